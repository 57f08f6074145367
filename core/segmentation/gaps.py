"""Places in one epoch where a unit is likely missing: points that no unit explains, and holes in the armour.

Only places that found units surround are looked at, so that the border of the layer and its underside are never taken for gaps, and
only where a whole unit fits between the found ones: two solids cannot interpenetrate. Loose piles have many such pores, so room alone
says nothing. What the cloud shows that belongs to no unit must speak as well: either it lies on the surface of a unit in
that place, or it reaches into the place's core, which is then seen to be empty, and the place is as wide as a unit's own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any, Literal, NamedTuple

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.kernels import in_parts, kernel
from ..common.neighbourhood import build_grid, point_tree
from ..common.voxels import thin
from ..model.tetrapod import distance_to_surface, surface_area
from ..model.unit_types import UnitType
from .aggregation import assign
from .cone_relation import height_above_cones
from .overlaps import CLOSEST_HEIGHTS, REACH_HEIGHTS, nearest_centres
from .pose_evidence import NUMBER_OF_CELLS
from .pose_refinement import refine
from .scene import Scene
from .surface_elements import THINNING_RATIO, element_normals
from .verification import FEWEST_CELLS, MOST_OVERLAP, overlap, solid_samples

STEP_HEIGHTS = 0.12
"""Distance between the places tried: half the radius of a unit's core."""
VOXEL_HEIGHTS = 2 * THINNING_RATIO
"""Thinning of the points; coarse enough that a voxel on a surface is filled at any useful density."""
EXPLAINED_HEIGHTS = 0.05
"""A point nearer than this to a unit's surface, or inside it, is that unit's: noise, roughness and the fillets of the joints."""
SURROUNDINGS_HEIGHTS = 1.5
"""Units within this distance must surround a place: the neighbours of a unit in a pile lie at 0.7 to 1.2 H."""
SURFACE_HEIGHTS = 3.0
"""Units within this distance tell the run of the armour's surface."""
WIDEST_GAP = np.radians(120)
"""Largest angle between neighbours in the armour's surface: six around a place with one missing."""
PLACES_AT_ONCE = 20_000
"""Places whose neighbours are looked at together; bounds memory."""
COARSE = 4
"""Steps of the lattice in a cell of the first, coarse look."""
ROTATIONS = 150
"""Orientations tried in a place: about 20 degrees apart, modulo the unit's symmetry; the best is settled by least squares."""
FIT_SAMPLES = 300
FEWEST_AROUND = 4
"""Units that must stand around a place."""
TIGHTEST = 0.05
"""Share of the epoch's units that may stand closer to their nearest neighbour than a missing one would."""
MOST_INSIDE = 0.08
"""Elements inside a unit, over those on its surface, above which they contradict it; as in the verification of poses."""
EXPLAINS_MOST = 0.75
"""Share of the points of no unit around a place that a unit there must explain, for rock seen through a pore seldom fits as well; and
share of the cross-section of a unit's core that the cloud must reach into to show it empty."""


class _Lists(NamedTuple):
    """Lists of indices as starts (n + 1,) and one array, as compiled loops like them."""

    starts: IntArray
    items: IntArray


class _Solids(NamedTuple):
    """(n, 12) poses of units and (n,) their types; of each type leg directions (k, 4, 3), and radius, gradient and length (k, 3)."""

    poses: FloatArray
    kinds: IntArray
    legs: FloatArray
    shapes: FloatArray


class _Trial(NamedTuple):
    """A unit type that is tried: points of its solid (m, 3), rotations (r, 3, 3), share of the points that may lie in others, tolerance."""

    kind: int
    samples: FloatArray
    rotations: FloatArray
    most: float
    tolerance: float


@dataclass(frozen=True, eq=False)
class Gap:
    """A place where a unit is likely missing.

    Attributes
    ----------
    place
        (3,) metres, where its centre would be.
    kind
        ``unexplained`` or ``hole``; see ``schema``.
    score
        0 to 1.
    area
        Surface of no unit that speaks for it, m2.
    unit
        Type of unit that fits.
    """

    place: FloatArray
    kind: Literal["unexplained", "hole"]
    score: float
    area: float
    unit: int


