"""Epochs of folders: names, GPS times, folders that show the same ground, repeated tiles."""

from __future__ import annotations

import tracemalloc
from dataclasses import replace
from datetime import UTC, date, datetime
from pathlib import Path

import numpy as np
import open3d
import pytest
from las_files import grid_points, write_las
from tetratrack.core.common.errors import InputError
from tetratrack.core.data.folder_epochs import find_tiles, group_epochs
from tetratrack.core.data.looks_at_ground import ground_in_common
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


def _coordinates(folder: Path, days: list[int | None], names: list[str]) -> None:
    """Tiles side by side under these names."""
    for k, (name, day) in enumerate(zip(names, days, strict=True)):
        _tile(folder / f"{name}.laz", k * EAST, None if day is None else datetime(2024, 6, day, tzinfo=UTC))


EASTINGS = [f"tile_{e}_4180100" for e in (250310, 250320, 250330, 250340, 250410)]


def test_coordinates_of_six_digits_are_no_dates(tmp_path: Path) -> None:
    _coordinates(tmp_path / "one", [None] * 5, EASTINGS)
    (epoch,) = group_epochs(find_tiles([tmp_path / "one"]))
    assert len(epoch.tiles) == 5
    _coordinates(tmp_path / "timed", [3] * 5, EASTINGS)
    assert [epoch.label for epoch in group_epochs(find_tiles([tmp_path / "timed"]))] == ["2024-06-03"]
    for year in ("2024", "2025"):
        _coordinates(tmp_path / "years" / year, [None] * 5, EASTINGS)
    assert [(epoch.label, len(epoch.tiles)) for epoch in group_epochs(find_tiles([tmp_path / "years"]))] == [("2024", 5), ("2025", 5)]
    _coordinates(tmp_path / "single", [3], EASTINGS[:1])
    assert [epoch.label for epoch in group_epochs(find_tiles([tmp_path / "single"]))] == ["2024-06-03"]


def test_six_digits_that_part_looks_at_the_same_ground_are_dates(tmp_path: Path) -> None:
    for day in ("240409", "250410"):
        _coordinates(tmp_path / "same", [None] * 2, [f"{day}_1", f"{day}_2"])
    assert [epoch.label for epoch in group_epochs(find_tiles([tmp_path / "same"]))] == ["2024-04-09", "2025-04-10"]
    _coordinates(tmp_path / "halves", [9, 20], ["240609_north", "240620_south"])
    assert [epoch.label for epoch in group_epochs(find_tiles([tmp_path / "halves"]))] == ["2024-06-09", "2024-06-20"]
    _coordinates(tmp_path / "one", [None] * 2, ["240409_1", "240409_2"])
    assert [epoch.label for epoch in group_epochs(find_tiles([tmp_path / "one"]))] == ["2024-04-09"]


def test_six_digits_without_any_coordinate_are_dates(tmp_path: Path) -> None:
    for k, name in enumerate(("240601_a", "250601_101500_b")):
        _tile(tmp_path / "years" / f"{name}.laz", 0.7 * k * EAST)
    assert _labels(tmp_path / "years") == [("2024-06-01", 1, 0), ("2025-06-01", 1, 0)]
    _tile(tmp_path / "later" / "240605_x.laz", when=datetime(2024, 6, 1, tzinfo=UTC))
    (epoch,) = group_epochs(find_tiles([tmp_path / "later"]))
    assert epoch.label == "2024-06-05"
    assert "the points' GPS time says 2024-06-01" in epoch.reason


def test_six_digits_that_are_taken_for_coordinates_are_noted(tmp_path: Path) -> None:
    _coordinates(tmp_path, [None] * 5, EASTINGS)
    (epoch,) = group_epochs(find_tiles([tmp_path]))
    assert epoch.questions == ()
    assert "if they are days (2025-03-10 to 2025-04-10), write them as 2025-03-10" in epoch.notes[-1]


def _labels(folder: Path) -> list[tuple[str, int, int]]:
    return [(epoch.label, len(epoch.tiles), len(epoch.questions)) for epoch in group_epochs(find_tiles([folder]))]


@pytest.mark.parametrize(
    ("root", "days"),
    [
        *((root, days) for root in ("busan_2024", "busan") for days in ((1, 2), (1, 1), (None, None))),
        *(("busan_2024-06-01", days) for days in ((1, 2), (None, None))),
    ],
)
def test_before_and_after_are_two_epochs(tmp_path: Path, root: str, days: tuple[int | None, int | None]) -> None:
    for name, day, shift in (("before", days[0], 0.0), ("after", days[1], 0.1)):
        for k in range(2):
            when = None if day is None else datetime(2024, 6, day, tzinfo=UTC)
            _tile(tmp_path / root / name / f"tile_{k}.laz", (k + shift) * EAST, when)
    assert _labels(tmp_path / root) == [("before", 2, 0), ("after", 2, 0)]


@pytest.mark.parametrize(
    ("root", "days", "found"),
    [
        ("site", (1, 1), [("2024-06-01", 2, 0)]),
        ("site", (1, 2), [("2024-06-01", 2, 1)]),
        ("site_2024", (1, 1), [("2024", 2, 0)]),
        ("site_2024", (1, 2), [("2024", 2, 1)]),
        ("site_2024", (1, 9), [("run1", 1, 0), ("run2", 1, 0)]),
        ("site_2024", (None, None), [("2024", 2, 1)]),
        ("site_2024-06-01", (1, 2), [("2024-06-01", 2, 0)]),
        ("site_2024-06-01", (None, None), [("2024-06-01", 2, 0)]),
        ("site_2024-06-01", (1, 9), [("2024-06-01", 2, 1)]),
        ("site_2024-03-01", (1, 9), [("2024-03-01", 2, 0)]),
    ],
)
def test_folders_of_the_same_ground_that_nothing_tells_apart_are_asked_about(
    tmp_path: Path, root: str, days: tuple[int | None, int | None], found: list[tuple[str, int, int]]
) -> None:
    """Strips of one flight show the same ground as well, on one day or two; GPS times that are never of the named day are of the export."""
    for name, day, shift in (("run1", days[0], 0.0), ("run2", days[1], 0.1)):
        _tile(tmp_path / root / name / "t.laz", shift * EAST, None if day is None else datetime(2024, 6, day, tzinfo=UTC))
    assert _labels(tmp_path / root) == found


