"""From the points of one epoch to tetrapods: conic RANSAC, assembly, verification, aggregation (paper 2.1, METHOD 5)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from .aggregation import assign, contested
from .assembly import (
    CELLS,
    CLOSE,
    INSIDE,
    LEGS,
    NUMBER_OF_CELLS,
    REACHED,
    RMS,
    SUPPORT,
    evidence,
    poses_from_pairs,
    poses_from_single_legs,
    refine,
)
from .conic_ransac import find_legs
from .neighbourhood import Grid, build_grid
from .pose import Pose
from .surface_elements import SurfaceElements, surface_elements
from .twist import settle_twists
from .unit_types import UnitType
from .verification import distinct, overlap, select

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
Status = Literal["found", "uncertain"]

PASSES = 4
FEWEST_POINTS = 50
"""A cloud of fewer points holds no unit."""
FOUND_SCORE = 0.65
"""Units of at least this score are stated as found; the others are kept as uncertain."""
CLEARANCE_IN_NOISE = 2.0
"""Points are used where no other unit's surface comes nearer than this multiple of the noise."""
LISTED_EVIDENCE, LISTED_SCORE = 0.2, 0.05
"""Poses of less evidence are chance alignments of rock, wall and water; where the evidence is good but the twist about a leg is open, the
score may be lower still. What is below either is not reported at all."""
SCORE_WEIGHTS = (1.08, 1.67, -1.22, -1.62, -1.71, -1.41)
SCORE_INTERCEPT = -4.48
WORTH_ANOTHER_PASS = 0.3
"""Score a pass must reach with at least one unit for the remaining points to be searched again."""
FEW_ELEMENTS = 40
"""Fewer supporting elements than this make a pose less likely, whatever share of those around it they are."""
CHANCE_SCORE = 0.2
"""Poses of a lower score lose their points to a last look for units."""
MOST_INTERPENETRATION = 0.01
"""Share of its volume by which the weaker of two units may enter the stronger and still be stated as found."""


@dataclass(frozen=True, eq=False)
class DetectedUnit:
    """One tetrapod in one cloud.

    Attributes
    ----------
    pose
        Centre and rotation in the frame of the points given.
    score
        0..1, how sure it is that a unit lies here in this pose.
    coverage
        Share of the surface that holds supporting points.
    legs_visible
        Legs with supporting points in at least two cells.
    status
        ``found``, or ``uncertain`` where the evidence is weak.
    misfit
        Root mean square distance of the supporting surface elements, metres.
    interpenetration
        Largest share of its volume that lies inside a unit that was found with a higher score.
    supported
        Share of the surface elements seen near the predicted surface that lie on it with an agreeing normal, 0 to 1.
    """

    pose: Pose
    score: float
    coverage: float
    legs_visible: int
    status: Status
    misfit: float
    interpenetration: float
    supported: float


@dataclass(frozen=True)
class TypicalUnit:
    """What fitting real surfaces leaves in a cloud.

    Attributes
    ----------
    misfit
        Median misfit, metres.
    agreement
        Median share of the elements on the surface whose normal agrees.
    """

    misfit: float
    agreement: float


@dataclass(frozen=True, eq=False)
class JudgedPoses:
    """Poses with what speaks for and against each.

    Attributes
    ----------
    elements
        The thinned cloud they were judged on.
    poses
        (k, 12) centre and rotation by rows, reduced frame.
    evidence
        (k, 7) columns as in ``assembly``.
    certainty
        (k,) 0..1, how far the turn about a leg is known: see ``twist``.
    tolerance
        Distance within which an element supports a unit, metres.
    typical
        What the poses that are surely units have in common.
    """

    elements: SurfaceElements
    poses: FloatArray
    evidence: FloatArray
    certainty: FloatArray
    tolerance: float
    typical: TypicalUnit


@dataclass(frozen=True, eq=False)
class Segmentation:
    """Units found in a cloud and the points of each.

    Attributes
    ----------
    units
        In order of decreasing evidence.
    labels
        (n,) for each point given, the index of its unit or -1, also where it cannot be told from a touching unit's.
    spacing
        Median distance of a point to its nearest neighbour, metres.
    noise
        Standard deviation of a point across the surface, metres.
    tolerance
        Distance to the surface within which a surface element supports a unit, metres.
    """

    units: tuple[DetectedUnit, ...]
    labels: IntArray
    spacing: float
    noise: float
    tolerance: float


