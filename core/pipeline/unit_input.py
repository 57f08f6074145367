"""Units read from the layer ``units`` of any GeoPackage, as a step of its own takes them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ..common.errors import InputError
from ..common.feedback import Feedback
from ..data.crs import check_same_crs
from ..data.survey import Survey, SurveyUnit
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..results.geopackage_reader import crs_of, read_given_rows, table_names
from ..results.result_access import REQUIRED
from ..results.unit_rows import read_epochs, unit_sizes
from ..results.unit_sizes import UnitSize, unit_of
from .epoch_plans import EpochPlan
from .given_units import GivenUnit
from .stated_frames import is_registered, stated_frames

GIVE = "Give a result of tetratrack segment, fit or run of this survey."
SAME_HEIGHT = 0.03
"""Heights that differ by a smaller share are of one size: ends of legs, 0.64 H from the centre, then stay within the 0.02 H from which
points of a known unit are taken."""


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
        The file has no such layer or field, another CRS, or types or heights of units that the survey does not have; or it holds units
        of the control frame without the registration that brought them there.
    """
    check_same_crs(crs_of_layer(path), survey.crs, source=path, whose="the survey")
    frames = stated_frames(path)
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
        found[row["epoch"]].append(_given_unit(row, _kind_of(row, survey.units, path), pose))
    return found


def _kind_of(row: Mapping[str, Any], units: Sequence[SurveyUnit], source: Path) -> int:
    """Index of the type of a row of ``units``; of several types of one name that of the nearest height."""
    name, height = row.get("unit_type"), row.get("height")
    named = [k for k, unit in enumerate(units) if _is_called(unit, name)] if name else list(range(len(units)))
    if name and not named and height is not None:
        # the same kind of unit by its name in the catalogue, which ends with its mass
        named = [k for k, unit in enumerate(units) if _kind(unit.type.name) == _kind(name) and _is_as_high(unit, height)]
    if not named:
        known = ", ".join(dict.fromkeys(unit.type.name for unit in units))
        raise InputError(f"names the type of unit {name!r}", source=source, where="layer units", remedy=f"Types of the survey: {known}.")
    if height is None:
        if len(named) > 1:
            raise InputError("says of a unit neither type nor height", source=source, where="layer units", remedy=GIVE)
        return named[0]
    nearest = min(named, key=lambda k: abs(units[k].type.height - height))
    if not _is_as_high(units[nearest], height):
        raise InputError(
            f"holds units of height {height:g} m, the survey has {units[nearest].type.height:g} m",
            source=source,
            where="layer units, field height",
            remedy="Correct height in survey.toml, or find the units anew (tetratrack segment).",
        )
    return nearest


def _is_called(unit: SurveyUnit, name: str) -> bool:
    return unit.type.name.casefold() == name.casefold()


def _kind(name: str) -> str:
    return name.casefold().split(maxsplit=1)[0]


def _is_as_high(unit: SurveyUnit, height: float) -> bool:
    return abs(height - unit.type.height) <= SAME_HEIGHT * unit.type.height


def check_places(
    given: Mapping[str, Sequence[GivenUnit]], survey: Survey, plans: Sequence[EpochPlan], source: Path, feedback: Feedback
) -> None:
    """Refuse units none of which lies in the tiles of its epoch; of single ones that do not, say so.

    Raises
    ------
    InputError
        With the epoch.
    """
    for plan in plans:
        units, label = given[plan.epoch.label], plan.epoch.label
        if not units:
            continue
        centres = np.array([unit.pose[:3] for unit in units])
        reach = max(unit.type.height for unit in survey.units)
        inside = np.zeros(len(units), dtype=np.bool_)
        for tile in plan.tiles:
            inside |= np.all((centres > np.array(tile.low) - reach) & (centres < np.array(tile.high) + reach), axis=1)
        if not inside.any():
            raise InputError(
                f"none of its {len(units)} units lies in the tiles of epoch {label}", source=source, where="layer units", remedy=GIVE
            )
        if not inside.all():
            feedback.warning(
                f"{label}: {int((~inside).sum())} of {len(units)} units of {source.name} lie outside the tiles and are left out"
            )


def _given_unit(row: Mapping[str, Any], kind: int, pose: Pose) -> GivenUnit:
    """What a row says of a unit whose pose in the frame of its cloud is ``pose``."""
    said = {name: row[name] for name in ("score", "coverage", "supported", "legs_visible") if row.get(name) is not None}
    status = "uncertain" if row.get("status") == "uncertain" else "found"
    return GivenUnit(kind, tuple(pose.as_row().tolist()), status, **said)


def crs_of_layer(path: Path, layer: str = "units") -> str:
    """CRS of a layer of a GeoPackage, as survey.toml writes it."""
    return crs_of(path, layer).text


def stated_sizes(path: Path) -> tuple[UnitSize, ...]:
    """Types of unit as a file with the layer ``units`` states them; () where it is no result.

    Raises
    ------
    InputError
        The file cannot be read, or its types of unit are damaged.
    """
    return unit_sizes(read_epochs(path)) if table_names(path, ("units",)).issuperset(REQUIRED) else ()


def fitted_unit(row: dict[str, Any], sizes: Sequence[UnitSize], source: Path) -> UnitType:
    """Geometry of a row of ``units``, whose file states ``sizes`` of its types."""
    values = [row.get(name) for name in ("height", "r0", "gradient")]
    if any(value is None for value in values):
        raise InputError(
            f"unit {row['unit_id']} has no height, r0 or gradient", source=source, remedy="Give a result of tetratrack fit or run."
        )
    return unit_of(row, sizes)
