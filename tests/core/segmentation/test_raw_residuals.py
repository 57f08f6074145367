"""Raw points of a noisy cloud lie about the surface of a unit as the noise says, and about that of a wrong pose they do not."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.pose_score import MOST_LOG_ODDS, USUAL_RESIDUALS, score_with_residuals
from tetratrack.core.segmentation.raw_residuals import LEAST_CHI_SQUARE, LEAST_SHARE, UNKNOWN, raw_residuals
from tetratrack.core.simulation.sampled_unit import cloud_of

UNIT = UnitType.tetrapod(2.3)
H = UNIT.height
NOISE = 0.033 * H
TRUE = Pose(np.zeros(3), Rotation.from_rotvec([0.4, -0.2, 0.9]).as_matrix())


def row(pose: Pose) -> np.ndarray:
    return np.r_[pose.centre, pose.rotation.ravel()]


@pytest.fixture(scope="module")
def cloud() -> np.ndarray:
    return cloud_of(UNIT, (TRUE,), np.sqrt(3) * NOISE, np.random.default_rng(3), count=6000).points


def test_points_of_a_unit_lie_as_the_noise_says(cloud):
    chi_square, within, inside = raw_residuals(cloud, row(TRUE)[None], UNIT, NOISE)[0]
    # means of n points have 1 / n of the variance of a point, so that their squares in standard deviations have a mean of one
    assert np.exp(chi_square) - LEAST_CHI_SQUARE == pytest.approx(1.0, abs=0.4)
    assert within == pytest.approx(1.0, abs=0.08)
    assert inside < np.log(2 * LEAST_SHARE)


def test_patches_of_a_wrong_pose_lie_off_its_surface(cloud):
    beside = TRUE.shifted(np.array([0.03 * H, 0, 0]))
    right, wrong = (raw_residuals(cloud, row(pose)[None], UNIT, NOISE, settle=False)[0] for pose in (TRUE, beside))
    assert wrong[0] > right[0] + 0.7
    scores = score_with_residuals(np.array([0.65, 0.65]), np.vstack([right, wrong]), np.full(2, 150.0))
    assert scores[0] > 0.7
    assert scores[1] < 0.4


def test_a_pose_is_taken_to_its_points_first(cloud):
    beside = Pose(np.array([0.03 * H, -0.02 * H, 0]), Rotation.from_rotvec([0.0, 0.06, 0.0]).as_matrix() @ TRUE.rotation)
    right, drawn = (raw_residuals(cloud, row(pose)[None], UNIT, NOISE)[0] for pose in (TRUE, beside))
    assert drawn == pytest.approx(right, abs=0.02)
    # each of several to its own, and those before the first that is asked for stay where they are
    two = np.array([row(beside), row(beside.shifted(np.array([3 * H, 0, 0])))])
    both = np.vstack([cloud, cloud + np.array([3 * H, 0, 0])])
    assert raw_residuals(both, two, UNIT, NOISE) == pytest.approx(np.array([right, right]), abs=0.15)
    assert raw_residuals(both, two, UNIT, NOISE, first=1) == pytest.approx(np.array([UNKNOWN, right]), abs=0.15)


def test_what_is_no_unit_lies_off_its_surface_wherever_it_is_taken(cloud):
    rng = np.random.default_rng(4)
    rock = rng.normal(size=(6000, 3))
    rock *= 0.35 * H / np.linalg.norm(rock, axis=1)[:, None]
    rock = rock[rock[:, 2] > 0] + rng.normal(0, NOISE, (np.count_nonzero(rock[:, 2] > 0), 3))
    right, wrong = (raw_residuals(points, row(TRUE)[None], UNIT, NOISE)[0] for points in (cloud, rock))
    assert wrong[0] > right[0] + 0.7


def test_points_inside_speak_against_a_pose_but_for_one_broken_leg(cloud):
    legs = UNIT.leg_directions @ TRUE.rotation.T
    along = np.linspace(0.65, 0.85, 300)[:, None] * UNIT.leg_length
    whole, broken, hollow = (
        raw_residuals(np.vstack([cloud, *[along * legs[k] for k in filled]]), row(TRUE)[None], UNIT, NOISE)[0, 2]
        for filled in ((), (0,), (0, 1))
    )
    assert broken == pytest.approx(whole, abs=0.05)
    assert hollow > whole + 1


def test_a_broken_leg_end_draws_no_pose_and_speaks_against_none():
    rng, noise = np.random.default_rng(6), 0.013 * H
    surface = cloud_of(UNIT, (TRUE,), 1e-6, rng, count=3000).points
    body = TRUE.to_body(surface)
    relation = relate(body, UNIT)
    # the end of leg 0 is gone from an oblique plane on, in which points lie as densely as on the leg
    across = np.linalg.svd(UNIT.leg_directions[:1])[2][1:]
    limit = 0.7 * UNIT.leg_length + body @ (0.2 * across[0])
    gone = (relation.leg == 0) & (relation.axial > limit)
    radius, angle = 0.8 * UNIT.radius * np.sqrt(rng.random(gone.sum())), rng.uniform(0, 2 * np.pi, gone.sum())
    face = radius[:, None] * (np.cos(angle)[:, None] * across[0] + np.sin(angle)[:, None] * across[1])
    body[gone] = face + (0.7 * UNIT.leg_length + face @ (0.2 * across[0]))[:, None] * UNIT.leg_directions[0]
    whole, broken = (
        raw_residuals(points + rng.normal(0, noise, points.shape), row(TRUE)[None], UNIT, noise)[0]
        for points in (surface, TRUE.to_frame(body))
    )
    assert broken == pytest.approx(whole, abs=0.3)


def test_what_hardly_any_point_tells_stays_as_it_is(cloud):
    far = Pose(np.array([50.0, 0, 0]), np.eye(3))
    assert raw_residuals(cloud, row(far)[None], UNIT, NOISE)[0] == pytest.approx(UNKNOWN)
    assert raw_residuals(cloud, np.zeros((0, 12)), UNIT, NOISE).shape == (0, 3)
    assert raw_residuals(np.zeros((0, 3)), row(TRUE)[None], UNIT, NOISE)[0] == pytest.approx(UNKNOWN)


def test_scores_are_believed_up_to_a_limit():
    good = np.tile([0.26, 1.1, -3.8], (4, 1))
    limit = 1 / (1 + np.exp(-MOST_LOG_ODDS))
    scores = score_with_residuals(np.array([0.0, 0.5, limit, 1.0]), good, np.full(4, 150.0))
    assert scores[0] == 0.0
    assert 0.5 < scores[1] < scores[2]
    assert scores[2] == pytest.approx(scores[3])


def test_what_all_sure_poses_of_a_cloud_show_speaks_against_none():
    scores, support, good = np.array([0.7, 0.99, 0.99, 0.99]), np.full(4, 150.0), np.tile([0.5, 1.1, -3.8], (4, 1))
    odd = good + np.array([1.5, 0.0, 0.0])
    usual = np.array([USUAL_RESIDUALS[0] - 0.5, 0.0, 0.0])
    assert score_with_residuals(scores, odd, support) == pytest.approx(score_with_residuals(scores, good + usual, support))
    # two sure poses tell nothing of the cloud
    few = score_with_residuals(scores[:3], odd[:3], support[:3])
    assert few[0] < score_with_residuals(scores, odd, support)[0] - 0.2


def test_few_elements_agree_by_chance():
    good = np.tile([0.0, 1.5, -3.9], (2, 1))
    few, many = score_with_residuals(np.array([0.2, 0.2]), good, np.array([60.0, 400.0]))
    assert few < many - 0.1
