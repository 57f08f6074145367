"""How the raw points of a noisy cloud lie to poses: what elements moved onto a shared surface no longer tell.

Raw points of a unit lie about its surface as the noise says, and so do their means over patches of it; rock that was smoothed alike lies on
one side here and on the other there. Smoothing takes both for a surface, and its elements fit either about as well.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

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
UNKNOWN = (0.26, 1.0, 0.0)
"""Of a pose without enough patches: means as the noise has them, and nothing that speaks for it."""
FIT_LIMIT, FIT_ROUNDS, MOST_FITTED = 4.0, 10, 1500
"""Distance from the surface, in standard deviations of a point, at which a point no longer draws a pose (Tukey's biweight); rounds; points
of a pose that take part."""
BROKEN_FROM, BROKEN_POINTS, BROKEN_SHARE = 0.5, 8, 0.03
"""Of a leg's length, beyond which nothing is asked of a leg whose end seems to be broken off, obliquely as a rule; points inside its outer
part, at the fewest and as a share of those on the surface, where it does."""
LARGEST_STEP, RIDGE = 0.05, 1e-3
"""Of a round, as a share of the height; added to the diagonal of the normal matrix, as a share of its mean over shifts: the turn about a
leg may be open."""


def raw_residuals(
    points: FloatArray, poses: FloatArray, unit: UnitType, noise: float, *, first: int = 0, settle: bool = True
) -> FloatArray:
    """(k, 3) how (n, 3) raw points lie to (k, 12) poses that compete for them, reduced frame, metres.

    Logarithm of the mean of squared means over patches of the surface, in standard deviations of these; variance of points within patches
    over that of the noise; logarithm of the share of points inside, those within the outer part of one leg, which may be broken off, left
    out.

    Parameters
    ----------
    noise
        Standard deviation of a point across the surface, metres.
    first
        Pose from which on it is asked; nothing is said of those before.
    settle
        Take each pose to where its points lie closest to it: elements of a shared surface lie beside them.
    """
    out = np.tile(UNKNOWN, (len(poses), 1))
    if not len(poses) or not len(points):
        return out
    reach = unit.reach + REACH * noise
    grid = build_grid(points, 0.25 * reach)
    if settle:
        labels, doubtful = _owned(points, poses, unit, noise)
        poses = poses.copy()
        for k in range(first, len(poses)):
            near = grid.within(poses[k, :3], reach)
            near = near[((labels[near] == k) | (labels[near] < 0)) & ~doubtful[near]]
            poses[k] = _settled(poses[k], points[near], unit, noise)
    labels, doubtful = _owned(points, poses, unit, noise)
    for k in range(first, len(poses)):
        near = grid.within(poses[k, :3], reach)
        near = near[(labels[near] == k) | (labels[near] < 0)]
        out[k] = _of_points(poses[k], points[near], doubtful[near], unit, noise, settle=settle)
    return out


def _of_points(pose: FloatArray, points: FloatArray, doubtful: BoolArray, unit: UnitType, noise: float, *, settle: bool) -> FloatArray:
    """(3,) of one (12,) pose from (n, 3) points around it that are no other's; ``doubtful`` (n,) says which of them may be.

    Where points reach into a leg its end is broken off: from there on it draws the pose no more, and nothing is asked of it.
    """
    body, relation = _in_body(points, pose, unit)
    leg = _broken_leg(relation, relation.distance / noise, unit)
    if leg >= 0:
        kept = ~_beyond_break(relation, leg, unit)
        if settle:
            pose = _settled(pose, points[kept & ~doubtful], unit, noise)
            body, relation = _in_body(points, pose, unit)
            kept = ~_beyond_break(relation, leg, unit)
        points, doubtful = points[kept], doubtful[kept]
        body, relation = _in_body(points, pose, unit)
    own = ~doubtful & (relation.axial < TIP_RATIO * unit.leg_length)
    return _of_pose(relation, _patches(body, relation, unit), relation.distance / noise, own, unit, forgiven=leg >= 0)


def _in_body(points: FloatArray, pose: FloatArray, unit: UnitType) -> tuple[FloatArray, SurfaceRelation]:
    """(n, 3) points in the body frame of a (12,) pose, and how they lie to its surface."""
    body = (points - pose[:3]) @ pose[3:].reshape(3, 3)
    return body, relate(body, unit)


def _owned(points: FloatArray, poses: FloatArray, unit: UnitType, noise: float) -> tuple[IntArray, BoolArray]:
    """Pose that each of (n, 3) points lies nearest to, -1 for none, and whether it may as well be another one's."""
    labels, _ = assign(points, poses, unit, OWNED * noise)
    return labels, contested(points, labels, poses, unit, noise)


def _settled(pose: FloatArray, points: FloatArray, unit: UnitType, noise: float) -> FloatArray:
    """A (12,) pose where (n, 3) points lie closest to it: robust least squares of their distances."""
    points = points[:: -(-len(points) // MOST_FITTED) or 1]
    centre, turn = pose[:3], pose[3:].reshape(3, 3)
    for _ in range(FIT_ROUNDS):
        body = (points - centre) @ turn
        relation = relate(body, unit)
        weights = np.maximum(1 - (relation.distance / (FIT_LIMIT * noise)) ** 2, 0.0) ** 2
        # turns in heights, so that all six are lengths
        rows = -np.hstack([relation.normal, np.cross(body, relation.normal) / unit.height])
        normal = (weights[:, None] * rows).T @ rows
        spread = np.trace(normal[:3, :3]) / 3
        if spread <= 0:
            break
        step = -np.linalg.solve(normal + RIDGE * spread * np.eye(6), rows.T @ (weights * relation.distance)) / unit.height
        step /= max(1.0, float(np.abs(step).max()) / LARGEST_STEP)
        centre = centre + turn @ step[:3] * unit.height
        turn = turn @ Rotation.from_rotvec(step[3:]).as_matrix()
    return np.concatenate([centre, turn.ravel()])


def _patches(body: FloatArray, relation: SurfaceRelation, unit: UnitType) -> IntArray:
    """(n,) patch of the surface of each of (n, 3) points in the body frame."""
    first, second = across_legs(unit)
    azimuth = np.arctan2(np.sum(body * second[relation.leg], axis=1), np.sum(body * first[relation.leg], axis=1))
    around = np.minimum((azimuth + np.pi) / (2 * np.pi) * AZIMUTH_CELLS, AZIMUTH_CELLS - 1).astype(np.int64)
    low = INNER_RATIO * unit.height
    along = np.clip((relation.axial - low) / (unit.leg_length - low) * AXIAL_CELLS, 0, AXIAL_CELLS - 1).astype(np.int64)
    within = np.where(relation.part == END_DISC, CELLS_PER_LEG - 1, AXIAL_CELLS * around + along)
    return np.asarray(CELLS_PER_LEG * relation.leg + within)


def _broken_leg(relation: SurfaceRelation, residual: FloatArray, unit: UnitType) -> int:
    """The leg into whose outer part points reach, of (n,) residuals in standard deviations; -1 where none is."""
    inside = np.bincount(relation.leg[(residual < -WINDOW) & (relation.axial > OUTER_SHARE * unit.leg_length)], minlength=4)
    leg = int(np.argmax(inside))
    fewest = max(BROKEN_POINTS, BROKEN_SHARE * np.count_nonzero(np.abs(residual) < WINDOW))
    return leg if inside[leg] >= fewest else -1


def _beyond_break(relation: SurfaceRelation, leg: int, unit: UnitType) -> BoolArray:
    """(n,) whether points lie where a leg is no more."""
    return np.asarray((relation.leg == leg) & (relation.axial > BROKEN_FROM * unit.leg_length))


def _of_pose(
    relation: SurfaceRelation, patch: IntArray, residual: FloatArray, own: BoolArray, unit: UnitType, *, forgiven: bool
) -> FloatArray:
    """(3,) of one pose from (n,) residuals in standard deviations.

    ``own`` (n,) says whether they are no other unit's, nor of a rounded tip; ``forgiven`` whether points of a broken leg are left out.
    """
    on = np.abs(residual) < WINDOW
    if not on.any():
        return np.array(UNKNOWN)
    used = on & own
    count, total, squares = (
        np.bincount(patch[used], weights, minlength=NUMBER_OF_CELLS) for weights in (None, residual[used], residual[used] ** 2)
    )
    full = count >= FEWEST_OF_PATCH
    patches = np.count_nonzero(full)
    chi_square, within = UNKNOWN[:2]
    if patches >= FEWEST_PATCHES:
        between = np.sum(total[full] ** 2 / count[full])
        chi_square = np.log(between / patches + LEAST_CHI_SQUARE)
        within = (squares[full].sum() - between) / (count[full].sum() - patches)
    depth = np.where(residual < -DEEP, 3.0, np.where(residual < -WINDOW, 1.0, 0.0))
    outer = np.bincount(relation.leg, depth * (relation.axial > OUTER_SHARE * unit.leg_length), minlength=4)
    inside = (depth.sum() - (0.0 if forgiven else outer.max())) / np.count_nonzero(on)
    return np.array([chi_square, within, np.log(inside + LEAST_SHARE)])
