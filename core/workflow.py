"""All steps from survey.toml to result.gpkg, one function each; the console command and, through it, QGIS call these.

Units are found and adjusted block by block in the frame of each epoch's cloud; registration then takes poses, covariances and
feature points into the control frame, where epochs are compared.
"""

from __future__ import annotations

import math
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from .epoch_plans import plan_survey
from .epoch_registration import register_epochs
from .epoch_units import find_and_fit, segment_epochs
from .errors import InputError, OutputError
from .feature_points import FEATURES
from .feedback import Feedback
from .gap_rows import gap_rows, look_into_tiles
from .geopackage import check_output, from_upper_triangle, replace_durably, write_result
from .pose import Pose
from .quality import state_quality
from .result_rows import control_rows, epoch_row, feature_rows, fitted_feature_rows, provisional_ids, unit_rows
from .run_options import RunOptions, job_runner
from .run_record import record_run
from .schema import LAYERS
from .survey import Survey
from .survey_tables import Tables, check_tables, track_tables
from .tiles import TileInfo, inspect_tile
from .unit_layer import crs_of_layer, plain, read_poses, read_units, unit_of

SHARES = {"read": 0.03, "fit": 0.82, "track": 0.14, "write": 0.01}
"""Share of each step in the time of a whole run, for the progress bar."""


def run_inspect(paths: Sequence[Path], output: Path | None, feedback: Feedback) -> dict[str, Any]:
    """Step ``inspect``: extent, CRS, number and density of points of tiles, as a table and, with ``output``, a layer ``tiles``.

    Raises
    ------
    InputError
        A tile that cannot be read.
    """
    tiles = []
    for k, path in enumerate(paths):
        feedback.check()
        tile = inspect_tile(path, None)
        tiles.append(tile)
        feedback.progress((k + 1) / len(paths), f"checked {path.name}")
    if output is not None:
        write_tile_index(output, tiles)
    names = [tile.crs for tile in tiles]
    return {
        "tiles": len(tiles),
        "points": sum(tile.points for tile in tiles),
        "density": float(np.median([tile.density for tile in tiles])),
        "crs": max(sorted(set(names)), key=names.count),
        "table": [
            {
                "tile": tile.path.name,
                "points": tile.points,
                "density": round(tile.density, 1),
                "crs": tile.crs if len(tile.crs) < 20 else f"{tile.crs[:19]}…",
                "extent": " ".join(f"{low:.2f}..{high:.2f}" for low, high in zip(tile.low, tile.high, strict=True)),
            }
            for tile in tiles
        ],
    }


def write_tile_index(path: Path, tiles: Sequence[TileInfo]) -> None:
    """Write one rectangle per tile to the layer ``tiles`` of a new GeoPackage, replacing an earlier one.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    import geopandas
    import shapely
    from pyogrio.errors import DataSourceError

    frame = geopandas.GeoDataFrame(
        {
            "file": [str(tile.path) for tile in tiles],
            "points": [tile.points for tile in tiles],
            "density": [tile.density for tile in tiles],
            "height_min": [tile.low[2] for tile in tiles],
            "height_max": [tile.high[2] for tile in tiles],
            "crs": [tile.crs for tile in tiles],
            "las_version": [tile.version for tile in tiles],
            "point_format": [tile.point_format for tile in tiles],
            "copc": [tile.copc for tile in tiles],
        },
        geometry=[shapely.box(tile.low[0], tile.low[1], tile.high[0], tile.high[1]) for tile in tiles],
        crs=next((tile.crs for tile in tiles if tile.crs not in ("", "LOCAL")), None),
    )
    target = path.absolute()
    try:
        # GDAL warns of a GeoPackage whose name does not end in .gpkg
        with tempfile.TemporaryDirectory(prefix=".tetratrack-", dir=target.parent) as folder:
            temporary = Path(folder) / "tiles.gpkg"
            frame.to_file(temporary, layer="tiles", driver="GPKG", engine="pyogrio")
            replace_durably(temporary, target)
    except (DataSourceError, OSError) as error:
        raise OutputError("cannot be written", source=path, remedy="Check the folder's permissions and free space.") from error


def run_register(survey: Survey, output: Path, options: RunOptions, feedback: Feedback) -> dict[str, Any]:
    """Step ``register``: transformation of each epoch's cloud to survey control, and the residuals."""
    check_output(output)
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


def run_features(units: Path, output: Path, feedback: Feedback) -> dict[str, Any]:
    """Step ``features``: feature points with covariance from a layer ``units`` of any GeoPackage."""
    check_output(output)
    tables: Tables = {"units": [], "feature_points": []}
    for row in read_units(units):
        feedback.check()
        row = {name: plain(value) for name, value in row.items() if name in {*LAYERS["units"].names, "geometry"}}
        tables["units"].append(row)
        if row["geometry"] is None:
            continue
        pose = Pose.from_quaternion(row["geometry"], [row["qx"], row["qy"], row["qz"], row["qw"]])
        unit = unit_of(row, units)
        covariance = from_upper_triangle(row["covariance"]) if row.get("covariance") else None
        tables["feature_points"] += feature_rows(
            str(row["unit_id"]), str(row["epoch"]), row.get("epoch_time"), pose, unit, covariance, [None] * len(FEATURES)
        )
    write_result(output, crs_of_layer(units), tables)
    return {"output": str(output), "features": len(tables["feature_points"])}


def run_survey(survey: Survey, output: Path, options: RunOptions, feedback: Feedback) -> dict[str, Any]:
    """All steps: tiles to units, feature points, registration and displacements, in one result.

    Raises
    ------
    InputError
        Input that cannot be used; nothing is written then.
    Cancelled
        The user ended the run; nothing is written.
    """
    check_output(output)
    start = SHARES["read"]
    plans = plan_survey(survey, feedback.part(0, start))
    record = record_run(
        survey,
        options.seed,
        {"step": "run", "survey": survey.name, "unit": [repr(unit) for unit in survey.units], "leg_length": survey.unit.leg_length},
    )
    registrations = register_epochs(survey, plans, feedback)
    with job_runner(output, options, feedback) as runner:
        fitted, calibration = find_and_fit(survey, plans, record, runner, feedback.part(start, start := start + SHARES["fit"]))
        feedback.progress(start, "tracking units")
        tables, summary = track_tables(survey, fitted, fitted[0].units, registrations, feedback)
        feedback.progress(1 - 3 * SHARES["write"], "looking for gaps")
        when = [(plan.epoch.label, plan.epoch.time) for plan in plans]
        seen = look_into_tiles(tables["units"], survey, plans, fitted[0].units, registrations, record.checksums, runner)
        tables["gaps"] = gap_rows(tables["units"], when, fitted[0].units, seen)
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
        write_result(output, survey.crs, tables)
    feedback.progress(1.0, "done")
    return {"output": str(output), "units": summary["units"], "moved": summary["moved"], "check_rmse": check_rmse}


def run_segment(survey: Survey, output: Path, options: RunOptions, feedback: Feedback) -> dict[str, Any]:
    """Step ``segment``: units with approximate poses, in the frame of each epoch's cloud."""
    check_output(output)
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
    check_output(output)
    given = None if units is None else read_poses(units, survey)
    plans = plan_survey(survey, feedback.part(0, 0.05))
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
