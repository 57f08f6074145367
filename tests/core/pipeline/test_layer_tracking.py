"""Step ``track`` on layers alone: frames that bend, targets and clouds that are not aligned are dealt with as in a whole run."""

from __future__ import annotations

import json
import sqlite3
from collections import Counter
from contextlib import closing
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bent_coast import BentCoast, bent_coast
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation
from tetratrack.core.armour.placement_rows import size_of_type
from tetratrack.core.common.errors import InputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.deformation.fitted_unit import FittedUnit
from tetratrack.core.deformation.target_shifts import TargetShifts
from tetratrack.core.deformation.tracked_epoch import TrackedEpoch
from tetratrack.core.deformation.tracking import track
from tetratrack.core.deformation.unit_clouds import UnitCloud
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.pipeline.layer_tracking import run_track
from tetratrack.core.pipeline.run_options import RunOptions
from tetratrack.core.pipeline.stated_frames import stated_frames
from tetratrack.core.pipeline.unit_input import read_units
from tetratrack.core.pipeline.whole_survey import run_features, run_register
from tetratrack.core.registration.transformation import Transformation
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.core.results.geopackage_writer import from_upper_triangle, upper_triangle, write_result
from tetratrack.core.results.unit_sizes import shape_of

UNIT = UnitType.tetrapod(2.3)
ORIGIN = np.array([500_000.0, 3_500_000.0, 0.0])
TIMES = (datetime(2024, 4, 9, tzinfo=UTC), datetime(2024, 10, 9, tzinfo=UTC))
TURNS = Rotation.random(2000, random_state=np.random.default_rng(8)).as_matrix()


@pytest.fixture(scope="module")
def coast() -> BentCoast:
    return bent_coast(3, length=70.0, density=2.5, station=24.0, longest=120.0)


def poses(coast: BentCoast, epoch: int) -> list[Pose]:
    shifts = coast.displacements if epoch else np.zeros_like(coast.places)
    return [Pose(place + shift, turn) for place, shift, turn in zip(coast.places, shifts, TURNS, strict=False)]


def covariance(coast: BentCoast, k: int) -> np.ndarray:
    total = np.zeros((8, 8))
    total[:3, :3], total[3:6, 3:6] = coast.covariances[k] / 2, np.eye(3) * 0.002**2
    return total


def transformation() -> Transformation:
    return Transformation.identity(ORIGIN)


def unit_rows(coast: BentCoast, motion: Transformation | None = None) -> list[dict[str, Any]]:
    rows = []
    for epoch, time in enumerate(TIMES):
        for k, pose in enumerate(poses(coast, epoch)):
            placed = pose.shifted(ORIGIN)
            placed = placed if motion is None or not epoch else motion.apply_pose(placed)
            qx, qy, qz, qw = (float(v) for v in placed.quaternion())
            rows.append(
                {"unit_id": f"U{k}", "epoch": str(epoch), "epoch_time": time, "unit_type": "tetrapod", "height": UNIT.height,
                 "r0": UNIT.radius, "gradient": UNIT.gradient, "qx": qx, "qy": qy, "qz": qz, "qw": qw, "status": "found", "leg1": "broken",
                 "leg_missing": 0.3,
                 "leg_probability": 0.9, "score": 0.95, "n_points": 1500, "covariance": upper_triangle(covariance(coast, k)),
                 "geometry": placed.centre}
            )  # fmt: skip
    return rows


def registered(coast: BentCoast, path: Path, later: Transformation | None = None) -> Path:
    """What the step ``register`` writes; ``later`` brings the later cloud to control."""
    targets, epochs = [], []
    for epoch, time in enumerate(TIMES):
        record = json.dumps((later if later is not None and epoch else transformation()).as_record())
        settings = json.dumps({"redundancy": 3 * len(coast.targets) - 6})
        epochs.append({"label": str(epoch), "time": time, "points": 0, "transformation": record, "datum": "control", "settings": settings})
        for k, (place, residual) in enumerate(zip(coast.targets, coast.residuals[epoch], strict=True)):
            targets.append(
                {"point_id": f"T{k}", "epoch": str(epoch), "ve": residual[0], "vn": residual[1], "vh": residual[2], "w_max": 1.0,
                 "used": True, "outlier": False, "sd_e": coast.target_sd, "sd_n": coast.target_sd, "sd_h": coast.target_sd,
                 "geometry": place + ORIGIN}
            )  # fmt: skip
    write_result(path, "EPSG:32650", {"control_residuals": targets, "epochs": epochs})
    return path


