"""Instruments that survey a simulated site: rays cast against the units and the structure, then range noise and artefacts.

All coordinates are in the site frame of ``armour_pile``. Surfaces are exact cones plus what real ones carry: casting roughness, a fillet
in the creases, a chamfer at the leg ends and, near the water line, growth. They displace the return along its beam, so that the
relief is the same from every station and in every epoch.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from .armour_pile import PiledUnit, Site
from .tetrapod import mesh, relate
from .unit_types import UnitType

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
Instrument = Literal["uav", "tls", "photogrammetry", "depth_camera"]

WALL, TABLE, ROCK, WATER, OUTLIER, OBJECT = -1, -2, -3, -4, -5, -6
"""Labels of points that belong to no unit."""

REFERENCE_HEIGHT = 2.3
"""Unit height in metres for which the instruments' ray spacings below are stated; a site in proportion is seen in proportion."""


@dataclass(frozen=True)
class Returns:
    """Points measured in one epoch, before registration.

    Attributes
    ----------
    points
        (n, 3) site frame, metres.
    labels
        (n,) unit number, or one of the negative labels.
    source
        (n,) flight line, station or view, from 1.
    intensity
        (n,) 16-bit.
    time
        (n,) seconds since the start of the survey.
    return_number, returns
        (n,) number of the return and count of returns of its pulse.
    sensor
        (n, 3) where the pulse left from, site frame, metres.
    """

    points: FloatArray
    labels: IntArray
    source: IntArray
    intensity: NDArray[np.uint16]
    time: FloatArray
    return_number: NDArray[np.uint8]
    returns: NDArray[np.uint8]
    sensor: FloatArray

    def chosen(self, which: NDArray[np.bool_] | IntArray) -> Returns:
        """The subset of points given by a mask or indices."""
        return Returns(*(getattr(self, name)[which] for name in self.__dataclass_fields__))

    @classmethod
    def joined(cls, parts: list[Returns]) -> Returns:
        """All parts in order."""
        return cls(*(np.concatenate([getattr(p, name) for p in parts]) for name in cls.__dataclass_fields__))


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
    """

    roughness: float
    fillet: float
    chamfer: float
    growth: float


class Scene:
    """Units and structure of one epoch, ready for ray casting with Open3D."""

    def __init__(
        self, units: tuple[PiledUnit, ...], unit: UnitType, site: Site | None, surfaces: Surfaces, seed: int, *, rough_rock: bool = True
    ) -> None:
        """``site`` None is a laboratory table with a board. The relief of a unit depends on ``seed`` and its number only."""
        import open3d

        self._o3d: Any = open3d
        self.units = {u.number: u for u in units}
        self.unit = unit
        self.site = site
        self.surfaces = surfaces
        self.seed = seed
        self._scene: Any = open3d.t.geometry.RaycastingScene()
        self._owner: list[int] = []
        vertices, triangles = mesh(unit, 48, 8)
        for u in units:
            self._add(u.pose.to_frame(_broken(vertices, unit, u) * u.scale), triangles, u.number)
        structure = _table(unit) if site is None else _structure(site, unit, np.random.default_rng(seed), rough_rock)
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
        """Move hits from the facets to the curved surface with its relief, in place."""
        piled = self.units[number]
        shape = piled.shape(self.unit)
        at = origins[which] + directions[which] * distance[which, None]
        body = piled.pose.to_body(at)
        relation = relate(body, shape)
        facet = np.where(np.abs(relation.distance) < 0.008 * shape.height, relation.distance, 0.0)
        normal = relation.normal @ piled.pose.rotation.T
        steep = np.clip(np.abs(np.sum(normal * directions[which], axis=1)), 0.25, 1)
        relief = self._relief(piled, shape, body, at[:, 2])
        distance[which] -= (relief - facet) / steep
        cosine[which] = steep

    def _relief(self, piled: PiledUnit, shape: UnitType, body: FloatArray, level: FloatArray) -> FloatArray:
        rng = np.random.default_rng([self.seed, piled.number, 77])
        h = shape.height
        relief = self.surfaces.roughness * _field(body, rng, 0.04 * h, 0.3 * h)
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
            patch = np.clip(_field(body, rng, 0.15 * h, 0.5 * h) - 0.6, 0, 1)
            relief += np.where(level < 0.55 * h, rng.uniform(0.006, 0.02) * np.sqrt(patch), 0.0)
        return np.asarray(relief)


def survey_uav(scene: Scene, rng: np.random.Generator, *, density: float, noise: float, offset: float) -> Returns:
    """Airborne profiler on three lines along the wall and a sparser oblique one from the sea; double returns at edges."""
    site = _site_of(scene)
    h = scene.unit.height / REFERENCE_HEIGHT
    length = site.half_length
    lines = [
        (site.wall - 4 * h, 50.0 * h, 0.31),
        (site.wall + 5 * h, 50.0 * h, 0.29),
        (site.wall + 13 * h, 50.0 * h, 0.2),
        (site.wall + 24 * h, 44.0 * h, 0.1),
    ]
    parts = []
    for k, (y, z, share) in enumerate(lines):
        spacing = 1 / np.sqrt(density * share)
        low, high = (site.wall + 2 * h if k == 3 else 0.0), site.toe + 2.5 * h
        across = np.arange(low, high, spacing) + rng.uniform(0, spacing)
        along = np.arange(-length, length, spacing) + rng.uniform(0, spacing)
        x, foot = (g.ravel() for g in np.meshgrid(along, across, indexing="ij"))
        x = x + rng.normal(0, 0.1 * spacing, x.size)
        foot = foot + rng.normal(0, 0.1 * spacing, x.size)
        # a pulse aims at its place on a sloping mean surface: the scan angle alone decides the beam
        aim = np.column_stack([x, foot, np.interp(foot, [0, site.wall, site.toe], [site.deck, site.deck, 0])])
        origins = np.column_stack([x, np.full(x.size, y), np.full(x.size, z)]) + rng.normal(0, 0.01, (x.size, 3))
        shift = rng.uniform(-offset, offset, 3)
        parts.append(
            _measure(
                scene, origins, _unit(aim - origins), rng, noise=noise, footprint=0.0006, second_returns=True, source=k + 1, shift=shift
            )
        )
    return _with_strays(scene, Returns.joined(parts), rng, 2e-4)


def survey_tls(scene: Scene, rng: np.random.Generator, *, density: float, noise: float, offset: float) -> Returns:
    """Tripod stations, four on the wall and one on the opposite mole, each thinned by a grid."""
    site = _site_of(scene)
    h = scene.unit.height / REFERENCE_HEIGHT
    cell = 1 / np.sqrt(density)
    parts = []
    stands = [(f * (site.half_length - h), site.wall - 1.6 * h, site.deck + site.parapet + 1.7) for f in (-0.9, -0.3, 0.3, 0.9)]
    stands.append((rng.uniform(-4, 4) * h, site.toe + 32 * h, 6.0 * h))
    for k, stand in enumerate(stands):
        station = np.array(stand)
        corners = np.array(
            [
                [x, y, z]
                for x in (-site.half_length, site.half_length)
                for y in (0.0, site.toe + 2 * h)
                for z in (-0.3 * h, site.deck + 2 * h)
            ]
        )
        to = corners - station
        if k < 4:
            azimuth, elevation = np.array([-np.pi, np.pi]), np.radians([-80.0, 25.0])
        else:
            turns = np.arctan2(to[:, 0], -to[:, 1])
            azimuth = np.array([turns.min(), turns.max()])
            rise = np.arcsin(to[:, 2] / np.linalg.norm(to, axis=1))
            elevation = np.array([rise.min(), rise.max()])
        # half the cell at the middle of the pile, so that thinning and not the beam decides the spacing there
        step = 0.6 * cell / float(np.median(np.linalg.norm(to, axis=1)))
        step = max(step, float(np.ptp(azimuth)) / 4000)
        a, e = (g.ravel() for g in np.meshgrid(_steps(azimuth, step), _steps(elevation, step), indexing="ij"))
        a, e = a + rng.uniform(0, step), e + rng.uniform(0, step)
        directions = np.column_stack([np.sin(a) * np.cos(e), -np.cos(a) * np.cos(e), np.sin(e)])
        shift = rng.uniform(-offset, offset, 3)
        origins = np.broadcast_to(station, directions.shape)
        seen = _measure(scene, origins, directions, rng, noise=noise, footprint=0.0003, second_returns=False, source=k + 1, shift=shift)
        inside = (np.abs(seen.points[:, 0]) < site.half_length) & (seen.points[:, 1] > 0) & (seen.points[:, 1] < site.toe + 3 * h)
        seen = seen.chosen(inside)
        parts.append(seen.chosen(_thin(seen.points, cell, rng)))
    return _with_strays(scene, Returns.joined(parts), rng, 2e-4)


def survey_photogrammetry(scene: Scene, rng: np.random.Generator, *, density: float, noise: float, offset: float) -> Returns:
    """Dense matching from a block of nadir and oblique images: correlated error, smoothed creases, holes where one image alone sees."""
    del offset  # one adjusted block has no strips
    site = _site_of(scene)
    h = scene.unit.height / REFERENCE_HEIGHT
    cell = 1 / np.sqrt(density)
    cameras = [
        (x * site.half_length, y, z)
        for x in (-0.8, 0, 0.8)
        for y, z in ((-4 * h, 26 * h), (12 * h, 30 * h), (26 * h, 24 * h), (38 * h, 16 * h))
    ]
    cells: list[IntArray] = []
    views: list[Returns] = []
    for k, camera in enumerate(cameras):
        origin = np.array(camera)
        x, y = (
            g.ravel()
            for g in np.meshgrid(np.arange(-site.half_length, site.half_length, 0.75 * cell), np.arange(0, site.toe + 2 * h, 0.75 * cell))
        )
        aim = np.column_stack([x, y, np.interp(y, [0, site.wall, site.toe], [site.deck, site.deck, 0])])
        aim[:, :2] += rng.uniform(-0.4, 0.4, (len(aim), 2)) * cell
        directions = _unit(aim - origin)
        origins = np.broadcast_to(origin, directions.shape)
        seen = _measure(scene, origins, directions, rng, noise=0.0, footprint=0.0004, second_returns=False, source=k + 1, shift=np.zeros(3))
        seen = seen.chosen(_thin(seen.points, cell, rng))
        views.append(seen)
        cells.append(np.unique(_keys(seen.points, 3 * cell)))
    together = Returns.joined(views)
    key, count = np.unique(np.concatenate(cells), return_counts=True)
    matched = np.isin(_keys(together.points, 3 * cell), key[count >= 3])
    cloud = together.chosen(matched & (together.labels != WATER))
    cloud = cloud.chosen(_thin(cloud.points, cell, rng))
    n = len(cloud.points)
    errors = np.column_stack([_field(cloud.points, np.random.default_rng([scene.seed, 5, k]), 0.12 * h, 0.8 * h) for k in range(3)])
    points = cloud.points + noise * errors * [0.6, 0.6, 1] + rng.normal(0, 0.5 * noise, (n, 3))
    cloud = replace(cloud, points=points, source=np.ones(n, dtype=np.int64), time=np.zeros(n))
    return _with_strays(scene, cloud, rng, 2e-4)


def survey_depth_camera(scene: Scene, rng: np.random.Generator, *, density: float, noise: float, offset: float) -> Returns:
    """Four views of a table by a depth camera, already in one frame."""
    h = scene.unit.height
    half, depth, top = 2.9 * h, 3.8 * h, 3.1 * h
    parts = []
    for k, (x, y, z) in enumerate([(-2.9, 6.6, 4.2), (-1.0, 7.2, 4.9), (1.1, 7.2, 4.6), (2.8, 6.7, 4.4)]):
        origin = np.array([x, y, z]) * h
        forward = _unit(np.array([[0.0, 1.3 * h, 0.3 * h]]) - origin)[0]
        right = _unit(np.cross(forward, [0.0, 0, 1])[None])[0]
        up = np.cross(right, forward)
        pixel = 1 / np.sqrt(density) / float(np.linalg.norm(origin))
        i, j = (g.ravel() for g in np.meshgrid(np.arange(-0.62, 0.62, pixel), np.arange(-0.5, 0.5, pixel)))
        directions = _unit(forward + i[:, None] * right + j[:, None] * up)
        origins = np.broadcast_to(origin, directions.shape)
        shift = rng.uniform(-offset, offset, 3)
        seen = _measure(scene, origins, directions, rng, noise=noise, footprint=pixel, second_returns=False, source=k + 1, shift=shift)
        p = seen.points
        # the background is thinned, as an operator does before keeping a scan
        inside = (np.abs(p[:, 0]) < half) & (p[:, 1] < depth) & (p[:, 2] < top)
        parts.append(seen.chosen(inside & ((seen.labels > 0) | (rng.random(len(p)) < 0.24))))
    return _with_strays(scene, Returns.joined(parts), rng, 1e-4)


def _measure(
    scene: Scene,
    origins: FloatArray,
    directions: FloatArray,
    rng: np.random.Generator,
    *,
    noise: float,
    footprint: float,
    second_returns: bool,
    source: int,
    shift: FloatArray,
) -> Returns:
    """Cast, add range noise, edge effects (mixed pixels or second returns) and water dropouts."""
    distance, label, cosine = scene.cast(origins, directions)
    kept = np.isfinite(distance) & ((label != WATER) | (rng.random(len(label)) < 0.04))
    if scene.site is not None:
        # nothing returns from under water
        kept &= (origins[:, 2] + directions[:, 2] * distance > -0.02) | (label == WATER)
    origins, directions, distance, label, cosine = (a[kept] for a in (origins, directions, distance, label, cosine))
    beside = _unit(directions + rng.normal(0, footprint, directions.shape))
    far, far_label, _ = scene.cast(origins, beside)
    step = np.abs(far - distance)
    split = np.isfinite(far) & (step > 0.03 * scene.unit.height) & (rng.random(len(far)) < 0.45)
    measured = distance + rng.normal(0, 1, len(distance)) * noise * (0.85 + 0.15 / np.clip(cosine, 0.25, 1))
    number = np.ones(len(distance), dtype=np.uint8)
    count = np.ones(len(distance), dtype=np.uint8)
    back: Returns | None = None
    time = 1.0 * source * 50 + np.linspace(0, 45, len(distance), endpoint=False)
    if second_returns:
        double = split & (step > 0.25 * scene.unit.height) & (far_label != WATER)
        order = far[double] < distance[double]
        count[double] = 2
        number[double] = np.where(order, 2, 1)
        points = origins[double] + beside[double] * (far[double] + rng.normal(0, noise, int(double.sum())))[:, None]
        back = Returns(
            points + shift,
            far_label[double],
            np.full(len(points), source),
            _intensity(np.ones(len(points)), far_label[double], rng),
            time[double],
            np.where(order, 1, 2).astype(np.uint8),
            np.full(len(points), 2, dtype=np.uint8),
            origins[double],
        )
        split &= ~double
    # a beam that meets two surfaces closer than its pulse length returns a range in between
    measured[split] = distance[split] + rng.uniform(0, 1, int(split.sum())) * (far[split] - distance[split])
    points = origins + directions * measured[:, None] + shift
    first = Returns(points, label, np.full(len(points), source), _intensity(cosine, label, rng), time, number, count, origins)
    return first if back is None else Returns.joined([first, back])


def _with_strays(scene: Scene, cloud: Returns, rng: np.random.Generator, share: float) -> Returns:
    """Add isolated points in the air and put the pulses in order of time."""
    n = max(1, round(share * len(cloud.points)))
    low, high = cloud.points.min(axis=0), cloud.points.max(axis=0)
    strays = rng.uniform(low, high + np.array([0, 0, 0.4 * scene.unit.height]), (n, 3))
    pick = rng.integers(0, len(cloud.points), n)
    one = np.ones(n, dtype=np.uint8)
    added = Returns(strays, np.full(n, OUTLIER), cloud.source[pick], cloud.intensity[pick], cloud.time[pick], one, one, cloud.sensor[pick])
    together = Returns.joined([cloud, added])
    return together.chosen(np.lexsort((together.return_number, together.time)))


def _intensity(cosine: FloatArray, label: IntArray, rng: np.random.Generator) -> NDArray[np.uint16]:
    base = np.select([label > 0, label == ROCK, label == WATER], [20000.0, 13000.0, 3500.0], 17000.0)
    return np.clip(base * (0.35 + 0.65 * cosine) * rng.normal(1, 0.12, len(label)), 200, 60000).astype(np.uint16)


def _thin(points: FloatArray, cell: float, rng: np.random.Generator) -> IntArray:
    """Indices of one random point a cubic cell."""
    order = rng.permutation(len(points))
    _, first = np.unique(_keys(points, cell)[order], return_index=True)
    return np.sort(order[first]).astype(np.int64)


def _keys(points: FloatArray, cell: float) -> IntArray:
    index = np.floor(points / cell).astype(np.int64) + (1 << 20)
    return np.asarray((index[:, 0] << 42) | (index[:, 1] << 21) | index[:, 2])


def _field(points: FloatArray, rng: np.random.Generator, shortest: float, longest: float) -> FloatArray:
    """(n,) values of a smooth random field of unit variance with wavelengths in a range."""
    waves = 24
    direction = _unit(rng.normal(size=(waves, 3)))
    wavelength = np.exp(rng.uniform(np.log(shortest), np.log(longest), waves))
    phase = rng.uniform(0, 2 * np.pi, waves)
    return np.asarray(np.cos(points @ (direction * (2 * np.pi / wavelength)[:, None]).T + phase).sum(axis=1) * np.sqrt(2 / waves))


def _steps(limits: FloatArray, step: float) -> FloatArray:
    return np.arange(float(limits[0]), float(limits[1]), step)


def _unit(vectors: FloatArray) -> FloatArray:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def _site_of(scene: Scene) -> Site:
    if scene.site is None:
        raise ValueError("this instrument surveys a site outdoors")
    return scene.site


def _broken(vertices: FloatArray, unit: UnitType, piled: PiledUnit) -> FloatArray:
    """Vertices of the mesh with the broken leg flattened at an uneven oblique plane."""
    if piled.broken_leg < 0:
        return vertices
    axis = unit.leg_directions[piled.broken_leg]
    lean = vertices @ unit.leg_directions.T
    tilt = np.random.default_rng(piled.number).normal(0, 0.25, 3)
    axial = lean[:, piled.broken_leg]
    across = vertices - axial[:, None] * axis
    limit = piled.broken_length + across @ tilt
    cut = (np.argmax(lean, axis=1) == piled.broken_leg) & (axial > limit)
    result = vertices.copy()
    result[cut] -= (axial - limit)[cut, None] * axis
    return result


def _structure(site: Site, unit: UnitType, rng: np.random.Generator, rough: bool) -> Iterator[tuple[FloatArray, IntArray, int]]:
    """Deck, crown wall and its face, rock, deck furniture and the water surface."""
    h = unit.height / REFERENCE_HEIGHT
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
        flat = np.column_stack([grid, np.zeros(len(grid))])
        relief = np.abs(_field(flat, rng, 0.5 * h, 1.6 * h)) * 0.16 * h + np.abs(_field(flat, rng, 0.25 * h, 0.6 * h)) * 0.05 * h
        level = level - relief
    i, j = np.meshgrid(np.arange(len(x) - 1), np.arange(len(y) - 1), indexing="ij")
    a = (i * len(y) + j).ravel()
    quads = np.vstack([np.column_stack([a, a + len(y), a + 1]), np.column_stack([a + 1, a + len(y), a + len(y) + 1])])
    yield np.column_stack([grid, level]), quads, ROCK
    y0 = site.wall - 2.4 * h
    yield *_box([-2.6 * h, y0, site.deck], [-1.5 * h, y0 + 0.9 * h, site.deck + 0.7 * h]), OBJECT
    for bollard in (-0.5, 0.45):
        yield *_box([bollard * length, y0 + 1.2 * h, site.deck], [bollard * length + 0.3 * h, y0 + 1.5 * h, site.deck + 0.55 * h]), OBJECT
    yield *_tube([0.1 * length, y0 + 0.4 * h, site.deck], 0.09 * h, 6.0 * h), OBJECT
    # a railing post and pipe: cylinders are what a cone finder could take for legs
    yield *_tube([0.3 * length, y0 - 1.5 * h, site.deck], 0.16 * h, 1.0 * h), OBJECT
    far = site.toe + 4 * h
    plane = np.array([[-length, site.wall, 0.0], [length, site.wall, 0.0], [length, far, 0.0], [-length, far, 0.0]])
    yield plane, np.array([[0, 1, 2], [0, 2, 3]]), WATER


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
