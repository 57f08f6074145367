"""How often Python looks for objects that are dead but hold each other: seldom in processes of one's own, which make few and end soon."""

from __future__ import annotations

import atexit
import gc

BETWEEN_LOOKS = (20_000, 20, 20)
"""Containers made and not freed before a look at the youngest ones, and looks before one at the older and at the oldest ones. By default
700, 10 and 10, with which 270 000 objects of numba, SciPy and LLVM are gone through again and again while they are loaded."""


def look_seldom() -> None:
    """Have this process look for dead objects seldom, and not once more when it ends: the system takes its memory as a whole."""
    gc.set_threshold(*BETWEEN_LOOKS)
    # Python would go through all objects, and take machine code apart loop by loop
    atexit.register(gc.freeze)
