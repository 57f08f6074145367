"""Small positive definite matrices: systems in compiled loops, and what a covariance leaves open.

numba's `np.linalg.solve` calls LAPACK, which costs more than the arithmetic where there are five or six unknowns, and its texts of
errors take a loop seconds to compile.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from .arrays import FloatArray
from .kernels import kernel


@kernel(makes_arrays=False)
def factorise(matrix: Any) -> None:
    """Cholesky factor of a symmetric, positive definite (n, n) matrix, in place of its lower triangle, which alone is read.

    A matrix that is not positive definite gives what is not finite (Golub and Van Loan, 2013, Matrix Computations, 4.2).
    """
    for a in range(matrix.shape[0]):
        for b in range(a + 1):
            total = matrix[a, b]
            for k in range(b):
                total -= matrix[a, k] * matrix[b, k]
            matrix[a, b] = math.sqrt(total) if a == b else total / matrix[b, b]


@kernel(makes_arrays=False)
def solve_factorised(factor: Any, right: Any) -> None:
    """Solution for a (n,) right-hand side, in its place, by what :func:`factorise` left."""
    for a in range(factor.shape[0]):
        for k in range(a):
            right[a] -= factor[a, k] * right[k]
        right[a] /= factor[a, a]
    substitute_back(factor, right)


@kernel(makes_arrays=False)
def substitute_back(factor: Any, right: Any) -> None:
    """A (n,) right-hand side times the inverse of the factor's transpose, in its place: the second half of a solution."""
    n = factor.shape[0]
    for a in range(n - 1, -1, -1):
        for k in range(a + 1, n):
            right[a] -= factor[k, a] * right[k]
        right[a] /= factor[a, a]


@kernel(makes_arrays=False)
def whiten_columns(factor: Any, right: Any) -> None:
    """(n, q) right-hand sides times the inverse of the factor, in their place: the first half of a solution, row by row as they lie."""
    for a in range(factor.shape[0]):
        for k in range(a):
            for c in range(right.shape[1]):
                right[a, c] -= factor[a, k] * right[k, c]
        for c in range(right.shape[1]):
            right[a, c] /= factor[a, a]


@kernel(makes_arrays=False)
def inverse_factor(factor: Any, rows: Any) -> None:
    """Inverse of the factor into the lower triangle of ``rows`` (n, n), which holds zeros, by what :func:`factorise` left.

    Row by row, which lie as they are read.
    """
    for a in range(factor.shape[0]):
        rows[a, a] = 1.0
        for k in range(a):
            for c in range(k + 1):
                rows[a, c] -= factor[a, k] * rows[k, c]
        for c in range(a + 1):
            rows[a, c] /= factor[a, a]


@kernel()
def inverse_diagonal(factor: Any) -> Any:
    """(n,) diagonal of the inverse of the matrix, by what :func:`factorise` left."""
    n = factor.shape[0]
    rows, diagonal = np.zeros((n, n)), np.zeros(n)
    inverse_factor(factor, rows)
    for a in range(n):
        for c in range(a + 1):
            diagonal[c] += rows[a, c] * rows[a, c]
    return diagonal


def largest_sd(covariance: FloatArray) -> float:
    """Standard deviation in the worst direction of a (n, n) covariance, in the unit of its unknowns."""
    return math.sqrt(max(float(np.linalg.eigvalsh(covariance)[-1]), 0.0))
