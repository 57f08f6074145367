"""Steps that read an earlier result open it as everything else does: recovered, no views, no network, fields checked."""

from __future__ import annotations

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

import geopandas
import pytest
import shapely
from tetratrack.core.common.errors import CrsError, InputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.crs import check_same_crs, parse_crs
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.pipeline.epoch_plans import plan_survey
from tetratrack.core.pipeline.run_options import RunOptions
from tetratrack.core.pipeline.unit_input import check_places, crs_of_layer, read_given_units, read_units
from tetratrack.core.pipeline.whole_survey import run_fit
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.scripts.cli import app
from typer.testing import CliRunner

KILLED_WRITER = """
import os, signal, sqlite3, sys
c = sqlite3.connect(sys.argv[1], isolation_level=None)
c.execute("PRAGMA cache_size = 1")
c.execute("BEGIN IMMEDIATE")
c.execute("UPDATE units SET unit_id = 'half written'")
c.execute("UPDATE feature_points SET unit_id = 'half written'")
os.kill(os.getpid(), signal.SIGKILL)
"""


@pytest.fixture
def units(result: Path, tmp_path: Path) -> Path:
    """A copy of the result of the tiny survey."""
    return Path(shutil.copy(result, tmp_path / "units.gpkg"))


def _steps(units: Path, tiny: Path) -> list[list[str]]:
    check = str(next(tiny.glob("check_*.csv")))
    return [["features", str(units)], ["track", str(units)], ["validate", str(units), "--check", check, "--epoch", check[-14:-4]]]


def _told(arguments: list[str], output: Path) -> tuple[int, str]:
    told = CliRunner().invoke(app, [*arguments, "--output", str(output)])
    assert "Traceback" not in told.output
    return told.exit_code, told.stderr


@pytest.mark.skipif(os.name != "posix", reason="kills as POSIX has them")
@pytest.mark.parametrize("step", [0, 1, 2], ids=["features", "track", "validate"])
def test_what_a_killed_writer_left_is_recovered(units: Path, tiny: Path, tmp_path: Path, step: int) -> None:
    killed = subprocess.run([sys.executable, "-c", KILLED_WRITER, str(units)], check=False)
    assert killed.returncode == -signal.SIGKILL
    assert units.with_name("units.gpkg-journal").stat().st_size > 0
    code, words = _told(_steps(units, tiny)[step], tmp_path / "out.gpkg")
    assert code == 0, words
    assert "half written" not in {row["unit_id"] for row in read_layer_rows(tmp_path / "out.gpkg", "units")}


def _endless_view(path: Path) -> None:
    with closing(sqlite3.connect(path)) as connection, connection:
        for layer in ("units", "feature_points"):
            connection.execute(f"ALTER TABLE {layer} RENAME TO {layer}_2")
            endless = "WITH RECURSIVE r(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM r)"
            connection.execute(f"CREATE VIEW {layer} AS {endless} SELECT {layer}_2.* FROM {layer}_2, r")  # noqa: S608 - constants


def _description(path: Path) -> None:
    path.write_text(
        '<OGRVRTDataSource><OGRVRTLayer name="units"><SrcDataSource>/vsicurl/http://127.0.0.1:1/x.gpkg</SrcDataSource></OGRVRTLayer>'
        "</OGRVRTDataSource>"
    )


