"""Data snooping: which targets of a registration are disturbed, in time and memory that grow with their number.

Outliers are tested a point (three coordinates) at a time with the externally studentised statistic, whose distribution F(3, r - 3)
holds for small redundancy too (Foerstner and Wrobel, 2016, Photogrammetric Computer Vision, 4.6.4), the level shared among the
points after Bonferroni (Pope, 1976; Baarda, 1968 for the notion of snooping). What the others say of a point follows from one fit of
all (Cook and Weisberg, 1982, Residuals and Influence in Regression, 2.2); only where leaving it out changes more than linearly are
they fitted again.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from scipy.special import fdtrc

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.rotations import closest_rotation
from .weighted_transformation import WeightedFit, weighted_fit

MIN_TARGETS = 3
LEAST_SPREAD = 0.1
"""Least spread of chosen targets across their main direction, over that of all targets."""
MOST_TRIPLES = 400
"""Transformations through three targets that are tried for a robust start."""
LINEAR = 1e-3
"""Error of a prediction without a second fit, in stated standard deviations, that is let pass."""


def outlier_tests(
    surveyed: FloatArray,
    measured: FloatArray,
    variances: FloatArray,
    used: BoolArray,
    similarity: bool,
    pool: tuple[float, int] = (0.0, 0),
) -> tuple[FloatArray, FloatArray]:
    """Prediction of every point from the other used ones.

    Parameters
    ----------
    surveyed, measured, variances, used, similarity
        As :func:`weighted_fit` takes them, of n points.
    pool
        Weighted square sum of the residuals of other epochs, and its redundancy.

    Returns
    -------
    (n, 3) normalised differences and (n,) p-values of all three together; 0 and 1 where the other points do not determine the
    transformation or have no redundancy.
    """
    statistics, p_values = np.zeros((len(used), 3)), np.ones(len(used))
    tested = (used.sum() - used >= MIN_TARGETS) & _spread_without(measured, used, float(math.sqrt(np.median(variances))))
    if not tested.any():
        return statistics, p_values
    fit = weighted_fit(surveyed, measured, variances, used, similarity)
    tested &= fit.redundancy - 3 * used >= 1
    own = np.flatnonzero(tested)
    gaps, cofactors, square_sums, curved = _predictions(fit, variances, used, own)
    for k in np.flatnonzero(curved):
        others = used.copy()
        others[own[k]] = False
        again = weighted_fit(surveyed, measured, variances, others, similarity)
        gaps[k], square_sums[k] = again.residuals[own[k]], again.square_sum
        cofactors[k] = np.diag(variances[own[k]]) + _cofactors(again, own[k : k + 1])[0]
    redundancies = fit.redundancy - 3 * used[own] + pool[1]
    # a sample variance below the stated one is luck as a rule; without this floor a lucky handful would condemn good targets
    unit_variances = np.maximum((square_sums + pool[0]) / redundancies, 1.0)
    forms = np.einsum("ki,ki->k", gaps, np.linalg.solve(cofactors, gaps[:, :, None])[:, :, 0])
    statistics[own] = gaps / np.sqrt(np.einsum("kii->ki", cofactors) * unit_variances[:, None])
    p_values[own] = fdtrc(3, redundancies, forms / 3 / unit_variances)
    return statistics, p_values


def _predictions(
    fit: WeightedFit, variances: FloatArray, used: BoolArray, own: IntArray
) -> tuple[FloatArray, FloatArray, FloatArray, BoolArray]:
    """Of k ``own`` points, each by the other used ones: predicted less surveyed (k, 3), its cofactors (k, 3, 3).

    Then (k,) square sums of the others, and (k,) whether this is not linear enough to be told from the fit of all used ones.
    """
    inside = used[own]
    residuals, stated = fit.residuals[own], variances[own][:, :, None] * np.eye(3)
    adjusted = _cofactors(fit, own)
    # covariance of an own residual (I - H) V; of a point that was left out the difference to the prediction itself
    left = stated + np.where(inside, -1.0, 1.0)[:, None, None] * adjusted
    solved = np.linalg.solve(left, residuals[:, :, None])[:, :, 0]
    gaps = np.where(inside[:, None], variances[own] * solved, residuals)
    cofactors = np.where(inside[:, None, None], stated @ np.linalg.solve(left, stated), left)
    square_sums = fit.square_sum - np.where(inside, np.einsum("ki,ki->k", residuals, solved), 0.0)
    free = fit.rows.shape[2]
    changes = np.einsum("ab,kib,ki->ka", fit.transformation.covariance[:free, :free], fit.rows[own], solved)
    turns = np.linalg.norm(changes[:, 3:], axis=1)
    longest = float(np.sqrt(np.max(np.sum(fit.rows[:, :, 3:6] ** 2, axis=(1, 2))) / 2))
    misfit = float(np.sqrt(np.mean(np.sum(fit.residuals[used] ** 2, axis=1))))
    return gaps, cofactors, square_sums, inside & (turns * (turns * longest + misfit) > LINEAR * np.sqrt(variances.min()))


def _cofactors(fit: WeightedFit, own: IntArray) -> FloatArray:
    """(k, 3, 3) covariance of some transformed points."""
    rows = fit.rows[own]
    free = rows.shape[2]
    return np.asarray(rows @ fit.transformation.covariance[:free, :free] @ np.swapaxes(rows, 1, 2))


def used_targets(
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
    total = math.comb(count, 3)
    few = total <= MOST_TRIPLES
    index = triples(count, np.arange(total) if few else np.random.default_rng(0).choice(total, MOST_TRIPLES, replace=False))
    keep = max(MIN_TARGETS + 1, count // 2 + 1)
    noise, across = float(math.sqrt(np.median(variances))), spread_across(measured)
    index = index[_far_enough(_spreads(measured[index]), 3, noise, across)]
    from_places, to_places = measured[index], surveyed[index]
    from_middle, to_middle = (places.mean(axis=1, keepdims=True) for places in (from_places, to_places))
    rotations, _ = closest_rotation(np.swapaxes(to_places - to_middle, 1, 2) @ (from_places - from_middle))
    moved = (measured - from_middle) @ np.swapaxes(rotations, 1, 2) + to_middle
    squares = np.sum((moved - surveyed) ** 2 / variances, axis=2)
    orders = np.argsort(squares, axis=1)[:, :keep]
    farthest = np.take_along_axis(squares, orders[:, -1:], axis=1)[:, 0]
    best = (orders[k] for k in np.argsort(farthest, kind="stable"))
    chosen = next((order for order in best if spread_enough(measured[order], noise, across)), np.arange(keep))
    used = np.zeros(count, dtype=bool)
    used[chosen] = True
    return used


def triples(count: int, ranks: IntArray) -> IntArray:
    """(k, 3) triples of the numbers below ``count`` by their (k,) ranks in lexicographic order (Knuth, 2011, 7.2.1.3)."""
    numbers = range(count + 1)
    left = math.comb(count, 3) - 1 - ranks
    found = np.empty((len(ranks), 3), dtype=np.int64)
    for place, size in enumerate((3, 2, 1)):
        smaller = np.array([math.comb(number, size) for number in numbers])
        found[:, place] = np.searchsorted(smaller, left, side="right") - 1
        left = left - smaller[found[:, place]]
    return count - 1 - found


def spread_across(network: FloatArray) -> float:
    """Spread of (n, 3) points across their main direction, metres."""
    return float(_spreads(network)[1]) / math.sqrt(len(network))


def spread_enough(points: FloatArray, noise: float, across: float = 0.0) -> bool:
    """Whether points lie so far off one line that the rotation about it is determined (better than about 10 degrees).

    Of points chosen from a network, which spreads ``across`` its main direction, more is asked: targets in one row agree with each other
    whatever the rotation about the row, and would condemn all others. Noise alone, often understated, must not pass for a spread.
    """
    return bool(_far_enough(_spreads(points), len(points), noise, across))


def _spread_without(network: FloatArray, used: BoolArray, noise: float) -> BoolArray:
    """(n,) whether the used points less the one in question are :func:`spread_enough`, from the moments of all used ones."""
    count, inside = int(used.sum()), used[:, None, None]
    arms = network - network[used].mean(axis=0)
    moments = arms[used].T @ arms[used]
    without = moments - np.where(inside, arms[:, :, None] * arms[:, None, :] * count / max(count - 1, 1), 0.0)
    values = np.asarray(np.sqrt(np.maximum(np.linalg.eigvalsh(without)[:, ::-1], 0.0)), dtype=np.float64)
    return np.asarray(_far_enough(values, count - used, noise, spread_across(network)))


def _far_enough(values: FloatArray, count: int | IntArray, noise: float, across: float) -> BoolArray:
    """Whether sets of ``count`` points with (..., 3) singular values, the largest first, are :func:`spread_enough`."""
    least = np.maximum(np.maximum(5 * noise, 1e-3 * values[..., 0]), LEAST_SPREAD * across * np.sqrt(np.asarray(count, dtype=np.float64)))
    return np.asarray(values[..., 1] > least)


def _spreads(points: FloatArray) -> FloatArray:
    """(..., 3) singular values of (..., n, 3) points about their mean."""
    return np.asarray(np.linalg.svd(points - points.mean(axis=-2, keepdims=True), compute_uv=False), dtype=np.float64)
