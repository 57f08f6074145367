"""An epoch as a row of the table that start page and *Monitor a survey* share, without any widget."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from ..algorithms.support.inputs import epoch_time

FILES = ("control", "targets", "check")
"""Tables of points of an epoch, by the keys of survey.toml, in the order of their columns."""
MATRIX_COLUMNS = 3 + len(FILES)


@dataclass(frozen=True)
class EpochRow:
    """One epoch.

    Attributes
    ----------
    label
        Its name; empty for one that is found.
    time
        ISO 8601 in UTC; empty for one that is found.
    tiles
        Files.
    files
        File or layer by key of survey.toml.
    points, density, crs, footprint
        What the tiles say, once they have been looked at: points, points per m², the CRS they declare, and west, south, east, north
        of each.
    reason
        What label and time come from.
    """

    label: str = ""
    time: str = ""
    tiles: tuple[str, ...] = ()
    files: dict[str, str] = field(default_factory=dict)
    points: int = 0
    density: float = 0.0
    crs: str = ""
    footprint: tuple[tuple[float, float, float, float], ...] = ()
    reason: str = ""

    def with_tiles(self, tiles: tuple[str, ...]) -> EpochRow:
        """The epoch with other tiles, of which nothing is known yet."""
        return self if tiles == self.tiles else replace(self, tiles=tiles, points=0, density=0.0, crs="", footprint=(), reason="")


def rows_of_draft(draft: dict[str, Any]) -> list[EpochRow]:
    """Rows from what the engine found in a folder."""
    return [
        EpochRow(
            label=epoch["label"],
            time=epoch["time"],
            tiles=tuple(epoch["tiles"]),
            files={key: path for key, path in epoch["files"].items() if key in FILES},
            points=epoch["points"],
            density=epoch["density"],
            crs=epoch["crs"],
            footprint=tuple(tuple(extent) for extent in epoch["footprint"]),
            reason=epoch["reason"],
        )
        for epoch in draft["epochs"]
    ]


def rows_for_engine(rows: list[EpochRow]) -> list[dict[str, Any]]:
    """Rows as the engine reads them; layers must have become files."""
    return [{"label": row.label, "time": row.time, "tiles": list(row.tiles), "files": row.files} for row in rows]


def matrix_of(rows: list[EpochRow]) -> list[str]:
    """Rows as the values of the parameter ``EPOCHS``, six an epoch."""
    return [cell for row in rows for cell in (row.label, row.time, ";".join(row.tiles), *(row.files.get(key, "") for key in FILES))]


def rows_of_matrix(values: list[Any] | None) -> list[EpochRow]:
    """Rows from values of the parameter ``EPOCHS``; a time that is none is kept as it was written."""
    cells = ["" if value is None else str(value).strip() for value in values or []]
    cells += [""] * (-len(cells) % MATRIX_COLUMNS)
    rows = []
    for start in range(0, len(cells), MATRIX_COLUMNS):
        label, time, tiles, *files = cells[start : start + MATRIX_COLUMNS]
        with suppress(ValueError):
            time = epoch_time(time) if time else ""
        paths = tuple(part.strip() for part in tiles.split(";") if part.strip())
        rows.append(EpochRow(label, time, paths, {key: file for key, file in zip(FILES, files, strict=True) if file}))
    return [row for row in rows if row != EpochRow()]


def tiles_text(tiles: tuple[str, ...]) -> str:
    """What a cell says of its tiles."""
    if len(tiles) == 1:
        return Path(tiles[0]).name
    return f"{len(tiles)} × {Path(tiles[0]).suffix.lower() or Path(tiles[0]).name}" if tiles else ""
