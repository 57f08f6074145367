"""LAS, LAZ and COPC tiles: looked through before any work, points read by chunks inside a window.

What a header says of the extent is compared with the points, which are counted in coarse cells: blocks are laid out where points are.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray, in_box
from ..common.errors import Cancelled, InputError
from . import thinned_clouds
from .crs import TileTransform, crs_text, parse_crs, resolved_crs, tile_transform, vertical_name
from .las_crs import declared_crs
from .las_files import LasHeader, chunks_of, copc_chunks, open_points, positions, read_header
from .occupancy import Occupancy, merged, stray_cells
from .places_by_second import PlacesBySecond
from .repeated_points import by_place, second_copies
from .scan_cache import Scan
from .tile_extent import looked_through, main_part, point_records, said_of_extent, scanned, usable

Corner = tuple[float, float, float]

DEFAULT_LEVEL = 2
"""Cells of 4 m where nothing is known of the units."""


@dataclass(frozen=True)
class Window:
    """Half-open rectangle of the survey CRS, metres: west <= easting < east, south <= northing < north."""

    west: float
    south: float
    east: float
    north: float

    def grown(self, by: float) -> Window:
        """The rectangle with a margin on all sides."""
        return Window(self.west - by, self.south - by, self.east + by, self.north + by)

    def contains(self, points: FloatArray) -> NDArray[np.bool_]:
        """(n,) whether (n, >= 2) positions lie inside."""
        e, n = points[:, 0], points[:, 1]
        return np.asarray((e >= self.west) & (e < self.east) & (n >= self.south) & (n < self.north))

    def meets(self, low: Sequence[float], high: Sequence[float]) -> bool:
        """Whether an extent from (e, n) ``low`` to ``high``, both included, has a place in common with the window."""
        return bool(low[0] < self.east and high[0] >= self.west and low[1] < self.north and high[1] >= self.south)


@dataclass(frozen=True, kw_only=True)
class TileInfo:
    """What is known of a tile after it was looked through.

    Attributes
    ----------
    path
        The file.
    points
        Number of points promised by the header, and there.
    low, high
        Extent e, n, h of the points that are used, in the survey's CRS, metres.
    version, point_format
        LAS version and point data format.
    compressed, copc
        Whether the points are LAZ chunks, and whether they are indexed as a cloud-optimised point cloud.
    crs
        The CRS of its coordinates as survey.toml takes it, empty where there is none.
    has_time
        Points carry GPS time.
    size
        Bytes of the file.
    note
        What was done to bring the tile into the survey's CRS; empty where nothing was.
    remarks
        What else is odd about the file and how it was taken, one sentence each.
    dropped
        Points left out because they are classed as noise or withheld.
    unread
        Points that the file seems to hold behind those that its header counts.
    strays
        Points left out because they lie far from all others.
    definition
        CRS of its coordinates as WKT, empty where there is none.
    heights
        Height system of its coordinates, empty where none is stated.
    bounds
        Lowest and highest corner of all its points in its own CRS; None where they were not looked at.
    main
        The same without stray points: where transformations are judged.
    resolution
        Least step of its coordinates, metres.
    cells
        Where the points that are used are, in the survey's CRS; None where they were not looked at.
    times
        First and last GPS time of these; infinity and its negative where they have none.
    sources
        Point source IDs that occur among them.
    by_second
        Where they were measured in each second.
    strip_starts
        GPS times at which strips begin, where those of the points' own numbers are none (:mod:`.strip_numbers`); None where they are.
    thinned, patch, means
        Of a tile that is denser than is of use: the key of its thinned points (:mod:`.thinned_clouds`), the radius of the patches, metres,
        and their number. Whoever reads the tile reads these.
    """

    path: Path
    points: int
    low: tuple[float, float, float]
    high: tuple[float, float, float]
    version: str
    point_format: int
    compressed: bool
    copc: bool
    crs: str
    has_time: bool
    size: int
    note: str
    remarks: tuple[str, ...] = ()
    dropped: int = 0
    unread: int = 0
    strays: int = 0
    definition: str = ""
    heights: str = ""
    bounds: tuple[Corner, Corner] | None = None
    main: tuple[Corner, Corner] | None = None
    resolution: float = 0.001
    cells: Occupancy | None = field(default=None, compare=False, repr=False)
    times: tuple[float, float] = (math.inf, -math.inf)
    sources: tuple[int, ...] = ()
    by_second: PlacesBySecond = field(default_factory=PlacesBySecond.empty, compare=False, repr=False)
    strip_starts: tuple[float, ...] | None = None
    thinned: str = ""
    patch: float = 0.0
    means: int = 0

    @property
    def held(self) -> int:
        """Points that reading it gives: those that are used, or the means that stand for them."""
        return self.means if self.thinned else self.used

    @property
    def used(self) -> int:
        """Points that are used."""
        return self.points - self.dropped - self.strays

    @property
    def density(self) -> float:
        """Points per square metre of the extent."""
        return self.points / max((self.high[0] - self.low[0]) * (self.high[1] - self.low[1]), 1e-6)

    def strips_of(self, source_id: NDArray[np.uint16], gps_time: FloatArray) -> NDArray[np.uint16]:
        """(n,) numbers of the strips or stations of points with source IDs and GPS times (n,) as in the file; 0 where there is none."""
        if self.strip_starts is None:
            return source_id
        return np.searchsorted(np.array(self.strip_starts), np.nan_to_num(gps_time), side="right").astype(np.uint16)


@dataclass(frozen=True, eq=False)
class PointCloud:
    """Points of one epoch inside a window.

    Attributes
    ----------
    xyz
        (n, 3) metres, less ``origin``.
    origin
        (3,) reduction point: easting, northing, height in the survey's CRS.
    source_id
        (n,) uint16, flight strip or scanner station (LAS point source ID).
    gps_time
        (n,) seconds as in the file; zero where the tiles have none.
    spread
        (n,) variance along the surface of the points that each is the mean of, square metres; None where all are points as they were
        measured.
    """

    xyz: FloatArray
    origin: FloatArray
    source_id: NDArray[np.uint16]
    gps_time: FloatArray
    spread: FloatArray | None = None

    def __len__(self) -> int:
        return len(self.xyz)

    def select(self, keep: NDArray[Any]) -> PointCloud:
        """The points of a mask or of indices."""
        spread = None if self.spread is None else self.spread[keep]
        return PointCloud(self.xyz[keep], self.origin, self.source_id[keep], self.gps_time[keep], spread)


def inspect_tile(
    path: str | Path,
    survey_crs: str | None,
    *,
    tiles_crs: str | None = None,
    undeclared_crs: str | None = None,
    level: int = DEFAULT_LEVEL,
    patch: float = 0.0,
    is_cancelled: Callable[[], bool] = lambda: False,
) -> TileInfo:
    """Look through a tile: its header, its CRS, and where its points are.

    Parameters
    ----------
    path
        LAS, LAZ or COPC file.
    survey_crs
        CRS of the survey as in survey.toml; None takes the tile as it is, whatever its CRS.
    tiles_crs
        CRS that overrules what the header declares.
    undeclared_crs
        CRS where the header declares none that can be understood.
    level
        Size of the cells in which points are counted: 2 ** level metres.
    patch
        Radius of the patches, metres, whose means stand for the points of a tile that is denser than is of use; 0 thins none.
    is_cancelled
        Asked between chunks.

    Returns
    -------
    A tile without points that could be used has ``used`` 0 and no CRS is asked of it.

    Raises
    ------
    InputError
        The file is missing, unreadable, not LAS, truncated or damaged.
    CrsError
        Its CRS is missing or cannot be used.
    """
    source = Path(path)
    header = read_header(source)
    remarks = [header.note] if header.note else []
    if header.unread:
        seems = header.count + header.unread
        remarks.append(f"{source.name}: its header counts {header.count} points, the file seems to hold {seems}; those behind are not read")
    if header.count == 0:
        return _tile_of(header, None, TileTransform(None), remarks)
    declared = declared_crs(header)
    if declared.other and tiles_crs is None:
        remarks.append(f"{source.name}: its header declares {declared.name} and {declared.other}; the former is taken")
    if survey_crs is None and tiles_crs is None:
        crs = declared.crs
        remarks += [f"{source.name}: {declared.problem}"] if declared.problem else []
    else:
        crs, said = resolved_crs(declared, tiles_crs, undeclared_crs, source=source)
        remarks += [said] if said else []
    scan = scanned(header, None, "", level, is_cancelled, patch)
    said = said_of_extent(header, scan)
    remarks += [said] if said else []
    main = main_part(scan)
    transform = TileTransform(None) if survey_crs is None else tile_transform(crs, survey_crs, _corners(*main), source=source)
    tile = replace(
        _tile_of(header, scan, transform, remarks),
        crs=crs_text(crs),
        definition="" if crs is None else str(crs.to_wkt()),
        heights=vertical_name(crs),
        bounds=(_corner(scan.raw_low), _corner(scan.raw_high)),
        main=(_corner(main[0]), _corner(main[1])),
        patch=patch,
    )
    if transform.apply is None:
        return tile
    there = scanned(header, transform.apply, f"{tile.definition} {survey_crs}", level, is_cancelled, patch)
    dropped = header.count - there.cells.points
    tile = replace(tile, low=_corner(there.low), high=_corner(there.high), cells=there.cells, dropped=dropped)
    return replace(tile, thinned=there.thinned, means=there.means)


def without_strays(tiles: Sequence[TileInfo], survey_crs: str, is_cancelled: Callable[[], bool] = lambda: False) -> tuple[TileInfo, ...]:
    """Tiles of one cloud without the few points that lie far from all others; their extents are those of what is left.

    Raises
    ------
    InputError
        A tile changed meanwhile.
    """
    known = [tile for tile in tiles if tile.cells is not None]
    if not known or len(known) < len(tiles):
        return tuple(tiles)
    site = merged([tile.cells for tile in tiles if tile.cells is not None])
    stray = {(int(e), int(n), int(h)) for e, n, h in site.cells[stray_cells(site)]}
    return tuple(_kept(tile, survey_crs, site.level, stray, is_cancelled) for tile in tiles) if stray else tuple(tiles)


def _kept(tile: TileInfo, survey_crs: str, level: int, stray: set[tuple[int, int, int]], is_cancelled: Callable[[], bool]) -> TileInfo:
    """A tile without the points in stray cells of a level."""
    if tile.cells is None:
        return tile
    cells = tile.cells.coarser(level)
    gone = np.array([(int(e), int(n), int(h)) in stray for e, n, h in cells.cells], dtype=np.bool_)
    if not gone.any():
        return tile
    left = cells.select(~gone)
    strays = int(cells.counts[gone].sum())
    if not len(left.cells):
        return replace(tile, cells=left, strays=strays)
    low, high = left.box()
    trimmed = replace(tile, cells=left, strays=strays, low=_corner(np.maximum(low, tile.low)), high=_corner(np.minimum(high, tile.high)))
    # cells tell the place of a point to metres; the extent that blocks are laid out from is that of the points themselves
    lows, highs = [], []
    for xyz in used_points(trimmed, survey_crs, is_cancelled):
        if len(xyz):
            lows.append(xyz.min(axis=0))
            highs.append(xyz.max(axis=0))
    return replace(trimmed, low=_corner(np.min(lows, axis=0)), high=_corner(np.max(highs, axis=0))) if lows else trimmed


def transform_of(tile: TileInfo, survey_crs: str) -> Callable[[FloatArray], FloatArray] | None:
    """How (n, 3) coordinates of a tile come into the survey's CRS; None where they are the same."""
    crs = parse_crs(tile.definition) if tile.definition else None
    return tile_transform(crs, survey_crs, _corners(*(tile.main or (tile.low, tile.high))), source=tile.path).apply


