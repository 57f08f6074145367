"""A part of an epoch's points, enough to tell what the whole shows: places where much surface stands, spread over the cloud."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from ..common.arrays import FloatArray
from ..data.repeated_points import by_place
from ..data.tiles import TileInfo, Window, read_points, used_points
from ..segmentation.unit_size import WINDOW_SIDE, dense_windows

MOST_POINTS = 1_500_000
"""Clouds up to this size are read whole; a read point takes some hundred bytes until it stands in its order."""
MOST_OF_OVERVIEW = 1_000_000
"""Points of larger ones that show where surface stands: every so many of the cloud."""
MOST_READ = 60_000_000
"""Points decompressed at most to see where surface stands: whole tiles, evenly spread over the epoch."""
SUPPOSED_HEIGHT = 2.2
"""Metres; large clouds are surveys of the coast, whose dense places are looked for at the scale of customary units."""
PLACES = 8
"""Parts of a large cloud at most, of equal length, of each of which one place is read: the one where most surface stands."""
MOST_OF_PLACES = 2_000_000
"""Points of all places that are as wide as they may be; denser ones are narrower, and past their least width every so many are taken."""
MOST_HELD = 3_000_000
"""Points that are held from the first look to the second one, rather than decompressed again."""
LEAST_SIDE, MOST_SIDE = 1.5, 3.0
"""Side of a place in squares of a trial (:data:`WINDOW_SIDE`): that units three times as large as supposed fill one too."""


def sample_points(
    tiles: Sequence[TileInfo],
    crs: str,
    height: float = SUPPOSED_HEIGHT,
    *,
    whole: Callable[[], FloatArray | None] = lambda: None,
    is_cancelled: Callable[[], bool] = lambda: False,
) -> tuple[FloatArray, FloatArray]:
    """Points (n, 3) of an epoch in a reduced frame and the origin (3,) of that: all, or those of dense places, however long it is.

    Parameters
    ----------
    tiles
        Headers read in the CRS ``crs``.
    crs
        As for :func:`read_points`.
    height
        Of the units that are supposed to be there, metres; places are up to nine times as wide, so that larger units are whole there too.
    whole
        Asked first for the points (n, 3) of a cloud that is read whole: somebody may have read them, as :func:`read_points` does.
    is_cancelled
        Asked between chunks.
    """
    if sum(tile.held for tile in tiles) <= MOST_POINTS:
        points = whole()
        if points is None:
            cloud = read_points(tiles, crs, is_cancelled=is_cancelled)
            return cloud.xyz, cloud.origin
        origin = np.floor(np.min([tile.low for tile in tiles], axis=0))
        return points - origin, origin
    used = [tile for tile in tiles if tile.used]
    held = {}
    if sum(tile.held for tile in used) <= MOST_HELD:
        held = {tile.path: list(used_points(tile, crs, is_cancelled)) for tile in used}

    def chunks(tile: TileInfo) -> Iterable[FloatArray]:
        return held[tile.path] if held else used_points(tile, crs, is_cancelled)

    chosen, coarse, stride = _overview(used, chunks)
    origin = np.floor(coarse.min(axis=0))
    windows = _dense_places(coarse, stride, height)
    parts: list[list[FloatArray]] = [[] for _ in windows]
    for tile in chosen:
        near = [k for k, window in enumerate(windows) if window.meets(tile.low, tile.high)]
        for xyz in chunks(tile) if near else ():
            rest = xyz
            for k in near:
                inside = windows[k].contains(rest)
                parts[k].append(rest[inside] - origin)
                rest = rest[~inside]
    # in an order that does not depend on the tiling, and what two tiles hold once
    return np.vstack([_at_most(_once_each(np.vstack(own)), MOST_OF_PLACES // len(parts)) for own in parts]), origin


def _once_each(points: FloatArray) -> FloatArray:
    """Points (n, 3) by easting, northing and height, those that occur several times once."""
    alike = np.zeros(len(points))
    ordered = points[by_place(points, alike.astype(np.uint16), alike)]
    another = np.ones(len(points), dtype=np.bool_)
    another[1:] = False
    # column by column: to ask row by row takes several times as long
    for column in ordered.T:
        another[1:] |= column[1:] != column[:-1]
    return np.asarray(ordered[another])


def _dense_places(points: FloatArray, stride: int, height: float) -> list[Window]:
    """Squares that hold most surface, one in each part of (n, 3) points, every ``stride``-th of the cloud, along their longer extent."""
    extent = np.ptp(points[:, :2], axis=0)
    along = points[:, int(np.argmax(extent))]
    side = WINDOW_SIDE * height
    count = int(np.clip(extent.max() / (MOST_SIDE * side), 1, PLACES))
    part = np.minimum((along - along.min()) / extent.max() * count, count - 1).astype(np.int64)
    windows = []
    for k in np.unique(part):
        mine = points[part == k] - points[0]
        for place in dense_windows(mine, height, 1):
            e, n = mine[place, :2].min(axis=0) + points[0, :2] + 0.5 * side
            squares = MOST_OF_PLACES / count / (len(place) * stride)
            half = 0.5 * side * float(np.clip(np.sqrt(squares), LEAST_SIDE, MOST_SIDE))
            windows.append(Window(e - half, n - half, e + half, n + half))
    return windows


def _overview(tiles: Sequence[TileInfo], chunks: Callable[[TileInfo], Iterable[FloatArray]]) -> tuple[list[TileInfo], FloatArray, int]:
    """Tiles spread over the epoch, and every so many of their points."""
    total = sum(tile.held for tile in tiles)
    step = max(1, round(total / MOST_READ))
    chosen = list(tiles)[::step] if len(tiles) > step else list(tiles[:1])
    stride = max(1, sum(tile.held for tile in chosen) // MOST_OF_OVERVIEW)
    # copies: a view would keep all points of its chunk in memory
    return chosen, np.vstack([xyz[::stride].copy() for tile in chosen for xyz in chunks(tile)]), stride


def _at_most(points: FloatArray, most: int) -> FloatArray:
    return points if len(points) <= most else points[:: round(len(points) / most)].copy()
