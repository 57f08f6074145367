"""Outlines and surfaces of a result against the poses of its units, before and after a correction."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

import geopandas
import numpy as np
import shapely
from synthetic_result import LEG_LENGTH, write_result
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.results import geopackage_writer
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.core.review.corrections import NewPose, merge_units, set_pose, split_unit, undo_edit


def _distances(result: Path) -> np.ndarray:
    """Distance of every corner of every surface from the exact surface of the unit whose row it is."""
    units = {(row["unit_id"], row["epoch"]): row for row in read_layer_rows(result, "units") if row["geom"] is not None}
    found = []
    surfaces = read_layer_rows(result, "unit_surfaces")
    assert {(row["unit_id"], row["epoch"]) for row in surfaces} == units.keys()
    for row in surfaces:
        unit = units[row["unit_id"], row["epoch"]]
        shape = UnitType.tetrapod(unit["height"], radius=unit["r0"], gradient=unit["gradient"], leg_length=LEG_LENGTH)
        pose = Pose.from_quaternion(unit["geom"], [unit[name] for name in ("qx", "qy", "qz", "qw")])
        found.append(np.abs(relate(pose.to_body(row["geom"]), shape).distance).max())
    return np.array(found)


def test_a_written_result_holds_a_body_for_every_pose(tmp_path: Path) -> None:
    source, result = tmp_path / "made.gpkg", tmp_path / "written.gpkg"
    write_result(source, 12)
    tables = {
        layer: [
            {("geometry" if name == "geom" else name): value for name, value in row.items() if name != "fid"}
            for row in read_layer_rows(source, layer)
        ]
        for layer in ("units", "displacements", "epochs")
    }
    geopackage_writer.write_result(result, "EPSG:5186", tables)
    assert _distances(result).max() < 1e-6
    outlines = geopandas.read_file(result, layer="unit_outlines")
    surfaces = geopandas.read_file(result, layer="unit_surfaces")
    assert set(outlines.geom_type) == {"Polygon"}
    assert set(surfaces.geom_type) == {"MultiPolygon"}
    assert shapely.has_z(surfaces.geometry.values).all()
    assert np.allclose(outlines["area"], outlines.area)
    assert outlines.crs.to_epsg() == 5186
    # the class is that of the displacement which ends in the epoch
    moved = {(row["unit_id"], row["epoch_to"]): row["class"] for row in tables["displacements"] if row["feature"] == "centre"}
    for row in outlines.itertuples():
        assert outlines.loc[row.Index, "class"] == moved.get((row.unit_id, row.epoch), row.status)


def test_bodies_that_are_made_already_are_written_as_they_are(tmp_path: Path) -> None:
    result = tmp_path / "written.gpkg"
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
    epochs = [{"label": "a", "time": datetime(2024, 1, 1, tzinfo=UTC)}, {"label": "b", "time": datetime(2025, 1, 1, tzinfo=UTC)}]
    body = {"unit_id": "u1", "epoch": "a"}
    tables = {
        "units": [],
        "epochs": epochs,
        "unit_outlines": [body | {"geometry": square}],
        "unit_surfaces": [body | {"geometry": [square[None]]}],
    }
    geopackage_writer.write_result(result, "EPSG:5186", tables)
    for layer in ("unit_outlines", "unit_surfaces"):
        assert [(row["unit_id"], row["epoch_until"][:4]) for row in read_layer_rows(result, layer)] == [("u1", "2025")], layer


def test_bodies_follow_corrections_and_their_undoing(tmp_path: Path) -> None:
    result = tmp_path / "result.gpkg"
    made = write_result(result, 12)
    unit = next(u for u in made if u.fate == "stable")
    before = {(row["unit_id"], row["epoch"]): row["geom"] for row in read_layer_rows(result, "unit_surfaces")}
    epoch = "2024-04-09"
    pose = NewPose(
        centre=unit.centres[1] + [0.3, 0.0, 0.1],
        rotation=np.eye(3),
        radius=0.6,
        gradient=0.17,
        height=2.3,
        sd=np.full(3, 0.004),
        sd_rotation_deg=0.2,
    )
    set_pose(result, unit.unit_id, epoch, pose, editor="a")
    assert _distances(result).max() < 1e-6
    name = split_unit(result, unit.unit_id, "2025-04-09", editor="a")
    assert _distances(result).max() < 1e-6
    merge_units(result, unit.unit_id, name, editor="a")
    assert _distances(result).max() < 1e-6
    for number in (3, 2, 1):
        undo_edit(result, number, editor="a")
    after = {(row["unit_id"], row["epoch"]): row["geom"] for row in read_layer_rows(result, "unit_surfaces")}
    assert after.keys() == before.keys()
    assert all(np.allclose(after[key], before[key], rtol=0, atol=1e-9) for key in before)
