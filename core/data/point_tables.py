"""CSV tables of points that the user gives: surveyed control, targets in a cloud, check points, stations, trajectories."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from textwrap import shorten
from typing import Any, Literal

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..common.input_files import content_of
from .table_text import UNIT_NAMES, TableError, columns_of, decoded, split_table

Axes = Literal["en", "ne"]
CONTROL_COLUMNS = ("point_id", "easting", "northing", "height", "sd_e", "sd_n", "sd_h")
TARGET_COLUMNS = ("point_id", "x", "y", "z")
SMALL_UNITS = ("mm", "cm", "dm")
LARGEST = 1e12
"""No coordinate and no time is as large."""


@dataclass(frozen=True, eq=False)
class SurveyedPoints:
    """Named points of one file.

    Attributes
    ----------
    ids
        Names, unique.
    coordinates
        (n, 3) metres.
    sds
        (n, 3) standard deviations, metres; zero where the file states none.
    source
        File the points come from; None for points made in memory.
    """

    ids: tuple[str, ...]
    coordinates: FloatArray
    sds: FloatArray
    source: Path | None = None


def read_control(path: str | Path, *, axes: Axes = "en", sd: float | None = None, unit: str | None = None) -> SurveyedPoints:
    """Read surveyed targets: ``point_id,easting,northing,height,sd_e,sd_n,sd_h``.

    Parameters
    ----------
    axes
        ``ne`` where what the file calls easting, or x, is the northing.
    sd
        Standard deviation of every coordinate in the unit of the file where it states none; None asks the file for its own.
    unit
        ``m``, ``ft`` or ``us-ft``, which no unit in the header may contradict; None takes feet as well as metres.

    Raises
    ------
    InputError
        File, header, line or field that cannot be used.
    """
    deviations = CONTROL_COLUMNS[4:]
    rows = read_point_table(path, CONTROL_COLUMNS[:4] if sd is not None else CONTROL_COLUMNS, positive=deviations, unit=unit)
    for row in rows:
        if axes == "ne":
            row["easting"], row["northing"] = row["northing"], row["easting"]
            row["sd_e"], row["sd_n"] = row.get("sd_n", sd), row.get("sd_e", sd)
        row |= {name: sd for name in deviations if row.get(name) is None}
    return _points(rows, ("easting", "northing", "height"), deviations, Path(path))


def read_targets(path: str | Path) -> SurveyedPoints:
    """Read targets as measured in the cloud: ``point_id,x,y,z`` and optionally ``sd`` in metres, of all targets or of none.

    Raises
    ------
    InputError
        File, header, line or field that cannot be used.
    """
    rows = read_point_table(path, TARGET_COLUMNS, positive=("sd",))
    stated = [row for row in rows if "sd" in row]
    if stated and len(stated) < len(rows):
        line = next(row["line"] for row in rows if "sd" not in row)
        remedy = "Give it for every target, or leave the column out."
        raise InputError("has no standard deviation", source=path, where=f"line {line}, field sd", remedy=remedy)
    sds = ("sd", "sd", "sd") if stated else ()
    return _points(rows, ("x", "y", "z"), sds, Path(path))


def read_point_table(
    path: str | Path,
    columns: Sequence[str],
    *,
    positive: Iterable[str] = (),
    text: Iterable[str] = ("point_id",),
    unique: bool = True,
    may_be_empty: bool = False,
    unit: str | None = "m",
) -> list[dict[str, Any]]:
    """Read a CSV of points: numbers as float, ``text`` columns as str; the key ``line`` tells where a row stands.

    Columns may bear other customary names (:mod:`table_text`), be separated by semicolons or tabs, and then hold decimal commas.
    Further columns are kept if they hold numbers. The first of ``text`` is the name and must be unique unless ``unique`` is False. No
    points at all are an error unless they ``may_be_empty``. A header such as ``height [ft]`` must not state another ``unit`` of length.

    Raises
    ------
    InputError
        With the line and field at fault.
    """
    source, text, positive = Path(path), tuple(text), tuple(positive)
    try:
        table = split_table(decoded(content_of(source)))
    except TableError as error:
        unclosed = "Look for a quotation mark that is not closed."
        remedy = "Save it as UTF-8 text with commas (CSV)." if "text" in str(error) else unclosed
        raise InputError(f"is no table ({error})", source=source, where=f"line {error.line}", remedy=remedy) from None
    except FileNotFoundError:
        raise InputError("does not exist", source=source, remedy="Correct the path in survey.toml.") from None
    except OSError as error:
        raise InputError(
            f"cannot be read ({error.strerror or error})", source=source, remedy="Check the file's permissions and disk."
        ) from None
    names = _header(table.names, columns, positive, source)
    _check_units([(name, stated) for name, stated in zip(names, table.units) if name in (*columns, *positive)], unit, source)
    rows: list[dict[str, Any]] = []
    seen: dict[str, int] = {}
    for number, fields in table.rows:
        if len(fields) != len(names):
            raise InputError(
                f"has {len(fields)} fields, the header {len(names)}",
                source=source,
                where=f"line {number}",
                remedy="Use a point as decimal sign and one comma between fields, or semicolons between fields.",
            )
        row: dict[str, Any] = {"line": number}
        for name, field in zip(names, fields):
            if name in text:
                row[name] = field.strip()
            elif name in columns or field.strip():
                value = _value(field, name, columns, positive, source, number)
                if value is not None:
                    row[name] = value
        key = str(row[text[0]])
        if not key:
            raise InputError("has an empty name", source=source, where=f"line {number}, field {text[0]}", remedy="Name every point.")
        if unique and key in seen:
            raise InputError(
                f"names point {key!r} again (first in line {seen[key]})",
                source=source,
                where=f"line {number}, field {text[0]}",
                remedy="Every point of an epoch needs a name of its own: rename or remove one.",
            )
        seen.setdefault(key, number)
        rows.append(row)
    if not (rows or may_be_empty):
        raise InputError("holds no points", source=source, remedy="Write one line for each point under the header.")
    return rows


def _header(header: Iterable[str], columns: Sequence[str], positive: Sequence[str], source: Path) -> list[str]:
    """Names of the columns, those that are known by the names used here."""
    names = list(header)
    known = columns_of(names, (*columns, *positive))
    missing = [name for name in columns if name not in known]
    if missing:
        found = shorten(", ".join(names), 200, placeholder=" …") if any(names) else "nothing"
        raise InputError(
            f"has no column {', '.join(missing)}; found {found}",
            source=source,
            where="line 1",
            remedy=f"The header must be {','.join(columns)}.",
        )
    repeated = {name for name in columns if names.count(name) > 1}
    if repeated:
        raise InputError(f"has column {', '.join(sorted(repeated))} twice", source=source, where="line 1", remedy="Name every column once.")
    for name, index in known.items():
        names[index] = name
    return names


def _check_units(stated: Iterable[tuple[str, str]], unit: str | None, source: Path) -> None:
    """Refuse columns whose header states another unit of length than theirs; ``ft`` leaves open which foot."""
    for name, text in stated:
        words = text.replace(" ", "")
        found = UNIT_NAMES.get(words, words if words in SMALL_UNITS else None)
        if found is None or found == unit or (unit is None and found not in SMALL_UNITS) or (found == "ft" and unit == "us-ft"):
            continue
        if found in SMALL_UNITS:
            remedy = "Give metres: 0.003 for 3 mm."
        elif unit == "m":
            remedy = f'Give metres; control that is in feet throughout needs control_unit = "{found}".'
        else:
            remedy = f'All numbers of a file with control_unit = "{unit}" are in that unit, standard deviations too.'
        raise InputError(f"states {name} [{text}]", source=source, where="line 1", remedy=remedy)


def _points(rows: list[dict[str, Any]], axes: Sequence[str], sds: Sequence[str], source: Path) -> SurveyedPoints:
    coordinates = np.array([[row[a] for a in axes] for row in rows], dtype=np.float64)
    deviations = np.array([[row[s] for s in sds] for row in rows], dtype=np.float64) if sds else np.zeros_like(coordinates)
    return SurveyedPoints(tuple(str(row["point_id"]) for row in rows), coordinates, deviations, source)


def _value(field: str, name: str, columns: Sequence[str], positive: Sequence[str], source: Path, line: int) -> float | None:
    value = _number(field, name, name in columns or name in positive, source, line)
    if name in positive and value is not None and value <= 0:
        raise InputError(
            f"standard deviation {_shown(field)} is not positive",
            source=source,
            where=f"line {line}, field {name}",
            remedy="Give the standard deviation of the coordinate in metres.",
        )
    return value


def _shown(field: str) -> str:
    """As much of a field as a message has room for."""
    return field.strip()[:40]


def _number(field: str, name: str, required: bool, source: Path, line: int) -> float | None:
    try:
        value = float(field)
    except ValueError:
        if not required:
            return None
        raise InputError(
            f"{_shown(field)!r} is not a number",
            source=source,
            where=f"line {line}, field {name}",
            remedy="Use a point as decimal sign.",
        ) from None
    if math.isfinite(value) and abs(value) > LARGEST:
        raise InputError(
            f"{_shown(field)} is too large", source=source, where=f"line {line}, field {name}", remedy="Give it in metres or seconds."
        )
    if not math.isfinite(value):
        raise InputError(
            f"{_shown(field)} is not finite", source=source, where=f"line {line}, field {name}", remedy="Give a number or drop the line."
        )
    return value
