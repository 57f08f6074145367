"""Displacement of a unit's feature points and its rotation between two epochs, with tests, classes and detection limits.

Covariances hold the fits of both epochs (calibrated, see :mod:`congruence`) and the part common to all units. A displacement is tested
against zero as a vector of three components: ``significant`` is that single test at the stated level, while the class of a unit
needs the Benjamini-Hochberg procedure (1995, J. R. Statist. Soc. B 57), which keeps the share of stable units among
those called moved below the level however many units there are.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.spatial.transform import Rotation
from scipy.special import chdtrc, chdtri

from ..common.arrays import FloatArray
from ..common.noncentrality import noncentrality
from ..model.feature_points import FeaturePoints
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..registration.transformation import rigid_jacobian
from .congruence import pooled_degrees, quadratic
from .null_model import NullModel, f_p_value

SIGNIFICANCE = 0.05
POWER = 0.8
SEEN_ALIKE = 0.005
"""Motion, as a share of the height, by which what two epochs show of a unit's surface becomes another part of it: means of a cell agree to
their noise where the middles of its points lie within 0.003 of the height (nine surveys of docs/benchmarks-castings.md), as at rest."""


@dataclass(frozen=True)
class Grade:
    """A named limit of displacement: ``value`` in metres, in heights H or in nominal diameters Dn."""

    name: str
    value: float
    unit: str

    def metres(self, unit_type: UnitType) -> float:
        """The limit in metres for a type of unit."""
        return self.value * {"m": 1.0, "H": unit_type.height, "Dn": unit_type.nominal_diameter}[self.unit]


GRADE_UNITS = {"watch": "m", "alert": "m", "partly_damaged": "Dn", "damaged": "Dn", "dislocated": "H"}
"""Names of the grades in survey.toml, section [displacement], and what their limits are counted in."""


def grades_from(section: Mapping[str, float]) -> tuple[Grade, ...]:
    """Grades with the limits of section [displacement] of survey.toml."""
    return tuple(Grade(name.replace("_", " "), float(section[name]), unit) for name, unit in GRADE_UNITS.items())


@dataclass(frozen=True, eq=False, kw_only=True)
class UnitMotion:
    """A unit's motion in one epoch pair and datum.

    Attributes
    ----------
    starts
        (5, 3) feature points of the earlier epoch in the control frame, less the reduction point.
    vectors, covariances
        (5, 3), (5, 3, 3) displacements of the features and their full covariance, registration included.
    turn, turn_sd
        Rotation angle and its standard deviation, radians.
    statistics, p_values
        (5,) test of each feature's displacement against zero.
    turn_p_value
        Test of the rotation against zero.
    detectable
        (5,) displacement in metres found with a power of 80 % at the level of the test in the worst direction.
    """

    starts: FloatArray
    vectors: FloatArray
    covariances: FloatArray
    turn: float
    turn_sd: float
    statistics: FloatArray
    p_values: FloatArray
    turn_p_value: float
    detectable: FloatArray


def turn_vector(before: Pose, after: Pose) -> FloatArray:
    """(3,) rotation vector from one pose to the other about the frame's axes, radians."""
    return np.asarray(Rotation.from_matrix(after.rotation @ before.rotation.T).as_rotvec())


def turn_covariance(before: Pose, after: Pose, joint: FloatArray) -> FloatArray:
    """(3, 3) covariance of :func:`turn_vector` from the (12, 12) covariance of both poses, for turns that are not large."""
    turn = after.rotation @ before.rotation.T
    rows = np.zeros((3, 12))
    rows[:, 3:6], rows[:, 9:12] = -turn, np.eye(3)
    return np.asarray(rows @ joint @ rows.T)


