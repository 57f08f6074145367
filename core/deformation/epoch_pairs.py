"""Two epochs compared: every unit's motion in both datums, with rigid frames or bent ones.

What is common to the units around one, the error of the frames, is predicted by all others (leave one out) and taken from its motion.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..model.feature_points import feature_points
from ..model.unit_types import UnitType
from ..registration.frame_field import LocalMotions
from .common_motion import common_prior
from .congruence import Congruence, congruence_of
from .control_scale import with_rigid_scale
from .displacement import (
    FramePart,
    UnitMotion,
    UnitPair,
    adjusted_p_values,
    classify,
    moved_share,
    turn_covariance,
    turn_vector,
    unit_motion,
)
from .elastic_congruence import ElasticDatum, FrameTie, elastic_congruence_of
from .epoch_frames import EpochFrames, PairShifts
from .identity import Track
from .joint_records import JointAdjustment
from .null_model import NullModel, calibrate
from .stretches import JudgedUnits, StretchMotion, motions_of_stretches
from .tracked_epoch import TrackedEpoch, TrackedUnit

DATUMS = ("stable", "control")


@dataclass(frozen=True, eq=False)
class PairMotion:
    """A unit's motion in one pair and both datums, with what the frames brought into it."""

    unit: int
    motions: dict[str, UnitMotion]
    classes: dict[str, str]
    adjusted: dict[str, float]
    frames: dict[str, FramePart]


@dataclass(frozen=True, eq=False, kw_only=True)
class EpochPair:
    """Two epochs, earlier first, with their datum and all motions.

    ``judged`` numbers those of ``units`` that are certain and stayed in place, on which the congruence rests; ``tie`` holds
    what they say of frames that bend, of epochs that follow each other; ``stretches`` the common motion of stretches by datum.
    """

    first: int
    second: int
    congruence: Congruence
    turn_null: NullModel
    units: tuple[PairMotion, ...]
    judged: IntArray
    stretches: Mapping[str, Sequence[StretchMotion]]
    tie: FrameTie | None = None

    @property
    def calibration(self) -> tuple[float, float, float, float]:
        """Factor and floor of positions, then of rotations."""
        null, turn = self.congruence.null, self.turn_null
        return null.factor, null.floor, turn.factor, turn.floor


@dataclass(frozen=True, eq=False, kw_only=True)
class _Members:
    """Units with a pose in both epochs: numbers, pairs, whether each is certain and whether it was carried elsewhere."""

    numbers: tuple[int, ...]
    pairs: tuple[UnitPair, ...]
    certain: BoolArray
    carried: BoolArray

    @property
    def judged(self) -> IntArray:
        return np.flatnonzero(self.certain & ~self.carried)

    @property
    def centres(self) -> FloatArray:
        return np.array([p.before.positions[0] for p in self.pairs]).reshape(-1, 3)

    @property
    def vectors(self) -> FloatArray:
        return np.array([p.after.positions[0] - p.before.positions[0] for p in self.pairs]).reshape(-1, 3)

    @property
    def covariances(self) -> FloatArray:
        return np.array([p.covariances_of(p.joint)[0] for p in self.pairs]).reshape(-1, 3, 3)


@dataclass(frozen=True, eq=False, kw_only=True)
class TrackedUnits:
    """Everything that is known of all units: types, identity, state by epoch, joint adjustment and the numbers of its sightings."""

    types: Sequence[UnitType]
    tracks: Sequence[Track]
    states: Sequence[Mapping[int, TrackedUnit]]
    joint: JointAdjustment
    numbers: Mapping[tuple[int, int], int]


def shifts_between(units: TrackedUnits, first: int, second: int) -> PairShifts:
    """Displacements of the units on which a pair's datum may rest."""
    members = _members(units, first, second)
    own = members.judged
    return PairShifts(places=members.centres[own], vectors=members.vectors[own], covariances=members.covariances[own])


def compare_epochs(units: TrackedUnits, epochs: Sequence[TrackedEpoch], first: int, second: int, frames: EpochFrames | None) -> EpochPair:
    """Motion of every unit between two epochs; ``frames`` where these bend."""
    members = _members(units, first, second)
    judged = members.judged
    height = max(unit.height for unit in units.types)
    degrees = (epochs[first].redundancy + epochs[second].redundancy) or math.inf
    if frames is None:
        congruence, parts = _rigid(members, epochs, first, second, height, degrees)
        elastic = None
    else:
        congruence, elastic, parts = _elastic(members, frames, first, second, height, min(degrees, frames.degrees))
    turns = np.array([p.turn for p in members.pairs]).reshape(-1, 3)
    turn_covariances = np.array([p.turn_covariance for p in members.pairs]).reshape(-1, 3, 3)
    turn_null = calibrate(turns[judged] - parts["stable"].means[judged, 3:], turn_covariances[judged], 1.0)
    placement = epochs[second].placement
    carried = None if placement is None else placement.covariance
    # what neighbours say is the word of many
    known = {"stable": math.inf, "control": congruence.control_degrees}
    factors = {"stable": 1.0, "control": congruence.control_factor}
    scales = {"stable": _scale_degrees(members, congruence), "control": np.full(len(members.numbers), math.inf)}
    own_frames = [
        {
            datum: FramePart(
                motion=parts[datum].means[i],
                covariance=parts[datum].covariances[i],
                degrees=known[datum],
                carried=carried,
                factor=factors[datum],
                scale_degrees=float(scales[datum][i]),
            )
            for datum in DATUMS
        }
        for i in range(len(members.numbers))
    ]
    shares = [moved_share(pair, congruence.null, own["stable"]) for pair, own in zip(members.pairs, own_frames, strict=True)]
    motions = [
        {datum: unit_motion(pair, congruence.null, turn_null, own[datum], share) for datum in DATUMS}
        for pair, own, share in zip(members.pairs, own_frames, shares, strict=True)
    ]
    return EpochPair(
        first=first, second=second, congruence=congruence, turn_null=turn_null,
        units=_classified(members, motions, own_frames), judged=judged,
        tie=elastic.tie if elastic is not None and second == first + 1 else None,
        stretches=motions_of_stretches(_judged_units(members, congruence), congruence, elastic, height),
    )  # fmt: skip


