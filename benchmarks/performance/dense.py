"""A cloud so dense that most of its points say nothing new: time beside its own floor, and what becomes of units and displacements.

    python benchmarks/performance/dense.py [SURVEY] [--copies 16] [--scatter 0.004] [--folder DIR] [--workers 2] [--record]

Every point of a survey (a simulated photogrammetric one where none is given) is written so many times with scatter. The thin survey, its
dense copy and the floor of that are run in a process each, the caches of tiles emptied before: reading all tiles as they are with laspy and
thinning them to 0.02 H with Open3D normals. Units of both results are one where their centres lie within 0.1 H.
"""

from __future__ import annotations

import argparse
import os
import shutil
import tempfile
import time
from pathlib import Path
from typing import Any

import laspy
import numpy as np
import pyogrio
from tetratrack.benchmarks.accuracy.peers import VOXEL, with_normals
from tetratrack.benchmarks.accuracy.segmentation import isolated
from tetratrack.benchmarks.performance.record import add_to_record
from tetratrack.benchmarks.performance.scale import run
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.simulation.survey_plan import SimulationPlan
from tetratrack.core.simulation.virtual_survey import simulate_survey

SAME_HEIGHTS = 0.1
WELL_SEEN = 0.3


def copy_densely(source: Path, target: Path, copies: int, scatter: float) -> int:
    """Write a survey with every point so many times, with normal ``scatter`` (metres) in each coordinate; returns its points."""
    rng = np.random.default_rng(1)
    shutil.copytree(source, target, ignore=shutil.ignore_patterns("tiles"))
    total = 0
    for path in sorted(source.glob("tiles/**/*.la[sz]")):
        las = laspy.read(path)
        dense = laspy.LasData(las.header)
        dense.points = las.points[np.tile(np.arange(len(las.points)), copies)]
        for axis, scale in zip("XYZ", las.header.scales, strict=True):
            dense[axis] = np.asarray(dense[axis]) + np.rint(rng.normal(0, scatter, len(dense.points)) / scale).astype(np.int32)
        place = target / path.relative_to(source)
        place.parent.mkdir(parents=True, exist_ok=True)
        dense.write(str(place))
        total += len(dense.points)
    return total


def raw_floor(folder: Path, label: str, workers: int) -> dict[str, Any]:
    """Seconds for an epoch's tiles read as they are, thinned, and given normals."""
    survey = read_survey(folder / "survey.toml")
    start, worked = time.perf_counter(), time.process_time()
    clouds = [laspy.read(path).xyz for path in survey.epoch(label).tiles]
    points = np.concatenate([np.asarray(cloud) for cloud in clouds])
    with_normals(points - points.min(axis=0), VOXEL * survey.unit.height)
    return {"seconds": time.perf_counter() - start, "cpu": time.process_time() - worked}


