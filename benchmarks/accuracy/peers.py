"""Other software on the same points: CloudCompare's RANSAC cones, OpenCV's point-pair features, Open3D's FPFH + RANSAC + ICP.

None of them is needed by tetratrack. CloudCompare is the Debian package ``cloudcompare`` (with ``xvfb``); OpenCV needs
``pip install opencv-contrib-python-headless``.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from tetratrack.benchmarks.ground_truth import EpochCloud, FloatArray, TrueUnit
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate, sample_surface
from tetratrack.core.model.unit_types import UnitType

VOXEL = 0.02
"""Thinning before any peer, as a fraction of H."""


def with_normals(points: FloatArray, voxel: float) -> Any:
    """Open3D cloud, thinned, with normals that point up."""
    import open3d as o3d

    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points)).voxel_down_sample(voxel)
    cloud.estimate_normals(o3d.geometry.KDTreeSearchParamHybrid(radius=4 * voxel, max_nn=30))
    cloud.orient_normals_to_align_with_direction(np.array([0.0, 0, 1]))
    return cloud


def refined(source: Any, target: Any, start: FloatArray, reach: float) -> tuple[FloatArray, float]:
    """(4, 4) after point-to-plane ICP of a model on a scene, and the share of the model that has a partner."""
    import open3d as o3d

    registration = o3d.pipelines.registration
    result = registration.registration_icp(source, target, reach, start, registration.TransformationEstimationPointToPlane())
    return np.array(result.transformation), float(result.fitness)


def model_cloud(unit: UnitType, count: int = 3000) -> Any:
    """Open3D cloud of the whole surface of a unit with outward normals."""
    import open3d as o3d

    points, normals, _ = sample_surface(unit, count, np.random.default_rng(0))
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    cloud.normals = o3d.utility.Vector3dVector(normals)
    return cloud


def _pose(matrix: FloatArray) -> Pose:
    u, _, v = np.linalg.svd(matrix[:3, :3])
    return Pose(matrix[:3, 3], u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v)


def point_pair_features(cloud: EpochCloud, unit: UnitType, wanted: int) -> list[Pose]:
    """Poses by ``cv2.ppf_match_3d``: the best by votes are refined by ICP, then the best of those by fitness, no two centres within 0.4 H.

    It is told how many units there are.
    """
    from cv2 import ppf_match_3d

    model = model_cloud(unit)
    scene = with_normals(cloud.points, VOXEL * unit.height)
    detector = ppf_match_3d.PPF3DDetector(0.04, 0.04, 30)
    detector.trainModel(np.hstack([model.points, model.normals]).astype(np.float32))
    found = detector.match(np.hstack([scene.points, scene.normals]).astype(np.float32), 1.0 / 5.0, 0.03)
    thin = model.voxel_down_sample(0.04 * unit.height)
    starts = [np.array(c.pose, dtype=np.float64) for c in sorted(found, key=lambda p: -p.numVotes)]
    best = apart([(_pose(start), 0.0) for start in starts], 0.2 * unit.height, 6 * wanted)
    fitted = []
    for pose in best:
        start = np.eye(4)
        start[:3, :3], start[:3, 3] = pose.rotation, pose.centre
        matrix, fitness = refined(thin, scene, start, 0.06 * unit.height)
        fitted.append((_pose(matrix), fitness))
    return apart(sorted(fitted, key=lambda f: -f[1]), 0.4 * unit.height, wanted)


def apart(candidates: list[tuple[Pose, float]], distance: float, wanted: int) -> list[Pose]:
    """The first poses of a ranked list with no two centres nearer than a distance."""
    chosen: list[Pose] = []
    for pose, _ in candidates:
        if len(chosen) == wanted:
            break
        if all(np.linalg.norm(pose.centre - other.centre) >= distance for other in chosen):
            chosen.append(pose)
    return chosen


def fpfh_ransac(target: Any, model: Any, voxel: float) -> tuple[FloatArray, float]:
    """Global registration of a model to a cloud by FPFH features, RANSAC and ICP."""
    import open3d as o3d

    registration = o3d.pipelines.registration
    near = o3d.geometry.KDTreeSearchParamHybrid(radius=8 * voxel, max_nn=100)
    features = [registration.compute_fpfh_feature(c, near) for c in (model, target)]
    result = registration.registration_ransac_based_on_feature_matching(
        model,
        target,
        *features,
        mutual_filter=False,
        max_correspondence_distance=2 * voxel,
        estimation_method=registration.TransformationEstimationPointToPoint(False),
        ransac_n=3,
        checkers=[registration.CorrespondenceCheckerBasedOnDistance(2 * voxel)],
        criteria=registration.RANSACConvergenceCriteria(200_000, 0.999),
    )
    return refined(model, target, np.array(result.transformation), 2 * voxel)


def fpfh_blind(cloud: EpochCloud, unit: UnitType, wanted: int, seconds: float = 300.0) -> list[Pose]:
    """Peel units off the whole scene one by one; stops when three tries in a row explain nothing new, or when time is up."""
    import open3d as o3d

    end = time.monotonic() + seconds
    o3d.utility.random.seed(1)
    voxel = 0.03 * unit.height
    model = model_cloud(unit).voxel_down_sample(voxel)
    left = with_normals(cloud.points, voxel)
    poses: list[Pose] = []
    failures = 0
    while len(poses) < wanted and failures < 3 and time.monotonic() < end:
        matrix, _ = fpfh_ransac(left, model, voxel)
        pose = _pose(matrix)
        on = np.abs(relate(pose.to_body(np.asarray(left.points)), unit).distance) < voxel
        if on.sum() < 30:
            failures += 1
            continue
        failures = 0
        poses.append(pose)
        left = left.select_by_index(np.flatnonzero(on), invert=True)
    return poses


def fpfh_with_true_segments(cloud: EpochCloud, unit: UnitType) -> list[Pose]:
    """The same when each unit's points are handed over separately."""
    import open3d as o3d

    o3d.utility.random.seed(1)
    voxel = 0.03 * unit.height
    model = model_cloud(unit).voxel_down_sample(voxel)
    owner, _ = true_owner(cloud.points, cloud.truth, unit, 0.03 * unit.height)
    poses = []
    for k in range(len(cloud.truth)):
        own = cloud.points[owner == k]
        if len(own) >= 50:
            poses.append(_pose(fpfh_ransac(with_normals(own, voxel), model, voxel)[0]))
    return poses


