"""Tiles as people give them: quoted lists, patterns, folders of scans, virtual point clouds."""

from __future__ import annotations

import json
import struct
from datetime import UTC, datetime
from pathlib import Path

import pytest
from qgis.core import QgsProcessingContext, QgsProcessingException
from tetratrack.algorithms.support.inputs import tile_paths
from tetratrack.algorithms.survey_algorithm import creation_date


def _names(value: object) -> list[str]:
    return [Path(path).name for path in tile_paths(value, QgsProcessingContext(), "Tiles")]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("tiles/a.laz", "tiles/b.LAZ", "tiles/mesh.ply", "scans/c.E57", "scans/notes.txt"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(b"")
    features = [{"assets": {"data": {"href": "tiles/a.laz"}, "thin": {"href": "tiles/thin.copc.laz", "roles": ["overview"]}}}]
    (tmp_path / "all.VPC").write_text(json.dumps({"features": features}))
    return tmp_path


def test_tiles_as_people_give_them(folder: Path) -> None:
    assert _names(str(folder / "tiles")) == ["a.laz", "b.LAZ"]
    assert _names(str(folder / "scans")) == ["c.E57"]
    assert _names(str(folder / "tiles" / "*.laz")) == ["a.laz", "b.LAZ"]
    assert _names(f'"{folder / "tiles" / "a.laz"}" "{folder / "scans" / "c.E57"}"') == ["a.laz", "c.E57"]
    assert _names([str(folder / "all.VPC"), str(folder / "tiles" / "a.laz")]) == ["a.laz"]
    with pytest.raises(QgsProcessingException, match=r"gone\.laz"):
        _names(f'"{folder / "tiles" / "a.laz"}" "{folder / "gone.laz"}"')


@pytest.mark.parametrize("year", [0, 1970, 9999, 65535])
def test_a_year_beyond_reason_is_no_creation_date(tmp_path: Path, year: int) -> None:
    tile = tmp_path / "a.las"
    tile.write_bytes(b"LASF".ljust(90, b"\0") + struct.pack("<HH", 366, year))
    assert abs(creation_date(tile).timestamp() - tile.stat().st_mtime) < 1
    tile.write_bytes(b"LASF".ljust(90, b"\0") + struct.pack("<HH", 366, 2024))
    assert creation_date(tile) == datetime(2024, 12, 31, tzinfo=UTC)


def test_links_of_a_virtual_point_cloud_are_those_that_the_engine_follows(folder: Path) -> None:
    tile = folder / "tiles" / "a b#1.laz"
    tile.write_bytes(b"")
    cloud = folder / "linked.vpc"
    cloud.write_text(json.dumps({"features": [{"assets": {"data": {"href": tile.as_uri()}}}]}))
    assert tile_paths(str(cloud), QgsProcessingContext(), "Tiles") == [str(tile.resolve())]
    cloud.write_text(json.dumps({"features": [{"assets": {"data": {"href": "tiles/gone.laz"}}}]}))
    with pytest.raises(QgsProcessingException, match=r"Tiles: .*names the tile tiles/gone\.laz, which is not there"):
        _names(str(cloud))
    cloud.write_text("no cloud")
    with pytest.raises(QgsProcessingException, match="is not a virtual point cloud"):
        _names(str(cloud))
