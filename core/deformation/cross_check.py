"""Independent check of a unit's displacement: its own points of two epochs registered to each other without any model (GICP).

Generalised ICP (Segal, Haehnel and Thrun, 2009) of the later points onto the earlier ones gives the rigid motion between them. It
needs surface seen in both epochs and knows nothing of cones, so that where both agree within their covariances the displacement does
not depend on the model; where they do not, a broken leg, growth or a wrong unit is likely.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import small_gicp
from scipy.spatial import cKDTree
from scipy.special import chdtrc

from ..common.arrays import FloatArray
from ..common.robust import sd_of_deviations
from ..model.pose import Pose, rotation_angle

MIN_POINTS = 60
MAX_POINTS = 1000
NEIGHBOURS = 20
AGREEMENT_LEVEL = 0.001
"""Level of the test of agreement, low because it asks for one gross difference among many units."""


@dataclass(frozen=True, eq=False, kw_only=True)
class CrossCheck:
    """Motion of a unit by direct registration beside the one by the model.

    Attributes
    ----------
    vector
        (3,) displacement of the unit's centre by GICP, metres.
    turn
        Rotation angle by GICP, radians.
    covariance
        (3, 3) of ``vector``.
    overlap
        Share of the later points that have a neighbour on the earlier surface.
    difference
        Length of GICP's less the model's displacement, metres.
    statistic, p_value
        Test that both agree.
    agrees
        False where they do not; None where too little surface is seen in both epochs.
    reason
        Why there is no answer, or what to look at.
    """

    vector: FloatArray
    turn: float
    covariance: FloatArray
    overlap: float
    difference: float
    statistic: float
    p_value: float
    agrees: bool | None
    reason: str


def cross_check(
    before: FloatArray, after: FloatArray, pose_before: Pose, pose_after: Pose, covariance: FloatArray, noise: float
) -> CrossCheck:
    """Compare a unit's displacement with direct registration of its points.

    Parameters
    ----------
    before, after
        (n, 3), (m, 3) its points in two epochs, one frame near the origin, offsets of strips removed.
    pose_before, pose_after
        Model's poses in that frame, legs numbered alike.
    covariance
        (3, 3) of the model's displacement of the centre, without registration (both ways share it).
    noise
        Standard deviation of a point along the surface normal, metres.
    """
    if min(len(before), len(after)) < MIN_POINTS:
        return _nothing(f"fewer than {MIN_POINTS} points in one epoch")
    start = _motion(pose_before, pose_after)
    source, target = _thinned(after), _thinned(before)
    tree = cKDTree(target)
    spacing = float(np.median(tree.query(target, k=2)[0][:, 1]))
    reach = 4 * (spacing + noise)
    guess = np.linalg.inv(start)
    moved = source @ guess[:3, :3].T + guess[:3, 3]
    overlap = float(np.mean(tree.query(moved)[0] < reach))
    if overlap < 0.2:
        return _nothing("too little surface is seen in both epochs")
    clouds = [small_gicp.PointCloud(points) for points in (target, source)]
    for cloud in clouds:
        small_gicp.estimate_normals_covariances(cloud, num_neighbors=NEIGHBOURS, num_threads=1)
    result = small_gicp.align(
        *clouds, small_gicp.KdTree(clouds[0]), init_T_target_source=guess, registration_type="GICP", max_correspondence_distance=reach,
        num_threads=1, max_iterations=40, rotation_epsilon=1e-5, translation_epsilon=1e-3 * noise,
    )  # fmt: skip
    motion = np.linalg.inv(result.T_target_source)
    vector = motion[:3, :3] @ pose_before.centre + motion[:3, 3] - pose_before.centre
    aligned = source @ result.T_target_source[:3, :3].T + result.T_target_source[:3, 3]
    own = _covariance(tree, clouds[0].normals()[:, :3], aligned, pose_before.centre, reach)
    gap = vector - (pose_after.centre - pose_before.centre)
    # both use the same points: their difference varies by less than the sum, so that the test errs on the side of agreement
    statistic = float(gap @ np.linalg.solve(own + covariance, gap))
    p_value = float(chdtrc(3, statistic))
    agrees = p_value >= AGREEMENT_LEVEL
    turn = rotation_angle(np.eye(3), motion[:3, :3])
    return CrossCheck(
        vector=vector,
        turn=turn,
        covariance=own,
        overlap=overlap,
        difference=float(np.linalg.norm(gap)),
        statistic=statistic,
        p_value=p_value,
        agrees=agrees,
        reason="" if agrees else "look for a broken leg, growth or a wrong unit",
    )


def _nothing(reason: str) -> CrossCheck:
    nan = math.nan
    return CrossCheck(
        vector=np.full(3, nan),
        turn=nan,
        covariance=np.full((3, 3), nan),
        overlap=0.0,
        difference=nan,
        statistic=nan,
        p_value=nan,
        agrees=None,
        reason=reason,
    )


def _motion(before: Pose, after: Pose) -> FloatArray:
    """(4, 4) rigid motion that takes the earlier pose to the later one."""
    motion = np.eye(4)
    motion[:3, :3] = after.rotation @ before.rotation.T
    motion[:3, 3] = after.centre - motion[:3, :3] @ before.centre
    return motion


def _thinned(points: FloatArray) -> FloatArray:
    return np.ascontiguousarray(points[:: max(1, math.ceil(len(points) / MAX_POINTS))])


def _covariance(tree: cKDTree, normals: FloatArray, source: FloatArray, centre: FloatArray, reach: float) -> FloatArray:
    """(3, 3) covariance of the translation at the centre from the point-to-plane system at the solution, to the points of a tree.

    Neighbouring normals come from the same few points, so that of the points on one patch only as many count as independent as
    there are such patches: one in the root of NEIGHBOURS.
    """
    distance, nearest = tree.query(source)
    good = distance < reach
    across = normals[nearest[good]]
    arms = source[good] - centre
    residuals = np.einsum("ni,ni->n", source[good] - tree.data[nearest[good]], across)
    rows = np.hstack([across, np.cross(arms, across)])
    scale = sd_of_deviations(residuals)
    length = float(np.sqrt(np.mean(np.sum(arms**2, axis=1))))
    prior = np.diag([1 / length**2] * 3 + [1.0] * 3)
    normal = rows.T @ rows / (math.sqrt(NEIGHBOURS) * scale**2) + prior
    return np.asarray(np.linalg.inv(normal)[:3, :3])
