"""Whether the legs of all units of a cloud are whole."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import BoolArray, FloatArray
from ..common.neighbourhood import build_grid
from ..model.unit_types import UnitType
from .leg_ends import LegEnds, LegView, leg_ends
from .seen_through import SeenThrough
from .sight_lines import SightLines
from .surface_elements import surface_noise

REACHES = 1.1
"""Distance from a unit's centre, in its reaches, within which points say whether its legs are whole."""
CELL_HEIGHTS = 0.3
"""Edge of the cells in which a cloud's points are looked up."""
FEWEST_POINTS = 50
"""Points of a cloud that tell its noise."""


def ends_of_units(
    points: FloatArray,
    sources: NDArray[Any],
    poses: FloatArray,
    kinds: NDArray[Any],
    certain: BoolArray,
    units: Sequence[UnitType],
) -> list[LegEnds]:
    """Ends of the legs of each unit.

    Parameters
    ----------
    points, sources
        (n, 3) the cloud, metres, and (n,) the strips or stations that its points come from.
    poses, kinds, certain
        (k, 12) centres and row-major rotations, (k,) indices into ``units``, and (k,) whether the pose is sure: one that may be wrong
        would call any surface that crosses it a face of fracture, so that nothing is said of it.
    """
    found = [LegEnds.unseen() for _ in poses]
    if not len(poses) or not len(points):
        return found
    grid = build_grid(points, CELL_HEIGHTS * min(unit.height for unit in units))
    for kind in np.unique(kinds):
        unit, of_kind = units[int(kind)], kinds == kind
        noise = surface_noise(points, unit.height) if len(points) >= FEWEST_POINTS else 0.0
        lines = SightLines(points, grid, poses[of_kind], unit, noise)
        own = np.flatnonzero(of_kind & certain)
        around = [points[grid.within(poses[row, :3], REACHES * unit.reach)] for row in own]
        views = [LegView(_body(near, poses[row]), unit, noise) for near, row in zip(around, own, strict=True)]
        whole = np.array([view.sides_to_end() for view in views], dtype=np.bool_).reshape(-1, 4)
        through = SeenThrough(points, sources, poses[own], whole, unit, noise)
        places = np.cumsum(of_kind) - 1
        for k, (row, view) in enumerate(zip(own, views, strict=True)):
            found[row] = leg_ends(view, partial(lines.missing, int(places[row])), partial(through.through, k))
    return found


def _body(points: FloatArray, pose: FloatArray) -> FloatArray:
    """(n, 3) points in the body frame of a (12,) pose."""
    return np.asarray((points - pose[:3]) @ pose[3:].reshape(3, 3))
