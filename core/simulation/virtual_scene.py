"""What simulated instruments survey: units with the surfaces of real ones, and the structure they lie on, ready for ray casting.

All coordinates are in the site frame of ``armour_pile``. Surfaces are exact cones plus what real ones carry: casting roughness, a fillet
in the creases, a chamfer at the leg ends and, near the water line, growth. They displace the return along its beam, so that the
relief is the same from every station and in every epoch.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..model.tetrapod import mesh, relate
from ..model.unit_types import UnitType
from .armour_pile import PiledUnit, Site
from .castings import Casting

WALL, TABLE, ROCK, WATER, OUTLIER, OBJECT = -1, -2, -3, -4, -5, -6
"""Labels of points that belong to no unit."""

REFERENCE_HEIGHT = 2.3
"""Unit height in metres for which the instruments' ray spacings below are stated; a site in proportion is seen in proportion."""

ON_FACETS = 0.008
"""Distance from the ideal cones, a share of the unit's height, within which a facet stands for them; others are faces of fracture."""
ON_SURFACE, LONGEST_STEP, LONGEST_WAY = 1e-4, 0.02, 0.03
"""Distance from a surface with relief within which a beam is taken to have met it, longest step along the beam to get there, and longest
way in all (rounded tips are passed beyond), shares of the unit's height."""
BEAM_STEPS = 20
"""Steps after which a beam that has not met the surface of the facets it hit is taken to pass beside it: at silhouettes and rims."""
LEAST_COSINE, GRAZING = 0.1, 0.25
"""Least cosine of incidence by which a step is lengthened, and least that is given for a hit (assumed: noise grows no more)."""


@dataclass(frozen=True)
class Surfaces:
    """What a survey measures besides the perfect cones; lengths in metres.

    Attributes
    ----------
    roughness
        Standard deviation of the correlated relief of the concrete.
    fillet, chamfer
        Width over which creases are filled and leg ends rounded.
    growth
        Share of the units at the water line that carry patches of growth.
    castings
        Whether units differ from the ideal cones as real castings do (:mod:`.castings`).
    bridging
        Radius of the narrowest hollow that image matching follows; 0 where it follows all (:mod:`.smoothing_matcher`).
    """

    roughness: float
    fillet: float
    chamfer: float
    growth: float
    castings: bool = False
    bridging: float = 0.0


