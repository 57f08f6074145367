"""Sensor positions: read with errors that name the line, interpolated, and used to weight a unit's points along and across their beams."""

from __future__ import annotations

import json
import sqlite3
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from las_files import write_las
from scipy.spatial.transform import Rotation
from tetratrack.core.adjustment.adjustment_records import AdjustmentOptions
from tetratrack.core.adjustment.gauss_helmert import adjust
from tetratrack.core.common.errors import InputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.data.trajectory import BeamNoise, beam_covariances, read_stations, read_trajectory
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.pipeline.block_jobs import ROUGHNESS_RATIO, FitJob
from tetratrack.core.pipeline.epoch_plans import plan_survey
from tetratrack.core.pipeline.run_options import RunOptions
from tetratrack.core.pipeline.whole_survey import run_survey

UNIT = UnitType.tetrapod(2.3)
ORIGIN = np.array([500_000.0, 3_500_000.0, 2.0])


def write(path: Path, *lines: str) -> Path:
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def test_positions_lie_on_straight_lines_between_the_given_ones(tmp_path: Path) -> None:
    path = write(tmp_path / "t.csv", "gps_time,x,y,z,roll", "10.0,0,0,50,1", "10.5,2,0,50,1", "11.0,2,4,51,1")
    trajectory = read_trajectory(path)
    expected = [[0, 0, 50], [1, 0, 50], [2, 0, 50], [2, 1, 50.25], [2, 4, 51]]
    assert trajectory.at(np.array([10.0, 10.25, 10.5, 10.625, 11.0])) == pytest.approx(np.array(expected))


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (["gps_time,x,y", "1,2,3"], "line 1: has no column z"),
        (["gps_time,x,y,z", "1,0,0,0", "2,0,zero,0"], "line 3, field y"),
        (["gps_time,x,y,z", "1,0,0,0", "soon,0,0,0"], "line 3, field gps_time: 'soon' is not a number"),
        (["gps_time,x,y,z", "1,0,0,0", "nan,0,0,0"], "line 3, field gps_time"),
        (["gps_time,x,y,z", "1,0,0,0", "2,inf,0,0"], "line 3, field x"),
        (["gps_time,x,y,z", "1,0,0,0", "", "3,0,0,0", "2,0,0,0"], "line 5, field gps_time: GPS time 2.000 is earlier than that of line 4"),
        (["gps_time,x,y,z", "1,0,0,0", "1.0,0,0,1"], "line 3, field gps_time: GPS time 1.000 repeats the time of line 2"),
        (["gps_time,x,y,z", "1,0,0,0"], "holds a single position"),
        (["gps_time,x,y,z"], "holds no points"),
    ],
)
def test_a_trajectory_that_cannot_be_used_is_refused_with_its_line(tmp_path: Path, lines: list[str], message: str) -> None:
    with pytest.raises(InputError, match=r"t\.csv") as caught:
        read_trajectory(write(tmp_path / "t.csv", *lines))
    assert message in str(caught.value)


def test_a_trajectory_says_nothing_beyond_its_ends_and_in_gaps(tmp_path: Path) -> None:
    trajectory = read_trajectory(write(tmp_path / "t.csv", "gps_time,x,y,z", "10,0,0,50", "10.5,2,0,50", "20,9,0,50", "20.5,9,0,50"))
    with pytest.raises(InputError, match=r"does not reach 2 of 3 points of a unit: it covers GPS time 10.000 to 20.500"):
        trajectory.at(np.array([9.0, 10.2, 20.6]))
    with pytest.raises(InputError, match=r"does not reach 2 of 3 points .* they have 20.600 to 20.600"):
        trajectory.at(np.array([np.nan, 10.2, 20.6]))
    with pytest.raises(InputError, match=r"does not reach 1 of 2 points .* they have none"):
        trajectory.at(np.array([10.2, np.nan]))
    with pytest.raises(InputError, match=r"no position between GPS time 10.500 and 20.000"):
        trajectory.at(np.array([10.2, 15.0]))
    # a turn between two flight lines may be cut out
    assert trajectory.at(np.array([10.5, 20.0]))[:, 0] == pytest.approx([2, 9])


