"""The paper's model as printed (eqs. 5-7): two angles inside each leg's rotation and 120 degrees from leg 1 to the others.

A point X belongs to leg L where x = R1(q 120 deg + Omega) R3(p 120 deg + Psi) (X - Xc) satisfies x^2 + y^2 = (r - c z)^2. For Omega other
than zero the four legs are no longer a rigid body, so this fits only a unit standing on three legs. It is here to replicate the
paper's experiments and to compare; ``opening = "paper"`` in :mod:`tetratrack.core.adjustment.gauss_helmert` is the rigid form of the
same solid.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from tetratrack.core.adjustment.adjustment_records import MIN_POINTS
from tetratrack.core.adjustment.condition_records import NormalEquations, PointStates, Solid, Weighting, Work, leg_directions
from tetratrack.core.adjustment.cone_conditions import linearise_points
from tetratrack.core.common.arrays import FloatArray, IntArray
from tetratrack.core.common.errors import InputError
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.unit_types import UnitType

MAX_ITERATIONS = 60


@dataclass(frozen=True, eq=False)
class LiteralFit:
    """Result of :func:`fit_literal`; parameter order e, n, h, Omega, Psi, r, c (metres, radians).

    Attributes
    ----------
    centre
        (3,) metres.
    omega, psi
        Angles of eq. (5), radians.
    radius, gradient
        Shape of eq. (1).
    covariance
        (7, 7), for equal independent noise.
    noise
        Standard deviation of the residuals, metres.
    legs
        (n,) leg 0..3 of each point.
    residuals
        (n,) signed distance to the leg's cone, metres.
    converged
        Whether the last step was below 1 % of the parameters' standard deviations.
    """

    centre: FloatArray
    omega: float
    psi: float
    radius: float
    gradient: float
    covariance: FloatArray
    noise: float
    legs: IntArray
    residuals: FloatArray
    converged: bool

    @property
    def axes(self) -> FloatArray:
        """(4, 3) axes of the legs in the frame of the points."""
        return literal_axes(self.omega, self.psi)


def literal_rotations(omega: float, psi: float) -> FloatArray:
    """(4, 3, 3) rotations of eq. (5) for legs L = 1..4, with p and q of eqs. (6) and (7)."""
    rotations = []
    for leg in (1, 2, 3, 4):
        p = (abs(leg - 2) + (leg - 2)) / 2
        q = math.ceil((leg - 1) / 4)
        about_x, about_z = q * math.radians(120) + omega, p * math.radians(120) + psi
        r1 = np.array([[1, 0, 0], [0, math.cos(about_x), -math.sin(about_x)], [0, math.sin(about_x), math.cos(about_x)]])
        r3 = np.array([[math.cos(about_z), -math.sin(about_z), 0], [math.sin(about_z), math.cos(about_z), 0], [0, 0, 1]])
        rotations.append(r1 @ r3)
    return np.array(rotations)


def literal_axes(omega: float, psi: float) -> FloatArray:
    """(4, 3) unit vectors of the legs' axes, frame of the points: the third row of each leg's rotation."""
    return np.ascontiguousarray(literal_rotations(omega, psi)[:, 2, :])


def fit_literal(
    points: ArrayLike, unit: UnitType, centre: ArrayLike, omega: float, psi: float, *, legs: ArrayLike | None = None, unbiased: bool = False
) -> LiteralFit:
    """Fit the printed model by the iterated Gauss-Helmert adjustment with equal weights.

    Parameters
    ----------
    points
        (n, 3) metres in a reduced frame.
    unit
        Starting values of radius and gradient, and the leg length; its opening is not used.
    centre, omega, psi
        Starting values, metres and radians.
    legs
        (n,) known leg 0..3 of each point; None gives each point to its likeliest leg in every iteration.
    unbiased
        Remove the second-order bias, which the paper does not do.

    Raises
    ------
    InputError
        Fewer points than needed.
    """
    xyz = np.ascontiguousarray(points, dtype=np.float64)
    n = len(xyz)
    if n < MIN_POINTS:
        raise InputError(f"{n} points are too few to fit a unit", remedy=f"give at least {MIN_POINTS} points of one unit")
    known = None if legs is None else np.ascontiguousarray(legs, dtype=np.int64)
    middle = np.array(centre, dtype=np.float64)
    angles = np.array([omega, psi])
    shape = np.array([unit.radius, unit.gradient, unit.leg_length])
    scale = 0.02 * unit.height
    converged = False
    covariance = np.zeros((7, 7))
    owner, residuals = np.zeros(n, dtype=np.int64), np.zeros(n)
    for _ in range(MAX_ITERATIONS):
        owner = known if known is not None else _linearise(xyz, middle, angles, shape, np.zeros(0, dtype=np.int64), scale, 0.0)[2]
        normal, rhs = np.zeros((7, 7)), np.zeros(7)
        rotations = literal_rotations(*angles)
        for leg in range(4):
            alone = np.where(owner == leg, leg, -1)
            own_normal, own_rhs, _, own_residuals, biases = _linearise(xyz, middle, angles, shape, alone, scale, scale if unbiased else 0.0)
            residuals[alone >= 0] = (own_residuals - biases)[alone >= 0]
            turn = np.zeros((8, 7))
            turn[:3, :3] = np.eye(3)
            # Omega turns this leg about the x axis of eq. (5) after R3, Psi turns it about the z axis of the points' frame
            turn[3:6, 3] = -rotations[leg][0]
            turn[3:6, 4] = (0.0, 0.0, -1.0)
            turn[6:, 5:] = np.eye(2)
            normal += turn.T @ own_normal @ turn
            rhs += turn.T @ own_rhs
        covariance = np.linalg.inv(normal + 1e-12 * np.trace(normal) * np.eye(7))
        change = covariance @ rhs
        gain = float(rhs @ change)
        change *= min(
            1.0, 0.15 / max(float(np.max(np.abs(change[3:5]))), 1e-300), 0.25 * shape[0] / max(float(np.max(np.abs(change[:3]))), 1e-300)
        )
        middle = middle + change[:3]
        angles = angles + change[3:5]
        shape[:2] += change[5:]
        previous, scale = scale, max(float(np.sqrt(np.sum(residuals**2) / max(n - 7, 1))), 1e-7 * unit.height)
        if gain < 1e-4 and abs(scale - previous) < 1e-3 * previous:
            converged = True
            break
    return LiteralFit(
        middle, float(angles[0]), float(angles[1]), float(shape[0]), float(shape[1]), covariance, scale, owner, residuals, converged
    )


def literal_start(pose: Pose) -> tuple[float, float]:
    """Omega and Psi of eq. (5) nearest to a rigid pose: from the axis of leg 1 and the azimuth of leg 2, radians.

    Exact for a unit standing on three legs (leg 1 vertical); otherwise only a starting value.
    """
    leg_1, leg_2 = pose.rotation[:, 2], pose.rotation @ np.array([math.sin(math.radians(120)), 0.0, math.cos(math.radians(120))])
    # third row of R1(Omega) R3(Psi) is (sin Omega sin Psi, sin Omega cos Psi, cos Omega)
    omega = math.acos(float(np.clip(leg_1[2], -1, 1)))
    psi = math.atan2(float(leg_2[0]), float(leg_2[1]))
    return omega, psi


def _linearise(
    xyz: FloatArray, centre: FloatArray, angles: FloatArray, shape: FloatArray, given: IntArray, scale: float, correct: float
) -> tuple[FloatArray, FloatArray, IntArray, FloatArray, FloatArray]:
    """Normal matrix (8, 8) and right-hand side (8,) of :func:`.cone_conditions.linearise_points`, and legs, residuals and biases."""
    equations, points = NormalEquations.empty(), PointStates.empty(len(xyz))
    every, none = np.ones(4, dtype=np.bool_), np.zeros(4, dtype=np.bool_)
    solid = Solid(centre, np.eye(3), leg_directions(literal_axes(*angles)), shape, np.full(4, shape[2]), every, none)
    weighting = Weighting(scale=scale, correct=correct, tip=math.inf, fade=scale, edge=0.0, redescend=False, final=False)
    linearise_points(np.ascontiguousarray(xyz.T), np.zeros((0, 3, 3)), given, solid, weighting, equations, points, Work.empty())
    return equations.normal[:8, :8], equations.rhs[:8], points.legs, points.residuals, points.biases
