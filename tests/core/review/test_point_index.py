"""The index of points beside a result belongs to what the result is now."""

from __future__ import annotations

import json
import os
import sqlite3
import time
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from synthetic_result import make_units, write_points, write_result
from tetratrack.core.common.errors import InputError
from tetratrack.core.results.geopackage_reader import epoch_pairs
from tetratrack.core.review.decisions import decide
from tetratrack.core.review.point_index import frames_state, index_folder, index_of, write_index
from tetratrack.scripts.cli import app
from typer.testing import CliRunner

EARLIER = "was built for an earlier state of the result"


@pytest.fixture
def result(tmp_path: Path) -> Path:
    path = tmp_path / "result.gpkg"
    units = make_units(6, 2, seed=4)
    write_result(path, epochs=2, units=units)
    write_points(path, units, epochs=2, per_unit=300)
    return path


def _change(path: Path, statement: str, *values: object) -> None:
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute(statement, values)


def _state_the_index(path: Path) -> None:
    description = index_folder(path) / "index.json"
    content = json.loads(description.read_text(encoding="utf-8"))
    description.write_text(json.dumps(content | {"state": frames_state(path)}), encoding="utf-8")


@pytest.mark.parametrize(
    ("statement", "value"),
    [
        ("UPDATE epochs SET transformation = ? WHERE label = '2024-04-09'", '{"shift": [0.05, 0, 0]}'),
        ("UPDATE epochs SET settings = ? WHERE label = '2024-04-09'", '{"source_offsets_m": {"1": [0.01, 0, 0]}}'),
        ("UPDATE epochs SET settings = ? WHERE label = '2024-04-09'", '{"inputs": [{"name": "tile_1", "sha256": "ab"}]}'),
        ("INSERT INTO frame_errors (epoch, along, de) VALUES ('2024-04-09', 0.0, ?)", 0.03),
    ],
    ids=["control", "strips", "tiles", "bend"],
)
def test_an_index_of_an_earlier_state_is_refused(result: Path, statement: str, value: object) -> None:
    _state_the_index(result)
    assert index_of(result).epochs == ("2023-04-09", "2024-04-09")
    _change(result, statement, value)
    with pytest.raises(InputError, match=f"{EARLIER}. Build it again with tetratrack unit-points"):
        index_of(result)


def test_decisions_leave_an_index_as_it_is(result: Path) -> None:
    _state_the_index(result)
    decide(result, ["U00001"], epoch_pairs(result)[0], "accepted", comment="", reviewer="me")
    assert index_of(result).epochs


def test_an_index_without_a_state_counts_where_the_result_is_no_newer(result: Path) -> None:
    assert index_of(result).state == ""
    description = index_folder(result) / "index.json"
    past = time.time() - 3600
    os.utime(description, (past, past))
    with pytest.raises(InputError, match=EARLIER):
        index_of(result)
    _change(result, "UPDATE gpkg_contents SET last_change = '2020-01-01T00:00:00.000Z' WHERE table_name = 'epochs'")
    assert index_of(result).epochs


def test_points_of_an_earlier_state_are_in_no_output(result: Path) -> None:
    _state_the_index(result)
    _change(result, "UPDATE epochs SET transformation = '{}' WHERE label = '2024-04-09'")
    for step, name in (("residuals", "o.laz"), ("profiles", "o.gpkg")):
        refused = CliRunner().invoke(app, [step, str(result), "-o", str(result.with_name(name))])
        assert refused.exit_code == 2, refused.output
        assert EARLIER in refused.stderr
    report = CliRunner().invoke(app, ["report", str(result), "-o", str(result.with_name("o.html"))])
    assert report.exit_code == 0, report.output
    assert f"units are drawn without points: {index_folder(result)}: {EARLIER}" in report.stderr


def test_a_written_index_states_what_it_was_told(tmp_path: Path) -> None:
    place = np.array([[100.0, 200.0, 3.0]])
    write_index(tmp_path / "r.points", [("a", "1", place)], place, 2.0, state="abc")
    assert json.loads((tmp_path / "r.points" / "index.json").read_text(encoding="utf-8"))["state"] == "abc"
