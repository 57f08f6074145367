"""Registration of an epoch's cloud to survey control: weighted rigid or similarity transformation with data snooping.

Model per target: X = X0 + t + m R (x - x0), with x measured in the cloud and X surveyed. x0 and X0 are reduction points (the
weighted centroids), so that nothing runs on seven-digit coordinates and translation and rotation are nearly uncorrelated.
Outliers are tested a point (three coordinates) at a time with the externally studentised statistic, whose distribution F(3, r - 3)
holds for small redundancy too (Foerstner and Wrobel, 2016, Photogrammetric Computer Vision, 4.6.4), the level shared among the
points after Bonferroni (Pope, 1976; Baarda, 1968 for the notion of snooping).
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation
from scipy.special import fdtrc

from ..common.arrays import BoolArray, FloatArray
from ..common.errors import InputError
from ..common.rotations import closest_rotation
from ..data.point_tables import SurveyedPoints
from .transformation import Transformation, rigid_jacobian

SNOOPING_LEVEL = 0.01
"""Probability of excluding any good target of an epoch."""
MIN_TARGETS = 3
DISTURBED = "disturbed target excluded"
"""How the note on excluded targets begins."""
LEAST_SPREAD = 0.1
"""Least spread of chosen targets across their main direction, over that of all targets."""
AXES_TOLERANCE = 30.0
"""Misfit of half of the targets, in stated standard deviations, that no measurement explains."""
SCALE_TOLERANCE = 0.002
"""Difference of scale that projection, height and instrument together can bring."""
LEVEL_TOLERANCE = 5.0
"""Tilt in degrees between a cloud's vertical and control that a levelled instrument never has."""


@dataclass(frozen=True, eq=False, kw_only=True)
class ControlResidual:
    """Residual of one target after the transformation, and the verdict on it.

    Attributes
    ----------
    position
        (3,) surveyed coordinates, metres.
    residual
        (3,) transformed cloud less surveyed coordinate, metres; of an excluded point the error it would have brought.
    sds
        (3,) stated standard deviations of the residual, metres.
    w_max
        Largest of the three residuals over their standard deviations.
    p_value
        Of the point's outlier test, not yet shared among the points.
    """

    point_id: str
    position: FloatArray
    residual: FloatArray
    sds: FloatArray
    w_max: float
    p_value: float
    used: bool
    outlier: bool


@dataclass(frozen=True, eq=False, kw_only=True)
class Registration:
    """Result of :func:`register`.

    Attributes
    ----------
    sigma0
        Standard deviation of unit weight; the covariance is scaled by its square where it exceeds 1 (nobody states how well the
        targets were measured in the cloud).
    redundancy
        Coordinates less parameters.
    exclusion_effect
        Shift in metres that keeping the excluded targets would bring at ``reference`` (largest over the reference points); 0 without
        exclusions.
    notes
        Statements for the user.
    reference
        Label of the epoch whose registered cloud this one was tied to; its error is part of the covariance. None for targets.
    tied_by
        What tied it: stable areas, or units that both epochs show.
    """

    transformation: Transformation
    residuals: tuple[ControlResidual, ...]
    sigma0: float
    redundancy: int
    exclusion_effect: float
    notes: tuple[str, ...]
    reference: str | None = None
    tied_by: Literal["stable areas", "units"] = "stable areas"

    @classmethod
    def own_frame(cls, origin: ArrayLike) -> Registration:
        """The cloud's own frame is the datum that other epochs are tied to."""
        return cls(
            transformation=Transformation.identity(origin),
            residuals=(),
            sigma0=1.0,
            redundancy=0,
            exclusion_effect=0.0,
            notes=("no control, its cloud's own frame is the datum",),
        )

    @property
    def datum(self) -> str:
        """What the frame hangs on: control, stable areas, units, or cloud (its own frame), as field ``datum`` of the result says it."""
        if self.reference is not None:
            return self.tied_by
        return "control" if self.residuals else "cloud"

    @property
    def excluded(self) -> tuple[str, ...]:
        """Names of the disturbed targets."""
        return tuple(r.point_id for r in self.residuals if r.outlier)


