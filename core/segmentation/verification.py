"""Verification of whole units: support against contradiction, exclusive claims on the points, no two solids in one place."""

from __future__ import annotations

import heapq
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.kernels import kernel
from ..model.tetrapod import distance_to_surface, relate
from ..model.unit_types import UnitType
from .pose_evidence import evidence
from .pose_refinement import refine
from .scene import Evidence, Scene

FEWEST_CELLS = 5
"""Surface cells (of 132) below which a pose is not kept even as a weak one: less than about 4 % of the surface."""
MOST_INSIDE = 0.08
"""Elements inside the solid, over those that support it, above which they contradict it."""
MOST_MISFIT = 0.85
"""Of the tolerance: three quarters of what chance gives."""
LEAST_SHARE = 0.45
"""Of the elements on the surface those whose normal must agree, and of those near it those that must lie on it."""
MOST_OVERLAP = 0.06
"""Share of a unit's volume by which a candidate may enter an accepted unit before both have their final pose."""


@dataclass(frozen=True, eq=False)
class Accepted:
    """Poses kept by :func:`select`, strongest first, with the evidence each had when it was accepted.

    Attributes
    ----------
    poses
        (k, 12) centre and rotation by rows.
    evidence
        Of each.
    """

    poses: FloatArray
    evidence: Evidence


def select(candidates: FloatArray, scene: Scene, active: BoolArray, accepted: FloatArray) -> Accepted:
    """Accept candidates one by one, each judged on the points that are still unclaimed; claims are written into ``active``.

    The worth of a candidate is the number of elements that support it less three for each that lies inside the solid. It only
    falls as points are claimed, so a queue of old values, re-judged when they come to the top, gives the exact greedy order.
    """
    unit, tolerance = scene.unit, scene.tolerance
    first = evidence(candidates, scene, active)
    value = worth(first)
    good = np.flatnonzero(plausible(first, tolerance))
    good = good[np.argsort(-value[good], kind="stable")]
    good = good[distinct(candidates[good], unit)]
    queue = [(-value[k], k, len(accepted)) for k in good]
    heapq.heapify(queue)
    count = len(accepted)
    standing = np.vstack([accepted, np.zeros((len(queue), 12))])
    rows: list[Evidence] = []
    while queue:
        old, k, seen = heapq.heappop(queue)
        pose = candidates[k]
        away = np.sum((standing[:count, :3] - pose[:3]) ** 2, axis=1)
        if (away < (0.3 * unit.height) ** 2).any():
            continue
        # only a claim made nearby since the last judgement can have changed it
        if (away[seen:] < (1.5 * unit.height) ** 2).any():
            row = evidence(pose[None], scene, active)
            if not plausible(row, tolerance)[0]:
                continue
            now = float(worth(row)[0])
            if now < -old - 1e-9:
                heapq.heappush(queue, (-now, k, count))
                continue
        finer = refine(pose[None], scene, active, most=1500, sweeps=20)[0]
        row = evidence(finer[None], scene, active)
        if worth(row)[0] < -old * 0.9:
            finer, row = pose, evidence(pose[None], scene, active)
        near = np.flatnonzero(np.sum((standing[:count, :3] - finer[:3]) ** 2, axis=1) < (2 * unit.reach) ** 2)
        if not plausible(row, tolerance)[0] or any(overlap(finer, standing[j], unit) > MOST_OVERLAP for j in near):
            continue
        claim(finer, scene, active)
        standing[count] = finer
        count += 1
        rows.append(row)
    return Accepted(standing[len(accepted) : count], Evidence.joined(rows))


def distinct(poses: FloatArray, unit: UnitType) -> IntArray:
    """Indices of (k, 12) candidates, best first, that are not near-copies of a better one."""
    return without_copies(poses, unit.symmetries, 0.08 * unit.height, np.cos(np.radians(10)))


def without_copies(poses: FloatArray, symmetries: FloatArray, near: float, cosine: float) -> IntArray:
    """Indices of (k, 12) poses, best first, that are not close to a better one.

    Close is what lies within ``near`` metres in centre and, up to the (s, 3, 3) symmetries, within the angle of that cosine in rotation.
    """
    return np.flatnonzero(_without_copies(poses, np.argsort(poses[:, 0], kind="stable"), symmetries, near, cosine))


