"""Targets of an epoch as its registered cloud shows them, and what two epochs have in common of them."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from ..common.arrays import BoolArray, FloatArray, IntArray

SAME_COORDINATES = 2e-5
"""Difference in metres up to which two epochs hold the same surveyed coordinate: files give them to a tenth of a millimetre at best."""
LEAST_OF_CLOUD = 0.05
"""Least share of the stated variance of a target's residual that is its measurement in the cloud, where files say nothing of that."""


@dataclass(frozen=True, eq=False, kw_only=True)
class TargetShifts:
    """Targets of an epoch after its rigid registration.

    Attributes
    ----------
    ids
        Names.
    positions
        (k, 3) surveyed, control frame less the reduction point, metres.
    residuals
        (k, 3) registered cloud less surveyed coordinate, metres.
    variances
        (k, 3) stated, square metres.
    surveyed_variances
        (k, 3) those of the surveyed coordinates alone, which epochs with one control file share; zero where it is not known.
    used
        (k,) took part in the rigid registration; None where all did.
    offset_variance
        Variance per axis of the mean offset of the epoch's strips or stations, which units have and targets do not, square metres.
    drift_variances
        (3,) by axis, of the mean of their drifts at a place, in the same way; zero where they are stiff.
    """

    ids: tuple[str, ...]
    positions: FloatArray
    residuals: FloatArray
    variances: FloatArray
    surveyed_variances: FloatArray
    used: BoolArray | None = None
    offset_variance: float = 0.0
    drift_variances: FloatArray = field(default_factory=lambda: np.zeros(3))

    def chosen(self, used: BoolArray | IntArray) -> TargetShifts:
        """Some of them."""
        return replace(
            self,
            ids=tuple(np.array(self.ids)[used].tolist()),
            positions=self.positions[used],
            residuals=self.residuals[used],
            variances=self.variances[used],
            surveyed_variances=self.surveyed_variances[used],
            used=None if self.used is None else self.used[used],
        )


def numbers_of_common(first: TargetShifts, second: TargetShifts) -> tuple[IntArray, IntArray]:
    """Numbers of the targets that both epochs measured, in each."""
    names = [name for name in first.ids if name in set(second.ids)]
    a, b = (np.array([own.ids.index(name) for name in names], dtype=np.int64) for own in (first, second))
    return a, b


def numbers_of_shared(first: TargetShifts, second: TargetShifts) -> tuple[IntArray, IntArray]:
    """Numbers of the targets that both epochs measured and whose surveyed coordinates are known to be the same ones, in each."""
    a, b = numbers_of_common(first, second)
    same = np.all(np.abs(first.positions[a] - second.positions[b]) < SAME_COORDINATES, axis=1)
    same &= np.all(first.surveyed_variances[a] > 0, axis=1)
    return a[same], b[same]


def difference_of_shared(first: TargetShifts, second: TargetShifts) -> TargetShifts | None:
    """Targets as observations of the difference of two frames, from which the error of coordinates surveyed once drops out.

    None where less than half of an epoch's targets have the same coordinates in the other one.
    """
    a, b = numbers_of_shared(first, second)
    if 2 * len(a) < max(len(first.ids), len(second.ids)):
        return None
    one, other = first.chosen(a), second.chosen(b)
    total = one.variances + other.variances
    return replace(
        one,
        residuals=other.residuals - one.residuals,
        variances=np.maximum(total - one.surveyed_variances - other.surveyed_variances, LEAST_OF_CLOUD * total),
        surveyed_variances=np.zeros_like(total),
        offset_variance=one.offset_variance + other.offset_variance,
        drift_variances=one.drift_variances + other.drift_variances,
    )
