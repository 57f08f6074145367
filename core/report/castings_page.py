"""What a report says of the castings: the mould that was learned or held, how units vary about it, and which legs are broken."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from ..model.mould import Mould
from ..results.unit_rows import EpochInfo, UnitRow

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


@dataclass(frozen=True, kw_only=True)
class CastingsPage:
    """Moulds of the run, units with broken legs, largest break first, and number of legs by state."""

    moulds: tuple[MouldView, ...]
    broken: tuple[UnitRow, ...]
    legs: Counter[str]


def castings_page(epochs: Sequence[EpochInfo], rows: Sequence[UnitRow], rejected: frozenset[str]) -> CastingsPage:
    """Read what the settings of a result say of its moulds, and its units of their legs."""
    settings = epochs[-1].settings if epochs else {}
    heights = {kind["name"]: float(kind["height"]) for kind in settings.get("unit_types", ()) if "name" in kind and "height" in kind}
    views = []
    for name, record in settings.get("castings", {}).items():
        try:
            mould = Mould.from_record(record, str(record.get("name", name)))
        except (ValueError, AttributeError):
            # an earlier version's, which stated less
            continue
        if mould.units >= LEAST_UNITS and name in heights:
            views.append(MouldView(mould=mould, height=heights[name], held=bool(settings.get("moulds"))))
    kept = [row for row in rows if row.unit_id not in rejected]
    broken = sorted((row for row in kept if row.broken_legs), key=lambda row: (-(row.leg_missing or 0.0), row.unit_id))
    return CastingsPage(moulds=tuple(views), broken=tuple(broken), legs=Counter(state for row in kept for state in row.legs))
