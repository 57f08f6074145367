"""Offsets of flight strips and scanner stations, estimated jointly with the poses of all units: the units are the tie objects.

Observation of point i on unit u in epoch t, from source s (LAS point_source_id), on patch k of the unit's surface:

    distance(p_i - o_s; pose_ut, scale_u) = b_uk + noise

with o_s the offset of the source, and b_uk the deviation of the patch from the ideal cone (mould, roughness, growth). A patch keeps
its deviation over the epochs, so that it does not pass into displacements, and the points on one patch are rightly not counted as
independent. Patches and poses are eliminated from the normal equations unit by unit (Foerstner and Wrobel, 2016, Photogrammetric
Computer Vision, 15.3), which leaves a small system of the offsets alone. Offsets are pseudo-observed as zero with a standard
deviation: an offset common to all sources of an epoch cannot be told from a shift of the cloud, and stays in the registration.

Points are read anew for every look at them, and what is kept of a unit is its reduced normal equations: memory does not grow with the
number of points.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from .gauss_helmert import TIP_RATIO
from .kernels import kernel
from .pose import Pose
from .streamed_median import StreamedMedian
from .unit_clouds import UnitCloud, by_home
from .unit_types import UnitType

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]

AXIAL_PATCHES, AZIMUTH_PATCHES, DISC_PATCHES = 5, 10, 3
LEG_PATCHES = AXIAL_PATCHES * AZIMUTH_PATCHES + DISC_PATCHES
TUKEY_CONSTANT = 4.685
HEIGHT_SPREAD = 0.003
"""Relative standard deviation of the size of units from one set of moulds."""
MAX_ITERATIONS = 8
CONVERGED = 0.01
"""Largest last step of nine tenths of the units, over the noise of one point."""
UNKNOWN_NOISE_RATIO = 0.005
"""Noise over the height of a unit where no epoch holds enough points to estimate it."""
GAUGE_WEIGHT = 1e4
"""Weight of the condition that the offsets of an epoch add up to zero, over the weight of one offset's pseudo-observation."""


@dataclass(frozen=True, eq=False)
class UnitSighting:
    """A unit in one epoch.

    Attributes
    ----------
    unit
        Index of the physical unit, 0, 1, ...
    epoch
        Index of the epoch.
    pose
        Approximate pose, legs numbered alike in all epochs; metres, any frame common to all sightings less a reduction point.
    cloud
        The unit's points in that frame, with the flight strip or station of each.
    discs
        (4,) whether the end of the leg is a plane that may be used.
    shape
        Geometry of the unit.
    """

    unit: int
    epoch: int
    pose: Pose
    cloud: UnitCloud
    discs: BoolArray
    shape: UnitType


@dataclass(frozen=True, eq=False)
class JointAdjustment:
    """Result of :func:`adjust_jointly`.

    Attributes
    ----------
    poses
        Of each sighting, in the order given.
    covariances
        By unit: (6 k, 6 k) covariance of the poses of its k sightings, in the order of ``order[unit]``; e, n, h, w_e, w_n, w_h
        each. It holds noise, surface deviations and offsets.
    order
        By unit: indices of its sightings, by epoch.
    offsets
        (epoch, source) to (3,) offset in metres: a point less its offset is in the epoch's mean frame.
    offset_sds
        (epoch, source) to (3,) standard deviations.
    scales, scale_sds
        By unit: relative difference of its size from the given geometry, and its standard deviation.
    noise
        (e,) standard deviation of a point along the surface normal by epoch, metres; an epoch with too few points to tell counts as
        noisy as the others.
    surface_sd
        Standard deviation of the surface deviations, metres.
    used
        (sightings,) points that carry weight.
    """

    poses: tuple[Pose, ...]
    covariances: dict[int, FloatArray]
    order: dict[int, tuple[int, ...]]
    offsets: dict[tuple[int, int], FloatArray]
    offset_sds: dict[tuple[int, int], FloatArray]
    scales: dict[int, float]
    scale_sds: dict[int, float]
    noise: FloatArray
    surface_sd: float
    used: IntArray


