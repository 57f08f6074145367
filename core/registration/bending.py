"""How much a frame bends and over which distance, learned from the survey itself: restricted maximum likelihood over cells of the ground.

Observations are shifts of many small bodies (resting units between two epochs) or of targets. Units that moved by themselves must not
pass for a bend: cells take medians, a robust variogram (Cressie and Hawkins, 1980, Math. Geol. 12) gives the first model, and cells
that its robust adjustment does not explain stay out of the likelihood. A stiff frame must not seem to bend: without a clear gain of
likelihood there is no model.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import product

import numpy as np
from scipy.linalg import solve_triangular
from scipy.linalg.lapack import dormqr, dpttrf, dpttrs, dsytrd
from scipy.optimize import minimize_scalar

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.axis import Axis
from ..common.centreline import ARM_HEIGHTS, centreline
from ..common.robust import CHI2_1_MEDIAN, MAD_TO_SD, t_weights
from .frame_field import FieldModel, matern
from .moved_stretches import moved_stretches
from .shift_samples import FEWEST_CELLS, ShiftSample, axis_of, smooth_covariances, trend_of

MOST_CELLS = 180
"""Cells of one window of the likelihood; longer coasts are looked at in several, which cover them."""
WINDOW_STEP = 0.5
"""Distance of windows as a share of their cells: what moved as one at the edge of one lies whole in the next."""
MOST_LIKELY_WINDOWS = 4
"""Windows that tell size and lengths of a bend, which are alike all along; what moved as one is looked for in all."""
LARGEST_SHARE = 1.3
"""Largest standard deviation of a field over that of the shifts themselves."""
ALIKE = 0.5
"""How far the standard deviation of a component is drawn to that of all: a coast holds few bends, which leave a single one open by a factor
of two, while those of plan and height differ by half as a rule (assumed)."""
GAIN = 12.0
"""Least gain of log-likelihood by which a frame is said to bend; one that does not gains 12 in fewer than one survey of ten thousand."""
SHORTEST_HEIGHTS = 2.5
"""Least correlation length looked for, in heights of a unit."""
ELONGATED = 3.0
"""Length over width from which the ground is a strip, along which errors run."""
LINE_OF_FLIGHT = 16.0
"""Correlation length across over along of errors that run along a line of flight and are the same all across it."""
SIDE_CELLS, SIDE_SHARE = 4, 0.5
"""Cells on one side of another, and the share of the correlation length within which they are looked for, that say whether it agrees."""
AGREEING = 3.5
"""Distance from those in standard deviations up to which it does."""
LEAST_STRETCH = 5.0
"""Stretch of the whole structure in standard deviations from which it is seen."""
CLEAR_OUTLIER = 5.0
"""Misfit of a cell in standard deviations that no bend explains."""


@dataclass(frozen=True, kw_only=True)
class Bending:
    """What :func:`estimate_bending` found.

    Attributes
    ----------
    model
        None where a rigid motion explains the shifts.
    gain
        Of log-likelihood over a rigid motion.
    line
        Centreline of the structure.
    jumps
        Stretches, from and to along it in metres, that moved as one against all around them: no smooth bend does that.
    """

    model: FieldModel | None
    gain: float
    line: Axis
    jumps: tuple[tuple[float, float], ...] = ()

    def jumped(self, places: FloatArray) -> BoolArray:
        """(k,) which of (k, 2 or 3) places lie on a stretch that moved as one."""
        along = self.line.locate(places)[0]
        inside = np.zeros(len(places), dtype=bool)
        for low, high in self.jumps:
            inside |= (along >= low) & (along <= high)
        return inside


def estimate_bending(sample: ShiftSample, height: float, least_gain: float = GAIN) -> Bending:
    """Model of the bend that the shifts show.

    Parameters
    ----------
    sample
        Shifts by cells and targets.
    height
        H in metres.
    least_gain
        Gain of log-likelihood below which the frame is called rigid.
    """
    axis, elongation = axis_of(sample.places)
    line = centreline(sample.places, ARM_HEIGHTS * height)
    rigid = Bending(model=None, gain=0.0, line=line)
    if np.sum(~sample.fixed) < FEWEST_CELLS and not sample.fixed.all():
        return rigid
    along, shortest = line.locate(sample.places)[0], SHORTEST_HEIGHTS * height
    extent = float(np.ptp(along))
    lengths = np.geomspace(shortest, max(2 * extent, 2 * shortest), 10)
    ratios = (1.0, 4.0) if elongation > ELONGATED else (1.0,)
    first = _first_model(sample, along, lengths, axis)
    windows, searched = [], []
    for window in _windows(along):
        kept = _kept(sample, window, first)
        windows.append(window[kept])
        searched.append(window[kept | _beside_a_step(sample, window, along, first, ~kept)])
    bend_of = partial(_likeliest, sample, axis=axis, lengths=lengths, ratios=ratios)
    found = moved_stretches(sample, along, windows, searched, bend_of, shortest, least_gain)
    model, gain = found.model, found.gain
    if model is None or gain <= least_gain:
        return replace(rigid, gain=gain)
    if elongation > ELONGATED:
        # looked for last: the freer a bend is to follow the ground, the less a step looks like one
        wide, wide_gain = _likeliest(sample, found.windows, axis, lengths, (LINE_OF_FLIGHT,))
        model, gain = (wide, wide_gain) if wide is not None and wide_gain > gain else (model, gain)
    return Bending(model=_no_stiffer_than_seen(sample, found.windows, model), gain=gain, line=line, jumps=found.stretches)


def explained(sample: ShiftSample, model: FieldModel, line: Axis) -> IntArray:
    """Numbers of the cells along a ``line`` that a robust adjustment of a ``model`` explains: units there rest."""
    along = line.locate(sample.places)[0]
    return np.unique(np.concatenate([window[_kept(sample, window, model)] for window in _windows(along)]))


def _likeliest(
    sample: ShiftSample, windows: Sequence[IntArray], axis: tuple[float, float], lengths: FloatArray, ratios: Sequence[float]
) -> tuple[FieldModel | None, float]:
    """Likeliest model of all lengths, ratios and smoothnesses, and its gain over a rigid motion."""
    # a single cell shows no bend
    windows = [window for window in windows if len(window) > 1]
    chosen = min(MOST_LIKELY_WINDOWS, len(windows))
    windows = [windows[(2 * k + 1) * len(windows) // (2 * chosen)] for k in range(chosen)]
    noises = [_whiteners(sample, window) for window in windows]
    best, gain = None, 0.0
    for smoothness, ratio in product((2.5, 1.5), ratios):
        if best is not None and smoothness < best.smoothness and best.across != ratio * best.length:
            continue
        for length in lengths:
            model = FieldModel(sds=(1.0, 1.0, 1.0), length=length, across=length * ratio, axis=axis, smoothness=smoothness)
            sds, found = _likely(sample, windows, noises, model)
            if found > gain:
                best, gain = replace(model, sds=_alike(sds)), found
    return best, gain


def _alike(sds: tuple[float, float, float]) -> tuple[float, float, float]:
    """Standard deviations of the components that bend, each drawn to what all of them say; those that do not stay zero."""
    common = math.exp(sum(math.log(sd) for sd in sds if sd > 0) / max(sum(sd > 0 for sd in sds), 1))
    first, second, third = (sd ** (1 - ALIKE) * common**ALIKE if sd > 0 else 0.0 for sd in sds)
    return first, second, third


def _no_stiffer_than_seen(sample: ShiftSample, windows: Sequence[IntArray], model: FieldModel) -> FieldModel:
    """The model with as much bend in plan as a stretch of the whole structure along itself shows, where a component was said to have none.

    Slopes tell nothing of a bend, since most of them a rigid motion may have; but that one it has not, and a component that is held rigid
    against it turns the frame.
    """
    cells = np.unique(np.concatenate(windows))
    axis = np.array(model.axis)
    weights = 1 / (sample.variances[cells, :2] @ axis**2)
    along = sample.places[cells] @ axis
    arm = along - np.average(along, weights=weights)
    known = float(np.sum(weights * arm**2))
    slope = float(np.sum(weights * arm * (sample.values[cells, :2] @ axis))) / known
    if slope**2 * known < LEAST_STRETCH**2:
        return model
    seen = abs(slope) * float(np.std(along)) * np.abs(axis)
    first, second = (sd if sd > 0 else float(least) for sd, least in zip(model.sds[:2], seen, strict=True))
    return replace(model, sds=(first, second, model.sds[2]))


def rigid_log_likelihood(sample: ShiftSample) -> float:
    """Log-likelihood of the shifts under a rigid motion alone, up to a constant that depends on their number."""
    total = 0.0
    trend = trend_of(sample.places)
    for axis in range(3):
        factor = np.linalg.cholesky(trend @ trend.T + np.diag(sample.variances[:, axis]))
        white = solve_triangular(factor, sample.values[:, axis], lower=True)
        total -= 0.5 * float(white @ white) + float(np.sum(np.log(np.diag(factor))))
    return total


def _first_model(sample: ShiftSample, along: FloatArray, lengths: FloatArray, axis: tuple[float, float]) -> FieldModel:
    """Model from the robust variogram along the structure."""
    order = np.argsort(along)
    lags: list[float] = []
    halves: list[FloatArray] = []
    top = float(np.ptp(along))
    for step in np.unique(np.geomspace(1, max(len(order) // 2, 1), 16).astype(np.int64)):
        i, j = order[:-step], order[step:]
        lag = float(np.median(along[j] - along[i]))
        if len(i) < 5 or lag > 0.6 * top:
            continue
        difference = (sample.values[j] - sample.values[i]) ** 2 / CHI2_1_MEDIAN / 2
        lags.append(lag)
        halves.append(np.median(difference, axis=0) - np.median(sample.variances[i] + sample.variances[j], axis=0) / 2)
    if not lags:
        return FieldModel(sds=(0.0, 0.0, 0.0), length=float(lengths[-1]), across=float(lengths[-1]), axis=axis)
    at, half = np.array(lags), np.maximum(np.array(halves), 0.0)
    best, chosen, sills = math.inf, float(lengths[-1]), np.zeros(3)
    for length in lengths:
        shape = 1 - matern(at / length, 2.5)
        sill = shape @ half / (shape @ shape)
        misfit = float(np.sum((half - shape[:, None] * sill) ** 2))
        if misfit < best:
            best, chosen, sills = misfit, float(length), sill
    sds = np.sqrt(np.maximum(sills, 0.0))
    return FieldModel(sds=(float(sds[0]), float(sds[1]), float(sds[2])), length=chosen, across=4 * chosen, axis=axis)


def _windows(along: FloatArray) -> list[IntArray]:
    """Numbers of the cells of stretches that cover the structure and overlap, each with what the likelihood can hold."""
    order = np.argsort(along)
    if len(order) <= MOST_CELLS:
        return [order]
    steps = math.ceil((len(order) - MOST_CELLS) / (WINDOW_STEP * MOST_CELLS))
    starts = np.linspace(0, len(order) - MOST_CELLS, steps + 1).astype(np.int64)
    return [order[s : s + MOST_CELLS] for s in starts]


def _kept(sample: ShiftSample, window: IntArray, model: FieldModel) -> BoolArray:
    """Which cells a robust adjustment of the first model explains; fixed observations always."""
    fixed = sample.fixed[window]
    weight, misfit = np.ones(len(window)), np.zeros(len(window))
    smooth = smooth_covariances(sample.places[window], model)
    for _ in range(12):
        misfit = np.zeros(len(window))
        for axis in range(3):
            own = sample.variances[window, axis]
            noise = own / weight
            inverse = np.linalg.inv(smooth[axis] + np.diag(noise))
            # prediction of each from all others, with its own stated variance
            away = inverse @ sample.values[window, axis] / np.diag(inverse)
            misfit += away**2 / (1 / np.diag(inverse) - noise + own)
        weights, size = t_weights(misfit)
        weight = np.where(fixed, 1.0, weights)
    return np.asarray(fixed | (misfit / size < CLEAR_OUTLIER**2))


def _beside_a_step(sample: ShiftSample, window: IntArray, along: FloatArray, model: FieldModel, doubtful: BoolArray) -> BoolArray:
    """Which doubtful cells agree with those on one side of them: where a stretch moved as one, no smooth field explains its ends."""
    along = along[window]
    free = ~sample.fixed[window]
    found = np.zeros(len(window), dtype=bool)
    for k in np.flatnonzero(doubtful):
        apart = along - along[k]
        for side in (apart < 0, apart > 0):
            near = np.flatnonzero(side & free & (np.abs(apart) < SIDE_SHARE * model.length))
            near = near[np.argsort(np.abs(apart[near]))[:SIDE_CELLS]]
            if len(near) < SIDE_CELLS:
                continue
            away = sample.values[window[k]] - np.median(sample.values[window[near]], axis=0)
            bent = 2 * np.square(model.sds) * (1 - matern(np.abs(apart[near]).mean() / np.array(model.length), model.smoothness))
            found[k] |= bool(np.sum(away**2 / (2 * sample.variances[window[k]] + bent)) < AGREEING**2)
    return found


def _whiteners(sample: ShiftSample, window: IntArray) -> list[tuple[FloatArray, FloatArray]]:
    """By component, inverse Cholesky factor of the covariance of noise and trend, and the values it whitens."""
    trend = trend_of(sample.places[window])
    found = []
    for axis in range(3):
        factor = np.linalg.cholesky(trend @ trend.T + np.diag(sample.variances[window, axis]))
        inverse = solve_triangular(factor, np.eye(len(window)), lower=True)
        found.append((inverse, inverse @ sample.values[window, axis]))
    return found


def _likely(
    sample: ShiftSample, windows: Sequence[IntArray], noises: Sequence[list[tuple[FloatArray, FloatArray]]], model: FieldModel
) -> tuple[tuple[float, float, float], float]:
    """Most likely standard deviations of a field of given lengths, and the gain of log-likelihood over a rigid motion, all components."""
    sds, gain = [], 0.0
    correlations = [model.correlation(scaled, scaled) for scaled in (model.scaled(sample.places[window]) for window in windows)]
    for axis in range(3):
        # in tridiagonal form every standard deviation costs one sweep, and getting there less than eigenvectors would
        parts = []
        for correlation, noise in zip(correlations, noises, strict=True):
            inverse, white = noise[axis]
            parts.append(_tridiagonal(inverse @ correlation @ inverse.T, white))

        def loss(log_sd: float, parts: Sequence[tuple[FloatArray, FloatArray, FloatArray]] = parts) -> float:
            return sum(_negative_log_likelihood(math.exp(2 * log_sd), *part) for part in parts)

        typical = 0.5 * math.log(float(np.median(sample.variances[:, axis])))
        # smooth waves are fitted alike by a longer and larger field, which would say too little between targets: no larger than it is seen
        seen = np.concatenate(
            [sample.values[w[~sample.fixed[w]], axis] if not sample.fixed[w].all() else sample.values[w, axis] for w in windows]
        )
        largest = math.log(max(LARGEST_SHARE * MAD_TO_SD * float(np.median(np.abs(seen - np.median(seen)))), math.exp(typical)))
        found = minimize_scalar(loss, bounds=(typical - 2.0, min(largest, typical + 5.0) + 0.1), method="bounded", options={"xatol": 0.02})
        better = 0.5 * sum(float(white @ white) for _, _, white in parts) - float(found.fun)
        sds.append(math.exp(float(found.x)) if better > 1.0 else 0.0)
        gain += max(better, 0.0)
    return (sds[0], sds[1], sds[2]), gain


def _tridiagonal(matrix: FloatArray, vector: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Diagonal (k,) and off-diagonal (k - 1,) of a symmetric (k, k) matrix, k > 1, turned to tridiagonal form, and a (k,) vector with it.

    Householder reduction (Golub and Van Loan, 2013, sec. 8.3.1).
    """
    reflectors, diagonal, beside, factors, _ = dsytrd(matrix, lower=1)
    turned = vector.copy()
    turned[1:] = dormqr("L", "T", reflectors[1:, :-1], factors, vector[1:, None], lwork=64)[0][:, 0]
    return diagonal, beside, turned


def _negative_log_likelihood(variance: float, diagonal: FloatArray, beside: FloatArray, white: FloatArray) -> float:
    """Of white noise plus ``variance`` times a tridiagonal matrix, at whitened values (k,), up to a constant."""
    pivots, factor, _ = dpttrf(1 + variance * diagonal, variance * beside)
    return 0.5 * float(white @ dpttrs(pivots, factor, white)[0]) + 0.5 * float(np.sum(np.log(pivots)))
