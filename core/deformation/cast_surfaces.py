"""Surfaces of one kind of unit during the joint adjustment: what is known of them, learned anew as the poses come right."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..adjustment.shape_effects import CellSums, Eliminated, eliminate, prior_surface, surface_of
from ..adjustment.surface_estimation import SampledUnit, estimate_surface
from ..common.arrays import FloatArray
from ..model.mould import Mould

SAMPLE_UNITS = 40
"""Units, those that show most, from which the surface is learned."""

MISFIT_DEGREES = 10.0
"""Of the t distribution of single units: a pose that is wrong, a chipped casting or points of others make all of its cells depart. Learned
on seven simulated surveys, held on seven others."""
TELLING_DEGREES, TELLING_UNITS = 60, 6
"""Cells beyond the unknowns of its poses from which a unit says how far castings depart as a rule, and the fewest units that tell."""

MILLIMETRE = 0.001
LARGEST_HALF = 6e4
"""Largest number that half precision holds, nearly."""


class CastSurfaces:
    """What is known of the surfaces of the units of one kind.

    Attributes
    ----------
    model
        Mould and variances.
    learned
        Whether they come from this survey.
    """

    def __init__(self, height: float, mould: Mould | None = None) -> None:
        self.height = height
        self._stored = None if mould is None else surface_of(mould, height)
        self.model = self._stored or prior_surface(height)
        self.learned = False
        self._covariance = self.model.covariance
        self._deviations: dict[int, NDArray[np.float16]] = {}
        self._own: dict[int, tuple[NDArray[np.float16], ...]] = {}
        self._apart: dict[int, NDArray[np.float16]] = {}
        self._sample: dict[int, tuple[float, SampledUnit]] = {}
        self._misfits: dict[int, tuple[float, int]] = {}

    def expected(self, unit: int) -> FloatArray:
        """(CELLS,) deviations of a unit's cells as far as they are known, metres."""
        return self._deviations[unit].astype(np.float64) * MILLIMETRE if self.learned and unit in self._deviations else self.model.mean

    @property
    def roughness(self) -> float:
        """Standard deviation of single points about :meth:`expected`, metres, noise apart."""
        return math.sqrt(self.model.own + float(self.model.variances[-2:].sum()))

    def reduced(self, unit: int, normal: FloatArray, rhs: FloatArray, sightings: Sequence[CellSums], tied: Sequence[bool]) -> Eliminated:
        """Normal equations of a unit without the deviations of its cells; nothing is changed, so that units may be reduced side by side.

        Sightings that are not ``tied``, never all, have a surface of their own, as if of another casting: which cells they show is unknown.
        """
        known = [own.astype(np.float64) * MILLIMETRE**2 for own in self._own.get(unit, ())]
        apart = self._apart[unit].astype(np.float64) * MILLIMETRE**2 if self.learned and unit in self._apart else None
        own = [np.zeros(0)] * len(sightings)
        results: list[Eliminated] = []
        for group in [np.flatnonzero(tied), *np.flatnonzero(~np.asarray(tied))[:, None]]:
            seen, variances = [sightings[k] for k in group], [known[k] for k in group] if known else None
            found = eliminate(normal, rhs, seen, self.model, self._covariance, variances, None if results else apart)
            normal, rhs = found.normal, found.rhs
            for k, variance in zip(group, found.own, strict=True):
                own[k] = variance
            results.append(found)
        misfit, cells = sum(found.misfit for found in results), sum(found.seen for found in results)
        return replace(results[0], normal=normal, rhs=rhs, own=tuple(own), misfit=misfit, seen=cells)

    def keep(self, unit: int, scale: float, found: Eliminated, sightings: Sequence[CellSums], unknowns: int) -> None:
        """Keep what the reduction of a unit of relative size 1 + ``scale`` found of its surface.

        The first ``unknowns`` of its equations are its poses and its size.
        """
        # kept for every unit of the survey: three digits of millimetres and their squares are plenty
        self._deviations[unit] = (found.deviations / MILLIMETRE).astype(np.float16)
        self._own[unit] = tuple(np.minimum(own / MILLIMETRE**2, LARGEST_HALF).astype(np.float16) for own in found.own)
        self._apart[unit] = np.minimum(found.apart / MILLIMETRE**2, LARGEST_HALF).astype(np.float16)
        self._misfits[unit] = found.misfit, found.seen - unknowns
        seen = float(found.seen)
        weakest = None
        if unit not in self._sample and len(self._sample) >= SAMPLE_UNITS:
            weakest = min(self._sample, key=lambda k: self._sample[k][0])
        if weakest is None or seen > self._sample[weakest][0]:
            if weakest is not None:
                del self._sample[weakest]
            own = [CellSums(s.rows[:, :unknowns].copy(), s.weight, s.rhs, s.square, s.noise) for s in sightings]
            self._sample[unit] = (seen, SampledUnit(scale, own, found.own, found.apart))

    def factors(self) -> dict[int, float]:
        """By unit reduced last, the factor, one or more, of its variances for departing from the mould by more than others do.

        How far a unit departs is taken for a scale of its own, so that its deviations have a t distribution of ``MISFIT_DEGREES``. What
        is usual is the median of the units that show enough to tell; with few such no unit is held against others.
        """
        usual = [form / degrees for form, degrees in self._misfits.values() if degrees >= TELLING_DEGREES]
        if len(usual) < TELLING_UNITS:
            return {}
        middle = float(np.median(usual))
        return {
            unit: max((MISFIT_DEGREES + form / middle) / (MISFIT_DEGREES + degrees), 1.0)
            for unit, (form, degrees) in self._misfits.items()
            if degrees > 0
        }

    def learn(self) -> None:
        """Learn mould and variances from the units reduced last."""
        self.model = estimate_surface([unit for _, unit in self._sample.values()], self.height, self.model, self._stored)
        self._covariance = self.model.covariance
        self.learned = True
