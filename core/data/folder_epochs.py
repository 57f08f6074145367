"""Epochs of a folder of tiles: what belongs together, and when it was measured, from names, GPS times and headers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, date, datetime, time, timedelta
from itertools import pairwise
from pathlib import Path

from ..common.errors import InputError
from ..common.virtual_clouds import ENDING as VIRTUAL
from ..common.virtual_clouds import expanded
from .dates_in_names import DAY, NamedDate, date_in_name, has_coordinates
from .looks_at_ground import (
    ONE_EPOCH_DAYS,
    SAME_GROUND,
    FoundTile,
    are_told,
    ground_in_common,
    looks_at,
    measured_then,
    said_of,
    share_in_common,
    turn,
)
from .other_clouds import ENDINGS as OTHER_ENDINGS
from .tile_dates import tile_dates
from .tiles import TileInfo, inspect_tile

ENDINGS = (".las", ".laz")
"""Endings of tiles, in any case; COPC ends in .copc.laz."""
CLOUDS = (*ENDINGS, *OTHER_ENDINGS, VIRTUAL)
"""Endings of all files that hold or name points."""
NOON = time(12, tzinfo=UTC)


@dataclass(frozen=True)
class FoundEpoch:
    """Tiles that make one epoch.

    Attributes
    ----------
    label, time
        As they go into survey.toml.
    tiles
        Sorted by path.
    reason
        What label and time come from, as a comment.
    notes
        What a user should look at: tiles that overlap or repeat each other.
    questions
        What the tiles leave open: whether folders of the same ground are one epoch.
    """

    label: str
    time: datetime
    tiles: tuple[TileInfo, ...]
    reason: str
    notes: tuple[str, ...] = ()
    questions: tuple[str, ...] = ()

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """West, south, east, north of all tiles, in their own CRS."""
        return _extent(self.tiles)


def find_tiles(roots: Iterable[Path], progress: Callable[[float, str], None] = lambda fraction, message: None) -> list[FoundTile]:
    """Headers and dates of all point clouds in folders, searched to the bottom; files may be given as well, virtual point clouds too.

    E57 and PLY count in folders without LAS or LAZ alone: beside tiles they are what these were made from, or meshes.

    Raises
    ------
    InputError
        A folder does not exist or holds no point cloud, or a tile cannot be read.
    """
    places: dict[Path, Path] = {}
    for root in roots:
        if not root.exists():
            raise InputError(
                "does not exist", source=root, remedy="Give your tiles (LAS, LAZ, COPC, E57, PLY), or the folder that holds them."
            )
        if root.is_file():
            places |= {path: path.parent for path in expanded([root.absolute()]) if path not in places}
            continue
        for path in _some_clouds(root):
            places.setdefault(path.absolute(), root.absolute())
    out = []
    for k, (path, root) in enumerate(places.items()):
        progress(k / len(places), f"looking at {path.name}")
        named, place = _named(path, root)
        info = inspect_tile(path, None)
        if info.used:
            otherwise = _named(path, root, short=False) if named is not None and named.short and place == path else None
            out.append(FoundTile(info, tile_dates(path), named, place, otherwise))
    if not out:
        folder = next(iter(places)).parent
        raise InputError("holds tiles without a single point that can be used", source=folder, remedy="Give other tiles.")
    return out


def clouds_in(root: Path) -> list[Path]:
    """Point clouds in a folder and below, sorted; none is no error.

    Raises
    ------
    InputError
        A virtual point cloud is damaged.
    """
    files = [path for path in sorted(root.rglob("*")) if path.is_file() and not _hidden(path, root)]
    tiles = [path for path in files if path.suffix.lower() in ENDINGS]
    with_tiles = {path.parent for path in tiles}
    others = [path for path in files if path.suffix.lower() in OTHER_ENDINGS and path.parent not in with_tiles]
    # one that stands beside or above tiles is their index, perhaps of before they were moved
    indexed = {folder for path in (*tiles, *others) for folder in path.parents}
    virtual = [path for path in files if path.suffix.lower() == VIRTUAL and path.parent not in indexed]
    return sorted({*tiles, *others, *expanded(virtual)})


def group_epochs(tiles: Sequence[FoundTile]) -> list[FoundEpoch]:
    """Epochs in order of time: by dates in names, else by GPS time, by folders that show the same ground, or all in one."""
    sure = _with_sure_dates(tiles)
    dropped = {was.info.path: was.named.label for was, now in zip(tiles, sure, strict=True) if was.named and was.named != now.named}
    tiles, repeats = _without_repeats(sure)
    groups: dict[tuple[str, Path | None], list[FoundTile]] = {}
    dated = [tile for tile in tiles if tile.named is not None]
    for tile in dated:
        groups.setdefault((tile.named.label if tile.named else "", None), []).append(tile)
    groups = _split_by_place(groups)
    epochs = [_dated_epoch(label, place, members) for (label, place), members in groups.items()]
    rest = [tile for tile in tiles if tile.named is None]
    epochs += [_undated_epoch(members, folder) for members, folder in _undated_groups(rest)]
    epochs = [_with_doubts(epoch, tiles, dropped) for epoch in epochs]
    epochs = [replace(epoch, notes=(*epoch.notes, *repeats.get(epoch.tiles[0].path, ()))) for epoch in epochs]
    return _distinct(sorted(epochs, key=lambda epoch: (epoch.time, turn(epoch.label), epoch.label)))


def _some_clouds(root: Path) -> list[Path]:
    found = clouds_in(root)
    if not found:
        raise InputError("holds no point cloud (LAS, LAZ, COPC, E57, PLY)", source=root, remedy=_what_else(root))
    return found


def given_tiles(places: Iterable[Path]) -> list[Path]:
    """Tiles of folders, files and virtual point clouds, each once.

    Raises
    ------
    InputError
        A folder holds none, or a virtual point cloud leads nowhere.
    """
    return expanded(tile for place in places for tile in (_some_clouds(place) if place.is_dir() else [place]))


def _hidden(path: Path, root: Path) -> bool:
    return any(part.startswith(".") for part in path.relative_to(root).parts)


def _what_else(root: Path) -> str:
    endings = {path.suffix.lower() for path in root.rglob("*") if path.is_file()}
    others = sorted(endings & {".xyz", ".pts", ".ptx", ".pcd", ".zip", ".rcp", ".rcs"})
    return f"It holds {', '.join(others)}: export them as LAZ." if others else "Give the folder that holds your tiles."


def _named(path: Path, root: Path, *, short: bool = True) -> tuple[NamedDate | None, Path]:
    """Date of the deepest folder whose name holds one, sharpened by the file's; and what carries it."""
    folders = [parent for parent in path.parents if parent == root or root in parent.parents]
    of_folder = next(((found, folder) for folder in folders if (found := date_in_name(folder.name)) is not None), None)
    of_file = date_in_name(path.stem, years_alone=False)
    if of_file is not None and of_file.short and not short:
        of_file = None
    if of_folder is None:
        return (of_file, path) if of_file is not None else (None, path.parent)
    if of_file is not None and of_file.exactness < of_folder[0].exactness and of_folder[0].holds(of_file.day):
        return of_file, path
    return of_folder


