"""Parts of a window near places."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree
from tetratrack.core.data.tiles import Window
from tetratrack.core.data.window_around import WindowAround

WINDOW = Window(100.0, 200.0, 180.0, 260.0)


def test_holds_all_within_reach_and_little_else() -> None:
    rng = np.random.default_rng(4)
    for count in (1, 3, 12):
        places = rng.uniform((95, 195), (185, 265), (count, 2))
        around = WindowAround.of(WINDOW, places, 4.0)
        points = rng.uniform((90, 190), (190, 270), (20_000, 2))
        near = cKDTree(places).query(points)[0]
        inside = around.contains(points)
        assert inside[(near <= 4.0) & WINDOW.contains(points)].all()
        assert not inside[near > 4.0 * 1.5 * np.sqrt(2)].any()
        assert not inside[~WINDOW.contains(points)].any()


def test_meets_what_holds_points_near_a_place() -> None:
    around = WindowAround.of(WINDOW, np.array([(120.0, 220.0), (170.0, 250.0)]), 3.0)
    assert around.meets((118.0, 218.0), (119.0, 219.0))
    assert around.meets((0.0, 0.0), (500.0, 500.0))
    # between the places
    assert not around.meets((140.0, 230.0), (150.0, 235.0))
    assert not around.meets((0.0, 0.0), (50.0, 500.0))


def test_places_outside_leave_nothing() -> None:
    around = WindowAround.of(WINDOW, np.array([(20.0, 220.0)]), 3.0)
    assert not around.meets((0.0, 0.0), (500.0, 500.0))
    assert not around.contains(np.array([(120.0, 220.0)])).any()
