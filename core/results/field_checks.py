"""What the fields of a result hold, checked as they are read: other programs change results too, and SQLite lets any type in."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from datetime import datetime
from pathlib import Path
from typing import Any

from ..common.errors import InputError, TetratrackError
from .result_access import CHANGED
from .schema import LAYERS

FARTHEST = 1e8
"""Metres: no coordinate on Earth or its projections is as large."""
LARGEST_UNIT = 100.0
"""Metres: no armour unit is as high."""
LARGEST = 1e15
"""No number of a result is as large."""

KEYS: Mapping[str, tuple[str, ...]] = {
    "units": ("unit_id", "epoch", "status"),
    "feature_points": ("unit_id", "epoch", "feature"),
    "displacements": ("unit_id",),
    "displacements_other": ("unit_id",),
    "check_residuals": ("point_id", "epoch"),
    "control_residuals": ("point_id", "epoch"),
    "epoch_pairs": ("epoch_from", "epoch_to"),
    "epochs": ("label",),
    "gaps": ("epoch", "kind"),
    "review_log": ("number", "unit_id", "epoch_from", "epoch_to", "action", "reviewer", "at"),
    "unit_edits": ("kind", "unit_id", "editor", "edited_at"),
    "manual_picks": ("unit_id", "epoch", "feature", "picked_by"),
}
"""Fields without which a row says nothing."""
NUMBERS: Mapping[str, tuple[str, ...]] = {
    "units": ("height", "r0", "gradient", "qx", "qy", "qz", "qw", "sd_e", "sd_n", "sd_h", "coverage"),
    "feature_points": ("observed", "sd_e", "sd_n", "sd_h"),
    "displacements": ("de", "dn", "dh", "d_horizontal", "d_3d", "sd_e", "sd_n", "sd_h", "rotation_deg", "p_value", "significant", "class"),
    "check_residuals": ("unit_id", "feature", "de", "dn", "dh"),
    "control_residuals": ("ve", "vn", "vh", "w_max", "used", "outlier"),
    "epochs": ("time", "settings", "transformation"),
}
"""Further fields that every version of the format has; their values may be empty."""
_OWN_TYPES = {"number": "integer", "undoes": "integer", "at": "datetime", "edited_at": "datetime", "picked_at": "datetime"}
_ALWAYS_TEXT = ("action", "decision", "comment", "reviewer", "editor", "picked_by", "kind")


def _types() -> dict[str, dict[str, str]]:
    """Type by layer and field."""
    own = _OWN_TYPES | dict.fromkeys(_ALWAYS_TEXT, "text") | {"unit_id": "text", "epoch": "text", "feature": "text"}
    types = {name: {field.name: str(field.type) for field in layer.fields} for name, layer in LAYERS.items()}
    pair = {"epoch_from": "text", "epoch_to": "text"}
    return types | {"review_log": own | pair, "unit_edits": own, "manual_picks": own}


TYPES = _types()
_STORED: Mapping[str, frozenset[type]] = {
    "text": frozenset({str, type(None)}),
    "datetime": frozenset({str, type(None)}),
    "integer": frozenset({int, type(None)}),
    "boolean": frozenset({int, type(None)}),
    "real": frozenset({int, float, type(None)}),
}
_WORDS = {"text": "text", "datetime": "a time", "integer": "a whole number", "boolean": "true or false", "real": "a number"}


def always_there(layer: str) -> tuple[str, ...]:
    """Fields of a layer that every version of the format has."""
    return (*KEYS.get(layer, ()), *NUMBERS.get(layer, ()))


def check_records(layer: str, names: Sequence[str], records: Sequence[Any], needed: Sequence[str]) -> None:
    """Check the rows of one layer before anything is computed from them.

    Parameters
    ----------
    layer
        Name; others than this program's are not checked.
    names
        Columns of the records, in their order.
    records
        Rows, values in the order of ``names``.
    needed
        Columns that must be among them.

    Raises
    ------
    InputError
        With layer, row and field.
    """
    types = TYPES.get(layer)
    if types is None:
        return
    missing = [name for name in needed if name not in names]
    if missing:
        raise InputError(f"there is no field {missing[0]}", where=f"layer {layer}", remedy=CHANGED)
    row_names = names.index("fid") if "fid" in names else None
    for place, name in enumerate(names):
        if name not in types:
            continue
        kind = types[name]
        stored = [record[place] for record in records]
        fault = _fault(kind, stored, name in KEYS.get(layer, ()))
        if fault is not None:
            number = fault + 1 if row_names is None else records[fault][row_names]
            value = " ".join(repr(stored[fault])[:40].split())
            raise InputError(
                f"{value} is not {_WORDS[kind]}" if stored[fault] is not None else "is empty",
                where=f"layer {layer}, row {number}, field {name}",
                remedy=CHANGED,
            )


def _fault(kind: str, values: Sequence[Any], needed: bool) -> int | None:
    """Index of the first value that a field of this kind cannot hold."""
    if not needed and not set(map(type, values)) <= _STORED[kind]:
        return _first(values, lambda value: type(value) not in _STORED[kind])
    if needed and not set(map(type, values)) <= _STORED[kind] - {type(None)}:
        return _first(values, lambda value: value is None or type(value) not in _STORED[kind])
    if kind in ("real", "integer"):
        numbers = [value for value in values if value is not None]
        if numbers and not (min(numbers) > -LARGEST and max(numbers) < LARGEST):
            return _first(values, lambda value: value is not None and not abs(value) < LARGEST)
    if kind == "datetime":
        wrong = {value for value in set(values) if value and not _is_time(value)}
        if wrong:
            return _first(values, lambda value: value in wrong)
    return None


def _first(values: Sequence[Any], fails: Callable[[Any], bool]) -> int:
    return next(place for place, value in enumerate(values) if fails(value))


def _is_time(text: str) -> bool:
    try:
        datetime.fromisoformat(text.replace("Z", "+00:00").replace("/", "-"))
    except ValueError:
        return False
    return True


def check_pose(row: Mapping[str, Any]) -> None:
    """Check that a row of ``units`` holds a rotation and a size.

    Raises
    ------
    InputError
        With the field that is empty or no part of a pose.
    """
    fault = next((name for name in ("qx", "qy", "qz", "qw", "height", "r0", "gradient") if row[name] is None), None)
    if fault is None and not 0.5 < math.hypot(row["qx"], row["qy"], row["qz"], row["qw"]) < 2.0:
        fault = "qw"
    if fault is None:
        fault = next((name for name in ("height", "r0") if not 0.0 < row[name] < LARGEST_UNIT), None)
    if fault is None and not -1.0 < row["gradient"] < 1.0:
        fault = "gradient"
    if fault is not None:
        raise InputError(
            f"{row[fault]!r} is no part of a pose" if row[fault] is not None else "is empty",
            where=f"layer units, unit {row['unit_id']}, epoch {row['epoch']}, field {fault}",
            remedy=CHANGED,
        )


@contextmanager
def foreign_contents(path: Path) -> Iterator[None]:
    """Where a result is read into something else: what :func:`check_records` cannot see in a file that others changed ends in one
    sentence too.

    Raises
    ------
    InputError
        In the place of any error of computation.
    """
    try:
        yield
    except TetratrackError:
        raise
    except (ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError) as error:
        words = " ".join(f"{type(error).__name__}: {error}".split())[:200]
        raise InputError(
            f"holds something that cannot be used ({words})",
            source=path,
            remedy="Run tetratrack again; if no other tool changed the file, please report this.",
        ) from error


def layer_of(statement: str) -> str:
    """Layer that an SQL statement reads; empty where it reads none."""
    found = re.search(r"FROM (\w+)", statement)
    return found[1] if found else ""
