"""Layers that images leave before a surface are taken off, and nothing where a cloud has none."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.common.voxels import thin
from tetratrack.core.model.tetrapod import relate
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.innermost_layer import innermost_layer
from tetratrack.core.segmentation.pose_score import BRIDGED, LAYERED, TypicalUnit, score, typical_unit
from tetratrack.core.segmentation.scene import Evidence, Scene
from tetratrack.core.segmentation.segment import FOUND_SCORE, cloud_elements, segment
from tetratrack.core.segmentation.surface_elements import THINNING_RATIO
from tetratrack.core.simulation.sampled_unit import cloud_of, interlocked_poses

UNIT = UnitType.tetrapod(2.3)
H = UNIT.height
ROWS = interlocked_poses(UNIT, columns=3, lower_rows=2, upper_rows=1)


def seen_from_above(noise: float) -> np.ndarray:
    """Points on what faces upwards of every unit."""
    points = cloud_of(UNIT, ROWS, noise, np.random.default_rng(5), count=30000).points
    nearest = np.argmin([np.abs(relate(pose.to_body(points), UNIT).distance) for pose in ROWS], axis=0)
    rises = [(relate(pose.to_body(points), UNIT).normal @ pose.rotation.T)[:, 2] for pose in ROWS]
    return np.asarray(points[np.array(rises)[nearest, np.arange(len(points))] > 0])


@pytest.fixture(scope="module")
def layered() -> tuple[np.ndarray, np.ndarray]:
    """Cloud that is bridged on three quarters of its places, and which of its points are of the surface."""
    rng = np.random.default_rng(9)
    points = seen_from_above(0.002 * H)
    _, place = thin(points, 0.3 * H)
    bridged = (rng.random(place.max() + 1) < 0.75)[place] & (rng.random(len(points)) < 0.6)
    before = points + np.array([0.0, 0.0, 1.0]) * rng.uniform(0.0, 0.1 * H, len(points))[:, None]
    return np.where(bridged[:, None], before, points), ~bridged


def layer_of(points: np.ndarray) -> np.ndarray | None:
    return innermost_layer(points, thin(points, THINNING_RATIO * H)[0], H)


def distances(points: np.ndarray) -> np.ndarray:
    """Unsigned distance of each point to the nearest unit's surface, in heights."""
    return np.min([np.abs(relate(pose.to_body(points), UNIT).distance) for pose in ROWS], axis=0) / H


def test_layers_before_the_surface_are_taken_off(layered):
    points, on_surface = layered
    kept = layer_of(points)
    assert kept is not None
    assert np.mean(kept[on_surface]) > 0.7
    far = distances(points) > 0.015
    assert np.mean(far) > 0.2
    assert np.mean(far[kept]) < 0.2 * np.mean(far)


@pytest.mark.parametrize("noise", [0.002, 0.013, 0.033])
def test_noise_alone_makes_no_layers(noise):
    assert layer_of(seen_from_above(noise * H)) is None


@pytest.mark.parametrize("roughness", [0.01, 0.03])
def test_rock_around_few_units_is_rough_and_no_layers(roughness):
    """As uneven as where layers are, but to both sides of what is smooth."""
    rng = np.random.default_rng(8)
    units = seen_from_above(0.002 * H)
    low, high = units.min(axis=0) - 2 * H, units.max(axis=0) + 2 * H
    rock = np.column_stack([rng.uniform(low[:2], high[:2], (250_000, 2)), np.full(250_000, units[:, 2].min())])
    rock[:, 2] += rng.normal(0, roughness * H, len(rock))
    cloud = np.vstack([units, rock])
    assert cloud_elements(cloud, UNIT).kept.all()
    assert not cloud_elements(cloud, UNIT).elements.layered


def test_a_cloud_too_small_to_tell_has_none():
    assert layer_of(seen_from_above(0.002 * H)[:40]) is None
    assert layer_of(np.zeros((0, 3))) is None


def test_little_of_a_unit_is_enough_behind_layers():
    # a quarter of a unit of a simulated pile, and what was best in rock: support, close, inside, cells, legs, misfit, reached
    seen = Evidence(np.array([[342.0, 369.0, 7.0, 19.0, 2.0, 0.66, 473.0], [229.0, 291.0, 11.0, 18.0, 3.0, 0.84, 475.0]]))
    unit, rock = score(seen, 1.0, TypicalUnit(misfit=0.63, agreement=0.97, model=LAYERED))
    assert unit > FOUND_SCORE > 0.2 > rock
    assert score(seen[:1], 1.0, TypicalUnit(misfit=0.63, agreement=0.97, model=BRIDGED)) < 0.3


def test_clouds_with_layers_have_a_score_of_their_own(layered):
    cloud = cloud_elements(layered[0], UNIT)
    assert cloud.elements.layered
    assert typical_unit(Evidence.joined([]), Scene.of(cloud.elements, UNIT, cloud.tolerance)).model is LAYERED


def test_units_are_found_behind_layers(layered):
    points, _ = layered
    result = segment(points, UNIT)
    found = [u for u in result.units if u.status == "found"]
    away = [np.min([np.linalg.norm(u.pose.centre - pose.centre) for u in found]) for pose in ROWS]
    assert max(away) < 0.02 * H
    assert len(found) == len(ROWS)
    # what lies before the surface is no unit's
    assert np.mean(distances(points[result.labels >= 0]) > 0.015) < 0.05
