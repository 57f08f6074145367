"""The axis of a structure: chainage along it, and offsets across it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .arrays import FloatArray, IntArray
from .errors import InputError

GROUP_PARTS = 12
"""Size of the groups in which places are located, in parts of the axis: each is held against the parts near it alone."""


@dataclass(frozen=True, eq=False)
class Axis:
    """A polyline in plan, which runs straight on before and after its ends.

    Attributes
    ----------
    corners
        (n, 2) easting and northing, metres.
    gaps
        Numbers of its parts that only lead from one arm to the next: chainage runs on over them, but no place lies there.
    """

    corners: FloatArray
    gaps: tuple[int, ...] = ()

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
        places = places[:, :2]
        parts = np.setdiff1d(np.arange(len(self.corners) - 1), self.gaps)
        along, offset = np.zeros(len(places)), np.zeros(len(places))
        key = np.floor(places / (GROUP_PARTS * float(self.lengths[parts].mean())))
        _, group = np.unique(key, axis=0, return_inverse=True)
        order = np.argsort(group.ravel(), kind="stable")
        for own in np.split(order, np.cumsum(np.bincount(group.ravel()))[:-1]):
            along[own], offset[own] = self._on_parts(places[own], self._near(places[own], parts))
        return along, offset

    def _near(self, places: FloatArray, parts: IntArray) -> IntArray:
        """Those of some parts that may be nearest to one of (m, 2) places."""
        if not len(places):
            return parts
        middle = places.mean(axis=0)
        distance = self._reached(middle[None], parts)[1][0]
        return np.asarray(parts[distance <= distance.min() + 2.001 * float(np.linalg.norm(places - middle, axis=1).max()) + 1e-6])

    def _reached(self, places: FloatArray, parts: IntArray) -> tuple[FloatArray, FloatArray]:
        """Unit vectors (k, 2) along parts, and distances (m, k) of places from them as long as they are, metres."""
        lengths = self.lengths[parts]
        heading = (self.corners[parts + 1] - self.corners[parts]) / lengths[:, None]
        from_start = places[:, None] - self.corners[None, parts]
        inside = np.clip(np.einsum("mki,ki->mk", from_start, heading), 0.0, lengths)
        return heading, np.linalg.norm(from_start - inside[..., None] * heading, axis=2)

    def _on_parts(self, places: FloatArray, parts: IntArray) -> tuple[FloatArray, FloatArray]:
        """:meth:`locate` of (m, 2) places on some parts."""
        heading, distances = self._reached(places, parts)
        # nearest to the axis as long as it is, so that what lies beyond an end is not sought across the structure
        best = np.argmin(distances, axis=1)
        heading, part = heading[best], parts[best]
        lengths = self.lengths
        from_start = places - self.corners[part]
        share = np.einsum("mi,mi->m", from_start, heading)
        low, high = np.where(part == 0, -np.inf, 0.0), np.where(part == len(lengths) - 1, np.inf, lengths[part])
        inside = np.clip(share, low, high)
        distance = np.linalg.norm(from_start - inside[:, None] * heading, axis=1)
        left = heading[:, 0] * from_start[:, 1] - heading[:, 1] * from_start[:, 0]
        return np.append(0.0, np.cumsum(lengths))[part] + inside, distance * np.where(left < 0, -1.0, 1.0)

    def frame(self, along: float) -> tuple[FloatArray, FloatArray]:
        """Place (2,) at a chainage, and unit vector (2,) along the axis there."""
        lengths = self.lengths
        begin = np.concatenate([[0.0], np.cumsum(lengths)[:-1]])
        part = int(np.clip(np.searchsorted(begin, along, side="right") - 1, 0, len(lengths) - 1))
        heading = (self.corners[part + 1] - self.corners[part]) / lengths[part]
        return np.asarray(self.corners[part] + (along - begin[part]) * heading), np.asarray(heading)


def main_direction(places: FloatArray) -> FloatArray:
    """(2,) unit vector along the longest horizontal direction of (k, >= 2) places, towards east or north, whichever it runs more."""
    if len(places) < 2:
        return np.array([1.0, 0.0])
    flat = places[:, :2] - places[:, :2].mean(axis=0)
    return upwards(np.linalg.eigh(flat.T @ flat)[1][:, 1])


def upwards(direction: FloatArray) -> FloatArray:
    """A (2,) direction or its opposite, so that the larger of its components is positive."""
    return np.asarray(-direction if direction[np.argmax(np.abs(direction))] < 0 else direction)


def straight_axis(places: FloatArray) -> Axis:
    """The line through (k, >= 2) places along their :func:`main_direction`, from the first to the last."""
    if not len(places):
        return Axis(np.array([[0.0, 0.0], [1.0, 0.0]]))
    middle, direction = places[:, :2].mean(axis=0), main_direction(places)
    reach = (places[:, :2] - middle) @ direction
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
