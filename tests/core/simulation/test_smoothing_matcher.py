"""Image matching bridges narrow hollows, and nothing else."""

from __future__ import annotations

import numpy as np
import pytest
from tetratrack.core.common.errors import InputError
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.simulation.armour_pile import PiledUnit
from tetratrack.core.simulation.smoothing_matcher import MatchedView, closed
from tetratrack.core.simulation.survey_plan import SimulationPlan
from tetratrack.core.simulation.virtual_instruments import Instrument
from tetratrack.core.simulation.virtual_scanner import ISLAND_HEIGHTS, MISMATCHED, WRONG_DEPTH_HEIGHTS, Returns, mismatched
from tetratrack.core.simulation.virtual_scene import OUTLIER, Scene, Surfaces

SPACING = 0.02
X, Y = np.meshgrid(np.arange(-1, 1, SPACING), np.arange(-1, 1, SPACING), indexing="ij")


def test_a_gap_sinks_by_the_sagitta_of_the_paraboloid_and_its_rims_stay() -> None:
    """Between rims a distance w apart a paraboloid of radius R hangs down by w squared over 8 R."""
    half, radius = 0.2, 0.5
    surface = np.where(np.abs(X) < half - 1e-9, -1.0, 0.0)
    filled = closed(surface, radius, SPACING)
    middle = np.argmin(np.abs(X[:, 0]))
    assert filled[middle] == pytest.approx(-(half**2) / (2 * radius))
    assert np.array_equal(filled[np.abs(X) >= half - 1e-9], surface[np.abs(X) >= half - 1e-9])


def test_convex_and_wide_hollow_surfaces_stay_also_where_they_are_tilted() -> None:
    radius = 0.3
    for surface in (-(X**2 + Y**2) / 0.4, (X**2 + Y**2) / (4 * radius), -np.hypot(X, Y)):
        for tilt in (0.0, 0.4):
            tilted = surface + tilt * (X + 0.5 * Y)
            inner = (np.abs(X) < 0.3) & (np.abs(Y) < 0.3)
            # the paraboloid touches at pixels only
            assert closed(tilted, radius, SPACING)[inner] == pytest.approx(tilted[inner], abs=SPACING**2 / radius)


def test_a_hollow_narrower_than_the_paraboloid_is_filled_to_its_surface() -> None:
    groove = X**2 / (2 * 0.1)
    filled = closed(np.minimum(groove, 0.1), 0.4, SPACING)
    assert (filled - np.minimum(groove, 0.1)).max() > 0.02
    assert (filled >= np.minimum(groove, 0.1)).all()


def test_a_radius_below_nought_is_refused() -> None:
    with pytest.raises(InputError, match="bridging"):
        SimulationPlan("s", "photogrammetry", bridging=-0.1)


@pytest.mark.parametrize("instrument", ["uav", "tls", "depth_camera"])
def test_an_instrument_that_matches_no_images_refuses_it(instrument: Instrument) -> None:
    with pytest.raises(InputError, match=f"{instrument} bridges no hollows"):
        SimulationPlan("s", instrument, bridging=0.1)
    assert SimulationPlan("s", instrument).bridging == 0


class _Floor:
    """Two blocks with a gap of 0.2 m between them, seen from above: tops at height 0, floor at -1."""

    unit = site = None

    def cast(self, origins: np.ndarray, directions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        top = -origins[:, 2] / directions[:, 2]
        gap = np.abs(origins[:, 0] + top * directions[:, 0]) < 0.1
        return np.where(gap, (-1 - origins[:, 2]) / directions[:, 2], top), np.ones(len(top), dtype=np.int64), -directions[:, 2]


def test_an_image_shows_a_gap_bridged_and_the_rest_where_it_is() -> None:
    camera = np.array([0.0, 0.0, 20.0])
    aims = np.column_stack([X.ravel(), Y.ravel(), np.zeros(X.size)])
    directions = aims - camera
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    origins = np.broadcast_to(camera, directions.shape)
    distance, _, _ = MatchedView(_Floor(), camera, aims, 0.3, SPACING).cast(origins, directions)  # type: ignore[arg-type]
    height = (origins + distance[:, None] * directions)[:, 2].reshape(X.shape)
    inner = np.abs(Y) < 0.6
    assert height[inner & (np.abs(X) > 0.15) & (np.abs(X) < 0.6)] == pytest.approx(0.0, abs=1e-3)
    assert height[inner & (np.abs(X) < 0.03)] == pytest.approx(-(0.1**2) / 0.6, abs=0.01)


@pytest.mark.parametrize("castings", [False, True])
def test_bridges_reach_no_farther_than_hollows_are_deep(castings: bool) -> None:
    """An image of a real scene has no pixel without a depth amid a unit, which would pull its neighbours away."""
    unit = UnitType.tetrapod(2.0)
    pile = tuple(PiledUnit(k + 1, Pose(np.array([1.7 * k, 0.0, 1.0]), np.eye(3)), 1.0) for k in range(2))
    scene = Scene(pile, unit, None, Surfaces(roughness=0.003, fillet=0.05, chamfer=0.03, growth=0.0, castings=castings), seed=8)
    body, _, _ = sample_surface(unit, 4000, np.random.default_rng(2))
    aims, camera = np.vstack([own.pose.to_frame(body) for own in pile]), np.array([0.5, 4.0, 20.0])
    directions = (aims - camera) / np.linalg.norm(aims - camera, axis=1)[:, None]
    origins = np.broadcast_to(camera, directions.shape)
    there, label, _ = scene.cast(origins, directions)
    drawn, _, _ = MatchedView(scene, camera, aims, 0.15, 0.03).cast(origins, directions)
    met = np.isfinite(there) & (label > 0)
    assert np.abs(drawn[met] - there[met]).max() < 2 * unit.height


def test_hollows_that_few_images_see_leave_islands_at_a_wrong_depth() -> None:
    """A floor of 400 patches seen from above: whole patches stay or go, each at one depth, and none counts as surface."""
    size, camera = ISLAND_HEIGHTS, np.array([0.0, 0.0, 1e6])
    x, y = (g.ravel() for g in np.meshgrid(np.arange(0.025, 2, 0.05), np.arange(0.025, 2, 0.05)))
    floor = np.column_stack([x, y, np.full(x.size, 0.01)])
    one = np.ones(x.size)
    weak = Returns(
        floor, one.astype(np.int64), one.astype(np.int64), one.astype(np.uint16), one, one.astype(np.uint8), one.astype(np.uint8),
        np.tile(camera, (x.size, 1)),
    )  # fmt: skip
    islands = mismatched(weak, 1.0, np.random.default_rng(4))
    assert (islands.labels == OUTLIER).all()
    _, own, count = np.unique(np.floor(islands.points[:, :2] / size + 1e-4), axis=0, return_inverse=True, return_counts=True)
    assert (count == 4).all()
    assert len(count) / 400 == pytest.approx(MISMATCHED, abs=3 * np.sqrt(MISMATCHED * (1 - MISMATCHED) / 400))
    depths = [islands.points[own.ravel() == k, 2] - 0.01 for k in range(len(count))]
    assert max(np.ptp(d) for d in depths) < 1e-6
    assert np.std([d[0] for d in depths]) == pytest.approx(WRONG_DEPTH_HEIGHTS, rel=0.25)
    nothing = weak.chosen(np.zeros(x.size, dtype=np.bool_))
    assert len(mismatched(nothing, 1.0, np.random.default_rng(4)).points) == 0
