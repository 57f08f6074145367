"""Noise that neighbours share, as image matching leaves it, is told from that of single points, and is not smoothed through."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.common.voxels import thin
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.pose_score import BRIDGED, MATCHED, TypicalUnit, score, typical_unit
from tetratrack.core.segmentation.scene import Evidence, Scene
from tetratrack.core.segmentation.second_look import second_look
from tetratrack.core.segmentation.segment import FOUND_SCORE, cloud_elements, segment
from tetratrack.core.segmentation.shared_noise import neighbours_share_noise
from tetratrack.core.segmentation.surface_elements import THINNING_RATIO
from tetratrack.core.simulation.sampled_unit import cloud_of, interlocked_poses
from tetratrack.core.simulation.virtual_scene import smooth_field

UNIT = UnitType.tetrapod(2.3)
H = UNIT.height
ROWS = interlocked_poses(UNIT, columns=3, lower_rows=2, upper_rows=1)


def noised(shared: float, single: float, count: int = 30000, seeds: tuple[int, ...] = (1, 2, 3)) -> np.ndarray:
    """Points on all units that deviate by what neighbours share and by what is their own, standard deviations in heights."""
    points = cloud_of(UNIT, ROWS, single * H, np.random.default_rng(5), count=count).points
    field = [smooth_field(points, np.random.default_rng(seed), 0.1 * H, 0.15 * H) for seed in seeds]
    return np.asarray(points + shared * H * np.column_stack(field))


@pytest.fixture(scope="module")
def matched() -> np.ndarray:
    return noised(0.018, 0.006)


def is_shared(points: np.ndarray, noise: float) -> bool:
    return neighbours_share_noise(points, thin(points, THINNING_RATIO * H)[0], H, noise * H)


def test_noise_that_neighbours_share_is_told(matched):
    assert is_shared(matched, 0.012)


@pytest.mark.parametrize(("noise", "count"), [(0.012, 30000), (0.033, 30000), (0.021, 5000), (0.021, 500)])
def test_noise_of_single_points_is_not(noise, count):
    assert not is_shared(noised(0.0, noise, count), noise)


def test_points_that_a_cloud_holds_twice_are_no_neighbours():
    points = noised(0.0, 0.021, 5000)
    assert not is_shared(np.vstack([points, points]), 0.021)


def test_shared_noise_is_not_smoothed_and_has_a_score_of_its_own(matched):
    cloud = cloud_elements(matched, UNIT)
    assert cloud.elements.shared_noise
    assert not cloud.elements.smoothed
    assert typical_unit(Evidence.joined([]), Scene.of(cloud.elements, UNIT, cloud.tolerance)).model is MATCHED
    assert cloud_elements(noised(0.0, 0.021), UNIT).elements.smoothed


def test_rock_within_shared_noise_is_no_unit():
    # two poses of a simulated pile: support, close, inside, cells, legs, misfit, reached
    seen = Evidence(np.array([[1836.0, 3437.0, 0.0, 78.0, 4.0, 0.52, 4507.0], [1583.0, 2756.0, 22.0, 58.0, 4.0, 0.66, 3091.0]]))
    unit, rock = score(seen, 1.0, TypicalUnit(misfit=0.5, agreement=0.73, model=MATCHED))
    assert unit > FOUND_SCORE > 0.3 > rock
    assert score(seen, 1.0, TypicalUnit(misfit=0.5, agreement=0.73, model=BRIDGED))[1] > FOUND_SCORE


def test_units_are_found_in_shared_noise(matched):
    found = [u for u in segment(matched, UNIT).units if u.status == "found"]
    away = [min(np.linalg.norm(u.pose.centre - pose.centre) for u in found) for pose in ROWS]
    assert len(found) == len(ROWS)
    assert max(away) < 0.04 * H


def test_a_second_look_takes_shared_noise_for_poor(matched):
    others = np.array([pose.as_row() for pose in ROWS[1:]])
    around = matched[np.linalg.norm(matched - ROWS[0].centre, axis=1) < 1.35 * UNIT.reach]
    again = noised(0.018, 0.006, seeds=(4, 5, 6))
    again = again[np.linalg.norm(again - ROWS[0].centre, axis=1) < 1.35 * UNIT.reach]
    looks = [
        second_look(points, ROWS[0].as_row(), others, np.ones(len(others)), UNIT, shared_noise=known)
        for points, known in ((around, False), (np.vstack([around, again]), True))
    ]
    for look in looks:
        assert look is not None
        assert look.noisy
        assert look.shared_noise
        assert look.score > 0.9
        assert np.linalg.norm(look.place.centre - ROWS[0].centre) < 0.04 * H
