"""Datum control of rigid frames: the units at rest show how far off the control is, and a structure that moved does not hide in it."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray
from tetratrack.core.deformation.congruence import Congruence, congruence_of, quadratic
from tetratrack.core.deformation.control_scale import MOST_SIZE, with_rigid_scale
from tetratrack.core.registration.transformation import rigid_jacobian

FloatArray = NDArray[np.float64]
ORIGIN = np.zeros(3)
STATED = np.diag([0.004**2] * 3 + [0.0001**2] * 3 + [0.0])
SEEDS = range(300, 330)


@cache
def pair(seed: int, error: float, settlement: float = 0.0, count: int = 120) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Displacements of resting units with covariances that are right, in frames that are off by ``error`` times what control states."""
    rng = np.random.default_rng(seed)
    points = rng.uniform(-15, 15, (count, 3))
    covariances = (rng.uniform(0.001, 0.003, count) ** 2)[:, None, None] * np.eye(3)
    own = rng.normal(size=(count, 3)) * np.sqrt(covariances[:, 0, :1])
    common = error * rng.multivariate_normal(np.zeros(6), STATED[:6, :6])
    shifts = rigid_jacobian(points)[:, :, :6] @ common - [0.0, 0.0, settlement]
    return own + shifts, covariances, points


def judged(seed: int, error: float, settlement: float = 0.0, count: int = 120) -> tuple[Congruence, Congruence]:
    """Before and after the resting units were asked."""
    displacements, covariances, points = pair(seed, error, settlement, count)
    before = congruence_of(displacements, covariances, points, STATED, ORIGIN, 2.3)
    return before, with_rigid_scale(before, displacements, covariances, points)


def normalised(congruence: Congruence, seed: int, error: float) -> float:
    """Mean squared normalised error of displacements in datum control."""
    displacements, covariances, points = pair(seed, error)
    own = congruence.null.spread * congruence.null.covariance(covariances)
    frame = congruence.rigid_motions(points, "control").covariances[:, :3, :3]
    return float(np.mean(displacements**2 / np.einsum("nii->ni", own + frame)))


@pytest.mark.parametrize("error", [0.6, 1.0, 1.4])
def test_every_pair_has_its_own_size_and_level(error: float) -> None:
    found = [judged(seed, error) for seed in SEEDS]
    kept = [(seed, before, after) for seed, (before, after) in zip(SEEDS, found, strict=True) if after is not before]
    assert len(kept) >= 0.7 * len(SEEDS)
    sizes = np.array([normalised(after, seed, error) for seed, _, after in kept])
    flags = np.array([np.mean(after.control_p_values < 0.05) for _, _, after in kept])
    assert np.mean((sizes > 0.7) & (sizes < 1.4)) >= 0.9
    assert np.mean((flags >= 0.02) & (flags <= 0.08)) >= 0.9
    # by the stated size, chance alone decides on either
    plain = np.array([normalised(before, seed, error) for seed, before, _ in kept])
    assert np.mean((plain > 0.7) & (plain < 1.4)) < 0.7


def test_the_size_has_bounds() -> None:
    """A handful of values is more than six times its variance once in a thousand draws; below, control is taken at its word."""
    found = [judged(seed, 1.5) for seed in SEEDS]
    sizes = np.array([after.prior[0, 0] / before.prior[0, 0] for before, after in found])
    assert sizes.max() < 1.5 * MOST_SIZE
    assert np.median(sizes[sizes != 1.0]) > 1.0


def test_a_structure_that_settled_does_not_hide_in_its_control() -> None:
    for seed in range(300, 306):
        before, after = judged(seed, 1.0, settlement=0.03)
        assert before.common_p_value < 0.01
        assert after is before
        assert np.mean(after.control_p_values < 0.05) > 0.9


def test_statistics_are_those_of_the_stated_covariances() -> None:
    displacements, covariances, points = pair(301, 1.0)
    _, after = judged(301, 1.0)
    frame = after.rigid_motions(points, "control").covariances[:, :3, :3]
    expected = quadratic(displacements, after.null.covariance(covariances) + frame) / after.control_factor
    np.testing.assert_allclose(after.control_statistics, expected)


def test_few_units_and_no_control_change_nothing() -> None:
    before, after = judged(300, 1.0, count=12)
    assert after is before
    displacements, covariances, points = pair(300, 1.0)
    loose = congruence_of(displacements, covariances, points, None, ORIGIN, 2.3)
    assert with_rigid_scale(loose, displacements, covariances, points) is loose
