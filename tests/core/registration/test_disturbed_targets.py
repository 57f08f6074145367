"""Outlier tests of all targets from one fit are those of a fit without each target, and nothing grows faster than the targets do."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from scipy.special import fdtrc
from tetratrack.core.registration import disturbed_targets as module
from tetratrack.core.registration.weighted_transformation import weighted_fit

LEVEL = 0.01


def network(seed: int, length: float = 100.0) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Surveyed and measured places, their variances and the numbers of none to five disturbed ones among 6 to 20."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(6, 21))
    measured = rng.uniform(0, 1, (count, 3)) * [length, rng.choice([4.0, 40.0]), 3.0] + [5e5, 4e6, 0.0]
    turn = Rotation.from_rotvec(rng.normal(0, 0.2, 3) * [0.01, 0.01, 1.0]).as_matrix()
    sds = rng.uniform(0.003, 0.006, measured.shape)
    surveyed = (measured - measured[0]) @ turn.T + measured[0] + rng.normal(0, 0.3, 3) + rng.normal(0, sds)
    disturbed = rng.choice(count, int(rng.integers(0, min(6, count // 2))), replace=False)
    surveyed[disturbed] += rng.normal(0, 1, (len(disturbed), 3)) * rng.choice([0.01, 0.03, 0.1, 0.5, 5.0], (len(disturbed), 1))
    return surveyed, measured, sds**2, disturbed


def by_refits(
    surveyed: np.ndarray, measured: np.ndarray, variances: np.ndarray, used: np.ndarray, similarity: bool
) -> tuple[np.ndarray, np.ndarray]:
    """Normalised differences and p-values of all points, each from a fit of its own to the other used ones."""
    statistics, p_values = np.zeros((len(used), 3)), np.ones(len(used))
    noise, across = math.sqrt(np.median(variances)), module.spread_across(measured)
    for k in range(len(used)):
        others = used.copy()
        others[k] = False
        if others.sum() < 3 or not module.spread_enough(measured[others], noise, across):
            continue
        fit = weighted_fit(surveyed, measured, variances, others, similarity)
        if fit.redundancy < 1:
            continue
        gap, rows = fit.transformation.apply(measured[k][None])[0] - surveyed[k], fit.rows[k]
        free = rows.shape[1]
        cofactor = np.diag(variances[k]) + rows @ fit.transformation.covariance[:free, :free] @ rows.T
        unit_variance = max(fit.square_sum / fit.redundancy, 1.0)
        statistics[k] = gap / np.sqrt(np.diag(cofactor) * unit_variance)
        p_values[k] = fdtrc(3, fit.redundancy, float(gap @ np.linalg.solve(cofactor, gap)) / 3 / unit_variance)
    return statistics, p_values


@pytest.mark.parametrize("similarity", [False, True])
def test_tests_from_one_fit_are_those_of_refits(similarity: bool) -> None:
    seen = 0
    for seed in range(25):
        surveyed, measured, variances, disturbed = network(seed)
        for out in (disturbed[:0], disturbed[:1], disturbed):
            used = np.ones(len(surveyed), dtype=bool)
            used[out] = False
            found = module.outlier_tests(surveyed, measured, variances, used, similarity)
            expected = by_refits(surveyed, measured, variances, used, similarity)
            np.testing.assert_allclose(found[0], expected[0], rtol=2e-3, atol=2e-3)
            np.testing.assert_allclose(found[1], expected[1], rtol=2e-2, atol=1e-9)
            seen += int(np.sum(expected[1] < LEVEL / len(used)))
    assert seen > 50


def test_verdicts_are_those_of_refits() -> None:
    excluded = 0
    for seed in range(100, 135):
        surveyed, measured, variances, _ = network(seed)
        given, ones = (surveyed, measured, variances), np.ones(len(surveyed), dtype=bool)
        found, expected = (
            module.exclude_by_turns(lambda used, tests=tests, given=given: tests(*given, used, False)[1], ones, LEVEL)
            for tests in (module.outlier_tests, by_refits)
        )
        np.testing.assert_array_equal(found, expected)
        excluded += int(np.sum(~found))
    assert excluded > 40


def test_good_targets_of_a_long_coast_are_tested_by_one_fit(monkeypatch: pytest.MonkeyPatch) -> None:
    fits = []

    def counted(*arguments: object) -> object:
        fits.append(arguments)
        return weighted_fit(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(module, "weighted_fit", counted)
    rng = np.random.default_rng(3)
    measured = np.column_stack([np.linspace(0, 2000, 200), rng.uniform(0, 6, 200), rng.uniform(0, 3, 200)])
    surveyed = measured + rng.normal(0, 0.004, measured.shape)
    surveyed[7] += [0.1, 0.1, 0.0]
    variances = np.full(measured.shape, 0.004**2)
    _, p_values = module.outlier_tests(surveyed, measured, variances, np.ones(200, dtype=bool), False)
    # the disturbed one bends more than linearly what it takes part in
    assert len(fits) <= 2
    assert np.flatnonzero(p_values < LEVEL / 200).tolist() == [7]


@pytest.mark.parametrize("count", [4, 14, 40])
def test_triples_by_their_rank_are_those_of_the_list_of_all(count: int) -> None:
    every = np.array(list(itertools.combinations(range(count), 3)))
    ranks = np.random.default_rng(1).permutation(len(every))
    np.testing.assert_array_equal(module.triples(count, ranks), every[ranks])
