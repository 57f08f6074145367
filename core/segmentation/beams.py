"""Beams that pass through legs: of the solids of units, frusta about their legs' axes, which is hit over what length."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..common.kernels import kernel

BLOCK, BANDS = 16, 10
"""Places, one beside the other, that the beams of a point are asked about together, and bands of heights in which they are put in order."""


@kernel(makes_arrays=False)
def _within(axial: float, lean: float, along: float, square: float, ends: Any, cone: Any) -> Any:
    """Where along a beam from a point it comes into a frustum about an axis, and where it leaves; the one is not before the other where it
    misses. No branches: loops around it run in vector registers.

    The point lies ``axial`` along the axis and ``along`` the beam from the centre, the square of its distance from there is ``square``, and
    ``lean`` the cosine between beam and axis. ``ends`` are along the axis, ``cone`` the radius at the centre and its decrease.
    """
    (first, last), (radius, gradient) = ends, cone
    # |x|^2 - axial^2 <= (radius - gradient axial)^2 along the beam
    thick = radius - gradient * axial
    a = 1.0 - lean * lean * (1.0 + gradient * gradient)
    b = along - axial * lean + thick * gradient * lean
    c = square - axial * axial - thick * thick
    root = b * b - a * c
    width = np.sqrt(max(root, 0.0))
    per = 1.0 / (a if abs(a) >= 1e-9 else 1.0)
    one, two = min((-b - width) * per, (-b + width) * per), max((-b - width) * per, (-b + width) * per)
    # nearly along the axis, a < 0: inside the cone before its apex
    low = one if a > 0.0 else (-1e300 if lean > 0.0 else two)
    high = two if a > 0.0 else (one if lean > 0.0 else 1e300)
    # across the axis: within both ends all along, or nowhere
    steps = 1.0 / (lean if abs(lean) > 1e-9 else 1e-300)
    start, end = (first - axial) * steps, (last - axial) * steps
    low, high = max(max(low, min(start, end)), 0.0), min(high, max(start, end))
    return low, high if (root > 0.0) & (abs(a) >= 1e-9) else low


@kernel()
def passing_beams(
    points: Any, stands: Any, drifts: Any, axis: Any, first: float, last: float, radius: float, gradient: float, chord: float, most: int
) -> Any:
    """(m,) beams of points towards each stand that pass through a leg of the unit in the middle, up to ``most``, and (m, most) where along
    the leg."""
    counts, places = np.zeros(len(stands), dtype=np.int64), np.empty((len(stands), most))
    middle, wide = 0.5 * (first + last), radius - gradient * first
    round_end = wide * wide + 0.25 * (last - first) ** 2
    for k in range(len(stands)):
        for i in range(len(points)):
            on = points[i, 0] * drifts[k, 0] + points[i, 1] * drifts[k, 1] + points[i, 2] * drifts[k, 2]
            bx, by = stands[k, 0] + on * drifts[k, 0] - points[i, 0], stands[k, 1] + on * drifts[k, 1] - points[i, 1]
            bz = stands[k, 2] + on * drifts[k, 2] - points[i, 2]
            mx, my, mz = middle * axis[0] - points[i, 0], middle * axis[1] - points[i, 1], middle * axis[2] - points[i, 2]
            square = bx * bx + by * by + bz * bz
            along, apart = mx * bx + my * by + mz * bz, mx * mx + my * my + mz * mz
            # the end lies in a ball that most beams miss
            if apart > round_end and (along < 0.0 or apart * square - along * along > round_end * square):
                continue
            length = np.sqrt(square)
            px, py, pz = points[i, 0], points[i, 1], points[i, 2]
            axial = px * axis[0] + py * axis[1] + pz * axis[2]
            lean = (bx * axis[0] + by * axis[1] + bz * axis[2]) / length
            towards = (px * bx + py * by + pz * bz) / length
            low, high = _within(axial, lean, towards, px * px + py * py + pz * pz, (first, last), (radius, gradient))
            if high - low > chord:
                places[k, counts[k]] = min(axial + lean * low, axial + lean * high)
                counts[k] += 1
                if counts[k] >= most:
                    break
    return counts, places


@kernel()
def entering_beams(
    points: Any,
    stands: Any,
    drifts: Any,
    centres: Any,
    axes: Any,
    lasts: Any,
    reach: float,
    radius: float,
    gradient: float,
    chord: float,
    most: int,
) -> Any:
    """(m,) how many beams of points towards a stand enter the legs of units about (k, 3) centres; one more than ``most`` where more do.

    One stand is enough: those after the first from which no more than ``most`` enter are not asked, and count as others.
    """
    units = len(centres)
    result = np.full(len(stands), most + 1)
    # beams that entered from the last place are asked first: most places are left after a few
    order = np.arange(len(points))
    by_axis, frusta = centres.T.copy(), np.empty((4, 4 * units))
    for u in range(units):
        for leg in range(4):
            for a in range(3):
                frusta[a, 4 * u + leg] = axes[u, leg, a]
            frusta[3, 4 * u + leg] = lasts[u, leg]
    # of a point from a centre, square of the distance beyond the reach: the same from all places
    beyond = np.empty((len(points), units))
    for i in range(len(points)):
        for u in range(units):
            px, py, pz = points[i, 0] - by_axis[0, u], points[i, 1] - by_axis[1, u], points[i, 2] - by_axis[2, u]
            beyond[i, u] = px * px + py * py + pz * pz - reach * reach
    inwards, near = np.empty(units), np.empty(units + 1, dtype=np.int64)
    asked = np.zeros((7, 4 * units + 4))
    for k in range(len(stands)):
        entered = 0
        for place in range(len(points)):
            i = order[place]
            x, y, z = points[i, 0], points[i, 1], points[i, 2]
            on = x * drifts[k, 0] + y * drifts[k, 1] + z * drifts[k, 2]
            bx, by, bz = stands[k, 0] + on * drifts[k, 0] - x, stands[k, 1] + on * drifts[k, 1] - y, stands[k, 2] + on * drifts[k, 2] - z
            length = np.sqrt(bx * bx + by * by + bz * bz)
            bx, by, bz = bx / length, by / length, bz / length
            # without branches, in vector registers: whether the beam passes through the sphere around a unit
            for u in range(units):
                along = max((by_axis[0, u] - x) * bx + (by_axis[1, u] - y) * by + (by_axis[2, u] - z) * bz, 0.0)
                inwards[u] = along * along - beyond[i, u]
            count = 0
            for u in range(units):
                near[count] = u
                count += 1 if inwards[u] >= 0.0 else 0
            if count == 0:
                continue
            for m in range(count):
                u = near[m]
                for leg in range(4):
                    for a in range(4):
                        asked[a, 4 * m + leg] = frusta[a, 4 * u + leg]
                    asked[4, 4 * m + leg] = x - by_axis[0, u]
                    asked[5, 4 * m + leg] = y - by_axis[1, u]
                    asked[6, 4 * m + leg] = z - by_axis[2, u]
            if count % 2 == 1:
                # legs go by eight: four of no length
                for leg in range(4):
                    asked[3, 4 * count + leg] = 0.0
            if _legs_entered(asked, (count + 1) // 2, (bx, by, bz), radius, gradient, chord) > 0.0:
                order[place], order[entered] = order[entered], order[place]
                entered += 1
                if entered > most:
                    break
        result[k] = entered
        if entered <= most:
            break
    return result


@kernel(makes_arrays=False)
def _legs_entered(legs: Any, eights: int, beam: Any, radius: float, gradient: float, chord: float) -> float:
    """How many of so many times eight legs a beam runs within for more than ``chord``, as :func:`_within` tells.

    Columns of ``legs`` (7, n) are the direction of a leg, where it ends along it, and from where the beam comes, relative to the unit's
    centre. No branches, and a number of passes that fills vector registers.
    """
    bx, by, bz = beam
    entered = 0.0
    for k in range(8 * eights):
        ax, ay, az = legs[0, k], legs[1, k], legs[2, k]
        px, py, pz = legs[4, k], legs[5, k], legs[6, k]
        axial = px * ax + py * ay + pz * az
        lean = bx * ax + by * ay + bz * az
        along, square = px * bx + py * by + pz * bz, px * px + py * py + pz * pz
        low, high = _within(axial, lean, along, square, (0.0, legs[3, k]), (radius, gradient))
        entered += 1.0 if high - low > chord else 0.0
    return entered


def entering_beams_by_block(
    points: FloatArray,
    stands: FloatArray,
    drifts: FloatArray,
    centres: FloatArray,
    axes: FloatArray,
    lasts: FloatArray,
    reach: float,
    radius: float,
    gradient: float,
    chord: float,
    most: int,
) -> IntArray:
    """As :func:`entering_beams` of all stands, none of them the origin, in about half the time."""
    order = _by_direction(stands)
    counts = np.empty(len(stands), dtype=np.int64)
    counts[order] = _entered(points, (stands[order], drifts[order]), (centres, axes, lasts), reach, (radius, gradient, chord), most, BLOCK)
    return counts


def _by_direction(places: FloatArray) -> IntArray:
    """Order of (n, 3) places in which those that follow one another lie in nearly the same direction from the origin."""
    away = np.linalg.norm(places, axis=1)
    band = np.floor((places[:, 2] / away + 1) * BANDS / 2)
    turn = np.arctan2(places[:, 1], places[:, 0])
    return np.lexsort((away, np.where(band % 2 == 0, turn, -turn), band))


@kernel()
def _entered(points: Any, places: Any, legs: Any, reach: float, cone: Any, most: int, wide: int) -> Any:
    """As :func:`entering_beams_by_block`, for stands that follow one another in nearly the same direction: of a point the beams towards
    ``wide`` of them are held against one leg after the other, in vector registers, and most legs are missed by all."""
    (stands, drifts), (centres, axes, lasts) = places, legs
    result, order = np.empty(len(stands), dtype=np.int64), np.arange(len(points))
    towards, beams, along = np.empty((6, wide)), np.empty((3, wide)), np.empty(wide)
    counts, inside = np.empty(wide), np.empty(wide)
    for begin in range(0, len(stands), wide):
        for s in range(wide):
            for a in range(3):
                towards[a, s] = stands[min(begin + s, len(stands) - 1), a]
                towards[3 + a, s] = drifts[min(begin + s, len(stands) - 1), a]
            counts[s] = 0.0
        # beams that entered from places before are asked first: most places are left after a few
        front = 0
        for place in range(len(points)):
            i = order[place]
            x, y, z = points[i, 0], points[i, 1], points[i, 2]
            for s in range(wide):
                on = x * towards[3, s] + y * towards[4, s] + z * towards[5, s]
                bx, by = towards[0, s] + on * towards[3, s] - x, towards[1, s] + on * towards[4, s] - y
                bz = towards[2, s] + on * towards[5, s] - z
                per = 1.0 / np.sqrt(bx * bx + by * by + bz * bz)
                beams[0, s], beams[1, s], beams[2, s] = bx * per, by * per, bz * per
                inside[s] = 0.0
            for u in range(len(centres)):
                px, py, pz = x - centres[u, 0], y - centres[u, 1], z - centres[u, 2]
                square, near = px * px + py * py + pz * pz, 0.0
                for s in range(wide):
                    along[s] = px * beams[0, s] + py * beams[1, s] + pz * beams[2, s]
                    inwards = min(along[s], 0.0)
                    near += 1.0 if inwards * inwards >= square - reach * reach else 0.0
                if near == 0.0:
                    continue
                for leg in range(4):
                    axis = axes[u, leg, 0], axes[u, leg, 1], axes[u, leg, 2]
                    axial = px * axis[0] + py * axis[1] + pz * axis[2]
                    _enter_leg(beams, along, inside, axis, (axial, square, lasts[u, leg]), cone)
            some = left = 0.0
            for s in range(wide):
                entered = 1.0 if inside[s] > 0.0 else 0.0
                counts[s] += entered
                some += entered
                left += 1.0 if counts[s] <= most else 0.0
            if some > 0.0:
                order[place], order[front] = order[front], order[place]
                front += 1
                if left == 0.0:
                    break
        for s in range(min(wide, len(stands) - begin)):
            result[begin + s] = min(int(counts[s]), most + 1)
    return result


@kernel(makes_arrays=False)
def _enter_leg(beams: Any, along: Any, inside: Any, axis: Any, place: Any, cone: Any) -> None:
    """Add 1 to ``inside`` (w,) for each of the ``beams`` (3, w) from a point that runs within a leg for more than its chord.

    ``place`` holds the point's coordinate along the ``axis``, the square of its distance from the centre and where the leg ends, ``cone``
    radius, gradient and chord; ``along`` (w,) are its coordinates along the beams.
    """
    (ax, ay, az), (axial, square, last), (radius, gradient, chord) = axis, place, cone
    middle, near = 0.5 * last, 0.0
    # of the point from a ball that holds the leg
    beyond = square - 2.0 * axial * middle - radius * radius
    for s in range(len(inside)):
        inwards = max(middle * (beams[0, s] * ax + beams[1, s] * ay + beams[2, s] * az) - along[s], 0.0)
        near += 1.0 if inwards * inwards >= beyond else 0.0
    if near == 0.0:
        return
    for s in range(len(inside)):
        lean = beams[0, s] * ax + beams[1, s] * ay + beams[2, s] * az
        low, high = _within(axial, lean, along[s], square, (0.0, last), (radius, gradient))
        inside[s] += 1.0 if high - low > chord else 0.0
