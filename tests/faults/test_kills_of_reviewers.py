"""Kills at random moments of reviewers and of runs that replace the result under them: no acknowledged decision is lost, the result stays
readable, and nothing is left that the next run does not clean."""

from __future__ import annotations

from pathlib import Path

import pytest
from faults.kill_all import kill_reviewers, kill_runs

pytestmark = pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="looks at processes as Linux shows them")
SITUATIONS = pytest.mark.parametrize("replaced", [False, True], ids=["reviewers", "a run replaces the result"])


@SITUATIONS
def test_a_few_kills(tmp_path: Path, replaced: bool) -> None:
    outcome = kill_reviewers(tmp_path, 6, replaced=replaced)
    assert outcome.wrong == []
    assert outcome.decisions > outcome.kills


@pytest.mark.slow
@SITUATIONS
def test_two_hundred_kills(tmp_path: Path, replaced: bool) -> None:
    outcome = kill_reviewers(tmp_path, 200, replaced=replaced)
    assert outcome.wrong == []
    assert outcome.decisions > outcome.kills


def test_a_few_kills_of_runs(tmp_path: Path) -> None:
    assert kill_runs(tmp_path, 2).wrong == []


@pytest.mark.slow
def test_two_hundred_kills_of_runs(tmp_path: Path) -> None:
    outcome = kill_runs(tmp_path, 200)
    assert outcome.wrong == []
    assert min(outcome.alone, outcome.group) > 50
