"""Tables of a whole survey: its units tracked through all epochs, and its check points compared with theirs."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from .control import Registration, Transformation
from .displacement import grades_from
from .epoch_units import EpochUnits
from .feedback import Feedback
from .fitted_unit import FittedUnit
from .survey import Survey
from .tiles import read_points
from .tracking import Surroundings, TrackedEpoch, track
from .tracking_tables import TableOptions, cross_check_rows, displacement_rows, pair_rows, unit_names, unit_tables, velocity_rows
from .unit_clouds import UnitCloud
from .unit_types import UnitType
from .validation import CheckResidual, check_residuals, checked_displacements, read_check, residual_rows, summarise

FloatArray = NDArray[np.float64]
Tables = dict[str, list[dict[str, Any]]]


def track_tables(
    survey: Survey,
    fitted: Sequence[EpochUnits],
    units: tuple[UnitType, ...],
    registrations: Mapping[str, Registration],
    feedback: Feedback,
) -> tuple[Tables, dict[str, Any]]:
    """Rows of all layers that need several epochs, and of units and feature points; counts and settings by epoch for the record."""
    centres = np.concatenate([epoch.table["poses"][:, :3] for epoch in fitted])
    origin = np.round(centres.mean(axis=0)) if len(centres) else np.zeros(3)
    labels = [e.plan.epoch.label for e in fitted]
    placed = [_tracked_epoch(k, e, registrations.get(e.plan.epoch.label), units, origin, labels) for k, e in enumerate(fitted)]
    result = track(placed, units, _surroundings(survey, fitted, registrations, origin, feedback))
    names = unit_names(len(result.units))
    limits = survey.sections["displacement"]
    base = (float(origin[0]), float(origin[1]), float(origin[2]))
    options = TableOptions(base, limits["significance"], grades_from(limits))

    def from_fit(epoch: int, row: int | None) -> dict[str, Any]:
        if row is None:
            return {}
        table = fitted[epoch].table
        fields = ("legs_visible", "coverage", "score", "sigma0", "distance_median", "supported")
        return {name: table[name][row] for name in fields} | {"observed": [bool(v) for v in table["observed"][row]]}

    unit_rows_, points = unit_tables(result, placed, units, names, origin, from_fit)
    moved, other = displacement_rows(result, placed, units, names, options)
    tables: Tables = {
        "units": unit_rows_,
        "feature_points": points,
        "displacements": moved,
        "displacements_other": other,
        "epoch_pairs": pair_rows(result, placed, origin),
        "cross_checks": cross_check_rows(result, placed, names, origin),
        "velocities": velocity_rows(result, placed, names, origin),
    }
    settings = {
        e.label: {
            "displacement": dict(limits),
            "source_offsets_m": {
                str(source): [round(float(v), 5) for v in offset]
                for (epoch, source), offset in sorted(result.joint.offsets.items())
                if epoch == k
            },
        }
        for k, e in enumerate(placed)
    }
    last = {row["unit_id"] for row in moved if row["class"] == "moved"}
    return tables, {"units": len(names), "moved": len(last), "epochs": settings}


def _tracked_epoch(
    number: int,
    epoch: EpochUnits,
    registration: Registration | None,
    units: tuple[UnitType, ...],
    origin: FloatArray,
    labels: Sequence[str],
) -> TrackedEpoch:
    """Units of an epoch (its number) with their clouds in the control frame, less the common reduction point."""
    known = None if registration is None else registration.transformation
    transformation = Transformation.identity(origin) if known is None else known
    table = epoch.table
    turn = np.kron(np.eye(2), transformation.rotation)
    points_of = epoch.reader()

    def cloud(row: int, ids: NDArray[np.uint16]) -> UnitCloud:
        def read() -> tuple[FloatArray, NDArray[np.uint16]]:
            points, sources = points_of(row)
            return transformation.apply(points) - origin, sources

        return UnitCloud(ids, read, (number, int(epoch.places[row, 0])))

    found: dict[int, FittedUnit] = {}
    for row, ids in epoch.source_ids():
        pose = transformation.apply_pose(epoch.pose(row)).shifted(-origin)
        kind = int(table["type"][row])
        certain = table["status"][row] == "found"
        score = float(table["score"][row])
        own = table["covariance"][row][:6, :6]
        covariance = turn @ own @ turn.T if np.isfinite(own).all() else None
        n_points = int(table["n_points"][row])
        found[row] = FittedUnit(pose, units[kind], kind, certain, table["discs"][row], cloud(row, ids), covariance, score, n_points)
    return TrackedEpoch(
        epoch.plan.epoch.label,
        epoch.plan.epoch.time,
        tuple(found[row] for row in range(len(epoch))),
        None if known is None else replace(known, origin_to=known.origin_to - origin),
        0 if registration is None else registration.redundancy,
        None if registration is None or registration.reference is None else labels.index(registration.reference),
    )


def _surroundings(
    survey: Survey, epochs: Sequence[EpochUnits], registrations: Mapping[str, Registration], origin: FloatArray, feedback: Feedback
) -> Surroundings:
    """Reader of an epoch's cloud around places, for :func:`tetratrack.core.tracking.track`."""

    def read(number: int, places: FloatArray, reach: float) -> tuple[FloatArray, NDArray[np.integer[Any]]]:
        plan = epochs[number].plan
        registration = registrations.get(plan.epoch.label)
        transformation = Transformation.identity(origin) if registration is None else registration.transformation
        where = transformation.invert(places + origin)
        tree = cKDTree(where - origin)
        parts: list[FloatArray] = []
        sources: list[NDArray[np.integer[Any]]] = []
        for block in plan.blocks:
            if not block.core.grown(reach).contains(where).any():
                continue
            feedback.check()
            cloud = read_points(block.tiles, survey.crs, window=block.core, origin=origin, tiles_crs=plan.epoch.tiles_crs)
            near = np.isfinite(tree.query(cloud.xyz, distance_upper_bound=reach)[0])
            parts.append(transformation.apply(cloud.xyz[near] + origin) - origin)
            sources.append(cloud.source_id[near])
        if not parts:
            return np.empty((0, 3)), np.empty(0, dtype=np.uint16)
        return np.vstack(parts), np.concatenate(sources)

    return read


def check_tables(survey: Survey, points: Sequence[Mapping[str, Any]], feedback: Feedback) -> tuple[list[dict[str, Any]], float | None]:
    """Rows of ``check_residuals`` of all epochs that have check points, and their root mean square length in metres."""
    residuals: list[CheckResidual] = []
    for epoch in survey.epochs:
        if epoch.check is None:
            continue
        features: dict[str, dict[str, FloatArray]] = {}
        for row in points:
            if row["epoch"] == epoch.label:
                features.setdefault(row["unit_id"], {})[row["feature"]] = row["geometry"]
        residuals += check_residuals(read_check(epoch.check), features, max(u.type.height for u in survey.units), epoch.label)
    summary = summarise([c.error for c in checked_displacements(residuals, [epoch.label for epoch in survey.epochs])])
    if summary.count:
        feedback.info(
            f"displacements of {summary.count} check points: mean absolute error {1000 * summary.mean_absolute:.1f} mm, "
            f"largest {1000 * summary.maximum:.1f} mm"
        )
    lengths = [r.length for r in residuals if r.difference is not None]
    return residual_rows(residuals), math.sqrt(sum(v**2 for v in lengths) / len(lengths)) if lengths else None
