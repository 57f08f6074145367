"""Bends of long structures, of which one window of the likelihood holds a part."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from curved_structures import line_of, units_along
from tetratrack.core.registration.bending import estimate_bending, explained
from tetratrack.core.registration.shift_samples import ShiftSample

SPACING = 1.5
"""Of cells along the structure, metres."""


def long_sample(seed: int, count: int, slide: tuple[float, float] | None = None) -> ShiftSample:
    """Cells of a structure that bends by 3 cm over 100 m and more, each known to 2 mm; a slide is 10 cm."""
    rng = np.random.default_rng(seed)
    along = SPACING * np.arange(count)
    phases = rng.uniform(0, 2 * np.pi, (3, 4))
    lengths = rng.uniform(100, 300, (3, 4))
    bend = 0.02 * np.sin(2 * np.pi * along[:, None, None] / lengths + phases).sum(axis=2)
    values = bend + rng.normal(0, 0.002, bend.shape)
    if slide is not None:
        values[(along > slide[0]) & (along < slide[1])] += [0.07, 0.0, -0.07]
    return ShiftSample(
        places=np.column_stack([along, rng.uniform(0, 10, count)]),
        values=values,
        variances=np.full(values.shape, 0.002**2),
        fixed=np.zeros(count, dtype=bool),
    )


def test_cells_of_a_whole_long_coast_rest() -> None:
    sample = long_sample(1, 800)
    found = estimate_bending(sample, 2.4)
    assert found.model is not None
    assert len(explained(sample, found.model, found.line)) > 0.98 * 800


def test_a_slide_anywhere_on_a_long_coast_is_no_bend() -> None:
    for middle in (200.0, 300.0, 400.0):
        sample = long_sample(2, 400, (middle - 12, middle + 12))
        jumps = estimate_bending(sample, 2.4).jumps
        assert len(jumps) == 1
        np.testing.assert_allclose(jumps[0], (middle - 12, middle + 12), atol=3.0)


def test_a_slide_of_one_arm_is_none_of_the_other() -> None:
    """Two arms of a harbour bend smoothly over the ground, and a stretch of one slides by 10 cm."""
    for seed in range(3):
        places, chainage, _ = units_along(line_of("U"), seed)
        places, chainage = places[::4, :2], chainage[::4]
        rng = np.random.default_rng(seed)
        values = 0.03 * np.sin(2 * np.pi * (places @ rng.normal(0, 0.005, (2, 3))) + rng.uniform(0, 6, 3))
        sliding = (chainage > 90) & (chainage < 114)
        values = values + rng.normal(0, 0.002, values.shape) + sliding[:, None] * [0.07, 0.0, -0.07]
        sample = ShiftSample(
            places=places, values=values, variances=np.full(values.shape, 0.002**2), fixed=np.zeros(len(values), dtype=bool)
        )
        found = estimate_bending(sample, 2.4)
        assert len(found.jumps) == 1
        assert found.jumped(places)[sliding].mean() > 0.8
        assert found.jumped(places)[np.abs(chainage - 102) > 17].mean() < 0.01


@pytest.mark.parametrize(("slopes", "bends"), [((0.0015, 0.0), True), ((0.0, 0.0015), False), ((0.0, 0.0), False)])
def test_a_stretch_along_the_whole_structure_is_a_bend_and_a_turn_is_none(slopes: tuple[float, float], bends: bool) -> None:
    """Heights bend; in plan nothing but a slope is seen: across the structure it is a turn, along it no rigid motion."""
    sample = long_sample(3, 50)
    along = sample.places[:, :1]
    noise = np.random.default_rng(4).normal(0, 0.002, (len(along), 2))
    plan = replace(sample, values=np.hstack([along * np.array(slopes) + noise, sample.values[:, 2:]]))
    model = estimate_bending(plan, 2.4).model
    assert model is not None
    assert model.sds[2] > 0
    assert (model.sds[0] > 0.01) == bends
    assert model.sds[1] < 0.01
