"""Registration of overlapping views (depth camera, hand-held scanner) into the frame of the first: multiway ICP with a pose graph.

Every pair of views that overlap is registered (generalised ICP from coarse to fine, Segal, Haehnel and Thrun, 2009), the pairs
become edges of a pose graph weighted by their information, and the graph is optimised with switchable loop closures (Choi, Zhou and
Koltun, 2015, Robust Reconstruction of Indoor Scenes). Views must be roughly aligned, as a rig or a tracking camera delivers them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import Cancelled, InputError

REACHES = (10.0, 3.0)
"""Search distances of the passes, in voxels."""
MIN_FITNESS = 0.25
"""Least share of a view's points with a partner for two views to count as overlapping."""


@dataclass(frozen=True, eq=False)
class RegisteredViews:
    """Result of :func:`register_views`.

    Attributes
    ----------
    motions
        (v, 4, 4) rigid motion of each view into the frame of the first.
    rmse
        Root mean square distance of corresponding points over all overlapping pairs after optimisation, metres.
    overlaps
        Pairs of views that were tied, with the share of points that found a partner.
    """

    motions: FloatArray
    rmse: float
    overlaps: tuple[tuple[int, int, float], ...]


def register_views(
    views: Sequence[FloatArray], *, voxel: float | None = None, is_cancelled: Callable[[], bool] = lambda: False
) -> RegisteredViews:
    """Register views to the first.

    Parameters
    ----------
    views
        (n, 3) metres each, in one rough frame near the origin.
    voxel
        Edge of the voxels in metres; None takes one and a half times the typical point spacing.
    is_cancelled
        Asked between pairs; True ends early with what is tied so far being insufficient.

    Raises
    ------
    InputError
        Fewer than two views, an empty view, or views that do not hang together.
    """
    import open3d as o3d

    if len(views) < 2:
        raise InputError(f"{len(views)} view cannot be registered", remedy="Give at least two overlapping views.")
    for number, view in enumerate(views, start=1):
        if len(view) < 100:
            raise InputError(f"view {number} holds {len(view)} points", remedy="Give views of at least 100 points.")
    if voxel is None:
        voxel = 1.5 * float(np.median([_spacing(view) for view in views]))
    clouds = [_prepared(o3d, view, voxel) for view in views]
    graph = o3d.pipelines.registration.PoseGraph()
    node = o3d.pipelines.registration.PoseGraphNode
    edge = o3d.pipelines.registration.PoseGraphEdge
    start = np.eye(4)
    graph.nodes.append(node(start))
    overlaps: list[tuple[int, int, float]] = []
    for i in range(len(views)):
        for j in range(i + 1, len(views)):
            if is_cancelled():
                raise Cancelled("cancelled")
            motion, fitness, information = _pair(o3d, clouds[i], clouds[j], voxel)
            neighbours = j == i + 1
            if neighbours:
                start = motion @ start if fitness >= MIN_FITNESS else start
                graph.nodes.append(node(np.linalg.inv(start)))
            if fitness >= MIN_FITNESS:
                graph.edges.append(edge(i, j, motion, information, uncertain=not neighbours))
                overlaps.append((i, j, fitness))
    _check_connected(len(views), overlaps)
    registration = o3d.pipelines.registration
    with o3d.utility.VerbosityContextManager(o3d.utility.VerbosityLevel.Error):
        registration.global_optimization(
            graph,
            registration.GlobalOptimizationLevenbergMarquardt(),
            registration.GlobalOptimizationConvergenceCriteria(),
            registration.GlobalOptimizationOption(
                max_correspondence_distance=REACHES[-1] * voxel, edge_prune_threshold=0.25, reference_node=0
            ),
        )
    motions = np.array([n.pose for n in graph.nodes])
    motions = np.linalg.inv(motions[0]) @ motions
    squares, count = 0.0, 0
    for i, j, _ in overlaps:
        result = registration.evaluate_registration(clouds[i], clouds[j], REACHES[-1] * voxel, np.linalg.inv(motions[j]) @ motions[i])
        pairs = len(result.correspondence_set)
        squares += result.inlier_rmse**2 * pairs
        count += pairs
    return RegisteredViews(motions, float(np.sqrt(squares / max(count, 1))), tuple(overlaps))


def _prepared(o3d: Any, view: FloatArray, voxel: float) -> Any:
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(view)).voxel_down_sample(voxel)
    cloud.estimate_normals(o3d.geometry.KDTreeSearchParamHybrid(radius=3 * voxel, max_nn=30))
    return cloud


def _pair(o3d: Any, source: Any, target: Any, voxel: float) -> tuple[FloatArray, float, FloatArray]:
    """Motion of ``source`` onto ``target``, share of points with a partner, and (6, 6) information."""
    import small_gicp

    clouds = [small_gicp.PointCloud(np.asarray(cloud.points)) for cloud in (target, source)]
    for cloud in clouds:
        small_gicp.estimate_covariances(cloud, num_neighbors=20)
    tree = small_gicp.KdTree(clouds[0])
    motion = np.eye(4)
    for reach in REACHES:
        motion = small_gicp.align(
            *clouds, tree, init_T_target_source=motion, registration_type="GICP", max_correspondence_distance=reach * voxel,
            max_iterations=60, rotation_epsilon=1e-6, translation_epsilon=1e-4 * voxel,
        ).T_target_source  # fmt: skip
    registration = o3d.pipelines.registration
    fitness = float(registration.evaluate_registration(source, target, REACHES[-1] * voxel, motion).fitness)
    information = registration.get_information_matrix_from_point_clouds(source, target, REACHES[-1] * voxel, motion)
    return np.array(motion), fitness, np.array(information)


def _check_connected(count: int, overlaps: Sequence[tuple[int, int, float]]) -> None:
    reached, queue = {0}, [0]
    while queue:
        at = queue.pop()
        for i, j, _ in overlaps:
            for a, b in ((i, j), (j, i)):
                if a == at and b not in reached:
                    reached.add(b)
                    queue.append(b)
    if len(reached) < count:
        alone = ", ".join(str(k + 1) for k in range(count) if k not in reached)
        raise InputError(
            f"view {alone} overlaps none of the views tied to the first", remedy="Add views in between, or align it roughly beforehand."
        )


def _spacing(view: FloatArray) -> float:
    from scipy.spatial import cKDTree

    some = view[:: max(1, len(view) // 1000)]
    return float(np.median(cKDTree(view).query(some, k=2)[0][:, 1]))
