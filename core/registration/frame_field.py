"""Frames that bend: the error of an epoch's cloud as a rigid motion and a smooth vector field over the ground.

    e(x) = t + w x (x - x0) + g(x),   g ~ GP(0, diag(s_e^2, s_n^2, s_h^2) k(x, x'))

with k a Matern correlation of the horizontal places (Rasmussen and Williams, 2006, Gaussian Processes for Machine Learning, 4.2),
longer across the structure than along it where the survey says so. The field lives on the nodes of a regular grid over the units and
targets, between which it is interpolated by cubic convolution (Keys, 1981, IEEE ASSP 29(6)); kriging is then a linear adjustment of
the nodes with their covariance as prior (Wackernagel, 2003, Multivariate Geostatistics), and the effort follows the area and not the
observations.

Everything is in the control frame less one reduction point, in metres and radians.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from scipy.linalg import cho_factor, cho_solve, lu_factor, lu_solve
from scipy.linalg.lapack import dpotri
from scipy.sparse import coo_array, csr_array

from ..common.arrays import FloatArray, IntArray
from .transformation import rigid_jacobian

FINEST, COARSEST = 0.15, 0.5
"""Bounds of the distance of the nodes over the correlation length."""
MOST_NODES = 1500
"""Nodes above which the grid is made coarser: unknowns are inverted as one matrix."""
NUGGET = 1e-6
"""Share of the variance that every node has for itself, so that correlations of smooth fields can be inverted."""
RIGID = 6
"""Columns of the rigid motion: shift, then rotation vector."""
FREE_SHIFT, FREE_TURN = 10.0, 0.1
"""Standard deviations, metres and radians, of what is left of a rigid motion of which nothing is known once clouds are aligned."""
TAPS = 4
PLACES_AT_A_TIME = 64
"""Places whose covariances are formed at once: together they hold less than the processor's caches."""
MIRRORED = 256
"""Rows of a symmetric matrix whose lower half is filled in at a time."""


@dataclass(frozen=True, kw_only=True)
class FieldModel:
    """How an epoch (or the difference of two) bends.

    Attributes
    ----------
    sds
        Standard deviations of e, n, h in metres; zero for a component that does not bend.
    length, across
        Correlation lengths along and across the structure, metres.
    axis
        Direction of the structure in the plane, unit vector (e, n).
    smoothness
        1.5 or 2.5: how often the field can be differentiated, plus a half.
    """

    sds: tuple[float, float, float]
    length: float
    across: float
    axis: tuple[float, float]
    smoothness: float = 2.5

    def scaled(self, places: FloatArray) -> FloatArray:
        """(k, 2) places along and across the structure in correlation lengths, of (k, 2 or 3) points."""
        a, b = self.axis
        x, y = places[:, 0], places[:, 1]
        return np.column_stack([(a * x + b * y) / self.length, (a * y - b * x) / self.across])

    def correlation(self, first: FloatArray, second: FloatArray) -> FloatArray:
        """(k, m) correlation of the field at (k, 2) and (m, 2) scaled places."""
        r = np.sqrt(np.sum((first[:, None] - second[None]) ** 2, axis=2))
        return matern(r, self.smoothness)

    def times(self, factor: float) -> FieldModel:
        """The same with standard deviations times a factor."""
        return FieldModel(
            sds=(self.sds[0] * factor, self.sds[1] * factor, self.sds[2] * factor),
            length=self.length, across=self.across, axis=self.axis, smoothness=self.smoothness,
        )  # fmt: skip


def spacing_for(model: FieldModel, resolution: float) -> float:
    """Distance of nodes over the correlation length for an interpolation error of ``resolution`` metres.

    Measured on random fields: about 0.5 sd h^2.5 for smoothness 2.5 and 0.45 sd h^1.5 for 1.5, h the distance over the length.
    """
    share = resolution / max(0.5 * max(model.sds), 1e-9)
    return float(min(max(share ** (1 / model.smoothness), FINEST), COARSEST))


def matern(r: FloatArray, smoothness: float) -> FloatArray:
    """Matern correlation at distances in correlation lengths, for smoothness 1.5 and 2.5."""
    if smoothness == 1.5:
        s = math.sqrt(3) * r
        return np.asarray((1 + s) * np.exp(-s))
    s = math.sqrt(5) * r
    return np.asarray((1 + s + s * s / 3) * np.exp(-s))


