"""Size and proportions of the units of a cloud, estimated jointly with their poses where the nominal size is only roughly known.

Radius, gradient and length of the legs are common to all units, each unit has its own pose: Gauss-Newton on the distances of surface
elements to lateral surfaces and end discs, the poses eliminated unit by unit. Robust and coarse on purpose: it tells the size to well
under a per cent so that the survey can be described; what a result rests on is the adjustment (``core.adjustment``).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..model.tetrapod import LATERAL, TIP_RATIO, SurfaceRelation, relate
from ..model.unit_types import GRADIENT, LEG_LENGTH_RATIO, RADIUS_RATIO, UnitType
from .conic_ransac import LEAST_AGREEMENT
from .surface_elements import SurfaceElements

SWEEPS = 14
CREASE_RATIO = 0.07
"""Distance from the planes between legs, as a share of the height, within which fillets and two-legged normals are left out."""
DISC_WINDOW_RATIO = 0.08
"""Distance from an end disc, as a share of the height, within which elements that face along the leg are taken for it at first."""
FEWEST_DISC_ELEMENTS = 40
"""End discs of fewer elements in all say nothing about the legs' length."""
LONGEST = 1.35
"""Legs are looked along to this multiple of their supposed length."""
FEWEST_CONE_ELEMENTS = 400
"""Elements on the outer half of the legs, all units together, from which their end can be read."""
GRADIENT_SD = 0.02
"""By which the gradients of moulds differ from the standard."""
CORRELATED = 20.0
"""Elements that count as one: roughness, and the choice of what is near, are alike among neighbours."""
NOISY_TOLERANCE_RATIO = 0.04
"""Tolerance, as a share of the height, from which radius and gradient are biased and the length of the legs tells the size better."""
DISC_AGREEMENT = 0.94
"""Cosine of the largest angle between a leg and the normal of an element of its end disc."""
INNER_DISC = 0.75
"""Share of the end disc's radius inside which its chamfer does not reach."""


@dataclass(frozen=True, eq=False)
class FreeShape:
    """Size and proportions that fit a cloud's units best.

    Attributes
    ----------
    unit
        Unit type with the estimated height, radius, gradient and length of the legs.
    poses
        (k, 12) poses that belong to it.
    ends
        Whether the ends of legs were seen, so that their length is measured; else it follows from the radius.
    noisy
        The noise is so large that it, and what it leaves out, shifts radius and gradient.
    """

    unit: UnitType
    poses: FloatArray
    ends: bool
    noisy: bool


@dataclass(frozen=True, eq=False)
class _Equations:
    """Linearised conditions of one unit: residuals, derivatives by pose (6) and by radius, gradient, leg length (3), weights."""

    residual: FloatArray
    pose: FloatArray
    shape: FloatArray
    weight: FloatArray
    disc: BoolArray


def fit_shape(elements: SurfaceElements, poses: FloatArray, unit: UnitType, tolerance: float) -> FreeShape:
    """Estimate size and proportions from units found with a nominal size that is off by up to a tenth.

    Parameters
    ----------
    poses
        (k, 12) poses of units that surely stand in the cloud.
    tolerance
        Distance to the surface within which an element belongs to it in the end, metres.
    """
    poses = poses.copy()
    agreement = _agreement(tolerance / unit.height)
    near = [_near(elements, pose, unit) for pose in poses]
    discs = False
    for sweep in range(SWEEPS):
        window = tolerance * max(1.5, 4.0 * 0.8**sweep)
        normal, right = np.zeros((3, 3)), np.zeros(3)
        eliminated = []
        seen = 0
        for pose, chosen in zip(poses, near, strict=True):
            e = _equations(elements.points[chosen], elements.normals[chosen], pose, unit, window, agreement, sweep)
            weighted = e.weight[:, None] * e.pose
            own = weighted.T @ e.pose + 1e-3 * max(float(e.weight.sum()), 1.0) * np.diag([1, 1, 1, *[unit.height**2] * 3]) / 3
            cross = weighted.T @ e.shape
            solved = np.linalg.solve(own, np.column_stack([cross, weighted.T @ e.residual]))
            normal += (e.weight[:, None] * e.shape).T @ e.shape - cross.T @ solved[:, :3]
            right += e.shape.T @ (e.weight * e.residual) - cross.T @ solved[:, 3]
            eliminated.append(solved)
            seen += int(e.disc.sum())
        discs = seen >= FEWEST_DISC_ELEMENTS
        step = _shape_step(normal, right, unit, discs, tolerance)
        for k, solved in enumerate(eliminated):
            poses[k] = _moved(poses[k], -(solved[:, 3] + solved[:, :3] @ step), unit.height)
        unit = _reshaped(unit, step, discs)
    length = unit.leg_length if discs else _end_of_cones(elements, poses, unit, 2 * tolerance, agreement)
    noisy = tolerance > NOISY_TOLERANCE_RATIO * unit.height
    return FreeShape(replace(unit, leg_length=length or unit.leg_length), poses, length is not None, noisy)


