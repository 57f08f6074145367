"""The paper's printed model, as the replication uses it."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.benchmarks.replication.literal_model import fit_literal, literal_axes, literal_start
from tetratrack.core.model.feature_points import body_features
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType


def test_printed_rotations_stand_at_120_degrees_and_bend_when_tilted() -> None:
    upright = literal_axes(0.0, 0.4)
    angles = np.degrees(np.arccos(np.clip(upright @ upright.T, -1, 1)))
    assert angles[0, 1:] == pytest.approx(np.full(3, 120.0))
    assert angles[1, 2] == pytest.approx(97.18, abs=0.01)
    tilted = literal_axes(math.radians(10), 0.0)
    spread = np.degrees(np.arccos(np.clip(tilted @ tilted.T, -1, 1)))
    assert np.ptp(spread[0, 1:]) > 10


def test_printed_model_is_fitted_with_its_angles() -> None:
    rng = np.random.default_rng(5)
    unit = UnitType.tetrapod(2.3, opening="paper")
    # upright, the printed model is the rigid 120-degree solid
    pose = Pose(np.array([1.0, 2.0, 3.0]), Rotation.from_euler("z", 25, degrees=True).as_matrix())
    body, _, leg = sample_surface(unit, 3000, rng, end_discs=False)
    points = pose.to_frame(body) + rng.normal(0, 0.01, body.shape)
    omega, psi = literal_start(pose)
    axes = literal_axes(omega, psi)
    order = np.argmax((unit.leg_directions @ pose.rotation.T) @ axes.T, axis=1)
    assert sorted(order) == [0, 1, 2, 3]
    fit = fit_literal(points, unit, pose.centre + np.array([0.03, -0.02, 0.02]), omega + 0.03, psi + 0.03, legs=order[leg])
    assert fit.converged
    found = np.array([*fit.centre - pose.centre, fit.omega - omega, fit.psi - psi, fit.radius - unit.radius, fit.gradient - unit.gradient])
    assert (np.abs(found) < 4 * np.sqrt(np.diag(fit.covariance))).all()
    assert fit.noise == pytest.approx(0.01, rel=0.05)
    assert body_features(unit).shape == (5, 3)
