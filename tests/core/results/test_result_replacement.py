"""Replacing a result: nothing of users is lost, nobody's decision either, and what cannot stay is said before the work."""

from __future__ import annotations

import sqlite3
import threading
from contextlib import closing
from pathlib import Path

import pytest
from las_files import grid_points, write_las
from tetratrack.core.common.errors import OutputError, TetratrackError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.pipeline.inspection import run_inspect
from tetratrack.core.results import result_replacement
from tetratrack.core.results.comparison_layers import SECTION_LAYERS
from tetratrack.core.results.geopackage_reader import EpochPair, ResultCrs, read_layer_rows
from tetratrack.core.results.geopackage_writer import check_output, write_beside, write_geopackage, write_result
from tetratrack.core.review.decisions import decide, read_history

PAIR = EpochPair("a", "b")
TIME = "2025-03-14T02:30:00+00:00"


def _tables(status: str = "found") -> dict:
    places = [(500_000.0 + k, 3_500_000.0, 2.0) for k in range(5)]
    units = [
        {"unit_id": f"U{k}", "epoch": "a", "epoch_time": TIME, "status": status, "qw": None, "geometry": place}
        for k, place in enumerate(places)
    ]
    return {"units": units, "epochs": [{"label": "a", "time": TIME}]}


@pytest.fixture
def result(tmp_path: Path) -> Path:
    path = tmp_path / "result.gpkg"
    write_result(path, "EPSG:32650", _tables())
    return path


def _change(path: Path, script: str) -> None:
    with closing(sqlite3.connect(path, isolation_level=None)) as connection:
        connection.executescript(script)


def _rows(path: Path, statement: str) -> list[tuple]:
    with closing(sqlite3.connect(path)) as connection:
        return connection.execute(statement).fetchall()


def test_what_users_added_survives(result: Path) -> None:
    _change(
        result,
        """
        CREATE TABLE "it's my ""own"" layer" (fid INTEGER PRIMARY KEY, text TEXT);
        INSERT INTO "it's my ""own"" layer" (text) VALUES ('kept');
        CREATE TABLE log (unit_id TEXT);
        CREATE TRIGGER watch_units AFTER UPDATE ON units BEGIN INSERT INTO log VALUES (new.unit_id); END;
        CREATE INDEX by_status ON units (status);
        CREATE VIEW found AS SELECT unit_id FROM units WHERE status = 'uncertain';
        CREATE VIRTUAL TABLE words USING fts5(text);
        INSERT INTO words VALUES ('searchable');
        INSERT INTO gpkg_spatial_ref_sys VALUES ('site', 100000, 'NONE', 100000, 'LOCAL_CS["site grid"]', '');
        INSERT INTO layer_styles (f_table_name, f_geometry_column, styleName, styleQML, useAsDefault, description, owner)
          VALUES ('units', 'geom', 'mine', '<qgis mine=""/>', 1, 'mine', 'me');
        UPDATE layer_styles SET useAsDefault = 0 WHERE styleName = 'units';
        UPDATE layer_styles SET styleQML = '<qgis changed=""/>' WHERE styleName = 'gaps';
        """,
    )
    check_output(result)
    write_result(result, "LOCAL", _tables("uncertain"))
    assert _rows(result, """SELECT text FROM "it's my ""own"" layer" LIMIT 2""") == [("kept",)]
    assert _rows(result, "SELECT count(*) FROM found") == [(5,)]
    assert _rows(result, "SELECT text FROM words WHERE words MATCH 'searchable'") == [("searchable",)]
    assert _rows(result, "SELECT definition FROM gpkg_spatial_ref_sys WHERE srs_id = 100000") == [('LOCAL_CS["site grid"]',)]
    assert _rows(result, "SELECT styleName FROM layer_styles WHERE f_table_name = 'units' AND useAsDefault") == [("mine",)]
    assert _rows(result, "SELECT styleQML FROM layer_styles WHERE styleName = 'gaps'") == [('<qgis changed=""/>',)]
    assert _rows(result, "SELECT count(*) FROM layer_styles WHERE f_table_name = 'units'") == [(2,)]
    assert _rows(result, "SELECT name FROM sqlite_master WHERE name = 'by_status'") == [("by_status",)]
    _change(result, "UPDATE units SET status = 'found' WHERE unit_id = 'U3'")
    assert _rows(result, "SELECT unit_id FROM log") == [("U3",)]
    assert _rows(result, "PRAGMA integrity_check") == [("ok",)]


