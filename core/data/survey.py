"""A survey: what was surveyed, when and with which files; read from a survey.toml by ``survey_reader``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any, Literal

from ..common.errors import InputError
from ..model.mould import Mould
from ..model.unit_types import UnitType

Ring = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class LayerFile:
    """A vector file and the name of one of its layers, empty where it has but one."""

    path: Path
    layer: str = ""


@dataclass(frozen=True)
class SurveyUnit:
    """A type of unit that the survey holds.

    Attributes
    ----------
    type
        Nominal geometry.
    calibrate
        Estimate radius and gradient of the type for this survey from the best-seen units, then hold them.
    area
        Ring of (easting, northing) inside which units of this type lie; None for everywhere.
    mould
        What an earlier survey says of their moulds and castings, to be held; None to learn it.
    """

    type: UnitType
    calibrate: bool = False
    area: Ring | None = None
    mould: Mould | None = None


@dataclass(frozen=True, kw_only=True)
class Epoch:
    """One survey of the site; paths are absolute.

    Attributes
    ----------
    label, time
        Name used in all layers; UTC.
    tiles
        LAS/LAZ/COPC files, sorted, each once.
    control, targets, check
        CSV files of surveyed targets, of the targets measured in the cloud and of check points, or None.
    tiles_crs
        CRS of the tiles' coordinates, which overrules their headers, or None.
    undeclared_crs
        CRS of tiles whose header declares none that can be understood, or None.
    control_crs, control_unit
        CRS of the control file, None for the survey's, and length unit of its numbers.
    control_axes, control_sd
        ``ne`` where the control file's first coordinate is the northing, whatever its name; standard deviation of its coordinates, in
        the unit of the file, where it states none.
    trajectory, stations
        CSV files of the sensor's positions by GPS time, and by point source ID, or None.
    range_sd, angle_sd
        Standard deviations of a range, metres, and of each direction of a beam, degrees; None where the sensor's position is not known.
    """

    label: str
    time: datetime
    tiles: tuple[Path, ...]
    control: Path | None = None
    targets: Path | None = None
    check: Path | None = None
    tiles_crs: str | None = None
    control_crs: str | None = None
    control_unit: Literal["m", "ft", "us-ft"] = "m"
    control_axes: Literal["en", "ne"] = "en"
    control_sd: float | None = None
    trajectory: Path | None = None
    stations: Path | None = None
    undeclared_crs: str | None = None
    range_sd: float | None = None
    angle_sd: float | None = None

    @property
    def files(self) -> tuple[Path, ...]:
        """All files the epoch is made of."""
        others = (self.control, self.targets, self.check, self.trajectory, self.stations)
        return (*self.tiles, *(path for path in others if path is not None))


@dataclass(frozen=True, kw_only=True)
class Survey:
    """A whole survey.toml.

    Attributes
    ----------
    path
        The file, absolute.
    name, crs, description
        ``crs`` as written, for example ``EPSG:32650`` or ``LOCAL``.
    units
        Types of unit, at least one.
    epochs
        In order of time.
    sections
        Checked values of the optional sections, by section and key, with defaults filled in.
    stable_areas
        Polygon layer of surfaces that tie epochs without control to the reference epoch, or None.
    frame
        Whether the frames of epochs may bend: ``auto``, ``rigid`` or ``elastic``.
    size_check
        Whether the size of the units is held against the cloud before a run.
    moulds
        Files of the moulds that are used.
    """

    path: Path
    name: str
    crs: str
    description: str
    units: tuple[SurveyUnit, ...]
    epochs: tuple[Epoch, ...]
    sections: Mapping[str, Mapping[str, Any]]
    stable_areas: LayerFile | None = None
    frame: Literal["auto", "rigid", "elastic"] = "auto"
    size_check: bool = True
    moulds: tuple[Path, ...] = ()

    @property
    def files(self) -> tuple[Path, ...]:
        """Every file that the survey is described and made of."""
        areas = () if self.stable_areas is None else (self.stable_areas.path,)
        return (self.path, *areas, *self.moulds, *(path for epoch in self.epochs for path in epoch.files))

    @property
    def unit(self) -> UnitType:
        """Nominal geometry of the first type of unit."""
        return self.units[0].type

    @property
    def reference(self) -> Epoch:
        """Epoch that epochs without control are tied to: the earliest with control, else the first."""
        return next((epoch for epoch in self.epochs if epoch.control is not None), self.epochs[0])

    def epoch(self, label: str) -> Epoch:
        """Epoch of a label."""
        for epoch in self.epochs:
            if epoch.label == label:
                return epoch
        labels = ", ".join(epoch.label for epoch in self.epochs)
        raise InputError(f"has no epoch {label!r}", source=self.path, remedy=f"Epochs are: {labels}.")


def inside(ring: Ring, easting: float, northing: float) -> bool:
    """Whether a position lies in a closed ring of corners (even-odd rule)."""
    within = False
    for (e1, n1), (e2, n2) in zip(ring, ring[1:] + ring[:1], strict=True):
        if (n1 > northing) != (n2 > northing) and easting < (e2 - e1) * (northing - n1) / (n2 - n1) + e1:
            within = not within
    return within
