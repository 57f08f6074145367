"""Robust least squares of the poses of whole units to the elements around them (paper 2.1)."""

from __future__ import annotations

from functools import partial
from typing import Any, NamedTuple

import numpy as np

from ..common.arrays import BoolArray, FloatArray
from ..common.kernels import in_parts, kernel
from ..common.neighbourhood import gather
from ..common.positive_definite import factorise, solve_factorised
from .cone_relation import FEW_POSES, ConeShape
from .scene import Scene

BROAD = 0.8
"""Distance from the centre, as a share of the height, within which elements take part: a unit's reach is 0.66 of it."""

LEAST_AGREEMENT_OF_FIT = 0.75
"""Cosine between an element's normal and the surface's from which it draws a pose towards itself, whatever the sign."""


class _Effort(NamedTuple):
    """Elements that a fit uses, and its steps."""

    most: int
    sweeps: int


def refine(poses: FloatArray, scene: Scene, active: BoolArray, *, most: int = 500, sweeps: int = 12) -> FloatArray:
    """Robust least squares of each (12,) pose to the active points around it, tolerance narrowing from 4 to 1.5 times."""
    out = poses.copy()
    shape, elements, effort = ConeShape.of(scene.unit), scene.elements, _Effort(most, sweeps)
    if len(out) > FEW_POSES:
        passes = partial(
            _refine_many,
            poses=out,
            elements=elements,
            active=active,
            grid=scene.grid,
            shape=shape,
            tolerance=scene.tolerance,
            effort=effort,
        )
        in_parts(passes, len(out))
    else:
        for pose in out:
            _refine_one(pose, elements, active, scene.grid, shape, scene.tolerance, effort)
    return out


@kernel(releases=True)
def _refine_many(
    first: int, last: int, poses: Any, elements: Any, active: Any, grid: Any, shape: Any, tolerance: float, effort: Any
) -> None:
    for i in range(first, last):
        _refine_one(poses[i], elements, active, grid, shape, tolerance, effort)


@kernel()
def _refine_one(pose: Any, elements: Any, active: Any, grid: Any, shape: Any, tolerance: float, effort: Any) -> None:
    """Least squares of one pose, in place."""
    points, normals = elements.points, elements.normals
    height = shape.height
    most, sweeps = effort
    near = gather(active, (pose[0], pose[1], pose[2]), BROAD * height, grid, most)
    m = len(near)
    local = np.empty((6, m))
    for q in range(m):
        for a in range(3):
            local[a, q] = points[near[q], a] - pose[a]
            local[3 + a, q] = normals[near[q], a]
    centre = np.zeros(3)
    rot, turn = np.empty((3, 3)), np.empty((3, 3))
    for a in range(3):
        for b in range(3):
            rot[a, b] = pose[3 + 3 * a + b]
    normal = np.empty((6, 6))
    step = np.empty(6)
    for sweep in range(sweeps):
        _sum_up(local, centre, rot, shape, tolerance * max(1.5, 4.0 - 0.5 * sweep), normal, step)
        weight = normal[0, 0] + normal[1, 1] + normal[2, 2]
        if weight < 5.0:
            break
        for a in range(6):
            normal[a, a] += 2e-3 * weight / 3.0
        factorise(normal)
        solve_factorised(normal, step)
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
            turn[0, 0] = 1 - ca * (k1 * k1 + k2 * k2)
            turn[0, 1] = -sa * k2 + ca * k0 * k1
            turn[0, 2] = sa * k1 + ca * k0 * k2
            turn[1, 0] = sa * k2 + ca * k0 * k1
            turn[1, 1] = 1 - ca * (k0 * k0 + k2 * k2)
            turn[1, 2] = -sa * k0 + ca * k1 * k2
            turn[2, 0] = -sa * k1 + ca * k0 * k2
            turn[2, 1] = sa * k0 + ca * k1 * k2
            turn[2, 2] = 1 - ca * (k0 * k0 + k1 * k1)
            for b in range(3):
                r0, r1, r2 = rot[0, b], rot[1, b], rot[2, b]
                for a in range(3):
                    rot[a, b] = turn[a, 0] * r0 + turn[a, 1] * r1 + turn[a, 2] * r2
        if sweep > 5 and angle < 1e-4 and abs(step[0]) + abs(step[1]) + abs(step[2]) < 1e-4 * height:
            break
    for a in range(3):
        pose[a] += centre[a]
        for b in range(3):
            pose[3 + 3 * a + b] = rot[a, b]


