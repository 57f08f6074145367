"""What the web page needs to show units on a map one can walk in, in a table and as bodies, as one JSON value."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from markupsafe import Markup

from ..common.arrays import FloatArray
from ..model.facets import facets, plan_outline, triangulated
from ..model.outline import PlacedShape
from ..results.class_colours import CLASS_COLOURS, class_colour
from ..results.geopackage_reader import EpochPair, Row
from ..results.unit_rows import UnitRow
from .displacement_arrows import displacement_arrows, usual_height
from .number_formats import further_decimals

Shapes = Mapping[str, PlacedShape]

TEMPLATES = Path(__file__).parent / "templates"
OUTLINE_DIRECTIONS = 24
"""Corners of a leg's outline: on a screen, a chord of 24 cannot be told from the curve."""

OUTLINE_STEPS = 100
"""Steps to a metre in which outlines of units of a metre and more are written; for a model of a tenth of a metre, ten times as many."""


def explorer_data(
    rows: Sequence[UnitRow],
    shapes: tuple[Shapes, Shapes],
    control: Sequence[Row],
    decisions: Mapping[str, str],
    pair: EpochPair,
    translate: Callable[[str], str],
) -> dict[str, Any]:
    """Units of an epoch pair for the page's script.

    Parameters
    ----------
    rows
        Units to show; those without a place are left out.
    shapes
        Shapes by unit in the earlier and in the later epoch.
    control
        Rows of ``control_residuals`` of the later epoch.
    decisions
        Reviewers' decisions by unit, translated.
    """
    shown = [(row, row.place) for row in rows if row.place is not None]
    origin: FloatArray = np.zeros(3)
    if shown:
        origin = np.asarray(np.round(np.array([place for _, place in shown]).mean(axis=0)))
    solids: dict[tuple[float, ...], int] = {}
    bodies: list[dict[str, Any]] = []
    units = []
    height = usual_height(rows)
    further = further_decimals(height)
    steps = OUTLINE_STEPS * 10**further
    for row, place in shown:
        ends = [found.get(row.unit_id) for found in shapes]
        record = _numbers(row, 2 + further) | {"place": _rounded(place - origin, 3), "decision": decisions.get(row.unit_id, "")}
        seen = [shape for shape in ends if shape is not None]
        if seen:
            record["solid"] = _solid(seen[-1], solids, bodies)
            outline = plan_outline(seen[-1], OUTLINE_DIRECTIONS) - origin[:2]
            # whole numbers keep the page small
            record["outline"] = np.round(steps * outline).astype(int).reshape(-1).tolist()
        for name, shape in zip(("early", "late"), ends, strict=True):
            if shape is not None:
                record[name] = _rounded(shape.centre - origin, 4) + _rounded(shape.rotation.reshape(-1), 5)
        units.append(record)
    targets = [
        {"id": str(row["point_id"]), "place": _rounded(row["geom"] - origin, 2), "used": bool(row["used"])}
        for row in control
        if row["geom"] is not None and row["epoch"] == pair.epoch_to
    ]
    arrows = displacement_arrows([row for row, _ in shown])
    drawn = np.column_stack([arrows.starts - origin[:2], arrows.shown, arrows.cut])
    return {
        "origin": [float(v) for v in origin],
        "height": round(height, 3),
        "outline_steps": steps,
        "decimals": 1 + further,
        "arrows": {"times": arrows.times, "drawn": [_rounded(line, 3) for line in drawn]},
        "epochs": [pair.epoch_from, pair.epoch_to],
        "classes": [{"key": kind, "name": translate(kind), "colour": class_colour(kind)} for kind in CLASS_COLOURS],
        "solids": bodies,
        "units": units,
        "control": targets,
    }


def page_script(explorer: Mapping[str, Any] | None) -> dict[str, Any]:
    """Data of the page's own script, the script, and its hash for the page's security policy, which lets no other one run."""
    if explorer is None:
        return {"explorer": None}
    script = (TEMPLATES / "explorer.js").read_text(encoding="utf-8")
    digest = base64.b64encode(hashlib.sha256(script.encode("utf-8")).digest()).decode("ascii")
    # a file of this package, not a text from a result
    return {"explorer": explorer, "script": Markup(script), "script_hash": f"sha256-{digest}"}  # noqa: S704  # nosec B704


def _numbers(row: UnitRow, decimals: int) -> dict[str, Any]:
    """Measures of a unit in centimetres, of that many decimals, and degrees, None where there is none."""
    vector = [None] * 3 if row.vector is None else [round(100 * float(v), decimals) for v in row.vector]
    return {
        "id": row.unit_id,
        "kind": row.kind,
        "d": None if row.d_3d is None else round(100 * row.d_3d, decimals),
        "sd": None if row.sd_3d is None else round(100 * row.sd_3d, decimals),
        "e": vector[0],
        "n": vector[1],
        "h": vector[2],
        "turn": None if row.rotation_deg is None else round(row.rotation_deg, 2),
        "p": None if row.p_value is None else float(f"{row.p_value:.2g}"),
        "significant": row.significant,
        "broken": list(row.broken_legs),
    }


def _solid(shape: PlacedShape, known: dict[tuple[float, ...], int], bodies: list[dict[str, Any]]) -> int:
    """Number of the solid of a unit's size; units whose radius differs by millimetres share one."""
    size = (round(shape.leg_length, 2), round(shape.radius, 1))
    if size not in known:
        known[size] = len(bodies)
        still = replace(shape, centre=np.zeros(3), rotation=np.eye(3))
        corners, normals, indices = triangulated(facets(still))
        bodies.append(
            {
                "corners": _rounded(corners.reshape(-1), 3),
                "normals": _rounded(normals.reshape(-1), 3),
                "triangles": indices.reshape(-1).tolist(),
                "reach": round(float(np.linalg.norm(corners, axis=1).max()), 3),
            }
        )
    return known[size]


def _rounded(values: Any, decimals: int) -> list[float]:
    return [round(float(v), decimals) for v in np.asarray(values)]
