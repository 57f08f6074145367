"""The axis of a structure: chainage along it, and offsets across it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import InputError


@dataclass(frozen=True, eq=False)
class Axis:
    """A polyline in plan, which runs straight on before and after its ends.

    Attributes
    ----------
    corners
        (n, 2) easting and northing, metres.
    """

    corners: FloatArray

    def __post_init__(self) -> None:
        steps = np.linalg.norm(np.diff(self.corners, axis=0), axis=1)
        if len(self.corners) < 2 or not np.all(steps > 0):
            raise InputError("the axis needs two different corners or more", remedy="Give it as easting,northing pairs.")

    @property
    def lengths(self) -> FloatArray:
        """(n - 1,) lengths of its parts, metres."""
        return np.asarray(np.linalg.norm(np.diff(self.corners, axis=0), axis=1))

    def locate(self, places: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Chainage (m,) of the nearest place on the axis and offset (m,) from it, positive to the left, of (m, >= 2) places; metres."""
        lengths = self.lengths
        heading = np.diff(self.corners, axis=0) / lengths[:, None]
        begin = np.concatenate([[0.0], np.cumsum(lengths)[:-1]])
        from_start = places[:, None, :2] - self.corners[None, :-1]
        share = np.einsum("mki,ki->mk", from_start, heading)
        low = np.where(np.arange(len(lengths)) == 0, -np.inf, 0.0)
        high = np.where(np.arange(len(lengths)) == len(lengths) - 1, np.inf, lengths)
        inside = np.clip(share, low, high)
        aside = from_start - inside[..., None] * heading
        distance = np.linalg.norm(aside, axis=2)
        best = np.argmin(distance, axis=1)
        rows = np.arange(len(places))
        left = heading[best, 0] * from_start[rows, best, 1] - heading[best, 1] * from_start[rows, best, 0]
        return (begin + inside)[rows, best], distance[rows, best] * np.where(left < 0, -1.0, 1.0)

    def frame(self, along: float) -> tuple[FloatArray, FloatArray]:
        """Place (2,) at a chainage, and unit vector (2,) along the axis there."""
        lengths = self.lengths
        begin = np.concatenate([[0.0], np.cumsum(lengths)[:-1]])
        part = int(np.clip(np.searchsorted(begin, along, side="right") - 1, 0, len(lengths) - 1))
        heading = (self.corners[part + 1] - self.corners[part]) / lengths[part]
        return np.asarray(self.corners[part] + (along - begin[part]) * heading), np.asarray(heading)


def longest_direction(places: FloatArray) -> Axis:
    """The line through (m, >= 2) places along their longest horizontal direction, west (or south) end first."""
    middle = places[:, :2].mean(axis=0)
    flat = places[:, :2] - middle
    direction = np.linalg.svd(flat, full_matrices=False)[2][0] if len(flat) > 1 else np.array([1.0, 0.0])
    if (direction[0], direction[1]) < (0.0, 0.0):
        direction = -direction
    reach = flat @ direction
    ends = np.array([reach.min(), max(float(reach.max()), float(reach.min()) + 1.0)])
    return Axis(np.asarray(middle + ends[:, None] * direction))


def parse_axis(text: str) -> FloatArray:
    """(n, 2) corners of an axis written as ``e,n e,n ...``.

    Raises
    ------
    InputError
        It is not a list of two or more pairs of numbers.
    """
    try:
        axis = np.array([[float(value) for value in pair.split(",")] for pair in text.replace(";", " ").split()])
    except ValueError:
        axis = np.empty((0, 0))
    if axis.ndim != 2 or axis.shape[1:] != (2,) or len(axis) < 2 or not np.all(np.isfinite(axis)):
        raise InputError(f"the axis {text!r} is not a list of places", remedy="Write it as easting,northing easting,northing ...")
    return axis
