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
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import permutations
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ..adjustment.shape_effects import CELLS, CellSums, Eliminated
from ..common.arrays import FloatArray, IntArray, upper_triangle
from ..common.kernels import side_by_side
from ..common.positive_definite import largest_sd
from ..common.robust import MAD_TO_SD, TUKEY
from ..model.mould import AZIMUTH_CELLS, Mould
from ..model.pose import Pose
from ..model.tetrapod import TIP_RATIO, leg_frame
from ..model.unit_types import UnitType
from .cast_surfaces import CastSurfaces
from .ends_in_epochs import ends_shown, way_to_ends
from .joint_records import JointAdjustment, UnitSighting
from .presence import CHANCE_SDS
from .streamed_median import StreamedMedian
from .strip_drifts import DriftSystem, Knots, UnitEquations
from .strip_observations import Body, StripObservations, accumulate, deviations, kept_share, observations
from .strip_systems import DriftStep, OffsetSystem, StripSystem, StripValues, UnitBlock
from .unit_clouds import ReadCloud, by_home

MAX_ITERATIONS = 8

CONVERGED = 0.01
"""Largest last step of nine tenths of the units, over the noise of one point."""

LEARNING_ITERATIONS = (1, 3)
"""After which the surfaces of the units are learned, with the poses as they are then."""

END_ITERATIONS = (1, 3)
"""Before which the ends of legs are looked at again, with the poses as they are then."""

MORE_POINTS = 1.1
"""By what factor, and ``CHANCE_SDS`` of their number beyond it, more points of a sighting must lie on its unit where another one
has it than where its own fit does (assumed; looked at on U013 of docs/benchmarks-castings.md)."""

OPEN_TURN = math.pi / AZIMUTH_CELLS
"""Standard deviation of a turn, half the width of a cell, from which it is not known which cells of a leg a sighting shows."""

UNKNOWN_NOISE_RATIO = 0.005
"""Noise over the height of a unit where no epoch holds enough points to estimate it."""

LEAST_DRIFT = 0.25
"""Drift over the whole structure, over the noise of a point, from which strips are not held stiff."""


def adjust_jointly(
    sightings: Sequence[UnitSighting],
    *,
    offset_sd: float | None = None,
    scale_sd: float | None = None,
    moulds: Mapping[UnitType, Mould] = MappingProxyType({}),
) -> JointAdjustment:
    """Adjust the poses of all units in all epochs together with the offsets of strips or stations.

    Parameters
    ----------
    sightings
        Units as identified over the epochs; a unit has at most one sighting an epoch.
    offset_sd
        A priori standard deviation of an offset in metres, 0 to estimate none; None for the noise of the epoch.
    scale_sd
        Relative spread of unit sizes; 0 holds the size, None learns it.
    moulds
        What earlier surveys say of the castings of a type; of others it is learned.
    """
    solver = _JointSolver(sightings, offset_sd, scale_sd, moulds)
    return solver.solve()


class UnitReduction(NamedTuple):
    """A unit eliminated from the normal equations: its block, whether the turn of each sighting is open, what it says of its surface, and
    its sums by cell and sighting."""

    block: UnitBlock
    open: list[bool]
    surface: Eliminated
    cells: list[CellSums]


class LookAgain(NamedTuple):
    """What is needed to look at points again, metres: by sighting the (3, 3) covariance of its centre, and by two epochs how far units lie
    elsewhere in the second, (3,) median of those that both show, where a sighting may begin at another's pose."""

    covariances: dict[int, FloatArray]
    shifts: dict[tuple[int, int], FloatArray] | None


