"""E57 and PLY clouds, read by their own libraries once and kept as LAZ in the user's cache, where all else reads them as tiles.

PLY states no CRS and E57 seldom does: ``undeclared_crs`` or ``tiles_crs`` of survey.toml says it.
"""

from __future__ import annotations

import contextlib
import os
import re
import subprocess  # nosec B404 - a reader is started with fixed arguments
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field
from datetime import date, timedelta
from pathlib import Path
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.atomic_files import cannot_write, temporary_beside, temporary_folder
from ..common.errors import InputError
from ..common.user_cache import cache_folder, drop_unused
from .scan_cache import key_of

E57, PLY = ".e57", ".ply"
ENDINGS = (E57, PLY)
RESOLUTION = 1e-4
"""Metres; step of the copies' coordinates, so that extents of 200 km fit."""
COARSEST = 2e-3
"""Metres; numbers of single precision whose steps are larger no longer carry what a survey measured."""
E57_POINTS = 2_000_000
"""Points read at a time from an E57."""
E57_ORIGIN = date(1980, 1, 6)
"""From here E57 counts seconds (ASTM E2807-11, 8.4.3, dateTimeValue)."""
CARTESIAN = ("cartesianX", "cartesianY", "cartesianZ")
SPHERICAL = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
PLY_PROGRAM = """
import sys, numpy, open3d
cloud = open3d.t.io.read_point_cloud(sys.argv[1], format="ply")
if "positions" in cloud.point:
    numpy.save(sys.argv[2], cloud.point.positions.numpy())
"""
INSTALL = 'Install it beside the engine (pip install "tetratrack[e57]"), or export the scans as LAZ.'


@dataclass(kw_only=True)
class _Cloud:
    """What a file holds: (n, 3) positions by part, each with the number of its scan, its CRS as WKT and its day, where it states them."""

    parts: Iterator[tuple[FloatArray, int]]
    wkt: str = ""
    day: date | None = None
    close: contextlib.ExitStack = field(default_factory=contextlib.ExitStack)


def as_las(path: Path) -> Path:
    """The file itself, or the LAZ that stands for it in the user's cache, made where there is none of its present state.

    Raises
    ------
    InputError
        An E57 or PLY that cannot be read, or for which the reader or a place for the copy is missing.
    OutputError
        The copy cannot be written.
    OSError
        The file is missing or unreadable.
    """
    ending = path.suffix.lower()
    if ending not in ENDINGS:
        return path
    folder = cache_folder("clouds")
    if folder is None:
        raise InputError(
            "is read by way of a copy, and there is no cache folder for it",
            source=path,
            remedy="Set XDG_CACHE_HOME to a folder that can be written, or export the cloud as LAZ.",
        )
    copy = folder / f"{key_of(path, 'copy as LAZ')}.laz"
    if copy.is_file():
        os.utime(copy)
        return copy
    drop_unused(folder, "*.laz")
    with contextlib.ExitStack() as stack:
        cloud = _e57(path) if ending == E57 else _ply(path)
        stack.enter_context(cloud.close)
        temporary = stack.enter_context(temporary_beside(copy))
        try:
            _write(cloud, temporary)
        except (InputError, MemoryError):
            raise
        except OSError as error:
            raise cannot_write(copy, error) from error
        except Exception as error:
            # libE57 reports damage through exceptions of its own
            raise _damaged(path, error) from error
        temporary.replace(copy)
    return copy


def _damaged(path: Path, error: BaseException) -> InputError:
    # libE57 adds the names of its errors, and where in its source they came up
    reason = re.split(r"\s*(?:\(Error|\*\*\*)", " ".join(str(error).split()))[0][:120]
    return InputError(f"cannot be read as {path.suffix[1:].upper()} ({reason})", source=path, remedy="Export it again, or as LAZ.")


def _write(cloud: _Cloud, target: Path) -> None:
    """LAS 1.4, point format 0: no time is known; the source is the number of the scan."""
    import laspy

    header = laspy.LasHeader(point_format=0, version="1.4")
    header.scales = np.full(3, RESOLUTION)
    header.generating_software = "tetratrack"
    header.creation_date = cloud.day
    if cloud.wkt:
        header.vlrs.append(laspy.vlrs.known.WktCoordinateSystemVlr(cloud.wkt))
        header.global_encoding.wkt = True
    writer = None
    with target.open("wb") as stream:
        for xyz, scan in cloud.parts:
            if writer is None:
                header.offsets = np.floor(xyz[0]) if len(xyz) else np.zeros(3)
                writer = laspy.open(stream, mode="w", header=header, do_compress=True, laz_backend=laspy.LazBackend.Lazrs, closefd=False)
            record = laspy.ScaleAwarePointRecord.zeros(len(xyz), header=header)
            record.x, record.y, record.z = xyz.T
            record.point_source_id[:] = min(scan, 65535)
            writer.write_points(record)
        if writer is not None:
            writer.close()


