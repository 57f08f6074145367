"""Records of the linearised conditions of points on a unit's surface, for compiled loops: what goes in, what comes out, work arrays."""

from __future__ import annotations

import threading
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.kernels import COMPILED
from ..model.unit_types import Opening, UnitType

INLINED = COMPILED | {"inline": "always"}
"""Of the innermost functions: passing a dozen arrays costs as much as the work itself (measured: a third of a linearisation)."""

CONTESTED = COMPILED | {"forceinline": True, "_nrt": False}
"""Of those for points that several parts may own: inlined by LLVM, once they are compiled, since numba takes longer over the copies."""

BLOCK = 128
"""Points that are linearised together; what is known of them then stays in the nearest cache."""

WEIGHT, SCORE, SINGLE, X, Y, Z, LEG, CLEAR, RESIDUAL, BIAS, TIP = range(8, 19)
"""Rows of the work array of a block after the eight derivatives."""

BLOCK_ROWS = 19

BLOCK_COLUMNS = 9 * BLOCK + 8

SQUARES, WEIGHTS, PSI_SQUARES, SLOPES, SINGLES = range(5)
"""Places of :class:`Sums` in a work array."""


class LegDirections(NamedTuple):
    """How the legs of a unit lie in its own frame.

    Attributes
    ----------
    directions
        (4, 3) unit vectors from the centre.
    creases
        (4, 4, 3) unit normals of the planes between every two legs.
    spread
        Largest distance between the ends of two directions.
    """

    directions: FloatArray
    creases: FloatArray
    spread: float

    @classmethod
    def empty(cls) -> LegDirections:
        """Stands for any in what is compiled."""
        return cls(np.zeros((4, 3)), np.zeros((4, 4, 3)), 0.0)


class Solid(NamedTuple):
    """The solid that points are compared with: where it is, and its surface.

    Attributes
    ----------
    centre, rotation
        (3,) metres and (3, 3), body to the axes of the points.
    legs
        Their directions.
    shape
        (2,) radius at the centre, metres, and gradient.
    leg_lengths
        (4,) metres from the centre to the end discs.
    opened, discs
        (4,) legs that may own points, and those whose end disc may.
    """

    centre: FloatArray
    rotation: FloatArray
    legs: LegDirections
    shape: FloatArray
    leg_lengths: FloatArray
    opened: BoolArray
    discs: BoolArray

    @classmethod
    def empty(cls) -> Solid:
        """Stands for any in what is compiled."""
        none = np.zeros(4, dtype=np.bool_)
        return cls(np.zeros(3), np.zeros((3, 3)), LegDirections.empty(), np.zeros(2), np.zeros(4), none, none)


class Weighting(NamedTuple):
    """How residuals are standardised and weighted in one linearisation.

    Attributes
    ----------
    scale
        Standardises residuals and is the noise for memberships: metres without covariances of the points, else a factor on these.
    correct
        The noise whose bias is removed, in the same unit.
    tip, fade
        Metres along a leg: the use of its cone fades from one half of ``fade`` before ``tip`` to one half of it behind.
    edge
        Width left out along creases and rims, metres.
    redescend
        Whether weights are robust.
    final
        Whether what the covariance needs is made too.
    """

    scale: float
    correct: float
    tip: float
    fade: float
    edge: float
    redescend: bool
    final: bool


class NormalEquations(NamedTuple):
    """What the points say about the 12 unknowns: shift and turn along the axes of the body, radius, gradient, errors of the leg lengths.

    Attributes
    ----------
    normal, rhs
        (12, 12) and (12,) of the Gauss-Newton step.
    plain
        (12, 12) outer products of the rows of points that belong to one part only.
    shared, shared_scores
        (12, 12) of the other points, the derivative of their scores and the outer product of these.
    """

    normal: FloatArray
    rhs: FloatArray
    plain: FloatArray
    shared: FloatArray
    shared_scores: FloatArray

    @classmethod
    def empty(cls) -> NormalEquations:
        """Equations to be filled by :func:`linearise_points`."""
        return cls(np.zeros((12, 12)), np.zeros(12), np.zeros((12, 12)), np.zeros((12, 12)), np.zeros((12, 12)))


