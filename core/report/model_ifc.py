"""As-built model as IFC4X3 (ISO 16739-1:2024): a breakwater, its units as elements with pose, uncertainty and movement.

Geometry is held once a solid and class and mapped to every unit; the survey CRS stands as IfcProjectedCRS with an IfcMapConversion from
the model's reduction point. The file is written as plain STEP (ISO 10303-21), which needs no library.
"""

from __future__ import annotations

import uuid
from collections.abc import Sequence
from datetime import UTC, datetime
from typing import Any

import numpy as np

from ..armour.as_built import AsBuilt, BuiltUnit, Solid
from ..common.software import software_version
from ..results.class_colours import class_colour

SCHEMA = "IFC4X3_ADD2"
PROPERTY_SETS = {
    "Tetratrack_Unit": ("unit_id", "unit_type", "height", "status", "class", "coverage"),
    "Tetratrack_Uncertainty": ("sd_e", "sd_n", "sd_h", "sd_rotation_deg"),
    "Tetratrack_Movement": ("epoch_from", "datum", "de", "dn", "dh", "d_3d", "rotation_deg", "p_value", "significant"),
}
"""Properties of a unit by set; lengths in metres, angles in degrees."""
_ALPHABET = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$"


class Reference(int):
    """Number of an entity of the file."""


class Keyword(str):
    """A value of an enumeration, or ``*``, written as it is."""

    __slots__ = ()


class Typed:
    """A value with its type, as a property wants it."""

    def __init__(self, kind: str, value: Any) -> None:
        self.kind, self.value = kind, value


