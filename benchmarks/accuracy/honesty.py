"""Are stated standard deviations, tests and statuses true? Runs surveys with ground truth and compares centres in datum ``stable``.

    .venv/bin/python benchmarks/accuracy/honesty.py SURVEY_FOLDER... [--result FILE.gpkg] [--seeds N]

For each folder one line: right and wrong units that count, right ones called uncertain; of resting and of moved units the median and 90th
percentile of the error (mm), the mean squared normalised error per coordinate (1 is honest), the share of coordinates within 1.96 standard
deviations, and units flagged; then (standard error output) broken legs that are named, as ``broken_legs.py`` counts them.
``--seeds`` simulates as many surveys of castings seen from other sides, instruments in turn.
"""

from __future__ import annotations

import argparse
import csv
import sqlite3
import sys
import tempfile
from pathlib import Path

import numpy as np
from tetratrack.benchmarks.accuracy.broken_legs import counted, judged_in_run, true_legs
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.pipeline.run_options import RunOptions
from tetratrack.core.pipeline.whole_survey import run_survey
from tetratrack.core.simulation.survey_plan import plan_of
from tetratrack.core.simulation.virtual_survey import simulate_survey

SAME_UNIT_HEIGHTS = 0.25
"""Distance of a centre from the true one, in unit heights, up to which a unit is right."""
COLUMNS = ("survey", "right", "wrong", "right but uncertain", "units", "median", "p90", "squared error", "inside 95 %", "flagged")


def true_units(folder: Path) -> tuple[dict[str, list[tuple[str, np.ndarray]]], float]:
    """Centres by epoch, and the height of the units."""
    rows = [row for row in csv.DictReader((folder / "truth/units.csv").open()) if row["E"]]
    units: dict[str, list[tuple[str, np.ndarray]]] = {}
    for row in rows:
        units.setdefault(row["epoch"], []).append((row["unit_id"], np.array([float(row[k]) for k in "ENH"])))
    return units, float(rows[0]["height"])


def matched(result: Path, folder: Path) -> tuple[dict[tuple[str, str], str], list[int]]:
    """True name by (unit, epoch), and counts of right, wrong, and right but uncertain ones."""
    units, height = true_units(folder)
    names: dict[tuple[str, str], str] = {}
    counts = [0, 0, 0]
    with sqlite3.connect(result) as connection:
        starts = connection.execute("select unit_id, epoch, status from units").fetchall()
        places = connection.execute("select unit_id, epoch, geom from feature_points where feature = 'centre'").fetchall()
    status = {(unit, epoch): state for unit, epoch, state in starts}
    for unit, epoch, blob in places:
        centre = np.frombuffer(blob[-24:], dtype="<f8")
        name, distance = min(((n, float(np.linalg.norm(c - centre))) for n, c in units[epoch]), key=lambda item: item[1])
        right = distance < SAME_UNIT_HEIGHTS * height
        if right:
            names[unit, epoch] = name
        if status[unit, epoch] == "uncertain":
            counts[2] += right
        else:
            counts[0 if right else 1] += 1
    return names, counts


def broken_legs(result: Path, folder: Path) -> str:
    """What the result says of broken legs, beside the truth."""
    survey = read_survey(folder / "survey.toml")
    count = counted(judged_in_run(result, folder, survey), true_legs(folder, survey))
    named = [f"{int(number)} of {int(of)}" for number, of in (count.seen, count.shown, count.whole)]
    return f"{folder.name}: broken legs named {named[0]} seen, {named[1]} of which the break is shown, {named[2]} whole ones named broken"


def judged(result: Path, folder: Path) -> list[str]:
    """Lines of the table of one survey: resting, then moved units."""
    names, counts = matched(result, folder)
    truth = {
        (row["unit_id"], row["epoch_from"], row["epoch_to"]): (np.array([float(row[k]) for k in ("de", "dn", "dh")]), int(row["moved"]))
        for row in csv.DictReader((folder / "truth/displacements.csv").open())
    }
    errors: dict[int, list[tuple[float, float, float, bool]]] = {0: [], 1: []}
    query = "select unit_id, epoch_from, epoch_to, de, dn, dh, sd_e, sd_n, sd_h, significant from displacements where feature = 'centre'"
    with sqlite3.connect(result) as connection:
        for unit, first, second, *values in connection.execute(query):
            name = names.get((unit, first))
            if name is None or name != names.get((unit, second)) or (name, first, second) not in truth:
                continue
            vector, moved = truth[name, first, second]
            error, sd = np.array(values[:3]) - vector, np.array(values[3:6])
            inside = float(np.mean(np.abs(error) < 1.96 * sd))
            errors[moved].append((float(np.linalg.norm(error)), float(np.mean((error / sd) ** 2)), inside, bool(values[6])))
    lines = []
    for moved, kind in ((0, "resting"), (1, "moved")):
        if errors[moved]:
            length, form, inside, flagged = (np.array(column, dtype=float) for column in zip(*errors[moved], strict=True))
            numbers = [
                f"{1000 * np.median(length):.1f}",
                f"{1000 * np.quantile(length, 0.9):.1f}",
                f"{form.mean():.2f}",
                f"{inside.mean():.3f}",
            ]
            found = [str(c) for c in counts] if not moved else [""] * 3
            lines.append(" | ".join([f"{folder.name}, {kind}", *found, str(len(length)), *numbers, f"{int(flagged.sum())}/{len(flagged)}"]))
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="*", type=Path)
    parser.add_argument("--result", type=Path, help="judge this result of the one folder given, without a run")
    parser.add_argument("--seeds", type=int, default=0)
    arguments = parser.parse_args()
    print("| " + " | ".join(COLUMNS) + " |\n|" + " --- |" * len(COLUMNS))
    with tempfile.TemporaryDirectory() as work:
        folders = list(arguments.folders)
        for seed in range(arguments.seeds):
            instrument = ("tls", "uav", "photogrammetry")[seed % 3]
            plan = plan_of(instrument, f"castings_{instrument}_{seed}", units=60, seed=9000 + seed, castings=True, other_views=True)
            folders.append(simulate_survey(plan, Path(work) / plan.name).parent)
        for folder in folders:
            result = arguments.result or Path(work) / f"{folder.name}.gpkg"
            if arguments.result is None:
                run_survey(read_survey(folder / "survey.toml"), result, RunOptions(workers=2), Feedback())
            for line in judged(result, folder):
                print(f"| {line} |", flush=True)
            print(broken_legs(result, folder), file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
