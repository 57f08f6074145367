"""Corrections by hand to a finished result: delete, merge, split, a new pose, picks beside the fit, a placeholder for a unit not found.

Every correction is one transaction on the result file and one row in ``unit_edits`` with the rows it replaced, so that it stays
visible who changed what, and can be taken back, by the one who made it. Nothing is taken out of ``unit_edits``: taking back appends a
row of kind ``undo`` and marks the one it takes back. Decisions that rested on the numbers a correction changes lapse with it.
"""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..model.outline import rotation_of_quaternion
from ..results.geopackage_reader import Row, add_spatial_functions, encode_point, now_utc, query, srs_of, table_names
from ..results.result_access import reading
from ..results.schema import FEATURES, LAYERS
from .bodies import redraw_bodies
from .decisions import settle, writing
from .pose_consequences import NewPose, carry_displacements, connect_epochs, drop_velocities, write_features, write_pose
from .pose_from_picks import nearest_labels
from .unit_records import DELETE_ROW, RENAME_ROW, columns_of, delete_rows, insert_row, place_of, raw_row, rows_of_unit

UNDO, PICK = "undo", "pick"
"""Kinds of rows of ``unit_edits``: one that takes another back, and points picked by hand beside the fit, which change no number."""
CREATE_EDITS = (
    "CREATE TABLE IF NOT EXISTS unit_edits (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom BLOB, kind TEXT, unit_id TEXT, "
    "epoch TEXT, comment TEXT, editor TEXT, edited_at DATETIME, before TEXT, undone BOOLEAN DEFAULT 0, undoes INTEGER)"
)
CREATE_PICKS = (
    "CREATE TABLE IF NOT EXISTS manual_picks (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom BLOB, unit_id TEXT, epoch TEXT, "
    "feature TEXT, picked_by TEXT, picked_at DATETIME)"
)
SELECT_PICK = "SELECT fid FROM manual_picks WHERE unit_id = ? AND epoch = ? AND feature = ? AND picked_by = ?"


@dataclass(frozen=True, kw_only=True)
class UnitEdit:
    """One correction: ``kind`` is delete, merge, split, pose, pick or placeholder."""

    number: int
    kind: str
    unit_id: str
    epoch: str
    comment: str
    editor: str
    edited_at: str
    undone: bool
    undone_by: str = ""


def read_edits(path: Path) -> list[UnitEdit]:
    """All corrections, oldest first, with who took them back."""
    if "unit_edits" not in table_names(path):
        return []
    with reading(path) as connection:
        rows = query(connection, "SELECT * FROM unit_edits ORDER BY fid")
    taken_back = {row["undoes"]: row["editor"] for row in rows if row.get("undoes") is not None}
    return [
        UnitEdit(
            number=row["fid"],
            kind=row["kind"],
            unit_id=row["unit_id"],
            epoch=row["epoch"] or "",
            comment=row["comment"] or "",
            editor=row["editor"],
            edited_at=row["edited_at"],
            undone=bool(row["undone"]),
            undone_by=taken_back.get(row["fid"], ""),
        )
        for row in rows
        if row["kind"] != UNDO
    ]


def last_edit_of(path: Path, editor: str) -> UnitEdit | None:
    """The last correction of one person that stands."""
    mine = (edit for edit in reversed(read_edits(path)) if not edit.undone and edit.editor.casefold() == editor.strip().casefold())
    return next(mine, None)


def contents_stamp(path: Path) -> tuple[int, int, tuple[tuple[str, str], ...]]:
    """Last rows of corrections and picks, and when each layer was written: a cheap look whether anything but decisions changed."""
    tables = table_names(path)
    statements = {
        "unit_edits": "SELECT coalesce(max(fid), 0) FROM unit_edits",
        "manual_picks": "SELECT coalesce(max(fid), 0) FROM manual_picks",
    }
    with reading(path) as connection:
        edits, picks = (int(connection.execute(sql).fetchone()[0]) if name in tables else 0 for name, sql in statements.items())
        written = connection.execute("SELECT table_name, last_change FROM gpkg_contents ORDER BY table_name").fetchall()
    computed = LAYERS.keys() - {"reviews"}
    return edits, picks, tuple((str(name), str(moment)) for name, moment in written if name in computed)


def read_picks(path: Path, unit_id: str) -> list[Row]:
    """Points of a unit picked by hand, rows of ``manual_picks``."""
    if "manual_picks" not in table_names(path):
        return []
    with reading(path) as connection:
        return query(connection, "SELECT * FROM manual_picks WHERE unit_id = ? ORDER BY fid", (unit_id,))


