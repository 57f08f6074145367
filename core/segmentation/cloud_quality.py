"""How much a cloud shows of units: points per square of a unit's height, and noise as a share of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..common.arrays import FloatArray
from .surface_elements import SMOOTH_SHARE, surface_noise
from .unit_size import dense_windows

PLACES = 4
"""Places that are looked at: those that hold most surface, where the armour is."""
PLAN_CELL_RATIO = 0.2
"""Edge of the squares, as a share of the height, by which the area of these places that holds points is told."""
EDGE_SHARE = 0.2
"""Of the usual number of points of a square, below which it is not wholly within the cloud."""
FEWEST_POINTS = 50
"""Of a place that tells anything."""


@dataclass(frozen=True)
class CloudQuality:
    """What decides how much of a pile can be found.

    Attributes
    ----------
    density
        Points per square of edge H as seen from above.
    noise
        Standard deviation of a point across the surface as a share of H.
    """

    density: float
    noise: float


def cloud_quality(points: FloatArray, height: float) -> CloudQuality | None:
    """Quality of (n, 3) points in a reduced frame, metres, for units of a height in metres; None where too few points are together."""
    if len(points) < FEWEST_POINTS:
        return None
    places = [points[index] for index in dense_windows(points, height, PLACES) if len(index) >= FEWEST_POINTS]
    if not places:
        return None
    density = float(np.median([_density(place, height) for place in places]))
    noise = float(np.median([surface_noise(place, height) for place in places]))
    return CloudQuality(density=density, noise=noise / SMOOTH_SHARE / height)


def _density(points: FloatArray, height: float) -> float:
    """Points per square of edge H where there are points, squares at the edge of the cloud left out."""
    east, north = np.floor(points[:, :2] / (PLAN_CELL_RATIO * height)).astype(np.int64).T
    counts = np.unique(east * (np.ptp(north) + 1) + north - north.min(), return_counts=True)[1]
    return float(counts[counts >= EDGE_SHARE * np.median(counts)].mean()) / PLAN_CELL_RATIO**2
