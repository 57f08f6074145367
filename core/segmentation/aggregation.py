"""Point aggregation with geometric constraints (paper 2.1): every point to at most one unit, by nearness to its fitted surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray, IntArray
from ..common.neighbourhood import build_grid
from ..model.tetrapod import distance_to_surface, relate
from ..model.unit_types import UnitType


def assign(
    points: FloatArray, poses: FloatArray, unit: UnitType, tolerance: float, *, clearance: float = 0.0
) -> tuple[IntArray, FloatArray]:
    """Assign (n, 3) points to the unit whose surface is nearest, if nearer than ``tolerance`` metres.

    Where two surfaces come closer than the noise, the nearer one takes points of the other, always those displaced towards it,
    which pushes both fits apart. With a ``clearance`` in metres :func:`contested` points are not assigned.

    Returns
    -------
    labels, distance
        (n,) index of the unit, -1 for none; (n,) signed distance to the nearest unit's surface, metres, inf where none is near.
    """
    labels = np.full(len(points), -1, dtype=np.int64)
    distance = np.full(len(points), np.inf)
    if not len(poses) or not len(points):
        return labels, distance
    reach = unit.reach + tolerance
    grid = build_grid(points, 0.25 * reach)
    for k in range(len(poses)):
        index = grid.within(points, poses[k, :3], reach)
        own = distance_to_surface((points[index] - poses[k, :3]) @ poses[k, 3:].reshape(3, 3), unit)
        nearer = np.abs(own) < np.abs(distance[index])
        distance[index[nearer]] = own[nearer]
        close = nearer & (np.abs(own) < tolerance)
        labels[index[close]] = k
    if clearance > 0:
        labels[contested(points, labels, poses, unit, clearance)] = -1
    return labels, distance


def contested(points: FloatArray, labels: IntArray, poses: FloatArray, unit: UnitType, clearance: float) -> NDArray[np.bool_]:
    """(n,) whether an assigned point lies where another unit could have it as well.

    It does where its foot on its own unit's surface is within ``clearance`` metres of another unit's surface, a choice by place and
    not by residual, and where its mirror image in its own unit's surface is nearer to another: points on the side towards a neighbour
    are lost to it, and without those on the other side they leave no bias.
    """
    near_another = np.zeros(len(points), dtype=np.bool_)
    centres = cKDTree(poses[:, :3])
    order = np.argsort(labels, kind="stable")
    starts = np.searchsorted(labels[order], np.arange(len(poses) + 1))
    for k in range(len(poses)):
        own = order[starts[k] : starts[k + 1]]
        rotation = poses[k, 3:].reshape(3, 3)
        relation = relate((points[own] - poses[k, :3]) @ rotation, unit)
        normal = relation.normal @ rotation.T
        foot = points[own] - relation.distance[:, None] * normal
        size = np.abs(relation.distance)
        # a surface that is nearer to an image than the point's own is nearer to the foot than twice as far
        reach = unit.reach + max(clearance, 2 * float(size.max(initial=0.0)))
        for j in centres.query_ball_point(poses[k, :3], unit.reach + reach):
            inside = np.flatnonzero(np.sum((foot - poses[j, :3]) ** 2, axis=1) < reach**2)
            if j == k or not len(inside):
                continue
            gap = _distance(foot[inside], poses[j], unit)
            near_another[own[inside[gap < clearance]]] = True
            # the image is no further from the foot than the point
            inside = inside[(gap >= clearance) & (gap < 2 * size[inside])]
            image = foot[inside] - relation.distance[inside, None] * normal[inside]
            near_another[own[inside[_distance(image, poses[j], unit) < size[inside]]]] = True
    return near_another


def _distance(points: FloatArray, pose: FloatArray, unit: UnitType) -> FloatArray:
    """(n,) distance of (n, 3) points from the surface of a unit with a pose (12,), metres."""
    return np.abs(distance_to_surface((points - pose[:3]) @ pose[3:].reshape(3, 3), unit))
