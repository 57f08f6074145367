"""Point source IDs that number scan lines are read as one strip; those of strips and stations stay."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.strip_numbers import LEAST_POINTS, MOST_STRIPS, by_strips
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.data.tiles import inspect_tile, read_points
from tetratrack.core.pipeline.survey_check import check_survey
from tetratrack.tests.helpers.las_files import grid_points, write_las

FRAMES = 3 * MOST_STRIPS
"""Scan lines of the test's tiles."""


@pytest.fixture
def lines(tmp_path):
    """A tile of as many scan lines, each with a number of its own."""
    points = grid_points(FRAMES * 4)
    return write_las(tmp_path / "lines.laz", points, source=np.repeat(np.arange(1, FRAMES + 1), 4))


def test_scan_lines_are_one_strip(lines):
    """Every point is read with the number 0, and the sentence counts the lines."""
    tiles, said = by_strips("may", [inspect_tile(lines, "EPSG:32650")])
    cloud = read_points(tiles, "EPSG:32650")
    assert f"may: {FRAMES} point source IDs" in said
    assert len(cloud) == FRAMES * 4
    assert not cloud.source_id.any()
    assert tiles[0].sources == (0,)


def test_strips_and_stations_stay(lines):
    """Few numbers, and many that have as many points as a strip has."""
    frames = inspect_tile(lines, "EPSG:32650")
    few = replace(frames, sources=tuple(range(MOST_STRIPS)))
    rich = replace(frames, points=FRAMES * LEAST_POINTS)
    for tile in (few, rich):
        tiles, said = by_strips("may", [tile])
        assert tiles == (tile,)
        assert not said
    assert len(np.unique(read_points([frames], "EPSG:32650").source_id)) == FRAMES


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
    assert check.tiles["may"][0].one_strip is not stations
