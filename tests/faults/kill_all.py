"""Kills at random moments, of a process alone or with its group: of runs, of reviewers, and of runs that replace a result under reviewers.

    python tests/faults/kill_all.py run|reviewer|replacement [--kills 200] [--seed 1]

No acknowledged decision is lost, the result stays readable, no process is left after five seconds, and the next run cleans what is left.
"""

from __future__ import annotations

import argparse
import os
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import closing, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

if __name__ == "__main__":
    sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parents[1] / "helpers")]

import synthetic_result
from result_contents import contents
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.core.results.geopackage_writer import check_output
from tetratrack.core.review.decisions import read_history

TINY = Path(__file__).resolve().parents[1] / "data" / "tiny"
SECONDS_LEFT = 5.0
"""How long after a kill any process of the killed one's session may live."""

REVIEWER = """
import os, sys
from pathlib import Path
from tetratrack.core.common.errors import TetratrackError
from tetratrack.core.results.geopackage_reader import epoch_pairs, read_layer_rows
from tetratrack.core.review.decisions import decide

path, who = Path(sys.argv[1]), sys.argv[2]
pair = epoch_pairs(path)[0]
unit = next(row["unit_id"] for row in read_layer_rows(path, "displacements") if row["epoch_to"] == pair.epoch_to)
Path(f"alive-{os.getpid()}").touch()
with open(sys.argv[3], "a") as log:
    number = 0
    while True:
        comment = f"{who}-{os.getpid()}-{number}"
        try:
            decide(path, [unit], pair, "accepted", comment=comment, reviewer=who)
        except TetratrackError:
            continue
        log.write(comment + "\\n")
        log.flush()
        number += 1
"""
RUN = """
import os, sys
from pathlib import Path
from tetratrack.core.common.errors import TetratrackError
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.core.results.geopackage_writer import check_output, write_geopackage

path = Path(sys.argv[1])
names = ("units", "feature_points", "displacements", "epochs", "control_residuals", "check_residuals")
tables = {name: [] for name in names}
for name in names:
    for row in read_layer_rows(path, name):
        values = {field: value for field, value in row.items() if field not in ("fid", "geom")}
        tables[name].append(values | ({"geometry": row["geom"]} if "geom" in row else {}))
Path(f"alive-{os.getpid()}").touch()
while True:
    check_output(path)
    write_geopackage(path, "EPSG:32650", tables)
"""


@dataclass
class Outcome:
    """What became of the kills."""

    alone: int = 0
    group: int = 0
    with_workers: int = 0
    decisions: int = 0
    finished: int = 0
    longest_left: float = 0.0
    wrong: list[str] = field(default_factory=list)

    @property
    def kills(self) -> int:
        """All of them."""
        return self.alone + self.group

    def __str__(self) -> str:
        return (
            f"{self.kills} kills ({self.alone} of the process alone, {self.group} of its group, {self.with_workers} while it had others), "
            f"{self.decisions} acknowledged decisions, {self.finished} finished runs compared, "
            f"last process gone after {self.longest_left:.1f} s, {len(self.wrong)} faults"
        )


def in_session(leader: int) -> list[int]:
    """Living processes of a session, as Linux shows them."""
    found = []
    for status in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            words = status.read_text().rsplit(")", 1)[1].split()
            if int(words[3]) == leader and words[0] != "Z":
                found.append(int(status.parent.name))
    return found


def kill(process: subprocess.Popen[Any], group: bool, outcome: Outcome) -> None:
    """Kill a leader of a session, alone or with all of it, and see that nothing of it is left after five seconds."""
    outcome.with_workers += len(in_session(process.pid)) > 1
    with suppress(ProcessLookupError):
        (os.killpg if group else os.kill)(process.pid, signal.SIGKILL)
    process.wait()
    outcome.group += group
    outcome.alone += not group
    start = time.monotonic()
    while (left := in_session(process.pid)) and time.monotonic() - start < SECONDS_LEFT:
        time.sleep(0.05)
    outcome.longest_left = max(outcome.longest_left, time.monotonic() - start)
    if left:
        outcome.wrong.append(f"kill {outcome.kills}: {len(left)} processes are left")
        for pid in left:
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)


