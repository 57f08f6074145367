"""Factor of blocks that touch their neighbours alone: what it gives is what the whole matrix gives."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.sparse import csc_array
from tetratrack.core.common.block_tridiagonal import BlockTridiagonal


@pytest.mark.parametrize("sizes", [(3, 3, 3, 3), (2, 5, 1, 4, 3), (2, 0, 3, 1), (0, 2, 0), (4,)])
def test_solution_determinant_and_blocks_of_the_inverse(sizes: tuple[int, ...]) -> None:
    rng = np.random.default_rng(len(sizes))
    starts = np.concatenate([[0], np.cumsum(sizes)])
    block = np.repeat(np.arange(len(sizes)), sizes)
    root = rng.normal(size=(starts[-1], starts[-1])) * ((block[:, None] == block) | (block[:, None] == block + 1))
    matrix = root @ root.T + np.eye(len(root))
    found = BlockTridiagonal(csc_array(matrix), starts)
    right, whole = rng.normal(size=len(root)), np.linalg.inv(matrix)
    np.testing.assert_allclose(found.solve(right), whole @ right, rtol=1e-9, atol=1e-12)
    assert found.log_determinant() == pytest.approx(np.linalg.slogdet(matrix)[1])
    seen = []
    for k, part in found.inverse_blocks():
        own = slice(starts[k], starts[k + 2])
        np.testing.assert_allclose(part, whole[own, own], rtol=1e-9, atol=1e-12)
        seen.append(k)
    assert seen == list(range(len(sizes) - 1))[::-1]


def test_a_matrix_that_is_not_positive_definite_is_refused() -> None:
    with pytest.raises(np.linalg.LinAlgError):
        BlockTridiagonal(csc_array(-np.eye(4)), [0, 2, 4])
