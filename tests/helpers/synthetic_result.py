"""A result.gpkg made up from nothing but numpy and sqlite3: for tests and benchmarks of what reads results.

Layers and fields follow core/schema.py. Displacements are drawn, not computed: most units stand still within their standard
deviation, some slide, a few are lost, hidden, new or carried away.
"""

from __future__ import annotations

import json
import shutil
import sqlite3
from contextlib import closing
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from functools import cache
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from tetratrack.core.model.outline import PlacedShape, reach, rotation_of_quaternion
from tetratrack.core.results.geopackage_reader import add_indices, encode_geometry
from tetratrack.core.results.result_replacement import put_in_place
from tetratrack.core.results.schema import FEATURES, LAYERS
from tetratrack.core.results.unit_bodies import body_rows
from tetratrack.core.results.unit_sizes import sizes_of_settings
from tetratrack.core.review.decisions import settle_decisions
from tetratrack.core.review.point_index import index_folder, write_index

HEIGHT, RADIUS, GRADIENT, LEG_LENGTH = 2.3, 0.60814, 0.17610, 1.48120
NOMINAL_DIAMETER = 1.52
"""Metres; a little more than of standard proportions, as a mould may have it."""
LEGS = np.array([[0, 0, 1], [0.942809, 0, -1 / 3], [-0.471405, 0.816497, -1 / 3], [-0.471405, -0.816497, -1 / 3]])
ORIGIN = np.array([236500.0, 285150.0, 3.0])
SRS = 5186
SQL_TYPES = {"text": "TEXT", "integer": "INTEGER", "real": "REAL", "boolean": "BOOLEAN", "datetime": "DATETIME"}
CENTRE_SD = np.array([0.004, 0.004, 0.003])


@dataclass(frozen=True)
class SyntheticUnit:
    """Truth of one unit: id, fate, and per epoch its centre ((3,), metres) and quaternion (qx, qy, qz, qw)."""

    unit_id: str
    fate: str
    centres: np.ndarray
    quaternions: np.ndarray


