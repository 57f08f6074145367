"""The twist of a unit of which hardly more than one leg shows: what the points, and the room among its neighbours, leave open.

A leg looks the same turned about its axis, so the points of one leg say nothing of that turn. The other three legs need room,
however: tetrapods do not enter each other, and in a pile that leaves few twists.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from ..common.arrays import BoolArray, FloatArray, IntArray
from ..model.feature_points import body_features
from ..model.tetrapod import relate
from ..model.unit_types import UnitType
from .assembly import poses_from_pairs, poses_from_single_legs
from .conic_ransac import find_legs
from .pose_evidence import evidence
from .pose_refinement import refine
from .scene import Evidence, Scene
from .verification import overlap, without_copies, worth

FEW_LEGS = 2
"""Units with more visible legs than this have no open twist."""
TURN = 2 * np.pi / 3
"""A leg's axis is one of threefold symmetry: twists repeat after this angle."""
STEPS = 30
"""Twists looked at, four degrees apart."""
ANGLES = (np.arange(STEPS) * TURN / STEPS + TURN / 2) % TURN - TURN / 2
"""To both sides: about a leg that has not the others evenly around it, as three of the paper's opening have not, only those near count."""
WORTH_SCALE = 0.04
"""Share of its worth that makes a twist less likely by a factor e: a few of a hundred elements, which chance easily aligns. To its mean a
unit is turned: real legs lie some centimetres off their cones, and what a few elements of a second one prefer is no better start."""
ALIGNED = 3.0
"""Elements that make a twist less likely by a factor e where it is asked how sure it is: those of the leg that is turned about fit at
every twist and say nothing, however many they are. Of 904 units of 98 simulated clouds with one or two legs that show, 2 elements explain
the true twists best and 3 nearly as well, with less said against those that few elements gainsay."""
ROOM_SD = 0.015
"""Share of a unit's volume by which true neighbours seem to enter each other, as poses are not exact (standard deviation)."""
SURE_ROOM_SD = 0.006
"""The same where it is asked how sure a twist is: of these units 0.004 and less explain the true twists best, in noise too, and 0.006
nearly as well. Where a unit is turned to hangs on the former, as poses are settled yet."""
SURELY_NOT = 1e-12
"""Likelihood below which twists are ruled out alike."""
OPEN_TWIST = np.radians(10)
"""Standard deviation of the twist, or its mean, above which the mean is taken, not what chance aligned."""
FEATURE_TOLERANCE = 0.15
"""Mean error of the feature points, in heights, within which a pose counts as known."""
SAME_AXIS = np.radians(12)
"""Legs whose axes differ less are the same leg, seen in two poses."""
LEAST_CERTAINTY = 0.1
"""Certainty of a unit whose twist is open: it is there, and reported as uncertain."""
LEAST_MISFIT = 0.15
"""Of the tolerance, below which a misfit tells no more: elements are not independent."""
RIVAL_MARGIN = 0.08
"""Share of its log-likelihood by which a pose must beat every pose with other legs in its place to count as unambiguous."""
RIVAL_OVERLAP = 0.03
"""Share of its volume by which such a pose may enter another unit."""


@dataclass(frozen=True, eq=False)
class Twist:
    """What is known of a turn about a leg's axis.

    Attributes
    ----------
    mean, sd
        Radians, from the pose it was asked for.
    certainty
        ``LEAST_CERTAINTY`` where nothing is known, 1 where all likely twists place the feature points within ``FEATURE_TOLERANCE``.
    """

    mean: float
    sd: float
    certainty: float


def settle_twists(poses: FloatArray, found: Evidence, sure: BoolArray, scene: Scene, owner: IntArray) -> tuple[FloatArray, FloatArray]:
    """Turn units of few visible legs to the middle of the twists that are left to them, and say how much that leaves open.

    Parameters
    ----------
    poses, found
        (k, 12) centre and rotation by rows, and the evidence for each.
    sure
        (k,) whether the evidence makes it a unit, whatever its twist.
    owner
        (m,) index of the unit that each element was assigned to, -1 for none.

    Returns
    -------
    poses, certainty
        (k, 12), and (k,) 0 to 1: see :class:`Twist`; 0 also where a different pose about another leg explains the points as well.
    """
    unit = scene.unit
    poses = poses.copy()
    certainty = np.ones(len(poses))
    few = np.flatnonzero(found.legs <= FEW_LEGS)
    # units that stand in the way, and how far each is known to be where it seems to be
    standing = {int(k): 1.0 for k in np.flatnonzero(sure & (found.legs > FEW_LEGS))}
    turns = {int(k): _turns(poses[k], scene, owner == k, owner < 0) for k in few}
    # units that their own points settle stand in the way of those that need the room to be settled
    alone = {k: twist_of(worth(own.found), np.zeros(STEPS), unit) for k, own in turns.items()}
    for k in sorted(turns, key=lambda k: (alone[k].sd, k)):
        near = [j for j in standing if np.sum((poses[j, :3] - poses[k, :3]) ** 2) < (2 * unit.reach) ** 2]
        trust = np.array([standing[j] for j in near])
        poses[k], certainty[k] = _settled(turns[k], poses[near], trust, scene, owner == k, owner < 0)
        if sure[k] and certainty[k] > 0.5:
            standing[int(k)] = float(certainty[k])
    return poses, certainty


