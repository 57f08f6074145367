"""The numbers a decision is made on, and whether they are still the same."""

from __future__ import annotations

import json
import math
import sqlite3
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..results.geopackage_reader import EpochPair
from ..results.result_access import reading
from .unit_records import tables_of

Numbers = tuple[float, float, float, float | None, str]
"""Easting, northing, height (metres), rotation (degrees, None where unknown) and class of the displacement of a unit's centre."""
CENTRES = {
    "displacements": (
        "SELECT unit_id, epoch_from, epoch_to, datum, de, dn, dh, rotation_deg, class FROM displacements WHERE feature = 'centre'"
    ),
    "displacements_other": (
        "SELECT unit_id, epoch_from, epoch_to, datum, de, dn, dh, rotation_deg, class FROM displacements_other WHERE feature = 'centre'"
    ),
}
CENTRES_OF_UNIT = {layer: f"{statement} AND unit_id = ?" for layer, statement in CENTRES.items()}
CENTRES_OF_PAIR = {layer: f"{statement} AND epoch_from = ? AND epoch_to = ?" for layer, statement in CENTRES.items()}
SAME_LENGTH, SAME_ANGLE_DEG = 0.0005, 0.05
"""Metres and degrees by which a number may change under a decision: less than the review shows."""


@dataclass(frozen=True)
class Basis:
    """The numbers of one unit in one epoch pair.

    Attributes
    ----------
    displacements
        By datum.
    status
        Status of the unit in the earlier and in the later epoch; empty where it has no row.
    """

    displacements: Mapping[str, Numbers]
    status: tuple[str, str] = ("", "")

    @classmethod
    def from_json(cls, text: str | None) -> Basis | None:
        """As :attr:`json` wrote it; None for nothing."""
        if not text:
            return None
        values = json.loads(text)
        return cls({datum: tuple(row) for datum, row in values["displacements"].items()}, tuple(values["status"]))

    @property
    def json(self) -> str:
        """As ``review_log`` holds it."""
        return json.dumps({"displacements": dict(self.displacements), "status": self.status}, sort_keys=True)

    @property
    def length(self) -> float | None:
        """3D displacement in metres, in the datum that comes first; None where there is none."""
        rows = [self.displacements[datum] for datum in sorted(self.displacements, reverse=True)]
        return math.hypot(*rows[0][:3]) if rows else None

    def agrees(self, other: Basis) -> bool:
        """Whether a reviewer would see the same numbers."""
        if self.status != other.status or self.displacements.keys() != other.displacements.keys():
            return False
        return all(_same_row(row, other.displacements[datum]) for datum, row in self.displacements.items())


def _same_row(a: Numbers, b: Numbers) -> bool:
    turned = (a[3] or 0.0) - (b[3] or 0.0)
    return a[4] == b[4] and max(abs(x - y) for x, y in zip(a[:3], b[:3])) < SAME_LENGTH and abs(turned) < SAME_ANGLE_DEG


def basis_of(connection: sqlite3.Connection, unit_id: str, pair: EpochPair) -> Basis:
    """Present numbers of one unit in one epoch pair."""
    return bases(connection, {pair}, unit_id).get((unit_id, pair), Basis({}))


def read_bases(path: Path, pair: EpochPair) -> dict[str, Basis]:
    """Present numbers of all units of a result in one epoch pair, by unit."""
    with reading(path) as connection:
        return {unit: basis for (unit, _), basis in bases(connection, {pair}).items()}


def bases(connection: sqlite3.Connection, pairs: Collection[EpochPair], unit_id: str = "") -> dict[tuple[str, EpochPair], Basis]:
    """Present numbers by unit and epoch pair, of one unit or of all that the epochs of the pairs hold."""
    moved: dict[tuple[str, EpochPair], dict[str, Numbers]] = {}
    for layer in CENTRES.keys() & tables_of(connection):
        for unit, start, stop, datum, de, dn, dh, turn, kind in _centres(connection, layer, pairs, unit_id):
            moved.setdefault((unit, EpochPair(start, stop)), {})[datum] = (de, dn, dh, turn, kind or "")
    status: dict[str, dict[str, str]] = {}
    for unit, epoch, value in _statuses(connection, pairs, unit_id):
        status.setdefault(unit, {})[epoch] = value or ""
    return {
        (unit, pair): Basis(moved.get((unit, pair), {}), (known.get(pair.epoch_from, ""), known.get(pair.epoch_to, "")))
        for unit, known in status.items()
        for pair in pairs
    }


def _centres(connection: sqlite3.Connection, layer: str, pairs: Collection[EpochPair], unit_id: str) -> Iterator[tuple[Any, ...]]:
    """Displacements of centres in the order of ``CENTRES``: all of one unit, which are few, or those of the pairs."""
    if unit_id:
        yield from connection.execute(CENTRES_OF_UNIT[layer], (unit_id,))
        return
    for pair in pairs:
        yield from connection.execute(CENTRES_OF_PAIR[layer], (pair.epoch_from, pair.epoch_to))


def _statuses(connection: sqlite3.Connection, pairs: Collection[EpochPair], unit_id: str) -> Iterator[tuple[Any, ...]]:
    """Unit, epoch and status: of one unit, or of the epochs of the pairs."""
    if unit_id:
        yield from connection.execute("SELECT unit_id, epoch, status FROM units WHERE unit_id = ?", (unit_id,))
        return
    for epoch in {epoch for pair in pairs for epoch in (pair.epoch_from, pair.epoch_to)}:
        yield from connection.execute("SELECT unit_id, epoch, status FROM units WHERE epoch = ?", (epoch,))
