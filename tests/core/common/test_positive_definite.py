"""Small positive definite systems."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.common.positive_definite import (
    factorise,
    inverse_diagonal,
    inverse_factor,
    largest_sd,
    solve_factorised,
    substitute_back,
    whiten_columns,
)


@pytest.mark.parametrize("size", [1, 3, 5, 6])
def test_solutions_are_those_of_lapack(size: int) -> None:
    rng = np.random.default_rng(size)
    for _ in range(20):
        root = rng.normal(size=(size, size + 2))
        matrix, right = root @ root.T, rng.normal(size=size)
        factor, solution = np.tril(matrix), right.copy()
        factorise(factor)
        solve_factorised(factor, solution)
        np.testing.assert_allclose(factor, np.linalg.cholesky(matrix), rtol=1e-9, atol=1e-12)
        np.testing.assert_allclose(solution, np.linalg.solve(matrix, right), rtol=1e-7)


def test_halves_of_a_solution_are_those_of_the_factor() -> None:
    rng = np.random.default_rng(3)
    root = rng.normal(size=(7, 9))
    factor, right = np.tril(root @ root.T), rng.normal(size=(7, 4))
    factorise(factor)
    whitened, back = right.copy(), right[:, 0].copy()
    whiten_columns(factor, whitened)
    substitute_back(factor, back)
    np.testing.assert_allclose(factor @ whitened, right, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(factor.T @ back, right[:, 0], rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(inverse_diagonal(factor), np.diag(np.linalg.inv(root @ root.T)), rtol=1e-9)


def test_the_worst_direction_of_a_covariance() -> None:
    along = np.array([0.6, 0.8])
    assert largest_sd(0.01 * np.eye(2) + 0.08 * np.outer(along, along)) == pytest.approx(0.3)
    # round-off makes what is known without error a little negative
    assert largest_sd(-1e-20 * np.eye(3)) == 0.0


def test_only_the_lower_triangle_is_read() -> None:
    matrix = np.array([[4.0, np.nan], [2.0, 3.0]])
    solution = np.array([8.0, 8.0])
    factorise(matrix)
    solve_factorised(matrix, solution)
    np.testing.assert_allclose(solution, [1.0, 2.0], rtol=1e-15)


def test_what_is_not_positive_definite_is_not_finite() -> None:
    matrix = np.array([[1.0, 0.0], [2.0, 1.0]])
    solution = np.ones(2)
    factorise(matrix)
    solve_factorised(matrix, solution)
    assert not np.isfinite(solution).all()


def test_the_inverse_of_a_factor_is_that_of_lapack() -> None:
    root = np.random.default_rng(5).normal(size=(30, 40))
    factor, found = np.tril(root @ root.T), np.zeros((30, 30))
    factorise(factor)
    inverse_factor(factor, found)
    np.testing.assert_allclose(found.T @ found, np.linalg.inv(root @ root.T), rtol=1e-8, atol=1e-12)
