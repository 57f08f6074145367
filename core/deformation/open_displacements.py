"""Displacements that the points of an epoch leave open: there the unit is held at rest, and that is said.

Of a unit of which one leg is seen, few points or noisy ones leave the way along that leg open, or the turn about it, and the pose lies
anywhere within decimetres. The other epoch often shows the unit well. A displacement of which some direction cannot be told is therefore
adjusted with the condition that the unit moved there as its neighbours did, as long as the test of rest does not speak against it; what
the points do say, across the leg, stays. Standard deviations stay those of the points: they say how far it may have moved unseen.
Conditions between unknowns: Mikhail and Ackermann (1976, Observations and Least Squares, chapter 9).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import block_diag
from scipy.spatial import cKDTree
from scipy.special import chdtrc

from ..common.arrays import FloatArray
from ..model.feature_points import body_features
from ..model.unit_types import UnitType
from .displacement import SIGNIFICANCE, turn_vector
from .epoch_pairs import TrackedUnits, joint_block
from .tracked_epoch import TrackedUnit

OPEN_HEIGHTS = 0.015
"""Standard deviation of a displacement in some direction, in unit heights, beyond which it is open: a motion of 5 % of H is missed more
often than not then (test at 5 %, power 80 %: 3.3 standard deviations)."""
NEIGHBOURS = 9
"""Units whose median motion says how the place of a unit moved."""


@dataclass(frozen=True, eq=False)
class _Step:
    """A unit's motion from one epoch to another, less that of its neighbours.

    Attributes
    ----------
    motion, covariance
        (6,), (6, 6) shift in metres and turn times the mean distance of the feature points from the centre, metres.
    """

    motion: FloatArray
    covariance: FloatArray

    def open_directions(self, height: float) -> FloatArray:
        """(6, m) orthonormal directions of the motion that the points leave open."""
        variances, directions = np.linalg.eigh(self.covariance)
        return np.asarray(directions[:, variances > (OPEN_HEIGHTS * height) ** 2])

    @property
    def is_rest(self) -> bool:
        """Whether the test of rest does not speak against it."""
        return bool(chdtrc(6, self.motion @ np.linalg.solve(self.covariance, self.motion)) > SIGNIFICANCE)


def hold_open_displacements(units: TrackedUnits) -> list[dict[int, TrackedUnit]]:
    """States of all units, open displacements held at rest in the directions that are, against the epoch that shows the unit best.

    They have the poses adjusted so, and are ``held`` in the epochs whose pose was open; covariances stay.
    """
    states = [dict(own) for own in units.states]
    motions = _NeighboursMotion(units)
    for unit, own in enumerate(units.states):
        counting = [epoch for epoch, state in own.items() if _counts(state)]
        if len(counting) < 2 or units.tracks[unit].relocated:
            continue
        best = min(counting, key=lambda epoch: (_largest_sd(own[epoch]), epoch))
        for epoch in counting:
            if epoch != best:
                states[unit] |= _held(units, unit, states[unit], best, epoch, motions)
    return states


def _held(
    units: TrackedUnits, unit: int, states: Mapping[int, TrackedUnit], best: int, epoch: int, motions: _NeighboursMotion
) -> dict[int, TrackedUnit]:
    """States of the unit with its open displacement from the ``best`` epoch to another one held at rest; none where it is not open."""
    shape = units.types[units.tracks[unit].kind]
    first, second = states[best].pose, states[epoch].pose
    if first is None or second is None:
        return {}
    a, b = units.numbers[unit, best], units.numbers[unit, epoch]
    lever = _lever(shape)
    scale = np.repeat([1.0, lever], 3)
    turn = second.rotation @ first.rotation.T
    difference = scale[:, None] * np.hstack([-block_diag(np.eye(3), turn), np.eye(6)])
    both = joint_block(units.joint, unit, a, b)
    shift = motions.at(unit, best, epoch, first.centre)
    motion = scale * np.concatenate([second.centre - first.centre - shift, turn_vector(first, second)])
    step = _Step(motion, difference @ both @ difference.T)
    directions = step.open_directions(shape.height)
    if not directions.shape[1] or not step.is_rest:
        return {}
    conditions = directions.T @ difference
    change = -both @ conditions.T @ np.linalg.solve(conditions @ both @ conditions.T, directions.T @ motion)
    return {
        best: replace(states[best], pose=first.perturbed(change[:3], change[3:6])),
        epoch: replace(states[epoch], pose=second.perturbed(change[6:9], change[9:]), held=True),
    }


class _NeighboursMotion:
    """How the cloud around a unit moved from one epoch to another."""

    def __init__(self, units: TrackedUnits) -> None:
        self._units = units
        self._known: dict[tuple[int, int], tuple[cKDTree, FloatArray, list[int]]] = {}

    def at(self, unit: int, first: int, second: int, place: FloatArray) -> FloatArray:
        """(3,) median motion of the nearest other units that both epochs show; none without others."""
        if (first, second) not in self._known:
            rows = [
                (k, a.pose.centre, b.pose.centre)
                for k, own in enumerate(self._units.states)
                if (a := own.get(first)) is not None and (b := own.get(second)) is not None and _counts(a) and _counts(b)
                and a.pose is not None and b.pose is not None
            ]  # fmt: skip
            before, after = (np.array([row[k] for row in rows]).reshape(-1, 3) for k in (1, 2))
            self._known[first, second] = cKDTree(before), after - before, [row[0] for row in rows]
        tree, motions, numbers = self._known[first, second]
        near = [int(k) for k in tree.query(place, k=min(NEIGHBOURS + 1, len(numbers)))[1].reshape(-1)] if len(numbers) > 1 else []
        others = [k for k in near if numbers[k] != unit]
        return np.asarray(np.median(motions[others], axis=0)) if others else np.zeros(3)


def _counts(state: TrackedUnit) -> bool:
    return state.pose is not None and state.status != "uncertain"


def _largest_sd(state: TrackedUnit) -> float:
    """Standard deviation of the centre in its worst direction, metres."""
    return math.inf if state.covariance is None else math.sqrt(max(np.linalg.eigvalsh(state.covariance[:3, :3])[-1], 0.0))


def _lever(shape: UnitType) -> float:
    """Mean distance of the feature points from the centre, metres."""
    return float(np.linalg.norm(body_features(shape)[1:], axis=1).mean())
