"""Control from another CRS, height system or length unit brought into the survey's, and the scale of the grid on the ground."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from ..common.errors import CrsError
from ..data.point_tables import SurveyedPoints

LengthUnit = Literal["m", "ft", "us-ft"]
METRES_PER: dict[LengthUnit, float] = {"m": 1.0, "ft": 0.3048, "us-ft": 1200 / 3937}


def to_survey_frame(points: SurveyedPoints, crs: str | None, survey_crs: str, unit: LengthUnit = "m") -> SurveyedPoints:
    """Control from another CRS, height system or length unit to the survey's.

    Parameters
    ----------
    points
        Coordinates as in the file: easting, northing, height whatever the axis order of the CRS's definition.
    crs
        CRS of the file ("EPSG:5179", compound "EPSG:5186+5193"); None for the survey's own.
    survey_crs
        CRS of the results, or "LOCAL".
    unit
        Length unit of the file's numbers where ``crs`` does not state one of its own: for a CRS defined in feet the
        horizontal numbers are its feet, and ``unit`` is that of heights unless the CRS is compound.

    Raises
    ------
    CrsError
        A CRS that cannot be used, or a transformation whose grid is not installed: refused, since without it PROJ would fall back
        to a less accurate one or leave heights as they are.
    """
    import pyproj
    from pyproj.exceptions import CRSError, ProjError

    factor = METRES_PER[unit]
    if crs is None or crs == survey_crs:
        return replace(points, coordinates=points.coordinates * factor, sds=points.sds * factor)
    if survey_crs == "LOCAL":
        raise CrsError(f"is in {crs}, the survey in a local frame", source=points.source, remedy="Give control in the local frame.")
    try:
        source, target = pyproj.CRS.from_user_input(crs), pyproj.CRS.from_user_input(survey_crs)
    except CRSError as error:
        raise CrsError(f"CRS {crs!r} is not known ({error})", source=points.source, remedy="Use a code such as EPSG:32652.") from None
    horizontal = source.sub_crs_list[0] if source.is_compound else source
    if not horizontal.is_projected:
        raise CrsError(f"CRS {crs} is not projected", source=points.source, remedy="Give control as easting, northing, height.")
    to_metre = horizontal.axis_info[0].unit_conversion_factor
    if source.is_compound != target.is_compound and source.is_compound:
        raise CrsError(
            f"heights are in {source.sub_crs_list[1].name}, the survey's CRS {survey_crs} has no height system",
            source=points.source,
            remedy="Give the survey's crs its height system too, or drop it from control_crs if both are equal.",
        )
    group = pyproj.transformer.TransformerGroup(source, target, always_xy=True)
    if group.unavailable_operations and not group.best_available:
        grids = ", ".join(sorted({g.short_name for o in group.unavailable_operations for g in o.grids if not g.available}))
        raise CrsError(
            f"transformation from {crs} to {survey_crs} needs the grid {grids}, which is not installed",
            source=points.source,
            remedy=f"Install it (projsync --file {grids.split(',')[0]}) or give control in {survey_crs}.",
        )
    if source.is_compound and source.sub_crs_list[1] != target.sub_crs_list[1] and not _changes_heights(group):
        raise CrsError(
            f"no transformation is known between heights {source.sub_crs_list[1].name} and {target.sub_crs_list[1].name}",
            source=points.source,
            remedy="Give control heights in the survey's height system.",
        )
    horizontal_factor = factor if math.isclose(to_metre, 1.0) else 1.0
    height_factor = 1.0 if source.is_compound and horizontal_factor != factor else factor
    given = points.coordinates * [horizontal_factor, horizontal_factor, height_factor]
    try:
        transformer = pyproj.Transformer.from_crs(source, target, always_xy=True, only_best=True)
        moved = np.column_stack(transformer.transform(given[:, 0], given[:, 1], given[:, 2], errcheck=True))
    except ProjError as error:
        raise CrsError(
            f"cannot be transformed from {crs} to {survey_crs} ({error})", source=points.source, remedy=f"Give control in {survey_crs}."
        ) from None
    if not np.isfinite(moved).all():
        raise CrsError(
            f"lies outside the area of {crs} or {survey_crs}", source=points.source, remedy="Check control_crs and the axis order."
        )
    horizontal_sd = horizontal_factor * to_metre
    vertical_sd = source.sub_crs_list[1].axis_info[0].unit_conversion_factor if source.is_compound else height_factor
    return replace(points, coordinates=moved, sds=points.sds * [horizontal_sd, horizontal_sd, vertical_sd])


def grid_scale(crs: str, position: ArrayLike) -> float:
    """Grid distance over ground distance at (3,) easting, northing, height: scale of the projection times the reduction to the ellipsoid.

    Total-station distances are on the ground; in a network of 100 m a scale of 0.9996 is 4 cm.
    """
    import pyproj

    definition = pyproj.CRS.from_user_input(crs)
    horizontal = definition.sub_crs_list[0] if definition.is_compound else definition
    easting, northing, height = np.asarray(position, dtype=np.float64)
    back = pyproj.Transformer.from_crs(horizontal, horizontal.geodetic_crs, always_xy=True)
    longitude, latitude = back.transform(easting, northing)
    factors = pyproj.Proj(horizontal).get_factors(longitude, latitude)
    mean_radius = 6_371_000.0
    return float(math.sqrt(factors.areal_scale) * (1 - height / mean_radius))


def _changes_heights(group: Any) -> bool:
    return any("ballpark vertical" not in t.description.lower() for t in group.transformers)
