"""Beams through units, asked one place of a sensor after the other or many beside each other."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.beams import entering_beams, entering_beams_by_block

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
