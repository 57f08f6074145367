"""Places of units that an epoch does not show: few points are enough in a sparse cloud, and no two solids share a place."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation
from synthetic_units import ALL_DISCS, UNIT, seen_from_above
from tetratrack.core.deformation.fitted_unit import FittedUnit
from tetratrack.core.deformation.missing_units import MissingUnits
from tetratrack.core.deformation.questions import Answer
from tetratrack.core.deformation.unit_clouds import UnitCloud
from tetratrack.core.model.pose import Pose

POSE = Pose(np.array([0.0, 0.0, 0.0]), Rotation.from_euler("xyz", [0.3, 0.4, 0.5]).as_matrix())


def fitted(pose: Pose, points: np.ndarray) -> FittedUnit:
    cloud = UnitCloud.held(points, np.zeros(len(points), dtype=np.uint16))
    return FittedUnit(pose=pose, shape=UNIT, kind=0, certain=True, discs=ALL_DISCS, cloud=cloud)


def asked(now: np.ndarray, before: np.ndarray, owners: tuple[FittedUnit, ...] = ()) -> Answer:
    """What becomes of a unit whose epoch holds ``before``, and nothing else, in one that holds ``now``."""
    return MissingUnits(
        units=(fitted(POSE, before),),
        moves=np.zeros((1, 3)),
        owners=owners,
        now=lambda: (now, np.zeros(len(now), dtype=np.uint16)),
        before=lambda: (before, np.zeros(len(before), dtype=np.uint16)),
        reach=1.35 * UNIT.reach,
        height=UNIT.height,
    ).answer()


def test_few_points_are_enough_where_the_cloud_is_sparse() -> None:
    rng = np.random.default_rng(1)
    before = seen_from_above(POSE, rng, 60, 0.01).points
    few = seen_from_above(POSE.shifted([0.04, 0.0, -0.03]), rng, 45, 0.01).points
    answer = asked(few, before)
    assert answer["state"].tolist() == ["there"]
    assert len(answer["points"]) >= 40
    assert np.linalg.norm(answer["centre"][0] - [0.04, 0.0, -0.03]) < 0.02
    # the same number among many is a small part of the surface
    ground = np.column_stack([rng.uniform(-1.5, 1.5, (20000, 2)), rng.normal(-1.7, 0.01, 20000)])
    assert asked(np.vstack([few, ground]), before)["state"].tolist() == ["hidden"]


def test_a_unit_is_not_taken_up_inside_another_one() -> None:
    rng = np.random.default_rng(2)
    before, now = (seen_from_above(POSE, rng, 900, 0.01).points for _ in range(2))
    beside, inside = (fitted(Pose(np.array([way * UNIT.height, 0.0, 0.0]), POSE.rotation), np.zeros((0, 3))) for way in (1.2, 0.4))
    assert asked(now, before, (beside,))["state"].tolist() == ["there"]
    answer = asked(now, before, (beside, inside))
    assert answer["state"].tolist() == ["hidden"]
    assert not len(answer["points"])
