"""Sections, crest and settlement of blocks whose places are known, and points less blocks."""

from __future__ import annotations

import json
import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import geopandas
import laspy
import numpy as np
import pytest
import shapely
import synthetic_result
from synthetic_result import CENTRE_SD, HEIGHT, SRS, SyntheticUnit, make_units, write_points, write_result
from tetratrack.core.armour.as_built import read_as_built
from tetratrack.core.armour.comparisons import profiles, write_profiles
from tetratrack.core.armour.contacts import reach_of
from tetratrack.core.armour.residual_cloud import write_residual_cloud
from tetratrack.core.armour.sections import CutPlane, cut_body, settlement_rows
from tetratrack.core.common.axis import Axis
from tetratrack.core.common.centreline import ARM_HEIGHTS, centreline
from tetratrack.core.common.errors import InputError
from tetratrack.core.deformation.stretches import stretches_of
from tetratrack.core.model.outline import reach
from tetratrack.core.results.geopackage_reader import encode_geometry, read_layer_rows

TOP = 10.0
SETTLED = -0.12
FRAME_SD, OWN_SD = 0.005, 0.002
"""Of heights, metres: what all units of an epoch have in common, and what each has besides."""
AXIS = np.array([[200_000.0, 550_000.0], [200_100.0, 550_000.0]])


