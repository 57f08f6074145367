"""Clouds in frames of their own: the units themselves tell how one lies against the other."""

from __future__ import annotations

import numpy as np
import pytest
from constellations import UNIT, found, moved, pile
from scipy.spatial.transform import Rotation
from tetratrack.core.deformation.constellation import align, aligned_share


@pytest.mark.parametrize(
    ("degrees", "tilt", "shift"),
    [(4.0, 0.0, (3.0, -2.0, 1.5)), (137.0, 0.0, (-400.0, 250.0, 12.0)), (0.0, 3.0, (0.0, 0.0, 26.4)), (90.0, 5.0, (10.0, 0.0, 0.0))],
)
def test_a_frame_turned_and_shifted_is_found(degrees: float, tilt: float, shift: tuple[float, float, float]) -> None:
    for seed in range(3):
        rng = np.random.default_rng(seed)
        poses = pile(rng)
        rotation = Rotation.from_euler("zx", [degrees, tilt], degrees=True).as_matrix()
        # a tenth of the units have gone, and as many came
        later = moved(poses[7:], rotation, np.array(shift))
        first, second = found(poses[:-7], rng), found(later, rng)
        assert aligned_share(first, second, UNIT.height) < 0.25
        motion = align(first, second, [UNIT])
        assert motion is not None
        assert motion.matched >= 50
        back = np.array([motion.rotation @ p.centre + motion.translation for p in later])
        assert np.abs(back - [p.centre for p in poses[7:]]).max() < 0.03


def test_piles_that_have_nothing_in_common_are_not_aligned() -> None:
    for seed in range(3):
        rng = np.random.default_rng(seed)
        assert align(found(pile(rng), rng), found(pile(rng), rng), [UNIT]) is None


def test_an_aligned_pile_is_left_alone() -> None:
    rng = np.random.default_rng(1)
    poses = pile(rng)
    assert aligned_share(found(poses, rng), found(poses[10:], rng), UNIT.height) > 0.95


def test_too_few_units_say_nothing() -> None:
    rng = np.random.default_rng(2)
    poses = pile(rng, 4)
    assert align(found(poses, rng), found(moved(poses, np.eye(3), np.array([50.0, 0, 0])), rng), [UNIT]) is None
