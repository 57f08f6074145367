"""Medians of streams: exact whatever is held, and with few numbers held."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.deformation.streamed_median import StreamedMedian


def streamed(pieces: list[np.ndarray], most_held: int, expected: float = np.nan) -> tuple[float, int]:
    """Median of all pieces, and how often they had to be given."""
    median = StreamedMedian(expected, most_held=most_held)
    for times in range(1, 6):
        for piece in pieces:
            median.add(piece)
        if median.settled():
            return median.value, times
    raise AssertionError("not settled after being given five times")


@pytest.mark.parametrize("count", [1, 2, 999, 1000])
@pytest.mark.parametrize("most_held", [50, 10_000])
def test_median_is_exact(count: int, most_held: int) -> None:
    numbers = np.abs(np.random.default_rng(count).normal(0, 0.01, count))
    value, times = streamed(np.array_split(numbers, 7), most_held)
    assert value == np.median(numbers)
    assert times == (1 if count <= most_held else 2)


@pytest.mark.parametrize(
    "numbers",
    [
        np.repeat([0.25, 0.5, 0.1], [400, 300, 300]),
        np.repeat([0.0, 1e300], 500),
        np.zeros(1000),
        np.nextafter(1.0, np.repeat([0.0, 2.0, 1.0], [300, 400, 301])),
        np.array([-0.0] * 600 + [1.0] * 400),
    ],
    ids=["few values", "far apart", "all zero", "neighbours", "negative zero"],
)
def test_numbers_that_bins_do_not_part(numbers: np.ndarray) -> None:
    numbers = np.random.default_rng(0).permutation(numbers)
    assert streamed(np.array_split(numbers, 10), 40)[0] == np.median(numbers)


@pytest.mark.parametrize(("off", "times"), [(1.0, 1), (1.04, 1), (0.96, 1), (1.2, 3), (0.8, 3), (0.0, 2), (1e6, 3)])
def test_an_expected_median_settles_at_once_and_a_wrong_one_does_no_harm(off: float, times: int) -> None:
    numbers = np.abs(np.random.default_rng(5).normal(0, 0.01, 5000))
    pieces, median = np.array_split(numbers, 7), float(np.median(numbers))
    assert streamed(pieces, 1000, off * median) == (median, times)


def test_the_two_numbers_in_the_middle_may_lie_on_both_sides_of_what_is_looked_at() -> None:
    numbers = np.repeat([0.5, 1.0], [100, 100])
    for expected in (0.5, 0.51, 0.75, 1.0):
        assert streamed([numbers], 1000, expected)[0] == 0.75


def test_little_is_held() -> None:
    rng = np.random.default_rng(3)
    pieces = [np.abs(rng.normal(0, 0.01, 1000)) for _ in range(200)]
    median = StreamedMedian(most_held=5000)
    for _ in range(2):
        for piece in pieces:
            median.add(piece)
            assert median.held <= 5000
        median.settled()
    assert median.value == np.median(np.concatenate(pieces))


def test_nothing_has_no_median() -> None:
    assert np.isnan(streamed([np.empty(0)], 10)[0])
    assert np.isnan(streamed([], 10)[0])
