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
from copy import copy
from dataclasses import dataclass
from functools import lru_cache
from statistics import NormalDist
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .cone_conditions import FULL_WEIGHT, NO_WEIGHT, PARAMETERS, SCALE_NARROWING, clear_counts, legs_of, linearise_points, row_excess
from .errors import InputError
from .kernels import kernel
from .pose import Pose
from .residual_correlation import correlated_part
from .tetrapod import LATERAL
from .unit_types import UnitType

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

NONCENTRALITY = 4.13
"""Square root of the noncentrality of a test of one outlier with alpha = 0.1 % and power 80 % (Baarda, 1968)."""
LOST = math.pi / math.sqrt(3)
"""Standard deviation of a parameter of which nothing is known: in radians, an angle uniform over the full turn."""
DETERMINED = 0.5
"""A direction in parameter space counts as determined if its standard deviation is below this, in radians or leg lengths."""
MIN_POINTS = 8
FEW_POINTS = 4 * len(PARAMETERS)
"""Used points below which robust weights cannot tell bad points, and the stated covariance does not hold."""
EDGE_RATIO = 0.03
"""Width of the fillet along creases and of the chamfer around end discs that is left out, as a share of the height."""
TIP_RATIO = 0.87
"""Share of the leg up to which the cone of a real leg holds; its tip is rounded."""
APPROACH_SAMPLE = 250
"""Points with which the adjustment comes near before it uses all."""


@dataclass(frozen=True)
class AdjustmentOptions:
    """How a unit is adjusted.

    Attributes
    ----------
    radius_sd, gradient_sd
        Standard deviation of the unit type's radius (metres) and gradient as prior observations: 0 holds the value
        fixed, inf leaves it free.
    sigma
        Known noise of one coordinate, metres, or known factor on given standard deviations; None estimates it.
    robust
        Redescending weights on standardised residuals.
    end_discs
        Use the planes at the ends of the legs; ``auto`` only where the points show a plane at the nominal length.
    leg_length_sd
        Standard deviation of the distance from the centre to an end disc as built, metres; None for 0.3 % of it.
    tip
        Share of the leg length up to which the cone holds on legs whose end disc is not used; 1 for all of it.
    edge
        Width in metres left out along the creases between the legs (fillet) and along the rims of used end discs (chamfer);
        None for 3 % of the height, less where the noise hides what is rounded there, and the same for ``tip``.
    bias_correction
        Remove the second-order bias of distances to a curved surface; without it the radius is too large by sigma^2 / 2r.
    max_iterations
        Limit of the Gauss-Newton iterations.
    """

    radius_sd: float = math.inf
    gradient_sd: float = math.inf
    sigma: float | None = None
    robust: bool = True
    end_discs: bool | Literal["auto"] = "auto"
    leg_length_sd: float | None = None
    tip: float = TIP_RATIO
    edge: float | None = None
    bias_correction: bool = True
    max_iterations: int = 100

    def __post_init__(self) -> None:
        if not (self.radius_sd >= 0 and self.gradient_sd >= 0):
            raise ValueError("radius_sd and gradient_sd must be 0 (fixed), positive (prior) or inf (free)")
        if self.sigma is not None and not self.sigma > 0:
            raise ValueError("sigma must be positive")
        if self.leg_length_sd is not None and not self.leg_length_sd > 0:
            raise ValueError("leg_length_sd must be positive")
        if not 0 < self.tip <= 1:
            raise ValueError("tip is a share of the leg length, above 0 and at most 1")
        if self.edge is not None and not self.edge >= 0:
            raise ValueError("edge must be 0 or a positive length")

    @classmethod
    def ideal(cls, **changes: object) -> AdjustmentOptions:
        """For surfaces that are cones everywhere and have no end discs, as in the paper's simulation: nothing is left out."""
        return cls(**({"end_discs": False, "tip": 1.0, "edge": 0.0} | changes))  # type: ignore[arg-type]


