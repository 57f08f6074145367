"""Chainage along an axis that is given."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.common.axis import Axis, main_direction


def test_chainage_on_a_bent_axis_and_beyond_its_ends() -> None:
    axis = Axis(np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]]))
    places = np.array([[3.0, 1.0, 5], [10.5, 4.0, 5], [-2.0, 0.5, 5], [9.0, 14.0, 5], [10.2, -0.3, 5]])
    along, offset = axis.locate(places)
    np.testing.assert_allclose(along, [3.0, 14.0, -2.0, 24.0, 10.0])
    np.testing.assert_allclose(offset, [1.0, -0.5, 0.5, 1.0, -np.hypot(0.2, 0.3)])


def test_what_lies_beside_a_hook_is_not_sought_beyond_its_end() -> None:
    axis = Axis(np.array([[0.0, 0.0], [100.0, 0.0], [100.0, 40.0], [50.0, 40.0], [50.0, 20.0]]))
    np.testing.assert_allclose(axis.locate(np.array([[50.0, 1.0]])), [[50.0], [1.0]])


def test_no_place_lies_on_a_gap() -> None:
    corners = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 100.0], [0.0, 100.0]])
    along, offset = Axis(corners, gaps=(1,)).locate(np.array([[10.0, 40.0], [4.0, 99.0]]))
    np.testing.assert_allclose(along, [10.0, 116.0])
    np.testing.assert_allclose(np.abs(offset), [40.0, 1.0])


def test_places_are_held_against_the_parts_near_them_with_the_same_result() -> None:
    rng = np.random.default_rng(0)
    corners = np.cumsum(rng.normal(0, 10, (60, 2)), axis=0)
    places = rng.uniform(-80, 80, (400, 2))
    parts = [Axis(corners[k : k + 2], ()) for k in range(59)]
    nearest = np.full(len(places), np.inf)
    for part in parts:
        along, offset = part.locate(places)
        beyond = np.maximum(np.maximum(-along, along - part.lengths[0]), 0)
        nearest = np.minimum(nearest, np.hypot(beyond, offset))
    axis = Axis(corners)
    along, offset = axis.locate(places)
    inside = (along > 0) & (along < axis.lengths.sum())
    np.testing.assert_allclose(np.abs(offset)[inside], nearest[inside])


@pytest.mark.parametrize("direction", [(1.0, 0.1), (-1.0, 0.1), (0.1, -1.0), (-0.1, 1.0)])
def test_the_main_direction_runs_east_or_north(direction: tuple[float, float]) -> None:
    places = np.outer(np.arange(5.0), direction)
    assert main_direction(places) == pytest.approx(np.array(direction) * np.sign(sum(direction)) / np.linalg.norm(direction))
