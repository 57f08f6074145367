"""Gauss-Helmert adjustment of four co-centred cones to the points of one unit (paper 2.3, eqs. 8-9).

The condition per point is f = x^2 + y^2 - (r - c z)^2 = 0 in the frame of its leg, or z = leg length on an end disc. It is
linearised at the *adjusted* observations until both parameters and adjusted observations stand still (Foerstner and Wrobel,
2016, Photogrammetric Computer Vision, 4.8; Lenzmann and Lenzmann, 2004, on why the one-step form is wrong). Divided by the
length of its gradient B, the condition's misclosure there is the signed distance to the surface, measured along the noise.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numba import njit
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation

from .errors import InputError
from .pose import Pose
from .tetrapod import END_DISC, LATERAL
from .unit_types import UnitType

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]

PARAMETERS = ("e", "n", "h", "omega_e", "omega_n", "omega_h", "r", "c")
TUKEY_CONSTANT = 4.685
"""Tuning constant of the biweight: 95 % efficiency at the normal distribution (Maronna et al., 2019, Robust Statistics, 2.4)."""
NONCENTRALITY = 4.13
"""sqrt(lambda0) of a test of one outlier with alpha = 0.1 % and power 80 % (Baarda, 1968)."""
LOST_TURN = math.pi / math.sqrt(3)
"""Standard deviation in radians of an angle of which nothing is known: uniform over the full turn."""
MIN_POINTS = 8


@dataclass(frozen=True)
class AdjustmentOptions:
    """How a unit is adjusted.

    Attributes
    ----------
    radius_sd, gradient_sd
        Standard deviation of the unit type's radius (metres) and gradient as prior observations: 0 holds the value
        fixed, inf leaves it free.
    sigma
        Known noise of one coordinate, metres, or factor on the given covariances; None estimates it.
    robust
        Redescending weights on standardised residuals; off for clean data with known legs.
    end_discs
        Use the planes at the ends of the legs: ``auto`` only on legs where the points show a plane at the nominal length.
    tip
        Share of the leg length up to which the cone holds; beyond it lateral points are left out (real legs have rounded tips
        beyond about 0.87). Given legs are left alone.
    joint
        Width in metres of the fillet along the creases between legs that is left out.
    bias_correction
        Remove the second-order bias of distances to a curved surface (radius too large by sigma^2 / 2r without it).
    max_iterations
        Limit of the Gauss-Newton iterations.
    """

    radius_sd: float = math.inf
    gradient_sd: float = math.inf
    sigma: float | None = None
    robust: bool = True
    end_discs: bool | Literal["auto"] = "auto"
    tip: float = 1.0
    joint: float = 0.0
    bias_correction: bool = True
    max_iterations: int = 60

    def __post_init__(self) -> None:
        if not (self.radius_sd >= 0 and self.gradient_sd >= 0):
            raise ValueError("radius_sd and gradient_sd must be 0 (fixed), positive (prior) or inf (free)")
        if self.sigma is not None and not self.sigma > 0:
            raise ValueError("sigma must be positive")
        if not 0 < self.tip <= 1:
            raise ValueError("tip is a share of the leg length, above 0 and at most 1")


@dataclass(frozen=True, eq=False)
class Adjustment:
    """Result of :func:`adjust`. Parameter order e, n, h, omega_e, omega_n, omega_h, r, c (metres, radians).

    Attributes
    ----------
    pose, radius, gradient
        Adjusted parameters, in the frame of the points.
    covariance
        (8, 8) with zero rows for what was held fixed. A direction the points do not determine has the variance of
        knowing nothing (an angle uniform over the turn, a centre anywhere along the leg) and is listed in ``undetermined``.
    sigma0
        Standard deviation of unit weight: noise over the given a priori noise (1 where none was given).
    noise
        Robust standard deviation of the residuals, metres.
    redundancy
        Effective observations less parameters.
    redundancy_numbers
        (n,) share of each residual that the others check; 0 for unused points.
    minimal_detectable_bias
        (n,) smallest error of one point, metres, found at alpha 0.1 % with power 80 %; inf for unused points.
    weights
        (n,) 0..1, robust weight times membership.
    legs, parts
        (n,) leg 0..3 or -1 for unused points; ``LATERAL`` or ``END_DISC``.
    residuals
        (n,) signed distance to the part, metres, positive outside; nan for points of no leg.
    n_effective
        Number of independent observations with the same information, after correlation between residuals.
    converged, iterations
        Whether the last step was below 1e-3 of the parameters' standard deviations, and how many were made.
    undetermined
        (k, 8) unit directions in parameter space (lengths in units of the leg length) that the points do not determine.
    legs_visible
        Number of legs with at least 3 % of the used points, and not fewer than eight.
    flags
        Short statements for the user: ``one leg: twist undetermined``, ``two legs``, ``end discs only``, ...
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
    flags: tuple[str, ...] = field(default=())

    def unit(self, unit: UnitType) -> UnitType:
        """The unit type with the adjusted radius and gradient."""
        return unit.with_shape(self.radius, self.gradient)


