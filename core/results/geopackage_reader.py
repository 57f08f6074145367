"""Read a result.gpkg with nothing but sqlite3, so that the QGIS window and the report see the same rows.

Inside QGIS a second GDAL would break QGIS's own (docs/architecture.md), therefore layers are read here as plain SQL tables and
geometries from the GeoPackage binary (OGC 12-128r18, clause 2.1.3).
"""

from __future__ import annotations

import json
import math
import re
import sqlite3
import struct
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import combinations, pairwise
from pathlib import Path
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import InputError
from .field_checks import FARTHEST, TYPES, always_there, check_records, layer_of
from .result_access import CHANGED, REQUIRED, patiently, reading

Row = dict[str, Any]

WKT2_COLUMN = "definition_12_063"
"""Field of ``gpkg_spatial_ref_sys`` for WKT of ISO 19162 (OGC 12-128r18, annex F.10)."""
_STATED = re.compile("PROJ|GEOG|GEOD|COMP|BOUND|DERIVEDPROJ")
"""Start of WKT of a place on earth, of both versions; a local frame has another, or none."""
_PROJECTED = re.compile(r"PROJCR?S\[")
_BRACKETS_AND_CODES = re.compile(r'(?:ID|AUTHORITY)\["EPSG",\s*"?(?P<code>\d+)"?\]|"[^"]*"|\[|\]')

SELECT_ALL: Mapping[str, str] = {
    "units": "SELECT * FROM units",
    "feature_points": "SELECT * FROM feature_points",
    "displacements": "SELECT * FROM displacements",
    "displacements_other": "SELECT * FROM displacements_other",
    "control_residuals": "SELECT * FROM control_residuals",
    "gaps": "SELECT * FROM gaps",
    "frame_errors": "SELECT * FROM frame_errors",
    "stretches": "SELECT * FROM stretches",
    "unit_outlines": "SELECT * FROM unit_outlines",
    "unit_surfaces": "SELECT * FROM unit_surfaces",
    "placement": "SELECT * FROM placement",
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
    ("unit_outlines", "CREATE INDEX IF NOT EXISTS unit_outlines_unit ON unit_outlines (unit_id)"),
    ("unit_surfaces", "CREATE INDEX IF NOT EXISTS unit_surfaces_unit ON unit_surfaces (unit_id)"),
    ("placement", "CREATE INDEX IF NOT EXISTS placement_unit ON placement (unit_id)"),
)
"""By layer, what makes a look at one unit or one epoch pair quick in a result of ten thousand units."""


@dataclass(frozen=True)
class EpochPair:
    """Two epochs between which units are compared; labels as in survey.toml."""

    epoch_from: str
    epoch_to: str

    def __str__(self) -> str:
        return f"{self.epoch_from} → {self.epoch_to}"


