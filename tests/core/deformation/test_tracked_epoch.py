"""What the strips or stations of an epoch leave open of its place."""

from __future__ import annotations

from datetime import UTC, datetime

import numpy as np
import pytest
from tetratrack.core.deformation.tracked_epoch import TrackedEpoch
from tetratrack.core.registration.transformation import Transformation

REGISTRATION = Transformation(
    origin_from=np.zeros(3), origin_to=np.zeros(3), translation=np.zeros(3), rotation=np.eye(3), scale=1.0, covariance=np.zeros((7, 7))
)
EPOCH = TrackedEpoch(label="a", time=datetime(2024, 4, 9, tzinfo=UTC), units=(), registration=REGISTRATION)


def shift_sd(epoch: TrackedEpoch) -> float:
    assert epoch.placement is not None
    return float(np.sqrt(epoch.placement.covariance[0, 0]))


def test_strips_with_numbers_show_the_variance_of_their_mean() -> None:
    rng = np.random.default_rng(5)
    truth = [rng.normal(0, 0.006, (5, 3)) for _ in range(400)]
    # the adjustment gives offsets less their mean
    stated = [EPOCH.with_mean_offset(dict(enumerate(own - own.mean(axis=0), 1)), 0.017).offset_variance for own in truth]
    true = np.mean([own.mean(axis=0) ** 2 for own in truth])
    assert np.mean(stated) == pytest.approx(true, rel=0.15)


def test_strips_without_numbers_are_off_by_a_share_of_the_noise() -> None:
    epoch = EPOCH.with_mean_offset({0: np.zeros(3)}, 0.015)
    assert shift_sd(epoch) == pytest.approx(0.003)


def test_a_single_station_is_known_as_well_as_its_targets() -> None:
    epoch = EPOCH.with_mean_offset({7: np.zeros(3)}, 0.015)
    assert epoch.offset_variance == 0
    assert shift_sd(EPOCH.with_mean_offset({}, np.nan)) == 0
