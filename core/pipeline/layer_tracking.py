"""Step ``track``: fitted units of several epochs, given as layers, followed and compared without their points."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace
from datetime import datetime
from pathlib import Path
from typing import Any, cast, get_args

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..common.feedback import Feedback
from ..common.output_files import check_targets
from ..common.software import software_version
from ..data.crs import check_same_crs
from ..data.survey_keys import SECTIONS
from ..deformation.displacement import grades_from
from ..deformation.epoch_frames import FrameChoice
from ..deformation.fitted_unit import FittedUnit
from ..deformation.identity import FoundUnits
from ..deformation.tracked_epoch import TrackedEpoch
from ..deformation.tracking import Tracking, track
from ..deformation.unit_clouds import UnitCloud
from ..model.pose import Pose
from ..model.unit_types import UnitType, told_apart
from ..registration.transformation import Transformation
from ..results.field_checks import foreign_contents
from ..results.geopackage_writer import check_output, from_upper_triangle, write_result
from ..results.unit_sizes import size_of
from ..segmentation.leg_ends import LegEnds
from .displacement_table import TableOptions, displacement_rows, pair_rows, unit_names, unit_tables, velocity_rows
from .epoch_alignment import PlacedUnits, tie_by_units
from .epoch_quality import state_quality
from .frame_table import frame_error_rows, frame_settings, stretch_rows
from .gap_table import gap_rows
from .registered_layers import RegisteredEpoch, read_registered
from .stated_frames import StatedFrame, is_registered, stated_frames
from .unit_input import SAME_HEIGHT, crs_of_layer, read_units, stated_sizes

FROM_FIT = ("legs_visible", "coverage", "score", "sigma0", "n_points", "distance_median", "supported")
"""Fields of ``units`` that tracking takes over."""
NOT_FITTED = "Give a result of tetratrack fit."

_Kind = tuple[str, float]
"""Type of unit in a layer: its name there, and the least height of its units in metres."""


def run_track(units: Path, registrations: Sequence[Path], output: Path, feedback: Feedback, frame: str = "auto") -> dict[str, Any]:
    """Step ``track``: identity, datum and displacements from fitted units alone.

    Clouds that are not aligned, frames that bend and targets are dealt with as in a whole run. Without points there is no joint
    adjustment of strips and no look-up of missing units, so that ``run`` is the better way where the tiles are at hand.

    Parameters
    ----------
    units
        Layer ``units`` of several epochs with covariance, each in the frame of its cloud. Units of a whole run or of an earlier tracking,
        which stand in the control frame, are taken back to their clouds where ``registrations`` has their epoch, and elsewhere stay as
        they were registered.
    registrations
        GeoPackages of the step ``register``.
    output
        Result to write.
    feedback
        Messages and cancelling.
    frame
        Whether frames may bend.

    Raises
    ------
    InputError
        Fewer than two epochs, units without covariance, epochs that have no units in common, or units of the control frame whose
        registration is not known.
    """
    choice = frame_choice(frame)
    check_targets([(output, "the result")], [units, *registrations])
    crs = crs_of_layer(units)
    check_output(output, crs)
    with foreign_contents(units):
        epochs, fits, types, origin = _fitted_epochs(units, registrations, feedback)
    labels = [epoch.label for epoch in epochs]
    epochs = _aligned(epochs, types, origin, units, feedback)
    result = track(epochs, types, frame=choice)
    names = unit_names(len(result.units))
    limits = {name: key.default for name, key in SECTIONS["displacement"].items()}
    options = TableOptions((float(origin[0]), float(origin[1]), float(origin[2])), limits["significance"], grades_from(limits))

    def from_fit(epoch: int, row: int | None) -> Mapping[str, Any]:
        if row is None:
            return {}
        known = fits[labels[epoch]][row]
        return {name: known.get(name) for name in FROM_FIT}

    unit_rows, points = unit_tables(result, epochs, types, names, origin, from_fit)
    moved, other = displacement_rows(result, epochs, types, names, options)
    feedback.check()
    gaps = gap_rows(unit_rows, [(epoch.label, epoch.time) for epoch in epochs], types)
    state_quality(unit_rows, types, labels, feedback)
    tables = {
        "epochs": _epoch_rows(result, epochs, types, origin),
        "units": unit_rows,
        "gaps": gaps,
        "feature_points": points,
        "displacements": moved,
        "displacements_other": other,
        "epoch_pairs": pair_rows(result, epochs, origin),
        "velocities": velocity_rows(result, epochs, names, origin),
        "frame_errors": frame_error_rows(result, epochs, max(unit.height for unit in types), origin),
        "stretches": stretch_rows(result.pairs, epochs, origin, limits["significance"]),
    }
    write_result(output, crs, tables)
    return {
        "output": str(output),
        "units": len(names),
        "displacements": len(moved),
        "moved": len({row["unit_id"] for row in moved if row["class"] == "moved"}),
    }


def _epoch_rows(result: Tracking, epochs: Sequence[TrackedEpoch], types: Sequence[UnitType], origin: FloatArray) -> list[dict[str, Any]]:
    """Rows of layer ``epochs``: what the steps after this one must know of the frames and of the types of unit."""
    kinds = [asdict(unit) for unit in types]
    rows = []
    for k, epoch in enumerate(epochs):
        known = epoch.registration
        record = None if known is None else json.dumps(replace(known, origin_to=known.origin_to + origin).as_record())
        settings = {"step": "track", "redundancy": epoch.redundancy, "frame": frame_settings(result, k), "unit_types": kinds}
        rows.append(
            {
                "label": epoch.label, "time": epoch.time, "transformation": record, "datum": epoch.datum,
                "reference_epoch": None if epoch.tied_to is None else epochs[epoch.tied_to].label,
                "software": f"tetratrack {software_version()}", "settings": json.dumps(settings, sort_keys=True),
            }
        )  # fmt: skip
    return rows


def _fitted_epochs(
    units: Path, registrations: Sequence[Path], feedback: Feedback
) -> tuple[list[TrackedEpoch], dict[str, list[dict[str, Any]]], tuple[UnitType, ...], FloatArray]:
    """Epochs in the order of time, rows of each by its label, types of unit, and the (3,) origin of the reduced frame."""
    rows = [row for row in read_units(units) if row["geometry"] is not None]
    labels = sorted({str(row["epoch"]) for row in rows}, key=lambda label: _time_of(rows, label, units))
    if len(labels) < 2:
        raise InputError(f"holds {len(labels)} epoch", source=units, remedy="Give the units of at least two epochs.")
    fits = {label: [row for row in rows if row["epoch"] == label] for label in labels}
    frames = {label: frame for label, frame in stated_frames(units).items() if label in labels}
    registered, kept = _registered(fits, frames, units, registrations, feedback)
    origin: FloatArray = np.round(np.array([row["geometry"] for row in rows], dtype=np.float64).mean(axis=0))
    kinds = _kinds(rows, units)
    epochs = []
    for label in labels:
        found = [_as_found(row, frames.get(label), label in kept, units) for row in fits[label]]
        epochs.append(_fitted_epoch(label, fits[label], found, registered.get(label), kinds, origin, units))
    return [_tied(epoch, registered, labels) for epoch in epochs], fits, tuple(kinds.values()), origin


def _registered(
    fits: Mapping[str, Sequence[Mapping[str, Any]]],
    frames: Mapping[str, StatedFrame],
    units: Path,
    registrations: Sequence[Path],
    feedback: Feedback,
) -> tuple[dict[str, RegisteredEpoch], set[str]]:
    """What ties each epoch, and the epochs whose units stay where their own file's registration put them."""
    for path in registrations:
        check_same_crs(crs_of_layer(path), crs_of_layer(units), source=path, whose=units.name)
    given = read_registered(registrations)
    kept = {label for label in frames if label not in given or given[label].bent or given[label].transformation is None}
    for label in sorted(kept):
        if frames[label].applied.bent:
            # how far its targets leave the bend open is not in it, and the control datum would hang on the units instead
            raise InputError(
                f"holds units of {label} in a frame that was bent", source=units, where="layer units",
                remedy="Give what tetratrack register says of this survey with --registration, or the units of tetratrack fit.",
            )  # fmt: skip
        feedback.info(f"{label}: its units are in the control frame already and stay as they were registered")
    registered = given | {label: frames[label].applied for label in kept}
    for label, rows in fits.items():
        if label in registered and label not in frames and any(map(is_registered, rows)):
            raise InputError(
                f"holds units of {label} in the control frame, which would be registered twice", source=units,
                remedy="Give the units of Fit tetrapods, or the whole result instead of its layer, or no registration.",
            )  # fmt: skip
        if label not in registered or registered[label].transformation is None:
            feedback.info(f"{label}: no registration, its cloud's frame is taken as registered")
    return registered, kept


