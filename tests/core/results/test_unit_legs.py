"""Legs of a unit from rows of results that state them leg by leg, as a whole, or not at all."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from tetratrack.core.model.outline import PlacedShape
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.results.unit_legs import Leg, end_of_leg, legs_of_pair, legs_of_row, most_broken, way_of_leg

UNIT = UnitType.tetrapod(2.0)


def row(*states: str, **told: Any) -> dict[str, Any]:
    return {f"leg{k + 1}": state for k, state in enumerate(states)} | told


def test_two_broken_legs_are_told_apart_and_the_unseen_one_has_nothing() -> None:
    legs = legs_of_row(
        row("broken", "unseen", "whole", "broken", leg1_missing=0.2, leg4_missing=0.5, leg1_probability=0.97, leg3_probability=0.01,
            leg4_probability=0.6, leg_missing=0.5, leg_probability=0.97)
    )  # fmt: skip
    assert [(leg.missing, leg.probability) for leg in legs] == [(0.2, 0.97), (None, None), (None, 0.01), (0.5, 0.6)]
    assert most_broken(legs) == Leg(number=4, state="broken", missing=0.5, probability=0.6)


def test_earlier_versions_state_one_length_which_is_that_of_the_only_broken_leg() -> None:
    told = {"leg_missing": 0.4, "leg_probability": 0.9}
    assert most_broken(legs_of_row(row("whole", "broken", "unseen", "whole", **told))) == Leg(
        number=2, state="broken", missing=0.4, probability=0.9
    )
    both = legs_of_row(row("broken", "broken", "unseen", "whole", **told))
    assert [leg.missing for leg in both] == [None] * 4, "nobody knows whose length it is"
    assert legs_of_row(row("whole", "whole", "whole", "unseen", **told))[0].probability is None
    assert legs_of_row({"unit_id": "U1"}) == legs_of_row(row("", "", "", "")) == legs_of_row(None) == ()
    assert most_broken(()) is None


def test_a_leg_does_not_heal_but_a_whole_one_may_break_unseen() -> None:
    early = row("broken", "whole", "whole", "broken", leg1_missing=0.3, leg1_probability=0.9, leg4_missing=0.1, leg4_probability=0.7)
    late = row("unseen", "unseen", "broken", "whole", leg3_missing=0.2, leg3_probability=0.8, leg4_probability=0.2)
    legs = legs_of_pair(early, late)
    assert [leg.state for leg in legs] == ["broken", "unseen", "broken", "whole"]
    assert [leg.missing for leg in legs] == [0.3, None, 0.2, None]
    hidden = legs_of_pair(early, {"status": "unseen", "leg1": None})
    assert [leg.state for leg in hidden] == ["broken", "unseen", "unseen", "broken"]
    assert legs_of_pair(None, late) == legs_of_row(late)
    assert legs_of_pair(None, None) == ()


def test_where_a_broken_leg_ends_and_whither_it_points() -> None:
    turn = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])  # what was up points north
    shape = PlacedShape(
        centre=np.array([10.0, 20.0, 1.0]), rotation=turn, radius=UNIT.radius, gradient=UNIT.gradient, leg_length=UNIT.leg_length,
        legs=np.array([[0.0, 0.0, 1.0], *UNIT.leg_directions[1:]]),
    )  # fmt: skip
    leg = Leg(number=1, state="broken", missing=0.25)
    assert end_of_leg(leg, shape) == pytest.approx([10.0, 20.0 + UNIT.leg_length - 0.25, 1.0])
    assert end_of_leg(Leg(number=1, state="whole"), shape)[1] == pytest.approx(20.0 + UNIT.leg_length)
    assert way_of_leg(leg, shape) == (0, 0)
