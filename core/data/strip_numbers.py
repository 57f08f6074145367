"""Whether the point source IDs of an epoch number its flight strips and scanner stations, whose offsets the units can tell.

Some software writes another number for every scan line, frame or image. Their offsets are unknowns by the thousand, of which none
is seen by enough points to be told, and whose normal equations grow with the square of their number.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from .tiles import TileInfo

MOST_STRIPS = 200
"""Point source IDs of an epoch up to which they are taken as they are."""

LEAST_POINTS = 10_000
"""Points that a strip or station has in the mean (assumed: fifty metres of an armour layer at 20 points per square metre)."""


def by_strips(label: str, tiles: Sequence[TileInfo]) -> tuple[tuple[TileInfo, ...], str]:
    """Tiles of the epoch ``label`` as they are to be read, and a sentence where that is as one strip, since their IDs number frames."""
    numbers = len({number for tile in tiles for number in tile.sources})
    if numbers <= MOST_STRIPS or sum(tile.used for tile in tiles) >= LEAST_POINTS * numbers:
        return tuple(tiles), ""
    said = f"{label}: {numbers} point source IDs number scan lines or frames, not strips: they are not used, strips have no offsets"
    return tuple(replace(tile, sources=(0,), one_strip=True) for tile in tiles), said
