"""Neighbours of places among many points: a uniform grid for kernels that gather them inside compiled loops, and the nearest ones of a few
places, for which no tree is grown."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from .arrays import FloatArray, IntArray, corners
from .kernels import kernel

AT_ONCE = 100_000
"""Points whose cells are found together."""
SPARSE_NEIGHBOURS = 4
"""Which neighbour among places tells how dense the points are around one of them."""
FEWEST_A_PLACE = 15
"""Points for each place from which it takes less time to go past all of them than to grow a tree."""
GENEROUS = 2.0
"""How much farther neighbours are looked for than they are supposed to lie: four times as many are found on a surface."""
FEW_IN_COLUMN = 12
"""Points for each column of a row of cells up to which all of the row's are gone past, however high they lie."""
MOST_SQUARES = 4_000_000
"""Squares of a table of places, or places listed in them, up to which it is made: 32 MB each."""


class Grid(NamedTuple):
    """Points sorted into cubic cells: cell k holds ``order[start[k]:start[k + 1]]``, in ascending order. Compiled loops take it as it is.

    Cells stand in columns, one after the other, each from its lowest point to its highest: a cloud is a surface, and most cells of the box
    around it are empty.

    Attributes
    ----------
    start
        (cells + 1,) where each cell begins in ``order``.
    column, bottom
        (columns + 1,) which cell is the lowest of each column, and (columns,) the level of that cell; column ``i * size[1] + j`` is that of
        the cells i, j.
    order
        (n,) indices of the points.
    places
        (n, 3) the points themselves in that order, metres: loops over cells read them one after the other.
    origin
        (3,) lowest corner, metres.
    size
        (3,) number of cells along each axis of the box.
    cell
        Edge of a cell, metres.
    """

    start: NDArray[np.int32]
    column: NDArray[np.int32]
    bottom: NDArray[np.int32]
    order: IntArray
    places: FloatArray
    origin: FloatArray
    size: IntArray
    cell: float

    def within(self, middle: FloatArray, reach: float, active: NDArray[np.bool_] | None = None) -> IntArray:
        """Indices of the points within ``reach`` metres of ``middle`` (3,), of the active ones where that is given."""
        chosen = np.ones(len(self.order), dtype=np.bool_) if active is None else active
        x, y, z = np.asarray(middle, dtype=np.float64).tolist()
        return np.asarray(gather(chosen, (x, y, z), reach, self, len(self.order)))


def point_tree(points: FloatArray) -> cKDTree:
    """Tree of (n, 3) points, split in the middle of the longest edge and not at the median of the points.

    It is built in less than half the time, 0.2 s less a million points, and asked as fast where points cover a surface.
    """
    return cKDTree(points, balanced_tree=False, compact_nodes=False)


def neighbours_of_some(points: FloatArray, chosen: IntArray, count: int) -> tuple[FloatArray, IntArray]:
    """Distances, ascending, and indices, (k, count) each, of the nearest of (n, 3) points to some of them, ``chosen`` (k,) at random.

    The point itself is the first; n is at least ``count``. For a few thousand of a million points no tree is grown, which would take ten
    times as long: all points go once past those that are asked about. How far their neighbours lie is guessed from how far they lie
    apart, and where that was not far enough they go past once more.
    """
    places = points[chosen]
    if len(places) <= SPARSE_NEIGHBOURS or len(points) < FEWEST_A_PLACE * len(places):
        return _by_tree(points, places, count)
    apart = point_tree(places).query(places, k=[SPARSE_NEIGHBOURS + 1])[0][:, 0]
    low, high = corners(places[:, :2])
    least = max(0.1 * float(np.median(apart)), float((high - low).max()) / len(points))
    reach = GENEROUS * np.maximum(apart, least) * np.sqrt(count * len(places) / (SPARSE_NEIGHBOURS * len(points)))
    edge = float(np.median(reach))
    distance, index = np.full((len(places), count), np.inf), np.zeros((len(places), count), dtype=np.int64)
    left = np.arange(len(places))
    while len(left):
        cell = max(edge, float(np.median(reach[left])))
        if not cell or _squares(places[left], reach[left], cell) > MOST_SQUARES:
            # all in one place, or what lies together lies in a corner of the extent
            distance[left], index[left] = _by_tree(points, places[left], count)
            break
        near, which = np.full((len(left), count), np.inf), np.zeros((len(left), count), dtype=np.int64)
        _pass_by(points, places[left], reach[left], cell, near, which)
        distance[left], index[left] = np.sqrt(near), which
        left = left[distance[left, -1] > reach[left]]
        reach[left] *= 2
    return distance, index


def _squares(places: FloatArray, reach: FloatArray, cell: float) -> float:
    """Squares that :func:`_pass_by` holds, or places that they list where these are more."""
    low, high = (places[:, :2] - reach[:, None]).min(axis=0), (places[:, :2] + reach[:, None]).max(axis=0)
    return float(max(np.prod((high - low) / cell + 1), np.sum((2 * reach / cell + 2) ** 2)))


