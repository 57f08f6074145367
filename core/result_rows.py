"""Rows of the result that units of one epoch, its plan and its registration become."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .control import Registration
from .epoch_plans import EpochPlan
from .epoch_units import EpochUnits
from .feature_points import FEATURES, feature_points
from .geopackage import upper_triangle
from .pose import Pose
from .run_record import RunRecord, software_version
from .unit_types import UnitType

FloatArray = NDArray[np.float64]
Row = dict[str, Any]


def unit_rows(epoch: EpochUnits, ids: Sequence[str]) -> list[Row]:
    """Rows of layer ``units`` in the frame of the cloud; ``ids`` names the units in the table's order."""
    table = epoch.table
    fitted = "covariance" in table
    rows = []
    for k in range(len(epoch)):
        pose = epoch.pose(k)
        unit = epoch.units[int(table["type"][k])]
        radius, gradient = (float(v) for v in table["shape"][k]) if fitted else (unit.radius, unit.gradient)
        qx, qy, qz, qw = (float(v) for v in pose.quaternion())
        row: dict[str, Any] = {
            "unit_id": ids[k],
            "epoch": epoch.plan.epoch.label,
            "epoch_time": epoch.plan.epoch.time,
            "unit_type": unit.name,
            "height": unit.height,
            "r0": radius,
            "gradient": gradient,
            "qx": qx,
            "qy": qy,
            "qz": qz,
            "qw": qw,
            "legs_visible": table["legs_visible"][k],
            "coverage": table["coverage"][k],
            "score": table["score"][k],
            "supported": table["supported"][k],
            "status": str(table["status"][k]),
            "geometry": pose.centre,
        }
        if fitted and np.isfinite(table["covariance"][k]).all():
            row |= covariance_fields(table["covariance"][k]) | {name: table[name][k] for name in ("sigma0", "n_points", "distance_median")}
        rows.append(row)
    return rows


def covariance_fields(covariance: FloatArray) -> dict[str, Any]:
    """Fields of ``units`` that follow from the (8, 8) covariance."""
    variances = np.clip(np.diag(covariance), 0, None)
    return {
        "sd_e": math.sqrt(variances[0]),
        "sd_n": math.sqrt(variances[1]),
        "sd_h": math.sqrt(variances[2]),
        "sd_rotation_deg": math.degrees(math.sqrt(variances[3:6].sum())),
        "covariance": upper_triangle(covariance),
    }


def feature_rows(
    unit_id: str, epoch: str, time: Any, pose: Pose, unit: UnitType, covariance: FloatArray | None, observed: Sequence[bool | None]
) -> list[Row]:
    """Rows of layer ``feature_points`` of one unit."""
    points = feature_points(pose, unit, covariance)
    rows = []
    for k, name in enumerate(FEATURES):
        row: dict[str, Any] = {
            "unit_id": unit_id,
            "epoch": epoch,
            "epoch_time": time,
            "feature": name,
            "observed": observed[k],
            "geometry": points.positions[k],
        }
        if covariance is not None:
            c = points.covariances[k]
            sds = np.sqrt(np.clip(np.diag(c), 0, None))
            row |= {"sd_e": sds[0], "sd_n": sds[1], "sd_h": sds[2], "cov_en": c[0, 1], "cov_eh": c[0, 2], "cov_nh": c[1, 2]}
        rows.append(row)
    return rows


def epoch_row(plan: EpochPlan, record: RunRecord, registration: Registration | None, extra: Mapping[str, Any]) -> dict[str, Any]:
    """Row of layer ``epochs``; no registration means that the cloud's own frame was kept and nothing was tied to it."""
    reference = None if registration is None else registration.reference
    if reference is not None:
        datum = "stable areas"
    else:
        datum = "control" if registration is not None and registration.residuals else "cloud"
    return {
        "label": plan.epoch.label,
        "time": plan.epoch.time,
        "tiles": json.dumps([tile.path.name for tile in plan.tiles]),
        "points": plan.points,
        "transformation": None if registration is None else json.dumps(registration.transformation.as_record()),
        "sigma0": None if registration is None else registration.sigma0,
        "datum": datum,
        "reference_epoch": reference,
        "software": f"tetratrack {software_version()}",
        "settings": record.of_epoch(plan.epoch, extra),
    }


def control_rows(epoch: str, registration: Registration) -> list[Row]:
    """Rows of layer ``control_residuals``."""
    return [
        {
            "point_id": r.point_id,
            "epoch": epoch,
            "ve": r.residual[0],
            "vn": r.residual[1],
            "vh": r.residual[2],
            "w_max": r.w_max,
            "used": r.used,
            "outlier": r.outlier,
            "geometry": r.position,
        }
        for r in registration.residuals
    ]


def provisional_ids(count: int) -> list[str]:
    """Names of units in order of easting, where no other epoch says otherwise."""
    return [f"U{k + 1:04d}" for k in range(count)]


def fitted_feature_rows(epoch: EpochUnits, row: int, unit_id: str) -> list[Row]:
    table = epoch.table
    covariance = table["covariance"][row]
    known = bool(np.isfinite(covariance).all())
    unit = epoch.units[int(table["type"][row])].with_shape(*table["shape"][row])
    return feature_rows(
        unit_id,
        epoch.plan.epoch.label,
        epoch.plan.epoch.time,
        epoch.pose(row),
        unit,
        covariance if known else None,
        [bool(v) for v in table["observed"][row]],
    )
