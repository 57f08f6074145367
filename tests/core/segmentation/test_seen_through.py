"""The place of a sensor follows from what stands in its beams, and beams through an end that is not there name the break."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.model.tetrapod import relate, sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.leg_ends import BROKEN, PRIOR_ODDS, UNSEEN, LegView, leg_ends
from tetratrack.core.segmentation.seen_through import SeenThrough

UNIT = UnitType.tetrapod(2.3)
SENSORS = (np.array([3.0, -9.0, 14.0]), np.array([-14.0, 6.0, 30.0]))
LEG = 1


def scanned(sensor: np.ndarray, poses: np.ndarray, left: float, rng: np.random.Generator) -> np.ndarray:
    """(n, 3) points of a sensor on units over flat ground; leg ``LEG`` of the first ends at a share of its length, its face not seen."""
    body, _, _ = sample_surface(UNIT, 40_000, rng)
    clouds = []
    for k, pose in enumerate(poses):
        lean = body @ UNIT.leg_directions.T
        gone = (np.argmax(lean, axis=1) == LEG) & (lean[:, LEG] > left * UNIT.leg_length)
        clouds.append((body[~gone] if k == 0 else body) @ pose[3:].reshape(3, 3).T + pose[:3])
    clouds.append(np.column_stack([rng.uniform(-5, 8, (90_000, 2)), np.zeros(90_000)]))
    points = np.vstack(clouds)
    beams = sensor - points
    beams /= np.linalg.norm(beams, axis=1)[:, None]
    free = np.ones(len(points), dtype=bool)
    # steps along the beam, the solids in their true extent
    for step in np.arange(0.06, 3.5, 0.06):
        at = points + step * beams
        for k, pose in enumerate(poses):
            there = (at - pose[:3]) @ pose[3:].reshape(3, 3)
            relation = relate(there, UNIT)
            cut = left * UNIT.leg_length if k == 0 else UNIT.leg_length
            gone = (relation.leg == LEG) & (there @ UNIT.leg_directions[LEG] > cut)
            free &= ~((relation.distance < -0.04) & ~gone)
    return points[free] + rng.normal(0, 0.006, (int(free.sum()), 3))


@pytest.fixture(scope="module", params=[1.0, 0.7])
def scene(request: pytest.FixtureRequest) -> tuple[float, np.ndarray, np.ndarray, np.ndarray]:
    """Share of the leg that is left, points, their sources, and (2, 12) poses."""
    rng = np.random.default_rng(8)
    turn = Rotation.from_euler("xyz", [25, 10, 30], degrees=True).as_matrix().ravel()
    poses = np.array([[0.0, 0.0, 1.4, *turn], [2.6, 0.4, 1.4, *turn]])
    clouds = [scanned(sensor, poses, request.param, rng) for sensor in SENSORS]
    sources = np.repeat([1, 2], [len(cloud) for cloud in clouds])
    return request.param, np.vstack(clouds), sources, poses


def test_beams_pass_where_an_end_is_missing_and_nowhere_else(scene: tuple[float, np.ndarray, np.ndarray, np.ndarray]) -> None:
    left, points, sources, poses = scene
    through = SeenThrough(points, sources, poses, np.zeros((2, 4), dtype=bool), UNIT, 0.006)
    passing = [through.through(unit, leg, 0.6 * UNIT.leg_length).evidence for unit in (0, 1) for leg in range(4)]
    missing = passing.pop(LEG)
    assert max(passing) < -PRIOR_ODDS
    if left < 1:
        assert missing > 10
        body = (points - poses[0, :3]) @ poses[0, 3:].reshape(3, 3)
        ends = leg_ends(
            LegView(body[np.linalg.norm(body, axis=1) < 1.1 * UNIT.reach], UNIT, 0.006), None, lambda k, at: through.through(0, k, at)
        )
        assert ends.states[LEG] == BROKEN
        assert ends.missing[LEG] == pytest.approx((1 - left) * UNIT.leg_length, abs=0.08 * UNIT.leg_length)
        assert (ends.states != BROKEN).sum() == 3
    else:
        assert missing < -PRIOR_ODDS


def test_a_source_of_many_places_says_nothing(scene: tuple[float, np.ndarray, np.ndarray, np.ndarray]) -> None:
    _, points, sources, poses = scene
    through = SeenThrough(points, np.zeros_like(sources), poses, np.zeros((2, 4), dtype=bool), UNIT, 0.006)
    assert through.through(0, LEG, 0.6 * UNIT.leg_length).evidence == 0


def test_sides_that_go_on_need_no_beams() -> None:
    body, _, _ = sample_surface(UNIT, 12_000, np.random.default_rng(3))
    lean = body @ UNIT.leg_directions.T
    short = body[~((np.argmax(lean, axis=1) == LEG) & (lean[:, LEG] > 0.7 * UNIT.leg_length))]
    assert LegView(body, UNIT, 0.004).sides_to_end().all()
    assert LegView(short, UNIT, 0.004).sides_to_end().tolist() == [k != LEG for k in range(4)]
    assert leg_ends(LegView(short, UNIT, 0.004)).states[LEG] == UNSEEN
