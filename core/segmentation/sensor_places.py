"""Where the sensor of a strip or station stood, told by the units its beams pass by.

No beam may enter what surely stands: the shafts of legs, which breaks leave, and legs that were seen to be whole. What lies about one unit
tells a direction to a degree or so, and hardly a distance. A tripod stands at one place for all units, though, and an aircraft scans from
a straight line, abeam of what it measures: where one such place or line does for units all over the cloud, it is found by drawing places
about the best ones again and again (cross-entropy method: Rubinstein, 1999, Methodology and Computing in Applied Probability 1, 127-190),
and tells the place for each unit much better than the unit itself. Where none does, each unit is asked by itself, and sources that mix many
places, as clouds of images do, say nothing.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.neighbourhood import build_grid
from ..model.unit_types import UnitType
from .beams import entering_beams, entering_beams_by_block

STANDING = 0.6
"""Share of a leg that breaks leave."""
ROUNDED = 0.95
"""Share of a whole leg that rounded tips leave."""
AROUND_HEIGHTS = 2.0
"""Distance from a unit's centre within which points are what lies behind it, and units stand in the way."""
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
SHARP_MARGIN_HEIGHTS, SHARP_CHORD_HEIGHTS = 0.01, 0.02
"""The same for places common to all units, of which many beams tell: more enter, and fewest from the very place. Log-likelihoods of the
true places of five stations of simulated castings were 4 to 54 above those of the places found with the others."""
MOST_SHARED_ENTERED = 0.015
"""Share of beams that may enter then."""
SEEDS, FEWEST_SEEDS = 6, 4
"""Units all over a cloud whose beams tell the place of a source common to them, and by how few it is not told."""
ASKED = 3
"""Of these, units that are asked for the place by themselves first."""
HEADINGS = 30
"""Of lines of flight that are tried first, six degrees apart."""
DISTANCE_WEIGHT = 0.02
"""Of the distances that units tell of a sensor, beside their directions."""
DRAWS = ((40, 240), (100, 60), (250, 44), (600, 32))
"""Points of each seed whose beams are asked, and places of which most are, round by round."""
LATER_DRAWS = 24
"""Places drawn about the best of each round."""
BEST, FEWEST_BEST = 0.1, 10
"""Share of the places about which the next ones are drawn, and fewest of them."""
WIDER = 2.0
"""Factor of their covariance."""
MOST_ENTERED = 0.2
"""Share of a seed's beams beyond which no more are counted that enter what stands."""
GIVEN_UP = 0.05
"""Share of all of them from the best place beyond which there is none."""
MOST_SHARED, CHECKED = 16, 500
"""Places common to all units that are kept, and points about a unit whose beams tell whether they do for it."""


class Around(NamedTuple):
    """(n, 3) points of a source about a unit, from its centre, and the same in the order of their distance from it."""

    points: FloatArray
    nearest: FloatArray


class Stands(NamedTuple):
    """Places at which a sensor may have stood.

    (m, 3) places, of the sensor when it measured what is about a unit's centre, from there; (m, 3) horizontal unit vectors along which it
    moved with what it measured, 0 where it stood; and (m,) their log-likelihoods less that of the best one.
    """

    places: FloatArray
    drifts: FloatArray
    likelihoods: FloatArray

    @classmethod
    def none(cls) -> Stands:
        """Nothing is known."""
        return cls(np.empty((0, 3)), np.empty((0, 3)), np.empty(0))


