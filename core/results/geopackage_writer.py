"""Write result.gpkg: whole or not at all, with sqlite3 and the layout of OGC 12-128r18.

The file is built beside its target under a temporary name, forced to disk and renamed; an earlier result of that name has its layers
exchanged inside it instead (:mod:`.result_replacement`).
"""

from __future__ import annotations

import json
import math
import sqlite3
from collections.abc import Collection, Iterable, Mapping, Sequence
from contextlib import closing
from datetime import UTC, datetime
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np

from ..common.atomic_files import cannot_write, temporary_beside
from ..common.errors import InputError, OutputError
from ..common.output_files import not_own
from ..data.crs import LOCAL, parse_crs, wkt_of
from .epoch_ends import with_epoch_ends
from .geopackage_reader import WKT2_COLUMN, ResultCrs, add_indices, definition_of, encode_geometry, now_utc, parse_settings
from .result_access import connect, reading
from .result_replacement import add_wkt2, put_in_place, put_whole_in_place, quoted, rehearse, style_mark
from .schema import LAYERS, Field, Layer
from .unit_bodies import BODIES, body_rows
from .unit_sizes import sizes_of_settings

Row = Mapping[str, Any]

STYLES = Path(__file__).parent / "styles"

GEOMETRY = "geometry"
"""Key of a row's geometry: (3,) for points, (k, 3) for lines and polygons, blocks of faces (m, k, 3) for surfaces; absent or None for
a row without one."""

NEVER_EMPTIED = ("units", "feature_points", "displacements", "displacements_other", "control_residuals", "check_residuals")
"""Layers whose rows a single step that computes none of them does not replace by nothing."""
_APPLICATION_ID = 0x47504B47
_USER_VERSION = 10300
_LOCAL_SRS, _OWN_SRS = -1, 100000
_TYPES = {"text": "TEXT", "integer": "INTEGER", "real": "DOUBLE", "boolean": "BOOLEAN", "datetime": "DATETIME"}

_KEPT_BY_PROGRAMS = ("gpkg_", "rtree_", "sqlite_", "layer_styles")
"""Start of the names of tables in a GeoPackage that are no layers."""

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


def check_output(path: str | Path, survey_crs: str = LOCAL, *, step: Collection[str] | None = None) -> None:
    """Find out before any work whether a result in the survey's CRS can be written.

    Parameters
    ----------
    path
        Target.
    survey_crs
        As in survey.toml.
    step
        Layers that a single step computes; None for a whole run.

    Raises
    ------
    OutputError
        The folder is missing or read-only, the path is a folder or a file that tetratrack did not write, or an earlier result there is
        locked, read-only, or holds what a user added and a new run would lose, or what a single step would replace by nothing.
    """
    target = Path(path).absolute()
    _check_place(target)
    if step is not None and target.exists():
        _check_nothing_emptied(target, step)
    with temporary_beside(target) as temporary:
        # written even where nothing is to be replaced: a CRS that cannot be stated is found out now, not after hours
        _write_file(temporary, survey_crs, {}, {}, _reference_ids(target) if target.exists() else {})
        if target.exists():
            rehearse(temporary, target, _computed({}))


def _check_place(target: Path) -> None:
    if target.is_dir():
        raise OutputError("is a folder", source=target, remedy="Give the name of a file, for example result.gpkg.")
    if not target.parent.is_dir():
        raise OutputError("cannot be written: its folder does not exist", source=target, remedy=f"Create {target.parent} first.")
    if target.exists():
        try:
            connect(target).close()
        except InputError as error:
            raise OutputError(
                f"exists and is no result of tetratrack ({error.problem})", source=target, remedy="Choose another name for the new result."
            ) from error