def store_picks(path: Path, unit_id: str, epoch: str, picks: Mapping[str, ArrayLike], *, editor: str) -> None:
    """Keep hand-picked feature points beside the fit; a feature picked again replaces the same person's older pick until it is taken back.

    Parameters
    ----------
    picks
        Feature name to (3,) coordinates in the control frame.

    Raises
    ------
    InputError
        A feature does not exist.
    OutputError
        The file cannot be written.
    """
    if not picks:
        return
    with writing(path) as connection:
        _prepare(connection)
        place = np.mean([np.asarray(point, dtype=np.float64) for point in picks.values()], axis=0)
        before = _keep_picks(connection, unit_id, epoch, picks, editor)
        _log(connection, PICK, unit_id, epoch, place, "", editor, {"picked": before})


def add_placeholder(path: Path, epoch: str, place: ArrayLike, *, editor: str, comment: str = "") -> str:
    """Mark a unit that is there but was not found, so that completeness can be stated; its name."""
    with writing(path) as connection:
        _prepare(connection)
        used = {str(row["unit_id"]) for row in connection.execute("SELECT unit_id FROM unit_edits WHERE kind = 'placeholder'")}
        number = next(k for k in range(1, len(used) + 2) if f"P{k:03d}" not in used)
        _log(connection, "placeholder", f"P{number:03d}", epoch, np.asarray(place, dtype=np.float64), comment, editor, {})
        return f"P{number:03d}"


def placeholders(path: Path, epoch: str) -> list[tuple[str, FloatArray]]:
    """Name and place of the standing placeholders of an epoch."""
    if "unit_edits" not in table_names(path):
        return []
    with reading(path) as connection:
        rows = query(connection, "SELECT * FROM unit_edits WHERE kind = 'placeholder' AND epoch = ? AND NOT undone ORDER BY fid", (epoch,))
    return [(row["unit_id"], row["geom"]) for row in rows]


def delete_unit(path: Path, unit_id: str, *, editor: str, comment: str = "") -> None:
    """Take a false unit out of the result, in all epochs.

    Raises
    ------
    InputError
        There is no such unit.
    """
    with writing(path) as connection:
        _prepare(connection)
        before = rows_of_unit(connection, unit_id)
        place = place_of(before)
        delete_rows(connection, before)
        _log(connection, "delete", unit_id, "", place, comment, editor, {"deleted": before})


def merge_units(path: Path, keep: str, other: str, *, editor: str, comment: str = "") -> None:
    """Make one unit of two names that are the same physical unit in different epochs; displacements between them follow.

    Raises
    ------
    InputError
        A unit does not exist, or both were found in the same epoch.
    """
    with writing(path) as connection:
        _prepare(connection)
        kept, gone = rows_of_unit(connection, keep), rows_of_unit(connection, other)
        found = [{row["epoch"] for row in rows["units"] if row["geom"] is not None} for rows in (kept, gone)]
        both = sorted(found[0] & found[1])
        if both:
            raise InputError(f"both were found in {both[0]}", where=f"units {keep} and {other}", remedy="Delete the wrong one instead.")
        place = place_of(gone)
        # where one of them was found, the other's "lost", "unseen" or "new" no longer holds
        absent = {row["epoch"] for row in kept["units"]}
        stale = {"units": [row for row in kept["units"] if row["geom"] is None and row["epoch"] in found[1]]}
        stale["units"] += [row for row in gone["units"] if row["geom"] is None and row["epoch"] in absent]
        # so does a place where it was looked for, of which one is enough where both are missing
        gaps = kept.get("gaps", [])
        stale["gaps"] = [row for row in gaps if row["epoch"] in found[1]]
        stale["gaps"] += [row for row in gone.get("gaps", []) if row["epoch"] in found[0] | {row["epoch"] for row in gaps}]
        picks = {"unit": other, "rows": [row["fid"] for row in gone.get("manual_picks", [])], "last": _last_pick(connection)}
        picks["epochs"] = sorted(found[1])
        for layer, rows in gone.items():
            connection.executemany(RENAME_ROW[layer], [(keep, row["fid"]) for row in rows])
        delete_rows(connection, stale)
        connection.execute(
            "UPDATE units SET status = 'found' WHERE unit_id = ? AND status IN ('new', 'relocated') AND geom IS NOT NULL", (keep,)
        )
        added = connect_epochs(connection, keep, found[0], found[1])
        drop_velocities(connection, kept, gone)
        _log(
            connection,
            "merge",
            keep,
            "",
            place,
            comment,
            editor,
            {"deleted": stale, "renamed": _computed(gone), "changed": _computed(kept), "added": added, "picks": picks},
        )


