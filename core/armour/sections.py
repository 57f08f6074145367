"""Cross-sections of the armour by chainage, and settlement along it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.axis import Axis
from ..model.facets import facets
from ..model.outline import PlacedShape
from ..results.geopackage_reader import Row
from ..results.unit_rows import Z_95
from .as_built import AsBuilt, of_height
from .contacts import reach_of
from .design_surface import DesignSurface

ANOTHER_PART = 2.0
"""Distance from the axis along a section over that from the axis at all, beyond which a unit belongs to another part of a bent axis."""
POINT_STEP, POINT_GAP = 0.10, 0.5
"""Length along a section for which one height of the points is stated, and without points from which their line is broken: metres, of units
of usual size (:func:`.as_built.of_height`)."""
POINT_SHARE = 0.95
"""Quantile of the points' heights that stands for the surface: the highest points are spray and birds."""
DESIGN_STEP = 0.25
"""Of the design's line, in the same way."""


@dataclass(frozen=True, eq=False)
class CutPlane:
    """A vertical plane across the axis: place (2,) on the axis, unit vector (2,) along it, and chainage, metres."""

    place: FloatArray
    heading: FloatArray
    along: float

    @property
    def left(self) -> FloatArray:
        """(2,) unit vector across the axis, to the left."""
        return np.array([-self.heading[1], self.heading[0]])

    def at(self, offset: FloatArray, height: FloatArray) -> FloatArray:
        """(n, 3) places in the CRS of offsets from the axis and heights."""
        return np.column_stack([self.place + offset[:, None] * self.left, height])


def cut_planes(axis: Axis, places: FloatArray, step: float) -> list[CutPlane]:
    """Planes every ``step`` metres along the axis, in the middles of reaches from the first unit to the last."""
    along = axis.locate(places)[0]
    count = max(1, math.ceil((float(along.max()) - float(along.min())) / step - 1e-9))
    begin = float(along.min())
    return [CutPlane(*axis.frame(begin + (k + 0.5) * step), begin + (k + 0.5) * step) for k in range(count)]


def cut_body(shape: PlacedShape, plane: CutPlane, sides: int = 24) -> list[FloatArray]:
    """Closed curves (n, 3) in which a plane cuts a unit, CRS; () where it does not."""
    corners, lateral, ends = facets(shape, sides).welded()
    corners = corners @ shape.rotation.T + shape.centre
    height = (corners[:, :2] - plane.place) @ plane.heading
    # a corner on the plane itself would be cut twice
    height = np.where(np.abs(height) < 1e-9, 1e-9, height)
    following: dict[tuple[int, int], tuple[int, int]] = {}
    for face in [*lateral.tolist(), *ends.tolist()]:
        around = [(a, b) for a, b in zip(face, face[1:] + face[:1], strict=True) if a != b and (height[a] > 0) != (height[b] > 0)]
        # faces are convex: one edge leads into the half space before the plane, and one out of it
        if len(around) == 2:
            into, out = around if height[around[0][0]] < 0 else around[::-1]
            following[_edge(into)] = _edge(out)
    curves = []
    while following:
        first, edge = following.popitem()
        ring = [first]
        while edge != first and edge in following:
            ring.append(edge)
            edge = following.pop(edge)
        share = np.array([height[a] / (height[a] - height[b]) for a, b in ring])
        places = corners[[a for a, _ in ring]] + share[:, None] * (corners[[b for _, b in ring]] - corners[[a for a, _ in ring]])
        curves.append(np.vstack([places, places[:1]]))
    return curves


