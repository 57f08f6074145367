"""LAS, LAZ and COPC files below the level of points: headers as the world has them, records, and chunks of points.

Files come from the field and may be damaged, and writers bend the format. What can be understood beyond doubt is mended while it is
read, and said; what cannot ends in one sentence.
"""

from __future__ import annotations

import hashlib
import io
import struct
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import InputError, TetratrackError
from ..common.input_files import check_regular
from .other_clouds import as_las

CHUNK_POINTS = 250_000
"""Points decompressed at a time; bounds memory whatever the tile's size."""

POINT_LENGTHS = (20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67)
"""Least record length in bytes of point formats 0 to 10 (LAS 1.4 R15, 2.6)."""
HEADER_LENGTHS = (227, 227, 227, 235, 375)
"""Least header length in bytes of LAS 1.0 to 1.4."""
MOST_RECORD_BYTES = 4_000_000
"""Largest record that is read for what it says; CRS definitions have some kilobytes."""
POINTWISE, LAYERED = 1, 3
"""Compressors of LASzip 1.x, without chunks, and of LASzip 3, with chunks in layers (LASzip's laszip.hpp)."""
EXTRA_BYTES = 14
LAYERS_OF = {10: 9, 11: 1, 12: 2, 13: 1}
"""Layers of a chunk by type of item: point, colour, colour with infrared, waveform; extra bytes have one each (laszip.hpp)."""

REMEDY_DAMAGED = "Copy the file again from its source, or check it with lasinfo."


@dataclass(frozen=True)
class LasRecord:
    """A variable length record, extended or not: where its content stands in the file."""

    user_id: str
    record_id: int
    offset: int
    length: int
    extended: bool


@dataclass(frozen=True, eq=False, kw_only=True)
class LasHeader:
    """What a header says.

    Attributes
    ----------
    path
        The file.
    stored
        Where its bytes are read: the file itself, or the copy as LAZ of an E57 or PLY.
    size
        Bytes of that.
    version
        As written, "1.4".
    header_size, data_offset, record_length, point_format, compressed, count
        As the format names them; ``count`` is the number of points.
    scales, offsets, low, high
        (3,) of coordinates, and the extent that the header gives, metres; nothing is promised about the extent.
    records
        Variable length records and extended ones, in the order of the file.
    wkt
        The header says that its CRS is WKT.
    patches
        Bytes to read in place of the file's, by position, so that a library understands what the writer meant.
    note
        What was mended; empty where nothing was.
    unread
        Points that the file seems to hold behind those that the header counts.
    """

    path: Path
    stored: Path
    size: int
    version: str
    header_size: int
    data_offset: int
    record_length: int
    point_format: int
    compressed: bool
    count: int
    scales: FloatArray
    offsets: FloatArray
    low: FloatArray
    high: FloatArray
    records: tuple[LasRecord, ...]
    wkt: bool
    patches: Mapping[int, bytes] = field(default_factory=dict)
    note: str = ""
    unread: int = 0

    @property
    def copc(self) -> bool:
        """Whether the points are indexed as a cloud-optimised point cloud."""
        return any(record.user_id == "copc" and record.record_id == 1 for record in self.records)

    @property
    def has_time(self) -> bool:
        """Points carry GPS time."""
        return self.point_format not in (0, 2)

    def content(self, user_id: str, record_id: int) -> bytes | None:
        """Content of the first record of a kind; None where there is none or it is beyond measure."""
        for record in self.records:
            if (record.user_id, record.record_id) == (user_id, record_id) and (content := self.content_of(record)) is not None:
                return content
        return None

    def content_of(self, record: LasRecord) -> bytes | None:
        """Content of a record; None where it is beyond measure."""
        if record.length > MOST_RECORD_BYTES:
            return None
        try:
            with self.stored.open("rb") as stream:
                stream.seek(record.offset)
                return stream.read(record.length)
        except OSError as error:
            raise unreadable(self.path, error) from error


def read_header(path: Path) -> LasHeader:
    """Read and check a header with the list of its records.

    Refused is what is no LAS file, or one whose header promises more bytes than the file has: the counts and offsets of a damaged
    header would otherwise make a reader allocate or loop without end.

    Raises
    ------
    InputError
        In one sentence.
    """
    try:
        check_regular(path)
        stored = as_las(path)
        with stored.open("rb") as stream:
            return _parsed(path, stored, stored.stat().st_size, stream)
    except OSError as error:
        raise unreadable(path, error) from error
    except struct.error as error:
        raise InputError("has a damaged or truncated header", source=path, remedy=REMEDY_DAMAGED) from error


