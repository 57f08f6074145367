"""From the points of one epoch to tetrapods: conic RANSAC, assembly, verification, aggregation (paper 2.1, METHOD 5)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple

import numpy as np

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..model.pose import Pose
from ..model.unit_types import UnitType
from .aggregation import assign, contested
from .assembly import poses_from_pairs, poses_from_single_legs
from .conic_ransac import find_legs
from .end_discs import legs_of_discs
from .innermost_layer import innermost_layer
from .pose_evidence import NUMBER_OF_CELLS, evidence
from .pose_refinement import refine
from .pose_score import (
    FINE_TOLERANCE,
    RICH,
    SPARSE,
    SURE_ALONE,
    TypicalUnit,
    is_sparse,
    score,
    score_among,
    score_with_residuals,
    typical_unit,
    where_bridged,
)
from .raw_residuals import raw_residuals
from .restarts import begun_anew
from .scene import COLUMNS, Evidence, Scene
from .shared_noise import neighbours_share_noise
from .smoothed_surface import NOISY_RATIO, smoothed
from .surface_elements import SurfaceElements, surface_elements
from .twist import log_likelihood, settle_twists
from .verification import FEWEST_CELLS, distinct, overlap, select
from .whole_unit_search import poses_about_elements

Status = Literal["found", "uncertain"]

PASSES = 4
FEWEST_POINTS = 50
"""A cloud of fewer points holds no unit."""
FOUND_SCORE = 0.65
"""Units of at least this score are stated as found; the others are kept as uncertain."""
CLEARANCE_IN_NOISE, MOST_CLEARANCE = 2.0, 0.03
"""Points are used where no other unit's surface comes nearer than this multiple of the noise, or than this share of the height: beyond it
the points lost would cost more than the few that another unit's noise adds."""
LABEL_NOISE, LABEL_TOLERANCES, MOST_LABEL_RATIO = 3.5, 2.0, 0.05
"""Points are a unit's up to this multiple of the noise from its surface, and up to this multiple of the tolerance of its elements where
that stays below this share of the height: roughness and offsets of strips are small, and in noisy clouds a wider window only takes in
what is of other surfaces."""
NEAR_SURFACE_RATIO = 0.02
"""Share of the height that takes the place of the tolerance where none is known."""
LISTED_EVIDENCE, LISTED_SCORE = 0.2, 0.05
"""Poses of less evidence are chance alignments of rock, wall and water; where the evidence is good but the twist about a leg is open, the
score may be lower still. What is below either is not reported at all."""
WORTH_ANOTHER_PASS = 0.3
"""Score a pass must reach with at least one unit for the remaining points to be searched again."""
CHANCE_SCORE = 0.2
"""Poses of a lower score lose their points to a last look for units."""
FEWEST_FOUND_CELLS = 8
"""Cells of the surface, of 132, on fewer of which no pose is stated as found by one cloud alone: two of ten such poses of simulated surveys
were rock that fits by chance, one of 1980 others was. Where another epoch shows the unit, that makes it found."""
SURE_OF_FEW, EXACT = 0.85, 1.5
"""Score, and misfit in multiples of the usual one, of poses on fewer cells that are stated in rich clouds all the same: rock that fits so
little by chance hardly ever fits it as closely as a surface does, see ``docs/segmentation.md``."""
ELEMENTS_OF_DENSE_CELL = 18.0
"""Supporting elements per cell of sure units in the clouds on which these were counted; see :func:`fewest_found_cells`."""
SHARED_RATIO = 0.02
"""Tolerance that the noise asks for, as a share of the height, beyond which it is asked whether neighbours share it."""
IN_DOUBT = (0.02, 0.99)
"""Scores between which a pose in noise is begun anew from poses around it, where the tolerance is fine: beyond, rock gains by it as units
do."""
MOST_INTERPENETRATION, MOST_IN_NOISE = 0.01, 0.02
"""Share of its volume by which the weaker of two units may enter the stronger and still be stated as found, the second where noise was
taken off the elements or neighbours share it: poses are less exact there, and in noise of 3.3 % of the height units that touch seem to
enter each other so far."""


