"""From the result of tracking to rows of the layers: units, feature points, displacements, epoch pairs and velocities."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from ..common.arrays import FloatArray
from ..deformation.displacement import Grade, UnitMotion, grade
from ..deformation.epoch_pairs import DATUMS, EpochPair, unit_shape
from ..deformation.tracked_epoch import TrackedEpoch, TrackedUnit
from ..deformation.tracking import Tracking
from ..model.feature_points import FEATURES
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..registration.transformation import rigid_jacobian
from .unit_table import covariance_fields, feature_rows

Row = dict[str, Any]


@dataclass(frozen=True)
class TableOptions:
    """What the rows are made with.

    Attributes
    ----------
    origin
        (3,) reduction point of the tracking.
    significance
        Level of ``significant``.
    grades
        Limits of displacement.
    """

    origin: tuple[float, float, float]
    significance: float
    grades: tuple[Grade, ...]


def unit_names(count: int) -> list[str]:
    """Names of physical units in the order of the tracking."""
    return [f"U{k + 1:04d}" for k in range(count)]


def pose_covariance(tracking: Tracking, epoch: int, state: TrackedUnit) -> FloatArray:
    """(8, 8) covariance of a pose in the control frame: calibrated joint adjustment and registration; shape held."""
    if state.covariance is None or state.pose is None:
        raise ValueError("a unit without pose has no covariance")
    covariance = np.zeros((8, 8))
    covariance[:6, :6] = tracking.calibrations[epoch].covariance(state.covariance)
    error = tracking.frame_error(epoch, state.pose.centre[None])
    registration = tracking.registrations[epoch]
    if error is not None:
        covariance[:6, :6] += error.covariances[0]
    elif registration is not None:
        covariance[:6, :6] += registration.pose_covariance(state.pose)
    return covariance


def pose_in_frame(tracking: Tracking, epoch: int, pose: Pose) -> Pose:
    """A pose less the error of its epoch's bent frame, as the targets see it."""
    error = tracking.frame_error(epoch, pose.centre[None])
    if error is None:
        return pose
    shift, turn = error.means[0, :3], error.means[0, 3:]
    return Pose(pose.centre - shift, Rotation.from_rotvec(-turn).as_matrix() @ pose.rotation)


def may_be(tracking: Tracking, unit: int, epoch: int) -> list[int]:
    """Units of the same type that a lost one may have become in an epoch, or that a new one may have been before."""
    opposite = {"lost": "new", "new": "lost"}.get(tracking.units[unit][epoch].status)
    if opposite is None:
        return []
    return [
        k
        for k, states in enumerate(tracking.units)
        if epoch in states and states[epoch].status == opposite and tracking.kinds[k] == tracking.kinds[unit]
    ]


def displacement_rows(
    tracking: Tracking, epochs: Sequence[TrackedEpoch], units: Sequence[UnitType], names: Sequence[str], options: TableOptions
) -> tuple[list[Row], list[Row]]:
    """Rows of ``displacements`` (consecutive epochs, datum ``stable``) and of ``displacements_other``."""
    main: list[Row] = []
    other: list[Row] = []
    for pair in tracking.pairs:
        for motion in pair.units:
            unit = units[tracking.kinds[motion.unit]]
            for datum in DATUMS:
                rows = _motion_rows(
                    name=names[motion.unit],
                    pair=pair,
                    epochs=epochs,
                    motion=motion.motions[datum],
                    kind=motion.classes[datum],
                    adjusted=motion.adjusted[datum],
                    datum=datum,
                    unit=unit,
                    options=options,
                    starts=_starts(tracking, pair.first, motion.motions[datum].starts),
                )
                (main if datum == "stable" and pair.second == pair.first + 1 else other).extend(rows)
    return main, other


def _starts(tracking: Tracking, epoch: int, points: FloatArray) -> FloatArray:
    """(5, 3) feature points of a unit less the error of their epoch's bent frame."""
    error = tracking.frame_error(epoch, points[:1])
    if error is None:
        return points
    return np.asarray(points - rigid_jacobian(points - points[0])[:, :, :6] @ error.means[0])


def _motion_rows(
    name: str,
    pair: EpochPair,
    epochs: Sequence[TrackedEpoch],
    motion: UnitMotion,
    kind: str,
    adjusted: float,
    datum: str,
    unit: UnitType,
    options: TableOptions,
    starts: FloatArray,
) -> list[Row]:
    rows = []
    for k, feature in enumerate(FEATURES):
        vector = motion.vectors[k]
        sds = np.sqrt(np.diag(motion.covariances[k]))
        length = float(np.linalg.norm(vector))
        start = starts[k] + options.origin
        significant = bool(motion.p_values[k] < options.significance)
        rows.append(
            {
                "unit_id": name,
                "feature": feature,
                "epoch_from": epochs[pair.first].label,
                "epoch_to": epochs[pair.second].label,
                "time_from": epochs[pair.first].time,
                "time_to": epochs[pair.second].time,
                "de": vector[0],
                "dn": vector[1],
                "dh": vector[2],
                "d_horizontal": math.hypot(vector[0], vector[1]),
                "d_3d": length,
                "azimuth_deg": math.degrees(math.atan2(vector[0], vector[1])) % 360,
                "sd_e": sds[0],
                "sd_n": sds[1],
                "sd_h": sds[2],
                "rotation_deg": math.degrees(motion.turn),
                "sd_rotation_deg": math.degrees(motion.turn_sd),
                "datum": datum,
                "statistic": motion.statistics[k],
                "p_value": motion.p_values[k],
                "significant": significant,
                "class": kind,
                "p_adjusted": adjusted,
                "detectable": motion.detectable[k],
                "d_over_h": length / unit.height,
                "d_over_dn": length / unit.nominal_diameter,
                "grade": grade(length, significant, unit, options.grades),
                "geometry": [start, start + vector],
            }
        )
    return rows


