"""Finding tetrapods: cones, whole units, verification, aggregation."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.common.neighbourhood import build_grid, gather
from tetratrack.core.common.voxels import thin
from tetratrack.core.model.pose import Pose, rotation_angle
from tetratrack.core.model.tetrapod import relate, sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.aggregation import assign
from tetratrack.core.segmentation.assembly import poses_from_pairs
from tetratrack.core.segmentation.conic_ransac import find_legs
from tetratrack.core.segmentation.pose_evidence import AZIMUTH_CELLS, LAST_OF_TURN, azimuth_cell, evidence
from tetratrack.core.segmentation.pose_refinement import refine
from tetratrack.core.segmentation.pose_score import BRIDGED, NOISY, RICH, SMOOTHED, SPARSE, ScoreModel, TypicalUnit, score, where_bridged
from tetratrack.core.segmentation.scene import CELLS, CLOSE, COLUMNS, MISFIT, REACHED, SUPPORT, Evidence, Scene
from tetratrack.core.segmentation.segment import FEWEST_FOUND_CELLS, FOUND_SCORE, SURE_OF_FEW, fewest_found_cells, least_scores, segment
from tetratrack.core.segmentation.surface_elements import squares_off_quadrics, surface_elements
from tetratrack.core.segmentation.verification import FEWEST_CELLS, overlap, without_copies
from tetratrack.core.simulation.sampled_unit import interlocked_rows

UNIT = UnitType.tetrapod(2.3)


def row(pose: Pose) -> np.ndarray:
    return np.concatenate([pose.centre, pose.rotation.ravel()])


def turned(seed: int, centre=(0.0, 0.0, 0.0)) -> Pose:
    return Pose(np.array(centre, dtype=float), Rotation.random(random_state=seed).as_matrix())


def seen_from_above(pose: Pose, count: int, noise: float, seed: int) -> np.ndarray:
    """Points of the upper side of a unit, with isotropic noise in metres."""
    rng = np.random.default_rng(seed)
    points, normals, _ = sample_surface(UNIT, count, rng)
    up = (normals @ pose.rotation.T)[:, 2] > 0.1
    return pose.to_frame(points[up]) + rng.normal(0, noise, (int(up.sum()), 3))


def angle_to(pose: Pose, truth: Pose) -> float:
    """Degrees between two orientations of the same solid."""
    return float(np.degrees(min(rotation_angle(truth.rotation, pose.relabelled(s).rotation) for s in UNIT.symmetries)))


def test_thinning_keeps_means_and_says_where_points_went():
    points = np.random.default_rng(0).uniform(0, 1, (2000, 3))
    thinned, source = thin(points, 0.25)
    assert source.shape == (2000,)
    assert len(thinned) <= 5**3
    for k in (0, len(thinned) // 2, len(thinned) - 1):
        np.testing.assert_allclose(thinned[k], points[source == k].mean(axis=0), atol=1e-12)


def test_gather_equals_brute_force():
    points = np.random.default_rng(1).uniform(-3, 3, (3000, 3))
    grid = build_grid(points, 0.4)
    active = np.random.default_rng(2).random(3000) < 0.7
    middle = np.array([0.3, -1.0, 2.9])
    near = gather(active, middle, 0.9, grid, 10**6)
    wanted = np.flatnonzero(active & (np.linalg.norm(points - middle, axis=1) <= 0.9))
    assert sorted(near) == sorted(wanted)
    fewer = gather(active, middle, 0.9, grid, 10)
    assert len(fewer) == 10
    assert set(fewer) <= set(wanted)


def test_normals_and_noise_of_a_unit():
    pose = turned(3)
    points = seen_from_above(pose, 30000, 0.01, 4)
    elements = surface_elements(points, UNIT.height)
    relation = relate(pose.to_body(elements.points), UNIT)
    # cones away from joints and rims
    plain = (relation.part == 0) & (relation.axial > 0.35 * UNIT.height) & (relation.axial < 0.55 * UNIT.height)
    cosine = np.einsum("ij,ij->i", relation.normal @ pose.rotation.T, elements.normals)[plain]
    assert np.degrees(np.median(np.arccos(np.clip(np.abs(cosine), 0, 1)))) < 4
    assert (cosine[elements.curved[plain] > 0] > 0).mean() > 0.95
    # smooth neighbourhoods, the lower third, speak for the noise: a tenth below it (eight seeds: 0.00885 to 0.00895)
    assert elements.noise == pytest.approx(0.0089, rel=0.03)
    assert elements.spacing == pytest.approx(0.015, rel=0.04)


def test_squares_off_a_quadric_are_those_of_least_squares_and_none_of_points_on_a_line():
    rng = np.random.default_rng(8)
    points = np.vstack([rng.normal(0, 0.1, (50, 3)) * [1, 1, 0.05], np.outer(np.linspace(0, 1, 25), [1.0, 2.0, -1.0]), np.ones((25, 3))])
    index = np.arange(100).reshape(4, 25)
    squares = np.full(4, np.nan)
    squares_off_quadrics(0, 4, points, index, squares)
    for k in range(2):
        local = points[index[k]] - points[index[k]].mean(axis=0)
        w, u, v = (local @ np.linalg.svd(local)[2][::-1].T).T
        design = np.stack([np.ones_like(u), u, v, u * u, u * v, v * v], axis=-1)
        rest = w - design @ np.linalg.lstsq(design, w, rcond=None)[0]
        assert squares[k] == pytest.approx(rest @ rest, rel=1e-9)
    assert squares[2:] == pytest.approx(0.0, abs=1e-25)


def test_a_wall_is_known_to_be_too_flat_for_a_leg_and_a_leg_is_not():
    rng = np.random.default_rng(21)
    wall = surface_elements(np.column_stack([rng.uniform(0, 6, (40000, 2)), rng.normal(0, 0.005, 40000)]), UNIT.height)
    middle = np.abs(wall.points[:, :2] - 3).max(axis=1) < 2.5
    assert (wall.curved[middle] == -1).mean() > 0.95
    pose = turned(3)
    legs = surface_elements(seen_from_above(pose, 40000, 0.005, 22), UNIT.height)
    axial = relate(pose.to_body(legs.points), UNIT).axial
    plain = (axial > 0.35 * UNIT.height) & (axial < 0.55 * UNIT.height)
    assert (legs.curved[plain] == 1).mean() > 0.9
    # where noise hides the bend nothing is said
    noisy = surface_elements(np.column_stack([rng.uniform(0, 6, (4000, 2)), rng.normal(0, 0.1, 4000)]), UNIT.height)
    assert (noisy.curved == -1).mean() < 0.05


def test_legs_are_found_and_pairs_of_them_give_the_pose():
    pose = turned(5)
    elements = surface_elements(seen_from_above(pose, 20000, 0.005, 6), UNIT.height)
    scene = Scene.of(elements, UNIT, 0.02)
    active = np.ones(len(elements.points), dtype=bool)
    legs = find_legs(scene, active, seed=0)
    best = (legs.axis @ (pose.rotation @ UNIT.leg_directions.T)).max(axis=0)
    assert (np.degrees(np.arccos(best)) < 5).sum() >= 3
    candidates = refine(poses_from_pairs(legs, UNIT), scene, active)
    errors = [np.linalg.norm(c[:3] - pose.centre) for c in candidates if angle_to(Pose(c[:3], c[3:].reshape(3, 3)), pose) < 2]
    assert min(errors) < 0.01


def test_evidence_speaks_for_the_true_pose_and_against_a_shifted_one():
    pose = turned(7)
    elements = surface_elements(seen_from_above(pose, 20000, 0.005, 8), UNIT.height)
    scene = Scene.of(elements, UNIT, 0.02)
    active = np.ones(len(elements.points), dtype=bool)
    shifted = pose.shifted([0, 0, 0.3])
    found = evidence(np.array([row(pose), row(shifted)]), scene, active)
    assert found.inside[0] == 0
    assert found.cells[0] > 30
    assert found.support[0] > 0.8 * len(elements.points)
    assert found.inside[1] > 50
    # one pose at a time takes another path through the code
    single = evidence(row(shifted)[None], scene, active)
    np.testing.assert_array_equal(single.table, found[1].table)


def test_what_disagrees_on_rounded_tips_says_nothing_where_the_noise_lets_them_show():
    pose = turned(7)
    elements = surface_elements(seen_from_above(pose, 20000, 0.005, 8), UNIT.height)
    relation = relate(pose.to_body(elements.points), UNIT)
    tips = relation.axial > 0.9 * UNIT.leg_length
    # normals on the tips as a rounding would have them: 45 degrees towards the end
    axes = UNIT.leg_directions[relation.leg] @ pose.rotation.T
    leaning = relation.normal @ pose.rotation.T + axes
    normals = np.where(tips[:, None], leaning / np.linalg.norm(leaning, axis=1, keepdims=True), elements.normals)
    scene = replace(Scene.of(elements, UNIT, 0.02), normals=normals)
    active = np.ones(len(elements.points), dtype=bool)

    def close(noise: float) -> int:
        return int(evidence(row(pose)[None], replace(scene, noise=noise), active).close[0])

    lateral = tips & (relation.part == 0)
    assert lateral.sum() > 100
    assert close(0.02 * UNIT.height) - close(0.001 * UNIT.height) >= 0.9 * lateral.sum()


def test_overlap_of_solids():
    a = row(Pose(np.zeros(3), np.eye(3)))
    assert overlap(a, a, UNIT) > 0.99
    assert overlap(a, row(Pose(np.array([3 * UNIT.height, 0, 0]), np.eye(3))), UNIT) == 0
    touching = row(Pose(np.array([0.3 * UNIT.height, 0, 0]), np.eye(3)))
    assert 0.1 < overlap(a, touching, UNIT) < 0.9


def test_points_go_to_the_nearest_unit_and_contested_ones_to_none():
    first, second = (
        Pose(np.zeros(3), np.eye(3)),
        Pose(np.array([0.0, 0.0, 2 * UNIT.leg_length + 0.02]), Rotation.from_euler("x", 180, degrees=True).as_matrix()),
    )
    rng = np.random.default_rng(9)
    a, b = (p.to_frame(sample_surface(UNIT, 4000, rng)[0]) for p in (first, second))
    points = np.vstack([a, b, [[9.0, 9.0, 9.0]]])
    poses = np.array([row(first), row(second)])
    labels, distance = assign(points, poses, UNIT, 0.01)
    assert (labels[:4000] == 0).all()
    assert (labels[4000:8000] == 1).all()
    assert labels[8000] == -1
    assert np.abs(distance[:8000]).max() < 1e-9
    assert np.isinf(distance[8000])
    cleared, _ = assign(points, poses, UNIT, 0.01, clearance=0.05)
    dropped = points[:8000][cleared[:8000] < 0]
    # the two end discs that face each other across a gap of 2 cm, and nothing far from them
    assert len(dropped) > 50
    assert np.abs(dropped[:, 2] - UNIT.leg_length - 0.01).max() < 0.1


def test_points_towards_a_neighbour_are_given_up_on_both_sides():
    gap = 0.3
    first = Pose(np.zeros(3), np.eye(3))
    second = Pose(np.array([0.0, 0.0, 2 * UNIT.leg_length + gap]), Rotation.from_euler("x", 180, degrees=True).as_matrix())
    rng = np.random.default_rng(10)
    # points of the middle of the first unit's upper end disc, with noise across it
    offset = rng.uniform(-0.25, 0.25, 2000)
    points = np.column_stack([rng.uniform(-0.05, 0.05, (2000, 2)), UNIT.leg_length + offset])
    labels, _ = assign(points, np.array([row(first), row(second)]), UNIT, 0.5, clearance=0.05)
    kept = offset[labels == 0]
    # the neighbour takes what lies beyond the middle of the gap, and the mirror images of that belong to nobody
    assert kept.max() < gap / 2
    assert kept.min() > -gap / 2
    assert abs(kept.mean()) < 0.01


@pytest.mark.parametrize("noise", [0.01, 0.1])
def test_interlocked_rows_are_found_whole_with_their_points(noise):
    unit = UnitType.tetrapod(3.609)
    cloud = interlocked_rows(unit, noise, np.random.default_rng(10), columns=3, lower_rows=2, upper_rows=1)
    result = segment(cloud.points, unit)
    assert len(result.units) == len(cloud.poses)
    assert all(u.status == "found" and u.score > 0.9 and u.interpenetration < 0.01 for u in result.units)
    centres = np.array([u.pose.centre for u in result.units])
    nearest = [np.linalg.norm(centres - pose.centre, axis=1).min() for pose in cloud.poses]
    assert max(nearest) < 0.05 * unit.height
    assert (result.labels >= 0).mean() > 0.7


def test_same_seed_same_result():
    cloud = interlocked_rows(UNIT, 0.01, np.random.default_rng(11), columns=2, lower_rows=1, upper_rows=1)
    first, second = segment(cloud.points, UNIT, seed=4), segment(cloud.points, UNIT, seed=4)
    np.testing.assert_array_equal(first.labels, second.labels)
    assert [u.pose.centre.tolist() for u in first.units] == [u.pose.centre.tolist() for u in second.units]


def test_walls_rock_and_emptiness_hold_no_units():
    rng = np.random.default_rng(12)
    assert segment(np.zeros((0, 3)), UNIT).units == ()
    deck = np.column_stack([rng.uniform(0, 12, (40000, 2)), rng.normal(0, 0.01, 40000)])
    wall = np.column_stack([rng.uniform(0, 12, 20000), rng.normal(0, 0.01, 20000), rng.uniform(0, 3, 20000)])
    boulders = []
    for _ in range(60):
        direction = rng.normal(size=(600, 3))
        direction /= np.linalg.norm(direction, axis=1, keepdims=True)
        boulders.append(rng.uniform([0, 2, 0], [12, 12, 0.5]) + direction * rng.uniform(0.3, 0.8, 3))
    result = segment(np.vstack([deck, wall, *boulders]), UNIT)
    assert [u for u in result.units if u.status == "found"] == []


def test_score_falls_for_what_no_unit_shows():
    weak = Evidence(np.array([[93.0, 98.0, 0.0, 10.0, 3.0, 0.4, 105.0]]))
    typical = TypicalUnit(misfit=0.4, agreement=0.95)
    assert score(weak, 1.0, typical)[0] > FOUND_SCORE
    scattered, turned = weak.replaced(misfit=0.75), weak.replaced(support=60)
    few = weak.replaced(support=12, close=12, cells=5, reached=12)
    assert (score(Evidence.joined([scattered, few, turned]), 1.0, typical) < FOUND_SCORE).all()


def test_tiny_survey_against_its_truth(repository: Path):
    import csv

    import laspy

    folder = repository / "tests" / "data" / "tiny"
    tiles = sorted((folder / "tiles" / "2024-04-09").glob("*.laz"))
    points = np.vstack([laspy.read(tile).xyz for tile in tiles])
    origin = np.floor(points.mean(axis=0))
    with open(folder / "truth" / "units.csv", newline="") as handle:
        rows = [r for r in csv.DictReader(handle) if r["epoch"] == "2024-04-09" and float(r["visible_area_fraction"]) >= 0.15]
    import tomllib

    survey = tomllib.loads((folder / "survey.toml").read_text())
    unit = UnitType.tetrapod(**{k: v for k, v in survey["unit"].items() if k in ("height", "radius", "gradient", "leg_length")})
    found = [u.pose.centre + origin for u in segment(points - origin, unit).units if u.status == "found"]
    truth = np.array([[float(r[k]) for k in "ENH"] for r in rows])
    # the cloud's registration error is a few centimetres
    assert len(found) >= len(truth)
    assert all(min(np.linalg.norm(c - t) for c in found) < 0.08 * unit.height for t in truth)


def test_blurred_normals_at_creases_of_a_sparse_cloud_do_not_speak_against_a_unit():
    pose = turned(3)

    def judged(count: int, noise: float) -> tuple[float, Evidence, Evidence]:
        elements = surface_elements(seen_from_above(pose, count, noise, seed=5), UNIT.height)
        scene = Scene.of(elements, UNIT, max(2.5 * elements.element_noise, 0.008 * UNIT.height))
        every = np.ones(len(elements.points), dtype=bool)
        rows = [evidence(row(pose)[None], s, every) for s in (scene, replace(scene, normal_radius=0.0))]
        return elements.normal_radius / UNIT.height, rows[0], rows[1]

    radius, allowed, counted = judged(300, 0.015)
    assert radius > 0.09
    assert allowed.support[0] == counted.support[0]
    # of the 36 elements near its surface that do not agree, those within reach of a crease
    assert allowed.close[0] <= counted.close[0] - 5
    radius, allowed, counted = judged(40_000, 0.005)
    assert radius < 0.07
    np.testing.assert_array_equal(allowed.table, counted.table)


def units_of(per_cell: float, cells: float = 40.0) -> Evidence:
    """Two poses on as many elements per cell of the surface."""
    return Evidence(np.array([[per_cell * cells, per_cell * cells, 0.0, cells, 4.0, 0.01, per_cell * cells]] * 2))


@pytest.mark.parametrize(("per_cell", "fewest"), [(18.5, 8), (18.0, 8), (12.6, 6), (8.7, FEWEST_CELLS), (3.0, FEWEST_CELLS)])
def test_the_fewest_cells_of_a_found_unit_go_with_what_cells_hold_in_a_sparse_cloud(per_cell: float, fewest: int):
    sparse = TypicalUnit(0.01, 1.0, model=SPARSE)
    assert fewest_found_cells(units_of(per_cell), np.array([0.95, 0.95]), sparse) == fewest
    # what is not sure does not tell what a cell can hold
    both = Evidence.joined([units_of(per_cell), units_of(1.0)])
    assert fewest_found_cells(both, np.array([0.95, 0.95, 0.7, 0.7]), sparse) == fewest
    assert fewest_found_cells(units_of(per_cell), np.array([0.8, 0.8]), sparse) == FEWEST_FOUND_CELLS
    assert fewest_found_cells(Evidence.joined([]), np.zeros(0), sparse) == FEWEST_FOUND_CELLS


def test_few_cells_are_enough_in_a_rich_cloud_where_they_fit_closely() -> None:
    # support, close, inside, cells, legs, misfit, reached
    few = Evidence(
        np.array(
            [[90.0, 92.0, 0.0, cells, 2.0, misfit, 95.0] for cells, misfit in ((8, 0.05), (7, 0.014), (5, 0.014), (7, 0.02), (4, 0.01))]
        )
    )
    scores = np.full(len(few), 0.9)
    assert least_scores(few, scores, TypicalUnit(0.01, 1.0, model=RICH)) == pytest.approx(
        [FOUND_SCORE, SURE_OF_FEW, SURE_OF_FEW, np.inf, np.inf]
    )
    for model in (NOISY, SMOOTHED, BRIDGED):
        assert not np.isfinite(least_scores(few, scores, TypicalUnit(0.01, 1.0, model=model))[1:]).any()


@pytest.mark.parametrize("model", [RICH, NOISY, SMOOTHED])
def test_the_fewest_cells_stay_where_the_number_of_points_is_not_what_limits(model: ScoreModel):
    assert fewest_found_cells(units_of(8.7), np.array([0.95, 0.95]), TypicalUnit(0.01, 1.0, model=model)) == FEWEST_FOUND_CELLS


def test_where_gaps_are_bridged_what_lies_beside_a_unit_speaks_less_against_it() -> None:
    """Of an unbridged cloud, of no poses and of a poor cloud the model stays."""
    tolerance, columns = 0.03, {SUPPORT: 0, CLOSE: 1, REACHED: 2, CELLS: 3, MISFIT: 4}

    def poses(*rows: tuple[float, float, float, float, float]) -> Evidence:
        table = np.zeros((len(rows), len(COLUMNS)))
        for column, place in columns.items():
            table[:, column] = [row[place] for row in rows]
        return Evidence(table)

    unit, half, rock = (1900.0, 2550.0, 3600.0, 74.0, 0.015), (700.0, 850.0, 1100.0, 33.0, 0.015), (300.0, 480.0, 800.0, 20.0, 0.024)
    found = poses(unit, half, rock)
    typical = TypicalUnit(misfit=0.015, agreement=0.8)
    bridged = where_bridged(typical, found)
    assert bridged.model is BRIDGED
    before, after = score(found, tolerance, typical), score(found, tolerance, bridged)
    assert before[0] < 0.65 < 0.95 < after[0]
    assert after[1] > before[1]
    assert after[2] < 0.05
    clean = poses((1900.0, 1950.0, 2000.0, 74.0, 0.015), rock)
    assert where_bridged(typical, clean) is typical
    assert where_bridged(typical, poses()) is typical
    sparse = TypicalUnit(0.015, 0.8, model=SPARSE)
    assert where_bridged(sparse, found) is sparse


@pytest.mark.parametrize("legs", [(0, 1), (1, 2), (1, 2, 3), (0, 2, 3)])
def test_legs_of_unequal_angles_are_told_apart(legs):
    """The paper's model has 120 degrees between leg 1 and the others, 97 among these: a unit of legs that it holds alike is turned."""
    unit = UnitType.tetrapod(2.3, opening="paper")
    rng = np.random.default_rng(sum(legs))
    poses = [turned(seed, (8.0 * seed, 0.0, 0.0)) for seed in range(6)]
    points, _, leg = sample_surface(unit, 16_000, rng)
    points = points[np.isin(leg, legs)]
    cloud = np.vstack([pose.to_frame(points) + rng.normal(0, 0.01, points.shape) for pose in poses])
    units = segment(cloud, unit).units
    assert len(units) == len(poses)
    for pose in poses:
        own = min(units, key=lambda u: np.linalg.norm(u.pose.centre - pose.centre))
        axes = own.pose.rotation @ unit.leg_directions.T
        seen = pose.rotation @ unit.leg_directions[list(legs)].T
        assert np.linalg.norm(own.pose.centre - pose.centre) < 0.01
        assert np.degrees(np.arccos(np.clip(np.max(seen.T @ axes, axis=1), -1, 1))).max() < 1.0


