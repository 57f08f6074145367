"""Units through all epochs: identity, joint adjustment, datum, displacements. Arrays in, frozen results out; no files.

Everything here is in the control frame less one reduction point.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import block_diag
from scipy.spatial import cKDTree

from .congruence import Congruence, NullModel, PoseCalibration, calibrate, congruence_of
from .control import Transformation, mean_offset_variance
from .cross_check import CrossCheck, cross_check
from .displacement import (
    SECONDS_PER_YEAR,
    UnitMotion,
    Velocity,
    adjusted_p_values,
    classify,
    relative_covariance,
    turn_covariance,
    turn_vector,
    unit_motion,
    velocity,
)
from .feature_points import FEATURES, FeaturePoints, feature_points
from .fitted_unit import FittedUnit
from .identity import FoundUnits, Track, identify
from .pose import Pose
from .presence import look_up
from .relocation import join_relocated
from .strip_offsets import HEIGHT_SPREAD, JointAdjustment, UnitSighting, adjust_jointly
from .unit_clouds import UnitCloud, by_home
from .unit_types import UnitType

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

DATUMS = ("stable", "control")
MIN_RECOVERED_POINTS = 60
LOOK_UP_REACHES = 1.35
"""Distance from a missing unit's centre, in reaches of a unit, in which its place is looked at."""
SAME_POINT = 1e-4
"""Distance in metres below which a point of the cloud is the point of a unit."""
ODD_SIZE = 4.5
"""Deviation of a unit's size from that of the others, in standard deviations, above which something else was fitted."""
RECOVERED_SCORE = 0.8
"""Probability below which one detection does not vouch for the unit in an epoch where it was not detected."""


@dataclass(frozen=True, eq=False)
class TrackedEpoch:
    """One epoch to be tracked.

    Attributes
    ----------
    label, time
        As in survey.toml.
    units
        Found units.
    registration
        Transformation to control, its reduction point ``origin_to`` already less the common one; None without control.
    redundancy
        Of the registration.
    tied_to
        Index of the epoch that this one was registered to on stable areas, so that it shares that one's error; None for control.
    offset_variance
        Variance of the mean offset of the epoch's strips or stations per axis, square metres: what a registration cannot know.
    """

    label: str
    time: datetime
    units: tuple[FittedUnit, ...]
    registration: Transformation | None
    redundancy: int = 0
    tied_to: int | None = None
    offset_variance: float = 0.0

    @property
    def placement(self) -> Transformation | None:
        """The registration with the mean offset of the strips, as a common shift, added to its covariance."""
        return None if self.registration is None else self.registration.with_offset(self.offset_variance)


@dataclass(frozen=True, eq=False)
class TrackedUnit:
    """A physical unit in one epoch.

    Attributes
    ----------
    row
        Its row in the epoch's units; None where it was recovered at the place another epoch predicts, or is not seen.
    pose, covariance
        Pose of the joint adjustment with the unit's own leg numbers, and (6, 6) covariance without registration; None without pose.
    scale
        Size over the nominal one, estimated from all epochs.
    status
        ``found``, ``uncertain``, ``new``, ``relocated``, ``lost`` or ``unseen``.
    points
        Points used.
    ambiguous
        The motion since the last sighting leaves the leg numbers open.
    """

    row: int | None
    pose: Pose | None
    covariance: FloatArray | None
    scale: float
    status: str
    points: int
    ambiguous: bool = False


@dataclass(frozen=True, eq=False)
class PairMotion:
    """A unit's motion in one pair and both datums."""

    unit: int
    motions: dict[str, UnitMotion]
    classes: dict[str, str]
    adjusted: dict[str, float]


@dataclass(frozen=True, eq=False)
class EpochPair:
    """Two epochs, earlier first, with their datum and all motions."""

    first: int
    second: int
    congruence: Congruence
    turn_null: NullModel
    units: tuple[PairMotion, ...]

    @property
    def calibration(self) -> tuple[float, float, float, float]:
        """Factor and floor of positions, then of rotations."""
        null, turn = self.congruence.null, self.turn_null
        return null.factor, null.floor, turn.factor, turn.floor


