"""Which end discs and legs the points show while a unit is adjusted."""

from __future__ import annotations

import math

import numpy as np

from ..common.arrays import BoolArray
from ..common.robust import MAD_TO_SD
from ..model.tetrapod import TIP_RATIO
from .adjustment_records import MIN_POINTS
from .adjustment_state import Problem, UnitState
from .condition_records import PointStates
from .noise_along_surface import clear_counts


def discs_shown(problem: Problem, state: UnitState, points: PointStates, scale: float) -> BoolArray:
    """(4,) legs at whose end the points show a plane at the nominal length: many, thin, in place."""
    body = (problem.points - state.centre) @ state.rotation
    length, tolerance = problem.prior.leg_length, problem.prior.sds[8]
    noise = scale * float(np.mean(points.sds[np.isfinite(points.residuals)]))
    rim = max(state.shape[0] - state.shape[1] * length - problem.edge, 0.0)
    axial = body @ problem.legs.directions.T
    beside = np.einsum("ij,ij->i", body, body)[:, None] - axial**2 < rim**2
    discs = state.discs.copy()
    for k in range(4):
        beyond = axial[:, k] - length
        near = beside[:, k] & (np.abs(beyond) < (1 - TIP_RATIO) * length + 3 * noise)
        if len(problem.given):
            near &= problem.given == k
        if near.sum() < 2 * MIN_POINTS:
            continue
        middle = float(np.median(beyond[near]))
        spread = MAD_TO_SD * float(np.median(np.abs(beyond[near] - middle)))
        off = 4 * math.hypot(tolerance, 1.5 * noise / math.sqrt(near.sum()))
        discs[k] = spread < 1.5 * noise and abs(middle) < off
    return discs


def legs_shown(problem: Problem, state: UnitState, points: PointStates, scale: float) -> BoolArray:
    """(4,) legs that own points beyond doubt: what a crease shares with the others says nothing about where they are.

    All that are open where there is none, or where legs are given.
    """
    if len(problem.given):
        return state.opened
    enough = max(float(MIN_POINTS), 0.01 * np.count_nonzero(points.weights))
    keep = state.opened & (clear_counts(problem.points, problem.solid(state), points, scale, enough) >= enough)
    return keep if keep.any() else state.opened