@pytest.mark.parametrize(
    "names",
    [
        ("first flight", "second flight"),
        ("午前", "午後"),
        ("오전", "오후"),
        ("morning", "afternoon"),
        ("before noon", "after noon"),
        ("pre-dawn", "post-noon"),
        ("flight old camera", "flight new camera"),
        ("first", "final"),
    ],
)
def test_flights_of_one_day_are_one_epoch(tmp_path: Path, names: tuple[str, str]) -> None:
    for root, label in (("site_2024-06-01", "2024-06-01"), ("site_2024", "2024"), ("site", "2024-06-01")):
        for k, name in enumerate(names):
            _tile(tmp_path / root / name / "t.laz", 0.1 * k * EAST, datetime(2024, 6, 1, 1 + 5 * k, tzinfo=UTC))
        assert _labels(tmp_path / root) == [(label, 2, 0)]


@pytest.mark.parametrize(
    "names", [("台風前", "台風後"), ("태풍 전", "태풍 후"), ("vorher", "nachher"), ("01 after works", "02 before works")]
)
def test_before_and_after_of_one_day_in_several_languages(tmp_path: Path, names: tuple[str, str]) -> None:
    for k, name in enumerate(names):
        _tile(tmp_path / "site_2024" / name / "t.laz", 0.1 * k * EAST, datetime(2024, 6, 1, 1 + 5 * k, tzinfo=UTC))
    assert sorted(_labels(tmp_path / "site_2024")) == sorted((name, 1, 0) for name in names)


def test_before_and_after_of_one_named_and_measured_day_are_asked_about(tmp_path: Path) -> None:
    for name in ("before", "after"):
        _tile(tmp_path / "2024-06-01" / name / "t.laz", 0.1 * (name == "after") * EAST, datetime(2024, 6, 1, tzinfo=UTC))
    assert _labels(tmp_path / "2024-06-01") == [("2024-06-01", 2, 1)]


@pytest.mark.parametrize("root", ["site", "site_2024"])
@pytest.mark.parametrize("days", [(1, 1), (None, None)])
def test_folders_are_compared_where_their_paths_part(tmp_path: Path, root: str, days: tuple[int | None, int | None]) -> None:
    for name, day, shift in (("before", days[0], 0.0), ("after", days[1], 0.1)):
        for k, part in enumerate(("las", "north/las", "south/las")):
            when = None if day is None else datetime(2024, 6, day, tzinfo=UTC)
            _tile(tmp_path / "deep" / root / name / part / "t.laz", (k + shift) * EAST, when)
            if k == 0:
                _tile(tmp_path / "flat" / root / name / part / "t.laz", shift * EAST, when)
    assert _labels(tmp_path / "deep" / root) == [("before", 3, 0), ("after", 3, 0)]
    assert _labels(tmp_path / "flat" / root) == [("before", 1, 0), ("after", 1, 0)]


def test_questions_name_the_folders_in_which_paths_part(tmp_path: Path) -> None:
    for k in (1, 2):
        _tile(tmp_path / "site" / f"run{k}" / "las" / "t.laz", 0.1 * k * EAST, datetime(2024, 6, k, tzinfo=UTC))
    (epoch,) = group_epochs(find_tiles([tmp_path / "site"]))
    assert "folders run1 and run2 show the same ground" in epoch.questions[0]
    assert "if they are one, take this line out of the file that init writes" in epoch.questions[0]


@pytest.mark.parametrize("name", ["pos{}", "scan_{}", "Strip {}", "harbour_flight{}", "block-{}", "teil{}"])
def test_stations_and_strips_are_one_epoch_with_a_note(tmp_path: Path, name: str) -> None:
    for k in (1, 2, 3):
        _tile(tmp_path / "harbour_2024" / name.format(k) / "t.laz", 0.1 * k * EAST)
    assert _labels(tmp_path / "harbour_2024") == [("2024", 3, 0)]
    (epoch,) = group_epochs(find_tiles([tmp_path / "harbour_2024"]))
    assert "are taken as parts of one epoch; if they are several, add dates" in epoch.notes[0]


def test_ground_in_common_of_many_tiles_takes_little_memory(tmp_path: Path) -> None:
    _tile(tmp_path / "t.laz")
    (tile,) = find_tiles([tmp_path])
    one, other = (
        [
            replace(tile, info=replace(tile.info, low=(10.0 * k + shift, 0.0, 0.0), high=(10.0 * k + shift + 10, 10.0, 1.0)))
            for k in range(3000)
        ]
        for shift in (0.0, 4.0)
    )
    ground_in_common(one[:2], other[:2])
    tracemalloc.start()
    share = ground_in_common(one, other)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert share == pytest.approx(1 - 4 / 30_000)
    assert peak < 20e6


def test_halves_of_one_flight_in_folders_are_one_epoch(tmp_path: Path) -> None:
    for root in ("site_2024", "site"):
        for k, name in enumerate(("before the bend", "after the bend")):
            _tile(tmp_path / root / name / "t.laz", 0.9 * k * EAST, datetime(2024, 6, 1 + k, tzinfo=UTC))
        assert [row[1:] for row in _labels(tmp_path / root)] == [(2, 0)]
