"""A synthetic coast of 2, 8, 32 and 64 tiles of 50 units: throughput, peak memory of a worker and of the parent, parallel efficiency.

    python benchmarks/performance/scale.py [--tiles 2 8 32 64] [--epochs 1] [--workers 1 2] [--folder DIR] [--density 500] [--json FILE]
    python benchmarks/performance/scale.py --bend 0.03 --tiles 8 64 --epochs 2 --workers 1 --density 300

One simulated stretch of breakwater is repeated along the coast; every repetition is a tile. With ``--bend`` the whole coast is
simulated instead: every tile is a stretch of 40 units of its own, lines run through all of them, every epoch bends by so many metres
and stations of targets stand every 70 m. Each size runs ``tetratrack run`` in a process of its own. Wall-clock time depends on what
else the machine does; processor time hardly does, so both are given. Work is done by blocks, whose size decides the memory of a worker:
their number is given, and a coast of one block is worked on without workers.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import threading
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import laspy
import numpy as np
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.pipeline.epoch_plans import plan_survey
from tetratrack.core.simulation.bent_frames import FrameErrors
from tetratrack.core.simulation.coast import CoastSimulation
from tetratrack.core.simulation.survey_plan import SimulationPlan, plan_of
from tetratrack.core.simulation.virtual_survey import simulate_survey

UNITS_PER_TILE, UNITS_PER_STRETCH = 50, 40
BENT_SEED, BENT_TARGETS = 771, 70.0
"""Of a coast that bends: its seed, and the distance of its stations of targets in metres."""


def stretch(folder: Path, density: float, epochs: int) -> Path:
    """Simulate the stretch that is repeated: wall along east."""
    plan = SimulationPlan(
        "stretch",
        "uav",
        UNITS_PER_TILE,
        2.3,
        epochs,
        8,
        density,
        crs="EPSG:32650",
        azimuth_deg=0.0,
        tiles=(1, 1),
        origin=(500_000.0, 3_500_000.0, 0.0),
    )
    return simulate_survey(plan, folder).parent


def coast(source: Path, folder: Path, tiles: int) -> tuple[Path, int]:
    """Repeat a stretch; returns survey.toml and the number of points of all epochs."""
    stretches = [laspy.read(path) for path in sorted(source.glob("tiles/*/*.laz"))]
    length = max(float(las.x.max()) for las in stretches) - min(float(las.x.min()) for las in stretches)
    step = round(length / stretches[0].header.scales[0])
    text = (source / "survey.toml").read_text(encoding="utf-8").split("[[epoch]]")[0]
    for number, las in enumerate(stretches):
        label = f"epoch{number}"
        out = folder / "tiles" / label
        out.mkdir(parents=True)
        first = np.array(las.X)
        for k in range(tiles):
            las.X = first + k * step
            las.write(str(out / f"coast_{k:03d}.laz"))
        text += f'[[epoch]]\nlabel = "{label}"\ntime = {2024 + number}-04-09T02:30:00Z\ntiles = "tiles/{label}/*.laz"\n'
    survey = folder / "survey.toml"
    survey.write_text(text, encoding="utf-8")
    return survey, tiles * sum(len(las.X) for las in stretches)


def bent_coast(folder: Path, tiles: int, density: float, epochs: int, bend: float) -> tuple[Path, int]:
    """Simulate a coast whose epochs bend by ``bend`` metres, a stretch a tile; gives survey.toml and the points of all epochs."""
    plan = plan_of(
        "uav", "coast", units=UNITS_PER_STRETCH, epochs=epochs, seed=BENT_SEED, density=density, frame=FrameErrors(bend=bend), length=1.0,
        targets_every=BENT_TARGETS,
    )  # fmt: skip
    stretch_length = 2 * CoastSimulation(plan, folder).core
    survey = simulate_survey(replace(plan, length=tiles * stretch_length), folder)
    return survey, sum(_points_in(path) for path in folder.glob("tiles/*/*.laz"))


def _points_in(path: Path) -> int:
    with laspy.open(path) as reader:
        return int(reader.header.point_count)


def blocks_of(survey: Path) -> int:
    """Number of blocks of all epochs of a survey."""
    return sum(len(plan.blocks) for plan in plan_survey(read_survey(survey)))


class WorkerMemory(threading.Thread):
    """Peak resident memory of a process and its descendants, read from /proc while it runs."""

    def __init__(self, root: int) -> None:
        super().__init__(daemon=True)
        self.root = root
        self.peaks: dict[int, int] = {}
        self.ended = threading.Event()

    def run(self) -> None:
        while not self.ended.wait(0.1):
            for pid in self._family():
                try:
                    status = Path(f"/proc/{pid}/status").read_text(encoding="ascii")
                except (FileNotFoundError, ProcessLookupError):
                    continue
                for line in status.splitlines():
                    if line.startswith("VmHWM:"):
                        self.peaks[pid] = int(line.split()[1])

    def _family(self) -> list[int]:
        parents: dict[int, list[int]] = {}
        for entry in Path("/proc").iterdir():
            if not entry.name.isdigit():
                continue
            try:
                fields = (entry / "stat").read_text(encoding="ascii", errors="replace").rpartition(")")[2].split()
            except (FileNotFoundError, ProcessLookupError):
                continue
            parents.setdefault(int(fields[1]), []).append(int(entry.name))
        found: list[int] = []
        todo = [self.root]
        while todo:
            found.append(todo.pop())
            todo += parents.get(found[-1], [])
        return found

    def peak_gib(self, *, parent: bool) -> float:
        """Largest peak of the parent, or of its workers (the parent itself where there are none)."""
        chosen = [v for pid, v in self.peaks.items() if (pid == self.root) == parent]
        return max(chosen or list(self.peaks.values()), default=0) / 2**20


def run(survey: Path, output: Path, workers: int) -> dict[str, Any]:
    """One run of the command: wall-clock and processor seconds, peak memory, units found."""
    program = Path(sys.executable).with_name("tetratrack")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.perf_counter()
    environment = os.environ | {"OMP_NUM_THREADS": "1"}
    command = [str(program), "run", str(survey), "--output", str(output), "--workers", str(workers), "--quiet"]
    with subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        memory = WorkerMemory(process.pid)
        memory.start()
        text, _ = process.communicate()
        memory.ended.set()
        memory.join()
    seconds = time.perf_counter() - start
    if process.returncode:
        raise SystemExit(f"{' '.join(command)} failed ({process.returncode}):\n{text}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {
        "seconds": seconds,
        "cpu": cpu,
        "worker_gib": memory.peak_gib(parent=False),
        "parent_gib": memory.peak_gib(parent=True),
        "units": found_units(output),
    }


def found_units(result: Path) -> int:
    """Sightings of units in a result that count as found."""
    import pyogrio

    states = pyogrio.read_dataframe(result, layer="units", read_geometry=False)["status"]
    return int(states.isin(["found", "new", "relocated"]).sum())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tiles", nargs="+", type=int, default=[2, 8, 32, 64])
    parser.add_argument("--epochs", type=int, default=1)
    parser.add_argument("--workers", nargs="+", type=int, default=[1, 2])
    parser.add_argument("--bend", type=float, default=0.0, help="of every epoch, metres rms per coordinate")
    parser.add_argument("--density", type=float, default=500, help="points per square metre, all lines together")
    parser.add_argument("--folder", type=Path, help="where the coast is made (default: a temporary folder)")
    parser.add_argument("--json", type=Path, help="write the figures to this file as well")
    options = parser.parse_args()
    rows: list[dict[str, Any]] = []
    columns = (
        "tiles",
        "blocks",
        "units",
        "points",
        "workers",
        "found",
        "s",
        "points/s",
        "units/s",
        "CPU µs/point",
        "worker GiB",
        "parent GiB",
        "speed-up",
    )
    print(f"| {' | '.join(columns)} |")
    print("| --- " * len(columns) + "|")
    with tempfile.TemporaryDirectory(dir=options.folder) as name:
        work = Path(name)
        bent = options.bend > 0
        source = None if bent else stretch(work / "stretch", options.density, options.epochs)
        for tiles in options.tiles:
            folder = work / f"coast{tiles}"
            if source is None:
                survey, points = bent_coast(folder, tiles, options.density, options.epochs, options.bend)
            else:
                survey, points = coast(source, folder, tiles)
            blocks = blocks_of(survey)
            alone: float | None = None
            for workers in options.workers:
                r = run(survey, folder / f"result{workers}.gpkg", workers)
                alone = r["seconds"] if workers == 1 else alone
                units = tiles * (UNITS_PER_STRETCH if bent else UNITS_PER_TILE) * options.epochs
                r |= {"tiles": tiles, "blocks": blocks, "true_units": units, "points": points, "workers": workers}
                rows.append(r)
                rates = (points / r["seconds"], units / r["seconds"], 1e6 * r["cpu"] / points, r["worker_gib"], r["parent_gib"])
                cells = [
                    tiles,
                    blocks,
                    units,
                    points,
                    workers,
                    r["units"],
                    f"{r['seconds']:.1f}",
                    f"{rates[0]:.0f}",
                    f"{rates[1]:.2f}",
                    f"{rates[2]:.1f}",
                ]
                cells += [f"{rates[3]:.2f}", f"{rates[4]:.2f}", "-" if alone is None else f"{alone / r['seconds']:.2f}"]
                print(f"| {' | '.join(map(str, cells))} |", flush=True)
    if options.json:
        options.json.write_text(json.dumps(rows, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