class Solids:
    """What surely stands of the units of one type: the shafts of their legs, and the legs that are known to be whole."""

    def __init__(self, poses: FloatArray, whole: BoolArray, unit: UnitType, noise: float) -> None:
        """Of (k, 12) centres and row-major rotations, and (k, 4) legs known to be whole; points have a noise of so many metres."""
        self.unit, self.centres = unit, poses[:, :3]
        self.axes = np.einsum("kij,lj->kli", poses[:, 3:].reshape(-1, 3, 3), unit.leg_directions)
        self._lasts = np.where(whole, ROUNDED, STANDING) * unit.leg_length
        self._tree = cKDTree(self.centres)
        self.reach = AROUND_HEIGHTS * unit.height
        margins = (max(share * unit.height, MARGIN_IN_NOISE * noise) for share in (MARGIN_HEIGHTS, SHARP_MARGIN_HEIGHTS))
        chords = CHORD_HEIGHTS * unit.height, SHARP_CHORD_HEIGHTS * unit.height
        self.cone, self._sharp = ((unit.radius - margin, unit.gradient, chord) for margin, chord in zip(margins, chords, strict=True))
        """Radius at the centre, its decrease along a leg and the length inside from which a beam enters, metres."""

    def entered(
        self, number: int, points: FloatArray, stands: tuple[FloatArray, FloatArray], most: int, *, one: bool = False, sharp: bool = False
    ) -> IntArray:
        """(m,) how many beams of (n, 3) points towards places with their drifts, all from a unit's centre, enter what stands about it.

        One more than ``most`` where more do; where ``one`` place is enough, those after it are not asked. ``sharp`` solids are hardly
        thinner than nominal.
        """
        centre = self.centres[number]
        near = self._tree.query_ball_point(centre, self.reach)
        about = self.centres[near] - centre, self.axes[near], self._lasts[near]
        entering = entering_beams if one else entering_beams_by_block
        return np.asarray(entering(points, *stands, *about, self.unit.reach, *(self._sharp if sharp else self.cone), most))


class Source:
    """Points of one strip or station, and the places it was found to have stood at."""

    def __init__(self, points: FloatArray, solids: Solids) -> None:
        self._points, self._solids = points, solids
        self._grid = build_grid(points, CELL_HEIGHTS * solids.unit.height)
        self._known: dict[int, Stands] = {}
        self._seen_from: list[tuple[FloatArray, FloatArray]] = []
        self._shared: Shared | None = None
        self._looked = False

    def around(self, number: int) -> Around:
        """Points about a unit, from its centre."""
        centre = self._solids.centres[number]
        own = self._points[self._grid.within(centre, self._solids.reach)] - centre
        return Around(own, nearest_first(own))

    def stands(self, number: int, own: Around) -> Stands:
        """Places from which the beams of the points about a unit enter no solid, but for a few."""
        if number not in self._known:
            shared = self.shared()
            self._known[number] = self._searched(number, own) if shared is None else self._of_shared(number, own, shared)
        return self._known[number]

    def knows(self, number: int) -> bool:
        """Whether the places for a unit are known already."""
        return number in self._known

    def shared(self) -> Shared | None:
        """Places that do for units all over the cloud, if some do."""
        if not self._looked:
            self._looked = True
            self._shared = self._search_shared()
        return self._shared

    def _of_shared(self, number: int, own: Around, shared: Shared) -> Stands:
        """Those of the places common to all from which the beams about a unit enter no solid, but for a few: else its pose errs."""
        places = shared.seen_from(self._solids.centres[number])
        some = spread_evenly(own.nearest, CHECKED)
        most = int(ROUNDS[-1][2] * len(some))
        likely = self._solids.entered(number, some, (places, shared.drifts), most) <= most
        if not likely.any():
            return Stands.none()
        likelihoods = shared.likelihoods[likely]
        return Stands(places[likely], shared.drifts[likely], likelihoods - likelihoods.max())

    def _search_shared(self) -> Shared | None:
        """Places common to units all over the cloud, of those with most points; some are asked for their own first."""
        centres = self._solids.centres
        abouts = {int(number): self.around(int(number)) for number in _spread_out(centres, 2 * SEEDS)}
        rich = sorted((k for k, own in abouts.items() if len(own.points) >= FEWEST_POINTS), key=lambda k: -len(abouts[k].points))[:SEEDS]
        if len(rich) < FEWEST_SEEDS:
            return None
        seeds = {number: abouts[number] for number in rich}
        told: dict[int, FloatArray] = {}
        for number, own in seeds.items():
            places, _ = self._tried(number, own, ROUNDS[:-1])
            if len(places):
                told[number] = places + centres[number]
            if len(told) >= ASKED:
                break
        return shared_places(seeds, told, self._solids) if len(told) > 1 else None

    def _searched(self, number: int, own: Around) -> Stands:
        """The same of one unit by itself; the source remembers the places."""
        solids, centre = self._solids, self._solids.centres[number]
        tried, some = self._tried(number, own, ROUNDS)
        if not len(tried):
            return Stands.none()
        nearest, most = own.nearest, int(ROUNDS[-1][2] * len(some))
        self._seen_from.append((centre, tried + centre))
        # the sensor may stand between the places tried
        tried, cost = _beside(tried, FINEST_DEG), BEAM_COST * len(nearest) / len(some)
        entered = solids.entered(number, some, (tried, np.zeros_like(tried)), most)
        likelihoods = cost * (entered.min() - entered)
        likely = (entered <= most) & (likelihoods > -LEAST_LIKELY)
        return Stands(tried[likely], np.zeros_like(tried[likely]), likelihoods[likely])

    def _tried(self, number: int, own: Around, rounds: Sequence[tuple[int, float, float, float]]) -> tuple[FloatArray, FloatArray]:
        """(m, 3) places that are left of a unit's after rounds, and the points whose beams were asked last."""
        solids = self._solids
        tried = (_directions()[:, None, :] * (np.array(DISTANCES_HEIGHTS) * solids.unit.height)[:, None]).reshape(-1, 3)
        for k, (count, part, share, _) in enumerate(rounds):
            tried = _beside(tried, rounds[k - 1][3]) if k else tried
            some = spread_evenly(own.nearest[: max(int(part * len(own.nearest)), FEWEST_POINTS)], count)
            most = int(share * len(some))
            tried = tried[solids.entered(number, some, (tried, np.zeros_like(tried)), most) <= most]
            if len(tried) > MOST_PLACES or not len(tried):
                return np.empty((0, 3)), some
        return tried, some

    def stood(self, number: int) -> FloatArray:
        """(m, 3) places remembered of the units next to one, from its centre; the nearest unit's come first."""
        centre = self._solids.centres[number]
        away = [float(np.sum((own - centre) ** 2)) for own, _ in self._seen_from]
        near = np.argsort(away, kind="stable")[:NEIGHBOURS]
        return np.asarray(np.vstack([np.empty((0, 3)), *(self._seen_from[k][1] for k in near)]) - centre)


