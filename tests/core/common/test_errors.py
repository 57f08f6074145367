"""Errors: one root, siblings below it, their parts kept across processes; bad input is never taken for a fit without a solution."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from tetratrack.core.adjustment.adjustment_records import AdjustmentOptions
from tetratrack.core.adjustment.shape_calibration import calibrate
from tetratrack.core.common.errors import Cancelled, CrsError, InputError, NoSolutionError, OutputError, TetratrackError
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.pipeline.block_jobs import adjusted_nearby

UNIT = UnitType.tetrapod(2.3)
POSE = Pose(np.zeros(3), np.eye(3))


def test_input_output_and_solver_are_siblings() -> None:
    assert {kind.__base__ for kind in (InputError, OutputError, NoSolutionError, Cancelled)} == {TetratrackError}
    assert CrsError.__base__ is InputError


@pytest.mark.parametrize("kind", [InputError, CrsError, OutputError, NoSolutionError, TetratrackError])
def test_parts_survive_a_process_border(kind: type[TetratrackError]) -> None:
    error = pickle.loads(pickle.dumps(kind("has no CRS", source="a.laz", where="header", remedy="Declare it.")))  # noqa: S301 - what was dumped here
    assert type(error) is kind
    assert (error.problem, error.source, error.where, error.remedy) == ("has no CRS", "a.laz", "header", "Declare it.")
    assert str(error) == "a.laz, header: has no CRS. Declare it."


def test_points_without_coordinates_are_not_swallowed_as_a_unit_hardly_seen() -> None:
    points = np.full((50, 3), np.nan)
    with pytest.raises(InputError, match="not finite"):
        adjusted_nearby(points, UNIT, POSE, AdjustmentOptions(), None)
    with pytest.raises(InputError, match="not finite"):
        calibrate([points], UNIT, [POSE])
    with pytest.raises(NoSolutionError, match="stays near"):
        adjusted_nearby(np.zeros((3, 3)), UNIT, POSE, AdjustmentOptions(), None)


def test_covariances_without_noise_are_not_swallowed_either() -> None:
    points = np.random.default_rng(0).normal(size=(50, 3))
    with pytest.raises(InputError, match="not finite and positive definite"):
        adjusted_nearby(points, UNIT, POSE, AdjustmentOptions(), np.zeros((50, 3, 3)))
