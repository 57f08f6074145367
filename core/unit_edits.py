"""Corrections by hand to a finished result: delete, merge, split, a new pose, picks beside the fit, a placeholder for a unit not found.

Every correction is one transaction on the result file and one row in ``unit_edits`` with the rows it replaced, so that it stays
visible who changed what, and can be taken back.
"""

from __future__ import annotations

import json
import math
import sqlite3
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import permutations
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import InputError
from .outline import VOLUME_RATIO, rotation_of_quaternion
from .result_tables import Row, connect, decode_geometry, encode_line, encode_point, now_utc, query, srs_of, table_names
from .reviews import writing
from .schema import FEATURES
from .unit_types import leg_directions

FloatArray = NDArray[np.float64]

CREATE_EDITS = (
    "CREATE TABLE IF NOT EXISTS unit_edits (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom BLOB, kind TEXT, unit_id TEXT, "
    "epoch TEXT, comment TEXT, editor TEXT, edited_at DATETIME, before TEXT, undone BOOLEAN DEFAULT 0)"
)
CREATE_PICKS = (
    "CREATE TABLE IF NOT EXISTS manual_picks (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom BLOB, unit_id TEXT, epoch TEXT, "
    "feature TEXT, picked_by TEXT, picked_at DATETIME)"
)
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
CRITICAL_P = {
    "displacements": "SELECT max(p_value) FROM displacements WHERE significant AND epoch_from = ? AND epoch_to = ? AND datum = ?",
    "displacements_other": (
        "SELECT max(p_value) FROM displacements_other WHERE significant AND epoch_from = ? AND epoch_to = ? AND datum = ?"
    ),
}


@dataclass(frozen=True)
class UnitEdit:
    """One correction: ``kind`` is delete, merge, split, pose or placeholder."""

    number: int
    kind: str
    unit_id: str
    epoch: str
    comment: str
    editor: str
    edited_at: str
    undone: bool


@dataclass(frozen=True, eq=False)
class NewPose:
    """A pose found by a new fit or pinned by picks.

    Attributes
    ----------
    centre, rotation
        (3,) metres in the control frame, (3, 3) body to CRS axes.
    radius, gradient, height
        Shape of the unit.
    sd
        (3,) standard deviations of the centre, metres.
    sd_rotation_deg
        Standard deviation of the rotation, degrees.
    sigma0, n_points, legs_visible, coverage, score
        As in ``units``; None where a pinned pose has none.
    """

    centre: FloatArray
    rotation: FloatArray
    radius: float
    gradient: float
    height: float
    sd: FloatArray
    sd_rotation_deg: float
    sigma0: float | None = None
    n_points: int | None = None
    legs_visible: int | None = None
    coverage: float | None = None
    score: float | None = None


def read_edits(path: Path) -> list[UnitEdit]:
    """All corrections, oldest first."""
    if "unit_edits" not in table_names(path):
        return []
    connection = connect(path)
    try:
        rows = query(connection, "SELECT * FROM unit_edits ORDER BY fid")
    finally:
        connection.close()
    return [
        UnitEdit(
            row["fid"],
            row["kind"],
            row["unit_id"],
            row["epoch"] or "",
            row["comment"] or "",
            row["editor"],
            row["edited_at"],
            bool(row["undone"]),
        )
        for row in rows
    ]


def read_picks(path: Path, unit_id: str) -> list[Row]:
    """Points of a unit picked by hand, rows of ``manual_picks``."""
    if "manual_picks" not in table_names(path):
        return []
    connection = connect(path)
    try:
        return query(connection, "SELECT * FROM manual_picks WHERE unit_id = ? ORDER BY fid", (unit_id,))
    finally:
        connection.close()


