"""What two registrations leave open of the motion that all units share, where coordinates were surveyed once."""

from __future__ import annotations

from datetime import UTC, datetime

import numpy as np
import pytest
from tetratrack.core.common.arrays import FloatArray
from tetratrack.core.data.point_tables import SurveyedPoints
from tetratrack.core.deformation.common_motion import common_prior
from tetratrack.core.deformation.target_shifts import TargetShifts
from tetratrack.core.deformation.tracked_epoch import TrackedEpoch
from tetratrack.core.registration.control import register
from tetratrack.core.registration.transformation import rigid_jacobian

NAMES = tuple(f"T{k}" for k in range(8))
SURVEYED_SD, CLOUD_SD = 0.004, 0.002
PLACE = np.array([20.0, 3.0, 1.0])
DRAWS = 150


def points(coordinates: FloatArray, sd: float) -> SurveyedPoints:
    return SurveyedPoints(ids=NAMES, coordinates=coordinates, sds=np.full((8, 3), sd))


def registered(control: FloatArray, cloud: FloatArray, similarity: bool) -> TrackedEpoch:
    found = register(points(control, SURVEYED_SD), points(cloud, CLOUD_SD), similarity=similarity, level=1e-9)
    rows = found.residuals
    targets = TargetShifts(
        ids=tuple(r.point_id for r in rows), positions=np.array([r.position for r in rows]), residuals=np.array([r.residual for r in rows]),
        variances=np.array([r.sds for r in rows]) ** 2, surveyed_variances=np.array([r.surveyed_sds for r in rows]) ** 2,
        used=np.array([r.used for r in rows]),
    )  # fmt: skip
    return TrackedEpoch(
        label="e", time=datetime(2024, 4, 9, tzinfo=UTC), units=(), registration=found.transformation, redundancy=18, targets=targets
    )


def squared_error(*, once: bool, similarity: bool = False, cloud_sd: float = CLOUD_SD) -> float:
    """Mean squared normalised error of the shift between two epochs at a place, per coordinate."""
    rng = np.random.default_rng(11)
    truth = rng.uniform([0, 0, 0], [40, 10, 4], (8, 3))
    squares = []
    for _ in range(DRAWS):
        first = truth + rng.normal(0, SURVEYED_SD, (8, 3))
        second = first if once else truth + rng.normal(0, SURVEYED_SD, (8, 3))
        epochs = [registered(own, truth + rng.normal(0, cloud_sd, (8, 3)), similarity) for own in (first, second)]
        prior = common_prior(epochs, 0, 1, PLACE)
        placed = [e.registration.apply(PLACE[None])[0] for e in epochs if e.registration is not None]
        assert prior is not None
        rows = rigid_jacobian(np.zeros((1, 3)))[0]
        away = placed[1] - placed[0]
        squares.append(away @ np.linalg.solve(rows @ prior @ rows.T, away) / 3)
    return float(np.mean(squares))


@pytest.mark.parametrize("similarity", [False, True])
def test_error_of_coordinates_surveyed_once_drops_out(similarity: bool) -> None:
    """The factor of unit weight, never below one, widens a little."""
    assert squared_error(once=True, similarity=similarity) == pytest.approx(0.9, abs=0.12)


def test_clouds_that_err_more_than_stated_show_it_in_what_targets_differ_by() -> None:
    """Few degrees of freedom tell the factor: what is stated is a little too narrow in the mean."""
    assert squared_error(once=True, cloud_sd=2.5 * CLOUD_SD) == pytest.approx(1.1, abs=0.2)


def test_coordinates_surveyed_anew_err_anew() -> None:
    assert squared_error(once=False) == pytest.approx(0.9, abs=0.12)


def test_without_the_deviations_of_coordinates_nothing_is_taken_off() -> None:
    rng = np.random.default_rng(2)
    truth = rng.uniform([0, 0, 0], [40, 10, 4], (8, 3))
    epochs = [registered(truth, truth + rng.normal(0, CLOUD_SD, (8, 3)), False) for _ in range(2)]
    for epoch in epochs:
        assert epoch.targets is not None
        epoch.targets.surveyed_variances[:] = 0
    prior = common_prior(epochs, 0, 1, PLACE)
    own = [e.registration.covariance_at(PLACE) for e in epochs if e.registration is not None]
    assert prior == pytest.approx(own[0] + own[1])
