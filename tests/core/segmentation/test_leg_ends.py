"""Legs are named broken from a face inside the nominal solid, whole where they go on, and nothing is said of what is not seen."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.leg_ends import (
    BROKEN,
    END,
    FACE,
    OBLIQUITY,
    PRIOR_ODDS,
    UNSEEN,
    WHOLE,
    LegEnds,
    LegView,
    left_by_breaks,
    leg_ends,
)
from tetratrack.core.segmentation.seen_through import Passing
from tetratrack.core.segmentation.sight_lines import SECTORS, leg_places

UNIT = UnitType.tetrapod(2.3)


def unit_with_break(share: float, rng: np.random.Generator, count: int = 12_000) -> np.ndarray:
    """Points on a unit whose leg 3 ends at a share of its length, with the face of the fracture."""
    points, _, _ = sample_surface(UNIT, count, rng)
    axis = UNIT.leg_directions[2]
    axial, length = points @ axis, share * UNIT.leg_length
    gone = (np.argmax(points @ UNIT.leg_directions.T, axis=1) == 2) & (axial > length)
    radius = UNIT.radius - UNIT.gradient * length
    flat = rng.normal(size=(300, 3))
    flat -= np.outer(flat @ axis, axis)
    flat *= (radius * np.sqrt(rng.random(300)) / np.linalg.norm(flat, axis=1))[:, None]
    return np.vstack([points[~gone], flat + length * axis])


@pytest.mark.parametrize("share", [0.6, 0.72, 0.85])
def test_a_broken_leg_is_named_with_what_is_missing(share: float) -> None:
    rng = np.random.default_rng(5)
    ends = leg_ends(LegView(unit_with_break(share, rng) + rng.normal(0, 0.004, (1, 3)), UNIT, 0.004))
    assert ends.states.tolist() == [WHOLE, WHOLE, BROKEN, WHOLE]
    assert ends.missing[2] == pytest.approx((1 - share) * UNIT.leg_length, abs=0.03)
    row = ends.as_row()
    assert (row["leg2"], row["leg3"]) == ("whole", "broken")
    assert float(str(row["leg_probability"])) > 0.95


def test_a_leg_that_shows_its_face_only_is_broken_and_its_end_only_is_not_asked() -> None:
    rng = np.random.default_rng(9)
    for share, state in ((0.7, BROKEN), (1.0, UNSEEN)):
        points = unit_with_break(share, rng)
        lean = points @ UNIT.leg_directions.T
        at_end = np.abs(lean[:, 2] - share * UNIT.leg_length) < 0.01
        hidden = (np.argmax(lean, axis=1) == 2) & (lean[:, 2] > 0.3 * UNIT.leg_length) & ~at_end
        assert leg_ends(LegView(points[~hidden], UNIT, 0.004)).states.tolist() == [WHOLE, WHOLE, state, WHOLE]


def test_noise_and_strays_break_no_leg() -> None:
    rng = np.random.default_rng(6)
    for noise in (0.004, 0.02):
        points, _, _ = sample_surface(UNIT, 3000, rng)
        strays = rng.uniform(-1.5, 1.5, (40, 3))
        ends = leg_ends(LegView(np.vstack([points + rng.normal(0, noise, points.shape), strays]), UNIT, noise))
        assert BROKEN not in ends.states


def test_rock_within_a_leg_whose_sides_go_on_breaks_nothing() -> None:
    rng = np.random.default_rng(8)
    points, _, _ = sample_surface(UNIT, 12_000, rng)
    axis = UNIT.leg_directions[2]
    # half of the leg, as deep as its axis and as far as its end
    within = rng.uniform(-1, 1, (80_000, 3))
    leg, axial, rho, sector = leg_places(within, UNIT)
    deep = rho < UNIT.radius - UNIT.gradient * axial - 0.1
    along = axial / UNIT.leg_length
    rock = within[(leg == 2) & deep & (along > FACE[0]) & (along < FACE[1]) & (sector < SECTORS // 2)]
    assert len(rock) > 300
    ends = leg_ends(LegView(np.vstack([points, rock]), UNIT, 0.004))
    assert ends.states.tolist() == [WHOLE] * 4
    # the same points where the sides stop are a face
    axials = points @ axis
    gone = (np.argmax(points @ UNIT.leg_directions.T, axis=1) == 2) & (axials > 0.7 * UNIT.leg_length)
    assert leg_ends(LegView(np.vstack([points[~gone], rock]), UNIT, 0.004)).states[2] == BROKEN


def test_nothing_is_said_of_an_end_that_is_not_seen() -> None:
    rng = np.random.default_rng(7)
    points, _, _ = sample_surface(UNIT, 6000, rng)
    lean = points @ UNIT.leg_directions.T
    hidden = (np.argmax(lean, axis=1) == 1) & (lean[:, 1] > 0.6 * UNIT.leg_length)
    ends = leg_ends(LegView(points[~hidden], UNIT, 0.004))
    assert ends.states.tolist() == [WHOLE, UNSEEN, WHOLE, WHOLE]
    assert leg_ends(LegView(np.empty((0, 3)), UNIT, 0.0)).as_row()["leg_probability"] is None


def whole_leg_seen_from(sectors: int, rng: np.random.Generator) -> np.ndarray:
    """Points on a whole unit, of leg 3 but so many of the eight sectors around its side, and not its end."""
    points, _, _ = sample_surface(UNIT, 40_000, rng)
    leg, axial, _, sector = leg_places(points, UNIT)
    return points[(leg != 2) | ((sector < sectors) & (axial < 0.99 * UNIT.leg_length))]


def test_the_fewer_sides_go_on_to_the_end_the_less_they_say_that_it_is_whole() -> None:
    """An oblique break leaves one side as long: a probability of nearly nothing was told from two sectors of eight."""
    told = [leg_ends(LegView(whole_leg_seen_from(n, np.random.default_rng(n)), UNIT, 0.004)) for n in (1, 2, 4, 8)]
    assert [int(ends.states[2]) for ends in told] == [WHOLE] * 4
    probabilities = [float(ends.broken[2]) for ends in told]
    assert probabilities == sorted(probabilities, reverse=True)
    assert 5e-4 < probabilities[0] < 0.01
    assert probabilities[-1] < 2e-4


@pytest.mark.parametrize("sectors", [(0,), (2, 3), (7, 0, 1), (0, 4), tuple(range(8))])
def test_breaks_leave_sides_as_often_as_is_said(sectors: tuple[int, ...]) -> None:
    """Breaks drawn anywhere along the leg and at all slopes, and whether the sides in all of these sectors reach the end."""
    rng, count = np.random.default_rng(3), 200_000
    along = rng.uniform(*FACE, count) * UNIT.leg_length
    slopes = rng.normal(0, OBLIQUITY, (count, 2))
    turn = (np.array(sectors) + 0.5) / SECTORS * 2 * np.pi
    reach = along[:, None] + UNIT.end_radius * (slopes[:, :1] * np.cos(turn) + slopes[:, 1:] * np.sin(turn))
    left = np.mean((reach > END[0] * UNIT.leg_length).all(axis=1))
    told = left_by_breaks(UNIT, tuple(k in sectors for k in range(SECTORS)))
    assert told == pytest.approx(left, rel=0.1)


def test_beams_tell_of_an_oblique_break_whose_longer_side_reaches_the_end() -> None:
    """What the side says against a break is no more than such breaks are rare: beams through the missing part outweigh it."""
    rng = np.random.default_rng(4)
    points = whole_leg_seen_from(2, rng)
    leg, axial, _, _ = leg_places(points, UNIT)
    # the side thins out towards its end, as that of an oblique break does
    kept = (leg != 2) | (axial < 0.9 * UNIT.leg_length) | (rng.random(len(points)) < 0.3)
    view = LegView(points[kept], UNIT, 0.004)
    for evidence, state in ((0.0, WHOLE), (4.0, WHOLE), (9.0, BROKEN)):
        ends = leg_ends(view, beams=lambda leg, first, told=evidence: Passing(told if leg == 2 else 0.0, 0.8 * UNIT.leg_length))
        assert ends.states.tolist() == [WHOLE, WHOLE, state, WHOLE]


def test_rows_state_each_leg_and_are_read_again() -> None:
    """Two broken legs of which one lacks more, one whole, one unseen."""
    states, broken = np.array([BROKEN, WHOLE, UNSEEN, BROKEN]), np.array([0.97, 0.02, np.nan, 0.6])
    evidence = np.where(np.isnan(broken), 0.0, np.log(broken / (1 - broken)) - PRIOR_ODDS)
    row = LegEnds(states, np.array([0.2, 0.0, 0.0, 0.5]), broken, evidence).as_row()
    assert [(row[f"leg{k}"], row[f"leg{k}_missing"], row[f"leg{k}_probability"]) for k in range(1, 5)] == [
        ("broken", 0.2, 0.97),
        ("whole", None, 0.02),
        ("unseen", None, None),
        ("broken", 0.5, 0.6),
    ]
    assert (row["leg_missing"], row["leg_probability"]) == (0.5, 0.97)
    again = LegEnds.from_row(row)
    assert again.as_row() == row
    assert again.evidence == pytest.approx(evidence)


def test_of_rows_of_earlier_versions_whole_legs_are_not_as_likely_broken_as_the_broken_one() -> None:
    row = {"leg1": "whole", "leg2": "broken", "leg3": "unseen", "leg4": "whole", "leg_missing": 0.3, "leg_probability": 0.9}
    ends = LegEnds.from_row(row)
    assert ends.states.tolist() == [WHOLE, BROKEN, UNSEEN, WHOLE]
    assert ends.broken[1] == pytest.approx(0.9)
    assert ends.evidence[[0, 2, 3]].tolist() == [0, 0, 0]
    assert (ends.as_row()["leg2_missing"], ends.as_row()["leg_probability"]) == (0.3, 0.9)


def test_a_face_in_one_sector_counts_with_beams_beyond_it() -> None:
    points = unit_with_break(0.75, np.random.default_rng(5))
    leg, axial, rho, sector = leg_places(points, UNIT)
    face = (leg == 2) & (UNIT.radius - UNIT.gradient * axial - rho > 0.01)
    for kept, evidence, state in ((sector == 0, 2.0, BROKEN), (sector == 0, 1.0, UNSEEN), (sector < 0, 2.0, UNSEEN)):
        view = LegView(points[~face | kept], UNIT, 0.004)
        ends = leg_ends(view, beams=lambda leg, first, told=evidence: Passing(told if leg == 2 else 0.0, 0.8 * UNIT.leg_length))
        assert ends.states.tolist() == [WHOLE, WHOLE, state, WHOLE]
