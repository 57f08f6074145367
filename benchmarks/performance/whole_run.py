"""Time and memory of a whole run, from tiles to displacements, beside the floor that any method pays.

    python benchmarks/performance/whole_run.py SURVEY... [--workers 2] [--repeat 3] [--record]

SURVEY is a folder with survey.toml and truth/. The floor is reading all tiles, thinning to 0.02 H and Open3D normals, measured in a
process of its own just before each run with the same number of threads; starting Python and loading libraries is part of the run and
not of the floor. The best of the repetitions of each is taken: what else the machine does only adds. A run before them compiles.
With ``--record`` the ratios go to record.jsonl and are held against the last ones there (:mod:`.record`).
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

from tetratrack.benchmarks.accuracy.segmentation import floor, isolated
from tetratrack.benchmarks.performance.record import add_to_record
from tetratrack.benchmarks.performance.scale import run
from tetratrack.core.data.survey_reader import read_survey


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surveys", nargs="+", type=Path, metavar="SURVEY")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--record", action="store_true")
    options = parser.parse_args()
    told: list[str] = []
    columns = ("survey", "points", "workers", "floor s", "run s", "x floor", "CPU s", "points/s", "worker GiB", "parent GiB")
    print(f"| {' | '.join(columns)} |\n{'| --- ' * len(columns)}|")
    for folder in options.surveys:
        labels = [epoch.label for epoch in read_survey(folder / "survey.toml").epochs]
        with tempfile.TemporaryDirectory() as name:
            runs, floors = [], []
            for number in range(options.repeat + 1):
                base = [isolated(floor, folder, label, options.workers) for label in labels]
                runs.append(run(folder / "survey.toml", Path(name) / f"result{number}.gpkg", options.workers))
                floors.append(sum(part["seconds"] for part in base))
        points = sum(part["points"] for part in base)
        best, least = min(runs[1:], key=lambda r: r["seconds"]), min(floors[1:])
        cells = [folder.name, points, options.workers, f"{least:.2f}", f"{best['seconds']:.1f}", f"{best['seconds'] / least:.1f}"]
        cells += [f"{best['cpu']:.1f}", f"{points / best['seconds']:.0f}", f"{best['worker_gib']:.2f}", f"{best['parent_gib']:.2f}"]
        print(f"| {' | '.join(map(str, cells))} |", flush=True)
        if options.record:
            case = f"{folder.resolve().name}, {options.workers} workers"
            told += add_to_record("whole_run", case, {"run / floor": best["seconds"] / least, "CPU / floor": best["cpu"] / least})
    for line in told:
        print(line)


if __name__ == "__main__":
    main()
