"""All steps on the tiny survey: same result for any tiling, workers and interruption; layers that belong together."""

from __future__ import annotations

import json
import math
import os
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import laspy
import numpy as np
import pytest
from result_contents import contents
from tetratrack.core.common.errors import Cancelled, InputError, OutputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey import Survey
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.pipeline.epoch_plans import plan_survey
from tetratrack.core.pipeline.gap_table import covered_ground
from tetratrack.core.pipeline.inspection import run_inspect
from tetratrack.core.pipeline.run_options import RunOptions
from tetratrack.core.pipeline.whole_survey import run_fit, run_segment, run_survey
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.core.results.geopackage_writer import from_upper_triangle
from tetratrack.scripts.cli import app
from typer.testing import CliRunner


def retiled(tiny: Path, folder: Path, split: Callable[[np.ndarray, np.ndarray], np.ndarray], order: int = 1) -> Survey:
    """The tiny survey with the points of each epoch cut into other files."""
    folder.mkdir()
    survey = read_survey(tiny / "survey.toml")
    epochs = []
    for epoch in survey.epochs:
        clouds = [laspy.read(path) for path in epoch.tiles]
        header = clouds[0].header
        points = np.concatenate([np.asarray(cloud.points.array) for cloud in clouds])[::order]
        record = laspy.ScaleAwarePointRecord(points, header.point_format, header.scales, header.offsets)
        part = split(np.asarray(record.x), np.asarray(record.y))
        paths = []
        for number in np.unique(part):
            las = laspy.LasData(laspy.LasHeader(version=header.version, point_format=header.point_format))
            las.header.scales, las.header.offsets, las.header.vlrs = header.scales, header.offsets, header.vlrs
            las.header.global_encoding.wkt = True
            las.points = record[part == number]
            paths.append(folder / f"{epoch.label}_{number}.laz")
            las.write(str(paths[-1]))
        epochs.append(replace(epoch, tiles=tuple(paths)))
    return replace(survey, epochs=tuple(epochs))


def test_every_unit_and_epoch_states_its_quality(result: Path) -> None:
    units = [row for row in read_layer_rows(result, "units") if row["geom"] is not None]
    fitted = [row for row in units if row["distance_median"] is not None]
    assert len(fitted) > 0.8 * len(units)
    for row in fitted:
        assert 0 < row["distance_median"] < 0.02 * row["height"]
        assert 0 < row["supported"] <= 1
    assert all(row["nearest_centre"] > 0.5 * row["height"] and 0 <= row["overlap_share"] < 0.01 for row in units)
    for epoch in read_layer_rows(result, "epochs"):
        quality = json.loads(epoch["settings"])["quality"]
        own = [row for row in units if row["epoch"] == epoch["label"]]
        assert quality["found"] + quality["uncertain"] == len(own)
        assert quality["close_pairs"] == 0
        assert quality["gaps"] == sum(row["epoch"] == epoch["label"] for row in read_layer_rows(result, "gaps"))


def test_layers_belong_together(result: Path, tiny: Path) -> None:
    layers = contents(result)
    units = {(row["unit_id"], row["epoch"]): row for row in layers["units"]}
    assert len(units) == len(layers["units"]) > 0
    assert {row["status"] for row in layers["units"]} <= {"found", "uncertain", "new", "relocated", "lost", "unseen"}
    placed = {key for key, row in units.items() if row["geom"] is not None}
    assert {row["status"] for key, row in units.items() if key not in placed} <= {"lost", "unseen"}
    features = {(row["unit_id"], row["epoch"], row["feature"]): row for row in layers["feature_points"]}
    assert len(features) == 5 * len(placed)
    for unit_id, epoch in placed:
        assert np.allclose(features[unit_id, epoch, "centre"]["geom"], units[unit_id, epoch]["geom"], atol=1e-9)
    for row in layers["displacements"]:
        start, end = np.array(row["geom"])
        assert np.allclose(end - start, [row["de"], row["dn"], row["dh"]], atol=1e-6)
        assert np.allclose(start, features[row["unit_id"], row["epoch_from"], row["feature"]]["geom"], atol=1e-6)
        assert row["d_3d"] == pytest.approx(np.linalg.norm(end - start), abs=1e-6)
    for row in layers["units"]:
        if row["covariance"]:
            covariance = from_upper_triangle(row["covariance"])
            assert np.sqrt(covariance[0, 0]) == pytest.approx(row["sd_e"])
            assert np.linalg.eigvalsh(covariance).min() > -1e-12
    survey = read_survey(tiny / "survey.toml")
    for epoch, row in zip(survey.epochs, layers["epochs"], strict=True):
        assert row["label"] == epoch.label
        assert json.loads(row["tiles"]) == [path.name for path in epoch.tiles]
        settings = json.loads(row["settings"])
        assert {item["name"] for item in settings["inputs"]} >= {path.name for path in epoch.tiles}


