"""Processes that work and end collect garbage seldom, and not when they end."""

from __future__ import annotations

import subprocess
import sys

import pytest
from tetratrack.core.common.garbage_collection import THRESHOLDS

CYCLE = """
import gc
from tetratrack.core.common.garbage_collection import collect_seldom

class Ring:
    def __del__(self):
        print("taken apart")

if {seldom}:
    collect_seldom()
print(gc.get_threshold())
ring = Ring()
ring.itself = ring
del ring
"""


@pytest.mark.parametrize("seldom", [True, False])
def test_a_process_that_ends_takes_no_garbage_collection_apart(seldom: bool) -> None:
    told = subprocess.run([sys.executable, "-c", CYCLE.format(seldom=seldom)], capture_output=True, encoding="utf-8", check=True).stdout
    assert (f"{THRESHOLDS}\n" in told) == seldom
    assert ("taken apart" in told) == (not seldom)
