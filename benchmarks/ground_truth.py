"""Ground truth of simulated surveys: read it, bring it into the frame of an epoch's cloud, and match poses to it.

For benchmarks and tests only; the product never reads ``truth/``.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment
from tetratrack.core.data.point_tables import read_control, read_targets
from tetratrack.core.data.survey import Survey
from tetratrack.core.data.tiles import inspect_tile, read_points
from tetratrack.core.model.feature_points import body_features, label_symmetry
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.registration.control import register
from tetratrack.core.simulation.survey_plan import STRETCH_NUMBERS

FloatArray = NDArray[np.float64]
CENTRE_TOLERANCE, FEATURE_TOLERANCE, COUNTED = 0.25, 0.15, 0.05
"""A pose is right within these fractions of H (centre; mean of the feature points); units seen less than COUNTED count neither way."""
BINS = ((0.30, 1.01), (0.15, 0.30), (0.05, 0.15))


@dataclass(frozen=True)
class TrueUnit:
    """A unit of one epoch in the frame of that epoch's cloud, less the reduction point."""

    unit_id: str
    pose: Pose
    visible: float
    broken: bool
    status: str


@dataclass(frozen=True)
class EpochCloud:
    """Points of an epoch less ``origin``, their strips or stations, and the units that are truly there."""

    label: str
    points: FloatArray
    sources: NDArray[np.uint16]
    origin: FloatArray
    truth: tuple[TrueUnit, ...]


@dataclass(frozen=True)
class Match:
    """Result of matching found poses to the truth.

    Attributes
    ----------
    pairs
        (k, 2) index of the found pose and of the true unit.
    centre_error, rotation_error_deg
        (k, 3) metres, found less true, and (k,) modulo the unit's symmetry.
    wrong
        Found poses that belong to no unit.
    neutral
        Found poses of units seen too little to count.
    missed
        Indices of counting units that were not found.
    """

    pairs: NDArray[np.int64]
    centre_error: FloatArray
    rotation_error_deg: FloatArray
    wrong: list[int]
    neutral: list[int]
    missed: list[int]


def unit_rows(folder: Path) -> list[dict[str, str]]:
    """Rows of ``truth/units.csv`` of a survey's folder; units taken away have no coordinates."""
    with (folder / "truth" / "units.csv").open(newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def number_of(unit_id: str) -> int:
    """Number by which points of a unit are labelled: 17 for U017, 2017 for U017_002, unit 17 of stretch 2 of a coast."""
    number, _, stretch = unit_id.removeprefix("U").partition("_")
    return int(number) + STRETCH_NUMBERS * int(stretch or 0)


def read_epoch(survey: Survey, label: str) -> EpochCloud:
    """Read the tiles and truth of an epoch; the truth is brought into the cloud's frame by the targets where there are any."""
    epoch = survey.epoch(label)
    tiles = [inspect_tile(path, survey.crs, tiles_crs=epoch.tiles_crs) for path in epoch.tiles]
    cloud = read_points(tiles, survey.crs)
    move = None
    if epoch.control is not None and epoch.targets is not None:
        move = register(read_control(epoch.control), read_targets(epoch.targets)).transformation
    units = []
    for row in unit_rows(survey.path.parent):
        if row["epoch"] != label or row["status"] == "removed":
            continue
        pose = Pose.from_quaternion([float(row[k]) for k in "ENH"], [float(row[k]) for k in ("qx", "qy", "qz", "qw")])
        pose = _to_cloud(pose, move).shifted(-cloud.origin)
        units.append(TrueUnit(row["unit_id"], pose, float(row["visible_area_fraction"]), row["broken"] == "1", row["status"]))
    return EpochCloud(label, cloud.xyz, cloud.source_id, cloud.origin, tuple(units))


def _to_cloud(pose: Pose, move: object) -> Pose:
    """Invert the registration by its small size: two steps leave nothing."""
    if move is None:
        return pose
    back = pose
    for _ in range(3):
        there = move.apply_pose(back)  # type: ignore[attr-defined]
        turn = pose.rotation @ there.rotation.T
        back = Pose(back.centre + pose.centre - there.centre, turn @ back.rotation)
    return back


def match(found: list[Pose], truth: tuple[TrueUnit, ...], unit: UnitType) -> Match:
    """One-to-one assignment of found poses to true units, by distance of centres and feature points modulo symmetry."""
    h = unit.height
    big = 1e6
    cost = np.full((len(found), len(truth)), big)
    turns: dict[tuple[int, int], float] = {}
    features = body_features(unit)[1:]
    centres = np.array([t.pose.centre for t in truth]).reshape(-1, 3)
    for i, pose in enumerate(found):
        distance = np.linalg.norm(centres - pose.centre, axis=1)
        for j in np.flatnonzero(distance <= CENTRE_TOLERANCE * h):
            symmetry, turn, _ = label_symmetry(truth[j].pose, pose, unit)
            errors = pose.relabelled(symmetry).to_frame(features) - truth[j].pose.to_frame(features)
            error = float(np.linalg.norm(errors, axis=1).mean())
            if error <= FEATURE_TOLERANCE * h:
                cost[i, j] = distance[j] + error
                turns[i, int(j)] = turn
    rows, columns = linear_sum_assignment(cost) if cost.size else (np.empty(0, int), np.empty(0, int))
    good = cost[rows, columns] < big
    pairs = np.column_stack([rows[good], columns[good]]).astype(np.int64)
    matched = set(pairs[:, 0].tolist())
    neutral = [i for i, j in pairs.tolist() if truth[j].visible < COUNTED]
    hidden = [t.pose.centre for t in truth if t.visible < COUNTED]
    wrong = []
    for i in range(len(found)):
        if i in matched:
            continue
        near = any(np.linalg.norm(found[i].centre - c) <= CENTRE_TOLERANCE * h for c in hidden)
        (neutral if near else wrong).append(i)
    missed = [j for j, t in enumerate(truth) if t.visible >= COUNTED and j not in set(pairs[:, 1].tolist())]
    error = np.array([found[i].centre - truth[j].pose.centre for i, j in pairs.tolist()]).reshape(-1, 3)
    angle = np.degrees(np.array([turns[i, j] for i, j in pairs.tolist()]))
    return Match(pairs, error, angle, wrong, neutral, missed)


def recall_by_visibility(matched: Match, truth: tuple[TrueUnit, ...]) -> list[tuple[int, int]]:
    """For each of BINS, units found and units there."""
    found = set(matched.pairs[:, 1].tolist())
    bins = []
    for low, high in BINS:
        there = [j for j, t in enumerate(truth) if low <= t.visible < high]
        bins.append((sum(j in found for j in there), len(there)))
    return bins


def point_labels(survey: Survey, label: str, tile: Path) -> NDArray[np.int64]:
    """True unit number (or negative label) of each point of a tile, in file order."""
    with np.load(survey.path.parent / "truth" / f"labels_{label}.npz") as labels:
        return np.asarray(labels[tile.name.removesuffix(".laz")], dtype=np.int64)