def compared(thin: Path, dense: Path, height: float) -> str:
    """Sentences on units and displacements of two results of one survey."""
    told = []
    one, other = (pyogrio.read_dataframe(path, layer="units") for path in (thin, dense))
    seen: dict[str, float] = {}
    for epoch in sorted(set(one["epoch"])):
        a, b = (frame[(frame["epoch"] == epoch) & frame.geometry.notna() & frame["coverage"].notna()] for frame in (one, other))
        distance = np.linalg.norm(_places(a)[:, None] - _places(b)[None], axis=2)
        near = distance.min(axis=1) < SAME_HEIGHTS * height
        for name, coverage in zip(a["unit_id"], a["coverage"], strict=True):
            seen[name] = min(seen.get(name, 1.0), coverage)
        lost = ", ".join(f"{100 * c:.1f} %" for c in a["coverage"][~near]) or "none"
        told.append(
            f"{epoch}: {len(a)} and {len(b)} units, {int(near.sum())} in both; the surface seen of those in the thin cloud only: {lost}"
        )
    moves = []
    for path in (thin, dense):
        frame = pyogrio.read_dataframe(path, layer="displacements")
        frame = frame[frame["feature"] == "centre"]
        starts = np.array([line.coords[0] for line in frame.geometry])
        moves.append(
            (starts, frame[["de", "dn", "dh"]].to_numpy(float), frame[["sd_e", "sd_n", "sd_h"]].to_numpy(float), list(frame["unit_id"]))
        )
    distance = np.linalg.norm(moves[0][0][:, None] - moves[1][0][None], axis=2)
    nearest, near = distance.argmin(axis=1), distance.min(axis=1) < SAME_HEIGHTS * height
    difference = 1000 * np.linalg.norm(moves[0][1] - moves[1][1][nearest], axis=1)
    sds = np.linalg.norm(moves[0][2], axis=1), np.linalg.norm(moves[1][2][nearest], axis=1)
    well = near & (np.array([seen.get(name, 0.0) for name in moves[0][3]]) >= WELL_SEEN)
    for what, chosen in (("all units", near), (f"units seen {100 * WELL_SEEN:.0f} % or more", well)):
        told.append(
            f"displacements of {int(chosen.sum())}, {what}: differences of median {np.median(difference[chosen]):.2f} mm, 90 % below "
            f"{np.percentile(difference[chosen], 90):.2f} mm; stated deviations median {1000 * np.median(sds[0][chosen]):.1f} mm, ratio "
            f"dense to thin {np.median(sds[1][chosen] / sds[0][chosen]):.3f}"
        )
    return "\n".join(told)


def _places(units: Any) -> np.ndarray:
    return np.array([(point.x, point.y, point.z) for point in units.geometry]).reshape(-1, 3)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("survey", nargs="?", type=Path, help="a survey with tiles below its folder")
    parser.add_argument("--copies", type=int, default=16)
    parser.add_argument("--scatter", type=float, default=0.004)
    parser.add_argument("--folder", type=Path, help="where surveys are made (default: a temporary folder)")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--seed", type=int, default=2101)
    parser.add_argument("--record", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=options.folder) as name:
        work = Path(name)
        source = options.survey
        if source is None:
            place = {"crs": "EPSG:2154", "origin": (1176200.0, 6105300.0, 0.0)}
            plan = SimulationPlan("thin", "photogrammetry", 60, 2.6, 2, options.seed, azimuth_deg=200.0, **place)
            source = simulate_survey(plan, work / "thin").parent
        points = copy_densely(source, work / "dense", options.copies, options.scatter)
        survey = read_survey(source / "survey.toml")
        floors = [isolated(raw_floor, work / "dense", epoch.label, options.workers) for epoch in survey.epochs]
        floor, floor_cpu = (sum(part[key] for part in floors) for key in ("seconds", "cpu"))
        runs = {}
        for kind, folder in (("thin", source), ("dense", work / "dense")):
            os.environ["XDG_CACHE_HOME"] = str(work / f"cache_{kind}")
            runs[kind] = run(folder / "survey.toml", work / f"{kind}.gpkg", options.workers)
        dense = runs["dense"]
        print(
            f"{points} points, {options.workers} workers: floor {floor:.1f} s ({floor_cpu:.1f} CPU s), run {dense['seconds']:.1f} s "
            f"({dense['cpu']:.1f} CPU s), {dense['seconds'] / floor:.2f} x floor; thin cloud {runs['thin']['seconds']:.1f} s "
            f"({runs['thin']['cpu']:.1f} CPU s); worker {dense['worker_gib']:.2f} GiB, parent {dense['parent_gib']:.2f} GiB"
        )
        print(compared(work / "thin.gpkg", work / "dense.gpkg", survey.unit.height))
        if options.record:
            ratios = {"run / floor": dense["seconds"] / floor, "CPU / floor": dense["cpu"] / floor_cpu}
            for line in add_to_record("dense", f"{options.survey or 'simulated'}, {options.copies} copies", ratios):
                print(line)


if __name__ == "__main__":
    main()