def register(
    control: SurveyedPoints,
    targets: SurveyedPoints,
    *,
    similarity: bool = False,
    level: float = SNOOPING_LEVEL,
    reference: ArrayLike | None = None,
    others: Sequence[Registration] = (),
) -> Registration:
    """Estimate the transformation of a cloud to survey control.

    Parameters
    ----------
    control, targets
        The same targets as surveyed and as measured in the cloud; they are matched by name.
    similarity
        Estimate a scale as well.
    level
        Probability of excluding any good target.
    reference
        (n, 3) points of the cloud (the units' centres) at which the effect of excluded targets is stated; None for the targets.
    others
        Registrations of the survey's other epochs. Their targets were measured alike, so that their residuals tell too how large one may
        be: with eight targets in each of two epochs a disturbed target is missed half as often.

    Raises
    ------
    InputError
        Fewer than three common targets, targets on one line, or coordinates whose columns or axes are exchanged.
    """
    names, unmatched = _common_names(control, targets)
    pick_control = [control.ids.index(name) for name in names]
    pick_target = [targets.ids.index(name) for name in names]
    surveyed, measured = control.coordinates[pick_control], targets.coordinates[pick_target]
    variances = control.sds[pick_control] ** 2 + targets.sds[pick_target] ** 2
    if not (variances > 0).all():
        variances = np.where(variances > 0, variances, np.max(variances) or 1.0)
    noise = float(math.sqrt(np.median(variances)))
    _check_spread(measured, noise, targets)
    _check_axes(surveyed, measured, noise, control, targets)
    pool = sum(r.sigma0**2 * r.redundancy for r in others), sum(r.redundancy for r in others)

    @cache  # both searches for the targets to use end, as a rule, with the same ones
    def outlier_tests(used: bytes) -> list[tuple[FloatArray, float]]:
        kept = np.frombuffer(used, dtype=np.bool_)
        return [_outlier_test(surveyed, measured, variances, kept, similarity, k, pool) for k in range(len(names))]

    used = _snoop(surveyed, measured, variances, similarity, level, lambda used: np.array([p for _, p in outlier_tests(used.tobytes())]))
    fit = weighted_fit(surveyed, measured, variances, used, similarity)
    everything = weighted_fit(surveyed, measured, variances, np.ones(len(names), dtype=bool), similarity)
    residuals = fit.transformation.apply(measured) - surveyed
    residual_rows = tuple(
        ControlResidual(
            point_id=name,
            position=surveyed[k],
            residual=residuals[k],
            sds=np.sqrt(variances[k]),
            w_max=float(np.max(np.abs(statistic))),
            p_value=p_value,
            used=bool(used[k]),
            outlier=not used[k],
        )
        for k, (name, (statistic, p_value)) in enumerate(zip(names, outlier_tests(used.tobytes()), strict=True))
    )
    effect, where = 0.0, measured if reference is None else np.asarray(reference, dtype=np.float64).reshape(-1, 3)
    if not used.all():
        shift = everything.transformation.apply(where) - fit.transformation.apply(where)
        effect = float(np.max(np.linalg.norm(shift, axis=1)))
    excluded = [name for name, kept in zip(names, used) if not kept]
    notes = tuple(_notes(fit, unmatched, excluded, effect, "the targets" if reference is None else "the units"))
    # an a posteriori factor below 1 is not trusted: the stated deviations are the least a surveyor vouches for
    factor = max(1.0, fit.sigma0) ** 2 if fit.redundancy > 0 else 1.0
    return Registration(
        transformation=replace(fit.transformation, covariance=fit.transformation.covariance * factor),
        residuals=residual_rows,
        sigma0=fit.sigma0,
        redundancy=fit.redundancy,
        exclusion_effect=effect,
        notes=notes,
    )


def _common_names(control: SurveyedPoints, targets: SurveyedPoints) -> tuple[list[str], list[str]]:
    """Names of the targets in both files, in the order of control, and of those in one file only."""
    names = [name for name in control.ids if name in set(targets.ids)]
    unmatched = sorted(set(control.ids) ^ set(targets.ids))
    if len(names) < MIN_TARGETS:
        raise InputError(
            f"shares {len(names)} targets with {_name(control.source)}; a transformation needs {MIN_TARGETS}",
            source=targets.source,
            where=f"unmatched: {', '.join(unmatched[:8])}" if unmatched else "",
            remedy="Use the same point_id in both files and measure at least three targets, better five, that are not on one line.",
        )
    return names, unmatched


