"""Layers of a result as CSV and GeoParquet, for spreadsheets and data science."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .errors import InputError, OutputError
from .geopackage import replace_durably, temporary_beside
from .result_tables import table_names
from .schema import LAYERS

FORMATS = ("csv", "parquet")


def export_layers(result: Path, folder: Path, formats: Sequence[str] = FORMATS, layers: Sequence[str] = ()) -> list[Path]:
    """Write every layer of a result to ``folder/<layer>.csv`` and ``folder/<layer>.parquet``.

    A CSV has the coordinates in columns ``x``, ``y``, ``z`` (and ``x_to``, ``y_to``, ``z_to`` of lines), in the CRS of the result;
    times are ISO 8601 in UTC.

    Parameters
    ----------
    result
        GeoPackage of tetratrack.
    folder
        Made if it is missing.
    formats
        Of ``csv`` and ``parquet``.
    layers
        Names; empty for all.

    Raises
    ------
    InputError
        The result has no such layer.
    OutputError
        A file cannot be written.
    """
    present = table_names(result)
    missing = sorted(set(layers) - (present & LAYERS.keys()))
    if missing:
        raise InputError(f"has no layer {', '.join(missing)}", source=result, remedy=f"Layers are: {', '.join(LAYERS)}.")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(f"cannot be made ({error.strerror})", source=folder, remedy="Give a folder that can be written.") from error
    written = []
    for name in layers or [name for name in LAYERS if name in present]:
        frame = _read(result, name)
        for kind in formats:
            target = folder / f"{name}.{kind}"
            with temporary_beside(target) as temporary:
                if kind == "csv":
                    _flat(frame).to_csv(temporary, index=False, date_format="%Y-%m-%dT%H:%M:%SZ")
                else:
                    frame.to_parquet(temporary, index=False)
                replace_durably(temporary, target)
            written.append(target)
    return written


def _read(result: Path, name: str) -> Any:
    """Layer as a (Geo)DataFrame."""
    import geopandas
    from pyogrio.errors import DataLayerError, DataSourceError

    try:
        return geopandas.read_file(result, layer=name, engine="pyogrio")
    except (DataSourceError, DataLayerError) as error:
        raise InputError("cannot be read", source=result, remedy="Give a result of tetratrack.") from error


def _flat(frame: Any) -> Any:
    """A table without geometry: coordinates as columns."""
    import pandas
    import shapely

    if "geometry" not in frame:
        return frame
    shapes = frame.geometry.to_numpy()
    columns: dict[str, Any] = {}
    for end, suffix in ((0, ""), (-1, "_to")):
        if suffix and not (shapely.get_type_id(shapes) == shapely.GeometryType.LINESTRING).any():
            break
        points = [None if s is None or s.is_empty else shapely.get_coordinates(s, include_z=True)[end] for s in shapes]
        for k, axis in enumerate("xyz"):
            columns[f"{axis}{suffix}"] = [None if p is None else p[k] for p in points]
    return pandas.concat([pandas.DataFrame(frame.drop(columns="geometry")), pandas.DataFrame(columns, index=frame.index)], axis=1)
