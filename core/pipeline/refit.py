"""Fit one unit of a finished result again, from the points around a place the user showed; index those points first."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..adjustment.adjustment_records import Adjustment, AdjustmentOptions
from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..common.feedback import Feedback
from ..common.registration_records import common_variance
from ..data.las_files import checksum
from ..data.survey import Survey
from ..data.tiles import read_points
from ..data.trajectory import noise_of, surface_covariances
from ..deformation.congruence import PoseCalibration
from ..model.mould import Mould, onto_cones
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..registration.frame_correction import FrameCorrection
from ..registration.transformation import Transformation, transformation_of
from ..results.field_checks import foreign_contents
from ..results.geopackage_reader import read_layer_rows
from ..results.run_record import epochs_of
from ..results.unit_rows import EpochInfo, read_epochs, unit_sizes
from ..results.unit_sizes import unit_of
from ..review.corrections import set_pose
from ..review.point_index import frames_state, index_folder, index_of, write_index
from ..review.pose_consequences import NewPose
from ..segmentation.segment import DetectedUnit, segment
from .block_jobs import ROUGHNESS_RATIO, adjusted_nearby
from .epoch_plans import plan_survey
from .placed_points import placing

REACH_HEIGHTS = 1.6
"""Points are kept this far from a unit's centre, in heights: the unit, its neighbours' near sides, and room for a motion of half H."""
CLICK_HEIGHTS = 0.6
"""A click on a unit lies at most this far from its centre, in heights (legs reach 0.644 H)."""


def index_unit_points(survey: Survey, result: Path, feedback: Feedback) -> dict[str, Any]:
    """Write the index of points around the units of a result, in the control frame, beside it; with the sensor's positions where the
    survey gives them.

    Points lie where the run saw them: less the offset of their strip or station, as poses and displacements are.

    Raises
    ------
    InputError
        Survey and result do not belong together, there are no units, a tile is damaged, or the sensor's position is not known for a
        point.
    OutputError
        The index cannot be written.
    """
    infos, state = epochs_of(survey, result, feedback), frames_state(result)
    centres = [row["geom"] for row in read_layer_rows(result, "units") if row["geom"] is not None]
    height = max(unit.type.height for unit in survey.units)
    plans = plan_survey(survey, feedback.part(0.0, 0.05))
    count = sum(len(plan.tiles) for plan in plans)
    bends = read_layer_rows(result, "frame_errors")

    def tiles() -> Iterator[tuple[str, str, FloatArray]]:
        done = 0
        for plan in plans:
            info = infos[plan.epoch.label]
            placed, transformation = placing(info, bends), transformation_of(info.transformation)
            beams = noise_of(plan.epoch, checksum)
            for tile in plan.tiles:
                feedback.check()
                feedback.progress(0.05 + 0.95 * done / count, f"reading {tile.path.name}")
                cloud = read_points([tile], survey.crs, is_cancelled=feedback.is_cancelled)
                places = [placed(cloud.xyz + cloud.origin, cloud.source_id)]
                if beams is not None:
                    sensors = beams.sensors(cloud.source_id, cloud.gps_time)
                    places.append(sensors if transformation is None else transformation.apply(sensors))
                yield plan.epoch.label, tile.path.name, np.hstack(places)
                done += 1

    folder = index_folder(result)
    noise = {e.label: (e.range_sd, math.radians(e.angle_sd)) for e in survey.epochs if e.range_sd is not None and e.angle_sd is not None}
    kept = write_index(folder, tiles(), np.array(centres).reshape(-1, 3), REACH_HEIGHTS * height, noise=noise, state=state)
    feedback.info(f"{kept} points around {len(centres)} positions of units")
    return {"index": str(folder), "points": kept}


def refit_unit(result: Path, unit_id: str, epoch: str, near: ArrayLike, *, editor: str, seed: int = 0) -> dict[str, Any]:
    """Find the unit at a place shown by the user, adjust it and put the new pose into the result.

    The shape (radius, gradient) stays that of the unit's rows, and points are weighted by beam where the index knows the sensor's
    positions, as in the run. Standard deviations are calibrated and hold the registration, as those of the run.

    Parameters
    ----------
    result
        Result of a run, with its point index beside it (:func:`index_unit_points`).
    unit_id
        The unit, which may have been missed in that epoch but has a pose in some epoch.
    epoch
        Label of the epoch to fit it in.
    near
        (3,) place on or in the unit, control frame, metres.
    editor
        Who asks for it; stands beside the correction.
    seed
        Of the random draws of the search.

    Returns
    -------
    summary
        ``unit_id``, ``epoch``, ``n_points`` that carry weight, ``score`` of the detection and ``sigma0`` of the fit.

    Raises
    ------
    InputError
        There is no point index or one of another version; the unit or the epoch is not in the result, or the unit has no pose in any
        epoch or another opening than the tetrahedral one; no tetrapod is found at that place; or the editor has no name.
    OutputError
        The result cannot be written.
    """
    # what follows works on points: its errors are the program's own
    with foreign_contents(result):
        unit, info = _unit_and_epoch(result, unit_id, epoch)
        mould = _mould_of(info, unit)
        frame = _EpochFrame.read(result, info)
    place = np.asarray(near, dtype=np.float64)
    index = index_of(result)
    noise, reach = index.noise(epoch), REACH_HEIGHTS * unit.height
    points, sensors = index.read_with_sensors(epoch, place, reach) if noise is not None else (index.read(epoch, place, reach), None)
    points = points - place
    found = segment(points, unit, seed=seed, workers=1)
    distance = [float(np.linalg.norm(detected.pose.centre)) for detected in found.units]
    if not distance or min(distance) > CLICK_HEIGHTS * unit.height:
        raise InputError(
            f"no tetrapod is found at that place among {len(points)} points",
            where=f"unit {unit_id}, epoch {epoch}",
            remedy="Click nearer to the unit's middle, or pin it by three joints.",
        )
    chosen = int(np.argmin(distance))
    detected = found.units[chosen]
    own = found.labels == chosen
    covariances = None
    if noise is not None and sensors is not None:
        covariances = surface_covariances(points[own], sensors[own] - place, *noise, ROUGHNESS_RATIO * unit.height)
    options = AdjustmentOptions(radius_sd=0.0, gradient_sd=0.0)
    cloud = points[own]
    on_cones = cloud if mould is None else onto_cones(cloud, detected.pose.rotation, detected.pose.centre, unit, mould)
    fitted = adjusted_nearby(on_cones, unit, detected.pose, options, covariances)
    new = _new_pose(fitted, fitted.pose.shifted(place), detected, unit, frame)
    with foreign_contents(result):
        set_pose(result, unit_id, epoch, new, editor=editor, comment="fitted again at a place shown by the user")
    return {"unit_id": unit_id, "epoch": epoch, "n_points": new.n_points, "score": detected.score, "sigma0": fitted.sigma0}


def _new_pose(fitted: Adjustment, pose: Pose, detected: DetectedUnit, unit: UnitType, frame: _EpochFrame) -> NewPose:
    """What the result is to hold of a unit; ``pose`` is that of the adjustment in the control frame."""
    sd = np.sqrt(np.diag(frame.covariance_in_control(fitted.covariance[:6, :6], pose)))
    return NewPose(
        centre=pose.centre,
        rotation=pose.rotation,
        radius=fitted.radius,
        gradient=fitted.gradient,
        height=unit.height,
        sd=sd[:3],
        sd_rotation_deg=math.degrees(float(np.linalg.norm(sd[3:]))),
        sigma0=fitted.sigma0,
        n_points=int(np.sum(fitted.weights > 0)),
        legs_visible=fitted.legs_visible,
        coverage=detected.coverage,
        score=detected.score,
    )


def _unit_and_epoch(result: Path, unit_id: str, epoch: str) -> tuple[UnitType, EpochInfo]:
    """Shape of the unit as its rows state it, and the epoch it is to be fitted in."""
    rows = [row for row in read_layer_rows(result, "units") if row["unit_id"] == unit_id]
    if not rows:
        raise InputError("there is no such unit", source=result, where=f"unit {unit_id}", remedy="Choose a unit of the result.")
    epochs = read_epochs(result)
    info = next((info for info in epochs if info.label == epoch), None)
    if info is None:
        raise InputError(f"has no epoch {epoch}", source=result, remedy=f"It has {', '.join(e.label for e in epochs)}.")
    shape = next((row for row in rows if row["r0"] is not None and row["qw"] is not None), None)
    if shape is None:
        raise InputError(
            "has no pose in any epoch to take its size from", source=result, where=f"unit {unit_id}", remedy="Choose another unit."
        )
    unit = unit_of(shape, unit_sizes(epochs))
    if unit.opening != "tetrahedral":
        # corrections number legs and place joints as of a regular tetrahedron
        raise InputError(
            f"has the opening {unit.opening!r}, of which corrections know nothing",
            source=result,
            where=f"unit {unit_id}",
            remedy="Run the survey again instead.",
        )
    return unit, info


def _mould_of(info: EpochInfo, unit: UnitType) -> Mould | None:
    """The mould that the run learned of a type of unit, or held; None where an earlier version has written the result."""
    castings = info.settings.get("castings", {})
    record = castings.get(unit.name) or (next(iter(castings.values())) if len(castings) == 1 else None)
    try:
        return None if record is None else Mould.from_record(record, unit.name)
    except (ValueError, AttributeError, TypeError):
        return None


@dataclass(frozen=True, eq=False)
class _EpochFrame:
    """What a result says of the uncertainty of an epoch's poses besides that of their adjustment.

    Attributes
    ----------
    calibration
        By the epoch pairs.
    correction
        Error of the registered cloud where its frame bends.
    transformation
        Registration with the mean offset and drift of the epoch's strips or stations in its covariance; None without one.
    """

    calibration: PoseCalibration
    correction: FrameCorrection
    transformation: Transformation | None

    @classmethod
    def read(cls, result: Path, info: EpochInfo) -> _EpochFrame:
        """Of one epoch of a result."""
        known = transformation_of(info.transformation)
        return cls(
            _calibration(result, info.label),
            FrameCorrection.from_rows(read_layer_rows(result, "frame_errors"), info.label),
            None if known is None else known.with_offset(common_variance(info.settings)),
        )

    def covariance_in_control(self, own: FloatArray, pose: Pose) -> FloatArray:
        """(6, 6) covariance of a pose in the control frame from that of its adjustment, as the run states those of its units."""
        covariance = self.calibration.covariance(own)
        if self.transformation is None:
            return covariance
        if len(self.correction.chainage):
            # the bent frame's own uncertainty takes the place of the rigid registration's
            covariance[:3, :3] += np.diag(self.correction.variances_at(pose.centre[None])[0])
            return covariance
        return covariance + self.transformation.pose_covariance(pose)


def _calibration(result: Path, epoch: str) -> PoseCalibration:
    """Calibration of the poses of an epoch as the rows of its pairs state it."""
    pairs = []
    for row in read_layer_rows(result, "epoch_pairs"):
        factor, floor = row.get("covariance_factor"), row.get("covariance_floor")
        if epoch not in (row["epoch_from"], row["epoch_to"]) or factor is None or floor is None:
            continue
        # earlier versions do not record rotations, whose standard deviations are too small for the same reasons
        pairs.append((factor, floor, row.get("rotation_factor") or factor, math.radians(row.get("rotation_floor_deg") or 0.0)))
    return PoseCalibration.of_pairs(pairs)