@njit(cache=True, fastmath=False)
def _normal_tail(t: float) -> float:
    return 0.5 * math.erfc(-t * 0.7071067811865476)


@njit(cache=True)
def _part(x, y, z, leg, disc, axes, r, c, length, cov, has_cov, out):  # type: ignore[no-untyped-def]
    """Foot of one point on the lateral surface or end disc of one leg.

    ``out`` receives normal (0:3), distance (3), sd factor (4), axial coordinate of the foot (5), second-order bias (6),
    distance of the foot inside the edge of the part (7), foot (8:11).
    """
    ax, ay, az = axes[leg, 0], axes[leg, 1], axes[leg, 2]
    cosine = 1.0 / math.sqrt(1.0 + c * c)
    fx, fy, fz = x, y, z
    nx = ny = nz = ux = uy = uz = 0.0
    e = 0.0
    variance = 1.0
    turns = 6 if has_cov and not disc else 1
    for _ in range(turns):
        axial = fx * ax + fy * ay + fz * az
        ux, uy, uz = fx - axial * ax, fy - axial * ay, fz - axial * az
        rho = math.sqrt(ux * ux + uy * uy + uz * uz) + 1e-300
        ux /= rho
        uy /= rho
        uz /= rho
        if disc:
            nx, ny, nz = ax, ay, az
            f = axial - length
        else:
            nx, ny, nz = (ux + c * ax) * cosine, (uy + c * ay) * cosine, (uz + c * az) * cosine
            f = (rho - r + c * axial) * cosine
        e = f + nx * (x - fx) + ny * (y - fy) + nz * (z - fz)
        if has_cov:
            gx = cov[0, 0] * nx + cov[0, 1] * ny + cov[0, 2] * nz
            gy = cov[1, 0] * nx + cov[1, 1] * ny + cov[1, 2] * nz
            gz = cov[2, 0] * nx + cov[2, 1] * ny + cov[2, 2] * nz
            variance = gx * nx + gy * ny + gz * nz + 1e-300
            new_x, new_y, new_z = x - gx * e / variance, y - gy * e / variance, z - gz * e / variance
        else:
            new_x, new_y, new_z = x - nx * e, y - ny * e, z - nz * e
        moved = abs(new_x - fx) + abs(new_y - fy) + abs(new_z - fz)
        fx, fy, fz = new_x, new_y, new_z
        if moved < 1e-9 * length:
            break
    axial = fx * ax + fy * ay + fz * az
    bias = 0.0
    if not disc:
        rho = max(r - c * axial, 0.05 * r)
        tx, ty, tz = ay * uz - az * uy, az * ux - ax * uz, ax * uy - ay * ux
        if has_cov:
            sx = cov[0, 0] * tx + cov[0, 1] * ty + cov[0, 2] * tz
            sy = cov[1, 0] * tx + cov[1, 1] * ty + cov[1, 2] * tz
            sz = cov[2, 0] * tx + cov[2, 1] * ty + cov[2, 2] * tz
            across = sx * nx + sy * ny + sz * nz
            bias = 0.5 * cosine / rho * (sx * tx + sy * ty + sz * tz - across * across / variance)
        else:
            bias = 0.5 * cosine / rho
    if disc:
        inside = r - c * length - math.sqrt(max(fx * fx + fy * fy + fz * fz - axial * axial, 0.0))
    else:
        inside = 1e30
        for m in range(4):
            if m != leg:
                qx, qy, qz = ax - axes[m, 0], ay - axes[m, 1], az - axes[m, 2]
                q = math.sqrt(qx * qx + qy * qy + qz * qz)
                lean = (fx * qx + fy * qy + fz * qz) / q
                slope = (nx * qx + ny * qy + nz * qz) / q
                lean /= math.sqrt(max(1.0 - slope * slope, 0.05))
                inside = min(inside, lean)
    out[0], out[1], out[2], out[3] = nx, ny, nz, e
    out[4], out[5], out[6], out[7] = math.sqrt(variance), axial, bias, inside
    out[8], out[9], out[10] = fx, fy, fz


