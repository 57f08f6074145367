"""Legs whose face of fracture is turned away are named from what is seen where they should be; shadows break none."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.common.neighbourhood import build_grid
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.leg_ends import BROKEN, LegView, leg_ends
from tetratrack.core.segmentation.sight_lines import SightLines, shaft_patches

UNIT = UnitType.tetrapod(2.3)
LOOKS = np.array([[0.35, 0.1, 0.93], [-0.4, -0.1, 0.91], [0.05, 0.45, 0.89]])
"""Towards the sensor, from above."""


def seen_from_above(points: np.ndarray, pixel: float = 0.03) -> np.ndarray:
    """(m, 3) points that no other hides in one of the directions."""
    shown = np.zeros(len(points), dtype=bool)
    for look in LOOKS / np.linalg.norm(LOOKS, axis=1)[:, None]:
        across = np.cross(look, [0.0, 1.0, 0.0])
        across /= np.linalg.norm(across)
        key = np.floor(np.column_stack([points @ across, points @ np.cross(look, across)]) / pixel).astype(np.int64)
        _, cell = np.unique(key, axis=0, return_inverse=True)
        top = np.full(cell.max() + 1, -np.inf)
        depth = points @ look
        np.maximum.at(top, cell, depth)
        shown |= depth > top[cell] - 0.08
    return points[shown]


def scene(rng: np.random.Generator, *, broken: bool, roof: bool = False) -> tuple[np.ndarray, np.ndarray]:
    """Cloud and (2, 12) poses of two units over flat ground; leg 2 of the first may lack its end, or a roof may hide it."""
    rotation = Rotation.from_euler("xyz", [20, 15, 30], degrees=True).as_matrix()
    clouds, poses = [], []
    for k, place in enumerate(([0.0, 0.0, 1.3], [2.8, 0.3, 1.3])):
        body, _, _ = sample_surface(UNIT, 60_000, rng)
        lean = body @ UNIT.leg_directions.T
        if k == 0 and broken:
            body = body[~((np.argmax(lean, axis=1) == 1) & (lean[:, 1] > 0.66 * UNIT.leg_length))]
        clouds.append(body @ rotation.T + place)
        poses.append(np.concatenate([place, rotation.ravel()]))
    ground = np.column_stack([rng.uniform(-4, 6, (120_000, 2)), np.zeros(120_000)])
    end = poses[0][:3] + rotation @ UNIT.leg_directions[1] * UNIT.leg_length
    if roof:
        clouds.append(np.column_stack([end[:2] + rng.uniform(-0.5, 0.5, (20_000, 2)), np.full(20_000, end[2] + 0.9)]))
    cloud = seen_from_above(np.vstack([*clouds, ground]))
    return cloud + rng.normal(0, 0.008, cloud.shape), np.array(poses)


@pytest.mark.parametrize(("broken", "roof", "expected"), [(True, False, True), (False, False, False), (False, True, False)])
def test_a_leg_is_missed_where_what_lies_behind_it_is_seen(broken: bool, roof: bool, expected: bool) -> None:
    cloud, poses = scene(np.random.default_rng(4), broken=broken, roof=roof)
    lines = SightLines(cloud, build_grid(cloud, 0.5), poses, UNIT, 0.008)
    body = (cloud - poses[0, :3]) @ poses[0, 3:].reshape(3, 3)
    ends = leg_ends(LegView(body[np.linalg.norm(body, axis=1) < 1.1 * UNIT.reach], UNIT, 0.008), partial(lines.missing, 0))
    assert (ends.states[1] == BROKEN) == expected
    assert (ends.states[[0, 2, 3]] != BROKEN).all()
    if expected:
        assert ends.missing[1] == pytest.approx(0.34 * UNIT.leg_length, abs=0.1 * UNIT.leg_length)


def test_shafts_alone_are_open_to_the_directions_to_which_they_are_among_all_patches() -> None:
    cloud, poses = scene(np.random.default_rng(5), broken=False)
    alone, all_patches = (SightLines(cloud, build_grid(cloud, 0.5), poses, UNIT, 0.008) for _ in range(2))
    for number in range(2):
        shafts = alone.look_at_shafts(number)
        assert shafts.any()
        assert (shafts == all_patches.look(number)[shaft_patches().ravel()]).all()
        assert (shafts == all_patches.look_at_shafts(number)).all()
