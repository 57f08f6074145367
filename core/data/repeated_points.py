"""Points that several tiles of one cloud hold, where tiles overlap or were exported twice, and an order that puts copies side by side."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..common.arrays import BoolArray, FloatArray, IntArray, corners, in_box


def by_place(xyz: FloatArray, source_id: NDArray[np.uint16], gps_time: FloatArray) -> IntArray:
    """(n,) order of points by easting, northing, height, source and time: one that does not hang on the tiles they came from.

    The same as ``np.lexsort`` of all five, in a third of the time: few points share easting and northing.
    """
    if not len(xyz):
        return np.empty(0, dtype=np.int64)
    low, high = corners(xyz[:, :2])
    # whole numbers are sorted in vector registers: easting in the upper bits, northing in the lower ones
    steps = np.floor((xyz[:, :2] - low) / np.maximum(high - low, 1e-300) * (2.0**31 - 1)).astype(np.int64)
    order = np.argsort((steps[:, 0] << 32) | steps[:, 1])
    x, y = xyz[order, 0], xyz[order, 1]
    same = (x[1:] == x[:-1]) & (y[1:] == y[:-1])
    if ((x[1:] < x[:-1]) | ((x[1:] == x[:-1]) & (y[1:] < y[:-1]))).any():
        # eastings that differ by less than a step
        return np.lexsort((gps_time, source_id, xyz[:, 2], xyz[:, 1], xyz[:, 0]))
    tied = np.zeros(len(xyz), dtype=np.bool_)
    tied[1:] |= same
    tied[:-1] |= same
    again = np.sort(order[tied])
    order[tied] = again[np.lexsort((gps_time[again], source_id[again], xyz[again, 2], xyz[again, 1], xyz[again, 0]))]
    return order


def second_copies(
    xyz: FloatArray, source_id: NDArray[np.uint16], gps_time: FloatArray, tile: NDArray[np.int64], resolution: float
) -> BoolArray:
    """(n,) points that stand in an earlier tile too: of the same source and time, and at the same place but for rounding.

    Points of one tile follow one another, in the order of the (n,) tiles' numbers.
    """
    again = np.zeros(len(xyz), dtype=np.bool_)
    numbers = np.unique(tile)
    if len(numbers) < 2:
        return again
    reach = 1.02 * resolution + 1e-9
    parts = [slice(*np.searchsorted(tile, (k, k + 1))) for k in numbers]
    boxes = [(low - reach, high + reach) for low, high in (corners(xyz[part]) for part in parts)]
    shared = np.zeros(len(xyz), dtype=np.bool_)
    for k, part in enumerate(parts):
        own_low, own_high = boxes[k]
        for low, high in (*boxes[:k], *boxes[k + 1 :]):
            if (low <= own_high).all() and (high >= own_low).all():
                shared[part] |= in_box(xyz[part], low, high)
    chosen = np.flatnonzero(shared)
    chosen = chosen[np.lexsort((tile[chosen], gps_time[chosen], source_id[chosen]))]
    if not len(chosen):
        return again
    new = (np.diff(gps_time[chosen]) != 0) | (np.diff(source_id[chosen].astype(np.int64)) != 0)
    pulse = np.concatenate([[0], np.cumsum(new)])
    first, last = np.searchsorted(pulse, pulse, "left"), np.searchsorted(pulse, pulse, "right") - 1
    doubtful = tile[chosen[first]] != tile[chosen[last]]
    chosen, pulse = chosen[doubtful], pulse[doubtful]
    if not len(chosen):
        return again
    # pulses are put apart by a fourth coordinate, so that only points of the same one are compared
    tree = cKDTree(np.column_stack([xyz[chosen], 10 * reach * pulse]))
    pairs = chosen[tree.query_pairs(reach, p=np.inf, output_type="ndarray")]
    pairs = pairs[tile[pairs[:, 0]] != tile[pairs[:, 1]]]
    again[np.where(tile[pairs[:, 0]] > tile[pairs[:, 1]], pairs[:, 0], pairs[:, 1])] = True
    return again
