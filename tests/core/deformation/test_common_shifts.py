"""A shift of all units is told from units that went their own ways."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.deformation.common_shifts import common_shift, whole_shift


@pytest.mark.parametrize("count", [3, 4, 60, 900])
def test_a_common_shift_of_any_length_is_found(count: int) -> None:
    rng = np.random.default_rng(count)
    before = rng.uniform(0, 10 * np.sqrt(count), (count, 3))
    after = before + np.array([0.3, -0.2, 20.3]) + rng.normal(0, 0.02, (count, 3))
    shift = whole_shift(before, after, 2.3)
    assert shift == pytest.approx([0.3, -0.2, 20.3], abs=0.05)


def test_other_units_have_no_common_shift() -> None:
    rng = np.random.default_rng(1)
    assert whole_shift(rng.uniform(0, 60, (40, 3)), rng.uniform(0, 60, (40, 3)), 2.3) is None
    assert whole_shift(np.zeros((2, 3)), np.ones((2, 3)), 2.3) is None


def test_common_shift_ignores_units_that_moved_on_their_own() -> None:
    rng = np.random.default_rng(5)
    before = rng.uniform(0, 14, (40, 3))
    after = before + rng.normal(0, 0.005, before.shape)
    after[:15] += rng.normal(0, 0.3, (15, 3))
    assert np.linalg.norm(common_shift(before, after, 2.3)) < 0.005
    assert not common_shift(before[:2], after[:2], 2.3).any()