@dataclass(frozen=True, eq=False)
class Armour:
    """The units of one epoch that fill space, and how they are packed.

    Attributes
    ----------
    poses
        (k, 12) centre in metres of a reduced frame and rotation by rows.
    kinds, units
        (k,) index of each unit's type, and the types.
    tree
        Of the centres.
    closest
        Distance in metres that a missing unit keeps from its neighbours, as nearly all units of the epoch do.
    """

    poses: FloatArray
    kinds: IntArray
    units: tuple[UnitType, ...]
    tree: cKDTree
    closest: float

    @property
    def height(self) -> float:
        """Largest height of a unit, metres."""
        return max(unit.height for unit in self.units)


def armour_of(poses: FloatArray, kinds: IntArray, units: Sequence[UnitType]) -> Armour | None:
    """The packing of (k, 12) poses of the types ``kinds``; None where there are too few units to surround anything."""
    if len(poses) < FEWEST_AROUND:
        return None
    centres = np.ascontiguousarray(poses[:, :3])
    closest = max(CLOSEST_HEIGHTS * max(unit.height for unit in units), float(np.quantile(nearest_centres(centres), TIGHTEST)))
    return Armour(poses, kinds, tuple(units), cKDTree(centres), closest)


def surrounded(places: FloatArray, tree: cKDTree, height: float) -> BoolArray:
    """(n,) whether units stand around (n, 3) places on all sides in the armour's surface, and none-too-high nor too low for it.

    Parameters
    ----------
    places
        Metres, frame of ``tree``.
    tree
        Of the units' centres.
    height
        H, metres.
    """
    centres = np.asarray(tree.data)
    inside = np.zeros(len(places), dtype=np.bool_)
    if not len(places):
        return inside
    for start in range(0, len(places), PLACES_AT_ONCE):
        part = places[start : start + PLACES_AT_ONCE]
        pairs = cKDTree(part).sparse_distance_matrix(tree, SURROUNDINGS_HEIGHTS * height, output_type="ndarray")
        enough = np.bincount(pairs["i"], minlength=len(part)) >= FEWEST_AROUND
        if not enough.any():
            continue
        pairs = pairs[enough[pairs["i"]]]
        known, patch_of = np.unique(tree.query(part)[1][pairs["i"]], return_inverse=True)
        patches = [centres[tree.query_ball_point(centres[k], SURFACE_HEIGHTS * height)] for k in known]
        axes = np.array([np.linalg.svd(patch - patch.mean(axis=0), full_matrices=False)[2] for patch in patches])
        around = np.einsum("nab,nb->na", axes[patch_of], centres[pairs["j"]] - part[pairs["i"]])
        inside[start + np.flatnonzero(enough)] = _all_around(pairs["i"], around)
    return inside


def _all_around(place: IntArray, around: FloatArray) -> BoolArray:
    """For each place, in ascending order, whether its neighbours stand on all sides in the surface and on both sides of it.

    ``around`` (m, 3) leads from the place of each to a neighbour, along two axes in the surface and one across it.
    """
    angles = np.arctan2(around[:, 1], around[:, 0])
    order = np.lexsort((angles, place))
    angles, across = angles[order], around[order, 2]
    first = np.flatnonzero(np.diff(place[order], prepend=-1))
    last = np.append(first[1:], len(order)) - 1
    steps = np.diff(angles, append=0.0)
    steps[last] = angles[first] + 2 * np.pi - angles[last]
    # the place must lie within the layer's thickness: not on top of all its neighbours, not below them
    within = (np.minimum.reduceat(across, first) < 0) & (np.maximum.reduceat(across, first) > 0)
    return np.asarray(within & (np.maximum.reduceat(steps, first) <= WIDEST_GAP))


def find_gaps(points: FloatArray, armour: Armour) -> list[Gap]:
    """Places among the units where the points, and the room between the units, speak for a missing one.

    Parameters
    ----------
    points
        (n, 3) metres, frame of the armour: all points of the cloud there.
    armour
        Units of the epoch.

    Returns
    -------
    gaps
        At least a height apart, largest area first.
    """
    elements = unexplained(points, armour)
    if not len(elements):
        return []
    places = _places(elements, armour)
    kinds = armour.kinds[armour.tree.query(places)[1]] if len(places) else np.empty(0, dtype=np.int64)
    found: list[Gap] = []
    for kind in np.unique(kinds):
        found += _judged(places[kinds == kind], int(kind), elements, armour)
    return clearest(found, armour.height)


