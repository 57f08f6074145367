"""What the joint adjustment of units and strips takes and gives (:mod:`.strip_offsets`)."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..adjustment.shape_effects import SurfaceModel
from ..common.arrays import BoolArray, FloatArray, IntArray
from ..model.pose import Pose
from ..model.unit_types import UnitType
from .strip_drifts import StripDrifts
from .unit_clouds import Sources, UnitCloud


@dataclass(frozen=True, eq=False, kw_only=True)
class UnitSighting:
    """A unit in one epoch.

    Attributes
    ----------
    unit
        Index of the physical unit, 0, 1, ...
    epoch
        Index of the epoch.
    pose
        Approximate pose, legs numbered alike in all epochs; metres, any frame common to all sightings less a reduction point.
    cloud
        The unit's points in that frame, with the flight strip or station of each.
    discs
        (4,) whether the end of the leg is a plane that may be used.
    shape
        Geometry of the unit.
    """

    unit: int
    epoch: int
    pose: Pose
    cloud: UnitCloud
    discs: BoolArray
    shape: UnitType


@dataclass(frozen=True, eq=False, kw_only=True)
class JointAdjustment:
    """Result of :func:`adjust_jointly`.

    Attributes
    ----------
    poses
        Of each sighting, in the order given.
    covariances
        By unit: (6 k, 6 k) covariance of the poses of its k sightings, in the order of ``order[unit]``; e, n, h, w_e, w_n, w_h
        each. It holds noise, surface deviations and offsets.
    noise_covariances
        By unit: what would be left of its covariance if its surface and the offsets were known, which is noise alone.
    order
        By unit: indices of its sightings, by epoch.
    offsets
        (epoch, source) to (3,) offset in metres: a point less its offset is in the epoch's mean frame.
    offset_sds
        (epoch, source) to (3,) standard deviations.
    scales, scale_sds
        By unit: relative difference of its size from the given geometry, and its standard deviation.
    noise
        (e,) standard deviation of a point along the surface normal by epoch, metres; an epoch with too few points to tell counts as
        noisy as the others.
    surface_sd
        Standard deviation of the surface deviations, metres.
    used
        (sightings,) points that carry weight.
    drifts
        How strips deviate from their offsets along the structure; None where they are stiff.
    surfaces
        By geometry of units, mould and variances of their castings.
    """

    poses: tuple[Pose, ...]
    covariances: dict[int, FloatArray]
    noise_covariances: dict[int, FloatArray]
    order: dict[int, tuple[int, ...]]
    offsets: dict[tuple[int, int], FloatArray]
    offset_sds: dict[tuple[int, int], FloatArray]
    scales: dict[int, float]
    scale_sds: dict[int, float]
    noise: FloatArray
    surface_sd: float
    used: IntArray
    drifts: StripDrifts | None = None
    surfaces: dict[UnitType, SurfaceModel] = field(default_factory=dict)

    def offsets_of(self, unit: int, epoch: int, sources: Sources) -> FloatArray:
        """(s, 3) offsets of strips or stations where a unit lies, metres."""
        constant = np.array([self.offsets[epoch, int(k)] for k in sources]).reshape(-1, 3)
        return constant if self.drifts is None else constant + self.drifts.at(unit, epoch, sources)
