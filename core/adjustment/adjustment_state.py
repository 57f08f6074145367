"""What an adjustment is given, and what its iterations change."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..model.pose import Pose
from ..model.tetrapod import EDGE_RATIO
from ..model.unit_types import UnitType
from .adjustment_records import LENGTH_SD, AdjustmentOptions
from .condition_records import LegDirections, NormalEquations, PointStates, Solid, Sums, legs_of

END_IN_NOISE = 1.0
"""Distance from the end of a leg, in standard deviations of the noise, up to which its cone is used where its end disc is not."""


class Prior(NamedTuple):
    """What is known of the 12 unknowns beforehand.

    Attributes
    ----------
    nominal
        (2,) radius, metres, and gradient.
    leg_length
        Metres.
    sds, weights
        (12,) standard deviations, 0 for what is held fixed, and the weights of prior observations.
    scaling
        (12,) what makes unknowns comparable: one leg length, one radian.
    """

    nominal: FloatArray
    leg_length: float
    sds: FloatArray
    weights: FloatArray
    scaling: FloatArray

    @classmethod
    def of(cls, unit: UnitType, options: AdjustmentOptions) -> Prior:
        """Of a unit type."""
        length = float(unit.leg_length)
        length_sd = LENGTH_SD * length if options.leg_length_sd is None else options.leg_length_sd
        sds = np.array([math.inf] * 6 + [options.radius_sd, options.gradient_sd] + [length_sd] * 4)
        with np.errstate(divide="ignore"):
            weights = np.where((sds > 0) & np.isfinite(sds), 1 / sds**2, 0.0)
        scaling = np.array([length] * 3 + [1.0] * 3 + [length, 1.0] + [length] * 4)
        return cls(np.array([unit.radius, unit.gradient], dtype=np.float64), length, sds, weights, scaling)

    @classmethod
    def empty(cls) -> Prior:
        """Stands for any in what is compiled."""
        return cls(np.zeros(2), 0.0, np.zeros(12), np.zeros(12), np.zeros(12))


class UnitState(NamedTuple):
    """Where a unit is and how it is shaped; its arrays change in place from step to step.

    Attributes
    ----------
    centre, rotation
        (3,) metres and (3, 3), body to the axes of the points.
    shape
        (2,) radius, metres, and gradient.
    leg_errors
        (4,) errors of the leg lengths, metres.
    opened, discs
        (4,) legs that may own points, and those whose end disc is used.
    """

    centre: FloatArray
    rotation: FloatArray
    shape: FloatArray
    leg_errors: FloatArray
    opened: BoolArray
    discs: BoolArray

    @classmethod
    def start(cls, unit: UnitType, pose: Pose, options: AdjustmentOptions) -> UnitState:
        """Of a unit type's nominal shape in a pose."""
        return cls(
            np.array(pose.centre),
            np.array(pose.rotation, dtype=np.float64, order="C"),
            np.array([unit.radius, unit.gradient], dtype=np.float64),
            np.zeros(4),
            np.ones(4, dtype=np.bool_),
            np.full(4, options.end_discs is True),
        )

    @classmethod
    def empty(cls) -> UnitState:
        """Stands for any in what is compiled."""
        none = np.zeros(4, dtype=np.bool_)
        return cls(np.zeros(3), np.zeros((3, 3)), np.zeros(2), np.zeros(4), none, none)

    def copy(self) -> UnitState:
        """The same with arrays of its own."""
        return UnitState(
            self.centre.copy(), self.rotation.copy(), self.shape.copy(), self.leg_errors.copy(), self.opened.copy(), self.discs.copy()
        )


