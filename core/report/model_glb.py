"""As-built model as binary glTF 2.0: one mesh a solid and class, one node a unit with its pose and properties.

glTF is right-handed with the y axis up and is read in single precision, so the root node turns the survey's axes and the nodes below
hold coordinates less the model's reduction point, which stands in the scene's ``extras``.
"""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np

from ..armour.as_built import AsBuilt, Solid
from ..model.facets import triangulated
from ..results.class_colours import class_colour

FLOAT, UNSIGNED_SHORT = 5126, 5123
ARRAY, ELEMENT_ARRAY = 34962, 34963

GLB_MARK = '"generator":"tetratrack"'


def glb(model: AsBuilt) -> bytes:
    """Bytes of the .glb file."""
    binary = bytearray()
    views: list[dict[str, Any]] = []
    accessors: list[dict[str, Any]] = []
    for solid in model.solids:
        _add_solid(solid, binary, views, accessors)
    classes = sorted({unit.kind for unit in model.units})
    used = sorted({(unit.solid, unit.kind) for unit in model.units})
    mesh_of = {key: k for k, key in enumerate(used)}
    nodes: list[dict[str, Any]] = []
    for unit in model.units:
        nodes.append(
            {
                "name": unit.unit_id,
                "mesh": mesh_of[unit.solid, unit.kind],
                "translation": [round(float(v), 4) for v in unit.shape.centre - model.offset],
                "rotation": list(unit.quaternion),
                "extras": unit.properties,
            }
        )
    half = float(np.sqrt(0.5))
    nodes.append({"name": model.name, "rotation": [-half, 0.0, 0.0, half], "children": list(range(len(model.units)))})
    document = {
        "asset": {"version": "2.0", "generator": "tetratrack"},
        "scene": 0,
        "scenes": [{"name": model.name, "nodes": [len(nodes) - 1], "extras": _frame(model)}],
        "nodes": nodes,
        "meshes": [
            {
                "name": f"{model.solids[solid].unit.name} {kind}",
                "primitives": [
                    {
                        "attributes": {"POSITION": 3 * solid, "NORMAL": 3 * solid + 1},
                        "indices": 3 * solid + 2,
                        "material": classes.index(kind),
                    }
                ],
            }
            for solid, kind in used
        ],
        "materials": [_material(kind) for kind in classes],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(binary)}],
    }
    text = json.dumps(document, ensure_ascii=False, separators=(",", ":")).encode("utf-8")
    text += b" " * (-len(text) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + bytes(binary)
    return struct.pack("<III", 0x46546C67, 2, 12 + len(body)) + body


def _frame(model: AsBuilt) -> dict[str, Any]:
    return {
        "crs": model.crs.name,
        "epsg": model.crs.epsg,
        "epoch": model.epoch,
        "time": None if model.time is None else model.time.isoformat(),
        "offset": [float(v) for v in model.offset],
        "axes": "nodes under the root: x easting, y northing, z height, metres less offset",
    }


def _material(kind: str) -> dict[str, Any]:
    # colours of the palette are sRGB, factors of glTF are linear
    rgb = np.array([int(class_colour(kind)[k : k + 2], 16) / 255 for k in (1, 3, 5)])
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    return {
        "name": kind,
        "pbrMetallicRoughness": {
            "baseColorFactor": [round(float(v), 4) for v in (*linear, 1)],
            "metallicFactor": 0,
            "roughnessFactor": 0.9,
        },
    }


def _add_solid(solid: Solid, binary: bytearray, views: list[dict[str, Any]], accessors: list[dict[str, Any]]) -> None:
    """Append corners, normals and triangles of a solid: smooth around the cones, with an edge at the end discs."""
    corners, normals, indices = triangulated(solid.faces)
    points = corners.astype("<f4")
    for content, kind, component, target in (
        (points, "VEC3", FLOAT, ARRAY),
        (normals.astype("<f4"), "VEC3", FLOAT, ARRAY),
        (indices.reshape(-1).astype("<u2"), "SCALAR", UNSIGNED_SHORT, ELEMENT_ARRAY),
    ):
        binary += b"\0" * (-len(binary) % 4)
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": content.nbytes, "target": target})
        accessor: dict[str, Any] = {"bufferView": len(views) - 1, "componentType": component, "count": len(content), "type": kind}
        if content is points:
            accessor |= {"min": [float(v) for v in points.min(axis=0)], "max": [float(v) for v in points.max(axis=0)]}
        accessors.append(accessor)
        binary += content.tobytes()
    binary += b"\0" * (-len(binary) % 4)
