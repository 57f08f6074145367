"""What the elements of a scene say about the poses of whole units (paper 2.1)."""

from __future__ import annotations

import math
from functools import lru_cache, partial
from typing import Any, NamedTuple

import numpy as np

from ..common.arrays import BoolArray, FloatArray
from ..common.kernels import in_parts, kernel
from ..common.neighbourhood import column_within
from ..model.tetrapod import EDGE_RATIO, TIP_RATIO, across_legs
from ..model.unit_types import UnitType
from .cone_relation import FEW_POSES, ConeShape, crease_distance, normal_at
from .conic_ransac import LEAST_AGREEMENT
from .scene import CELLS, CLOSE, COLUMNS, INSIDE, LEGS, MISFIT, REACHED, SUPPORT, Evidence, Scene
from .surface_elements import BEND_RADIUS_RATIO, LEAST_RADIUS_RATIO

AZIMUTH_CELLS, AXIAL_CELLS = 8, 4

CELLS_PER_LEG = AZIMUTH_CELLS * AXIAL_CELLS + 1

NUMBER_OF_CELLS = 4 * CELLS_PER_LEG
INNER_RATIO = 0.2
"""Coordinate along a leg, as a share of the height, from which its cells count: below, the legs meet."""
OUTER_SHARE = 0.6
"""Of a leg's length, beyond which it may be broken off."""

BLURRED_FROM, BLURRED_WHOLLY = 0.07, 0.09
"""Radii of the neighbourhoods of normals, as shares of the height, from which their blur at creases is allowed for, and wholly so: below,
the few elements that it spoils are worth less than what the others there say."""
QUIET_RATIO = 0.03
"""Tolerance, as a share of the height, beyond which no blur is allowed for: with so much noise rock then looks like units."""
LAST_OF_TURN, LAST_OF_LEG = AZIMUTH_CELLS - 1e-5, 1 - 1e-5
"""What lies on the upper edge of the last cell belongs to it."""
EDGES = np.array(
    [(math.cos(a), math.sin(a)) for a in (2 * math.pi * k / LAST_OF_TURN - math.pi for k in range(1, AZIMUTH_CELLS))], dtype=np.float64
)
"""(7, 2) directions between two cells around a leg, cosine and sine, from -180 degrees on; those below 0 come first."""
MIDDLE_CELL = AZIMUTH_CELLS // 2 - 1
"""First of these that is not below 0."""


class _Limits(NamedTuple):
    """What poses are judged by.

    Tolerance in metres, how far what is rounded can be seen, 0 to 1, distance from a crease within which normals are of both legs, metres,
    and (2, 4, 3) the directions by which azimuths about legs count.
    """

    tolerance: float
    seen: float
    blurred: float
    across: FloatArray


def evidence(poses: FloatArray, scene: Scene, active: BoolArray) -> Evidence:
    """What the active elements of a scene say about each (12,) pose."""
    # what is rounded shows in the normals where the noise is well below the least of it
    seen = min(max(1.5 - 4.5 * scene.noise / (EDGE_RATIO * scene.unit.height), 0.0), 1.0)
    shape, elements = ConeShape.of(scene.unit), scene.elements
    # the nearest neighbours of an element this close to a crease lie on two legs
    blurred = max(seen * LEAST_RADIUS_RATIO * scene.unit.height, _blurred(scene))
    limits = _Limits(scene.tolerance, seen, blurred, _across(scene.unit))
    if len(poses) > FEW_POSES:
        out = np.zeros((len(poses), len(COLUMNS)))
        passes = partial(
            _evidence_of_many, out=out, poses=poses, elements=elements, active=active, grid=scene.grid, shape=shape, limits=limits
        )
        in_parts(passes, len(poses))
        return Evidence(out)
    table = np.zeros((len(poses), len(COLUMNS)))
    for pose, row in zip(poses, table, strict=True):
        _evidence_of_one(row, pose, elements, active, scene.grid, shape, limits)
    return Evidence(table)


@lru_cache(maxsize=8)
def _across(unit: UnitType) -> FloatArray:
    """(2, 4, 3) directions by which azimuths about legs count."""
    return np.stack(across_legs(unit))


def _blurred(scene: Scene) -> float:
    """Distance from a crease, metres, within which normals of a sparse cloud are taken over both legs; 0 in rich and in noisy clouds."""
    if scene.tolerance > QUIET_RATIO * scene.unit.height:
        return 0.0
    ratio = scene.normal_radius / scene.unit.height
    return float(np.clip((ratio - BLURRED_FROM) / (BLURRED_WHOLLY - BLURRED_FROM), 0.0, 1.0)) * scene.normal_radius


