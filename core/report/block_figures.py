"""Pictures of the report that show units as blocks: a view of all of them, and maps of parts whose names can be read."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D

from ..common.arrays import FloatArray
from ..common.axis import main_direction
from ..model.facets import facets, plan_outline
from ..model.outline import PlacedShape
from ..results.class_colours import CLASS_COLOURS, class_colour
from ..results.unit_rows import UnitRow
from .damage import centreline_of
from .figures import Translate, drawn_as_uri, empty_figure, map_frame

DETAIL_UNITS = 100
"""Units on a map of a part; their names stay readable at the report's width."""
MOST_DETAILS = 40
ELEVATION = math.radians(35)
"""Height of the eye above the horizon."""


def block_view(rows: Sequence[UnitRow], shapes: Mapping[str, PlacedShape], _: Translate) -> str:
    """All units as blocks by class, seen across the structure's long side from above; '' where there is nothing to show."""
    shown = [(row, shapes[row.unit_id]) for row in rows if row.unit_id in shapes]
    if not shown:
        return ""
    centres = np.array([shape.centre for _row, shape in shown])
    right, up, towards = _view_axes(centres)
    faces, colours, depths = [], [], []
    sides = 12 if len(shown) <= 2000 else 6
    for row, shape in shown:
        body = facets(shape, sides).placed(shape.centre - centres.mean(axis=0), shape.rotation)
        colour = np.array(to_rgb(class_colour(row.kind)))
        for corners, normals in ((body.lateral, body.normals.reshape(-1, 3)), (body.rim, body.axes)):
            facing = normals @ towards
            seen = facing > 0
            faces += list(corners[seen] @ np.column_stack([right, up]))
            depths.append((corners[seen] @ towards).mean(axis=1))
            colours.append(colour * (0.45 + 0.55 * facing[seen])[:, None])
    order = np.argsort(np.concatenate(depths))
    tint = np.vstack(colours)[order]
    figure = empty_figure(7.0, 3.6)
    axes = figure.add_subplot()
    axes.add_collection(PolyCollection([faces[k] for k in order], facecolors=tint, edgecolors=tint, linewidths=0.15))
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_axis_off()
    present = [kind for kind in CLASS_COLOURS if any(row.kind == kind for row, _shape in shown)]
    handles = [
        Line2D([], [], marker="s", linestyle="", color=CLASS_COLOURS[kind], markeredgecolor="#5D6D7E", label=_(kind)) for kind in present
    ]
    axes.legend(handles=handles, fontsize=7, loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0, frameon=False)
    return drawn_as_uri(figure)


def detail_maps(rows: Sequence[UnitRow], shapes: Mapping[str, PlacedShape], _: Translate) -> list[str]:
    """Maps of consecutive parts along the structure with the names of the units; none where one map shows them all readably."""
    shown = [(row, row.place) for row in rows if row.place is not None]
    if len(shown) <= DETAIL_UNITS:
        return []
    places = np.array([place for _row, place in shown])
    along = centreline_of([row for row, _place in shown]).locate(places)[0]
    parts = np.array_split(np.argsort(along), min(math.ceil(len(shown) / DETAIL_UNITS), MOST_DETAILS))
    return [_detail_map([shown[k][0] for k in part], shapes, _) for part in parts]


def _detail_map(rows: Sequence[UnitRow], shapes: Mapping[str, PlacedShape], _: Translate) -> str:
    figure = empty_figure(7.0, 5.0)
    axes = figure.add_subplot()
    drawn = [row for row in rows if row.unit_id in shapes]
    outlines = [plan_outline(shapes[row.unit_id]) for row in drawn]
    colours = [class_colour(row.kind) for row in drawn]
    axes.add_collection(PolyCollection(outlines, facecolors=colours, edgecolors="#5D6D7E", linewidths=0.4))
    for row in rows:
        if row.place is not None:
            place = (float(row.place[0]), float(row.place[1]))
            name = axes.annotate(row.unit_id, place, fontsize=4.5, ha="center", va="center", color="#17202A")
            # names lie on the map; to ask each of them again in every pass of the layout takes half of the time
            name.set_in_layout(False)
    map_frame(axes, _)
    return drawn_as_uri(figure)


def _view_axes(centres: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Right, up and towards the eye, (3,) unit vectors: across the long side, from where the units lie lower."""
    along = np.append(main_direction(centres), 0.0)
    across = np.array([-along[1], along[0], 0.0])
    offsets = centres - centres.mean(axis=0)
    # the slope of a breakwater faces the sea: the eye stands over the low side
    if float(np.sum((offsets @ across) * offsets[:, 2])) > 0:
        across, along = -across, -along
    towards = math.cos(ELEVATION) * across + np.array([0.0, 0.0, math.sin(ELEVATION)])
    right = np.cross(np.array([0.0, 0.0, 1.0]), across)
    return right, np.cross(towards, right), towards
