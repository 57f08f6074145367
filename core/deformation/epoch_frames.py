"""How the frames of all epochs bend: the model from resting units and targets, and each epoch's error as its targets see it.

Targets are judged against the bent frame, each by what the others predict at its place: one that the flight around it contradicts is
disturbed, a station of targets that agree with each other is not.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Literal

import numpy as np
from scipy.linalg import solve_triangular
from scipy.special import fdtrc

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.robust import CHI2_3_MEDIAN
from ..registration.bending import GAIN, Bending, estimate_bending, explained, rigid_log_likelihood
from ..registration.control import SNOOPING_LEVEL
from ..registration.disturbed_targets import MIN_TARGETS, exclude_by_turns
from ..registration.frame_field import FREE_SHIFT, FREE_TURN, RIGID, FieldBasis, FieldEstimate, FieldModel
from ..registration.shift_samples import FEWEST_CELLS, ShiftSample, in_cells
from ..registration.transformation import rigid_jacobian
from .target_changes import p_values_of_changes
from .target_shifts import TargetShifts, difference_of_shared, numbers_of_common, numbers_of_shared

FrameChoice = Literal["auto", "rigid", "elastic"]
CELL_HEIGHTS = 1.5
"""Size of the cells of ground in which displacements are pooled, in heights of a unit."""
RESOLUTION_HEIGHTS = 0.0005
"""Interpolation error of the field that is allowed, in heights of a unit."""
FEWEST_DEGREES = 4.0
"""Least degrees of freedom that the size of a bend is given."""
FEWEST_BENT_TARGETS = 12
"""Targets from which alone a bend may be learned, where there is one epoch."""
NOISE_FACTORS = (1.0, 1.25, 1.6, 2.0, 2.5, 3.2, 4.0, 5.0, 6.3)
BEND_FACTORS = (0.5, 0.7, 1.0, 1.4, 2.0)
"""Factors of the targets' stated deviations, and of the bend between epochs, among which the targets of all epochs choose."""
STATION_HEIGHTS = 4.0
"""Distance in heights of a unit within which targets stand together."""
T5_SCALE = 1.2753
"""Variance of normal errors over the squared scale of the t distribution (three components, five degrees) likeliest for them."""
TARGET_CAUTION = 4.0
"""Factor of the stated deviations of targets while it is not known how well they were measured, and which are disturbed."""


@dataclass(frozen=True, eq=False, kw_only=True)
class TargetVerdicts:
    """Targets of an epoch against its bent frame.

    Attributes
    ----------
    residuals
        (k, 3) what the bent frame leaves, metres; of an excluded target what the others predict less it.
    w_max, p_values
        (k,) largest normalised residual and p-value of all three, from the prediction by the others.
    used
        (k,) False for a disturbed one.
    """

    residuals: FloatArray
    w_max: FloatArray
    p_values: FloatArray
    used: BoolArray


