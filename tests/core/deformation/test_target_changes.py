"""Targets held against the ground around them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from tetratrack.core.deformation.target_changes import p_values_of_changes
from tetratrack.core.registration.frame_field import LocalMotions

FloatArray = NDArray[np.float64]
ALONG = np.repeat([0.0, 24.0, 48.0, 72.0], 5) + np.tile([-3.5, -2.0, 0.0, 2.5, 3.5], 4)
NOISE = 0.006


def changes(seed: int) -> tuple[FloatArray, LocalMotions]:
    """Changes of twenty targets on a bent ground that units know within three millimetres."""
    rng = np.random.default_rng(seed)
    bend = np.column_stack([0.05 * np.sin(ALONG / 7 + k) for k in range(3)])
    known = np.zeros((len(ALONG), 6))
    known[:, :3] = bend + rng.normal(0, 0.003, bend.shape)
    covariances = np.tile(np.diag([0.003**2] * 3 + [1e-8] * 3), (len(ALONG), 1, 1))
    return bend + rng.normal(0, NOISE, bend.shape), LocalMotions(known, covariances)


def judged(differences: FloatArray, ground: LocalMotions) -> FloatArray:
    return p_values_of_changes(differences, np.full(differences.shape, NOISE**2), ground, ALONG, 9.0)


def test_good_targets_change_as_the_ground_does() -> None:
    p_values = np.concatenate([judged(*changes(seed)) for seed in range(40)])
    assert np.mean(p_values < 0.05) < 0.07
    assert np.mean(p_values < 0.01 / len(ALONG)) < 0.003


def test_a_disturbed_target_changes_unlike_the_ground_and_its_station() -> None:
    for seed in range(10):
        differences, ground = changes(seed)
        differences[7] += [0.03, 0.03, -0.03]
        p_values = judged(differences, ground)
        assert np.argmin(p_values) == 7
        assert p_values[7] < 0.01 / len(ALONG)


def test_a_station_that_moved_as_one_is_not_disturbed() -> None:
    differences, ground = changes(3)
    differences[5:10] += [0.07, 0.0, -0.07]
    assert judged(differences, ground).min() > 0.01 / len(ALONG)
