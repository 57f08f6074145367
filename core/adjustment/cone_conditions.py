"""Conditions of points on cones and end discs, linearised at the adjusted observations.

What one pass over the points of a unit gives the adjustment (:mod:`.gauss_helmert`): which part of which leg each point belongs to, how far
it lies from it, and what its condition adds to the normal equations. Points are read in blocks; those that belong to one leg beyond doubt
(:mod:`.clear_points`) are linearised together, the others (:mod:`.contested_points`) one by one.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..common.kernels import compiled_for, kernel
from .clear_points import clear_points, keep_clear_point
from .condition_records import (
    BLOCK,
    BLOCK_COLUMNS,
    BLOCK_ROWS,
    CLEAR,
    LEG,
    Cone,
    Noise,
    NormalEquations,
    PointStates,
    Solid,
    Sums,
    Task,
    Weighting,
    Work,
    X,
    Y,
    Z,
)  # fmt: skip
from .contested_points import blurred_points, contested_point, turned_covariance
from .normal_sums import accumulate, empty_equations, mirror_equations


@kernel(makes_arrays=False)
def _linearise_points(points: Any, cov: Any, given: Any, solid: Any, weighting: Any, equations: Any, states: Any, work: Any) -> None:
    """See :func:`linearise_points`; the sums are left in ``work.sums``."""
    n = points.shape[1]
    r, c = solid.shape[0], solid.shape[1]
    # asked at run time: a loop of its own for points with covariances takes seconds more to compile
    has_cov = cov.shape[0] == n
    has_given = given.shape[0] == n
    scale, final = weighting.scale, weighting.final
    empty_equations(equations, final)
    # a column for every point, and one for each of up to eight parts that may own it; rows a power of two apart would share cache lines
    block = work.block
    # with the shape known, loops along the columns run in vector registers
    if block.shape[0] != BLOCK_ROWS or block.shape[1] != BLOCK_COLUMNS:
        raise ValueError("work arrays of another shape")
    work.sums[:] = 0.0
    cone = Cone(r, c, 1.0 / math.sqrt(1.0 + c * c))
    task = Task(solid, cone, weighting, weighting.correct * weighting.correct, equations, states, work)
    reach = scale
    for first in range(0, n, BLOCK):
        count = min(BLOCK, n - first)
        if has_cov:
            blurred_points(points, first, count, solid, block)
        else:
            if has_given:
                for i in range(count):
                    block[LEG, i] = given[first + i]
            sums = clear_points(points, first, count, has_given, solid, cone, weighting, block)
            for a in range(5):
                work.sums[a] += sums[a]
        columns = count
        for i in range(count):
            j = first + i
            states.parts[j] = 0
            states.sds[j] = 1.0
            states.at_tip[j] = False
            known = given[j] if has_given else -1
            left_out = has_given and known < 0
            place = (block[X, i], block[Y, i], block[Z, i])
            if block[CLEAR, i] > 0.0 or left_out:
                keep_clear_point(task, place, i, j, left_out)
                continue
            states.legs[j] = -1
            states.weights[j] = 0.0
            states.residuals[j] = math.nan
            states.biases[j] = 0.0
            if final:
                for a in range(12):
                    states.rows[j, a] = 0.0
            if has_cov:
                turned_covariance(cov, j, solid.rotation, work.body_cov)
                reach = scale * math.sqrt(work.body_cov[0, 0] + work.body_cov[1, 1] + work.body_cov[2, 2])
            columns = contested_point(task, place, Noise(work.body_cov, has_cov, scale, reach), j, known, columns)
        accumulate(equations, work, columns, final)
    mirror_equations(equations, final)


@lru_cache
def _compiled() -> Callable[..., None]:
    """:func:`_linearise_points` for arrays in C order."""
    examples = (
        np.zeros((3, 0)),
        np.zeros((0, 3, 3)),
        np.zeros(0, dtype=np.int64),
        Solid.empty(),
        Weighting(scale=1.0, correct=0.0, tip=0.0, fade=0.0, edge=0.0, redescend=False, final=False),
        NormalEquations.empty(),
        PointStates.empty(0),
        Work.empty(),
    )
    return compiled_for(_linearise_points, *examples)


def linearise_points(
    points: FloatArray,
    cov: FloatArray,
    given: IntArray,
    solid: Solid,
    weighting: Weighting,
    equations: NormalEquations,
    states: PointStates,
    work: Work,
) -> Sums:
    """One linearisation: normal equations, right-hand side and the state of every point.

    Parameters
    ----------
    points
        (3, n) metres. All arrays, those in records too, must be in C order and aligned: that is not checked, since a look at their types
        takes as long as half a hundred points (:func:`.kernels.compiled_for`).
    cov
        (n, 3, 3) their covariances, square metres, or (0, 3, 3) for equal noise.
    given
        (n,) leg 0..3 of each point, -1 to leave it out; (0,) where legs are to be found.
    solid, weighting
        Surface, and how residuals count.
    equations, states
        Are overwritten.
    work
        Work arrays.
    """
    _compiled()(points, cov, given, solid, weighting, equations, states, work)
    return Sums(*work.sums.tolist())
