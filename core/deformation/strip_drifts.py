"""Drifts of flight strips and stations along the structure, beyond their constant offsets.

The deviation of a strip from its offset is a random walk over knots along the structure, interpolated linearly between them: what a
trajectory does within a survey, whatever the times of its points. Its rate is learned by restricted maximum likelihood from the
normal equations of the units, which see every strip where they overlap; without a clear gain strips stay stiff. What all strips of an
epoch do alike at a place cannot be told here and belongs to the frame: their mean is held at zero knot by knot.

A strip has unknowns from the first knot to the last around units that see it. What the walk does beyond them is eliminated beforehand,
strip by strip, so that time and memory grow with the structure.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csc_array, eye_array, kron

from ..common.arrays import FloatArray, IntArray, upper_triangle
from ..common.block_tridiagonal import BlockTridiagonal
from ..common.centreline import ARM_HEIGHTS, centreline
from .unit_clouds import Sources

KNOT_HEIGHTS = 3.5
"""Distance of knots in heights of a unit."""
FEWEST_KNOTS = 3
RATES = (0.0002, 0.0005, 0.001, 0.002, 0.004, 0.008, 0.016)
"""Deviations after ten heights, over the height, among which the rate of the walk is chosen."""
GAIN = 12.0
"""Least gain of log-likelihood by which strips are said to drift."""
GAUGE_WEIGHT = 1e4
"""Weight of the condition that strips of an epoch add up to zero, over the weight of one strip's pseudo-observation."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Knots:
    """Knots along the structure, and where every unit lies between them.

    Attributes
    ----------
    count
        Of knots.
    spacing
        Their distance, metres.
    first
        (u,) knot before each unit.
    share
        (u,) weight of the knot after it, 0 to 1.
    """

    count: int
    spacing: float
    first: IntArray
    share: FloatArray

    @property
    def length(self) -> float:
        """From the first knot to the last, metres."""
        return self.spacing * (self.count - 1)

    @classmethod
    def along(cls, places: FloatArray, height: float) -> Knots | None:
        """Knots for units at (u, 3) ``places``; None where the structure is too short for any."""
        along = centreline(places, ARM_HEIGHTS * height).locate(places)[0]
        low, high = float(along.min()), float(along.max())
        count = round((high - low) / (KNOT_HEIGHTS * height)) + 1
        if count < FEWEST_KNOTS:
            return None
        spacing = (high - low) / (count - 1)
        scaled = (along - low) / spacing
        first = np.minimum(scaled.astype(np.int64), count - 2)
        return cls(count=count, spacing=spacing, first=first, share=scaled - first)

    def weights(self, unit: int) -> tuple[tuple[int, float], tuple[int, float]]:
        """The two knots around a unit with their weights."""
        k, share = int(self.first[unit]), float(self.share[unit])
        return (k, 1 - share), (k + 1, share)


@dataclass(frozen=True, eq=False, kw_only=True)
class StripDrifts:
    """Adjusted drifts.

    Attributes
    ----------
    knots
        Along the structure.
    numbers
        (epoch, source) to number of the strip.
    values
        (knots, strips, 3) deviation from the strip's offset, metres.
    places
        Physical unit to its number among the knots' units.
    seen
        By the knot before some units, numbers of the strips that see any of these.
    """

    knots: Knots
    numbers: Mapping[tuple[int, int], int]
    values: FloatArray
    places: Mapping[int, int]
    seen: Mapping[int, IntArray]

    def at(self, unit: int, epoch: int, sources: Sources) -> FloatArray:
        """(s, 3) deviations of strips where a unit lies."""
        own = [self.numbers[epoch, int(k)] for k in sources]
        return np.asarray(sum(weight * self.values[k, own] for k, weight in self.knots.weights(self.places[unit])))

    def variances_of_mean(self, epoch: int) -> FloatArray:
        """(3,) variance by axis of the mean drift of the strips of an epoch that see a place, square metres, as these differ.

        The mean over all places that two or more of them see; 0 without any.
        """
        own = {number for (e, _), number in self.numbers.items() if e == epoch}
        found = []
        for knot, strips in self.seen.items():
            there = [int(k) for k in strips if int(k) in own]
            if len(there) > 1:
                between = 0.5 * (self.values[knot, there] + self.values[knot + 1, there])
                found.append(np.var(between, axis=0, ddof=1) / len(there))
        return np.asarray(np.mean(found, axis=0)) if found else np.zeros(3)


@dataclass(frozen=True, eq=False, kw_only=True)
class UnitEquations:
    """What one unit, its pose and surface eliminated, says of the strips that see it.

    Attributes
    ----------
    unit
        Its number among the knots' units.
    strips
        (t,) numbers of the strips, ascending.
    upper, rhs
        Upper half of the (3 t, 3 t) matrix, row by row, and (3 t,) right-hand side of the reduced normal equations of their offsets.
    """

    unit: int
    strips: IntArray
    upper: FloatArray
    rhs: FloatArray

    @property
    def normal(self) -> FloatArray:
        """(3 t, 3 t) reduced normal matrix."""
        return symmetric(self.upper, len(self.rhs))