def _with_sure_dates(tiles: Sequence[FoundTile]) -> list[FoundTile]:
    """Tiles whose six digits are dates unless names hold coordinates: 250310 is an easting as well as a day.

    Among coordinates they are dates where these part looks at the same ground, or the points' GPS time says the same.
    """
    folders: dict[str, list[FoundTile]] = {}
    for tile in tiles:
        named = tile.named if tile.otherwise is None else tile.otherwise[0]
        folders.setdefault("" if named is None or tile.place.is_file() else named.label, []).append(tile)
    doubtful = set()
    for members in folders.values():
        if not any(has_coordinates(tile.info.path.stem) for tile in members):
            continue
        looks: dict[str, list[FoundTile]] = {}
        for tile in members:
            looks.setdefault(tile.named.label if tile.named else "", []).append(tile)
        short = [tile for tile in members if tile.otherwise is not None]
        if len(looks) < 2 or all(measured_then(tile) for tile in short):
            # of one day alone, a wrong one parts nothing
            short = [tile for tile in short if len(looks) < 2 and tile.dates.measured is not None and not measured_then(tile)]
        elif any(ground_in_common(a, b) > SAME_GROUND for k, a in enumerate(looks.values()) for b in list(looks.values())[:k]):
            continue
        doubtful |= {tile.info.path for tile in short}
    return [
        replace(tile, named=tile.otherwise[0], place=tile.otherwise[1], otherwise=None)
        if tile.otherwise is not None and tile.info.path in doubtful
        else tile
        for tile in tiles
    ]


