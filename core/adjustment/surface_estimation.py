"""Mould and variances of castings, learned from the cells of the units of a survey (:mod:`.shape_effects`).

Variances are estimated by restricted maximum likelihood (Patterson and Thompson, 1971, Biometrika 58, 545-554) from the means of the cells,
the poses projected out, with the minorisation-maximisation steps of Zhou et al. (2019, J. Comput. Graph. Stat. 28, 350-361), which stay
positive. A scaled inverse chi-square prior with few degrees of freedom holds them where a survey is too small to tell. Mould and mean
size follow by generalised least squares under these variances; of too few units no mould is learned.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache, partial

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..common.kernels import side_by_side
from ..common.positive_definite import inverse
from ..model.mould import AXIAL_CELLS, AZIMUTH_CELLS, DISC_CELLS
from .shape_effects import (
    COMPONENTS,
    LEG_CELLS,
    CellSums,
    SurfaceModel,
    prior_surface,
    smooth_factors,
    straight_cells,
    structures,
)

PRIOR_DEGREES = 4.0
"""Degrees of freedom of the prior of each variance: it weighs as much as so many effects that were seen."""
STORED_DEGREES = 20.0
"""The same where an earlier survey has told them: of the same moulds, but worn and grown over by now."""
LEAST_CELLS = 16
"""Cells beyond the unknowns of its poses from which a unit takes part."""
MOST_CELLS = 120
"""Cells of a unit that are used, spread evenly."""
MAX_STEPS = 20
MOULD_STEPS = 5
"""Steps of the variances between two estimates of the mould."""
LEAST_CHANGE = 0.02
"""Relative change of a variance below which it stands."""
MOULD_CELLS = AXIAL_CELLS * AZIMUTH_CELLS // 3 + 1
"""Cells of a mould: along a leg and around a third of it, all legs and thirds being alike, and the end disc."""
LEAST_MOULD_UNITS = 4
OWN, STRAIGHT, ENDS, SIZE = range(len(COMPONENTS), len(COMPONENTS) + 4)
"""Places of the variances of what does not come back, of its shares, and of the size, after those of the components."""
SHORT_RANGE = [COMPONENTS.index("patch"), COMPONENTS.index("spot")]
WHOLE = [*SHORT_RANGE, OWN, STRAIGHT, ENDS]
"""Variances that multiply matrices of full rank."""
PATCH_TAILS = 2.0
"""Factor of the standard deviation of what is left from patch to patch: chips, fins and fillets make it long-tailed. Chosen on real units
seen from sides drawn anew (``benchmarks/accuracy/real_views.py``), beside two factors derived from surveys; simulated castings do not
mind."""
MOULD_SD = 0.004
"""Prior standard deviation of the mould, as a share of the height: a dimple of 11 mm at 2.9 m."""
MOULD_LENGTH = 0.15
"""Length over which a mould changes, as a share of the leg."""
STRAIGHT_SD = 3e-5
"""Standard deviation, as a share of the height, to which the straight part of the mould is the nominal cone on average."""
SIZE_MEAN_SD = 0.02
"""Prior relative standard deviation of the mean size."""


@dataclass(frozen=True, eq=False)
class SampledUnit:
    """A unit from whose cells a surface is learned.

    Attributes
    ----------
    scale
        Its present relative size less one.
    sightings
        Sums by cell; the unknowns are six of each sighting's pose and, last, the unit's size.
    own
        By sighting, variances of what does not come back, see :class:`.shape_effects.Eliminated`.
    apart
        (CELLS,) variances of single cells, as there; None for none.
    """

    scale: float
    sightings: Sequence[CellSums]
    own: Sequence[FloatArray]
    apart: FloatArray | None = None


@dataclass(frozen=True, eq=False)
class _Observed:
    """Means of the cells of one unit, poses projected out by an orthonormal basis of the space that they do not reach.

    ``values`` (m,), their ``noise`` (m, m), ``factors`` (m, r) of what the variances of :func:`_factored` multiply, ``parts`` (v, m, m)
    that those of ``WHOLE`` multiply, and what the mould's cells and the mean size add, ``mould`` (m, MOULD_CELLS + 1).
    """

    values: FloatArray
    noise: FloatArray
    factors: FloatArray
    parts: FloatArray
    mould: FloatArray

    def covariance(self, variances: FloatArray) -> FloatArray:
        """(m, m) of the values."""
        scaled = self.factors * np.sqrt(variances[_factored()])
        result = np.tensordot(variances[WHOLE], self.parts, axes=1)
        result += scaled @ scaled.T
        result += self.noise
        return np.asarray(result)


def estimate_surface(
    units: Sequence[SampledUnit], height: float, surface: SurfaceModel, stored: SurfaceModel | None = None
) -> SurfaceModel:
    """Learn the surface of a kind of unit.

    Parameters
    ----------
    units
        The best-seen ones.
    height
        Of the units, metres.
    surface
        What was known of it when their cells were summed up; the search starts from its variances.
    stored
        What an earlier survey says of the kind: its mould is held, its variances are the prior of these.
    """
    prior = stored or prior_surface(height)
    degrees = PRIOR_DEGREES if stored is None else STORED_DEGREES
    observed = [o for o in side_by_side(partial(_observations, surface=surface), units) if o is not None]
    if not observed:
        return prior
    # order of the variances: components, own, its shares, size
    base = np.concatenate([prior.variances, [prior.own, *prior.uneven, prior.size_sd**2]])
    if stored is not None:
        # a stored mould states them with their tails
        base[SHORT_RANGE] /= PATCH_TAILS**2
    values = np.concatenate([surface.variances, [surface.own, *surface.uneven, surface.size_sd**2]])
    learns = stored is None and len(observed) >= LEAST_MOULD_UNITS
    mould = np.zeros(MOULD_CELLS + 1) if stored is None else _cells_of(stored)
    for step in range(MAX_STEPS):
        if learns and step % MOULD_STEPS == 0:
            mould = _mould(observed, values, height)
        forms, traces = np.zeros(len(values)), np.zeros(len(values))
        for a, t in side_by_side(partial(_scores, values=values, mould=mould), observed):
            forms += a
            traces += t
        new = values * np.sqrt((forms + degrees * base / values**2) / (traces + degrees / values))
        settled = np.max(np.abs(np.log(new / values))) < LEAST_CHANGE
        values = new
        if settled:
            break
    own, straight, ends, size = (float(v) for v in values[-4:])
    values[SHORT_RANGE] *= PATCH_TAILS**2
    return SurfaceModel(mould[mould_cells()], values[:-4], own, (straight, ends), float(mould[-1]), math.sqrt(size), len(observed))


def _cells_of(stored: SurfaceModel) -> FloatArray:
    """(MOULD_CELLS + 1,) deviations and, last, mean size of a stored surface."""
    result = np.zeros(MOULD_CELLS + 1)
    result[mould_cells()] = stored.mean
    result[-1] = stored.size_mean
    return result


@lru_cache(maxsize=1)
def mould_cells() -> IntArray:
    """(CELLS,) cell of the mould of every cell: the same on all legs, and three times around each."""
    ring, turn = np.divmod(np.arange(AXIAL_CELLS * AZIMUTH_CELLS), AZIMUTH_CELLS)
    third = AZIMUTH_CELLS // 3
    return np.tile(np.concatenate([ring * third + turn % third, np.full(DISC_CELLS, MOULD_CELLS - 1)]), 4)


@lru_cache(maxsize=1)
def _mould_prior() -> FloatArray:
    """(MOULD_CELLS, MOULD_CELLS) correlation of the mould's deviations: smooth along a leg and around it."""
    third = AZIMUTH_CELLS // 3
    ring, turn = np.divmod(np.arange(MOULD_CELLS - 1), third)
    along = (ring[:, None] - ring) / (AXIAL_CELLS * MOULD_LENGTH)
    around = 2 * np.pi * (turn[:, None] - turn) / third
    result = np.eye(MOULD_CELLS)
    # the part that is the same all around is the larger one
    result[:-1, :-1] = np.exp(-0.5 * along**2) * (0.9 + 0.1 * np.cos(around))
    return result + 1e-4 * np.eye(MOULD_CELLS)


