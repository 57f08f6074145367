"""Direct registration of two clouds of one unit as a check of its displacement."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import grid_poses, seen_from_above
from tetratrack.core.deformation.cross_check import cross_check
from tetratrack.core.model.pose import Pose, rotation_angle

POSE = Pose(np.array([0.0, 0.0, 0.0]), Rotation.from_euler("xyz", [0.3, 0.4, 0.5]).as_matrix())


def test_direct_registration_agrees_with_the_true_motion() -> None:
    differences, agreed = [], 0
    for seed, pose in enumerate(grid_poses(np.random.default_rng(1), 3)):
        rng = np.random.default_rng(seed)
        after = pose.perturbed(rng.normal(0, 0.1, 3), rng.normal(0, 0.05, 3))
        clouds = [seen_from_above(p, np.random.default_rng([seed, k]), 1500, 0.006).points for k, p in enumerate((pose, after))]
        check = cross_check(*clouds, pose, after, np.eye(3) * 0.001**2, 0.006)
        differences.append(check.difference)
        agreed += check.agrees is True
        assert math.degrees(check.turn) == pytest.approx(math.degrees(rotation_angle(pose.rotation, after.rotation)), abs=0.5)
    assert np.sqrt(np.mean(np.square(differences))) < 0.004
    assert agreed >= 8


def test_direct_registration_disagrees_with_a_wrong_model() -> None:
    rng = np.random.default_rng(2)
    clouds = [seen_from_above(POSE, rng, 1500, 0.006).points for _ in range(2)]
    check = cross_check(*clouds, POSE, POSE.shifted([0.03, 0, 0.0]), np.eye(3) * 0.001**2, 0.006)
    assert check.agrees is False
    assert check.difference == pytest.approx(0.03, abs=0.006)
    assert "broken leg" in check.reason


def test_direct_registration_says_when_it_cannot_tell() -> None:
    rng = np.random.default_rng(3)
    points = seen_from_above(POSE, rng, 1500, 0.006).points
    few = cross_check(points[:20], points, POSE, POSE, np.eye(3) * 1e-6, 0.006)
    assert few.agrees is None
    assert "fewer than" in few.reason
    apart = cross_check(points[points[:, 0] > 0.6], points[points[:, 0] < -0.6], POSE, POSE, np.eye(3) * 1e-6, 0.006)
    assert apart.agrees is None
    assert math.isnan(apart.difference)