def split_unit(path: Path, unit_id: str, epoch: str, *, editor: str, comment: str = "") -> str:
    """From an epoch on, give a unit a new name: two physical units had been taken for one; the new name.

    Raises
    ------
    InputError
        The unit was not found both before and from that epoch on.
    """
    with writing(path) as connection:
        _prepare(connection)
        before = rows_of_unit(connection, unit_id)
        place = place_of(before)
        times = {row["epoch"]: row["epoch_time"] or "" for row in before["units"]}
        later = {label for label in times if times[label] >= times.get(epoch, "\uffff")}
        found = {row["epoch"] for row in before["units"] if row["geom"] is not None}
        if not (found & later and found - later):
            raise InputError(
                f"was not found both before and from {epoch} on", where=f"unit {unit_id}", remedy="Choose the epoch it changes at."
            )
        taken = {str(row["unit_id"]) for row in connection.execute("SELECT DISTINCT unit_id FROM units")}
        name = next(f"{unit_id}{letter}" for letter in "bcdefghijklmnopqrstuvwxyz" if f"{unit_id}{letter}" not in taken)
        for layer, rows in before.items():
            across = [row for row in rows if "epoch_from" in row and (row["epoch_from"] in later) != (row["epoch_to"] in later)]
            delete_rows(connection, {layer: across})
            inside = [row for row in rows if all(row[key] in later for key in ("epoch", "epoch_from", "epoch_to") if key in row)]
            connection.executemany(RENAME_ROW[layer], [(name, row["fid"]) for row in inside])
        first = min(found & later, key=lambda label: times[label])
        connection.execute("UPDATE units SET status = 'new' WHERE unit_id = ? AND epoch = ?", (name, first))
        drop_velocities(connection, before)
        _log(connection, "split", unit_id, epoch, place, comment, editor, {"changed": _computed(before), "name": name})
        return name


def set_pose(
    path: Path, unit_id: str, epoch: str, pose: NewPose, *, editor: str, comment: str = "", picks: Mapping[str, ArrayLike] | None = None
) -> None:
    """Replace the pose of a unit in one epoch and bring its feature points and displacements along.

    The legs are numbered as before (the rotation of the tetrapod onto itself that turns it least). Displacements change by the
    change of the feature points, and their variances grow by what the new fit is worse than the old. Statistic and
    p-value then follow from the standard deviations (chi-square with three degrees of freedom).

    Parameters
    ----------
    picks
        Points that the pose was made of, as of :func:`store_picks`; they stand and fall with it.

    Raises
    ------
    InputError
        The unit has no row in that epoch, or there is no such feature.
    """
    with writing(path) as connection:
        _prepare(connection)
        before = rows_of_unit(connection, unit_id)
        place = place_of(before)
        old = next((row for row in before["units"] if row["epoch"] == epoch), None)
        if old is None:
            raise InputError(f"is not in epoch {epoch}", where=f"unit {unit_id}", remedy="Choose an epoch of the result.")
        rotation = pose.rotation
        reference = next((row for row in [old, *before["units"]] if row["qw"] is not None), None)
        if reference is not None:
            rotation = nearest_labels(rotation_of_quaternion([reference[name] for name in ("qx", "qy", "qz", "qw")]), rotation)
        found = {row["epoch"] for row in before["units"] if row["geom"] is not None}
        write_pose(connection, old, pose, rotation)
        write_features(connection, before["feature_points"], old, pose, rotation)
        added: dict[str, list[int]] = {}
        if epoch in found:
            carry_displacements(connection, before, epoch, old, pose)
        else:
            added = connect_epochs(connection, unit_id, found, {epoch})
        drop_velocities(connection, before)
        # it is not missing there any more, and what was compared with its displacements was compared with others
        stale = {"gaps": [row for row in before.get("gaps", []) if row["epoch"] == epoch]}
        stale["cross_checks"] = [row for row in before.get("cross_checks", []) if epoch in (row["epoch_from"], row["epoch_to"])]
        delete_rows(connection, stale)
        replaced: dict[str, Any] = {"changed": _computed(before), "added": added}
        if picks:
            replaced["picked"] = _keep_picks(connection, unit_id, epoch, picks, editor)
        _log(connection, "pose", unit_id, epoch, place, comment, editor, replaced)


