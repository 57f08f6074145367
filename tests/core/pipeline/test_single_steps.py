"""Steps on files by themselves: what they cannot do is refused before it is done."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from las_files import grid_points, write_las
from tetratrack.core.common.errors import InputError, OutputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.pipeline.single_steps import run_register_views


@pytest.mark.parametrize("voxel", [-1.0, 0.0, math.nan, math.inf])
def test_voxels_without_a_size_are_refused(tmp_path: Path, voxel: float) -> None:
    with pytest.raises(InputError, match="have no size"):
        run_register_views([tmp_path / "a.laz", tmp_path / "b.laz"], tmp_path / "out.laz", voxel, Feedback())


def test_a_merged_cloud_is_named_as_what_it_is(tmp_path: Path) -> None:
    """Points as LAS under the name of a PLY, which no program reads."""
    with pytest.raises(OutputError, match=r"End the name in \.laz or \.las"):
        run_register_views([tmp_path / "a.laz", tmp_path / "b.laz"], tmp_path / "out.ply", None, Feedback())


def test_a_frame_without_a_crs_does_not_get_that_of_another_view(tmp_path: Path) -> None:
    views = [write_las(tmp_path / "own.laz", grid_points(), None), write_las(tmp_path / "utm.laz", grid_points())]
    with pytest.raises(InputError, match=r"own\.laz, states no CRS"):
        run_register_views(views, tmp_path / "out.laz", None, Feedback())
    assert not (tmp_path / "out.laz").exists()
