"""What displacement a survey can detect, computed before it is flown: the Cramer-Rao bound of the adjustment from geometry.

The information of one point about pose and shape is the square of its condition's row (paper eqs. 8-9) over the noise; summed
over the part of a unit that the instrument sees, its inverse bounds the covariance of every unbiased estimate. Detectability
follows Baarda (1968): the displacement whose noncentrality reaches a given power at a given level of significance.
"""

from __future__ import annotations

import contextlib
import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from ..common.arrays import FloatArray
from ..common.noncentrality import noncentrality
from ..model.tetrapod import LATERAL, distance_to_surface, relate, surface_cells
from ..model.unit_types import UnitType

ORIENTATIONS = 64
CHART_SHARES, CHART_REACH, CHART_STEPS = (0.1, 0.3, 0.6), 16.0, 12
"""Visible shares that a chart shows beside the planned one; factor by which densities reach up and down, and steps on either side."""
CELLS = 400


@dataclass(frozen=True)
class SurveyPlan:
    """A planned survey.

    Attributes
    ----------
    density
        Points per square metre of a surface that faces the instrument.
    noise
        Standard deviation of one point along the surface normal, metres (white part).
    visible_share
        Share of a unit's surface that holds points, 0 to 1; the cells seen that lie nearest the instrument are kept, as in a
        pile where neighbours hide the lower parts.
    systematic
        Standard deviation of what does not average out over the points of a unit in one epoch (strip offsets, roughness,
        growth), metres per coordinate.
    registration
        Standard deviation of the registration of one epoch to the common datum at the unit, metres per coordinate.
    tilt
        Angle in radians between the line of sight and the vertical: 0 for a survey from the air, about 1.2 from a wall.
    shape_fixed
        True when radius and gradient of the cones are known (calibrated) and held.
    significance, power
        Level of the test and probability with which the displacement is to be found.
    """

    density: float
    noise: float
    visible_share: float = 0.3
    systematic: float = 0.0
    registration: float = 0.0
    tilt: float = 0.0
    shape_fixed: bool = True
    significance: float = 0.001
    power: float = 0.8

    def __post_init__(self) -> None:
        for name in ("density", "noise"):
            value = getattr(self, name)
            if not math.isfinite(value) or value <= 0:
                raise ValueError(f"{name} must be a positive number, got {value!r}")
        for name in ("systematic", "registration"):
            value = getattr(self, name)
            if not math.isfinite(value) or value < 0:
                raise ValueError(f"{name} must be zero or a positive number, got {value!r}")
        if not 0 < self.visible_share <= 1:
            raise ValueError(f"visible_share must be above 0 and at most 1, got {self.visible_share!r}")
        if not 0 <= self.tilt <= math.pi / 2:
            raise ValueError("tilt must lie between 0 (from above) and a right angle (horizontal)")
        if not 0 < self.significance < self.power < 1:
            raise ValueError("significance and power must lie between 0 and 1, significance below power")


@dataclass(frozen=True)
class Detectability:
    """What a plan can detect; figures are medians over orientations of the unit.

    Attributes
    ----------
    points
        Points on a unit.
    visible_share
        Share of the surface that holds points: the planned one, or less where the line of sight cannot reach as much.
    sd_centre
        Standard deviation of the centre in one epoch, metres, root of the three summed variances, white noise only.
    sd_rotation
        Standard deviation of the rotation in one epoch, radians, root of the three summed variances, white noise only.
    sd_displacement
        Standard deviation of a displacement between two epochs in its worst direction, metres, everything included.
    detectable_worst, detectable_mean
        Smallest displacement found with the planned power, metres, in the worst direction and as mean over all directions.
    detectable_rotation
        Smallest rotation found with the planned power about the worst axis, radians.
    determined
        Share of the orientations in which the points determine the pose; the figures are medians over these.
    """

    points: float
    visible_share: float
    sd_centre: float
    sd_rotation: float
    sd_displacement: float
    detectable_worst: float
    detectable_mean: float
    detectable_rotation: float
    determined: float


def detectability(unit: UnitType, plan: SurveyPlan, *, orientations: int = ORIENTATIONS, seed: int = 0) -> Detectability:
    """Smallest displacement and rotation that a planned survey finds.

    Raises
    ------
    ValueError
        If the plan leaves no orientation of the unit determined (too few points, or too little of the surface).
    """
    line_of_sight = np.array([math.sin(plan.tilt), 0.0, math.cos(plan.tilt)])
    turns = Rotation.random(orientations, rng=np.random.default_rng(seed)).as_matrix()
    cells = surface_cells(unit, CELLS)
    limit = noncentrality(plan.significance, plan.power)
    rows = []
    for turn in turns:
        weight = point_counts(unit, cells, turn.T @ line_of_sight, plan.density, plan.visible_share)
        bound = pose_bound(unit, cells[0], cells[1], weight, plan.noise, shape_fixed=plan.shape_fixed)
        if bound is None:
            continue
        # the bound is stated in body axes; lengths and angles of interest do not depend on the axes
        centre, rotation = bound[:3, :3], bound[3:6, 3:6]
        single = centre + (plan.systematic**2 + plan.registration**2) * np.eye(3)
        displacement = 2 * np.linalg.eigvalsh(single)
        seen = cells[2][weight > 0].sum() / cells[2].sum()
        rows.append(
            (
                weight.sum(),
                seen,
                math.sqrt(np.trace(centre)),
                math.sqrt(np.trace(rotation)),
                math.sqrt(displacement[-1]),
                math.sqrt(limit * displacement[-1]),
                math.sqrt(limit * displacement.mean()),
                math.sqrt(limit * 2 * np.linalg.eigvalsh(rotation)[-1]),
            )
        )
    if not rows:
        raise ValueError("the planned points determine the pose of no unit: raise the density or the visible share")
    return Detectability(*[*np.median(rows, axis=0).tolist(), len(rows) / orientations])


