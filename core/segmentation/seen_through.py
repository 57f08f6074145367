"""Rays that pass through where the end of a leg should be.

The beam of every point was free from the sensor to the point. Where points of one strip or station lie behind the end of a leg, as seen
from the sensor, the end is not there. Where the sensor stood is told by the units themselves: no beam of the source may enter what surely
stands, the shafts of the legs, which breaks leave, and the legs that were seen to be whole. Places from which hardly more beams would
enter than from the best are weighed by how many do, those between the places tried with them, and the evidence is the ratio of two
likelihoods: of what all places say if the end is missing, and if beams through it are as rare as those through what stands. An end is
missed only if the beams that pass through its place cannot have come from another one.
Sources that mix many places, as clouds of images do, have no such place and say nothing.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from scipy.special import logsumexp

from ..common.arrays import BoolArray, FloatArray
from ..common.kernels import kernel
from ..common.neighbourhood import build_grid
from ..common.voxels import thin
from ..model.unit_types import UnitType

STANDING = 0.6
"""Share of a leg that breaks leave."""
ROUNDED = 0.95
"""Share of a whole leg that rounded tips leave."""
AROUND_HEIGHTS = 2.0
"""Distance from a unit's centre within which points are what lies behind it, and units stand in the way."""
VOXEL_HEIGHTS = 0.03
CELL_HEIGHTS = 0.5
"""Edge of the cells in which a source's points are looked up."""
DISTANCES_HEIGHTS = (2.5, 4.0, 7.0, 25.0)
"""Distances of a sensor from a unit that are tried: from a station on the wall beside it to a flight."""
NEARER = 0.85
"""Factor by which a place nearer or farther than a tried one is tried too."""
DIRECTIONS = 320
"""Over the sphere, eleven degrees apart."""
ROUNDS = ((150, 0.33, 0.12, 4.0), (500, 0.5, 0.02, 1.5), (1000, 1.0, 0.008, 0.0))
"""Points of a source whose beams are asked, from which share of all, the nearest (the unit shapes what lies about it, what lies beyond
tells finer); share of them that may enter what stands (the places tried are some degrees off; then strays, mixed pixels and what poses
err), and how many degrees beside the places that are left the next ones are tried."""
FINEST_DEG = 1.5
"""Spacing of the places that were tried last: those around the ones that are left are kept with them."""
STRAYS = 0.005
"""Share of beams that enter what stands from the very place of the sensor, in a clean cloud."""
BEAM_COST = 0.5
"""Log-likelihood that one beam through a solid takes away from a place of the sensor: beams beside each other err together, by a pose or by
growth. On 700 whole legs of simulated surveys whose ends do not show 99 % have less than 0.5 of evidence for a break."""
LEAST_LIKELY = 12.0
"""Log-likelihood below that of the best place from which a place no longer counts."""
MOST_BEAMS = 80
"""Beams through the place of an end beyond which more say no more."""
FEWEST_POINTS = 150
GOLDEN = 0.618034
"""Fractional part of the golden section: multiples of it fall evenly."""
TRIED_AT_ONCE = 8
"""Places from neighbours that are tried before it is seen whether one of them will do."""
NEIGHBOURS = 3
"""Units whose sensors' places are tried first."""
MOST_PLACES = 300
"""Places beyond which a source does not tell where it stood: too few of its beams pass by what stands."""
MARGIN_HEIGHTS = 0.02
"""By which a solid is thinner than nominal, as moulds, poses and points err."""
MARGIN_IN_NOISE = 1.5
CHORD_HEIGHTS = 0.05
"""Length inside a solid from which a beam enters it."""


class Passing(NamedTuple):
    """Beams through the place of an end: log-likelihood ratio of its being missing, and where along the leg they come nearest to the centre
    (metres): it breaks before."""

    evidence: float
    place: float


class _Stands(NamedTuple):
    """(m, 3) places at which a sensor may have stood, from a unit's centre, and (m,) their log-likelihoods less that of the best one."""

    places: FloatArray
    likelihoods: FloatArray


class _Around(NamedTuple):
    """(n, 3) points of a source about a unit, from its centre, and the same in the order of their distance from it."""

    points: FloatArray
    nearest: FloatArray


