"""Clouds that are not aligned: the units of two epochs as constellations, and the rigid motion that brings one onto the other.

A pair of units, one of each epoch, gives a whole motion for each of the unit's symmetries. Motions that keep the vertical, as levelled
instruments and projected clouds do, vote by how many neighbours they bring onto units; the best are refined over all units and the one
that explains most stays (hypothesise and verify, Fischler and Bolles, 1981, CACM 24(6)).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from ..common.arrays import FloatArray, IntArray
from ..common.rotations import closest_rotation
from ..model.unit_types import UnitType
from .common_shifts import common_shift
from .identity import FoundUnits

FEWEST_UNITS = 6
"""Units of each epoch from which a constellation can be recognised."""
ALIGNED_SHARE = 0.25
"""Share of the smaller epoch's units that stand where the other epoch has one, from which the clouds are aligned as they are."""
MATCHED_SHARE = 0.3
"""Share that a motion must explain."""
ANCHORS, NEIGHBOURS, KEPT = 30, 12, 24
"""Units of the first epoch that are tried, neighbours that vote, and motions that are refined."""
STEEPEST = math.radians(20)
"""Tilt between two clouds beyond which no motion is looked for."""
NEAR_HEIGHTS, FAR_HEIGHTS = 0.12, 0.3
"""Distance of matching centres over H: among the neighbours of an anchor, and over the whole constellation at first."""
TURN_ERROR = 0.03
"""Error of a motion's turn from one pair of units, radians."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Alignment:
    """Motion x -> rotation @ x + translation of the second epoch's frame onto the first's.

    Attributes
    ----------
    rotation, translation
        (3, 3), (3,) metres, about the frame's origin.
    matched
        Units that it brings together.
    scatter
        Root mean square distance of matching centres, metres.
    """

    rotation: FloatArray
    translation: FloatArray
    matched: int
    scatter: float

    @property
    def turn_degrees(self) -> float:
        """Angle of the rotation."""
        return math.degrees(self.turn)

    @property
    def turn(self) -> float:
        """Angle of the rotation, radians."""
        return float(np.linalg.norm(Rotation.from_matrix(self.rotation).as_rotvec()))

    def shift_at(self, place: FloatArray) -> FloatArray:
        """(3,) how far a (3,) place of the second epoch's frame moves, metres."""
        return np.asarray(self.rotation @ place + self.translation - place)


def aligned_share(first: FoundUnits, second: FoundUnits, height: float) -> float:
    """Share of the smaller epoch's certain units that stand within 0.3 H of one of the other epoch, a common shift of 1.5 H removed."""
    a, b = _centres(first), _centres(second)
    if not len(a) or not len(b):
        return 1.0
    if len(b) > len(a):
        a, b = b, a
    shift = common_shift(a, b, height)
    return float(np.mean(cKDTree(a + shift).query(b)[0] < FAR_HEIGHTS * height))


def settled(first: FoundUnits, second: FoundUnits, height: float) -> Alignment | None:
    """Motion of units that stand about where the other epoch has them: shifted by up to 1.5 H, and turned; None if it explains too few."""
    a, b = _centres(first), _centres(second)
    if min(len(a), len(b)) < FEWEST_UNITS:
        return None
    found = _refined(np.eye(3), -common_shift(a, b, height), a, b, cKDTree(a), height)
    return found if found is not None and found.matched >= MATCHED_SHARE * min(len(a), len(b)) else None


