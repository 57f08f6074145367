"""From raw points to oriented surface elements: thinning, spacing, noise, normals that point out of convex surfaces.

Nothing about the instrument is assumed. A leg is convex across its axis, so the side on which a point's neighbours fall away
from the tangent plane tells outside from inside; where the surface is flat (end discs, walls) the sign stays open.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from scipy.special import chdtri

from ..common.arrays import FloatArray
from ..common.kernels import in_parts, kernel
from ..common.least_axis import across, least_axis
from ..common.neighbourhood import build_grid, gather, neighbours_of_some, point_tree
from ..common.voxels import thin

THINNING_RATIO = 0.03
"""Voxel edge as a share of the unit's height."""
FEWEST_NEIGHBOURS = 7
"""A normal of fewer points says nothing."""
MOST_NEIGHBOURS = 200
"""More than a surface thinned to ``THINNING_RATIO`` holds within ``BEND_RADIUS_RATIO``, even where two surfaces meet."""
LEAST_RADIUS_RATIO = 0.055
"""Radius, as a share of the height, within which a normal is taken where the noise is small."""
BEND_RADIUS_RATIO = 0.14
"""Radius, as a share of the height, within which the sense of curvature is read."""
NOISE_NEIGHBOURS = (25, 20, 16, 13)
"""Points of a neighbourhood from which the noise is told: the most of which enough neighbourhoods stay on one leg."""
LEAST_NEAR = 0.3
"""Share of the neighbourhoods looked at that is enough."""
NOTHING_LEFT = 1e-20
"""Share of a term's square that round-off leaves of one that others make up."""
WIDE_IN_NOISE = 6.0
"""Radius of such a neighbourhood in standard deviations of the noise, from which it does not choose among the points by their noise."""
SMOOTH_PERCENTILE, SMOOTH_SHARE = 30, 0.906
"""Percentile of the neighbourhoods' variances that is the noise's, and the share of the standard deviation that it is where all are equally
smooth: the root of that percentile of chi-squared with 19 degrees of freedom, over these."""


@dataclass(frozen=True, eq=False)
class SurfaceElements:
    """Thinned points with normals.

    Attributes
    ----------
    points
        (m, 3) metres, reduced frame.
    normals
        (m, 3) unit normals; outward where ``curved`` is 1.
    curved
        (m,) int8: 1 where the surface bends as a leg does, which gives the sign of the normal; -1 where it is too flat for a leg; 0 where
        too few or too noisy neighbours leave it open.
    spacing
        Median distance of a raw point to its nearest neighbour, metres.
    noise
        Standard deviation of a raw point across the surface, metres.
    element_noise
        The same for a thinned point.
    normal_radius
        Radius of the neighbourhoods of most normals, metres.
    smoothed
        Whether the points were moved onto the surface that the points around share (:mod:`.smoothed_surface`).
    layered
        Whether layers before the surface were taken off (:mod:`.innermost_layer`).
    shared_noise
        Whether neighbours share their noise (:mod:`.shared_noise`), so that no smoothing takes it off.
    """

    points: FloatArray
    normals: FloatArray
    curved: NDArray[np.int8]
    spacing: float
    noise: float
    element_noise: float
    normal_radius: float
    smoothed: bool = False
    layered: bool = False
    shared_noise: bool = False


def surface_elements(points: FloatArray, height: float, *, workers: int = -1) -> SurfaceElements:
    """Thin (n, 3) reduced points to 0.03 H and give each remaining point an outward normal.

    The neighbourhood for normals grows with the noise: it must be wide enough for a steady normal and narrow enough to stay
    on one leg, whose radius is about 0.2 H.
    """
    thinned, _ = thin(points, THINNING_RATIO * height)
    rng = np.random.default_rng(0)
    probe = np.sort(rng.choice(len(points), min(len(points), 4000), replace=False))
    spacing = float(np.median(neighbours_of_some(points, probe, 2)[0][:, 1])) if len(points) > 1 else 0.0
    tree = point_tree(thinned)
    element_noise, _ = _noise_of(thinned, tree, height, workers)
    # wanted: normal error sigma / (R/2 sqrt(n)) of about 3 degrees, n = pi R^2 / area of an element
    some = thinned[np.sort(rng.choice(len(thinned), min(len(thinned), 4000), replace=False))]
    seventh = tree.query(some, k=min(FEWEST_NEIGHBOURS, len(thinned)), workers=workers)[0].reshape(len(some), -1)[:, -1]
    fewest = float(np.median(seventh))
    area = max(fewest**2 * np.pi / 6, (0.5 * THINNING_RATIO * height) ** 2)
    wanted = np.sqrt(2 * element_noise * np.sqrt(area / np.pi) / 0.05)
    radius = float(np.clip(wanted, LEAST_RADIUS_RATIO * height, BEND_RADIUS_RATIO * height))
    normals, curved = senses(*_bends(thinned, radius, height), height)
    noise = surface_noise(points, height)
    return SurfaceElements(thinned, normals, curved, spacing, noise, element_noise, max(radius, fewest))


