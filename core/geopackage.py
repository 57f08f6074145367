"""Write result.gpkg: whole or not at all, with sqlite3 and the layout of OGC 12-128r18.

The file is built beside its target under a temporary name, forced to disk and renamed. Where another program has the target
open (its write-ahead log lies beside it), renaming would marry that log to a foreign file; there the contents are replaced by one
SQLite transaction instead.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import sqlite3
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np

from .crs import LOCAL, parse_crs
from .errors import InputError, OutputError
from .result_tables import add_indices, connect, encode_line, encode_point, now_utc
from .schema import LAYERS, Field, Layer

Row = Mapping[str, Any]

STYLES = Path(__file__).parent / "styles"

GEOMETRY = "geometry"
"""Key of a row's geometry: (3,) for points, (k, 3) for lines, absent or None for a row without one."""

_APPLICATION_ID = 0x47504B47
_USER_VERSION = 10300
_LOCAL_SRS, _OWN_SRS = -1, 100000
_TYPES = {"text": "TEXT", "integer": "INTEGER", "real": "DOUBLE", "boolean": "BOOLEAN", "datetime": "DATETIME"}

_SYSTEM_TABLES = """
CREATE TABLE gpkg_spatial_ref_sys (srs_name TEXT NOT NULL, srs_id INTEGER NOT NULL PRIMARY KEY, organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT);
CREATE TABLE gpkg_contents (table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE,
  description TEXT DEFAULT '', last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')),
  min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE,
  srs_id INTEGER, CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id));
CREATE TABLE gpkg_geometry_columns (table_name TEXT NOT NULL, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL, CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name),
  CONSTRAINT uk_gc_table_name UNIQUE (table_name));
CREATE TABLE layer_styles (id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, f_table_catalog TEXT(256), f_table_schema TEXT(256),
  f_table_name TEXT(256), f_geometry_column TEXT(256), styleName TEXT(30), styleQML TEXT, styleSLD TEXT, useAsDefault BOOLEAN,
  description TEXT, owner TEXT(30), ui TEXT(30), update_time DATETIME DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')));
INSERT INTO gpkg_contents (table_name, data_type, identifier, srs_id) VALUES ('layer_styles', 'attributes', 'layer_styles', 0);
"""

_REFERENCE_SYSTEMS = (
    ("Undefined Cartesian SRS", -1, "NONE", -1, "undefined", "undefined Cartesian coordinate reference system"),
    ("Undefined geographic SRS", 0, "NONE", 0, "undefined", "undefined geographic coordinate reference system"),
    (
        "WGS 84 geodetic",
        4326,
        "EPSG",
        4326,
        'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,AUTHORITY["EPSG","7030"]],AUTHORITY["EPSG","6326"]],'
        'PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],'
        'AXIS["Latitude",NORTH],AXIS["Longitude",EAST],AUTHORITY["EPSG","4326"]]',
        "longitude/latitude coordinates in decimal degrees on the WGS 84 spheroid",
    ),
)


def check_output(path: str | Path) -> None:
    """Find out before any work whether a result can be written.

    Raises
    ------
    OutputError
        The folder is missing or read-only, or the path is a folder or a file that tetratrack did not write.
    """
    target = Path(path).absolute()
    if target.is_dir():
        raise OutputError("is a folder", source=target, remedy="Give the name of a file, for example result.gpkg.")
    if not target.parent.is_dir():
        raise OutputError("cannot be written: its folder does not exist", source=target, remedy=f"Create {target.parent} first.")
    if target.exists():
        try:
            connect(target).close()
        except InputError as error:
            raise OutputError(
                "exists and is no result of tetratrack", source=target, remedy="Choose another name, or delete it first."
            ) from error
    with temporary_beside(target):
        pass


def write_result(path: str | Path, survey_crs: str, tables: Mapping[str, Sequence[Row]]) -> None:
    """Write a result with the shipped QGIS styles."""
    styles = {style.stem: style.read_text(encoding="utf-8") for style in sorted(STYLES.glob("*.qml"))}
    write_geopackage(path, survey_crs, tables, styles=styles)


