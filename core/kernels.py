"""How the loops over points are compiled."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar, cast

from numba import njit

Function = TypeVar("Function", bound=Callable[..., object])


def kernel(*, parallel: bool = False) -> Callable[[Function], Function]:
    """Decorator of a compiled loop, kept on disk between runs.

    Sums may be taken in another order, so that they run in vector registers; what is not finite stays so. ``parallel`` loops must
    give every pass of their ``prange`` its own output.
    """
    compiled = njit(cache=True, error_model="numpy", fastmath={"contract", "reassoc", "arcp", "nsz"}, parallel=parallel)
    return cast(Callable[[Function], Function], compiled)
