"""Virtual point clouds: their tiles in their place, and one sentence for one that leads nowhere."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from las_files import grid_points, write_las
from tetratrack.core.common.errors import InputError
from tetratrack.core.common.virtual_clouds import expanded, tiles_of
from tetratrack.core.data.folder_epochs import find_tiles


def write_vpc(path: Path, links: list[str]) -> Path:
    features = [{"assets": {"data": {"href": link}, "overview": {"href": "thin.laz", "roles": ["overview"]}}} for link in links]
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}), encoding="utf-8")
    return path


def test_tiles_stand_in_its_place(tmp_path: Path) -> None:
    (tmp_path / "tiles of may").mkdir()
    first = write_las(tmp_path / "tiles of may" / "a.laz", grid_points())
    second = write_las(tmp_path / "b.LAZ", grid_points())
    path = write_vpc(tmp_path / "all.VPC", ["./tiles of may/a.laz", second.as_uri()])
    assert [tile.resolve() for tile in tiles_of(path)] == [first.resolve(), second.resolve()]
    assert len(expanded([path, tiles_of(path)[0]])) == 2


def test_in_a_folder_it_counts_where_no_tiles_stand_below(tmp_path: Path) -> None:
    tile = write_las(tmp_path / "a_20240409.laz", grid_points())
    write_vpc(tmp_path / "all.vpc", ["./a_20240409.laz"])
    assert len(find_tiles([tmp_path / "all.vpc"])) == 1
    write_vpc(tmp_path / "all.vpc", ["/elsewhere/a_20240409.laz"])
    assert len(find_tiles([tmp_path])) == 1
    (tmp_path / "index").mkdir()
    write_vpc(tmp_path / "index" / "all.vpc", ["../a_20240409.laz"])
    assert [found.info.path.resolve() for found in find_tiles([tmp_path / "index"])] == [tile.resolve()]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{}", "is not a virtual point cloud"),
        ("[" * 100_000, "is not a virtual point cloud"),
        ('{"features": []}', "without tiles"),
        ('{"features": [{"assets": {"data": {"href": "gone.laz"}}}]}', "gone.laz, which is not there"),
        ('{"features": [{"assets": {"data": {"href": "https://example.org/a.laz"}}}]}', "on a server"),
    ],
)
def test_one_that_leads_nowhere(tmp_path: Path, text: str, said: str) -> None:
    path = tmp_path / "all.vpc"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=said) as refused:
        tiles_of(path)
    assert refused.value.source == path
    assert refused.value.remedy