@dataclass(frozen=True, eq=False)
class Tracking:
    """Result of :func:`track`.

    Attributes
    ----------
    kinds
        Type of unit by physical unit.
    units
        By physical unit: epoch index to its state.
    registrations
        By epoch: transformation to control with the uncertainty of the mean offset of its strips or stations added.
    pairs
        All pairs of epochs.
    calibrations
        By epoch: what its pairs say of the covariances of its poses.
    joint
        Joint adjustment with offsets of strips and stations.
    cross_checks
        (pair of epochs, physical unit) to direct registration of the unit's points, for consecutive epochs.
    velocities
        Physical unit to velocities by feature, for units seen in more than two epochs.
    shifts
        (e, 3) common shift between the clouds that identity removed, metres.
    """

    kinds: tuple[int, ...]
    units: tuple[dict[int, TrackedUnit], ...]
    registrations: tuple[Transformation | None, ...]
    pairs: tuple[EpochPair, ...]
    calibrations: tuple[PoseCalibration, ...]
    joint: JointAdjustment
    cross_checks: dict[tuple[int, int, int], CrossCheck]
    velocities: dict[int, tuple[Velocity, ...]]
    shifts: FloatArray


Surroundings = Callable[[int, FloatArray, float], tuple[FloatArray, NDArray[np.integer]]]
"""Points and sources of an epoch (index) within a distance of (k, 3) places, control frame less the reduction point."""


def track(epochs: Sequence[TrackedEpoch], units: Sequence[UnitType], surroundings: Surroundings | None = None) -> Tracking:
    """Follow all units through all epochs.

    Parameters
    ----------
    epochs
        In order of time.
    units
        Types of unit.
    surroundings
        Reads an epoch's cloud around places, to recover units that another epoch predicts and to tell lost from unseen; without
        it units that are not found are ``unseen``. The points of recovered units, a few in a hundred, stay in memory.
    """
    found = [
        FoundUnits(
            tuple(u.pose for u in e.units),
            np.array([u.kind for u in e.units], dtype=np.int64),
            np.array([u.certain for u in e.units], dtype=bool),
        )
        for e in epochs
    ]
    identities = identify(found, units)
    tracks = list(identities.tracks)
    seen: list[dict[int, FittedUnit]] = [{e: epochs[e].units[row].relabelled(t.symmetries[e]) for e, row in t.rows.items()} for t in tracks]
    states, recovered = _look_for_missing(epochs, tracks, seen, units, identities.shifts, surroundings)
    for unit, epoch, sighting in recovered:
        seen[unit][epoch] = sighting
    tracks, seen, states = join_relocated(tracks, seen, states, identities.shifts)
    joint, numbers = _adjust(seen)
    epochs = [_with_mean_offset(e, k, joint) for k, e in enumerate(epochs)]
    odd = _odd_sizes(joint, np.array([t.kind for t in tracks], dtype=np.int64))
    tracked = [_states_of(k, tracks[k], seen[k], states[k], joint, numbers, len(epochs), k in odd) for k in range(len(tracks))]
    pairs = tuple(_compare(a, b, epochs, units, tracks, tracked, joint, numbers) for a, b in combinations(range(len(epochs)), 2))
    calibrations = tuple(PoseCalibration.of_pairs([p.calibration for p in pairs if k in (p.first, p.second)]) for k in range(len(epochs)))
    checks = _cross_checks(seen, joint, numbers, len(epochs))
    velocities = _velocities(epochs, units, tracks, tracked, pairs, calibrations) if len(epochs) > 2 else {}
    return Tracking(
        tuple(t.kind for t in tracks),
        tuple(tracked),
        tuple(e.placement for e in epochs),
        pairs,
        calibrations,
        joint,
        checks,
        velocities,
        identities.shifts,
    )


