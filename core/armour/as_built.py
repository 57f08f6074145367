"""The as-built model of one epoch: what every export format is written from."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass, replace
from datetime import datetime
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..model.facets import Facets, facets
from ..model.outline import PlacedShape
from ..model.unit_types import UnitType
from ..results.geopackage_reader import ResultCrs, Row, crs_of, read_layer_rows
from ..results.unit_rows import EpochInfo, read_epochs, unit_sizes
from ..results.unit_sizes import shape_of, unit_of

SIDES = 24
"""Faces around a leg of an exported unit."""
RADIUS_DECIMALS, GRADIENT_DECIMALS = 3, 4
"""Rounding of radius (m) and taper within which units share one solid, which moves no place of a surface by more than 0.6 mm; the radius of
units lower than a metre has as many digits more as their height has less."""

FULL_HEIGHT = 2.0
"""Height H from which lengths that are stated in metres suit units; smaller units, and models of a tank, take the same share of theirs."""


def of_height(metres: float, height: float) -> float:
    """A length that suits units of ``FULL_HEIGHT`` and more, for units of a height H; both in metres."""
    return metres * min(1.0, height / FULL_HEIGHT)


@dataclass(frozen=True, eq=False)
class Solid:
    """A solid that units share: nominal type with the fitted radius and gradient, rounded."""

    unit: UnitType

    @cached_property
    def faces(self) -> Facets:
        """Faces in the body frame, metres."""
        return facets(self.unit.in_body, SIDES)


@dataclass(frozen=True, kw_only=True, eq=False)
class BuiltUnit:
    """One unit of the model.

    Attributes
    ----------
    unit_id, kind, status
        Name, class of its displacement from the epoch before (status where it has none), and status in the epoch.
    solid
        Index into ``AsBuilt.solids``.
    shape
        Pose and shape, survey CRS.
    row, motion
        Its row of ``units``, and of ``displacements`` (centre, from the epoch before) where it has one.
    """

    unit_id: str
    kind: str
    status: str
    solid: int
    shape: PlacedShape
    row: Row
    motion: Row | None

    @property
    def quaternion(self) -> tuple[float, float, float, float]:
        """qx, qy, qz, qw of the rotation body to CRS axes, of length one."""
        q = np.array([self.row[name] for name in ("qx", "qy", "qz", "qw")], dtype=np.float64)
        x, y, z, w = (float(v) for v in q / np.linalg.norm(q))
        return x, y, z, w

    @property
    def properties(self) -> dict[str, Any]:
        """What the formats tell of a unit beside its pose; standard deviations in metres and degrees, values that are unknown left out."""
        known: dict[str, Any] = {"unit_id": self.unit_id, "class": self.kind, "status": self.status}
        known |= {name: self.row.get(name) for name in ("unit_type", "height", "sd_e", "sd_n", "sd_h", "sd_rotation_deg", "coverage")}
        if self.motion is not None:
            names = ("epoch_from", "de", "dn", "dh", "d_3d", "rotation_deg", "p_value", "datum")
            known |= {name: self.motion.get(name) for name in names} | {"significant": bool(self.motion["significant"])}
        return {name: value for name, value in known.items() if value is not None}


@dataclass(frozen=True, kw_only=True, eq=False)
class AsBuilt:
    """All units of one epoch.

    Attributes
    ----------
    name, epoch, time
        Survey, label of the epoch and its time.
    crs
        CRS of the poses.
    offset
        (3,) reduction point, whole metres: formats whose readers compute in single precision hold coordinates less this point.
    solids, units
        Distinct solids, and the units that refer to them by index.
    """

    name: str
    epoch: str
    time: datetime | None
    crs: ResultCrs
    offset: FloatArray
    solids: tuple[Solid, ...]
    units: tuple[BuiltUnit, ...]

    def without(self, unit_ids: Collection[str]) -> AsBuilt:
        """The model without some units, by name."""
        return replace(self, units=tuple(unit for unit in self.units if unit.unit_id not in unit_ids)) if unit_ids else self

    @property
    def height(self) -> float:
        """Nominal height H of its smallest unit, metres."""
        return min(float(unit.row["height"]) for unit in self.units)


def read_as_built(result: Path, epoch: str | None = None) -> AsBuilt:
    """Units of one epoch of a result, by default the latest that has any.

    Raises
    ------
    InputError
        The file cannot be read, has no such epoch, or no unit of the epoch has a pose.
    """
    epochs = read_epochs(result)
    sizes = unit_sizes(epochs)
    rows = [row for row in read_layer_rows(result, "units") if row["geom"] is not None and row["qw"] is not None]
    chosen = _chosen(result, epochs, rows, epoch)
    moved = {
        row["unit_id"]: row
        for row in read_layer_rows(result, "displacements")
        if row["epoch_to"] == chosen.label and row["feature"] == "centre"
    }
    solids: dict[tuple[Any, ...], int] = {}
    kinds: list[Solid] = []
    units = []
    for row in rows:
        shape = shape_of(row, sizes) if row["epoch"] == chosen.label else None
        if shape is None:
            continue
        nominal = unit_of(row, sizes)
        decimals = RADIUS_DECIMALS - min(0, math.floor(math.log10(nominal.height)))
        unit = nominal.with_shape(round(shape.radius, decimals), round(shape.gradient, GRADIENT_DECIMALS))
        key = (unit.name, unit.height, unit.radius, unit.gradient, unit.leg_length, unit.opening)
        if key not in solids:
            solids[key] = len(kinds)
            kinds.append(Solid(unit))
        motion = moved.get(row["unit_id"])
        kind = str(row["status"] if motion is None else motion["class"])
        units.append(
            BuiltUnit(
                unit_id=str(row["unit_id"]),
                kind=kind,
                status=str(row["status"]),
                solid=solids[key],
                shape=shape,
                row=row,
                motion=motion,
            )
        )
    units.sort(key=lambda unit: unit.unit_id)
    offset = np.asarray(np.round(np.array([unit.shape.centre for unit in units]).mean(axis=0)))
    return AsBuilt(
        name=str(chosen.settings.get("survey") or result.stem),
        epoch=chosen.label,
        time=chosen.time,
        crs=crs_of(result),
        offset=offset,
        solids=tuple(kinds),
        units=tuple(units),
    )


def _chosen(result: Path, epochs: tuple[EpochInfo, ...], rows: list[Row], label: str | None) -> EpochInfo:
    """The epoch asked for, or the latest with units."""
    have = {row["epoch"] for row in rows}
    possible = [epoch for epoch in epochs if epoch.label in have]
    if not possible:
        raise InputError("holds no unit with a pose", source=result, remedy="Choose a result of tetratrack run.")
    if label is None:
        return possible[-1]
    found = next((epoch for epoch in possible if epoch.label == label), None)
    if found is None:
        known = ", ".join(epoch.label for epoch in possible)
        raise InputError(f"has no units of an epoch {label!r}", source=result, remedy=f"Epochs with units are: {known}.")
    return found
