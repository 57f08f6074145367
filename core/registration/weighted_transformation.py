"""Weighted least squares for the rigid or similarity transformation between points of two frames."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from ..common.arrays import BoolArray, FloatArray
from ..common.rotations import closest_rotation
from .transformation import Transformation, rigid_jacobian


@dataclass(frozen=True, eq=False, kw_only=True)
class WeightedFit:
    """Transformation by weighted least squares, with what tests need.

    Attributes
    ----------
    transformation
        Cloud to control, with the covariance of the stated deviations.
    sigma0, redundancy, square_sum
        Standard deviation of unit weight, degrees of freedom, and the weighted sum of squares of the residuals.
    residuals
        (n, 3) adjusted less surveyed, metres, of points left out too.
    rows
        Derivatives of the coordinates with respect to the free parameters.
    """

    transformation: Transformation
    sigma0: float
    redundancy: int
    square_sum: float
    residuals: FloatArray
    rows: FloatArray


def weighted_fit(surveyed: FloatArray, measured: FloatArray, variances: FloatArray, used: BoolArray, similarity: bool) -> WeightedFit:
    """Weighted least squares over the used points; closed-form start, then Gauss-Newton with the full weights.

    Parameters
    ----------
    surveyed, measured
        (n, 3) the same points in control and in the cloud, metres.
    variances
        (n, 3) of their differences, square metres.
    used
        (n,) points that take part.
    similarity
        Estimate a scale as well.
    """
    weights = np.where(used[:, None], 1 / variances, 0.0)
    mean_weight = weights.mean(axis=1)
    origin_from, origin_to = _weighted_mean(measured, mean_weight), _weighted_mean(surveyed, mean_weight)
    x, y = measured - origin_from, surveyed - origin_to
    rotation, scale = closed_form(x[used], y[used], mean_weight[used], similarity)
    free = 7 if similarity else 6
    translation = np.zeros(3)
    cofactor = np.zeros((7, 7))
    for _ in range(10):
        turned = scale * x @ rotation.T
        misfit = y - turned - translation
        rows = rigid_jacobian(turned)[:, :, :free]
        rows = rows.copy()
        if similarity:
            rows[:, :, 6] /= scale
        normal = np.einsum("nia,ni,nib->ab", rows, weights, rows)
        change = np.linalg.solve(normal, np.einsum("nia,ni,ni->a", rows, weights, misfit))
        translation = translation + change[:3]
        rotation = Rotation.from_rotvec(change[3:6]).as_matrix() @ rotation
        if similarity:
            scale += change[6]
        if np.linalg.norm(change[:3]) < 1e-9 and np.linalg.norm(change[3:6]) < 1e-12:
            break
    cofactor[:free, :free] = np.linalg.inv(normal)
    residuals = scale * x @ rotation.T + translation - y
    redundancy = 3 * int(used.sum()) - free
    square_sum = float(np.sum(weights * residuals**2))
    sigma0 = math.sqrt(square_sum / redundancy) if redundancy > 0 else 1.0
    transformation = Transformation(
        origin_from=origin_from, origin_to=origin_to, translation=translation, rotation=rotation, scale=float(scale), covariance=cofactor
    )
    return WeightedFit(
        transformation=transformation, sigma0=sigma0, redundancy=redundancy, square_sum=square_sum, residuals=residuals, rows=rows
    )


def closed_form(x: FloatArray, y: FloatArray, weights: FloatArray, similarity: bool) -> tuple[FloatArray, float]:
    """Rotation and scale of reduced points."""
    x, y = x - _weighted_mean(x, weights), y - _weighted_mean(y, weights)
    rotation, values = closest_rotation((y * weights[:, None]).T @ x)
    scale = float(np.sum(values) / np.sum(weights * np.sum(x**2, axis=1))) if similarity else 1.0
    return rotation, scale


def _weighted_mean(places: FloatArray, weights: FloatArray) -> FloatArray:
    """(3,) mean of (n, 3) places; numpy's takes longer than all else here to look at what it is given."""
    return np.asarray((places * weights[:, None]).sum(axis=0) / weights.sum())
