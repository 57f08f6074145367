"""Axes of the scatter of points in space, and directions across one, for compiled loops over small neighbourhoods."""

from __future__ import annotations

from typing import Any

import numpy as np

from .kernels import kernel

MOST_SWEEPS = 12
"""Sweeps of Jacobi rotations: the third or fourth leaves nothing outside the diagonal, as what is left is squared by each."""


@kernel()
def principal_axes(xx: float, xy: float, xz: float, yy: float, yz: float, zz: float) -> Any:
    """Eigenvalue and unit eigenvector, of either sign, three times, of a symmetric matrix; in no order.

    By Jacobi's rotations (Golub and Van Loan, 2013, Matrix Computations, 8.5), a tenth of the time that LAPACK takes to be called for three
    by three.
    """
    ux, uy, uz = 1.0, 0.0, 0.0
    vx, vy, vz = 0.0, 1.0, 0.0
    wx, wy, wz = 0.0, 0.0, 1.0
    nothing = 1e-34 * (xx + yy + zz) ** 2
    for _ in range(MOST_SWEEPS):
        if xy * xy + xz * xz + yz * yz <= nothing:
            break
        t, c, s = _rotation(xx, yy, xy)
        xx, yy, xy = xx - t * xy, yy + t * xy, 0.0
        xz, yz = c * xz - s * yz, s * xz + c * yz
        ux, uy, uz, vx, vy, vz = c * ux - s * vx, c * uy - s * vy, c * uz - s * vz, s * ux + c * vx, s * uy + c * vy, s * uz + c * vz
        t, c, s = _rotation(xx, zz, xz)
        xx, zz, xz = xx - t * xz, zz + t * xz, 0.0
        xy, yz = c * xy - s * yz, s * xy + c * yz
        ux, uy, uz, wx, wy, wz = c * ux - s * wx, c * uy - s * wy, c * uz - s * wz, s * ux + c * wx, s * uy + c * wy, s * uz + c * wz
        t, c, s = _rotation(yy, zz, yz)
        yy, zz, yz = yy - t * yz, zz + t * yz, 0.0
        xy, xz = c * xy - s * xz, s * xy + c * xz
        vx, vy, vz, wx, wy, wz = c * vx - s * wx, c * vy - s * wy, c * vz - s * wz, s * vx + c * wx, s * vy + c * wy, s * vz + c * wz
    return (xx, ux, uy, uz), (yy, vx, vy, vz), (zz, wx, wy, wz)


@kernel()
def least_axis(xx: float, xy: float, xz: float, yy: float, yz: float, zz: float) -> Any:
    """Unit eigenvector of the smallest eigenvalue of a symmetric matrix, of either sign."""
    first, second, third = principal_axes(xx, xy, xz, yy, yz, zz)
    least = first if first[0] <= second[0] and first[0] <= third[0] else (second if second[0] <= third[0] else third)
    return least[1], least[2], least[3]


@kernel()
def across(x: float, y: float, z: float) -> Any:
    """Two unit vectors that complete a unit vector to a right-handed frame."""
    if abs(x) < 0.8:
        f1, f2, f3 = 0.0, z, -y
    else:
        f1, f2, f3 = -z, 0.0, x
    size = np.sqrt(f1 * f1 + f2 * f2 + f3 * f3)
    f1, f2, f3 = f1 / size, f2 / size, f3 / size
    return f1, f2, f3, y * f3 - z * f2, z * f1 - x * f3, x * f2 - y * f1


@kernel()
def _rotation(first: float, second: float, between: float) -> Any:
    """Tangent, cosine and sine of the turn that takes away what is between two axes."""
    if between == 0.0:
        return 0.0, 1.0, 0.0
    half = (second - first) / (2.0 * between)
    t = 1.0 / (abs(half) + np.sqrt(half * half + 1.0))
    t = t if half >= 0.0 else -t
    c = 1.0 / np.sqrt(t * t + 1.0)
    return t, c, t * c
