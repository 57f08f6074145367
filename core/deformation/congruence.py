"""Congruence of two epochs: which units are stable, the datum they strengthen, and how uncertain a displacement really is.

Displacements d_u (3,) of units in the control frame have a part common to all, the error of the two registrations, and one of their own:

    d_u = A(x_u) theta + e_u,   theta ~ N(0, Sigma_registration),   e_u ~ t_nu(0, V_u),   V_u = s^2 C_u + tau^2 I

with C_u the covariance of the joint adjustment. Roughness, growth and drifts within a strip make C_u too small, so the factor s,
the floor tau and the weight nu of the tails are estimated from the stable units themselves by maximum likelihood, while moved
units are described by a broad second component (the empirical null distribution of Efron, 2004, JASA 99). Congruence test and
datum after Pelzer (1971) and Niemeier (1985): global test of all units, then units that do not agree leave the datum. Their sum of
squares would say nothing, as their own spread is its measure: the global test combines the p-values of units (Liu and Xie, 2020, JASA
115, the Cauchy combination test), whose level holds however the statistics of units with a common datum depend on each other.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.special import fdtrc

from ..common.arrays import BoolArray, FloatArray
from ..common.robust import CHI2_3_MEDIAN
from ..registration.frame_field import LocalMotions
from ..registration.transformation import rigid_jacobian
from .null_model import NullModel, calibrate, f_p_value

STABLE_LEVEL = 0.01
"""Units with a smaller p-value do not support the datum."""
FEW_MEMBERS = 12
"""Units of a datum up to which it is solved anew without each of them, and up to which it matters how little they tell of deviations."""
STATED_DEGREES = 1.0
"""Degrees of freedom that stated covariances are worth by themselves: they are off by factors of two, as in :func:`calibrate`."""
LARGEST_SHARE = 0.9999
"""Share of a statistic's variance up to which what is known of a frame apart from units counts as such."""
LEAST_P_VALUE = 1e-15
"""To which p-values of units are rounded, and 1 less that, where they are combined."""
FREE_SHIFT, FREE_TURN = 1e3, 1.0
"""Standard deviations, metres and radians, of a common motion of which nothing is known."""


@dataclass(frozen=True, eq=False)
class PoseCalibration:
    """What the stable units say of the covariances of the poses of one epoch.

    Attributes
    ----------
    factors, floors
        (6,) factors of the standard deviations of e, n, h and the rotation vector, and deviations (metres, radians) of a difference of
        two epochs that are added.
    """

    factors: FloatArray
    floors: FloatArray

    @classmethod
    def of_pairs(cls, pairs: Sequence[tuple[float, float, float, float]]) -> PoseCalibration:
        """From factor and floor of positions, then of rotations, in every pair the epoch belongs to: their medians; none change nothing."""
        factor, floor, turn_factor, turn_floor = np.median(np.array(pairs or [(1.0, 0.0, 1.0, 0.0)]), axis=0)
        return cls(np.repeat([factor, turn_factor], 3), np.repeat([floor, turn_floor], 3))

    def covariance(self, covariance: FloatArray) -> FloatArray:
        """(6, 6) covariance of a pose by itself from that of its adjustment.

        What the poses of both epochs err by alike, the casting's part, drops out of displacements at rest: a factor below one says nothing
        of it, and leaves the covariance as it is.
        """
        factors = np.maximum(self.factors, 1.0)
        # the floor of a difference belongs half to each of its epochs
        return np.asarray(covariance * np.outer(factors, factors) + np.diag(0.5 * self.floors**2))


def combined_test(p_values: FloatArray) -> tuple[float, float]:
    """Whether (n,) p-values of units, dependent or not, are those of units at rest: statistic and p-value of all together.

    The statistic, the mean of tan((1/2 - p) pi), has a standard Cauchy distribution (Liu and Xie, 2020, JASA 115).
    """
    if len(p_values) < 2:
        return 0.0, 1.0
    # one p-value that is exactly 0 or 1 is not to outweigh all
    statistic = float(np.mean(1 / np.tan(np.pi * np.clip(p_values, LEAST_P_VALUE, 1 - LEAST_P_VALUE))))
    return statistic, math.atan2(1.0, statistic) / math.pi


def pooled_degrees(own: FloatArray, tail: float, frame: FloatArray, degrees: float) -> FloatArray:
    """Degrees of freedom of the sum of two covariances (Satterthwaite, 1946, Biometrics Bulletin 2(6), by their traces).

    Parameters
    ----------
    own, tail
        (n, 3, 3) of units themselves, and its degrees of freedom.
    frame, degrees
        (n, 3, 3) of the frames at their places, and its degrees of freedom.
    """
    a, b = np.einsum("nii->n", own), np.einsum("nii->n", frame)
    return np.asarray((a + b) ** 2 / (a**2 / tail + b**2 / max(degrees, 1.0)))