def write_geopackage(
    path: str | Path, survey_crs: str, tables: Mapping[str, Sequence[Row]], *, styles: Mapping[str, str] | None = None
) -> None:
    """Write all layers of ``LAYERS``, the empty ones too; whole or not at all.

    Reviewers' decisions and tables that other tools added to an earlier result of the same name are kept.

    Parameters
    ----------
    path
        Target; replaced if it is an earlier result.
    survey_crs
        CRS of all geometries, as in survey.toml.
    tables
        Rows by layer name; a row maps field names to values (datetimes aware, numpy scalars welcome, nan written as NULL) and
        ``geometry`` to coordinates.
    styles
        QGIS styles (QML) by layer name, stored in ``layer_styles``.

    Raises
    ------
    OutputError
        The file cannot be written, or the disk is full.
    """
    target = Path(path).absolute()
    check_output(target)
    try:
        with temporary_beside(target) as temporary:
            with closing(sqlite3.connect(temporary, isolation_level=None)) as connection:
                _build(connection, survey_crs, tables, styles or {})
                if target.exists():
                    _keep_foreign(connection, target, replaced=tuple(name for name in LAYERS if name != "reviews" or tables.get("reviews")))
            if target.with_name(target.name + "-wal").exists():
                _replace_contents(target, temporary)
            else:
                replace_durably(temporary, target)
    except (sqlite3.Error, OSError) as error:
        raise _cannot_write(target, error) from error


@contextmanager
def temporary_beside(target: Path) -> Iterator[Path]:
    """An empty temporary file in the target's folder, removed on leaving unless it was renamed."""
    try:
        handle, name = tempfile.mkstemp(prefix=f".{target.name}.", suffix=".part", dir=target.parent)
        os.close(handle)
    except OSError as error:
        raise _cannot_write(target, error) from error
    temporary = Path(name)
    try:
        yield temporary
    finally:
        for leftover in (temporary, temporary.with_name(temporary.name + "-journal")):
            with contextlib.suppress(FileNotFoundError):
                leftover.unlink()


def replace_durably(temporary: Path, target: Path) -> None:
    """Give a finished temporary file its name so that neither a crash nor power loss leaves a half-written file."""
    with temporary.open("rb+") as stream:
        os.fsync(stream.fileno())
    # mkstemp makes files for the owner alone; results are shared like any other file
    mask = os.umask(0)
    os.umask(mask)
    temporary.chmod(0o666 & ~mask)
    temporary.replace(target)
    if os.name == "posix":
        folder = os.open(target.parent, os.O_RDONLY)
        try:
            os.fsync(folder)
        finally:
            os.close(folder)


def upper_triangle(matrix: Any) -> str:
    """JSON list of the upper triangle of a symmetric matrix by rows, as ``units.covariance`` holds it."""
    values = np.asarray(matrix, dtype=np.float64)
    return json.dumps([float(v) for v in values[np.triu_indices(len(values))]])


def from_upper_triangle(text: str) -> Any:
    """Inverse of :func:`upper_triangle`: (k, k) array."""
    values = np.array(json.loads(text), dtype=np.float64)
    size = round((math.sqrt(8 * len(values) + 1) - 1) / 2)
    matrix = np.zeros((size, size))
    matrix[np.triu_indices(size)] = values
    return matrix + np.triu(matrix, 1).T


def _build(connection: sqlite3.Connection, survey_crs: str, tables: Mapping[str, Sequence[Row]], styles: Mapping[str, str]) -> None:
    # nothing reads the temporary file before it is complete, so the journal would only cost time
    connection.execute("PRAGMA journal_mode = OFF")
    connection.execute("PRAGMA synchronous = OFF")
    connection.execute(f"PRAGMA application_id = {_APPLICATION_ID:d}")
    connection.execute(f"PRAGMA user_version = {_USER_VERSION:d}")
    connection.execute("BEGIN")
    for statement in _SYSTEM_TABLES.split(";"):
        connection.execute(statement)
    connection.executemany("INSERT INTO gpkg_spatial_ref_sys VALUES (?, ?, ?, ?, ?, ?)", _REFERENCE_SYSTEMS)
    srs = _add_reference_system(connection, survey_crs)
    for layer in LAYERS.values():
        _add_layer(connection, layer, srs, tables.get(layer.name, ()))
    for name, qml in styles.items():
        connection.execute(
            "INSERT INTO layer_styles (f_table_catalog, f_table_schema, f_table_name, f_geometry_column, styleName, styleQML, styleSLD, "
            "useAsDefault, description, owner) VALUES ('', '', ?, ?, ?, ?, '', 1, '', '')",
            (name, "" if LAYERS[name].geometry == "none" else "geom", name, qml),
        )
    add_indices(connection)
    connection.execute("COMMIT")


