"""The table and the layer of ``inspect``: every tile has its row and its place, whatever its name and CRS."""

from __future__ import annotations

from pathlib import Path

import geopandas
import numpy as np
import pytest
from las_files import ORIGIN, grid_points, write_las
from pyproj import Transformer
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.pipeline.inspection import run_inspect

NEIGHBOUR = "EPSG:32651"
"""The UTM zone east of that of the other tiles."""
SURVEY = """[survey]
name = "s"
crs = "EPSG:32650"
size_check = false
[unit]
type = "tetrapod"
height = 2.3
[[epoch]]
label = "one"
time = 2024-04-09T02:30:00Z
tiles = "tile.laz"
"""


def to_neighbour(points: np.ndarray) -> np.ndarray:
    moved = Transformer.from_crs("EPSG:32650", NEIGHBOUR, always_xy=True).transform(points[:, 0], points[:, 1])
    return np.column_stack([*moved, points[:, 2]])


def middles(index: Path) -> np.ndarray:
    """Easting and northing of the middles of the layer's rectangles, whatever its CRS, in that of most tiles."""
    centroids = geopandas.read_file(index, layer="tiles").geometry.centroid.to_crs("EPSG:32650")
    return np.column_stack([centroids.x, centroids.y])


def test_tiles_of_one_name_in_several_folders_have_a_row_each(tmp_path: Path) -> None:
    folders = [tmp_path / name for name in ("first", "second", "third")]
    for folder in folders:
        folder.mkdir()
    tiles = [write_las(folder / "strip.laz", grid_points(count)) for folder, count in zip(folders, (400, 300), strict=False)]
    damaged = folders[2] / "strip.laz"
    damaged.write_bytes(tiles[0].read_bytes()[:300])
    index = tmp_path / "index.gpkg"
    outputs, error = run_inspect([*tiles, damaged], index, Feedback())
    assert error is not None
    assert [(row["input"], row["points"], row["verdict"]) for row in outputs["table"]] == [
        (str(tiles[0]), 400, "ok"),
        (str(tiles[1]), 300, "ok"),
        (str(damaged), "", "refused"),
    ]
    assert sorted(geopandas.read_file(index, layer="tiles")["points"]) == [300, 400]


def test_tiles_of_two_surveys_with_the_same_epochs_have_a_row_each(tmp_path: Path) -> None:
    surveys = []
    for name in ("north", "south"):
        (tmp_path / name).mkdir()
        write_las(tmp_path / name / "tile.laz", grid_points())
        (tmp_path / name / "survey.toml").write_text(SURVEY)
        surveys.append(read_survey(tmp_path / name / "survey.toml"))
    outputs, _ = run_inspect(surveys, None, Feedback())
    assert [row["points"] for row in outputs["table"] if row["what"] == "tile"] == [400, 400]


@pytest.mark.parametrize("neighbour_first", [False, True])
def test_tiles_of_several_crs_lie_where_they_are_on_the_map(tmp_path: Path, neighbour_first: bool) -> None:
    points = grid_points()
    own, other = write_las(tmp_path / "own.laz", points), write_las(tmp_path / "other.laz", to_neighbour(points), NEIGHBOUR)
    index = tmp_path / "index.gpkg"
    run_inspect([other, own] if neighbour_first else [own, other], index, Feedback())
    assert np.abs(middles(index) - (ORIGIN[:2] + 2)).max() < 0.5


def test_a_tile_that_a_survey_transforms_lies_where_it_is_on_the_map(tmp_path: Path) -> None:
    write_las(tmp_path / "tile.laz", to_neighbour(grid_points()), NEIGHBOUR)
    (tmp_path / "survey.toml").write_text(SURVEY)
    index = tmp_path / "index.gpkg"
    run_inspect([read_survey(tmp_path / "survey.toml")], index, Feedback())
    assert np.abs(middles(index) - (ORIGIN[:2] + 2)).max() < 0.5
