"""From raw points to oriented surface elements: thinning, spacing, noise, normals that point out of convex surfaces.

Nothing about the instrument is assumed. A leg is convex across its axis, so the side on which a point's neighbours fall away
from the tangent plane tells outside from inside; where the surface is flat (end discs, walls) the sign stays open.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numba import njit, prange
from numpy.typing import NDArray
from scipy.spatial import cKDTree

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

THINNING_RATIO = 0.03
"""Voxel edge as a share of the unit's height."""
NEIGHBOURS = 48
"""Most neighbours used for a normal; a normal of 48 points is as steady as the segmentation can use."""
BEND_RADIUS_RATIO = 0.14
"""Radius, as a share of the height, within which the sense of curvature is read."""


@dataclass(frozen=True, eq=False)
class SurfaceElements:
    """Thinned points with normals.

    Attributes
    ----------
    points
        (m, 3) metres, reduced frame.
    normals
        (m, 3) unit normals; outward where ``oriented``.
    oriented
        (m,) bool, sign of the normal known from convexity.
    flatness
        (m,) standard deviation of the neighbourhood across the tangent plane, metres.
    source
        (n,) for each raw point the element it was thinned into.
    spacing
        Median distance of a raw point to its nearest neighbour, metres.
    noise
        Standard deviation of a raw point across the surface, metres.
    element_noise
        The same for a thinned point.
    radius
        Radius of the neighbourhoods the normals were taken from, metres.
    """

    points: FloatArray
    normals: FloatArray
    oriented: NDArray[np.bool_]
    flatness: FloatArray
    source: IntArray
    spacing: float
    noise: float
    element_noise: float
    radius: float


def surface_elements(points: FloatArray, height: float, *, workers: int = -1) -> SurfaceElements:
    """Thin (n, 3) reduced points to 0.03 H and give each remaining point an outward normal.

    The neighbourhood for normals grows with the noise: it must be wide enough for a steady normal and narrow enough to stay
    on one leg, whose radius is about 0.2 H.
    """
    thinned, source = thin(points, THINNING_RATIO * height)
    rng = np.random.default_rng(0)
    raw = cKDTree(points)
    probe = points[np.sort(rng.choice(len(points), min(len(points), 4000), replace=False))]
    spacing = float(np.median(raw.query(probe, k=2, workers=workers)[0][:, 1])) if len(points) > 1 else 0.0
    tree = cKDTree(thinned)
    count = min(NEIGHBOURS, len(thinned))
    distance, index = tree.query(thinned, k=count, workers=workers)
    distance, index = distance.reshape(len(thinned), count), index.reshape(len(thinned), count)
    element_noise = _noise_of(thinned, tree, height, workers)
    # wanted: normal error sigma / (R/2 sqrt(n)) of about 3 degrees, n = pi R^2 / area of an element
    area = max(float(np.median(distance[:, min(6, count - 1)])) ** 2 * np.pi / 6, (0.5 * THINNING_RATIO * height) ** 2)
    wanted = np.sqrt(2 * element_noise * np.sqrt(area / np.pi) / 0.05)
    radius = float(np.clip(wanted, 0.055 * height, 0.14 * height))
    normals, flatness, bend, bend_sd = _normals(thinned, index.astype(np.int64), distance, radius, BEND_RADIUS_RATIO * height)
    # on a leg the surface falls away by d^2 / (4 rho) on average over directions, rho about 0.2 H: a third of that, if it also
    # stands out of its own standard error, is taken as a sign
    expected = 1 / (4 * 0.2 * height)
    oriented = (np.abs(bend) > expected / 3) & (np.abs(bend) > 2 * bend_sd)
    normals = np.where(bend[:, None] > 0, -normals, normals)
    noise = _noise_of(points, raw, height, workers)
    return SurfaceElements(thinned, normals, oriented, flatness, source, spacing, noise, element_noise, radius)