@dataclass(frozen=True, eq=False, kw_only=True)
class Congruence:
    """Result of :func:`congruence_of` for one epoch pair.

    Attributes
    ----------
    origin
        (3,) point the common motion refers to: the centroid of the units.
    motion, motion_covariance
        (7,), (7, 7): shift (m), rotation vector (rad), scale of the stable set in the control frame, control included; to be subtracted
        in datum ``stable``.
    prior
        (7, 7) covariance of the common motion from the registrations alone; that of knowing nothing without control.
    stable
        (n,) whether a unit supports the datum.
    null
        Calibrated distribution of stable units.
    statistics, p_values
        (n,) of each unit in datum ``stable``, itself left out of the datum.
    scale_degrees
        (n,) degrees of freedom with which the others of few units know the scale of deviations in datum ``stable``; infinite for many.
    control_statistics, control_p_values
        The same in datum ``control``.
    control_degrees
        Degrees of freedom with which the frames' part of datum ``control`` is known.
    control_factor
        By which statistics of datum ``control`` are divided, so that their level is that of the units at rest.
    global_statistic, global_p_value
        Test that no unit moved against the others: p-values of all units combined, see :func:`combined_test`.
    common_statistic, common_p_value
        Test that the stable set did not move against control; nan without control or without stable units.
    """

    origin: FloatArray
    motion: FloatArray
    motion_covariance: FloatArray
    prior: FloatArray
    stable: BoolArray
    null: NullModel
    statistics: FloatArray
    p_values: FloatArray
    scale_degrees: FloatArray
    control_statistics: FloatArray
    control_p_values: FloatArray
    control_degrees: float
    control_factor: float
    global_statistic: float
    global_p_value: float
    common_statistic: float
    common_p_value: float

    def rigid_motions(self, points: FloatArray, datum: str) -> LocalMotions:
        """What the common motion is for small bodies at (n, 3) points of the control frame, in datum ``stable`` or ``control``."""
        rows = np.zeros((len(points), 6, 7))
        rows[:, :3] = rigid_jacobian(points - self.origin)
        rows[:, [3, 4, 5], [3, 4, 5]] = 1
        motion = self.motion if datum == "stable" else np.zeros(7)
        covariance = self.motion_covariance if datum == "stable" else self.prior
        return LocalMotions(rows @ motion, rows @ covariance @ np.swapaxes(rows, 1, 2))

    def by_others(self, points: FloatArray, displacements: FloatArray, effective: FloatArray, used: BoolArray) -> LocalMotions:
        """Datum ``stable`` at (n,) units, without what each of those ``used`` for it says itself; lengths in metres."""
        parts = self.rigid_motions(points, "stable")
        if used.sum() > FEW_MEMBERS:
            return parts.without(displacements, effective, used.astype(np.float64))
        means, covariances = parts.means.copy(), parts.covariances.copy()
        for k in np.flatnonzero(used):
            rest = used.copy()
            rest[k] = False
            own = self.resting_on(rest, displacements, effective, points).rigid_motions(points[[k]], "stable")
            means[k], covariances[k] = own.means[0], own.covariances[0]
        return LocalMotions(means, covariances)

    def resting_on(self, units: BoolArray, displacements: FloatArray, effective: FloatArray, points: FloatArray) -> Congruence:
        """The same with datum ``stable`` resting on some of the (n,) units alone.

        Their (n, 3) displacements, (n, 3, 3) effective covariances and (n, 3) points are in metres. Without control and with fewer than
        three units their motion is open.
        """
        a = rigid_jacobian(points[units] - self.origin)
        motion, covariance = _solve(displacements[units], np.asarray(np.linalg.inv(effective[units]), dtype=np.float64), a, self.prior)
        return replace(self, motion=motion, motion_covariance=0.5 * (covariance + covariance.T))


