"""What is said of a cloud before it is worked on."""

import itertools

import numpy as np
import pytest
from tetratrack.core.adjustment.expectation import DENSITIES, NOISES, RECALL, advice, expected
from tetratrack.core.model.unit_types import UnitType

UNIT = UnitType.tetrapod(3.2)


def test_table_has_a_row_for_every_noise_and_density() -> None:
    assert np.shape(RECALL) == (len(NOISES), len(DENSITIES), 3)
    assert ((np.array(RECALL) >= 0) & (np.array(RECALL) <= 1)).all()


def test_measured_places_are_told_as_measured() -> None:
    for (i, noise), (j, density) in itertools.product(enumerate(NOISES), enumerate(DENSITIES)):
        assert expected(density, noise, UNIT).recall == pytest.approx(RECALL[i][j])


def test_more_points_and_less_noise_never_show_less() -> None:
    limits = [expected(density, 0.013, UNIT).limit for density in (150, 500, 2000, 9000)]
    assert limits == sorted(limits, reverse=True)
    limits = [expected(1000, noise, UNIT).limit for noise in (0.003, 0.01, 0.03)]
    assert limits == sorted(limits)
    assert expected(20, 0.01, UNIT).recall == (0, 0, 0)


def test_poor_clouds_are_warned_of_with_what_would_help() -> None:
    said, poor = advice(180, 0.03, UNIT)
    assert poor
    assert said.startswith("the cloud: 180 points per H², 3.0 % of H noise: expect ")
    assert "would show" in said
    said, poor = advice(6300, 0.006, UNIT)
    assert not poor
    assert "6 300 points per H²" in said
    assert "would show" not in said
    assert "mm on (80 % found)" in said
