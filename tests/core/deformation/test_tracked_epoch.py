"""What the strips or stations of an epoch leave open of its place."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime

import numpy as np
import pytest
from tetratrack.core.deformation.target_shifts import TargetShifts
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


def test_parts_of_one_strip_do_not_make_its_offset_known() -> None:
    """Passes that GPS time tells may be parts of one strip: equal offsets say nothing of what they have in common."""
    equal = {number: np.full(3, 1e-5 * number) for number in range(1, 7)}
    assert EPOCH.with_mean_offset(equal, 0.015).offset_variance < 1e-9
    by_time = replace(EPOCH, numbered=False)
    assert by_time.with_mean_offset(equal, 0.015).offset_variance == pytest.approx(0.003**2)
    far = {1: np.full(3, 0.02), 2: np.full(3, -0.02)}
    assert by_time.with_mean_offset(far, 0.015).offset_variance == EPOCH.with_mean_offset(far, 0.015).offset_variance


def test_a_single_station_is_known_as_well_as_its_targets() -> None:
    epoch = EPOCH.with_mean_offset({7: np.zeros(3)}, 0.015)
    assert epoch.offset_variance == 0
    assert shift_sd(EPOCH.with_mean_offset({}, np.nan)) == 0


def test_what_strips_drift_in_the_mean_is_in_a_rigid_registration() -> None:
    """Targets do not drift with the strips: units are known less well, axis by axis, and the targets themselves are told so."""
    nothing = np.zeros((1, 3))
    targets = TargetShifts(
        ids=("T1",), positions=nothing, residuals=nothing, variances=np.full((1, 3), 1e-6), surveyed_variances=nothing
    )  # fmt: skip
    stiff = replace(EPOCH.with_mean_offset({0: np.zeros(3)}, 0.015), targets=targets)
    drifting = replace(stiff, drift_variances=np.array([16e-6, 9e-6, 4e-6]))
    assert stiff.placement is not None
    assert drifting.placement is not None
    more = drifting.placement.covariance - stiff.placement.covariance
    assert more == pytest.approx(np.diag([16e-6, 9e-6, 4e-6, 0, 0, 0, 0]))
    told = drifting.placed_targets
    assert told is not None
    assert told.offset_variance == pytest.approx(9e-6)
    assert told.drift_variances == pytest.approx([16e-6, 9e-6, 4e-6])
    assert EPOCH.placed_targets is None
