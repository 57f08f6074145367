"""survey.toml: what was surveyed, when and with which files. Every key is checked; errors name the key and its line."""

from __future__ import annotations

import difflib
import math
import re
import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Literal

from .crs import LOCAL, check_survey_crs
from .errors import InputError
from .unit_types import UnitType, catalogue_unit

Ring = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class SurveyUnit:
    """A type of unit that the survey holds.

    Attributes
    ----------
    type
        Nominal geometry.
    calibrate
        Estimate radius and gradient of the type for this survey from the best-seen units, then hold them.
    area
        Ring of (easting, northing) inside which units of this type lie; None for everywhere.
    """

    type: UnitType
    calibrate: bool = False
    area: Ring | None = None


@dataclass(frozen=True)
class Epoch:
    """One survey of the site; paths are absolute.

    Attributes
    ----------
    label, time
        Name used in all layers; UTC.
    tiles
        LAS/LAZ/COPC files, sorted, each once.
    control, targets, check
        CSV files of surveyed targets, of the targets measured in the cloud and of check points, or None.
    tiles_crs
        CRS of tiles whose header declares none, or None.
    control_crs, control_unit
        CRS of the control file, None for the survey's, and length unit of its numbers.
    trajectory, stations
        CSV files of the sensor's positions by GPS time, and by point source ID, or None.
    range_sd, angle_sd
        Standard deviations of a range, metres, and of each direction of a beam, degrees; None where the sensor's position is not known.
    """

    label: str
    time: datetime
    tiles: tuple[Path, ...]
    control: Path | None = None
    targets: Path | None = None
    check: Path | None = None
    tiles_crs: str | None = None
    control_crs: str | None = None
    control_unit: Literal["m", "ft", "us-ft"] = "m"
    trajectory: Path | None = None
    stations: Path | None = None
    range_sd: float | None = None
    angle_sd: float | None = None

    @property
    def files(self) -> tuple[Path, ...]:
        """All files the epoch is made of."""
        others = (self.control, self.targets, self.check, self.trajectory, self.stations)
        return (*self.tiles, *(path for path in others if path is not None))


@dataclass(frozen=True)
class Survey:
    """A whole survey.toml.

    Attributes
    ----------
    path
        The file, absolute.
    name, crs, description
        ``crs`` as written, for example ``EPSG:32650`` or ``LOCAL``.
    units
        Types of unit, at least one.
    epochs
        In order of time.
    sections
        Checked values of the optional sections, by section and key, with defaults filled in.
    stable_areas
        Polygon layer of surfaces that tie epochs without control to the reference epoch, or None.
    """

    path: Path
    name: str
    crs: str
    description: str
    units: tuple[SurveyUnit, ...]
    epochs: tuple[Epoch, ...]
    sections: Mapping[str, Mapping[str, Any]]
    stable_areas: Path | None = None

    @property
    def unit(self) -> UnitType:
        """Nominal geometry of the first type of unit."""
        return self.units[0].type

    @property
    def reference(self) -> Epoch:
        """Epoch that epochs without control are tied to: the earliest with control, else the first."""
        return next((epoch for epoch in self.epochs if epoch.control is not None), self.epochs[0])

    def epoch(self, label: str) -> Epoch:
        """Epoch of a label."""
        for epoch in self.epochs:
            if epoch.label == label:
                return epoch
        raise InputError(
            f"has no epoch {label!r}", source=self.path, remedy=f"Epochs are: {', '.join(epoch.label for epoch in self.epochs)}."
        )


@dataclass(frozen=True)
class Key:
    """One key of survey.toml: how it is checked, and what the template says about it.

    Attributes
    ----------
    kind
        ``text``, ``number``, ``boolean``, ``time``, ``file``, ``files``, ``ring`` or ``choice``.
    help
        Meaning, as a comment of the template.
    example
        TOML literal of the template.
    required
        The file is refused without it.
    choices
        Allowed texts of a ``choice``.
    default
        Value where the key is absent.
    least, most
        Open lower bound and closed upper bound of a ``number``.
    """

    kind: str
    help: str
    example: str
    required: bool = False
    choices: tuple[str, ...] = ()
    default: Any = None
    least: float = -math.inf
    most: float = math.inf


