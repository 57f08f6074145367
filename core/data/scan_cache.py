"""What a look through a tile found, kept beside other caches of the user so that the next command need not look again.

Nothing depends on it: where it cannot be read or written, tiles are looked through again.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..common.atomic_files import temporary_beside
from ..common.errors import OutputError
from ..common.software import code_fingerprint
from ..common.user_cache import cache_folder
from .occupancy import Occupancy
from .places_by_second import PlacesBySecond

MOST_FILES = 4000
"""Files kept; the oldest go."""


@dataclass(frozen=True, eq=False)
class Scan:
    """Extents (3,) of all points in the tile's own CRS, and of the points that are used in the survey's, and where these are.

    Of the points that are used also the first and last GPS time (2,), infinity and its negative where there is none, the point source IDs
    that occur (k,), and where they were measured in each second. Of a tile that was thinned, the key of the means
    (:mod:`.thinned_clouds`) and their number.
    """

    raw_low: FloatArray
    raw_high: FloatArray
    low: FloatArray
    high: FloatArray
    cells: Occupancy
    times: FloatArray
    sources: IntArray
    by_second: PlacesBySecond
    thinned: str = ""
    means: int = 0


def key_of(path: Path, settings: str) -> str:
    """Name of what is known of a file in its present state, looked at in a certain way."""
    state = path.stat()
    parts = (
        str(path.resolve()),
        state.st_size,
        state.st_mtime_ns,
        state.st_ctime_ns,
        state.st_ino,
        settings,
        code_fingerprint(("common", "data")),
    )
    return hashlib.sha256(repr(parts).encode("utf-8", "surrogateescape")).hexdigest()[:40]


def load(key: str) -> Scan | None:
    """What was found then; None where nothing is known or the memory is damaged."""
    folder = scans_folder()
    if folder is None:
        return None
    try:
        with np.load(folder / f"{key}.npz", allow_pickle=False) as kept:
            cells = Occupancy(int(kept["level"]), kept["cells"], kept["counts"], kept["heights"])
            own = {name: kept[name] for name in ("raw_low", "raw_high", "low", "high", "times", "sources")}
            by_second = PlacesBySecond(kept["seconds"], kept["by_second"], kept["sums"])
            return Scan(**own, cells=cells, by_second=by_second, thinned=str(kept["thinned"]), means=int(kept["means"]))
    except Exception:
        # a damaged archive raises whatever its bytes lead to, as in array_files.load_arrays
        return None


def store(key: str, scan: Scan) -> None:
    """Remember what was found, if that is possible."""
    folder = scans_folder()
    if folder is None:
        return
    cells = scan.cells
    buffer = io.BytesIO()
    np.savez_compressed(
        buffer, raw_low=scan.raw_low, raw_high=scan.raw_high, low=scan.low, high=scan.high,
        level=np.array(cells.level), cells=cells.cells, counts=cells.counts, heights=cells.heights,
        times=scan.times, sources=scan.sources,
        seconds=scan.by_second.seconds, by_second=scan.by_second.counts, sums=scan.by_second.sums,
        thinned=np.array(scan.thinned), means=np.array(scan.means),
    )  # fmt: skip
    # a memory that cannot be kept is no loss
    with contextlib.suppress(OSError, OutputError), temporary_beside(folder / f"{key}.npz") as temporary:
        temporary.write_bytes(buffer.getbuffer())
        temporary.replace(folder / f"{key}.npz")


@cache
def scans_folder() -> Path | None:
    """Folder of the memory, tidied; None where there can be none."""
    folder = cache_folder("tiles")
    try:
        files = sorted(folder.glob("*.npz"), key=lambda path: path.stat().st_mtime) if folder else []
        for old in files[:-MOST_FILES]:
            old.unlink()
    except OSError:
        return None
    return folder
