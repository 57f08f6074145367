"""Movement bands as users of armour surveys know them, and words for the damage of a structure."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..common.errors import InputError
from ..results.unit_rows import UnitRow

BANDS: Mapping[str, tuple[tuple[float, str], ...]] = {
    "cm": ((0.05, "m"), (0.10, "m")),
    "dn": ((0.5, "Dn"), (1.0, "Dn")),
    "usace": ((0.09, "m"), (0.30, "m"), (0.61, "m")),
}
"""Limits of the bands: 5 and 10 cm (Chan and Lichti, 2026), half and one nominal diameter (van der Meer, 1988), and 0.3, 1 and 2 ft, in
which the US Army Corps of Engineers states movements of its concrete-armoured structures (Bottin, 2003)."""
HOLE_DIAMETERS = 1.5
"""Gone units nearer to each other than this make one hole that the layer below shows through, nominal diameters."""
STATES = ("no damage", "initiation of damage", "Iribarren's damage", "initiation of destruction")


@dataclass(frozen=True, kw_only=True)
class Band:
    """Units that moved by ``low`` metres or more and less than ``high``; the last band has no upper limit, and holds lost ones."""

    name: str
    low: float
    high: float
    count: int
    share: float


def movement_bands(rows: Sequence[UnitRow], preset: str, diameter: float) -> tuple[Band, ...]:
    """Units of a pair by bands of their displacement.

    Parameters
    ----------
    rows
        Units judged; those that are lost or relocated moved by more than any limit.
    preset
        Key of ``BANDS``.
    diameter
        Dn, metres.

    Raises
    ------
    InputError
        There is no such preset.
    """
    if preset not in BANDS:
        raise InputError(f"there are no bands {preset!r}", remedy=f"Choose {', '.join(BANDS)}.")
    limits = [value * (diameter if unit == "Dn" else 1.0) for value, unit in BANDS[preset]]
    named = [f"{value:.2f} m" if unit == "m" else f"{value:g} {unit}" for value, unit in BANDS[preset]]
    moved = np.array([distance for row in rows if (distance := moved_by(row)) is not None])
    bands = []
    for k, (low, high) in enumerate(zip([0.0, *limits], [*limits, math.inf], strict=True)):
        count = int(np.sum((moved >= low) & (moved < high))) if k < len(limits) else int(np.sum(moved >= low))
        name = f"< {named[0]}" if k == 0 else f"≥ {named[-1]}" if k == len(limits) else f"{named[k - 1]} – {named[k]}"
        bands.append(Band(name=name, low=low, high=high, count=count, share=count / max(len(moved), 1)))
    return tuple(bands)


def damage_state(rows: Sequence[UnitRow], layers: Mapping[str, int], diameter: float) -> str:
    """State of the armour in the words of Campos et al. (2020), as far as units tell it.

    No damage: no unit moved by one Dn or is lost. Initiation of damage: some did. Iribarren's damage: two that did lay side by side in the
    outer layer, so that a hole shows the layer below. Initiation of destruction: one of the layer below did. Destruction, the underlayer
    laid bare, cannot be told from units.

    Parameters
    ----------
    rows
        Units judged.
    layers
        Layer of each unit in the earlier epoch, 1 for the outer one.
    diameter
        Dn, metres.
    """
    gone = [row for row in rows if row.place is not None and (moved_by(row) or 0.0) >= diameter]
    if not gone:
        return STATES[0]
    if any(layers.get(row.unit_id, 1) > 1 for row in gone):
        return STATES[3]
    places = np.array([row.place for row in gone])
    apart = np.linalg.norm(places[:, None] - places[None], axis=2) + np.diag(np.full(len(gone), np.inf))
    return STATES[2] if len(gone) > 1 and apart.min() <= HOLE_DIAMETERS * diameter else STATES[1]


def moved_by(row: UnitRow) -> float | None:
    """Displacement in metres; infinite for units that were carried away or are lost, None where nothing is known."""
    return math.inf if row.kind in ("lost", "relocated") else row.d_3d
