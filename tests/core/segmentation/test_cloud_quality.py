"""Density and noise of clouds, as they decide how much of a pile is found."""

import numpy as np
import pytest
from tetratrack.core.segmentation.cloud_quality import cloud_quality
from tetratrack.core.segmentation.surface_elements import SMOOTH_SHARE, surface_noise

HEIGHT = 2.0


def cylinders(per_square: float, noise: float, seed: int = 0) -> np.ndarray:
    """Upper halves of cylinders as thick as legs, side by side over 8 x 8 m, with so many points per H² from above and so much noise."""
    rng = np.random.default_rng(seed)
    count = int(per_square * 64 / HEIGHT**2)
    radius = 0.25 * HEIGHT
    x, y = rng.uniform(0, 8, (2, count))
    across = (x % (2 * radius)) - radius
    z = np.sqrt(np.maximum(radius**2 - across**2, 0.0))
    return np.column_stack([x, y, z]) + rng.normal(0, noise * HEIGHT, (count, 3))


@pytest.mark.parametrize("noise", [0.005, 0.02, 0.033])
def test_noise_beyond_the_spacing_is_seen_whole(noise: float) -> None:
    # 25 neighbours of 6000 points per H² lie within 0.04 H: less than three standard deviations of the larger noises
    found = surface_noise(cylinders(6000, noise), HEIGHT) / HEIGHT
    assert found == pytest.approx(SMOOTH_SHARE * noise, rel=0.15)


@pytest.mark.parametrize("density", [60, 100, 130, 200, 400])
def test_noise_of_sparse_clouds_is_told_from_fewer_neighbours(density: float) -> None:
    """Hardly a point of them has 25 neighbours within 0.2 H: noise was 0 or three times too large by chance. Wide cells bend a little."""
    found = [surface_noise(cylinders(density, 0.009, seed), HEIGHT) / HEIGHT / SMOOTH_SHARE for seed in range(4)]
    assert found == pytest.approx(np.full(4, 1.15 * 0.009), rel=0.2)


@pytest.mark.parametrize(("density", "noise"), [(4000, 0.007), (400, 0.013), (200, 0.01)])
def test_quality_of_a_cloud(density: float, noise: float) -> None:
    quality = cloud_quality(cylinders(density, noise), HEIGHT)
    assert quality is not None
    assert quality.density == pytest.approx(density, rel=0.15)
    assert quality.noise == pytest.approx(noise, rel=0.3)


def test_a_handful_of_points_tells_nothing() -> None:
    assert cloud_quality(cylinders(2, 0.01), HEIGHT) is None
