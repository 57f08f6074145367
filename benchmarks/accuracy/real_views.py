"""Are stated deviations true on real castings? Real units seen from other sides in a second epoch, many draws of the views.

    .venv/bin/python benchmarks/accuracy/real_views.py FOLDER_OF_REAL [--seeds N] [--copies N]

The crops of real units in FOLDER_OF_REAL (data set `real`) are put side by side in turned copies. Each epoch holds another half of the
points, less what is hidden from two or three places above, drawn anew (hidden-point removal, Katz et al., 2007), so that two epochs share
as much as chance gives; one unit in seven moves by 30 mm. Poses start at the fits to whole crops, so that what is measured is adjustment
and test, not the search. Copies of a unit share its casting: six units are six, however often they stand there; a seed draws the views.

For each seed and for all: resting and moved units, median and 90th percentile of the error, mean squared normalised error, share of
coordinates within 1.96 standard deviations, false alarms, and moves flagged where both epochs see 10 % of the unit; of all units of which
both epochs see 10 % of three legs the median and largest turn found, degrees (none turns), and the share of them up to 0.3 degrees.
"""

from __future__ import annotations

import argparse
import math
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

import laspy
import numpy as np
from scipy.spatial.transform import Rotation
from tetratrack.core.adjustment.adjustment_records import AdjustmentOptions
from tetratrack.core.adjustment.gauss_helmert import adjust
from tetratrack.core.deformation.fitted_unit import FittedUnit
from tetratrack.core.deformation.tracked_epoch import TrackedEpoch
from tetratrack.core.deformation.tracking import track
from tetratrack.core.deformation.unit_clouds import UnitCloud
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate, surface_cells
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.segment import segment

UNIT = UnitType.tetrapod(2.92, radius=0.776, gradient=0.203)
"""As calibrated on these units (their README)."""
ON_SURFACE = 0.035
SPACING = 9.0
MOVE = 0.03
SEEN = 0.10
LARGEST_TURN = 0.3
"""Degrees that a unit which does not turn may seem to."""
MOST_POINTS = 5_000


@dataclass(frozen=True)
class Crop:
    """A real unit: (n, 3) points of it in its body frame."""

    body: np.ndarray


def crops(folder: Path) -> list[Crop]:
    """Units of the crops, each fitted to all of its points."""
    found = []
    for path in sorted(folder.glob("tiles/**/*.la[sz]")):
        las = laspy.read(path)
        points = np.column_stack([las.x, las.y, las.z])
        points = points - points.mean(axis=0)
        units = segment(points[::4], UNIT, workers=1).units
        near = min(units, key=lambda unit: float(np.linalg.norm(unit.pose.centre)))
        fit = adjust(points[::4], UNIT, near.pose, options=AdjustmentOptions(radius_sd=0.01, gradient_sd=0.01))
        body = fit.pose.to_body(points)
        found.append(Crop(body[np.abs(relate(body, UNIT).distance) < ON_SURFACE]))
    return found


def visible(points: np.ndarray, eyes: np.ndarray) -> np.ndarray:
    """(n,) whether a point is seen from one of the (k, 3) eyes: its spherical flip lies on the hull of all."""
    from scipy.spatial import ConvexHull

    seen = np.zeros(len(points), dtype=bool)
    for eye in eyes:
        rays = points - eye
        lengths = np.linalg.norm(rays, axis=1)
        flipped = rays + 2 * (10**2.6 * lengths.max() - lengths)[:, None] * rays / lengths[:, None]
        hull = ConvexHull(np.vstack([flipped, np.zeros(3)])).vertices
        seen[hull[hull < len(points)]] = True
    return seen


def drawn_eyes(rng: np.random.Generator) -> np.ndarray:
    """(k, 3) places of two or three views, 12 m from the unit and above it."""
    count = int(rng.integers(2, 4))
    turn = rng.uniform(0, 2 * np.pi) + rng.normal(0, 0.5, count)
    rise = rng.uniform(0.35, 1.2, count)
    return 12 * np.column_stack([np.cos(rise) * np.cos(turn), np.cos(rise) * np.sin(turn), np.sin(rise)])


