"""Tiles as the world has them: sound points under headers that say something else."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from las_files import grid_points
from laspy.vlrs.vlr import VLR

EXTENT_AT, VERSION_AT, HEADER_SIZE_AT, LEGACY_COUNT_AT, COUNT_AT = 179, 25, 94, 107, 247


def patched(path: Path, changes: Mapping[int, bytes]) -> Path:
    """Overwrite bytes of a file."""
    data = bytearray(path.read_bytes())
    for at, content in changes.items():
        data[at : at + len(content)] = content
    path.write_bytes(data)
    return path


def with_extent(path: Path, low: np.ndarray, high: np.ndarray) -> Path:
    """Let a header give another extent."""
    return patched(path, {EXTENT_AT: struct.pack("<6d", high[0], low[0], high[1], low[1], high[2], low[2])})


def write_keys(path: Path, keys: Mapping[int, int], citation: str = "", points: np.ndarray | None = None) -> Path:
    """Write a tile whose CRS stands in GeoTIFF keys."""
    import laspy

    header = laspy.LasHeader(version="1.2", point_format=1)
    xyz = grid_points() if points is None else points
    header.scales, header.offsets = np.full(3, 0.001), np.floor(xyz.min(axis=0))
    rows = [(key, 0, 1, value) for key, value in sorted(keys.items())]
    text = citation.encode() + b"|" if citation else b""
    if text:
        rows.append((3073, 34737, len(text), 0))
        rows.sort()
    shorts = [1, 1, 0, len(rows), *(value for row in rows for value in row)]
    header.vlrs.append(VLR("LASF_Projection", 34735, "", struct.pack(f"<{len(shorts)}H", *shorts)))
    if text:
        header.vlrs.append(VLR("LASF_Projection", 34737, "", text + b"\0"))
    las = laspy.LasData(header)
    las.x, las.y, las.z = xyz.T
    las.write(str(path))
    return path


def write_wkt(path: Path, wkt: bytes) -> Path:
    """Write a tile whose header holds these bytes as its CRS."""
    import laspy

    points = grid_points()
    header = laspy.LasHeader(version="1.4", point_format=6)
    header.scales, header.offsets = np.full(3, 0.001), np.floor(points.min(axis=0))
    header.global_encoding.wkt = True
    header.vlrs.append(VLR("LASF_Projection", 2112, "", wkt))
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T
    las.write(str(path))
    return path


def write_survey(
    folder: Path, tiles: str = "*.la[sz]", *, crs: str = "EPSG:32650", height: float = 2.3, epochs: str = "", more: str = ""
) -> Path:
    """A survey.toml of one epoch (or those given) over tiles beside it."""
    path = folder / "survey.toml"
    first = f'[[epoch]]\nlabel = "a"\ntime = 2024-03-14T02:30:00Z\ntiles = "{tiles}"\n{more}\n'
    head = f'[survey]\nname = "site"\ncrs = "{crs}"\n[unit]\ntype = "tetrapod"\nheight = {height}\n'
    path.write_text(head + (epochs or first), encoding="utf-8")
    return path
