"""How real castings differ from ideal cones: the mould that all units share, and what each casting has of its own.

Measured on seven real units, H = 2.92 m, in two patches of a photogrammetric cloud of the Ajaccio breakwater (create_models/results of
github.com/nicolasplantier/Find-generic-model-tetrapod, MIT licence); see docs/method.md. All figures are shares of the height.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..common.arrays import FloatArray
from ..model.tetrapod import END_DISC, relate, turn_around
from ..model.unit_types import UnitType

SIZE_SD = 0.007
"""Relative standard deviation of the size of units."""
PROFILE_PLACES = (0.0, 0.2, 0.30, 0.35, 0.84, 0.90, 0.95, 1.0)
PROFILE = (0.0038, 0.0038, 0.0020, 0.0, 0.0, -0.0058, -0.0082, -0.0106)
"""Mean deviation along a leg: a dimple of 11 mm below 0.3 of its length, straight to 0.85, a tip rounded by 17 to 31 mm beyond 0.9."""
AROUND = 0.0005
"""Amplitude of the mould's deviation three times around a leg, within the 2 mm to which a leg is straight."""
RADIUS_SD = 0.0024
"""Of the radius of single legs: 7 mm."""
TAPER_SD = 0.0010
AXIS_SD, TILT_SD, OVALITY_SD = 0.0015, 0.0008, 0.0012
"""By component across the leg: together they make 5 to 10 mm around a leg."""
LENGTH_SD = 0.0020


@dataclass(frozen=True, eq=False)
class Casting:
    """Deviations of one unit from its mould, metres, by leg.

    Attributes
    ----------
    radius, taper, length
        (4,) of the leg's radius, of its change from the middle of the leg to 0.3 of its length farther out, and of the leg's length.
    axis, tilt, oval
        (4, 2) along two directions across the leg: offset of its axis, its change as for ``taper``, and the two components of ovality.
    """

    radius: FloatArray
    taper: FloatArray
    length: FloatArray
    axis: FloatArray
    tilt: FloatArray
    oval: FloatArray

    @classmethod
    def drawn(cls, height: float, rng: np.random.Generator) -> Casting:
        """A casting of a unit of a height in metres."""
        sds = (RADIUS_SD, TAPER_SD, LENGTH_SD, AXIS_SD, TILT_SD, OVALITY_SD)
        return cls(*(rng.normal(0, sd * height, (4,) if k < 3 else (4, 2)) for k, sd in enumerate(sds)))

    def deviation(self, body: FloatArray, unit: UnitType) -> FloatArray:
        """(n,) metres by which the surface lies outside the ideal cones next to (n, 3) points of the body frame, mould included."""
        relation = relate(body, unit)
        leg, along = relation.leg, relation.axial / unit.leg_length
        turn = turn_around(body, leg, unit)
        mould = unit.height * (np.interp(along, PROFILE_PLACES, PROFILE) + AROUND * np.cos(3 * turn))
        lever = (along - 0.55) / 0.3
        around, twice = (np.column_stack([np.cos(k * turn), np.sin(k * turn)]) for k in (1, 2))
        own = self.radius[leg] + self.taper[leg] * lever
        own += np.sum((self.axis[leg] + self.tilt[leg] * lever[:, None]) * around + self.oval[leg] * twice, axis=1)
        return np.where(relation.part == END_DISC, self.length[leg], mould + own)
