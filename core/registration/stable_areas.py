"""Registration of an epoch without targets to a reference epoch on stable surfaces: point-to-plane ICP inside areas that the user chose.

Generalised ICP from a wide reach (Segal, Haehnel and Thrun, 2009, RSS V) is followed by a robust least-squares adjustment of the
distances to the tangent planes of the reference surface (Chen and Medioni, 1992, Image and Vision Computing 10(3)) with Tukey's weights.

Relief, drifts of the sensor and the interpolation of surfaces make neighbouring distances alike, so that the number of points says
little about the accuracy. The scores of the adjustment are therefore summed over patches of the surface, and the variance of these
sums, over what independent points would give, enlarges the covariance (variance of clustered observations: Liang and Zeger, 1986,
Biometrika 73(1)); patches grow until the variance no longer does. What no distance on the areas can show, a mean offset of all flight
strips or stations of an epoch, is added with the strips' offsets in :mod:`tracking`.

A straight crown wall is a prism: nothing on it tells where it is along its own direction. There the cloud keeps its own position, with a
standard deviation that says so, and only the units can tell (datum ``stable``). Whatever else is not determined is refused.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..common.robust import TUKEY, sd_of_deviations
from ..common.voxels import thin
from ..data.crs import LOCAL, horizontal_transform
from ..data.tiles import TileInfo, Window, read_points
from ..data.vector_files import check_vector_file
from .control import Registration
from .transformation import Transformation

if TYPE_CHECKING:
    import shapely


VOXEL_HEIGHTS = 0.03
"""Edge of the voxels that clouds are thinned to, in unit heights: about the point spacing of a survey that shows units."""
REACH_HEIGHTS = 0.5
"""Largest misfit of two clouds before registration, in unit heights."""
FINE_REACH = 3.0
"""Search distance of the adjustment, in voxels."""
NEIGHBOURS = 20
FLATNESS = 0.1
"""Largest ratio of the smallest to the middle variance of a neighbourhood that has a tangent plane."""
MIN_POINTS = 200
MAX_POINTS = 60_000
MIN_OVERLAP = 0.5
"""Least share of the points that lie on the reference surface."""
MISFIT_HEIGHTS = 0.02
"""Largest standard deviation of the distances, in unit heights: more is a surface that changed."""
LEAST_DETERMINED = 0.01
"""Least eigenvalue of the mean normal matrix (arms over their mean length): one plane has three of 0, a right-angled corner 1/3.
Noise of the normals alone brings a tenth to a fifth of this limit (measured), and draws the estimate towards no motion."""
SLIDES = 0.95
"""Least horizontal part of a unit vector of shifts and turns that is a shift along a level wall."""
FIRST_PATCH, MIN_PATCHES = 8.0, 20
"""Edge of the smallest patches in voxels, and least number of patches that a variance is taken from."""


GRID = np.array([[2.0, -1.0, -1.0], [0.0, math.sqrt(3), -math.sqrt(3)], [math.sqrt(2)] * 3]) / math.sqrt(6)
"""(3, 3) axes, as columns, of the grid for voxels and patches, all equally inclined. A level deck or a plumb wall is never parallel to a
side of its cells: where one is, cells part the points by their noise, and their means draw the surface towards the side."""


@dataclass(frozen=True, eq=False)
class Surface:
    """Thinned points inside the areas.

    Attributes
    ----------
    points
        (n, 3) metres, less the reduction point.
    normals
        (n, 3) unit normals of the tangent planes.
    flat
        (n,) whether the neighbourhood is a plane.
    """

    points: FloatArray
    normals: FloatArray
    flat: NDArray[np.bool_]


def read_areas(path: Path, survey_crs: str, layer: str = "") -> shapely.Geometry:
    """Union of the polygons of a layer (GeoPackage, GeoJSON, Shapefile) in the survey's CRS.

    Parameters
    ----------
    path, survey_crs
        File, and CRS of the survey.
    layer
        Name of the layer; empty where the file has but one with polygons.

    Raises
    ------
    InputError
        The file is no vector layer, has several, or holds no polygon.
    CrsError
        The layer has no CRS, or one that cannot be transformed exactly.
    """
    import pyogrio
    import shapely
    from pyogrio.errors import DataLayerError, DataSourceError

    useless = InputError(
        "is not a readable polygon layer", source=path, remedy="Save the stable areas as GeoPackage, GeoJSON or Shapefile."
    )
    check_vector_file(path)
    try:
        with warnings.catch_warnings():
            # what GDAL thinks of the file besides
            warnings.simplefilter("ignore")
            chosen = _layer_of(path, layer)
            meta, _, wkb, _ = pyogrio.raw.read(path, layer=chosen, columns=[])
    except (DataSourceError, DataLayerError, ValueError, RuntimeError) as error:
        raise useless from error
    try:
        shapes = shapely.from_wkb([] if wkb is None else wkb)
    except shapely.errors.ShapelyError as error:
        raise useless from error
    polygons = shapely.make_valid(shapes[np.isin(shapely.get_type_id(shapes), (3, 6)) & ~shapely.is_empty(shapes)])
    areas = shapely.force_2d(shapely.union_all(polygons))
    if not shapely.area(areas) > 0:
        raise InputError("holds no polygon", source=path, remedy="Draw polygons around surfaces that do not move, such as the crown wall.")
    if survey_crs == LOCAL:
        return areas
    transform = horizontal_transform(meta["crs"], survey_crs, source=path)
    return areas if transform is None else shapely.transform(areas, transform)


def _layer_of(path: Path, layer: str) -> str | None:
    """The layer of polygons to read: the one that is named, or the only one."""
    import pyogrio

    listed = [(str(name), str(kind or "")) for name, kind in pyogrio.list_layers(path)]
    names = [name for name, kind in listed if "Polygon" in kind or kind in ("Unknown", "GeometryCollection")]
    if layer and layer not in [name for name, _ in listed]:
        raise InputError(f"has no layer {layer!r}", source=path, remedy=f"Its layers are: {', '.join(name for name, _ in listed)}.")
    if not layer and len(names) > 1:
        raise InputError(
            f"has {len(names)} layers of polygons: {', '.join(names)}",
            source=path,
            remedy=f'Name one: stable_areas = "{path.name}|layername={names[-1]}"',
        )
    return layer or (names[0] if names else listed[0][0] if listed else None)


def read_stable_points(
    tiles: Sequence[TileInfo],
    survey_crs: str,
    areas: shapely.Geometry,
    origin: FloatArray,
    voxel: float,
    is_cancelled: Callable[[], bool] = lambda: False,
) -> FloatArray:
    """(n, 3) points of a cloud inside the areas, thinned to one mean point a voxel, less ``origin``.

    Tiles are read one at a time and only where they touch the areas, so that memory holds one tile's share of them.
    """
    import shapely

    shapely.prepare(areas)
    parts = [np.empty((0, 3))]
    for tile in tiles:
        inside = shapely.intersection(areas, shapely.box(*tile.low[:2], *tile.high[:2]))
        if shapely.is_empty(inside):
            continue
        # the window is half open
        window = Window(*shapely.bounds(inside).tolist()).grown(1e-3)
        xyz = read_points([tile], survey_crs, window=window, origin=origin, is_cancelled=is_cancelled).xyz
        parts.append(_thinned(xyz[shapely.contains_xy(areas, xyz[:, 0] + origin[0], xyz[:, 1] + origin[1])], voxel))
    return _thinned(np.vstack(parts), voxel)


def surface_of(points: FloatArray) -> Surface:
    """Tangent planes of (n, 3) points from their nearest neighbours."""
    _, nearest = cKDTree(points).query(points, k=min(NEIGHBOURS, len(points)))
    around = points[nearest] - points[nearest].mean(axis=1, keepdims=True)
    variances, axes = np.linalg.eigh(np.swapaxes(around, 1, 2) @ around)
    return Surface(points, axes[:, :, 0], variances[:, 0] < FLATNESS * variances[:, 1])


def register_on_areas(reference: FloatArray, moving: FloatArray, origin: FloatArray, height: float) -> Registration:
    """Rigid transformation of a cloud to the registered cloud of the reference epoch.

    Parameters
    ----------
    reference
        (n, 3) thinned points of the reference epoch inside the areas and a margin, in the control frame less ``origin``, metres.
    moving
        (m, 3) thinned points of the epoch inside the areas, in the frame of its cloud less ``origin``.
    origin
        (3,) reduction point.
    height
        Unit height H in metres: sets voxels, reach and the gates.

    Returns
    -------
    Registration without targets; ``redundancy`` counts independent patches, and the covariance is that of the transformation relative
    to the reference epoch.

    Raises
    ------
    InputError
        Too few points, too little overlap, surfaces that differ, or surfaces that leave a direction undetermined.
    """
    for points, what in ((reference, "of the reference epoch"), (moving, "of this epoch")):
        if len(points) < MIN_POINTS:
            raise InputError(
                f"only {len(points)} points {what} lie inside the areas",
                remedy="Draw the areas where both clouds show a surface, and check the CRS of the layer.",
            )
    voxel = VOXEL_HEIGHTS * height
    surface, moving = surface_of(reference), _flat_points(moving)
    tree = cKDTree(surface.points)
    motion = _coarse(surface.points, moving, REACH_HEIGHTS * height)
    found = _adjust(surface, tree, moving, motion, FINE_REACH * voxel)
    if found.overlap < MIN_OVERLAP:
        raise InputError(
            f"only {100 * found.overlap:.0f} % of the points inside the areas lie on the surface of the reference epoch",
            remedy=f"Choose surfaces that both epochs show unchanged, and clouds that agree within {REACH_HEIGHTS * height:.2g} m.",
        )
    if found.sigma > MISFIT_HEIGHTS * height:
        raise InputError(
            f"the surfaces inside the areas differ by {1000 * found.sigma:.0f} mm (standard deviation)",
            remedy="Leave out what moved, grew or was rebuilt, and water and plants.",
        )
    notes = []
    along = _undetermined(found)
    if along is not None:
        turn, shift = motion_parts(motion)
        before = turn.T @ (found.centre - shift)
        motion[:3, 3] -= along * (along @ (found.centre - before))
        found = _adjust(surface, tree, moving, motion, FINE_REACH * voxel, along)
        azimuth = math.degrees(math.atan2(along[0], along[1])) % 180
        notes.append(
            f"the stable areas do not tell the position along azimuth {azimuth:.0f} degrees: the cloud keeps its own there, and only datum "
            "stable can show motions that way"
        )
    return _registration(found, along, notes, origin, height, voxel)


def _registration(
    found: _Adjusted, along: FloatArray | None, notes: list[str], origin: FloatArray, height: float, voxel: float
) -> Registration:
    """Registration of an adjustment, its covariance enlarged by what neighbouring points have in common."""
    factor, patches = _correlation(found, FIRST_PATCH * voxel)
    covariance = np.zeros((7, 7))
    covariance[:6, :6] = found.cofactor * found.variance * factor
    if along is not None:
        covariance[:3, :3] += np.outer(along, along) * (REACH_HEIGHTS * height) ** 2
    turn, shift = motion_parts(found.motion)
    before = turn.T @ (found.centre - shift)
    transformation = Transformation(
        origin_from=before + origin,
        origin_to=found.centre + origin,
        translation=np.zeros(3),
        rotation=turn,
        scale=1.0,
        covariance=covariance,
    )
    notes.insert(
        0,
        f"{len(found.used)} points on stable areas, {100 * found.overlap:.0f} % on the reference surface within "
        f"{1000 * found.sigma:.1f} mm; neighbours are alike, so that they count as {len(found.used) / factor:.0f}",
    )
    return Registration(
        transformation=transformation,
        residuals=(),
        sigma0=math.sqrt(factor),
        redundancy=patches - 6,
        exclusion_effect=0.0,
        notes=tuple(notes),
    )


@dataclass(frozen=True, eq=False, kw_only=True)
class _Adjusted:
    """Adjustment at its solution: (4, 4) motion, rows (k, 6) about ``centre``, (k,) distances and weights, (k, 3) places of the points."""

    motion: FloatArray
    centre: FloatArray
    rows: FloatArray
    distances: FloatArray
    weights: FloatArray
    used: FloatArray
    sigma: float
    overlap: float

    @property
    def normal_matrix(self) -> FloatArray:
        """(6, 6) of the last step."""
        return np.asarray(self.rows.T @ (self.weights[:, None] * self.rows))

    @property
    def cofactor(self) -> FloatArray:
        """(6, 6) of the parameters; zero along a direction that was held.

        What a distance changes in the solution is the slope of Tukey's function, which is less than its weight (Huber, 1981, Robust
        Statistics, 6.3).
        """
        root = np.sqrt(self.weights)
        slopes = root * (5 * root - 4)
        return np.asarray(np.linalg.pinv(self.rows.T @ (slopes[:, None] * self.rows), rcond=1e-9, hermitian=True))

    @property
    def variance(self) -> float:
        """Of unit weight, were all points independent."""
        return float(self.weights @ self.distances**2 / (self.weights.sum() - 6))


def motion_parts(motion: FloatArray) -> tuple[FloatArray, FloatArray]:
    """(3, 3) rotation and (3,) shift of a (4, 4) rigid motion."""
    return motion[:3, :3], motion[:3, 3]


def _flat_points(points: FloatArray) -> FloatArray:
    """Points with a tangent plane, a regular sample of them where there are very many."""
    flat = points[surface_of(points).flat]
    return flat[:: max(1, math.ceil(len(flat) / MAX_POINTS))]


def _thinned(points: FloatArray, voxel: float) -> FloatArray:
    """Mean point of every voxel."""
    place = _cells(points, voxel)
    count = np.bincount(place)
    return np.column_stack([np.bincount(place, points[:, k]) / count for k in range(3)])


def _cells(points: FloatArray, edge: float) -> NDArray[np.int64]:
    """(n,) number of the cell of :data:`GRID` that each point lies in."""
    return thin(points @ GRID, edge)[1]


def _coarse(reference: FloatArray, moving: FloatArray, reach: float) -> FloatArray:
    """(4, 4) motion by generalised ICP from a wide to a narrow reach."""
    import small_gicp

    clouds = [small_gicp.PointCloud(points) for points in (reference, moving)]
    for cloud in clouds:
        small_gicp.estimate_covariances(cloud, num_neighbors=NEIGHBOURS, num_threads=1)
    tree = small_gicp.KdTree(clouds[0], num_threads=1)
    motion = np.eye(4)
    for part in (1.0, 0.3):
        motion = np.array(
            small_gicp.align(
                *clouds, tree, init_T_target_source=motion, registration_type="GICP", max_correspondence_distance=part * reach,
                num_threads=1, max_iterations=60,
            ).T_target_source
        )  # fmt: skip
    return motion


def _adjust(
    surface: Surface, tree: cKDTree, moving: FloatArray, motion: FloatArray, reach: float, held: FloatArray | None = None
) -> _Adjusted:
    """Robust least squares of the distances to the reference's tangent planes, with partners looked up anew in every step.

    Nothing moves along the direction ``held``.
    """
    for _ in range(30):
        turn, shift = motion_parts(motion)
        moved = moving @ turn.T + shift
        away, nearest = tree.query(moved, distance_upper_bound=reach)
        pairs = np.flatnonzero(np.isfinite(away))
        pairs = pairs[surface.flat[nearest[pairs]]]
        if len(pairs) < MIN_POINTS:
            return _Adjusted(
                motion=motion,
                centre=np.zeros(3),
                rows=np.empty((0, 6)),
                distances=np.empty(0),
                weights=np.empty(0),
                used=np.empty((0, 3)),
                sigma=0.0,
                overlap=0.0,
            )
        across, places = surface.normals[nearest[pairs]], moved[pairs]
        distances = np.einsum("ni,ni->n", places - surface.points[nearest[pairs]], across)
        sigma = sd_of_deviations(distances)
        weights = np.clip(1 - (distances / (TUKEY * sigma)) ** 2, 0, None) ** 2
        centre = np.average(places, axis=0, weights=weights)
        rows = np.hstack([across, np.cross(places - centre, across)])
        if held is not None:
            rows[:, :3] -= np.outer(across @ held, held)
        normal = rows.T @ (weights[:, None] * rows)
        # a direction without any hold stays where it is; whether there is one is judged afterwards
        change = -np.linalg.lstsq(normal, rows.T @ (weights * distances), rcond=1e-9)[0]
        step = np.eye(4)
        step[:3, :3] = Rotation.from_rotvec(change[3:]).as_matrix()
        step[:3, 3] = centre + change[:3] - step[:3, :3] @ centre
        if np.linalg.norm(change[:3]) < 1e-6 * reach and np.linalg.norm(change[3:]) < 1e-9:
            break
        motion = step @ motion
    used = weights > 0
    overlap = float(used.sum() / len(moving))
    return _Adjusted(
        motion=motion,
        centre=centre,
        rows=rows[used],
        distances=distances[used],
        weights=weights[used],
        used=places[used],
        sigma=sigma,
        overlap=overlap,
    )


def _undetermined(found: _Adjusted) -> FloatArray | None:
    """(3,) the one horizontal direction along which the surfaces may slide, as along a straight wall; None where all is determined.

    Raises
    ------
    InputError
        More than that is undetermined.
    """
    length = float(np.sqrt(np.average(np.sum((found.used - found.centre) ** 2, axis=1), weights=found.weights)))
    scaling = np.array([1.0] * 3 + [1 / length] * 3)
    values, axes = np.linalg.eigh(found.normal_matrix * np.outer(scaling, scaling) / found.weights.sum())
    weak = axes[:, values < LEAST_DETERMINED].T
    if not len(weak):
        return None
    if len(weak) == 1 and np.linalg.norm(weak[0, :2]) > SLIDES:
        along = np.array([weak[0, 0], weak[0, 1], 0.0])
        return along / float(np.linalg.norm(along))
    raise InputError(
        f"the surfaces inside the areas leave {len(weak)} of six shifts and turns undetermined",
        remedy="Add surfaces that face other ways: a deck alone is one plane; a wall's front, a parapet or a step hold it.",
    )


def _correlation(found: _Adjusted, edge: float) -> tuple[float, int]:
    """Factor by which correlation of neighbouring distances enlarges the covariance, and the number of patches it was taken from."""
    scores = found.rows * (found.weights * found.distances)[:, None]
    inverse = found.cofactor / found.variance
    free = int(np.linalg.matrix_rank(inverse, hermitian=True))
    factor, count = 1.0, len(scores)
    while True:
        patch = _cells(found.used, edge)
        patches = int(patch.max()) + 1
        if patches < MIN_PATCHES:
            return factor, count
        sums = np.column_stack([np.bincount(patch, scores[:, k]) for k in range(6)])
        # of the parameter that suffers most: a tilt about the long axis of a wall more than its height
        grown = float(np.max(np.diag(inverse @ (sums.T @ sums)))) * patches / (patches - free)
        if grown > factor:
            factor, count = grown, patches
        edge *= 2
