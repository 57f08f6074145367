"""Where the points of a cloud are, in coarse cells: what headers say of their extent is not to be believed.

Cells are cubes whose edge is a power of two metres, counted from zero, so that cells of several tiles fall together whatever the
tiling, and coarser ones are made of finer ones without a look at the points.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..common.arrays import BoolArray, FloatArray, IntArray, corners

MOST_CELLS = 200_000
"""Cells kept of one tile; with more of them, cells are made coarser."""
GAP_CELLS = 8
"""Points are apart from the rest with at least so many empty cells between."""
FEW_POINTS, FEW_SHARE = 1000, 1e-3
"""Points apart from the rest are no part of the site where they are fewer than this, and less than this share of all."""
MOST_STRAYS = 0.05
"""Largest share of points that may be apart in this way."""
HANDFUL, HANDFUL_SHARE = 4, 0.02
"""In small clouds: fewer than a handful, and less than this share."""


@dataclass(frozen=True, eq=False)
class Occupancy:
    """Occupied cells.

    Attributes
    ----------
    level
        Edge of a cell, as a power of two: 2 ** level metres.
    cells
        (m, 3) whole numbers: cell k spans ``cells[k] * size`` to ``(cells[k] + 1) * size``; in lexicographic order, each once.
    counts
        (m,) points in each.
    heights
        (m,) sum of their heights, metres.
    """

    level: int
    cells: IntArray
    counts: IntArray
    heights: FloatArray

    @property
    def size(self) -> float:
        """Edge of a cell, metres."""
        return float(2.0**self.level)

    @property
    def points(self) -> int:
        """Points in all cells."""
        return int(self.counts.sum())

    @classmethod
    def empty(cls, level: int) -> Occupancy:
        """No points at all."""
        return cls(level, np.empty((0, 3), dtype=np.int64), np.empty(0, dtype=np.int64), np.empty(0))

    @classmethod
    def of(cls, points: FloatArray, level: int) -> Occupancy:
        """Cells of (n, 3) points."""
        if not len(points):
            return cls.empty(level)
        cells = np.floor(points / 2.0**level).astype(np.int64)
        return _merged(level, cells, np.ones(len(points), dtype=np.int64), points[:, 2])

    def coarser(self, level: int) -> Occupancy:
        """The same points in larger cells."""
        if level <= self.level:
            return self
        return _merged(level, self.cells >> (level - self.level), self.counts, self.heights)

    def bounded(self) -> Occupancy:
        """The same points in at most ``MOST_CELLS`` cells."""
        found = self
        while len(found.cells) > MOST_CELLS:
            found = found.coarser(found.level + 1)
        return found

    def select(self, keep: BoolArray) -> Occupancy:
        """Some of the cells."""
        return Occupancy(self.level, self.cells[keep], self.counts[keep], self.heights[keep])

    def box(self) -> tuple[FloatArray, FloatArray]:
        """(3,) lowest and (3,) highest corner of all cells, metres."""
        return self.cells.min(axis=0) * self.size, (self.cells.max(axis=0) + 1) * self.size


def merged(parts: Sequence[Occupancy]) -> Occupancy:
    """Points of several parts together, in the coarsest of their cells."""
    level = max(part.level for part in parts)
    even = [part.coarser(level) for part in parts]
    return _merged(
        level,
        np.concatenate([part.cells for part in even]),
        np.concatenate([part.counts for part in even]),
        np.concatenate([part.heights for part in even]),
    )


def level_for(unit_height: float) -> int:
    """Level of cells for units of a height in metres: up to 2.5 heights across."""
    return math.floor(math.log2(2.5 * unit_height))


def stray_cells(site: Occupancy) -> BoolArray:
    """(m,) cells of a few points far from all others: a reflection of the sun, a bird, a point at the origin of the coordinates."""
    if len(site.cells) < 2:
        return np.zeros(len(site.cells), dtype=np.bool_)
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import cKDTree

    blocks, block_of = np.unique(site.cells // GAP_CELLS, axis=0, return_inverse=True)
    pairs = cKDTree(blocks.astype(np.float64)).query_pairs(1.0, p=np.inf, output_type="ndarray")
    links = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(len(blocks), len(blocks)))
    _, group_of = connected_components(links, directed=False)
    group = group_of[block_of.reshape(-1)]
    points = np.bincount(group, weights=site.counts)
    main = int(points.argmax())
    few = points < min(FEW_POINTS, max(FEW_SHARE * site.points, min(HANDFUL, HANDFUL_SHARE * site.points)))
    # a point without coordinates has zeros; there may be many of them
    elsewhere = ~np.isin(site.cells[:, :2], (-1, 0)).all(axis=1)
    few |= np.bincount(group, weights=elsewhere) == 0
    few[main] = False
    # a cloud that is nothing but scattered points has no main part
    if points[few].sum() > MOST_STRAYS * site.points:
        few[:] = False
    return np.asarray(few[group])


def share_that_differs(one: Occupancy, other: Occupancy) -> float:
    """Points that only one of two clouds has, cell by cell, over the points of both."""
    level = max(one.level, other.level)
    a, b = one.coarser(level), other.coarser(level)
    both = _merged(level, np.concatenate([a.cells, b.cells]), np.concatenate([a.counts, -b.counts]), np.concatenate([a.heights, b.heights]))
    return float(np.abs(both.counts).sum() / max(a.points + b.points, 1))


def common_height_shift(one: Occupancy, other: Occupancy, least_columns: int = 3) -> float | None:
    """Height of ``other`` less that of ``one``, metres: median over the columns of cells that both have; None where these are few."""
    level = max(one.level, other.level)
    means = []
    for part in (one.coarser(level), other.coarser(level)):
        columns, member = np.unique(part.cells[:, :2], axis=0, return_inverse=True)
        member = member.reshape(-1)
        counts = np.bincount(member, weights=part.counts)
        heights = np.bincount(member, weights=part.heights) / counts
        means.append({(int(e), int(n)): float(h) for (e, n), h in zip(columns, heights, strict=True)})
    both = means[0].keys() & means[1].keys()
    if len(both) < least_columns:
        return None
    return float(np.median([means[1][key] - means[0][key] for key in both]))


def _merged(level: int, cells: IntArray, counts: IntArray, heights: FloatArray) -> Occupancy:
    """Cells each once, in order, with counts and heights added up."""
    if not len(cells):
        return Occupancy.empty(level)
    low, high = corners(cells)
    span = high - low + 1
    place = cells - low
    if float(span[0]) * float(span[1]) * float(span[2]) < 2.0**62:
        key = (place[:, 0] * span[1] + place[:, 1]) * span[2] + place[:, 2]
        if span.prod() <= len(cells):
            # nearly every chunk of a tile: a table of the whole box is smaller than what would be sorted
            counted, summed = np.bincount(key, weights=counts), np.bincount(key, weights=heights)
            there = np.flatnonzero(np.bincount(key))
            kept = np.column_stack([there // (span[1] * span[2]), there // span[2] % span[1], there % span[2]]) + low
            return Occupancy(level, kept, counted[there].astype(np.int64), summed[there].astype(np.float64))
        _, first, member = np.unique(key, return_index=True, return_inverse=True)
        kept = cells[first]
    else:
        kept, member = np.unique(cells, axis=0, return_inverse=True)
    member = member.reshape(-1)
    total = np.bincount(member, weights=counts).astype(np.int64)
    return Occupancy(level, kept, total, np.bincount(member, weights=heights).astype(np.float64))
