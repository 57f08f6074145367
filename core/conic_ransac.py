"""RANSAC on conic features (paper 2.1): legs found as cones of known taper from pairs of oriented surface elements.

Two outward normals n1, n2 on a cone of gradient c both make the angle asin(c / sqrt(1 + c^2)) with the plane across the axis,
which leaves two axes; the two positions then give the cone's radius where the pair lies. Because the taper is small, a pair (or
a whole leg) fixes the axis as a line and the radius, but the centre along the axis only as (r - rho) / c: the assembly of legs
to units decides that (module ``assembly``).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray

from .neighbourhood import Grid, gather
from .surface_elements import SurfaceElements
from .unit_types import UnitType

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

SEED_SPACING_RATIO = 0.08
"""Distance between the places where legs are looked for, as a share of the height."""
NEIGHBOURHOOD_RATIO = 0.26
"""Radius of the neighbourhood a leg is looked for in: less than the length of a leg's cone, 0.477 H."""
MOST_NEIGHBOURS = 110
PAIRS = 40


@dataclass(frozen=True, eq=False)
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


def find_legs(elements: SurfaceElements, active: NDArray[np.bool_], grid: Grid, unit: UnitType, tolerance: float, seed: int) -> Legs:
    """Look for legs around seeds spread over the active elements.

    Parameters
    ----------
    active
        (m,) bool, elements not yet explained by an accepted unit.
    grid
        Grid over ``elements.points``.
    tolerance
        Distance to the cone within which an element agrees, metres.
    seed
        Of the random draws; every seed place has a stream of its own, so that the result does not depend on threads.
    """
    seeds = spread(elements.points, np.flatnonzero(active), SEED_SPACING_RATIO * unit.height)
    sign = np.where(elements.oriented, 1, 0).astype(np.int8)
    found = _search(
        elements.points, elements.normals, sign, active, seeds, grid.start, grid.order, grid.origin, grid.size, grid.cell,
        NEIGHBOURHOOD_RATIO * unit.height, unit.radius, unit.gradient, unit.leg_length, tolerance, seed,
    )  # fmt: skip
    good = found[:, 7] > 0
    order = np.argsort(-found[good, 7], kind="stable")
    found = found[good][order]
    kept = _distinct(found, 0.25 * unit.height, 0.08 * unit.height)
    found = found[kept]
    return Legs(found[:, 0:3], found[:, 3:6], found[:, 6], found[:, 7])


def spread(points: FloatArray, candidates: IntArray, spacing: float) -> IntArray:
    """One of the candidate indices for every occupied voxel of an edge of ``spacing`` metres: the one nearest the voxel's mean."""
    if not len(candidates):
        return candidates
    key = np.floor((points[candidates] - points[candidates].min(axis=0)) / spacing).astype(np.int64)
    size = key.max(axis=0) + 1
    flat = (key[:, 0] * size[1] + key[:, 1]) * size[2] + key[:, 2]
    _, voxel, count = np.unique(flat, return_inverse=True, return_counts=True)
    mean = np.column_stack([np.bincount(voxel, weights=points[candidates, k]) for k in range(3)]) / count[:, None]
    away = np.sum((points[candidates] - mean[voxel]) ** 2, axis=1)
    order = np.lexsort((away, voxel))
    first = np.concatenate([[0], np.cumsum(count)[:-1]])
    return np.asarray(candidates[order[first]])


@njit(cache=True)
def _solve5(a: Any, b: Any) -> Any:
    for i in range(5):
        a[i, i] += 1e-12 + 1e-9 * a[i, i]
    return np.linalg.solve(a, b)


