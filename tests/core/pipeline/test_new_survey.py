"""Areas of units of several sizes, from where each was found."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.common.arrays import FloatArray
from tetratrack.core.data.survey import inside
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.pipeline.drafted_units import unit_areas
from tetratrack.core.segmentation.unit_size import FoundSize, SizeTrial

ORIGIN = np.array([500_000.0, 3_500_000.0, 0.0])


def _size(height: float, centres: FloatArray) -> FoundSize:
    trial = SizeTrial(height, 1.0, len(centres))
    return FoundSize(UnitType.tetrapod(height), 0.01, standard=True, noisy=False, trial=trial, centres=centres)


def _rows(east: float, north: float, count: int = 40) -> FloatArray:
    k = np.arange(count)
    return np.column_stack([east + 2.5 * (k % 8), north + 2.5 * (k // 8), np.zeros(count)])


def test_sizes_that_lie_apart_get_areas_of_their_own() -> None:
    small, large = _rows(0, 0), _rows(0, 30)
    rings = unit_areas([_size(2.3, small), _size(2.9, large)], np.vstack([small, large]), ORIGIN)
    assert rings is not None
    for ring, mine, others in zip(rings, (small, large), (large, small), strict=True):
        assert all(inside(ring, *(centre + ORIGIN)[:2]) for centre in mine)
        assert not any(inside(ring, *(centre + ORIGIN)[:2]) for centre in others)


def test_single_ones_among_the_others_do_not_hide_it() -> None:
    small, large = _rows(0, 0), _rows(40, 0)
    astray = np.vstack([large, [[8.0, 4.0, 0.0]]])
    rings = unit_areas([_size(2.3, small), _size(2.9, astray)], np.vstack([small, astray]), ORIGIN)
    assert rings is not None
    east = [ring[0][0] - ORIGIN[0] for ring in rings]
    assert max(east) == pytest.approx(0.5 * (2.5 * 7 + 40))
    assert all(inside(rings[1], *(centre + ORIGIN)[:2]) for centre in large)


def test_sizes_among_each_other_get_none() -> None:
    small, large = _rows(0, 0), _rows(1, 1)
    assert unit_areas([_size(2.3, small), _size(2.9, large)], np.vstack([small, large]), ORIGIN) is None
    assert unit_areas([_size(2.3, small)], small, ORIGIN) is None
