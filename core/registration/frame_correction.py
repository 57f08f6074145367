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
from ..common.axis import Axis, straight_axis

GAP_SPACINGS = 4.0
"""Distance of rows that follow each other, over their usual one, between which there is no structure on one that turns."""


@dataclass(frozen=True, eq=False, kw_only=True)
class FrameCorrection:
    """Error of one epoch along the structure.

    Attributes
    ----------
    line
        On which chainage is counted; None for a rigid frame.
    chainage
        (k,) ascending, metres; empty for a rigid frame.
    errors, sds
        (k, 3) registered cloud less control, and standard deviations, metres.
    """

    line: Axis | None
    chainage: FloatArray
    errors: FloatArray
    sds: FloatArray

    @classmethod
    def none(cls) -> FrameCorrection:
        """Of a rigid frame."""
        return cls(line=None, chainage=np.zeros(0), errors=np.zeros((0, 3)), sds=np.zeros((0, 3)))

    @classmethod
    def from_rows(cls, rows: Iterable[Mapping[str, Any]], epoch: str) -> FrameCorrection:
        """From rows of ``frame_errors`` with their ``geometry`` (or ``geom``): those by which targets know the epoch."""
        own = [row for row in rows if row["epoch"] == epoch and row["known_by"] == "targets"]
        if len(own) < 2:
            return cls.none()
        places = np.array([np.asarray(row.get("geometry", row.get("geom")), dtype=np.float64)[:2] for row in own])
        line, chainage = _line_through(places, np.array([float(row["along"]) for row in own]))
        order = np.argsort(chainage)
        errors = np.array([[row["de"], row["dn"], row["dh"]] for row in own])[order]
        sds = np.array([[row["sd_e"], row["sd_n"], row["sd_h"]] for row in own])[order]
        return cls(line=line, chainage=chainage[order], errors=errors, sds=sds)

    def at(self, points: FloatArray) -> FloatArray:
        """(n, 3) error of the registered cloud at (n, 3) points of the control frame, metres."""
        return self._between(points, self.errors)

    def variances_at(self, points: FloatArray) -> FloatArray:
        """(n, 3) variances of that error, square metres."""
        return self._between(points, self.sds) ** 2

    def _between(self, points: FloatArray, values: FloatArray) -> FloatArray:
        if self.line is None:
            return np.zeros((len(points), 3))
        along = self.line.locate(points)[0]
        return np.column_stack([np.interp(along, self.chainage, values[:, axis]) for axis in range(3)])

    def as_settings(self) -> dict[str, Any]:
        """Plain numbers that tell one correction from another."""
        corners = [] if self.line is None else self.line.corners.tolist()
        return {"chainage": self.chainage.tolist(), "errors": self.errors.tolist(), "line": corners}


def _line_through(places: FloatArray, along: FloatArray) -> tuple[Axis, FloatArray]:
    """Line of (k, 2) places that lie ``along`` (k,) metres of the structure, and their chainage on it, metres.

    The line is straight where the run counted so, within the distance of the places.
    """
    straight = straight_axis(places)
    projected, spacing = straight.locate(places)[0], float(np.ptp(along)) / (len(along) - 1)
    stated, seen = along - along.mean(), projected - projected.mean()
    if min(float(np.abs(stated - seen).max()), float(np.abs(stated + seen).max())) <= spacing:
        return straight, projected
    order = np.argsort(along)
    steps = np.linalg.norm(np.diff(places[order], axis=0), axis=1)
    line = Axis(places[order], tuple(np.flatnonzero(steps > GAP_SPACINGS * np.median(steps)).tolist()))
    chainage = np.zeros(len(along))
    chainage[order] = np.append(0.0, np.cumsum(steps))
    return line, chainage