class _Source:
    """Points of one strip or station, and the places it was found to have stood at."""

    def __init__(self, points: FloatArray, cell: float) -> None:
        self.points, self._grid = points, build_grid(points, cell)
        self._seen_from: list[tuple[FloatArray, FloatArray]] = []

    def around(self, centre: FloatArray, reach: float) -> _Around:
        """Points within reach of a place, from there."""
        own = self.points[self._grid.within(centre, reach)] - centre
        return _Around(own, nearest_first(own))

    def keep(self, centre: FloatArray, stands: FloatArray) -> None:
        """Remember places, from a unit's centre, from which hardly a beam enters what stands around it."""
        self._seen_from.append((centre, stands + centre))

    def stood(self, centre: FloatArray) -> FloatArray:
        """(m, 3) places remembered of the units next to a centre, from there; the nearest unit's come first."""
        away = [float(np.sum((own - centre) ** 2)) for own, _ in self._seen_from]
        return np.vstack([np.empty((0, 3)), *(self._seen_from[k][1] for k in np.argsort(away, kind="stable")[:NEIGHBOURS])]) - centre


class SeenThrough:
    """Beams through the legs of the units of one cloud."""

    def __init__(
        self, points: FloatArray, sources: NDArray[Any], poses: FloatArray, whole: BoolArray, unit: UnitType, noise: float
    ) -> None:
        """Look at (n, 3) points of a cloud, metres, and the (n,) strips or stations they come from, with units of one type.

        ``poses`` are (k, 12) centres and row-major rotations, ``whole`` (k, 4) legs that are known to be whole, and ``noise`` the standard
        deviation of a point across the surface, metres.
        """
        self._unit, self._poses = unit, poses
        voxel, cell = VOXEL_HEIGHTS * unit.height, CELL_HEIGHTS * unit.height
        self._sources = [_Source(thin(points[sources == source], voxel)[0], cell) for source in np.unique(sources)]
        self._margin = max(MARGIN_HEIGHTS * unit.height, MARGIN_IN_NOISE * noise)
        self._lasts = np.where(whole, ROUNDED, STANDING) * unit.leg_length
        self._axes = np.einsum("kij,lj->kli", poses[:, 3:].reshape(-1, 3, 3), unit.leg_directions)
        self._centres = cKDTree(poses[:, :3])
        self._known: dict[tuple[int, int], _Stands] = {}
        self._around: tuple[int, list[_Around]] = -1, []

    def through(self, number: int, leg: int, first: float) -> Passing:
        """Beams that pass through a unit's leg between ``first`` (metres along it) and its end."""
        end = self._axes[number, leg], first, ROUNDED * self._unit.leg_length
        centre, reach = self._poses[number, :3], AROUND_HEIGHTS * self._unit.height
        near = self._centres.query_ball_point(centre, reach)
        solids = self._poses[near, :3] - centre, self._axes[near], self._lasts[near]
        evidence, places = 0.0, [np.empty(0)]
        if self._around[0] != number:
            # the legs of a unit are asked about one after the other
            self._around = number, [source.around(centre, reach) for source in self._sources]
        for k, (source, own) in enumerate(zip(self._sources, self._around[1], strict=True)):
            if len(own.points) < FEWEST_POINTS:
                continue
            if (number, k) not in self._known:
                # where no beam passes from one place that the sensor may have stood at, the others need not be known
                if self._none_passes(own, source.stood(centre), solids, end):
                    continue
                self._known[number, k] = self._stands(own, solids, source, centre)
            stands = self._known[number, k]
            if len(stands.places):
                count, along = _passing(own.points, stands.places, *end, *self._cone(), MOST_BEAMS)
                whole = stands.likelihoods - BEAM_COST * count
                evidence += float(logsumexp(stands.likelihoods) - logsumexp(whole))
                likeliest = int(np.where(count > 0, whole, -np.inf).argmax())
                places.append(along[likeliest, : count[likeliest]])
        passed = np.concatenate(places)
        return Passing(evidence, float(np.quantile(passed, 0.02)) if len(passed) else 0.0)

    def _cone(self) -> tuple[float, float, float]:
        return self._unit.radius - self._margin, self._unit.gradient, CHORD_HEIGHTS * self._unit.height

    def _none_passes(
        self,
        own: _Around,
        stands: FloatArray,
        solids: tuple[FloatArray, FloatArray, FloatArray],
        end: tuple[FloatArray, float, float],
    ) -> bool:
        """Whether the sensor stood as likely as anywhere at one of (m, 3) places from which no beam passes through the end of a leg."""
        some = _spread(own.nearest, ROUNDS[-1][0])
        most = int(STRAYS * len(some))
        for first in range(0, len(stands), TRIED_AT_ONCE):
            tried = stands[first : first + TRIED_AT_ONCE]
            tried = tried[_passing(own.points, tried, *end, *self._cone(), 1)[0] == 0]
            if (_entered(some, tried, *solids, self._unit.reach, *self._cone(), most, True) <= most).any():
                return True
        return False

    def _stands(self, own: _Around, solids: tuple[FloatArray, FloatArray, FloatArray], source: _Source, centre: FloatArray) -> _Stands:
        """Places from which the beams of points enter no solid, but for a few; the source remembers them."""
        height, reach = self._unit.height, self._unit.reach
        none = _Stands(np.empty((0, 3)), np.empty(0))
        tried = (_directions()[:, None, :] * (np.array(DISTANCES_HEIGHTS) * height)[:, None]).reshape(-1, 3)
        nearest = own.nearest
        for count, part, share, step in ROUNDS:
            some = _spread(nearest[: max(int(part * len(nearest)), FEWEST_POINTS)], count)
            most = int(share * len(some))
            entered = _entered(some, tried, *solids, reach, *self._cone(), most, False)
            tried = tried[entered <= most]
            if len(tried) > MOST_PLACES or not len(tried):
                return none
            if step > 0:
                tried = _beside(tried, step)
        source.keep(centre, tried)
        # the sensor may stand between the places tried
        tried, cost = _beside(tried, FINEST_DEG), BEAM_COST * len(nearest) / len(some)
        most = min(most, int(entered.min() + LEAST_LIKELY / cost))
        entered = _entered(some, tried, *solids, reach, *self._cone(), most, False)
        likelihoods = cost * (entered.min() - entered)
        likely = (entered <= most) & (likelihoods > -LEAST_LIKELY)
        return _Stands(tried[likely], likelihoods[likely])