@dataclass(frozen=True, eq=False, kw_only=True)
class Problem:
    """One adjustment's points and terms.

    A residual is in metres, and its standard deviation is a ``scale`` times the point's in ``PointStates.sds``. Without covariances that is
    1 and a scale is in metres: the noise. With covariances it is what they give in the direction of the residual, metres, and a scale is a
    factor on it; where metres are needed before a point's direction is known (``noise`` in what follows), it is times ``mean_sd``. Points
    of no part keep 1.

    Attributes
    ----------
    unit, options
        Nominal geometry, and how it is adjusted.
    points, columns
        (n, 3) metres, and the same as (3, n). These and the other arrays are in C order and aligned, which compiled loops rely on.
    cov
        (n, 3, 3) their covariances, square metres, or (0, 3, 3).
    given
        (n,) known leg of each point, -1 to leave it out, or (0,).
    legs, prior
        Directions of the legs; what is known of the unknowns.
    edge, tip
        Widths in metres along creases and rims, and axial coordinate along legs, that are left out where no noise hides them.
    mean_sd
        Standard deviation of a coordinate for a scale of one, root mean square, metres.
    floor
        Smallest scale that makes sense.
    """

    unit: UnitType
    options: AdjustmentOptions
    points: FloatArray
    columns: FloatArray
    cov: FloatArray
    given: IntArray
    legs: LegDirections
    prior: Prior
    edge: float
    tip: float
    mean_sd: float
    floor: float

    @classmethod
    def of(cls, points: FloatArray, unit: UnitType, options: AdjustmentOptions, *, cov: FloatArray, given: IntArray) -> Problem:
        """Of (n, 3) points, (n, 3, 3) covariances or none, and (n,) known legs or none."""
        return cls(
            unit=unit,
            options=options,
            points=points,
            columns=np.ascontiguousarray(points.T),
            cov=cov,
            given=given,
            legs=legs_of(unit.opening),
            prior=Prior.of(unit, options),
            edge=float(EDGE_RATIO * unit.height if options.edge is None else options.edge),
            tip=options.tip * unit.leg_length if options.tip < 1 else math.inf,
            mean_sd=math.sqrt(float(np.mean(np.trace(cov, axis1=1, axis2=2))) / 3) if len(cov) else 1.0,
            floor=1e-7 if len(cov) else 1e-7 * unit.height,
        )

    def sampled(self, some: IntArray) -> Problem:
        """The same terms for some of the points."""
        points = self.points[some]
        return replace(
            self,
            points=points,
            columns=np.ascontiguousarray(points.T),
            cov=self.cov[some] if len(self.cov) else self.cov,
            given=self.given[some] if len(self.given) else self.given,
        )

    def solid(self, state: UnitState) -> Solid:
        """The solid of a state."""
        lengths = self.prior.leg_length + state.leg_errors
        return Solid(state.centre, state.rotation, self.legs, state.shape, lengths, state.opened, state.discs)

    def free(self, state: UnitState, *, hold_shape: bool = False) -> BoolArray:
        """(12,) which unknowns are adjusted: those not held fixed, and the leg lengths whose end discs are in use."""
        free = self.prior.sds > 0
        free[8:] = state.discs
        if hold_shape:
            free[6:8] = False
        return free

    def trimming(self, scale: float) -> tuple[float, float, float]:
        """Width left out along creases and rims, axial coordinate up to which a leg's cone is used, and over which its use fades, metres.

        Fillets, chamfers and rounded tips depart from the cones by a fraction of their width. Noise of that width hides them, and
        leaving points out then costs more than it saves: the trimming fades from a third of the width on. No cone is used where the noise
        carries points of its end to: those of an end disc that is not used lie inside it, bend it and shift the unit along its leg.
        """
        noise = scale * self.mean_sd
        if len(self.given) and not math.isfinite(self.tip):
            return self.edge, math.inf, noise
        share = 1.0 if self.options.edge is not None else min(max(1.5 * (1.0 - noise / self.edge), 0.0), 1.0)
        edge = self.edge * share
        # surfaces of which nothing is left out have no discs, and cones that the noise carries beyond their ends
        end = -END_IN_NOISE if math.isfinite(self.tip) else 1.0
        tip = min(self.unit.leg_length + end * noise, self.tip / max(share, 1e-9))
        return edge, tip, max(0.5 * edge, 2.0 * noise)


class Linearisation(NamedTuple):
    """One linearisation of a problem; its arrays are overwritten by the solver's next.

    Attributes
    ----------
    scale
        That residuals were standardised by.
    equations, points, sums
        See :mod:`.condition_records`.
    """

    scale: float
    equations: NormalEquations
    points: PointStates
    sums: Sums
