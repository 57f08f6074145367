"""Whether the legs of a unit are whole: what the cloud shows at and short of their ends.

A leg is whole where the sides that show nearer the centre go on to its end, or where its end disc shows. It is broken where points lie
well inside the nominal solid, short of the end, as a face across the leg: no other solid can be there; where beams pass through the place
of its end (:mod:`.seen_through`); or where its sides stop short of the end all around although what lies behind is seen
(:mod:`.sight_lines`). Elsewhere its end is not seen, and nothing is said: a side that stops may lie in the shadow of a neighbour.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, TypeVar

import numpy as np

from ..common.arrays import BoolArray, FloatArray
from ..model.unit_types import UnitType
from .seen_through import Passing
from .sight_lines import SECTORS, leg_places

UNSEEN, WHOLE, BROKEN = 0, 1, 2
LEG_STATES = ("unseen", "whole", "broken")
SHAFT = (0.35, 0.6)
"""Part of a leg, in shares of its length, that shows how densely it is sampled: breaks leave it."""
TIP = (0.78, 0.9)
"""Part of a leg, in shares of its length, that every break takes away and no rounded tip reaches."""
END = (0.9, 0.98)
"""Part of a leg, in shares of its length, that no oblique break leaves."""
FACE = (0.5, 0.93)
"""Shares of a leg between which a face of fracture is looked for."""
DEPTH_HEIGHTS = 0.035
"""Depth below the nominal surface, in unit heights, beyond which a point is inside: more than tips are rounded and concrete is worn."""
TOLERANCE_HEIGHTS = 0.02
DEPTH_IN_NOISE = 3.5
LEAST_SECTORS = 4
"""Sectors of a leg's section that a face of fracture has to reach."""
LEAST_POINTS = 8
NARROW_EVIDENCE, BEYOND_NARROW = 3.0, 1.5
"""The most that points inside a leg say which reach too few sectors (log-likelihood ratio), and evidence of beams through its end from
which they are asked: a neighbour or a pose that errs puts points into some sectors, too, but of 186 whole legs beams say 1.0 at most."""
MOST_WITHIN_SIDES = math.log(1000.0)
"""The most that points inside a leg say one of whose sides goes on to its end (assumed: a move may push a leg into rock). Of 119 broken
legs of fourteen simulated surveys that show a face eight had such a side, and others that stop short of the end; of 1551 whole ones none
had points inside, on `long_coast` one, and all its sides go on."""
MOST_DISC = 3
"""Times as many points about an end's plane as count show its disc: fewer may be of what lies beyond a break."""
SHOWN, STRAY = 0.35, 0.03
"""Shares of a face's or an end's points, at the density of the leg, that are there where it is seen and where it is not."""
OBLIQUITY = 0.25
"""Standard deviation of a break's slopes across the leg (assumed: breaks that leave a side 10 cm longer than the other are common)."""
SLOPES = 61
"""Slopes of breaks, in either direction, by which it is asked which sides they leave."""
RAREST = 1e-6
"""Probability below which none is told."""
INDEPENDENT = 0.15
"""Share of points that count as independent evidence: their neighbours see the same."""
PRIOR_ODDS = math.log(0.02 / 0.98)
"""Natural logarithm of the odds that a leg is broken, before looking: one of fifty is."""
SIGHT_WEIGHT = 0.4
"""Of the evidence of patches that should be seen and are not: sensor directions are known to some degrees only. On whole legs of simulated
and real surveys it reaches 8, on the broken leg of `uav_as_cast` 12, and 9.7 is asked for."""
LEAST_EVIDENCE = 0.5
"""Of beams through the place of an end (logarithm of a likelihood ratio): less passes on one of a hundred whole legs."""
LEAST_SIGHT_SECTORS = 3
"""Sectors of a shaft that must be seen before its end is missed."""

Count = TypeVar("Count", float, FloatArray)


