"""Shape of the units of one survey: radius and gradient shared by all, estimated from the units that are seen best.

Moulds differ from the catalogue's proportions, and a wrong taper moves the centre of a unit seen from one side by centimetres. One unit
seen from one side determines its taper poorly, many together well: every unit is adjusted with free shape, its pose eliminated (its
2x2 covariance of radius and gradient is what remains of its normal equations), and the units are combined with the scatter between
them (manufacture, systematic errors of the cloud) as a component of variance (DerSimonian and Laird, 1986).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import chdtri

from ..common.arrays import BoolArray, FloatArray
from ..common.errors import InputError, NoSolutionError
from ..common.robust import MAD_TO_SD
from ..model.pose import Pose
from ..model.unit_types import UnitType
from .adjustment_records import Adjustment, AdjustmentOptions
from .gauss_helmert import adjust

MIN_LEGS = 2
"""Legs a unit must show to take part: with one, radius and gradient mix with the place along its axis."""
CALIBRATION_UNITS = 60
"""Units used, those with most points: enough to average the scatter between units out."""
REJECTION = 0.999
"""Probability up to which a unit's distance from the common shape is taken for chance."""


@dataclass(frozen=True, eq=False)
class Calibration:
    """Common shape of the units of a survey.

    Attributes
    ----------
    unit
        The unit type with the estimated radius (metres) and gradient.
    covariance
        (2, 2) of the common radius and gradient.
    between
        (2,) standard deviation of single units' radius and gradient about the common values.
    used
        (n,) units that took part in the end.
    shapes
        (n, 2) radius and gradient of every unit adjusted by itself; nan where it could not be.
    """

    unit: UnitType
    covariance: FloatArray
    between: FloatArray
    used: BoolArray
    shapes: FloatArray

    @property
    def sd(self) -> FloatArray:
        """(2,) standard deviations of the common radius and gradient."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))

    @property
    def unit_sds(self) -> FloatArray:
        """(2,) standard deviations of a single unit's radius and gradient about the stated ones: the priors of later adjustments.

        They hold the error of the common values, so that no shape is held as known: where few units hide their scatter, ``between`` is 0.
        """
        return np.asarray(np.sqrt(self.between**2 + self.sd**2))


def calibrate(
    points: Sequence[ArrayLike],
    unit: UnitType,
    poses: Sequence[Pose],
    *,
    covariances: Sequence[ArrayLike | None] | None = None,
    options: AdjustmentOptions | None = None,
    best: int = CALIBRATION_UNITS,
) -> Calibration:
    """Estimate radius and gradient common to units.

    Parameters
    ----------
    points
        For each unit (m, 3) metres in a reduced frame.
    unit
        Nominal geometry, the starting value.
    poses
        Approximate pose of each unit.
    covariances
        For each unit (m, 3, 3) covariances of its points, square metres, or None for equal noise in all directions; None for equal noise
        of all.
    options
        Options of the single adjustments; their shape is always free.
    best
        Number of units used, those with most points.

    Raises
    ------
    InputError
        No unit shows enough legs to determine its shape.
    """
    noise = [None] * len(points) if covariances is None else covariances
    if not len(points) == len(poses) == len(noise):
        raise ValueError(f"{len(points)} clouds but {len(poses)} poses and covariances of {len(noise)}")
    free = replace(options or AdjustmentOptions(), radius_sd=math.inf, gradient_sd=math.inf)
    order = sorted(range(len(points)), key=lambda k: -len(np.asarray(points[k])))[:best]
    shapes = np.full((len(points), 2), math.nan)
    shape_covariances = np.full((len(points), 2, 2), math.nan)
    for k in order:
        try:
            result = adjust(points[k], unit, poses[k], options=free, covariances=noise[k])
        except NoSolutionError:
            continue
        if _determines_shape(result):
            shapes[k] = result.radius, result.gradient
            shape_covariances[k] = result.covariance[6:, 6:]
    used = np.isfinite(shapes[:, 0])
    if not used.any():
        raise InputError(
            "no unit shows enough of itself to calibrate the shape",
            where="[unit], key calibrate",
            remedy="set calibrate = false and give radius and gradient, or use a cloud in which some units show two legs or more",
        )
    _, covariance, between = _combine(shapes[used], shape_covariances[used])
    # the median to begin with: one strange unit must not put the mean where all others look strange
    mean = np.median(shapes[used], axis=0)
    limit = float(chdtri(2, 1 - REJECTION))
    for _ in range(10):
        offsets = shapes - mean
        spread = shape_covariances + np.diag(between**2)
        candidates = np.flatnonzero(np.isfinite(shapes[:, 0]))
        distances = np.array([offsets[k] @ np.linalg.solve(spread[k], offsets[k]) for k in candidates])
        kept = np.zeros(len(points), dtype=np.bool_)
        kept[candidates[distances < limit]] = True
        if not kept.any():
            break
        settled = bool((kept == used).all())
        used = kept
        mean, covariance, between = _combine(shapes[used], shape_covariances[used])
        if settled:
            break
    return Calibration(unit.with_shape(*mean), covariance, between, used, shapes)


def _determines_shape(result: Adjustment) -> bool:
    return result.converged and result.legs_visible >= MIN_LEGS and len(result.undetermined) == 0


def _combine(shapes: FloatArray, covariances: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Common value, its covariance, and the standard deviation between units."""
    if len(shapes) == 1:
        return shapes[0], covariances[0], np.zeros(2)
    middle = np.median(shapes, axis=0)
    within = np.diagonal(covariances, axis1=1, axis2=2)
    # robust: half of the units may be spoilt by neighbours' points
    scatter = (MAD_TO_SD * np.median(np.abs(shapes - middle), axis=0)) ** 2
    between = np.sqrt(np.maximum(scatter - np.median(within, axis=0), 0.0))
    weights = np.linalg.inv(covariances + np.diag(between**2))
    covariance = np.linalg.inv(weights.sum(axis=0))
    mean = covariance @ np.einsum("kij,kj->i", weights, shapes)
    return np.asarray(mean), np.asarray(covariance), np.asarray(between)
