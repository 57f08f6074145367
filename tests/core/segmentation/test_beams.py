"""Beams through units, asked one place of a sensor after the other or many beside each other."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.beams import entering_beams, entering_beams_by_block, passing_beams

UNIT = UnitType.tetrapod(2.3)


def test_blocks_of_places_count_as_each_place_does() -> None:
    rng = np.random.default_rng(3)
    axes = np.einsum("kij,lj->kli", Rotation.random(7, random_state=5).as_matrix(), UNIT.leg_directions)
    about = rng.uniform(-4, 4, (7, 3)), axes, rng.uniform(0.5, 1.0, (7, 4)) * UNIT.leg_length
    points = rng.uniform(-3, 3, (300, 3))
    stands = rng.normal(0, 15, (37, 3))
    turns = rng.uniform(0, np.pi, 37)
    drifts = np.column_stack([np.cos(turns), np.sin(turns), np.zeros(37)]) * (np.arange(37) % 2)[:, None]
    rest = *about, UNIT.reach, UNIT.radius, UNIT.gradient, 0.1, 100
    each = [int(entering_beams(points, stands[[k]], drifts[[k]], *rest)[0]) for k in range(37)]
    assert 5 < sum(20 < count < 101 for count in each) < 37
    assert 101 in each
    np.testing.assert_array_equal(entering_beams_by_block(points, stands, drifts, *rest), each)


def test_beams_pass_through_the_end_of_a_leg_where_steps_along_them_do() -> None:
    rng = np.random.default_rng(4)
    axis = np.array([0.6, 0.0, 0.8])
    first, last, chord, step = 0.5 * UNIT.leg_length, UNIT.leg_length, 0.05, 0.002
    # from all around, along the axis either way, and across it
    stands = 20 * np.vstack([Rotation.random(5, random_state=1).as_matrix()[:, 0], [axis, -axis, [0.0, 1.0, 0.0], [0.8, 0.0, -0.6]]])
    points = axis * 0.7 * UNIT.leg_length + rng.normal(0, 0.5, (300, 3))
    steps = np.arange(0, 6, step)
    asked = passed = 0
    for stand in stands:
        for point in points:
            towards = (stand - point) / np.linalg.norm(stand - point)
            beam = point + steps[:, None] * towards
            axial = beam @ axis
            rho = np.linalg.norm(beam - axial[:, None] * axis, axis=1)
            inside = (axial > first) & (axial < last) & (rho < UNIT.radius - UNIT.gradient * axial)
            length = step * inside.sum()
            if abs(length - chord) < 2 * step:
                continue
            cone = UNIT.radius, UNIT.gradient
            counts, places = passing_beams(point[None], stand[None], np.zeros((1, 3)), axis, first, last, *cone, chord, 1)
            asked += 1
            passed += int(counts[0])
            assert counts[0] == (length > chord)
            if counts[0]:
                np.testing.assert_allclose(places[0, 0], axial[inside].min(), atol=2 * step)
    assert 500 < passed < asked - 500
