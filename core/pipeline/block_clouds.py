"""Points of blocks that the search leaves to those who look at them again in the same run, read and sorted already."""

from __future__ import annotations

import hashlib
import math
import os
import shutil
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray
from ..common.atomic_files import temporary_beside
from ..common.errors import OutputError
from ..data.tiles import PointCloud, Window, read_points
from .blocks import Block

MOST_KEPT = 10_000_000
"""Points of a survey up to which they are kept, a quarter of a gigabyte: of longer ones the tiles are read again."""
LEAST_FREE = 2**30
"""Bytes of the disk that stay free for results: points that are kept only save time."""
LOOK_SECONDS = 0.02
"""Between two looks whether points are kept already."""


@dataclass(frozen=True)
class BlockClouds:
    """Where points of blocks are kept.

    Attributes
    ----------
    folder
        Of one run, whose tiles do not change; None keeps none.
    """

    folder: Path | None = None

    def keep(self, block: Block, window: Window, cloud: PointCloud) -> None:
        """Leave the points of a window around a block; where the disk does not take them, they are read again."""
        if self.folder is None or cloud.spread is not None:
            return
        path = self._path(self.folder, block)
        with suppress(OSError, OutputError):
            if shutil.disk_usage(self.folder).free < LEAST_FREE + cloud.xyz.nbytes + cloud.source_id.nbytes:
                return
            with temporary_beside(path) as temporary:
                with temporary.open("wb") as stream:
                    np.save(stream, np.array([window.west, window.south, window.east, window.north]))
                    # to reduce them was exact where coordinates are large: what is read is what stands in the tiles
                    np.save(stream, cloud.xyz + cloud.origin)
                    np.save(stream, cloud.source_id)
                os.replace(temporary, path)

    def points(self, block: Block, survey_crs: str, window: Window, origin: FloatArray) -> tuple[FloatArray, NDArray[np.integer[Any]]]:
        """(n, 3) points of a block within a window, less ``origin``, and (n,) sources.

        Raises
        ------
        InputError
            A tile is damaged.
        """
        kept = self._kept(block, window)
        if kept is None:
            cloud = read_points(block.tiles, survey_crs, window=window, origin=origin)
            return cloud.xyz, cloud.source_id
        xyz, sources = kept
        inside = window.contains(xyz)
        return xyz[inside] - origin, sources[inside]

    def of_so_many(self, points: int) -> BlockClouds:
        """These, or none where a survey has too many points to keep."""
        return self if points <= MOST_KEPT else NOT_KEPT

    def awaited(self, blocks: Sequence[Block], seconds: float, is_cancelled: Callable[[], bool] = lambda: False) -> FloatArray | None:
        """(n, 3) points of an epoch of one block that another process is reading, as soon as it keeps them.

        None where there are more blocks or none is kept, or where that takes longer than so many ``seconds``.
        """
        if self.folder is None or len(blocks) != 1 or any(tile.thinned for tile in blocks[0].tiles):
            return None
        everywhere = Window(-math.inf, -math.inf, math.inf, math.inf)
        end = time.monotonic() + seconds
        while (kept := self._kept(blocks[0], everywhere)) is None and time.monotonic() < end and not is_cancelled():
            time.sleep(LOOK_SECONDS)
        return None if kept is None else kept[0]

    def _kept(self, block: Block, window: Window) -> tuple[FloatArray, NDArray[np.integer[Any]]] | None:
        """(n, 3) positions and (n,) sources of the points around a block, if those are kept that the window needs."""
        if self.folder is None:
            return None
        try:
            with self._path(self.folder, block).open("rb") as stream:
                west, south, east, north = np.load(stream)
                # beyond the tiles there is nothing to be read
                low = np.maximum((window.west, window.south), np.min([tile.low[:2] for tile in block.tiles], axis=0))
                high = np.minimum((window.east, window.north), np.max([tile.high[:2] for tile in block.tiles], axis=0))
                if low[0] < west or low[1] < south or high[0] >= east or high[1] >= north:
                    return None
                return np.load(stream), np.load(stream)
        except (OSError, EOFError, ValueError):
            return None

    @staticmethod
    def _path(folder: Path, block: Block) -> Path:
        return folder / f"cloud-{hashlib.sha256(block.epoch.encode()).hexdigest()[:12]}-{block.column}-{block.row}.npy"


NOT_KEPT = BlockClouds()
"""Tiles are read each time."""
