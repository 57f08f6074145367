"""A pose that a refinement has left beside its elements is found again from poses around it."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.pose_evidence import evidence
from tetratrack.core.segmentation.pose_refinement import refine
from tetratrack.core.segmentation.restarts import begun_anew
from tetratrack.core.segmentation.scene import Scene
from tetratrack.core.segmentation.segment import cloud_elements

UNIT = UnitType.tetrapod(2.3)
H = UNIT.height
TRUE = Pose(np.zeros(3), Rotation.random(random_state=1).as_matrix())


def test_what_is_in_doubt_is_taken_to_its_elements_and_all_else_stays():
    rng = np.random.default_rng(1)
    points, normals, _ = sample_surface(UNIT, 12000, rng)
    world = TRUE.to_frame(points)
    # an eighth of the surface, two legs from above
    shown = world[((normals @ TRUE.rotation.T)[:, 2] > 0.1) & (world[:, 2] > 0.3 * H)]
    cloud = cloud_elements(shown + rng.normal(0, 0.015 * H, shown.shape), UNIT, workers=1)
    scene = Scene.of(cloud.elements, UNIT, cloud.tolerance)
    assert scene.smoothed
    every = np.ones(len(scene.points), dtype=np.bool_)
    starts = []
    for seed in (101, 102):
        draw = np.random.default_rng(seed)
        shift, turn = draw.normal(0, 0.08 * H, 3), draw.normal(0, 0.15, 3)
        starts.append(np.r_[shift, (Rotation.from_rotvec(turn).as_matrix() @ TRUE.rotation).ravel()])
    poses = refine(np.array(starts), scene, every, most=1500, sweeps=20)
    found = evidence(poses, scene, every)
    assert np.linalg.norm(poses[:, :3], axis=1).min() > 0.15 * H
    owner, contested = np.zeros(len(every), dtype=np.int64), ~every
    anew, judged = begun_anew(poses, found, np.array([True, False]), scene, owner, contested, 0)
    assert np.linalg.norm(anew[0, :3]) < 0.01 * H
    np.testing.assert_array_equal(judged[0].table, evidence(anew[:1], scene, every).table)
    np.testing.assert_array_equal(anew[1], poses[1])
    np.testing.assert_array_equal(judged[1].table, found[1].table)
    # one seed, one result
    np.testing.assert_array_equal(begun_anew(poses, found, np.array([True, False]), scene, owner, contested, 0)[0], anew)
