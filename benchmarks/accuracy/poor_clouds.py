"""How much of a pile is found in sparse, noisy and one-sided clouds, and how well displacements come out; the phase diagram of both.

    .venv/bin/python benchmarks/accuracy/poor_clouds.py SURVEY... [--stations TLS_SURVEY] [--run] [--phase] [--folder KEEP] [--json FILE]
    .venv/bin/python benchmarks/accuracy/poor_clouds.py --image FILE

Surveys are folders with ground truth (../shared/data/uav; simulated ones). Copies thinned to so many points per H², noised to so much of H,
and of --stations the points of one scanner station alone, are segmented, and with --run run as a whole: then displacements count too.
--phase goes through densities and noises together and prints the table of ``core/adjustment/expectation.py`` as well; --image draws that
table. The same seed makes the same copies.
"""

from __future__ import annotations

import argparse
import csv
import json
import sqlite3
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import laspy
import numpy as np
from tetratrack.benchmarks.accuracy.honesty import matched
from tetratrack.benchmarks.accuracy.poor_copies import Poverty, points_per_square, poor_copy
from tetratrack.benchmarks.ground_truth import BINS, EpochCloud, match, point_labels, read_epoch, recall_by_visibility
from tetratrack.core.adjustment.expectation import CLASSES, DENSITIES, NOISES, RECALL, expected
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey import Survey
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.pipeline.run_options import RunOptions
from tetratrack.core.pipeline.whole_survey import run_survey
from tetratrack.core.segmentation.segment import segment
from tetratrack.core.segmentation.surface_elements import surface_noise

POOR = (
    *(Poverty("density", v) for v in (1600, 800, 400)),
    *(Poverty("noise", v) for v in (0.013, 0.021, 0.033)),
)
STATIONS = (2, 3, 5)
SHOWN_HEIGHT = 2.3
"""Of the units for which the detection limit is drawn, metres."""
SEEN_WELL = 0.15
"""Visible share in both epochs of the units whose displacements count."""


@dataclass
class Figures:
    """What was found on one or more copies.

    Attributes
    ----------
    found, there
        (3,) units found, and units there, by ``BINS``.
    wrong, right
        Units stated as found that are none, or are right.
    scores
        (score, whether right) of every pose reported.
    """

    found: np.ndarray[Any, Any] = field(default_factory=lambda: np.zeros(3, dtype=np.int64))
    there: np.ndarray[Any, Any] = field(default_factory=lambda: np.zeros(3, dtype=np.int64))
    wrong: int = 0
    right: int = 0
    scores: list[tuple[float, bool]] = field(default_factory=list)

    def add(self, cloud: EpochCloud, poses: Sequence[Pose], scores: Sequence[float], sure: Sequence[bool], unit: UnitType) -> None:
        """Count the units of one epoch."""
        stated = [pose for pose, is_sure in zip(poses, sure, strict=True) if is_sure]
        result = match(stated, cloud.truth, unit)
        counts = np.array(recall_by_visibility(result, cloud.truth))
        self.found, self.there = self.found + counts[:, 0], self.there + counts[:, 1]
        self.wrong += len(result.wrong)
        self.right += len(stated) - len(result.neutral) - len(result.wrong)
        every = match(list(poses), cloud.truth, unit)
        hits = set(every.pairs[:, 0].tolist())
        self.scores += [(float(s), k in hits) for k, s in enumerate(scores) if k not in every.neutral]

    @property
    def recall(self) -> str:
        """By class of visible share."""
        return " / ".join(f"{k / n:.2f}" if n else "–" for k, n in zip(self.found, self.there, strict=True))

    @property
    def precision(self) -> str:
        """Of the units stated as found."""
        return f"{self.right / (self.right + self.wrong):.3f}" if self.right + self.wrong else "–"


def segmented(folder: Path) -> Figures:
    """Units of all epochs of a survey, by segmentation alone."""
    survey, figures = read_survey(folder / "survey.toml"), Figures()
    for epoch in survey.epochs:
        cloud = read_epoch(survey, epoch.label)
        units = segment(cloud.points, survey.unit, workers=1).units
        figures.add(cloud, [u.pose for u in units], [u.score for u in units], [u.status == "found" for u in units], survey.unit)
    return figures