def _changed(*statements: str) -> Callable[[Path], None]:
    def change(path: Path) -> None:
        with closing(sqlite3.connect(path)) as connection, connection:
            for statement in statements:
                connection.execute(statement)

    return change


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (_endless_view, "is no plain table"),
        (_description, "cannot be read as a GeoPackage"),
        (_changed("DROP TABLE units", "DROP TABLE feature_points"), "has no layer"),
        (
            _changed("ALTER TABLE units RENAME COLUMN epoch TO day", "ALTER TABLE feature_points RENAME COLUMN epoch TO day"),
            "there is no field epoch",
        ),
        (_changed("UPDATE units SET geom = X'4750'", "UPDATE feature_points SET geom = X'4750'"), "a geometry is damaged"),
        (_changed("UPDATE units SET epoch = X'07'", "UPDATE feature_points SET epoch = X'07'"), "is not text"),
    ],
)
def test_a_changed_file_is_refused_by_every_step(
    units: Path, tiny: Path, tmp_path: Path, change: Callable[[Path], None], words: str
) -> None:
    change(units)
    for arguments in _steps(units, tiny):
        start = time.monotonic()
        code, said = _told(arguments, tmp_path / "out.gpkg")
        assert (code, words in said) == (2, True), said
        assert time.monotonic() - start < 30
        assert not (tmp_path / "out.gpkg").exists()


@pytest.mark.parametrize(
    ("statement", "words"),
    [
        ("UPDATE units SET qw = 0, qx = 0, qy = 0, qz = 0", "is no rotation"),
        ("UPDATE units SET qw = NULL", "is no rotation"),
        ("UPDATE units SET covariance = 'x'", "cannot be used"),
        ("UPDATE units SET height = -1", ""),
        ("UPDATE units SET epoch_time = 'yesterday'", "is not a time"),
    ],
)
def test_values_that_no_fit_has(units: Path, tiny: Path, tmp_path: Path, statement: str, words: str) -> None:
    _changed(statement)(units)
    for arguments in _steps(units, tiny)[:2]:
        code, said = _told(arguments, tmp_path / "out.gpkg")
        assert code in (0, 2), said
        assert words in said


@pytest.mark.parametrize(
    ("statement", "words"),
    [
        ("UPDATE units SET unit_type = 'cube'", "names the type of unit 'cube'"),
        ("UPDATE units SET height = height + 1", "holds units of height 3.3 m, the survey has 2.3 m"),
        ("UPDATE gpkg_geometry_columns SET srs_id = -1", "has no CRS"),
        ("UPDATE gpkg_spatial_ref_sys SET organization_coordsys_id = 32651 WHERE srs_id = 32650", "the survey in 'EPSG:32650'"),
        ("UPDATE epochs SET transformation = json_set(transformation, '$.translation_m[0]', 437000)", "units lies in the tiles of epoch"),
    ],
)
def test_units_that_are_not_the_surveys_are_refused(units: Path, tiny: Path, tmp_path: Path, statement: str, words: str) -> None:
    _changed(statement)(units)
    with pytest.raises(InputError, match=words):
        run_fit(read_survey(tiny / "survey.toml"), units, tmp_path / "out.gpkg", RunOptions(workers=1), Feedback())
    assert not (tmp_path / "out.gpkg").exists()


def test_types_of_units_are_told_by_name_and_height(units: Path, tiny: Path) -> None:
    survey = read_survey(tiny / "survey.toml")
    large = replace(survey.units[0], type=UnitType.tetrapod(2 * survey.unit.height))
    several = replace(survey, units=(large, *survey.units))
    assert {unit.kind for known in read_given_units(units, several).values() for unit in known} == {1}
    for statement in (
        "UPDATE units SET unit_type = 'Tetrapod'",
        "UPDATE units SET unit_type = 'tetrapod 8 t'",
        "UPDATE units SET unit_type = NULL",
    ):
        _changed(statement)(units)
        assert {unit.kind for known in read_given_units(units, several).values() for unit in known} == {1}
    _changed("UPDATE units SET height = NULL")(units)
    with pytest.raises(InputError, match="neither type nor height"):
        read_given_units(units, several)
    assert {unit.kind for known in read_given_units(units, survey).values() for unit in known} == {0}


def test_single_units_beside_the_tiles_are_named(units: Path, tiny: Path) -> None:
    survey, said = read_survey(tiny / "survey.toml"), []
    given = read_given_units(units, survey)
    label = survey.epochs[0].label
    first = given[label][0]
    given[label][0] = first._replace(pose=(first.pose[0] + 1000.0, *first.pose[1:]))
    check_places(given, survey, plan_survey(survey), units, Feedback(warning=said.append))
    assert said == [f"{label}: 1 of {len(given[label])} units of units.gpkg lie outside the tiles and are left out"]