def unexplained(points: FloatArray, armour: Armour) -> FloatArray:
    """(m, 3) thinned points near the units that lie on or in none of them, metres."""
    elements = thin(points, VOXEL_HEIGHTS * armour.height)[0]
    if len(elements):
        elements = elements[armour.tree.query(elements)[0] < REACH_HEIGHTS * armour.height]
    free = np.ones(len(elements), dtype=np.bool_)
    for kind in np.unique(armour.kinds):
        unit = armour.units[kind]
        distance = assign(elements, armour.poses[armour.kinds == kind], unit, EXPLAINED_HEIGHTS * unit.height)[1]
        free &= distance > EXPLAINED_HEIGHTS * unit.height
    return elements[free]


def clearest(gaps: Sequence[Gap], height: float) -> list[Gap]:
    """One for each missing unit: of gaps within a height of the one with the largest area, the one in their middle.

    Where a unit explains the points, a place beside it, into which those points reach, is no hole.
    """
    kept: list[Gap] = []
    left = sorted(gaps, key=lambda g: (-g.area, -g.score, *g.place))
    while left:
        near = [gap for gap in left if np.linalg.norm(gap.place - left[0].place) < height]
        near = [gap for gap in near if gap.kind == "unexplained"] or near
        middle = np.average([gap.place for gap in near], axis=0, weights=[gap.area for gap in near])
        kept.append(min(near, key=lambda g: (float(np.linalg.norm(g.place - middle)), *g.place)))
        left = [gap for gap in left if np.linalg.norm(gap.place - left[0].place) >= height]
    return kept


def needed_area(unit: UnitType) -> float:
    """Surface, m2, below which the segmentation keeps no pose either."""
    return FEWEST_CELLS / NUMBER_OF_CELLS * surface_area(unit)


def _places(elements: FloatArray, armour: Armour) -> FloatArray:
    """(n, 3) places of a lattice fixed in the frame that have room, neighbours all around and elements near."""
    height = armour.height
    smallest = min(armour.units, key=lambda unit: unit.height)
    reach = smallest.reach
    tree = point_tree(elements)
    # coarse cells first: most of the box around a pile is air, or far from what is left unexplained
    step = STEP_HEIGHTS * height
    wanted = needed_area(smallest) / (VOXEL_HEIGHTS * height) ** 2
    fine = _lattice(np.zeros(3), np.full(3, (COARSE - 1) * step), step)
    middle, beside = fine.mean(axis=0), float(np.linalg.norm(fine[-1])) / 2
    coarse = _lattice(elements.min(axis=0) - reach, elements.max(axis=0) + reach, COARSE * step)
    coarse = coarse[tree.query_ball_point(coarse + middle, reach + beside, return_length=True) >= wanted]
    away = armour.tree.query(coarse + middle, distance_upper_bound=REACH_HEIGHTS * height + beside)[0]
    coarse = coarse[np.isfinite(away) & (away >= armour.closest - beside)]
    places = (coarse[:, None] + fine).reshape(-1, 3)
    away = armour.tree.query(places, distance_upper_bound=REACH_HEIGHTS * height)[0]
    places = places[(away >= armour.closest) & np.isfinite(away)]
    # few places are surrounded, and counting the elements around one takes longer
    places = places[surrounded(places, armour.tree, height)]
    if len(places):
        places = places[tree.query_ball_point(places, reach, return_length=True) >= wanted]
    return np.asarray(places)


def _lattice(low: FloatArray, high: FloatArray, step: float) -> FloatArray:
    """(n, 3) multiples of ``step`` from at most ``low`` to at least ``high``."""
    lines = [np.arange(np.floor(a / step), np.ceil(b / step - 1e-9) + 1) * step for a, b in zip(low, high, strict=True)]
    return np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, 3)