def _parsed(path: Path, stored: Path, size: int, stream: BinaryIO) -> LasHeader:
    head = stream.read(375)
    if len(head) < 227 or head[:4] != b"LASF":
        raise InputError(
            "is empty" if size == 0 else "is not a LAS or LAZ file", source=path, remedy="Give LAS, LAZ, COPC, E57 or PLY point clouds."
        )
    major, minor = head[24], head[25]
    header_size, data_offset, vlrs = struct.unpack_from("<HII", head, 94)
    point_format, length, legacy_count = struct.unpack_from("<BHI", head, 104)
    compressed = bool(point_format & 0x80)
    point_format &= 0x3F
    if major != 1 or minor >= len(HEADER_LENGTHS) or point_format >= len(POINT_LENGTHS):
        raise InputError(f"is LAS {major}.{minor} with point format {point_format}, which is unknown", source=path, remedy=REMEDY_DAMAGED)
    numbers = np.array(struct.unpack_from("<12d", head, 131))
    if not np.isfinite(numbers[:6]).all() or numbers[:3].min() <= 0:
        raise InputError("has an impossible scale in its header", source=path, remedy=REMEDY_DAMAGED)
    count, evlr_start, evlrs = legacy_count, 0, 0
    patches: dict[int, bytes] = {}
    note = ""
    needed = HEADER_LENGTHS[minor]
    if 227 <= header_size < needed:
        note = f"{path.name}: its header has {header_size} bytes where LAS {major}.{minor} needs {needed}; it is read as LAS 1.2"
        patches[25] = b"\x02"
    elif minor == 4:
        if len(head) < 375:
            raise InputError("is truncated inside its header", source=path, remedy=REMEDY_DAMAGED)
        evlr_start, evlrs, count = struct.unpack_from("<QIQ", head, 235)
        if count == 0 and legacy_count:
            count = legacy_count
            note = f"{path.name}: its header counts points only where LAS 1.2 does; that count, {count}, is taken"
            patches[247] = struct.pack("<Q", count)
    elif minor == 3:
        # waveforms inside the file are an extended record that only this field tells of
        (evlr_start,) = struct.unpack_from("<Q", head, 227)
        evlrs = int(data_offset <= evlr_start <= size - 60)
        evlr_start *= evlrs
    sound = length >= POINT_LENGTHS[point_format] and header_size >= 227 and header_size + 54 * vlrs <= data_offset
    if not sound or (evlrs and not (data_offset <= evlr_start and evlr_start + 60 * evlrs <= size)):
        raise InputError("has a damaged or truncated header", source=path, remedy=REMEDY_DAMAGED)
    if data_offset > size or data_offset + (8 if compressed and count else length * count) > size:
        raise InputError("is truncated: its points end before the header says", source=path, remedy=REMEDY_DAMAGED)
    records = (*_records(stream, header_size, vlrs, data_offset, False), *_records(stream, evlr_start, evlrs, size, True))
    if compressed and count:
        _check_compression(stream, path, records, data_offset, size, count)
    elif not compressed and count == 0 and (evlr_start or size) - data_offset >= length:
        raise InputError(
            "says that it holds no points, but has room for some: its header was never finished",
            source=path,
            remedy="Mend its header (lasinfo -repair), or export it again.",
        )
    # a compressed file has no length that would tell
    room = _counted_by_return(head, minor) if compressed else ((evlr_start or size) - data_offset) // length
    return LasHeader(
        path=path,
        stored=stored,
        size=size,
        version=f"{major}.{minor}",
        header_size=header_size,
        data_offset=data_offset,
        record_length=length,
        point_format=point_format,
        compressed=compressed,
        count=count,
        scales=numbers[:3],
        offsets=numbers[3:6],
        low=numbers[[7, 9, 11]],
        high=numbers[[6, 8, 10]],
        records=records,
        wkt=bool(struct.unpack_from("<H", head, 6)[0] & 0x10),
        patches=patches,
        note=note,
        unread=room - count if 8 * size > room > count > 0 else 0,
    )


