"""How units lie: density, packing, spacing, layers, orientation, contacts, columns and distance from their mean surface.

Every figure is defined in docs/placement.md with its source. Armours bend with the coast and go over the crest, so that a unit is looked at
in the plane through its own neighbours, not in one plane for all.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..model.outline import PlacedShape, nominal_diameter
from ..results.unit_bodies import polygon_area
from .contacts import free_gaps, reach_of

FEWEST_UNITS = 12
"""Units below which no figure is stated: hardly one of them has neighbours on all sides."""
NEIGHBOURS = 24
"""Nearest units that span the plane a unit is looked at in."""
EDGE_CELL = 2.0
"""A cell larger than this many times the median belongs to the edge of the armour, or to a gap in it."""
OVER_ALONG, OVER_ACROSS = 0.5, 0.7
"""A unit lies over another: in nominal diameters its centre is higher by the first (half a layer), and aside by less than the second."""
CONTACT_HEIGHTS = 0.01
"""Gap over H up to which two units count as touching: what poses are good for, and concrete is cast to."""
FLAT_SLOPE = math.radians(10)
"""Below this slope there is no up and down, and no column."""
COLUMN_ANGLE, BELOW_ANGLE = math.radians(15), math.radians(45)
"""The next unit down the slope is looked for within the second angle of the slope's line; within the first the two stand in a column."""


@dataclass(frozen=True, eq=False, kw_only=True)
class UnitPlacement:
    """Placement of n units, in their order; NaN where a figure cannot be told.

    Attributes
    ----------
    nominal_diameter
        Dn of the units as fitted, metres.
    layer
        (n,) 1 for units that none lies over, one more for each layer above.
    inner
        (n,) the unit has neighbours on all sides.
    cell
        (n,) area that is nearer to the unit than to any other of its layer, m2; NaN at the edge.
    spacing
        (n,) distance to the nearest centre over Dn.
    turn
        (n,) turn against the nearest neighbour of the layer, degrees.
    off_surface
        (n,) distance from the plane through the neighbours of the outer layer, metres, positive outwards.
    contacts
        (n,) units that it touches.
    gap
        (n,) free gap to the nearest unit, metres; negative where the bodies reach into each other.
    column
        (n,) 1 where the unit stands right above the next one down the slope, else 0; NaN where there is no slope or none below.
    """

    nominal_diameter: float
    layer: IntArray
    inner: BoolArray
    cell: FloatArray
    spacing: FloatArray
    turn: FloatArray
    off_surface: FloatArray
    contacts: IntArray
    gap: FloatArray
    column: FloatArray


@dataclass(frozen=True, kw_only=True)
class LayerPlacement:
    """One layer: its number from outside, units, units per square metre, and units per square of one Dn."""

    number: int
    units: int
    density: float
    packing: float


@dataclass(frozen=True, kw_only=True)
class Placement:
    """Placement of the units of one epoch.

    Attributes
    ----------
    units, inner
        Units with a pose, and those of the outer layer with neighbours on all sides, over which density is taken.
    density
        Units of the outer layer per square metre of surface.
    packing
        The same per square of one nominal diameter, the packing density coefficient (van der Meer, 1988).
    layers
        All layers over the area of the outer one.
    spacing_median, spacing_low
        Median and 5 % quantile of the distance to the nearest centre, nominal diameters.
    turn_neighbours, turn_random
        Median angle between the orientations of nearest neighbours, and of units turned at random, degrees; a tetrapod's twelve
        rotations onto itself count as none.
    random_p
        Probability of a difference from random turns at least as large if neighbours do lie at random (Kolmogorov-Smirnov).
    off_surface_rms, off_surface_most
        Root mean square and largest distance of centres from the surface through their neighbours, metres.
    contacts
        Mean number of units that one touches.
    gap_median
        Median free gap to the nearest unit, metres.
    columns, on_slope
        Units that stand in a column, of those that have one below.
    nominal_diameter
        Dn, metres.
    """

    units: int
    inner: int
    density: float
    packing: float
    layers: tuple[LayerPlacement, ...]
    spacing_median: float
    spacing_low: float
    turn_neighbours: float
    turn_random: float
    random_p: float
    off_surface_rms: float
    off_surface_most: float
    contacts: float
    gap_median: float
    columns: int
    on_slope: int
    nominal_diameter: float


