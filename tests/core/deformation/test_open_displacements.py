"""A displacement that the points leave open in some direction is held at rest there, unless its tests call it moved."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import UTC, datetime
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import UNIT, grid_poses, seen_from_above
from tetratrack.core.deformation.displacement import FramePart, turn_vector
from tetratrack.core.deformation.epoch_pairs import EpochPair, PairMotion, TrackedUnits
from tetratrack.core.deformation.fitted_unit import FittedUnit
from tetratrack.core.deformation.identity import Track
from tetratrack.core.deformation.joint_records import JointAdjustment
from tetratrack.core.deformation.open_displacements import hold_open_displacements
from tetratrack.core.deformation.tracked_epoch import TrackedEpoch, TrackedUnit
from tetratrack.core.deformation.tracking import Tracking, track
from tetratrack.core.deformation.unit_clouds import UnitCloud
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate

COMMON = np.array([0.02, -0.01, 0.0])
"""Shift of the later cloud, metres."""
LEG = np.array([0.0, 0.6, 0.8])
SD, OPEN_SD = 0.003, 0.05 * UNIT.height
ROTATION = Rotation.from_euler("xyz", [0.3, 0.4, 0.5]).as_matrix()


def tracked(shift: np.ndarray, turn: np.ndarray, open_shift: bool = True, open_turn: bool = False) -> TrackedUnits:
    """A unit whose second epoch leaves the way along a leg, or the turn about it, open; it moved with the frame, and besides."""
    pose = Pose(np.array([2.0, 0.1, 0.0]), ROTATION)
    both = np.diag(np.full(12, SD**2))
    both[6:9, 6:9] += open_shift * OPEN_SD**2 * np.outer(LEG, LEG)
    both[9:, 9:] += open_turn * np.outer(LEG, LEG)
    poses = (pose, pose.perturbed(COMMON + shift, turn))
    states = {
        e: TrackedUnit(
            row=0, pose=poses[e], covariance=both[6 * e : 6 * e + 6, 6 * e : 6 * e + 6], scale=1.0, status="found", points=50
        )
        for e in (0, 1)
    }  # fmt: skip
    track = Track(kind=0, rows={0: 0, 1: 0}, symmetries={}, ambiguous=frozenset())
    joint = cast(JointAdjustment, SimpleNamespace(covariances={0: both}, noise_covariances={0: both}, order={0: (0, 1)}))
    return TrackedUnits(types=[UNIT], tracks=[track], states=[states], joint=joint, numbers={(0, 0): 0, (0, 1): 1})


def compared(kind: str) -> EpochPair:
    """Both epochs, the unit judged to be of a class."""
    frame = FramePart(motion=np.concatenate([COMMON, np.zeros(3)]), covariance=np.zeros((6, 6)), degrees=30.0)
    unit = PairMotion(0, {}, {"stable": kind}, {"stable": 1.0}, {"stable": frame})
    return cast(EpochPair, SimpleNamespace(first=0, second=1, units=(unit,)))


def motion(states: Mapping[int, TrackedUnit]) -> tuple[np.ndarray, np.ndarray]:
    before, after = (states[e].pose for e in (0, 1))
    assert before is not None
    assert after is not None
    return after.centre - before.centre, turn_vector(before, after)


def test_what_is_open_is_held_and_what_is_told_stays() -> None:
    across = np.array([0.004, 0.0, 0.0])
    units = tracked(1.5 * OPEN_SD * LEG + across, np.zeros(3))
    held = hold_open_displacements(units, [compared("stable")])
    assert held is not None
    assert motion(held[0])[0] == pytest.approx(COMMON + across, abs=1e-6)
    assert [held[0][e].held for e in (0, 1)] == [False, True]
    # the pose that was open is the one that gives way
    before, after = held[0][0].pose, units.states[0][0].pose
    assert before is not None
    assert after is not None
    assert np.linalg.norm(before.centre - after.centre) < 0.01 * OPEN_SD
    assert held[0][1].covariance is units.states[0][1].covariance


def test_a_turn_about_a_leg_is_held_too() -> None:
    held = hold_open_displacements(tracked(np.zeros(3), 0.4 * LEG, open_shift=False, open_turn=True), [compared("stable")])
    assert held is not None
    shift, turn = motion(held[0])
    assert shift == pytest.approx(COMMON, abs=1e-6)
    assert turn == pytest.approx(np.zeros(3), abs=1e-3)


@pytest.mark.parametrize(
    ("kind", "is_open"), [("moved", True), ("rotated", True), ("uncertain", True), ("relocated", True), ("stable", False)]
)
def test_others_keep_their_poses(kind: str, is_open: bool) -> None:
    assert hold_open_displacements(tracked(1.5 * OPEN_SD * LEG, np.zeros(3), open_shift=is_open), [compared(kind)]) is None


SEEN_LITTLE = 5
"""The unit of which the later epoch sees a leg."""


def tracked_with_one_leg(seed: int) -> Tracking:
    """Units at rest in two epochs, of one of which the later sees 40 points of a leg and begins 80 mm along it."""
    rng = np.random.default_rng(seed)
    poses = grid_poses(rng)
    leg = 2
    epochs = []
    for number in range(2):
        units = []
        for k, pose in enumerate(poses):
            points = seen_from_above(pose, rng, 900, 0.01, np.zeros((1, 3))).points
            start = pose
            if k == SEEN_LITTLE and number == 1:
                on_leg = relate(pose.to_body(points), UNIT)
                points = points[(on_leg.leg == leg) & (on_leg.axial > 0.4 * UNIT.leg_length)][:40]
                start = pose.shifted(0.08 * pose.rotation @ UNIT.leg_directions[leg])
            cloud = UnitCloud.held(points, np.ones(len(points), dtype=np.int64))
            units.append(FittedUnit(pose=start, shape=UNIT, kind=0, certain=True, discs=np.zeros(4, dtype=np.bool_), cloud=cloud))
        time = datetime(2020 + number, 1, 1, tzinfo=UTC)
        epochs.append(TrackedEpoch(label=str(number), time=time, units=tuple(units), registration=None))
    return track(epochs, [UNIT])


def own_motion(result: Tracking) -> PairMotion:
    """Of the unit of which little is seen."""
    return next(m for m in result.pairs[0].units if m.unit == SEEN_LITTLE)


def test_a_unit_of_which_one_leg_is_seen_is_held_by_the_other_epoch() -> None:
    result = tracked_with_one_leg(11)
    states = result.units[SEEN_LITTLE]
    assert [states[e].held for e in (0, 1)] == [False, True]
    assert [states[e].status for e in (0, 1)] == ["found", "found"]
    assert own_motion(result).classes["stable"] == "uncertain"
    assert SEEN_LITTLE not in [result.pairs[0].units[k].unit for k in result.pairs[0].judged]
    # what is open is stated
    assert own_motion(result).motions["stable"].detectable[0] > 0.08


def test_the_displacement_of_a_unit_of_which_one_leg_is_seen_is_known_as_stated() -> None:
    """It is that of a unit at rest, mostly within 20 mm although the fit began 80 mm off, and its errors are as large as stated."""
    motions = [own_motion(tracked_with_one_leg(seed)).motions["stable"] for seed in range(1, 9)]
    away = [np.linalg.norm(motion.vectors[0]) for motion in motions]
    squares = [motion.vectors[0] @ np.linalg.solve(motion.covariances[0, :3, :3], motion.vectors[0]) / 3 for motion in motions]
    assert np.median(away) < 0.02
    assert 0.6 < np.mean(squares) < 1.6