def _ply(path: Path) -> _Cloud:
    """Vertices of a PLY, read by a process of its own: damaged files end Open3D's reader without a word, or leave numbers nobody wrote."""
    if path.stat().st_size == 0:
        raise InputError("is empty", source=path, remedy="Export it again.")
    with temporary_folder() as folder:
        target = folder / "positions.npy"
        # the interpreter that runs this, with a program of this module and two paths
        command = [sys.executable, "-I", "-c", PLY_PROGRAM, str(path.absolute()), str(target)]
        done = subprocess.run(command, capture_output=True, stdin=subprocess.DEVNULL, check=False)  # nosec B603
        if done.returncode or b"failed" in done.stdout or not target.is_file():
            header = b"header" in done.stdout
            raise _damaged(path, ValueError("its header makes no sense" if header else "it is damaged, or ends early"))
        stored = np.load(target, allow_pickle=False)
    xyz = np.asarray(stored, dtype=np.float64)
    _check(xyz, path)
    if stored.dtype == np.float32 and len(stored):
        step = float(np.spacing(np.abs(stored).max()))
        if step > COARSEST:
            raise InputError(
                f"holds coordinates of single precision, which stand {step:.2g} m apart so far from the origin",
                source=path,
                remedy="Export it with double precision or less its offset, or as LAZ.",
            )
    return _Cloud(parts=iter([(xyz, 0)]))


def _e57(path: Path) -> _Cloud:
    """Scans of an E57 in the frame of the file; points that the scanner marked as invalid are left out."""
    try:
        import pye57
    except ImportError as error:
        raise InputError("is an E57 file, and its reader pye57 is not installed", source=path, remedy=INSTALL) from error
    if path.stat().st_size == 0:
        raise InputError("is empty", source=path, remedy="Export it again.")
    try:
        file = pye57.E57(str(path))
        scans = [file.get_header(k) for k in range(file.scan_count)]
        root = file.root
        wkt = root["coordinateMetadata"].value() if root.isDefined("coordinateMetadata") else ""
        day = _day(scans)
    except Exception as error:
        raise _damaged(path, error) from error
    if not any(scan.point_count for scan in scans):
        raise InputError("holds no points", source=path, remedy="Export the scans with their points.")
    cloud = _Cloud(parts=_e57_parts(file, scans, path), wkt=wkt if "[" in wkt else "", day=day)
    cloud.close.callback(file.close)
    return cloud


def _day(scans: list[Any]) -> date | None:
    """Day of the first scan."""
    starts = [scan["acquisitionStart"]["dateTimeValue"].value() for scan in scans if scan.node.isDefined("acquisitionStart")]
    known = [start for start in starts if start > 0]
    return E57_ORIGIN + timedelta(seconds=min(known)) if known else None


def _e57_parts(file: Any, scans: list[Any], path: Path) -> Iterator[tuple[FloatArray, int]]:
    for number, scan in enumerate(scans, start=1):
        names = CARTESIAN if set(CARTESIAN) <= set(scan.point_fields) else SPHERICAL
        if not set(names) <= set(scan.point_fields):
            raise InputError(f"has no coordinates in scan {number}", source=path, remedy="Export the scans with their points.")
        flag = "cartesianInvalidState" if names is CARTESIAN else "sphericalInvalidState"
        fields = [*names, *([flag] if flag in scan.point_fields else [])]
        data, buffers = file.make_buffers(fields, min(E57_POINTS, max(scan.point_count, 1)))
        reader = scan.points.reader(buffers)
        try:
            while count := reader.read():
                own = np.column_stack([np.asarray(data[name][:count], dtype=np.float64) for name in names])
                if flag in data:
                    own = own[data[flag][:count] == 0]
                if names is SPHERICAL:
                    own = _cartesian(own)
                xyz = own @ scan.rotation_matrix.T + scan.translation
                _check(xyz, path)
                yield xyz, number
        finally:
            reader.close()


def _cartesian(polar: FloatArray) -> FloatArray:
    """(n, 3) x, y, z from range, azimuth and elevation, radians (ASTM E2807-11, 4.1.2)."""
    distance, azimuth, elevation = polar.T
    level = distance * np.cos(elevation)
    return np.column_stack([level * np.cos(azimuth), level * np.sin(azimuth), distance * np.sin(elevation)])


def _check(xyz: FloatArray, path: Path) -> None:
    if not np.isfinite(xyz).all():
        raise InputError("holds points without finite coordinates", source=path, remedy="Export it again, or as LAZ.")
    if len(xyz) and np.ptp(xyz, axis=0).max() > 1e5:
        raise InputError("holds points more than 100 km apart", source=path, remedy="Take out the strays, and export it again.")
