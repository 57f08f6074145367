"""Parts of a window near some places, for whoever needs little of a cloud: the rest is neither sorted nor held."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray
from .tiles import Window


@dataclass(frozen=True)
class WindowAround(Window):
    """The part of a rectangle near some places: what lies within ``reach`` metres of one of the (k, 2) ``places``, and a little more."""

    places: FloatArray = field(compare=False, repr=False)
    reach: float

    @classmethod
    def of(cls, window: Window, places: FloatArray, reach: float) -> WindowAround:
        """Of a rectangle, no larger than the places, at least one, need."""
        west, south = places[:, :2].min(axis=0) - reach
        east, north = places[:, :2].max(axis=0) + reach
        return cls(
            float(max(window.west, west)), float(max(window.south, south)), float(min(window.east, east)), float(min(window.north, north)),
            places[:, :2], reach,
        )  # fmt: skip

    @cached_property
    def _near(self) -> NDArray[np.bool_]:
        """Square cells of half the reach that hold points within it."""
        size = np.maximum(np.ceil(np.subtract((self.east, self.north), (self.west, self.south)) / (0.5 * self.reach)), 0).astype(np.int64)
        near = np.zeros(size + 1, dtype=np.bool_)
        for e, n in np.floor((self.places - (self.west, self.south)) / (0.5 * self.reach)).astype(np.int64):
            near[max(e - 2, 0) : max(e + 3, 0), max(n - 2, 0) : max(n + 3, 0)] = True
        return near

    def contains(self, points: FloatArray) -> NDArray[np.bool_]:
        """(n,) whether (n, >= 2) positions lie inside."""
        inside = super().contains(points)
        cells = self._cells(points[inside])
        inside[inside] = self._near[cells[:, 0], cells[:, 1]]
        return inside

    def meets(self, low: Sequence[float], high: Sequence[float]) -> bool:
        """Whether an extent from (e, n) ``low`` to ``high``, both included, has a place in common with the window."""
        if not super().meets(low, high):
            return False
        corners = np.clip([low[:2], high[:2]], (self.west, self.south), (self.east, self.north))
        first, last = self._cells(corners)
        return bool(self._near[first[0] : last[0] + 1, first[1] : last[1] + 1].any())

    def _cells(self, points: FloatArray) -> NDArray[np.int64]:
        return np.asarray((points[:, :2] - (self.west, self.south)) / (0.5 * self.reach), dtype=np.int64)