def _counted_by_return(head: bytes, minor: int) -> int:
    """Points of a file as its header counts them by number of return."""
    return sum(struct.unpack_from("<15Q", head, 255) if minor == 4 and len(head) >= 375 else struct.unpack_from("<5I", head, 111))


def _records(stream: BinaryIO, start: int, number: int, end: int, extended: bool) -> Iterator[LasRecord]:
    """Records one after another from ``start``, as long as they lie before ``end``."""
    layout = struct.Struct("<H16sHQ32s" if extended else "<H16sHH32s")
    at = start
    for _ in range(number):
        stream.seek(at)
        head = stream.read(layout.size)
        if len(head) < layout.size:
            return
        _, user, record_id, length, _ = layout.unpack(head)
        at += layout.size
        if at + length > end:
            return
        yield LasRecord(user.split(b"\0")[0].decode("latin-1"), record_id, at, length, extended)
        at += length


def _check_compression(stream: BinaryIO, path: Path, records: tuple[LasRecord, ...], data_offset: int, size: int, count: int) -> None:
    """A LAZ file names, before its points, where the table of its chunks begins: near the end, where truncation shows."""
    laszip = next((r for r in records if r.user_id == "laszip encoded" and r.record_id == 22204), None)
    if laszip is not None and laszip.length >= 2:
        stream.seek(laszip.offset)
        if struct.unpack("<H", stream.read(2))[0] == POINTWISE:
            raise InputError(
                "is compressed point by point, as LASzip 1 did; only compression by chunks can be read",
                source=path,
                remedy="Write it anew with a program of today, for example: laszip -i in.laz -o out.laz, or pdal translate in.laz out.laz",
            )
    stream.seek(data_offset)
    table = struct.unpack("<q", stream.read(8))[0]
    if table == -1:
        stream.seek(-8, 2)
        table = struct.unpack("<q", stream.read(8))[0]
    if not data_offset + 8 <= table <= size - 8:
        raise InputError("is truncated: the table of its compressed chunks is missing", source=path, remedy=REMEDY_DAMAGED)
    stream.seek(table)
    version, chunks = struct.unpack("<II", stream.read(8))
    if version != 0 or chunks > count or chunks > size:
        raise InputError("is damaged: the table of its compressed chunks makes no sense", source=path, remedy=REMEDY_DAMAGED)
    if laszip is not None:
        _check_layers(stream, path, laszip, data_offset + 8, table)


def _check_layers(stream: BinaryIO, path: Path, laszip: LasRecord, start: int, table: int) -> None:
    """Refuse a chunk in layers (LASzip 3) that claims more bytes than the file has: a decoder makes room for them before it looks.

    Each chunk is its first point as it stands, the number of its points, the sizes of all layers, and these one after another.
    """
    stream.seek(laszip.offset)
    content = stream.read(min(laszip.length, 34 + 6 * 64))
    if len(content) < 34 or struct.unpack_from("<H", content)[0] != LAYERED:
        return
    items = [struct.unpack_from("<HH", content, at) for at in range(34, len(content) - 5, 6)]
    layers = sum(size if kind == EXTRA_BYTES else LAYERS_OF.get(kind, 0) for kind, size in items)
    fixed = sum(size for _, size in items) + 4
    at = start
    while at + fixed + 4 * layers <= table:
        stream.seek(at + fixed)
        at += fixed + 4 * layers + sum(struct.unpack(f"<{layers}I", stream.read(4 * layers)))
        if at > table:
            raise InputError("is damaged: a compressed chunk claims more bytes than there are", source=path, remedy=REMEDY_DAMAGED)


class _Patched(io.RawIOBase):
    """A file some bytes of which are read as others."""

    def __init__(self, path: Path, patches: Mapping[int, bytes]) -> None:
        self._file = path.open("rb")
        self._patches = patches

    def readable(self) -> bool:
        return True

    def seekable(self) -> bool:
        return True

    def seek(self, offset: int, whence: int = 0) -> int:
        return self._file.seek(offset, whence)

    def tell(self) -> int:
        return self._file.tell()

    def readinto(self, buffer: Any) -> int:
        start = self._file.tell()
        read = self._file.readinto(buffer) or 0
        view = memoryview(buffer).cast("B")
        for at, content in self._patches.items():
            for k, value in enumerate(content):
                if start <= at + k < start + read:
                    view[at + k - start] = value
        return read

    def close(self) -> None:
        self._file.close()
        super().close()


