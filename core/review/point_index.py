"""Points around single units, from an index beside the result that answers in milliseconds.

The index holds, per epoch and tile, the points near any unit in the control frame, sorted by square cells, as plain numpy
files of which only the cells asked for are read: neither LAZ nor the engine is needed. No file is kept open between two looks, since
Windows does not let go of a folder with open files, and an index that was built anew meanwhile is taken up by itself.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import re
import shutil
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from tokenize import TokenError

import numpy as np
from numpy.typing import ArrayLike

from ..common.arrays import FloatArray, IntArray
from ..common.atomic_files import process_mark, remove_leftovers
from ..common.errors import InputError, OutputError
from ..common.input_files import content_of
from ..results.geopackage_reader import parse_settings, parse_time, read_layer_rows
from ..results.result_access import reading

INDEX_VERSION = 3
SCALE = 1e-4
"""Resolution of stored coordinates, metres: far below any sensor's noise."""
MAX_SPAN = 4e5
"""Extent in metres that the numbers of one part hold about its own origin."""
REMEDY = "Build it with tetratrack unit-points, or from the review dock."
_STRIDE = 1 << 20
_PLAIN_NAME = re.compile(r"[0-9A-Za-z_-][0-9A-Za-z_.-]{0,120}")
"""Names of an index's files: none leads out of its folder."""
LEAST_CELL = 0.02
"""Metres: smaller cells would take for ever to go through."""
MOST_HALF_SIZE = 200.0


@dataclass(frozen=True)
class IndexPart:
    """Points of one tile: file stem, number of points, bounds (min e, min n, max e, max n) and origin of their numbers, metres."""

    stem: str
    count: int
    bounds: tuple[float, float, float, float]
    origin: tuple[float, float, float]


def damaged(place: Path) -> InputError:
    """What to say of an index that cannot be used."""
    return InputError(
        "is no point index, or a damaged one", source=place, remedy="Delete the folder and build it again with tetratrack unit-points."
    )


def index_folder(result: Path) -> Path:
    """Folder of the point index that belongs to a result.gpkg."""
    return result.with_name(f"{result.stem}.points")


def kept_survey(result: Path) -> Path:
    """The survey.toml kept beside a result.gpkg whose survey was given in a dialog; it need not exist."""
    return result.with_name(f"{result.stem}_survey") / "survey.toml"


def frames_state(result: Path) -> str:
    """Checksum of what places points in the frame of a result: transformations, offsets of strips and stations, bends, and inputs.

    Decisions and corrections change none of it.

    Raises
    ------
    InputError
        The result cannot be read.
    """
    epochs = []
    for row in sorted(read_layer_rows(result, "epochs"), key=lambda row: str(row["label"])):
        settings = parse_settings(row["settings"])
        epochs.append([row["label"], row["transformation"], settings.get("source_offsets_m"), settings.get("inputs")])
    bends = [
        [None if row["geom"] is None else row["geom"].tolist(), *(row[name] for name in sorted(row.keys() - {"fid", "geom"}))]
        for row in read_layer_rows(result, "frame_errors")
    ]
    text = json.dumps([epochs, sorted(bends, key=str)], sort_keys=True, default=str)
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def index_of(result: Path) -> PointIndex:
    """The index beside a result, which must have been built for what the result is now.

    Raises
    ------
    InputError
        There is none, it cannot be used, or the result was computed anew since; or the result cannot be read.
    """
    index = PointIndex(index_folder(result))
    if index.state == frames_state(result) if index.state else index.made >= computed_at(result):
        return index
    raise InputError(
        "was built for an earlier state of the result", source=index.folder, remedy="Build it again with tetratrack unit-points."
    )


def computed_at(result: Path) -> float:
    """When the epochs of a result were written, seconds; 0 where it does not say: corrections and decisions leave them as they are."""
    with reading(result) as connection:
        row = connection.execute("SELECT last_change FROM gpkg_contents WHERE table_name = 'epochs'").fetchone()
        moment = parse_time(None if row is None else str(row["last_change"] or ""))
    return 0.0 if moment is None else moment.timestamp()


