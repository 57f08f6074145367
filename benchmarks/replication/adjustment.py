"""Speed and accuracy of the adjustment beside other ways to fit the same points.

    python benchmarks/replication/adjustment.py [--fits 200] [--points 1500] [--noise 0.02] [--json FILE]

All start from the same poses (5 % of H and 3 degrees off) and see the same points, normal noise on the lateral surfaces of a unit of 2.3 m:

- ours, legs found by the adjustment, robust, with covariance (what the product runs), and ours with the legs given and nothing robust;
- SciPy ``least_squares`` on orthogonal distances: legs found in every evaluation with a robust loss (the same work), and legs given with a
  linear loss; both with the numerical Jacobian, the latter also with an analytical one;
- one Gauss-Newton step on the algebraic condition x^2 + y^2 - (r - c z)^2 at the observations, legs given;
- Open3D point-to-plane ICP of the points on a model cloud (20 000 points) of the nominal shape, which has the true shape here.

Time is processor time of one thread. The methods take turns, 20 units each, so that all see the same load on the machine.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation
from tetratrack.benchmarks.replication.paper import FIELD_UNIT, bound, design, random_pose, rough_start
from tetratrack.core.adjustment.adjustment_records import AdjustmentOptions
from tetratrack.core.adjustment.gauss_helmert import adjust
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface

FloatArray = np.ndarray
UNIT = FIELD_UNIT
BLOCK = 20
"""Fits that a method makes one after another before the next method has its turn, as a survey's units are fitted."""
Fit = Callable[[FloatArray, FloatArray, Pose, float], FloatArray]
"""Points, legs, start and noise to (8,) parameters: centre, rotation vector from the start, radius, gradient."""


def _parameters(pose: Pose, radius: float, gradient: float, start: Pose) -> FloatArray:
    turn = Rotation.from_matrix(pose.rotation @ start.rotation.T).as_rotvec()
    return np.concatenate([pose.centre, turn, [radius, gradient]])


def ours(options: AdjustmentOptions, *, given: bool) -> Fit:
    def fit(points: FloatArray, legs: FloatArray, start: Pose, noise: float) -> FloatArray:
        result = adjust(points, UNIT, start, options=options, legs=legs if given else None)
        return _parameters(result.pose, result.radius, result.gradient, start)

    return fit


def _lateral(x: FloatArray, points: FloatArray, legs: FloatArray, start: Pose) -> tuple[FloatArray, FloatArray]:
    """Distances to the cones of known legs, and the points in the body frame."""
    body = (points - x[:3]) @ (Rotation.from_rotvec(x[3:6]).as_matrix() @ start.rotation)
    axes = UNIT.leg_directions[legs]
    axial = np.einsum("ij,ij->i", body, axes)
    rho = np.sqrt(np.maximum(np.einsum("ij,ij->i", body, body) - axial**2, 0))
    return (rho - x[6] + x[7] * axial) / math.hypot(1, x[7]), body


def scipy_found(points: FloatArray, legs: FloatArray, start: Pose, noise: float) -> FloatArray:
    def distances(x: FloatArray) -> FloatArray:
        pose = start.perturbed(np.zeros(3), x[3:6])
        body = (points - x[:3]) @ pose.rotation
        nearest = np.argmax(body @ UNIT.leg_directions.T, axis=1)
        return _lateral(x, points, nearest, start)[0]

    first = np.concatenate([start.centre, np.zeros(3), [UNIT.radius, UNIT.gradient]])
    return least_squares(distances, first, loss="soft_l1", f_scale=2 * noise, x_scale="jac").x


def scipy_given(*, analytical: bool) -> Fit:
    def fit(points: FloatArray, legs: FloatArray, start: Pose, noise: float) -> FloatArray:
        def distances(x: FloatArray) -> FloatArray:
            return _lateral(x, points, legs, start)[0]

        def jacobian(x: FloatArray) -> FloatArray:
            pose = start.perturbed(x[:3] - start.centre, x[3:6])
            shaped = UNIT.with_shape(x[6], x[7])
            body = pose.to_body(points)
            rows = design(body, legs, shaped, pose)
            # from a turn on the left to the rotation vector: the left Jacobian of SO(3)
            angle = np.linalg.norm(x[3:6])
            cross = np.cross(np.eye(3), x[3:6])
            if angle > 1e-8:
                left = np.eye(3) + (1 - math.cos(angle)) / angle**2 * -cross + (angle - math.sin(angle)) / angle**3 * cross @ cross
            else:
                left = np.eye(3) - 0.5 * cross
            rows[:, 3:6] = rows[:, 3:6] @ left
            return rows

        first = np.concatenate([start.centre, np.zeros(3), [UNIT.radius, UNIT.gradient]])
        return least_squares(distances, first, jac=jacobian if analytical else "2-point", method="lm", x_scale="jac").x

    return fit


