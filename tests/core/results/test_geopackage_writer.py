"""result.gpkg: layout, whole or not at all, what is kept, and that GeoPandas reads it."""

from __future__ import annotations

import os
import sqlite3
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
from tetratrack.core.common.errors import OutputError
from tetratrack.core.data.crs import parse_crs
from tetratrack.core.results import geopackage_writer as geopackage
from tetratrack.core.results.geopackage_reader import crs_of, read_layer_rows
from tetratrack.core.results.geopackage_writer import check_output, from_upper_triangle, upper_triangle, write_beside, write_geopackage
from tetratrack.core.results.schema import LAYERS, markdown

SITE_GRID = (
    'DERIVEDPROJCRS["site",BASEPROJCRS["WGS 84 / UTM zone 50N",BASEGEOGCRS["WGS 84",DATUM["World Geodetic System 1984",'
    'ELLIPSOID["WGS 84",6378137,298.257223563]]],CONVERSION["UTM zone 50N",METHOD["Transverse Mercator"],'
    'PARAMETER["Latitude of natural origin",0,ANGLEUNIT["degree",0.0174532925199433]],'
    'PARAMETER["Longitude of natural origin",117,ANGLEUNIT["degree",0.0174532925199433]],'
    'PARAMETER["Scale factor at natural origin",0.9996],PARAMETER["False easting",500000,LENGTHUNIT["metre",1]],'
    'PARAMETER["False northing",0,LENGTHUNIT["metre",1]]]],DERIVINGCONVERSION["shift",METHOD["Affine parametric transformation"],'
    'PARAMETER["A0",-400000,LENGTHUNIT["metre",1]],PARAMETER["A1",1,SCALEUNIT["coefficient",1]],'
    'PARAMETER["A2",0,SCALEUNIT["coefficient",1]],PARAMETER["B0",-3000000,LENGTHUNIT["metre",1]],'
    'PARAMETER["B1",0,SCALEUNIT["coefficient",1]],PARAMETER["B2",1,SCALEUNIT["coefficient",1]]],CS[Cartesian,2],'
    'AXIS["easting",east,LENGTHUNIT["metre",1]],AXIS["northing",north,LENGTHUNIT["metre",1]]]'
)
"""A grid of the site's own, laid on UTM."""
TIME = datetime(2025, 3, 14, 2, 30, tzinfo=UTC)
PLACE = np.array([500_000.25, 3_500_000.5, 2.125])


def _rows(status: str = "found") -> dict:
    return {
        "units": [
            {
                "unit_id": "U1",
                "epoch": "a",
                "epoch_time": TIME,
                "n_points": np.int64(7),
                "sd_e": np.nan,
                "status": status,
                "geometry": PLACE,
            },
            {"unit_id": "U2", "epoch": "a", "epoch_time": TIME, "status": "lost"},
        ],
        "displacements": [{"unit_id": "U1", "significant": np.True_, "de": 0.1, "geometry": [PLACE, PLACE + 1]}],
        "epochs": [{"label": "a", "time": TIME, "points": 3}],
    }


@pytest.fixture
def result(tmp_path: Path) -> Path:
    path = tmp_path / "result.gpkg"
    write_geopackage(path, "EPSG:32650", _rows(), styles={"units": "<qgis/>", "epochs": "<qgis/>"})
    return path


def test_every_layer_is_there_with_its_fields(result: Path) -> None:
    with closing(sqlite3.connect(result)) as connection:
        for name, layer in LAYERS.items():
            columns = [row[1] for row in connection.execute("SELECT * FROM pragma_table_info(?)", (name,))]
            assert columns == ["fid", *(["geom"] if layer.geometry != "none" else []), *layer.names]
        contents = dict(connection.execute("SELECT table_name, data_type FROM gpkg_contents").fetchall())
        assert contents.pop("layer_styles") == "attributes"
        assert contents == {n: "attributes" if layer.geometry == "none" else "features" for n, layer in LAYERS.items()}
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
        assert connection.execute("PRAGMA foreign_key_check").fetchall() == []
        assert connection.execute("SELECT f_table_name, f_geometry_column, useAsDefault FROM layer_styles").fetchall() == [
            ("units", "geom", 1),
            ("epochs", "", 1),
        ]


