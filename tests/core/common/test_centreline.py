"""Centrelines of straight and of turning structures, and chainage along them."""

from __future__ import annotations

import numpy as np
import pytest
from curved_structures import WIDTH, line_of, units_along
from tetratrack.core.common.axis import Axis, main_direction
from tetratrack.core.common.centreline import centreline

REACH = 13.8
STRETCH = 23.0


def spread_of_stretches(axis: Axis, places: np.ndarray) -> float:
    """Largest extent in plan of what lies on one stretch, metres."""
    along = axis.locate(places)[0]
    stretches = (places[(along >= start) & (along < start + STRETCH), :2] for start in np.arange(0, along.max(), STRETCH / 2))
    return max(float(np.linalg.norm(np.ptp(own, axis=0))) for own in stretches if len(own))


@pytest.mark.parametrize("width", [10.0, 40.0])
def test_straight_structures_keep_the_distance_along_their_longest_direction(width: float) -> None:
    for seed in range(10):
        rng = np.random.default_rng(seed)
        turn = rng.uniform(0, 2 * np.pi)
        strip = np.column_stack([rng.uniform(0, 30 + 40 * seed, 300), rng.uniform(0, width, 300)])
        places = strip @ np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]]) + [6e5, 3e6]
        axis = centreline(places, REACH)
        assert len(axis.corners) == 2
        projected = places @ main_direction(places)
        np.testing.assert_allclose(axis.locate(places)[0], projected - projected.min(), atol=1e-7)


def test_both_slopes_of_a_crest_and_pieces_of_a_coast_are_one_straight_structure() -> None:
    rng = np.random.default_rng(0)
    slopes = np.column_stack([rng.uniform(0, 200, 600), rng.uniform(0, 8, 600) + 20 * rng.integers(0, 2, 600)])
    pieces = np.column_stack([rng.uniform(0, 50, 300) + 90 * rng.integers(0, 3, 300), rng.uniform(0, 8, 300)])
    assert all(len(centreline(places, REACH).corners) == 2 for places in (slopes, pieces))


@pytest.mark.parametrize("name", ["L", "U", "head"])
def test_chainage_follows_corners_basins_and_heads(name: str) -> None:
    for seed in range(10):
        places, chainage, _ = units_along(line_of(name), seed)
        axis = centreline(places, REACH)
        along = axis.locate(places)[0]
        # each corner is cut by about two thirds of the width
        assert np.abs(along - chainage).max() < 2 * WIDTH
        assert np.corrcoef(along, chainage)[0, 1] > 0.999
        assert not axis.gaps
        assert spread_of_stretches(axis, places) < 1.5 * STRETCH


def test_a_ring_and_arms_that_stand_apart_share_no_stretch() -> None:
    for seed in range(10):
        rng = np.random.default_rng(seed)
        ring, _, _ = units_along(line_of("ring"), seed)
        jetties = np.column_stack([rng.uniform(0, 200, 600), rng.uniform(0, WIDTH, 600) + 150 * rng.integers(0, 2, 600)])
        spur = np.column_stack([rng.uniform(0, WIDTH, 120) + 100, rng.uniform(WIDTH, 90, 120)])
        trunk = np.column_stack([rng.uniform(0, 200, 300), rng.uniform(0, WIDTH, 300)])
        hook = np.vstack(
            [units_along(line_of("head"), seed)[0][:, :2], np.column_stack([rng.uniform(60, 150, 135), rng.uniform(-45, -35, 135)])]
        )
        for places in (ring, jetties, np.vstack([trunk, spur]), hook):
            assert spread_of_stretches(centreline(places, REACH), places) < 2 * STRETCH


def test_arms_follow_each_other_end_to_end() -> None:
    rng = np.random.default_rng(1)
    jetties = np.column_stack([rng.uniform(0, 200, 600), rng.uniform(0, WIDTH, 600) + 150 * rng.integers(0, 2, 600)])
    axis = centreline(jetties, REACH)
    assert len(axis.gaps) == 1
    assert axis.lengths.sum() == pytest.approx(550, abs=15)
    assert axis.lengths[axis.gaps[0]] == pytest.approx(150, abs=5)


def test_few_places_and_places_at_one_spot_have_a_line_too() -> None:
    for places in (np.zeros((0, 3)), np.ones((1, 3)), np.ones((9, 3)), np.array([[0.0, 0.0], [300.0, 5.0]])):
        along = centreline(places, REACH).locate(places)[0]
        assert len(along) == len(places)
        assert np.isfinite(along).all()


def test_a_long_coast_takes_time_by_its_length() -> None:
    """Places are held against the parts of the line near them: five kilometres in far less than a second."""
    turn = np.linspace(0, 2.5, 400)[:, None]
    places, chainage, _ = units_along(2000 * np.hstack([-np.cos(turn), np.sin(turn)]), 0)
    along = centreline(places, REACH).locate(places)[0]
    assert np.abs(along - chainage).max() < WIDTH