@dataclass(frozen=True, eq=False)
class Adjustment:
    """Result of :func:`adjust`. Parameter order e, n, h, omega_e, omega_n, omega_h, r, c (metres, radians).

    Attributes
    ----------
    pose, radius, gradient
        Adjusted parameters, in the frame of the points.
    covariance
        (8, 8) with zero rows for what was held fixed. A direction the points do not determine has the variance of
        knowing nothing (an angle uniform over the turn, 1.8 leg lengths) and is listed in ``undetermined``.
    sigma0
        Standard deviation of unit weight: estimated over a priori noise; 1 where no noise was given.
    noise
        Robust standard deviation of the residuals, metres.
    redundancy
        Sum of the redundancy numbers: weighted observations less parameters.
    redundancy_numbers
        (n,) share of a point's error that shows in its own residual; 0 for unused points.
    minimal_detectable_bias
        (n,) smallest error of one point, metres, found at alpha 0.1 % with power 80 %; inf for unused points.
    weights
        (n,) 0..1, robust weight times share of membership in the leg.
    legs, parts
        (n,) leg 0..3 or -1 for unused points; ``LATERAL`` or ``END_DISC``.
    residuals
        (n,) signed distance to that part, metres, positive outside; nan for points that belong to none.
    n_effective
        Number of independent points with the same information, after the correlation between residuals.
    converged, iterations
        Whether the next step is expected below 5 % of the parameters' standard deviations, and how many were made.
    undetermined
        (k, 8) unit directions in parameter space (lengths in units of the leg length) that the points do not determine.
    legs_visible
        Number of legs whose lateral surface holds at least ``MIN_POINTS`` points and 1 % of the used points.
    flags
        Short statements for the user: ``one leg: twist about its axis undetermined``, ``two legs``, ``few points`` (too few to tell bad
        ones: the covariance may be too small), ...
    """

    pose: Pose
    radius: float
    gradient: float
    covariance: FloatArray
    sigma0: float
    noise: float
    redundancy: float
    redundancy_numbers: FloatArray
    minimal_detectable_bias: FloatArray
    weights: FloatArray
    legs: IntArray
    parts: IntArray
    residuals: FloatArray
    n_effective: float
    converged: bool
    iterations: int
    undetermined: FloatArray
    legs_visible: int
    flags: tuple[str, ...]

    def unit(self, unit: UnitType) -> UnitType:
        """The unit type with the adjusted radius and gradient."""
        return unit.with_shape(self.radius, self.gradient)


def _weighted_square(scale: float) -> float:
    """Weighted mean square of a standard normal variable under the weights of the scale, with the window opened by a factor."""
    u = np.linspace(0, NO_WEIGHT * scale, 2001)
    v = np.clip((u / (scale * SCALE_NARROWING) - FULL_WEIGHT) / (NO_WEIGHT - FULL_WEIGHT), 0, 1)
    mass = (1 - v * v) ** 2 * np.exp(-0.5 * u * u)
    return float(np.sum(mass * u * u) / np.sum(mass))


_SCALE_CONSISTENCY = _weighted_square(1.0)
"""Makes the scale consistent for clean data."""
_SCALE_CONTRACTION = math.sqrt(_weighted_square(1.01) / _SCALE_CONSISTENCY) / 0.01 - 100
"""Share of its error that a scale keeps when it is refined once, for clean data."""


@kernel()
def _turned(rotation: Any, vector: Any) -> Any:
    """rotation @ exp([vector]x), by Rodrigues' formula."""
    x, y, z = vector[0], vector[1], vector[2]
    angle = math.sqrt(x * x + y * y + z * z)
    # sin(a)/a and (1 - cos a)/a^2 without loss of digits for small angles
    first = math.sin(angle) / angle if angle > 1e-6 else 1.0 - angle * angle / 6.0
    half = math.sin(0.5 * angle) / (0.5 * angle) if angle > 1e-6 else 1.0 - angle * angle / 24.0
    second = 0.5 * half * half
    cross = np.array(((0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0)))
    turn = np.eye(3) + first * cross + second * (cross @ cross)
    return rotation @ turn


