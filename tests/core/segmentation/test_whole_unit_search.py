"""Units of which a sparse cloud shows some tens of points, and the score in sparse and noisy clouds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.model.pose import Pose, rotation_angle
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.pose_refinement import refine
from tetratrack.core.segmentation.pose_score import NOISY, RICH, SMOOTHED, SPARSE, typical_unit
from tetratrack.core.segmentation.scene import Evidence, Scene
from tetratrack.core.segmentation.surface_elements import surface_elements
from tetratrack.core.segmentation.whole_unit_search import SURROUNDINGS, poses_about_elements

UNIT = UnitType.tetrapod(2.3)
KNOWN = np.concatenate([[1.3 * UNIT.height, 0.0, 0.0], np.eye(3).ravel()])[None]


def sparse_part(seed: int) -> tuple[np.ndarray, Pose]:
    """About sixty points of the quarter of a unit that faces one way, 5 mm of noise, and its pose."""
    rng = np.random.default_rng(seed)
    pose = Pose(np.zeros(3), Rotation.random(random_state=seed).as_matrix())
    points, normals, _ = sample_surface(UNIT, 240, rng)
    shown = (normals @ pose.rotation.T)[:, 2] > 0.5
    return pose.to_frame(points[shown]) + rng.normal(0, 0.005, (int(shown.sum()), 3)), pose


def scene_of(points: np.ndarray) -> Scene:
    return Scene.of(surface_elements(points, UNIT.height), UNIT, 0.017 * UNIT.height)


@pytest.mark.parametrize("seed", range(6))
def test_a_unit_of_some_tens_of_points_is_among_the_poses(seed: int) -> None:
    points, truth = sparse_part(seed)
    scene = scene_of(points)
    active = np.ones(len(scene.points), dtype=np.bool_)
    poses = refine(poses_about_elements(scene, active, KNOWN), scene, active, most=250, sweeps=8)
    away = np.linalg.norm(poses[:, :3] - truth.centre, axis=1)
    turns = [
        min(rotation_angle(truth.rotation, Pose(p[:3], p[3:].reshape(3, 3)).relabelled(s).rotation) for s in UNIT.symmetries) for p in poses
    ]
    assert ((away < 0.05 * UNIT.height) & (np.degrees(turns) < 5)).any()


def test_nothing_is_looked_for_where_no_unit_is_near() -> None:
    points, _ = sparse_part(1)
    scene = scene_of(points)
    active = np.ones(len(scene.points), dtype=np.bool_)
    far = KNOWN + np.concatenate([[2 * SURROUNDINGS * UNIT.height, 0, 0], np.zeros(9)])
    assert len(poses_about_elements(scene, active, far)) == 0
    assert len(poses_about_elements(scene, active, np.zeros((0, 12)))) == 0
    assert len(poses_about_elements(scene, ~active, KNOWN)) == 0


def test_the_score_is_that_of_the_cloud() -> None:
    scene = scene_of(sparse_part(2)[0])
    none = Evidence.joined([])
    assert typical_unit(none, scene).model is SPARSE
    assert typical_unit(none, replace(scene, spacing=0.01 * UNIT.height)).model is RICH
    assert typical_unit(none, replace(scene, tolerance=0.06 * UNIT.height)).model is NOISY
    assert typical_unit(none, replace(scene, spacing=0.01 * UNIT.height, tolerance=0.06 * UNIT.height)).model is NOISY
    assert typical_unit(none, replace(scene, smoothed=True)).model is SMOOTHED