@dataclass(frozen=True, eq=False, kw_only=True)
class FieldBasis:
    """Nodes of a field over some places, and the rows by which a point or a small body feels it.

    Attributes
    ----------
    model
        Of the field.
    origin
        (3,) point the rotation vector refers to.
    spacing
        Distance of the nodes over the correlation lengths.
    low
        (2,) scaled place of the grid's corner.
    shape
        Nodes of the whole grid along and across.
    numbers
        (shape) number of each node among those in use, -1 for the others.
    nodes
        (n, 2) scaled places of those in use.
    """

    model: FieldModel
    origin: FloatArray
    spacing: float
    low: FloatArray
    shape: tuple[int, int]
    numbers: IntArray
    nodes: FloatArray

    @classmethod
    def over(cls, model: FieldModel, points: FloatArray, resolution: float) -> FieldBasis:
        """Basis for (k, 3) points whose interpolation errs by about ``resolution`` metres where the area allows it."""
        spacing = spacing_for(model, resolution)
        while True:
            basis = cls._with_spacing(model, points, spacing)
            if len(basis.nodes) <= MOST_NODES or spacing >= COARSEST:
                return basis
            spacing *= 1.2

    @classmethod
    def _with_spacing(cls, model: FieldModel, points: FloatArray, spacing: float) -> FieldBasis:
        scaled = model.scaled(points)
        low = (np.floor(scaled.min(axis=0) / spacing) - 1) * spacing
        cell = np.floor((scaled - low) / spacing).astype(np.int64)
        shape = (int(cell[:, 0].max()) + TAPS, int(cell[:, 1].max()) + TAPS)
        used = np.zeros(shape, dtype=bool)
        for i, j in product(range(-1, TAPS - 1), repeat=2):
            used[cell[:, 0] + i, cell[:, 1] + j] = True
        numbers = np.full(shape, -1, dtype=np.int64)
        numbers[used] = np.arange(int(used.sum()))
        return cls(
            model=model,
            origin=points.mean(axis=0),
            spacing=spacing,
            low=low,
            shape=shape,
            numbers=numbers,
            nodes=np.argwhere(used) * spacing + low,
        )

    def scaled_by(self, factor: float) -> FieldBasis:
        """The same nodes for a field whose standard deviations are ``factor`` times as large."""
        return replace(self, model=self.model.times(factor))

    @property
    def size(self) -> int:
        """Number of unknowns: rigid motion, then e, n, h of every node."""
        return RIGID + 3 * len(self.nodes)

    def precision(self, rigid: FloatArray | None = None) -> FloatArray:
        """Inverse of the prior covariance of the unknowns; ``rigid`` (6, 6) of the rigid motion, or free."""
        total = np.zeros((self.size, self.size))
        free = np.diag([FREE_SHIFT**2] * 3 + [FREE_TURN**2] * 3)
        total[:RIGID, :RIGID] = np.linalg.inv(free if rigid is None else rigid)
        k = self.model.correlation(self.nodes, self.nodes) + NUGGET * np.eye(len(self.nodes))
        inverse = np.asarray(cho_solve(cho_factor(k), np.eye(len(k))))
        for axis, sd in enumerate(self.model.sds):
            part = slice(RIGID + axis, None, 3)
            # a component that does not bend is held
            total[part, part] = inverse / max(sd, 1e-6) ** 2
        return total

    def local(self, points: FloatArray) -> tuple[IntArray, FloatArray]:
        """Columns (k, 54) and rows (k, 6, 54) of shift and rotation vector that the frame's error gives a small body at (k, 3) points.

        A body in a field that varies over its size turns by half of the field's curl; its shearing is left out.

        Raises
        ------
        ValueError
            A point lies off the grid.
        """
        scaled = (self.model.scaled(points) - self.low) / self.spacing
        cell = np.floor(scaled).astype(np.int64)
        t = scaled - cell
        wx, dx = _keys(t[:, 0])
        wy, dy = _keys(t[:, 1])
        steps = np.arange(-1, TAPS - 1)
        i = cell[:, 0, None, None] + steps[None, :, None]
        j = cell[:, 1, None, None] + steps[None, None, :]
        if (i < 0).any() or (j < 0).any() or (i >= self.shape[0]).any() or (j >= self.shape[1]).any():
            raise ValueError("a point lies off the field's grid")
        node = self.numbers[i, j].reshape(len(points), -1)
        if (node < 0).any():
            raise ValueError("a point lies off the field's grid")
        value = (wx[:, :, None] * wy[:, None, :]).reshape(len(points), -1)
        along = (dx[:, :, None] * wy[:, None, :]).reshape(len(points), -1) / (self.spacing * self.model.length)
        over = (wx[:, :, None] * dy[:, None, :]).reshape(len(points), -1) / (self.spacing * self.model.across)
        a, b = self.model.axis
        east, north = a * along - b * over, b * along + a * over
        columns = np.concatenate(
            [np.tile(np.arange(RIGID), (len(points), 1)), (RIGID + 3 * node[:, :, None] + np.arange(3)).reshape(len(points), -1)], axis=1
        )
        rows = np.zeros((len(points), 6, columns.shape[1]))
        rows[:, :3, :RIGID] = rigid_jacobian(points - self.origin)[:, :, :RIGID]
        rows[:, [3, 4, 5], [3, 4, 5]] = 1
        for axis in range(3):
            rows[:, axis, RIGID + axis :: 3] = value
        rows[:, 3, RIGID + 2 :: 3] = 0.5 * north
        rows[:, 4, RIGID + 2 :: 3] = -0.5 * east
        rows[:, 5, RIGID + 1 :: 3] = 0.5 * east
        rows[:, 5, RIGID::3] = -0.5 * north
        return columns, rows

    def design(self, points: FloatArray) -> csr_array:
        """(3 k, size) rows of the shift at (k, 3) points."""
        columns, rows = self.local(points)
        k, width = columns.shape
        index = np.repeat(np.arange(3 * k), width)
        where = np.repeat(columns[:, None], 3, axis=1).ravel()
        return csr_array(coo_array((rows[:, :3].ravel(), (index, where)), shape=(3 * k, self.size)))


