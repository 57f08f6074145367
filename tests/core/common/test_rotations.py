"""Rotations that fit vectors best."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.common.rotations import closest_rotation


@pytest.mark.parametrize("seed", range(4))
def test_the_rotation_between_two_sets_of_vectors_is_found(seed: int) -> None:
    rng = np.random.default_rng(seed)
    turn, source = Rotation.random(random_state=seed).as_matrix(), rng.normal(size=(5, 3))
    found, values = closest_rotation((source @ turn.T).T @ source)
    assert found == pytest.approx(turn, abs=1e-12)
    assert (values > 0).all()


def test_a_mirror_image_gives_a_rotation_all_the_same() -> None:
    found, values = closest_rotation(np.diag([3.0, 2.0, -1.0]))
    assert np.linalg.det(found) == pytest.approx(1)
    assert values.tolist() == [3.0, 2.0, -1.0]
