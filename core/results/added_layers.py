"""Layers beside those that a run writes: what a review adds to a result, and the index of tiles."""

from __future__ import annotations

from .comparison_layers import COMPARISON_LAYERS
from .schema import LAYERS, Field, Layer

UNIT_ID = LAYERS["units"].fields[0]
EPOCH = LAYERS["units"].fields[1]

ADDED: dict[str, Layer] = {
    layer.name: layer
    for layer in (
        Layer(
            "unit_edits",
            "PointZ",
            "Corrections by hand, placeholders for units that were not found among them, one row an act",
            (
                Field("kind", "text", "delete, merge, split, pose, pick, placeholder, or undo, which takes another back"),
                UNIT_ID,
                EPOCH,
                Field("comment", "text", "editor's remark"),
                Field("editor", "text", "name of the editor"),
                Field("edited_at", "datetime", "time of the correction", "UTC"),
                Field("before", "text", "JSON: rows that it replaced"),
                Field("undone", "boolean", "it was taken back"),
                Field("undoes", "integer", "number of the correction that this one takes back"),
            ),
        ),
        Layer(
            "manual_picks",
            "PointZ",
            "Feature points picked by hand, beside the fit, one row a pick",
            (
                UNIT_ID,
                EPOCH,
                Field("feature", "text", "feature point: f123, f124, f134 or f234"),
                Field("picked_by", "text", "who picked it"),
                Field("picked_at", "datetime", "when it was picked", "UTC"),
            ),
        ),
    )
}
"""Layers that a review adds to a result."""


TILE_INDEX = Layer(
    "tiles",
    "PolygonZ",
    "Extents of point cloud tiles with what their headers and points say, one row a tile",
    (
        Field("file", "text", "file of the tile"),
        Field("points", "integer", "points in it"),
        Field("density", "real", "points per square metre where there are any"),
        Field("height_min", "real", "lowest point", "m"),
        Field("height_max", "real", "highest point", "m"),
        Field("crs", "text", "CRS that it declares"),
        Field("measured", "text", "day of its points by their GPS time; else the day the file was made, with a question mark"),
        Field("las_version", "text", "version of the LAS format"),
        Field("point_format", "integer", "point format of LAS"),
        Field("copc", "boolean", "it is a cloud optimised point cloud"),
        Field("used", "integer", "points that a run uses"),
        Field("verdict", "text", "ok, note, warning or refused"),
        Field("remark", "text", "why"),
    ),
)
"""Layer of the step ``inspect``; no part of a result."""


def known_layer(name: str) -> Layer | None:
    """A layer of a result, one that a review adds to it or a comparison writes beside it, or the index of tiles."""
    return LAYERS.get(name) or ADDED.get(name) or COMPARISON_LAYERS.get(name) or (TILE_INDEX if name == TILE_INDEX.name else None)