SECTIONS: dict[str, dict[str, Key]] = {
    "survey": {
        "name": Key("text", "name of the site", '"north breakwater"', required=True),
        "crs": Key("text", 'projected (or compound) CRS of all results; "LOCAL" for a lab frame in metres', '"EPSG:32650"', required=True),
        "description": Key("text", "anything worth telling", '"UAV laser scanning"', default=""),
        "stable_areas": Key(
            "file",
            "polygon layer around surfaces that do not move (crown wall, deck): ties epochs without control to the earliest with control, "
            "or to the first",
            '"stable_areas.gpkg"',
        ),
    },
    "unit": {
        "type": Key("text", 'type of unit: "tetrapod", or a catalogue name such as "tetrapod 8 t"', '"tetrapod"', required=True),
        "height": Key("number", "nominal height H, metres; not needed with a catalogue name", "2.3", least=0),
        "radius": Key("number", "leg cone radius at the unit's centre, metres (default: standard proportions)", "0.60814", least=0),
        "gradient": Key("number", "loss of radius per metre along the leg's axis (default: standard proportions)", "0.17610", least=0),
        "leg_length": Key("number", "centre to end disc, metres (default: standard proportions)", "1.48120", least=0),
        "opening": Key(
            "choice",
            'angle between the legs: "tetrahedral", or "paper" (120 degrees between leg 1 and the others)',
            '"tetrahedral"',
            choices=("tetrahedral", "paper"),
            default="tetrahedral",
        ),
        "calibrate": Key("boolean", "estimate radius and gradient from the best-seen units, then hold them", "false", default=False),
        "area": Key("ring", "where units of this type lie: corners [easting, northing]; with several [[unit]] types", "[]"),
    },
    "epoch": {
        "label": Key("text", "name of the epoch in all layers", '"2025-03-14"', required=True),
        "time": Key("time", "time of the survey with its time zone (Z is UTC)", "2025-03-14T02:30:00Z", required=True),
        "tiles": Key(
            "files", "LAS/LAZ/COPC files: path, pattern or list, relative to this file", '"tiles/2025-03-14/*.laz"', required=True
        ),
        "tiles_crs": Key("text", "CRS of tiles whose header declares none", '"EPSG:32650"'),
        "control": Key("file", "surveyed targets: point_id,easting,northing,height,sd_e,sd_n,sd_h", '"control_2025-03-14.csv"'),
        "targets": Key("file", "the same targets as measured in this epoch's cloud: point_id,x,y,z", '"targets_2025-03-14.csv"'),
        "control_crs": Key("text", "CRS of the control file where it is not the survey's", '"EPSG:5179"'),
        "control_unit": Key("choice", "length unit of the control file's numbers", '"m"', choices=("m", "ft", "us-ft"), default="m"),
        "check": Key(
            "file",
            "check points, for validation only: point_id,unit_easting,unit_northing,unit_height,easting,northing,height,sd",
            '"check_2025-03-14.csv"',
        ),
        "trajectory": Key(
            "file", "sensor positions in the survey's CRS by the tiles' GPS time: gps_time,x,y,z", '"trajectory_2025-03-14.csv"'
        ),
        "stations": Key("file", "scanner stations in the survey's CRS: point_source_id,x,y,z", '"stations_2025-03-14.csv"'),
        "range_sd": Key("number", "standard deviation of a range, metres; with trajectory or stations", "0.02", least=0),
        "angle_sd": Key("number", "standard deviation of a beam's direction, degrees; with trajectory or stations", "0.01", least=0),
    },
    "displacement": {
        "significance": Key("number", "level of the test of each displacement", "0.05", default=0.05, least=0, most=0.5),
        "watch": Key("number", "displacement graded watch, metres", "0.05", default=0.05, least=0),
        "alert": Key("number", "displacement graded alert, metres", "0.10", default=0.10, least=0),
        "partly_damaged": Key("number", "displacement graded partly damaged, in nominal diameters Dn", "0.5", default=0.5, least=0),
        "damaged": Key("number", "displacement graded damaged, in nominal diameters Dn", "1.0", default=1.0, least=0),
        "dislocated": Key("number", "displacement graded dislocated, in heights H", "1.0", default=1.0, least=0),
    },
}
"""All keys by section; ``unit`` and ``epoch`` may be repeated as [[unit]] and [[epoch]]."""

