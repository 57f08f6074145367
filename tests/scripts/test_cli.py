"""The console command: every kind of bad input ends with exit code 2, one sentence and nothing left behind; messages and exit codes."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import numpy as np
import pytest
from las_files import grid_points, write_las
from synthetic_result import write_result as write_synthetic
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.core.results.schema import LAYERS
from tetratrack.scripts.cli import app
from typer.testing import CliRunner

SURVEY = """[survey]
name = "site"
crs = "EPSG:32650"
[unit]
type = "tetrapod"
height = 2.3
[[epoch]]
label = "a"
time = 2024-03-14T02:30:00Z
tiles = "{tiles}"
{more}
"""


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "tiles").mkdir()
    write_las(tmp_path / "tiles" / "good.laz", grid_points())
    (tmp_path / "out").mkdir()
    return tmp_path


def _survey(site: Path, tiles: str = "tiles/*.la[sz]", more: str = "") -> Path:
    path = site / "survey.toml"
    path.write_text(SURVEY.format(tiles=tiles, more=more), encoding="utf-8")
    return path


def _refused(site: Path, arguments: list[str], *said: str) -> None:
    before = sorted(p.relative_to(site) for p in site.rglob("*"))
    result = CliRunner().invoke(app, [str(a) for a in arguments])
    assert result.exit_code == 2, result.output
    errors = [line for line in result.stderr.splitlines() if line.startswith("error: ")]
    assert len(errors) == 1
    assert "Traceback" not in result.output
    for part in said:
        assert part in errors[0]
    assert sorted(p.relative_to(site) for p in site.rglob("*")) == before


def _run(site: Path) -> list[str]:
    return ["run", str(site / "survey.toml"), "--output", str(site / "out" / "result.gpkg"), "--workers", "1"]


def test_missing_survey(site: Path) -> None:
    _refused(site, _run(site), "survey.toml: there is no such file", "tetratrack template")


@pytest.mark.parametrize(
    ("tiles", "more", "said"),
    [
        ("tiles/none.laz", "", ("line 10", "there is no file tiles/none.laz")),
        ("tiles/*.copc", "", ("line 10", "no file matches tiles/*.copc")),
        ("tiles/*.la[sz]", "colour = 1", ("line 11", "unknown key colour", "Known here: label")),
        ("tiles/*.la[sz]", "tiles_crs = 7", ("line 11", "tiles_crs must be text in quotes, not the number 7")),
    ],
)
def test_mistakes_in_the_survey(site: Path, tiles: str, more: str, said: tuple[str, ...]) -> None:
    _survey(site, tiles, more)
    _refused(site, _run(site), "survey.toml", *said)


def test_a_bad_table_of_check_points_is_refused_before_the_tiles_are_looked_at(site: Path) -> None:
    (site / "check.csv").write_text("point_id,x,y,z\nK1,1,2,3\n", encoding="utf-8")
    _text(site)
    _survey(site, "tiles/*.la[sz]", 'check = "check.csv"')
    _refused(site, _run(site), "check.csv, line 1: has no column unit_easting")


def _text(site: Path) -> str:
    (site / "tiles" / "bad.las").write_text("x,y,z\n" * 200)
    return "is not a LAS or LAZ file"


def _truncated(site: Path) -> str:
    path = write_las(site / "tiles" / "bad.laz", grid_points(5000))
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    return "truncated"


def _flipped(site: Path) -> str:
    path = write_las(site / "tiles" / "bad.laz", grid_points(5000))
    data = bytearray(path.read_bytes())
    data[len(data) // 2 : len(data) // 2 + 400] = b"\xff" * 400
    path.write_bytes(data)
    return "bad.laz"


def _no_crs(site: Path) -> str:
    write_las(site / "tiles" / "bad.las", grid_points(), None)
    return "has no CRS"


def _geographic(site: Path) -> str:
    write_las(site / "tiles" / "bad.las", grid_points(origin=np.array([117.0, 31.0, 2.0])), "EPSG:4326")
    return "EPSG:4326 is geographic"


def _feet(site: Path) -> str:
    write_las(site / "tiles" / "bad.las", grid_points(), "EPSG:2264")
    return "EPSG:2264 is in US survey foot, not metres"


@pytest.mark.parametrize("damage", [_text, _truncated, _flipped, _no_crs, _geographic, _feet])
def test_bad_tiles(site: Path, damage) -> None:
    said = damage(site)
    _survey(site)
    _refused(site, _run(site), "bad.la", said)


def test_bad_csv(site: Path) -> None:
    (site / "control.csv").write_text(
        "point_id,easting,northing,height,sd_e,sd_n,sd_h\nT1,1,2,3,0.01,0.01,0.01\nT2,1,nan,3,0.01,0.01,0.01\n"
    )
    (site / "targets.csv").write_text("point_id,x,y,z\nT1,1,2,3\nT2,1,2,3\n")
    _survey(site, more='control = "control.csv"\ntargets = "targets.csv"')
    _refused(site, _run(site), "control.csv", "line 3", "northing")


def test_bad_outputs(site: Path) -> None:
    _survey(site)
    base = _run(site)[:3]
    _refused(site, [*base, site / "none" / "r.gpkg"], "its folder does not exist", "Create")
    _refused(site, [*base, site / "out"], "is a folder")
    if Path("/proc/self").is_dir():
        _refused(site, [*base, "/proc/self/r.gpkg"], "/proc/self/r.gpkg: cannot be written")
    (site / "out" / "other.gpkg").write_text("other")
    _refused(site, [*base, site / "out" / "other.gpkg"], "exists and is no result of tetratrack")
    _refused(site, [*_run(site), "--log-file", site / "none" / "log.txt"], "log.txt: cannot be written")


def test_a_single_step_does_not_empty_a_result(site: Path) -> None:
    result, given = site / "out" / "result.gpkg", site / "given.gpkg"
    write_synthetic(result, 6, 2)
    shutil.copy(result, given)
    (site / "check.csv").write_text("point_id,easting,northing,height,sd_e,sd_n,sd_h,unit_id,feature\n")
    survey, before = _survey(site), result.read_bytes()
    for step, layer in (
        (["register", survey], "units"),
        (["segment", survey], "feature_points"),
        (["fit", survey], "displacements"),
        (["features", given], "displacements"),
        (["validate", given, "--check", site / "check.csv"], "units"),
    ):
        _refused(site, [*step, "--output", result], f"holds a result whose layer {layer} (", "Choose another name for the output of a")
    assert result.read_bytes() == before


def test_a_single_step_replaces_what_it_wrote_before(site: Path) -> None:
    given, output = site / "given.gpkg", site / "out" / "features.gpkg"
    write_synthetic(given, 6, 2)
    for _ in range(2):
        result = CliRunner().invoke(app, ["features", str(given), "--output", str(output), "--quiet"])
        assert result.exit_code == 0, result.output


def test_no_dask_scheduler(site: Path) -> None:
    _survey(site)
    _refused(site, [*_run(site), "--scheduler", "tcp://127.0.0.1:9"], "no dask scheduler answers at tcp://127.0.0.1:9")


def test_features_of_something_else(site: Path) -> None:
    _refused(site, ["features", site / "tiles" / "good.laz", "--output", site / "out" / "f.gpkg"], "cannot be read as a GeoPackage")


def test_a_cloud_without_units_gives_an_empty_result(site: Path) -> None:
    _survey(site)
    result = CliRunner().invoke(app, _run(site))
    assert result.exit_code == 0, result.output
    path = site / "out" / "result.gpkg"
    assert read_layer_rows(path, "units") == []
    (epoch,) = read_layer_rows(path, "epochs")
    settings = json.loads(epoch["settings"])
    assert epoch["points"] == 400
    assert settings["inputs"][0]["name"] == "good.laz"
    assert len(settings["inputs"][0]["sha256"]) == 64
    assert [p.name for p in (site / "out").iterdir()] == ["result.gpkg"]


def test_template_and_help() -> None:
    result = CliRunner().invoke(app, ["template"])
    assert result.exit_code == 0
    assert "[survey]" in result.stdout
    for command in app.registered_commands:
        name = command.name or command.callback.__name__.replace("_", "-")
        shown = CliRunner().invoke(app, [name, "--help"])
        assert shown.exit_code == 0
        assert "Usage" in shown.stdout


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        (["--opening", "paper", "--radius", "0.5"], {"height": 2.3, "radius": 0.5, "opening": "paper"}),
        (["--leg-length", "1.6"], {"height": 2.3, "leg_length": 1.6, "opening": "tetrahedral"}),
        (["--instrument", "depth_camera", "--gradient", "0.2"], {"height": 0.105, "gradient": 0.2}),
    ],
)
def test_a_simulated_unit_of_the_usual_height_has_the_shape_that_is_told(
    site: Path, options: list[str], expected: dict[str, object]
) -> None:
    told = CliRunner().invoke(app, ["simulate", "-o", str(site / "made"), "--units", "3", "--epochs", "1", "--density", "20", *options])
    assert told.exit_code == 0, told.output
    (survey,) = site.rglob("survey.toml")
    unit = tomllib.loads(survey.read_text(encoding="utf-8"))["unit"]
    assert {key: unit[key] for key in expected} == expected


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["plan", "--density", "500", "--noise", "0.01", "--height", "2300"], "Is it in millimetres? Then write 2.3."),
        (["plan", "--density", "500", "--noise", "0.01", "--height", "2.3", "--coast", "-300"], "has no stations"),
        (["plan", "--density", "500", "--noise", "0.01", "--height", "2.3", "--coast", "nan"], "has no stations"),
        (["simulate", "-o", "SITE/made", "--bend", "0.03", "--wave-lengths", "0", "0"], "cannot be drawn"),
        (["simulate", "-o", "SITE/made", "--height", "2300"], "Is it in millimetres? Then write 2.3."),
        (["simulate", "-o", "SITE/made", "--radius", "608"], "Is it in millimetres? Then write 0.608."),
        (["init", "SITE", "--height", "2300"], "Is it in millimetres? Then write 2.3."),
        (["run", "SITE/tiles", "--height", "2300", "-o", "SITE/r.gpkg"], "Is it in millimetres? Then write 2.3."),
        (
            ["features", "SITE/r.gpkg", "--end-discs", "--leg-length", "1481", "-o", "SITE/f.gpkg"],
            "Is it in millimetres? Then write 1.481.",
        ),
        (["alarms", "SITE/r.gpkg", "--threshold", "100", "-o", "SITE/a.csv"], "Is it in millimetres? Then write 0.1."),
        (["simulate", "-o", "SITE/made", "--seed", "99999999999999999999999"], "Invalid value for '--seed'"),
        (["simulate", "-o", "SITE/made", "--seed", "-1"], "Invalid value for '--seed'"),
    ],
)
def test_options_have_the_bounds_of_the_survey_file(site: Path, arguments: list[str], words: str) -> None:
    before = sorted(site.rglob("*"))
    told = CliRunner().invoke(app, [text.replace("SITE", str(site)) for text in arguments])
    assert (told.exit_code, words in told.stderr) == (2, True), told.output
    assert sorted(site.rglob("*")) == before


def test_inspect(site: Path) -> None:
    index = site / "out" / "tiles.gpkg"
    result = CliRunner().invoke(app, ["inspect", str(site / "tiles" / "good.laz"), "--output", str(index), "--json-progress"])
    assert result.exit_code == 0, result.output
    events = [json.loads(line) for line in result.stdout.splitlines()]
    outputs = events[-1]["outputs"]
    assert events[-1]["event"] == "result"
    assert (outputs["tiles"], outputs["points"], outputs["crs"]) == (1, 400, "EPSG:32650")
    import geopandas

    tiles = geopandas.read_file(index, layer="tiles")
    assert tiles.points.tolist() == [400]
    assert tiles.crs.to_epsg() == 32650
    assert re.fullmatch(r"(\d{4}-\d\d-\d\d\??)?", tiles.measured[0])
    assert CliRunner().invoke(app, ["inspect", str(_survey(site))]).exit_code == 0


def test_errors_as_json(site: Path) -> None:
    _survey(site, "none.laz")
    result = CliRunner().invoke(app, [*_run(site), "--json-progress"])
    assert result.exit_code == 2
    (event,) = [json.loads(line) for line in result.stdout.splitlines()]
    assert event["event"] == "error"
    assert "none.laz" in event["message"]
    assert event["remedy"]


def test_quiet_and_log_file(site: Path) -> None:
    _survey(site)
    log = site / "log.txt"
    result = CliRunner().invoke(app, [*_run(site), "--quiet", "--log-file", str(log)])
    assert result.exit_code == 0
    assert result.stderr == ""
    assert len(result.stdout.splitlines()) == 1
    lines = log.read_text(encoding="utf-8").splitlines()
    assert any("result" in line for line in lines) or lines
    assert all(line[:2] == "20" for line in lines)


@pytest.mark.parametrize("kind", [signal.SIGINT, signal.SIGTERM])
def test_interrupt_leaves_nothing(repository: Path, tmp_path: Path, kind: signal.Signals) -> None:
    survey = repository / "tests" / "data" / "tiny" / "survey.toml"
    environment = os.environ | {"TMPDIR": str(tmp_path / "tmp")}
    (tmp_path / "tmp").mkdir()
    (tmp_path / "out").mkdir()
    command = [sys.executable, "-m", "tetratrack.scripts.cli", "run", str(survey), "-o", str(tmp_path / "out" / "r.gpkg"), "-j", "2"]
    # Ctrl-C reaches the run even where whoever started pytest ignores it, as a script in the background does for all its children
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment)
    finally:
        signal.signal(signal.SIGINT, before)
    # the folder of the jobs' results tells that the run is under way
    deadline = time.monotonic() + 60
    while not list((tmp_path / "tmp").glob(".tetratrack-*")) and process.poll() is None and time.monotonic() < deadline:
        time.sleep(0.02)
    process.send_signal(kind)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 130, errors
    assert "error: interrupted; nothing was written" in errors
    assert "Traceback" not in errors
    assert list((tmp_path / "out").iterdir()) == []
    assert [p.name for p in (tmp_path / "tmp").iterdir() if not p.name.endswith(".lock")] == []


def test_layers_of_the_interface_are_all_described() -> None:
    wanted = {
        "units",
        "gaps",
        "feature_points",
        "displacements",
        "displacements_other",
        "control_residuals",
        "check_residuals",
        "epochs",
        "reviews",
    }
    assert wanted <= set(LAYERS)
