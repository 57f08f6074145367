"""Conditions of the points that belong to one leg's lateral surface beyond doubt: most do, and many are done at once."""

from __future__ import annotations

import math

from numba import njit

from .condition_records import BIAS, CLEAR, INLINED, LEG, RESIDUAL, SCORE, SINGLE, TIP, WEIGHT, Sums, X, Y, Z
from .residual_weights import FULL_WEIGHT, NO_WEIGHT, SCALE_NARROWING


@njit(**INLINED)
def clear_points(points, first, count, has_given, solid, cone, weighting, block):  # type: ignore[no-untyped-def]
    """Linearise ``count`` points with equal noise that belong to one leg's lateral surface beyond doubt, into the columns of ``block``.

    Most points do. Without a branch, so that eight are done at once; the others get a weight of zero and ``block[CLEAR]`` of zero, and are
    left to :func:`candidates`. Where ``has_given``, ``block[LEG]`` holds the legs. Returns the :class:`Sums` over these points.
    """
    centre, rotation, axes, ends, opened, discs = (
        solid.centre, solid.rotation, solid.legs.directions, solid.leg_lengths, solid.opened, solid.discs,
    )  # fmt: skip
    r, c, cosine = cone
    scale, tip, fade, edge = weighting.scale, weighting.tip, weighting.fade, weighting.edge
    square_correct = weighting.correct * weighting.correct
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
    at, beside, within = 8.0 * scale, 1.25 * edge * solid.legs.spread, max(8.0 * scale, 1.25 * edge)
    beyond = NO_WEIGHT * scale
    per_noise = 1.0 / scale
    windowed = 1.0 if weighting.redescend else 0.0
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
        k = block[LEG, i]
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
        block[TIP, i] = in_tip if e < beyond else 0.0
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
        block[WEIGHT, i] = w
        block[SCORE, i] = w * u
        # whether the point counts as one part's alone in the covariance
        single = counted if robust > 0.0 else 0.0
        block[SINGLE, i] = single
        block[X, i], block[Y, i], block[Z, i] = x, y, z
        block[LEG, i], block[CLEAR, i], block[RESIDUAL, i], block[BIAS, i] = k, clear, e, bias
        squares += narrow * u * u
        total_weight += narrow
        psi_squares += single * robust * robust * u * u
        slopes += single * (robust - size * 4.0 * v * (1.0 - v * v) / (NO_WEIGHT - FULL_WEIGHT))
        singles += single
    return Sums(squares, total_weight, psi_squares, slopes, singles)


@njit(**INLINED)
def keep_clear_point(task, place, i, j, left_out):  # type: ignore[no-untyped-def]
    """State of a point that :func:`clear_points` dealt with in column ``i``, or that belongs to no leg by what is given."""
    states, block = task.states, task.work.block
    states.legs[j] = -1 if left_out else int(block[LEG, i])
    states.residuals[j] = math.nan if left_out else block[RESIDUAL, i]
    states.biases[j] = 0.0 if left_out else block[BIAS, i]
    states.weights[j] = block[WEIGHT, i]
    states.at_tip[j] = block[TIP, i] > 0.0
    if task.weighting.final:
        e = block[RESIDUAL, i] * task.weighting.scale
        x, y, z = place
        states.feet[j, 0], states.feet[j, 1], states.feet[j, 2] = x + block[0, i] * e, y + block[1, i] * e, z + block[2, i] * e
        kept = block[SINGLE, i]
        for a in range(8):
            states.rows[j, a] = kept * block[a, i]
        for a in range(8, 12):
            states.rows[j, a] = 0.0
