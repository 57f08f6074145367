"""A unit in noise that no draw of the search hits upon is found about its single elements, and nothing else changes by that."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation import segment as segmentation

UNIT = UnitType.tetrapod(2.3)
H = UNIT.height
PLACES = H * np.array([[0, 0, 0], [1.2, 0, 0], [0, 1.2, 0], [1.2, 1.2, -0.1]])


def pile(seed: int, noise: float) -> np.ndarray:
    """Three units seen from above and, of the last one, a strip that holds a twentieth of its surface."""
    rng, parts = np.random.default_rng(seed), []
    for k, centre in enumerate(PLACES):
        pose = Pose(centre, Rotation.random(random_state=10 * seed + k).as_matrix())
        points, normals, _ = sample_surface(UNIT, 7000, rng)
        shown = pose.to_frame(points)[(normals @ pose.rotation.T)[:, 2] > 0.1]
        if k == len(PLACES) - 1:
            across = np.abs((shown - centre) @ [np.cos(seed), np.sin(seed), 0])
            shown = shown[np.argsort(across)[:350]]
        parts.append(shown)
    points = np.vstack(parts)
    return points + rng.normal(0, noise, points.shape)


@pytest.mark.parametrize("seed", range(3))
def test_what_the_draws_miss_is_found_about_its_elements_and_adds_to_the_rest(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    points, about = pile(seed, 0.013 * H), segmentation.poses_about_elements

    def unlucky(drawn):
        def elsewhere(*args, **options):
            poses = drawn(*args, **options)
            return poses[np.linalg.norm(poses[:, :3] - PLACES[-1], axis=1) > 0.6 * H]

        return elsewhere

    for name in ("poses_from_pairs", "poses_from_single_legs"):
        monkeypatch.setattr(segmentation, name, unlucky(getattr(segmentation, name)))
    monkeypatch.setattr(segmentation, "poses_about_elements", lambda *_: np.zeros((0, 12)))
    before = segmentation.judge_poses(points, UNIT, workers=1)
    monkeypatch.setattr(segmentation, "poses_about_elements", about)
    after = segmentation.judge_poses(points, UNIT, workers=1)
    assert after.elements.smoothed
    assert np.linalg.norm(before.poses[:, :3] - PLACES[-1], axis=1).min() > 0.5 * H
    count = len(before.poses)
    # the turn about a leg is asked among all of them; all else is as it was
    np.testing.assert_array_equal(after.evidence.table[:count], before.evidence.table)
    np.testing.assert_array_equal(after.scores[:count], before.scores)
    np.testing.assert_array_equal(after.residuals[:count], before.residuals)
    away = np.linalg.norm(after.poses[count:, :3] - PLACES[-1], axis=1)
    assert away.min() < 0.03 * H
    assert after.scores[count + np.argmin(away)] >= segmentation.FOUND_SCORE
