"""Arrows of displacements on the report's maps: enlarged by one factor, and the longest cut short, which is told."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..common.arrays import BoolArray, FloatArray
from ..results.unit_rows import UnitRow

USUAL_HEIGHT = 2.0
"""Height H in metres of units of which none is known."""
TYPICAL, LONGEST = 1.2, 4.0
"""Length of the median arrow, and of the longest, in heights of a unit: a longer one would cross the map."""


@dataclass(frozen=True, eq=False)
class Arrows:
    """Arrows of the units that moved significantly.

    Attributes
    ----------
    times
        Factor by which displacements are enlarged, at least 1.
    starts, shown
        (n, 2) easting and northing of the beginnings, and vectors as drawn, metres on the map.
    cut
        (n,) whether an arrow is shorter than its displacement enlarged.
    """

    times: float
    starts: FloatArray
    shown: FloatArray
    cut: BoolArray


def displacement_arrows(rows: Sequence[UnitRow]) -> Arrows:
    """Arrows for the significant horizontal displacements of ``rows``.

    A unit that was carried farther than the longest arrow keeps the true length of its way.
    """
    moved = [(row.place, row.vector) for row in rows if row.significant and row.place is not None and row.vector is not None]
    starts = np.array([place for place, _ in moved]).reshape(-1, 3)[:, :2]
    vectors = np.array([vector for _, vector in moved]).reshape(-1, 3)[:, :2]
    lengths = np.linalg.norm(vectors, axis=1)
    height = usual_height(rows)
    typical = float(np.median(lengths)) if len(lengths) else 0.0
    times = max(1.0, nearest_round(TYPICAL * height / typical)) if typical > 0 else 1.0
    most = np.maximum(LONGEST * height, lengths)
    cut = times * lengths > most * (1 + 1e-9)
    factors = np.where(cut, most / np.where(lengths > 0, lengths, 1.0), times)
    return Arrows(times, starts, vectors * factors[:, None], cut)


def usual_height(rows: Sequence[UnitRow]) -> float:
    """Median height H of units, metres."""
    heights = [row.height for row in rows if row.height]
    return float(np.median(heights)) if heights else USUAL_HEIGHT


def nearest_round(value: float) -> float:
    """The nearest of 1, 2, 5 times a power of ten, by their ratio, to a positive value."""
    power = 10.0 ** np.floor(np.log10(value))
    steps = [factor * power for factor in (1, 2, 5, 10)]
    return float(min(steps, key=lambda step: abs(np.log(step / value))))
