"""Rows of the layers that show units as bodies, made from those of ``units`` and ``displacements``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..model.facets import facets, plan_outline
from ..model.outline import PlacedShape
from .unit_sizes import UnitSize, shape_of

Row = Mapping[str, Any]
BODIES = frozenset({"unit_outlines", "unit_surfaces"})
"""Layers that show units as bodies."""


def body_rows(units: Iterable[Row], displacements: Iterable[Row], sizes: Sequence[UnitSize]) -> dict[str, list[dict[str, Any]]]:
    """Rows of ``unit_outlines`` and ``unit_surfaces`` of all units that have a pose.

    Parameters
    ----------
    units
        Rows of layer ``units``; the place stands under ``geometry`` as the writer takes it, or ``geom`` as the reader gives it.
    displacements
        Rows of layer ``displacements``, whose class and length the bodies carry.
    sizes
        What ``units`` does not say of the types of unit.
    """
    motion = {(row["unit_id"], row["epoch_to"]): row for row in displacements if row["feature"] == "centre"}
    outlines, surfaces = [], []
    for row in units:
        place = row["geometry"] if "geometry" in row else row.get("geom")
        shape = shape_of({**row, "geom": None if place is None else np.asarray(place, dtype=np.float64)}, sizes)
        if shape is None:
            continue
        moved = motion.get((row["unit_id"], row["epoch"]))
        common = {name: row.get(name) for name in ("unit_id", "epoch", "epoch_time", "epoch_until", "unit_type", "status")}
        common["class"] = row.get("status") if moved is None else moved["class"]
        common["d_3d"] = None if moved is None else moved["d_3d"]
        outline = plan_outline(shape)
        level = np.column_stack([outline, np.full(len(outline), shape.centre[2])])
        outlines.append(common | {"geometry": level, "area": polygon_area(outline - shape.centre[:2])})
        surfaces.append(common | {"geometry": faces_of(shape)})
    return {"unit_outlines": outlines, "unit_surfaces": surfaces}


def faces_of(shape: PlacedShape) -> list[FloatArray]:
    """Faces of a unit in the CRS as the writer takes them: those along the legs (m, 4, 3), and the end discs (4, k, 3)."""
    placed = facets(shape).placed(shape.centre, shape.rotation)
    return [placed.lateral, placed.rim]


def polygon_area(corners: FloatArray) -> float:
    """Area within (n, 2) corners, positive where they run counter-clockwise."""
    following = np.roll(corners, -1, axis=0)
    return float(np.sum(corners[:, 0] * following[:, 1] - corners[:, 1] * following[:, 0]) / 2)
