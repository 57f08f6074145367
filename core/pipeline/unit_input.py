"""Units read from the layer ``units`` of any GeoPackage, as a step of its own takes them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..common.errors import InputError
from ..data.crs import LOCAL
from ..data.survey import Survey
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..results.geopackage_reader import crs_of, read_given_rows
from .given_units import GivenUnit
from .stated_frames import is_registered, stated_frames

GIVE = "Give a result of tetratrack segment, fit or run."


def read_units(path: Path) -> list[dict[str, Any]]:
    """Rows of the layer ``units`` of any GeoPackage, with ``geometry`` (3,) or None.

    Raises
    ------
    InputError
        The file cannot be read, has no such layer or field, or a value is not what its field holds.
    """
    rows = read_given_rows(path, "units", ("epoch", "qx", "qy", "qz", "qw"))
    for row in rows:
        row["geometry"] = place = row.pop("geom", None)
        if place is None:
            continue
        if place.shape != (3,):
            raise InputError("a geometry is no point", source=path, where="layer units", remedy=GIVE)
        turn = [row[name] for name in ("qx", "qy", "qz", "qw")]
        if None in turn or not 0.5 < math.hypot(*turn) < 2.0:
            raise InputError(f"{tuple(turn)} is no rotation", source=path, where="layer units, fields qx, qy, qz, qw", remedy=GIVE)
    return rows


def read_given_units(path: Path, survey: Survey) -> dict[str, list[GivenUnit]]:
    """Units of a layer ``units`` by epoch in the frame of its cloud, as the step ``fit`` takes them.

    Raises
    ------
    InputError
        The file has no such layer or field, or holds units of the control frame without the registration that brought them there.
    """
    frames = stated_frames(path)
    kinds = {unit.type.name: k for k, unit in enumerate(survey.units)}
    found: dict[str, list[GivenUnit]] = {epoch.label: [] for epoch in survey.epochs}
    for row in read_units(path):
        if row["geometry"] is None:
            continue
        if row["epoch"] not in found:
            raise InputError(f"names the epoch {row['epoch']!r}", source=path, remedy=f"Epochs of the survey: {', '.join(found)}.")
        pose = Pose.from_quaternion(row["geometry"], [row["qx"], row["qy"], row["qz"], row["qw"]])
        if row["epoch"] in frames:
            pose = frames[row["epoch"]].in_cloud(pose)
        elif is_registered(row):
            raise InputError(f"holds units of {row['epoch']} in the control frame without their registration", source=path, remedy=GIVE)
        found[row["epoch"]].append(_given_unit(row, kinds.get(row.get("unit_type", ""), 0), pose))
    return found


def _given_unit(row: Mapping[str, Any], kind: int, pose: Pose) -> GivenUnit:
    """What a row says of a unit whose pose in the frame of its cloud is ``pose``."""
    said = {name: row[name] for name in ("score", "coverage", "supported", "legs_visible") if row.get(name) is not None}
    status = "uncertain" if row.get("status") == "uncertain" else "found"
    return GivenUnit(kind, tuple(pose.as_row().tolist()), status, **said)


def crs_of_layer(path: Path, layer: str = "units") -> str:
    """CRS of a layer of a GeoPackage, as survey.toml writes it."""
    crs = crs_of(path, layer)
    if crs.epsg is not None:
        return f"EPSG:{crs.epsg}"
    return LOCAL if crs.definition == "undefined" else crs.definition


def unit_of(row: Mapping[str, Any], source: Path) -> UnitType:
    """Geometry of a row of ``units``."""
    values = [row.get(name) for name in ("height", "r0", "gradient")]
    if any(value is None for value in values):
        raise InputError(
            f"unit {row['unit_id']} has no height, r0 or gradient", source=source, remedy="Give a result of tetratrack fit or run."
        )
    return UnitType.tetrapod(float(values[0]), radius=float(values[1]), gradient=float(values[2]))  # type: ignore[arg-type]