REPEATED = ("unit", "epoch")
REQUIRED = ("survey", "unit", "epoch")


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
        text = source.read_bytes().decode("utf-8-sig")
    except FileNotFoundError as error:
        raise InputError("there is no such file", source=source, remedy="Write one with: tetratrack template > survey.toml") from error
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"cannot be read ({_reason(error)})", source=source, remedy="Give a survey.toml in UTF-8.") from error
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        place = re.search(r"line (\d+), column (\d+)", str(error))
        problem = re.sub(r"\s*\(at .*\)$", "", str(error))
        raise InputError(
            f"is not TOML: {problem[0].lower()}{problem[1:]}",
            source=source,
            where=f"line {place[1]}, column {place[2]}" if place else "at its end",
            remedy="Compare with the output of: tetratrack template",
        ) from error
    return _Reader(source, text).survey(data)


def template() -> str:
    """A survey.toml to fill in: every key with its meaning; optional keys are commented out."""
    lines = ["# Survey of tetrapod armour units. Paths are relative to this file.", ""]
    for section, keys in SECTIONS.items():
        lines.append(f"[[{section}]]" if section == "epoch" else f"[{section}]")
        for name, key in keys.items():
            needed = key.required or (section, name) == ("unit", "height")
            lines.append(f"{'' if needed else '# '}{name} = {key.example}  # {key.help}")
        lines.append("")
    return "\n".join(lines)


def inside(ring: Ring, easting: float, northing: float) -> bool:
    """Whether a position lies in a closed ring of corners (even-odd rule)."""
    within = False
    for (e1, n1), (e2, n2) in zip(ring, ring[1:] + ring[:1], strict=True):
        if (n1 > northing) != (n2 > northing) and easting < (e2 - e1) * (northing - n1) / (n2 - n1) + e1:
            within = not within
    return within


def unit_from_keys(values: Mapping[str, Any]) -> UnitType:
    """Unit type from the values of the keys of section [unit]; None stands for an absent key.

    Raises
    ------
    InputError
        With the key in ``where``.
    """
    name: str = values["type"]
    named = catalogue_unit(name)
    if named is None and name.strip().lower() != "tetrapod":
        raise InputError(
            f"unknown type of unit {name!r}", where="type", remedy='Write "tetrapod" with a height, or a mass as in "tetrapod 8 t".'
        )
    height = values["height"] or (named.height if named else None)
    if height is None:
        raise InputError("key height is missing", where="height", remedy="Add the nominal height in metres, or a mass to the type.")
    try:
        return UnitType.tetrapod(
            height,
            radius=values["radius"],
            gradient=values["gradient"],
            leg_length=values["leg_length"],
            opening=values["opening"],
            name=named.name if named else "tetrapod",
        )
    except ValueError as error:
        raise InputError(str(error), where="type", remedy="Check height, radius, gradient, leg_length and opening.") from error