class StepFile:
    """Entities in the order written; names of the file are made from its own name, so that one model has the same ones each time."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.lines: list[str] = []

    def add(self, entity: str, *values: Any) -> Reference:
        """Append an entity."""
        self.lines.append(f"#{len(self.lines) + 1}={entity}({','.join(encode(value) for value in values)});")
        return Reference(len(self.lines))

    def rooted(self, entity: str, key: str, *values: Any) -> Reference:
        """Append an entity with a global identifier and no owner history."""
        return self.add(entity, global_id(f"{self.name}/{entity}/{key}"), None, *values)


def ifc(model: AsBuilt) -> str:
    """Text of the .ifc file."""
    file = StepFile(f"{model.name}/{model.epoch}")
    origin = file.add("IFCCARTESIANPOINT", (0.0, 0.0, 0.0))
    frame = file.add("IFCAXIS2PLACEMENT3D", origin, None, None)
    context = file.add("IFCGEOMETRICREPRESENTATIONCONTEXT", None, "Model", 3, 1e-5, frame, None)
    body = file.add(
        "IFCGEOMETRICREPRESENTATIONSUBCONTEXT", "Body", "Model", *([Keyword("*")] * 4), context, None, Keyword(".MODEL_VIEW."), None
    )
    _add_frame(file, model, context)
    project = file.rooted("IFCPROJECT", "project", *[model.name, None, None, None, None, [context], _units(file)])
    ground = file.add("IFCLOCALPLACEMENT", None, frame)
    site = file.rooted("IFCSITE", "site", *[model.name, None, None, ground, None, None, Keyword(".ELEMENT."), None, None, None, None, None])
    place = file.add("IFCLOCALPLACEMENT", ground, frame)
    title = f"{model.name}, {model.epoch}"
    facility = file.rooted(
        "IFCMARINEFACILITY", "facility", *[title, None, None, place, None, None, Keyword(".ELEMENT."), Keyword(".BREAKWATER.")]
    )
    file.rooted("IFCRELAGGREGATES", "site", None, None, project, [site])
    file.rooted("IFCRELAGGREGATES", "facility", None, None, site, [facility])
    maps = _add_solids(file, model, body, frame)
    still = file.add("IFCCARTESIANTRANSFORMATIONOPERATOR3D", None, None, origin, None, None)
    elements: list[Reference] = []
    of_solid: dict[int, list[Reference]] = {}
    for unit in model.units:
        element = _add_unit(file, model, unit, place, body, maps[unit.solid, unit.kind], still)
        elements.append(element)
        of_solid.setdefault(unit.solid, []).append(element)
    file.rooted("IFCRELCONTAINEDINSPATIALSTRUCTURE", "units", None, None, elements, facility)
    for number, members in of_solid.items():
        unit_type = model.solids[number].unit
        own = [reference for (solid, _), reference in maps.items() if solid == number]
        kind = file.rooted(
            "IFCBUILDINGELEMENTPROXYTYPE", f"{number}", *[unit_type.name, None, None, None, own, None, "tetrapod", Keyword(".ELEMENT.")]
        )
        file.rooted("IFCRELDEFINESBYTYPE", f"{number}", None, None, members, kind)
    return _head(title) + "\n".join(file.lines) + "\nENDSEC;\nEND-ISO-10303-21;\n"


IFC_MARK = "'tetratrack "


def _head(title: str) -> str:
    moment = datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%S")
    software = encode(f"tetratrack {software_version()}")
    return (
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('ViewDefinition [ReferenceView]'),'2;1');\n"
        f"FILE_NAME({encode(title)},'{moment}',(''),(''),{software},{software},'');\nFILE_SCHEMA(('{SCHEMA}'));\nENDSEC;\nDATA;\n"
    )


def _units(file: StepFile) -> Reference:
    kinds = (("LENGTHUNIT", "METRE"), ("AREAUNIT", "SQUARE_METRE"), ("VOLUMEUNIT", "CUBIC_METRE"), ("PLANEANGLEUNIT", "RADIAN"))
    units = [file.add("IFCSIUNIT", Keyword("*"), Keyword(f".{kind}."), None, Keyword(f".{name}.")) for kind, name in kinds]
    return file.add("IFCUNITASSIGNMENT", units)


def _add_frame(file: StepFile, model: AsBuilt, context: Reference) -> None:
    """Where the origin of the model lies in the survey CRS."""
    name = model.crs.name if model.crs.epsg is None else f"EPSG:{model.crs.epsg}"
    target = file.add("IFCPROJECTEDCRS", name or "LOCAL", model.crs.name or None, None, None, None, None, None)
    east, north, height = (float(v) for v in model.offset)
    file.add("IFCMAPCONVERSION", *[context, target, east, north, height, 1.0, 0.0, 1.0])


def _add_solids(file: StepFile, model: AsBuilt, body: Reference, frame: Reference) -> dict[tuple[int, str], Reference]:
    """Representation maps by solid and class."""
    styles = {kind: _style(file, kind) for kind in sorted({unit.kind for unit in model.units})}
    found = {}
    for number, kind in sorted({(unit.solid, unit.kind) for unit in model.units}):
        surface = _face_set(file, model.solids[number])
        file.add("IFCSTYLEDITEM", surface, [styles[kind]], None)
        shape = file.add("IFCSHAPEREPRESENTATION", body, "Body", "Tessellation", [surface])
        found[number, kind] = file.add("IFCREPRESENTATIONMAP", frame, shape)
    return found


def _style(file: StepFile, kind: str) -> Reference:
    red, green, blue = (int(class_colour(kind)[k : k + 2], 16) / 255 for k in (1, 3, 5))
    shading = file.add("IFCSURFACESTYLESHADING", file.add("IFCCOLOURRGB", None, red, green, blue), 0.0)
    return file.add("IFCSURFACESTYLE", kind, Keyword(".BOTH."), [shading])


def _face_set(file: StepFile, solid: Solid) -> Reference:
    corners, lateral, ends = solid.faces.welded()
    fans = [np.column_stack([np.full(len(end) - 2, end[0]), end[1:-1], end[2:]]) for end in ends]
    triangles = np.vstack([lateral[:, [0, 1, 2]], lateral[:, [0, 2, 3]], *fans]) + 1
    points = file.add("IFCCARTESIANPOINTLIST3D", [tuple(round(float(v), 6) for v in corner) for corner in corners], None)
    return file.add("IFCTRIANGULATEDFACESET", points, None, True, [tuple(triangle) for triangle in triangles.tolist()], None)


def _add_unit(
    file: StepFile, model: AsBuilt, unit: BuiltUnit, place: Reference, body: Reference, solid: Reference, still: Reference
) -> Reference:
    centre = file.add("IFCCARTESIANPOINT", tuple(round(float(v), 5) for v in unit.shape.centre - model.offset))
    axis, first = (file.add("IFCDIRECTION", tuple(float(v) for v in unit.shape.rotation[:, k])) for k in (2, 0))
    placed = file.add("IFCLOCALPLACEMENT", place, file.add("IFCAXIS2PLACEMENT3D", centre, axis, first))
    mapped = file.add("IFCMAPPEDITEM", solid, still)
    shape = file.add("IFCSHAPEREPRESENTATION", body, "Body", "MappedRepresentation", [mapped])
    product = file.add("IFCPRODUCTDEFINITIONSHAPE", None, None, [shape])
    element = file.rooted(
        "IFCBUILDINGELEMENTPROXY",
        unit.unit_id,
        *[unit.unit_id, None, model.solids[unit.solid].unit.name, placed, product, unit.unit_id, Keyword(".ELEMENT.")],
    )
    known = unit.properties
    for title, names in PROPERTY_SETS.items():
        values = [(name, known[name]) for name in names if name in known]
        if not values:
            continue
        properties = [file.add("IFCPROPERTYSINGLEVALUE", name, None, _typed(value), None) for name, value in values]
        held = file.rooted("IFCPROPERTYSET", f"{unit.unit_id}/{title}", title, None, properties)
        file.rooted("IFCRELDEFINESBYPROPERTIES", f"{unit.unit_id}/{title}", None, None, [element], held)
    return element


def _typed(value: Any) -> Typed:
    if isinstance(value, bool):
        return Typed("IFCBOOLEAN", value)
    return Typed("IFCREAL", float(value)) if isinstance(value, int | float) else Typed("IFCLABEL", str(value))


def encode(value: Any) -> str:
    """A value in the exchange structure of ISO 10303-21."""
    if value is None:
        return "$"
    if isinstance(value, Typed):
        return f"{value.kind}({encode(value.value)})"
    if isinstance(value, Keyword):
        return str(value)
    if isinstance(value, bool):
        return ".T." if value else ".F."
    if isinstance(value, Reference):
        return f"#{int(value)}"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        text = repr(value).upper()
        return text if "." in text else text.replace("E", ".E") if "E" in text else f"{text}."
    if isinstance(value, str):
        return f"'{_text(value)}'"
    if isinstance(value, Sequence):
        return f"({','.join(encode(item) for item in value)})"
    raise TypeError(f"{type(value).__name__} has no form in a STEP file")


def _text(text: str) -> str:
    """A string with quotes doubled and everything beyond ASCII as UTF-16."""
    parts = []
    for character in text:
        if character in "'\\":
            parts.append(character * 2)
        elif " " <= character <= "~":
            parts.append(character)
        else:
            parts.append(f"\\X2\\{character.encode('utf-16-be').hex().upper()}\\X0\\")
    return "".join(parts)


def global_id(name: str) -> str:
    """Identifier of 22 characters (IfcGloballyUniqueId) that follows from a name."""
    number = uuid.uuid5(uuid.NAMESPACE_URL, f"https://tetratrack/{name}").int
    digits = []
    for _ in range(22):
        number, digit = divmod(number, 64)
        digits.append(_ALPHABET[digit])
    return "".join(reversed(digits))