def _check_nothing_emptied(target: Path, step: Collection[str]) -> None:
    with reading(target) as connection:
        present = {str(row["name"]) for row in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
        for name in NEVER_EMPTIED:
            if name in step or name not in present:
                continue
            (rows,) = connection.execute(f"SELECT count(*) FROM {quoted(name)}").fetchone()  # noqa: S608  # nosec B608 - a constant
            if rows:
                raise OutputError(
                    f"holds a result whose layer {name} ({rows} rows) this step does not compute and would empty",
                    source=target,
                    remedy="Choose another name for the output of a single step.",
                )


def write_result(path: str | Path, survey_crs: str, tables: Mapping[str, Sequence[Row]]) -> None:
    """Write a result with the shipped QGIS styles; outlines and surfaces follow from the units where no rows of them are given."""
    styles = {style.stem: style.read_text(encoding="utf-8") for style in sorted(STYLES.glob("*.qml")) if style.stem in LAYERS}
    settings = [parse_settings(row.get("settings")) for row in tables.get("epochs", ())]
    tables = with_epoch_ends(tables)
    if not BODIES.issubset(tables):
        tables |= body_rows(tables.get("units", ()), tables.get("displacements", ()), sizes_of_settings(settings))
    write_geopackage(path, survey_crs, tables, styles=styles)


def write_geopackage(
    path: str | Path, survey_crs: str, tables: Mapping[str, Sequence[Row]], *, styles: Mapping[str, str] | None = None
) -> None:
    """Write all layers of ``LAYERS``, the empty ones too; whole or not at all.

    Reviewers' decisions, corrections, and what users added to an earlier result of the same name are kept.

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
    _check_place(target)
    try:
        with temporary_beside(target) as temporary:
            _write_file(temporary, survey_crs, tables, styles or {}, _reference_ids(target) if target.exists() else {})
            put_in_place(temporary, target, _computed(tables))
    except (sqlite3.Error, OSError) as error:
        raise cannot_write(target, error) from error


def write_beside(path: Path, crs: ResultCrs, layers: Mapping[str, Layer], tables: Mapping[str, Sequence[Row]]) -> None:
    """Write layers that belong to a result into a GeoPackage of their own; whole or not at all.

    Parameters
    ----------
    path
        Target; replaced where it is there: :func:`check_beside` tells before the work whether it may be.
    crs
        That of the result.
    layers
        Layers to write, the empty ones too.
    tables
        Rows as :func:`write_geopackage` takes them.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    if not path.parent.is_dir():
        raise OutputError("cannot be written (its folder does not exist)", source=path, remedy="Choose a folder that exists.")
    styles = {name: style.read_text(encoding="utf-8") for name in layers if (style := STYLES / f"{name}.qml").is_file()}
    try:
        with temporary_beside(path.absolute()) as temporary:
            with closing(sqlite3.connect(temporary, isolation_level=None)) as connection:
                _build(connection, crs.text, tables, styles, {}, layers)
            put_whole_in_place(temporary, path.absolute())
    except (sqlite3.Error, OSError) as error:
        raise cannot_write(path, error) from error


def check_beside(path: Path, layers: Iterable[Layer]) -> None:
    """Refuse to replace a GeoPackage that holds anything but these layers with their own fields: a result, or work of a user.

    Raises
    ------
    OutputError
        Before anything is written.
    """
    if not path.is_file():
        return
    own = {layer.name: {"fid", "geom", *layer.names} for layer in layers}
    try:
        with reading(path, ()) as connection:
            tables = [str(row["name"]) for row in connection.execute("SELECT name FROM sqlite_master WHERE type IN ('table', 'view')")]
            found = {
                name: {str(row["name"]) for row in connection.execute(f"PRAGMA table_info({quoted(name)})")}
                for name in tables
                if not name.startswith(_KEPT_BY_PROGRAMS)
            }
    except InputError as error:
        raise not_own(path) from error
    if any(not fields <= own.get(name, set()) for name, fields in found.items()):
        raise not_own(path)


def _computed(tables: Mapping[str, Sequence[Row]]) -> tuple[str, ...]:
    """Layers that a run writes; decisions are the reviewers' unless they are given."""
    return tuple(name for name in LAYERS if name != "reviews" or tables.get("reviews"))


def _reference_ids(earlier: Path) -> dict[int, str]:
    """Definition by number of the reference systems in an earlier result."""
    with reading(earlier) as connection:
        rows = connection.execute("SELECT * FROM gpkg_spatial_ref_sys").fetchall()
    return {int(row["srs_id"]): definition_of(row) for row in rows}


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


def _write_file(
    path: Path, survey_crs: str, tables: Mapping[str, Sequence[Row]], styles: Mapping[str, str], taken: Mapping[int, str] | None = None
) -> None:
    """Write a complete GeoPackage; numbers of reference systems ``taken`` with another definition are left alone."""
    with closing(sqlite3.connect(path, isolation_level=None)) as connection:
        _build(connection, survey_crs, tables, styles, taken or {})


def _build(
    connection: sqlite3.Connection,
    survey_crs: str,
    tables: Mapping[str, Sequence[Row]],
    styles: Mapping[str, str],
    taken: Mapping[int, str],
    layers: Mapping[str, Layer] = LAYERS,
) -> None:
    # nothing reads the temporary file before it is complete, so the journal would only cost time
    connection.execute("PRAGMA journal_mode = OFF")
    connection.execute("PRAGMA synchronous = OFF")
    connection.execute(f"PRAGMA application_id = {_APPLICATION_ID:d}")
    connection.execute(f"PRAGMA user_version = {_USER_VERSION:d}")
    connection.execute("BEGIN")
    for statement in _SYSTEM_TABLES.split(";"):
        connection.execute(statement)
    connection.executemany("INSERT INTO gpkg_spatial_ref_sys VALUES (?, ?, ?, ?, ?, ?)", _REFERENCE_SYSTEMS)
    srs = _add_reference_system(connection, survey_crs, taken)
    for layer in layers.values():
        _add_layer(connection, layer, srs, tables.get(layer.name, ()))
    for name, qml in styles.items():
        connection.execute(
            "INSERT INTO layer_styles (f_table_catalog, f_table_schema, f_table_name, f_geometry_column, styleName, styleQML, styleSLD, "
            "useAsDefault, description, owner) VALUES ('', '', ?, ?, ?, ?, '', 1, ?, '')",
            (name, "" if layers[name].geometry == "none" else "geom", name, qml, style_mark(qml)),
        )
    add_indices(connection)
    connection.execute("COMMIT")


def _add_reference_system(connection: sqlite3.Connection, survey_crs: str, taken: Mapping[int, str]) -> int:
    if survey_crs == LOCAL:
        return _LOCAL_SRS
    crs = parse_crs(survey_crs)
    authority = crs.to_authority(min_confidence=100)
    organisation, code = (authority[0], int(authority[1])) if authority and authority[1].isdigit() else ("NONE", _OWN_SRS)
    definition, first_version = wkt_of(crs)
    srs = code if organisation == "EPSG" else next(k for k in count(_OWN_SRS) if taken.get(k, definition) == definition)
    if srs != 4326:
        stated = (crs.name, srs, organisation, code, definition if first_version else "undefined")
        connection.execute("INSERT INTO gpkg_spatial_ref_sys VALUES (?, ?, ?, ?, ?, '')", stated)
    if not first_version:
        add_wkt2(connection)
        statement = f"UPDATE gpkg_spatial_ref_sys SET {WKT2_COLUMN} = ? WHERE srs_id = ?"  # noqa: S608  # nosec B608 - a constant
        connection.execute(statement, (definition, srs))
    return srs


def _add_layer(connection: sqlite3.Connection, layer: Layer, srs: int, rows: Sequence[Row]) -> None:
    columns = ["fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL"]
    spatial = layer.geometry != "none"
    if spatial:
        columns.append(f"geom {_kind(layer)}")
    columns += [f"{quoted(field.name)} {_TYPES[field.type]}" for field in layer.fields]
    table = quoted(layer.name)
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
                blob = encode_geometry(srs, layer.geometry, coordinates)
                blocks = coordinates if layer.geometry == "MultiPolygonZ" else [np.asarray(coordinates, dtype=np.float64)]
                flat = np.vstack([block.reshape(-1, 3)[:, :2] for block in blocks])
                low, high = np.minimum(low, flat.min(axis=0)), np.maximum(high, flat.max(axis=0))
            record.insert(0, blob)
        records.append(record)
    if np.isfinite(low).all():
        extent = [float(v) for v in (*low, *high)]
    names = (["geom"] if spatial else []) + [quoted(name) for name in layer.names]
    marks = ", ".join("?" * len(names))
    connection.executemany(f"INSERT INTO {table} ({', '.join(names)}) VALUES ({marks})", records)  # noqa: S608  # nosec B608 - names of LAYERS
    connection.execute(
        "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, last_change, min_x, min_y, max_x, max_y, srs_id) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        (layer.name, "features" if spatial else "attributes", layer.name, layer.description, now_utc(), *extent, srs if spatial else 0),
    )
    if spatial:
        connection.execute("INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', ?, ?, 1, 0)", (layer.name, _kind(layer), srs))


def _kind(layer: Layer) -> str:
    """Name of a layer's geometry in the catalogue, which states the third coordinate apart."""
    return layer.geometry.removesuffix("Z").upper()


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
