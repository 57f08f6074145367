"""Gauss-Helmert adjustment of four co-centred cones to the points of one unit (paper 2.3, eqs. 8-9).

The condition per point is f = x^2 + y^2 - (r - c z)^2 = 0 in the frame of its leg, or z = leg length on an end disc. It is
linearised at the *adjusted* observations until parameters and adjusted observations stand still (Foerstner and Wrobel, 2016,
Photogrammetric Computer Vision, 4.8; Lenzmann and Lenzmann, 2004, on why the one-step form is wrong). Divided by the length
of its gradient B, the misclosure there is the signed distance to the surface along the direction in which the noise acts.

Three things go beyond the textbook form, each to keep the estimate unbiased or its covariance honest:

- the second-order bias of distances to a curved surface is removed (Kanatani et al., 2016, Ellipse Fitting for Computer
  Vision, ch. 8): the component of the noise across the leg's generator lifts a point by half its variance times the curvature;
- a point near a crease belongs to both legs with the probabilities of a uniformly sampled surface under the noise. Weights
  that depend on the foot of the perpendicular only are independent of the residual, so the estimating equations keep mean zero;
- the covariance is the sandwich of an M-estimator (Huber, 1967), with the correlation between residuals of neighbouring points
  taken from the residuals themselves.
"""

from __future__ import annotations

import math
from copy import copy
from dataclasses import dataclass
from functools import lru_cache
from statistics import NormalDist
from typing import Literal

import numpy as np
from numba import njit
from numpy.typing import ArrayLike, NDArray

from .errors import InputError
from .kernels import COMPILED
from .pose import Pose
from .tetrapod import LATERAL
from .unit_types import Opening, UnitType

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

PARAMETERS = ("e", "n", "h", "omega_e", "omega_n", "omega_h", "r", "c")
FULL_WEIGHT, NO_WEIGHT = 2.5, 4.5
"""Standardised residuals up to which a point has full weight and from which it has none, with a biweight between (a three-part
redescending function after Hampel): 99 % efficient for normal noise and fully for bounded noise, where the plain biweight loses 8 %."""
SCALE_NARROWING = 0.8
"""The scale of the residuals is estimated with weights this much narrower: bad points five deviations away must not widen it."""
NONCENTRALITY = 4.13
"""Square root of the noncentrality of a test of one outlier with alpha = 0.1 % and power 80 % (Baarda, 1968)."""
LOST = math.pi / math.sqrt(3)
"""Standard deviation of a parameter of which nothing is known: in radians, an angle uniform over the full turn."""
DETERMINED = 0.5
"""A direction in parameter space counts as determined if its standard deviation is below this, in radians or leg lengths."""
MIN_POINTS = 8
EDGE_RATIO = 0.03
"""Width of the fillet along creases and of the chamfer around end discs that is left out, as a share of the height."""
TIP_RATIO = 0.87
"""Share of the leg up to which the cone of a real leg holds; its tip is rounded."""
APPROACH_SAMPLE = 250
"""Points with which the adjustment comes near before it uses all."""
CORRELATION_SAMPLE = 2500
"""Points among which the correlation of residuals is looked for; all pairs are formed."""
PAIR_SAMPLES = (500, 2000)
"""Points whose near pairs make the covariance, first to see whether correlation matters, then, if it does, for good: with 500 the sum
over pairs is itself so uncertain that 95 % regions hold 92 %."""
EXPECTED_SAMPLE = 64
"""Points whose pairs show what the fit makes of white noise."""
IMPOSSIBLE = 6.36
"""Standard deviations beyond its edge from which a point cannot lie on a surface (1e-10)."""
_CELLS = 12
"""Cells along each axis into which points are sorted to find near ones."""
_LAGS = 0.005 * np.array([0, 2, 4, 6, 9, 13, 18, 24])
"""Edges of the distance classes for that, as shares of the height."""
_CORRELATION_LENGTHS = np.tile(np.geomspace(0.01, 0.12, 10), 2)
_CORRELATION_EXPONENTS = np.repeat([1.0, 2.0], 10)
_USUAL_CORRELATION = 15
"""Forms of the covariance function that are tried, lengths as shares of the height; and the one taken where none stands out."""
_LAG_MIDDLES = 0.5 * (_LAGS[1:] + _LAGS[:-1])
_FORMS = np.exp(-((_LAG_MIDDLES / _CORRELATION_LENGTHS[:, None]) ** _CORRELATION_EXPONENTS[:, None]))
"""Value of each form in each distance class."""


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
        if self.edge is not None and self.edge < 0:
            raise ValueError("edge must not be negative")

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
        Whether the last step was below 5 % of the parameters' standard deviations, and how many were made.
    undetermined
        (k, 8) unit directions in parameter space (lengths in units of the leg length) that the points do not determine.
    legs_visible
        Number of legs whose lateral surface holds at least ``MIN_POINTS`` points and 1 % of the used points.
    flags
        Short statements for the user: ``one leg: twist about its axis undetermined``, ``two legs``, ...
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


_INLINED = COMPILED | {"inline": "always"}
"""Of the innermost functions: passing a dozen arrays costs as much as the work itself (measured: a third of a linearisation)."""
_BLOCK = 128
"""Points that are linearised together; what is known of them then stays in the nearest cache."""
_WEIGHT, _SCORE, _SINGLE, _X, _Y, _Z, _LEG, _CLEAR, _RESIDUAL, _BIAS, _TIP = range(8, 19)
_BLOCK_ROWS = 19
"""Rows of the work array of a block after the eight derivatives; a column is a point, or a further part that may own it."""


@njit(**COMPILED)  # type: ignore[untyped-decorator]
def _ramp(t: float) -> float:
    """0 up to 3/4 of an edge's width, 1 from 5/4: a hard limit would let points flip in and out for ever."""
    return min(max(2.0 * (t - 0.75), 0.0), 1.0)


@njit(**COMPILED)  # type: ignore[untyped-decorator]
def _robust_weight(u: float) -> tuple[float, float]:
    """Weight of a standardised residual, and the derivative of weight times residual."""
    v = (abs(u) - FULL_WEIGHT) / (NO_WEIGHT - FULL_WEIGHT)
    if v <= 0.0:
        return 1.0, 1.0
    if v >= 1.0:
        return 0.0, 0.0
    weight = (1.0 - v * v) ** 2
    return weight, weight - abs(u) * 4.0 * v * (1.0 - v * v) / (NO_WEIGHT - FULL_WEIGHT)


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


@njit(**COMPILED)  # type: ignore[untyped-decorator]
def _inside_probability(t: float) -> float:
    if t > 6.0:
        return 1.0
    if t < -IMPOSSIBLE:
        return 0.0
    return 0.5 * math.erfc(-t * 0.7071067811865476)


@njit(**_INLINED)
def _to_body(px, py, pz, centre, rotation):  # type: ignore[no-untyped-def]
    dx, dy, dz = px - centre[0], py - centre[1], pz - centre[2]
    x = rotation[0, 0] * dx + rotation[1, 0] * dy + rotation[2, 0] * dz
    y = rotation[0, 1] * dx + rotation[1, 1] * dy + rotation[2, 1] * dz
    z = rotation[0, 2] * dx + rotation[1, 2] * dy + rotation[2, 2] * dz
    return x, y, z