def store_picks(path: Path, unit_id: str, epoch: str, picks: dict[str, ArrayLike], *, editor: str) -> None:
    """Keep hand-picked feature points beside the fit; a feature picked again replaces the same person's older pick.

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
    unknown = sorted(set(picks) - set(FEATURES))
    if unknown:
        raise InputError(f"there is no feature {unknown[0]}", where=f"unit {unit_id}", remedy=f"Use one of {', '.join(FEATURES)}.")
    with writing(path) as connection:
        connection.execute(CREATE_PICKS)
        _register_layer(connection, "manual_picks", "Feature points picked by hand, beside the fit", "POINT")
        srs = srs_of(connection)
        for feature, place in picks.items():
            key = (unit_id, epoch, feature, editor)
            connection.execute("DELETE FROM manual_picks WHERE unit_id = ? AND epoch = ? AND feature = ? AND picked_by = ?", key)
            connection.execute(
                "INSERT INTO manual_picks (geom, unit_id, epoch, feature, picked_by, picked_at) VALUES (?, ?, ?, ?, ?, ?)",
                (encode_point(srs, np.asarray(place, dtype=np.float64)), *key, now_utc()),
            )


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
    connection = connect(path)
    try:
        rows = query(connection, "SELECT * FROM unit_edits WHERE kind = 'placeholder' AND epoch = ? AND NOT undone ORDER BY fid", (epoch,))
    finally:
        connection.close()
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
        before = _rows_of(connection, unit_id)
        place = _place(before, unit_id)
        for layer, rows in before.items():
            connection.executemany(DELETE_ROW[layer], [(row["fid"],) for row in rows])
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
        kept, gone = _rows_of(connection, keep), _rows_of(connection, other)
        found = [{row["epoch"] for row in rows["units"] if row["geom"] is not None} for rows in (kept, gone)]
        both = sorted(found[0] & found[1])
        if both:
            raise InputError(f"both were found in {both[0]}", where=f"units {keep} and {other}", remedy="Delete the wrong one instead.")
        place = _place(gone, other)
        # where one of them was found, the other's "lost", "unseen" or "new" no longer holds
        absent = {row["epoch"] for row in kept["units"]}
        stale = [row for row in kept["units"] if row["geom"] is None and row["epoch"] in found[1]]
        stale += [row for row in gone["units"] if row["geom"] is None and row["epoch"] in absent]
        stale_fids = {row["fid"] for row in stale}
        connection.executemany(DELETE_ROW["units"], [(fid,) for fid in stale_fids])
        for layer, statement in RENAME_ROW.items():
            names = [(keep, row["fid"]) for row in gone.get(layer, []) if layer != "units" or row["fid"] not in stale_fids]
            connection.executemany(statement, names)
        connection.execute(
            "UPDATE units SET status = 'found' WHERE unit_id = ? AND status IN ('new', 'relocated') AND geom IS NOT NULL", (keep,)
        )
        added = _connect_epochs(connection, keep, found[0], found[1])
        _drop_velocities(connection, kept, gone)
        _log(
            connection,
            "merge",
            keep,
            "",
            place,
            comment,
            editor,
            {"deleted": {"units": stale}, "renamed": gone, "changed": kept, "added": added},
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
        before = _rows_of(connection, unit_id)
        place = _place(before, unit_id)
        times = {row["epoch"]: row["epoch_time"] or "" for row in before["units"]}
        later = {label for label in times if times[label] >= times.get(epoch, "\uffff")}
        found = {row["epoch"] for row in before["units"] if row["geom"] is not None}
        if not (found & later and found - later):
            raise InputError(
                f"was not found both before and from {epoch} on", where=f"unit {unit_id}", remedy="Choose the epoch it changes at."
            )
        taken = {str(row["unit_id"]) for row in connection.execute("SELECT DISTINCT unit_id FROM units")}
        name = next(f"{unit_id}{letter}" for letter in "bcdefghijklmnopqrstuvwxyz" if f"{unit_id}{letter}" not in taken)
        for layer in ("units", "feature_points", "check_residuals"):
            connection.executemany(RENAME_ROW[layer], [(name, row["fid"]) for row in before.get(layer, []) if row["epoch"] in later])
        for layer in ("displacements", "displacements_other"):
            across = [row for row in before.get(layer, []) if (row["epoch_from"] in later) != (row["epoch_to"] in later)]
            connection.executemany(DELETE_ROW[layer], [(row["fid"],) for row in across])
            inside = [row for row in before.get(layer, []) if row["epoch_from"] in later and row["epoch_to"] in later]
            connection.executemany(RENAME_ROW[layer], [(name, row["fid"]) for row in inside])
        first = min(found & later, key=lambda label: times[label])
        connection.execute("UPDATE units SET status = 'new' WHERE unit_id = ? AND epoch = ?", (name, first))
        _drop_velocities(connection, before)
        _log(connection, "split", unit_id, epoch, place, comment, editor, {"changed": before, "name": name})
        return name


def set_pose(path: Path, unit_id: str, epoch: str, pose: NewPose, *, editor: str, comment: str = "") -> None:
    """Replace the pose of a unit in one epoch and bring its feature points and displacements along.

    The legs are numbered as before (the rotation of the tetrapod onto itself that turns it least). Displacements change by the
    change of the feature points, and their variances grow by what the new fit is worse than the old. Statistic and
    p-value then follow from the standard deviations (chi-square with three degrees of freedom).

    Raises
    ------
    InputError
        The unit has no row in that epoch.
    """
    with writing(path) as connection:
        _prepare(connection)
        before = _rows_of(connection, unit_id)
        place = _place(before, unit_id)
        old = next((row for row in before["units"] if row["epoch"] == epoch), None)
        if old is None:
            raise InputError(f"is not in epoch {epoch}", where=f"unit {unit_id}", remedy="Choose an epoch of the result.")
        rotation = pose.rotation
        reference = next((row for row in [old, *before["units"]] if row["qw"] is not None), None)
        if reference is not None:
            rotation = nearest_labels(rotation_of_quaternion([reference[name] for name in ("qx", "qy", "qz", "qw")]), rotation)
        found = {row["epoch"] for row in before["units"] if row["geom"] is not None}
        _write_pose(connection, old, pose, rotation)
        _write_features(connection, before["feature_points"], old, pose, rotation)
        added: dict[str, list[int]] = {}
        if epoch in found:
            _carry_displacements(connection, before, epoch, old, pose)
        else:
            added = _connect_epochs(connection, unit_id, found, {epoch})
        _drop_velocities(connection, before)
        _log(connection, "pose", unit_id, epoch, place, comment, editor, {"changed": before, "added": added})


def undo_edit(path: Path, number: int, *, editor: str) -> UnitEdit:
    """Take back the last correction of a unit: the rows it replaced come back as they were.

    Raises
    ------
    InputError
        There is no such correction, it is taken back already, or a later one on the same unit stands.
    """
    with writing(path) as connection:
        _prepare(connection)
        rows = query(connection, "SELECT * FROM unit_edits WHERE fid = ?", (number,))
        if not rows or rows[0]["undone"]:
            raise InputError(f"correction {number} does not stand", remedy="Choose one that is not taken back yet.")
        row = rows[0]
        later = connection.execute(
            "SELECT 1 FROM unit_edits WHERE fid > ? AND unit_id = ? AND NOT undone", (number, row["unit_id"])
        ).fetchone()
        if later:
            raise InputError(f"unit {row['unit_id']} was corrected again later", remedy="Take back the later correction first.")
        before: dict[str, Any] = json.loads(row["before"] or "{}")
        for layer, fids in before.get("added", {}).items():
            connection.executemany(DELETE_ROW[layer], [(fid,) for fid in fids])
        for part in ("deleted", "renamed", "changed"):
            for layer, replaced in before.get(part, {}).items():
                for old in replaced:
                    connection.execute(DELETE_ROW[layer], (old["fid"],))
                    _insert(connection, layer, {name: bytes.fromhex(v) if name == "geom" and v else v for name, v in old.items()})
        connection.execute("UPDATE unit_edits SET undone = 1 WHERE fid = ?", (number,))
        return UnitEdit(number, row["kind"], row["unit_id"], row["epoch"] or "", row["comment"] or "", editor, now_utc(), True)


def nearest_labels(reference: FloatArray, rotation: FloatArray) -> FloatArray:
    """(3, 3) ``rotation`` with its legs renumbered so that it turns least from ``reference`` (12 rotations of the tetrapod onto itself)."""
    candidates = rotation @ _symmetries()
    traces = np.einsum("kij,ij->k", candidates, reference)
    return np.asarray(candidates[int(np.argmax(traces))])


def pose_from_features(
    picks: ArrayLike, radius: float, gradient: float, reference: FloatArray | None = None
) -> tuple[FloatArray, FloatArray, tuple[str, ...], float]:
    """Pose that brings three (or four) feature points onto picks, whichever of the four they are.

    Parameters
    ----------
    picks
        (3, 3) or (4, 3) joints of three legs as picked, metres.
    radius, gradient
        Shape of the leg cone.
    reference
        (3, 3) earlier rotation, which settles the legs' numbers; None leaves them arbitrary.

    Returns
    -------
    centre, rotation, names, misfit
        (3,), (3, 3), the feature each pick was taken for, and the root mean square distance in metres.

    Raises
    ------
    InputError
        Fewer than three picks, or two of them nearly in the same place.
    """
    points = np.asarray(picks, dtype=np.float64).reshape(-1, 3)
    body = joints_of(radius, gradient)
    gaps = np.linalg.norm(points[:, None] - points[None], axis=2) + np.eye(len(points)) * 1e9
    if len(points) not in (3, 4) or gaps.min() < 0.3 * float(np.linalg.norm(body[0])):
        raise InputError("three different feature points are needed", remedy="Click three joints where three legs meet.")
    best: tuple[float, float, FloatArray, FloatArray, tuple[int, ...]] | None = None
    for chosen in permutations(range(4), len(points)):
        centre, rotation, misfit = _rigid(body[list(chosen)], points)
        turn = 0.0 if reference is None else -float(np.trace(reference.T @ rotation))
        key = (round(misfit, 9), turn)
        if best is None or key < best[:2]:
            best = (*key, centre, rotation, chosen)
    if best is None:
        raise InputError("no pose passes through these points", remedy="Click three joints where three legs meet.")
    return best[2], best[3], tuple(FEATURES[1 + k] for k in best[4]), best[0]


def joints_of(radius: float, gradient: float) -> FloatArray:
    """(4, 3) f123, f124, f134, f234 in the body frame (paper eqs. 10-13, closed form for the tetrahedral opening)."""
    angle = math.acos(1 / 3)
    distance = radius / (math.sin(angle) + gradient * math.cos(angle))
    return np.asarray(-distance * leg_directions("tetrahedral")[[3, 2, 1, 0]])


def chi2_3_survival(statistic: float) -> float:
    """Probability that chi-square with three degrees of freedom exceeds a value."""
    return math.erfc(math.sqrt(statistic / 2)) + math.sqrt(2 * statistic / math.pi) * math.exp(-statistic / 2)


def _symmetries() -> FloatArray:
    """(12, 3, 3) proper rotations that permute the four legs: the even permutations."""
    found, legs = [], leg_directions("tetrahedral")
    for order in permutations(range(4)):
        turn = 0.75 * legs[list(order)].T @ legs
        if np.linalg.det(turn) > 0:
            found.append(turn)
    return np.array(found)


def _rigid(body: FloatArray, points: FloatArray) -> tuple[FloatArray, FloatArray, float]:
    """Rotation and translation body -> points by least squares (Kabsch, 1976), and the root mean square misfit."""
    middle_body, middle = body.mean(axis=0), points.mean(axis=0)
    u, _, vt = np.linalg.svd((points - middle).T @ (body - middle_body))
    rotation = u @ np.diag([1, 1, np.sign(np.linalg.det(u @ vt))]) @ vt
    centre = middle - rotation @ middle_body
    misfit = float(np.sqrt(np.mean(np.sum((points - body @ rotation.T - centre) ** 2, axis=1))))
    return centre, rotation, misfit


def _quaternion(rotation: FloatArray) -> FloatArray:
    """qx, qy, qz, qw of a rotation, qw >= 0: the leading eigenvector of Bar-Itzhack's (2000) matrix."""
    r = rotation
    k = np.array(
        [
            [r[0, 0] - r[1, 1] - r[2, 2], r[1, 0] + r[0, 1], r[2, 0] + r[0, 2], r[2, 1] - r[1, 2]],
            [r[1, 0] + r[0, 1], r[1, 1] - r[0, 0] - r[2, 2], r[2, 1] + r[1, 2], r[0, 2] - r[2, 0]],
            [r[2, 0] + r[0, 2], r[2, 1] + r[1, 2], r[2, 2] - r[0, 0] - r[1, 1], r[1, 0] - r[0, 1]],
            [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], r[0, 0] + r[1, 1] + r[2, 2]],
        ]
    )
    q = np.linalg.eigh(k)[1][:, -1]
    return np.asarray(q if q[3] >= 0 else -q)


