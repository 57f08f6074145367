"""Folders that show the same ground: two looks at it, before and after, or stations and strips of one survey."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from itertools import pairwise
from pathlib import Path

import numpy as np

from .dates_in_names import DAY, NamedDate
from .tile_dates import TileDates
from .tiles import TileInfo

SAME_GROUND = 0.5
"""Share of the smaller extent that two groups of tiles must have in common to be two looks at the same ground."""
ONE_EPOCH_DAYS = 2
"""Tiles without dates in their names whose GPS times lie closer than this are one epoch."""
BEFORE = re.compile(r"before(?!.?(noon|lunch))|(?<![a-z])(vorher|avant|antes)(?![a-z])|(?<!午)前(?![一-鿿])|(?<!오)전(?![가-힣])")
AFTER = re.compile(
    r"after(?!.?(noon|lunch))|(?<![a-z])(nachher|apr[eè]s|depois|despu[eé]s)(?![a-z])|(?<!午)[後后](?![一-鿿])|(?<!오)후(?![가-힣])"
)
"""Words of folders that hold one of two looks; halves of a day and front and rear sides are none."""
EARLIER = re.compile(r"(?<![a-z])(pre|old|first|initial|baseline|vor)(?![a-z])")
LATER = re.compile(r"(?<![a-z])(post|new|second|final|repeat|nach)(?![a-z])")
"""Words that put epochs in order and no more: strips, cameras and exports of one survey are called so, too."""
PARTS = re.compile(
    r"(?<![a-z])(pos|positions?|scans?|stations?|stand|standpunkt|setups?|st|sp|strips?|lines?|swaths?|flights?|flug|blocks?|parts?|teil)"
    r"[ _.-]*#"
)
"""Names, with # for their numbers, of what several of make one survey."""
BLOCK = 500
"""Tiles whose neighbours are looked for at once."""


@dataclass(frozen=True)
class FoundTile:
    """A tile with what tells its epoch.

    Attributes
    ----------
    info
        Header, extent in the tile's own CRS.
    dates
        When it was measured and made.
    named
        Date in the name of its folder, or of the file; None where there is none.
    place
        Folder, or file, whose name holds that date; else the folder the tile lies in.
    otherwise
        What ``named`` and ``place`` are if six digits of the file's name are no date; None where they do not count.
    """

    info: TileInfo
    dates: TileDates
    named: NamedDate | None
    place: Path
    otherwise: tuple[NamedDate | None, Path] | None = None


def looks_at(tiles: Iterable[FoundTile]) -> dict[Path, list[FoundTile]]:
    """Tiles by the uppermost folder in which their paths part, where every two of these show the same ground; else none."""
    tiles = list(tiles)
    parents = {tile.info.path.parent for tile in tiles}
    if len(parents) < 2 or len({parent.anchor for parent in parents}) > 1:
        return {}
    common = Path(os.path.commonpath(parents))
    folders: dict[Path, list[FoundTile]] = {}
    for tile in tiles:
        below = tile.info.path.parent.relative_to(common).parts
        folders.setdefault(common.joinpath(*below[:1]), []).append(tile)
    groups = list(folders.values())
    same = all(ground_in_common(a, b) > SAME_GROUND for k, a in enumerate(groups) for b in groups[:k])
    return folders if same else {}


def are_told(looks: Mapping[Path, Sequence[FoundTile]]) -> bool:
    """Whether folders were measured on days well apart, or are called before and after; strips of one survey show the same ground, too.

    A name that gives the day is believed rather than GPS time, which may be of the export.
    """
    if _are_well_apart(looks) and not _are_of_a_day(looks):
        return True
    return _are_before_and_after(looks) and not (_are_of_a_day(looks) and _are_timed(looks) and not _are_apart(looks))


