"""Drifts of flight strips and stations along the structure, beyond their constant offsets.

The deviation of a strip from its offset is a random walk over knots along the structure, interpolated linearly between them: what a
trajectory does within a survey, whatever the times of its points. Its rate is learned by restricted maximum likelihood from the
normal equations of the units, which see every strip where they overlap; without a clear gain strips stay stiff. What all strips of an
epoch do alike at a place cannot be told here and belongs to the frame: their mean is held at zero knot by knot.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csc_array, diags_array, eye_array, kron
from scipy.sparse.linalg import SuperLU, splu

from ..common.arrays import FloatArray, IntArray, upper_triangle
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
        self.knots, self.strips = knots, len(strip_epoch)
        self.places = places
        self.size = 3 * self.strips * knots.count
        self.strip_epoch, self.weak_sd = strip_epoch, weak_sd
        self.rhs = np.zeros(self.size)
        seen = np.zeros((knots.count, self.strips))
        spans: dict[int, list[UnitEquations]] = {}
        for own in equations:
            spans.setdefault(int(knots.first[own.unit]), []).append(own)
            for k, w in knots.weights(own.unit):
                self.rhs[self.columns(k, own.strips)] += w * own.rhs
                seen[k, own.strips] += w
        self.seen = {k: np.unique(np.concatenate([own.strips for own in members])) for k, members in sorted(spans.items())}
        index, values = [np.zeros((2, 0), dtype=np.int64)], [np.zeros(0)]
        for k, strips in self.seen.items():
            block = self._between(spans[k], strips)
            around = self._around(k, strips)
            index.append(np.stack([np.repeat(around, len(around)), np.tile(around, len(around))]))
            values.append(block.ravel())
        where = np.hstack(index)
        self.normal = csc_array(coo_array((np.concatenate(values), (where[0], where[1])), shape=(self.size, self.size)))
        self.gauge = self._gauge(seen)

    def _between(self, members: Sequence[UnitEquations], strips: IntArray) -> FloatArray:
        """(6 t, 6 t) normal matrix of t strips at two knots that follow each other, of all units between these.

        Units are added up before they go into the sparse matrix: their own entries are a hundred times as many as those of the sum.
        """
        half = 3 * len(strips)
        total = np.zeros((2 * half, 2 * half))
        for own in members:
            local = (3 * np.searchsorted(strips, own.strips)[:, None] + np.arange(3)).ravel()
            normal = own.normal
            for i, (_, w) in enumerate(self.knots.weights(own.unit)):
                for j, (_, v) in enumerate(self.knots.weights(own.unit)):
                    total[np.ix_(i * half + local, j * half + local)] += w * v * normal
        return total

    def _around(self, knot: int, strips: IntArray) -> IntArray:
        """Unknowns of some strips at a knot and at the one after it."""
        return np.concatenate([self.columns(knot, strips), self.columns(knot + 1, strips)])

    def columns(self, knot: int, strips: IntArray) -> IntArray:
        """Unknowns of some strips at a knot."""
        return np.asarray((3 * (knot * self.strips + strips)[:, None] + np.arange(3)).ravel(), dtype=np.int64)

    def _gauge(self, seen: FloatArray) -> csc_array:
        """Condition that the strips of an epoch that are seen at a knot drift by zero in the mean, weighted by how much of them is seen."""
        rows, columns, values = [], [], []
        strong = GAUGE_WEIGHT / float(np.median(self.weak_sd)) ** 2
        epochs = [np.flatnonzero(self.strip_epoch == epoch) for epoch in np.unique(self.strip_epoch)]
        for knot in range(self.knots.count):
            for number, own in enumerate(epochs):
                total = seen[knot, own].sum()
                share = seen[knot, own] / total if total > 0 else np.full(len(own), 1 / len(own))
                rows.append(np.full(len(own), knot * len(epochs) + number))
                columns.append(knot * self.strips + own)
                values.append(share)
        shape = (self.knots.count * len(epochs), self.knots.count * self.strips)
        matrix = csc_array(coo_array((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), shape=shape))
        return csc_array(kron(strong * (matrix.T @ matrix), eye_array(3)))

    def prior(self, rate: float) -> csc_array:
        """Weight matrix of the walk with a ``rate`` in metres per root metre, and of the weak pseudo-observations of zero."""
        count = self.knots.count
        steps = diags_array([-np.ones(count - 1), np.ones(count - 1)], offsets=[0, 1], shape=(count - 1, count))
        walk = (steps.T @ steps) / (rate**2 * self.knots.spacing)
        weak = np.tile(1 / (count * self.weak_sd**2), count)
        return csc_array(kron(kron(walk, eye_array(self.strips)), eye_array(3)) + diags_array(np.repeat(weak, 3)) + self.gauge)

    def rate(self, height: float) -> tuple[float | None, float]:
        """Likeliest rate, None where strips are as likely stiff, and the gain of log-likelihood."""
        scale = height / np.sqrt(10 * height)
        stiff = self._log_likelihood(1e-3 * RATES[0] * scale)
        gains = [self._log_likelihood(r * scale) - stiff for r in RATES]
        best = int(np.argmax(gains))
        return (RATES[best] * scale, gains[best]) if gains[best] > GAIN else (None, gains[best])

    def _log_likelihood(self, rate: float) -> float:
        prior = self.prior(rate)
        factor = splu(csc_array(self.normal + prior))
        return float(0.5 * self.rhs @ factor.solve(self.rhs) - 0.5 * _log_determinant(factor) + 0.5 * _log_determinant(splu(prior)))

    def solve(self, rate: float, at: FloatArray) -> tuple[FloatArray, SuperLU]:
        """Change (knots, strips, 3) of drifts that are ``at`` their present values, and the factorised normal matrix."""
        prior = self.prior(rate)
        factor = splu(csc_array(self.normal + prior))
        change = factor.solve(self.rhs - prior @ at.ravel())
        return change.reshape(self.knots.count, self.strips, 3), factor

    def cofactors(self, factor: SuperLU) -> dict[int, FloatArray]:
        """Covariance of the ``seen`` strips at the knots ``k`` and ``k + 1``, by ``k`` before any unit; (6 t, 6 t) each."""
        found = {}
        for k, strips in self.seen.items():
            columns = self._around(k, strips)
            unit = np.zeros((self.size, len(columns)))
            unit[columns, np.arange(len(columns))] = 1
            found[k] = np.asarray(factor.solve(unit)[columns])
        return found

    def mean_sds(self, cofactors: Mapping[int, FloatArray]) -> FloatArray:
        """(s, 3) root mean variance of every strip over the knots before units that see it."""
        total, count = np.zeros((self.strips, 3)), np.zeros((self.strips, 1))
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


def _log_determinant(factor: SuperLU) -> float:
    return float(np.sum(np.log(np.abs(factor.U.diagonal()))))