def make_units(count: int, epochs: int, seed: int = 1) -> list[SyntheticUnit]:
    """Units in rows of ten down a slope along a breakwater that runs north-east."""
    rng = np.random.default_rng(seed)
    along = np.array([np.cos(0.6), np.sin(0.6), 0])
    across = np.array([-np.sin(0.6), np.cos(0.6), 0])
    units = []
    for k in range(count):
        place = ORIGIN + (k // 10) * 0.95 * HEIGHT * along + (k % 10) * (0.9 * HEIGHT * across + np.array([0, 0, 0.5 * HEIGHT]))
        quaternion = rng.normal(size=4)
        quaternion /= np.linalg.norm(quaternion)
        fate = rng.choice(["stable", "moved", "lost", "unseen", "new", "relocated"], p=[0.84, 0.12, 0.01, 0.01, 0.01, 0.01])
        step = np.zeros(3)
        if fate == "moved":
            step = (np.array([0.6, -0.6, -0.5]) * rng.gamma(1.2, 0.12)) * rng.uniform(0.5, 1, 3)
        if fate == "relocated":
            step = np.array([2.1, -2.4, -1.5])
        epoch = np.arange(epochs)[:, None]
        centres = place + rng.normal(0, 0.15, 3) + epoch * step + rng.normal(0, CENTRE_SD, (epochs, 3))
        turn = np.zeros((epochs, 4))
        turn[:] = quaternion
        if fate in ("moved", "relocated"):
            turn = turn + epoch * rng.normal(0, 0.01, 4)
            turn /= np.linalg.norm(turn, axis=1, keepdims=True)
        units.append(SyntheticUnit(f"U{k + 1:05d}", str(fate), centres, turn))
    return units


def write_result(
    path: Path, count: int = 120, epochs: int = 3, seed: int = 1, units: list[SyntheticUnit] | None = None
) -> list[SyntheticUnit]:
    """Write a result of ``count`` units and return their truth."""
    if units is not None:
        _write(path, _rows_of_result(units, epochs, seed))
        return units
    made, content = _drawn_result(count, epochs, seed)
    path.write_bytes(content)
    return list(made)


@cache
def _drawn_result(count: int, epochs: int, seed: int) -> tuple[tuple[SyntheticUnit, ...], bytes]:
    """Truth and file of a drawn result: dozens of tests begin with the same one."""
    made = make_units(count, epochs, seed)
    with TemporaryDirectory() as folder:
        path = Path(folder) / "result.gpkg"
        _write(path, _rows_of_result(made, epochs, seed))
        return tuple(made), path.read_bytes()


def _rows_of_result(made: list[SyntheticUnit], epochs: int, seed: int) -> dict[str, list[dict[str, Any]]]:
    """Rows of every layer."""
    labels = [f"{2023 + k}-04-09" for k in range(epochs)]
    times = [datetime(2023, 4, 9, 2, 30, tzinfo=UTC) + timedelta(days=365 * k) for k in range(epochs)]
    stamps = [t.strftime("%Y-%m-%dT%H:%M:%S.000Z") for t in times]
    rows: dict[str, list[dict[str, Any]]] = {name: [] for name in LAYERS}
    rng = np.random.default_rng(seed + 1)
    for unit in made:
        present = _present(unit, epochs)
        for e in range(epochs):
            rows["units"].append(_unit_row(unit, e, labels[e], stamps[e], present, rng))
            if present[e]:
                rows["feature_points"] += [_feature_row(unit, e, f, labels[e], stamps[e]) for f in range(5)]
        for i in range(epochs):
            for j in range(i + 1, epochs):
                if present[i] and present[j]:
                    for datum in ("stable", "control"):
                        layer = "displacements" if j == i + 1 and datum == "stable" else "displacements_other"
                        rows[layer] += [_displacement_row(unit, i, j, f, labels, stamps, datum) for f in range(5)]
    for start, stop in pairwise(labels):
        row = {"epoch_from": start, "epoch_to": stop, "units": len(made), "stable_units": int(0.8 * len(made)), "global_p_value": 0.43}
        row |= {"common_e": 0.002, "common_n": 0.003, "common_h": -0.004, "common_p_value": 0.21, "geom": ORIGIN}
        rows["epoch_pairs"].append(row)
    rows["gaps"] += [_gap_row(unit, epochs, labels[-1], stamps[-1]) for unit in made if unit.fate in ("lost", "unseen")]
    _control(rows, labels, rng)
    _check(rows, made, labels, rng)
    rows |= {
        layer: [{**row, "geom": row["geometry"]} for row in made]
        for layer, made in body_rows(
            [row for row in rows["units"] if row], rows["displacements"], sizes_of_settings([{"leg_length": LEG_LENGTH}])
        ).items()
    }
    for e in range(epochs):
        transformation = {
            "origin_from": ORIGIN.tolist(),
            "origin_to": ORIGIN.tolist(),
            "translation_m": [0.0, 0.0, 0.0],
            "rotation_vector_rad": [0.0, 0.0, 0.0],
            "scale": 1.0,
            "covariance": np.diag([4e-6, 4e-6, 4e-6, 1e-8, 1e-8, 1e-8, 0]).tolist(),
        }
        settings = {"crs": f"EPSG:{SRS}", "survey": "synthetic breakwater", "significance": 0.05, "leg_length": LEG_LENGTH}
        rows["epochs"].append(
            {
                "label": labels[e],
                "time": stamps[e],
                "tiles": json.dumps([f"tile_{e}.laz"]),
                "points": 2_000_000,
                "transformation": json.dumps(transformation),
                "sigma0": 1.04,
                "software": "tetratrack 0.1.0",
                "settings": json.dumps(settings),
            }
        )
    return rows


def features_of(unit: SyntheticUnit, epoch: int) -> np.ndarray:
    """(5, 3) centre and joints in the CRS; the joint of three legs lies opposite to the fourth."""
    angle = np.arccos(1 / 3)
    reach = RADIUS / (np.sin(angle) + GRADIENT * np.cos(angle))
    body = np.vstack([np.zeros(3), -reach * LEGS[[3, 2, 1, 0]]])
    return unit.centres[epoch] + body @ rotation_of_quaternion(unit.quaternions[epoch]).T


def write_points(
    result: Path, units: list[SyntheticUnit], epochs: int = 3, per_unit: int = 2500, seed: int = 3, noise: float = 0.005
) -> None:
    """Write the point index of a result: points with noise (metres) on the upper side of every unit that is there."""
    rng = np.random.default_rng(seed)
    labels = [f"{2023 + k}-04-09" for k in range(epochs)]
    tiles = []
    for e, label in enumerate(labels):
        clouds = []
        for unit in (u for u in units if _present(u, epochs)[e]):
            direction = rng.normal(size=(per_unit, 3))
            direction[:, 2] = np.abs(direction[:, 2])
            direction /= np.linalg.norm(direction, axis=1, keepdims=True)
            shape = PlacedShape(
                centre=unit.centres[e],
                rotation=rotation_of_quaternion(unit.quaternions[e]),
                radius=RADIUS,
                gradient=GRADIENT,
                leg_length=LEG_LENGTH,
                legs=LEGS,
            )
            clouds.append(unit.centres[e] + direction * reach(direction, shape)[:, None] + rng.normal(0, noise, (per_unit, 3)))
        tiles.append((label, f"tile_{e}", np.vstack(clouds)))
    write_index(index_folder(result), tiles, np.vstack([u.centres for u in units]), 1.5 * HEIGHT)


def _present(unit: SyntheticUnit, epochs: int) -> list[bool]:
    present = [True] * epochs
    if unit.fate in ("lost", "unseen"):
        present[-1] = False
    if unit.fate == "new":
        present = [False] * (epochs - 1) + [True]
    return present


def _unit_row(unit: SyntheticUnit, e: int, label: str, stamp: str, present: list[bool], rng: np.random.Generator) -> dict[str, Any]:
    status = "found"
    if not present[e]:
        status = unit.fate if unit.fate != "new" else None
    elif unit.fate in ("new", "relocated") and e == len(present) - 1:
        status = unit.fate
    if status is None:
        return {}
    row: dict[str, Any] = {
        "unit_id": unit.unit_id,
        "epoch": label,
        "epoch_time": stamp,
        "height": HEIGHT,
        "r0": RADIUS,
        "gradient": GRADIENT,
        "status": status,
    }
    if not present[e]:
        return row
    q = unit.quaternions[e]
    coverage = float(rng.uniform(0.1, 0.5))
    row |= {"qx": q[0], "qy": q[1], "qz": q[2], "qw": q[3], "sd_e": 0.004, "sd_n": 0.004, "sd_h": 0.003, "sd_rotation_deg": 0.2}
    row |= {"unit_type": "tetrapod", "sigma0": 1.0, "n_points": int(4000 * coverage), "legs_visible": 3, "coverage": coverage, "score": 0.8}
    return row | {"geom": unit.centres[e]}


def _gap_row(unit: SyntheticUnit, epochs: int, label: str, stamp: str) -> dict[str, Any]:
    row = {
        "epoch": label,
        "epoch_time": stamp,
        "kind": unit.fate,
        "status": "placeholder",
        "unit_id": unit.unit_id,
        "unit_type": "tetrapod",
    }
    row |= {"height": HEIGHT, "radius": 0.66 * HEIGHT, "score": 1.0, "nearest_units": "[]", "nearest_centre": 0.9 * HEIGHT}
    return row | {"geom": unit.centres[epochs - 2]}


def _feature_row(unit: SyntheticUnit, e: int, f: int, label: str, stamp: str) -> dict[str, Any]:
    row = {"unit_id": unit.unit_id, "epoch": label, "epoch_time": stamp, "feature": FEATURES[f], "observed": int(f < 3)}
    row |= {"sd_e": 0.004, "sd_n": 0.004, "sd_h": 0.003, "cov_en": 0.0, "cov_eh": 0.0, "cov_nh": 0.0}
    return row | {"geom": features_of(unit, e)[f]}


def _displacement_row(unit: SyntheticUnit, i: int, j: int, f: int, labels: list[str], stamps: list[str], datum: str) -> dict[str, Any]:
    start, stop = features_of(unit, i)[f], features_of(unit, j)[f]
    d = stop - start + (np.array([0.002, 0.003, -0.004]) if datum == "control" else 0.0)
    sd = CENTRE_SD * np.sqrt(2) * (2 if datum == "control" else 1)
    statistic = float(np.sum((d / sd) ** 2))
    p = float(np.exp(-statistic / 2) * (1 + statistic / 2))
    cosine = abs(float(unit.quaternions[i] @ unit.quaternions[j]))
    kind = "relocated" if unit.fate == "relocated" else ("moved" if p < 0.001 else "stable")
    return {
        "unit_id": unit.unit_id,
        "feature": FEATURES[f],
        "epoch_from": labels[i],
        "epoch_to": labels[j],
        "time_from": stamps[i],
        "time_to": stamps[j],
        "de": d[0],
        "dn": d[1],
        "dh": d[2],
        "d_horizontal": float(np.hypot(d[0], d[1])),
        "d_3d": float(np.linalg.norm(d)),
        "azimuth_deg": float(np.degrees(np.arctan2(d[0], d[1])) % 360),
        "sd_e": sd[0],
        "sd_n": sd[1],
        "sd_h": sd[2],
        "rotation_deg": float(np.degrees(2 * np.arccos(min(cosine, 1.0)))),
        "sd_rotation_deg": 0.3,
        "datum": datum,
        "statistic": statistic,
        "p_value": p,
        "significant": int(p < 0.001),
        "class": kind,
        "d_over_h": float(np.linalg.norm(d)) / HEIGHT,
        "d_over_dn": float(np.linalg.norm(d)) / NOMINAL_DIAMETER,
        "geom": np.array([start, start + d]),
    }


def _control(rows: dict[str, list[dict[str, Any]]], labels: list[str], rng: np.random.Generator) -> None:
    for e, label in enumerate(labels):
        for k in range(6):
            v = rng.normal(0, 0.004, 3)
            disturbed = e == len(labels) - 1 and k == 5
            v = v + (0.06 if disturbed else 0)
            row = {"point_id": f"T{k + 1}", "epoch": label, "ve": v[0], "vn": v[1], "vh": v[2], "w_max": float(abs(v).max() / 0.004)}
            rows["control_residuals"].append(
                row | {"used": int(not disturbed), "outlier": int(disturbed), "geom": ORIGIN + np.array([k * 9.0, 25.0, 6.0])}
            )


def _check(rows: dict[str, list[dict[str, Any]]], units: list[SyntheticUnit], labels: list[str], rng: np.random.Generator) -> None:
    for k, unit in enumerate([u for u in units if u.fate in ("stable", "moved")][:4]):
        for e, label in enumerate(labels):
            d = rng.normal(0, 0.005, 3)
            row = {"point_id": f"K{k + 1}", "epoch": label, "unit_id": unit.unit_id, "feature": "f123", "de": d[0], "dn": d[1], "dh": d[2]}
            rows["check_residuals"].append(row | {"d_3d": float(np.linalg.norm(d)), "geom": features_of(unit, e)[1]})


def run_again(result: Path, change: str, *values: object, other: Path | None = None) -> None:
    """Replace a result as a run does: by itself, or another result, after a change in SQL."""
    finished = result.with_name("night.gpkg")
    shutil.copy(other or result, finished)
    with closing(sqlite3.connect(finished)) as connection, connection:
        connection.execute(change, values)
        connection.execute("UPDATE gpkg_contents SET last_change = '2030-01-01T00:00:00.000Z'")
        connection.execute(
            "CREATE TABLE layer_styles (id INTEGER PRIMARY KEY, f_table_catalog, f_table_schema, f_table_name, f_geometry_column, "
            "styleName, styleQML, styleSLD, useAsDefault, description, owner)"
        )
    put_in_place(finished, result, tuple(name for name in LAYERS if name != "reviews"))
    settle_decisions(result)


def _write(path: Path, rows: dict[str, list[dict[str, Any]]]) -> None:
    with closing(sqlite3.connect(path, isolation_level=None)) as connection:
        connection.execute("PRAGMA application_id = 1196444487")
        connection.execute("PRAGMA user_version = 10300")
        connection.execute("BEGIN")
        connection.execute(
            "CREATE TABLE gpkg_spatial_ref_sys (srs_name TEXT NOT NULL, srs_id INTEGER PRIMARY KEY, organization TEXT NOT NULL, "
            "organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT)"
        )
        for name, number, organization in (("undefined", -1, "NONE"), ("undefined", 0, "NONE"), (f"EPSG:{SRS}", SRS, "EPSG")):
            connection.execute(
                "INSERT INTO gpkg_spatial_ref_sys VALUES (?, ?, ?, ?, 'undefined', NULL)", (name, number, organization, number)
            )
        connection.execute(
            "CREATE TABLE gpkg_contents (table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE, "
            "description TEXT DEFAULT '', last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')), "
            "min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, srs_id INTEGER)"
        )
        connection.execute(
            "CREATE TABLE gpkg_geometry_columns (table_name TEXT NOT NULL, column_name TEXT NOT NULL, "
            "geometry_type_name TEXT NOT NULL, srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL, "
            "CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name))"
        )
        for layer in LAYERS.values():
            columns = ", ".join(f'"{field.name}" {SQL_TYPES[field.type]}' for field in layer.fields)
            spatial = layer.geometry != "none"
            geometry = "geom BLOB, " if spatial else ""
            connection.execute(f'CREATE TABLE "{layer.name}" (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, {geometry}{columns})')
            table = [row for row in rows[layer.name] if row]
            points = np.array([_first_corner(row["geom"]) for row in table if row.get("geom") is not None]).reshape(-1, 3)
            low, high = (points.min(axis=0)[:2], points.max(axis=0)[:2]) if len(points) else (np.zeros(2), np.zeros(2))
            connection.execute(
                "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, min_x, min_y, max_x, max_y, srs_id) "
                "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
                (layer.name, "features" if spatial else "attributes", layer.name, layer.description, *low, *high, SRS if spatial else 0),
            )
            if spatial:
                kind = layer.geometry.removesuffix("Z").upper()
                connection.execute("INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', ?, ?, 1, 0)", (layer.name, kind, SRS))
            names = [*(["geom"] if spatial else []), *layer.names]
            quoted = ", ".join(f'"{name}"' for name in names)
            values = [
                [
                    encode_geometry(SRS, layer.geometry, row["geom"]) if n == "geom" and row.get("geom") is not None else _plain(row.get(n))
                    for n in names
                ]
                for row in table
            ]
            connection.executemany(f'INSERT INTO "{layer.name}" ({quoted}) VALUES ({", ".join("?" * len(names))})', values)  # noqa: S608 - names of the schema
        add_indices(connection)
        connection.execute("COMMIT")


def _first_corner(geometry: Any) -> np.ndarray:
    """(3,) first corner of a geometry as the writer takes it."""
    return np.reshape(geometry[0] if isinstance(geometry, list) else geometry, (-1, 3))[0]


def _plain(value: Any) -> Any:
    return value.item() if isinstance(value, np.generic) else value
