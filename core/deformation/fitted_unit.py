"""A unit as one epoch shows it: found, adjusted, with access to its points."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..segmentation.leg_ends import LegEnds
from .unit_clouds import UnitCloud


@dataclass(frozen=True, eq=False, kw_only=True)
class FittedUnit:
    """A unit found and adjusted in one epoch, in the control frame less the reduction point.

    Attributes
    ----------
    pose, shape, kind
        Adjusted pose; geometry; index of the type of unit.
    certain
        False for weak evidence.
    discs
        (4,) legs whose end disc was used.
    cloud
        Its points and their strips or stations; none where only the fit is known.
    covariance
        (6, 6) of the fitted pose, used where there are no points or nothing ties the units.
    score
        Probability that it is a unit, 0 to 1.
    twist_open
        Uncertain for nothing but the turn about a leg, which its own epoch leaves open.
    n_points
        Points that carry weight in the fit.
    legs
        Whether its legs are whole.
    """

    pose: Pose
    shape: UnitType
    kind: int
    certain: bool
    discs: NDArray[np.bool_]
    cloud: UnitCloud
    covariance: FloatArray | None = None
    score: float = 1.0
    twist_open: bool = False
    n_points: int = 0
    legs: LegEnds = field(default_factory=LegEnds.unseen)

    def relabelled(self, symmetry: FloatArray) -> FittedUnit:
        """The same unit with its legs numbered anew by one of the type's (3, 3) symmetries."""
        new_to_old = np.argmax(self.shape.leg_directions @ (self.shape.leg_directions @ symmetry.T).T, axis=0)
        return replace(self, pose=self.pose.relabelled(symmetry), discs=self.discs[new_to_old], legs=self.legs.renumbered(new_to_old))
