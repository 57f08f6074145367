"""Which end discs and legs the points show while a unit is adjusted."""

from __future__ import annotations

import math

import numpy as np

from ..common.arrays import BoolArray, FloatArray
from ..common.robust import MAD_TO_SD
from ..model.tetrapod import TIP_RATIO
from .adjustment_records import MIN_POINTS
from .adjustment_state import Problem, UnitState
from .condition_records import NormalEquations, PointStates
from .gauss_newton_step import DETERMINED
from .noise_along_surface import clear_counts

SURELY = 4.0
"""Standard deviations from the nominal length within which an end disc is in place."""
MOST_SHIFT = 0.04
"""Share of the height by which at most an end disc may seem shifted because the unit's place along the leg is poorly known: a broken leg is
shorter by more."""


def discs_shown(problem: Problem, state: UnitState, points: PointStates, scale: float, equations: NormalEquations) -> BoolArray:
    """(4,) legs at whose end the points show a plane at the nominal length: many, thin, in place.

    Without discs little but the taper says where along its legs a unit lies. What its normal equations leave open there is no evidence
    against a disc.
    """
    body = (problem.points - state.centre) @ state.rotation
    length, tolerance = problem.prior.leg_length, problem.prior.sds[8]
    noise = scale * float(np.mean(points.sds[np.isfinite(points.residuals)]))
    rim = max(state.shape[0] - state.shape[1] * length - problem.edge, 0.0)
    discs = state.discs.copy()
    beyond, near = beyond_ends(body, problem.legs.directions, length, rim, noise)
    if len(problem.given):
        near &= problem.given[:, None] == np.arange(4)
    counts = near.sum(axis=0).tolist()
    shifts: list[float] = []
    for k, count in enumerate(counts):
        if count < 2 * MIN_POINTS:
            continue
        middle = plane_beyond(beyond[near[:, k], k], noise)
        discs[k] = False
        if middle is not None:
            shifts = shifts or _sds_along_legs(problem, state, equations).tolist()
            discs[k] = abs(middle) < most_beyond(problem.unit.height, tolerance, shifts[k], noise / math.sqrt(count))
    return discs


def beyond_ends(body: FloatArray, directions: FloatArray, length: float, rim: float, noise: float) -> tuple[FloatArray, BoolArray]:
    """(n, k) how far (n, 3) points (body frame) lie beyond the ends of legs with (k, 3) ``directions``, and whether they may lie on these.

    They do within ``rim`` of the axis and no farther from the end than tips are rounded; metres.
    """
    axial = body @ directions.T
    beside = np.einsum("ij,ij->i", body, body)[:, None] - axial**2 < rim**2
    beyond = axial - length
    return beyond, beside & (np.abs(beyond) < farthest_from_end(length, noise))


def farthest_from_end(length: float, noise: float) -> float:
    """How far from the end of a leg of a length points of its end disc may lie, metres: tips are rounded."""
    return (1 - TIP_RATIO) * length + 3 * noise


def plane_beyond(lengths: FloatArray, noise: float) -> float | None:
    """Where points that lie (n,) ``lengths`` beyond the end of a leg have a plane across it; None where they are too few or too thick."""
    if len(lengths) < 2 * MIN_POINTS:
        return None
    middle = _median(lengths)
    return middle if MAD_TO_SD * _median(np.abs(lengths - middle)) < 1.5 * noise else None


def most_beyond(height: float, length_sd: float, shift_sd: float, mean_sd: float) -> float:
    """How far from its nominal place an end disc may seem to lie, metres, and still be in place.

    Parameters
    ----------
    height
        Of the unit.
    length_sd, shift_sd, mean_sd
        Standard deviations of the leg's length, of the unit's place along it, and of the mean of the points but for their roughness.
    """
    return math.hypot(SURELY * math.hypot(length_sd, 1.5 * mean_sd), min(SURELY * shift_sd, MOST_SHIFT * height))


def _median(values: FloatArray) -> float:
    """Median of finite values: of so few numpy's own takes five times as long."""
    order = np.sort(values)
    return 0.5 * float(order[(len(order) - 1) // 2] + order[len(order) // 2])


def _sds_along_legs(problem: Problem, state: UnitState, equations: NormalEquations) -> FloatArray:
    """(4,) standard deviation of the unit's place along each leg, metres."""
    chosen = np.flatnonzero(problem.free(state))
    scaling, weights = problem.prior.scaling[chosen], problem.prior.weights[chosen]
    scalings = scaling[:, None] * scaling
    normal = equations.normal[chosen[:, None], chosen] * scalings
    normal.ravel()[:: len(chosen) + 1] += weights * scaling**2 + 1 / DETERMINED**2
    covariance = np.linalg.inv(normal)[:3, :3] * scalings[:3, :3]
    axes = problem.legs.directions
    return np.asarray(np.sqrt(np.einsum("ki,ij,kj->k", axes, covariance, axes)))


def legs_shown(problem: Problem, state: UnitState, points: PointStates, scale: float) -> BoolArray:
    """(4,) legs that own points beyond doubt: what a crease shares with the others says nothing about where they are.

    All that are open where there is none, or where legs are given.
    """
    if len(problem.given):
        return state.opened
    enough = max(float(MIN_POINTS), 0.01 * np.count_nonzero(points.weights))
    keep = state.opened & (clear_counts(problem.points, problem.solid(state), points, scale, enough) >= enough)
    return keep if keep.any() else state.opened
