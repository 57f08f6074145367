"""One epoch to be tracked, and a physical unit in one epoch."""

from __future__ import annotations

from dataclasses import dataclass, field
from datetime import datetime

from ..common.arrays import FloatArray
from ..model.pose import Pose
from ..registration.transformation import Transformation
from ..segmentation.leg_ends import LegEnds
from .epoch_frames import TargetShifts
from .fitted_unit import FittedUnit


@dataclass(frozen=True, eq=False, kw_only=True)
class TrackedEpoch:
    """One epoch to be tracked.

    Attributes
    ----------
    label, time
        As in survey.toml.
    units
        Found units.
    registration
        Transformation to control, its reduction point ``origin_to`` already less the common one; None without control.
    redundancy
        Of the registration.
    tied_to
        Index of the epoch that this one was registered to on stable areas, so that it shares that one's error; None for control.
    offset_variance
        Variance of the mean offset of the epoch's strips or stations per axis, square metres: what a registration cannot know.
    targets
        Its targets after the registration; None without control.
    """

    label: str
    time: datetime
    units: tuple[FittedUnit, ...]
    registration: Transformation | None
    redundancy: int = 0
    tied_to: int | None = None
    offset_variance: float = 0.0
    targets: TargetShifts | None = None

    @property
    def placement(self) -> Transformation | None:
        """The registration with the mean offset of the strips, as a common shift, added to its covariance."""
        return None if self.registration is None else self.registration.with_offset(self.offset_variance)


@dataclass(frozen=True, eq=False, kw_only=True)
class TrackedUnit:
    """A physical unit in one epoch.

    Attributes
    ----------
    row
        Its row in the epoch's units; None where it was recovered at the place another epoch predicts, or is not seen.
    pose, covariance
        Pose of the joint adjustment with the unit's own leg numbers, and (6, 6) covariance without registration; None without pose.
    scale
        Size over the nominal one, estimated from all epochs.
    status
        ``found``, ``uncertain``, ``new``, ``relocated``, ``lost`` or ``unseen``.
    points
        Points used.
    ambiguous
        The motion since the last sighting leaves the leg numbers open.
    legs
        Whether its legs are whole, by its own leg numbers.
    """

    row: int | None
    pose: Pose | None
    covariance: FloatArray | None
    scale: float
    status: str
    points: int
    ambiguous: bool = False
    legs: LegEnds = field(default_factory=LegEnds.unseen)
