"""Types of the arrays that the numeric code passes around; shapes and units stand in the docstrings that use them."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]


def corners(points: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """(k,) lowest and highest coordinates of (n, k) points, n > 0; one column at a time, as numpy takes 25 times as long along axis 0."""
    return np.array([column.min() for column in points.T]), np.array([column.max() for column in points.T])


def in_box(points: NDArray[Any], low: Sequence[float] | FloatArray, high: Sequence[float] | FloatArray) -> BoolArray:
    """(n,) whether (n, k) points lie in a box from (k,) ``low`` to ``high``, both included; one column at a time, as there."""
    inside = np.ones(len(points), dtype=np.bool_)
    for column, least, most in zip(points.T, low, high, strict=True):
        inside &= (column >= least) & (column <= most)
    return inside


@lru_cache(maxsize=256)
def upper_triangle(size: int) -> tuple[IntArray, IntArray]:
    """Rows and columns of the upper half of a (size, size) matrix, row by row: ``numpy.triu_indices``, made once for each size."""
    rows, columns = np.triu_indices(size)
    for index in (rows, columns):
        index.setflags(write=False)
    return rows, columns
