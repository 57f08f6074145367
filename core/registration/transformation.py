"""Rigid or similarity transformation of an epoch's cloud to the control frame, with its covariance."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from ..common.arrays import FloatArray
from ..common.registration_records import record_numbers
from ..model.pose import Pose


@dataclass(frozen=True, eq=False, kw_only=True)
class Transformation:
    """X = origin_to + translation + scale * rotation @ (x - origin_from), cloud to control frame.

    Attributes
    ----------
    origin_from, origin_to
        (3,) reduction points in the cloud and in the control frame, metres.
    translation
        (3,) metres.
    rotation
        (3, 3).
    scale
        1 for a rigid transformation.
    covariance
        (7, 7) of t_e, t_n, t_h (m), w_e, w_n, w_h (rad, rotation vector about the control frame's axes at ``origin_to``) and scale;
        zero rows for what was held fixed.
    """

    origin_from: FloatArray
    origin_to: FloatArray
    translation: FloatArray
    rotation: FloatArray
    scale: float
    covariance: FloatArray

    @classmethod
    def identity(cls, origin: ArrayLike) -> Transformation:
        """The cloud's own frame is kept, without uncertainty."""
        point = np.array(origin, dtype=np.float64)
        return cls(
            origin_from=point, origin_to=point.copy(), translation=np.zeros(3), rotation=np.eye(3), scale=1.0, covariance=np.zeros((7, 7))
        )

    def apply(self, points: ArrayLike) -> FloatArray:
        """(n, 3) cloud coordinates to the control frame."""
        reduced = np.asarray(points, dtype=np.float64) - self.origin_from
        return np.asarray(self.scale * reduced @ self.rotation.T + (self.origin_to + self.translation))

    def invert(self, points: ArrayLike) -> FloatArray:
        """(n, 3) coordinates of the control frame to the cloud."""
        reduced = np.asarray(points, dtype=np.float64) - (self.origin_to + self.translation)
        return np.asarray(reduced @ self.rotation / self.scale + self.origin_from)

    def apply_pose(self, pose: Pose) -> Pose:
        """Pose in the cloud to the control frame."""
        return Pose(self.apply(pose.centre[None])[0], self.rotation @ pose.rotation)

    def jacobian(self, points: ArrayLike) -> FloatArray:
        """(n, 3, 7) derivatives of (n, 3) transformed points with respect to the seven parameters."""
        arm = np.asarray(points, dtype=np.float64).reshape(-1, 3) - self.origin_to
        return rigid_jacobian(arm)

    def covariance_at(self, origin: ArrayLike) -> FloatArray:
        """(7, 7) covariance of the same parameters with shifts referring to (3,) ``origin`` of the control frame."""
        carry = np.eye(7)
        carry[:3] = self.jacobian(origin)[0]
        return np.asarray(carry @ self.covariance @ carry.T)

    def pose_covariance(self, pose: Pose) -> FloatArray:
        """(6, 6) covariance of e, n, h and rotation vector that the registration brings into a pose of the control frame."""
        effect = np.zeros((6, 7))
        effect[:3] = self.jacobian(pose.centre)[0]
        effect[3:, 3:6] = np.eye(3)
        return np.asarray(effect @ self.covariance @ effect.T)

    def with_offset(self, variance: ArrayLike) -> Transformation:
        """The same with the variance of a common offset (square metres), of every axis or (3,) by axis, added to its covariance."""
        return replace(self, covariance=self.covariance + np.diag([*np.broadcast_to(variance, 3), 0.0, 0.0, 0.0, 0.0]))

    def with_shift(self, shift: ArrayLike, turn: ArrayLike, covariance: FloatArray) -> Transformation:
        """The transformation followed by a small motion (shift in m, rotation vector in rad, about ``origin_to``)."""
        matrix = Rotation.from_rotvec(np.asarray(turn, dtype=np.float64)).as_matrix()
        translation = matrix @ self.translation + np.asarray(shift, dtype=np.float64)
        return replace(self, translation=translation, rotation=matrix @ self.rotation, covariance=covariance)

    @classmethod
    def from_record(cls, record: Mapping[str, Any]) -> Transformation:
        """Inverse of :meth:`as_record`.

        Raises
        ------
        InputError
            The record is incomplete or damaged.
        """
        return cls(
            origin_from=record_numbers(record, "origin_from"),
            origin_to=record_numbers(record, "origin_to"),
            translation=record_numbers(record, "translation_m"),
            rotation=Rotation.from_rotvec(record_numbers(record, "rotation_vector_rad")).as_matrix(),
            scale=float(record_numbers(record, "scale")),
            covariance=record_numbers(record, "covariance"),
        )

    def as_record(self) -> dict[str, Any]:
        """Plain numbers for the run record and the layer ``epochs``."""
        return {
            "model": "X = origin_to + translation + scale * R(rotation_vector) (x - origin_from)",
            "origin_from": self.origin_from.tolist(),
            "origin_to": self.origin_to.tolist(),
            "translation_m": self.translation.tolist(),
            "rotation_vector_rad": Rotation.from_matrix(self.rotation).as_rotvec().tolist(),
            "scale": self.scale,
            "covariance": self.covariance.tolist(),
        }


def transformation_of(record: Mapping[str, Any]) -> Transformation | None:
    """Transformation from the record in layer ``epochs``; None where the cloud's own frame was kept.

    Raises
    ------
    InputError
        The record is incomplete or damaged.
    """
    if not record:
        return None
    return Transformation.from_record(record)


def rigid_jacobian(arms: FloatArray) -> FloatArray:
    """(n, 3, 7) derivative of points at (n, 3) ``arms`` from the reduction point by shift, rotation vector and scale."""
    jacobian = np.zeros((len(arms), 3, 7))
    jacobian[:, [0, 1, 2], [0, 1, 2]] = 1
    x, y, z = arms.T
    jacobian[:, 0, 4], jacobian[:, 0, 5] = z, -y
    jacobian[:, 1, 3], jacobian[:, 1, 5] = -z, x
    jacobian[:, 2, 3], jacobian[:, 2, 4] = y, -x
    jacobian[:, :, 6] = arms
    return jacobian
