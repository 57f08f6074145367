"""Rows of one unit in the layers of a result: read, written and removed by statements that stand here only."""

from __future__ import annotations

import sqlite3

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..results.geopackage_reader import Row, query
from ..results.schema import LAYERS

MADE_ELSEWHERE = frozenset({"unit_outlines", "unit_surfaces", "placement", "reviews"})
"""Layers that corrections draw again or let lapse as a whole, and decisions, which follow the numbers."""
OF_UNITS = (*(name for name, layer in LAYERS.items() if "unit_id" in layer.names and name not in MADE_ELSEWHERE), "manual_picks")
"""Layers whose rows belong to a unit and go with its name."""
# the names are those of the schema
SELECT_OF_UNIT = {layer: f"SELECT * FROM {layer} WHERE unit_id = ?" for layer in OF_UNITS}  # noqa: S608  # nosec B608
SELECT_ROW = {layer: f"SELECT * FROM {layer} WHERE fid = ?" for layer in OF_UNITS}  # noqa: S608  # nosec B608
DELETE_ROW = {layer: f"DELETE FROM {layer} WHERE fid = ?" for layer in OF_UNITS}  # noqa: S608  # nosec B608
RENAME_ROW = {layer: f"UPDATE {layer} SET unit_id = ? WHERE fid = ?" for layer in OF_UNITS}  # noqa: S608  # nosec B608


def tables_of(connection: sqlite3.Connection) -> set[str]:
    """Names of all tables in the file."""
    return {str(row["name"]) for row in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}


def columns_of(connection: sqlite3.Connection, table: str) -> list[str]:
    """Names of the columns of a table; none where there is no such table."""
    return [str(column["name"]) for column in connection.execute("SELECT name FROM pragma_table_info(?)", (table,))]


def rows_of_unit(connection: sqlite3.Connection, unit_id: str) -> dict[str, list[Row]]:
    """Rows of a unit by layer, geometry decoded and, as ``raw_geom``, as stored.

    Raises
    ------
    InputError
        There is no such unit.
    """
    rows = {layer: query(connection, SELECT_OF_UNIT[layer], (unit_id,)) for layer in OF_UNITS if "unit_id" in columns_of(connection, layer)}
    if not rows["units"]:
        raise InputError("there is no such unit", where=f"unit {unit_id}", remedy="Open the result again; it may have been deleted.")
    for layer, found in rows.items():
        for row in found:
            row["raw_geom"] = raw_row(connection, layer, row["fid"])["geom"]
    return rows


def raw_row(connection: sqlite3.Connection, layer: str, fid: int) -> Row:
    """One row as stored, its geometry as a blob."""
    row = connection.execute(SELECT_ROW[layer], (fid,)).fetchone()
    return dict(row)


def insert_row(connection: sqlite3.Connection, layer: str, row: Row) -> int:
    """Insert what a row holds of the layer's columns; the number it got."""
    present = [name for name in columns_of(connection, layer) if name in row]
    quoted = ", ".join('"' + name.replace('"', '""') + '"' for name in present)
    marks = ", ".join("?" * len(present))
    # layer and columns come from the file's own catalogue, values are bound
    statement = f'INSERT INTO "{layer}" ({quoted}) VALUES ({marks})'  # noqa: S608  # nosec B608
    return int(connection.execute(statement, [row[name] for name in present]).lastrowid or 0)


def delete_rows(connection: sqlite3.Connection, rows: dict[str, list[Row]]) -> None:
    """Delete rows by layer; a layer that the file does not hold has none."""
    for layer, found in rows.items():
        # SQLite looks for the table even where there is nothing to delete
        if found:
            connection.executemany(DELETE_ROW[layer], [(row["fid"],) for row in found])


def place_of(rows: dict[str, list[Row]]) -> FloatArray | None:
    """Place of the first row that has one; None where none has."""
    return next((row["geom"] for row in rows["units"] if row["geom"] is not None), None)
