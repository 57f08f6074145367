"""The size of units told from points alone: right, sure, and silent where there is none."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tetratrack.core.data.tiles import inspect_tile, read_points
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.unit_size import estimate_everywhere, estimate_sizes, trial_heights, try_size

TINY = Path(__file__).resolve().parents[2] / "data" / "tiny" / "tiles" / "2024-04-09"
HEIGHT = 2.3


@pytest.fixture(scope="module")
def points() -> np.ndarray:
    tiles = [inspect_tile(path, "EPSG:32650") for path in sorted(TINY.glob("*.laz"))]
    return read_points(tiles, "EPSG:32650").xyz


def test_size_of_a_small_survey(points: np.ndarray) -> None:
    (size,) = estimate_sizes(points, heights=[1.75, 2.05, 2.4, 2.8])
    assert size.unit.height == pytest.approx(HEIGHT, rel=0.01)
    assert abs(size.unit.height - HEIGHT) < 3 * size.uncertainty
    assert size.standard
    assert size.sure


def test_size_of_a_model_in_a_flume(points: np.ndarray) -> None:
    (size,) = estimate_sizes(points * 0.05, heights=[0.095, 0.11, 0.13])
    assert size.unit.height == pytest.approx(HEIGHT * 0.05, rel=0.01)


def test_trial_heights_span_what_points_and_extent_allow() -> None:
    rng = np.random.default_rng(5)
    heights = trial_heights(rng.uniform(0, [30, 30, 5], (90_000, 3)))
    assert heights[0] < 3
    assert 5 < heights[-1] < 8


def test_the_true_height_explains_far_more_than_others(points: np.ndarray) -> None:
    true, *others = (try_size(points, UnitType.tetrapod(HEIGHT * f)).evidence for f in (1, 0.85, 1.15))
    assert true > 5 * max(others)


@pytest.mark.slow
def test_two_sizes_beside_each_other(points: np.ndarray) -> None:
    larger = points * 1.4 + [60, 0, 0]
    heights = sorted(size.unit.height for size in estimate_everywhere(np.vstack([points, larger])))
    assert heights == pytest.approx([HEIGHT, 1.4 * HEIGHT], rel=0.01)


def test_no_size_in_rough_ground() -> None:
    rng = np.random.default_rng(3)
    flat = rng.uniform(0, 20, (40_000, 2))
    waves = rng.uniform(0.5, 3, (12, 2))
    height = sum(0.3 * np.sin(flat @ wave + phase) for wave, phase in zip(waves, rng.uniform(0, 6, 12), strict=True))
    assert estimate_sizes(np.column_stack([flat, height]), heights=[1.5, 2.3, 3.2]) == ()
