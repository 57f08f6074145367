"""Two epochs compared: what units at rest tell of the standard deviations and tests of units that moved."""

from __future__ import annotations

from datetime import UTC, datetime
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import UNIT, grid_poses, unturned_pair
from tetratrack.core.deformation.displacement import FramePart, moved_share
from tetratrack.core.deformation.epoch_pairs import TrackedUnits, compare_epochs
from tetratrack.core.deformation.identity import Track
from tetratrack.core.deformation.joint_records import JointAdjustment
from tetratrack.core.deformation.null_model import NullModel, f_p_value
from tetratrack.core.deformation.tracked_epoch import TrackedEpoch, TrackedUnit
from tetratrack.core.model.pose import Pose

DIFFERS, NOISE = 0.001, 0.0007
"""Deviation per coordinate that is stated of what the poses of two epochs differ by, and what noise makes of it, metres and radians."""
TURNED, CARRIED, CREPT = 4, 9, 17


def surveyed(true_share: float) -> tuple[TrackedUnits, list[TrackedEpoch]]:
    """Units at rest, whose poses differ by a share of what the adjustment states, one turned by 8 degrees and one carried by 5 cm, which
    differ by all of it, and one that crept by 5 mm. What both poses of a unit err by alike is 3 mm."""
    rng = np.random.default_rng(5)
    poses = grid_poses(rng, 6)
    tracks = [Track(kind=0, rows={0: k, 1: k}, symmetries={}, ambiguous=frozenset()) for k in range(len(poses))]
    states, covariances, noise = [], {}, {}
    for k, pose in enumerate(poses):
        turn, way = np.radians([8.0, 0.0, 0.0]) * (k == TURNED), np.array([0.03, 0.0, 0.04]) * ((k == CARRIED) + 0.1 * (k == CREPT))
        turned = np.kron(np.eye(2), Rotation.from_rotvec(turn).as_matrix())
        rows = np.block([[np.eye(6), -0.5 * np.eye(6)], [turned, 0.5 * turned]])
        both, noise[k] = (rows @ np.diag(np.repeat([shared**2, own**2], 6)) @ rows.T for shared, own in ((0.003, DIFFERS), (0.0, NOISE)))
        error = (1.0 if k in (TURNED, CARRIED) else true_share) * rng.normal(0, DIFFERS, 6)
        after = pose.perturbed(error[:3] + way, error[3:]).perturbed(np.zeros(3), turn)
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
    joint = cast(JointAdjustment, SimpleNamespace(covariances=covariances, noise_covariances=noise, order=order))
    numbers = {(k, e): 2 * k + e for k in range(len(poses)) for e in (0, 1)}
    epochs = [TrackedEpoch(label=str(year), time=datetime(year, 5, 1, tzinfo=UTC), units=(), registration=None) for year in (2024, 2025)]
    return TrackedUnits(types=[UNIT], tracks=tracks, states=states, joint=joint, numbers=numbers), epochs


@pytest.mark.parametrize("true_share", [0.4, 1.5])
def test_a_factor_below_one_is_that_of_units_at_rest(true_share: float) -> None:
    """They show the same parts of their surfaces in both epochs, units that moved or turned do not; a factor beyond one is that of all."""
    units, epochs = surveyed(true_share)
    pair = compare_epochs(units, epochs, 0, 1, None)
    null = pair.congruence.null
    assert null.factor == pytest.approx(true_share, rel=0.35)
    for unit in pair.units:
        motion, frame = unit.motions["stable"], unit.frames["stable"].covariance[:3, :3]
        own = (motion.covariances[0] - frame) / null.spread - null.floor**2 * np.eye(3)
        stated = 3 * DIFFERS**2 + (4 * 0.003**2 * (1 - np.cos(np.radians(8.0))) if unit.unit == TURNED else 0.0)
        # noise is told at rest
        held = 3 * NOISE**2 if unit.unit in (TURNED, CARRIED) and null.factor < 1 else stated
        expected = null.factor**2 * held + stated - held
        found = np.trace(own)
        # what crept is nearly what rests
        assert found == pytest.approx(expected, rel=0.05) or (unit.unit == CREPT and expected < found < expected + 0.15 * stated)
    assert pair.units[CREPT].motions["stable"].p_values[0] < 0.01 or true_share > 1


def test_degrees_of_freedom_are_those_of_the_covariance_that_is_stated() -> None:
    """The own part of a unit that moved is no smaller for units at rest, and the test has the degrees of its sum with the frame's part,
    which is known to many (Satterthwaite, 1946)."""
    units, epochs = surveyed(0.4)
    pair = compare_epochs(units, epochs, 0, 1, None)
    null = pair.congruence.null
    for unit in pair.units:
        motion, share = unit.motions["stable"], np.trace(unit.frames["stable"].covariance[:3, :3])
        own = (np.trace(motion.covariances[0]) - share) / null.spread
        expected = f_p_value(motion.statistics[:1], null.tail * (1 + share / own) ** 2)
        assert motion.p_values[0] == pytest.approx(expected[0], rel=1e-6)
    assert {unit.unit for unit in pair.units if unit.classes["stable"] == "moved"} >= {CARRIED, CREPT}


def test_a_motion_that_is_not_known_is_no_sign_of_one() -> None:
    """Displacements as large as they are known to be leave a unit at rest, larger ones do not."""
    here = Pose(np.zeros(3), np.eye(3))
    still = NullModel(0.5, 0.0, 30.0, 0.1, 40)
    part = FramePart(motion=np.zeros(6), covariance=np.zeros((6, 6)), degrees=np.inf)
    for sd, way, least, most in ((0.05, 0.04, 0.0, 0.0), (0.001, 0.003, 0.0, 0.05), (0.001, 0.05, 0.95, 1.0)):
        joint = np.diag(np.repeat([0.5 * sd**2, 1e-10, 0.5 * sd**2, 1e-10], 3))
        unit = unturned_pair((here, here.shifted([way, 0.0, 0.0])), UNIT, joint)
        assert least <= moved_share(unit, still, part) <= most
