"""Simulated surveys: files, truth and clouds agree with each other, and the same plan gives the same survey."""

from __future__ import annotations

import csv
import hashlib
import re
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("open3d")
pytest.importorskip("mujoco")

import laspy
from scipy.spatial import cKDTree
from tetratrack.core.common.arrays import FloatArray
from tetratrack.core.data.point_tables import read_control, read_targets
from tetratrack.core.data.survey import Survey
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.data.trajectory import BeamNoise
from tetratrack.core.model.feature_points import body_features
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate, sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.registration.control import register
from tetratrack.core.simulation.armour_pile import Changes, PiledUnit, Site, deepest_overlap, settle
from tetratrack.core.simulation.survey_plan import SimulationPlan
from tetratrack.core.simulation.virtual_instruments import INSTRUMENTS, SENSOR_FILES
from tetratrack.core.simulation.virtual_scanner import survey_photogrammetry
from tetratrack.core.simulation.virtual_scene import Scene, Surfaces
from tetratrack.core.simulation.virtual_survey import simulate_survey

PLANS = {
    "uav": SimulationPlan(
        "small", "uav", 4, 2.3, seed=3, density=250, changes=Changes(moved=1), tiles=(2, 1), origin=(512000.0, 5_712_000.0, 0.0)
    ),
    "tls": SimulationPlan("small", "tls", 3, 2.0, seed=4, density=150, epochs=1, tiles=(1, 1)),
    "photogrammetry": SimulationPlan("small", "photogrammetry", 3, 2.0, seed=5, density=250, epochs=1, tiles=(1, 1)),
    "depth_camera": SimulationPlan(
        "small", "depth_camera", 3, 0.105, seed=6, density=60_000, crs="LOCAL", origin=(1.0, 1.8, 0.75), tiles=(1, 1)
    ),
}


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