@njit(**_INLINED)
def _foot(x, y, z, leg, disc, axes, creases, r, c, cosine, end, cov, has_cov, near, found, j):  # type: ignore[no-untyped-def]
    """Adjusted observation of one point (body frame) on the lateral surface or end disc of one leg.

    ``found[j]`` receives the outward normal (0:3), signed distance (3), standard deviation along it for unit noise (4), axial coordinate
    of the foot (5), second-order bias for unit noise (6), distance of the foot inside the creases or, on a disc, inside the rim (7), and
    the foot itself (8:11). The distance to a crease is measured within the surface where it is below ``near``; beyond, it is a lower
    bound.
    """
    ax, ay, az = axes[leg, 0], axes[leg, 1], axes[leg, 2]
    fx, fy, fz = x, y, z
    nx = ny = nz = ux = uy = uz = e = 0.0
    variance = 1.0
    # with equal noise the first perpendicular is exact; an inclined noise ellipsoid needs the iteration of the adjusted observation
    turns = 8 if has_cov and not disc else 1
    for _ in range(turns):
        axial = fx * ax + fy * ay + fz * az
        ux, uy, uz = fx - axial * ax, fy - axial * ay, fz - axial * az
        rho = math.sqrt(ux * ux + uy * uy + uz * uz) + 1e-300
        inverse = 1.0 / rho
        ux *= inverse
        uy *= inverse
        uz *= inverse
        if disc:
            nx, ny, nz = ax, ay, az
            f = axial - end
        else:
            nx, ny, nz = (ux + c * ax) * cosine, (uy + c * ay) * cosine, (uz + c * az) * cosine
            f = (rho - r + c * axial) * cosine
        e = f + nx * (x - fx) + ny * (y - fy) + nz * (z - fz)
        if not has_cov:
            fx, fy, fz = x - nx * e, y - ny * e, z - nz * e
            break
        gx = cov[0, 0] * nx + cov[0, 1] * ny + cov[0, 2] * nz
        gy = cov[1, 0] * nx + cov[1, 1] * ny + cov[1, 2] * nz
        gz = cov[2, 0] * nx + cov[2, 1] * ny + cov[2, 2] * nz
        variance = gx * nx + gy * ny + gz * nz + 1e-300
        step = e / variance
        moved = abs(x - gx * step - fx) + abs(y - gy * step - fy) + abs(z - gz * step - fz)
        fx, fy, fz = x - gx * step, y - gy * step, z - gz * step
        if moved < 1e-7 * r:
            break
    axial = fx * ax + fy * ay + fz * az
    bias = 0.0
    if disc:
        inside = r - c * end - math.sqrt(max(fx * fx + fy * fy + fz * fz - axial * axial, 0.0))
    else:
        curvature = cosine / max(r - c * axial, 0.05 * r)
        if has_cov:
            # of the noise only the part that is independent of the residual moves the point along the curved surface
            tx, ty, tz = ay * uz - az * uy, az * ux - ax * uz, ax * uy - ay * ux
            sx = cov[0, 0] * tx + cov[0, 1] * ty + cov[0, 2] * tz
            sy = cov[1, 0] * tx + cov[1, 1] * ty + cov[1, 2] * tz
            sz = cov[2, 0] * tx + cov[2, 1] * ty + cov[2, 2] * tz
            across = sx * nx + sy * ny + sz * nz
            bias = 0.5 * curvature * (sx * tx + sy * ty + sz * tz - across * across / variance)
        else:
            bias = 0.5 * curvature
        inside = 1e300
        for m in range(4):
            if m == leg:
                continue
            qx, qy, qz = creases[leg, m, 0], creases[leg, m, 1], creases[leg, m, 2]
            away = fx * qx + fy * qy + fz * qz
            if away < near:
                # from the distance to the crease's plane to the distance within the surface
                slope = nx * qx + ny * qy + nz * qz
                away /= math.sqrt(max(1.0 - slope * slope, 0.05))
            inside = min(inside, away)
    found[j, 0], found[j, 1], found[j, 2], found[j, 3] = nx, ny, nz, e
    found[j, 4], found[j, 5], found[j, 6], found[j, 7] = math.sqrt(variance), axial, bias, inside
    found[j, 8], found[j, 9], found[j, 10] = fx, fy, fz


@njit(**_INLINED)
def _candidates(  # type: ignore[no-untyped-def]
    x, y, z, given, axes, creases, r, c, cosine, ends, cov, has_cov, opened, discs, noise, reach, edge, lean, found, which, density
):  # fmt: skip
    """Parts (0..3 lateral, 4..7 end discs) that may own a point into ``which``, the logarithm of its density under each into ``density``.

    ``noise`` is a factor on ``cov`` or metres, ``reach`` the largest standard deviation of the point in any direction, metres. Returns how
    many parts there are and the place of the likeliest among them; of the only one in question the density is not computed.
    """
    for k in range(4):
        lean[k] = x * axes[k, 0] + y * axes[k, 1] + z * axes[k, 2]
    nearest = given
    if given < 0:
        highest = -1e300
        for k in range(4):
            if opened[k] and lean[k] > highest:
                highest = lean[k]
                nearest = k
    # the creases are the planes of equal lean: a leg further off than the noise reaches cannot own the point
    least = lean[nearest] - 8.0 * reach
    # a distance to a crease beyond which neither membership nor the fillet depends on it
    near = min(max(1.25 * edge, 6.0 * reach), 0.5 * r)
    alone = not discs[nearest]
    for k in range(4):
        if given < 0 and k != nearest and opened[k] and lean[k] >= least:
            alone = False
    if alone:
        _foot(x, y, z, nearest, False, axes, creases, r, c, cosine, ends[nearest], cov, has_cov, near, found, nearest)
        which[0] = nearest
        density[0] = 0.0
        return (0 if given < 0 and found[nearest, 7] < -IMPOSSIBLE * noise * found[nearest, 4] else 1), 0
    square = x * x + y * y + z * z
    best = -1
    count = 0
    # a part this much further off in standard deviations, squared and halved, has no share in the point
    furthest = 1e300
    for turn in range(4):
        # the nearest leg first
        k = (nearest + turn) % 4
        if turn > 0:
            if given >= 0 or not opened[k] or lean[k] < least:
                continue
            if not has_cov and not discs[k]:
                rho = math.sqrt(max(square - lean[k] * lean[k], 0.0))
                u = (rho - r + c * lean[k]) * cosine / noise
                if 0.5 * u * u > furthest:
                    continue
        for disc in range(2):
            if disc == 1 and not discs[k]:
                continue
            j = k + 4 * disc
            _foot(x, y, z, k, disc == 1, axes, creases, r, c, cosine, ends[k], cov, has_cov, near, found, j)
            spread = max(noise * found[j, 4], 1e-300)
            share = 1.0
            if disc == 1 or given < 0:
                share = _inside_probability(found[j, 7] / spread)
            if disc == 0 and discs[k]:
                share *= _inside_probability((ends[k] - found[j, 5]) / spread)
            if share == 0.0:
                continue
            u = found[j, 3] / spread
            which[count] = j
            density[count] = -0.5 * u * u
            if share < 1.0:
                density[count] += math.log(share)
            if has_cov:
                # equal noise divides all densities by the same
                density[count] -= math.log(spread)
            if best < 0 or density[count] > density[best]:
                best = count
                furthest = 8.0 - density[count]
            count += 1
    return count, best


@njit(**_INLINED)
def _add_outer(matrix, row, factor, part):  # type: ignore[no-untyped-def]
    """Add ``factor`` times the outer product of a row of one part; of an end disc's unknown only what lies below the diagonal."""
    for a in range(8):
        p = factor * row[a]
        for b in range(8):
            matrix[a, b] += p * row[b]
    _add_disc(matrix, row, factor, part)


