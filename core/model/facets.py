"""A unit as a body of plane faces, and its true outline from above: what maps, scenes and exported models draw.

Nothing but numpy is needed: these functions also run inside QGIS's own Python.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ..common.arrays import FloatArray, IntArray
from .outline import PlacedShape

SIDES = 12
"""Faces around a leg unless asked for otherwise; a multiple of six, so that the joints of three legs are corners."""
_WELD = 1e-6
"""Corners of two legs closer than this, metres, are one: they are computed from either side of a crease."""


@dataclass(frozen=True, eq=False)
class Facets:
    """Plane faces of a unit, k around each of its four legs; every corner lies on the surface of the unit.

    Attributes
    ----------
    root, rim
        (4, k, 3) corners where a leg comes out of the joint and around its end disc, metres, counter-clockwise about the leg's axis.
    normals
        (4, k, 3) outward unit normals of the cone along the line through ``root`` and ``rim``.
    axes
        (4, 3) unit vectors of the legs, which are the normals of the end discs.
    """

    root: FloatArray
    rim: FloatArray
    normals: FloatArray
    axes: FloatArray

    @property
    def lateral(self) -> FloatArray:
        """(4 k, 4, 3) corners of the faces along the legs, counter-clockwise from outside; each face is plane."""
        faces = [self.root, np.roll(self.root, -1, axis=1), np.roll(self.rim, -1, axis=1), self.rim]
        return np.stack(faces, axis=2).reshape(-1, 4, 3)

    def placed(self, centre: FloatArray, rotation: FloatArray) -> Facets:
        """The same faces after a rotation (3, 3) and a shift to ``centre`` (3,)."""
        return Facets(
            self.root @ rotation.T + centre, self.rim @ rotation.T + centre, self.normals @ rotation.T, np.asarray(self.axes @ rotation.T)
        )

    def welded(self) -> tuple[FloatArray, IntArray, IntArray]:
        """One list of corners (v, 3), with (4 k, 4) and (4, k) indices into it of the faces along the legs and of the end discs."""
        corners = np.vstack([self.lateral.reshape(-1, 3), self.rim.reshape(-1, 3)])
        _, first, owner = np.unique(np.round(corners / _WELD).astype(np.int64), axis=0, return_index=True, return_inverse=True)
        owner = owner.reshape(-1)
        count = 4 * len(self.lateral)
        return corners[first], owner[:count].reshape(-1, 4), owner[count:].reshape(4, -1)


def facets(shape: PlacedShape, sides: int = SIDES) -> Facets:
    """Faces of a unit in its own body frame (see :meth:`Facets.placed`), ``sides`` around each leg.

    With legs at equal angles the bodies are closed: neighbouring legs share the corners of their crease.
    """
    gradient, legs = shape.gradient, shape.legs
    radial, start = _around_legs(np.asarray(legs, dtype=np.float64).tobytes(), gradient, sides)
    axes = legs[:, None]

    def corners(along: FloatArray) -> FloatArray:
        """Corners at (4, k) or (1, 1) distances along the legs."""
        return np.asarray(along[..., None] * axes + (shape.radius - gradient * along)[..., None] * radial)

    normals = (radial + gradient * axes) * (1 / math.hypot(1, gradient))
    return Facets(corners(shape.radius * start), corners(np.full((1, 1), shape.leg_length)), normals, legs)


@lru_cache(maxsize=64)
def _around_legs(axes: bytes, gradient: float, sides: int) -> tuple[FloatArray, FloatArray]:
    """Directions (4, k, 3) around legs, whose unit vectors are given as bytes, and (4, k) how far along a leg its crease lies in each, over
    its radius: the same for units of one kind."""
    legs = np.frombuffer(axes).reshape(-1, 3)
    azimuth = np.arange(sides) * (2 * math.pi / sides)
    around: list[FloatArray] = []
    starts: list[FloatArray] = []
    for k, axis in enumerate(legs):
        others = [m for m in range(len(legs)) if m != k]
        # from the direction to a neighbour on, so that the corners of both legs mirror each other at the crease
        first = legs[others[0]] - (legs[others[0]] @ axis) * axis
        first = first / np.linalg.norm(first)
        radial = np.cos(azimuth)[:, None] * first + np.sin(azimuth)[:, None] * np.cross(axis, first)
        # crease: z a_k.(a_k - a_m) = rho radial.(a_m - a_k) with rho = r - c z, solved for z
        lean = radial @ (legs[others] - axis).T
        starts.append(np.max(lean / (1 - legs[others] @ axis + gradient * lean), axis=1))
        around.append(radial)
    return np.array(around), np.array(starts)


def triangulated(body: Facets) -> tuple[FloatArray, FloatArray, IntArray]:
    """Corners (n, 3), outward normals (n, 3) and triangles (m, 3) for drawing: smooth around the cones, with an edge at the end discs."""
    sides = body.root.shape[1]
    corners = np.concatenate([body.root, body.rim, body.rim], axis=1)
    normals = np.concatenate([body.normals, body.normals, np.repeat(body.axes[:, None], sides, axis=1)], axis=1)
    k = np.arange(sides)
    after = (k + 1) % sides
    lateral = [np.column_stack([k, after, sides + after]), np.column_stack([k, sides + after, sides + k])]
    fan = 2 * sides + np.column_stack([np.zeros(sides - 2, dtype=np.int64), k[1:-1], k[2:]])
    one_leg = np.vstack([*lateral, fan])
    return corners.reshape(-1, 3), normals.reshape(-1, 3), np.vstack([one_leg + 3 * sides * leg for leg in range(4)])


def plan_outline(shape: PlacedShape, directions: int = 48) -> FloatArray:
    """(n, 2) corners of the outline of a unit seen from above, easting and northing in metres, counter-clockwise, not closed.

    A leg is the convex hull of two discs, its end and the circle of its cone at the centre, so that the point of its outline in any
    direction is known in closed form; the unit's outline is that of its four legs together, which all hold the centre.

    Parameters
    ----------
    shape
        The unit.
    directions
        Corners of a leg's outline before the legs are put together.
    """
    legs = [_Outline.of(corners) for corners in _leg_corners(shape, directions)]
    rays, places = np.unique(np.concatenate([leg.angle for leg in legs]), return_inverse=True)
    length = np.array([leg.reach(rays) for leg in legs])
    longest = np.argmax(length, axis=0)
    is_corner = np.zeros(length.shape, dtype=np.bool_)
    is_corner[np.repeat(np.arange(len(legs)), directions), places] = True
    corner = is_corner[longest, np.arange(len(rays))]
    after = np.roll(rays, -1)
    after[-1] += 2 * math.pi
    crossed = np.flatnonzero(longest != np.roll(longest, -1))
    crossings = [_crossing(legs[longest[k]], legs[longest[(k + 1) % len(rays)]], rays[k], after[k]) for k in crossed]
    kept = np.flatnonzero(corner)
    points = (length[longest, np.arange(len(rays))] * np.array([np.cos(rays), np.sin(rays)])).T[kept]
    order = np.argsort(np.concatenate([kept, crossed + 0.5]), kind="stable")
    return np.asarray(np.vstack([points, np.reshape(crossings, (-1, 2))])[order] + shape.centre[:2])


def _leg_corners(shape: PlacedShape, directions: int) -> FloatArray:
    """(4, directions, 2) corners of the outlines of the legs from above, metres from the centre, counter-clockwise."""
    angle = np.arange(directions) * (2 * math.pi / directions)
    outward = np.column_stack([np.cos(angle), np.sin(angle)])
    axes = (shape.legs @ shape.rotation.T)[:, None, :2]
    along = np.sum(outward * axes, axis=-1, keepdims=True)
    # the point of a disc farthest in a direction n lies at its radius along the share of n in the disc's plane
    in_plane = (outward - along * axes) / np.sqrt(np.maximum(1 - along**2, 1e-12))
    at_root = shape.radius * in_plane
    at_end = shape.leg_length * axes + (shape.radius - shape.gradient * shape.leg_length) * in_plane
    end_farther = np.sum(outward * (at_end - at_root), axis=-1, keepdims=True) > 0
    return np.asarray(np.where(end_farther, at_end, at_root))


@dataclass(frozen=True, eq=False)
class _Outline:
    """A convex outline around the origin: corners (n, 2) by their angle (n,), and the vector (n, 2) to the next one."""

    corners: FloatArray
    angle: FloatArray
    along: FloatArray

    @classmethod
    def of(cls, corners: FloatArray) -> _Outline:
        """Outline of corners in any cyclic order."""
        angle = np.arctan2(corners[:, 1], corners[:, 0])
        order = np.argsort(angle)
        corners = corners[order]
        # np.roll takes as long as all else here
        along = np.concatenate([corners[1:], corners[:1]]) - corners
        return cls(corners, angle[order], along)

    def reach(self, rays: FloatArray) -> FloatArray:
        """(m,) distance from the origin to the outline in directions (m,) in radians from -pi to pi."""
        edge = np.searchsorted(self.angle, rays, side="right") - 1
        start, along = self.corners[edge], self.along[edge]
        across = start[:, 0] * along[:, 1] - start[:, 1] * along[:, 0]
        turn = np.cos(rays) * along[:, 1] - np.sin(rays) * along[:, 0]
        # the circle of a level leg is a line through the origin from above: a ray along it ends at its corner
        level = np.abs(turn) < 1e-12
        if not level.any():
            return np.asarray(across / turn)
        return np.where(level, np.linalg.norm(start, axis=1), across / np.where(level, 1.0, turn))


def _crossing(first: _Outline, second: _Outline, begin: float, end: float) -> FloatArray:
    """(2,) point between two directions, in radians, at which two outlines, straight in between, cross."""
    # just inside both directions, so that each outline is taken on the edge between them
    near = begin + (end - begin) * np.array([1e-6, 1 - 1e-6])
    near = np.arctan2(np.sin(near), np.cos(near))
    heading = np.column_stack([np.cos(near), np.sin(near)])
    a, b = (outline.reach(near)[:, None] * heading for outline in (first, second))
    step, other, apart = a[1] - a[0], b[1] - b[0], b[0] - a[0]
    gain = step[0] * other[1] - step[1] * other[0]
    share = (apart[0] * other[1] - apart[1] * other[0]) / gain if abs(gain) > 1e-15 else 0.5
    return np.asarray(a[0] + min(max(float(share), 0.0), 1.0) * step)
