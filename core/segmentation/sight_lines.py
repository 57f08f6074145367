"""Which patches of the units' legs the cloud should show, had the legs their whole length.

Where the sensor stood need not be known. Along each of many directions the cloud is looked at as a depth map: a patch is open to a
direction where the map holds points behind it and none before it, so that whoever looked along there looked through the patch, or at it. A
direction along which the sensor looked shows the patches that are open to it; how likely, is estimated by expectation maximisation of

    P(patch holds points) = 1 - product over directions (1 - s_d open_d)

(the noisy-or of Pearl, 1988, Probabilistic Reasoning in Intelligent Systems, 4.3.2) over the shafts of the unit and of its neighbours.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.kernels import kernel
from ..common.neighbourhood import Grid, build_grid, point_tree
from ..common.voxels import thin
from ..model.tetrapod import leg_frame, turn_around
from ..model.unit_types import UnitType

SECTORS, RINGS = 8, 9
FIRST, LAST = 0.30, 0.975
"""Shares of a leg between which its side is divided into patches: what joints and rounded tips leave."""
SHAFT_RINGS = 4
"""Rings, from the joint on, that breaks leave: they tell along which directions the sensor looked."""
DIRECTIONS = 320
"""Over the sphere, about seven degrees apart."""
LEAST_FACING = 0.5
"""Cosine between a patch's normal and a direction from which it is counted as seen: grazing rays show little."""
PIXEL_HEIGHTS = 0.05
PIXEL_SPACINGS = 2.0
"""Edge of the pixels of a depth map, in unit heights and in spacings of the thinned cloud, whichever is larger."""
MARGIN_PIXELS = 2.0
"""Depth within which points of a pixel belong to the patch itself: a surface turned by 60 degrees changes by 1.7 pixels."""
VOXEL_HEIGHTS = 0.03
CELL_HEIGHTS = 0.2
"""Edge of the cells in which the thinned cloud is looked up; points of one follow one another."""
AROUND_HEIGHTS = 3.0
"""Distance from a unit's centre within which points hide it, or lie behind it."""
POOLED_HEIGHTS = 2.0
POOLED_UNITS = 4
"""Units near enough to be looked at along the same directions."""
ON_SURFACE_HEIGHTS = 0.02
ON_SURFACE_NOISE = 3.5
LEAST_SHARE = 0.25
"""Share of the points of a typical patch that makes a patch seen: others are strays."""
LAST_SHAFT_RING = 3
"""Rings next to a break of which one must be seen."""
FIRST_TIP_RING = RINGS - 2
"""Ring from which nothing but tips is left, which may be rounded or cropped: a break begins before it."""
MOST_EXPECTED = 0.97
"""Probability beyond which no patch is expected: there are wet and dark places, and poses err."""
GOES_ON, AGAINST = 0.3, -2.3
"""Share of a sector's patches beyond a break that are seen where there is none, and the evidence of such a sector."""
GROUP = 32
"""Points that are asked together whether they fall into a map."""
STEPS = 30
PRIOR_MISSES = 3.0
"""Patches that a direction did not show, before looking: most directions show nothing."""


class LegPlaces(NamedTuple):
    """Where points lie by the legs of a unit: (n,) leg whose direction is nearest, distance along its axis and from it (metres), sector."""

    leg: IntArray
    axial: FloatArray
    rho: FloatArray
    sector: IntArray


def leg_places(body: FloatArray, unit: UnitType) -> LegPlaces:
    """Places of (n, 3) points in the body frame."""
    lean = body @ unit.leg_directions.T
    leg = np.argmax(lean, axis=1)
    axial = lean[np.arange(len(body)), leg]
    rho = np.sqrt(np.maximum(np.einsum("ij,ij->i", body, body) - axial**2, 0.0))
    sector = np.floor((turn_around(body, leg, unit) + math.pi) / (2 * math.pi) * SECTORS).astype(np.int64) % SECTORS
    return LegPlaces(leg, axial, rho, sector)


def ring_places() -> FloatArray:
    """(RINGS + 1,) shares of the leg at which rings end."""
    return np.linspace(FIRST, LAST, RINGS + 1)


