"""How far the points control one another, and what of the unit they show."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..common.kernels import compiled_for, kernel
from ..model.tetrapod import LATERAL
from .adjustment_records import MIN_POINTS, PARAMETERS
from .adjustment_state import Linearisation
from .condition_records import PointStates

NONCENTRALITY = 4.13
"""Square root of the noncentrality of a test of one outlier with alpha = 0.1 % and power 80 % (Baarda, 1968)."""
FEW_POINTS = 4 * len(PARAMETERS)
"""Used points below which robust weights cannot tell bad points, and the stated covariance does not hold."""


class Redundancy(NamedTuple):
    """Redundancy of the points of one adjustment.

    Attributes
    ----------
    numbers, detectable
        (n,) redundancy number and minimal detectable bias, metres.
    influence, weight
        Sums over the points of what the parameters take from them, and of their weights.
    owned
        (4,) used points on each leg's lateral surface.
    square_sd
        Sum of the used points' squared standard deviations for a scale of one.
    """

    numbers: FloatArray
    detectable: FloatArray
    influence: float
    weight: float
    owned: IntArray
    square_sd: float


@kernel()
def _redundancy(whitened: Any, points: Any, scale: Any, numbers: Any, detectable: Any) -> Any:
    """Redundancy number and minimal detectable bias of every used point; returns the sums of their influences and weights, the number of
    used lateral points by leg and the sum of squared standard deviations."""
    weights, legs, parts, sds = points.weights, points.legs, points.parts, points.sds
    owned = np.zeros(4, dtype=np.int64)
    influences = all_weight = squares = 0.0
    for i in range(weights.shape[0]):
        if weights[i] <= 0.0:
            continue
        influence = 0.0
        for m in range(whitened.shape[1]):
            influence += whitened[i, m] * whitened[i, m]
        influence *= weights[i]
        influences += influence
        all_weight += weights[i]
        squares += sds[i] * sds[i]
        owned[legs[i]] += parts[i] == LATERAL
        numbers[i] = min(max(1.0 - influence, 0.0), 1.0)
        detectable[i] = NONCENTRALITY * scale * sds[i] / math.sqrt(numbers[i])
    return influences, all_weight, owned, squares


@lru_cache
def _compiled() -> Callable[..., tuple[float, float, IntArray, float]]:
    """:func:`_redundancy` for arrays in C order."""
    return compiled_for(_redundancy, np.zeros((0, 12)), PointStates.empty(0), 1.0, np.zeros(0), np.zeros(0))


def redundancy(now: Linearisation, whitened: FloatArray) -> Redundancy:
    """Of the points of a final linearisation, with (n, 12) ``whitened`` derivatives of their conditions."""
    n = len(whitened)
    numbers, detectable = np.zeros(n), np.full(n, math.inf)
    influence, weight, owned, square_sd = _compiled()(whitened, now.points, now.scale, numbers, detectable)
    return Redundancy(numbers, detectable, influence, weight, owned, square_sd)


def legs_visible(owned: IntArray, used: float) -> int:
    """Number of legs that own enough of the ``used`` points."""
    return sum(number >= max(MIN_POINTS, 0.01 * used) for number in owned.tolist())


def flags(visible: int, undetermined: int, *, discs_only: bool, few_points: bool) -> tuple[str, ...]:
    """Short statements for the user about what a fit can tell."""
    found = []
    if few_points:
        found.append("few points")
    if discs_only:
        found.append("end discs only")
    if visible == 1:
        found.append("one leg: twist about its axis undetermined")
    elif visible == 2:
        found.append("two legs")
    if undetermined > (1 if visible == 1 else 0):
        found.append(f"{undetermined} directions undetermined")
    return tuple(found)
