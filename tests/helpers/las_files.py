"""Small LAS and LAZ files for tests."""

from __future__ import annotations

import struct
from pathlib import Path

import laspy
import numpy as np
from laspy.vlrs.known import WktCoordinateSystemVlr
from pyproj import CRS

ORIGIN = np.array([500_000.0, 3_500_000.0, 2.0])


def grid_points(count: int = 400, origin: np.ndarray = ORIGIN) -> np.ndarray:
    """(count, 3) points on a gently curved surface of 4 m by 4 m."""
    rng = np.random.default_rng(1)
    flat = rng.uniform(0, 4, (count, 2))
    return np.round(np.column_stack([flat, 0.1 * flat[:, 0] ** 2]) + origin, 3)


def write_las(
    path: Path,
    points: np.ndarray,
    crs: str | None = "EPSG:32650",
    *,
    point_format: int = 6,
    classification: np.ndarray | None = None,
    withheld: np.ndarray | None = None,
    source: np.ndarray | None = None,
    time: np.ndarray | None = None,
) -> Path:
    """Write points as LAS 1.4 (LAZ by the file's ending)."""
    header = laspy.LasHeader(version="1.4", point_format=point_format)
    header.scales = np.full(3, 0.001)
    header.offsets = np.floor(points.min(axis=0)) if len(points) else np.zeros(3)
    if crs is not None:
        header.global_encoding.wkt = True
        header.vlrs.append(WktCoordinateSystemVlr(CRS.from_user_input(crs).to_wkt("WKT1_GDAL")))
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T if len(points) else (np.empty(0),) * 3
    if classification is not None:
        las.classification = classification
    if withheld is not None:
        las.withheld = withheld
    if source is not None:
        las.point_source_id = source
    if time is not None:
        las.gps_time = time
    las.write(str(path))
    return path


def write_copc(path: Path, points: np.ndarray, crs: str = "EPSG:32650") -> Path:
    """Write points as a cloud-optimised point cloud of one node (COPC 1.0: info VLR first, hierarchy in an EVLR)."""
    from laspy.vlrs.vlr import VLR

    header = laspy.LasHeader(version="1.4", point_format=6)
    header.scales, header.offsets = np.full(3, 0.001), np.floor(points.min(axis=0))
    header.vlrs.append(VLR("copc", 1, "", bytes(160)))
    header.global_encoding.wkt = True
    header.vlrs.append(WktCoordinateSystemVlr(CRS.from_user_input(crs).to_wkt("WKT1_GDAL")))
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T
    las.write(str(path), do_compress=True)
    data = bytearray(path.read_bytes())
    (start,) = struct.unpack_from("<I", data, 96)
    (table,) = struct.unpack_from("<q", data, start)
    hierarchy = struct.pack("<4iQii", 0, 0, 0, 0, start + 8, table - start - 8, len(points))
    evlr = len(data)
    data += struct.pack("<H16sHQ32s", 0, b"copc", 1000, len(hierarchy), b"") + hierarchy
    struct.pack_into("<QI", data, 235, evlr, 1)
    low, high = points.min(axis=0), points.max(axis=0)
    half = float((high - low).max()) / 2
    info = struct.pack("<5dQQ2d", *((low + high) / 2), half, half / 16, evlr + 60, len(hierarchy), 0.0, 0.0)
    data[375 + 54 : 375 + 54 + len(info)] = info
    path.write_bytes(data)
    return path
