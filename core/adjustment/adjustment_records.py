"""How a unit is adjusted, and what comes of it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from ..common.arrays import FloatArray, IntArray
from ..model.pose import Pose
from ..model.tetrapod import TIP_RATIO
from ..model.unit_types import UnitType

PARAMETERS = ("e", "n", "h", "omega_e", "omega_n", "omega_h", "r", "c")
LENGTH_SD = 0.003
"""Relative standard deviation of the length of legs as built (assumed: that of the units' sizes)."""
MIN_POINTS = 8
"""Points without which nothing is adjusted, and by which a leg or an end disc counts as seen."""


@dataclass(frozen=True, kw_only=True)
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
        Standard deviation of the distance from the centre to an end disc as built, metres; None for ``LENGTH_SD`` of it.
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


@dataclass(frozen=True, eq=False, kw_only=True)
class Adjustment:
    """Result of :func:`.gauss_helmert.adjust`. Parameter order e, n, h, omega_e, omega_n, omega_h, r, c (metres, radians).

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
