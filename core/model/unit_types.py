"""Types of armour unit: proportions, catalogue by mass, and the quantities engineers derive from them.

Proportions of a built tetrapod after the Shore Protection Manual (US Army CERC, 1984, vol. II, fig. 7-110), as fractions of
its height H: end-disc radius B = 0.151, cone length C = 0.477, cone root radius E = 0.235, centre to end disc F = 0.644.
"""

from __future__ import annotations

import itertools
import math
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property, lru_cache
from typing import Any, Literal

import numpy as np

from ..common.arrays import FloatArray
from .outline import PlacedShape, volume

Opening = Literal["tetrahedral", "paper"]

END_RADIUS_RATIO, CONE_LENGTH_RATIO, ROOT_RADIUS_RATIO, LEG_LENGTH_RATIO = 0.151, 0.477, 0.235, 0.644
GRADIENT = (ROOT_RADIUS_RATIO - END_RADIUS_RATIO) / CONE_LENGTH_RATIO
RADIUS_RATIO = ROOT_RADIUS_RATIO + GRADIENT * (LEG_LENGTH_RATIO - CONE_LENGTH_RATIO)
CONCRETE_DENSITY = 2.35
"""t/m3; plain concrete of armour units is 2.3 to 2.4 (Rock Manual, CIRIA 2007, 3.12)."""

OPENING_ANGLES: dict[Opening, float] = {"tetrahedral": math.acos(-1 / 3), "paper": math.radians(120)}
"""Angle in radians between leg 1 and each other leg; the paper's eqs. (5)-(7) give 120 degrees."""

CATALOGUE_MASSES = (0.5, 1, 2, 3.2, 4, 5, 6.3, 8, 10, 12.5, 16, 20, 25, 32, 40, 50, 64, 80)
"""Customary nominal masses in tonnes."""


@dataclass(frozen=True)
class UnitType:
    """Nominal geometry of a unit: four equal conical frusta with a common centre (paper eqs. 1, 5-7).

    Attributes
    ----------
    name
        Name as given by the user or the catalogue.
    height
        Nominal height H, metres: from the plane under three legs to the top of the fourth.
    radius
        Radius r of a leg's cone at the unit's centre, metres.
    gradient
        Loss c of radius per metre along the leg's axis.
    leg_length
        Distance from the centre to the end disc, metres.
    opening
        ``tetrahedral`` (arccos(-1/3) between every two legs) or ``paper`` (120 degrees between leg 1 and the others).
    """

    name: str
    height: float
    radius: float
    gradient: float
    leg_length: float
    opening: Opening = "tetrahedral"

    def __post_init__(self) -> None:
        for field in ("height", "radius", "gradient", "leg_length"):
            value = getattr(self, field)
            if not math.isfinite(value) or value <= 0:
                raise ValueError(f"unit {field} must be a positive number, got {value!r}")
        if self.opening not in OPENING_ANGLES:
            raise ValueError(f"unit opening must be 'tetrahedral' or 'paper', got {self.opening!r}")
        if self.end_radius <= 0:
            raise ValueError("unit legs would taper to a point before their end: gradient or leg_length is too large")

    def __getstate__(self) -> dict[str, Any]:
        """What a copy for another process takes along: the values, and not what was derived from them.

        Copied arrays could be written to, and loops would be compiled anew for them; a process makes its own, which all units share.
        """
        return {field.name: getattr(self, field.name) for field in fields(self)}

    @classmethod
    def tetrapod(
        cls,
        height: float,
        *,
        radius: float | None = None,
        gradient: float | None = None,
        leg_length: float | None = None,
        opening: Opening = "tetrahedral",
        name: str = "tetrapod",
    ) -> UnitType:
        """Tetrapod of a height in metres; what is not given follows the standard proportions."""
        return cls(
            name,
            float(height),
            RADIUS_RATIO * height if radius is None else float(radius),
            GRADIENT if gradient is None else float(gradient),
            LEG_LENGTH_RATIO * height if leg_length is None else float(leg_length),
            opening,
        )

    @property
    def end_radius(self) -> float:
        """Radius of the end disc, metres."""
        return self.radius - self.gradient * self.leg_length

    @property
    def reach(self) -> float:
        """Distance from the centre to the farthest point of the surface, the rim of an end disc, metres."""
        return math.hypot(self.leg_length, self.end_radius)

    @cached_property
    def leg_directions(self) -> FloatArray:
        """(4, 3) unit vectors of the legs' axes in the body frame, legs 1 to 4."""
        return leg_directions(self.opening)

    @cached_property
    def symmetries(self) -> FloatArray:
        """(k, 3, 3) rotations that map the body onto itself: 12 for the tetrahedral opening, 3 for the paper's."""
        return _symmetries(self.opening)

    @cached_property
    def leg_pairs(self) -> list[tuple[int, int]]:
        """Ordered pairs of legs, 0 to 3, none of which a symmetry turns into another: 1 for the tetrahedral opening, 4 for the paper's."""
        legs = self.leg_directions
        # the leg in whose place each symmetry puts every leg
        places = np.argmax(np.einsum("ij,sjk,lk->sli", legs, self.symmetries, legs), axis=2)
        return [pair for pair in itertools.permutations(range(4), 2) if pair == min((int(to[pair[0]]), int(to[pair[1]])) for to in places)]

    @cached_property
    def numberings(self) -> FloatArray:
        """(k, 3, 3) rotations that put legs as near as can be into other legs' places: one for each leg that leg 1 cannot be told from.

        The first is the identity, which is all there is for the tetrahedral opening; 4 for the paper's, whose leg 1 stands at wider angles.
        """
        return _numberings(self.opening)

    @cached_property
    def volume(self) -> float:
        """Volume of the union of the four frusta, m3."""
        return _volume(self.radius, self.gradient, self.leg_length, self.opening)

    @property
    def nominal_diameter(self) -> float:
        """Dn = volume^(1/3), metres."""
        return float(self.volume ** (1 / 3))

    def mass(self, density: float = CONCRETE_DENSITY) -> float:
        """Mass in tonnes for a density in t/m3."""
        return self.volume * density

    @property
    def crotch_distance(self) -> float:
        """Distance from the centre to the joint of three legs, metres (paper eqs. 10-13, closed form for the tetrahedral opening)."""
        angle = math.acos(1 / 3)
        return self.radius / (math.sin(angle) + self.gradient * math.cos(angle))

    @property
    def in_body(self) -> PlacedShape:
        """The unit in its body frame."""
        return PlacedShape(
            centre=np.zeros(3),
            rotation=np.eye(3),
            radius=self.radius,
            gradient=self.gradient,
            leg_length=self.leg_length,
            legs=np.asarray(self.leg_directions),
        )

    def with_shape(self, radius: float, gradient: float) -> UnitType:
        """The same unit with a calibrated radius and gradient."""
        return replace(self, radius=float(radius), gradient=float(gradient))


