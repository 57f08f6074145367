"""All steps from survey.toml to result.gpkg, one function each; the console command and, through it, QGIS call these.

Units are found and adjusted block by block in the frame of each epoch's cloud; registration then takes poses, covariances and
feature points into the control frame, where epochs are compared.
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from ..armour.placement_rows import placement_rows, size_of_type
from ..common.errors import InputError
from ..common.feedback import Feedback
from ..common.kernels import threads_of_kernels
from ..common.output_files import check_targets
from ..data.survey import Survey
from ..data.survey_keys import check_number
from ..model.feature_points import FEATURES
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..registration.control import Registration
from ..results.field_checks import foreign_contents
from ..results.geopackage_writer import check_output, from_upper_triangle, write_result
from ..results.run_record import record_run
from ..results.schema import LAYERS
from ..results.unit_bodies import body_rows
from ..review.decisions import settle_decisions
from .epoch_alignment import align_epochs
from .epoch_plans import plan_survey
from .epoch_quality import state_quality
from .epoch_registration import register_epochs
from .epoch_tracking import Tables, check_tables, track_tables
from .epoch_units import find_and_fit, segment_epochs
from .gap_table import covered_ground, gap_rows, look_into_tiles
from .local_processes import LocalProcesses, processes_for
from .no_units import warn_of_empty
from .run_options import RunOptions, job_runner
from .size_check import check_sizes
from .unit_input import check_places, crs_of_layer, fitted_unit, read_given_units, read_units, stated_sizes
from .unit_table import control_rows, epoch_row, feature_rows, fitted_feature_rows, provisional_ids, unit_rows

SHARES = {"read": 0.03, "fit": 0.82, "track": 0.14, "write": 0.01}
"""Share of each step in the time of a whole run, for the progress bar."""
PATIENCE, PATIENCE_A_POINT = 2.0, 5e-6
"""Seconds, in all and for each point, that the check of sizes waits for the points of a block which a worker reads: a busy machine takes
1e-6 a point. Then they are read once more."""


def run_register(survey: Survey, output: Path, options: RunOptions, feedback: Feedback) -> dict[str, Any]:
    """Step ``register``: transformation of each epoch's cloud to survey control, and the residuals."""
    check_targets([(output, "the result")], survey.files)
    check_output(output, survey.crs, step=("control_residuals", "epochs"))
    plans = plan_survey(survey, feedback.part(0, 0.5))
    record = record_run(survey, options.seed, {"step": "register"})
    registrations = register_epochs(survey, plans, feedback.part(0.5, 1))
    if not registrations:
        raise InputError(
            "no epoch names control and targets",
            source=survey.path,
            remedy="Add control and targets to an [[epoch]], or stable_areas to [survey].",
        )
    tables: Tables = {"control_residuals": [], "epochs": []}
    squares, outliers = [], 0
    for plan in plans:
        registration = registrations.get(plan.epoch.label)
        if registration is None:
            tables["epochs"].append(epoch_row(plan, record, None, {}))
            continue
        for note in registration.notes:
            feedback.info(f"{plan.epoch.label}: {note}")
        tables["control_residuals"] += control_rows(plan.epoch.label, registration)
        tables["epochs"].append(epoch_row(plan, record, registration, {"redundancy": registration.redundancy}))
        squares += [float(np.sum(r.residual**2)) for r in registration.residuals if r.used]
        outliers += len(registration.excluded)
    write_result(output, survey.crs, tables)
    rmse = math.sqrt(sum(squares) / len(squares)) if squares else None
    return {"output": str(output), "rmse": rmse, "outliers": outliers}