@dataclass(frozen=True, eq=False, kw_only=True)
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
    twist_open
        Uncertain for nothing but the turn about a leg.
    """

    pose: Pose
    score: float
    coverage: float
    legs_visible: int
    status: Status
    misfit: float
    interpenetration: float
    supported: float
    twist_open: bool


@dataclass(frozen=True, eq=False, kw_only=True)
class JudgedPoses:
    """Poses with what speaks for and against each.

    Attributes
    ----------
    kept
        (n,) whether a point of the cloud is used: those of layers before the innermost are not.
    thinned
        The thinned cloud.
    elements
        What they were judged on: the thinned cloud, in noise moved onto the surface that neighbours share.
    poses
        (k, 12) centre and rotation by rows, reduced frame.
    evidence
        For each.
    scores
        (k,) 0..1, how sure each is that of a unit, whatever its twist.
    residuals
        (k, 3) how raw points lie to each where noise was taken off the elements: see ``raw_residuals``.
    certainty
        (k,) 0..1, how far the turn about a leg is known: see ``twist``.
    tolerance
        Distance within which an element supports a unit, metres.
    typical
        What the poses that are surely units have in common.
    """

    kept: BoolArray
    thinned: SurfaceElements
    elements: SurfaceElements
    poses: FloatArray
    evidence: Evidence
    scores: FloatArray
    residuals: FloatArray | None
    certainty: FloatArray
    tolerance: float
    typical: TypicalUnit


@dataclass(frozen=True, eq=False, kw_only=True)
class Segmentation:
    """Units found in a cloud and the points of each.

    Attributes
    ----------
    units
        In order of decreasing evidence.
    labels
        (n,) for each point given, the index of its unit or -1, also where it cannot be told from a touching unit's or lies in a layer
        before the surface.
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
        return Segmentation(units=(), labels=np.full(len(points), -1, dtype=np.int64), spacing=0.0, noise=0.0, tolerance=0.0)
    return _stated(points, judge_poses(points, unit, seed=seed, workers=workers), unit)


def judge_poses(points: FloatArray, unit: UnitType, *, seed: int = 0, workers: int = -1) -> JudgedPoses:
    """Every pose that :func:`segment` weighs, chance alignments included, with the evidence for it; arguments as there."""
    cloud = cloud_elements(points, unit, workers=workers)
    points, thinned, elements = cloud.points, cloud.thinned, cloud.elements
    scene = Scene.of(elements, unit, cloud.tolerance)
    scene, poses = _searched(scene, seed)
    poses, found, owner = _settled(elements, poses, scene, rounds=1)
    # chance alignments claim points of units: a last look without them
    likely = score_among(found, poses[:, :3], scene.tolerance, where_bridged(typical_unit(found, scene), found), unit)
    unlikely = likely < CHANCE_SCORE
    active = ~np.isin(owner, np.flatnonzero(~unlikely))
    discs = poses_from_single_legs(legs_of_discs(scene, active), scene, active, twists=5)
    candidates = np.vstack([_candidates(scene, active, seed + PASSES, twists=5), refine(discs, scene, active, most=250, sweeps=8)])
    if is_sparse(scene):
        about = refine(poses_about_elements(scene, active, poses[likely >= FOUND_SCORE]), scene, active, most=250, sweeps=8)
        candidates = np.vstack([candidates, about])
    chance = int(unlikely.sum())
    known = distinct(np.vstack([poses[unlikely], candidates]), unit)
    candidates = candidates[known[known >= chance] - chance]
    chosen = select(candidates, scene, active, poses[~unlikely])
    poses, found, owner = _settled(elements, np.vstack([poses[~unlikely], chosen.poses]), scene, rounds=2)
    typical = where_bridged(typical_unit(found, scene), found)
    scores = score_among(found, poses[:, :3], scene.tolerance, typical, unit)
    residuals = None
    if scene.smoothed:
        if scene.tolerance <= FINE_TOLERANCE * unit.height:
            doubted = (scores > IN_DOUBT[0]) & (scores < IN_DOUBT[1])
            doubtful = contested(scene.points, owner, poses, unit, CLEARANCE_IN_NOISE * elements.element_noise)
            poses, found = begun_anew(poses, found, doubted, scene, owner, doubtful, seed)
            scores = score_among(found, poses[:, :3], scene.tolerance, typical, unit)
        residuals = raw_residuals(points, poses, unit, thinned.noise)
        scores = score_with_residuals(scores, residuals, found.support)
    poses, certainty = settle_twists(poses, found, scores >= FOUND_SCORE, scene, owner)
    return JudgedPoses(
        kept=cloud.kept,
        thinned=thinned,
        elements=elements,
        poses=poses,
        evidence=found,
        scores=scores,
        residuals=residuals,
        certainty=certainty,
        tolerance=scene.tolerance,
        typical=typical,
    )


