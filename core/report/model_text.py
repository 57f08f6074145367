"""As-built model as Wavefront OBJ, and its poses as JSON."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from ..armour.as_built import AsBuilt, BuiltUnit
from ..results.class_colours import class_colour

POSES_FORMAT, POSES_VERSION = "tetratrack poses", 1
POSES_MARK = f'"format": "{POSES_FORMAT}"'
OBJ_MARK = "; metres, x easting, y northing, z height, less the offset"


def obj(model: AsBuilt) -> str:
    """OBJ with one object a unit, corners with the colour of its class; z is height, coordinates less the offset in its head."""
    lines = [
        " ".join(f"# {model.name}, epoch {model.epoch}".splitlines()),
        " ".join(f"# CRS {model.crs.name}{OBJ_MARK}".splitlines()),
        f"# offset {model.offset[0]:.0f} {model.offset[1]:.0f} {model.offset[2]:.0f}",
    ]
    first = 1
    welded = [solid.faces.welded() for solid in model.solids]
    for unit in model.units:
        corners, lateral, ends = welded[unit.solid]
        placed = corners @ unit.shape.rotation.T + (unit.shape.centre - model.offset)
        red, green, blue = (int(class_colour(unit.kind)[k : k + 2], 16) / 255 for k in (1, 3, 5))
        lines.append(f"o {one_word(unit.unit_id)}")
        lines += [f"v {x:.4f} {y:.4f} {z:.4f} {red:.3f} {green:.3f} {blue:.3f}" for x, y, z in placed]
        lines += ["f " + " ".join(str(first + k) for k in face) for faces in (lateral, ends) for face in faces.tolist()]
        first += len(corners)
    return "\n".join(lines) + "\n"


def poses(model: AsBuilt) -> str:
    """JSON of all poses; docs/models.md explains every key."""
    document = {
        "format": POSES_FORMAT,
        "version": POSES_VERSION,
        "survey": model.name,
        "epoch": model.epoch,
        "time": None if model.time is None else model.time.isoformat(),
        "crs": {"name": model.crs.name, "epsg": model.crs.epsg, "definition": model.crs.definition},
        "offset": [float(v) for v in model.offset],
        "types": [
            {
                "name": solid.unit.name,
                "height": solid.unit.height,
                "radius": solid.unit.radius,
                "gradient": solid.unit.gradient,
                "leg_length": solid.unit.leg_length,
                "opening": solid.unit.opening,
                "leg_directions": np.round(solid.unit.leg_directions, 9).tolist(),
                "volume": round(solid.unit.volume, 6),
            }
            for solid in model.solids
        ],
        "units": [_pose(unit, model) for unit in model.units],
    }
    return json.dumps(document, ensure_ascii=False, indent=1) + "\n"


def _pose(unit: BuiltUnit, model: AsBuilt) -> dict[str, Any]:
    record: dict[str, Any] = {
        "unit_id": unit.unit_id,
        "type": unit.solid,
        "translation": [round(float(v), 5) for v in unit.shape.centre - model.offset],
        "quaternion": [round(v, 9) for v in unit.quaternion],
        "radius": unit.shape.radius,
        "gradient": unit.shape.gradient,
    }
    record |= {name: value for name, value in unit.properties.items() if name not in record}
    if unit.row.get("covariance"):
        record["covariance"] = json.loads(unit.row["covariance"])
    return record


def one_word(text: str) -> str:
    """A name without white space, as formats want it whose items are separated by it."""
    return "_".join(text.split()) or "_"
