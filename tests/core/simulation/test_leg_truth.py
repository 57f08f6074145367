"""Truth of the legs: what is missing of a broken one, what is seen of each, and the points whose beams a whole leg would have stopped."""

from __future__ import annotations

from dataclasses import fields

import numpy as np
import pytest

pytest.importorskip("open3d")
pytest.importorskip("mujoco")

from scipy.spatial.transform import Rotation
from tetratrack.core.common.arrays import FloatArray
from tetratrack.core.common.errors import InputError
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface, surface_cells
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.simulation.armour_pile import PiledUnit
from tetratrack.core.simulation.leg_truth import COLUMNS, JOINT, leg_columns, stopped_by_missing_part
from tetratrack.core.simulation.survey_plan import SimulationPlan
from tetratrack.core.simulation.virtual_scanner import Returns

UNIT = UnitType.tetrapod(2.0)
POSE = Pose(np.array([3.0, -2.0, 5.0]), Rotation.from_euler("xyz", [20, -35, 110], degrees=True).as_matrix())
CELLS = surface_cells(UNIT, 400)[0]
ROCK = -3


def measured(points: FloatArray, sensors: FloatArray, label: int) -> Returns:
    """Points of one label from places of the sensor, both in the body frame of POSE."""
    other = {f.name: np.zeros(len(points)) for f in fields(Returns)}
    placed = {"points": POSE.to_frame(points), "sensor": POSE.to_frame(sensors), "labels": np.full(len(points), label)}
    return Returns(**{**other, **placed})


@pytest.mark.parametrize("leg", range(4))
@pytest.mark.parametrize("scale", [1.0, 1.05])
def test_only_beams_through_the_missing_part_show_the_break(leg: int, scale: float) -> None:
    piled = PiledUnit(5, POSE, scale, broken_leg=leg, broken_length=0.7 * UNIT.leg_length)
    axis = UNIT.leg_directions[leg]
    side = np.cross(axis, UNIT.leg_directions[(leg + 1) % 4])
    side /= np.linalg.norm(side)
    # beams across the leg at places along it: before the break they end on the leg, beyond its end nothing was there
    shares = np.array([0.3, 0.5, 0.9, 0.97, 1.05, 1.3])
    middles = scale * UNIT.leg_length * shares[:, None] * axis
    cloud = measured(middles - 2.0 * side, middles + 9.0 * side, ROCK)
    assert stopped_by_missing_part(piled, UNIT, cloud).tolist() == [False, False, True, True, False, False]
    # a point before the leg was not stopped by it, one on its face of fracture is
    before = measured(middles + 2.0 * side, middles + 9.0 * side, ROCK)
    assert not stopped_by_missing_part(piled, UNIT, before).any()
    face = scale * piled.broken_length * axis[None]
    assert stopped_by_missing_part(piled, UNIT, measured(face, face + 9.0 * axis, 5)).all()


def test_columns_say_what_is_missing_and_what_is_seen_of_each_leg() -> None:
    body, _, legs = sample_surface(UNIT, 40_000, np.random.default_rng(2))
    along = (body @ UNIT.leg_directions.T).max(axis=1) / UNIT.leg_length
    # leg 3 hidden, of leg 2 but the part next to the joint
    shown = body[(legs != 2) & ((legs != 1) | (along < JOINT))]
    cloud = measured(shown, shown + np.array([0.0, 0.0, 30.0]), 5)
    whole = dict(zip(COLUMNS, leg_columns(PiledUnit(5, POSE, 1.02), UNIT, shown, CELLS, cloud), strict=True))
    assert (whole["broken_leg"], whole["leg_missing"], whole["break_points"]) == (0, 0.0, 0)
    seen = [float(str(whole[f"leg{k}_seen"])) for k in range(1, 5)]
    assert seen[0] == seen[3] == pytest.approx(1.0, abs=0.02)
    assert seen[1:3] == [0.0, 0.0]
    assert [whole[f"leg{k}_points"] for k in range(1, 5)] == [
        int(np.sum((legs == k) & (along > JOINT))) if k in (0, 3) else 0 for k in range(4)
    ]
    broken = PiledUnit(5, POSE, 1.02, broken_leg=3, broken_length=0.75 * UNIT.leg_length)
    told = dict(zip(COLUMNS, leg_columns(broken, UNIT, shown, CELLS, cloud), strict=True))
    assert (told["broken_leg"], told["leg_missing"]) == (4, pytest.approx(0.25 * UNIT.leg_length * 1.02, abs=1e-4))


def test_nothing_is_seen_of_a_unit_without_points() -> None:
    piled = PiledUnit(5, POSE, 1.0, broken_leg=0, broken_length=1.0)
    values = dict(
        zip(COLUMNS, leg_columns(piled, UNIT, np.empty((0, 3)), CELLS, measured(np.empty((0, 3)), np.empty((0, 3)), 5)), strict=True)
    )
    assert {values[f"leg{k}_{what}"] for k in range(1, 5) for what in ("points", "seen")} == {0}
    assert values["break_points"] == 0


def test_a_plan_says_how_many_units_are_broken() -> None:
    assert [SimulationPlan("s", units=n).broken_units for n in (0, 18, 75)] == [0, 0, 2]
    assert SimulationPlan("s", units=10, broken=7).broken_units == 7
    for wrong in ({"broken": -1}, {"broken": 76}, {"broken": 1, "instrument": "depth_camera"}):
        with pytest.raises(InputError, match="broken"):
            SimulationPlan("s", **wrong)  # type: ignore[arg-type]
