"""Where units are that questions to points need: those around a place, and how far the cloud around it lies elsewhere in another epoch."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray
from .fitted_unit import FittedUnit

NEIGHBOURS = 9
"""Units whose median motion says where a unit would be that one epoch does not show."""


class Asked(NamedTuple):
    """Units that are asked for in another epoch: (k, 3) places here and there, moves of the cloud, certain units around, there and here."""

    here: FloatArray
    there: FloatArray
    moves: FloatArray
    owners: tuple[FittedUnit, ...]
    beside: tuple[FittedUnit, ...]


class UnitPlaces:
    """Certain units of every epoch, what all show of every unit by epoch, and the (e, 3) common shifts of the clouds, metres."""

    def __init__(self, certain: Sequence[list[FittedUnit]], seen: Sequence[Mapping[int, FittedUnit]], shifts: FloatArray) -> None:
        self._certain, self._seen, self._shifts = certain, seen, shifts
        self._trees = [cKDTree(np.array([u.pose.centre for u in own]).reshape(-1, 3)) for own in certain]
        self._both: dict[tuple[int, int], tuple[cKDTree, FloatArray] | None] = {}

    def owners(self, epoch: int, places: FloatArray, reach: float) -> tuple[FittedUnit, ...]:
        """Certain units of an epoch within a distance of (k, 3) places."""
        near = sorted({k for around in self._trees[epoch].query_ball_point(places, reach) for k in around})
        return tuple(self._certain[epoch][k] for k in near)

    def asked(self, reference: int, epoch: int, units: Sequence[FittedUnit], reach: float) -> Asked:
        """Units as a reference shows them, to be asked for in another epoch, with certain ones within a distance."""
        centres = np.array([unit.pose.centre for unit in units])
        moves = self.shifts(reference, epoch, centres)
        there = centres + moves
        return Asked(centres, there, moves, self.owners(epoch, there, reach), self.owners(reference, centres, reach))

    def shifts(self, first: int, second: int, places: FloatArray) -> FloatArray:
        """(k, 3) shift between two epochs' clouds at (k, 3) places: the median of the nearest units that both show, or the common one."""
        if (first, second) not in self._both:
            both = [(s[first].pose.centre, s[second].pose.centre) for s in self._seen if first in s and second in s and s[first].certain]
            known = None
            if len(both) >= NEIGHBOURS:
                before, after = (np.array(column) for column in zip(*both, strict=True))
                known = cKDTree(before), after - before
            self._both[first, second] = known
        known = self._both[first, second]
        if known is None:
            return np.tile(self._shifts[second] - self._shifts[first], (len(places), 1))
        return np.asarray(np.median(known[1][known[0].query(places, k=NEIGHBOURS)[1]], axis=1))