def displaced(folder: Path) -> dict[str, Any]:
    """Whole run of a survey: recall of the result, errors of displacements of units seen well in both epochs, and false alarms."""
    survey = read_survey(folder / "survey.toml")
    result = folder / "result.gpkg"
    run_survey(survey, result, RunOptions(workers=1), Feedback())
    names, (right, wrong, _) = matched(result, folder)
    with (folder / "truth/units.csv").open() as stream:
        seen = {(r["unit_id"], r["epoch"]): float(r["visible_area_fraction"]) for r in csv.DictReader(stream) if r["E"]}
    with (folder / "truth/displacements.csv").open() as stream:
        truth = {(r["unit_id"], r["epoch_from"], r["epoch_to"]): r for r in csv.DictReader(stream)}
    sure = set(_sure(result))
    counted = [sum(1 for key, name in names.items() if key in sure and low <= seen[name, key[1]] < high) for low, high in BINS]
    there = [sum(1 for share in seen.values() if low <= share < high) for low, high in BINS]
    errors, alarms, limits = [], [], []
    query = "select unit_id, epoch_from, epoch_to, de, dn, dh, significant, detectable from displacements where feature = 'centre'"
    with sqlite3.connect(result) as connection:
        for unit, first, second, *vector, significant, limit in connection.execute(query):
            name = names.get((unit, first))
            if name is None or name != names.get((unit, second)) or (name, first, second) not in truth:
                continue
            if min(seen[name, first], seen[name, second]) < SEEN_WELL or {(unit, first), (unit, second)} - sure:
                continue
            row = truth[name, first, second]
            errors.append(float(np.linalg.norm(np.array(vector) - [float(row[k]) for k in ("de", "dn", "dh")])))
            limits.append(float(limit) if limit is not None else np.nan)
            if row["moved"] == "0":
                alarms.append(bool(significant))
    return {
        "recall": " / ".join(f"{k / n:.2f}" if n else "–" for k, n in zip(counted, there, strict=True)),
        "precision": right / max(right + wrong, 1),
        "rmse_mm": 1000 * float(np.sqrt(np.mean(np.square(errors)))) if errors else None,
        "limit_mm": 1000 * float(np.nanmedian(limits)) if errors else None,
        "alarms": float(np.mean(alarms)) if alarms else None,
    }


def _sure(result: Path) -> Iterator[tuple[str, str]]:
    """Unit and epoch of the units stated as found."""
    with sqlite3.connect(result) as connection:
        yield from connection.execute("select unit_id, epoch from units where status != 'uncertain' and geom is not null")


def phase(folders: Sequence[Path], seed: int) -> list[dict[str, Any]]:
    """Recall over density and noise together, on the first epoch of each survey."""
    rows = []
    for noise in NOISES:
        for density in DENSITIES:
            figures = Figures()
            for number, folder in enumerate(folders):
                survey = read_survey(folder / "survey.toml")
                cloud = read_epoch(survey, survey.epochs[0].label)
                points = _made_poor(
                    cloud.points, survey, density, noise, np.random.default_rng([seed, number, int(density), int(1e4 * noise)])
                )
                units = segment(points, survey.unit, workers=1).units
                figures.add(cloud, [u.pose for u in units], [u.score for u in units], [u.status == "found" for u in units], survey.unit)
            rows.append({"noise": noise, "density": density, "found": figures.found.tolist(), "there": figures.there.tolist()})
            print(f"| {100 * noise:.1f} % | {density:.0f} | {figures.recall} | {figures.precision} |", flush=True)
    return rows


def _made_poor(
    points: np.ndarray[Any, Any], survey: Survey, density: float, noise: float, rng: np.random.Generator
) -> np.ndarray[Any, Any]:
    """Points of the first epoch thinned to points per H² and noised to a share of H; a cloud that is poorer by itself stays as it is."""
    height, epoch = survey.unit.height, survey.epochs[0]
    clouds = [laspy.read(tile) for tile in epoch.tiles]
    present = points_per_square(clouds, [point_labels(survey, epoch.label, tile) for tile in epoch.tiles], height)
    more = np.sqrt(max((noise * height) ** 2 - surface_noise(points, height) ** 2, 0.0))
    kept = points[rng.random(len(points)) < density / present]
    return np.asarray(kept + rng.normal(0.0, more, kept.shape))


def table_of_phase(rows: Sequence[dict[str, Any]]) -> str:
    """Rows of ``RECALL`` in ``core/adjustment/expectation.py``."""
    lines = []
    for noise in NOISES:
        shares = [
            tuple(round(k / max(n, 1), 2) for k, n in zip(r["found"], r["there"], strict=True))
            for density in DENSITIES
            for r in rows
            if (r["noise"], r["density"]) == (noise, density)
        ]
        lines.append(f"    {tuple(shares)},")
    return "\n".join(lines)