@njit(**_INLINED)
def _add_disc(matrix, row, factor, part):  # type: ignore[no-untyped-def]
    """Of an outer product only what an end disc's own unknown has in it, below the diagonal."""
    if part >= 4:
        p = factor * row[part + 4]
        matrix[part + 4, part + 4] += p * row[part + 4]
        for b in range(8):
            matrix[part + 4, b] += p * row[b]


@njit(**COMPILED)
def _add_products(block, count, weight, scaled, matrix):  # type: ignore[no-untyped-def]
    """Add the outer products of the rows of ``count`` columns, each times its value in row ``weight``, below the diagonal of a matrix.

    Along the points instead of point by point: vector registers then need no sum across them before the end.
    """
    for a in range(8):
        for i in range(count):
            scaled[i] = block[weight, i] * block[a, i]
        for b in range(a + 1):
            total = 0.0
            for i in range(count):
                total += scaled[i] * block[b, i]
            matrix[a, b] += total


@njit(**_INLINED)
def _clear_points(  # type: ignore[no-untyped-def]
    points, first, count, centre, rotation, axes, spread, r, c, cosine, ends, has_given, opened, discs, scale, square_correct, tip,
    fade, edge, redescend, block,
):  # fmt: skip
    """Linearise ``count`` points with equal noise that belong to one leg's lateral surface beyond doubt, into the columns of ``block``.

    Most points do. Without a branch, so that eight are done at once; the others get a weight of zero and ``block[_CLEAR]`` of zero, and are
    left to :func:`_candidates`. Where ``has_given``, ``block[_LEG]`` holds the legs. ``spread`` is the largest distance between the
    ends of two legs' directions. Returns the sums of :func:`linearise_points` over these points.
    """
    cx, cy, cz = centre[0], centre[1], centre[2]
    r00, r01, r02 = rotation[0, 0], rotation[0, 1], rotation[0, 2]
    r10, r11, r12 = rotation[1, 0], rotation[1, 1], rotation[1, 2]
    r20, r21, r22 = rotation[2, 0], rotation[2, 1], rotation[2, 2]
    x0, y0, z0 = axes[0, 0], axes[0, 1], axes[0, 2]
    x1, y1, z1 = axes[1, 0], axes[1, 1], axes[1, 2]
    x2, y2, z2 = axes[2, 0], axes[2, 1], axes[2, 2]
    x3, y3, z3 = axes[3, 0], axes[3, 1], axes[3, 2]
    end0, end1, end2, end3 = ends[0], ends[1], ends[2], ends[3]
    disc0, disc1, disc2, disc3 = 1.0 * discs[0], 1.0 * discs[1], 1.0 * discs[2], 1.0 * discs[3]
    open0, open1, open2, open3 = 1.0 * opened[0], 1.0 * opened[1], 1.0 * opened[2], 1.0 * opened[3]
    at, beside, within = 8.0 * scale, 1.25 * edge * spread, max(8.0 * scale, 1.25 * edge)
    beyond = NO_WEIGHT * scale
    per_noise = 1.0 / scale
    windowed = 1.0 if redescend else 0.0
    squares = total_weight = psi_squares = slopes = singles = 0.0
    px, py, pz = points[0, first : first + count], points[1, first : first + count], points[2, first : first + count]
    for i in range(count):
        dx, dy, dz = px[i] - cx, py[i] - cy, pz[i] - cz
        x = r00 * dx + r10 * dy + r20 * dz
        y = r01 * dx + r11 * dy + r21 * dz
        z = r02 * dx + r12 * dy + r22 * dz
        l0 = x * x0 + y * y0 + z * z0
        l1 = x * x1 + y * y1 + z * z1
        l2 = x * x2 + y * y2 + z * z2
        l3 = x * x3 + y * y3 + z * z3
        k = block[_LEG, i]
        if not has_given:
            k = 0.0
            k = 1.0 if l1 > l0 else k
            k = 2.0 if l2 > max(l0, l1) else k
            k = 3.0 if l3 > max(max(l0, l1), l2) else k
        own0, own1, own2, own3 = k == 0.0, k == 1.0, k == 2.0, k == 3.0
        ax = x1 if own1 else (x2 if own2 else (x3 if own3 else x0))
        ay = y1 if own1 else (y2 if own2 else (y3 if own3 else y0))
        az = z1 if own1 else (z2 if own2 else (z3 if own3 else z0))
        end = end1 if own1 else (end2 if own2 else (end3 if own3 else end0))
        disc = disc1 if own1 else (disc2 if own2 else (disc3 if own3 else disc0))
        usable = open1 if own1 else (open2 if own2 else (open3 if own3 else open0))
        lean = l1 if own1 else (l2 if own2 else (l3 if own3 else l0))
        ux, uy, uz = x - lean * ax, y - lean * ay, z - lean * az
        rho = math.sqrt(ux * ux + uy * uy + uz * uz) + 1e-300
        inverse = 1.0 / rho
        nx, ny, nz = (ux * inverse + c * ax) * cosine, (uy * inverse + c * ay) * cosine, (uz * inverse + c * az) * cosine
        e = (rho - r + c * lean) * cosine
        axial = lean - c * cosine * e
        # how much further the point, and its foot, reach along this leg than along any other
        f0 = -1e300 if own0 else l0 - e * (nx * x0 + ny * y0 + nz * z0)
        f1 = -1e300 if own1 else l1 - e * (nx * x1 + ny * y1 + nz * z1)
        f2 = -1e300 if own2 else l2 - e * (nx * x2 + ny * y2 + nz * z2)
        f3 = -1e300 if own3 else l3 - e * (nx * x3 + ny * y3 + nz * z3)
        foot_lead = axial - max(max(f0, f1), max(f2, f3))
        m0, m1 = -1e300 if own0 else l0, -1e300 if own1 else l1
        m2, m3 = -1e300 if own2 else l2, -1e300 if own3 else l3
        lead = lean - max(max(m0, m1), max(m2, m3))
        clear = 1.0 if has_given else usable
        if not has_given:
            clear = clear if lead >= at else 0.0
            clear = clear if foot_lead >= beside else 0.0
        clear_of_disc = (1.0 if end - max(lean, axial) >= within else 0.0) * (1.0 if abs(e) <= at else 0.0)
        clear *= max(1.0 - disc, clear_of_disc)
        # the limit of a leg without an end disc is a ramp too
        clear = clear if abs(axial - tip) >= 0.5 * fade else clear * disc
        gate = disc if axial > tip else 1.0
        in_tip = (1.0 - disc) if axial > tip else 0.0
        in_tip = in_tip if lean < end + beyond else 0.0
        block[_TIP, i] = in_tip if e < beyond else 0.0
        if has_given:
            # points that are left out are dealt with too
            clear = clear if k >= 0.0 else 1.0
            gate = gate if k >= 0.0 else 0.0
        bias = 0.5 * cosine / max(r - c * axial, 0.05 * r) * square_correct
        u = (e - bias) * per_noise
        size = abs(u)
        v = windowed * min(max((size - FULL_WEIGHT) / (NO_WEIGHT - FULL_WEIGHT), 0.0), 1.0)
        robust = (1.0 - v * v) * (1.0 - v * v)
        narrow = windowed * min(max((size / SCALE_NARROWING - FULL_WEIGHT) / (NO_WEIGHT - FULL_WEIGHT), 0.0), 1.0)
        narrow = (1.0 - narrow * narrow) * (1.0 - narrow * narrow)
        counted = clear * gate
        w = counted * robust
        narrow *= counted
        nx, ny, nz = nx * per_noise, ny * per_noise, nz * per_noise
        block[0, i], block[1, i], block[2, i] = -nx, -ny, -nz
        block[3, i], block[4, i], block[5, i] = ny * z - nz * y, nz * x - nx * z, nx * y - ny * x
        block[6, i] = -cosine * per_noise
        block[7, i] = axial * cosine * per_noise
        block[_WEIGHT, i] = w
        block[_SCORE, i] = w * u
        # whether the point counts as one part's alone in the covariance
        single = counted if robust > 0.0 else 0.0
        block[_SINGLE, i] = single
        block[_X, i], block[_Y, i], block[_Z, i] = x, y, z
        block[_LEG, i], block[_CLEAR, i], block[_RESIDUAL, i], block[_BIAS, i] = k, clear, e, bias
        squares += narrow * u * u
        total_weight += narrow
        psi_squares += single * robust * robust * u * u
        slopes += single * (robust - size * 4.0 * v * (1.0 - v * v) / (NO_WEIGHT - FULL_WEIGHT))
        singles += single
    return squares, total_weight, psi_squares, slopes, singles


