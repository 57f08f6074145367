"""Units through all epochs: identity, joint adjustment, datum, displacements. Arrays in, frozen results out; no files.

Everything here is in the control frame less one reduction point.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from scipy.linalg import block_diag

from ..common.arrays import FloatArray
from ..model.mould import Mould
from ..model.unit_types import UnitType
from ..registration.frame_field import LocalMotions
from ..registration.transformation import Transformation
from .chained_frames import chained_errors
from .checked_units import checks_of, cross_check_questions
from .congruence import PoseCalibration
from .cross_check import CrossCheck
from .elastic_congruence import FrameTie
from .epoch_frames import EpochFrames, FrameChoice, estimate_frames
from .epoch_pairs import EpochPair, TrackedUnits, compare_epochs, shifts_between
from .evidence_of_epochs import SAME_PLACE_HEIGHTS
from .fitted_unit import FittedUnit
from .identity import FoundUnits, Track, identify
from .joint_records import JointAdjustment, UnitSighting
from .legs_over_epochs import legs_over_epochs
from .missing_units import Surroundings, look_for_missing, look_for_rest
from .open_displacements import hold_open_displacements
from .questions import Ask, answered_here
from .relocation import join_relocated
from .shared_twists import settle_together
from .strip_offsets import adjust_jointly
from .tracked_epoch import TrackedEpoch, TrackedUnit
from .unit_states import SURE_SCORE, doubted_where_open, odd_sizes, states_of
from .velocities import Velocity, velocities_of_units


@dataclass(frozen=True, eq=False, kw_only=True)
class Tracking:
    """Result of :func:`track`.

    Attributes
    ----------
    kinds
        Type of unit by physical unit.
    units
        By physical unit: epoch index to its state.
    registrations
        By epoch: transformation to control with the uncertainty of the mean offset and drift of its strips or stations added.
    offset_variances
        By epoch: that of this mean offset per axis, square metres.
    drift_variances
        By epoch: (3,) those of the mean drift by axis, square metres.
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
    frames
        How the epochs' frames bend, with their errors as the targets of all epochs see them, tied by resting units; None where they
        are rigid.
    """

    kinds: tuple[int, ...]
    units: tuple[dict[int, TrackedUnit], ...]
    registrations: tuple[Transformation | None, ...]
    offset_variances: tuple[float, ...]
    drift_variances: tuple[FloatArray, ...]
    pairs: tuple[EpochPair, ...]
    calibrations: tuple[PoseCalibration, ...]
    joint: JointAdjustment
    cross_checks: dict[tuple[int, int, int], CrossCheck]
    velocities: dict[int, tuple[Velocity, ...]]
    shifts: FloatArray
    frames: EpochFrames | None = None

    def frame_error(self, epoch: int, points: FloatArray) -> LocalMotions | None:
        """Error of an epoch's registered cloud at (k, 3) points as targets see it; None where its frame is rigid or without targets."""
        error = None if self.frames is None else self.frames.errors[epoch]
        return None if error is None else error.at(points)


def track(
    epochs: Sequence[TrackedEpoch],
    units: Sequence[UnitType],
    surroundings: Surroundings | None = None,
    frame: FrameChoice = "auto",
    moulds: Sequence[Mould | None] = (),
    ask: Ask = answered_here,
) -> Tracking:
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
    frame
        Whether frames may bend.
    moulds
        By type of unit, the mould that an earlier survey has learned, or None; empty for none of any.
    ask
        Answers what is asked of the points of a few units, here or in other processes.
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
    tracks, seen = settle_together(tracks, seen, units, identities.shifts, surroundings, ask)
    states, recovered, verdicts = look_for_missing(epochs, seen, units, identities.shifts, surroundings, ask)
    for unit, is_certain in verdicts.items():
        seen[unit] = {epoch: replace(sighting, certain=is_certain) for epoch, sighting in seen[unit].items()}
    for unit, epoch, sighting in recovered:
        seen[unit][epoch] = sighting
    for unit, epoch, sighting in look_for_rest(seen, len(epochs), units, identities.shifts, surroundings, ask):
        # the pose that was found elsewhere is given up
        seen[unit][epoch], states[unit][epoch] = sighting, "there"
        tracks[unit] = replace(tracks[unit], rows={e: row for e, row in tracks[unit].rows.items() if e != epoch})
    tracks, seen, states = _without_rivals(tracks, seen, states, recovered)
    tracks, seen, states = join_relocated(tracks, seen, states, identities.shifts)
    seen = [_with_legs(own) for own in seen]
    joint, numbers = _adjust(seen, {unit: mould for unit, mould in zip(units, moulds) if mould is not None})
    epochs = [_with_mean_offset(e, k, joint) for k, e in enumerate(epochs)]
    sure = np.array([all(s.score >= SURE_SCORE for s in own.values()) for own in seen], dtype=np.bool_)
    odd = odd_sizes(joint, np.array([t.kind for t in tracks], dtype=np.int64), units, sure)
    tracked = [states_of(k, tracks[k], seen[k], states[k], joint, numbers, len(epochs), k in odd) for k in range(len(tracks))]
    known = TrackedUnits(types=units, tracks=tracks, states=tracked, joint=joint, numbers=numbers)
    frames = _frames(known, epochs, frame)
    known, pairs, checks = _settled_and_checked(known, epochs, frames, seen, ask)
    calibrations = _calibrations(pairs, len(epochs))
    velocities = velocities_of_units(known, [e.time for e in epochs], pairs)
    if frames is not None:
        frames = replace(frames, errors=chained_errors(frames, _ties_of_neighbours(pairs)))
    return Tracking(
        kinds=tuple(t.kind for t in tracks),
        units=tuple(dict(own) for own in known.states),
        registrations=tuple(e.placement for e in epochs),
        offset_variances=tuple(e.offset_variance for e in epochs),
        drift_variances=tuple(e.drift_variances for e in epochs),
        pairs=pairs,
        calibrations=calibrations,
        joint=joint,
        cross_checks=checks,
        velocities=velocities,
        shifts=identities.shifts,
        frames=frames,
    )


