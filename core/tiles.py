"""LAS, LAZ and COPC tiles: headers checked before any work, points read by chunks inside a window.

Files come from the field and may be damaged: whatever is read is compared with what the header promises (counts, extents), so
that a broken file ends in one sentence and never in wrong points.
"""

from __future__ import annotations

import hashlib
import math
import struct
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .crs import LOCAL, TileTransform, crs_text, parse_crs, tile_transform
from .errors import Cancelled, InputError

if TYPE_CHECKING:
    from pyproj import CRS

FloatArray = NDArray[np.float64]

CHUNK_POINTS = 1_000_000
"""Points decompressed at a time; bounds memory whatever the tile's size."""

NOISE_CLASSES = (7, 18)
"""ASPRS classes low and high noise (LAS 1.4 R15, table 17)."""

POINT_LENGTHS = (20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67)
"""Least record length in bytes of point formats 0 to 10 (LAS 1.4 R15, 2.6)."""

_REMEDY_DAMAGED = "Copy the file again from its source, or check it with lasinfo."


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


@dataclass(frozen=True)
class TileInfo:
    """Header of a tile.

    Attributes
    ----------
    path
        The file.
    points
        Number of points promised by the header.
    low, high
        Extent e, n, h in the survey's CRS, metres.
    version, point_format
        LAS version and point data format.
    compressed, copc
        Whether the points are LAZ chunks, and whether they are indexed as a cloud-optimised point cloud.
    crs
        The header's CRS (or the epoch's tiles_crs) as survey.toml takes it, empty where there is none.
    has_time
        Points carry GPS time.
    size
        Bytes of the file.
    note
        What was done to bring the tile into the survey's CRS; empty where nothing was.
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

    @property
    def density(self) -> float:
        """Points per square metre of the extent."""
        return self.points / max((self.high[0] - self.low[0]) * (self.high[1] - self.low[1]), 1e-6)


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
    """

    xyz: FloatArray
    origin: FloatArray
    source_id: NDArray[np.uint16]
    gps_time: FloatArray

    def __len__(self) -> int:
        return len(self.xyz)

    def select(self, keep: NDArray[Any]) -> PointCloud:
        """The points of a mask or of indices."""
        return PointCloud(self.xyz[keep], self.origin, self.source_id[keep], self.gps_time[keep])


def inspect_tile(path: str | Path, survey_crs: str | None, *, tiles_crs: str | None = None) -> TileInfo:
    """Read and check a tile's header.

    Parameters
    ----------
    path
        LAS, LAZ or COPC file.
    survey_crs
        CRS of the survey as in survey.toml; None takes the tile as it is, whatever its CRS.
    tiles_crs
        CRS to assume where the header declares none.

    Raises
    ------
    InputError
        The file is missing, unreadable, not LAS, truncated or empty of points.
    CrsError
        Its CRS is missing or cannot be used.
    """
    source = Path(path)
    size = _check_header(source)
    with _open(source) as reader:
        header = reader.header
        if header.point_count == 0:
            raise InputError("holds no points", source=source, remedy="Leave the tile out of the epoch's tiles.")
        low, high = np.asarray(header.mins, dtype=np.float64), np.asarray(header.maxs, dtype=np.float64)
        if not (np.isfinite([low, high]).all() and (low <= high).all()):
            raise InputError("has an impossible extent in its header", source=source, remedy=_REMEDY_DAMAGED)
        crs = tile_crs(header, source, tiles_crs)
        copc = any(vlr.user_id == "copc" and vlr.record_id == 1 for vlr in header.vlrs)
        transform = TileTransform(None) if survey_crs is None else tile_transform(crs, survey_crs, _corners(low, high), source=source)
        if transform.apply is not None:
            corners = transform.apply(_corners(low, high, 9))
            low, high = corners.min(axis=0), corners.max(axis=0)
        return TileInfo(
            source,
            int(header.point_count),
            (float(low[0]), float(low[1]), float(low[2])),
            (float(high[0]), float(high[1]), float(high[2])),
            str(header.version),
            int(header.point_format.id),
            bool(header.are_points_compressed),
            copc,
            crs_text(crs),
            "gps_time" in header.point_format.dimension_names,
            size,
            transform.note,
        )


