"""Fields of the result's layers in words, as tables, forms and the identify window show them."""

from __future__ import annotations

from ...core.results.schema import LEG_NUMBERS, Field
from .translation import tr

UNIT_SIGNS = {"m2": "m²", "degrees": "°", "m/a": "m/a", "m": "m"}


def field_title(name: str) -> str:
    """What a field is called; its own name where there is no word for it."""
    return _titles().get(name, name)


def field_alias(field: Field, *, with_unit: bool = True) -> str:
    """Title of a field, with its unit of measurement unless the values carry theirs."""
    unit = UNIT_SIGNS.get(field.unit, field.unit) if with_unit else ""
    return f"{field_title(field.name)} [{unit}]" if unit else field_title(field.name)


def _titles() -> dict[str, str]:
    return _identity() | _lengths() | _qualities() | _legs()


def _legs() -> dict[str, str]:
    titles = {}
    for number in LEG_NUMBERS:
        titles[f"leg{number}"] = tr("Leg {number}").format(number=number)
        titles[f"leg{number}_missing"] = tr("Leg {number}: missing").format(number=number)
        titles[f"leg{number}_probability"] = tr("Leg {number}: probability of a break").format(number=number)
    return titles


def _identity() -> dict[str, str]:
    return {
        "unit_id": tr("Unit"),
        "point_id": tr("Point"),
        "plan_id": tr("Unit in the plan"),
        "section": tr("Section"),
        "epoch": tr("Epoch"),
        "label": tr("Epoch"),
        "time": tr("Time"),
        "epoch_time": tr("Time"),
        "epoch_until": tr("Until"),
        "epoch_from": tr("From epoch"),
        "epoch_to": tr("To epoch"),
        "time_from": tr("From"),
        "time_to": tr("To"),
        "feature": tr("Feature point"),
        "unit_type": tr("Type of unit"),
        "status": tr("Status"),
        "class": tr("Class"),
        "kind": tr("Kind"),
        "grade": tr("Grade"),
        "datum": tr("Datum"),
        "reference_epoch": tr("Reference epoch"),
        "may_be": tr("May be"),
        "nearest_units": tr("Nearest units"),
        "decision": tr("Decision"),
        "comment": tr("Comment"),
        "reviewer": tr("Reviewer"),
        "reviewed_at": tr("Reviewed"),
        "confirmed_by": tr("Confirmed by"),
        "confirmed_at": tr("Confirmed"),
        "editor": tr("Editor"),
        "edited_at": tr("Edited"),
        "undone": tr("Taken back"),
        "picked_by": tr("Picked by"),
        "picked_at": tr("Picked"),
        "reason": tr("Reason"),
        "known_by": tr("Known by"),
        "tiles": tr("Tiles"),
        "software": tr("Software"),
        "file": tr("File"),
        "crs": tr("CRS"),
        "measured": tr("Measured"),
        "verdict": tr("Verdict"),
        "remark": tr("Remark"),
        "las_version": tr("LAS version"),
        "point_format": tr("Point format"),
        "copc": tr("COPC"),
    }


def _lengths() -> dict[str, str]:
    return {
        "height": tr("Height H"),
        "area": tr("Area"),
        "radius": tr("Radius"),
        "de": tr("Easting component"),
        "dn": tr("Northing component"),
        "dh": tr("Height component"),
        "d_horizontal": tr("Horizontal displacement"),
        "d_3d": tr("Displacement"),
        "azimuth_deg": tr("Azimuth"),
        "sd_e": tr("Std. dev. easting"),
        "sd_n": tr("Std. dev. northing"),
        "sd_h": tr("Std. dev. height"),
        "rotation_deg": tr("Rotation"),
        "sd_rotation_deg": tr("Std. dev. rotation"),
        "detectable": tr("Detectable"),
        "d_over_h": tr("Displacement / H"),
        "d_over_dn": tr("Displacement / Dn"),
        "leg_missing": tr("Missing of a leg"),
        "distance_median": tr("Distance of the points"),
        "nearest_centre": tr("Nearest centre"),
        "ve": tr("Easting component"),
        "vn": tr("Northing component"),
        "vh": tr("Height component"),
        "along": tr("Along the structure"),
        "along_from": tr("Along, from"),
        "along_to": tr("Along, to"),
        "correlation_length": tr("Correlation length"),
        "height_min": tr("Lowest height"),
        "height_max": tr("Greatest height"),
        "sd": tr("Std. dev."),
        "sd_3d": tr("Std. dev. displacement"),
        "nearest": tr("Nearest of the other side"),
        "design_height": tr("Height of the design"),
        "off_centre": tr("Centre off the design"),
        "off_outer": tr("Outermost point off the design"),
        "crest_height": tr("Height of the crest"),
        "crest_highest": tr("Highest top"),
        "crest_width": tr("Width of the crest"),
        "change": tr("Change"),
        "sd_change": tr("Std. dev. change"),
        "low": tr("95 % band, from"),
        "high": tr("95 % band, to"),
    }


def _qualities() -> dict[str, str]:
    return {
        "p_value": tr("p-value"),
        "p_adjusted": tr("p-value, adjusted"),
        "significant": tr("Significant"),
        "sigma0": tr("Sigma 0"),
        "n_points": tr("Points"),
        "points": tr("Points"),
        "used": tr("Used"),
        "density": tr("Points/m²"),
        "legs_visible": tr("Legs seen"),
        "leg_probability": tr("Probability of a broken leg"),
        "coverage": tr("Share seen"),
        "score": tr("Probability"),
        "supported": tr("Share supported"),
        "overlap_share": tr("Overlap"),
        "observed": tr("Observed"),
        "w_max": tr("Normalised residual"),
        "outlier": tr("Disturbed"),
        "strip": tr("Strip"),
        "units": tr("Units"),
        "layer": tr("Layer of the armour"),
        "packing": tr("Packing"),
        "spacing": tr("Spacing / Dn"),
        "turn_deg": tr("Turn against the neighbour"),
        "off_surface": tr("Off the surface"),
        "off_surface_dn": tr("Off the surface / Dn"),
        "contacts": tr("Contacts"),
        "free_gap": tr("Free gap"),
        "in_column": tr("In a column"),
    }
