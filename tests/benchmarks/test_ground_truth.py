"""Ground truth of simulated surveys, as benchmarks read it."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("open3d")
pytest.importorskip("mujoco")

from tetratrack.benchmarks.ground_truth import number_of
from tetratrack.core.simulation.coast import CoastSimulation
from tetratrack.core.simulation.survey_plan import plan_of
from tetratrack.core.simulation.survey_simulation import Simulation


@pytest.mark.parametrize("number", [1, 42, 999])
def test_units_of_one_site_bear_their_numbers(tmp_path: Path, number: int) -> None:
    assert number_of(Simulation(plan_of("uav", "x", units=1), tmp_path).unit_name(number)) == number


@pytest.mark.parametrize("number", [1, 1001, 12_034])
def test_units_of_a_coast_bear_number_and_stretch(tmp_path: Path, number: int) -> None:
    """Read as one number with an underscore in it, U001_000 was unit 0 of stretch 1."""
    assert number_of(CoastSimulation(plan_of("uav", "x", units=1, length=20.0), tmp_path).unit_name(number)) == number
