"""The paper's simulated clouds and the virtual surveys: what is written must be what it says it is."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial import cKDTree
from tetratrack.core.common.errors import CrsError, InputError, OutputError
from tetratrack.core.data.plausibility import Place, check_scale
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate, sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.simulation.armour_pile import CONTACT_TOLERANCE, Changes, PiledUnit, Site, change, deepest_overlap
from tetratrack.core.simulation.sampled_unit import cloud_of, interlocked_poses, interlocked_rows, single_unit
from tetratrack.core.simulation.survey_plan import SimulationPlan, plan_of

PAPER_UNIT = UnitType.tetrapod(3.608833, radius=1.0, gradient=0.1958, leg_length=2.32409)


def samples(unit: UnitType) -> np.ndarray:
    return sample_surface(unit, 2000, np.random.default_rng(1))[0]


def test_single_unit_lies_on_its_surface() -> None:
    pose = Pose(np.array([1.0, 2.0, 3.0]), np.eye(3)[[1, 2, 0]])
    cloud = single_unit(PAPER_UNIT, 0.0, np.random.default_rng(0), count=1500, pose=pose)
    relation = relate(pose.to_body(cloud.points), PAPER_UNIT)
    assert cloud.points.shape == (1500, 3)
    assert np.abs(relation.distance).max() < 1e-9
    inside_sector = relation.axial < 0.98 * PAPER_UNIT.leg_length
    assert np.array_equal(relation.leg[inside_sector], cloud.leg[inside_sector])
    assert np.bincount(cloud.leg, minlength=4).min() > 300


def test_noise_is_uniform_with_the_stated_half_width() -> None:
    exact = single_unit(PAPER_UNIT, 0.0, np.random.default_rng(3), count=4000)
    noisy = cloud_of(PAPER_UNIT, exact.poses, 0.2, np.random.default_rng(3), count=4000)
    noise = noisy.points - exact.points
    assert np.abs(noise).max() <= 0.2
    assert np.std(noise) == pytest.approx(0.2 / np.sqrt(3), rel=0.02)
    with pytest.raises(ValueError, match="noise"):
        single_unit(PAPER_UNIT, -0.1, np.random.default_rng(0))


def test_fifty_units_interlock_without_overlap() -> None:
    """Fig. 9: two layers; a unit of the upper layer is nearer to the lower than the units of a layer to each other."""
    cloud = interlocked_rows(PAPER_UNIT, 0.05, np.random.default_rng(0), count=20)
    assert len(cloud.poses) == 50
    assert len(cloud.points) == 1000
    assert np.array_equal(np.bincount(cloud.unit_index), np.full(50, 20))
    poses = interlocked_poses(PAPER_UNIT, columns=3)
    pile = [PiledUnit(k + 1, pose, 1.0) for k, pose in enumerate(poses)]
    assert max(deepest_overlap(PAPER_UNIT, u.pose, [v for v in pile if v is not u], PAPER_UNIT, samples(PAPER_UNIT)) for u in pile) == 0
    centres = np.array([p.centre for p in poses])
    across = cKDTree(centres[:9]).query(centres[9:])[0].min()
    assert across < 0.8 * PAPER_UNIT.height < cKDTree(centres[:9]).query(centres[:9], k=2)[0][:, 1].min()


def row_pile(unit: UnitType) -> tuple[tuple[PiledUnit, ...], Site]:
    """Units apart from each other, standing on the bench before the wall."""
    site = Site.of_height(unit.height, 30, parapet=True)
    lift = unit.radius + 0.05
    y = (site.wall + site.bench_end) / 2
    return tuple(
        PiledUnit(k + 1, Pose(np.array([(k - 1.5) * 1.6 * unit.height, y, site.bench + lift]), np.eye(3)), 1.0) for k in range(4)
    ), site


def test_changes_keep_units_apart_and_say_what_happened() -> None:
    unit = UnitType.tetrapod(2.0)
    pile, site = row_pile(unit)
    after, gone = change(pile, unit, site, Changes(moved=2, removed=1, new=1), np.random.default_rng(4), next_number=5)
    status = {u.number: u.status for u in after}
    assert len(gone) == 1
    assert not set(gone) & set(status)
    moved = [u for u in after if u.status == "moved"]
    assert len(moved) == 2
    before = {u.number: u for u in pile}
    for u in moved:
        assert 0.005 * unit.height < np.linalg.norm(u.pose.centre - before[u.number].pose.centre) <= 0.5 * unit.height + 1e-9
    assert all(u.pose is before[u.number].pose for u in after if u.status == "stable")
    for u in after:
        others = [v for v in after if v is not u]
        assert deepest_overlap(u.shape(unit), u.pose, others, unit, samples(unit)) <= CONTACT_TOLERANCE * unit.height + 0.001 * unit.height


@pytest.mark.parametrize(
    ("field", "value"),
    [("instrument", "sonar"), ("name", "a/b"), ("units", -1), ("height", float("nan")), ("epochs", 0), ("noise", 0.0), ("tiles", (0, 1))],
)
def test_a_plan_that_cannot_be_simulated_names_the_field(field: str, value: object) -> None:
    with pytest.raises(InputError) as caught:
        dataclasses.replace(SimulationPlan("x"), **{field: value})
    assert caught.value.where == field
    assert caught.value.remedy


def test_an_existing_folder_or_a_crs_that_a_run_refuses_is_refused(tmp_path: Path) -> None:
    pytest.importorskip("open3d")
    from tetratrack.core.simulation.virtual_survey import simulate_survey

    with pytest.raises(OutputError, match="exists"):
        simulate_survey(SimulationPlan("x", units=0), tmp_path)
    refused = {"EPSG:4326": "geographic", "EPSG:2227": "foot", "EPSG:2053": "west", "EPSG:3857": "1.154 m in crs"}
    for crs, said in refused.items():
        with pytest.raises(CrsError, match=said):
            simulate_survey(SimulationPlan("x", units=0, crs=crs), tmp_path / "new")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("crs", "place"),
    [("EPSG:28992", (143_000, 471_000)), ("EPSG:2193", (1_558_000, 5_493_000)), ("EPSG:32750", (500_000, 3_500_000))],
)
def test_the_site_lies_where_its_grid_is_for_use(crs: str, place: tuple[int, int]):
    """One place for all was none that a national grid can measure."""
    plan = plan_of("uav", "x", units=0, crs=crs)
    assert plan.origin[:2] == place
    check_scale(crs, Place(plan.origin, plan.origin, crs, plan.height), source=Path("survey.toml"))


def test_a_table_without_models_can_be_simulated(tmp_path: Path) -> None:
    pytest.importorskip("open3d")
    from tetratrack.core.simulation.virtual_survey import simulate_survey

    plan = dataclasses.replace(plan_of("depth_camera", "x", units=0), density=20_000)
    survey = read_survey(simulate_survey(plan, tmp_path / "new"))
    assert [len(epoch.tiles) > 0 for epoch in survey.epochs] == [True, True]