class Shared(NamedTuple):
    """Places of a sensor common to all units.

    (3,) a middle, (m, 3) places of the sensor when it measured what is there, in the frame of the cloud; (m, 3) horizontal unit vectors
    along which it moved with what it measured, 0 where it stood; and (m,) log-likelihoods.
    """

    middle: FloatArray
    places: FloatArray
    drifts: FloatArray
    likelihoods: FloatArray

    def seen_from(self, centre: FloatArray) -> FloatArray:
        """(m, 3) places of the sensor when it measured what is about a centre, from there."""
        return np.asarray(self.places + ((centre - self.middle) @ self.drifts.T)[:, None] * self.drifts - centre)

    def chosen(self, which: IntArray) -> Shared:
        """Some of the places."""
        return self._replace(places=self.places[which], drifts=self.drifts[which], likelihoods=self.likelihoods[which])


def shared_places(seeds: Mapping[int, Around], told: Mapping[int, FloatArray], solids: Solids) -> Shared | None:
    """Places, or lines of flight, from which hardly a beam about units enters what stands; None where there are none.

    Parameters
    ----------
    seeds
        Points about the units asked, by their numbers.
    told
        (m, 3) places that some of the units tell by themselves, in the frame of the cloud.
    """
    middle = solids.centres[list(seeds)].mean(axis=0)
    found = []
    turns = np.arange(HEADINGS) * math.pi / HEADINGS
    for headings in (None, turns):
        places, share = _best_places(_meeting(told, solids, middle, headings), seeds, solids, middle)
        if share <= MOST_SHARED_ENTERED:
            found.append(places)
    if not found:
        return None
    both = Shared(middle, *(np.concatenate(parts) for parts in zip(*(own[1:] for own in found), strict=True)))
    order = np.argsort(-both.likelihoods, kind="stable")[:MOST_SHARED]
    best = both.chosen(order[both.likelihoods[order] > both.likelihoods.max() - LEAST_LIKELY])
    return best._replace(likelihoods=best.likelihoods - best.likelihoods.max())