def test_stations_go_by_source_id_and_the_trajectory_serves_the_rest(tmp_path: Path) -> None:
    stations = write(tmp_path / "s.csv", "point_source_id,x,y,z", "7,1,2,3", "8,4,5,6")
    trajectory = write(tmp_path / "t.csv", "gps_time,x,y,z", "0,0,0,50", "1,10,0,50")
    both = BeamNoise(0.02, 0.001, trajectory, stations, ("a", "b"))
    ids, times = np.array([8, 1, 7], np.uint16), np.array([99.0, 0.5, 99.0])
    assert both.sensors(ids, times) == pytest.approx(np.array([[4, 5, 6], [5, 0, 50], [1, 2, 3]]))
    with pytest.raises(InputError, match=r"s.csv: has no station for point source ID 1\."):
        replace(both, trajectory=None, checksums=("a",)).sensors(ids, times)


@pytest.mark.parametrize("name", ["65536", "-1", "A", "1.5"])
def test_a_source_id_is_a_whole_number(tmp_path: Path, name: str) -> None:
    with pytest.raises(InputError, match="line 2, field point_source_id"):
        read_stations(write(tmp_path / "s.csv", "point_source_id,x,y,z", f"{name},1,2,3"))


def test_a_job_is_another_with_other_noise_or_another_trajectory() -> None:
    plain = FitJob(Path("segment-x.npz"), (0,), (UNIT,), ((0.0, 0.0),))
    beams = BeamNoise(0.02, 0.001, Path("t.csv"), None, ("sum",))
    jobs = [plain, *(replace(plain, beams=b) for b in (beams, replace(beams, range_sd=0.03), replace(beams, angle_sd=0.002)))]
    jobs.append(replace(plain, beams=replace(beams, checksums=("other",))))
    assert len({job.name for job in jobs}) == 5
    # but not with the place where the file lies
    assert replace(plain, beams=replace(beams, trajectory=Path("elsewhere/t.csv"))).name == jobs[1].name


def measured(
    rng: np.random.Generator, sensor: np.ndarray, range_sd: float, angle_sd: float
) -> tuple[Pose, np.ndarray, np.ndarray, np.ndarray]:
    """Pose, exact points that face the sensor, the same with noise along and across the beams, and legs."""
    pose = Pose(rng.normal(size=3), Rotation.random(random_state=rng).as_matrix())
    body, normals, legs = sample_surface(UNIT, 3000, rng, end_discs=False)
    exact = pose.to_frame(body)
    beams = exact - sensor
    ranges = np.linalg.norm(beams, axis=1, keepdims=True)
    beams /= ranges
    facing = np.sum(normals @ pose.rotation.T * beams, axis=1) < -0.05
    exact, beams = exact[facing], beams[facing]
    across = rng.normal(0, angle_sd, exact.shape) * ranges[facing]
    across -= np.sum(across * beams, axis=1, keepdims=True) * beams
    return pose, exact, exact + beams * rng.normal(0, range_sd, (len(exact), 1)) + across, legs[facing]


def test_weights_by_beam_reach_the_bound_of_range_noise() -> None:
    """Noise of 2 cm along the beams and 3 mm across: 60 units, beside the Cramer-Rao bound of that noise."""
    held = AdjustmentOptions.ideal(radius_sd=0.0, gradient_sd=0.0)
    sensor = np.array([4.0, -8.0, 6.0])
    scaled: dict[str, list[np.ndarray]] = {"aware": [], "blind": []}
    for seed in range(60):
        rng = np.random.default_rng([44, seed])
        pose, exact, noisy, legs = measured(rng, sensor, 0.02, 0.0003)
        covariances = beam_covariances(noisy, sensor, 0.02, 0.0003)
        body = pose.to_body(exact)
        axes = UNIT.leg_directions[legs]
        axial = np.sum(body * axes, axis=1)
        radial = body - axial[:, None] * axes
        radial /= np.linalg.norm(radial, axis=1, keepdims=True)
        normal = (radial + UNIT.gradient * axes) / np.hypot(1, UNIT.gradient)
        rows = np.hstack([-normal @ pose.rotation.T, np.cross(normal, body) @ pose.rotation.T])
        n = normal @ pose.rotation.T
        variance = np.einsum("ij,ijk,ik->i", n, beam_covariances(exact, sensor, 0.02, 0.0003), n)
        bound = np.sqrt(np.diag(np.linalg.inv(rows.T @ (rows / variance[:, None]))))
        for name, given in (("aware", covariances), ("blind", None)):
            result = adjust(noisy, UNIT, pose.perturbed([0.03, -0.02, 0.02], [0.02, 0.01, -0.02]), options=held, covariances=given)
            turn = Rotation.from_matrix(result.pose.rotation @ pose.rotation.T).as_rotvec()
            scaled[name].append(np.concatenate([result.pose.centre - pose.centre, turn]) / bound)
    rmse = {name: float(np.sqrt(np.mean(np.square(values)))) for name, values in scaled.items()}
    # 360 errors over the bound: chance alone gives 0.04
    assert rmse["aware"] < 1.10
    assert rmse["blind"] > 1.10 * rmse["aware"]