@njit(cache=True)
def _pass(  # type: ignore[no-untyped-def]
    points,
    centre,
    rotation,
    axes,
    shape,
    cov,
    given,
    discs,
    scale,
    noise,
    tip,
    joint,
    tukey,
    normal,
    rhs,
    legs,
    parts,
    residuals,
    sds,
    biases,
    weights,
    rows,
):
    """One linearisation: normal equations, right-hand side and the state of every point.

    ``scale`` standardises residuals, ``noise`` is the coordinate noise (m or factor) for membership and bias; ``tukey`` 0
    switches robust weights off. Returns the weighted sum of squared standardised residuals and the sum of weights.
    """
    n = points.shape[0]
    r, c, length = shape[0], shape[1], shape[2]
    has_cov = cov.shape[0] == n
    normal[:, :] = 0.0
    rhs[:] = 0.0
    body_cov = np.zeros((3, 3))
    found = np.zeros((8, 11))
    density = np.zeros(8)
    row = np.zeros(8)
    cosine = 1.0 / math.sqrt(1.0 + c * c)
    square_sum = 0.0
    weight_sum = 0.0
    for i in range(n):
        legs[i] = -1
        parts[i] = 0
        weights[i] = 0.0
        residuals[i] = math.nan
        sds[i] = 1.0
        biases[i] = 0.0
        rows[i, :] = 0.0
        if given.shape[0] == n and given[i] < 0:
            continue
        px, py, pz = points[i, 0] - centre[0], points[i, 1] - centre[1], points[i, 2] - centre[2]
        x = rotation[0, 0] * px + rotation[1, 0] * py + rotation[2, 0] * pz
        y = rotation[0, 1] * px + rotation[1, 1] * py + rotation[2, 1] * pz
        z = rotation[0, 2] * px + rotation[1, 2] * py + rotation[2, 2] * pz
        if has_cov:
            body_cov[:, :] = rotation.T @ cov[i] @ rotation
        best = -1
        top = -1e300
        for k in range(8):
            density[k] = -1e300
        if given.shape[0] == n:
            leg = given[i]
            _part(x, y, z, leg, False, axes, r, c, length, body_cov, has_cov, found[leg])
            best = leg
            top = density[leg] = 0.0
        else:
            nearest = 0
            lean = -1e300
            for k in range(4):
                s = x * axes[k, 0] + y * axes[k, 1] + z * axes[k, 2]
                if s > lean:
                    lean = s
                    nearest = k
            for k in range(4):
                # a leg whose sector is further away than the noise reaches cannot own the point
                s = x * axes[k, 0] + y * axes[k, 1] + z * axes[k, 2]
                if k != nearest and lean - s > 8.0 * noise:
                    continue
                _part(x, y, z, k, False, axes, r, c, length, body_cov, has_cov, found[k])
                spread = max(noise * found[k, 4], 1e-12)
                if found[k, 7] < joint:
                    if k == nearest and found[k, 7] > -4.0 * spread and joint > 0.0:
                        top = 1e300
                    continue_membership = joint <= 0.0
                else:
                    continue_membership = True
                if found[k, 5] > tip or not continue_membership:
                    if not discs[k]:
                        continue
                inside = _normal_tail(found[k, 7] / spread)
                if discs[k]:
                    inside *= _normal_tail((length - found[k, 5]) / spread)
                if found[k, 5] <= tip and continue_membership and inside > 1e-12:
                    u = found[k, 3] / spread
                    density[k] = -0.5 * u * u + math.log(inside)
                if discs[k]:
                    _part(x, y, z, k, True, axes, r, c, length, body_cov, has_cov, found[k + 4])
                    spread = max(noise * found[k + 4, 4], 1e-12)
                    inside = _normal_tail(found[k + 4, 7] / spread)
                    if inside > 1e-12:
                        u = found[k + 4, 3] / spread
                        density[k + 4] = -0.5 * u * u + math.log(inside)
            if top == 1e300:
                continue
            for k in range(8):
                if density[k] > top:
                    top = density[k]
                    best = k
            if best < 0:
                continue
        total = 0.0
        for k in range(8):
            total += math.exp(max(density[k] - top, -700.0)) if density[k] > -1e299 else 0.0
        legs[i] = best % 4
        parts[i] = 1 if best >= 4 else 0
        residuals[i] = found[best, 3]
        sds[i] = found[best, 4]
        biases[i] = found[best, 6] * noise * noise
        for k in range(8):
            if density[k] <= -1e299:
                continue
            share = math.exp(max(density[k] - top, -700.0)) / total
            if share < 1e-4:
                continue
            e = found[k, 3] - found[k, 6] * noise * noise
            s = scale * found[k, 4]
            u = e / s
            w = share
            if tukey > 0.0:
                v = u / tukey
                w = share * (1.0 - v * v) ** 2 if abs(v) < 1.0 else 0.0
            if k == best:
                weights[i] = w
            square_sum += w * u * u
            weight_sum += w
            nx, ny, nz = found[k, 0], found[k, 1], found[k, 2]
            for m in range(3):
                row[m] = -(rotation[m, 0] * nx + rotation[m, 1] * ny + rotation[m, 2] * nz)
            mx, my, mz = ny * z - nz * y, nz * x - nx * z, nx * y - ny * x
            for m in range(3):
                row[m + 3] = rotation[m, 0] * mx + rotation[m, 1] * my + rotation[m, 2] * mz
            if k < 4:
                row[6] = -cosine
                row[7] = found[k, 5] * cosine
            else:
                row[6] = 0.0
                row[7] = 0.0
            if k == best:
                rows[i, :] = row
            p = w / (s * s)
            for a in range(8):
                rhs[a] -= p * row[a] * e
                for b in range(a + 1):
                    normal[a, b] += p * row[a] * row[b]
    for a in range(8):
        for b in range(a):
            normal[b, a] = normal[a, b]
    return square_sum, weight_sum


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
        (n, 3, 3) covariance of each point, square metres; None for equal isotropic noise. See :func:`beam_covariances`.
    legs
        (n,) known leg 0..3 of each point, -1 to leave it out; None lets the adjustment find it.

    Raises
    ------
    InputError
        Fewer usable points than parameters, or points that are not finite.
    """
    options = options or AdjustmentOptions()
    xyz = np.ascontiguousarray(points, dtype=np.float64)
    if xyz.ndim != 2 or xyz.shape[1] != 3:
        raise ValueError(f"points must be (n, 3), got {xyz.shape}")
    if not np.isfinite(xyz).all():
        raise InputError("points of a unit are not finite", remedy="remove points without coordinates")
    n = len(xyz)
    if n < MIN_POINTS:
        raise InputError(f"{n} points are too few to adjust a unit", remedy=f"give at least {MIN_POINTS} points of one unit")
    cov = np.zeros((0, 3, 3)) if covariances is None else np.ascontiguousarray(covariances, dtype=np.float64)
    if covariances is not None and cov.shape != (n, 3, 3):
        raise ValueError(f"covariances must be ({n}, 3, 3), got {cov.shape}")
    given = np.zeros(0, dtype=np.int64) if legs is None else np.ascontiguousarray(legs, dtype=np.int64)
    if legs is not None and (given.shape != (n,) or given.max(initial=0) > 3):
        raise ValueError("legs must be (n,) numbers 0..3, or -1")
    return _Solver(xyz, unit, pose, options, cov, given).solve()


class _Solver:
    """State of one adjustment; a class only because the passes share a dozen work arrays."""

    def __init__(self, xyz: FloatArray, unit: UnitType, pose: Pose, options: AdjustmentOptions, cov: FloatArray, given: IntArray) -> None:
        n = len(xyz)
        # the reduction to the centroid keeps the rotation's columns of the normal equations well scaled
        self.origin = xyz.mean(axis=0)
        self.xyz = np.ascontiguousarray(xyz - self.origin)
        self.unit, self.options, self.cov, self.given = unit, options, cov, given
        self.centre = np.array(pose.centre - self.origin)
        self.rotation = np.array(pose.rotation)
        self.shape = np.array([unit.radius, unit.gradient, unit.leg_length])
        self.axes = np.ascontiguousarray(unit.leg_directions)
        self.normal, self.rhs = np.zeros((8, 8)), np.zeros(8)
        self.legs, self.parts = np.zeros(n, dtype=np.int64), np.zeros(n, dtype=np.int64)
        self.residuals, self.sds, self.biases, self.weights = np.zeros(n), np.ones(n), np.zeros(n), np.zeros(n)
        self.rows = np.zeros((n, 8))
        self.discs = np.full(4, options.end_discs is True)
        self.free = np.array([True] * 6 + [options.radius_sd > 0, options.gradient_sd > 0])
        self.units = np.array([unit.leg_length] * 3 + [1.0] * 3 + [unit.leg_length, 1.0])

    def linearise(self, scale: float, noise: float, tukey: float) -> tuple[float, float]:
        square_sum, weight_sum = _pass(
            self.xyz, self.centre, self.rotation, self.axes, self.shape, self.cov, self.given, self.discs, scale, noise,
            self.options.tip * self.unit.leg_length if self.options.tip < 1 else math.inf, self.options.joint, tukey,
            self.normal, self.rhs, self.legs, self.parts, self.residuals, self.sds, self.biases, self.weights, self.rows,
        )  # fmt: skip
        for k, sd, nominal in ((6, self.options.radius_sd, self.unit.radius), (7, self.options.gradient_sd, self.unit.gradient)):
            if 0 < sd < math.inf:
                self.normal[k, k] += 1 / sd**2
                self.rhs[k] += (nominal - self.shape[k - 6]) / sd**2
        return square_sum, weight_sum

    def standardised(self) -> FloatArray:
        return (self.residuals - self.biases) / self.sds

    def robust_scale(self) -> float:
        u = np.abs(self.standardised())
        u = u[np.isfinite(u)]
        return float(1.4826 * np.median(u)) if len(u) else 0.0

    def decompose(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Eigenvalues, eigenvectors and scaling of the normal matrix of the free parameters, in like units."""
        scaling = self.units[self.free]
        values, vectors = np.linalg.eigh(self.normal[np.ix_(self.free, self.free)] * np.outer(scaling, scaling))
        return values, vectors, scaling

    def step(self) -> tuple[FloatArray, float]:
        values, vectors, scaling = self.decompose()
        usable = values > _RANK_LIMIT * values[-1]
        along = vectors.T @ (scaling * self.rhs[self.free])
        inner = np.where(usable, along / np.where(usable, values, 1.0), 0.0)
        # decrease of the target in units of its variance: below 1e-6 no parameter moves by 1e-3 of its deviation
        gain = float(np.sum(inner * along))
        change = np.zeros(8)
        change[self.free] = scaling * (vectors @ inner)
        size = max(
            np.linalg.norm(change[:3]) / (0.25 * self.unit.radius),
            np.linalg.norm(change[3:6]) / 0.15,
            abs(change[6]) / (0.1 * self.unit.radius),
            abs(change[7]) / 0.1,
            1.0,
        )
        return change / size, gain

    def move(self, change: FloatArray) -> None:
        turn = Rotation.from_rotvec(change[3:6]).as_matrix()
        self.centre = self.centre + change[:3]
        self.rotation = np.ascontiguousarray(turn @ self.rotation)
        u, _, vt = np.linalg.svd(self.rotation)
        self.rotation = np.ascontiguousarray(u @ vt)
        self.shape[:2] += change[6:]
        # a cone that closes before the end of the leg has no meaning; the step stays short of it
        self.shape[0] = max(self.shape[0], 0.2 * self.unit.radius)
        self.shape[1] = min(max(self.shape[1], 0.0), 0.95 * self.shape[0] / self.unit.leg_length)

    def solve(self) -> Adjustment:
        options = self.options
        floor = 1e-7 * self.unit.height
        tukey = TUKEY_CONSTANT if options.robust else 0.0
        self.linearise(1.0, 0.02 * self.unit.height if options.sigma is None else options.sigma, 0.0)
        scale = self._scale(floor)
        converged = False
        iteration = 0
        for iteration in range(1, options.max_iterations + 1):
            self.linearise(scale, scale, tukey)
            change, gain = self.step()
            self.move(change)
            new_scale = self._scale(floor)
            steady = abs(new_scale - scale) < 1e-3 * scale
            scale = new_scale
            if gain < 1e-6 and steady:
                converged = True
                break
        self.linearise(scale, scale, tukey)
        return self._result(scale, converged, iteration)

    def _scale(self, floor: float) -> float:
        if self.options.sigma is not None:
            # a known noise still needs a wide start while the pose is rough
            return max(self.options.sigma, floor)
        return max(self.robust_scale(), floor)

    def _result(self, scale: float, converged: bool, iterations: int) -> Adjustment:
        values, vectors, scaling = self.decompose()
        usable = values > _RANK_LIMIT * values[-1]
        lost = (scaling[:, None] * vectors[:, ~usable]).T
        kept = vectors[:, usable]
        cofactor = np.zeros((8, 8))
        cofactor[np.ix_(self.free, self.free)] = (kept / values[usable]) @ kept.T * np.outer(scaling, scaling)
        used = self.weights > 0
        weight_sum = float(self.weights.sum())
        parameters = int(self.free.sum()) - int((~usable).sum())
        noise = float(scale * np.sqrt(np.mean(self.sds[used] ** 2))) if used.any() else math.nan
        influence = self.weights / (scale * self.sds) ** 2 * np.einsum("ij,jk,ik->i", self.rows, cofactor, self.rows)
        redundancy_numbers = np.where(used, np.clip(1 - influence, 0, 1), 0.0)
        undetermined = np.zeros((len(lost), 8))
        undetermined[:, self.free] = lost / self.units[self.free]
        covariance = cofactor.copy()
        for direction in undetermined:
            full = direction * self.units
            covariance += LOST_TURN**2 * np.outer(full, full)
        n_effective = weight_sum
        with np.errstate(divide="ignore"):
            detectable = np.where(redundancy_numbers > 0, NONCENTRALITY * scale * self.sds / np.sqrt(redundancy_numbers), math.inf)
        counts = np.bincount(self.legs[used & (self.parts == LATERAL)], minlength=4)
        visible = int(np.sum(counts >= max(MIN_POINTS, 0.03 * used.sum())))
        flags = _flags(visible, undetermined, bool(used.any() and (self.parts[used] == END_DISC).all()))
        return Adjustment(
            Pose(self.centre + self.origin, self.rotation), float(self.shape[0]), float(self.shape[1]), covariance,
            1.0 if self.options.sigma is None else scale / self.options.sigma, noise, weight_sum - parameters, redundancy_numbers, detectable,
            self.weights.copy(), np.where(used, self.legs, -1), self.parts.copy(), self.residuals.copy(), n_effective, converged, iterations,
            undetermined, visible, flags,
        )  # fmt: skip


_RANK_LIMIT = 1e-10


def _flags(visible: int, undetermined: FloatArray, discs_only: bool) -> tuple[str, ...]:
    flags = []
    if discs_only:
        flags.append("end discs only")
    if visible == 1:
        flags.append("one leg: twist about its axis undetermined")
    elif visible == 2:
        flags.append("two legs")
    if len(undetermined) > (1 if visible == 1 else 0):
        flags.append(f"{len(undetermined)} directions undetermined")
    return tuple(flags)
