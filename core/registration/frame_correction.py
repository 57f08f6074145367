"""Error of an epoch's bent frame as a result states it, for those who go from the control frame back to the cloud.

A result holds the error at places along the structure (layer ``frame_errors``); between them it is interpolated linearly along the
structure, which misses the field by a millimetre where waves are 60 m long.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..common.arrays import FloatArray


@dataclass(frozen=True, eq=False, kw_only=True)
class FrameCorrection:
    """Error of one epoch along the structure.

    Attributes
    ----------
    origin, axis
        (2,) place and unit vector that chainage counts from and along, (easting, northing).
    chainage
        (k,) ascending, metres; empty for a rigid frame.
    errors, sds
        (k, 3) registered cloud less control, and standard deviations, metres.
    """

    origin: FloatArray
    axis: FloatArray
    chainage: FloatArray
    errors: FloatArray
    sds: FloatArray

    @classmethod
    def none(cls) -> FrameCorrection:
        """Of a rigid frame."""
        return cls(origin=np.zeros(2), axis=np.array([1.0, 0.0]), chainage=np.zeros(0), errors=np.zeros((0, 3)), sds=np.zeros((0, 3)))

    @classmethod
    def from_rows(cls, rows: Iterable[Mapping[str, Any]], epoch: str) -> FrameCorrection:
        """From rows of ``frame_errors`` with their ``geometry`` (or ``geom``): those by which targets know the epoch."""
        own = [row for row in rows if row["epoch"] == epoch and row["known_by"] == "targets"]
        if len(own) < 2:
            return cls.none()
        places = np.array([np.asarray(row.get("geometry", row.get("geom")), dtype=np.float64)[:2] for row in own])
        origin = places.mean(axis=0)
        axis = np.linalg.svd(places - origin, full_matrices=False)[2][0]
        chainage = (places - origin) @ axis
        order = np.argsort(chainage)
        errors = np.array([[row["de"], row["dn"], row["dh"]] for row in own])[order]
        sds = np.array([[row["sd_e"], row["sd_n"], row["sd_h"]] for row in own])[order]
        return cls(origin=origin, axis=axis, chainage=chainage[order], errors=errors, sds=sds)

    def at(self, points: FloatArray) -> FloatArray:
        """(n, 3) error of the registered cloud at (n, 3) points of the control frame, metres."""
        return self._between(points, self.errors)

    def variances_at(self, points: FloatArray) -> FloatArray:
        """(n, 3) variances of that error, square metres."""
        return self._between(points, self.sds) ** 2

    def _between(self, points: FloatArray, values: FloatArray) -> FloatArray:
        if not len(self.chainage):
            return np.zeros((len(points), 3))
        along = (points[:, :2] - self.origin) @ self.axis
        return np.column_stack([np.interp(along, self.chainage, values[:, axis]) for axis in range(3)])

    def as_settings(self) -> dict[str, Any]:
        """Plain numbers that tell one correction from another."""
        return {"chainage": self.chainage.tolist(), "errors": self.errors.tolist(), "origin": self.origin.tolist()}
