"""Robust least squares of the poses of whole units to the elements around them (paper 2.1)."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import prange

from ..common.arrays import BoolArray, FloatArray
from ..common.kernels import kernel
from ..common.neighbourhood import gather
from ..common.positive_definite import factorise, solve_factorised
from .cone_relation import FEW_POSES, ConeShape, OrientedPoints, normal_at, relate_point, surely_farther
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
    shape, elements, effort = ConeShape.of(scene.unit), OrientedPoints(scene.points, scene.normals, scene.curved), _Effort(most, sweeps)
    if len(out) > FEW_POSES:
        _refine_many(out, elements, active, scene.grid, shape, scene.tolerance, effort)
    else:
        for pose in out:
            _refine_one(pose, elements, active, scene.grid, shape, scene.tolerance, effort)
    return out


@kernel(parallel=True)
def _refine_many(poses: Any, elements: Any, active: Any, grid: Any, shape: Any, tolerance: float, effort: Any) -> None:
    for i in prange(len(poses)):
        _refine_one(poses[i], elements, active, grid, shape, tolerance, effort)


@kernel()
def _refine_one(pose: Any, elements: Any, active: Any, grid: Any, shape: Any, tolerance: float, effort: Any) -> None:
    """Least squares of one pose, in place."""
    points, normals = elements.points, elements.normals
    legs, radius, gradient, length, height = shape
    most, sweeps = effort
    cosine = 1.0 / np.sqrt(1.0 + gradient * gradient)
    near = gather(points, active, (pose[0], pose[1], pose[2]), BROAD * height, grid, most)
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
            if surely_farther(x, y, z, legs, radius, gradient, length, limit):
                continue
            leg, dist, part, axial, rho = relate_point(x, y, z, legs, radius, gradient, length)
            if part == 2 or abs(dist) > limit or rho < 1e-9:
                continue
            nx, ny, nz = normal_at((x, y, z), leg, part, axial, rho, legs, gradient, cosine)
            gx = r00 * nx + r01 * ny + r02 * nz
            gy = r10 * nx + r11 * ny + r12 * nz
            gz = r20 * nx + r21 * ny + r22 * nz
            if abs(gx * local[q, 3] + gy * local[q, 4] + gz * local[q, 5]) < LEAST_AGREEMENT_OF_FIT:
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
        weight = normal[0, 0] + normal[1, 1] + normal[2, 2]
        if weight < 5.0:
            break
        for a in range(6):
            normal[a, a] += 2e-3 * weight / 3.0
        factorise(normal)
        step = right.copy()
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