@dataclass(frozen=True, eq=False, kw_only=True)
class EpochFrames:
    """Frames of all epochs.

    Attributes
    ----------
    model
        Bend of one epoch; its standard deviations are those of a single epoch.
    gain
        Log-likelihood gained over rigid frames.
    basis
        Nodes over all units and targets.
    errors
        By epoch: error of the registered cloud as its targets see it; None without targets.
    verdicts
        By epoch: its targets judged; None without targets.
    targets
        By epoch: those that its frame rests on; None without targets.
    noise_factor
        Of the targets' stated deviations.
    bendings
        By pair of epochs that follow each other: what its units show; None for too few of them.
    degrees
        Degrees of freedom with which the size of the bend is known: correlation lengths that the structure is long, at least
        ``FEWEST_DEGREES``.
    """

    model: FieldModel
    gain: float
    basis: FieldBasis
    errors: tuple[FieldEstimate | None, ...]
    verdicts: tuple[TargetVerdicts | None, ...]
    targets: tuple[TargetShifts | None, ...]
    noise_factor: float
    bendings: tuple[Bending | None, ...]
    degrees: float

    def jumped(self, first: int, second: int, places: FloatArray) -> BoolArray:
        """(k,) which of (k, 3) places lie on a stretch that moved as one in some pair between two epochs."""
        inside = np.zeros(len(places), dtype=bool)
        for bending in self.bendings[first:second]:
            if bending is not None:
                inside |= bending.jumped(places)
        return inside

    def between(self, first: int, second: int) -> tuple[FieldEstimate, FloatArray]:
        """Difference of two epochs as targets see it, the prior where one has none, and the inverse of its covariance."""
        a, b = self.errors[first], self.errors[second]
        one, other = self.targets[first], self.targets[second]
        shared = None if one is None or other is None else difference_of_shared(one, other)
        if shared is not None:
            basis = self.basis.scaled_by(math.sqrt(2))
            noise = _likeliest_noise(basis.model, shared)
            known = _seen_by(basis, basis.precision(), shared, noise**2 * shared.variances)
            return known, np.asarray(np.linalg.inv(known.covariance), dtype=np.float64)
        if a is None or b is None:
            precision = self.basis.scaled_by(math.sqrt(2)).precision()
            covariance = np.asarray(np.linalg.inv(precision), dtype=np.float64)
            return FieldEstimate(self.basis, np.zeros(self.basis.size), covariance), precision
        covariance = a.covariance + b.covariance
        return FieldEstimate(self.basis, b.mean - a.mean, covariance), np.asarray(np.linalg.inv(covariance), dtype=np.float64)

    def errors_for_all(self) -> tuple[FieldEstimate | None, ...]:
        """``errors``, each for what it adds to those of the other epochs: once they are put together, coordinates that several epochs
        share count once."""
        found = list(self.errors)
        known = [(k, own) for k, own in enumerate(self.targets) if own is not None]
        for k, own in known:
            more = np.zeros(len(own.ids))
            for number, other in known:
                if number != k:
                    more[numbers_of_shared(own, other)[0]] += 1
            if more.any():
                variances = self.noise_factor**2 * own.variances + more[:, None] * own.surveyed_variances
                found[k] = _seen_by(self.basis, self.basis.precision(), own, variances)
        return tuple(found)

    def controlled(self, first: int, second: int) -> bool:
        """Whether targets tell the frames of both epochs."""
        return self.errors[first] is not None and self.errors[second] is not None


@dataclass(frozen=True, eq=False, kw_only=True)
class PairShifts:
    """Displacements of units between two epochs, from which a bend is learned: (n, 3) places and vectors, (n, 3, 3) covariances."""

    places: FloatArray
    vectors: FloatArray
    covariances: FloatArray


def estimate_frames(
    pairs: Sequence[PairShifts], targets: Sequence[TargetShifts | None], places: FloatArray, height: float, choice: FrameChoice
) -> EpochFrames | None:
    """Model of the bend and the frames of all epochs; None where rigid frames explain what is seen.

    Parameters
    ----------
    pairs
        Units between epochs that follow each other.
    targets
        By epoch.
    places
        (n, 3) of all units, over which the field is wanted.
    height
        H in metres.
    choice
        ``auto`` asks for clear evidence of a bend, ``elastic`` for any, ``rigid`` never bends.
    """
    if choice == "rigid" or not len(places):
        return None
    least_gain = GAIN if choice == "auto" else 0.0
    bendings = tuple(_bending_between(pair, targets[k : k + 2], height, least_gain) for k, pair in enumerate(pairs))
    model, gain = _model(bendings, targets, height, least_gain)
    if model is None:
        return None
    known = [t.positions for t in targets if t is not None]
    basis = FieldBasis.over(model, np.vstack([places, *known]), RESOLUTION_HEIGHTS * height)
    bend, noise = _target_factors(model, [t for t in targets if t is not None])
    changes = _changes_unlike_the_ground(pairs, targets, bendings, model, noise, height)
    basis = basis.scaled_by(bend)
    precision = basis.precision()
    degrees = max(float(np.ptp(model.scaled(places)[:, 0])), FEWEST_DEGREES)
    errors: list[FieldEstimate | None] = []
    verdicts: list[TargetVerdicts | None] = []
    chosen: list[TargetShifts | None] = []
    for own, change in zip(targets, changes, strict=True):
        if own is None or len(own.ids) < MIN_TARGETS:
            errors.append(None)
            verdicts.append(None)
            chosen.append(None)
            continue
        used = exclude_by_turns(partial(_p_values, basis.model, own, noise, change), np.ones(len(own.ids), dtype=bool), SNOOPING_LEVEL)
        chosen.append(own.chosen(used))
        seen = _seen_by(basis, precision, own.chosen(used), noise**2 * own.variances[used])
        errors.append(seen)
        verdicts.append(_verdicts(basis.model, own, noise, change, used, seen))
    return EpochFrames(
        model=basis.model,
        gain=gain,
        basis=basis,
        errors=tuple(errors),
        verdicts=tuple(verdicts),
        targets=tuple(chosen),
        noise_factor=noise,
        bendings=bendings,
        degrees=degrees,
    )


