"""Gauss-Helmert adjustment of four co-centred cones to the points of one unit (paper 2.3, eqs. 8-9).

The condition per point is f = x^2 + y^2 - (r - c z)^2 = 0 in the frame of its leg, or z = leg length on an end disc
(:mod:`.cone_conditions`). It is linearised at the *adjusted* observations until parameters and adjusted observations stand still
(Foerstner and Wrobel, 2016, Photogrammetric Computer Vision, 4.8; Lenzmann and Lenzmann, 2004, on why the one-step form is wrong).
Divided by the length of its gradient B, the misclosure there is the signed distance to the surface along the direction in which the
noise acts.

Three things go beyond the textbook form, each to keep the estimate unbiased or its covariance honest:

- the second-order bias of distances to a curved surface is removed (Kanatani et al., 2016, Ellipse Fitting for Computer
  Vision, ch. 8): the component of the noise across the leg's generator lifts a point by half its variance times the curvature;
- a point near a crease belongs to both legs with the probabilities of a uniformly sampled surface under the noise. Weights
  that depend on the foot of the perpendicular only are independent of the residual, so the estimating equations keep mean zero;
- the covariance is the sandwich of an M-estimator (Huber, 1967), with the correlation between residuals of neighbouring points
  taken from the residuals themselves (:mod:`.residual_correlation`).
"""

from __future__ import annotations

import math
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from ..common.arrays import BoolArray, FloatArray
from ..common.errors import InputError, NoSolutionError
from ..model.pose import Pose
from ..model.unit_types import UnitType
from .adjustment_records import MIN_POINTS, Adjustment, AdjustmentOptions
from .adjustment_state import Linearisation, Problem, UnitState
from .condition_records import NormalEquations, PointStates, Weighting, Work
from .cone_conditions import linearise_points
from .gauss_newton_step import Step, make_step
from .parameter_covariance import parameter_covariance
from .redundancy import FEW_POINTS, flags, legs_visible, redundancy
from .residual_scale import SCALE_CONSISTENCY, SCALE_CONTRACTION, quantile_scale, share_within
from .residual_weights import NO_WEIGHT
from .visible_parts import discs_shown, legs_shown

ARRANGED: tuple[Literal["C"], Literal["A"], Literal["E"]] = ("C", "A", "E")
"""How compiled loops take arrays, in C order, aligned, plain ones: they do not check it."""
APPROACH_SAMPLE = 250
"""Points with which the adjustment comes near before it uses all."""


