"""Where an instrument measured in each second: what tells the passes of a flight and the stations of a scanner without their numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..common.arrays import FloatArray, IntArray

MOST_TIME = 2.0**53
"""Seconds beyond which a number is no time: what nobody wrote may be anything."""


@dataclass(frozen=True, eq=False)
class PlacesBySecond:
    """Points counted by the second of their GPS time.

    Attributes
    ----------
    seconds
        (k,) whole seconds, ascending.
    counts
        (k,) points in each.
    sums
        (k, 2) sums of their eastings and northings, metres.
    """

    seconds: IntArray
    counts: IntArray
    sums: FloatArray

    @classmethod
    def empty(cls) -> PlacesBySecond:
        """Of no point."""
        return cls(np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64), np.zeros((0, 2)))

    @classmethod
    def of(cls, times: FloatArray, places: FloatArray, each: int = 1) -> PlacesBySecond:
        """Of points at (n, >= 2) places, metres, with GPS times (n,); every one stands for ``each`` so many, those without for none."""
        known = np.isfinite(times) & (np.abs(times) < MOST_TIME)
        seconds, numbers, counts = np.unique(np.floor(times[known]).astype(np.int64), return_inverse=True, return_counts=True)
        sums = [np.bincount(numbers, places[known, axis], minlength=len(seconds)) for axis in (0, 1)]
        return cls(seconds, each * counts, each * np.column_stack(sums).astype(np.float64))

    @classmethod
    def merged(cls, parts: Sequence[PlacesBySecond]) -> PlacesBySecond:
        """Of the points of several together."""
        seconds, numbers = np.unique(np.concatenate([part.seconds for part in parts]), return_inverse=True)
        counts, sums = np.zeros(len(seconds), dtype=np.int64), np.zeros((len(seconds), 2))
        np.add.at(counts, numbers, np.concatenate([part.counts for part in parts]))
        np.add.at(sums, numbers, np.concatenate([part.sums for part in parts]))
        return cls(seconds, counts, sums)

    @property
    def places(self) -> FloatArray:
        """(k, 2) mean place of each second, metres."""
        return np.asarray(self.sums / self.counts[:, None])
