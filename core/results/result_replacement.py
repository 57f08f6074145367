"""One way to replace a result: its layers are exchanged inside the file, in one transaction of SQLite.

The file stays the same one, so that a reviewer, QGIS or any other program that has it open neither writes to a file that is gone nor
leaves its journal to a foreign one; decisions wait for the transaction and follow it. What the run does not compute stays untouched:
decisions, corrections, and layers, views, triggers, styles and reference systems that users added. What cannot stay is found out before
the work, by the same exchange with empty layers, rolled back.
"""

from __future__ import annotations

import hashlib
import sqlite3
import time
from collections.abc import Collection, Iterator
from contextlib import closing, contextmanager
from pathlib import Path

from ..common.atomic_files import cannot_write, replace_durably
from ..common.errors import OutputError
from ..common.paths import sqlite_address
from .geopackage_reader import WKT2_COLUMN, add_spatial_functions
from .result_access import BUSY_SECONDS, connect, is_writable
from .schema import LAYERS

REHEARSAL_SECONDS = 2.0
"""How long the look before the work waits for another program that is writing."""
LOCK_SECONDS = 0.002
"""Pause between two tries to get the lock."""
STYLE_MARK = "tetratrack "
"""Start of a shipped style's description, before a checksum that tells whether a user changed the style since."""
EARLIER_FIELDS = frozenset({"adjusted_p_value"})
"""Fields of earlier versions, which no user added."""


def remove_stale_logs(target: Path) -> None:
    """Remove journals beside a result that does not exist: SQLite would take them for the new file's own."""
    if not target.exists():
        for suffix in ("-journal", "-wal", "-shm"):
            target.with_name(target.name + suffix).unlink(missing_ok=True)


def put_in_place(finished: Path, target: Path, computed: Collection[str]) -> None:
    """Make a finished GeoPackage the result: under its name where there is none yet, otherwise by exchange of its layers.

    Parameters
    ----------
    finished
        Complete GeoPackage beside the target; gone where it could be given the target's name.
    target
        Result file.
    computed
        Layers to exchange; the others of an earlier result stay.

    Raises
    ------
    OutputError
        Another program kept the earlier result locked, or that is damaged; the new result is then kept under another name.
    sqlite3.Error, OSError
        The disk is full, or the file cannot be written; the earlier result is as it was.
    """
    if not target.exists():
        remove_stale_logs(target)
        replace_durably(finished, target)
        return
    try:
        with _exchange(finished, target, computed, BUSY_SECONDS):
            pass
    except sqlite3.DatabaseError as error:
        if "full" in str(error) or "I/O" in str(error):
            raise
        kept = _free_name(target)
        replace_durably(finished, kept)
        raise OutputError(
            f"could not be replaced ({error}), so the new result is kept as {kept.name}, without the decisions in {target.name}",
            source=target,
            remedy="Close the programs that have it open and run again, or use the new file.",
        ) from error


def put_whole_in_place(finished: Path, target: Path) -> None:
    """Make a finished GeoPackage, to which users add nothing, the file of a name: inside the file where there is one.

    Another program may have that open: its write-ahead log would be applied to a new file of the same name, which is then malformed.

    Parameters
    ----------
    finished
        Complete GeoPackage beside the target; gone where it could be given the target's name.
    target
        Earlier file of the same kind, or none.

    Raises
    ------
    OutputError, sqlite3.Error, OSError
        Another program kept the earlier file locked, the disk is full, or the file cannot be written; it is as it was.
    """
    if not target.exists():
        remove_stale_logs(target)
        replace_durably(finished, target)
        return
    end = time.monotonic() + BUSY_SECONDS

    def look(status: int, remaining: int, total: int) -> None:
        # a copy of SQLite would try for ever; it asks once more when it is done
        if status in (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED) and time.monotonic() > end:
            raise sqlite3.OperationalError("database is locked")

    # read only and unchangeable, as nobody else knows it
    address = sqlite_address(finished.resolve(), "mode=ro&immutable=1")
    with closing(connect(target, write=True, needed=())) as there, closing(sqlite3.connect(address, uri=True)) as made:
        there.execute("PRAGMA synchronous = FULL")
        made.backup(there, progress=look, sleep=LOCK_SECONDS)


def rehearse(finished: Path, target: Path, computed: Collection[str]) -> None:
    """Find out before the work whether an earlier result can be replaced, by doing so and taking it back.

    Raises
    ------
    OutputError
        It is read-only or locked, or holds what a user added and a new run would lose.
    """
    if not is_writable(target):
        raise OutputError("is read-only", source=target, remedy="Allow writing to the file and its folder, or choose another name.")
    try:
        with _exchange(finished, target, computed, REHEARSAL_SECONDS):
            raise _TakenBack
    except _TakenBack:
        return
    except sqlite3.OperationalError as error:
        if "locked" not in str(error):
            raise cannot_write(target, error) from error
        raise OutputError(
            "is locked by another program, which is writing to it",
            source=target,
            remedy="Save and close it there (an edit session in QGIS, for example), or choose another name.",
        ) from error
    except sqlite3.Error as error:
        raise OutputError(
            f"holds what a new run would lose or break ({error})", source=target, remedy="Choose another name for the new result."
        ) from error


