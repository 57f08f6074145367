"""Points of a unit as observations of its pose, its size and the offsets of strips: distances from its surface, and their sums."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from ..adjustment.shape_effects import CELLS, LEG_CELLS
from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.kernels import kernel
from ..model.mould import AXIAL_CELLS, AZIMUTH_CELLS, DISC_CELLS

THIN_SHARE = 0.25
"""Points of a patch over those of a patch of its sighting (median), below which it is left out: where a shadow begins few points of the
unit are left among mixed pixels and points of what casts it, and these lie there in every epoch."""

HALF_TURN = AZIMUTH_CELLS // 2
"""Cells around half a leg."""
EDGES = (np.cos(np.pi / HALF_TURN * np.arange(1, HALF_TURN)), np.sin(np.pi / HALF_TURN * np.arange(1, HALF_TURN)))
"""Cosines and sines of the turns at which they begin, but for the first."""


class Body(NamedTuple):
    """A unit where its points are observed, for compiled loops.

    Attributes
    ----------
    centre, rotation
        (3,) metres and (3, 3), body to the axes of the points.
    axes, across
        (4, 3) directions of the legs, and (2, 4, 3) two directions across each.
    discs
        (4,) whether the end of the leg is a plane that may be used.
    radius, gradient, length
        Of the cones in the unit's own size, metres.
    """

    centre: FloatArray
    rotation: FloatArray
    axes: FloatArray
    across: FloatArray
    discs: BoolArray
    radius: float
    gradient: float
    length: float


class StripObservations(NamedTuple):
    """Points of one sighting as observations at the present estimates.

    Attributes
    ----------
    rows
        (n, 7) derivatives of the distances by pose and scale; none where only distances were asked for.
    residuals
        (n,) distances, metres.
    patches
        (n,) patch of the surface; -1 for points that are left out.
    strips
        (n,) number of the strip or station.
    """

    rows: FloatArray
    residuals: FloatArray
    patches: IntArray
    strips: IntArray


def observations(
    points: FloatArray, strips: IntArray, offsets: FloatArray, body: Body, *, margin: float, tip: float, derived: bool = True
) -> StripObservations:
    """Observations of (n, 3) points of (n,) strips with (s, 3) offsets, metres.

    Points nearer to a crease than ``margin`` are left out, and so are those of patches that hold few; beyond ``tip`` along a leg the cone
    counts only if the end disc holds it.
    Without ``derived`` no derivatives are formed.
    """
    n = len(points)
    found = StripObservations(np.zeros((n if derived else 0, 7)), np.zeros(n), np.full(n, -1, dtype=np.int64), strips)
    _observe(np.ascontiguousarray(points, dtype=np.float64), strips, offsets, body, (margin, tip), found)
    leave_out_thin(found.patches, np.zeros(CELLS, dtype=np.int64))
    return found


@kernel(releases=True)
def leave_out_thin(patches: Any, counts: Any) -> None:
    """Leave out the points of patches that hold far fewer than those of their sighting do, in place; ``counts`` (CELLS,) are zeros."""
    for i in range(len(patches)):
        if patches[i] >= 0:
            counts[patches[i]] += 1
    # how many patches hold so many points, up to the middle of them
    held, patched = np.zeros(len(patches) + 1, dtype=np.int64), 0
    for k in range(len(counts)):
        if counts[k] > 0:
            held[counts[k]] += 1
            patched += 1
    usual, seen, points = 0.0, 0, 0
    while seen <= patched // 2 and seen < patched:
        points += 1
        # the mean of two in the middle of an even number
        for place in ((patched - 1) // 2, patched // 2):
            if seen <= place < seen + held[points]:
                usual += 0.5 * points
        seen += held[points]
    for i in range(len(patches)):
        if patches[i] >= 0 and counts[patches[i]] < THIN_SHARE * usual:
            patches[i] = -1


@kernel(releases=True)
def _observe(points: Any, strip: Any, offsets: Any, body: Any, limits: Any, found: Any) -> None:
    """Distances, rows and patch of every point of one sighting into ``found``; points nearer to a crease than the first of the limits are
    left out.

    Beyond the second of the limits along a leg, where tips are rounded, the cone counts only if the end disc holds it.
    """
    centre, rotation, axes, across, discs, r, c, length = body
    margin, tip = limits
    rows, residual, patch, _ = found
    cosines, sines = EDGES
    cosine = 1.0 / math.sqrt(1.0 + c * c)
    end_radius = r - c * length
    derived = rows.shape[0] > 0
    # x . (a_leg - a_k) is a difference of what is formed anyway: only what it is held against depends on the legs
    leans, least = np.zeros(4), np.zeros((4, 4))
    for leg in range(4):
        for k in range(4):
            if k != leg:
                qx, qy, qz = axes[leg, 0] - axes[k, 0], axes[leg, 1] - axes[k, 1], axes[leg, 2] - axes[k, 2]
                least[leg, k] = margin * math.sqrt(qx * qx + qy * qy + qz * qz)
    for i in range(points.shape[0]):
        s = strip[i]
        px = points[i, 0] - offsets[s, 0] - centre[0]
        py = points[i, 1] - offsets[s, 1] - centre[1]
        pz = points[i, 2] - offsets[s, 2] - centre[2]
        x = rotation[0, 0] * px + rotation[1, 0] * py + rotation[2, 0] * pz
        y = rotation[0, 1] * px + rotation[1, 1] * py + rotation[2, 1] * pz
        z = rotation[0, 2] * px + rotation[1, 2] * py + rotation[2, 2] * pz
        leg = 0
        axial = -1e300
        for k in range(4):
            leans[k] = x * axes[k, 0] + y * axes[k, 1] + z * axes[k, 2]
            if leans[k] > axial:
                axial, leg = leans[k], k
        patch[i] = -1
        # points at a crease may belong to either leg: left out, for their distance is biased
        at_crease = False
        for k in range(4):
            at_crease |= axial - leans[k] < least[leg, k]
        if at_crease:
            continue
        ax, ay, az = axes[leg, 0], axes[leg, 1], axes[leg, 2]
        ux, uy, uz = x - axial * ax, y - axial * ay, z - axial * az
        rho = math.sqrt(ux * ux + uy * uy + uz * uz) + 1e-300
        ux, uy, uz = ux / rho, uy / rho, uz / rho
        side = (rho - r + c * axial) * cosine
        end = axial - length
        # the nearer of both surfaces: a leg that is shorter than others has its whole end disc below the nominal one
        disc = end > side or end > -margin or (axial > tip and not discs[leg])
        if disc and (not discs[leg] or rho > end_radius - margin or end < side):
            continue
        first = ux * across[0, leg, 0] + uy * across[0, leg, 1] + uz * across[0, leg, 2]
        second = ux * across[1, leg, 0] + uy * across[1, leg, 1] + uz * across[1, leg, 2]
        if disc:
            turn = math.atan2(second, first) / (2.0 * math.pi)
            turn += 1.0 if turn < 0.0 else 0.0
            patch[i] = leg * LEG_CELLS + AXIAL_CELLS * AZIMUTH_CELLS + min(int(turn * DISC_CELLS), DISC_CELLS - 1)
            residual[i] = end
        else:
            # sectors of the nearer half-turn that begin before the point: quicker than its angle
            sector = 0
            if second < 0.0:
                sector, first, second = HALF_TURN, -first, -second
            for k in range(HALF_TURN - 1):
                sector += 1 if second * cosines[k] >= first * sines[k] else 0
            ring = min(max(int(axial / length * AXIAL_CELLS), 0), AXIAL_CELLS - 1)
            patch[i] = leg * LEG_CELLS + ring * AZIMUTH_CELLS + sector
            residual[i] = side
        if not derived:
            continue
        if disc:
            nx, ny, nz = ax, ay, az
            rows[i, 6] = -length
        else:
            nx, ny, nz = (ux + c * ax) * cosine, (uy + c * ay) * cosine, (uz + c * az) * cosine
            rows[i, 6] = -r * cosine
        mx, my, mz = ny * z - nz * y, nz * x - nx * z, nx * y - ny * x
        for m in range(3):
            rows[i, m] = -(rotation[m, 0] * nx + rotation[m, 1] * ny + rotation[m, 2] * nz)
            rows[i, m + 3] = rotation[m, 0] * mx + rotation[m, 1] * my + rotation[m, 2] * mz


@kernel(releases=True)
def kept_share(limit: Any) -> Any:
    """Share of a small departure from the middle of Tukey's window that a mean with its weights keeps, for normal points of which none is
    seen beyond ``limit`` standard deviations.

    It is also the share of their variance that the weights leave (Stein's lemma).
    """
    step = limit / 400
    mass = square = 0.0
    for i in range(400):
        u = (i + 0.5) * step
        w = (1.0 - (u / limit) ** 2) ** 2 * math.exp(-0.5 * u * u)
        mass += w
        square += w * u * u
    return square / mass


@kernel(releases=True)
def accumulate(seen: Any, window: Any, expected: Any, equations: Any, cells: Any, places: Any) -> int:
    """Add one sighting to its unit's normal equations and to its cells; returns the number of points with weight.

    Of a pose only the means of the cells speak: within a cell a casting is as uneven as it is from cell to cell, and how its points lie
    there, of which a dense cloud has thousands, would tell a turn that the shape of the casting makes. Strips speak through what they
    differ by within a cell, too.

    Parameters
    ----------
    seen
        :class:`StripObservations`.
    window
        Standard deviation of a point, metres, from how many of these on a point has no weight, and the share of a small departure from
        what is expected that weighted means keep (:func:`kept_share`), by which they are divided.
    expected
        (CELLS,) what the cells deviate by, metres.
    equations
        Normal matrix and right-hand side of the unit, which are added to.
    cells
        Sums by cell as in :class:`.shape_effects.CellSums`, which are added to.
    places
        Number of the sighting within the unit, number of the unit's pose unknowns, and (n,) the strip of each point among the unit's.
    """
    rows, residual, patch, _ = seen
    sigma, tukey, kept = window
    normal, rhs = equations
    patch_rows, patch_weight, patch_rhs, patch_square = cells
    body, n_pose, strip_local = places
    strips = (len(rhs) - n_pose - 1) // 3
    count = len(patch_weight)
    means, weights, distances = np.zeros((count, 7)), np.zeros((count, strips)), np.zeros((count, strips))
    used = 0
    for i in range(rows.shape[0]):
        if patch[i] < 0:
            continue
        u = (residual[i] - expected[patch[i]]) / (sigma * tukey)
        if abs(u) >= 1.0:
            continue
        w = (1.0 - u * u) ** 2 / (sigma * sigma)
        used += 1
        k = patch[i]
        for m in range(7):
            means[k, m] += w * rows[i, m]
        weights[k, strip_local[i]] += w
        distances[k, strip_local[i]] += w * residual[i]
        patch_weight[k] += w
        patch_rhs[k] -= w * residual[i]
        patch_square[k] += w * residual[i] * residual[i]
    for k in range(count):
        if patch_weight[k] == 0.0:
            continue
        total, mean = patch_weight[k], -patch_rhs[k] / patch_weight[k]
        within = max(patch_square[k] / total - mean * mean, 0.0) / kept
        for s in range(strips):
            distances[k, s] = weights[k, s] * expected[k] + (distances[k, s] - weights[k, s] * expected[k]) / kept
        mean = expected[k] + (mean - expected[k]) / kept
        patch_rhs[k], patch_square[k] = -total * mean, total * (within + mean * mean)
    index = np.zeros(10, dtype=np.int64)
    for m in range(6):
        index[m] = 6 * body + m
    index[6] = n_pose
    value = np.zeros(10)
    for k in range(count):
        if patch_weight[k] == 0.0:
            continue
        for m in range(10):
            # an offset moves all points of its strip as a shift of the unit does
            value[m] = means[k, m if m < 7 else m - 7] / patch_weight[k]
        for s in range(strips):
            if weights[k, s] == 0.0:
                continue
            for m in range(3):
                index[7 + m] = n_pose + 1 + 3 * s + m
            for a in range(10):
                wa = weights[k, s] * value[a]
                rhs[index[a]] -= distances[k, s] * value[a]
                patch_rows[k, index[a]] += wa
                for b in range(10):
                    normal[index[a], index[b]] += wa * value[b]
    return used
