"""The centreline of what lies along a structure, from which its chainage is counted where nobody gave an axis.

A straight structure has a straight one: the longest direction of its places. Where the structure turns, at a corner, around a harbour or
a head, places at the same distance along a straight line lie on several arms. So ground is taken in cells, cells near each other are
joined, and the longest of the shortest ways through them (Dijkstra, 1959, Numerische Mathematik 1) leads along the structure. Local lines
through the cells beside it, by chainage, draw it into their middle, as principal curves are found (Hastie and Stuetzle, 1989, Journal of
the American Statistical Association 84(406)). What lies far beside it is another arm: a spur, the other half of a ring, or what stands
apart. Arms follow each other end to end by the shortest gaps, so that none is met across a basin.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import connected_components, dijkstra
from scipy.spatial import cKDTree

from .arrays import FloatArray, IntArray
from .axis import Axis, straight_axis, upwards

ARM_HEIGHTS = 6.0
"""Reach in heights of a unit: slopes on both sides of a crest are one structure, and arms of the smallest harbours are not."""
CELL_SHARE, BIN_SHARE = 1 / 3, 0.5
"""Size of the cells, and distance of the corners of the centreline, over the reach."""
SHORTEST_ARM = 2.0
"""Length over width from which something is an arm."""
WIDTH_OF_MEDIAN = 4.0
"""Width of a strip over the median distance of its places from its middle."""
ROUNDS = 4
"""Times that the centreline is drawn into the middle of the cells: it moves by less than a tenth of its cells then."""
KERNEL_SDS = 3


def centreline(places: FloatArray, reach: float) -> Axis:
    """The centreline of (k, >= 2) places: straight where it leaves a straight line by less than the structure's width.

    Parameters
    ----------
    places
        Easting and northing of units or of cells of ground, metres.
    reach
        Places nearer to each other than this are of one arm, and no structure is told to be narrower, metres.
    """
    straight = straight_axis(places)
    if len(places) < 3 or float(np.ptp(straight.locate(places)[1])) <= reach:
        return straight
    cells = _cells(places[:, :2], CELL_SHARE * reach)
    arms, width = _arms(cells, reach)
    if not arms or float(np.max(np.abs(straight.locate(np.vstack(arms))[1]))) <= width:
        return straight
    return _to_the_ends(_chained(arms), places)


def _cells(places: FloatArray, size: float) -> FloatArray:
    """(c, 2) mean places of the cells of a grid of ``size`` metres, so that dense ground weighs no more than other."""
    key = np.floor((places - places.min(axis=0)) / size).astype(np.int64)
    _, cell, counts = np.unique(key, axis=0, return_inverse=True, return_counts=True)
    cell = cell.ravel()
    return np.column_stack([np.bincount(cell, weights=places[:, axis]) for axis in range(2)]) / counts[:, None]


def _arms(cells: FloatArray, reach: float) -> tuple[list[FloatArray], float]:
    """Centrelines (n, 2) of the arms, and the width of the widest, metres; what is too short for an arm has none."""
    graph = _joined(cells, reach)
    arms: list[FloatArray] = []
    left, widest = np.arange(len(cells)), reach
    while len(left):
        near = graph[left][:, left]
        parts = connected_components(near, directed=False)[1]
        order = np.argsort(parts, kind="stable")
        beside: list[IntArray] = [np.zeros(0, dtype=np.int64)]
        for members in np.split(order, np.flatnonzero(np.diff(parts[order])) + 1):
            way = _longest_way(near[members][:, members])
            arm, width = _in_the_middle(cells[left[members]], way, reach)
            if arm is not None:
                arms.append(arm)
                widest = max(widest, width)
                beside.append(left[np.delete(members, way)])
        left = np.sort(np.concatenate(beside))
        for arm in arms:
            left = left[np.abs(Axis(arm).locate(cells[left])[1]) > widest]
    return arms, widest


def _joined(cells: FloatArray, reach: float) -> csr_array:
    """(c, c) distances of the cells within reach of each other."""
    pairs = cKDTree(cells).query_pairs(reach, output_type="ndarray")
    both = np.vstack([pairs, pairs[:, ::-1]])
    distances = np.linalg.norm(cells[both[:, 0]] - cells[both[:, 1]], axis=1)
    return csr_array(coo_array((distances, (both[:, 0], both[:, 1])), shape=(len(cells), len(cells))))


def _longest_way(graph: csr_array) -> IntArray:
    """Numbers of the cells on the shortest way between two that are farthest apart along the ground."""
    begin = int(np.argmax(dijkstra(graph, indices=0)))
    distances, before = dijkstra(graph, indices=begin, return_predecessors=True)
    way = [int(np.argmax(distances))]
    while way[-1] != begin:
        way.append(int(before[way[-1]]))
    return np.array(way, dtype=np.int64)


def _in_the_middle(cells: FloatArray, way: IntArray, reach: float) -> tuple[FloatArray | None, float]:
    """Line (n, 2) along a way through the middle of the cells beside it, None where it is too short for an arm; width of these, metres."""
    line, width = cells[way], reach
    for _ in range(ROUNDS):
        if len(line) < 2:
            return None, width
        axis = Axis(line)
        along, offset = axis.locate(cells)
        width = max(WIDTH_OF_MEDIAN * float(np.median(np.abs(offset))), reach)
        if float(axis.lengths.sum()) < SHORTEST_ARM * width:
            return None, width
        beside = np.abs(offset) <= width
        line = _local_lines(along[beside], cells[beside], BIN_SHARE * reach, width / 2)
    return line, width


def _local_lines(along: FloatArray, places: FloatArray, step: float, sd: float) -> FloatArray:
    """(n, 2) places about every ``step`` metres on lines fitted locally to (k, 2) places by chainage, weighted by a normal kernel."""
    low, extent = float(along.min()), max(float(np.ptp(along)), 1e-9)
    count = max(2, round(extent / step) + 1)
    number = np.round((along - low) / extent * (count - 1)).astype(np.int64)
    reach = min(count - 1, int(np.ceil(KERNEL_SDS * sd * (count - 1) / extent)))
    lag = np.arange(-reach, reach + 1.0)
    kernel = np.exp(-0.5 * (lag * extent / (count - 1) / sd) ** 2)
    sums = [np.bincount(number, weights=values, minlength=count) for values in (np.ones(len(along)), *places.T)]
    # moments about every corner, by the number of steps from it
    (zeroth, first, second), *moments = [[np.convolve(own, kernel * lag**k)[reach : reach + count] for k in range(3)] for own in sums]
    determinant = zeroth * second - first**2
    sloped = determinant > 1e-6 * zeroth**2
    divisor = np.where(sloped, determinant, zeroth)
    line = np.column_stack([np.where(sloped, second * mean - first * slope, mean) / divisor for mean, slope, _ in moments])
    return np.asarray(line[np.append(True, np.linalg.norm(np.diff(line, axis=0), axis=1) > 0)])


def _to_the_ends(axis: Axis, places: FloatArray) -> Axis:
    """The axis from the first of (k, >= 2) places, whose chainage is zero, to the last."""
    along, length = axis.locate(places)[0], float(axis.lengths.sum())
    corners = axis.corners.copy()
    for end, beside, beyond in ((0, 1, -float(along.min())), (-1, -2, float(along.max()) - length)):
        way = corners[end] - corners[beside]
        corners[end] += max(beyond, 0.0) * way / np.linalg.norm(way)
    return Axis(corners, axis.gaps)


def _chained(arms: Sequence[FloatArray]) -> Axis:
    """Arms (n, 2) one after the other: those whose ends are nearest to each other are joined first."""
    ends = np.array([(arm[0], arm[-1]) for arm in arms]).reshape(-1, 2)
    first, second = np.triu_indices(len(ends), 1)
    nearest = np.argsort(np.linalg.norm(ends[first] - ends[second], axis=1), kind="stable")
    chains = [[arm] for arm in arms]
    of_end = np.repeat(np.arange(len(arms)), 2)
    free = np.ones(len(ends), dtype=bool)
    for a, b in zip(first[nearest], second[nearest], strict=True):
        one, other = of_end[a], of_end[b]
        if one == other or not (free[a] and free[b]):
            continue
        free[a] = free[b] = False
        before = chains[one] if np.array_equal(chains[one][-1][-1], ends[a]) else [arm[::-1] for arm in reversed(chains[one])]
        after = chains[other] if np.array_equal(chains[other][0][0], ends[b]) else [arm[::-1] for arm in reversed(chains[other])]
        chains[one] = before + after
        of_end[of_end == other] = one
    chain = chains[of_end[0]]
    way = chain[-1][-1] - chain[0][0]
    if np.any(upwards(way) != way):
        chain = [arm[::-1] for arm in reversed(chain)]
    gaps = np.cumsum([len(arm) for arm in chain])[:-1] - 1
    return Axis(np.vstack(chain), tuple(gaps.tolist()))