def test_an_own_reference_system_takes_a_free_number(result: Path) -> None:
    _change(result, """INSERT INTO gpkg_spatial_ref_sys VALUES ('site', 100000, 'NONE', 100000, 'LOCAL_CS["site grid"]', '')""")
    write_geopackage(result, "EPSG:32650+5773", _tables())
    (number,) = _rows(result, "SELECT srs_id FROM gpkg_geometry_columns WHERE table_name = 'units'")[0]
    assert number == 100001
    assert len(_rows(result, "SELECT 1 FROM gpkg_spatial_ref_sys WHERE srs_id IN (100000, 100001)")) == 2


def test_a_spatial_index_made_by_gdal_follows(result: Path) -> None:
    import geopandas
    import pyogrio

    frame = geopandas.read_file(result, layer="units")
    pyogrio.write_dataframe(frame, result.with_name("other.gpkg"), layer="units")
    indexed = _rows(result.with_name("other.gpkg"), "SELECT sql FROM sqlite_master WHERE name = 'rtree_units_geom'")[0][0]
    _change(result, indexed)
    _change(
        result,
        "INSERT INTO rtree_units_geom VALUES (77, 0, 1, 0, 1);"
        "CREATE TRIGGER rtree_units_geom_insert AFTER INSERT ON units WHEN (new.geom NOT NULL AND NOT ST_IsEmpty(new.geom)) BEGIN "
        "INSERT OR REPLACE INTO rtree_units_geom VALUES (new.fid, ST_MinX(new.geom), ST_MaxX(new.geom), ST_MinY(new.geom), "
        "ST_MaxY(new.geom)); END; CREATE TABLE gpkg_ogr_contents (table_name TEXT PRIMARY KEY, feature_count INTEGER); "
        "INSERT INTO gpkg_ogr_contents VALUES ('units', 99)",
    )
    write_geopackage(result, "EPSG:32650", _tables())
    assert [row[0] for row in _rows(result, "SELECT id FROM rtree_units_geom ORDER BY id")] == [1, 2, 3, 4, 5]
    assert _rows(result, "SELECT feature_count FROM gpkg_ogr_contents") == [(5,)]


@pytest.mark.parametrize(
    ("script", "told"),
    [
        ("ALTER TABLE units ADD COLUMN remark TEXT", "layer units: holds a field remark that a user added"),
        (
            "CREATE TABLE mine (fid INTEGER PRIMARY KEY); INSERT INTO gpkg_contents (table_name, data_type, identifier) VALUES "
            "('mine', 'attributes', 'x'); UPDATE gpkg_contents SET identifier = 'old' WHERE table_name = 'units'; "
            "UPDATE gpkg_contents SET identifier = 'units' WHERE table_name = 'mine'",
            "holds what a new run would lose or break",
        ),
    ],
)
def test_what_cannot_stay_is_refused_before_the_work(result: Path, script: str, told: str) -> None:
    _change(result, script)
    before = result.read_bytes()
    with pytest.raises(OutputError, match=told):
        check_output(result)
    assert result.read_bytes() == before
    assert [path.name for path in result.parent.iterdir()] == ["result.gpkg"]