def _by_tree(points: FloatArray, places: FloatArray, count: int) -> tuple[FloatArray, IntArray]:
    distance, index = point_tree(points).query(places, k=[*range(1, count + 1)])
    return distance, index


@kernel(releases=True)
def _pass_by(points: Any, places: Any, reach: Any, cell: float, near: Any, which: Any) -> None:
    """Squared distances and indices of the nearest of (n, 3) points within ``reach`` (k,) of places (k, 3), into rows of ``near`` and
    ``which``, those beyond it perhaps; ``cell`` is the edge of squares in plan, metres, each of which lists the places that it may be near
    to."""
    low_x = low_y = np.inf
    high_x = high_y = -np.inf
    for i in range(len(places)):
        low_x, high_x = min(low_x, places[i, 0] - reach[i]), max(high_x, places[i, 0] + reach[i])
        low_y, high_y = min(low_y, places[i, 1] - reach[i]), max(high_y, places[i, 1] + reach[i])
    columns, rows = int((high_x - low_x) / cell) + 1, int((high_y - low_y) / cell) + 1
    start = np.zeros(columns * rows + 1, dtype=np.int64)
    listed = np.empty(0, dtype=np.int64)
    # counted first, then listed from the last place of each square down
    for turn in range(2):
        for i in range(len(places)):
            # rounding may lead past the last one
            first_a = min(int((places[i, 0] - reach[i] - low_x) / cell), columns - 1)
            first_b = min(int((places[i, 1] - reach[i] - low_y) / cell), rows - 1)
            last_a = min(int((places[i, 0] + reach[i] - low_x) / cell), columns - 1)
            last_b = min(int((places[i, 1] + reach[i] - low_y) / cell), rows - 1)
            for a in range(first_a, last_a + 1):
                for b in range(first_b, last_b + 1):
                    square = a * rows + b
                    if turn == 0:
                        start[square] += 1
                    else:
                        start[square] -= 1
                        listed[start[square]] = i
        if turn == 0:
            for square in range(columns * rows):
                start[square + 1] += start[square]
            listed = np.empty(start[columns * rows], dtype=np.int64)
    count = near.shape[1]
    for k in range(len(points)):
        x, y = points[k, 0], points[k, 1]
        if not (low_x <= x <= high_x and low_y <= y <= high_y):
            continue
        square = min(int((x - low_x) / cell), columns - 1) * rows + min(int((y - low_y) / cell), rows - 1)
        for m in range(start[square], start[square + 1]):
            i = listed[m]
            dx, dy, dz = x - places[i, 0], y - places[i, 1], points[k, 2] - places[i, 2]
            away = dx * dx + dy * dy + dz * dz
            if away < near[i, count - 1]:
                j = count - 1
                while j > 0 and near[i, j - 1] > away:
                    near[i, j], which[i, j] = near[i, j - 1], which[i, j - 1]
                    j -= 1
                near[i, j], which[i, j] = away, k


def build_grid(points: FloatArray, cell: float, most_cells: int = 20_000_000) -> Grid:
    """Grid of (n, 3) points; cells grow where the extent would need more than ``most_cells`` of them."""
    origin, high = corners(points)
    extent = high - origin
    while np.prod(np.floor(extent / cell) + 1) > most_cells:
        cell *= 1.5
    size = (np.floor(extent / cell) + 1).astype(np.int64)
    column, level = np.empty(len(points), dtype=np.int32), np.empty(len(points), dtype=np.int32)
    for first in range(0, len(points), AT_ONCE):
        part = slice(first, first + AT_ONCE)
        key = np.minimum(np.floor((points[part] - origin) / cell).astype(np.int64), size - 1)
        column[part], level[part] = key[:, 0] * size[1] + key[:, 1], key[:, 2]
    start, lowest, bottom, order = _sorted_into_cells(column, level, int(size[0] * size[1]))
    return Grid(start, lowest, bottom, order, points[order], origin, size, float(cell))


@kernel()
def _sorted_into_cells(column: Any, level: Any, columns: int) -> Any:
    """Where every cell begins in the order of the points, cells of columns, and that order, ascending within a cell: see :class:`Grid`."""
    bottom = np.full(columns, 2**31 - 1, dtype=np.int32)
    top = np.full(columns, -1, dtype=np.int32)
    for i in range(len(column)):
        bottom[column[i]] = min(bottom[column[i]], level[i])
        top[column[i]] = max(top[column[i]], level[i])
    lowest = np.zeros(columns + 1, dtype=np.int32)
    for k in range(columns):
        lowest[k + 1] = lowest[k] + (top[k] - bottom[k] + 1 if top[k] >= 0 else 0)
    cells = lowest[columns]
    start = np.zeros(cells + 1, dtype=np.int32)
    for i in range(len(column)):
        start[lowest[column[i]] + level[i] - bottom[column[i]] + 1] += 1
    for k in range(cells):
        start[k + 1] += start[k]
    order = np.empty(len(column), dtype=np.int64)
    for i in range(len(column)):
        k = lowest[column[i]] + level[i] - bottom[column[i]]
        order[start[k]] = i
        start[k] += 1
    # every cell now begins where it ends
    for k in range(cells, 0, -1):
        start[k] = start[k - 1]
    start[0] = 0
    return start, lowest, bottom, order


