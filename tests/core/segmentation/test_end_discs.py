"""Legs of which a cloud shows the end disc and hardly more."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.model.pose import Pose, rotation_angle
from tetratrack.core.model.tetrapod import END_DISC, across_legs, relate, sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.conic_ransac import find_legs
from tetratrack.core.segmentation.end_discs import legs_of_discs
from tetratrack.core.segmentation.scene import Scene
from tetratrack.core.segmentation.segment import judge_poses
from tetratrack.core.segmentation.surface_elements import surface_elements

UNIT = UnitType.tetrapod(2.3)
SLIVER = np.radians(16)
"""Half the part of the turn about a leg that shows: less than tells a cone."""


def seen_along_a_leg(seed: int) -> tuple[np.ndarray, Pose]:
    """Points of the disc of a unit's first leg and of slivers of its sides and of another leg's, 4 mm of noise, and the unit's pose."""
    rng = np.random.default_rng(seed)
    pose = Pose(np.array([3.0, -1.0, 2.0]), Rotation.random(random_state=seed).as_matrix())
    body, _, _ = sample_surface(UNIT, 60000, rng)
    relation = relate(body, UNIT)
    first, second = across_legs(UNIT)
    turn = np.arctan2(np.sum(body * second[relation.leg], axis=1), np.sum(body * first[relation.leg], axis=1))
    sliver = (np.abs(turn) < SLIVER) & (relation.axial > 0.3 * UNIT.height) & (relation.leg < 2)
    shown = np.where(relation.part == END_DISC, relation.leg == 0, sliver)
    return pose.to_frame(body[shown]) + rng.normal(0, 0.004, (int(shown.sum()), 3)), pose


def scene_of(points: np.ndarray) -> tuple[Scene, np.ndarray]:
    scene = Scene.of(surface_elements(points, UNIT.height), UNIT, 0.01 * UNIT.height)
    return scene, np.ones(len(scene.points), dtype=np.bool_)


@pytest.mark.parametrize("seed", range(3))
def test_a_leg_that_shows_its_end_alone_is_found_by_its_disc(seed: int) -> None:
    points, truth = seen_along_a_leg(seed)
    scene, active = scene_of(points)
    axis = truth.rotation @ UNIT.leg_directions[0]
    assert not (find_legs(scene, active, 0).axis @ axis > np.cos(np.radians(12))).any()
    legs = legs_of_discs(scene, active)
    right = legs.axis @ axis > np.cos(np.radians(4))
    assert np.linalg.norm(legs.centre[right] - truth.centre, axis=1).min() < 0.03 * UNIT.height


@pytest.mark.parametrize("seed", range(3))
def test_a_unit_seen_along_a_leg_is_proposed(seed: int) -> None:
    points, truth = seen_along_a_leg(seed)
    judged = judge_poses(points, UNIT, workers=1)
    poses = [Pose.of_row(row) for row in judged.poses]
    turns = [min(rotation_angle(truth.rotation, pose.relabelled(s).rotation) for s in UNIT.symmetries) for pose in poses]
    near = [np.linalg.norm(pose.centre - truth.centre) < 0.03 * UNIT.height for pose in poses]
    assert any(n and np.degrees(t) < 5 for n, t in zip(near, turns, strict=True))


def test_what_is_flat_and_wider_than_a_disc_has_no_legs() -> None:
    rng = np.random.default_rng(5)
    deck = np.column_stack([rng.uniform(0, 6, (60000, 2)), rng.normal(0, 0.004, 60000)])
    strip = deck[deck[:, 1] < 0.3 * UNIT.height]
    for points in (deck, strip):
        scene, active = scene_of(points)
        assert np.count_nonzero(scene.curved < 0) > 100
        assert len(legs_of_discs(scene, active).axis) == 0
