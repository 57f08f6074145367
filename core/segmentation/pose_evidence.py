"""What the elements of a scene say about the poses of whole units (paper 2.1)."""

from __future__ import annotations

from functools import lru_cache, partial
from typing import Any, NamedTuple

import numpy as np

from ..common.arrays import BoolArray, FloatArray
from ..common.kernels import in_parts, kernel
from ..common.neighbourhood import column_within
from ..model.tetrapod import EDGE_RATIO, TIP_RATIO, across_legs
from ..model.unit_types import UnitType
from .cone_relation import FEW_POSES, ConeShape, OrientedPoints, crease_distance, normal_at, relate_point, surely_farther
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
    shape, elements = ConeShape.of(scene.unit), OrientedPoints(scene.points, scene.normals, scene.curved)
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
    _, order, places, origin, size, cell = grid
    legs, radius, gradient, length, height = shape
    tolerance, seen, blurred, across = limits
    first, second = across[0], across[1]
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    low = INNER_RATIO * height
    reach = 0.75 * height
    lo = np.empty(2, dtype=np.int64)
    hi = np.empty(2, dtype=np.int64)
    for a in range(2):
        lo[a] = max(0, int(np.floor((pose[a] - reach - origin[a]) / cell)))
        hi[a] = min(size[a] - 1, int(np.floor((pose[a] + reach - origin[a]) / cell)))
    cells = np.zeros(NUMBER_OF_CELLS, dtype=np.int64)
    outer = OUTER_SHARE * length
    rounded = (1.0 - seen * (1.0 - TIP_RATIO)) * length
    # where two legs meet they are concave: so far from there the sense of curvature tells nothing
    half = np.sqrt(0.5 + 0.5 * (legs[0, 0] * legs[1, 0] + legs[0, 1] * legs[1, 1] + legs[0, 2] * legs[1, 2]))
    concave = radius * half / (np.sqrt(1.0 - half * half) + gradient * half) + (BEND_RADIUS_RATIO + EDGE_RATIO) * height
    outer_inside = np.zeros(4)
    squares = 0.0
    for gi in range(lo[0], hi[0] + 1):
        for gj in range(lo[1], hi[1] + 1):
            first_at, last_at = column_within(gi, gj, (pose[0], pose[1], pose[2]), reach, grid)
            for at in range(first_at, last_at):
                q = order[at]
                d0 = places[at, 0] - pose[0]
                d1 = places[at, 1] - pose[1]
                d2 = places[at, 2] - pose[2]
                if d0 * d0 + d1 * d1 + d2 * d2 > reach * reach:
                    continue
                x = d0 * pose[3] + d1 * pose[6] + d2 * pose[9]
                y = d0 * pose[4] + d1 * pose[7] + d2 * pose[10]
                z = d0 * pose[5] + d1 * pose[8] + d2 * pose[11]
                if surely_farther(x, y, z, legs, radius, gradient, length, 6.0 * tolerance):
                    continue
                leg, dist, part, axial, rho = relate_point(x, y, z, legs, radius, gradient, length)
                if dist < -max(3.0 * tolerance, 0.03 * height):
                    if axial > outer:
                        outer_inside[leg] += 1
                    else:
                        out[INSIDE] += 1
                    continue
                if not active[q]:
                    continue
                if dist < 6.0 * tolerance:
                    out[REACHED] += 1
                if part == 2 or abs(dist) > 2.0 * tolerance or rho < 1e-9:
                    continue
                out[CLOSE] += 1
                nx, ny, nz = normal_at((x, y, z), leg, part, axial, rho, legs, gradient, cosine)
                agree = nx * (pose[3] * normals[q, 0] + pose[6] * normals[q, 1] + pose[9] * normals[q, 2])
                agree += ny * (pose[4] * normals[q, 0] + pose[7] * normals[q, 1] + pose[10] * normals[q, 2])
                agree += nz * (pose[5] * normals[q, 0] + pose[8] * normals[q, 1] + pose[11] * normals[q, 2])
                unsigned = curved[q] <= 0 or axial < concave
                flat = curved[q] < 0 and part == 0 and axial > concave
                if flat or not (agree > LEAST_AGREEMENT or (unsigned and agree < -LEAST_AGREEMENT)):
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
                    azimuth = int((np.arctan2(across2, across1) + np.pi) / (2.0 * np.pi) * LAST_OF_TURN)
                    ring = int(max(0.0, min(LAST_OF_LEG, (axial - low) / (length - low))) * float(AXIAL_CELLS))
                    cells[CELLS_PER_LEG * leg + AXIAL_CELLS * azimuth + ring] += 1
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
