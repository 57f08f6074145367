"""The epochs of a survey with their checked tiles, cut into blocks: what is wrong with the input is said before hours of work."""

from __future__ import annotations

from dataclasses import dataclass

from ..common.feedback import Feedback
from ..data.survey import Epoch, Survey
from ..data.tiles import TileInfo
from .blocks import Block, plan_blocks
from .input_findings import report
from .survey_check import check_survey


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
    """Check every input, so that what is wrong is said before hours of work, and cut epochs into blocks.

    Raises
    ------
    InputError
        The first input that cannot be used.
    """
    feedback = feedback or Feedback()
    check = check_survey(survey, feedback)
    report(check.findings, feedback)
    height = max(unit.type.height for unit in survey.units)
    return tuple(
        EpochPlan(epoch, check.tiles[epoch.label], plan_blocks(epoch.label, check.tiles[epoch.label], height)) for epoch in survey.epochs
    )