def placement_of_units(shapes: Sequence[PlacedShape], height: float, symmetries: FloatArray) -> UnitPlacement | None:
    """Figures of each unit; None where too few have neighbours.

    Parameters
    ----------
    shapes
        Units of one epoch and one height.
    height
        Nominal H, metres.
    symmetries
        (k, 3, 3) rotations that map the unit onto itself.
    """
    from scipy.spatial import cKDTree

    if len(shapes) < FEWEST_UNITS:
        return None
    diameter = nominal_diameter(shapes)
    centres = np.array([shape.centre for shape in shapes])
    reduced = centres - centres.mean(axis=0)
    count = min(NEIGHBOURS, len(shapes) - 1)
    distance, near = cKDTree(reduced).query(reduced, k=count + 1)
    normals = _normals(reduced, near)
    layer = _layers(reduced, near, normals, diameter)
    outer = np.flatnonzero(layer == 1)
    if len(outer) < FEWEST_UNITS:
        return None
    outer_near = np.asarray(outer[cKDTree(reduced[outer]).query(reduced, k=min(count, len(outer) - 1) + 1)[1]])
    normals = _normals(reduced, outer_near)
    rotations = np.array([shape.rotation for shape in shapes])
    cell, nearest = np.full(len(shapes), np.nan), near[:, 1].copy()
    for number in np.unique(layer):
        own = np.flatnonzero(layer == number)
        if len(own) > 4:
            near_own = own[cKDTree(reduced[own]).query(reduced[own], k=min(count, len(own) - 1) + 1)[1]]
            nearest[own] = near_own[:, 1]
            cell[own] = [_cell(reduced, row, normals[k]) for k, row in zip(own, near_own, strict=True)]
    known = np.isfinite(cell)
    inner = known & (cell <= EDGE_CELL * np.median(cell[known])) if known.any() else known
    gaps = _gaps(shapes, reduced)
    return UnitPlacement(
        nominal_diameter=diameter,
        layer=layer,
        inner=inner,
        cell=np.where(inner, cell, np.nan),
        spacing=distance[:, 1] / diameter,
        turn=turns(rotations, rotations[nearest], symmetries),
        off_surface=_off_surface(reduced, outer_near, normals),
        contacts=np.array([sum(gap <= CONTACT_HEIGHTS * height for gap in own) for own in gaps], dtype=np.int64),
        gap=np.array([min(own, default=math.nan) for own in gaps]),
        column=_columns(reduced, near, layer, normals, 2 * float(np.median(distance[:, 1]))),
    )


def placement(shapes: Sequence[PlacedShape], height: float, symmetries: FloatArray) -> Placement | None:
    """Figures of all units together (see :func:`placement_of_units`); None where too few have neighbours on all sides."""
    found = placement_of_units(shapes, height, symmetries)
    return None if found is None else summary(found, symmetries)


def summary(units: UnitPlacement, symmetries: FloatArray) -> Placement | None:
    """Figures of all units together; None where no unit of the outer layer has neighbours on all sides."""
    from scipy.spatial.transform import Rotation
    from scipy.stats import ks_2samp

    outer = units.layer == 1
    inner = outer & units.inner
    if not inner.any():
        return None
    diameter = units.nominal_diameter
    density = float(inner.sum() / units.cell[inner].sum())
    layers = []
    for number in np.unique(units.layer).tolist():
        share = float(np.sum(units.layer == number) / outer.sum())
        layers.append(
            LayerPlacement(
                number=number, units=int(np.sum(units.layer == number)), density=share * density, packing=share * density * diameter**2
            )
        )
    drawn = Rotation.random(4000, random_state=20250314).as_matrix()
    random = turns(drawn, np.broadcast_to(np.eye(3), drawn.shape), symmetries)
    on_slope = np.isfinite(units.column)
    gaps = units.gap[np.isfinite(units.gap)]
    return Placement(
        units=len(units.layer),
        inner=int(inner.sum()),
        density=density,
        packing=density * diameter**2,
        layers=tuple(layers),
        spacing_median=float(np.median(units.spacing)),
        spacing_low=float(np.quantile(units.spacing, 0.05)),
        turn_neighbours=float(np.median(units.turn)),
        turn_random=float(np.median(random)),
        random_p=float(ks_2samp(units.turn, random).pvalue),
        off_surface_rms=float(np.sqrt(np.mean(units.off_surface[outer] ** 2))),
        off_surface_most=float(np.abs(units.off_surface[outer]).max()),
        contacts=float(np.mean(units.contacts)),
        gap_median=float(np.median(gaps)) if len(gaps) else math.nan,
        columns=int(np.nansum(units.column[on_slope])),
        on_slope=int(on_slope.sum()),
        nominal_diameter=diameter,
    )


def turns(first: FloatArray, second: FloatArray, symmetries: FloatArray) -> FloatArray:
    """(n,) smallest angle in degrees that takes orientations (n, 3, 3) to others, up to the unit's own symmetry."""
    trace = np.einsum("nji,njk,ski->ns", first, second, symmetries)
    return np.asarray(np.degrees(np.arccos(np.clip((trace.max(axis=1) - 1) / 2, -1, 1))))


def _normals(centres: FloatArray, near: IntArray) -> FloatArray:
    """(n, 3) unit normals, upwards, of the planes that fit the units ``near`` (n, k) best."""
    local = centres[near] - centres[near].mean(axis=1, keepdims=True)
    normal = np.linalg.svd(local, full_matrices=False)[2][:, 2]
    return np.asarray(normal * np.where(normal[:, 2:] < 0, -1.0, 1.0))