def congruence_of(
    displacements: FloatArray,
    covariances: FloatArray,
    points: FloatArray,
    prior: FloatArray | None,
    origin: FloatArray,
    scale: float,
    degrees: float = math.inf,
) -> Congruence:
    """Find the stable set of an epoch pair, its datum and the calibrated tests.

    Parameters
    ----------
    displacements, covariances
        (n, 3), (n, 3, 3) of one point of each unit (the centre), without registration error, metres.
    points
        (n, 3) where the units are.
    prior
        (7, 7) covariance of the common motion (shift, rotation vector, scale) about ``origin`` from both registrations; None where
        an epoch has no control, so that nothing is known of it.
    origin
        (3,) reduction point of the common motion.
    scale
        Length of the units in metres (H), for the broad component of moved units.
    degrees
        Degrees of freedom of the prior's variance, the redundancy of the registrations.
    """
    known = prior is not None
    sigma = _free_prior() if prior is None else _regular(prior)
    a = rigid_jacobian(points - origin)
    rough = covariances + (0.002 * scale) ** 2 * np.eye(3)
    theta, cofactor = _robust_motion(displacements, rough, a, sigma)
    # the first datum has no members, so that no unit's residual is small for having been fitted
    residuals, spread = displacements - a @ theta, a @ cofactor @ np.swapaxes(a, 1, 2)
    null = calibrate(residuals, covariances, scale, spread)
    effective = null.covariance(covariances)
    stable = null.p_value(quadratic(residuals, effective + spread)) > STABLE_LEVEL
    for _ in range(12):
        others = _others(displacements, effective, a, sigma, stable, degrees)
        earlier, null = null, calibrate(others.residuals, covariances, scale, others.spread)
        previous, stable = stable, f_p_value(others.statistics, np.minimum(null.tail, others.degrees)) > STABLE_LEVEL
        effective = null.covariance(covariances)
        if (stable == previous).all() and abs(null.factor - earlier.factor) + abs(null.floor - earlier.floor) / scale < 1e-3:
            break
    else:
        # two sets of units take turns, as where one null leaves none and knows nothing: the wider null contradicts neither
        null = max(null, earlier, key=lambda model: np.trace(model.covariance(covariances), axis1=1, axis2=2).sum())
        effective, stable = null.covariance(covariances), stable | previous
        others = _others(displacements, effective, a, sigma, stable, degrees)
        stable = f_p_value(others.statistics, np.minimum(null.tail, others.degrees)) > STABLE_LEVEL
    others = _others(displacements, effective, a, sigma, stable, degrees)
    statistics, p_values = others.statistics, f_p_value(others.statistics, np.minimum(null.tail, others.degrees))
    frame = a @ sigma @ np.swapaxes(a, 1, 2)
    control = quadratic(displacements, effective + frame)
    global_statistic, global_p_value = combined_test(p_values)
    common = math.nan
    if known and stable.any():
        common = _common(displacements[stable], effective[stable], a[stable], sigma)
    return Congruence(
origin=origin,
motion=others.motion,
motion_covariance=others.cofactor,
prior=sigma,
stable=stable,
null=null,
statistics=statistics,
p_values=p_values,
scale_degrees=others.degrees,
control_statistics=control,
control_p_values=f_p_value(control, pooled_degrees(effective, null.tail, frame, degrees)),
control_degrees=degrees,
control_factor=1.0,
global_statistic=global_statistic,
global_p_value=global_p_value,
common_statistic=common,
common_p_value=float(fdtrc(6, min(degrees, 1e6) or 1e6, common / 6)) if math.isfinite(common) else math.nan,
)  # fmt: skip


def _free_prior() -> FloatArray:
    return np.diag([FREE_SHIFT**2] * 3 + [FREE_TURN**2] * 3 + [1e-24])


def _regular(prior: FloatArray) -> FloatArray:
    """Covariance with a tiny variance where a parameter was held fixed, so that it can be inverted."""
    return prior + np.diag([1e-14] * 3 + [1e-20] * 3 + [1e-24])