@dataclass(frozen=True, eq=False, kw_only=True)
class FramePart:
    """What the frames of both epochs bring into the motion of one unit, in one datum, as everything but the unit itself says.

    Attributes
    ----------
    motion, covariance
        (6,), (6, 6) shift (m) and rotation vector (rad) of a small body at the unit's centre.
    degrees
        Degrees of freedom with which that covariance is known.
    carried
        (7, 7) covariance of the later epoch's registration; None without. Its turn and scale change a displacement by its length, and
        count where a unit was carried by metres.
    factor
        By which the statistic is divided, so that the level of the test is that of the units at rest.
    scale_degrees
        Degrees of freedom with which few units at rest show the scale of deviations: at most these are the test's.
    """

    motion: FloatArray
    covariance: FloatArray
    degrees: float
    carried: FloatArray | None = None
    factor: float = 1.0
    scale_degrees: float = math.inf

    def at(self, arms: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Shifts (k, 3) and their covariances (k, 3, 3) at (k, 3) ``arms`` from the unit's centre."""
        rows = rigid_jacobian(arms)[:, :, :6]
        return rows @ self.motion, rows @ self.covariance @ np.swapaxes(rows, 1, 2)


@dataclass(frozen=True, eq=False, kw_only=True)
class UnitPair:
    """One unit in two epochs, legs numbered alike.

    Attributes
    ----------
    before, after
        Feature points in the control frame less the reduction point.
    joint, noise
        (12, 12) covariance of both poses, and what noise alone would leave of it.
    turn, turn_covariance, turn_noise
        (3,), (3, 3), (3, 3) rotation between the epochs, radians, and the same of it.
    height
        Of the unit, metres.
    """

    before: FeaturePoints
    after: FeaturePoints
    joint: FloatArray
    noise: FloatArray
    turn: FloatArray
    turn_covariance: FloatArray
    turn_noise: FloatArray
    height: float

    def covariances_of(self, poses: FloatArray) -> FloatArray:
        """(5, 3, 3) of displacements of the features by themselves from a (12, 12) covariance of both poses."""
        rows = np.concatenate([-self.before.jacobian[:, :, :6], self.after.jacobian[:, :, :6]], axis=2)
        return np.asarray(rows @ poses @ np.swapaxes(rows, 1, 2))

    def vectors(self, frame: FramePart) -> FloatArray:
        """(5, 3) displacements of the features less what the frames bring into them."""
        points = self.before.positions
        return self.after.positions - points - frame.at(points - points[0])[0]


def moved_share(unit: UnitPair, null: NullModel, frame: FramePart) -> float:
    """How far a unit is from what units at rest are: 0 where no motion of its features is seen beyond what is known of them, 1 where both
    epochs show it elsewhere or turned."""
    known = null.spread * null.covariance(unit.covariances_of(unit.joint))
    beyond = np.mean(np.sum(unit.vectors(frame) ** 2, axis=1) - np.trace(known, axis1=1, axis2=2))
    return -math.expm1(-0.5 * max(float(beyond), 0.0) / (SEEN_ALIKE * unit.height) ** 2)


def unit_motion(unit: UnitPair, null: NullModel, turn_null: NullModel, frame: FramePart, share: float) -> UnitMotion:
    """Motion of a unit in the datum of ``frame``, with its tests; ``null`` and ``turn_null`` calibrate positions and rotations, those of a
    unit that moved (``share``, see :func:`moved_share`) as far as units at rest can.

    One covariance serves standard deviation, test and detection limit: that of the unit itself and of what the others predict. Both come
    from the same t distribution, the test from its scale and its tails, the standard deviation from its variance.
    """
    points, vectors = unit.before.positions, unit.vectors(frame)
    _, spread = frame.at(points - points[0])
    angle = unit.turn - frame.motion[3:]
    own = null.covariance_of_moved(unit.covariances_of(unit.joint), unit.covariances_of(unit.noise), share)
    own_turn = turn_null.covariance_of_moved(unit.turn_covariance, unit.turn_noise, share)
    if frame.carried is not None:
        turned = rigid_jacobian(vectors)[:, :, 3:]
        spread = spread + turned @ frame.carried[3:, 3:] @ np.swapaxes(turned, 1, 2)
    turn_spread = frame.covariance[3:, 3:]
    # the tests take a unit's own part for t distributed with that scale; what is stated is the variance of that distribution
    statistics = quadratic(vectors, own + spread) / frame.factor
    degrees = np.minimum(pooled_degrees(own, null.tail, spread, frame.degrees), frame.scale_degrees)
    turn_statistic = angle @ np.linalg.solve(own_turn + turn_spread, angle)
    covariances = null.spread * own + spread
    turn_total = turn_null.spread * own_turn + turn_spread
    size = float(np.linalg.norm(angle))
    along = angle / size if size > 0 else np.array([0.0, 0.0, 1.0])
    return UnitMotion(
        starts=points,
        vectors=vectors,
        covariances=covariances,
        turn=size,
        turn_sd=float(math.sqrt(along @ turn_total @ along)),
        statistics=statistics,
        p_values=f_p_value(statistics, degrees),
        turn_p_value=float(turn_null.p_value(np.array([turn_statistic]))[0]),
        detectable=_detection_factor(frame.factor) * np.sqrt(np.linalg.eigvalsh(covariances)[:, -1]),
    )


@cache
def _detection_factor(factor: float) -> float:
    """Detectable displacement over the standard deviation in its direction, by a test whose statistic is divided by a ``factor``."""
    return math.sqrt(noncentrality(float(chdtrc(3, factor * chdtri(3, SIGNIFICANCE))), POWER))


def adjusted_p_values(p_values: Sequence[float]) -> FloatArray:
    """Benjamini-Hochberg adjusted p-values: the smallest false discovery rate at which each test is called."""
    p = np.asarray(p_values, dtype=np.float64)
    order = np.argsort(p)[::-1]
    scaled = np.minimum.accumulate(p[order] * len(p) / np.arange(len(p), 0, -1)) if len(p) else p
    adjusted = np.empty_like(p)
    adjusted[order] = np.minimum(scaled, 1.0)
    return adjusted


def classify(adjusted: float, turn_adjusted: float, certain: bool, relocated: bool, level: float = SIGNIFICANCE) -> str:
    """Class of a unit in an epoch pair from its adjusted p-values of displacement and rotation."""
    if relocated:
        return "relocated"
    if not certain:
        return "uncertain"
    if adjusted <= level:
        return "moved"
    return "rotated" if turn_adjusted <= level else "stable"


def grade(length: float, significant: bool, unit: UnitType, grades: Sequence[Grade]) -> str:
    """Grade of a displacement in metres: below the detection limit, significant, or the highest limit it exceeds."""
    if not significant:
        return "below detection limit"
    passed = [(g.metres(unit), g.name) for g in grades if length > g.metres(unit)]
    return max(passed)[1] if passed else "significant"
