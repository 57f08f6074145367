"""Whether points that lie beside each other share their noise, as dense matching of images makes them.

A matcher compares windows and asks for smooth depths, so that its errors are alike over some pixels (Hirschmüller, 2008); a range finder
errs anew at every point. Where neighbours share the noise, a surface smoothed through them follows it and seems several times better known
than it is: what lies beside a unit's surface by the noise looks like another surface then.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.kernels import in_parts, kernel
from ..common.neighbourhood import build_grid, gather
from .smoothed_surface import MOST_POINTS, TINY, in_radii, quadric_terms, robust_quadric, tangent_axes

RADIUS_RATIO = 0.1
"""Radius of the patches, as a share of the height: half the radius of a leg, so that a quadric leaves hardly anything of its surface."""
FEWEST_POINTS = 36
"""Of a patch: six for each parameter of a quadric."""
PROBES, FEWEST_PROBES = 800, 100
"""Patches that are asked, about and at least."""
ON_SURFACE = 3.0
"""Distance from the quadric, in standard deviations of a point, up to which a point is of the surface."""
SAME_PLACE = 1e-10
"""Squared distance, in radii of a patch, up to which a point is the same again, and no neighbour."""
SHARED = 0.1
"""Correlation of a point's deviation with that of the nearest one, median over the patches, from which neighbours share their noise. Added
noise of 1.3 to 3.3 % of H leaves -0.03 to 0.05 on UAV strips and scans of any density, simulated matching noise of 1.2 % 0.17 to 0.26."""


def neighbours_share_noise(points: FloatArray, places: FloatArray, height: float, noise: float) -> bool:
    """Whether (n, 3) raw points, reduced frame, deviate from their surface as their neighbours do; not where patches hold too few.

    Parameters
    ----------
    places
        (k, 3) thinned points of the cloud: about some of them it is asked.
    height, noise
        Of a unit, and standard deviation of a point across the surface, metres.
    """
    some = np.ascontiguousarray(places[:: max(len(places) // PROBES, 1)])
    correlations = np.full(len(some), np.nan)
    radius = RADIUS_RATIO * height
    grid, every = build_grid(points, radius), np.ones(len(points), dtype=np.bool_)
    asked = partial(_correlations, points=points, every=every, places=some, radius=radius, noise=noise, grid=grid, out=correlations)
    in_parts(asked, len(some))
    known = correlations[np.isfinite(correlations)]
    return bool(len(known) >= FEWEST_PROBES and np.median(known) > SHARED)


@kernel(releases=True)
def _correlations(first: int, last: int, points: Any, every: Any, places: Any, radius: float, noise: float, grid: Any, out: Any) -> None:
    """Correlations of deviations with those of nearest points into ``out`` (k,), by place."""
    for i in range(first, last):
        near = gather(every, (places[i, 0], places[i, 1], places[i, 2]), radius, grid, np.int64(MOST_POINTS))
        if len(near) < FEWEST_POINTS:
            continue
        # lengths in radii from here on
        local = in_radii(points, near, places[i], radius)
        axes = tangent_axes(local)
        solution, _, _ = robust_quadric(local, axes, noise / radius)
        design, across = quadric_terms(local, axes)
        rest = across - design @ solution
        own = np.flatnonzero(np.abs(rest) < ON_SURFACE * noise / radius)
        if len(own) < FEWEST_POINTS:
            continue
        product, square = 0.0, TINY
        for this in own:
            least, nearest = np.inf, int(this)
            for other in own:
                away = (design[this, 1] - design[other, 1]) ** 2 + (design[this, 2] - design[other, 2]) ** 2
                if SAME_PLACE < away < least:
                    least, nearest = away, int(other)
            product += rest[this] * rest[nearest]
            square += rest[this] ** 2
        out[i] = product / square