@kernel(makes_arrays=False)
def column_within(i: int, j: int, middle: Any, reach: float, grid: Any) -> Any:
    """From where to where, in the order of the cells, the points of those cells of column i, j lie that a ball meets.

    Cells of a column are stored one after the other. Half of the cells of the box around a ball lie outside it.
    """
    # rounding may put a point into the cell beside its own
    wide = reach * (1.0 + 1e-6)
    x, y = grid.origin[0] + i * grid.cell, grid.origin[1] + j * grid.cell
    beside_x = max(max(x - middle[0], middle[0] - x - grid.cell), 0.0)
    beside_y = max(max(y - middle[1], middle[1] - y - grid.cell), 0.0)
    rest = wide * wide - beside_x * beside_x - beside_y * beside_y
    if rest < 0.0:
        return 0, 0
    half = np.sqrt(rest)
    k = i * grid.size[1] + j
    row, bottom = int(grid.column[k]), int(grid.bottom[k])
    # within the column; the levels below and above it hold no points
    low = max(0, int(np.floor((middle[2] - half - grid.origin[2]) / grid.cell)) - bottom)
    high = min(int(grid.column[k + 1]) - row, int(np.floor((middle[2] + half - grid.origin[2]) / grid.cell)) - bottom + 1)
    if high <= low:
        return 0, 0
    return np.int64(grid.start[row + low]), np.int64(grid.start[row + high])


@kernel(makes_arrays=False)
def _rows_within(middle: float, reach: float, origin: float, cell: float, size: int) -> Any:
    """First and last cell along an axis that lie within ``reach`` of a coordinate."""
    return max(0, int(np.floor((middle - reach - origin) / cell))), min(size - 1, int(np.floor((middle + reach - origin) / cell)))


@kernel(makes_arrays=False)
def _columns_within(i: int, middle: Any, reach: float, grid: Any) -> Any:
    """First and last column of the row i that a ball meets; the last before the first where it meets none."""
    # rounding may put a point into the cell beside its own
    wide = reach * (1.0 + 1e-6)
    x = grid.origin[0] + i * grid.cell
    beside = max(max(x - middle[0], middle[0] - x - grid.cell), 0.0)
    if beside > wide:
        return 0, -1
    return _rows_within(middle[1], np.sqrt(wide * wide - beside * beside), grid.origin[1], grid.cell, grid.size[1])


@kernel(makes_arrays=False)
def _points_of_columns(i: int, left: int, right: int, grid: Any) -> Any:
    """From where to where, in the order of the cells, the points of columns i, left to i, right lie."""
    k = i * grid.size[1]
    return np.int64(grid.start[grid.column[k + left]]), np.int64(grid.start[grid.column[k + right + 1]])


@kernel()
def gather(active: Any, middle: Any, reach: float, grid: Any, most: Any) -> Any:
    """Indices of active points of a grid within ``reach`` of ``middle``; an even choice of ``most`` of them where there are more.

    Compiled loops give ``middle`` as a tuple and ``most`` as an ``np.int64``: this one would be compiled anew for each way an array can
    lie in memory, and for each constant.
    """
    order, places = grid.order, grid.places
    count = 0
    room = 256
    found = np.empty(room, dtype=np.int64)
    limit = reach * reach
    low, high = _rows_within(middle[0], reach, grid.origin[0], grid.cell, grid.size[0])
    for i in range(low, high + 1):
        left, right = _columns_within(i, middle, reach, grid)
        if right < left:
            continue
        # columns of a row are stored one after the other, too: to go past a few points above and below the ball takes less time than to
        # find where it begins and ends in each
        first, last = _points_of_columns(i, left, right, grid)
        step = right - left + 1 if last - first <= FEW_IN_COLUMN * (right - left + 1) else 1
        for j in range(left, right + 1, step):
            if step == 1:
                first, last = column_within(i, j, middle, reach, grid)
            if count + last - first > room:
                room = 2 * (count + last - first)
                wider = np.empty(room, dtype=np.int64)
                for m in range(count):
                    wider[m] = found[m]
                found = wider
            # every point is written down, and written over where it does not count: branches would take longer
            for k in range(first, last):
                x, y, z = places[k, 0] - middle[0], places[k, 1] - middle[1], places[k, 2] - middle[2]
                found[count] = order[k]
                count += 1 if (x * x + y * y + z * z <= limit) & active[order[k]] else 0
    if count <= most:
        return found[:count]
    chosen = np.empty(most, dtype=np.int64)
    for k in range(most):
        chosen[k] = found[int(k * count / most)]
    return chosen