class Scene:
    """Units and structure of one epoch, ready for ray casting with Open3D."""

    def __init__(
        self,
        units: tuple[PiledUnit, ...],
        unit: UnitType,
        site: Site | None,
        surfaces: Surfaces,
        seed: int,
        *,
        rough_rock: bool = True,
        core: float | None = None,
        along: float = 0.0,
        epoch: int = 0,
    ) -> None:
        """``site`` None is a laboratory table with a board. The relief of a unit depends on ``seed`` and its number only.

        ``epoch`` counts the surveys of one pile: what images make of a surface is drawn anew in each.

        Of a coast in stretches, ``core`` is half the length (m) of the stretch that is surveyed, among neighbours up to the site's half
        length, and ``along`` where its middle lies on the coast.
        """
        import open3d

        self._o3d: Any = open3d
        self.units = {u.number: u for u in units}
        self.unit = unit
        self.site = site
        self.core = core if core is not None or site is None else site.half_length
        self.along = along
        self.epoch = epoch
        self.surfaces = surfaces
        self.seed = seed
        self._scene: Any = open3d.t.geometry.RaycastingScene()
        self._owner: list[int] = []
        vertices, triangles = mesh(unit, 48, 8)
        for u in units:
            self._add(u.pose.to_frame(_broken(vertices, unit, u) * u.scale), triangles, u.number)
        structure = _table(unit) if site is None else _structure(self, site, np.random.default_rng(seed), rough_rock)
        for v, t, label in structure:
            self._add(v, t, label)

    def _add(self, vertices: FloatArray, triangles: IntArray, owner: int) -> None:
        core = self._o3d.core
        self._scene.add_triangles(core.Tensor(vertices.astype(np.float32)), core.Tensor(triangles.astype(np.uint32)))
        self._owner.append(owner)

    def cast(self, origins: FloatArray, directions: FloatArray) -> tuple[FloatArray, IntArray, FloatArray]:
        """First hits of (n, 3) rays with unit directions: (n,) range (inf for none), (n,) label, (n,) cosine of incidence."""
        rays = np.concatenate([origins, directions], axis=1).astype(np.float32)
        answer = self._scene.cast_rays(self._o3d.core.Tensor(rays))
        distance = answer["t_hit"].numpy().astype(np.float64)
        hit = np.isfinite(distance)
        label = np.zeros(len(rays), dtype=np.int64)
        label[hit] = np.array(self._owner)[answer["geometry_ids"].numpy()[hit].astype(np.int64)]
        normals = answer["primitive_normals"].numpy().astype(np.float64)
        cosine = np.abs(np.sum(normals * directions, axis=1))
        for number in np.unique(label[label > 0]):
            self._on_true_surface(int(number), np.flatnonzero(label == number), origins, directions, distance, cosine)
        return distance, label, cosine

    def _on_true_surface(
        self, number: int, which: IntArray, origins: FloatArray, directions: FloatArray, distance: FloatArray, cosine: FloatArray
    ) -> None:
        """Move hits from the facets along their beams to the curved surface with its relief, in place; beams that pass beside it are lost.

        A relief that is read off at the facets depends on the station: a beam that grazes the surface meets it centimetres farther along.
        So it is read there only for faces of fracture, which no ideal cone bears.
        """
        piled = self.units[number]
        shape = piled.shape(self.unit)

        def at(rays: IntArray, way: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
            """Distances from the ideal cones, relief and cosines of incidence of rays on their way."""
            place = origins[rays] + directions[rays] * way[:, None]
            body = piled.pose.to_body(place)
            relation = relate(body, shape)
            steep = -np.sum((relation.normal @ piled.pose.rotation.T) * directions[rays], axis=1)
            return relation.distance, self._relief(piled, shape, body, place[:, 2]), steep

        start = distance[which]
        outside, relief, steep = at(which, start)
        cosine[which] = np.clip(np.abs(steep), GRAZING, 1)
        cone = np.abs(outside) < ON_FACETS * shape.height
        distance[which] = np.where(cone, np.inf, start - relief / cosine[which])
        left = which[cone]
        start, way, short, steep = (a[cone] for a in (start, start, outside - relief, steep))
        for _ in range(BEAM_STEPS):
            step = LONGEST_STEP * shape.height
            way = way + np.clip(short / np.maximum(np.abs(steep), LEAST_COSINE), -step, step)
            outside, relief, steep = at(left, way)
            short = outside - relief
            reached = (np.abs(short) < ON_SURFACE * shape.height) & (steep > 0) & (np.abs(way - start) < LONGEST_WAY * shape.height)
            distance[left[reached]] = way[reached]
            cosine[left[reached]] = np.clip(steep[reached], GRAZING, 1)
            left = left[~reached]
            start, way, short, steep = (a[~reached] for a in (start, way, short, steep))
            if not len(left):
                break

    def _relief(self, piled: PiledUnit, shape: UnitType, body: FloatArray, level: FloatArray) -> FloatArray:
        rng = np.random.default_rng([self.seed, piled.number, 77])
        h = shape.height
        relief = self.surfaces.roughness * smooth_field(body, rng, 0.04 * h, 0.3 * h)
        lean = body @ shape.leg_directions.T
        order = np.sort(lean, axis=1)
        rho = np.sqrt(np.maximum(np.sum(body**2, axis=1)[:, None] - lean**2, 0))
        lateral = np.sort((rho - shape.radius + shape.gradient * lean) / np.hypot(1, shape.gradient), axis=1)
        if self.surfaces.fillet > 0:
            gap = np.clip(1 - (lateral[:, 1] - lateral[:, 0]) / self.surfaces.fillet, 0, 1)
            relief += self.surfaces.fillet / 4 * gap**2
        if self.surfaces.chamfer > 0:
            edge = np.abs(lateral[:, 0] - (order[:, 3] - shape.leg_length))
            relief -= self.surfaces.chamfer / 4 * np.clip(1 - edge / self.surfaces.chamfer, 0, 1) ** 2
        if rng.random() < self.surfaces.growth:
            patch = np.clip(smooth_field(body, rng, 0.15 * h, 0.5 * h) - 0.6, 0, 1)
            relief += np.where(level < 0.55 * h, rng.uniform(0.006, 0.02) * np.sqrt(patch), 0.0)
        if self.surfaces.castings:
            relief += Casting.drawn(h, np.random.default_rng([self.seed, piled.number, 78])).deviation(body, shape)
        return np.asarray(relief)


def smooth_field(points: FloatArray, rng: np.random.Generator, shortest: float, longest: float) -> FloatArray:
    """(n,) values of a smooth random field of unit variance with wavelengths in a range."""
    waves = 24
    direction = unit_vectors(rng.normal(size=(waves, 3)))
    wavelength = np.exp(rng.uniform(np.log(shortest), np.log(longest), waves))
    phase = rng.uniform(0, 2 * np.pi, waves)
    return np.asarray(np.cos(points @ (direction * (2 * np.pi / wavelength)[:, None]).T + phase).sum(axis=1) * np.sqrt(2 / waves))


def unit_vectors(vectors: FloatArray) -> FloatArray:
    """(n, 3) vectors in their directions, one long."""
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def _broken(vertices: FloatArray, unit: UnitType, piled: PiledUnit) -> FloatArray:
    """Vertices of the mesh with the broken leg flattened at an uneven oblique plane."""
    if piled.broken_leg < 0:
        return vertices
    axis = unit.leg_directions[piled.broken_leg]
    lean = vertices @ unit.leg_directions.T
    tilt = piled.slope_of_break()
    axial = lean[:, piled.broken_leg]
    across = vertices - axial[:, None] * axis
    limit = piled.broken_length + across @ tilt
    cut = (np.argmax(lean, axis=1) == piled.broken_leg) & (axial > limit)
    result = vertices.copy()
    result[cut] -= (axial - limit)[cut, None] * axis
    return result


def _structure(scene: Scene, site: Site, rng: np.random.Generator, rough: bool) -> Iterator[tuple[FloatArray, IntArray, int]]:
    """Deck, crown wall and its face, rock, deck furniture of every stretch and the water surface."""
    h = scene.unit.height / REFERENCE_HEIGHT
    length, top = site.half_length, site.deck + site.parapet
    yield *_box([-length, 0.0, site.bench - 3 * h], [length, site.wall - 0.5 * h, site.deck]), WALL
    yield *_box([-length, site.wall - 0.5 * h, site.bench - 3 * h], [length, site.wall, top]), WALL
    step = 0.12 * h
    x = np.arange(-length, length + step, step)
    y = np.arange(site.wall, site.toe + 3 * h, step)
    grid = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    level = site.rock(grid[:, 1])
    if rough:
        # blocks lie below the plane on which the armour rests
        flat = np.column_stack([grid + np.array([scene.along, 0.0]), np.zeros(len(grid))])
        blocks, stones = smooth_field(flat, rng, 0.5 * h, 1.6 * h), smooth_field(flat, rng, 0.25 * h, 0.6 * h)
        level = level - (np.abs(blocks) * 0.16 * h + np.abs(stones) * 0.05 * h)
    i, j = np.meshgrid(np.arange(len(x) - 1), np.arange(len(y) - 1), indexing="ij")
    a = (i * len(y) + j).ravel()
    quads = np.vstack([np.column_stack([a, a + len(y), a + 1]), np.column_stack([a + 1, a + len(y), a + len(y) + 1])])
    yield np.column_stack([grid, level]), quads, ROCK
    half = scene.core or length
    beside = round((length / half - 1) / 2)
    for stretch in range(-beside, beside + 1):
        yield from _furniture(site, 2 * half * stretch, half, h)
    far = site.toe + 4 * h
    plane = np.array([[-length, site.wall, 0.0], [length, site.wall, 0.0], [length, far, 0.0], [-length, far, 0.0]])
    yield plane, np.array([[0, 1, 2], [0, 2, 3]]), WATER


def _furniture(site: Site, middle: float, half: float, h: float) -> Iterator[tuple[FloatArray, IntArray, int]]:
    """What stands on the deck of a stretch about ``middle``, ``half`` its length to either side."""
    y0 = site.wall - 2.4 * h
    yield *_box([middle - 2.6 * h, y0, site.deck], [middle - 1.5 * h, y0 + 0.9 * h, site.deck + 0.7 * h]), OBJECT
    for bollard in (-0.5, 0.45):
        foot = middle + bollard * half
        yield *_box([foot, y0 + 1.2 * h, site.deck], [foot + 0.3 * h, y0 + 1.5 * h, site.deck + 0.55 * h]), OBJECT
    yield *_tube([middle + 0.1 * half, y0 + 0.4 * h, site.deck], 0.09 * h, 6.0 * h), OBJECT
    # a railing post and pipe: cylinders are what a cone finder could take for legs
    yield *_tube([middle + 0.3 * half, y0 - 1.5 * h, site.deck], 0.16 * h, 1.0 * h), OBJECT


def _table(unit: UnitType) -> Iterator[tuple[FloatArray, IntArray, int]]:
    h = unit.height
    yield *_box([-3 * h, 0, -0.2 * h], [3 * h, 4 * h, 0]), TABLE
    yield *_box([-3 * h, -0.2 * h, -0.2 * h], [3 * h, 0, 3.3 * h]), WALL


def _box(low: list[float], high: list[float]) -> tuple[FloatArray, IntArray]:
    corners = np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
    faces = [
        [0, 1, 3],
        [0, 3, 2],
        [4, 6, 7],
        [4, 7, 5],
        [0, 4, 5],
        [0, 5, 1],
        [2, 3, 7],
        [2, 7, 6],
        [0, 2, 6],
        [0, 6, 4],
        [1, 5, 7],
        [1, 7, 3],
    ]
    return corners, np.array(faces, dtype=np.int64)


def _tube(foot: list[float], radius: float, height: float) -> tuple[FloatArray, IntArray]:
    azimuth = np.arange(24) * (2 * np.pi / 24)
    ring = np.column_stack([np.cos(azimuth), np.sin(azimuth), np.zeros(24)]) * radius + foot
    a = np.arange(24)
    b = (a + 1) % 24
    cap = np.column_stack([a + 24, b + 24, np.full(24, 48)])
    return np.vstack([ring, ring + np.array([0, 0, height]), [np.add(foot, [0, 0, height])]]), np.vstack(
        [np.column_stack([a, b, b + 24]), np.column_stack([a, b + 24, a + 24]), cap]
    )
