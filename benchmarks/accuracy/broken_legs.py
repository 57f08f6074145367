"""Are broken legs named, and none invented? Counts legs of surveys with ground truth one by one, and says whether probabilities are true.

    .venv/bin/python benchmarks/accuracy/broken_legs.py SURVEY_FOLDER... [--result FILE.gpkg] [--seed N]

Legs are judged at poses of truth that err as fits do (--seed draws how), from the points of each epoch and then by all epochs together, as
runs do; with --result, a run of the one folder given is judged instead, its units that are found and right. A leg of truth is

- *broken and seen*, if so in truth and 20 points or more of it lie beyond its joint (0.45 of its length);
- *shown*, if 20 points or more of the cloud show the break: a whole leg would have stopped their beams;
- *whole*, if not broken in truth, seen or not: of these none should be named broken.

For each folder and for all a line: broken legs named of those seen and of those shown, whole legs named broken, all in sightings (a leg in
one epoch), and the error of the missing length of named ones, median, metres. Then the reliability of the probabilities of all legs that
something is said of (of a result: that are named broken): legs, mean probability and share broken by classes of the probability.
Truth of earlier simulators names no leg: there the leg is taken whose points lie inside the nominal solid, or end before its end.
"""

from __future__ import annotations

import argparse
import math
import sqlite3
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import laspy
import numpy as np
from scipy.spatial.transform import Rotation
from tetratrack.benchmarks.ground_truth import EpochCloud, number_of, read_epoch, unit_rows
from tetratrack.core.common.arrays import FloatArray
from tetratrack.core.data.survey import Survey
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.deformation.legs_over_epochs import legs_over_epochs
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.ends_of_units import ends_of_units
from tetratrack.core.segmentation.leg_ends import BROKEN, LEG_STATES, LegEnds
from tetratrack.core.simulation.leg_truth import JOINT

SEEN, SHOWN = 20, 20
"""Points of a leg beyond its joint from which it is seen, and points that show its break from which that is."""
END, NONE_AT_END = 0.9, 0.05
"""Share of a leg beyond which its points are of its end, and share of a stump's points there that are mixed pixels or of a neighbour."""
DEPTH_HEIGHTS = 0.05
"""Depth below the nominal surface beyond which points of a unit are of a face of fracture."""
SAME_UNIT_HEIGHTS = 0.25
"""Distance of a centre from the true one, in unit heights, up to which a unit is right."""
CENTRE_HEIGHTS, TURN_DEG = 0.001, 0.15
"""Standard deviations per coordinate and axis of poses that err as fits of castings do."""
FOUND = 0.05
"""Share of a unit that is seen from which runs find it."""
COLUMNS = ("survey", "named of seen", "named of shown", "named of whole", "error of the missing length, m")
CLASSES = (0.0, 0.01, 0.1, 0.5, 0.9, 0.99, 1.0)
"""Bounds of the classes of probabilities."""


@dataclass(frozen=True)
class TrueLegs:
    """Truth of the legs of a unit in one epoch.

    Attributes
    ----------
    broken
        Leg 0..3 that is broken, -1 for none.
    missing
        Length missing of it, metres; nan where truth does not say.
    points
        (4,) points of the legs beyond their joints.
    shown
        Points that show the break; nan where truth does not say.
    """

    broken: int
    missing: float
    points: FloatArray
    shown: float


@dataclass
class Count:
    """Sightings of legs: named of those that are broken and seen, and shown, named of whole ones, and probabilities with the truth."""

    seen: FloatArray
    shown: FloatArray
    whole: FloatArray
    lengths: list[float]
    told: list[tuple[float, bool]]

    @classmethod
    def none(cls) -> Count:
        """Of nothing."""
        return cls(np.zeros(2), np.zeros(2), np.zeros(2), [], [])

    def add(self, legs: LegEnds, truth: TrueLegs) -> None:
        """Count the legs of a sighting, numbered as in truth."""
        for k in range(4):
            named = float(legs.states[k] == BROKEN)
            if not math.isnan(legs.broken[k]):
                self.told.append((float(legs.broken[k]), k == truth.broken))
            if k != truth.broken:
                self.whole += (named, 1)
                continue
            self.seen += (named, 1) if truth.points[k] >= SEEN else (0, 0)
            self.shown += (named, 1) if truth.shown >= SHOWN else (0, 0)
            if named and not math.isnan(truth.missing):
                self.lengths.append(abs(float(legs.missing[k]) - truth.missing))

    def joined(self, other: Count) -> Count:
        """Of both."""
        return Count(
            self.seen + other.seen, self.shown + other.shown, self.whole + other.whole, self.lengths + other.lengths, self.told + other.told
        )

    def line(self, name: str) -> str:
        """Row of the table."""
        pairs = [f"{int(named)}/{int(of)}" for named, of in (self.seen, self.shown, self.whole)]
        length = f"{np.median(self.lengths):.2f}" if self.lengths else ""
        return "| " + " | ".join([name, *pairs, length]) + " |"

    def reliability(self) -> list[str]:
        """Rows of the table of probabilities."""
        told = np.array(self.told, dtype=float).reshape(-1, 2)
        rows = []
        for low, high in pairwise(CLASSES):
            own = told[(told[:, 0] >= low) & ((told[:, 0] < high) | (high == CLASSES[-1]))]
            if len(own):
                rows.append(f"| {low:g} to {high:g} | {len(own)} | {own[:, 0].mean():.4f} | {own[:, 1].mean():.4f} |")
        return rows


