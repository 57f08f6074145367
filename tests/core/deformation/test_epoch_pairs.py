"""Two epochs compared: what the tests of a unit that turned rest on."""

from __future__ import annotations

from datetime import UTC, datetime
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import UNIT, grid_poses
from tetratrack.core.deformation.congruence import f_p_value
from tetratrack.core.deformation.epoch_pairs import TrackedUnits, compare_epochs
from tetratrack.core.deformation.identity import Track
from tetratrack.core.deformation.joint_records import JointAdjustment
from tetratrack.core.deformation.tracked_epoch import TrackedEpoch, TrackedUnit

ALIKE, DIFFERS = 0.003, 0.001
"""What the poses of both epochs err by alike as seen from the body, and by what they differ, metres."""
TRUE_SHARE = 0.4
"""Of the deviations that are stated of what the poses differ by."""
TURNED = 4


def surveyed() -> tuple[TrackedUnits, list[TrackedEpoch]]:
    """Units at rest and one turned by 70 degrees, as the joint adjustment states them."""
    rng = np.random.default_rng(5)
    poses = grid_poses(rng, 6)
    tracks = [Track(kind=0, rows={0: k, 1: k}, symmetries={}, ambiguous=frozenset()) for k in range(len(poses))]
    states, covariances = [], {}
    for k, pose in enumerate(poses):
        turn = np.radians([70.0, 0.0, 0.0]) * (k == TURNED)
        turned = np.kron(np.eye(2), Rotation.from_rotvec(turn).as_matrix())
        rows = np.block([[np.eye(6), -0.5 * np.eye(6)], [turned, 0.5 * turned]])
        both = rows @ np.diag(np.repeat([ALIKE**2, DIFFERS**2], 6)) @ rows.T
        error = TRUE_SHARE * rng.normal(0, DIFFERS, 6)
        after = pose.perturbed(error[:3] + 0.05 * (k == TURNED), error[3:]).perturbed(np.zeros(3), turn)
        covariances[k] = both
        states.append(
            {
                e: TrackedUnit(
                    row=k, pose=own, covariance=both[6 * e : 6 * e + 6, 6 * e : 6 * e + 6], scale=1.0, status="found", points=900
                )
                for e, own in enumerate((pose, after))
            }
        )  # fmt: skip
    order = {k: (2 * k, 2 * k + 1) for k in range(len(poses))}
    joint = cast(JointAdjustment, SimpleNamespace(covariances=covariances, order=order))
    numbers = {(k, e): 2 * k + e for k in range(len(poses)) for e in (0, 1)}
    epochs = [TrackedEpoch(label=str(year), time=datetime(year, 5, 1, tzinfo=UTC), units=(), registration=None) for year in (2024, 2025)]
    return TrackedUnits(types=[UNIT], tracks=tracks, states=states, joint=joint, numbers=numbers), epochs


def test_degrees_of_freedom_are_those_of_the_covariance_that_is_stated() -> None:
    """What a turned unit errs by is mostly its casting's, of which units at rest say nothing: its own part is the larger share.

    The sum of own part and frame has the degrees of Satterthwaite (1946), the frame's being known to many.
    """
    units, epochs = surveyed()
    pair = compare_epochs(units, epochs, 0, 1, None)
    null = pair.congruence.null
    assert null.factor < 0.6
    own = {}
    for unit in pair.units:
        motion, frame = unit.motions["stable"], unit.frames["stable"].covariance[:3, :3]
        share = np.trace(frame)
        own[unit.unit] = (np.trace(motion.covariances[0]) - share) / null.spread
        degrees = null.tail * (1 + share / own[unit.unit]) ** 2
        assert motion.p_values[0] == pytest.approx(f_p_value(motion.statistics[:1], degrees)[0], rel=1e-6)
    assert own[TURNED] > 10 * np.median(list(own.values()))
