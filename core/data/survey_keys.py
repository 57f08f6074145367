"""Keys of survey.toml: how each is checked, and what the template says of it."""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ..common.errors import InputError
from ..model.unit_types import UnitType, catalogue_unit

LONGEST_NAME = 100
"""Signs of a name: it becomes part of files' names, columns and titles."""
LARGEST_COORDINATE = 1e9


def is_name(value: Any) -> bool:
    """Whether a value is a text that can serve as a name: not long, and on one line."""
    return isinstance(value, str) and len(value) <= LONGEST_NAME and not any(unicodedata.category(sign) == "Cc" for sign in value)


def is_place(value: Any) -> bool:
    """Whether a value is [easting, northing]."""
    return (
        isinstance(value, list)
        and len(value) == 2
        and all(isinstance(v, int | float) and not isinstance(v, bool) and abs(v) < LARGEST_COORDINATE for v in value)
    )


@dataclass(frozen=True)
class Key:
    """One key of survey.toml: how it is checked, and what the template says about it.

    Attributes
    ----------
    kind
        ``text``, ``name``, ``number``, ``boolean``, ``time``, ``file``, ``layer``, ``files``, ``ring`` or ``choice``.
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
    unit
        What a number is in, for the message about one that cannot be.
    """

    kind: str
    help: str
    example: str
    required: bool = False
    choices: tuple[str, ...] = ()
    default: Any = None
    least: float = -math.inf
    most: float = math.inf
    unit: str = ""