@dataclass(frozen=True, eq=False)
class LegEnds:
    """State of the four legs of a unit.

    Attributes
    ----------
    states
        (4,) ``UNSEEN``, ``WHOLE`` or ``BROKEN``.
    missing
        (4,) length that is missing of broken legs, metres, or would be of legs that something speaks for a break of; 0 of others.
    broken
        (4,) probability that the leg is broken; nan where its end is not seen.
    evidence
        (4,) log-likelihood ratio of a broken leg against a whole one, 0 where nothing is seen of it; what was known before is not in it.
    """

    states: FloatArray
    missing: FloatArray
    broken: FloatArray
    evidence: FloatArray

    @classmethod
    def unseen(cls) -> LegEnds:
        """Nothing is known."""
        return cls(np.full(4, UNSEEN), np.zeros(4), np.full(4, math.nan), np.zeros(4))

    def renumbered(self, order: FloatArray) -> LegEnds:
        """With the legs in another order, (4,) old numbers by new ones."""
        return LegEnds(self.states[order], self.missing[order], self.broken[order], self.evidence[order])

    def as_row(self) -> dict[str, object]:
        """Fields of the layer ``units``: state, missing length and probability of each leg, and the largest of each."""
        row: dict[str, object] = {}
        for k, state in enumerate(self.states.tolist()):
            told = state != UNSEEN and math.isfinite(self.broken[k])
            row[f"leg{k + 1}"] = LEG_STATES[int(state)]
            row[f"leg{k + 1}_missing"] = float(self.missing[k]) if state == BROKEN else None
            row[f"leg{k + 1}_probability"] = float(self.broken[k]) if told else None
        gone, shares = self.missing[self.states == BROKEN], self.broken[(self.states != UNSEEN) & np.isfinite(self.broken)]
        row["leg_missing"] = float(gone.max()) if len(gone) else None
        row["leg_probability"] = float(shares.max()) if len(shares) else None
        return row

    @classmethod
    def from_row(cls, row: Mapping[str, Any]) -> LegEnds:
        """Inverse of :meth:`as_row`; unseen where a row says nothing.

        A row of an earlier version states one length and one probability: those of its broken legs, or where none is broken of all seen.
        """
        states = np.array([LEG_STATES.index(row[f"leg{k + 1}"]) if row.get(f"leg{k + 1}") in LEG_STATES else UNSEEN for k in range(4)])
        broken = states == BROKEN
        told, gone = (_numbers(row.get(f"leg{k + 1}_{what}") for k in range(4)) for what in ("probability", "missing"))
        if np.isnan(told).all():
            told, gone = (_numbers([row.get(name)] * 4) for name in ("leg_probability", "leg_missing"))
            told = np.where(broken | ~broken.any(), told, math.nan)
        told = np.where(states == UNSEEN, math.nan, told)
        sure = np.clip(told, 1e-9, 1 - 1e-9)
        evidence = np.where(np.isnan(told), 0.0, np.log(sure / (1 - sure)) - PRIOR_ODDS)
        return cls(states, np.where(broken, np.nan_to_num(gone), 0.0), told, evidence)


def _numbers(values: Iterable[Any]) -> FloatArray:
    """Values of a row as numbers, nan for none."""
    return np.array([math.nan if value is None else float(value) for value in values])


def leg_ends(
    view: LegView,
    sights: Callable[[int, float], tuple[float, float]] | None = None,
    beams: Callable[[int, float], Passing] | None = None,
) -> LegEnds:
    """Judge the legs of a unit.

    Where its own points do not tell, ``beams`` tells what passes through a leg from a place along it (metres), and ``sights`` the evidence
    that a leg ends early and the share of it that is left, if the evidence reaches its second argument (natural logarithm of odds).
    """
    unit, result = view.unit, LegEnds.unseen()
    for k in range(4):
        odds, place = view.odds(k)
        if beams is not None and view.may_end_early(k, odds):
            passing = beams(k, SHAFT[1] * unit.leg_length)
            result.evidence[k] = passing.evidence
            if passing.evidence > LEAST_EVIDENCE:
                place = view.break_before(k, passing.place)
                result.missing[k] = unit.leg_length - place
                if math.isnan(odds) and passing.evidence > BEYOND_NARROW:
                    result.evidence[k] += view.narrow_face(k)
                through = result.evidence[k] + (PRIOR_ODDS if math.isnan(odds) else odds)
                # what proves nothing by itself may do so with other epochs
                odds = through if through > 0 or not math.isnan(odds) else odds
        if math.isnan(odds) and sights is not None and view.shaft_sectors(k) >= LEAST_SIGHT_SECTORS:
            odds, place = _odds_of_sights(sights(k, -PRIOR_ODDS / SIGHT_WEIGHT), unit)
        if math.isnan(odds):
            continue
        broken = 1 / (1 + math.exp(-min(max(odds, -500.0), 500.0)))
        result.broken[k] = broken
        result.evidence[k] = odds - PRIOR_ODDS
        result.states[k] = BROKEN if broken > 0.5 else WHOLE
        if result.evidence[k] > 0:
            # other epochs may say that it is broken
            result.missing[k] = unit.leg_length - place
    return result