def _write_pose(connection: sqlite3.Connection, old: Row, pose: NewPose, rotation: FloatArray) -> None:
    q = _quaternion(rotation)
    values = {
        "geom": encode_point(srs_of(connection), pose.centre),
        "height": pose.height,
        "r0": pose.radius,
        "gradient": pose.gradient,
        **dict(zip(("qx", "qy", "qz", "qw"), (float(v) for v in q), strict=True)),
        **dict(zip(("sd_e", "sd_n", "sd_h"), (float(v) for v in pose.sd), strict=True)),
        "sd_rotation_deg": pose.sd_rotation_deg,
        "sigma0": pose.sigma0,
        "n_points": pose.n_points,
        "legs_visible": pose.legs_visible,
        "coverage": pose.coverage,
        "score": pose.score,
        "covariance": None,
        "status": "found" if old["status"] in ("uncertain", "lost", "unseen") else old["status"],
    }
    row = {name: values.get(name, value) for name, value in _raw(connection, "units", old["fid"]).items()}
    connection.execute(DELETE_ROW["units"], (old["fid"],))
    _insert(connection, "units", row)


def _write_features(connection: sqlite3.Connection, rows: Sequence[Row], old: Row, pose: NewPose, rotation: FloatArray) -> None:
    places = _features(pose.centre, rotation, pose.radius, pose.gradient)
    arm = math.radians(pose.sd_rotation_deg) / math.sqrt(3)
    here = {row["feature"]: row for row in rows if row["epoch"] == old["epoch"]}
    columns = [str(row["name"]) for row in connection.execute("SELECT name FROM pragma_table_info('feature_points')")]
    for feature, place in places.items():
        # rotation about three axes with equal variance: every direction across the arm gets arm length times that
        reach = float(np.linalg.norm(place - pose.centre))
        ray = (place - pose.centre) / reach if reach else np.zeros(3)
        covariance = np.diag(pose.sd**2) + (arm * reach) ** 2 * (np.eye(3) - np.outer(ray, ray)) * (reach > 0)
        row: Row = dict.fromkeys(columns)
        row |= {"unit_id": old["unit_id"], "epoch": old["epoch"], "epoch_time": old["epoch_time"], "feature": feature, "observed": 0}
        if feature in here:
            row |= _raw(connection, "feature_points", here[feature]["fid"])
            connection.execute(DELETE_ROW["feature_points"], (here[feature]["fid"],))
        sd = np.sqrt(np.diag(covariance))
        row |= {"geom": encode_point(srs_of(connection), place), "sd_e": float(sd[0]), "sd_n": float(sd[1]), "sd_h": float(sd[2])}
        row |= {"cov_en": float(covariance[0, 1]), "cov_eh": float(covariance[0, 2]), "cov_nh": float(covariance[1, 2])}
        _insert(connection, "feature_points", row)


