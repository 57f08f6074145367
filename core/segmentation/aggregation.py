"""Point aggregation with geometric constraints (paper 2.1): every point to at most one unit, by nearness to its fitted surface."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray, IntArray
from ..common.kernels import kernel
from ..common.neighbourhood import build_grid
from ..model.tetrapod import relate
from ..model.unit_types import UnitType
from .cone_relation import ConeShape, relate_point


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
    grid, shape = build_grid(points, 0.25 * reach), ConeShape.of(unit)
    points, poses = np.ascontiguousarray(points), np.ascontiguousarray(poses)
    for k in range(len(poses)):
        index = grid.within(poses[k, :3], reach)
        own = _distances(points[index], poses[k], shape)
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
    near_another, shape = np.zeros(len(points), dtype=np.bool_), ConeShape.of(unit)
    points, poses = np.ascontiguousarray(points), np.ascontiguousarray(poses)
    centres = cKDTree(poses[:, :3])
    order = np.argsort(labels, kind="stable")
    starts = np.searchsorted(labels[order], np.arange(len(poses) + 1))
    for k in range(len(poses)):
        own = order[starts[k] : starts[k + 1]]
        rotation = poses[k, 3:].reshape(3, 3)
        relation = relate((points[own] - poses[k, :3]) @ rotation, unit)
        normal = relation.normal @ rotation.T
        foot = points[own] - relation.distance[:, None] * normal
        image = foot - relation.distance[:, None] * normal
        size = np.abs(relation.distance)
        # a surface that is nearer to an image than the point's own is nearer to the foot than twice as far
        reach = unit.reach + max(clearance, 2 * float(size.max(initial=0.0)))
        others = [j for j in centres.query_ball_point(poses[k, :3], unit.reach + reach) if j != k]
        near_another[own] = _near_others(foot, image, size, poses[others], shape, clearance, reach)
    return near_another


@kernel()
def _near_others(feet: Any, images: Any, sizes: Any, poses: Any, shape: Any, clearance: float, reach: float) -> Any:
    """(n,) whether another unit's surface lies within ``clearance`` of a point's foot, or nearer to its image than its own does."""
    near = np.zeros(len(feet), dtype=np.bool_)
    for i in range(len(feet)):
        for j in range(len(poses)):
            d0, d1, d2 = feet[i, 0] - poses[j, 0], feet[i, 1] - poses[j, 1], feet[i, 2] - poses[j, 2]
            if d0 * d0 + d1 * d1 + d2 * d2 >= reach * reach:
                continue
            gap = abs(_distance(feet[i], poses[j], shape))
            # the image is no further from the foot than the point
            if gap < clearance or (gap < 2.0 * sizes[i] and abs(_distance(images[i], poses[j], shape)) < sizes[i]):
                near[i] = True
                break
    return near


@kernel()
def _distances(points: Any, pose: Any, shape: Any) -> Any:
    """(n,) signed distances of (n, 3) points from the surface of a unit with a pose (12,), metres."""
    result = np.empty(len(points))
    for i in range(len(points)):
        result[i] = _distance(points[i], pose, shape)
    return result


@kernel()
def _distance(point: Any, pose: Any, shape: Any) -> Any:
    """Signed distance of a point (3,) from the surface of a unit with a pose (12,), metres."""
    legs, radius, gradient, length, _ = shape
    d0, d1, d2 = point[0] - pose[0], point[1] - pose[1], point[2] - pose[2]
    x = d0 * pose[3] + d1 * pose[6] + d2 * pose[9]
    y = d0 * pose[4] + d1 * pose[7] + d2 * pose[10]
    z = d0 * pose[5] + d1 * pose[8] + d2 * pose[11]
    return relate_point(x, y, z, legs, radius, gradient, length)[1]
