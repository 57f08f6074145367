"""What an output would replace: an earlier one of its own kind, and nothing else."""

from __future__ import annotations

import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import laspy
import numpy as np
import pytest
from crooked_las import write_survey
from las_files import grid_points, write_las
from pyproj import CRS
from synthetic_result import make_units, write_points, write_result
from tetratrack.core.data.crs import parse_crs
from tetratrack.core.results.geopackage_writer import write_geopackage
from tetratrack.scripts.cli import app
from typer.testing import CliRunner


def _crs_of(path: Path) -> CRS | None:
    with laspy.open(path) as reader:
        return reader.header.parse_crs()


FOREIGN = "exists and was not written by this command"


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("made")
    units = make_units(6, 2, seed=4)
    write_result(folder / "result.gpkg", epochs=2, units=units)
    write_points(folder / "result.gpkg", units, epochs=2, per_unit=300)
    place = units[0].centres[0]
    lines = ["unit_id,easting,northing,height", f"P1,{place[0]:.3f},{place[1]:.3f},{place[2]:.3f}"]
    (folder / "plan.csv").write_text("\n".join(lines) + "\n")
    return folder


@pytest.fixture
def site(made: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(made, tmp_path / "site"))


def _drawing(path: Path) -> None:
    import ezdxf

    drawing = ezdxf.new("R2010")
    drawing.appids.add("TETRATRACK")
    drawing.saveas(path)


def _web_page(path: Path) -> None:
    path.write_text("<!DOCTYPE html>\n<html><head><meta charset='utf-8'></head><body>tetratrack report</body></html>")


def _tile(path: Path) -> None:
    write_las(path, grid_points())


def _bytes(path: Path) -> None:
    path.write_bytes(b"somebody's own work")


OUTPUTS = [
    (("residuals", "SITE/result.gpkg"), "o.laz", _tile),
    (("model", "SITE/result.gpkg"), "o.dxf", _drawing),
    (("model", "SITE/result.gpkg"), "o.json", _bytes),
    (("model", "SITE/result.gpkg"), "o.obj", _bytes),
    (("model", "SITE/result.gpkg"), "o.glb", _bytes),
    (("model", "SITE/result.gpkg"), "o.ifc", _bytes),
    (("report", "SITE/result.gpkg", "--worst", "1"), "o.html", _web_page),
    (("report", "SITE/result.gpkg", "--worst", "1"), "o.pdf", _bytes),
    (("profiles", "SITE/result.gpkg"), "o.gpkg", lambda path: shutil.copy(path.with_name("result.gpkg"), path)),
    (("design", "SITE/result.gpkg", "--plan", "SITE/plan.csv"), "o.gpkg", lambda path: shutil.copy(path.with_name("result.gpkg"), path)),
]


@pytest.mark.parametrize(("arguments", "name", "foreign"), OUTPUTS, ids=[f"{words[0]}-{name[2:]}" for words, name, _ in OUTPUTS])
def test_an_output_replaces_its_own_kind_alone(site: Path, arguments: tuple[str, ...], name: str, foreign) -> None:
    output = site / name
    words = [word.replace("SITE", str(site)) for word in arguments]
    foreign(output)
    before = output.read_bytes()
    refused = CliRunner().invoke(app, [*words, "-o", str(output)])
    assert refused.exit_code == 2, refused.output
    assert f"{name}: {FOREIGN}" in refused.stderr
    assert output.read_bytes() == before
    output.unlink()
    for _ in range(2):
        done = CliRunner().invoke(app, [*words, "-o", str(output)])
        assert done.exit_code == 0, done.output


def test_a_comparison_that_a_user_added_to_is_his(site: Path) -> None:
    words = ["profiles", str(site / "result.gpkg"), "-o", str(site / "o.gpkg")]
    assert CliRunner().invoke(app, words).exit_code == 0
    for change in ("ALTER TABLE sections ADD COLUMN remark TEXT", "CREATE TABLE mine (fid INTEGER PRIMARY KEY)"):
        shutil.copy(site / "o.gpkg", site / "changed.gpkg")
        with closing(sqlite3.connect(site / "changed.gpkg")) as connection, connection:
            connection.execute(change)
        refused = CliRunner().invoke(app, [*words[:-1], str(site / "changed.gpkg")])
        assert refused.exit_code == 2
        assert FOREIGN in refused.stderr