def senses(normals: FloatArray, bend: FloatArray, bend_sd: FloatArray, height: float) -> tuple[FloatArray, NDArray[np.int8]]:
    """Normals (m, 3) turned outwards and ``curved`` (m,), from the bend of the surface and its standard deviation (m,), 1/metres."""
    # on a leg the surface falls away by d^2 / (4 rho) on average over directions, rho about 0.2 H: a third of that, if it also
    # stands out of its own standard error, is taken as a sign
    expected = 1 / (4 * 0.2 * height)
    curved = np.zeros(len(normals), dtype=np.int8)
    curved[(np.abs(bend) > expected / 3) & (np.abs(bend) > 2 * bend_sd)] = 1
    curved[np.abs(bend) + 2 * bend_sd < expected / 3] = -1
    return np.where(bend[:, None] > 0, -normals, normals), curved


def element_normals(points: FloatArray, height: float) -> FloatArray:
    """(n, 3) unit normals of thinned points (n, 3), of either sign, from neighbourhoods of ``BEND_RADIUS_RATIO``."""
    return _bends(points, BEND_RADIUS_RATIO * height, height)[0]


def _bends(points: FloatArray, radius: float, height: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """What :func:`_normals` finds for thinned points."""
    reach = BEND_RADIUS_RATIO * height
    grid = build_grid(points, 0.5 * reach)
    every = np.ones(len(points), dtype=np.bool_)
    normals, bend, bend_sd = np.empty((len(points), 3)), np.empty(len(points)), np.empty(len(points))
    passes = partial(
        _normals, points=points, every=every, radius=radius, bend_radius=reach, grid=grid, normals=normals, bend=bend, bend_sd=bend_sd
    )
    in_parts(passes, len(points))
    return normals, bend, bend_sd


def surface_noise(points: FloatArray, height: float, *, tree: cKDTree | None = None) -> float:
    """Standard deviation of (n, 3) points across the surface, metres; 0 where too few lie together to tell.

    The nearest neighbours of a point are those that noise put near it, so that a neighbourhood narrower than the noise makes it look
    small. Such a cloud is thinned at random until the neighbourhoods reach beyond the noise. ``tree`` is that of the points, where there is
    one.
    """
    rng = np.random.default_rng(2)
    noise, radius = _noise_of(points, tree, height)
    for _ in range(4):
        wanted = min(WIDE_IN_NOISE * noise, BEND_RADIUS_RATIO * height)
        if radius >= 0.9 * wanted:
            break
        points = points[rng.random(len(points)) < (radius / wanted) ** 2]
        again, radius = _noise_of(points, None, height)
        noise = max(noise, again)
    return noise


def _noise_of(points: FloatArray, tree: cKDTree | None, height: float, workers: int = 1) -> tuple[float, float]:
    """Standard deviation across the surface, from quadric fits to neighbourhoods that stay on one leg, and the median radius of these."""
    rng = np.random.default_rng(1)
    chosen = np.sort(rng.choice(len(points), min(len(points), 1500), replace=False))
    for count in NOISE_NEIGHBOURS:
        if count > len(points):
            continue
        if tree is None:
            distance, index = neighbours_of_some(points, chosen, count)
        else:
            distance, index = tree.query(points[chosen], k=count, workers=workers)
        near = distance[:, -1] < 0.2 * height
        # a few dense places of a sparse cloud speak of mixed pixels and growth as well as of concrete
        if near.sum() >= LEAST_NEAR * len(chosen) or (count == NOISE_NEIGHBOURS[-1] and near.any()):
            break
    else:
        return 0.0, np.inf
    index = index[near]
    squares = np.empty(len(index))
    in_parts(partial(squares_off_quadrics, points=points, index=index, squares=squares), len(index))
    # rough ground and edges only add: the lower half of the neighbourhoods speaks for smooth concrete
    variance = float(np.percentile(squares, SMOOTH_PERCENTILE)) / (count - 6) * _as_of_most(count)
    return float(np.sqrt(variance)), float(np.median(distance[near, -1]))


def _as_of_most(count: int) -> float:
    """Factor of a low percentile of variances of so many neighbours that makes it that of the most: fewer scatter further down."""
    least, most = (chdtri(n - 6, 1 - SMOOTH_PERCENTILE / 100) / (n - 6) for n in (count, NOISE_NEIGHBOURS[0]))
    return float(most / least)


@kernel(releases=True)
def squares_off_quadrics(first: int, last: int, points: Any, index: Any, squares: Any) -> None:
    """Sums of the squared distances (k,) of neighbourhoods, the points of the rows of ``index`` (k, m), from a quadric through each.

    What its terms have in common with the heights is taken out term by term (modified Gram-Schmidt: Golub and Van Loan, 2013, Matrix
    Computations, 5.2.8), a term that points on a line leave nothing of being none.
    """
    m = index.shape[1]
    # heights over the plane of the neighbourhood, and 1, u, v, uu, uv, vv, which are the same in any two directions along it
    terms, whole = np.empty((7, m)), np.empty(7)
    for i in range(first, last):
        x = y = z = 0.0
        for j in range(m):
            x += points[index[i, j], 0] / m
            y += points[index[i, j], 1] / m
            z += points[index[i, j], 2] / m
        xx = xy = xz = yy = yz = zz = 0.0
        for j in range(m):
            p, q, r = points[index[i, j], 0] - x, points[index[i, j], 1] - y, points[index[i, j], 2] - z
            terms[1, j], terms[2, j], terms[3, j] = p, q, r
            xx += p * p
            xy += p * q
            xz += p * r
            yy += q * q
            yz += q * r
            zz += r * r
        nx, ny, nz = least_axis(xx, xy, xz, yy, yz, zz)
        size = np.sqrt((xx + yy + zz) / m)
        if size == 0.0:
            squares[i] = 0.0
            continue
        ux, uy, uz, vx, vy, vz = across(nx, ny, nz)
        for j in range(m):
            p, q, r = terms[1, j], terms[2, j], terms[3, j]
            u, v = (p * ux + q * uy + r * uz) / size, (p * vx + q * vy + r * vz) / size
            terms[0, j], terms[1, j], terms[2, j] = p * nx + q * ny + r * nz, u, v
            terms[3, j], terms[4, j], terms[5, j], terms[6, j] = u * u, u * v, v * v, 1.0
        for a in range(7):
            whole[a] = 0.0
            for j in range(m):
                whole[a] += terms[a, j] * terms[a, j]
        for a in range(6, 0, -1):
            own = 0.0
            for j in range(m):
                own += terms[a, j] * terms[a, j]
            if own <= NOTHING_LEFT * whole[a]:
                continue
            for b in range(a):
                common = 0.0
                for j in range(m):
                    common += terms[a, j] * terms[b, j]
                for j in range(m):
                    terms[b, j] -= common / own * terms[a, j]
        squares[i] = 0.0
        for j in range(m):
            squares[i] += terms[0, j] * terms[0, j]


@kernel(releases=True)
def _normals(
    first: int, last: int, points: Any, every: Any, radius: float, bend_radius: float, grid: Any, normals: Any, bend: Any, bend_sd: Any
) -> None:
    """Normal of every point, bend of the surface away from the tangent plane, and its standard deviation."""
    for i in range(first, last):
        reach = bend_radius
        middle = (points[i, 0], points[i, 1], points[i, 2])
        near = gather(every, middle, reach, grid, np.int64(MOST_NEIGHBOURS))
        # a lone point looks further, up to about a unit's half
        while len(near) < FEWEST_NEIGHBOURS and reach < 3.0 * bend_radius:
            reach *= 2.0
            near = gather(every, middle, reach, grid, np.int64(MOST_NEIGHBOURS))
        count = len(near)
        local = np.empty((count, 4))
        m = 0
        for j in range(count):
            q = near[j]
            x, y, z = points[q, 0] - points[i, 0], points[q, 1] - points[i, 1], points[q, 2] - points[i, 2]
            local[j, 0], local[j, 1], local[j, 2], local[j, 3] = x, y, z, x * x + y * y + z * z
            if local[j, 3] <= radius * radius:
                m += 1
        limit = radius * radius if m >= FEWEST_NEIGHBOURS else np.inf
        cx = cy = cz = 0.0
        xx = xy = xz = yy = yz = zz = 0.0
        m = 0
        for j in range(count):
            x, y, z = local[j, 0], local[j, 1], local[j, 2]
            if local[j, 3] > limit:
                continue
            cx += x
            cy += y
            cz += z
            xx += x * x
            xy += x * y
            xz += x * z
            yy += y * y
            yz += y * z
            zz += z * z
            m += 1
        cx, cy, cz = cx / m, cy / m, cz / m
        xx, xy, xz = xx - m * cx * cx, xy - m * cx * cy, xz - m * cx * cz
        yy, yz, zz = yy - m * cy * cy, yz - m * cy * cz, zz - m * cz * cz
        nx, ny, nz = least_axis(xx, xy, xz, yy, yz, zz)
        normals[i, 0], normals[i, 1], normals[i, 2] = nx, ny, nz
        # convexity: slope of the height over the tangent plane against the squared distance
        su = sh = suu = suh = shh = 0.0
        for j in range(count):
            h = (local[j, 0] - cx) * nx + (local[j, 1] - cy) * ny + (local[j, 2] - cz) * nz
            u = local[j, 3]
            su += u
            sh += h
            suu += u * u
            suh += u * h
            shh += h * h
        spread = suu - su * su / count
        if count >= FEWEST_NEIGHBOURS and spread > 0.0:
            bend[i] = (suh - su * sh / count) / spread
            rest = shh - sh * sh / count - bend[i] ** 2 * spread
            bend_sd[i] = np.sqrt(max(rest, 0.0) / (count - 2) / spread)
        else:
            bend[i], bend_sd[i] = 0.0, np.inf