def _look_for_missing(
    epochs: Sequence[TrackedEpoch],
    tracks: Sequence[Track],
    seen: Sequence[dict[int, FittedUnit]],
    units: Sequence[UnitType],
    shifts: FloatArray,
    surroundings: Surroundings | None,
) -> tuple[list[dict[int, str]], list[tuple[int, int, FittedUnit]]]:
    """State of every unit in the epochs that do not show it, and units recovered where another epoch predicts them."""
    states: list[dict[int, str]] = [{} for _ in tracks]
    recovered: list[tuple[int, int, FittedUnit]] = []
    wanted: dict[int, list[tuple[int, int]]] = {}
    for unit, sightings in enumerate(seen):
        certain = [e for e, s in sightings.items() if s.certain]
        for epoch in range(len(epochs)):
            if epoch not in sightings and certain:
                reference = min(certain, key=lambda e: (abs(e - epoch), e))
                wanted.setdefault(epoch, []).append((unit, reference))
                states[unit][epoch] = "hidden"
    if surroundings is None:
        return states, recovered
    reach = max(u.reach for u in units) * LOOK_UP_REACHES
    for epoch, items in sorted(wanted.items()):
        owners = [u for u in epochs[epoch].units if u.certain]
        owner_tree = cKDTree(np.array([u.pose.centre for u in owners]).reshape(-1, 3))
        # units of one home lie together: their surroundings are read together, and no more than these at a time
        homes: dict[tuple[int, ...], list[tuple[int, int]]] = {}
        for unit, reference in items:
            homes.setdefault((reference, *seen[unit][reference].cloud.home), []).append((unit, reference))
        for (reference, *_), group in sorted(homes.items()):
            move = shifts[epoch] - shifts[reference]
            centres = np.array([seen[unit][reference].pose.centre for unit, _ in group])
            points, sources = surroundings(epoch, centres + move, reach)
            other, _ = surroundings(reference, centres, reach)
            tree, other_tree = cKDTree(points), cKDTree(other)
            for unit, _ in group:
                known = seen[unit][reference]
                pose = known.pose.shifted(move)
                now = np.sort(np.array(tree.query_ball_point(pose.centre, reach), dtype=np.int64))
                before = other[other_tree.query_ball_point(known.pose.centre, reach)] + move
                tolerance = 0.025 * known.shape.height
                presence = look_up(known.cloud.read()[0] + move, pose, known.shape, before, points[now], tolerance)
                states[unit][epoch] = presence.state
                if presence.state != "there":
                    continue
                near = [owners[k] for k in owner_tree.query_ball_point(pose.centre, 2 * reach)]
                index = _left_by(near, points, now[presence.points])
                if len(index) < MIN_RECOVERED_POINTS:
                    states[unit][epoch] = "hidden"
                    continue
                recovered.append((unit, epoch, replace(known, pose=pose, cloud=UnitCloud.held(points[index], sources[index]))))
    return states, recovered


def _left_by(owners: Sequence[FittedUnit], points: FloatArray, index: IntArray) -> IntArray:
    """Those of the indices whose points belong to none of the units."""
    for owner in sorted(owners, key=lambda u: u.cloud.home):
        own, _ = owner.cloud.read()
        if len(own) and len(index):
            index = index[cKDTree(own).query(points[index])[0] > SAME_POINT]
    return index


def _adjust(seen: Sequence[dict[int, FittedUnit]]) -> tuple[JointAdjustment, dict[tuple[int, int], int]]:
    """Joint adjustment of all sightings; their numbers by unit and epoch."""
    sightings: list[UnitSighting] = []
    numbers: dict[tuple[int, int], int] = {}
    for unit, own in enumerate(seen):
        for epoch in sorted(own):
            s = own[epoch]
            numbers[unit, epoch] = len(sightings)
            sightings.append(UnitSighting(unit, epoch, s.pose, s.cloud, s.discs, s.shape))
    # one epoch from one station has neither offsets nor surfaces seen twice: nothing ties its units, and their own fits stand
    tied = any(len(own) > 1 for own in seen) or len({(s.epoch, int(k)) for s in sightings for k in s.cloud.ids}) > 1
    fitted = all(unit.covariance is not None for own in seen for unit in own.values())
    if any(s.cloud.has_points for s in sightings) and (tied or not fitted):
        return adjust_jointly(sightings), numbers
    return _as_fitted(seen, numbers), numbers


