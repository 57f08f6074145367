"""Symmetric, positive definite matrices whose blocks touch their neighbours alone: what is asked of them takes time and memory that grow
with the number of blocks.

Of the inverse the blocks that the matrix has itself follow from its factor (Takahashi et al., 1973, 8th PICA Conference;
Erisman and Tinney, 1975, Communications of the ACM 18(3)).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np
from scipy.linalg import solve_triangular
from scipy.sparse import csc_array

from .arrays import FloatArray, IntArray


class BlockTridiagonal:
    """Cholesky factor of a (n, n) matrix.

    Raises
    ------
    numpy.linalg.LinAlgError
        The matrix is not positive definite.
    """

    def __init__(self, matrix: csc_array, starts: Sequence[int] | IntArray) -> None:
        """Of a matrix and the first row of every block, n at last; a block may be empty."""
        self.bounds = list(pairwise(int(start) for start in starts))
        self.diagonal: list[FloatArray] = []
        self.below: list[FloatArray] = []
        for k, (low, high) in enumerate(self.bounds):
            end = self.bounds[k + 1][1] if k + 1 < len(self.bounds) else high
            columns = np.asarray(matrix[:, low:high][low:end].toarray(), dtype=np.float64)
            own = columns[: high - low]
            if k:
                own = own - self.below[-1] @ self.below[-1].T
            self.diagonal.append(np.asarray(np.linalg.cholesky(own), dtype=np.float64))
            if end > high:
                self.below.append(solve_triangular(self.diagonal[-1], columns[high - low :].T, lower=True, check_finite=False).T)
            else:
                self.below.append(np.zeros((0, high - low)))

    def log_determinant(self) -> float:
        """Of the matrix."""
        return 2 * float(sum(np.sum(np.log(np.diag(own))) for own in self.diagonal))

    def solve(self, right: FloatArray) -> FloatArray:
        """(n,) solution for a (n,) right-hand side."""
        found = np.array(right, dtype=np.float64)
        before = found[:0]
        for k, (low, high) in enumerate(self.bounds):
            if k:
                found[low:high] -= self.below[k - 1] @ before
            before = found[low:high] = solve_triangular(self.diagonal[k], found[low:high], lower=True, check_finite=False)
        after = found[:0]
        for (low, high), own, below in zip(reversed(self.bounds), reversed(self.diagonal), reversed(self.below), strict=True):
            right_side = found[low:high] - below.T @ after
            after = found[low:high] = solve_triangular(own, right_side, lower=True, trans=1, check_finite=False)
        return found

    def inverse_blocks(self) -> Iterator[tuple[int, FloatArray]]:
        """Number of a block and the inverse of the matrix for it and the one after it together, from the last such pair to the first."""
        after = self._own_inverse(len(self.bounds) - 1)
        after = after.T @ after
        for k in range(len(self.bounds) - 2, -1, -1):
            root = self._own_inverse(k)
            gain = self.below[k] @ root
            across = -after @ gain
            own = root.T @ root - gain.T @ across
            yield k, np.block([[own, across.T], [across, after]])
            after = own

    def _own_inverse(self, number: int) -> FloatArray:
        """Inverse of a block of the factor's diagonal."""
        own = self.diagonal[number]
        return np.asarray(solve_triangular(own, np.eye(len(own)), lower=True, check_finite=False), dtype=np.float64)
