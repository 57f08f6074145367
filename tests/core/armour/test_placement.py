"""Placement figures of a grid on a slope, known by construction, and of orientations drawn at random."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.armour.contacts import free_gaps
from tetratrack.core.armour.placement import CONTACT_HEIGHTS, placement, placement_of_units
from tetratrack.core.model.outline import PlacedShape
from tetratrack.core.model.tetrapod import relate, sample_surface
from tetratrack.core.model.unit_types import UnitType

UNIT = UnitType.tetrapod(2.3)
ALONG, UP_SLOPE = 1.7, 2.1


def _grid(rotations: Rotation, noise: float = 0.0) -> list[PlacedShape]:
    """A grid of 12 by 9 units on a slope of 1 in 1.5, its spacings measured on the slope."""
    across = np.array([0.0, 1.5, 1.0]) / np.hypot(1.5, 1)
    i, j = (index.reshape(-1) for index in np.meshgrid(np.arange(12), np.arange(9)))
    centres = np.array([5e5, 3e6, 2.0]) + i[:, None] * ALONG * np.array([1.0, 0, 0]) + j[:, None] * UP_SLOPE * across
    centres = centres + np.random.default_rng(1).normal(0, noise, centres.shape)
    return [
        PlacedShape(
            centre=centre, rotation=turn, radius=UNIT.radius, gradient=UNIT.gradient, leg_length=UNIT.leg_length, legs=UNIT.leg_directions
        )
        for centre, turn in zip(centres, rotations.as_matrix(), strict=True)
    ]


def test_a_grid_known_by_construction_to_one_percent() -> None:
    # all alike, though each is written with another of the twelve rotations of a tetrapod onto itself
    alike = Rotation.from_matrix(UNIT.symmetries[np.arange(108) % 12])
    found = placement(_grid(alike, 0.0), UNIT.height, UNIT.symmetries)
    assert found is not None
    diameter = UNIT.nominal_diameter
    assert found.units == 108
    assert found.inner == 10 * 7
    assert found.density == pytest.approx(1 / (ALONG * UP_SLOPE), rel=0.01)
    assert found.packing == pytest.approx(diameter**2 / (ALONG * UP_SLOPE), rel=0.01)
    assert found.spacing_median == pytest.approx(ALONG / diameter, rel=0.01)
    assert found.spacing_low == pytest.approx(ALONG / diameter, rel=0.01)
    assert found.turn_neighbours < 1e-4
    assert found.off_surface_most < 1e-6


def test_orientations_at_random_and_a_rough_surface() -> None:
    found = placement(_grid(Rotation.random(108, random_state=2), 0.05), UNIT.height, UNIT.symmetries)
    assert found is not None
    assert found.turn_neighbours == pytest.approx(found.turn_random, rel=0.15)
    assert found.turn_random > 40
    assert found.off_surface_rms == pytest.approx(0.05, rel=0.2)
    assert found.density == pytest.approx(1 / (ALONG * UP_SLOPE), rel=0.02)


def test_too_few_units_state_nothing() -> None:
    assert placement(_grid(Rotation.random(108, random_state=2))[:8], UNIT.height, UNIT.symmetries) is None


def _unit(centre: list[float], turn: Rotation) -> PlacedShape:
    return PlacedShape(
        centre=np.array(centre),
        rotation=turn.as_matrix(),
        radius=UNIT.radius,
        gradient=UNIT.gradient,
        leg_length=UNIT.leg_length,
        legs=UNIT.leg_directions,
    )


def test_gaps_of_units_end_to_end_and_rim_to_cone() -> None:
    up, down = Rotation.identity(), Rotation.from_rotvec([np.pi, 0, 0])
    pair = np.array([[0, 1]])
    # end disc against end disc: twice the leg, and the gap
    facing = [_unit([7e5, 4e6, 3.0], up), _unit([7e5, 4e6, 3.0 + 2 * UNIT.leg_length + 0.1], down)]
    assert free_gaps(facing, pair)[0] == pytest.approx(0.100, abs=1e-3)
    into = [_unit([0, 0, 0], up), _unit([0, 0, 2 * UNIT.leg_length - 0.02], down)]
    assert free_gaps(into, pair)[0] < 0
    # upright legs of two units side by side, cones that part upwards: nearest where the lower legs meet, known from dense points
    beside = [_unit([0, 0, 0], up), _unit([2.6, 0, 0.3], Rotation.from_rotvec([0, 0, np.pi]))]
    points, _, _ = sample_surface(UNIT, 400_000, np.random.default_rng(4))
    dense = relate((points @ beside[0].rotation.T - beside[1].centre) @ beside[1].rotation, UNIT).distance.min()
    assert free_gaps(beside, pair)[0] == pytest.approx(dense, abs=2e-3)
    assert free_gaps(beside, pair)[0] <= dense + 1e-6


def test_contacts_of_a_column_of_units_that_stand_on_each_other() -> None:
    turn = Rotation.identity()
    units = [_unit([4.0 * k, 0, 0.001 * k * k], turn) for k in range(13)]
    touching = _unit([0, 0, 2 * UNIT.leg_length + 0.5 * CONTACT_HEIGHTS * UNIT.height], Rotation.from_rotvec([np.pi, 0, 0]))
    found = placement_of_units([*units, touching], UNIT.height, UNIT.symmetries)
    assert found is not None
    assert found.contacts[0] == found.contacts[-1] == 1
    assert found.contacts[1:-1].sum() == 0
    assert found.gap[0] == pytest.approx(0.5 * CONTACT_HEIGHTS * UNIT.height, abs=1e-3)


def test_columns_of_a_square_and_of_a_staggered_grid() -> None:
    square = _grid(Rotation.random(108, random_state=2))
    staggered = [replace(unit, centre=unit.centre + np.array([ALONG / 2 * (k // 12 % 2), 0, 0])) for k, unit in enumerate(square)]
    in_square, in_staggered = (placement(units, UNIT.height, UNIT.symmetries) for units in (square, staggered))
    assert in_square is not None
    assert in_staggered is not None
    assert in_square.on_slope == 12 * 8
    assert in_square.columns == in_square.on_slope
    assert in_staggered.columns == 0
    # a shift of rows changes no density
    assert in_staggered.density == pytest.approx(1 / (ALONG * UP_SLOPE), rel=0.01)


def test_two_layers_and_a_bent_coast() -> None:
    """Rows around an arc of 60 m radius, a second layer right under the first."""
    rng = np.random.default_rng(3)
    radius, step = 60.0, 1.8
    diameter = UNIT.nominal_diameter
    units = []
    for depth in (0.0, 1.04 * diameter):
        for row in range(6):
            # every row as long on its own arc, so that the density is the same everywhere
            around = radius + row * 1.5
            for k in range(24):
                angle = (k - 12 + 0.5 * (row % 2)) * step / radius
                slope = np.array([np.sin(angle) * 0.8, np.cos(angle) * 0.8, 0.6])
                place = np.array([around * np.sin(angle), around * np.cos(angle), -row * 1.5 * 0.75]) - depth * slope
                units.append(_unit(place.tolist(), Rotation.random(random_state=rng.integers(1 << 30))))
    found = placement_of_units(units, UNIT.height, UNIT.symmetries)
    assert found is not None
    assert (found.layer[:144] == 1).all()
    assert (found.layer[144:] == 2).mean() > 0.98
    together = placement(units, UNIT.height, UNIT.symmetries)
    assert together is not None
    assert [layer.number for layer in together.layers] == [1, 2]
    rows = np.arange(1, 5)
    # outer rows lie farther apart along the arc
    area = np.mean(1.5 * np.hypot(1, 0.75) * step * (radius + 1.5 * rows) / radius)
    assert together.density == pytest.approx(1 / area, rel=0.02)
    assert together.layers[1].packing == pytest.approx(together.packing, rel=0.03)
    assert together.off_surface_most < 0.35


def test_the_nominal_diameter_is_of_the_cones_as_fitted() -> None:
    stout = UNIT.with_shape(1.1 * UNIT.radius, UNIT.gradient)
    units = [replace(unit, radius=stout.radius) for unit in _grid(Rotation.random(108, random_state=2))]
    found = placement(units, UNIT.height, UNIT.symmetries)
    assert found is not None
    assert found.nominal_diameter == pytest.approx(stout.nominal_diameter, rel=1e-12)
    assert stout.nominal_diameter > 1.05 * UNIT.nominal_diameter
