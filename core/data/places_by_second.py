"""Where an instrument measured in each second: what tells the passes of a flight and the stations of a scanner without their numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..common.arrays import FloatArray, IntArray

MOST_SECONDS = 400_000
"""Seconds that are kept of a tile, some days: times that spread over more are no seconds."""


@dataclass(frozen=True, eq=False)
class PlacesBySecond:
    """Points counted by the second of their GPS time.

    Attributes
    ----------
    seconds
        (k,) whole seconds, ascending.
    counts
        (k,) points in each, or those that were looked at.
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
    def of(cls, times: FloatArray, places: FloatArray) -> PlacesBySecond:
        """Of points at (n, >= 2) places, metres, with their GPS times (n,): those without one are left out, and all where they are none."""
        known = np.isfinite(times)
        if not known.any():
            return cls.empty()
        whole = np.floor(times[known])
        first, last = whole.min(), whole.max()
        if last - first >= MOST_SECONDS:
            return cls.empty()
        numbers = (whole - first).astype(np.int64)
        counts = np.bincount(numbers)
        sums = np.column_stack([np.bincount(numbers, places[known, axis]) for axis in (0, 1)])
        occurs = np.flatnonzero(counts)
        return cls(occurs + int(first), counts[occurs], np.asarray(sums[occurs], dtype=np.float64))

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
