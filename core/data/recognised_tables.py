"""What the tables beside a survey's tiles are: control, targets, check points, trajectories, stations, told by columns, names and place."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from ..common.arrays import FloatArray
from .dates_in_names import NamedDate, date_in_name
from .table_text import UNIT_NAMES, TableError, TextTable, columns_of, decoded, split_table

Role = Literal["control", "targets", "check", "trajectory", "stations"]
Extent = tuple[float, float, float, float]

ENDINGS = (".csv", ".txt", ".tsv")
MOST_BYTES = 50_000_000
"""Larger text files are point clouds."""
ROLE_WORDS: dict[Role, tuple[str, ...]] = {
    "check": ("check", "validation", "verif", "prüf", "检查", "検証", "검사"),
    "targets": ("target", "cloud", "scan", "sphere", "marke", "ziel", "标靶", "ターゲット", "표적"),
    "control": ("control", "gcp", "survey", "fixed", "station_coord", "pass", "控制", "基準", "기준"),
    "trajectory": ("traj", "sbet", "flight", "pos", "轨迹", "軌跡"),
    "stations": ("station", "scanner", "setup", "测站"),
}
"""Words in file names that tell what a table is, where its columns leave it open."""
ANGLE_OF_TRAJECTORY_ROWS = 50
"""A table of times and places with fewer lines is no trajectory."""
NEAR = 2.0
"""A table belongs to tiles whose extent, grown by this multiple of its size and 100 m, holds most of its points."""
FEET: tuple[tuple[str, float], ...] = (("m", 1.0), ("ft", 0.3048), ("us-ft", 1200 / 3937))


@dataclass(frozen=True, eq=False)
class FoundTable:
    """A table and what it is.

    Attributes
    ----------
    path, role
        The file, and what it holds.
    named
        Date in its name or its folder's; None where there is none.
    points
        Names of its points, as far as it has names.
    unit
        Length unit of its numbers.
    swapped
        Its first coordinate is the northing.
    sds
        It states standard deviations.
    changes
        How its numbers differ from metres with easting first, in words.
    reason
        What told all this, as a comment.
    """

    path: Path
    role: Role
    named: NamedDate | None
    points: frozenset[str]
    unit: str
    swapped: bool
    sds: bool
    changes: tuple[str, ...]
    reason: str


@dataclass(frozen=True, eq=False)
class _Candidate:
    path: Path
    table: TextTable
    columns: dict[str, int]
    coordinates: FloatArray


def find_tables(places: Iterable[Path]) -> list[Path]:
    """Text tables in folders (or beside files) and below, and right beside the folders; hidden ones left out."""
    found: dict[Path, None] = {}
    for place in places:
        folder = (place if place.is_dir() else place.parent).absolute()
        for path in sorted([*folder.rglob("*"), *folder.parent.glob("*")]):
            hidden = any(part.startswith(".") for part in path.relative_to(folder.parent).parts[1:])
            if path.suffix.lower() in ENDINGS and not hidden and path.is_file() and path.stat().st_size < MOST_BYTES:
                found[path] = None
    return list(found)


def recognise(paths: Iterable[Path], extent: Extent, *, local: bool = False) -> tuple[list[FoundTable], list[str]]:
    """Tables that belong to tiles of an extent, and a sentence on every other one that looks like points but is not used.

    Parameters
    ----------
    extent
        West, south, east, north of the tiles, metres.
    local
        The frame is a laboratory's: nearness then is a matter of metres.
    """
    tables, notes = [], []
    for path in paths:
        found = _recognised(path, extent, local)
        if isinstance(found, FoundTable):
            tables.append(found)
        elif found:
            notes.append(found)
    return tables, notes


def assign(tables: Sequence[FoundTable], label: str, folder: Path, *, others: Sequence[str]) -> dict[Role, FoundTable]:
    """The table of each role that belongs to an epoch: by the date in its name, by its folder, or as the only one of its role.

    Parameters
    ----------
    label, folder
        Of the epoch, and where its tiles lie.
    others
        Labels of all epochs.
    """
    out: dict[Role, FoundTable] = {}
    for role in ROLE_WORDS:
        mine = [table for table in tables if table.role == role]
        dated = [table for table in mine if table.named is not None and _same_date(table.named, label)]
        beside = [table for table in mine if table.path.parent == folder]
        undated = [table for table in mine if table.named is None or not any(_same_date(table.named, other) for other in others)]
        chosen = dated or beside or (undated if len(undated) == 1 else [])
        if len(chosen) == 1:
            out[role] = chosen[0]
    return out


def _same_date(named: NamedDate, label: str) -> bool:
    return label.startswith(named.label) or named.label.startswith(label)


def _start_of(path: Path) -> bytes:
    with path.open("rb") as stream:
        return stream.read(2_000_000)


def _recognised(path: Path, extent: Extent, local: bool) -> FoundTable | str:
    """What a table is, or why it is not used; an empty text where it is no table of points at all."""
    try:
        table = split_table(decoded(_start_of(path), "replace"))
    except (OSError, TableError):
        return ""
    role, columns = _role(path, table)
    if role is None:
        return _headless(path, table)
    axes = {"check": ("easting", "northing"), "control": ("easting", "northing")}.get(role, ("x", "y"))
    coordinates = _numbers(table, columns, axes)
    if not len(coordinates):
        return f"{path.name} has columns of {role} but no lines that can be read"
    placed = _place(coordinates, extent, local, _stated_unit(table, columns, axes))
    if placed is None:
        e, n = np.median(coordinates, axis=0)
        return f"{path.name} looks like {role}, but its points lie elsewhere (about {e:.0f}, {n:.0f}): not used"
    unit, swapped = placed
    name = columns.get("point_id")
    points = frozenset(fields[name].strip() for _, fields in table.rows if name is not None and name < len(fields))
    changes = ["northing before easting"] if swapped else []
    if unit != "m":
        changes.append("feet" if unit == "ft" else "US survey feet")
    # a run reads decimal commas as they are
    told = ", ".join(["decimal commas", *changes] if table.decimal_commas else changes)
    reason = "columns and place" + (f"; {told}" if told else "")
    return FoundTable(
        path, role, _date(path), points, unit=unit, swapped=swapped, sds="sd_e" in columns, changes=tuple(changes), reason=reason
    )


def _date(path: Path) -> NamedDate | None:
    return date_in_name(path.stem, years_alone=False) or date_in_name(path.parent.name, years_alone=False)


def _role(path: Path, table: TextTable) -> tuple[Role | None, dict[str, int]]:
    """What a table's columns allow, and of that what its name says."""
    names = table.names
    words = path.stem.lower()
    check = columns_of(names, ("point_id", "unit_easting", "unit_northing", "unit_height", "easting", "northing", "height", "sd"))
    if {"point_id", "unit_easting", "unit_northing", "unit_height", "easting", "northing", "height"} <= check.keys():
        return "check", check
    moving = columns_of(names, ("gps_time", "x", "y", "z"))
    if len(moving) == 4 and len(table.rows) >= ANGLE_OF_TRAJECTORY_ROWS and "point_id" not in names:
        return "trajectory", moving
    if "point_source_id" in names or any(word in words for word in ROLE_WORDS["stations"]):
        fixed = columns_of(names, ("point_source_id", "x", "y", "z"))
        if len(fixed) == 4:
            return "stations", fixed
    control = columns_of(names, ("point_id", "easting", "northing", "height", "sd_e", "sd_n", "sd_h"))
    targets = columns_of(names, ("point_id", "x", "y", "z", "sd"))
    for role in ("targets", "control"):
        columns = control if role == "control" else targets
        wanted = ("easting", "northing", "height") if role == "control" else ("x", "y", "z")
        if any(word in words for word in ROLE_WORDS[role]) and {"point_id", *wanted} <= columns.keys():
            return role, columns
    if {"point_id", "easting", "northing", "height"} <= control.keys() and ("sd_e" in control or "easting" in names):
        return "control", control
    if {"point_id", "x", "y", "z"} <= targets.keys():
        return "targets", targets
    return None, {}


