"""A broken leg stays broken, epochs that say little each say enough together, and a contradicted break is none."""

from __future__ import annotations

import math

import numpy as np
import pytest
from tetratrack.core.deformation.legs_over_epochs import legs_over_epochs
from tetratrack.core.segmentation.leg_ends import BROKEN, PRIOR_ODDS, UNSEEN, WHOLE, LegEnds


def ends(evidence: float, missing: float = 0.0) -> LegEnds:
    """One leg, the second, of which an epoch says so much; the others are whole."""
    all_legs = np.array([-8.0, evidence, -8.0, -8.0])
    odds = all_legs + PRIOR_ODDS
    states = np.where(odds > 0, BROKEN, np.where(all_legs < 0, WHOLE, UNSEEN))
    broken = np.where(states == UNSEEN, math.nan, 1 / (1 + np.exp(-odds)))
    return LegEnds(states, np.array([0.0, missing, 0.0, 0.0]), broken, all_legs)


def states(*evidence: float) -> list[int]:
    """State of the leg by epoch."""
    found = legs_over_epochs({k: ends(value, 0.4 if value > 0 else 0.0) for k, value in enumerate(evidence)})
    assert all((np.delete(own.states, 1) == WHOLE).all() for own in found.values())
    return [int(found[k].states[1]) for k in range(len(evidence))]


def test_a_break_is_carried_to_epochs_that_do_not_show_it() -> None:
    found = legs_over_epochs({0: ends(0.0), 2: ends(9.0, 0.4), 5: ends(0.0)})
    assert [int(found[k].states[1]) for k in (0, 2, 5)] == [BROKEN, BROKEN, BROKEN]
    assert [float(found[k].missing[1]) for k in (0, 2, 5)] == [0.4, 0.4, 0.4]
    assert float(found[5].broken[1]) > float(found[0].broken[1]) > 0.5


def test_epochs_that_say_little_each_say_enough_together() -> None:
    assert states(2.5, 0.0) == [UNSEEN, UNSEEN]
    assert states(2.5, 2.5) == [BROKEN, BROKEN]


def test_a_leg_may_break_between_epochs_and_does_not_heal() -> None:
    assert states(-8.0, -8.0, 9.0, 0.0) == [WHOLE, WHOLE, BROKEN, BROKEN]
    assert states(9.0, -9.0) == [WHOLE, WHOLE]
    assert states(9.0, -9.0, 9.0, 9.0)[2:] == [BROKEN, BROKEN]


def test_the_chain_equals_the_sum_over_all_its_ways() -> None:
    from tetratrack.core.deformation.legs_over_epochs import BREAKS_BETWEEN

    told = [1.5, -2.0, 3.0]
    prior = 1 / (1 + math.exp(-PRIOR_ODDS))
    first = [prior, *(BREAKS_BETWEEN * (1 - BREAKS_BETWEEN) ** k * (1 - prior) for k in range(2)), (1 - BREAKS_BETWEEN) ** 2 * (1 - prior)]
    weight = np.array([share * math.exp(sum(told[at:])) for at, share in enumerate(first)])
    expected = [weight[: k + 1].sum() / weight.sum() for k in range(3)]
    found = legs_over_epochs({k: ends(value, 0.4) for k, value in enumerate(told)})
    for k in range(3):
        if found[k].states[1] != UNSEEN:
            assert float(found[k].broken[1]) == pytest.approx(expected[k], rel=1e-9)


def test_one_epoch_stands_as_it_is() -> None:
    own = ends(9.0, 0.4)
    assert legs_over_epochs({3: own}) == {3: own}


def test_what_epochs_that_show_a_leg_whole_say_for_a_break_counts_once() -> None:
    def taken_for_whole(evidence: float) -> LegEnds:
        own = ends(evidence, 0.4)
        return LegEnds(np.full(4, WHOLE), own.missing, 1 / (1 + np.exp(-PRIOR_ODDS - own.evidence)), own.evidence)

    # the same rock in a leg of which sides go on to its end
    found = legs_over_epochs({0: taken_for_whole(2.3), 1: taken_for_whole(2.3), 2: taken_for_whole(2.3)})
    assert [int(own.states[1]) for own in found.values()] == [WHOLE] * 3
    assert float(found[0].broken[1]) == pytest.approx(float(taken_for_whole(2.3).broken[1]), rel=0.05)
    # beside an epoch that shows a break it counts, and has a length
    found = legs_over_epochs({0: taken_for_whole(2.3), 1: ends(2.5, 0.3)})
    assert int(found[0].states[1]) == BROKEN
    assert float(found[0].missing[1]) in (0.3, 0.4)
