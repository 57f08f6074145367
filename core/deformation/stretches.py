"""Common motion of stretches along the structure: settlement and sliding that single units, judged by their neighbours, cannot show.

A stretch's motion in datum ``control`` is the mean displacement of its units less what targets say of the frames there; in datum
``stable`` it is less what the units of all other stretches (and targets) say, so that a stretch cannot explain itself. Its covariance
holds the frames' common error, which does not become less with the number of units, and what stretches that did not move differ by
beyond that: errors that neighbours share, of a station or strip, of growth or of a bend too small to be told. That variance is learned
from the other stretches of the structure, as the variance between groups is in an analysis of random effects (DerSimonian and Laird,
1986, Controlled Clinical Trials 7), by their median, so that a stretch that moved does not hide itself or another. On a coast of 100 m
one to four others show it, and the test's tails are as heavy as so few leave them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from scipy.optimize import brentq
from scipy.special import fdtri, gammaln

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.centreline import ARM_HEIGHTS, centreline
from ..common.kernels import kernel
from ..common.noncentrality import noncentrality
from ..common.positive_definite import factorise, solve_factorised
from ..common.robust import CHI2_3_MEDIAN, t_weights
from ..registration.frame_field import FieldEstimate
from .congruence import Congruence, pooled_degrees, quadratic
from .displacement import POWER, SIGNIFICANCE, adjusted_p_values
from .elastic_congruence import ElasticDatum
from .null_model import f_p_value

DATUMS = ("stable", "control")
STRETCH_HEIGHTS = 10.0
"""Length of a stretch in heights of a unit."""
FEWEST_UNITS = 5
FEWEST_OF_DATUM = 3
"""Units that know a rigid frame where there is no control."""
FEW_STRETCHES = 20
"""Stretches up to which one that moved shifts and turns a rigid frame under the others by what matters; of more each holds too little."""
OVERLAPPING = 3
"""A stretch and the two that it overlaps."""
FEWEST_OTHERS = 4
"""Other stretches, none of them overlapping, from which their variance is learned for datum ``control``: fewer may lie on what moved."""
NO_OTHERS = 1.0
"""Degrees of freedom of what is stated where no stretch is apart from the one in question and could show it."""
TAILS = (3.0, 4.0, 6.0, 9.0, 15.0, 30.0)
USUAL_TAIL, TAIL_PRIOR = 15.0, 0.8
"""Degrees of freedom of the tails among which the likeliest is chosen, and their prior: about 15 within a factor of two, as for units."""
OVERLAP = 2.0
"""Stretches that show the same ground."""
MOST_ANEW = 500
"""Unknowns of a field up to which it is adjusted anew without each stretch: of a longer coast the stretch is taken out of what is known."""
ROBUST_STEPS = 8
"""Times that weights and mean follow from each other."""


@dataclass(frozen=True, eq=False, kw_only=True)
class StretchMotion:
    """Common motion of the units of one stretch in one datum.

    Attributes
    ----------
    place
        (3,) centroid of its units, metres.
    along_from, along_to
        Beginning and end along the structure, from the first unit, metres.
    units
        Units that were averaged.
    motion, covariance
        (3,), (3, 3) metres.
    p_value, adjusted
        Test against zero, and the smallest false discovery rate at which it is called among all stretches of the pair.
    detectable
        Motion found with a power of 80 % in the worst direction, metres: what is less cannot be told from the frames' error.
    """

    place: FloatArray
    along_from: float
    along_to: float
    units: int
    motion: FloatArray
    covariance: FloatArray
    p_value: float
    adjusted: float
    detectable: float


@dataclass(frozen=True, eq=False, kw_only=True)
class JudgedUnits:
    """Units of a pair on which its datum may rest: (n, 3) places and displacements, (n, 3, 3) calibrated covariances."""

    places: FloatArray
    vectors: FloatArray
    covariances: FloatArray


def stretches_of(places: FloatArray, height: float) -> tuple[list[IntArray], FloatArray, float]:
    """Units of each stretch by number, where each of (n, 3) units lies along the structure (metres from the first), and a stretch's length.

    Stretches begin every half of their length, so that what slides lies for three quarters of it in one of them at least.
    """
    along = centreline(places, ARM_HEIGHTS * height).locate(places)[0]
    along = along - along.min() if len(along) else along
    length = float(along.max()) if len(along) else 0.0
    count = max(1, round(length / (STRETCH_HEIGHTS * height)))
    half = np.minimum((along / max(length, 1e-9) * 2 * count).astype(np.int64), 2 * count - 1)
    return [np.flatnonzero((half == k) | (half == k + 1)) for k in range(2 * count - 1)], along, length / count


def motions_of_stretches(
    units: JudgedUnits, congruence: Congruence, elastic: ElasticDatum | None, height: float
) -> dict[str, list[StretchMotion]]:
    """Common motion of every stretch with enough units, by datum.

    Rigid frames reach everywhere, so that a stretch which moved turns them under all others: the clearest one is told first, and the others
    are judged again without it, where enough of them say which one that is. Bent frames are known without what moved as one.
    """
    stretches, _, length = stretches_of(units.places, height)
    numbers = [k for k, own in enumerate(stretches) if len(own) >= FEWEST_UNITS]
    judged = partial(_all_motions, units, stretches, numbers, length, elastic=elastic, height=height)
    found = judged(congruence)
    if elastic is not None or not FEWEST_OTHERS + OVERLAPPING <= len(numbers) <= FEW_STRETCHES:
        return found
    rests = congruence.stable
    told: set[int] = set()
    while clear := [
        (motion.p_value, k) for k, motion in zip(numbers, found["stable"], strict=True) if motion.adjusted < SIGNIFICANCE and k not in told
    ]:
        told.add(min(clear)[1])
        rests = rests.copy()
        rests[stretches[min(clear)[1]]] = False
        if rests.sum() < FEWEST_UNITS:
            break
        found = judged(replace(congruence, stable=rests))
    return found


def _all_motions(
    units: JudgedUnits,
    stretches: Sequence[IntArray],
    numbers: Sequence[int],
    length: float,
    congruence: Congruence,
    *,
    elastic: ElasticDatum | None,
    height: float,
) -> dict[str, list[StretchMotion]]:
    """Of the stretches of these ``numbers``, each of a ``length`` in metres, by datum; ``stable`` is that of ``congruence``."""
    means = {datum: [_mean_motion(units, stretches[k], congruence, elastic, datum, height) for k in numbers] for datum in DATUMS}
    others = [_motions_of_others(units, stretches, numbers, k, congruence, means["stable"], elastic, height) for k in numbers]
    between = [_between_stretches(own) for own in others]
    known = [b if len(own) >= FEWEST_OTHERS else (0.0, math.inf) for b, own in zip(between, others, strict=True)]
    learned = {"stable": between, "control": known}
    found: dict[str, list[StretchMotion]] = {}
    for datum in DATUMS:
        covariances, p_values = [], []
        for k, mean, (variance, degrees) in zip(numbers, means[datum], learned[datum], strict=True):
            own = mean.cofactor + variance * np.eye(3)
            own_degrees = min(degrees, len(stretches[k]) * congruence.null.tail)
            covariances.append(own + mean.frame)
            form = float(mean.motion @ np.linalg.solve(covariances[-1], mean.motion))
            # in datum stable it is the others that show how far off units and bend together are
            of_frame = own_degrees if datum == "stable" else congruence.control_degrees
            pooled = pooled_degrees(own[None], own_degrees, mean.frame[None], of_frame)
            p_values.append(float(f_p_value(np.array([form]), pooled)[0]))
        found[datum] = [
            StretchMotion(
                place=units.places[stretches[k]].mean(axis=0),
                along_from=0.5 * k * length,
                along_to=(0.5 * k + 1) * length,
                units=len(stretches[k]),
                motion=mean.motion,
                covariance=covariance,
                p_value=p_value,
                adjusted=float(adjusted),
                detectable=math.sqrt(noncentrality(SIGNIFICANCE, POWER) * float(np.linalg.eigvalsh(covariance)[-1])),
            )
            for k, mean, covariance, p_value, adjusted in zip(
                numbers, means[datum], covariances, p_values, adjusted_p_values(p_values), strict=True
            )
        ]
    return found


@dataclass(frozen=True, eq=False, kw_only=True)
class _MeanMotion:
    """Mean (3,) of a stretch's motions, its covariance (3, 3) by the units' own errors, and that of the frames (3, 3)."""

    motion: FloatArray
    cofactor: FloatArray
    frame: FloatArray


def _motions_of_others(
    units: JudgedUnits,
    stretches: Sequence[IntArray],
    numbers: Sequence[int],
    k: int,
    congruence: Congruence,
    means: Sequence[_MeanMotion],
    elastic: ElasticDatum | None,
    height: float,
) -> list[_MeanMotion]:
    """Motions in datum ``stable`` of the stretches apart from stretch ``k``; ``means`` are those of all ``numbers``.

    Rigid frames reach everywhere: what ``k`` did is in the datum of each other, which so would seem to differ by as much. There they are
    judged without it, unless there are many.
    """
    apart = [i for i, j in enumerate(numbers) if abs(j - k) > 1]
    if elastic is not None or len(numbers) > FEW_STRETCHES:
        return [means[i] for i in apart]
    resting = congruence.stable.copy()
    resting[stretches[k]] = False
    without = replace(congruence, stable=resting)
    return [_mean_motion(units, stretches[numbers[i]], without, None, "stable", height) for i in apart]


def _mean_motion(
    units: JudgedUnits, own: IntArray, congruence: Congruence, elastic: ElasticDatum | None, datum: str, height: float
) -> _MeanMotion:
    shifts, frame = _frame_part(units, own, congruence, elastic, datum)
    motion, cofactor = _robust_mean(units.vectors[own] - shifts, units.covariances[own], height)
    return _MeanMotion(motion=motion, cofactor=cofactor, frame=frame)


def _between_stretches(others: Sequence[_MeanMotion]) -> tuple[float, float]:
    """Variance (square metres) by which resting stretches differ beyond what is stated, from the others, and its degrees of freedom.

    A bend is rougher here and smoother there, and what others say of a stretch errs accordingly: by the tails of t, whose degrees of
    freedom are the likeliest, with a weak prior. Stretches overlap by half, each has three components, and a median knows a variance about
    as well as two thirds of its values do: together as well as there are others.
    """
    if not others:
        return 0.0, NO_OTHERS
    motions = np.array([mean.motion for mean in others])
    covariances = np.array([mean.cofactor + mean.frame for mean in others])
    # a variance alike in all directions is added to that of each axis
    variances, axes = np.linalg.eigh(covariances)
    squares = np.einsum("na,nab->nb", motions, axes) ** 2
    largest = float(np.max(np.sum(motions**2, axis=1)))
    best, found = -math.inf, (0.0, NO_OTHERS)
    for tail in TAILS:
        median = 3 * float(fdtri(3, tail, 0.5))

        def misfit(variance: float, median: float = median) -> float:
            return float(np.median(np.sum(squares / (variances + variance), axis=1))) - median

        variance = float(brentq(misfit, 0.0, largest)) if misfit(0.0) > 0 else 0.0
        total = covariances + variance * np.eye(3)
        each = -0.5 * (tail + 3) * np.log1p(quadratic(motions, total) / tail) - 0.5 * np.linalg.slogdet(total)[1]
        constant = gammaln((tail + 3) / 2) - gammaln(tail / 2) - 1.5 * math.log(tail)
        likely = float(np.sum(each) + len(others) * constant) / OVERLAP - 0.5 * (math.log(tail / USUAL_TAIL) / TAIL_PRIOR) ** 2
        if likely > best:
            best, found = likely, (variance, min(tail, float(len(others))))
    return found


def _frame_part(
    units: JudgedUnits, own: IntArray, congruence: Congruence, elastic: ElasticDatum | None, datum: str
) -> tuple[FloatArray, FloatArray]:
    """Error of the frames at the units of a stretch (k, 3), as those outside and targets see it, and covariance of its mean (3, 3)."""
    places = units.places[own]
    if elastic is None:
        others = congruence
        if datum == "stable":
            keep = congruence.stable.copy()
            keep[own] = False
            # without control too few others say nothing of the frames: the stretch is all there is
            if keep.sum() >= FEWEST_OF_DATUM or not math.isnan(congruence.common_p_value):
                others = congruence.resting_on(keep, units.vectors, units.covariances, units.places)
        middle = others.rigid_motions(places.mean(axis=0)[None], datum)
        return others.rigid_motions(places, datum).means[:, :3], middle.covariances[0, :3, :3]
    if datum == "stable":
        return _without(units, own, elastic)
    return elastic.control.at(places).means[:, :3], elastic.control.covariance_of_mean(places)


def _without(units: JudgedUnits, own: IntArray, elastic: ElasticDatum) -> tuple[FloatArray, FloatArray]:
    """Datum ``stable`` by all units but those of a stretch: the error (k, 3) at these, and covariance of its mean (3, 3).

    What the units of a stretch say bears on the few unknowns that they feel, and is taken out of the joint distribution of these: the
    effort follows the stretch and not the coast, and what is left is that of an adjustment anew to some 1e-8 metres. The less the others
    say, the more digits that costs: 1e-4 metres where a stretch is nearly the whole coast. So short coasts, which cost little, are adjusted
    anew.
    """
    basis = elastic.stable.basis
    if basis.size <= MOST_ANEW:
        field = _adjusted_without(units, own, elastic)
        return field.at(units.places[own]).means[:, :3], field.covariance_of_mean(units.places[own])
    design = basis.design(units.places[own])
    columns = np.unique(design.indices)
    rows = design[:, columns].toarray().reshape(len(own), 3, -1)
    used = elastic.used[own]
    weighted = np.linalg.inv(units.covariances[own][used]) @ rows[used]
    information = np.einsum("kia,kib->ab", rows[used], weighted, optimize=True)
    rhs = np.einsum("kia,ki->a", weighted, units.vectors[own][used])
    known, mean = elastic.stable.covariance[np.ix_(columns, columns)], elastic.stable.mean[columns]
    others = np.linalg.solve(np.eye(len(columns)) - known @ information, known)
    mean = mean + others @ (information @ mean - rhs)
    average = rows.mean(axis=0)
    covariance = average @ others @ average.T
    return rows @ mean, 0.5 * (covariance + covariance.T)


def _adjusted_without(units: JudgedUnits, own: IntArray, elastic: ElasticDatum) -> FieldEstimate:
    """Datum ``stable`` adjusted anew without the units of a stretch."""
    keep: BoolArray = elastic.used.copy()
    keep[own] = False
    weights = np.asarray(np.linalg.inv(units.covariances[keep]), dtype=np.float64)
    return FieldEstimate.from_observations(
        elastic.control.basis, elastic.precision, units.places[keep], units.vectors[keep], weights, elastic.control.mean
    )


def _robust_mean(values: FloatArray, covariances: FloatArray, height: float) -> tuple[FloatArray, FloatArray]:
    """Mean of (k, 3) values that units which moved on their own do not pull, and its covariance."""
    # what units differ by beyond their covariances counts for the weights; the mean's own covariance is told by the values themselves
    rough = covariances + (0.002 * height) ** 2 * np.eye(3)
    centre, residual, weighted, cofactor = _reweighted(values, np.linalg.inv(rough), np.median(values, axis=0))
    _, size = t_weights(quadratic(residual, covariances))
    return centre, size * cofactor @ np.sum(weighted @ covariances @ weighted, axis=0) @ cofactor


@kernel()
def _reweighted(values: Any, inverse: Any, centre: Any) -> Any:
    """Mean of (k, 3) values with (k, 3, 3) weights, from a first one (3,) on: each value weighs less the farther it lies
    (:func:`..common.robust.t_weights`).

    Beside it the values less the mean before the last step (k, 3), their weights in that step (k, 3, 3), and the inverse of the sum of
    these (3, 3).
    """
    count = len(values)
    forms, residual, weighted = np.empty(count), np.empty((count, 3)), np.empty((count, 3, 3))
    cofactor = np.eye(3)
    for _ in range(ROBUST_STEPS):
        for n in range(count):
            forms[n] = 0.0
            for a in range(3):
                residual[n, a] = values[n, a] - centre[a]
            for a in range(3):
                for b in range(3):
                    forms[n] += residual[n, a] * inverse[n, a, b] * residual[n, b]
        size = max(np.median(forms) / CHI2_3_MEDIAN, 1.0)
        total, side = np.zeros((3, 3)), np.zeros(3)
        for n in range(count):
            less = (1 + forms[n] / (3 * size)) ** 2
            for a in range(3):
                for b in range(3):
                    weighted[n, a, b] = inverse[n, a, b] / less
                    total[a, b] += weighted[n, a, b]
                    side[a] += weighted[n, a, b] * values[n, b]
        factorise(total)
        cofactor = np.eye(3)
        for a in range(3):
            solve_factorised(total, cofactor[a])
        centre = cofactor @ side
    return centre, residual, weighted, cofactor