def _seen_by(basis: FieldBasis, precision: FloatArray, own: TargetShifts, variances: FloatArray) -> FieldEstimate:
    """A frame as targets see it whose residuals have (k, 3) ``variances``; ``precision`` of what is known before."""
    weights = np.stack([np.diag(1 / v) for v in variances])
    return _with_mean_of_strips(FieldEstimate.from_observations(basis, precision, own.positions, own.residuals, weights), own)


def _with_mean_of_strips(seen: FieldEstimate, own: TargetShifts) -> FieldEstimate:
    """A frame as targets see it and what they do not see: the mean of strips, a shift and, where they drift, smooth as bends are."""
    covariance = seen.covariance.copy()
    covariance[[0, 1, 2], [0, 1, 2]] += own.offset_variance
    if own.drift_variances.any():
        nodes = seen.basis.nodes
        alike = seen.basis.model.correlation(nodes, nodes)
        for axis, variance in enumerate(own.drift_variances):
            part = slice(RIGID + axis, None, 3)
            covariance[part, part] += variance * alike
    return replace(seen, covariance=covariance)


def _resting_cells(pair: PairShifts, bending: Bending, height: float) -> tuple[ShiftSample, IntArray]:
    """Shifts by cells of ground, and the numbers of those that a smooth bend explains, outside stretches that moved as one."""
    cells = in_cells(pair.places[:, :2], pair.vectors, np.einsum("kii->ki", pair.covariances), CELL_HEIGHTS * height)
    if bending.model is None:
        return cells, np.zeros(0, dtype=np.int64)
    resting = explained(cells, bending.model, bending.line)
    return cells, resting[~bending.jumped(cells.places[resting])]


def _changes_unlike_the_ground(
    pairs: Sequence[PairShifts],
    targets: Sequence[TargetShifts | None],
    bendings: Sequence[Bending | None],
    model: FieldModel,
    noise: float,
    height: float,
) -> list[FloatArray]:
    """By epoch, (k,) p-values of the changes of its targets from or to its neighbours in time, 1 where nothing says so.

    A change is laid to the epoch in which the other targets contradict the target more.
    """
    found = [np.ones(0 if own is None else len(own.ids)) for own in targets]
    for number, (pair, bending) in enumerate(zip(pairs, bendings, strict=True)):
        first, second = targets[number : number + 2]
        if first is None or second is None or bending is None:
            continue
        cells, resting = _resting_cells(pair, bending, height)
        common = _common_targets(first, second)
        if len(resting) < FEWEST_CELLS or len(common.values) < MIN_TARGETS:
            continue
        places = np.column_stack([cells.places[resting], np.full(len(resting), float(np.mean(pair.places[:, 2])))])
        weights = np.stack([np.diag(1 / v) for v in cells.variances[resting]])
        # on nodes of its own: the centre of a cell may lie where no unit and so no node of the frames is
        between = FieldBasis.over(model.times(math.sqrt(2)), np.vstack([places, first.positions]), RESOLUTION_HEIGHTS * height)
        ground = FieldEstimate.from_observations(between, between.precision(), places, cells.values[resting], weights)
        a, b = numbers_of_common(first, second)
        p_values = p_values_of_changes(
            common.values,
            first.variances[a] + second.variances[b],
            ground.at(first.positions[a]),
            bending.line.locate(first.positions[a])[0],
            STATION_HEIGHTS * height,
        )
        alone = [_outlier_p_values(model, own, noise, np.ones(len(own.ids), dtype=bool))[1] for own in (first, second)]
        later = alone[1][b] < alone[0][a]
        for epoch, numbers, blamed in ((number, a, ~later), (number + 1, b, later)):
            found[epoch][numbers[blamed]] = np.minimum(found[epoch][numbers[blamed]], p_values[blamed])
    return found


def _bending_between(pair: PairShifts, targets: Sequence[TargetShifts | None], height: float, least_gain: float) -> Bending | None:
    """Bend between two epochs, from cells of units and from targets that both measured; None for too few units."""
    if len(pair.places) < FEWEST_CELLS:
        return None
    variances = np.einsum("kii->ki", pair.covariances)
    sample = in_cells(pair.places[:, :2], pair.vectors, variances, CELL_HEIGHTS * height)
    first, second = targets
    if first is not None and second is not None:
        sample = sample.joined(_common_targets(first, second))
    return estimate_bending(sample, height, least_gain)


