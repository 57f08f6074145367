"""Rotations that fit vectors best."""

from __future__ import annotations

import numpy as np

from .arrays import FloatArray


def closest_rotation(product: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Proper rotation that turns one set of vectors onto another best by least squares.

    Parameters
    ----------
    product
        (..., 3, 3) sum of the outer products of target and source vectors; of a matrix that is almost a rotation the matrix itself.

    Returns
    -------
    (..., 3, 3) rotation and (..., 3) singular values, the last one negative where a mirror image would fit better (Umeyama, 1991,
    IEEE PAMI 13(4)).
    """
    u, values, vt = np.linalg.svd(product)
    sign = np.ones_like(values)
    sign[..., 2] = np.sign(np.linalg.det(u @ vt))
    return np.asarray(u * sign[..., None, :] @ vt), np.asarray(values * sign)
