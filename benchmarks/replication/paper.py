"""The paper's experiments again (Figs. 8, 9, 11-14, Table 1), beside the Cramer-Rao bound, and what it leaves to future work.

    python benchmarks/replication/paper.py [--seeds 20] [--json FILE] [--images docs/images] [--lab ../shared/data/lab_table]
    python benchmarks/replication/paper.py --known-labels 100

Each noise level: fifty interlocked units, 2000 points each on the lateral surfaces, uniform noise of every coordinate, starts 5 % of the
height and 3 degrees off. Errors are given twice: of a single unit (root mean square, over the bound of its points) and, as the paper
can only have meant it, of the mean over the fifty units. Tables go to standard output as Markdown. The second form makes the fits with
known labels alone, from so many sets that chance and inefficiency can be told apart, and gives every parameter with its standard error.
"""

from __future__ import annotations

import argparse
import csv
import json
import math
import tomllib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation
from scipy.stats import chi2
from tetratrack.benchmarks.replication.literal_model import fit_literal, literal_axes
from tetratrack.core.adjustment.adjustment_records import Adjustment, AdjustmentOptions
from tetratrack.core.adjustment.gauss_helmert import adjust
from tetratrack.core.data.trajectory import beam_covariances
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import RADIUS_RATIO, UnitType
from tetratrack.core.simulation.sampled_unit import interlocked_poses, interlocked_rows, single_unit

FloatArray = np.ndarray
NOISES = (0.01, 0.05, 0.10, 0.20)
PAPER = {0.20: (1.7, 0.2, 6.0), 0.10: (1.0, 0.05, None)}
"""Translation mm, rotation degrees, radius mm of section 4.1, at the noise levels at which the text names them."""
UNIT = UnitType.tetrapod(1.0 / RADIUS_RATIO)
"""Radius 1 m, as in the paper."""
FIELD_UNIT = UnitType.tetrapod(2.3)
NAMES = ("e", "n", "h", "rot e", "rot n", "rot h", "r", "c")
POINTS = 2000


def design(body: FloatArray, leg: FloatArray, unit: UnitType, pose: Pose) -> FloatArray:
    """(n, 8) derivatives of the exact points' distances: what the bound is made of."""
    axes = unit.leg_directions[leg]
    axial = np.sum(body * axes, axis=1)
    across = body - axial[:, None] * axes
    radial = across / np.linalg.norm(across, axis=1, keepdims=True)
    cosine = 1 / math.hypot(1, unit.gradient)
    normal = (radial + unit.gradient * axes) * cosine
    return np.hstack(
        [
            -normal @ pose.rotation.T,
            np.cross(normal, body) @ pose.rotation.T,
            np.full((len(body), 1), -cosine),
            (axial * cosine)[:, None],
        ]
    )


def bound(body: FloatArray, leg: FloatArray, unit: UnitType, pose: Pose, sigma: float | FloatArray, free: int = 8) -> FloatArray:
    """(free, free) Cramer-Rao bound (its Kanatani form for geometric fitting) of the first parameters.

    ``sigma`` is the noise of every point, or (n, 3, 3) covariances of the points in the frame of the pose.
    """
    rows = design(body, leg, unit, pose)[:, :free]
    if isinstance(sigma, np.ndarray):
        # the first three derivatives are the outward normal, turned round
        rows = rows / np.sqrt(np.einsum("ij,ijk,ik->i", rows[:, :3], sigma, rows[:, :3]))[:, None]
        return np.linalg.inv(rows.T @ rows)
    return np.linalg.inv(rows.T @ rows) * sigma**2


def errors_of(result: Adjustment, pose: Pose, unit: UnitType) -> FloatArray:
    turn = Rotation.from_matrix(result.pose.rotation @ pose.rotation.T).as_rotvec()
    return np.concatenate([result.pose.centre - pose.centre, turn, [result.radius - unit.radius, result.gradient - unit.gradient]])


def rough_start(pose: Pose, unit: UnitType, rng: np.random.Generator) -> Pose:
    turn, shift = rng.normal(size=3), rng.normal(size=3)
    return pose.perturbed(0.05 * unit.height * shift / np.linalg.norm(shift), math.radians(3) * turn / np.linalg.norm(turn))


def mahalanobis(error: FloatArray, covariance: FloatArray) -> float:
    free = np.diag(covariance) > 0
    return float(error[free] @ np.linalg.solve(covariance[np.ix_(free, free)], error[free]))