def _without_repeats(tiles: Sequence[FoundTile]) -> tuple[list[FoundTile], dict[Path, tuple[str, ...]]]:
    """Tiles without those that say the same as another of the same name or folder, and a note on each under the tile that stays."""
    kept: dict[tuple[object, ...], FoundTile] = {}
    notes: dict[Path, tuple[str, ...]] = {}
    for tile in tiles:
        info = tile.info
        key = (info.points, info.low, info.high, tile.named.label if tile.named else tile.place, tile.dates.measured)
        first = kept.setdefault(key, tile)
        if first is not tile:
            notes[first.info.path] = (
                *notes.get(first.info.path, ()),
                f"{info.path.name} repeats {first.info.path.name} (same points and extent): left out",
            )
    by_epoch = {tile.info.path: notes.get(tile.info.path, ()) for tile in kept.values()}
    return list(kept.values()), by_epoch


def _split_by_place(groups: dict[tuple[str, Path | None], list[FoundTile]]) -> dict[tuple[str, Path | None], list[FoundTile]]:
    """Folders of one date that show the same ground are epochs of their own, such as ``before_2024-04-09`` and ``after_2024-04-09``."""
    out: dict[tuple[str, Path | None], list[FoundTile]] = {}
    for (label, _), members in groups.items():
        by_place: dict[Path, list[FoundTile]] = {}
        for tile in members:
            by_place.setdefault(tile.place if tile.place.is_dir() else tile.place.parent, []).append(tile)
        if len(by_place) > 1 and _same_ground(list(by_place.values())):
            out |= {(label, place): own for place, own in by_place.items()}
        elif (looks := looks_at(members)) and are_told(looks):
            out |= {(label, place): own for place, own in looks.items()}
        else:
            out[label, None] = members
    return out


def _with_doubts(epoch: FoundEpoch, found: Sequence[FoundTile], dropped: Mapping[Path, str]) -> FoundEpoch:
    """An epoch with what its tiles leave open; ``dropped`` holds dates that may stand in their names."""
    paths = {tile.path for tile in epoch.tiles}
    note, question = said_of(looks_at(tile for tile in found if tile.info.path in paths))
    notes = [*epoch.notes, note] if note else list(epoch.notes)
    days = sorted({dropped[tile.path] for tile in epoch.tiles if tile.path in dropped})
    if days:
        name = next(tile.path.name for tile in epoch.tiles if tile.path in dropped)
        said = " to ".join(days if len(days) < 3 else (days[0], days[-1]))
        notes.append(f"six digits of names such as {name} are taken for coordinates; if they are days ({said}), write them as {days[0]}")
    return replace(epoch, notes=tuple(notes), questions=(f"{epoch.label}: {question}",) if question else ())


def _same_ground(groups: Sequence[Sequence[FoundTile]]) -> bool:
    """Whether every two groups cover much of the same ground."""
    extents = [_extent([tile.info for tile in group]) for group in groups]
    return all(share_in_common(a, b) > SAME_GROUND for k, a in enumerate(extents) for b in extents[:k])


def _dated_epoch(label: str, place: Path | None, tiles: Sequence[FoundTile]) -> FoundEpoch:
    named = next(tile.named for tile in tiles if tile.named is not None)
    where = next(tile.place for tile in tiles)
    source = f"folder {where.name}" if where.is_dir() else f"file names ({where.name})"
    notes = []
    times = [tile.dates.measured for tile in tiles if tile.dates.measured is not None]
    day = named.day
    if named.swapped is not None:
        if times and abs(min(times).date() - named.swapped) < timedelta(days=2):
            day = named.swapped
        elif not times:
            notes.append(f"{where.name} is read day first, as {named.day}; if the month comes first, it is {named.swapped}")
    named = replace(named, day=day)
    when, reason = _time_of_day(named, times)
    return FoundEpoch(
        place.name if place is not None else named.label,
        when,
        tuple(sorted((tile.info for tile in tiles), key=lambda info: info.path)),
        f"date from {source}; {reason}",
        tuple(notes),
    )


