"""Planned detectability against the figures of METHOD 3, simulation of the adjustment, and its own limits."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2
from tetratrack.core.adjustment.adjustment_records import AdjustmentOptions
from tetratrack.core.adjustment.detectability import SurveyPlan, detectability, detectability_curves, point_counts, pose_bound
from tetratrack.core.adjustment.gauss_helmert import adjust
from tetratrack.core.common.noncentrality import noncentrality
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface, surface_cells
from tetratrack.core.model.unit_types import UnitType, catalogue_unit

UNIT = catalogue_unit("tetrapod 8 t") or UnitType.tetrapod(2.3)
PLAN = SurveyPlan(density=200, noise=0.02, visible_share=1.0)


def test_shape_fixed_bound_follows_the_rule_of_thumb() -> None:
    """3.2 sigma / sqrt(N) for the centre of an 8 t unit seen from above with its shape fixed (bound computed independently)."""
    found = detectability(UNIT, PLAN)
    assert found.sd_centre == pytest.approx(3.2 * PLAN.noise / math.sqrt(found.points), rel=0.1)
    assert math.degrees(found.sd_rotation) == pytest.approx(480 * PLAN.noise / (UNIT.height * math.sqrt(found.points)), rel=0.15)


def test_bound_is_reached_by_the_adjustment() -> None:
    """Scatter of adjusted centres over repeated noise equals the bound of the same points."""
    rng = np.random.default_rng(7)
    points, normals, legs = sample_surface(UNIT, 600, rng, end_discs=False)
    bound = pose_bound(UNIT, points, normals, np.ones(len(points)), 0.01, shape_fixed=True)
    assert bound is not None
    options = AdjustmentOptions(radius_sd=0, gradient_sd=0, robust=False, end_discs=False)
    start = Pose(np.zeros(3), np.eye(3))
    errors = np.array(
        [adjust(points + rng.normal(0, 0.01, points.shape), UNIT, start, options=options, legs=legs).pose.centre for _ in range(200)]
    )
    whitened = np.einsum("ni,ij,nj->n", errors, np.linalg.inv(bound[:3, :3]), errors).sum()
    assert chi2.ppf(0.001, 600) < whitened < chi2.ppf(0.999, 600)


def test_detectable_displacement_grows_as_it_must() -> None:
    base = detectability(UNIT, PLAN)
    assert detectability(UNIT, SurveyPlan(density=50, noise=0.02, visible_share=1.0)).sd_centre == pytest.approx(2 * base.sd_centre)
    assert detectability(UNIT, SurveyPlan(density=200, noise=0.04, visible_share=1.0)).sd_centre == pytest.approx(2 * base.sd_centre)
    less_seen = detectability(UNIT, SurveyPlan(density=200, noise=0.02, visible_share=0.15))
    assert less_seen.points < base.points
    assert less_seen.detectable_worst > base.detectable_worst
    free = detectability(UNIT, SurveyPlan(density=200, noise=0.02, visible_share=1.0, shape_fixed=False))
    assert free.detectable_worst > base.detectable_worst


def test_common_errors_do_not_average_out() -> None:
    """With very many points the registration alone is left: sqrt(2 lambda0) times its standard deviation."""
    found = detectability(UNIT, SurveyPlan(density=1e9, noise=0.02, registration=0.005))
    assert found.detectable_worst == pytest.approx(math.sqrt(2 * noncentrality(0.001, 0.8)) * 0.005, rel=1e-3)


def test_curves_of_the_chart_go_through_what_single_plans_give() -> None:
    plan = SurveyPlan(density=200, noise=0.02, visible_share=0.2, systematic=0.002, registration=0.003)
    curves = {curve["visible"]: curve for curve in detectability_curves(UNIT, plan)}
    assert sorted(curves) == [0.1, 0.2, 0.3, 0.6]
    own = curves[0.2]
    for k in (0, 12, 20):
        density = own["density"][k]
        expected = detectability(UNIT, replace(plan, density=density)).detectable_worst
        assert own["detectable_worst"][k] == pytest.approx(expected, rel=1e-3)


def test_noncentrality_is_baardas() -> None:
    """17.075 for one degree of freedom, 0.1 % and 80 % (Baarda, 1968: delta0 = 4.13)."""
    assert noncentrality(0.001, 0.8, 1) == pytest.approx(4.13**2, rel=2e-3)


def test_points_lie_on_what_faces_the_instrument() -> None:
    cells = surface_cells(UNIT)
    up = np.array([0.0, 0.0, 1.0])
    counts = point_counts(UNIT, cells, up, 100.0, 1.0)
    assert (counts[cells[1][:, 2] <= 0] == 0).all()
    assert (counts > 0).any()


def test_too_few_points_are_said_so() -> None:
    with pytest.raises(ValueError, match="raise the density"):
        detectability(UNIT, SurveyPlan(density=0.5, noise=0.02, visible_share=0.05))


@pytest.mark.parametrize("bad", [{"density": 0}, {"noise": -1}, {"visible_share": 0}, {"tilt": 4}, {"power": 0.0001}, {"registration": -1}])
def test_impossible_plans_are_refused(bad: dict[str, float]) -> None:
    with pytest.raises(ValueError, match=next(iter(bad))):
        SurveyPlan(**{"density": 100, "noise": 0.02, **bad})
