"""Read a result.gpkg with nothing but sqlite3, so that the QGIS window and the report see the same rows.

Inside QGIS a second GDAL would break QGIS's own (docs/architecture.md), therefore layers are read here as plain SQL tables and
geometries from the GeoPackage binary (OGC 12-128r18, clause 2.1.3).
"""

from __future__ import annotations

import json
import sqlite3
import struct
from collections.abc import Iterable, Mapping
from contextlib import closing
from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import InputError

FloatArray = NDArray[np.float64]
Row = dict[str, Any]

BUSY_SECONDS = 30.0
"""How long one process waits for another that is writing to the same file."""

SELECT_ALL: Mapping[str, str] = {
    "units": "SELECT * FROM units",
    "feature_points": "SELECT * FROM feature_points",
    "displacements": "SELECT * FROM displacements",
    "displacements_other": "SELECT * FROM displacements_other",
    "control_residuals": "SELECT * FROM control_residuals",
    "gaps": "SELECT * FROM gaps",
    "check_residuals": "SELECT * FROM check_residuals",
    "epochs": "SELECT * FROM epochs",
    "epoch_pairs": "SELECT * FROM epoch_pairs",
    "reviews": "SELECT * FROM reviews",
    "review_log": "SELECT * FROM review_log ORDER BY number",
    "manual_picks": "SELECT * FROM manual_picks",
    "unit_edits": "SELECT * FROM unit_edits ORDER BY fid",
}
"""The only statements that read a whole layer: layer names never come from outside."""

INDICES = (
    ("feature_points", "CREATE INDEX IF NOT EXISTS feature_points_unit ON feature_points (unit_id)"),
    ("displacements", "CREATE INDEX IF NOT EXISTS displacements_unit ON displacements (unit_id)"),
    ("displacements", "CREATE INDEX IF NOT EXISTS displacements_pair ON displacements (epoch_from, epoch_to, datum, feature)"),
    ("displacements_other", "CREATE INDEX IF NOT EXISTS displacements_other_unit ON displacements_other (unit_id)"),
    (
        "displacements_other",
        "CREATE INDEX IF NOT EXISTS displacements_other_pair ON displacements_other (epoch_from, epoch_to, datum, feature)",
    ),
    ("units", "CREATE INDEX IF NOT EXISTS units_epoch ON units (epoch)"),
    ("units", "CREATE INDEX IF NOT EXISTS units_unit ON units (unit_id)"),
)
"""By layer, what makes a look at one unit or one epoch pair quick in a result of ten thousand units."""
REQUIRED = ("units", "feature_points", "displacements", "epochs")


@dataclass(frozen=True)
class EpochPair:
    """Two epochs between which units are compared; labels as in survey.toml."""

    epoch_from: str
    epoch_to: str

    def __str__(self) -> str:
        return f"{self.epoch_from} → {self.epoch_to}"


def connect(path: Path, *, write: bool = False) -> sqlite3.Connection:
    """Open a result file, read-only unless told; the caller closes it.

    Raises
    ------
    InputError
        The file does not exist or is no GeoPackage of tetratrack.
    """
    if not path.is_file():
        raise InputError("there is no such file", source=path, remedy="Choose the result.gpkg that tetratrack run wrote.")
    # WAL readers must be able to write the -shm file, so a plain connection is right wherever the file can be written
    mode = "rw" if write else "ro"
    connection = sqlite3.connect(f"{path.resolve().as_uri()}?mode={mode}", uri=True, timeout=BUSY_SECONDS, isolation_level=None)
    connection.row_factory = sqlite3.Row
    try:
        tables = {str(row["name"]) for row in connection.execute("SELECT name FROM sqlite_master WHERE type IN ('table', 'view')")}
    except sqlite3.DatabaseError as error:
        connection.close()
        raise InputError(
            f"cannot be read as a GeoPackage ({error})", source=path, remedy="Choose the result.gpkg that tetratrack run wrote."
        ) from error
    missing = [name for name in REQUIRED if name not in tables]
    if missing:
        connection.close()
        raise InputError(
            f"has no layer {', '.join(missing)}", source=path, remedy="Choose a result of tetratrack run; this is another GeoPackage."
        )
    return connection


