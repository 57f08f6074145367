"""A part of an epoch's points, enough to tell what the whole shows: places where much surface stands, read densely."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ..common.arrays import FloatArray
from ..data.tiles import TileInfo, Window, read_points, used_points
from ..segmentation.unit_size import WINDOW_SIDE, dense_windows

MOST_POINTS = 4_000_000
"""Clouds up to this size are read whole."""
MOST_READ = 60_000_000
"""Points decompressed at most to see where surface stands: whole tiles, evenly spread over the epoch."""
SUPPOSED_HEIGHT = 2.2
"""Metres; large clouds are surveys of the coast, whose dense places are looked for at the scale of customary units."""
PLACES = 6


def sample_points(
    tiles: Sequence[TileInfo], crs: str, *, is_cancelled: Callable[[], bool] = lambda: False
) -> tuple[FloatArray, FloatArray]:
    """Points (n, 3) of an epoch in a reduced frame and the origin (3,) of that: all, or those of its densest places.

    Parameters
    ----------
    tiles
        Headers read in the CRS ``crs``.
    crs
        As for :func:`read_points`.
    """
    if sum(tile.held for tile in tiles) <= MOST_POINTS:
        cloud = read_points(tiles, crs, is_cancelled=is_cancelled)
        return cloud.xyz, cloud.origin
    coarse, chosen = _overview([tile for tile in tiles if tile.used], crs, is_cancelled)
    height = SUPPOSED_HEIGHT
    parts: list[FloatArray] = []
    origin = np.floor(coarse.min(axis=0))
    for place in dense_windows(coarse - origin, height, PLACES):
        low = coarse[place, :2].min(axis=0)
        # wide enough for the largest units
        side = 3 * WINDOW_SIDE * height
        middle = low + 0.5 * WINDOW_SIDE * height
        window = Window(middle[0] - side / 2, middle[1] - side / 2, middle[0] + side / 2, middle[1] + side / 2)
        cloud = read_points(chosen, crs, window=window, origin=origin, is_cancelled=is_cancelled)
        parts.append(_at_most(cloud.xyz, MOST_POINTS // PLACES))
    return np.unique(np.vstack(parts), axis=0), origin


def _overview(tiles: Sequence[TileInfo], crs: str, is_cancelled: Callable[[], bool]) -> tuple[FloatArray, list[TileInfo]]:
    """Every so many of the points of tiles spread over the epoch, and these tiles."""
    total = sum(tile.held for tile in tiles)
    step = max(1, round(total / MOST_READ))
    chosen = list(tiles)[::step] if len(tiles) > step else list(tiles[:1])
    stride = max(1, sum(tile.held for tile in chosen) // (MOST_POINTS // 2))
    return np.vstack([xyz[::stride] for tile in chosen for xyz in used_points(tile, crs, is_cancelled)]), chosen


def _at_most(points: FloatArray, most: int) -> FloatArray:
    return points if len(points) <= most else points[:: -(-len(points) // most)]
