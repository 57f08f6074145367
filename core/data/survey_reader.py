"""Reading of survey.toml: every key is checked, errors name the key and its line, and the files are found."""

from __future__ import annotations

import difflib
import re
import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from ..common.errors import InputError
from ..common.input_files import content_of
from ..common.virtual_clouds import expanded
from ..model.unit_types import told_apart
from .crs import LOCAL, check_survey_crs
from .file_patterns import MAGIC, BrokenLink, existing_path, matching_files
from .mould_files import moulded
from .survey import Epoch, LayerFile, Ring, Survey, SurveyUnit
from .survey_keys import LONGEST_NAME, REPEATED, REQUIRED, SECTIONS, check_number, is_name, is_place, unit_from_keys

BACKSLASHES = "In double quotes a backslash begins a special sign: write / instead of \\, or put the path in single quotes."
LARGEST_FILE = 4_000_000
"""Characters of a survey.toml."""
DEEPEST_KEY = 20
LARGEST_NUMBER = 10**18


def read_survey(path: str | Path) -> Survey:
    """Read and check a survey.toml, and find its files.

    Raises
    ------
    InputError
        The file is missing or not TOML, a key is unknown, missing or of the wrong type, or a file it names does not exist.
    CrsError
        The survey's CRS is unknown, geographic or not in metres.
    """
    source = Path(path).absolute()
    try:
        text = content_of(source, 4 * LARGEST_FILE).decode("utf-8-sig")
    except FileNotFoundError as error:
        raise InputError("there is no such file", source=source, remedy="Write one with: tetratrack template > survey.toml") from error
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"cannot be read ({_reason(error)})", source=source, remedy="Give a survey.toml in UTF-8.") from error
    if len(text) > LARGEST_FILE or _deepest_key(text) > DEEPEST_KEY:
        raise InputError("is no survey.toml", source=source, remedy="Compare with the output of: tetratrack template")
    try:
        data = tomllib.loads(text)
    except (RecursionError, MemoryError, OverflowError) as error:
        raise InputError("is nested too deeply", source=source, remedy="Compare with the output of: tetratrack template") from error
    except tomllib.TOMLDecodeError as error:
        place = re.search(r"line (\d+), column (\d+)", str(error))
        problem = " ".join(re.sub(r"\s*\(at .*\)$", "", str(error), flags=re.DOTALL).split())
        line = text.splitlines()[int(place[1]) - 1] if place and int(place[1]) <= len(text.splitlines()) else ""
        escape = "\\" in line and '"' in line
        raise InputError(
            f"is not TOML: {problem[:1].lower()}{problem[1:]}",
            source=source,
            where=f"line {place[1]}, column {place[2]}" if place else "at its end",
            remedy=BACKSLASHES if escape else "Compare with the output of: tetratrack template",
        ) from error
    except ValueError as error:
        # numbers of thousands of digits, and days that no calendar has
        raise InputError(
            f"holds a value that cannot be read ({error})", source=source, remedy="Look for a number or time out of range."
        ) from error
    return _Reader(source, text).survey(data)


def _deepest_key(text: str) -> int:
    """Most dots in one key outside of quotes: the parser's time grows with their square."""
    bare = re.sub(r"\s*\.\s*", ".", re.sub(r"\"[^\"\n]*\"|'[^'\n]*'", "", text))
    return max((word.count(".") for word in re.split(r"[\s,=\[\]{}]+", bare)), default=0)