class Tally:
    """Errors of many fits with their bounds and reported covariances."""

    def __init__(self) -> None:
        self.errors: list[FloatArray] = []
        self.bounds: list[FloatArray] = []
        self.reported: list[FloatArray] = []
        self.distances: list[float] = []

    def add(self, error: FloatArray, sharpest: FloatArray, covariance: FloatArray) -> None:
        self.errors.append(error)
        self.bounds.append(np.diag(sharpest))
        self.reported.append(np.diag(covariance))
        self.distances.append(mahalanobis(error, covariance))

    def summary(self) -> dict[str, Any]:
        errors, bounds = np.array(self.errors), np.array(self.bounds)
        free = bounds.shape[1]
        scaled = errors[:, :free] / np.sqrt(bounds)
        freedom = int(np.sum(np.array(self.reported[0]) > 0))
        return {
            "fits": len(errors),
            "bias_over_bound": scaled.mean(axis=0).round(3).tolist(),
            "rmse_over_bound": np.sqrt((scaled**2).mean(axis=0)).round(3).tolist(),
            "reported_over_bound": np.sqrt((np.array(self.reported)[:, :free] / bounds).mean(axis=0)).round(3).tolist(),
            "coverage_95": round(float(np.mean(np.array(self.distances) < chi2.ppf(0.95, freedom))), 4),
            "mean_mahalanobis_over_freedom": round(float(np.mean(self.distances)) / freedom, 3),
            "rmse_centre_mm": round(1e3 * float(np.sqrt(np.mean(np.sum(errors[:, :3] ** 2, axis=1)))), 3),
            "rmse_rotation_deg": round(math.degrees(float(np.sqrt(np.mean(np.sum(errors[:, 3:6] ** 2, axis=1))))), 4),
            "bias_radius_mm": round(1e3 * float(errors[:, 6].mean()), 3) if errors.shape[1] > 6 else None,
        }

    def per_set(self, size: int) -> tuple[float, float, float]:
        """Mean over sets of ``size`` units of the size of the mean error: translation mm, rotation degrees, radius mm."""
        errors = np.array(self.errors)
        means = errors.reshape(-1, size, errors.shape[1]).mean(axis=1)
        return (
            1e3 * float(np.mean(np.linalg.norm(means[:, :3], axis=1))),
            math.degrees(float(np.mean(np.linalg.norm(means[:, 3:6], axis=1)))),
            1e3 * float(np.mean(np.abs(means[:, 6]))),
        )


def _expected_of_set(sharpest: FloatArray, size: int) -> tuple[float, float, float]:
    """What :meth:`Tally.per_set` would give for estimates at the bound."""
    means = np.random.default_rng(0).normal(size=(20000, 8)) @ np.linalg.cholesky(sharpest / size).T
    return (
        1e3 * float(np.mean(np.linalg.norm(means[:, :3], axis=1))),
        math.degrees(float(np.mean(np.linalg.norm(means[:, 3:6], axis=1)))),
        1e3 * float(np.mean(np.abs(means[:, 6]))),
    )


VARIANTS: dict[str, tuple[AdjustmentOptions, bool]] = {
    "labels given": (AdjustmentOptions.ideal(), True),
    "labels found": (AdjustmentOptions.ideal(), False),
    "plain least squares": (AdjustmentOptions.ideal(robust=False, bias_correction=False), True),
}


def noise_levels(seeds: int, variants: Sequence[str] = tuple(VARIANTS)) -> dict[str, Any]:
    """Figs. 11-13: the rigid model on fifty interlocked units, by noise."""
    result: dict[str, Any] = {}
    for noise in NOISES:
        tallies = {name: Tally() for name in variants}
        sharpest_sum = np.zeros((8, 8))
        for seed in range(seeds):
            rng = np.random.default_rng([1, seed])
            cloud = interlocked_rows(UNIT, 0.0, rng, count=POINTS)
            noisy = cloud.points + rng.uniform(-noise, noise, cloud.points.shape)
            for k, pose in enumerate(cloud.poses):
                own = cloud.unit_index == k
                leg = cloud.leg[own]
                sharpest = bound(pose.to_body(cloud.points[own]), leg, UNIT, pose, noise / math.sqrt(3))
                start = rough_start(pose, UNIT, rng)
                for name in variants:
                    options, given = VARIANTS[name]
                    fit = adjust(noisy[own], UNIT, start, options=options, legs=leg if given else None)
                    tallies[name].add(errors_of(fit, pose, UNIT), sharpest, fit.covariance)
                sharpest_sum += sharpest
        result[f"{noise:.2f}"] = {name: tally.summary() | {"per_set": tally.per_set(50)} for name, tally in tallies.items()}
        result[f"{noise:.2f}"]["bound"] = {"per_set": _expected_of_set(sharpest_sum / (50 * seeds), 50)}
    return result