class CloudElements(NamedTuple):
    """Of a cloud: what poses are held against.

    ``kept`` (n,) says which points are used at all, those of layers before the innermost are not, ``points`` are these; ``thinned`` are
    their elements, ``elements`` what these become in noise on the surface they share; ``tolerance`` is the distance within which they
    support a unit, metres.
    """

    kept: BoolArray
    points: FloatArray
    thinned: SurfaceElements
    elements: SurfaceElements
    tolerance: float


def cloud_elements(
    points: FloatArray, unit: UnitType, *, workers: int = -1, shared_noise: bool = False, noise: float = 0.0
) -> CloudElements:
    """Elements of (n, 3) points, reduced frame, metres; ``shared_noise`` says that neighbours are known to share theirs.

    ``noise``, where it is not 0, is that of a point of the whole cloud, of which it is known that it is taken off: a part of the cloud that
    holds few points does not tell.
    """
    thinned = surface_elements(points, unit.height, workers=workers)
    kept = innermost_layer(points, thinned.points, unit.height, surely=True)
    if kept is None or np.count_nonzero(kept) < FEWEST_POINTS:
        kept = np.ones(len(points), dtype=np.bool_)
    else:
        points = np.ascontiguousarray(points[kept])
        thinned = replace(surface_elements(points, unit.height, workers=workers), layered=True)
    tolerance = 2.5 * thinned.element_noise
    elements = thinned
    if tolerance > SHARED_RATIO * unit.height and (
        shared_noise or neighbours_share_noise(points, thinned.points, unit.height, thinned.noise)
    ):
        elements = replace(thinned, shared_noise=True)
    elif noise > 0:
        elements = smoothed(points, replace(thinned, noise=noise), unit.height, part=True)
    elif tolerance > NOISY_RATIO * unit.height:
        elements = smoothed(points, thinned, unit.height)
    return CloudElements(kept, points, thinned, elements, max(2.5 * elements.element_noise, 0.008 * unit.height))


def _searched(scene: Scene, seed: int) -> tuple[Scene, FloatArray]:
    """Poses (k, 12) that one pass after the other accepts, and the scene with the tolerance that the strongest units tell."""
    active = np.ones(len(scene.points), dtype=np.bool_)
    poses = np.zeros((0, 12))
    typical = typical_unit(Evidence.joined([]), scene)
    for turn in range(PASSES):
        candidates = _candidates(scene, active, seed + turn, twists=2 if turn > 0 else 0)
        chosen = select(candidates, scene, active, poses)
        poses = np.vstack([poses, chosen.poses])
        if turn == 0:
            typical = typical_unit(chosen.evidence, scene)
            if len(chosen.poses) >= 3:
                # the misfit of real surfaces, which roughness and strip offsets make larger than the noise
                tolerance = float(np.clip(2.5 * typical.misfit, scene.tolerance, 1.3 * scene.tolerance))
                scene = replace(scene, tolerance=tolerance)
        elif not np.any(score(chosen.evidence, scene.tolerance, typical) > WORTH_ANOTHER_PASS):
            break
    return scene, poses