class _Reader:
    """Checks the parsed file; knows where every key stands."""

    def __init__(self, source: Path, text: str) -> None:
        self.source = source
        self.lines = dict(_key_lines(text))
        self.moulds: list[Path] = []

    def survey(self, data: Mapping[str, Any]) -> Survey:
        self._names(data, SECTIONS, "section", lambda name: (name, 0, ""))
        for section in REQUIRED:
            if section not in data:
                brackets = f"[[{section}]]" if section == "epoch" else f"[{section}]"
                raise InputError(f"has no section {brackets}", source=self.source, remedy="Compare with the output of: tetratrack template")
        tables = {section: self._tables(section, data[section]) for section in data}
        checked = {section: [self._values(section, index, table) for index, table in enumerate(tables[section])] for section in tables}
        head = checked["survey"][0]
        check_survey_crs(head["crs"], source=self.source, where=self._where("survey", 0, "crs"))
        epochs = [self._epoch(index, values) for index, values in enumerate(checked["epoch"])]
        self._distinct_epochs(epochs)
        optional = {section: checked[section][0] for section in checked if section not in REQUIRED}
        optional |= {
            section: {name: key.default for name, key in keys.items()}
            for section, keys in SECTIONS.items()
            if section not in REQUIRED and section not in optional
        }
        self._check_grades(optional["displacement"])
        units = [self._unit(index, values) for index, values in enumerate(checked["unit"])]
        types = told_apart([unit.type for unit in units])
        return Survey(
            path=self.source,
            name=head["name"],
            crs=head["crs"],
            description=head["description"],
            units=tuple(replace(unit, type=kind) for unit, kind in zip(units, types, strict=True)),
            moulds=tuple(self.moulds),
            epochs=tuple(sorted(epochs, key=lambda epoch: epoch.time)),
            sections=optional,
            stable_areas=head["stable_areas"],
            frame=head["frame"],
            size_check=head["size_check"],
        )

    def _tables(self, section: str, value: Any) -> list[Mapping[str, Any]]:
        tables = value if isinstance(value, list) and section in REPEATED else [value]
        if not tables or not all(isinstance(table, dict) for table in tables):
            brackets = f"[[{section}]]" if section == "epoch" else f"[{section}]"
            raise self._error(section, 0, "", f"must be a section {brackets}")
        return tables

    def _names(self, given: Mapping[str, Any], known: Mapping[str, Any], what: str, place: Callable[[str], tuple[str, int, str]]) -> None:
        for name in given:
            if name not in known:
                close = difflib.get_close_matches(name, known, n=1)
                remedy = f"Did you mean {close[0]}?" if close else f"Known here: {', '.join(known)}."
                raise self._error(*place(name), f"unknown {what} {name}", remedy)

    def _values(self, section: str, index: int, table: Mapping[str, Any]) -> dict[str, Any]:
        keys = SECTIONS[section]
        self._names(table, keys, "key", lambda name: (section, index, name))
        for name, key in keys.items():
            if key.required and name not in table:
                raise self._error(section, index, "", f"key {name} is missing", f"Add: {name} = {key.example}")
        return {name: self._value(section, index, name, table[name]) if name in table else key.default for name, key in keys.items()}

    def _value(self, section: str, index: int, name: str, value: Any) -> Any:
        key = SECTIONS[section][name]
        expected = _EXPECTED[key.kind]
        if not expected.accepts(value):
            raise self._error(
                section, index, name, f"{name} must be {expected.words}, not {_describe(value)}", f"For example: {name} = {key.example}"
            )
        if key.kind == "choice" and value not in key.choices:
            raise self._error(section, index, name, f"{name} must be one of {', '.join(key.choices)}, not {value!r}")
        if key.kind == "number":
            try:
                check_number(section, name, value)
            except InputError as error:
                raise self._error(section, index, name, error.problem, error.remedy) from None
            return float(value)
        if key.kind == "time":
            if not isinstance(value, datetime) or value.tzinfo is None:
                raise self._error(
                    section, index, name, f"{name} has no time of day or time zone", f"Write for example: {name} = {key.example}"
                )
            try:
                return value.astimezone(UTC)
            except (OverflowError, ValueError):
                raise self._error(
                    section, index, name, f"{name} {value} is no time in UTC", f"For example: {name} = {key.example}"
                ) from None
        if key.kind == "file":
            return self._file(section, index, name, value)
        if key.kind == "layer":
            return self._layer(section, index, name, value)
        if key.kind == "files":
            return self._files(section, index, name, [value] if isinstance(value, str) else value)
        if key.kind == "ring":
            return tuple((float(e), float(n)) for e, n in value)
        return value.strip() if isinstance(value, str) else value

    def _file(self, section: str, index: int, name: str, value: str) -> Path:
        self._check_signs(section, index, name, value)
        path = existing_path(self.source.parent, value)
        if not path.is_file():
            what = "is a link to nothing" if path.is_symlink() else "there is no file"
            raise self._error(section, index, name, f"{name}: {what} {value}", f"Looked in {self.source.parent}.")
        return path

    def _layer(self, section: str, index: int, name: str, value: str) -> LayerFile:
        path, _, layer = value.partition("|layername=")
        return LayerFile(self._file(section, index, name, path), layer)

    def _files(self, section: str, index: int, name: str, patterns: list[str]) -> tuple[Path, ...]:
        found: dict[Path, None] = {}
        for pattern in patterns:
            self._check_signs(section, index, name, pattern)
            try:
                matches = matching_files(self.source.parent, pattern)
            except BrokenLink as link:
                raise self._error(
                    section, index, name, f"{name}: {link} is a link to nothing", "Mend the link, or move it out of the pattern."
                ) from link
            except (ValueError, IndexError, NotImplementedError, OSError, RecursionError) as error:
                raise self._error(section, index, name, f"{name}: {pattern!r} cannot be searched ({_reason(error)})") from error
            if not matches:
                magic = MAGIC.search(pattern) is not None
                remedy = f"Looked in {self.source.parent}."
                if "[" in pattern:
                    remedy += " A sign in [ ] stands for one of those within; write [[] for a bracket itself."
                raise self._error(section, index, name, f"{name}: {'no file matches' if magic else 'there is no file'} {pattern}", remedy)
            found |= dict.fromkeys(expanded(matches))
        return tuple(sorted(found))

    def _check_signs(self, section: str, index: int, name: str, value: str) -> None:
        """Refuse line breaks and the like: what TOML makes of a backslash in double quotes."""
        if any(ord(sign) < 32 or ord(sign) == 127 for sign in value):
            raise self._error(section, index, name, f"{name}: {value!r} holds a control character", BACKSLASHES)

    def _unit(self, index: int, values: Mapping[str, Any]) -> SurveyUnit:
        ring: Ring | None = values["area"] or None
        if ring is not None and len(ring) < 3:
            raise self._error("unit", index, "area", "area needs at least three corners")
        try:
            unit = unit_from_keys(values)
        except InputError as error:
            raise self._error("unit", index, error.where, error.problem, error.remedy) from error
        if values["mould"] is None:
            return SurveyUnit(unit, values["calibrate"], ring)
        self._check_signs("unit", index, "mould", values["mould"])
        try:
            shaped, mould, path = moulded(unit, values, self.source.parent)
        except InputError as error:
            raise self._error("unit", index, "mould", f"mould: {error.problem}", error.remedy) from error
        self.moulds.append(path)
        return SurveyUnit(shaped, False, ring, mould)

    def _epoch(self, index: int, values: Mapping[str, Any]) -> Epoch:
        if not values["label"]:
            raise self._error("epoch", index, "label", "label is empty")
        for one, other in (("control", "targets"), ("targets", "control")):
            if values[one] is not None and values[other] is None:
                raise self._error("epoch", index, one, f"{one} is given without {other}", "Registration needs both, or neither.")
        placed = [name for name in ("trajectory", "stations") if values[name] is not None]
        for name in ("range_sd", "angle_sd"):
            if placed and values[name] is None:
                raise self._error(
                    "epoch", index, placed[0], f"{placed[0]} is given without {name}", f"Add: {name} = {SECTIONS['epoch'][name].example}"
                )
            if values[name] is not None and not placed:
                raise self._error(
                    "epoch",
                    index,
                    name,
                    f"{name} is given without trajectory or stations",
                    "Beams are known only from the sensor's position.",
                )
        for key in ("tiles_crs", "undeclared_crs"):
            if values[key] is not None and values[key] != LOCAL:
                check_survey_crs(values[key], source=self.source, where=self._where("epoch", index, key))
        return Epoch(**values)

    def _distinct_epochs(self, epochs: list[Epoch]) -> None:
        for what in ("label", "time"):
            seen: set[Any] = set()
            for index, epoch in enumerate(epochs):
                value = getattr(epoch, what)
                if value in seen:
                    raise self._error("epoch", index, what, f"{what} {value} belongs to two epochs", "Give every epoch its own.")
                seen.add(value)

    def _check_grades(self, limits: Mapping[str, Any]) -> None:
        """Refuse limits of grades that are counted alike and not in their order."""
        for lower, higher in (("watch", "alert"), ("partly_damaged", "damaged")):
            if limits[lower] > limits[higher]:
                raise self._error(
                    "displacement",
                    0,
                    lower if ("displacement", 0, lower) in self.lines else higher,
                    f"{lower} ({limits[lower]:g}) is above {higher} ({limits[higher]:g})",
                    f"Give both, {lower} first.",
                )

    def _where(self, section: str, index: int, name: str) -> str:
        line = self.lines.get((section, index, name)) or self.lines.get((section, index, ""))
        return ", ".join(part for part in (f"line {line}" if line else "", f"section {section}") if part)

    def _error(self, section: str, index: int, name: str, problem: str, remedy: str = "") -> InputError:
        return InputError(problem, source=self.source, where=self._where(section, index, name), remedy=remedy)