SECTIONS: dict[str, dict[str, Key]] = {
    "survey": {
        "name": Key("name", "name of the site", '"north breakwater"', required=True),
        "crs": Key("text", 'projected (or compound) CRS of all results; "LOCAL" for a lab frame in metres', '"EPSG:32650"', required=True),
        "description": Key("text", "anything worth telling", '"UAV laser scanning"', default=""),
        "stable_areas": Key(
            "layer",
            "polygon layer around surfaces that do not move (crown wall, deck): ties epochs without control to the earliest with control, "
            "or to the first; of a file with several layers, name one: file.gpkg|layername=NAME",
            '"stable_areas.gpkg"',
        ),
        "frame": Key(
            "choice",
            'whether an epoch\'s cloud may be bent: the survey itself tells, "rigid" holds it stiff (short sites, one set-up), '
            '"elastic" lets it bend on any evidence (long flights)',
            '"auto"',
            choices=("auto", "rigid", "elastic"),
            default="auto",
        ),
        "size_check": Key(
            "boolean", "hold the size of the units against the cloud before a run, and refuse one that is not theirs", "true", default=True
        ),
    },
    "unit": {
        "type": Key("text", 'type of unit: "tetrapod", or a catalogue name such as "tetrapod 8 t"', '"tetrapod"', required=True),
        "height": Key("number", "nominal height H, metres; not needed with a catalogue name", "2.3", least=0.01, most=7.0, unit="metres"),
        "radius": Key(
            "number",
            "leg cone radius at the unit's centre, metres (default: standard proportions)",
            "0.60814",
            least=0,
            most=2,
            unit="metres",
        ),
        "gradient": Key(
            "number", "loss of radius per metre along the leg's axis (default: standard proportions)", "0.17610", least=0, most=2
        ),
        "leg_length": Key(
            "number", "centre to end disc, metres (default: standard proportions)", "1.48120", least=0, most=5, unit="metres"
        ),
        "opening": Key(
            "choice",
            'angle between the legs: "tetrahedral", or "paper" (120 degrees between leg 1 and the others)',
            '"tetrahedral"',
            choices=("tetrahedral", "paper"),
            default="tetrahedral",
        ),
        "calibrate": Key("boolean", "estimate radius and gradient from the best-seen units, then hold them", "false", default=False),
        "mould": Key(
            "text",
            "mould that an earlier survey has learned: its result.gpkg, a JSON file of the record under castings in its settings, or the "
            "name of such a file beside this one; it gives radius, gradient and leg_length where these are not given, and is held",
            '"north_2025"',
        ),
        "area": Key("ring", "where units of this type lie: corners [easting, northing]; with several [[unit]] types", "[]"),
    },
    "epoch": {
        "label": Key("name", "name of the epoch in all layers", '"2025-03-14"', required=True),
        "time": Key("time", "time of the survey with its time zone (Z is UTC)", "2025-03-14T02:30:00Z", required=True),
        "tiles": Key(
            "files",
            "LAS, LAZ, COPC, E57, PLY or VPC files: path, pattern or list, relative to this file",
            '"tiles/2025-03-14/*.laz"',
            required=True,
        ),
        "tiles_crs": Key(
            "text", "CRS of the tiles' coordinates where their header declares none or a wrong one: it overrules the header", '"EPSG:32650"'
        ),
        "undeclared_crs": Key("text", "CRS of those tiles alone whose header declares none that can be understood", '"EPSG:32650"'),
        "control": Key("file", "surveyed targets: point_id,easting,northing,height,sd_e,sd_n,sd_h", '"control_2025-03-14.csv"'),
        "targets": Key("file", "the same targets as measured in this epoch's cloud: point_id,x,y,z", '"targets_2025-03-14.csv"'),
        "control_crs": Key("text", "CRS of the control file where it is not the survey's", '"EPSG:5179"'),
        "control_unit": Key("choice", "length unit of the control file's numbers", '"m"', choices=("m", "ft", "us-ft"), default="m"),
        "control_axes": Key(
            "choice",
            'order of the control file\'s coordinates: "ne" where x is the northing, as surveyors in some countries have it',
            '"en"',
            choices=("en", "ne"),
            default="en",
        ),
        "control_sd": Key(
            "number",
            "standard deviation of the control points' coordinates, in the unit of their file, where it states none",
            "0.005",
            least=0,
        ),
        "check": Key(
            "file",
            "check points, for validation only: point_id,unit_easting,unit_northing,unit_height,easting,northing,height,sd",
            '"check_2025-03-14.csv"',
        ),
        "trajectory": Key(
            "file", "sensor positions in the survey's CRS by the tiles' GPS time: gps_time,x,y,z", '"trajectory_2025-03-14.csv"'
        ),
        "stations": Key("file", "scanner stations in the survey's CRS: point_source_id,x,y,z", '"stations_2025-03-14.csv"'),
        "range_sd": Key(
            "number", "standard deviation of a range, metres; with trajectory or stations", "0.02", least=0, most=1, unit="metres"
        ),
        "angle_sd": Key(
            "number",
            "standard deviation of a beam's direction, degrees; with trajectory or stations",
            "0.01",
            least=0,
            most=5,
            unit="degrees",
        ),
    },
    "displacement": {
        "significance": Key("number", "level of the test of each displacement", "0.05", default=0.05, least=0, most=0.5),
        "watch": Key("number", "displacement graded watch, metres", "0.05", default=0.05, least=0, most=10, unit="metres"),
        "alert": Key("number", "displacement graded alert, metres", "0.10", default=0.10, least=0, most=10, unit="metres"),
        "partly_damaged": Key("number", "displacement graded partly damaged, in nominal diameters Dn", "0.5", default=0.5, least=0),
        "damaged": Key("number", "displacement graded damaged, in nominal diameters Dn", "1.0", default=1.0, least=0),
        "dislocated": Key("number", "displacement graded dislocated, in heights H", "1.0", default=1.0, least=0),
    },
}
"""All keys by section; ``unit`` and ``epoch`` may be repeated as [[unit]] and [[epoch]]."""


REPEATED = ("unit", "epoch")


REQUIRED = ("survey", "unit", "epoch")


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


def check_number(section: str, name: str, value: float) -> None:
    """Refuse a number that a key cannot have, wherever it comes from.

    Raises
    ------
    InputError
        With the key in ``where``; a length that is too great is asked whether it is in millimetres.
    """
    key = SECTIONS[section][name]
    if math.isfinite(value) and key.least < value <= key.most:
        return
    limits = f"above {key.least:g}" if math.isinf(key.most) else f"above {key.least:g} and at most {key.most:g}"
    metres = key.unit == "metres" and math.inf > value > key.most
    likely = f"Is it in millimetres? Then write {value / 1000:g}." if metres else f"It is in {key.unit}." if key.unit else ""
    raise InputError(f"{name} must be a number {limits}, not {value!r}", where=name, remedy=likely)


def unit_from_keys(values: Mapping[str, Any]) -> UnitType:
    """Unit type from the values of the keys of section [unit]; None stands for an absent key.

    Raises
    ------
    InputError
        With the key in ``where``.
    """
    for key in ("height", "radius", "gradient", "leg_length"):
        if values[key] is not None:
            check_number("unit", key, values[key])
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
