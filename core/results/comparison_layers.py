"""Layers of the files that compare a result with its design and cut it into profiles; they stand beside the result, never in it."""

from __future__ import annotations

from .schema import Field, Layer

_UNIT_ID = Field("unit_id", "text", "name of the physical unit")
_EPOCH = Field("epoch", "text", "label of the epoch")
_ALONG = Field("along", "real", "chainage along the axis", "m")
_VERDICT = Field(
    "verdict",
    "text",
    "within or outside the tolerance with 95 % certainty, or open where the standard deviations leave it open",
)

PLAN_LAYERS = (
    Layer(
        "plan_deviations",
        "LineStringZ",
        "Units less their places in the plan, from the planned to the built place",
        (
            Field("plan_id", "text", "name of the unit in the plan"),
            _UNIT_ID,
            _EPOCH,
            Field("de", "real", "built less planned, easting", "m"),
            Field("dn", "real", "built less planned, northing", "m"),
            Field("dh", "real", "built less planned, height", "m"),
            Field("d_horizontal", "real", "length of the horizontal deviation", "m"),
            Field("d_3d", "real", "length of the deviation", "m"),
            Field("sd_3d", "real", "standard deviation of that length", "m"),
            Field(
                "rotation_deg",
                "real",
                "turn from the planned orientation, the own symmetry left out; empty if none is planned",
                "degrees",
            ),
            Field("sd_rotation_deg", "real", "standard deviation of the orientation", "degrees"),
            _VERDICT,
        ),
    ),
    Layer(
        "plan_unmatched",
        "PointZ",
        "Places of the plan without a unit, and units without a place",
        (
            Field("kind", "text", "missing (a place without a unit) or extra (a unit without a place)"),
            Field("plan_id", "text", "name of the unit in the plan"),
            _UNIT_ID,
            _EPOCH,
            Field("nearest", "real", "distance to the nearest place or unit of the other side", "m"),
        ),
    ),
)

PROFILE_LAYERS = (
    Layer(
        "profile_deviations",
        "PointZ",
        "Units against the surface of the design profile, across that surface and positive outwards",
        (
            _UNIT_ID,
            _EPOCH,
            _ALONG,
            Field("design_height", "real", "height of the design surface under the centre", "m"),
            Field("off_centre", "real", "distance of the centre from the design surface", "m"),
            Field("off_outer", "real", "distance of the unit's outermost point from the design surface", "m"),
            Field("sd", "real", "standard deviation of both", "m"),
            _VERDICT,
        ),
    ),
)

SECTION_LAYERS = (
    Layer(
        "sections",
        "LineStringZ",
        "Cross-sections: outlines of the blocks where the section cuts them, the surface of the points, and the design",
        (
            Field("section", "integer", "number of the section"),
            _ALONG,
            Field("kind", "text", "blocks, points or design"),
            _UNIT_ID,
            _EPOCH,
        ),
    ),
    Layer(
        "crest",
        "PointZ",
        "Crest of each reach between sections",
        (
            Field("section", "integer", "number of the reach"),
            _ALONG,
            _EPOCH,
            Field("units", "integer", "units of the crest: those whose top lies less than 0.5 Dn below the highest one of the reach"),
            Field("crest_height", "real", "mean height of their tops", "m"),
            Field("crest_highest", "real", "highest top", "m"),
            Field("crest_width", "real", "width of their outlines across the axis", "m"),
            Field("sd", "real", "standard deviation of the mean height, the frame's error included", "m"),
            Field("change", "real", "crest height less that of the epoch before, of the units that are the crest's in both", "m"),
            Field("sd_change", "real", "standard deviation of the change, the frames' error included", "m"),
        ),
    ),
    Layer(
        "settlement",
        "LineStringZ",
        "Height change of stretches along the structure, drawn along the axis (layer stretches of the result)",
        (
            Field("epoch_from", "text", "label of the earlier epoch"),
            Field("epoch_to", "text", "label of the later epoch"),
            Field("datum", "text", "stable or control, as in the result"),
            Field("along_from", "real", "beginning of the stretch, as in the result: from the first unit of its pair of epochs", "m"),
            Field("along_to", "real", "end of the stretch", "m"),
            Field("units", "integer", "units that were averaged"),
            Field("dh", "real", "common height change, positive up", "m"),
            Field("low", "real", "lower end of its 95 % band", "m"),
            Field("high", "real", "upper end of its 95 % band", "m"),
            Field("significant", "boolean", "the stretch moved"),
        ),
    ),
)

COMPARISON_LAYERS = {layer.name: layer for layer in (*PLAN_LAYERS, *PROFILE_LAYERS, *SECTION_LAYERS)}
