"""The units of every epoch, found and adjusted block by block in the frame of its cloud, with calibrated shapes where those are wanted."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..adjustment.shape_calibration import CALIBRATION_UNITS, calibrate
from ..common.arrays import FloatArray, IntArray
from ..common.feedback import Feedback
from ..data.survey import Survey, SurveyUnit
from ..data.tiles import Window
from ..data.trajectory import BeamNoise, noise_of
from ..model.mould import Mould
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..results.run_record import RunRecord
from ..segmentation.segment import MOST_INTERPENETRATION
from .array_files import loaded_arrays
from .block_jobs import (
    BLOCK_ARRAYS,
    GRADIENT_TOLERANCE,
    POINT_ARRAYS,
    RADIUS_TOLERANCE,
    SAME_UNIT_HEIGHTS,
    FitJob,
    SegmentJob,
    covariances_of,
)
from .epoch_plans import EpochPlan
from .epoch_quality import entering, reduced
from .given_units import GivenUnit
from .job_runner import JobRunner
from .tracking_jobs import LastFile


@dataclass(frozen=True, eq=False)
class EpochUnits:
    """Units of one epoch, in the frame of its cloud.

    Attributes
    ----------
    plan
        The epoch.
    table
        Arrays by column, one row per unit in order of easting; ``poses`` (k, 12) are absolute. See :mod:`block_jobs`.
    places
        (k, 2) number of the file in ``files`` and row in it that hold each unit's points.
    files
        Results of the blocks' jobs.
    units
        Geometry by type of unit, calibrated where that was asked for.
    """

    plan: EpochPlan
    table: Mapping[str, NDArray[Any]]
    places: IntArray
    files: tuple[Path, ...]
    units: tuple[UnitType, ...]

    def __len__(self) -> int:
        return len(self.places)

    def pose(self, row: int) -> Pose:
        """Absolute pose of a unit."""
        return Pose.of_row(self.table["poses"][row])

    def points(self) -> Iterator[tuple[int, FloatArray]]:
        """Row and (n, 3) absolute points of every unit, file by file."""
        arrays_of = self._arrays()
        for row in np.argsort(self.places[:, 0], kind="stable"):
            arrays, own = arrays_of(int(row))
            yield int(row), arrays["points"][own] + arrays["origin"]

    def source_ids(self) -> Iterator[tuple[int, NDArray[np.uint16]]]:
        """Row, and ids of the strips or stations that see it, of every unit once it is adjusted, file by file; no points are read."""
        for number, path in enumerate(self.files):
            arrays = loaded_arrays(path, without=POINT_ARRAYS)
            starts = arrays["source_offsets"]
            for row in np.flatnonzero(self.places[:, 0] == number):
                place = self.places[row, 1]
                yield int(row), arrays["source_ids"][starts[place] : starts[place + 1]]

    def covariances(self, beams: BeamNoise) -> Callable[[int], FloatArray]:
        """Reads (n, 3, 3) covariances of a unit's points by its row, in the order of :meth:`points`; square metres.

        It holds one file at a time: units of one file are to be asked for one after the other.

        Raises
        ------
        InputError
            When reading, if a file is gone or the sensor's position is not known for a point.
        """
        arrays_of = self._arrays()

        def read(row: int) -> FloatArray:
            arrays, own = arrays_of(row)
            return covariances_of(arrays, own, beams, self.units[int(self.table["type"][row])])

        return read

    def _arrays(self) -> Callable[[int], tuple[Mapping[str, NDArray[Any]], slice]]:
        """Reads the arrays of the block that holds a unit, and which of their points are the unit's, by its row; holds one file."""
        last = LastFile()

        def read(row: int) -> tuple[Mapping[str, NDArray[Any]], slice]:
            number, place = self.places[row]
            arrays = last.arrays(self.files[number])
            return arrays, slice(arrays["offsets"][place], arrays["offsets"][place + 1])

        return read


def find_and_fit(
    survey: Survey,
    plans: Sequence[EpochPlan],
    record: RunRecord,
    runner: JobRunner,
    feedback: Feedback,
    given: Mapping[str, Sequence[GivenUnit]] | None = None,
    beside: Callable[[], None] = lambda: None,
) -> tuple[tuple[EpochUnits, ...], dict[str, Any]]:
    """Find units and adjust each to its points; with ``calibrate`` the shape is first estimated from the best-seen units of all epochs,
    then the units are found and adjusted anew with it.

    Returns the adjusted units by epoch, and what calibration found, for the record. ``beside`` is the caller's own work while units are
    found.
    """
    calibrates = any(unit.calibrate for unit in survey.units)
    share = 0.4 if calibrates else 0.75
    found = segment_epochs(survey, plans, record, runner, feedback.part(0, share), given, beside)
    shape_sds = tuple(_shape_sds(unit) for unit in survey.units)
    notes: dict[str, Any] = {}
    if calibrates:
        feedback.progress(share, "calibrating radius and gradient")
        survey, shape_sds, notes = calibrate_shapes(survey, found, shape_sds, record, feedback)
        found = segment_epochs(survey, plans, record, runner, feedback.part(share, 0.8), given)
        share = 0.8
    moulds = tuple(unit.mould for unit in survey.units)
    return fit_epochs(found, shape_sds, moulds, record, runner, feedback.part(share, 1)), notes