def pair_rows(tracking: Tracking, epochs: Sequence[TrackedEpoch], origin: FloatArray) -> list[Row]:
    """Rows of ``epoch_pairs``: congruence tests, datum and calibration."""
    rows = []
    for pair in tracking.pairs:
        test = pair.congruence
        rows.append(
            {
                "epoch_from": epochs[pair.first].label,
                "epoch_to": epochs[pair.second].label,
                "units": len(test.stable),
                "stable_units": int(test.stable.sum()),
                "global_statistic": test.global_statistic,
                "global_degrees": None,
                "global_p_value": test.global_p_value,
                "common_e": test.motion[0],
                "common_n": test.motion[1],
                "common_h": test.motion[2],
                "common_rotation_deg": math.degrees(float(np.linalg.norm(test.motion[3:6]))),
                "common_p_value": test.common_p_value,
                "covariance_factor": test.null.factor,
                "covariance_floor": test.null.floor,
                "rotation_factor": pair.turn_null.factor,
                "rotation_floor_deg": math.degrees(pair.turn_null.floor),
                "tail_degrees": test.null.tail,
                "geometry": np.asarray(test.origin) + origin,
            }
        )
    return rows


def cross_check_rows(tracking: Tracking, epochs: Sequence[TrackedEpoch], names: Sequence[str], origin: FloatArray) -> list[Row]:
    """Rows of ``cross_checks``."""
    rows = []
    for (first, second, unit), check in sorted(tracking.cross_checks.items()):
        sds = np.sqrt(np.diag(check.covariance))
        pose = tracking.units[unit][first].pose
        rows.append(
            {
                "unit_id": names[unit],
                "epoch_from": epochs[first].label,
                "epoch_to": epochs[second].label,
                "de": check.vector[0],
                "dn": check.vector[1],
                "dh": check.vector[2],
                "sd_e": sds[0],
                "sd_n": sds[1],
                "sd_h": sds[2],
                "rotation_deg": math.degrees(check.turn),
                "overlap": check.overlap,
                "difference": check.difference,
                "statistic": check.statistic,
                "p_value": check.p_value,
                "agrees": check.agrees,
                "reason": check.reason,
                "geometry": None if pose is None else pose.centre + origin,
            }
        )
    return rows


def velocity_rows(tracking: Tracking, epochs: Sequence[TrackedEpoch], names: Sequence[str], origin: FloatArray) -> list[Row]:
    """Rows of ``velocities``."""
    rows = []
    for unit, velocities in sorted(tracking.velocities.items()):
        have = [e for e, s in sorted(tracking.units[unit].items()) if s.pose is not None]
        pose = tracking.units[unit][have[-1]].pose
        for v in velocities:
            rows.append(
                {
                    "unit_id": names[unit],
                    "feature": v.feature,
                    "epoch_from": epochs[have[0]].label,
                    "epoch_to": epochs[have[-1]].label,
                    "epochs": len(have),
                    "ve": v.vector[0],
                    "vn": v.vector[1],
                    "vh": v.vector[2],
                    "sd_e": v.sd[0],
                    "sd_n": v.sd[1],
                    "sd_h": v.sd[2],
                    "misfit_p_value": v.misfit_p_value,
                    "geometry": None if pose is None else pose.centre + origin,
                }
            )
    return rows


def unit_tables(
    tracking: Tracking,
    epochs: Sequence[TrackedEpoch],
    units: Sequence[UnitType],
    names: Sequence[str],
    origin: FloatArray,
    from_fit: Callable[[int, int | None], Mapping[str, Any]],
) -> tuple[list[Row], list[Row]]:
    """Rows of ``units`` and ``feature_points``.

    Parameters
    ----------
    from_fit
        Fields of an epoch's fitted unit that tracking does not change, with ``observed`` (5,); for row None those of a recovered unit.
    """
    unit_rows: list[Row] = []
    points: list[Row] = []
    for k, states in enumerate(tracking.units):
        unit = units[tracking.kinds[k]]
        for epoch, state in sorted(states.items()):
            base: Row = {
                "unit_id": names[k],
                "epoch": epochs[epoch].label,
                "epoch_time": epochs[epoch].time,
                "unit_type": unit.name,
                "height": unit.height,
                "status": state.status,
                "datum": epochs[epoch].datum,
            }
            others = may_be(tracking, k, epoch)
            base["may_be"] = " ".join(names[j] for j in others) or None
            if state.pose is None:
                unit_rows.append(base | {"geometry": None})
                continue
            shape = unit_shape(unit, state.scale)
            fit = dict(from_fit(epoch, state.row))
            observed = fit.pop("observed", [None] * len(FEATURES))
            covariance = pose_covariance(tracking, epoch, state)
            pose = pose_in_frame(tracking, epoch, state.pose).shifted(origin)
            qx, qy, qz, qw = pose.quaternion()
            unit_rows.append(
                base
                | {"r0": shape.radius, "gradient": shape.gradient, "qx": qx, "qy": qy, "qz": qz, "qw": qw, "n_points": state.points}
                | fit
                | state.legs.as_row()
                | covariance_fields(covariance)
                | {"geometry": pose.centre}
            )
            points += feature_rows(names[k], epochs[epoch].label, epochs[epoch].time, pose, shape, covariance, observed)
    return unit_rows, points
