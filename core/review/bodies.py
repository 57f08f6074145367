"""Outlines and surfaces of corrected units: drawn again within the transaction of the correction; their placement lapses."""

from __future__ import annotations

import sqlite3
from collections.abc import Collection

from ..results.geopackage_reader import encode_geometry, parse_settings, query, srs_of
from ..results.schema import LAYERS
from ..results.unit_bodies import body_rows
from ..results.unit_sizes import sizes_of_settings
from .unit_records import tables_of

DELETE = {
    "unit_outlines": "DELETE FROM unit_outlines WHERE unit_id = ?",
    "unit_surfaces": "DELETE FROM unit_surfaces WHERE unit_id = ?",
}


def redraw_bodies(connection: sqlite3.Connection, unit_ids: Collection[str]) -> None:
    """Make outlines and surfaces of units anew from their poses; a result of an earlier version without these layers stays as it is."""
    present = tables_of(connection)
    if "placement" in present:
        # neighbours count there, and their search needs libraries that QGIS lacks: the figures of the unit lapse until the next run
        connection.executemany("DELETE FROM placement WHERE unit_id = ?", [(unit_id,) for unit_id in sorted(unit_ids)])
    if not present.issuperset(DELETE):
        return
    sizes = sizes_of_settings(parse_settings(row["settings"]) for row in connection.execute("SELECT settings FROM epochs ORDER BY time"))
    srs = srs_of(connection)
    for unit_id in sorted(unit_ids):
        units = query(connection, "SELECT * FROM units WHERE unit_id = ?", (unit_id,))
        moved = query(connection, "SELECT * FROM displacements WHERE unit_id = ?", (unit_id,))
        for layer, rows in body_rows(units, moved, sizes).items():
            connection.execute(DELETE[layer], (unit_id,))
            names = LAYERS[layer].names
            columns = ", ".join(f'"{name}"' for name in ("geom", *names))
            marks = ", ".join("?" * (len(names) + 1))
            values = [(encode_geometry(srs, LAYERS[layer].geometry, row["geometry"]), *(row[name] for name in names)) for row in rows]
            # names of the schema, values are bound
            connection.executemany(f'INSERT INTO "{layer}" ({columns}) VALUES ({marks})', values)  # noqa: S608  # nosec B608