@pytest.fixture(scope="module")
def flight(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder of a survey of one rough unit, flown over with 2 cm of range noise, with trajectory and stations."""
    folder = tmp_path_factory.mktemp("flight")
    rng = np.random.default_rng(8)
    times = np.arange(0.0, 20.0, 0.1)
    track = ORIGIN + np.column_stack([times - 10, np.full(len(times), -6.0), np.full(len(times), 9.0)])
    rows = [f"{t + 1000:.4f},{x:.4f},{y:.4f},{z:.4f}" for t, (x, y, z) in zip(times, track, strict=True)]
    write(folder / "trajectory.csv", "gps_time,x,y,z", *rows)
    write(folder / "stations.csv", "point_source_id,x,y,z", f"3,{track[100, 0]},{track[100, 1]},{track[100, 2]}")
    pose = Pose(ORIGIN + np.array([0.0, 0.0, 1.0]), Rotation.random(random_state=rng).as_matrix())
    body, normals, _ = sample_surface(UNIT, 8000, rng)
    exact, outward = pose.to_frame(body), normals @ pose.rotation.T
    when = rng.uniform(0, 19.8, len(exact))
    beams = exact - np.column_stack([np.interp(when, times, track[:, k]) for k in range(3)])
    beams /= np.linalg.norm(beams, axis=1, keepdims=True)
    seen = np.sum(outward * beams, axis=1) < -0.1
    noisy = exact[seen] + beams[seen] * rng.normal(0, 0.02, (seen.sum(), 1))
    noisy += outward[seen] * rng.normal(0, ROUGHNESS_RATIO * UNIT.height, (seen.sum(), 1))
    write_las(folder / "tile.las", noisy, time=when[seen] + 1000, source=np.full(seen.sum(), 3))
    return folder


def calibrated(path: Path) -> dict[str, object]:
    """What calibration found in a survey that asks for it."""
    text = path.read_text(encoding="utf-8").replace("height = 2.3", "height = 2.3\ncalibrate = true")
    path.write_text(text, encoding="utf-8")
    _, record = run(path)
    return record["calibration"]["tetrapod"]  # type: ignore[index,no-any-return]


def survey_file(folder: Path, name: str, *lines: str) -> Path:
    head = ["[survey]", 'name = "flight"', 'crs = "EPSG:32650"', "[unit]", 'type = "tetrapod"', "height = 2.3"]
    epoch = ["[[epoch]]", 'label = "2025-03-14"', "time = 2025-03-14T02:30:00Z", 'tiles = "tile.las"']
    return write(folder / name, *head, *epoch, *lines)


def run(path: Path) -> tuple[dict[str, float], dict[str, object]]:
    """Row of the only unit of a survey's result, and the record of its epoch."""
    output = path.with_suffix(".gpkg")
    run_survey(read_survey(path), output, RunOptions(workers=1), Feedback())
    with closing(sqlite3.connect(output)) as database:
        database.row_factory = sqlite3.Row
        units = database.execute("SELECT * FROM units").fetchall()
        settings = json.loads(database.execute("SELECT settings FROM epochs").fetchone()[0])
    assert len(units) == 1
    return dict(units[0]), settings


def test_survey_with_a_trajectory_is_weighted_by_beam(flight: Path) -> None:
    noise = ("range_sd = 0.02", "angle_sd = 0.01")
    blind, record = run(survey_file(flight, "blind.toml"))
    flown, flown_record = run(survey_file(flight, "flown.toml", 'trajectory = "trajectory.csv"', *noise))
    stood, _ = run(survey_file(flight, "stood.toml", 'stations = "stations.csv"', *noise))
    # the noise given, with the roughness of concrete, is the noise there is; without it the unit of weight is unknown
    assert flown["sigma0"] == pytest.approx(1.0, abs=0.05)
    assert blind["sigma0"] == pytest.approx(1.0)
    sds = [[row[name] for name in ("sd_e", "sd_n", "sd_h")] for row in (blind, flown)]
    assert np.linalg.norm(sds[1]) < 0.95 * np.linalg.norm(sds[0])
    # stations at the middle of the line are nearly the same, and the unit of weight shows that they are not
    assert 1.05 < stood["sigma0"] < 1.25
    # weights for beams that were not flown cannot be better than those for the ones that were: a sixth worse in height here
    assert 1.0 <= (stood["sd_h"] / stood["sigma0"]) / (flown["sd_h"] / flown["sigma0"]) < 1.2
    inputs = {entry["name"] for entry in flown_record["inputs"]}  # type: ignore[attr-defined]
    assert inputs == {"tile.las", "trajectory.csv"}
    assert (flown_record["range_sd"], flown_record["angle_sd"]) == (0.02, 0.01)
    assert "range_sd" not in record


def test_calibration_knows_the_beams_too(flight: Path) -> None:
    blind = calibrated(survey_file(flight, "blind_shape.toml"))
    flown = calibrated(survey_file(flight, "flown_shape.toml", 'trajectory = "trajectory.csv"', "range_sd = 0.02", "angle_sd = 0.01"))
    radius = UNIT.radius
    assert abs(flown["radius"] - radius) < 4 * flown["sd"][0]  # type: ignore[operator,index]
    assert flown["sd"][0] < 0.95 * blind["sd"][0]  # type: ignore[index]


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (('trajectory = "trajectory.csv"', "angle_sd = 0.01"), "line 11, section epoch: trajectory is given without range_sd"),
        (('stations = "stations.csv"', "range_sd = 0.01"), "line 11, section epoch: stations is given without angle_sd"),
        (("range_sd = 0.02",), "line 11, section epoch: range_sd is given without trajectory or stations"),
        (('trajectory = "no.csv"',), "trajectory: there is no file no.csv"),
        (('trajectory = "trajectory.csv"', "range_sd = 0", "angle_sd = 0.01"), "range_sd must be a number above 0"),
    ],
)
def test_keys_that_do_not_go_together_are_refused(flight: Path, lines: tuple[str, ...], message: str) -> None:
    with pytest.raises(InputError) as caught:
        read_survey(survey_file(flight, "wrong.toml", *lines))
    assert message in str(caught.value)


