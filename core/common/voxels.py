"""Thinning of clouds by voxels."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from .arrays import FloatArray, IntArray, corners
from .kernels import kernel

SPREADING = 0x1E3779B97F4A7C15
"""Odd factor by which neighbouring voxels fall far apart in a table (Knuth, 1998, The Art of Computer Programming 3, 6.4)."""


def thin(points: FloatArray, voxel: float) -> tuple[FloatArray, IntArray]:
    """Mean point of every occupied voxel (m, 3), in lexicographic voxel order, and for each of the n points its voxel."""
    if not len(points):
        return np.zeros((0, 3)), np.zeros(0, dtype=np.int64)
    points = np.ascontiguousarray(points, dtype=np.float64)
    scaled = points / voxel
    low, high = (np.floor(corner).astype(np.int64) for corner in corners(scaled))
    source, found = np.empty(len(points), dtype=np.int64), np.empty(len(points), dtype=np.int64)
    slots = np.full(1 << (2 * len(points)).bit_length(), -1, dtype=np.int32)
    order = np.argsort(found[: _number(scaled, (low, high - low + 1), slots, found, source)])
    rank = np.empty(len(order), dtype=np.int64)
    rank[order] = np.arange(len(order))
    mean, weight = np.zeros((len(order), 3)), np.zeros(len(order))
    _sum_up(points, rank, source, mean, weight)
    mean /= weight[:, None]
    return mean, source


@kernel(releases=True)
def _number(scaled: Any, box: Any, slots: Any, found: Any, source: Any) -> int:
    """Numbers of voxels as they come, (n,) into ``source``, from (n, 3) points over their edge; the place of each in the ``box`` of all,
    its first corner and how many there are along each axis, once into ``found``. Returns how many there are.

    ``slots`` holds -1, a power of two of them, at least twice as many as there are points.
    """
    count, mask = 0, len(slots) - 1
    low, size = box
    for i in range(len(scaled)):
        x, y, z = math.floor(scaled[i, 0]) - low[0], math.floor(scaled[i, 1]) - low[1], math.floor(scaled[i, 2]) - low[2]
        place = (x * size[1] + y) * size[2] + z
        slot = ((place * SPREADING) >> 24) & mask
        while slots[slot] >= 0 and found[slots[slot]] != place:
            slot = (slot + 1) & mask
        if slots[slot] < 0:
            slots[slot], found[count] = count, place
            count += 1
        source[i] = slots[slot]
    return count


@kernel(releases=True)
def _sum_up(points: Any, rank: Any, source: Any, sums: Any, weight: Any) -> None:
    """Sums of (n, 3) points by voxel and their numbers, added to ``sums`` (m, 3) and ``weight`` (m,); ``source`` is ranked in place."""
    for i in range(len(points)):
        k = rank[source[i]]
        source[i] = k
        weight[k] += 1.0
        for m in range(3):
            sums[k, m] += points[i, m]
