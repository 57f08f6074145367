"""Layers and fields of the result GeoPackage: the one description that writers, styles, tables and documentation share."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

FieldType = Literal["text", "integer", "real", "boolean", "datetime"]
Geometry = Literal["PointZ", "LineStringZ", "PolygonZ", "MultiPolygonZ", "none"]

FORMAT_VERSION = 1
"""Version of the result's layout; raised when a field's name or meaning changes."""

FEATURES = ("centre", "f123", "f124", "f134", "f234")
"""Feature points of a unit, in the order used everywhere (paper 2.4)."""

LEG_NUMBERS = (1, 2, 3, 4)
"""Legs of a unit as the names of their fields have them."""

STATUSES = ("found", "uncertain", "new", "relocated", "lost", "unseen")
"""Values of ``units.status``; rows with ``lost`` and ``unseen`` have no geometry."""

GAP_KINDS = ("lost", "unseen", "unexplained", "hole")
"""Values of ``gaps.kind``."""

PLACEHOLDER = "placeholder"
"""Value of ``gaps.status``: a unit is likely there, or should be, and nobody has decided."""

CLASSES = ("stable", "moved", "rotated", "lost", "new", "relocated", "uncertain")
"""Values of ``displacements.class``."""

DATUMS = ("stable", "control")
"""Values of ``displacements.datum``."""


@dataclass(frozen=True)
class Field:
    """One column of a layer.

    Attributes
    ----------
    name, type
        Column name and logical type; ``datetime`` is UTC.
    description
        What the value means.
    unit
        Unit of measurement, empty where the value has none.
    """

    name: str
    type: FieldType
    description: str
    unit: str = ""


@dataclass(frozen=True)
class Layer:
    """One layer or attribute table of the result."""

    name: str
    geometry: Geometry
    description: str
    fields: tuple[Field, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Column names in the order written."""
        return tuple(field.name for field in self.fields)


_UNIT_ID = Field("unit_id", "text", "name of the physical unit, the same in all epochs")
_EPOCH = Field("epoch", "text", "label of the epoch in survey.toml")
_EPOCH_TIME = Field("epoch_time", "datetime", "time of the epoch", "UTC")
_EPOCH_UNTIL = Field("epoch_until", "datetime", "time of the next epoch, until which the row is the latest; empty in the last one", "UTC")
_POINT_ID = Field("point_id", "text", "name of the surveyed point")


def _sd(of: str) -> tuple[Field, Field, Field]:
    return (
        Field("sd_e", "real", f"standard deviation of {of}, easting", "m"),
        Field("sd_n", "real", f"standard deviation of {of}, northing", "m"),
        Field("sd_h", "real", f"standard deviation of {of}, height", "m"),
    )


_DISPLACEMENT_FIELDS = (
    _UNIT_ID,
    Field("feature", "text", "feature point: centre, f123, f124, f134 or f234"),
    Field("epoch_from", "text", "label of the earlier epoch"),
    Field("epoch_to", "text", "label of the later epoch"),
    Field("time_from", "datetime", "time of the earlier epoch", "UTC"),
    Field("time_to", "datetime", "time of the later epoch", "UTC"),
    Field("de", "real", "displacement, easting", "m"),
    Field("dn", "real", "displacement, northing", "m"),
    Field("dh", "real", "displacement, height, positive up", "m"),
    Field("d_horizontal", "real", "length of the horizontal displacement", "m"),
    Field("d_3d", "real", "length of the displacement", "m"),
    Field("azimuth_deg", "real", "direction of the horizontal displacement, from grid north clockwise", "degrees"),
    *_sd("the displacement"),
    Field("rotation_deg", "real", "angle of the unit's rotation between the epochs", "degrees"),
    Field("sd_rotation_deg", "real", "standard deviation of the rotation angle", "degrees"),
    Field("datum", "text", "frame of the displacement: stable (control and stable units) or control (control points alone)"),
    Field("statistic", "real", "test statistic of the displacement against zero"),
    Field("p_value", "real", "probability of a statistic at least as large if the unit did not move"),
    Field("significant", "boolean", "the displacement is significant at the level of the run"),
    Field(
        "class",
        "text",
        "stable, moved, rotated, lost, new, relocated or uncertain (weak evidence, or left open by its points and held at rest)",
    ),
    Field("p_adjusted", "real", "p-value of the centre's displacement adjusted for all units of the pair (Benjamini-Hochberg)"),
    Field("detectable", "real", "displacement found with a probability of 80 % in the worst direction", "m"),
    Field("d_over_h", "real", "length of the displacement over the unit's height H"),
    Field("d_over_dn", "real", "length of the displacement over the nominal diameter Dn"),
    Field("grade", "text", "below detection limit, significant, or the highest limit of [displacement] that is exceeded"),
)