def _carry_displacements(connection: sqlite3.Connection, before: dict[str, list[Row]], epoch: str, old: Row, pose: NewPose) -> None:
    """Move the end that lies in ``epoch`` of every displacement of the unit."""
    unit_id = old["unit_id"]
    was = {(row["feature"]): row for row in before["feature_points"] if row["epoch"] == epoch}
    now = {
        row["feature"]: row for row in query(connection, "SELECT * FROM feature_points WHERE unit_id = ? AND epoch = ?", (unit_id, epoch))
    }
    rotations = _rotations(connection, unit_id)
    for layer in ("displacements", "displacements_other"):
        for row in before.get(layer, []):
            if epoch not in (row["epoch_from"], row["epoch_to"]) or row["feature"] not in was:
                continue
            sign = 1.0 if row["epoch_to"] == epoch else -1.0
            a, b = was[row["feature"]], now[row["feature"]]
            vector = _vector(row) + sign * (b["geom"] - a["geom"])
            # only the fit's share changes; a correction by hand never makes a displacement look surer than the run did
            variance = _sd(row) ** 2 + np.maximum(_sd(b) ** 2 - _sd(a) ** 2, 0.0)
            start = row["geom"][0] if sign > 0 else row["geom"][0] + (b["geom"] - a["geom"])
            more = max(pose.sd_rotation_deg**2 - (old["sd_rotation_deg"] or 0.0) ** 2, 0.0)
            sd_rotation = math.sqrt((row["sd_rotation_deg"] or 0.0) ** 2 + more)
            critical = _critical_p(connection, layer, row)
            values = _measures(vector, np.sqrt(variance), start, srs_of(connection), row["class"], critical, pose.height)
            values |= {"rotation_deg": _turn(rotations, row["epoch_from"], row["epoch_to"]), "sd_rotation_deg": sd_rotation}
            full = _raw(connection, layer, row["fid"]) | values
            connection.execute(DELETE_ROW[layer], (row["fid"],))
            _insert(connection, layer, full)


