"""Many surveys, and folders that are watched: ``tetratrack batch`` and ``tetratrack watch`` run each survey in a process of its own, so
that one bad survey does not end the others."""

from __future__ import annotations

import subprocess  # nosec B404 - starts this command itself, with a list of arguments
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from ..core.errors import InputError
from ..core.feedback import Feedback
from ..core.survey import read_survey
from ..core.tiles import checksum
from .console import DONE

SETTLED_SECONDS = 5.0
"""A tile whose size stands still this long counts as copied completely."""


def result_of(survey: Path) -> Path:
    """Where a survey's result goes: beside it, under its name."""
    return survey.with_suffix(".gpkg")


def run_batch(surveys: Sequence[Path], options: Sequence[str], feedback: Feedback) -> dict[str, Any]:
    """Run every survey; the ones that fail are named at the end.

    Parameters
    ----------
    surveys
        survey.toml files; results go beside them.
    options
        Further options of ``tetratrack run``.

    Raises
    ------
    InputError
        After all have been tried, if any was refused.
    """
    failed = []
    for number, survey in enumerate(surveys):
        feedback.progress(number / len(surveys), f"{survey}")
        code = _run(survey, options, feedback)
        if code != DONE:
            failed.append(str(survey))
    feedback.progress(1.0, "done")
    if failed:
        raise InputError(
            f"{len(failed)} of {len(surveys)} surveys failed: {', '.join(failed)}", remedy="Their messages are above; the others are done."
        )
    return {"surveys": len(surveys)}


def watch(survey: Path, options: Sequence[str], interval: float, once: bool, feedback: Feedback) -> dict[str, Any]:
    """Run a survey anew whenever its tiles or its survey.toml changed and have stood still for a moment.

    Parameters
    ----------
    survey
        survey.toml; its patterns are searched again every time.
    options
        Further options of ``tetratrack run``; ``--resume`` is added, so that blocks of earlier epochs are not computed again.
    interval
        Seconds between looks.
    once
        End after the first run that succeeds.
    feedback
        Receives what happens.
    """
    runs = 0
    state_file = result_of(survey).with_suffix(".watched")
    done = state_file.read_text(encoding="utf-8") if state_file.is_file() else ""
    while True:
        state = _settled_state(survey, feedback)
        if state is not None and state != done:
            feedback.info(f"{survey}: new or changed input")
            if _run(survey, ["--resume", *options], feedback) == DONE:
                state_file.write_text(state, encoding="utf-8")
                runs += 1
            # input that is refused is refused until it changes
            done = state
            if once:
                return {"runs": runs}
        elif once and state is not None:
            return {"runs": runs}
        time.sleep(interval)


def _run(survey: Path, options: Sequence[str], feedback: Feedback) -> int:
    """Run one survey in a process of its own and pass its lines on."""
    command = [sys.executable, "-m", "tetratrack.scripts.cli", "run", str(survey), "--output", str(result_of(survey)), *options]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, encoding="utf-8") as process:  # nosec B603 - as above
        try:
            for line in process.stdout or ():
                say: Callable[[str], None] = feedback.warning if line.startswith("error: ") else feedback.info
                say(f"{survey.stem}: {line.rstrip()}")
        except BaseException:
            process.terminate()
            raise
    return process.returncode


def _settled_state(survey: Path, feedback: Feedback) -> str | None:
    """Checksum of the survey and all its inputs; None while something is missing or still being copied."""
    try:
        described = read_survey(survey)
    except InputError as error:
        feedback.progress(0.0, f"waiting: {error}")
        return None
    files = [survey, *(path for epoch in described.epochs for path in epoch.files)]
    sizes = [path.stat().st_size for path in files]
    time.sleep(SETTLED_SECONDS)
    if [path.stat().st_size for path in files if path.exists()] != sizes:
        feedback.progress(0.0, "waiting: files are being copied")
        return None
    return "\n".join(f"{checksum(path)}  {path}" for path in files)