@pytest.mark.parametrize("mode", ["WAL", "DELETE"])
def test_a_locked_result_is_refused_before_the_work_and_kept_beside_after_it(
    result: Path, mode: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tetratrack.core.results.result_replacement.BUSY_SECONDS", 0.5)
    with closing(sqlite3.connect(result, isolation_level=None)) as other:
        other.execute(f"PRAGMA journal_mode = {mode}")
        other.execute("BEGIN IMMEDIATE")
        other.execute("UPDATE units SET status = 'lost'")
        with pytest.raises(OutputError, match="locked by another program"):
            check_output(result)
        with pytest.raises(OutputError, match=r"kept as result\.new\.gpkg"):
            write_geopackage(result, "EPSG:32650", _tables("uncertain"))
        other.execute("ROLLBACK")
    assert {row["status"] for row in read_layer_rows(result.with_name("result.new.gpkg"), "units")} == {"uncertain"}
    assert {row["status"] for row in read_layer_rows(result, "units")} == {"found"}


def test_no_acknowledged_decision_is_lost_while_results_replace_each_other(result: Path) -> None:
    acknowledged: list[int] = []
    stop = threading.Event()
    troubles: list[TetratrackError] = []

    def review() -> None:
        while not stop.is_set():
            try:
                acknowledged.extend(decide(result, ["U1"], PAIR, "accepted", comment=str(len(acknowledged)), reviewer="me"))
            except TetratrackError as error:
                troubles.append(error)

    reviewer = threading.Thread(target=review)
    reviewer.start()
    try:
        for number in range(6):
            write_geopackage(result, "EPSG:32650", _tables("found" if number % 2 else "uncertain"))
    finally:
        stop.set()
        reviewer.join()
    assert not troubles
    assert len(acknowledged) > 6
    assert [event.number for event in read_history(result)] == acknowledged


def _write_sections(path: Path, count: int) -> None:
    rows = [{"section": k, "along": float(k), "kind": "design", "geometry": [[k, 0.0, 0.0], [k, 1.0, 0.0]]} for k in range(count)]
    write_beside(path, ResultCrs("", None, "undefined"), {layer.name: layer for layer in SECTION_LAYERS}, {"sections": rows})


@pytest.mark.parametrize("kind", ["comparison", "tiles"])
@pytest.mark.parametrize("mode", ["wal", "delete"])
def test_a_file_that_another_program_has_open_is_no_ruin_when_written_anew(tmp_path: Path, kind: str, mode: str) -> None:
    """Its write-ahead log was applied to the new file of its name, which then was malformed for all."""
    path = tmp_path / "beside.gpkg"
    if kind == "tiles":
        pytest.importorskip("geopandas")
        tile = write_las(tmp_path / "tile.las", grid_points())
        run_inspect([tile], path, Feedback())
        layer, again, expected = "tiles", (lambda: run_inspect([tile], path, Feedback())), 1
    else:
        _write_sections(path, 3)
        layer, again, expected = "sections", (lambda: _write_sections(path, 400)), 400
    with closing(sqlite3.connect(path, isolation_level=None)) as other, closing(sqlite3.connect(path, isolation_level=None)) as third:
        other.execute(f"PRAGMA journal_mode = {mode}")
        other.execute("UPDATE gpkg_contents SET description = 'saved in another program'")
        if mode == "wal":
            third.execute("BEGIN")
            third.execute("SELECT * FROM gpkg_contents").fetchall()
        again()
        assert _rows(path, "PRAGMA integrity_check") == [("ok",)]
        assert _rows(path, f"SELECT count(*) FROM {layer}") == [(expected,)]  # noqa: S608
    assert _rows(path, "PRAGMA integrity_check") == [("ok",)]
    assert _rows(path, f"SELECT count(*) FROM {layer}") == [(expected,)]  # noqa: S608
    assert [file.name for file in tmp_path.glob("*beside*")] == ["beside.gpkg"]


def test_a_file_that_another_program_keeps_locked_stays_as_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "beside.gpkg"
    _write_sections(path, 3)
    monkeypatch.setattr(result_replacement, "BUSY_SECONDS", 0.1)
    monkeypatch.setattr("tetratrack.core.results.result_access.BUSY_SECONDS", 0.1)
    with closing(sqlite3.connect(path, isolation_level=None)) as other:
        other.execute("BEGIN")
        other.execute("SELECT count(*) FROM sections").fetchall()
        with pytest.raises(OutputError, match="locked"):
            _write_sections(path, 400)
    assert _rows(path, "SELECT count(*) FROM sections") == [(3,)]


def test_a_file_that_was_written_late_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "beside.gpkg"
    _write_sections(path, 3)
    monkeypatch.setattr(result_replacement, "BUSY_SECONDS", 0.0)
    _write_sections(path, 400)
    assert _rows(path, "SELECT count(*) FROM sections") == [(400,)]


def test_what_was_left_of_a_file_that_is_gone_is_not_taken_for_the_new_ones(tmp_path: Path) -> None:
    path = tmp_path / "beside.gpkg"
    _write_sections(path, 3)
    with closing(sqlite3.connect(path, isolation_level=None)) as other:
        other.execute("PRAGMA journal_mode = wal")
        other.execute("UPDATE gpkg_contents SET description = 'saved in another program'")
        log = path.with_name("beside.gpkg-wal").read_bytes()
    path.unlink()
    path.with_name("beside.gpkg-wal").write_bytes(log)
    _write_sections(path, 400)
    assert _rows(path, "PRAGMA integrity_check") == [("ok",)]
    assert _rows(path, "SELECT count(*) FROM sections") == [(400,)]
