"""Legs to whole units: common centre and leg angles, refinement of the pose, and what the points say about it (paper 2.1).

A pose is held as 12 numbers here, centre (3) and rotation body -> frame (9, by rows), because that is what compiled loops like.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import prange
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from .conic_ransac import LEAST_AGREEMENT, Legs
from .gauss_helmert import EDGE_RATIO, TIP_RATIO
from .kernels import kernel
from .neighbourhood import Grid, gather
from .surface_elements import BEND_RADIUS_RATIO, LEAST_RADIUS_RATIO
from .unit_types import UnitType

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

AZIMUTH_CELLS, AXIAL_CELLS = 8, 4
CELLS_PER_LEG = AZIMUTH_CELLS * AXIAL_CELLS + 1
NUMBER_OF_CELLS = 4 * CELLS_PER_LEG
ABOUT_AS_GOOD = 0.9
"""Share of the best twist's support at which another twist about a leg stands as well."""
SUPPORT, CLOSE, INSIDE, CELLS, LEGS, RMS, REACHED = range(7)
"""Columns of the evidence table of :func:`evidence`."""


def poses_from_pairs(legs: Legs, unit: UnitType) -> FloatArray:
    """Whole-unit poses from pairs of legs that meet at the unit's leg angle: (k, 12)."""
    height = unit.height
    if len(legs.axis) < 2:
        return np.zeros((0, 12))
    pairs = cKDTree(legs.centre).query_pairs(0.45 * height, output_type="ndarray")
    i, j = pairs[:, 0], pairs[:, 1]
    a, b = legs.axis[i], legs.axis[j]
    cosine = np.einsum("ij,ij->i", a, b)
    opening = float(unit.leg_directions[0] @ unit.leg_directions[1])
    fits = np.abs(np.arccos(np.clip(cosine, -1, 1)) - np.arccos(opening)) < np.radians(16)
    i, j, a, b, cosine = i[fits], j[fits], a[fits], b[fits], cosine[fits]
    gap = legs.centre[j] - legs.centre[i]
    # nearest approach of the two lines, each point held back by how far its own leg can shift along its axis
    s = (np.einsum("ij,ij->i", gap, a) - np.einsum("ij,ij->i", gap, b) * cosine) / (1 - cosine**2)
    t = (np.einsum("ij,ij->i", gap, a) * cosine - np.einsum("ij,ij->i", gap, b)) / (1 - cosine**2)
    first, second = legs.centre[i] + s[:, None] * a, legs.centre[j] + t[:, None] * b
    miss = np.linalg.norm(first - second, axis=1)
    reach_i = 4 * legs.centre_sd[i] + 0.1 * height
    reach_j = 4 * legs.centre_sd[j] + 0.1 * height
    fits = (miss < 0.12 * height) & (np.abs(s) < reach_i) & (np.abs(t) < reach_j)
    centre = (0.5 * (first + second))[fits]
    return np.column_stack([centre, _rotation_of_legs(a[fits], b[fits], unit)])


def _rotation_of_legs(a: FloatArray, b: FloatArray, unit: UnitType) -> FloatArray:
    """(k, 9) rotations that bring legs 1 and 2 of the body closest to the directions a and b."""
    total, across = a + b, np.cross(a, b)
    total /= np.linalg.norm(total, axis=1, keepdims=True)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    frame = np.stack([total, across, np.cross(total, across)], axis=2)
    d1, d2 = unit.leg_directions[0], unit.leg_directions[1]
    bisector, normal = d1 + d2, np.cross(d1, d2)
    bisector, normal = bisector / np.linalg.norm(bisector), normal / np.linalg.norm(normal)
    body = np.column_stack([bisector, normal, np.cross(bisector, normal)])
    return np.asarray((frame @ body.T).reshape(len(a), 9))


def poses_from_single_legs(
    legs: Legs, points: FloatArray, active: NDArray[np.bool_], grid: Grid, unit: UnitType, tolerance: float, *, twists: int = 2
) -> FloatArray:
    """Poses about each leg, searched over the shift along its axis and the twist about it: (n, 12).

    The best two, and with ``twists`` 5 three more where they are about as good as the best: which of them has room is seen later.
    """
    if not len(legs.axis):
        return np.zeros((0, 12))
    reach = np.clip(2.5 * legs.centre_sd, 0.06 * unit.height, 0.24 * unit.height)
    poses = np.asarray(_twist_search(
        legs.axis, legs.centre, reach, points, active, grid.start, grid.order, grid.origin, grid.size, grid.cell,
        unit.leg_directions, unit.radius, unit.gradient, unit.leg_length, unit.height, tolerance, twists,
    ))  # fmt: skip
    return np.asarray(poses[poses[:, 3:].any(axis=1)])


