"""Calibration of the displacement test over many synthetic epoch pairs, the stable set and the datum."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation
from scipy.stats import false_discovery_control, kstest
from synthetic_units import unturned_pair
from tetratrack.core.deformation.congruence import Congruence, PoseCalibration, congruence_of
from tetratrack.core.deformation.displacement import (
    FramePart,
    adjusted_p_values,
    classify,
    grade,
    grades_from,
    unit_motion,
)
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.registration.transformation import rigid_jacobian

FloatArray = NDArray[np.float64]
PRIOR = np.diag([0.004**2] * 3 + [0.0004**2] * 3 + [0.0])
GRADES = grades_from({"watch": 0.05, "alert": 0.1, "partly_damaged": 0.5, "damaged": 1.0, "dislocated": 1.0})


def common_motion(seed: int) -> FloatArray:
    """Registration error of a pair: shift and rotation vector about the origin."""
    return np.random.default_rng([seed, 1]).multivariate_normal(np.zeros(6), PRIOR[:6, :6])


def pair(
    seed: int, count: int = 60, moved: int = 10, factor: float = 1.5, floor: float = 0.0005, tail: float = np.inf, settlement: float = 0.0
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Displacements with unequal formal covariances that are too small by ``factor``, a registration error, and some moved units."""
    rng = np.random.default_rng(seed)
    points = rng.uniform(-8, 8, (count, 3))
    shape = rng.normal(size=(count, 3, 3)) * 0.4 + np.eye(3)
    covariances = shape @ np.swapaxes(shape, 1, 2) * (rng.uniform(0.0004, 0.003, count) ** 2)[:, None, None]
    total = factor**2 * covariances + floor**2 * np.eye(3)
    errors = np.einsum("nij,nj->ni", np.linalg.cholesky(total), rng.normal(size=(count, 3)))
    if np.isfinite(tail):
        errors *= np.sqrt(tail / rng.chisquare(tail, count))[:, None]
    common = common_motion(seed)
    displacements = errors + rigid_jacobian(points)[:, :, :6] @ common
    displacements[:, 2] -= settlement
    way = rng.normal(size=(moved, 3))
    displacements[:moved] += way / np.linalg.norm(way, axis=1, keepdims=True) * rng.uniform(0.02, 0.3, moved)[:, None]
    return displacements, covariances, points, np.arange(count) < moved


def judged(seed: int, prior: FloatArray | None = PRIOR, **kwargs: float) -> tuple[Congruence, FloatArray, FloatArray]:
    displacements, covariances, points, moved = pair(seed, **kwargs)  # type: ignore[arg-type]
    return congruence_of(displacements, covariances, points, prior, np.zeros(3), 2.3), displacements, moved


@pytest.mark.parametrize(("factor", "floor", "tail"), [(1.0, 0.0, np.inf), (1.5, 0.0005, np.inf), (3.0, 0.001, np.inf), (1.5, 0.0005, 6.0)])
def test_p_values_of_stable_units_are_uniform(factor: float, floor: float, tail: float) -> None:
    """Whatever the fits' covariances miss, stable units are flagged at the level, and every motion of 2 cm is found."""
    stable, found = [], []
    for seed in range(12):
        result, _, moved = judged(seed, factor=factor, floor=floor, tail=tail)
        stable += result.p_values[~moved].tolist()
        found += (result.p_values[moved] < 0.05).tolist()
    assert kstest(stable, "uniform").pvalue > 0.01
    assert 0.03 <= np.mean(np.array(stable) < 0.05) <= 0.07
    assert np.mean(found) >= 0.95


def test_datum_stable_is_much_closer_than_control_and_keeps_moved_units_out() -> None:
    stable, control = [], []
    for seed in range(8):
        result, _, moved = judged(seed)
        points, common = pair(seed)[2], common_motion(seed)
        truth = rigid_jacobian(points)[:, :, :6] @ common
        stable.append(np.mean((result.rigid_motions(points, "stable").means[:, :3] - truth) ** 2))
        control.append(np.mean(truth**2))
        assert not result.stable[moved].any()
        assert result.stable[~moved].mean() > 0.9
    assert np.sqrt(np.mean(stable)) < 0.2 * np.sqrt(np.mean(control))


