"""Legs are named broken from a face inside the nominal solid, whole where they go on, and nothing is said of what is not seen."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.leg_ends import BROKEN, UNSEEN, WHOLE, LegView, leg_ends

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


def test_nothing_is_said_of_an_end_that_is_not_seen() -> None:
    rng = np.random.default_rng(7)
    points, _, _ = sample_surface(UNIT, 6000, rng)
    lean = points @ UNIT.leg_directions.T
    hidden = (np.argmax(lean, axis=1) == 1) & (lean[:, 1] > 0.6 * UNIT.leg_length)
    ends = leg_ends(LegView(points[~hidden], UNIT, 0.004))
    assert ends.states.tolist() == [WHOLE, UNSEEN, WHOLE, WHOLE]
    assert leg_ends(LegView(np.empty((0, 3)), UNIT, 0.0)).as_row()["leg_probability"] is None
