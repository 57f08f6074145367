"""Opening a result that a killed writer left, that lies in a folder to be read only, or that a stranger made."""

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
from pathlib import Path

import pytest
import synthetic_result
from tetratrack.core.common.errors import InputError
from tetratrack.core.common.sqlite_files import recover
from tetratrack.core.report.alarms import write_alarms
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.core.results.geopackage_writer import check_output, write_geopackage
from tetratrack.core.results.result_access import connect, reading

KILLED_WRITER = """
import os, signal, sqlite3, sys
c = sqlite3.connect(sys.argv[1], isolation_level=None)
c.execute("PRAGMA cache_size = 1")
c.execute("BEGIN IMMEDIATE")
c.execute("UPDATE units SET status = 'half written'")
c.execute("UPDATE feature_points SET feature = 'half written'")
os.kill(os.getpid(), signal.SIGKILL)
"""


@pytest.fixture
def result(tmp_path: Path) -> Path:
    path = tmp_path / "result.gpkg"
    synthetic_result.write_result(path, count=40, epochs=2)
    return path


def _leave_hot_journal(path: Path) -> None:
    """What SIGKILL in the middle of a write leaves: a database with pages of the transaction, and the journal that takes them back."""
    subprocess.run([sys.executable, "-c", KILLED_WRITER, str(path)], check=False)
    assert path.with_name(path.name + "-journal").stat().st_size > 0


def test_a_hot_journal_is_rolled_back_on_reading(result: Path, tmp_path: Path) -> None:
    expected = [(row["unit_id"], row["status"]) for row in read_layer_rows(result, "units")]
    _leave_hot_journal(result)
    with closing(sqlite3.connect(f"{result.as_uri()}?mode=ro", uri=True)) as readonly, pytest.raises(sqlite3.OperationalError):
        readonly.execute("SELECT count(*) FROM units").fetchone()
    assert write_alarms(result, tmp_path / "alarms.csv", 0.0) > 0
    assert [(row["unit_id"], row["status"]) for row in read_layer_rows(result, "units")] == expected
    assert not result.with_name("result.gpkg-journal").exists()


def test_a_hot_journal_is_rolled_back_before_gdal_reads_or_a_run_replaces(result: Path) -> None:
    _leave_hot_journal(result)
    recover(result)
    assert "half written" not in {row["status"] for row in read_layer_rows(result, "units")}
    _leave_hot_journal(result)
    check_output(result)
    assert not result.with_name("result.gpkg-journal").exists()


def test_a_journal_of_a_result_that_is_gone_does_not_spoil_the_new_one(result: Path) -> None:
    _leave_hot_journal(result)
    result.unlink()
    write_geopackage(result, "EPSG:32650", {"units": [{"unit_id": "U1", "epoch": "a", "status": "found"}]})
    with closing(sqlite3.connect(result)) as connection:
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
        assert connection.execute("SELECT unit_id FROM units").fetchall() == [("U1",)]


@pytest.mark.skipif(os.name != "posix" or not shutil.which("setpriv"), reason="permissions as POSIX has them")
def test_write_ahead_mode_in_a_folder_to_be_read_only(result: Path, tmp_path: Path) -> None:
    with closing(sqlite3.connect(result)) as connection:
        connection.execute("PRAGMA journal_mode = WAL")
        connection.execute("UPDATE units SET status = 'found'")
        connection.commit()
    result.chmod(0o444)
    tmp_path.chmod(0o555)
    for parent in tmp_path.parents[:3]:
        parent.chmod(parent.stat().st_mode | 0o011)
    program = "import sys; from pathlib import Path; from tetratrack.core.results.geopackage_reader import read_layer_rows as r; "
    program += "print(len(r(Path(sys.argv[1]), 'units')))"
    command = [sys.executable, "-c", program, str(result)]
    if os.geteuid() == 0:
        command = ["setpriv", "--bounding-set", "-all", "--inh-caps", "-all", *command]
    try:
        found = subprocess.run(command, capture_output=True, text=True, check=False)
    finally:
        tmp_path.chmod(0o755)
    assert found.stdout.strip() == str(len(read_layer_rows(result, "units"))), found.stderr