@pytest.mark.parametrize("prior", [PRIOR, None], ids=["control", "free"])
@pytest.mark.parametrize(("tail", "count"), [(np.inf, 6), (np.inf, 60), (5.0, 60), (8.0, 60)])
def test_global_test_holds_its_level_whatever_the_tails_and_the_number_of_units(tail: float, count: int, prior: FloatArray | None) -> None:
    p_values = [judged(seed, prior, moved=0, count=count, tail=tail)[0].global_p_value for seed in range(24)]
    assert np.mean(np.array(p_values) < 0.05) <= 0.17
    assert 0.35 < np.mean(p_values) < 0.7


def test_global_test_finds_one_unit_that_moved_among_many() -> None:
    p_values = [judged(seed, prior, moved=1, count=40)[0].global_p_value for seed in range(6) for prior in (PRIOR, None)]
    assert np.max(p_values) < 0.01
    assert judged(1)[0].global_p_value < 1e-6


def test_settlement_of_everything_shows_against_control_alone() -> None:
    """A common motion of 5 cm is invisible in datum stable, and found in datum control and by the test of the common motion."""
    result, _, moved = judged(3, settlement=0.05)
    assert result.common_p_value < 1e-6
    assert np.mean(result.control_p_values[~moved] < 0.05) == 1
    assert np.mean(result.p_values[~moved] < 0.05) < 0.15
    quiet = [judged(seed)[0].common_p_value for seed in range(20, 40)]
    assert np.mean(np.array(quiet) < 0.05) <= 0.25


def test_without_control_the_stable_units_alone_make_the_datum() -> None:
    result, _displacements, moved = judged(4, prior=None)
    assert np.isnan(result.common_p_value)
    assert (result.p_values[moved] < 0.05).all()
    assert np.mean(result.p_values[~moved] < 0.05) < 0.15
    # nothing is known against control, and nothing is said to have moved against it
    assert np.min(result.control_p_values) > 0.99
    spread = result.rigid_motions(np.zeros((1, 3)), "control").covariances[0]
    assert np.sqrt(np.diag(spread)[:3]).min() > 100


@pytest.mark.parametrize(("count", "understated"), [(4, 2.5), (7, 4.0)])
def test_few_units_whose_deviations_are_understated_do_not_vouch_for_each_other(count: int, understated: float) -> None:
    """Three that agree by chance told all others, with p-values as small as of many, that they moved."""
    p_values = np.concatenate([at_rest(seed, count, understated).p_values for seed in range(24)])
    assert np.mean(p_values < 0.001) <= 0.01
    assert np.mean(p_values < 0.05) <= 0.15


def at_rest(seed: int, count: int, understated: float = 1.0, way: float = 0.0) -> Congruence:
    """Units of 3 mm without control, the first of which moved by a ``way`` in metres."""
    rng = np.random.default_rng(seed)
    points = np.column_stack([rng.uniform(0, 40, count), rng.uniform(0, 10, count), rng.uniform(0, 3, count)])
    vectors = rng.normal(0, 0.003 * understated, (count, 3))
    vectors[0, 0] += way
    return congruence_of(vectors, np.tile(np.eye(3) * 0.003**2, (count, 1, 1)), points, None, points.mean(axis=0), 2.3)


def test_one_of_few_units_that_moved_is_found_without_control() -> None:
    results = [at_rest(seed, count, way=0.1) for seed in range(6) for count in (4, 7)]
    assert all(result.p_values[0] < 0.05 and not result.stable[0] for result in results)
    assert np.mean(np.concatenate([result.p_values[1:] for result in results]) < 0.05) <= 0.05


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_what_others_say_has_a_covariance_however_few_they_are(count: int) -> None:
    for seed in range(8):
        rng = np.random.default_rng(seed)
        points, vectors = rng.uniform(0, 20, (count, 3)), rng.normal(0, 0.003, (count, 3))
        covariances = np.tile(np.eye(3) * 0.003**2, (count, 1, 1))
        result = congruence_of(vectors, covariances, points, None, points.mean(axis=0), 2.3)
        parts = result.by_others(points, vectors, result.null.covariance(covariances), result.stable)
        assert np.linalg.eigvalsh(parts.covariances[:, :3, :3]).min() > 0
        assert (result.p_values > 0.01).all()