def stray_place(tile: TileInfo, kept: TileInfo) -> str:
    """Where the farthest point lies that ``kept`` has no more: its distance from what is left, in words."""
    beyond = np.maximum(np.maximum(np.subtract(kept.low, tile.low), np.subtract(tile.high, kept.high)), 0.0)
    return f"up to {float(np.linalg.norm(beyond)):,.0f} m away".replace(",", " ")


def read_points(
    tiles: Sequence[TileInfo],
    survey_crs: str,
    *,
    window: Window | None = None,
    origin: FloatArray | None = None,
    is_cancelled: Callable[[], bool] = lambda: False,
) -> PointCloud:
    """Read the points of several tiles inside a window, in an order and number that do not depend on the tiling.

    Withheld points, noise classes and points far from all others are dropped. Points are sorted by position, source and time, and
    points equal in all of these (overlapping or duplicate tiles, rounded in another way or not) are kept once.

    Parameters
    ----------
    tiles
        Headers as returned by :func:`inspect_tile`.
    survey_crs
        As there.
    window
        Rectangle of the survey CRS; None reads everything.
    origin
        (3,) reduction point; None takes the lower corner of the window or tiles, rounded to whole metres.
    is_cancelled
        Asked between chunks.

    Raises
    ------
    InputError
        A tile is damaged.
    Cancelled
        ``is_cancelled`` said so.
    """
    if origin is None:
        low = np.min([tile.low for tile in tiles], axis=0) if tiles else np.zeros(3)
        if window is not None:
            low = np.array([window.west, window.south, low[2]])
        origin = np.floor(low)
    parts = [
        (number, *part)
        for number, tile in enumerate(tiles)
        if window is None or window.meets(tile.low, tile.high)
        for part in _read_tile(tile, survey_crs, window, origin, is_cancelled)
    ]
    xyz = np.concatenate([p[1] for p in parts]) if parts else np.empty((0, 3))
    source_id = np.concatenate([p[2] for p in parts]) if parts else np.empty(0, np.uint16)
    gps_time = np.concatenate([p[3] for p in parts]) if parts else np.empty(0)
    spread = np.concatenate([p[4] for p in parts]) if any(tiles[p[0]].thinned for p in parts) else None
    tile_of = np.repeat(np.array([p[0] for p in parts], dtype=np.int64), [len(p[1]) for p in parts])
    del parts
    cloud = PointCloud(xyz, np.asarray(origin, dtype=np.float64), source_id, gps_time, spread)
    again = second_copies(xyz, source_id, gps_time, tile_of, max((tile.resolution for tile in tiles), default=0.0))
    if again.any():
        cloud = cloud.select(~again)
    cloud = cloud.select(by_place(cloud.xyz, cloud.source_id, cloud.gps_time))
    same = (cloud.gps_time[1:] == cloud.gps_time[:-1]) & (cloud.source_id[1:] == cloud.source_id[:-1])
    for column in cloud.xyz.T:
        same &= column[1:] == column[:-1]
    return cloud.select(np.concatenate([[True], ~same])) if same.any() else cloud