def test_what_is_wrong_with_a_trajectory_is_said_before_the_work(flight: Path, tmp_path: Path) -> None:
    rows = (flight / "trajectory.csv").read_text(encoding="utf-8").splitlines()
    write(flight / "late.csv", rows[0], *rows[150:])
    noise = ("range_sd = 0.02", "angle_sd = 0.01")
    with pytest.raises(InputError, match=r"late.csv: does not reach \d+ of \d+ points of a unit"):
        run(survey_file(flight, "late.toml", 'trajectory = "late.csv"', *noise))
    write(flight / "unsorted.csv", rows[0], rows[2], rows[1])
    with pytest.raises(InputError, match=r"unsorted.csv, line 3"):
        plan_survey(read_survey(survey_file(flight, "unsorted.toml", 'trajectory = "unsorted.csv"', *noise)))
    write_las(flight / "timeless.las", ORIGIN + np.random.default_rng(0).normal(size=(50, 3)), point_format=0)
    path = survey_file(flight, "timeless.toml", 'trajectory = "trajectory.csv"', *noise)
    path.write_text(path.read_text(encoding="utf-8").replace("tile.las", "timeless.las"), encoding="utf-8")
    with pytest.raises(InputError, match=r"timeless.las: has no GPS time by which trajectory trajectory.csv could be read"):
        plan_survey(read_survey(path))
