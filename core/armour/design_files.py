"""What engineers hand over of a design: plans of placed units (CSV or layer), and lines of profiles (layer or DXF)."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..common.arrays import BoolArray, FloatArray
from ..common.errors import InputError
from ..data.crs import LOCAL, horizontal_transform
from ..data.point_tables import read_point_table
from ..data.vector_files import check_vector_file
from ..results.geopackage_reader import ResultCrs

QUATERNION = ("qx", "qy", "qz", "qw")
LAYER_MARK = "|layername="
"""Between the path of a file and the layer of it that is meant, as QGIS writes it."""
PLAN_REMEDY = "Give a CSV unit_id,easting,northing,height (and qx,qy,qz,qw), or a layer of points with heights and a field unit_id."
LINES_REMEDY = "Give lines with heights (LineStringZ) in a GeoPackage, GeoJSON or Shapefile, or a DXF with 3D polylines."


@dataclass(frozen=True, eq=False, kw_only=True)
class PlacementPlan:
    """Planned units: names, (n, 3) centres in the survey CRS, (n, 3, 3) orientations of those in ``turned`` (n,)."""

    ids: tuple[str, ...]
    places: FloatArray
    rotations: FloatArray
    turned: BoolArray


def read_plan(source: str | Path, crs: ResultCrs) -> PlacementPlan:
    """Read a placement plan.

    Parameters
    ----------
    source
        CSV ``unit_id,easting,northing,height`` in the survey CRS, optionally with the orientation ``qx,qy,qz,qw`` (body to CRS axes); or
        a layer of points with heights and the same fields, ``FILE|layername=NAME`` where the file has several.
    crs
        Survey CRS, into which a layer is brought.

    Raises
    ------
    InputError
        The file cannot be read, holds no place, names a unit twice or half an orientation.
    """
    path, layer = split_source(source)
    if path.suffix.lower() in (".csv", ".txt", ".tsv"):
        rows = read_point_table(path, ("unit_id", "easting", "northing", "height"), text=("unit_id",))
        places = np.array([[row["easting"], row["northing"], row["height"]] for row in rows])
    else:
        rows, shapes = _read_layer(path, layer, crs, PLAN_REMEDY)
        if any(len(shape) != 1 for shape in shapes):
            raise InputError("is no layer of points", source=path, remedy=PLAN_REMEDY)
        places = np.array([shape[0] for shape in shapes]).reshape(-1, 3)
        for number, row in enumerate(rows, start=1):
            row["unit_id"] = str(row["unit_id"]) if row.get("unit_id") is not None else str(number)
            row["line"] = number
    if not len(places):
        raise InputError("holds no place of a unit", source=path, remedy=PLAN_REMEDY)
    if not np.isfinite(places).all():
        raise InputError("has points without heights", source=path, remedy=PLAN_REMEDY)
    ids = [str(row["unit_id"]) for row in rows]
    twice = next((name for name in ids if ids.count(name) > 1), None) if len(set(ids)) < len(ids) else None
    if twice is not None:
        raise InputError(f"names the unit {twice!r} twice", source=path, remedy="Give every planned unit a name of its own.")
    rotations = np.tile(np.eye(3), (len(rows), 1, 1))
    turned = np.zeros(len(rows), dtype=bool)
    for k, row in enumerate(rows):
        known = [row.get(name) for name in QUATERNION]
        if all(value is None for value in known):
            continue
        rotations[k], turned[k] = _rotation(known, path, row["line"]), True
    return PlacementPlan(ids=tuple(ids), places=places, rotations=rotations, turned=turned)


def read_design_lines(source: str | Path, crs: ResultCrs) -> list[FloatArray]:
    """Lines of a design profile, (n, 3) each, in the survey CRS.

    Parameters
    ----------
    source
        DXF (lines, polylines and splines as they are drawn, in the survey CRS), or a layer of lines with heights.
    crs
        Survey CRS, into which a layer is brought.

    Raises
    ------
    InputError
        The file cannot be read or holds no line with heights.
    """
    path, layer = split_source(source)
    if path.suffix.lower() == ".dxf":
        lines = _read_dxf(path)
    else:
        lines = [shape for shape in _read_layer(path, layer, crs, LINES_REMEDY)[1] if len(shape) > 1]
    lines = [line[np.append(True, ~(np.linalg.norm(np.diff(line, axis=0), axis=1) <= 1e-6))] for line in lines]
    lines = [line for line in lines if len(line) > 1]
    if not lines:
        raise InputError("holds no line", source=path, remedy=LINES_REMEDY)
    if not all(np.isfinite(line).all() for line in lines):
        raise InputError("has lines without heights", source=path, remedy=LINES_REMEDY)
    return lines


def split_source(source: str | Path) -> tuple[Path, str]:
    """Path and layer of ``FILE|layername=NAME``; no layer is named by ''."""
    path, _, layer = str(source).partition(LAYER_MARK)
    return Path(path), layer


def _rotation(quaternion: list[Any], path: Path, line: int) -> FloatArray:
    from ..model.outline import rotation_of_quaternion

    try:
        return rotation_of_quaternion([float(value) for value in quaternion])
    except (TypeError, ValueError) as error:
        raise InputError(
            "half an orientation", source=path, where=f"line {line}", remedy="Give qx, qy, qz and qw, or none of them."
        ) from error


def _read_layer(path: Path, layer: str, crs: ResultCrs, remedy: str) -> tuple[list[dict[str, Any]], list[FloatArray]]:
    """Attributes and (n, 3) corners of the features of a layer, in the survey CRS; heights that are missing are NaN."""
    import pyogrio
    import shapely
    from pyogrio.errors import DataLayerError, DataSourceError

    check_vector_file(path)
    try:
        with warnings.catch_warnings():
            # what GDAL thinks of the file besides
            warnings.simplefilter("ignore")
            meta, _, wkb, columns = pyogrio.raw.read(path, layer=layer or None)
        shapes = shapely.from_wkb([] if wkb is None else wkb)
    except (DataSourceError, DataLayerError, ValueError, RuntimeError, shapely.errors.ShapelyError) as error:
        raise InputError("is no layer that can be read", source=path, remedy=remedy) from error
    known = [not (shape is None or shape.is_empty) for shape in shapes]
    names = [str(name).lower() for name in meta["fields"]]
    rows = [{name: _plain(column[k]) for name, column in zip(names, columns, strict=True)} for k, usable in enumerate(known) if usable]
    parts: list[FloatArray] = []
    kept: list[dict[str, Any]] = []
    for row, shape in zip(rows, (s for s, usable in zip(shapes, known, strict=True) if usable), strict=True):
        for part in shapely.get_parts(shape):
            parts.append(shapely.get_coordinates(part, include_z=True))
            kept.append(row)
    transform: Callable[[FloatArray], FloatArray] | None = None
    if crs.text != LOCAL and meta["crs"]:
        transform = horizontal_transform(meta["crs"], crs.text, source=path)
    if transform is not None:
        parts = [np.column_stack([transform(part[:, :2]), part[:, 2]]) for part in parts]
    return kept, parts


def _plain(value: Any) -> Any:
    value = value.item() if isinstance(value, np.generic) else value
    return None if isinstance(value, float) and np.isnan(value) else value


def _read_dxf(path: Path) -> list[FloatArray]:
    """Lines and polylines of the drawing; arcs within them and splines flattened to 1 cm."""
    try:
        from ezdxf import path as dxf_path
        from ezdxf.entities.polyline import Polyline
        from ezdxf.filemanagement import readfile
        from ezdxf.lldxf.const import DXFError
    except ImportError as error:
        raise InputError("needs the library ezdxf to be read", source=path, remedy="Install tetratrack[model], or give a layer.") from error
    if not path.is_file():
        raise InputError("does not exist", source=path, remedy="Check the path.")
    try:
        drawing = readfile(path)
    except (DXFError, OSError, UnicodeError, ValueError) as error:
        raise InputError("is no DXF, or a damaged one", source=path, remedy="Write it again from the CAD program, as DXF R2000.") from error
    lines = []
    for entity in drawing.modelspace().query("LINE LWPOLYLINE POLYLINE SPLINE"):
        if isinstance(entity, Polyline) and not (entity.is_2d_polyline or entity.is_3d_polyline):
            continue
        lines.append(np.array([(v.x, v.y, v.z) for v in dxf_path.make_path(entity).flattening(0.01)]).reshape(-1, 3))
    return lines
