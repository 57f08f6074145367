"""Points of one voxel become their mean."""

from __future__ import annotations

import numpy as np
from tetratrack.core.common.voxels import thin


def test_voxels_are_in_order_and_hold_the_mean_of_their_points():
    rng = np.random.default_rng(4)
    for count, extent in ((1, 1.0), (5000, 3.0), (5000, 1e4)):
        points = rng.uniform(-extent, extent, (count, 3))
        means, source = thin(points, 0.25)
        voxels, wanted, counts = np.unique(np.floor(points / 0.25), axis=0, return_inverse=True, return_counts=True)
        assert source.tolist() == wanted.ravel().tolist()
        sums = np.zeros((len(voxels), 3))
        np.add.at(sums, wanted.ravel(), points)
        np.testing.assert_array_equal(means, sums / counts[:, None])


def test_nothing_has_no_voxels():
    means, source = thin(np.empty((0, 3)), 0.25)
    assert means.shape == (0, 3)
    assert source.shape == (0,)
