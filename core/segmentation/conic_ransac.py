"""RANSAC on conic features (paper 2.1): legs found as cones of known taper from pairs of oriented surface elements.

Two outward normals n1, n2 on a cone of gradient c both make the angle asin(c / sqrt(1 + c^2)) with the plane across the axis,
which leaves two axes; the two positions then give the cone's radius where the pair lies. Because the taper is small, a pair (or
a whole leg) fixes the axis as a line and the radius, but the centre along the axis only as (r - rho) / c: the assembly of legs
to units decides that (module ``assembly``).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from ..common.arrays import BoolArray, FloatArray, IntArray, corners
from ..common.kernels import in_parts, kernel
from ..common.least_axis import across
from ..common.neighbourhood import gather
from ..common.positive_definite import factorise, solve_factorised
from .scene import Scene

SEED_SPACING_RATIO = 0.08
"""Distance between the places where legs are looked for, as a share of the height."""
NEIGHBOURHOOD_RATIO = 0.26
"""Radius of the neighbourhood a leg is looked for in: less than the length of a leg's cone, 0.477 H."""
MOST_NEIGHBOURS = 110
"""Elements of a neighbourhood that are used; more cost time and find no other legs."""
PAIRS = 40
"""Pairs drawn in a neighbourhood: of elements half of which lie on one leg, all but one in 100 000 neighbourhoods draw a pair of these."""
MULTIPLIER, INCREMENT = np.uint64(6364136223846793005), np.uint64(1442695040888963407)
"""Of the linear congruential generator modulo 2^64 (Knuth's MMIX): its upper bits are random enough for draws."""
SWEEPS = 6
"""Steps of the least squares that settles a leg."""
SECTORS = 24
"""Parts of the turn about a leg's axis by which the seen arc is told."""
LEAST_ARC = 0.12
"""Share of the turn that must hold elements for a leg: below, a plane fits as well."""
FEWEST_ON_LEG = 10
"""Elements of a neighbourhood that must agree with a cone for a leg."""
LEAST_AGREEMENT = 0.85
"""Cosine of the largest angle between the normal of an element and that of the surface it lies on."""


class _NominalCone(NamedTuple):
    """Radius, gradient and length of a leg, and the radius of the neighbourhood it is looked for in; metres."""

    radius: float
    gradient: float
    length: float
    reach: float


@dataclass(frozen=True, eq=False, kw_only=True)
class Legs:
    """Leg hypotheses.

    Attributes
    ----------
    axis
        (k, 3) unit vectors from the unit's centre outward.
    centre
        (k, 3) the unit's centre as this leg alone sees it, metres, reduced frame.
    centre_sd
        (k,) standard deviation of that centre along the axis, metres.
    support
        (k,) number of surface elements of the neighbourhood that agree in place and normal, times the share they are of all
        elements near the cone.
    """

    axis: FloatArray
    centre: FloatArray
    centre_sd: FloatArray
    support: FloatArray


def find_legs(scene: Scene, active: BoolArray, seed: int) -> Legs:
    """Look for legs around seeds spread over the active elements.

    Parameters
    ----------
    active
        (m,) bool, elements not yet explained by an accepted unit.
    seed
        Of the random draws; every seed place has a stream of its own, so that the result does not depend on threads.
    """
    unit = scene.unit
    seeds = spread(scene.points, np.flatnonzero(active & (scene.curved >= 0)), SEED_SPACING_RATIO * unit.height)
    cone = _NominalCone(float(unit.radius), float(unit.gradient), float(unit.leg_length), NEIGHBOURHOOD_RATIO * unit.height)
    found = np.zeros((len(seeds), 8))
    passes = partial(
        _search,
        elements=scene.elements,
        active=active,
        seeds=seeds,
        grid=scene.grid,
        nominal=cone,
        tolerance=scene.tolerance,
        seed=seed,
        out=found,
    )
    in_parts(passes, len(seeds))
    good = found[:, 7] > 0
    order = np.argsort(-found[good, 7], kind="stable")
    found = found[good][order]
    kept = _distinct(found, 0.25 * unit.height, 0.08 * unit.height)
    found = found[kept]
    return Legs(axis=found[:, 0:3], centre=found[:, 3:6], centre_sd=found[:, 6], support=found[:, 7])


