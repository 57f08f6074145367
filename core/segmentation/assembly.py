"""Legs to whole units: common centre and leg angles of pairs, shift and twist about single legs (paper 2.1).

Poses are rows of 12 numbers, see :mod:`.cone_relation`.
"""

from __future__ import annotations

from functools import partial
from typing import Any, NamedTuple

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.kernels import in_parts, kernel
from ..common.least_axis import across
from ..common.neighbourhood import gather
from ..model.unit_types import UnitType
from .cone_relation import ConeShape
from .conic_ransac import Legs
from .scene import Scene

ABOUT_AS_GOOD = 0.9
"""Share of the best twist's support at which another twist about a leg stands as well."""

MEETING = 0.45
"""Distance of the centres that two legs of one unit see, as a share of the height, below which they are held against each other."""

MEETING_ANGLE = np.radians(16)
"""By how much the angle between two such legs may differ from the unit's."""

MISSED = 0.12
"""Share of the height by which their axes may miss each other."""

TWISTS = 16
"""Twists about a leg that are tried over a third of a turn, 7.5 degrees apart: the shape repeats after it."""

TWIST_SAMPLE = 260
"""Elements about a leg by which a twist is judged."""


class _Hypotheses(NamedTuple):
    """Axes and centres of single legs, (k, 3), and (k,) how far the centre may lie along the axis, metres."""

    axes: FloatArray
    centres: FloatArray
    reaches: FloatArray


def poses_from_pairs(legs: Legs, unit: UnitType) -> FloatArray:
    """Whole-unit poses from pairs of legs that meet at an angle of the unit's legs: (k, 12)."""
    if len(legs.axis) < 2:
        return np.zeros((0, 12))
    pairs = cKDTree(legs.centre).query_pairs(MEETING * unit.height, output_type="ndarray")
    return np.vstack([_poses_of_legs(legs, pairs, unit, numbers) for numbers in unit.leg_pairs])


def _poses_of_legs(legs: Legs, pairs: IntArray, unit: UnitType, numbers: tuple[int, int]) -> FloatArray:
    """Poses (k, 12) of those of (n, 2) pairs of legs that can be the two legs of a unit with these numbers, 0 to 3."""
    height = unit.height
    i, j = pairs[:, 0], pairs[:, 1]
    a, b = legs.axis[i], legs.axis[j]
    cosine = np.einsum("ij,ij->i", a, b)
    directions = unit.leg_directions[list(numbers)]
    opening = float(directions[0] @ directions[1])
    fits = np.abs(np.arccos(np.clip(cosine, -1, 1)) - np.arccos(opening)) < MEETING_ANGLE
    i, j, a, b, cosine = i[fits], j[fits], a[fits], b[fits], cosine[fits]
    gap = legs.centre[j] - legs.centre[i]
    # nearest approach of the two lines, each point held back by how far its own leg can shift along its axis
    s = (np.einsum("ij,ij->i", gap, a) - np.einsum("ij,ij->i", gap, b) * cosine) / (1 - cosine**2)
    t = (np.einsum("ij,ij->i", gap, a) * cosine - np.einsum("ij,ij->i", gap, b)) / (1 - cosine**2)
    first, second = legs.centre[i] + s[:, None] * a, legs.centre[j] + t[:, None] * b
    miss = np.linalg.norm(first - second, axis=1)
    reach_i = 4 * legs.centre_sd[i] + 0.1 * height
    reach_j = 4 * legs.centre_sd[j] + 0.1 * height
    fits = (miss < MISSED * height) & (np.abs(s) < reach_i) & (np.abs(t) < reach_j)
    centre = (0.5 * (first + second))[fits]
    return np.column_stack([centre, _rotation_of_legs(a[fits], b[fits], directions)])


def _rotation_of_legs(a: FloatArray, b: FloatArray, directions: FloatArray) -> FloatArray:
    """(k, 9) rotations that bring two (2, 3) directions in the body closest to the directions a and b."""
    total, across = a + b, np.cross(a, b)
    total /= np.linalg.norm(total, axis=1, keepdims=True)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    frame = np.stack([total, across, np.cross(total, across)], axis=2)
    d1, d2 = directions
    bisector, normal = d1 + d2, np.cross(d1, d2)
    bisector, normal = bisector / np.linalg.norm(bisector), normal / np.linalg.norm(normal)
    body = np.column_stack([bisector, normal, np.cross(bisector, normal)])
    return np.asarray((frame @ body.T).reshape(len(a), 9))


def poses_from_single_legs(legs: Legs, scene: Scene, active: BoolArray, *, twists: int = 2) -> FloatArray:
    """Poses about each leg, searched over the shift along its axis and the twist about it: (n, 12).

    The best two, and with ``twists`` 5 three more where they are about as good as the best: which of them has room is seen later.
    """
    if not len(legs.axis):
        return np.zeros((0, 12))
    height = scene.unit.height
    starts = _Hypotheses(
        np.ascontiguousarray(legs.axis), np.ascontiguousarray(legs.centre), np.clip(2.5 * legs.centre_sd, 0.06 * height, 0.24 * height)
    )
    shape = ConeShape.of(scene.unit)
    count = len(starts[0])
    poses = np.zeros((twists * count, 12))
    passes = partial(
        _twist_search,
        starts=starts,
        points=scene.points,
        active=active,
        grid=scene.grid,
        shape=shape,
        tolerance=scene.tolerance,
        most=twists,
        out=poses,
    )
    in_parts(passes, count)
    return np.asarray(poses[poses[:, 3:].any(axis=1)])


