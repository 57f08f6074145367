"""Strips and stations: by point source ID, by GPS time where all points have one number, or one where numbers are those of scan lines."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.places_by_second import PlacesBySecond
from tetratrack.core.data.strip_numbers import LEAST_POINTS, MOST_SECONDS, MOST_STRIPS, by_strips, passes
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.data.tiles import TileInfo, Window, inspect_tile, read_points
from tetratrack.core.pipeline.block_jobs import SegmentJob
from tetratrack.core.pipeline.blocks import Block
from tetratrack.core.pipeline.survey_check import check_survey
from tetratrack.tests.helpers.las_files import ORIGIN, grid_points, write_las

FRAMES = 3 * MOST_STRIPS
"""Scan lines of the test's tiles."""
CRS = "EPSG:32650"
START = 396_665_018.25
"""GPS time (adjusted standard) of the first point, seconds."""


@pytest.fixture
def lines(tmp_path):
    """A tile of as many scan lines, each with a number of its own."""
    points = grid_points(FRAMES * 4)
    return write_las(tmp_path / "lines.laz", points, source=np.repeat(np.arange(1, FRAMES + 1), 4))


def flown(gap, length=80.0, speed=2.0, rate=100):
    """Two lines along a coast and back, with ``gap`` seconds around the end: (n, 3) points, (n,) times and (n,) true numbers."""
    rng = np.random.default_rng(5)
    clock = np.arange(0, length / speed, 1 / rate)
    there = np.column_stack([speed * clock, rng.uniform(-4, 4, len(clock))])
    back = np.column_stack([length - speed * clock, rng.uniform(-4, 4, len(clock))])
    times = START + np.concatenate([clock, clock + clock[-1] + gap])
    plan = np.vstack([there, back]) @ np.array([[0.8, 0.6], [-0.6, 0.8]])
    return ORIGIN + np.column_stack([plan, rng.normal(0, 0.1, len(plan))]), times, np.repeat([1, 2], len(clock))


def test_scan_lines_are_one_strip(lines):
    """Every point is read with the number 0, and the sentence counts the lines."""
    tiles, said = by_strips("may", [inspect_tile(lines, CRS)])
    cloud = read_points(tiles, CRS)
    assert f"may: {FRAMES} point source IDs" in said
    assert len(cloud) == FRAMES * 4
    assert not cloud.source_id.any()
    assert tiles[0].sources == (0,)


def test_strips_and_stations_stay(lines):
    """Few numbers, and many that have as many points as a strip has."""
    frames = inspect_tile(lines, CRS)
    few = replace(frames, sources=tuple(range(MOST_STRIPS)))
    rich = replace(frames, points=FRAMES * LEAST_POINTS)
    for tile in (few, rich):
        tiles, said = by_strips("may", [tile])
        assert tiles == (tile,)
        assert not said
    assert len(np.unique(read_points([frames], CRS).source_id)) == FRAMES


@pytest.mark.parametrize("gap", [0.5, 30.0])
@pytest.mark.parametrize("number", [0, 3])
def test_flight_lines_without_numbers_are_told_by_time(tmp_path, gap, number):
    """Whether the flight was cut at the turn or not, over several tiles, whatever number all points have."""
    points, times, line = flown(gap)
    tiles = []
    for k in (0, 1):
        own = np.arange(len(points)) % 2 == k
        numbers = np.full(own.sum(), number)
        tiles.append(inspect_tile(write_las(tmp_path / f"{k}.laz", points[own], source=numbers, time=times[own]), CRS))
    read, said = by_strips("may", tiles)
    cloud = read_points(read, CRS)
    assert "by GPS time there are 2 passes or stations" in said
    order = np.argsort(cloud.gps_time)
    wrong = cloud.source_id[order] != line
    assert wrong.sum() <= 100 * 1.5  # a turn is told to the second
    assert read[0].sources == (1, 2)


def test_a_gap_within_a_line_is_no_new_line():
    """Data of a few seconds are missing, as over water."""
    points, times, _ = flown(30.0)
    lost = (times > START + 12) & (times < START + 20)
    assert len(passes(PlacesBySecond.of(times[~lost], points[~lost]))) == 2


def test_stations_are_told_by_the_way_between_them():
    """A scanner turns half around on three stations, minutes apart, and sees 200 m of a wall from each."""
    turn = np.linspace(-1.4, 1.4, 9000)
    wall = [np.column_stack([60.0 * k + 18 * np.tan(turn), np.full(len(turn), 18.0)]) for k in range(3)]
    times = [START + 400 * k + np.linspace(0, 90, len(turn)) for k in range(3)]
    starts = passes(PlacesBySecond.of(np.concatenate(times), np.vstack(wall)))
    np.testing.assert_array_equal(starts, np.floor(START) + 400 * np.arange(3))


