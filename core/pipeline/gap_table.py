"""Rows of the layer ``gaps``: what other epochs know of an epoch's missing units, and what its own cloud and packing say."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray
from ..data.occupancy import merged
from ..model.unit_types import UnitType
from ..registration.frame_correction import FrameCorrection
from ..registration.transformation import Transformation
from ..results.schema import PLACEHOLDER
from ..segmentation.gaps import Armour, Gap, armour_of, clearest, find_gaps
from ..segmentation.overlaps import CLOSEST_HEIGHTS, REACH_HEIGHTS
from .array_files import Arrays, loaded_arrays
from .block_clouds import NOT_KEPT, BlockClouds
from .blocks import Block
from .epoch_quality import ACCEPTED, kinds_of, placed_rows, pose_table
from .job_runner import JobRunner, job_key

if TYPE_CHECKING:
    from ..data.survey import Survey
    from ..registration.control import Registration
    from .epoch_plans import EpochPlan

Row = dict[str, Any]
NEAREST = 3
KNOWN_HEIGHTS = 6.0
"""A job knows the units this far around its block, in heights: more than the run of the armour's surface is told from."""


@dataclass(frozen=True, eq=False, kw_only=True)
class GapJob:
    """Look for gaps in one block.

    Attributes
    ----------
    block
        Where; gaps in its core are reported.
    survey_crs, tiles_crs
        As in survey.toml.
    armour
        Units around the block, control frame less ``origin``.
    origin
        (3,) reduction point.
    transformation
        From the epoch's cloud to the control frame.
    correction
        What is left of the epoch's bent frame.
    checksums
        Of the block's tiles.
    clouds
        Where points of blocks are kept.
    """

    block: Block
    survey_crs: str
    tiles_crs: str | None
    armour: Armour
    origin: FloatArray
    transformation: Transformation
    correction: FrameCorrection
    checksums: tuple[str, ...]
    clouds: BlockClouds = NOT_KEPT

    @property
    def name(self) -> str:
        """File name of the result."""
        core = self.block.core
        settings = {
            "crs": self.survey_crs,
            "tiles_crs": self.tiles_crs,
            "core": [repr(v) for v in (core.west, core.south, core.east, core.north)],
            "units": repr(self.armour.units),
            "armour": [self.armour.poses.tolist(), self.armour.kinds.tolist(), self.armour.closest],
            "origin": self.origin.tolist(),
            "transformation": self.transformation.as_record(),
            "correction": self.correction.as_settings(),
        }
        return f"gaps-{job_key('gaps', settings, self.checksums)}.npz"

    def run(self) -> Arrays:
        """Arrays by gap: place (absolute, control frame), kind, score, area and index of the type of unit."""
        window = self.block.core.grown(2 * REACH_HEIGHTS * self.armour.height)
        points = self.transformation.apply(self.clouds.points(self.block, self.survey_crs, window, self.origin)[0] + self.origin)
        gaps = find_gaps(points - self.correction.at(points) - self.origin, self.armour)
        places = np.array([gap.place for gap in gaps]).reshape(-1, 3) + self.origin
        mine = self.block.core.contains(self.transformation.invert(places + self.correction.at(places)))
        return {
            "place": places[mine],
            "kind": np.array([gap.kind for gap in gaps], dtype="U12")[mine],
            "score": np.array([gap.score for gap in gaps])[mine],
            "area": np.array([gap.area for gap in gaps])[mine],
            "unit": np.array([gap.unit for gap in gaps], dtype=np.int64)[mine],
        }


