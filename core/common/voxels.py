"""Thinning of clouds by voxels."""

from __future__ import annotations

import numpy as np

from .arrays import FloatArray, IntArray, corners


def thin(points: FloatArray, voxel: float) -> tuple[FloatArray, IntArray]:
    """Mean point of every occupied voxel (m, 3), in lexicographic voxel order, and for each of the n points its voxel."""
    if not len(points):
        return np.zeros((0, 3)), np.zeros(0, dtype=np.int64)
    key = np.floor(points / voxel).astype(np.int64)
    low, high = corners(key)
    key -= low
    size = high - low + 1
    flat = (key[:, 0] * size[1] + key[:, 1]) * size[2] + key[:, 2]
    _, source = np.unique(flat, return_inverse=True)
    weight = np.bincount(source)
    mean = np.column_stack([np.bincount(source, weights=points[:, k]) for k in range(3)]) / weight[:, None]
    return mean, source.astype(np.int64)