class _Reader:
    """Checks the parsed file; knows where every key stands."""

    def __init__(self, source: Path, text: str) -> None:
        self.source = source
        self.lines = dict(_key_lines(text))

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
        return Survey(
            self.source,
            head["name"],
            head["crs"],
            head["description"],
            tuple(self._unit(index, values) for index, values in enumerate(checked["unit"])),
            tuple(sorted(epochs, key=lambda epoch: epoch.time)),
            optional,
            head["stable_areas"],
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
            if not (math.isfinite(value) and key.least < value <= key.most):
                limits = f"above {key.least:g}" if math.isinf(key.most) else f"above {key.least:g} and at most {key.most:g}"
                raise self._error(section, index, name, f"{name} must be a number {limits}, not {value!r}")
            return float(value)
        if key.kind == "time":
            if not isinstance(value, datetime) or value.tzinfo is None:
                raise self._error(
                    section, index, name, f"{name} has no time of day or time zone", f"Write for example: {name} = {key.example}"
                )
            return value.astimezone(UTC)
        if key.kind == "file":
            return self._file(section, index, name, value)
        if key.kind == "files":
            return self._files(section, index, name, [value] if isinstance(value, str) else value)
        if key.kind == "ring":
            return tuple((float(e), float(n)) for e, n in value)
        return value.strip() if isinstance(value, str) else value

    def _file(self, section: str, index: int, name: str, value: str) -> Path:
        path = self.source.parent / value
        if not path.is_file():
            raise self._error(section, index, name, f"{name}: there is no file {value}", f"Looked in {self.source.parent}.")
        return path

    def _files(self, section: str, index: int, name: str, patterns: list[str]) -> tuple[Path, ...]:
        found: dict[Path, None] = {}
        for pattern in patterns:
            path = Path(pattern)
            base, relative = (
                (Path(path.anchor), str(path.relative_to(path.anchor))) if path.is_absolute() else (self.source.parent, pattern)
            )
            try:
                # a name may itself hold pattern characters: an existing file is taken as it stands
                matches = [base / relative] if (base / relative).is_file() else sorted(p for p in base.glob(relative) if p.is_file())
            except (ValueError, NotImplementedError, OSError) as error:
                raise self._error(section, index, name, f"{name}: {pattern!r} cannot be searched ({_reason(error)})") from error
            if not matches:
                what = "no file matches" if any(c in pattern for c in "*?[") else "there is no file"
                raise self._error(section, index, name, f"{name}: {what} {pattern}", f"Looked in {base}.")
            found |= dict.fromkeys(matches)
        return tuple(sorted(found))

    def _unit(self, index: int, values: Mapping[str, Any]) -> SurveyUnit:
        ring: Ring | None = values["area"] or None
        if ring is not None and len(ring) < 3:
            raise self._error("unit", index, "area", "area needs at least three corners")
        try:
            unit = unit_from_keys(values)
        except InputError as error:
            raise self._error("unit", index, error.where, error.problem, error.remedy) from error
        return SurveyUnit(unit, values["calibrate"], ring)

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
        if values["tiles_crs"] is not None and values["tiles_crs"] != LOCAL:
            check_survey_crs(values["tiles_crs"], source=self.source, where=self._where("epoch", index, "tiles_crs"))
        return Epoch(**values)

    def _distinct_epochs(self, epochs: list[Epoch]) -> None:
        for what in ("label", "time"):
            seen: set[Any] = set()
            for index, epoch in enumerate(epochs):
                value = getattr(epoch, what)
                if value in seen:
                    raise self._error("epoch", index, what, f"{what} {value} belongs to two epochs", "Give every epoch its own.")
                seen.add(value)

    def _where(self, section: str, index: int, name: str) -> str:
        line = self.lines.get((section, index, name)) or self.lines.get((section, index, ""))
        return ", ".join(part for part in (f"line {line}" if line else "", f"section {section}") if part)

    def _error(self, section: str, index: int, name: str, problem: str, remedy: str = "") -> InputError:
        return InputError(problem, source=self.source, where=self._where(section, index, name), remedy=remedy)


def _key_lines(text: str) -> Iterator[tuple[tuple[str, int, str], int]]:
    """Line of every section and key, since the TOML parser does not tell: ((section, number of repeat, key or ""), line)."""
    section, index, repeats = "", 0, dict[str, int]()
    for number, line in enumerate(text.splitlines(), start=1):
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
    return isinstance(value, int | float) and not isinstance(value, bool)


def _is_ring(value: Any) -> bool:
    return isinstance(value, list) and all(isinstance(c, list) and len(c) == 2 and all(map(_is_number, c)) for c in value)


def _is_text(value: Any) -> bool:
    return isinstance(value, str)


_EXPECTED = {
    "text": _Expected("text in quotes", _is_text),
    "choice": _Expected("text in quotes", _is_text),
    "number": _Expected("a number", _is_number),
    "boolean": _Expected("true or false", lambda value: isinstance(value, bool)),
    "time": _Expected("a time without quotes", lambda value: not isinstance(value, str | int | float | list | dict)),
    "file": _Expected("a path in quotes", lambda value: isinstance(value, str) and bool(value)),
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
        return f"the text {value!r}"
    if isinstance(value, int | float):
        return f"the number {value}"
    if isinstance(value, list):
        return "a list"
    if isinstance(value, dict):
        return "a section"
    return f"the time {value}"


def _reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or str(error)
