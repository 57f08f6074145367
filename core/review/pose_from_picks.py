"""A pose from joints that somebody clicked, and its legs numbered as they were before: geometry alone, numpy is all it needs."""

from __future__ import annotations

import math
from itertools import permutations

import numpy as np
from numpy.typing import ArrayLike

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..common.rotations import closest_rotation
from ..model.unit_types import leg_directions
from ..results.schema import FEATURES


def nearest_labels(reference: FloatArray, rotation: FloatArray) -> FloatArray:
    """(3, 3) ``rotation`` with its legs renumbered so that it turns least from ``reference`` (12 rotations of the tetrapod onto itself)."""
    candidates = rotation @ _symmetries()
    traces = np.einsum("kij,ij->k", candidates, reference)
    return np.asarray(candidates[int(np.argmax(traces))])


def pose_from_features(
    picks: ArrayLike, radius: float, gradient: float, reference: FloatArray | None = None
) -> tuple[FloatArray, FloatArray, tuple[str, ...], float]:
    """Pose that brings three (or four) feature points onto picks, whichever of the four they are.

    Parameters
    ----------
    picks
        (3, 3) or (4, 3) joints of three legs as picked, metres.
    radius, gradient
        Shape of the leg cone.
    reference
        (3, 3) earlier rotation, which settles the legs' numbers; None leaves them arbitrary.

    Returns
    -------
    centre, rotation, names, misfit
        (3,), (3, 3), the feature each pick was taken for, and the root mean square distance in metres.

    Raises
    ------
    InputError
        Fewer than three picks, or two of them nearly in the same place.
    """
    points = np.asarray(picks, dtype=np.float64).reshape(-1, 3)
    body = joints_of(radius, gradient)
    gaps = np.linalg.norm(points[:, None] - points[None], axis=2) + np.eye(len(points)) * 1e9
    if len(points) not in (3, 4) or gaps.min() < 0.3 * float(np.linalg.norm(body[0])):
        raise InputError("three different feature points are needed", remedy="Click three joints where three legs meet.")
    best: tuple[float, float, FloatArray, FloatArray, tuple[int, ...]] | None = None
    for chosen in permutations(range(4), len(points)):
        centre, rotation, misfit = _rigid(body[list(chosen)], points)
        turn = 0.0 if reference is None else -float(np.trace(reference.T @ rotation))
        key = (round(misfit, 9), turn)
        if best is None or key < best[:2]:
            best = (*key, centre, rotation, chosen)
    if best is None:
        raise InputError("no pose passes through these points", remedy="Click three joints where three legs meet.")
    return best[2], best[3], tuple(FEATURES[1 + k] for k in best[4]), best[0]


def joints_of(radius: float, gradient: float) -> FloatArray:
    """(4, 3) f123, f124, f134, f234 in the body frame (paper eqs. 10-13, closed form for the tetrahedral opening)."""
    angle = math.acos(1 / 3)
    distance = radius / (math.sin(angle) + gradient * math.cos(angle))
    return np.asarray(-distance * leg_directions("tetrahedral")[[3, 2, 1, 0]])


def _symmetries() -> FloatArray:
    """(12, 3, 3) proper rotations that permute the four legs: the even permutations."""
    found, legs = [], leg_directions("tetrahedral")
    for order in permutations(range(4)):
        turn = 0.75 * legs[list(order)].T @ legs
        if np.linalg.det(turn) > 0:
            found.append(turn)
    return np.array(found)


def _rigid(body: FloatArray, points: FloatArray) -> tuple[FloatArray, FloatArray, float]:
    """Rotation and translation body -> points by least squares (Kabsch, 1976), and the root mean square misfit."""
    middle_body, middle = body.mean(axis=0), points.mean(axis=0)
    rotation, _ = closest_rotation((points - middle).T @ (body - middle_body))
    centre = middle - rotation @ middle_body
    misfit = float(np.sqrt(np.mean(np.sum((points - body @ rotation.T - centre) ** 2, axis=1))))
    return centre, rotation, misfit