def _agreement(tolerance_ratio: float) -> float:
    """Cosine to which normals must agree: they are blurred where the noise is large, most of all at the ends of legs."""
    return max(LEAST_AGREEMENT - 6 * max(tolerance_ratio - 0.02, 0.0), 0.5)


def _end_of_cones(elements: SurfaceElements, poses: FloatArray, unit: UnitType, window: float, agreement: float) -> float | None:
    """Length of the legs, metres, where no end disc is seen: where the elements on the cones thin out to half; None where they do not."""
    longer = replace(unit, leg_length=min(LONGEST * unit.leg_length, 0.95 * unit.radius / unit.gradient))
    edges = np.linspace(0.5 * unit.leg_length, longer.leg_length, 36)
    middles = 0.5 * (edges[1:] + edges[:-1])
    counts = np.zeros(len(middles))
    for pose in poses:
        rotation = pose[3:].reshape(3, 3)
        chosen = np.flatnonzero(np.sum((elements.points - pose[:3]) ** 2, axis=1) < longer.reach**2)
        relation = relate((elements.points[chosen] - pose[:3]) @ rotation, longer)
        agree = np.abs(np.einsum("ij,ij->i", elements.normals[chosen] @ rotation, relation.normal))
        on_cone = (relation.part == LATERAL) & (np.abs(relation.distance) < window) & (agree > agreement)
        counts += np.histogram(relation.axial[on_cone], edges)[0]
    density = counts / (unit.radius - unit.gradient * middles)
    plateau = float(np.median(density[middles < 0.8 * unit.leg_length]))
    half = np.flatnonzero((density[:-1] >= 0.5 * plateau) & (density[1:] < 0.5 * plateau))
    if counts.sum() < FEWEST_CONE_ELEMENTS or not len(half) or density[half[-1] + 3 :].max(initial=0.0) > 0.3 * plateau:
        return None
    k = int(half[-1])
    share = (density[k] - 0.5 * plateau) / (density[k] - density[k + 1])
    return float(middles[k] + share * (middles[k + 1] - middles[k]))


def _near(elements: SurfaceElements, pose: FloatArray, unit: UnitType) -> IntArray:
    away = np.sum((elements.points - pose[:3]) ** 2, axis=1)
    return np.flatnonzero(away < (1.12 * unit.reach) ** 2)


