"""Targets along a coast: what they leave unknown between them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from tetratrack.core.common.errors import InputError
from tetratrack.core.registration.frame_field import matern
from tetratrack.core.registration.target_spacing import BentSurvey, stations_for


def test_what_is_unknown_grows_from_the_targets_own_to_the_bend() -> None:
    survey = BentSurvey()
    unknown = [survey.unknown(spacing) for spacing in (3, 10, 30, 70, 300)]
    assert np.all(np.diff(unknown) > 0)
    assert unknown[0] < survey.target_sd
    assert survey.bend < unknown[-1] < 1.3 * survey.bend


def test_errors_of_drawn_bends_have_the_stated_size() -> None:
    """Kriging of random fields between stations 50 m apart, with the true covariance, errs by what is stated."""
    survey = BentSurvey(correlation_length=30.0)
    rng = np.random.default_rng(0)
    places = (np.arange(9) - 3.5) * 50.0
    everywhere = np.append(places, 0.0)
    covariance = survey.bend**2 * matern(np.abs(everywhere[:, None] - everywhere[None]) / 30.0, 2.5)
    fields = np.linalg.cholesky(covariance + 1e-12 * np.eye(10)) @ rng.normal(size=(10, 4000))
    seen = fields[:9] + rng.normal(0, survey.target_sd / np.sqrt(survey.targets), (9, 4000))
    design = np.column_stack([np.ones(9), places])
    noisy = covariance[:9, :9] + np.eye(9) * survey.target_sd**2 / survey.targets
    inverse = np.linalg.inv(noisy)
    trend = np.linalg.solve(design.T @ inverse @ design, design.T @ inverse @ seen)
    predicted = trend[0] + covariance[9, :9] @ inverse @ (seen - design @ trend)
    assert np.std(predicted - fields[9]) == pytest.approx(survey.unknown(50.0), rel=0.05)


def test_stations_keep_the_limit_and_fewer_do_not() -> None:
    survey = BentSurvey()
    count, spacing = stations_for(survey, 0.05, 500.0)
    assert survey.detectable(spacing) <= 0.05
    assert survey.detectable(500.0 / (count - 2)) > 0.05


def test_a_limit_below_the_targets_own_is_refused() -> None:
    with pytest.raises(InputError, match="cannot be reached"):
        stations_for(BentSurvey(target_sd=0.05), 0.01, 200.0)


@pytest.mark.parametrize(
    "numbers",
    [{"correlation_length": 0.0}, {"bend": math.nan}, {"bend": -0.03}, {"target_sd": math.inf}, {"target_sd": 0.0}, {"targets": 0}],
)
def test_numbers_of_no_survey_are_refused(numbers: dict[str, float]) -> None:
    """They came out as stations every two metres, with a detection limit that is no number."""
    with pytest.raises(InputError) as caught:
        BentSurvey(**numbers)
    assert caught.value.where in numbers


@pytest.mark.parametrize("length", [-300.0, math.nan, math.inf, 1e12])
def test_lengths_of_no_structure_are_refused(length: float) -> None:
    with pytest.raises(InputError, match="has no stations"):
        stations_for(BentSurvey(), 0.05, length)


@pytest.mark.parametrize(("sd", "targets"), [(0.006, 1000), (1e-4, 3)])
def test_without_a_bend_what_is_unknown_is_the_same_at_any_distance(sd: float, targets: int) -> None:
    """Long spacings and good targets ended with a singular matrix."""
    survey = BentSurvey(bend=0.0, target_sd=sd, targets=targets)
    assert [survey.unknown(spacing) for spacing in (100.0, 1e4, 1e6)] == pytest.approx([survey.unknown(10.0)] * 3, rel=0.03)
    assert stations_for(survey, 0.05, 1e6) == (2, 1e6)
