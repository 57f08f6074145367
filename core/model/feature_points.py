"""Feature points: the centre and the four points where three cones meet on the outside (paper 2.4, eqs. 10-13)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from ..common.arrays import FloatArray
from .pose import Pose
from .unit_types import UnitType

FEATURES = ("centre", "f123", "f124", "f134", "f234")
"""Order of features everywhere; digits are leg numbers 1..4."""
END_DISCS = ("d1", "d2", "d3", "d4")
"""Optional features: centres of the legs' end discs, which crews can measure and paint."""
TRIPLES = tuple(combinations(range(4), 3))


@dataclass(frozen=True, eq=False)
class FeaturePoints:
    """Feature points of one unit, in the order of ``FEATURES``.

    Attributes
    ----------
    positions
        (5, 3) metres, in the frame of the pose.
    covariances
        (5, 3, 3) square metres.
    jacobian
        (5, 3, 8) derivatives with respect to e, n, h, omega_e, omega_n, omega_h, r, c; with the unit's 8x8 covariance it
        gives the covariance between any two features.
    """

    positions: FloatArray
    covariances: FloatArray
    jacobian: FloatArray


def body_features(unit: UnitType) -> FloatArray:
    """(5, 3) feature points in the body frame, metres: closed form for the tetrahedral opening, general solver otherwise."""
    if unit.opening == "tetrahedral":
        joints = -unit.crotch_distance * unit.leg_directions[[3, 2, 1, 0]]
    else:
        joints = np.array([intersect_cones(unit.leg_directions[list(t)], unit.radius, unit.gradient) for t in TRIPLES])
    return np.vstack([np.zeros(3), joints])


def intersect_cones(axes: ArrayLike, radius: float, gradient: float) -> FloatArray:
    """(3,) outer point where three co-centred equal cones meet (paper eqs. 10-13), for any three axes.

    Equal cones meet where the three axial coordinates are equal, so the point lies on the line through the centre whose
    direction d solves axes @ d = 1 up to scale; on the ray that leans towards the three legs the cone's equation is linear in the distance.

    Parameters
    ----------
    axes
        (3, 3) unit vectors of the legs, one a row.
    radius, gradient
        Shape of the cones, metres and metres per metre.

    Raises
    ------
    ValueError
        The axes lie in one plane with the centre, or the cones do not meet on the outside.
    """
    rows = np.asarray(axes, dtype=np.float64)
    if abs(np.linalg.det(rows)) < 1e-9:
        raise ValueError("three legs in one plane have no common point on the outside")
    direction = np.linalg.solve(rows, np.ones(3))
    direction /= np.linalg.norm(direction)
    lean = float(rows[0] @ direction)
    # distance s along the ray: s sin = r - c s cos
    reach = radius / (math.sqrt(max(1 - lean * lean, 0.0)) + gradient * lean)
    if reach <= 0:
        raise ValueError("cones of these legs do not meet on the outside")
    return np.asarray(reach * direction)


def feature_points(pose: Pose, unit: UnitType, covariance: ArrayLike | None = None) -> FeaturePoints:
    """Feature points of a unit with their covariance.

    Parameters
    ----------
    pose
        Placement of the unit.
    unit
        Geometry with the adjusted radius and gradient.
    covariance
        (8, 8) of e, n, h, omega_e, omega_n, omega_h, r, c; None for zero.
    """
    body = body_features(unit)
    positions = pose.to_frame(body)
    arms = positions - pose.centre
    jacobian = np.zeros((5, 3, 8))
    jacobian[:, :, :3] = np.eye(3)
    for k in range(5):
        x, y, z = arms[k]
        # X = centre + exp([dw]x) arm, so dX/dw = -[arm]x
        jacobian[k, :, 3:6] = [[0, z, -y], [-z, 0, x], [y, -x, 0]]
    # reach = r / (s + c l): linear in r, and -r l / (s + c l)^2 in c
    for k, triple in enumerate(TRIPLES, start=1):
        reach = float(np.linalg.norm(body[k]))
        ray = arms[k] / reach
        lean = float(unit.leg_directions[triple[0]] @ body[k]) / reach
        jacobian[k, :, 6] = ray * reach / unit.radius
        jacobian[k, :, 7] = -ray * reach**2 * lean / unit.radius
    given = np.zeros((8, 8)) if covariance is None else np.asarray(covariance, dtype=np.float64)
    if given.shape != (8, 8):
        raise ValueError(f"covariance must be (8, 8), got {given.shape}")
    covariances = np.einsum("kia,ab,kjb->kij", jacobian, given, jacobian)
    return FeaturePoints(positions, covariances, jacobian)


def end_disc_centres(pose: Pose, unit: UnitType, covariance: ArrayLike | None = None) -> tuple[FloatArray, FloatArray]:
    """Centres of the end discs of legs 1 to 4: (4, 3) positions in the frame of the pose, metres, and (4, 3, 3) covariances.

    The length of a leg is taken as known: castings end within millimetres of their mould.

    Parameters
    ----------
    pose, unit
        Placement and geometry.
    covariance
        (8, 8) of e, n, h, omega_e, omega_n, omega_h, r, c; None for zero.
    """
    positions = pose.to_frame(unit.leg_length * unit.leg_directions)
    given = np.zeros((8, 8)) if covariance is None else np.asarray(covariance, dtype=np.float64)
    jacobian = np.zeros((4, 3, 6))
    jacobian[:, :, :3] = np.eye(3)
    for k, (x, y, z) in enumerate(positions - pose.centre):
        jacobian[k, :, 3:6] = [[0, z, -y], [-z, 0, x], [y, -x, 0]]
    return positions, np.einsum("kia,ab,kjb->kij", jacobian, given[:6, :6], jacobian)


def label_symmetry(reference: Pose, pose: Pose, unit: UnitType) -> tuple[FloatArray, float, float]:
    """Rotation of the body onto itself that renumbers ``pose`` to turn least from ``reference``.

    Returns the (3, 3) symmetry for :meth:`Pose.relabelled`, the remaining turn and the next best turn, radians; where the two are
    close the labels are ambiguous.
    """
    turns = reference.rotation.T @ pose.rotation @ unit.symmetries
    angles = Rotation.from_matrix(turns).magnitude()
    order = np.argsort(angles)
    return unit.symmetries[order[0]], float(angles[order[0]]), float(angles[order[1]])