def read_points(
    tiles: Sequence[TileInfo],
    survey_crs: str,
    *,
    window: Window | None = None,
    origin: FloatArray | None = None,
    tiles_crs: str | None = None,
    is_cancelled: Callable[[], bool] = lambda: False,
) -> PointCloud:
    """Read the points of several tiles inside a window, in an order and number that do not depend on the tiling.

    Withheld points and noise classes are dropped. Points are sorted by position, source and time, and points equal in all of
    these (overlapping or duplicate tiles) are kept once.

    Parameters
    ----------
    tiles
        Headers as returned by :func:`inspect_tile`.
    survey_crs, tiles_crs
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
        part
        for tile in tiles
        if window is None or window.meets(tile.low, tile.high)
        for part in _read_tile(tile, survey_crs, tiles_crs, window, origin, is_cancelled)
    ]
    xyz = np.concatenate([p[0] for p in parts]) if parts else np.empty((0, 3))
    source_id = np.concatenate([p[1] for p in parts]) if parts else np.empty(0, np.uint16)
    gps_time = np.concatenate([p[2] for p in parts]) if parts else np.empty(0)
    del parts
    order = np.lexsort((gps_time, source_id, xyz[:, 2], xyz[:, 1], xyz[:, 0]))
    xyz, source_id, gps_time = xyz[order], source_id[order], gps_time[order]
    same = (np.diff(xyz, axis=0) == 0).all(axis=1) & (np.diff(gps_time) == 0) & (source_id[1:] == source_id[:-1])
    if same.any():
        keep = np.concatenate([[True], ~same])
        xyz, source_id, gps_time = xyz[keep], source_id[keep], gps_time[keep]
    return PointCloud(xyz, np.asarray(origin, dtype=np.float64), source_id, gps_time)


def checksum(path: Path) -> str:
    """SHA-256 of a file, hexadecimal."""
    try:
        with path.open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError as error:
        raise _unreadable(path, error) from error


def _read_tile(
    tile: TileInfo,
    survey_crs: str,
    tiles_crs: str | None,
    window: Window | None,
    origin: FloatArray,
    is_cancelled: Callable[[], bool],
) -> Iterator[tuple[FloatArray, NDArray[np.uint16], FloatArray]]:
    """Yield reduced positions, source ids and times of the points of one tile inside the window."""
    _check_header(tile.path)
    with _open(tile.path) as reader:
        header = reader.header
        crs = tile_crs(header, tile.path, tiles_crs)
        low, high = np.asarray(header.mins, dtype=np.float64), np.asarray(header.maxs, dtype=np.float64)
        transform = tile_transform(crs, survey_crs, _corners(low, high), source=tile.path).apply
        if tile.copc and window is not None and transform is None:
            chunks = _copc_chunks(tile.path, window)
        else:
            chunks = tile_chunks(reader, tile.path)
        slack = 2 * np.asarray(header.scales) + 1e-9
        for chunk in chunks:
            if is_cancelled():
                raise Cancelled("cancelled while reading")
            xyz = np.column_stack([chunk.x, chunk.y, chunk.z]).astype(np.float64, copy=False)
            if not np.isfinite(xyz).all():
                raise InputError("holds points without finite coordinates", source=tile.path, remedy=_REMEDY_DAMAGED)
            if ((xyz < low - slack) | (xyz > high + slack)).any():
                raise InputError("holds points outside the extent its header gives", source=tile.path, remedy=_REMEDY_DAMAGED)
            if transform is not None:
                xyz = transform(xyz)
            names = set(chunk.point_format.dimension_names)
            keep = ~np.isin(np.asarray(chunk.classification), NOISE_CLASSES)
            if "withheld" in names:
                keep &= np.asarray(chunk.withheld) == 0
            if window is not None:
                keep &= window.contains(xyz)
            time = np.asarray(chunk.gps_time, dtype=np.float64)[keep] if "gps_time" in names else np.zeros(int(keep.sum()))
            yield xyz[keep] - origin, np.asarray(chunk.point_source_id, dtype=np.uint16)[keep], np.nan_to_num(time)


def tile_chunks(reader: Any, path: Path) -> Iterator[Any]:
    """All points of an open tile by chunks; fewer than the header promises is an error."""
    total = 0
    chunks = reader.chunk_iterator(CHUNK_POINTS)
    while True:
        try:
            chunk = next(chunks)
        except StopIteration:
            break
        except BaseException as error:
            raise _damaged(path, error) from error
        total += len(chunk)
        yield chunk
    if total != reader.header.point_count:
        raise InputError(f"is truncated: {total} of {reader.header.point_count} points are there", source=path, remedy=_REMEDY_DAMAGED)


def _copc_chunks(path: Path, window: Window) -> Iterator[Any]:
    """Points of the nodes of a COPC that touch the window."""
    import laspy
    from laspy.copc import Bounds

    try:
        with path.open("rb") as stream:
            reader = laspy.CopcReader(stream)
            low, high = reader.header.mins, reader.header.maxs
            bounds = Bounds(
                mins=np.array([max(window.west, low[0]), max(window.south, low[1])]),
                maxs=np.array([min(window.east, high[0]), min(window.north, high[1])]),
            )
            points = reader.query(bounds)
    except BaseException as error:
        raise _damaged(path, error) from error
    for start in range(0, len(points), CHUNK_POINTS):
        yield points[start : start + CHUNK_POINTS]


def _open(path: Path) -> Any:
    """Open a tile for chunked reading; one thread, since tiles are read by several processes."""
    import laspy

    wanted = laspy.DecompressionSelection
    selection = wanted.XY_RETURNS_CHANNEL | wanted.Z | wanted.CLASSIFICATION | wanted.FLAGS | wanted.POINT_SOURCE_ID | wanted.GPS_TIME
    try:
        return laspy.open(str(path), laz_backend=laspy.LazBackend.Lazrs, decompression_selection=selection)
    except BaseException as error:
        raise _damaged(path, error) from error


def tile_crs(header: Any, path: Path, tiles_crs: str | None) -> CRS | None:
    """CRS of the header's WKT or GeoTIFF keys, else the one to assume; None where there is neither."""
    from pyproj.exceptions import CRSError

    try:
        crs: CRS | None = header.parse_crs()
    except CRSError as error:
        raise InputError("declares a CRS that cannot be understood", source=path, remedy="Write its EPSG code into the header.") from error
    except BaseException as error:
        raise _damaged(path, error) from error
    return parse_crs(tiles_crs) if crs is None and tiles_crs not in (None, LOCAL) else crs