def _connect_epochs(connection: sqlite3.Connection, unit_id: str, first: set[str], second: set[str]) -> dict[str, list[int]]:
    """Add displacements of a unit between epochs of two sets, wherever the result compares them at all; the fids added.

    What the layers do not hold, the registration's share of the variance and the datum's small shift, is taken from other units.
    """
    points = query(connection, "SELECT * FROM feature_points WHERE unit_id = ?", (unit_id,))
    places = {(row["epoch"], row["feature"]): row for row in points}
    rotations = _rotations(connection, unit_id)
    heights = query(connection, "SELECT height FROM units WHERE unit_id = ? AND height IS NOT NULL LIMIT 1", (unit_id,))
    height = float(heights[0]["height"]) if heights else math.nan
    added: dict[str, list[int]] = {}
    for layer in ("displacements", "displacements_other"):
        if layer not in _tables(connection):
            continue
        kinds = {
            "displacements": "SELECT DISTINCT epoch_from, epoch_to, time_from, time_to, datum FROM displacements",
            "displacements_other": "SELECT DISTINCT epoch_from, epoch_to, time_from, time_to, datum FROM displacements_other",
        }
        for pair in query(connection, kinds[layer]):
            ends = (pair["epoch_from"], pair["epoch_to"])
            if not ((ends[0] in first and ends[1] in second) or (ends[0] in second and ends[1] in first)):
                continue
            shift, common, least = _common_part(connection, layer, pair)
            critical = _critical_p(connection, layer, pair)
            for feature in FEATURES:
                a, b = places.get((ends[0], feature)), places.get((ends[1], feature))
                if a is None or b is None or a["geom"] is None or b["geom"] is None:
                    continue
                vector = b["geom"] - a["geom"] + shift
                sd = np.sqrt(np.maximum(_sd(a) ** 2 + _sd(b) ** 2 + common, least))
                row: Row = {**pair, "unit_id": unit_id, "feature": feature}
                row |= _measures(vector, sd, a["geom"], srs_of(connection), "stable", critical, height)
                row |= {"rotation_deg": _turn(rotations, *ends), "sd_rotation_deg": None}
                added.setdefault(layer, []).append(_insert(connection, layer, row))
    return added


