"""Constants of robust statistics are what their names say."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import chi2, norm
from tetratrack.core.common.robust import CHI2_3_95, CHI2_3_MEDIAN, MAD_TO_SD, TUKEY, sd_of_deviations, t_weights


def test_constants() -> None:
    assert pytest.approx(1 / norm.ppf(0.75), rel=1e-4) == MAD_TO_SD
    assert pytest.approx(chi2(3).median(), rel=1e-4) == CHI2_3_MEDIAN
    assert pytest.approx(chi2(3).ppf(0.95), rel=1e-9) == CHI2_3_95


def test_tukey_is_95_percent_efficient() -> None:
    """Variance of the mean of normal errors over that of the M-estimate: (E psi')^2 / E psi^2."""
    x = np.linspace(-TUKEY, TUKEY, 200_001)
    density, u = norm.pdf(x) * (x[1] - x[0]), x / TUKEY
    slope = np.sum((1 - u**2) * (1 - 5 * u**2) * density)
    square = np.sum((x * (1 - u**2) ** 2) ** 2 * density)
    assert slope**2 / square == pytest.approx(0.95, abs=1e-4)


def test_a_third_of_wild_errors_does_little() -> None:
    rng = np.random.default_rng(0)
    deviations = np.concatenate([rng.normal(0, 0.01, 20_000), rng.normal(0, 5.0, 5_000)])
    assert sd_of_deviations(deviations[:20_000]) == pytest.approx(0.01, rel=0.03)
    assert sd_of_deviations(deviations) < 0.015


def test_t_weights_fall_with_the_misfit_and_know_understated_covariances() -> None:
    weights, size = t_weights(np.array([0.0, 2.366, 2.366, 30.0, 2.366]))
    assert size == pytest.approx(1.0)
    assert weights[0] == 1.0
    assert weights[3] < 0.01 < weights[1] == weights[2]
    assert t_weights(4 * np.full(5, 2.366))[1] == pytest.approx(4.0)
    assert t_weights(np.zeros(0))[1] == 1.0
