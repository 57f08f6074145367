"""Tables of a whole survey: its units tracked through all epochs, and its check points compared with theirs."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from ..adjustment.surface_estimation import LEAST_MOULD_UNITS
from ..common.arrays import FloatArray
from ..common.feedback import Feedback
from ..data.survey import Survey
from ..deformation.displacement import grades_from
from ..deformation.fitted_unit import FittedUnit
from ..deformation.missing_units import Surroundings
from ..deformation.target_shifts import TargetShifts
from ..deformation.tracked_epoch import TrackedEpoch
from ..deformation.tracking import Tracking, track
from ..deformation.unit_clouds import UnitCloud
from ..deformation.validation import CheckResidual, check_residuals, checked_displacements, read_check, residual_rows, summarise
from ..model.unit_types import UnitType
from ..registration.control import DISTURBED, Registration
from ..registration.transformation import Transformation
from ..segmentation.leg_ends import LegEnds
from .block_clouds import BlockClouds
from .block_jobs import LEG_COLUMNS
from .displacement_table import TableOptions, cross_check_rows, displacement_rows, pair_rows, unit_names, unit_tables, velocity_rows
from .epoch_units import EpochUnits
from .frame_table import frame_error_rows, frame_settings, stretch_rows
from .job_runner import JobRunner
from .tracking_jobs import FiledPoints, HeldClouds, LastFile, PointsAround, answered_by

Tables = dict[str, list[dict[str, Any]]]

FEW_UNITS = 10
"""Units of a pair below which the prior of the calibration counts about as much as they do: thirty components for its four parameters."""


def track_tables(
    survey: Survey,
    fitted: Sequence[EpochUnits],
    units: tuple[UnitType, ...],
    registrations: Mapping[str, Registration],
    checksums: Mapping[Path, str],
    runner: JobRunner,
    feedback: Feedback,
) -> tuple[Tables, dict[str, Any]]:
    """Rows of all layers that need several epochs, and of units and feature points; counts and settings by epoch for the record.

    Parameters
    ----------
    survey, fitted
        The survey, and its units by epoch.
    units
        Types of unit.
    registrations
        By label of the epoch.
    checksums
        Of the tiles.
    runner
        Runs what is asked of points.
    feedback
        Messages.
    """
    centres = np.concatenate([epoch.table["poses"][:, :3] for epoch in fitted])
    origin = np.round(centres.mean(axis=0)) if len(centres) else np.zeros(3)
    labels = [e.plan.epoch.label for e in fitted]
    held = HeldClouds()
    placed = [_tracked_epoch(k, e, registrations.get(e.plan.epoch.label), units, origin, labels, held) for k, e in enumerate(fitted)]
    moulds = tuple(unit.mould for unit in survey.units)
    around = _surroundings(survey, fitted, registrations, origin, checksums, runner.clouds)
    result = track(placed, units, around, survey.frame, moulds, partial(answered_by, runner))
    _say_what_rests_on_experience(result, labels, feedback)
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
        "frame_errors": frame_error_rows(result, placed, max(unit.height for unit in units), origin),
        "stretches": stretch_rows(result.pairs, placed, origin, limits["significance"]),
    }
    settings: dict[str, dict[str, Any]] = {
        e.label: {
            "displacement": dict(limits),
            "redundancy": e.redundancy,
            "frame": frame_settings(result, k),
            "castings": {shape.name: surface.as_mould(survey.name, shape).as_record() for shape, surface in result.joint.surfaces.items()},
            "source_offsets_m": {
                str(source): [round(float(v), 5) for v in offset]
                for (epoch, source), offset in sorted(result.joint.offsets.items())
                if epoch == k
            },
            "mean_offset_sd_m": math.sqrt(result.offset_variances[k]),
            "mean_drift_sds_m": [round(float(v), 6) for v in np.sqrt(result.drift_variances[k])],
        }
        for k, e in enumerate(placed)
    }
    last = {row["unit_id"] for row in moved if row["class"] == "moved"}
    judged = {e.label: judged_targets(registrations[e.label], result, k) for k, e in enumerate(placed) if e.label in registrations}
    return tables, {"units": len(names), "moved": len(last), "epochs": settings, "registrations": judged}


def _say_what_rests_on_experience(result: Tracking, labels: Sequence[str], feedback: Feedback) -> None:
    """Tell where too few units stand behind the calibration of a pair, or behind the mould."""
    for pair in result.pairs:
        count = len(pair.judged)
        if 0 < count < FEW_UNITS and pair.second == pair.first + 1:
            feedback.info(
                f"{labels[pair.first]} to {labels[pair.second]}: {count} units are too few to tell by themselves how far standard "
                "deviations hold; they rest on the adjustment and on what is known of other surveys "
                f"({pair.congruence.null.tail:.0f} degrees of freedom)"
            )
    for shape, surface in result.joint.surfaces.items():
        if surface.units < LEAST_MOULD_UNITS and result.pairs:
            feedback.info(f"{shape.name}: no mould is learned of {surface.units} units; castings are taken to vary as elsewhere")


def _tracked_epoch(
    number: int,
    epoch: EpochUnits,
    registration: Registration | None,
    units: tuple[UnitType, ...],
    origin: FloatArray,
    labels: Sequence[str],
    held: HeldClouds,
) -> TrackedEpoch:
    """Units of an epoch (its number) with their clouds in the control frame, less the common reduction point."""
    known = None if registration is None else registration.transformation
    transformation = Transformation.identity(origin) if known is None else known
    table = epoch.table
    turn = np.kron(np.eye(2), transformation.rotation)
    last = LastFile()
    found: dict[int, FittedUnit] = {}
    for row, ids in epoch.source_ids():
        pose = transformation.apply_pose(epoch.pose(row)).shifted(-origin)
        kind = int(table["type"][row])
        certain = table["status"][row] == "found"
        score = float(table["score"][row])
        own = table["covariance"][row][:6, :6]
        covariance = turn @ own @ turn.T if np.isfinite(own).all() else None
        n_points = int(table["n_points"][row])
        file, place = (int(value) for value in epoch.places[row])
        points = FiledPoints(file=epoch.files[file], place=place, transformation=transformation, origin=origin, last=last, held=held)
        legs = LegEnds(*(table[name][row] for name in LEG_COLUMNS)) if LEG_COLUMNS[0] in table else LegEnds.unseen()
        found[row] = FittedUnit(
            pose=pose,
            shape=units[kind],
            kind=kind,
            certain=certain,
            discs=table["discs"][row],
            cloud=UnitCloud(ids, points, (number, file)),
            covariance=covariance,
            score=score,
            twist_open=bool(table["twist_open"][row]),
            n_points=n_points,
            legs=legs,
        )
    return TrackedEpoch(
        label=epoch.plan.epoch.label,
        time=epoch.plan.epoch.time,
        units=tuple(found[row] for row in range(len(epoch))),
        registration=None if known is None else replace(known, origin_to=known.origin_to - origin),
        redundancy=0 if registration is None else registration.redundancy,
        tied_to=None if registration is None or registration.reference is None else labels.index(registration.reference),
        targets=_targets(registration, origin),
        datum="cloud" if registration is None else registration.datum,
        numbered=not any(tile.strip_starts for tile in epoch.plan.tiles),
    )


def judged_targets(registration: Registration, tracking: Tracking, epoch: int) -> Registration:
    """The registration with its targets judged against the epoch's bent frame; as it was where frames are rigid."""
    verdicts = None if tracking.frames is None else tracking.frames.verdicts[epoch]
    if verdicts is None or tracking.frames is None:
        return registration
    rows = tuple(
        replace(
            row, residual=verdicts.residuals[k], w_max=float(verdicts.w_max[k]), p_value=float(verdicts.p_values[k]),
            used=bool(verdicts.used[k]), outlier=not verdicts.used[k],
        )
        for k, row in enumerate(registration.residuals)
    )  # fmt: skip
    sds = [1000 * sd for sd in tracking.frames.model.sds]
    notes = [note for note in registration.notes if not note.startswith(DISTURBED)]
    notes.append(
        f"its frame bends: {sds[0]:.0f}, {sds[1]:.0f}, {sds[2]:.0f} mm (e, n, h) over a correlation length of "
        f"{tracking.frames.model.length:.0f} m; removed from units and displacements, see layer frame_errors"
    )
    out = [row.point_id for row in rows if row.outlier]
    if out:
        notes.append(f"{DISTURBED}: {', '.join(out)}, judged against the bent frame")
    return replace(registration, residuals=rows, notes=tuple(notes))


