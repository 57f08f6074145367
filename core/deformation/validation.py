"""Comparison of feature points and their displacements with surveyed check points, as in the paper's Table 1.

Check points never enter a fit. Each names the approximate centre of its unit and the surveyed position of one feature point, so the
unit is the nearest one and the feature the nearest of its four joints.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..data.point_tables import read_point_table
from ..model.feature_points import FEATURES

CHECK_COLUMNS = ("point_id", "unit_easting", "unit_northing", "unit_height", "easting", "northing", "height", "sd")
PICK_COLUMNS = ("point_id", "epoch", "easting", "northing", "height")
UNIT_REACH_HEIGHTS = 0.5
"""Farthest a unit's centre may be from the approximate one: two units never come nearer to each other."""
FEATURE_REACH_HEIGHTS = 0.15
"""Farthest a feature may be from its check point: half the distance between two joints of a unit is 0.21 H."""


@dataclass(frozen=True, eq=False)
class CheckPoint:
    """One surveyed feature point: approximate unit centre and position (3,) metres, standard deviation of a coordinate."""

    point_id: str
    unit: FloatArray
    position: FloatArray
    sd: float


@dataclass(frozen=True, eq=False, kw_only=True)
class CheckResidual:
    """Feature less check point in one epoch, metres; ``unit_id`` and ``feature`` are empty where none lies near."""

    point_id: str
    epoch: str
    position: FloatArray
    unit_id: str
    feature: str
    difference: FloatArray | None

    @property
    def length(self) -> float:
        """Length of the difference, nan where nothing was matched."""
        return math.nan if self.difference is None else float(np.linalg.norm(self.difference))


@dataclass(frozen=True, eq=False)
class CheckedDisplacement:
    """One column of the paper's Table 1, metres; manual picks are nan where there are none.

    Attributes
    ----------
    check, fitted, manual
        Length of the displacement by total station, by the feature points and by manual picks.
    vector_error
        Length of the difference between the fitted and the surveyed displacement vectors.
    """

    point_id: str
    unit_id: str
    feature: str
    epoch_from: str
    epoch_to: str
    check: float
    fitted: float
    manual: float
    vector_error: float

    @property
    def error(self) -> float:
        """Fitted less surveyed length."""
        return self.fitted - self.check

    @property
    def manual_error(self) -> float:
        """Manually picked less surveyed length."""
        return self.manual - self.check


@dataclass(frozen=True)
class ErrorSummary:
    """Mean and largest absolute error of displacement lengths, metres, over ``count`` points."""

    count: int
    mean_absolute: float
    maximum: float


def read_check(path: str | Path) -> tuple[CheckPoint, ...]:
    """Read check points; a header without points is a survey in which nothing was checked.

    Raises
    ------
    InputError
        With the line and field at fault.
    """
    rows = read_point_table(path, CHECK_COLUMNS, positive=("sd",), may_be_empty=True)
    return tuple(
        CheckPoint(
            row["point_id"],
            np.array([row["unit_easting"], row["unit_northing"], row["unit_height"]]),
            np.array([row["easting"], row["northing"], row["height"]]),
            row["sd"],
        )
        for row in rows
    )


def read_picks(path: str | Path) -> dict[tuple[str, str], FloatArray]:
    """Manual picks of the same feature points, ``point_id,epoch,easting,northing,height``: (point_id, epoch) to (3,) metres."""
    rows = read_point_table(path, PICK_COLUMNS, text=("point_id", "epoch"), unique=False)
    picks: dict[tuple[str, str], FloatArray] = {}
    for row in rows:
        key = str(row["point_id"]), str(row["epoch"])
        if key in picks:
            raise InputError(
                f"names point {key[0]!r} in epoch {key[1]!r} again", source=path, where=f"line {row['line']}", remedy="Keep one pick."
            )
        picks[key] = np.array([row["easting"], row["northing"], row["height"]])
    return picks


def check_residuals(
    checks: Sequence[CheckPoint], features: Mapping[str, Mapping[str, FloatArray]], height: float, epoch: str
) -> tuple[CheckResidual, ...]:
    """Residuals of one epoch.

    Parameters
    ----------
    checks
        Of that epoch.
    features
        unit_id to feature to (3,) position in the control frame.
    height
        H in metres.
    epoch
        Label.
    """
    ids = [name for name, points in features.items() if "centre" in points]
    centres = np.array([features[name]["centre"] for name in ids]).reshape(-1, 3)
    found = []
    for check in checks:
        unit_id, feature, difference = "", "", None
        away = np.linalg.norm(centres - check.unit, axis=1)
        near = [ids[k] for k in np.flatnonzero(away <= UNIT_REACH_HEIGHTS * height)]
        candidates = [
            (float(np.linalg.norm(features[name][joint] - check.position)), name, joint)
            for name in near
            for joint in FEATURES[1:]
            if joint in features[name]
        ]
        if candidates and min(candidates)[0] <= FEATURE_REACH_HEIGHTS * height:
            _, unit_id, feature = min(candidates)
            difference = features[unit_id][feature] - check.position
        found.append(
            CheckResidual(
                point_id=check.point_id, epoch=epoch, position=check.position, unit_id=unit_id, feature=feature, difference=difference
            )
        )
    return tuple(found)


def checked_displacements(
    residuals: Sequence[CheckResidual], epochs: Sequence[str], picks: Mapping[tuple[str, str], FloatArray] | None = None
) -> tuple[CheckedDisplacement, ...]:
    """Displacements of check points seen on the same feature in two epochs, for every pair of epochs.

    Parameters
    ----------
    residuals
        Of all epochs.
    epochs
        Labels in order of time.
    picks
        Manual picks by point and epoch.
    """
    by_key = {(r.point_id, r.epoch): r for r in residuals if r.difference is not None}
    names = list(dict.fromkeys(r.point_id for r in residuals))
    result = []
    for start, stop in combinations(epochs, 2):
        for name in names:
            a, b = by_key.get((name, start)), by_key.get((name, stop))
            if a is None or b is None or a.difference is None or b.difference is None or (a.unit_id, a.feature) != (b.unit_id, b.feature):
                continue
            surveyed = b.position - a.position
            fitted = surveyed + b.difference - a.difference
            manual = math.nan
            if picks and (name, start) in picks and (name, stop) in picks:
                manual = float(np.linalg.norm(picks[name, stop] - picks[name, start]))
            lengths = float(np.linalg.norm(surveyed)), float(np.linalg.norm(fitted))
            error = float(np.linalg.norm(fitted - surveyed))
            result.append(CheckedDisplacement(name, a.unit_id, a.feature, start, stop, *lengths, manual, error))
    return tuple(result)


def residual_rows(residuals: Sequence[CheckResidual]) -> list[dict[str, Any]]:
    """Rows of layer ``check_residuals``; a check point without a feature nearby has empty differences."""
    rows = []
    for r in residuals:
        de, dn, dh = (None, None, None) if r.difference is None else r.difference
        rows.append(
            {
                "point_id": r.point_id,
                "epoch": r.epoch,
                "unit_id": r.unit_id or None,
                "feature": r.feature or None,
                "de": de,
                "dn": dn,
                "dh": dh,
                "d_3d": r.length,
                "geometry": r.position,
            }
        )
    return rows


def summarise(errors: Sequence[float]) -> ErrorSummary:
    """Mean absolute and largest error; nan values are left out."""
    values = np.abs(np.asarray([e for e in errors if math.isfinite(e)], dtype=np.float64))
    if not len(values):
        return ErrorSummary(0, math.nan, math.nan)
    return ErrorSummary(len(values), float(values.mean()), float(values.max()))
