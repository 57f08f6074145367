"""Where the points of a tile really are, whatever its header says; what is told of strays and of an extent that is stale."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import BoolArray, FloatArray, corners
from ..common.errors import Cancelled, InputError
from ..common.patch_means import Means
from . import scan_cache, thinned_clouds
from .las_files import LasHeader, chunks_of, open_points, positions
from .occupancy import Occupancy, merged, stray_cells
from .places_by_second import PlacesBySecond
from .scan_cache import Scan
from .thinned_clouds import Thinning

NOISE_CLASSES = (7, 18)
"""ASPRS classes low and high noise (LAS 1.4 R15, table 17)."""
TIMED_POINTS = 20_000
"""Points of a chunk, evenly spread over it, that say where it was measured in each second."""
STALE_METRES = 10.0
"""A header whose extent is so much larger than that of the points, in one direction, is worth a word."""


def scanned(
    header: LasHeader,
    apply: Callable[[FloatArray], FloatArray] | None,
    crs: str,
    level: int,
    is_cancelled: Callable[[], bool],
    radius: float = 0.0,
) -> Scan:
    """Look at every point of a tile once; what was found is remembered as long as the file stays as it is.

    With ``radius`` (metres) a tile that is dense beyond use is thinned to patches of it in the same go; the means are kept too.
    """
    key = scan_cache.key_of(header.path, f"{level} {crs} {radius!r}")
    known = scan_cache.load(key)
    if known is not None and (not known.thinned or thinned_clouds.load(key) is not None):
        return known
    scan, means = looked_through(header, apply, level, is_cancelled, radius)
    # means that cannot be kept would have to be formed again by every reader
    if means is not None and thinned_clouds.store(key, means):
        scan = replace(scan, thinned=key, means=len(means.xyz))
    scan_cache.store(key, scan)
    return scan


def looked_through(
    header: LasHeader, apply: Callable[[FloatArray], FloatArray] | None, level: int, is_cancelled: Callable[[], bool], radius: float
) -> tuple[Scan, Means | None]:
    """What a look at every point of a tile finds, and its thinned points where it is dense beyond use; see :func:`scanned`."""
    extents = np.full((4, 3), np.inf)
    parts = [Occupancy.empty(level)]
    times = np.array([np.inf, -np.inf])
    occurs = np.zeros(1 << 16, dtype=np.bool_)
    by_second = PlacesBySecond.empty()
    thinning = Thinning(radius, header.count)
    with open_points(header) as reader:
        for chunk in chunks_of(reader, header):
            if is_cancelled():
                raise Cancelled("cancelled while reading")
            xyz = positions(chunk, header.path)
            if not len(xyz):
                continue
            low, high = corners(xyz)
            extents[0], extents[1] = np.minimum(extents[0], low), np.minimum(extents[1], -high)
            keep = usable(chunk)
            sources, seconds = point_records(chunk, header, keep)
            occurs[sources] = True
            if header.has_time:
                known = seconds[np.isfinite(seconds)]
                if len(known):
                    times = np.array([min(times[0], known.min()), max(times[1], known.max())])
            used = xyz if keep.all() else xyz[keep]
            if apply is not None:
                used = apply(used)
                finite = np.isfinite(used).all(axis=1)
                used, sources, seconds = used[finite], sources[finite], seconds[finite]
            if len(used):
                low, high = (low, high) if used is xyz else corners(used)
                extents[2], extents[3] = np.minimum(extents[2], low), np.minimum(extents[3], -high)
                parts = [merged([*parts, Occupancy.of(used, level)]).bounded()]
                thinning.add(used, sources, np.nan_to_num(seconds))
                if header.has_time:
                    each = 1 + len(used) // TIMED_POINTS
                    by_second = PlacesBySecond.merged([by_second, PlacesBySecond.of(seconds[::each], used[::each], each)])
    scan = Scan(extents[0], -extents[1], extents[2], -extents[3], parts[0], times, np.flatnonzero(occurs), by_second)
    return scan, thinning.means()


def point_records(chunk: Any, header: LasHeader, keep: BoolArray) -> tuple[NDArray[np.uint16], FloatArray]:
    """Source IDs and GPS times of the chosen points of a chunk; zero where the tile has no times."""
    sources = np.asarray(chunk.point_source_id, dtype=np.uint16)[keep]
    return sources, np.asarray(chunk.gps_time, dtype=np.float64)[keep] if header.has_time else np.zeros(len(sources))


def main_part(scan: Scan) -> tuple[FloatArray, FloatArray]:
    """Lowest and highest corner of a tile's points without strays, to metres."""
    if not len(scan.cells.cells):
        return scan.raw_low, scan.raw_high
    low, high = scan.cells.select(~stray_cells(scan.cells)).box()
    return np.maximum(low, scan.low), np.minimum(high, scan.high)


def said_of_extent(header: LasHeader, scan: Scan) -> str:
    """A sentence where the extent that the header gives is not that of the points; empty where it is.

    Raises
    ------
    InputError
        Some points lie outside of it and some within, as in a damaged file.
    """
    given_low, given_high, name = header.low, header.high, header.path.name
    if (given_low > given_high).any() or not np.isfinite([given_low, given_high]).all() or (not given_low.any() and not given_high.any()):
        return f"{name}: its header gives no extent; that of its points is taken"
    slack = np.maximum(2 * header.scales, _rounding(np.concatenate([given_low, given_high]))) + 1e-9
    if not ((scan.raw_low < given_low - slack) | (scan.raw_high > given_high + slack)).any():
        beyond = np.maximum(scan.raw_low - given_low, given_high - scan.raw_high).max()
        larger = f"{name}: its header gives an extent {beyond:.0f} m larger than that of its points, which is taken"
        return "" if beyond < STALE_METRES else larger
    shift = scan.raw_low - given_low
    if (np.abs(scan.raw_high - given_high - shift) <= 2 * slack).all():
        moved = ", ".join(f"{value:.2f}" for value in shift)
        return f"{name}: its points lie ({moved}) m beside the extent its header gives, as if it had been moved; their own extent is taken"
    if ((scan.raw_low > given_high + slack) | (scan.raw_high < given_low - slack)).any():
        return f"{name}: none of its points lie in the extent its header gives; their own extent is taken"
    raise InputError(
        "holds points outside the extent its header gives",
        source=header.path,
        remedy="If the file is sound, mend its header (lasinfo -repair, or pdal translate in.laz out.laz); else copy it again.",
    )


def _rounding(values: FloatArray) -> float:
    """Step that all values of an extent are rounded to, metres; 0 where they are not."""
    for step in (1.0, 0.1, 0.01):
        if (np.abs(values / step - np.round(values / step)) < 1e-6).all():
            return step
    return 0.0


def usable(chunk: Any) -> BoolArray:
    """(n,) points that are neither classed as noise nor withheld."""
    keep: BoolArray = ~np.isin(np.asarray(chunk.classification), NOISE_CLASSES)
    if "withheld" in set(chunk.point_format.dimension_names):
        keep &= np.asarray(chunk.withheld) == 0
    return keep