def _candidates(scene: Scene, active: BoolArray, seed: int, *, twists: int) -> FloatArray:
    """Refined poses (k, 12) from pairs of legs among the active elements, and from single legs with so many ``twists`` each, if any."""
    legs = find_legs(scene, active, seed)
    found = [poses_from_pairs(legs, scene.unit)]
    if twists:
        found.append(poses_from_single_legs(legs, scene, active, twists=twists))
    return refine(np.vstack(found), scene, active, most=250, sweeps=8)


def _settled(elements: SurfaceElements, poses: FloatArray, scene: Scene, *, rounds: int) -> tuple[FloatArray, Evidence, IntArray]:
    """Poses refined on their exclusive points, the evidence for each, and the owner of every element."""
    poses = poses.copy()
    found = [Evidence(np.zeros((1, len(COLUMNS)))) for _ in poses]
    for _ in range(rounds):
        owner, _ = assign(scene.points, poses, scene.unit, 2.5 * scene.tolerance)
        doubtful = contested(scene.points, owner, poses, scene.unit, CLEARANCE_IN_NOISE * elements.element_noise)
        for k in range(len(poses)):
            own = (owner == k) | (owner < 0)
            refined = refine(_numbered(poses[k], scene.unit), scene, own & ~doubtful, most=1500, sweeps=20)
            judged = evidence(refined, scene, own)
            likeliest = int(np.argmax(log_likelihood(judged, scene.tolerance)))
            poses[k], found[k] = refined[likeliest], judged[likeliest]
    return poses, Evidence.joined(found), owner


def _numbered(pose: FloatArray, unit: UnitType) -> FloatArray:
    """(k, 12) a pose with its legs taken for one another, as they easily are where the opening tells them apart: as it is first."""
    turns = (pose[3:].reshape(3, 3) @ unit.numberings).reshape(-1, 9)
    return np.column_stack([np.tile(pose[:3], (len(turns), 1)), turns])


def _stated(points: FloatArray, judged: JudgedPoses, unit: UnitType) -> Segmentation:
    """State which poses are units, and hand the raw points out."""
    poses, seen, tolerance, elements = judged.poses, judged.evidence, judged.tolerance, judged.elements
    found = judged.scores
    scores = judged.certainty * found
    shared = np.zeros(len(poses))
    for k in range(len(poses)):
        stronger = np.flatnonzero((scores >= FOUND_SCORE) & (scores > scores[k]))
        for j in stronger[np.sum((poses[stronger, :3] - poses[k, :3]) ** 2, axis=1) < (2 * unit.reach) ** 2]:
            shared[k] = max(shared[k], overlap(poses[k], poses[j], unit))
    entered = shared > (MOST_IN_NOISE if elements.smoothed or elements.shared_noise else MOST_INTERPENETRATION)
    kept = np.flatnonzero((found >= LISTED_EVIDENCE) & (scores >= LISTED_SCORE))
    least = least_scores(seen, found, judged.typical)
    but_for_twist = (found >= least) & ~entered
    stated = poses[kept]
    if elements.smoothed:
        # a shared surface is drawn inwards where it bends; from there, points would be taken from one side more than from the other
        scene = Scene.of(judged.thinned, unit, 2.5 * judged.thinned.element_noise)
        stated, _, _ = _settled(judged.thinned, stated, scene, rounds=1)
    units = tuple(
        DetectedUnit(
            pose=Pose.of_row(pose),
            score=float(scores[k]),
            coverage=float(seen.cells[k] / NUMBER_OF_CELLS),
            legs_visible=int(seen.legs[k]),
            status="found" if scores[k] >= least[k] and but_for_twist[k] else "uncertain",
            misfit=float(seen.misfit[k]),
            interpenetration=float(shared[k]),
            supported=float(seen.support[k] / max(seen.reached[k], 1)),
            twist_open=bool(but_for_twist[k] and scores[k] < least[k]),
        )
        for k, pose in zip(kept, stated, strict=True)
    )
    window = label_window(elements.noise, unit.height, tolerance)
    labels = np.full(len(points), -1, dtype=np.int64)
    labels[judged.kept], _ = assign(points[judged.kept], stated, unit, window, clearance=clearance(elements.noise, unit.height))
    return Segmentation(units=units, labels=labels, spacing=elements.spacing, noise=elements.noise, tolerance=tolerance)


