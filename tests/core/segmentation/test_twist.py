"""The twist of units of one visible leg: nothing from the points alone, much from the room among the neighbours."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.model.pose import Pose, rotation_angle
from tetratrack.core.model.tetrapod import relate
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.scene import Evidence
from tetratrack.core.segmentation.segment import FOUND_SCORE, segment
from tetratrack.core.segmentation.twist import (
    ALIGNED,
    LEAST_CERTAINTY,
    LEAST_MISFIT,
    ROOM_SD,
    STEPS,
    SURE_ROOM_SD,
    TURN,
    entered_by_trust,
    log_likelihood,
    tolerated_twist,
    twist_of,
)
from tetratrack.core.simulation.sampled_unit import cloud_of, interlocked_poses

UNIT = UnitType.tetrapod(2.3)
ROWS = interlocked_poses(UNIT, columns=5, lower_rows=3, upper_rows=2)
MIDDLE = 7
"""A unit in the middle of the lower layer, with neighbours all around."""


def with_one_leg(hidden: int, leg: int) -> np.ndarray:
    """Points of the rows, of one unit only the outer part of a leg."""
    cloud = cloud_of(UNIT, ROWS, 0.01, np.random.default_rng(3), count=6000)
    relation = relate(ROWS[hidden].to_body(cloud.points), UNIT)
    return cloud.points[(cloud.unit_index != hidden) | ((cloud.leg == leg) & (relation.axial > 0.3 * UNIT.height))]


@pytest.mark.parametrize("leg", [1, 2, 3])
def test_neighbours_leave_a_unit_of_one_leg_few_twists(leg):
    units = segment(with_one_leg(MIDDLE, leg), UNIT).units
    truth = ROWS[MIDDLE]
    own = [u for u in units if np.linalg.norm(u.pose.centre - truth.centre) < 0.1 * UNIT.height]
    assert len(units) == len(ROWS)
    assert [(u.status, u.legs_visible) for u in own] == [("found", 1)]
    turn = min(rotation_angle(truth.rotation, own[0].pose.relabelled(s).rotation) for s in UNIT.symmetries)
    assert turn < tolerated_twist(UNIT) / 2


def test_a_leg_alone_is_reported_but_not_found():
    cloud = cloud_of(UNIT, ROWS[:1], 0.01, np.random.default_rng(4), count=12000)
    relation = relate(ROWS[0].to_body(cloud.points), UNIT)
    units = segment(cloud.points[(cloud.leg == 1) & (relation.axial > 0.3 * UNIT.height)], UNIT).units
    assert [u.status for u in units] == ["uncertain"]
    assert units[0].score < FOUND_SCORE
    assert np.linalg.norm(units[0].pose.centre - ROWS[0].centre) < 0.1 * UNIT.height


def test_room_on_one_side_gives_the_middle_of_it():
    angles = np.arange(STEPS) * TURN / STEPS
    entered = np.where((angles > 0.6) & (angles < 1.6), 4 * ROOM_SD, 0.0)
    known = twist_of(np.full(STEPS, 100.0), entered, UNIT)
    # free from 1.6 over 2.09, which is 0 again, to 0.6
    assert (known.mean + TURN / 2) % TURN - TURN / 2 == pytest.approx((1.6 - TURN + 0.6) / 2, abs=TURN / STEPS)
    # evenly spread over 1.09 rad
    assert known.sd == pytest.approx(1.09 / np.sqrt(12), rel=0.1)
    assert known.certainty == pytest.approx(1.0, abs=0.02)


def test_neighbours_that_surely_stand_speak_by_the_volume_they_share():
    entered = np.linspace(0, 0.09, 2 * STEPS).reshape(STEPS, 2)
    assert entered_by_trust(entered, np.ones(2)) == pytest.approx(entered.max(axis=1))
    assert entered_by_trust(np.zeros((STEPS, 0)), np.zeros(0)) == pytest.approx(0)


def test_a_neighbour_that_may_stand_elsewhere_settles_no_twist():
    angles = np.arange(STEPS) * TURN / STEPS
    entered = np.where((angles > 0.2) & (angles < 1.9), 4 * ROOM_SD, 0.0)[:, None]
    sure = twist_of(np.full(STEPS, 100.0), entered_by_trust(entered, np.ones(1)), UNIT)
    doubtful = twist_of(np.full(STEPS, 100.0), entered_by_trust(entered, np.array([0.55])), UNIT)
    assert sure.certainty > 0.95
    # with a probability of 0.45 all twists are alike
    assert entered_by_trust(entered, np.array([0.55]))[10] == pytest.approx(ROOM_SD * np.sqrt(-2 * np.log(0.45)), rel=0.01)
    assert doubtful.certainty < 0.4


def test_a_closer_fit_outweighs_some_elements():
    # the false pose of tls_quay seen from station 3 alone, and the true one
    more = Evidence(np.array([[91.0, 92.0, 0.0, 8.0, 1.0, 0.00596, 98.0]]))
    closer = Evidence(np.array([[86.0, 86.0, 0.0, 5.0, 1.0, 0.0040, 88.0]]))
    tolerance = 0.0208
    assert log_likelihood(closer, tolerance)[0] > log_likelihood(more, tolerance)[0]
    # Gaussian density of residuals at their own deviation over that of the window of four tolerances, for each element
    expected = 91 * (np.log(4 * tolerance) - 0.5 * np.log(2 * np.pi * np.e * 0.00596**2))
    assert log_likelihood(more, tolerance)[0] == pytest.approx(expected)
    # elements inside the solid speak against, and closeness beyond what neighbouring elements tell counts no more
    assert log_likelihood(more.replaced(inside=31), tolerance)[0] < 0
    closest, least = more.replaced(misfit=1e-6), more.replaced(misfit=LEAST_MISFIT * tolerance)
    assert log_likelihood(closest, tolerance) == log_likelihood(least, tolerance)


def test_all_twists_alike_are_no_knowledge():
    known = twist_of(np.full(STEPS, 100.0), np.zeros(STEPS), UNIT)
    assert known.certainty == LEAST_CERTAINTY
    assert known.sd == pytest.approx(TURN / np.sqrt(12), rel=0.02)


def test_points_that_prefer_one_twist_settle_it():
    values = np.full(STEPS, 70.0)
    values[10] = 100.0
    known = twist_of(values, np.zeros(STEPS), UNIT)
    assert known.mean == pytest.approx(10 * TURN / STEPS, abs=0.03)
    assert known.sd < np.radians(8)
    assert known.certainty > 0.95


def test_a_second_leg_settles_how_sure_a_twist_is_however_many_elements_the_first_has():
    """Twelve elements of a second leg at one twist, as on a right unit of a simulated scan that has 505 on its first."""
    values = np.full(STEPS, 505.0)
    values[0] = 517.0
    assert twist_of(values, np.zeros(STEPS), UNIT, ALIGNED).certainty > 3 * twist_of(values, np.zeros(STEPS), UNIT).certainty
    values[0] = 525.0
    assert twist_of(values, np.zeros(STEPS), UNIT, ALIGNED).certainty > 0.65
    # three are chance
    values[0] = 508.0
    assert twist_of(values, np.zeros(STEPS), UNIT, ALIGNED).certainty < 0.2
    # few elements are weighed as before
    few = np.full(STEPS, 60.0)
    few[0] = 70.0
    assert twist_of(few, np.zeros(STEPS), UNIT, ALIGNED).certainty == twist_of(few, np.zeros(STEPS), UNIT).certainty


def test_a_hundredth_of_its_volume_inside_neighbours_rules_a_twist_out():
    """How sure a twist is goes with how exact poses of neighbours are; where a unit is turned to, with more."""
    angles = np.arange(STEPS) * TURN / STEPS
    entered = np.where((angles > 0.5) & (angles < 1.6), 0.012, 0.0)[:, None]
    sure, loose = (
        twist_of(np.full(STEPS, 300.0), entered_by_trust(entered, np.ones(1), room), UNIT, ALIGNED, room)
        for room in (SURE_ROOM_SD, ROOM_SD)
    )
    assert sure.certainty > 0.65
    assert loose.certainty < 0.4
    # a neighbour that may be elsewhere says no more than it is trusted
    doubted = entered_by_trust(entered, np.array([0.2]), SURE_ROOM_SD)
    assert twist_of(np.full(STEPS, 300.0), doubted, UNIT, ALIGNED, SURE_ROOM_SD).certainty < 0.2


def test_tolerated_twist_keeps_the_feature_points_near():
    from tetratrack.core.model.feature_points import body_features

    features = body_features(UNIT)[1:]
    axis, angle = UNIT.leg_directions[0], tolerated_twist(UNIT)
    cross = np.cross(np.broadcast_to(axis, features.shape), features)
    turned = features * np.cos(angle) + cross * np.sin(angle) + np.outer(features @ axis, axis) * (1 - np.cos(angle))
    assert np.linalg.norm(turned - features, axis=1).mean() == pytest.approx(0.15 * UNIT.height, rel=1e-6)


def test_a_twist_is_taken_over_and_the_leg_stays() -> None:
    axis = UNIT.leg_directions[2]
    known = Pose(np.array([1.0, 2.0, 3.0]), Rotation.random(random_state=1).as_matrix())
    turned = Pose(known.centre + 0.01, Rotation.from_rotvec(0.6 * known.rotation @ axis).as_matrix() @ known.rotation)
    back = turned.twisted_as(known, axis)
    np.testing.assert_allclose(back.rotation, known.rotation, atol=1e-12)
    np.testing.assert_array_equal(back.centre, turned.centre)
    # a leg that leans a little otherwise stays where it was seen
    leaning = Pose(turned.centre, Rotation.from_rotvec([0.02, -0.01, 0.015]).as_matrix() @ turned.rotation)
    result = leaning.twisted_as(known, axis)
    np.testing.assert_allclose(result.rotation @ axis, leaning.rotation @ axis, atol=1e-12)
    assert Rotation.from_matrix(result.rotation @ known.rotation.T).magnitude() < 0.03
