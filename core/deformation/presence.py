"""What an epoch that does not show a known unit says about it: still there, its space seen to be empty, or hidden.

The places where another epoch's rays met the unit are looked up again. Where many still hold points on the unit's surface it is there.
Where they do not, and the cloud now holds points behind them that the unit used to hide, the sensor has looked through the unit's
place. Points in front of them, or none at all, say nothing: the place is hidden.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from ..adjustment.adjustment_records import AdjustmentOptions
from ..adjustment.gauss_helmert import adjust
from ..common.arrays import FloatArray
from ..common.errors import NoSolutionError
from ..model.pose import Pose
from ..model.tetrapod import distance_to_surface, relate
from ..model.unit_types import UnitType

SUPPORTED = 0.4
"""Share of the places seen before that must hold points for the unit to be there."""
GONE = 0.3
"""Share below which it is not."""
LOOKED_THROUGH = 0.05
"""Newly seen points behind the unit's surface, over the points it had, that prove its place empty."""
BANDS = (5.0, 4.0, 3.0, 2.0, 1.5, 1.5)
"""Distances from the surface, over the tolerance, from which points are taken while a unit is brought onto them."""
FEWEST_POINTS = 60
"""Points from which a pose is adjusted, where they lie dense."""
FARTHEST_HEIGHTS, FARTHEST_TURN = 0.25, math.radians(15)
"""Way in unit heights and turn beyond which a pose was drawn onto something else."""

CHANCE_SDS = 3.0
"""By how many standard deviations of their number more points must lie on the surface of a settled pose than on that of the predicted one:
six unknowns fitted to what noise and other surfaces put there always gather some."""


@dataclass(frozen=True, eq=False)
class Presence:
    """Evidence about a unit in an epoch where it was not found.

    Attributes
    ----------
    state
        ``there``, ``empty`` or ``hidden``.
    support
        Share of the places where it was seen before that hold points on its surface, 0 to 1.
    points
        (m,) indices of the points on its surface.
    """

    state: Literal["there", "empty", "hidden"]
    support: float
    points: NDArray[np.int64]


def look_up(own: FloatArray, pose: Pose, unit: UnitType, before: FloatArray, now: FloatArray, tolerance: float) -> Presence:
    """Judge a unit's place in an epoch that does not show it.

    Parameters
    ----------
    own
        (k, 3) the unit's points in an epoch that shows it.
    pose
        Where the unit would be, same frame.
    before, now
        (n, 3), (m, 3) all points around it in the epoch that shows it, and in the one that does not, both in that frame.
    tolerance
        Distance in metres within which a point lies on the surface (noise and registration).
    """
    reach = unit.reach + tolerance
    # what the unit hid lies partly beyond its own reach
    near = np.flatnonzero(np.sum((now - pose.centre) ** 2, axis=1) < (1.3 * reach) ** 2)
    if not len(near) or not len(own):
        return Presence("hidden", 0.0, np.empty(0, dtype=np.int64))
    relation = relate(pose.to_body(now[near]), unit)
    on_surface = near[np.abs(relation.distance) < tolerance]
    places = own[:: max(1, len(own) // 500)]
    spacing = float(np.median(cKDTree(own).query(places, k=min(5, len(own)))[0][:, -1])) if len(own) > 1 else tolerance
    radius = 2.5 * spacing + tolerance
    support = 0.0
    if len(on_surface):
        support = float(np.mean(cKDTree(now[on_surface]).query(places)[0] < radius))
    if support >= SUPPORTED:
        return Presence("there", support, on_surface)
    towards = relate(pose.to_body(places), unit).normal.mean(axis=0) @ pose.rotation.T
    size = float(np.linalg.norm(towards))
    if support > GONE or size < 1e-6:
        return Presence("hidden", support, on_surface)
    # points where nothing was before, and which side of the unit's former surface they are on
    fresh = near[cKDTree(before).query(now[near])[0] > max(radius, 0.05 * unit.height)] if len(before) else near
    depth = (now[fresh] - pose.centre) @ (towards / size)
    front = float(np.median((places - pose.centre) @ (towards / size)))
    behind, ahead = int(np.sum(depth < front)), int(np.sum(depth > front + 0.15 * unit.height))
    through = behind >= LOOKED_THROUGH * len(own) and behind > ahead
    return Presence("empty" if through else "hidden", support, on_surface)


def settled_on(points: FloatArray, pose: Pose, unit: UnitType, tolerance: float, fewest: int = FEWEST_POINTS) -> Pose:
    """Pose of a unit that moved since it was seen, brought onto its (n, 3) points from where another epoch predicts it.

    The points that lie on the predicted surface by chance would hold it there. The predicted pose stays where the points do not lie
    better on another one near it, nor where fewer than ``fewest`` do.
    """
    found = pose
    for band in BANDS:
        near = np.abs(distance_to_surface(found.to_body(points), unit)) < band * tolerance
        if np.count_nonzero(near) < fewest:
            return pose
        try:
            found = adjust(points[near], unit, found, options=AdjustmentOptions(radius_sd=0.0, gradient_sd=0.0)).pose
        except NoSolutionError:
            return pose
    way = float(np.linalg.norm(found.centre - pose.centre)) / unit.height
    turn = float(np.linalg.norm(Rotation.from_matrix(found.rotation @ pose.rotation.T).as_rotvec()))
    if way > FARTHEST_HEIGHTS or turn > FARTHEST_TURN:
        return pose
    before, after = (np.count_nonzero(np.abs(distance_to_surface(p.to_body(points), unit)) < 0.5 * tolerance) for p in (pose, found))
    return found if after - before > CHANCE_SDS * math.sqrt(before) else pose