def _notes(fit: WeightedFit, unmatched: Sequence[str], excluded: Sequence[str], effect: float, where_shifted: str) -> list[str]:
    """What a surveyor should know of a registration, one sentence each."""
    notes = [f"target {name} is in one file only" for name in unmatched]
    if excluded:
        out = ", ".join(excluded)
        notes.append(f"{DISTURBED}: {out}; keeping it would shift the cloud by up to {1000 * effect:.1f} mm at {where_shifted}")
    tilt = math.degrees(math.acos(float(np.clip(fit.transformation.rotation[2, 2], -1, 1))))
    if tilt > LEVEL_TOLERANCE:
        notes.append(
            f"vertical of the cloud is turned by {tilt:.1f} degrees against control: check the sign of heights unless it was not levelled"
        )
    if fit.redundancy < 3:
        notes.append(f"redundancy of the registration is {fit.redundancy}: a disturbed target cannot be told")
    return notes


@dataclass(frozen=True, eq=False, kw_only=True)
class WeightedFit:
    """Transformation by weighted least squares, with what tests need.

    Attributes
    ----------
    transformation
        Cloud to control, with the covariance of the stated deviations.
    sigma0, redundancy, square_sum
        Standard deviation of unit weight, degrees of freedom, and the weighted sum of squares of the residuals.
    residuals
        (n, 3) adjusted less surveyed, metres, of points left out too.
    rows
        Derivatives of the coordinates with respect to the free parameters.
    """

    transformation: Transformation
    sigma0: float
    redundancy: int
    square_sum: float
    residuals: FloatArray
    rows: FloatArray


def weighted_fit(surveyed: FloatArray, measured: FloatArray, variances: FloatArray, used: BoolArray, similarity: bool) -> WeightedFit:
    """Weighted least squares over the used points; closed-form start, then Gauss-Newton with the full weights.

    Parameters
    ----------
    surveyed, measured
        (n, 3) the same points in control and in the cloud, metres.
    variances
        (n, 3) of their differences, square metres.
    used
        (n,) points that take part.
    similarity
        Estimate a scale as well.
    """
    weights = np.where(used[:, None], 1 / variances, 0.0)
    mean_weight = weights.mean(axis=1)
    origin_from = np.average(measured, axis=0, weights=mean_weight)
    origin_to = np.average(surveyed, axis=0, weights=mean_weight)
    x, y = measured - origin_from, surveyed - origin_to
    rotation, scale = _closed_form(x[used], y[used], mean_weight[used], similarity)
    free = 7 if similarity else 6
    translation = np.zeros(3)
    cofactor = np.zeros((7, 7))
    for _ in range(10):
        turned = scale * x @ rotation.T
        misfit = y - turned - translation
        rows = rigid_jacobian(turned)[:, :, :free]
        rows = rows.copy()
        if similarity:
            rows[:, :, 6] /= scale
        normal = np.einsum("nia,ni,nib->ab", rows, weights, rows)
        change = np.linalg.solve(normal, np.einsum("nia,ni,ni->a", rows, weights, misfit))
        translation = translation + change[:3]
        rotation = Rotation.from_rotvec(change[3:6]).as_matrix() @ rotation
        if similarity:
            scale += change[6]
        if np.linalg.norm(change[:3]) < 1e-9 and np.linalg.norm(change[3:6]) < 1e-12:
            break
    cofactor[:free, :free] = np.linalg.inv(normal)
    residuals = scale * x @ rotation.T + translation - y
    redundancy = 3 * int(used.sum()) - free
    square_sum = float(np.sum(weights * residuals**2))
    sigma0 = math.sqrt(square_sum / redundancy) if redundancy > 0 else 1.0
    transformation = Transformation(
        origin_from=origin_from, origin_to=origin_to, translation=translation, rotation=rotation, scale=float(scale), covariance=cofactor
    )
    return WeightedFit(
        transformation=transformation, sigma0=sigma0, redundancy=redundancy, square_sum=square_sum, residuals=residuals, rows=rows
    )


def _closed_form(x: FloatArray, y: FloatArray, weights: FloatArray, similarity: bool) -> tuple[FloatArray, float]:
    """Rotation and scale of reduced points."""
    x, y = x - np.average(x, axis=0, weights=weights), y - np.average(y, axis=0, weights=weights)
    rotation, values = closest_rotation((y * weights[:, None]).T @ x)
    scale = float(np.sum(values) / np.sum(weights * np.sum(x**2, axis=1))) if similarity else 1.0
    return rotation, scale