def _keys(t: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Weights (k, 4) of the nodes at -1, 0, 1, 2 for places (k,) between 0 and 1, and their derivatives."""
    s = t[:, None]
    one = np.hstack([((-0.5 * s + 1) * s - 0.5) * s, (1.5 * s - 2.5) * s * s + 1, ((-1.5 * s + 2) * s + 0.5) * s, (0.5 * s - 0.5) * s * s])
    two = np.hstack([(-1.5 * s + 2) * s - 0.5, (4.5 * s - 5) * s, (-4.5 * s + 4) * s + 0.5, (1.5 * s - 1) * s])
    return one, two


@dataclass(frozen=True, eq=False)
class FieldEstimate:
    """What is known of a field: mean and covariance of its unknowns.

    Attributes
    ----------
    basis
        Its nodes.
    mean, covariance
        (size,), (size, size).
    """

    basis: FieldBasis
    mean: FloatArray
    covariance: FloatArray

    @classmethod
    def from_observations(
        cls, basis: FieldBasis, precision: FloatArray, points: FloatArray, values: FloatArray, weights: FloatArray,
        start: FloatArray | None = None,
    ) -> FieldEstimate:  # fmt: skip
        """Adjust the unknowns with prior ``precision`` about ``start`` (zero) to (k, 3) shifts with (k, 3, 3) weights at (k, 3) points."""
        mean = np.zeros(basis.size) if start is None else start
        information, rhs = information_of(basis, points, values, weights)
        total = np.array(precision, order="F")
        total[information.coords] += information.data
        factor = cho_factor(total, overwrite_a=True)
        # long coasts have thousands of unknowns: the inverse takes the place of the factor once that is not needed
        mean = mean + cho_solve(factor, rhs - information @ mean)
        inverse = dpotri(factor[0], lower=0, overwrite_c=1)[0]
        _mirror(inverse)
        return cls(basis, mean, inverse)

    def informed(self, information: FloatArray | coo_array, rhs: FloatArray) -> FieldEstimate:
        """What is known once independent observations are added, by their (size, size) normal matrix and (size,) right-hand side."""
        covariance = symmetric_part(solved(self.covariance @ information, np.array(self.covariance, order="F")))
        return FieldEstimate(self.basis, self.mean + covariance @ (rhs - information @ self.mean), covariance)

    def at(self, points: FloatArray) -> LocalMotions:
        """Shift and turn at (k, 3) points."""
        columns, rows = self.basis.local(points)
        means = np.einsum("kij,kj->ki", rows, self.mean[columns])
        covariances = np.empty((len(points), 6, 6))
        for start in range(0, len(points), PLACES_AT_A_TIME):
            some = slice(start, start + PLACES_AT_A_TIME)
            own, felt = columns[some], rows[some]
            covariances[some] = felt @ self.covariance[own[:, :, None], own[:, None, :]] @ np.swapaxes(felt, 1, 2)
        return LocalMotions(means, covariances)

    def covariance_of_mean(self, points: FloatArray) -> FloatArray:
        """(3, 3) covariance of the mean shift of (k, 3) points, square metres."""
        design = self.basis.design(points)
        average = csr_array(np.full((1, len(points)), 1 / len(points)))
        dense = np.vstack([(average @ design[axis::3]).toarray() for axis in range(3)])
        return np.asarray(np.einsum("ia,ab,jb->ij", dense, self.covariance, dense, optimize=True))


@dataclass(frozen=True, eq=False)
class LocalMotions:
    """Motion of the frame as small bodies at some places feel it.

    Attributes
    ----------
    means
        (k, 6) shift in metres and rotation vector in radians.
    covariances
        (k, 6, 6).
    """

    means: FloatArray
    covariances: FloatArray

    def without(self, values: FloatArray, covariances: FloatArray, used: FloatArray) -> LocalMotions:
        """What others alone say at every place: each one's own observation of the shift taken back out.

        Parameters
        ----------
        values, covariances
            (k, 3), (k, 3, 3) shifts observed at the places, as they entered.
        used
            (k,) weight with which each entered, over that of its covariance; 0 for those that did not.
        """
        means, totals = self.means.copy(), self.covariances.copy()
        own = np.flatnonzero(used > 1e-9)
        left = covariances[own] / used[own, None, None] - totals[own, :3, :3]
        gain = totals[own, :, :3] @ np.linalg.inv(left)
        means[own] -= np.einsum("kij,kj->ki", gain, values[own] - means[own, :3])
        totals[own] += gain @ totals[own, :3]
        return LocalMotions(means, totals)


def information_of(basis: FieldBasis, points: FloatArray, values: FloatArray, weights: FloatArray) -> tuple[coo_array, FloatArray]:
    """Normal matrix (size, size) and right-hand side (size,) of (k, 3) shifts with (k, 3, 3) weights at (k, 3) points.

    A shift bears on the nodes around it alone: the matrix is sparse, each of its entries there once.
    """
    if not len(points):
        return coo_array((basis.size, basis.size)), np.zeros(basis.size)
    design = basis.design(points)
    weighted = block_rows(weights) @ design
    return coo_array(design.T @ weighted), np.asarray(weighted.T @ values.ravel())


def solved(product: FloatArray, right: FloatArray) -> FloatArray:
    """The solution of (1 + ``product``) x = ``right``; both are used up, to spare memory, where ``right`` runs by columns."""
    product[np.diag_indices_from(product)] += 1
    # a view transposed runs by columns, as LAPACK asks for, and nothing is copied
    turned = bool(product.flags.c_contiguous)
    factor = lu_factor(product.T if turned else product, overwrite_a=True)
    return np.asarray(lu_solve(factor, right, trans=int(turned), overwrite_b=True), dtype=np.float64)


def symmetric_part(matrix: FloatArray) -> FloatArray:
    """Mean of a square matrix and its transpose."""
    total = matrix + matrix.T
    total *= 0.5
    return total


def _mirror(matrix: FloatArray) -> None:
    """Fill the lower half of a square matrix with its upper one, in place."""
    for start in range(0, len(matrix), MIRRORED):
        stop = start + MIRRORED
        matrix[start:stop, :start] = matrix[:start, start:stop].T
        block = matrix[start:stop, start:stop]
        block[:] = np.triu(block) + np.triu(block, 1).T


def block_rows(blocks: FloatArray) -> csr_array:
    """(3 k, 3 k) block-diagonal matrix of (k, 3, 3) blocks."""
    k = len(blocks)
    rows = (3 * np.arange(k)[:, None, None] + np.arange(3)[None, :, None]) * np.ones((1, 1, 3), dtype=np.int64)
    columns = np.swapaxes(rows, 1, 2)
    return csr_array(coo_array((blocks.ravel(), (rows.ravel(), columns.ravel())), shape=(3 * k, 3 * k)))