class _TakenBack(Exception):
    """Ends a rehearsal."""


@contextmanager
def _exchange(finished: Path, target: Path, computed: Collection[str], patience: float) -> Iterator[None]:
    """The exchange as a transaction, committed on leaving and taken back on any error."""
    with closing(connect(target, write=True)) as connection:
        connection.execute("PRAGMA synchronous = FULL")
        # spilled pages would shut readers out for the time of the whole exchange
        connection.execute("PRAGMA cache_spill = OFF")
        add_spatial_functions(connection)
        # read only: a transaction on two files would leave a journal of its own beside them when it is killed
        connection.execute("ATTACH ? AS finished", (sqlite_address(finished.resolve(), "mode=ro&immutable=1"),))
        _begin(connection, patience)
        try:
            for name in computed:
                _exchange_layer(connection, name, target)
            _complete_other_layers(connection, computed)
            _exchange_styles(connection)
            _add_reference_systems(connection)
            yield
            connection.execute("COMMIT")
        except BaseException:
            if connection.in_transaction:
                connection.execute("ROLLBACK")
            raise


def _begin(connection: sqlite3.Connection, patience: float) -> None:
    """Begin to write; asks more often than SQLite would, which waits longer and longer and so never gets in between busy reviewers."""
    end = time.monotonic() + patience
    connection.execute("PRAGMA busy_timeout = 0")
    while True:
        try:
            connection.execute("BEGIN IMMEDIATE")
            break
        except sqlite3.OperationalError as error:
            if "locked" not in str(error) or time.monotonic() > end:
                raise
        time.sleep(LOCK_SECONDS)
    connection.execute(f"PRAGMA busy_timeout = {int(1000 * BUSY_SECONDS):d}")


def _exchange_layer(connection: sqlite3.Connection, name: str, target: Path) -> None:
    """Exchange one layer with its registration; indices and triggers that users added to it are made again."""
    table = quoted(name)
    columns = [str(row[1]) for row in connection.execute(f"PRAGMA main.table_info({table})")]
    own = {"fid", "geom", *LAYERS[name].names} | EARLIER_FIELDS
    added = [column for column in columns if column not in own]
    if added:
        raise OutputError(
            f"holds a field {added[0]} that a user added and a new run would lose",
            source=target,
            where=f"layer {name}",
            remedy="Copy that layer under another name and take the field out, or choose another name for the new result.",
        )
    attached = _definitions(connection, "main", name)
    connection.execute(f"DROP TABLE IF EXISTS main.{table}")
    (definition,) = connection.execute("SELECT sql FROM finished.sqlite_master WHERE type = 'table' AND name = ?", (name,)).fetchone()
    connection.execute(definition)
    connection.execute(f"INSERT INTO main.{table} SELECT * FROM finished.{table}")  # noqa: S608  # nosec B608 - a name of LAYERS
    for registry in ("gpkg_contents", "gpkg_geometry_columns"):
        connection.execute(f"DELETE FROM main.{registry} WHERE table_name = ?", (name,))  # noqa: S608  # nosec B608 - constants
        connection.execute(
            f"INSERT INTO main.{registry} SELECT * FROM finished.{registry} WHERE table_name = ?",  # noqa: S608  # nosec B608 - constants
            (name,),
        )
    _fill_spatial_index(connection, name)
    for kept in (attached | _definitions(connection, "finished", name)).values():
        connection.execute(kept)


def _definitions(connection: sqlite3.Connection, database: str, name: str) -> dict[str, str]:
    """Statements that make the indices and triggers of a table, by their names."""
    rows = connection.execute(
        f"SELECT name, sql FROM {database}.sqlite_master WHERE tbl_name = ? AND type IN ('index', 'trigger') AND sql IS NOT NULL",  # noqa: S608  # nosec B608 - constants
        (name,),
    )
    return {str(row[0]): str(row[1]) for row in rows}


def _fill_spatial_index(connection: sqlite3.Connection, name: str) -> None:
    """Fill anew the spatial index and the count of features that QGIS keeps of a layer."""
    index = quoted(f"rtree_{name}_geom")
    present = {str(row[0]) for row in connection.execute("SELECT name FROM main.sqlite_master WHERE type = 'table'")}
    if f"rtree_{name}_geom" in present:
        connection.execute(f"DELETE FROM main.{index}")  # noqa: S608  # nosec B608 - a name of LAYERS
        connection.execute(
            f"INSERT INTO main.{index} SELECT fid, ST_MinX(geom), ST_MaxX(geom), ST_MinY(geom), ST_MaxY(geom) "  # noqa: S608  # nosec B608
            f"FROM main.{quoted(name)} WHERE geom IS NOT NULL AND NOT ST_IsEmpty(geom)"
        )
    if "gpkg_ogr_contents" in present:
        connection.execute(
            f"UPDATE main.gpkg_ogr_contents SET feature_count = (SELECT count(*) FROM main.{quoted(name)}) WHERE table_name = ?",  # noqa: S608  # nosec B608
            (name,),
        )


