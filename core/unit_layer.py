"""Units read from the layer ``units`` of any GeoPackage, as a step of its own takes them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from datetime import UTC
from pathlib import Path
from typing import Any

import numpy as np

from .errors import InputError
from .pose import Pose
from .survey import Survey
from .unit_types import UnitType


def read_units(path: Path) -> list[dict[str, Any]]:
    """Rows of the layer ``units`` of any GeoPackage, with ``geometry`` (3,) or None.

    Raises
    ------
    InputError
        The file cannot be read, or has no such layer or field.
    """
    import pyogrio
    import shapely
    from pyogrio.errors import DataLayerError, DataSourceError

    try:
        meta, _, geometry, columns = pyogrio.raw.read(path, layer="units")
    except (DataSourceError, DataLayerError) as error:
        raise InputError("has no readable layer units", source=path, remedy="Give a result of tetratrack segment, fit or run.") from error
    names = list(meta["fields"])
    missing = [name for name in ("epoch", "qx", "qy", "qz", "qw") if name not in names]
    if missing:
        raise InputError(
            f"layer units has no field {', '.join(missing)}", source=path, remedy="Give a result of tetratrack segment, fit or run."
        )
    shapes = shapely.from_wkb(geometry)
    places = [None if shape is None or shape.is_empty else shapely.get_coordinates(shape, include_z=True)[0] for shape in shapes]
    return [dict(zip(names, values, strict=True)) | {"geometry": place} for *values, place in zip(*columns, places, strict=True)]


def read_poses(path: Path, survey: Survey) -> dict[str, list[tuple[float, ...]]]:
    """Poses of a layer ``units`` by epoch: type of unit, centre and row-major rotation, as :class:`SegmentJob` takes them.

    Raises
    ------
    InputError
        The file has no such layer or field.
    """
    kinds = {unit.type.name: k for k, unit in enumerate(survey.units)}
    poses: dict[str, list[tuple[float, ...]]] = {epoch.label: [] for epoch in survey.epochs}
    for row in read_units(path):
        if row["geometry"] is None:
            continue
        if row["epoch"] not in poses:
            raise InputError(f"names the epoch {row['epoch']!r}", source=path, remedy=f"Epochs of the survey: {', '.join(poses)}.")
        pose = Pose.from_quaternion(row["geometry"], [row["qx"], row["qy"], row["qz"], row["qw"]])
        poses[row["epoch"]].append((float(kinds.get(row.get("unit_type", ""), 0)), *pose.centre.tolist(), *pose.rotation.ravel().tolist()))
    return poses


def crs_of_layer(path: Path) -> str:
    """CRS of the layer ``units`` of a GeoPackage, as survey.toml writes it."""
    import pyogrio

    return str(pyogrio.read_info(path, layer="units")["crs"] or "LOCAL")


def unit_of(row: Mapping[str, Any], source: Path) -> UnitType:
    """Geometry of a row of ``units``."""
    values = [row.get(name) for name in ("height", "r0", "gradient")]
    if any(value is None for value in values):
        raise InputError(
            f"unit {row['unit_id']} has no height, r0 or gradient", source=source, remedy="Give a result of tetratrack fit or run."
        )
    return UnitType.tetrapod(float(values[0]), radius=float(values[1]), gradient=float(values[2]))  # type: ignore[arg-type]


def plain(value: Any) -> Any:
    """A cell as the writers take it: numpy's missing values become None, its times aware datetimes."""
    if isinstance(value, np.datetime64):
        return None if np.isnat(value) else value.astype("datetime64[ms]").item().replace(tzinfo=UTC)
    if isinstance(value, float | np.floating) and math.isnan(value):
        return None
    return value