def picture_of_phase(path: Path) -> None:
    """Shares of units found over points per H² and noise, one map for each class of visible share; lines: detection limit, % of H."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 3.2), dpi=150, layout="constrained")
    FigureCanvasAgg(figure)
    unit = UnitType.tetrapod(SHOWN_HEIGHT)
    limits = [[100 * expected(density, noise, unit).limit / unit.height for density in DENSITIES] for noise in NOISES]
    for number, name in enumerate(CLASSES):
        axes = figure.add_subplot(1, len(CLASSES), number + 1)
        shares = 100 * np.array(RECALL)[:, :, number]
        axes.imshow(shares, origin="lower", aspect="auto", cmap="YlGnBu", vmin=0, vmax=100)
        for row, column in np.ndindex(*shares.shape):
            colour = "white" if shares[row, column] > 55 else "black"
            axes.text(column, row + 0.3, f"{shares[row, column]:.0f}", ha="center", va="center", fontsize=8, color=colour)
        lines = axes.contour(limits, levels=(0.5, 1.0, 2.0), colors="#E67E22", linewidths=1.4)
        axes.clabel(lines, fmt="%g %%", fontsize=7)
        axes.set_xticks(range(len(DENSITIES)), [f"{density:.0f}" for density in DENSITIES], fontsize=7)
        axes.set_yticks(range(len(NOISES)), [f"{100 * noise:.1f}" for noise in NOISES], fontsize=7)
        axes.set_title(f"seen to {name}", fontsize=9)
        axes.set_xlabel("points per H²", fontsize=8)
        if not number:
            axes.set_ylabel("noise, % of H", fontsize=8)
    figure.savefig(path, metadata={"Software": None})


def calibration(scores: Sequence[tuple[float, bool]]) -> str:
    """How often poses of a stated score are right."""
    parts = []
    for low, high in ((0.0, 0.35), (0.35, 0.65), (0.65, 0.85), (0.85, 1.01)):
        inside = [ok for s, ok in scores if low <= s < high]
        parts.append(f"{low:.2f}-{min(high, 1.0):.2f}: {sum(inside)}/{len(inside)}")
    return ", ".join(parts)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surveys", nargs="*", type=Path, metavar="SURVEY", help="surveys to be thinned and noised")
    parser.add_argument("--stations", nargs="*", type=Path, default=[], help="scans of which single stations are kept")
    parser.add_argument("--run", action="store_true", help="whole runs as well")
    parser.add_argument("--phase", action="store_true", help="the phase diagram instead")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--folder", type=Path, help="where the copies are kept; without it they go")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--image", type=Path, help="the phase diagram as it is in the code, drawn")
    options = parser.parse_args()
    if options.image:
        picture_of_phase(options.image)
        return
    if options.phase:
        rows = phase(options.surveys, options.seed)
        print("\n" + table_of_phase(rows))
        if options.json:
            options.json.write_text(json.dumps(rows, indent=1), encoding="utf-8")
        return
    todo = [(folder, poverty) for folder in options.surveys for poverty in POOR]
    todo += [(folder, Poverty("station", station)) for folder in options.stations for station in STATIONS]
    results = []
    print("| copy | recall >= 30 / 15-30 / 5-15 % | precision | run: recall | precision | RMSE, mm | limit, mm | false alarms |")
    print("| --- " * 8 + "|")
    every: list[tuple[float, bool]] = []
    with tempfile.TemporaryDirectory() as temporary:
        for source, poverty in todo:
            copy = (options.folder or Path(temporary)) / f"{source.name}_{poverty.name}"
            if not copy.exists():
                copy.parent.mkdir(parents=True, exist_ok=True)
                poor_copy(source, copy, poverty, options.seed)
            figures = segmented(copy)
            every += figures.scores
            run = displaced(copy) if options.run else {}
            cells = [
                run.get("recall", "–"),
                *(_shown(run.get(k), d) for k, d in (("precision", ".3f"), ("rmse_mm", ".1f"), ("limit_mm", ".1f"), ("alarms", ".1%"))),
            ]
            print(f"| {copy.name} | {figures.recall} | {figures.precision} | {' | '.join(cells)} |", flush=True)
            results.append(asdict(poverty) | {"survey": source.name, "recall": figures.recall, "precision": figures.precision, "run": run})
    print("\nscores: " + calibration(every))
    if options.json:
        options.json.write_text(json.dumps(results, indent=1), encoding="utf-8")


def _shown(value: float | None, digits: str) -> str:
    return "–" if value is None else format(value, digits)


if __name__ == "__main__":
    main()