class PointStates(NamedTuple):
    """What a linearisation makes of each of n points.

    Attributes
    ----------
    legs, parts
        (n,) likeliest leg 0..3, or -1, and 0 on its lateral surface, 1 on its end disc.
    residuals, sds, biases
        (n,) signed distance, metres, nan for points that belong to no part; its standard deviation for a scale of one; its bias.
    weights
        (n,) robust weight times share of membership.
    at_tip
        (n,) points in the unit's tips, which neither a cone nor an end disc in use describes.
    rows, feet
        (n, 12) derivatives of the standardised condition of points that belong to one part only, and (n, 3) adjusted observations in the
        body frame; filled by a final linearisation alone.
    """

    legs: IntArray
    parts: IntArray
    residuals: FloatArray
    sds: FloatArray
    biases: FloatArray
    weights: FloatArray
    at_tip: BoolArray
    rows: FloatArray
    feet: FloatArray

    @classmethod
    def empty(cls, n: int) -> PointStates:
        """Of n points, to be filled by :func:`linearise_points`."""
        return cls(
            legs=np.zeros(n, dtype=np.int64),
            parts=np.zeros(n, dtype=np.int64),
            residuals=np.zeros(n),
            sds=np.ones(n),
            biases=np.zeros(n),
            weights=np.zeros(n),
            at_tip=np.zeros(n, dtype=np.bool_),
            rows=np.zeros((n, 12)),
            feet=np.zeros((n, 3)),
        )


class Sums(NamedTuple):
    """Sums over the points: squared residuals and weights, which make the scale; of points that belong to one part only those of psi^2
    and of psi', and their number."""

    squares: float
    weights: float
    psi_squares: float
    slopes: float
    singles: float


class Cone(NamedTuple):
    """Radius at the centre, gradient, and cosine of half the opening angle."""

    r: float
    c: float
    cosine: float


class Noise(NamedTuple):
    """Covariance of a point in the body frame, and whether there is one; the factor on it, else metres; the largest standard deviation of
    the point in any direction, metres."""

    cov: FloatArray
    has_cov: bool
    scale: float
    reach: float


_KEPT = threading.local()


class Work(NamedTuple):
    """Work arrays of linearisations.

    A column of ``block`` is a point, or a further part that may own it; rows are named above. ``found`` is filled by :func:`foot`,
    ``lean``, ``which`` and ``density`` by :func:`candidates`; ``row`` and ``mean_score`` are derivatives and score of one point.
    """

    block: FloatArray
    scaled: FloatArray
    body_cov: FloatArray
    found: FloatArray
    lean: FloatArray
    which: IntArray
    density: FloatArray
    row: FloatArray
    mean_score: FloatArray
    sums: FloatArray

    @classmethod
    def of_thread(cls) -> Work:
        """Those of this thread, for any number of points: nothing in them outlives a linearisation, and making them anew for every unit
        costs more than the unit's last step."""
        found: Work | None = getattr(_KEPT, "work", None)
        if found is None:
            found = _KEPT.work = cls.empty()
        return found

    @classmethod
    def empty(cls) -> Work:
        """For any number of points, one linearisation after another."""
        # a column for every point, and one for each of up to eight parts that may own it; rows a power of two apart would share cache lines
        return cls(
            block=np.zeros((BLOCK_ROWS, BLOCK_COLUMNS)),
            scaled=np.empty(BLOCK_COLUMNS),
            body_cov=np.zeros((3, 3)),
            found=np.zeros((8, 11)),
            lean=np.zeros(4),
            which=np.zeros(8, dtype=np.int64),
            density=np.zeros(8),
            row=np.zeros(12),
            mean_score=np.zeros(12),
            sums=np.zeros(5),
        )


class Task(NamedTuple):
    """What all points of one linearisation have in common; ``variance`` is that whose bias is removed."""

    solid: Solid
    cone: Cone
    weighting: Weighting
    variance: float
    equations: NormalEquations
    states: PointStates
    work: Work


def leg_directions(axes: FloatArray) -> LegDirections:
    """Of (4, 3) unit vectors."""
    between = axes[:, None] - axes[None]
    lengths = np.linalg.norm(between, axis=2, keepdims=True)
    return LegDirections(axes, between / np.maximum(lengths, 1e-300), float(lengths.max()))


@lru_cache
def legs_of(opening: Opening) -> LegDirections:
    """Directions of a unit's legs."""
    return leg_directions(np.ascontiguousarray(UnitType.tetrapod(1.0, opening=opening).leg_directions))