def adjust(
    points: ArrayLike,
    unit: UnitType,
    pose: Pose,
    *,
    options: AdjustmentOptions | None = None,
    covariances: ArrayLike | None = None,
    legs: ArrayLike | None = None,
) -> Adjustment:
    """Adjust pose, radius and gradient of one unit to its points.

    Parameters
    ----------
    points
        (n, 3) metres in a reduced frame (coordinates of some kilometres at most).
    unit
        Nominal geometry; its radius and gradient are the starting values and priors.
    pose
        Approximate pose, in the same frame.
    options
        See :class:`AdjustmentOptions`.
    covariances
        (n, 3, 3) covariance of each point, square metres; None for equal isotropic noise. See :func:`.trajectory.beam_covariances`.
    legs
        (n,) known leg 0..3 of each point, -1 to leave it out; None lets the adjustment find it.

    Raises
    ------
    InputError
        Points that are not finite, or covariances that are not positive definite.
    NoSolutionError
        Fewer points near the unit than parameters.
    """
    options = options or AdjustmentOptions()
    xyz = np.require(points, np.float64, ARRANGED)
    if xyz.ndim != 2 or xyz.shape[1] != 3:
        raise ValueError(f"points must be (n, 3), got {xyz.shape}")
    if not np.isfinite(xyz).all():
        raise InputError("points of a unit are not finite", remedy="remove points without coordinates")
    n = len(xyz)
    cov = np.zeros((0, 3, 3)) if covariances is None else np.require(covariances, np.float64, ARRANGED)
    if covariances is not None and cov.shape != (n, 3, 3):
        raise ValueError(f"covariances must be ({n}, 3, 3), got {cov.shape}")
    unusable = n - np.count_nonzero(_positive_definite(cov)) if len(cov) else 0
    if unusable:
        raise InputError(
            f"the covariances of {unusable} of {n} points are not finite and positive definite",
            remedy="give each point a covariance in square metres with noise in all three directions, and leave out points without a GPS "
            "time or sensor position",
        )
    given = np.zeros(0, dtype=np.int64) if legs is None else np.require(legs, np.int64, ARRANGED)
    if legs is not None and (given.shape != (n,) or given.max(initial=0) > 3):
        raise ValueError(f"legs must be ({n},) numbers 0..3, or -1")
    kept = np.arange(n) if legs is None else np.flatnonzero(given >= 0)
    if len(kept) < MIN_POINTS:
        raise NoSolutionError(f"{len(kept)} points are too few to adjust a unit", remedy=f"give at least {MIN_POINTS} points of one unit")
    problem = Problem.of(xyz, unit, options, cov=cov, given=given)
    start = UnitState.start(unit, pose, options)
    if len(kept) <= 2 * APPROACH_SAMPLE:
        solver = Solver(problem, start)
        return solver.solve(solver.approach())
    rough = Solver(problem.sampled(kept[:: len(kept) // APPROACH_SAMPLE]), start)
    scale = rough.approach()
    return rough.of_all(problem).solve(scale)


def _positive_definite(cov: FloatArray) -> BoolArray:
    """(n,) which of (n, 3, 3) symmetric matrices are finite and positive definite beyond rounding, by their leading minors."""
    finite = np.isfinite(cov).all(axis=(1, 2))
    a, b, c, d, e, f = (np.where(finite, cov[:, i, j], 0.0) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))
    least = 1e-14 * (a + b + c)
    second = a * b - d * d
    third = c * second - a * f * f - b * e * e + 2 * d * e * f
    return np.asarray((least > 0) & (a > least) & (second > least * a) & (third > least * second))


class Solver:
    """One adjustment under way: the state that its steps change, and the work arrays that they share.

    Attributes
    ----------
    problem
        What is adjusted to what.
    state
        Where the unit is now.
    points
        What the latest linearisation made of each point.
    """

    def __init__(self, problem: Problem, start: UnitState) -> None:
        self._take(problem, start)
        self._equations = NormalEquations.empty()
        self._work = Work.of_thread()

    def of_all(self, problem: Problem) -> Solver:
        """Go on from a sample with all points; arrays are made once, which is a fiftieth of the time of small units."""
        self._take(problem, self.state)
        return self

    def _take(self, problem: Problem, start: UnitState) -> None:
        self.problem, self.state = problem, start.copy()
        self.points = PointStates.empty(len(problem.points))
        self._terms_of(self.state)

    def _terms_of(self, state: UnitState) -> None:
        """What follows from a state and stays while its arrays change in place."""
        self._described = state
        self._solid = self.problem.solid(state)
        self._free, self._free_pose = (self.problem.free(state, hold_shape=hold) for hold in (False, True))

    def solve(self, scale: float) -> Adjustment:
        """Iterate from an approximate state and scale to the end."""
        options = self.problem.options
        discs_sought = options.end_discs != "auto"
        converged = final = False
        iteration = 0
        gain = math.inf
        while iteration < options.max_iterations:
            iteration += 1
            # once the way is short, every linearisation may be the last
            final = gain < 100.0
            now = self.linearise(scale, redescend=options.robust, final=final)
            before = gain
            gain, change = self.step(now)
            if now.points.weights.sum() < MIN_POINTS or not math.isfinite(gain):
                raise NoSolutionError(
                    "too few points lie near the unit's surface to adjust it", remedy="check the approximate pose and the unit's height"
                )
            # the step takes its gain away from the sum of squares
            scale = self.refined_scale(now, max(now.sums.squares - gain, 0.5 * now.sums.squares))
            settled = abs(scale - now.scale) < 2e-3 * now.scale
            if options.robust and options.sigma is None:
                scale += SCALE_CONTRACTION / (1 - SCALE_CONTRACTION) * (scale - now.scale)
            if not discs_sought and gain < 0.25:
                discs_sought = True
                if self.find_discs(scale):
                    gain = math.inf
                    continue
            # steps shorten at a rate, so that the next one is known; a first step tells of none and must be short itself
            expected = gain * min(gain / before, 1.0) if math.isfinite(before) else gain
            if gain < 0.25 and expected < 2.5e-3 and settled:
                if self.close_legs(scale):
                    gain = math.inf
                    continue
                converged = True
                break
        if converged and final:
            # so small a step moves the residuals by the rows and leaves the rest as it is
            now.points.residuals[:] += now.points.rows @ change * now.scale * now.points.sds
        else:
            now = self.linearise(scale, redescend=options.robust, final=True)
        return self.result(now, converged=converged, iterations=iteration)

    def approach(self) -> float:
        """Come near from an approximate pose; returns the scale of the residuals.

        A wide window for the robust weights finds the way from afar, a narrow one does not follow other surfaces nearby. Narrower
        ones are tried only if the residuals do not look like noise, and the best pose is kept.
        """
        start = self.state
        least, nearest, scale, noise_alone = math.inf, start, math.inf, False
        for window in (1.0, 0.4, 0.15) if self.problem.options.robust else (1.0,):
            self.state = start.copy()
            found = self.approach_through(window)
            # most points close, and those that belong very close
            misfit = self.quantile_scale(0.6) + found
            like_noise = self.looks_like_noise(found)
            if misfit < least:
                least, nearest, scale, noise_alone = misfit, self.state, found, like_noise
            if like_noise:
                break
        self.state = nearest
        if noise_alone:
            return scale
        # from below: bad points just outside the window must not find it open
        return max(0.85 * scale, self.problem.options.sigma or self.problem.floor)

    def approach_through(self, window: float) -> float:
        """One approach: pose alone until it settles, then all parameters with the window narrowed below the noise and widened again.

        Bad points in one place (a neighbour, growth) pull a fit until they look like noise; the narrow window lets go of them. This
        is kept if more of all points then lie closer.
        """
        options, floor = self.problem.options, self.problem.floor
        self.linearise(0.02 * self.problem.unit.height / self.problem.mean_sd, redescend=False)
        for _ in range(30):
            now = self.linearise(window * self.quantile_scale(0.35), redescend=options.robust)
            if self.step(now, hold_shape=True).gain < 0.1:
                break
        scale = self.quantile_scale(0.35)
        if not options.robust:
            return scale
        closeness, wide = self.quantile_scale(0.6), self.state.copy()
        if self.looks_like_noise(scale) and closeness < 1.15 * scale:
            return scale
        tight = window * scale
        while tight > max(options.sigma or 0.0, floor) and self.share_within(tight) > 0.5:
            tight *= 0.5
            self.step(self.linearise(tight, redescend=True))
        for _ in range(20):
            now = self.linearise(tight, redescend=True)
            self.step(now)
            tight = self.refined_scale(now, now.sums.squares)
            if abs(tight - now.scale) < 0.1 * tight:
                break
        self.linearise(tight, redescend=True)
        if self.quantile_scale(0.6) + tight < closeness + scale:
            return tight
        self.state = wide
        self.linearise(scale, redescend=True)
        return scale

    def linearise(self, scale: float, *, redescend: bool, final: bool = False) -> Linearisation:
        """Normal equations and residuals at the state; ``final`` also makes what the covariance needs."""
        problem = self.problem
        correct = float(problem.options.sigma or scale) if problem.options.bias_correction else 0.0
        edge, tip, fade = problem.trimming(scale)
        weighting = Weighting(scale=scale, correct=correct, tip=tip, fade=fade, edge=edge, redescend=redescend, final=final)
        if self._described is not self.state:
            self._terms_of(self.state)
        else:
            np.add(problem.prior.leg_length, self.state.leg_errors, out=self._solid.leg_lengths)
        sums = linearise_points(
            problem.columns, problem.cov, problem.given, self._solid, weighting, self._equations, self.points, self._work
        )
        return Linearisation(scale=scale, equations=self._equations, points=self.points, sums=sums)

    def step(self, now: Linearisation, *, hold_shape: bool = False) -> Step:
        """Make one Gauss-Newton step."""
        return make_step(now.equations, self._free_pose if hold_shape else self._free, self.problem.prior, self.state)

    def looks_like_noise(self, scale: float) -> bool:
        """Whether nearly all residuals are small beside the unit, and none far beyond their scale."""
        owned = self.points.legs >= 0
        small = bool(owned.any()) and scale * float(self.points.sds[owned].mean()) < 0.01 * self.problem.unit.height
        return small and self.share_within(scale) > 0.95

    def share_within(self, scale: float) -> float:
        """Share of the points inside the window of the robust weights; points in the tips, which fit nothing, do not count."""
        return share_within(self.points, self.problem.given, NO_WEIGHT * scale)

    def quantile_scale(self, share: float) -> float:
        """Scale of the residuals of all points, from the quantile of their sizes at ``share``."""
        scale = quantile_scale(self.points, self.problem.given, share)
        # a known noise still needs a wide start while the pose is rough
        return min(max(scale, self.problem.options.sigma or self.problem.floor), 1e6 * self.problem.unit.height)

    def refined_scale(self, now: Linearisation, squares: float) -> float:
        """Scale after a linearisation: the known one, or :meth:`scale_of` above the smallest that makes sense."""
        if self.problem.options.sigma is not None:
            return self.problem.options.sigma
        return max(self.scale_of(now, squares), self.problem.floor)

    def scale_of(self, now: Linearisation, squares: float) -> float:
        """Scale of the residuals from their squares, standardised by that of ``now``, over what the weights exceed the unknowns by.

        The unknowns take their share of the residuals with or without robust weights. Left out of account among few points, the scale
        comes out too small, the weights then drop good points, and so on: of 40 points seven were left that fitted exactly.
        """
        consistency = SCALE_CONSISTENCY if self.problem.options.robust else 1.0
        unknowns = np.count_nonzero(self._free)
        return now.scale * math.sqrt(squares / max(now.sums.weights - unknowns, 1.0) / consistency)

    def find_discs(self, scale: float) -> bool:
        """Use the end discs that the points show. Tells of any."""
        self.state = self.state._replace(discs=discs_shown(self.problem, self.state, self.points, scale, self._equations))
        return bool(self.state.discs.any())

    def close_legs(self, scale: float) -> bool:
        """Shut legs that own no points beyond doubt. Tells of any."""
        keep = legs_shown(self.problem, self.state, self.points, scale)
        if (keep == self.state.opened).all():
            return False
        self.state = self.state._replace(opened=keep, discs=self.state.discs & keep)
        return True

    def result(self, now: Linearisation, *, converged: bool, iterations: int) -> Adjustment:
        """The adjustment after its final linearisation."""
        state, points, options = self.state, now.points, self.problem.options
        known = parameter_covariance(now, self.problem, state)
        control = redundancy(now, known.whitened)
        used = points.weights > 0
        count = float(np.count_nonzero(used))
        noise = now.scale if options.sigma is None else self.scale_of(now, now.sums.squares)
        a_priori = options.sigma or (1.0 if len(self.problem.cov) else noise)
        mean_sd = math.sqrt(control.square_sd / count) if count else math.nan
        visible = legs_visible(control.owned, count)
        return Adjustment(
            pose=Pose(state.centre, state.rotation),
            radius=float(state.shape[0]),
            gradient=float(state.shape[1]),
            covariance=known.covariance,
            sigma0=noise / a_priori,
            noise=noise * mean_sd,
            redundancy=control.weight - control.influence,
            redundancy_numbers=control.numbers,
            minimal_detectable_bias=control.detectable,
            weights=points.weights.copy(),
            legs=np.where(used, points.legs, -1),
            parts=points.parts.copy(),
            residuals=points.residuals.copy(),
            n_effective=control.weight / known.inflation,
            converged=converged,
            iterations=iterations,
            undetermined=known.undetermined,
            legs_visible=visible,
            flags=flags(visible, len(known.undetermined), discs_only=count > 0 and not control.owned.any(), few_points=count < FEW_POINTS),
        )
