"""Rows of the layer ``placement``: how each unit of a result lies among its neighbours."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from ..model.outline import PlacedShape
from ..model.unit_types import UnitType
from ..results.unit_sizes import UnitSize, shape_of
from .placement import UnitPlacement, placement_of_units

Row = Mapping[str, Any]
COUNTED = ("found", "new", "relocated")
"""Values of ``units.status`` of units that are placed."""


def placement_rows(units: Iterable[Row], sizes: Sequence[UnitSize]) -> list[dict[str, Any]]:
    """Rows of ``placement`` of all epochs; none of an epoch where units of several heights lie side by side or are too few.

    Parameters
    ----------
    units
        Rows of layer ``units``; the place stands under ``geometry`` as the writer takes it.
    sizes
        What ``units`` does not say of the types of unit.
    """
    by_epoch: dict[str, list[tuple[Row, PlacedShape]]] = {}
    for row in units:
        place = row.get("geometry")
        if place is None or row.get("status") not in COUNTED:
            continue
        shape = shape_of({**row, "geom": np.asarray(place, dtype=np.float64)}, sizes)
        if shape is not None:
            by_epoch.setdefault(str(row["epoch"]), []).append((row, shape))
    rows = []
    for placed in by_epoch.values():
        heights = {float(row["height"]) for row, _ in placed if row.get("height") is not None}
        if len(heights) == 1:
            opening = sizes[0].opening if sizes else "tetrahedral"
            height = heights.pop()
            found = placement_of_units([shape for _, shape in placed], height, UnitType.tetrapod(1.0, opening=opening).symmetries)
            if found is not None:
                rows += [_row(row, shape, found, k) for k, (row, shape) in enumerate(placed)]
    return rows


def size_of_type(unit: UnitType) -> UnitSize:
    """The same of a type of unit."""
    return UnitSize(unit.name, unit.height, unit.leg_length, unit.opening)


def _row(row: Row, shape: PlacedShape, found: UnitPlacement, k: int) -> dict[str, Any]:
    diameter = found.nominal_diameter
    column = float(found.column[k])
    return {name: row.get(name) for name in ("unit_id", "epoch", "epoch_time", "epoch_until", "unit_type")} | {
        "geometry": shape.centre,
        "layer": found.layer[k],
        "area": found.cell[k],
        "packing": diameter**2 / found.cell[k],
        "spacing": found.spacing[k],
        "turn_deg": found.turn[k],
        "off_surface": found.off_surface[k],
        "off_surface_dn": found.off_surface[k] / diameter,
        "contacts": found.contacts[k],
        "free_gap": found.gap[k],
        "in_column": None if np.isnan(column) else bool(column),
    }
