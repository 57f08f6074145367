"""Damage of an armour layer in the figures coastal engineers use: units displaced by thresholds, N_od, share per section.

N_od is the number of displaced units per width of one nominal diameter along the structure (van der Meer, 1988; CIRIA Rock
Manual, 2007, 5.2.2.2): N_od = N Dn / B, with B the width of the section looked at. Here a unit counts as displaced for N_od when it
moved by one Dn or more, was carried away, or is lost.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .displacement_rows import UnitRow
from .errors import InputError
from .outline import VOLUME_RATIO

FloatArray = NDArray[np.float64]

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
    """

    start: float
    stop: float
    units: int
    counts: tuple[int, ...]
    n_od: float


@dataclass(frozen=True)
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
    sections
        By chainage; empty sections are left out.
    """

    units: int
    height: float
    nominal_diameter: float
    classes: tuple[DamageClass, ...]
    width: float
    n_od: float
    n_lost: int
    sections: tuple[SectionDamage, ...]


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
        (n, 2) easting, northing of the structure's axis, n >= 2; the longest direction of the units by default.
    width
        Length of structure looked at, metres; the extent of the units along the axis by default.
    section
        Length of a section along the axis, metres; ten Dn by default.
    nominal_diameter
        Dn = volume^(1/3), metres; from H by the standard proportions unless given.

    Raises
    ------
    InputError
        No unit can be judged, or the axis, width or section has no length.
    """
    judged = [row for row in rows if row.unit_id not in excluded and row.place is not None and (row.d_3d is not None or row.kind == "lost")]
    heights = [row.height for row in judged if row.height is not None]
    if not judged or not heights:
        raise InputError("no unit has a displacement to judge", remedy="Choose an epoch pair with displacements, or take back rejections.")
    height = float(np.median(heights))
    diameter = VOLUME_RATIO ** (1 / 3) * height if nominal_diameter is None else nominal_diameter
    places = np.array([row.place for row in judged])
    line = main_axis(places) if axis is None else np.asarray(axis, dtype=np.float64).reshape(-1, 2)
    along = chainage(places, line)
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
    out = moved >= diameter
    whole = extent if width is None else width
    return Damage(
        len(judged),
        height,
        diameter,
        tuple(classes),
        whole,
        float(out.sum()) * diameter / whole,
        sum(row.kind == "lost" for row in judged),
        _sections(along, moved, [limit for _, limit in limits], length, diameter),
    )


def main_axis(places: FloatArray) -> FloatArray:
    """(2, 2) ends of the line through the units along their longest horizontal direction, west (or south) end first."""
    flat = places[:, :2] - places[:, :2].mean(axis=0)
    direction = np.linalg.svd(flat, full_matrices=False)[2][0] if len(flat) > 1 else np.array([1.0, 0.0])
    if (direction[0], direction[1]) < (0.0, 0.0):
        direction = -direction
    reach = flat @ direction
    ends = np.array([reach.min(), max(reach.max(), reach.min() + 1.0)])
    return np.asarray(places[:, :2].mean(axis=0) + ends[:, None] * direction)


def chainage(places: FloatArray, axis: FloatArray) -> FloatArray:
    """(m,) metres along a polyline (n, 2) of the nearest place on it; before and after its ends it runs straight on.

    Raises
    ------
    InputError
        The axis has fewer than two different corners.
    """
    steps = np.diff(axis, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    if len(axis) < 2 or not np.all(lengths > 0):
        raise InputError("the axis needs two different corners or more", remedy="Give it as easting,northing pairs.")
    begin = np.concatenate([[0.0], np.cumsum(lengths)[:-1]])
    share = np.einsum("mki,ki->mk", places[:, None, :2] - axis[None, :-1], steps / lengths[:, None])
    low = np.where(np.arange(len(lengths)) == 0, -np.inf, 0.0)
    high = np.where(np.arange(len(lengths)) == len(lengths) - 1, np.inf, lengths)
    inside = np.clip(share, low, high)
    foot = axis[None, :-1] + inside[..., None] * (steps / lengths[:, None])
    best = np.argmin(np.linalg.norm(places[:, None, :2] - foot, axis=2), axis=1)
    return np.asarray((begin + inside)[np.arange(len(places)), best])


def _sections(along: FloatArray, moved: FloatArray, limits: Sequence[float], length: float, diameter: float) -> tuple[SectionDamage, ...]:
    number = np.floor(along / length).astype(np.int64)
    found = []
    for k in np.unique(number):
        here = moved[number == k]
        counts = tuple(int(np.sum(here >= limit)) for limit in limits)
        n_od = float(np.sum(here >= diameter)) * diameter / length
        found.append(SectionDamage(float(k * length), float((k + 1) * length), len(here), counts, n_od))
    return tuple(found)
