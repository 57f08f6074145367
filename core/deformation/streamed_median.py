"""Medians of more numbers than memory should hold, given piece by piece."""

from __future__ import annotations

import math

import numpy as np

from ..common.arrays import FloatArray, IntArray

MOST_HELD = 500_000
"""Numbers that are held: more are counted, and those near the median held the next time they are given."""
MOST_BINS_LOG2 = 19
"""Bins that the rest is counted in, as a power of two; of all numbers, a bin is then 0.4 % wide."""
NEAR = 0.05
"""Relative distance from what the median is expected to be within which numbers are held at first."""
_INFINITY = 0x7FF0 << 48


class StreamedMedian:
    """Median of numbers >= 0, the same to the last bit as that of all at once.

    Give all numbers by :meth:`add`, then ask :meth:`settled`; where it says no, give them all once more. Up to ``most_held`` numbers
    settle at once and almost any others the second time, when all but those near the median are only counted. Many more settle at
    once if the median is about what it was ``expected`` to be.

    Parameters
    ----------
    expected
        About what the median will be, such as that of an earlier look at the same things; nan where nothing is known.
    most_held
        Numbers held at a time; ``held`` says how many are.

    Attributes
    ----------
    value
        The median once it is settled; nan where no numbers were given.
    """

    def __init__(self, expected: float = math.nan, *, most_held: int = MOST_HELD) -> None:
        self.value = math.nan
        self._most_held = most_held
        self._done = False
        self._parting: int | None = None
        self._neighbours = (0, _INFINITY)
        if expected > 0:
            first, last = np.array([expected * (1 - NEAR), expected * (1 + NEAR)]).view(np.int64)
            self._look_between(int(first), int(last))
        else:
            self._look_between(0, _INFINITY)

    def _look_between(self, first: int, last: int) -> None:
        """Start anew: only numbers with these patterns of bits matter, which for numbers >= 0 are in the order of the numbers."""
        self._first, self._last = first, last
        self._shift = max((last - first).bit_length() - MOST_BINS_LOG2, 0)
        self._below = self._count = self._inside = self.held = 0
        self._pieces: list[IntArray] = []
        self._bins: IntArray | None = None

    def add(self, numbers: FloatArray) -> None:
        """Take (n,) finite numbers >= 0; ignored once the median is known."""
        if self._done:
            return
        # a negative zero plus zero is a positive one
        bits = (np.asarray(numbers, dtype=np.float64) + 0.0).view(np.int64)
        if self._parting is not None:
            lower, upper = bits[bits < self._parting], bits[bits >= self._parting]
            self._neighbours = (
                max(self._neighbours[0], int(lower.max(initial=0))),
                min(self._neighbours[1], int(upper.min(initial=_INFINITY))),
            )
            return
        self._count += len(bits)
        self._below += int(np.sum(bits < self._first))
        self._pieces.append(bits[(bits >= self._first) & (bits < self._last)])
        self._inside += len(self._pieces[-1])
        self.held += len(self._pieces[-1])
        if self.held > self._most_held:
            self._bins = self._counted()

    def _counted(self) -> IntArray:
        """What is held, counted into bins and let go."""
        bins = np.bincount(
            (np.concatenate(self._pieces) - self._first) >> self._shift, minlength=-((self._first - self._last) >> self._shift)
        )
        self._pieces, self.held = [np.empty(0, dtype=np.int64)], 0
        return bins if self._bins is None else bins + self._bins

    def settled(self) -> bool:
        """Whether ``value`` is the median of what was given; otherwise all of it has to be given again."""
        if self._done or not self._count:
            self._done = True
            return True
        if self._parting is not None:
            return self._settle(np.array(self._neighbours))
        ranks = np.array([(self._count - 1) // 2, self._count // 2]) - self._below
        if ranks[0] < 0 or ranks[1] >= self._inside:
            # not where it was expected
            self._look_between(0, _INFINITY)
            return False
        if self._bins is None:
            return self._settle(np.sort(np.concatenate(self._pieces))[ranks])
        bins = np.searchsorted(np.cumsum(self._counted()), ranks, side="right")
        if self._shift == 0:
            return self._settle(self._first + bins)
        if bins[0] != bins[1]:
            # the median is the mean of the last number of one bin and the first of another
            self._parting = self._first + (int(bins[0]) + 1 << self._shift)
        else:
            first = self._first + (int(bins[0]) << self._shift)
            self._look_between(first, first + (1 << self._shift))
        return False

    def _settle(self, middle: IntArray) -> bool:
        self.value = float(np.mean(middle.view(np.float64)))
        self._done = True
        self._pieces = []
        return True
