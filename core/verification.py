"""Verification of whole units: support against contradiction, exclusive claims on the points, no two solids in one place."""

from __future__ import annotations

import heapq
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .assembly import CELLS, CLOSE, INSIDE, REACHED, RMS, SUPPORT, evidence, refine
from .kernels import kernel
from .neighbourhood import Grid
from .surface_elements import SurfaceElements
from .tetrapod import relate
from .unit_types import UnitType

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

FEWEST_CELLS = 5
"""Surface cells (of 132) below which a pose is not kept even as a weak one: less than about 4 % of the surface."""
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
        (k, 7) columns as in ``assembly``.
    """

    poses: FloatArray
    evidence: FloatArray


def select(
    candidates: FloatArray, elements: SurfaceElements, active: NDArray[np.bool_], grid: Grid, unit: UnitType, tolerance: float,
    accepted: FloatArray,
) -> Accepted:  # fmt: skip
    """Accept candidates one by one, each judged on the points that are still unclaimed; claims are written into ``active``.

    The worth of a candidate is the number of elements that support it less three for each that lies inside the solid. It only
    falls as points are claimed, so a queue of old values, re-judged when they come to the top, gives the exact greedy order.
    """

    def judge(poses: FloatArray) -> FloatArray:
        return evidence(poses, elements.points, elements.normals, elements.curved, active, grid, unit, tolerance, elements.noise)

    table = judge(candidates)
    value = np.array([worth(row) for row in table])
    good = np.flatnonzero([plausible(row, tolerance) for row in table])
    good = good[np.argsort(-value[good], kind="stable")]
    good = good[distinct(candidates[good], unit)]
    queue = [(-value[k], k, len(accepted)) for k in good]
    heapq.heapify(queue)
    count = len(accepted)
    standing = np.vstack([accepted, np.zeros((len(queue), 12))])
    rows: list[FloatArray] = []
    while queue:
        old, k, seen = heapq.heappop(queue)
        pose = candidates[k]
        away = np.sum((standing[:count, :3] - pose[:3]) ** 2, axis=1)
        if (away < (0.3 * unit.height) ** 2).any():
            continue
        # only a claim made nearby since the last judgement can have changed it
        if (away[seen:] < (1.5 * unit.height) ** 2).any():
            row = judge(pose[None])[0]
            if not plausible(row, tolerance):
                continue
            if worth(row) < -old - 1e-9:
                heapq.heappush(queue, (-worth(row), k, count))
                continue
        finer = refine(pose[None], elements.points, elements.normals, active, grid, unit, tolerance, most=1500, sweeps=20)[0]
        row = judge(finer[None])[0]
        if worth(row) < -old * 0.9:
            finer, row = pose, judge(pose[None])[0]
        near = np.flatnonzero(np.sum((standing[:count, :3] - finer[:3]) ** 2, axis=1) < (2 * unit.reach) ** 2)
        if not plausible(row, tolerance) or any(overlap(finer, standing[j], unit) > MOST_OVERLAP for j in near):
            continue
        claim(finer, elements.points, active, grid, unit, tolerance)
        standing[count] = finer
        count += 1
        rows.append(row)
    return Accepted(standing[len(accepted) : count], np.array(rows).reshape(-1, 7))


def distinct(poses: FloatArray, unit: UnitType) -> IntArray:
    """Indices of (k, 12) candidates, best first, that are not near-copies of a better one."""
    return np.asarray(without_copies(poses, unit.symmetries, 0.08 * unit.height, np.cos(np.radians(10))))


@kernel()
def without_copies(poses: Any, symmetries: Any, near: float, cosine: float) -> Any:
    """Indices of poses, best first, that are not close to a better one in centre and, up to the symmetry, in rotation."""
    kept = np.empty(len(poses), dtype=np.int64)
    count = 0
    for i in range(len(poses)):
        copy = False
        for k in range(count):
            j = kept[k]
            d0, d1, d2 = poses[i, 0] - poses[j, 0], poses[i, 1] - poses[j, 1], poses[i, 2] - poses[j, 2]
            if d0 * d0 + d1 * d1 + d2 * d2 > near * near:
                continue
            for s in range(len(symmetries)):
                trace = 0.0
                for a in range(3):
                    for b in range(3):
                        for c in range(3):
                            trace += poses[i, 3 + 3 * a + b] * symmetries[s, b, c] * poses[j, 3 + 3 * a + c]
                if 0.5 * (trace - 1.0) > cosine:
                    copy = True
                    break
            if copy:
                break
        if not copy:
            kept[count] = i
            count += 1
    return kept[:count]


def plausible(row: FloatArray, tolerance: float) -> bool:
    """Whether a candidate may claim points at all: enough cells, few points inside, and a misfit unlike that of chance.

    Points scattered evenly across the window of twice the tolerance on either side have a misfit of 1.15 times the tolerance.
    """
    return bool(
        row[CELLS] >= FEWEST_CELLS
        and row[INSIDE] <= 0.08 * row[SUPPORT]
        and row[RMS] < 0.85 * tolerance
        and row[SUPPORT] > 0.45 * row[CLOSE]
        and row[CLOSE] > 0.45 * row[REACHED]
    )


def worth(row: FloatArray) -> float:
    """Support less three for every element inside the solid."""
    return float(row[SUPPORT] - 3 * row[INSIDE])


def claim(pose: FloatArray, points: FloatArray, active: NDArray[np.bool_], grid: Grid, unit: UnitType, tolerance: float) -> None:
    """Take the active points on the surface of the unit out of ``active``."""
    near = grid.within(points, pose[:3], unit.reach + 2.5 * tolerance, active)
    relation = relate((points[near] - pose[:3]) @ pose[3:].reshape(3, 3), unit)
    active[near[np.abs(relation.distance) < 2.5 * tolerance]] = False


def overlap(a: FloatArray, b: FloatArray, unit: UnitType, other: UnitType | None = None) -> float:
    """Share of the volume of unit ``a`` that lies inside unit ``b``, of the same type unless ``other`` is given; poses (12,)."""
    samples = solid_samples(unit)
    shape = other or unit
    inside = samples @ a[3:].reshape(3, 3).T + a[:3] - b[:3]
    return float(_share_inside(inside @ b[3:].reshape(3, 3), shape.leg_directions, shape.radius, shape.gradient, shape.leg_length))


@lru_cache(maxsize=32)
def solid_samples(unit: UnitType) -> FloatArray:
    """About 3000 points on a regular lattice inside the solid, body frame."""
    step = (unit.volume / 3000) ** (1 / 3)
    half = unit.leg_length * 1.2
    line = np.arange(-half, half, step)
    lattice = np.stack(np.meshgrid(line, line, line, indexing="ij"), axis=-1).reshape(-1, 3)
    return lattice[relate(lattice, unit).distance < 0]


@kernel()
def _share_inside(points: Any, legs: Any, radius: float, gradient: float, length: float) -> float:
    inside = 0
    for q in range(len(points)):
        axial = -1e300
        x, y, z = points[q, 0], points[q, 1], points[q, 2]
        for k in range(4):
            lean = x * legs[k, 0] + y * legs[k, 1] + z * legs[k, 2]
            if lean > axial:
                axial = lean
        if axial < length:
            rho = radius - gradient * axial
            if x * x + y * y + z * z - axial * axial < rho * rho:
                inside += 1
    return inside / len(points)