def align(first: FoundUnits, second: FoundUnits, units: Sequence[UnitType]) -> Alignment | None:
    """Motion that brings the second epoch's units onto the first's; None where no constellation is recognised.

    Parameters
    ----------
    first, second
        Units of two epochs, each in its own frame less the same reduction point.
    units
        Types of unit.
    """
    height = max(unit.height for unit in units)
    a, b = _certain(first), _certain(second)
    if min(len(a), len(b)) < FEWEST_UNITS:
        return None
    centres, others = _centres(first), _centres(second)
    tree, own_tree = cKDTree(centres), cKDTree(others)
    candidates: list[tuple[int, FloatArray, FloatArray]] = []
    step = max(1, len(b) // ANCHORS)
    for anchor in b[np.argsort(others[:, 0], kind="stable")][::step]:
        candidates += _votes(int(anchor), first, second, a, units, tree=tree, own_tree=own_tree, others=others, height=height)
    candidates.sort(key=lambda found: -found[0])
    best: Alignment | None = None
    for _, rotation, translation in candidates[:KEPT]:
        refined = _refined(rotation, translation, centres, others, tree, height)
        if refined is not None and (best is None or refined.matched > best.matched):
            best = refined
    enough = max(FEWEST_UNITS - 1, MATCHED_SHARE * min(len(a), len(b)))
    return best if best is not None and best.matched >= enough else None


def _certain(found: FoundUnits) -> IntArray:
    return np.flatnonzero(found.certain)


def _centres(found: FoundUnits) -> FloatArray:
    return np.array([found.poses[k].centre for k in _certain(found)]).reshape(-1, 3)


def _votes(
    anchor: int,
    first: FoundUnits,
    second: FoundUnits,
    rows: IntArray,
    units: Sequence[UnitType],
    *,
    tree: cKDTree,
    own_tree: cKDTree,
    others: FloatArray,
    height: float,
) -> list[tuple[int, FloatArray, FloatArray]]:
    """Motions of one unit of the second epoch onto every unit of its type in the first, with the neighbours each brings onto a unit."""
    pose = second.poses[anchor]
    unit = units[int(second.kinds[anchor])]
    near = np.atleast_1d(own_tree.query(pose.centre, k=min(NEIGHBOURS + 1, len(others)))[1])
    arms = others[near] - pose.centre
    tolerance = NEAR_HEIGHTS * height + TURN_ERROR * np.linalg.norm(arms, axis=1)
    found = []
    for row in rows[first.kinds[rows] == second.kinds[anchor]]:
        target = first.poses[row]
        turns = target.rotation @ unit.symmetries @ pose.rotation.T
        for turn in turns[turns[:, 2, 2] > math.cos(STEEPEST)]:
            distance = tree.query(target.centre + arms @ turn.T)[0]
            votes = int(np.sum(distance < tolerance))
            if votes >= FEWEST_UNITS - 2:
                found.append((votes, np.asarray(turn), np.asarray(target.centre - turn @ pose.centre)))
    return found


def _refined(
    rotation: FloatArray, translation: FloatArray, centres: FloatArray, others: FloatArray, tree: cKDTree, height: float
) -> Alignment | None:
    """The motion adjusted to all centres that it brings together, from near the start outwards."""
    matched, distance = np.zeros(0, dtype=np.int64), np.zeros(0)
    for limit in (2.0, 1.5, 1.0, 1.0, 1.0):
        moved = others @ rotation.T + translation
        distance, index = tree.query(moved)
        matched = np.flatnonzero(distance < limit * FAR_HEIGHTS * height)
        if len(matched) < FEWEST_UNITS - 2:
            return None
        # moved units pull: the nearer half of the matches leads
        keep = matched[distance[matched] <= max(float(np.median(distance[matched])), 1e-6)] if len(matched) > FEWEST_UNITS else matched
        x, y = others[keep], centres[index[keep]]
        rotation, _ = closest_rotation((y - y.mean(axis=0)).T @ (x - x.mean(axis=0)))
        translation = y.mean(axis=0) - rotation @ x.mean(axis=0)
    distance, index = tree.query(others @ rotation.T + translation)
    matched = np.flatnonzero(distance < FAR_HEIGHTS * height)
    # two units cannot be the same one
    if len(np.unique(index[matched])) < 0.8 * len(matched):
        return None
    scatter = float(np.sqrt(np.median(distance[matched] ** 2))) if len(matched) else math.inf
    return Alignment(rotation=rotation, translation=translation, matched=len(matched), scatter=scatter)
