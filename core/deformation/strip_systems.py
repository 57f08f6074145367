"""Normal equations of the strips once the units are eliminated: offsets alone, or offsets that drift along the structure."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from ..common.arrays import FloatArray, IntArray
from .strip_drifts import GAUGE_WEIGHT, DriftSystem, StripDrifts, symmetric


@dataclass(frozen=True, eq=False, kw_only=True)
class UnitBlock:
    """One unit in the normal equations: inverse of its block, the same were its surface known, coupling to its strips, right-hand side, and
    what is left for the strips."""

    inverse_upper: FloatArray
    known_upper: FloatArray
    coupling: FloatArray
    rhs: FloatArray
    strips: IntArray
    strip_upper: FloatArray
    strip_rhs: FloatArray

    @property
    def inverse(self) -> FloatArray:
        """Inverse of the unit's own block."""
        return symmetric(self.inverse_upper, len(self.rhs))

    @property
    def noise_covariance(self) -> FloatArray:
        """Of the unit's poses and its size, were its surface and the strips known."""
        return symmetric(self.known_upper, len(self.rhs))

    @property
    def strip_normal(self) -> FloatArray:
        """(3 t, 3 t) what is left for the strips."""
        return symmetric(self.strip_upper, len(self.strip_rhs))


@dataclass(eq=False, kw_only=True)
class StripValues:
    """What is known of all strips so far, which steps change.

    Attributes
    ----------
    offsets
        (s, 3) metres.
    drifts
        (k, s, 3) deviations from them at the knots along the structure, metres.
    """

    offsets: FloatArray
    drifts: FloatArray


class StripSystem(Protocol):
    """Adjusted strips of one step."""

    def apply(self, values: StripValues) -> float:
        """Move the strips; the largest step in metres."""

    def change(self, unit: int, strips: IntArray) -> FloatArray:
        """(3 t,) change of some strips where a unit lies."""

    def covariance(self, unit: int, strips: IntArray) -> FloatArray:
        """(3 t, 3 t) covariance of some strips where a unit lies."""

    def drifts(self, numbers: Mapping[tuple[int, int], int], values: StripValues) -> StripDrifts | None:
        """How strips drift, by (epoch, source) with their numbers; None where they are stiff."""

    def offset_sds(self) -> FloatArray:
        """(s, 3) standard deviations of the offsets, metres."""


class OffsetSystem:
    """Constant offsets of all strips: one dense system."""

    def __init__(self, weights: FloatArray, epochs: IntArray, offsets: FloatArray, blocks: Iterable[UnitBlock]) -> None:
        """Of (3 s,) weights of the pseudo-observations, (s,) epochs and (s, 3) present offsets of the strips, and what the units say."""
        prior = np.diag(weights)
        for epoch in np.unique(epochs):
            columns = strip_columns(np.flatnonzero(epochs == epoch)).reshape(-1, 3)
            for axis in columns.T:
                # the mean offset of an epoch is the registration's business: held at zero
                prior[np.ix_(axis, axis)] += GAUGE_WEIGHT * weights[axis].mean()
        reduced = prior.copy()
        rhs = -prior @ offsets.ravel()
        for block in blocks:
            columns = strip_columns(block.strips)
            reduced[np.ix_(columns, columns)] += block.strip_normal
            rhs[columns] += block.strip_rhs
        self.cofactor = np.asarray(np.linalg.inv(reduced), dtype=np.float64)
        self.shift = self.cofactor @ rhs

    def apply(self, values: StripValues) -> float:
        """Take the step; the largest change of an offset."""
        values.offsets += self.shift.reshape(-1, 3)
        return float(np.abs(self.shift).max(initial=0.0))

    def change(self, unit: int, strips: IntArray) -> FloatArray:
        """(3 t,) change of some strips."""
        return np.asarray(self.shift[strip_columns(strips)])

    def covariance(self, unit: int, strips: IntArray) -> FloatArray:
        """(3 t, 3 t) covariance of some strips."""
        columns = strip_columns(strips)
        return np.asarray(self.cofactor[np.ix_(columns, columns)])

    def drifts(self, numbers: Mapping[tuple[int, int], int], values: StripValues) -> StripDrifts | None:
        """How strips drift, by (epoch, source) with their numbers; None where they are stiff."""
        return None

    def offset_sds(self) -> FloatArray:
        """(s, 3) standard deviations of the offsets, metres."""
        return np.asarray(np.sqrt(np.diag(self.cofactor)).reshape(-1, 3), dtype=np.float64)


class DriftStep:
    """One step of drifting strips."""

    def __init__(self, system: DriftSystem, rate: float, at: FloatArray) -> None:
        self.system = system
        self.step, self.factor = system.solve(rate, at)

    @cached_property
    def cofactors(self) -> dict[int, FloatArray]:
        """Of the strips by span of knots, which the last step alone is asked for."""
        return self.system.cofactors(self.factor)

    def apply(self, values: StripValues) -> float:
        """Take the step; the largest change of a drift."""
        values.drifts = values.drifts + self.step
        return float(np.abs(self.step).max(initial=0.0))

    def change(self, unit: int, strips: IntArray) -> FloatArray:
        """(3 t,) change of some strips where a unit lies."""
        around = self.system.knots.weights(self.system.places[unit])
        return np.asarray(sum(weight * self.step[k, strips] for k, weight in around)).ravel()

    def covariance(self, unit: int, strips: IntArray) -> FloatArray:
        """(3 t, 3 t) covariance of some strips where a unit lies."""
        place = self.system.places[unit]
        lever = self.system.lever(place, strips)
        return np.asarray(lever @ self.cofactors[int(self.system.knots.first[place])] @ lever.T)

    def drifts(self, numbers: Mapping[tuple[int, int], int], values: StripValues) -> StripDrifts | None:
        """How strips drift, by (epoch, source) with their numbers; None where they are stiff."""
        knots, places, seen = self.system.knots, self.system.places, self.system.seen
        return StripDrifts(knots=knots, numbers=numbers, values=values.drifts, places=places, seen=seen)

    def offset_sds(self) -> FloatArray:
        """(s, 3) standard deviations of the offsets, metres."""
        return self.system.mean_sds(self.cofactors)


def strip_columns(strips: IntArray) -> IntArray:
    """Columns of the three offsets of each strip."""
    return np.asarray((3 * strips[:, None] + np.arange(3)).ravel(), dtype=np.int64)
