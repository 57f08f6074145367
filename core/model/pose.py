"""Pose of a unit: where its body frame lies in a metric frame (survey CRS, or the CRS less a reduction point)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from ..common.arrays import FloatArray

_IDENTITY = np.eye(3)


@dataclass(frozen=True, eq=False)
class Pose:
    """Rigid placement X = centre + rotation @ x of body coordinates x.

    Attributes
    ----------
    centre
        (3,) metres, easting, northing, height.
    rotation
        (3, 3) proper rotation, body axes to frame axes.

    Small changes are written (dX, dw): centre + dX, and exp([dw]x) @ rotation, so that dw is a rotation vector
    about the frame's axes, in radians. Every covariance of a pose in this package follows that order and meaning.
    """

    centre: FloatArray
    rotation: FloatArray

    def __post_init__(self) -> None:
        centre = np.asarray(self.centre, dtype=np.float64)
        rotation = np.asarray(self.rotation, dtype=np.float64)
        if centre.shape != (3,) or rotation.shape != (3, 3):
            raise ValueError(f"pose needs a (3,) centre and a (3, 3) rotation, got {centre.shape} and {rotation.shape}")
        # what numpy.allclose would say, which takes longer than all else here
        orthonormal = (np.abs(rotation @ rotation.T - _IDENTITY) <= 1e-6 + 1e-5 * _IDENTITY).all()
        if not orthonormal or np.linalg.det(rotation) < 0:
            raise ValueError("pose rotation is not a proper rotation matrix")
        centre.setflags(write=False)
        rotation.setflags(write=False)
        object.__setattr__(self, "centre", centre)
        object.__setattr__(self, "rotation", rotation)

    @classmethod
    def of_row(cls, row: FloatArray) -> Pose:
        """From (12,) centre and rotation by rows, as compiled loops and tables hold poses."""
        return cls(row[:3], row[3:].reshape(3, 3))

    def as_row(self) -> FloatArray:
        """(12,) centre and rotation by rows."""
        return np.concatenate([self.centre, self.rotation.ravel()])

    def to_frame(self, body: ArrayLike) -> FloatArray:
        """(n, 3) body coordinates to frame coordinates."""
        return np.asarray(np.asarray(body, dtype=np.float64) @ self.rotation.T + self.centre)

    def to_body(self, points: ArrayLike) -> FloatArray:
        """(n, 3) frame coordinates to body coordinates."""
        return np.asarray((np.asarray(points, dtype=np.float64) - self.centre) @ self.rotation)

    def shifted(self, offset: ArrayLike) -> Pose:
        """The same pose in a frame whose origin differs: centre + offset."""
        return Pose(self.centre + np.asarray(offset, dtype=np.float64), self.rotation)

    def perturbed(self, translation: ArrayLike, rotation_vector: ArrayLike) -> Pose:
        """Apply a small change (dX in metres, dw in radians about the frame's axes)."""
        turn = Rotation.from_rotvec(np.asarray(rotation_vector, dtype=np.float64)).as_matrix()
        return Pose(self.centre + np.asarray(translation, dtype=np.float64), turn @ self.rotation)

    def relabelled(self, symmetry: ArrayLike) -> Pose:
        """The same solid with its legs renumbered by a (3, 3) rotation that maps the body onto itself."""
        return Pose(self.centre, self.rotation @ np.asarray(symmetry, dtype=np.float64))

    def twisted_as(self, known: Pose, axis: ArrayLike) -> Pose:
        """The pose turned about a (3,) axis of the body, which stays where it is, so that the twist about it is that of the known pose."""
        along = self.rotation @ np.asarray(axis, dtype=np.float64)
        x, y, z, w = Rotation.from_matrix(known.rotation @ self.rotation.T).as_quat()
        twist = 2 * np.arctan2(np.dot([x, y, z], along), w)
        return Pose(self.centre, Rotation.from_rotvec(twist * along).as_matrix() @ self.rotation)

    def quaternion(self) -> FloatArray:
        """(4,) qx, qy, qz, qw of the rotation body -> frame, qw >= 0."""
        return np.asarray(Rotation.from_matrix(self.rotation).as_quat(canonical=True))

    @classmethod
    def from_quaternion(cls, centre: ArrayLike, quaternion: ArrayLike) -> Pose:
        """Pose from a centre and (qx, qy, qz, qw)."""
        rotation = Rotation.from_quat(np.asarray(quaternion, dtype=np.float64)).as_matrix()
        return cls(np.array(centre, dtype=np.float64), rotation)


def rotation_angle(a: ArrayLike, b: ArrayLike) -> float:
    """Angle in radians of the rotation that takes (3, 3) rotation ``a`` to ``b``."""
    turn = np.asarray(b, dtype=np.float64) @ np.asarray(a, dtype=np.float64).T
    return float(Rotation.from_matrix(turn).magnitude())