def _odds_of_sights(missing: tuple[float, float], unit: UnitType) -> tuple[float, float]:
    """Log-odds that a leg is broken, nan where the sights do not prove it; and where along it, metres."""
    evidence, left = missing
    odds = PRIOR_ODDS + SIGHT_WEIGHT * evidence
    return (odds, left * unit.leg_length) if odds > 0 else (math.nan, 0.0)


class LegView:
    """Points around a unit by leg, sector around it, place along it and distance from its side."""

    def __init__(self, body: FloatArray, unit: UnitType, noise: float) -> None:
        """Look at all (n, 3) points around a unit, in its body frame; ``noise`` is the standard deviation of a point, metres."""
        self.unit = unit
        self.leg, self.axial, rho, self.sector = leg_places(body, unit)
        self.outside = rho - (unit.radius - unit.gradient * self.axial)
        self.tolerance = max(TOLERANCE_HEIGHTS * unit.height, DEPTH_IN_NOISE * noise)
        self.depth = max(DEPTH_HEIGHTS * unit.height, DEPTH_IN_NOISE * noise)
        self.along = self.axial / unit.leg_length

    def sides_to_end(self) -> BoolArray:
        """(4,) legs whose sides are seen to go on to their ends."""
        return np.array([self.goes_on(k) for k in range(4)])

    def odds(self, leg: int) -> tuple[float, float]:
        """Log-odds that a leg is broken, nan where its end is not seen; and where along it, metres."""
        unit, own = self.unit, self.leg == leg
        on_side = own & (np.abs(self.outside) < self.tolerance)
        shaft = self._by_sector(on_side, SHAFT)
        sided = bool((shaft >= LEAST_POINTS).any())
        # a leg that points at the sensor hides its sides and shows its face: the other legs tell how densely it is sampled
        densities = [self._density(s) for s in ([shaft] if sided else map(self._shaft, range(4)))]
        if not any(densities):
            return math.nan, 0.0
        density = float(np.median([d for d in densities if d > 0]))
        section = math.pi * (unit.end_radius - self.depth) ** 2
        inside = self._inside(leg)
        face = float(inside.sum())
        if face < LEAST_POINTS or len(np.unique(self.sector[inside])) < LEAST_SECTORS:
            face = 0.0
        disc = float(np.sum(own & (np.abs(self.axial - unit.leg_length) < self.tolerance) & (self.outside < -self.tolerance)))
        sides = self._sides_to_the_end(on_side, shaft) if sided else 0.0
        if face:
            evidence = INDEPENDENT * (_support(face, density * section) - _support(disc, density * section))
            if sides:
                evidence = min(evidence, MOST_WITHIN_SIDES) + sides + self._sides_that_stop(on_side, shaft)
            return PRIOR_ODDS + evidence, float(np.median(self.axial[inside]))
        if not sided:
            return math.nan, 0.0
        if sides:
            return PRIOR_ODDS + sides, 0.0
        support = INDEPENDENT * _support(disc, density * section)
        if disc >= LEAST_POINTS and support > 0:
            return PRIOR_ODDS - support, 0.0
        return math.nan, 0.0

    def _sides_to_the_end(self, on_side: BoolArray, shaft: FloatArray) -> float:
        """Log-likelihood ratio of a break by sides that go on to the end, 0 where none does: one that goes on to the tip and stops there
        may end where the leg breaks."""
        tip, end = (self._side_support(on_side, part, shaft) for part in (TIP, END))
        if tip.sum() <= 0 or end.sum() <= 0:
            return 0.0
        # an oblique break may leave one side as long
        return max(-INDEPENDENT * float(tip.sum()), math.log(left_by_breaks(self.unit, tuple(end > 0))))

    def _sides_that_stop(self, on_side: BoolArray, shaft: FloatArray) -> float:
        """Log-likelihood ratio of a break by sides that stop short of the end; by themselves they prove nothing, as they may lie in the
        shadow of a neighbour."""
        return -INDEPENDENT * float(np.minimum(self._side_support(on_side, END, shaft), 0.0).sum())

    def _side_support(self, on_side: BoolArray, part: tuple[float, float], shaft: FloatArray) -> FloatArray:
        """(SECTORS,) log-likelihood ratios of a part of a leg's side being there; 0 in sectors that hide its ``shaft`` (SECTORS,)."""
        expected = shaft * self._area(part) / self._area(SHAFT)
        return np.where(shaft >= LEAST_POINTS, _support(self._by_sector(on_side, part), expected), 0.0)

    def narrow_face(self, leg: int) -> float:
        """Log-likelihood ratio of a break by points well inside a leg that reach too few of its sectors to be a face by themselves."""
        count = int(self._inside(leg).sum())
        return min(INDEPENDENT * count * math.log(SHOWN / STRAY), NARROW_EVIDENCE) if count >= LEAST_POINTS else 0.0

    def _inside(self, leg: int) -> BoolArray:
        """(n,) points well inside a leg short of its end."""
        short = (self.along > FACE[0]) & (self.along < FACE[1]) & (self.axial < self.unit.leg_length - self.depth)
        return np.asarray((self.leg == leg) & (self.outside < -self.depth) & short)

    def goes_on(self, leg: int) -> bool:
        """Whether the side of a leg is seen up to its end, in the sectors in which its shaft is."""
        on_side = (self.leg == leg) & (np.abs(self.outside) < self.tolerance)
        shaft, end = self._by_sector(on_side, SHAFT), self._by_sector(on_side, END)
        expected = shaft.sum() * self._area(END) / self._area(SHAFT)
        return bool(expected > 0 and end[shaft > 0].sum() > SHOWN * expected)

    def may_end_early(self, leg: int, odds: float) -> bool:
        """Whether a leg's shaft is seen and its end is not; ``odds`` as :meth:`odds` tells."""
        disc = (self.leg == leg) & (np.abs(self.axial - self.unit.leg_length) < self.tolerance) & (self.outside < -self.tolerance)
        return (
            not odds > 0
            and self._shaft(leg).sum() >= LEAST_POINTS
            and not self.goes_on(leg)
            and int(disc.sum()) <= MOST_DISC * LEAST_POINTS
        )

    def break_before(self, leg: int, place: float) -> float:
        """Where a leg breaks, metres along it, that is missed from ``place`` on: midway from where its sides are last seen."""
        on_side = (self.leg == leg) & (np.abs(self.outside) < self.tolerance) & (self.axial < place)
        ends = self.axial[on_side & (self._shaft(leg)[self.sector] > 0)]
        return 0.5 * (place + float(np.quantile(ends, 0.98)))

    def shaft_sectors(self, leg: int) -> int:
        """Sectors in which a leg's shaft is seen."""
        return int(np.sum(self._shaft(leg) > 0))

    def _shaft(self, leg: int) -> FloatArray:
        return self._by_sector((self.leg == leg) & (np.abs(self.outside) < self.tolerance), SHAFT)

    def _density(self, shaft: FloatArray) -> float:
        """Points a square metre of a leg's side, of (SECTORS,) points of its shaft; 0 where it is not seen."""
        sides = shaft >= LEAST_POINTS
        return float(np.median(shaft[sides])) / self._area(SHAFT) if sides.any() else 0.0

    def _by_sector(self, which: BoolArray, part: tuple[float, float]) -> FloatArray:
        chosen = which & (self.along > part[0]) & (self.along < part[1])
        return np.bincount(self.sector[chosen], minlength=SECTORS).astype(np.float64)

    def _area(self, part: tuple[float, float]) -> float:
        """Area of one sector of a part of a leg's side, square metres."""
        radius = self.unit.radius - self.unit.gradient * 0.5 * sum(part) * self.unit.leg_length
        return 2 * math.pi * radius / SECTORS * (part[1] - part[0]) * self.unit.leg_length


