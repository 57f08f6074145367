"""Units that are known already, as a step that adjusts them takes them, and the points of each."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..data.tiles import PointCloud
from ..model.unit_types import UnitType


class GivenUnit(NamedTuple):
    """A unit that is known already, and what was known of it; nan where that was not said.

    Attributes
    ----------
    kind
        Index of its type.
    pose
        Absolute centre and row-major rotation, (12,).
    status
        ``found`` or ``uncertain``.
    score, coverage, supported, legs_visible
        As in the layer ``units``.
    """

    kind: int
    pose: tuple[float, ...]
    status: str = "found"
    score: float = math.nan
    coverage: float = math.nan
    supported: float = math.nan
    legs_visible: int = 0


def place_given(cloud: PointCloud, given: Sequence[GivenUnit], units: Sequence[UnitType]) -> tuple[FloatArray, IntArray]:
    """Reduced poses of known units, and their points: each goes to the unit whose surface is nearest, or to none where it is contested.

    Returns
    -------
    poses
        (k, 12) centre less the cloud's origin and row-major rotation.
    labels
        (n,) which unit each point of the cloud belongs to, or -1.
    """
    from ..segmentation.segment import KnownUnits, points_of_known
    from ..segmentation.surface_elements import surface_noise

    poses = np.array([unit.pose for unit in given], dtype=np.float64).reshape(-1, 12)
    poses[:, :3] -= cloud.origin
    kinds = np.array([unit.kind for unit in given], dtype=np.int64)
    known = []
    for kind in np.unique(kinds):
        members = np.flatnonzero(kinds == kind)
        noise = surface_noise(cloud.xyz, units[kind].height) if len(cloud) >= 50 else 0.0
        known.append(KnownUnits(units[kind], poses[members], noise, members))
    return poses, points_of_known(cloud.xyz, known)