def spread(points: FloatArray, candidates: IntArray, spacing: float) -> IntArray:
    """One of the candidate indices for every occupied voxel of an edge of ``spacing`` metres: the one nearest the voxel's mean."""
    if not len(candidates):
        return candidates
    places = points[candidates]
    low, high = corners(places)
    key = np.floor((places - low) / spacing).astype(np.int64)
    size = np.floor((high - low) / spacing).astype(np.int64) + 1
    flat = (key[:, 0] * size[1] + key[:, 1]) * size[2] + key[:, 2]
    _, voxel, count = np.unique(flat, return_inverse=True, return_counts=True)
    mean = np.column_stack([np.bincount(voxel, weights=places[:, k]) for k in range(3)]) / count[:, None]
    away = np.sum((places - mean[voxel]) ** 2, axis=1)
    order = np.lexsort((away, voxel))
    first = np.concatenate([[0], np.cumsum(count)[:-1]])
    return np.asarray(candidates[order[first]])


@kernel()
def _count_on_cone(near: Any, axis: Any, foot: Any, rho: float, gradient: float, window: float) -> int:
    """Elements within ``window`` of a cone whose normals agree; rows of ``near``: position (3), normal (3), 1 where its sign is open."""
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    sine = gradient * cosine
    ax, ay, az = axis
    fx, fy, fz = foot
    count = 0
    # no branches and no products of arrays: the loop runs in vector registers
    for q in range(near.shape[1]):
        x, y, z = near[0, q] - fx, near[1, q] - fy, near[2, q] - fz
        t = x * ax + y * ay + z * az
        x, y, z = x - t * ax, y - t * ay, z - t * az
        rr = np.sqrt(x * x + y * y + z * z + 1e-18)
        away = (rr - rho + gradient * t) * cosine
        agree = (x * near[3, q] + y * near[4, q] + z * near[5, q]) / rr * cosine
        agree += sine * (ax * near[3, q] + ay * near[4, q] + az * near[5, q])
        agree = max(agree, -near[6, q] * agree)
        count += 1 if (abs(away) <= window) & (agree > LEAST_AGREEMENT) else 0
    return count


