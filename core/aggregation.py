"""Point aggregation with geometric constraints (paper 2.1): every point to at most one unit, by nearness to its fitted surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from .tetrapod import relate
from .unit_types import UnitType

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]


def assign(points: FloatArray, poses: FloatArray, unit: UnitType, tolerance: float) -> tuple[IntArray, FloatArray]:
    """Assign (n, 3) points to the unit whose surface is nearest, if nearer than ``tolerance`` metres.

    Returns
    -------
    labels, distance
        (n,) index of the unit, -1 for none; (n,) signed distance to the nearest unit's surface, metres, inf where none is near.
    """
    labels = np.full(len(points), -1, dtype=np.int64)
    distance = np.full(len(points), np.inf)
    if not len(poses) or not len(points):
        return labels, distance
    tree = cKDTree(points)
    reach = float(np.hypot(unit.leg_length, unit.end_radius)) + tolerance
    for k, near in enumerate(tree.query_ball_point(poses[:, :3], reach)):
        index = np.asarray(near, dtype=np.int64)
        relation = relate((points[index] - poses[k, :3]) @ poses[k, 3:].reshape(3, 3), unit)
        nearer = np.abs(relation.distance) < np.abs(distance[index])
        distance[index[nearer]] = relation.distance[nearer]
        close = nearer & (np.abs(relation.distance) < tolerance)
        labels[index[close]] = k
    return labels, distance