def _shape_sds(unit: SurveyUnit) -> tuple[float, float]:
    """Standard deviation of single units' radius (metres) and gradient about those of their type."""
    if unit.mould is None:
        return RADIUS_TOLERANCE * unit.type.radius, GRADIENT_TOLERANCE
    return unit.mould.size_sd * unit.type.radius, min(unit.mould.gradient_sd, GRADIENT_TOLERANCE)


def segment_epochs(
    survey: Survey,
    plans: Sequence[EpochPlan],
    record: RunRecord,
    runner: JobRunner,
    feedback: Feedback,
    given: Mapping[str, Sequence[GivenUnit]] | None = None,
    beside: Callable[[], None] = lambda: None,
) -> tuple[EpochUnits, ...]:
    """Find the units of every epoch (or take ``given`` ones by epoch label), each once; ``beside`` is the caller's own work meanwhile.

    Raises
    ------
    InputError
        A tile is damaged.
    """
    blocks = [(plan, block) for plan in plans for block in plan.blocks]
    clouds = runner.clouds.of_so_many(sum(plan.points for plan in plans))
    jobs = [
        SegmentJob(
            block=block,
            survey_crs=survey.crs,
            tiles_crs=plan.epoch.tiles_crs,
            units=survey.units,
            seed=record.seed,
            checksums=tuple(record.checksums[tile.path] for tile in block.tiles),
            given=None if given is None else tuple(given.get(plan.epoch.label, ())),
            timed=plan.epoch.trajectory is not None,
            clouds=clouds,
        )
        for plan, block in blocks
    ]
    what = "finding units" if given is None else "collecting points"
    files = runner.run(jobs, lambda done, total: feedback.progress(done / total, f"{what}, block {done} of {total}"), beside)
    heights = [unit.type.height for unit in survey.units]
    result = []
    for plan in plans:
        mine = [k for k, (other, _) in enumerate(blocks) if other is plan]
        arrays = [loaded_arrays(files[k], without=POINT_ARRAYS) for k in mine]
        rows = owners([(blocks[k][1].core, a) for k, a in zip(mine, arrays, strict=True)], heights)
        result.append(_collected(plan, arrays, rows, tuple(files[k] for k in mine), tuple(unit.type for unit in survey.units)))
    return tuple(result)


def owners(blocks: Sequence[tuple[Window, Mapping[str, NDArray[Any]]]], heights: Sequence[float]) -> list[IntArray]:
    """Rows of every block's units that are that block's own, so that a unit found by two blocks is kept once.

    A unit belongs to the block whose core its centre lies in. One that its neighbour alone has found is kept too.

    Parameters
    ----------
    blocks
        Core and arrays of each block, in a fixed order.
    heights
        Nominal height of each type of unit, metres.
    """
    centres = [arrays["poses"][:, :3] + arrays["origin"] for _, arrays in blocks]
    count = [len(c) for c in centres]
    if not sum(count):
        return [np.empty(0, dtype=np.int64) for _ in blocks]
    place = np.concatenate(centres)
    block = np.repeat(np.arange(len(blocks)), count)
    own = np.concatenate([core.contains(c) for (core, _), c in zip(blocks, centres, strict=True)])
    height = np.array(heights)[np.concatenate([arrays["type"] for _, arrays in blocks])]
    score = np.concatenate([arrays["score"] for _, arrays in blocks])
    keep = np.ones(len(place), dtype=np.bool_)
    pairs = cKDTree(place - place.mean(axis=0)).query_pairs(SAME_UNIT_HEIGHTS * float(height.max()), output_type="ndarray")
    for i, j in pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]:
        near = np.linalg.norm(place[i] - place[j]) < SAME_UNIT_HEIGHTS * max(height[i], height[j])
        if not near or block[i] == block[j] or not (keep[i] and keep[j]):
            continue
        better = (bool(own[i]), float(score[i]), -int(block[i])) > (bool(own[j]), float(score[j]), -int(block[j]))
        keep[j if better else i] = False
    starts = np.concatenate([[0], np.cumsum(count)])
    return [np.flatnonzero(keep[starts[k] : starts[k + 1]]) for k in range(len(blocks))]