@kernel(releases=True)
def _evidence_of_many(first: int, last: int, out: Any, poses: Any, elements: Any, active: Any, grid: Any, shape: Any, limits: Any) -> None:
    for i in range(first, last):
        _evidence_of_one(out[i], poses[i], elements, active, grid, shape, limits)


@kernel()
def _evidence_of_one(out: Any, pose: Any, elements: Any, active: Any, grid: Any, shape: Any, limits: Any) -> None:
    """Row of the table of evidence for one pose."""
    _, normals, curved = elements
    legs, radius, gradient, length, height = shape
    tolerance, seen, blurred, across = limits
    first, second = across[0], across[1]
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    low = INNER_RATIO * height
    near, local = _around(pose, 0.75 * height, grid)
    leaning = np.empty((3, len(near)))
    _relate(local, leaning, shape)
    cells = np.zeros(NUMBER_OF_CELLS, dtype=np.int64)
    outer = OUTER_SHARE * length
    rounded = (1.0 - seen * (1.0 - TIP_RATIO)) * length
    # where two legs meet they are concave: so far from there the sense of curvature tells nothing
    half = np.sqrt(0.5 + 0.5 * (legs[0, 0] * legs[1, 0] + legs[0, 1] * legs[1, 1] + legs[0, 2] * legs[1, 2]))
    concave = radius * half / (np.sqrt(1.0 - half * half) + gradient * half) + (BEND_RADIUS_RATIO + EDGE_RATIO) * height
    deep = -max(3.0 * tolerance, 0.03 * height)
    edge = radius - gradient * length
    outer_inside = np.zeros(4)
    squares = 0.0
    chosen = np.empty(len(near) + 1, dtype=np.int64)
    reached = count = 0
    for k in range(len(near)):
        dist, end, over = leaning[0, k], leaning[1, k] - length, leaning[2, k] - edge
        if dist < deep:
            if leaning[1, k] > outer:
                outer_inside[_leg_of(local[0, k], local[1, k], local[2, k], legs)] += 1
            else:
                out[INSIDE] += 1
        # beside the end disc the nearest point is on its rim
        beside = (end > 0.0) & (over > 0.0)
        seen_here = active[near[k]] & (dist >= deep)
        within = (dist < 6.0 * tolerance) & ((not beside) | (end * end + over * over < 36.0 * tolerance * tolerance))
        reached += 1 if seen_here & within else 0
        chosen[count] = k
        count += 1 if seen_here & (not beside) & (abs(dist) <= 2.0 * tolerance) & (leaning[2, k] >= 1e-9) else 0
    out[REACHED] += reached
    for m in range(count):
        k = chosen[m]
        q, dist, axial, rho = near[k], leaning[0, k], leaning[1, k], leaning[2, k]
        x, y, z = local[0, k], local[1, k], local[2, k]
        leg = _leg_of(x, y, z, legs)
        part = 1 if axial - length > (rho - radius + gradient * axial) * cosine else 0
        out[CLOSE] += 1
        nx, ny, nz = normal_at((x, y, z), leg, part, axial, rho, legs, gradient, cosine)
        agree = nx * (pose[3] * normals[q, 0] + pose[6] * normals[q, 1] + pose[9] * normals[q, 2])
        agree += ny * (pose[4] * normals[q, 0] + pose[7] * normals[q, 1] + pose[10] * normals[q, 2])
        agree += nz * (pose[5] * normals[q, 0] + pose[8] * normals[q, 1] + pose[11] * normals[q, 2])
        unsigned = (curved[q] <= 0) | (axial < concave)
        flat = (curved[q] < 0) & (part == 0) & (axial > concave)
        agrees = (agree > LEAST_AGREEMENT) | (unsigned & (agree < -LEAST_AGREEMENT))
        if flat | (not agrees):
            # rounded tips and the fillets of creases are no cone: what disagrees there says nothing
            if axial > rounded or crease_distance(x, y, z, leg, axial, legs) < blurred:
                out[CLOSE] -= 1
                out[REACHED] -= 1
            continue
        out[SUPPORT] += 1
        squares += dist * dist
        if part == 1:
            cells[CELLS_PER_LEG * leg + CELLS_PER_LEG - 1] += 1
        else:
            across1 = x * first[leg, 0] + y * first[leg, 1] + z * first[leg, 2]
            across2 = x * second[leg, 0] + y * second[leg, 1] + z * second[leg, 2]
            ring = int(max(0.0, min(LAST_OF_LEG, (axial - low) / (length - low))) * float(AXIAL_CELLS))
            cells[CELLS_PER_LEG * leg + AXIAL_CELLS * azimuth_cell(across1, across2) + ring] += 1
    # one broken leg end lets the sensor see into the nominal solid: the worst leg's outer part is forgiven
    worst = max(max(outer_inside[0], outer_inside[1]), max(outer_inside[2], outer_inside[3]))
    out[INSIDE] += outer_inside[0] + outer_inside[1] + outer_inside[2] + outer_inside[3] - worst
    for k in range(4):
        own = 0
        for c in range(CELLS_PER_LEG):
            if cells[CELLS_PER_LEG * k + c] >= 2:
                own += 1
        out[CELLS] += own
        if own >= 2:
            out[LEGS] += 1
    if out[SUPPORT] > 0:
        out[MISFIT] = np.sqrt(squares / out[SUPPORT])


