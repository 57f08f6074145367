"""Units of which two epochs show one leg: what both leave of the turn about it makes one of them, and a certain one."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import ALL_DISCS
from tetratrack.core.common.arrays import FloatArray
from tetratrack.core.deformation.fitted_unit import FittedUnit
from tetratrack.core.deformation.identity import Track
from tetratrack.core.deformation.questions import answered_here
from tetratrack.core.deformation.shared_twists import settle_together
from tetratrack.core.deformation.unit_clouds import UnitCloud
from tetratrack.core.model.pose import Pose, rotation_angle
from tetratrack.core.model.tetrapod import relate
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.segment import FOUND_SCORE
from tetratrack.core.segmentation.twist import tolerated_twist
from tetratrack.core.simulation.sampled_unit import cloud_of, interlocked_poses

UNIT = UnitType.tetrapod(2.3)
ROWS = interlocked_poses(UNIT, columns=5, lower_rows=3, upper_rows=2)
MIDDLE, LEG = 7, 1
"""A unit in the middle of the lower layer, and the one of its legs that shows."""


def points_of(units: Sequence[int], rng: int) -> FloatArray:
    """Points of some of the units, and the outer part of a leg of the one in the middle."""
    cloud = cloud_of(UNIT, ROWS, 0.01, np.random.default_rng(rng), count=6000)
    outer = relate(ROWS[MIDDLE].to_body(cloud.points), UNIT).axial > 0.3 * UNIT.height
    shown = np.isin(cloud.unit_index, units) | ((cloud.unit_index == MIDDLE) & (cloud.leg == LEG) & outer)
    near = np.linalg.norm(cloud.points - ROWS[MIDDLE].centre, axis=1) < 2 * UNIT.reach
    return np.asarray(cloud.points[shown & near])


def sighting(pose: Pose, score: float, *, certain: bool = False, twist_open: bool = False) -> FittedUnit:
    return FittedUnit(
        pose=pose,
        shape=UNIT,
        kind=0,
        certain=certain,
        discs=ALL_DISCS,
        cloud=UnitCloud.none(),
        covariance=np.eye(6) * 0.01**2,
        score=score,
        twist_open=twist_open,
    )


def turned(angle: float) -> Pose:
    """The middle unit turned about its leg that shows, degrees, its legs numbered as they come."""
    unit = ROWS[MIDDLE]
    turn = np.radians(angle) * UNIT.leg_directions[LEG]
    return Pose(unit.centre, unit.rotation @ Rotation.from_rotvec(turn).as_matrix()).relabelled(UNIT.symmetries[4])


def settled(
    first: Sequence[int], second: Sequence[int], third: bool = False, **changes: bool
) -> tuple[list[Track], list[dict[int, FittedUnit]]]:
    """Tracks and sightings where two epochs are certain of some units each and leave the middle one open, 40 degrees apart."""
    shown = (list(first), list(second))
    clouds = [points_of(own, epoch) for epoch, own in enumerate((*shown, []))]
    seen = [{e: sighting(ROWS[k], 1.0, certain=True)} for e, own in enumerate(shown) for k in own]
    options = {"twist_open": True} | changes
    seen += [{0: sighting(turned(15.0), 0.3, **options)}, {1: sighting(turned(-25.0), 0.4, **options)}]
    if third:
        seen[-1][2] = sighting(turned(-24.0), 0.35, **options)
    tracks = [Track(dict.fromkeys(own, k), {e: np.eye(3) for e in own}, frozenset(), 0) for k, own in enumerate(seen)]

    def around(epoch: int, places: FloatArray, reach: float):
        return lambda: (clouds[epoch], np.zeros(len(clouds[epoch]), dtype=np.uint16))

    return settle_together(tracks, seen, [UNIT], np.zeros((3, 3)), around, answered_here)


def test_two_epochs_settle_a_turn_together():
    tracks, seen = settled([2, 6, 8, 12], [16, 17, 21, 22])
    assert len(seen) == len(tracks) == 9
    own = seen[-1]
    assert sorted(own) == sorted(tracks[-1].rows) == sorted(tracks[-1].symmetries) == [0, 1]
    assert all(s.certain and not s.twist_open and s.score >= FOUND_SCORE for s in own.values())
    for s in own.values():
        turn = min(rotation_angle(ROWS[MIDDLE].rotation, s.pose.relabelled(symmetry).rotation) for symmetry in UNIT.symmetries)
        assert turn < tolerated_twist(UNIT) / 2
    # both number their legs alike, the first one as it did
    assert rotation_angle(own[0].pose.rotation, own[1].pose.rotation) < 1e-6
    assert rotation_angle(own[0].pose.rotation, turned(15.0).rotation) < np.radians(40)
    np.testing.assert_allclose(tracks[-1].symmetries[0], np.eye(3))


@pytest.mark.parametrize("twist_open", [True, False])
def test_what_both_leave_open_stays_as_it_is(twist_open):
    # no unit stands where it tells, or it is not the turn alone that is in doubt
    first, second = ([6, 8, 12], [8, 17]) if twist_open else ([2, 6, 8, 12], [16, 17, 21, 22])
    tracks, seen = settled(first, second, twist_open=twist_open)
    assert [sorted(own) for own in seen[-2:]] == [[0], [1]]
    assert not any(s.certain for own in seen[-2:] for s in own.values())
    assert len(tracks) == len(seen)


def test_a_sighting_of_a_third_epoch_is_not_lost():
    _, seen = settled([2, 6, 8, 12], [16, 17, 21, 22], third=True)
    assert sum(map(len, seen)) == 8 + 3
    assert [sorted(own) for own in seen[-2:]] == [[0], [1, 2]]