def literal_levels(seeds: int) -> dict[str, Any]:
    """Figs. 11-13 with the printed model: upright units of the 120-degree solid, labels given, bias left in."""
    solid = UnitType.tetrapod(UNIT.height, opening="paper")
    result: dict[str, Any] = {}
    for noise in NOISES:
        sets = []
        for seed in range(seeds):
            rng = np.random.default_rng([2, seed])
            errors = []
            for _ in range(50):
                psi = rng.uniform(-math.pi, math.pi)
                points, legs = literal_points(solid, 0.0, psi, POINTS, rng)
                noisy = points + rng.uniform(-noise, noise, points.shape)
                fit = fit_literal(noisy, solid, rng.normal(0, 0.03, 3), 0.03, psi + 0.03, legs=legs)
                errors.append([*fit.centre, fit.omega, fit.psi - psi, fit.radius - solid.radius])
            sets.append(np.mean(errors, axis=0))
        means = np.array(sets)
        result[f"{noise:.2f}"] = {
            "per_set": (
                1e3 * float(np.mean(np.linalg.norm(means[:, :3], axis=1))),
                math.degrees(float(np.mean(np.linalg.norm(means[:, 3:5], axis=1)))),
                1e3 * float(np.mean(np.abs(means[:, 5]))),
            )
        }
    return result


def literal_points(solid: UnitType, omega: float, psi: float, count: int, rng: np.random.Generator) -> tuple[FloatArray, FloatArray]:
    """Points on the lateral surfaces of the printed model (eqs. 5-7), outside the other legs."""
    axes = literal_axes(omega, psi)
    leg = rng.integers(0, 4, 3 * count)
    rho = np.sqrt(solid.radius**2 + rng.random(3 * count) * (solid.end_radius**2 - solid.radius**2))
    azimuth = rng.uniform(0, 2 * math.pi, 3 * count)
    axis = axes[leg]
    first = np.cross(axis, [0.31, 0.52, 0.79])
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second = np.cross(axis, first)
    points = ((solid.radius - rho) / solid.gradient)[:, None] * axis
    points += rho[:, None] * (np.cos(azimuth)[:, None] * first + np.sin(azimuth)[:, None] * second)
    outside = np.argmax(points @ axes.T, axis=1) == leg
    return points[outside][:count], leg[outside][:count]


def random_pose(rng: np.random.Generator) -> Pose:
    return Pose(rng.normal(size=3), Rotation.random(random_state=rng).as_matrix())


def two_legs(cases: int) -> dict[str, Any]:
    """Fig. 14: two visible legs, started 15 degrees and 0.15 H away."""
    result: dict[str, Any] = {}
    for name, options in {
        "shape fixed": AdjustmentOptions.ideal(radius_sd=0.0, gradient_sd=0.0),
        "shape free": AdjustmentOptions.ideal(),
    }.items():
        rng = np.random.default_rng(14)
        tally, converged = Tally(), 0
        free = 6 if name == "shape fixed" else 8
        for _ in range(cases):
            pose = random_pose(rng)
            body, _, leg = sample_surface(FIELD_UNIT, POINTS, rng, end_discs=False)
            seen = np.isin(leg, rng.permutation(4)[:2])
            shift, turn = rng.normal(size=3), rng.normal(size=3)
            start = pose.perturbed(0.15 * FIELD_UNIT.height * shift / np.linalg.norm(shift), math.radians(15) * turn / np.linalg.norm(turn))
            noisy = pose.to_frame(body[seen]) + rng.normal(0, 0.02, (seen.sum(), 3))
            fit = adjust(noisy, FIELD_UNIT, start, options=options)
            error = errors_of(fit, pose, FIELD_UNIT)
            sharpest = bound(body[seen], leg[seen], FIELD_UNIT, pose, 0.02, free)
            if np.all(np.abs(error[:free]) < 6 * np.sqrt(np.diag(sharpest))):
                converged += 1
                tally.add(error, sharpest, fit.covariance)
        result[name] = tally.summary() | {"cases": cases, "converged": converged / cases}
    return result