def _equations(
    points: FloatArray, normals: FloatArray, pose: FloatArray, unit: UnitType, window: float, agreement: float, sweep: int
) -> _Equations:
    rotation = pose[3:].reshape(3, 3)
    body = (points - pose[:3]) @ rotation
    body_normals = normals @ rotation
    relation = relate(body, unit)
    side, disc = _usable(body, body_normals, relation, unit, window, agreement, sweep)
    chosen = side | disc
    disc = disc[chosen]
    outward = np.where(disc[:, None], unit.leg_directions[relation.leg[chosen]], relation.normal[chosen])
    slant = 1 / math.hypot(1, unit.gradient)
    axial = relation.axial[chosen]
    residual = np.where(disc, axial - unit.leg_length, relation.distance[chosen])
    world = outward @ rotation.T
    arm = points[chosen] - pose[:3]
    # distance = n . (p - centre): a shift of the unit by d changes it by -n.d, a turn by w by -(arm x n).w
    by_pose = np.column_stack([-world, -np.cross(arm, world)])
    zero = np.zeros(len(axial))
    by_shape = np.column_stack([np.where(disc, 0, -slant), np.where(disc, 0, axial * slant), np.where(disc, -1.0, zero)])
    reach = np.where(disc, max(window, (DISC_WINDOW_RATIO * 0.85**sweep) * unit.height), window)
    weight = np.maximum(1 - (residual / reach) ** 2, 0) ** 2
    return _Equations(residual, by_pose, by_shape, weight, disc)


def _usable(
    body: FloatArray, normals: FloatArray, relation: SurfaceRelation, unit: UnitType, window: float, agreement: float, sweep: int
) -> tuple[BoolArray, BoolArray]:
    """Elements of the cones where these are straight, and of the end discs inside their chamfers."""
    legs = unit.leg_directions
    lean = body @ legs.T
    rows = np.arange(len(body))
    axial = relation.axial
    lean[rows, relation.leg] = -np.inf
    crease = (axial - lean.max(axis=1)) / math.sqrt(2 - 2 * float(legs[0] @ legs[1]))
    agree = np.abs(np.einsum("ij,ij->i", normals, relation.normal))
    side = (relation.part == LATERAL) & (np.abs(relation.distance) < window) & (agree > agreement)
    side &= (crease > CREASE_RATIO * unit.height) & (axial < TIP_RATIO * unit.leg_length)
    along = np.abs(np.einsum("ij,ij->i", normals, legs[relation.leg]))
    rho = np.sqrt(np.maximum(np.sum(body**2, axis=1) - axial**2, 0))
    reach = max(window, DISC_WINDOW_RATIO * 0.85**sweep * unit.height)
    disc = (along > DISC_AGREEMENT) & (rho < INNER_DISC * unit.end_radius) & (np.abs(axial - unit.leg_length) < reach)
    return side & ~disc, disc


def _shape_step(normal: FloatArray, right: FloatArray, unit: UnitType, discs: bool, tolerance: float) -> FloatArray:
    """Step of radius, gradient and leg length, held back where the cloud says little."""
    # where the noise is large, what is near the surface is not all of it: then the gradient is little better known than from other moulds
    held = CORRELATED * (tolerance / 2.5 / GRADIENT_SD) ** 2
    normal[1, 1] += held
    right[1] += held * (unit.gradient - GRADIENT)
    scale = np.array([unit.height, 1.0, unit.height])
    normal = normal * np.outer(scale, scale)
    right = right * scale
    strength = np.array([1e-4, 1e-4, 1e-4 if discs else 1e9]) * max(float(normal[0, 0]), 1e-12)
    step = -np.linalg.solve(normal + np.diag(strength), right)
    return np.asarray(np.clip(step, -0.03, 0.03) * scale)


def _reshaped(unit: UnitType, step: FloatArray, discs: bool) -> UnitType:
    radius = unit.radius + step[0]
    gradient = float(np.clip(unit.gradient + step[1], 0.10, 0.28))
    if discs:
        length = unit.leg_length + step[2]
        return replace(unit, radius=radius, gradient=gradient, leg_length=length, height=length / LEG_LENGTH_RATIO)
    height = radius / RADIUS_RATIO
    return replace(unit, radius=radius, gradient=gradient, leg_length=LEG_LENGTH_RATIO * height, height=height)


def _moved(pose: FloatArray, step: FloatArray, height: float) -> FloatArray:
    out = pose.copy()
    out[:3] += np.clip(step[:3], -0.06 * height, 0.06 * height)
    turn = np.clip(step[3:], -0.1, 0.1)
    out[3:] = (Rotation.from_rotvec(turn).as_matrix() @ pose[3:].reshape(3, 3)).ravel()
    return out
