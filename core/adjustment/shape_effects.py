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
        """(CELLS, CELLS) square metres."""
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
def structures() -> FloatArray:
    """(len(COMPONENTS), CELLS, CELLS) correlation of the cells by component."""
    leg, axial, azimuth, disc = cell_places()
    same_leg = leg[:, None] == leg
    side = same_leg & (disc[:, None] + disc == 0)
    end = same_leg & (disc[:, None] * disc == 1)
    turned = azimuth[:, None] - azimuth
    along = (axial - 0.55) / 0.3
    lever = np.outer(along, along)
    # a leg is about a third as thick as it is long
    apart = np.hypot(axial[:, None] - axial, 2 * 0.32 * np.sin(0.5 * turned))
    return np.stack(
        [
            side * 1.0,
            side * lever,
            side * np.cos(turned),
            side * lever * np.cos(turned),
            side * np.cos(2 * turned),
            end * 1.0,
            end * np.cos(turned),
            side * np.exp(-0.5 * (apart / PATCH_LENGTH) ** 2),
            np.eye(CELLS),
        ]
    )


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
    normal, rhs = normal.copy(), rhs.copy()
    size = len(rhs)
    rows, weight, cell_rhs = np.zeros((CELLS, size)), np.zeros(CELLS), np.zeros(CELLS)
    misfit, seen = 0.0, 0
    variances = own or [surface.own_of(sums) for sums in sightings]
    for sums, variance in zip(sightings, variances, strict=True):
        cells = np.flatnonzero(sums.weight > 0)
        r, w, v = sums.rows[cells], sums.weight[cells], variance[cells]
        # distances are judged against the mould
        b = sums.rhs[cells] + w * surface.mean[cells]
        rhs += r.T @ surface.mean[cells]
        share = 1 / (w + 1 / v)
        normal -= (r * share[:, None]).T @ r
        rhs -= r.T @ (share * b)
        # what is left of a cell once its own deviation in this sighting is taken away
        left = share / v
        misfit += float(np.sum(left * b**2 / w))
        seen += len(cells)
        rows[cells] += r * left[:, None]
        weight[cells] += w * left
        cell_rhs[cells] += b * left
    cells = np.flatnonzero(weight > 0)
    root = np.sqrt(weight[cells])
    scaled = rows[cells] / root[:, None]
    target = cell_rhs[cells] / root
    # W^1/2 (W + K^-1)^-1 W^1/2 = I - (I + W^1/2 K W^1/2)^-1, with W the weights of the cells
    whitened, deviations = np.column_stack([scaled, target]), surface.mean.copy()
    lone = np.zeros(CELLS) if apart is None else apart
    beyond = np.zeros(CELLS)
    _whiten(covariance, cells, root, whitened, deviations, lone, beyond)
    taken, left = whitened[:, :-1], whitened[:, -1]
    contradictions = tuple(_contradicted(sums, deviations, surface.own_of(sums)) for sums in sightings)
    return Eliminated(
        normal=normal - scaled.T @ scaled + taken.T @ taken,
        rhs=rhs - scaled.T @ target + taken.T @ left,
        deviations=deviations,
        own=contradictions,
        apart=beyond,
        misfit=misfit - float(target @ target) + float(left @ left),
        seen=seen,
    )


@kernel(releases=True)
def _whiten(covariance: Any, cells: Any, root: Any, right: Any, deviations: Any, lone: Any, beyond: Any) -> None:
    """Right-hand sides in place times the inverse of the Cholesky factor of I + W^1/2 K W^1/2, leg by leg, as nothing ties two legs; what
    the last of them says of the deviations is added to these.

    Each cell is held against what all others say of it (leave one out): its variance is that of the scale mixture of a t distribution of
    ``OWN_DEGREES``.

    Parameters
    ----------
    covariance
        (CELLS, CELLS) of the deviations, K.
    cells, root
        (n,) cells that are seen, ascending, and the roots of their weights.
    right
        (n, q) right-hand sides.
    deviations
        (CELLS,) of the mould.
    lone, beyond
        (CELLS,) variance of single cells beyond K so far, and as this elimination finds it.
    """
    count, columns = right.shape
    start = 0
    while start < count:
        leg = cells[start] // LEG_CELLS
        stop = start
        while stop < count and cells[stop] // LEG_CELLS == leg:
            stop += 1
        factor = np.empty((stop - start, stop - start))
        for a in range(stop - start):
            for b in range(a + 1):
                factor[a, b] = root[start + a] * covariance[cells[start + a], cells[start + b]] * root[start + b]
            factor[a, a] += 1.0 + root[start + a] ** 2 * lone[cells[start + a]]
        factorise(factor)
        own = right[start:stop]
        whiten_columns(factor, own)
        solved = own[:, columns - 1].copy()
        substitute_back(factor, solved)
        inverse = inverse_diagonal(factor)
        for a in range(stop - start):
            cell, precision = cells[start + a], root[start + a] * inverse[a]
            known = 1.0 / (root[start + a] * precision) - lone[cell]
            left = solved[a] / precision
            beyond[cell] = known * max((left * left / known - 1.0) / (OWN_DEGREES + 1.0), 0.0)
        for a in range(stop - start):
            solved[a] *= root[start + a]
            deviations[cells[start + a]] -= lone[cells[start + a]] * solved[a]
        for c in range(leg * LEG_CELLS, (leg + 1) * LEG_CELLS):
            for a in range(stop - start):
                deviations[c] -= covariance[c, cells[start + a]] * solved[a]
        start = stop


def _contradicted(sums: CellSums, deviations: FloatArray, own: FloatArray) -> FloatArray:
    """(CELLS,) variance of what does not come back, by the scale mixture of a t distribution of ``OWN_DEGREES``."""
    seen = sums.weight > 0
    result = own.copy()
    left = -sums.rhs[seen] / sums.weight[seen] - deviations[seen]
    square = left**2 / (own[seen] + 1 / sums.weight[seen])
    result[seen] = own[seen] * np.maximum((OWN_DEGREES + square) / (OWN_DEGREES + 1), 1.0)
    return result
