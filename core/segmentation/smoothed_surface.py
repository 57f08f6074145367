"""Surface elements of noisy clouds, each moved onto the surface that the points around it share.

Noise wider than the thinning leaves a shell of elements, of which hardly any lies where the surface is. Within a patch of a leg the surface
is a quadric; fitted by weights that fall with the distance along the surface (moving least squares: Levin, 1998) and robustly against other
surfaces (Tukey's biweight across it), it is known two to three times better than a point. Normal and bend come from it too, the bend with
its standard deviation.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.kernels import in_parts, kernel
from ..common.least_axis import principal_axes
from ..common.neighbourhood import build_grid, gather
from ..common.positive_definite import factorise, solve_factorised
from ..common.voxels import thin
from .surface_elements import BEND_RADIUS_RATIO, THINNING_RATIO, SurfaceElements, senses

NOISY_RATIO = 0.03
"""Tolerance that the noise asks for, as a share of the height, beyond which elements are moved onto the surface first."""
RADIUS_RATIO = BEND_RADIUS_RATIO
"""Radius of the patches, as a share of the height: a leg's radius is about 0.2."""
MOST_POINTS = 250
"""Points of a patch that take part, at most."""
BAND_IN_NOISE = 3.0
"""Distance from the quadric, in standard deviations of a point, at which a point's weight is nothing."""
FEWEST_WEIGHT = 4.0
"""Sum of weights below which a patch says nothing: a quadric has six parameters."""
FARTHEST_IN_NOISE = 4.0
"""Way across the surface, in standard deviations of a point, beyond which an element is none of this surface."""
LEFT_OVER = 2.0
"""Standard deviation of the moved elements over that of the fit: on simulated piles with noise of 1.3 to 3.3 % of H they lie twice as far
from the true surfaces, as other surfaces and creases share in the patches."""
ROUNDS, REWEIGHTED = 2, 4
"""Times that elements are moved, and fits of a patch: after the first, points away from it weigh less."""
FEWEST_POINTS = 12
"""Of a patch: twice the parameters."""
ENOUGH_POINTS = 36
"""Of most patches, six for each parameter of a quadric: at 400 points per H² (25) smoothing finds no more, at 200 much less than wide
tolerances do."""
RIDGE, TINY = 1e-4, 1e-12
"""Added to the diagonal of the normal matrix, as a share of the sum of weights and at least: a patch of which one side is seen has no bend
of its own."""


def smoothed(points: FloatArray, elements: SurfaceElements, height: float, *, part: bool = False) -> SurfaceElements:
    """Elements of (n, 3) raw points on the surface that these share; ``elements`` are those of thinning, ``height`` the unit's, metres.

    The elements as they are where patches hold too few points for a surface of their own: most of a cloud, but all of a ``part`` of one, a
    place that may show little of what is smoothed elsewhere.
    """
    radius = RADIUS_RATIO * height
    grid = build_grid(points, 0.5 * radius)
    every = np.ones(len(points), dtype=np.bool_)
    places = elements.points
    for _ in range(ROUNDS):
        places, _ = thin(places, THINNING_RATIO * height)
        patches = np.full((len(places), 10), np.nan)
        passes = partial(_patches, points=points, every=every, places=places, radius=radius, noise=elements.noise, grid=grid, out=patches)
        in_parts(passes, len(places))
        kept = np.isfinite(patches[:, 0])
        if not np.any(kept) or (not part and np.median(patches[:, 9]) < ENOUGH_POINTS):
            return elements
        patches = patches[kept]
        places = np.ascontiguousarray(patches[:, :3])
    normals, curved = senses(patches[:, 3:6], patches[:, 6], patches[:, 7], height)
    return SurfaceElements(
        places,
        normals,
        curved,
        elements.spacing,
        elements.noise,
        LEFT_OVER * float(np.median(patches[:, 8])),
        radius,
        smoothed=True,
    )


@kernel(releases=True)
def _patches(first: int, last: int, points: Any, every: Any, places: Any, radius: float, noise: float, grid: Any, out: Any) -> None:
    """Rows (k, 10) of ``out`` by place: where the surface passes it, normal, bend and its sd, sd of the first, points; as they were without
    one."""
    for i in range(first, last):
        near = gather(every, (places[i, 0], places[i, 1], places[i, 2]), radius, grid, np.int64(MOST_POINTS))
        out[i, 9] = len(near)
        if len(near) < FEWEST_POINTS:
            continue
        # lengths in radii from here on
        local = in_radii(points, near, places[i], radius)
        axes = tangent_axes(local)
        solution, covariance, weight = robust_quadric(local, axes, noise / radius)
        if weight < FEWEST_WEIGHT or abs(solution[0]) * radius > FARTHEST_IN_NOISE * noise:
            continue
        slope = 1.0 / np.sqrt(1.0 + solution[1] ** 2 + solution[2] ** 2)
        for a in range(3):
            out[i, a] = places[i, a] + solution[0] * radius * axes[a, 0]
            out[i, 3 + a] = slope * (axes[a, 0] - solution[1] * axes[a, 1] - solution[2] * axes[a, 2])
        out[i, 6] = 0.5 * (solution[3] + solution[5]) / radius
        out[i, 7] = 0.5 * np.sqrt(max(covariance[3, 3] + covariance[5, 5] + 2.0 * covariance[3, 5], 0.0)) * noise / radius**2
        out[i, 8] = np.sqrt(covariance[0, 0]) * noise


