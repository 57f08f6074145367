"""How sure a pose that another epoch shows is that of a unit, by the points that this one holds there.

In noise and in sparse clouds rock looks like a part of a unit now and then, in one epoch here and in another one there; what is a unit
looks like one in all that see it. Each epoch's points are therefore worth asking by themselves. Rich points that agree say nothing, as rock
at rest looks alike in all epochs; what they say against a pose does.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..model.pose import Pose
from ..model.unit_types import UnitType
from .aggregation import assign, contested
from .pose_evidence import evidence
from .pose_refinement import refine
from .pose_score import (
    AMONG_HEIGHTS,
    SURE_ALONE,
    TypicalUnit,
    is_sparse,
    score,
    score_in_company,
    score_with_residuals,
    typical_unit,
    where_bridged,
)
from .raw_residuals import raw_residuals
from .scene import Evidence, Scene
from .segment import CLEARANCE_IN_NOISE, cloud_elements
from .twist import settle_twist

ROUNDS = 2
"""Times that the pose is refined on the elements that are nobody else's."""
FEWEST_POINTS = 50
"""Around a pose, below which nothing is said."""


@dataclass(frozen=True, eq=False)
class SecondLook:
    """What the points around a pose say of it.

    Attributes
    ----------
    score
        0 to 1, as of a pose that was found there.
    pose
        (12,) centre and rotation by rows, refined where that was asked for.
    noisy
        Whether noise limits what the points show: their elements were moved onto the surface they share, or neighbours share it. Else they
        are sparse or rich.
    shared_noise
        Whether neighbours share it.
    certainty
        0 to 1, how far the turn about a leg is known: see :mod:`.twist`; 1 where that was not asked.
    """

    score: float
    pose: FloatArray
    noisy: bool
    shared_noise: bool = False
    certainty: float = 1.0

    @property
    def place(self) -> Pose:
        """The pose."""
        return Pose.of_row(self.pose)


def second_look(
    points: FloatArray,
    pose: FloatArray,
    others: FloatArray,
    scores: FloatArray,
    unit: UnitType,
    *,
    settle: bool = True,
    rich: bool = False,
    twist: bool = False,
    shared_noise: bool = False,
    noise: float = 0.0,
) -> SecondLook | None:
    """Judge a (12,) pose by the (n, 3) points around it, reduced frame; None where these are rich: rock looks alike in all epochs then.

    None too where noise is taken off the cloud, and they are too few for that.

    Parameters
    ----------
    others
        (k, 12) poses of the units around, which have their points.
    scores
        (k,) of these: units lie among such as leave no doubt.
    settle
        Refine the pose; else it is judged where it is.
    rich
        Judge it by rich points as well, for what speaks against it.
    twist
        Ask how far its turn about a leg is known, and turn it to the middle of what is left.
    shared_noise
        Whether neighbours are known to share their noise: of points of two epochs every other neighbour has its own.
    noise
        Of a point, metres, where it is known that it is taken off the cloud as a whole, else 0: few points look rich or sparse in any.
    """
    if len(points) < FEWEST_POINTS:
        return None
    cloud = cloud_elements(points, unit, workers=1, shared_noise=shared_noise, noise=noise)
    points, elements, tolerance = cloud.points, cloud.elements, cloud.tolerance
    scene = Scene.of(elements, unit, tolerance)
    noisy = scene.smoothed or scene.shared_noise
    if noise > 0 and not noisy:
        return None
    poor = noisy or is_sparse(scene)
    if not (poor or rich):
        return None
    poses, own = np.vstack([others, pose]), len(others)
    for _ in range(ROUNDS):
        owner, _ = assign(scene.points, poses, unit, 2.5 * scene.tolerance)
        free = (owner == own) | (owner < 0)
        if not settle:
            break
        doubtful = contested(scene.points, owner, poses, unit, CLEARANCE_IN_NOISE * elements.element_noise)
        poses[own] = refine(poses[own:], scene, free & ~doubtful, most=1500, sweeps=20)[0]
    found = evidence(poses[own:], scene, free)
    near = np.linalg.norm(others[:, :3] - poses[own, :3], axis=1) < AMONG_HEIGHTS * unit.height
    company = np.log1p([np.count_nonzero((scores >= SURE_ALONE) & near)])
    typical = typical_unit(found, scene) if poor else _typical_around(poses, owner, scene)
    likely = score_in_company(score(found, tolerance, typical), found, company, tolerance, typical)
    if scene.smoothed:
        # of the units around a part is seen here: what is usual on them cannot be told
        residuals = raw_residuals(points, poses, unit, scene.noise, first=own, settle=settle)[own:]
        likely = score_with_residuals(likely, residuals, found.support)
    settled, certainty = poses[own], 1.0
    if twist:
        settled, certainty = settle_twist(settled, found, others, scores, scene, owner == own, owner < 0)
    return SecondLook(float(likely[0]), settled, noisy, scene.shared_noise, certainty)


def _typical_around(poses: FloatArray, owner: IntArray, scene: Scene) -> TypicalUnit:
    """What (k, 12) poses in a rich cloud have in common, each by the elements whose (n,) owner it is: how surfaces lie, what is bridged."""
    found = Evidence.joined([evidence(pose[None], scene, (owner == k) | (owner < 0)) for k, pose in enumerate(poses)])
    return where_bridged(typical_unit(found, scene), found)