def _corners(low: FloatArray, high: FloatArray, steps: int = 2) -> FloatArray:
    """(k, 3) points along the edges of an extent; more steps follow the curvature of a transformation."""
    along = np.linspace(0, 1, steps)
    edge = np.array([(a, b) for a in along for b in along if a in (0, 1) or b in (0, 1)])
    flat = low[:2] + edge * (high - low)[:2]
    return np.vstack([np.column_stack([flat, np.full(len(flat), h)]) for h in (low[2], high[2])])


def _check_header(path: Path) -> int:
    """Refuse what is no LAS file, or one whose header promises more bytes than the file has; returns its size in bytes.

    The counts and offsets of a damaged header would otherwise make a reader allocate or loop without end.
    """
    try:
        size = path.stat().st_size
        with path.open("rb") as stream:
            head = stream.read(375)
            if len(head) < 227 or head[:4] != b"LASF":
                raise InputError(
                    "is empty" if size == 0 else "is not a LAS or LAZ file", source=path, remedy="Give LAS, LAZ or COPC point clouds."
                )
            major, minor = head[24], head[25]
            header_size, data_offset, vlrs = struct.unpack_from("<HII", head, 94)
            point_format, length, count = struct.unpack_from("<BHI", head, 104)
            compressed = bool(point_format & 0x80)
            point_format &= 0x3F
            if (major, minor) not in ((1, 0), (1, 1), (1, 2), (1, 3), (1, 4)) or point_format >= len(POINT_LENGTHS):
                raise InputError(
                    f"is LAS {major}.{minor} with point format {point_format}, which is unknown", source=path, remedy=_REMEDY_DAMAGED
                )
            evlr_start = evlrs = 0
            if minor == 4:
                if len(head) < 375:
                    raise InputError("is truncated inside its header", source=path, remedy=_REMEDY_DAMAGED)
                evlr_start, evlrs, count = struct.unpack_from("<QIQ", head, 235)
            scales = struct.unpack_from("<6d", head, 131)
            if not all(map(math.isfinite, scales)) or min(scales[:3]) <= 0:
                raise InputError("has an impossible scale in its header", source=path, remedy=_REMEDY_DAMAGED)
            sound = length >= POINT_LENGTHS[point_format] and header_size >= 227 and header_size + 54 * vlrs <= data_offset
            if not sound or (evlrs and not (data_offset <= evlr_start and evlr_start + 60 * evlrs <= size)):
                raise InputError("has a damaged or truncated header", source=path, remedy=_REMEDY_DAMAGED)
            end = data_offset + (8 if compressed and count else length * count)
            if data_offset > size or end > size:
                raise InputError("is truncated: its points end before the header says", source=path, remedy=_REMEDY_DAMAGED)
            if compressed and count:
                _check_chunk_table(stream, path, data_offset, size, count)
    except OSError as error:
        raise _unreadable(path, error) from error
    return size


