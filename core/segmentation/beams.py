"""Beams that pass through legs: of the solids of units, frusta about their legs' axes, which is hit over what length."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..common.kernels import kernel


@kernel()
def _inside(point: Any, beam: Any, axis: Any, first: float, last: float, radius: float, gradient: float) -> Any:
    """Length of a beam from a point inside a frustum about an axis, and the place along the axis of the part nearest to the centre."""
    px, py, pz = point
    bx, by, bz = beam
    axial = px * axis[0] + py * axis[1] + pz * axis[2]
    lean = bx * axis[0] + by * axis[1] + bz * axis[2]
    # |x|^2 - axial^2 <= (radius - gradient axial)^2 along the beam
    thick = radius - gradient * axial
    a = 1.0 - lean * lean * (1.0 + gradient * gradient)
    b = px * bx + py * by + pz * bz - axial * lean + thick * gradient * lean
    c = px * px + py * py + pz * pz - axial * axial - thick * thick
    root = b * b - a * c
    if root <= 0.0 or abs(a) < 1e-9:
        return 0.0, 0.0
    root = np.sqrt(root)
    low, high = (-b - root) / a, (-b + root) / a
    if a < 0.0:
        # nearly along the axis: inside the cone before its apex
        one, two = min(low, high), max(low, high)
        low, high = (-1e300, one) if lean > 0.0 else (two, 1e300)
    if abs(lean) > 1e-9:
        one, two = (first - axial) / lean, (last - axial) / lean
        low, high = max(low, min(one, two)), min(high, max(one, two))
    elif axial < first or axial > last:
        return 0.0, 0.0
    low = max(low, 0.0)
    if high <= low:
        return 0.0, 0.0
    return high - low, min(axial + lean * low, axial + lean * high)


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
            point, beam = (points[i, 0], points[i, 1], points[i, 2]), (bx / length, by / length, bz / length)
            inside, place = _inside(point, beam, axis, first, last, radius, gradient)
            if inside > chord:
                places[k, counts[k]] = place
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
    one: bool,
) -> Any:
    """(m,) how many beams of points towards a stand enter the legs of units about (k, 3) centres; one more than ``most`` where more do.

    Where ``one`` stand is enough, those after the first from which no more than ``most`` enter are not asked, and count as others.
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
        if one and entered <= most:
            break
    return result


@kernel(makes_arrays=False)
def _legs_entered(legs: Any, eights: int, beam: Any, radius: float, gradient: float, chord: float) -> float:
    """How many of so many times eight legs a beam runs within for more than ``chord``, as :func:`_inside` tells.

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
        thick = radius - gradient * axial
        a = 1.0 - lean * lean * (1.0 + gradient * gradient)
        b = px * bx + py * by + pz * bz - axial * lean + thick * gradient * lean
        c = px * px + py * py + pz * pz - axial * axial - thick * thick
        root = b * b - a * c
        width = np.sqrt(max(root, 0.0))
        per = 1.0 / (a if abs(a) >= 1e-9 else 1.0)
        one, two = min((-b - width) * per, (-b + width) * per), max((-b - width) * per, (-b + width) * per)
        # nearly along the axis, a < 0: inside the cone before its apex
        low = one if a > 0.0 else (-1e300 if lean > 0.0 else two)
        high = two if a > 0.0 else (one if lean > 0.0 else 1e300)
        # across the axis: within both ends all along, or nowhere
        steps = 1.0 / (lean if abs(lean) > 1e-9 else 1e-300)
        start, end = -axial * steps, (legs[3, k] - axial) * steps
        low, high = max(max(low, min(start, end)), 0.0), min(high, max(start, end))
        entered += 1.0 if (root > 0.0) & (abs(a) >= 1e-9) & (high - low > chord) else 0.0
    return entered