def test_rows_come_back(result: Path) -> None:
    first, second = read_layer_rows(result, "units")
    assert np.array_equal(first["geom"], PLACE)
    assert (first["n_points"], first["sd_e"], first["epoch_time"]) == (7, None, "2025-03-14T02:30:00.000Z")
    assert second["geom"] is None
    (line,) = read_layer_rows(result, "displacements")
    assert np.array_equal(line["geom"], [PLACE, PLACE + 1])
    assert line["significant"] == 1


@pytest.mark.parametrize("crs", ["EPSG:32650", "EPSG:32650+5773", "LOCAL"])
def test_geopandas_reads_it(tmp_path: Path, crs: str) -> None:
    import geopandas
    import pyogrio

    path = tmp_path / "r.gpkg"
    write_geopackage(path, crs, _rows())
    kinds = dict(pyogrio.list_layers(path).tolist())
    for name, layer in LAYERS.items():
        assert kinds[name] == (None if layer.geometry == "none" else f"{layer.geometry.removesuffix('Z')} Z")
    units = geopandas.read_file(path, layer="units")
    assert units.geometry[0].z == PLACE[2]
    assert units.geometry[1] is None
    assert str(units.epoch_time.dtype).endswith("UTC]")
    assert units.epoch_time[0] == TIME
    if crs != "LOCAL":
        flat = units.crs.sub_crs_list[0] if units.crs.is_compound else units.crs
        assert units.crs.is_compound == ("+" in crs)
        assert flat.to_epsg() == 32650
    assert geopandas.read_file(path, layer="displacements").significant.dtype == bool


@pytest.mark.parametrize("text", ["EPSG:6250", "EPSG:9895", SITE_GRID], ids=["code", "heights", "derived"])
def test_a_crs_that_wkt_of_the_first_version_cannot_say(tmp_path: Path, text: str) -> None:
    import geopandas
    from pyproj import CRS

    path = tmp_path / "r.gpkg"
    check_output(path, text)
    write_geopackage(path, text, _rows())
    assert CRS.from_user_input(crs_of(path).text) == CRS.from_user_input(text)
    read = geopandas.read_file(path, layer="units").crs
    assert read.to_epsg() == CRS.from_user_input(text).to_epsg()
    assert read.name == CRS.from_user_input(text).name
    write_beside(tmp_path / "beside.gpkg", crs_of(path), {"units": LAYERS["units"]}, {})
    assert crs_of(tmp_path / "beside.gpkg", "units") == crs_of(path)


def test_results_with_and_without_wkt_of_the_second_version_replace_one_another(tmp_path: Path) -> None:
    path = tmp_path / "r.gpkg"
    for text in ("EPSG:32650", SITE_GRID, "EPSG:32650", SITE_GRID, "EPSG:9895", "LOCAL"):
        check_output(path, text)
        write_geopackage(path, text, _rows())
        assert parse_crs(crs_of(path).text) == parse_crs(text) if text != "LOCAL" else crs_of(path).text == text
    with closing(sqlite3.connect(path)) as connection:
        assert connection.execute("SELECT count(*) FROM gpkg_spatial_ref_sys WHERE srs_id >= 100000").fetchone() == (1,)
        assert connection.execute("SELECT extension_name FROM gpkg_extensions").fetchall() == [("gpkg_crs_wkt",)]