def _common_part(connection: sqlite3.Connection, layer: str, pair: Row) -> tuple[FloatArray, FloatArray, FloatArray]:
    """What up to 200 other units of a pair and datum tell, (3,) each: shift against the points' own frame, variance beyond that of
    the two points (negative where a registration error common to both epochs cancels), and the least variance."""
    statements = {
        "displacements": "SELECT * FROM displacements WHERE feature = 'centre' AND epoch_from = ? AND epoch_to = ? AND datum = ? LIMIT 200",
        "displacements_other": (
            "SELECT * FROM displacements_other WHERE feature = 'centre' AND epoch_from = ? AND epoch_to = ? AND datum = ? LIMIT 200"
        ),
    }
    shifts, commons, variances = [], [], []
    for row in query(connection, statements[layer], (pair["epoch_from"], pair["epoch_to"], pair["datum"])):
        ends = {
            point["epoch"]: point
            for point in query(connection, "SELECT * FROM feature_points WHERE unit_id = ? AND feature = 'centre'", (row["unit_id"],))
        }
        a, b = ends.get(pair["epoch_from"]), ends.get(pair["epoch_to"])
        if a is not None and b is not None and a["geom"] is not None and b["geom"] is not None:
            shifts.append(_vector(row) - (b["geom"] - a["geom"]))
            commons.append(_sd(row) ** 2 - _sd(a) ** 2 - _sd(b) ** 2)
            variances.append(_sd(row) ** 2)
    if not shifts:
        return np.zeros(3), np.zeros(3), np.zeros(3)
    return np.median(shifts, axis=0), np.median(commons, axis=0), np.min(variances, axis=0)


