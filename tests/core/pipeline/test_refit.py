"""The point index from tiles, and a new fit of one unit at a place the user showed."""

from __future__ import annotations

import json
import sqlite3
from contextlib import closing
from dataclasses import asdict, replace
from pathlib import Path

import laspy
import numpy as np
import pytest
from synthetic_result import GRADIENT, HEIGHT, LEG_LENGTH, ORIGIN, RADIUS, SRS, SyntheticUnit, make_units, write_points, write_result
from tetratrack.core.common.errors import InputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.data.trajectory import beam_covariances
from tetratrack.core.model.outline import rotation_of_quaternion
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.pipeline.refit import index_unit_points, refit_unit
from tetratrack.core.registration.transformation import Transformation, transformation_of
from tetratrack.core.results.geopackage_reader import epoch_pairs, read_layer_rows
from tetratrack.core.results.unit_rows import read_details, read_epochs, read_unit_rows
from tetratrack.core.review.corrections import read_edits, set_pose
from tetratrack.core.review.point_index import PointIndex, frames_state, index_folder, index_of, write_index
from tetratrack.core.review.pose_consequences import NewPose


def stable_units(count: int) -> list[SyntheticUnit]:
    return [unit for unit in make_units(3 * count, 2) if unit.fate == "stable"][:count]


def test_refit_finds_the_unit_under_the_click_and_carries_its_displacement(tmp_path: Path) -> None:
    path = tmp_path / "result.gpkg"
    units = write_result(path, epochs=2, units=stable_units(8))
    write_points(path, units, 2, per_unit=2000)
    unit, (pair,) = units[3], epoch_pairs(path)
    truth = next(row for row in read_unit_rows(path, pair, "stable") if row.unit_id == unit.unit_id)
    wrong = NewPose(
        centre=unit.centres[1] + 0.3,
        rotation=rotation_of_quaternion([0, 0, 0, 1]),
        radius=RADIUS,
        gradient=GRADIENT,
        height=HEIGHT,
        sd=np.full(3, 0.004),
        sd_rotation_deg=0.2,
    )
    set_pose(path, unit.unit_id, pair.epoch_to, wrong, editor="A")
    near = unit.centres[1] + np.array([0.2, -0.1, 0.5])
    found = refit_unit(path, unit.unit_id, pair.epoch_to, near, editor="B")
    assert found["n_points"] > 200
    shape = read_details(path, unit.unit_id).shapes[pair.epoch_to]
    assert np.linalg.norm(shape.centre - unit.centres[1]) < 0.005
    turn = shape.rotation.T @ rotation_of_quaternion(unit.quaternions[1])
    assert np.degrees(np.arccos(min((np.trace(turn) - 1) / 2, 1.0))) < 1.0, "legs keep their numbers"
    row = next(row for row in read_unit_rows(path, pair, "stable") if row.unit_id == unit.unit_id)
    np.testing.assert_allclose(row.vector, truth.vector, atol=0.005)
    # the registration's 2 mm are part of the new standard deviations
    unit_row = next(r for r in read_layer_rows(path, "units") if r["unit_id"] == unit.unit_id and r["epoch"] == pair.epoch_to)
    assert 0.002 <= unit_row["sd_e"] < 0.02
    assert [(edit.kind, edit.editor) for edit in read_edits(path)] == [("pose", "A"), ("pose", "B")]


def test_refit_takes_the_size_of_the_units_own_type(tmp_path: Path) -> None:
    path = tmp_path / "result.gpkg"
    units = write_result(path, epochs=2, units=stable_units(3))
    write_points(path, units, 2, per_unit=2000)
    own = UnitType.tetrapod(HEIGHT, radius=RADIUS, gradient=GRADIENT, leg_length=LEG_LENGTH)
    other = UnitType.tetrapod(2 * HEIGHT, name="tetrapod 64 t")

    def record(*types: UnitType) -> None:
        settings = json.dumps({"leg_length": types[0].leg_length, "unit_types": [asdict(kind) for kind in types]})
        with closing(sqlite3.connect(path)) as connection, connection:
            connection.execute("UPDATE epochs SET settings = ?", (settings,))

    record(other, own)
    refit_unit(path, units[1].unit_id, "2024-04-09", units[1].centres[1], editor="A")
    shape = read_details(path, units[1].unit_id).shapes["2024-04-09"]
    assert np.linalg.norm(shape.centre - units[1].centres[1]) < 0.005
    record(other, replace(own, opening="paper"))
    with pytest.raises(InputError, match="opening 'paper'"):
        refit_unit(path, units[1].unit_id, "2024-04-09", units[1].centres[1], editor="A")


