"""The paper's simulated clouds (section 3.1): one unit (Fig. 8) and fifty interlocked units on a slope (Fig. 9), with uniform noise."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..model.pose import Pose
from ..model.tetrapod import sample_surface
from ..model.unit_types import UnitType

COLUMN_SPACING, ROW_SPACING = 1.23, 0.97
"""Distances of neighbours in a layer, as fractions of H, at which the two layers interlock without touching."""
UPPER_LAYER = (0.615, 0.097, 0.291)
"""Place of the upper layer's first unit from the lower one's: along the row, up the slope, out of the slope, fractions of H."""
POINTS_PER_UNIT = 2000


@dataclass(frozen=True, eq=False)
class SimulatedCloud:
    """Points drawn from the model's surface, with what they were drawn from.

    Attributes
    ----------
    points
        (n, 3) metres, with noise.
    unit_index
        (n,) index into ``poses``.
    leg
        (n,) leg 0..3.
    poses
        Exact poses of the units.
    """

    points: FloatArray
    unit_index: IntArray
    leg: IntArray
    poses: tuple[Pose, ...]


def single_unit(
    unit: UnitType, noise: float, rng: np.random.Generator, *, count: int = POINTS_PER_UNIT, pose: Pose | None = None
) -> SimulatedCloud:
    """One unit seen from everywhere (paper Fig. 8).

    Parameters
    ----------
    noise
        Half width of the uniform noise of every coordinate, metres.
    pose
        Where the unit stands; its body frame when None.
    """
    return cloud_of(unit, (pose or Pose(np.zeros(3), np.eye(3)),), noise, rng, count=count)


def interlocked_rows(
    unit: UnitType,
    noise: float,
    rng: np.random.Generator,
    *,
    columns: int = 10,
    lower_rows: int = 3,
    upper_rows: int = 2,
    slope: float = 2 / 3,
    count: int = POINTS_PER_UNIT,
) -> SimulatedCloud:
    """Rows of equal units in two interlocked layers on a slope (paper Fig. 9: fifty units).

    The lower layer stands on three legs with the fourth out of the slope; the upper layer lies head down in its gaps. x runs along the
    rows, -y up the slope, z up; the first unit of the lowest row is at the origin.

    Parameters
    ----------
    noise
        Half width of the uniform noise of every coordinate, metres (the paper: 0.01 to 0.20).
    slope
        Rise per metre.
    """
    return cloud_of(
        unit, interlocked_poses(unit, columns=columns, lower_rows=lower_rows, upper_rows=upper_rows, slope=slope), noise, rng, count=count
    )


def interlocked_poses(
    unit: UnitType, *, columns: int = 10, lower_rows: int = 3, upper_rows: int = 2, slope: float = 2 / 3
) -> tuple[Pose, ...]:
    """Poses of ``interlocked_rows``."""
    angle = math.atan(slope)
    along = np.array([1.0, 0, 0])
    upslope = np.array([0, -math.cos(angle), math.sin(angle)])
    outward = np.array([0, math.sin(angle), math.cos(angle)])
    frame = np.column_stack([along, upslope, outward]) * unit.height
    # leg 1 out of the slope and leg 2 up the slope; in the upper layer leg 1 into the slope and a leg in each gap
    standing = np.column_stack([upslope, along, outward])
    turn = math.radians(30)
    turned = np.column_stack(
        [math.cos(turn) * along + math.sin(turn) * upslope, math.cos(turn) * upslope - math.sin(turn) * along, -outward]
    )
    poses = []
    for row in range(lower_rows):
        poses += [Pose(frame @ [COLUMN_SPACING * k, ROW_SPACING * row, 0.0], standing) for k in range(columns)]
    for row in range(upper_rows):
        place = np.array([0.0, ROW_SPACING * row, 0.0]) + UPPER_LAYER
        poses += [Pose(frame @ (place + np.array([COLUMN_SPACING * k, 0, 0])), turned) for k in range(columns)]
    return tuple(poses)


def cloud_of(
    unit: UnitType, poses: tuple[Pose, ...], noise: float, rng: np.random.Generator, *, count: int = POINTS_PER_UNIT
) -> SimulatedCloud:
    """``count`` points on the lateral surfaces of each of some units (no end discs, no occlusion), with uniform noise.

    Raises
    ------
    ValueError
        The noise is negative or not a number.
    """
    if not noise >= 0:
        raise ValueError(f"noise must be zero or positive, got {noise!r}")
    points, legs = [], []
    for pose in poses:
        body, _, leg = sample_surface(unit, count, rng, end_discs=False)
        points.append(pose.to_frame(body))
        legs.append(leg)
    exact = np.vstack(points)
    noisy = exact + rng.uniform(-noise, noise, exact.shape)
    return SimulatedCloud(noisy, np.repeat(np.arange(len(poses)), count), np.concatenate(legs), poses)