def detectability_curves(unit: UnitType, plan: SurveyPlan) -> list[dict[str, object]]:
    """Detectable displacement over point density, for some visible shares beside the planned one, for a chart.

    Returns
    -------
    One dictionary a share: ``visible``, ``density`` (points per m²) and, by them, ``detectable_worst`` (metres); shares that leave a
    unit undetermined are left out.
    """
    # noise averages out with the number of points; what does not is the same at every density
    constant = 2 * noncentrality(plan.significance, plan.power) * (plan.systematic**2 + plan.registration**2)
    densities = plan.density * np.geomspace(1 / CHART_REACH, CHART_REACH, 2 * CHART_STEPS + 1)
    curves: list[dict[str, object]] = []
    for share in sorted({*CHART_SHARES, plan.visible_share}):
        with contextlib.suppress(ValueError):
            planned = detectability(unit, replace(plan, visible_share=share)).detectable_worst
            found = np.sqrt((planned**2 - constant) * plan.density / densities + constant)
            curves.append({"visible": share, "density": densities.tolist(), "detectable_worst": found.tolist()})
    return curves


def point_counts(
    unit: UnitType, cells: tuple[FloatArray, FloatArray, FloatArray], towards: ArrayLike, density: float, visible_share: float
) -> FloatArray:
    """Expected points per surface cell of a unit seen along a direction.

    Parameters
    ----------
    unit, cells
        The unit and its :func:`~.tetrapod.surface_cells`.
    towards
        (3,) unit vector to the instrument, body frame.
    density
        Points per square metre across the line of sight.
    visible_share
        Largest share of the surface that is left free by neighbours; the cells nearest the instrument are kept.

    Returns
    -------
    (m,) expected points; 0 for cells that face away, are hidden by the unit itself, or by its neighbours.
    """
    centres, normals, area = cells
    direction = np.asarray(towards, dtype=np.float64)
    facing = normals @ direction
    steps = np.linspace(0.02, 1, 48)[1:] * 2 * unit.leg_length
    lifted = centres + 1e-3 * unit.height * normals
    # of those that face away nothing is asked, and nothing lies beyond the reach of the unit
    ahead = np.flatnonzero(facing > 0)
    along = lifted[ahead, None, :] + steps[None, :, None] * direction
    row, step = np.nonzero(np.sum(along**2, axis=2) < unit.reach**2)
    seen = facing > 0
    seen[ahead[row[distance_to_surface(along[row, step], unit) < 0]]] = False
    order = np.argsort(-(centres @ direction), kind="stable")
    kept = np.cumsum(np.where(seen[order], area[order], 0)) <= visible_share * area.sum()
    free = np.zeros(len(centres), dtype=bool)
    free[order] = kept
    return np.where(seen & free, density * area * facing, 0.0)


def pose_bound(
    unit: UnitType, points: FloatArray, normals: FloatArray, weight: FloatArray, noise: float, *, shape_fixed: bool
) -> FloatArray | None:
    """Cramer-Rao bound of e, n, h, omega (body axes), and of r, c unless the shape is fixed.

    Parameters
    ----------
    points, normals
        (m, 3) surface points and outward unit normals, body frame, metres.
    weight
        (m,) number of observations at each.
    noise
        Standard deviation along the normal, metres.

    Returns
    -------
    (6, 6) or (8, 8) covariance in metres and radians, or None where the points leave a direction undetermined.
    """
    relation = relate(points, unit)
    cosine = 1 / math.hypot(1, unit.gradient)
    lateral = (relation.part == LATERAL).astype(np.float64)
    columns = [-normals, -np.cross(points, normals)]
    if not shape_fixed:
        columns.append(np.column_stack([-cosine * lateral, cosine * lateral * relation.axial]))
    rows = np.hstack(columns)
    # lengths in units of the leg, so that the rank is judged on numbers of one size
    scale = np.array([1.0] * 3 + [1 / unit.leg_length] * 3 + ([] if shape_fixed else [1.0, 1 / unit.leg_length]))
    scaled = rows * scale
    information = scaled.T @ (scaled * weight[:, None])
    values = np.linalg.eigvalsh(information)
    if weight.sum() < rows.shape[1] or values[0] <= 1e-6 * values[-1]:
        return None
    return np.asarray(noise**2 * np.linalg.inv(information) * np.outer(scale, scale))