def said_of(looks: Mapping[Path, Sequence[FoundTile]]) -> tuple[str, str]:
    """A note and a question, either empty, on folders of the same ground that are taken as one epoch though they may be several."""
    if not looks or are_told(looks):
        return "", ""
    names = " and ".join(sorted(folder.name for folder in looks))
    if _are_of_a_day(looks):
        doubtful = _are_before_and_after(looks) or (
            _are_well_apart(looks) and any(measured_then(tile) for own in looks.values() for tile in own)
        )
    else:
        undated = all(None in own for own in _days(looks))
        doubtful = _are_apart(looks) or (undated and any(tile.named is not None for own in looks.values() for tile in own))
    if not doubtful:
        return "", ""
    if len({re.sub(r"\d+", "#", folder.name) for folder in looks}) == 1 and PARTS.search(re.sub(r"\d+", "#", names.lower())):
        return (
            f"folders {names} show the same ground and are taken as parts of one epoch; if they are several, add dates to their names",
            "",
        )
    question = (
        f"folders {names} show the same ground and are taken as one epoch; if they are several, add dates to their names; "
        "if they are one, take this line out of the file that init writes, and run that"
    )
    return "", question


def measured_then(tile: FoundTile) -> bool:
    """Whether the points' GPS time is of the day that the name says, or of one beside it."""
    return tile.named is not None and tile.dates.measured is not None and abs((tile.dates.measured.date() - tile.named.day).days) <= 1


def turn(name: str) -> int:
    """-1 for a name that says before, 1 for one that says after, else 0."""
    name = name.lower()
    return _proper_turn(name) or bool(LATER.search(name)) - bool(EARLIER.search(name))


def share_in_common(a: tuple[float, float, float, float], b: tuple[float, float, float, float]) -> float:
    """Share of the smaller of two extents (west, south, east, north) that both cover."""
    width, depth = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
    smaller = min((a[2] - a[0]) * (a[3] - a[1]), (b[2] - b[0]) * (b[3] - b[1]))
    return max(width, 0.0) * max(depth, 0.0) / smaller if smaller > 0 else 0.0


def ground_in_common(one: Sequence[FoundTile], other: Sequence[FoundTile]) -> float:
    """Share of the tiles' extents of the smaller of two groups that tiles of the larger cover."""
    # slow to import, and most surveys need it not
    import shapely

    a, b = (np.array([(*tile.info.low[:2], *tile.info.high[:2]) for tile in group], dtype=np.float64) for group in (one, other))
    areas = [np.prod(boxes[:, 2:] - boxes[:, :2], axis=1) for boxes in (a, b)]
    if areas[0].sum() > areas[1].sum():
        a, b, areas = b, a, areas[::-1]
    whole = float(areas[0].sum())
    tree = shapely.STRtree(shapely.box(*b.T))
    shared = np.zeros(len(a))
    for start in range(0, len(a), BLOCK):
        mine, theirs = tree.query(shapely.box(*a[start : start + BLOCK].T))
        mine += start
        sides = np.minimum(a[mine, 2:], b[theirs, 2:]) - np.maximum(a[mine, :2], b[theirs, :2])
        shared += np.bincount(mine, np.prod(np.maximum(sides, 0.0), axis=1), minlength=len(a))
    return float(np.minimum(shared, areas[0]).sum()) / whole if whole > 0 else 0.0


def _proper_turn(name: str) -> int:
    return bool(AFTER.search(name.lower())) - bool(BEFORE.search(name.lower()))


def _are_before_and_after(looks: Mapping[Path, Sequence[FoundTile]]) -> bool:
    return sorted(_proper_turn(folder.name) for folder in looks) == [-1, 1]


def _days(looks: Mapping[Path, Sequence[FoundTile]]) -> list[set[date | None]]:
    return [{tile.dates.measured.date() if tile.dates.measured else None for tile in own} for own in looks.values()]


def _are_timed(looks: Mapping[Path, Sequence[FoundTile]]) -> bool:
    return all(tile.dates.measured is not None for own in looks.values() for tile in own)


def _are_apart(looks: Mapping[Path, Sequence[FoundTile]]) -> bool:
    """Whether no two folders have a day of GPS time, or the lack of one, in common."""
    days = _days(looks)
    return all(a.isdisjoint(b) for k, a in enumerate(days) for b in days[:k])


def _are_well_apart(looks: Mapping[Path, Sequence[FoundTile]]) -> bool:
    days = sorted(sorted(day for day in own if day is not None) for own in _days(looks))
    return _are_timed(looks) and all((later[0] - earlier[-1]).days >= ONE_EPOCH_DAYS for earlier, later in pairwise(days))


def _are_of_a_day(looks: Mapping[Path, Sequence[FoundTile]]) -> bool:
    """Whether a name says the day."""
    return any(tile.named is not None and tile.named.exactness == DAY for own in looks.values() for tile in own)