@kernel()
def _step(
    normal: Any, rhs: Any, free: Any, scaling: Any, prior_weights: Any, nominal: Any, leg_length: Any, centre: Any, rotation: Any,
    shape: Any, leg_errors: Any, change: Any,
) -> Any:  # fmt: skip
    """Make one Gauss-Newton step in place, no longer than a leg's width and kept in ``change``; returns its squared length in standard
    deviations.

    The equations are damped at what counts as undetermined: that only holds still what the points do not determine, and has no effect at
    convergence. Scaled so, they are positive definite, and are solved by Cholesky's factors.
    """
    chosen = np.flatnonzero(free)
    m = len(chosen)
    factor = np.zeros((m, m))
    along, inner = np.zeros(m), np.zeros(m)
    for a in range(m):
        p = chosen[a]
        value = rhs[p]
        if 6 <= p < 8:
            value += prior_weights[p] * (nominal[p - 6] - shape[p - 6])
        elif p >= 8:
            value -= prior_weights[p] * leg_errors[p - 8]
        along[a] = scaling[p] * value
        inner[a] = along[a]
        for b in range(a + 1):
            q = chosen[b]
            total = normal[p, q] * scaling[p] * scaling[q]
            if a == b:
                total += prior_weights[p] * scaling[p] * scaling[p] + 1.0 / DETERMINED**2
            for k in range(b):
                total -= factor[a, k] * factor[b, k]
            factor[a, b] = math.sqrt(total) if a == b else total / factor[b, b]
        for k in range(a):
            inner[a] -= factor[a, k] * inner[k]
        inner[a] /= factor[a, a]
    gain = 0.0
    for a in range(m - 1, -1, -1):
        for k in range(a + 1, m):
            inner[a] -= factor[k, a] * inner[k]
        inner[a] /= factor[a, a]
        gain += along[a] * inner[a]
    change[:] = 0.0
    change[chosen] = scaling[chosen] * inner
    longest = max(
        math.sqrt(change[0] ** 2 + change[1] ** 2 + change[2] ** 2) / (0.25 * nominal[0]),
        math.sqrt(change[3] ** 2 + change[4] ** 2 + change[5] ** 2) / 0.15,
        abs(change[6]) / (0.1 * nominal[0]),
        abs(change[7]) / 0.05,
        1.0,
    )
    change /= longest
    centre += rotation @ change[:3]
    rotation[:, :] = _turned(rotation, change[3:6])
    shape += change[6:8]
    # a cone that closes before the end of its leg has no meaning
    shape[0] = max(shape[0], 0.2 * nominal[0])
    shape[1] = min(max(shape[1], 0.0), 0.95 * shape[0] / leg_length)
    leg_errors += change[8:]
    return gain


@kernel()
def _scaled(matrix: Any, chosen: Any, scaling: Any) -> Any:
    """Rows and columns of a (12, 12) matrix by number, each times its unknown's scaling."""
    n = len(chosen)
    scaled = np.zeros((n, n))
    for a in range(n):
        for b in range(n):
            scaled[a, b] = matrix[chosen[a], chosen[b]] * scaling[chosen[a]] * scaling[chosen[b]]
    return scaled


@kernel()
def _guarded(correlated: Any, noise_part: Any, free: Any, scaling: Any) -> Any:
    """The correlated part without negative directions, if sampling the pairs of a large cloud has made any that matter."""
    chosen = np.flatnonzero(free)
    values, vectors = np.linalg.eigh(_scaled(correlated, chosen, scaling))
    if values[0] >= 0.0 or values[0] >= -0.5 * np.linalg.eigvalsh(_scaled(noise_part, chosen, scaling))[0]:
        return correlated
    positive = (vectors * np.maximum(values, 0.0)) @ vectors.T
    result = np.zeros((12, 12))
    for a in range(len(chosen)):
        for b in range(len(chosen)):
            result[chosen[a], chosen[b]] = positive[a, b] / (scaling[chosen[a]] * scaling[chosen[b]])
    return result


@kernel()
def _inverse_root(matrix: Any, prior_weights: Any, free: Any, scaling: Any) -> Any:
    """(12, m) root whose square is the inverse of a (12, 12) matrix, prior weights added, in the free unknowns, over the m directions that
    are determined; and the (k, 12) unit directions, scaled, that are not."""
    chosen = np.flatnonzero(free)
    n = len(chosen)
    scaled = _scaled(matrix, chosen, scaling)
    for a in range(n):
        scaled[a, a] += prior_weights[chosen[a]] * scaling[chosen[a]] ** 2
    values, vectors = np.linalg.eigh(scaled)
    # in ascending order
    k = np.searchsorted(values, 1.0 / DETERMINED**2, side="right")
    root, undetermined = np.zeros((12, n - k)), np.zeros((k, 12))
    for a in range(n):
        for b in range(k, n):
            root[chosen[a], b - k] = scaling[chosen[a]] * vectors[a, b] / math.sqrt(values[b])
        for b in range(k):
            undetermined[b, chosen[a]] = vectors[a, b]
    return root, undetermined


@kernel()
def _sandwich(white: Any, scores: Any, correlated: Any) -> Any:
    """(8, 8) covariance of the parameters from the inverse of the scores' derivative and the outer product of the scores, and the mean
    factor by which the correlated part makes variances larger."""
    before = (white @ scores @ white)[:8, :8]
    covariance = before + (white @ correlated @ white)[:8, :8]
    ratio, seen = 0.0, 0
    for a in range(8):
        if before[a, a] > 0.0:
            ratio += max(covariance[a, a], 0.0) / before[a, a]
            seen += 1
    return covariance, ratio / seen if seen else 1.0


