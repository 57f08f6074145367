"""A displacement that the points leave open in some direction is held at rest there, unless the test of rest speaks against it."""

from __future__ import annotations

from collections.abc import Mapping
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import UNIT
from tetratrack.core.deformation.displacement import turn_vector
from tetratrack.core.deformation.epoch_pairs import TrackedUnits
from tetratrack.core.deformation.identity import Track
from tetratrack.core.deformation.joint_records import JointAdjustment
from tetratrack.core.deformation.open_displacements import hold_open_displacements
from tetratrack.core.deformation.tracked_epoch import TrackedUnit
from tetratrack.core.model.pose import Pose

COMMON = np.array([0.02, -0.01, 0.0])
"""Shift of the later cloud, metres."""
LEG = np.array([0.0, 0.6, 0.8])
SD, OPEN_SD = 0.003, 0.05 * UNIT.height
ROTATION = Rotation.from_euler("xyz", [0.3, 0.4, 0.5]).as_matrix()


def tracked(
    shift: np.ndarray, turn: np.ndarray, open_shift: bool = True, open_turn: bool = False, status: str = "found", relocated: bool = False
) -> TrackedUnits:
    """A row of twelve units with the common shift; number 5 moves besides, and its second epoch leaves the way along a leg, or the turn
    about it, open."""
    poses = [Pose(np.array([2.0 * k, 0.1 * k, 0.0]), ROTATION) for k in range(12)]
    states, tracks, covariances = [], [], {}
    for k, pose in enumerate(poses):
        own = np.diag(np.full(12, SD**2))
        if k == 5:
            own[6:9, 6:9] += open_shift * OPEN_SD**2 * np.outer(LEG, LEG)
            own[9:, 9:] += open_turn * np.outer(LEG, LEG)
        after = pose.perturbed(COMMON + (shift if k == 5 else 0), turn if k == 5 else np.zeros(3))
        covariances[k] = own
        states.append(
            {
                e: TrackedUnit(
                    row=k, pose=(pose, after)[e], covariance=own[6 * e : 6 * e + 6, 6 * e : 6 * e + 6], scale=1.0,
                    status=status if k == 5 else "found", points=50,
                )
                for e in (0, 1)
            }
        )  # fmt: skip
        far = frozenset({1}) if relocated and k == 5 else frozenset()
        tracks.append(Track(kind=0, rows={0: k, 1: k}, symmetries={}, ambiguous=frozenset(), relocated=far))
    numbers = {(k, e): 2 * k + e for k in range(12) for e in (0, 1)}
    order = {k: (2 * k, 2 * k + 1) for k in range(12)}
    joint = cast(JointAdjustment, SimpleNamespace(covariances=covariances, order=order))
    return TrackedUnits(types=[UNIT], tracks=tracks, states=states, joint=joint, numbers=numbers)


def motion(states: Mapping[int, TrackedUnit]) -> tuple[np.ndarray, np.ndarray]:
    before, after = (states[e].pose for e in (0, 1))
    assert before is not None
    assert after is not None
    return after.centre - before.centre, turn_vector(before, after)


def test_what_is_open_is_held_and_what_is_told_stays() -> None:
    across = np.array([0.004, 0.0, 0.0])
    units = tracked(1.5 * OPEN_SD * LEG + across, np.zeros(3))
    held = hold_open_displacements(units)
    assert motion(held[5])[0] == pytest.approx(COMMON + across, abs=1e-6)
    assert [held[5][e].held for e in (0, 1)] == [False, True]
    # the pose that was open is the one that gives way
    before, after = held[5][0].pose, units.states[5][0].pose
    assert before is not None
    assert after is not None
    assert np.linalg.norm(before.centre - after.centre) < 0.01 * OPEN_SD
    assert held[5][1].covariance is units.states[5][1].covariance
    assert not any(state.held for k, own in enumerate(held) if k != 5 for state in own.values())


def test_a_turn_about_a_leg_is_held_too() -> None:
    units = tracked(np.zeros(3), 0.4 * LEG, open_shift=False, open_turn=True)
    shift, turn = motion(hold_open_displacements(units)[5])
    assert shift == pytest.approx(COMMON, abs=1e-6)
    assert turn == pytest.approx(np.zeros(3), abs=1e-3)


@pytest.mark.parametrize(
    "units",
    [
        tracked(5 * OPEN_SD * LEG, np.zeros(3)),
        tracked(1.5 * OPEN_SD * LEG + np.array([0.05, 0.0, 0.0]), np.zeros(3)),
        tracked(0.01 * LEG, np.zeros(3), open_shift=False),
        tracked(1.5 * OPEN_SD * LEG, np.zeros(3), status="uncertain"),
        tracked(1.5 * OPEN_SD * LEG, np.zeros(3), relocated=True),
    ],
    ids=["moved along the leg", "moved across it", "told", "weak evidence", "carried off"],
)
def test_others_keep_their_poses(units: TrackedUnits) -> None:
    held = hold_open_displacements(units)
    assert [own == other for own, other in zip(held, units.states, strict=True)] == [True] * 12
