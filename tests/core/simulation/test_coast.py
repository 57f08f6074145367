"""Coasts of repeated stretches: one truth, lines and stations that run through, and targets as far apart as asked for."""

from __future__ import annotations

import csv
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("open3d")
pytest.importorskip("mujoco")

import laspy
from tetratrack.core.common.errors import InputError
from tetratrack.core.data.point_tables import read_targets
from tetratrack.core.data.survey import Survey
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate
from tetratrack.core.simulation.bent_frames import FrameErrors, FrameOfEpoch
from tetratrack.core.simulation.coast import STATIONS
from tetratrack.core.simulation.survey_plan import SimulationPlan, plan_of
from tetratrack.core.simulation.virtual_survey import simulate_survey

PLANS = {
    "uav": SimulationPlan(
        "coast", "uav", 4, 2.3, seed=3, density=120, length=20.0, targets_every=12.0, slide=0.1,
        frame=FrameErrors(bend=0.05, shortest=20, longest=40), azimuth_deg=0.0,
    ),
    "tls": SimulationPlan("coast", "tls", 3, 2.3, seed=4, density=60, length=20.0, targets_every=0.0, azimuth_deg=0.0),
}  # fmt: skip


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


@pytest.fixture(scope="module", params=list(PLANS))
def survey(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[SimulationPlan, Survey]:
    plan = PLANS[request.param]
    return plan, read_survey(simulate_survey(plan, tmp_path_factory.mktemp(request.param) / "survey"))


def points_of(survey: Survey, epoch: str) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Points, unit numbers, sources and times of an epoch."""
    parts = []
    with np.load(survey.path.parent / "truth" / f"labels_{epoch}.npz") as labels:
        for name in labels.files:
            las = laspy.read(survey.path.parent / "tiles" / epoch / f"{name}.laz")
            parts.append((np.column_stack([las.x, las.y, las.z]), labels[name], np.array(las.point_source_id), np.array(las.gps_time)))
    points, numbers, sources, times = (np.concatenate(column) for column in zip(*parts, strict=True))
    return points, numbers, sources, times


def test_units_stand_where_truth_has_them_bend_and_registration_removed(survey: tuple[SimulationPlan, Survey]) -> None:
    plan, site = survey
    truth = rows(site.path.parent / "truth" / "units.csv")
    stretches = {row["unit_id"].split("_")[1] for row in truth}
    assert len(stretches) == 3
    for number, epoch in enumerate(site.epochs):
        points, numbers, _, _ = points_of(site, epoch.label)
        distances, shifts = [], []
        for row in truth:
            if row["epoch"] != epoch.label or row["status"] == "removed" or int(row["n_points"]) < 80:
                continue
            unit, stretch = (int(part) for part in row["unit_id"][1:].split("_"))
            own = points[numbers == 1000 * stretch + unit]
            assert abs(len(own) - int(row["n_points"])) <= 0.02 * len(own) + 2
            pose = Pose.from_quaternion([float(row[k]) for k in "ENH"], [float(row[k]) for k in ("qx", "qy", "qz", "qw")])
            # azimuth 0: the coast runs along the easting
            along = np.column_stack([own[:, 0] - plan.origin[0], np.zeros((len(own), 2))])
            half = 3 * 2.3 * 10
            bent = FrameOfEpoch(plan.frame, number, half, plan.seed).at(along) if plan.frame.bend else np.zeros((len(own), 3))
            distances.append(relate(pose.to_body(own - bent), site.units[0].type).distance)
            shifts.append(pose.centre)
        # a shift of the whole cloud of a few centimetres is left
        assert np.median(np.abs(np.concatenate(distances))) < 0.05


def test_lines_run_through_all_stretches_and_stations_stand_in_each(survey: tuple[SimulationPlan, Survey]) -> None:
    plan, site = survey
    points, numbers, sources, times = points_of(site, site.epochs[0].label)
    if plan.instrument == "uav":
        assert set(np.unique(sources)) == {1, 2, 3, 4}
        for source in (1, 2):
            own = sources == source
            # a line is flown from one end to the other
            assert np.corrcoef(times[own], points[own, 0])[0, 1] > 0.99
    else:
        assert set(np.unique(sources // STATIONS)) == {0, 1, 2}
        seen = {source // STATIONS: set(np.unique(numbers[(sources == source) & (numbers > 0)] // 1000)) for source in np.unique(sources)}
        assert any(len(stretches) > 1 for stretches in seen.values())


def test_targets_stand_as_asked_and_the_middle_slides(survey: tuple[SimulationPlan, Survey]) -> None:
    plan, site = survey
    moves = rows(site.path.parent / "truth" / "displacements.csv")
    if plan.targets_every == 0:
        assert all(epoch.control is None and epoch.targets is None for epoch in site.epochs)
        return
    epoch = site.epochs[0]
    assert epoch.targets is not None
    along = np.sort(read_targets(epoch.targets).coordinates[:, 0])
    starts = along[np.flatnonzero(np.diff(along, prepend=-np.inf) > 4)]
    assert np.diff(starts) == pytest.approx(12.0, abs=1.5)
    middle = [row for row in moves if row["unit_id"].endswith("_001")]
    assert all(row["moved"] == "1" for row in middle)
    assert np.median([float(row["dh"]) for row in middle]) == pytest.approx(-0.1 * np.sqrt(0.5), abs=0.02)
    assert np.median([float(row["dn"]) for row in middle]) == pytest.approx(0.1 * np.sqrt(0.5), abs=0.02)
    assert any(row["moved"] == "0" for row in moves if not row["unit_id"].endswith("_001"))


def test_what_cannot_be_a_coast_is_refused() -> None:
    with pytest.raises(InputError, match="coast"):
        SimulationPlan("table", "depth_camera", 4, 0.105, crs="LOCAL", length=10.0)
    with pytest.raises(InputError, match="slide"):
        replace(PLANS["uav"], slide=-1.0)


@pytest.mark.parametrize(("length", "epochs"), [(0.0, 2), (60.0, 1)])
def test_a_slide_needs_a_coast_and_two_epochs(length: float, epochs: int) -> None:
    with pytest.raises(InputError, match="nothing slides"):
        plan_of("uav", "still", units=20, epochs=epochs, length=length, slide=0.1)
