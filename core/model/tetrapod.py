"""The solid itself: distances to its surface, outward normals, samples and a mesh (paper eqs. 1, 5-7, full rotation).

All functions work in the unit's body frame: origin at the centre, legs along ``UnitType.leg_directions``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..common.arrays import BoolArray, FloatArray, IntArray
from .unit_types import UnitType

EDGE_RATIO = 0.03
"""Width of the fillet along creases and of the chamfer around end discs that is left out, as a share of the height."""
TIP_RATIO = 0.87
"""Share of the leg up to which the cone of a real leg holds; its tip is rounded."""
LATERAL, END_DISC = 0, 1


@dataclass(frozen=True, eq=False)
class SurfaceRelation:
    """How points lie to the surface of a unit.

    Attributes
    ----------
    distance
        (n,) signed orthogonal distance to the nearest part of the surface, metres, positive outside.
    leg
        (n,) leg 0..3 whose sector the point is in.
    part
        (n,) ``LATERAL`` or ``END_DISC``, the nearer part of that leg.
    axial
        (n,) coordinate along the leg's axis from the centre, metres.
    normal
        (n, 3) outward unit normal of that part at the foot of the perpendicular, body frame.
    """

    distance: FloatArray
    leg: IntArray
    part: IntArray
    axial: FloatArray
    normal: FloatArray


def relate(body_points: ArrayLike, unit: UnitType) -> SurfaceRelation:
    """Relate (n, 3) points in the body frame to the surface of the unit.

    A point belongs to the leg whose axis it leans to most; because the cones are equal, the planes of equal lean are exactly
    the creases between the legs.
    """
    lean = _Lean.of(body_points, unit)
    distance, on_end = lean.distance()
    radial = lean.across / np.maximum(lean.rho, 1e-300)[:, None]
    normal = np.where(on_end[:, None], lean.axis, (radial + unit.gradient * lean.axis) * lean.cosine)
    return SurfaceRelation(distance, lean.leg.astype(np.int64), np.where(on_end, END_DISC, LATERAL).astype(np.int64), lean.axial, normal)


def distance_to_surface(body_points: ArrayLike, unit: UnitType) -> FloatArray:
    """(n,) signed distance of (n, 3) points in the body frame as :func:`relate` gives it, without all else that costs as much again."""
    return _Lean.of(body_points, unit).distance()[0]


@dataclass(frozen=True, eq=False)
class _Lean:
    """Points in the frame of the leg that they lean to most.

    Attributes
    ----------
    unit
        Nominal geometry.
    leg, axis, axial
        (n,) number, (n, 3) direction of the leg, (n,) coordinate along it.
    across, rho
        (n, 3) vector from the axis to the point and (n,) its length.
    """

    unit: UnitType
    leg: IntArray
    axis: FloatArray
    axial: FloatArray
    across: FloatArray
    rho: FloatArray

    @classmethod
    def of(cls, body_points: ArrayLike, unit: UnitType) -> _Lean:
        points = np.asarray(body_points, dtype=np.float64).reshape(-1, 3)
        lean = points @ unit.leg_directions.T
        leg = np.argmax(lean, axis=1)
        axis = unit.leg_directions[leg]
        axial = lean[np.arange(len(points)), leg]
        across = points - axial[:, None] * axis
        return cls(unit, leg, axis, axial, across, np.linalg.norm(across, axis=1))

    @property
    def cosine(self) -> float:
        """Of the angle between the cone's generators and its axis."""
        return 1 / math.hypot(1, self.unit.gradient)

    def distance(self) -> tuple[FloatArray, BoolArray]:
        """(n,) signed distance and whether the nearer part is the end disc."""
        unit, rho = self.unit, self.rho
        lateral = (rho - (unit.radius - unit.gradient * self.axial)) * self.cosine
        end = self.axial - unit.leg_length
        on_end = (end > lateral) & (rho <= unit.end_radius) | (end > 0) & (lateral <= 0)
        on_end |= (lateral < 0) & (end > lateral)
        # past the rim of the end disc the nearest point is the rim itself
        beyond = (end > 0) & (rho > unit.end_radius)
        rim = np.hypot(rho - unit.end_radius, end)
        return np.where(beyond, rim, np.where(on_end, end, lateral)), on_end