def _settled_and_checked(
    units: TrackedUnits, epochs: Sequence[TrackedEpoch], frames: EpochFrames | None, seen: Sequence[dict[int, FittedUnit]], ask: Ask
) -> tuple[TrackedUnits, tuple[EpochPair, ...], dict[tuple[int, int, int], CrossCheck]]:
    """What :func:`_settled` returns, found while other processes answer the cross checks of the units that keep their poses."""
    settled: list[tuple[TrackedUnits, tuple[EpochPair, ...]]] = []
    # points say the same of units whose poses are doubted meanwhile: what they say is left out afterwards
    checks = _cross_checks(seen, units.joint, units.numbers, len(epochs), ask, lambda: settled.append(_settled(units, epochs, frames)))
    known, pairs = settled[0]
    return known, pairs, _of_posed(checks, [with_poses(own, known.states[k]) for k, own in enumerate(seen)])


def _settled(units: TrackedUnits, epochs: Sequence[TrackedEpoch], frames: EpochFrames | None) -> tuple[TrackedUnits, tuple[EpochPair, ...]]:
    """Units and pairs of epochs once poses that are left open are doubted, and displacements that are, are held at rest."""
    pairs = _compared(units, epochs, frames)
    doubted = doubted_where_open(units.states, [units.types[t.kind] for t in units.tracks], _calibrations(pairs, len(epochs)))
    if doubted is not None:
        units = replace(units, states=doubted)
        pairs = _compared(units, epochs, frames)
    held = hold_open_displacements(units, pairs)
    if held is not None:
        units = replace(units, states=held)
        pairs = _compared(units, epochs, frames)
    return units, pairs


def _compared(units: TrackedUnits, epochs: Sequence[TrackedEpoch], frames: EpochFrames | None) -> tuple[EpochPair, ...]:
    """All pairs of epochs."""
    return tuple(compare_epochs(units, epochs, a, b, frames) for a, b in combinations(range(len(epochs)), 2))


def _calibrations(pairs: Sequence[EpochPair], epochs: int) -> tuple[PoseCalibration, ...]:
    """What units at rest say of the covariances of each epoch, in all pairs that it belongs to."""
    return tuple(PoseCalibration.of_pairs([p.calibration for p in pairs if k in (p.first, p.second)]) for k in range(epochs))


def _with_legs(seen: Mapping[int, FittedUnit]) -> dict[int, FittedUnit]:
    """A unit's sightings by epoch, each with what all of them say of its legs."""
    legs = legs_over_epochs({epoch: sighting.legs for epoch, sighting in seen.items()})
    return {epoch: replace(sighting, legs=legs[epoch]) for epoch, sighting in seen.items()}


def with_poses(seen: Mapping[int, FittedUnit], states: Mapping[int, TrackedUnit]) -> dict[int, FittedUnit]:
    """A unit's sightings by epoch, without those whose points leave the pose open: they are no sightings then."""
    return {epoch: own for epoch, own in seen.items() if epoch in states and states[epoch].pose is not None}


def _ties_of_neighbours(pairs: Sequence[EpochPair]) -> list[FrameTie | None]:
    """Of pairs of epochs that follow each other."""
    return [pair.tie for pair in sorted(pairs, key=lambda pair: pair.first) if pair.second == pair.first + 1]