def rough_field(points: FloatArray, sd: float, length: float, rng: np.random.Generator) -> FloatArray:
    """(n,) correlated roughness, covariance sd^2 exp(-h^2 / 2 length^2)."""
    waves = rng.normal(size=(400, 3)) / length
    return sd * math.sqrt(2 / 400) * np.cos(points @ waves.T + rng.uniform(0, 2 * math.pi, 400)).sum(axis=1)


Disturbance = Callable[[FloatArray, FloatArray, FloatArray, np.random.Generator], FloatArray]


def study(
    fits: int,
    count: int,
    sigma: float,
    disturb: Disturbance,
    *,
    options: AdjustmentOptions,
    unit: UnitType = FIELD_UNIT,
    parameters: int = 8,
) -> dict[str, Any]:
    """Fits of single units with noise sigma plus a disturbance, which gets body points, normals and legs and returns all points.

    ``parameters`` 6 judges the pose alone, where the unit's own size is not the nominal one.
    """
    rng = np.random.default_rng(5)
    tally = Tally()
    for _ in range(fits):
        pose = random_pose(rng)
        body, normals, leg = sample_surface(unit, count, rng, end_discs=False)
        sharpest = bound(body, leg, unit, pose, sigma)
        moved = disturb(body + rng.normal(0, sigma, body.shape), normals, leg, rng)
        fit = adjust(pose.to_frame(moved), unit, rough_start(pose, unit, rng), options=options)
        tally.add(errors_of(fit, pose, unit)[:parameters], sharpest[:parameters, :parameters], fit.covariance[:parameters, :parameters])
    return tally.summary()


def gross(share: float, kind: str) -> Disturbance:
    """Add bad points until they are ``share`` of all: a neighbour, rock, growth of 10 to 20 cm, or points anywhere."""

    def disturb(body: FloatArray, normals: FloatArray, leg: FloatArray, rng: np.random.Generator) -> FloatArray:
        from tetratrack.core.model.tetrapod import relate

        count = int(len(body) * share / (1 - share))
        if kind == "neighbour":
            other = random_pose(rng)
            surface, _, _ = sample_surface(FIELD_UNIT, 8 * count, rng)
            bad = surface @ other.rotation.T - 1.0 * FIELD_UNIT.height * FIELD_UNIT.leg_directions[rng.integers(4)]
            bad = bad[np.argsort(np.linalg.norm(bad, axis=1))[: 2 * count]]
        elif kind == "rock":
            toward = rng.normal(size=3)
            toward /= np.linalg.norm(toward)
            spread = rng.normal(0, 0.3 * FIELD_UNIT.height, (2 * count, 3))
            # a slope of rock on which the unit rests
            plane = np.max(body @ toward) * toward + spread - np.outer(spread @ toward, toward)
            bad = plane + np.abs(rng.normal(0, 0.05, (2 * count, 1))) * toward
        elif kind == "growth":
            near = np.argsort(np.linalg.norm(body - body[rng.integers(len(body))], axis=1))[:count]
            bad = body[near] + normals[near] * rng.uniform(0.1, 0.2, (count, 1))
        else:
            bad = rng.uniform(-0.6, 0.6, (count, 3)) * FIELD_UNIT.height
        if kind in ("neighbour", "rock"):
            bad = bad[relate(bad, FIELD_UNIT).distance > 0][:count]
        return np.vstack([body, bad])

    return disturb


