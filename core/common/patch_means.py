"""Means of small patches of a cloud, formed while it goes by in parts, with how far the points of each are strewn.

A point that comes farther than a radius from the seeds of all patches is the seed of a new one, any other belongs to the nearest seed
(leader clustering; Hartigan, 1975, Clustering Algorithms, ch. 3). Borders between seeds on a surface stand across it, so that noise does
not decide to which patch a point goes. The faces of voxels run along the surface in places and part points above it from those below:
their means were noisier than those of the same number of points by a tenth to a third. Every mean stands for nearly the same number of
points, so that whoever weighs means equally weighs the points equally.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple, cast

import numpy as np
from numba import njit
from numpy.typing import NDArray

from .arrays import BoolArray, FloatArray
from .kernels import COMPILED, kernel

SOME = 8
"""Points that are summed before a further sum is begun for the same patch."""
MEANS_PER_PATCH = 2
"""Means of a patch of the usual number of points: patches of other numbers have more or fewer, to half a mean."""
FEW = 0.25
"""A patch with less than this share of the points of its fullest neighbour is left out: what is between a surface and a stray point, or was
left over between other patches, and noisier than others."""
FEWEST_FOR_NOISE = 50
"""Patches that tell of the noise."""
SEED = np.dtype([("e", np.float64), ("n", np.float64), ("h", np.float64), ("before", np.int32), ("source", np.uint16)], align=True)
"""Of a patch: its seed in metres, the earlier patch of the same voxel or -1, and the source of its points; half a line of the processor's
cache, as most of the time goes into waiting for these."""
_FEWEST_ROWS = 1 << 15
_MOST_EXPECTED = 10_000_000
"""Points up to which room is made before they come: some 250 MB."""
_PATCHES, _VOXELS, _SUMS = range(3)


class Patches(NamedTuple):
    """Patches and sums under way; rows beyond the numbers in use mean nothing.

    Attributes
    ----------
    used
        (3,) patches, voxels and finished sums in use.
    slots
        Hash table of a power of two: row of a voxel, or -1.
    voxels
        (v, 4) whole numbers: place of a voxel, whose edge is two radii, along three axes; and its latest patch.
    seeds
        (p,) ``SEED``.
    open
        (p, 10) number of the points of the sum under way; sums of their coordinates from the seed; of their products xx, xy, xz, yy, yz,
        zz.
    since
        (p,) earliest time of these.
    steady
        (p,) seeds that were put into the mean of their first points.
    done, owner, times
        (s, 10) finished sums like ``open``, (s,) their patches, and (s,) earliest times.
    """

    used: NDArray[np.int64]
    slots: NDArray[np.int32]
    voxels: NDArray[np.int32]
    seeds: NDArray[np.void]
    open: FloatArray
    since: FloatArray
    steady: BoolArray
    done: NDArray[np.float32]
    owner: NDArray[np.int32]
    times: FloatArray


@dataclass(frozen=True, eq=False, kw_only=True)
class Means:
    """Means of m groups of points.

    Attributes
    ----------
    xyz
        (m, 3) metres.
    counts
        (m,) points of each.
    spread
        (m,) variance of the points along the surface, mean of its two directions, square metres: what is beyond their variance across it.
    sources
        (m,) source of the points.
    times
        (m,) earliest time of the points.
    """

    xyz: FloatArray
    counts: NDArray[np.int32]
    spread: FloatArray
    sources: NDArray[np.uint16]
    times: FloatArray


class _Sums(NamedTuple):
    """Sums of some of the points of patches, in the order of the patches: like ``done``, ``owner`` and ``times`` of :class:`Patches`."""

    table: NDArray[np.float32]
    owner: NDArray[np.int32]
    times: FloatArray


class PatchMeans:
    """Patches of a cloud to which part after part is added.

    Parameters
    ----------
    radius
        Farthest that a point lies from the seed of its patch, metres.
    expected
        Points that will be added, about: room is made once for patches of twice ``SOME`` points, and else as it is needed.
    """

    def __init__(self, radius: float, expected: int = 0) -> None:
        self.radius = radius
        expected = min(expected, _MOST_EXPECTED)
        self._patches = _empty(_room(expected // (2 * SOME)), _room(expected // SOME))

    @property
    def count(self) -> int:
        """Patches so far."""
        return int(self._patches.used[_PATCHES])

    def add(self, xyz: FloatArray, sources: NDArray[np.uint16], times: FloatArray) -> None:
        """Add (n, 3) points with their sources and times (n,)."""
        used = self._patches.used
        rows, sums = int(used[_PATCHES]) + len(xyz), int(used[_SUMS]) + len(xyz) // SOME + self.count
        if rows > len(self._patches.seeds) or sums > len(self._patches.done):
            larger = _empty(_room(rows), _room(sums))
            for name, old in self._patches._asdict().items():
                if name != "slots":
                    getattr(larger, name)[: len(old)] = old[: len(getattr(larger, name))]
            _find_slots(larger)
            self._patches = larger
        _add(np.ascontiguousarray(xyz), sources, times, self.radius, self._patches)

    def noise(self) -> float:
        """Standard deviation of the points across the surface, metres, from patches of at least ``SOME`` points; 0 where there are few."""
        sums = self._sums()
        points = np.bincount(sums.owner, weights=sums.table[:, 0], minlength=self.count).astype(np.float64)
        *_, across = self._formed(sums, points, np.ones(self.count))
        full = points >= SOME
        # a plane takes its share of the variance
        variance = across[full] * points[full] / (points[full] - 3.0)
        return float(np.sqrt(max(np.median(variance), 0.0))) if np.count_nonzero(full) >= FEWEST_FOR_NOISE else 0.0

    def means(self) -> Means:
        """What was added; every mean stands for nearly the same number of points."""
        sums = self._sums()
        points = np.bincount(sums.owner, weights=sums.table[:, 0], minlength=self.count).astype(np.float64)
        enough = _enough(self._patches, points, self.radius)[sums.owner]
        sums = _Sums(sums.table[enough], sums.owner[enough], sums.times[enough])
        usual = max(float(np.average(points, weights=points)) / MEANS_PER_PATCH, 1.5 * SOME) if self.count else 1.0
        xyz, counts, spread, earliest, patch, _ = self._formed(sums, points, np.maximum(np.rint(points / usual), 1.0))
        return Means(xyz=xyz, counts=counts, spread=spread, sources=self._patches.seeds["source"][patch], times=earliest)

    def _sums(self) -> _Sums:
        """All sums, those under way too, in the order of their patches."""
        patches, count, finished = self._patches, self.count, int(self._patches.used[_SUMS])
        left = patches.open[:count, 0] > 0
        table = np.concatenate([patches.done[:finished], patches.open[:count][left].astype(np.float32)])
        owner = np.concatenate([patches.owner[:finished], np.flatnonzero(left).astype(np.int32)])
        times = np.concatenate([patches.times[:finished], patches.since[:count][left]])
        order = np.argsort(owner, kind="stable")
        return _Sums(table[order], owner[order], times[order])

    def _formed(self, sums: _Sums, points: FloatArray, wanted: FloatArray) -> tuple[Any, ...]:
        """What :func:`_means` makes of sums, as many means of each patch as are wanted."""
        mean_of = _shared_out(sums.table[:, 0], sums.owner, points, wanted)
        return cast("tuple[Any, ...]", _means(sums, mean_of, self._patches.seeds))


def _room(rows: int) -> int:
    return 1 << math.ceil(math.log2(max(rows, _FEWEST_ROWS)))


def _empty(rows: int, sums: int) -> Patches:
    return Patches(
        used=np.zeros(3, dtype=np.int64),
        slots=np.full(2 * rows, -1, dtype=np.int32),
        voxels=np.empty((rows, 4), dtype=np.int32),
        seeds=np.empty(rows, dtype=SEED),
        open=np.empty((rows, 10)),
        since=np.empty(rows),
        steady=np.empty(rows, dtype=np.bool_),
        done=np.empty((sums, 10), dtype=np.float32),
        owner=np.empty(sums, dtype=np.int32),
        times=np.empty(sums),
    )


@njit(**COMPILED | {"inline": "always"})
def _slot(slots, voxels, x, y, z):  # type: ignore[no-untyped-def]
    """Where a voxel stands in the hash table, or would."""
    mask = len(slots) - 1
    mixed = (x * 73856093) ^ (y * 19349663) ^ (z * 83492791)
    place = (mixed ^ (mixed >> 15)) & mask
    while slots[place] >= 0:
        k = slots[place]
        if voxels[k, 0] == x and voxels[k, 1] == y and voxels[k, 2] == z:
            break
        place = (place + 1) & mask
    return place


@kernel()
def _find_slots(patches: Any) -> None:
    """Enter all voxels into an empty hash table."""
    voxels = patches.voxels
    for k in range(patches.used[_VOXELS]):
        x, y, z = np.int64(voxels[k, 0]), np.int64(voxels[k, 1]), np.int64(voxels[k, 2])
        patches.slots[_slot(patches.slots, voxels, x, y, z)] = k


@njit(**COMPILED | {"inline": "always"})
def _nearest_patch(px, py, pz, source, radius, patches):  # type: ignore[no-untyped-def]
    """Patch of a source with the seed nearest to a point, or -1 where all are farther than the radius."""
    edge = 2.0 * radius
    x, y, z = math.floor(px / edge), math.floor(py / edge), math.floor(pz / edge)
    # of the eight voxels that the radius reaches, those that may hold a seed nearer than the best so far, its own first
    fx, fy, fz = px - x * edge, py - y * edge, pz - z * edge
    sx, sy, sz = (1 if fx > radius else -1), (1 if fy > radius else -1), (1 if fz > radius else -1)
    fx, fy, fz = min(fx, edge - fx), min(fy, edge - fy), min(fz, edge - fz)
    best, nearest = -1, radius * radius
    for h in range(8):
        ox, oy, oz = h >> 2, h >> 1 & 1, h & 1
        if ox * fx * fx + oy * fy * fy + oz * fz * fz > nearest:
            continue
        row = patches.slots[_slot(patches.slots, patches.voxels, x + ox * sx, y + oy * sy, z + oz * sz)]
        if row < 0:
            continue
        k = patches.voxels[row, 3]
        while k >= 0:
            seed = patches.seeds[k]
            dx, dy, dz = px - seed.e, py - seed.n, pz - seed.h
            square = dx * dx + dy * dy + dz * dz
            if square < nearest and seed.source == source:
                best, nearest = k, square
            k = seed.before
    return best


@kernel(releases=True)
def _add(points: Any, sources: Any, times: Any, radius: Any, patches: Any) -> None:
    """Add points to their patches."""
    used, sums, since = patches.used, patches.open, patches.since
    for i in range(len(points)):
        px, py, pz = points[i, 0], points[i, 1], points[i, 2]
        k = _nearest_patch(px, py, pz, sources[i], radius, patches)
        if k < 0:
            k = used[_PATCHES]
            used[_PATCHES] += 1
            x, y, z = math.floor(px * 0.5 / radius), math.floor(py * 0.5 / radius), math.floor(pz * 0.5 / radius)
            place = _slot(patches.slots, patches.voxels, x, y, z)
            row = patches.slots[place]
            if row < 0:
                row = used[_VOXELS]
                used[_VOXELS] += 1
                patches.slots[place] = row
                patches.voxels[row, 0], patches.voxels[row, 1], patches.voxels[row, 2], patches.voxels[row, 3] = x, y, z, -1
            new = patches.seeds[k]
            new.e, new.n, new.h, new.source, new.before = px, py, pz, sources[i], patches.voxels[row, 3]
            patches.voxels[row, 3] = k
            sums[k], patches.steady[k] = 0.0, False
        seed = patches.seeds[k]
        dx, dy, dz = px - seed.e, py - seed.n, pz - seed.h
        since[k] = times[i] if sums[k, 0] == 0.0 else min(since[k], times[i])
        sums[k, 0] += 1.0
        sums[k, 1] += dx
        sums[k, 2] += dy
        sums[k, 3] += dz
        sums[k, 4] += dx * dx
        sums[k, 5] += dx * dy
        sums[k, 6] += dx * dz
        sums[k, 7] += dy * dy
        sums[k, 8] += dy * dz
        sums[k, 9] += dz * dz
        if sums[k, 0] == SOME:
            if not patches.steady[k]:
                _move_seed(seed, sums, k, 2.0 * radius)
                patches.steady[k] = True
            last = used[_SUMS]
            used[_SUMS] += 1
            patches.owner[last], patches.times[last] = k, since[k]
            for a in range(10):
                patches.done[last, a] = sums[k, a]
                sums[k, a] = 0.0


@njit(**COMPILED | {"inline": "always"})
def _move_seed(seed, sums, k, edge):  # type: ignore[no-untyped-def]
    """Put a seed into the mean of its first points, whose noise is less, as far as its voxel goes; their sums are then from there."""
    c, m0, m1, m2 = sums[k, 0], sums[k, 1], sums[k, 2], sums[k, 3]
    d0, d1, d2 = _step(seed.e, m0 / c, edge), _step(seed.n, m1 / c, edge), _step(seed.h, m2 / c, edge)
    seed.e += d0
    seed.n += d1
    seed.h += d2
    sums[k, 1] -= c * d0
    sums[k, 2] -= c * d1
    sums[k, 3] -= c * d2
    sums[k, 4] += c * d0 * d0 - 2.0 * d0 * m0
    sums[k, 5] += c * d0 * d1 - d0 * m1 - d1 * m0
    sums[k, 6] += c * d0 * d2 - d0 * m2 - d2 * m0
    sums[k, 7] += c * d1 * d1 - 2.0 * d1 * m1
    sums[k, 8] += c * d1 * d2 - d1 * m2 - d2 * m1
    sums[k, 9] += c * d2 * d2 - 2.0 * d2 * m2


@njit(**COMPILED | {"inline": "always"})
def _step(place, wanted, edge):  # type: ignore[no-untyped-def]
    """A step along one axis, shortened where it would leave the voxel."""
    low = math.floor(place / edge) * edge
    return min(max(place + wanted, low), low + (1.0 - 1e-9) * edge) - place


@kernel()
def _enough(patches: Any, points: Any, radius: Any) -> Any:
    """(p,) patches that do not have far fewer points than another of their source whose seed is within two radii."""
    seeds = patches.seeds
    enough = np.ones(len(points), dtype=np.bool_)
    per_edge = 0.5 / radius
    for k in range(len(points)):
        one = seeds[k]
        x, y, z = math.floor(one.e * per_edge), math.floor(one.n * per_edge), math.floor(one.h * per_edge)
        for h in range(27):
            row = patches.slots[_slot(patches.slots, patches.voxels, x + h // 9 - 1, y + h // 3 % 3 - 1, z + h % 3 - 1)]
            j = patches.voxels[row, 3] if row >= 0 else -1
            while j >= 0:
                other = seeds[j]
                dx, dy, dz = one.e - other.e, one.n - other.n, one.h - other.h
                near = dx * dx + dy * dy + dz * dz < 4.0 * radius * radius
                if near and other.source == one.source and points[k] < FEW * points[j]:
                    enough[k] = False
                j = other.before
    return enough


@kernel()
def _shared_out(counts: Any, owner: Any, points: Any, wanted: Any) -> Any:
    """(s,) number of the mean that each sum goes into, of sums in the order of their patches: as many means of each patch as are wanted."""
    mean_of = np.empty(len(owner), dtype=np.int64)
    made = -1
    before = 0.0
    for i in range(len(owner)):
        k = owner[i]
        if i == 0 or owner[i - 1] != k:
            before, place = 0.0, -1
        own = int((before + 0.5 * counts[i]) / points[k] * wanted[k])
        before += counts[i]
        made += own > place
        place = own
        mean_of[i] = made
    return mean_of


@kernel()
def _means(sums: Any, mean_of: Any, seeds: Any) -> Any:
    """Mean, number, spread along the surface, earliest time, patch, and variance across the surface of the points of every mean."""
    table, owner, times = sums
    m = mean_of[-1] + 1 if len(mean_of) else 0
    xyz, counts, spread, across = np.empty((m, 3)), np.empty(m, dtype=np.int32), np.empty(m), np.empty(m)
    earliest, patch = np.empty(m), np.empty(m, dtype=np.int64)
    total = np.zeros(10)
    for i in range(len(owner)):
        k, j = owner[i], mean_of[i]
        if i == 0 or mean_of[i - 1] != j:
            total[:] = 0.0
            earliest[j], patch[j] = times[i], k
        earliest[j] = min(earliest[j], times[i])
        for a in range(10):
            total[a] += table[i, a]
        if i + 1 < len(owner) and mean_of[i + 1] == j:
            continue
        c = total[0]
        m0, m1, m2 = total[1] / c, total[2] / c, total[3] / c
        counts[j] = int(c)
        xyz[j, 0], xyz[j, 1], xyz[j, 2] = seeds[k].e + m0, seeds[k].n + m1, seeds[k].h + m2
        xx, xy, xz = total[4] / c - m0 * m0, total[5] / c - m0 * m1, total[6] / c - m0 * m2
        yy, yz, zz = total[7] / c - m1 * m1, total[8] / c - m1 * m2, total[9] / c - m2 * m2
        across[j] = _smallest_variance(xx, xy, xz, yy, yz, zz)
        spread[j] = max(0.5 * (xx + yy + zz - 3.0 * across[j]), 0.0)
    return xyz, counts, spread, earliest, patch, across


@njit(**COMPILED | {"inline": "always"})
def _smallest_variance(xx, xy, xz, yy, yz, zz):  # type: ignore[no-untyped-def]
    """Smallest eigenvalue of a symmetric (3, 3) matrix, in closed form (Smith, 1961)."""
    mean = (xx + yy + zz) / 3.0
    dx, dy, dz = xx - mean, yy - mean, zz - mean
    squares = (dx * dx + dy * dy + dz * dz + 2.0 * (xy * xy + xz * xz + yz * yz)) / 6.0
    if squares <= 0.0:
        return mean
    size = math.sqrt(squares)
    determinant = dx * (dy * dz - yz * yz) - xy * (xy * dz - yz * xz) + xz * (xy * yz - dy * xz)
    angle = math.acos(min(max(0.5 * determinant / (squares * size), -1.0), 1.0)) / 3.0
    return mean + 2.0 * size * math.cos(angle + 2.0 * math.pi / 3.0)