def _targets(registration: Registration | None, origin: FloatArray) -> TargetShifts | None:
    """Targets after the rigid registration, the excluded ones too: a bent frame judges them anew."""
    if registration is None or not registration.residuals:
        return None
    rows = registration.residuals
    return TargetShifts(
        ids=tuple(r.point_id for r in rows),
        positions=np.array([r.position for r in rows]) - origin,
        residuals=np.array([r.residual for r in rows]),
        variances=np.array([r.sds for r in rows]) ** 2,
        surveyed_variances=np.array([r.surveyed_sds for r in rows]) ** 2,
        used=np.array([r.used for r in rows]),
    )


def _surroundings(
    survey: Survey,
    epochs: Sequence[EpochUnits],
    registrations: Mapping[str, Registration],
    origin: FloatArray,
    checksums: Mapping[Path, str],
    clouds: BlockClouds,
) -> Surroundings:
    """Reader of an epoch's cloud around places, for :func:`tetratrack.core.deformation.tracking.track`."""

    def around(number: int, places: FloatArray, reach: float) -> PointsAround:
        plan = epochs[number].plan
        registration = registrations.get(plan.epoch.label)
        transformation = Transformation.identity(origin) if registration is None else registration.transformation
        where = transformation.invert(places + origin)
        blocks = tuple(block for block in plan.blocks if block.core.grown(reach).contains(where).any())
        return PointsAround(
            blocks=blocks,
            survey_crs=survey.crs,
            transformation=transformation,
            origin=origin,
            places=where,
            reach=reach,
            checksums=tuple(checksums[tile.path] for block in blocks for tile in block.tiles),
            clouds=clouds,
        )

    return around


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