def used_points(tile: TileInfo, survey_crs: str, is_cancelled: Callable[[], bool] = lambda: False) -> Iterator[FloatArray]:
    """Yield (n, 3) positions of the points of one tile that are used, chunk by chunk, in the survey's CRS.

    Raises
    ------
    InputError
        The tile is damaged, or another one than it was.
    """
    for part in _read_tile(tile, survey_crs, None, np.zeros(3), is_cancelled):
        yield part[0]


def _read_tile(
    tile: TileInfo, survey_crs: str, window: Window | None, origin: FloatArray, is_cancelled: Callable[[], bool]
) -> Iterator[tuple[FloatArray, NDArray[np.uint16], FloatArray, FloatArray]]:
    """Yield reduced positions, source ids, times and spreads of the points of one tile inside the window."""
    if not tile.used:
        return
    if tile.thinned:
        yield _means_of(tile, survey_crs, window, origin, is_cancelled)
        return
    header = read_header(tile.path)
    bounds = (header.low, header.high) if tile.bounds is None else (np.array(tile.bounds[0]), np.array(tile.bounds[1]))
    transform = transform_of(tile, survey_crs)
    with open_points(header) as reader:
        if tile.copc and window is not None and transform is None:
            low, high = np.maximum(tile.low[:2], (window.west, window.south)), np.minimum(tile.high[:2], (window.east, window.north))
            chunks = copc_chunks(tile.path, low, high)
        else:
            chunks = chunks_of(reader, header)
        slack = header.scales + 1e-9
        for chunk in chunks:
            if is_cancelled():
                raise Cancelled("cancelled while reading")
            xyz = positions(chunk, tile.path)
            if not in_box(xyz, bounds[0] - slack, bounds[1] + slack).all():
                raise InputError("is not as it was when it was checked", source=tile.path, remedy="Run again; leave tiles alone meanwhile.")
            if transform is not None:
                xyz = transform(xyz)
            keep = usable(chunk)
            if tile.strays or transform is not None:
                keep &= in_box(xyz, np.subtract(tile.low, slack), np.add(tile.high, slack))
            if window is not None:
                keep &= window.contains(xyz)
            sources, times = point_records(chunk, header, keep)
            yield xyz[keep] - origin, tile.strips_of(sources, times), np.nan_to_num(times), np.zeros(len(sources))