def true_owner(
    points: FloatArray, truth: tuple[TrueUnit, ...], unit: UnitType, tolerance: float
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Index of the true unit whose surface a point lies on (-1 for none), and the leg."""
    owner = np.full(len(points), -1)
    leg = np.full(len(points), -1)
    best = np.full(len(points), tolerance)
    for k, true in enumerate(truth):
        near = np.flatnonzero(np.linalg.norm(points - true.pose.centre, axis=1) < 0.75 * unit.height)
        relation = relate(true.pose.to_body(points[near]), unit)
        closer = np.abs(relation.distance) < best[near]
        owner[near[closer]], leg[near[closer]] = k, relation.leg[closer]
        best[near[closer]] = np.abs(relation.distance[closer])
    return owner, leg


@dataclass(frozen=True)
class ConeLegs:
    """What CloudCompare's cones say about legs: it builds no units.

    Attributes
    ----------
    cones
        Number of cones.
    legs_found
        (n,) legs of each true unit that some cone covers: at least 60 % of the cone on the leg, and 30 % of the leg's points.
    angles_deg
        Half opening angles of the cones (a tetrapod's leg has 10 degrees).
    """

    cones: int
    legs_found: NDArray[np.int64]
    angles_deg: FloatArray


def cloudcompare_cones(cloud: EpochCloud, unit: UnitType) -> ConeLegs:
    """``CloudCompare -RANSAC`` with cones only, tolerances in proportion to the unit."""
    import open3d as o3d

    program = shutil.which("CloudCompare")
    if program is None:
        raise RuntimeError("CloudCompare is not installed (Debian package cloudcompare, with xvfb)")
    h = unit.height
    scene = with_normals(cloud.points, VOXEL * h)
    points = np.asarray(scene.points)
    owner, leg = true_owner(points, cloud.truth, unit, 0.03 * h)
    sizes = np.zeros((len(cloud.truth), 4))
    np.add.at(sizes, (owner[owner >= 0], leg[owner >= 0]), 1)
    found = np.zeros((len(cloud.truth), 4), dtype=bool)
    angles = []
    with tempfile.TemporaryDirectory() as folder:
        o3d.io.write_point_cloud(f"{folder}/scene.ply", scene)
        command = [
            "xvfb-run",
            "-a",
            program,
            "-SILENT",
            "-AUTO_SAVE",
            "OFF",
            "-C_EXPORT_FMT",
            "ASC",
            "-PREC",
            "6",
            "-O",
            f"{folder}/scene.ply",
        ]
        command += ["-RANSAC", "EPSILON_ABSOLUTE", f"{0.015 * h}", "BITMAP_EPSILON_ABSOLUTE", f"{0.05 * h}", "SUPPORT_POINTS", "60"]
        command += [
            "MAX_NORMAL_DEV",
            "20",
            "PROBABILITY",
            "0.01",
            "OUT_CLOUD_DIR",
            folder,
            "OUTPUT_INDIVIDUAL_SUBCLOUDS",
            "ENABLE_PRIMITIVE",
            "CONE",
        ]
        run = subprocess.run(command, capture_output=True, text=True, timeout=1800, check=False)
        files = sorted(p for p in Path(folder).glob("*.asc"))
        if not files:
            raise RuntimeError(f"CloudCompare wrote no cones: {run.stdout[-500:]} {run.stderr[-500:]}")
        for file in files:
            cone = np.loadtxt(file, ndmin=2)[:, :3]
            angle = re.search(r"alpha=(-?[\d.]+)", file.name)
            if angle:
                angles.append(float(angle[1]))
            on, which = true_owner(cone, cloud.truth, unit, 0.03 * h)
            counts = np.zeros_like(sizes)
            np.add.at(counts, (on[on >= 0], which[on >= 0]), 1)
            k = np.unravel_index(int(np.argmax(counts)), counts.shape)
            if counts[k] >= 0.6 * len(cone) and counts[k] >= 0.3 * sizes[k]:
                found[k] = True
    return ConeLegs(len(files), found.sum(axis=1), np.array(angles))