def _layers(centres: FloatArray, near: IntArray, normals: FloatArray, diameter: float) -> IntArray:
    """(n,) number of each unit's layer from outside: one more than that of the lowest one over it."""
    offsets = centres[near] - centres[:, None]
    height = np.einsum("nki,ni->nk", offsets, normals)
    aside = np.linalg.norm(offsets - height[..., None] * normals[:, None], axis=2)
    over = (height > OVER_ALONG * diameter) & (aside < OVER_ACROSS * diameter)
    layer = np.ones(len(centres), dtype=np.int64)
    # each turn finishes one layer more
    for _ in range(len(centres)):
        deeper = np.where(over.any(axis=1), 1 + np.max(np.where(over, layer[near], 0), axis=1), 1)
        if (deeper == layer).all() or deeper.max() > 9:
            break
        layer = deeper
    return layer


def _cell(centres: FloatArray, near: IntArray, normal: FloatArray) -> float:
    """Area nearer to the first of the units ``near`` than to any other, in the plane across ``normal``, m2; NaN where it is open."""
    helper = np.array([0.0, 1.0, 0.0]) if abs(normal[1]) < 0.9 else np.array([1.0, 0.0, 0.0])
    first = np.cross(helper, normal)
    first /= np.linalg.norm(first)
    flat = (centres[near[1:]] - centres[near[0]]) @ np.column_stack([first, np.cross(normal, first)])
    far = 10 * float(np.abs(flat).max())
    cell = [(-far, -far), (far, -far), (far, far), (-far, far)]
    for x, y in flat.tolist():
        cell = _clipped(cell, x, y)
    corners = np.array(cell)
    # a cell that reaches beyond the outermost centres is one of the edge: from there they lie to one side
    places = np.vstack([flat, [[0.0, 0.0]]])
    for corner in corners:
        seen = np.sort(np.arctan2(*(places - corner).T))
        if np.diff(np.append(seen, seen[0] + 2 * math.pi)).max() > math.pi + 1e-6:
            return math.nan
    return polygon_area(corners)


def _clipped(cell: list[tuple[float, float]], x: float, y: float) -> list[tuple[float, float]]:
    """The part of a convex polygon that is nearer to the origin than to (x, y)."""
    half = (x * x + y * y) / 2
    beyond = [a * x + b * y - half for a, b in cell]
    kept = []
    for k, (a, b) in enumerate(cell):
        before, (c, d) = beyond[k - 1], cell[k - 1]
        if (before < 0) != (beyond[k] < 0):
            share = before / (before - beyond[k])
            kept.append((c + share * (a - c), d + share * (b - d)))
        if beyond[k] < 0:
            kept.append((a, b))
    return kept


def _off_surface(centres: FloatArray, near: IntArray, normals: FloatArray) -> FloatArray:
    """(n,) distance of each unit from the plane through its neighbours (n, k), the unit itself left out, metres."""
    others = near != np.arange(len(centres))[:, None]
    middle = np.sum(centres[near] * others[..., None], axis=1) / others.sum(axis=1)[:, None]
    return np.asarray(np.einsum("ni,ni->n", centres - middle, normals))


def _gaps(shapes: Sequence[PlacedShape], centres: FloatArray) -> list[list[float]]:
    """Free gaps of each unit to those that it could touch."""
    from scipy.spatial import cKDTree

    reach = max(reach_of(shape) for shape in shapes)
    pairs = cKDTree(centres).query_pairs(2 * reach, output_type="ndarray")
    found: list[list[float]] = [[] for _ in shapes]
    for (a, b), gap in zip(pairs.tolist(), free_gaps(shapes, pairs).tolist(), strict=True):
        found[a].append(gap)
        found[b].append(gap)
    return found


def _columns(centres: FloatArray, near: IntArray, layer: IntArray, normals: FloatArray, farthest: float) -> FloatArray:
    """(n,) 1 where the next unit of the layer down the slope lies right below, else 0; NaN where there is none or no slope."""
    down = np.column_stack([normals[:, 0] * normals[:, 2], normals[:, 1] * normals[:, 2], normals[:, 2] ** 2 - 1])
    steep = np.linalg.norm(down, axis=1)
    down = down / np.maximum(steep, 1e-12)[:, None]
    offsets = centres[near[:, 1:]] - centres[:, None]
    along = np.einsum("nki,ni->nk", offsets, down)
    across = np.einsum("nki,ni->nk", offsets, np.cross(normals, down))
    angle = np.abs(np.arctan2(across, along))
    below = (angle <= BELOW_ANGLE) & (layer[near[:, 1:]] == layer[:, None]) & (np.hypot(along, across) <= farthest)
    distance = np.where(below, np.hypot(along, across), np.inf)
    next_one = np.argmin(distance, axis=1)
    known = below.any(axis=1) & (np.arcsin(np.clip(steep, 0, 1)) > FLAT_SLOPE)
    return np.where(known, angle[np.arange(len(centres)), next_one] <= COLUMN_ANGLE, np.nan)
