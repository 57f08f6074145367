"""Run the cases of what users met (``../shared/faults``), or one's own of the same layout, and say whether each gives what is right.

    python tests/faults/run_all.py [FOLDER] [--only 05 31]

A case is a folder with ``run.sh`` and ``expect.txt``; here stands, by its number, what its output must and must not hold.
"""

from __future__ import annotations

import argparse
import os
import re
import resource
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOST_SECONDS = 30.0
"""What a case may take; runs of several epochs on a busy machine are given more before they are ended."""
ENDED_SECONDS = 300.0


@dataclass(frozen=True)
class Expected:
    """Patterns that the output must hold, in any order, and one that it must not."""

    holds: tuple[str, ...]
    never: str = ""


EXPECTED = {
    "01": Expected((r"exit 0", r"_00.laz.*1 point lies far from all others")),
    "02": Expected((r"exit 2", r"targets_2024-04-09.csv: targets lie 4 022 km", "exchanged"), r"found \["),
    "04": Expected((r"exit 0", r"its header gives no extent")),
    "05": Expected((r"exit 2", r"is in US survey foot, not metres"), r"found \["),
    "07": Expected((r"exit 2", r"EPSG:3857", r"EPSG:32650")),
    "08": Expected((r"exit 0", r"height systems differ", r"lies 20\.\d m higher", r"seem shifted as a whole by 20\.\d m")),
    "10": Expected((r"exit 0", r"tiles_crs overrules it: EPSG:32650")),
    "11": Expected((r"exit 0", r"tiles_crs overrules it: EPSG:32650")),
    "13": Expected((r"exit 2", r"is one of the inputs")),
    "14": Expected((r"exit 2", r"^LASF"), r"SQLite"),
    "15": Expected((r"exit 0", r"\[([^\]]+)\] \[\1\]")),
    "16": Expected((r"exit 0", r"EPSG:32650")),
    "18": Expected((r"exit 0", r"tiles 2, ")),
    "21": Expected((r"exit 0",)),
    "22": Expected((r"exit 0", r"tiles 2, ")),
    "23": Expected((r"exit 0", r"surveys 1")),
    "24": Expected((r"exit (0|2)",)),
    "25": Expected((r"exit (0|2)",)),
    "26": Expected((r"exit (0|2)",), r"Choose the result.gpkg that tetratrack run wrote"),
    "28": Expected((r"exit 2", r"all 51459 points are classed as noise")),
    "29": Expected((r"exit 2", r"control_2024-04-09.csv", r"millimetres")),
    "30": Expected((r"exit 2", r"site_boundary, stable", r"layername=")),
    "31": Expected((r"exit 0", r"holds the same points as", r"units 4")),
    "33": Expected((r"exit 0", r"_20.laz.*holds no points and is left out")),
    "34": Expected((r"exit 2", r"write / instead of \\")),
    "35": Expected((r"exit 0", r"tiles 2, ")),
    "37": Expected((r"__main__", r"worker processes import this script"), r"ended from outside"),
    "38": Expected((r"exit 0", r"227 bytes where LAS 1.3 needs 235")),
    "40": Expected((r"exit 0", r"(no font|ko\.html)"), r"Glyph \d+"),
    "41": Expected((r"exit 0", r"357 273 277")),
    "43": Expected((r"exit 2", r'crs = "EPSG:4549"'), r"projsync"),
}


@dataclass(frozen=True)
class Outcome:
    """How a case went: seconds that passed and seconds of processor, and what is wrong, empty where nothing is."""

    seconds: float
    processor: float
    wrong: str
    output: str


def run_case(folder: Path, command: Path) -> Outcome:
    """Run one case and compare its output with what is expected of its number."""
    expected = EXPECTED.get(folder.name[:2])
    start, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
    environment = os.environ | {"TETRATRACK": str(command)}
    try:
        done = subprocess.run(
            ["sh", str(folder / "run.sh")], cwd=ROOT, env=environment, capture_output=True, timeout=ENDED_SECONDS, check=False
        )
    except subprocess.TimeoutExpired:
        return Outcome(time.monotonic() - start, 0.0, "does not end", "")
    seconds = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    output = (done.stdout + done.stderr).decode("utf-8", "replace")
    wrong = []
    if "Traceback" in output.replace("sqlite3.OperationalError: no such table", "") and re.search(r'File ".*tetratrack', output):
        wrong += [] if folder.name.startswith("37") else ["traceback"]
    if expected is not None:
        wrong += [f"lacks {pattern!r}" for pattern in expected.holds if not re.search(pattern, output, re.MULTILINE)]
        wrong += [f"holds {expected.never!r}"] if expected.never and re.search(expected.never, output) else []
    return Outcome(seconds, processor, ", ".join(wrong), output)


def main() -> int:
    """Run the cases and print a line for each; the exit code is 1 if one is wrong or slow."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=ROOT.parent / "shared" / "faults")
    parser.add_argument("--only", nargs="*", default=[], help="numbers of cases")
    parser.add_argument("--command", type=Path, default=ROOT / ".venv" / "bin" / "tetratrack")
    parser.add_argument("--verbose", action="store_true", help="show the output of what is wrong")
    options = parser.parse_args()
    failures = 0
    # the loops are compiled once for all: that is no case's own time
    with tempfile.TemporaryDirectory() as place:
        tiny = ROOT / "tests" / "data" / "tiny" / "survey.toml"
        subprocess.run([str(options.command), "run", str(tiny), "-o", f"{place}/result.gpkg", "--workers", "1", "--quiet"], check=True)
    for folder in sorted(path.parent for path in options.folder.glob("*/run.sh")):
        if options.only and folder.name[:2] not in options.only:
            continue
        outcome = run_case(folder, options.command)
        # on a machine with more to do than it has processors, what a case waits for its turn is not its own
        busy = os.getloadavg()[0] > 2 * (os.cpu_count() or 1)
        slow = (outcome.processor if busy else outcome.seconds) > MOST_SECONDS
        failures += bool(outcome.wrong) or slow
        verdict = outcome.wrong or ("slow" if slow else "as expected")
        sys.stdout.write(f"{folder.name}: {verdict} ({outcome.seconds:.0f} s, {outcome.processor:.0f} s of processor)\n")
        if options.verbose and outcome.wrong:
            sys.stdout.write(outcome.output + "\n")
        sys.stdout.flush()
    return int(failures > 0)


if __name__ == "__main__":
    sys.exit(main())
