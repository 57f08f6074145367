"""What the units of an epoch have in common of their heights' errors: that of the frame in which they all stand."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from ..common.arrays import FloatArray
from ..common.registration_records import common_variance, record_numbers
from .geopackage_reader import Row
from .unit_rows import EpochInfo


@dataclass(frozen=True, eq=False, kw_only=True)
class FrameHeights:
    """Error in height of one epoch's frame as a result states it.

    Attributes
    ----------
    label
        The epoch.
    origin, covariance
        (3,) reduction point and (7, 7) covariance of its registration: shift (m), turn (rad) and scale; zero without one.
    offset
        Variance of what its strips or stations have in common and drift by, square metres.
    places, variances
        (k, 2) places along a bent frame and (k,) variances there, square metres, which take the place of the registration's; empty for a
        rigid one.
    """

    label: str
    origin: FloatArray
    covariance: FloatArray
    offset: float
    places: FloatArray = field(default_factory=lambda: np.zeros((0, 2)))
    variances: FloatArray = field(default_factory=lambda: np.zeros(0))

    @classmethod
    def read(cls, info: EpochInfo, bends: Iterable[Row]) -> FrameHeights:
        """Of one epoch, from its row and the rows of ``frame_errors``.

        Raises
        ------
        InputError
            The record of the transformation is incomplete or damaged.
        """
        if not info.transformation:
            return cls(label=info.label, origin=np.zeros(3), covariance=np.zeros((7, 7)), offset=0.0)
        own = [row for row in bends if row["epoch"] == info.label and row["known_by"] == "targets" and row["geom"] is not None]
        return cls(
            label=info.label,
            origin=record_numbers(info.transformation, "origin_to"),
            covariance=record_numbers(info.transformation, "covariance"),
            offset=float(common_variance(info.settings)[2]),
            places=np.array([row["geom"][:2] for row in own], dtype=np.float64).reshape(-1, 2),
            variances=np.array([row["sd_h"] for row in own], dtype=np.float64) ** 2,
        )

    def single(self, places: FloatArray) -> FloatArray:
        """(n,) variance of the height of each of (n, 3) places by the frame, square metres."""
        if len(self.places):
            return self._bent(places)
        rows = self._rows(places)
        return np.asarray(np.einsum("ni,ij,nj->n", rows, self.covariance, rows) + self.offset)

    def mean(self, places: FloatArray) -> float:
        """Variance of the mean height of (n, 3) places by the frame, square metres: it does not become less with their number."""
        if len(self.places):
            return float(self._bent(places).mean())
        row = self._rows(places).mean(axis=0)
        return float(row @ self.covariance @ row) + self.offset

    def _rows(self, places: FloatArray) -> FloatArray:
        """(n, 7) derivative of the height of (n, 3) places by the parameters of the registration."""
        east, north, up = (places - self.origin).T
        rows = np.zeros((len(places), 7))
        rows[:, 2], rows[:, 3], rows[:, 4], rows[:, 6] = 1.0, north, -east, up
        return rows

    def _bent(self, places: FloatArray) -> FloatArray:
        """(n,) variances where the bent frame is stated nearest to each place."""
        distances = np.linalg.norm(places[:, None, :2] - self.places[None], axis=2)
        return np.asarray(self.variances[np.argmin(distances, axis=1)])