def future_work(fits: int) -> dict[str, Any]:
    """Roughness, bad points, density, share visible, strip offset, size tolerance."""
    ideal = AdjustmentOptions.ideal()

    def nothing(body: FloatArray, normals: FloatArray, leg: FloatArray, rng: np.random.Generator) -> FloatArray:
        return body

    def rough(body: FloatArray, normals: FloatArray, leg: FloatArray, rng: np.random.Generator) -> FloatArray:
        return body + normals * rough_field(body, 0.005, 0.10, rng)[:, None]

    result: dict[str, Any] = {
        "white noise 2 cm": study(2 * fits, POINTS, 0.02, nothing, options=ideal),
        "roughness 5 mm / 10 cm, noise 5 mm": study(5 * fits, POINTS, 0.005, rough, options=ideal),
        "roughness 5 mm / 10 cm, noise 2 cm": study(5 * fits, POINTS, 0.02, rough, options=ideal),
    }
    for kind in ("neighbour", "rock", "growth", "anywhere"):
        result[f"30 % bad points: {kind}"] = study(fits, 1400, 0.02, gross(0.3, kind), options=ideal)
    # as the product fits real units
    result["30 % bad points: rock, tips and edges left out"] = study(fits, 1400, 0.02, gross(0.3, "rock"), options=AdjustmentOptions())
    result["density"] = {str(n): study(fits, n, 0.02, nothing, options=ideal) for n in (100, 200, 500, 1000, 2000, 5000)}
    held = AdjustmentOptions.ideal(radius_sd=0.0, gradient_sd=0.0)
    result["2 cm along the beam, 3 mm across, weighted"] = {
        "by beam": _beams(fits, weighted=True),
        "equally": _beams(fits, weighted=False),
    }
    result["visible"] = {f"{share:.2f}": _visible(fits, share, held) for share in (0.05, 0.1, 0.2, 0.3, 0.5)}

    def strips(offset: float) -> Disturbance:
        def disturb(body: FloatArray, normals: FloatArray, leg: FloatArray, rng: np.random.Generator) -> FloatArray:
            direction = rng.normal(size=3)
            # a strip sees one side: where its direction leaves the surface outwards
            side = normals @ rng.normal(size=3) > 0
            return body + np.where(side[:, None], offset * direction / np.linalg.norm(direction), 0.0)

        return disturb

    result["strip offset"] = {f"{1000 * d:.0f} mm": study(fits, POINTS, 0.02, strips(d), options=ideal) for d in (0.0, 0.005, 0.01, 0.02)}

    def swollen(sd: float) -> Disturbance:
        return lambda body, normals, leg, rng: body * (1 + rng.normal(0, sd))

    result["size tolerance, shape held"] = {
        f"{100 * sd:.1f} %": study(fits, POINTS, 0.02, swollen(sd), options=held, parameters=6) for sd in (0.0, 0.003, 0.01)
    }
    result["size tolerance, prior 0.3 %"] = {
        f"{100 * sd:.1f} %": study(
            fits,
            POINTS,
            0.02,
            swollen(sd),
            options=AdjustmentOptions.ideal(radius_sd=0.003 * FIELD_UNIT.radius, gradient_sd=0.002),
            parameters=6,
        )
        for sd in (0.0, 0.003, 0.01)
    }
    return result


def _visible(fits: int, share: float, options: AdjustmentOptions) -> dict[str, Any]:
    """Units of which the part facing a viewer is seen, shape known."""
    rng = np.random.default_rng(9)
    tally, lost = Tally(), 0
    for _ in range(fits):
        pose = random_pose(rng)
        body, normals, leg = sample_surface(FIELD_UNIT, 6000, rng, end_discs=False)
        viewer = rng.normal(size=3)
        viewer /= np.linalg.norm(viewer)
        facing = normals @ viewer + 0.3 * (body @ viewer) / FIELD_UNIT.leg_length
        seen = np.argsort(-facing)[: int(share * 6000)]
        noisy = pose.to_frame(body[seen]) + rng.normal(0, 0.02, (len(seen), 3))
        fit = adjust(noisy, FIELD_UNIT, rough_start(pose, FIELD_UNIT, rng), options=options)
        if len(fit.undetermined):
            lost += 1
            continue
        tally.add(errors_of(fit, pose, FIELD_UNIT), bound(body[seen], leg[seen], FIELD_UNIT, pose, 0.02, 6), fit.covariance)
    return tally.summary() | {"stated as undetermined": lost}


def _beams(fits: int, *, weighted: bool) -> dict[str, Any]:
    """Units seen from one place 10 m away with noise of 2 cm along the beam and 3 mm across, shape known."""
    rng = np.random.default_rng(21)
    tally = Tally()
    for _ in range(fits):
        pose = random_pose(rng)
        body, normals, leg = sample_surface(FIELD_UNIT, 2 * POINTS, rng, end_discs=False)
        exact = pose.to_frame(body)
        sensor = np.array([4.0, -8.0, 6.0])
        seen = np.einsum("ij,ij->i", normals @ pose.rotation.T, sensor - exact) > 0.05 * np.linalg.norm(sensor - exact, axis=1)
        covariances = beam_covariances(exact[seen], sensor, 0.02, 0.0003)
        noise = np.einsum("ijk,ik->ij", np.linalg.cholesky(covariances), rng.normal(size=(seen.sum(), 3)))
        noisy = exact[seen] + noise
        fit = adjust(
            noisy, FIELD_UNIT, rough_start(pose, FIELD_UNIT, rng), options=AdjustmentOptions.ideal(radius_sd=0.0, gradient_sd=0.0),
            covariances=beam_covariances(noisy, sensor, 0.02, 0.0003) if weighted else None,
        )  # fmt: skip
        tally.add(errors_of(fit, pose, FIELD_UNIT), bound(body[seen], leg[seen], FIELD_UNIT, pose, covariances, 6), fit.covariance)
    return tally.summary()