@kernel()
def twist_support(
    local: Any, count: int | np.int64, turned: Any, shift: float, radius: float, gradient: float, length: float, tolerance: float
) -> float:
    """Elements on the surface less those inside the solid, of the first ``count`` of ``local`` (3, m) about a leg.

    ``turned`` (4, 3) are the legs in that frame.
    """
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    edge = radius - gradient * length
    a0, a1, a2 = turned[0, 0], turned[0, 1], turned[0, 2]
    b0, b1, b2 = turned[1, 0], turned[1, 1], turned[1, 2]
    c0, c1, c2 = turned[2, 0], turned[2, 1], turned[2, 2]
    d0, d1, d2 = turned[3, 0], turned[3, 1], turned[3, 2]
    total = 0.0
    # no branches: the loop runs in vector registers
    for q in range(count):
        x, y, z = local[0, q], local[1, q], local[2, q] - shift
        axial = max(max(x * a0 + y * a1 + z * a2, x * b0 + y * b1 + z * b2), max(x * c0 + y * c1 + z * c2, x * d0 + y * d1 + z * d2))
        rho = np.sqrt(max(x * x + y * y + z * z - axial * axial, 0.0))
        distance = max((rho - radius + gradient * axial) * cosine, axial - length)
        beside = (axial > length) & (rho > edge)
        total += 1.0 if (distance < 2.0 * tolerance) & (not beside) else 0.0
        total -= 2.0 if distance < -2.5 * tolerance else 0.0
    return total


@kernel(releases=True)
def _twist_search(
    first: int, last: int, starts: Any, points: Any, active: Any, grid: Any, shape: Any, tolerance: float, most: int, out: Any
) -> None:
    """Best poses about each of n legs over shift and twist into ``out`` (most * n, 12), left at zero where a twist is worse than those
    before."""
    axes, centres, reaches = starts
    legs, radius, gradient, length, height = shape
    twists = TWISTS
    for i in range(first, last):
        near = gather(active, (centres[i, 0], centres[i, 1], centres[i, 2]), 0.85 * height, grid, np.int64(TWIST_SAMPLE))
        m = len(near)
        e30, e31, e32 = axes[i, 0], axes[i, 1], axes[i, 2]
        e10, e11, e12, e20, e21, e22 = across(e30, e31, e32)
        local = np.empty((3, m))
        for q in range(m):
            d0 = points[near[q], 0] - centres[i, 0]
            d1 = points[near[q], 1] - centres[i, 1]
            d2 = points[near[q], 2] - centres[i, 2]
            local[0, q] = d0 * e10 + d1 * e11 + d2 * e12
            local[1, q] = d0 * e20 + d1 * e21 + d2 * e22
            local[2, q] = d0 * e30 + d1 * e31 + d2 * e32
        steps = max(1, int(np.ceil(reaches[i] / (0.035 * height))))
        best = np.full(2, -1e300)
        best_z = np.zeros(most)
        best_t = np.zeros(most)
        of_twist = np.full(twists, -1e300)
        shift_of_twist = np.zeros(twists)
        turned = np.empty((4, 3))
        widest = 0
        for t in range(twists):
            angle = t * (2.0 * np.pi / 3.0) / twists
            ca = np.cos(angle)
            sa = np.sin(angle)
            for k in range(4):
                turned[k, 0], turned[k, 1], turned[k, 2] = ca * legs[k, 0] - sa * legs[k, 1], sa * legs[k, 0] + ca * legs[k, 1], legs[k, 2]
            for k in range(-steps, steps + 1):
                shift = k * reaches[i] / steps
                total = twist_support(local, m, turned, shift, radius, gradient, length, tolerance)
                if total > of_twist[t]:
                    of_twist[t], shift_of_twist[t] = total, shift
                far = 1.0
                if best[0] > -1e299:
                    turn = abs(angle - best_t[0])
                    turn = min(turn, 2.0 * np.pi / 3.0 - turn)
                    if turn < 0.35 and abs(shift - best_z[0]) < 0.12 * height:
                        far = 0.0
                if total > best[0]:
                    if far > 0.0:
                        best[1], best_z[1], best_t[1] = best[0], best_z[0], best_t[0]
                    best[0], best_z[0], best_t[0] = total, shift, angle
                elif total > best[1] and far > 0.0:
                    best[1], best_z[1], best_t[1] = total, shift, angle
            widest = t if of_twist[t] > of_twist[widest] else widest
        for w in range(2, most):
            t = (widest + (w - 1) * twists // 4) % twists
            best_t[w] = t * (2.0 * np.pi / 3.0) / twists
            # a twist that is worse is left as zeros
            best_z[w] = shift_of_twist[t] if of_twist[t] >= ABOUT_AS_GOOD * best[0] else np.inf
        for w in range(most):
            if best_z[w] == np.inf:
                continue
            ca = np.cos(best_t[w])
            sa = np.sin(best_t[w])
            pose = out[most * i + w]
            for a, (e1, e2, e3) in enumerate(((e10, e20, e30), (e11, e21, e31), (e12, e22, e32))):
                pose[a] = centres[i, a] + best_z[w] * e3
                pose[3 + 3 * a], pose[4 + 3 * a], pose[5 + 3 * a] = ca * e1 + sa * e2, ca * e2 - sa * e1, e3