@kernel()
def _observe(
    points: Any, strip: Any, offsets: Any, centre: Any, rotation: Any, axes: Any, across: Any, shape: Any, discs: Any, margin: float,
    tip: float, rows: Any, residual: Any, patch: Any,
) -> None:  # fmt: skip
    """Distances, rows (de/dpose 6, de/dscale) and patch of every point of one sighting; patch -1 for points that are left out.

    Beyond ``tip`` along a leg, where tips are rounded, the cone counts only if the end disc holds it.
    """
    r, c, length = shape[0], shape[1], shape[2]
    cosine = 1.0 / math.sqrt(1.0 + c * c)
    end_radius = r - c * length
    for i in range(points.shape[0]):
        s = strip[i]
        px = points[i, 0] - offsets[s, 0] - centre[0]
        py = points[i, 1] - offsets[s, 1] - centre[1]
        pz = points[i, 2] - offsets[s, 2] - centre[2]
        x = rotation[0, 0] * px + rotation[1, 0] * py + rotation[2, 0] * pz
        y = rotation[0, 1] * px + rotation[1, 1] * py + rotation[2, 1] * pz
        z = rotation[0, 2] * px + rotation[1, 2] * py + rotation[2, 2] * pz
        leg = 0
        axial = -1e300
        for k in range(4):
            lean = x * axes[k, 0] + y * axes[k, 1] + z * axes[k, 2]
            if lean > axial:
                axial, leg = lean, k
        ax, ay, az = axes[leg, 0], axes[leg, 1], axes[leg, 2]
        patch[i] = -1
        # points at a crease may belong to either leg: left out, for their distance is biased
        at_crease = False
        for k in range(4):
            if k != leg:
                qx, qy, qz = ax - axes[k, 0], ay - axes[k, 1], az - axes[k, 2]
                if x * qx + y * qy + z * qz < margin * math.sqrt(qx * qx + qy * qy + qz * qz):
                    at_crease = True
        if at_crease:
            continue
        ux, uy, uz = x - axial * ax, y - axial * ay, z - axial * az
        rho = math.sqrt(ux * ux + uy * uy + uz * uz) + 1e-300
        ux, uy, uz = ux / rho, uy / rho, uz / rho
        side = (rho - r + c * axial) * cosine
        end = axial - length
        if end > -margin or (axial > tip and not discs[leg]):
            if not discs[leg] or rho > end_radius - margin or end < side:
                continue
            nx, ny, nz = ax, ay, az
            e = end
            scale_row = -length
            disc = True
        else:
            nx, ny, nz = (ux + c * ax) * cosine, (uy + c * ay) * cosine, (uz + c * az) * cosine
            e = side
            scale_row = -r * cosine
            disc = False
        first = ux * across[0, leg, 0] + uy * across[0, leg, 1] + uz * across[0, leg, 2]
        second = ux * across[1, leg, 0] + uy * across[1, leg, 1] + uz * across[1, leg, 2]
        turn = (math.atan2(second, first) / (2.0 * math.pi)) % 1.0
        if disc:
            patch[i] = leg * LEG_PATCHES + AXIAL_PATCHES * AZIMUTH_PATCHES + min(int(turn * DISC_PATCHES), DISC_PATCHES - 1)
        else:
            ring = min(max(int(axial / length * AXIAL_PATCHES), 0), AXIAL_PATCHES - 1)
            patch[i] = leg * LEG_PATCHES + ring * AZIMUTH_PATCHES + min(int(turn * AZIMUTH_PATCHES), AZIMUTH_PATCHES - 1)
        residual[i] = e
        mx, my, mz = ny * z - nz * y, nz * x - nx * z, nx * y - ny * x
        for m in range(3):
            rows[i, m] = -(rotation[m, 0] * nx + rotation[m, 1] * ny + rotation[m, 2] * nz)
            rows[i, m + 3] = rotation[m, 0] * mx + rotation[m, 1] * my + rotation[m, 2] * mz
        rows[i, 6] = scale_row


