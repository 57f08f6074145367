"""Simulated errors of trajectories: of the size that was asked for, smooth, shared or for each strip."""

from __future__ import annotations

import math

import numpy as np
import pytest
from tetratrack.core.common.errors import InputError
from tetratrack.core.simulation.armour_pile import Site
from tetratrack.core.simulation.bent_frames import FrameErrors, FrameOfEpoch


def along(count: int = 4000, length: float = 2000.0) -> np.ndarray:
    return np.column_stack([np.linspace(0, length, count), np.zeros(count), np.zeros(count)])


def test_a_bend_has_the_size_asked_for_and_no_waves_shorter_than_asked_for() -> None:
    sizes = []
    for epoch in range(6):
        error = FrameOfEpoch(FrameErrors(bend=0.03, shortest=60, longest=300), epoch, 20.0, 5).at(along())
        sizes.append(np.mean(error**2))
        spectrum = np.abs(np.fft.rfft(error * np.hanning(len(error))[:, None], axis=0)) ** 2
        waves = np.fft.rfftfreq(len(error), 2000 / len(error))
        assert spectrum[waves > 1 / 45].sum() < 0.01 * spectrum.sum()
    assert abs(np.sqrt(np.mean(sizes)) - 0.03) < 0.003


def test_strips_drift_each_for_itself_and_targets_see_none_of_it() -> None:
    frame = FrameOfEpoch(FrameErrors(drift=0.02), 1, 20.0, 3)
    points = along()
    first, second = (frame.at(points, np.full(len(points), k)) for k in (1, 2))
    assert abs(np.corrcoef(first[:, 0], second[:, 0])[0, 1]) < 0.5
    assert (frame.at(points) == 0).all()


def test_a_bowl_alternates_between_epochs() -> None:
    points = np.array([[0.0, 0, 0], [20.0, 0, 0]])
    one, two = (FrameOfEpoch(FrameErrors(bowl=0.05), k, 20.0, 0).at(points) for k in (0, 1))
    assert np.allclose(one[:, 2], [-0.05, 0.05])
    assert np.allclose(two, -one)


def test_a_bowl_is_no_deeper_at_the_toe_of_a_short_site() -> None:
    site = Site.of_height(2.3, 40, parapet=True)
    wall, toe = site.across
    corners = np.array([[x, y, 0.0] for x in (-site.half_length, 0.0, site.half_length) for y in np.linspace(wall, toe, 5)])
    heights = FrameOfEpoch(FrameErrors(bowl=0.05), 0, site.half_length, 0, across=site.across).at(corners)[:, 2]
    assert heights.min() == pytest.approx(-0.05)
    assert heights[corners[:, 0] == 0].max() <= 0.05 + 1e-12
    # a corner is farther from the middle than either end
    assert heights.max() <= 3 * 0.05 + 1e-12


def test_without_errors_a_frame_is_rigid() -> None:
    assert (FrameOfEpoch(FrameErrors(), 0, 20.0, 0).at(along(), np.ones(4000, dtype=np.int64)) == 0).all()


@pytest.mark.parametrize(
    ("errors", "where"),
    [
        ({"shortest": 0.0}, "wave lengths"),
        ({"shortest": -5.0}, "wave lengths"),
        ({"shortest": 300.0, "longest": 60.0}, "wave lengths"),
        ({"longest": math.inf}, "wave lengths"),
        ({"bend": math.nan}, "bend"),
        ({"drift": -0.01}, "drift"),
    ],
)
def test_errors_that_no_frame_has_are_refused(errors: dict[str, float], where: str) -> None:
    with pytest.raises(InputError) as caught:
        FrameErrors(**errors)
    assert caught.value.where == where
