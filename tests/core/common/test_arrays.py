"""Arrays: points in a box, and the half of a symmetric matrix."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.common.arrays import in_box, upper_triangle


def test_points_in_a_box() -> None:
    points = np.array([[0.0, 0.0, 0.0], [1.0, 2.0, 3.0], [1.0, 2.0, 3.1], [-0.1, 1.0, 1.0], [0.5, np.nan, 1.0]])
    assert in_box(points, (0.0, 0.0, 0.0), np.array([1.0, 2.0, 3.0])).tolist() == [True, True, False, False, False]


def test_the_upper_half_of_a_matrix_is_laid_out_once() -> None:
    rows, columns = upper_triangle(5)
    assert np.array_equal(np.array([rows, columns]), np.triu_indices(5))
    assert upper_triangle(5)[0] is rows
    with pytest.raises(ValueError, match="read-only"):
        rows[0] = 1
