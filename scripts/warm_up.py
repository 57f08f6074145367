"""Loops compiled ahead of the first run, at set-up, by what a run does: a small simulated survey goes from tiles to displacements.

numba compiles a loop when it is first called, with the kinds of arrays it is called with, and keeps the code
(`core.common.compiled_code`). A list of loops and kinds written down here would silently fall behind the code; a run cannot.
"""

from __future__ import annotations

import compileall
import multiprocessing
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

from ..core.adjustment.adjustment_records import AdjustmentOptions
from ..core.adjustment.gauss_helmert import adjust
from ..core.armour.contacts import free_gaps
from ..core.common.arrays import FloatArray
from ..core.common.feedback import Feedback
from ..core.common.patch_means import PatchMeans
from ..core.data.survey_reader import read_survey
from ..core.model.pose import Pose
from ..core.model.tetrapod import sample_surface
from ..core.model.unit_types import UnitType
from ..core.pipeline.run_options import RunOptions
from ..core.pipeline.whole_survey import run_survey
from ..core.segmentation.scene import Scene
from ..core.segmentation.sensor_places import Solids
from ..core.segmentation.shared_noise import neighbours_share_noise
from ..core.segmentation.smoothed_surface import smoothed
from ..core.segmentation.surface_elements import surface_elements
from ..core.segmentation.whole_unit_search import poses_about_elements
from ..core.simulation.survey_plan import plan_of
from ..core.simulation.virtual_survey import simulate_survey

PACKAGE = Path(__file__).resolve().parents[1]
UNITS = 16
"""More than the fewest of which a placement is stated."""
POINTS = 1500
NOISE = 0.01
"""Standard deviation of the points of the unit that is adjusted, metres."""


def warm_up(feedback: Feedback) -> float:
    """Compile what runs need and keep it, in two processes; seconds that took.

    The adjustment compiles aside while the survey is simulated and its units are searched.
    """
    began = time.monotonic()
    keep_bytecode(PACKAGE)
    aside = multiprocessing.get_context("spawn").Process(target=fit_a_unit, daemon=True)
    aside.start()
    try:
        with tempfile.TemporaryDirectory() as folder:
            plan = plan_of("uav", "warm_up", None, units=UNITS, epochs=2, seed=1, density=None, noise=None, crs="EPSG:32650")
            survey = read_survey(simulate_survey(plan, Path(folder) / "survey"))
            quiet = Feedback(progress=feedback.progress, is_cancelled=feedback.is_cancelled)
            run_survey(survey, Path(folder) / "result.gpkg", RunOptions(workers=1), quiet)
        aside.join()
    finally:
        aside.kill()
    return time.monotonic() - began


def keep_bytecode(package: Path) -> None:
    """Keep Python's own code of the modules of ``core`` and ``scripts`` beside them, where the folder can be written.

    Where Python is told to write none by itself (``PYTHONDONTWRITEBYTECODE``) every process of every run would make it anew.
    """
    for folder in ("core", "scripts"):
        compileall.compile_dir(package / folder, quiet=2)


def fit_a_unit() -> None:
    """Adjust a unit made up to points that are equally good, and to points with covariances of their own.

    By the time elements are formed here the survey's process has compiled that loop: none is compiled by both.
    """
    rng = np.random.default_rng(1)
    unit = UnitType.tetrapod(2.3)
    points, _, _ = sample_surface(unit, POINTS, rng)
    points = points + rng.normal(0.0, NOISE, points.shape)
    start = Pose(np.full(3, 0.02), np.eye(3))
    for covariances in (None, np.tile(NOISE**2 * np.eye(3), (POINTS, 1, 1))):
        adjust(points, unit, start, options=AdjustmentOptions(radius_sd=0.01, gradient_sd=0.01), covariances=covariances)
    # at the survey's end
    shapes = [replace(unit.in_body, centre=centre) for centre in np.diag([0.0, 0.0, unit.height])[1:]]
    free_gaps(shapes, np.array([[0, 1]]))
    # the survey's noise is not so large that its elements are smoothed, nor its points so few that whole units are searched for
    elements = surface_elements(points, unit.height, workers=1)
    neighbours_share_noise(points, elements.points, unit.height, NOISE)
    smoothed(points, elements, unit.height)
    scene = Scene.of(elements, unit, 2 * NOISE)
    poses_about_elements(scene, np.ones(len(elements.points), dtype=np.bool_), start.as_row()[None])
    # one place tells of all of the survey's strips where the sensor stood: no unit is asked whether those of its neighbours will do
    solids = Solids(start.as_row()[None], np.ones((1, 4), dtype=np.bool_), unit, NOISE)
    solids.entered(0, points, (np.full((1, 3), 10 * unit.height), np.zeros((1, 3))), 0, one=True)
    thin_a_cloud(points)


def thin_a_cloud(points: FloatArray) -> None:
    """Take means of points that are denser than is of use; the survey's are not."""
    patches = PatchMeans(100 * NOISE)
    patches.add(points, np.zeros(len(points), dtype=np.uint16), np.zeros(len(points)))
    patches.noise()
    patches.means()
