"""Legs whose end disc shows, and hardly more: a flat round patch of the size of a disc, across whose middle the leg's axis stands.

A station that looks along a leg sees its end and slivers of its sides, too little of the turn about the axis for a cone
(:mod:`.conic_ransac`). The disc gives axis and centre at once; open is the twist, and which side of the disc the leg is on.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from ..common.arrays import BoolArray
from ..common.kernels import in_parts, kernel
from ..common.least_axis import least_axis
from ..common.neighbourhood import gather
from .conic_ransac import Legs, spread
from .scene import Scene

SEED_SPACING_RATIO = 0.12
"""Distance between the places where discs are looked for, as a share of the height: three or four of them lie on one."""
WITHIN, RING_FROM, RING_TO = 1.1, 1.25, 1.9
"""Distances from the middle of a disc, in its radii: up to which elements are on it, and between which hardly any may lie in its plane."""
MOST_BEYOND = 0.15
"""Elements in that ring, over those on the disc: a plane that goes on holds 2.2 times as many there."""
FEWEST_ON_DISC = 20
"""Elements of a disc, of the 80 that are on one which is seen whole."""
COPLANAR = 0.9
"""Cosine between the normal of an element and that of the disc it lies on."""
ROUNDS = 4
"""Times that the middle is taken anew from the elements about it."""
MOST_NEIGHBOURS = 400
CENTRE_SD_RATIO = 0.02
"""Standard deviation of the centre along the axis, as a share of the height."""


def legs_of_discs(scene: Scene, active: BoolArray) -> Legs:
    """Legs, two to each disc among the active elements (m,): one on either side of it."""
    unit = scene.unit
    seeds = spread(scene.points, np.flatnonzero(active & (scene.curved < 0)), SEED_SPACING_RATIO * unit.height)
    found = np.zeros((len(seeds), 7))
    passes = partial(
        _search,
        elements=scene.elements,
        active=active,
        seeds=seeds,
        grid=scene.grid,
        radius=float(unit.end_radius),
        tolerance=scene.tolerance,
        out=found,
    )
    in_parts(passes, len(seeds))
    found = found[found[:, 6] > 0]
    found = found[np.argsort(-found[:, 6], kind="stable")]
    found = found[_apart(found, 0.5 * unit.end_radius)]
    axis = np.vstack([found[:, :3], -found[:, :3]])
    middle = np.vstack([found[:, 3:6]] * 2)
    sd = np.full(len(axis), CENTRE_SD_RATIO * unit.height)
    return Legs(axis=axis, centre=middle - unit.leg_length * axis, centre_sd=sd, support=np.tile(found[:, 6], 2))


@kernel()
def _apart(found: Any, distance: float) -> Any:
    """Indices of discs, strongest first, whose middle is not within ``distance`` of a stronger one's."""
    kept = np.empty(len(found), dtype=np.int64)
    count = 0
    for i in range(len(found)):
        copy = False
        for k in range(count):
            away = 0.0
            for a in range(3):
                away += (found[i, 3 + a] - found[kept[k], 3 + a]) ** 2
            copy = copy or away < distance * distance
        if not copy:
            kept[count] = i
            count += 1
    return kept[:count]


@kernel(releases=True)
def _search(first: int, last: int, elements: Any, active: Any, seeds: Any, grid: Any, radius: float, tolerance: float, out: Any) -> None:
    """Disc about each seed into ``out`` (k, 7): normal (3), middle (3), elements on it; left at 0 where there is none."""
    points, normals, _ = elements
    for s in range(first, last):
        start = points[seeds[s]]
        # a disc is seen from its rim as well, and its surroundings from there
        near = gather(active, (start[0], start[1], start[2]), (WITHIN + RING_TO) * radius, grid, np.int64(MOST_NEIGHBOURS))
        m0, m1, m2 = start[0], start[1], start[2]
        n0, n1, n2 = normals[seeds[s], 0], normals[seeds[s], 1], normals[seeds[s], 2]
        on = beyond = 0
        for sweep in range(ROUNDS):
            xx = xy = xz = yy = yz = zz = c0 = c1 = c2 = 0.0
            on = beyond = 0
            for k in near:
                x, y, z = points[k, 0] - m0, points[k, 1] - m1, points[k, 2] - m2
                away = x * n0 + y * n1 + z * n2
                agree = abs(normals[k, 0] * n0 + normals[k, 1] * n1 + normals[k, 2] * n2)
                if abs(away) > 1.5 * tolerance or agree < COPLANAR:
                    continue
                aside = np.sqrt(x * x + y * y + z * z - away * away) / radius
                if aside < WITHIN:
                    on += 1
                    c0, c1, c2 = c0 + x, c1 + y, c2 + z
                    xx, xy, xz, yy, yz, zz = xx + x * x, xy + x * y, xz + x * z, yy + y * y, yz + y * z, zz + z * z
                elif RING_FROM < aside < RING_TO:
                    beyond += 1
            if on < FEWEST_ON_DISC or sweep == ROUNDS - 1:
                break
            c0, c1, c2 = c0 / on, c1 / on, c2 / on
            m0, m1, m2 = m0 + c0, m1 + c1, m2 + c2
            n0, n1, n2 = least_axis(
                xx / on - c0 * c0, xy / on - c0 * c1, xz / on - c0 * c2, yy / on - c1 * c1, yz / on - c1 * c2, zz / on - c2 * c2
            )
        if on < FEWEST_ON_DISC or beyond > MOST_BEYOND * on:
            continue
        out[s, 0], out[s, 1], out[s, 2], out[s, 3], out[s, 4], out[s, 5], out[s, 6] = n0, n1, n2, m0, m1, m2, on
