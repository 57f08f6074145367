"""Whether the units that survey.toml describes are those in the cloud, and how much of them it shows.

A wrong size finds little, and what it finds looks like units; a sparse or noisy cloud finds less than its owner thinks.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from ..adjustment.expectation import advice
from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..common.feedback import Feedback
from ..data.survey import Survey, SurveyUnit, inside
from ..data.tiles import TileInfo
from ..model.unit_types import UnitType
from ..segmentation.cloud_quality import cloud_quality
from ..segmentation.unit_size import (
    FINAL_WINDOWS,
    LEAST_EVIDENCE,
    TRIAL_WINDOWS,
    FoundSize,
    SizeTrial,
    estimate_sizes,
    refined,
    trial_heights,
    try_size,
)
from .cloud_sample import sample_points

SIDE = 1.1
"""Ratio of the heights above and below the given one that are tried beside it."""
REFUSED = 0.08
"""Difference of heights, as a share, from which units are certainly of another size: castings differ by a tenth of it."""
WARNED = 0.045
"""Difference that is worth a warning: more than moulds of one nominal size differ by."""
FAR = 3.2
"""Ratio of heights up to which another size is looked for where the given one shows nothing."""


def check_sizes(
    survey: Survey, tiles: Sequence[TileInfo], feedback: Feedback, whole: Callable[[], FloatArray | None] = lambda: None
) -> None:
    """Hold every type of unit of a survey against the tiles of one epoch, and say what comes of it; ``whole`` as of
    :func:`.sample_points`.

    Raises
    ------
    InputError
        A size that contradicts itself, or that of the units that are there; it names the right one.
    """
    for index, unit in enumerate(survey.units):
        _check_proportions(survey, index, unit.type)
    if not survey.size_check:
        return
    height = max(unit.type.height for unit in survey.units)
    points, origin = sample_points(tiles, survey.crs, height, whole=whole, is_cancelled=feedback.is_cancelled)
    for index, unit in enumerate(survey.units):
        feedback.progress(index / len(survey.units), "comparing the size of the units with the cloud")
        mine = _inside(points, origin, unit)
        others = [other.type.height for k, other in enumerate(survey.units) if k != index]
        _judge(survey, index, mine, others, feedback)
        _say_what_to_expect(mine, unit.type, feedback)


def _say_what_to_expect(points: FloatArray, unit: UnitType, feedback: Feedback) -> None:
    """How much a cloud of this density and noise shows, from (n, 3) points of it; a warning where that is little."""
    quality = cloud_quality(points, unit.height)
    if quality is None:
        return
    said, poor = advice(quality.density, quality.noise, unit)
    (feedback.warning if poor else feedback.info)(said)


def found_size(points: FloatArray, unit: UnitType) -> tuple[SizeTrial, FoundSize | None]:
    """What a given unit explains, and the size of the units that are there where it is not plainly that; None where it is, or none is seen.

    Parameters
    ----------
    points
        (n, 3) reduced frame, metres.
    """
    # one place mostly tells; the second is looked at where it does not
    for windows in (1, TRIAL_WINDOWS):
        given = try_size(points, unit, windows=windows)
        sides = [try_size(points, _scaled(unit, factor), windows=windows) for factor in (1 / SIDE, SIDE)]
        best = max(sides, key=lambda trial: trial.evidence)
        if given.evidence > max(2 * best.evidence, LEAST_EVIDENCE):
            return given, None
    if max(given.evidence, best.evidence) > LEAST_EVIDENCE:
        return given, _refined(points, unit if given.evidence > best.evidence else _scaled(unit, best.height / unit.height))
    heights = [float(h) for h in trial_heights(points) if 1 / FAR < h / unit.height < FAR]
    return given, next(iter(estimate_sizes(points, heights=heights)), None)


def _refined(points: FloatArray, unit: UnitType) -> FoundSize | None:
    """Size near a trial size; in noise the trial size itself, within half a step, where that explains more.

    Noise makes free shapes too large: at 3.3 % of the height by 8 to 10 % on simulated piles, where the true size explains a tenth to a
    fifth more.
    """
    found = refined(points, unit)
    if found is None or not found.noisy:
        return found
    trial = try_size(points, unit, windows=FINAL_WINDOWS)
    if trial.evidence < found.trial.evidence:
        return found
    return replace(found, unit=unit, trial=trial, uncertainty=0.5 * (SIDE - 1) * unit.height)


def _judge(survey: Survey, index: int, points: FloatArray, others: Sequence[float], feedback: Feedback) -> None:
    """Say whether the size of one type of unit fits, or refuse it; ``others`` are the heights of the survey's other types."""
    unit = survey.units[index].type
    given, other = found_size(points, unit)
    if other is None:
        if given.units:
            feedback.info(f"size of the units: {unit.height:.4g} m fits ({given.units} stand out in the places looked at)")
        else:
            feedback.info(f"size of the units: nothing stands out that tells it; {unit.height:.4g} m is taken as given")
        return
    apart = abs(other.unit.height / unit.height - 1)
    low, high = other.unit.height - other.uncertainty, other.unit.height + other.uncertainty
    seen = f"{other.trial.units} stand out whose height is between {low:.3g} and {high:.3g} m"
    if apart < WARNED or any(abs(other.unit.height / height - 1) < REFUSED for height in others):
        feedback.info(f"size of the units: {unit.height:.4g} m fits ({seen})")
    elif apart < REFUSED or not other.sure:
        feedback.warning(f"size of the units: {unit.height:.4g} m is given, but {seen}. Is height = {other.unit.height:.3g} meant?")
    else:
        raise InputError(
            f"height {unit.height:.4g} m is not that of the units in the tiles: {seen}",
            source=survey.path,
            where=_key(survey, index),
            remedy=f"Write height = {other.unit.height:.3g} (and take out radius, gradient and leg_length), "
            "or size_check = false in [survey] if you mean others.",
        )


def _check_proportions(survey: Survey, index: int, unit: UnitType) -> None:
    """Refuse a height that the given legs do not reach: from the plane under three legs to the top of the fourth."""
    if unit.opening != "tetrahedral":
        return
    reached = unit.leg_length * 4 / 3 + unit.end_radius * math.sqrt(8) / 3
    if abs(reached / unit.height - 1) > REFUSED:
        raise InputError(
            f"height {unit.height:.4g} m contradicts the legs: radius, gradient and leg_length make a unit {reached:.4g} m high",
            source=survey.path,
            where=_key(survey, index),
            remedy=f"Correct height, or take out radius, gradient and leg_length: for {unit.height:.4g} m they follow from the height.",
        )


def _key(survey: Survey, index: int) -> str:
    return f"[[unit]] {index + 1}, key height" if len(survey.units) > 1 else "[unit], key height"


def _inside(points: FloatArray, origin: FloatArray, unit: SurveyUnit) -> FloatArray:
    """Points of the squares, a height wide, whose middles lie in the area of a type; all where it has none."""
    area = unit.area
    if area is None:
        return points
    cells, which = np.unique(np.floor(points[:, :2] / unit.type.height).astype(np.int64), axis=0, return_inverse=True)
    middles = (cells + 0.5) * unit.type.height + origin[:2]
    keep = np.array([inside(area, float(e), float(n)) for e, n in middles], dtype=np.bool_)
    return points[keep[which.ravel()]]


def _scaled(unit: UnitType, factor: float) -> UnitType:
    return replace(unit, height=unit.height * factor, radius=unit.radius * factor, leg_length=unit.leg_length * factor)
