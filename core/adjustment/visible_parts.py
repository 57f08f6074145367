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
    axial = body @ problem.legs.directions.T
    beside = np.einsum("ij,ij->i", body, body)[:, None] - axial**2 < rim**2
    discs = state.discs.copy()
    shifts = np.minimum(SURELY * _sds_along_legs(problem, state, equations), MOST_SHIFT * problem.unit.height)
    for k in range(4):
        beyond = axial[:, k] - length
        near = beside[:, k] & (np.abs(beyond) < (1 - TIP_RATIO) * length + 3 * noise)
        if len(problem.given):
            near &= problem.given == k
        if near.sum() < 2 * MIN_POINTS:
            continue
        middle = float(np.median(beyond[near]))
        spread = MAD_TO_SD * float(np.median(np.abs(beyond[near] - middle)))
        off = SURELY * math.hypot(tolerance, 1.5 * noise / math.sqrt(near.sum()))
        discs[k] = spread < 1.5 * noise and abs(middle) < math.hypot(off, shifts[k])
    return discs


def _sds_along_legs(problem: Problem, state: UnitState, equations: NormalEquations) -> FloatArray:
    """(4,) standard deviation of the unit's place along each leg, metres."""
    chosen = np.flatnonzero(problem.free(state))
    scaling, weights = problem.prior.scaling[chosen], problem.prior.weights[chosen]
    normal = equations.normal[np.ix_(chosen, chosen)] * np.outer(scaling, scaling)
    normal[np.diag_indices(len(chosen))] += weights * scaling**2 + 1 / DETERMINED**2
    covariance = np.linalg.inv(normal)[:3, :3] * np.outer(scaling[:3], scaling[:3])
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
