"""When the points of a tile were measured: GPS time of its first points, and the day its file was made."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import UTC, date, datetime, timedelta
from pathlib import Path

import numpy as np

from .las_files import open_points, read_header

GPS_ORIGIN = datetime(1980, 1, 6, tzinfo=UTC)
ADJUSTED_OFFSET = 1e9
"""Seconds that adjusted standard GPS time leaves out (LAS 1.4 R15, global encoding bit 0)."""
WEEK = 604_800
LEAP_SECONDS = (
    (datetime(2017, 1, 1, tzinfo=UTC), 18),
    (datetime(2015, 7, 1, tzinfo=UTC), 17),
    (datetime(2012, 7, 1, tzinfo=UTC), 16),
    (datetime(2009, 1, 1, tzinfo=UTC), 15),
    (datetime(2006, 1, 1, tzinfo=UTC), 14),
)
"""GPS less UTC from a day on, latest first (IERS Bulletin C); 13 s before."""
FIRST_POINTS = 20_000
"""Points whose times are read: the first chunk of a LAZ file is decompressed whole anyway."""
EARLIEST_YEAR = 1990


@dataclass(frozen=True)
class TileDates:
    """What a tile says about when it was measured.

    Attributes
    ----------
    measured
        UTC of its first points; None without GPS time, or with seconds of an unknown week.
    made
        Creation day of the header; None where there is none.
    """

    measured: datetime | None
    made: date | None


def tile_dates(path: Path) -> TileDates:
    """Read when a tile was measured and made.

    Raises
    ------
    InputError
        The tile is damaged.
    """
    with open_points(read_header(path)) as reader:
        made = reader.header.creation_date
        times = np.zeros(0)
        if "gps_time" in reader.header.point_format.dimension_names and reader.header.point_count:
            times = np.asarray(reader.read_points(FIRST_POINTS).gps_time, dtype=np.float64)
    times = times[np.isfinite(times) & (times != 0)]
    return TileDates(utc_of_gps(float(np.median(times))) if len(times) else None, made)


def utc_of_gps(seconds: float) -> datetime | None:
    """UTC of a GPS time of a LAS file; None for seconds of a week, which name no day, and for what lies in no plausible year.

    Files often declare the wrong kind; numbers of adjusted standard, standard and week time do not overlap in the years that matter.
    """
    if 0 <= seconds <= WEEK:
        return None
    since = seconds if seconds > ADJUSTED_OFFSET else seconds + ADJUSTED_OFFSET
    try:
        gps = GPS_ORIGIN + timedelta(seconds=since)
    except OverflowError:
        return None
    leap = next((count for first, count in LEAP_SECONDS if gps >= first), 13)
    utc = gps - timedelta(seconds=leap)
    return utc if EARLIEST_YEAR <= utc.year <= datetime.now(UTC).year + 1 else None