def segment(points: FloatArray, unit: UnitType, *, seed: int = 0, workers: int = -1) -> Segmentation:
    """Find the tetrapods in (n, 3) points of a reduced frame, metres.

    Parameters
    ----------
    unit
        Nominal geometry.
    seed
        Of the random draws; the result depends on it, the points and the unit only, not on threads.
    workers
        Threads of the neighbour searches, -1 for all.
    """
    points = np.ascontiguousarray(points, dtype=np.float64)
    if len(points) < FEWEST_POINTS:
        return Segmentation((), np.full(len(points), -1, dtype=np.int64), 0.0, 0.0, 0.0)
    return _stated(points, judge_poses(points, unit, seed=seed, workers=workers), unit)


def judge_poses(points: FloatArray, unit: UnitType, *, seed: int = 0, workers: int = -1) -> JudgedPoses:
    """Every pose that :func:`segment` weighs, chance alignments included, with the evidence for it; arguments as there."""
    height = unit.height
    elements = surface_elements(points, height, workers=workers)
    grid = build_grid(elements.points, 0.13 * height)
    tolerance = max(2.5 * elements.element_noise, 0.008 * height)
    active = np.ones(len(elements.points), dtype=np.bool_)
    poses = np.zeros((0, 12))
    typical = _typical_unit(np.zeros((0, 7)))
    for turn in range(PASSES):
        candidates = _candidates(elements, active, grid, unit, tolerance, seed + turn, twists=2 if turn > 0 else 0)
        chosen = select(candidates, elements, active, grid, unit, tolerance, poses)
        poses = np.vstack([poses, chosen.poses])
        if turn == 0 and len(chosen.poses) >= 3:
            # the strongest units tell the misfit of real surfaces, which roughness and strip offsets make larger than the noise
            tolerance = float(np.clip(2.5 * _typical_unit(chosen.evidence).misfit, tolerance, 1.3 * tolerance))
        typical = _typical_unit(chosen.evidence) if turn == 0 else typical
        if turn > 0 and not any(score(row, tolerance, typical) > WORTH_ANOTHER_PASS for row in chosen.evidence):
            break
    poses, table, owner = _settled(elements, poses, unit, tolerance, grid, rounds=1)
    # chance alignments claim points of units: a last look without them
    typical = _typical_unit(table)
    unlikely = np.array([score(row, tolerance, typical) < CHANCE_SCORE for row in table], dtype=np.bool_)
    active = ~np.isin(owner, np.flatnonzero(~unlikely))
    candidates = _candidates(elements, active, grid, unit, tolerance, seed + PASSES, twists=5)
    chance = int(unlikely.sum())
    known = distinct(np.vstack([poses[unlikely], candidates]), unit)
    candidates = candidates[known[known >= chance] - chance]
    chosen = select(candidates, elements, active, grid, unit, tolerance, poses[~unlikely])
    poses, table, owner = _settled(elements, np.vstack([poses[~unlikely], chosen.poses]), unit, tolerance, grid, rounds=2)
    typical = _typical_unit(table)
    sure = np.array([score(row, tolerance, typical) >= FOUND_SCORE for row in table], dtype=np.bool_)
    poses, certainty = settle_twists(poses, table, sure, elements, owner, grid, unit, tolerance)
    return JudgedPoses(elements, poses, table, certainty, tolerance, typical)


def _candidates(
    elements: SurfaceElements, active: NDArray[np.bool_], grid: Grid, unit: UnitType, tolerance: float, seed: int, *, twists: int
) -> FloatArray:
    """Refined poses (k, 12) from pairs of legs among the active elements, and from single legs with so many ``twists`` each, if any."""
    legs = find_legs(elements, active, grid, unit, tolerance, seed)
    found = [poses_from_pairs(legs, unit)]
    if twists:
        found.append(poses_from_single_legs(legs, elements.points, active, grid, unit, tolerance, twists=twists))
    return refine(np.vstack(found), elements.points, elements.normals, active, grid, unit, tolerance, most=250, sweeps=8)


def _settled(
    elements: SurfaceElements, poses: FloatArray, unit: UnitType, tolerance: float, grid: Grid, *, rounds: int
) -> tuple[FloatArray, FloatArray, IntArray]:
    """Poses refined on their exclusive points, the evidence for each, and the owner of every element."""
    poses = poses.copy()
    table = np.zeros((len(poses), 7))
    for _ in range(rounds):
        owner, _ = assign(elements.points, poses, unit, 2.5 * tolerance)
        doubtful = contested(elements.points, owner, poses, unit, CLEARANCE_IN_NOISE * elements.element_noise)
        for k in range(len(poses)):
            own = (owner == k) | (owner < 0)
            poses[k] = refine(
                poses[k : k + 1], elements.points, elements.normals, own & ~doubtful, grid, unit, tolerance, most=1500, sweeps=20
            )[0]
            table[k] = evidence(
                poses[k : k + 1], elements.points, elements.normals, elements.curved, own, grid, unit, tolerance, elements.noise
            )[0]
    return poses, table, owner