def test_times_that_tell_nothing_leave_tiles_alone(tmp_path):
    """One line; all points at one time, at none or at what nobody wrote; times rounded to half a minute; and one to a point for days."""
    points, times, _ = flown(30.0)
    line = times < START + 35
    count = line.sum()
    rounded = np.float64(np.float32(times[line] + 40.0 * np.arange(count)))
    for k, own in enumerate((times[line], np.zeros(count), np.full(count, np.nan), np.full(count, -6.3e66), rounded)):
        tile = inspect_tile(write_las(tmp_path / f"{k}.laz", points[line], time=own), CRS)
        assert by_strips("may", [tile]) == ((tile,), "")
    tile = inspect_tile(write_las(tmp_path / "none.laz", points, point_format=0), CRS)
    assert by_strips("may", [tile]) == ((tile,), "")
    many = np.arange(MOST_SECONDS + 1)
    assert not len(passes(PlacesBySecond(many, np.ones(len(many), dtype=np.int64), np.zeros((len(many), 2)))))


def test_a_tile_without_times_leaves_all_alone(tmp_path):
    """Its points are of no pass, and the others' passes would be no strips of theirs."""
    points, times, _ = flown(30.0)
    timed = inspect_tile(write_las(tmp_path / "timed.laz", points, time=times), CRS)
    untimed = inspect_tile(write_las(tmp_path / "untimed.laz", points + np.array([0, 20, 0]), time=np.full(len(points), np.nan)), CRS)
    assert by_strips("may", [timed, untimed]) == ((timed, untimed), "")


def test_times_that_begin_anew_are_other_passes(tmp_path):
    """Seconds of a week end at midnight of Saturday; what was measured then comes before, in whatever order points lie."""
    points, times, line = flown(30.0)
    week = np.where(line == 2, times - START - 60, times - START + 604_700)
    shuffled = np.random.default_rng(3).permutation(len(points))
    tile = inspect_tile(write_las(tmp_path / "week.laz", points[shuffled], time=week[shuffled]), CRS)
    read, said = by_strips("may", [tile])
    assert "there are 2 passes" in said
    cloud = read_points(read, CRS)
    assert set(cloud.source_id[cloud.gps_time > 600_000]) == {2}
    assert set(cloud.source_id[cloud.gps_time < 600_000]) == {1}


def test_means_of_points_have_no_pass_and_it_is_said(tmp_path):
    """A mean may be of points of several passes."""
    points, times, _ = flown(30.0)
    tile = replace(inspect_tile(write_las(tmp_path / "a.laz", points, time=times), CRS), thinned="key")
    read, said = by_strips("may", [tile])
    assert "where points are thinned passes cannot be told apart" in said
    assert read[0].strip_starts == ()


def test_a_block_is_not_kept_where_its_points_are_of_other_strips():
    """Numbers of passes hang on all tiles of the epoch, those of a kept block's points on those of the run before."""
    core = Window(0, 0, 10, 10)
    tile = TileInfo(
        path=Path("a.laz"), points=10, low=(0, 0, 0), high=(9, 9, 3), version="1.4", point_format=6, compressed=True, copc=False, crs="",
        has_time=True, size=1000, note="",
    )  # fmt: skip
    names = set()
    for starts in (None, (), (5.0, 60.0), (1.0, 5.0, 60.0)):
        block = Block(epoch="may", column=0, row=0, core=core, tiles=(replace(tile, strip_starts=starts),))
        names.add(SegmentJob(block=block, survey_crs=CRS, tiles_crs=None, units=(), seed=0, checksums=("x",)).name)
    assert len(names) == 4


@pytest.mark.parametrize("stations", [False, True])
def test_the_check_of_a_survey_says_so(lines, stations):
    """A warning in the check of the input; a table of stations says what the numbers are."""
    folder = lines.parent
    table = "\n".join(f"{number},500002,3500002,5" for number in range(1, FRAMES + 1))
    (folder / "stations.csv").write_text(f"point_source_id,x,y,z\n{table}\n")
    given = 'stations = "stations.csv"\nrange_sd = 0.004\nangle_sd = 0.0001\n' if stations else ""
    (folder / "survey.toml").write_text(
        '[survey]\nname = "lines"\ncrs = "EPSG:32650"\n[unit]\ntype = "tetrapod"\nheight = 2.5\n'
        f'[[epoch]]\nlabel = "may"\ntime = 2025-05-01T00:00:00Z\ntiles = "lines.laz"\n{given}'
    )
    check = check_survey(read_survey(folder / "survey.toml"), Feedback())
    said = [finding.message for finding in check.findings if "scan lines or frames" in finding.message]
    assert len(said) == (0 if stations else 1)
    assert check.tiles["may"][0].strip_starts == (None if stations else ())
