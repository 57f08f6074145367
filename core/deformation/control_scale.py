"""How far off targets leave the frames of a pair, learned from the units that rest: the scale of datum ``control`` and of its test.

The error of a bent frame between targets is a draw of a few independent bends. What a model says of its size is right over many coasts
and may be off by a factor on each of them; resting units show the draw itself. Its variance is scaled so that their mean squared
normalised error is that of the stated deviations, and the statistic so that its level among them is the stated one (an empirical null
distribution: Efron, 2004, JASA 99), since the squares of few bends have not the tails of a chi-square of many. What *all* units of a
structure do together would pass for such an error, which is why both factors have bounds.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq
from scipy.special import chdtri

from ..common.arrays import FloatArray
from ..registration.frame_field import FieldEstimate
from .congruence import NullModel, f_p_value, pooled_degrees, quadratic

LEVEL = 0.05
"""Share of resting units that the test of datum ``control`` is to call significant at this level."""
FEWEST_RESTING = 15
"""Resting units from which the scale is learned."""
LEAST_SIZE, MOST_SIZE = 0.2, 4.0
LEAST_FACTOR, MOST_FACTOR = 0.5, 1.6
"""Bounds of the factors of the variance and of the statistic."""
LARGEST_MISFIT = 16.0
"""Normalised square up to which one coordinate counts."""
MOST_PLACES = 80
"""Places at which the degrees of freedom of a field are looked at."""


@dataclass(frozen=True, kw_only=True)
class ControlScale:
    """What resting units say of datum ``control``.

    Attributes
    ----------
    size
        Factor of the variance of what targets leave unknown.
    factor
        By which statistics are divided.
    degrees
        Degrees of freedom with which that variance is known.
    bends
        Independent bends that it was learned from; 0 where it was not.
    """

    size: float
    factor: float
    degrees: float
    bends: float


def scale_of_control(
    control: FieldEstimate, places: FloatArray, displacements: FloatArray, own: FloatArray, null: NullModel, degrees: float
) -> ControlScale:
    """Scale of datum ``control``; of too few units what a size of so few degrees of freedom is worth.

    Parameters
    ----------
    control
        Difference of the frames as targets see it, by the model.
    places, displacements
        (n, 3) of units at rest, metres.
    own
        (n, 3, 3) effective covariance of each one's own part.
    null
        Distribution of that part.
    degrees
        Degrees of freedom of the size by the model alone.
    """
    if len(places) < FEWEST_RESTING:
        return ControlScale(size=1 + 2 / degrees, factor=1.0, degrees=degrees, bends=0.0)
    known = control.at(places)
    away, frame = displacements - known.means[:, :3], known.covariances[:, :3, :3]
    squares = away**2
    units, frames = (np.einsum("nii->ni", part) for part in (null.spread * own, frame))

    def excess(size: float) -> float:
        return float(np.mean(np.minimum(squares / (units + size * frames), LARGEST_MISFIT))) - 1.0

    if excess(LEAST_SIZE) <= 0:
        size = LEAST_SIZE
    elif excess(MOST_SIZE) >= 0:
        size = MOST_SIZE
    else:
        size = float(brentq(excess, LEAST_SIZE, MOST_SIZE))
    p_values = f_p_value(quadratic(away, own + size * frame), pooled_degrees(own, null.tail, size * frame, np.inf))
    factor = float(chdtri(3, np.quantile(p_values, LEVEL)) / chdtri(3, LEVEL))
    return ControlScale(
        size=size, factor=min(max(factor, LEAST_FACTOR), MOST_FACTOR), degrees=np.inf, bends=_independent_bends(control, places)
    )


def _independent_bends(field: FieldEstimate, places: FloatArray) -> float:
    """Degrees of freedom of the sum of squares of a field's error at (n, 3) places (Satterthwaite, 1946, Biometrics Bulletin 2(6))."""
    design = field.basis.design(places[:: max(1, -(-len(places) // MOST_PLACES))])
    covariance = design @ (design @ field.covariance).T
    deviations = np.sqrt(np.diag(covariance))
    correlation = covariance / np.outer(deviations, deviations)
    return float(len(deviations) ** 2 / np.sum(correlation**2))
