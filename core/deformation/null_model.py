"""What displacements of units at rest look like: covariances, tails, and how many units moved, learned from the displacements themselves.

The empirical null distribution of Efron (2004, JASA 99): stable units follow t with scaled covariances and a floor, moved ones a broad
second component.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import minimize
from scipy.special import digamma, fdtrc, gammaln

from ..common.arrays import FloatArray
from ..common.kernels import kernel

NORMAL_TAIL, LEAST_TAIL = 200.0, 3.0
"""Degrees of freedom beyond which t is normal, and fewest that are believed: with fewer, t has no variance worth stating."""
USUAL, USUAL_WITHIN = np.array([0.0, -0.7, math.log(15), -1.7]), np.array([0.7, 1.0, 0.8, 1.0])
"""Priors, mean and standard deviation: logarithms of the factor, of the floor over the formal deviations, and of the degrees of freedom
of the tails, and log odds of a unit that moved."""
FARTHEST = 12.0
"""Standard deviations from what is usual up to which the search goes: its steps may be so long that exponentials overflow."""
STARTS = ([0.35, -0.7, math.log(15), -1.7], [1.2, 0.5, math.log(15), -1.7], [0.35, 2.5, math.log(15), -1.7])
"""Where the search begins: covariances as usual, far too small, and far below the floor."""


@dataclass(frozen=True, eq=False)
class NullModel:
    """What displacements of stable units look like: covariance factor ** 2 * C + floor ** 2 * I with t tails of ``tail`` degrees.

    ``moved_share`` is the share of units that the broad component describes, ``count`` the number of units it was estimated from.
    """

    factor: float
    floor: float
    tail: float
    moved_share: float
    count: int

    def covariance(self, covariances: FloatArray) -> FloatArray:
        """(..., 3, 3) effective covariances."""
        return np.asarray(self.factor**2 * covariances + self.floor**2 * np.eye(3))

    def covariance_of_moved(self, covariances: FloatArray, noise: FloatArray, share: float) -> FloatArray:
        """(..., 3, 3) effective covariances of a unit that moved (``share`` 1; 0 at rest).

        At rest both epochs show the same parts of a surface, whose deviations cancel further than the adjustment says. A factor below one
        holds for a unit that moved or turned as far as its covariances are of ``noise`` alone.
        """
        return self.covariance(covariances) + share * max(1.0 - self.factor**2, 0.0) * (covariances - noise)

    @property
    def spread(self) -> float:
        """Variance of the t distribution over its squared scale: what a stated standard deviation has to hold beyond ``covariance``."""
        return self.tail / (self.tail - 2)

    def p_value(self, statistics: FloatArray) -> FloatArray:
        """Of quadratic forms of three components."""
        return f_p_value(statistics, self.tail)


def f_p_value(statistics: FloatArray, tail: float | FloatArray) -> FloatArray:
    """p-values of quadratic forms of three components whose variance has ``tail`` degrees of freedom."""
    return np.asarray(fdtrc(3, tail, np.asarray(statistics) / 3))


def calibrate(residuals: FloatArray, covariances: FloatArray, scale: float, spread: FloatArray | None = None) -> NullModel:
    """Maximum a posteriori factor, floor and tails of the displacements of stable units, among moved ones.

    Parameters
    ----------
    residuals, covariances
        (n, 3), (n, 3, 3) displacements less the common part, and their formal covariance.
    scale
        H in metres; moved units are taken from a Cauchy distribution of that order.
    spread
        (n, 3, 3) covariance of the common part that was subtracted, not to be scaled; None for zero.

    The priors are weak and only matter for a handful of units: factor 1 within a factor of two, tails of about 15 degrees of
    freedom, floor of the order of the formal standard deviations.
    """
    n = len(residuals)
    if n == 0:
        return NullModel(1.0, 0.0, NORMAL_TAIL, 0.0, 0)
    values, vectors = np.linalg.eigh(covariances)
    values = np.maximum(values, 1e-18)
    squares = np.einsum("nij,ni->nj", vectors, residuals) ** 2
    extra = np.zeros_like(values) if spread is None else np.einsum("nij,nik,nkj->nj", vectors, spread, vectors)
    typical, broad = float(np.sqrt(np.median(values))), 0.02 * scale

    def target(parameters: FloatArray) -> tuple[float, FloatArray]:
        factor, floor, tail, odds = parameters
        degrees, moved = math.exp(tail), 1 / (1 + math.exp(-odds))
        constant = gammaln((degrees + 3) / 2) - gammaln(degrees / 2) - 1.5 * math.log(degrees * math.pi)
        variances = math.exp(2 * factor), (typical * math.exp(floor)) ** 2
        total, *slopes = _log_likelihood(squares, values, extra, *variances, degrees, float(constant), moved, broad)
        slopes[2] += slopes[4] * (0.5 * digamma((degrees + 3) / 2) - 0.5 * digamma(degrees / 2) - 1.5 / degrees)
        away = (parameters - USUAL) / USUAL_WITHIN
        return 0.5 * float(away @ away) - total, away / USUAL_WITHIN - np.array(slopes[:4]) * (2.0, 2.0, degrees, 1.0)

    bounds = np.column_stack([USUAL - FARTHEST * USUAL_WITHIN, USUAL + FARTHEST * USUAL_WITHIN])
    bounds[2, 0] = math.log(LEAST_TAIL)
    best = min((minimize(target, start, jac=True, method="L-BFGS-B", bounds=bounds) for start in STARTS), key=lambda found: found.fun)
    factor, floor, tail, odds = best.x
    return NullModel(
        float(math.exp(factor)),
        float(typical * math.exp(floor)),
        float(min(max(math.exp(tail), LEAST_TAIL), NORMAL_TAIL)),
        float(1 / (1 + math.exp(-odds))),
        n,
    )


@kernel()
def _log_likelihood(
    squares: Any, values: Any, extra: Any, scaled: float, added: float, tail: float, constant: float, moved: float, broad: float
) -> Any:
    """Of (n, 3) squared residuals along the axes of their covariances: variances ``scaled * values + added + extra``, t of ``tail``
    degrees of freedom, among a share ``moved`` of units that Cauchy's distribution of scale ``broad`` describes.

    ``constant`` is that of the density of t. Beside the likelihood its slopes: by the logarithms of the first two variances, by the
    degrees of freedom but for the constant, by the log odds of ``moved``, and by the constant.
    """
    of_null = constant + math.log1p(-moved)
    of_moved = math.log(moved) - 2.0 * math.log(math.pi) - 3.0 * math.log(broad)
    total, by_scaled, by_added, by_tail, by_odds, at_rest = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for n in range(len(squares)):
        form, far, volume, scaled_form, added_form, scaled_volume, added_volume = 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0
        for k in range(3):
            weight = 1.0 / (scaled * values[n, k] + added + extra[n, k])
            own = squares[n, k] * weight
            form += own
            far += squares[n, k]
            volume *= weight
            scaled_form += own * weight * scaled * values[n, k]
            added_form += own * weight * added
            scaled_volume += weight * scaled * values[n, k]
            added_volume += weight * added
        null = of_null - (tail + 3.0) / 2.0 * math.log1p(form / tail) + 0.5 * math.log(volume)
        broader = of_moved - 2.0 * math.log1p(far / broad**2)
        total += max(null, broader) + math.log1p(math.exp(-abs(null - broader)))
        rests = 1.0 / (1.0 + math.exp(broader - null))
        steep = (tail + 3.0) / 2.0 / (tail + form)
        at_rest += rests
        by_scaled += rests * (steep * scaled_form - 0.5 * scaled_volume)
        by_added += rests * (steep * added_form - 0.5 * added_volume)
        by_tail += rests * (steep * form / tail - 0.5 * math.log1p(form / tail))
        by_odds += (1.0 - rests) * (1.0 - moved) - rests * moved
    return total, by_scaled, by_added, by_tail, by_odds, at_rest