def table_1(folder: Path) -> list[dict[str, Any]]:
    """Table 1 on the sample survey of four models: displacement by fitting beside the total station, cm."""
    import laspy

    config = tomllib.loads((folder / "survey.toml").read_text())
    keys = config["unit"]
    unit = UnitType.tetrapod(keys["height"], radius=keys["radius"], gradient=keys["gradient"], leg_length=keys["leg_length"])
    found: list[dict[str, tuple[Pose, UnitType]]] = []
    for epoch in config["epoch"]:
        turn, origin, shift = _rigid(
            _table(folder / epoch["targets"], "x", "y", "z"), _table(folder / epoch["control"], "easting", "northing", "height")
        )
        labels = np.load(folder / "truth" / f"labels_{epoch['label']}.npz")
        points, owner = [], []
        for tile in sorted(folder.glob(epoch["tiles"])):
            cloud = laspy.read(tile)
            points.append(np.column_stack([cloud.x, cloud.y, cloud.z]))
            owner.append(labels[tile.stem])
        cloud_points = (np.vstack(points) - origin) @ turn.T + shift
        numbers = np.concatenate(owner)
        fits = {}
        for row in csv.DictReader((folder / "truth" / "units.csv").open()):
            if row["epoch"] == epoch["label"]:
                truth = Pose.from_quaternion([float(row[k]) for k in "ENH"], [float(row[k]) for k in ("qx", "qy", "qz", "qw")])
                own = cloud_points[numbers == int(row["unit_id"][1:])] - truth.centre
                options = AdjustmentOptions(radius_sd=0.003 * unit.radius, gradient_sd=0.002)
                fit = adjust(own, unit, Pose(np.zeros(3), truth.rotation), options=options)
                fits[row["unit_id"]] = (fit.pose.shifted(truth.centre), fit.unit(unit))
        found.append(fits)
    from tetratrack.core.model.feature_points import feature_points

    rows = []
    checks = [_table(folder / epoch["check"], "easting", "northing", "height") for epoch in config["epoch"]]
    for point in checks[0].keys() & checks[1].keys():
        station = checks[1][point] - checks[0][point]
        candidates = []
        for name in found[0]:
            before, after = (feature_points(*found[k][name]).positions for k in (0, 1))
            k = int(np.argmin(np.linalg.norm(before[1:] - checks[0][point], axis=1))) + 1
            candidates.append((float(np.linalg.norm(before[k] - checks[0][point])), name, after[k] - before[k]))
        _, name, fitted = min(candidates, key=lambda c: c[0])
        rows.append(
            {
                "point": point,
                "unit": name,
                "fitting_cm": 100 * float(np.linalg.norm(fitted)),
                "station_cm": 100 * float(np.linalg.norm(station)),
                "error_cm": 100 * float(np.linalg.norm(fitted) - np.linalg.norm(station)),
                "vector_error_cm": 100 * float(np.linalg.norm(fitted - station)),
            }
        )
    return sorted(rows, key=lambda row: row["point"])


def _table(path: Path, *columns: str) -> dict[str, FloatArray]:
    return {row["point_id"]: np.array([float(row[c]) for c in columns]) for row in csv.DictReader(path.open())}


