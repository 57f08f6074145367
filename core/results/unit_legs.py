"""Legs of a unit as a result states them: whole, broken, or with an end that is not seen; leg by leg."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..model.outline import PlacedShape
from .geopackage_reader import Row
from .schema import LEG_NUMBERS

WHOLE, BROKEN, UNSEEN = "whole", "broken", "unseen"
LEG_STATES = (WHOLE, BROKEN, UNSEEN)
"""Values of ``units.leg1`` to ``units.leg4``."""
FIELDS_OF_LEGS = tuple(f"leg{k}{what}" for k in LEG_NUMBERS for what in ("", "_missing", "_probability"))
"""What ``units`` states of each leg."""


@dataclass(frozen=True, kw_only=True)
class Leg:
    """One leg of a unit.

    Attributes
    ----------
    number
        1 to 4, the same in all epochs.
    state
        Of ``LEG_STATES``.
    missing
        Length that a broken leg lacks, metres; None where it is not broken, or the result does not say.
    probability
        Probability that the leg is broken, 0 to 1; None where its end is not seen, or the result does not say.
    """

    number: int
    state: str
    missing: float | None = None
    probability: float | None = None

    @property
    def is_broken(self) -> bool:
        """Whether its end is gone."""
        return self.state == BROKEN


def legs_of_row(row: Row | None) -> tuple[Leg, ...]:
    """The four legs of a row of ``units``; () where it says nothing of them.

    Results made before there were fields for each leg state one length and one probability for the unit: those of its broken leg where it
    is the only one, and of nobody knows which where there are more.
    """
    if row is None or not row.get("leg1"):
        return ()
    states = [str(row[f"leg{k}"]) if row[f"leg{k}"] in LEG_STATES else UNSEEN for k in LEG_NUMBERS]
    legs = [Leg(number=k, state=state, **_stated(row, k, state)) for k, state in zip(LEG_NUMBERS, states, strict=True)]
    if states.count(BROKEN) != 1 or any(leg.missing is not None or leg.probability is not None for leg in legs):
        return tuple(legs)
    alone = states.index(BROKEN)
    legs[alone] = replace(legs[alone], missing=row.get("leg_missing"), probability=row.get("leg_probability"))
    return tuple(legs)


def _stated(row: Row, number: int, state: str) -> dict[str, Any]:
    missing = row.get(f"leg{number}_missing") if state == BROKEN else None
    return {"missing": missing, "probability": row.get(f"leg{number}_probability")}


def legs_of_pair(early: Row | None, late: Row | None) -> tuple[Leg, ...]:
    """Legs as they are in the later epoch of a pair, from its rows of ``units``.

    A leg whose end the later epoch does not show is broken where the earlier epoch says so, since it does not heal; one that was whole may
    have broken meanwhile, so that nothing is said of it.
    """
    before, after = legs_of_row(early), legs_of_row(late)
    if not before:
        return after
    now = after or tuple(Leg(number=k, state=UNSEEN) for k in LEG_NUMBERS)
    return tuple(was if leg.state == UNSEEN and was.is_broken else leg for was, leg in zip(before, now, strict=True))


def most_broken(legs: Sequence[Leg]) -> Leg | None:
    """The broken leg that lacks most; None where none is broken."""
    return max((leg for leg in legs if leg.is_broken), key=lambda leg: (leg.missing or 0.0, leg.probability or 0.0), default=None)


def end_of_leg(leg: Leg, shape: PlacedShape) -> FloatArray:
    """(3,) where a leg ends, metres in the frame of the shape: at its face of fracture where it is broken and the length is known."""
    direction = shape.rotation @ shape.legs[leg.number - 1]
    return np.asarray(shape.centre + (shape.leg_length - (leg.missing or 0.0)) * direction)


def way_of_leg(leg: Leg, shape: PlacedShape) -> tuple[int, int]:
    """Whither a leg points: degrees from grid north clockwise, 0 to 359, and degrees above the horizon, whole ones."""
    east, north, up = shape.rotation @ shape.legs[leg.number - 1]
    azimuth = round(float(np.degrees(np.arctan2(east, north)))) % 360
    return azimuth, round(float(np.degrees(np.arcsin(np.clip(up, -1.0, 1.0)))))
