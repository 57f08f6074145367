"""Congruence of two epochs whose frames bend: the datum is a field, and every unit is judged by what the others predict at its place.

Displacements of units hold the difference of the two frames' errors and a part of their own,

    d_u = A(x_u) theta + g(x_u) + e_u,   e_u ~ t_nu(0, V_u)

with the field g of :mod:`..registration.frame_field`. What targets say of the field is datum ``control``; what they and the units that
agree with each other say is datum ``stable``, where a unit's own observation is taken back out (leave one out), so that it cannot
explain itself. The null distribution of resting units is calibrated as in :mod:`.congruence`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import coo_array

from ..common.arrays import BoolArray, FloatArray
from ..common.robust import t_weights
from ..registration.frame_field import FieldEstimate, LocalMotions, information_of
from ..registration.transformation import rigid_jacobian
from .congruence import STABLE_LEVEL, Congruence, combined_test, pooled_degrees, quadratic
from .control_scale import ControlScale, scale_of_control
from .null_model import NullModel, calibrate, f_p_value

ROUGH_SHARE = 0.002
"""Deviation over H that a unit may have beyond its covariance before the null distribution is known."""
ROBUST_STEPS, DATUM_STEPS = 12, 8


@dataclass(frozen=True, eq=False, kw_only=True)
class FrameTie:
    """What resting units say of the frames of two epochs.

    Attributes
    ----------
    stable
        The difference of the two frames' errors as targets and resting units see it.
    information, rhs
        Sparse normal matrix and right-hand side of these units: what ``stable`` knows beyond targets.
    size
        Factor of the model's variance that datum ``control`` was found to need.
    bends
        Independent bends that it was learned from; 0 where it was not.
    """

    stable: FieldEstimate
    information: coo_array
    rhs: FloatArray
    size: float
    bends: float


@dataclass(frozen=True, eq=False, kw_only=True)
class ElasticDatum(FrameTie):
    """Both datums of an epoch pair as fields.

    Attributes
    ----------
    control
        The difference of the two frames' errors as targets see it; its covariance holds ``size``.
    precision
        Inverse of its covariance by the model.
    used
        (n,) whether a unit took part in datum ``stable``.
    """

    control: FieldEstimate
    precision: FloatArray
    used: BoolArray

    @property
    def tie(self) -> FrameTie:
        """What outlasts the comparison: on long coasts each matrix of all unknowns is large."""
        return FrameTie(stable=self.stable, information=self.information, rhs=self.rhs, size=self.size, bends=self.bends)


def elastic_congruence_of(
    displacements: FloatArray,
    covariances: FloatArray,
    points: FloatArray,
    control: FieldEstimate,
    precision: FloatArray,
    scale: float,
    degrees: float,
    suspects: BoolArray,
    controlled: bool,
) -> tuple[Congruence, ElasticDatum]:
    """Find the stable set, the datum as a field and the calibrated tests.

    Parameters
    ----------
    displacements, covariances
        (n, 3), (n, 3, 3) of the centres of units, without the error of the frames, metres.
    points
        (n, 3) where the units are.
    control
        Difference of the frames' errors before any unit has been asked; its covariance is that of the prior where there is no control.
    precision
        Inverse of that covariance.
    scale
        H in metres.
    degrees
        Degrees of freedom of the registrations.
    suspects
        (n,) units of stretches that moved as one: they agree with each other, and would vouch for each other if they were asked.
    controlled
        Whether both epochs have targets: resting units then show how far off these leave the frames.
    """
    basis = control.basis
    at_control = control.at(points)

    def adjusted(weights: FloatArray, variances: FloatArray) -> FieldEstimate:
        inverse = np.linalg.inv(variances) * weights[:, None, None]
        keep = weights > 1e-6
        return FieldEstimate.from_observations(basis, precision, points[keep], displacements[keep], inverse[keep], control.mean)

    def by_others(weights: FloatArray, variances: FloatArray) -> LocalMotions:
        # the field itself is let go at once: two at a time would be twice the memory
        return adjusted(weights, variances).at(points).without(displacements, variances, weights)

    rough = covariances + (ROUGH_SHARE * scale) ** 2 * np.eye(3)
    weights = t_weights(quadratic(displacements - at_control.means[:, :3], rough + at_control.covariances[:, :3, :3]))[0]
    weights[suspects] = 0.0
    for _ in range(ROBUST_STEPS):
        others = by_others(weights, rough)
        earlier, weights = weights, t_weights(quadratic(displacements - others.means[:, :3], rough + others.covariances[:, :3, :3]))[0]
        weights[suspects] = 0.0
        if np.abs(weights - earlier).max(initial=0.0) < 0.05:
            break
    others = by_others(weights, rough)
    residuals, spread = displacements - others.means[:, :3], others.covariances[:, :3, :3]
    null = calibrate(residuals, covariances, scale, spread)
    stable = ~suspects & (null.p_value(quadratic(residuals, null.covariance(covariances) + spread)) > STABLE_LEVEL)
    for _ in range(DATUM_STEPS):
        others = by_others(stable.astype(np.float64), null.covariance(covariances))
        residuals, spread = displacements - others.means[:, :3], others.covariances[:, :3, :3]
        before, null = null, calibrate(residuals, covariances, scale, spread)
        consistent = null.p_value(quadratic(residuals, null.covariance(covariances) + spread)) > STABLE_LEVEL
        previous, stable = stable, ~suspects & consistent
        if (stable == previous).all() and abs(null.factor - before.factor) + abs(null.floor - before.floor) / scale < 1e-3:
            break
    effective = null.covariance(covariances)
    field = adjusted(stable.astype(np.float64), effective)
    others = field.at(points).without(displacements, effective, stable.astype(np.float64))
    known = ControlScale(size=1.0, factor=1.0, degrees=degrees, bends=0.0)
    if controlled:
        known = scale_of_control(control, points[stable], displacements[stable], effective[stable], null, degrees)
    control = replace(control, covariance=control.covariance * known.size)
    congruence = _summary(displacements, effective, points, stable, null, others, control.at(points), known)
    weights = np.asarray(np.linalg.inv(effective[stable]), dtype=np.float64)
    information, rhs = information_of(basis, points[stable], displacements[stable], weights)
    datum = ElasticDatum(
        control=control, stable=field, precision=precision, used=stable, information=information, rhs=rhs, size=known.size,
        bends=known.bends,
    )  # fmt: skip
    return congruence, datum


def _summary(
    displacements: FloatArray,
    effective: FloatArray,
    points: FloatArray,
    stable: BoolArray,
    null: NullModel,
    others: LocalMotions,
    at_control: LocalMotions,
    known: ControlScale,
) -> Congruence:
    """The pair's tests in the form that rigid frames have; motion is the rigid part of what the stable units share."""
    origin = points[stable].mean(axis=0) if stable.any() else np.zeros(3)
    statistics = quadratic(displacements - others.means[:, :3], effective + others.covariances[:, :3, :3])
    frame = at_control.covariances[:, :3, :3]
    control = quadratic(displacements - at_control.means[:, :3], effective + frame) / known.factor
    motion = np.zeros(7)
    if stable.sum() >= 3:
        design = rigid_jacobian(points[stable] - origin)[:, :, :6].reshape(-1, 6)
        motion[:6] = np.linalg.lstsq(design, others.means[stable, :3].ravel(), rcond=None)[0]
    p_values = null.p_value(statistics)
    global_statistic, global_p_value = combined_test(p_values)
    return Congruence(
origin=origin,
motion=motion,
motion_covariance=np.zeros((7, 7)),
prior=np.zeros((7, 7)),
stable=stable,
null=null,
statistics=statistics,
p_values=p_values,
scale_degrees=np.full(len(displacements), math.inf),
control_statistics=control,
control_p_values=f_p_value(control, pooled_degrees(effective, null.tail, frame, known.degrees)),
control_degrees=known.degrees,
control_factor=known.factor,
global_statistic=global_statistic,
global_p_value=global_p_value,
common_statistic=math.nan,
common_p_value=math.nan,
)  # fmt: skip
