"""Overlapping views of a depth camera in one frame."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import grid_poses, seen_from_above
from tetratrack.core.common.errors import Cancelled, InputError
from tetratrack.core.registration.views import register_views


def test_views_are_brought_into_the_frame_of_the_first() -> None:
    pytest.importorskip("open3d")
    rng = np.random.default_rng(5)
    scene = np.vstack([seen_from_above(p, rng, 6000, 0.0).points for p in grid_poses(rng, 2)])
    floor = np.column_stack([rng.uniform(-2, 6, (9000, 2)), rng.normal(0, 0.0, 9000) - 1.2])
    scene = np.vstack([scene, floor])
    views, motions = [], []
    for k in range(3):
        turn = Rotation.from_rotvec(np.radians(rng.normal(0, 0.0 if k == 0 else 1.0, 3))).as_matrix()
        shift = rng.normal(0, 0.0 if k == 0 else 0.03, 3)
        some = scene[rng.random(len(scene)) < 0.5]
        views.append((some + rng.normal(0, 0.004, some.shape)) @ turn.T + shift)
        motions.append((turn, shift))
    result = register_views(views)
    for (turn, shift), motion in zip(motions, result.motions, strict=True):
        there = scene @ turn.T + shift
        back = there @ motion[:3, :3].T + motion[:3, 3]
        assert np.sqrt(np.mean(np.sum((back - scene) ** 2, axis=1))) < 0.004
    assert len(result.overlaps) == 3


def test_views_that_do_not_hang_together() -> None:
    pytest.importorskip("open3d")
    rng = np.random.default_rng(6)
    views = [rng.uniform(0, 1, (500, 3)), rng.uniform(50, 51, (500, 3))]
    with pytest.raises(InputError, match="view 2 overlaps none"):
        register_views(views)
    with pytest.raises(InputError, match="at least two"):
        register_views(views[:1])
    with pytest.raises(InputError, match="view 2 holds 5 points"):
        register_views([views[0], views[1][:5]])


def test_a_cancel_is_no_bad_input() -> None:
    pytest.importorskip("open3d")
    views = list(np.random.default_rng(6).uniform(0, 1, (3, 500, 3)))
    with pytest.raises(Cancelled):
        register_views(views, is_cancelled=lambda: True)
