"""Frames that a result states for its own units: the way from the control frame back to each epoch's cloud.

Steps of their own take units as they were found, in the frame of their cloud. A result of a whole run or of tracking holds them in the
control frame, straightened where the frame bends; registered once more they would lie wrong by the whole registration.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from scipy.linalg import eigh

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..model.pose import Pose
from ..registration.frame_correction import FrameCorrection
from ..registration.transformation import Transformation
from ..results.geopackage_reader import read_layer_rows, table_names
from ..results.result_access import REQUIRED
from .registered_layers import RegisteredEpoch, read_registered

LEAST_OWN = 1e-4
"""Least share of a stated covariance that stays with the unit when that of its frame is taken out of it."""


@dataclass(frozen=True, eq=False, kw_only=True)
class StatedFrame:
    """Frame of one epoch as a result states it.

    Attributes
    ----------
    transformation
        Cloud to control.
    applied
        What ties units that stay in the control frame.
    correction
        Error of the registered cloud where its frame bends.
    """

    transformation: Transformation
    applied: RegisteredEpoch
    correction: FrameCorrection

    def in_cloud(self, pose: Pose) -> Pose:
        """A pose of the control frame in the frame of the cloud."""
        registered = pose.centre[None] + self.correction.at(pose.centre[None])
        return Pose(self.transformation.invert(registered)[0], self.transformation.rotation.T @ pose.rotation)

    def own_covariance(self, pose: Pose, covariance: FloatArray) -> FloatArray:
        """(6, 6) covariance of a pose of the control frame (m, rad) less what its frame brought into it.

        Raises
        ------
        InputError
            The covariance is none.
        """
        shared = self.transformation.pose_covariance(pose)
        if len(self.correction.chainage):
            shared[:3, :3] = np.diag(self.correction.variances_at(pose.centre[None])[0])
        try:
            shares, vectors = eigh(shared, covariance)
        except (np.linalg.LinAlgError, ValueError) as error:
            raise InputError(
                "a covariance is not positive definite", where="layer units", remedy="Give a result of tetratrack fit."
            ) from error
        carried = covariance @ vectors
        return np.asarray((carried * np.clip(1.0 - shares, LEAST_OWN, None)) @ carried.T)


def stated_frames(path: Path) -> dict[str, StatedFrame]:
    """Frames by the label of their epoch of a GeoPackage with the layer ``units``; none for epochs whose units are in the frame of their
    cloud, and of a file that holds no result.

    Raises
    ------
    InputError
        The file cannot be read, or a transformation is incomplete.
    """
    if not table_names(path, ("units",)).issuperset(REQUIRED):
        return {}
    bends = read_layer_rows(path, "frame_errors")
    found = {}
    for label, epoch in read_registered([path]).items():
        if epoch.transformation is not None:
            correction = FrameCorrection.from_rows(bends, label)
            found[label] = StatedFrame(transformation=epoch.transformation, applied=epoch.applied(), correction=correction)
    return found


def is_registered(row: Mapping[str, Any]) -> bool:
    """Whether a row of ``units`` says that it is not in the frame of its cloud."""
    return row.get("datum") not in (None, "cloud")
