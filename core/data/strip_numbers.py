"""Which points of an epoch are of one flight strip or scanner station, whose offsets the units can tell.

LAS files say so in the point source ID. Some software writes the same number into every point: then a pass over the structure, or the
time on a station, is told by GPS time. Other software writes another number for every scan line, frame or image: offsets of these would
be unknowns by the thousand, of which none is seen by enough points to be told, and whose normal equations grow with the square of their
number. A scanner that turns past a long structure and back on a station counts as two passes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ..common.arrays import FloatArray
from .places_by_second import PlacesBySecond
from .tiles import TileInfo

MOST_STRIPS = 200
"""Point source IDs of an epoch up to which they are taken as they are, and passes up to which they are told apart."""

LEAST_POINTS = 10_000
"""Points that a strip or station has in the mean (assumed: fifty metres of an armour layer at 20 points per square metre)."""

MOST_SECONDS = 400_000
"""Seconds with points of an epoch, some days, beyond which its times are no seconds."""

LONGEST_GAP = 10.0
"""Seconds without a point of the structure after which another pass or station begins: the way around to the next flight line."""

LEAST_RETURN = 20.0
"""Metres along the structure that a flight has to go back for another pass to begin; on a shorter one gaps alone tell passes apart."""

LEAST_SHARE = 0.02
"""Points of a pass, over those that passes have in the mean, below which it belongs to the one before."""


def by_strips(label: str, tiles: Sequence[TileInfo]) -> tuple[tuple[TileInfo, ...], str]:
    """Tiles of the epoch ``label`` as they are to be read, and a sentence where their points' numbers are not those in the files."""
    numbers = len({number for tile in tiles for number in tile.sources})
    frames = numbers > MOST_STRIPS and sum(tile.used for tile in tiles) < LEAST_POINTS * numbers
    if numbers > 1 and not frames:
        return tuple(tiles), ""
    timed = all(len(tile.by_second.seconds) for tile in tiles)
    starts = passes(PlacesBySecond.merged([tile.by_second for tile in tiles])) if timed else np.zeros(0)
    several = 1 < len(starts) <= MOST_STRIPS
    if not several and not frames:
        return tuple(tiles), ""
    # a mean of points may be of several passes
    thinned = any(tile.thinned for tile in tiles)
    said = f"{numbers} point source IDs number scan lines or frames and are not used" if frames else "the tiles do not number strips"
    if several and not thinned:
        strips = tuple(range(1, len(starts) + 1))
        return (
            tuple(replace(tile, sources=strips, strip_starts=tuple(starts.tolist())) for tile in tiles),
            f"{label}: {said}: by GPS time there are {len(starts)} passes or stations",
        )
    why = ", and where points are thinned passes cannot be told apart" if thinned and several else ""
    return tuple(replace(tile, sources=(0,), strip_starts=()) for tile in tiles), f"{label}: {said}{why}: it is taken for one strip"


def passes(seen: PlacesBySecond) -> FloatArray:
    """(k,) GPS times at which passes over the structure begin, or times on a station: after a gap, and where the way turns back.

    Nothing is told by times that were rounded to more than a second, nor by more of them than a survey takes.
    """
    if not len(seen.seconds) or len(seen.seconds) > MOST_SECONDS or np.median(np.diff(seen.seconds, prepend=seen.seconds[0] - 1)) > 1:
        return np.zeros(0)
    places = seen.places - np.average(seen.places, axis=0, weights=seen.counts)
    along = places @ np.linalg.eigh((places * seen.counts[:, None]).T @ places)[1][:, 1]
    ends = [0, *(np.flatnonzero(np.diff(seen.seconds) > LONGEST_GAP) + 1).tolist(), len(along)]
    starts = np.array([first + turn for first, last in pairwise(ends) for turn in (0, *_turns(along[first:last]))])
    points = np.add.reduceat(seen.counts, starts)
    kept = points >= LEAST_SHARE * points.mean()
    kept[0] = True
    return np.asarray(seen.seconds[starts[kept]], dtype=np.float64)


def _turns(along: FloatArray) -> list[int]:
    """Where a way turns back: indices of the extremes of (n,) chainages, metres, that ``LEAST_RETURN`` lies behind and before."""
    turns: list[int] = []
    low = high = 0
    for k, place in enumerate(along):
        high = k if place > along[high] else high
        low = k if place < along[low] else low
        if along[high] - along[low] < LEAST_RETURN:
            continue
        if high > low and along[high] - place >= LEAST_RETURN:
            turns.append(high)
            low = k
        elif low > high and place - along[low] >= LEAST_RETURN:
            turns.append(low)
            high = k
    return turns