def look_into_tiles(
    rows: Sequence[Mapping[str, Any]],
    survey: Survey,
    plans: Sequence[EpochPlan],
    units: tuple[UnitType, ...],
    registrations: Mapping[str, Registration],
    frame_errors: Sequence[Mapping[str, Any]],
    checksums: Mapping[Path, str],
    runner: JobRunner,
    *,
    beside: Callable[[], None] = lambda: None,
) -> dict[str, list[Gap]]:
    """Gaps by epoch that its cloud and packing show, in the control frame, looked for block by block.

    Parameters
    ----------
    rows
        Of the layer ``units``, final poses.
    survey, plans
        The survey and its epochs cut into blocks.
    units
        Types of unit.
    registrations
        By label of the epoch.
    frame_errors
        Rows of the layer: where frames bend.
    checksums
        Of the tiles.
    runner
        Runs the jobs.
    beside
        The caller's own work meanwhile.
    """
    jobs: list[tuple[str, GapJob]] = []
    for plan in plans:
        label = plan.epoch.label
        placed = placed_rows(rows, label)
        poses = pose_table(placed)
        origin: FloatArray = np.round(poses[:, :3].mean(axis=0)) if len(poses) else np.zeros(3)
        poses[:, :3] -= origin
        whole = armour_of(poses, kinds_of(placed, units), units)
        if whole is None:
            continue
        registration = registrations.get(label)
        transformation = Transformation.identity(origin) if registration is None else registration.transformation
        correction = FrameCorrection.from_rows(frame_errors, label)
        centres = poses[:, :3] + origin
        where = transformation.invert(centres + correction.at(centres))
        for block in plan.blocks:
            near = block.core.grown(KNOWN_HEIGHTS * whole.height).contains(where)
            if not block.core.grown(2 * REACH_HEIGHTS * whole.height).contains(where).any():
                continue
            armour = replace(whole, poses=poses[near], kinds=whole.kinds[near], tree=cKDTree(poses[near, :3]))
            own = tuple(checksums[tile.path] for tile in block.tiles)
            jobs.append(
                (
                    label,
                    GapJob(
                        block=block,
                        survey_crs=survey.crs,
                        tiles_crs=plan.epoch.tiles_crs,
                        armour=armour,
                        origin=origin,
                        transformation=transformation,
                        correction=correction,
                        checksums=own,
                        clouds=runner.clouds,
                    ),
                )
            )
    height = max(unit.height for unit in units)
    found: dict[str, list[Gap]] = {plan.epoch.label: [] for plan in plans}
    for (label, _), path in zip(jobs, runner.run([job for _, job in jobs], beside=beside), strict=True):
        result = loaded_arrays(path)
        columns = (result[name] for name in ("place", "kind", "score", "area", "unit"))
        found[label] += [Gap(place, str(kind), float(score), float(area), int(unit)) for place, kind, score, area, unit in zip(*columns)]  # type: ignore[arg-type]
    return {label: clearest(gaps, height) for label, gaps in found.items()}


@dataclass(frozen=True, eq=False, kw_only=True)
class CoveredGround:
    """Where an epoch has points at all, by their extent and the cells that they were counted in when its tiles were checked; neither
    depends on the tiling.

    Attributes
    ----------
    low, high
        (2,) south-western and north-eastern corner of the extent, metres.
    columns
        Easting and northing of the occupied cells, in whole cells.
    size
        Edge of a cell, metres.
    transformation
        From the epoch's cloud to the control frame.
    correction
        What is left of the epoch's bent frame.
    """

    low: FloatArray
    high: FloatArray
    columns: frozenset[tuple[int, int]]
    size: float
    transformation: Transformation
    correction: FrameCorrection

    def around(self, place: FloatArray, reach: float) -> bool:
        """Whether the extent and a cell with points lie within ``reach`` metres, on either axis, of a (3,) place of the control frame."""
        where = self.transformation.invert(place[None] + self.correction.at(place[None]))[0, :2]
        if (where < self.low - reach).any() or (where > self.high + reach).any():
            return False
        low, high = (np.floor((where + side) / self.size).astype(np.int64) for side in (-reach, reach))
        return any((e, n) in self.columns for e in range(low[0], high[0] + 1) for n in range(low[1], high[1] + 1))


def covered_ground(
    plans: Sequence[EpochPlan], registrations: Mapping[str, Registration], frame_errors: Sequence[Mapping[str, Any]]
) -> dict[str, CoveredGround]:
    """Where each epoch has points, by its label; arguments as of :func:`look_into_tiles`. Epochs with tiles that nobody looked through,
    and so without cells, are left out."""
    found = {}
    for plan in plans:
        label, parts = plan.epoch.label, [tile.cells for tile in plan.tiles if tile.cells is not None]
        if not parts or len(parts) < len(plan.tiles):
            continue
        cells = merged(parts)
        registration = registrations.get(label)
        found[label] = CoveredGround(
            low=np.min([tile.low[:2] for tile in plan.tiles], axis=0),
            high=np.max([tile.high[:2] for tile in plan.tiles], axis=0),
            columns=frozenset((int(e), int(n)) for e, n in np.unique(cells.cells[:, :2], axis=0)),
            size=cells.size,
            transformation=Transformation.identity(np.zeros(3)) if registration is None else registration.transformation,
            correction=FrameCorrection.from_rows(frame_errors, label),
        )
    return found