def _complete_other_layers(connection: sqlite3.Connection, computed: Collection[str]) -> None:
    """Give layers that stay the fields that a later version added to them, or make them where an earlier version had none."""
    for name in LAYERS.keys() - set(computed):
        columns = {str(row[1]) for row in connection.execute(f"PRAGMA main.table_info({quoted(name)})")}
        if not columns:
            _exchange_layer(connection, name, Path())
            continue
        for row in connection.execute(f"PRAGMA finished.table_info({quoted(name)})").fetchall():
            if row[1] not in columns:
                connection.execute(f"ALTER TABLE main.{quoted(name)} ADD COLUMN {quoted(row[1])} {row[2]}")


def style_mark(qml: str) -> str:
    """Description of a shipped style."""
    return STYLE_MARK + hashlib.sha256(qml.encode()).hexdigest()[:16]


def _exchange_styles(connection: sqlite3.Connection) -> None:
    """Exchange shipped styles; what a user changed or added stays, and stays the default where it was."""
    if connection.execute("SELECT 1 FROM main.sqlite_master WHERE name = 'layer_styles'").fetchone() is None:
        for (definition,) in connection.execute("SELECT sql FROM finished.sqlite_master WHERE name = 'layer_styles'").fetchall():
            connection.execute(definition)
    for row in connection.execute(
        "SELECT id, styleQML, description FROM main.layer_styles WHERE f_table_name = styleName AND ifnull(owner, '') = ''"
    ).fetchall():
        description = str(row["description"] or "")
        if not description or description == style_mark(str(row["styleQML"])):
            connection.execute("DELETE FROM main.layer_styles WHERE id = ?", (row["id"],))
    connection.execute(
        "INSERT INTO main.layer_styles (f_table_catalog, f_table_schema, f_table_name, f_geometry_column, styleName, styleQML, styleSLD, "
        "useAsDefault, description, owner) SELECT f_table_catalog, f_table_schema, f_table_name, f_geometry_column, styleName, styleQML, "
        "styleSLD, NOT EXISTS (SELECT 1 FROM main.layer_styles AS kept WHERE kept.f_table_name = new.f_table_name AND kept.useAsDefault), "
        "description, owner FROM finished.layer_styles AS new WHERE NOT EXISTS "
        "(SELECT 1 FROM main.layer_styles AS kept WHERE kept.f_table_name = new.f_table_name AND kept.styleName = new.styleName)"
    )


def add_wkt2(connection: sqlite3.Connection) -> None:
    """Give the reference systems of a GeoPackage the field for WKT of the second version, where they lack it (extension CRS WKT)."""
    if WKT2_COLUMN in _columns(connection, "main", "gpkg_spatial_ref_sys"):
        return
    connection.execute(f"ALTER TABLE main.gpkg_spatial_ref_sys ADD COLUMN {WKT2_COLUMN} TEXT NOT NULL DEFAULT 'undefined'")
    connection.execute(
        "CREATE TABLE IF NOT EXISTS main.gpkg_extensions (table_name TEXT, column_name TEXT, extension_name TEXT NOT NULL, "
        "definition TEXT NOT NULL, scope TEXT NOT NULL, CONSTRAINT ge_tce UNIQUE (table_name, column_name, extension_name))"
    )
    connection.execute(
        "INSERT OR IGNORE INTO main.gpkg_extensions VALUES ('gpkg_spatial_ref_sys', ?, 'gpkg_crs_wkt', "
        "'http://www.geopackage.org/spec130/#extension_crs_wkt', 'read-write')",
        (WKT2_COLUMN,),
    )


def _add_reference_systems(connection: sqlite3.Connection) -> None:
    """Add those of the finished file that are not there yet; one of the two files may lack the field for WKT of the second version."""
    names = _columns(connection, "finished", "gpkg_spatial_ref_sys")
    if WKT2_COLUMN in names:
        add_wkt2(connection)
    fields = [name for name in names if name in _columns(connection, "main", "gpkg_spatial_ref_sys")]
    values = list(fields)
    if WKT2_COLUMN in _columns(connection, "main", "gpkg_spatial_ref_sys") and WKT2_COLUMN not in names:
        fields, values = [*fields, WKT2_COLUMN], [*values, "'undefined'"]
    connection.execute(
        f"INSERT OR IGNORE INTO main.gpkg_spatial_ref_sys ({', '.join(fields)}) "  # noqa: S608  # nosec B608 - names of the standard
        f"SELECT {', '.join(values)} FROM finished.gpkg_spatial_ref_sys"
    )


def _columns(connection: sqlite3.Connection, database: str, table: str) -> list[str]:
    return [str(row[1]) for row in connection.execute(f"PRAGMA {database}.table_info({quoted(table)})")]


def _free_name(target: Path) -> Path:
    """A name beside the target that no file has."""
    number = 1
    while True:
        name = f"{target.stem}.new{'' if number == 1 else number}{target.suffix}"
        if not target.with_name(name).exists():
            return target.with_name(name)
        number += 1


def quoted(identifier: str) -> str:
    """An SQL identifier in quotes."""
    return '"' + identifier.replace('"', '""') + '"'