class SightLines:
    """What the cloud shows and should show of the sides of the units' legs, looked at as it is asked for."""

    def __init__(self, points: FloatArray, grid: Grid, poses: FloatArray, unit: UnitType, noise: float) -> None:
        """Look at (n, 3) points of a cloud, metres, and the grid of them, with units of one type in (k, 12) poses, centres and row-major
        rotations.

        ``noise`` is the standard deviation of a point across the surface, metres.
        """
        self._points, self._raw, self._poses, self._unit = points, grid, poses, unit
        self._thinned, _ = thin(points, VOXEL_HEIGHTS * unit.height)
        self._grid = build_grid(self._thinned, CELL_HEIGHTS * unit.height)
        spacing = 0.0
        if len(self._thinned) > 1:
            some = self._thinned[:: max(1, len(self._thinned) // 2000)]
            spacing = float(np.median(point_tree(self._thinned).query(some, k=2)[0][:, 1]))
        self._pixel = max(PIXEL_HEIGHTS * unit.height, PIXEL_SPACINGS * spacing)
        self._tolerance = max(ON_SURFACE_HEIGHTS * unit.height, ON_SURFACE_NOISE * noise)
        self._pools = _pools(poses[:, :3], unit.height)
        self._opened: dict[tuple[int, bool], BoolArray] = {}
        self._shown: dict[int, BoolArray] = {}
        self._expected: dict[int, FloatArray] = {}

    def missing(self, number: int, leg: int, least: float) -> tuple[float, float]:
        """Evidence that a leg of a unit ends early (natural logarithm of odds) and the share of it that is left.

        Evidence below ``least`` may be told as 0: what should be seen is not asked where it cannot reach it.
        """
        seen = self._seen(number)[leg]
        if _missing(np.full(seen.shape, MOST_EXPECTED), seen)[0] < least:
            return 0.0, 1.0
        if number not in self._expected:
            own, *others = self._pools[number]
            shown = [self._seen(k)[shaft_patches()] for k in others]
            self._expected[number] = _expected(self.look(own), self._seen(own), [self.look_at_shafts(k) for k in others], shown)
        return _missing(self._expected[number][leg], seen)

    def _seen(self, number: int) -> BoolArray:
        if number not in self._shown:
            pose = self._poses[number]
            near = self._points[self._raw.within(pose[:3], self._unit.reach)] - pose[:3]
            self._shown[number] = _seen(near @ pose[3:].reshape(3, 3), self._unit, self._tolerance)
        return self._shown[number]

    def look(self, number: int) -> BoolArray:
        """(4 RINGS SECTORS, DIRECTIONS) which of all patches of a unit are open to which directions."""
        if (number, True) not in self._opened:
            self._opened[number, True] = self._open_of(number, np.ones(4 * RINGS * SECTORS, dtype=np.bool_))
        return self._opened[number, True]

    def look_at_shafts(self, number: int) -> BoolArray:
        """The same of the patches of its shafts alone, in the order of :func:`shaft_patches`: less of a map has to be filled."""
        if (number, False) not in self._opened:
            shafts = shaft_patches().ravel()
            known = self._opened.get((number, True))
            self._opened[number, False] = self._open_of(number, shafts) if known is None else known[shafts]
        return self._opened[number, False]

    def _open_of(self, number: int, chosen: BoolArray) -> BoolArray:
        pose = self._poses[number]
        rotation = pose[3:].reshape(3, 3)
        patches, normals = (places @ rotation.T for places in _patches(self._unit))
        around = self._thinned[self._grid.within(pose[:3], AROUND_HEIGHTS * self._unit.height)] - pose[:3]
        reach = float(np.sqrt(np.max(np.sum(patches**2, axis=1))))
        lengths = reach, self._pixel, MARGIN_PIXELS * self._pixel
        return np.asarray(_open(around, patches[chosen], normals[chosen], *_directions(), lengths, LEAST_FACING))


def _missing(expected: FloatArray, seen: BoolArray) -> tuple[float, float]:
    """Evidence that a leg ends early and the share of it that is left, from (RINGS, SECTORS) probabilities that its patches hold points if
    it is whole, and whether they do.

    The patches of a sector beyond a break lie in one another's shadow, so that all of them count as one.
    """
    expected = np.minimum(expected, MOST_EXPECTED)
    best, left = 0.0, 1.0
    for ring in range(LAST_SHAFT_RING, FIRST_TIP_RING):
        beyond = seen[ring:].mean(axis=0)
        gone = -np.log1p(-expected[ring:].mean(axis=0)) * np.where(beyond > 0, 0.5, 1.0)
        # a sector tells of a break where its shaft is seen up to it, and against one where it goes on
        upto = seen[ring - LAST_SHAFT_RING : ring].any(axis=0)
        evidence = float(np.where(beyond > GOES_ON, AGAINST, np.where(upto, gone, 0.0)).sum())
        if evidence > best:
            best, left = evidence, float(ring_places()[ring])
    return best, left


def _pools(centres: FloatArray, height: float) -> list[list[int]]:
    """Each unit, first, and those near it."""
    distance, near = cKDTree(centres).query(centres, k=min(POOLED_UNITS, len(centres)), distance_upper_bound=POOLED_HEIGHTS * height)
    pairs = zip(np.atleast_2d(distance.reshape(len(centres), -1)), np.atleast_2d(near.reshape(len(centres), -1)), strict=True)
    return [[k, *(int(j) for d, j in zip(ds, js, strict=True) if math.isfinite(d) and j != k)] for k, (ds, js) in enumerate(pairs)]


@lru_cache(maxsize=1)
def shaft_patches() -> BoolArray:
    """(4, RINGS, SECTORS) patches that breaks leave."""
    shaft = np.zeros((4, RINGS, SECTORS), dtype=np.bool_)
    shaft[:, :SHAFT_RINGS] = True
    return shaft


def _expected(opened: BoolArray, seen: BoolArray, others: Sequence[BoolArray], others_shown: Sequence[BoolArray]) -> FloatArray:
    """(4, RINGS, SECTORS) probability that the patches of a unit hold points if its legs are whole.

    Its patches are open to directions, (4 RINGS SECTORS, DIRECTIONS), and hold points or not, (4, RINGS, SECTORS); so are those of the
    shafts of the units near it, and do.
    """
    result = np.zeros((4, RINGS, SECTORS))
    for leg in range(4):
        # whether this leg is broken is not asked of itself
        asked = shaft_patches().copy()
        asked[np.arange(4) != leg] = True
        rows = np.concatenate([opened[asked.ravel()], *others])
        shown = np.concatenate([seen[asked], *others_shown])
        told = rows.any(axis=1)
        shares = _noisy_or(rows[told], shown[told])
        mine = opened.reshape(4, RINGS, SECTORS, -1)[leg]
        result[leg] = 1 - np.prod(1 - mine * shares, axis=-1)
    return result


@kernel()
def _noisy_or(opened: Any, shown: Any) -> Any:
    """(DIRECTIONS,) probabilities that a direction shows a patch that is open to it, from (n, DIRECTIONS) and (n,)."""
    patches, directions = opened.shape
    # few patches are open to a direction: the lists of those are gone through
    first, found = np.zeros(patches + 1, dtype=np.int64), np.empty(opened.size, dtype=np.int64)
    count = np.zeros(directions)
    for i in range(patches):
        first[i + 1] = first[i]
        for d in range(directions):
            if opened[i, d]:
                found[first[i + 1]] = d
                first[i + 1] += 1
                count[d] += 1.0
    shares, fired = np.empty(directions), np.empty(directions)
    for d in range(directions):
        shares[d] = 0.5 if count[d] > 0.0 else 0.0
    for _ in range(STEPS):
        fired[:] = 0.0
        for i in range(patches):
            if not shown[i]:
                continue
            missed = 1.0
            for k in range(first[i], first[i + 1]):
                missed *= 1.0 - shares[found[k]]
            weight = 1.0 / max(1.0 - missed, 1e-9)
            for k in range(first[i], first[i + 1]):
                fired[found[k]] += weight
        for d in range(directions):
            shares[d] = min(shares[d] * fired[d] / (count[d] + PRIOR_MISSES), 0.98)
    return shares


@lru_cache(maxsize=8)
def _patches(unit: UnitType) -> tuple[FloatArray, FloatArray]:
    """(4 RINGS SECTORS, 3) middles and outward normals of the patches, body frame."""
    first, second = leg_frame(unit)
    edges = ring_places()
    axial = 0.5 * (edges[1:] + edges[:-1]) * unit.leg_length
    turn = (np.arange(SECTORS) + 0.5) / SECTORS * 2 * math.pi - math.pi
    radial = first[:, None, None] * np.cos(turn)[:, None] + second[:, None, None] * np.sin(turn)[:, None]
    axis = unit.leg_directions[:, None, None, :]
    along = axial[:, None, None]
    middle = along * axis + (unit.radius - unit.gradient * along) * radial
    normal = (radial + unit.gradient * axis) / math.hypot(1, unit.gradient) + np.zeros_like(middle)
    return middle.reshape(-1, 3), normal.reshape(-1, 3)


def _seen(body: FloatArray, unit: UnitType, tolerance: float) -> BoolArray:
    """(4, RINGS, SECTORS) whether patches hold points of (n, 3) in the body frame."""
    leg, axial, rho, sector = leg_places(body, unit)
    ring = np.floor((axial / unit.leg_length - FIRST) / (LAST - FIRST) * RINGS).astype(np.int64)
    on = (np.abs(rho - (unit.radius - unit.gradient * axial)) < tolerance) & (ring >= 0) & (ring < RINGS)
    count = np.zeros((4, RINGS, SECTORS))
    np.add.at(count, (leg[on], ring[on], sector[on]), 1)
    typical = float(np.median(count[count > 0])) if count.any() else 0.0
    return np.asarray(count > LEAST_SHARE * typical)


@lru_cache(maxsize=1)
def _directions() -> tuple[FloatArray, FloatArray, FloatArray]:
    """(DIRECTIONS, 3) towards the sensor, evenly over the sphere (Fibonacci lattice), and two axes across each."""
    k = np.arange(DIRECTIONS) + 0.5
    height, turn = 1 - 2 * k / DIRECTIONS, math.pi * (1 + math.sqrt(5)) * k
    flat = np.sqrt(1 - height**2)
    towards = np.column_stack([flat * np.cos(turn), flat * np.sin(turn), height])
    other = np.where(np.abs(height)[:, None] > 0.9, [1.0, 0.0, 0.0], [0.0, 0.0, 1.0])
    across = np.cross(towards, other)
    across /= np.linalg.norm(across, axis=1)[:, None]
    return towards, across, np.cross(towards, across)


@kernel()
def _groups(points: Any) -> Any:
    """Middles (3, k) and radii of spheres around every ``GROUP`` points that follow one another."""
    count = (len(points) + GROUP - 1) // GROUP
    middles, radii = np.zeros((3, count)), np.zeros(count)
    for k in range(count):
        first, last = k * GROUP, min((k + 1) * GROUP, len(points))
        for a in range(3):
            for i in range(first, last):
                middles[a, k] += points[i, a] / (last - first)
        for i in range(first, last):
            x, y, z = points[i, 0] - middles[0, k], points[i, 1] - middles[1, k], points[i, 2] - middles[2, k]
            radii[k] = max(radii[k], np.sqrt(x * x + y * y + z * z))
    return middles, radii


@kernel()
def _open(points: Any, patches: Any, normals: Any, towards: Any, across: Any, upwards: Any, lengths: Any, facing: float) -> Any:
    """(m, d) whether patches are open to directions; points (n, 3) and patches (m, 3) relative to the unit's centre.

    The lengths, metres: how far a map reaches from the centre, the edge of its pixels, and the depth that belongs to a patch.
    Points that follow one another should be near one another: most groups of them fall beside a map.
    """
    reach, pixel, margin = lengths
    size = 2 * (int(reach / pixel) + 1)
    half = 0.5 * size * pixel
    # no farther out than the pixels of the patches
    asked = 0.0
    for i in range(len(patches)):
        asked = max(asked, np.sqrt(patches[i, 0] ** 2 + patches[i, 1] ** 2 + patches[i, 2] ** 2))
    asked = min(asked + pixel, half)
    result = np.zeros((len(patches), len(towards)), dtype=np.bool_)
    middles, radii = _groups(points)
    # a group's own block: numba asks of the sum of two indices whether it is negative, at every point
    blocks = np.zeros((len(radii), 3, GROUP))
    for i in range(len(points)):
        for a in range(3):
            blocks[i // GROUP, a, i % GROUP] = points[i, a]
    cell, near = np.empty(GROUP, dtype=np.int32), np.empty(GROUP)
    # what falls beside the map goes to one place more
    beside, depth = np.empty(len(radii)), np.empty(size * size + 1)
    for d in range(len(towards)):
        depth[:] = -np.inf
        # without branches, in vector registers: groups, and then the points of those that are near
        for k in range(len(radii)):
            u = middles[0, k] * across[d, 0] + middles[1, k] * across[d, 1] + middles[2, k] * across[d, 2]
            v = middles[0, k] * upwards[d, 0] + middles[1, k] * upwards[d, 1] + middles[2, k] * upwards[d, 2]
            beside[k] = max(abs(u), abs(v)) - radii[k]
        for k in range(len(radii)):
            if beside[k] > asked:
                continue
            for i in range(GROUP):
                x, y, z = blocks[k, 0, i], blocks[k, 1, i], blocks[k, 2, i]
                right = (x * across[d, 0] + y * across[d, 1] + z * across[d, 2] + half) / pixel
                up = (x * upwards[d, 0] + y * upwards[d, 1] + z * upwards[d, 2] + half) / pixel
                within = (right >= 0.0) & (up >= 0.0) & (right < size) & (up < size)
                cell[i] = np.int32(right) * np.int32(size) + np.int32(up) if within else size * size
                near[i] = x * towards[d, 0] + y * towards[d, 1] + z * towards[d, 2]
            for i in range(min(GROUP, len(points) - k * GROUP)):
                depth[cell[i]] = max(depth[cell[i]], near[i])
        for i in range(len(patches)):
            if normals[i, 0] * towards[d, 0] + normals[i, 1] * towards[d, 1] + normals[i, 2] * towards[d, 2] < facing:
                continue
            a = int((patches[i, 0] * across[d, 0] + patches[i, 1] * across[d, 1] + patches[i, 2] * across[d, 2] + half) / pixel)
            b = int((patches[i, 0] * upwards[d, 0] + patches[i, 1] * upwards[d, 1] + patches[i, 2] * upwards[d, 2] + half) / pixel)
            z = patches[i, 0] * towards[d, 0] + patches[i, 1] * towards[d, 1] + patches[i, 2] * towards[d, 2]
            result[i, d] = -np.inf < depth[a * size + b] < z + margin
    return result
