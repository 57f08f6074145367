"""Feature points: closed form against the general solver, the printed opening, covariance against finite differences, labels."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from tetratrack.core.model.feature_points import TRIPLES, body_features, end_disc_centres, feature_points, intersect_cones, label_symmetry
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate
from tetratrack.core.model.unit_types import UnitType

heights = st.floats(0.05, 6.0)
gradients = st.floats(0.02, 0.25)


def random_pose(seed: int) -> Pose:
    rng = np.random.default_rng(seed)
    return Pose(rng.normal(size=3) * 10, Rotation.random(random_state=rng).as_matrix())


@given(height=heights, gradient=gradients)
def test_closed_form_and_general_solver_agree(height: float, gradient: float) -> None:
    unit = UnitType.tetrapod(height, gradient=gradient)
    general = [intersect_cones(unit.leg_directions[list(t)], unit.radius, unit.gradient) for t in TRIPLES]
    assert np.abs(np.array(general) - body_features(unit)[1:]).max() < 1e-9


@pytest.mark.parametrize("opening", ["tetrahedral", "paper"])
def test_feature_points_lie_on_their_three_cones(opening: str) -> None:
    unit = UnitType.tetrapod(2.3, opening=opening)
    for triple, point in zip(TRIPLES, body_features(unit)[1:], strict=True):
        for axis in unit.leg_directions[list(triple)]:
            axial = point @ axis
            rho = np.linalg.norm(point - axial * axis)
            assert rho == pytest.approx(unit.radius - unit.gradient * axial, abs=1e-12)
            assert axial > 0 or opening == "paper"


def test_tetrahedral_feature_points_lie_opposite_the_fourth_leg() -> None:
    unit = UnitType.tetrapod(2.3)
    features = body_features(unit)
    assert features[0] == pytest.approx(np.zeros(3))
    # f123 is opposite leg 4, f234 opposite leg 1
    assert features[1] / np.linalg.norm(features[1]) == pytest.approx(-unit.leg_directions[3])
    assert features[4] / np.linalg.norm(features[4]) == pytest.approx(-unit.leg_directions[0])
    assert np.linalg.norm(features[1:], axis=1) == pytest.approx(np.full(4, unit.radius / (math.sqrt(8) / 3 + unit.gradient / 3)))


def test_legs_in_one_plane_are_refused() -> None:
    axes = np.array([[1.0, 0, 0], [0, 1.0, 0], [1, 1, 0] / np.sqrt(2)])
    with pytest.raises(ValueError, match="one plane"):
        intersect_cones(axes, 1.0, 0.1)


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10**6), opening=st.sampled_from(["tetrahedral", "paper"]))
def test_jacobian_matches_finite_differences(seed: int, opening: str) -> None:
    unit = UnitType.tetrapod(2.3, opening=opening)
    pose = random_pose(seed)
    jacobian = feature_points(pose, unit).jacobian
    step = 1e-6
    for k in range(8):
        ends = []
        for sign in (-1, 1):
            change = np.zeros(8)
            change[k] = sign * step
            moved = pose.perturbed(change[:3], change[3:6])
            shaped = unit.with_shape(unit.radius + change[6], unit.gradient + change[7])
            ends.append(feature_points(moved, shaped).positions)
        assert jacobian[:, :, k] == pytest.approx((ends[1] - ends[0]) / (2 * step), abs=1e-7)


def test_covariance_is_propagated() -> None:
    unit, pose = UnitType.tetrapod(2.3), random_pose(1)
    root = np.random.default_rng(2).normal(size=(8, 8)) * 1e-3
    result = feature_points(pose, unit, root @ root.T)
    assert result.covariances[0] == pytest.approx((root @ root.T)[:3, :3])
    for k in range(5):
        assert result.covariances[k] == pytest.approx(result.jacobian[k] @ root @ root.T @ result.jacobian[k].T)


@settings(max_examples=50, deadline=None)
@given(seed=st.integers(0, 10**6), symmetry=st.integers(0, 11), turn=st.floats(0, 0.4))
def test_labels_are_carried_by_the_smallest_turn(seed: int, symmetry: int, turn: float) -> None:
    unit, pose = UnitType.tetrapod(2.3), random_pose(seed)
    axis = np.random.default_rng(seed).normal(size=3)
    moved = pose.perturbed([0.1, 0, 0], turn * axis / np.linalg.norm(axis))
    found, least, second = label_symmetry(pose, moved.relabelled(unit.symmetries[symmetry]), unit)
    carried = moved.relabelled(unit.symmetries[symmetry]).relabelled(found)
    assert carried.rotation == pytest.approx(moved.rotation, abs=1e-9)
    assert least == pytest.approx(turn, abs=1e-6)
    assert second > least


def test_centres_of_end_discs_and_their_covariance() -> None:
    unit = UnitType.tetrapod(2.3)
    rng = np.random.default_rng(8)
    pose = Pose(np.array([7e5, 4e6, 3.0]), Rotation.random(random_state=3).as_matrix())
    root = 1e-3 * rng.normal(size=(8, 8))
    covariance = root @ root.T
    centres, covariances = end_disc_centres(pose, unit, covariance)
    assert np.linalg.norm(centres - pose.centre, axis=1) == pytest.approx(unit.leg_length)
    assert relate(pose.to_body(centres), unit).distance == pytest.approx(0, abs=1e-9)
    draws = rng.multivariate_normal(np.zeros(8), covariance, 20_000)
    moved = np.array([end_disc_centres(pose.perturbed(d[:3], d[3:6]), unit)[0] for d in draws[:4000]])
    for k in range(4):
        assert np.cov(moved[:, k].T) == pytest.approx(covariances[k], abs=0.1 * np.abs(covariances[k]).max())