@kernel(makes_arrays=False)
def _sum_up(local: Any, centre: Any, rot: Any, shape: Any, limit: float, normal: Any, right: Any) -> None:
    """Normal equations, lower triangle and right-hand side, of the elements within ``limit`` of a pose's surface whose normals agree.

    Columns of ``local`` are positions and normals; turns are in heights.
    """
    legs, radius, gradient, length, height = shape
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    edge = radius - gradient * length
    p0, p1, p2 = centre[0], centre[1], centre[2]
    r00, r01, r02 = rot[0, 0], rot[0, 1], rot[0, 2]
    r10, r11, r12 = rot[1, 0], rot[1, 1], rot[1, 2]
    r20, r21, r22 = rot[2, 0], rot[2, 1], rot[2, 2]
    ax, ay, az = legs[0, 0], legs[0, 1], legs[0, 2]
    bx, by, bz = legs[1, 0], legs[1, 1], legs[1, 2]
    cx, cy, cz = legs[2, 0], legs[2, 1], legs[2, 2]
    dx, dy, dz = legs[3, 0], legs[3, 1], legs[3, 2]
    n00 = n10 = n11 = n20 = n21 = n22 = n30 = n31 = n32 = n33 = 0.0
    n40 = n41 = n42 = n43 = n44 = n50 = n51 = n52 = n53 = n54 = n55 = 0.0
    s0 = s1 = s2 = s3 = s4 = s5 = 0.0
    # weights of 0 and choices in place of branches: the loop runs in vector registers
    for q in range(local.shape[1]):
        d0, d1, d2 = local[0, q] - p0, local[1, q] - p1, local[2, q] - p2
        x = d0 * r00 + d1 * r10 + d2 * r20
        y = d0 * r01 + d1 * r11 + d2 * r21
        z = d0 * r02 + d1 * r12 + d2 * r22
        lean_a, lean_b = x * ax + y * ay + z * az, x * bx + y * by + z * bz
        lean_c, lean_d = x * cx + y * cy + z * cz, x * dx + y * dy + z * dz
        first, second = max(lean_a, lean_b), max(lean_c, lean_d)
        axial = max(first, second)
        on_b, on_d, on_second = lean_b > lean_a, lean_d > lean_c, second > first
        ux, vx = bx if on_b else ax, dx if on_d else cx
        uy, vy = by if on_b else ay, dy if on_d else cy
        uz, vz = bz if on_b else az, dz if on_d else cz
        ux, uy, uz = vx if on_second else ux, vy if on_second else uy, vz if on_second else uz
        rho = np.sqrt(max(x * x + y * y + z * z - axial * axial, 1e-18))
        lateral, end = (rho - radius + gradient * axial) * cosine, axial - length
        disc = end > lateral
        dist = max(end, lateral)
        rim = (end > 0.0) & (rho > edge)
        # of the cone, or of its end disc
        out, along = 0.0 if disc else cosine / rho, 1.0 if disc else (gradient - axial / rho) * cosine
        nx, ny, nz = x * out + ux * along, y * out + uy * along, z * out + uz * along
        gx = r00 * nx + r01 * ny + r02 * nz
        gy = r10 * nx + r11 * ny + r12 * nz
        gz = r20 * nx + r21 * ny + r22 * nz
        agree = abs(gx * local[3, q] + gy * local[4, q] + gz * local[5, q])
        near = 1.0 - (dist / limit) ** 2
        w = near * near if (near >= 0.0) & (agree >= LEAST_AGREEMENT_OF_FIT) & ~rim else 0.0
        # moving the unit by dX changes the distance by -n.dX; turning it by dw by -(d x n).dw
        tx, ty, tz = (d1 * gz - d2 * gy) / height, (d2 * gx - d0 * gz) / height, (d0 * gy - d1 * gx) / height
        wx, wy, wz, ox, oy, oz = w * gx, w * gy, w * gz, w * tx, w * ty, w * tz
        s0 += wx * dist
        s1 += wy * dist
        s2 += wz * dist
        s3 += ox * dist
        s4 += oy * dist
        s5 += oz * dist
        n00 += wx * gx
        n10 += wy * gx
        n11 += wy * gy
        n20 += wz * gx
        n21 += wz * gy
        n22 += wz * gz
        n30 += ox * gx
        n31 += ox * gy
        n32 += ox * gz
        n33 += ox * tx
        n40 += oy * gx
        n41 += oy * gy
        n42 += oy * gz
        n43 += oy * tx
        n44 += oy * ty
        n50 += oz * gx
        n51 += oz * gy
        n52 += oz * gz
        n53 += oz * tx
        n54 += oz * ty
        n55 += oz * tz
    right[0], right[1], right[2], right[3], right[4], right[5] = s0, s1, s2, s3, s4, s5
    normal[0, 0] = n00
    normal[1, 0], normal[1, 1] = n10, n11
    normal[2, 0], normal[2, 1], normal[2, 2] = n20, n21, n22
    normal[3, 0], normal[3, 1], normal[3, 2], normal[3, 3] = n30, n31, n32, n33
    normal[4, 0], normal[4, 1], normal[4, 2], normal[4, 3], normal[4, 4] = n40, n41, n42, n43, n44
    normal[5, 0], normal[5, 1], normal[5, 2], normal[5, 3], normal[5, 4], normal[5, 5] = n50, n51, n52, n53, n54, n55