def _as_found(row: Mapping[str, Any], frame: StatedFrame | None, kept: bool, source: Path) -> tuple[Pose, FloatArray]:
    """Pose and (6, 6) covariance of a unit without what its epoch's frame brings into it; in the frame of the cloud unless ``kept``."""
    pose = Pose.from_quaternion(row["geometry"], [row["qx"], row["qy"], row["qz"], row["qw"]])
    if not row.get("covariance"):
        raise InputError(f"unit {row.get('unit_id')} has no covariance", source=source, remedy=NOT_FITTED)
    covariance: FloatArray = from_upper_triangle(row["covariance"])[:6, :6]
    if frame is None:
        return pose, covariance
    covariance = frame.own_covariance(pose, covariance)
    if kept:
        return pose, covariance
    turn = np.kron(np.eye(2), frame.transformation.rotation.T)
    return frame.in_cloud(pose), turn @ covariance @ turn.T


def frame_choice(text: str) -> FrameChoice:
    """Choice of that name.

    Raises
    ------
    InputError
        It is none.
    """
    for choice in get_args(FrameChoice):
        if text == choice:
            return cast(FrameChoice, choice)
    raise InputError(f"{text!r} is no choice of frame", where="frame", remedy=f"Use one of: {', '.join(get_args(FrameChoice))}.")


