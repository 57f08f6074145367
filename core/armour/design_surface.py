"""The surface of a design profile, and units against it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any, Literal

import numpy as np

from ..common.arrays import FloatArray
from ..common.axis import Axis
from ..common.errors import InputError
from ..model.outline import PlacedShape
from .as_built import AsBuilt, of_height
from .placement_plan import verdict

Reference = Literal["outer", "centre"]
STEP = 0.5
"""Distance of the corners that stand for a line: finer than a unit, so that the surface keeps to the lines between them. Metres, as the
lengths below of units of usual size (:func:`.as_built.of_height`)."""
ROUNDING = 0.005
"""Within which corners of a drawing lie above each other."""
LEAST_FACE = 0.05
"""Between heights of such corners, from which they are a vertical face."""
HALF_SLOPE = 0.01
"""To either side of a place whose slope is asked."""


@dataclass(frozen=True, eq=False)
class SweptSection:
    """One cross-section line drawn along the axis: offset (n,) from the axis, which never falls, and height (n,), metres.

    A vertical face are two corners at one offset, in their order across the axis.
    """

    axis: Axis
    offset: FloatArray
    height: FloatArray

    def heights(self, places: FloatArray) -> FloatArray:
        """(m,) design height under (m, >= 2) places; NaN beyond the ends of the line."""
        return np.asarray(np.interp(self.axis.locate(places)[1], self.offset, self.height, left=np.nan, right=np.nan))


@dataclass(frozen=True, eq=False)
class RuledSurface:
    """The surface between several lines: triangles between their corners, reduced by ``origin`` (3,)."""

    origin: FloatArray
    interpolate: Any

    def heights(self, places: FloatArray) -> FloatArray:
        """(m,) design height under (m, >= 2) places; NaN outside the lines."""
        reduced: FloatArray = np.asarray(self.interpolate(places[:, :2] - self.origin[:2]), dtype=np.float64)
        return np.asarray(reduced + self.origin[2])


DesignSurface = SweptSection | RuledSurface


def design_surface(lines: list[FloatArray], axis: Axis, height: float, source: Path | None = None) -> DesignSurface:
    """Surface of a design profile.

    Parameters
    ----------
    lines
        (n, 3) each. A single line is a cross-section, which is drawn along the axis; several are edges of the profile (crest, toe,
        berms), with plane faces between them.
    axis
        Of the structure.
    height
        H of the units, metres.
    source
        Their file, for what is said of it.

    Raises
    ------
    InputError
        The surface would have two heights at one place: a cross-section folds back, or edges lie one above the other.
    """
    if len(lines) == 1:
        return _swept(lines[0], axis, of_height(ROUNDING, height), source)
    from scipy.interpolate import LinearNDInterpolator
    from scipy.spatial import cKDTree

    corners = np.vstack([_dense(line, of_height(STEP, height)) for line in lines])
    origin = corners.mean(axis=0)
    reduced = corners - origin
    first, second = cKDTree(reduced[:, :2]).query_pairs(of_height(ROUNDING, height), output_type="ndarray").T
    if np.any(np.abs(reduced[first, 2] - reduced[second, 2]) > of_height(LEAST_FACE, height)):
        remedy = "Draw the foot of a vertical face a few centimetres before its top, or give the profile as one cross-section."
        raise InputError("has edges one above the other, which leave the faces between them open", source=source, remedy=remedy)
    return RuledSurface(origin, LinearNDInterpolator(reduced[:, :2], reduced[:, 2]))


def _swept(line: FloatArray, axis: Axis, rounding: float, source: Path | None) -> SweptSection:
    """A cross-section whichever way it was drawn, with corners ``rounding`` metres off."""
    offset, height = axis.locate(line)[1], line[:, 2]
    if offset[-1] < offset[0]:
        offset, height = offset[::-1], height[::-1]
    rising = np.maximum.accumulate(offset)
    if np.any(rising - offset > rounding):
        remedy = "Draw its surface alone, once from one side to the other, without overhangs."
        raise InputError("has a cross-section that folds back", source=source, remedy=remedy)
    return SweptSection(axis, rising, height)


def compare_with_profile(
    model: AsBuilt, surface: DesignSurface, axis: Axis, tolerance: float | None, reference: Reference = "outer"
) -> list[dict[str, Any]]:
    """Rows of ``profile_deviations``: units of an epoch across the design surface; those outside its lines are left out.

    Parameters
    ----------
    tolerance
        Metres that a unit may be off the design either way; None does not judge.
    reference
        What is judged: the outermost point (``outer``) of a unit, or its ``centre``.
    """
    centres = np.array([unit.shape.centre for unit in model.units])
    design = surface.heights(centres)
    slope = np.column_stack([_slope(surface, centres, axis_number, of_height(HALF_SLOPE, model.height)) for axis_number in (0, 1)])
    along = axis.locate(centres)[0]
    rows = []
    for k, unit in enumerate(model.units):
        if not np.isfinite([design[k], *slope[k]]).all():
            continue
        normal = np.array([-slope[k, 0], -slope[k, 1], 1.0]) / math.hypot(1.0, *slope[k])
        centre = float((centres[k, 2] - design[k]) * normal[2])
        outer = centre + support(unit.shape, normal)
        sds = [unit.row.get(name) for name in ("sd_e", "sd_n", "sd_h")]
        sd = None if any(value is None for value in sds) else float(np.linalg.norm(np.array(sds, dtype=np.float64) * normal))
        judged = outer if reference == "outer" else centre
        rows.append(
            {
                "geometry": centres[k],
                "unit_id": unit.unit_id,
                "epoch": model.epoch,
                "along": float(along[k]),
                "design_height": float(design[k]),
                "off_centre": centre,
                "off_outer": outer,
                "sd": sd,
                "verdict": verdict([(judged, sd, tolerance)]),
            }
        )
    return rows


def support(shape: PlacedShape, direction: FloatArray) -> float:
    """Distance of the outermost point of a unit from its centre along a unit vector (3,), metres."""
    along = shape.legs @ shape.rotation.T @ direction
    rim = shape.radius - shape.gradient * shape.leg_length
    return float(np.max(shape.leg_length * along + rim * np.sqrt(np.maximum(1 - along**2, 0))))


def _slope(surface: DesignSurface, places: FloatArray, axis_number: int, half: float) -> FloatArray:
    """(m,) rise of the surface per metre to the east (0) or north (1), ``half`` metres to either side."""
    step = np.zeros(2)
    step[axis_number] = half
    after, before = surface.heights(places[:, :2] + step), surface.heights(places[:, :2] - step)
    return np.asarray((after - before) / (2 * half))


def _dense(line: FloatArray, step: float) -> FloatArray:
    """Corners of a line and places between them, at most ``step`` metres apart in plan: the same ones where edges lie above each other."""
    parts = [line[:1]]
    for start, stop in pairwise(line):
        count = max(1, math.ceil(float(np.linalg.norm(stop[:2] - start[:2])) / step))
        parts.append(start + (np.arange(1, count + 1) / count)[:, None] * (stop - start))
    return np.vstack(parts)