def run_features(
    units: Path, output: Path, feedback: Feedback, *, end_discs: bool = False, leg_length: float | None = None
) -> dict[str, Any]:
    """Step ``features``: feature points with covariance from a layer ``units`` of any GeoPackage.

    With ``end_discs`` the centres of the legs' end discs as well; ``leg_length`` (metres) is that given, else that of the run, or of
    standard proportions where the file is no result.

    Raises
    ------
    InputError
        The layer cannot be used, or no unit of it can have such legs.
    """
    check_targets([(output, "the result")], [units])
    if leg_length is not None:
        check_number("unit", "leg_length", leg_length)
    crs = crs_of_layer(units)
    check_output(output, crs, step=("units", "feature_points"))
    sizes = stated_sizes(units)
    tables: Tables = {"units": [], "feature_points": []}
    for row in read_units(units):
        feedback.check()
        row = {name: value for name, value in row.items() if name in {*LAYERS["units"].names, "geometry"}}
        tables["units"].append(row)
        if row["geometry"] is None:
            continue
        pose = Pose.from_quaternion(row["geometry"], [row["qx"], row["qy"], row["qz"], row["qw"]])
        with foreign_contents(units):
            unit = fitted_unit(row, sizes, units)
            if end_discs and leg_length is not None:
                unit = _with_legs(unit, leg_length)
            covariance = from_upper_triangle(row["covariance"]) if row.get("covariance") else None
            name, epoch, time = str(row["unit_id"]), str(row["epoch"]), row.get("epoch_time")
            unseen = [None] * len(FEATURES)
            tables["feature_points"] += feature_rows(name, epoch, time, pose, unit, covariance, unseen, end_discs=end_discs)
    write_result(output, crs, tables)
    return {"output": str(output), "features": len(tables["feature_points"])}


def _with_legs(unit: UnitType, leg_length: float) -> UnitType:
    """The unit with legs of a length that the user gave, metres."""
    try:
        return replace(unit, leg_length=leg_length)
    except ValueError as error:
        raise InputError(str(error), where="--leg-length", remedy=f"Units here are {unit.height:g} m high.") from error


def run_survey(
    survey: Survey, output: Path, options: RunOptions, feedback: Feedback, processes: LocalProcesses | None = None
) -> dict[str, Any]:
    """All steps: tiles to units, feature points, registration and displacements, in one result.

    ``processes`` may be loading libraries already; None makes them.

    Raises
    ------
    InputError
        Input that cannot be used; nothing is written then.
    Cancelled
        The user ended the run; nothing is written.
    """
    check_targets([(output, "the result")], survey.files)
    check_output(output, survey.crs)
    with processes or processes_for(options.workers, options.scheduler) as own:
        # every epoch is a job or more
        own.start(len(survey.epochs))
        return _run(survey, output, options, feedback, own)


def _run(survey: Survey, output: Path, options: RunOptions, feedback: Feedback, processes: LocalProcesses) -> dict[str, Any]:
    start = SHARES["read"]
    plans = plan_survey(survey, feedback.part(0, start))
    if len(plans) == 1:
        feedback.info("one epoch: units and feature points are found; displacements need a second one")
    record = record_run(
        survey,
        options.seed,
        {"step": "run", "survey": survey.name, "unit": [repr(unit) for unit in survey.units], "leg_length": survey.unit.leg_length},
    )
    registrations: dict[str, Registration] = {}

    def look_beside() -> None:
        first = plans[0]
        kept = runner.clouds.of_so_many(sum(plan.points for plan in plans))
        seconds = PATIENCE + PATIENCE_A_POINT * first.points if runner.has_company else 0.0
        check_sizes(survey, first.tiles, feedback.part(start, start), lambda: kept.awaited(first.blocks, seconds, feedback.is_cancelled))
        registrations.update(register_epochs(survey, plans, feedback))

    with job_runner(output, options, feedback, processes, keep_points=True) as runner:
        part = feedback.part(start, start + SHARES["fit"])
        fitted, calibration = find_and_fit(survey, plans, record, runner, part, beside=look_beside)
        warn_of_empty(survey, [epoch.plan for epoch in fitted if not len(epoch)], feedback)
        registrations = align_epochs(survey, fitted, registrations, feedback)
        feedback.progress(start + SHARES["fit"], "tracking units")
        with threads_of_kernels(runner.workers):
            # the workers wait meanwhile
            tables, summary = track_tables(survey, fitted, fitted[0].units, registrations, record.checksums, runner, feedback)
        registrations = registrations | summary["registrations"]
        feedback.progress(1 - 3 * SHARES["write"], "looking for gaps")
        when = [(plan.epoch.label, plan.epoch.time) for plan in plans]
        shown: Tables = {}

        def lay_out_units() -> None:
            sizes = [size_of_type(unit.type) for unit in survey.units]
            shown.update(body_rows(tables["units"], tables["displacements"], sizes), placement=placement_rows(tables["units"], sizes))

        seen = look_into_tiles(
            tables["units"], survey, plans, fitted[0].units, registrations, tables["frame_errors"], record.checksums, runner,
            beside=lay_out_units,
        )  # fmt: skip
        covered = covered_ground(plans, registrations, tables["frame_errors"])
        tables["gaps"] = gap_rows(tables["units"], when, fitted[0].units, seen, covered)
        qualities = state_quality(tables["units"], fitted[0].units, [label for label, _ in when], feedback, tables["gaps"])
        tables |= {"control_residuals": [], "epochs": []}
        tables["check_residuals"], check_rmse = check_tables(survey, tables["feature_points"], feedback)
        for epoch in fitted:
            label = epoch.plan.epoch.label
            registration = registrations.get(label)
            if registration is None:
                feedback.info(f"{label}: no control, results stay in the frame of the cloud")
            else:
                tables["control_residuals"] += control_rows(label, registration)
                for note in registration.notes:
                    feedback.info(f"{label}: {note}")
            extra = summary["epochs"][label] | {"calibration": calibration, "quality": qualities[label]}
            tables["epochs"].append(epoch_row(epoch.plan, record, registration, extra))
        feedback.check()
        feedback.progress(1 - SHARES["write"], "writing")
        write_result(output, survey.crs, tables | shown)
    lapsed = settle_decisions(output)
    if lapsed:
        feedback.warning(f"{lapsed} decisions of reviewers rested on numbers that are others now: those units are undecided again")
    feedback.progress(1.0, "done")
    return {"output": str(output), "units": summary["units"], "moved": summary["moved"], "check_rmse": check_rmse}


