"""Moulds that an earlier survey has learned: from its result, or from a file of their own."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Mapping
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from typing import Any

from ..common.errors import InputError
from ..common.paths import sqlite_address
from ..common.sqlite_files import recover
from ..model.mould import Mould
from ..model.unit_types import UnitType, sized_name
from .file_patterns import existing_path

ENDINGS = (".mould.json", ".json", ".gpkg")
"""Of the files in which a mould is looked for by its name."""
REMEDY = "Name a result of this version, or a JSON file with one of the records under castings in its epochs.settings."
LARGEST_FILE = 1_000_000


def moulded(unit: UnitType, values: Mapping[str, Any], folder: Path) -> tuple[UnitType, Mould, Path]:
    """A unit type with the cones of its mould where the keys do not give them, the mould, and its file.

    Parameters
    ----------
    unit
        As the other keys give it.
    values
        Of the keys of section [unit], ``mould`` among them.
    folder
        Of survey.toml.

    Raises
    ------
    InputError
        There is no such mould, it is none of such units, or the shape is to be calibrated too.
    """
    if values["calibrate"]:
        raise InputError("it is given with calibrate = true", remedy="A mould is held: leave one of them out.")
    mould, path = find_mould(values["mould"], folder, unit)
    given = {name: values[name] for name in ("radius", "gradient", "leg_length") if values[name] is not None}
    try:
        return replace(mould.shaped(unit), **given), mould, path
    except ValueError as error:
        raise InputError(str(error), source=path, remedy=REMEDY) from error


def find_mould(named: str, folder: Path, unit: UnitType) -> tuple[Mould, Path]:
    """The mould of a name, which is a file or one beside survey.toml less its ending, and its file.

    Parameters
    ----------
    named
        As in survey.toml.
    folder
        Of survey.toml.
    unit
        Its type: a result may hold the moulds of several.

    Raises
    ------
    InputError
        There is no such file, or none of a mould.
    """
    for ending in ("", *ENDINGS):
        path = existing_path(folder, named + ending)
        if path.is_file():
            return read_mould(path, unit), path
    raise InputError(
        f"there is no mould {named}",
        remedy=f"Looked in {folder} for a file of that name, with the ending {', '.join(ENDINGS[:-1])} or {ENDINGS[-1]} too.",
    )


def read_mould(path: Path, unit: UnitType) -> Mould:
    """The mould in a result (.gpkg), or in a file of its own.

    Raises
    ------
    InputError
        The file holds none.
    """
    record = _of_result(path, unit) if path.suffix.lower() == ".gpkg" else _of_file(path)
    if record is None:
        raise InputError("holds no mould", source=path, remedy=REMEDY)
    try:
        return Mould.from_record(record, str(record.get("name") or path.name.split(".")[0]))
    except ValueError as error:
        raise InputError(f"holds no mould that can be used: it {error}", source=path, remedy=REMEDY) from error


def _of_file(path: Path) -> Mapping[str, Any] | None:
    try:
        if path.stat().st_size > LARGEST_FILE:
            return None
        record = json.loads(path.read_text("utf-8-sig"))
    except (OSError, ValueError, RecursionError) as error:
        raise InputError(f"cannot be read ({getattr(error, 'strerror', None) or error})", source=path, remedy=REMEDY) from error
    return record if isinstance(record, dict) else None


def _of_result(path: Path, unit: UnitType) -> Mapping[str, Any] | None:
    recover(path)
    try:
        with closing(sqlite3.connect(sqlite_address(path.absolute(), "mode=ro"), uri=True)) as connection:
            rows = connection.execute("select settings from epochs").fetchall()
        castings: Any = next((found for (text,) in rows if (found := json.loads(text).get("castings"))), {})
    except (sqlite3.Error, ValueError, TypeError, AttributeError, RecursionError) as error:
        raise InputError(f"cannot be read as a result ({error})", source=path, remedy=REMEDY) from error
    if not isinstance(castings, dict):
        return None
    own = castings.get(unit.name) or castings.get(sized_name(unit))
    record = own or (next(iter(castings.values())) if len(castings) == 1 else None)
    return record if isinstance(record, dict) else None