def _view(connection: sqlite3.Connection) -> None:
    connection.execute("ALTER TABLE units RENAME TO hidden")
    connection.execute(
        "CREATE VIEW units AS WITH RECURSIVE r(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM r) SELECT hidden.* FROM hidden, r"
    )


def _full_text_table(connection: sqlite3.Connection) -> None:
    connection.execute("DROP TABLE reviews")
    connection.execute("CREATE VIRTUAL TABLE reviews USING fts5(unit_id, epoch_from, epoch_to, decision, comment, reviewer, reviewed_at)")


def _view_on_decisions(connection: sqlite3.Connection) -> None:
    connection.execute("CREATE VIEW review_log AS SELECT 1 AS number")


@pytest.mark.parametrize("change", [_view, _full_text_table, _view_on_decisions])
def test_layers_must_be_plain_tables(result: Path, change: Callable[[sqlite3.Connection], None]) -> None:
    with closing(sqlite3.connect(result)) as connection, connection:
        change(connection)
    with pytest.raises(InputError, match="is no plain table"):
        connect(result)


@pytest.mark.parametrize(
    ("statement", "told"),
    [
        ("UPDATE units SET height = 'high' WHERE fid = 2", "layer units, row 2, field height: 'high' is not a number"),
        ("UPDATE units SET unit_id = x'11' WHERE fid = 2", "layer units, row 2, field unit_id: b'.x11' is not text"),
        ("UPDATE units SET unit_id = NULL WHERE fid = 2", "layer units, row 2, field unit_id: is empty"),
        ("UPDATE units SET epoch_time = 'soon' WHERE fid = 2", "layer units, row 2, field epoch_time: 'soon' is not a time"),
        ("UPDATE units SET coverage = 9e999 WHERE fid = 2", "layer units, row 2, field coverage: inf is not a number"),
        ("UPDATE units SET sd_e = 1e300 WHERE fid = 2", r"layer units, row 2, field sd_e: 1e\+300 is not a number"),
        ("UPDATE units SET geom = x'4750' WHERE fid = 2", "layer units, row 2: a geometry is damaged"),
        ("UPDATE units SET geom = 'here' WHERE fid = 2", "layer units, row 2: a geometry is not in GeoPackage binary form"),
        ("UPDATE units SET status = CAST(x'c328' AS TEXT) WHERE fid = 2", "cannot be read .*Could not decode to UTF-8"),
        ("ALTER TABLE units DROP COLUMN coverage", "layer units: there is no field coverage"),
    ],
)
def test_values_that_their_fields_cannot_hold(result: Path, statement: str, told: str) -> None:
    with closing(sqlite3.connect(result)) as connection, connection:
        connection.execute(statement)
    with pytest.raises(InputError, match=told):
        read_layer_rows(result, "units")


def test_bytes_flipped_anywhere_are_read_or_refused(result: Path, tmp_path: Path) -> None:
    import random

    good = result.read_bytes()
    rng = random.Random(3)
    refused: list[str] = []
    for number in range(60):
        data = bytearray(good)
        for _ in range(rng.choice((1, 8, 200))):
            data[rng.randrange(len(data) if number % 2 else 8192)] ^= 1 << rng.randrange(8)
        path = tmp_path / f"flipped{number}.gpkg"
        path.write_bytes(data)
        try:
            for layer in ("units", "feature_points", "displacements", "epochs", "reviews"):
                read_layer_rows(path, layer)
        except InputError as error:
            refused.append(str(error))
    assert len(refused) > 10
    assert not [message for message in refused if "\n" in message]


def test_reading_heeds_signals_and_ends(result: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    endless = "WITH RECURSIVE r(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM r) SELECT count(*) FROM r"
    monkeypatch.setattr("tetratrack.core.results.result_access.READING_SECONDS", 1.0)
    with pytest.raises(InputError, match="takes longer than 1 s"), reading(result) as connection:
        connection.execute(endless)
    monkeypatch.setattr("tetratrack.core.results.result_access.READING_SECONDS", 60.0)
    start = time.monotonic()
    signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.setitimer(signal.ITIMER_REAL, 0.5)
    with pytest.raises(KeyboardInterrupt), reading(result) as connection:
        connection.execute(endless)
    assert time.monotonic() - start < 20
