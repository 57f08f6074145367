"""How the loops over points are compiled."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TypeVar, cast

import numba

Function = TypeVar("Function", bound=Callable[..., object])


def kernel(*, parallel: bool = False) -> Callable[[Function], Function]:
    """Decorator of a compiled loop, kept on disk between runs.

    Sums may be taken in another order, so that they run in vector registers; what is not finite stays so. ``parallel`` loops must
    give every pass of their ``prange`` its own output.
    """
    compiled = numba.njit(cache=True, error_model="numpy", fastmath={"contract", "reassoc", "arcp", "nsz"}, parallel=parallel)
    return cast(Callable[[Function], Function], compiled)


@contextmanager
def threads_of_kernels(count: int) -> Iterator[None]:
    """Let parallel kernels use at most ``count`` threads meanwhile."""
    before = numba.get_num_threads()
    numba.set_num_threads(min(count, before))
    try:
        yield
    finally:
        numba.set_num_threads(before)
