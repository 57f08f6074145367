"""Units all over a cloud tell together where a scanner stood, or the line it flew along."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.model.tetrapod import relate, sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.sensor_places import Solids, Source, nearest_first

UNIT = UnitType.tetrapod(2.3)
PLACE, HEADING = np.array([4.0, -12.0, 28.0]), np.array([np.cos(0.6), np.sin(0.6), 0.0])
ALONG_X = np.array([np.cos(3.11), np.sin(3.11), 0.0])


def poses_in_rows() -> np.ndarray:
    """(9, 12) units apart, each turned otherwise."""
    turns = Rotation.random(9, random_state=5).as_matrix().reshape(-1, 9)
    places = [(3.1 * k, 3.3 * row + 0.4 * k, 1.4) for k in range(3) for row in range(3)]
    return np.hstack([np.array(places), turns])


def scanned(poses: np.ndarray, drift: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """(n, 3) points of units over flat ground, from a sensor at ``PLACE`` abeam of the first that moved with what it measured."""
    body, _, _ = sample_surface(UNIT, 2_500, rng)
    flat = rng.uniform(-3, 10, (9_000, 2))
    ground = np.column_stack([flat, np.zeros(len(flat))])
    points = np.vstack([*(body @ pose[3:].reshape(3, 3).T + pose[:3] for pose in poses), ground])
    beams = PLACE + (points @ drift)[:, None] * drift - points
    beams /= np.linalg.norm(beams, axis=1)[:, None]
    free = np.ones(len(points), dtype=bool)
    for pose in poses:
        away = pose[:3] - points
        along = np.einsum("ij,ij->i", away, beams)
        near = np.flatnonzero((np.einsum("ij,ij->i", away, away) - along**2 < UNIT.reach**2) & (along > -UNIT.reach))
        for step in np.arange(-UNIT.reach, UNIT.reach, 0.05):
            near = near[free[near]]
            ahead = along[near] + step
            at = (points[near] + ahead[:, None] * beams[near] - pose[:3]) @ pose[3:].reshape(3, 3)
            free[near] = (relate(at, UNIT).distance > -0.01) | (ahead < 0.02)
    return points[free]


@pytest.mark.parametrize("drift", [np.zeros(3), HEADING, ALONG_X], ids=["stood", "flew", "flew west"])
def test_units_tell_together_where_the_sensor_was(drift: np.ndarray) -> None:
    poses = poses_in_rows()
    points = scanned(poses, drift, np.random.default_rng(4))
    source = Source(points, Solids(poses, np.ones((9, 4), dtype=bool), UNIT, 0.004))
    shared = source.shared()
    assert shared is not None
    for centre in poses[:, :3]:
        seen = np.exp(shared.likelihoods) @ shared.seen_from(centre)
        true = PLACE + (centre @ drift) * drift - centre
        cosine = seen @ true / np.linalg.norm(seen) / np.linalg.norm(true)
        assert np.degrees(np.arccos(cosine)) < 4


def test_a_mix_of_places_is_none() -> None:
    poses = poses_in_rows()
    rng = np.random.default_rng(4)
    points = np.vstack([scanned(poses, drift, rng) for drift in (np.zeros(3), 5 * HEADING)])
    assert Source(points, Solids(poses, np.ones((9, 4), dtype=bool), UNIT, 0.004)).shared() is None


def test_points_equally_far_stay_in_their_order():
    rng = np.random.default_rng(2)
    points = rng.integers(-3, 4, (4000, 3)).astype(np.float64)
    order = np.argsort(np.sum(points**2, axis=1), kind="stable")
    np.testing.assert_array_equal(nearest_first(points), points[order])
