"""Sums of the normal equations over points, for compiled loops: below the diagonal first, mirrored at the end."""

from __future__ import annotations

from typing import Any

from numba import njit

from ..common.kernels import kernel
from .condition_records import INLINED, SCORE, SINGLE, WEIGHT


@njit(**INLINED)
def add_outer(matrix, row, factor, part):  # type: ignore[no-untyped-def]
    """Add ``factor`` times the outer product of a row of one part; of an end disc's unknown only what lies below the diagonal."""
    for a in range(8):
        p = factor * row[a]
        for b in range(8):
            matrix[a, b] += p * row[b]
    add_disc(matrix, row, factor, part)


@njit(**INLINED)
def add_disc(matrix, row, factor, part):  # type: ignore[no-untyped-def]
    """Of an outer product only what an end disc's own unknown has in it, below the diagonal."""
    if part >= 4:
        p = factor * row[part + 4]
        matrix[part + 4, part + 4] += p * row[part + 4]
        for b in range(8):
            matrix[part + 4, b] += p * row[b]


@kernel()
def add_products(block: Any, count: Any, weight: Any, scaled: Any, matrix: Any) -> None:
    """Add the outer products of the rows of ``count`` columns, each times its value in row ``weight``, below the diagonal of a matrix.

    Along the points instead of point by point: vector registers then need no sum across them before the end.
    """
    for a in range(8):
        for i in range(count):
            scaled[i] = block[weight, i] * block[a, i]
        for b in range(a + 1):
            total = 0.0
            for i in range(count):
                total += scaled[i] * block[b, i]
            matrix[a, b] += total


@njit(**INLINED)
def add_products_of_scores(equations, mean_score):  # type: ignore[no-untyped-def]
    """Add the outer product of the score of a point that several parts share."""
    for a in range(12):
        for b in range(a + 1):
            product = mean_score[a] * mean_score[b]
            equations.shared[a, b] += product
            equations.shared_scores[a, b] += product


@njit(**INLINED)
def accumulate(equations, work, columns, final):  # type: ignore[no-untyped-def]
    """Add the first ``columns`` columns of the block to the equations, below the diagonal."""
    add_products(work.block, columns, WEIGHT, work.scaled, equations.normal)
    for a in range(8):
        total = 0.0
        for i in range(columns):
            total += work.block[SCORE, i] * work.block[a, i]
        equations.rhs[a] -= total
    if final:
        add_products(work.block, columns, SINGLE, work.scaled, equations.plain)


@njit(**INLINED)
def empty_equations(equations, final):  # type: ignore[no-untyped-def]
    """Set to zero what is summed; what the covariance needs in a final linearisation alone."""
    equations.normal[:, :] = 0.0
    equations.rhs[:] = 0.0
    if final:
        equations.plain[:, :] = 0.0
        equations.shared[:, :] = 0.0
        equations.shared_scores[:, :] = 0.0


@njit(**INLINED)
def mirror_equations(equations, final):  # type: ignore[no-untyped-def]
    """Fill the half above the diagonal."""
    for a in range(12):
        for b in range(a):
            equations.normal[b, a] = equations.normal[a, b]
            if final:
                equations.plain[b, a] = equations.plain[a, b]
                equations.shared[b, a] = equations.shared[a, b]
                equations.shared_scores[b, a] = equations.shared_scores[a, b]
