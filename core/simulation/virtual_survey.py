"""Whole surveys with ground truth, written as a folder that ``tetratrack run`` reads: pile, instrument, epochs, control, truth."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

from ..common.errors import CrsError, OutputError
from ..data.crs import check_survey_crs
from ..data.plausibility import Place, check_scale
from .coast import CoastSimulation
from .survey_plan import SimulationPlan
from .survey_simulation import Simulation


def simulate_survey(plan: SimulationPlan, folder: Path, progress: Callable[[float, str], None] | None = None) -> Path:
    """Simulate a survey and write it as a folder with ``survey.toml``, tiles, control and ``truth/``.

    Parameters
    ----------
    plan
        What to simulate.
    folder
        Folder to make; it must not exist yet, and appears whole or not at all.
    progress
        Called with the fraction done and what is being done.

    Returns
    -------
    Path of the survey.toml.

    Raises
    ------
    OutputError
        The folder exists or cannot be written.
    InputError
        MuJoCo is not installed, or no survey can be in the CRS.
    """
    report = progress or (lambda fraction, message: None)
    if folder.exists():
        raise OutputError("exists already", source=folder, remedy="Choose another folder, or remove it.")
    _vet_crs(plan, folder)
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        work = Path(tempfile.mkdtemp(prefix=f".{folder.name}-", dir=folder.parent))
    except OSError as cause:
        raise OutputError(f"cannot be made: {cause.strerror}", source=folder, remedy="Choose a folder that can be written.") from cause
    try:
        simulation = CoastSimulation if plan.length > 0 else Simulation
        simulation(plan, work).run(report)
        work.chmod(0o755)
        work.rename(folder)
    except OSError as cause:
        raise OutputError(f"cannot be written: {cause}", source=folder, remedy="Check free space and rights.") from cause
    finally:
        shutil.rmtree(work, ignore_errors=True)
    report(1.0, f"{plan.name} written")
    return folder / "survey.toml"


def _vet_crs(plan: SimulationPlan, folder: Path) -> None:
    """Refuse what a run would refuse of the survey."""
    for name in (plan.crs, plan.las_crs or plan.crs):
        check_survey_crs(name, where="crs")
    try:
        check_scale(plan.crs, Place(plan.origin, plan.origin, plan.crs, plan.height), source=folder)
    except CrsError as error:
        raise CrsError(error.problem, where="crs", remedy="Give the grid of a country, or a UTM zone.") from error
