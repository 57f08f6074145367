"""How far off targets leave the frames of a pair, learned from the units that rest: the scale of datum ``control`` and of its test.

The error of a frame between targets is a draw of a few independent values: the bends of one that bends, and of a rigid one the shift and
turn that all units share. What a model says of its size is right over many coasts and may be off by a factor on each of them; resting
units show the draw itself. Its variance is scaled so that their mean squared normalised error is that of the stated deviations, and the
statistic so that its level among them is the stated one (an empirical null distribution: Efron, 2004, JASA 99), since the squares of few
bends have not the tails of a chi-square of many. What *all* units of a structure do together would pass for such an error, which is why
both factors have bounds, and why a rigid pair whose common motion contradicts its control keeps the model's own size.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import brentq
from scipy.sparse import csr_array
from scipy.special import chdtri

from ..common.arrays import FloatArray
from ..registration.frame_field import FieldEstimate, LocalMotions
from ..registration.transformation import rigid_jacobian
from .congruence import Congruence, pooled_degrees, quadratic
from .null_model import NullModel, f_p_value

LEVEL = 0.05
"""Share of resting units that the test of datum ``control`` is to call significant at this level."""
FEWEST_RESTING = 15
"""Resting units from which the scale is learned."""
LEAST_SIZE, MOST_SIZE = 0.2, 4.0
LEAST_FACTOR, MOST_FACTOR = 0.5, 1.6
"""Bounds of the factors of the variance and of the statistic."""
RAREST_DRAW = 0.001
"""Share of coasts on which so few bends are smaller, or larger, than the bounds of the variance, where those above are closer: a bowl is
two or three, and so is the shift of a rigid frame."""
LARGEST_MISFIT = 16.0
"""Normalised square up to which one coordinate counts."""
COMMON_LEVEL = 0.01
"""p-value of a rigid pair's common motion against control below which it is no draw of the control's error."""
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
    """Scale of datum ``control`` of frames that bend; of too few units what a size of so few degrees of freedom is worth.

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
    bends = _independent_bends(control.basis.design(_some(places)), control.covariance)
    size, factor = _size_and_factor(control.at(places), displacements, own, null, bends)
    return ControlScale(size=size, factor=factor, degrees=math.inf, bends=bends)


def with_rigid_scale(congruence: Congruence, displacements: FloatArray, covariances: FloatArray, points: FloatArray) -> Congruence:
    """The congruence of two rigid frames with datum ``control`` as its resting units show it.

    It stays as it is without control, with too few units, and where the common motion is none that the control's error explains: then
    the structure moved, and no unit is to hide it.

    Parameters
    ----------
    congruence
        Of the pair.
    displacements, covariances, points
        (n, 3), (n, 3, 3), (n, 3) as they entered it, metres.
    """
    resting = congruence.stable
    if resting.sum() < FEWEST_RESTING or not congruence.common_p_value >= COMMON_LEVEL:
        return congruence
    null = congruence.null
    effective = null.covariance(covariances)
    known = congruence.rigid_motions(points[resting], "control")
    bends = _independent_bends(rigid_jacobian(_some(points[resting]) - congruence.origin).reshape(-1, 7), congruence.prior)
    size, factor = _size_and_factor(known, displacements[resting], effective[resting], null, bends)
    scaled = replace(congruence, prior=congruence.prior * size)
    frame = scaled.rigid_motions(points, "control").covariances[:, :3, :3]
    statistics = quadratic(displacements, effective + frame) / factor
    return replace(
        scaled,
        control_statistics=statistics,
        control_p_values=f_p_value(statistics, pooled_degrees(effective, null.tail, frame, math.inf)),
        control_degrees=math.inf,
        control_factor=factor,
    )


def _size_and_factor(known: LocalMotions, displacements: FloatArray, own: FloatArray, null: NullModel, bends: float) -> tuple[float, float]:
    """Factors of the variance of the frames, a draw of so many bends, and of the statistic, by (n, 3) displacements of units at rest."""
    least = min(LEAST_SIZE, float(chdtri(bends, 1 - RAREST_DRAW)) / bends)
    most = max(MOST_SIZE, float(chdtri(bends, RAREST_DRAW)) / bends)
    away, frame = displacements - known.means[:, :3], known.covariances[:, :3, :3]
    squares = away**2
    units, frames = (np.einsum("nii->ni", part) for part in (null.spread * own, frame))

    def excess(size: float) -> float:
        return float(np.mean(np.minimum(squares / (units + size * frames), LARGEST_MISFIT))) - 1.0

    if excess(least) <= 0:
        size = least
    elif excess(most) >= 0:
        size = most
    else:
        size = float(brentq(excess, least, most))
    p_values = f_p_value(quadratic(away, own + size * frame), pooled_degrees(own, null.tail, size * frame, math.inf))
    factor = float(chdtri(3, np.quantile(p_values, LEVEL)) / chdtri(3, LEVEL))
    return size, min(max(factor, LEAST_FACTOR), MOST_FACTOR)


def _some(places: FloatArray) -> FloatArray:
    """An even choice of (n, 3) places."""
    return places[:: max(1, -(-len(places) // MOST_PLACES))]


def _independent_bends(design: FloatArray | csr_array, unknowns: FloatArray) -> float:
    """Degrees of freedom of the sum of squares of a frame's error (Satterthwaite, 1946, Biometrics Bulletin 2(6)).

    Parameters
    ----------
    design
        (3 k, u) rows of the shifts at k places.
    unknowns
        (u, u) covariance of what they depend on.
    """
    covariance = design @ (design @ unknowns).T
    deviations = np.sqrt(np.diag(covariance))
    correlation = covariance / np.outer(deviations, deviations)
    return float(len(deviations) ** 2 / np.sum(correlation**2))