def _means_of(
    tile: TileInfo, survey_crs: str, window: Window | None, origin: FloatArray, is_cancelled: Callable[[], bool]
) -> tuple[FloatArray, NDArray[np.uint16], FloatArray, FloatArray]:
    """The same of a tile that was thinned; on a machine that does not have the means they are formed again."""
    means = thinned_clouds.load(tile.thinned)
    if means is None:
        _, means = looked_through(read_header(tile.path), transform_of(tile, survey_crs), DEFAULT_LEVEL, is_cancelled, tile.patch)
    if means is None or len(means.xyz) != tile.means:
        raise InputError("is not as it was when it was checked", source=tile.path, remedy="Run again; leave tiles alone meanwhile.")
    keep = np.ones(len(means.xyz), dtype=np.bool_) if window is None else window.contains(means.xyz)
    if tile.strays:
        keep &= in_box(means.xyz, tile.low, tile.high)
    return means.xyz[keep] - origin, tile.strips_of(means.sources[keep], means.times[keep]), means.times[keep], means.spread[keep]


def _tile_of(header: LasHeader, scan: Scan | None, transform: TileTransform, remarks: Sequence[str]) -> TileInfo:
    low, high = (np.zeros(3), np.zeros(3)) if scan is None else (scan.low, scan.high)
    if not np.isfinite([low, high]).all():
        low, high = np.zeros(3), np.zeros(3)
    return TileInfo(
        path=header.path,
        points=header.count,
        low=_corner(low),
        high=_corner(high),
        version=header.version,
        point_format=header.point_format,
        compressed=header.compressed,
        copc=header.copc,
        crs="",
        has_time=header.has_time,
        size=header.size,
        note=transform.note,
        remarks=tuple(remarks),
        unread=header.unread,
        dropped=0 if scan is None else header.count - scan.cells.points,
        resolution=float(header.scales.max()),
        cells=None if scan is None else scan.cells,
        times=(math.inf, -math.inf) if scan is None else (float(scan.times[0]), float(scan.times[1])),
        sources=() if scan is None else tuple(scan.sources.tolist()),
        by_second=PlacesBySecond.empty() if scan is None else scan.by_second,
        thinned="" if scan is None else scan.thinned,
        means=0 if scan is None else scan.means,
    )


def _corner(values: Sequence[float] | FloatArray) -> Corner:
    return float(values[0]), float(values[1]), float(values[2])


def _corners(low: Sequence[float] | FloatArray, high: Sequence[float] | FloatArray) -> FloatArray:
    """(8, 3) corners of a box."""
    return np.array([(e, n, h) for e in (low[0], high[0]) for n in (low[1], high[1]) for h in (low[2], high[2])])
