"""Layers of a result as CSV and GeoParquet, for spreadsheets and data science."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..common.atomic_files import write_all
from ..common.csv_text import SPREADSHEET_ENCODING, signs, spreadsheet_safe
from ..common.errors import InputError, OutputError
from ..common.output_files import check_own, check_targets
from ..common.sqlite_files import has_leftovers
from .geopackage_reader import table_names
from .result_access import is_writable, reading
from .schema import LAYERS, Field

FORMATS = ("csv", "parquet")
_NULLABLE = {"integer": "Int64", "boolean": "boolean"}
"""Kinds of column that hold empty values beside whole numbers and truth values, by type of field."""


def export_layers(
    result: Path, folder: Path, formats: Sequence[str] = FORMATS, layers: Sequence[str] = (), separator: str = "comma"
) -> list[Path]:
    """Write every layer of a result to ``folder/<layer>.csv`` and ``folder/<layer>.parquet``.

    A CSV has the coordinates in columns ``x``, ``y``, ``z`` (and ``x_to``, ``y_to``, ``z_to`` of lines), in the CRS of the result;
    times are ISO 8601 in UTC, truth values True and False. Text that a spreadsheet would run as a formula has an apostrophe before it.

    Parameters
    ----------
    result
        GeoPackage of tetratrack.
    folder
        Made if it is missing.
    formats
        Of ``FORMATS``, in capitals or not.
    layers
        Names; empty for all.
    separator
        Of a CSV, by its name in :data:`~tetratrack.core.common.csv_text.SEPARATORS`.

    Raises
    ------
    InputError
        The result has no such layer, or there is no such format.
    OutputError
        A file cannot be written.
    """
    kinds = list(dict.fromkeys(kind.lower() for kind in formats))
    unknown = [kind for kind in kinds if kind not in FORMATS]
    if unknown:
        raise InputError(f"layers cannot be written as {', '.join(unknown)}", where="format", remedy=f"Choose of {', '.join(FORMATS)}.")
    between, decimal = signs(separator)
    present = table_names(result)
    missing = sorted(set(layers) - (present & LAYERS.keys()))
    if missing:
        raise InputError(f"has no layer {', '.join(missing)}", source=result, remedy=f"Layers are: {', '.join(LAYERS)}.")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(f"cannot be made ({error.strerror})", source=folder, remedy="Give a folder that can be written.") from error
    chosen = list(layers) or [name for name in LAYERS if name in present]
    check_targets([(folder / f"{name}.{kind}", f"layer {name}") for name in dict.fromkeys(chosen) for kind in kinds], [result])
    contents: dict[Path, bytes] = {}
    for name in chosen:
        frame = _read(result, name)
        for kind in kinds:
            target = folder / f"{name}.{kind}"
            buffer = io.BytesIO()
            if kind == "csv":
                table = _safe(_flat(frame))
                check_own(target, [str(name) for name in table.columns[:3]])
                table.to_csv(
                    buffer, index=False, date_format="%Y-%m-%dT%H:%M:%SZ", encoding=SPREADSHEET_ENCODING, sep=between, decimal=decimal
                )
            else:
                frame.to_parquet(buffer, index=False)
                check_own(target, ("PAR1",))
            contents[target] = buffer.getvalue()
    write_all(contents)
    return list(contents)


def _read(result: Path, name: str) -> Any:
    """Layer as a (Geo)DataFrame."""
    import geopandas
    from pyogrio.errors import DataLayerError, DataSourceError

    with reading(result):
        # recovered, and its layers are tables: now GDAL reads what SQLite has read
        immutable = {} if is_writable(result) or has_leftovers(result) else {"IMMUTABLE": "YES"}
    try:
        frame = geopandas.read_file(result, layer=name, engine="pyogrio", **immutable)
    except (DataSourceError, DataLayerError) as error:
        raise InputError("cannot be read", source=result, remedy="Give a result of tetratrack.") from error
    return frame.astype({field.name: _NULLABLE[field.type] for field in LAYERS[name].fields if _is_widened(field, frame)})


def _is_widened(field: Field, frame: Any) -> bool:
    """Whether a column of whole numbers or truth values was read as real ones, as it is where some are empty: 3 would be written 3.0."""
    return field.type in _NULLABLE and field.name in frame and frame[field.name].dtype.kind not in "iub"


def _safe(frame: Any) -> Any:
    """A table whose texts no spreadsheet runs."""
    texts = [name for name in frame.columns if any(isinstance(value, str) for value in frame[name])]
    return frame.assign(**{name: frame[name].map(spreadsheet_safe) for name in texts})


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