@njit(**COMPILED)
def linearise_points(  # type: ignore[no-untyped-def]
    points, centre, rotation, axes, creases, spread, shape, ends, cov, given, opened, discs, scale, correct, tip, fade, edge, redescend,
    final, normal, rhs, plain, shared, shared_scores, legs, parts, residuals, sds, biases, weights, at_tip, rows, feet,
):  # fmt: skip
    """One linearisation: normal equations, right-hand side and the state of every point.

    ``points`` is (3, n); ``scale`` standardises residuals and is the noise for memberships, in metres where ``cov`` is None, else a factor
    on it; ``correct`` is the noise whose bias is removed; ``redescend`` asks for robust weights, ``final`` for what the covariance needs.
    The use of a leg's cone fades from one half of ``fade`` before ``tip`` to one half of it behind, metres along the leg.
    Of the 12 unknowns, shift and turn are along the axes of the body, and the last four are the errors of the leg lengths. ``normal`` and
    ``rhs`` make the Gauss-Newton step. For the covariance, points that belong to one part only enter ``plain``
    (their rows' outer products), the others ``shared`` (derivative of their scores) and ``shared_scores`` (outer products of these).
    ``at_tip`` tells of points in the unit's tips, which neither a cone nor an end disc in use describes.
    Returns the sum of squared residuals and the sum of weights that make the scale, and of the former points the sums of psi^2, of
    psi', and their number.
    """
    n = points.shape[1]
    r, c = shape[0], shape[1]
    has_cov = cov is not None
    has_given = given.shape[0] == n
    normal[:, :] = 0.0
    rhs[:] = 0.0
    if final:
        plain[:, :] = 0.0
        shared[:, :] = 0.0
        shared_scores[:, :] = 0.0
    body_cov = np.zeros((3, 3))
    found = np.zeros((8, 11))
    density = np.zeros(8)
    lean = np.zeros(4)
    which = np.zeros(8, dtype=np.int64)
    row = np.zeros(12)
    mean_score = np.zeros(12)
    # a column for every point, and one for each of up to eight parts that may own it; rows a power of two apart would share cache lines
    block = np.zeros((_BLOCK_ROWS, 9 * _BLOCK + 8))
    scaled = np.empty(9 * _BLOCK)
    cosine = 1.0 / math.sqrt(1.0 + c * c)
    square_correct = correct * correct
    reach = scale
    squares = total_weight = psi_squares = slopes = singles = 0.0
    for first in range(0, n, _BLOCK):
        members = min(_BLOCK, n - first)
        if has_cov:
            # an inclined noise ellipsoid needs the slower way
            block[_CLEAR, :members] = 0.0
            block[_WEIGHT, :members] = 0.0
            block[_SCORE, :members] = 0.0
            block[_SINGLE, :members] = 0.0
            for i in range(members):
                j = first + i
                block[_X, i], block[_Y, i], block[_Z, i] = _to_body(points[0, j], points[1, j], points[2, j], centre, rotation)
        else:
            if has_given:
                for i in range(members):
                    block[_LEG, i] = given[first + i]
            sums = _clear_points(
                points, first, members, centre, rotation, axes, spread, r, c, cosine, ends, has_given, opened, discs, scale,
                square_correct, tip, fade, edge, redescend, block,
            )  # fmt: skip
            squares += sums[0]
            total_weight += sums[1]
            psi_squares += sums[2]
            slopes += sums[3]
            singles += sums[4]
        columns = members
        for i in range(members):
            j = first + i
            parts[j] = 0
            sds[j] = 1.0
            at_tip[j] = False
            known = given[j] if has_given else -1
            left_out = has_given and known < 0
            x, y, z = block[_X, i], block[_Y, i], block[_Z, i]
            if block[_CLEAR, i] > 0.0 or left_out:
                legs[j] = -1 if left_out else int(block[_LEG, i])
                residuals[j] = math.nan if left_out else block[_RESIDUAL, i]
                biases[j] = 0.0 if left_out else block[_BIAS, i]
                weights[j] = block[_WEIGHT, i]
                at_tip[j] = block[_TIP, i] > 0.0
                if final:
                    e = block[_RESIDUAL, i] * scale
                    feet[j, 0], feet[j, 1], feet[j, 2] = x + block[0, i] * e, y + block[1, i] * e, z + block[2, i] * e
                    kept = block[_SINGLE, i]
                    for a in range(8):
                        rows[j, a] = kept * block[a, i]
                    for a in range(8, 12):
                        rows[j, a] = 0.0
                continue
            legs[j] = -1
            weights[j] = 0.0
            residuals[j] = math.nan
            biases[j] = 0.0
            if final:
                for a in range(12):
                    rows[j, a] = 0.0
            if has_cov:
                for a in range(3):
                    for b in range(3):
                        total = 0.0
                        for p in range(3):
                            for q in range(3):
                                total += rotation[p, a] * cov[j, p, q] * rotation[q, b]
                        body_cov[a, b] = total
                reach = scale * math.sqrt(body_cov[0, 0] + body_cov[1, 1] + body_cov[2, 2])
            count, likeliest = _candidates(
                x, y, z, known, axes, creases, r, c, cosine, ends, body_cov, has_cov, opened, discs, scale, reach, edge, lean, found, which,
                density,
            )  # fmt: skip
            if count == 0:
                continue
            best = which[likeliest]
            legs[j] = best % 4
            parts[j] = best // 4
            residuals[j] = found[best, 3]
            sds[j] = found[best, 4]
            biases[j] = found[best, 6] * square_correct
            if best < 4 and not discs[best] and found[best, 5] > tip:
                beyond = NO_WEIGHT * scale * found[best, 4]
                at_tip[j] = lean[best] < ends[best] + beyond and found[best, 3] < beyond
            total = 1.0
            for m in range(count):
                if m != likeliest and density[m] > density[likeliest] - 30.0:
                    total += math.exp(density[m] - density[likeliest])
            alone = total < 1.001
            if final:
                feet[j, 0], feet[j, 1], feet[j, 2] = found[best, 8], found[best, 9], found[best, 10]
                mean_score[:] = 0.0
            for candidate in range(count):
                if density[candidate] < density[likeliest] - 7.0:
                    continue
                k = which[candidate]
                share = 1.0 / total if k == best else math.exp(density[candidate] - density[likeliest]) / total
                leg = k % 4
                # edges are judged at the foot of the perpendicular, which says nothing about the residual
                gate = 1.0
                if edge > 0.0 and (k >= 4 or known < 0):
                    gate = _ramp(found[k, 7] / edge)
                if k < 4:
                    if discs[leg] and edge > 0.0:
                        gate *= _ramp((ends[leg] - found[k, 5]) / edge)
                    elif not discs[leg]:
                        gate *= min(max(0.5 + (tip - found[k, 5]) / fade, 0.0), 1.0)
                if gate == 0.0:
                    continue
                share *= gate
                per_noise = 1.0 / (scale * found[k, 4])
                u = (found[k, 3] - found[k, 6] * square_correct) * per_noise
                robust = 1.0
                slope = 1.0
                narrow = 1.0
                if redescend:
                    robust, slope = _robust_weight(u)
                    if robust == 0.0:
                        continue
                    narrow = _robust_weight(u / SCALE_NARROWING)[0]
                w = share * robust
                nx, ny, nz = found[k, 0] * per_noise, found[k, 1] * per_noise, found[k, 2] * per_noise
                row[0], row[1], row[2] = -nx, -ny, -nz
                row[3], row[4], row[5] = ny * z - nz * y, nz * x - nx * z, nx * y - ny * x
                row[6] = -cosine * per_noise if k < 4 else 0.0
                row[7] = found[k, 5] * cosine * per_noise if k < 4 else 0.0
                if k >= 4:
                    row[k + 4] = -per_noise
                    rhs[k + 4] += w * u * per_noise
                    _add_disc(normal, row, w, k)
                if k == best:
                    weights[j] = w
                    if final:
                        for m in range(8):
                            rows[j, m] = row[m]
                        if k >= 4:
                            rows[j, k + 4] = row[k + 4]
                squares += share * narrow * u * u
                total_weight += share * narrow
                if gate < 1.0:
                    alone = False
                for m in range(8):
                    block[m, columns] = row[m]
                block[_WEIGHT, columns] = w
                block[_SCORE, columns] = w * u
                block[_SINGLE, columns] = 1.0 if alone else 0.0
                columns += 1
                if not final:
                    continue
                if alone:
                    singles += 1.0
                    psi_squares += robust * robust * u * u
                    slopes += slope
                    _add_disc(plain, row, 1.0, k)
                else:
                    for a in range(8):
                        mean_score[a] += w * u * row[a]
                    if k >= 4:
                        mean_score[k + 4] += w * u * row[k + 4]
                    _add_outer(shared, row, share * slope - w * robust * u * u, k)
            if final and not alone:
                for a in range(12):
                    for b in range(a + 1):
                        product = mean_score[a] * mean_score[b]
                        shared[a, b] += product
                        shared_scores[a, b] += product
        _add_products(block, columns, _WEIGHT, scaled, normal)
        for a in range(8):
            total = 0.0
            for i in range(columns):
                total += block[_SCORE, i] * block[a, i]
            rhs[a] -= total
        if final:
            _add_products(block, columns, _SINGLE, scaled, plain)
    for a in range(12):
        for b in range(a):
            normal[b, a] = normal[a, b]
            if final:
                plain[b, a] = plain[a, b]
                shared[b, a] = shared[a, b]
                shared_scores[b, a] = shared_scores[a, b]
    return squares, total_weight, psi_squares, slopes, singles