def _judged(places: FloatArray, kind: int, elements: FloatArray, armour: Armour) -> list[Gap]:
    unit = armour.units[kind]
    voxel = (VOXEL_HEIGHTS * armour.height) ** 2
    wanted = needed_area(unit) / voxel
    reach = unit.reach + EXPLAINED_HEIGHTS * unit.height
    tree = point_tree(elements)
    tolerance = EXPLAINED_HEIGHTS * unit.height
    grid = build_grid(elements, 0.25 * reach)
    normals = element_normals(elements, unit.height)
    either = np.zeros(len(elements), dtype=np.int8)
    scene = Scene(points=elements, normals=normals, curved=either, grid=grid, unit=unit, tolerance=0.5 * tolerance, noise=0.0)
    everything = np.ones(len(elements), dtype=np.bool_)
    core = tree.query_ball_point(places, unit.crotch_distance, return_length=True)
    section = np.pi * unit.crotch_distance**2
    shapes = armour.units
    others = _Solids(
        poses=armour.poses,
        kinds=armour.kinds,
        legs=np.array([u.leg_directions for u in shapes]),
        shapes=np.array([[u.radius, u.gradient, u.leg_length] for u in shapes]),
    )
    trial = _Trial(kind=kind, samples=_samples(unit), rotations=_rotations(), most=MOST_OVERLAP, tolerance=tolerance)
    neighbours = _packed(armour.tree.query_ball_point(places, REACH_HEIGHTS * armour.height))
    turns = np.full(len(places), -1, dtype=np.int64)
    beside = _packed(tree.query_ball_point(places, reach))
    passes = partial(_fits, places=places, others=others, around=neighbours, elements=elements, beside=beside, trial=trial, out=turns)
    in_parts(passes, len(places))
    fitting = turns >= 0
    starts = np.column_stack([places, _rotations()[turns].reshape(-1, 9)])
    # least squares tell a unit from rock better than one of a few orientations
    settled = starts.copy()
    settled[fitting] = refine(starts[fitting], scene, everything)
    gaps: list[Gap] = []
    for k in np.flatnonzero(fitting):
        pose = settled[k]
        own = elements[grid.within(pose[:3], reach)]
        distance = distance_to_surface((own - pose[:3]) @ pose[3:].reshape(3, 3), unit)
        on, inside = int(np.sum(np.abs(distance) <= tolerance)), int(np.sum(distance < -tolerance))
        share = on / max(len(own), 1)
        if on >= wanted and inside <= MOST_INSIDE * on and share >= EXPLAINS_MOST and _free(pose, kind, armour):
            gaps.append(Gap(pose[:3], "unexplained", share, float(on * voxel), kind))
        elif (reached := min(1.0, core[k] * voxel / section)) >= EXPLAINS_MOST:
            gaps.append(Gap(places[k], "hole", float(reached), float(core[k] * voxel), kind))
    return gaps


def _free(pose: FloatArray, kind: int, armour: Armour) -> bool:
    """Whether a unit of a type has room in its pose (12,) among the others."""
    near = armour.tree.query_ball_point(pose[:3], REACH_HEIGHTS * armour.height)
    shapes = armour.units
    return all(overlap(pose, armour.poses[k], shapes[kind], shapes[armour.kinds[k]]) <= MOST_OVERLAP for k in near)


def _packed(lists: Sequence[Sequence[int]]) -> _Lists:
    starts = np.concatenate([[0], np.cumsum([len(items) for items in lists])]).astype(np.int64)
    flat = np.concatenate([np.asarray(items, dtype=np.int64) for items in lists]) if len(lists) else np.empty(0, dtype=np.int64)
    return _Lists(starts, flat)


