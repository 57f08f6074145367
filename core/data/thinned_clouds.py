"""Clouds denser than their noise makes useful, thinned while a tile is looked through, and kept as means of patches in the user's cache.

Residuals of one surface are alike over some hundredths of a unit's height (:mod:`..adjustment.residual_correlation`), so that points
closer together say nothing new but for their white noise, which a mean keeps. Whatever reads a tile then reads the means.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray, IntArray, corners
from ..common.atomic_files import temporary_beside
from ..common.errors import InputError, OutputError
from ..common.patch_means import Means, PatchMeans
from ..common.user_cache import cache_folder, drop_unused
from .las_files import read_header

RADIUS_RATIO, MOST_RADIUS_RATIO = 0.0125, 0.03
"""Least radius of the patches that means are taken of, as a share of the unit's height: half the edge of the elements in which units are
looked for, and a third of the length over which residuals of one surface are usually alike; and the largest."""
RADIUS_IN_NOISE = 6.0
"""The radius in standard deviations of the noise across the surface, if that is more: in smaller patches noise decides to which of them a
point goes, and means become noisier than those of so many points are (by 13 % at 5, by 5 % at 7)."""
LEAST_POINTS = 16
"""A tile is thinned where a patch has so many points or more; below that, reading all costs little."""
LARGE = 2_000_000
"""Points of a cloud from which it is thinned: less takes little time as it is, and a weak unit may depend on any of its points."""
PART = 100_000
"""Points after which it is asked anew whether a tile can be so dense."""
SQUARE_RADII = 40.0
"""Edge, in radii of patches, of the squares whose points are taken in one square after another: the patches of one stay in the processor's
cache, which takes almost half of the time off."""


def patch_radius(height: float) -> float:
    """Least radius of patches for units of a height in metres."""
    return RADIUS_RATIO * height


def is_large(paths: Sequence[Path]) -> bool:
    """Whether tiles hold so many points together that thinning them saves time; those that cannot be read count as empty."""
    total = 0
    for path in paths:
        with contextlib.suppress(InputError, OutputError):
            total += read_header(path).count
        if total >= LARGE:
            return True
    return False


class Thinning:
    """Means of a tile under way, given up as soon as the tile is seen not to be dense enough.

    Parameters
    ----------
    radius
        Least one of a patch, metres; 0 thins nothing. It grows with the noise of the first points.
    total
        Points of the tile.
    """

    def __init__(self, radius: float, total: int) -> None:
        self.radius = radius
        self._patches: PatchMeans | None = PatchMeans(radius, total) if radius else None
        self._total = total
        self._points = 0

    def add(self, xyz: FloatArray, sources: NDArray[np.uint16], times: FloatArray) -> None:
        """Take in (n, 3) points with their sources and times (n,)."""
        self._add(xyz, sources, times)
        if self._points == 0 and self._patches is not None:
            wide = PatchMeans(MOST_RADIUS_RATIO / RADIUS_RATIO * self.radius)
            wide.add(xyz, sources, times)
            wanted = min(RADIUS_IN_NOISE * wide.noise(), wide.radius)
            if wanted > self.radius:
                self.radius = wanted
                self._patches = PatchMeans(wanted, self._total)
                self._add(xyz, sources, times)
        self._points += len(xyz)

    def _add(self, xyz: FloatArray, sources: NDArray[np.uint16], times: FloatArray) -> None:
        for start in range(0, len(xyz), PART):
            if self._patches is None:
                return
            order = start + _by_square(xyz[start : start + PART], SQUARE_RADII * self.radius)
            self._patches.add(xyz[order], sources[order], times[order])
            if self._total < LEAST_POINTS * self._patches.count:
                self._patches = None

    def means(self) -> Means | None:
        """The means, or None where patches have too few points."""
        if self._patches is None or not self._points or self._points < LEAST_POINTS * self._patches.count:
            return None
        return self._patches.means()


def _by_square(xyz: FloatArray, edge: float) -> IntArray:
    """(n,) numbers of (n, 3) points, one square in plan after another, and as they come within each."""
    place = np.floor(xyz[:, :2] / edge).astype(np.int64)
    low, high = corners(place)
    number = (place[:, 0] - low[0]) * (high[1] - low[1] + 1) + place[:, 1] - low[1]
    # numpy sorts short numbers in a fraction of the time
    return np.argsort(number.astype(np.uint16) if number.max() < 1 << 16 else number, kind="stable")


def load(key: str) -> Means | None:
    """Means kept under a key; None where there are none or they are damaged."""
    folder = cache_folder("thinned")
    return None if folder is None else means_in(folder / f"{key}.npz")


@lru_cache(maxsize=2)
def means_in(path: Path) -> Means | None:
    """Means of a file, those of the latest ones remembered; None where it is missing or damaged."""
    try:
        os.utime(path)
        # opened here: numpy forgets to close a file in which it finds no archive
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as kept:
            return Means(**{name: kept[name] for name in ("xyz", "counts", "spread", "sources", "times")})
    except Exception:
        # a damaged archive raises whatever its bytes lead to
        return None


def store(key: str, means: Means) -> bool:
    """Keep means under a key; tells whether that was possible."""
    folder = cache_folder("thinned")
    if folder is None:
        return False
    drop_unused(folder, "*.npz")
    path = folder / f"{key}.npz"
    try:
        with temporary_beside(path) as temporary:
            with temporary.open("wb") as stream:
                np.savez(stream, **vars(means))
            temporary.replace(path)
    except (OSError, OutputError):
        return False
    means_in.cache_clear()
    return True