@kernel()
def _best_cone(near: Any, rho_low: float, rho_high: float, gradient: float, tolerance: float, state: Any, cone: Any) -> int:
    """Best cone through pairs of elements drawn at random into ``cone``: axis (3), foot (3), radius at the foot; returns its support."""
    m = near.shape[1]
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    sine = gradient * cosine
    best = 0
    for draw in range(PAIRS):
        # four elements of five on one cone: more draws will not find a better leg here
        if draw >= 10 and best > 0.8 * m:
            break
        state = state * MULTIPLIER + INCREMENT
        i = int((state >> np.uint64(33)) % np.uint64(m))
        state = state * MULTIPLIER + INCREMENT
        j = int((state >> np.uint64(33)) % np.uint64(m))
        if i == j:
            continue
        si = -1.0 if near[6, i] > 0.0 and (state >> np.uint64(20)) & np.uint64(1) else 1.0
        sj = -1.0 if near[6, j] > 0.0 and (state >> np.uint64(21)) & np.uint64(1) else 1.0
        n1x, n1y, n1z = si * near[3, i], si * near[4, i], si * near[5, i]
        n2x, n2y, n2z = sj * near[3, j], sj * near[4, j], sj * near[5, j]
        d = n1x * n2x + n1y * n2y + n1z * n2z
        if d > 0.90 or d < -0.90:
            continue
        alpha = sine / (1.0 + d)
        rest = 1.0 - 2.0 * sine * sine / (1.0 + d)
        if rest <= 0.0:
            continue
        beta = np.sqrt(rest / (1.0 - d * d))
        wx, wy, wz = n1y * n2z - n1z * n2y, n1z * n2x - n1x * n2z, n1x * n2y - n1y * n2x
        gx, gy, gz = near[0, i] - near[0, j], near[1, i] - near[1, j], near[2, i] - near[2, j]
        # the radial directions differ as the normals do
        dx, dy, dz = (n1x - n2x) / cosine, (n1y - n2y) / cosine, (n1z - n2z) / cosine
        dd = dx * dx + dy * dy + dz * dz
        for side in range(2):
            b = beta if side == 0 else -beta
            ax, ay, az = alpha * (n1x + n2x) + b * wx, alpha * (n1y + n2y) + b * wy, alpha * (n1z + n2z) + b * wz
            u1x, u1y, u1z = (n1x - sine * ax) / cosine, (n1y - sine * ay) / cosine, (n1z - sine * az) / cosine
            u2x, u2y, u2z = (n2x - sine * ax) / cosine, (n2y - sine * ay) / cosine, (n2z - sine * az) / cosine
            # p = foot + t axis + (rho0 - c t) u for both points, t from the seed's plane: the part across the axis gives rho0
            t1 = near[0, i] * ax + near[1, i] * ay + near[2, i] * az
            t2 = near[0, j] * ax + near[1, j] * ay + near[2, j] * az
            cx = gx - (t1 - t2) * ax + gradient * (t1 * u1x - t2 * u2x)
            cy = gy - (t1 - t2) * ay + gradient * (t1 * u1y - t2 * u2y)
            cz = gz - (t1 - t2) * az + gradient * (t1 * u1z - t2 * u2z)
            rho0 = (cx * dx + cy * dy + cz * dz) / dd
            if rho0 < 0.8 * rho_low or rho0 > 1.15 * rho_high:
                continue
            mx, my, mz = cx - rho0 * dx, cy - rho0 * dy, cz - rho0 * dz
            if mx * mx + my * my + mz * mz > 16.0 * tolerance * tolerance:
                continue
            out = rho0 - gradient * t1
            fx, fy, fz = near[0, i] - t1 * ax - out * u1x, near[1, i] - t1 * ay - out * u1y, near[2, i] - t1 * az - out * u1z
            count = _count_on_cone(near, (ax, ay, az), (fx, fy, fz), rho0, gradient, 1.5 * tolerance)
            if count > best:
                best = count
                cone[0], cone[1], cone[2] = ax, ay, az
                cone[3], cone[4], cone[5], cone[6] = fx, fy, fz, rho0
    return best


