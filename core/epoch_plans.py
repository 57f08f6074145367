"""The epochs of a survey with their checked tiles, cut into blocks: what is wrong with the input is said before hours of work."""

from __future__ import annotations

from dataclasses import dataclass

from .errors import InputError
from .feedback import Feedback
from .survey import Epoch, Survey
from .tile_jobs import Block, plan_blocks
from .tiles import TileInfo, inspect_tile
from .trajectory import read_stations, read_trajectory
from .validation import read_check


@dataclass(frozen=True, eq=False)
class EpochPlan:
    """An epoch with its checked tiles and the blocks it is cut into."""

    epoch: Epoch
    tiles: tuple[TileInfo, ...]
    blocks: tuple[Block, ...]

    @property
    def points(self) -> int:
        """Points of all tiles."""
        return sum(tile.points for tile in self.tiles)


def plan_survey(survey: Survey, feedback: Feedback | None = None) -> tuple[EpochPlan, ...]:
    """Check the headers of all tiles and the tables of points, so that what is wrong is said before hours of work; cut epochs into blocks.

    Raises
    ------
    InputError
        The first tile or table that cannot be used.
    """
    feedback = feedback or Feedback()
    height = max(unit.type.height for unit in survey.units)
    plans = []
    total = sum(len(epoch.tiles) for epoch in survey.epochs)
    done = 0
    for epoch in survey.epochs:
        if epoch.trajectory is not None:
            read_trajectory(epoch.trajectory)
        if epoch.stations is not None:
            read_stations(epoch.stations)
        if epoch.check is not None:
            read_check(epoch.check)
        tiles = []
        for path in epoch.tiles:
            feedback.check()
            feedback.progress(done / total, f"checking {path.name}")
            tile = inspect_tile(path, survey.crs, tiles_crs=epoch.tiles_crs)
            if tile.note:
                feedback.info(tile.note)
            if epoch.trajectory is not None and not tile.has_time:
                raise InputError(
                    f"has no GPS time by which trajectory {epoch.trajectory.name} could be read",
                    source=path,
                    remedy="Export the tiles with GPS time, or take trajectory, range_sd and angle_sd out of survey.toml.",
                )
            tiles.append(tile)
            done += 1
        plans.append(EpochPlan(epoch, tuple(tiles), plan_blocks(epoch.label, tiles, height)))
    return tuple(plans)
