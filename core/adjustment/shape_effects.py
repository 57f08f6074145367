"""Deviations of real castings from the ideal cones as random effects of the physical unit, the same in all epochs.

The surface of a unit is divided into cells. The deviation b of a unit's cells along the normal, metres, is

    b ~ N(m, sum_j v_j K_j)

with m the mould, common to all units, and one variance component v_j for each way in which a
casting differs from its mould: radius and taper of single legs, offset and tilt of a leg's axis, ovality, length of a leg, tilt of its end
disc, and what is left from patch to patch. What a sighting adds that does not come back (drift of the sensor, other points of the same
cell) has a variance of its own by cell and sighting. Where two epochs see the same cells the deviations cancel in the difference of poses;
where they see others, they do not, and the covariance says so.

Mould and variances are learned from a survey by :mod:`.surface_estimation`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.kernels import kernel
from ..common.positive_definite import factorise, inverse_diagonal, substitute_back, whiten_columns
from ..model.mould import AXIAL_CELLS, AZIMUTH_CELLS, DISC_CELLS, THIRD, Mould
from ..model.unit_types import UnitType

LEG_CELLS = AXIAL_CELLS * AZIMUTH_CELLS + DISC_CELLS
CELLS = 4 * LEG_CELLS
COMPONENTS = ("radius", "taper", "axis", "tilt", "ovality", "length", "disc tilt", "patch", "spot")
"""Ways in which a casting differs from its mould, each with a variance in square metres."""
PRIOR_SDS = np.array([2.4e-3, 1.0e-3, 1.7e-3, 1.0e-3, 1.2e-3, 2.0e-3, 1.0e-3, 1.2e-3, 1.0e-3])
"""Standard deviations as shares of the height: radius of legs 0.24 %, around a leg 5 to 10 mm at 2.9 m (seven real units), the rest of that
order."""
PRIOR_SIZE_SD = 0.005
"""Relative standard deviation of the size of units: 0.3 % in the simulated surveys, 0.7 % of seven real ones."""
PRIOR_OWN_SD = 1e-4
"""Prior of what does not come back in a cell, as a share of the height."""
PRIOR_UNEVEN = (0.05, 0.3)
"""Prior of the shares of the variance within a cell that its mean does not keep: steep relief at root and tip depends on which points are
seen."""
OWN_DEGREES = 4.0
"""Of the t distribution of what does not come back: points of a neighbour and growth make it long-tailed."""
STRAIGHT = (0.33, 0.85)
"""Shares of a leg between which real moulds are straight."""
PATCH_LENGTH = 0.10
"""Length over which patches of a surface deviate together, as a share of the leg."""


@dataclass(frozen=True, eq=False)
class CellSums:
    """Weighted sums over the points of each cell in one sighting.

    Attributes
    ----------
    rows
        (CELLS, p) of the derivatives of the distances by the unknowns.
    weight
        (CELLS,) of the weights, 1 / square metre.
    rhs
        (CELLS,) of the negative distances.
    square
        (CELLS,) of the squared distances.
    noise
        Standard deviation of one point, metres.
    """

    rows: FloatArray
    weight: FloatArray
    rhs: FloatArray
    square: FloatArray
    noise: float

    @property
    def uneven(self) -> FloatArray:
        """(CELLS,) variance within each cell beyond noise, square metres: where it is large, the mean depends on which points are seen."""
        weight = np.maximum(self.weight, 1e-300)
        within = self.square / weight - (self.rhs / weight) ** 2
        return np.asarray(np.where(self.weight > 0, np.maximum(within - self.noise**2, 0.0), 0.0))


@dataclass(frozen=True, eq=False)
class SurfaceModel:
    """What is known of the deviations of a unit's cells before it is seen.

    Attributes
    ----------
    mean
        (CELLS,) of the mould, metres.
    variances
        By ``COMPONENTS``, square metres.
    own, uneven
        Variance by cell and sighting of what does not come back: square metres, and shares of the variance within the cell, in the
        straight part of a leg, and at its root, tip and end disc.
    size_mean, size_sd
        Mean relative difference of the units' size from the nominal one, and standard deviation about it.
    units
        Units that the variances were estimated from.
    """

    mean: FloatArray
    variances: FloatArray
    own: float
    uneven: tuple[float, float]
    size_mean: float
    size_sd: float
    units: int

    def as_mould(self, name: str, unit: UnitType) -> Mould:
        """What is known of a unit type's castings, to be stored and used in another survey."""
        h = unit.height
        lateral = self.mean[: AXIAL_CELLS * AZIMUTH_CELLS].reshape(AXIAL_CELLS, AZIMUTH_CELLS)[:, :THIRD]
        return Mould(
            name=name,
            units=self.units,
            radius=unit.radius / h,
            gradient=unit.gradient,
            leg_length=unit.leg_length / h,
            side=tuple((lateral / h).ravel().tolist()),
            disc=float(self.mean[LEG_CELLS - 1]) / h,
            size_mean=self.size_mean,
            size_sd=self.size_sd,
            sds=tuple((np.sqrt(self.variances) / h).tolist()),
            own=self.own / h**2,
            uneven=self.uneven,
        )

    def own_of(self, sums: CellSums) -> FloatArray:
        """(CELLS,) variance of what does not come back in the cells of a sighting."""
        return np.asarray(self.own + np.where(straight_cells(), *self.uneven) * sums.uneven)

    @property
    def covariance(self) -> FloatArray:
        """(LEG_CELLS, LEG_CELLS) of the cells of a leg, square metres; nothing ties two legs."""
        return np.asarray(np.tensordot(self.variances, structures(), axes=1))


