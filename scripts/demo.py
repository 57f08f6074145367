"""The sample survey from tiles to report, from a checkout or an installed package."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

from ..core.common.feedback import Feedback

SAMPLE = Path(__file__).resolve().parents[1] / "tests" / "data" / "sample" / "survey.toml"
"""Comes with a checkout, not with the installed package: that simulates a survey of its own."""
SIMULATED_UNITS = 24


def run_demo(folder: Path, workers: int, feedback: Feedback) -> dict[str, Any]:
    """Run the sample survey, or a simulated one, and write its report; says what took how long and how to look at it.

    Raises
    ------
    InputError
        The folder cannot be written.
    """
    from ..core.data.survey_reader import read_survey
    from ..core.pipeline.run_options import RunOptions
    from ..core.pipeline.whole_survey import run_survey
    from ..core.report.report import ReportOptions, write_report

    folder.mkdir(parents=True, exist_ok=True)
    began = time.monotonic()
    survey = read_survey(SAMPLE if SAMPLE.is_file() else _simulated(folder / "sample", feedback))
    prepared = time.monotonic()
    result, page = folder / "result.gpkg", folder / "report.html"
    outputs = run_survey(survey, result, RunOptions(workers), feedback)
    computed = time.monotonic()
    write_report(result, page, ReportOptions())
    written = time.monotonic()
    feedback.info(
        f"survey {prepared - began:.0f} s, from tiles to displacements {computed - prepared:.0f} s (the first run compiles, later ones "
        f"are faster), report {written - computed:.0f} s"
    )
    feedback.info(f"look at it without QGIS: {page.absolute().as_uri()}")
    feedback.info(f"in QGIS: drag {result} onto the map; in Python: geopandas.read_file({str(result)!r}, layer='displacements')")
    feedback.info("your own: tetratrack run FOLDER_OF_TILES --output result.gpkg")
    return outputs | {"report": str(page), "seconds": round(written - began)}


def _simulated(folder: Path, feedback: Feedback) -> Path:
    """survey.toml of a small simulated survey."""
    from ..core.simulation.survey_plan import plan_of
    from ..core.simulation.virtual_survey import simulate_survey

    known = folder / "survey.toml"
    if known.is_file():
        return known
    feedback.info(f"simulating a survey of {SIMULATED_UNITS} units in {folder}")
    plan = plan_of("uav", "sample", None, units=SIMULATED_UNITS, epochs=2, seed=1, density=None, noise=None, crs="EPSG:32650")
    return Path(simulate_survey(plan, folder, feedback.progress))
