"""What displacements of units at rest look like, learned from a mixture with moved ones."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.stats import multivariate_t, norm
from tetratrack.core.deformation.null_model import NullModel, calibrate

HEIGHT = 2.3
FloatArray = NDArray[np.float64]


def displacements(seed: int, count: int, factor: float, floor: float, tail: float, moved: float) -> tuple[FloatArray, FloatArray]:
    """(n, 3) residuals of units whose covariances (n, 3, 3) are off by a factor and a floor, a share of which moved by decimetres."""
    rng = np.random.default_rng(seed)
    roots = rng.normal(size=(count, 3, 3)) * 0.002
    stated = roots @ np.swapaxes(roots, 1, 2) + 0.001**2 * np.eye(3)
    true = np.linalg.cholesky(factor**2 * stated + floor**2 * np.eye(3))
    errors = np.einsum("nij,nj->ni", true, rng.normal(size=(count, 3))) * np.sqrt(tail / rng.chisquare(tail, (count, 1)))
    errors[: round(moved * count)] += rng.normal(0, 0.15, (round(moved * count), 3))
    return errors, stated


def log_posterior(null: NullModel, residuals: FloatArray, covariances: FloatArray, typical: float) -> float:
    """By densities of scipy's, apart from the product's: likelihood of all units and the priors that calibrate states."""
    rests = [
        multivariate_t.logpdf(own, shape=shape, df=null.tail) for own, shape in zip(residuals, null.covariance(covariances), strict=True)
    ]
    far = multivariate_t.logpdf(residuals, shape=(0.02 * HEIGHT) ** 2 * np.eye(3), df=1)
    likelihood = np.sum(np.logaddexp(np.log(1 - null.moved_share) + rests, np.log(null.moved_share) + far))
    prior = (
        norm.logpdf(math.log(null.factor), 0, 0.7)
        + norm.logpdf(math.log(null.floor / typical), -0.7, 1)
        + norm.logpdf(math.log(null.tail), math.log(15), 0.8)
        + norm.logpdf(math.log(null.moved_share / (1 - null.moved_share)), -1.7, 1)
    )
    return float(likelihood + prior)


@pytest.mark.parametrize(("count", "tail"), [(5, 30.0), (120, 5.0)])
def test_what_is_learned_is_the_likeliest(count: int, tail: float) -> None:
    residuals, covariances = displacements(1, count, 1.6, 0.002, tail, 0.2)
    typical = float(np.sqrt(np.median(np.linalg.eigvalsh(covariances))))
    found = calibrate(residuals, covariances, HEIGHT)
    best = log_posterior(found, residuals, covariances, typical)
    odds = math.log(found.moved_share / (1 - found.moved_share))
    for step in (-0.05, 0.05):
        grown = math.exp(step)
        for factor, floor, own_tail, share in ((grown, 1, 1, 0), (1, grown, 1, 0), (1, 1, grown, 0), (1, 1, 1, step)):
            moved = 1 / (1 + math.exp(-odds - share))
            other = NullModel(found.factor * factor, found.floor * floor, found.tail * own_tail, moved, count)
            assert log_posterior(other, residuals, covariances, typical) < best


def test_factor_floor_and_share_come_out_of_many_units() -> None:
    residuals, covariances = displacements(2, 3000, 1.5, 0.003, 8.0, 0.15)
    found = calibrate(residuals, covariances, HEIGHT)
    assert found.factor == pytest.approx(1.5, rel=0.1)
    assert found.floor == pytest.approx(0.003, rel=0.1)
    assert found.moved_share == pytest.approx(0.15, abs=0.03)


@pytest.mark.parametrize(("seed", "factor", "floor"), [(11, 2.2, 0.03), (0, 1.5, 0.06)], ids=["a long step", "a start nearby"])
def test_a_floor_far_above_what_is_stated_is_found(seed: int, factor: float, floor: float) -> None:
    residuals, covariances = displacements(seed, 100, factor, floor, 6.0, 0.1)
    found = calibrate(residuals, covariances, HEIGHT)
    assert found.floor == pytest.approx(floor, rel=0.15)
    assert found.factor < 3


def test_no_units_leave_covariances_as_stated() -> None:
    found = calibrate(np.empty((0, 3)), np.empty((0, 3, 3)), HEIGHT)
    assert (found.factor, found.floor, found.count) == (1.0, 0.0, 0)