@njit(**COMPILED)
def _row_excess(feet, legs, parts, weights, sds, rotation, axes, shape, cov, stride, out):  # type: ignore[no-untyped-def]
    """What the noise along the surface adds to the normal equations but not to what the points determine, into ``out`` (12, 12).

    Rows are taken at adjusted observations, which keep the noise along the surface, so legs look longer and better determining than
    they are. The second derivative of the distance, times the residual, cancels this in the expected derivative of the scores; both come
    to the noise variance times the outer product of the rows' derivatives (the errors-in-variables effect; 5 % of the variance where
    the noise is a tenth of the radius). A smooth sum, taken over every ``stride``-th point.
    """
    c = shape[1]
    cosine = 1.0 / math.sqrt(1.0 + c * c)
    has_cov = cov.shape[0] == feet.shape[0]
    shift, turn = np.zeros(12), np.zeros(12)
    taken = all_weight = 0.0
    for i in range(feet.shape[0]):
        all_weight += weights[i]
        if i % stride != 0 or weights[i] <= 0.0:
            continue
        taken += weights[i]
        ax, ay, az = axes[legs[i], 0], axes[legs[i], 1], axes[legs[i], 2]
        z = feet[i, 0] * ax + feet[i, 1] * ay + feet[i, 2] * az
        ux, uy, uz = feet[i, 0] - z * ax, feet[i, 1] - z * ay, feet[i, 2] - z * az
        rho = math.sqrt(ux * ux + uy * uy + uz * uz) + 1e-300
        ux, uy, uz = ux / rho, uy / rho, uz / rho
        tx, ty, tz = ay * uz - az * uy, az * ux - ax * uz, ax * uy - ay * ux
        lateral = parts[i] == 0
        along_t = along_g = 1.0
        if has_cov:
            n, g, t = np.array((ax, ay, az)), np.array((ux, uy, uz)), np.array((tx, ty, tz))
            if lateral:
                n, g = (g + c * n) * cosine, (n - c * g) * cosine
            body_cov = rotation.T @ cov[i] @ rotation
            spread = body_cov @ n
            variance = n @ spread
            along_t = t @ (body_cov @ t) - (t @ spread) ** 2 / variance
            along_g = g @ (body_cov @ g) - (g @ spread) ** 2 / variance
        p = weights[i] / (sds[i] * sds[i])
        shift[3], shift[4], shift[5] = -tx, -ty, -tz
        arm = 1.0
        if lateral:
            arm = cosine * (z - c * rho) / rho
            shift[7] = cosine * cosine
            turn[0], turn[1], turn[2] = -cosine * tx / rho, -cosine * ty / rho, -cosine * tz / rho
        else:
            shift[7] = turn[0] = turn[1] = turn[2] = 0.0
        turn[3], turn[4], turn[5] = arm * ux, arm * uy, arm * uz
        _add_outer(out, shift, p * along_g, 0)
        _add_outer(out, turn, p * along_t, 0)
    out *= all_weight / max(taken, 1.0)


@njit(**COMPILED)
def _turned(rotation, vector):  # type: ignore[no-untyped-def]
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


@njit(**COMPILED)
def _step(normal, rhs, free, scaling, prior_weights, nominal, leg_length, centre, rotation, shape, leg_errors, change):  # type: ignore[no-untyped-def]
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


@njit(**COMPILED)
def _scaled(matrix, chosen, scaling):  # type: ignore[no-untyped-def]
    """Rows and columns of a (12, 12) matrix by number, each times its unknown's scaling."""
    n = len(chosen)
    scaled = np.zeros((n, n))
    for a in range(n):
        for b in range(n):
            scaled[a, b] = matrix[chosen[a], chosen[b]] * scaling[chosen[a]] * scaling[chosen[b]]
    return scaled


@njit(**COMPILED)
def _guarded(correlated, noise_part, free, scaling):  # type: ignore[no-untyped-def]
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


@njit(**COMPILED)
def _inverse_root(matrix, prior_weights, free, scaling):  # type: ignore[no-untyped-def]
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


@njit(**COMPILED)
def _sandwich(white, scores, correlated):  # type: ignore[no-untyped-def]
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


