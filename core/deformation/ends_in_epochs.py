"""Ends of legs that the points of one epoch show once the unit is adjusted together with other epochs.

The fit of a single epoch uses the end disc of a leg where the points show a plane at the nominal length. Where its pose was off, it missed
discs that another epoch uses, and what the two then differ by along the leg is no motion.
"""

from __future__ import annotations

import math

import numpy as np

from ..adjustment.adjustment_records import LENGTH_SD
from ..adjustment.visible_parts import beyond_ends, most_beyond, plane_beyond
from ..common.arrays import FloatArray
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
    asked = np.flatnonzero(~body.discs)
    beyond, near = beyond_ends((points - body.centre) @ body.rotation, body.axes[asked], body.length, max(rim, 0.0), noise)
    for leg, lengths, own in zip(asked, beyond.T, near.T, strict=True):
        middle = plane_beyond(lengths[own], noise)
        axis = body.rotation @ body.axes[leg]
        shift_sd = math.sqrt(max(float(axis @ covariance @ axis), 0.0))
        mean_sd = noise / math.sqrt(max(int(np.count_nonzero(own)), 1))
        if middle is not None and abs(middle) < most_beyond(height, LENGTH_SD * body.length, shift_sd, mean_sd):
            found[leg] = middle
    return found


def way_to_ends(shown: FloatArray, body: Body, noise: float) -> FloatArray:
    """(3,) way of the centre that brings ends which lie far from their (4,) :func:`ends_shown` there, metres."""
    far = np.where(np.abs(shown) > FAR_IN_NOISE * noise, shown, 0.0)
    return np.asarray(body.rotation @ (far @ body.axes))
