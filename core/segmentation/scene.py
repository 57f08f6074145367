"""The thinned cloud that poses are held against, and what it says about them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..common.arrays import FloatArray
from ..common.neighbourhood import Grid, build_grid
from ..model.unit_types import UnitType
from .cone_relation import OrientedPoints
from .surface_elements import SurfaceElements

CELL_RATIO = 0.13
"""Edge of the cells by which elements are found, as a share of the height: a neighbourhood is some cells wide."""
COLUMNS = ("support", "close", "inside", "cells", "legs", "misfit", "reached")
SUPPORT, CLOSE, INSIDE, CELLS, LEGS, MISFIT, REACHED = range(len(COLUMNS))
"""Columns of the table that compiled loops fill; elsewhere they go by name, see :class:`Evidence`."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Scene:
    """Surface elements in which units of one type are looked for.

    Attributes
    ----------
    points, normals, curved
        As in :class:`.surface_elements.SurfaceElements`.
    grid
        Over the points.
    unit
        Nominal geometry.
    tolerance
        Distance to a surface within which an element supports it, metres.
    noise
        Standard deviation of a raw point across the surface, metres: tells how far tips and fillets can be seen at all.
    normal_radius
        Radius of the neighbourhoods of the normals, metres: near a crease they are of both legs.
    spacing
        Median distance of a raw point to its nearest neighbour, metres.
    smoothed
        Whether noise was taken off the points (:mod:`.smoothed_surface`).
    layered
        Whether layers before the surface were (:mod:`.innermost_layer`).
    shared_noise
        Whether neighbours share their noise (:mod:`.shared_noise`).
    """

    points: FloatArray
    normals: FloatArray
    curved: NDArray[np.int8]
    grid: Grid
    unit: UnitType
    tolerance: float
    noise: float
    normal_radius: float = 0.0
    spacing: float = 0.0
    smoothed: bool = False
    layered: bool = False
    shared_noise: bool = False

    @property
    def elements(self) -> OrientedPoints:
        """Points, normals and whether these are bent, as compiled loops take them."""
        return OrientedPoints(self.points, self.normals, self.curved)

    @classmethod
    def of(cls, elements: SurfaceElements, unit: UnitType, tolerance: float) -> Scene:
        """Of the elements of a cloud."""
        return cls(
            points=elements.points,
            normals=elements.normals,
            curved=elements.curved,
            grid=build_grid(elements.points, CELL_RATIO * unit.height),
            unit=unit,
            tolerance=tolerance,
            noise=elements.noise,
            normal_radius=elements.normal_radius,
            spacing=elements.spacing,
            smoothed=elements.smoothed,
            layered=elements.layered,
            shared_noise=elements.shared_noise,
        )


@dataclass(frozen=True, eq=False)
class Evidence:
    """What the elements say about each of k poses, as columns (k,) by name; an index gives the same of some poses.

    Attributes
    ----------
    table
        (k, 7) in the order of ``COLUMNS``.
    """

    table: FloatArray

    @classmethod
    def joined(cls, several: Sequence[Evidence]) -> Evidence:
        """Of several lots of poses, one after the other."""
        return cls(np.vstack([np.zeros((0, len(COLUMNS))), *(some.table for some in several)]))

    def __len__(self) -> int:
        """Number of poses."""
        return len(self.table)

    def __getitem__(self, some: int | NDArray[np.bool_] | NDArray[np.int64]) -> Evidence:
        """Of one pose by its number, or of some by numbers or a mask."""
        return Evidence(np.atleast_2d(self.table[some]))

    def replaced(self, **columns: ArrayLike) -> Evidence:
        """The same with other values in some columns."""
        table = self.table.copy()
        for name, values in columns.items():
            table[:, COLUMNS.index(name)] = values
        return Evidence(table)

    @property
    def support(self) -> FloatArray:
        """Active elements on the surface whose normal agrees."""
        return self.table[:, SUPPORT]

    @property
    def close(self) -> FloatArray:
        """All active elements on the surface but those on rounded tips and fillets whose normal does not agree."""
        return self.table[:, CLOSE]

    @property
    def inside(self) -> FloatArray:
        """Elements, active or not, deep within the solid but for the outer part of one leg, which may be broken off."""
        return self.table[:, INSIDE]

    @property
    def cells(self) -> FloatArray:
        """Surface cells that hold support."""
        return self.table[:, CELLS]

    @property
    def legs(self) -> FloatArray:
        """Legs with at least two such cells."""
        return self.table[:, LEGS]

    @property
    def misfit(self) -> FloatArray:
        """Root mean square distance of the support from the surface, metres."""
        return self.table[:, MISFIT]

    @property
    def reached(self) -> FloatArray:
        """Active elements near the unit."""
        return self.table[:, REACHED]