def nearest_first(points: FloatArray) -> FloatArray:
    """(n, 3) points in the order of their distance from the origin, those equally far in their own."""
    squares = np.einsum("ij,ij->i", points, points)
    # in half the time of a stable order, which differs where two points are equally far
    order = np.argsort(squares)
    ranked = squares[order]
    if (ranked[1:] == ranked[:-1]).any():
        order = np.argsort(squares, kind="stable")
    return np.asarray(points[order])


def _spread(points: FloatArray, count: int) -> FloatArray:
    """At most so many of (n, 3) points, evenly in their order but not in the order itself: beams of all are asked early."""
    chosen = points[np.linspace(0, len(points) - 1, min(count, len(points))).astype(np.int64)]
    return np.ascontiguousarray(chosen[np.argsort(np.arange(len(chosen)) * GOLDEN % 1.0)])


def _beside(stands: FloatArray, step: float) -> FloatArray:
    """(k, 3) of (n, 3) places, one nearer, one farther, and six around in directions that differ by ``step`` degrees; each but once."""
    length = np.linalg.norm(stands, axis=1)[:, None]
    towards = stands / length
    first = np.cross(towards, np.where(np.abs(towards[:, :1]) < 0.9, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]))
    first /= np.linalg.norm(first, axis=1)[:, None]
    second = np.cross(towards, first)
    ring = math.tan(math.radians(step)) * length
    turns = [(math.cos(k * math.pi / 3), math.sin(k * math.pi / 3)) for k in range(6)]
    places = np.vstack([stands, NEARER * stands, stands / NEARER, *(stands + ring * (c * first + s * second) for c, s in turns)])
    length = np.linalg.norm(places, axis=1)[:, None]
    keys = np.hstack([places / length / (0.7 * math.radians(step)), np.log(length) / -math.log(NEARER)])
    return np.asarray(places[np.sort(np.unique(np.round(keys), axis=0, return_index=True)[1])])


