"""As-built model as DXF: one block a solid, inserted at every unit's pose, and outlines from above, on layers by class."""

from __future__ import annotations

import io
import re
from typing import Any

import numpy as np

from ..armour.as_built import AsBuilt, BuiltUnit, Solid
from ..common.errors import OutputError
from ..model.facets import SIDES, facets, plan_outline
from ..results.class_colours import class_colour

VERSION = "R2010"
METRES = 6
"""Value of $INSUNITS."""
LABEL_HEIGHT = 0.15
"""Height of the names over the height of a unit."""
MOST_BYTES = 255
"""Of a text beside an entity."""
_BREAKS = re.compile(r"[\x00-\x1f\x7f-\x9f\u2028\u2029]")
"""Control characters, and what Python's readers of lines take for the end of one."""
DXF_MARK = "999\ntetratrack model\n"
"""A comment, which no CAD program keeps: a drawing that was worked on is not taken for an earlier output."""


def dxf(model: AsBuilt) -> str:
    """Text of the .dxf file, coordinates in the survey CRS.

    Raises
    ------
    OutputError
        The library ezdxf is missing.
    """
    try:
        from ezdxf.document import Drawing
        from ezdxf.math import Matrix44
    except ImportError as error:
        raise OutputError("DXF needs the library ezdxf", remedy="Install tetratrack[model], or choose another ending.") from error
    drawing = Drawing.new(VERSION)
    drawing.header["$INSUNITS"] = METRES
    for kind in sorted({unit.kind for unit in model.units}):
        colour = int(class_colour(kind)[1:], 16)
        for prefix in ("unit", "outline", "name"):
            drawing.layers.add(layer_name(prefix, kind), true_color=colour)
    for number, solid in enumerate(model.solids):
        _add_block(drawing, f"UNIT{number + 1}", solid)
    space = drawing.modelspace()
    for unit in model.units:
        turn = np.eye(4)
        # ezdxf multiplies rows from the left
        turn[:3, :3] = unit.shape.rotation.T
        turn[3, :3] = unit.shape.centre
        insert = space.add_blockref(f"UNIT{unit.solid + 1}", (0, 0, 0), dxfattribs={"layer": layer_name("unit", unit.kind)})
        insert.transform(Matrix44(turn.reshape(-1)))
        insert.set_xdata("TETRATRACK", [(1000, one_line(f"{name}={value}")) for name, value in unit.properties.items()])
        _add_plan(space, unit)
    drawing.appids.add("TETRATRACK")
    text = io.StringIO()
    text.write(DXF_MARK)
    drawing.write(text)
    return text.getvalue()


def layer_name(prefix: str, kind: str) -> str:
    """Name of a layer, without the characters that DXF keeps for itself."""
    return re.sub(r"[^\w-]", "_", f"{prefix}_{kind}")


def one_line(text: str) -> str:
    """A text as a DXF may hold one: every line of the file is a value, and one of extended data has ``MOST_BYTES``."""
    return _BREAKS.sub(" ", text).encode("utf-8")[:MOST_BYTES].decode("utf-8", "ignore")


def _add_block(drawing: Any, name: str, solid: Solid) -> None:
    """Faces of a solid on layer 0, so that they take colour and layer of each insert."""
    block = drawing.blocks.new(name)
    body = facets(solid.unit.in_body, SIDES)
    for face in body.lateral:
        block.add_3dface([tuple(corner) for corner in face.tolist()])
    for ring in body.rim.tolist():
        # a convex ring as faces of four corners from its first one
        for k in range(1, len(ring) - 1, 2):
            block.add_3dface([ring[0], ring[k], ring[k + 1], ring[min(k + 2, len(ring) - 1)]])


def _add_plan(space: Any, unit: BuiltUnit) -> None:
    level = float(unit.shape.centre[2])
    outline = space.add_lwpolyline(
        [tuple(corner) for corner in plan_outline(unit.shape).tolist()],
        close=True,
        dxfattribs={"layer": layer_name("outline", unit.kind), "elevation": level},
    )
    outline.set_xdata("TETRATRACK", [(1000, one_line(f"unit_id={unit.unit_id}"))])
    text = space.add_text(
        one_line(unit.unit_id), height=LABEL_HEIGHT * float(unit.row["height"]), dxfattribs={"layer": layer_name("name", unit.kind)}
    )
    text.set_placement(tuple(unit.shape.centre.tolist()))