@lru_cache(maxsize=512)
def left_by_breaks(unit: UnitType, sectors: tuple[bool, ...]) -> float:
    """Probability that a break leaves a leg's side up to its end in all of the given sectors: breaks lie anywhere along ``FACE``, at slopes
    of any direction, and reach farther out on one side."""
    slope = np.linspace(-4, 4, SLOPES)
    weight = np.exp(-0.5 * (slope[:, None] ** 2 + slope**2))
    turn = (np.flatnonzero(sectors) + 0.5) / SECTORS * 2 * math.pi
    farther = OBLIQUITY * unit.end_radius / unit.leg_length * (slope[:, None, None] * np.cos(turn) + slope[:, None] * np.sin(turn))
    least = farther.min(axis=2, initial=np.inf) if len(turn) else np.zeros(weight.shape)
    left = np.clip((FACE[1] + least - END[0]) / (FACE[1] - FACE[0]), 0.0, 1.0)
    return float(max((weight * left).sum() / weight.sum(), RAREST))


def _support(count: Count, expected: Count) -> Count:
    """Log-likelihood ratio of a Poisson count, or of each of several: ``SHOWN`` of what is expected against ``STRAY`` of it."""
    return count * math.log(SHOWN / STRAY) - (SHOWN - STRAY) * expected