def raise_means(body_means: ArrayLike, spread: FloatArray, unit: UnitType) -> FloatArray:
    """(m, 3) means of points on a unit's surface, moved out to where the surface is; body frame.

    The mean of points of a surface that bends lies inside of it, by half its curvature times their variance in that direction (the second
    order of the surface about its tangent plane). Generators of a cone and end discs are straight.

    Parameters
    ----------
    body_means
        (m, 3) metres.
    spread
        (m,) variance of the points of each along the surface, square metres.
    unit
        Nominal geometry.
    """
    means = np.asarray(body_means, dtype=np.float64).reshape(-1, 3)
    relation = relate(means, unit)
    cosine = 1 / math.hypot(1, unit.gradient)
    curvature = cosine / np.maximum(unit.radius - unit.gradient * relation.axial, 0.05 * unit.radius)
    height = np.where(relation.part == LATERAL, 0.5 * curvature * spread, 0.0)
    return np.asarray(means + height[:, None] * relation.normal)


def sample_surface(
    unit: UnitType, count: int, rng: np.random.Generator, *, end_discs: bool = True
) -> tuple[FloatArray, FloatArray, IntArray]:
    """Draw ``count`` points uniformly over the outer surface.

    Returns
    -------
    points, normals, leg
        (count, 3) body coordinates, (count, 3) outward unit normals, (count,) leg 0..3; end discs are left out when
        ``end_discs`` is False (the paper's simulation has lateral surfaces only).
    """
    slant = math.hypot(1, unit.gradient)
    lateral_area = math.pi * (unit.radius + unit.end_radius) * unit.leg_length * slant
    disc_area = math.pi * unit.end_radius**2 if end_discs else 0.0
    points, normals, legs = [], [], []
    have = 0
    while have < count:
        n = 2 * (count - have) + 64
        leg = rng.integers(0, 4, n)
        on_disc = rng.random(n) < disc_area / (lateral_area + disc_area)
        azimuth = rng.uniform(0, 2 * math.pi, n)
        # radius of a lateral sample falls linearly along the axis: invert the cumulative area
        u = rng.random(n)
        rho = np.sqrt(unit.radius**2 + u * (unit.end_radius**2 - unit.radius**2))
        z = (unit.radius - rho) / unit.gradient
        rho = np.where(on_disc, unit.end_radius * np.sqrt(u), rho)
        z = np.where(on_disc, unit.leg_length, z)
        first, second = across_legs(unit)
        radial = np.cos(azimuth)[:, None] * first[leg] + np.sin(azimuth)[:, None] * second[leg]
        axis = unit.leg_directions[leg]
        p = z[:, None] * axis + rho[:, None] * radial
        outside = np.argmax(p @ unit.leg_directions.T, axis=1) == leg
        normal = np.where(on_disc[:, None], axis, (radial + unit.gradient * axis) / slant)
        points.append(p[outside])
        normals.append(normal[outside])
        legs.append(leg[outside])
        have += int(outside.sum())
    return np.vstack(points)[:count], np.vstack(normals)[:count], np.concatenate(legs)[:count]


