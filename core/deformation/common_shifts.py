"""Shifts that most units of two epochs share: of a frame that errs a little, or of another height system or frame altogether."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray

MOST_UNITS = 400
"""Units of each epoch that are compared; an even choice of them where there are more."""
MAX_COMMON_SHIFT_HEIGHTS = 1.5
"""Length up to which a shift is the error of a frame."""
COMMON_HEIGHTS, NEAR_HEIGHTS = 0.06, 0.1
"""Differences of centres that agree within this, in unit heights, are one shift: a small one of the frame, and one of any length."""
LEAST_UNITS, COMMON_SHARE, LEAST_SHARE = 3, 0.3, 0.5
"""Units, and shares of the smaller epoch's, that must have a small one, and one of any length."""


def common_shift(before: FloatArray, after: FloatArray, height: float) -> FloatArray:
    """(3,) shift in metres shared by most units of two epochs: the densest place of all differences of centres.

    Units that moved on their own, and units without a partner, spread their differences and do not matter.
    """
    if not len(before) or not len(after):
        return np.zeros(3)
    near = cKDTree(after).query_ball_point(before, MAX_COMMON_SHIFT_HEIGHTS * height)
    differences = np.array([after[j] - before[i] for i, js in enumerate(near) for j in js]).reshape(-1, 3)
    if len(differences) < LEAST_UNITS:
        return np.zeros(3)
    members = _densest(differences, COMMON_HEIGHTS * height)
    # a handful of agreeing differences among many units is chance, not a shift of the frame
    if len(members) < max(LEAST_UNITS, COMMON_SHARE * min(len(before), len(after))):
        return np.zeros(3)
    return np.asarray(np.median(members, axis=0))


def whole_shift(before: FloatArray, after: FloatArray, height: float) -> FloatArray | None:
    """(3,) shift in metres, of any length, that brings at least half of the units of two epochs together; None where there is none.

    Parameters
    ----------
    before, after
        (n, 3) and (m, 3) centres of units.
    height
        H in metres.
    """
    first, second = (points[:: max(1, -(-len(points) // MOST_UNITS))] for points in (before, after))
    least = max(LEAST_UNITS, LEAST_SHARE * min(len(first), len(second)))
    if min(len(first), len(second)) < LEAST_UNITS:
        return None
    differences = (second[None, :, :] - first[:, None, :]).reshape(-1, 3)
    members = _densest(differences, NEAR_HEIGHTS * height)
    return np.asarray(np.median(members, axis=0)) if len(members) >= least else None


def _densest(differences: FloatArray, radius: float) -> FloatArray:
    """(m, 3) differences around the one with most others within a radius; of several such the shortest."""
    tree = cKDTree(differences)
    support = np.asarray(tree.query_ball_point(differences, radius, return_length=True))
    best = np.flatnonzero(support == support.max())
    start = differences[best[np.argmin(np.linalg.norm(differences[best], axis=1))]]
    return np.asarray(differences[tree.query_ball_point(start, radius)])
