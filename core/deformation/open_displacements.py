"""Displacements that the points of an epoch leave open: there the unit is held at rest, and that is said.

Of a unit of which one leg is seen, few points or noisy ones leave the way along that leg open, or the turn about it, and the pose lies
anywhere within decimetres. The other epoch often shows the unit well. A displacement of which some direction cannot be told is therefore
adjusted with the condition that the unit moved there as the frame says that units at rest did, unless its tests call it moved or rotated;
what the points do say, across the leg, stays. Standard deviations stay those of the points: they say how far it may have moved unseen.
Conditions between unknowns: Mikhail and Ackermann (1976, Observations and Least Squares, chapter 9).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.linalg import block_diag

from ..common.positive_definite import largest_sd
from ..model.feature_points import body_features
from ..model.pose import Pose
from ..model.unit_types import UnitType
from .displacement import FramePart, turn_vector
from .epoch_pairs import EpochPair, TrackedUnits, joint_block
from .tracked_epoch import TrackedUnit

OPEN_HEIGHTS = 0.015
"""Standard deviation of a displacement in some direction, in unit heights, beyond which it is open: a motion of 5 % of H is missed more
often than not then (test at 5 %, power 80 %: 3.3 standard deviations)."""


def hold_open_displacements(units: TrackedUnits, pairs: Sequence[EpochPair]) -> list[dict[int, TrackedUnit]] | None:
    """States of all units with open displacements held at rest in the directions that are, each against the epoch that shows the unit best.

    They have the poses adjusted so, and are ``held`` in the epochs whose pose was open; covariances stay. None where nothing is open.

    Parameters
    ----------
    pairs
        All pairs of epochs, with what is known of the motions before anything is held.
    """
    states = [dict(own) for own in units.states]
    best = [min((_largest_sd(state), epoch) for epoch, state in own.items())[1] for own in states]
    held = False
    for pair in pairs:
        for motion in pair.units:
            own, epochs = states[motion.unit], (pair.first, pair.second)
            if motion.classes["stable"] != "stable" or best[motion.unit] not in epochs:
                continue
            poses = _at_rest(units, motion.unit, own, epochs, motion.frames["stable"])
            if poses is not None:
                held = True
                for epoch, pose in zip(epochs, poses, strict=True):
                    own[epoch] = replace(own[epoch], pose=pose, held=own[epoch].held or epoch != best[motion.unit])
    return states if held else None


def _at_rest(
    units: TrackedUnits, unit: int, states: dict[int, TrackedUnit], epochs: tuple[int, int], frame: FramePart
) -> tuple[Pose, Pose] | None:
    """Poses of a unit in two epochs, its displacement held at rest in the directions that its points leave open; None where none is."""
    shape = units.types[units.tracks[unit].kind]
    first, second = states[epochs[0]].pose, states[epochs[1]].pose
    if first is None or second is None:
        return None
    both = joint_block(units.joint, unit, *(units.numbers[unit, epoch] for epoch in epochs))
    turn = second.rotation @ first.rotation.T
    # turns as ways of the feature points, so that all components are metres
    scale = np.repeat([1.0, _lever(shape)], 3)
    difference = scale[:, None] * np.hstack([-block_diag(np.eye(3), turn), np.eye(6)])
    variances, directions = np.linalg.eigh(difference @ both @ difference.T)
    left_open = directions[:, variances > (OPEN_HEIGHTS * shape.height) ** 2]
    if not left_open.shape[1]:
        return None
    motion = scale * (np.concatenate([second.centre - first.centre, turn_vector(first, second)]) - frame.motion)
    conditions = left_open.T @ difference
    change = -both @ conditions.T @ np.linalg.solve(conditions @ both @ conditions.T, left_open.T @ motion)
    return first.perturbed(change[:3], change[3:6]), second.perturbed(change[6:9], change[9:])


def _largest_sd(state: TrackedUnit) -> float:
    """Standard deviation of the centre in its worst direction, metres; inf without a pose."""
    return math.inf if state.covariance is None else largest_sd(state.covariance[:3, :3])


def _lever(shape: UnitType) -> float:
    """Mean distance of the feature points from the centre, metres."""
    return float(np.linalg.norm(body_features(shape)[1:], axis=1).mean())