def _common_targets(first: TargetShifts, second: TargetShifts) -> ShiftSample:
    """Targets of two epochs as observations of the difference of their frames."""
    a, b = numbers_of_common(first, second)
    values = second.residuals[b] - first.residuals[a]
    return ShiftSample(
        places=first.positions[a][:, :2],
        values=values,
        variances=TARGET_CAUTION**2 * (first.variances[a] + second.variances[b]),
        fixed=np.ones(len(a), dtype=bool),
    )


def _model(
    bendings: Sequence[Bending | None], targets: Sequence[TargetShifts | None], height: float, least_gain: float
) -> tuple[FieldModel | None, float]:
    """Bend of one epoch from the clearest pair, or from targets alone where no pair has enough units."""
    best, gain = None, 0.0
    for bending in bendings:
        if bending is not None and bending.model is not None and bending.gain > gain:
            # the difference of two epochs varies twice as much as each
            best, gain = bending.model.times(math.sqrt(0.5)), bending.gain
    if best is not None or any(bending is not None for bending in bendings):
        return best, gain
    for own in targets:
        if own is not None and len(own.ids) >= FEWEST_BENT_TARGETS:
            model, found = _bend_of_targets(own, height, least_gain)
            if model is not None and found > gain:
                best, gain = model, found
    return best, gain


def _bend_of_targets(own: TargetShifts, height: float, least_gain: float) -> tuple[FieldModel | None, float]:
    """Bend that the targets of one epoch show, and its gain over a rigid frame with targets as badly measured as that needs."""
    stiff, bent = -math.inf, -math.inf
    model = None
    for noise in NOISE_FACTORS:
        sample = ShiftSample(
            places=own.positions[:, :2],
            values=own.residuals,
            variances=noise**2 * own.variances,
            fixed=np.ones(len(own.ids), dtype=bool),
        )
        rigid = rigid_log_likelihood(sample)
        found = estimate_bending(sample, height, 0.0)
        stiff = max(stiff, rigid)
        if found.model is not None and rigid + found.gain > bent:
            bent, model = rigid + found.gain, found.model
    return (model, bent - stiff) if bent - stiff > least_gain else (None, bent - stiff)


def _covariance(model: FieldModel, own: TargetShifts, noise: float) -> FloatArray:
    """(3 k, 3 k) covariance of the residuals of k targets: rigid motion left free, bend, and their own errors."""
    scaled = model.scaled(own.positions)
    bend = np.kron(model.correlation(scaled, scaled), np.diag(np.square(model.sds)))
    arm = own.positions - own.positions.mean(axis=0)
    rigid = rigid_jacobian(arm)[:, :, :RIGID].reshape(-1, RIGID) * np.repeat([FREE_SHIFT, FREE_TURN], 3)
    return np.asarray(bend + rigid @ rigid.T + np.diag(noise**2 * own.variances.ravel()))


def _target_factors(model: FieldModel, targets: Sequence[TargetShifts]) -> tuple[float, float]:
    """Factors of the bend and of the stated deviations under which targets are likeliest, disturbed ones weighing less."""
    rest = [t for t in targets if len(t.ids) >= MIN_TARGETS + 1]
    if not rest:
        return 1.0, 1.0
    losses = {
        # without evidence things are as they are stated
        (bend, noise): sum(_loss(model.times(bend), own, noise) for own in rest) + _unlike_stated(bend, 2) + _unlike_stated(noise, 4)
        for bend in BEND_FACTORS
        for noise in NOISE_FACTORS
    }
    return min(losses, key=losses.__getitem__)


def _likeliest_noise(model: FieldModel, own: TargetShifts) -> float:
    """Factor of the stated deviations under which the targets of one frame are likeliest."""
    losses = {noise: _loss(model, own, noise) + _unlike_stated(noise, 4) for noise in NOISE_FACTORS}
    return min(losses, key=losses.__getitem__)


def _unlike_stated(factor: float, usual: float) -> float:
    """Negative log-density, beforehand, of what is stated being off by a ``factor``, as it is by a ``usual`` one and its inverse."""
    return 0.5 * (math.log(factor) / math.log(usual)) ** 2


