"""Sizes of the types of unit as a run's settings state them, and with them the geometry of a row of ``units``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..common.errors import InputError
from ..model.outline import PlacedShape, rotation_of_quaternion
from ..model.unit_types import LEG_LENGTH_RATIO, Opening, UnitType, leg_directions
from .field_checks import check_pose
from .geopackage_reader import Row
from .result_access import CHANGED


@dataclass(frozen=True)
class UnitSize:
    """What the layer ``units`` does not say of a type of unit.

    Attributes
    ----------
    name, height
        Type in survey.toml and nominal height H, metres; None where a result of an earlier version states one leg length for all.
    leg_length
        Centre to end disc, metres.
    opening
        ``tetrahedral`` or ``paper``.
    """

    name: str | None
    height: float | None
    leg_length: float
    opening: Opening = "tetrahedral"


def sizes_of_settings(epoch_settings: Iterable[Mapping[str, Any]]) -> tuple[UnitSize, ...]:
    """The same from the ``settings`` of the epochs alone."""
    for settings in epoch_settings:
        types, leg_length = settings.get("unit_types"), settings.get("leg_length")
        if isinstance(types, list):
            try:
                return tuple(_unit_size(kind) for kind in types)
            except (KeyError, TypeError, ValueError) as error:
                raise InputError("unit_types of the settings are damaged", where="layer epochs, field settings", remedy=CHANGED) from error
        # earlier versions state that of the first type only
        if isinstance(leg_length, int | float) and len(settings.get("unit", ())) < 2:
            return (UnitSize(None, None, float(leg_length)),)
    return ()


def _unit_size(record: Row) -> UnitSize:
    opening: Opening = "paper" if record["opening"] == "paper" else "tetrahedral"
    return UnitSize(str(record["name"]), float(record["height"]), float(record["leg_length"]), opening)


def size_of(row: Row, sizes: Sequence[UnitSize]) -> UnitSize:
    """Size of the unit of a row of ``units`` by its type, of two types of one name by its height; standard proportions for others."""
    name, height = row.get("unit_type"), float(row["height"])
    known = [size for size in sizes if size.name in (None, name)]
    if not known:
        return UnitSize(name, height, LEG_LENGTH_RATIO * height)
    return min(known, key=lambda size: abs((size.height or height) - height))


def unit_of(row: Row, sizes: Sequence[UnitSize]) -> UnitType:
    """Geometry of the unit of a row of ``units``, as fitted."""
    check_pose(row)
    size = size_of(row, sizes)
    return UnitType.tetrapod(
        row["height"],
        radius=row["r0"],
        gradient=row["gradient"],
        leg_length=size.leg_length,
        opening=size.opening,
        name=row.get("unit_type") or "tetrapod",
    )


def shape_of(row: Row, sizes: Sequence[UnitSize] = ()) -> PlacedShape | None:
    """Outline of a row of ``units``; None where it has no geometry or no pose."""
    if row["geom"] is None or row["qw"] is None:
        return None
    check_pose(row)
    rotation = rotation_of_quaternion([row["qx"], row["qy"], row["qz"], row["qw"]])
    size = size_of(row, sizes)
    return PlacedShape(
        centre=row["geom"],
        rotation=rotation,
        radius=float(row["r0"]),
        gradient=float(row["gradient"]),
        leg_length=size.leg_length,
        legs=leg_directions(size.opening),
    )
