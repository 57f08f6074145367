"""Ends of legs that the points of one epoch show once the unit is adjusted together with other epochs.

The fit of a single epoch uses the end disc of a leg where the points show a plane at the nominal length. Where its pose was off, it missed
discs that another epoch uses, and what the two then differ by along the leg is no motion.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..adjustment.adjustment_records import LENGTH_SD
from ..adjustment.visible_parts import farthest_from_end, most_beyond, plane_beyond
from ..common.arrays import FloatArray
from ..common.kernels import kernel
from .strip_observations import Body

FAR_IN_NOISE = 2.0
"""Distance of a plane from the end of its leg, in standard deviations of a point, beyond which the unit is moved there: robust weights
would doubt what lies farther off."""


def ends_shown(points: FloatArray, body: Body, covariance: FloatArray, height: float, margin: float, noise: float) -> FloatArray:
    """(4,) how far beyond the ends of legs without an end disc the points show one in place, metres; nan where they do not.

    Parameters
    ----------
    points
        (n, 3) of one sighting.
    covariance
        (3, 3) of its centre, square metres.
    height
        Of the unit, metres.
    margin
        Distance from the rim within which points are left out, metres.
    noise
        Standard deviation of a point, metres.
    """
    found = np.full(4, math.nan)
    rim = body.radius - body.gradient * body.length - margin
    beyond, counts = np.empty((4, len(points) + 1)), np.zeros(4, dtype=np.int64)
    _near_ends(np.ascontiguousarray(points), body, (max(rim, 0.0), farthest_from_end(body.length, noise)), beyond, counts)
    for leg in np.flatnonzero(~body.discs):
        lengths = beyond[leg, : counts[leg]]
        middle = plane_beyond(lengths, noise)
        axis = body.rotation @ body.axes[leg]
        shift_sd = math.sqrt(max(float(axis @ covariance @ axis), 0.0))
        mean_sd = noise / math.sqrt(max(len(lengths), 1))
        if middle is not None and abs(middle) < most_beyond(height, LENGTH_SD * body.length, shift_sd, mean_sd):
            found[leg] = middle
    return found


def way_to_ends(shown: FloatArray, body: Body, noise: float) -> FloatArray:
    """(3,) way of the centre that brings ends which lie far from their (4,) :func:`ends_shown` there, metres."""
    far = np.where(np.abs(shown) > FAR_IN_NOISE * noise, shown, 0.0)
    return np.asarray(body.rotation @ (far @ body.axes))


@kernel(releases=True)
def _near_ends(points: Any, body: Any, limits: Any, beyond: Any, counts: Any) -> None:
    """How far points lie beyond the ends of legs without an end disc, into ``beyond`` (4, n + 1) and their ``counts`` (4,), of those that
    lie no farther from the axis and from the end than the ``limits``."""
    centre, rotation, axes, _, discs, _, _, length = body
    rim, reach = limits
    for i in range(len(points)):
        px, py, pz = points[i, 0] - centre[0], points[i, 1] - centre[1], points[i, 2] - centre[2]
        x = rotation[0, 0] * px + rotation[1, 0] * py + rotation[2, 0] * pz
        y = rotation[0, 1] * px + rotation[1, 1] * py + rotation[2, 1] * pz
        z = rotation[0, 2] * px + rotation[1, 2] * py + rotation[2, 2] * pz
        square = x * x + y * y + z * z
        for k in range(4):
            axial = x * axes[k, 0] + y * axes[k, 1] + z * axes[k, 2]
            beyond[k, counts[k]] = axial - length
            shown = not discs[k] and square - axial * axial < rim * rim and abs(axial - length) < reach
            counts[k] += 1 if shown else 0
