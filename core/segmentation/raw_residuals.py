"""How the raw points of a noisy cloud lie to poses: what elements moved onto a shared surface no longer tell.

Raw points of a unit lie about its surface as the noise says, and so do their means over patches of it; rock that was smoothed alike lies on
one side here and on the other there. Smoothing takes both for a surface, and its elements fit either about as well.
"""

from __future__ import annotations

import numpy as np

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.neighbourhood import build_grid
from ..model.tetrapod import END_DISC, TIP_RATIO, SurfaceRelation, across_legs, relate
from ..model.unit_types import UnitType
from .aggregation import assign, contested
from .pose_evidence import AXIAL_CELLS, AZIMUTH_CELLS, CELLS_PER_LEG, INNER_RATIO, NUMBER_OF_CELLS, OUTER_SHARE

WINDOW, DEEP, REACH = 3.0, 8.0, 7.0
"""In standard deviations of a point: up to which it is of the surface, from which it lies deep inside, which counts three times, and how
far beyond the solid points are looked at."""
OWNED = 3.5
"""The same, up to which a point belongs to the pose whose surface is nearest."""
FEWEST_OF_PATCH, FEWEST_PATCHES = 6, 3
"""Points of a patch that have a mean, and such patches of a pose that its residuals tell anything of."""
LEAST_CHI_SQUARE, LEAST_SHARE = 0.3, 0.02
"""Added before the logarithm."""
UNKNOWN = (0.26, 0.0, 0.0)
"""Of a pose without enough patches: means as the noise has them, and nothing that speaks for it."""


def raw_residuals(points: FloatArray, poses: FloatArray, unit: UnitType, noise: float) -> FloatArray:
    """(k, 3) how (n, 3) raw points lie to (k, 12) poses that compete for them, reduced frame, metres.

    Logarithm of the mean of squared means over patches of the surface, in standard deviations of these; variance of points within patches
    over that of the noise; logarithm of the share of points inside, those within the outer part of one leg, which may be broken off, left
    out.

    Parameters
    ----------
    noise
        Standard deviation of a point across the surface, metres.
    """
    out = np.tile(UNKNOWN, (len(poses), 1))
    if not len(poses) or not len(points):
        return out
    labels, _ = assign(points, poses, unit, OWNED * noise)
    doubtful = contested(points, labels, poses, unit, noise)
    reach = unit.reach + REACH * noise
    grid = build_grid(points, 0.25 * reach)
    for k, pose in enumerate(poses):
        near = grid.within(pose[:3], reach)
        near = near[(labels[near] == k) | (labels[near] < 0)]
        body = (points[near] - pose[:3]) @ pose[3:].reshape(3, 3)
        relation = relate(body, unit)
        own = ~doubtful[near] & (relation.axial < TIP_RATIO * unit.leg_length)
        out[k] = _of_pose(relation, _patches(body, relation, unit), relation.distance / noise, own, unit)
    return out


def _patches(body: FloatArray, relation: SurfaceRelation, unit: UnitType) -> IntArray:
    """(n,) patch of the surface of each of (n, 3) points in the body frame."""
    first, second = across_legs(unit)
    azimuth = np.arctan2(np.sum(body * second[relation.leg], axis=1), np.sum(body * first[relation.leg], axis=1))
    around = np.minimum((azimuth + np.pi) / (2 * np.pi) * AZIMUTH_CELLS, AZIMUTH_CELLS - 1).astype(np.int64)
    low = INNER_RATIO * unit.height
    along = np.clip((relation.axial - low) / (unit.leg_length - low) * AXIAL_CELLS, 0, AXIAL_CELLS - 1).astype(np.int64)
    within = np.where(relation.part == END_DISC, CELLS_PER_LEG - 1, AXIAL_CELLS * around + along)
    return np.asarray(CELLS_PER_LEG * relation.leg + within)


def _of_pose(relation: SurfaceRelation, patch: IntArray, residual: FloatArray, own: BoolArray, unit: UnitType) -> FloatArray:
    """(3,) of one pose from (n,) residuals in standard deviations; ``own`` (n,) whether they are no other unit's, nor of a rounded tip."""
    on = np.abs(residual) < WINDOW
    used = on & own
    count, total, squares = (
        np.bincount(patch[used], weights, minlength=NUMBER_OF_CELLS) for weights in (None, residual[used], residual[used] ** 2)
    )
    full = count >= FEWEST_OF_PATCH
    patches = np.count_nonzero(full)
    if patches < FEWEST_PATCHES:
        return np.array(UNKNOWN)
    between = np.sum(total[full] ** 2 / count[full])
    within = (squares[full].sum() - between) / (count[full].sum() - patches)
    depth = np.where(residual < -DEEP, 3.0, np.where(residual < -WINDOW, 1.0, 0.0))
    outer = np.bincount(relation.leg, depth * (relation.axial > OUTER_SHARE * unit.leg_length), minlength=4)
    inside = (depth.sum() - outer.max()) / max(np.count_nonzero(on), 1)
    return np.array([np.log(between / patches + LEAST_CHI_SQUARE), within, np.log(inside + LEAST_SHARE)])
