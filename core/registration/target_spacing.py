"""How many targets a long structure needs: what they leave unknown of a bent frame halfway between two stations.

The model is that of :mod:`.frame_field` along one line: stations of targets at equal distances, the field kriged between them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..common.noncentrality import noncentrality
from .frame_field import matern

STATIONS = 9
"""Stations on which the kriging rests: those farther away say nothing more."""
FREE = 10.0
CLOSEST = 2.0
"""Least spacing that is considered, metres: nearer stations are one."""
LEAST_TARGET_SD, LEAST_STATION_SD = 1e-6, 1e-5
"""Metres; nobody measures a target better than the first, nor are all of a station together better known than the second."""
LONGEST = 1e6
"""Metres; no structure is longer."""


@dataclass(frozen=True, kw_only=True)
class BentSurvey:
    """What a planned survey is like, metres.

    Attributes
    ----------
    bend
        Root mean square of an epoch's bend per coordinate.
    correlation_length
        Distance over which the bend forgets itself.
    target_sd
        Standard deviation of one target in the cloud, survey included, per coordinate.
    targets
        Targets of one station.

    Raises
    ------
    InputError
        Something is no number that a survey can have.
    """

    bend: float = 0.03
    correlation_length: float = 35.0
    target_sd: float = 0.006
    targets: int = 3

    def __post_init__(self) -> None:
        for field, least in (("bend", 0.0), ("correlation_length", 1e-3), ("target_sd", LEAST_TARGET_SD), ("targets", 1)):
            value = getattr(self, field)
            if not least <= value < math.inf:
                raise InputError(f"{field} must be a number of {least:g} or more, got {value!r}", where=field, remedy="Correct the number.")

    def unknown(self, spacing: float) -> float:
        """Standard deviation (m, per coordinate) of an epoch's error halfway between stations ``spacing`` metres apart."""
        places = np.asarray((np.arange(STATIONS) - (STATIONS - 1) / 2 + 0.5) * spacing, dtype=np.float64)
        return math.sqrt(self._variance(places, 0.0))

    def _variance(self, places: FloatArray, where: float) -> float:
        # a shift and a slope stay of the rigid registration
        free = [FREE, FREE / max(1000.0, float(np.abs(places).max()))]
        drift = np.column_stack([np.ones(len(places)), places]) * free
        own = np.array([1.0, where]) * free
        station_sd = max(self.target_sd / math.sqrt(self.targets), LEAST_STATION_SD)
        apart = np.abs(places[:, None] - places[None]) / self.correlation_length
        covariance = self.bend**2 * matern(apart, 2.5) + drift @ drift.T + np.eye(len(places)) * station_sd**2
        cross = self.bend**2 * matern(np.abs(places - where) / self.correlation_length, 2.5) + drift @ own
        return max(float(self.bend**2 + own @ own - cross @ np.linalg.solve(covariance, cross)), 0.0)

    def detectable(self, spacing: float, significance: float = 0.05, power: float = 0.8) -> float:
        """Least displacement (m) between two epochs in datum ``control`` that a test finds halfway between stations."""
        return math.sqrt(2 * noncentrality(significance, power)) * self.unknown(spacing)

    def spacing_for(self, limit: float, length: float) -> float:
        """Largest distance of stations (m), up to the ``length`` of the structure, that keeps the detection limit.

        Raises
        ------
        InputError
            No spacing does: the targets themselves are not good enough.
        """
        low, high = CLOSEST, max(length, CLOSEST)
        if not self.detectable(low) <= limit:
            raise InputError(
                f"a detection limit of {limit:g} m cannot be reached with {self.targets} targets of {self.target_sd:g} m a station",
                where="limit",
                remedy="Measure targets better, or more of them at each station.",
            )
        if self.detectable(high) <= limit:
            return high
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self.detectable(middle) <= limit else (low, middle)
        return low


def stations_for(survey: BentSurvey, limit: float, length: float) -> tuple[int, float]:
    """Stations for a structure of ``length`` metres, one at each end, and their distance in metres.

    Raises
    ------
    InputError
        The length is none that a structure has, or no spacing keeps the limit.
    """
    if not 0 < length <= LONGEST:
        raise InputError(
            f"a structure of {length!r} m has no stations",
            where="length",
            remedy=f"Give its length in metres, at most {LONGEST / 1000:.0f} km.",
        )
    spacing = survey.spacing_for(limit, length)
    count = max(2, math.ceil(length / spacing) + 1)
    return count, length / (count - 1)