@lru_cache(maxsize=1)
def _directions() -> FloatArray:
    """(DIRECTIONS, 3) evenly over the sphere (Fibonacci lattice)."""
    k = np.arange(DIRECTIONS) + 0.5
    height, turn = 1 - 2 * k / DIRECTIONS, math.pi * (1 + math.sqrt(5)) * k
    flat = np.sqrt(1 - height**2)
    return np.column_stack([flat * np.cos(turn), flat * np.sin(turn), height])


@kernel()
def _inside(point: Any, beam: Any, axis: Any, first: float, last: float, radius: float, gradient: float) -> Any:
    """Length of a beam from a point inside a frustum about an axis, and the place along the axis of the part nearest to the centre."""
    px, py, pz = point
    bx, by, bz = beam
    axial = px * axis[0] + py * axis[1] + pz * axis[2]
    lean = bx * axis[0] + by * axis[1] + bz * axis[2]
    # |x|^2 - axial^2 <= (radius - gradient axial)^2 along the beam
    thick = radius - gradient * axial
    a = 1.0 - lean * lean * (1.0 + gradient * gradient)
    b = px * bx + py * by + pz * bz - axial * lean + thick * gradient * lean
    c = px * px + py * py + pz * pz - axial * axial - thick * thick
    root = b * b - a * c
    if root <= 0.0 or abs(a) < 1e-9:
        return 0.0, 0.0
    root = np.sqrt(root)
    low, high = (-b - root) / a, (-b + root) / a
    if a < 0.0:
        # nearly along the axis: inside the cone before its apex
        one, two = min(low, high), max(low, high)
        low, high = (-1e300, one) if lean > 0.0 else (two, 1e300)
    if abs(lean) > 1e-9:
        one, two = (first - axial) / lean, (last - axial) / lean
        low, high = max(low, min(one, two)), min(high, max(one, two))
    elif axial < first or axial > last:
        return 0.0, 0.0
    low = max(low, 0.0)
    if high <= low:
        return 0.0, 0.0
    return high - low, min(axial + lean * low, axial + lean * high)


@kernel()
def _passing(
    points: Any, stands: Any, axis: Any, first: float, last: float, radius: float, gradient: float, chord: float, most: int
) -> Any:
    """(m,) beams of points towards each stand that pass through a leg of the unit in the middle, up to ``most``, and (m, most) where along
    the leg."""
    counts, places = np.zeros(len(stands), dtype=np.int64), np.empty((len(stands), most))
    middle, wide = 0.5 * (first + last), radius - gradient * first
    round_end = wide * wide + 0.25 * (last - first) ** 2
    for k in range(len(stands)):
        for i in range(len(points)):
            bx, by, bz = stands[k, 0] - points[i, 0], stands[k, 1] - points[i, 1], stands[k, 2] - points[i, 2]
            mx, my, mz = middle * axis[0] - points[i, 0], middle * axis[1] - points[i, 1], middle * axis[2] - points[i, 2]
            square = bx * bx + by * by + bz * bz
            along, apart = mx * bx + my * by + mz * bz, mx * mx + my * my + mz * mz
            # the end lies in a ball that most beams miss
            if apart > round_end and (along < 0.0 or apart * square - along * along > round_end * square):
                continue
            length = np.sqrt(square)
            point, beam = (points[i, 0], points[i, 1], points[i, 2]), (bx / length, by / length, bz / length)
            inside, place = _inside(point, beam, axis, first, last, radius, gradient)
            if inside > chord:
                places[k, counts[k]] = place
                counts[k] += 1
                if counts[k] >= most:
                    break
    return counts, places


