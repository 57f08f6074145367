"""Find the units of surveys with ground truth: recall by visible share, precision, score calibration, time and peak memory.

    python benchmarks/accuracy/segmentation.py SURVEY... [--peers ppf fpfh fpfh-true cloudcompare] [--epochs 1] [--workers 1] [--json FILE]

SURVEY is a folder with survey.toml and truth/ (../shared/data/uav, or one made by ``tetratrack simulate``). Each run has a process of
its own, so that the peak memory is its own. The last column relates the time to the floor: reading the tiles, thinning to 0.02 H
and Open3D normals.
"""

from __future__ import annotations

import argparse
import itertools
import json
import multiprocessing
import resource
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from tetratrack.benchmarks.ground_truth import BINS, COUNTED, match, read_epoch, recall_by_visibility
from tetratrack.core.data.survey_reader import read_survey

PEERS = ("ppf", "fpfh", "fpfh-true", "cloudcompare")
SCORE_STEPS = (0.0, 0.25, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)


def floor(folder: Path, label: str, workers: int) -> dict[str, Any]:
    """Time of reading, thinning and normals alone."""
    from tetratrack.benchmarks.accuracy.peers import VOXEL, with_normals

    survey = read_survey(folder / "survey.toml")
    start = time.perf_counter()
    cloud = read_epoch(survey, label)
    with_normals(cloud.points, VOXEL * survey.unit.height)
    return {"seconds": time.perf_counter() - start, "points": len(cloud.points)}


def tetratrack(folder: Path, label: str, workers: int) -> dict[str, Any]:
    """Reading and segmentation, then quality against the truth."""
    from tetratrack.core.segmentation.segment import segment

    survey = read_survey(folder / "survey.toml")
    start = time.perf_counter()
    cloud = read_epoch(survey, label)
    found = segment(cloud.points, survey.unit, workers=workers)
    seconds = time.perf_counter() - start
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    sure = [u for u in found.units if u.status == "found"]
    result = quality(cloud, [u.pose for u in sure], survey.unit)
    every = match([u.pose for u in found.units], cloud.truth, survey.unit)
    right = {i for i, j in every.pairs.tolist() if cloud.truth[j].visible >= COUNTED}
    scores = [(u.score, i in right) for i, u in enumerate(found.units) if i not in every.neutral]
    return result | {
        "seconds": seconds,
        "peak_gib": peak,
        "uncertain": len(found.units) - len(sure),
        "interpenetration": max((u.interpenetration for u in sure), default=0.0),
        "scores": scores,
    }


def quality(cloud: Any, poses: list[Any], unit: Any) -> dict[str, Any]:
    """Recall by visible share, precision and errors after the epoch's mean offset."""
    matched = match(poses, cloud.truth, unit)
    counting = len(poses) - len(matched.neutral)
    seen = np.array([cloud.truth[j].visible >= 0.3 for j in matched.pairs[:, 1]], dtype=bool)
    errors = matched.centre_error - (matched.centre_error.mean(axis=0) if len(matched.pairs) else 0)
    return {
        "recall": recall_by_visibility(matched, cloud.truth),
        "found": len(poses),
        "wrong": len(matched.wrong),
        "precision": 1 - len(matched.wrong) / counting if counting else 1.0,
        "centre_rmse_mm": 1000 * float(np.sqrt(np.mean(np.sum(errors[seen] ** 2, axis=1)))) if seen.any() else None,
        "rotation_median_deg": float(np.median(matched.rotation_error_deg[seen])) if seen.any() else None,
    }


def peer(name: str) -> Callable[[Path, str, int], dict[str, Any]]:
    """Run of one of PEERS."""
    return {"ppf": _ppf, "fpfh": _fpfh, "fpfh-true": _fpfh_true, "cloudcompare": _cloudcompare}[name]


def _ppf(folder: Path, label: str, workers: int) -> dict[str, Any]:
    from tetratrack.benchmarks.accuracy.peers import point_pair_features

    return _poses(folder, label, lambda cloud, unit: point_pair_features(cloud, unit, len(cloud.truth)))


def _fpfh(folder: Path, label: str, workers: int) -> dict[str, Any]:
    from tetratrack.benchmarks.accuracy.peers import fpfh_blind

    return _poses(folder, label, lambda cloud, unit: fpfh_blind(cloud, unit, len(cloud.truth)))


def _fpfh_true(folder: Path, label: str, workers: int) -> dict[str, Any]:
    from tetratrack.benchmarks.accuracy.peers import fpfh_with_true_segments

    return _poses(folder, label, fpfh_with_true_segments)


