"""Shaded relief: light and shadow where they belong, holes left open, georeference kept."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tetratrack.core.pipeline.relief import empty_grid, shade, write_relief


def roof() -> np.ndarray:
    """Points of a ridge that runs north: its western face looks to the light's side."""
    e, n = np.meshgrid(np.arange(0, 10, 0.05), np.arange(0, 10, 0.05))
    return np.column_stack([e.ravel() + 500_000, n.ravel() + 4_000_000, 5 - np.abs(e.ravel() - 5)])


def test_the_face_towards_the_light_is_the_brighter() -> None:
    grid = empty_grid((500_000, 4_000_000, 0), (500_010, 4_000_010, 5), 1.5)
    grid.add(roof())
    grey, alpha = shade(grid)
    middle = grey.shape[0] // 2
    assert grey[middle, 20:40].mean() > grey[middle, 60:80].mean() + 50
    assert (alpha[5:-5, 5:-5] == 255).all()


def test_cells_without_points_are_transparent() -> None:
    points = roof()
    grid = empty_grid((500_000, 4_000_000, 0), (500_010, 4_000_010, 5), 1.5)
    grid.add(points[points[:, 0] < 500_004])
    _, alpha = shade(grid)
    assert (alpha[:, 50:] == 0).all()


def test_strips_of_a_wide_grid_are_shaded_as_the_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    grid = empty_grid((500_000, 4_000_000, 0), (500_010, 4_000_010, 5), 1.5)
    grid.add(roof()[::7])
    whole = shade(grid)
    monkeypatch.setattr("tetratrack.core.pipeline.relief.STRIP_CELLS", 7 * grid.height.shape[1])
    for one, other in zip(shade(grid), whole, strict=True):
        # sums that run along a column are rounded otherwise
        assert np.abs(one.astype(int) - other.astype(int)).max() <= 1


def test_geotiff_keeps_place_and_crs(tmp_path: Path) -> None:
    rasterio = pytest.importorskip("rasterio")
    grid = empty_grid((500_000, 4_000_000, 0), (500_010, 4_000_010, 5), 1.5)
    grid.add(roof())
    write_relief(tmp_path / "relief.tif", grid, "EPSG:32650")
    with rasterio.open(tmp_path / "relief.tif") as found:
        assert found.crs.to_epsg() == 32650
        assert found.bounds.left == 500_000
        assert found.bounds.top == 4_000_010
        assert found.res == (0.1, 0.1)
    assert [p.name for p in tmp_path.iterdir()] == ["relief.tif"]


@pytest.mark.parametrize(("spacing", "cell"), [(0.05, 0.075), (0.001, 2.3 / 80), (1.0, 2.3 / 15)])
def test_cells_are_as_fine_as_the_points_allow(spacing: float, cell: float) -> None:
    grid = empty_grid((500_000, 4_000_000, 0), (500_010, 4_000_010, 5), 2.3, spacing)
    assert grid.cell == pytest.approx(cell)
