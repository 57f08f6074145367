"""Mould and variances of castings, learned from the cells of the units of a survey (:mod:`.shape_effects`).

Variances are estimated by restricted maximum likelihood (Patterson and Thompson, 1971, Biometrika 58, 545-554) from the means of the cells,
the poses projected out, with the minorisation-maximisation steps of Zhou et al. (2019, J. Comput. Graph. Stat. 28, 350-361), which stay
positive. A scaled inverse chi-square prior with few degrees of freedom holds them where a survey is too small to tell: castings that are
truer than is customary in what it tells are taken to be so in all (a scale of the prior, found from the variances: empirical Bayes). Mould
and mean size follow by generalised least squares under these variances; of too few units no mould is learned.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..common.kernels import kernel, side_by_side
from ..common.positive_definite import factorise, inverse_factor, whiten_columns
from ..model.mould import AXIAL_CELLS, AZIMUTH_CELLS, DISC_CELLS
from .shape_effects import (
    COMPONENTS,
    LEG_CELLS,
    CellSums,
    SurfaceModel,
    prior_surface,
    straight_cells,
    structures,
)

PRIOR_DEGREES = 4.0
"""Degrees of freedom of the prior of each variance: it weighs as much as so many effects that were seen."""
CUSTOMARY_WEIGHT = 0.05
"""What the customary size of castings' deviations weighs beside one smooth component that is well told, where a survey shows how true its
own castings are: enough to begin with (chosen on four surveys of ideal cones, which a quarter leaves twice as wide as they err)."""
STORED_DEGREES = 20.0
"""The same where an earlier survey has told them: of the same moulds, but worn and grown over by now."""
LEAST_CELLS = 16
"""Cells beyond the unknowns of its poses from which a unit takes part."""
MOST_CELLS = 120
"""Cells of a unit that are used, spread evenly."""
MAX_STEPS = 12
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
    """Means of n cells of one unit, leg by leg.

    Attributes
    ----------
    distances
        (n,) of the means, as if the unit had its nominal size, metres.
    cells, first
        (n,) cell of each, and (5,) where the cells of each leg begin, and where the last one's end.
    known
        (n,) variance of each mean whatever the castings are, and (n,) of what its cell has beyond them in all sightings.
    doubt
        (3, n) by what the variances ``OWN``, ``STRAIGHT`` and ``ENDS`` are multiplied.
    unknowns
        (q, n) an orthonormal basis of what poses reach, and last the derivatives by the unit's size, of which a variance is known.
    """

    distances: FloatArray
    cells: IntArray
    first: IntArray
    known: tuple[FloatArray, FloatArray]
    doubt: FloatArray
    unknowns: FloatArray

    def projector(self, values: FloatArray, covariance: FloatArray) -> FloatArray:
        """(n, n) inverse of the covariance of the distances within the space that poses do not reach, zero in what they do.

        ``values`` are the variances, and ``covariance`` what those of ``COMPONENTS`` make of the cells of a leg.
        """
        result, told = np.zeros((len(self.distances), len(self.distances))), np.zeros_like(self.unknowns)
        noise, apart = self.known
        own = noise + values[OWN:SIZE] @ self.doubt
        places = self.cells % LEG_CELLS, self.first
        _project(covariance, places, (own, apart), (self.unknowns, 1 / values[SIZE]), (result, told))
        result -= told.T @ told
        return result

    def beside(self, mould: FloatArray) -> FloatArray:
        """(n,) distances from a mould, (MOULD_CELLS + 1,) its cells and the mean size."""
        return np.asarray(self.distances - mould[mould_cells()[self.cells]] + mould[-1] * self.unknowns[-1])


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
        for a, t in side_by_side(partial(_scores, values=values, covariance=_of_components(values), mould=mould), observed):
            forms += a
            traces += t
        held = base if stored is not None else _as_true(base, values, traces)
        new = values * np.sqrt((forms + degrees * held / values**2) / (traces + degrees / values))
        settled = np.max(np.abs(np.log(new / values))) < LEAST_CHANGE
        values = new
        if settled:
            break
    own, straight, ends, size = (float(v) for v in values[-4:])
    values[SHORT_RANGE] *= PATCH_TAILS**2
    return SurfaceModel(mould[mould_cells()], values[:-4], own, (straight, ends), float(mould[-1]), math.sqrt(size), len(observed))


def _as_true(customary: FloatArray, values: FloatArray, traces: FloatArray) -> FloatArray:
    """Variances that the prior holds the present ``values`` to: of components, ``customary`` ones, or less where these castings are truer.

    Each smooth component says by how much it is off, as far as the survey tells it: by the degrees of freedom that are left of its
    (len(values),) ``traces``, beside those of the prior. Without that the customary variances hold up those of ideal cones, of which
    every single one is told by a few degrees of freedom only where it is far below the noise.
    """
    smooth = slice(0, SHORT_RANGE[0])
    told = traces[smooth] * values[smooth]
    weights = told / (told + PRIOR_DEGREES)
    share = (weights @ (values[smooth] / customary[smooth]) + CUSTOMARY_WEIGHT) / (weights.sum() + CUSTOMARY_WEIGHT)
    held = customary.copy()
    # one component that is far off, as in a worn series, says nothing of the others
    held[:OWN] *= min(1.0, share)
    return held


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
    covariance = _of_components(values)
    for o in observed:
        design = np.column_stack([np.eye(MOULD_CELLS)[mould_cells()[o.cells]], -o.unknowns[-1]])
        weighted = design.T @ o.projector(values, covariance)
        normal += weighted @ design
        rhs += weighted @ o.distances
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
    # sightings are summed up one after the other, legs are what is eliminated together
    by_leg = np.argsort(where // LEG_CELLS, kind="stable")
    where, columns = where[by_leg], columns[chosen[by_leg]]
    distance, noise, doubt, uneven = columns[:, :4].T
    basis, _ = np.linalg.qr(columns[:, 4:-1])
    size, straight = columns[:, -1], straight_cells()[where]
    return _Observed(
        distances=distance - unit.scale * size,
        cells=where,
        first=np.searchsorted(where // LEG_CELLS, np.arange(5)),
        known=(noise, np.zeros(len(where)) if unit.apart is None else unit.apart[where]),
        doubt=np.stack([doubt, doubt * uneven * straight, doubt * uneven * ~straight]),
        unknowns=np.vstack([basis.T, size]),
    )


def _columns(sums: CellSums, own: FloatArray, seen: IntArray, surface: SurfaceModel) -> FloatArray:
    """(m, 4 + p) mean distance of the seen cells, its noise variance, the factor by which a cell is doubted, its unevenness, and its
    derivatives by the unknowns."""
    weight = sums.weight[seen]
    doubt = own[seen] / surface.own_of(sums)[seen]
    means = [-sums.rhs[seen] / weight, 1 / weight, doubt, sums.uneven[seen]]
    return np.column_stack([*means, sums.rows[seen] / weight[:, None]])


def _of_components(values: FloatArray) -> FloatArray:
    """(LEG_CELLS, LEG_CELLS) covariance of the cells of a leg by variances of which the first are those of ``COMPONENTS``."""
    return np.asarray(np.tensordot(values[:OWN], structures(), axes=1))


@lru_cache(maxsize=1)
def _structures_by_cells() -> FloatArray:
    """(LEG_CELLS, LEG_CELLS, len(COMPONENTS)) :func:`.shape_effects.structures`, those of two cells beside each other."""
    return np.ascontiguousarray(np.moveaxis(structures(), 0, -1))


def _scores(o: _Observed, values: FloatArray, covariance: FloatArray, mould: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Quadratic forms y' P K_j P y and traces of P K_j by variance."""
    p = o.projector(values, covariance)
    py = p @ o.beside(mould)
    size = o.unknowns[-1]
    forms, traces = np.zeros(len(values)), np.zeros(len(values))
    _add_scores(p, py, o.cells % LEG_CELLS, o.first, _structures_by_cells(), forms, traces)
    forms[OWN:SIZE], traces[OWN:SIZE] = o.doubt @ py**2, o.doubt @ np.diag(p)
    forms[SIZE], traces[SIZE] = (size @ py) ** 2, size @ p @ size
    return forms, traces