@pytest.mark.parametrize(
    ("split", "order"),
    [
        (lambda x, y: np.zeros(len(x), int), 1),
        (lambda x, y: (x > np.median(x)) * 2 + (y > np.median(y)), -1),
        (lambda x, y: np.arange(len(x)) % 16, 1),
    ],
    ids=["one tile", "four tiles", "sixteen overlapping tiles"],
)
def test_result_does_not_depend_on_tiling(tiny: Path, result: Path, tmp_path: Path, split, order: int) -> None:
    survey = retiled(tiny, tmp_path / "tiles", split, order)
    path = tmp_path / "other.gpkg"
    run_survey(survey, path, RunOptions(workers=1), Feedback())
    assert contents(path, without_inputs=True) == contents(result, without_inputs=True)


def test_duplicate_tiles_change_nothing(tiny: Path, result: Path, tmp_path: Path) -> None:
    survey = read_survey(tiny / "survey.toml")
    epochs = []
    for epoch in survey.epochs:
        copy = tmp_path / f"copy_of_{epoch.tiles[0].name}"
        shutil.copy(epoch.tiles[0], copy)
        epochs.append(replace(epoch, tiles=(*epoch.tiles, copy)))
    path = tmp_path / "other.gpkg"
    said: list[str] = []
    run_survey(replace(survey, epochs=tuple(epochs)), path, RunOptions(workers=1), Feedback(warning=said.append))
    assert sum("holds the same points as" in line for line in said) == len(epochs)
    for name in ("units", "feature_points", "displacements"):
        assert contents(path)[name] == contents(result)[name]


def command(survey: Path, path: Path, workers: int, *options: str) -> list[str]:
    program = [sys.executable, "-m", "tetratrack.scripts.cli"]
    return [*program, "run", str(survey), "-o", str(path), "-j", str(workers), "-q", *options]