@kernel()
def in_radii(points: Any, near: Any, place: Any, radius: float) -> Any:
    """(m, 3) those of (n, 3) points whose numbers are ``near`` (m,), from a place (3,), in lengths of ``radius``."""
    local = np.empty((len(near), 3))
    for j in range(len(near)):
        for a in range(3):
            local[j, a] = (points[near[j], a] - place[a]) / radius
    return local


@kernel()
def tangent_axes(local: Any) -> Any:
    """(3, 3) directions in columns, the first across the surface, of points (m, 3) within a radius of 1 about the origin."""
    total = 0.0
    mean = np.zeros(3)
    second = np.zeros((3, 3))
    for j in range(len(local)):
        w = (1.0 - min(local[j, 0] ** 2 + local[j, 1] ** 2 + local[j, 2] ** 2, 1.0)) ** 2
        total += w
        for a in range(3):
            mean[a] += w * local[j, a]
            for b in range(a + 1):
                second[a, b] += w * local[j, a] * local[j, b]
    for a in range(3):
        for b in range(a + 1):
            second[a, b] -= mean[a] * mean[b] / total
    one, two, three = principal_axes(second[0, 0], second[1, 0], second[2, 0], second[1, 1], second[2, 1], second[2, 2])
    if two[0] < one[0]:
        one, two = two, one
    if three[0] < one[0]:
        one, three = three, one
    if three[0] < two[0]:
        two, three = three, two
    axes = np.empty((3, 3))
    for a in range(3):
        axes[a, 0], axes[a, 1], axes[a, 2] = one[a + 1], two[a + 1], three[a + 1]
    return axes


@kernel()
def quadric_terms(local: Any, axes: Any) -> Any:
    """Terms 1, u, v, uu, uv, vv (m, 6) of a height over the tangent plane, and (m,) that of points (m, 3)."""
    m = len(local)
    design = np.empty((m, 6))
    across = np.empty(m)
    for j in range(m):
        h = u = v = 0.0
        for a in range(3):
            h += local[j, a] * axes[a, 0]
            u += local[j, a] * axes[a, 1]
            v += local[j, a] * axes[a, 2]
        across[j] = h
        design[j, 0], design[j, 1], design[j, 2] = 1.0, u, v
        design[j, 3], design[j, 4], design[j, 5] = u * u, u * v, v * v
    return design, across


@kernel()
def robust_quadric(local: Any, axes: Any, noise: float) -> Any:
    """Height over the tangent plane as (6,) coefficients of 1, u, v, uu, uv, vv, their (6, 6) covariance by unit noise, sum of weights."""
    m = len(local)
    design, across = quadric_terms(local, axes)
    along = np.empty(m)
    for j in range(m):
        along[j] = (1.0 - min(design[j, 3] + design[j, 5], 1.0)) ** 2
    weights = along.copy()
    normal = np.empty((6, 6))
    spread = np.empty((6, 6))
    right = np.empty(6)
    weight = 0.0
    for _ in range(REWEIGHTED):
        normal[:, :] = 0.0
        spread[:, :] = 0.0
        right[:] = 0.0
        weight = 0.0
        for j in range(m):
            w = weights[j]
            weight += w
            for a in range(6):
                right[a] += w * design[j, a] * across[j]
                for b in range(a + 1):
                    normal[a, b] += w * design[j, a] * design[j, b]
                    spread[a, b] += w * w * design[j, a] * design[j, b]
        for a in range(6):
            for b in range(a):
                spread[b, a] = spread[a, b]
            normal[a, a] += RIDGE * weight + TINY
        factorise(normal)
        solve_factorised(normal, right)
        for j in range(m):
            rest = across[j]
            for a in range(6):
                rest -= design[j, a] * right[a]
            t = rest / (BAND_IN_NOISE * noise)
            weights[j] = along[j] * max(1.0 - t * t, 0.0) ** 2
    inverse = np.eye(6)
    for a in range(6):
        solve_factorised(normal, inverse[a])
    return right, inverse @ spread @ inverse, weight
