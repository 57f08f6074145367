"""Rays that pass through where the end of a leg should be.

The beam of every point was free from the sensor to the point. Where points of one strip or station lie behind the end of a leg, as seen
from the sensor, the end is not there. Where the sensor stood is told by the units themselves (:mod:`.sensor_places`): no beam of the source
may enter what surely stands. Places are weighed by how many do, and the evidence is the ratio of two likelihoods: of what all places say if
the end is missing, and if beams through it are as rare as those through what stands. An end is missed only if the beams that pass through
its place cannot have come from another one.
Sources that mix many places, as clouds of images do, have no such place and say nothing.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp

from ..common.arrays import BoolArray, FloatArray
from ..common.voxels import thin
from ..model.unit_types import UnitType
from .beams import passing_beams
from .sensor_places import (
    BEAM_COST,
    FEWEST_POINTS,
    ROUNDED,
    ROUNDS,
    STRAYS,
    TRIED_AT_ONCE,
    Around,
    Solids,
    Source,
    spread_evenly,
)

VOXEL_HEIGHTS = 0.03
MOST_BEAMS = 80
"""Beams through the place of an end beyond which more say no more."""


class Passing(NamedTuple):
    """Beams through the place of an end: log-likelihood ratio of its being missing, and where along the leg they come nearest to the centre
    (metres): it breaks before."""

    evidence: float
    place: float


class SeenThrough:
    """Beams through the legs of the units of one cloud."""

    def __init__(
        self, points: FloatArray, sources: NDArray[Any], poses: FloatArray, whole: BoolArray, unit: UnitType, noise: float
    ) -> None:
        """Look at (n, 3) points of a cloud, metres, and the (n,) strips or stations they come from, with units of one type.

        ``poses`` are (k, 12) centres and row-major rotations, ``whole`` (k, 4) legs that are known to be whole, and ``noise`` the standard
        deviation of a point across the surface, metres.
        """
        self._unit, self._solids = unit, Solids(poses, whole, unit, noise)
        voxel = VOXEL_HEIGHTS * unit.height
        self._sources = [Source(thin(points[sources == source], voxel)[0], self._solids) for source in np.unique(sources)]
        self._around: tuple[int, list[Around]] = -1, []

    def through(self, number: int, leg: int, first: float) -> Passing:
        """Beams that pass through a unit's leg between ``first`` (metres along it) and its end."""
        end = self._solids.axes[number, leg], first, ROUNDED * self._unit.leg_length
        evidence, places = 0.0, [np.empty(0)]
        if self._around[0] != number:
            # the legs of a unit are asked about one after the other
            self._around = number, [source.around(number) for source in self._sources]
        for source, own in zip(self._sources, self._around[1], strict=True):
            if len(own.points) < FEWEST_POINTS:
                continue
            # where no beam passes from one place that the sensor may have stood at, the others need not be known
            if source.shared() is None and not source.knows(number) and self._none_passes(number, own, source.stood(number), end):
                continue
            stands = source.stands(number, own)
            if len(stands.places):
                count, along = passing_beams(own.points, stands.places, stands.drifts, *end, *self._solids.cone, MOST_BEAMS)
                whole = stands.likelihoods - BEAM_COST * count
                evidence += float(logsumexp(stands.likelihoods) - logsumexp(whole))
                likeliest = int(np.where(count > 0, whole, -np.inf).argmax())
                places.append(along[likeliest, : count[likeliest]])
        passed = np.concatenate(places)
        return Passing(evidence, float(np.quantile(passed, 0.02)) if len(passed) else 0.0)

    def _none_passes(self, number: int, own: Around, stands: FloatArray, end: tuple[FloatArray, float, float]) -> bool:
        """Whether the sensor stood as likely as anywhere at one of (m, 3) places from which no beam passes through the end of a leg."""
        some = spread_evenly(own.nearest, ROUNDS[-1][0])
        most = int(STRAYS * len(some))
        for first in range(0, len(stands), TRIED_AT_ONCE):
            tried = stands[first : first + TRIED_AT_ONCE]
            still = np.zeros_like(tried)
            passing = passing_beams(own.points, tried, still, *end, *self._solids.cone, 1)[0] > 0
            if (self._solids.entered(number, some, (tried[~passing], still[~passing]), most, one=True) <= most).any():
                return True
        return False