def surface_cells(unit: UnitType, count: int = 400) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Centres, outward normals and areas of about equal cells of the outer surface (deterministic).

    Returns (m, 3), (m, 3), (m,) with m close to ``count``; used to state which share of a unit is seen.
    """
    rng = np.random.default_rng(20250314)
    dense, normals, _ = sample_surface(unit, 40 * count, rng)
    centres = dense[_farthest(dense, count)]
    from scipy.spatial import cKDTree

    _, owner = cKDTree(centres).query(dense)
    area = np.bincount(owner, minlength=count) * (surface_area(unit) / len(dense))
    chosen = cKDTree(dense).query(centres)[1]
    return centres, np.asarray(normals[chosen]), np.asarray(area)


def surface_area(unit: UnitType) -> float:
    """Area of the outer surface, m2: lateral sectors outside the joints, and the four end discs."""
    azimuth = (np.arange(3600) + 0.5) * (2 * math.pi / 3600)
    total = 0.0
    slant = math.hypot(1, unit.gradient)
    first, second = across_legs(unit)
    for k in range(4):
        radial = np.cos(azimuth)[:, None] * first[k] + np.sin(azimuth)[:, None] * second[k]
        start = np.clip(_crease(unit, k, radial), 0, unit.leg_length)
        rho0 = unit.radius - unit.gradient * start
        total += float(np.mean((rho0**2 - unit.end_radius**2) / (2 * unit.gradient))) * 2 * math.pi * slant
        total += math.pi * unit.end_radius**2
    return total


def mesh(unit: UnitType, segments: int = 48, rings: int = 12) -> tuple[FloatArray, IntArray]:
    """Triangle mesh of the outer surface: (v, 3) vertices in metres and (t, 3) indices, outward oriented, closed but for the
    creases, where the sectors meet along the same curve."""
    vertices: list[FloatArray] = []
    triangles: list[IntArray] = []
    offset = 0
    azimuth = np.arange(segments) * (2 * math.pi / segments)
    first, second = across_legs(unit)
    for k in range(4):
        radial = np.cos(azimuth)[:, None] * first[k] + np.sin(azimuth)[:, None] * second[k]
        a_k = unit.leg_directions[k]
        start = _crease(unit, k, radial)
        t = np.linspace(0, 1, rings + 1)[:, None]
        z = start + t * (unit.leg_length - start)
        rho = unit.radius - unit.gradient * z
        side = z[..., None] * a_k + rho[..., None] * radial
        vertices += [side.reshape(-1, 3), (unit.leg_length * a_k)[None]]
        i, j = np.meshgrid(np.arange(rings), np.arange(segments), indexing="ij")
        a, b = i * segments + j, i * segments + (j + 1) % segments
        c, d = a + segments, b + segments
        apex = (rings + 1) * segments
        last = rings * segments + np.arange(segments)
        cap = np.column_stack([last, np.roll(last, -1), np.full(segments, apex)])
        quads = np.vstack([np.stack([a, b, d], -1).reshape(-1, 3), np.stack([a, d, c], -1).reshape(-1, 3), cap])
        triangles.append(quads.astype(np.int64) + offset)
        offset += apex + 1
    return np.vstack(vertices), np.vstack(triangles)


def _crease(unit: UnitType, leg: int, radial: FloatArray) -> FloatArray:
    """(n,) axial coordinate, metres, at which a leg comes out of the joint in the directions ``radial`` (n, 3) across its axis."""
    others = [m for m in range(4) if m != leg]
    a_k, a_m = unit.leg_directions[leg], unit.leg_directions[others]
    # crease: z a_k.(a_k - a_m) = rho radial.(a_m - a_k) with rho = r - c z, solved for z
    lean = radial @ (a_m - a_k).T
    return np.asarray(np.max(unit.radius * lean / (1 - a_m @ a_k + unit.gradient * lean), axis=1))


def across_legs(unit: UnitType) -> tuple[FloatArray, FloatArray]:
    """Two (4, 3) sets of unit vectors that complete each leg's axis to a right-handed frame."""
    return across_axes(unit.leg_directions)


def across_axes(axes: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Two (k, 3) sets of unit vectors that complete each of (k, 3) unit vectors to a right-handed frame."""
    help_axis = np.where(np.abs(axes[:, 2:3]) < 0.9, [[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]])
    first = np.cross(help_axis, axes)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    return first, np.cross(axes, first)


def leg_frame(unit: UnitType) -> tuple[FloatArray, FloatArray]:
    """Two (4, 3) sets of unit vectors that complete each leg's axis to a right-handed frame, the first towards another leg.

    The same for every leg up to the symmetries of a tetrahedral unit: what a mould does around a leg comes back every third of a turn.
    """
    axes = unit.leg_directions
    other = axes[[1, 0, 0, 0]]
    first = other - np.sum(other * axes, axis=1, keepdims=True) * axes
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    return np.ascontiguousarray(first), np.cross(axes, first)


def turn_around(body_points: FloatArray, leg: IntArray, unit: UnitType) -> FloatArray:
    """(n,) angle of (n, 3) points in the body frame around the axes of their (n,) legs, from the first vector of :func:`leg_frame`."""
    first, second = leg_frame(unit)
    across, towards = (np.einsum("ij,ij->i", body_points, own[leg]) for own in (second, first))
    return np.asarray(np.arctan2(across, towards))


def _farthest(points: FloatArray, count: int) -> IntArray:
    """Indices of ``count`` points spread by farthest-point sampling."""
    chosen = np.zeros(count, dtype=np.int64)
    nearest = np.full(len(points), np.inf)
    x, y, z = np.ascontiguousarray(points.T)
    for k in range(1, count):
        place = points[chosen[k - 1]]
        np.minimum(nearest, (x - place[0]) ** 2 + (y - place[1]) ** 2 + (z - place[2]) ** 2, out=nearest)
        chosen[k] = int(np.argmax(nearest))
    return chosen