def height_of_mass(mass: float, density: float = CONCRETE_DENSITY) -> float:
    """Height in metres of a standard tetrapod of a mass in tonnes."""
    unit = UnitType.tetrapod(1.0)
    return float((mass / (density * unit.volume)) ** (1 / 3))


def catalogue() -> dict[str, UnitType]:
    """Standard tetrapods by name, for example ``tetrapod 8 t``."""
    return {name: UnitType.tetrapod(height_of_mass(m), name=name) for m in CATALOGUE_MASSES for name in [f"tetrapod {m:g} t"]}


def catalogue_unit(name: str) -> UnitType | None:
    """Unit named ``tetrapod <mass> t``, any positive mass; None for any other name."""
    match = re.fullmatch(r"\s*tetrapod\s+(\d+(?:\.\d+)?)\s*t\s*", name, flags=re.IGNORECASE)
    if match is None or float(match[1]) <= 0:
        return None
    return UnitType.tetrapod(height_of_mass(float(match[1])), name=" ".join(name.split()))


def sized_name(unit: UnitType) -> str:
    """Name of a type among others of its name: with its height, as in "tetrapod 2.3 m"."""
    return f"{unit.name} {unit.height:g} m"


def told_apart(units: Sequence[UnitType]) -> tuple[UnitType, ...]:
    """The types of a survey with a name each, by which results tell them apart.

    Of several of one name each gets its height into it (:func:`sized_name`), and of those of one height too all but the first a number.
    """
    often = Counter(unit.name for unit in units)
    taken = {name for name, count in often.items() if count == 1}
    named = []
    for unit in units:
        name = unit.name
        if often[name] > 1:
            sized = sized_name(unit)
            name = next(own for k in itertools.count(1) if (own := sized if k == 1 else f"{sized} ({k})") not in taken)
            taken.add(name)
        named.append(replace(unit, name=name))
    return tuple(named)


@lru_cache(maxsize=None)
def leg_directions(opening: Opening) -> FloatArray:
    """(4, 3) unit vectors of the legs' axes in the body frame, legs 1 to 4."""
    polar = OPENING_ANGLES[opening]
    azimuth = np.radians([0.0, 120.0, 240.0])
    lower = np.column_stack([math.sin(polar) * np.cos(azimuth), math.sin(polar) * np.sin(azimuth), np.full(3, math.cos(polar))])
    directions = np.vstack([[0.0, 0.0, 1.0], lower])
    directions.setflags(write=False)
    return directions


@lru_cache(maxsize=None)
def _symmetries(opening: Opening) -> FloatArray:
    # outlines and types of unit are also needed in QGIS's own Python, which may lack SciPy
    from scipy.spatial.transform import Rotation

    turns = [Rotation.from_rotvec([0, 0, k * 2 * math.pi / 3]) for k in range(3)]
    if opening == "tetrahedral":
        # identity and the half-turns about the three axes that bisect a pair of legs, each followed by the thirds about leg 1
        legs = leg_directions(opening)
        half_turns = [Rotation.identity()]
        half_turns += [Rotation.from_rotvec(math.pi * b / np.linalg.norm(b)) for b in (legs[0] + legs[k] for k in (1, 2, 3))]
        turns = [h * t for h in half_turns for t in turns]
    matrices = np.array([t.as_matrix() for t in turns])
    matrices.setflags(write=False)
    return matrices


@lru_cache(maxsize=None)
def _numberings(opening: Opening) -> FloatArray:
    from scipy.spatial.transform import Rotation

    legs = leg_directions(opening)
    others = () if opening == "tetrahedral" else (1, 2, 3)
    # leg 1 and another change places, and so do the two that are left
    matrices = np.array([np.eye(3), *(Rotation.align_vectors(legs[np.arange(4) ^ k], legs)[0].as_matrix() for k in others)])
    matrices.setflags(write=False)
    return matrices


@lru_cache(maxsize=256)
def _volume(radius: float, gradient: float, leg_length: float, opening: Opening) -> float:
    legs = leg_directions(opening)
    return volume(PlacedShape(centre=np.zeros(3), rotation=np.eye(3), radius=radius, gradient=gradient, leg_length=leg_length, legs=legs))