def settle_twist(
    pose: FloatArray, found: Evidence, others: FloatArray, trust: FloatArray, scene: Scene, own: BoolArray, free: BoolArray
) -> tuple[FloatArray, float]:
    """The same of a single (12,) pose: where the twists left to it are, and how far it is known.

    Parameters
    ----------
    found
        The evidence for it alone.
    others, trust
        (k, 12) units around it, and how far each is known to be where it seems to be, (k,) 0 to 1.
    own, free
        (m,) whether an element was assigned to it, and to no unit.
    """
    if found.legs[0] > FEW_LEGS:
        return pose, 1.0
    near = np.sum((others[:, :3] - pose[:3]) ** 2, axis=1) < (2 * scene.unit.reach) ** 2
    return _settled(_turns(pose, scene, own, free), others[near], trust[near], scene, own, free)


class _Turns(NamedTuple):
    """A (12,) pose turned about its main leg by ``ANGLES``, (STEPS, 12), and the evidence for each."""

    pose: FloatArray
    leg: int
    twists: FloatArray
    found: Evidence


def _turns(pose: FloatArray, scene: Scene, own: BoolArray, free: BoolArray) -> _Turns:
    leg = _main_leg(pose, scene.points[own], scene.unit, scene.tolerance)
    twists = _turned(pose, leg, ANGLES, scene.unit)
    return _Turns(pose, leg, twists, evidence(twists, scene, own | free))


def _settled(
    turns: _Turns, others: FloatArray, trust: FloatArray, scene: Scene, own: BoolArray, free: BoolArray
) -> tuple[FloatArray, float]:
    """The pose in the middle of the twists that its elements and (k, 12) units around leave to it, and how far it is known."""
    unit, values, pose = scene.unit, worth(turns.found), turns.pose
    entered = np.array([[overlap(twist, other, unit) for other in others] for twist in turns.twists]).reshape(STEPS, len(others))
    known = twist_of(values, entered_by_trust(entered, trust), unit)
    if max(known.sd, abs(known.mean)) > OPEN_TWIST:
        pose = _turned(pose, turns.leg, np.array([known.mean]), unit)[0]
    rival = _best_rival(pose, turns.leg, others, scene, own, free)
    margin = (1 - rival / max(float(log_likelihood(turns.found, scene.tolerance).max()), 1e-9)) / RIVAL_MARGIN
    sure_of = twist_of(values, entered_by_trust(entered, trust, SURE_ROOM_SD), unit, ALIGNED, SURE_ROOM_SD)
    return pose, min(sure_of.certainty, float(np.clip(margin, 0, 1)))


def entered_by_trust(entered: FloatArray, trust: FloatArray, room: float = ROOM_SD) -> FloatArray:
    """(STEPS,) shares of volume that speak as much against each twist as (STEPS, n) shares inside n neighbours that may be elsewhere.

    With its ``trust`` (n,), 0 to 1, a neighbour is where it seems to be, to within ``room``; otherwise it says nothing. The neighbour that
    says most counts.
    """
    likely = np.min(trust * np.exp(-0.5 * (entered / room) ** 2) + (1 - trust), axis=1, initial=1.0)
    return np.asarray(room * np.sqrt(-2 * np.log(np.maximum(likely, SURELY_NOT))))


def _main_leg(pose: FloatArray, points: FloatArray, unit: UnitType, tolerance: float) -> int:
    """The leg that holds most of (n, 3) points."""
    relation = relate((points - pose[:3]) @ pose[3:].reshape(3, 3), unit)
    return int(np.argmax(np.bincount(relation.leg[np.abs(relation.distance) < 2 * tolerance], minlength=4)))