@lru_cache(maxsize=8)
def _samples(unit: UnitType) -> FloatArray:
    """About FIT_SAMPLES points spread through the solid, body frame."""
    inside = solid_samples(unit)
    return np.ascontiguousarray(inside[:: max(1, len(inside) // FIT_SAMPLES)])


@lru_cache(maxsize=1)
def _rotations() -> FloatArray:
    return np.asarray(Rotation.random(ROTATIONS, random_state=0).as_matrix())


@kernel(releases=True)
def _fits(first: int, last: int, places: Any, others: Any, around: Any, elements: Any, beside: Any, trial: Any, out: Any) -> None:
    """Into ``out`` (n,) the number of the orientation that fits each place and that the elements like best; as it was where none fits.

    ``around`` and ``beside`` are the units and the elements near each place.
    """
    poses, kinds, legs, shapes = others
    starts, neighbours = around
    element_starts, near = beside
    kind, samples, rotations, most, tolerance = trial
    limit = int(most * len(samples))
    # square of the distance from the centre to the rim of an end disc
    farthest = shapes[:, 2] ** 2 + (shapes[:, 0] - shapes[:, 1] * shapes[:, 2]) ** 2
    for i in range(first, last):
        best = -1e300
        count = element_starts[i + 1] - element_starts[i]
        local = np.empty((3, count))
        for q in range(count):
            for a in range(3):
                local[a, q] = elements[near[element_starts[i] + q], a] - places[i, a]
        for r in range(len(rotations)):
            turn = rotations[r]
            value = _explained(local, turn, legs[kind], shapes[kind], tolerance)
            # the elements are fewer than the samples of the solid, and only a better orientation need fit
            if value <= best:
                continue
            entered = 0
            for s in range(len(samples)):
                s0, s1, s2 = samples[s, 0], samples[s, 1], samples[s, 2]
                at0 = places[i, 0] + turn[0, 0] * s0 + turn[0, 1] * s1 + turn[0, 2] * s2
                at1 = places[i, 1] + turn[1, 0] * s0 + turn[1, 1] * s1 + turn[1, 2] * s2
                at2 = places[i, 2] + turn[2, 0] * s0 + turn[2, 1] * s1 + turn[2, 2] * s2
                for a in range(starts[i], starts[i + 1]):
                    j = neighbours[a]
                    p = poses[j]
                    d0, d1, d2 = at0 - p[0], at1 - p[1], at2 - p[2]
                    if d0 * d0 + d1 * d1 + d2 * d2 > farthest[kinds[j]]:
                        continue
                    x = d0 * p[3] + d1 * p[6] + d2 * p[9]
                    y = d0 * p[4] + d1 * p[7] + d2 * p[10]
                    z = d0 * p[5] + d1 * p[8] + d2 * p[11]
                    if height_above_cones(x, y, z, legs[kinds[j]], shapes[kinds[j]]) < 0.0:
                        entered += 1
                        break
                if entered > limit:
                    break
            if entered <= limit:
                best = value
                out[i] = r


@kernel()
def _explained(local: Any, turn: Any, legs: Any, shape: Any, tolerance: float) -> float:
    """Elements (3, m), from a unit's centre, that lie on the cones of a unit turned so, less three for each inside them.

    As :func:`.cone_relation.height_above_cones` has it, without branches: the loop runs in vector registers.
    """
    radius, gradient, length = shape[0], shape[1], shape[2]
    slant = 1.0 / np.sqrt(1.0 + gradient * gradient)
    u0, u1, u2, v0, v1, v2 = turn[0, 0], turn[1, 0], turn[2, 0], turn[0, 1], turn[1, 1], turn[2, 1]
    w0, w1, w2 = turn[0, 2], turn[1, 2], turn[2, 2]
    a0, a1, a2, b0, b1, b2 = legs[0, 0], legs[0, 1], legs[0, 2], legs[1, 0], legs[1, 1], legs[1, 2]
    c0, c1, c2, d0, d1, d2 = legs[2, 0], legs[2, 1], legs[2, 2], legs[3, 0], legs[3, 1], legs[3, 2]
    value = 0.0
    for q in range(local.shape[1]):
        p0, p1, p2 = local[0, q], local[1, q], local[2, q]
        x, y, z = p0 * u0 + p1 * u1 + p2 * u2, p0 * v0 + p1 * v1 + p2 * v2, p0 * w0 + p1 * w1 + p2 * w2
        axial = max(max(x * a0 + y * a1 + z * a2, x * b0 + y * b1 + z * b2), max(x * c0 + y * c1 + z * c2, x * d0 + y * d1 + z * d2))
        rho = np.sqrt(max(x * x + y * y + z * z - axial * axial, 0.0))
        above = max((rho - radius + gradient * axial) * slant, axial - length)
        value += 1.0 if above < tolerance else 0.0
        value -= 4.0 if above < -tolerance else 0.0
    return value