@kernel()
def _accumulate(
    rows: Any, residual: Any, patch: Any, strip_local: Any, body: int, sigma: float, tukey: float, normal: Any, rhs: Any,
    patch_rows: Any, patch_weight: Any, patch_rhs: Any, n_pose: int,
) -> int:  # fmt: skip
    """Add one sighting to its unit's normal equations; returns the number of points with weight."""
    index = np.zeros(10, dtype=np.int64)
    value = np.zeros(10)
    used = 0
    for i in range(rows.shape[0]):
        if patch[i] < 0:
            continue
        u = residual[i] / (sigma * tukey)
        if abs(u) >= 1.0:
            continue
        w = (1.0 - u * u) ** 2 / (sigma * sigma)
        used += 1
        for m in range(6):
            index[m] = 6 * body + m
            value[m] = rows[i, m]
        index[6] = n_pose
        value[6] = rows[i, 6]
        for m in range(3):
            index[7 + m] = n_pose + 1 + 3 * strip_local[i] + m
            value[7 + m] = rows[i, m]
        k = patch[i]
        patch_weight[k] += w
        patch_rhs[k] -= w * residual[i]
        for a in range(10):
            wa = w * value[a]
            rhs[index[a]] -= wa * residual[i]
            patch_rows[k, index[a]] += wa
            for b in range(10):
                normal[index[a], index[b]] += wa * value[b]
    return used


def adjust_jointly(
    sightings: Sequence[UnitSighting], *, offset_sd: float | None = None, scale_sd: float = HEIGHT_SPREAD
) -> JointAdjustment:
    """Adjust the poses of all units in all epochs together with the offsets of strips or stations.

    Parameters
    ----------
    sightings
        Units as identified over the epochs; a unit has at most one sighting an epoch.
    offset_sd
        A priori standard deviation of an offset in metres, 0 to estimate none; None for the noise of the epoch.
    scale_sd
        Relative spread of unit sizes; 0 holds the size.
    """
    solver = _JointSolver(sightings, offset_sd, scale_sd)
    return solver.solve()


@dataclass(frozen=True, eq=False)
class _Observations:
    """Points of one sighting as observations at the present estimates.

    Attributes
    ----------
    rows
        (n, 7) derivatives of the distances by pose and scale.
    residuals
        (n,) distances, metres.
    patches
        (n,) patch of the surface; -1 for points that are left out.
    strips
        (n,) number of the strip or station.
    """

    rows: FloatArray
    residuals: FloatArray
    patches: IntArray
    strips: IntArray


