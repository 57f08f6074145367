"""Many surveys, and folders that are watched: ``tetratrack batch`` and ``tetratrack watch`` run each survey in a process of its own, so
that one bad survey does not end the others."""

from __future__ import annotations

import json
import os
import signal
import subprocess  # nosec B404 - starts this command itself, with a list of arguments
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..core.common.atomic_files import write_whole
from ..core.common.errors import Cancelled, InputError, TetratrackError
from ..core.common.feedback import Feedback
from ..core.common.output_files import check_targets
from ..core.data.las_files import checksum
from ..core.data.survey_reader import read_survey
from .console import BAD_INPUT, DONE, INTERRUPTED

SETTLED_SECONDS = 5.0
"""A tile whose size stands still this long counts as copied completely."""
LONGEST_PAUSE = 3600.0
"""Seconds between two tries of a run that failed for a passing reason, at most."""
KILL = 9
"""Signal by which a system that runs out of memory ends a process."""
MEMORY = "If nobody ended it, memory ran out: try fewer --workers."
ENGINE = Path(__file__).with_name("engine.py")


@dataclass(frozen=True)
class Outcome:
    """How a run ended: exit code, its last error, and whether another try may succeed with the same input."""

    code: int
    problem: str = ""
    remedy: str = ""
    passing: bool = False


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
    check_targets([(result_of(survey), str(survey)) for survey in surveys])
    failed = []
    for number, survey in enumerate(surveys):
        feedback.progress(number / len(surveys), f"{survey}")
        outcome = _run(survey, options, feedback)
        if outcome.code == INTERRUPTED:
            raise Cancelled("cancelled")
        if outcome.code != DONE:
            failed.append(str(survey))
    feedback.progress(1.0, "done")
    if failed:
        raise InputError(
            f"{len(failed)} of {len(surveys)} surveys failed: {', '.join(failed)}", remedy="Their messages are above; the others are done."
        )
    return {"surveys": len(surveys)}


def watch(survey: Path, options: Sequence[str], interval: float, once: bool, feedback: Feedback) -> dict[str, Any]:
    """Run a survey anew whenever its tiles or its survey.toml changed and have stood still for a moment, or its result is gone.

    Input that is refused is refused until it changes; what failed for another reason (a locked result, a full disk) is tried again after
    pauses that grow to an hour.

    Parameters
    ----------
    survey
        survey.toml; its patterns are searched again every time.
    options
        Further options of ``tetratrack run``; ``--resume`` is added, so that blocks of earlier epochs are not computed again.
    interval
        Seconds between looks.
    once
        Look once, run if there is something new, and end as that run ended.
    feedback
        Receives what happens.

    Raises
    ------
    InputError, TetratrackError
        With ``once``: input is missing, is still being copied, or was refused; or the run failed.
    Cancelled
        The run was interrupted.
    """
    state_file = result_of(survey).with_suffix(".watched")
    done = state_file.read_text(encoding="utf-8", errors="replace") if state_file.is_file() else ""
    waiting, refused, tries = "", "", 0
    known: dict[Path, tuple[tuple[int, int], str]] = {}
    while True:
        pause = interval
        try:
            state = settled_state(survey, known)
        except InputError as error:
            if once:
                raise
            if str(error) != waiting:
                waiting = str(error)
                feedback.warning(f"waiting: {waiting}")
        else:
            waiting = ""
            # a result that was taken away is made again
            if state == refused or (state == done and result_of(survey).is_file()):
                if once:
                    return {"runs": 0}
            else:
                feedback.info(f"{survey}: {'its result is gone' if state == done else 'new or changed input'}")
                outcome = _run(survey, ["--resume", *options], feedback)
                if outcome.code == DONE:
                    write_whole(state_file, state.encode("utf-8"))
                    done = state
                if once or outcome.code == INTERRUPTED:
                    return _ended(outcome)
                tries = tries + 1 if outcome.passing else 0
                if outcome.passing:
                    pause = min(interval * 2**tries, LONGEST_PAUSE)
                    feedback.warning(f"trying again in {pause:.0f} s")
                elif outcome.code != DONE:
                    refused = state
        time.sleep(pause)


