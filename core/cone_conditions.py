"""Conditions of points on cones and end discs, linearised at the adjusted observations.

What one pass over the points of a unit gives the adjustment (:mod:`.gauss_helmert`): which part of which leg each point belongs to, how far
it lies from it, and what its condition adds to the normal equations. The loops that do this call one another, and numba's disk cache knows
a loop by the file of the outermost only: they stay together in this module.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from .kernels import COMPILED, kernel
from .unit_types import Opening, UnitType

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

PARAMETERS = ("e", "n", "h", "omega_e", "omega_n", "omega_h", "r", "c")
FULL_WEIGHT, NO_WEIGHT = 2.5, 4.5
"""Standardised residuals up to which a point has full weight and from which it has none, with a biweight between (a three-part
redescending function after Hampel): 99 % efficient for normal noise and fully for bounded noise, where the plain biweight loses 8 %."""
SCALE_NARROWING = 0.8
"""The scale of the residuals is estimated with weights this much narrower: bad points five deviations away must not widen it."""
IMPOSSIBLE = 6.36
"""Standard deviations beyond its edge from which a point cannot lie on a surface (1e-10)."""


_INLINED = COMPILED | {"inline": "always"}
"""Of the innermost functions: passing a dozen arrays costs as much as the work itself (measured: a third of a linearisation)."""
_BLOCK = 128
"""Points that are linearised together; what is known of them then stays in the nearest cache."""
_WEIGHT, _SCORE, _SINGLE, _X, _Y, _Z, _LEG, _CLEAR, _RESIDUAL, _BIAS, _TIP = range(8, 19)
_BLOCK_ROWS = 19
"""Rows of the work array of a block after the eight derivatives; a column is a point, or a further part that may own it."""


@kernel()
def _ramp(t: float) -> float:
    """0 up to 3/4 of an edge's width, 1 from 5/4: a hard limit would let points flip in and out for ever."""
    return min(max(2.0 * (t - 0.75), 0.0), 1.0)


@kernel()
def _robust_weight(u: float) -> tuple[float, float]:
    """Weight of a standardised residual, and the derivative of weight times residual."""
    v = (abs(u) - FULL_WEIGHT) / (NO_WEIGHT - FULL_WEIGHT)
    if v <= 0.0:
        return 1.0, 1.0
    if v >= 1.0:
        return 0.0, 0.0
    weight = (1.0 - v * v) ** 2
    return weight, weight - abs(u) * 4.0 * v * (1.0 - v * v) / (NO_WEIGHT - FULL_WEIGHT)


@kernel()
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


@kernel()
def _add_products(block: Any, count: Any, weight: Any, scaled: Any, matrix: Any) -> None:
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


@kernel()
def linearise_points(
    points: Any, centre: Any, rotation: Any, axes: Any, creases: Any, spread: Any, shape: Any, ends: Any, cov: Any, given: Any, opened: Any,
    discs: Any, scale: Any, correct: Any, tip: Any, fade: Any, edge: Any, redescend: Any, final: Any, normal: Any, rhs: Any, plain: Any,
    shared: Any, shared_scores: Any, legs: Any, parts: Any, residuals: Any, sds: Any, biases: Any, weights: Any, at_tip: Any, rows: Any,
    feet: Any,
) -> Any:  # fmt: skip
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


@kernel()
def _row_excess(
    feet: Any, legs: Any, parts: Any, weights: Any, sds: Any, rotation: Any, axes: Any, shape: Any, cov: Any, stride: Any, out: Any
) -> None:
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


def row_excess(
    feet: FloatArray, legs: IntArray, parts: IntArray, weights: FloatArray, sds: FloatArray, rotation: FloatArray, axes: FloatArray,
    shape: FloatArray, cov: FloatArray, stride: int,
) -> FloatArray:  # fmt: skip
    """(12, 12) noise part of the normal equations; a smooth sum, taken over every ``stride``-th point."""
    excess = np.zeros((12, 12))
    _row_excess(feet, legs, parts, weights, sds, rotation, axes, shape, cov, stride, excess)
    return excess


@kernel()
def clear_counts(
    points: Any, centre: Any, rotation: Any, axes: Any, opened: Any, sds: Any, weights: Any, legs: Any, scale: Any, enough: Any
) -> Any:
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


def planes_between_legs(axes: FloatArray) -> tuple[FloatArray, float]:
    """(4, 4, 3) unit normals of the planes between every two legs of (4, 3) directions, and the largest distance between two
    directions' ends."""
    between = axes[:, None] - axes[None]
    lengths = np.linalg.norm(between, axis=2, keepdims=True)
    return between / np.maximum(lengths, 1e-300), float(lengths.max())


@lru_cache
def legs_of(opening: Opening) -> tuple[FloatArray, FloatArray, float]:
    """(4, 3) directions of the legs, and :func:`planes_between_legs`."""
    axes = np.ascontiguousarray(UnitType.tetrapod(1.0, opening=opening).leg_directions)
    return axes, *planes_between_legs(axes)