@kernel()
def _fit_cone(near: Any, gradient: float, tolerance: float, cone: Any) -> Any:
    """Least squares on the agreeing elements, in place: turn of the axis (2), shift across it (2), radius.

    Returns the support, the elements near the cone, the standard deviation of the radius and the share of the turn that holds support.
    """
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    sine = gradient * cosine
    normal = np.empty((5, 5))
    step = np.empty(5)
    # of each element: across the axis (2), and 1 if it is on the cone
    placed = np.empty((3, near.shape[1]))
    support = 0
    reached = 0
    for sweep in range(SWEEPS):
        ax, ay, az, fx, fy, fz, rho = cone[0], cone[1], cone[2], cone[3], cone[4], cone[5], cone[6]
        e1x, e1y, e1z, e2x, e2y, e2z = across(ax, ay, az)
        limit = tolerance * (2.0 if sweep < 2 else 1.2)
        n00 = n01 = n02 = n03 = n04 = n11 = n12 = n13 = n14 = n22 = n23 = n24 = n33 = n34 = 0.0
        r0 = r1 = r2 = r3 = r4 = 0.0
        squares = on_cone = near_cone = 0.0
        # weights of 0 and 1 in place of branches, and no integers: the loop runs in vector registers
        for q in range(near.shape[1]):
            x, y, z = near[0, q] - fx, near[1, q] - fy, near[2, q] - fz
            t = x * ax + y * ay + z * az
            y1 = x * e1x + y * e1y + z * e1z
            y2 = x * e2x + y * e2y + z * e2z
            rr = np.sqrt(y1 * y1 + y2 * y2 + 1e-18)
            away = (rr - rho + gradient * t) * cosine
            near_cone += 1.0 if (away > -3.0 * tolerance) & (away < 6.0 * tolerance) else 0.0
            nx, ny, nz = near[3, q], near[4, q], near[5, q]
            c1, c2 = y1 / rr, y2 / rr
            agree = (c1 * (e1x * nx + e1y * ny + e1z * nz) + c2 * (e2x * nx + e2y * ny + e2z * nz)) * cosine
            agree += sine * (ax * nx + ay * ny + az * nz)
            agree = max(agree, -near[6, q] * agree)
            w = 1.0 if (abs(away) <= limit) & (agree > LEAST_AGREEMENT) else 0.0
            placed[0, q], placed[1, q], placed[2, q] = y1, y2, w
            # turning the axis towards e1 by w moves the axis by w t: d(rr) = -c1 t w, d(t) = y1 w
            weight = w * cosine
            a0 = (gradient * y1 - c1 * t) * weight
            a1 = (gradient * y2 - c2 * t) * weight
            a2 = -c1 * weight
            a3 = -c2 * weight
            r0 -= a0 * away
            r1 -= a1 * away
            r2 -= a2 * away
            r3 -= a3 * away
            r4 += weight * away
            n00 += a0 * a0
            n01 += a0 * a1
            n02 += a0 * a2
            n03 += a0 * a3
            n04 -= a0 * weight
            n11 += a1 * a1
            n12 += a1 * a2
            n13 += a1 * a3
            n14 -= a1 * weight
            n22 += a2 * a2
            n23 += a2 * a3
            n24 -= a2 * weight
            n33 += a3 * a3
            n34 -= a3 * weight
            on_cone += w
            squares += w * away * away
        support, reached = int(on_cone), int(near_cone)
        if support < FEWEST_ON_LEG:
            break
        normal[0, 0] = n00
        normal[1, 0], normal[1, 1] = n01, n11
        normal[2, 0], normal[2, 1], normal[2, 2] = n02, n12, n22
        normal[3, 0], normal[3, 1], normal[3, 2], normal[3, 3] = n03, n13, n23, n33
        normal[4, 0], normal[4, 1], normal[4, 2], normal[4, 3] = n04, n14, n24, n34
        # a weak prior keeps the solution on the leg where the arc is short
        normal[4, 4] = support * cosine * cosine + 0.02 * support
        for a in range(5):
            normal[a, a] += 1e-12 + 1e-9 * normal[a, a]
        factorise(normal)
        if sweep == SWEEPS - 1:
            variance = max(squares / support, (0.2 * tolerance) ** 2) / normal[4, 4] ** 2
            sectors = 0
            for q in range(near.shape[1]):
                if placed[2, q] > 0.0:
                    sectors |= 1 << int((np.arctan2(placed[1, q], placed[0, q]) + np.pi) / (2 * np.pi) * (SECTORS - 1e-3))
            filled = 0
            for k in range(SECTORS):
                filled += (sectors >> k) & 1
            return support, reached, np.sqrt(max(variance, 0.0)), filled / SECTORS
        step[0], step[1], step[2], step[3], step[4] = r0, r1, r2, r3, r4
        solve_factorised(normal, step)
        turn = max(np.sqrt(step[0] ** 2 + step[1] ** 2), 1e-12)
        scale = min(1.0, 0.2 / turn)
        ax += scale * (step[0] * e1x + step[1] * e2x)
        ay += scale * (step[0] * e1y + step[1] * e2y)
        az += scale * (step[0] * e1z + step[1] * e2z)
        size = np.sqrt(ax * ax + ay * ay + az * az)
        cone[0], cone[1], cone[2] = ax / size, ay / size, az / size
        cone[3] = fx + scale * (step[2] * e1x + step[3] * e2x)
        cone[4] = fy + scale * (step[2] * e1y + step[3] * e2y)
        cone[5] = fz + scale * (step[2] * e1z + step[3] * e2z)
        cone[6] = rho + scale * step[4]
    return support, reached, 0.0, 0.0


