"""Presence of missing units: there, gone, or hidden."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import UNIT, seen_from_above
from tetratrack.core.deformation.presence import look_up, settled_on
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate

POSE = Pose(np.array([0.0, 0.0, 0.0]), Rotation.from_euler("xyz", [0.3, 0.4, 0.5]).as_matrix())


def bed(rng: np.random.Generator, hidden_under: Pose | None) -> np.ndarray:
    """Ground below the unit, without what the unit hides from above."""
    flat = np.column_stack([rng.uniform(-2.5, 2.5, (6000, 2)), np.full(6000, -1.5) + rng.normal(0, 0.01, 6000)])
    if hidden_under is None:
        return flat
    heights = np.linspace(-1.4, 1.5, 30)
    column = flat[:, None] + np.array([0, 0, 1.0]) * (heights[:, None] + 1.5)[None]
    inside = (relate(hidden_under.to_body(column.reshape(-1, 3)), UNIT).distance < 0).reshape(len(flat), -1).any(axis=1)
    return np.asarray(flat[~inside])


def test_presence_tells_there_from_gone_from_hidden() -> None:
    rng = np.random.default_rng(0)
    own = seen_from_above(POSE, rng, 2000, 0.01).points
    before = np.vstack([own, bed(rng, POSE)])
    there = look_up(own, POSE, UNIT, before, np.vstack([seen_from_above(POSE, rng, 900, 0.01).points, bed(rng, POSE)]), 0.05)
    assert there.state == "there"
    assert there.support > 0.8
    gone = look_up(own, POSE, UNIT, before, bed(rng, None), 0.05)
    assert gone.state == "empty"
    assert gone.support < 0.1
    cover = POSE.shifted([0, 0, 2.0])
    roof = np.column_stack([rng.uniform(-2, 2, (5000, 2)), np.full(5000, 1.9)])
    assert look_up(own, POSE, UNIT, before, np.vstack([roof, seen_from_above(cover, rng, 500, 0.01).points]), 0.05).state == "hidden"
    assert look_up(own, POSE, UNIT, before, np.empty((0, 3)), 0.05).state == "hidden"


@pytest.mark.parametrize("way", [0.0, 0.05, 0.09, 0.12])
def test_a_unit_that_moved_is_brought_onto_its_own_points(way: float) -> None:
    rng = np.random.default_rng(3)
    points = np.vstack([seen_from_above(POSE, rng, 1500, 0.015).points, bed(rng, POSE)])
    predicted = POSE.shifted(way * UNIT.height * np.array([0.8, 0.5, -0.33]))
    found = settled_on(points, predicted, UNIT, 0.025 * UNIT.height)
    assert np.linalg.norm(found.centre - POSE.centre) < 0.004
    # nor do some more points that chance gathers on another pose, half as many as would tell
    away = predicted.shifted([0.0, 0.0, -0.4])
    some = np.vstack([seen_from_above(predicted, rng, 400, 0.01).points, seen_from_above(away, rng, 425, 0.01).points])
    assert settled_on(some, predicted, UNIT, 0.025 * UNIT.height) is predicted
    # nothing to be brought onto
    assert settled_on(bed(rng, None), predicted, UNIT, 0.025 * UNIT.height) is predicted