@kernel(releases=True)
def _project(covariance: Any, places: Any, variances: Any, asked: Any, found: Any) -> None:
    """V^-1 and L^-1 Z' V^-1 with L L' = Z' V^-1 Z + D into ``found``, (n, n) and (q, n), which hold zeros.

    Nothing but what is unknown ties two legs, so that V falls apart into theirs.

    Parameters
    ----------
    covariance
        (LEG_CELLS, LEG_CELLS) of the cells of a leg.
    places
        (n,) which of these each mean is of, and (5,) where those of each leg begin.
    variances
        (n,) of single means, and of what all means of one cell have in common.
    asked
        Z' (q, n), and what D holds for the last of it alone.
    """
    cells, first = places
    own, apart = variances
    unknowns, weight = asked
    inverse, told = found
    count = len(unknowns)
    for leg in range(4):
        start, size = first[leg], first[leg + 1] - first[leg]
        factor, roots = np.empty((size, size)), np.zeros((size, size))
        # of this leg alone: loops whose places begin at 0 run in vector registers
        block, line = np.zeros((size, size)), np.empty(size)
        for a in range(size):
            for b in range(a + 1):
                factor[a, b] = covariance[cells[start + a], cells[start + b]]
                if cells[start + a] == cells[start + b]:
                    factor[a, b] += apart[start + a]
            factor[a, a] += own[start + a]
        factorise(factor)
        inverse_factor(factor, roots)
        for k in range(size):
            for a in range(k + 1):
                for b in range(k + 1):
                    block[a, b] += roots[k, a] * roots[k, b]
        for a in range(size):
            for b in range(size):
                inverse[start + a, start + b] = block[a, b]
        for q in range(count):
            line[:] = 0.0
            for a in range(size):
                for b in range(size):
                    line[b] += unknowns[q, start + a] * block[a, b]
            for b in range(size):
                told[q, start + b] = line[b]
    system = np.zeros((count, count))
    for q in range(count):
        for r in range(q + 1):
            for a in range(len(cells)):
                system[q, r] += told[q, a] * unknowns[r, a]
    system[count - 1, count - 1] += weight
    factorise(system)
    whiten_columns(system, told)


@kernel(releases=True)
def _add_scores(p: Any, py: Any, cells: Any, first: Any, structures: Any, forms: Any, traces: Any) -> None:
    """Quadratic forms and traces of the components, (LEG_CELLS, LEG_CELLS, k) by cells, added to ``forms`` and ``traces`` of (n, n) ``p``
    and (n,) ``py``; cells and legs as in :func:`_project`."""
    for leg in range(4):
        for a in range(first[leg], first[leg + 1]):
            for b in range(first[leg], a + 1):
                times = 1.0 if a == b else 2.0
                form, trace = times * py[a] * py[b], times * p[a, b]
                for k in range(structures.shape[2]):
                    forms[k] += form * structures[cells[a], cells[b], k]
                    traces[k] += trace * structures[cells[a], cells[b], k]
