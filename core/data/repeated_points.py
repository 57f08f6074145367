"""Points that several tiles of one cloud hold: where tiles overlap, or were exported twice."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..common.arrays import BoolArray, FloatArray


def second_copies(
    xyz: FloatArray, source_id: NDArray[np.uint16], gps_time: FloatArray, tile: NDArray[np.int64], resolution: float
) -> BoolArray:
    """(n,) points that stand in an earlier tile too: of the same source and time, and at the same place but for rounding."""
    again = np.zeros(len(xyz), dtype=np.bool_)
    numbers = np.unique(tile)
    if len(numbers) < 2:
        return again
    reach = 1.02 * resolution + 1e-9
    boxes = {k: (xyz[tile == k].min(axis=0) - reach, xyz[tile == k].max(axis=0) + reach) for k in numbers}
    shared = np.zeros(len(xyz), dtype=np.bool_)
    for k in numbers:
        own = np.flatnonzero(tile == k)
        for low, high in (boxes[other] for other in numbers if other != k):
            shared[own] |= ((xyz[own] >= low) & (xyz[own] <= high)).all(axis=1)
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
