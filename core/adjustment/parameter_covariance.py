"""Covariance of the adjusted parameters, and the directions that the points do not determine."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.kernels import compiled_for, kernel
from .adjustment_state import Linearisation, Prior, Problem, UnitState
from .gauss_newton_step import DETERMINED
from .noise_along_surface import row_excess
from .residual_correlation import correlated_part

LOST = math.pi / math.sqrt(3)
"""Standard deviation of a parameter of which nothing is known: in radians, an angle uniform over the full turn."""
EXCESS_SAMPLE = 250
"""Points from which the noise part of the normal equations is taken at least: a smooth sum."""


@dataclass(frozen=True, eq=False, kw_only=True)
class ParameterCovariance:
    """What the last linearisation says about the parameters.

    Attributes
    ----------
    covariance
        (8, 8) e, n, h, omega_e, omega_n, omega_h, r, c; along the axes of the points.
    undetermined
        (k, 8) unit directions, lengths in units of the leg length, that the points do not determine.
    whitened
        (n, 12) derivatives of the points' conditions times the root of the inverse of the normal equations.
    inflation
        Mean factor by which the correlation between residuals makes variances larger.
    """

    covariance: FloatArray
    undetermined: FloatArray
    whitened: FloatArray
    inflation: float


@kernel()
def _scaled(matrix: Any, chosen: Any, scaling: Any) -> Any:
    """Rows and columns of a (12, 12) matrix by number, each times its unknown's scaling."""
    n = len(chosen)
    scaled = np.zeros((n, n))
    for a in range(n):
        for b in range(n):
            scaled[a, b] = matrix[chosen[a], chosen[b]] * scaling[chosen[a]] * scaling[chosen[b]]
    return scaled


@kernel()
def _guarded(correlated: Any, noise_part: Any, free: Any, scaling: Any) -> Any:
    """The correlated part without negative directions, if sampling the pairs of a large cloud has made any that matter."""
    chosen = np.flatnonzero(free)
    values, vectors = np.linalg.eigh(_scaled(correlated, chosen, scaling))
    if values[0] >= 0.0 or values[0] >= -0.5 * np.linalg.eigvalsh(_scaled(noise_part, chosen, scaling))[0]:
        return correlated
    positive = (vectors * np.maximum(values, 0.0)) @ vectors.T
    result = np.zeros((12, 12))
    for a in range(len(chosen)):
        for b in range(len(chosen)):
            result[chosen[a], chosen[b]] = positive[a, b] / (scaling[chosen[a]] * scaling[chosen[b]])
    return result


@kernel()
def _inverse_root(matrix: Any, prior: Any, free: Any) -> Any:
    """(12, m) root whose square is the inverse of a (12, 12) matrix, prior weights added, in the free unknowns, over the m directions that
    are determined; and the (k, 12) unit directions, scaled, that are not."""
    scaling = prior.scaling
    chosen = np.flatnonzero(free)
    n = len(chosen)
    scaled = _scaled(matrix, chosen, scaling)
    for a in range(n):
        scaled[a, a] += prior.weights[chosen[a]] * scaling[chosen[a]] ** 2
    values, vectors = np.linalg.eigh(scaled)
    # in ascending order
    k = np.searchsorted(values, 1.0 / DETERMINED**2, side="right")
    root, undetermined = np.zeros((12, n - k)), np.zeros((k, 12))
    for a in range(n):
        for b in range(k, n):
            root[chosen[a], b - k] = scaling[chosen[a]] * vectors[a, b] / math.sqrt(values[b])
        for b in range(k):
            undetermined[b, chosen[a]] = vectors[a, b]
    return root, undetermined


@lru_cache
def _compiled_root() -> Callable[..., tuple[FloatArray, FloatArray]]:
    """:func:`_inverse_root` for arrays in C order."""
    return compiled_for(_inverse_root, np.zeros((12, 12)), Prior.empty(), np.zeros(12, dtype=np.bool_))


@kernel()
def _sandwich(white: Any, scores: Any, correlated: Any) -> Any:
    """(8, 8) covariance of the parameters from the inverse of the scores' derivative and the outer product of the scores, and the mean
    factor by which the correlated part makes variances larger."""
    before = (white @ scores @ white)[:8, :8]
    covariance = before + (white @ correlated @ white)[:8, :8]
    ratio, seen = 0.0, 0
    for a in range(8):
        if before[a, a] > 0.0:
            ratio += max(covariance[a, a], 0.0) / before[a, a]
            seen += 1
    return covariance, ratio / seen if seen else 1.0


def parameter_covariance(now: Linearisation, problem: Problem, state: UnitState) -> ParameterCovariance:
    """Sandwich covariance after a final linearisation at the adjusted state."""
    points, equations, sums, prior = now.points, now.equations, now.sums, problem.prior
    free = problem.free(state)
    singles = max(sums.singles, 1.0)
    slope = sums.slopes / singles
    stride = max(1, len(problem.points) // EXCESS_SAMPLE)
    excess = row_excess(points, problem.solid(state), problem.cov, stride)
    root, undetermined = _compiled_root()(slope * equations.plain + equations.shared - excess, prior, free)
    white = root @ root.T
    count = float(np.count_nonzero(points.weights > 0))
    small_sample = max(count, 1.0) / max(count - np.count_nonzero(free[:8]), 1.0)
    psi = small_sample * sums.psi_squares / singles
    noise_part = psi * equations.plain + small_sample * equations.shared_scores
    whitened = points.rows @ root
    correlated = correlated_part(
        feet=points.feet,
        rows=points.rows,
        whitened=whitened,
        scores=(points.residuals - points.biases) / points.sds * points.weights,
        weights=points.weights,
        height=problem.unit.height,
        white=white,
        plain=equations.plain,
        psi=psi,
    )
    correlated = _guarded(correlated, noise_part, free, prior.scaling)
    covariance, inflation = _sandwich(white, noise_part + np.diag(prior.weights), correlated)
    covariance, undetermined = _with_what_is_lost(covariance, undetermined, prior, state.rotation)
    return ParameterCovariance(covariance=covariance, undetermined=undetermined, whitened=whitened, inflation=inflation)


def _with_what_is_lost(
    covariance: FloatArray, undetermined: FloatArray, prior: Prior, rotation: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """(8, 8) covariance with the variance of knowing nothing along (k, 12) directions, and these as (k, 8); along the points' axes."""
    if len(undetermined):
        undetermined = undetermined[np.linalg.norm(undetermined[:, :8], axis=1) > 0.1]
    undetermined = undetermined[:, :8]
    lost = undetermined * prior.scaling[:8]
    covariance += LOST**2 * lost.T @ lost
    axes = np.eye(8)
    axes[:3, :3] = axes[3:6, 3:6] = rotation
    return axes @ covariance @ axes.T, undetermined @ axes.T
