"""Whether two CRS are one, whatever they are called."""

from __future__ import annotations

from osgeo import osr
from qgis.core import Qgis, QgsCoordinateReferenceSystem


def same_crs(one: QgsCoordinateReferenceSystem, other: QgsCoordinateReferenceSystem) -> bool:
    """Whether coordinates in both mean the same places.

    QGIS compares codes where there are any, so that one CRS under two codes, or with a code and without, counts as two. PROJ compares what
    they are made of, and holds apart datums that differ by metres on the same ellipsoid, such as GDA94 and GDA2020. No CRS is another one
    than any CRS.
    """
    if one == other or not (one.isValid() and other.isValid()):
        return one == other
    first, second = osr.SpatialReference(), osr.SpatialReference()
    codes = [made.ImportFromWkt(crs.toWkt(Qgis.CrsWktVariant.Preferred)) for made, crs in ((first, one), (second, other))]
    if any(codes):
        # two that GDAL cannot read would both be empty
        return False
    # x is easting in the files of both, whatever the order of axes in the definition
    return bool(first.IsSame(second, ["IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES"]))


def crs_name(crs: QgsCoordinateReferenceSystem) -> str:
    """Code of a CRS, or its description where it has no code; empty for none."""
    return str(crs.authid() or crs.description() or crs.userFriendlyIdentifier()) if crs.isValid() else ""