def open_points(header: LasHeader, *, everything: bool = False) -> Any:
    """Open a tile for chunked reading; one thread, since tiles are read by several processes.

    Without ``everything`` only what segmentation uses is decompressed. Extended records are never read: they may be huge.
    """
    import laspy

    wanted = laspy.DecompressionSelection
    some = wanted.XY_RETURNS_CHANNEL | wanted.Z | wanted.CLASSIFICATION | wanted.FLAGS | wanted.POINT_SOURCE_ID | wanted.GPS_TIME
    try:
        source: Any = io.BufferedReader(_Patched(header.stored, header.patches)) if header.patches else str(header.stored)
        return laspy.open(
            source,
            laz_backend=laspy.LazBackend.Lazrs,
            decompression_selection=wanted.all() if everything else some,
            read_evlrs=False,
        )
    except BaseException as error:
        raise damaged(header.path, error) from error


def chunks_of(reader: Any, header: LasHeader) -> Iterator[Any]:
    """All points of an open tile by chunks; fewer than the header promises is an error."""
    total = 0
    chunks = reader.chunk_iterator(CHUNK_POINTS)
    while True:
        try:
            chunk = next(chunks)
        except StopIteration:
            break
        except BaseException as error:
            raise damaged(header.path, error) from error
        total += len(chunk)
        yield chunk
    if total != header.count:
        raise InputError(f"is truncated: {total} of {header.count} points are there", source=header.path, remedy=REMEDY_DAMAGED)


def copc_chunks(path: Path, low: FloatArray, high: FloatArray) -> Iterator[Any]:
    """Points of the nodes of a COPC that touch a rectangle from (2,) ``low`` to ``high`` of its own CRS."""
    import laspy
    from laspy.copc import Bounds

    try:
        with path.open("rb") as stream:
            points = laspy.CopcReader(stream).query(Bounds(mins=np.asarray(low), maxs=np.asarray(high)))
    except BaseException as error:
        raise damaged(path, error) from error
    for start in range(0, len(points), CHUNK_POINTS):
        yield points[start : start + CHUNK_POINTS]


def positions(chunk: Any, path: Path) -> FloatArray:
    """(n, 3) coordinates of a chunk in the CRS of the file.

    Raises
    ------
    InputError
        One is not finite, or beyond what any CRS has.
    """
    xyz = np.column_stack([chunk.x, chunk.y, chunk.z]).astype(np.float64, copy=False)
    if not np.isfinite(xyz).all():
        raise InputError("holds points without finite coordinates", source=path, remedy=REMEDY_DAMAGED)
    if len(xyz) and np.abs(xyz).max() > 1e9:
        raise InputError("holds points with coordinates beyond any CRS", source=path, remedy=REMEDY_DAMAGED)
    return xyz


def checksum(path: Path) -> str:
    """SHA-256 of a file, hexadecimal."""
    try:
        with path.open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError as error:
        raise unreadable(path, error) from error


def unreadable(path: Path, error: OSError) -> InputError:
    """What to say of a file that the system does not give."""
    if isinstance(error, FileNotFoundError):
        return InputError("there is no such file", source=path, remedy="Check the tiles of its epoch.")
    return InputError(f"cannot be read ({error.strerror or error})", source=path, remedy="Check the file's permissions and disk.")


def damaged(path: Path, error: BaseException) -> BaseException:
    """An InputError for whatever the decoders raise on a damaged file; a user's interrupt stays what it is.

    The LAZ decoder reports some damage as a panic, which Python sees as a BaseException that is no Exception.
    """
    if isinstance(error, KeyboardInterrupt | SystemExit | GeneratorExit | TetratrackError):
        return error
    if isinstance(error, OSError) and error.errno is not None:
        return unreadable(path, error)
    if isinstance(error, MemoryError):
        return InputError("needs more memory than there is, or is damaged", source=path, remedy=REMEDY_DAMAGED)
    text = " ".join(str(error).split())[:120]
    return InputError(f"is damaged or truncated ({text or type(error).__name__})", source=path, remedy=REMEDY_DAMAGED)