def undo_edit(path: Path, number: int, *, editor: str) -> UnitEdit:
    """Take back a correction of one's own: the rows it replaced come back as they were.

    Raises
    ------
    InputError
        There is no such correction, it is somebody else's or taken back already, or a later one on the same unit stands.
    """
    with writing(path) as connection:
        _prepare(connection)
        rows = query(connection, "SELECT * FROM unit_edits WHERE fid = ?", (number,))
        if not rows or rows[0]["undone"] or rows[0]["kind"] == UNDO:
            raise InputError(f"correction {number} does not stand", remedy="Choose one that is not taken back yet.")
        row = rows[0]
        if row["editor"].casefold() != editor.strip().casefold():
            raise InputError(f"correction {number} is {row['editor']}'s", remedy="Only your own corrections can be taken back.")
        touched = _touched(row)
        later = query(connection, "SELECT * FROM unit_edits WHERE fid > ? AND NOT undone AND kind <> ?", (number, UNDO))
        before: dict[str, Any] = json.loads(row["before"] or "{}")
        # points picked since change no row that is brought back, but one's own may have replaced those taken back
        counted = [e for e in later if e["kind"] != PICK or ("picked" in before and e["editor"].casefold() == row["editor"].casefold())]
        blocking = next((e for e in counted if touched & _touched(e)), None)
        if blocking is not None:
            raise InputError(
                f"unit {blocking['unit_id']} was corrected again later, by {blocking['editor']}",
                remedy="The later correction has to be taken back first.",
            )
        for layer, fids in before.get("added", {}).items():
            connection.executemany(DELETE_ROW[layer], [(fid,) for fid in fids])
        for part in ("deleted", "renamed", "changed"):
            for layer, replaced in before.get(part, {}).items():
                for old in replaced:
                    connection.execute(DELETE_ROW[layer], (old["fid"],))
                    insert_row(connection, layer, {name: bytes.fromhex(v) if name == "geom" and v else v for name, v in old.items()})
        _return_picks(connection, str(row["unit_id"]), before)
        if "picked" in before:
            _unpick(connection, before["picked"])
        redraw_bodies(connection, touched)
        connection.execute("UPDATE unit_edits SET undone = 1 WHERE fid = ?", (number,))
        _log(connection, UNDO, row["unit_id"], row["epoch"] or "", row["geom"], "", editor, {}, undoes=number)
        return UnitEdit(
            number=number,
            kind=row["kind"],
            unit_id=row["unit_id"],
            epoch=row["epoch"] or "",
            comment=row["comment"] or "",
            editor=editor,
            edited_at=now_utc(),
            undone=True,
            undone_by=editor,
        )


def _keep_picks(connection: sqlite3.Connection, unit_id: str, epoch: str, picks: Mapping[str, ArrayLike], editor: str) -> dict[str, Any]:
    """Store points picked by hand; the rows made and those they replace, for :func:`_unpick`."""
    unknown = sorted(set(picks) - set(FEATURES))
    if unknown:
        raise InputError(f"there is no feature {unknown[0]}", where=f"unit {unit_id}", remedy=f"Use one of {', '.join(FEATURES)}.")
    connection.execute(CREATE_PICKS)
    _register_layer(connection, "manual_picks", "Feature points picked by hand, beside the fit", "POINT")
    srs, made, replaced = srs_of(connection), [], []
    for feature, place in picks.items():
        key = (unit_id, epoch, feature, editor)
        older = [int(row["fid"]) for row in connection.execute(SELECT_PICK, key)]
        for row in (raw_row(connection, "manual_picks", fid) for fid in older):
            replaced.append({**row, "raw_geom": row["geom"]})
        connection.executemany(DELETE_ROW["manual_picks"], [(fid,) for fid in older])
        cursor = connection.execute(
            "INSERT INTO manual_picks (geom, unit_id, epoch, feature, picked_by, picked_at) VALUES (?, ?, ?, ?, ?, ?)",
            (encode_point(srs, np.asarray(place, dtype=np.float64)), *key, now_utc()),
        )
        made.append(cursor.lastrowid)
    return {"made": made, "replaced": replaced}


def _unpick(connection: sqlite3.Connection, picked: dict[str, Any]) -> None:
    """Take points picked by hand back, and bring those back that they replaced, under the name that their unit has by now."""
    owners = connection.execute("SELECT unit_id FROM manual_picks WHERE fid = ?", (picked["made"][0],)).fetchone()
    connection.executemany(DELETE_ROW["manual_picks"], [(fid,) for fid in picked["made"]])
    for old in picked["replaced"]:
        name = old["unit_id"] if owners is None else str(owners["unit_id"])
        insert_row(connection, "manual_picks", {**old, "unit_id": name, "geom": bytes.fromhex(old["geom"])})