def _members(units: TrackedUnits, first: int, second: int) -> _Members:
    numbers, pairs, certain, carried = [], [], [], []
    for k, states in enumerate(units.states):
        a, b = states.get(first), states.get(second)
        if a is None or b is None or a.pose is None or b.pose is None:
            continue
        sightings = units.numbers[k, first], units.numbers[k, second]
        both, noise = joint_block(units.joint, k, *sightings), joint_block(units.joint, k, *sightings, of_noise=True)
        shape = unit_shape(units.types[units.tracks[k].kind], a.scale)
        numbers.append(k)
        pairs.append(
            UnitPair(
                before=feature_points(a.pose, shape), after=feature_points(b.pose, shape), joint=both, noise=noise,
                turn=turn_vector(a.pose, b.pose), turn_covariance=turn_covariance(a.pose, b.pose, both),
                turn_noise=turn_covariance(a.pose, b.pose, noise), height=shape.height,
            )
        )  # fmt: skip
        certain.append("uncertain" not in (a.status, b.status) and not (a.held or b.held))
        carried.append(any(first < e <= second for e in units.tracks[k].relocated))
    return _Members(
        numbers=tuple(numbers), pairs=tuple(pairs), certain=np.array(certain, dtype=bool), carried=np.array(carried, dtype=bool)
    )


def _judged_units(members: _Members, congruence: Congruence) -> JudgedUnits:
    own = members.judged
    return JudgedUnits(
        places=members.centres[own], vectors=members.vectors[own], covariances=congruence.null.covariance(members.covariances[own])
    )


def _scale_degrees(members: _Members, congruence: Congruence) -> FloatArray:
    """Degrees of freedom with which the others know the scale of each unit's deviations; of one that is not judged, the fewest of all."""
    known = np.full(len(members.numbers), congruence.scale_degrees.min(initial=math.inf))
    known[members.judged] = congruence.scale_degrees
    return known


def _rigid(
    members: _Members, epochs: Sequence[TrackedEpoch], first: int, second: int, height: float, degrees: float
) -> tuple[Congruence, dict[str, LocalMotions]]:
    judged, centres, vectors, own = members.judged, members.centres, members.vectors, members.covariances
    origin = centres[judged].mean(axis=0) if len(judged) else np.zeros(3)
    prior = common_prior(epochs, first, second, origin)
    congruence = congruence_of(vectors[judged], own[judged], centres[judged], prior, origin, height, degrees)
    congruence = with_rigid_scale(congruence, vectors[judged], own[judged], centres[judged])
    used = np.zeros(len(centres), dtype=bool)
    used[judged] = congruence.stable
    stable = congruence.by_others(centres, vectors, congruence.null.covariance(own), used)
    return congruence, {"stable": stable, "control": congruence.rigid_motions(centres, "control")}


def _elastic(
    members: _Members, frames: EpochFrames, first: int, second: int, height: float, degrees: float
) -> tuple[Congruence, ElasticDatum, dict[str, LocalMotions]]:
    judged, centres, vectors, own = members.judged, members.centres, members.vectors, members.covariances
    congruence, datum = elastic_congruence_of(
        vectors[judged], own[judged], centres[judged], *frames.between(first, second), height, degrees,
        suspects=frames.jumped(first, second, centres[judged]), controlled=frames.controlled(first, second),
    )  # fmt: skip
    used = np.zeros(len(centres))
    used[judged] = datum.used
    stable = datum.stable.at(centres).without(vectors, congruence.null.covariance(own), used)
    return congruence, datum, {"stable": stable, "control": datum.control.at(centres)}


def _classified(
    members: _Members, motions: Sequence[dict[str, UnitMotion]], frames: Sequence[dict[str, FramePart]]
) -> tuple[PairMotion, ...]:
    judged = members.judged
    adjusted, turn_adjusted = ({datum: np.ones(len(motions)) for datum in DATUMS} for _ in range(2))
    for datum in DATUMS:
        adjusted[datum][judged] = adjusted_p_values([motions[i][datum].p_values[0] for i in judged])
        turn_adjusted[datum][judged] = adjusted_p_values([motions[i][datum].turn_p_value for i in judged])
    return tuple(
        PairMotion(
            k,
            motions[i],
            {
                datum: classify(
                    float(adjusted[datum][i]), float(turn_adjusted[datum][i]), bool(members.certain[i]), bool(members.carried[i])
                )
                for datum in DATUMS
            },
            {datum: float(adjusted[datum][i]) for datum in DATUMS},
            frames[i],
        )
        for i, k in enumerate(members.numbers)
    )


def joint_block(joint: JointAdjustment, unit: int, *sightings: int, of_noise: bool = False) -> FloatArray:
    """(6 k, 6 k) covariance of the poses of k sightings of a unit, or what noise alone would leave of it."""
    order, covariances = joint.order[unit], joint.noise_covariances if of_noise else joint.covariances
    index = np.concatenate([6 * order.index(n) + np.arange(6) for n in sightings])
    return np.asarray(covariances[unit][np.ix_(index, index)])


def unit_shape(unit: UnitType, scale: float) -> UnitType:
    """Geometry of a unit whose size differs from the nominal one."""
    return replace(unit, radius=unit.radius * scale, leg_length=unit.leg_length * scale)