def _start(folder: Path, script: str, *arguments: str) -> subprocess.Popen[bytes]:
    path = folder / f"{'run' if script is RUN else 'reviewer'}.py"
    path.write_text(script, encoding="utf-8")
    command = [sys.executable, str(path), str(folder / "result.gpkg"), *arguments]
    return subprocess.Popen(command, cwd=folder, start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def _check_decisions(folder: Path, acknowledged: Path, units: int, outcome: Outcome) -> None:
    result = folder / "result.gpkg"
    if len(read_layer_rows(result, "units")) != units:
        outcome.wrong.append(f"kill {outcome.kills}: units are gone")
    # the log first: the others go on meanwhile
    log = acknowledged.read_text().splitlines() if acknowledged.exists() else []
    comments = {event.comment for event in read_history(result)}
    outcome.decisions = len(log)
    lost = [line for line in log if line not in comments]
    if lost:
        outcome.wrong.append(f"kill {outcome.kills}: {len(lost)} acknowledged decisions are lost, {lost[0]} first")


def kill_reviewers(
    folder: Path, kills: int, *, replaced: bool, seed: int = 9, told: Callable[[str], object] = lambda line: None
) -> Outcome:
    """Two reviewers, who decide without pause, and with ``replaced`` a run that replaces the result under them, one of them killed
    at a time."""
    rng = random.Random(seed)
    synthetic_result.write_result(folder / "result.gpkg", count=30, epochs=2)
    units = len(read_layer_rows(folder / "result.gpkg", "units"))
    acknowledged = folder / "acknowledged.txt"
    roles = [("Anna",), ("Bert",), *([None] if replaced else [])]
    outcome = Outcome()

    def start(role: tuple[str, ...] | None) -> subprocess.Popen[bytes]:
        return _start(folder, RUN) if role is None else _start(folder, REVIEWER, *role, str(acknowledged))

    running = [start(role) for role in roles]
    try:
        while outcome.kills < kills:
            victim = rng.randrange(len(running))
            alive = folder / f"alive-{running[victim].pid}"
            # one in ten dies while it starts, the others at work
            while rng.random() > 0.1 and not alive.exists():
                time.sleep(0.1)
            time.sleep(rng.uniform(0.0, 0.8))
            kill(running[victim], rng.random() < 0.5, outcome)
            _check_decisions(folder, acknowledged, units, outcome)
            running[victim] = start(roles[victim])
            if outcome.kills % 20 == 0:
                told(str(outcome))
    finally:
        for process in running:
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    _check_decisions(folder, acknowledged, units, outcome)
    check_output(folder / "result.gpkg")
    with closing(sqlite3.connect(folder / "result.gpkg")) as connection:
        if connection.execute("PRAGMA integrity_check").fetchone() != ("ok",):
            outcome.wrong.append("the result is damaged")
    left = {path.name for path in folder.iterdir() if not path.name.startswith("alive-")}
    if left - {"run.py", "reviewer.py"} != {"result.gpkg", "acknowledged.txt"}:
        outcome.wrong.append(f"left: {sorted(left)}")
    return outcome


def kill_runs(folder: Path, kills: int, *, seed: int = 5, told: Callable[[str], object] = lambda line: None) -> Outcome:
    """Runs with two workers that go on from each other's blocks and replace an earlier result; each that finishes is compared."""
    rng = random.Random(seed)
    survey = Path(shutil.copytree(TINY, folder / "tiny")) / "survey.toml"
    # a look at the size of the units, in the parent alone, would be half of such a small run
    survey.write_text(survey.read_text().replace("[unit]", "size_check = false\n[unit]", 1))
    output = folder / "result.gpkg"
    command = [sys.executable, "-m", "tetratrack.scripts.cli", "run", str(survey), "--output", str(output), "--quiet"]
    command += ["--resume", "--workers", "2"]
    jobs = folder / "result.gpkg.jobs"

    def seconds_of_a_run(anew: bool) -> float:
        if anew:
            shutil.rmtree(jobs, ignore_errors=True)
        began = time.monotonic()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return time.monotonic() - began

    # the first compiles, where that was not done before
    seconds_of_a_run(anew=True)
    lengths = {anew: seconds_of_a_run(anew) for anew in (True, False)}
    expected = contents(output)
    outcome = Outcome()
    while outcome.kills < kills or outcome.finished == 0:
        anew = rng.random() < 0.4
        if anew:
            shutil.rmtree(jobs, ignore_errors=True)
        process = subprocess.Popen(command, start_new_session=True, stdout=subprocess.DEVNULL)
        try:
            process.wait(timeout=rng.uniform(0.05, 1.1) * lengths[anew] if outcome.kills < kills else None)
        except subprocess.TimeoutExpired:
            kill(process, rng.random() < 0.5, outcome)
            told(str(outcome))
        else:
            if process.returncode:
                outcome.wrong.append(f"kill {outcome.kills}: the next run ended with {process.returncode}")
            outcome.finished += 1
            left = {path.name for path in folder.iterdir()} - {"tiny", "result.gpkg", "result.gpkg.jobs"}
            if left:
                outcome.wrong.append(f"kill {outcome.kills}: a finished run leaves {sorted(left)}")
        if contents(output) != expected:
            outcome.wrong.append(f"kill {outcome.kills}: the result is another one")
    return outcome


def main() -> int:
    """Run from the command line; exit code 1 if anything was lost."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("run", "reviewer", "replacement"))
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()

    def say(line: str) -> None:
        sys.stdout.write(f"{line}\n")
        sys.stdout.flush()

    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        if options.what == "run":
            outcome = kill_runs(folder, options.kills, seed=options.seed, told=say)
        else:
            outcome = kill_reviewers(folder, options.kills, replaced=options.what == "replacement", seed=options.seed, told=say)
    say(f"{options.what}: {outcome}")
    for fault in outcome.wrong:
        say(f"    {fault}")
    return int(bool(outcome.wrong))


if __name__ == "__main__":
    sys.exit(main())