def section_rows(
    models: Sequence[AsBuilt],
    axis: Axis,
    planes: Sequence[CutPlane],
    clouds: Mapping[str, Sequence[FloatArray]],
    design: DesignSurface | None,
) -> list[dict[str, Any]]:
    """Rows of ``sections``: blocks and points of every epoch, and the design.

    Parameters
    ----------
    models
        Units of every epoch.
    axis
        Of the structure: what is nearer to another part of it by far is of that part's sections.
    planes
        Where to cut.
    clouds
        By epoch, points (n, 3) near each plane; epochs without points are left out.
    design
        Surface of the design profile, if there is one.
    """
    rows = []
    height = min(model.height for model in models)
    reach = max((reach_of(unit.shape) for model in models for unit in model.units), default=1.0)
    beside = [np.abs(axis.locate(np.array([unit.shape.centre for unit in model.units]))[1]) for model in models]
    for number, plane in enumerate(planes, start=1):
        base = {"section": number, "along": plane.along}
        offsets: list[float] = []
        for model, distances in zip(models, beside, strict=True):
            for unit, distance in zip(model.units, distances, strict=True):
                away = unit.shape.centre[:2] - plane.place
                if abs(float(away @ plane.heading)) > reach or abs(float(away @ plane.left)) > ANOTHER_PART * distance + reach:
                    continue
                for curve in cut_body(unit.shape, plane):
                    rows.append(base | {"geometry": curve, "kind": "blocks", "unit_id": unit.unit_id, "epoch": model.epoch})
                    offsets += ((curve[:, :2] - plane.place) @ plane.left).tolist()
        if not offsets:
            continue
        for epoch, points in clouds.items():
            for line in _point_lines(points[number - 1], plane, min(offsets), max(offsets), height):
                rows.append(base | {"geometry": line, "kind": "points", "epoch": epoch})
        if design is not None:
            step = of_height(DESIGN_STEP, height)
            across = np.arange(min(offsets), max(offsets) + step, step)
            line = plane.at(across, design.heights(plane.at(across, np.zeros(len(across)))))
            line = line[np.isfinite(line[:, 2])]
            if len(line) > 1:
                rows.append(base | {"geometry": line, "kind": "design"})
    return rows


def settlement_rows(stretches: Sequence[Row], axis: Axis, level: float) -> list[dict[str, Any]]:
    """Rows of ``settlement`` from those of ``stretches``: each drawn at a height (metres) as the part of the axis about its units.

    Each pair of epochs counts chainage from the first of its own units, which a result does not name: the middle of its units is known.
    Rows without that place cannot be drawn and are left out.
    """
    rows = []
    for row in (row for row in stretches if row["geom"] is not None):
        middle, half_length = float(axis.locate(row["geom"][None])[0][0]), (float(row["along_to"]) - float(row["along_from"])) / 2
        ends = [axis.frame(middle + sign * half_length)[0] for sign in (-1, 1)]
        half = Z_95 * float(row["sd_h"])
        names = ("epoch_from", "epoch_to", "datum", "along_from", "along_to", "units", "dh", "significant")
        rows.append(
            {name: row[name] for name in names}
            | {
                "geometry": np.column_stack([np.array(ends), np.full(2, level)]),
                "low": float(row["dh"]) - half,
                "high": float(row["dh"]) + half,
            }
        )
    return rows


def _point_lines(points: FloatArray, plane: CutPlane, low: float, high: float, unit_height: float) -> list[FloatArray]:
    """Lines (n, 3) of the surface of points near a plane, broken where there are none for a while."""
    offset = (points[:, :2] - plane.place) @ plane.left
    kept = (offset >= low) & (offset <= high)
    offset, height = offset[kept], points[kept, 2]
    if not len(offset):
        return []
    step = of_height(POINT_STEP, unit_height)
    slot = np.floor((offset - low) / step).astype(np.int64)
    order = np.argsort(slot, kind="stable")
    slots, starts = np.unique(slot[order], return_index=True)
    tops = np.array([np.quantile(part, POINT_SHARE) for part in np.split(height[order], starts[1:])])
    across = low + (slots + 0.5) * step
    breaks = np.flatnonzero(np.diff(across) > of_height(POINT_GAP, unit_height)) + 1
    lines = [plane.at(a, h) for a, h in zip(np.split(across, breaks), np.split(tops, breaks), strict=True)]
    return [line for line in lines if len(line) > 1]


def _edge(pair: tuple[int, int]) -> tuple[int, int]:
    return (min(pair), max(pair))