def test_four_units_of_which_three_moved() -> None:
    """Like the paper's laboratory test: control tells the one that stayed."""
    result, _, moved = judged(5, count=4, moved=3)
    assert (result.p_values[moved] < 0.05).all()
    assert result.stable.tolist() == [False, False, False, True]


def test_no_units_and_one_unit() -> None:
    none = congruence_of(np.zeros((0, 3)), np.zeros((0, 3, 3)), np.zeros((0, 3)), PRIOR, np.zeros(3), 2.3)
    assert none.p_values.shape == (0,)
    one = congruence_of(np.full((1, 3), 0.002), np.eye(3)[None] * 1e-6, np.zeros((1, 3)), PRIOR, np.zeros(3), 2.3)
    assert one.p_values[0] > 0.05
    far = congruence_of(np.full((1, 3), 0.2), np.eye(3)[None] * 1e-6, np.zeros((1, 3)), PRIOR, np.zeros(3), 2.3)
    assert far.p_values[0] < 0.01


def test_a_unit_carried_by_metres_bears_the_turn_of_its_frame() -> None:
    """Datum stable takes away what turns all units alike, at the places where they were: not the turn of the way of one of them."""
    unit, way = UnitType.tetrapod(2.3), np.array([4.0, -2.0, -1.5])
    here = Pose(np.array([1.0, 2.0, 3.0]), np.eye(3))
    congruence, _, _ = judged(6, moved=0, factor=1.0, floor=0.0)
    null = congruence.null
    frame = np.diag([0.0] * 3 + [0.0008**2] * 3 + [0.0])
    joint = np.eye(12) * 0.0003**2
    squares = []
    for turn in np.random.default_rng(7).normal(0, 0.0008, (400, 3)):
        there = here.shifted(Rotation.from_rotvec(turn).apply(way))
        pair = unturned_pair((here, there), unit, joint)
        part = FramePart(motion=np.zeros(6), covariance=np.zeros((6, 6)), degrees=null.tail, carried=frame)
        motion = unit_motion(pair, null, null, part, 1.0)
        error = motion.vectors[0] - way
        squares.append(error @ np.linalg.solve(motion.covariances[0], error))
    assert np.mean(squares) < 3.3
    assert np.mean(squares) > 1.5


@pytest.mark.parametrize("factor", [0.4, 1.0, 1.6])
def test_a_pose_by_itself_is_known_no_better_than_its_adjustment_says(factor: float) -> None:
    """Units at rest do not show what both epochs err by alike, which is in the pose of each."""
    calibration = PoseCalibration.of_pairs([(factor, 0.002, 1.0, 0.0)])
    stated = np.diag([0.003**2] * 3 + [0.001**2] * 3)
    floors = [0.5 * 0.002**2] * 3 + [0.0] * 3
    expected = np.diag(stated) * ([max(factor, 1.0) ** 2] * 3 + [1.0] * 3) + floors
    assert np.diag(calibration.covariance(stated)) == pytest.approx(expected)


def test_adjusted_p_values_are_those_of_benjamini_and_hochberg() -> None:
    p = np.random.default_rng(0).uniform(size=50) ** 3
    assert np.allclose(adjusted_p_values(p), false_discovery_control(p))
    assert adjusted_p_values([]).shape == (0,)


def test_classes() -> None:
    assert classify(0.01, 0.5, True, False) == "moved"
    assert classify(0.2, 0.01, True, False) == "rotated"
    assert classify(0.2, 0.2, True, False) == "stable"
    assert classify(0.01, 0.01, False, False) == "uncertain"
    assert classify(0.01, 0.01, True, True) == "relocated"


def test_grades_in_metres_heights_and_nominal_diameters() -> None:
    unit = UnitType.tetrapod(2.3)
    diameter = unit.nominal_diameter
    assert grade(0.5, False, unit, GRADES) == "below detection limit"
    assert grade(0.01, True, unit, GRADES) == "significant"
    assert grade(0.06, True, unit, GRADES) == "watch"
    assert grade(0.2, True, unit, GRADES) == "alert"
    assert grade(0.6 * diameter, True, unit, GRADES) == "partly damaged"
    assert grade(1.1 * diameter, True, unit, GRADES) == "damaged"
    assert grade(2.4, True, unit, GRADES) == "dislocated"