def _turned(pose: FloatArray, leg: int, angles: FloatArray, unit: UnitType) -> FloatArray:
    """(k, 12) the pose turned about a leg's axis by (k,) angles."""
    rotation = pose[3:].reshape(3, 3)
    turns = Rotation.from_rotvec(angles[:, None] * (rotation @ unit.leg_directions[leg])).as_matrix() @ rotation
    return np.column_stack([np.tile(pose[:3], (len(angles), 1)), turns.reshape(-1, 9)])


def log_likelihood(found: Evidence, tolerance: float) -> FloatArray:
    """(k,) how much likelier poses make their elements than chance does, natural logarithm, those inside the solid counting against it.

    Chance spreads an element over the window of twice the ``tolerance`` (metres) on either side of the surface, a unit puts it there with
    the standard deviation that the misfit tells. Some elements more on a surface that fits them worse may be none of it.
    """
    misfit = np.maximum(found.misfit / tolerance, LEAST_MISFIT)
    return np.asarray(worth(found) * np.maximum(np.log(4 / (math.sqrt(2 * math.pi * math.e) * misfit)), 0.0))


def twist_of(values: FloatArray, entered: FloatArray, unit: UnitType, aligned: float = math.inf, room: float = ROOM_SD) -> Twist:
    """What (STEPS,) worths and shares of volume inside neighbours say of the twist, each step as likely as any before.

    ``WORTH_SCALE`` of the worth, but no more than ``aligned`` elements, make a twist less likely by a factor e; ``room`` is the standard
    deviation of the shares.
    """
    most = float(values.max())
    exponent = (most - values) / min(WORTH_SCALE * max(most, 1e-9), aligned) + 0.5 * (entered / room) ** 2
    likely = np.exp(exponent.min() - exponent)
    likely /= likely.sum()
    mean = float(np.angle(np.sum(likely * np.exp(3j * ANGLES))) / 3)
    away = np.abs((ANGLES - mean + TURN / 2) % TURN - TURN / 2)
    within = tolerated_twist(unit)
    # where all twists are alike a guess is already right as often as this
    chance = 2 * within / TURN
    known = float(likely[away <= within].sum())
    return Twist(mean, float(np.sqrt(np.sum(likely * away**2))), float(np.clip((known - chance) / (1 - chance), LEAST_CERTAINTY, 1)))


def tolerated_twist(unit: UnitType) -> float:
    """Twist in radians at which the mean error of the feature points reaches ``FEATURE_TOLERANCE``."""
    features = body_features(unit)[1:]
    axis = unit.leg_directions[0]
    off_axis = np.linalg.norm(features - np.outer(features @ axis, axis), axis=1)
    return float(2 * np.arcsin(min(1.0, FEATURE_TOLERANCE * unit.height / (2 * off_axis.mean()))))


def _best_rival(pose: FloatArray, main: int, others: FloatArray, scene: Scene, own: BoolArray, free: BoolArray) -> float:
    """Log-likelihood of the likeliest pose that has no leg where the main one is and does not enter another unit, for the same elements."""
    unit = scene.unit
    twists = [_turned(pose, leg, np.radians([24.0, 48.0, 72.0, 96.0]), unit) for leg in range(4) if leg != main]
    legs = find_legs(scene, own, 0)
    starts = [*twists, poses_from_pairs(legs, unit), poses_from_single_legs(legs, scene, own)]
    both = own | free
    rivals = refine(np.vstack(starts), scene, both, most=400, sweeps=8)
    axis = pose[3:].reshape(3, 3) @ unit.leg_directions[main]
    axes = np.einsum("nij,kj->nki", rivals[:, 3:].reshape(-1, 3, 3), unit.leg_directions)
    away = rivals[:, :3] - pose[:3]
    # a leg along the same axis is the same leg, wherever on it the centre came to lie
    across = np.linalg.norm(away - (away @ axis)[:, None] * axis, axis=1)
    different = (np.max(axes @ axis, axis=1) < np.cos(SAME_AXIS)) | (across > 0.1 * unit.height)
    if not different.any():
        return 0.0
    rivals = rivals[different]
    # most twists end in the same few poses
    rivals = rivals[without_copies(rivals, unit.symmetries, 0.02 * unit.height, np.cos(np.radians(2)))]
    value = log_likelihood(evidence(rivals, scene, both), scene.tolerance)
    for k in np.argsort(-value, kind="stable"):
        if value[k] > 0 and all(overlap(rivals[k], other, unit) <= RIVAL_OVERLAP for other in others):
            return float(value[k])
    return 0.0
