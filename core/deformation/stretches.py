"""Common motion of stretches along the structure: settlement and sliding that single units, judged by their neighbours, cannot show.

A stretch's motion in datum ``control`` is the mean displacement of its units less what targets say of the frames there; in datum
``stable`` it is less what the units of all other stretches (and targets) say, so that a stretch cannot explain itself. Its covariance
holds the frames' common error, which does not become less with the number of units.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.noncentrality import noncentrality
from ..common.robust import t_weights
from ..registration.bending import axis_of
from ..registration.frame_field import FieldEstimate
from .congruence import Congruence, f_p_value, pooled_degrees
from .displacement import POWER, SIGNIFICANCE
from .elastic_congruence import ElasticDatum

STRETCH_HEIGHTS = 10.0
"""Length of a stretch in heights of a unit."""
FEWEST_UNITS = 5
MOST_UNKNOWNS = 2500
"""Unknowns of a field up to which it is adjusted anew without each stretch."""


@dataclass(frozen=True, eq=False, kw_only=True)
class StretchMotion:
    """Common motion of the units of one stretch in one datum.

    Attributes
    ----------
    place
        (3,) centroid of its units, metres.
    along_from, along_to
        Beginning and end along the structure, from the first unit, metres.
    units
        Units that were averaged.
    motion, covariance
        (3,), (3, 3) metres.
    p_value
        Test against zero.
    detectable
        Motion found with a power of 80 % in the worst direction, metres: what is less cannot be told from the frames' error.
    """

    place: FloatArray
    along_from: float
    along_to: float
    units: int
    motion: FloatArray
    covariance: FloatArray
    p_value: float
    detectable: float


@dataclass(frozen=True, eq=False, kw_only=True)
class JudgedUnits:
    """Units of a pair on which its datum may rest: (n, 3) places and displacements, (n, 3, 3) calibrated covariances."""

    places: FloatArray
    vectors: FloatArray
    covariances: FloatArray


def stretches_of(places: FloatArray, height: float) -> tuple[list[IntArray], FloatArray, float]:
    """Units of each stretch by number, where each of (n, 3) units lies along the structure (metres from the first), and a stretch's length.

    Stretches begin every half of their length, so that what slides lies for three quarters of it in one of them at least.
    """
    axis = axis_of(places[:, :2])[0] if len(places) > 1 else (1.0, 0.0)
    along = places[:, :2] @ np.array(axis)
    along = along - along.min() if len(along) else along
    length = float(along.max()) if len(along) else 0.0
    count = max(1, round(length / (STRETCH_HEIGHTS * height)))
    half = np.minimum((along / max(length, 1e-9) * 2 * count).astype(np.int64), 2 * count - 1)
    return [np.flatnonzero((half == k) | (half == k + 1)) for k in range(2 * count - 1)], along, length / count


def motions_of_stretches(
    units: JudgedUnits, congruence: Congruence, elastic: ElasticDatum | None, height: float
) -> dict[str, list[StretchMotion]]:
    """Common motion of every stretch with enough units, by datum."""
    stretches, _, length = stretches_of(units.places, height)
    known = {"stable": math.inf, "control": congruence.control_degrees}
    found: dict[str, list[StretchMotion]] = {"stable": [], "control": []}
    for k, own in enumerate(stretches):
        if len(own) < FEWEST_UNITS:
            continue
        for datum in found:
            means, spread = _frame_part(units, own, congruence, elastic, datum)
            motion, cofactor = _robust_mean(units.vectors[own] - means, units.covariances[own], height)
            covariance = cofactor + spread
            form = float(motion @ np.linalg.solve(covariance, motion))
            degrees = pooled_degrees(cofactor[None], len(own) * congruence.null.tail, spread[None], known[datum])[0]
            found[datum].append(
                StretchMotion(
                    place=units.places[own].mean(axis=0),
                    along_from=0.5 * k * length,
                    along_to=(0.5 * k + 1) * length,
                    units=len(own),
                    motion=motion,
                    covariance=covariance,
                    p_value=float(f_p_value(np.array([form]), degrees)[0]),
                    detectable=math.sqrt(noncentrality(SIGNIFICANCE, POWER) * float(np.linalg.eigvalsh(covariance)[-1])),
                )
            )
    return found


def _frame_part(
    units: JudgedUnits, own: IntArray, congruence: Congruence, elastic: ElasticDatum | None, datum: str
) -> tuple[FloatArray, FloatArray]:
    """Error of the frames at the units of a stretch (k, 3), as those outside and targets see it, and covariance of its mean (3, 3)."""
    places = units.places[own]
    if elastic is None:
        middle = congruence.rigid_motions(places.mean(axis=0)[None], datum)
        return congruence.rigid_motions(places, datum).means[:, :3], middle.covariances[0, :3, :3]
    field = elastic.control if datum == "control" else _without(units, own, elastic)
    return field.at(places).means[:, :3], field.covariance_of_mean(places)


def _without(units: JudgedUnits, own: IntArray, elastic: ElasticDatum) -> FieldEstimate:
    """Datum ``stable`` without the units of a stretch; of very long coasts that of all units."""
    if elastic.control.basis.size > MOST_UNKNOWNS:
        return elastic.stable
    keep: BoolArray = elastic.used.copy()
    keep[own] = False
    weights = np.asarray(np.linalg.inv(units.covariances[keep]), dtype=np.float64)
    return FieldEstimate.from_observations(
        elastic.control.basis, elastic.precision, units.places[keep], units.vectors[keep], weights, elastic.control.mean
    )


def _robust_mean(values: FloatArray, covariances: FloatArray, height: float) -> tuple[FloatArray, FloatArray]:
    """Mean of (k, 3) values that units which moved on their own do not pull, and its covariance."""
    centre = np.median(values, axis=0)
    inverse = np.linalg.inv(covariances + (0.002 * height) ** 2 * np.eye(3))
    cofactor = np.linalg.inv(inverse.sum(axis=0))
    for _ in range(8):
        residual = values - centre
        misfit = np.einsum("ni,nij,nj->n", residual, inverse, residual)
        weights, size = t_weights(misfit)
        weighted = inverse * weights[:, None, None]
        cofactor = np.linalg.inv(weighted.sum(axis=0)) * size
        centre = cofactor / size @ np.einsum("nij,nj->i", weighted, values)
    return centre, cofactor