def _outlier_test(
    surveyed: FloatArray,
    measured: FloatArray,
    variances: FloatArray,
    used: BoolArray,
    similarity: bool,
    point: int,
    pool: tuple[float, int],
) -> tuple[FloatArray, float]:
    """Prediction of one point from the other used ones: normalised residuals (3,) and p-value of all three together.

    ``pool`` is the weighted square sum of the residuals of other epochs and its redundancy.
    """
    others = used.copy()
    others[point] = False
    if others.sum() < MIN_TARGETS or not _spread_enough(measured[others], float(math.sqrt(np.median(variances))), _spread_across(measured)):
        return np.zeros(3), 1.0
    fit = weighted_fit(surveyed, measured, variances, others, similarity)
    moved = fit.transformation.apply(measured[point][None])
    gap = (moved - surveyed[point])[0]
    jacobian = fit.transformation.jacobian(moved)[0]
    cofactor = np.diag(variances[point]) + jacobian @ fit.transformation.covariance @ jacobian.T
    redundancy = fit.redundancy + pool[1]
    if fit.redundancy < 1:
        return np.zeros(3), 1.0
    # a sample variance below the stated one is luck as a rule; without this floor a lucky handful would condemn good targets
    unit_variance = max((fit.square_sum + pool[0]) / redundancy, 1.0)
    statistic = float(gap @ np.linalg.solve(cofactor, gap)) / 3 / unit_variance
    return gap / np.sqrt(np.diag(cofactor) * unit_variance), float(fdtrc(3, redundancy, statistic))


def _snoop(
    surveyed: FloatArray,
    measured: FloatArray,
    variances: FloatArray,
    similarity: bool,
    level: float,
    p_values: Callable[[BoolArray], FloatArray],
) -> BoolArray:
    """Points to use: from all points and from a robust start, the worst point out and any good one back in until nothing changes.

    ``p_values`` of all points, each against those that are used.

    Several disturbed targets can hide each other from the first; the second begins with the points that agree best, which makes the
    noise look too small and good targets too far off. So the second counts only where its variance is significantly less.
    """
    count = len(surveyed)
    if count <= MIN_TARGETS + 1:
        return np.ones(count, dtype=bool)

    starts = np.ones(count, dtype=bool), _robust_start(surveyed, measured, variances)
    from_all, robust = (exclude_by_turns(p_values, start, level) for start in starts)
    fits = [weighted_fit(surveyed, measured, variances, used, similarity) for used in (from_all, robust)]
    ratio = fits[0].sigma0 ** 2 / max(fits[1].sigma0 ** 2, 1.0)
    smaller = fdtrc(fits[0].redundancy, fits[1].redundancy, ratio) < level
    return robust if smaller else from_all


def exclude_by_turns(p_values_of: Callable[[BoolArray], FloatArray], start: BoolArray, level: float) -> BoolArray:
    """(k,) observations to use: the worst out and any good one back in until nothing changes.

    Parameters
    ----------
    p_values_of
        (k,) p-values of all observations, each against the (k,) used ones.
    start
        (k,) used at first.
    level
        Of the test, for the whole set (Bonferroni).
    """
    used = start.copy()
    count = len(used)
    critical = level / count
    for _ in range(2 * count):
        p = p_values_of(used)
        back, worst = np.where(~used, p, 0.0), np.where(used, p, 2.0)
        if back.max() >= critical:
            used[int(np.argmax(back))] = True
        elif worst.min() < critical and used.sum() > MIN_TARGETS + 1:
            used[int(np.argmin(worst))] = False
        else:
            break
    return used