def _tied(epoch: TrackedEpoch, registered: Mapping[str, RegisteredEpoch], labels: Sequence[str]) -> TrackedEpoch:
    """The epoch with the one it was tied to on stable areas; where that has no units here, its error counts as the epoch's own."""
    own = registered.get(epoch.label)
    if own is None or own.reference not in labels:
        return epoch
    return replace(epoch, tied_to=labels.index(own.reference))


def _aligned(
    epochs: Sequence[TrackedEpoch], types: Sequence[UnitType], origin: FloatArray, source: Path, feedback: Feedback
) -> list[TrackedEpoch]:
    """The epochs, those that only their units tie brought into the frame of the first registered one, or of the first."""
    placed = [
        PlacedUnits(
            label=epoch.label,
            found=FoundUnits(
                tuple(unit.pose for unit in epoch.units),
                np.array([unit.kind for unit in epoch.units], dtype=np.int64),
                np.array([unit.certain for unit in epoch.units], dtype=bool),
            ),
            registered=epoch.registration is not None,
        )
        for epoch in epochs
    ]
    root = next((k for k, epoch in enumerate(placed) if epoch.registered), 0)
    known = epochs[root].registration
    absolute = None if known is None else replace(known, origin_to=known.origin_to + origin)
    ties = tie_by_units(placed[root], placed, types, origin, absolute, source, feedback)
    return [epoch if epoch.label not in ties else _moved(epoch, ties[epoch.label].transformation, origin, root) for epoch in epochs]


def _moved(epoch: TrackedEpoch, motion: Transformation, origin: FloatArray, root: int) -> TrackedEpoch:
    """The epoch, whose cloud's frame was taken as registered, moved by a tie to the epoch ``root``."""
    turn = np.kron(np.eye(2), motion.rotation)
    units = tuple(
        replace(
            unit,
            pose=motion.apply_pose(unit.pose.shifted(origin)).shifted(-origin),
            covariance=None if unit.covariance is None else turn @ unit.covariance @ turn.T,
        )
        for unit in epoch.units
    )
    return replace(epoch, units=units, registration=replace(motion, origin_to=motion.origin_to - origin), tied_to=root, datum="units")