def algebraic(points: FloatArray, legs: FloatArray, start: Pose, noise: float) -> FloatArray:
    first = np.concatenate([start.centre, np.zeros(3), [UNIT.radius, UNIT.gradient]])

    def condition(x: FloatArray) -> FloatArray:
        _, body = _lateral(x, points, legs, start)
        axial = np.einsum("ij,ij->i", body, UNIT.leg_directions[legs])
        return np.einsum("ij,ij->i", body, body) - axial**2 - (x[6] - x[7] * axial) ** 2

    value = condition(first)
    steps = np.full(8, 1e-6)
    matrix = np.column_stack([(condition(first + steps * np.eye(8)[k]) - value) / steps[k] for k in range(8)])
    return first - np.linalg.lstsq(matrix, value, rcond=None)[0]


def icp() -> Fit:
    import open3d as o3d

    body, normals, _ = sample_surface(UNIT, 20000, np.random.default_rng(0), end_discs=False)
    target = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(body))
    target.normals = o3d.utility.Vector3dVector(normals)
    registration = o3d.pipelines.registration

    def fit(points: FloatArray, legs: FloatArray, start: Pose, noise: float) -> FloatArray:
        source = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(start.to_body(points)))
        result = registration.registration_icp(
            source, target, 0.15 * UNIT.height, np.eye(4), registration.TransformationEstimationPointToPlane(),
            registration.ICPConvergenceCriteria(1e-9, 1e-9, 100),
        )  # fmt: skip
        turn, shift = result.transformation[:3, :3], result.transformation[:3, 3]
        rotation = start.rotation @ turn.T
        return _parameters(Pose(start.centre - rotation @ shift, rotation), UNIT.radius, UNIT.gradient, start)

    return fit


def _case(rng: np.random.Generator, count: int, noise: float) -> tuple[Pose, FloatArray, FloatArray, FloatArray, Pose]:
    """True pose, exact and noisy points, their legs, and the start."""
    pose = random_pose(rng)
    body, _, legs = sample_surface(UNIT, count, rng, end_discs=False)
    exact = pose.to_frame(body)
    return pose, exact, exact + rng.normal(0, noise, body.shape), legs, rough_start(pose, UNIT, rng)


def run(fits: int, count: int, noise: float) -> dict[str, Any]:
    methods: dict[str, Fit] = {
        "ours, legs found, robust": ours(AdjustmentOptions.ideal(), given=False),
        "ours, legs given": ours(AdjustmentOptions.ideal(robust=False), given=True),
        "scipy, legs found, robust": scipy_found,
        "scipy, legs given": scipy_given(analytical=False),
        "scipy, legs given, analytical Jacobian": scipy_given(analytical=True),
        "one algebraic step, legs given": algebraic,
        "open3d ICP on the model": icp(),
    }
    seconds = dict.fromkeys(methods, 0.0)
    errors: dict[str, list[FloatArray]] = {name: [] for name in methods}
    bounds = []
    rng = np.random.default_rng(15)
    # compiling and loading are not part of the work; what only some units need is met within so many
    for _ in range(BLOCK):
        _, _, points, legs, start = _case(rng, count, noise)
        for method in methods.values():
            method(points, legs, start, noise)
    for first in range(0, fits, BLOCK):
        cases = [_case(rng, count, noise) for _ in range(min(BLOCK, fits - first))]
        bounds += [np.diag(bound(pose.to_body(exact), legs, UNIT, pose, noise)) for pose, exact, _, legs, _ in cases]
        for name, method in methods.items():
            clock = time.process_time()
            found = [method(points, legs, start, noise) for _, _, points, legs, start in cases]
            seconds[name] += time.process_time() - clock
            for x, (pose, _, _, _, start) in zip(found, cases, strict=True):
                fitted = start.perturbed(x[:3] - start.centre, x[3:6])
                turned = Rotation.from_matrix(fitted.rotation @ pose.rotation.T).as_rotvec()
                errors[name].append(np.concatenate([fitted.centre - pose.centre, turned, [x[6] - UNIT.radius, x[7] - UNIT.gradient]]))
    report = {}
    for name in methods:
        e = np.array(errors[name])
        report[name] = {
            "fits_per_second": fits / seconds[name],
            "rmse_centre_mm": 1e3 * float(np.sqrt(np.mean(np.sum(e[:, :3] ** 2, axis=1)))),
            "rmse_rotation_deg": math.degrees(float(np.sqrt(np.mean(np.sum(e[:, 3:6] ** 2, axis=1))))),
            "rmse_radius_mm": 1e3 * float(np.sqrt(np.mean(e[:, 6] ** 2))),
            "rmse_over_bound": float(np.sqrt(np.mean(e[:, :6] ** 2 / np.array(bounds)[:, :6]))),
        }
    return report


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fits", type=int, default=200)
    parser.add_argument("--points", type=int, default=1500)
    parser.add_argument("--noise", type=float, default=0.02, help="standard deviation, metres")
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    report = run(arguments.fits, arguments.points, arguments.noise)
    print("| method | fits/s | RMSE / bound (pose) | centre mm | rotation ° | radius mm |\n|---|---|---|---|---|---|")
    for name, row in report.items():
        print(
            f"| {name} | {row['fits_per_second']:.0f} | {row['rmse_over_bound']:.3f} | {row['rmse_centre_mm']:.2f} "
            f"| {row['rmse_rotation_deg']:.3f} | {row['rmse_radius_mm']:.2f} |"
        )
    if arguments.json:
        arguments.json.write_text(json.dumps(report, indent=1))


if __name__ == "__main__":
    main()
