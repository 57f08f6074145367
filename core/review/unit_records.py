"""Rows of one unit in the layers of a result: read, written and removed by statements that stand here only."""

from __future__ import annotations

import sqlite3

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..results.geopackage_reader import Row, query

SELECT_OF_UNIT = {
    "units": "SELECT * FROM units WHERE unit_id = ?",
    "feature_points": "SELECT * FROM feature_points WHERE unit_id = ?",
    "displacements": "SELECT * FROM displacements WHERE unit_id = ?",
    "displacements_other": "SELECT * FROM displacements_other WHERE unit_id = ?",
    "check_residuals": "SELECT * FROM check_residuals WHERE unit_id = ?",
    "velocities": "SELECT * FROM velocities WHERE unit_id = ?",
}
DELETE_ROW = {
    "units": "DELETE FROM units WHERE fid = ?",
    "feature_points": "DELETE FROM feature_points WHERE fid = ?",
    "displacements": "DELETE FROM displacements WHERE fid = ?",
    "displacements_other": "DELETE FROM displacements_other WHERE fid = ?",
    "check_residuals": "DELETE FROM check_residuals WHERE fid = ?",
    "velocities": "DELETE FROM velocities WHERE fid = ?",
}
RENAME_ROW = {
    "units": "UPDATE units SET unit_id = ? WHERE fid = ?",
    "feature_points": "UPDATE feature_points SET unit_id = ? WHERE fid = ?",
    "check_residuals": "UPDATE check_residuals SET unit_id = ? WHERE fid = ?",
    "displacements": "UPDATE displacements SET unit_id = ? WHERE fid = ?",
    "displacements_other": "UPDATE displacements_other SET unit_id = ? WHERE fid = ?",
}


def tables_of(connection: sqlite3.Connection) -> set[str]:
    """Names of all tables in the file."""
    return {str(row["name"]) for row in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}


def rows_of_unit(connection: sqlite3.Connection, unit_id: str) -> dict[str, list[Row]]:
    """Rows of a unit by layer, geometry decoded and, as ``raw_geom``, as stored.

    Raises
    ------
    InputError
        There is no such unit.
    """
    present = tables_of(connection)
    rows = {layer: query(connection, statement, (unit_id,)) for layer, statement in SELECT_OF_UNIT.items() if layer in present}
    if not rows["units"]:
        raise InputError("there is no such unit", where=f"unit {unit_id}", remedy="Open the result again; it may have been deleted.")
    for layer, found in rows.items():
        for row in found:
            row["raw_geom"] = raw_row(connection, layer, row["fid"])["geom"]
    return rows


def raw_row(connection: sqlite3.Connection, layer: str, fid: int) -> Row:
    """One row as stored, its geometry as a blob."""
    statements = {
        "units": "SELECT * FROM units WHERE fid = ?",
        "feature_points": "SELECT * FROM feature_points WHERE fid = ?",
        "displacements": "SELECT * FROM displacements WHERE fid = ?",
        "displacements_other": "SELECT * FROM displacements_other WHERE fid = ?",
        "check_residuals": "SELECT * FROM check_residuals WHERE fid = ?",
        "velocities": "SELECT * FROM velocities WHERE fid = ?",
    }
    row = connection.execute(statements[layer], (fid,)).fetchone()
    return dict(row)


def insert_row(connection: sqlite3.Connection, layer: str, row: Row) -> int:
    """Insert what a row holds of the layer's columns; the number it got."""
    columns = [str(column["name"]) for column in connection.execute("SELECT name FROM pragma_table_info(?)", (layer,))]
    present = [name for name in columns if name in row]
    quoted = ", ".join('"' + name.replace('"', '""') + '"' for name in present)
    marks = ", ".join("?" * len(present))
    # layer and columns come from the file's own catalogue, values are bound
    statement = f'INSERT INTO "{layer}" ({quoted}) VALUES ({marks})'  # noqa: S608  # nosec B608
    return int(connection.execute(statement, [row[name] for name in present]).lastrowid or 0)


def place_of(rows: dict[str, list[Row]]) -> FloatArray | None:
    """Place of the first row that has one; None where none has."""
    return next((row["geom"] for row in rows["units"] if row["geom"] is not None), None)
