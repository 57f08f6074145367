"""Size of the units of a cloud where nobody says it: conic features of a few dense places, looked for at every size that units have.

At a trial height legs are found, put together in pairs and refined as in :mod:`segment`; how much of the surface the whole units then
explain, and how closely, peaks sharply at the true height: half or one and a half times of it explains next to nothing, a tenth off less
than a fifth. What is best is refined with free size and proportions (:mod:`free_shape`) and judged again.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray, IntArray
from ..common.neighbourhood import point_tree
from ..common.voxels import thin
from ..model.unit_types import GRADIENT, LEG_LENGTH_RATIO, RADIUS_RATIO, UnitType
from .assembly import poses_from_pairs
from .conic_ransac import find_legs
from .free_shape import FreeShape, fit_shape
from .pose_evidence import evidence
from .pose_refinement import refine
from .scene import COLUMNS, Evidence, Scene
from .surface_elements import SurfaceElements, surface_elements
from .verification import plausible

LEAST_HEIGHT, GREATEST_HEIGHT = 0.03, 6.0
"""Metres: models in flumes, and above the heaviest armour unit (80 t, 5 m)."""
STEP = 1.16
"""Ratio of one trial height to the one before: half of it off, a true size still shows clearly."""
LEAST_SPACINGS = 12
"""Trial heights start at this multiple of the distance between points: a leg must hold a few points around."""
WINDOW_SIDE = 3.0
"""Side of a square looked into, in heights: whole units in the middle, few enough points for some thirty trials."""
TRIAL_WINDOWS, FINAL_WINDOWS = 2, 4
TOLERANCE_RATIO = 0.02
"""Distance to the surface, as a share of the height, that a size off by half a step needs."""
FINE_TOLERANCE_RATIO = 0.012
"""The same once the size is nearly known: real castings stay within."""
GREATEST_TOLERANCE_RATIO = 0.085
"""With more noise than this allows any lump looks like a unit."""
THINNING_RATIO = 0.012
"""Points are thinned to this share of the trial height: finer than surface elements, and quick however dense the cloud is."""
UNIT_COST = 60.0
"""Evidence, in natural logarithmic units, that a pose found among so many must bring before it counts: six parameters, and chance."""
STANDING_OUT = 0.25
"""Units that tell the size bring at least this share of the best one's evidence."""
CHANCE_MISFIT = 0.8
"""Misfit of what chance puts near a surface, in tolerances: poses in rubble reach 0.6 to 0.85."""
LEAST_EVIDENCE = 0.04
"""Evidence per surface element under which a cloud shows no unit of a size."""
CUSTOMARY_HEIGHT = 2.2
"""Metres; trials begin here, in the middle of what is built."""
CLEAR_EVIDENCE = 0.12
"""Evidence per surface element that no false size reaches: those seen so far stayed below 0.02."""
FAR_SIZE = 2.2
"""Ratio of heights beyond which a clear size spares the trial of another."""
PART_SIDE = 14.0
"""Parts in which another size is looked for are about this many heights long."""
MOST_PARTS = 8
RIVAL = 0.35
"""Share of the best size's evidence that another size must reach in the same place to be a rival."""
FEWEST_SURE = 4
"""Units that must stand behind a size for a sure answer."""
OTHER_GIRTH = 0.025
"""Ratio from which radius and length of the legs tell of a mould of other girth: rounded ends shorten legs by up to two per cent."""
STANDARD = 0.015
"""Radius within this share of the standard proportions, and gradient within as much of the radius over a leg, are the standard's."""


@dataclass(frozen=True)
class SizeTrial:
    """What a trial height explains.

    Attributes
    ----------
    height
        Metres.
    evidence
        Logarithmic evidence for units per surface element looked at.
    units
        Units that carry it.
    """

    height: float
    evidence: float
    units: int


@dataclass(frozen=True, eq=False)
class FoundSize:
    """A size of unit found in a cloud.

    Attributes
    ----------
    unit
        Height, radius, gradient and leg length as estimated, metres.
    uncertainty
        By how much the height may be off, metres: the disagreement of its measures, and of the units among each other.
    standard
        The proportions are those of the catalogue within what can be told here.
    noisy
        The noise is too large to tell the proportions.
    trial
        What it explains after refinement.
    centres
        (k, 3) units it rests on, frame of the points.
    rivals
        Other heights that explain the same places nearly as well, best first.
    """

    unit: UnitType
    uncertainty: float
    standard: bool
    noisy: bool
    trial: SizeTrial
    centres: FloatArray
    rivals: tuple[SizeTrial, ...] = ()

    @property
    def sure(self) -> bool:
        """Whether the size can be stated as a fact."""
        return self.trial.units >= FEWEST_SURE and not self.rivals and self.uncertainty < 0.03 * self.unit.height