def tracked(coast: BentCoast) -> list[TrackedEpoch]:
    names = tuple(f"T{k}" for k in range(len(coast.targets)))
    # the step's own reduction point, to which nodes of the field are bound
    base = np.round(np.mean([pose.centre for epoch in range(2) for pose in poses(coast, epoch)], axis=0))
    found = []
    for epoch, time in enumerate(TIMES):
        units = tuple(
            FittedUnit(
                pose=pose.shifted(-base), shape=UNIT, kind=0, certain=True, discs=np.zeros(4, dtype=bool), cloud=UnitCloud.none(),
                covariance=covariance(coast, k)[:6, :6],
            )
            for k, pose in enumerate(poses(coast, epoch))
        )  # fmt: skip
        variances = np.full(coast.targets.shape, coast.target_sd**2)
        targets = TargetShifts(
            ids=names, positions=coast.targets - base, residuals=coast.residuals[epoch], variances=variances,
            surveyed_variances=np.zeros_like(variances),
        )  # fmt: skip
        placed = Transformation.identity(np.zeros(3))
        found.append(
            TrackedEpoch(
                label=str(epoch), time=time, units=units, registration=placed, redundancy=3 * len(names) - 6, targets=targets
            )
        )  # fmt: skip
    return found


def vectors(path: Path, layer: str, datum: str) -> dict[str, np.ndarray]:
    rows = [row for row in read_layer_rows(path, layer) if row["feature"] == "centre" and row["datum"] == datum]
    return {row["unit_id"]: np.array([row["de"], row["dn"], row["dh"], row["sd_e"], row["sd_n"], row["sd_h"]]) for row in rows}


def test_layers_give_what_a_run_gives(coast: BentCoast, tmp_path: Path) -> None:
    write_result(tmp_path / "units.gpkg", "EPSG:32650", {"units": unit_rows(coast)})
    found = run_track(tmp_path / "units.gpkg", [registered(coast, tmp_path / "control.gpkg")], tmp_path / "out.gpkg", Feedback())
    assert found["units"] == len(coast.places)
    whole = track(tracked(coast), [UNIT])
    assert whole.frames is not None
    for layer, datum in (("displacements", "stable"), ("displacements_other", "control")):
        own = vectors(tmp_path / "out.gpkg", layer, datum)
        expected = [motion.motions[datum] for motion in whole.pairs[0].units]
        given = sorted(own.values(), key=tuple)
        wanted = sorted((np.concatenate([m.vectors[0], np.sqrt(np.diag(m.covariances[0]))]) for m in expected), key=tuple)
        assert np.abs(np.array(given) - np.array(wanted)).max() < 1e-5
    assert {row["known_by"] for row in read_layer_rows(tmp_path / "out.gpkg", "frame_errors")} == {"targets", "units"}
    assert {row["datum"] for row in read_layer_rows(tmp_path / "out.gpkg", "stretches")} == {"stable", "control"}
    units = read_layer_rows(tmp_path / "out.gpkg", "units")
    assert all("broken" in (row["leg1"], row["leg2"], row["leg3"], row["leg4"]) for row in units)


@pytest.mark.parametrize("shift", [(3.0, -2.0, 1.5), (0.6, 0.4, 0.2)])
def test_a_turned_cloud_is_aligned_by_its_units(coast: BentCoast, tmp_path: Path, shift: tuple[float, float, float]) -> None:
    motion = Transformation(
        origin_from=ORIGIN, origin_to=ORIGIN, translation=np.array(shift),
        rotation=Rotation.from_euler("z", 4, degrees=True).as_matrix(), scale=1.0, covariance=np.zeros((7, 7)),
    )  # fmt: skip
    write_result(tmp_path / "straight.gpkg", "EPSG:32650", {"units": unit_rows(coast)})
    write_result(tmp_path / "turned.gpkg", "EPSG:32650", {"units": unit_rows(coast, motion)})
    said: list[str] = []
    for name in ("straight", "turned"):
        run_track(tmp_path / f"{name}.gpkg", [], tmp_path / f"{name}_out.gpkg", Feedback(info=said.append))
    assert sum("aligned by" in line and ("turned by 3.9" in line or "turned by 4.0" in line) for line in said) == 1
    first, second = (vectors(tmp_path / f"{name}_out.gpkg", "displacements", "stable") for name in ("straight", "turned"))
    assert first.keys() == second.keys()
    assert np.median([np.linalg.norm(first[name][:3] - second[name][:3]) for name in first]) < 1e-3


