"""Scale of the residuals: from the weights of the adjustment, or from a quantile of their sizes while the pose is rough."""

from __future__ import annotations

import math
from functools import lru_cache
from statistics import NormalDist
from typing import Any

import numpy as np

from ..common.arrays import IntArray
from ..common.kernels import kernel
from .condition_records import PointStates
from .residual_weights import FULL_WEIGHT, NO_WEIGHT, SCALE_NARROWING


def _weighted_square(scale: float) -> float:
    """Weighted mean square of a standard normal variable under the weights of the scale, with the window opened by a factor."""
    u = np.linspace(0, NO_WEIGHT * scale, 2001)
    v = np.clip((u / (scale * SCALE_NARROWING) - FULL_WEIGHT) / (NO_WEIGHT - FULL_WEIGHT), 0, 1)
    mass = (1 - v * v) ** 2 * np.exp(-0.5 * u * u)
    return float(np.sum(mass * u * u) / np.sum(mass))


SCALE_CONSISTENCY = _weighted_square(1.0)
"""Makes the scale consistent for clean data."""
SCALE_CONTRACTION = math.sqrt(_weighted_square(1.01) / SCALE_CONSISTENCY) / 0.01 - 100
"""Share of its error that a scale keeps when it is refined once, for clean data."""


@kernel()
def _sizes(residuals: Any, biases: Any, sds: Any, given: Any) -> Any:
    """Sizes of the standardised residuals of all points but those left out by ``given``, inf for points that belong to no part."""
    n = len(residuals)
    sizes = np.empty(n)
    count = 0
    for i in range(n):
        if len(given) == n and given[i] < 0:
            continue
        size = abs((residuals[i] - biases[i]) / sds[i])
        sizes[count] = math.inf if math.isnan(size) else size
        count += 1
    return sizes[:count]


@kernel()
def _share_within(residuals: Any, biases: Any, sds: Any, at_tip: Any, given: Any, limit: Any) -> Any:
    n = len(residuals)
    within = counted = kept = 0
    for i in range(n):
        if len(given) == n and given[i] < 0:
            continue
        kept += 1
        if not at_tip[i]:
            counted += 1
            within += abs(residuals[i] - biases[i]) < limit * sds[i]
    return within / max(counted, kept // 2, 1)


@lru_cache
def _size_at(share: float) -> float:
    """Size below which a share of standard normal variables lies."""
    return NormalDist().inv_cdf(0.5 * (1 + share))


def quantile_scale(points: PointStates, given: IntArray, share: float) -> float:
    """Scale of the residuals of all points, from the quantile of their sizes at ``share``."""
    # arrays one by one: numba takes longer to look through a record of nine than the loop takes
    u = _sizes(points.residuals, points.biases, points.sds, given)
    u.partition(int(share * len(u)))
    return float(u[int(share * len(u))]) / _size_at(share)


def share_within(points: PointStates, given: IntArray, limit: float) -> float:
    """Share of the points whose standardised residual is below a limit; those left out by ``given`` do not count, nor those in tips if
    they are not the most."""
    return float(_share_within(points.residuals, points.biases, points.sds, points.at_tip, given, limit))