def refine(
    poses: FloatArray, points: FloatArray, normals: FloatArray, active: NDArray[np.bool_], grid: Grid, unit: UnitType,
    tolerance: float, *, most: int = 500, sweeps: int = 12,
) -> FloatArray:  # fmt: skip
    """Robust least squares of each (12,) pose to the active points around it, tolerance narrowing from 4 to 1.5 times."""
    out = poses.copy()
    shape: tuple[Any, ...] = (unit.leg_directions, unit.radius, unit.gradient, unit.leg_length, unit.height, tolerance)
    cells: tuple[Any, ...] = (grid.start, grid.order, grid.origin, grid.size, grid.cell)
    arguments: tuple[Any, ...] = (points, normals, active, *cells, *shape, most, sweeps)
    if len(out) > 4:
        _refine_many(out, *arguments)
    else:
        for pose in out:
            _refine_one(pose, *arguments)
    return out


def evidence(
    poses: FloatArray, points: FloatArray, normals: FloatArray, curved: NDArray[np.int8], active: NDArray[np.bool_], grid: Grid,
    unit: UnitType, tolerance: float, noise: float,
) -> FloatArray:  # fmt: skip
    """What the points say about each pose: (k, 7) with columns SUPPORT, CLOSE, INSIDE, CELLS, LEGS, RMS, REACHED.

    SUPPORT counts active points on the surface whose normal agrees, CLOSE all active points on the surface but those on rounded tips
    and fillets whose normal does not agree, INSIDE points
    (active or not) deep within the solid but for the outer part of one leg, which may be broken off, CELLS the surface cells
    (of 132) holding support, LEGS legs with at least two such cells, RMS the misfit of the support in metres, REACHED the active
    points near the unit. ``noise`` of a point, metres, tells how far tips and fillets can be seen at all.
    """
    # what is rounded shows in the normals where the noise is well below the least of it
    seen = min(max(1.5 - 4.5 * noise / (EDGE_RATIO * unit.height), 0.0), 1.0)
    shape: tuple[Any, ...] = (unit.leg_directions, unit.radius, unit.gradient, unit.leg_length, unit.height, tolerance, seen)
    cells: tuple[Any, ...] = (grid.start, grid.order, grid.origin, grid.size, grid.cell)
    if len(poses) > 4:
        return np.asarray(_evidence_of_many(poses, points, normals, curved, active, *cells, *shape))
    table = np.zeros((len(poses), 7))
    for pose, row in zip(poses, table, strict=True):
        _evidence_of_one(row, pose, points, normals, curved, active, *cells, *shape)
    return table


@kernel()
def _relate(x: Any, y: Any, z: Any, legs: Any, radius: float, gradient: float, length: float) -> Any:
    """Leg, signed distance, part (0 lateral, 1 end disc), axial coordinate and distance from the axis, in the body frame."""
    leg = 0
    axial = -1e300
    for k in range(4):
        lean = x * legs[k, 0] + y * legs[k, 1] + z * legs[k, 2]
        if lean > axial:
            axial = lean
            leg = k
    rho = np.sqrt(max(x * x + y * y + z * z - axial * axial, 0.0))
    lateral = (rho - radius + gradient * axial) / np.sqrt(1.0 + gradient * gradient)
    end = axial - length
    edge = radius - gradient * length
    if end > 0.0 and rho > edge:
        return leg, np.sqrt(end * end + (rho - edge) ** 2), 2, axial, rho
    if end > lateral:
        return leg, end, 1, axial, rho
    return leg, lateral, 0, axial, rho


@kernel()
def _farther(x: float, y: float, z: float, legs: Any, radius: float, gradient: float, length: float, limit: float) -> bool:
    """Whether a point of the body frame surely lies farther than ``limit`` outside: a quick look before :func:`_relate`."""
    axial = max(
        max(x * legs[0, 0] + y * legs[0, 1] + z * legs[0, 2], x * legs[1, 0] + y * legs[1, 1] + z * legs[1, 2]),
        max(x * legs[2, 0] + y * legs[2, 1] + z * legs[2, 2], x * legs[3, 0] + y * legs[3, 1] + z * legs[3, 2]),
    )
    widest = radius - gradient * axial + limit * np.sqrt(1.0 + gradient * gradient)
    return bool(axial > length + limit or x * x + y * y + z * z - axial * axial > widest * widest)


