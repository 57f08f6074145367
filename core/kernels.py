"""How the loops over points are compiled.

Arrays in a compiled loop are made from tuples, ``np.array((x, y, z))``, never from lists: numba (0.68.1) rewrites lists in different
branches under the same names, and then fails to compile, or not, by what else the process has compiled before.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar, cast

import numba

Function = TypeVar("Function", bound=Callable[..., object])

COMPILED: dict[str, Any] = {"cache": True, "error_model": "numpy", "fastmath": {"contract", "reassoc", "arcp", "nsz"}}
"""How all kernels are compiled: kept on disk between runs, and sums may be taken in another order, so that they run in vector
registers; what is not finite stays so."""


def kernel(*, parallel: bool = False) -> Callable[[Function], Function]:
    """Decorator of a loop compiled as ``COMPILED`` says; ``parallel`` ones must give every pass of their ``prange`` its own output."""
    return cast(Callable[[Function], Function], numba.njit(parallel=parallel, **COMPILED))


@contextmanager
def threads_of_kernels(count: int) -> Iterator[None]:
    """Let parallel kernels use at most ``count`` threads meanwhile."""
    before = numba.get_num_threads()
    numba.set_num_threads(min(count, before))
    try:
        yield
    finally:
        numba.set_num_threads(before)