def _poses(folder: Path, label: str, finder: Callable[[Any, Any], list[Any]]) -> dict[str, Any]:
    survey = read_survey(folder / "survey.toml")
    start = time.perf_counter()
    cloud = read_epoch(survey, label)
    poses = finder(cloud, survey.unit)
    seconds = time.perf_counter() - start
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    return quality(cloud, poses, survey.unit) | {"seconds": seconds, "peak_gib": peak}


def _cloudcompare(folder: Path, label: str, workers: int) -> dict[str, Any]:
    from tetratrack.benchmarks.accuracy.peers import cloudcompare_cones

    survey = read_survey(folder / "survey.toml")
    start = time.perf_counter()
    cloud = read_epoch(survey, label)
    cones = cloudcompare_cones(cloud, survey.unit)
    seconds = time.perf_counter() - start
    visible = np.array([t.visible for t in cloud.truth])
    two_legs = [
        (int(np.sum(cones.legs_found[(visible >= a) & (visible < b)] >= 2)), int(np.sum((visible >= a) & (visible < b)))) for a, b in BINS
    ]
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 2**20
    angles = [float(cones.angles_deg.min()), float(cones.angles_deg.max())] if len(cones.angles_deg) else None
    return {"recall": two_legs, "found": cones.cones, "seconds": seconds, "peak_gib": peak, "cone_half_angles_deg": angles}


def isolated(work: Callable[[Path, str, int], dict[str, Any]], folder: Path, label: str, workers: int) -> dict[str, Any]:
    """Result of ``work`` in a fresh process."""
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        return pool.apply(work, (folder, label, workers))


def calibration(results: list[dict[str, Any]]) -> str:
    """Markdown table: share of right units by score."""
    pairs = [pair for r in results for pair in r.get("scores", [])]
    lines = ["| score | right | wrong | share right |", "| --- | --- | --- | --- |"]
    for low, high in itertools.pairwise(SCORE_STEPS):
        inside = [ok for s, ok in pairs if low <= s < high or (high == 1.0 and s == 1.0)]
        share = f"{sum(inside) / len(inside):.3f}" if inside else "-"
        lines.append(f"| {low:.2f}-{high:.2f} | {sum(inside)} | {len(inside) - sum(inside)} | {share} |")
    sure = [ok for s, ok in pairs if s >= 0.5]
    if sure:
        lines.append(f"| **>= 0.5** | {sum(sure)} | {len(sure) - sum(sure)} | **{sum(sure) / len(sure):.3f}** |")
    return "\n".join(lines)


def row(r: dict[str, Any]) -> str:
    """One line of the table."""
    bins = " | ".join(f"{k}/{n}" for k, n in r["recall"])

    def show(key: str, digits: str) -> str:
        return "-" if r.get(key) is None else format(r[key], digits)

    cells = [show("precision", ".3f"), show("centre_rmse_mm", ".1f"), show("rotation_median_deg", ".2f"), show("seconds", ".1f")]
    cells += [show("times_floor", ".1f"), show("peak_gib", ".2f")]
    return f"| {r['survey']} {r['epoch']} | {r['method']} | {bins} | {' | '.join(cells)} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surveys", nargs="+", type=Path, metavar="SURVEY")
    parser.add_argument("--peers", nargs="*", choices=PEERS, default=[])
    parser.add_argument("--epochs", type=int, default=1, help="how many epochs of each survey (default 1)")
    parser.add_argument("--workers", type=int, default=-1, help="threads of the neighbour searches")
    parser.add_argument("--no-tetratrack", action="store_true", help="peers only")
    parser.add_argument("--json", type=Path, help="write the figures to this file as well")
    options = parser.parse_args()
    results: list[dict[str, Any]] = []
    print("| survey | method | >= 30 % | 15-30 % | 5-15 % | precision | centre RMSE, mm | rotation median, deg | s | x floor | peak GiB |")
    print("| --- " * 11 + "|")
    for folder in options.surveys:
        for epoch in read_survey(folder / "survey.toml").epochs[: options.epochs]:
            base = isolated(floor, folder, epoch.label, options.workers)
            methods = {} if options.no_tetratrack else {"tetratrack": tetratrack}
            for name, work in (methods | {p: peer(p) for p in options.peers}).items():
                r = isolated(work, folder, epoch.label, options.workers)
                r |= {"survey": folder.name, "epoch": epoch.label, "method": name, "times_floor": r["seconds"] / base["seconds"]}
                results.append(r)
                print(row(r), flush=True)
    if not options.no_tetratrack:
        print("\n" + calibration(results))
    if options.json:
        options.json.write_text(json.dumps(results, indent=1), encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