def test_a_crs_that_cannot_be_stated_is_found_out_before_the_work(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def no_wkt(_: object) -> None:
        raise ValueError("cannot be stated")

    monkeypatch.setattr(geopackage, "wkt_of", no_wkt)
    with pytest.raises(ValueError, match="cannot be stated"):
        check_output(tmp_path / "r.gpkg", "EPSG:32650")


def test_unknown_field_and_naive_time_are_programming_errors(tmp_path: Path) -> None:
    with pytest.raises(KeyError, match="colour"):
        write_geopackage(tmp_path / "r.gpkg", "LOCAL", {"units": [{"colour": 1}]})
    with pytest.raises(ValueError, match="time zone"):
        write_geopackage(tmp_path / "r.gpkg", "LOCAL", {"epochs": [{"time": datetime(2025, 1, 1)}]})
    assert list(tmp_path.iterdir()) == []


def test_reviews_and_foreign_tables_survive_a_new_run(result: Path) -> None:
    with closing(sqlite3.connect(result)) as connection, connection:
        connection.execute("INSERT INTO reviews (unit_id, decision) VALUES ('U1', 'accepted')")
        connection.execute("CREATE TABLE notes (fid INTEGER PRIMARY KEY, text TEXT)")
        connection.execute("INSERT INTO notes (text) VALUES ('kept')")
        connection.execute("INSERT INTO gpkg_contents (table_name, data_type, identifier) VALUES ('notes', 'attributes', 'notes')")
    write_geopackage(result, "EPSG:32650", _rows("uncertain"))
    assert [row["status"] for row in read_layer_rows(result, "units")] == ["uncertain", "lost"]
    assert [row["decision"] for row in read_layer_rows(result, "reviews")] == ["accepted"]
    with closing(sqlite3.connect(result)) as connection:
        assert connection.execute("SELECT text FROM notes").fetchall() == [("kept",)]
        assert connection.execute("SELECT data_type FROM gpkg_contents WHERE table_name = 'notes'").fetchone() == ("attributes",)


def test_a_result_open_elsewhere_is_replaced_inside_and_stays_sound(result: Path) -> None:
    reader = sqlite3.connect(result, isolation_level=None)
    reader.execute("PRAGMA journal_mode = WAL")
    reader.execute("UPDATE units SET status = 'unseen'")
    assert result.with_name("result.gpkg-wal").stat().st_size > 0
    before = result.stat().st_ino
    write_geopackage(result, "EPSG:32650", _rows("uncertain"))
    assert result.stat().st_ino == before
    assert reader.execute("SELECT status FROM units WHERE unit_id = 'U1'").fetchone() == ("uncertain",)
    assert reader.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    reader.close()
    assert [row["status"] for row in read_layer_rows(result, "units")] == ["uncertain", "lost"]


def test_failure_leaves_the_earlier_result_and_no_litter(result: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = result.read_bytes()

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as failing:
        failing.setattr(geopackage, "put_in_place", full)
        with pytest.raises(OutputError, match="No space left"):
            write_geopackage(result, "EPSG:32650", _rows("uncertain"))
    assert result.read_bytes() == before
    assert [p.name for p in result.parent.iterdir()] == ["result.gpkg"]


def test_outputs_that_cannot_be(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="folder does not exist"):
        check_output(tmp_path / "none" / "r.gpkg")
    with pytest.raises(OutputError, match="is a folder"):
        check_output(tmp_path)
    (tmp_path / "photo.gpkg").write_bytes(b"something precious")
    with pytest.raises(OutputError, match="no result of tetratrack"):
        check_output(tmp_path / "photo.gpkg")
    assert (tmp_path / "photo.gpkg").read_bytes() == b"something precious"


@pytest.mark.skipif(not Path("/proc/self").is_dir(), reason="no /proc, the one folder that even root cannot write to")
def test_read_only_folder() -> None:
    with pytest.raises(OutputError, match="cannot be written"):
        check_output("/proc/self/r.gpkg")


def test_result_is_readable_by_all_the_umask_allows(result: Path) -> None:
    mask = os.umask(0)
    os.umask(mask)
    assert result.stat().st_mode & 0o777 == 0o666 & ~mask


def test_covariance_text_round_trip() -> None:
    matrix = np.cov(np.random.default_rng(0).normal(size=(8, 30)))
    assert np.array_equal(from_upper_triangle(upper_triangle(matrix)), matrix)


def test_every_field_is_described() -> None:
    text = markdown()
    for layer in LAYERS.values():
        assert f"### `{layer.name}`" in text
        assert all(f"| `{field.name}` |" in text and field.description for field in layer.fields)
