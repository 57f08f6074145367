"""How points lie to the cones and end discs of a unit, for compiled loops, in the unit's own frame.

A pose is held as 12 numbers there, centre (3) and rotation body -> frame (9, by rows), because that is what compiled loops like.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray
from ..common.kernels import kernel
from ..model.unit_types import UnitType

FEW_POSES = 4
"""Poses up to which starting the threads takes longer than the work."""


class ConeShape(NamedTuple):
    """A unit's shape as compiled loops take it: (4, 3) directions of the legs, radius, gradient, leg length, height; metres."""

    legs: FloatArray
    radius: float
    gradient: float
    length: float
    height: float

    @classmethod
    def of(cls, unit: UnitType) -> ConeShape:
        """Of a unit type."""
        return cls(unit.leg_directions, float(unit.radius), float(unit.gradient), float(unit.leg_length), float(unit.height))


class OrientedPoints(NamedTuple):
    """Elements as compiled loops take them."""

    points: FloatArray
    normals: FloatArray
    curved: NDArray[np.int8]


@kernel()
def relate_point(x: Any, y: Any, z: Any, legs: Any, radius: float, gradient: float, length: float) -> Any:
    """Leg, signed distance, part (0 lateral, 1 end disc), axial coordinate and distance from the axis, in the body frame."""
    leg = 0
    axial = -1e300
    for k in range(4):
        lean = x * legs[k, 0] + y * legs[k, 1] + z * legs[k, 2]
        if lean > axial:
            axial = lean
            leg = k
    rho = np.sqrt(max(x * x + y * y + z * z - axial * axial, 0.0))
    lateral = (rho - radius + gradient * axial) / np.sqrt(1.0 + gradient * gradient)
    end = axial - length
    edge = radius - gradient * length
    if end > 0.0 and rho > edge:
        return leg, np.sqrt(end * end + (rho - edge) ** 2), 2, axial, rho
    if end > lateral:
        return leg, end, 1, axial, rho
    return leg, lateral, 0, axial, rho


@kernel()
def normal_at(place: Any, leg: int, part: int, axial: float, rho: float, legs: Any, gradient: float, cosine: float) -> Any:
    """Outward normal of the lateral surface (part 0) or end disc (1) of a leg, body frame."""
    x, y, z = place
    ax, ay, az = legs[leg, 0], legs[leg, 1], legs[leg, 2]
    if part == 1:
        return ax, ay, az
    along = gradient - axial / rho
    return (x / rho + along * ax) * cosine, (y / rho + along * ay) * cosine, (z / rho + along * az) * cosine


@kernel()
def crease_distance(x: float, y: float, z: float, leg: int, axial: float, legs: Any) -> float:
    """Distance of a point of the body frame from the nearest plane in which its leg meets another."""
    nearest = np.inf
    for k in range(4):
        if k != leg:
            between = 2.0 - 2.0 * (legs[leg, 0] * legs[k, 0] + legs[leg, 1] * legs[k, 1] + legs[leg, 2] * legs[k, 2])
            nearest = min(nearest, (axial - x * legs[k, 0] - y * legs[k, 1] - z * legs[k, 2]) / np.sqrt(between))
    return nearest


@kernel()
def height_above_cones(x: float, y: float, z: float, legs: Any, shape: Any) -> float:
    """Signed distance to the cone or the end disc of the leg a body point leans to, metres, positive outside.

    What :func:`relate_point` tells less the rim of the disc, in half the time; ``shape`` is radius, gradient and length.
    """
    axial = -1e300
    for k in range(4):
        lean = x * legs[k, 0] + y * legs[k, 1] + z * legs[k, 2]
        if lean > axial:
            axial = lean
    rho = np.sqrt(max(x * x + y * y + z * z - axial * axial, 0.0))
    lateral = (rho - shape[0] + shape[1] * axial) / np.sqrt(1.0 + shape[1] * shape[1])
    return float(max(lateral, axial - shape[2]))
