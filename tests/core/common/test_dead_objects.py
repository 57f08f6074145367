"""Processes that work and end look seldom for dead objects, and not when they end."""

from __future__ import annotations

import subprocess
import sys

import pytest
from tetratrack.core.common.dead_objects import BETWEEN_LOOKS

CYCLE = """
import gc
from tetratrack.core.common.dead_objects import look_seldom

class Ring:
    def __del__(self):
        print("taken apart")

if {seldom}:
    look_seldom()
print(gc.get_threshold())
ring = Ring()
ring.itself = ring
del ring
"""


@pytest.mark.parametrize("seldom", [True, False])
def test_a_process_that_ends_takes_no_dead_objects_apart(seldom: bool) -> None:
    told = subprocess.run([sys.executable, "-c", CYCLE.format(seldom=seldom)], capture_output=True, encoding="utf-8", check=True).stdout
    assert (f"{BETWEEN_LOOKS}\n" in told) == seldom
    assert ("taken apart" in told) == (not seldom)
