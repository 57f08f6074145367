"""The record of performance: figures are kept, and a slowdown is named."""

from __future__ import annotations

import re
from pathlib import Path

from tetratrack.benchmarks.performance.record import Figures, add_to_record, comparison, read_record


def test_figures_are_kept_and_held_against_the_last_of_their_case(tmp_path: Path) -> None:
    record = tmp_path / "record.jsonl"
    assert add_to_record("whole_run", "uav", {"run / floor": 4.0}, record) == []
    assert add_to_record("whole_run", "quay", {"run / floor": 9.0}, record) == []
    (told,) = add_to_record("whole_run", "uav", {"run / floor": 4.6}, record)
    assert re.fullmatch(r"uav, run / floor: 4\.60 against 4\.00 \([0-9a-f]+\+?, \d{4}-\d\d-\d\d\): \+15%, SLOWER", told)
    assert [(figures.case, figures.ratios["run / floor"]) for figures in read_record(record)] == [("uav", 4.0), ("quay", 9.0), ("uav", 4.6)]


def test_what_a_quiet_machine_repeats_is_no_slowdown() -> None:
    before, now = (Figures("2026-11-28", "abc", "whole_run", "uav", {"run / floor": value}) for value in (4.0, 4.3))
    assert comparison(before, now) == ["uav, run / floor: 4.30 against 4.00 (abc, 2026-11-28): +7%, as before"]
