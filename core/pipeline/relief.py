"""Top-view shaded relief of an epoch as GeoTIFF: a backdrop where point clouds cannot be shown."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter

from ..common.arrays import FloatArray
from ..common.atomic_files import write_whole
from ..common.errors import OutputError
from ..common.feedback import Feedback
from ..common.output_files import check_own, check_targets, safe_name
from ..data.crs import LOCAL
from ..data.survey import Survey
from ..data.tiles import TileInfo, read_points
from .epoch_plans import plan_survey

GreyArray = NDArray[np.uint8]

LEAST_CELLS_PER_HEIGHT, MOST_CELLS_PER_HEIGHT = 15, 80
"""Cells across a unit's height: from fewer nothing is recognised, more would show only the noise of the points."""
SPACINGS_PER_CELL = 1.5
"""Size of a cell in mean spacings of the points: one cell in ten stays empty then, and is filled from its neighbours."""
MOST_CELLS = 100_000_000
STRIP_CELLS = 4_000_000
"""Cells that are shaded at a time."""
MARK = "tetratrack relief"
"""Software that the images name, by which they are known."""
SUN_AZIMUTH, SUN_ALTITUDE = math.radians(315), math.radians(45)
"""Light from the north-west, the custom of relief maps; from elsewhere the eye swaps heights and hollows."""


@dataclass(frozen=True, eq=False)
class HighestPoints:
    """Highest point of every cell of a grid.

    Attributes
    ----------
    west, north
        Upper left corner, metres.
    cell
        Size of a cell, metres.
    height
        (rows, columns) metres, -inf where there is no point; row 0 is the northernmost.
    """

    west: float
    north: float
    cell: float
    height: NDArray[np.float32]

    def add(self, points: FloatArray) -> None:
        """Take (n, 3) absolute points into account; points outside the grid are left out."""
        rows, columns = self.height.shape
        column = np.floor((points[:, 0] - self.west) / self.cell).astype(np.int64)
        row = np.floor((self.north - points[:, 1]) / self.cell).astype(np.int64)
        inside = (row >= 0) & (row < rows) & (column >= 0) & (column < columns)
        np.maximum.at(self.height, (row[inside], column[inside]), points[inside, 2].astype(np.float32))


def empty_grid(low: tuple[float, ...], high: tuple[float, ...], height: float, spacing: float = math.inf) -> HighestPoints:
    """Grid over an extent (e, n, ...) with cells as fine as points of a mean ``spacing`` in metres allow.

    Cells are fractions of the unit's ``height`` in metres, coarser where the grid would grow too large.
    """
    width, length = max(high[0] - low[0], height), max(high[1] - low[1], height)
    wanted = min(max(SPACINGS_PER_CELL * spacing, height / MOST_CELLS_PER_HEIGHT), height / LEAST_CELLS_PER_HEIGHT)
    cell = max(wanted, math.sqrt(width * length / MOST_CELLS))
    shape = (math.ceil(length / cell) + 1, math.ceil(width / cell) + 1)
    return HighestPoints(low[0], high[1], cell, np.full(shape, -np.inf, dtype=np.float32))