def test_a_choice_of_frame_is_checked(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no choice of frame"):
        run_track(tmp_path / "units.gpkg", [], tmp_path / "out.gpkg", Feedback(), "stiff")


def centres(path: Path) -> dict[tuple[str, str], np.ndarray]:
    return {(row["unit_id"], row["epoch"]): row["geom"] for row in read_layer_rows(path, "units") if row["geom"] is not None}


@pytest.fixture(scope="module")
def tracked_once(coast: BentCoast, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path, Path]:
    """Fitted units whose later cloud lies turned by half a degree and 5 cm off, its registration, and the result of tracking them."""
    folder = tmp_path_factory.mktemp("tracked_once")
    motion = Transformation(
        origin_from=ORIGIN, origin_to=ORIGIN, translation=np.array([0.05, -0.03, 0.02]),
        rotation=Rotation.from_euler("z", 0.5, degrees=True).as_matrix(), scale=1.0, covariance=np.zeros((7, 7)),
    )  # fmt: skip
    back = Transformation(
        origin_from=ORIGIN + motion.translation, origin_to=ORIGIN, translation=np.zeros(3), rotation=motion.rotation.T, scale=1.0,
        covariance=np.diag([0.004**2] * 3 + [2e-5**2] * 3 + [0.0]),
    )  # fmt: skip
    write_result(folder / "units.gpkg", "EPSG:32650", {"units": unit_rows(coast, motion)})
    registration = registered(coast, folder / "control.gpkg", back)
    run_track(folder / "units.gpkg", [registration], folder / "out.gpkg", Feedback())
    return folder / "units.gpkg", registration, folder / "out.gpkg"


def test_tracked_units_are_registered_once(tracked_once: tuple[Path, Path, Path], tmp_path: Path) -> None:
    _, registration, first = tracked_once
    assert {row["datum"] for row in read_layer_rows(first, "units")} == {"control"}
    run_track(first, [registration], tmp_path / "second.gpkg", Feedback())
    # a bend that is stated at places loses up to a millimetre on each axis between them (frame_correction), more than it is known
    before, after = centres(first), centres(tmp_path / "second.gpkg")
    assert np.sqrt(np.mean([np.sum((after[key] - before[key]) ** 2) for key in before])) < 3e-3
    for layer, datum in (("displacements", "stable"), ("displacements_other", "control")):
        old, new = vectors(first, layer, datum), vectors(tmp_path / "second.gpkg", layer, datum)
        assert np.sqrt(np.mean([(old[name][:3] - new[name][:3]) ** 2 / old[name][3:] ** 2 for name in old])) < 0.35
        # that error is part of what the second tracking sees of the noise
        assert 0.9 < np.median([new[name][3:] / old[name][3:] for name in old]) < 1.25
    with pytest.raises(InputError, match="in a frame that was bent"):
        run_track(first, [], tmp_path / "third.gpkg", Feedback())


def test_units_of_a_run_are_registered_once(result: Path, tiny: Path, tmp_path: Path) -> None:
    register = run_register(read_survey(tiny / "survey.toml"), tmp_path / "register.gpkg", RunOptions(workers=1), Feedback())
    before = centres(result)
    for registrations in ([], [result], [Path(register["output"])]):
        run_track(result, registrations, tmp_path / "again.gpkg", Feedback())
        # names follow the order of the units in the layer
        places = np.array([place for _, place in sorted(before.items())])
        after = np.array(list(centres(tmp_path / "again.gpkg").values()))
        assert max(np.linalg.norm(places - place, axis=1).min() for place in after) < 1e-6


def test_units_of_the_control_frame_go_back_to_their_cloud(tracked_once: tuple[Path, Path, Path]) -> None:
    fitted, _, first = tracked_once
    frames = stated_frames(first)
    clouds: dict[str, list[np.ndarray]] = {}
    for row in read_layer_rows(fitted, "units"):
        clouds.setdefault(row["epoch"], []).append(row["geom"])
    found = []
    for row in read_layer_rows(first, "units"):
        pose = Pose.from_quaternion(row["geom"], [row[name] for name in ("qx", "qy", "qz", "qw")])
        frame = frames[row["epoch"]]
        assert np.linalg.eigvalsh(frame.own_covariance(pose, from_upper_triangle(row["covariance"])[:6, :6])).min() > 0
        found.append(np.linalg.norm(np.array(clouds[row["epoch"]]) - frame.in_cloud(pose).centre, axis=1).min())
    assert np.sqrt(np.mean(np.square(found))) < 3e-3


def test_a_layer_of_registered_units_alone_is_not_registered_twice(tracked_once: tuple[Path, Path, Path], tmp_path: Path) -> None:
    _, registration, first = tracked_once
    rows = read_units(first)
    for row in rows:
        del row["fid"]
    write_result(tmp_path / "layer.gpkg", "EPSG:32650", {"units": rows})
    # as QGIS writes one layer
    with closing(sqlite3.connect(tmp_path / "layer.gpkg")) as connection, connection:
        for layer in ("feature_points", "displacements", "epochs"):
            connection.execute(f"DROP TABLE {layer}")
            connection.execute("DELETE FROM gpkg_contents WHERE table_name = ?", (layer,))
    with pytest.raises(InputError, match="registered twice"):
        run_track(tmp_path / "layer.gpkg", [registration], tmp_path / "out.gpkg", Feedback())
    run_track(tmp_path / "layer.gpkg", [], tmp_path / "out.gpkg", Feedback())
    before, after = centres(first), centres(tmp_path / "out.gpkg")
    assert max(np.linalg.norm(after[key] - before[key]) for key in before) < 1e-6


def own_types(coast: BentCoast, types: list[UnitType]) -> list[dict[str, Any]]:
    """Rows as fitted, the types taking turns."""
    rows = unit_rows(coast)
    for k, row in enumerate(rows):
        unit = types[int(row["unit_id"][1:]) % len(types)]
        # heights that two surveys of the same units state
        height = unit.height * (1.01 if k % 5 == 0 else 1.0)
        row |= {"unit_type": unit.name, "height": height, "r0": unit.radius, "gradient": unit.gradient}
    return rows


def test_sizes_of_one_name_stay_apart(coast: BentCoast, tmp_path: Path) -> None:
    types = [UnitType.tetrapod(2.3), UnitType.tetrapod(1.15)]
    write_result(tmp_path / "units.gpkg", "EPSG:32650", {"units": own_types(coast, types)})
    run_track(tmp_path / "units.gpkg", [registered(coast, tmp_path / "control.gpkg")], tmp_path / "out.gpkg", Feedback())
    rows = read_layer_rows(tmp_path / "out.gpkg", "units")
    assert {(row["unit_type"], row["height"]) for row in rows} == {("tetrapod 2.3 m", 2.3), ("tetrapod 1.15 m", 1.15)}
    assert Counter(row["r0"] for row in rows) == Counter(types[k % 2].radius for k in range(len(coast.places)) for _ in TIMES)
    places = np.array([row["geom"] for row in rows if row["height"] == 1.15 and row["epoch"] == "0"])
    assert set(cKDTree(coast.places).query(places - ORIGIN)[1] % 2) == {1}
    moved = {row["unit_id"]: row for row in read_layer_rows(tmp_path / "out.gpkg", "displacements") if row["feature"] == "centre"}
    height = {row["unit_id"]: row["height"] for row in rows}
    assert all(row["d_over_h"] == pytest.approx(row["d_3d"] / height[name]) for name, row in moved.items())


def test_the_opening_is_that_of_the_run(coast: BentCoast, tmp_path: Path) -> None:
    unit = UnitType.tetrapod(2.3, opening="paper", leg_length=1.5)
    settings = json.dumps({"unit_types": [asdict(unit)]})
    epochs = [{"label": str(k), "time": time, "points": 0, "settings": settings} for k, time in enumerate(TIMES)]
    tables = {"units": own_types(coast, [unit]), "epochs": epochs, "feature_points": [], "displacements": []}
    write_result(tmp_path / "units.gpkg", "EPSG:32650", tables)
    run_track(tmp_path / "units.gpkg", [], tmp_path / "tracked.gpkg", Feedback())
    for given in ("units", "tracked"):
        run_features(tmp_path / f"{given}.gpkg", tmp_path / "features.gpkg", Feedback(), end_discs=True)
        shapes = [shape_of(row, [size_of_type(unit)]) for row in read_layer_rows(tmp_path / f"{given}.gpkg", "units")]
        ends = np.concatenate([shape.centre + unit.leg_length * shape.legs @ shape.rotation.T for shape in shapes if shape is not None])
        points = read_layer_rows(tmp_path / "features.gpkg", "feature_points")
        discs = np.array([row["geom"] for row in points if row["feature"].startswith("d")])
        assert len(discs) == len(ends)
        assert cKDTree(ends - ORIGIN).query(discs - ORIGIN)[0].max() < 1e-6
    # of the tracked units, by either step
    placed = read_layer_rows(tmp_path / "tracked.gpkg", "feature_points")
    own, joints = (np.array([row["geom"] for row in table if row["feature"].startswith("f")]) for table in (points, placed))
    assert cKDTree(own - ORIGIN).query(joints - ORIGIN)[0].max() < 1e-6