def _robust_start(surveyed: FloatArray, measured: FloatArray, variances: FloatArray) -> BoolArray:
    """Half of the points, and at least four, that agree best with a transformation through some three of them (least median of squares)."""
    count = len(surveyed)
    triples = list(itertools.combinations(range(count), 3))
    if len(triples) > 400:
        rng = np.random.default_rng(0)
        triples = [tuple(t) for t in np.array(triples)[rng.choice(len(triples), 400, replace=False)]]
    keep = max(MIN_TARGETS + 1, count // 2 + 1)
    noise, across = float(math.sqrt(np.median(variances))), _spread_across(measured)
    spread = [triple for triple in triples if _spread_enough(measured[list(triple)], noise, across)]
    index = np.array(spread, dtype=np.int64).reshape(-1, 3)
    from_places, to_places = measured[index], surveyed[index]
    from_middle, to_middle = (places.mean(axis=1, keepdims=True) for places in (from_places, to_places))
    rotations, _ = closest_rotation(np.swapaxes(to_places - to_middle, 1, 2) @ (from_places - from_middle))
    moved = (measured - from_middle) @ np.swapaxes(rotations, 1, 2) + to_middle
    squares = np.sum((moved - surveyed) ** 2 / variances, axis=2)
    orders = np.argsort(squares, axis=1)[:, :keep]
    farthest = np.take_along_axis(squares, orders[:, -1:], axis=1)[:, 0]
    best = (orders[k] for k in np.argsort(farthest, kind="stable"))
    chosen = next((order for order in best if _spread_enough(measured[order], noise, across)), np.arange(keep))
    used = np.zeros(count, dtype=bool)
    used[chosen] = True
    return used


def _spread_across(network: FloatArray) -> float:
    """Spread of (n, 3) points across their main direction, metres."""
    return float(np.linalg.svd(network - network.mean(axis=0), compute_uv=False)[1]) / math.sqrt(len(network))


def _spread_enough(points: FloatArray, noise: float, across: float = 0.0) -> bool:
    """Whether points lie so far off one line that the rotation about it is determined (better than about 10 degrees).

    Of points chosen from a network, which spreads ``across`` its main direction, more is asked: targets in one row agree with each other
    whatever the rotation about the row, and would condemn all others. Noise alone, often understated, must not pass for a spread.
    """
    values = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    least = max(5 * noise, 1e-3 * values[0], LEAST_SPREAD * across * math.sqrt(len(points)))
    return bool(values[1] > least)


def _check_spread(measured: FloatArray, noise: float, targets: SurveyedPoints) -> None:
    if not _spread_enough(measured, noise):
        raise InputError(
            f"{len(measured)} common targets lie on one line: the rotation about it is not determined",
            source=targets.source,
            remedy="Add a target off that line (another height or another row on the deck).",
        )


def _check_axes(surveyed: FloatArray, measured: FloatArray, noise: float, control: SurveyedPoints, targets: SurveyedPoints) -> None:
    """Refuse exchanged columns: found as the order of columns with which the network fits upright."""
    axes = ("easting", "northing", "height")
    size = float(np.sqrt(np.mean(np.sum((surveyed - surveyed.mean(axis=0)) ** 2, axis=1))))
    tolerance = AXES_TOLERANCE * noise + SCALE_TOLERANCE * size
    found: list[tuple[float, float, tuple[int, ...]]] = []
    for order in itertools.permutations(range(3)):
        moved = surveyed[:, order]
        x, y = measured - np.median(measured, axis=0), moved - np.median(moved, axis=0)
        rotation, _ = _closed_form(x, y, np.ones(len(x)), False)
        misfit = (x - x.mean(axis=0)) @ rotation.T - (y - y.mean(axis=0))
        tilt = math.degrees(math.acos(float(np.clip(rotation[2, 2], -1, 1))))
        found.append((float(np.median(np.linalg.norm(misfit, axis=1))), tilt, order))
    given_misfit, given_tilt, _ = found[0]
    if given_misfit <= tolerance and given_tilt < 45:
        return
    upright = [f for f in found[1:] if f[0] <= tolerance and f[1] < 45]
    if upright:
        order = min(upright)[2]
        columns = ", ".join(f"{axes[k]} holds {axes[order.index(k)]}" for k in range(3) if order[k] != k)
        raise InputError(
            f"columns or axes are exchanged: {columns}",
            source=control.source,
            remedy=f"Put easting, northing and height in their columns (here or in {_name(targets.source)}).",
        )
    if given_misfit <= tolerance:
        raise InputError(
            f"fits the targets only with the vertical turned by {given_tilt:.0f} degrees",
            source=control.source,
            remedy="Check the order of the columns, the sign of heights, and that the cloud's z points up.",
        )
    raise InputError(
        f"does not fit {_name(targets.source)}: half of the targets are off by more than {given_misfit:.3g} m",
        source=control.source,
        remedy="Check that point_ids name the same targets, that units and CRS agree (control_crs, control_unit), and the epoch.",
    )


def _name(source: Path | None) -> str:
    return "the other file" if source is None else source.name