def _critical_p(connection: sqlite3.Connection, layer: str, pair: Row) -> float:
    """Largest p-value the run called significant in a pair and datum, its multiple-testing control included; 0.05 where none was."""
    found = connection.execute(CRITICAL_P[layer], (pair["epoch_from"], pair["epoch_to"], pair["datum"])).fetchone()[0]
    return 0.05 if found is None else float(found)


def _measures(vector: FloatArray, sd: FloatArray, start: FloatArray, srs: int, kind: str, critical: float, height: float) -> Row:
    statistic = float(np.sum((vector / sd) ** 2)) if np.all(sd > 0) else None
    p = None if statistic is None else chi2_3_survival(statistic)
    significant = p is not None and p <= critical
    if kind in ("stable", "moved"):
        kind = "moved" if significant else "stable"
    return {
        "geom": encode_line(srs, np.array([start, start + vector])),
        "de": float(vector[0]),
        "dn": float(vector[1]),
        "dh": float(vector[2]),
        "d_horizontal": float(math.hypot(vector[0], vector[1])),
        "d_3d": float(np.linalg.norm(vector)),
        "azimuth_deg": math.degrees(math.atan2(vector[0], vector[1])) % 360,
        "sd_e": float(sd[0]),
        "sd_n": float(sd[1]),
        "sd_h": float(sd[2]),
        "statistic": statistic,
        "p_value": p,
        "significant": int(significant),
        "class": kind,
        "d_over_h": float(np.linalg.norm(vector)) / height,
        "d_over_dn": float(np.linalg.norm(vector)) / (VOLUME_RATIO ** (1 / 3) * height),
        # what rests on all units of the pair is the run's to say
        "p_adjusted": None,
        "detectable": None,
        "grade": None,
    }


def _drop_velocities(connection: sqlite3.Connection, *before: dict[str, list[Row]]) -> None:
    """Velocities over all epochs no longer hold once one epoch changed; the next run computes them again."""
    connection.executemany(DELETE_ROW["velocities"], [(row["fid"],) for rows in before for row in rows.get("velocities", [])])


def _features(centre: FloatArray, rotation: FloatArray, radius: float, gradient: float) -> dict[str, FloatArray]:
    places = centre + np.vstack([np.zeros(3), joints_of(radius, gradient)]) @ rotation.T
    return dict(zip(FEATURES, places, strict=True))


def _rotations(connection: sqlite3.Connection, unit_id: str) -> dict[str, FloatArray]:
    rows = query(connection, "SELECT epoch, qx, qy, qz, qw FROM units WHERE unit_id = ? AND qw IS NOT NULL", (unit_id,))
    return {row["epoch"]: rotation_of_quaternion([row["qx"], row["qy"], row["qz"], row["qw"]]) for row in rows}


