"""Instruments that survey a simulated site: rays cast against the scene, then range noise and artefacts.

All coordinates are in the site frame of ``armour_pile``.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray, IntArray
from .armour_pile import Site
from .smoothing_matcher import MatchedView
from .virtual_scene import OUTLIER, REFERENCE_HEIGHT, ROCK, WATER, Scene, smooth_field, unit_vectors

AGREEING_IMAGES = 3
"""Images that must see a place for dense matching to keep it where it is."""
ISLAND_HEIGHTS = 0.1
"""Size of a patch of wrong matches, in unit heights: assumed, some 0.3 m on units of 3 m."""
MISMATCHED = 0.3
"""Share of such patches that are kept, of those in hollows that fewer images see: assumed; filters of small clusters leave some."""
WRONG_DEPTH_HEIGHTS = 0.1
"""Standard deviation of their depth, in unit heights: assumed, what is seen in hollows between units is some decimetres deep."""


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


def survey_uav(
    scene: Scene, rng: np.random.Generator, *, density: float, noise: float, offset: float, views: np.random.Generator | None = None
) -> Returns:
    """Airborne profiler on three lines along the wall and a sparser oblique one from the sea; double returns at edges."""
    site, length = _site_of(scene)
    h = scene.unit.height / REFERENCE_HEIGHT
    lines = [
        (site.wall - 4 * h, 50.0 * h, 0.31),
        (site.wall + 5 * h, 50.0 * h, 0.29),
        (site.wall + 13 * h, 50.0 * h, 0.2),
        (site.wall + 24 * h, 44.0 * h, 0.1),
    ]
    if views is not None:
        lines = [(y + float(views.uniform(-7, 7)) * h, z * float(views.uniform(0.75, 1.1)), share) for y, z, share in lines]
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
        beams = unit_vectors(aim - origins)
        parts.append(_measure(scene, origins, beams, rng, noise=noise, footprint=0.0006, second_returns=True, source=k + 1, shift=shift))
    return _with_strays(scene, Returns.joined(parts), rng, 2e-4)


def survey_tls(
    scene: Scene, rng: np.random.Generator, *, density: float, noise: float, offset: float, views: np.random.Generator | None = None
) -> Returns:
    """Tripod stations, four on the wall and one on the opposite mole, each thinned by a grid; two on the wall of a stretch of a coast."""
    site, length = _site_of(scene)
    h = scene.unit.height / REFERENCE_HEIGHT
    cell = 1 / np.sqrt(density)
    parts = []
    alone = length == site.half_length
    places = (-0.9, -0.3, 0.3, 0.9) if alone else (-0.5, 0.5)
    stands = [(f * (length - h), site.wall - 1.6 * h, site.deck + site.parapet + 1.7) for f in places]
    if views is not None:
        stands = [(x + float(views.uniform(-0.3, 0.3)) * length, y, z) for x, y, z in stands]
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
        if k < len(places):
            azimuth, elevation = np.array([-np.pi, np.pi]), np.radians([-80.0, 25.0])
        else:
            turns = np.arctan2(to[:, 0], -to[:, 1])
            azimuth = np.array([turns.min(), turns.max()])
            rise = np.arcsin(to[:, 2] / np.linalg.norm(to, axis=1))
            elevation = np.array([rise.min(), rise.max()])
        # half the cell at the middle of the pile, so that thinning and not the beam decides the spacing there
        step = 0.6 * cell / float(np.median(np.linalg.norm(to, axis=1)))
        step = max(step, float(np.ptp(azimuth)) / (4000 if alone else 2000))
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


def survey_photogrammetry(
    scene: Scene, rng: np.random.Generator, *, density: float, noise: float, offset: float, views: np.random.Generator | None = None
) -> Returns:
    """Dense matching from a block of nadir and oblique images: correlated error, smoothed creases, holes where one image alone sees.

    Where the surfaces say so, narrow hollows are bridged.
    """
    del offset  # one adjusted block has no strips
    site, length = _site_of(scene)
    h = scene.unit.height / REFERENCE_HEIGHT
    cell = 1 / np.sqrt(density)
    seaward = float(views.uniform(-10, 10)) * h if views is not None else 0.0
    cameras = [
        (x * length, y + seaward, z)
        for x in (-0.8, 0, 0.8)
        for y, z in ((-4 * h, 26 * h), (12 * h, 30 * h), (26 * h, 24 * h), (38 * h, 16 * h))
    ]
    cells: list[IntArray] = []
    seen_by: list[Returns] = []
    for k, camera in enumerate(cameras):
        origin = np.array(camera)
        x, y = (g.ravel() for g in np.meshgrid(np.arange(-length, length, 0.75 * cell), np.arange(0, site.toe + 2 * h, 0.75 * cell)))
        aim = np.column_stack([x, y, np.interp(y, [0, site.wall, site.toe], [site.deck, site.deck, 0])])
        aim[:, :2] += rng.uniform(-0.4, 0.4, (len(aim), 2)) * cell
        directions = unit_vectors(aim - origin)
        origins = np.broadcast_to(origin, directions.shape)
        bridging = scene.surfaces.bridging
        shown = MatchedView(scene, origin, aim, bridging, 0.75 * cell) if bridging > 0 else scene
        seen = _measure(shown, origins, directions, rng, noise=0.0, footprint=0.0004, second_returns=False, source=k + 1, shift=np.zeros(3))
        seen = seen.chosen(_thin(seen.points, cell, rng))
        seen_by.append(seen)
        cells.append(np.unique(_keys(seen.points, 3 * cell)))
    together = Returns.joined(seen_by)
    key, count = np.unique(np.concatenate(cells), return_counts=True)
    matched = np.isin(_keys(together.points, 3 * cell), key[count >= AGREEING_IMAGES])
    cloud = together.chosen(matched & (together.labels != WATER))
    if scene.surfaces.bridging > 0:
        # beams that pass by an edge far into the sky lie outside of what is surveyed
        on_site = np.all((together.points > cloud.points.min(axis=0)) & (together.points < cloud.points.max(axis=0)), axis=1)
        hidden = ~matched & (together.labels > 0) & on_site
        cloud = Returns.joined([cloud, mismatched(together.chosen(hidden), scene.unit.height, rng)])
    cloud = cloud.chosen(_thin(cloud.points, cell, rng))
    n = len(cloud.points)
    places = cloud.points + np.array([scene.along, 0.0, 0.0])
    # other images of another day err otherwise, stretches of one block of images alike
    drawn = [np.random.default_rng([scene.seed, 5, scene.epoch, k]) for k in range(3)]
    errors = np.column_stack([smooth_field(places, of_axis, 0.12 * h, 0.8 * h) for of_axis in drawn])
    points = cloud.points + noise * errors * [0.6, 0.6, 1] + rng.normal(0, 0.5 * noise, (n, 3))
    cloud = replace(cloud, points=points, source=np.ones(n, dtype=np.int64), time=np.zeros(n))
    return _with_strays(scene, cloud, rng, 2e-4)


def mismatched(weak: Returns, height: float, rng: np.random.Generator) -> Returns:
    """What dense matching keeps of places on units that too few images see: islands of smooth surface at a wrong depth.

    Dark hollows show hardly any texture, and few images look into them. A matcher that prefers smooth depths gives such a place one depth,
    right or wrong, and where two images happen to agree it stays: islands before or behind the true surface, inside solids too.

    Parameters
    ----------
    weak
        Points of those places as single images see them.
    height
        Nominal height of a unit, metres.
    """
    if not len(weak.points):
        return weak
    patches, own = np.unique(_keys(weak.points, ISLAND_HEIGHTS * height), return_inverse=True)
    kept = rng.random(len(patches)) < MISMATCHED
    wrong = rng.normal(0, WRONG_DEPTH_HEIGHTS * height, len(patches))
    on_island = kept[own]
    ray = unit_vectors(weak.points - weak.sensor)
    moved = replace(weak, points=weak.points + wrong[own][:, None] * ray, labels=np.full(len(weak.labels), OUTLIER))
    return moved.chosen(on_island)


def survey_depth_camera(
    scene: Scene, rng: np.random.Generator, *, density: float, noise: float, offset: float, views: np.random.Generator | None = None
) -> Returns:
    """Four views of a table by a depth camera, already in one frame."""
    h = scene.unit.height
    aside = float(views.uniform(-1, 1)) if views is not None else 0.0
    half, depth, top = 2.9 * h, 3.8 * h, 3.1 * h
    parts = []
    for k, (x, y, z) in enumerate([(-2.9, 6.6, 4.2), (-1.0, 7.2, 4.9), (1.1, 7.2, 4.6), (2.8, 6.7, 4.4)]):
        origin = np.array([x + aside, y, z]) * h
        forward = unit_vectors(np.array([[0.0, 1.3 * h, 0.3 * h]]) - origin)[0]
        right = unit_vectors(np.cross(forward, [0.0, 0, 1])[None])[0]
        up = np.cross(right, forward)
        pixel = 1 / np.sqrt(density) / float(np.linalg.norm(origin))
        i, j = (g.ravel() for g in np.meshgrid(np.arange(-0.62, 0.62, pixel), np.arange(-0.5, 0.5, pixel)))
        directions = unit_vectors(forward + i[:, None] * right + j[:, None] * up)
        origins = np.broadcast_to(origin, directions.shape)
        shift = rng.uniform(-offset, offset, 3)
        seen = _measure(scene, origins, directions, rng, noise=noise, footprint=pixel, second_returns=False, source=k + 1, shift=shift)
        p = seen.points
        # the background is thinned, as an operator does before keeping a scan
        inside = (np.abs(p[:, 0]) < half) & (p[:, 1] < depth) & (p[:, 2] < top)
        parts.append(seen.chosen(inside & ((seen.labels > 0) | (rng.random(len(p)) < 0.24))))
    return _with_strays(scene, Returns.joined(parts), rng, 1e-4)


def _measure(
    scene: Scene | MatchedView,
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
    beside = unit_vectors(directions + rng.normal(0, footprint, directions.shape))
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


def _steps(limits: FloatArray, step: float) -> FloatArray:
    return np.arange(float(limits[0]), float(limits[1]), step)


def _site_of(scene: Scene) -> tuple[Site, float]:
    """The site, and half the length of the stretch that is surveyed."""
    if scene.site is None or scene.core is None:
        raise ValueError("this instrument surveys a site outdoors")
    return scene.site, scene.core
