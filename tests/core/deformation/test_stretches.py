"""Common motion of stretches against errors that neighbours share."""

from __future__ import annotations

import math

import numpy as np
from bent_coast import DIRECTION, bent_coast
from tetratrack.core.deformation.congruence import congruence_of
from tetratrack.core.deformation.stretches import JudgedUnits, StretchMotion, motions_of_stretches

HEIGHT = 2.3
PATCH = 12.0
"""Length over which units share an error, metres: what one tripod sees best."""


def stretches(seed: int, shared: float, slide: tuple[float, float] | None = None) -> list[StretchMotion]:
    """Of a stiff coast whose units share errors of ``shared`` metres within every patch."""
    coast = bent_coast(seed, rms=0.0, slide=slide, unit_sd=0.001)
    patch = (coast.places[:, :2] @ DIRECTION / PATCH).astype(np.int64)
    errors = np.random.default_rng(seed).normal(0, shared * math.sqrt(2), (patch.max() + 1, 3))
    vectors = coast.displacements + errors[patch]
    origin = coast.places.mean(axis=0)
    found = congruence_of(vectors, coast.covariances, coast.places, None, origin, HEIGHT)
    units = JudgedUnits(places=coast.places, vectors=vectors, covariances=found.null.covariance(coast.covariances))
    return motions_of_stretches(units, found, None, HEIGHT)["stable"]


def test_errors_that_neighbours_share_are_no_motion() -> None:
    coasts = [stretches(seed, 0.002) for seed in range(10)]
    assert np.mean([any(s.adjusted < 0.05 for s in coast) for coast in coasts]) <= 0.2
    assert 0.5 < np.mean([s.motion @ np.linalg.solve(s.covariance, s.motion) / 3 for coast in coasts for s in coast]) < 2.0


def test_units_with_errors_of_their_own_show_no_motion_of_stretches() -> None:
    assert not any(s.adjusted < 0.05 for seed in range(10) for s in stretches(seed, 0.0))


def test_a_slide_stands_out_of_them() -> None:
    for seed in range(5):
        coast = stretches(seed, 0.002, slide=(72.0, 96.0))
        inside = [s for s in coast if s.along_from >= 68 and s.along_to <= 100]
        apart = [s for s in coast if s.along_to <= 72 or s.along_from >= 96]
        assert all(s.adjusted < 0.05 for s in inside)
        assert sum(s.adjusted < 0.05 for s in apart) <= 1
        assert inside