def _add_reference_system(connection: sqlite3.Connection, survey_crs: str) -> int:
    if survey_crs == LOCAL:
        return _LOCAL_SRS
    crs = parse_crs(survey_crs)
    authority = crs.to_authority(min_confidence=100)
    organisation, code = (authority[0], int(authority[1])) if authority and authority[1].isdigit() else ("NONE", _OWN_SRS)
    srs = code if organisation == "EPSG" else _OWN_SRS
    if srs != 4326:
        connection.execute(
            "INSERT INTO gpkg_spatial_ref_sys VALUES (?, ?, ?, ?, ?, '')", (crs.name, srs, organisation, code, crs.to_wkt("WKT1_GDAL"))
        )
    return srs


def _add_layer(connection: sqlite3.Connection, layer: Layer, srs: int, rows: Sequence[Row]) -> None:
    columns = ["fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL"]
    spatial = layer.geometry != "none"
    if spatial:
        columns.append(f"geom {'POINT' if layer.geometry == 'PointZ' else 'LINESTRING'}")
    columns += [f"{_quoted(field.name)} {_TYPES[field.type]}" for field in layer.fields]
    table = _quoted(layer.name)
    connection.execute(f"CREATE TABLE {table} ({', '.join(columns)})")
    known = {GEOMETRY, *layer.names}
    extent: list[Any] = [None] * 4
    low, high = np.full(2, np.inf), np.full(2, -np.inf)
    records = []
    for row in rows:
        if not known.issuperset(row):
            raise KeyError(f"layer {layer.name} has no field {sorted(set(row) - known)}")
        record = [_value(field, row.get(field.name)) for field in layer.fields]
        if spatial:
            coordinates = row.get(GEOMETRY)
            blob = None
            if coordinates is not None:
                coordinates = np.asarray(coordinates, dtype=np.float64)
                blob = encode_point(srs, coordinates) if layer.geometry == "PointZ" else encode_line(srs, coordinates)
                flat = coordinates.reshape(-1, 3)[:, :2]
                low, high = np.minimum(low, flat.min(axis=0)), np.maximum(high, flat.max(axis=0))
            record.insert(0, blob)
        records.append(record)
    if np.isfinite(low).all():
        extent = [float(v) for v in (*low, *high)]
    names = (["geom"] if spatial else []) + [_quoted(name) for name in layer.names]
    marks = ", ".join("?" * len(names))
    connection.executemany(f"INSERT INTO {table} ({', '.join(names)}) VALUES ({marks})", records)  # noqa: S608  # nosec B608 - names of LAYERS
    connection.execute(
        "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, last_change, min_x, min_y, max_x, max_y, srs_id) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        (layer.name, "features" if spatial else "attributes", layer.name, layer.description, now_utc(), *extent, srs if spatial else 0),
    )
    if spatial:
        kind = "POINT" if layer.geometry == "PointZ" else "LINESTRING"
        connection.execute("INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', ?, ?, 1, 0)", (layer.name, kind, srs))


def _value(field: Field, value: Any) -> Any:
    """SQLite value of a field: NULL for None and nan."""
    if value is None:
        return None
    if field.type == "text":
        return value if isinstance(value, str) else str(value)
    if field.type == "datetime":
        if isinstance(value, str):
            value = datetime.fromisoformat(value)
        if value.tzinfo is None:
            raise ValueError(f"{field.name} needs a time zone")
        return value.astimezone(UTC).strftime("%Y-%m-%dT%H:%M:%S.%f")[:-3] + "Z"
    if field.type == "boolean":
        return int(bool(value))
    if field.type == "integer":
        return int(value)
    number = float(value)
    return number if math.isfinite(number) else None