@njit(**COMPILED)
def _sizes(residuals, biases, sds):  # type: ignore[no-untyped-def]
    """(n,) sizes of the standardised residuals, inf for points that belong to no part."""
    sizes = np.abs((residuals - biases) / sds)
    for i in range(len(sizes)):
        if math.isnan(sizes[i]):
            sizes[i] = math.inf
    return sizes


@njit(**COMPILED)
def _share_within(residuals, biases, sds, at_tip, limit):  # type: ignore[no-untyped-def]
    """Share of points whose standardised residual is below a limit, those in tips left out if they are not the most."""
    within = counted = 0
    for i in range(len(residuals)):
        if not at_tip[i]:
            counted += 1
            within += abs(residuals[i] - biases[i]) < limit * sds[i]
    return within / max(counted, len(residuals) // 2, 1)


@njit(**COMPILED)
def _redundancy(whitened, weights, legs, parts, sds, scale, numbers, detectable):  # type: ignore[no-untyped-def]
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


@njit(**COMPILED)
def _clear_counts(points, centre, rotation, axes, opened, sds, weights, legs, scale, enough):  # type: ignore[no-untyped-def]
    """(4,) number of points that belong to each leg beyond doubt: well used and far from the creases with other opened legs. Ends where
    all opened legs have ``enough``."""
    counts = np.zeros(4)
    lacking = np.sum(opened)
    for i in range(points.shape[0]):
        if lacking == 0:
            break
        if weights[i] <= 0.5:
            continue
        x, y, z = _to_body(points[i, 0], points[i, 1], points[i, 2], centre, rotation)
        highest = second = -1e300
        for k in range(4):
            if opened[k]:
                lean = x * axes[k, 0] + y * axes[k, 1] + z * axes[k, 2]
                if lean > highest:
                    highest, second = lean, highest
                elif lean > second:
                    second = lean
        if highest - second > 4.0 * scale * sds[i]:
            counts[legs[i]] += 1.0
            lacking -= enough <= counts[legs[i]] < enough + 1.0
    return counts


@njit(**COMPILED)
def _in_cells(points, chosen, size):  # type: ignore[no-untyped-def]
    """The chosen numbers of body-frame points in the order of cubic cells of the given size, and where each cell starts.

    Whatever is far out shares the outer cells.
    """
    n = len(chosen)
    cell = np.zeros(n, dtype=np.int64)
    starts = np.zeros(_CELLS**3 + 1, dtype=np.int64)
    for i in range(n):
        for d in range(3):
            place = int(min(max(points[chosen[i], d] / size + _CELLS // 2, 0.0), _CELLS - 1.0))
            cell[i] = cell[i] * _CELLS + place
        starts[cell[i] + 1] += 1
    for k in range(_CELLS**3):
        starts[k + 1] += starts[k]
    order = np.empty(n, dtype=np.int64)
    filled = starts.copy()
    for i in range(n):
        order[filled[cell[i]]] = chosen[i]
        filled[cell[i]] += 1
    return order, starts


@njit(**COMPILED)
def _near_ranges(starts):  # type: ignore[no-untyped-def]
    """(m, 4) ranges first, last, low, high such that every pair i < j of points in the same or touching cells, once, has i in the former
    and j in the latter."""
    ranges = np.empty((5 * _CELLS**3, 4), dtype=np.int64)
    count = 0
    for x in range(_CELLS):
        for y in range(_CELLS):
            for z in range(_CELLS):
                cell = (x * _CELLS + y) * _CELLS + z
                if starts[cell] == starts[cell + 1]:
                    continue
                for ox in range(x, min(x + 2, _CELLS)):
                    for oy in range(max(y - 1, 0) if ox > x else y, min(y + 2, _CELLS)):
                        # cells of one column follow one another, so that their points form one range
                        column = (ox * _CELLS + oy) * _CELLS
                        low = cell if ox == x and oy == y else column + max(z - 1, 0)
                        ranges[count, 0], ranges[count, 1] = starts[cell], starts[cell + 1]
                        ranges[count, 2], ranges[count, 3] = starts[low], starts[column + min(z + 2, _CELLS)]
                        count += 1
    return ranges[:count]


@njit(**COMPILED)
def _near(points, i, low, high, reach, near, squares):  # type: ignore[no-untyped-def]
    """Points low..high nearer than ``reach`` (squared) to point i into ``near`` and ``squares``; returns their number.

    Without a branch, since no processor can foresee which points are near.
    """
    count = 0
    x, y, z = points[i, 0], points[i, 1], points[i, 2]
    for j in range(max(low, i + 1), high):
        dx, dy, dz = x - points[j, 0], y - points[j, 1], z - points[j, 2]
        square = dx * dx + dy * dy + dz * dz
        near[count] = j
        squares[count] = square
        count += square < reach
    return count


@njit(**COMPILED)
def _add_below(squares, products, count, edges, sums, counts):  # type: ignore[no-untyped-def]
    """Add, for each of seven edges, the products whose squared distance lies below it to ``sums``, and how many they are to ``counts``.

    Comparing with every edge runs in vector registers, looking up the class of each pair does not.
    """
    e0, e1, e2, e3, e4, e5, e6 = edges[0], edges[1], edges[2], edges[3], edges[4], edges[5], edges[6]
    s0 = s1 = s2 = s3 = s4 = s5 = s6 = 0.0
    for h in range(count):
        square, product = squares[h], products[h]
        s0 += product if square < e0 else 0.0
        s1 += product if square < e1 else 0.0
        s2 += product if square < e2 else 0.0
        s3 += product if square < e3 else 0.0
        s4 += product if square < e4 else 0.0
        s5 += product if square < e5 else 0.0
        s6 += product if square < e6 else 0.0
    c0 = c1 = c2 = c3 = c4 = c5 = c6 = 0.0
    for h in range(count):
        square = squares[h]
        c0 += 1.0 if square < e0 else 0.0
        c1 += 1.0 if square < e1 else 0.0
        c2 += 1.0 if square < e2 else 0.0
        c3 += 1.0 if square < e3 else 0.0
        c4 += 1.0 if square < e4 else 0.0
        c5 += 1.0 if square < e5 else 0.0
        c6 += 1.0 if square < e6 else 0.0
    for k, (total, number) in enumerate(((s0, c0), (s1, c1), (s2, c2), (s3, c3), (s4, c4), (s5, c5), (s6, c6))):
        sums[k] += total
        counts[k] += number


@njit(**COMPILED)
def _lag_products(points, values, whitened, chosen, height, sums, expected, counts):  # type: ignore[no-untyped-def]
    """Products of residuals over all pairs of points by class of distance, and what the fit makes of white noise there."""
    reach = _LAGS[-1] * height
    edges = (_LAGS[1:] * height) ** 2
    order, starts = _in_cells(points, chosen, reach)
    n = len(order)
    x, y, z, value = np.empty(n), np.empty(n), np.empty(n), np.empty(n)
    for i in range(n):
        x[i], y[i], z[i], value[i] = points[order[i], 0], points[order[i], 1], points[order[i], 2], values[order[i]]
    # a cell's points and those after them in the cells around it
    around_x, around_y, around_z, around_value = np.empty(n), np.empty(n), np.empty(n), np.empty(n)
    number = np.empty(n, dtype=np.int64)
    squares, products, hats = np.empty(4 * n), np.empty(4 * n), np.empty(n)
    # what the fit makes of white noise is smooth in the distance: the pairs of some points are enough
    stride = max(1, n // EXPECTED_SAMPLE)
    unused = np.zeros(len(edges))
    ranges = _near_ranges(starts)
    taken = filled = 0
    while taken < len(ranges):
        first, last = ranges[taken, 0], ranges[taken, 1]
        m = 0
        while taken < len(ranges) and ranges[taken, 0] == first:
            low, high = ranges[taken, 2], ranges[taken, 3]
            for j in range(low, high):
                h = m + j - low
                around_x[h], around_y[h], around_z[h], around_value[h], number[h] = x[j], y[j], z[j], value[j], order[j]
            m += high - low
            taken += 1
        for i in range(first, last):
            start = i - first + 1
            count = m - start
            if filled + count > len(squares):
                _add_below(squares, products, filled, edges, sums, counts)
                filled = 0
            xi, yi, zi, vi = x[i], y[i], z[i], value[i]
            xs, ys, zs, vs = around_x[start:m], around_y[start:m], around_z[start:m], around_value[start:m]
            own_squares, own_products = squares[filled : filled + count], products[filled : filled + count]
            for h in range(count):
                dx, dy, dz = xi - xs[h], yi - ys[h], zi - zs[h]
                own_squares[h] = dx * dx + dy * dy + dz * dz
                own_products[h] = vi * vs[h]
            filled += count
            if i % stride == 0:
                for h in range(count):
                    hat = 0.0
                    for k in range(whitened.shape[1]):
                        hat += whitened[order[i], k] * whitened[number[start + h], k]
                    hats[h] = -stride * hat
                _add_below(own_squares, hats, count, edges, expected, unused)
    _add_below(squares, products, filled, edges, sums, counts)
    for k in range(len(edges) - 1, 0, -1):
        sums[k] -= sums[k - 1]
        expected[k] -= expected[k - 1]
        counts[k] -= counts[k - 1]


@njit(**COMPILED)
def _pair_products(points, rows, chosen, length, exponent, reach):  # type: ignore[no-untyped-def]
    """(12, 12) sum over pairs i != j of exp(-(distance / length)^exponent) times the outer product of their rows."""
    order, starts = _in_cells(points, chosen, reach)
    points, rows = points[order], rows[order]
    near, squares = np.empty(len(points) + 1, dtype=np.int64), np.empty(len(points) + 1)
    mixed = np.zeros(rows.shape)
    for first, last, low, high in _near_ranges(starts):
        for i in range(first, last):
            for h in range(_near(points, i, low, high, reach * reach, near, squares)):
                t = squares[h] / (length * length)
                correlation = math.exp(-t if exponent == 2.0 else -math.sqrt(t))
                for a in range(12):
                    mixed[i, a] += correlation * rows[near[h], a]
    once = rows.T @ mixed
    return once + once.T


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
        Points that are not finite, or fewer points near the unit than parameters.
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
        raise ValueError(f"legs must be ({n},) numbers 0..3, or -1")
    solver = _Solver(xyz, unit, pose, options, cov, given)
    if n <= 2 * APPROACH_SAMPLE:
        return solver.solve(solver.approach())
    some = slice(None, None, n // APPROACH_SAMPLE)
    rough = solver.sampled(some)
    scale = rough.approach()
    solver.restore(rough.state())
    return solver.solve(scale)


def beam_covariances(points: ArrayLike, sensors: ArrayLike, range_sd: float, angle_sd: float) -> FloatArray:
    """(n, 3, 3) covariance of points measured along beams, square metres.

    Parameters
    ----------
    points
        (n, 3) metres.
    sensors
        (3,) or (n, 3) position of the sensor at the time of each point, in the same frame.
    range_sd
        Standard deviation along the beam, metres.
    angle_sd
        Standard deviation of each of the two directions, radians.
    """
    beams = np.asarray(points, dtype=np.float64) - np.asarray(sensors, dtype=np.float64)
    ranges = np.linalg.norm(beams, axis=1)
    if (ranges == 0).any():
        raise ValueError("a point coincides with its sensor")
    directions = beams / ranges[:, None]
    along = directions[:, :, None] * directions[:, None, :]
    return np.asarray(range_sd**2 * along + ((angle_sd * ranges) ** 2)[:, None, None] * (np.eye(3) - along))


def planes_between_legs(axes: FloatArray) -> tuple[FloatArray, float]:
    """(4, 4, 3) unit normals of the planes between every two legs of (4, 3) directions, and the largest distance between two
    directions' ends."""
    between = axes[:, None] - axes[None]
    lengths = np.linalg.norm(between, axis=2, keepdims=True)
    return between / np.maximum(lengths, 1e-300), float(lengths.max())


@lru_cache
def _legs_of(opening: Opening) -> tuple[FloatArray, FloatArray, float]:
    """(4, 3) directions of the legs, and :func:`planes_between_legs`."""
    axes = np.ascontiguousarray(UnitType.tetrapod(1.0, opening=opening).leg_directions)
    return axes, *planes_between_legs(axes)


@lru_cache
def _size_at(share: float) -> float:
    """Size below which a share of standard normal variables lies."""
    return NormalDist().inv_cdf(0.5 * (1 + share))


class _Solver:
    """State of one adjustment; a class because its steps share a dozen work arrays."""

    def __init__(self, xyz: FloatArray, unit: UnitType, pose: Pose, options: AdjustmentOptions, cov: FloatArray, given: IntArray) -> None:
        self.unit, self.options = unit, options
        self.take(xyz, cov, given)
        self.centre, self.rotation = np.array(pose.centre), np.array(pose.rotation, dtype=np.float64, order="C")
        self.nominal = np.array([unit.radius, unit.gradient])
        self.shape = self.nominal.copy()
        self.leg_errors = np.zeros(4)
        self.axes, self.creases, self.spread = _legs_of(unit.opening)
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
        n = len(xyz)
        self.xyz, self.cov, self.given = xyz, cov, given
        self.columns = np.ascontiguousarray(xyz.T)
        self.legs, self.parts = np.zeros(n, dtype=np.int64), np.zeros(n, dtype=np.int64)
        self.residuals, self.sds, self.biases, self.weights = np.zeros(n), np.ones(n), np.zeros(n), np.zeros(n)
        self.at_tip = np.zeros(n, dtype=np.bool_)
        self.rows, self.feet = np.zeros((n, 12)), np.zeros((n, 3))

    def sampled(self, some: slice) -> _Solver:
        """A solver of some of the points that leaves this one's pose alone; the other work arrays are shared."""
        sample = copy(self)
        sample.take(np.ascontiguousarray(self.xyz[some]), np.ascontiguousarray(self.cov[some]), np.ascontiguousarray(self.given[some]))
        sample.restore(self.state())
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
            if self.weights.sum() < MIN_POINTS:
                raise InputError(
                    "too few points lie near the unit's surface to adjust it", remedy="check the approximate pose and the unit's height"
                )
            before, gain = gain, self.step()
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
            # steps shorten at a rate, so that the next one is known
            if gain < 0.25 and gain * min(gain / before, 1.0) < 2.5e-3 and settled:
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
        best: tuple[float, float, tuple[FloatArray, ...]] = (math.inf, math.inf, start)
        for window in (1.0, 0.4, 0.15) if self.options.robust else (1.0,):
            self.restore(start)
            scale = self.approach_through(window)
            # most points close, and those that belong very close
            misfit = self.quantile_scale(0.6) + scale
            if misfit < best[0]:
                best = misfit, scale, self.state()
            noise_alone = self.looks_like_noise(scale)
            if noise_alone:
                break
        self.restore(best[2])
        if noise_alone:
            return best[1]
        # from below: bad points just outside the window must not find it open
        return max(0.85 * best[1], self.options.sigma or self.floor)

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
        return self.centre.copy(), self.rotation.copy(), self.shape.copy(), self.leg_errors.copy()

    def restore(self, state: tuple[FloatArray, ...]) -> None:
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
        return scale * float(self.sds.mean()) < 0.01 * self.unit.height and self.share_within(scale) > 0.95

    def share_within(self, scale: float) -> float:
        """Share of the points inside the window of the robust weights; points in the tips, which fit nothing, do not count."""
        share: float = _share_within(self.residuals, self.biases, self.sds, self.at_tip, NO_WEIGHT * scale)
        return share

    def quantile_scale(self, share: float) -> float:
        """Scale of the residuals of all points, from the quantile of their sizes at ``share``."""
        u = _sizes(self.residuals, self.biases, self.sds)
        u.partition(int(share * len(u)))
        scale = float(u[int(share * len(u))]) / _size_at(share)
        # a known noise still needs a wide start while the pose is rough
        return min(max(scale, self.options.sigma or self.floor), 1e6 * self.unit.height)

    def refined_scale(self, scale: float, squares: float, weight_sum: float) -> float:
        if self.options.sigma is not None:
            return self.options.sigma
        if not self.options.robust:
            free = float(self.free().sum())
            return max(scale * math.sqrt(squares / max(weight_sum - free, 1.0)), self.floor)
        return max(scale * math.sqrt(squares / max(weight_sum, 1.0) / _SCALE_CONSISTENCY), self.floor)

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
        counts = _clear_counts(
            self.xyz, self.centre, self.rotation, self.axes, self.opened, self.sds, self.weights, self.legs, scale, enough
        )
        keep = self.opened & (counts >= enough)
        if not keep.any() or (keep == self.opened).all():
            return False
        self.opened, self.discs = keep, self.discs & keep
        return True

    def result(self, scale: float, sums: tuple[float, float], converged: bool, iterations: int) -> Adjustment:
        squares, weight_sum = sums
        free = self.free()
        slope = self.slopes / max(self.singles, 1.0)
        root, undetermined = _inverse_root(slope * self.plain + self.shared - self.row_excess(), self.prior_weights, free, self.scaling)
        white = root @ root.T
        used = self.weights > 0
        count = float(np.count_nonzero(used))
        small_sample = max(count, 1.0) / max(count - np.count_nonzero(free[:8]), 1.0)
        psi = small_sample * self.psi_squares / max(self.singles, 1.0)
        noise_part = psi * self.plain + small_sample * self.shared_scores
        prior = np.diag(self.prior_weights)
        whitened = self.rows @ root
        correlated = _guarded(self.correlated_part(white, whitened, psi), noise_part, free, self.scaling)
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
        noise = scale if self.options.sigma is None else scale * math.sqrt(squares / max(weight_sum, 1e-300) / self.consistency())
        visible = sum(number >= max(MIN_POINTS, 0.01 * count) for number in owned.tolist())
        mean_sd = math.sqrt(squared_sds / count) if count else math.nan
        a_priori = self.options.sigma or (1.0 if len(self.cov) else noise)
        return Adjustment(
            Pose(self.centre, self.rotation), float(self.shape[0]), float(self.shape[1]), covariance, noise / a_priori, noise * mean_sd,
            all_weight - influence, redundancy_numbers, detectable, self.weights.copy(), np.where(used, self.legs, -1),
            self.parts.copy(), self.residuals.copy(), all_weight / inflation, converged, iterations, undetermined, visible,
            _flags(visible, len(undetermined), count > 0 and not owned.any()),
        )  # fmt: skip

    def row_excess(self) -> FloatArray:
        """(12, 12) noise part of the normal equations; a smooth sum, taken over some of the points."""
        excess = np.zeros((12, 12))
        _row_excess(
            self.feet, self.legs, self.parts, self.weights, self.sds, self.rotation, self.axes, self.shape, self.cov,
            max(1, len(self.xyz) // APPROACH_SAMPLE), excess,
        )  # fmt: skip
        return excess

    def consistency(self) -> float:
        return _SCALE_CONSISTENCY if self.options.robust else 1.0

    def correlated_part(self, white: FloatArray, whitened: FloatArray, psi: float) -> FloatArray:
        """(12, 12) what the correlation between residuals of neighbouring points adds to the expected outer product of the scores.

        A covariance function s exp(-(h / l)^p), p = 1 or 2, is fitted to the products of residuals by distance; the form that stands
        out most is taken.
        """
        used = np.flatnonzero(self.weights > 0.05)
        nothing = np.zeros((12, 12))
        if len(used) < 10 * MIN_POINTS or psi <= 0:
            return nothing
        chosen = used[:: math.ceil(len(used) / CORRELATION_SAMPLE)]
        thinning = len(used) / len(chosen)
        u = (self.residuals - self.biases) / self.sds * self.weights
        u /= math.sqrt(float(np.mean(np.square(u[chosen]))))
        sums, expected, counts = (np.zeros(len(_LAGS) - 1) for _ in range(3))
        # distances between adjusted observations: those between noisy points depend on the residuals
        _lag_products(self.feet, u, whitened, chosen, self.unit.height, sums, expected, counts)
        if not counts.any():
            return nothing
        information = _FORMS**2 @ counts
        correlated, inflation = nothing, 1.0
        for most in PAIR_SAMPLES:
            # the fit takes a little of every pair's product away, the more the fewer independent points there are
            strengths = _FORMS @ (sums - inflation * expected) / information
            deviations = strengths * np.sqrt(information)
            best = int(np.argmax(deviations))
            if deviations[best] < 2.5:
                # what is too weak to show its form is taken at the length of a mould's roughness, less what chance alone gives
                best = _USUAL_CORRELATION
                strengths[best] -= 0.3 / math.sqrt(float(information[best]))
            strength = min(float(strengths[best]), 1.0)
            if strength <= 0:
                return nothing
            length, exponent = float(_CORRELATION_LENGTHS[best]) * self.unit.height, float(_CORRELATION_EXPONENTS[best])
            few = chosen[:: math.ceil(len(chosen) / most)]
            pairs = _pair_products(self.feet, self.rows, few, length, exponent, length * (4.0 if exponent == 1 else 2.2))
            correlated = strength * (len(used) / len(few)) ** 2 * pairs
            inflation = 1 + max(float(np.trace(white @ correlated)), 0.0) / max(float(np.trace(white @ self.plain)), 1.0)
            if inflation < 1.2:
                break
            # the covariance function itself is known from so many independent patches only (mean of an inverted Wishart distribution)
            neighbours = 2 * float(counts[self.unit.height * _LAG_MIDDLES < length].sum()) / len(chosen) * thinning
            patches = max(len(used) / (1 + neighbours), 2.0 * (len(PARAMETERS) + 1))
            correlated *= patches / (patches - len(PARAMETERS) - 1)
        return np.asarray(psi * correlated)


def _flags(visible: int, undetermined: int, discs_only: bool) -> tuple[str, ...]:
    flags = []
    if discs_only:
        flags.append("end discs only")
    if visible == 1:
        flags.append("one leg: twist about its axis undetermined")
    elif visible == 2:
        flags.append("two legs")
    if undetermined > (1 if visible == 1 else 0):
        flags.append(f"{undetermined} directions undetermined")
    return tuple(flags)