def _key_lines(text: str) -> Iterator[tuple[tuple[str, int, str], int]]:
    """Line of every section and key, since the TOML parser does not tell: ((section, number of repeat, key or ""), line)."""
    section, index, repeats = "", 0, dict[str, int]()
    for number, whole in enumerate(text.splitlines(), start=1):
        line = whole[:200]
        header = re.match(r"\s*(\[\[?)\s*[\"']?([^\]\"']+?)[\"']?\s*\]", line)
        key = re.match(r"\s*[\"']?([A-Za-z0-9_-]+)[\"']?\s*[.=]", line)
        if header:
            section = header[2]
            index = repeats[section] = repeats.get(section, -1) + 1 if header[1] == "[[" else 0
            yield (section, index, ""), number
        elif key:
            yield (section, index, key[1]) if section else (key[1], 0, ""), number


@dataclass(frozen=True)
class _Expected:
    words: str
    accepts: Callable[[Any], bool]


def _is_number(value: Any) -> bool:
    return isinstance(value, float) or (isinstance(value, int) and not isinstance(value, bool) and abs(value) < LARGEST_NUMBER)


def _is_ring(value: Any) -> bool:
    return isinstance(value, list) and all(map(is_place, value))


def _is_text(value: Any) -> bool:
    return isinstance(value, str)


_EXPECTED = {
    "text": _Expected("text in quotes", _is_text),
    "choice": _Expected("text in quotes", _is_text),
    "name": _Expected(f"text in quotes, on one line and of at most {LONGEST_NAME} signs", is_name),
    "number": _Expected("a number", _is_number),
    "boolean": _Expected("true or false", lambda value: isinstance(value, bool)),
    "time": _Expected("a time without quotes", lambda value: not isinstance(value, str | int | float | list | dict)),
    **dict.fromkeys(("file", "layer"), _Expected("a path in quotes", lambda value: isinstance(value, str) and bool(value))),
    "files": _Expected(
        "a path in quotes or a list of them",
        lambda value: (
            bool(value) and (isinstance(value, str) or (isinstance(value, list) and all(isinstance(v, str) and v for v in value)))
        ),
    ),
    "ring": _Expected("a list of corners [easting, northing]", _is_ring),
}


def _describe(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f"the text {value!r}" if len(value) < 200 else "a long text"
    if isinstance(value, int | float):
        return f"the number {value}" if abs(value) < LARGEST_NUMBER else "a number of many digits"
    if isinstance(value, list):
        return "a list"
    if isinstance(value, dict):
        return "a section"
    return f"the time {value}"


def _reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or str(error)