def add_indices(connection: sqlite3.Connection) -> None:
    """Add the indices of all layers that are there and lack them."""
    tables = {str(row[0]) for row in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    for table, statement in INDICES:
        if table in tables:
            connection.execute(statement)


def add_spatial_functions(connection: sqlite3.Connection) -> None:
    """Give a connection the functions that the triggers of GDAL's spatial index call."""
    bounds: tuple[tuple[str, Callable[[bytes], float]], ...] = (
        ("ST_MinX", lambda blob: _extent(blob)[0]),
        ("ST_MaxX", lambda blob: _extent(blob)[1]),
        ("ST_MinY", lambda blob: _extent(blob)[2]),
        ("ST_MaxY", lambda blob: _extent(blob)[3]),
    )
    for name, function in bounds:
        connection.create_function(name, 1, function, deterministic=True)
    connection.create_function("ST_IsEmpty", 1, lambda blob: int(decode_geometry(blob) is None), deterministic=True)


def _extent(blob: bytes) -> tuple[float, float, float, float]:
    decoded = decode_geometry(blob)
    if decoded is None:
        return math.nan, math.nan, math.nan, math.nan
    points = np.atleast_2d(decoded)
    return float(points[:, 0].min()), float(points[:, 0].max()), float(points[:, 1].min()), float(points[:, 1].max())


def table_names(path: Path, needed: Sequence[str] = REQUIRED) -> frozenset[str]:
    """Names of all tables and views in a file with the ``needed`` layers."""
    with reading(path, needed) as connection:
        return frozenset(str(row["name"]) for row in connection.execute("SELECT name FROM sqlite_master WHERE type IN ('table', 'view')"))


def read_layer_rows(path: Path, layer: str) -> list[Row]:
    """All rows of a layer as dictionaries, geometry decoded to ``geom`` ((3,) for points, (n, 3) for lines and the corners of
    polygons ring by ring, None); [] when absent.

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
    with reading(path) as connection:
        return query(connection, statement)


def read_given_rows(path: Path, layer: str, fields: Sequence[str]) -> list[Row]:
    """All rows of one layer of any GeoPackage, as :func:`read_layer_rows`; it need hold no other layer, and of this one only ``fields``.

    Times are aware, and truth values are such, as the writers of results take them.

    Raises
    ------
    InputError
        The file cannot be read, has no such layer or field, or a value is not what its field holds.
    """
    with reading(path, (layer,)) as connection:
        rows = query(connection, SELECT_ALL[layer], needed=fields)
    types = TYPES[layer]
    for row in rows:
        for name in types.keys() & row.keys():
            if row[name] is not None and types[name] == "datetime":
                row[name] = parse_time(row[name])
            elif row[name] is not None and types[name] == "boolean":
                row[name] = bool(row[name])
    return rows


def query(connection: sqlite3.Connection, statement: str, parameters: Iterable[Any] = (), needed: Sequence[str] | None = None) -> list[Row]:
    """Rows of a statement on one layer with geometry decoded; all fields that every result has must be there, or those ``needed``.

    Raises
    ------
    InputError
        A field that is needed is missing, or a value is not what its field holds.
    """
    given = tuple(parameters)
    cursor = patiently(lambda: connection.execute(statement, given))
    names = [str(column[0]) for column in cursor.description]
    layer = layer_of(statement)
    records = cursor.fetchall()
    if needed is None:
        needed = always_there(layer) if "SELECT *" in statement else ()
    check_records(layer, names, records, needed)
    geometry = next((k for k, name in enumerate(names) if name in ("geom", "geometry", "the_geom")), None)
    rows = []
    for number, values in enumerate(records, start=1):
        row = dict(zip(names, values, strict=True))
        if geometry is not None:
            try:
                row["geom"] = decode_geometry(values[geometry])
            except InputError as error:
                raise InputError(error.problem, where=f"layer {layer}, row {row.get('fid', number)}", remedy=error.remedy) from error
        rows.append(row)
    return rows


def decode_geometry(blob: bytes | None) -> FloatArray | None:
    """Coordinates of a GeoPackage point ((3,)), line string or (multi)polygon ((n, 3), polygons ring by ring), metres; height 0 where
    the geometry has none.

    Raises
    ------
    InputError
        It is no such geometry, is cut short, or lies farther off than any place on Earth.
    """
    if blob is None:
        return None
    try:
        coordinates = _decoded(blob)
    except (struct.error, IndexError, TypeError, ValueError) as error:
        raise InputError("a geometry is damaged", remedy=CHANGED) from error
    if coordinates is None or len(coordinates) == 0:
        return None
    if not (np.abs(coordinates) < FARTHEST).all():
        raise InputError("a geometry is not a place on Earth", remedy=CHANGED)
    return coordinates


def _decoded(blob: bytes) -> FloatArray | None:
    if blob[:2] != b"GP":
        raise InputError("a geometry is not in GeoPackage binary form", remedy=CHANGED)
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
        return _read_corners(blob, order, dimensions, body)[0]
    if flat == 3:
        return _read_rings(blob, order, dimensions, body)[0]
    if flat == 6:
        faces = []
        place = body + 4
        for _ in range(struct.unpack_from(f"{order}I", blob, body)[0]):
            corners, place = _read_rings(blob, order, dimensions, place + 5)
            faces.append(corners)
        return np.vstack(faces)
    raise InputError(f"geometry type {kind} is neither a point, a line nor a polygon", remedy=CHANGED)


def _read_corners(blob: bytes, order: str, dimensions: int, place: int) -> tuple[FloatArray, int]:
    """(n, 3) corners that follow their number at ``place``, and the place after them."""
    count: int = struct.unpack_from(f"{order}I", blob, place)[0]
    line = np.frombuffer(blob, f"{order}f8", count * dimensions, place + 4).reshape(count, dimensions).astype(np.float64)
    return line if dimensions == 3 else np.column_stack([line, np.zeros(count)]), place + 4 + 8 * count * dimensions


def _read_rings(blob: bytes, order: str, dimensions: int, place: int) -> tuple[FloatArray, int]:
    """(n, 3) corners of all rings of a polygon whose number stands at ``place``, and the place after them."""
    rings = []
    count: int = struct.unpack_from(f"{order}I", blob, place)[0]
    place += 4
    for _ in range(count):
        corners, place = _read_corners(blob, order, dimensions, place)
        rings.append(corners)
    return np.vstack(rings), place


def encode_point(srs_id: int, coordinates: FloatArray) -> bytes:
    """GeoPackage binary of a PointZ."""
    return struct.pack("<2sBBiBI3d", b"GP", 0, 1, srs_id, 1, 1001, *(float(v) for v in coordinates))


def encode_line(srs_id: int, coordinates: FloatArray) -> bytes:
    """GeoPackage binary of a LineStringZ with an envelope in easting and northing, as GDAL writes it."""
    return _header(srs_id, coordinates) + struct.pack("<BII", 1, 1002, len(coordinates)) + _corners(coordinates)


def encode_polygon(srs_id: int, corners: FloatArray) -> bytes:
    """GeoPackage binary of a PolygonZ with one ring of (n, 3) corners, the first not repeated."""
    closed = np.vstack([corners, corners[:1]])
    return _header(srs_id, closed) + struct.pack("<BIII", 1, 1003, 1, len(closed)) + _corners(closed)


def encode_faces(srs_id: int, faces: Sequence[FloatArray]) -> bytes:
    """GeoPackage binary of a MultiPolygonZ; ``faces`` holds (m, k, 3) corners of m polygons of k corners each, the first not repeated."""
    parts = []
    for block in faces:
        closed = np.concatenate([block, block[:, :1]], axis=1)
        polygons = np.zeros(
            len(closed), dtype=[("order", "u1"), ("kind", "<u4"), ("rings", "<u4"), ("corners", "<u4"), ("xyz", "<f8", closed.shape[1:])]
        )
        polygons["order"], polygons["kind"], polygons["rings"], polygons["corners"] = 1, 1003, 1, closed.shape[1]
        polygons["xyz"] = closed
        parts.append(polygons.tobytes())
    every = np.vstack([block.reshape(-1, 3) for block in faces])
    return b"".join([_header(srs_id, every), struct.pack("<BII", 1, 1006, sum(len(block) for block in faces)), *parts])


def encode_geometry(srs_id: int, kind: str, coordinates: Any) -> bytes:
    """GeoPackage binary of a geometry of the schema: (3,) of a PointZ, (n, 3) of a line or polygon, blocks of faces of a MultiPolygonZ."""
    if kind == "MultiPolygonZ":
        return encode_faces(srs_id, coordinates)
    values = np.asarray(coordinates, dtype=np.float64)
    if kind == "PointZ":
        return encode_point(srs_id, values)
    return encode_polygon(srs_id, values) if kind == "PolygonZ" else encode_line(srs_id, values)


def _header(srs_id: int, corners: FloatArray) -> bytes:
    low, high = corners[:, :2].min(axis=0), corners[:, :2].max(axis=0)
    return struct.pack("<2sBBi4d", b"GP", 0, 3, srs_id, low[0], high[0], low[1], high[1])


def _corners(corners: FloatArray) -> bytes:
    return np.ascontiguousarray(corners, dtype="<f8").tobytes()


def srs_of(connection: sqlite3.Connection, layer: str = "units") -> int:
    """srs_id of a layer."""
    row = connection.execute("SELECT srs_id FROM gpkg_geometry_columns WHERE table_name = ?", (layer,)).fetchone()
    return int(row["srs_id"]) if row else 0


@dataclass(frozen=True)
class ResultCrs:
    """CRS of a result.

    Attributes
    ----------
    name
        As the file names it.
    epsg
        EPSG code; None for a local frame or a CRS without a code.
    definition
        WKT, or ``undefined``.
    """

    name: str
    epsg: int | None
    definition: str

    @property
    def horizontal_epsg(self) -> int | None:
        """EPSG code of the CRS, or of its horizontal part where heights have a system of their own."""
        start = _PROJECTED.search(self.definition)
        if self.epsg is not None or start is None:
            return self.epsg
        depth = 0
        # what follows at the first level is the part's own: its units and axes have codes, too
        for found in _BRACKETS_AND_CODES.finditer(self.definition, start.end()):
            if found["code"] and depth == 0:
                return int(found["code"])
            depth += {"[": 1, "]": -1}.get(found[0], 0)
            if depth < 0:
                break
        return None

    @property
    def text(self) -> str:
        """As survey.toml writes it: a code, WKT, or LOCAL."""
        # QGIS's process reads results too, and loads nothing of the survey's data
        from ..data.crs import LOCAL

        if self.epsg is not None:
            return f"EPSG:{self.epsg}"
        return self.definition if _STATED.match(self.definition) else LOCAL


def crs_of(path: Path, layer: str | None = None) -> ResultCrs:
    """CRS of the layer ``units`` of a result, or of the one named, of any GeoPackage."""
    with reading(path, REQUIRED if layer is None else (layer,)) as connection:
        srs = srs_of(connection, layer or "units")
        row = connection.execute("SELECT * FROM gpkg_spatial_ref_sys WHERE srs_id = ?", (srs,)).fetchone()
    if row is None:
        return ResultCrs("", None, "undefined")
    known = str(row["organization"]).upper() == "EPSG"
    return ResultCrs(str(row["srs_name"]), int(row["organization_coordsys_id"]) if known else None, definition_of(row))


def definition_of(row: sqlite3.Row) -> str:
    """WKT of a row of ``gpkg_spatial_ref_sys``, or ``undefined``."""
    definition = str(row["definition"])
    if definition == "undefined" and WKT2_COLUMN in row.keys():  # noqa: SIM118 - a row of SQLite iterates over its values
        # where WKT of the first version cannot say it, as with heights of their own
        definition = str(row[WKT2_COLUMN])
    return definition


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
    except (ValueError, RecursionError):
        return {}
    return settings if isinstance(settings, dict) else {}


def epoch_pairs(path: Path) -> tuple[EpochPair, ...]:
    """Epoch pairs the result compares: consecutive ones in the order of time first, then the others.

    Consecutive epochs that a run compared are a pair though no unit is left that both see: all may be lost.
    """
    tables = table_names(path)
    consecutive = "SELECT 1 FROM displacements WHERE epoch_from = ? AND epoch_to = ? LIMIT 1"
    other = "SELECT 1 FROM displacements_other WHERE epoch_from = ? AND epoch_to = ? LIMIT 1"
    with reading(path) as connection:
        labels = [str(row["label"]) for row in connection.execute("SELECT label FROM epochs ORDER BY time")]
        possible = list(combinations(labels, 2))
        compared: set[tuple[str, str]] = set()
        if "epoch_pairs" in tables:
            rows = connection.execute("SELECT epoch_from, epoch_to FROM epoch_pairs").fetchall()
            compared = {(str(row["epoch_from"]), str(row["epoch_to"])) for row in rows} & set(pairwise(labels))
        found = [pair for pair in possible if pair in compared or connection.execute(consecutive, pair).fetchone()]
        if "displacements_other" in tables:
            found += [pair for pair in possible if pair not in found and connection.execute(other, pair).fetchone()]
    return tuple(EpochPair(*pair) for pair in found)


def latest_pair(pairs: Sequence[EpochPair], labels: Sequence[str]) -> EpochPair:
    """The last of the pairs of consecutive epochs, which a result is opened for; ``labels`` in the order of time."""
    consecutive = [pair for pair in pairs if labels.index(pair.epoch_to) == labels.index(pair.epoch_from) + 1]
    return max(consecutive or pairs, key=lambda pair: labels.index(pair.epoch_to))
