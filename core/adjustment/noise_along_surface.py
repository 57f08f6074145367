"""What the noise along the surface adds to the normal equations, and how many points belong to each leg beyond doubt."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.kernels import compiled_for, kernel
from .condition_records import PointStates, Solid
from .contested_points import to_body, turned_covariance
from .normal_sums import add_outer


@kernel()
def _form(matrix: Any, first: Any, second: Any) -> float:
    """The bilinear form of a (3, 3) matrix and two vectors."""
    total = 0.0
    for a in range(3):
        for b in range(3):
            total += first[a] * matrix[a, b] * second[b]
    return total


@kernel()
def _row_excess(points: Any, solid: Any, cov: Any, stride: Any, out: Any) -> None:
    """What the noise along the surface adds to the normal equations but not to what the points determine, into ``out`` (12, 12).

    Rows are taken at adjusted observations, which keep the noise along the surface, so legs look longer and better determining than
    they are. The second derivative of the distance, times the residual, cancels this in the expected derivative of the scores; both come
    to the noise variance times the outer product of the rows' derivatives (the errors-in-variables effect; 5 % of the variance where
    the noise is a tenth of the radius). A smooth sum, taken over every ``stride``-th point.
    """
    feet, legs, parts, weights, sds = points.feet, points.legs, points.parts, points.weights, points.sds
    axes, rotation = solid.legs.directions, solid.rotation
    c = solid.shape[1]
    cosine = 1.0 / math.sqrt(1.0 + c * c)
    has_cov = cov.shape[0] == feet.shape[0]
    shift, turn, body_cov = np.zeros(12), np.zeros(12), np.zeros((3, 3))
    taken = all_weight = 0.0
    for i in range(feet.shape[0]):
        all_weight += weights[i]
        if i % stride != 0 or weights[i] <= 0.0:
            continue
        taken += weights[i]
        ax, ay, az = axes[legs[i], 0], axes[legs[i], 1], axes[legs[i], 2]
        z = feet[i, 0] * ax + feet[i, 1] * ay + feet[i, 2] * az
        ux, uy, uz = feet[i, 0] - z * ax, feet[i, 1] - z * ay, feet[i, 2] - z * az
        rho = math.sqrt(ux * ux + uy * uy + uz * uz) + 1e-300
        ux, uy, uz = ux / rho, uy / rho, uz / rho
        tx, ty, tz = ay * uz - az * uy, az * ux - ax * uz, ax * uy - ay * ux
        lateral = parts[i] == 0
        along_t = along_g = 1.0
        if has_cov:
            normal, along = (ax, ay, az), (ux, uy, uz)
            if lateral:
                normal = ((ux + c * ax) * cosine, (uy + c * ay) * cosine, (uz + c * az) * cosine)
                along = ((ax - c * ux) * cosine, (ay - c * uy) * cosine, (az - c * uz) * cosine)
            turned_covariance(cov, i, rotation, body_cov)
            variance = _form(body_cov, normal, normal)
            along_t = _form(body_cov, (tx, ty, tz), (tx, ty, tz)) - _form(body_cov, (tx, ty, tz), normal) ** 2 / variance
            along_g = _form(body_cov, along, along) - _form(body_cov, along, normal) ** 2 / variance
        p = weights[i] / (sds[i] * sds[i])
        shift[3], shift[4], shift[5] = -tx, -ty, -tz
        arm = 1.0
        if lateral:
            arm = cosine * (z - c * rho) / rho
            shift[7] = cosine * cosine
            turn[0], turn[1], turn[2] = -cosine * tx / rho, -cosine * ty / rho, -cosine * tz / rho
        else:
            shift[7] = turn[0] = turn[1] = turn[2] = 0.0
        turn[3], turn[4], turn[5] = arm * ux, arm * uy, arm * uz
        add_outer(out, shift, p * along_g, 0)
        add_outer(out, turn, p * along_t, 0)
    for a in range(12):
        for b in range(12):
            out[a, b] *= all_weight / max(taken, 1.0)


def row_excess(points: PointStates, solid: Solid, cov: FloatArray, stride: int) -> FloatArray:
    """(12, 12) noise part of the normal equations; a smooth sum, taken over every ``stride``-th point."""
    excess = np.zeros((12, 12))
    _compiled_excess()(points, solid, cov, stride, excess)
    return excess


@lru_cache
def _compiled_excess() -> Callable[..., None]:
    """:func:`_row_excess` for arrays in C order."""
    return compiled_for(_row_excess, PointStates.empty(0), Solid.empty(), np.zeros((0, 3, 3)), 1, np.zeros((12, 12)))


@kernel()
def _clear_counts(xyz: Any, solid: Any, points: Any, scale: Any, enough: Any) -> Any:
    """See :func:`clear_counts`."""
    axes, opened = solid.legs.directions, solid.opened
    sds, weights, legs = points.sds, points.weights, points.legs
    counts = np.zeros(4)
    lacking = 0
    for k in range(4):
        lacking += opened[k]
    for i in range(xyz.shape[0]):
        if lacking == 0:
            break
        if weights[i] <= 0.5:
            continue
        x, y, z = to_body(xyz[i, 0], xyz[i, 1], xyz[i, 2], solid.centre, solid.rotation)
        highest = second = -1e300
        for k in range(4):
            if opened[k]:
                lean = x * axes[k, 0] + y * axes[k, 1] + z * axes[k, 2]
                if lean > highest:
                    highest, second = lean, highest
                elif lean > second:
                    second = lean
        if highest - second > 4.0 * scale * sds[i]:
            counts[legs[i]] += 1.0
            lacking -= enough <= counts[legs[i]] < enough + 1.0
    return counts


@lru_cache
def _compiled_counts() -> Callable[..., FloatArray]:
    """:func:`_clear_counts` for arrays in C order."""
    return compiled_for(_clear_counts, np.zeros((0, 3)), Solid.empty(), PointStates.empty(0), 1.0, 1.0)


def clear_counts(xyz: FloatArray, solid: Solid, points: PointStates, scale: float, enough: float) -> FloatArray:
    """(4,) number of points that belong to each leg beyond doubt: well used and far from the creases with other opened legs. Ends where
    all opened legs have ``enough``."""
    return _compiled_counts()(xyz, solid, points, scale, enough)