@pytest.fixture(scope="module")
def crest(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Four rows of upright units at one height, a fifth 3 m lower; between the epochs all sank but for the first twelve metres."""
    path = tmp_path_factory.mktemp("sections") / "result.gpkg"
    write_crest(path)
    state_registration(path, FRAME_SD)
    return path


def write_crest(path: Path, scale: float = 1.0) -> None:
    """The structure and its points, or a model of both at a scale."""
    units = []
    for row in range(5):
        for k in range(12):
            own = scale * np.array([2.0 * k, 1.7 * row, -0.644 * HEIGHT - (3.0 if row == 4 else 0.0)])
            place = own + np.array([*AXIS[0], TOP])
            later = place + np.array([0, 0, scale * SETTLED if k >= 6 else 0.0])
            turn = np.tile([0.0, 0.0, 0.0, 1.0], (2, 1))
            units.append(SyntheticUnit(f"U{row:02d}{k:03d}", "stable", np.array([place, later]), turn))
    write_result(path, epochs=2, units=units)
    write_points(path, units, epochs=2, noise=0.005 * scale)


def state_registration(path: Path, sd: float) -> None:
    """State a registration whose height is known to ``sd`` metres everywhere, and heights of units with 2 mm of their own."""
    record = {"origin_to": [*AXIS[0], TOP], "covariance": np.diag([sd**2] * 3 + [0.0] * 4).tolist()}
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("UPDATE epochs SET transformation = ?", (json.dumps(record),))
        connection.execute("UPDATE units SET sd_h = ?", (float(np.hypot(sd, OWN_SD)),))


@pytest.fixture(scope="module")
def harbour(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, np.ndarray]:
    """Three rows of units along two arms, 60 m apart, and the end between them; and the first and last unit of the middle row."""
    path = tmp_path_factory.mktemp("harbour") / "result.gpkg"
    line = np.array([[0.0, 0.0], [60.0, 0.0], [60.0, 60.0], [0.0, 60.0]])
    units, middle = [], []
    for part in range(3):
        heading = (line[part + 1] - line[part]) / 60.0
        for k, row in np.ndindex(22, 3):
            place = AXIS[0] + line[part] + (2.0 + 2.6 * k) * heading + 2.6 * (row - 1) * np.array([-heading[1], heading[0]])
            units.append(
                SyntheticUnit(f"U{part}{k:02d}{row}", "stable", np.tile([*place, TOP], (2, 1)), np.tile([0.0, 0.0, 0.0, 1.0], (2, 1)))
            )
            middle.append(place)
    write_result(path, epochs=2, units=units)
    return path, np.array([middle[1], middle[-2]])


def test_sections_of_a_harbour_cut_one_arm_each(harbour: tuple[Path, np.ndarray]) -> None:
    found = profiles(harbour[0], step=9.0)
    for plane in found.planes:
        own = [row["geometry"] for row in found.sections if row["along"] == plane.along]
        if not own:
            assert plane is found.planes[-1]
            continue
        assert np.linalg.norm(np.ptp(np.vstack(own)[:, :2], axis=0)) < 15.0
    parts = [{row["unit_id"][1] for row in found.sections if row["along"] == plane.along} for plane in found.planes]
    assert sum(len(own) > 1 for own in parts) <= 4, "of the corners alone"
    assert set.union(*parts) == {"0", "1", "2"}


def test_settlement_is_drawn_at_its_units_whichever_way_the_axis_is_given(harbour: tuple[Path, np.ndarray]) -> None:
    path, (first, _) = harbour
    line = AXIS[0] + np.array([[0.0, 0.0], [60.0, 0.0], [60.0, 60.0], [0.0, 60.0]])
    places = np.array([unit.shape.centre for unit in read_as_built(path, None).units])
    middle = np.array([first[0] + 12.0, first[1], TOP])
    row = {"epoch_from": "a", "epoch_to": "b", "datum": "stable", "along_from": 0.0, "along_to": 20.0, "units": 9, "dh": -0.1, "sd_h": 0.01,
           "significant": True, "geom": middle}  # fmt: skip
    for axis in (centreline(places, ARM_HEIGHTS * HEIGHT), Axis(line), Axis(line[::-1])):
        drawn = settlement_rows([row], axis, TOP)[0]["geometry"]
        assert np.linalg.norm(drawn.mean(axis=0) - middle) < 3.0
        assert np.linalg.norm(drawn[1] - drawn[0]) == pytest.approx(20.0, abs=2.0)


def test_settlement_between_epochs_of_half_a_coast_is_drawn_on_that_half(tmp_path: Path) -> None:
    """The first two epochs begin 30 m after the third: chainage of their stretches is counted from there."""
    path = tmp_path / "result.gpkg"
    far = [unit for unit in make_units(300, 3) if unit.fate == "stable"]
    write_result(path, epochs=3, units=far)
    along = np.array([unit.centres[0, :2] @ [np.cos(0.6), np.sin(0.6)] for unit in far])
    along = along - along.min()
    early = [unit for unit, a in zip(far, along, strict=True) if a > 30.0]
    gone = [unit.unit_id for unit, a in zip(far, along, strict=True) if a <= 30.0]
    places = np.array([unit.centres[0] for unit in early])
    stretches, chainage, length = stretches_of(places, HEIGHT)
    with closing(sqlite3.connect(path)) as connection, connection:
        for label in ("2023-04-09", "2024-04-09"):
            connection.executemany("DELETE FROM units WHERE epoch = ? AND unit_id = ?", [(label, name) for name in gone])
        for k, own in enumerate(stretches):
            connection.execute(
                "INSERT INTO stretches (epoch_from, epoch_to, datum, along_from, along_to, units, dh, sd_h, geom) "
                "VALUES ('2023-04-09', '2024-04-09', 'stable', ?, ?, ?, -0.1, 0.01, ?)",
                (0.5 * k * length, (0.5 * k + 1) * length, len(own), encode_geometry(SRS, "PointZ", places[own].mean(axis=0))),
            )
    found = profiles(path)
    for row, own in zip(found.settlement, stretches, strict=True):
        assert np.linalg.norm(row["geometry"].mean(axis=0)[:2] - places[own].mean(axis=0)[:2]) < 3.0
        assert row["along_from"] <= chainage[own].min() + 1e-6


def test_curves_of_a_cut_lie_on_the_body_and_in_the_plane() -> None:
    unit = make_units(1, 1)[0]
    shape = read_shape(unit)
    for distance in (-1.2, -0.4, 0.0, 0.3, 0.9):
        heading = np.array([0.8, 0.6])
        plane = CutPlane(shape.centre[:2] + distance * heading, heading, 0.0)
        curves = cut_body(shape, plane, 48)
        assert curves
        for curve in curves:
            assert (curve[0] == curve[-1]).all()
            assert np.abs((curve[:, :2] - plane.place) @ heading).max() < 1e-6
            away = curve - shape.centre
            length = np.linalg.norm(away, axis=1)
            # chords of a leg with 48 faces lie at most 1.3 mm inside
            assert np.abs(length - reach(away / length[:, None], shape)).max() < 0.01
    assert cut_body(shape, CutPlane(shape.centre[:2] + np.array([reach_of(shape) + 0.01, 0.0]), np.array([1.0, 0.0]), 0.0)) == []


def read_shape(unit: SyntheticUnit):
    from synthetic_result import GRADIENT, LEG_LENGTH, LEGS, RADIUS
    from tetratrack.core.model.outline import PlacedShape, rotation_of_quaternion

    return PlacedShape(
        centre=unit.centres[0],
        rotation=rotation_of_quaternion(unit.quaternions[0]),
        radius=RADIUS,
        gradient=GRADIENT,
        leg_length=LEG_LENGTH,
        legs=LEGS,
    )


def test_crest_height_width_and_change_are_those_of_the_construction(crest: Path) -> None:
    found = profiles(crest, axis=AXIS, step=6.0)
    shape = read_as_built(crest).units[0].shape
    top = float(reach(np.array([0.0, 0.0, 1.0]), shape))
    assert sum(row["units"] for row in found.crest) == 2 * 4 * 12, "those on a border in one reach alone"
    by_epoch = {label: [row for row in found.crest if row["epoch"] == label] for label in found.epochs}
    early, late = (by_epoch[label] for label in found.epochs)
    assert [row["crest_height"] for row in early] == pytest.approx([TOP - 0.644 * HEIGHT + top] * len(early), abs=1e-3)
    width = early[0]["crest_width"]
    outline = max(abs(leg[1]) for leg in shape.legs @ shape.rotation.T) * shape.leg_length
    assert 3 * 1.7 + 2 * outline < width < 3 * 1.7 + 2 * reach_of(shape)
    assert early[0]["change"] is None
    assert late[0]["change"] == pytest.approx(0.0, abs=1e-3)
    assert late[-1]["change"] == pytest.approx(SETTLED, abs=1e-3)
    # what is common to all units of a crest does not become less with their number
    assert [row["sd"] for row in early] == pytest.approx([np.hypot(FRAME_SD, OWN_SD / np.sqrt(row["units"])) for row in early], rel=1e-6)
    assert late[0]["sd_change"] == pytest.approx(np.hypot(FRAME_SD * np.sqrt(2), OWN_SD * np.sqrt(2 / late[0]["units"])), rel=1e-6)


def test_what_both_frames_share_is_not_in_the_change_of_the_crest(crest: Path, tmp_path: Path) -> None:
    path = tmp_path / "result.gpkg"
    shutil.copy(crest, path)
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("UPDATE displacements_other SET sd_h = 0.003")
    before, after = profiles(path, axis=AXIS, step=6.0).crest[:2]
    assert before["sd"] == pytest.approx(np.hypot(FRAME_SD, OWN_SD / np.sqrt(before["units"])), rel=1e-6)
    assert after["sd_change"] == pytest.approx(0.003, rel=1e-6)


def test_bent_frame_takes_the_place_of_the_registration_in_the_crest(crest: Path, tmp_path: Path) -> None:
    path = tmp_path / "result.gpkg"
    shutil.copy(crest, path)
    own = [row for row in read_layer_rows(path, "units") if row["geom"] is not None]
    with closing(sqlite3.connect(path)) as connection, connection:
        for place in (own[0]["geom"], own[-1]["geom"]):
            connection.execute(
                "INSERT INTO frame_errors (epoch, known_by, along, sd_h, geom) VALUES (?, 'targets', 0, 0.004, ?)",
                (own[0]["epoch"], encode_geometry(SRS, "PointZ", place)),
            )
        connection.execute("UPDATE units SET sd_h = 0.005")
    first = profiles(path, axis=AXIS, step=6.0).crest[0]
    assert first["sd"] == pytest.approx(np.hypot(0.004, 0.003 / np.sqrt(first["units"])), rel=1e-6)


def test_the_crest_holds_what_strips_have_in_common_of_earlier_versions_too(crest: Path, tmp_path: Path) -> None:
    """They have not said how far the mean offset is known: the offsets tell."""
    path = tmp_path / "result.gpkg"
    shutil.copy(crest, path)
    offsets = np.array([[0.004, 0.0, 0.008], [-0.004, 0.0, -0.008]])
    common = np.sqrt(np.sum(offsets**2) / 3 / 2)
    told = {"source_offsets_m": dict(enumerate(offsets.tolist()))}
    for known in ({}, {"mean_offset_sd_m": None}, {"mean_offset_sd_m": common}):
        with closing(sqlite3.connect(path)) as connection, connection:
            (settings,) = connection.execute("SELECT settings FROM epochs").fetchone()
            connection.execute("UPDATE epochs SET settings = ?", (json.dumps(json.loads(settings or "{}") | told | known),))
            connection.execute("UPDATE units SET sd_h = ?", (float(np.sqrt(FRAME_SD**2 + common**2 + OWN_SD**2)),))
        first = profiles(path, axis=AXIS, step=6.0).crest[0]
        assert first["sd"] == pytest.approx(np.sqrt(FRAME_SD**2 + common**2 + OWN_SD**2 / first["units"]), rel=1e-6)


def test_damaged_records_of_a_registration_end_the_crest_in_a_sentence(crest: Path, tmp_path: Path) -> None:
    path = tmp_path / "result.gpkg"
    shutil.copy(crest, path)
    record = read_layer_rows(path, "epochs")[0]["transformation"]
    faults = {
        "damaged transformation: 'covariance'": {"covariance": [1.0, 2.0]},
        "damaged transformation: 'origin_to'": {"origin_to": "here"},
    }
    for words, fault in faults.items():
        with closing(sqlite3.connect(path)) as connection, connection:
            connection.execute("UPDATE epochs SET transformation = ?", (json.dumps(json.loads(record) | fault),))
        with pytest.raises(InputError, match=words):
            profiles(path, axis=AXIS, step=6.0)
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("UPDATE epochs SET transformation = ?, settings = ?", (record, json.dumps({"mean_drift_sds_m": None})))
    with pytest.raises(InputError, match=r"result\.gpkg: holds something that cannot be used"):
        profiles(path, axis=AXIS, step=6.0)


def test_units_that_were_not_adjusted_count_for_the_crest_where_nothing_else_does(crest: Path, tmp_path: Path) -> None:
    path = tmp_path / "result.gpkg"
    shutil.copy(crest, path)
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("UPDATE units SET sd_h = NULL WHERE unit_id LIKE 'U00%'")
    whole, found = profiles(crest, axis=AXIS, step=6.0).crest, profiles(path, axis=AXIS, step=6.0).crest
    assert found[0]["units"] == whole[0]["units"] * 3 // 4
    assert found[0]["sd"] == pytest.approx(np.hypot(FRAME_SD, OWN_SD / np.sqrt(found[0]["units"])), rel=1e-6)
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("UPDATE units SET sd_h = NULL")
    unknown = profiles(path, axis=AXIS, step=6.0).crest
    assert [row["crest_height"] for row in unknown] == [row["crest_height"] for row in whole]
    assert {row["sd"] for row in unknown} == {None}
    assert unknown[1]["sd_change"] == pytest.approx(CENTRE_SD[2] * np.sqrt(2) * 2, rel=1e-6), "of displacements"
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("DELETE FROM displacements_other")
    assert profiles(path, axis=AXIS, step=6.0).crest[1]["sd_change"] is None


def test_sections_hold_blocks_points_and_design_of_every_epoch(crest: Path, tmp_path: Path) -> None:
    design = tmp_path / "design.gpkg"
    line = shapely.LineString([(AXIS[0, 0] + 5, AXIS[0, 1] - 3, TOP), (AXIS[0, 0] + 5, AXIS[0, 1] + 6, TOP)])
    geopandas.GeoDataFrame(geometry=[line], crs=f"EPSG:{SRS}").to_file(design, driver="GPKG")
    output = tmp_path / "profiles.gpkg"
    found = write_profiles(crest, output, axis=AXIS, step=6.0, profile=str(design))
    assert found.has_points
    rows = geopandas.read_file(output, layer="sections")
    assert set(rows["kind"]) == {"blocks", "points", "design"}
    assert set(rows["section"]) == {1, 2, 3, 4}
    assert rows[rows["kind"] != "design"].groupby("section")["epoch"].nunique().eq(2).all()
    heights = np.concatenate([shapely.get_coordinates(g, include_z=True)[:, 2] for g in rows[rows["kind"] == "design"].geometry])
    assert heights == pytest.approx(TOP, abs=1e-6)
    # points lie on blocks: their surface is nowhere above the highest block, but for noise
    tops = np.concatenate([shapely.get_coordinates(g, include_z=True)[:, 2] for g in rows[rows["kind"] == "points"].geometry])
    assert tops.max() < TOP + 0.1
    assert len(geopandas.read_file(output, layer="crest")) == 8
    with pytest.raises(InputError, match="distance of sections"):
        profiles(crest, step=0.0)


def test_points_less_blocks(crest: Path, tmp_path: Path) -> None:
    output = tmp_path / "residuals.laz"
    told = write_residual_cloud(crest, output)
    cloud = laspy.read(output)
    assert len(cloud.points) == told.points > 10_000
    assert cloud.header.parse_crs().to_epsg() == SRS
    near = np.abs(np.asarray(cloud.distance)) < 0.05
    # points were drawn with 5 mm noise on the blocks
    assert near.mean() > 0.95
    assert np.median(np.abs(np.asarray(cloud.distance)[near])) == pytest.approx(0.6745 * 0.005, rel=0.3)
    assert set(np.unique(cloud.unit)) <= set(range(61))
    outside, inside = np.asarray(cloud.distance) > 0.004, np.asarray(cloud.distance) < -0.004
    assert (cloud.red[outside] >= cloud.blue[outside]).all()
    assert (cloud.blue[inside] >= cloud.red[inside]).all()
    other = tmp_path / "other.gpkg"
    write_result(other, 20, 2)
    with pytest.raises(InputError, match="no point index"):
        write_residual_cloud(other, tmp_path / "a.laz")


def test_sections_and_residuals_of_a_model_are_those_of_the_structure(crest: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    scale, small = 0.05, tmp_path / "model.gpkg"
    design = np.array([[5.0, -3.0, 0.0], [5.0, 6.0, 0.0]])
    for name in ("HEIGHT", "RADIUS", "LEG_LENGTH"):
        monkeypatch.setattr(synthetic_result, name, scale * getattr(synthetic_result, name))
    write_crest(small, scale)
    counts, shares = [], []
    for path, factor in ((crest, 1.0), (small, scale)):
        lines = tmp_path / f"design {factor}.gpkg"
        line = shapely.LineString(factor * design + np.array([*AXIS[0], TOP]))
        geopandas.GeoDataFrame(geometry=[line], crs=f"EPSG:{SRS}").to_file(lines, driver="GPKG")
        found = write_profiles(path, tmp_path / f"sections {factor}.gpkg", axis=AXIS, step=6.0 * factor, profile=str(lines))
        of_kind = {kind: [row["geometry"] for row in found.sections if row["kind"] == kind] for kind in ("points", "design")}
        counts.append([len(of_kind["points"]), *(len(np.vstack(of_kind[kind])) for kind in ("points", "design"))])
        told = write_residual_cloud(path, tmp_path / "residuals.laz")
        cloud = laspy.read(tmp_path / "residuals.laz")
        assert told.median == pytest.approx(0.6745 * 0.005 * factor, rel=0.3)
        assert max(cloud.header.scales) <= 1e-3 * min(1.0, HEIGHT * factor)
        shares.append([told.near / told.points, float(np.mean(cloud.red)) / 65_535, float(np.mean(cloud.blue)) / 65_535])
    # walls of few points end a line sooner or later
    assert counts[1] == pytest.approx(counts[0], rel=0.15)
    assert shares[1] == pytest.approx(shares[0], abs=0.01)


def test_an_axis_with_a_corner() -> None:
    axis = Axis(np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]]))
    along, offset = axis.locate(np.array([[5.0, 2.0, 0], [12.0, 5.0, 0], [-3.0, -1.0, 0], [8.0, 14.0, 0]]))
    assert along == pytest.approx([5.0, 15.0, -3.0, 24.0])
    assert offset == pytest.approx([2.0, -2.0, -1.0, 2.0])
    place, heading = axis.frame(24.0)
    assert place == pytest.approx([10.0, 14.0])
    assert heading == pytest.approx([0.0, 1.0])
