"""Rows of the result that units of one epoch, its plan and its registration become."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.software import software_version
from ..model.feature_points import END_DISCS, FEATURES, end_disc_centres, feature_points
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..registration.control import Registration
from ..results.geopackage_writer import upper_triangle
from ..results.run_record import RunRecord
from ..segmentation.leg_ends import LegEnds
from .block_jobs import LEG_COLUMNS
from .epoch_plans import EpochPlan
from .epoch_units import EpochUnits

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
            "datum": "cloud",
            "geometry": pose.centre,
        }
        if LEG_COLUMNS[0] in table:
            row |= LegEnds(*(table[name][k] for name in LEG_COLUMNS)).as_row()
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
    unit_id: str,
    epoch: str,
    time: Any,
    pose: Pose,
    unit: UnitType,
    covariance: FloatArray | None,
    observed: Sequence[bool | None],
    *,
    end_discs: bool = False,
) -> list[Row]:
    """Rows of layer ``feature_points`` of one unit; ``end_discs`` adds the optional ones, of which nothing is said to be observed."""
    points = feature_points(pose, unit, covariance)
    names: tuple[str, ...] = FEATURES
    positions, covariances = points.positions, points.covariances
    if end_discs:
        discs = end_disc_centres(pose, unit, covariance)
        names, observed = (*FEATURES, *END_DISCS), [*observed, *([None] * len(END_DISCS))]
        positions, covariances = np.vstack([positions, discs[0]]), np.concatenate([covariances, discs[1]])
    rows = []
    for k, name in enumerate(names):
        row: dict[str, Any] = {
            "unit_id": unit_id,
            "epoch": epoch,
            "epoch_time": time,
            "feature": name,
            "observed": observed[k],
            "geometry": positions[k],
        }
        if covariance is not None:
            c = covariances[k]
            sds = np.sqrt(np.clip(np.diag(c), 0, None))
            row |= {"sd_e": sds[0], "sd_n": sds[1], "sd_h": sds[2], "cov_en": c[0, 1], "cov_eh": c[0, 2], "cov_nh": c[1, 2]}
        rows.append(row)
    return rows


def epoch_row(plan: EpochPlan, record: RunRecord, registration: Registration | None, extra: Mapping[str, Any]) -> dict[str, Any]:
    """Row of layer ``epochs``; no registration means that the cloud's own frame was kept and nothing was tied to it."""
    return {
        "label": plan.epoch.label,
        "time": plan.epoch.time,
        "tiles": json.dumps([tile.path.name for tile in plan.tiles]),
        "points": plan.points,
        "transformation": None if registration is None else json.dumps(registration.transformation.as_record()),
        "sigma0": None if registration is None else registration.sigma0,
        "datum": "cloud" if registration is None else registration.datum,
        "reference_epoch": None if registration is None else registration.reference,
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
            "sd_e": r.sds[0],
            "sd_n": r.sds[1],
            "sd_h": r.sds[2],
            "geometry": r.position,
        }
        for r in registration.residuals
    ]


def provisional_ids(count: int) -> list[str]:
    """Names of units in order of easting, where no other epoch says otherwise."""
    return [f"U{k + 1:04d}" for k in range(count)]


def fitted_feature_rows(epoch: EpochUnits, row: int, unit_id: str) -> list[Row]:
    """Rows of ``feature_points`` for one adjusted unit of an epoch."""
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
