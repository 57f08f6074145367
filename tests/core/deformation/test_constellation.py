"""Clouds in frames of their own: the units themselves tell how one lies against the other."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.deformation.constellation import align, aligned_share
from tetratrack.core.deformation.identity import FoundUnits
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.unit_types import UnitType

UNIT = UnitType.tetrapod(2.3)


def pile(rng: np.random.Generator, count: int = 70, length: float = 30.0) -> list[Pose]:
    """Units in random orientation, no two centres nearer than 0.55 H."""
    centres: list[np.ndarray] = []
    while len(centres) < count:
        candidate = rng.uniform(0, [length, 12, 5])
        if all(np.linalg.norm(candidate - c) > 0.55 * UNIT.height for c in centres):
            centres.append(candidate)
    return [Pose(c, r.as_matrix()) for c, r in zip(centres, Rotation.random(count, random_state=rng), strict=True)]


def found(poses: list[Pose], rng: np.random.Generator) -> FoundUnits:
    """As a detector gives them: any leg numbers, errors of a centimetre and half a degree."""
    noisy = [p.perturbed(rng.normal(0, 0.01, 3), rng.normal(0, 0.008, 3)).relabelled(UNIT.symmetries[rng.integers(12)]) for p in poses]
    return FoundUnits(tuple(noisy), np.zeros(len(poses), dtype=np.int64), np.ones(len(poses), dtype=bool))


def moved(poses: list[Pose], rotation: np.ndarray, shift: np.ndarray) -> list[Pose]:
    return [Pose(rotation @ p.centre + shift, rotation @ p.rotation) for p in poses]


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
