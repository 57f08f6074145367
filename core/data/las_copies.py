"""A tile copied with one dimension more. Everything else stays as it is, byte by byte: header fields, records, extended records, extra
bytes with their scales, references to waveforms."""

from __future__ import annotations

import shutil
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray
from ..common.atomic_files import cannot_write, replace_durably, temporary_beside
from ..common.errors import InputError
from .las_files import POINT_LENGTHS, LasHeader, LasRecord, chunks_of, open_points, positions, read_header
from .tile_extent import point_records

EXTRA_BYTES = ("LASF_Spec", 4)
WAVEFORMS = ("LASF_Spec", 65535)
OF_COMPRESSION = (("laszip encoded", 22204), ("copc", 1), ("copc", 1000), ("copc", 10000))
"""Records that say how points are compressed and ordered: those of the copy are its own."""
UNDOCUMENTED, UNSIGNED_BYTE, UNSIGNED_INT = 0, 1, 5
"""Data types of extra bytes (LAS 1.4 R15, table 24)."""
WAVEFORM_FORMATS = (4, 5, 9, 10)
Values = Callable[[FloatArray, NDArray[np.uint16], FloatArray], Any]


@dataclass(frozen=True)
class Dimension:
    """Name (at most 32 bytes) and description of a whole number of 32 bits that is added to every point."""

    name: str
    description: str


def write_with_dimension(source: Path, target: Path, dimension: Dimension, values: Values) -> int:
    """Copy a LAS, LAZ or COPC file as LAZ with one dimension more, whole or not at all.

    Parameters
    ----------
    source, target
        Files; waveforms kept beside the source (.wdp) are copied too.
    dimension
        What is added.
    values
        (n,) whole numbers for (n, 3) coordinates of the source, (n,) point source IDs and (n,) GPS times, zero where there are none.

    Returns
    -------
    How many points have a value other than 0.

    Raises
    ------
    InputError
        The source is damaged, or has such a dimension already.
    OutputError
        The target cannot be written.
    """
    header = read_header(source)
    described = _described(header, dimension)
    try:
        with temporary_beside(target.absolute()) as temporary:
            with header.stored.open("rb") as original, temporary.open("wb") as copy:
                count = _copy(header, original, copy, described, values)
            replace_durably(temporary, target.absolute())
        waves = source.with_suffix(".wdp")
        if header.point_format in WAVEFORM_FORMATS and waves.is_file() and waves.resolve() != target.with_suffix(".wdp").resolve():
            shutil.copyfile(waves, target.with_suffix(".wdp"))
    except OSError as error:
        raise cannot_write(target, error) from error
    return count


def _described(header: LasHeader, dimension: Dimension) -> bytes:
    """Content of the record of extra bytes with the new dimension at its end."""
    known = header.content(*EXTRA_BYTES) or b""
    known = known[: len(known) // 192 * 192]
    names = [known[k + 4 : k + 36].split(b"\0")[0].decode("utf-8", "replace") for k in range(0, len(known), 192)]
    if dimension.name in names:
        raise InputError(f"has a dimension {dimension.name} already", source=header.path, remedy="Give the tiles as they were surveyed.")
    spare = (
        header.record_length - POINT_LENGTHS[header.point_format] - sum(_bytes_of(known[k : k + 192]) for k in range(0, len(known), 192))
    )
    for k in range(spare):
        # bytes that nobody described must be accounted for before the new dimension; one by one, which every program understands
        known += struct.pack("<2xBB32s124x32s", UNSIGNED_BYTE, 0, f"undescribed_{k + 1}".encode(), b"")
    words = (dimension.name.encode(), dimension.description.encode())
    return known + struct.pack("<2xBB32s124x32s", UNSIGNED_INT, 0, *words)


def _bytes_of(entry: bytes) -> int:
    """Bytes of a point that an entry of the record of extra bytes describes."""
    kind, options = entry[2], entry[3]
    if kind == UNDOCUMENTED:
        return options
    return (1, 1, 2, 2, 4, 4, 8, 8, 4, 8)[(kind - 1) % 10] * ((kind - 1) // 10 + 1)


def _copy(header: LasHeader, original: BinaryIO, copy: BinaryIO, described: bytes, values: Values) -> int:
    """Header, records, points and extended records; returns how many points have a value."""
    import lazrs

    length = header.record_length + 4
    laszip = lazrs.LazVlr.new_for_compression(header.point_format, length - POINT_LENGTHS[header.point_format], False)
    kept = [r for r in header.records if (r.user_id, r.record_id) not in (*OF_COMPRESSION, EXTRA_BYTES)]
    own = ((EXTRA_BYTES, "extra bytes", described), (OF_COMPRESSION[0], "laszip", bytes(laszip.record_data())))
    original.seek(0)
    head = bytearray(original.read(header.header_size))
    copy.write(head)
    near = [record for record in kept if not record.extended]
    for record in near:
        copy.write(_whole_record(original, record))
    for (user, number), text, content in own:
        copy.write(struct.pack("<H16sHH32s", 0, user.encode(), number, len(content), text.encode()) + content)
    start = copy.tell()
    found = 0
    compressor = lazrs.LasZipCompressor(copy, laszip)
    with open_points(header, everything=True) as reader:
        for chunk in chunks_of(reader, header):
            records = point_records(chunk, header, np.ones(len(chunk), dtype=np.bool_))
            numbers = np.asarray(values(positions(chunk, header.path), *records), dtype="<u4")
            raw = np.frombuffer(np.ascontiguousarray(chunk.array).tobytes(), dtype=np.uint8).reshape(len(chunk), -1)
            compressor.compress_many(np.hstack([raw, numbers.view(np.uint8).reshape(-1, 4)]).tobytes())
            found += int((numbers > 0).sum())
    compressor.done()
    far = [record for record in kept if record.extended]
    copy.seek(0, 2)
    end = copy.tell()
    for record in far:
        if (record.user_id, record.record_id) == WAVEFORMS:
            struct.pack_into("<Q", head, 227, copy.tell())
        original.seek(record.offset - 60)
        _pour(original, copy, record.length + 60)
    struct.pack_into("<II", head, 96, start, len(near) + len(own))
    struct.pack_into("<BH", head, 104, header.point_format | 0x80, length)
    if len(head) >= 247 and header.version == "1.4":
        struct.pack_into("<QI", head, 235, end if far else 0, len(far))
    for at, content in header.patches.items():
        if at >= 235:
            head[at : at + len(content)] = content
    copy.seek(0)
    copy.write(head)
    return found


def _whole_record(stream: BinaryIO, record: LasRecord) -> bytes:
    """A record with its own header of 54 bytes."""
    stream.seek(record.offset - 54)
    return stream.read(record.length + 54)


def _pour(source: BinaryIO, target: BinaryIO, length: int, step: int = 1 << 22) -> None:
    """Copy a stretch of any length."""
    while length > 0:
        part = source.read(min(step, length))
        if not part:
            return
        target.write(part)
        length -= len(part)
