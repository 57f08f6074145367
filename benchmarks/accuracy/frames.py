"""Systematic errors of long surveys, which the paper leaves to future work: amplitude, wave length and spacing of targets.

    python benchmarks/accuracy/frames.py [--seeds 4] [--first 0] [--image docs/images/frames.png] [--json FILE]

Coasts of 168 m are drawn as displacements of 770 units with their covariances, two epochs bent each for itself by a sum of sinusoids,
15 % of the units moved by 2 to 20 cm, and eight targets a station (``tests/helpers/bent_coast.py``): no clouds, so that every cell of
the table is a mean over seeds. Each coast is judged as a run judges it, with frames that may bend and with rigid ones.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "helpers"))

from bent_coast import BentCoast, bent_coast
from tetratrack.core.deformation.congruence import congruence_of
from tetratrack.core.deformation.elastic_congruence import elastic_congruence_of
from tetratrack.core.deformation.epoch_frames import EpochFrames, PairShifts, estimate_frames
from tetratrack.core.deformation.target_shifts import TargetShifts

HEIGHT = 2.3
DEGREES = 40.0
AMPLITUDES = (0.0, 0.01, 0.03, 0.05)
WAVES = ((30.0, 60.0), (60.0, 300.0))
STATIONS = (25.0, 50.0, 70.0, 0.0)


def frames_of(coast: BentCoast) -> EpochFrames | None:
    """Frames of both epochs as a run estimates them."""
    names = tuple(f"T{k}" for k in range(len(coast.targets)))
    variances = np.full(coast.targets.shape, coast.target_sd**2)
    targets = [
        TargetShifts(
            ids=names, positions=coast.targets, residuals=residuals, variances=variances, surveyed_variances=np.zeros_like(variances)
        )
        if names
        else None
        for residuals in coast.residuals
    ]
    shifts = PairShifts(places=coast.places, vectors=coast.displacements, covariances=coast.covariances)
    return estimate_frames([shifts], targets, coast.places, HEIGHT, "auto")


def judge(coast: BentCoast) -> dict[str, float]:
    """Errors (mm), normalised errors and flags of one coast, both datums, and with rigid frames."""
    resting = coast.resting
    origin = coast.places.mean(axis=0)
    rigid = congruence_of(coast.displacements, coast.covariances, coast.places, None, origin, HEIGHT, DEGREES)
    part = rigid.rigid_motions(coast.places, "stable").means[:, :3]
    found = {"rigid_rmse": rmse((coast.displacements - part)[resting]), "rigid_found": flagged(rigid.p_values[~resting])}
    frames = frames_of(coast)
    if frames is None:
        spread = rigid.rigid_motions(coast.places, "stable").covariances[:, :3, :3]
        return found | errors("stable", coast, part, spread, rigid.null.covariance(coast.covariances), rigid.p_values)
    control, precision = frames.between(0, 1)
    result, datum = elastic_congruence_of(
        coast.displacements, coast.covariances, coast.places, control, precision, HEIGHT, frames.degrees,
        frames.jumped(0, 1, coast.places), frames.controlled(0, 1),
    )  # fmt: skip
    own = result.null.covariance(coast.covariances)
    stable = datum.stable.at(coast.places).without(coast.displacements, own, datum.used.astype(np.float64))
    at_control = datum.control.at(coast.places)
    found |= errors("stable", coast, stable.means[:, :3], stable.covariances[:, :3, :3], own, result.p_values)
    return found | errors("control", coast, at_control.means[:, :3], at_control.covariances[:, :3, :3], own, result.control_p_values)


def errors(datum: str, coast: BentCoast, part: Any, spread: Any, own: Any, p_values: Any) -> dict[str, float]:
    """Figures of one datum."""
    resting = coast.resting
    away = (coast.displacements - part - coast.motions)[resting]
    variance = np.einsum("nii->ni", own + spread)[resting]
    return {
        f"{datum}_rmse": rmse(away),
        f"{datum}_normalised": float(np.mean(away**2 / variance)),
        f"{datum}_false": flagged(p_values[resting]),
        f"{datum}_found": flagged(p_values[~resting]),
    }


def rmse(vectors: Any) -> float:
    """Root mean square length, millimetres."""
    return 1000 * float(np.sqrt(np.mean(np.sum(vectors**2, axis=1))))


def flagged(p_values: Any) -> float:
    """Share that is significant at 5 %."""
    return float(np.mean(p_values < 0.05)) if len(p_values) else math.nan


def picture(rows: list[dict[str, Any]], path: Path) -> None:
    """RMSE of both datums over the amplitude, by wave length and spacing of targets."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 3.6), dpi=150, layout="constrained")
    FigureCanvasAgg(figure)
    for number, waves in enumerate(WAVES):
        axes = figure.add_subplot(1, 2, number + 1)
        own = [row for row in rows if row["waves"] == list(waves)]
        for station, colour in zip(STATIONS, ("#0072B2", "#009E73", "#E69F00", "#7F8C8D"), strict=True):
            line = sorted((row for row in own if row["station"] == station), key=lambda row: row["amplitude"])
            name = f"targets every {station:.0f} m" if station else "no targets"
            axes.plot([100 * r["amplitude"] for r in line], [r["stable_rmse"] for r in line], "o-", color=colour, markersize=3, label=name)
            if station:
                control = [r.get("control_rmse", math.nan) for r in line]
                axes.plot([100 * r["amplitude"] for r in line], control, "s--", color=colour, markersize=3)
        rigid = sorted((row for row in own if row["station"] == 50.0), key=lambda row: row["amplitude"])
        axes.plot([100 * r["amplitude"] for r in rigid], [r["rigid_rmse"] for r in rigid], "x:", color="#C0392B", label="rigid frames")
        axes.set_yscale("log")
        axes.set_title(f"waves of {waves[0]:.0f} to {waves[1]:.0f} m", fontsize=9)
        axes.set_xlabel("bend of each epoch, rms per coordinate (cm)", fontsize=8)
        axes.set_ylabel("displacement RMSE of resting units (mm)", fontsize=8)
        axes.tick_params(labelsize=7)
        axes.legend(fontsize=6, frameon=False)
    figure.savefig(path, metadata={"Software": None})


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=4)
    parser.add_argument("--first", type=int, default=0, help="first seed")
    parser.add_argument("--image", type=Path)
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    rows: list[dict[str, Any]] = []
    columns = (
        "bend (cm)",
        "waves (m)",
        "targets every (m)",
        "rigid: RMSE (mm), found",
        "stable: RMSE, z², false, found",
        "control: RMSE, z², false (of each coast)",
    )
    print("| " + " | ".join(columns) + " |")
    print("| --- | --- | --- | --- | --- | --- |")
    for amplitude in AMPLITUDES:
        for waves in WAVES:
            for station in STATIONS:
                coasts = [
                    judge(bent_coast(seed, rms=amplitude, shortest=waves[0], longest=waves[1], station=station))
                    for seed in range(arguments.first, arguments.first + arguments.seeds)
                ]
                keys = sorted({key for coast in coasts for key in coast})
                mean = {key: float(np.mean([coast[key] for coast in coasts if key in coast])) for key in keys}
                rows.append({"amplitude": amplitude, "waves": list(waves), "station": station, **mean})
                flags = [coast["control_false"] for coast in coasts if "control_false" in coast]
                rows[-1] |= {"control_false_least": min(flags, default=math.nan), "control_false_most": max(flags, default=math.nan)}
                print(line_of(rows[-1]), flush=True)
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=1), encoding="utf-8")
    if arguments.image:
        picture(rows, arguments.image)


def line_of(row: dict[str, Any]) -> str:
    """Row of the table."""
    control = "–"
    if "control_rmse" in row and row["station"]:
        each = f"{100 * row['control_false_least']:.1f}–{100 * row['control_false_most']:.1f}"
        control = f"{row['control_rmse']:.1f}, {row['control_normalised']:.2f}, {row['control_false']:.1%} ({each})"
    station = f"{row['station']:.0f}" if row["station"] else "never"
    return (
        f"| {100 * row['amplitude']:.0f} | {row['waves'][0]:.0f}–{row['waves'][1]:.0f} | {station} | "
        f"{row['rigid_rmse']:.1f}, {row['rigid_found']:.0%} | {row['stable_rmse']:.1f}, {row['stable_normalised']:.2f}, "
        f"{row['stable_false']:.1%}, {row['stable_found']:.1%} | {control} |"
    )


if __name__ == "__main__":
    main()
