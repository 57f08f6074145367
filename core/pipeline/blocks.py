"""The survey cut into blocks that are worked on alone.

They are laid out from where the epoch's points are, so that neither the way the points were cut into files nor the number of workers
changes anything.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..data.tiles import TileInfo, Window

BLOCK_HEIGHTS = 30.0
"""Side of a block in unit heights: some two hundred units of surface, large beside the halo and small beside memory."""


LEAST_BLOCK_HEIGHTS = 5.0


MOST_BLOCK_POINTS = 3_000_000
"""Points per block that a worker with 1 GiB can hold with all that is derived from them."""


HALO_HEIGHTS = 2.5
"""A unit centred on the edge of a block reaches 0.66 H; the neighbours that compete with it for points, another 1.3 H."""


MARGIN_HEIGHTS = 0.5
"""Units centred this far outside their block are reported too, and the block they lie in decides."""


MOST_BLOCKS = 20_000
"""Blocks of an epoch; with units of 2 m some 70 km2 of armour, more than there is anywhere."""


@dataclass(frozen=True)
class Block:
    """Part of an epoch that one job works on.

    Attributes
    ----------
    epoch
        Label of the epoch.
    column, row
        Place in the epoch's grid of blocks.
    core
        The block itself; blocks of an epoch do not overlap.
    tiles
        Tiles that hold points of the core or its halo.
    """

    epoch: str
    column: int
    row: int
    core: Window
    tiles: tuple[TileInfo, ...]


def plan_blocks(epoch: str, tiles: Sequence[TileInfo], unit_height: float) -> tuple[Block, ...]:
    """Cut an epoch into equal blocks from the extent and number of its points; a block where no point is is left out.

    Parameters
    ----------
    epoch
        Label.
    tiles
        All tiles of the epoch.
    unit_height
        Largest nominal height H, metres.

    Raises
    ------
    InputError
        More blocks than any structure needs.
    """
    low = np.min([tile.low for tile in tiles], axis=0)[:2]
    high = np.max([tile.high for tile in tiles], axis=0)[:2]
    size = high - low
    count = np.maximum(1, np.ceil(size / (BLOCK_HEIGHTS * unit_height))).astype(int)
    most = np.maximum(1, np.floor(size / (LEAST_BLOCK_HEIGHTS * unit_height))).astype(int)
    points = sum(tile.held for tile in tiles)
    places = _occupied(tiles, low, size, count)
    while points / len(places) > MOST_BLOCK_POINTS and (count < most).any():
        side = np.where(count < most, size / count, -1.0)
        count[int(np.argmax(side))] += 1
        places = _occupied(tiles, low, size, count)
    if len(places) > MOST_BLOCKS:
        raise InputError(
            f"epoch {epoch} would be cut into {len(places)} blocks of {BLOCK_HEIGHTS * unit_height:.3g} m",
            remedy=f"Is the unit's height of {unit_height:g} really in metres, as the tiles are? Else make the survey smaller.",
        )
    light = [replace(tile, cells=None) for tile in tiles]
    blocks = []
    for column, row in places:
        # the last block of a row is open to the east and north, so that no point lies on an edge and in no block
        east = low[0] + size[0] * (column + 1) / count[0] if column + 1 < count[0] else math.inf
        north = low[1] + size[1] * (row + 1) / count[1] if row + 1 < count[1] else math.inf
        core = Window(float(low[0] + size[0] * column / count[0]), float(low[1] + size[1] * row / count[1]), float(east), float(north))
        grown = core.grown(HALO_HEIGHTS * unit_height)
        near = tuple(tile for tile in light if grown.meets(tile.low, tile.high))
        if any(core.meets(tile.low, tile.high) for tile in near):
            blocks.append(Block(epoch, column, row, core, near))
    return tuple(blocks)


def _occupied(tiles: Sequence[TileInfo], low: FloatArray, size: FloatArray, count: NDArray[Any]) -> list[tuple[int, int]]:
    """Columns and rows of the blocks that hold points, going by the tiles' cells, or by their extents where these are not known."""
    boxes = []
    for tile in tiles:
        if tile.cells is None:
            boxes.append(np.array([[*tile.low[:2], *tile.high[:2]]]))
        elif tile.used:
            flat = np.unique(tile.cells.cells[:, :2], axis=0)
            boxes.append(np.hstack([flat, flat + 1]) * tile.cells.size)
    box = np.vstack(boxes)
    side = np.where(size > 0, size / count, 1.0)
    first = np.clip(np.floor((box[:, :2] - low) / side - 1e-9).astype(np.int64), 0, count - 1)
    last = np.clip(np.floor((box[:, 2:] - low) / side).astype(np.int64), 0, count - 1)
    spans = np.unique(np.hstack([first, last]), axis=0)
    found: set[tuple[int, int]] = set()
    for west, south, east, north in spans.tolist():
        found.update(product(range(west, east + 1), range(south, north + 1)))
        if len(found) > 100 * MOST_BLOCKS:
            break
    return sorted(found)
