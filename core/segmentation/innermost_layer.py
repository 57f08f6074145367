"""The innermost of the layers that images leave in hollows: what dense matching puts before a surface, taken off again.

A matcher with a smoothness term bridges a hollow that is narrow as an image sees it (Hirschmüller, 2008): every image at a depth of its
own, always before the surface, never behind it. What is kept of all images is a pile of layers up to some hundredths of the height thick.
Only where all of them see a surface alike its points lie as their own noise says. The scatter told over the whole of such a cloud is that
of its layers, several times the noise, and a surface smoothed through their middle is none of a unit.

The innermost layer is that of the images that look into the hollow best. Around a place it is found by a quadric through the points, from
which those above are taken out until the scatter of the rest is that of agreeing images.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from ..common.arrays import BoolArray, FloatArray
from ..common.kernels import in_parts, kernel
from ..common.neighbourhood import build_grid, gather
from ..common.positive_definite import factorise, solve_factorised
from ..common.voxels import thin
from .smoothed_surface import in_radii, quadric_terms, tangent_axes
from .surface_elements import THINNING_RATIO

NEAR_RATIO, FAR_RATIO = 0.05, 0.1
"""Radius of the patches, as a share of the height, and where the points are sparse: less than half the radius of a leg, wider than layers
are thick."""
MOST_POINTS, FEWEST_POINTS = 60, 14
"""Of a patch: so many of them take part, and so many a layer must have; a quadric has six parameters."""
PROBES, FEWEST_PROBES = 4000, 100
"""Places at which it is asked whether there are layers, about and at least."""
ROUNDS = 6
"""Times that points above are taken out."""
ABOVE = 0.5
"""Standard deviations above the quadric from which they are: beyond 0.2 and below 1 the layers found are the same."""
LEAST_RISE = 0.2
"""Of the normal, up to which a surface faces the cameras: where it stands upright its inside is not known, and nothing is taken out."""
AGREEING_PERCENTILE, AGREEING_SHARE = 5, 0.8
"""Percentile of the scatter about all places that is that of agreeing images, and the share of their noise that it is by chance."""
USUAL_PERCENTILE, UNEVEN = 30, 0.5
"""Percentile by which a cloud's noise is told elsewhere, too. Where agreeing images have less than this share of it, layers make
the scatter: 0.17 to 0.31 in simulated clouds that are bridged (up to 0.42 in parts of 6 H), 0.63 and more in all others, also with noise of
0 to 3.3 % of H added (0.59 in parts of 1.6 to 6 H)."""
ONE_SIDED = 3.0
"""Standard deviations of chance by which places must be more that agree once what lies above is taken out than once what lies below is:
layers lie before the surface, never behind it, while rock scatters to both sides."""
UPSIDE_DOWN = np.array([1.0, 1.0, -1.0])
AGREEING = 2.0
"""Scatter of a layer over the noise of agreeing images, at most."""
LEAST_SCATTER_RATIO = 0.003
"""Of a layer, as a share of the height, that is let be in any case: roughness and what real legs deviate. Where the usual scatter is no
larger, layers would not matter: of real photogrammetry it is 0.0007."""
IN_LAYER = 2.0
"""Distance of a point of a layer from its quadric, over the scatter allowed, at most."""
AT_ONCE = 100_000
"""Points whose layers are held in memory together."""
SCATTER, RADIUS, MIDDLE, AXES, TERMS, COLUMNS = 0, 1, 2, 5, 14, 20
"""Columns of a layer: standard deviation of its points across it and radius of the patch, metres; middle of the patch; directions by rows
of coordinates, the first across; the quadric's coefficients, in radii."""