def _last_pick(connection: sqlite3.Connection) -> int:
    """Number of the last point picked by hand; 0 where there is none."""
    if not columns_of(connection, "manual_picks"):
        return 0
    return int(connection.execute("SELECT coalesce(max(fid), 0) FROM manual_picks").fetchone()[0])


def _return_picks(connection: sqlite3.Connection, unit_id: str, before: dict[str, Any]) -> None:
    """Give points picked by hand the name they have without a split or a merge of ``unit_id`` that is taken back."""
    if not columns_of(connection, "manual_picks"):
        return
    if "name" in before:
        # those made since the split, too: the name is gone
        connection.execute("UPDATE manual_picks SET unit_id = ? WHERE unit_id = ?", (unit_id, before["name"]))
    picks = before.get("picks")
    if picks:
        # of the other unit's those that nobody picked anew, and those made since the merge where it was found
        connection.executemany(RENAME_ROW["manual_picks"], [(picks["unit"], fid) for fid in picks["rows"]])
        since = "UPDATE manual_picks SET unit_id = ? WHERE unit_id = ? AND epoch = ? AND fid > ?"
        connection.executemany(since, [(picks["unit"], unit_id, epoch, picks["last"]) for epoch in picks["epochs"]])


def _computed(rows: dict[str, list[Row]]) -> dict[str, list[Row]]:
    """Rows without those picked by hand: a correction that leaves them alone must not bring back what was picked anew since."""
    return {layer: found for layer, found in rows.items() if layer != "manual_picks"}


def _touched(edit: Row) -> set[str]:
    """Names of all units whose rows a correction changed."""
    before: dict[str, Any] = json.loads(edit["before"] or "{}")
    return {str(edit["unit_id"]), str(before.get("name", edit["unit_id"])), *_units_of(before)}


def _prepare(connection: sqlite3.Connection) -> None:
    add_spatial_functions(connection)
    connection.execute(CREATE_EDITS)
    if "undoes" not in columns_of(connection, "unit_edits"):
        connection.execute("ALTER TABLE unit_edits ADD COLUMN undoes INTEGER")
    _register_layer(connection, "unit_edits", "Corrections by hand, and placeholders for units that were not found", "POINT")


def _register_layer(connection: sqlite3.Connection, table: str, description: str, kind: str) -> None:
    srs = srs_of(connection)
    connection.execute(
        "INSERT OR IGNORE INTO gpkg_contents (table_name, data_type, identifier, description, last_change, srs_id) "
        "VALUES (?, 'features', ?, ?, ?, ?)",
        (table, table, description, now_utc(), srs),
    )
    connection.execute(
        "INSERT OR IGNORE INTO gpkg_geometry_columns (table_name, column_name, geometry_type_name, srs_id, z, m) "
        "VALUES (?, 'geom', ?, ?, 1, 0)",
        (table, kind, srs),
    )


def _log(
    connection: sqlite3.Connection,
    kind: str,
    unit_id: str,
    epoch: str,
    place: FloatArray | None,
    comment: str,
    editor: str,
    before: dict[str, Any],
    *,
    undoes: int | None = None,
) -> None:
    if not editor.strip():
        raise InputError("the editor has no name", remedy="Enter your name or initials; it stands beside every correction.")
    point = None if place is None else encode_point(srs_of(connection), place)
    connection.execute(
        "INSERT INTO unit_edits (geom, kind, unit_id, epoch, comment, editor, edited_at, before, undone, undoes) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, 0, ?)",
        (point, kind, unit_id, epoch, comment, editor.strip(), now_utc(), json.dumps(_plain(before)), undoes),
    )
    settle(connection, editor.strip())
    redraw_bodies(connection, {unit_id, str(before.get("name", unit_id)), *_units_of(before)})
    connection.execute("UPDATE gpkg_contents SET last_change = ? WHERE table_name <> 'epochs'", (now_utc(),))


def _units_of(before: dict[str, Any]) -> set[str]:
    """Units whose rows a correction replaced."""
    parts = [before[part] for part in ("deleted", "renamed", "changed") if part in before]
    return {str(row["unit_id"]) for layers in parts for rows in layers.values() for row in rows}


def _plain(value: Any) -> Any:
    """JSON form of replaced rows: geometry as hexadecimal GeoPackage binary."""
    if isinstance(value, dict):
        if "raw_geom" in value:
            raw = value["raw_geom"]
            return {**{k: v for k, v in value.items() if k not in ("geom", "raw_geom")}, "geom": raw.hex() if raw else None}
        return {k: _plain(v) for k, v in value.items()}
    if isinstance(value, list):
        return [_plain(v) for v in value]
    return value
