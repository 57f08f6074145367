"""Rows of ``frame_errors`` and ``stretches``: how the frames bend along the structure, and what its stretches did together."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..deformation.epoch_pairs import DATUMS, EpochPair
from ..deformation.stretches import stretches_of
from ..deformation.tracked_epoch import TrackedEpoch
from ..deformation.tracking import Tracking
from ..registration.frame_field import LocalMotions

Row = dict[str, Any]


def frame_error_rows(tracking: Tracking, epochs: Sequence[TrackedEpoch], height: float, origin: FloatArray) -> list[Row]:
    """Rows of ``frame_errors``: of every epoch as its targets see it, of pairs as resting units see them, and of strips that drift."""
    places = [s.pose.centre for states in tracking.units for s in states.values() if s.pose is not None]
    if not places:
        return []
    points, along = _stations(np.array(places), height)
    rows: list[Row] = []
    if tracking.frames is not None:
        length = tracking.frames.model.length
        for number, epoch in enumerate(epochs):
            known = tracking.frame_error(number, points)
            if known is not None:
                rows += _rows(known, points, along, origin, {"epoch": epoch.label, "known_by": "targets", "correlation_length": length})
        for pair in tracking.pairs:
            if pair.tie is not None and pair.second == pair.first + 1:
                base = {"epoch": epochs[pair.second].label, "epoch_from": epochs[pair.first].label, "known_by": "units"}
                rows += _rows(pair.tie.stable.at(points), points, along, origin, base | {"correlation_length": length})
    return rows + _drift_rows(tracking, epochs, origin)


def frame_settings(tracking: Tracking, epoch: int) -> dict[str, Any]:
    """How an epoch's frame was treated, for the record."""
    frames = tracking.frames
    drifts = tracking.joint.drifts is not None and any(e == epoch for e, _ in tracking.joint.drifts.numbers)
    if frames is None:
        return {"bends": False, "strips_drift": drifts}
    return {
        "bends": True,
        "strips_drift": drifts,
        "sd_m": [round(sd, 5) for sd in frames.model.sds],
        "correlation_length_m": round(frames.model.length, 2),
        "correlation_length_across_m": round(frames.model.across, 2),
        "smoothness": frames.model.smoothness,
        "log_likelihood_gain": round(frames.gain, 1),
        "targets_noise_factor": frames.noise_factor,
        "stretches_that_moved_as_one": [[round(low, 1), round(high, 1)] for b in frames.bendings if b is not None for low, high in b.jumps],
    }


def _stations(places: FloatArray, height: float) -> tuple[FloatArray, FloatArray]:
    """(k, 3) unit in the middle of each stretch of three heights, and where the stretch lies along the structure, metres.

    A field is known where units are: the middle itself may lie in a gap.
    """
    _, along, _ = stretches_of(places, height)
    number = (along / (3 * height)).astype(np.int64)
    points, middles = [], []
    for k in np.unique(number):
        own = places[number == k]
        points.append(own[np.argmin(np.linalg.norm(own - own.mean(axis=0), axis=1))])
        middles.append(along[number == k].mean())
    return np.array(points), np.array(middles)


def _rows(known: LocalMotions, points: FloatArray, along: FloatArray, origin: FloatArray, base: Row) -> list[Row]:
    rows = []
    for k, place in enumerate(points):
        shift, covariance = known.means[k, :3], known.covariances[k, :3, :3]
        rows.append(base | _vector(shift, covariance) | {"along": float(along[k]), "geometry": place + origin})
    return rows


def _drift_rows(tracking: Tracking, epochs: Sequence[TrackedEpoch], origin: FloatArray) -> list[Row]:
    """Deviation of every strip from the mean of its epoch, offset included, at the units nearest to the knots."""
    drifts = tracking.joint.drifts
    if drifts is None:
        return []
    centres = {unit: next(s.pose.centre for s in states.values() if s.pose is not None) for unit, states in enumerate(tracking.units)
               if unit in drifts.places and any(s.pose is not None for s in states.values())}  # fmt: skip
    by_knot: dict[int, list[int]] = {}
    for unit in centres:
        by_knot.setdefault(int(drifts.knots.first[drifts.places[unit]]), []).append(unit)
    rows = []
    for (epoch, source), strip in sorted(drifts.numbers.items()):
        for knot, units in sorted(by_knot.items()):
            shift = tracking.joint.offsets[epoch, source] + 0.5 * (drifts.values[knot, strip] + drifts.values[knot + 1, strip])
            sds = tracking.joint.offset_sds[epoch, source]
            place = np.mean([centres[unit] for unit in units], axis=0)
            rows.append(
                _vector(shift, np.diag(sds**2))
                | {
                    "epoch": epochs[epoch].label,
                    "strip": int(source),
                    "known_by": "strips",
                    "along": float((knot + 0.5) * drifts.knots.spacing),
                    "geometry": place + origin,
                }
            )
    return rows


def stretch_rows(pairs: Sequence[EpochPair], epochs: Sequence[TrackedEpoch], origin: FloatArray, level: float) -> list[Row]:
    """Rows of ``stretches``."""
    rows = []
    for pair in pairs:
        for datum in DATUMS:
            for stretch in pair.stretches[datum]:
                rows.append(
                    {
                        "epoch_from": epochs[pair.first].label,
                        "epoch_to": epochs[pair.second].label,
                        "time_from": epochs[pair.first].time,
                        "time_to": epochs[pair.second].time,
                        "datum": datum,
                        "along_from": stretch.along_from,
                        "along_to": stretch.along_to,
                        "units": stretch.units,
                        "p_value": stretch.p_value,
                        "significant": bool(stretch.adjusted < level),
                        "detectable": stretch.detectable,
                        "geometry": stretch.place + origin,
                    }
                    | _vector(stretch.motion, stretch.covariance)
                )
    return rows


def _vector(shift: FloatArray, covariance: FloatArray) -> Row:
    sds = np.sqrt(np.clip(np.diag(covariance), 0, None))
    return {
        "de": shift[0],
        "dn": shift[1],
        "dh": shift[2],
        "d_3d": math.sqrt(float(shift @ shift)),
        "sd_e": sds[0],
        "sd_n": sds[1],
        "sd_h": sds[2],
    }