def _solve(displacements: FloatArray, weights: FloatArray, a: FloatArray, sigma: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Common motion from prior and units; ``weights`` (n, 3, 3)."""
    at_w = np.swapaxes(a, 1, 2) @ weights
    normal = np.linalg.inv(sigma) + np.sum(at_w @ a, axis=0)
    cofactor = np.linalg.inv(normal)
    return cofactor @ np.einsum("nij,nj->i", at_w, displacements), cofactor


def _robust_motion(displacements: FloatArray, covariances: FloatArray, a: FloatArray, sigma: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Common motion that most units share, by reweighting from the median shift."""
    if not len(displacements):
        return np.zeros(7), sigma
    inverse = np.linalg.inv(covariances)
    residuals = displacements - np.median(displacements, axis=0)
    theta, cofactor = np.zeros(7), sigma
    for _ in range(30):
        q = np.einsum("ni,nij,nj->n", residuals, inverse, residuals)
        size = max(float(np.median(q)) / CHI2_3_MEDIAN, 1e-12)
        weight = 1 / (1 + q / (3 * size)) ** 2
        theta, cofactor = _solve(displacements, inverse * (weight / size)[:, None, None], a, sigma)
        residuals = displacements - a @ theta
    return theta, cofactor


@dataclass(frozen=True, eq=False, kw_only=True)
class _Others:
    """A datum, and what it says of every unit once that is not asked.

    ``motion`` (7,) and ``cofactor`` (7, 7) of all members; ``residuals`` (n, 3) of units in the datum of the others, ``spread`` (n, 3, 3)
    of that datum, ``statistics`` (n,), and ``degrees`` (n,) with which the scale of both is known, infinite where members are many.
    """

    motion: FloatArray
    cofactor: FloatArray
    residuals: FloatArray
    spread: FloatArray
    statistics: FloatArray
    degrees: FloatArray


def _others(
    displacements: FloatArray, covariances: FloatArray, a: FloatArray, sigma: FloatArray, stable: BoolArray, degrees: float
) -> _Others:
    """Datum of the stable set, and each unit against the datum without itself; ``degrees`` of the prior."""
    weights = np.asarray(np.linalg.inv(covariances) * stable[:, None, None], dtype=np.float64)
    theta, cofactor = _solve(displacements, weights, a, sigma)
    if stable.sum() <= FEW_MEMBERS:
        residuals, spread, known = _each_anew(displacements, weights, covariances, a, sigma, stable, degrees)
        statistics = quadratic(residuals, covariances + spread)
    else:
        residuals = displacements - a @ theta
        spread = a @ cofactor @ np.swapaxes(a, 1, 2)
        # a member's residual has V - A Q A^T, an outsider's V + A Q A^T; the first equals the deletion statistic exactly
        statistics = quadratic(residuals, covariances + np.where(stable[:, None, None], -spread, spread))
        own, shared = covariances[stable], spread[stable]
        gain = np.linalg.inv(own - shared)
        residuals[stable] = np.einsum("kij,kj->ki", own @ gain, residuals[stable])
        spread[stable] = shared + shared @ gain @ shared
        known = np.full(len(displacements), math.inf)
    return _Others(motion=theta, cofactor=cofactor, residuals=residuals, spread=spread, statistics=statistics, degrees=known)


def _each_anew(
    displacements: FloatArray,
    weights: FloatArray,
    covariances: FloatArray,
    a: FloatArray,
    sigma: FloatArray,
    stable: BoolArray,
    degrees: float,
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Residuals, spread and degrees of :class:`_Others` from an adjustment without each unit: with few, what is left is no difference.

    Deviations of units, and with them that of the frame they show, have one scale, which the others know by their redundancy; what control
    says of the frame is known by itself. Both are pooled in the direction of the residual (Yao, 1965, Biometrika 52): a frame that is open
    in another one does not make the tails lighter.
    """
    at_w = np.swapaxes(a, 1, 2) @ weights
    prior, members = np.linalg.inv(sigma), np.flatnonzero(stable)
    normals, sides = at_w @ a, np.einsum("nij,nj->ni", at_w, displacements)
    residuals, spread, known = np.empty_like(displacements), np.empty_like(covariances), np.empty(len(displacements))
    for k in range(len(displacements)):
        # summed anew: a difference would cancel what is left of few
        rest = members[members != k]
        cofactor = np.linalg.inv(prior + normals[rest].sum(axis=0))
        cofactor = 0.5 * (cofactor + cofactor.T)
        residuals[k] = displacements[k] - a[k] @ (cofactor @ sides[rest].sum(axis=0))
        spread[k] = a[k] @ cofactor @ a[k].T
        by_prior = cofactor @ prior
        redundancy = 3 * len(rest) - (len(prior) - np.trace(by_prior))
        towards = np.linalg.solve(covariances[k] + spread[k], residuals[k])
        total = float(towards @ residuals[k])
        share = float(towards @ a[k] @ by_prior @ cofactor @ a[k].T @ towards) / total if total > 0 else 0.0
        scale = STATED_DEGREES + max(float(redundancy), 0.0)
        # a frame of which nothing is known is all there is, to the last digit
        share = min(max(share, 0.0), LARGEST_SHARE)
        known[k] = 1 / ((1 - share) ** 2 / scale + share**2 / max(degrees, 1.0))
    return residuals, spread, known


def quadratic(vectors: FloatArray, covariances: FloatArray) -> FloatArray:
    """(n,) quadratic forms of (n, 3) vectors with the inverse of their covariances."""
    return np.asarray(np.einsum("ni,ni->n", vectors, np.linalg.solve(covariances, vectors[:, :, None])[:, :, 0]))


def _common(displacements: FloatArray, covariances: FloatArray, a: FloatArray, sigma: FloatArray) -> float:
    """Motion of the stable units alone against zero, with the covariance of both registrations (rigid part, 6 degrees)."""
    free = _free_prior()
    theta, cofactor = _solve(displacements, np.asarray(np.linalg.inv(covariances), dtype=np.float64), a, free)
    total = (cofactor + sigma)[:6, :6]
    return float(theta[:6] @ np.linalg.solve(total, theta[:6]))