def _as_fitted(seen: Sequence[dict[int, FittedUnit]], numbers: dict[tuple[int, int], int]) -> JointAdjustment:
    """Poses and covariances of the fits of single epochs in the form of a joint adjustment."""
    poses = tuple(seen[unit][epoch].pose for unit, epoch in numbers)
    order = {unit: tuple(numbers[unit, epoch] for epoch in sorted(own)) for unit, own in enumerate(seen)}
    covariances = {}
    for unit, own in enumerate(seen):
        blocks = [c if (c := own[epoch].covariance) is not None else np.eye(6) * own[epoch].shape.height ** 2 for epoch in sorted(own)]
        covariances[unit] = np.asarray(block_diag(*blocks), dtype=np.float64)
    epochs = 1 + max((epoch for _, epoch in numbers), default=-1)
    scales = dict.fromkeys(order, 0.0)
    used = np.array([seen[unit][epoch].n_points for unit, epoch in numbers], dtype=np.int64)
    return JointAdjustment(poses, covariances, order, {}, {}, scales, scales, np.full(epochs, math.nan), 0.0, used)


def _with_mean_offset(epoch: TrackedEpoch, number: int, joint: JointAdjustment) -> TrackedEpoch:
    """The epoch with the variance of the mean offset of its strips."""
    return replace(epoch, offset_variance=mean_offset_variance([offset for (e, _), offset in joint.offsets.items() if e == number]))


def _odd_sizes(joint: JointAdjustment, kinds: IntArray) -> frozenset[int]:
    """Units whose size differs from that of their kind by more than castings from one set of moulds do.

    The points of a leg that are taken for more, or for another one, make the unit shrink or grow.
    """
    scales, sds = (np.array([values[k] for k in range(len(kinds))]) for values in (joint.scales, joint.scale_sds))
    # an estimate is drawn towards the nominal size by what the points leave open, and varies the less
    told = np.maximum(1 - (sds / HEIGHT_SPREAD) ** 2, 0.04)
    odd: list[int] = []
    for kind in np.unique(kinds):
        own = np.flatnonzero(kinds == kind)
        away = np.abs(scales[own] - told[own] * np.median(scales[own])) / (HEIGHT_SPREAD * np.sqrt(told[own]))
        odd += own[away > ODD_SIZE * max(1.4826 * float(np.median(away)), 1.0)].tolist()
    return frozenset(odd)


def _states_of(
    unit: int,
    track: Track,
    seen: dict[int, FittedUnit],
    states: dict[int, str],
    joint: JointAdjustment,
    numbers: dict[tuple[int, int], int],
    epochs: int,
    odd: bool,
) -> dict[int, TrackedUnit]:
    tracked = {}
    first = min(seen)
    confirmed = not odd and any(s.certain for s in seen.values())
    for epoch in range(epochs):
        if epoch in seen:
            number = numbers[unit, epoch]
            place = joint.order[unit].index(number)
            block = slice(6 * place, 6 * place + 6)
            vouched = epoch in track.rows or seen[epoch].score >= RECOVERED_SCORE
            status = "found" if confirmed and vouched else "uncertain"
            if epoch in track.relocated:
                status = "relocated"
            elif confirmed and epoch == first > 0 and states.get(epoch - 1) == "empty":
                status = "new"
            tracked[epoch] = TrackedUnit(
                track.rows.get(epoch), joint.poses[number], joint.covariances[unit][block, block], 1 + joint.scales[unit], status,
                int(joint.used[number]), epoch in track.ambiguous,
            )  # fmt: skip
        elif epoch > first and epoch in states:
            status = "lost" if states[epoch] == "empty" else "unseen"
            tracked[epoch] = TrackedUnit(None, None, None, 1 + joint.scales[unit], status, 0)
    return tracked