def _stated(points: FloatArray, judged: JudgedPoses, unit: UnitType) -> Segmentation:
    """State which poses are units, and hand the raw points out."""
    poses, table, tolerance, elements = judged.poses, judged.evidence, judged.tolerance, judged.elements
    found = np.array([score(row, tolerance, judged.typical) for row in table])
    scores = judged.certainty * found
    shared = np.zeros(len(poses))
    for k in range(len(poses)):
        stronger = np.flatnonzero((scores >= FOUND_SCORE) & (scores > scores[k]))
        for j in stronger[np.sum((poses[stronger, :3] - poses[k, :3]) ** 2, axis=1) < (2 * unit.reach) ** 2]:
            shared[k] = max(shared[k], overlap(poses[k], poses[j], unit))
    entered = shared > MOST_INTERPENETRATION
    kept = np.flatnonzero((found >= LISTED_EVIDENCE) & (scores >= LISTED_SCORE))
    units = tuple(
        DetectedUnit(
            Pose(poses[k, :3], poses[k, 3:].reshape(3, 3)),
            float(scores[k]),
            float(table[k, CELLS] / NUMBER_OF_CELLS),
            int(table[k, LEGS]),
            "found" if scores[k] >= FOUND_SCORE and not entered[k] else "uncertain",
            float(table[k, RMS]),
            float(shared[k]),
            float(table[k, SUPPORT] / max(table[k, REACHED], 1)),
        )
        for k in kept
    )
    labels, _ = assign(points, poses[kept], unit, max(3.5 * elements.noise, 2 * tolerance), clearance=CLEARANCE_IN_NOISE * elements.noise)
    return Segmentation(units, labels, elements.spacing, elements.noise, tolerance)


def _typical_unit(table: FloatArray) -> TypicalUnit:
    """What the poses that are surely units have in common.

    Where rock abounds most poses are none. Units are the poses whose elements' normals agree nearly as often as those of the best
    supported poses do.
    """
    if not len(table):
        return TypicalUnit(0.0, 1.0)
    agreeing = table[:, SUPPORT] / np.maximum(table[:, CLOSE], 1.0)
    agreement = float(np.median(agreeing[table[:, SUPPORT] >= 0.5 * table[:, SUPPORT].max()]))
    return TypicalUnit(float(np.median(table[agreeing >= 0.9 * agreement, RMS])), agreement)


def score(row: FloatArray, tolerance: float, typical: TypicalUnit) -> float:
    """Probability, 0..1, that the evidence row is that of a real unit in its true pose: a logistic model of its features.

    The weights were fitted to simulated piles, rock and laboratory scenes (``benchmarks/score_calibration.py``), never to a real
    survey. What no unit of those shows speaks against a pose beyond that.
    """
    if row[CLOSE] < 1:
        return 0.0
    odds = SCORE_INTERCEPT + np.dot(SCORE_WEIGHTS, score_features(row, tolerance, typical)) - _unlikeness(row, tolerance, typical)
    return float(1 / (1 + np.exp(-odds)))


def _unlikeness(row: FloatArray, tolerance: float, typical: TypicalUnit) -> float:
    """Logarithmic odds against a pose that is in one way unlike all units, however good the rest looks; 0 for most."""
    return float(
        # points scattered evenly over the window have a misfit of 1.15 tolerances, units hardly ever more than a half
        20 * max(0.0, row[RMS] / tolerance - 0.5)
        # few elements align by chance
        + 4 * max(0.0, 1 - row[SUPPORT] / FEW_ELEMENTS)
        # what is odd in few elements is telling in many
        + 20 * max(0.0, 1 - 3 / np.sqrt(row[CLOSE]) - row[SUPPORT] / row[CLOSE] / max(typical.agreement, 1e-12))
    )


def score_features(row: FloatArray, tolerance: float, typical: TypicalUnit) -> FloatArray:
    """(6,) what the score is made of.

    Odds that an element near the surface lies on it and odds that its normal agrees, both the more telling the more surface cells
    they come from; elements inside the solid; misfit against what is typical of this cloud and against the tolerance; extent.
    """
    close = row[CLOSE]
    # two per cent of disagreement is always allowed for, so that the odds stay finite
    on_surface = np.log((close + 1) / (row[REACHED] - close + 1 + 0.02 * close))
    agreeing = np.log((row[SUPPORT] + 1) / (close - row[SUPPORT] + 1 + 0.02 * close))
    extent = np.log1p(row[CELLS])
    return np.array(
        [
            extent * on_surface,
            extent * agreeing,
            np.log1p(row[INSIDE] / (0.01 * close + 1)),
            min(row[RMS] / max(typical.misfit, 1e-12), 4.0),
            row[RMS] / tolerance,
            extent,
        ]
    )
