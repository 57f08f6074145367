"""The grid over points: cells, their order, and what lies near a place."""

from __future__ import annotations

import tracemalloc

import numpy as np
import pytest
from scipy.spatial import cKDTree
from tetratrack.core.common.neighbourhood import build_grid, neighbours_of_some


def test_cells_hold_their_points_in_ascending_order() -> None:
    points = np.random.default_rng(0).uniform(-3, 4, (3000, 3))
    grid = build_grid(points, 0.5)
    cell = np.minimum(np.floor((points - grid.origin) / grid.cell).astype(int), grid.size - 1)
    flat = np.ravel_multi_index(tuple(cell.T), tuple(grid.size))
    assert grid.order.tolist() == np.argsort(flat, kind="stable").tolist()
    held = np.bincount(flat, minlength=int(np.prod(grid.size))).reshape(-1, grid.size[2])
    for k, counts in enumerate(held):
        own = np.flatnonzero(counts)
        assert grid.bottom[k] == own[0]
        starts = grid.start[grid.column[k] : grid.column[k + 1] + 1]
        assert np.diff(starts).tolist() == counts[own[0] : own[-1] + 1].tolist()


def test_table_of_cells_is_that_of_a_surface_not_of_the_box_around_it() -> None:
    # a slope of 45 degrees and a lone point above: 10^6 cells of the box, of which a column of the slope has one or two
    e, n = (values.ravel() for values in np.meshgrid(np.arange(0.05, 10, 0.1), np.arange(0.05, 10, 0.1)))
    points = np.vstack([np.column_stack([e, n, e]), [[5.0, 5.0, 9.9]]])
    grid = build_grid(points, 0.1)
    assert int(np.prod(grid.size)) > 900_000
    assert len(grid.start) < 25_000
    near = np.linalg.norm(points - [5.0, 5.0, 9.0], axis=1) <= 3.0
    assert sorted(grid.within(np.array([5.0, 5.0, 9.0]), 3.0)) == np.flatnonzero(near).tolist()


def test_points_within_reach() -> None:
    points = np.random.default_rng(1).uniform(0, 5, (2000, 3))
    grid = build_grid(points, 0.4)
    active = np.arange(len(points)) % 3 > 0
    near = np.linalg.norm(points - [2.0, 1.0, 4.9], axis=1) <= 0.9
    assert sorted(grid.within(np.array([2.0, 1.0, 4.9]), 0.9)) == np.flatnonzero(near).tolist()
    assert sorted(grid.within(np.array([2.0, 1.0, 4.9]), 0.9, active)) == np.flatnonzero(near & active).tolist()


def test_points_within_reach_anywhere_and_by_any_cells() -> None:
    rng = np.random.default_rng(2)
    points = np.round(rng.uniform(-2, 2, (1500, 3)), 1)
    for cell in (0.1, 0.35, 3.0):
        grid = build_grid(points, cell)
        assert np.array_equal(grid.places, points[grid.order])
        # beyond the cloud too, and with points between two cells, where rounding puts them into either
        for middle, reach in zip(np.round(rng.uniform(-3, 3, (40, 3)), 1), np.round(rng.uniform(0.1, 3, 40), 1) + 0.003, strict=True):
            near = np.sum((points - middle) ** 2, axis=1) <= reach * reach
            assert sorted(grid.within(middle, float(reach))) == np.flatnonzero(near).tolist()


@pytest.mark.parametrize("count", [2, 25])
@pytest.mark.parametrize("away", [60.0, 9000.0])
def test_neighbours_of_some_points_are_those_of_a_tree_however_unevenly_they_lie(count: int, away: float) -> None:
    rng = np.random.default_rng(3)
    dense = np.column_stack([rng.uniform(0, 2, (20_000, 2)), rng.normal(0, 0.01, 20_000)])
    sparse = np.column_stack([rng.uniform(-30, 40, (3000, 2)), rng.uniform(0, 5, 3000)])
    wall = np.column_stack([rng.normal(5, 0.002, 8000), rng.uniform(0, 3, (8000, 2))])
    alone = np.array([[away, -away, 50.0], [away, -away, 50.0]])
    points = rng.permutation(np.vstack([dense, sparse, wall, alone]))
    chosen = np.append(rng.choice(len(points), 400, replace=False), np.flatnonzero(points[:, 0] == away))
    distance, index = neighbours_of_some(points, chosen, count)
    np.testing.assert_allclose(distance, cKDTree(points).query(points[chosen], k=count)[0], atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(points[index] - points[chosen][:, None], axis=2), distance, atol=1e-12)
    assert all(len(set(row)) == count for row in index.tolist())


def test_neighbours_of_a_few_places_and_of_places_that_coincide() -> None:
    points = np.random.default_rng(4).uniform(0, 1, (5000, 3))
    points[:40] = points[0]
    for chosen in (np.array([7]), np.arange(60), np.arange(5000)):
        distance, _ = neighbours_of_some(points, chosen, 3)
        np.testing.assert_allclose(distance, cKDTree(points).query(points[chosen], k=3)[0], atol=1e-12)
    assert not neighbours_of_some(np.ones((5000, 3)), np.arange(60), 3)[0].any()


def test_the_last_place_that_is_left_has_no_neighbour_twice() -> None:
    """A square of its own reach is half as wide as what it is asked about, and rounding led past the last one."""
    rng = np.random.default_rng(5)
    for _ in range(100):
        dense = rng.uniform(0, 3, (3000, 3)) * [1, 1, 0.01]
        beside = rng.uniform([20, 20, 0], [21, 21, 1]) + np.vstack([np.zeros(3), rng.normal(0, 0.5, (40, 3))])
        points = np.vstack([dense, beside])
        chosen = np.append(rng.choice(len(dense), 60, replace=False), len(dense))
        distance, index = neighbours_of_some(points, chosen, 25)
        np.testing.assert_allclose(distance, cKDTree(points).query(points[chosen], k=25)[0], atol=1e-12)
        assert len(set(index[-1].tolist())) == 25


def test_strewn_points_far_away_need_no_table_of_all_between() -> None:
    """One in a hundred along 2 km took 4 GB of squares for 300 000 points."""
    rng = np.random.default_rng(6)
    points = rng.random((60_000, 3)) * [60, 0.5, 0.1]
    points[:600] = rng.random((600, 3)) * [2000, 0.5, 1]
    chosen = rng.choice(len(points), 1500, replace=False)
    tracemalloc.start()
    distance, _ = neighbours_of_some(points, chosen, 24)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    np.testing.assert_allclose(distance, cKDTree(points).query(points[chosen], k=24)[0], atol=1e-12)
    assert most < 150e6