@pytest.fixture(scope="module")
def result_of_command(tiny: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The result of one worker in a process of its own: last digits depend on which loops a process has loaded first."""
    path = tmp_path_factory.mktemp("command") / "r.gpkg"
    subprocess.run(command(tiny / "survey.toml", path, 1), check=True, env=os.environ)
    return path


def test_result_does_not_depend_on_workers(tiny: Path, result_of_command: Path, tmp_path: Path) -> None:
    path = tmp_path / "other.gpkg"
    subprocess.run(command(tiny / "survey.toml", path, 2), check=True, env=os.environ)
    assert contents(path) == contents(result_of_command)


def test_resume_does_not_do_finished_blocks_again(tiny: Path, result: Path, tmp_path: Path) -> None:
    survey = read_survey(tiny / "survey.toml")
    path = tmp_path / "r.gpkg"
    calls = 0

    def cancel_after_the_first_block() -> bool:
        nonlocal calls
        calls += len(list((tmp_path / "r.gpkg.jobs").glob("segment-*"))) if (tmp_path / "r.gpkg.jobs").exists() else 0
        return calls > 0

    with pytest.raises(Cancelled):
        run_survey(survey, path, RunOptions(workers=1, resume=True), Feedback(is_cancelled=cancel_after_the_first_block))
    assert not path.exists()
    finished = {p.name: p.stat().st_mtime_ns for p in (tmp_path / "r.gpkg.jobs").iterdir()}
    assert len(finished) == 1
    run_survey(survey, path, RunOptions(workers=1, resume=True), Feedback())
    assert contents(path) == contents(result)
    assert finished.items() <= {p.name: p.stat().st_mtime_ns for p in (tmp_path / "r.gpkg.jobs").iterdir()}.items()


def test_two_runs_into_one_output(tiny: Path, tmp_path: Path) -> None:
    survey = read_survey(tiny / "survey.toml")
    path = tmp_path / "r.gpkg"
    refused = []

    def second_run() -> bool:
        if not refused:
            with pytest.raises(OutputError, match="is being written by another run") as caught:
                run_survey(survey, path, RunOptions(workers=1), Feedback())
            refused.append(caught.value)
        return False

    run_segment(survey, path, RunOptions(workers=1), Feedback(progress=lambda f, m: second_run() if "block 1" in m else None))
    assert refused
    assert read_layer_rows(path, "units")


def test_steps_one_by_one(tiny: Path, tmp_path: Path) -> None:
    survey = read_survey(tiny / "survey.toml")
    runner = CliRunner()
    segmented, fitted, features, registered = (tmp_path / f"{name}.gpkg" for name in ("segmented", "fitted", "features", "registered"))
    found = run_segment(survey, segmented, RunOptions(workers=1), Feedback())
    assert found["epochs"] == 2
    assert found["units"] >= 1
    first = read_layer_rows(segmented, "units")[0]
    with closing(sqlite3.connect(segmented)) as connection, connection:
        connection.execute("UPDATE units SET status = 'uncertain', score = 0.34 WHERE fid = ?", (first["fid"],))
    run_fit(survey, segmented, fitted, RunOptions(workers=1), Feedback())
    before = {row["epoch"]: [] for row in read_layer_rows(segmented, "units")}
    for row in read_layer_rows(segmented, "units"):
        before[row["epoch"]].append(row["geom"])
    adjusted = [row for row in read_layer_rows(fitted, "units") if row["sd_e"] is not None]
    assert adjusted
    for row in adjusted:
        assert min(np.linalg.norm(row["geom"] - place) for place in before[row["epoch"]]) < 0.2 * row["height"]
    kept = min(read_layer_rows(fitted, "units"), key=lambda row: math.dist(row["geom"], first["geom"]) + (row["epoch"] != first["epoch"]))
    assert [kept[name] for name in ("status", "score", "coverage", "supported")] == [
        "uncertain",
        0.34,
        first["coverage"],
        first["supported"],
    ], "what segment said of it stays"
    assert None not in {row["score"] for row in read_layer_rows(fitted, "units")}
    result = runner.invoke(app, ["features", str(fitted), "--output", str(features), "--quiet"])
    assert result.exit_code == 0, result.output
    places = {(r["unit_id"], r["epoch"], r["feature"]): r["geom"] for r in read_layer_rows(features, "feature_points")}
    for row in read_layer_rows(fitted, "feature_points"):
        assert np.allclose(places[row["unit_id"], row["epoch"], row["feature"]], row["geom"], atol=1e-9)
    result = runner.invoke(app, ["register", str(tiny / "survey.toml"), "--output", str(registered), "--quiet"])
    assert result.exit_code == 0, result.output
    rows = read_layer_rows(registered, "control_residuals")
    assert {row["epoch"] for row in rows} == {epoch.label for epoch in survey.epochs}
    with pytest.raises(InputError, match="names the epoch"):
        run_fit(replace(survey, epochs=survey.epochs[:1]), segmented, tmp_path / "x.gpkg", RunOptions(workers=1), Feedback())


def test_several_types_of_unit_compete(tiny: Path, result: Path, tmp_path: Path) -> None:
    survey = read_survey(tiny / "survey.toml")
    wrong = replace(survey.units[0], type=replace(survey.unit, name="half", height=survey.unit.height / 2, radius=survey.unit.radius / 2,
                                                  leg_length=survey.unit.leg_length / 2))  # fmt: skip
    nowhere = replace(wrong, area=((0.0, 0.0), (1.0, 0.0), (1.0, 1.0)))
    path = tmp_path / "two.gpkg"
    run_segment(replace(survey, units=(survey.units[0], nowhere)), path, RunOptions(workers=1), Feedback())
    assert {row["unit_type"] for row in read_layer_rows(path, "units")} == {"tetrapod"}


def test_ground_that_an_epoch_covers(tiny: Path) -> None:
    for plan in plan_survey(read_survey(tiny / "survey.toml")):
        ground = covered_ground([plan], {}, [])[plan.epoch.label]
        low, high = (np.array([getattr(tile, side) for tile in plan.tiles]) for side in ("low", "high"))
        low, high = low.min(axis=0), high.max(axis=0)
        assert ground.around((low + high) / 2, 1.0)
        assert not any(ground.around(place, 1.0) for place in (low - 1.1, high + 1.1))
        unknown = replace(plan, tiles=tuple(replace(tile, cells=None) for tile in plan.tiles))
        assert not covered_ground([unknown], {}, [])


def test_inspect_without_crs(tmp_path: Path) -> None:
    from las_files import grid_points, write_las

    path = write_las(tmp_path / "a.las", grid_points(), None)
    outputs, error = run_inspect([path], None, Feedback())
    assert error is None
    assert outputs["crs"] == ""


def test_killed_run_leaves_no_result_and_resumes(tiny: Path, result_of_command: Path, tmp_path: Path) -> None:
    path = tmp_path / "r.gpkg"
    resumed = command(tiny / "survey.toml", path, 2, "--resume")
    process = subprocess.Popen(resumed, start_new_session=True, env=os.environ)
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline and process.poll() is None and not list(tmp_path.glob("r.gpkg.jobs/segment-*")):
        time.sleep(0.02)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    assert not path.exists()
    assert subprocess.run(resumed, check=False).returncode == 0
    assert contents(path) == contents(result_of_command)