def true_legs(folder: Path, survey: Survey) -> dict[tuple[str, str], TrueLegs]:
    """Legs by unit and epoch."""
    rows = [row for row in unit_rows(folder) if row["E"]]
    if "broken_leg" not in rows[0]:
        return _legs_of_labels(rows, folder, survey)
    return {
        (row["unit_id"], row["epoch"]): TrueLegs(
            int(row["broken_leg"]) - 1,
            float(row["leg_missing"]),
            np.array([float(row[f"leg{k}_points"]) for k in range(1, 5)]),
            float(row["break_points"]),
        )
        for row in rows
    }


def _legs_of_labels(rows: Sequence[dict[str, str]], folder: Path, survey: Survey) -> dict[tuple[str, str], TrueLegs]:
    """The same from labelled points: by those of all epochs, the leg with most of them inside its solid, or stopping before its end."""
    unit = survey.units[0].type
    found = {(row["unit_id"], row["epoch"]): TrueLegs(-1, math.nan, np.zeros(4), math.nan) for row in rows}
    counts: dict[str, dict[str, FloatArray]] = {}
    for epoch in survey.epochs:
        labelled = folder / f"truth/labels_{epoch.label}.npz"
        own = [row for row in rows if row["epoch"] == epoch.label and row["broken"] == "1"]
        if not own or not labelled.exists():
            continue
        with np.load(labelled) as labels:
            clouds = [(laspy.read(path), labels[path.stem]) for path in epoch.tiles if path.stem in labels]
        points = np.vstack([np.column_stack([las.x, las.y, las.z]) for las, _ in clouds])
        numbers = np.concatenate([those for _, those in clouds])
        for row in own:
            turn = Rotation.from_quat([float(row[k]) for k in ("qx", "qy", "qz", "qw")])
            body = turn.inv().apply(points[numbers == number_of(row["unit_id"])] - [float(row[k]) for k in "ENH"])
            counts.setdefault(row["unit_id"], {})[epoch.label] = _by_leg(body, unit)
    for name, epochs in counts.items():
        face, stump, end = sum(epochs.values())
        early = np.where(end < NONE_AT_END * stump, stump, 0.0)
        leg = int((face if face.max() >= SEEN else early).argmax())
        for epoch_name, (_, points_of, _) in epochs.items():
            found[name, epoch_name] = TrueLegs(leg, math.nan, points_of, math.nan)
    return found


def _by_leg(body: FloatArray, unit: UnitType) -> FloatArray:
    """(3, 4) points of the face of fracture, beyond the joint and at the end of each leg."""
    lean = body @ unit.leg_directions.T
    axial, leg = lean.max(axis=1), lean.argmax(axis=1)
    rho = np.sqrt(np.maximum(np.einsum("ij,ij->i", body, body) - axial**2, 0.0))
    deep = unit.radius - unit.gradient * axial - rho > DEPTH_HEIGHTS * unit.height
    along = axial / unit.leg_length
    parts = deep & (along > 0.5) & (along < END), along > JOINT, along > END
    return np.array([np.bincount(leg[part], minlength=4) for part in parts], dtype=np.float64)


def judged_at_truth(survey: Survey, rng: np.random.Generator) -> dict[tuple[str, str], LegEnds]:
    """What a run says of the legs, numbered as in truth, by unit and epoch: of all epochs together, at poses of truth as fits err."""
    unit = survey.units[0].type
    by_unit: dict[str, dict[int, LegEnds]] = {}
    for number, epoch in enumerate(survey.epochs):
        cloud = read_epoch(survey, epoch.label)
        for true, legs in zip(cloud.truth, _judged(cloud, unit, rng), strict=True):
            by_unit.setdefault(true.unit_id, {})[number] = legs
    return {(name, survey.epochs[number].label): legs for name, seen in by_unit.items() for number, legs in legs_over_epochs(seen).items()}