@dataclass(frozen=True, eq=False)
class _Look:
    """Units of one trial in one window."""

    elements: SurfaceElements
    tolerance: float
    poses: FloatArray
    evidence: FloatArray
    rows: Evidence


def trial_heights(points: FloatArray, *, greatest: float = GREATEST_HEIGHT) -> FloatArray:
    """Heights (k,) worth a trial in (n, 3) points: from what the points are dense enough for to what the extent has room for."""
    spacing = point_spacing(points)
    extent = np.sort(np.ptp(np.quantile(points, [0.01, 0.99], axis=0), axis=0))
    low, high = max(LEAST_SPACINGS * spacing, LEAST_HEIGHT), min(greatest, float(extent[1]))
    if high <= low:
        return np.zeros(0)
    count = math.ceil(math.log(high / low) / math.log(STEP))
    return np.asarray(low * STEP ** np.arange(count + 1))


def point_spacing(points: FloatArray) -> float:
    """Median distance of a point to its nearest neighbour, metres."""
    rng = np.random.default_rng(0)
    probe = points[np.sort(rng.choice(len(points), min(len(points), 3000), replace=False))]
    return float(np.median(point_tree(points).query(probe, k=2)[0][:, 1]))


def estimate_sizes(
    points: FloatArray, *, heights: Sequence[float] | FloatArray | None = None, progress: Callable[[float, str], None] = lambda f, m: None
) -> tuple[FoundSize, ...]:
    """Sizes of the units in (n, 3) points of a reduced frame, the one with most evidence first; none where no unit is found.

    Parameters
    ----------
    heights
        Trial heights, metres; None tries all that the points allow.
    """
    found: list[FoundSize] = []
    tried = trial_heights(points) if heights is None else np.asarray(heights, dtype=np.float64)
    trials: list[SizeTrial] = []
    # customary sizes first: what stands out there spares the trial of sizes that are far from it
    for k, height in enumerate(sorted(tried, key=lambda h: abs(math.log(h / CUSTOMARY_HEIGHT)))):
        best = max(trials, key=lambda trial: trial.evidence, default=SizeTrial(height, 0.0, 0))
        if best.evidence > CLEAR_EVIDENCE and best.units >= FEWEST_SURE and abs(math.log(height / best.height)) > math.log(FAR_SIZE):
            continue
        progress(0.75 * k / len(tried), f"trying units {height:.2f} m high")
        trials.append(try_size(points, UnitType.tetrapod(float(height))))
    for k, trial in enumerate(_peaks(trials)[:3]):
        progress(0.75 + 0.08 * k, f"refining the size of {trial.height:.2f} m")
        size = refined(points, UnitType.tetrapod(trial.height))
        if size is not None and not any(abs(size.unit.height / other.unit.height - 1) < 0.06 for other in found):
            found.append(size)
    return _settled(found)


def estimate_everywhere(
    points: FloatArray, *, progress: Callable[[float, str], None] = lambda fraction, message: None
) -> tuple[FoundSize, ...]:
    """:func:`estimate_sizes`, and where a part of the cloud shows none of the units found, once more there.

    Parameters
    ----------
    points
        (n, 3) reduced frame, metres.
    """
    found = list(estimate_sizes(points, progress=lambda fraction, message: progress(0.6 * fraction, message)))
    if not found:
        return ()
    parts = _parts(points, PART_SIDE * found[0].unit.height)
    for k, part in enumerate(parts if len(parts) > 1 else []):
        progress(0.6 + 0.4 * k / len(parts), "looking for units of another size")
        mine = points[part]
        if any(try_size(mine, size.unit, windows=1).evidence > LEAST_EVIDENCE for size in found):
            continue
        near = [h for h in trial_heights(mine) if any(1 / FAR_SIZE < h / size.unit.height < FAR_SIZE for size in found)]
        for size in estimate_sizes(mine, heights=near):
            if not any(abs(size.unit.height / other.unit.height - 1) < 0.06 for other in found):
                found.append(size)
    return tuple(found)