def least_scores(seen: Evidence, scores: FloatArray, typical: TypicalUnit) -> FloatArray:
    """(k,) score from which each pose of a cloud is found, from the evidence for them and their scores; not finite where it never is.

    What rests on few cells must be surer where the cloud is rich, and lie as closely to its elements as the others do; elsewhere it is not
    found.
    """
    exact = (seen.cells >= FEWEST_CELLS) & (seen.misfit <= EXACT * typical.misfit) & (typical.model is RICH)
    few = np.where(exact, SURE_OF_FEW, np.inf)
    return np.where(seen.cells >= fewest_found_cells(seen, scores, typical), FOUND_SCORE, few)


def fewest_found_cells(seen: Evidence, scores: FloatArray, typical: TypicalUnit) -> int:
    """Cells of the surface on fewer of which no pose of a cloud is found, from the evidence for its poses and their (k,) scores.

    A cell counts with two elements, so that the same patch counts fewer cells in a sparser cloud. What is kept out must stay the same
    patches: of the cells that chance poses of 5 to 12 count in dense clouds, 0.75, 0.53 and 0.33 are left where as much is taken from these
    that the cells of sure units hold 0.69, 0.47 and 0.32 of their elements. The limit goes in that proportion, rounded up, but not below
    what makes a candidate. Without a sure unit nothing tells what a cell can hold, and the limit stays.
    """
    sure = seen[scores >= SURE_ALONE]
    if typical.model is not SPARSE or not np.any(sure.cells):
        return FEWEST_FOUND_CELLS
    held = np.sum(sure.support) / np.sum(sure.cells)
    return int(np.clip(np.ceil(FEWEST_FOUND_CELLS * held / ELEMENTS_OF_DENSE_CELL), FEWEST_CELLS, FEWEST_FOUND_CELLS))


def clearance(noise: float, height: float) -> float:
    """Distance in metres of another unit's surface within which points are left out, from the noise of a point and the unit's height."""
    return min(CLEARANCE_IN_NOISE * noise, MOST_CLEARANCE * height)


def label_window(noise: float, height: float, tolerance: float | None = None) -> float:
    """Distance in metres from a unit's surface up to which points are taken for its own.

    Parameters
    ----------
    noise
        Of a point, metres.
    height
        Of the unit, metres.
    tolerance
        Of a cloud's elements, metres; None for units that were found before, whose elements are not known.
    """
    rough = NEAR_SURFACE_RATIO * height if tolerance is None else min(LABEL_TOLERANCES * tolerance, MOST_LABEL_RATIO * height)
    return max(LABEL_NOISE * noise, rough)


class KnownUnits(NamedTuple):
    """Units of one type that were found before: (k, 12) poses in the frame of the points, noise of a point in metres, and (k,) numbers."""

    unit: UnitType
    poses: FloatArray
    noise: float
    numbers: IntArray


def points_of_known(points: FloatArray, known: Iterable[KnownUnits]) -> IntArray:
    """(n,) number of the unit whose surface is nearest to each of (n, 3) points, metres; -1 for none, or where another may have it."""
    labels, nearest = np.full(len(points), -1, dtype=np.int64), np.full(len(points), np.inf)
    for unit, poses, noise, numbers in known:
        window, kept_clear = label_window(noise, unit.height), clearance(noise, unit.height)
        own, distance = assign(points, poses, unit, window, clearance=kept_clear)
        nearer = (own >= 0) & (np.abs(distance) < nearest)
        labels[nearer], nearest[nearer] = numbers[own[nearer]], np.abs(distance[nearer])
    return labels
