"""Arrows on the report's maps: one factor for all, and the longest no shorter than others."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.report.displacement_arrows import displacement_arrows, nearest_round
from tetratrack.core.results.unit_rows import UnitRow


def moved(name: str, east: float, north: float, *, height: float = 2.3, significant: bool = True) -> UnitRow:
    return UnitRow(
        unit_id=name,
        kind="moved",
        place=np.array([500000.0, 4000000.0, 3.0]),
        coverage=0.5,
        height=height,
        vector=np.array([east, north, 0.01]),
        significant=significant,
    )


def test_the_unit_that_moved_most_has_the_longest_arrow() -> None:
    rows = [moved("a", 0.05, 0.0), moved("b", 0.0, 0.06), moved("c", 0.3, 0.4), moved("d", 0.05, 0.0, significant=False)]
    arrows = displacement_arrows(rows)
    assert arrows.times == 50
    lengths = np.linalg.norm(arrows.shown, axis=1)
    assert lengths.tolist() == pytest.approx([2.5, 3.0, 4 * 2.3])
    assert arrows.cut.tolist() == [False, False, True]
    assert arrows.shown[2] / lengths[2] == pytest.approx([0.6, 0.8])


def test_a_unit_carried_far_keeps_the_length_of_its_way() -> None:
    arrows = displacement_arrows([moved("a", 0.05, 0.0), moved("b", 0.05, 0.0), moved("c", 15.0, 0.0)])
    assert arrows.shown[2].tolist() == [15.0, 0.0]
    assert arrows.cut.tolist() == [False, False, True]


def test_arrows_of_models_suit_their_size() -> None:
    arrows = displacement_arrows([moved("a", 0.014, 0.0, height=0.105), moved("b", 0.0, 0.018, height=0.105)])
    assert arrows.times == 10
    assert np.linalg.norm(arrows.shown, axis=1).max() < 2 * 0.105
    assert not displacement_arrows([]).starts.size
    assert displacement_arrows([moved("a", 0.0, 0.0)]).times == 1


def test_round_numbers_below_one_too() -> None:
    assert [nearest_round(value) for value in (0.11, 0.04, 1.4, 7.5, 55)] == pytest.approx([0.1, 0.05, 1, 10, 50])