def prior_surface(height: float) -> SurfaceModel:
    """What is known of units of a height in metres before a survey is seen."""
    return SurfaceModel(np.zeros(CELLS), (PRIOR_SDS * height) ** 2, (PRIOR_OWN_SD * height) ** 2, PRIOR_UNEVEN, 0.0, PRIOR_SIZE_SD, 0)


def surface_of(mould: Mould, height: float) -> SurfaceModel:
    """What a stored mould says of units of a height in metres."""
    side = np.tile(np.array(mould.side).reshape(AXIAL_CELLS, THIRD), (1, AZIMUTH_CELLS // THIRD)).ravel()
    mean = np.tile(np.concatenate([side, np.full(DISC_CELLS, mould.disc)]), 4) * height
    variances = (np.array(mould.sds) * height) ** 2
    return SurfaceModel(mean, variances, mould.own * height**2, mould.uneven, mould.size_mean, mould.size_sd, mould.units)


@lru_cache(maxsize=1)
def cell_places() -> tuple[IntArray, FloatArray, FloatArray, IntArray]:
    """(CELLS,) leg, share of the leg's length, azimuth (radians) and whether it lies on the end disc, of every cell."""
    ring, turn = np.divmod(np.arange(AXIAL_CELLS * AZIMUTH_CELLS), AZIMUTH_CELLS)
    axial = np.concatenate([(ring + 0.5) / AXIAL_CELLS, np.ones(DISC_CELLS)])
    azimuth = 2 * np.pi * np.concatenate([(turn + 0.5) / AZIMUTH_CELLS, (np.arange(DISC_CELLS) + 0.5) / DISC_CELLS])
    disc = np.concatenate([np.zeros(AXIAL_CELLS * AZIMUTH_CELLS, dtype=np.int64), np.ones(DISC_CELLS, dtype=np.int64)])
    return np.repeat(np.arange(4), LEG_CELLS), np.tile(axial, 4), np.tile(azimuth, 4), np.tile(disc, 4)


@lru_cache(maxsize=1)
def smooth_factors() -> tuple[FloatArray, ...]:
    """By component but the last two, (LEG_CELLS, r) columns F of which the correlation of the cells of a leg is F F'."""
    _, axial, azimuth, disc = (values[:LEG_CELLS] for values in cell_places())
    end = (disc == 1)[:, None] * 1.0
    side = 1.0 - end
    along = side * ((axial - 0.55) / 0.3)[:, None]

    def around(times: int) -> FloatArray:
        """A cosine of the difference of two azimuths, so often around the leg."""
        return np.column_stack([np.cos(times * azimuth), np.sin(times * azimuth)])

    return (side, along, side * around(1), along * around(1), side * around(2), end, end * around(1))


@lru_cache(maxsize=1)
def structures() -> FloatArray:
    """(len(COMPONENTS), LEG_CELLS, LEG_CELLS) correlation of the cells of a leg by component; nothing ties two legs."""
    _, axial, azimuth, disc = (values[:LEG_CELLS] for values in cell_places())
    side = disc[:, None] + disc == 0
    # a leg is about a third as thick as it is long
    apart = np.hypot(axial[:, None] - axial, 2 * 0.32 * np.sin(0.5 * (azimuth[:, None] - azimuth)))
    smooth = [columns @ columns.T for columns in smooth_factors()]
    return np.stack([*smooth, side * np.exp(-0.5 * (apart / PATCH_LENGTH) ** 2), np.eye(LEG_CELLS)])


@dataclass(frozen=True, eq=False)
class Eliminated:
    """Normal equations of a unit's unknowns without the deviations of its cells, and what the present estimates say of these.

    Attributes
    ----------
    normal, rhs
        (p, p), (p,).
    deviations
        (CELLS,) predicted deviations from the ideal cones, mould included, metres.
    own
        By sighting, (CELLS,) variance of what does not come back, larger in cells that contradict the rest of the unit.
    apart
        (CELLS,) variance of what single cells have beyond the deviations of castings, the same in all sightings: mixed pixels at the
        edges of what is seen, and neighbours that touch the unit, lie in the same place in every epoch.
    misfit
        Quadratic form of the deviations of all cells of all sightings from the mould with the inverse of the covariance that they are
        taken to have.
    seen
        Cells of all sightings.
    """

    normal: FloatArray
    rhs: FloatArray
    deviations: FloatArray
    own: tuple[FloatArray, ...]
    apart: FloatArray
    misfit: float
    seen: int


@lru_cache(maxsize=1)
def straight_cells() -> BoolArray:
    """(CELLS,) cells of the straight part of a leg."""
    _, axial, _, disc = cell_places()
    return np.asarray((axial > STRAIGHT[0]) & (axial < STRAIGHT[1]) & (disc == 0))


def eliminate(
    normal: FloatArray, rhs: FloatArray, sightings: Sequence[CellSums], surface: SurfaceModel, covariance: FloatArray,
    own: Sequence[FloatArray] | None = None, apart: FloatArray | None = None,
) -> Eliminated:  # fmt: skip
    """Eliminate the deviations of a unit's cells from its normal equations.

    Parameters
    ----------
    normal, rhs
        (p, p), (p,) of all points as if the surface had no deviations.
    sightings
        Sums by cell of each sighting.
    surface, covariance
        Of the unit's kind, and its ``covariance``.
    own
        Variances by cell of each sighting from an earlier elimination; None for the surface's.
    apart
        (CELLS,) of single cells from an earlier elimination; None for none.
    """
    rhs = rhs.copy()
    columns = len(rhs) + 1
    # of each cell its derivatives and, last, its distances
    single, scaled, whitened = (np.empty((count * CELLS, columns)) for count in (len(sightings), 1, 1))
    total = np.zeros((CELLS, columns)), np.zeros(CELLS)
    form, seen = 0.0, 0
    variances = own or [surface.own_of(sums) for sums in sightings]
    for sums, variance in zip(sightings, variances, strict=True):
        seen, part = _set_apart((sums.rows, sums.weight, sums.rhs), variance, surface.mean, rhs, single, seen, total)
        form += part
    deviations, beyond = surface.mean.copy(), np.zeros(CELLS)
    lone = np.zeros(CELLS) if apart is None else apart
    count = _whiten(covariance, total, scaled, whitened, deviations, lone, beyond)
    single, scaled, whitened = single[:seen], scaled[:count], whitened[:count]
    # with W the weights of the cells, W^1/2 (W + K^-1)^-1 W^1/2 = I - (I + W^1/2 K W^1/2)^-1
    change = whitened.T @ whitened - scaled.T @ scaled - single.T @ single
    contradictions = tuple(np.empty(CELLS) for _ in sightings)
    for sums, result in zip(sightings, contradictions, strict=True):
        _contradict((sums.weight, sums.rhs, sums.square), sums.noise, deviations, surface.own, surface.uneven, straight_cells(), result)
    return Eliminated(
        normal=normal + change[:-1, :-1],
        rhs=rhs + change[:-1, -1],
        deviations=deviations,
        own=contradictions,
        apart=beyond,
        misfit=form + float(change[-1, -1]),
        seen=seen,
    )


@kernel(releases=True)
def _set_apart(sums: Any, variance: Any, mean: Any, rhs: Any, single: Any, seen: int, total: Any) -> Any:
    """What the deviations that do not come back, of (CELLS,) ``variance``, take from the equations of one sighting, and what they leave.

    Parameters
    ----------
    sums
        ``rows``, ``weight`` and ``rhs`` of :class:`CellSums`.
    mean
        (CELLS,) of the mould, against which distances are judged: the right-hand side ``rhs`` (p,) is changed for it.
    single, seen
        (n, p + 1) where to write, from row ``seen`` on, roots of what is taken.
    total
        (CELLS, p + 1) and (CELLS,) derivatives with distances and weights, to which what is left of each cell is added.

    Returns
    -------
    seen, form
        The next row, and the quadratic form of the distances with the weights of the cells.
    """
    rows, weight, distances = sums
    left_rows, left_weight = total
    size = rows.shape[1]
    form = 0.0
    for c in range(len(weight)):
        if weight[c] <= 0.0:
            continue
        distance = distances[c] + weight[c] * mean[c]
        share = 1.0 / (weight[c] + 1.0 / variance[c])
        left, root = share / variance[c], math.sqrt(share)
        for k in range(size):
            rhs[k] += rows[c, k] * mean[c]
            single[seen, k] = root * rows[c, k]
            left_rows[c, k] += left * rows[c, k]
        single[seen, size] = root * distance
        left_rows[c, size] += left * distance
        left_weight[c] += left * weight[c]
        form += distance * distance / weight[c]
        seen += 1
    return seen, form


@kernel(releases=True)
def _whiten(covariance: Any, total: Any, scaled: Any, right: Any, deviations: Any, lone: Any, beyond: Any) -> int:
    """Columns of seen cells over the roots of their weights, and these times the inverse of the Cholesky factor of I + W^1/2 K W^1/2, leg
    by leg, as nothing ties two legs; what the last column says of the deviations is added to these.

    Each cell is held against what all others say of it (leave one out): its variance is that of the scale mixture of a t distribution of
    ``OWN_DEGREES``.

    Parameters
    ----------
    covariance
        (LEG_CELLS, LEG_CELLS) of the deviations of a leg, K.
    total
        (CELLS, q) columns of all cells, and (CELLS,) their weights.
    scaled, right
        (CELLS, q) for both results, one row for each of the cells that are seen.
    deviations
        (CELLS,) of the mould.
    lone, beyond
        (CELLS,) variance of single cells beyond K so far, and as this elimination finds it.

    Returns
    -------
    count
        How many cells are seen.
    """
    rows, weight = total
    columns = rows.shape[1]
    cells, root = np.empty(len(weight), dtype=np.int64), np.empty(len(weight))
    start = 0
    for first in range(0, len(weight), LEG_CELLS):
        stop = start
        for c in range(LEG_CELLS):
            if weight[first + c] > 0.0:
                cells[stop], root[stop] = c, math.sqrt(weight[first + c])
                for k in range(columns):
                    scaled[stop, k] = rows[first + c, k] / root[stop]
                    right[stop, k] = scaled[stop, k]
                stop += 1
        factor = np.empty((stop - start, stop - start))
        for a in range(stop - start):
            for b in range(a + 1):
                factor[a, b] = root[start + a] * covariance[cells[start + a], cells[start + b]] * root[start + b]
            factor[a, a] += 1.0 + root[start + a] ** 2 * lone[first + cells[start + a]]
        factorise(factor)
        own = right[start:stop]
        whiten_columns(factor, own)
        solved = own[:, columns - 1].copy()
        substitute_back(factor, solved)
        inverse = inverse_diagonal(factor)
        for a in range(stop - start):
            cell, precision = first + cells[start + a], root[start + a] * inverse[a]
            known = 1.0 / (root[start + a] * precision) - lone[cell]
            left = solved[a] / precision
            beyond[cell] = known * max((left * left / known - 1.0) / (OWN_DEGREES + 1.0), 0.0)
        for a in range(stop - start):
            solved[a] *= root[start + a]
            deviations[first + cells[start + a]] -= lone[first + cells[start + a]] * solved[a]
            # the covariance is symmetric: its rows lie as they are read
            for c in range(LEG_CELLS):
                deviations[first + c] -= covariance[cells[start + a], c] * solved[a]
        start = stop
    return start


@kernel(releases=True)
def _contradict(sums: Any, noise: Any, deviations: Any, own: Any, uneven: Any, straight: Any, result: Any) -> None:
    """(CELLS,) variance of what does not come back in the cells of a sighting into ``result``, as :meth:`SurfaceModel.own_of` but for what
    contradicts the ``deviations``: by the scale mixture of a t distribution of ``OWN_DEGREES``."""
    weight, distances, square = sums
    for c in range(len(weight)):
        result[c] = own
        if weight[c] > 0.0:
            distance = -distances[c] / weight[c]
            within = max(square[c] / weight[c] - distance * distance - noise * noise, 0.0)
            result[c] += (uneven[0] if straight[c] else uneven[1]) * within
            left = distance - deviations[c]
            left *= left / (result[c] + 1.0 / weight[c])
            result[c] *= max((OWN_DEGREES + left) / (OWN_DEGREES + 1.0), 1.0)