def test_refit_states_standard_deviations_as_the_run_does(tmp_path: Path) -> None:
    """Calibrated by the epoch pairs, with registration and the mean offset of the strips, each as recorded."""
    path = tmp_path / "result.gpkg"
    units = write_result(path, epochs=2, units=stable_units(2))
    write_points(path, units, 2, per_unit=2000)
    unit, label = units[1], "2024-04-09"

    def variances() -> np.ndarray:
        refit_unit(path, unit.unit_id, label, unit.centres[1], editor="A")
        row = next(r for r in read_layer_rows(path, "units") if r["unit_id"] == unit.unit_id and r["epoch"] == label)
        return np.array([row["sd_e"], row["sd_n"], row["sd_h"], np.radians(row["sd_rotation_deg"])]) ** 2

    registered = read_epochs(path)[1].transformation
    offsets = np.array([[0.02, -0.01, 0.01], [-0.01, 0.02, 0.0], [-0.01, -0.01, -0.01]])
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("UPDATE epochs SET transformation = NULL")
    adjusted = variances()
    calibration = "UPDATE epoch_pairs SET covariance_factor = 3, covariance_floor = 0.004, rotation_factor = ?, rotation_floor_deg = ?"
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute(calibration, (2.0, 0.1))
    calibrated = np.append(9 * adjusted[:3] + 0.5 * 0.004**2, 4 * adjusted[3] + 3 * 0.5 * np.radians(0.1) ** 2)
    np.testing.assert_allclose(variances(), calibrated, rtol=1e-9)
    with closing(sqlite3.connect(path)) as connection, connection:
        settings = json.dumps({"leg_length": LEG_LENGTH, "source_offsets_m": dict(enumerate(offsets.tolist()))})
        connection.execute("UPDATE epochs SET transformation = ?, settings = ?", (json.dumps(registered), settings))
    common = np.append(np.diag(registered["covariance"])[:3] + np.sum(offsets**2) / 3 / 2 / 3, 3e-8)
    arm = np.linalg.norm(unit.centres[1] - ORIGIN)
    found = variances()
    assert np.all(found >= calibrated + common - 1e-12)
    assert np.all(found <= calibrated + common + np.append(np.full(3, 1e-8 * arm**2 * 1.1), 1e-12))
    # strips without numbers show no offsets, and the run says what it takes their mean for
    with closing(sqlite3.connect(path)) as connection, connection:
        drifts = np.array([0.01, 0.02, 0.005])
        told = {"source_offsets_m": {"0": [0, 0, 0]}, "mean_offset_sd_m": 0.02, "mean_drift_sds_m": drifts.tolist()}
        connection.execute("UPDATE epochs SET settings = ?", (json.dumps({"leg_length": LEG_LENGTH} | told),))
    np.testing.assert_allclose(variances()[:3] - found[:3], drifts**2 + 0.02**2 - np.sum(offsets**2) / 3 / 2 / 3, rtol=1e-6)
    # earlier versions record no calibration of rotations: that of positions stands for it
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute(calibration, (None, None))
    assert variances()[3] == pytest.approx(9 * adjusted[3] + common[3])