def _judged(cloud: EpochCloud, unit: UnitType, rng: np.random.Generator) -> list[LegEnds]:
    """Legs of the units of one epoch by its points alone; of units that are seen enough to be found."""
    poses = np.empty((len(cloud.truth), 12))
    for k, true in enumerate(cloud.truth):
        poses[k, :3] = true.pose.centre + rng.normal(0, CENTRE_HEIGHTS * unit.height, 3)
        turn = Rotation.from_rotvec(np.radians(rng.normal(0, TURN_DEG, 3))).as_matrix()
        poses[k, 3:] = (turn @ true.pose.rotation).ravel()
    certain = np.array([true.visible >= FOUND for true in cloud.truth])
    return ends_of_units(cloud.points, cloud.sources, poses, np.zeros(len(poses), dtype=np.int64), certain, [unit])


def judged_in_run(result: Path, folder: Path, survey: Survey) -> dict[tuple[str, str], LegEnds]:
    """What a result says of the legs, numbered as in truth, by unit and epoch; of units that are found and right."""
    unit, found = survey.units[0].type, {}
    rows = [row for row in unit_rows(folder) if row["E"]]
    with sqlite3.connect(result) as connection:
        connection.row_factory = sqlite3.Row
        stated = [dict(row) for row in connection.execute("select * from units where status != 'uncertain' and geom is not null")]
    for row in stated:
        centre = np.frombuffer(row["geom"][-24:], dtype="<f8")
        near = [true for true in rows if true["epoch"] == row["epoch"]]
        true = min(near, key=lambda other: float(np.linalg.norm(_centre(other) - centre)))
        if np.linalg.norm(_centre(true) - centre) < SAME_UNIT_HEIGHTS * unit.height:
            axes, own = (_turn(pose) @ unit.leg_directions.T for pose in (true, row))
            legs = LegEnds.from_row(row).renumbered(np.argmax(axes.T @ own, axis=1))
            # a result states one probability, that of its most likely broken leg
            found[true["unit_id"], row["epoch"]] = replace(legs, broken=np.where(legs.states == BROKEN, legs.broken, np.nan))
    return found


def _centre(row: dict[str, str]) -> FloatArray:
    return np.array([float(row[k]) for k in "ENH"])


def _turn(row: Mapping[str, Any]) -> FloatArray:
    """(3, 3) rotation from a unit's body frame to that of its survey."""
    return np.asarray(Rotation.from_quat([float(row[k]) for k in ("qx", "qy", "qz", "qw")]).as_matrix())


def counted(judged: Mapping[tuple[str, str], LegEnds], truth: Mapping[tuple[str, str], TrueLegs]) -> Count:
    """Sightings that are judged, held against the truth."""
    count = Count.none()
    for sighting, legs in judged.items():
        count.add(legs, truth[sighting])
    return count


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--result", type=Path, help="judge this result of the one folder given")
    parser.add_argument("--seed", type=int, default=0, help="of what poses of truth err")
    parser.add_argument(
        "--missed", action="store_true", help="list sightings of shown broken legs that are not named, and whole ones that are"
    )
    arguments = parser.parse_args()
    total = Count.none()
    print("| " + " | ".join(COLUMNS) + " |\n|" + " --- |" * len(COLUMNS))
    for folder in arguments.folders:
        survey, rng = read_survey(folder / "survey.toml"), np.random.default_rng(arguments.seed)
        judged = judged_in_run(arguments.result, folder, survey) if arguments.result else judged_at_truth(survey, rng)
        truth = true_legs(folder, survey)
        count = counted(judged, truth)
        total = total.joined(count)
        print(count.line(folder.name), flush=True)
        if arguments.missed:
            print("\n".join(mistakes(judged, truth)), file=sys.stderr, flush=True)
    print(total.line("all"))
    print("\n| probability | legs | mean probability | share broken |\n| --- | --- | --- | --- |")
    print("\n".join(total.reliability()))


def mistakes(judged: Mapping[tuple[str, str], LegEnds], truth: Mapping[tuple[str, str], TrueLegs]) -> list[str]:
    """Lines on broken legs that are seen and not named, and whole ones that are named."""
    lines = []
    for (name, epoch), legs in judged.items():
        true = truth[name, epoch]
        for k in range(4):
            named, broken = legs.states[k] == BROKEN, k == true.broken
            if named == broken or (broken and true.points[k] < SEEN and not true.shown >= SHOWN):
                continue
            state = LEG_STATES[int(legs.states[k])]
            lines.append(
                f"{name} {epoch} leg {k + 1} {'broken' if broken else 'whole'} in truth, {state} (p {legs.broken[k]:.3f}, own evidence "
                f"{legs.evidence[k]:.1f}, missing {legs.missing[k]:.2f}); {true.points[k]:.0f} points, {true.shown:.0f} show the break, "
                f"{true.missing:.2f} m missing"
            )
    return lines


if __name__ == "__main__":
    main()