def _time_of(rows: Sequence[Mapping[str, Any]], label: str, source: Path) -> datetime:
    value = next(row.get("epoch_time") for row in rows if row["epoch"] == label)
    if not isinstance(value, datetime):
        raise InputError(f"epoch {label!r} has no epoch_time", source=source, remedy=NOT_FITTED)
    return value


def _kinds(rows: Sequence[Mapping[str, Any]], source: Path) -> dict[_Kind, UnitType]:
    """Types of unit by their name and least height in the rows: geometry as the file's settings state it, with the median shape of the
    fits. Heights of one name that differ by less than ``SAME_HEIGHT`` are of one type."""
    sizes = stated_sizes(source)
    own: dict[_Kind, list[list[float]]] = {}
    for name in dict.fromkeys(_name_of(row) for row in rows):
        values = [[row.get(field) for field in ("height", "r0", "gradient")] for row in rows if _name_of(row) == name]
        given = np.array(values, dtype=np.float64)
        if np.isnan(given).any():
            raise InputError("layer units has no height, r0 or gradient", source=source, remedy=NOT_FITTED)
        least = -math.inf
        for shape in sorted(given.tolist()):
            least = shape[0] if shape[0] > (1.0 + SAME_HEIGHT) * least else least
            own.setdefault((name, least), []).append(shape)
    found = []
    for (name, _), shapes in own.items():
        height, radius, gradient = (float(v) for v in np.median(shapes, axis=0))
        size = size_of({"unit_type": name, "height": height}, sizes)
        found.append(
            UnitType.tetrapod(height, radius=radius, gradient=gradient, leg_length=size.leg_length, opening=size.opening, name=name)
        )
    return dict(zip(own, told_apart(found), strict=True))


def _kind_of(row: Mapping[str, Any], kinds: Mapping[_Kind, UnitType]) -> int:
    """Number of the type of a row, of which ``kinds`` were formed."""
    own = [(least, k) for k, (name, least) in enumerate(kinds) if name == _name_of(row) and least <= row["height"]]
    return max(own)[1]


def _name_of(row: Mapping[str, Any]) -> str:
    return str(row.get("unit_type") or "tetrapod")


def _fitted_epoch(
    label: str,
    rows: Sequence[Mapping[str, Any]],
    poses: Sequence[tuple[Pose, FloatArray]],
    registered: RegisteredEpoch | None,
    kinds: Mapping[_Kind, UnitType],
    origin: FloatArray,
    source: Path,
) -> TrackedEpoch:
    """Units of an epoch, ``poses`` with (6, 6) covariances as found, in the control frame less ``origin``; without control in the frame
    of its cloud."""
    registration = None if registered is None else registered.transformation
    transformation = Transformation.identity(origin) if registration is None else registration
    types = tuple(kinds.values())
    found = []
    turn = np.kron(np.eye(2), transformation.rotation)
    for row, (pose, covariance) in zip(rows, poses, strict=True):
        kind = _kind_of(row, kinds)
        found.append(
            FittedUnit(
                pose=transformation.apply_pose(pose).shifted(-origin),
                shape=types[kind],
                kind=kind,
                certain=row.get("status") != "uncertain",
                discs=np.zeros(4, dtype=np.bool_),
                cloud=UnitCloud.none(),
                covariance=turn @ covariance @ turn.T,
                score=_number(row.get("score"), 1.0),
                n_points=int(_number(row.get("n_points"), 0.0)),
                legs=LegEnds.from_row(row),
            )
        )
    placed = None if registration is None else replace(registration, origin_to=registration.origin_to - origin)
    return TrackedEpoch(
        label=label,
        time=_time_of(rows, label, source),
        units=tuple(found),
        registration=placed,
        redundancy=0 if registered is None else registered.redundancy,
        targets=None if registered is None else registered.target_shifts(origin),
        datum="cloud" if registered is None else registered.datum,
    )


def _number(value: Any, otherwise: float) -> float:
    return otherwise if value is None else float(value)
