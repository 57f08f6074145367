"""Units carried elsewhere between two epochs: named relocated, reported lost and new with candidates, or mistaken.

    python benchmarks/accuracy/relocations.py [--instrument uav tls] [--seeds 7000 7001] [--units 45] [--folder DIR]
    python benchmarks/accuracy/relocations.py SURVEY=RESULT...

Without pairs, surveys with many changes are simulated and run, one of each seed and instrument; --folder keeps them and uses those that
are there. SURVEY is a folder with survey.toml and truth/, RESULT what ``tetratrack run`` made of it; such pairs are judged as they are.
Only relocated units with a pose within 0.25 H of the true centre in both epochs count. Units whose poses are of two different ones
(another unit stands where one was taken away) are counted apart.
"""

from __future__ import annotations

import argparse
import itertools
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial import cKDTree
from tetratrack.benchmarks.ground_truth import CENTRE_TOLERANCE, unit_rows
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.pipeline.run_options import RunOptions
from tetratrack.core.pipeline.whole_survey import run_survey
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.core.simulation.armour_pile import Changes
from tetratrack.core.simulation.survey_plan import SimulationPlan
from tetratrack.core.simulation.virtual_survey import simulate_survey

CHANGES = Changes(moved=6, removed=3, new=2, relocated=3)
COUNTS = ("relocated", "found in both epochs", "named relocated", "lost and new, candidates named", "other")
MISTAKES = ("wrongly named relocated", "moved unit named relocated", "two units taken for one")


def plan(instrument: Any, seed: int, units: int) -> SimulationPlan:
    """Survey of a seed; height of the units and direction of the wall differ from one seed to the next."""
    step = (seed - 7000) % 9
    height, azimuth = 2.3 + 0.15 * (step % 3), 40.0 * step
    return SimulationPlan(f"{instrument}{seed}", instrument, units, height, seed=seed, azimuth_deg=azimuth, changes=CHANGES)


def make(survey_plan: SimulationPlan, folder: Path) -> tuple[Path, Path]:
    """Survey and result, made unless they are there."""
    survey, result = folder / survey_plan.name, folder / f"{survey_plan.name}.gpkg"
    if not survey.exists():
        simulate_survey(survey_plan, survey)
    if not result.exists():
        run_survey(read_survey(survey / "survey.toml"), result, RunOptions(workers=1), Feedback())
    return survey, result


def true_units(folder: Path, label: str, rows: list[dict[str, Any]], height: float) -> dict[str, str]:
    """True unit of each of an epoch's units of the result that has a pose near one."""
    there = [row for row in unit_rows(folder) if row["epoch"] == label and row["E"]]
    placed = [row for row in rows if row["epoch"] == label and row["geom"] is not None]
    if not (there and placed):
        return {}
    centres = np.array([[float(row[k]) for k in "ENH"] for row in there])
    distances, nearest = cKDTree(centres).query(np.array([row["geom"] for row in placed]))
    return {p["unit_id"]: there[j]["unit_id"] for p, d, j in zip(placed, distances, nearest) if d <= CENTRE_TOLERANCE * height}


def judge(folder: Path, result: Path) -> tuple[Counter[str], list[str]]:
    """Counts over consecutive epochs, and what the relocated units under ``other`` were reported as."""
    survey = read_survey(folder / "survey.toml")
    rows: list[dict[str, Any]] = [dict(row) for row in read_layer_rows(result, "units")]
    states = {(row["unit_id"], row["epoch"]): row for row in rows}
    counts: Counter[str] = Counter()
    others = []
    for before, after in itertools.pairwise(epoch.label for epoch in survey.epochs):
        old, new = (true_units(folder, label, rows, survey.unit.height) for label in (before, after))
        relocated = {row["unit_id"] for row in unit_rows(folder) if row["epoch"] == after and row["status"] == "relocated"}
        named_old, named_new = ({true: name for name, true in names.items()} for names in (old, new))
        counts["relocated"] += len(relocated)
        for unit in sorted(relocated & set(named_old) & set(named_new)):
            counts["found in both epochs"] += 1
            a, b = named_old[unit], named_new[unit]
            left, came = states.get((a, after)), states[b, after]
            status = left["status"] if left else "absent"
            if a == b and came["status"] == "relocated":
                counts["named relocated"] += 1
            elif (status, came["status"]) == ("lost", "new") and left and b in str(left["may_be"]).split():
                counts["lost and new, candidates named"] += 1
            else:
                counts["other"] += 1
                others.append(f"{status} and {came['status']}")
        for name in {row["unit_id"] for row in rows}:
            here = states.get((name, after))
            if here is not None and here["status"] == "relocated":
                same = name in old and old[name] == new.get(name)
                counts["wrongly named relocated"] += not same
                counts["moved unit named relocated"] += same and old[name] not in relocated
            elif name in old and name in new:
                counts["two units taken for one"] += old[name] != new[name]
    return counts, others


def line(name: str, counts: Counter[str], others: list[str]) -> str:
    cells = [str(counts[key]) for key in COUNTS] + [str(counts[key]) for key in MISTAKES]
    if others:
        cells[len(COUNTS) - 1] += f" ({', '.join(others)})"
    return f"| {name} | {' | '.join(cells)} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surveys", nargs="*", metavar="SURVEY=RESULT")
    parser.add_argument("--instrument", nargs="+", choices=("uav", "tls", "photogrammetry"), default=["uav", "tls"])
    parser.add_argument("--seeds", nargs="+", type=int, default=[7000, 7001])
    parser.add_argument("--units", type=int, default=45)
    parser.add_argument("--folder", type=Path, help="where surveys and results stay; else in a temporary folder")
    options = parser.parse_args()
    print(f"| survey | {' | '.join((*COUNTS, *MISTAKES))} |")
    print("| --- " * (1 + len(COUNTS) + len(MISTAKES)) + "|")
    total: Counter[str] = Counter()
    with tempfile.TemporaryDirectory(prefix="relocations-") as scratch:
        if options.surveys:
            pairs = (tuple(map(Path, pair.split("=", 1))) for pair in options.surveys)
        else:
            folder = options.folder or Path(scratch)
            pairs = (make(plan(kind, seed, options.units), folder) for kind in options.instrument for seed in options.seeds)
        for survey, result in pairs:
            counts, others = judge(survey, result)
            total += counts
            print(line(survey.name, counts, others), flush=True)
    print(line("**all**", total, []))


if __name__ == "__main__":
    main()
