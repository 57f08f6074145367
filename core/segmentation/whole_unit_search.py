"""Whole units about single elements, where a cloud is too poor for legs: an element and its normal leave three numbers of a pose open.

On a leg, the normal stands at a known angle to the leg's axis. Open are where along the leg the element lies, the turn of the axis about
the normal, and the twist of the unit about the axis. All of them are tried, each against the elements around, those inside the solid
speaking against it (METHOD 11). That a leg shows as a leg is not asked for, as :mod:`.conic_ransac` does: of a unit of which a sixth is
seen, a sparse cloud holds some tens of elements on parts of two or three legs.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import BoolArray, FloatArray
from ..common.kernels import in_parts, kernel
from ..common.neighbourhood import gather
from ..common.voxels import thin
from .assembly import twist_support
from .cone_relation import ConeShape
from .scene import Scene

SEED_RATIO = 0.15
"""Edge of the voxels, as a share of the height, of which each gives an element to search about."""
SURROUNDINGS = 1.6
"""Units lie among units: distance from the centre of one, in heights, up to which others are searched."""
SHIFTS = (0.4, 0.55, 0.7, 0.85)
"""Places along the leg, as shares of its length, at which the element is taken to lie: refinement bridges what is between."""
TURNS, TWISTS = 24, 10
"""Turns of the axis about the normal, 15 degrees apart, and twists about the axis over a third of a turn: then a unit looks alike."""
REACH = 1.0
"""Distance from the element, in heights, within which others are counted."""
SAMPLE = 160
"""Elements by which a pose is judged, at most."""
KEPT = 2
"""Poses that are kept about an element: the best, and the best whose axis differs."""


def poses_about_elements(scene: Scene, active: BoolArray, known: FloatArray) -> FloatArray:
    """Poses (k, 12) about active elements near ``known`` ones (m, 12), best of all that leave the element on the side of a leg."""
    where = np.flatnonzero(active & (scene.curved >= 0))
    if not len(where) or not len(known):
        return np.zeros((0, 12))
    height = scene.unit.height
    where = where[cKDTree(known[:, :3]).query(scene.points[where], distance_upper_bound=SURROUNDINGS * height)[0] < np.inf]
    if not len(where):
        return np.zeros((0, 12))
    _, voxel = thin(scene.points[where], SEED_RATIO * height)
    seeds = where[np.unique(voxel, return_index=True)[1]]
    poses = np.zeros((KEPT * len(seeds), 12))
    elements = scene.points, scene.normals, scene.curved
    passes = partial(
        _search,
        seeds=seeds,
        elements=elements,
        active=active,
        grid=scene.grid,
        shape=ConeShape.of(scene.unit),
        tolerance=scene.tolerance,
        out=poses,
    )
    in_parts(passes, len(seeds))
    return np.asarray(poses[poses[:, 3:].any(axis=1)])


@kernel(releases=True)
def _search(first: int, last: int, seeds: Any, elements: Any, active: Any, grid: Any, shape: Any, tolerance: float, out: Any) -> None:
    """Best poses about each of n elements into ``out`` (KEPT * n, 12), left at zero where hardly any element supports one."""
    points, normals, curved = elements
    legs, radius, gradient, length, height = shape
    slant = 1.0 / np.sqrt(1.0 + gradient * gradient)
    # what lies farther from the centre is neither on nor inside the solid
    farthest = (length + 2.0 * tolerance) ** 2 + (radius - gradient * length + 2.0 * tolerance / slant) ** 2
    turns = np.empty((TWISTS, 2))
    turned = np.empty((TWISTS, 4, 3))
    for w in range(TWISTS):
        twist = w * (2.0 * np.pi / 3.0) / TWISTS
        c, s = np.cos(twist), np.sin(twist)
        turns[w, 0], turns[w, 1] = c, s
        for k in range(4):
            turned[w, k, 0] = c * legs[k, 0] - s * legs[k, 1]
            turned[w, k, 1] = s * legs[k, 0] + c * legs[k, 1]
            turned[w, k, 2] = legs[k, 2]
    for i in range(first, last):
        seed = seeds[i]
        place = (points[seed, 0], points[seed, 1], points[seed, 2])
        near = gather(active, place, REACH * height, grid, np.int64(SAMPLE))
        m = len(near)
        local, own = np.empty((3, m + 1)), np.empty((3, m))
        for q in range(m):
            for a in range(3):
                own[a, q] = points[near[q], a] - place[a]
        best = np.full(KEPT, -1e300)
        n = np.empty(3)
        aside = np.zeros(3)
        # the sign of a normal is known where the surface bends as a leg does
        for side in range(1 if curved[seed] > 0 else 2):
            for a in range(3):
                n[a] = normals[seed, a] if side == 0 else -normals[seed, a]
                aside[a] = 0.0
            aside[0 if abs(n[0]) < 0.8 else 1] = 1.0
            u = np.cross(n, aside)
            u /= np.sqrt(np.sum(u * u))
            v = np.cross(n, u)
            for t in range(TURNS):
                angle = t * 2.0 * np.pi / TURNS
                axis = gradient * slant * n + slant * (np.cos(angle) * u + np.sin(angle) * v)
                radial = (n - gradient * slant * axis) / slant
                across = np.cross(axis, radial)
                for share in SHIFTS:
                    along = share * length
                    rho = radius - gradient * along
                    # a number of the kind that other loops count with, or what they share would be compiled once more
                    count = np.int64(0)
                    # every element is written down, and written over where it is too far
                    for q in range(m):
                        x, y, z = own[0, q], own[1, q], own[2, q]
                        lx = x * radial[0] + y * radial[1] + z * radial[2] + rho
                        ly = x * across[0] + y * across[1] + z * across[2]
                        lz = x * axis[0] + y * axis[1] + z * axis[2] + along
                        local[0, count], local[1, count], local[2, count] = lx, ly, lz
                        count += 1 if lx * lx + ly * ly + lz * lz <= farthest else 0
                    for w in range(TWISTS):
                        c, s = turns[w, 0], turns[w, 1]
                        total = twist_support(local, count, turned[w], 0.0, radius, gradient, length, tolerance)
                        if total <= best[KEPT - 1]:
                            continue
                        # the first is replaced by what is better, and goes to the second where the axes differ
                        one, two = KEPT * i, KEPT * i + 1
                        same = out[one, 5] * axis[0] + out[one, 8] * axis[1] + out[one, 11] * axis[2] > 0.9
                        at = one if total > best[0] else two
                        if at == two and same:
                            continue
                        if at == one and not same:
                            best[1] = best[0]
                            out[two] = out[one]
                        best[at - one] = total
                        for a in range(3):
                            out[at, a] = place[a] - along * axis[a] - rho * radial[a]
                            out[at, 3 + 3 * a] = c * radial[a] + s * across[a]
                            out[at, 4 + 3 * a] = -s * radial[a] + c * across[a]
                            out[at, 5 + 3 * a] = axis[a]