@pytest.mark.parametrize(
    ("check", "picks", "words"),
    [
        ("P1,0,0,0,0,0,0,0.01", None, "matches no feature point"),
        (None, "no table", "line 2"),
        (None, "P1,2001-01-01,0,0,0", "It holds points of: 2001-01-01"),
    ],
)
def test_nothing_is_written_before_all_is_checked(
    units: Path, tiny: Path, tmp_path: Path, check: str | None, picks: str | None, words: str
) -> None:
    surveyed = next(tiny.glob("check_*.csv"))
    arguments = ["validate", str(units), "--epoch", surveyed.stem[-10:], "--check", str(surveyed)]
    if check is not None:
        arguments[-1] = str(tmp_path / "check.csv")
        header = surveyed.read_text(encoding="utf-8").splitlines()[0]
        (tmp_path / "check.csv").write_text(f"{header}\n{check}\n", encoding="utf-8")
    if picks is not None:
        (tmp_path / "picks.csv").write_text(f"point_id,epoch,easting,northing,height\n{picks}\n", encoding="utf-8")
        arguments += ["--picks", str(tmp_path / "picks.csv")]
    code, said = _told(arguments, tmp_path / "out.gpkg")
    assert (code, words in said) == (2, True), said
    assert not (tmp_path / "out.gpkg").exists()


def test_legs_that_no_unit_has_are_not_the_layers_fault(units: Path, tmp_path: Path) -> None:
    code, said = _told(["features", str(units), "--end-discs", "--leg-length", "4.5"], tmp_path / "out.gpkg")
    assert (code, "error: --leg-length: " in said) == (2, True), said
    assert not (tmp_path / "out.gpkg").exists()


def test_a_registration_in_another_crs_is_refused(units: Path, tmp_path: Path) -> None:
    other = Path(shutil.copy(units, tmp_path / "other.gpkg"))
    _changed("UPDATE gpkg_spatial_ref_sys SET organization_coordsys_id = 32651 WHERE srs_id = 32650")(other)
    code, words = _told(["track", str(units), "--registration", str(other)], tmp_path / "out.gpkg")
    assert (code, "other.gpkg: is in 'EPSG:32651', units.gpkg in 'EPSG:32650'" in words) == (2, True), words


def test_a_layer_of_another_program_will_do(tmp_path: Path) -> None:
    """With nothing but epochs and rotations; heights of their own in its CRS."""
    frame = geopandas.GeoDataFrame(
        {"epoch": ["a", "a"], "qx": [0.0, 0.0], "qy": [0.0, 0.0], "qz": [0.0, 0.0], "qw": [1.0, 1.0]},
        geometry=[shapely.Point(500000, 4000000, 3), shapely.Point(500005, 4000000, 3)],
        crs="EPSG:32650+5773",
    )
    frame.to_file(tmp_path / "u.gpkg", layer="units", driver="GPKG")
    rows = read_units(tmp_path / "u.gpkg")
    assert [row["geometry"].tolist() for row in rows] == [[500000, 4000000, 3], [500005, 4000000, 3]]
    assert [row["epoch"] for row in rows] == ["a", "a"]
    assert "EGM96" in crs_of_layer(tmp_path / "u.gpkg")
    for crs in ("EPSG:32650", "EPSG:32650+5773", parse_crs("EPSG:32650").to_3d().to_wkt()):
        check_same_crs(crs_of_layer(tmp_path / "u.gpkg"), crs, source="u.gpkg", whose="the survey")
    with pytest.raises(CrsError, match="the survey in"):
        check_same_crs(crs_of_layer(tmp_path / "u.gpkg"), "EPSG:32650+3855", source="u.gpkg", whose="the survey")