_BODY_FIELDS = (
    _UNIT_ID,
    _EPOCH,
    _EPOCH_TIME,
    _EPOCH_UNTIL,
    Field("unit_type", "text", "type of the unit in survey.toml; of several of one name with the height"),
    Field("status", "text", "status of the unit in the epoch, as in units"),
    Field("class", "text", "class of the centre's displacement from the epoch before; where there is none, the status"),
    Field("d_3d", "real", "length of that displacement", "m"),
)

LAYERS: dict[str, Layer] = {
    layer.name: layer
    for layer in (
        Layer(
            "units",
            "PointZ",
            "Units at their cones' common centre, one row per unit and epoch",
            (
                _UNIT_ID,
                _EPOCH,
                _EPOCH_TIME,
                _EPOCH_UNTIL,
                Field("unit_type", "text", "type of the unit in survey.toml; of several of one name with the height"),
                Field("height", "real", "nominal height H of the unit", "m"),
                Field("r0", "real", "radius of the leg cone at the unit's centre", "m"),
                Field("gradient", "real", "loss of cone radius per metre along the leg's axis"),
                Field("qx", "real", "rotation body to CRS axes, quaternion x"),
                Field("qy", "real", "rotation body to CRS axes, quaternion y"),
                Field("qz", "real", "rotation body to CRS axes, quaternion z"),
                Field("qw", "real", "rotation body to CRS axes, quaternion w (scalar part)"),
                *_sd("the centre"),
                Field(
                    "sd_rotation_deg", "real", "standard deviation of the rotation, root of the summed variances of three axes", "degrees"
                ),
                Field(
                    "covariance",
                    "text",
                    "JSON list, upper triangle by rows of the 8 x 8 covariance of e, n, h, w_e, w_n, w_h, r0, gradient (m, rad)",
                ),
                Field("sigma0", "real", "standard deviation of unit weight of the adjustment"),
                Field("n_points", "integer", "points used by the adjustment"),
                Field("legs_visible", "integer", "legs that hold enough points to be seen"),
                *(Field(f"leg{k}", "text", f"leg {k}: whole, broken (its end is gone) or unseen (as its end is)") for k in LEG_NUMBERS),
                Field("leg_missing", "real", "length missing of the most broken leg; empty where none is broken", "m"),
                Field("leg_probability", "real", "probability that the leg most likely broken is, 0 to 1; empty where no end is seen"),
                *(Field(f"leg{k}_missing", "real", f"length missing of leg {k}; empty where it is not broken", "m") for k in LEG_NUMBERS),
                *(Field(f"leg{k}_probability", "real", f"probability that leg {k} is broken; empty where unseen") for k in LEG_NUMBERS),
                Field("coverage", "real", "share of the unit's surface that holds points, 0 to 1"),
                Field(
                    "score",
                    "real",
                    "probability that there is a unit with this pose, from how well the points agree with it, 0 to 1",
                ),
                Field("status", "text", "found, uncertain, new, relocated, lost or unseen"),
                Field(
                    "datum",
                    "text",
                    "what the frame of the coordinates hangs on: control, stable areas, units, or cloud (as it was surveyed)",
                ),
                Field("distance_median", "real", "median absolute distance of the points used to the adjusted surface", "m"),
                Field(
                    "supported",
                    "real",
                    "share of the surface elements seen near the predicted surface that lie on it with an agreeing normal, 0 to 1; surface "
                    "that is hidden or out of sight counts neither way",
                ),
                Field("nearest_centre", "real", "distance to the nearest other unit's centre in the epoch; below 0.5 H: a duplicate", "m"),
                Field("overlap_share", "real", "largest share of the unit's volume inside another unit that counts in the epoch, 0 to 1"),
                Field("may_be", "text", "of a lost or new unit: unit_ids of new or lost ones that it may be; nothing decides between them"),
            ),
        ),
        Layer(
            "unit_outlines",
            "PolygonZ",
            "Outlines of the fitted units seen from above, at the height of their centres, one row per unit and epoch",
            (*_BODY_FIELDS, Field("area", "real", "area of the outline", "m2")),
        ),
        Layer(
            "unit_surfaces",
            "MultiPolygonZ",
            "Surfaces of the fitted units as plane faces for 3D views, one row per unit and epoch",
            _BODY_FIELDS,
        ),
        Layer(
            "placement",
            "PointZ",
            "How units lie among their neighbours, one row per unit and epoch; docs/placement.md defines every figure",
            (
                _UNIT_ID,
                _EPOCH,
                _EPOCH_TIME,
                _EPOCH_UNTIL,
                Field("unit_type", "text", "type of the unit in survey.toml; of several of one name with the height"),
                Field("layer", "integer", "1 for units that none lies over, one more for each layer above"),
                Field("area", "real", "surface nearer to the unit than to any other of its layer; empty at the edge of the armour", "m2"),
                Field("packing", "real", "units per square of one Dn, from that area; by design 0.52 for each of two layers of tetrapods"),
                Field("spacing", "real", "distance to the nearest centre over the nominal diameter Dn"),
                Field("turn_deg", "real", "turn against the nearest neighbour of the layer, the unit's own symmetry left out", "degrees"),
                Field("off_surface", "real", "distance from the plane through the neighbours of the outer layer, positive outwards", "m"),
                Field("off_surface_dn", "real", "the same over the nominal diameter Dn"),
                Field("contacts", "integer", "units that it touches: free gap of 0.01 H or less"),
                Field("free_gap", "real", "free gap to the nearest unit; negative where the fitted bodies reach into each other", "m"),
                Field("in_column", "boolean", "it stands right above the next unit down the slope; empty where there is none, or no slope"),
            ),
        ),
        Layer(
            "gaps",
            "PointZ",
            "Places where a unit is likely missing in the result, one row per place and epoch",
            (
                _EPOCH,
                _EPOCH_TIME,
                _EPOCH_UNTIL,
                Field(
                    "kind",
                    "text",
                    "lost (the unit's place is seen to be empty), unseen (known from another epoch, hidden or missed in this one, "
                    "where it has points), "
                    "unexplained (points of no unit lie on the surface of a unit that fits there) or hole (a unit fits there, and the "
                    "cloud reaches into its space)",
                ),
                Field("status", "text", "placeholder"),
                Field("unit_id", "text", "name of the physical unit, where another epoch shows it"),
                Field("unit_type", "text", "type of the unit that fits there"),
                Field("height", "real", "height H of that unit", "m"),
                Field("radius", "real", "radius of a sphere about the place that holds that unit", "m"),
                Field(
                    "score",
                    "real",
                    "0 to 1; lost and unseen: 1; unexplained: share of the points of no unit around the place that lie on the unit's "
                    "surface; hole: share of the cross-section of the unit's core that the cloud reaches into",
                ),
                Field("area", "real", "surface of no unit that the cloud shows on the unit (unexplained) or within its core (hole)", "m2"),
                Field("nearest_units", "text", "JSON list of the unit_id of the three nearest units"),
                Field("nearest_centre", "real", "distance to the nearest unit's centre", "m"),
            ),
        ),
        Layer(
            "feature_points",
            "PointZ",
            "Feature points: the centre and the joints of three cones, one row per unit, epoch and feature",
            (
                _UNIT_ID,
                _EPOCH,
                _EPOCH_TIME,
                _EPOCH_UNTIL,
                Field("feature", "text", "centre, f123, f124, f134 or f234; of tetratrack features --end-discs also d1 to d4"),
                Field("observed", "boolean", "points lie next to the feature point; otherwise it follows from the rest of the unit"),
                *_sd("the feature point"),
                Field("cov_en", "real", "covariance of easting and northing", "m2"),
                Field("cov_eh", "real", "covariance of easting and height", "m2"),
                Field("cov_nh", "real", "covariance of northing and height", "m2"),
            ),
        ),
        Layer(
            "displacements",
            "LineStringZ",
            "Displacements of feature points between consecutive epochs in the default datum, from the earlier to the later point",
            _DISPLACEMENT_FIELDS,
        ),
        Layer(
            "displacements_other",
            "LineStringZ",
            "Displacements of other epoch pairs and in the other datum",
            _DISPLACEMENT_FIELDS,
        ),
        Layer(
            "epoch_pairs",
            "PointZ",
            "Congruence of two epochs: tests, stable set, common motion and calibration, one row per pair",
            (
                Field("epoch_from", "text", "label of the earlier epoch"),
                Field("epoch_to", "text", "label of the later epoch"),
                Field("units", "integer", "units seen in both epochs"),
                Field("stable_units", "integer", "units that support the datum stable"),
                Field(
                    "global_statistic", "real", "test that no unit moved: all units' p-values combined to a value of a Cauchy distribution"
                ),
                Field("global_degrees", "integer", "empty; in results of earlier versions the degrees of freedom of a sum of squares"),
                Field("global_p_value", "real", "p-value of the global test"),
                Field("common_e", "real", "common motion of the stable set in the control frame, easting", "m"),
                Field("common_n", "real", "common motion of the stable set in the control frame, northing", "m"),
                Field("common_h", "real", "common motion of the stable set in the control frame, height", "m"),
                Field("common_rotation_deg", "real", "common rotation of the stable set in the control frame", "degrees"),
                Field("common_p_value", "real", "p-value of the test that the stable set did not move against control"),
                Field("covariance_factor", "real", "factor of the standard deviations, estimated from the stable units"),
                Field("covariance_floor", "real", "standard deviation added to every displacement, estimated from the stable units", "m"),
                Field("rotation_factor", "real", "factor of the rotations' standard deviations, estimated from the stable units"),
                Field(
                    "rotation_floor_deg",
                    "real",
                    "standard deviation added to every rotation about each axis, estimated from the stable units",
                    "degrees",
                ),
                Field("tail_degrees", "real", "degrees of freedom of the displacements' t distribution"),
            ),
        ),
        Layer(
            "cross_checks",
            "PointZ",
            "Displacement of units by direct registration of their points (GICP) beside the model's, control frame, consecutive epochs",
            (
                _UNIT_ID,
                Field("epoch_from", "text", "label of the earlier epoch"),
                Field("epoch_to", "text", "label of the later epoch"),
                Field("de", "real", "displacement of the centre by direct registration, easting", "m"),
                Field("dn", "real", "displacement of the centre by direct registration, northing", "m"),
                Field("dh", "real", "displacement of the centre by direct registration, height", "m"),
                *_sd("that displacement, without registration to control"),
                Field("rotation_deg", "real", "rotation by direct registration", "degrees"),
                Field("overlap", "real", "share of the later points with a neighbour on the earlier surface, 0 to 1"),
                Field("difference", "real", "length of the difference from the model's displacement", "m"),
                Field("statistic", "real", "test statistic of that difference against zero"),
                Field("p_value", "real", "probability of a difference at least as large if both are right"),
                Field("agrees", "boolean", "both agree; empty where too little surface is seen in both epochs"),
                Field("reason", "text", "why they disagree or cannot be compared"),
            ),
        ),
        Layer(
            "velocities",
            "PointZ",
            "Linear motion of feature points of units seen in more than two epochs, datum stable of the first epoch",
            (
                _UNIT_ID,
                Field("feature", "text", "feature point: centre, f123, f124, f134 or f234"),
                Field("epoch_from", "text", "label of the first epoch with the unit"),
                Field("epoch_to", "text", "label of the last epoch with the unit"),
                Field("epochs", "integer", "epochs with the unit"),
                Field("ve", "real", "velocity, easting", "m/a"),
                Field("vn", "real", "velocity, northing", "m/a"),
                Field("vh", "real", "velocity, height, positive up", "m/a"),
                Field("sd_e", "real", "standard deviation of the velocity, easting", "m/a"),
                Field("sd_n", "real", "standard deviation of the velocity, northing", "m/a"),
                Field("sd_h", "real", "standard deviation of the velocity, height", "m/a"),
                Field("misfit_p_value", "real", "p-value of the test against a straight uniform motion"),
            ),
        ),
        Layer(
            "frame_errors",
            "PointZ",
            "Bent frames: error of an epoch's registered cloud along the structure, removed from units and displacements",
            (
                _EPOCH,
                Field("epoch_from", "text", "earlier epoch, where the row is the difference of two epochs as resting units see it"),
                Field("strip", "integer", "flight strip or station, where the row is its deviation from the mean of its epoch"),
                Field("known_by", "text", "targets, units (difference of two epochs) or strips (overlap of strips at the units)"),
                Field("along", "real", "chainage: distance along the structure's centreline from its first unit", "m"),
                Field("de", "real", "error, easting", "m"),
                Field("dn", "real", "error, northing", "m"),
                Field("dh", "real", "error, height, positive up", "m"),
                Field("d_3d", "real", "length of the error", "m"),
                *_sd("the error"),
                Field("correlation_length", "real", "distance over which the bend forgets itself", "m"),
            ),
        ),
        Layer(
            "stretches",
            "PointZ",
            "Common motion of the units of each stretch along the structure: settlement and sliding",
            (
                Field("epoch_from", "text", "label of the earlier epoch"),
                Field("epoch_to", "text", "label of the later epoch"),
                Field("time_from", "datetime", "time of the earlier epoch", "UTC"),
                Field("time_to", "datetime", "time of the later epoch", "UTC"),
                Field("datum", "text", "stable (against all other stretches and control) or control (against targets alone)"),
                Field("along_from", "real", "beginning of the stretch: chainage along the structure's centreline from its first unit", "m"),
                Field("along_to", "real", "end of the stretch", "m"),
                Field("units", "integer", "units that were averaged"),
                Field("de", "real", "common motion, easting", "m"),
                Field("dn", "real", "common motion, northing", "m"),
                Field("dh", "real", "common motion, height, positive up", "m"),
                Field("d_3d", "real", "length of the common motion", "m"),
                *_sd("the common motion, the frames' error included"),
                Field("p_value", "real", "probability of a motion at least as large if the stretch did not move"),
                Field(
                    "significant",
                    "boolean",
                    "the motion is significant at the level of the run among all stretches of the pair (false discovery rate)",
                ),
                Field(
                    "detectable",
                    "real",
                    "common motion found with a probability of 80 %: less cannot be told from the bend of the frames",
                    "m",
                ),
            ),
        ),
        Layer(
            "control_residuals",
            "PointZ",
            "Residuals of the registration at the control points, one row per control point and epoch",
            (
                _POINT_ID,
                _EPOCH,
                Field("ve", "real", "residual, easting", "m"),
                Field("vn", "real", "residual, northing", "m"),
                Field("vh", "real", "residual, height", "m"),
                Field("w_max", "real", "largest normalised residual of the three coordinates"),
                Field("used", "boolean", "the point took part in the transformation"),
                Field("outlier", "boolean", "the point was found to be disturbed"),
                *_sd("the residual as stated"),
            ),
        ),
        Layer(
            "check_residuals",
            "PointZ",
            "Feature points less their surveyed check coordinates, one row per check point and epoch",
            (
                _POINT_ID,
                _EPOCH,
                _UNIT_ID,
                Field("feature", "text", "feature point the check point was matched with"),
                Field("de", "real", "feature point less check point, easting", "m"),
                Field("dn", "real", "feature point less check point, northing", "m"),
                Field("dh", "real", "feature point less check point, height", "m"),
                Field("d_3d", "real", "length of the difference", "m"),
            ),
        ),
        Layer(
            "epochs",
            "none",
            "Epochs and how they were computed, one row per epoch",
            (
                Field("label", "text", "label of the epoch in survey.toml"),
                Field("time", "datetime", "time of the epoch", "UTC"),
                Field("tiles", "text", "JSON list of the tiles' names"),
                Field("points", "integer", "points read"),
                Field("transformation", "text", "JSON: seven parameters cloud to control frame, their covariance and reduction points"),
                Field("sigma0", "real", "standard deviation of unit weight of the registration"),
                Field(
                    "datum",
                    "text",
                    "what the epoch's frame hangs on: control, stable areas, units, or cloud (its own frame)",
                ),
                Field("reference_epoch", "text", "epoch it was tied to by stable areas or units: displacements are relative to that one"),
                Field("software", "text", "name and version of the software"),
                Field("settings", "text", "JSON: settings, checksums of all inputs, versions and seed"),
            ),
        ),
        Layer(
            "reviews",
            "none",
            "Decisions of a reviewer, one row per unit and epoch pair",
            (
                _UNIT_ID,
                Field("epoch_from", "text", "label of the earlier epoch"),
                Field("epoch_to", "text", "label of the later epoch"),
                Field("decision", "text", "accepted, rejected or inspect (on site)"),
                Field("comment", "text", "reviewer's remark"),
                Field("reviewer", "text", "name of the reviewer"),
                Field("reviewed_at", "datetime", "time of the decision", "UTC"),
                Field("confirmed_by", "text", "name of a second reviewer who confirmed the decision"),
                Field("confirmed_at", "datetime", "time of the confirmation", "UTC"),
            ),
        ),
    )
}


def markdown(layers: Iterable[Layer] = LAYERS.values()) -> str:
    """Tables of all layers and fields for the documentation."""
    blocks = []
    for layer in layers:
        geometry = "table without geometry" if layer.geometry == "none" else layer.geometry
        rows = [f"| `{f.name}` | {f.type} | {f.unit} | {f.description} |" for f in layer.fields]
        blocks.append(
            "\n".join(
                [
                    f"### `{layer.name}` ({geometry})",
                    "",
                    f"{layer.description}.",
                    "",
                    "| field | type | unit | meaning |",
                    "| --- | --- | --- | --- |",
                    *rows,
                ]
            )
        )
    return "\n\n".join(blocks) + "\n"
