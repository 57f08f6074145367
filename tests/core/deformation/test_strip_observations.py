"""Patches of a sighting that hold far fewer points than most are left out."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.adjustment.shape_effects import CELLS
from tetratrack.core.deformation.strip_observations import THIN_SHARE, leave_out_thin


@pytest.mark.parametrize("count", [0, 1, 2, 3, 10, 500, 501])
def test_thin_patches_are_those_below_a_share_of_the_median(count: int) -> None:
    rng = np.random.default_rng(count)
    for _ in range(20):
        patches = np.minimum(rng.geometric(1 / (1 + 40 * rng.random()), count) - 2, CELLS - 1)
        held = np.bincount(patches[patches >= 0], minlength=CELLS)
        thin = held < THIN_SHARE * np.median(held[held > 0]) if held.any() else np.ones(CELLS, dtype=bool)
        expected = np.where((patches < 0) | thin[patches], -1, patches)
        leave_out_thin(patches, np.zeros(CELLS, dtype=np.int64))
        assert (patches == expected).all()