def innermost_layer(points: FloatArray, places: FloatArray, height: float, *, surely: bool = False) -> BoolArray | None:
    """(n,) whether each of (n, 3) raw points, reduced frame, is of the innermost layer at its place; None where a cloud has no layers.

    Parameters
    ----------
    places
        (k, 3) thinned points of the cloud: at some of them it is asked whether there are layers.
    height
        Of a unit, metres.
    surely
        Ask that the scatter be one-sided too, or rough ground about smooth units would pass for layers; a few places do not tell.
    """
    if len(places) < FEWEST_PROBES:
        return None
    some = np.ascontiguousarray(places[:: max(len(places) // PROBES, 1)])
    scatter = _layers(points, some, height, np.inf)[:, SCATTER]
    if np.count_nonzero(np.isfinite(scatter)) < FEWEST_PROBES:
        return None
    agreeing, usual = np.nanpercentile(scatter, [AGREEING_PERCENTILE, USUAL_PERCENTILE])
    if agreeing > UNEVEN * usual or usual < LEAST_SCATTER_RATIO * height:
        return None
    limit = max(AGREEING * agreeing / AGREEING_SHARE, LEAST_SCATTER_RATIO * height)
    if surely and not _is_one_sided(points, some, height, limit):
        return None
    means, voxel = thin(points, THINNING_RATIO * height)
    layers = _layers(points, means, height, limit)
    known = np.flatnonzero((layers[:, SCATTER] <= limit)[voxel])
    kept = np.zeros(len(points), dtype=np.bool_)
    for part in np.array_split(known, len(known) // AT_ONCE + 1):
        kept[part] = np.abs(_across(points[part], layers[voxel[part]])) < IN_LAYER * limit
    return kept


def _is_one_sided(points: FloatArray, places: FloatArray, height: float, limit: float) -> bool:
    """Whether scatter falls below a limit in metres by what lies above a surface being taken out, more than by what lies below it."""
    above = _layers(points, places, height, limit)[:, SCATTER] <= limit
    below = _layers(points * UPSIDE_DOWN, places * UPSIDE_DOWN, height, limit)[:, SCATTER] <= limit
    more, less = np.count_nonzero(above & ~below), np.count_nonzero(below & ~above)
    return bool(more - less >= ONE_SIDED * np.sqrt(more + less))


def _layers(points: FloatArray, places: FloatArray, height: float, limit: float) -> FloatArray:
    """(k, 20) innermost layers of (n, 3) points about (k, 3) places, whose scatter is below a limit in metres where that is reached.

    NaN where points are few.
    """
    layers = np.full((len(places), COLUMNS), np.nan)
    grid, every = build_grid(points, NEAR_RATIO * height), np.ones(len(points), dtype=np.bool_)
    radii = NEAR_RATIO * height, FAR_RATIO * height
    in_parts(partial(_fit, points=points, every=every, places=places, radii=radii, limit=limit, grid=grid, out=layers), len(places))
    return layers


def _across(points: FloatArray, layers: FloatArray) -> FloatArray:
    """(n,) distance of each of (n, 3) points from its own of (n, 20) layers, metres, along the first of its directions."""
    radius = layers[:, RADIUS]
    axes = layers[:, AXES:TERMS].reshape(-1, 3, 3)
    h, u, v = np.einsum("ni,nij->jn", points - layers[:, MIDDLE:AXES], axes) / radius
    terms = np.stack([np.ones_like(u), u, v, u * u, u * v, v * v], axis=-1)
    return np.asarray(radius * (h - np.sum(terms * layers[:, TERMS:], axis=1)))


@kernel(releases=True)
def _fit(first: int, last: int, points: Any, every: Any, places: Any, radii: Any, limit: float, grid: Any, out: Any) -> None:
    """Layers about places into the rows of ``out`` (k, 20)."""
    normal, right = np.empty((6, 6)), np.empty(6)
    for i in range(first, last):
        place, radius = (places[i, 0], places[i, 1], places[i, 2]), radii[0]
        near = gather(every, place, radius, grid, np.int64(MOST_POINTS))
        if len(near) < FEWEST_POINTS:
            radius = radii[1]
            near = gather(every, place, radius, grid, np.int64(MOST_POINTS))
        m = len(near)
        if m < FEWEST_POINTS:
            continue
        # lengths in radii from here on
        local = in_radii(points, near, places[i], radius)
        axes = tangent_axes(local)
        if axes[2, 0] < 0.0:
            for a in range(3):
                axes[a, 0] = -axes[a, 0]
        design, across = quadric_terms(local, axes)
        used, rest = np.ones(m, dtype=np.bool_), np.empty(m)
        for _ in range(ROUNDS):
            count = 0
            normal[:, :] = 0.0
            right[:] = 0.0
            for j in range(m):
                if used[j]:
                    count += 1
                    for a in range(6):
                        right[a] += design[j, a] * across[j]
                        for b in range(a + 1):
                            normal[a, b] += design[j, a] * design[j, b]
            if count < FEWEST_POINTS:
                break
            for a in range(6):
                normal[a, a] += 1e-6 * count
            factorise(normal)
            solve_factorised(normal, right)
            square = 0.0
            for j in range(m):
                rest[j] = across[j]
                for a in range(6):
                    rest[j] -= design[j, a] * right[a]
                square += rest[j] * rest[j] if used[j] else 0.0
            scatter = np.sqrt(square / (count - 6))
            out[i, SCATTER], out[i, RADIUS] = scatter * radius, radius
            for a in range(3):
                out[i, MIDDLE + a] = places[i, a]
                for b in range(3):
                    out[i, AXES + 3 * a + b] = axes[a, b]
            for a in range(6):
                out[i, TERMS + a] = right[a]
            if scatter * radius <= limit or axes[2, 0] < LEAST_RISE:
                break
            for j in range(m):
                used[j] &= rest[j] < ABOVE * scatter
