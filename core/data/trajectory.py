"""Where the scanner was when it measured a point, and so in which directions the point's noise lies.

A flight or drive has a trajectory by GPS time, terrestrial scanning has stations by point source ID. Noise along the beam comes from the
range, noise across it from the angles; on a surface met at a slant they differ in what they do to the fit.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..common.arrays import FloatArray
from ..common.errors import InputError

if TYPE_CHECKING:
    from .survey import Epoch


TRAJECTORY_COLUMNS = ("gps_time", "x", "y", "z")
STATION_COLUMNS = ("point_source_id", "x", "y", "z")
MOST_GAP_SECONDS = 1.0
"""Longest stretch of a trajectory without a position in which points may lie: a vehicle that brakes or turns with 2 m/s^2 is then within
0.25 m of the straight line, which turns a beam of 50 m by 0.3 degrees."""


@dataclass(frozen=True, eq=False)
class Trajectory:
    """Positions of a moving sensor.

    Attributes
    ----------
    times
        (m,) GPS time in seconds, in the same count as the tiles', rising.
    positions
        (m, 3) metres, in the CRS of the survey.
    source
        The file.
    """

    times: FloatArray
    positions: FloatArray
    source: Path

    def at(self, gps_time: FloatArray) -> FloatArray:
        """(n, 3) positions at (n,) times, on straight lines between the trajectory's.

        Raises
        ------
        InputError
            A time outside the trajectory or missing (nan), or in a gap longer than ``MOST_GAP_SECONDS``.
        """
        outside = ~((gps_time >= self.times[0]) & (gps_time <= self.times[-1]))
        if outside.any():
            known = gps_time[outside & ~np.isnan(gps_time)]
            theirs = f"they have {known.min():.3f} to {known.max():.3f}" if len(known) else "they have none"
            raise InputError(
                f"does not reach {int(outside.sum())} of {len(gps_time)} points of a unit: it covers GPS time {self.times[0]:.3f} to "
                f"{self.times[-1]:.3f}, {theirs}",
                source=self.source,
                remedy="Give the whole trajectory of this epoch, with gps_time counted as in the tiles (seconds of the week, or "
                "standard GPS time less 1e9).",
            )
        after = np.clip(np.searchsorted(self.times, gps_time), 1, len(self.times) - 1)
        before = after - 1
        span = self.times[after] - self.times[before]
        share = (gps_time - self.times[before]) / span
        wide = (span > MOST_GAP_SECONDS) & (share > 0) & (share < 1)
        if wide.any():
            k = int(np.argmax(wide))
            raise InputError(
                f"has no position between GPS time {self.times[before[k]]:.3f} and {self.times[after[k]]:.3f}, where points were measured",
                source=self.source,
                remedy=f"Give at least one position every {MOST_GAP_SECONDS:g} s.",
            )
        return np.asarray(self.positions[before] + share[:, None] * (self.positions[after] - self.positions[before]))


def read_trajectory(path: str | Path) -> Trajectory:
    """Read ``gps_time,x,y,z``: seconds and metres in the CRS of the survey, in order of time.

    Raises
    ------
    InputError
        File, header, line or field that cannot be used: among others a time that is not after the one before it.
    """
    source = Path(path)
    table = _plain_numbers(source)
    if table is not None and len(table) > 1 and np.isfinite(table).all() and (np.diff(table[:, 0]) > 0).all():
        return Trajectory(np.ascontiguousarray(table[:, 0]), np.ascontiguousarray(table[:, 1:]), source)
    from .point_tables import read_point_table

    # slower, but knows the line of what is wrong
    rows = read_point_table(source, TRAJECTORY_COLUMNS, text=("gps_time",), unique=False)
    times = np.array([_number(row["gps_time"], source, row["line"], "gps_time") for row in rows])
    for previous, k in zip(range(len(rows) - 1), range(1, len(rows)), strict=True):
        if times[k] <= times[previous]:
            what = "repeats the time" if times[k] == times[previous] else "is earlier than that"
            raise InputError(
                f"GPS time {times[k]:.3f} {what} of line {rows[previous]['line']}",
                source=source,
                where=f"line {rows[k]['line']}, field gps_time",
                remedy="Sort the trajectory by time and keep one position for each.",
            )
    if len(rows) < 2:
        raise InputError(
            "holds a single position", source=source, remedy="A trajectory needs two or more; for a tripod give stations instead."
        )
    return Trajectory(times, np.array([[row[name] for name in ("x", "y", "z")] for row in rows]), source)


def read_stations(path: str | Path) -> dict[int, FloatArray]:
    """Read ``point_source_id,x,y,z``: (3,) position of each scanner station in the CRS of the survey, metres, by LAS point source ID.

    Raises
    ------
    InputError
        File, header, line or field that cannot be used.
    """
    from .point_tables import read_point_table

    source = Path(path)
    stations: dict[int, FloatArray] = {}
    for row in read_point_table(source, STATION_COLUMNS, text=("point_source_id",)):
        name = row["point_source_id"]
        if not (name.isascii() and name.isdigit() and int(name) <= np.iinfo(np.uint16).max and int(name) not in stations):
            raise InputError(
                f"point_source_id {name!r} is no whole number from 0 to 65535, or not the only one",
                source=source,
                where=f"line {row['line']}, field point_source_id",
                remedy="Write the LAS point source ID of the station's points.",
            )
        stations[int(name)] = np.array([row["x"], row["y"], row["z"]])
    return stations


@dataclass(frozen=True)
class BeamNoise:
    """What is known about the noise of an epoch's points: of ranges and angles, and where the sensor was.

    Attributes
    ----------
    range_sd
        Standard deviation along the beam, metres.
    angle_sd
        Standard deviation of each of the beam's two directions, radians.
    trajectory, stations
        CSV files, at least one: see :func:`read_trajectory` and :func:`read_stations`. Points of a source that has no station belong to
        the trajectory.
    checksums
        Of the files there are.
    """

    range_sd: float
    angle_sd: float
    trajectory: Path | None
    stations: Path | None
    checksums: tuple[str, ...]

    def sensors(self, source_id: NDArray[np.uint16], gps_time: FloatArray) -> FloatArray:
        """(n, 3) positions of the sensor for points of (n,) point source IDs and GPS times (not used where there is no trajectory).

        Raises
        ------
        InputError
            A point without station and trajectory, or outside the trajectory.
        """
        result = np.full((len(source_id), 3), math.nan)
        if self.stations is not None:
            for number, place in _stations(self.stations, self.checksums).items():
                result[source_id == number] = place
        rest = np.isnan(result[:, 0])
        if rest.any():
            if self.trajectory is None:
                missing = ", ".join(map(str, np.unique(source_id[rest])[:5]))
                raise InputError(
                    f"has no station for point source ID {missing}",
                    source=self.stations,
                    remedy="Add a line for each station, or give a trajectory for the other points.",
                )
            result[rest] = _trajectory(self.trajectory, self.checksums).at(gps_time[rest])
        return result

    def covariances(
        self, points: FloatArray, origin: FloatArray, source_id: NDArray[np.uint16], gps_time: FloatArray, roughness: float
    ) -> FloatArray:
        """(n, 3, 3) covariance of points, square metres.

        Parameters
        ----------
        points, origin
            (n, 3) metres less ``origin``, the (3,) reduction point in the CRS of the survey.
        source_id, gps_time
            (n,) as in the tiles.
        roughness
            Standard deviation of the surface itself about the model, metres: without it a surface that is met at a slant, where the range
            says little about the distance to it, would be trusted without limit.
        """
        return surface_covariances(points, self.sensors(source_id, gps_time) - origin, self.range_sd, self.angle_sd, roughness)


def noise_of(epoch: Epoch, checksum: Callable[[Path], str]) -> BeamNoise | None:
    """Noise along and across the beams, where the epoch gives the sensor's positions; ``checksum`` gives that of a file."""
    if epoch.range_sd is None or epoch.angle_sd is None:
        return None
    checksums = tuple(checksum(path) for path in (epoch.trajectory, epoch.stations) if path is not None)
    return BeamNoise(epoch.range_sd, math.radians(epoch.angle_sd), epoch.trajectory, epoch.stations, checksums)