@kernel()
def _entered(
    points: Any,
    stands: Any,
    centres: Any,
    axes: Any,
    lasts: Any,
    reach: float,
    radius: float,
    gradient: float,
    chord: float,
    most: int,
    one: bool,
) -> Any:
    """(m,) how many beams of points towards a stand enter the legs of units about (k, 3) centres; one more than ``most`` where more do.

    Where ``one`` stand is enough, those after the first from which no more than ``most`` enter are not asked, and count as others.
    """
    units = len(centres)
    result = np.full(len(stands), most + 1)
    # beams that entered from the last place are asked first: most places are left after a few
    order = np.arange(len(points))
    by_axis, frusta = centres.T.copy(), np.empty((4, 4 * units))
    for u in range(units):
        for leg in range(4):
            for a in range(3):
                frusta[a, 4 * u + leg] = axes[u, leg, a]
            frusta[3, 4 * u + leg] = lasts[u, leg]
    # of a point from a centre, square of the distance beyond the reach: the same from all places
    beyond = np.empty((len(points), units))
    for i in range(len(points)):
        for u in range(units):
            px, py, pz = points[i, 0] - by_axis[0, u], points[i, 1] - by_axis[1, u], points[i, 2] - by_axis[2, u]
            beyond[i, u] = px * px + py * py + pz * pz - reach * reach
    inwards, near = np.empty(units), np.empty(units + 1, dtype=np.int64)
    asked = np.zeros((7, 4 * units + 4))
    for k in range(len(stands)):
        entered = 0
        for place in range(len(points)):
            i = order[place]
            x, y, z = points[i, 0], points[i, 1], points[i, 2]
            bx, by, bz = stands[k, 0] - x, stands[k, 1] - y, stands[k, 2] - z
            length = np.sqrt(bx * bx + by * by + bz * bz)
            bx, by, bz = bx / length, by / length, bz / length
            # without branches, in vector registers: whether the beam passes through the sphere around a unit
            for u in range(units):
                along = max((by_axis[0, u] - x) * bx + (by_axis[1, u] - y) * by + (by_axis[2, u] - z) * bz, 0.0)
                inwards[u] = along * along - beyond[i, u]
            count = 0
            for u in range(units):
                near[count] = u
                count += 1 if inwards[u] >= 0.0 else 0
            if count == 0:
                continue
            for m in range(count):
                u = near[m]
                for leg in range(4):
                    for a in range(4):
                        asked[a, 4 * m + leg] = frusta[a, 4 * u + leg]
                    asked[4, 4 * m + leg] = x - by_axis[0, u]
                    asked[5, 4 * m + leg] = y - by_axis[1, u]
                    asked[6, 4 * m + leg] = z - by_axis[2, u]
            if count % 2 == 1:
                # legs go by eight: four of no length
                for leg in range(4):
                    asked[3, 4 * count + leg] = 0.0
            if _legs_entered(asked, (count + 1) // 2, (bx, by, bz), radius, gradient, chord) > 0.0:
                order[place], order[entered] = order[entered], order[place]
                entered += 1
                if entered > most:
                    break
        result[k] = entered
        if one and entered <= most:
            break
    return result


@kernel(makes_arrays=False)
def _legs_entered(legs: Any, eights: int, beam: Any, radius: float, gradient: float, chord: float) -> float:
    """How many of so many times eight legs a beam runs within for more than ``chord``, as :func:`_inside` tells.

    Columns of ``legs`` (7, n) are the direction of a leg, where it ends along it, and from where the beam comes, relative to the unit's
    centre. No branches, and a number of passes that fills vector registers.
    """
    bx, by, bz = beam
    entered = 0.0
    for k in range(8 * eights):
        ax, ay, az = legs[0, k], legs[1, k], legs[2, k]
        px, py, pz = legs[4, k], legs[5, k], legs[6, k]
        axial = px * ax + py * ay + pz * az
        lean = bx * ax + by * ay + bz * az
        thick = radius - gradient * axial
        a = 1.0 - lean * lean * (1.0 + gradient * gradient)
        b = px * bx + py * by + pz * bz - axial * lean + thick * gradient * lean
        c = px * px + py * py + pz * pz - axial * axial - thick * thick
        root = b * b - a * c
        width = np.sqrt(max(root, 0.0))
        per = 1.0 / (a if abs(a) >= 1e-9 else 1.0)
        one, two = min((-b - width) * per, (-b + width) * per), max((-b - width) * per, (-b + width) * per)
        # nearly along the axis, a < 0: inside the cone before its apex
        low = one if a > 0.0 else (-1e300 if lean > 0.0 else two)
        high = two if a > 0.0 else (one if lean > 0.0 else 1e300)
        # across the axis: within both ends all along, or nowhere
        steps = 1.0 / (lean if abs(lean) > 1e-9 else 1e-300)
        start, end = -axial * steps, (legs[3, k] - axial) * steps
        low, high = max(max(low, min(start, end)), 0.0), min(high, max(start, end))
        entered += 1.0 if (root > 0.0) & (abs(a) >= 1e-9) & (high - low > chord) else 0.0
    return entered
