"""The mould of a kind of unit: its cones, how its surface departs from them, and how single castings vary; learned in one survey, used in
the next (METHOD 9).

The departure is given on a grid: rings along a leg, and around it a third of a turn, since a mould comes back three times around every leg.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from .tetrapod import LATERAL, relate, turn_around
from .unit_types import UnitType

AXIAL_CELLS, AZIMUTH_CELLS, DISC_CELLS = 10, 18, 3
"""Rings along a leg, cells around it, and cells of its end disc, in which the deviations of a surface are held."""
THIRD = AZIMUTH_CELLS // 3
VARIANCES = 9
"""Ways in which castings vary, see :data:`..adjustment.shape_effects.COMPONENTS`."""
LARGEST_DEVIATION = 0.05
"""Largest departure from the cones, as a share of the height, that a stored mould may have."""


@dataclass(frozen=True, kw_only=True)
class Mould:
    """A mould; lengths as shares of the unit's height.

    Attributes
    ----------
    name
        By which the user knows it.
    units
        Units that it was learned from.
    radius, gradient, leg_length
        Of the cones, see :class:`.UnitType`.
    side
        ``AXIAL_CELLS * THIRD`` departures from the cone along its normal, ring by ring, each around a third of a turn.
    disc
        Departure of the end disc.
    size_mean, size_sd
        Mean relative difference of castings from that size, and their standard deviation.
    sds
        Standard deviations of the ways in which castings vary.
    own, uneven
        Variance of what does not come back in a cell, square share of the height, and shares of the variance within a cell.
    """

    name: str
    units: int
    radius: float
    gradient: float
    leg_length: float
    side: tuple[float, ...]
    disc: float
    size_mean: float
    size_sd: float
    sds: tuple[float, ...]
    own: float
    uneven: tuple[float, float]

    def shaped(self, unit: UnitType) -> UnitType:
        """A unit type of the same height and opening with the mould's cones."""
        h = unit.height
        return replace(unit, radius=self.radius * h, gradient=self.gradient, leg_length=self.leg_length * h)

    @property
    def gradient_sd(self) -> float:
        """Standard deviation of the gradient of a casting whose four legs' tapers differ from the mould's."""
        # a taper is the change of the radius over 0.3 of the leg
        return self.sds[1] / (0.3 * self.leg_length) / 2

    def profile(self) -> tuple[FloatArray, FloatArray]:
        """(AXIAL_CELLS,) middles of the rings as shares of the leg, and the mean departure of each as a share of the height."""
        return (np.arange(AXIAL_CELLS) + 0.5) / AXIAL_CELLS, np.array(self.side).reshape(AXIAL_CELLS, THIRD).mean(axis=1)

    def departures(self, body: FloatArray, unit: UnitType) -> tuple[FloatArray, FloatArray]:
        """(n,) departures in metres next to (n, 3) points of the body frame, and (n, 3) outward normals of the cones there."""
        relation = relate(body, unit)
        turn = turn_around(body, relation.leg, unit)
        grid = np.array(self.side).reshape(AXIAL_CELLS, THIRD)
        ring = np.clip(relation.axial / unit.leg_length * AXIAL_CELLS - 0.5, 0, AXIAL_CELLS - 1)
        a = np.minimum(ring.astype(np.int64), AXIAL_CELLS - 2)
        across = (turn / (2 * math.pi) * AZIMUTH_CELLS - 0.5) % THIRD
        b = across.astype(np.int64) % THIRD
        u, v = ring - a, across - np.floor(across)
        c = (b + 1) % THIRD
        side = (1 - u) * ((1 - v) * grid[a, b] + v * grid[a, c]) + u * ((1 - v) * grid[a + 1, b] + v * grid[a + 1, c])
        return unit.height * np.where(relation.part == LATERAL, side, self.disc), relation.normal

    def as_record(self) -> dict[str, Any]:
        """Plain values, as stored in a result and in a file of its own."""
        return {
            "name": self.name,
            "units": self.units,
            **{key: round(getattr(self, key), 7) for key in ("radius", "gradient", "leg_length", "size_mean", "size_sd", "disc")},
            "side": [round(v, 7) for v in self.side],
            "sds": [round(v, 7) for v in self.sds],
            "own": float(f"{self.own:.6g}"),
            "uneven": [round(v, 5) for v in self.uneven],
        }

    @classmethod
    def from_record(cls, record: Mapping[str, Any], name: str) -> Mould:
        """Inverse of :meth:`as_record`.

        Raises
        ------
        ValueError
            The record is none of a mould.
        """
        try:
            plain = {key: float(record[key]) for key in ("radius", "gradient", "leg_length", "disc", "size_mean", "size_sd", "own")}
            side, sds, uneven = (tuple(float(v) for v in record[key]) for key in ("side", "sds", "uneven"))
            units = int(record["units"])
        except (KeyError, TypeError, ValueError, OverflowError) as error:
            raise ValueError(f"lacks or misstates {error}") from error
        values = [*plain.values(), *side, *sds, *uneven]
        if len(side) != AXIAL_CELLS * THIRD or len(sds) != VARIANCES or len(uneven) != 2 or not np.isfinite(values).all():
            raise ValueError("has another number of values")
        if min(plain["size_sd"], plain["own"], *sds, *uneven) <= 0 or max(map(abs, (*side, plain["disc"]))) > LARGEST_DEVIATION:
            raise ValueError("has values that no mould has")
        return cls(name=name, units=units, side=side, sds=sds, uneven=(uneven[0], uneven[1]), **plain)


def onto_cones(points: FloatArray, rotation: FloatArray, centre: FloatArray, unit: UnitType, mould: Mould) -> FloatArray:
    """(n, 3) points of a casting, moved along the normals by the mould's departure, onto its cones.

    Parameters
    ----------
    points
        (n, 3), metres.
    rotation, centre
        (3, 3), (3,) of the unit's approximate pose: departures change little from place to place.
    unit, mould
        Its geometry and its mould.
    """
    departures, normals = mould.departures((points - centre) @ rotation, unit)
    return np.asarray(points - (departures[:, None] * normals) @ rotation.T)
