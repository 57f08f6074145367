"""Mutated inputs of every kind: exit code 0 or 2, one sentence each, no traceback, no hang, memory within a GiB."""

from __future__ import annotations

from pathlib import Path

import pytest
from faults.mutate_all import try_all


def _faults(site: Path, number: int) -> list[str]:
    tallies = try_all(site, number)
    assert sum(tally.refused for tally in tallies) > number // 2
    return [fault for tally in tallies for fault in tally.faults]


def test_a_few_mutations_of_every_kind(tmp_path: Path) -> None:
    assert _faults(tmp_path, 34) == []


@pytest.mark.slow
def test_two_thousand_mutations(tmp_path: Path) -> None:
    assert _faults(tmp_path, 2000) == []