def test_merged_views_do_not_replace_a_tile(tmp_path: Path) -> None:
    rng = np.random.default_rng(5)
    bowl = rng.uniform(-1, 1, (4000, 2))
    heights = 5.0 + 0.3 * np.sin(3 * bowl[:, 0]) + 0.4 * np.cos(2 * bowl[:, 1])
    points = np.column_stack([bowl, heights]) + np.array([500_000.0, 3_500_000.0, 0.0])
    for name in ("a.laz", "b.laz", "tile.laz"):
        write_las(tmp_path / name, points)
    words = ["register-views", str(tmp_path / "a.laz"), str(tmp_path / "b.laz"), "-o"]
    before = (tmp_path / "tile.laz").read_bytes()
    refused = CliRunner().invoke(app, [*words, str(tmp_path / "tile.laz")])
    assert refused.exit_code == 2, refused.output
    assert FOREIGN in refused.stderr
    assert (tmp_path / "tile.laz").read_bytes() == before
    for _ in range(2):
        done = CliRunner().invoke(app, [*words, str(tmp_path / "merged.laz")])
        assert done.exit_code == 0, done.output
    assert _crs_of(tmp_path / "merged.laz") == _crs_of(tmp_path / "a.laz")


@pytest.mark.parametrize("crs", ["EPSG:5186", "EPSG:5186+5193", "EPSG:9895", "LOCAL"])
def test_the_points_less_blocks_keep_the_crs(site: Path, crs: str) -> None:
    write_geopackage(site / "crs.gpkg", crs, {})
    with closing(sqlite3.connect(site / "result.gpkg")) as connection, connection:
        connection.execute("ATTACH ? AS other", (str(site / "crs.gpkg"),))
        connection.execute("DROP TABLE gpkg_spatial_ref_sys")
        connection.execute("CREATE TABLE gpkg_spatial_ref_sys AS SELECT * FROM other.gpkg_spatial_ref_sys")
        number = connection.execute("SELECT srs_id FROM other.gpkg_geometry_columns WHERE table_name = 'units'").fetchone()
        connection.execute("UPDATE gpkg_geometry_columns SET srs_id = ? WHERE table_name = 'units'", number)
    done = CliRunner().invoke(app, ["residuals", str(site / "result.gpkg"), "-o", str(site / "o.laz")])
    assert done.exit_code == 0, done.output
    written = _crs_of(site / "o.laz")
    assert written is None if crs == "LOCAL" else written.name == parse_crs(crs).name


def test_a_relief_does_not_replace_an_image(tmp_path: Path) -> None:
    import rasterio

    write_las(tmp_path / "a.laz", grid_points())
    epochs = '[[epoch]]\nlabel = "a"\ntime = 2024-01-14T02:30:00Z\ntiles = "a.laz"\n'
    words = ["relief", str(write_survey(tmp_path, epochs=epochs)), "-o", str(tmp_path / "site")]
    image = tmp_path / "site_a.tif"
    place = rasterio.transform.from_origin(500_000, 3_500_000, 1, 1)
    with rasterio.open(image, "w", driver="GTiff", height=8, width=8, count=3, dtype="uint8", transform=place) as orthophoto:
        orthophoto.write(np.full((3, 8, 8), 7, np.uint8))
    before = image.read_bytes()
    refused = CliRunner().invoke(app, words)
    assert refused.exit_code == 2, refused.output
    assert f"site_a.tif: {FOREIGN}" in refused.stderr
    assert image.read_bytes() == before
    image.unlink()
    for _ in range(2):
        done = CliRunner().invoke(app, words)
        assert done.exit_code == 0, done.output