def _frames(units: TrackedUnits, epochs: Sequence[TrackedEpoch], choice: FrameChoice) -> EpochFrames | None:
    """Frames of all epochs, from the pairs that follow each other and from targets."""
    places = [s.pose.centre for states in units.states for s in states.values() if s.pose is not None]
    height = max(unit.height for unit in units.types)
    pairs = [shifts_between(units, k, k + 1) for k in range(len(epochs) - 1)]
    return estimate_frames(pairs, [e.placed_targets for e in epochs], np.array(places).reshape(-1, 3), height, choice)


def _without_rivals(
    tracks: Sequence[Track],
    seen: Sequence[dict[int, FittedUnit]],
    states: Sequence[dict[int, str]],
    recovered: Sequence[tuple[int, int, FittedUnit]],
) -> tuple[list[Track], list[dict[int, FittedUnit]], list[dict[int, str]]]:
    """Tracks, sightings and states without weak detections in a place where a unit known from another epoch was recovered.

    They explain its points by another pose, and two solids cannot share a place.
    """
    rivals: set[int] = set()
    for _, epoch, unit in recovered:
        for k, own in enumerate(seen):
            other = own.get(epoch)
            if other is not None and other is not unit and not any(s.certain for s in own.values()):
                near = np.linalg.norm(other.pose.centre - unit.pose.centre) < SAME_PLACE_HEIGHTS * unit.shape.height
                rivals |= {k} if near else set()
    kept = [k for k in range(len(tracks)) if k not in rivals]
    return [tracks[k] for k in kept], [seen[k] for k in kept], [states[k] for k in kept]


def _adjust(seen: Sequence[dict[int, FittedUnit]], moulds: Mapping[UnitType, Mould]) -> tuple[JointAdjustment, dict[tuple[int, int], int]]:
    """Joint adjustment of all sightings; their numbers by unit and epoch."""
    sightings: list[UnitSighting] = []
    numbers: dict[tuple[int, int], int] = {}
    for unit, own in enumerate(seen):
        for epoch in sorted(own):
            s = own[epoch]
            numbers[unit, epoch] = len(sightings)
            sightings.append(UnitSighting(unit=unit, epoch=epoch, pose=s.pose, cloud=s.cloud, discs=s.discs, shape=s.shape))
    # one epoch from one station has neither offsets nor surfaces seen twice: nothing ties its units, and their own fits stand, also
    # where one of them had too few points for a fit
    tied = any(len(own) > 1 for own in seen) or len({(s.epoch, int(k)) for s in sightings for k in s.cloud.ids}) > 1
    fitted = any(unit.covariance is not None for own in seen for unit in own.values())
    if any(s.cloud.has_points for s in sightings) and (tied or not fitted):
        return adjust_jointly(sightings, moulds=moulds), numbers
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
    return JointAdjustment(
        poses=poses,
        covariances=covariances,
        noise_covariances=covariances,
        order=order,
        offsets={},
        offset_sds={},
        scales=scales,
        scale_sds=scales,
        noise=np.full(epochs, math.nan),
        surface_sd=0.0,
        used=used,
    )


def _with_mean_offset(epoch: TrackedEpoch, number: int, joint: JointAdjustment) -> TrackedEpoch:
    """The epoch with what its strips leave open of its place, as the joint adjustment of its units shows it."""
    offsets = {source: offset for (own, source), offset in joint.offsets.items() if own == number}
    if offsets:
        epoch = epoch.with_mean_offset(offsets, float(joint.noise[number]))
    return epoch if joint.drifts is None else replace(epoch, drift_variances=joint.drifts.variances_of_mean(number))


def _cross_checks(
    seen: Sequence[dict[int, FittedUnit]],
    joint: JointAdjustment,
    numbers: Mapping[tuple[int, int], int],
    epochs: int,
    ask: Ask,
    beside: Callable[[], None],
) -> dict[tuple[int, int, int], CrossCheck]:
    """Displacements of all units between consecutive epochs by direct registration of their points.

    ``beside`` is done meanwhile, or before where no other process answers.
    """
    pairs = list(zip(range(epochs - 1), range(1, epochs), strict=True))
    asked = [(pair, *item) for pair in pairs for item in cross_check_questions(seen, joint, numbers, *pair)]
    answers = ask([question for _, _, question in asked], beside)
    checks: dict[tuple[int, int, int], CrossCheck] = {}
    for (pair, units, _), answer in zip(asked, answers, strict=True):
        checks |= {(*pair, unit): check for unit, check in zip(units, checks_of(answer), strict=True)}
    return checks


def _of_posed(
    checks: Mapping[tuple[int, int, int], CrossCheck], posed: Sequence[Mapping[int, FittedUnit]]
) -> dict[tuple[int, int, int], CrossCheck]:
    """Those of units that have a pose in both epochs; ``posed`` holds these by unit and epoch."""
    return {key: check for key, check in checks.items() if posed[key[2]].keys() >= set(key[:2])}
