"""Means of patches: what they keep of the points, and that an adjustment loses nothing by them."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.adjustment.adjustment_records import AdjustmentOptions
from tetratrack.core.adjustment.gauss_helmert import adjust
from tetratrack.core.common.patch_means import PatchMeans
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import raise_means, sample_surface
from tetratrack.core.model.unit_types import UnitType

UNIT = UnitType.tetrapod(2.5)
RADIUS = 0.015 * UNIT.height


def collected(points, parts=1, sources=None, radius=RADIUS):
    """Patches of points that come in parts."""
    sources = np.zeros(len(points), dtype=np.uint16) if sources is None else sources
    patches = PatchMeans(radius)
    for part in np.array_split(np.arange(len(points)), parts):
        patches.add(points[part], sources[part], part.astype(np.float64))
    return patches


def thinned(points, **options):
    """Means of points."""
    return collected(points, **options).means()


def test_points_count_once():
    """Numbers and weighted mean are those of the points, whatever parts they come in, and each source has its own means."""
    rng = np.random.default_rng(1)
    points = sample_surface(UNIT, 300_000, rng)[0] + [500_000.0, 3_500_000.0, 12.0]
    sources = rng.integers(1, 3, len(points)).astype(np.uint16)
    once, often = thinned(points, sources=sources), thinned(points, parts=13, sources=sources)
    assert np.array_equal(once.xyz, often.xyz)
    assert np.array_equal(once.counts, often.counts)
    # but for the few in patches left over between others
    assert 0.98 * len(points) < once.counts.sum() <= len(points)
    assert np.average(once.xyz, axis=0, weights=once.counts) == pytest.approx(points.mean(axis=0), abs=1e-3)
    for source in (1, 2):
        assert once.counts[once.sources == source].sum() == pytest.approx((sources == source).sum(), rel=0.02)
    assert once.times.min() == 0.0


def test_a_single_patch_has_the_exact_moments():
    """Mean and spread of points on a small plane, to rounding in single precision; the first seed moves into their mean."""
    rng = np.random.default_rng(5)
    points = np.array([100.05, 200.05, 3.05]) + np.column_stack([rng.uniform(-0.01, 0.01, (12, 2)), np.zeros(12)])
    means = thinned(points, radius=0.1)
    assert len(means.xyz) == 1
    assert means.xyz[0] == pytest.approx(points.mean(axis=0), abs=1e-7)
    assert means.spread[0] == pytest.approx(np.var(points[:, :2], axis=0).mean(), rel=1e-3)


def test_means_stand_for_nearly_equal_numbers():
    """Equal weights of the means lose 5 % of what weights by number would keep."""
    counts = thinned(sample_surface(UNIT, 400_000, np.random.default_rng(2))[0]).counts
    assert np.mean(counts) * np.mean(1 / counts) < 1.06


def test_stray_points_make_no_means():
    """Points off the surface, a thousandth of all, are left out instead of pulling means to them."""
    rng = np.random.default_rng(6)
    flat = np.column_stack([rng.uniform(0, 1, (100_000, 2)), np.zeros(100_000)])
    stray = np.column_stack([rng.uniform(0, 1, (100, 2)), rng.uniform(1.5 * RADIUS, 1.9 * RADIUS, 100)])
    means = thinned(np.vstack([flat, stray]))
    assert np.abs(means.xyz[:, 2]).max() < 1e-9


@pytest.mark.parametrize("noise", [0.002, 0.006])
def test_noise_is_told(noise):
    """From wide patches of a unit's surface."""
    rng = np.random.default_rng(3)
    points = sample_surface(UNIT, 200_000, rng)[0]
    assert collected(points + rng.normal(0, noise, points.shape), radius=0.03 * UNIT.height).noise() == pytest.approx(noise, rel=0.15)
    assert PatchMeans(0.1).noise() == 0.0


def test_raised_means_lie_on_the_surface():
    """Means of a leg's points lie inside it by half the curvature times their variance, until they are raised."""
    points = sample_surface(UNIT, 3_000_000, np.random.default_rng(4))[0]
    axial = (points @ UNIT.leg_directions.T).max(axis=1)
    points = points[(axial > 0.45 * UNIT.leg_length) & (axial < 0.8 * UNIT.leg_length)]
    means = thinned(points, radius=0.03 * UNIT.height)

    def outside(xyz):
        lean = xyz @ UNIT.leg_directions.T
        along = lean.max(axis=1)
        rho = np.sqrt(np.sum(xyz**2, axis=1) - along**2)
        middle = (along > 0.55 * UNIT.leg_length) & (along < 0.7 * UNIT.leg_length)
        return np.average((rho - UNIT.radius + UNIT.gradient * along)[middle], weights=means.counts[middle])

    before, after = outside(means.xyz), outside(raise_means(means.xyz, means.spread, UNIT))
    assert before < -2e-4
    assert abs(after) < 0.05 * abs(before)


@pytest.mark.parametrize(("count", "noise"), [(120_000, 0.003), (250_000, 0.005)])
def test_covariance_of_an_adjustment_stays(count, noise, monkeypatch):
    """A unit's standard deviations from means of points with white noise are those from all points within 7 %, and so is its centre.

    What residuals tell of correlation differs from sample to sample by more than that, and is left out.
    """
    monkeypatch.setattr("tetratrack.core.adjustment.parameter_covariance.correlated_part", lambda **_: np.zeros((12, 12)))
    ratios, differences = [], []
    options = AdjustmentOptions(radius_sd=0.01, gradient_sd=0.01)
    for seed in range(3):
        rng = np.random.default_rng([seed, count])
        points, normals, _ = sample_surface(UNIT, count, rng)
        seen = points[normals[:, 2] > -0.2]
        seen = seen + rng.normal(0, noise, seen.shape)
        means = thinned(seen + 10.0)
        start = Pose(np.array([0.01, -0.01, 0.01]), np.eye(3))
        full = adjust(seen, UNIT, start, options=options)
        few = adjust(raise_means(means.xyz - 10.0, means.spread, UNIT), UNIT, start, options=options)
        sds = np.sqrt(np.diag(full.covariance)[:6])
        ratios.append(np.sqrt(np.diag(few.covariance)[:6]) / sds)
        differences.append((few.pose.centre - full.pose.centre) / sds[:3])
    assert np.mean(ratios) == pytest.approx(1.0, abs=0.07)
    assert np.sqrt(np.mean(np.square(differences))) < 0.6