@pytest.fixture(scope="module", params=list(PLANS))
def survey(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[SimulationPlan, Survey]:
    plan = PLANS[request.param]
    path = simulate_survey(plan, tmp_path_factory.mktemp(request.param) / "survey")
    return plan, read_survey(path)


def test_points_of_a_unit_lie_on_it_once_registered(survey: tuple[SimulationPlan, Survey]) -> None:
    """Tiles, targets, control, labels and poses tell one story: distances to the true surface are noise, roughness and offsets."""
    plan, site = survey
    truth = rows(site.path.parent / "truth" / "units.csv")
    for epoch in site.epochs:
        assert epoch.control is not None
        assert epoch.targets is not None
        move = register(read_control(epoch.control), read_targets(epoch.targets)).transformation
        distances = []
        with np.load(site.path.parent / "truth" / f"labels_{epoch.label}.npz") as labels:
            for tile in epoch.tiles:
                las = laspy.read(tile)
                assert set(np.unique(las.classification)) == {1}
                assert las.header.version.minor == 4
                assert las.header.point_format.id == 6
                points = np.column_stack([las.x, las.y, las.z])
                mine = labels[tile.stem]
                assert len(mine) == len(points)
                for row in truth:
                    own = points[mine == int(row["unit_id"][1:])]
                    if row["epoch"] != epoch.label or row["status"] == "removed" or not len(own):
                        continue
                    pose = Pose.from_quaternion([float(row[k]) for k in "ENH"], [float(row[k]) for k in ("qx", "qy", "qz", "qw")])
                    unit = UnitType.tetrapod(float(row["height"]))
                    distances.append(relate(pose.to_body(move.apply(own)), unit).distance)
        residuals = np.concatenate(distances)
        # noise and offset of the instrument, target errors in the registration, roughness
        scale = 0.004 if plan.laboratory else 0.035
        assert np.abs(np.median(residuals)) < scale
        assert 1.4826 * np.median(np.abs(residuals - np.median(residuals))) < scale


def test_sensor_positions_are_those_the_points_were_measured_from(survey: tuple[SimulationPlan, Survey]) -> None:
    plan, site = survey
    if plan.instrument not in SENSOR_FILES:
        assert not [*site.path.parent.glob("trajectory*"), *site.path.parent.glob("stations*")]
        return
    proposed = site.path.with_name("by_beam.toml")
    proposed.write_text(re.sub("^# ", "", site.path.read_text(encoding="utf-8"), flags=re.MULTILINE), encoding="utf-8")
    azimuth = np.radians(plan.azimuth_deg)
    for epoch in read_survey(proposed).epochs:
        assert epoch.range_sd == INSTRUMENTS[plan.instrument].noise
        assert epoch.angle_sd is not None
        beams = BeamNoise(epoch.range_sd, np.radians(epoch.angle_sd), epoch.trajectory, epoch.stations, (epoch.label,))
        for tile in epoch.tiles:
            las = laspy.read(tile)
            away = beams.sensors(np.asarray(las.point_source_id), np.asarray(las.gps_time)) - np.asarray(las.xyz)
            if plan.instrument == "uav":
                # the profiler scans across its line: what is not a stray or a second return lies in the plane of its scan
                along = away[:, 0] * np.cos(azimuth) - away[:, 1] * np.sin(azimuth)
                assert np.median(np.abs(along)) < 0.1
                assert np.mean(np.abs(along) < 0.5) > 0.98
            else:
                # each of five tripods has measured its surroundings; a stray may be anywhere
                near = np.linalg.norm(away, axis=1) < 0.5
                assert len(np.unique(las.point_source_id)) == 5
                assert np.mean(near) < 1e-3


def test_truth_is_complete_and_consistent(survey: tuple[SimulationPlan, Survey]) -> None:
    plan, site = survey
    truth = site.path.parent / "truth"
    units = {(r["unit_id"], r["epoch"]): r for r in rows(truth / "units.csv")}
    assert {e for _, e in units} == {epoch.label for epoch in site.epochs}
    assert sum(e == site.epochs[0].label for _, e in units) == plan.units
    counts: dict[int, int] = {}
    with np.load(truth / f"labels_{site.epochs[0].label}.npz") as labels:
        for values in labels.values():
            for number, n in zip(*np.unique(values, return_counts=True), strict=True):
                counts[int(number)] = counts.get(int(number), 0) + int(n)
    for (unit_id, epoch), row in units.items():
        if epoch == site.epochs[0].label:
            assert int(row["n_points"]) == counts.get(int(unit_id[1:]), 0)
        legs = [float(row[f"leg{k}_points"]) for k in range(1, 5)]
        assert sum(legs) <= int(row["n_points"])
        assert all((points > 0) == (float(row[f"leg{k + 1}_seen"]) > 0) for k, points in enumerate(legs))
        assert (row["broken_leg"] == "0") == (row["broken"] == "0") == (float(row["leg_missing"]) == 0)
    for row in rows(truth / "feature_points.csv"):
        unit = units[row["unit_id"], row["epoch"]]
        pose = Pose.from_quaternion([float(unit[k]) for k in "ENH"], [float(unit[k]) for k in ("qx", "qy", "qz", "qw")])
        body = body_features(UnitType.tetrapod(float(unit["height"])))[["centre", "f123", "f124", "f134", "f234"].index(row["feature"])]
        assert np.allclose(pose.to_frame(body), [float(row[k]) for k in "ENH"], atol=2e-5 * plan.height + 2e-5)
    for row in rows(truth / "displacements.csv"):
        a, b = (np.array([float(units[row["unit_id"], row[k]][c]) for c in "ENH"]) for k in ("epoch_from", "epoch_to"))
        assert np.allclose(b - a, [float(row[k]) for k in ("de", "dn", "dh")], atol=2e-5)
        assert (float(row["d_3d"]) > 0) == (row["moved"] == "1")


def test_check_points_keep_their_names_and_lie_on_true_feature_points(survey: tuple[SimulationPlan, Survey]) -> None:
    plan, site = survey
    sd = 0.0002 if plan.laboratory else 0.003
    features = rows(site.path.parent / "truth" / "feature_points.csv")
    for epoch in site.epochs:
        assert epoch.check is not None
        known = np.array([[float(r[k]) for k in "ENH"] for r in features if r["epoch"] == epoch.label])
        points = rows(epoch.check)
        assert points
        assert len({r["point_id"] for r in points}) == len(points)
        for r in points:
            gap = np.linalg.norm(known - [float(r[k]) for k in ("easting", "northing", "height")], axis=1).min()
            assert gap < 5 * sd


def test_the_same_plan_gives_the_same_survey(tmp_path: Path) -> None:
    plan = PLANS["uav"]
    digests = []
    for run in ("a", "b"):
        folder = simulate_survey(plan, tmp_path / run).parent
        files = sorted(p for p in folder.rglob("*") if p.suffix in (".laz", ".csv", ".toml"))
        digests.append([(str(p.relative_to(folder)), hashlib.sha256(p.read_bytes()).hexdigest()) for p in files])
    assert digests[0] == digests[1]
    assert len(digests[0]) > 8


def test_a_coast_without_units_has_no_unit_points(tmp_path: Path) -> None:
    folder = simulate_survey(SimulationPlan("bare", units=0, epochs=1, density=60, tiles=(1, 1)), tmp_path / "bare").parent
    with np.load(folder / "truth" / f"labels_{read_survey(folder / 'survey.toml').epochs[0].label}.npz") as labels:
        values = np.concatenate(list(labels.values()))
    assert {-1, -3} <= set(values.tolist())
    assert values.max() < 0
    assert rows(folder / "truth" / "units.csv") == []


def test_images_of_another_epoch_err_otherwise() -> None:
    """What dense matching makes of a unit at rest does not come again with the next images: displacements hold the errors of both."""
    unit, site = UnitType.tetrapod(2.0), Site.of_height(2.0, 3, parapet=True)
    pile = settle(unit, site, 3, np.random.default_rng(8))
    smooth = Surfaces(roughness=0.0, fillet=0.0, chamfer=0.0, growth=0.0)

    def errors(epoch: int, seed: int) -> tuple[cKDTree, FloatArray]:
        scene = Scene(pile, unit, site, smooth, seed=8, epoch=epoch)
        cloud = survey_photogrammetry(scene, np.random.default_rng(seed), density=250, noise=0.007, offset=0.0)
        points = [u.pose.to_body(cloud.points[cloud.labels == u.number]) for u in pile]
        distances = np.concatenate([relate(p, u.shape(unit)).distance for u, p in zip(pile, points, strict=True)])
        return cKDTree(np.vstack([u.pose.to_frame(p) for u, p in zip(pile, points, strict=True)])), distances

    first, one = errors(0, seed=1)

    def likeness(epoch: int, seed: int) -> float:
        tree, there = errors(epoch, seed)
        apart, nearest = tree.query(first.data)
        near = (apart < 0.05) & (np.abs(one) < 0.03) & (np.abs(there[nearest]) < 0.03)
        assert near.sum() > 500
        return float(np.corrcoef(one[near], there[nearest[near]])[0, 1])

    assert likeness(0, seed=2) > 0.5
    assert abs(likeness(1, seed=2)) < 0.25


def test_a_casting_shows_every_station_the_same_surface() -> None:
    """Beams from another station, aimed at what one station sees, meet it there however flat they come in."""
    unit = UnitType.tetrapod(2.0)
    pile = (PiledUnit(7, Pose(np.array([0.0, 3.0, 2.0]), np.eye(3)), 1.0),)
    concrete = Surfaces(roughness=0.003, fillet=0.05, chamfer=0.03, growth=0.0, castings=True)
    scene = Scene(pile, unit, None, concrete, seed=8)
    body, _, _ = sample_surface(unit, 20000, np.random.default_rng(2))
    first, second = np.array([2.0, 12.0, 6.0]), np.array([6.5, 8.0, 2.5])

    def cast(station: FloatArray, aims: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        way = aims - station
        length = np.linalg.norm(way, axis=1)
        reach, label, cosine = scene.cast(np.broadcast_to(station, way.shape), way / length[:, None])
        return np.where(label == 7, reach, np.inf), length, cosine

    aims = pile[0].pose.to_frame(body)
    seen, length, _ = cast(first, aims)
    met = np.abs(seen - length) < 0.2
    points = first + (aims[met] - first) * (seen / length)[met, None]
    again, length, cosine = cast(second, points)
    off = np.abs(again - length)
    # some are hidden from there, by far
    facing = off < 0.1
    grazing = facing & (cosine > 0.25) & (cosine < 0.4)
    assert facing.sum() > 1500
    assert grazing.sum() > 200
    assert np.quantile(off[facing], 0.95) < 0.002
    assert np.quantile(off[grazing] * cosine[grazing], 0.9) < 0.001


def test_few_beams_that_come_in_steeply_pass_beside_a_casting() -> None:
    unit = UnitType.tetrapod(2.0)
    concrete = Surfaces(roughness=0.003, fillet=0.05, chamfer=0.03, growth=0.0, castings=True)
    scene = Scene((PiledUnit(7, Pose(np.zeros(3), np.eye(3)), 1.0),), unit, None, concrete, seed=8)
    across = np.random.default_rng(1).uniform(-1.3, 1.3, (20000, 2))
    start = np.column_stack([across, np.full(len(across), 5.0)])
    reach, label, cosine = scene.cast(start, np.broadcast_to([0.0, 0.0, -1.0], start.shape))
    steep = (label == 7) & (cosine > 0.5)
    assert steep.sum() > 1500
    assert np.isinf(reach[steep]).mean() < 0.06


@pytest.mark.parametrize("castings", [False, True])
def test_a_face_of_fracture_is_seen_where_the_leg_is_broken(castings: bool) -> None:
    unit = UnitType.tetrapod(2.0)
    remaining = 0.6 * unit.leg_length
    pile = (PiledUnit(7, Pose(np.zeros(3), np.eye(3)), 1.0, broken_leg=0, broken_length=remaining),)
    scene = Scene(pile, unit, None, Surfaces(roughness=0.003, fillet=0.05, chamfer=0.03, growth=0.0, castings=castings), seed=8)
    axis = unit.leg_directions[0]
    rng = np.random.default_rng(3)
    across = rng.normal(0, 0.1, (2000, 3))
    across -= (across @ axis)[:, None] * axis
    start = across[np.linalg.norm(across, axis=1) < 0.25] + 3 * axis
    reach, label, _ = scene.cast(start, np.broadcast_to(-axis, start.shape))
    assert (label == 7).all()
    # the plane of the fracture is oblique
    assert (3 - reach) == pytest.approx(remaining, abs=0.2)
    assert np.median(3 - reach) == pytest.approx(remaining, abs=0.03)


def test_a_settled_pile_rests_on_rock_without_interpenetration() -> None:
    unit = UnitType.tetrapod(2.3)
    site = Site.of_height(2.3, 12, parapet=True)
    pile = settle(unit, site, 12, np.random.default_rng(8), broken=1)
    surface = sample_surface(unit, 1500, np.random.default_rng(1))[0]
    assert [u.number for u in pile] == list(range(1, 13))
    assert sum(u.broken_leg >= 0 for u in pile) == 1
    for u in pile:
        others = [v for v in pile if v is not u]
        assert deepest_overlap(u.shape(unit), u.pose, others, unit, surface) < 0.01 * unit.height
        points = u.pose.to_frame(surface * u.scale)
        lift = points[:, 2] - site.rock(points[:, 1])
        assert lift.min() > -0.01 * unit.height
        assert points[:, 1].min() > site.wall - 0.01 * unit.height


def test_the_bundled_samples_can_be_read_and_stay_small(repository: Path) -> None:
    for name in ("sample", "tiny"):
        folder = repository / "tests" / "data" / name
        assert len(read_survey(folder / "survey.toml").epochs) == 2
        assert sum(p.stat().st_size for p in folder.rglob("*") if p.is_file()) < 5_000_000