def shade(grid: HighestPoints) -> tuple[GreyArray, GreyArray]:
    """Shading of a grid of highest points.

    Returns
    -------
    grey, alpha
        (rows, columns) brightness 55..255, so that shadows still show symbols, and 255 where a point lies in the cell or beside it,
        0 elsewhere.
    """
    rows = len(grid.height)
    grey, alpha = np.empty(grid.height.shape, np.uint8), np.empty(grid.height.shape, np.uint8)
    # a dozen arrays of the whole grid would be gigabytes; a row is shaded by the two above and below it
    strip = max(1, STRIP_CELLS // grid.height.shape[1])
    for start in range(0, rows, strip):
        first, last = max(0, start - 2), min(rows, start + strip + 2)
        part = slice(start - first, min(rows, start + strip) - first)
        some_grey, some_alpha = _shaded(grid.height[first:last], grid.cell)
        grey[start : start + strip], alpha[start : start + strip] = some_grey[part], some_alpha[part]
    return grey, alpha


def _shaded(height: NDArray[np.float32], cell: float) -> tuple[GreyArray, GreyArray]:
    """Brightness and transparency of some rows of a grid."""
    known = np.isfinite(height)
    weight = uniform_filter(known.astype(np.float32), 3)
    total = uniform_filter(np.where(known, height, 0).astype(np.float32), 3)
    filled = np.where(known, height, total / np.maximum(weight, 1e-6))
    seen = weight > 1e-6
    slope_n, slope_e = np.gradient(np.where(seen, filled, 0), -cell, cell)
    light = (math.sin(SUN_AZIMUTH) * math.cos(SUN_ALTITUDE), math.cos(SUN_AZIMUTH) * math.cos(SUN_ALTITUDE), math.sin(SUN_ALTITUDE))
    brightness = (light[2] - slope_e * light[0] - slope_n * light[1]) / np.sqrt(1 + slope_e**2 + slope_n**2)
    return (55 + 200 * np.clip(brightness, 0, 1)).astype(np.uint8), np.where(seen, 255, 0).astype(np.uint8)


def write_relief(path: Path, grid: HighestPoints, crs: str) -> None:
    """Write the shading of a grid as a compressed GeoTIFF with transparency, whole or not at all.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    from rasterio.enums import ColorInterp
    from rasterio.io import MemoryFile
    from rasterio.transform import from_origin

    grey, alpha = shade(grid)
    # GDAL does not say that a disk is full: the file is made in memory and then written
    with MemoryFile() as memory:
        with memory.open(
            driver="GTiff",
            height=grey.shape[0],
            width=grey.shape[1],
            count=2,
            dtype="uint8",
            crs=None if crs == LOCAL else crs,
            transform=from_origin(grid.west, grid.north, grid.cell, grid.cell),
            compress="deflate",
            zlevel=9,
            interleave="band",  # the transparency by itself takes next to nothing
            tiled=True,
        ) as target:
            target.update_tags(TIFFTAG_SOFTWARE=MARK)
            target.write(grey, 1)
            target.write(alpha, 2)
            target.colorinterp = (ColorInterp.gray, ColorInterp.alpha)
        write_whole(path, memory.read())


def mean_spacing(tiles: Sequence[TileInfo]) -> float:
    """Spacing of the points seen from above, metres: that of a square grid as dense as the tiles' extents are."""
    area = sum((tile.high[0] - tile.low[0]) * (tile.high[1] - tile.low[1]) for tile in tiles)
    points = sum(tile.points for tile in tiles)
    return math.sqrt(area / points) if points > 0 else math.inf


def run_relief(survey: Survey, prefix: Path, feedback: Feedback) -> dict[str, Any]:
    """Step ``relief``: one GeoTIFF per epoch, named ``<prefix>_<label>.tif``.

    Raises
    ------
    InputError
        A tile cannot be read.
    OutputError
        A file cannot be written, or is another image than an earlier relief.
    """
    targets = {epoch.label: prefix.with_name(f"{prefix.name}_{safe_name(epoch.label)}.tif") for epoch in survey.epochs}
    check_targets([(target, f"epoch {label}") for label, target in targets.items()], survey.files)
    for target in targets.values():
        check_own(target, (MARK,))
    if not prefix.absolute().parent.is_dir():
        raise OutputError("cannot be written: its folder does not exist", source=prefix, remedy=f"Create {prefix.absolute().parent} first.")
    plans = plan_survey(survey, feedback.part(0, 0.05))
    total = sum(len(plan.tiles) for plan in plans)
    height = max(unit.type.height for unit in survey.units)
    read = 0
    files = []
    for plan in plans:
        grid = empty_grid(_corner(plan.tiles, np.min), _corner(plan.tiles, np.max), height, mean_spacing(plan.tiles))
        for tile in plan.tiles:
            feedback.check()
            cloud = read_points([tile], survey.crs, is_cancelled=feedback.is_cancelled)
            grid.add(cloud.xyz + cloud.origin)
            read += 1
            feedback.progress(0.05 + 0.95 * read / total, f"relief, tile {read} of {total}")
        path = targets[plan.epoch.label]
        write_relief(path, grid, survey.crs)
        files.append(str(path))
    return {"files": files, "epochs": [plan.epoch.label for plan in plans]}


def _corner(tiles: Sequence[TileInfo], pick: Callable[..., FloatArray]) -> tuple[float, ...]:
    """Lower (``np.min``) or upper (``np.max``) corner of all tiles."""
    return tuple(pick([tile.low if pick is np.min else tile.high for tile in tiles], axis=0).tolist())