class _JointSolver:
    """State of the joint adjustment."""

    def __init__(self, sightings: Sequence[UnitSighting], offset_sd: float | None, scale_sd: float) -> None:
        self.sightings = list(sightings)
        self.scale_sd = max(scale_sd, 1e-9)
        self.offset_sd = offset_sd
        self.epochs = 1 + max((s.epoch for s in sightings), default=-1)
        self.strips: dict[tuple[int, int], int] = {}
        self.strips_of = [
            np.array([self.strips.setdefault((s.epoch, int(i)), len(self.strips)) for i in s.cloud.ids], dtype=np.int64)
            for s in self.sightings
        ]
        self.offsets = np.zeros((len(self.strips), 3))
        self.strip_epoch = np.array([epoch for epoch, _ in self.strips], dtype=np.int64)
        self.order: dict[int, tuple[int, ...]] = {}
        for k, s in sorted(enumerate(self.sightings), key=lambda item: item[1].epoch):
            self.order[s.unit] = (*self.order.get(s.unit, ()), k)
        self.reading = by_home((unit, tuple(self.sightings[k].cloud for k in own)) for unit, own in self.order.items())
        self.across = {shape: np.stack(across(shape)) for shape in {s.shape for s in self.sightings}}
        self.centres = [np.array(s.pose.centre) for s in self.sightings]
        self.rotations = [np.array(s.pose.rotation, order="C") for s in self.sightings]
        self.scales = dict.fromkeys(self.order, 0.0)
        self.noise = np.full(max(self.epochs, 1), math.nan)
        self.surface_sd = 0.0
        self.used = np.zeros(len(self.sightings), dtype=np.int64)

    def observed(self, noise: FloatArray) -> Iterator[tuple[int, list[_Observations]]]:
        """Every unit with its observations by sighting, in the order in which they are read with least effort; ``noise`` by epoch sets how
        near to a crease points are left out.
        """
        for unit in self.reading:
            yield unit, [self.observe(k, float(noise[self.sightings[k].epoch])) for k in self.order[unit]]

    def observe(self, number: int, noise: float) -> _Observations:
        s = self.sightings[number]
        unit = s.shape
        grown = 1 + self.scales[s.unit]
        shape = np.array([unit.radius * grown, unit.gradient, unit.leg_length * grown])
        margin = 0.03 * unit.radius if math.isnan(noise) else max(1.5 * noise, 0.01 * unit.radius)
        points, sources = s.cloud.read()
        strips = np.zeros(0, dtype=np.int64) if not len(sources) else self.strips_of[number][np.searchsorted(s.cloud.ids, sources)]
        found = _Observations(np.zeros((len(points), 7)), np.zeros(len(points)), np.full(len(points), -1, dtype=np.int64), strips)
        _observe(
            np.ascontiguousarray(points, dtype=np.float64), strips, self.offsets, self.centres[number], self.rotations[number],
            np.ascontiguousarray(unit.leg_directions), self.across[unit], shape, np.asarray(s.discs, dtype=np.bool_), margin,
            TIP_RATIO * unit.leg_length * grown, found.rows, found.residuals, found.patches,
        )  # fmt: skip
        return found

    def estimate_noise(self) -> None:
        """Noise by epoch from residuals less their patch's mean; spread of the patches beyond what noise explains."""
        before = self.noise.copy()
        within = [StreamedMedian() for _ in range(self.epochs)]
        spread, share = StreamedMedian(), StreamedMedian()
        settled = False
        while not settled:
            for unit, sightings in self.observed(before):
                for k, seen in zip(self.order[unit], sightings, strict=True):
                    self._add_deviations(seen, within[self.sightings[k].epoch], spread, share)
            # every one has to be asked: the answer is what makes it look closer
            settled = {median.settled() for median in (*within, spread, share)} == {True}
        for epoch, median in enumerate(within):
            if not math.isnan(median.value):
                self.noise[epoch] = 1.4826 * median.value
        height = max(s.shape.height for s in self.sightings)
        known = self.noise[np.isfinite(self.noise)]
        self.noise[np.isnan(self.noise)] = np.median(known) if len(known) else UNKNOWN_NOISE_RATIO * height
        # points without noise have no weights, surfaces without deviations no prior
        self.noise = np.maximum(self.noise, 1e-7 * height)
        noise = float(np.median(self.noise))
        beyond = 0.0 if math.isnan(spread.value) else (1.4826 * spread.value) ** 2 - noise**2 * share.value
        self.surface_sd = math.sqrt(max(beyond, (0.05 * noise) ** 2))

    @staticmethod
    def _add_deviations(seen: _Observations, within: StreamedMedian, spread: StreamedMedian, share: StreamedMedian) -> None:
        """Deviations of one sighting's points from the means of their patches, of these means from the cones, and one over the points of
        each patch.
        """
        good = seen.patches >= 0
        if good.sum() < 10:
            return
        e, p = seen.residuals[good], seen.patches[good]
        keep = np.abs(e) < 6 * 1.4826 * np.median(np.abs(e))
        e, p = e[keep], p[keep]
        counts = np.bincount(p, minlength=4 * LEG_PATCHES)
        sums = np.bincount(p, e, minlength=4 * LEG_PATCHES)
        mean = sums / np.maximum(counts, 1)
        full = counts >= 4
        inside = full[p]
        within.add(np.abs((e - mean[p])[inside] * np.sqrt(counts[p] / np.maximum(counts[p] - 1, 1))[inside]))
        spread.add(np.abs(mean[full]))
        share.add(1 / counts[full])

    def equations(self, unit: int, sightings: Sequence[_Observations]) -> tuple[FloatArray, FloatArray, IntArray]:
        """Normal equations of one unit after elimination of its patches: poses, scale, then its strips (global numbers returned)."""
        members = self.order[unit]
        touched = np.unique(np.concatenate([self.strips_of[k] for k in members]))
        n_pose = 6 * len(members)
        size = n_pose + 1 + 3 * len(touched)
        normal, rhs = np.zeros((size, size)), np.zeros(size)
        patch_rows, patch_weight, patch_rhs = np.zeros((4 * LEG_PATCHES, size)), np.zeros(4 * LEG_PATCHES), np.zeros(4 * LEG_PATCHES)
        for body, (k, seen) in enumerate(zip(members, sightings, strict=True)):
            local = np.searchsorted(touched, seen.strips)
            sigma = float(math.hypot(self.noise[self.sightings[k].epoch], self.surface_sd))
            self.used[k] = _accumulate(
                seen.rows, seen.residuals, seen.patches, local, body, self.noise[self.sightings[k].epoch],
                TUKEY_CONSTANT * sigma / self.noise[self.sightings[k].epoch], normal, rhs, patch_rows, patch_weight, patch_rhs, n_pose,
            )  # fmt: skip
        total = patch_weight + 1 / self.surface_sd**2
        seen_patches = patch_weight > 0
        weighted = patch_rows[seen_patches] / total[seen_patches, None]
        normal -= patch_rows[seen_patches].T @ weighted
        rhs -= weighted.T @ patch_rhs[seen_patches]
        normal[n_pose, n_pose] += 1 / self.scale_sd**2
        rhs[n_pose] -= self.scales[unit] / self.scale_sd**2
        return normal, rhs, touched

    def offset_prior(self) -> FloatArray:
        """(3 s,) weights of the pseudo-observations."""
        sd = self.noise[self.strip_epoch] if self.offset_sd is None else np.full(len(self.strip_epoch), max(self.offset_sd, 1e-12))
        return np.repeat(1 / sd**2, 3)

    def solve(self) -> JointAdjustment:
        if not self.sightings:
            return JointAdjustment((), {}, {}, {}, {}, {}, {}, self.noise, 0.0, self.used)
        for iteration in range(MAX_ITERATIONS):
            before = self.noise.copy()
            if iteration < 4:
                self.estimate_noise()
            # the noise is known better by now, but it must judge the points that it was estimated from
            blocks, reduced, reduced_rhs = self.reduce(before)
            cofactor = np.asarray(np.linalg.inv(reduced), dtype=np.float64)
            shift = cofactor @ reduced_rhs
            self.offsets += shift.reshape(-1, 3)
            steps = [float(np.abs(shift).max(initial=0.0))]
            for unit, (inverse, coupling, own_rhs, touched) in blocks.items():
                columns = strip_columns(touched)
                change = inverse @ (own_rhs - coupling @ shift[columns])
                steps.append(float(np.abs(change[:-1].reshape(-1, 6)[:, :3]).max()))
                for body, k in enumerate(self.order[unit]):
                    self.centres[k] = self.centres[k] + change[6 * body : 6 * body + 3]
                    turn = Rotation.from_rotvec(change[6 * body + 3 : 6 * body + 6]).as_matrix()
                    self.rotations[k] = np.ascontiguousarray(turn @ self.rotations[k])
                self.scales[unit] += float(change[-1])
            # units that are hardly determined go on wandering within their deviations: the rest decides
            if iteration >= 2 and max(steps[0], float(np.quantile(steps, 0.9))) < CONVERGED * float(np.nanmin(self.noise)):
                break
        return self.result(blocks, cofactor)

    def reduce(self, noise: FloatArray) -> tuple[dict[int, tuple[FloatArray, FloatArray, FloatArray, IntArray]], FloatArray, FloatArray]:
        """Eliminate the units, observed with the ``noise`` by epoch: their blocks, and normal matrix and right-hand side of the offsets."""
        weights = self.offset_prior()
        prior = np.diag(weights)
        for epoch in range(self.epochs):
            columns = strip_columns(np.flatnonzero(self.strip_epoch == epoch)).reshape(-1, 3)
            for axis in columns.T:
                # the mean offset of an epoch is the registration's business: held at zero
                prior[np.ix_(axis, axis)] += GAUGE_WEIGHT * weights[axis].mean() if len(axis) else 0.0
        reduced = prior.copy()
        reduced_rhs = -prior @ self.offsets.ravel()
        blocks = {}
        for unit, sightings in self.observed(noise):
            normal, rhs, touched = self.equations(unit, sightings)
            own = 6 * len(self.order[unit]) + 1
            inverse = _inverse(normal[:own, :own], self.sightings[self.order[unit][0]].shape.leg_length)
            coupling = normal[:own, own:]
            columns = strip_columns(touched)
            reduced[np.ix_(columns, columns)] += normal[own:, own:] - coupling.T @ inverse @ coupling
            reduced_rhs[columns] += rhs[own:] - coupling.T @ inverse @ rhs[:own]
            blocks[unit] = (inverse, coupling, rhs[:own], touched)
        return blocks, reduced, reduced_rhs

    def result(self, blocks: dict[int, tuple[FloatArray, FloatArray, FloatArray, IntArray]], cofactor: FloatArray) -> JointAdjustment:
        covariances, scale_sds = {}, {}
        for unit, (inverse, coupling, _, touched) in blocks.items():
            columns = strip_columns(touched)
            lever = inverse @ coupling
            full = inverse + lever @ cofactor[np.ix_(columns, columns)] @ lever.T
            covariances[unit], scale_sds[unit] = full[:-1, :-1], math.sqrt(full[-1, -1])
        poses = []
        for centre, rotation in zip(self.centres, self.rotations):
            u, _, vt = np.linalg.svd(rotation)
            poses.append(Pose(centre, u @ vt))
        sds = np.sqrt(np.diag(cofactor)).reshape(-1, 3)
        return JointAdjustment(
            tuple(poses),
            covariances,
            self.order,
            {key: self.offsets[k] for key, k in self.strips.items()},
            {key: sds[k] for key, k in self.strips.items()},
            self.scales,
            scale_sds,
            self.noise,
            self.surface_sd,
            self.used,
        )


def across(unit: UnitType) -> tuple[FloatArray, FloatArray]:
    """Two (4, 3) sets of unit vectors that complete each leg's axis to a right-handed frame, the first towards another leg."""
    axes = unit.leg_directions
    other = axes[[1, 0, 0, 0]]
    first = other - np.sum(other * axes, axis=1, keepdims=True) * axes
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    return np.ascontiguousarray(first), np.cross(axes, first)


def strip_columns(strips: IntArray) -> IntArray:
    """Columns of the three offsets of each strip."""
    return np.asarray((3 * strips[:, None] + np.arange(3)).ravel(), dtype=np.int64)


def _inverse(normal: FloatArray, length: float) -> FloatArray:
    """Inverse of a unit's block; a direction the points do not determine is held by a weak prior (unit's size, a full turn)."""
    poses = (len(normal) - 1) // 6
    prior = np.array(([1 / length**2] * 3 + [1.0] * 3) * poses + [0.0])
    return np.asarray(np.linalg.inv(normal + np.diag(prior)))
