"""Errors of a trajectory or of a block of images: frames that bend along the site, strips that drift for themselves, bowls.

The error of a trajectory is a process in time; on a line flown along the site that is one along the site. A sum of sinusoids with
wave lengths drawn uniformly in their logarithm stands for what is left after adjusting GNSS and IMU (Glennie, 2007, J. Appl. Geodesy
1(3); Skaloud and Lichti, 2006, ISPRS J. 61(1)); a bowl for the doming of image blocks (James and Robson, 2014, Earth Surf. Process.
Landforms 39(10)).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..common.errors import InputError

WAVES = 8


@dataclass(frozen=True, kw_only=True)
class FrameErrors:
    """How much the frame of every epoch errs beyond a rigid motion, metres.

    Attributes
    ----------
    bend
        Root mean square per coordinate of what all strips or stations share.
    drift
        The same of what each has for itself.
    bowl
        Height error at the ends of the site, or at wall and toe where it is wider than long; opposite in its middle, and of alternating
        sign by epoch.
    shortest, longest
        Wave lengths of bend and drift.

    Raises
    ------
    InputError
        Something is no number that a frame can err by.
    """

    bend: float = 0.0
    drift: float = 0.0
    bowl: float = 0.0
    shortest: float = 60.0
    longest: float = 300.0

    def __post_init__(self) -> None:
        for field in ("bend", "drift", "bowl"):
            value = getattr(self, field)
            if not math.isfinite(value) or value < 0:
                raise InputError(f"{field} must be 0 or a positive number, got {value!r}", where=field, remedy="Correct the number.")
        if not 0 < self.shortest <= self.longest < math.inf:
            raise InputError(
                f"waves of {self.shortest:g} to {self.longest:g} m cannot be drawn",
                where="wave lengths",
                remedy="Give the shortest and then the longest, both above 0.",
            )


RIGID = FrameErrors()
"""No error beyond the rigid motion of an epoch."""


class FrameOfEpoch:
    """Drawn errors of one epoch, by place in the site: x along its wall, from the middle to ``half_length``; y ``across``, from and to."""

    def __init__(self, errors: FrameErrors, epoch: int, half_length: float, seed: int, *, across: tuple[float, float] = (0.0, 0.0)) -> None:
        self.errors, self.epoch, self.seed = errors, epoch, seed
        self.middle = np.array([0.0, 0.5 * (across[0] + across[1])])
        self.reach = max(half_length, 0.5 * (across[1] - across[0]))

    def at(self, points: FloatArray, sources: IntArray | None = None) -> FloatArray:
        """(n, 3) errors at (n, 3) points measured from (n,) strips or stations; of their mean where none are given."""
        along = points[:, 0]
        total = self._waves(along, self.errors.bend, 0)
        if sources is not None and self.errors.drift > 0:
            for source in np.unique(sources):
                own = sources == source
                total[own] += self._waves(along[own], self.errors.drift, 1 + int(source))
        radius = np.sum((points[:, :2] - self.middle) ** 2, axis=1) / self.reach**2
        total[:, 2] += self.errors.bowl * (2 * radius - 1) * (-1) ** self.epoch
        return total

    def _waves(self, along: FloatArray, rms: float, number: int) -> FloatArray:
        total = np.zeros((len(along), 3))
        if rms <= 0:
            return total
        rng = np.random.default_rng([self.seed, self.epoch, number, 77])
        for axis in range(3):
            lengths = np.exp(rng.uniform(math.log(self.errors.shortest), math.log(self.errors.longest), WAVES))
            amplitudes = rng.normal(size=WAVES)
            amplitudes *= rms * math.sqrt(2 / np.sum(amplitudes**2))
            phases = rng.uniform(0, 2 * math.pi, WAVES)
            total[:, axis] = np.sum(amplitudes * np.sin(2 * math.pi * along[:, None] / lengths + phases), axis=1)
        return total