@kernel()
def _sizes(residuals: Any, biases: Any, sds: Any, given: Any) -> Any:
    """Sizes of the standardised residuals of all points but those left out by ``given``, inf for points that belong to no part."""
    n = len(residuals)
    sizes = np.empty(n)
    count = 0
    for i in range(n):
        if len(given) == n and given[i] < 0:
            continue
        size = abs((residuals[i] - biases[i]) / sds[i])
        sizes[count] = math.inf if math.isnan(size) else size
        count += 1
    return sizes[:count]


@kernel()
def _share_within(residuals: Any, biases: Any, sds: Any, at_tip: Any, given: Any, limit: Any) -> Any:
    """Share of points whose standardised residual is below a limit; those left out by ``given`` do not count, nor those in tips if they are
    not the most."""
    n = len(residuals)
    within = counted = kept = 0
    for i in range(n):
        if len(given) == n and given[i] < 0:
            continue
        kept += 1
        if not at_tip[i]:
            counted += 1
            within += abs(residuals[i] - biases[i]) < limit * sds[i]
    return within / max(counted, kept // 2, 1)


@kernel()
def _redundancy(whitened: Any, weights: Any, legs: Any, parts: Any, sds: Any, scale: Any, numbers: Any, detectable: Any) -> Any:
    """Redundancy number and minimal detectable bias of every used point; returns the sums of their influences and weights, the number of
    used lateral points by leg and the sum of squared standard deviations."""
    owned = np.zeros(4, dtype=np.int64)
    influences = all_weight = squares = 0.0
    for i in range(weights.shape[0]):
        if weights[i] <= 0.0:
            continue
        influence = 0.0
        for m in range(whitened.shape[1]):
            influence += whitened[i, m] * whitened[i, m]
        influence *= weights[i]
        influences += influence
        all_weight += weights[i]
        squares += sds[i] * sds[i]
        owned[legs[i]] += parts[i] == LATERAL
        numbers[i] = min(max(1.0 - influence, 0.0), 1.0)
        detectable[i] = NONCENTRALITY * scale * sds[i] / math.sqrt(numbers[i])
    return influences, all_weight, owned, squares


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
        Points that are not finite, covariances that are not positive definite, or fewer points near the unit than parameters.
    """
    options = options or AdjustmentOptions()
    xyz = np.ascontiguousarray(points, dtype=np.float64)
    if xyz.ndim != 2 or xyz.shape[1] != 3:
        raise ValueError(f"points must be (n, 3), got {xyz.shape}")
    if not np.isfinite(xyz).all():
        raise InputError("points of a unit are not finite", remedy="remove points without coordinates")
    n = len(xyz)
    cov = np.zeros((0, 3, 3)) if covariances is None else np.ascontiguousarray(covariances, dtype=np.float64)
    if covariances is not None and cov.shape != (n, 3, 3):
        raise ValueError(f"covariances must be ({n}, 3, 3), got {cov.shape}")
    unusable = n - np.count_nonzero(_positive_definite(cov)) if len(cov) else 0
    if unusable:
        raise InputError(
            f"the covariances of {unusable} of {n} points are not finite and positive definite",
            remedy="give each point a covariance in square metres with noise in all three directions, and leave out points without a GPS "
            "time or sensor position",
        )
    given = np.zeros(0, dtype=np.int64) if legs is None else np.ascontiguousarray(legs, dtype=np.int64)
    if legs is not None and (given.shape != (n,) or given.max(initial=0) > 3):
        raise ValueError(f"legs must be ({n},) numbers 0..3, or -1")
    kept = np.arange(n) if legs is None else np.flatnonzero(given >= 0)
    if len(kept) < MIN_POINTS:
        raise InputError(f"{len(kept)} points are too few to adjust a unit", remedy=f"give at least {MIN_POINTS} points of one unit")
    solver = _Solver(xyz, unit, pose, options, cov, given)
    if len(kept) <= 2 * APPROACH_SAMPLE:
        return solver.solve(solver.approach())
    rough = solver.sampled(kept[:: len(kept) // APPROACH_SAMPLE])
    scale = rough.approach()
    solver.restore(rough.state())
    return solver.solve(scale)


def _positive_definite(cov: FloatArray) -> NDArray[np.bool_]:
    """(n,) which of (n, 3, 3) symmetric matrices are finite and positive definite beyond rounding, by their leading minors."""
    finite = np.isfinite(cov).all(axis=(1, 2))
    a, b, c, d, e, f = (np.where(finite, cov[:, i, j], 0.0) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))
    least = 1e-14 * (a + b + c)
    second = a * b - d * d
    third = c * second - a * f * f - b * e * e + 2 * d * e * f
    return np.asarray((least > 0) & (a > least) & (second > least * a) & (third > least * second))


@lru_cache
def _size_at(share: float) -> float:
    """Size below which a share of standard normal variables lies."""
    return NormalDist().inv_cdf(0.5 * (1 + share))


class _Solver:
    """State of one adjustment; a class because its steps share a dozen work arrays.

    A residual is in metres, and its standard deviation is ``scale`` times the point's in ``sds``. Without covariances ``sds`` is 1 and a
    scale is in metres: the noise. With covariances ``sds`` is what they give in the direction of the residual, metres, and a scale is a
    factor on it; where metres are needed before a point's direction is known (``noise`` in the methods), it is times ``mean_sd``. Points of
    no part keep 1 in ``sds``.
    """

    def __init__(self, xyz: FloatArray, unit: UnitType, pose: Pose, options: AdjustmentOptions, cov: FloatArray, given: IntArray) -> None:
        self.unit, self.options = unit, options
        self.take(xyz, cov, given)
        self.centre, self.rotation = np.array(pose.centre), np.array(pose.rotation, dtype=np.float64, order="C")
        self.nominal = np.array([unit.radius, unit.gradient])
        self.shape = self.nominal.copy()
        self.leg_errors = np.zeros(4)
        self.axes, self.creases, self.spread = legs_of(unit.opening)
        self.normal, self.plain, self.shared, self.shared_scores = (np.zeros((12, 12)) for _ in range(4))
        self.rhs, self.change = np.zeros(12), np.zeros(12)
        self.opened = np.ones(4, dtype=np.bool_)
        self.discs = np.full(4, options.end_discs is True)
        self.edge = EDGE_RATIO * unit.height if options.edge is None else options.edge
        self.tip = options.tip * unit.leg_length if options.tip < 1 else math.inf
        self.mean_sd = math.sqrt(float(np.mean(np.trace(cov, axis1=1, axis2=2))) / 3) if len(cov) else 1.0
        self.scaling = np.array([unit.leg_length] * 3 + [1.0] * 3 + [unit.leg_length, 1.0] + [unit.leg_length] * 4)
        length_sd = 0.003 * unit.leg_length if options.leg_length_sd is None else options.leg_length_sd
        self.prior_sd = np.array([math.inf] * 6 + [options.radius_sd, options.gradient_sd] + [length_sd] * 4)
        with np.errstate(divide="ignore"):
            self.prior_weights = np.where((self.prior_sd > 0) & np.isfinite(self.prior_sd), 1 / self.prior_sd**2, 0.0)
        self.floor = 1e-7 * unit.height if not len(cov) else 1e-7

    def take(self, xyz: FloatArray, cov: FloatArray, given: IntArray) -> None:
        """Points to adjust to, and new work arrays for them: (n, 3), (n, 3, 3) or none, (n,) or none."""
        n = len(xyz)
        self.xyz, self.cov, self.given = xyz, cov, given
        self.columns = np.ascontiguousarray(xyz.T)
        self.legs, self.parts = np.zeros(n, dtype=np.int64), np.zeros(n, dtype=np.int64)
        self.residuals, self.sds, self.biases, self.weights = np.zeros(n), np.ones(n), np.zeros(n), np.zeros(n)
        self.at_tip = np.zeros(n, dtype=np.bool_)
        self.rows, self.feet = np.zeros((n, 12)), np.zeros((n, 3))

    def sampled(self, some: IntArray) -> _Solver:
        """A solver of some of the points that leaves this one's pose, legs and discs alone; the normal equations are shared."""
        sample = copy(self)
        sample.take(self.xyz[some], self.cov[some] if len(self.cov) else self.cov, self.given[some] if len(self.given) else self.given)
        sample.restore(self.state())
        sample.opened, sample.discs = self.opened.copy(), self.discs.copy()
        return sample

    def solve(self, scale: float) -> Adjustment:
        options = self.options
        discs_sought = options.end_discs != "auto"
        converged = False
        iteration = 0
        gain = math.inf
        while iteration < options.max_iterations:
            iteration += 1
            # once the way is short, every linearisation may be the last
            final = gain < 100.0
            sums = self.linearise(scale, redescend=options.robust, final=final)
            before, gain = gain, self.step()
            if self.weights.sum() < MIN_POINTS or not math.isfinite(gain):
                raise InputError(
                    "too few points lie near the unit's surface to adjust it", remedy="check the approximate pose and the unit's height"
                )
            # the step takes its gain away from the sum of squares
            previous, scale = scale, self.refined_scale(scale, max(sums[0] - gain, 0.5 * sums[0]), sums[1])
            settled = abs(scale - previous) < 2e-3 * previous
            if options.robust and options.sigma is None:
                scale += _SCALE_CONTRACTION / (1 - _SCALE_CONTRACTION) * (scale - previous)
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
            self.residuals += self.rows @ self.change * previous * self.sds
            return self.result(previous, sums, converged, iteration)
        sums = self.linearise(scale, redescend=options.robust, final=True)
        return self.result(scale, sums, converged, iteration)

    def approach(self) -> float:
        """Come near from an approximate pose; returns the scale of the residuals.

        A wide window for the robust weights finds the way from afar, a narrow one does not follow other surfaces nearby. Narrower
        ones are tried only if the residuals do not look like noise, and the best pose is kept.
        """
        start = self.state()
        best: tuple[float, float, bool, tuple[FloatArray, ...]] = (math.inf, math.inf, False, start)
        for window in (1.0, 0.4, 0.15) if self.options.robust else (1.0,):
            self.restore(start)
            scale = self.approach_through(window)
            # most points close, and those that belong very close
            misfit = self.quantile_scale(0.6) + scale
            noise_alone = self.looks_like_noise(scale)
            if misfit < best[0]:
                best = misfit, scale, noise_alone, self.state()
            if noise_alone:
                break
        _, scale, noise_alone, nearest = best
        self.restore(nearest)
        if noise_alone:
            return scale
        # from below: bad points just outside the window must not find it open
        return max(0.85 * scale, self.options.sigma or self.floor)

    def approach_through(self, window: float) -> float:
        """One approach: pose alone until it settles, then all parameters with the window narrowed below the noise and widened again.

        Bad points in one place (a neighbour, growth) pull a fit until they look like noise; the narrow window lets go of them. This
        is kept if more of all points then lie closer.
        """
        first = 0.02 * self.unit.height / self.mean_sd
        self.linearise(first, redescend=False)
        for _ in range(30):
            scale = window * self.quantile_scale(0.35)
            self.linearise(scale, redescend=self.options.robust)
            if self.step(hold_shape=True) < 0.1:
                break
        scale = self.quantile_scale(0.35)
        if not self.options.robust:
            return scale
        closeness, wide = self.quantile_scale(0.6), self.state()
        if self.looks_like_noise(scale) and closeness < 1.15 * scale:
            return scale
        tight = window * scale
        while tight > max(self.options.sigma or 0.0, self.floor) and self.share_within(tight) > 0.5:
            tight *= 0.5
            self.linearise(tight, redescend=True)
            self.step()
        for _ in range(20):
            squares, weight_sum = self.linearise(tight, redescend=True)
            self.step()
            previous, tight = tight, self.refined_scale(tight, squares, weight_sum)
            if abs(tight - previous) < 0.1 * tight:
                break
        self.linearise(tight, redescend=True)
        if self.quantile_scale(0.6) + tight < closeness + scale:
            return tight
        self.restore(wide)
        self.linearise(scale, redescend=True)
        return scale

    def state(self) -> tuple[FloatArray, ...]:
        """Copies of centre, rotation, shape and errors of the leg lengths."""
        return self.centre.copy(), self.rotation.copy(), self.shape.copy(), self.leg_errors.copy()

    def restore(self, state: tuple[FloatArray, ...]) -> None:
        """Go back to a :meth:`state`, which stays as it is; the normal equations and residuals are those of another pose then."""
        self.centre, self.rotation, self.shape, self.leg_errors = (part.copy() for part in state)

    def linearise(self, scale: float, *, redescend: bool, final: bool = False) -> tuple[float, float]:
        """Refresh the normal equations; returns the sums of squares and of weights that make the scale."""
        correct = (self.options.sigma or scale) if self.options.bias_correction else 0.0
        edge, tip, fade = self.trimming(scale)
        squares, weight_sum, self.psi_squares, self.slopes, self.singles = linearise_points(
            self.columns, self.centre, self.rotation, self.axes, self.creases, self.spread, self.shape,
            self.unit.leg_length + self.leg_errors, self.cov if len(self.cov) else None, self.given, self.opened, self.discs, scale,
            correct, tip, fade, edge, redescend, final, self.normal, self.rhs, self.plain, self.shared, self.shared_scores, self.legs,
            self.parts, self.residuals, self.sds, self.biases, self.weights, self.at_tip, self.rows, self.feet,
        )  # fmt: skip
        return squares, weight_sum

    def trimming(self, scale: float) -> tuple[float, float, float]:
        """Width left out along creases and rims, axial coordinate up to which a leg's cone is used, and over which its use fades, metres.

        Fillets, chamfers and rounded tips depart from the cones by a fraction of their width. Noise of that width hides them, and
        leaving points out then costs more than it saves: the trimming fades from a third of the width on. No cone is used beyond its
        leg, where rock that it would run into lies: points there are no further out than the noise carries them.
        """
        noise = scale * self.mean_sd
        if len(self.given) and not math.isfinite(self.tip):
            return self.edge, math.inf, noise
        share = 1.0 if self.options.edge is not None else min(max(1.5 * (1.0 - noise / self.edge), 0.0), 1.0)
        edge = self.edge * share
        return edge, min(self.unit.leg_length + noise, self.tip / max(share, 1e-9)), max(0.5 * edge, 2.0 * noise)

    def free(self) -> NDArray[np.bool_]:
        """(12,) which unknowns are adjusted: those not held fixed, and the leg lengths whose end discs are in use."""
        free = self.prior_sd > 0
        free[8:] = self.discs
        return free

    def step(self, *, hold_shape: bool = False) -> float:
        """Make one Gauss-Newton step; returns its squared length in standard deviations."""
        free = self.free()
        if hold_shape:
            free[6:8] = False
        gain: float = _step(
            self.normal, self.rhs, free, self.scaling, self.prior_weights, self.nominal, self.unit.leg_length,
            self.centre, self.rotation, self.shape, self.leg_errors, self.change,
        )  # fmt: skip
        return gain

    def looks_like_noise(self, scale: float) -> bool:
        """Whether nearly all residuals are small beside the unit, and none far beyond their scale."""
        owned = self.legs >= 0
        small = bool(owned.any()) and scale * float(self.sds[owned].mean()) < 0.01 * self.unit.height
        return small and self.share_within(scale) > 0.95

    def share_within(self, scale: float) -> float:
        """Share of the points inside the window of the robust weights; points in the tips, which fit nothing, do not count."""
        share: float = _share_within(self.residuals, self.biases, self.sds, self.at_tip, self.given, NO_WEIGHT * scale)
        return share

    def quantile_scale(self, share: float) -> float:
        """Scale of the residuals of all points, from the quantile of their sizes at ``share``."""
        u = _sizes(self.residuals, self.biases, self.sds, self.given)
        u.partition(int(share * len(u)))
        scale = float(u[int(share * len(u))]) / _size_at(share)
        # a known noise still needs a wide start while the pose is rough
        return min(max(scale, self.options.sigma or self.floor), 1e6 * self.unit.height)

    def refined_scale(self, scale: float, squares: float, weight_sum: float) -> float:
        """Scale after a linearisation with ``scale``: the known one, or :meth:`scale_of` above the smallest that makes sense."""
        if self.options.sigma is not None:
            return self.options.sigma
        return max(self.scale_of(scale, squares, weight_sum), self.floor)

    def scale_of(self, scale: float, squares: float, weight_sum: float) -> float:
        """Scale of the residuals from their squares, standardised by ``scale``, over what the weights exceed the unknowns by.

        The unknowns take their share of the residuals with or without robust weights. Left out of account among few points, the scale
        comes out too small, the weights then drop good points, and so on: of 40 points seven were left that fitted exactly.
        """
        consistency = _SCALE_CONSISTENCY if self.options.robust else 1.0
        return scale * math.sqrt(squares / max(weight_sum - np.count_nonzero(self.free()), 1.0) / consistency)

    def find_discs(self, scale: float) -> bool:
        """Use the end disc of a leg where the points show a plane at the nominal length: many, thin, in place. Tells of any."""
        body = (self.xyz - self.centre) @ self.rotation
        length, tolerance = self.unit.leg_length, self.prior_sd[8]
        noise = scale * float(np.mean(self.sds[np.isfinite(self.residuals)]))
        rim = max(self.shape[0] - self.shape[1] * length - self.edge, 0.0)
        axial = body @ self.axes.T
        beside = np.einsum("ij,ij->i", body, body)[:, None] - axial**2 < rim**2
        for k in range(4):
            beyond = axial[:, k] - length
            near = beside[:, k] & (np.abs(beyond) < (1 - TIP_RATIO) * length + 3 * noise)
            if len(self.given):
                near &= self.given == k
            if near.sum() < 2 * MIN_POINTS:
                continue
            middle = float(np.median(beyond[near]))
            spread = 1.4826 * float(np.median(np.abs(beyond[near] - middle)))
            off = 4 * math.hypot(tolerance, 1.5 * noise / math.sqrt(near.sum()))
            self.discs[k] = spread < 1.5 * noise and abs(middle) < off
        return bool(self.discs.any())

    def close_legs(self, scale: float) -> bool:
        """Shut legs that own no points beyond doubt: what a crease shares with them says nothing about where they are."""
        if len(self.given):
            return False
        enough = max(MIN_POINTS, 0.01 * np.count_nonzero(self.weights))
        counts = clear_counts(
            self.xyz, self.centre, self.rotation, self.axes, self.opened, self.sds, self.weights, self.legs, scale, enough
        )
        keep = self.opened & (counts >= enough)
        if not keep.any() or (keep == self.opened).all():
            return False
        self.opened, self.discs = keep, self.discs & keep
        return True

    def result(self, scale: float, sums: tuple[float, float], converged: bool, iterations: int) -> Adjustment:
        free = self.free()
        slope = self.slopes / max(self.singles, 1.0)
        excess = row_excess(
            self.feet, self.legs, self.parts, self.weights, self.sds, self.rotation, self.axes, self.shape, self.cov,
            max(1, len(self.xyz) // APPROACH_SAMPLE),
        )  # fmt: skip
        root, undetermined = _inverse_root(slope * self.plain + self.shared - excess, self.prior_weights, free, self.scaling)
        white = root @ root.T
        used = self.weights > 0
        count = float(np.count_nonzero(used))
        small_sample = max(count, 1.0) / max(count - np.count_nonzero(free[:8]), 1.0)
        psi = small_sample * self.psi_squares / max(self.singles, 1.0)
        noise_part = psi * self.plain + small_sample * self.shared_scores
        prior = np.diag(self.prior_weights)
        whitened = self.rows @ root
        scores = (self.residuals - self.biases) / self.sds * self.weights
        correlated = correlated_part(self.feet, self.rows, whitened, scores, self.weights, self.unit.height, white, self.plain, psi)
        correlated = _guarded(correlated, noise_part, free, self.scaling)
        covariance, inflation = _sandwich(white, noise_part + prior, correlated)
        if len(undetermined):
            undetermined = undetermined[np.linalg.norm(undetermined[:, :8], axis=1) > 0.1]
        undetermined = undetermined[:, :8]
        lost = undetermined * self.scaling[:8]
        covariance += LOST**2 * lost.T @ lost
        # from the axes of the body to those of the points
        axes = np.eye(8)
        axes[:3, :3] = axes[3:6, 3:6] = self.rotation
        covariance, undetermined = axes @ covariance @ axes.T, undetermined @ axes.T
        redundancy_numbers, detectable = np.zeros(len(self.xyz)), np.full(len(self.xyz), math.inf)
        influence, all_weight, owned, squared_sds = _redundancy(
            whitened, self.weights, self.legs, self.parts, self.sds, scale, redundancy_numbers, detectable
        )
        noise = scale if self.options.sigma is None else self.scale_of(scale, *sums)
        visible = sum(number >= max(MIN_POINTS, 0.01 * count) for number in owned.tolist())
        mean_sd = math.sqrt(squared_sds / count) if count else math.nan
        a_priori = self.options.sigma or (1.0 if len(self.cov) else noise)
        return Adjustment(
            Pose(self.centre, self.rotation), float(self.shape[0]), float(self.shape[1]), covariance, noise / a_priori, noise * mean_sd,
            all_weight - influence, redundancy_numbers, detectable, self.weights.copy(), np.where(used, self.legs, -1),
            self.parts.copy(), self.residuals.copy(), all_weight / inflation, converged, iterations, undetermined, visible,
            _flags(visible, len(undetermined), count > 0 and not owned.any(), count < FEW_POINTS),
        )  # fmt: skip


def _flags(visible: int, undetermined: int, discs_only: bool, few_points: bool) -> tuple[str, ...]:
    flags = []
    if few_points:
        flags.append("few points")
    if discs_only:
        flags.append("end discs only")
    if visible == 1:
        flags.append("one leg: twist about its axis undetermined")
    elif visible == 2:
        flags.append("two legs")
    if undetermined > (1 if visible == 1 else 0):
        flags.append(f"{undetermined} directions undetermined")
    return tuple(flags)
