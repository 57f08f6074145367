"""Velocities of units over several epochs, whose poses share the error of the unit's casting."""

from __future__ import annotations

from datetime import UTC, datetime
from itertools import combinations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from scipy.stats import kstest
from synthetic_units import UNIT
from tetratrack.core.deformation.epoch_pairs import EpochPair, TrackedUnits, compare_epochs
from tetratrack.core.deformation.identity import Track
from tetratrack.core.deformation.joint_records import JointAdjustment
from tetratrack.core.deformation.tracked_epoch import TrackedEpoch, TrackedUnit
from tetratrack.core.deformation.velocities import velocities_of_units, velocity
from tetratrack.core.model.pose import Pose

EPOCHS, UNITS = 5, 60
OWN_SD = 0.002
TIMES = [datetime(2020 + e, 1, 1, tzinfo=UTC) for e in range(EPOCHS)]


def survey(seed: int, shared_sd: float, acceleration: float = 0.0, tail: float = np.inf) -> tuple[TrackedUnits, tuple[EpochPair, ...]]:
    """Units at rest, but for the first one that accelerates (m/a²), each with an error of its casting that all its poses share."""
    rng = np.random.default_rng(seed)
    poses: list[Pose] = []
    states: list[dict[int, TrackedUnit]] = []
    covariance = np.kron(np.ones((EPOCHS, EPOCHS)), shared_sd**2 * np.eye(6)) + OWN_SD**2 * np.eye(6 * EPOCHS)
    for unit, rotation in enumerate(Rotation.random(UNITS, random_state=rng).as_matrix()):
        place = Pose(np.array([3.2 * (unit % 10), 3.2 * (unit // 10), 0.2 * (unit % 3)]), rotation)
        shared = rng.normal(0, 1, 6) * shared_sd
        own = {}
        for epoch in range(EPOCHS):
            size = 1.0 if np.isinf(tail) else np.sqrt(tail / rng.chisquare(tail))
            error = shared + size * rng.normal(0, OWN_SD, 6)
            error[0] += 0.5 * acceleration * epoch**2 if unit == 0 else 0.0
            pose = place.perturbed(error[:3], error[3:])
            poses.append(pose)
            own[epoch] = TrackedUnit(row=unit, pose=pose, covariance=covariance[:6, :6], scale=1.0, status="found", points=100)
        states.append(own)
    numbers = {(unit, epoch): EPOCHS * unit + epoch for unit in range(UNITS) for epoch in range(EPOCHS)}
    order = {unit: tuple(numbers[unit, epoch] for epoch in range(EPOCHS)) for unit in range(UNITS)}
    joint = JointAdjustment(
        poses=tuple(poses), covariances=dict.fromkeys(order, covariance), noise_covariances=dict.fromkeys(order, covariance),
        order=order, offsets={}, offset_sds={},
        scales=dict.fromkeys(order, 0.0), scale_sds=dict.fromkeys(order, 0.001), noise=np.full(EPOCHS, 0.005), surface_sd=0.002,
        used=np.full(len(poses), 100),
    )  # fmt: skip
    tracks = [Track(dict.fromkeys(range(EPOCHS), unit), dict.fromkeys(range(EPOCHS), np.eye(3)), frozenset(), 0) for unit in range(UNITS)]
    units = TrackedUnits(types=[UNIT], tracks=tracks, states=states, joint=joint, numbers=numbers)
    epochs = [TrackedEpoch(label=str(e), time=TIMES[e], units=(), registration=None) for e in range(EPOCHS)]
    return units, tuple(compare_epochs(units, epochs, a, b, None) for a, b in combinations(range(EPOCHS), 2))


@pytest.mark.parametrize(("shared_sd", "tail"), [(0.0, np.inf), (0.01, np.inf), (0.01, 4.0)])
def test_what_a_casting_brings_into_all_epochs_is_not_in_its_velocity(shared_sd: float, tail: float) -> None:
    squares, misfits = [], []
    for seed in range(2):
        units, pairs = survey(seed, shared_sd, tail=tail)
        found = [own[0] for own in velocities_of_units(units, TIMES, pairs).values()]
        assert len(found) == UNITS
        squares.append(np.mean([(v.vector / v.sd) ** 2 for v in found]))
        misfits += [v.misfit_p_value for v in found]
    # 360 values: their mean square has a standard deviation of 0.075, more with long tails
    assert 0.75 < np.mean(squares) < 1.3
    assert 0.4 < np.mean(misfits) < 0.6
    assert np.mean(np.array(misfits) < 0.05) < 0.12


def test_a_unit_that_accelerates_is_no_uniform_motion() -> None:
    units, pairs = survey(3, 0.01, acceleration=0.01)
    assert velocities_of_units(units, TIMES, pairs)[0][0].misfit_p_value < 0.001


def test_velocity_of_a_creeping_unit() -> None:
    rng = np.random.default_rng(0)
    years = np.array([0.0, 0.5, 1.0, 2.0, 3.0])
    true = np.array([0.01, -0.02, -0.005])
    own = 0.002**2 * np.eye(15)
    scores = []
    for _ in range(60):
        positions = years[:, None] * true + rng.normal(0, 0.002, (5, 3))
        v = velocity(0, years, positions, own, np.zeros((15, 15)), 200.0, 1.0)
        scores += ((v.vector - true) / v.sd).tolist()
    assert kstest(scores, "norm").pvalue > 0.01
    bent = np.array([0, 0, 0, 0.05, 0.05])[:, None] * np.ones(3)
    assert velocity(0, years, bent, own, np.zeros((15, 15)), 200.0, 1.0).misfit_p_value < 1e-6