def _keep_foreign(connection: sqlite3.Connection, earlier: Path, replaced: Sequence[str]) -> None:
    """Copy from an earlier result what this run does not compute: reviews, and tables other tools added."""
    connection.execute("ATTACH ? AS earlier", (str(earlier),))
    try:
        own = {*replaced, "layer_styles"}
        listed = [
            str(row[0])
            for row in connection.execute("SELECT name FROM earlier.sqlite_master WHERE type = 'table' ORDER BY name")
            if row[0] not in own and not str(row[0]).startswith(("gpkg_", "sqlite_", "rtree_"))
        ]
        for name in listed:
            _copy_table(connection, name)
    finally:
        connection.execute("DETACH earlier")


def _copy_table(connection: sqlite3.Connection, name: str) -> None:
    """Copy one table of the attached ``earlier`` with its registration; columns a later version added stay empty."""
    table = _quoted(name)
    (definition,) = connection.execute("SELECT sql FROM earlier.sqlite_master WHERE type = 'table' AND name = ?", (name,)).fetchone()
    if connection.execute("SELECT 1 FROM main.sqlite_master WHERE name = ?", (name,)).fetchone() is None:
        connection.execute(definition)
        for registry in ("gpkg_contents", "gpkg_geometry_columns"):
            connection.execute(
                f"INSERT INTO main.{registry} SELECT * FROM earlier.{registry} WHERE table_name = ?",  # noqa: S608  # nosec B608 - constants
                (name,),
            )
    have = [str(row[1]) for row in connection.execute(f"PRAGMA main.table_info({table})")]
    had = {str(row[1]) for row in connection.execute(f"PRAGMA earlier.table_info({table})")}
    common = ", ".join(_quoted(column) for column in have if column in had)
    connection.execute(
        f"INSERT INTO main.{table} ({common}) SELECT {common} FROM earlier.{table}"  # noqa: S608  # nosec B608 - quoted identifiers
    )


def _replace_contents(target: Path, source: Path) -> None:
    """Replace all contents of an open database by those of a finished one, in a single transaction."""
    with closing(sqlite3.connect(target, isolation_level=None, timeout=30)) as connection:
        connection.execute("ATTACH ? AS finished", (str(source),))
        connection.execute("BEGIN IMMEDIATE")
        try:
            for kind, name in connection.execute(
                "SELECT type, name FROM main.sqlite_master WHERE type IN ('trigger', 'view') AND name NOT LIKE 'sqlite%'"
            ).fetchall():
                connection.execute(f"DROP {'TRIGGER' if kind == 'trigger' else 'VIEW'} {_quoted(name)}")
            old = [
                str(row[0]) for row in connection.execute("SELECT name FROM main.sqlite_master WHERE type = 'table' AND sql LIKE 'CREATE%'")
            ]
            # dropping a virtual table drops its shadow tables too
            for name in sorted(old, key=lambda n: not n.startswith("rtree_")):
                if not name.startswith("sqlite_"):
                    connection.execute(f"DROP TABLE IF EXISTS {_quoted(name)}")
            tables = connection.execute(
                "SELECT name, sql FROM finished.sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite%'"
            ).fetchall()
            for name, definition in tables:
                connection.execute(definition)
                connection.execute(
                    f"INSERT INTO main.{_quoted(name)} SELECT * FROM finished.{_quoted(name)}"  # noqa: S608  # nosec B608 - quoted identifiers
                )
            connection.execute("COMMIT")
        except BaseException:
            connection.execute("ROLLBACK")
            raise


def _quoted(identifier: str) -> str:
    """An SQL identifier in quotes."""
    if '"' in identifier or "\0" in identifier:
        raise ValueError(f"not an identifier: {identifier!r}")
    return f'"{identifier}"'


def _cannot_write(target: Path, error: Exception) -> OutputError:
    reason = getattr(error, "strerror", None) or str(error)
    return OutputError(f"cannot be written ({reason})", source=target, remedy="Check the folder's permissions and free space.")