def _loss(model: FieldModel, own: TargetShifts, noise: float) -> float:
    """Negative log-likelihood of targets whose stated deviations are off by a factor."""
    statistics, log_determinants = _innovations(model, own, noise)
    # with the tails of t of five degrees of freedom, so that disturbed ones do not decide, its scale that of normal errors
    return float(np.sum(4.0 * np.log1p(T5_SCALE * statistics / 5.0) + 0.5 * log_determinants))


def _innovations(model: FieldModel, own: TargetShifts, noise: float) -> tuple[FloatArray, FloatArray]:
    """Quadratic form and log determinant (k,) of each target given those before it along the structure: together their likelihood.

    Each given all others would be a pseudo-likelihood, and a wrong one here: the neighbours of its station say where a target is, whatever
    the bend from station to station.
    """
    order = np.argsort(model.scaled(own.positions)[:, 0])
    sorted_own = replace(own, positions=own.positions[order], variances=own.variances[order])
    factor = np.linalg.cholesky(_covariance(model, sorted_own, noise))
    white = solve_triangular(factor, own.residuals[order].ravel(), lower=True)
    return np.sum(white.reshape(-1, 3) ** 2, axis=1), 2 * np.sum(np.log(np.diag(factor)).reshape(-1, 3), axis=1)


def _predicted(covariance: FloatArray, residuals: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Each target less the prediction by all others (k, 3), its covariance (k, 3, 3), quadratic form and log determinant (k,)."""
    inverse = np.linalg.inv(covariance)
    solved = (inverse @ residuals.ravel()).reshape(-1, 3)
    blocks = np.stack([inverse[3 * k : 3 * k + 3, 3 * k : 3 * k + 3] for k in range(len(residuals))])
    spread = np.linalg.inv(blocks)
    away = np.einsum("kij,kj->ki", spread, solved)
    return away, spread, np.einsum("ki,ki->k", away, solved), np.linalg.slogdet(spread)[1]


def _p_values(model: FieldModel, own: TargetShifts, noise: float, change: FloatArray, used: BoolArray) -> FloatArray:
    """(k,) p-values by the other targets of the epoch or by the ground, whichever is less, the level shared among both."""
    return np.asarray(np.minimum(2 * np.minimum(_outlier_p_values(model, own, noise, used)[1], change), 1.0))


def _outlier_p_values(model: FieldModel, own: TargetShifts, noise: float, used: BoolArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Each target less what the other used ones predict (k, 3), p-values (k,) and the covariance of the difference (k, 3, 3)."""
    covariance = _covariance(model, own, noise)
    away, spread = np.zeros((len(used), 3)), np.zeros((len(used), 3, 3))
    inside = np.repeat(used, 3)
    gap, block, statistics, _ = _predicted(covariance[np.ix_(inside, inside)], own.residuals[used])
    away[used], spread[used] = gap, block
    form = np.zeros(len(used))
    form[used] = statistics
    outside = np.flatnonzero(~used)
    if len(outside):
        gain = np.linalg.solve(covariance[np.ix_(inside, inside)], covariance[inside][:, np.repeat(~used, 3)]).T
        away[outside] = own.residuals[outside] - (gain @ own.residuals[used].ravel()).reshape(-1, 3)
        left = covariance[np.ix_(np.repeat(~used, 3), np.repeat(~used, 3))] - gain @ covariance[inside][:, np.repeat(~used, 3)]
        for k, target in enumerate(outside):
            spread[target] = left[3 * k : 3 * k + 3, 3 * k : 3 * k + 3]
            form[target] = away[target] @ np.linalg.solve(spread[target], away[target])
    degrees = max(3 * int(used.sum()) - 6, 3)
    # the noise was chosen by all targets; a median misfit above it is noise that the factors do not hold
    size = max(float(np.median(form[used])) / CHI2_3_MEDIAN, 1.0)
    return away, np.asarray(fdtrc(3, degrees, form / 3 / size)), spread * size


def _verdicts(
    model: FieldModel, own: TargetShifts, noise: float, change: FloatArray, used: BoolArray, seen: FieldEstimate
) -> TargetVerdicts:
    away, _, spread = _outlier_p_values(model, own, noise, used)
    p_values = _p_values(model, own, noise, change, used)
    w_max = np.max(np.abs(away) / np.sqrt(np.einsum("kii->ki", spread)), axis=1)
    left = own.residuals - seen.at(own.positions).means[:, :3]
    return TargetVerdicts(residuals=np.where(used[:, None], left, away), w_max=w_max, p_values=p_values, used=used)