def survey(real: list[Crop], copies: int, rng: np.random.Generator) -> tuple[list[TrackedEpoch], np.ndarray, np.ndarray]:
    """Two epochs, (n, 3) true displacements, and (n, 3) shares of the units that each epoch sees and number of legs that both see."""
    cells, _, _ = surface_cells(UNIT)
    leg_of = np.argmax(cells @ UNIT.leg_directions.T, axis=1)
    units: list[list[FittedUnit]] = [[], []]
    moves, shares = [], []
    for number in range(copies * len(real)):
        crop = real[number % len(real)]
        pose = Pose(np.array([SPACING * (number % 7), SPACING * (number // 7), 0.0]), Rotation.random(random_state=rng).as_matrix())
        move = np.zeros(3)
        if number % 7 == 3:
            move = rng.normal(size=3)
            move *= MOVE / np.linalg.norm(move)
        moves.append(move)
        half = rng.random(len(crop.body)) < 0.5
        share, legs = [], np.ones(4, dtype=bool)
        for epoch, mine in enumerate((half, ~half)):
            body = crop.body[mine]
            body = body[:: max(1, len(body) // MOST_POINTS)]
            body = body[visible(body @ pose.rotation.T, drawn_eyes(rng))]
            nearest = np.argmin(np.linalg.norm(body[:, None, :] - cells[None], axis=2), axis=1) if len(body) else np.zeros(0, dtype=int)
            seen = np.unique(nearest)
            share.append(len(seen) / len(cells))
            legs &= np.bincount(leg_of[seen], minlength=4) >= SEEN * np.bincount(leg_of)
            points = pose.to_frame(body) + epoch * move
            start = Pose(pose.centre + epoch * move + rng.normal(0, 0.01, 3), pose.rotation)
            ids = np.zeros(len(points), dtype=np.uint16)
            units[epoch].append(
                FittedUnit(
                    pose=start,
                    shape=UNIT,
                    kind=0,
                    certain=True,
                    discs=np.zeros(4, dtype=bool),
                    cloud=UnitCloud.held(points, ids),
                    score=1.0,
                )
            )
        shares.append([*share, legs.sum()])
    epochs = [
        TrackedEpoch(label=str(k), time=datetime(2020 + k, 1, 1, tzinfo=UTC), units=tuple(own), registration=None)
        for k, own in enumerate(units)
    ]
    return epochs, np.array(moves), np.array(shares)


def judged(epochs: list[TrackedEpoch], moves: np.ndarray, shares: np.ndarray) -> list[tuple[float, ...]]:
    """By unit: whether it moved, error in mm, squared normalised error, share of coordinates inside, flagged, least share seen, turn found
    in degrees (there is none), number of legs seen."""
    result = track(epochs, [UNIT])
    centres = np.array([u.pose.centre for u in epochs[0].units])
    rows = []
    for motion in result.pairs[0].units:
        found = motion.motions["stable"]
        number = int(np.argmin(np.linalg.norm(centres - found.starts[0], axis=1)))
        error, sd = found.vectors[0] - moves[number], np.sqrt(np.diag(found.covariances[0]))
        moved, least = bool(moves[number].any()), float(shares[number, :2].min())
        inside = float(np.mean(np.abs(error) < 1.96 * sd))
        form = float(np.mean((error / sd) ** 2))
        turn = math.degrees(found.turn), float(shares[number, 2])
        rows.append((moved, 1000 * float(np.linalg.norm(error)), form, inside, found.p_values[0] < 0.05, least, *turn))
    return rows


def line(name: str, rows: list[tuple[float, ...]]) -> str:
    """One line of the table."""
    table = np.array(rows, dtype=float)
    parts = [name]
    for moved in (0, 1):
        own = table[table[:, 0] == moved]
        parts += [
            str(len(own)),
            f"{np.median(own[:, 1]):.1f}, {np.quantile(own[:, 1], 0.9):.1f}",
            f"{own[:, 2].mean():.2f}",
            f"{own[:, 3].mean():.3f}",
        ]
        if not moved:
            parts.append(f"{own[:, 4].mean():.3f}")
    seen = table[(table[:, 0] == 1) & (table[:, 5] >= SEEN)]
    turns = table[table[:, 7] >= 3, 6]
    told = f"{np.median(turns):.2f}, {turns.max():.2f} ({np.mean(turns <= LARGEST_TURN):.3f})" if len(turns) else ""
    return "| " + " | ".join([*parts, f"{int(seen[:, 4].sum())}/{len(seen)}", told]) + " |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--copies", type=int, default=7)
    arguments = parser.parse_args()
    real = crops(arguments.folder)
    columns = ("seed", "resting", "median, p90 mm", "squared error", "inside 95 %", "false alarms")
    columns += ("moved", "median, p90 mm", "squared error", "inside 95 %", "flagged", "turn found where three legs are seen")
    print("| " + " | ".join(columns) + " |\n|" + " --- |" * len(columns))
    everything: list[tuple[float, ...]] = []
    for seed in range(arguments.seeds):
        rows = judged(*survey(real, arguments.copies, np.random.default_rng(seed)))
        print(line(str(seed), rows), flush=True)
        everything += rows
    print(line("all", everything))


if __name__ == "__main__":
    main()
