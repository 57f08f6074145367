"""Epochs whose clouds are not aligned: brought onto each other by their units where nothing else ties them, or refused in words."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..common.feedback import Feedback
from ..data.survey import Survey
from ..deformation.common_shifts import whole_shift
from ..deformation.constellation import ALIGNED_SHARE, Alignment, align, aligned_share, settled
from ..deformation.identity import FoundUnits
from ..model.unit_types import UnitType
from ..registration.control import Registration
from ..registration.transformation import Transformation
from .epoch_units import EpochUnits

COMPARABLE_UNITS = 12
"""Units of both epochs from which it is said that they have nothing in common."""
CLEAR_SHARE = 0.6
"""Share of the units that a motion must bring together so that no other one is looked for."""
LINEAR_HEIGHTS = 0.0005
"""Error in unit heights up to which a turn is left to the adjustment of the common motion."""
GEOID_LEAST, GEOID_TILT = 2.0, 0.3
"""Metres of height difference that a geoid separation has at least, and degrees it may tilt."""


@dataclass(frozen=True, eq=False, kw_only=True)
class PlacedUnits:
    """Units of an epoch where its registration, or its cloud, has them.

    Attributes
    ----------
    label
        Of the epoch.
    found
        Its units, less the common reduction point.
    registered
        Whether control or stable areas place them.
    """

    label: str
    found: FoundUnits
    registered: bool


@dataclass(frozen=True, eq=False, kw_only=True)
class UnitTie:
    """How an epoch that nothing else ties lies in the frame of the reference epoch, as their units say.

    Attributes
    ----------
    transformation
        Of its cloud, its error and that of the reference epoch in the covariance.
    note
        What is to be said of it.
    """

    transformation: Transformation
    note: str


def align_epochs(
    survey: Survey, fitted: Sequence[EpochUnits], registrations: Mapping[str, Registration], feedback: Feedback
) -> dict[str, Registration]:
    """Registrations with those of epochs added that only their units tie to the reference epoch.

    Raises
    ------
    InputError
        Control or the survey's frame contradicts the units, or two epochs have no units in common.
    """
    known = dict(registrations)
    root = next(e for e in fitted if e.plan.epoch is survey.reference)
    origin = _origin(fitted)
    placed = [
        PlacedUnits(
            label=epoch.plan.epoch.label,
            found=_found(epoch, known.get(epoch.plan.epoch.label), origin),
            registered=epoch.plan.epoch.label in known,
        )
        for epoch in fitted
    ]
    label = root.plan.epoch.label
    reference = next(p for p in placed if p.label == label)
    own = known.get(label)
    ties = tie_by_units(reference, placed, root.units, origin, None if own is None else own.transformation, survey.path, feedback)
    for name, tie in ties.items():
        transformation = tie.transformation
        known[name] = replace(
            Registration.own_frame(transformation.origin_from),
            transformation=transformation, notes=(tie.note,), reference=label, tied_by="units",
        )  # fmt: skip
    return known


def tie_by_units(
    reference: PlacedUnits,
    epochs: Sequence[PlacedUnits],
    units: Sequence[UnitType],
    origin: FloatArray,
    known: Transformation | None,
    source: Path,
    feedback: Feedback,
) -> dict[str, UnitTie]:
    """Ties of the epochs whose units stand elsewhere than those of the reference epoch, by label.

    Parameters
    ----------
    reference
        The epoch in whose frame all are compared.
    epochs
        All epochs.
    units
        Types of unit.
    origin
        (3,) reduction point of the units.
    known
        Registration of the reference epoch; None without.
    source
        File that messages name.
    feedback
        Told what was done.

    Raises
    ------
    InputError
        Control contradicts the units, or two epochs have no units in common.
    """
    height = max(unit.height for unit in units)
    ties = {}
    for epoch in epochs:
        label, own = epoch.label, epoch.found
        if epoch is reference:
            continue
        aligned = aligned_share(reference.found, own, height) >= ALIGNED_SHARE
        if aligned and epoch.registered:
            continue
        near = settled(reference.found, own, height) if aligned else None
        if near is not None and _is_clear(near, reference.found, own):
            if _lies_as(near, reference.found, height):
                continue
            motion: Alignment | None = near
        else:
            far = align(reference.found, own, units)
            motion = max((found for found in (near, far) if found is not None), key=lambda found: found.matched, default=None)
        if motion is None and aligned:
            continue
        if motion is None:
            _warn_of_shift(label, reference.label, reference.found, own, height, feedback)
            _refuse_strangers(source, label, reference.label, reference.found, own)
            continue
        told = _described(motion, own)
        if epoch.registered:
            raise InputError(
                f"epoch {label}: control places its units {told} away from those of epoch {reference.label}{_geoid(motion, own)}",
                source=source,
                remedy="Check control and targets of both epochs: files of the same epoch, the same CRS, the same height system.",
            )
        feedback.info(
            f"{label}: its cloud lies {told} from that of {reference.label}; aligned by {motion.matched} units that stand alike in "
            f"both, so that only motions against their neighbours can be seen{_geoid(motion, own)}"
        )
        note = f"aligned to {reference.label} by {motion.matched} units that both show"
        ties[label] = UnitTie(transformation=_transformation(motion, own, origin, known), note=note)
    return ties


def _is_clear(motion: Alignment, first: FoundUnits, second: FoundUnits) -> bool:
    """Whether a motion brings so many units together that no other one is looked for."""
    return motion.matched >= CLEAR_SHARE * min(int(first.certain.sum()), int(second.certain.sum()))


def _lies_as(motion: Alignment, first: FoundUnits, height: float) -> bool:
    """Whether two clouds lie so alike that the adjustment of their common motion, linear in its turn, may start from where they are."""
    extent = float(np.linalg.norm(np.ptp([pose.centre for pose in first.poses], axis=0)))
    return 0.25 * extent * motion.turn**2 < LINEAR_HEIGHTS * height


def _warn_of_shift(label: str, reference: str, before: FoundUnits, after: FoundUnits, height: float, feedback: Feedback) -> None:
    """Say so where units too few for a constellation stand alike, but elsewhere."""
    first, second = (np.array([pose.centre for pose in found.poses]).reshape(-1, 3) for found in (before, after))
    shift = whole_shift(first, second, height)
    if shift is None:
        return
    feedback.warning(
        f"{label}: its units seem shifted as a whole by {float(np.linalg.norm(shift)):.1f} m against those of {reference} "
        f"({', '.join(f'{value:+.1f}' for value in shift)} m in easting, northing and height): another height system or frame? "
        "They count as unseen and new."
    )


def _origin(fitted: Sequence[EpochUnits]) -> FloatArray:
    centres = np.concatenate([epoch.table["poses"][:, :3] for epoch in fitted])
    return np.round(np.median(centres, axis=0)) if len(centres) else np.zeros(3)


def _found(epoch: EpochUnits, registration: Registration | None, origin: FloatArray) -> FoundUnits:
    transformation = Transformation.identity(origin) if registration is None else registration.transformation
    poses = tuple(transformation.apply_pose(epoch.pose(row)).shifted(-origin) for row in range(len(epoch)))
    return FoundUnits(poses, np.asarray(epoch.table["type"], dtype=np.int64), np.asarray(epoch.table["status"] == "found"))


def _refuse_strangers(source: Path, label: str, other: str, first: FoundUnits, second: FoundUnits) -> None:
    if min(int(first.certain.sum()), int(second.certain.sum())) < COMPARABLE_UNITS:
        return
    a, b = (np.array([pose.centre for pose in found.poses]) for found in (first, second))
    overlap = np.minimum(a.max(axis=0), b.max(axis=0)) - np.maximum(a.min(axis=0), b.min(axis=0))
    apart = "they do not overlap" if (overlap[:2] < 0).any() else "they overlap, but no motion brings their units together"
    raise InputError(
        f"epochs {other} and {label} have no units in common: {apart}",
        source=source,
        remedy="Check the tiles of both epochs and their CRS; epochs of different places are surveys of their own.",
    )


def _described(motion: Alignment, found: FoundUnits) -> str:
    middle = np.mean([pose.centre for pose in found.poses], axis=0)
    # from the reference to where the cloud lies
    east, north, up = -motion.shift_at(middle)
    return f"{east:+.2f} m east, {north:+.2f} m north, {up:+.2f} m up and turned by {motion.turn_degrees:.2f} degrees"


def _geoid(motion: Alignment, found: FoundUnits) -> str:
    middle = np.mean([pose.centre for pose in found.poses], axis=0)
    shift = motion.shift_at(middle)
    if abs(shift[2]) < GEOID_LEAST or math.hypot(shift[0], shift[1]) > 0.2 * abs(shift[2]) or motion.turn_degrees > GEOID_TILT:
        return ""
    return (
        f"; heights alone differ, by {abs(shift[2]):.2f} m, as ellipsoidal and levelled heights do (geoid separation): bring both into one "
        "height system"
    )


def _transformation(motion: Alignment, found: FoundUnits, origin: FloatArray, known: Transformation | None) -> Transformation:
    """The motion as transformation of the cloud into the frame of the reference epoch, whose error ``known`` it shares."""
    middle = np.mean([pose.centre for pose in found.poses], axis=0)
    variance = motion.scatter**2 / max(motion.matched, 1)
    spread = float(np.mean(np.var([pose.centre for pose in found.poses], axis=0)[:2])) or 1.0
    covariance = np.diag([variance] * 3 + [variance / spread] * 3 + [0.0])
    place = origin + middle
    return Transformation(
        origin_from=place,
        origin_to=place,
        translation=motion.shift_at(middle),
        rotation=Rotation.from_matrix(motion.rotation).as_matrix(),
        scale=1.0,
        covariance=covariance if known is None else covariance + known.covariance_at(place),
    )