@kernel()
def _without_copies(poses: Any, along: Any, symmetries: Any, near: float, cosine: float) -> Any:
    """(k,) whether poses, best first, are no copies of a better one; ``along`` is their order by the first coordinate, so that only those
    about as far along it are looked at."""
    count = len(poses)
    place = np.empty(count, dtype=np.int64)
    for k in range(count):
        place[along[k]] = k
    kept = np.zeros(count, dtype=np.bool_)
    for i in range(count):
        kept[i] = True
        for way in (-1, 1):
            k = place[i] + way
            while kept[i] and 0 <= k < count and abs(poses[along[k], 0] - poses[i, 0]) <= near:
                if along[k] < i and kept[along[k]]:
                    kept[i] = not _is_copy(poses[i], poses[along[k]], symmetries, near, cosine)
                k += way
    return kept


@kernel()
def _is_copy(pose: Any, other: Any, symmetries: Any, near: float, cosine: float) -> bool:
    """Whether two poses differ by no more than ``near`` in centre and, up to the symmetry, by an angle of that cosine in rotation."""
    d0, d1, d2 = pose[0] - other[0], pose[1] - other[1], pose[2] - other[2]
    if d0 * d0 + d1 * d1 + d2 * d2 > near * near:
        return False
    for s in range(len(symmetries)):
        trace = 0.0
        for a in range(3):
            for b in range(3):
                for c in range(3):
                    trace += pose[3 + 3 * a + b] * symmetries[s, b, c] * other[3 + 3 * a + c]
        if 0.5 * (trace - 1.0) > cosine:
            return True
    return False


def plausible(found: Evidence, tolerance: float) -> BoolArray:
    """(k,) whether a candidate may claim points at all: enough cells, few points inside, and a misfit unlike that of chance.

    Points scattered evenly across the window of twice the tolerance on either side have a misfit of 1.15 times the tolerance.
    """
    return np.asarray(
        (found.cells >= FEWEST_CELLS)
        & (found.inside <= MOST_INSIDE * found.support)
        & (found.misfit < MOST_MISFIT * tolerance)
        & (found.support > LEAST_SHARE * found.close)
        & (found.close > LEAST_SHARE * found.reached)
    )


def worth(found: Evidence) -> FloatArray:
    """(k,) support less three for every element inside the solid."""
    return np.asarray(found.support - 3 * found.inside)


def claim(pose: FloatArray, scene: Scene, active: BoolArray) -> None:
    """Take the active points on the surface of the unit out of ``active``."""
    near = scene.grid.within(pose[:3], scene.unit.reach + 2.5 * scene.tolerance, active)
    relation = relate((scene.points[near] - pose[:3]) @ pose[3:].reshape(3, 3), scene.unit)
    active[near[np.abs(relation.distance) < 2.5 * scene.tolerance]] = False


def overlap(a: FloatArray, b: FloatArray, unit: UnitType, other: UnitType | None = None) -> float:
    """Share of the volume of unit ``a`` that lies inside unit ``b``, of the same type unless ``other`` is given; poses (12,)."""
    shape = other or unit
    back = b[3:].reshape(3, 3).T
    turn, shift = back @ a[3:].reshape(3, 3), back @ (a[:3] - b[:3])
    solid = (np.ascontiguousarray(shape.leg_directions), shape.radius, shape.gradient, shape.leg_length)
    return float(_share_inside(solid_samples(unit), turn, shift, *solid, shape.reach))


@lru_cache(maxsize=32)
def solid_samples(unit: UnitType) -> FloatArray:
    """About 3000 points on a regular lattice inside the solid, body frame."""
    step = (unit.volume / 3000) ** (1 / 3)
    half = unit.leg_length * 1.2
    line = np.arange(-half, half, step)
    lattice = np.stack(np.meshgrid(line, line, line, indexing="ij"), axis=-1).reshape(-1, 3)
    return lattice[distance_to_surface(lattice, unit) < 0]


@kernel()
def _share_inside(points: Any, turn: Any, shift: Any, legs: Any, radius: float, gradient: float, length: float, reach: float) -> float:
    """Share of (n, 3) points, turned and shifted into the body frame of a unit, that lie inside it."""
    inside = 0
    for q in range(len(points)):
        px, py, pz = points[q, 0], points[q, 1], points[q, 2]
        x = turn[0, 0] * px + turn[0, 1] * py + turn[0, 2] * pz + shift[0]
        y = turn[1, 0] * px + turn[1, 1] * py + turn[1, 2] * pz + shift[1]
        z = turn[2, 0] * px + turn[2, 1] * py + turn[2, 2] * pz + shift[2]
        square = x * x + y * y + z * z
        if square > reach * reach:
            continue
        axial = -1e300
        for k in range(4):
            lean = x * legs[k, 0] + y * legs[k, 1] + z * legs[k, 2]
            if lean > axial:
                axial = lean
        if axial < length:
            rho = radius - gradient * axial
            if square - axial * axial < rho * rho:
                inside += 1
    return inside / len(points)
