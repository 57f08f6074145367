"""How often Python's garbage collector runs: seldom in processes of one's own, which make few cycles of objects and end soon."""

from __future__ import annotations

import atexit
import gc

THRESHOLDS = (20_000, 20, 20)
"""Containers made and not freed before a collection of the youngest ones, and collections before one of the older and of the oldest ones.
Those of Python 3.11 are 700, 10 and 10, with which 270 000 objects of numba, SciPy and LLVM are gone through again and again while they are
loaded."""


def collect_seldom() -> None:
    """Have this process collect garbage seldom, and not once more when it ends: the system takes its memory as a whole.

    Files must be closed by those who opened them: one that is still open in a cycle at the end is not flushed any more.
    """
    gc.set_threshold(*THRESHOLDS)
    # Python would go through all objects, and take machine code apart loop by loop
    atexit.register(gc.freeze)
