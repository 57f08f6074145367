"""Free gaps between neighbouring units: least distance from the surface of one to that of the other."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..common.kernels import kernel
from ..model.outline import PlacedShape
from ..model.tetrapod import across_axes

ALONG, AROUND = 14, 16
"""Points along a leg, those of its end disc among them, and around it that stand for its surface in the first search."""
STEPS = 12
"""Steps of the search around the nearest place of a leg, each as wide as the last or half: from 0.2 m to below a millimetre."""


def free_gaps(shapes: Sequence[PlacedShape], pairs: IntArray) -> FloatArray:
    """(m,) gap of each of (m, 2) pairs of units, metres; negative where the fitted bodies reach into each other.

    The surface of either unit is searched for the point nearest to the other, coarsely first and then ever finer around the best
    places, so that the gap is right to a millimetre.
    """
    if not len(pairs):
        return np.zeros(0)
    origin = shapes[0].centre
    bodies = np.array([_record(shape, origin) for shape in shapes])
    found = np.empty((len(pairs), 2))
    _search(bodies, np.ascontiguousarray(pairs, dtype=np.int64), found)
    return np.asarray(found.min(axis=1))


def reach_of(shape: PlacedShape) -> float:
    """Distance from the centre of a unit to its farthest point, metres."""
    return math.hypot(shape.leg_length, shape.radius - shape.gradient * shape.leg_length)


def _record(shape: PlacedShape, origin: FloatArray) -> FloatArray:
    """(42,) a unit for the loops: centre, radius, gradient, leg length, and by leg its axis and two directions across it, in the CRS."""
    parts = [shape.centre - origin, np.array([shape.radius, shape.gradient, shape.leg_length])]
    for own in zip(shape.legs, *across_axes(shape.legs), strict=True):
        parts += [shape.rotation @ v for v in own]
    return np.concatenate(parts)


@kernel()
def _distance(body: FloatArray, x: float, y: float, z: float) -> float:
    """Distance of a place to the surface of a unit, metres, positive outside; as ``model.tetrapod.relate``."""
    x, y, z = x - body[0], y - body[1], z - body[2]
    axial = -1e300
    for leg in range(4):
        at = 6 + 9 * leg
        axial = max(axial, x * body[at] + y * body[at + 1] + z * body[at + 2])
    rho = math.sqrt(max(x * x + y * y + z * z - axial * axial, 0.0))
    rim = body[3] - body[4] * body[5]
    lateral = (rho - (body[3] - body[4] * axial)) / math.sqrt(1 + body[4] * body[4])
    end = axial - body[5]
    if lateral <= 0 and end <= 0:
        return float(max(lateral, end))
    if end > 0:
        return float(math.sqrt((rho - rim) ** 2 + end * end) if rho > rim else end)
    return float(lateral)


@kernel()
def _at(first: FloatArray, second: FloatArray, leg: int, along: float, around: float) -> float:
    """Distance to a second unit of a place on a leg of a first one: ``along`` 0 to 1 on the cone, 1 to 2 from the rim to the disc's middle.

    Places within the joint lie inside the body and are never the nearest.
    """
    at = 6 + 9 * leg
    axial = min(along, 1.0) * first[5]
    rho = (first[3] - first[4] * axial) * min(2 - along, 1.0)
    c, s = rho * math.cos(around), rho * math.sin(around)
    x = first[0] + axial * first[at] + c * first[at + 3] + s * first[at + 6]
    y = first[1] + axial * first[at + 1] + c * first[at + 4] + s * first[at + 7]
    z = first[2] + axial * first[at + 2] + c * first[at + 5] + s * first[at + 8]
    return _distance(second, x, y, z)


@kernel()
def _search(bodies: FloatArray, pairs: IntArray, found: FloatArray) -> None:
    """Fill ``found`` (m, 2) with the least distance of the surface of either unit of a pair to the other."""
    for pair in range(len(pairs)):
        for way in range(2):
            first, second = bodies[pairs[pair, way]], bodies[pairs[pair, 1 - way]]
            best = 1e300
            for leg in range(4):
                nearest, along, around = 1e300, 0.0, 0.0
                for i in range(ALONG):
                    for j in range(AROUND):
                        a, b = 2.0 * i / (ALONG - 1), 2 * math.pi * j / AROUND
                        distance = _at(first, second, leg, a, b)
                        if distance < nearest:
                            nearest, along, around = distance, a, b
                width, turn = 2.0 / (ALONG - 1), 2 * math.pi / AROUND
                for _ in range(STEPS if nearest < best + 0.5 * first[3] else 0):
                    to_along, to_around = along, around
                    for i in range(-1, 2):
                        for j in range(-1, 2):
                            a, b = min(max(along + i * width, 0.0), 2.0), around + j * turn
                            distance = _at(first, second, leg, a, b)
                            if distance < nearest:
                                nearest, to_along, to_around = distance, a, b
                    if to_along == along and to_around == around:
                        width, turn = width / 2, turn / 2
                    along, around = to_along, to_around
                best = min(best, nearest)
            found[pair, way] = best
