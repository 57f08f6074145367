"""Units of a pile as a detector finds them, and the same pile in another frame."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation
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
