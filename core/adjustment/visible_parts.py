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
    beyond = axial - length
    near = beside & (np.abs(beyond) < (1 - TIP_RATIO) * length + 3 * noise)
    if len(problem.given):
        near &= problem.given[:, None] == np.arange(4)
    counts = near.sum(axis=0).tolist()
    shifts: list[float] = []
    for k, count in enumerate(counts):
        if count < 2 * MIN_POINTS:
            continue
        lengths = beyond[near[:, k], k]
        middle = _median(lengths)
        discs[k] = False
        if MAD_TO_SD * _median(np.abs(lengths - middle)) < 1.5 * noise:
            shifts = shifts or np.minimum(SURELY * _sds_along_legs(problem, state, equations), MOST_SHIFT * problem.unit.height).tolist()
            off = SURELY * math.hypot(tolerance, 1.5 * noise / math.sqrt(count))
            discs[k] = abs(middle) < math.hypot(off, shifts[k])
    return discs


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