def run_segment(survey: Survey, output: Path, options: RunOptions, feedback: Feedback) -> dict[str, Any]:
    """Step ``segment``: units with approximate poses, in the frame of each epoch's cloud."""
    check_targets([(output, "the result")], survey.files)
    check_output(output, survey.crs, step=("units", "epochs"))
    plans = plan_survey(survey, feedback.part(0, 0.05))
    record = record_run(survey, options.seed, {"step": "segment"})
    with job_runner(output, options, feedback) as runner:
        epochs = segment_epochs(survey, plans, record, runner, feedback.part(0.05, 0.98))
        tables: Tables = {"units": [], "epochs": []}
        for epoch in epochs:
            tables["units"] += unit_rows(epoch, provisional_ids(len(epoch)))
        qualities = state_quality(tables["units"], epochs[0].units, [epoch.plan.epoch.label for epoch in epochs], feedback)
        for epoch in epochs:
            tables["epochs"].append(epoch_row(epoch.plan, record, None, {"quality": qualities[epoch.plan.epoch.label]}))
        feedback.check()
        write_result(output, survey.crs, tables)
    return {"output": str(output), "units": sum(int((e.table["status"] == "found").sum()) for e in epochs), "epochs": len(epochs)}


def run_fit(survey: Survey, units: Path | None, output: Path, options: RunOptions, feedback: Feedback) -> dict[str, Any]:
    """Step ``fit``: adjusted units and feature points in the frame of each epoch's cloud, from given poses or from the points alone."""
    check_targets([(output, "the result")], [*survey.files, *([] if units is None else [units])])
    check_output(output, survey.crs, step=("units", "feature_points", "epochs"))
    given = None if units is None else read_given_units(units, survey)
    plans = plan_survey(survey, feedback.part(0, 0.05))
    if units is not None and given is not None:
        check_places(given, survey, plans, units, feedback)
    record = record_run(survey, options.seed, {"step": "fit"})
    with job_runner(output, options, feedback) as runner:
        epochs, calibration = find_and_fit(survey, plans, record, runner, feedback.part(0.05, 0.98), given)
        tables: Tables = {"units": [], "feature_points": [], "epochs": []}
        for epoch in epochs:
            ids = provisional_ids(len(epoch))
            tables["units"] += unit_rows(epoch, ids)
            for k, name in enumerate(ids):
                tables["feature_points"] += fitted_feature_rows(epoch, k, name)
        qualities = state_quality(tables["units"], epochs[0].units, [epoch.plan.epoch.label for epoch in epochs], feedback)
        for epoch in epochs:
            extra = {"calibration": calibration, "quality": qualities[epoch.plan.epoch.label]}
            tables["epochs"].append(epoch_row(epoch.plan, record, None, extra))
        feedback.check()
        write_result(output, survey.crs, tables)
    return {"output": str(output), "units": sum(len(e) for e in epochs), "epochs": len(epochs)}