def _compare(
    first: int,
    second: int,
    epochs: Sequence[TrackedEpoch],
    units: Sequence[UnitType],
    tracks: Sequence[Track],
    tracked: Sequence[dict[int, TrackedUnit]],
    joint: JointAdjustment,
    numbers: dict[tuple[int, int], int],
) -> EpochPair:
    members, befores, afters, joints, turns, turn_covs = [], [], [], [], [], []
    for k, states in enumerate(tracked):
        a, b = states.get(first), states.get(second)
        if a is None or b is None or a.pose is None or b.pose is None:
            continue
        both = _joint_block(joint, k, numbers[k, first], numbers[k, second])
        shape = unit_shape(units[tracks[k].kind], a.scale)
        members.append(k)
        befores.append(feature_points(a.pose, shape))
        afters.append(feature_points(b.pose, shape))
        joints.append(both)
        turns.append(turn_vector(a.pose, b.pose))
        turn_covs.append(turn_covariance(a.pose, b.pose, both))
    certain = np.array([all(tracked[k][e].status != "uncertain" for e in (first, second)) for k in members], dtype=bool)
    carried = np.array([any(first < e <= second for e in tracks[k].relocated) for k in members], dtype=bool)
    judged = np.flatnonzero(certain & ~carried)
    height = max(unit.height for unit in units)
    centres = np.array([f.positions[0] for f in befores]).reshape(-1, 3)
    vectors = np.array([b.positions[0] - a.positions[0] for a, b in zip(befores, afters, strict=True)]).reshape(-1, 3)
    own = np.array([relative_covariance(a, b, c)[0] for a, b, c in zip(befores, afters, joints, strict=True)]).reshape(-1, 3, 3)
    origin = centres[judged].mean(axis=0) if len(judged) else np.zeros(3)
    prior = _common_prior(epochs, first, second, origin)
    degrees = epochs[first].redundancy + epochs[second].redundancy
    congruence = congruence_of(vectors[judged], own[judged], centres[judged], prior, origin, height, degrees or math.inf)
    turn = np.array(turns).reshape(-1, 3)
    turn_cov = np.array(turn_covs).reshape(-1, 3, 3)
    turn_null = calibrate(turn[judged] - congruence.motion[3:6], turn_cov[judged], 1.0)
    placement = epochs[second].placement
    frame = None if placement is None else placement.covariance
    supports = dict(zip(judged.tolist(), congruence.stable.tolist(), strict=True))
    motions = [
        {
            datum: unit_motion(
                befores[i], afters[i], turn[i], joints[i], turn_cov[i], congruence, turn_null, datum, supports.get(i, False), frame
            )
            for datum in DATUMS
        }
        for i in range(len(members))
    ]
    results = []
    adjusted = {datum: np.ones(len(members)) for datum in DATUMS}
    turn_adjusted = {datum: np.ones(len(members)) for datum in DATUMS}
    for datum in DATUMS:
        adjusted[datum][judged] = adjusted_p_values([motions[i][datum].p_values[0] for i in judged])
        turn_adjusted[datum][judged] = adjusted_p_values([motions[i][datum].turn_p_value for i in judged])
    for i, k in enumerate(members):
        classes = {
            datum: classify(float(adjusted[datum][i]), float(turn_adjusted[datum][i]), bool(certain[i]), bool(carried[i]))
            for datum in DATUMS
        }
        results.append(PairMotion(k, motions[i], classes, {datum: float(adjusted[datum][i]) for datum in DATUMS}))
    return EpochPair(first, second, congruence, turn_null, tuple(results))


def _cross_checks(
    seen: Sequence[dict[int, FittedUnit]], joint: JointAdjustment, numbers: dict[tuple[int, int], int], epochs: int
) -> dict[tuple[int, int, int], CrossCheck]:
    """Displacements of all units between consecutive epochs by direct registration of their points."""
    checks = {}
    for first, second in zip(range(epochs - 1), range(1, epochs), strict=True):
        both = [k for k, own in enumerate(seen) if first in own and second in own and (own[first].certain or own[second].certain)]
        for unit in by_home((k, (seen[k][first].cloud, seen[k][second].cloud)) for k in both):
            own = seen[unit]
            if not (own[first].cloud.has_points and own[second].cloud.has_points):
                continue
            noise = float(np.nanmax(joint.noise[[first, second]]))
            a, b = numbers[unit, first], numbers[unit, second]
            block = _joint_block(joint, unit, a, b)
            difference = np.hstack([-np.eye(3), np.zeros((3, 3)), np.eye(3), np.zeros((3, 3))])
            checks[first, second, unit] = cross_check(
                _without_offsets(own[first], first, joint), _without_offsets(own[second], second, joint), joint.poses[a], joint.poses[b],
                difference @ block @ difference.T, noise,
            )  # fmt: skip
    return checks


