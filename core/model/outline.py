"""Outlines of a unit for drawings: its silhouette from any side and its section by a plane through the centre.

Co-centred cones form a star-shaped solid, so both follow from the reach of the surface along a direction. Nothing but numpy
is needed: these functions also run inside QGIS's own Python.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from ..common.arrays import FloatArray

SPM_PACKING = 0.52
"""Units per Dn^2 of one layer of tetrapods by design: 1.04 for two (Shore Protection Manual, 1984, table 7-13: k = 1.04, porosity 50 %)."""


@dataclass(frozen=True, eq=False, kw_only=True)
class PlacedShape:
    """A unit as drawn.

    Attributes
    ----------
    centre
        (3,) metres, easting, northing, height.
    rotation
        (3, 3) body to CRS axes.
    radius, gradient, leg_length
        Leg cone radius at the centre (m), loss of radius per metre, centre to end disc (m).
    legs
        (4, 3) unit vectors of the legs in the body frame.
    """

    centre: FloatArray
    rotation: FloatArray
    radius: float
    gradient: float
    leg_length: float
    legs: FloatArray


def rotation_of_quaternion(quaternion: ArrayLike) -> FloatArray:
    """(3, 3) rotation of (qx, qy, qz, qw); the quaternion need not have length one.

    Raises
    ------
    ValueError
        The quaternion is zero or not finite.
    """
    q = np.asarray(quaternion, dtype=np.float64)
    length = float(np.linalg.norm(q))
    if not math.isfinite(length) or length == 0:
        raise ValueError(f"no rotation follows from the quaternion {q.tolist()}")
    x, y, z, w = q / length
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def quaternion_of_rotation(rotation: FloatArray) -> FloatArray:
    """(4,) qx, qy, qz, qw of a (3, 3) rotation, qw >= 0: the leading eigenvector of the matrix of Bar-Itzhack (2000)."""
    r = rotation
    k = np.array(
        [
            [r[0, 0] - r[1, 1] - r[2, 2], r[1, 0] + r[0, 1], r[2, 0] + r[0, 2], r[2, 1] - r[1, 2]],
            [r[1, 0] + r[0, 1], r[1, 1] - r[0, 0] - r[2, 2], r[2, 1] + r[1, 2], r[0, 2] - r[2, 0]],
            [r[2, 0] + r[0, 2], r[2, 1] + r[1, 2], r[2, 2] - r[0, 0] - r[1, 1], r[1, 0] - r[0, 1]],
            [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], r[0, 0] + r[1, 1] + r[2, 2]],
        ]
    )
    q = np.linalg.eigh(k)[1][:, -1]
    return np.asarray(q if q[3] >= 0 else -q)


def reach(directions: ArrayLike, shape: PlacedShape) -> FloatArray:
    """(...,) distance in metres from the centre to the surface along (..., 3) unit directions in the CRS axes."""
    body = np.asarray(directions, dtype=np.float64) @ shape.rotation
    return _reach_beside(np.max(body @ shape.legs.T, axis=-1), shape)


def _reach_beside(cosine: FloatArray, shape: PlacedShape) -> FloatArray:
    """The same by the cosine of the angle between a direction and the axis of the leg next to it."""
    cosine = np.clip(cosine, -1, 1)
    sine = np.sqrt(1 - cosine**2)
    return np.asarray(np.minimum(shape.radius / (sine + shape.gradient * cosine), shape.leg_length / np.maximum(cosine, 1e-12)))


def volume(shape: PlacedShape) -> float:
    """Volume of the union of the four frusta, m3: the integral of reach^3 / 3 over the sphere, since co-centred cones are star-shaped."""
    axes = np.asarray(shape.legs @ shape.rotation.T, dtype=np.float64)
    return _volume(shape.radius, shape.gradient, shape.leg_length, axes.tobytes())


@lru_cache(maxsize=256)
def _volume(radius: float, gradient: float, leg_length: float, legs: bytes) -> float:
    """The same by the axes of the legs in the CRS, given as bytes: the same for units of one kind that lie alike."""
    axes = np.frombuffer(legs).reshape(-1, 3)
    shape = PlacedShape(centre=np.zeros(3), rotation=np.eye(3), radius=radius, gradient=gradient, leg_length=leg_length, legs=axes)
    z, weight = np.polynomial.legendre.leggauss(400)
    azimuth = (np.arange(720) + 0.5) * (2 * math.pi / 720)
    east, north, rho = np.cos(azimuth), np.sin(azimuth), np.sqrt(1 - z**2)
    cosine = np.full((len(z), len(azimuth)), -1.0)
    for leg in axes:
        np.maximum(cosine, np.multiply.outer(rho, leg[0] * east + leg[1] * north) + (leg[2] * z)[:, None], out=cosine)
    reached = _reach_beside(cosine, shape)
    return float(weight @ np.sum(reached * reached * reached, axis=1) / 3 * (2 * math.pi / 720))


def nominal_diameter(shapes: Sequence[PlacedShape]) -> float:
    """Dn = volume^(1/3) of units as fitted, metres: of their median cone."""
    radius, gradient, leg_length = np.median([(shape.radius, shape.gradient, shape.leg_length) for shape in shapes], axis=0).tolist()
    typical = replace(shapes[0], rotation=np.eye(3), radius=radius, gradient=gradient, leg_length=leg_length)
    return float(volume(typical) ** (1 / 3))


def section(shape: PlacedShape, right: ArrayLike, up: ArrayLike, steps: int = 240) -> FloatArray:
    """(steps + 1, 2) closed curve in which the plane through the centre spanned by two orthonormal (3,) axes cuts the unit.

    Coordinates are metres along ``right`` and ``up`` from the centre.
    """
    angle = np.linspace(0, 2 * math.pi, steps + 1)
    flat = np.column_stack([np.cos(angle), np.sin(angle)])
    return np.asarray(flat * reach(flat @ np.vstack([right, up]), shape)[:, None])


def silhouette(shape: PlacedShape, right: ArrayLike, up: ArrayLike, steps: int = 180) -> FloatArray:
    """(steps + 1, 2) closed outline of the unit seen along the cross product of two orthonormal (3,) axes, metres from the centre."""
    r, u = np.asarray(right, dtype=np.float64), np.asarray(up, dtype=np.float64)
    towards = np.cross(r, u)
    angle = np.linspace(0, 2 * math.pi, steps + 1)
    tilt = np.linspace(-0.45 * math.pi, 0.45 * math.pi, 91)
    flat = np.column_stack([np.cos(angle), np.sin(angle)])
    across = flat @ np.vstack([r, u])
    directions = np.cos(tilt)[None, :, None] * across[:, None, :] + np.sin(tilt)[None, :, None] * towards
    extent = np.max(reach(directions, shape) * np.cos(tilt), axis=1)
    return np.asarray(flat * extent[:, None])


def end_discs(shape: PlacedShape, right: ArrayLike, up: ArrayLike, steps: int = 48) -> list[FloatArray]:
    """Outlines ((steps + 1, 2), metres from the centre) of the end discs that face the viewer."""
    axes = np.vstack([right, up])
    towards = np.cross(axes[0], axes[1])
    angle = np.linspace(0, 2 * math.pi, steps + 1)
    rim = max(shape.radius - shape.gradient * shape.leg_length, 0.0)
    discs = []
    for leg in shape.legs @ shape.rotation.T:
        if leg @ towards <= 0:
            continue
        helper = axes[0] if abs(leg @ axes[0]) < 0.9 else axes[1]
        first = np.cross(leg, helper)
        first /= np.linalg.norm(first)
        second = np.cross(leg, first)
        circle = shape.leg_length * leg + rim * (np.cos(angle)[:, None] * first + np.sin(angle)[:, None] * second)
        discs.append(np.asarray(circle @ axes.T))
    return discs
