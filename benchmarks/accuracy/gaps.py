"""How many units that a run did not find have a gap near, and how many gaps stand where no unit is missing.

    python benchmarks/accuracy/gaps.py SURVEY=RESULT...

SURVEY is a folder with survey.toml and truth/, RESULT what ``tetratrack run`` made of it; gaps are looked for anew. A gap is right when
a unit that the epoch's result lacks, or one taken away since the first epoch, lies within 0.5 H of it. Each epoch is judged twice: with
all it knows from the other epochs, and from its own cloud and packing alone. Processor time of the search, reading of the tiles
included, goes to stderr; the first is that of compiling too.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from tetratrack.benchmarks.ground_truth import CENTRE_TOLERANCE, unit_rows
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.pipeline.epoch_plans import plan_survey
from tetratrack.core.pipeline.epoch_quality import ACCEPTED
from tetratrack.core.pipeline.epoch_registration import register_epochs
from tetratrack.core.pipeline.gap_table import gap_rows, look_into_tiles
from tetratrack.core.pipeline.job_runner import JobRunner
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.core.results.run_record import record_run

FloatArray = NDArray[np.float64]
NEAR = 0.5
"""A gap is right within this many heights of a missing unit."""


def missing_units(folder: Path, label: str, labels: Sequence[str], found: FloatArray, height: float) -> tuple[FloatArray, FloatArray]:
    """(m, 3) centres of true units of an epoch without a pose near, and (g, 3) last centres of those taken away before it."""
    rows = unit_rows(folder)
    place = {(row["unit_id"], row["epoch"]): np.array([float(row[k]) for k in "ENH"]) for row in rows if row["E"]}
    missed = [c for (_, epoch), c in place.items() if epoch == label and not _near(c, found, CENTRE_TOLERANCE * height)]
    earlier = labels[: labels.index(label)][::-1]
    gone = [row["unit_id"] for row in rows if row["epoch"] == label and row["status"] == "removed"]
    left = [next(place[unit, epoch] for epoch in earlier if (unit, epoch) in place) for unit in gone]
    return np.array(missed).reshape(-1, 3), np.array(left).reshape(-1, 3)


def tally(places: FloatArray, missed: FloatArray, gone: FloatArray, height: float) -> list[int]:
    """Missed units with a gap near, units taken away with one, and gaps near neither."""
    both = np.vstack([missed, gone])
    hits = [sum(_near(centre, places, NEAR * height) for centre in centres) for centres in (missed, gone)]
    return [*hits, sum(not _near(place, both, NEAR * height) for place in places)]


def judge(folder: Path, result: Path) -> list[str]:
    """Lines of the table for one survey."""
    survey = read_survey(folder / "survey.toml")
    height = survey.unit.height
    plans = plan_survey(survey)
    units = tuple(unit.type for unit in survey.units)
    rows: list[Mapping[str, Any]] = [row | {"geometry": row["geom"]} for row in read_layer_rows(result, "units")]
    when = [(plan.epoch.label, plan.epoch.time) for plan in plans]
    labels = [label for label, _ in when]
    checksums = record_run(survey, 0, {}).checksums
    registrations = register_epochs(survey, plans, Feedback())
    clock = time.process_time()
    with tempfile.TemporaryDirectory() as folder_of_jobs, JobRunner(Path(folder_of_jobs)) as runner:
        seen = look_into_tiles(rows, survey, plans, units, registrations, checksums, runner)
    print(f"{folder.name}: {(time.process_time() - clock) / len(plans):.1f} CPU-seconds an epoch", file=sys.stderr, flush=True)
    gaps = gap_rows(rows, when, units, seen)
    lines = []
    for label in labels:
        own = [row for row in rows if row["epoch"] == label and row["geometry"] is not None]
        centres = np.array([row["geometry"] for row in own])
        missed, gone = missing_units(folder, label, labels, centres, height)
        cells = [str(sum(row["status"] in ACCEPTED for row in own)), str(len(missed)), str(len(gone))]
        for places in ([row["geometry"] for row in gaps if row["epoch"] == label], [gap.place for gap in seen[label]]):
            cells += [str(count) for count in tally(np.array(places).reshape(-1, 3), missed, gone, height)]
        lines.append(f"| {folder.name} {label} | {' | '.join(cells)} |")
    return lines


def _near(place: FloatArray, others: FloatArray, distance: float) -> bool:
    return bool(len(others) and np.linalg.norm(others - place, axis=1).min() <= distance)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surveys", nargs="+", metavar="SURVEY=RESULT")
    options = parser.parse_args()
    print("| survey | found | not found | taken away | all: not found with a gap | taken away with a gap | false gaps ", end="")
    print("| own cloud: not found with a gap | taken away with a gap | false gaps |")
    print("| --- " * 10 + "|")
    for pair in options.surveys:
        folder, _, result = pair.partition("=")
        for line in judge(Path(folder), Path(result)):
            print(line, flush=True)


if __name__ == "__main__":
    sys.exit(main())