class _JointSolver:
    """State of the joint adjustment."""

    def __init__(
        self, sightings: Sequence[UnitSighting], offset_sd: float | None, scale_sd: float | None, moulds: Mapping[UnitType, Mould]
    ) -> None:
        self.sightings = list(sightings)
        self.scale_sd = scale_sd
        self.offset_sd = offset_sd
        self.epochs = 1 + max((s.epoch for s in sightings), default=-1)
        self.strips: dict[tuple[int, int], int] = {}
        self.strips_of = [
            np.array([self.strips.setdefault((s.epoch, int(i)), len(self.strips)) for i in s.cloud.ids], dtype=np.int64)
            for s in self.sightings
        ]
        self.values = StripValues(offsets=np.zeros((len(self.strips), 3)), drifts=np.zeros((0, len(self.strips), 3)))
        self.strip_epoch = np.array([epoch for epoch, _ in self.strips], dtype=np.int64)
        self.order: dict[int, tuple[int, ...]] = {}
        for k, s in sorted(enumerate(self.sightings), key=lambda item: item[1].epoch):
            self.order[s.unit] = (*self.order.get(s.unit, ()), k)
        self.place_of = {unit: k for k, unit in enumerate(self.order)}
        self.knots: Knots | None = None
        self.rate: float | None = None
        self.reading = by_home((unit, tuple(self.sightings[k].cloud for k in own)) for unit, own in self.order.items())
        self.across = {shape: np.stack(leg_frame(shape)) for shape in {s.shape for s in self.sightings}}
        self.centres = [np.array(s.pose.centre) for s in self.sightings]
        self.rotations = [np.array(s.pose.rotation, order="C") for s in self.sightings]
        self.scales = dict.fromkeys(self.order, 0.0)
        self.noise = np.full(max(self.epochs, 1), math.nan)
        self.surface_sd = 0.0
        self.used = np.zeros(len(self.sightings), dtype=np.int64)
        self.open = np.zeros(len(self.sightings), dtype=np.bool_)
        shapes = sorted({s.shape for s in self.sightings}, key=repr)
        self.surfaces = {shape: CastSurfaces(shape.height, moulds.get(shape)) for shape in shapes}

    def clouds(self) -> Iterator[tuple[int, list[ReadCloud]]]:
        """Every unit with the points of its sightings, in the order in which they are read with least effort."""
        for unit in self.reading:
            yield unit, [self.sightings[k].cloud.read() for k in self.order[unit]]

    def observed(self, unit: int, clouds: Sequence[ReadCloud], noise: FloatArray, derived: bool = True) -> list[StripObservations]:
        """Observations of a unit by sighting, with derivatives where ``derived``; ``noise`` by epoch sets how near to a crease points are
        left out."""
        parts = zip(self.order[unit], clouds, strict=True)
        return [self.observe(k, cloud, float(noise[self.sightings[k].epoch]), derived) for k, cloud in parts]

    def observe(self, number: int, cloud: ReadCloud, noise: float, derived: bool) -> StripObservations:
        s, body = self.sightings[number], self.body_of(number)
        points, sources = cloud
        strips = _table(s.cloud.ids, self.strips_of[number])[sources]
        tip, margin = TIP_RATIO * body.length, _margin(s.shape, noise)
        return observations(points, strips, self.offsets_at(s.unit), body, margin=margin, tip=tip, derived=derived)

    def body_of(self, number: int) -> Body:
        """The unit as a sighting shows it at the present estimates."""
        s = self.sightings[number]
        unit, grown = s.shape, 1 + self.scales[s.unit]
        return Body(
            centre=self.centres[number],
            rotation=self.rotations[number],
            axes=np.ascontiguousarray(unit.leg_directions),
            across=self.across[unit],
            discs=np.asarray(s.discs, dtype=np.bool_),
            radius=unit.radius * grown,
            gradient=unit.gradient,
            length=unit.leg_length * grown,
        )

    def estimate_noise(self) -> None:
        """Noise by epoch from residuals less their patch's mean; spread of the patches beyond what noise explains."""
        before = self.noise.copy()
        within = [StreamedMedian(noise / MAD_TO_SD) for noise in before]
        spread, share = StreamedMedian(), StreamedMedian()
        settled = False
        while not settled:
            found = side_by_side(
                lambda item: (item[0], [deviations(seen) for seen in self.observed(*item, before, derived=False)]),
                self.clouds(),
            )
            for unit, parts in found:
                for k, part in zip(self.order[unit], parts, strict=True):
                    if part is not None:
                        for median, numbers in zip((within[self.sightings[k].epoch], spread, share), part, strict=True):
                            median.add(numbers)
            # every one has to be asked: the answer is what makes it look closer
            settled = {median.settled() for median in (*within, spread, share)} == {True}
        for epoch, median in enumerate(within):
            if not math.isnan(median.value):
                self.noise[epoch] = MAD_TO_SD * median.value
        height = max(s.shape.height for s in self.sightings)
        known = self.noise[np.isfinite(self.noise)]
        self.noise[np.isnan(self.noise)] = np.median(known) if len(known) else UNKNOWN_NOISE_RATIO * height
        # points without noise have no weights, surfaces without deviations no prior
        self.noise = np.maximum(self.noise, 1e-7 * height)
        noise = float(np.median(self.noise))
        beyond = 0.0 if math.isnan(spread.value) else (MAD_TO_SD * spread.value) ** 2 - noise**2 * share.value
        self.surface_sd = math.sqrt(max(beyond, (0.05 * noise) ** 2))

    def equations(self, unit: int, sightings: Sequence[StripObservations]) -> UnitReduction:
        """Normal equations of one unit after elimination of its patches: poses, scale, then its strips (global numbers returned)."""
        members = self.order[unit]
        touched = np.unique(np.concatenate([self.strips_of[k] for k in members]))
        n_pose = 6 * len(members)
        size = n_pose + 1 + 3 * len(touched)
        normal, rhs = np.zeros((size, size)), np.zeros(size)
        surface = self.surfaces[self.sightings[members[0]].shape]
        cells = []
        # epochs that show the same leg alone see mostly the same side of it: tied, what they share cancels in their difference
        tied = [bool(not self.open[k] or self.open[list(members)].all()) for k in members]
        number_of_strip = _table(touched, np.arange(len(touched)))
        for body, (k, seen) in enumerate(zip(members, sightings, strict=True)):
            local = number_of_strip[seen.strips]
            noise = float(self.noise[self.sightings[k].epoch])
            # once the surface is known, points are judged against it
            window = math.hypot(noise, surface.roughness if surface.learned else self.surface_sd)
            limit = TUKEY * window / noise
            sums = CellSums(np.zeros((CELLS, size)), np.zeros(CELLS), np.zeros(CELLS), np.zeros(CELLS), noise)
            self.used[k] = accumulate(
                seen,
                (noise, limit, kept_share(limit)),
                surface.expected(unit) if tied[body] else surface.model.mean,
                (normal, rhs),
                (sums.rows, sums.weight, sums.rhs, sums.square),
                (body, n_pose, local),
            )
            cells.append(sums)
        found = surface.reduced(unit, normal, rhs, cells, tied)
        known, normal, rhs = normal, found.normal, found.rhs
        mean, sd = (surface.model.size_mean, surface.model.size_sd) if self.scale_sd is None else (0.0, max(self.scale_sd, 1e-9))
        rhs[n_pose] -= (self.scales[unit] - mean) / sd**2
        own, length = n_pose + 1, self.sightings[members[0]].shape.leg_length
        for equations in (known, normal):
            equations[n_pose, n_pose] += 1 / sd**2
        inverse, if_known = (_inverse(equations[:own, :own], length) for equations in (normal, known))
        # copies: a view would keep the whole of the unit's equations in memory
        coupling = normal[:own, own:].copy()
        block = UnitBlock(
            inverse_upper=inverse[upper_triangle(own)],
            known_upper=if_known[upper_triangle(own)],
            coupling=coupling,
            rhs=rhs[:own].copy(),
            strips=touched,
            strip_upper=(normal[own:, own:] - coupling.T @ inverse @ coupling)[upper_triangle(size - own)],
            strip_rhs=rhs[own:] - coupling.T @ inverse @ rhs[:own],
        )
        turns = (inverse[k : k + 3, k : k + 3] for k in range(3, n_pose, 6))
        return UnitReduction(block, [largest_sd(turn) > OPEN_TURN for turn in turns], found, cells)

    def offset_prior(self) -> FloatArray:
        """(3 s,) weights of the pseudo-observations."""
        sd = self.noise[self.strip_epoch] if self.offset_sd is None else np.full(len(self.strip_epoch), max(self.offset_sd, 1e-12))
        return np.repeat(1 / sd**2, 3)

    def solve(self) -> JointAdjustment:
        if not self.sightings:
            return JointAdjustment(
                poses=(),
                covariances={},
                noise_covariances={},
                order={},
                offsets={},
                offset_sds={},
                scales={},
                scale_sds={},
                noise=self.noise,
                surface_sd=0.0,
                used=self.used,
            )
        blocks, strips = self.iterate()
        if self.let_drift(blocks):
            blocks, strips = self.iterate()
        return self.result(blocks, strips)

    def iterate(self) -> tuple[dict[int, UnitBlock], StripSystem]:
        """Adjust poses, sizes and strips to convergence; blocks of the units and system of the strips of the last step."""
        blocks: dict[int, UnitBlock] = {}
        for iteration in range(MAX_ITERATIONS):
            before = self.noise.copy()
            if iteration < 4:
                self.estimate_noise()
            # those of the last step go before the next ones come: two sets would be twice the memory
            looks, blocks = self._what_to_look_for(iteration, blocks), {}
            # the noise is known better by now, but it must judge the points that it was estimated from
            blocks = self.reduce(before, looks)
            if iteration in LEARNING_ITERATIONS:
                for surface in self.surfaces.values():
                    surface.learn()
            strips = self.strip_system(blocks)
            steps = [strips.apply(self.values)]
            changes = np.zeros((len(self.sightings), 6))
            for unit, block in blocks.items():
                change = block.inverse @ (block.rhs - block.coupling @ strips.change(unit, block.strips))
                changes[list(self.order[unit])] = change[:-1].reshape(-1, 6)
                steps.append(float(np.abs(changes[list(self.order[unit]), :3]).max()))
                self.scales[unit] += float(change[-1])
            turns = Rotation.from_rotvec(changes[:, 3:]).as_matrix()
            for k, change in enumerate(changes):
                self.centres[k] = self.centres[k] + change[:3]
                self.rotations[k] = np.ascontiguousarray(turns[k] @ self.rotations[k])
            # units that are hardly determined go on wandering within their deviations: the rest decides
            step = max(steps[0], float(np.quantile(steps, 0.9)))
            if iteration > LEARNING_ITERATIONS[-1] and step < CONVERGED * float(np.nanmin(self.noise)):
                break
        return blocks, strips

    def look_again(self, unit: int, clouds: Sequence[ReadCloud], looks: LookAgain) -> None:
        """Use end discs that the points of a unit in several epochs show at its present poses, if not at those of their own fits.

        A sighting begins where another one has the unit, at rest, if clearly more of its points lie on it there: a fit to few points may
        settle where most of them lie beside the unit, and robust weights never see these again.
        """
        own = self.order[unit]
        if len(own) < 2:
            return
        for k, cloud in zip(own, clouds, strict=True):
            if not self.open[k]:
                self.use_ends(k, cloud, looks.covariances[k])
        if looks.shifts is None:
            return
        counts = [self.points_on(k, cloud) for k, cloud in zip(own, clouds, strict=True)]
        best = own[int(np.argmax(counts))]
        for k, cloud, count in zip(own, clouds, counts, strict=True):
            if k != best:
                before = self.centres[k], self.rotations[k], self.sightings[k]
                self.centres[k] = self.centres[best] + looks.shifts[self.sightings[best].epoch, self.sightings[k].epoch]
                self.rotations[k] = self.rotations[best].copy()
                self.use_ends(k, cloud, looks.covariances[k])
                if self.points_on(k, cloud) <= MORE_POINTS * count + CHANCE_SDS * math.sqrt(count):
                    self.centres[k], self.rotations[k], self.sightings[k] = before

    def use_ends(self, number: int, cloud: ReadCloud, covariance: FloatArray) -> None:
        """Use what the points of a sighting show of ends of legs; ``covariance`` (3, 3) of its centre, square metres."""
        s, (points, sources) = self.sightings[number], cloud
        if s.discs.all() or not len(points):
            return
        body, noise = self.body_of(number), float(self.noise[s.epoch])
        points = points - self.offsets_at(s.unit)[_table(s.cloud.ids, self.strips_of[number])[sources]]
        shown = ends_shown(points, body, covariance, s.shape.height, _margin(s.shape, noise), noise)
        self.sightings[number] = replace(s, discs=s.discs | np.isfinite(shown))
        self.centres[number] = self.centres[number] + way_to_ends(shown, body, noise)

    def points_on(self, number: int, cloud: ReadCloud) -> int:
        """How many points of a sighting lie on its unit."""
        noise = float(self.noise[self.sightings[number].epoch])
        seen = self.observe(number, cloud, noise, derived=False)
        return int(np.count_nonzero((seen.patches >= 0) & (np.abs(seen.residuals) < TUKEY * noise)))

    def _what_to_look_for(self, iteration: int, blocks: Mapping[int, UnitBlock]) -> LookAgain | None:
        """What the looks before a step need to know of the step before, whose ``blocks`` are let go then; None where none is taken."""
        if iteration not in END_ITERATIONS:
            return None
        covariances: dict[int, FloatArray] = {}
        for unit, block in blocks.items():
            inverse = block.inverse
            covariances |= {k: inverse[6 * i : 6 * i + 3, 6 * i : 6 * i + 3].copy() for i, k in enumerate(self.order[unit])}
        if iteration != END_ITERATIONS[0]:
            return LookAgain(covariances, None)
        ways: dict[tuple[int, int], list[FloatArray]] = {}
        for own in self.order.values():
            for a, b in permutations(own, 2):
                ways.setdefault((self.sightings[a].epoch, self.sightings[b].epoch), []).append(self.centres[b] - self.centres[a])
        return LookAgain(covariances, {epochs: np.median(own, axis=0) for epochs, own in ways.items()})

    def reduce(self, noise: FloatArray, looks: LookAgain | None) -> dict[int, UnitBlock]:
        """Eliminate the units, looked at again if asked for and observed with the ``noise`` by epoch: their blocks, and what each says of
        its strips."""

        def reduced(item: tuple[int, list[ReadCloud]]) -> tuple[int, UnitReduction]:
            if looks is not None:
                self.look_again(*item, looks)
            return item[0], self.equations(item[0], self.observed(*item, noise))

        blocks = {}
        reductions = side_by_side(reduced, self.clouds())
        for unit, reduction in reductions:
            surface = self.surfaces[self.sightings[self.order[unit][0]].shape]
            surface.keep(unit, self.scales[unit], reduction.surface, reduction.cells, len(reduction.block.rhs))
            blocks[unit] = reduction.block
            self.open[list(self.order[unit])] |= reduction.open
        return blocks

    def strip_system(self, blocks: Mapping[int, UnitBlock]) -> StripSystem:
        """Strips with offsets alone, or with drifts where :meth:`let_drift` found them."""
        if self.knots is None or self.rate is None:
            return OffsetSystem(self.offset_prior(), self.strip_epoch, self.values.offsets, blocks.values())
        return DriftStep(self.drift_system(self.knots, blocks), self.rate, self.values.drifts)

    def drift_system(self, knots: Knots, blocks: Mapping[int, UnitBlock]) -> DriftSystem:
        equations = [
            UnitEquations(unit=self.place_of[unit], strips=b.strips, upper=b.strip_upper, rhs=b.strip_rhs) for unit, b in blocks.items()
        ]
        return DriftSystem(knots, self.strip_epoch, equations, 1 / np.sqrt(self.offset_prior()[::3]), self.place_of)

    def let_drift(self, blocks: Mapping[int, UnitBlock]) -> bool:
        """Decide whether strips drift along the structure, and lay knots for it."""
        if self.offset_sd == 0 or len(self.strips) < 2:
            return False
        places = np.array([self.centres[own[0]] for own in self.order.values()])
        height = max(s.shape.height for s in self.sightings)
        knots = Knots.along(places, height)
        if knots is None:
            return False
        rate = self.drift_system(knots, blocks).rate(height)[0]
        # what stays far below the noise of a point is left in the surface deviations, which hold it as well
        if rate is None or rate * math.sqrt(knots.length) < LEAST_DRIFT * float(np.median(self.noise)):
            return False
        self.knots, self.rate = knots, rate
        self.values.drifts = np.zeros((knots.count, len(self.strips), 3))
        return True

    def offsets_at(self, unit: int) -> FloatArray:
        """(s, 3) offsets of all strips where a unit lies, metres."""
        if self.knots is None:
            return self.values.offsets
        (a, wa), (b, wb) = self.knots.weights(self.place_of[unit])
        return np.asarray(self.values.offsets + wa * self.values.drifts[a] + wb * self.values.drifts[b])

    def result(self, blocks: Mapping[int, UnitBlock], strips: StripSystem) -> JointAdjustment:
        covariances, scale_sds = {}, {}
        factors = {unit: factor for surface in self.surfaces.values() for unit, factor in surface.factors().items()}
        for unit, block in blocks.items():
            inverse = block.inverse
            lever = inverse @ block.coupling
            full = inverse + lever @ strips.covariance(unit, block.strips) @ lever.T
            # a size's deviation says how far it is drawn towards the mean, which its weights decide
            scale_sds[unit] = math.sqrt(full[-1, -1])
            covariances[unit] = (full + (factors.get(unit, 1.0) - 1) * inverse)[:-1, :-1]
        poses = []
        for centre, rotation in zip(self.centres, self.rotations):
            u, _, vt = np.linalg.svd(rotation)
            poses.append(Pose(centre, u @ vt))
        return JointAdjustment(
            poses=tuple(poses),
            covariances=covariances,
            noise_covariances={unit: block.noise_covariance[:-1, :-1] for unit, block in blocks.items()},
            order=self.order,
            offsets={key: self.values.offsets[k] for key, k in self.strips.items()},
            offset_sds={key: strips.offset_sds()[k] for key, k in self.strips.items()},
            scales=self.scales,
            scale_sds=scale_sds,
            noise=self.noise,
            surface_sd=self.surface_sd,
            used=self.used,
            drifts=strips.drifts(self.strips, self.values),
            surfaces={shape: surface.model for shape, surface in self.surfaces.items()},
        )


def _margin(unit: UnitType, noise: float) -> float:
    """Distance of creases and rims, metres, within which points are left out; the noise of a point may be unknown (nan)."""
    return 0.03 * unit.radius if math.isnan(noise) else max(1.5 * noise, 0.01 * unit.radius)


def _table(keys: NDArray[np.integer], values: IntArray) -> IntArray:
    """(largest of the keys + 1,) value by ascending key: looking up is quicker than searching for the key of every point."""
    table = np.zeros(int(keys[-1]) + 1 if len(keys) else 0, dtype=np.int64)
    table[keys] = values
    return table


def _inverse(normal: FloatArray, length: float) -> FloatArray:
    """Inverse of a unit's block; a direction the points do not determine is held by a weak prior (unit's size, a full turn)."""
    poses = (len(normal) - 1) // 6
    prior = np.array(([1 / length**2] * 3 + [1.0] * 3) * poses + [0.0])
    return np.asarray(np.linalg.inv(normal + np.diag(prior)))