@njit(cache=True, parallel=True)
def _search(
    points: Any, normals: Any, sign: Any, active: Any, seeds: Any, start: Any, order: Any, origin: Any, size: Any, cell: float,
    reach: float, radius: float, gradient: float, length: float, tolerance: float, seed: int,
) -> Any:  # fmt: skip
    out = np.zeros((len(seeds), 8))
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    sine = gradient * cosine
    rho_low = (radius - gradient * length) * 0.93
    rho_high = radius * 0.97
    for s in prange(len(seeds)):
        near = gather(points, active, points[seeds[s]], reach, start, order, origin, size, cell, MOST_NEIGHBOURS)
        m = len(near)
        if m < 12:
            continue
        p = np.empty((m, 3))
        n = np.empty((m, 3))
        g = np.empty(m, dtype=np.int8)
        for i in range(m):
            for a in range(3):
                p[i, a] = points[near[i], a] - points[seeds[s], a]
                n[i, a] = normals[near[i], a]
            g[i] = sign[near[i]]
        state = np.uint64(seed * 1000003 + seeds[s] * 7919 + 12345)
        best = 0
        ax = np.zeros(3)
        foot = np.zeros(3)
        rho_at = 0.0
        for draw in range(PAIRS):
            # four elements of five on one cone: more draws will not find a better leg here
            if draw >= 10 and best > 0.8 * m:
                break
            state = state * np.uint64(6364136223846793005) + np.uint64(1442695040888963407)
            i = int((state >> np.uint64(33)) % np.uint64(m))
            state = state * np.uint64(6364136223846793005) + np.uint64(1442695040888963407)
            j = int((state >> np.uint64(33)) % np.uint64(m))
            if i == j:
                continue
            si = 1.0
            sj = 1.0
            if g[i] == 0 and (state >> np.uint64(20)) & np.uint64(1):
                si = -1.0
            if g[j] == 0 and (state >> np.uint64(21)) & np.uint64(1):
                sj = -1.0
            n1 = n[i] * si
            n2 = n[j] * sj
            d = n1[0] * n2[0] + n1[1] * n2[1] + n1[2] * n2[2]
            if d > 0.90 or d < -0.90:
                continue
            alpha = sine / (1.0 + d)
            rest = 1.0 - 2.0 * sine * sine / (1.0 + d)
            if rest <= 0.0:
                continue
            beta = np.sqrt(rest / (1.0 - d * d))
            w = np.cross(n1, n2)
            gap = p[i] - p[j]
            for side in range(2):
                b = beta if side == 0 else -beta
                axis = alpha * (n1 + n2) + b * w
                u1 = (n1 - sine * axis) / cosine
                u2 = (n2 - sine * axis) / cosine
                # p = foot + t axis + (rho0 - c t) u for both points, t from the seed's plane: the part across the axis gives rho0
                t1 = p[i, 0] * axis[0] + p[i, 1] * axis[1] + p[i, 2] * axis[2]
                t2 = p[j, 0] * axis[0] + p[j, 1] * axis[1] + p[j, 2] * axis[2]
                du = u1 - u2
                across = gap - (t1 - t2) * axis + gradient * (t1 * u1 - t2 * u2)
                duu = du[0] * du[0] + du[1] * du[1] + du[2] * du[2]
                rho0 = (across[0] * du[0] + across[1] * du[1] + across[2] * du[2]) / duu
                miss = across - rho0 * du
                if miss[0] ** 2 + miss[1] ** 2 + miss[2] ** 2 > 16.0 * tolerance * tolerance:
                    continue
                if rho0 < 0.8 * rho_low or rho0 > 1.15 * rho_high:
                    continue
                base = p[i] - t1 * axis - (rho0 - gradient * t1) * u1
                count = 0
                for q in range(m):
                    x = p[q] - base
                    t = x[0] * axis[0] + x[1] * axis[1] + x[2] * axis[2]
                    cr = x - t * axis
                    rr = np.sqrt(cr[0] ** 2 + cr[1] ** 2 + cr[2] ** 2)
                    dist = (rr - rho0 + gradient * t) * cosine
                    if dist > 1.5 * tolerance or dist < -1.5 * tolerance or rr < 1e-9:
                        continue
                    agree = ((cr[0] * n[q, 0] + cr[1] * n[q, 1] + cr[2] * n[q, 2]) / rr) * cosine
                    agree += sine * (axis[0] * n[q, 0] + axis[1] * n[q, 1] + axis[2] * n[q, 2])
                    if agree > 0.85 or (g[q] == 0 and agree < -0.85):
                        count += 1
                if count > best:
                    best = count
                    ax = axis.copy()
                    foot = base.copy()
                    rho_at = rho0
        if best < 10:
            continue
        # least squares on the agreeing elements: turn of the axis (2), shift across it (2), radius
        support = 0
        reached = 0
        sd_rho = 0.0
        arc = 0.0
        for sweep in range(6):
            help_axis = np.array([1.0, 0.0, 0.0]) if abs(ax[0]) < 0.8 else np.array([0.0, 1.0, 0.0])
            e1 = np.cross(ax, help_axis)
            e1 /= np.sqrt(np.sum(e1 * e1))
            e2 = np.cross(ax, e1)
            normal = np.zeros((5, 5))
            right = np.zeros(5)
            limit = tolerance * (2.0 if sweep < 2 else 1.2)
            support = 0
            reached = 0
            squares = 0.0
            sectors = 0
            row = np.empty(5)
            for q in range(m):
                x = p[q] - foot
                t = x[0] * ax[0] + x[1] * ax[1] + x[2] * ax[2]
                y1 = x[0] * e1[0] + x[1] * e1[1] + x[2] * e1[2]
                y2 = x[0] * e2[0] + x[1] * e2[1] + x[2] * e2[2]
                rr = np.sqrt(y1 * y1 + y2 * y2)
                if rr < 1e-9:
                    continue
                dist = (rr - rho_at + gradient * t) * cosine
                if -3.0 * tolerance < dist < 6.0 * tolerance:
                    reached += 1
                if abs(dist) > limit:
                    continue
                na = ax[0] * n[q, 0] + ax[1] * n[q, 1] + ax[2] * n[q, 2]
                n1_ = e1[0] * n[q, 0] + e1[1] * n[q, 1] + e1[2] * n[q, 2]
                n2_ = e2[0] * n[q, 0] + e2[1] * n[q, 1] + e2[2] * n[q, 2]
                agree = (y1 * n1_ + y2 * n2_) / rr * cosine + sine * na
                if not (agree > 0.85 or (g[q] == 0 and agree < -0.85)):
                    continue
                c1 = y1 / rr
                c2 = y2 / rr
                # turning the axis towards e1 by w moves the axis by w t: d(rr) = -c1 t w, d(t) = y1 w
                row[0] = (-c1 * t + gradient * y1) * cosine
                row[1] = (-c2 * t + gradient * y2) * cosine
                row[2] = -c1 * cosine
                row[3] = -c2 * cosine
                row[4] = -cosine
                for a in range(5):
                    right[a] -= row[a] * dist
                    for b_ in range(5):
                        normal[a, b_] += row[a] * row[b_]
                support += 1
                squares += dist * dist
                sectors |= 1 << int((np.arctan2(y2, y1) + np.pi) / (2 * np.pi) * 23.999)
            if support < 10:
                break
            # a weak prior keeps the solution on the leg where the arc is short
            normal[4, 4] += 0.02 * support
            step = _solve5(normal, right)
            if sweep == 5:
                inverse = np.linalg.inv(normal)
                sd_rho = np.sqrt(max(inverse[4, 4], 0.0) * max(squares / support, (0.2 * tolerance) ** 2))
                filled = 0
                for k in range(24):
                    filled += (sectors >> k) & 1
                arc = filled / 24.0
                break
            turn = max(np.sqrt(step[0] ** 2 + step[1] ** 2), 1e-12)
            scale = min(1.0, 0.2 / turn)
            ax = ax + scale * (step[0] * e1 + step[1] * e2)
            ax /= np.sqrt(np.sum(ax * ax))
            foot = foot + scale * (step[2] * e1 + step[3] * e2)
            rho_at += scale * step[4]
        # on a leg nearly every element near the cone is on it; where half are not, it is a chance alignment
        if support < 10 or arc < 0.12 or support < 0.4 * reached:
            continue
        # the seed's own height on the axis is t = 0 at the foot of the seed
        t0 = -(foot[0] * ax[0] + foot[1] * ax[1] + foot[2] * ax[2])
        rho_seed = rho_at - gradient * t0
        if rho_seed < rho_low - 4 * sd_rho or rho_seed > rho_high + 4 * sd_rho:
            continue
        z = (radius - rho_at) / gradient
        for a in range(3):
            out[s, a] = ax[a]
            out[s, 3 + a] = points[seeds[s], a] + foot[a] - z * ax[a]
        out[s, 6] = sd_rho / gradient
        out[s, 7] = support * support / reached
    return out


@njit(cache=True)
def _distinct(found: Any, along: float, across: float) -> Any:
    """Indices of hypotheses, strongest first, that are not near-copies of a stronger one."""
    kept = np.empty(len(found), dtype=np.int64)
    count = 0
    for i in range(len(found)):
        copy = False
        for k in range(count):
            j = kept[k]
            gap = found[i, 3:6] - found[j, 3:6]
            if abs(gap[0]) > along + across or abs(gap[1]) > along + across or abs(gap[2]) > along + across:
                continue
            cosine = found[i, 0] * found[j, 0] + found[i, 1] * found[j, 1] + found[i, 2] * found[j, 2]
            if cosine < 0.966:
                continue
            t = gap[0] * found[j, 0] + gap[1] * found[j, 1] + gap[2] * found[j, 2]
            off = gap[0] ** 2 + gap[1] ** 2 + gap[2] ** 2 - t * t
            if abs(t) < along and off < across * across:
                copy = True
                break
        if not copy:
            kept[count] = i
            count += 1
    return kept[:count]