def _headless(path: Path, table: TextTable) -> str:
    """A sentence on a table of points without a header line, as many instruments write it."""
    first = table.names
    numeric = sum(_number(name) is not None for name in first)
    if len(first) >= 4 and numeric >= 3 and len(table.rows):
        return f"{path.name} looks like points, but has no header line: add one, such as point_id,easting,northing,height,sd_e,sd_n,sd_h"
    return ""


def _numbers(table: TextTable, columns: dict[str, int], axes: Sequence[str]) -> FloatArray:
    """(n, 2) coordinates of the lines that hold them."""
    out = []
    for _, fields in table.rows:
        values = [_number(fields[columns[axis]]) if columns[axis] < len(fields) else None for axis in axes]
        if None not in values:
            out.append(values)
    return np.array(out, dtype=np.float64).reshape(-1, 2)


def _number(text: str) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def _stated_unit(table: TextTable, columns: dict[str, int], axes: Sequence[str]) -> str | None:
    return UNIT_NAMES.get(table.units[columns[axes[0]]].replace(" ", ""))


def _place(coordinates: FloatArray, extent: Extent, local: bool, stated: str | None) -> tuple[str, bool] | None:
    """Unit and axis order by which a table's points lie near the tiles, plain metres first; None where none does."""
    west, south, east, north = extent
    margin = NEAR * max(east - west, north - south) + (2.0 if local else 100.0)
    for unit, factor in FEET:
        if stated is not None and unit != stated:
            continue
        for swapped in (False, True):
            e, n = (coordinates[:, ::-1] if swapped else coordinates).T * factor
            inside = (e > west - margin) & (e < east + margin) & (n > south - margin) & (n < north + margin)
            if inside.mean() > 0.5:
                return unit, swapped
    return None