def thin(points: FloatArray, voxel: float) -> tuple[FloatArray, IntArray]:
    """Mean point of every occupied voxel (m, 3), in lexicographic voxel order, and for each of the n points its voxel."""
    if not len(points):
        return np.zeros((0, 3)), np.zeros(0, dtype=np.int64)
    key = np.floor(points / voxel).astype(np.int64)
    key -= key.min(axis=0)
    size = key.max(axis=0) + 1
    flat = (key[:, 0] * size[1] + key[:, 1]) * size[2] + key[:, 2]
    _, source = np.unique(flat, return_inverse=True)
    weight = np.bincount(source)
    mean = np.column_stack([np.bincount(source, weights=points[:, k]) for k in range(3)]) / weight[:, None]
    return mean, source.astype(np.int64)


def _noise_of(points: FloatArray, tree: cKDTree, height: float, workers: int) -> float:
    """Standard deviation across the surface, from quadric fits to neighbourhoods that stay on one leg."""
    rng = np.random.default_rng(1)
    chosen = rng.choice(len(points), min(len(points), 1500), replace=False)
    count = min(25, len(points))
    if count < 12:
        return 0.0
    distance, index = tree.query(points[np.sort(chosen)], k=count, workers=workers)
    near = distance[:, -1] < 0.2 * height
    if not near.any():
        return 0.0
    local = points[index[near]]
    local = local - local.mean(axis=1, keepdims=True)
    _, axes = np.linalg.eigh(np.einsum("nki,nkj->nij", local, local))
    local = np.einsum("nki,nij->nkj", local, axes)
    w, v, u = local[..., 0], local[..., 1], local[..., 2]
    design = np.stack([np.ones_like(u), u, v, u * u, u * v, v * v], axis=-1)
    solution = np.linalg.pinv(design) @ w[..., None]
    residual = w - (design @ solution)[..., 0]
    variance = np.sum(residual**2, axis=1) / (count - 6)
    # rough ground and edges only add: the lower half of the neighbourhoods speaks for smooth concrete
    return float(np.sqrt(np.percentile(variance, 30)))


@njit(cache=True, parallel=True)
def _normals(points: Any, index: Any, distance: Any, radius: float, bend_radius: float) -> Any:
    n, k = index.shape
    normals = np.zeros((n, 3))
    flatness = np.zeros(n)
    bend = np.zeros(n)
    bend_sd = np.zeros(n)
    for i in prange(n):
        cx = cy = cz = 0.0
        m = 0
        for j in range(k):
            if j >= 7 and distance[i, j] > radius:
                break
            q = index[i, j]
            cx += points[q, 0]
            cy += points[q, 1]
            cz += points[q, 2]
            m += 1
        cx /= m
        cy /= m
        cz /= m
        cov = np.zeros((3, 3))
        for j in range(m):
            q = index[i, j]
            x, y, z = points[q, 0] - cx, points[q, 1] - cy, points[q, 2] - cz
            cov[0, 0] += x * x
            cov[0, 1] += x * y
            cov[0, 2] += x * z
            cov[1, 1] += y * y
            cov[1, 2] += y * z
            cov[2, 2] += z * z
        cov[1, 0], cov[2, 0], cov[2, 1] = cov[0, 1], cov[0, 2], cov[1, 2]
        values, vectors = np.linalg.eigh(cov)
        for a in range(3):
            normals[i, a] = vectors[a, 0]
        flatness[i] = np.sqrt(max(values[0], 0.0) / m)
        # convexity: slope of the height over the tangent plane against the squared distance
        su = sh = suu = suh = shh = 0.0
        count = 0
        for j in range(k):
            if distance[i, j] > bend_radius:
                break
            q = index[i, j]
            h = (points[q, 0] - cx) * normals[i, 0] + (points[q, 1] - cy) * normals[i, 1] + (points[q, 2] - cz) * normals[i, 2]
            u = distance[i, j] ** 2
            su += u
            sh += h
            suu += u * u
            suh += u * h
            shh += h * h
            count += 1
        spread = suu - su * su / count
        if count > 6 and spread > 0.0:
            bend[i] = (suh - su * sh / count) / spread
            rest = shh - sh * sh / count - bend[i] ** 2 * spread
            bend_sd[i] = np.sqrt(max(rest, 0.0) / (count - 2) / spread)
        else:
            bend_sd[i] = np.inf
    return normals, flatness, bend, bend_sd
