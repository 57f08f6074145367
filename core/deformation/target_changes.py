"""Targets held against the ground around them: how a target's place in the cloud changed between two epochs, and what units say of it.

Two epochs measure a target at one surveyed place, so that its residuals differ by the difference of the frames there, which units at
rest around it know within millimetres however the frames bend from target to target. A target that differs otherwise was disturbed in one
of the epochs. Where a station's targets all differ alike, the ground moved and no target was disturbed.
"""

from __future__ import annotations

import math

import numpy as np

from ..common.arrays import FloatArray
from ..common.robust import CHI2_3_MEDIAN
from ..registration.frame_field import LocalMotions
from .congruence import quadratic
from .null_model import f_p_value

FEWEST_NEIGHBOURS = 2
"""Targets of a station that must differ alike from the ground for it to have moved."""


def p_values_of_changes(
    differences: FloatArray, variances: FloatArray, ground: LocalMotions, along: FloatArray, reach: float
) -> FloatArray:
    """(k,) p-values of the changes of targets against those of the ground, or of their station where that agrees better.

    Parameters
    ----------
    differences, variances
        (k, 3) later residual less the earlier one, metres, and its stated variance, square metres: the least that is believed, as how far
        off most targets are is seen here.
    ground
        Difference of the frames at the k targets, as units see it.
    along
        (k,) where the targets lie along the structure, metres.
    reach
        Distance within which targets are one station, metres.
    """
    away = differences - ground.means[:, :3]
    own = np.stack([np.diag(v) for v in variances])
    form = quadratic(away, own + ground.covariances[:, :3, :3])
    for k in range(len(away)):
        near = np.flatnonzero((np.abs(along - along[k]) < reach) & (np.arange(len(away)) != k))
        if len(near) < FEWEST_NEIGHBOURS:
            continue
        # a median of many is less certain than their mean by pi / 2
        spread = own[k] * (1 + math.pi / 2 / len(near))
        form[k] = min(form[k], quadratic((away[k] - np.median(away[near], axis=0))[None], spread[None])[0])
    size = max(float(np.median(form)) / CHI2_3_MEDIAN, 1.0) if len(form) else 1.0
    # a median knows a variance about as well as the squares of two thirds of its values do
    return f_p_value(form / size, 2.0 * len(form))