def _time_of_day(named: NamedDate, times: Sequence[datetime]) -> tuple[datetime, str]:
    """Time of an epoch of a named date, and where it comes from; GPS times of other days belong to the export, not to the survey."""
    fitting = [when for when in times if named.holds(when.date()) or (named.exactness == DAY and abs(when.date() - named.day).days <= 1)]
    if fitting:
        return min(fitting).replace(microsecond=0), "time from the points' GPS time"
    noon = datetime.combine(named.day, NOON)
    disagree = f" (the points' GPS time says {min(times):%Y-%m-%d})" if times else ""
    if named.exactness == DAY:
        return noon, f"time of day unknown, noon UTC taken{disagree}"
    middle = noon + timedelta(days=15 if named.exactness == 1 else 181)
    return middle, f"day unknown, the middle of {named.label} taken{disagree}"


def _undated_groups(tiles: Sequence[FoundTile]) -> list[tuple[list[FoundTile], Path | None]]:
    """Tiles without a date in any name: by GPS time, else by folder where folders show the same ground, else all together.

    The folder is the one after which the epoch is called.
    """
    if not tiles:
        return []
    if all(tile.dates.measured is not None for tile in tiles):
        groups: list[tuple[list[FoundTile], Path | None]] = []
        for group in _by_days(tiles, [t.dates.measured.date() for t in tiles if t.dates.measured]):
            looks = looks_at(group)
            groups += [(own, folder) for folder, own in looks.items()] if looks and are_told(looks) else [(group, None)]
        return groups
    by_folder: dict[Path, list[FoundTile]] = {}
    for tile in tiles:
        by_folder.setdefault(tile.place, []).append(tile)
    looks = looks_at(tiles)
    if len(by_folder) > 1 and _same_ground(list(by_folder.values())):
        # before/las and after/las are called before and after
        return [(group, folder) for folder, group in (looks if len(looks) == len(by_folder) else by_folder).items()]
    if looks and are_told(looks):
        return [(group, folder) for folder, group in looks.items()]
    made = [tile.dates.made for tile in tiles]
    if all(day is not None for day in made):
        by_day = _by_days(tiles, [day for day in made if day is not None])
        if len(by_day) > 1 and _same_ground(by_day):
            return [(group, None) for group in by_day]
    return [(list(tiles), None)]


def _by_days(tiles: Sequence[FoundTile], days: Sequence[date]) -> list[list[FoundTile]]:
    order = sorted(range(len(tiles)), key=lambda k: days[k])
    groups = [[tiles[order[0]]]]
    for before, k in pairwise(order):
        if (days[k] - days[before]).days >= ONE_EPOCH_DAYS:
            groups.append([])
        groups[-1].append(tiles[k])
    return groups


def _undated_epoch(tiles: Sequence[FoundTile], folder: Path | None) -> FoundEpoch:
    infos = tuple(sorted((tile.info for tile in tiles), key=lambda info: info.path))
    times = [tile.dates.measured for tile in tiles if tile.dates.measured is not None]
    made = [tile.dates.made for tile in tiles if tile.dates.made is not None]
    notes: tuple[str, ...] = ()
    if times:
        when, reason = min(times).replace(microsecond=0), "date and time from the points' GPS time"
    elif made:
        when = datetime.combine(min(made), NOON)
        reason = "day on which the files were made, from their headers"
        notes = ("no name and no GPS time tells when it was measured: correct the time if the files were made later",)
    else:
        newest = max(info.path.stat().st_mtime for info in infos)
        when = datetime.fromtimestamp(newest, tz=UTC).replace(microsecond=0)
        reason = "time at which the files were written"
        notes = ("nothing in the files tells when it was measured: correct the time",)
    label = when.date().isoformat() if folder is None else folder.name
    return FoundEpoch(label, when, infos, reason, notes)


def _distinct(epochs: Sequence[FoundEpoch]) -> list[FoundEpoch]:
    """Epochs with labels and times that no other has: survey.toml asks for it."""
    out: list[FoundEpoch] = []
    for epoch in epochs:
        label, when, count = epoch.label, epoch.time, 2
        while any(other.label == label for other in out):
            label, count = f"{epoch.label} ({count})", count + 1
        while any(other.time == when for other in out):
            when += timedelta(minutes=1)
        out.append(replace(epoch, label=label, time=when))
    return out


def _extent(tiles: Sequence[TileInfo]) -> tuple[float, float, float, float]:
    return (
        min(tile.low[0] for tile in tiles),
        min(tile.low[1] for tile in tiles),
        max(tile.high[0] for tile in tiles),
        max(tile.high[1] for tile in tiles),
    )