def _mould(observed: Sequence[_Observed], values: FloatArray, height: float) -> FloatArray:
    """(MOULD_CELLS + 1,) deviations and, last, size common to all units, by generalised least squares under the variances."""
    normal, rhs = np.zeros((MOULD_CELLS + 1, MOULD_CELLS + 1)), np.zeros(MOULD_CELLS + 1)
    normal[:-1, :-1] = np.linalg.inv(_mould_prior() * (MOULD_SD * height) ** 2)
    # a leg that is thicker all along is a larger unit: the straight part of the mould is the nominal cone
    straight = np.unique(mould_cells()[straight_cells()])
    normal[np.ix_(straight, straight)] += 1 / (len(straight) * STRAIGHT_SD * height) ** 2
    normal[-1, -1] = 1 / SIZE_MEAN_SD**2
    for o in observed:
        weighted = np.linalg.solve(o.covariance(values), np.column_stack([o.mould, o.values]))
        normal += o.mould.T @ weighted[:, :-1]
        rhs += o.mould.T @ weighted[:, -1]
    return np.asarray(np.linalg.solve(normal, rhs))


def _observations(unit: SampledUnit, surface: SurfaceModel) -> _Observed | None:
    poses = 6 * len(unit.sightings)
    cells = [np.flatnonzero(own.weight > 0) for own in unit.sightings]
    count = sum(len(c) for c in cells)
    if count < LEAST_CELLS + poses:
        return None
    parts = zip(unit.sightings, unit.own, cells, strict=True)
    columns = np.vstack([_columns(sums, own, seen, surface) for sums, own, seen in parts])
    chosen = np.arange(0, count, -(-count // MOST_CELLS))
    where = np.concatenate(cells)[chosen]
    distance, noise, doubt, uneven = columns[chosen, :4].T
    design, size = columns[chosen, 4:-1], columns[chosen, -1]
    basis, _ = np.linalg.qr(design, mode="complete")
    free = basis[:, poses:]
    straight = straight_cells()[where]
    leg, place = np.divmod(where, LEG_CELLS)
    same_leg = leg[:, None] == leg
    kernels = [free.T @ (same_leg * structures()[k][np.ix_(place, place)]) @ free for k in SHORT_RANGE]
    kernels += [free.T @ (d[:, None] * free) for d in (doubt, doubt * uneven * straight, doubt * uneven * ~straight)]
    each_leg = [(leg[:, None] == k) * np.hstack(smooth_factors())[place] for k in range(4)]
    factors = free.T @ np.column_stack([*each_leg, size])
    mould = free.T @ np.column_stack([np.eye(MOULD_CELLS)[mould_cells()[where]], -size])
    known = np.diag(noise)
    if unit.apart is not None:
        known += np.where(where[:, None] == where, unit.apart[where], 0.0)
    # as if the unit had its nominal size
    return _Observed(free.T @ (distance - unit.scale * size), free.T @ known @ free, factors, np.stack(kernels), mould)


def _columns(sums: CellSums, own: FloatArray, seen: IntArray, surface: SurfaceModel) -> FloatArray:
    """(m, 4 + p) mean distance of the seen cells, its noise variance, the factor by which a cell is doubted, its unevenness, and its
    derivatives by the unknowns."""
    weight = sums.weight[seen]
    doubt = own[seen] / surface.own_of(sums)[seen]
    means = [-sums.rhs[seen] / weight, 1 / weight, doubt, sums.uneven[seen]]
    return np.column_stack([*means, sums.rows[seen] / weight[:, None]])


@lru_cache(maxsize=1)
def _factored() -> IntArray:
    """(r,) place of the variance of each column of factors."""
    counts = [columns.shape[1] for columns in smooth_factors()]
    return np.append(np.tile(np.repeat(np.arange(len(counts)), counts), 4), SIZE)


def _scores(o: _Observed, values: FloatArray, mould: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Quadratic forms y' P K_j P y and traces of P K_j by variance."""
    p = inverse(o.covariance(values))
    py = p @ (o.values - o.mould @ mould)
    forms, traces = np.zeros(len(values)), np.zeros(len(values))
    np.add.at(forms, _factored(), (o.factors.T @ py) ** 2)
    np.add.at(traces, _factored(), np.sum(o.factors * (p @ o.factors), axis=0))
    forms[WHOLE], traces[WHOLE] = (o.parts @ py) @ py, o.parts.reshape(len(WHOLE), -1) @ p.ravel()
    return forms, traces