def _turn(rotations: dict[str, FloatArray], start: str, stop: str) -> float | None:
    if start not in rotations or stop not in rotations:
        return None
    cosine = (np.trace(rotations[start].T @ rotations[stop]) - 1) / 2
    return math.degrees(math.acos(min(max(float(cosine), -1.0), 1.0)))


def _prepare(connection: sqlite3.Connection) -> None:
    # layers written by GDAL keep their spatial index by triggers that call its functions; the same in Python
    bounds: tuple[tuple[str, Callable[[bytes], float]], ...] = (
        ("ST_MinX", lambda blob: _corners(blob)[0]),
        ("ST_MaxX", lambda blob: _corners(blob)[1]),
        ("ST_MinY", lambda blob: _corners(blob)[2]),
        ("ST_MaxY", lambda blob: _corners(blob)[3]),
    )
    for name, function in bounds:
        connection.create_function(name, 1, function, deterministic=True)
    connection.create_function("ST_IsEmpty", 1, lambda blob: int(decode_geometry(blob) is None), deterministic=True)
    connection.execute(CREATE_EDITS)
    _register_layer(connection, "unit_edits", "Corrections by hand, and placeholders for units that were not found", "POINT")


def _corners(blob: bytes) -> tuple[float, float, float, float]:
    decoded = decode_geometry(blob)
    if decoded is None:
        return math.nan, math.nan, math.nan, math.nan
    points = np.atleast_2d(decoded)
    return float(points[:, 0].min()), float(points[:, 0].max()), float(points[:, 1].min()), float(points[:, 1].max())


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


def _tables(connection: sqlite3.Connection) -> set[str]:
    return {str(row["name"]) for row in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}


def _rows_of(connection: sqlite3.Connection, unit_id: str) -> dict[str, list[Row]]:
    present = _tables(connection)
    rows = {layer: query(connection, statement, (unit_id,)) for layer, statement in SELECT_OF_UNIT.items() if layer in present}
    if not rows["units"]:
        raise InputError("there is no such unit", where=f"unit {unit_id}", remedy="Open the result again; it may have been deleted.")
    for layer, found in rows.items():
        for row in found:
            row["raw_geom"] = _raw(connection, layer, row["fid"])["geom"]
    return rows


def _raw(connection: sqlite3.Connection, layer: str, fid: int) -> Row:
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


def _insert(connection: sqlite3.Connection, layer: str, row: Row) -> int:
    columns = [str(column["name"]) for column in connection.execute("SELECT name FROM pragma_table_info(?)", (layer,))]
    present = [name for name in columns if name in row]
    quoted = ", ".join('"' + name.replace('"', '""') + '"' for name in present)
    marks = ", ".join("?" * len(present))
    # layer and columns come from the file's own catalogue, values are bound
    statement = f'INSERT INTO "{layer}" ({quoted}) VALUES ({marks})'  # noqa: S608  # nosec B608
    return int(connection.execute(statement, [row[name] for name in present]).lastrowid or 0)


def _place(rows: dict[str, list[Row]], unit_id: str) -> FloatArray | None:
    return next((row["geom"] for row in rows["units"] if row["geom"] is not None), None)


def _log(
    connection: sqlite3.Connection,
    kind: str,
    unit_id: str,
    epoch: str,
    place: FloatArray | None,
    comment: str,
    editor: str,
    before: dict[str, Any],
) -> None:
    if not editor.strip():
        raise InputError("the editor has no name", remedy="Enter your name or initials; it stands beside every correction.")
    point = None if place is None else encode_point(srs_of(connection), place)
    connection.execute(
        "INSERT INTO unit_edits (geom, kind, unit_id, epoch, comment, editor, edited_at, before) VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
        (point, kind, unit_id, epoch, comment, editor.strip(), now_utc(), json.dumps(_plain(before))),
    )
    connection.execute("UPDATE gpkg_contents SET last_change = ?", (now_utc(),))


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


def _vector(row: Row) -> FloatArray:
    return np.array([row["de"], row["dn"], row["dh"]], dtype=np.float64)


def _sd(row: Row) -> FloatArray:
    return np.array([row["sd_e"], row["sd_n"], row["sd_h"]], dtype=np.float64)
