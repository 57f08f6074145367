"""How near units lie to each other: centres, and volume of one inside another."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray
from ..model.unit_types import UnitType
from .verification import overlap

CLOSEST_HEIGHTS = 0.5
"""Two solid tetrapods cannot bring their centres nearer than about this many heights."""
REACH_HEIGHTS = 1.3
"""Units whose centres are farther apart than this cannot touch: each reaches 0.66 H."""


def nearest_centres(centres: FloatArray) -> FloatArray:
    """(k,) distance of each of (k, 3) centres to the nearest other one, metres; inf for a single unit."""
    if len(centres) < 2:
        return np.full(len(centres), np.inf)
    return np.asarray(cKDTree(centres).query(centres, k=2)[0][:, 1])


def overlap_shares(
    poses: FloatArray, kinds: NDArray[np.int64], units: Sequence[UnitType], accepted: NDArray[np.bool_] | None = None
) -> FloatArray:
    """(k,) largest share of each unit's volume that lies inside one other unit, 0 to 1.

    Parameters
    ----------
    poses
        (k, 12) centre in metres of one frame and rotation by rows.
    kinds, units
        (k,) index of each unit's type, and the types.
    accepted
        (k,) units that others may not enter; all unless given.
    """
    shares = np.zeros(len(poses))
    if len(poses) < 2:
        return shares
    reach = REACH_HEIGHTS * max(unit.height for unit in units)
    for i, j in cKDTree(poses[:, :3]).query_pairs(reach, output_type="ndarray"):
        for a, b in ((i, j), (j, i)):
            if accepted is None or accepted[b]:
                shares[a] = max(shares[a], overlap(poses[a], poses[b], units[kinds[a]], units[kinds[b]]))
    return shares
