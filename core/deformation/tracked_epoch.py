"""One epoch to be tracked, and a physical unit in one epoch."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from datetime import datetime

import numpy as np

from ..common.arrays import FloatArray
from ..common.registration_records import mean_offset_variance
from ..model.pose import Pose
from ..registration.transformation import Transformation
from ..segmentation.leg_ends import LegEnds
from .fitted_unit import FittedUnit
from .target_shifts import TargetShifts

UNNUMBERED = 0
"""Source of points whose strip or station nobody noted (ASPRS LAS specification 1.4, point source ID)."""
UNNUMBERED_OFFSET = 0.2
"""Mean offset of an epoch's strips or stations over the noise of a point, where points have no source: what four strips leave that are off
by two fifths of the noise each. Assumed; strips with numbers show theirs, and resting units say by how much it is wrong."""


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
    drift_variances
        (3,) by axis, of the mean of their drifts at a place, in the same way; zero where they are stiff.
    targets
        Its targets after the registration; None without control.
    datum
        What its frame hangs on, as field ``datum`` of the result says it.
    numbered
        Whether the files number its strips or stations; where they do not these are passes that GPS time tells, parts of one perhaps.
    """

    label: str
    time: datetime
    units: tuple[FittedUnit, ...]
    registration: Transformation | None
    redundancy: int = 0
    tied_to: int | None = None
    offset_variance: float = 0.0
    drift_variances: FloatArray = field(default_factory=lambda: np.zeros(3))
    targets: TargetShifts | None = None
    datum: str = "cloud"
    numbered: bool = True

    @property
    def placement(self) -> Transformation | None:
        """The registration with the mean offset of the strips and the mean of their drifts, as a common shift, added to its covariance.

        The drifts differ from place to place; where the frame stays rigid, what they leave open of one place is asked of all.
        """
        return None if self.registration is None else self.registration.with_offset(self.offset_variance + self.drift_variances)

    @property
    def placed_targets(self) -> TargetShifts | None:
        """Its targets with what its strips leave open of its units' place and not of theirs; None without control."""
        if self.targets is None:
            return None
        return replace(self.targets, offset_variance=self.offset_variance, drift_variances=self.drift_variances)

    def with_mean_offset(self, offsets: Mapping[int, FloatArray], noise: float) -> TrackedEpoch:
        """The epoch with the variance of the mean offset of its strips or stations, as they show it or, without numbers, as is assumed.

        Parameters
        ----------
        offsets
            (3,) in metres by source.
        noise
            Standard deviation of a point along the surface normal, metres.
        """
        assumed = (UNNUMBERED_OFFSET * float(noise)) ** 2
        if set(offsets) == {UNNUMBERED}:
            return replace(self, offset_variance=assumed)
        shown = mean_offset_variance(list(offsets.values()))
        # parts of one strip have its offset in common
        return replace(self, offset_variance=shown if self.numbered else max(shown, assumed))


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
    held
        Its points leave the displacement from another epoch open, and the pose is held where that one shows the unit
        (:mod:`.open_displacements`).
    """

    row: int | None
    pose: Pose | None
    covariance: FloatArray | None
    scale: float
    status: str
    points: int
    ambiguous: bool = False
    legs: LegEnds = field(default_factory=LegEnds.unseen)
    held: bool = False