@kernel()
def _normal_at(
    x: float, y: float, z: float, leg: int, part: int, axial: float, rho: float, legs: Any, gradient: float, cosine: float
) -> Any:  # fmt: skip
    """Outward normal of the lateral surface (part 0) or end disc (1) of a leg, body frame."""
    ax, ay, az = legs[leg, 0], legs[leg, 1], legs[leg, 2]
    if part == 1:
        return ax, ay, az
    along = gradient - axial / rho
    return (x / rho + along * ax) * cosine, (y / rho + along * ay) * cosine, (z / rho + along * az) * cosine


@kernel()
def _twist_support(local: Any, turned: Any, shift: float, radius: float, gradient: float, length: float, tolerance: float) -> float:
    """Elements on the surface less those inside the solid; ``local`` (3, m) about a leg, ``turned`` (4, 3) the legs in that frame."""
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    edge = radius - gradient * length
    a0, a1, a2 = turned[0, 0], turned[0, 1], turned[0, 2]
    b0, b1, b2 = turned[1, 0], turned[1, 1], turned[1, 2]
    c0, c1, c2 = turned[2, 0], turned[2, 1], turned[2, 2]
    d0, d1, d2 = turned[3, 0], turned[3, 1], turned[3, 2]
    total = 0.0
    # no branches: the loop runs in vector registers
    for q in range(local.shape[1]):
        x, y, z = local[0, q], local[1, q], local[2, q] - shift
        axial = max(max(x * a0 + y * a1 + z * a2, x * b0 + y * b1 + z * b2), max(x * c0 + y * c1 + z * c2, x * d0 + y * d1 + z * d2))
        rho = np.sqrt(max(x * x + y * y + z * z - axial * axial, 0.0))
        distance = max((rho - radius + gradient * axial) * cosine, axial - length)
        beside = (axial > length) & (rho > edge)
        total += 1.0 if (distance < 2.0 * tolerance) & (not beside) else 0.0
        total -= 2.0 if distance < -2.5 * tolerance else 0.0
    return total


@kernel()
def _crease_distance(x: float, y: float, z: float, leg: int, axial: float, legs: Any) -> float:
    """Distance of a point of the body frame from the nearest plane in which its leg meets another."""
    nearest = np.inf
    for k in range(4):
        if k != leg:
            between = 2.0 - 2.0 * (legs[leg, 0] * legs[k, 0] + legs[leg, 1] * legs[k, 1] + legs[leg, 2] * legs[k, 2])
            nearest = min(nearest, (axial - x * legs[k, 0] - y * legs[k, 1] - z * legs[k, 2]) / np.sqrt(between))
    return nearest


