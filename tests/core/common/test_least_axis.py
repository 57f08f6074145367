"""Axes of scatter against LAPACK."""

from __future__ import annotations

import numpy as np
from tetratrack.core.common.least_axis import least_axis, principal_axes


def axis_of(matrix: np.ndarray) -> np.ndarray:
    return np.array(least_axis(*(float(matrix[i, j]) for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)))))


def test_agrees_with_lapack():
    rng = np.random.default_rng(3)
    for scale in (1e-8, 1.0, 1e6):
        for _ in range(300):
            points = rng.normal(size=(9, 3)) * (1.0, 0.7, 0.1) @ np.linalg.qr(rng.normal(size=(3, 3)))[0]
            matrix = points.T @ points * scale
            axis, wanted = axis_of(matrix), np.linalg.eigh(matrix)[1][:, 0]
            assert abs(axis @ wanted) > 1 - 1e-13
            assert abs(np.linalg.norm(axis) - 1) < 1e-14


def test_degenerate_scatter_has_an_axis():
    for matrix in (np.zeros((3, 3)), np.eye(3), np.diag([1.0, 1.0, 0.0]), np.diag([0.0, 0.0, 2.0]), np.ones((3, 3))):
        axis = axis_of(matrix)
        assert abs(np.linalg.norm(axis) - 1) < 1e-14
        assert np.linalg.norm(matrix @ axis - np.linalg.eigvalsh(matrix)[0] * axis) < 1e-14


def test_all_axes_are_eigenvectors_and_stand_across_each_other():
    rng = np.random.default_rng(5)
    for _ in range(50):
        half = rng.normal(size=(3, 3))
        matrix = half @ half.T
        found = principal_axes(*(float(matrix[i, j]) for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))))
        axes = np.array([axis for _, *axis in found])
        assert np.abs(axes @ axes.T - np.eye(3)).max() < 1e-13
        for value, *axis in found:
            assert np.abs(matrix @ axis - value * np.array(axis)).max() < 1e-12 * np.trace(matrix)