@kernel(releases=True)
def _search(
    first: int, last: int, elements: Any, active: Any, seeds: Any, grid: Any, nominal: Any, tolerance: float, seed: int, out: Any
) -> None:
    """Leg about each seed into ``out`` (k, 8): axis (3), centre (3), its standard deviation along the axis, support; left at 0 where there
    is none."""
    points, normals, curved = elements
    radius, gradient, length, reach = nominal
    rho_low = (radius - gradient * length) * 0.93
    rho_high = radius * 0.97
    for s in range(first, last):
        middle = points[seeds[s]]
        found = gather(active, (middle[0], middle[1], middle[2]), reach, grid, np.int64(MOST_NEIGHBOURS))
        m = len(found)
        if m < 12:
            continue
        near = np.empty((7, m))
        for i in range(m):
            for a in range(3):
                near[a, i] = points[found[i], a] - middle[a]
                near[3 + a, i] = normals[found[i], a]
            near[6, i] = 0.0 if curved[found[i]] > 0 else 1.0
        cone = np.zeros(7)
        state = np.uint64(seed * 1000003 + seeds[s] * 7919 + 12345)
        if _best_cone(near, rho_low, rho_high, gradient, tolerance, state, cone) < FEWEST_ON_LEG:
            continue
        support, reached, sd_rho, arc = _fit_cone(near, gradient, tolerance, cone)
        # on a leg nearly every element near the cone is on it; where half are not, it is a chance alignment
        if support < FEWEST_ON_LEG or arc < LEAST_ARC or support < 0.4 * reached:
            continue
        # the seed's own height on the axis is t = 0 at the foot of the seed
        t0 = -(cone[3] * cone[0] + cone[4] * cone[1] + cone[5] * cone[2])
        rho_seed = cone[6] - gradient * t0
        if rho_seed < rho_low - 4 * sd_rho or rho_seed > rho_high + 4 * sd_rho:
            continue
        z = (radius - cone[6]) / gradient
        for a in range(3):
            out[s, a] = cone[a]
            out[s, 3 + a] = middle[a] + cone[3 + a] - z * cone[a]
        out[s, 6] = sd_rho / gradient
        out[s, 7] = support * support / reached


@kernel()
def _distinct(found: Any, along: float, across: float) -> Any:
    """Indices of hypotheses, strongest first, that are not near-copies of a stronger one."""
    kept = np.empty(len(found), dtype=np.int64)
    # axis and centre of those kept, one after the other
    stronger = np.empty((len(found), 6))
    count = 0
    far = along + across
    for i in range(len(found)):
        a0, a1, a2, c0, c1, c2 = found[i, 0], found[i, 1], found[i, 2], found[i, 3], found[i, 4], found[i, 5]
        copy = False
        for k in range(count):
            g0, g1, g2 = c0 - stronger[k, 3], c1 - stronger[k, 4], c2 - stronger[k, 5]
            if abs(g0) > far or abs(g1) > far or abs(g2) > far:
                continue
            b0, b1, b2 = stronger[k, 0], stronger[k, 1], stronger[k, 2]
            if a0 * b0 + a1 * b1 + a2 * b2 < 0.966:
                continue
            t = g0 * b0 + g1 * b1 + g2 * b2
            off = g0 * g0 + g1 * g1 + g2 * g2 - t * t
            if abs(t) < along and off < across * across:
                copy = True
                break
        if not copy:
            kept[count] = i
            for m in range(6):
                stronger[count, m] = found[i, m]
            count += 1
    return kept[:count]
