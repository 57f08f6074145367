"""What follows from a corrected pose: the unit's row, its feature points, and displacements to and from that epoch."""

from __future__ import annotations

import math
import sqlite3
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..common.arrays import FloatArray
from ..model.outline import quaternion_of_rotation, rotation_of_quaternion
from ..model.unit_types import UnitType
from ..results.geopackage_reader import Row, encode_line, encode_point, query, srs_of
from ..results.schema import FEATURES
from ..results.unit_legs import FIELDS_OF_LEGS
from .pose_from_picks import joints_of
from .unit_records import DELETE_ROW, columns_of, delete_rows, insert_row, raw_row, rows_of_unit, tables_of

CRITICAL_P = {
    "displacements": "SELECT max(p_value) FROM displacements WHERE significant AND epoch_from = ? AND epoch_to = ? AND datum = ?",
    "displacements_other": (
        "SELECT max(p_value) FROM displacements_other WHERE significant AND epoch_from = ? AND epoch_to = ? AND datum = ?"
    ),
}


SAME_PLACE_HEIGHTS, SAME_TURN_DEG = 0.1, 10.0
"""Shift over H and turn up to which what was seen of the legs at the old pose holds for the new one."""


@dataclass(frozen=True, eq=False, kw_only=True)
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


def write_pose(connection: sqlite3.Connection, old: Row, pose: NewPose, rotation: FloatArray) -> None:
    """Put a pose into the unit's row; what a fit states and a pose pinned by hand has not becomes empty, as does what was seen of the legs
    of another pose."""
    q = quaternion_of_rotation(rotation)
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
    if not _is_alike(old, pose, rotation):
        values |= dict.fromkeys(("leg_missing", "leg_probability", *FIELDS_OF_LEGS))
    row = {name: values.get(name, value) for name, value in raw_row(connection, "units", old["fid"]).items()}
    connection.execute(DELETE_ROW["units"], (old["fid"],))
    insert_row(connection, "units", row)


def _is_alike(old: Row, pose: NewPose, rotation: FloatArray) -> bool:
    """Whether a pose is the one of the unit's row but for what fits differ by."""
    if old["geom"] is None or old["qw"] is None:
        return False
    turn = _degrees_between(rotation_of_quaternion([old[name] for name in ("qx", "qy", "qz", "qw")]), rotation)
    return bool(np.linalg.norm(pose.centre - old["geom"]) < SAME_PLACE_HEIGHTS * pose.height and turn < SAME_TURN_DEG)


def write_features(connection: sqlite3.Connection, rows: Sequence[Row], old: Row, pose: NewPose, rotation: FloatArray) -> None:
    """Put the feature points that follow from a pose into the layer, with the covariance of the pose."""
    places = _features(pose.centre, rotation, pose.radius, pose.gradient)
    arm = math.radians(pose.sd_rotation_deg) / math.sqrt(3)
    here = {row["feature"]: row for row in rows if row["epoch"] == old["epoch"]}
    columns = columns_of(connection, "feature_points")
    for feature, place in places.items():
        # rotation about three axes with equal variance: every direction across the arm gets arm length times that
        reach = float(np.linalg.norm(place - pose.centre))
        ray = (place - pose.centre) / reach if reach else np.zeros(3)
        covariance = np.diag(pose.sd**2) + (arm * reach) ** 2 * (np.eye(3) - np.outer(ray, ray)) * (reach > 0)
        row: Row = dict.fromkeys(columns)
        row |= {"unit_id": old["unit_id"], "epoch": old["epoch"], "epoch_time": old["epoch_time"], "feature": feature, "observed": 0}
        row["epoch_until"] = old.get("epoch_until")
        if feature in here:
            row |= raw_row(connection, "feature_points", here[feature]["fid"])
            connection.execute(DELETE_ROW["feature_points"], (here[feature]["fid"],))
        sd = np.sqrt(np.diag(covariance))
        row |= {"geom": encode_point(srs_of(connection), place), "sd_e": float(sd[0]), "sd_n": float(sd[1]), "sd_h": float(sd[2])}
        row |= {"cov_en": float(covariance[0, 1]), "cov_eh": float(covariance[0, 2]), "cov_nh": float(covariance[1, 2])}
        insert_row(connection, "feature_points", row)


def carry_displacements(connection: sqlite3.Connection, before: dict[str, list[Row]], epoch: str, old: Row, pose: NewPose) -> None:
    """Move the end that lies in ``epoch`` of every displacement of the unit."""
    unit_id = old["unit_id"]
    was = {(row["feature"]): row for row in before["feature_points"] if row["epoch"] == epoch}
    now = {
        row["feature"]: row for row in query(connection, "SELECT * FROM feature_points WHERE unit_id = ? AND epoch = ?", (unit_id, epoch))
    }
    rotations = _rotations(connection, unit_id)
    diameter = nominal_diameter_of(before)
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
            values = _measures(vector, np.sqrt(variance), row["class"], critical) | _in_unit_sizes(vector, pose.height, diameter)
            values["geom"] = encode_line(srs_of(connection), np.array([start, start + vector]))
            values |= {"rotation_deg": _turn(rotations, row["epoch_from"], row["epoch_to"]), "sd_rotation_deg": sd_rotation}
            full = raw_row(connection, layer, row["fid"]) | values
            connection.execute(DELETE_ROW[layer], (row["fid"],))
            insert_row(connection, layer, full)


