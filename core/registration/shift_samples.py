"""Shifts of many small bodies or of targets, pooled by cells of the ground, from which the bend of a frame is learned."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import BoolArray, FloatArray
from ..common.axis import main_direction
from ..common.robust import CHI2_1_MEDIAN
from .frame_field import FieldModel

FEWEST_CELLS = 15
"""Cells from which a bend is learned, and among which a stretch that moved as one is looked for."""
TREND_SHIFT, TREND_SLOPE = 1.0, 0.01
"""Prior standard deviations of a shift (m) and slope that the rigid motion may leave."""


@dataclass(frozen=True, eq=False, kw_only=True)
class ShiftSample:
    """Shifts that are to be explained.

    Attributes
    ----------
    places
        (k, 2) metres.
    values
        (k, 3) metres.
    variances
        (k, 3) square metres, of independent errors.
    fixed
        (k,) observations that no one may leave out: targets.
    """

    places: FloatArray
    values: FloatArray
    variances: FloatArray
    fixed: BoolArray

    def joined(self, other: ShiftSample) -> ShiftSample:
        """Both samples."""
        return ShiftSample(
            places=np.vstack([self.places, other.places]), values=np.vstack([self.values, other.values]),
            variances=np.vstack([self.variances, other.variances]), fixed=np.concatenate([self.fixed, other.fixed]),
        )  # fmt: skip


def axis_of(places: FloatArray) -> tuple[tuple[float, float], float]:
    """Main direction of (k, 2) places, and length over width of what they cover."""
    along = main_direction(places)
    extent = np.ptp((places - places.mean(axis=0)) @ np.column_stack([along, [-along[1], along[0]]]), axis=0)
    return (float(along[0]), float(along[1])), float(extent[0] / max(extent[1], 1e-9))


def in_cells(places: FloatArray, values: FloatArray, variances: FloatArray, size: float) -> ShiftSample:
    """Median shifts of the bodies in each cell of a grid of ``size`` metres, and their variances.

    The stated (k, 3) ``variances`` are scaled to what neighbours differ by, since errors of their own are understated as a rule.
    """
    own = noise_between_neighbours(places, values, size)
    scale = np.maximum(own / np.maximum(np.median(variances, axis=0), 1e-18), 1e-3)
    key = np.floor((places - places.min(axis=0)) / size).astype(np.int64)
    _, cell = np.unique(key[:, 0] * (key[:, 1].max() + 1) + key[:, 1], return_inverse=True)
    order = np.argsort(cell, kind="stable")
    groups = np.split(order, np.flatnonzero(np.diff(cell[order])) + 1)
    middle = np.array([np.median(values[g], axis=0) for g in groups])
    # a median of many is less certain than their mean by pi / 2 (Kendall and Stuart, 1977, The Advanced Theory of Statistics, 14.12)
    spread = np.array([np.median(variances[g], axis=0) * scale * (1.0 if len(g) < 3 else math.pi / 2) / len(g) for g in groups])
    centre = np.array([places[g].mean(axis=0) for g in groups])
    return ShiftSample(places=centre, values=middle, variances=spread, fixed=np.zeros(len(groups), dtype=bool))


def noise_between_neighbours(places: FloatArray, values: FloatArray, reach: float) -> FloatArray:
    """(3,) variance of single bodies' shifts by component, from differences between neighbours within ``reach`` metres."""
    pairs = cKDTree(places).query_pairs(reach, output_type="ndarray")
    if len(pairs) < 8:
        nearest = cKDTree(places).query(places, k=min(2, len(places)))[1].reshape(len(places), -1)[:, -1]
        pairs = np.column_stack([np.arange(len(places)), nearest])
    difference = values[pairs[:, 0]] - values[pairs[:, 1]]
    return np.asarray(np.maximum(np.median(difference**2, axis=0) / CHI2_1_MEDIAN / 2, 1e-12))


def trend_of(places: FloatArray) -> FloatArray:
    """(k, 3) columns of a shift and two slopes at (k, 2) places, scaled by their prior deviations: what a rigid motion may leave."""
    arm = places - places.mean(axis=0)
    return np.column_stack([np.full(len(places), TREND_SHIFT), TREND_SLOPE * arm])


def smooth_covariances(places: FloatArray, model: FieldModel) -> list[FloatArray]:
    """By component, (k, k) covariance in square metres of what a bend and the rigid motion make at (k, 2) places, without noise."""
    scaled, trend = model.scaled(places), trend_of(places)
    correlation, left = model.correlation(scaled, scaled), trend @ trend.T
    return [np.asarray(sd**2 * correlation + left) for sd in model.sds]
