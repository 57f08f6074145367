"""Points of single units that are read when they are asked for, so that a long coast needs no more memory than a short one."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray

Sources = NDArray[np.integer]
ReadCloud = tuple[FloatArray, Sources]
"""(n, 3) points in metres and their (n,) strips or stations."""


@dataclass(frozen=True, eq=False)
class HeldPoints:
    """(n, 3) points and (n,) sources that stay in memory, to be called for."""

    points: FloatArray
    sources: Sources

    def __call__(self) -> ReadCloud:
        """Points and sources."""
        return self.points, self.sources


@dataclass(frozen=True, eq=False)
class UnitCloud:
    """Points of one unit in one epoch.

    Attributes
    ----------
    ids
        (s,) the flight strips or stations they come from, ascending, each once; empty where there are no points.
    read
        Reads (n, 3) points in metres and their (n,) strips or stations, the same ones each time.
    home
        Where they are read from. Clouds with one home are read together at the cost of one: whoever needs many goes home by home
        (:func:`by_home`). Empty for points that are held in memory.
    """

    ids: Sources
    read: Callable[[], ReadCloud]
    home: tuple[int, ...] = ()

    @property
    def has_points(self) -> bool:
        """Whether there is anything to read."""
        return len(self.ids) > 0

    @classmethod
    def held(cls, points: FloatArray, sources: Sources) -> UnitCloud:
        """Cloud of (n, 3) points and (n,) sources that stay in memory."""
        return cls(np.unique(sources), HeldPoints(points, sources))

    @classmethod
    def none(cls) -> UnitCloud:
        """Of a unit of which only the fit is known."""
        return cls.held(np.empty((0, 3)), np.empty(0, dtype=np.uint16))


def by_home(groups: Iterable[tuple[int, tuple[UnitCloud, ...]]]) -> list[int]:
    """Keys of groups of clouds that are needed at once, in the order in which they are read with the fewest changes of home."""
    return [key for _, key in sorted((tuple(cloud.home for cloud in clouds), key) for key, clouds in groups)]