@kernel(parallel=True)
def _twist_search(
    axes: Any, centres: Any, reaches: Any, points: Any, active: Any, start: Any, order: Any, origin: Any, size: Any, cell: float,
    legs: Any, radius: float, gradient: float, length: float, height: float, tolerance: float, most: int,
) -> Any:  # fmt: skip
    n = len(axes)
    out = np.zeros((most * n, 12))
    twists = 16
    for i in prange(n):
        near = gather(points, active, centres[i], 0.85 * height, start, order, origin, size, cell, 260)
        m = len(near)
        axis = axes[i]
        help_axis = np.zeros(3)
        help_axis[0 if abs(axis[0]) < 0.8 else 1] = 1.0
        e1 = np.cross(axis, help_axis)
        e1 /= np.sqrt(np.sum(e1 * e1))
        e2 = np.cross(axis, e1)
        local = np.empty((3, m))
        for q in range(m):
            d0 = points[near[q], 0] - centres[i, 0]
            d1 = points[near[q], 1] - centres[i, 1]
            d2 = points[near[q], 2] - centres[i, 2]
            local[0, q] = d0 * e1[0] + d1 * e1[1] + d2 * e1[2]
            local[1, q] = d0 * e2[0] + d1 * e2[1] + d2 * e2[2]
            local[2, q] = d0 * axis[0] + d1 * axis[1] + d2 * axis[2]
        steps = max(1, int(np.ceil(reaches[i] / (0.035 * height))))
        best = np.full(2, -1e300)
        best_z = np.zeros(most)
        best_t = np.zeros(most)
        of_twist = np.full(twists, -1e300)
        shift_of_twist = np.zeros(twists)
        turned = np.empty((4, 3))
        for t in range(twists):
            angle = t * (2.0 * np.pi / 3.0) / twists
            ca = np.cos(angle)
            sa = np.sin(angle)
            for k in range(4):
                turned[k, 0], turned[k, 1], turned[k, 2] = ca * legs[k, 0] - sa * legs[k, 1], sa * legs[k, 0] + ca * legs[k, 1], legs[k, 2]
            for k in range(-steps, steps + 1):
                shift = k * reaches[i] / steps
                total = _twist_support(local, turned, shift, radius, gradient, length, tolerance)
                if total > of_twist[t]:
                    of_twist[t], shift_of_twist[t] = total, shift
                far = 1.0
                if best[0] > -1e299:
                    turn = abs(angle - best_t[0])
                    turn = min(turn, 2.0 * np.pi / 3.0 - turn)
                    if turn < 0.35 and abs(shift - best_z[0]) < 0.12 * height:
                        far = 0.0
                if total > best[0]:
                    if far > 0.0:
                        best[1], best_z[1], best_t[1] = best[0], best_z[0], best_t[0]
                    best[0], best_z[0], best_t[0] = total, shift, angle
                elif total > best[1] and far > 0.0:
                    best[1], best_z[1], best_t[1] = total, shift, angle
        first = int(np.argmax(of_twist))
        for w in range(2, most):
            t = (first + (w - 1) * twists // 4) % twists
            best_t[w] = t * (2.0 * np.pi / 3.0) / twists
            # a twist that is worse is left as zeros
            best_z[w] = shift_of_twist[t] if of_twist[t] >= ABOUT_AS_GOOD * best[0] else np.inf
        for w in range(most):
            if best_z[w] == np.inf:
                continue
            ca = np.cos(best_t[w])
            sa = np.sin(best_t[w])
            for a in range(3):
                out[most * i + w, a] = centres[i, a] + best_z[w] * axis[a]
                out[most * i + w, 3 + 3 * a] = ca * e1[a] + sa * e2[a]
                out[most * i + w, 4 + 3 * a] = -sa * e1[a] + ca * e2[a]
                out[most * i + w, 5 + 3 * a] = axis[a]
    return out


@kernel(parallel=True)
def _refine_many(
    poses: Any, points: Any, normals: Any, active: Any, start: Any, order: Any, origin: Any, size: Any, cell: float,
    legs: Any, radius: float, gradient: float, length: float, height: float, tolerance: float, most: int, sweeps: int,
) -> None:  # fmt: skip
    for i in prange(len(poses)):
        _refine_one(
            poses[i], points, normals, active, start, order, origin, size, cell,
            legs, radius, gradient, length, height, tolerance, most, sweeps,
        )  # fmt: skip


@kernel()
def _refine_one(
    pose: Any, points: Any, normals: Any, active: Any, start: Any, order: Any, origin: Any, size: Any, cell: float,
    legs: Any, radius: float, gradient: float, length: float, height: float, tolerance: float, most: int, sweeps: int,
) -> None:  # fmt: skip
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    near = gather(points, active, pose[0:3], 0.8 * height, start, order, origin, size, cell, most)
    m = len(near)
    local = np.empty((m, 6))
    for q in range(m):
        for a in range(3):
            local[q, a] = points[near[q], a] - pose[a]
            local[q, 3 + a] = normals[near[q], a]
    centre = np.zeros(3)
    rot = pose[3:12].copy().reshape(3, 3)
    normal = np.empty((6, 6))
    right = np.empty(6)
    row = np.empty(6)
    for sweep in range(sweeps):
        limit = tolerance * max(1.5, 4.0 - 0.5 * sweep)
        normal[:, :] = 0.0
        right[:] = 0.0
        r00, r01, r02 = rot[0, 0], rot[0, 1], rot[0, 2]
        r10, r11, r12 = rot[1, 0], rot[1, 1], rot[1, 2]
        r20, r21, r22 = rot[2, 0], rot[2, 1], rot[2, 2]
        for q in range(m):
            d0, d1, d2 = local[q, 0] - centre[0], local[q, 1] - centre[1], local[q, 2] - centre[2]
            x = d0 * r00 + d1 * r10 + d2 * r20
            y = d0 * r01 + d1 * r11 + d2 * r21
            z = d0 * r02 + d1 * r12 + d2 * r22
            if _farther(x, y, z, legs, radius, gradient, length, limit):
                continue
            leg, dist, part, axial, rho = _relate(x, y, z, legs, radius, gradient, length)
            if part == 2 or abs(dist) > limit or rho < 1e-9:
                continue
            nx, ny, nz = _normal_at(x, y, z, leg, part, axial, rho, legs, gradient, cosine)
            gx = r00 * nx + r01 * ny + r02 * nz
            gy = r10 * nx + r11 * ny + r12 * nz
            gz = r20 * nx + r21 * ny + r22 * nz
            if abs(gx * local[q, 3] + gy * local[q, 4] + gz * local[q, 5]) < 0.75:
                continue
            w = (1.0 - (dist / limit) ** 2) ** 2
            # moving the unit by dX changes the distance by -n.dX; turning it by dw by -(d x n).dw
            row[0], row[1], row[2] = -gx, -gy, -gz
            row[3] = -(d1 * gz - d2 * gy) / height
            row[4] = -(d2 * gx - d0 * gz) / height
            row[5] = -(d0 * gy - d1 * gx) / height
            for a in range(6):
                weighted = w * row[a]
                right[a] -= weighted * dist
                for b in range(a + 1):
                    normal[a, b] += weighted * row[b]
        for a in range(6):
            for b in range(a):
                normal[b, a] = normal[a, b]
        weight = normal[0, 0] + normal[1, 1] + normal[2, 2]
        if weight < 5.0:
            break
        for a in range(6):
            normal[a, a] += 2e-3 * weight / 3.0
        step = np.linalg.solve(normal, right)
        for a in range(3):
            centre[a] += min(max(step[a], -0.06 * height), 0.06 * height)
        w0 = min(max(step[3] / height, -0.12), 0.12)
        w1 = min(max(step[4] / height, -0.12), 0.12)
        w2 = min(max(step[5] / height, -0.12), 0.12)
        angle = np.sqrt(w0 * w0 + w1 * w1 + w2 * w2)
        if angle > 1e-12:
            k0, k1, k2 = w0 / angle, w1 / angle, w2 / angle
            sa = np.sin(angle)
            ca = 1.0 - np.cos(angle)
            turn = np.empty((3, 3))
            turn[0, 0] = 1 - ca * (k1 * k1 + k2 * k2)
            turn[0, 1] = -sa * k2 + ca * k0 * k1
            turn[0, 2] = sa * k1 + ca * k0 * k2
            turn[1, 0] = sa * k2 + ca * k0 * k1
            turn[1, 1] = 1 - ca * (k0 * k0 + k2 * k2)
            turn[1, 2] = -sa * k0 + ca * k1 * k2
            turn[2, 0] = -sa * k1 + ca * k0 * k2
            turn[2, 1] = sa * k0 + ca * k1 * k2
            turn[2, 2] = 1 - ca * (k0 * k0 + k1 * k1)
            rot = turn @ rot
        if sweep > 5 and angle < 1e-4 and abs(step[0]) + abs(step[1]) + abs(step[2]) < 1e-4 * height:
            break
    for a in range(3):
        pose[a] += centre[a]
        for b in range(3):
            pose[3 + 3 * a + b] = rot[a, b]


@kernel(parallel=True)
def _evidence_of_many(
    poses: Any, points: Any, normals: Any, curved: Any, active: Any, start: Any, order: Any, origin: Any, size: Any, cell: float,
    legs: Any, radius: float, gradient: float, length: float, height: float, tolerance: float, seen: float,
) -> Any:  # fmt: skip
    out = np.zeros((len(poses), 7))
    for i in prange(len(poses)):
        _evidence_of_one(
            out[i], poses[i], points, normals, curved, active, start, order, origin, size, cell,
            legs, radius, gradient, length, height, tolerance, seen,
        )  # fmt: skip
    return out


@kernel()
def _evidence_of_one(
    out: Any, pose: Any, points: Any, normals: Any, curved: Any, active: Any, start: Any, order: Any, origin: Any, size: Any,
    cell: float, legs: Any, radius: float, gradient: float, length: float, height: float, tolerance: float, seen: float,
) -> None:  # fmt: skip
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    low = 0.2 * height
    reach = 0.75 * height
    first = np.empty((4, 3))
    second = np.empty((4, 3))
    for k in range(4):
        help_axis = np.zeros(3)
        help_axis[2 if abs(legs[k, 2]) < 0.9 else 0] = 1.0
        e1 = np.cross(help_axis, legs[k])
        first[k] = e1 / np.sqrt(np.sum(e1 * e1))
        second[k] = np.cross(legs[k], first[k])
    lo = np.empty(3, dtype=np.int64)
    hi = np.empty(3, dtype=np.int64)
    for a in range(3):
        lo[a] = max(0, int(np.floor((pose[a] - reach - origin[a]) / cell)))
        hi[a] = min(size[a] - 1, int(np.floor((pose[a] + reach - origin[a]) / cell)))
    if hi[2] < lo[2]:
        return
    cells = np.zeros(132, dtype=np.int64)
    outer = 0.6 * length
    # the nearest neighbours of an element this close to a crease lie on two legs
    blurred = seen * LEAST_RADIUS_RATIO * height
    rounded = (1.0 - seen * (1.0 - TIP_RATIO)) * length
    # where two legs meet they are concave: so far from there the sense of curvature tells nothing
    half = np.sqrt(0.5 + 0.5 * (legs[0, 0] * legs[1, 0] + legs[0, 1] * legs[1, 1] + legs[0, 2] * legs[1, 2]))
    concave = radius * half / (np.sqrt(1.0 - half * half) + gradient * half) + (BEND_RADIUS_RATIO + EDGE_RATIO) * height
    outer_inside = np.zeros(4)
    squares = 0.0
    for gi in range(lo[0], hi[0] + 1):
        for gj in range(lo[1], hi[1] + 1):
            column = (gi * size[1] + gj) * size[2]
            for at in range(start[column + lo[2]], start[column + hi[2] + 1]):
                q = order[at]
                d0 = points[q, 0] - pose[0]
                d1 = points[q, 1] - pose[1]
                d2 = points[q, 2] - pose[2]
                if d0 * d0 + d1 * d1 + d2 * d2 > reach * reach:
                    continue
                x = d0 * pose[3] + d1 * pose[6] + d2 * pose[9]
                y = d0 * pose[4] + d1 * pose[7] + d2 * pose[10]
                z = d0 * pose[5] + d1 * pose[8] + d2 * pose[11]
                if _farther(x, y, z, legs, radius, gradient, length, 6.0 * tolerance):
                    continue
                leg, dist, part, axial, rho = _relate(x, y, z, legs, radius, gradient, length)
                if dist < -max(3.0 * tolerance, 0.03 * height):
                    if axial > outer:
                        outer_inside[leg] += 1
                    else:
                        out[2] += 1
                    continue
                if not active[q]:
                    continue
                if dist < 6.0 * tolerance:
                    out[6] += 1
                if part == 2 or abs(dist) > 2.0 * tolerance or rho < 1e-9:
                    continue
                out[1] += 1
                nx, ny, nz = _normal_at(x, y, z, leg, part, axial, rho, legs, gradient, cosine)
                agree = nx * (pose[3] * normals[q, 0] + pose[6] * normals[q, 1] + pose[9] * normals[q, 2])
                agree += ny * (pose[4] * normals[q, 0] + pose[7] * normals[q, 1] + pose[10] * normals[q, 2])
                agree += nz * (pose[5] * normals[q, 0] + pose[8] * normals[q, 1] + pose[11] * normals[q, 2])
                unsigned = curved[q] <= 0 or axial < concave
                flat = curved[q] < 0 and part == 0 and axial > concave
                if flat or not (agree > LEAST_AGREEMENT or (unsigned and agree < -LEAST_AGREEMENT)):
                    # rounded tips and the fillets of creases are no cone: what disagrees there says nothing
                    if axial > rounded or _crease_distance(x, y, z, leg, axial, legs) < blurred:
                        out[1] -= 1
                        out[6] -= 1
                    continue
                out[0] += 1
                squares += dist * dist
                if part == 1:
                    cells[33 * leg + 32] += 1
                else:
                    across1 = x * first[leg, 0] + y * first[leg, 1] + z * first[leg, 2]
                    across2 = x * second[leg, 0] + y * second[leg, 1] + z * second[leg, 2]
                    azimuth = int((np.arctan2(across2, across1) + np.pi) / (2.0 * np.pi) * 7.99999)
                    ring = int(max(0.0, min(0.99999, (axial - low) / (length - low))) * 4.0)
                    cells[33 * leg + 4 * azimuth + ring] += 1
    # one broken leg end lets the sensor see into the nominal solid: the worst leg's outer part is forgiven
    out[2] += outer_inside.sum() - outer_inside.max()
    for k in range(4):
        own = 0
        for c in range(33):
            if cells[33 * k + c] >= 2:
                own += 1
        out[3] += own
        if own >= 2:
            out[4] += 1
    if out[0] > 0:
        out[5] = np.sqrt(squares / out[0])
