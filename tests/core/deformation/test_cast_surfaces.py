"""Surfaces of castings during the joint adjustment: what sightings share, and what they do not."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.adjustment.shape_effects import CELLS, CellSums
from tetratrack.core.deformation.cast_surfaces import CastSurfaces


def test_a_sighting_that_is_not_tied_says_what_it_says_alone() -> None:
    rng = np.random.default_rng(3)
    surfaces = CastSurfaces(2.0)
    weight = np.where(rng.random(CELLS) < 0.3, 1e7, 0.0)
    pair = []
    for k in range(2):
        rows = np.zeros((CELLS, 13))
        rows[:, 6 * k : 6 * k + 6] = rng.normal(size=(CELLS, 6)) * weight[:, None]
        values = rng.normal(0, 0.003, CELLS)
        pair.append(CellSums(rows, weight, -weight * values, weight * values**2, 0.002))
    empty, nothing = np.zeros((13, 13)), np.zeros(13)
    apart = surfaces.reduced(0, empty, nothing, pair, [True, False])
    alone = [surfaces.reduced(0, empty, nothing, [sums], [True]) for sums in pair]
    assert apart.normal == pytest.approx(alone[0].normal + alone[1].normal)
    assert apart.rhs == pytest.approx(alone[0].rhs + alone[1].rhs)
    assert len(apart.own) == 2
    assert np.abs(surfaces.reduced(0, empty, nothing, pair, [True, True]).normal[:6, 6:12]).max() > 0
    assert not apart.normal[:6, 6:12].any()
