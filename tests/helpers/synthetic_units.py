"""Small piles of units as point clouds with strips, for tests that need points but no instrument."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation
from tetratrack.core.deformation.displacement import UnitPair
from tetratrack.core.model.feature_points import feature_points
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType

FloatArray = NDArray[np.float64]
UNIT = UnitType.tetrapod(2.3)
ALL_DISCS = np.ones(4, dtype=np.bool_)


def unturned_pair(poses: tuple[Pose, Pose], unit: UnitType, joint: FloatArray) -> UnitPair:
    """A unit that kept its attitude, with the (12, 12) covariance of both poses, all of it of noise."""
    before, after = (feature_points(pose, unit) for pose in poses)
    return UnitPair(
        before=before, after=after, joint=joint, noise=joint,
        turn=np.zeros(3), turn_covariance=np.eye(3), turn_noise=np.eye(3), height=unit.height,
    )  # fmt: skip


@dataclass(frozen=True, eq=False)
class UnitCloud:
    """Points of one unit seen from above, and the strip each comes from."""

    pose: Pose
    points: FloatArray
    sources: NDArray[np.int64]


def grid_poses(rng: np.random.Generator, side: int = 4) -> list[Pose]:
    """Units in random orientation, 1.3 H apart."""
    step = 1.3 * UNIT.height
    places = [np.array([i * step, j * step, 0.3 * i]) for i in range(side) for j in range(side)]
    return [Pose(p, r.as_matrix()) for p, r in zip(places, Rotation.random(len(places), random_state=rng), strict=True)]


def seen_from_above(
    pose: Pose, rng: np.random.Generator, count: int, noise: float, offsets: FloatArray | None = None, roughness: FloatArray | None = None
) -> UnitCloud:
    """Points on the upper side with noise along the normal; strip k is shifted by row k of ``offsets`` (s, 3)."""
    body, normals, _ = sample_surface(UNIT, 4 * count, rng)
    up = (normals @ pose.rotation.T)[:, 2] > 0.1
    body, normals = body[up][:count], normals[up][:count]
    bumps = np.zeros(len(body)) if roughness is None else np.cos(body @ roughness.T).sum(axis=1) * 0.002
    points = pose.to_frame(body + normals * (rng.normal(0, noise, len(body)) + bumps)[:, None])
    sources = rng.integers(0, 1 if offsets is None else len(offsets), len(points))
    if offsets is not None:
        points = points + offsets[sources]
    return UnitCloud(pose, points, sources)
