"""One step of the adjustment: the normal equations solved and applied."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from ..common.arrays import BoolArray, FloatArray
from ..common.kernels import compiled_for, kernel
from ..common.positive_definite import factorise, solve_factorised
from .adjustment_state import Prior, UnitState
from .condition_records import NormalEquations

DETERMINED = 0.5
"""A direction in parameter space counts as determined if its standard deviation is below this, in radians or leg lengths."""


class Step(NamedTuple):
    """Squared length of a step in standard deviations, and (12,) what it changed."""

    gain: float
    change: FloatArray


@kernel()
def _turn(rotation: Any, x: float, y: float, z: float) -> None:
    """rotation @ exp([(x, y, z)]x) in place, by Rodrigues' formula."""
    angle = math.sqrt(x * x + y * y + z * z)
    # sin(a)/a and (1 - cos a)/a^2 without loss of digits for small angles
    first = math.sin(angle) / angle if angle > 1e-6 else 1.0 - angle * angle / 6.0
    half = math.sin(0.5 * angle) / (0.5 * angle) if angle > 1e-6 else 1.0 - angle * angle / 24.0
    second = 0.5 * half * half
    t00, t01, t02 = 1.0 - second * (y * y + z * z), second * x * y - first * z, second * x * z + first * y
    t10, t11, t12 = second * x * y + first * z, 1.0 - second * (x * x + z * z), second * y * z - first * x
    t20, t21, t22 = second * x * z - first * y, second * y * z + first * x, 1.0 - second * (x * x + y * y)
    for a in range(3):
        r0, r1, r2 = rotation[a, 0], rotation[a, 1], rotation[a, 2]
        rotation[a, 0] = r0 * t00 + r1 * t10 + r2 * t20
        rotation[a, 1] = r0 * t01 + r1 * t11 + r2 * t21
        rotation[a, 2] = r0 * t02 + r1 * t12 + r2 * t22


@kernel()
def _step(normal: Any, rhs: Any, free: Any, prior: Any, state: Any, change: Any) -> Any:
    """Make one Gauss-Newton step in place, no longer than a leg's width and kept in ``change``; returns its squared length in standard
    deviations.

    The equations are damped at what counts as undetermined: that only holds still what the points do not determine, and has no effect at
    convergence. Scaled so, they are positive definite, and are solved by Cholesky's factors.
    """
    nominal, prior_weights, scaling = prior.nominal, prior.weights, prior.scaling
    centre, rotation, shape, leg_errors = state.centre, state.rotation, state.shape, state.leg_errors
    chosen = np.empty(12, dtype=np.int64)
    m = 0
    for p in range(12):
        change[p] = 0.0
        if free[p]:
            chosen[m] = p
            m += 1
    factor = np.zeros((m, m))
    along, inner = np.zeros(m), np.zeros(m)
    for a in range(m):
        p = chosen[a]
        value = rhs[p]
        if 6 <= p < 8:
            value += prior_weights[p] * (nominal[p - 6] - shape[p - 6])
        elif p >= 8:
            value -= prior_weights[p] * leg_errors[p - 8]
        along[a] = scaling[p] * value
        inner[a] = along[a]
        for b in range(a + 1):
            q = chosen[b]
            total = normal[p, q] * scaling[p] * scaling[q]
            if a == b:
                total += prior_weights[p] * scaling[p] * scaling[p] + 1.0 / DETERMINED**2
            factor[a, b] = total
    factorise(factor)
    solve_factorised(factor, inner)
    gain = 0.0
    for a in range(m - 1, -1, -1):
        gain += along[a] * inner[a]
    for a in range(m):
        change[chosen[a]] = scaling[chosen[a]] * inner[a]
    longest = max(
        math.sqrt(change[0] ** 2 + change[1] ** 2 + change[2] ** 2) / (0.25 * nominal[0]),
        math.sqrt(change[3] ** 2 + change[4] ** 2 + change[5] ** 2) / 0.15,
        abs(change[6]) / (0.1 * nominal[0]),
        abs(change[7]) / 0.05,
        1.0,
    )
    for p in range(12):
        change[p] /= longest
    for a in range(3):
        centre[a] += rotation[a, 0] * change[0] + rotation[a, 1] * change[1] + rotation[a, 2] * change[2]
    _turn(rotation, change[3], change[4], change[5])
    # a cone that closes before the end of its leg has no meaning
    shape[0] = max(shape[0] + change[6], 0.2 * nominal[0])
    shape[1] = min(max(shape[1] + change[7], 0.0), 0.95 * shape[0] / prior.leg_length)
    for k in range(4):
        leg_errors[k] += change[8 + k]
    return gain


@lru_cache
def _compiled() -> Callable[..., float]:
    """:func:`_step` for arrays in C order."""
    return compiled_for(
        _step, np.zeros((12, 12)), np.zeros(12), np.zeros(12, dtype=np.bool_), Prior.empty(), UnitState.empty(), np.zeros(12)
    )


def make_step(equations: NormalEquations, free: BoolArray, prior: Prior, state: UnitState) -> Step:
    """Make one Gauss-Newton step in the (12,) ``free`` unknowns: the arrays of ``state`` change."""
    change = np.empty(12)
    return Step(_compiled()(equations.normal, equations.rhs, free, prior, state, change), change)
