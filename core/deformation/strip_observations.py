"""Points of a unit as observations of its pose, its size and the offsets of strips: distances from its surface, and their sums."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from ..adjustment.shape_effects import CELLS, LEG_CELLS
from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.kernels import kernel
from ..common.robust import MAD_TO_SD
from ..model.mould import AXIAL_CELLS, AZIMUTH_CELLS, DISC_CELLS

THIN_SHARE = 0.25
"""Points of a patch over those of a patch of its sighting (median), below which it is left out: where a shadow begins few points of the
unit are left among mixed pixels and points of what casts it, and these lie there in every epoch."""

FEWEST_POINTS = 10
"""Points of a sighting that tell of noise, and ``FEWEST_ON_PATCH`` on a patch."""
FEWEST_ON_PATCH = 4

HALF_TURN = AZIMUTH_CELLS // 2
"""Cells around half a leg."""
EDGES = (np.cos(np.pi / HALF_TURN * np.arange(1, HALF_TURN)), np.sin(np.pi / HALF_TURN * np.arange(1, HALF_TURN)))
"""Cosines and sines of the turns at which they begin, but for the first."""

TOGETHER = 128
"""Points that are observed at once."""
X, Y, Z, ALONG, AXIAL, LEG, FIRST, SECOND, HELD, SIDE, KEPT, SECTOR, SCRATCH = (TOGETHER * k for k in (*range(4), *range(7, 16)))
"""Where what is known of them lies: one array, so that it is seen that no two overlap and loops run in vector registers."""


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
        (n, 7) derivatives of the distances by pose and scale, of points that are not left out; none where only distances were asked for.
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
    found = StripObservations(np.empty((n if derived else 0, 7)), np.zeros(n), np.empty(n, dtype=np.int64), strips)
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
    centre, rotation = body[:2]
    margin, tip = limits
    # leaning along k by so much less than along the nearest leg
    least = np.full((4, 4), -1.0)
    for leg in range(4):
        for k in range(4):
            if k != leg:
                square = 0.0
                for m in range(3):
                    square += (body[2][leg, m] - body[2][k, m]) ** 2
                least[leg, k] = margin * math.sqrt(square)
    s = np.empty(SCRATCH)
    cx, cy, cz = centre[0], centre[1], centre[2]
    for begin in range(0, len(points), TOGETHER):
        count = min(TOGETHER, len(points) - begin)
        for i in range(count):
            k = strip[begin + i]
            s[AXIAL + i] = points[begin + i, 0] - offsets[k, 0] - cx
            s[FIRST + i] = points[begin + i, 1] - offsets[k, 1] - cy
            s[SECOND + i] = points[begin + i, 2] - offsets[k, 2] - cz
        for m in range(3):
            a, b, c, to = rotation[0, m], rotation[1, m], rotation[2, m], X + m * TOGETHER
            for i in range(count):
                s[to + i] = a * s[AXIAL + i] + b * s[FIRST + i] + c * s[SECOND + i]
        _nearest_legs(count, body, s)
        _on_surface(count, body, margin, tip, least, s)
        _write(begin, count, body, s, found)


@kernel(makes_arrays=False)
def _nearest_legs(count: int, body: Any, s: Any) -> None:
    """How far points lie along each leg, and of the one along which they lie farthest its number, both coordinates across it, and whether
    its end disc may be used."""
    axes, across, discs = body[2], body[3], body[4]
    for i in range(count):
        s[AXIAL + i] = -1e300
    for k in range(4):
        ax, ay, az = axes[k, 0], axes[k, 1], axes[k, 2]
        fx, fy, fz = across[0, k, 0], across[0, k, 1], across[0, k, 2]
        sx, sy, sz = across[1, k, 0], across[1, k, 1], across[1, k, 2]
        held, along = 1.0 if discs[k] else 0.0, ALONG + k * TOGETHER
        for i in range(count):
            x, y, z = s[X + i], s[Y + i], s[Z + i]
            lean = x * ax + y * ay + z * az
            first, second = x * fx + y * fy + z * fz, x * sx + y * sy + z * sz
            nearer = lean > s[AXIAL + i]
            s[along + i] = lean
            s[LEG + i] = float(k) if nearer else s[LEG + i]
            s[FIRST + i] = first if nearer else s[FIRST + i]
            s[SECOND + i] = second if nearer else s[SECOND + i]
            s[HELD + i] = held if nearer else s[HELD + i]
            s[AXIAL + i] = max(lean, s[AXIAL + i])


@kernel(makes_arrays=False)
def _on_surface(count: int, body: Any, margin: float, tip: float, least: Any, s: Any) -> None:
    """How far points lie from the side of their leg, the sector of it, and which are kept: 1 on the side, 2 on the end disc, 0 not.

    Points at a crease may belong to either leg: left out, for their distance is biased. They lean along another leg by hardly less than
    along their own, ``least`` (4, 4).
    """
    _, _, _, _, _, r, c, length = body
    cosine, end_radius = 1.0 / math.sqrt(1.0 + c * c), r - c * length
    cosines, sines = EDGES
    for i in range(count):
        rho, axial, held = math.sqrt(s[FIRST + i] ** 2 + s[SECOND + i] ** 2), s[AXIAL + i], s[HELD + i]
        side, end = (rho - r + c * axial) * cosine, axial - length
        s[SIDE + i] = side
        # the nearer of both surfaces: a leg that is shorter than others has its whole end disc below the nominal one
        disc = (end > side) | (end > -margin) | ((axial > tip) & (held == 0.0))
        beside = (held == 0.0) | (rho > end_radius - margin) | (end < side)
        s[KEPT + i] = (0.0 if beside else 2.0) if disc else 1.0
        s[SECTOR + i] = 0.0 if s[SECOND + i] >= 0.0 else float(HALF_TURN)
    for k in range(4):
        a, b, c, d = least[k, 0], least[k, 1], least[k, 2], least[k, 3]
        for i in range(count):
            axial = s[AXIAL + i]
            one = min(axial - s[ALONG + i] - a, axial - s[ALONG + TOGETHER + i] - b)
            two = min(axial - s[ALONG + 2 * TOGETHER + i] - c, axial - s[ALONG + 3 * TOGETHER + i] - d)
            s[KEPT + i] = 0.0 if (s[LEG + i] == k) & (min(one, two) < 0.0) else s[KEPT + i]
    # sectors of the nearer half-turn that begin before the point: quicker than its angle
    for k in range(HALF_TURN - 1):
        for i in range(count):
            sign = 1.0 if s[SECOND + i] >= 0.0 else -1.0
            s[SECTOR + i] += 1.0 if sign * s[SECOND + i] * cosines[k] >= sign * s[FIRST + i] * sines[k] else 0.0


@kernel(makes_arrays=False)
def _write(begin: int, count: int, body: Any, s: Any, found: Any) -> None:
    """Distances and patches of points that are kept, -1 of others, and rows where these are asked for."""
    _, rotation, axes, across, _, r, c, length = body
    rows, residual, patch, _ = found
    cosine = 1.0 / math.sqrt(1.0 + c * c)
    for i in range(count):
        leg, axial, first, second = int(s[LEG + i]), s[AXIAL + i], s[FIRST + i], s[SECOND + i]
        disc = s[KEPT + i] == 2.0
        if s[KEPT + i] == 0.0:
            patch[begin + i] = -1
            continue
        if disc:
            turn = math.atan2(second, first) / (2.0 * math.pi)
            turn += 1.0 if turn < 0.0 else 0.0
            patch[begin + i] = leg * LEG_CELLS + AXIAL_CELLS * AZIMUTH_CELLS + min(int(turn * DISC_CELLS), DISC_CELLS - 1)
            residual[begin + i] = axial - length
        else:
            ring = min(max(int(axial / length * AXIAL_CELLS), 0), AXIAL_CELLS - 1)
            patch[begin + i] = leg * LEG_CELLS + ring * AZIMUTH_CELLS + int(s[SECTOR + i])
            residual[begin + i] = s[SIDE + i]
        if rows.shape[0] == 0:
            continue
        nx, ny, nz = axes[leg, 0], axes[leg, 1], axes[leg, 2]
        rows[begin + i, 6] = -length if disc else -r * cosine
        if not disc:
            per = 1.0 / (math.sqrt(first * first + second * second) + 1e-300)
            first, second = first * per, second * per
            nx = (first * across[0, leg, 0] + second * across[1, leg, 0] + c * nx) * cosine
            ny = (first * across[0, leg, 1] + second * across[1, leg, 1] + c * ny) * cosine
            nz = (first * across[0, leg, 2] + second * across[1, leg, 2] + c * nz) * cosine
        x, y, z = s[X + i], s[Y + i], s[Z + i]
        mx, my, mz = ny * z - nz * y, nz * x - nx * z, nx * y - ny * x
        for m in range(3):
            rows[begin + i, m] = -(rotation[m, 0] * nx + rotation[m, 1] * ny + rotation[m, 2] * nz)
            rows[begin + i, m + 3] = rotation[m, 0] * mx + rotation[m, 1] * my + rotation[m, 2] * mz


def deviations(seen: StripObservations) -> tuple[FloatArray, FloatArray, FloatArray] | None:
    """Absolute deviations of one sighting's points from the means of their patches, of these means from the cones, and one over the points
    of each patch; None where too few points are seen.
    """
    about, means, shares = np.empty(len(seen.residuals)), np.zeros(CELLS), np.zeros(CELLS)
    count = _distances(seen.residuals, seen.patches, about)
    if count < FEWEST_POINTS:
        return None
    limit = 6 * MAD_TO_SD * float(np.median(about[:count]))
    points, patches = _about_means(seen.residuals, seen.patches, limit, about, means, shares)
    return about[:points], means[:patches], shares[:patches]


@kernel(releases=True)
def _distances(residuals: Any, patches: Any, found: Any) -> int:
    """Absolute distances of the points that are not left out into ``found``, and how many these are."""
    count = 0
    for i in range(len(residuals)):
        found[count] = abs(residuals[i])
        count += 1 if patches[i] >= 0 else 0
    return count


@kernel(releases=True)
def _about_means(residuals: Any, patches: Any, limit: float, about: Any, means: Any, shares: Any) -> Any:
    """What :func:`deviations` tells of points nearer than ``limit``, into the last three, of which the latter hold zeros; how many points
    and patches there are."""
    total, counts = np.zeros(len(means)), np.zeros(len(means))
    for i in range(len(residuals)):
        if patches[i] >= 0 and abs(residuals[i]) < limit:
            total[patches[i]] += residuals[i]
            counts[patches[i]] += 1.0
    factors = np.zeros(len(means))
    full = 0
    for k in range(len(means)):
        if counts[k] >= FEWEST_ON_PATCH:
            total[k] /= counts[k]
            factors[k] = math.sqrt(counts[k] / (counts[k] - 1.0))
            means[full], shares[full] = abs(total[k]), 1.0 / counts[k]
            full += 1
    count = 0
    for i in range(len(residuals)):
        k = max(patches[i], 0)
        about[count] = abs(residuals[i] - total[k]) * factors[k]
        count += 1 if patches[i] >= 0 and abs(residuals[i]) < limit and counts[k] >= FEWEST_ON_PATCH else 0
    return count, full


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