class PointIndex:
    """Points of a survey near its units, by epoch; :func:`index_of` finds out whether they are those of the result.

    Parameters
    ----------
    folder
        What :func:`write_index` wrote.

    Attributes
    ----------
    state
        Of the result it was built for, see :func:`frames_state`; empty where an earlier version wrote it.
    made
        When it was written, seconds.

    Raises
    ------
    InputError
        There is no index, or one of another version.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._describe()

    def _describe(self) -> None:
        """Read what the index holds."""
        description = self.folder / "index.json"
        self._cells: dict[str, tuple[IntArray, IntArray]] = {}
        if not description.is_file():
            raise InputError("there is no point index", source=self.folder, remedy=REMEDY)
        try:
            content = json.loads(content_of(description).decode("utf-8"))
            version, self.state = content["version"], str(content.get("state", ""))
            self.made = description.stat().st_mtime
        except (AttributeError, InputError, KeyError, OSError, RecursionError, TypeError, ValueError) as error:
            raise damaged(description) from error
        if version != INDEX_VERSION:
            raise InputError(f"is a point index of version {version}, not {INDEX_VERSION}", source=description, remedy=REMEDY)
        try:
            self.grid_origin = np.array(content["grid_origin"], dtype=np.float64)
            self.cell = float(content["cell"])
            self._parts = {
                epoch: [IndexPart(part["stem"], int(part["count"]), tuple(part["bounds"]), tuple(part["origin"])) for part in parts]
                for epoch, parts in content["epochs"].items()
            }
            self._noise = {epoch: (float(sds[0]), float(sds[1])) for epoch, sds in content.get("noise", {}).items()}
            self._check()
        except (AttributeError, IndexError, KeyError, OverflowError, RecursionError, TypeError, ValueError) as error:
            raise damaged(description) from error

    def _check(self) -> None:
        """Refuse what would lead out of the folder or into endless loops.

        Raises
        ------
        ValueError
            A value that no index holds.
        """
        numbers = [self.cell, *self.grid_origin, *(value for sds in self._noise.values() for value in sds)]
        for parts in self._parts.values():
            for part in parts:
                numbers += [*part.bounds, *part.origin]
                if not _PLAIN_NAME.fullmatch(part.stem) or len(part.bounds) != 4 or len(part.origin) != 3 or part.count < 0:
                    raise ValueError(part.stem)
        if self.grid_origin.shape != (2,) or self.cell < LEAST_CELL or not all(abs(value) < 1e9 for value in numbers):
            raise ValueError("cell")

    @property
    def epochs(self) -> tuple[str, ...]:
        """Labels of the epochs the index holds."""
        return tuple(self._parts)

    def noise(self, epoch: str) -> tuple[float, float] | None:
        """Standard deviations of ranges, metres, and of the beams' directions, radians; None where the sensor's positions are not known."""
        return self._noise.get(epoch)

    def read(self, epoch: str, centre: ArrayLike, half_size: float) -> FloatArray:
        """(n, 3) points of an epoch in the cube ``centre`` ± ``half_size`` metres, control frame; (0, 3) where nothing is indexed."""
        return self._read(epoch, centre, half_size, 3)

    def read_with_sensors(self, epoch: str, centre: ArrayLike, half_size: float) -> tuple[FloatArray, FloatArray]:
        """Points as :meth:`read` gives them, and (n, 3) positions of the sensor when it measured each; of epochs with :meth:`noise`."""
        found = self._read(epoch, centre, half_size, 6)
        return found[:, :3], found[:, 3:]

    def clouds(self, epoch: str) -> Iterator[FloatArray]:
        """Points (n, 3) of an epoch, one tile at a time, control frame."""
        for part in self._parts.get(epoch, []):
            try:
                coordinates = np.load(self.folder / f"{part.stem}.points.npy", mmap_mode="r", allow_pickle=False)
                if coordinates.dtype != np.int32 or coordinates.ndim != 2 or coordinates.shape[1] < 3:
                    raise ValueError("points")
            except (EOFError, OSError, SyntaxError, TokenError, ValueError) as error:
                raise damaged(self.folder / part.stem) from error
            yield np.asarray(coordinates[:, :3] * SCALE + np.array(part.origin))

    def _read(self, epoch: str, centre: ArrayLike, half_size: float, columns: int) -> FloatArray:
        """(n, columns) coordinates of points, and of their sensors where that many are asked for."""
        middle = np.asarray(centre, dtype=np.float64)
        low, high = middle - half_size, middle + half_size
        if not (np.abs(middle) < 1e9).all() or not 0 < half_size < MOST_HALF_SIZE:
            raise InputError(f"there are no points around {middle.tolist()}", source=self.folder, remedy="Choose a place in the survey.")
        try:
            points = self._read_parts(epoch, low, high, columns)
        except FileNotFoundError:
            # built anew since it was opened, with names of its own
            self._describe()
            try:
                points = self._read_parts(epoch, low, high, columns)
            except FileNotFoundError as error:
                raise damaged(self.folder) from error
        return points[np.all((points[:, :3] >= low) & (points[:, :3] <= high), axis=1)]

    def _read_parts(self, epoch: str, low: FloatArray, high: FloatArray, columns: int) -> FloatArray:
        found = [np.empty((0, columns))]
        for part in self._parts.get(epoch, []):
            e0, n0, e1, n1 = part.bounds
            if e1 < low[0] or e0 > high[0] or n1 < low[1] or n0 > high[1]:
                continue
            found.append(self._read_part(part, low, high, columns))
        return np.vstack(found)

    def _read_part(self, part: IndexPart, low: FloatArray, high: FloatArray, columns: int) -> FloatArray:
        try:
            return self._read_cells(part, low, high, columns)
        except FileNotFoundError:
            raise
        except (AttributeError, EOFError, IndexError, OSError, OverflowError, SyntaxError, TokenError, TypeError, ValueError) as error:
            raise damaged(self.folder / part.stem) from error

    def _read_cells(self, part: IndexPart, low: FloatArray, high: FloatArray, columns: int) -> FloatArray:
        if part.stem not in self._cells:
            table = np.load(self.folder / f"{part.stem}.cells.npy", allow_pickle=False)
            if table.dtype != np.int64 or table.ndim != 2 or len(table) != 2 or (np.diff(table) < 0).any() or (table[1] < 0).any():
                raise ValueError("cells")
            self._cells[part.stem] = table[0], table[1]
        keys, starts = self._cells[part.stem]
        first = np.floor((low[:2] - self.grid_origin) / self.cell).astype(np.int64)
        last = np.floor((high[:2] - self.grid_origin) / self.cell).astype(np.int64)
        # the map ends with this look
        coordinates = np.load(self.folder / f"{part.stem}.points.npy", mmap_mode="r", allow_pickle=False)
        if coordinates.dtype != np.int32 or coordinates.ndim != 2 or coordinates.shape[1] < columns or len(coordinates) < starts[-1]:
            raise ValueError("points")
        pieces = []
        # cells of one row follow each other in the file
        for i in range(int(first[0]), int(last[0]) + 1):
            a = np.searchsorted(keys, _key(i, int(first[1])), side="left")
            b = np.searchsorted(keys, _key(i, int(last[1])), side="right")
            if b > a:
                pieces.append(np.asarray(coordinates[starts[a] : starts[b], :columns]))
        return np.asarray(np.vstack(pieces) * SCALE + np.tile(part.origin, columns // 3)) if pieces else np.empty((0, columns))


def write_index(
    folder: Path,
    tiles: Iterable[tuple[str, str, FloatArray]],
    centres: ArrayLike,
    half_size: float,
    cell: float | None = None,
    *,
    noise: Mapping[str, tuple[float, float]] | None = None,
    state: str = "",
) -> int:
    """Write the index of all points near units; an index that is there already is replaced when the new one is complete.

    Parameters
    ----------
    folder
        Where to write, see :func:`index_folder`.
    tiles
        (epoch label, tile name, (n, 3) points in the control frame), one tile at a time; of epochs in ``noise`` (n, 6), with the position
        of the sensor after that of each point.
    centres
        (m, 3) centres of the units in all epochs.
    half_size
        All points within this of a centre in easting and northing are kept, metres, and the rest of the cells that this reaches into.
    cell
        Edge of the cells, metres; half of ``half_size`` by default.
    noise
        By epoch whose sensor positions are known, standard deviations of ranges (metres) and of the beams' directions (radians).
    state
        Of the result that the points are placed for, see :func:`frames_state`.

    Returns
    -------
    int
        Number of points indexed.

    Raises
    ------
    InputError
        There are no units, or points of one tile lie hundreds of kilometres apart.
    OutputError
        The folder cannot be written.
    """
    middle = np.asarray(centres, dtype=np.float64).reshape(-1, 3)
    if len(middle) == 0:
        raise InputError("there are no units to index points around", source=folder, remedy="Run the survey first.")
    edge = half_size / 2 if cell is None else cell
    origin = np.floor(middle[:, :2].min(axis=0) - 2 * half_size)
    wanted = _cells_near(middle, origin, half_size, edge)
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        remove_leftovers(folder)
        work = folder.with_name(f".{folder.name}.{process_mark()}")
        work.mkdir(mode=0o777)
    except OSError as error:
        raise OutputError(f"cannot be written ({error.strerror})", source=folder, remedy="Choose a folder that can be written.") from error
    parts: dict[str, list[IndexPart]] = {}
    # names of their own for every index: one that reads an older index never mixes the two
    build = work.name.removeprefix(f".{folder.name}.")
    try:
        for number, (epoch, tile, points) in enumerate(tiles):
            kept = _write_part(work / f"{build}-{number:05d}", points, origin, edge, wanted, tile)
            parts.setdefault(epoch, []).extend([] if kept is None else [kept])
        content = {
            "version": INDEX_VERSION,
            "state": state,
            "grid_origin": origin.tolist(),
            "cell": edge,
            "half_size": half_size,
            "epochs": {epoch: [asdict(part) for part in own] for epoch, own in parts.items()},
            "noise": dict(noise or {}),
        }
        (work / "index.json").write_text(json.dumps(content, indent=1), encoding="utf-8")
        _put(work, folder)
    except OSError as error:
        raise OutputError(
            f"cannot be written ({error.strerror or error})", source=folder, remedy="Free disk space or choose another folder."
        ) from error
    finally:
        shutil.rmtree(work, ignore_errors=True)
    return sum(part.count for own in parts.values() for part in own)


def _put(work: Path, folder: Path) -> None:
    """Give a finished index its name; one that has it already goes only when the new one is in its place."""
    aside = work.with_name(f"{work.name}.old")
    if folder.exists():
        os.replace(folder, aside)
    try:
        os.replace(work, folder)
    except OSError:
        if aside.exists():
            os.replace(aside, folder)
        raise
    shutil.rmtree(aside, ignore_errors=True)


def _write_part(stem: Path, points: FloatArray, grid_origin: FloatArray, cell: float, wanted: IntArray, tile: str) -> IndexPart | None:
    """Write the points of one tile in wanted cells; None where there are none."""
    place = np.floor((points[:, :2] - grid_origin) / cell).astype(np.int64)
    keys = place[:, 0] * _STRIDE + place[:, 1]
    inside = (place >= 0).all(axis=1) & (place < _STRIDE).all(axis=1)
    slot = np.minimum(np.searchsorted(wanted, keys), len(wanted) - 1)
    near = inside & (wanted[slot] == keys)
    if not near.any():
        return None
    kept, keys = points[near], keys[near]
    order = np.argsort(keys, kind="stable")
    kept, keys = kept[order], keys[order]
    cells, starts = np.unique(keys, return_index=True)
    # one more start than cells, so that the last cell ends somewhere; its key is never asked for
    table = np.vstack([np.append(cells, np.iinfo(np.int64).max), np.append(starts, len(kept))])
    np.save(stem.with_name(f"{stem.name}.cells.npy"), table)
    low, high = kept.min(axis=0), kept.max(axis=0)
    middle = np.round((low[:3] + high[:3]) / 2)
    reduced = kept - np.tile(middle, kept.shape[1] // 3)
    if np.abs(reduced).max() > MAX_SPAN / 2:
        raise InputError(
            f"points, or the sensor and its points, are {1e-3 * np.abs(reduced).max():.0f} km from the middle",
            source=Path(tile),
            remedy="Check the tile's coordinates and the sensor's positions, or cut the tile into smaller ones.",
        )
    np.save(stem.with_name(f"{stem.name}.points.npy"), np.round(reduced / SCALE).astype(np.int32))
    return IndexPart(
        stem.name,
        len(kept),
        (float(low[0]), float(low[1]), float(high[0]), float(high[1])),
        (float(middle[0]), float(middle[1]), float(middle[2])),
    )


def _cells_near(centres: FloatArray, origin: FloatArray, half_size: float, cell: float) -> IntArray:
    """Sorted keys of all cells that reach into ``half_size`` of a centre."""
    reach = math.ceil(half_size / cell)
    step = np.arange(-reach, reach + 1)
    place = np.floor((centres[:, :2] - origin) / cell).astype(np.int64)
    i = (place[:, 0, None, None] + step[None, :, None]) * _STRIDE
    return np.unique(i + place[:, 1, None, None] + step[None, None, :])


def _key(i: int, j: int) -> int:
    return i * _STRIDE + j