def symmetric(upper: FloatArray, size: int) -> FloatArray:
    """Symmetric matrix of which half is kept: one a unit stays in memory."""
    full = np.empty((size, size))
    rows, columns = upper_triangle(size)
    full[rows, columns] = full[columns, rows] = upper
    return full


class DriftSystem:
    """Normal equations of the drifts of all strips; unknowns run by knot, then strip, then axis."""

    def __init__(
        self,
        knots: Knots,
        strip_epoch: IntArray,
        equations: Sequence[UnitEquations],
        weak_sd: FloatArray,
        places: Mapping[int, int],
    ) -> None:
        self.knots, self.places = knots, places
        self.strip_epoch, self.weak_sd = strip_epoch, weak_sd
        spans: dict[int, list[UnitEquations]] = {}
        for own in equations:
            spans.setdefault(int(knots.first[own.unit]), []).append(own)
        self.seen = {k: np.unique(np.concatenate([own.strips for own in members])) for k, members in sorted(spans.items())}
        self.first, self.last = np.full(len(strip_epoch), knots.count), np.full(len(strip_epoch), -1)
        for k, strips in self.seen.items():
            self.first[strips] = np.minimum(self.first[strips], k)
            self.last[strips] = np.maximum(self.last[strips], k + 1)
        along = np.arange(knots.count)[:, None]
        self.active = (along >= self.first) & (along <= self.last)
        self.numbers = np.cumsum(self.active).reshape(self.active.shape) - 1
        self.starts = np.concatenate([[0], np.cumsum(self.active.sum(axis=1))]).astype(np.int64)
        self.size = 3 * int(self.starts[-1])
        self.rhs = np.zeros(self.size)
        seen = np.zeros(self.active.shape)
        for own in equations:
            for k, w in knots.weights(own.unit):
                self.rhs[self.columns(k, own.strips)] += w * own.rhs
                seen[k, own.strips] += w
        index, values = [np.zeros((2, 0), dtype=np.int64)], [np.zeros(0)]
        for k, strips in self.seen.items():
            block = self._between(spans[k], strips)
            around = self._around(k, strips)
            index.append(np.stack([np.repeat(around, len(around)), np.tile(around, len(around))]))
            values.append(block.ravel())
        self.normal = _sparse(np.concatenate(values), np.hstack(index), self.size)
        self.gauge = self._gauge(seen)

    def _between(self, members: Sequence[UnitEquations], strips: IntArray) -> FloatArray:
        """(6 t, 6 t) normal matrix of t strips at two knots that follow each other, of all units between these.

        Units are added up before they go into the sparse matrix: their own entries are a hundred times as many as those of the sum.
        """
        size = 3 * len(strips)
        first, across, second = sums = np.zeros((3, size, size))
        for own in members:
            local = (3 * np.searchsorted(strips, own.strips)[:, None] + np.arange(3)).ravel()
            (_, w), (_, v) = self.knots.weights(own.unit)
            sums[:, local[:, None], local] += np.array([w * w, w * v, v * v])[:, None, None] * own.normal
        return np.block([[first, across], [across, second]])

    def _around(self, knot: int, strips: IntArray) -> IntArray:
        """Unknowns of some strips at a knot and at the one after it."""
        return np.concatenate([self.columns(knot, strips), self.columns(knot + 1, strips)])

    def columns(self, knot: int, strips: IntArray) -> IntArray:
        """Unknowns of some strips at a knot where they have any."""
        return np.asarray((3 * self.numbers[knot, strips][:, None] + np.arange(3)).ravel(), dtype=np.int64)

    def _gauge(self, seen: FloatArray) -> csc_array:
        """Condition of one axis that the strips of an epoch that are seen at a knot drift by zero in the mean.

        Weighted by how much of them is seen; where none is, nothing asks for their mean.
        """
        rows: list[IntArray] = []
        columns, values = [], []
        strong = GAUGE_WEIGHT / float(np.median(self.weak_sd)) ** 2
        epochs = [np.flatnonzero(self.strip_epoch == epoch) for epoch in np.unique(self.strip_epoch)]
        for knot in range(self.knots.count):
            for own in epochs:
                there = own[seen[knot, own] > 0]
                rows.append(np.full(len(there), len(rows)))
                columns.append(self.numbers[knot, there])
                values.append(seen[knot, there] / seen[knot, there].sum())
        shape = (len(rows), int(self.starts[-1]))
        matrix = csc_array(coo_array((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), shape=shape))
        return csc_array(strong * (matrix.T @ matrix))

    def prior(self, rate: float) -> csc_array:
        """Weight matrix of the walk with a ``rate`` in metres per root metre, and of the weak pseudo-observations of zero."""
        return csc_array(kron(self._prior_of_axis(rate), eye_array(3)))

    def _prior_of_axis(self, rate: float) -> csc_array:
        walk, weak, beyond = self._walk(rate)
        diagonal = np.tile(weak, (self.knots.count, 1))
        strips = np.flatnonzero(self.last >= 0)
        first, last = self.first[strips], self.last[strips]
        diagonal[first, strips] += beyond[first, strips]
        diagonal[last, strips] += beyond[self.knots.count - 1 - last, strips]
        on = self.active[:-1] & self.active[1:]
        diagonal[:-1][on] += walk
        diagonal[1:][on] += walk
        here, there, own = self.numbers[:-1][on], self.numbers[1:][on], self.numbers[self.active]
        step = np.full(len(here), -walk)
        index = np.stack([np.concatenate([own, here, there]), np.concatenate([own, there, here])])
        return csc_array(_sparse(np.concatenate([diagonal[self.active], step, step]), index, len(own)) + self.gauge)

    def _walk(self, rate: float) -> tuple[float, FloatArray, FloatArray]:
        """Weight of a step of the walk, (s,) of zero at a knot, and (knots, s) of zero by so many knots beyond the last unknown."""
        walk, weak = 1 / (rate**2 * self.knots.spacing), 1 / (self.knots.count * self.weak_sd**2)
        beyond = np.zeros(self.active.shape)
        for m in range(1, self.knots.count):
            beyond[m] = 1 / (1 / walk + 1 / (weak + beyond[m - 1]))
        return walk, weak, beyond

    def _run_out(self, drifts: FloatArray, rate: float) -> None:
        """Set (knots, s, 3) drifts where strips have no unknowns to what the walk leads to from those they have."""
        walk, weak, beyond = self._walk(rate)
        share = (walk / (walk + weak + beyond))[:, :, None]
        for m in range(self.knots.count - 2, -1, -1):
            k = self.knots.count - 1 - m
            before, after = m < self.first, k > self.last
            drifts[m, before] = share[m, before] * drifts[m + 1, before]
            drifts[k, after] = share[m, after] * drifts[k - 1, after]

    def rate(self, height: float) -> tuple[float | None, float]:
        """Likeliest rate, None where strips are as likely stiff, and the gain of log-likelihood."""
        scale = height / np.sqrt(10 * height)
        stiff = self.log_likelihood(1e-3 * RATES[0] * scale)
        gains = [self.log_likelihood(r * scale) - stiff for r in RATES]
        best = int(np.argmax(gains))
        return (RATES[best] * scale, gains[best]) if gains[best] > GAIN else (None, gains[best])

    def log_likelihood(self, rate: float) -> float:
        """Restricted log-likelihood of a ``rate`` in metres per root metre, less what all rates have alike."""
        factor = BlockTridiagonal(csc_array(self.normal + self.prior(rate)), 3 * self.starts)
        # alike by axis
        prior = 3 * BlockTridiagonal(self._prior_of_axis(rate), self.starts).log_determinant()
        return float(0.5 * self.rhs @ factor.solve(self.rhs) - 0.5 * factor.log_determinant() + 0.5 * prior)

    def solve(self, rate: float, at: FloatArray) -> tuple[FloatArray, BlockTridiagonal]:
        """Change (knots, strips, 3) of drifts that are ``at`` their present values, and the factorised normal matrix."""
        prior = self.prior(rate)
        factor = BlockTridiagonal(csc_array(self.normal + prior), 3 * self.starts)
        drifts = at.copy()
        drifts[self.active] += factor.solve(self.rhs - prior @ at[self.active].ravel()).reshape(-1, 3)
        self._run_out(drifts, rate)
        return drifts - at, factor

    def cofactors(self, factor: BlockTridiagonal) -> dict[int, FloatArray]:
        """Covariance of the ``seen`` strips at the knots ``k`` and ``k + 1``, by ``k`` before any unit; (6 t, 6 t) each."""
        found = {}
        for k, block in factor.inverse_blocks():
            if k in self.seen:
                local = self._around(k, self.seen[k]) - 3 * self.starts[k]
                found[k] = block[np.ix_(local, local)]
        return found

    def mean_sds(self, cofactors: Mapping[int, FloatArray]) -> FloatArray:
        """(s, 3) root mean variance of every strip over the knots before units that see it."""
        total, count = np.zeros((len(self.strip_epoch), 3)), np.zeros((len(self.strip_epoch), 1))
        for k, strips in self.seen.items():
            total[strips] += np.diag(cofactors[k])[: 3 * len(strips)].reshape(-1, 3)
            count[strips] += 1
        return np.asarray(np.sqrt(total / count), dtype=np.float64)

    def lever(self, unit: int, strips: IntArray) -> FloatArray:
        """(3 t, 6 s) weights of the ``seen`` strips at the two knots around a unit in the drifts of some strips at its place."""
        seen = self.seen[int(self.knots.first[unit])]
        rows = np.zeros((3 * len(strips), 6 * len(seen)))
        for side, (_, weight) in enumerate(self.knots.weights(unit)):
            for t, place in enumerate(np.searchsorted(seen, strips)):
                start = 3 * (side * len(seen) + int(place))
                rows[3 * t : 3 * t + 3, start : start + 3] = weight * np.eye(3)
        return rows


def _sparse(values: FloatArray, index: IntArray, size: int) -> csc_array:
    """(size, size) matrix of the sums of values at (2, n) rows and columns."""
    return csc_array(coo_array((values, (index[0], index[1])), shape=(size, size)))
