"""What to simulate: instrument, site, units, changes and epochs of a virtual survey."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from datetime import date

from ..common.errors import InputError
from ..data.crs import check_survey_crs, place_in_use
from ..model.unit_types import Opening, UnitType
from .armour_pile import Changes
from .bent_frames import RIGID, FrameErrors
from .virtual_instruments import INSTRUMENTS, Instrument

STRETCH_NUMBERS = 1000
"""Numbers of units that one stretch of a coast may take."""
UNITS_TO_A_BROKEN_ONE = 38
"""Units of which one has a broken leg, unless a plan says how many have."""
LABORATORY_HEIGHT = 0.105
"""Nominal height of the models on a table, metres."""


@dataclass(frozen=True)
class SimulationPlan:
    """What to simulate.

    Attributes
    ----------
    name
        Name of the survey and prefix of its tiles.
    instrument
        ``uav``, ``tls``, ``photogrammetry`` or ``depth_camera``.
    units
        Number of units of the first epoch; 0 gives rock, wall and water only, or the table.
    height
        Nominal unit height, metres.
    epochs
        Number of epochs.
    seed
        Seed of everything random; the same plan gives the same survey.
    density
        Points per square metre, or None for the instrument's own.
    noise
        Range noise in metres (standard deviation), or None for the instrument's own.
    crs
        Projected or compound CRS of the site, or ``LOCAL``.
    las_crs
        CRS declared by the tiles where it differs (a compound CRS with the same horizontal part).
    origin
        Easting, northing and height of the site's origin.
    azimuth_deg
        Direction of the wall's outward normal, degrees clockwise from north.
    changes
        Changes between consecutive epochs; None for a typical number.
    tiles
        Number of tiles along easting and northing.
    first_day
        Date of the first epoch.
    radius, gradient, leg_length
        Proportions of the units where they are not the standard ones.
    opening
        ``tetrahedral``, or ``paper`` (120 degrees between leg 1 and the others).
    castings
        Units differ from the ideal cones as real castings do.
    bridging
        Radius in metres of the narrowest hollow that the matching of images follows; 0 where it follows all. Instruments other than
        photogrammetry bridge none and refuse it.
    other_views
        Later epochs are flown along other lines, or scanned from other stations.
    frame
        What the frames of epochs err beyond a rigid motion; targets share it, the mean of drifting strips left out.
    length
        Length of a coast in metres, made of stretches of ``units`` units each (:mod:`.coast`); 0 for one site.
    targets_every
        Distance of the stations of targets along a coast, metres; 0 for a coast without control.
    broken
        Units of the first epoch, or of each stretch of a coast, that have a broken leg; None for one of 38. Models on a table have none.
    slide
        How far the middle stretch of a coast slides seaward and down between the first two epochs, metres.
    """

    name: str
    instrument: Instrument = "uav"
    units: int = 75
    height: float = 2.3
    epochs: int = 2
    seed: int = 0
    density: float | None = None
    noise: float | None = None
    crs: str = "EPSG:32650"
    las_crs: str | None = None
    origin: tuple[float, float, float] = (500_000.0, 3_500_000.0, 0.0)
    azimuth_deg: float = 30.0
    changes: Changes | None = None
    tiles: tuple[int, int] = (2, 2)
    first_day: date = date(2024, 4, 9)
    radius: float | None = None
    gradient: float | None = None
    leg_length: float | None = None
    opening: Opening = "tetrahedral"
    castings: bool = False
    bridging: float = 0.0
    other_views: bool = False
    frame: FrameErrors = RIGID
    length: float = 0.0
    targets_every: float = 24.0
    slide: float = 0.0
    broken: int | None = None

    def __post_init__(self) -> None:
        if self.instrument not in INSTRUMENTS:
            raise InputError(
                f"instrument {self.instrument!r} is not known", where="instrument", remedy=f"Use one of: {', '.join(INSTRUMENTS)}."
            )
        if not self.name or any(c in self.name for c in '/\\"*?[]'):
            raise InputError(
                f"survey name {self.name!r} cannot be used in file names", where="name", remedy="Use letters, digits and underscores."
            )
        for field, low in (("units", 0), ("epochs", 1), ("height", 1e-3)):
            value = getattr(self, field)
            if not math.isfinite(value) or value < low:
                raise InputError(f"{field} must be at least {low}, got {value!r}", where=field, remedy="Correct the number.")
        if self.broken is not None and (not 0 <= self.broken <= self.units or self.laboratory):
            raise InputError(
                f"{self.broken} units of {self.units} with a broken leg cannot be simulated by {self.instrument}",
                where="broken",
                remedy="Use 0 to all units and uav, tls or photogrammetry, or leave it out for a typical number.",
            )
        for field in ("density", "noise"):
            value = getattr(self, field)
            if value is not None and (not math.isfinite(value) or value <= 0):
                raise InputError(
                    f"{field} must be a positive number, got {value!r}", where=field, remedy="Leave it out for the instrument's own."
                )
        for field in ("length", "targets_every", "slide", "bridging"):
            value = getattr(self, field)
            if not math.isfinite(value) or value < 0:
                raise InputError(f"{field} must be 0 or a positive number, got {value!r}", where=field, remedy="Correct the number.")
        if self.bridging > 0 and self.instrument != "photogrammetry":
            raise InputError(
                f"{self.instrument} bridges no hollows: it measures every point by itself",
                where="bridging",
                remedy="Use instrument photogrammetry, or leave bridging at 0.",
            )
        if self.length > 0 and (self.laboratory or not 0 < self.units < STRETCH_NUMBERS):
            raise InputError(
                f"a coast of {self.units} units a stretch cannot be simulated by {self.instrument}",
                where="length",
                remedy=f"Use uav, tls or photogrammetry and 1 to {STRETCH_NUMBERS - 1} units a stretch.",
            )
        if self.slide > 0 and (self.length <= 0 or self.epochs < 2):
            raise InputError(
                "nothing slides on one pile or in one epoch",
                where="slide",
                remedy="Give the length of a coast and two epochs or more, or leave slide at 0.",
            )
        if min(self.tiles) < 1:
            raise InputError("tiles must be at least 1 x 1", where="tiles", remedy="Correct the numbers.")

    @property
    def laboratory(self) -> bool:
        """Whether models on a table are surveyed instead of a breakwater."""
        return self.instrument == "depth_camera"

    @property
    def broken_units(self) -> int:
        """Units of the first epoch, or of a stretch of a coast, with a broken leg."""
        return round(self.units / UNITS_TO_A_BROKEN_ONE) if self.broken is None else self.broken

    @property
    def unit(self) -> UnitType:
        """Nominal unit."""
        return UnitType.tetrapod(self.height, radius=self.radius, gradient=self.gradient, leg_length=self.leg_length, opening=self.opening)


def usual_height(instrument: str) -> float:
    """Nominal height in metres of the units that an instrument is simulated with where none is given: of a breakwater, or of models."""
    return LABORATORY_HEIGHT if instrument == "depth_camera" else SimulationPlan.height


def plan_of(
    instrument: str,
    name: str,
    unit: UnitType | None = None,
    *,
    units: int | None = None,
    epochs: int = 2,
    seed: int = 0,
    density: float | None = None,
    noise: float | None = None,
    crs: str = SimulationPlan.crs,
    castings: bool = False,
    bridging: float = 0.0,
    other_views: bool = False,
    frame: FrameErrors = RIGID,
    length: float = 0.0,
    targets_every: float = SimulationPlan.targets_every,
    slide: float = 0.0,
    broken: int | None = None,
) -> SimulationPlan:
    """Plan for one instrument with a place and numbers that suit it: a breakwater, or models on a table for the depth camera.

    The breakwater lies where others do unless its CRS is not for use there; then it lies in the middle of the area that the CRS is for.

    Raises
    ------
    InputError
        Something cannot be simulated; it names the field.
    """
    if instrument not in INSTRUMENTS:
        raise InputError(f"instrument {instrument!r} is not known", where="instrument", remedy=f"Use one of: {', '.join(INSTRUMENTS)}.")
    laboratory = SimulationPlan(
        name, "depth_camera", 4, LABORATORY_HEIGHT, crs="LOCAL", origin=(1.0, 1.8, 0.75), azimuth_deg=0.0, tiles=(2, 1),
        first_day=date(2025, 2, 10),
    )  # fmt: skip
    if instrument == "depth_camera":
        base = laboratory
    else:
        check_survey_crs(crs, where="crs")
        easting, northing, height = SimulationPlan.origin
        base = SimulationPlan(name, instrument, crs=crs, origin=(*place_in_use(crs, easting, northing), height))
    if unit is not None:
        base = replace(
            base, height=unit.height, radius=unit.radius, gradient=unit.gradient, leg_length=unit.leg_length, opening=unit.opening
        )
    return replace(
        base, units=base.units if units is None else units, epochs=epochs, seed=seed, density=density, noise=noise,
        castings=castings, bridging=bridging, other_views=other_views, frame=frame, length=length, targets_every=targets_every, slide=slide,
        broken=broken,
    )  # fmt: skip
