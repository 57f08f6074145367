"""Whether two sightings show the same physical unit: the fine relief of its surface, which no two castings share.

Formwork, honeycombing and wear leave a relief of millimetres on every unit. What is left of the distances to the cones once their
local mean is taken away is compared point by point between two sightings, under each of the rotations that map the body onto itself.
Features of the mould are common to all units and come back on every leg, so that the level of the correlation says little; a unit is
recognised by one rotation that correlates far better than all others, which also gives its leg numbers. The method needs noise of the
order of the relief (terrestrial scans); where the noise drowns it, it recognises nothing.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray
from ..model.pose import Pose
from ..model.tetrapod import distance_to_surface
from ..model.unit_types import UnitType

LATERAL = (0.4, 0.85)
"""Part of a leg's length, from the centre, that no fillet and no rounded tip reaches."""
DEPTH_HEIGHTS = 0.008
"""Largest distance to the cone, in unit heights, that is relief and not growth or a neighbour."""
SMOOTHING = 50
"""Neighbours whose mean is taken away: what the scale, the pose and drifts of the sensor add is smooth over them."""
REACH_HEIGHTS = 0.012
"""Largest distance of two points, in unit heights, that are taken for the same place: less than the relief's correlation length."""
MAX_POINTS = 6000
MIN_PAIRS = 300
"""Points with a partner below which a rotation is not judged."""
LEAST_ROTATIONS = 4
RECOGNISED = 5.0
"""Lead of the best rotation over the second, in standard deviations of the correlation of unrelated points: 3.5 of the difference of two
such correlations."""


@dataclass(frozen=True, eq=False)
class Texture:
    """Relief of one sighting: (n, 3) points on the lateral surfaces in the body frame, (n,) heights over their local mean, metres."""

    points: FloatArray
    heights: FloatArray

    @cached_property
    def tree(self) -> cKDTree:
        """Of the points: one sighting is compared with many."""
        return cKDTree(self.points)


@dataclass(frozen=True, eq=False)
class Likeness:
    """Comparison of two textures.

    Attributes
    ----------
    symmetry
        (3, 3) rotation of the body that gives the second sighting the leg numbers of the first (``Pose.relabelled``).
    correlation
        Of the relief under it.
    lead
        Its lead over the next best rotation, in standard deviations of an unrelated pair; 0 where too little is seen in both.
    """

    symmetry: FloatArray
    correlation: float
    lead: float

    @property
    def same_unit(self) -> bool:
        """Whether the relief proves both sightings to be one unit."""
        return self.lead > RECOGNISED


def texture(points: FloatArray, sources: NDArray[np.integer], pose: Pose, unit: UnitType) -> Texture:
    """Relief of a unit from its (n, 3) points and their (n,) strips or stations, whose offsets do not matter."""
    body = pose.to_body(points)
    along = (body @ unit.leg_directions.T).max(axis=1) / unit.leg_length
    heights = distance_to_surface(body, unit)
    lateral = (along > LATERAL[0]) & (along < LATERAL[1]) & (np.abs(heights) < DEPTH_HEIGHTS * unit.height)
    parts = [(np.empty((0, 3)), np.empty(0))]
    for source in np.unique(sources[lateral]):
        own = lateral & (sources == source)
        if own.sum() > SMOOTHING:
            nearest = cKDTree(body[own]).query(body[own], k=SMOOTHING)[1]
            parts.append((body[own], heights[own] - heights[own][nearest].mean(axis=1)))
    return Texture(np.vstack([p for p, _ in parts]), np.concatenate([h for _, h in parts]))


def likeness(first: Texture, second: Texture, unit: UnitType) -> Likeness:
    """Compare two textures under all rotations of the body."""
    if min(len(first.points), len(second.points)) < MIN_PAIRS:
        return Likeness(np.eye(3), 0.0, 0.0)
    step = max(1, len(second.points) // MAX_POINTS)
    points, heights = second.points[::step], second.heights[::step]
    correlations, pairs, judged = [], [], []
    for number, symmetry in enumerate(unit.symmetries):
        away, nearest = first.tree.query(points @ symmetry, distance_upper_bound=REACH_HEIGHTS * unit.height)
        near = np.isfinite(away)
        if near.sum() < MIN_PAIRS:
            continue
        a, b = first.heights[nearest[near]], heights[near]
        correlations.append(float(np.sum(a * b) / np.sqrt(np.sum(a**2) * np.sum(b**2))))
        pairs.append(int(near.sum()))
        judged.append(number)
    if len(judged) < LEAST_ROTATIONS:
        return Likeness(np.eye(3), 0.0, 0.0)
    rho, count = np.array(correlations), np.array(pairs, dtype=np.float64)
    # how far each stands out of all others, which share the mould
    others = (np.sum(rho * count) - rho * count) / (count.sum() - count)
    scores = (rho - others) * np.sqrt(count)
    order = np.argsort(-scores)
    best = int(order[0])
    return Likeness(np.asarray(unit.symmetries[judged[best]]), float(rho[best]), float(scores[best] - scores[order[1]]))
