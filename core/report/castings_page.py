"""What a report says of the castings: the mould that was learned or held, how units vary about it, and which legs are broken."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..model.mould import Mould
from ..model.outline import PlacedShape
from ..results.unit_legs import BROKEN, UNSEEN, WHOLE, Leg, end_of_leg, way_of_leg
from ..results.unit_rows import EpochInfo, UnitRow
from .damage import Damage, section_numbers

LEAST_UNITS = 4
"""Units of which a mould can be learned."""


@dataclass(frozen=True, kw_only=True)
class MouldView:
    """A mould of the run: ``height`` of its units in metres, and whether an earlier survey gave it."""

    mould: Mould
    height: float
    held: bool

    @property
    def radius(self) -> float:
        """Of the cones at the centre, metres."""
        return self.mould.radius * self.height

    @property
    def leg_sd(self) -> float:
        """Standard deviation of the radius of single legs, metres."""
        return self.mould.sds[0] * self.height


@dataclass(frozen=True, kw_only=True, eq=False)
class BrokenLeg:
    """A broken leg of a unit.

    Attributes
    ----------
    unit_id, leg
        What the result says of it.
    way
        Whither it points: degrees from grid north and above the horizon; None where the unit's pose is not known.
    end
        (3,) where it ends now, metres; None likewise.
    unseen
        Numbers of the unit's legs whose ends are not seen.
    """

    unit_id: str
    leg: Leg
    way: tuple[int, int] | None
    end: FloatArray | None
    unseen: tuple[int, ...]


@dataclass(frozen=True, kw_only=True)
class LegSection:
    """Legs of the units in one section of the structure: chainages in metres, units of which the result states legs, units with a broken
    one, and legs by state."""

    start: float
    stop: float
    units: int
    broken_units: int
    whole: int
    broken: int
    unseen: int


@dataclass(frozen=True, kw_only=True)
class CastingsPage:
    """Moulds of the run, units with broken legs, largest break first, these legs one by one, number of legs by state, and by section."""

    moulds: tuple[MouldView, ...]
    broken: tuple[UnitRow, ...]
    broken_legs: tuple[BrokenLeg, ...]
    legs: Counter[str]
    sections: tuple[LegSection, ...]


def castings_page(
    epochs: Sequence[EpochInfo],
    rows: Sequence[UnitRow],
    rejected: frozenset[str],
    shapes: Mapping[str, PlacedShape],
    harm: Damage | None,
) -> CastingsPage:
    """Read what the settings of a result say of its moulds, and its units of their legs; rejected and uncertain ones are left out.

    ``shapes`` are those of the later epoch where a unit has one; ``harm`` tells axis and sections of the structure.
    """
    kept = [row for row in rows if row.unit_id not in rejected and row.kind != "uncertain"]
    broken = sorted((row for row in kept if row.broken_legs), key=lambda row: (-(row.leg_missing or 0.0), row.unit_id))
    return CastingsPage(
        moulds=tuple(_moulds(epochs[-1].settings if epochs else {})),
        broken=tuple(broken),
        broken_legs=tuple(_broken_leg(row, leg, shapes.get(row.unit_id)) for row in broken for leg in row.legs if leg.is_broken),
        legs=Counter(leg.state for row in kept for leg in row.legs),
        sections=() if harm is None else tuple(_leg_sections(kept, harm)),
    )


def _moulds(settings: Mapping[str, Any]) -> Iterator[MouldView]:
    heights = {kind["name"]: float(kind["height"]) for kind in settings.get("unit_types", ()) if "name" in kind and "height" in kind}
    for name, record in settings.get("castings", {}).items():
        try:
            mould = Mould.from_record(record, str(record.get("name", name)))
        except (ValueError, AttributeError):
            # an earlier version's, which stated less
            continue
        if mould.units >= LEAST_UNITS and name in heights:
            yield MouldView(mould=mould, height=heights[name], held=bool(settings.get("moulds")))


def _broken_leg(row: UnitRow, leg: Leg, shape: PlacedShape | None) -> BrokenLeg:
    return BrokenLeg(
        unit_id=row.unit_id,
        leg=leg,
        way=None if shape is None else way_of_leg(leg, shape),
        end=None if shape is None else end_of_leg(leg, shape),
        unseen=row.unseen_legs,
    )


def _leg_sections(rows: Sequence[UnitRow], harm: Damage) -> Iterator[LegSection]:
    placed = [(row, row.place) for row in rows if row.legs and row.place is not None]
    if not placed:
        return
    number = section_numbers(harm.axis.locate(np.array([place for _, place in placed]))[0], harm.section)
    for k in np.unique(number).tolist():
        here = [row for (row, _), own in zip(placed, number, strict=True) if own == k]
        count = Counter(leg.state for row in here for leg in row.legs)
        yield LegSection(
            start=k * harm.section,
            stop=(k + 1) * harm.section,
            units=len(here),
            broken_units=sum(bool(row.broken_legs) for row in here),
            whole=count[WHOLE],
            broken=count[BROKEN],
            unseen=count[UNSEEN],
        )
