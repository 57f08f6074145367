"""Files of a simulated survey: LAZ tiles and CSV tables."""

from __future__ import annotations

import csv
from collections.abc import Iterable
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from ..common.arrays import FloatArray
from ..data.crs import parse_crs, wkt_of
from .survey_plan import SimulationPlan
from .virtual_scanner import Returns

LOCAL_WKT = (
    'ENGCRS["Laboratory frame",EDATUM["Laboratory"],CS[Cartesian,3],AXIS["x",east,ORDER[1],LENGTHUNIT["metre",1]],'
    'AXIS["y",north,ORDER[2],LENGTHUNIT["metre",1]],AXIS["z",up,ORDER[3],LENGTHUNIT["metre",1]]]'
)


def tile_edges(middle: float, values: FloatArray, count: int, plan: SimulationPlan) -> FloatArray:
    """Inner tile edges at round coordinates, about equal strips."""
    if count == 1:
        return np.array([])
    low, high = float(values.min()), float(values.max())
    inner = low + (high - low) * np.arange(1, count) / count
    if count == 2:
        inner = np.array([middle])
    step = 0.02 if plan.laboratory else 0.5
    return np.asarray(np.round(inner / step) * step)


def write_las(path: Path, points: FloatArray, cloud: Returns, plan: SimulationPlan, time: datetime, generator: str) -> None:
    """Write one tile: LAS 1.4 of point format 6 with the CRS of the plan, compressed by the ending of the name."""
    import laspy
    from laspy.vlrs.known import WktCoordinateSystemVlr

    header = laspy.LasHeader(version="1.4", point_format=6)
    scale, block = (0.0001, 1.0) if plan.laboratory else (0.001, 100.0)
    header.scales = np.full(3, scale)
    header.offsets = np.floor(np.append(points[0, :2], 0.0) / block) * block
    header.generating_software = generator
    header.creation_date = time.date()
    header.global_encoding.gps_time_type = laspy.header.GpsTimeType.STANDARD
    header.global_encoding.wkt = True
    wkt = LOCAL_WKT if plan.crs == "LOCAL" else wkt_of(parse_crs(plan.las_crs or plan.crs))[0]
    header.vlrs.append(WktCoordinateSystemVlr(wkt))
    las = laspy.LasData(header)
    las.x, las.y, las.z = points[:, 0], points[:, 1], points[:, 2]
    las.intensity = cloud.intensity
    las.return_number = cloud.return_number
    las.number_of_returns = cloud.returns
    las.classification = np.ones(len(points), dtype=np.uint8)
    las.point_source_id = cloud.source.astype(np.uint16)
    las.gps_time = gps_seconds(time) + cloud.time
    las.write(str(path))


def gps_seconds(time: datetime) -> float:
    """Adjusted standard GPS time: seconds since 1980-01-06 less 1e9; 18 leap seconds since 2017."""
    return (time - datetime(1980, 1, 6, tzinfo=UTC)).total_seconds() + 18 - 1e9


def write_csv(path: Path, header: str, rows: Iterable[Iterable[object]]) -> None:
    """Write rows under a header of names with commas between."""
    with path.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(header.split(","))
        writer.writerows(rows)