def _best_places(drawn: FloatArray, seeds: Mapping[int, Around], solids: Solids, middle: FloatArray) -> tuple[Shared, float]:
    """Places drawn last, and the share of beams that enters what stands from the best of them; ``drawn`` as :func:`_placed` takes."""
    rng = np.random.default_rng(0)
    for count, draws in DRAWS:
        drawn = drawn[:draws]
        places = _placed(drawn, middle)
        likelihoods, share = _likelihoods(seeds, solids, places, count)
        if share > GIVEN_UP:
            break
        best = drawn[np.argsort(-likelihoods, kind="stable")[: max(int(BEST * len(drawn)), FEWEST_BEST)]]
        # a line is the same half a turn on: headings just above 0 and just below pi have their mean at 0
        best[:, 3:] = best[0, 3:] + (best[:, 3:] - best[0, 3:] + math.pi / 2) % math.pi - math.pi / 2
        drawn = np.vstack([best, rng.multivariate_normal(best.mean(axis=0), WIDER * np.cov(best.T), LATER_DRAWS)])
    return places._replace(likelihoods=likelihoods), share


def _meeting(told: Mapping[int, FloatArray], solids: Solids, middle: FloatArray, headings: FloatArray | None) -> FloatArray:
    """Places where directions nearly meet that units tell: (m, 3) from the middle, or (m, 4) with each of the headings of lines of flight.

    Each unit tells many: one of each is drawn again and again. How far it told the sensor to be counts a little, as directions may be
    parallel.
    """
    rng = np.random.default_rng(0)
    turns = np.repeat(np.zeros(1) if headings is None else headings, DRAWS[0][1] // (1 if headings is None else len(headings)))
    heading = np.column_stack([np.cos(turns), np.sin(turns), np.zeros(len(turns))]) * (headings is not None)
    left, right = np.zeros((len(turns), 3, 3)), np.zeros((len(turns), 3))
    for number, places in told.items():
        from_unit = places[rng.integers(0, len(places), len(turns))] - solids.centres[number]
        towards = from_unit / np.linalg.norm(from_unit, axis=1)[:, None]
        across = np.eye(3) - towards[:, :, None] * towards[:, None, :]
        start = solids.centres[number] - middle
        start = start - (heading @ start)[:, None] * heading
        left += across + DISTANCE_WEIGHT * np.eye(3)
        right += np.einsum("mij,mj->mi", across, start) + DISTANCE_WEIGHT * (start + from_unit)
    meeting = np.linalg.solve(left, right[:, :, None])[:, :, 0]
    return np.asarray(meeting if headings is None else np.column_stack([meeting, turns]), dtype=np.float64)


def _placed(drawn: FloatArray, middle: FloatArray) -> Shared:
    """Of (m, 3) places from the middle, or (m, 4) with headings."""
    drifts = np.zeros((len(drawn), 3))
    if drawn.shape[1] > 3:
        drifts[:, 0], drifts[:, 1] = np.cos(drawn[:, 3]), np.sin(drawn[:, 3])
    return Shared(middle, middle + drawn[:, :3], drifts, np.zeros(len(drawn)))


def _likelihoods(seeds: Mapping[int, Around], solids: Solids, places: Shared, count: int) -> tuple[FloatArray, float]:
    """(m,) log-likelihoods of places by so many points about each seed, and the share of beams that enters what stands from the best."""
    result, entered, asked = np.zeros(len(places.places)), np.zeros(len(places.places)), 0
    for number, around in seeds.items():
        some = spread_evenly(around.nearest, count)
        there = places.seen_from(solids.centres[number])
        own = solids.entered(number, some, (there, places.drifts), int(MOST_ENTERED * len(some)), sharp=True)
        result -= BEAM_COST * len(around.nearest) / len(some) * own
        entered += own
        asked += len(some)
    return result, float(entered[result.argmax()] / asked)


def _spread_out(places: FloatArray, count: int) -> IntArray:
    """Numbers of at most so many of (n, 3) places, each the farthest from those before it."""
    chosen = [0]
    away = np.linalg.norm(places - places[0], axis=1)
    while len(chosen) < min(count, len(places)):
        chosen.append(int(away.argmax()))
        away = np.minimum(away, np.linalg.norm(places - places[chosen[-1]], axis=1))
    return np.array(chosen)


def nearest_first(points: FloatArray) -> FloatArray:
    """(n, 3) points in the order of their distance from the origin, those equally far in their own."""
    squares = np.einsum("ij,ij->i", points, points)
    # in half the time of a stable order, which differs where two points are equally far
    order = np.argsort(squares)
    ranked = squares[order]
    if (ranked[1:] == ranked[:-1]).any():
        order = np.argsort(squares, kind="stable")
    return np.asarray(points[order])


def spread_evenly(points: FloatArray, count: int) -> FloatArray:
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
