"""What the ground truth says of the legs of a unit: which is broken, how much of it is missing, how much of each leg is seen, and how many
points show the break."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import BoolArray, FloatArray
from ..model.unit_types import UnitType
from .armour_pile import PiledUnit
from .virtual_scanner import Returns

COLUMNS = ("broken_leg", "leg_missing", *(f"leg{k}_{what}" for k in range(1, 5) for what in ("points", "seen")), "break_points")
"""Columns of ``truth/units.csv``: the leg that is broken, 1 to 4 (0: none), and the length missing on its axis, metres; of each leg the
points beyond its joint and the share of its cells there that hold some; and the points whose beams a whole leg would have stopped."""
JOINT = 0.45
"""Share of a leg beyond which its surface is its own: nearer the centre it is where legs meet."""
CHORD_HEIGHTS = 0.02
"""Length of a beam inside the missing part of a leg from which a whole leg would have stopped it."""
STEPS = 60
"""Places along a beam at which it is asked whether it lies inside the missing part."""


def leg_columns(piled: PiledUnit, unit: UnitType, body: FloatArray, cells: FloatArray, cloud: Returns) -> list[object]:
    """Values of :data:`COLUMNS` for a unit.

    ``body`` are its own (n, 3) points and ``cells`` (m, 3) middles of the cells of its surface, both in its body frame and nominal size;
    ``cloud`` is all that was measured, in the frame of the pile.
    """
    own, of_leg = body[_beyond_joint(body, unit)], cells[_beyond_joint(cells, unit)]
    held = of_leg[np.unique(cKDTree(of_leg).query(own)[1])]
    points, seen = _by_leg(own, unit), _by_leg(held, unit) / _by_leg(of_leg, unit)
    values = [value for k in range(4) for value in (int(points[k]), round(float(seen[k]), 3))]
    if piled.broken_leg < 0:
        return [0, 0.0, *values, 0]
    missing = (unit.leg_length - piled.broken_length) * piled.scale
    return [piled.broken_leg + 1, round(missing, 4), *values, int(stopped_by_missing_part(piled, unit, cloud).sum())]


def stopped_by_missing_part(piled: PiledUnit, unit: UnitType, cloud: Returns) -> BoolArray:
    """(n,) points of a cloud whose beams pass through what is missing of a broken leg, or end in it: they show that it is broken."""
    axis = unit.leg_directions[piled.broken_leg]
    slope = piled.slope_of_break()
    nearest = piled.broken_length - np.linalg.norm(slope) * unit.radius
    middle = 0.5 * (nearest + unit.leg_length) * axis
    reach = float(np.hypot(0.5 * (unit.leg_length - nearest), unit.radius))
    ends, starts = (piled.pose.to_body(places) / piled.scale for places in (cloud.points, cloud.sensor))
    way = ends - starts
    length = np.linalg.norm(way, axis=1)
    towards = way / np.maximum(length, 1e-9)[:, None]
    along = np.einsum("ij,ij->i", middle - starts, towards)
    aside = np.einsum("ij,ij->i", middle - starts, middle - starts) - along**2
    near = np.flatnonzero((aside < reach**2) & (cloud.labels >= -4) & (length > along - reach))
    half = np.sqrt(reach**2 - aside[near])
    share = (np.arange(STEPS) + 0.5) / STEPS
    first = along[near] - half
    last = np.minimum(along[near] + half, length[near])
    step = np.maximum(last - first, 0.0) / STEPS
    inside = np.zeros(len(near))
    for part in share:
        places = starts[near] + (first + part * (last - first))[:, None] * towards[near]
        axial = places @ axis
        across = places - axial[:, None] * axis
        within = np.linalg.norm(across, axis=1) < unit.radius - unit.gradient * axial
        inside += step * (within & (axial < unit.leg_length) & (axial > piled.broken_length + across @ slope))
    result = np.zeros(len(ends), dtype=np.bool_)
    result[near] = inside > CHORD_HEIGHTS * unit.height
    return result


def _beyond_joint(body: FloatArray, unit: UnitType) -> BoolArray:
    """(n,) whether places (n, 3) in the body frame lie beyond the joint of their leg."""
    return np.asarray((body @ unit.leg_directions.T).max(axis=1) > JOINT * unit.leg_length)


def _by_leg(body: FloatArray, unit: UnitType) -> FloatArray:
    """(4,) how many of (n, 3) places are on each leg."""
    return np.bincount(np.argmax(body @ unit.leg_directions.T, axis=1), minlength=4).astype(np.float64)