def _rigid(measured: dict[str, FloatArray], surveyed: dict[str, FloatArray]) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Rotation, its origin and the shift from cloud to control, leaving out targets that were disturbed."""
    names = sorted(measured.keys() & surveyed.keys())
    while True:
        a, b = np.array([measured[n] for n in names]), np.array([surveyed[n] for n in names])
        turn = Rotation.align_vectors(b - b.mean(0), a - a.mean(0))[0].as_matrix()
        off = np.linalg.norm((a - a.mean(0)) @ turn.T + b.mean(0) - b, axis=1)
        if off.max() < 5 * np.median(off) or len(names) <= 4:
            return turn, a.mean(0), b.mean(0)
        del names[int(np.argmax(off))]


def pictures(folder: Path, results: dict[str, Any]) -> None:
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    folder.mkdir(parents=True, exist_ok=True)
    colours = np.array(["#1b6ca8", "#d1495b", "#2e8b57", "#edae49"])
    rng = np.random.default_rng(8)

    def cloud(
        path: str,
        points: FloatArray,
        colour: FloatArray,
        size: float,
        view: tuple[int, int],
        over: FloatArray | None = None,
        shape: tuple[float, float, float] = (7, 5.5, 1.0),
    ) -> None:
        figure = plt.figure(figsize=shape[:2])
        axes = figure.add_subplot(projection="3d")
        if over is not None:
            axes.scatter(*over.T, s=0.4, c="#b8bcc2", linewidths=0, depthshade=False, clip_on=False)
        axes.scatter(*points.T, s=size, c=colour, linewidths=0, depthshade=False, clip_on=False)
        axes.set_box_aspect(np.ptp(points if over is None else over, axis=0), zoom=shape[2])
        axes.view_init(*view)
        axes.set_xlabel("x (m)")
        axes.set_ylabel("y (m)")
        axes.set_zlabel("z (m)")
        figure.savefig(folder / path, dpi=130, bbox_inches="tight")
        plt.close(figure)

    one = single_unit(UNIT, 0.01, rng, count=12000)
    cloud("paper_fig08.png", one.points, colours[one.leg], 1.2, (20, 35))
    many = interlocked_rows(UNIT, 0.01, rng, count=1200)
    cloud("paper_fig09.png", many.points, colours[many.leg], 0.7, (32, 72), shape=(13, 6.5, 2.0))

    pose = interlocked_poses(FIELD_UNIT)[0]
    body, _, leg = sample_surface(FIELD_UNIT, 6000, rng, end_discs=False)
    seen = (leg < 2) & (rng.random(len(leg)) < 0.5)
    points = pose.to_frame(body[seen]) + rng.normal(0, 0.01, (seen.sum(), 3))
    fit = adjust(points, FIELD_UNIT, rough_start(pose, FIELD_UNIT, rng), options=AdjustmentOptions.ideal(radius_sd=0, gradient_sd=0))
    whole, _, _ = sample_surface(FIELD_UNIT, 20000, rng, end_discs=False)
    cloud("paper_fig14.png", points, np.array(["#d1495b"]), 2.5, (20, 35), over=fit.pose.to_frame(whole))

    levels = results["noise levels"]
    x = [100 * n for n in NOISES]
    for index, (name, axis_label) in enumerate(
        (("fig11", "translation error (mm)"), ("fig12", "rotation error (degrees)"), ("fig13", "radius error (mm)"))
    ):
        figure, axes = plt.subplots(figsize=(6.5, 4.2))
        for variant, style in (("labels found", "o-"), ("labels given", "s--"), ("plain least squares", "^-"), ("bound", "k:")):
            axes.plot(x, [levels[f"{n:.2f}"][variant]["per_set"][index] for n in NOISES], style, label=variant, markersize=4)
        axes.plot(x, [results["literal"][f"{n:.2f}"]["per_set"][index] for n in NOISES], "v-", label="printed model", markersize=4)
        named = [(100 * n, values[index]) for n, values in PAPER.items() if values[index] is not None]
        axes.plot(*zip(*named, strict=True), "*", color="#d1495b", markersize=11, label="paper's text")
        axes.set_xlabel("uniform noise ± (cm)")
        axes.set_ylabel(axis_label)
        axes.set_title("error of the mean over fifty units", fontsize=10)
        axes.legend(fontsize=8, frameon=False)
        axes.grid(alpha=0.3)
        figure.savefig(folder / f"paper_{name}.png", dpi=130, bbox_inches="tight")
        plt.close(figure)

    figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
    density = results["future work"]["density"]
    left.loglog([int(k) for k in density], [v["rmse_centre_mm"] for v in density.values()], "o-")
    left.set_xlabel("points on the unit")
    visible = results["future work"]["visible"]
    right.plot([100 * float(k) for k in visible], [v["rmse_centre_mm"] for v in visible.values()], "o-")
    right.set_yscale("log")
    for axis in (left.xaxis, left.yaxis, right.yaxis):
        axis.set_major_formatter("{x:g}")
    left.yaxis.set_minor_formatter("{x:g}")
    right.set_xlabel("share of the surface visible (%), shape known")
    for axes in (left, right):
        axes.set_ylabel("RMSE of the centre (mm), noise 2 cm")
        axes.grid(alpha=0.3, which="both")
    figure.savefig(folder / "paper_density_visible.png", dpi=130, bbox_inches="tight")
    plt.close(figure)


def print_tables(results: dict[str, Any]) -> None:
    print("| noise | variant | mean of 50: translation mm | rotation ° | radius mm | max bias / bound | max RMSE / bound | coverage |")
    print("|---|---|---|---|---|---|---|---|")
    for noise in NOISES:
        key = f"{noise:.2f}"
        text = PAPER.get(noise)
        if text:
            print(f"| ±{100 * noise:.0f} cm | paper's text | {text[0]} | {text[1]} | {text[2] or '-'} | | | |")
        entries = results["noise levels"][key] | {"printed model": results["literal"][key]}
        for name, entry in entries.items():
            t, w, r = entry["per_set"]
            more = (
                f"{np.max(np.abs(entry['bias_over_bound'])):.2f} | {np.max(entry['rmse_over_bound']):.3f} | {entry['coverage_95']:.3f}"
                if "coverage_95" in entry
                else " | | "
            )
            print(f"| ±{100 * noise:.0f} cm | {name} | {t:.3f} | {w:.4f} | {r:.3f} | {more} |")
    print("\n| case | fits | max RMSE / bound | reported / bound | coverage 95 % | RMSE centre mm | rotation ° |")
    print("|---|---|---|---|---|---|---|")
    cases = {f"two legs, {k} (converged {v['converged']:.3f})": v for k, v in results["two legs"].items()}
    for name, entry in results["future work"].items():
        cases |= {name: entry} if "fits" in entry else {f"{name} {k}": v for k, v in entry.items()}
    for name, entry in cases.items():
        print(
            f"| {name} | {entry['fits']} | {np.max(entry['rmse_over_bound']):.2f} | {np.max(entry['reported_over_bound']):.2f} "
            f"| {entry['coverage_95']:.3f} | {entry['rmse_centre_mm']:.2f} | {entry['rmse_rotation_deg']:.3f} |"
        )
    for row in results.get("table 1", []):
        print(" | ".join(f"{k} {v:.2f}" if isinstance(v, float) else str(v) for k, v in row.items()))


def print_known_labels(levels: dict[str, Any], sets: int) -> None:
    """Bias and root mean square error over the bound by parameter, in one table per kind, with the standard error of the figures."""
    count = 50 * sets
    for what, key, chance in (("bias", "bias_over_bound", 1 / math.sqrt(count)), ("RMSE", "rmse_over_bound", 1 / math.sqrt(2 * count))):
        print(f"| noise | {' | '.join(NAMES)} | all |\n|---|{'---|' * (len(NAMES) + 1)}")
        for noise, entry in levels.items():
            values = np.array(entry["labels given"][key])
            whole = math.sqrt(float(np.mean(values**2)))
            print(f"| ±{100 * float(noise):.0f} cm | {' | '.join(f'{v:.3f}' for v in values)} | {whole:.3f} |")
        print(f"\n{what} over the Cramer-Rao standard deviation, {count} fits a line, standard error of one figure {chance:.3f}\n")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=20, help="sets of fifty units per noise level")
    parser.add_argument("--two-legs", type=int, default=1000, help="cases of two visible legs")
    parser.add_argument("--fits", type=int, default=200, help="fits per further case")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--images", type=Path)
    parser.add_argument("--lab", type=Path, help="sample survey of four models with truth/")
    parser.add_argument("--known-labels", type=int, metavar="SEEDS", help="only the fits with known labels, from so many sets")
    arguments = parser.parse_args()
    if arguments.known_labels:
        print_known_labels(noise_levels(arguments.known_labels, ["labels given"]), arguments.known_labels)
        return
    results: dict[str, Any] = {
        "seeds": arguments.seeds,
        "noise levels": noise_levels(arguments.seeds),
        "literal": literal_levels(arguments.seeds),
        "two legs": two_legs(arguments.two_legs),
        "future work": future_work(arguments.fits),
    }
    if arguments.lab:
        results["table 1"] = table_1(arguments.lab)
    if arguments.json:
        arguments.json.write_text(json.dumps(results, indent=1))
    print_tables(results)
    if arguments.images:
        pictures(arguments.images, results)


if __name__ == "__main__":
    main()
