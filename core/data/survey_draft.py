"""A survey.toml written from what the files say, every inferred value with its reason beside it."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import Any

from .file_patterns import BrokenLink, matching_files
from .survey import Ring

FIRST_LINE = "# Written by tetratrack init from what the files say"
"""By which a file that a draft wrote is known again."""
QUESTION = "ASK: "
"""What begins the comment of a key that the files leave open."""


@dataclass(frozen=True, kw_only=True)
class DraftUnit:
    """A type of unit of a draft.

    Attributes
    ----------
    height
        Metres; None where it is not known.
    radius, gradient
        Where they differ from the standard proportions, else None.
    calibrate
        Whether radius and gradient are to be estimated from the survey.
    area
        Where units of this type lie, or None.
    reasons
        What each value comes from, by key.
    """

    height: float | None
    radius: float | None = None
    gradient: float | None = None
    calibrate: bool = False
    area: Ring | None = None
    reasons: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class DraftEpoch:
    """An epoch of a draft: label, time, tiles and tables, with what each comes from.

    Attributes
    ----------
    label, time, tiles
        As in survey.toml; paths are absolute.
    values
        Further keys with their values: files, choices and numbers.
    reasons
        What a value comes from, by key.
    comments
        Lines on what was found and not used.
    points, density, crs
        Of all tiles: points, the median of points per m², and the CRS they declare, several parted by commas.
    footprint
        West, south, east, north of each tile in its own CRS.
    """

    label: str
    time: datetime
    tiles: tuple[Path, ...]
    values: dict[str, Path | str | float] = field(default_factory=dict)
    reasons: dict[str, str] = field(default_factory=dict)
    comments: tuple[str, ...] = ()
    points: int = 0
    density: float = 0.0
    crs: str = ""
    footprint: tuple[tuple[float, float, float, float], ...] = ()


@dataclass(frozen=True, kw_only=True)
class SurveyDraft:
    """All that was found in the folders of a survey.

    Attributes
    ----------
    name, crs
        As in survey.toml; crs empty where it is not known.
    crs_reason
        What it comes from.
    units, epochs
        At least one each.
    questions
        What nothing answers and has to be asked, as sentences that name the option.
    warnings
        What a user should look at.
    """

    name: str
    crs: str
    crs_reason: str
    units: tuple[DraftUnit, ...]
    epochs: tuple[DraftEpoch, ...]
    questions: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()


def draft_text(draft: SurveyDraft, folder: Path | None = None) -> str:
    """The draft as a survey.toml.

    Parameters
    ----------
    folder
        Where the file will stand: paths are relative to it where they lie below it or beside it; None writes them whole.
    """
    lines = [""]
    lines += [f"# {QUESTION}{question}" for question in draft.questions]
    lines += [f"# note: {warning}" for warning in draft.warnings]
    lines += ["", "[survey]", _line("name", draft.name, "")]
    lines.append(_line("crs", draft.crs, draft.crs_reason if draft.crs else f"{QUESTION}{draft.crs_reason}"))
    for unit in draft.units:
        lines += ["", "[[unit]]" if len(draft.units) > 1 else "[unit]", 'type = "tetrapod"', *_unit_lines(unit)]
    for epoch in draft.epochs:
        lines += ["", "[[epoch]]", *_epoch_lines(epoch, folder)]
    body = "\n" + "\n".join(line for k, line in enumerate(lines) if k and (line or lines[k - 1])) + "\n"
    return f"{FIRST_LINE}; the reasons stand beside the values. All keys: tetratrack template. {_checksum(body)}\n{body}"


def is_as_drafted(text: str) -> bool:
    """Whether a draft is what :func:`draft_text` made of it: nothing was corrected in it since."""
    first, _, body = text.partition("\n")
    return first.endswith(f" {_checksum(body)}")


def _checksum(body: str) -> str:
    return f"Checksum {hashlib.sha256(body.strip().encode('utf-8')).hexdigest()[:16]}"


def draft_record(draft: SurveyDraft) -> dict[str, Any]:
    """The draft in plain values, for a window that shows it as a table; files by their whole paths."""
    epochs = [
        {
            "label": epoch.label,
            "time": f"{epoch.time:%Y-%m-%dT%H:%M:%SZ}",
            "reason": epoch.reasons.get("time", ""),
            "tiles": [str(tile) for tile in epoch.tiles],
            "points": epoch.points,
            "density": epoch.density,
            "crs": epoch.crs,
            "footprint": [list(extent) for extent in epoch.footprint],
            "files": {name: str(value) for name, value in epoch.values.items() if isinstance(value, Path)},
            "comments": list(epoch.comments),
        }
        for epoch in draft.epochs
    ]
    units = [
        {"height": unit.height, "radius": unit.radius, "gradient": unit.gradient, "reason": unit.reasons.get("height", "")}
        for unit in draft.units
    ]
    return {
        "name": draft.name,
        "crs": draft.crs,
        "epochs": epochs,
        "units": units,
        "questions": list(draft.questions),
        "warnings": list(draft.warnings),
    }


def tile_patterns(tiles: Sequence[Path], folder: Path | None) -> list[str]:
    """The shortest patterns that match these tiles and no other file, one for each of their folders; else their names."""
    patterns: list[str] = []
    for parent in sorted({tile.parent for tile in tiles}):
        mine = {tile for tile in tiles if tile.parent == parent}
        endings = sorted({tile.suffix for tile in mine})
        pattern = f"*{endings[0]}" if len(endings) == 1 else "*.[lL][aA][sSzZ]"
        plain = not any(character in str(parent) for character in "*?[")
        if plain and len(mine) > 1 and _matches(parent, pattern) == mine:
            patterns.append(_shown(parent / pattern, folder))
        else:
            patterns += [_shown(tile, folder) for tile in sorted(mine)]
    return patterns


def _matches(folder: Path, pattern: str) -> set[Path]:
    """What the reader of survey.toml takes the pattern for; nothing where it would refuse it."""
    try:
        return set(matching_files(folder, pattern))
    except (BrokenLink, OSError):
        return set()


def _unit_lines(unit: DraftUnit) -> list[str]:
    reasons = unit.reasons
    if unit.height is None:
        return [f"# height = 2.3  # {QUESTION}{reasons.get('height', 'the height of the units, metres')}"]
    lines = [f"height = {_number(unit.height)}  # {reasons.get('height', 'given')}"]
    for name, value in (("radius", unit.radius), ("gradient", unit.gradient)):
        if value is not None:
            lines.append(f"{name} = {_number(value)}  # {reasons.get(name, 'estimated with the height')}")
    if unit.calibrate:
        lines.append(f"calibrate = true  # {reasons.get('calibrate', 'proportions differ from the standard')}")
    if unit.area is not None:
        corners = ", ".join(f"[{e:.2f}, {n:.2f}]" for e, n in unit.area)
        lines.append(f"area = [{corners}]  # {reasons.get('area', '')}")
    return lines


def _epoch_lines(epoch: DraftEpoch, folder: Path | None) -> list[str]:
    patterns = tile_patterns(epoch.tiles, folder)
    tiles = _text(patterns[0]) if len(patterns) == 1 else "[" + ", ".join(map(_text, patterns)) + "]"
    count = len(epoch.tiles)
    lines = [f"# {comment}" for comment in epoch.comments]
    lines += [
        _line("label", epoch.label, ""),
        f"time = {epoch.time:%Y-%m-%dT%H:%M:%SZ}  # {epoch.reasons.get('time', '')}",
        f"tiles = {tiles}  # {count} tile{'s' if count > 1 else ''}",
    ]
    for name, value in epoch.values.items():
        reason = epoch.reasons.get(name, "")
        if isinstance(value, float):
            lines.append(f"{name} = {_number(value)}  # {reason}")
        else:
            lines.append(_line(name, _shown(value, folder) if isinstance(value, Path) else value, reason))
    return lines


def _line(name: str, value: str, reason: str) -> str:
    return f"{name} = {_text(value)}" + (f"  # {reason}" if reason else "")


def _text(value: str) -> str:
    """A TOML string; control characters have no place in names of files that a survey is made of."""
    escaped = value.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(c if c >= " " and c != "\x7f" else f"\\u{ord(c):04x}" for c in escaped) + '"'


def _shown(path: Path, folder: Path | None) -> str:
    if folder is None:
        return path.as_posix()
    near = Path(os.path.relpath(path, folder))
    # beside the file's folder is near enough; from farther away the whole path is clearer, and right after the file moves
    return near.as_posix() if near.parts[:2] != ("..", "..") else path.as_posix()


def _number(value: float) -> str:
    return f"{value:.5g}"
