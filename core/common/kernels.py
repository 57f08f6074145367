"""How the loops over points are compiled.

Arrays in a compiled loop are made from tuples, ``np.array((x, y, z))``, never from lists: numba (0.68.1) rewrites lists in different
branches under the same names, and then fails to compile, or not, by what else the process has compiled before.

Arrays are assigned to parts of arrays element by element, and small systems are solved as in :mod:`.positive_definite`: an assignment of
arrays, like `np.linalg.solve`, brings along the texts of numba's errors of shape, which take two to four seconds to compile.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from itertools import pairwise
from typing import Any, TypeVar, cast

import numba
from numba.core.dispatcher import Dispatcher

from .compiled_code import choose_folder, keep_compiled

Function = TypeVar("Function", bound=Callable[..., object])
Item = TypeVar("Item")
Result = TypeVar("Result")

COMPILED: dict[str, Any] = {"error_model": "numpy", "fastmath": {"contract", "reassoc", "arcp", "nsz"}}
"""How all kernels are compiled: sums may be taken in another order, so that they run in vector registers; what is not finite stays
so."""

PARTS = 4
"""Parts of a loop for each thread: some take longer than others."""

choose_folder()


def kernel(*, makes_arrays: bool = True, releases: bool = False) -> Callable[[Function], Function]:
    """Decorator of a loop compiled as ``COMPILED`` says.

    Parameters
    ----------
    makes_arrays
        False for a loop that takes named tuples of arrays: numba counts a reference wherever an array is taken out of a tuple, which can
        take longer than the work itself. Without counting a loop can make no arrays; they are passed to it.
    releases
        Other threads of Python go on meanwhile.
    """
    options = COMPILED if makes_arrays else COMPILED | {"_nrt": False}
    compiled = numba.njit(nogil=releases, **options)
    return cast(Callable[[Function], Function], lambda function: keep_compiled(compiled(function)))


def compiled_for(loop: Function, *examples: object) -> Function:
    """A kernel as compiled for arguments of the types of ``examples``, without a look at the types at every call.

    numba goes through all arrays of nested named tuples to find their types, call by call, which takes longer than a short loop (8 us for
    thirty arrays). Nothing is checked here: later arguments must be of the same types, arrays of the same dtype, dimensions and order,
    and aligned. Numbers are converted.
    """
    if not isinstance(loop, Dispatcher):
        # NUMBA_DISABLE_JIT
        return loop
    # numba states no types
    typeof: Any = numba.typeof
    return cast(Function, loop.compile(tuple(typeof(example) for example in examples)))


@contextmanager
def threads_of_kernels(count: int) -> Iterator[None]:
    """Let :func:`in_parts` and :func:`side_by_side` use at most ``count`` threads meanwhile."""
    before = numba.get_num_threads()
    numba.set_num_threads(min(count, before))
    try:
        yield
    finally:
        numba.set_num_threads(before)


def in_parts(loop: Callable[[int, int], None], count: int) -> None:
    """Call a kernel for parts of its passes, ``loop(first, last)``, side by side on as many threads as kernels may use.

    The kernel, whose other values are bound by name, lets other threads go on (``releases``), and every pass has its own output. numba's
    own way, ``prange``, takes a third more time to compile, and takes ``reach *= 2.0`` in a pass for a product over all passes.
    """
    threads = numba.get_num_threads()
    if threads == 1 or count < 2:
        loop(0, count)
        return
    parts = min(count, PARTS * threads)
    edges = [count * k // parts for k in range(parts + 1)]
    for _ in side_by_side(lambda part: loop(*part), pairwise(edges)):
        pass


def side_by_side(work: Callable[[Item], Result], items: Iterable[Item]) -> Iterator[Result]:
    """What ``work`` makes of each item, in the order of the items, on as many threads as kernels may use.

    Items are drawn by the caller's thread, at most one more than there are threads ahead of the results. It pays where most of the work
    is in large arrays, linear algebra and kernels that let other threads of Python go on (``releases``).
    """
    threads = numba.get_num_threads()
    if threads == 1:
        yield from map(work, items)
        return
    waiting: deque[Future[Result]] = deque()
    with ThreadPoolExecutor(threads) as pool:
        try:
            for item in items:
                waiting.append(pool.submit(work, item))
                if len(waiting) > threads:
                    yield waiting.popleft().result()
            while waiting:
                yield waiting.popleft().result()
        finally:
            for future in waiting:
                future.cancel()