def calibrate_shapes(
    survey: Survey, epochs: Sequence[EpochUnits], shape_sds: tuple[tuple[float, float], ...], record: RunRecord, feedback: Feedback
) -> tuple[Survey, tuple[tuple[float, float], ...], dict[str, Any]]:
    """Estimate radius and gradient of the types that ask for it.

    Returns the survey with the estimated shapes, the standard deviation of single units' radius and gradient by type, and the numbers
    for the record.

    Raises
    ------
    InputError
        No unit shows enough of itself, or the sensor's position is not known for a point, where positions are given.
    """
    units, sds, notes = list(survey.units), list(shape_sds), {}
    for kind, unit in enumerate(survey.units):
        if not unit.calibrate:
            continue
        best: list[tuple[int, FloatArray, Pose, FloatArray | None]] = []
        for epoch in epochs:
            beams = noise_of(epoch.plan.epoch, record.checksums.__getitem__)
            covariances = epoch.covariances(beams) if beams is not None else None
            for row, points in epoch.points():
                feedback.check()
                # a shape that is wrong yet weakens the evidence of good units: what is no unit shows as an outlier instead
                if int(epoch.table["type"][row]) != kind:
                    continue
                pose = epoch.pose(row)
                origin = np.round(pose.centre)
                noise = covariances(row) if covariances is not None else None
                best.append((len(points), points - origin, pose.shifted(-origin), noise))
                best = sorted(best, key=lambda item: -item[0])[:CALIBRATION_UNITS]
        _, clouds, poses, noises = zip(*best, strict=True) if best else ((), (), (), ())
        result = calibrate(clouds, unit.type, poses, covariances=noises)
        units[kind] = replace(unit, type=result.unit)
        sds[kind] = (float(result.unit_sds[0]), float(result.unit_sds[1]))
        used = int(result.used.sum())
        feedback.info(
            f"calibrated on {used} units: radius {result.unit.radius:.4f} m (sd {result.sd[0]:.4f}), "
            f"gradient {result.unit.gradient:.4f} (sd {result.sd[1]:.4f})"
        )
        notes[unit.type.name] = {
            "radius": result.unit.radius,
            "gradient": result.unit.gradient,
            "sd": result.sd.tolist(),
            "between_units": result.between.tolist(),
            "units": used,
        }
    return replace(survey, units=tuple(units)), tuple(sds), notes


def fit_epochs(
    epochs: Sequence[EpochUnits],
    shape_sds: tuple[tuple[float, float], ...],
    moulds: tuple[Mould | None, ...],
    record: RunRecord,
    runner: JobRunner,
    feedback: Feedback,
) -> tuple[EpochUnits, ...]:
    """Adjust every unit to its points.

    Parameters
    ----------
    epochs
        Units with approximate poses.
    shape_sds
        By type of unit, standard deviations of radius (metres) and gradient about the type's shape; 0 holds it.
    moulds
        By type of unit, the mould that is held, or None.
    record
        Checksums of the inputs.

    Raises
    ------
    InputError
        The sensor's position is not known for a point, where positions are given.
    """
    jobs = []
    for epoch in epochs:
        beams = noise_of(epoch.plan.epoch, record.checksums.__getitem__)
        for number, path in enumerate(epoch.files):
            rows = tuple(int(row) for row in np.sort(epoch.places[epoch.places[:, 0] == number, 1]))
            jobs.append(FitJob(path, rows, epoch.units, shape_sds, beams, moulds))
    files = iter(runner.run(jobs, lambda done, total: feedback.progress(done / total, f"adjusting units, block {done} of {total}")))
    result = []
    for epoch in epochs:
        own = tuple(next(files) for _ in epoch.files)
        arrays = [loaded_arrays(path, without=POINT_ARRAYS) for path in own]
        result.append(_solid(_collected(epoch.plan, arrays, [np.arange(len(a["poses"])) for a in arrays], own, epoch.units)))
    return tuple(result)


def _solid(epoch: EpochUnits) -> EpochUnits:
    """The epoch with units uncertain that their adjustment moved into a stronger one, in noise no farther than elsewhere.

    Segmentation, which judges poses by smoothed elements there, allows twice as much. Of 236 units adjusted to their points at 3.3 % of H
    (two unseen piles) two enter a stronger one by more than 1 % of its volume: one by more than 3 %, and one 0.43 m off by 1.5 %.
    """
    status = np.array(epoch.table["status"])
    found = np.flatnonzero(status == "found")
    poses = reduced(epoch.table["poses"][found])
    inside = entering(poses, epoch.table["type"][found], epoch.units, epoch.table["score"][found], MOST_INTERPENETRATION)
    status[found[inside]] = "uncertain"
    return replace(epoch, table={**epoch.table, "status": status})


def _collected(
    plan: EpochPlan,
    arrays: Sequence[Mapping[str, NDArray[Any]]],
    rows: Sequence[IntArray],
    files: tuple[Path, ...],
    units: tuple[UnitType, ...],
) -> EpochUnits:
    """Units of all blocks in one table, poses absolute, ordered by easting and northing."""
    columns = [name for name in arrays[0] if name not in BLOCK_ARRAYS]
    table = {name: np.concatenate([a[name][r] for a, r in zip(arrays, rows, strict=True)]) for name in columns}
    table["poses"] = table["poses"].copy()
    table["poses"][:, :3] += np.concatenate([np.tile(a["origin"], (len(r), 1)) for a, r in zip(arrays, rows, strict=True)])
    places = np.concatenate([np.column_stack([np.full(len(r), k), r]) for k, r in enumerate(rows)]).astype(np.int64)
    order = np.lexsort((table["poses"][:, 1], table["poses"][:, 0]))
    return EpochUnits(plan, {name: values[order] for name, values in table.items()}, places[order], files, units)
