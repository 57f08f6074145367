"""Surfaces of castings during the joint adjustment: what sightings share, and what they do not."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.adjustment.shape_effects import CELLS, LEG_CELLS, CellSums
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


def test_a_unit_that_departs_more_than_others_is_known_less() -> None:
    rng = np.random.default_rng(4)
    surfaces = CastSurfaces(2.0)
    # nothing ties two legs
    root = np.kron(np.eye(4), np.linalg.cholesky(surfaces.model.covariance + 1e-12 * np.eye(LEG_CELLS)))
    sizes = [*np.full(8, 0.8), 2.4]
    for unit, size in enumerate(sizes):
        weight = np.where(rng.random(CELLS) < 0.2, 1e7, 0.0)
        values = size * (root @ rng.normal(size=CELLS) + rng.normal(0, 1e7**-0.5, CELLS))
        sums = CellSums(rng.normal(size=(CELLS, 7)) * weight[:, None], weight, -weight * values, weight * (values**2 + 4e-6), 0.002)
        surfaces.keep(unit, 0.0, surfaces.reduced(unit, np.eye(7), np.zeros(7), [sums], [True]), [sums], 7)
        assert surfaces.factors() == {} or unit >= 5
    factors = surfaces.factors()
    assert factors[8] == pytest.approx((2.4 / 0.8) ** 2, rel=0.3)
    assert 1 <= min(factors.values()) < 1.1
    assert max(factors[unit] for unit in range(8)) < 1.4