def add_indices(connection: sqlite3.Connection) -> None:
    """Add the indices of all layers that are there and lack them."""
    tables = {str(row[0]) for row in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    for table, statement in INDICES:
        if table in tables:
            connection.execute(statement)


def table_names(path: Path) -> frozenset[str]:
    """Names of all tables and views in the file."""
    with closing(connect(path)) as connection:
        return frozenset(str(row["name"]) for row in connection.execute("SELECT name FROM sqlite_master WHERE type IN ('table', 'view')"))


def read_layer_rows(path: Path, layer: str) -> list[Row]:
    """All rows of a layer as dictionaries, geometry decoded to ``geom`` ((3,) for points, (n, 3) for lines, None); [] when absent.

    Raises
    ------
    InputError
        The file cannot be read.
    KeyError
        ``layer`` is not a layer of the interface.
    """
    statement = SELECT_ALL[layer]
    if layer not in table_names(path):
        return []
    with closing(connect(path)) as connection:
        return query(connection, statement)


def query(connection: sqlite3.Connection, statement: str, parameters: Iterable[Any] = ()) -> list[Row]:
    """Rows of a statement with geometry decoded."""
    cursor = connection.execute(statement, tuple(parameters))
    names = [str(column[0]) for column in cursor.description]
    geometry = next((k for k, name in enumerate(names) if name in ("geom", "geometry", "the_geom")), None)
    rows = []
    for values in cursor:
        row = dict(zip(names, values, strict=True))
        if geometry is not None:
            row["geom"] = decode_geometry(values[geometry])
        rows.append(row)
    return rows


def decode_geometry(blob: bytes | None) -> FloatArray | None:
    """Coordinates of a GeoPackage point ((3,)) or line string ((n, 3)), metres; height 0 where the geometry has none."""
    if blob is None:
        return None
    if blob[:2] != b"GP":
        raise InputError(
            "a geometry is not in GeoPackage binary form", remedy="Run tetratrack again; the file was changed by another tool."
        )
    flags = blob[3]
    if flags & 0x10:
        return None
    start = 8 + (0, 32, 48, 48, 64)[(flags >> 1) & 7]
    order = "<" if blob[start] == 1 else ">"
    kind: int = struct.unpack_from(f"{order}I", blob, start + 1)[0]
    flat, dimensions = kind % 1000, 3 if kind // 1000 in (1, 3) else 2
    if kind & 0x80000000:
        flat, dimensions = kind & 0xFF, 3
    body = start + 5
    if flat == 1:
        values = np.array(struct.unpack_from(f"{order}{dimensions}d", blob, body))
        return values if dimensions == 3 else np.append(values, 0.0)
    if flat == 2:
        count: int = struct.unpack_from(f"{order}I", blob, body)[0]
        line = np.frombuffer(blob, f"{order}f8", count * dimensions, body + 4).reshape(count, dimensions).astype(np.float64)
        return line if dimensions == 3 else np.column_stack([line, np.zeros(count)])
    raise InputError(
        f"geometry type {kind} is neither a point nor a line", remedy="Run tetratrack again; the file was changed by another tool."
    )


def encode_point(srs_id: int, coordinates: FloatArray) -> bytes:
    """GeoPackage binary of a PointZ."""
    return struct.pack("<2sBBiBI3d", b"GP", 0, 1, srs_id, 1, 1001, *(float(v) for v in coordinates))


def encode_line(srs_id: int, coordinates: FloatArray) -> bytes:
    """GeoPackage binary of a LineStringZ with an envelope in easting and northing, as GDAL writes it."""
    low, high = coordinates[:, :2].min(axis=0), coordinates[:, :2].max(axis=0)
    header = struct.pack("<2sBBi4d", b"GP", 0, 3, srs_id, low[0], high[0], low[1], high[1])
    return header + struct.pack("<BII", 1, 1002, len(coordinates)) + np.ascontiguousarray(coordinates, dtype="<f8").tobytes()


def srs_of(connection: sqlite3.Connection) -> int:
    """srs_id of the ``units`` layer."""
    row = connection.execute("SELECT srs_id FROM gpkg_geometry_columns WHERE table_name = 'units'").fetchone()
    return int(row["srs_id"]) if row else 0


def now_utc() -> str:
    """The present moment as a GeoPackage DATETIME."""
    return datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%S.%f")[:-3] + "Z"


def parse_time(text: str | None) -> datetime | None:
    """A GeoPackage DATETIME (or DATE) as an aware UTC time."""
    if not text:
        return None
    moment = datetime.fromisoformat(text.replace("Z", "+00:00").replace("/", "-"))
    return moment if moment.tzinfo else moment.replace(tzinfo=UTC)


def parse_settings(text: str | None) -> dict[str, Any]:
    """The ``settings`` field of ``epochs`` as a dictionary; {} where it is empty or not JSON."""
    try:
        settings = json.loads(text) if text else {}
    except json.JSONDecodeError:
        return {}
    return settings if isinstance(settings, dict) else {}


def epoch_pairs(path: Path) -> tuple[EpochPair, ...]:
    """Epoch pairs the result compares: consecutive ones in the order of time first, then the others."""
    have_other = "displacements_other" in table_names(path)
    consecutive = "SELECT 1 FROM displacements WHERE epoch_from = ? AND epoch_to = ? LIMIT 1"
    other = "SELECT 1 FROM displacements_other WHERE epoch_from = ? AND epoch_to = ? LIMIT 1"
    with closing(connect(path)) as connection:
        labels = [str(row["label"]) for row in connection.execute("SELECT label FROM epochs ORDER BY time")]
        possible = list(combinations(labels, 2))
        found = [pair for pair in possible if connection.execute(consecutive, pair).fetchone()]
        if have_other:
            found += [pair for pair in possible if pair not in found and connection.execute(other, pair).fetchone()]
    return tuple(EpochPair(*pair) for pair in found)
