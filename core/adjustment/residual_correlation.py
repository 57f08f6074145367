"""Correlation between the residuals of neighbouring points, and what it adds to the covariance of an adjustment.

Surface roughness and what is left of strip errors are alike in points that lie together, so that many points say less than as many
independent ones.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.kernels import kernel
from .adjustment_records import PARAMETERS

LEAST_POINTS = 80
"""Used points from which correlation is looked for."""
CORRELATION_SAMPLE = 2500
"""Points among which the correlation of residuals is looked for; all pairs are formed."""
PAIR_SAMPLES = (500, 2000)
"""Points whose near pairs make the covariance, first to see whether correlation matters, then, if it does, for good: with 500 the sum
over pairs is itself so uncertain that 95 % regions hold 92 %."""
EXPECTED_SAMPLE = 64
"""Points whose pairs show what the fit makes of white noise."""
_CELLS = 12
"""Cells along each axis into which points are sorted to find near ones."""
LAGS = 0.005 * np.array([0, 2, 4, 6, 9, 13, 18, 24])
"""Edges of the distance classes for that, as shares of the height."""
_CORRELATION_LENGTHS = np.tile(np.geomspace(0.01, 0.12, 10), 2)
_CORRELATION_EXPONENTS = np.repeat([1.0, 2.0], 10)
_USUAL_CORRELATION = 15
"""Forms of the covariance function that are tried, lengths as shares of the height; and the one taken where none stands out."""
LAG_MIDDLES = 0.5 * (LAGS[1:] + LAGS[:-1])
_FORMS = np.exp(-((LAG_MIDDLES / _CORRELATION_LENGTHS[:, None]) ** _CORRELATION_EXPONENTS[:, None]))
"""Value of each form in each distance class."""


@kernel()
def _in_cells(points: Any, chosen: Any, size: Any) -> Any:
    """The chosen numbers of body-frame points in the order of cubic cells of the given size, and where each cell starts.

    Whatever is far out shares the outer cells.
    """
    n = len(chosen)
    cell = np.zeros(n, dtype=np.int64)
    starts = np.zeros(_CELLS**3 + 1, dtype=np.int64)
    for i in range(n):
        for d in range(3):
            place = int(min(max(points[chosen[i], d] / size + _CELLS // 2, 0.0), _CELLS - 1.0))
            cell[i] = cell[i] * _CELLS + place
        starts[cell[i] + 1] += 1
    for k in range(_CELLS**3):
        starts[k + 1] += starts[k]
    order = np.empty(n, dtype=np.int64)
    filled = starts.copy()
    for i in range(n):
        order[filled[cell[i]]] = chosen[i]
        filled[cell[i]] += 1
    return order, starts


@kernel()
def _near_ranges(starts: Any) -> Any:
    """(m, 4) ranges first, last, low, high such that every pair i < j of points in the same or touching cells, once, has i in the former
    and j in the latter."""
    ranges = np.empty((5 * _CELLS**3, 4), dtype=np.int64)
    count = 0
    for x in range(_CELLS):
        for y in range(_CELLS):
            for z in range(_CELLS):
                cell = (x * _CELLS + y) * _CELLS + z
                if starts[cell] == starts[cell + 1]:
                    continue
                for ox in range(x, min(x + 2, _CELLS)):
                    for oy in range(max(y - 1, 0) if ox > x else y, min(y + 2, _CELLS)):
                        # cells of one column follow one another, so that their points form one range
                        column = (ox * _CELLS + oy) * _CELLS
                        low = cell if ox == x and oy == y else column + max(z - 1, 0)
                        ranges[count, 0], ranges[count, 1] = starts[cell], starts[cell + 1]
                        ranges[count, 2], ranges[count, 3] = starts[low], starts[column + min(z + 2, _CELLS)]
                        count += 1
    return ranges[:count]


@kernel()
def _near(points: Any, i: Any, low: Any, high: Any, reach: Any, near: Any, squares: Any) -> Any:
    """Points low..high nearer than ``reach`` (squared) to point i into ``near`` and ``squares``; returns their number.

    Without a branch, since no processor can foresee which points are near.
    """
    count = 0
    x, y, z = points[i, 0], points[i, 1], points[i, 2]
    for j in range(max(low, i + 1), high):
        dx, dy, dz = x - points[j, 0], y - points[j, 1], z - points[j, 2]
        square = dx * dx + dy * dy + dz * dz
        near[count] = j
        squares[count] = square
        count += square < reach
    return count


@kernel()
def _add_below(squares: Any, products: Any, count: Any, edges: Any, sums: Any, counts: Any) -> None:
    """Add, for each of seven edges, the products whose squared distance lies below it to ``sums``, and how many they are to ``counts``.

    Comparing with every edge runs in vector registers, looking up the class of each pair does not.
    """
    e0, e1, e2, e3, e4, e5, e6 = edges[0], edges[1], edges[2], edges[3], edges[4], edges[5], edges[6]
    s0 = s1 = s2 = s3 = s4 = s5 = s6 = 0.0
    for h in range(count):
        square, product = squares[h], products[h]
        s0 += product if square < e0 else 0.0
        s1 += product if square < e1 else 0.0
        s2 += product if square < e2 else 0.0
        s3 += product if square < e3 else 0.0
        s4 += product if square < e4 else 0.0
        s5 += product if square < e5 else 0.0
        s6 += product if square < e6 else 0.0
    c0 = c1 = c2 = c3 = c4 = c5 = c6 = 0.0
    for h in range(count):
        square = squares[h]
        c0 += 1.0 if square < e0 else 0.0
        c1 += 1.0 if square < e1 else 0.0
        c2 += 1.0 if square < e2 else 0.0
        c3 += 1.0 if square < e3 else 0.0
        c4 += 1.0 if square < e4 else 0.0
        c5 += 1.0 if square < e5 else 0.0
        c6 += 1.0 if square < e6 else 0.0
    for k, (total, number) in enumerate(((s0, c0), (s1, c1), (s2, c2), (s3, c3), (s4, c4), (s5, c5), (s6, c6))):
        sums[k] += total
        counts[k] += number


@kernel()
def lag_products(points: Any, values: Any, whitened: Any, chosen: Any, height: Any, sums: Any, expected: Any, counts: Any) -> None:
    """Products of residuals over all pairs of points by class of distance, and what the fit makes of white noise there."""
    reach = LAGS[-1] * height
    edges = (LAGS[1:] * height) ** 2
    order, starts = _in_cells(points, chosen, reach)
    n = len(order)
    x, y, z, value = np.empty(n), np.empty(n), np.empty(n), np.empty(n)
    for i in range(n):
        x[i], y[i], z[i], value[i] = points[order[i], 0], points[order[i], 1], points[order[i], 2], values[order[i]]
    # a cell's points and those after them in the cells around it
    around_x, around_y, around_z, around_value = np.empty(n), np.empty(n), np.empty(n), np.empty(n)
    number = np.empty(n, dtype=np.int64)
    squares, products, hats = np.empty(4 * n), np.empty(4 * n), np.empty(n)
    # what the fit makes of white noise is smooth in the distance: the pairs of some points are enough
    stride = max(1, n // EXPECTED_SAMPLE)
    unused = np.zeros(len(edges))
    ranges = _near_ranges(starts)
    taken = filled = 0
    while taken < len(ranges):
        first, last = ranges[taken, 0], ranges[taken, 1]
        m = 0
        while taken < len(ranges) and ranges[taken, 0] == first:
            low, high = ranges[taken, 2], ranges[taken, 3]
            for j in range(low, high):
                h = m + j - low
                around_x[h], around_y[h], around_z[h], around_value[h], number[h] = x[j], y[j], z[j], value[j], order[j]
            m += high - low
            taken += 1
        for i in range(first, last):
            start = i - first + 1
            count = m - start
            if filled + count > len(squares):
                _add_below(squares, products, filled, edges, sums, counts)
                filled = 0
            xi, yi, zi, vi = x[i], y[i], z[i], value[i]
            xs, ys, zs, vs = around_x[start:m], around_y[start:m], around_z[start:m], around_value[start:m]
            own_squares, own_products = squares[filled : filled + count], products[filled : filled + count]
            for h in range(count):
                dx, dy, dz = xi - xs[h], yi - ys[h], zi - zs[h]
                own_squares[h] = dx * dx + dy * dy + dz * dz
                own_products[h] = vi * vs[h]
            filled += count
            if i % stride == 0:
                for h in range(count):
                    hat = 0.0
                    for k in range(whitened.shape[1]):
                        hat += whitened[order[i], k] * whitened[number[start + h], k]
                    hats[h] = -stride * hat
                _add_below(own_squares, hats, count, edges, expected, unused)
    _add_below(squares, products, filled, edges, sums, counts)
    for k in range(len(edges) - 1, 0, -1):
        sums[k] -= sums[k - 1]
        expected[k] -= expected[k - 1]
        counts[k] -= counts[k - 1]


@kernel()
def pair_products(points: Any, rows: Any, chosen: Any, length: Any, exponent: Any, reach: Any) -> Any:
    """(12, 12) sum over pairs i != j of exp(-(distance / length)^exponent) times the outer product of their rows."""
    order, starts = _in_cells(points, chosen, reach)
    points, rows = points[order], rows[order]
    near, squares = np.empty(len(points) + 1, dtype=np.int64), np.empty(len(points) + 1)
    mixed = np.zeros(rows.shape)
    for first, last, low, high in _near_ranges(starts):
        for i in range(first, last):
            for h in range(_near(points, i, low, high, reach * reach, near, squares)):
                t = squares[h] / (length * length)
                correlation = math.exp(-t if exponent == 2.0 else -math.sqrt(t))
                for a in range(12):
                    mixed[i, a] += correlation * rows[near[h], a]
    once = rows.T @ mixed
    return once + once.T


def correlated_part(
    *,
    feet: FloatArray,
    rows: FloatArray,
    whitened: FloatArray,
    scores: FloatArray,
    weights: FloatArray,
    height: float,
    white: FloatArray,
    plain: FloatArray,
    psi: float,
) -> FloatArray:
    """(12, 12) what the correlation between residuals of neighbouring points adds to the expected outer product of the scores.

    A covariance function s exp(-(h / l)^p), p = 1 or 2, is fitted to the products of residuals by distance; the form that stands
    out most is taken.

    Parameters
    ----------
    feet
        (n, 3) adjusted observations, metres in the body frame: distances between noisy points would depend on the residuals.
    rows, whitened
        (n, 12) derivatives of the conditions of points that belong to one part, and these times the root of ``white``.
    scores, weights
        (n,) standardised residuals times weights, and the weights, 0..1.
    height
        Of the unit, metres.
    white, plain
        (12, 12) inverse of the scores' derivative, and outer products of ``rows``.
    psi
        Mean square of the scores.
    """
    used = np.flatnonzero(weights > 0.05)
    nothing = np.zeros((12, 12))
    if len(used) < LEAST_POINTS or psi <= 0:
        return nothing
    # in one piece, or the loop would be compiled for steps as well
    chosen = np.ascontiguousarray(used[:: math.ceil(len(used) / CORRELATION_SAMPLE)])
    thinning = len(used) / len(chosen)
    u = scores / math.sqrt(float(np.mean(np.square(scores[chosen]))))
    sums, expected, counts = (np.zeros(len(LAGS) - 1) for _ in range(3))
    lag_products(feet, u, whitened, chosen, height, sums, expected, counts)
    if not counts.any():
        return nothing
    information = _FORMS**2 @ counts
    correlated, inflation = nothing, 1.0
    for most in PAIR_SAMPLES:
        # the fit takes a little of every pair's product away, the more the fewer independent points there are
        strengths = _FORMS @ (sums - inflation * expected) / information
        deviations = strengths * np.sqrt(information)
        best = int(np.argmax(deviations))
        if deviations[best] < 2.5:
            # what is too weak to show its form is taken at the length of a mould's roughness, less what chance alone gives
            best = _USUAL_CORRELATION
            strengths[best] -= 0.3 / math.sqrt(float(information[best]))
        strength = min(float(strengths[best]), 1.0)
        if strength <= 0:
            return nothing
        length, exponent = float(_CORRELATION_LENGTHS[best]) * height, float(_CORRELATION_EXPONENTS[best])
        few = np.ascontiguousarray(chosen[:: math.ceil(len(chosen) / most)])
        pairs = pair_products(feet, rows, few, length, exponent, length * (4.0 if exponent == 1 else 2.2))
        correlated = strength * (len(used) / len(few)) ** 2 * pairs
        inflation = 1 + max(float(np.trace(white @ correlated)), 0.0) / max(float(np.trace(white @ plain)), 1.0)
        if inflation < 1.2:
            break
        # the covariance function itself is known from so many independent patches only (mean of an inverted Wishart distribution)
        neighbours = 2 * float(counts[height * LAG_MIDDLES < length].sum()) / len(chosen) * thinning
        patches = max(len(used) / (1 + neighbours), 2.0 * (len(PARAMETERS) + 1))
        correlated *= patches / (patches - len(PARAMETERS) - 1)
    return np.asarray(psi * correlated)