def gap_rows(
    rows: Sequence[Mapping[str, Any]],
    epochs: Sequence[tuple[str, datetime]],
    units: Sequence[UnitType],
    seen: Mapping[str, Sequence[Gap]] | None = None,
    covered: Mapping[str, CoveredGround] | None = None,
) -> list[Row]:
    """Rows of the layer ``gaps``.

    Parameters
    ----------
    rows
        Of the layer ``units``, final poses.
    epochs
        Label and time, in order of time.
    units
        Types of unit.
    seen
        Gaps by epoch that its own cloud shows (:func:`look_into_tiles`); without it only what other epochs know is stated.
    covered
        Where epochs have points (:func:`covered_ground`): units elsewhere are not missing, but out of an epoch's sight. Epochs that it
        does not name are taken to have them everywhere.
    """
    result: list[Row] = []
    labels = [label for label, _ in epochs]
    known = _known_from_other_epochs(rows, labels)
    for label, time in epochs:
        placed = placed_rows(rows, label)
        if not placed:
            continue
        centres = np.array([row["geometry"] for row in placed])
        origin: FloatArray = np.round(centres.mean(axis=0))
        tree = cKDTree(centres - origin)
        own: list[Row] = []
        ground = None if covered is None else covered.get(label)
        for kind, row in known[label]:
            if kind == "unseen" and ground is not None and not ground.around(row["geometry"], CLOSEST_HEIGHTS * row["height"]):
                continue
            # where another unit lies by now, nothing is missing
            if tree.query(row["geometry"] - origin)[0] >= CLOSEST_HEIGHTS * row["height"]:
                unit = units[int(kinds_of([row], units)[0])]
                own.append({"kind": kind, "unit_id": row["unit_id"], "score": 1.0, "geometry": np.asarray(row["geometry"])} | _size(unit))
        taken = [row["geometry"] for row in own]
        for gap in [] if seen is None else seen.get(label, ()):
            unit = units[gap.unit]
            if all(np.linalg.norm(gap.place - place) >= unit.height for place in taken):
                own.append({"kind": gap.kind, "score": gap.score, "area": gap.area, "geometry": gap.place} | _size(unit))
        for gap_row in own:
            distance, index = tree.query(gap_row["geometry"] - origin, k=min(NEAREST, len(placed)))
            gap_row |= {
                "epoch": label,
                "epoch_time": time,
                "status": PLACEHOLDER,
                "nearest_units": json.dumps([placed[k]["unit_id"] for k in np.atleast_1d(index)]),
                "nearest_centre": float(np.atleast_1d(distance)[0]),
            }
        result += own
    return result


def _size(unit: UnitType) -> Row:
    return {"unit_type": unit.name, "height": unit.height, "radius": unit.reach}


def _known_from_other_epochs(rows: Iterable[Mapping[str, Any]], labels: Sequence[str]) -> dict[str, list[tuple[str, Mapping[str, Any]]]]:
    """By epoch: ``lost`` or ``unseen``, and the row of the nearest epoch that shows the unit."""
    order = {label: k for k, label in enumerate(labels)}
    by_unit: dict[str, dict[int, Mapping[str, Any]]] = {}
    for row in rows:
        by_unit.setdefault(row["unit_id"], {})[order[row["epoch"]]] = row
    found: dict[str, list[tuple[str, Mapping[str, Any]]]] = {label: [] for label in labels}
    for states in by_unit.values():
        certain = sorted(e for e, row in states.items() if row["geometry"] is not None and row["status"] in ACCEPTED)
        # a new unit came later: the pile does not lack it before
        first = certain[0] if certain and states[certain[0]]["status"] == "new" else 0
        for epoch in range(first, len(labels) if certain else 0):
            state = states.get(epoch)
            if state is not None and state["geometry"] is not None:
                continue
            _, seen = min((abs(e - epoch), e) for e in certain)
            found[labels[epoch]].append(("unseen" if state is None else str(state["status"]), states[seen]))
    return found