def beam_covariances(points: ArrayLike, sensors: ArrayLike, range_sd: float, angle_sd: float) -> FloatArray:
    """(n, 3, 3) covariance of points measured along beams, square metres.

    Parameters
    ----------
    points
        (n, 3) metres.
    sensors
        (3,) or (n, 3) position of the sensor at the time of each point, in the same frame.
    range_sd
        Standard deviation along the beam, metres.
    angle_sd
        Standard deviation of each of the two directions, radians.
    """
    beams = np.asarray(points, dtype=np.float64) - np.asarray(sensors, dtype=np.float64)
    ranges = np.linalg.norm(beams, axis=1)
    if (ranges == 0).any():
        raise ValueError("a point coincides with its sensor")
    directions = beams / ranges[:, None]
    along = directions[:, :, None] * directions[:, None, :]
    return np.asarray(range_sd**2 * along + ((angle_sd * ranges) ** 2)[:, None, None] * (np.eye(3) - along))


def surface_covariances(points: FloatArray, sensors: FloatArray, range_sd: float, angle_sd: float, roughness: float) -> FloatArray:
    """(n, 3, 3) covariance, square metres, of points of a surface measured from (n, 3) sensors in their frame.

    ``range_sd``, ``angle_sd`` and ``roughness`` as in :class:`BeamNoise`.
    """
    return np.asarray(beam_covariances(points, sensors, range_sd, angle_sd) + roughness**2 * np.eye(3))


# an epoch's blocks are fitted one after another in the same process: one reading serves them all
@lru_cache(maxsize=4)
def _trajectory(path: Path, checksums: tuple[str, ...]) -> Trajectory:
    return read_trajectory(path)


@lru_cache(maxsize=4)
def _stations(path: Path, checksums: tuple[str, ...]) -> dict[int, FloatArray]:
    return read_stations(path)


def _plain_numbers(path: Path) -> FloatArray | None:
    """(m, 4) columns of a trajectory whose file is nothing but numbers under a header; None for any other file."""
    try:
        with path.open(encoding="utf-8-sig") as stream, warnings.catch_warnings():
            # numpy only warns of a file without rows
            warnings.simplefilter("error")
            names = [name.strip().lower() for name in stream.readline().split(",")]
            columns = [names.index(name) for name in TRAJECTORY_COLUMNS]
            return np.loadtxt(stream, delimiter=",", usecols=columns, ndmin=2, comments=None)
    except (OSError, ValueError, UserWarning):
        return None


def _number(text: str, source: Path, line: int, field: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise InputError(f"{text!r} is not a number", source=source, where=f"line {line}, field {field}", remedy="Give seconds.")
    return value