def test_a_fault_of_the_program_is_not_said_to_be_the_results(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "result.gpkg"
    units = write_result(path, epochs=2, units=stable_units(3))
    write_points(path, units, 2, per_unit=2000)

    def refit() -> None:
        refit_unit(path, units[1].unit_id, "2024-04-09", units[1].centres[1], editor="A")

    with monkeypatch.context() as changed:
        changed.setattr("tetratrack.core.registration.transformation.Transformation.pose_covariance", lambda: None)
        with pytest.raises(TypeError, match="positional argument"):
            refit()
    # what the result holds still is
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("UPDATE epochs SET settings = ?", (json.dumps({"mean_offset_sd_m": "wide"}),))
    with pytest.raises(InputError, match=r"result\.gpkg: holds something that cannot be used"):
        refit()


def test_click_beside_every_unit_changes_nothing(tmp_path: Path) -> None:
    path = tmp_path / "result.gpkg"
    units = write_result(path, epochs=2, units=stable_units(3))
    write_points(path, units, 2, per_unit=300)
    with pytest.raises(InputError, match="no tetrapod is found"):
        refit_unit(path, units[0].unit_id, "2024-04-09", ORIGIN + np.array([0, 0, 40.0]), editor="A")
    with pytest.raises(InputError, match="no such unit"):
        refit_unit(path, "X", "2024-04-09", ORIGIN, editor="A")
    with pytest.raises(InputError, match="no epoch 1999"):
        refit_unit(path, units[0].unit_id, "1999", ORIGIN, editor="A")
    assert read_edits(path) == []


def test_tiles_are_indexed_in_the_control_frame(tmp_path: Path) -> None:
    path = tmp_path / "result.gpkg"
    units = write_result(path, epochs=2, units=stable_units(4))
    rng = np.random.default_rng(4)
    shift = np.array([0.05, -0.02, 0.03])
    record = json.dumps({**Transformation.identity(ORIGIN).as_record(), "translation_m": shift.tolist()})
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("UPDATE epochs SET transformation = ? WHERE label = '2024-04-09'", (record,))
        connection.execute("UPDATE epochs SET transformation = NULL WHERE label = '2023-04-09'")
    epochs = []
    cloud = np.round(rng.uniform(ORIGIN - 10, ORIGIN + np.array([40, 40, 10]), (40_000, 3)), 3)
    # of the second epoch the scanner's place is known
    station = np.round(ORIGIN + np.array([-30.0, 5.0, 12.0]), 3)
    (tmp_path / "stations.csv").write_text(f"point_source_id,x,y,z\n0,{station[0]},{station[1]},{station[2]}\n", encoding="utf-8")
    beams = 'stations = "stations.csv"\nrange_sd = 0.02\nangle_sd = 0.01\n'
    for label, known in (("2023-04-09", ""), ("2024-04-09", beams)):
        header = laspy.LasHeader(point_format=6, version="1.4")
        header.offsets, header.scales = ORIGIN, [0.001] * 3
        las = laspy.LasData(header)
        las.x, las.y, las.z = cloud.T
        las.write(str(tmp_path / f"{label}.laz"))
        epochs.append(f'[[epoch]]\nlabel = "{label}"\ntime = {label}T02:30:00Z\ntiles = "{label}.laz"\ntiles_crs = "EPSG:{SRS}"\n{known}')
    toml = f'[survey]\nname = "s"\ncrs = "EPSG:{SRS}"\n[unit]\ntype = "tetrapod"\nheight = {HEIGHT}\n' + "".join(epochs)
    (tmp_path / "survey.toml").write_text(toml, encoding="utf-8")
    index_unit_points(read_survey(tmp_path / "survey.toml"), path, Feedback())
    assert index_of(path).state == frames_state(path)
    index = PointIndex(index_folder(path))
    centre = units[0].centres[0]
    for label, moved in (("2023-04-09", cloud), ("2024-04-09", cloud + shift)):
        found = index.read(label, centre, 1.5)
        inside = moved[np.all(np.abs(moved - centre) <= 1.5, axis=1)]
        assert len(found) == len(inside) > 5
        np.testing.assert_allclose(found[np.lexsort(np.round(found, 3).T)], inside[np.lexsort(np.round(inside, 3).T)], atol=1e-3)
    assert index.noise("2023-04-09") is None
    assert index.noise("2024-04-09") == pytest.approx((0.02, np.radians(0.01)))
    found, sensors = index.read_with_sensors("2024-04-09", centre, 1.5)
    np.testing.assert_array_equal(found, index.read("2024-04-09", centre, 1.5))
    np.testing.assert_allclose(sensors, np.tile(station + shift, (len(found), 1)), atol=1e-3)


def test_refit_weights_by_beam_where_the_sensors_are_known(tmp_path: Path) -> None:
    """Noise of 3 cm along the beams and 3 mm across, from the side: sharper than equal weights, and as sharp as it says."""
    path = tmp_path / "result.gpkg"
    units = write_result(path, epochs=2, units=stable_units(6))
    rng = np.random.default_rng(5)
    unit_type = UnitType.tetrapod(HEIGHT, radius=RADIUS, gradient=GRADIENT, leg_length=LEG_LENGTH)
    (pair,) = epoch_pairs(path)
    errors, deviations = np.empty((len(units), 2)), np.empty((len(units), 2))
    for k, unit in enumerate(units):
        pose = Pose(unit.centres[1], rotation_of_quaternion(unit.quaternions[1]))
        body, normals, _ = sample_surface(unit_type, 6000, rng)
        sensor = pose.centre + np.array([9.0, -6.0, 8.0])
        beams = pose.to_frame(body) - sensor
        seen = np.einsum("ij,ij->i", normals @ pose.rotation.T, beams) < -1.0
        exact, beams = pose.to_frame(body)[seen], beams[seen]
        noise = np.linalg.cholesky(beam_covariances(exact, sensor, 0.03, 0.00022))
        points = exact + np.einsum("ijk,ik->ij", noise, rng.normal(size=exact.shape))
        for j, rows in enumerate((points, np.hstack([points, np.tile(sensor, (len(points), 1))]))):
            known = {pair.epoch_to: (0.03, 0.00022)} if j else None
            write_index(index_folder(path), [(pair.epoch_to, "tile", rows)], pose.centre[None], 1.6 * HEIGHT, noise=known)
            refit_unit(path, unit.unit_id, pair.epoch_to, pose.centre, editor="A")
            row = next(r for r in read_layer_rows(path, "units") if r["unit_id"] == unit.unit_id and r["epoch"] == pair.epoch_to)
            errors[k, j] = np.linalg.norm(read_details(path, unit.unit_id).shapes[pair.epoch_to].centre - pose.centre)
            deviations[k, j] = np.linalg.norm([row["sd_e"], row["sd_n"], row["sd_h"]])
    rmse = np.sqrt(np.mean(errors**2, axis=0))
    assert rmse[1] < 0.9 * rmse[0]
    # the registration's 2 mm are part of the deviations, not of these errors
    assert rmse[1] < deviations[:, 1].mean() < deviations[:, 0].mean()


def test_survey_of_another_result_is_refused(tmp_path: Path, repository: Path) -> None:
    path = tmp_path / "result.gpkg"
    write_result(path, epochs=2, units=stable_units(2))
    with pytest.raises(InputError, match="has no epoch 2024-10-09"):
        index_unit_points(read_survey(repository / "tests/data/tiny/survey.toml"), path, Feedback())


def test_transformation_survives_the_record() -> None:
    assert transformation_of({}) is None
    given = Transformation(
        origin_from=np.ones(3),
        origin_to=2 * np.ones(3),
        translation=np.full(3, 0.1),
        rotation=rotation_of_quaternion([0, 0, 0.1, 1]),
        scale=1.0001,
        covariance=np.eye(7),
    )
    found = transformation_of(given.as_record())
    points = np.random.default_rng(0).uniform(0, 50, (10, 3))
    np.testing.assert_allclose(found.apply(points), given.apply(points), atol=1e-9)
    with pytest.raises(InputError, match="without 'scale'"):
        transformation_of({name: value for name, value in given.as_record().items() if name != "scale"})
    with pytest.raises(InputError, match="damaged transformation: 'covariance'"):
        transformation_of(given.as_record() | {"covariance": [1.0, 2.0]})