def _check_chunk_table(stream: Any, path: Path, data_offset: int, size: int, count: int) -> None:
    """A LAZ file names, before its points, where the table of its chunks begins: near the end, where truncation shows."""
    stream.seek(data_offset)
    table = struct.unpack("<q", stream.read(8))[0]
    if table == -1:
        stream.seek(-8, 2)
        table = struct.unpack("<q", stream.read(8))[0]
    if not data_offset + 8 <= table <= size - 8:
        raise InputError("is truncated: the table of its compressed chunks is missing", source=path, remedy=_REMEDY_DAMAGED)
    stream.seek(table)
    version, chunks = struct.unpack("<II", stream.read(8))
    if version != 0 or chunks > count or chunks > size:
        raise InputError("is damaged: the table of its compressed chunks makes no sense", source=path, remedy=_REMEDY_DAMAGED)


def _unreadable(path: Path, error: OSError) -> InputError:
    if isinstance(error, FileNotFoundError):
        return InputError("there is no such file", source=path, remedy="Check the tiles of its epoch.")
    return InputError(f"cannot be read ({error.strerror or error})", source=path, remedy="Check the file's permissions and disk.")


def _damaged(path: Path, error: BaseException) -> BaseException:
    """An InputError for whatever the decoders raise on a damaged file; a user's interrupt stays what it is.

    The LAZ decoder reports some damage as a panic, which Python sees as a BaseException that is no Exception.
    """
    if isinstance(error, KeyboardInterrupt | SystemExit | GeneratorExit | Cancelled | InputError):
        return error
    if isinstance(error, OSError) and error.errno is not None:
        return _unreadable(path, error)
    if isinstance(error, MemoryError):
        return InputError("needs more memory than there is, or is damaged", source=path, remedy=_REMEDY_DAMAGED)
    text = " ".join(str(error).split())[:120]
    return InputError(f"is damaged or truncated ({text or type(error).__name__})", source=path, remedy=_REMEDY_DAMAGED)
