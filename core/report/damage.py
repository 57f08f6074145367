"""Damage of an armour layer in the figures coastal engineers use: units displaced by thresholds, N_od, share per section.

N_od is the number of displaced units per width of one nominal diameter along the structure (van der Meer, 1988; CIRIA Rock
Manual, 2007, 5.2.2.2): N_od = N Dn / B, with B the width of the section looked at. Here a unit counts as displaced for N_od when it
moved by one Dn or more, was carried away, or is lost.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.axis import Axis
from ..common.centreline import ARM_HEIGHTS, centreline
from ..common.errors import InputError
from ..model.unit_types import UnitType
from ..results.unit_rows import UnitRow

THRESHOLDS = (0.05, 0.10)
"""Displacements in metres at which instability is commonly flagged (paper 4.1)."""


@dataclass(frozen=True)
class DamageClass:
    """Units displaced by at least ``limit`` metres, lost and relocated ones included; ``share`` of the units judged."""

    name: str
    limit: float
    count: int
    share: float


@dataclass(frozen=True)
class SectionDamage:
    """One section of the structure.

    Attributes
    ----------
    start, stop
        Chainage along the axis, metres.
    units
        Units judged in the section.
    counts
        Units displaced by at least each class's limit.
    n_od
        Displaced units per Dn of the section's width.
    broken
        Units with a broken leg.
    """

    start: float
    stop: float
    units: int
    counts: tuple[int, ...]
    n_od: float
    broken: int = 0


@dataclass(frozen=True, kw_only=True)
class Damage:
    """Damage of the whole structure and of its sections.

    Attributes
    ----------
    units
        Units judged: both positions known, or lost; rejected, new, unseen and uncertain units are not.
    height, nominal_diameter
        H and Dn in metres.
    classes
        Counts by threshold.
    width
        Length of the structure looked at, metres, for ``n_od``.
    n_od, n_lost
        Displaced units per Dn of width; units lost.
    n_broken
        Units with a broken leg.
    sections
        By chainage; empty sections are left out.
    axis, section
        Axis of the structure, and length of a section along it, metres.
    """

    units: int
    height: float
    nominal_diameter: float
    classes: tuple[DamageClass, ...]
    width: float
    n_od: float
    n_lost: int
    n_broken: int
    sections: tuple[SectionDamage, ...]
    axis: Axis = field(compare=False)
    section: float

    def displaced(self, limit: float) -> DamageClass:
        """Units displaced by at least ``limit`` metres, one of the limits of its classes."""
        return next(c for c in self.classes if math.isclose(c.limit, limit))


def nominal_diameter_of(rows: Sequence[UnitRow]) -> float:
    """Dn in metres: the median of what the run states of units, or of standard proportions; of a height of 1 m where none is known."""
    stated = [row.nominal_diameter for row in rows if row.nominal_diameter is not None]
    if stated:
        return float(np.median(stated))
    heights = [row.height for row in rows if row.height is not None]
    return UnitType.tetrapod(float(np.median(heights)) if heights else 1.0).nominal_diameter


def damage(
    rows: Sequence[UnitRow],
    *,
    excluded: frozenset[str] = frozenset(),
    axis: ArrayLike | None = None,
    width: float | None = None,
    section: float | None = None,
    nominal_diameter: float | None = None,
) -> Damage:
    """Damage figures of one epoch pair.

    Parameters
    ----------
    rows
        Units of the pair.
    excluded
        Rejected units.
    axis
        (n, 2) easting, northing of the structure's axis, n >= 2; the centreline of the units by default.
    width
        Length of structure looked at, metres; the extent of the units along the axis by default.
    section
        Length of a section along the axis, metres; ten Dn by default.
    nominal_diameter
        Dn = volume^(1/3), metres; unless given the median of what the run states of the units, or of standard proportions.

    Raises
    ------
    InputError
        No unit can be judged, or the axis, width or section has no length.
    """
    judged = [row for row in rows if row.unit_id not in excluded and row.place is not None and row.is_judged]
    heights = [row.height for row in judged if row.height is not None]
    if not judged or not heights:
        raise InputError("no unit has a displacement to judge", remedy="Choose an epoch pair with displacements, or take back rejections.")
    height = float(np.median(heights))
    diameter = nominal_diameter_of(judged) if nominal_diameter is None else nominal_diameter
    places = np.array([row.place for row in judged])
    line = centreline_of(judged) if axis is None else Axis(np.asarray(axis, dtype=np.float64).reshape(-1, 2))
    along = line.locate(places)[0]
    extent = float(along.max() - along.min()) + height
    if width is not None and not width > 0:
        raise InputError(f"the section width is {width} m", remedy="Give the length of structure in metres, above zero.")
    if section is not None and not section > 0:
        raise InputError(f"the section length is {section} m", remedy="Give a length in metres, above zero.")
    length = 10 * diameter if section is None else section
    moved = np.array([math.inf if row.kind in ("lost", "relocated") or row.d_3d is None else row.d_3d for row in judged])
    limits = [(f"{100 * limit:g} cm", limit) for limit in THRESHOLDS]
    limits += [("0.5 Dn", 0.5 * diameter), ("0.5 H", 0.5 * height), ("1 Dn", diameter), ("1 H", height)]
    limits.sort(key=lambda item: item[1])
    classes = []
    for name, limit in limits:
        count = int(np.sum(moved >= limit))
        classes.append(DamageClass(name, limit, count, count / len(judged)))
    broken = np.array([bool(row.broken_legs) for row in judged])
    out = moved >= diameter
    whole = extent if width is None else width
    return Damage(
        units=len(judged),
        height=height,
        nominal_diameter=diameter,
        classes=tuple(classes),
        width=whole,
        n_od=float(out.sum()) * diameter / whole,
        n_lost=sum(row.kind == "lost" for row in judged),
        n_broken=int(broken.sum()),
        sections=_sections(along, moved, broken, [limit for _, limit in limits], length, diameter),
        axis=line,
        section=length,
    )


def centreline_of(rows: Sequence[UnitRow]) -> Axis:
    """The centreline of the units that have a place, of a height of 1 m where none is known."""
    heights = [row.height for row in rows if row.height is not None]
    places = np.array([row.place for row in rows if row.place is not None]).reshape(-1, 3)
    return centreline(places, ARM_HEIGHTS * (float(np.median(heights)) if heights else 1.0))


def section_numbers(along: FloatArray, length: float) -> IntArray:
    """(n,) numbers of the sections, of one length, that chainages (n,) lie in; metres."""
    return np.floor(along / length + 1e-9).astype(np.int64)


def _sections(
    along: FloatArray, moved: FloatArray, broken: BoolArray, limits: Sequence[float], length: float, diameter: float
) -> tuple[SectionDamage, ...]:
    number = section_numbers(along, length)
    found = []
    for k in np.unique(number):
        here = moved[number == k]
        counts = tuple(int(np.sum(here >= limit)) for limit in limits)
        n_od = float(np.sum(here >= diameter)) * diameter / length
        found.append(SectionDamage(float(k * length), float((k + 1) * length), len(here), counts, n_od, int(broken[number == k].sum())))
    return tuple(found)