@kernel()
def _around(pose: Any, reach: float, grid: Any) -> Any:
    """(n,) numbers of the elements within reach of a pose's centre, and (3, n) their coordinates in its body frame."""
    order, places, origin, size, cell = grid.order, grid.places, grid.origin, grid.size, grid.cell
    low, high = np.empty(2, dtype=np.int64), np.empty(2, dtype=np.int64)
    for a in range(2):
        low[a] = max(0, int(np.floor((pose[a] - reach - origin[a]) / cell)))
        high[a] = min(size[a] - 1, int(np.floor((pose[a] + reach - origin[a]) / cell)))
    wide = max(high[1] - low[1] + 1, 0)
    spans = np.empty((max(high[0] - low[0] + 1, 0) * wide, 2), dtype=np.int64)
    room = 0
    for c in range(len(spans)):
        i, j = low[0] + c // wide, low[1] + c % wide
        spans[c, 0], spans[c, 1] = column_within(i, j, (pose[0], pose[1], pose[2]), reach, grid)
        room += spans[c, 1] - spans[c, 0]
    # one more is written down, and written over where it does not count: branches would take longer
    near, around = np.empty(room + 1, dtype=np.int64), np.empty((3, room + 1))
    count = 0
    for c in range(len(spans)):
        for at in range(spans[c, 0], spans[c, 1]):
            d0, d1, d2 = places[at, 0] - pose[0], places[at, 1] - pose[1], places[at, 2] - pose[2]
            near[count] = order[at]
            around[0, count], around[1, count], around[2, count] = d0, d1, d2
            count += 1 if d0 * d0 + d1 * d1 + d2 * d2 <= reach * reach else 0
    local = np.empty((3, count))
    for k in range(count):
        d0, d1, d2 = around[0, k], around[1, k], around[2, k]
        local[0, k] = d0 * pose[3] + d1 * pose[6] + d2 * pose[9]
        local[1, k] = d0 * pose[4] + d1 * pose[7] + d2 * pose[10]
        local[2, k] = d0 * pose[5] + d1 * pose[8] + d2 * pose[11]
    return near[:count], local


@kernel(makes_arrays=False)
def _relate(local: Any, out: Any, shape: Any) -> None:
    """Signed distance from the cone or the end disc, whichever is larger, axial coordinate and distance from the axis of the leg that each
    of (3, n) points leans to, into ``out`` (3, n); no branches: the loop runs in vector registers."""
    legs, radius, gradient, length, _ = shape
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    a0, a1, a2 = legs[0, 0], legs[0, 1], legs[0, 2]
    b0, b1, b2 = legs[1, 0], legs[1, 1], legs[1, 2]
    c0, c1, c2 = legs[2, 0], legs[2, 1], legs[2, 2]
    d0, d1, d2 = legs[3, 0], legs[3, 1], legs[3, 2]
    for k in range(local.shape[1]):
        x, y, z = local[0, k], local[1, k], local[2, k]
        axial = max(max(x * a0 + y * a1 + z * a2, x * b0 + y * b1 + z * b2), max(x * c0 + y * c1 + z * c2, x * d0 + y * d1 + z * d2))
        rho = np.sqrt(max(x * x + y * y + z * z - axial * axial, 0.0))
        out[0, k] = max((rho - radius + gradient * axial) * cosine, axial - length)
        out[1, k] = axial
        out[2, k] = rho


@kernel()
def _leg_of(x: float, y: float, z: float, legs: Any) -> int:
    """The leg that a point of the body frame leans to."""
    leg = 0
    axial = -1e300
    for k in range(4):
        lean = x * legs[k, 0] + y * legs[k, 1] + z * legs[k, 2]
        if lean > axial:
            axial, leg = lean, k
    return leg


@kernel()
def azimuth_cell(across1: float, across2: float) -> int:
    """Cell around a leg, of ``AZIMUTH_CELLS``, of a direction across it: by the half it lies in, then by its side of the edges there."""
    cell = MIDDLE_CELL if across2 >= 0.0 else 0
    first = cell
    # the edge at 0 lies beyond all directions below it
    for k in range(AZIMUTH_CELLS // 2):
        cell += 1 if EDGES[first + k, 0] * across2 >= EDGES[first + k, 1] * across1 else 0
    return cell
