"""Epochs of folders: names, GPS times, folders that show the same ground, repeated tiles."""

from __future__ import annotations

from datetime import UTC, date, datetime
from pathlib import Path

import numpy as np
import open3d
import pytest
from las_files import grid_points, write_las
from tetratrack.core.common.errors import InputError
from tetratrack.core.data.folder_epochs import find_tiles, group_epochs
from tetratrack.core.data.tile_dates import utc_of_gps

EAST = np.array([4.0, 0.0, 0.0])


def _gps(when: datetime) -> float:
    """Adjusted standard GPS time."""
    return (when - datetime(1980, 1, 6, tzinfo=UTC)).total_seconds() + 18 - 1e9


def _tile(path: Path, shift: np.ndarray | None = None, when: datetime | None = None) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    points = grid_points() + (0 if shift is None else shift)
    write_las(path, points, time=None if when is None else np.full(len(points), _gps(when)))


def test_dated_folders_with_time_of_day_from_the_points(tmp_path: Path) -> None:
    for day in (9, 10):
        for k in range(2):
            _tile(tmp_path / f"2024-04-{day:02}" / "las" / f"t{k}.LAZ", k * EAST, datetime(2024, 4, day, 2, 30, tzinfo=UTC))
    first, second = group_epochs(find_tiles([tmp_path]))
    assert (first.label, second.label) == ("2024-04-09", "2024-04-10")
    assert first.time == datetime(2024, 4, 9, 2, 30, tzinfo=UTC)
    assert [tile.path.name for tile in first.tiles] == ["t0.LAZ", "t1.LAZ"]


def test_dates_in_file_names_of_one_folder(tmp_path: Path) -> None:
    for name in ("a_20240409.laz", "b_20240409.laz", "a_20251101.laz"):
        _tile(tmp_path / name, EAST if name[0] == "b" else None)
    epochs = group_epochs(find_tiles([tmp_path]))
    assert [(epoch.label, len(epoch.tiles)) for epoch in epochs] == [("2024-04-09", 2), ("2025-11-01", 1)]
    assert "noon UTC" in epochs[0].reason


def test_gps_time_where_no_name_tells(tmp_path: Path) -> None:
    for k, day in enumerate((1, 2, 20)):
        _tile(tmp_path / f"tile{k}.laz", k * EAST, datetime(2024, 6, day, 23, tzinfo=UTC))
    epochs = group_epochs(find_tiles([tmp_path]))
    assert [(epoch.label, len(epoch.tiles)) for epoch in epochs] == [("2024-06-01", 2), ("2024-06-20", 1)]


def test_folders_of_the_same_ground_are_epochs_and_folders_side_by_side_are_one(tmp_path: Path) -> None:
    for folder, shift in (("before", 0), ("after", 0.1)):
        _tile(tmp_path / "same" / folder / "t.laz", shift * EAST)
    for folder, shift in (("north", 0), ("south", 10)):
        _tile(tmp_path / "beside" / folder / "t.laz", shift * EAST)
    assert sorted(epoch.label for epoch in group_epochs(find_tiles([tmp_path / "same"]))) == ["after", "before"]
    assert len(group_epochs(find_tiles([tmp_path / "beside"]))) == 1


def test_a_tile_that_repeats_another_is_left_out_and_named(tmp_path: Path) -> None:
    _tile(tmp_path / "2024-04-09" / "t.laz")
    _tile(tmp_path / "2024-04-09" / "t.las")
    (epoch,) = group_epochs(find_tiles([tmp_path]))
    assert len(epoch.tiles) == 1
    assert "repeats" in epoch.notes[0]


def test_a_day_that_could_be_a_month_is_settled_by_gps_time(tmp_path: Path) -> None:
    _tile(tmp_path / "04-09-2024" / "t.laz", when=datetime(2024, 4, 9, 5, tzinfo=UTC))
    (epoch,) = group_epochs(find_tiles([tmp_path]))
    assert epoch.label == "2024-04-09"


def test_folder_without_tiles_says_what_it_holds(tmp_path: Path) -> None:
    (tmp_path / "scan.pts").write_text("")
    with pytest.raises(InputError, match=r"holds no point cloud.*\.pts"):
        find_tiles([tmp_path])


@pytest.mark.parametrize(
    ("seconds", "day"), [(396_665_018.0, date(2024, 4, 9)), (1_396_665_018.0, date(2024, 4, 9)), (200_000.0, None), (5e11, None)]
)
def test_kinds_of_gps_time(seconds: float, day: date | None) -> None:
    found = utc_of_gps(seconds)
    assert (found.date() if found else None) == day


def test_scans_count_where_no_tiles_stand_beside_them(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    write_las(tmp_path / "a" / "tile.LAZ", grid_points())
    for folder in "ab":
        cloud = open3d.t.geometry.PointCloud(open3d.core.Tensor(grid_points()))
        open3d.t.io.write_point_cloud(tmp_path / folder / "scan.ply", cloud)
    assert sorted(tile.info.path.name for tile in find_tiles([tmp_path])) == ["scan.ply", "tile.LAZ"]
    assert [tile.info.path.name for tile in find_tiles([tmp_path / "a" / "scan.ply"])] == ["scan.ply"]
