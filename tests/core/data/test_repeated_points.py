"""Copies of points in several tiles, and the order that does not hang on tiles."""

from __future__ import annotations

import numpy as np
from tetratrack.core.data.repeated_points import by_place, second_copies


def test_order_is_that_of_all_five_keys():
    rng = np.random.default_rng(6)
    for count in (0, 1, 4000):
        # steps so coarse that many points share places, some all of it
        xyz = np.round(rng.uniform(-2, 2, (count, 3)), 1)
        source, time = rng.integers(0, 3, count).astype(np.uint16), np.round(rng.uniform(0, 2, count), 1)
        wanted = np.lexsort((time, source, xyz[:, 2], xyz[:, 1], xyz[:, 0]))
        assert by_place(xyz, source, time).tolist() == wanted.tolist()


def test_order_holds_where_eastings_differ_by_next_to_nothing():
    rng = np.random.default_rng(8)
    xyz = np.round(rng.uniform(500_000, 500_040, (3000, 3)), 2)
    # as tiles of other offsets have them
    xyz[1::2, 0] = xyz[::2, 0] + 1e-10
    order = by_place(xyz, np.zeros(3000, dtype=np.uint16), np.zeros(3000))
    assert order.tolist() == np.lexsort((xyz[:, 2], xyz[:, 1], xyz[:, 0])).tolist()


def test_copies_in_later_tiles_are_seen_wherever_tiles_lie():
    rng = np.random.default_rng(7)
    low = np.array([(0.0, 0.0, 0.0), (9.0, 0.0, 0.0), (50.0, 0.0, 0.0)])
    tiles = [np.round(corner + rng.uniform(0, 10, (200, 3)), 3) for corner in low]
    tiles[1][:20] = tiles[0][np.argsort(tiles[0][:, 0])[-20:]]
    xyz, tile = np.vstack(tiles), np.repeat(np.arange(3), 200)
    time = np.arange(600.0)
    copies = [int(np.flatnonzero((tiles[0] == point).all(axis=1))[0]) for point in tiles[1][:20]]
    time[200:220] = time[copies]
    again = second_copies(xyz, np.zeros(600, dtype=np.uint16), time, tile, 0.001)
    assert np.flatnonzero(again).tolist() == list(range(200, 220))