def test_cell_around_a_leg_is_that_of_the_angle() -> None:
    angles = np.radians(np.concatenate([np.arange(-179.5, 180, 0.5), [-90, -45, 0, 45, 90, 179.999]]) + 1e-4)
    cells = [azimuth_cell(0.3 * np.cos(angle), 0.3 * np.sin(angle)) for angle in angles]
    assert cells == [int((angle + np.pi) / (2 * np.pi) * LAST_OF_TURN) for angle in angles]
    assert set(cells) == set(range(AZIMUTH_CELLS))


def test_copies_are_those_of_better_poses_that_are_kept() -> None:
    rng = np.random.default_rng(5)
    # chains of neighbours, each a copy of the one before: what is a copy of a copy alone is kept
    centres = np.repeat(rng.uniform(0, 4, (40, 3)), 15, axis=0) + rng.normal(0, 0.1, (600, 3))
    turns = Rotation.from_rotvec(rng.normal(0, 0.08, (600, 3))).as_matrix() @ UNIT.symmetries[rng.integers(0, 12, 600)]
    poses, near, cosine = np.column_stack([centres, turns.reshape(-1, 9)]), 0.15, np.cos(np.radians(10))
    kept: list[int] = []
    for i, pose in enumerate(poses):
        close = [k for k in kept if np.linalg.norm(poses[k, :3] - pose[:3]) <= near]
        both = pose[3:].reshape(3, 3) @ UNIT.symmetries
        angles = [(np.einsum("sij,ij->s", both, poses[k, 3:].reshape(3, 3)).max() - 1) / 2 for k in close]
        if not any(angle > cosine for angle in angles):
            kept.append(i)
    assert 100 < len(kept) < 500
    assert without_copies(poses, UNIT.symmetries, near, cosine).tolist() == kept