def _without_offsets(unit: FittedUnit, epoch: int, joint: JointAdjustment) -> FloatArray:
    """(n, 3) points less the offset of their strip or station."""
    points, sources = unit.cloud.read()
    offsets = np.array([joint.offsets[epoch, int(i)] for i in unit.cloud.ids])
    return np.asarray(points - offsets[np.searchsorted(unit.cloud.ids, sources)])


def _joint_block(joint: JointAdjustment, unit: int, first: int, second: int) -> FloatArray:
    """(12, 12) covariance of the poses of two sightings of a unit."""
    order = joint.order[unit]
    index = np.concatenate([6 * order.index(n) + np.arange(6) for n in (first, second)])
    return np.asarray(joint.covariances[unit][np.ix_(index, index)])


def unit_shape(unit: UnitType, scale: float) -> UnitType:
    """Geometry of a unit whose size differs from the nominal one."""
    return replace(unit, radius=unit.radius * scale, leg_length=unit.leg_length * scale)


def _common_prior(epochs: Sequence[TrackedEpoch], first: int, second: int, origin: FloatArray) -> FloatArray | None:
    """(7, 7) covariance of the motion common to all units between two registered epochs, about ``origin``.

    Epochs tied to the same one share the error of its registration, which drops out of their difference.
    """
    total = np.zeros((7, 7))
    roots = []
    for number in (first, second):
        placement = epochs[number].placement
        if placement is None:
            return None
        total += placement.covariance_at(origin)
        tied_to = epochs[number].tied_to
        roots.append(number if tied_to is None else tied_to)
    shared = epochs[roots[0]].registration
    if roots[0] == roots[1] and shared is not None:
        total -= 2 * shared.covariance_at(origin)
    return total


def _velocities(
    epochs: Sequence[TrackedEpoch],
    units: Sequence[UnitType],
    tracks: Sequence[Track],
    tracked: Sequence[dict[int, TrackedUnit]],
    pairs: Sequence[EpochPair],
    calibrations: Sequence[PoseCalibration],
) -> dict[int, tuple[Velocity, ...]]:
    """Velocities of units seen in more than two epochs, each epoch brought into the first one's datum ``stable``."""
    years = np.array([e.time.timestamp() for e in epochs]) / SECONDS_PER_YEAR
    to_first = {pair.second: pair for pair in pairs if pair.first == 0}
    result = {}
    for k, states in enumerate(tracked):
        have = [e for e, s in sorted(states.items()) if s.pose is not None and s.status != "uncertain"]
        have = [e for e in have if e == 0 or e in to_first]
        if len(have) < 3 or tracks[k].relocated:
            continue
        points = [_placed(states[e], units[tracks[k].kind], calibrations[e], to_first.get(e)) for e in have]
        result[k] = tuple(
            velocity(
                f, years[have], np.array([p.positions[f] for p in points]), np.array([p.covariances[f] for p in points]),
                min((to_first[e].congruence.null.tail for e in have if e), default=math.inf),
            )
            for f in range(len(FEATURES))
        )  # fmt: skip
    return result


def _placed(state: TrackedUnit, unit: UnitType, calibration: PoseCalibration, to_first: EpochPair | None) -> FeaturePoints:
    """Feature points in the first epoch's datum.

    Their covariance is the epoch's own one, calibrated, and, in later epochs, that of the motion from the first one to them.
    """
    if state.pose is None or state.covariance is None:
        raise ValueError("a unit without pose has no feature points")
    covariance = np.zeros((8, 8))
    covariance[:6, :6] = calibration.covariance(state.covariance)
    points = feature_points(state.pose, unit_shape(unit, state.scale), covariance)
    if to_first is None:
        return points
    congruence = to_first.congruence
    covariances = points.covariances + congruence.common_covariance(points.positions, "stable")
    return replace(points, positions=points.positions - congruence.common_part(points.positions), covariances=covariances)