def _parts(points: FloatArray, side: float) -> list[IntArray]:
    """The cloud cut, along its longer side and there at its widest gap, into parts no longer than ``side``, at most ``MOST_PARTS``."""
    parts = [np.arange(len(points))]
    while len(parts) < MOST_PARTS:
        extents = [np.ptp(points[part, :2], axis=0) for part in parts]
        k = int(np.argmax([extent.max() for extent in extents]))
        if extents[k].max() <= side:
            break
        axis = int(np.argmax(extents[k]))
        part = parts.pop(k)
        values = points[part, axis]
        ordered = np.sort(values)
        inner = ordered[len(ordered) // 10 : -max(len(ordered) // 10, 1)]
        gap = int(np.argmax(np.diff(inner)))
        wide = inner[gap + 1] - inner[gap] > 0.05 * extents[k][axis]
        cut = 0.5 * (inner[gap] + inner[gap + 1]) if wide else float(0.5 * (ordered[0] + ordered[-1]))
        parts += [own for own in (part[values < cut], part[values >= cut]) if len(own)]
    return [part for part in parts if len(part) > 1000]


def try_size(points: FloatArray, unit: UnitType, *, windows: int = TRIAL_WINDOWS) -> SizeTrial:
    """How much of the densest places of a cloud units of one size explain."""
    looks = [_look(points[w], unit) for w in dense_windows(points, unit.height, windows)]
    return _sum(unit.height, [look for look in looks if look is not None])


def refined(points: FloatArray, unit: UnitType) -> FoundSize | None:
    """Size and proportions near a trial size, from the units that stand out; None where too few do."""
    shapes: list[FreeShape] = []
    looks: list[_Look] = []
    for ratio in (TOLERANCE_RATIO, FINE_TOLERANCE_RATIO, FINE_TOLERANCE_RATIO):
        windows = dense_windows(points, unit.height, FINAL_WINDOWS)
        looks = [look for w in windows if (look := _look(points[w], unit, ratio)) is not None]
        best = max((look.evidence.max(initial=0.0) for look in looks), default=0.0)
        chosen = [(look.evidence > max(UNIT_COST, STANDING_OUT * best)) & (look.rows.legs >= 2) for look in looks]
        shapes = [
            fit_shape(look.elements, look.poses[good], unit, look.tolerance) for look, good in zip(looks, chosen, strict=True) if good.any()
        ]
        if not shapes:
            return None
        unit = _common(shapes, [float(look.evidence[good].sum()) for look, good in zip(looks, chosen, strict=True) if good.any()], unit)
    trial = _sum(unit.height, looks)
    spread = np.array([_height(s.unit) for s in shapes])
    # where the noise shifts what is measured, agreement is no check
    doubt = 0.02 * unit.height if all(s.noisy for s in shapes) else _disagreement(unit)
    uncertainty = max(doubt, float(np.std(spread)) / math.sqrt(len(spread)), 0.002 * unit.height)
    centres = np.vstack([look.poses[look.evidence > UNIT_COST, :3] for look in looks])
    return FoundSize(unit, uncertainty, _is_standard(unit), all(s.noisy for s in shapes), trial, centres)


def dense_windows(points: FloatArray, height: float, count: int) -> list[IntArray]:
    """Points of the squares that hold most surface: in a pile of units steep faces lie above one another, on flat ground none do."""
    thinned, _ = thin(points[:: max(1, len(points) // 400_000)], 0.15 * height)
    step = 0.5 * WINDOW_SIDE * height
    low = thinned[:, :2].min(axis=0)
    cell = np.floor((thinned[:, :2] - low) / step).astype(np.int64)
    # only squares that hold something: two sites of one survey may lie far apart
    filled, number = np.unique(cell, axis=0, return_counts=True)
    lower = (filled[:, None] - np.array([[0, 0], [0, 1], [1, 0], [1, 1]])).reshape(-1, 2)
    there = (lower >= 0).all(axis=1)
    squares, member = np.unique(lower[there], axis=0, return_inverse=True)
    four = np.bincount(member.reshape(-1), weights=np.repeat(number, 4)[there])
    chosen: list[tuple[int, int]] = []
    for place in np.argsort(-four, kind="stable"):
        if len(chosen) == count:
            break
        i, j = (int(x) for x in squares[place])
        if all(abs(i - a) > 1 or abs(j - b) > 1 for a, b in chosen):
            chosen.append((i, j))
    out = []
    for i, j in chosen:
        west, south = low + np.array([i, j]) * step
        east, north = points[:, 0], points[:, 1]
        inside = (east >= west) & (east < west + 2 * step) & (north >= south) & (north < south + 2 * step)
        out.append(np.flatnonzero(inside))
    return out


def _look(points: FloatArray, unit: UnitType, tolerance_ratio: float = TOLERANCE_RATIO) -> _Look | None:
    """Units of one size among the points of a window."""
    height = unit.height
    thinned, _ = thin(points, THINNING_RATIO * height)
    if len(thinned) < 100:
        return None
    elements = surface_elements(thinned, height)
    tolerance = max(2.5 * elements.element_noise, tolerance_ratio * height)
    nothing = _Look(elements, tolerance, np.zeros((0, 12)), np.zeros(0), Evidence(np.zeros((0, len(COLUMNS)))))
    if tolerance > GREATEST_TOLERANCE_RATIO * height:
        return nothing
    scene = Scene.of(elements, unit, tolerance)
    active = np.ones(len(elements.points), dtype=np.bool_)
    poses = poses_from_pairs(find_legs(scene, active, 0), unit)
    if not len(poses):
        return nothing
    poses = refine(poses, scene, active, most=250, sweeps=8)
    rows = evidence(poses, scene, active)
    closeness = np.log(CHANCE_MISFIT * tolerance / np.maximum(rows.misfit, 1e-3 * tolerance))
    value = rows.support * np.maximum(closeness, 0) - 3 * rows.inside
    value[~plausible(rows, tolerance)] = 0
    kept = _apart(poses, value, 0.6 * height)
    return _Look(elements, tolerance, poses[kept], value[kept], rows[kept])


def _apart(poses: FloatArray, value: FloatArray, distance: float) -> IntArray:
    """Indices of the best poses whose centres keep a distance, best first."""
    kept: list[int] = []
    for k in np.argsort(-value, kind="stable"):
        if value[k] <= 0:
            break
        if not kept or (np.sum((poses[kept, :3] - poses[k, :3]) ** 2, axis=1) > distance**2).all():
            kept.append(int(k))
    return np.array(kept, dtype=np.int64)


def _sum(height: float, looks: Sequence[_Look]) -> SizeTrial:
    elements = sum(len(look.elements.points) for look in looks)
    above = np.concatenate([look.evidence - UNIT_COST for look in looks]) if looks else np.zeros(0)
    above = above[above > 0]
    return SizeTrial(height, float(above.sum()) / max(elements, 1), len(above))


def _peaks(trials: Sequence[SizeTrial]) -> list[SizeTrial]:
    """Trials that explain more than their neighbours do, best first."""
    trials = sorted(trials, key=lambda trial: trial.height)
    values = [0.0, *(trial.evidence for trial in trials), 0.0]
    tops = [trial for k, trial in enumerate(trials, 1) if values[k] >= max(values[k - 1], values[k + 1], 0.3 * LEAST_EVIDENCE)]
    return sorted(tops, key=lambda trial: -trial.evidence)


def _common(shapes: Sequence[FreeShape], evidence_of_each: Sequence[float], unit: UnitType) -> UnitType:
    """Proportions of several windows put together, weighted by the evidence for their units, and the height they speak for."""
    weights = np.array(evidence_of_each)
    ends = [s.ends for s in shapes]
    radius, gradient, length = (
        float(np.average([getattr(s.unit, name) for s in shapes], weights=weights * (ends if name == "leg_length" and any(ends) else 1)))
        for name in ("radius", "gradient", "leg_length")
    )
    shape = replace(unit, radius=radius, gradient=gradient, leg_length=length)
    return replace(shape, height=_height(shape))


def _measures(unit: UnitType) -> tuple[float, float]:
    """The height as the length of the legs and as their radius give it by the standard proportions, metres."""
    return unit.leg_length / LEG_LENGTH_RATIO, unit.radius / RADIUS_RATIO


def _height(unit: UnitType) -> float:
    """Height of a shape: that of its legs' length, which needs no proportions but the angle; with the radius' where both agree."""
    by_length, by_radius = _measures(unit)
    return 0.5 * (by_length + by_radius) if abs(by_radius / by_length - 1) < OTHER_GIRTH else by_length


def _disagreement(unit: UnitType) -> float:
    """By how much the height may be off because moulds differ in girth, metres."""
    by_length, by_radius = _measures(unit)
    return min(0.5 * abs(by_length - by_radius), 0.01 * by_length)


def _is_standard(unit: UnitType) -> bool:
    return (
        abs(unit.radius / (RADIUS_RATIO * unit.height) - 1) < STANDARD
        and abs(unit.gradient - GRADIENT) * unit.leg_length / unit.radius < 2 * STANDARD
    )


def _settled(found: Sequence[FoundSize]) -> tuple[FoundSize, ...]:
    """Sizes by their evidence; what competes for the same places is a rival or, far weaker, dropped."""
    kept: list[FoundSize] = []
    for size in sorted((s for s in found if s.trial.evidence > LEAST_EVIDENCE), key=lambda s: -s.trial.evidence):
        for k, better in enumerate(kept):
            away = cKDTree(better.centres).query(size.centres)[0]
            if np.mean(away < 0.5 * max(better.unit.height, size.unit.height)) > 0.5:
                if size.trial.evidence > RIVAL * better.trial.evidence:
                    kept[k] = replace(better, rivals=(*better.rivals, size.trial))
                break
        else:
            kept.append(size)
    return tuple(kept)