def connect_epochs(connection: sqlite3.Connection, unit_id: str, first: set[str], second: set[str]) -> dict[str, list[int]]:
    """Add displacements of a unit between epochs of two sets, wherever the result compares them at all; the fids added.

    What the layers do not hold, the registration's share of the variance and the datum's small shift, is taken from other units.
    """
    points = query(connection, "SELECT * FROM feature_points WHERE unit_id = ?", (unit_id,))
    places = {(row["epoch"], row["feature"]): row for row in points}
    rotations = _rotations(connection, unit_id)
    rows = rows_of_unit(connection, unit_id)
    height = next((float(row["height"]) for row in rows["units"] if row["height"] is not None), math.nan)
    diameter = nominal_diameter_of(rows)
    added: dict[str, list[int]] = {}
    for layer in ("displacements", "displacements_other"):
        if layer not in tables_of(connection):
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
                row |= _measures(vector, sd, "stable", critical) | _in_unit_sizes(vector, height, diameter)
                row["geom"] = encode_line(srs_of(connection), np.array([a["geom"], a["geom"] + vector]))
                row |= {"rotation_deg": _turn(rotations, *ends), "sd_rotation_deg": None}
                added.setdefault(layer, []).append(insert_row(connection, layer, row))
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


def _measures(vector: FloatArray, sd: FloatArray, kind: str, critical: float) -> Row:
    statistic = float(np.sum((vector / sd) ** 2)) if np.all(sd > 0) else None
    p = None if statistic is None else chi2_3_survival(statistic)
    significant = p is not None and p <= critical
    if kind in ("stable", "moved"):
        kind = "moved" if significant else "stable"
    return {
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
        # what rests on all units of the pair is the run's to say
        "p_adjusted": None,
        "detectable": None,
        "grade": None,
    }


def _in_unit_sizes(vector: FloatArray, height: float, diameter: float) -> Row:
    length = float(np.linalg.norm(vector))
    return {"d_over_h": length / height, "d_over_dn": length / diameter}


def nominal_diameter_of(rows: dict[str, list[Row]]) -> float:
    """Dn of a unit in metres: as the run states it beside the unit's displacements, else of its fitted cones; nan
    where neither is known.

    Parameters
    ----------
    rows
        Rows of the unit by layer.
    """
    for layer in ("displacements", "displacements_other"):
        for row in rows.get(layer, []):
            if row["d_over_dn"]:
                return float(row["d_3d"]) / float(row["d_over_dn"])
    for row in rows["units"]:
        if row["r0"] is not None and row["height"] is not None:
            return UnitType.tetrapod(row["height"], radius=row["r0"], gradient=row["gradient"]).nominal_diameter
    return math.nan


def drop_velocities(connection: sqlite3.Connection, *before: dict[str, list[Row]]) -> None:
    """Velocities over all epochs no longer hold once one epoch changed; the next run computes them again."""
    delete_rows(connection, {"velocities": [row for rows in before for row in rows.get("velocities", [])]})


def _features(centre: FloatArray, rotation: FloatArray, radius: float, gradient: float) -> dict[str, FloatArray]:
    places = centre + np.vstack([np.zeros(3), joints_of(radius, gradient)]) @ rotation.T
    return dict(zip(FEATURES, places, strict=True))


def _rotations(connection: sqlite3.Connection, unit_id: str) -> dict[str, FloatArray]:
    rows = query(connection, "SELECT epoch, qx, qy, qz, qw FROM units WHERE unit_id = ? AND qw IS NOT NULL", (unit_id,))
    return {row["epoch"]: rotation_of_quaternion([row["qx"], row["qy"], row["qz"], row["qw"]]) for row in rows}


def _turn(rotations: dict[str, FloatArray], start: str, stop: str) -> float | None:
    if start not in rotations or stop not in rotations:
        return None
    return _degrees_between(rotations[start], rotations[stop])


def _degrees_between(start: FloatArray, stop: FloatArray) -> float:
    cosine = (np.trace(start.T @ stop) - 1) / 2
    return math.degrees(math.acos(min(max(float(cosine), -1.0), 1.0)))


def _vector(row: Row) -> FloatArray:
    return np.array([row["de"], row["dn"], row["dh"]], dtype=np.float64)


def _sd(row: Row) -> FloatArray:
    return np.array([row["sd_e"], row["sd_n"], row["sd_h"]], dtype=np.float64)


def chi2_3_survival(statistic: float) -> float:
    """Probability that chi-square with three degrees of freedom exceeds a value."""
    return math.erfc(math.sqrt(statistic / 2)) + math.sqrt(2 * statistic / math.pi) * math.exp(-statistic / 2)
