"""Tracking of a synthetic pile through three epochs: identity, status, datums, velocities, rows."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from functools import cache
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import ALL_DISCS, UNIT, grid_poses, seen_from_above
from tetratrack.core.deformation.checked_units import CrossChecks
from tetratrack.core.deformation.congruence import PoseCalibration
from tetratrack.core.deformation.displacement import grades_from
from tetratrack.core.deformation.fitted_unit import FittedUnit
from tetratrack.core.deformation.identity import Track
from tetratrack.core.deformation.joint_records import JointAdjustment
from tetratrack.core.deformation.missing_units import Around, Surroundings
from tetratrack.core.deformation.questions import Answer, Question
from tetratrack.core.deformation.tracked_epoch import TrackedEpoch, TrackedUnit
from tetratrack.core.deformation.tracking import Tracking, track, with_poses
from tetratrack.core.deformation.unit_clouds import HeldPoints, UnitCloud
from tetratrack.core.deformation.unit_states import doubted_where_open, odd_sizes, states_of
from tetratrack.core.model.pose import Pose
from tetratrack.core.pipeline.displacement_table import (
    TableOptions,
    cross_check_rows,
    displacement_rows,
    pair_rows,
    unit_names,
    velocity_rows,
)
from tetratrack.core.registration.transformation import Transformation
from tetratrack.core.results.schema import LAYERS

MOVE = np.array([0.06, -0.03, -0.02])
CREEP = np.array([0.02, 0.0, -0.01])
GONE, HIDDEN, MOVED, CREEPS = 3, 6, 9, 12
REGISTRATION = np.diag([0.004**2] * 3 + [0.0005**2] * 3 + [0.0])


def misplaced(rng: np.random.Generator) -> Transformation:
    """A registration that errs by 4 mm an axis, as its covariance says."""
    return Transformation(
        origin_from=np.zeros(3),
        origin_to=np.zeros(3),
        translation=rng.normal(0, 0.004, 3),
        rotation=np.eye(3),
        scale=1.0,
        covariance=REGISTRATION,
    )


@cache
def surveyed() -> tuple[tuple[TrackedEpoch, ...], list[Pose], list[list[int]], Surroundings]:
    """Sixteen units: one moves after the first epoch, one creeps, one is taken away, one is covered in the second epoch."""
    rng = np.random.default_rng(13)
    poses = grid_poses(rng)
    epochs: list[TrackedEpoch] = []
    clouds = []
    order = []
    for number in range(3):
        error = misplaced(rng)
        offsets = rng.normal(0, 0.008, (3, 3))
        offsets -= offsets.mean(axis=0)
        units, points, names = [], [], []
        for k, pose in enumerate(poses):
            if k == GONE and number > 0:
                ground = np.column_stack([rng.uniform(-1, 1, (1500, 2)), np.full(1500, -1.6)]) + pose.centre
                points.append(ground)
                continue
            if k == HIDDEN and number == 1:
                points.append(np.column_stack([rng.uniform(-1.4, 1.4, (3000, 2)), np.full(3000, 1.9)]) + pose.centre)
                continue
            shift = MOVE * (k == MOVED and number > 0) + CREEP * (number if k == CREEPS else 0)
            placed = pose.shifted(shift)
            cloud = seen_from_above(placed, rng, 900, 0.01, offsets)
            seen = error.apply(cloud.points)
            start = error.apply_pose(placed).perturbed(rng.normal(0, 0.005, 3), rng.normal(0, 0.003, 3))
            relabelled = start.relabelled(UNIT.symmetries[rng.integers(12)])
            units.append(
                FittedUnit(
                    pose=relabelled, shape=UNIT, kind=0, certain=True, discs=ALL_DISCS, cloud=UnitCloud.held(seen, cloud.sources + 1)
                )
            )
            points.append(seen)
            names.append(k)
        epochs.append(
            TrackedEpoch(
                label=str(number), time=datetime(2020 + number, 1, 1, tzinfo=UTC), units=tuple(units), registration=error, redundancy=15
            )
        )
        clouds.append(np.vstack(points))
        order.append(names)

    def surroundings(epoch: int, places: np.ndarray, reach: float) -> Around:
        near = np.linalg.norm(clouds[epoch][:, None] - places[None], axis=2).min(axis=1) < reach
        return HeldPoints(clouds[epoch][near], np.ones(int(near.sum()), dtype=np.int64))

    return tuple(epochs), poses, order, surroundings


@cache
def tracked() -> tuple[Tracking, tuple[TrackedEpoch, ...], list[Pose], list[list[int]]]:
    epochs, poses, order, surroundings = surveyed()
    return track(epochs, [UNIT], surroundings), epochs, poses, order


def scattered(count: int) -> list[Pose]:
    """Units in random orientation, well apart."""
    rng = np.random.default_rng(8)
    return [
        Pose(np.array([3.2 * (k % 10), 3.2 * (k // 10), 0.2 * (k % 3)]), rotation)
        for k, rotation in enumerate(Rotation.random(count, random_state=rng).as_matrix())
    ]


def of_unit(number: int) -> tuple[int, dict[int, Any]]:
    """Index in the result and states of a unit by its true number."""
    result, _, _, order = tracked()
    for k, states in enumerate(result.units):
        if states[0].row is not None and order[0][states[0].row] == number:
            return k, states
    raise KeyError(number)


def test_every_unit_is_one_track() -> None:
    result, _, _, order = tracked()
    assert len(result.units) == 16
    for states in result.units:
        assert len({order[e][s.row] for e, s in states.items() if s.row is not None}) == 1


def test_status_of_lost_and_covered_units() -> None:
    assert {e: s.status for e, s in of_unit(GONE)[1].items()} == {0: "found", 1: "lost", 2: "lost"}
    assert {e: s.status for e, s in of_unit(HIDDEN)[1].items()} == {0: "found", 1: "unseen", 2: "found"}
    assert of_unit(HIDDEN)[1][1].pose is None


def test_leg_numbers_are_carried() -> None:
    for states in tracked()[0].units:
        first = next(s for s in states.values() if s.pose is not None)
        for state in states.values():
            if state.pose is not None:
                assert np.allclose(state.pose.rotation, first.pose.rotation, atol=0.02)


def test_moved_and_stable_units_in_both_datums() -> None:
    result, _, _, _ = tracked()
    pair = result.pairs[0]
    moved, creeping = of_unit(MOVED)[0], of_unit(CREEPS)[0]
    for motion in pair.units:
        true = MOVE if motion.unit == moved else CREEP if motion.unit == creeping else np.zeros(3)
        assert np.allclose(motion.motions["stable"].vectors[0], true, atol=0.008)
        assert (motion.classes["stable"] == "moved") == bool(true.any())
        assert motion.motions["control"].covariances[0].trace() > motion.motions["stable"].covariances[0].trace()
        assert (motion.motions["stable"].detectable < motion.motions["control"].detectable).all()
    assert not dict(zip([m.unit for m in pair.units], pair.congruence.stable.tolist(), strict=True))[moved]
    assert pair.congruence.common_p_value > 0.001


def test_velocity_of_the_creeping_unit() -> None:
    result = tracked()[0]
    unit = of_unit(CREEPS)[0]
    centre = result.velocities[unit][0]
    assert np.allclose(centre.vector, CREEP, atol=0.004)
    quiet = [v[0] for k, v in result.velocities.items() if k not in (unit, of_unit(MOVED)[0])]
    assert max(np.linalg.norm(v.vector) for v in quiet) < 0.006


def test_velocities_vary_as_they_say() -> None:
    """Seventy quiet units in four epochs, the first of which misses one, their covariance understated by 3: normalised velocities have
    variance 1."""
    rng = np.random.default_rng(3)
    sds = np.repeat([0.006, 0.004], 3)
    epochs = []
    for number in range(4):
        placed = misplaced(rng)
        errors = rng.normal(0, sds, (70, 6))
        poses = [p.perturbed(e[:3] + placed.translation, e[3:]) for p, e in zip(scattered(70), errors, strict=True)]
        units = tuple(
            FittedUnit(
                pose=pose, shape=UNIT, kind=0, certain=True, discs=ALL_DISCS, cloud=UnitCloud.none(), covariance=np.diag((sds / 3) ** 2)
            )
            for pose in poses[number == 0 :]
        )
        epochs.append(
            TrackedEpoch(label=str(number), time=datetime(2020 + number, 1, 1, tzinfo=UTC), units=units, registration=placed, redundancy=15)
        )
    velocities = track(epochs, [UNIT]).velocities
    assert len(velocities) == 70
    for feature in (0, 1, 4):
        normalised = np.array([v[feature].vector / v[feature].sd for v in velocities.values()])
        # 210 values: their mean square has a standard deviation of 0.1
        assert 0.75 < np.mean(normalised**2) < 1.3
        assert np.mean([v[feature].misfit_p_value < 0.05 for v in velocities.values()]) < 0.15


def test_cross_checks_agree() -> None:
    checks = tracked()[0].cross_checks
    assert len(checks) >= 26
    assert np.mean([c.agrees is True for c in checks.values()]) > 0.9


def test_cross_checks_are_asked_for_in_parts_while_pairs_are_compared() -> None:
    epochs, _, _, surroundings = surveyed()
    asked: list[list[Question]] = []

    def elsewhere(questions: Sequence[Question], beside: Callable[[], None] = lambda: None) -> list[Answer]:
        asked.append(list(questions))
        answers = [copy.answer() for copy in pickle.loads(pickle.dumps(asked[-1]))]  # noqa: S301
        beside()
        return answers

    checks, others = tracked()[0].cross_checks, track(epochs, [UNIT], surroundings, ask=elsewhere).cross_checks
    assert {type(question) for question in asked[-1]} == {CrossChecks}
    # two pairs of epochs, four parts each
    assert len(asked[-1]) == 8
    assert checks.keys() == others.keys()
    for key, check in checks.items():
        assert np.array_equal(others[key].vector, check.vector, equal_nan=True)
        assert np.array_equal(others[key].covariance, check.covariance, equal_nan=True)
        assert (others[key].agrees, others[key].reason) == (check.agrees, check.reason)


def test_rows_fit_their_layers() -> None:
    result, epochs, _, _ = tracked()
    names = unit_names(len(result.units))
    section = {"watch": 0.05, "alert": 0.1, "partly_damaged": 0.5, "damaged": 1.0, "dislocated": 1.0}
    options = TableOptions((1000.0, 2000.0, 0.0), 0.05, grades_from(section))
    main, other = displacement_rows(result, epochs, [UNIT], names, options)
    for layer, rows in (
        ("displacements", main),
        ("displacements_other", other),
        ("epoch_pairs", pair_rows(result, epochs, np.zeros(3))),
        ("velocities", velocity_rows(result, epochs, names, np.zeros(3))),
        ("cross_checks", cross_check_rows(result, epochs, names, np.zeros(3))),
    ):
        assert rows
        assert all(set(row) == {*LAYERS[layer].names, "geometry"} for row in rows)
    assert {(r["epoch_from"], r["epoch_to"], r["datum"]) for r in main} == {("0", "1", "stable"), ("1", "2", "stable")}
    assert {(r["epoch_from"], r["epoch_to"], r["datum"]) for r in other} == {
        ("0", "1", "control"),
        ("1", "2", "control"),
        ("0", "2", "stable"),
        ("0", "2", "control"),
    }
    row = next(r for r in main if r["unit_id"] == names[of_unit(MOVED)[0]] and r["feature"] == "centre" and r["epoch_to"] == "1")
    assert row["grade"] == "watch"
    assert row["significant"]
    start, stop = row["geometry"]
    assert np.allclose(stop - start, [row["de"], row["dn"], row["dh"]])
    assert start[0] > 990


def test_without_points_the_fits_alone_are_tracked() -> None:
    _, epochs, _, _ = tracked()
    bare = [
        TrackedEpoch(
            label=e.label,
            time=e.time,
            units=tuple(
                FittedUnit(
                    pose=u.pose, shape=UNIT, kind=0, certain=True, discs=u.discs, cloud=UnitCloud.none(), covariance=np.eye(6) * 0.005**2
                )
                for u in e.units
            ),
            registration=e.registration,
        )
        for e in epochs
    ]
    result = track(bare, [UNIT])
    assert len(result.units) == 16
    assert not result.cross_checks
    classes = [m.classes["stable"] for m in result.pairs[0].units]
    assert classes.count("moved") == 1
    assert {s.status for states in result.units for s in states.values()} == {"found", "unseen"}


@pytest.mark.parametrize("counts", [(600, 40), (40, 40), (12, 12)])
def test_an_epoch_of_few_points_is_tracked_too(counts: tuple[int, int]) -> None:
    """No patch of any surface holds enough points to tell the noise of the epoch."""
    rng = np.random.default_rng(5)
    poses = grid_poses(rng)[:4]
    epochs = []
    for number, count in enumerate(counts):
        clouds = [seen_from_above(pose, rng, count, 0.01, np.zeros((1, 3))) for pose in poses]
        units = tuple(
            FittedUnit(pose=p, shape=UNIT, kind=0, certain=True, discs=ALL_DISCS, cloud=UnitCloud.held(c.points, c.sources + 1))
            for p, c in zip(poses, clouds, strict=True)
        )
        epochs.append(TrackedEpoch(label=str(number), time=datetime(2020 + number, 1, 1, tzinfo=UTC), units=units, registration=None))
    result = track(epochs, [UNIT])
    assert np.isfinite(result.joint.noise).all()
    for states in result.units:
        assert all(np.isfinite(state.covariance).all() for state in states.values())


def test_what_comes_out_in_another_size_is_uncertain() -> None:
    """The points of one unit are of a larger body: it was taken for what it is not."""
    rng = np.random.default_rng(6)
    poses = grid_poses(rng)
    odd = 5
    epochs = []
    for number in range(2):
        units = []
        for k, pose in enumerate(poses):
            cloud = seen_from_above(pose, rng, 900, 0.005, np.zeros((1, 3)))
            points = cloud.points + 0.03 * (cloud.points - pose.centre) * (k == odd)
            units.append(
                FittedUnit(pose=pose, shape=UNIT, kind=0, certain=True, discs=ALL_DISCS, cloud=UnitCloud.held(points, cloud.sources + 1))
            )
        epochs.append(
            TrackedEpoch(label=str(number), time=datetime(2020 + number, 1, 1, tzinfo=UTC), units=tuple(units), registration=None)
        )
    result = track(epochs, [UNIT])
    statuses = [{state.status for state in states.values()} for states in result.units]
    assert statuses == [{"uncertain"} if k == odd else {"found"} for k in range(len(poses))]


def test_one_epoch() -> None:
    _, epochs, _, _ = tracked()
    result = track(epochs[:1], [UNIT])
    assert result.pairs == ()
    assert len(result.units) == 16


def test_deviations_of_one_epoch_do_not_depend_on_a_unit_that_could_not_be_fitted() -> None:
    """One scan from one station: nothing ties its units, and each keeps what its own fit says."""
    rng = np.random.default_rng(8)
    units = []
    for pose in grid_poses(rng)[:4]:
        cloud = seen_from_above(pose, rng, 400, 0.005, np.zeros((1, 3)))
        held = UnitCloud.held(cloud.points, np.ones(len(cloud.points), dtype=np.uint16))
        units.append(FittedUnit(pose=pose, shape=UNIT, kind=0, certain=True, discs=ALL_DISCS, cloud=held, covariance=np.eye(6) * 0.007**2))
    time = datetime(2020, 1, 1, tzinfo=UTC)
    for last in (units[-1], replace(units[-1], certain=False, covariance=None)):
        epoch = TrackedEpoch(label="0", time=time, units=(*units[:-1], last), registration=None)
        result = track([epoch], [UNIT])
        for k in range(3):
            covariance = result.units[k][0].covariance
            assert covariance is not None
            assert np.diag(covariance) == pytest.approx(0.007**2)


@pytest.mark.parametrize("count", [1, 2])
def test_no_units_at_all(count: int) -> None:
    _, epochs, _, _ = tracked()
    empty = [TrackedEpoch(label=e.label, time=e.time, units=(), registration=e.registration) for e in epochs[:count]]
    assert track(empty, [UNIT]).units == ()


def test_points_are_read_home_by_home_with_the_same_result() -> None:
    """As from the files of four blocks: every look at all units opens each file once, whatever the order of the units."""
    epochs, _, _, surroundings = surveyed()
    opened: dict[int, list[int]] = {0: [], 1: [], 2: []}
    looked_at: list[int] = []

    def filed(epoch: int, unit: FittedUnit) -> FittedUnit:
        block = int(unit.pose.centre[0] > 4) + 2 * int(unit.pose.centre[1] > 4)

        def read() -> tuple[np.ndarray, np.ndarray]:
            if opened[epoch][-1:] != [block]:
                opened[epoch].append(block)
            return unit.cloud.read()

        return replace(unit, cloud=UnitCloud(unit.cloud.ids, read, (epoch, block)))

    def around(epoch: int, places: np.ndarray, reach: float) -> Around:
        looked_at.append(len({(x > 4, y > 4) for x, y, _ in places}))
        return surroundings(epoch, places, reach)

    blocks = [replace(e, units=tuple(filed(k, u) for u in e.units)) for k, e in enumerate(epochs)]
    held, read = tracked()[0], track(blocks, [UNIT], around)
    assert looked_at
    assert set(looked_at) == {1}
    # at most eight rounds with noise estimated in four, the cross checks, and the look-up of missing units with their neighbours
    assert max(len(blocks) for blocks in opened.values()) < 4 * (8 + 4 + 1) + 16
    assert [{e: s.status for e, s in unit.items()} for unit in read.units] == [
        {e: s.status for e, s in unit.items()} for unit in held.units
    ]
    for states, others in zip(held.units, read.units, strict=True):
        for epoch, state in states.items():
            if state.pose is not None:
                assert np.allclose(state.pose.centre, others[epoch].pose.centre, rtol=0, atol=1e-12)
                assert np.allclose(state.covariance, others[epoch].covariance, rtol=1e-9)
    assert {key: c.agrees for key, c in held.cross_checks.items()} == {key: c.agrees for key, c in read.cross_checks.items()}


def test_stretches_state_their_common_motion() -> None:
    pair = tracked()[0].pairs[0]
    for datum in ("stable", "control"):
        for stretch in pair.stretches[datum]:
            assert stretch.units >= 5
            assert stretch.p_value > 0.001
            assert np.linalg.norm(stretch.motion) < 0.02
            assert stretch.detectable > 2 * np.sqrt(np.linalg.eigvalsh(stretch.covariance)[-1])


@pytest.mark.parametrize(("open_epoch", "detected", "status"), [(1, False, "unseen"), (1, True, "uncertain"), (0, False, None)])
def test_a_pose_that_its_points_leave_open_is_none(open_epoch: int, detected: bool, status: str | None) -> None:
    """A unit looked up where another epoch predicts it, which its adjustment lets go, has no pose there; a detected one is uncertain."""
    sure = FittedUnit(
        pose=Pose(np.zeros(3), np.eye(3)),
        shape=UNIT,
        kind=0,
        certain=True,
        discs=ALL_DISCS,
        cloud=UnitCloud.held(*seen_nothing()),
        score=1.0,
    )
    spread = np.concatenate([np.full(6, 1e-6), np.full(6, 1e-6)])
    spread[6 * open_epoch : 6 * open_epoch + 3] = (0.3 * UNIT.height) ** 2
    joint = cast(
        JointAdjustment,
        SimpleNamespace(
            covariances={0: np.diag(spread)}, order={0: (0, 1)}, poses=(sure.pose, sure.pose), scales={0: 0.0}, used=np.array([90, 90])
        ),
    )
    rows = {e: 0 for e in (0, 1) if detected or e != open_epoch}
    track = Track(kind=0, rows=rows, symmetries={}, ambiguous=frozenset(), relocated=frozenset())
    found = states_of(0, track, {0: sure, 1: sure}, {}, joint, {(0, 0): 0, (0, 1): 1}, 2, False)
    assert found[1 - open_epoch].status == "found"
    assert (found[open_epoch].status if open_epoch in found else None) == status
    assert status != "unseen" or found[open_epoch].pose is None
    # nor is there anything to check by direct registration
    assert sorted(with_poses({0: sure, 1: sure}, found)) == ([0, 1] if detected else [1 - open_epoch])


def test_a_found_pose_is_doubted_where_what_is_known_of_covariances_leaves_it_open() -> None:
    """Units at rest say that true deviations are twice the adjusted ones: what was known to 4 % of the height is known to 8 %."""
    sds = {"found": (0.004, 0.04), "relocated": (0.04,)}
    states = [
        {
            0: TrackedUnit(
                row=0, pose=Pose(np.zeros(3), np.eye(3)), covariance=np.diag([(sd * UNIT.height) ** 2, *[1e-8] * 5]),
                scale=1.0, status=status, points=90,
            )
        }
        for status, own in sds.items()
        for sd in own
    ]  # fmt: skip
    assert doubted_where_open(states, [UNIT] * 3, [PoseCalibration.of_pairs([])]) is None
    found = doubted_where_open(states, [UNIT] * 3, [PoseCalibration.of_pairs([(2.0, 0.0, 1.0, 0.0)])])
    assert found is not None
    assert [own[0].status for own in found] == ["found", "uncertain", "relocated"]


@pytest.mark.parametrize(("turn_sd", "away", "status"), [(20, 0.55, "uncertain"), (20, 1.4, "found"), (2, 0.55, "found")])
def test_a_turn_that_the_room_alone_could_settle_is_doubted_where_there_is_none(turn_sd: float, away: float, status: str) -> None:
    """A unit whose turn is open to 20 degrees enters its neighbour; where it does not, or its points tell the turn, it stays.

    The other epoch shows the unit alone, and states the same turn.
    """
    states = [
        dict.fromkeys(
            epochs,
            TrackedUnit(
                row=0, pose=Pose(np.array([0.0, 0.0, place * UNIT.height]), np.eye(3)),
                covariance=np.diag([1e-6] * 5 + [np.radians(sd) ** 2]), scale=1.0, status="found", points=90,
            ),
        )
        for place, sd, epochs in ((0.0, 1.0, (0,)), (away, turn_sd, (0, 1)))
    ]  # fmt: skip
    found = doubted_where_open(states, [UNIT] * 2, [PoseCalibration.of_pairs([])] * 2) or states
    assert [state.status for own in found for state in own.values()] == ["found", status, status]


def seen_nothing() -> tuple[np.ndarray, np.ndarray]:
    return np.empty((0, 3)), np.empty(0, dtype=np.uint16)


def test_sizes_of_sure_units_are_held_against_what_castings_differ_by() -> None:
    """2 % of size is odd in a survey of alike units, unless the unit itself is beyond doubt."""
    scales = dict(enumerate([*np.random.default_rng(2).normal(0, 0.002, 20), 0.02]))
    joint = cast(
        JointAdjustment,
        SimpleNamespace(
            scales=scales,
            scale_sds=dict.fromkeys(scales, 1e-4),
            surfaces={UNIT: SimpleNamespace(size_sd=0.003)},
            noise=np.array([0.01, np.nan]),
        ),
    )
    for sure, odd in ((False, {20}), (True, set())):
        assert odd_sizes(joint, np.zeros(21, dtype=np.int64), [UNIT], np.full(21, sure)) == odd
    # points of other surfaces within the noise draw a size by as much
    for share, odd in ((0.021, set()), (0.004, {20})):
        joint.noise[0] = share * UNIT.height
        assert odd_sizes(joint, np.zeros(21, dtype=np.int64), [UNIT], np.full(21, False)) == odd