def _ended(outcome: Outcome) -> dict[str, Any]:
    """End as the run did."""
    if outcome.code == DONE:
        return {"runs": 1}
    if outcome.code == INTERRUPTED:
        raise Cancelled("cancelled")
    if outcome.code == BAD_INPUT:
        raise InputError(outcome.problem, remedy=outcome.remedy)
    raise TetratrackError(outcome.problem, remedy=outcome.remedy)


def _run(survey: Path, options: Sequence[str], feedback: Feedback) -> Outcome:
    """Run one survey in a process of its own, which ends with this one, and pass its messages on."""
    result = result_of(survey)
    # -P: nothing is imported from the working directory
    command = [sys.executable, "-P", "-X", "utf8", str(ENGINE), "--attached", "run", str(survey), "--output", str(result), *options]
    problem, remedy, passing, reported = "", "", True, False
    with subprocess.Popen(  # nosec B603 - as above
        [*command, "--json-progress"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        encoding="utf-8",
        errors="replace",
        env=os.environ | {"PYTHONSAFEPATH": "1"},
    ) as process:
        try:
            for line in process.stdout or ():
                event = _event(line)
                kind, message = event.get("event"), f"{survey.stem}: {event.get('message', '')}"
                if kind == "log":
                    (feedback.warning if event.get("level") == "warning" else feedback.info)(message)
                elif kind == "result":
                    reported = True
                elif kind == "error":
                    problem, remedy, passing = str(event["message"]), str(event.get("remedy", "")), bool(event.get("passing"))
                    feedback.warning(f"{survey.stem}: error: {problem}")
        except BaseException:
            process.terminate()
            raise
    code = process.returncode
    if code not in (DONE, INTERRUPTED) and not problem:
        # what is killed says nothing itself
        problem = f"the run was ended by {_name_of_signal(-code)}" if code < 0 else f"the run ended with exit code {code}"
        remedy = MEMORY if code == -KILL else ""
        feedback.warning(f"{survey.stem}: error: {problem}{'. ' if remedy else ''}{remedy}")
        return Outcome(code, problem, remedy, passing=True)
    if code == DONE and not (reported and result.is_file()):
        return Outcome(1, f"{result} was not written though the run ended well", passing=True)
    # one error holds the remedy in its message already
    return Outcome(code, problem.removesuffix(remedy).rstrip(), remedy, passing and code not in (DONE, INTERRUPTED))


def _name_of_signal(number: int) -> str:
    try:
        return f"signal {number} ({signal.Signals(number).name})"
    except ValueError:
        return f"signal {number}"


def _event(line: str) -> dict[str, Any]:
    """An event of the engine; a line that some library printed is a message."""
    try:
        event = json.loads(line)
    except ValueError:
        event = None
    return event if isinstance(event, dict) else {"event": "log", "level": "info", "message": line.rstrip()}


def settled_state(survey: Path, known: dict[Path, tuple[tuple[int, int], str]]) -> str:
    """Checksum of the survey and all its inputs.

    Parameters
    ----------
    known
        Size and time of change of files with their checksums, by path: what is as it was is not read again. Brought up to date here.

    Raises
    ------
    InputError
        Something is missing, or is still being copied.
    """
    described = read_survey(survey)
    files = [survey, *(path for path in described.files if path != described.path)]
    stamps = [_stamp(path) for path in files]
    time.sleep(SETTLED_SECONDS)
    settled = {}
    for path, stamp in zip(files, stamps, strict=True):
        if stamp is None or _stamp(path) != stamp:
            raise InputError("is still being copied", source=path, remedy="Look again when the copy is complete.")
        settled[path] = stamp
    for path, stamp in settled.items():
        if path not in known or known[path][0] != stamp:
            known[path] = stamp, checksum(path)
    return "\n".join(f"{known[path][1]}  {path}" for path in settled)


def _stamp(path: Path) -> tuple[int, int] | None:
    """Size and time of the last change; None where the file is gone."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_size, status.st_mtime_ns
