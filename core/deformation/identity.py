"""Identity of units over epochs: which found unit is which physical unit, with leg numbers carried through the 12 rotations.

Two epochs are matched by assignment with the cost of the motion between them, after the shift common to all units is removed. The
limits are physical: units are solid, so that centres of two units never come nearer than about half a height, and a unit that kept
its place in the interlock has moved by less than that.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from ..common.arrays import FloatArray, IntArray
from ..model.pose import Pose
from ..model.unit_types import UnitType
from .common_shifts import common_shift

MAX_MOVE_HEIGHTS = 0.6
"""Largest motion by which a unit is still taken for the one that stood there."""
TYPICAL_MOVE_HEIGHTS, TYPICAL_TURN = 0.5, math.radians(50)
"""Motion and turn that weigh alike in the cost."""
MAX_COST = 2.2
CONFIRM_MOVE_HEIGHTS, CONFIRM_TURN = 0.1, math.radians(10)
"""Weak evidence this near to a known unit's pose is that unit."""
AMBIGUOUS_MARGIN = math.radians(12)
"""Leg numbers are ambiguous where the next best numbering turns less than this more."""


@dataclass(frozen=True, eq=False)
class FoundUnits:
    """Units found in one epoch.

    Attributes
    ----------
    poses
        In a frame common to all epochs.
    kinds
        (k,) index of the type of unit.
    certain
        (k,) False for weak evidence.
    """

    poses: tuple[Pose, ...]
    kinds: IntArray
    certain: NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Track:
    """One physical unit.

    Attributes
    ----------
    rows
        Epoch index to row in that epoch's units.
    symmetries
        Epoch index to the (3, 3) rotation of the body that gives the unit the leg numbers of its first epoch (``Pose.relabelled``).
    ambiguous
        Epochs whose leg numbers the motion leaves open (turn near 60 degrees or more).
    kind
        Index of the type of unit.
    relocated
        Epochs in which the relief of its surface, not its place, told which unit it is (:mod:`.relocation`), however far it had moved: it
        was lost before, or another one may have filled the place it left (a motion of more than 0.2 H).
    """

    rows: dict[int, int]
    symmetries: dict[int, FloatArray]
    ambiguous: frozenset[int]
    kind: int
    relocated: frozenset[int] = frozenset()


@dataclass(frozen=True, eq=False)
class Identities:
    """All tracks, by first epoch and there in the order of its rows; ``shifts`` (e, 3) are the common shifts removed, metres."""

    tracks: tuple[Track, ...]
    shifts: FloatArray


def identify(epochs: Sequence[FoundUnits], units: Sequence[UnitType]) -> Identities:
    """Follow units through any number of epochs, in order of time.

    A unit hidden in some epochs keeps its identity by its last pose. Weak evidence joins a track only where it confirms a known
    unit's pose, and otherwise stays a track of its own.
    """
    height = max((unit.height for unit in units), default=1.0)
    last_pose: list[Pose] = []
    rows: list[dict[int, int]] = []
    symmetries: list[dict[int, FloatArray]] = []
    ambiguous: list[set[int]] = []
    kinds: list[int] = []
    certain: list[bool] = []
    shifts = np.zeros((len(epochs), 3))
    total_shift = np.zeros(3)
    for number, found in enumerate(epochs):
        centres = np.array([p.centre for p in found.poses]).reshape(-1, 3)
        known = np.array([p.centre for p in last_pose]).reshape(-1, 3)
        step = common_shift(known + total_shift, centres, height)
        total_shift = total_shift + step
        shifts[number] = total_shift
        pairs = _match(last_pose, np.array(kinds, dtype=np.int64), np.array(certain, dtype=bool), found, units, total_shift)
        taken = set()
        for track, row in pairs:
            unit = units[kinds[track]]
            symmetry, turn, runner_up = nearest_labels(last_pose[track], found.poses[row], unit)
            rows[track][number] = row
            symmetries[track][number] = symmetry
            if runner_up - turn < AMBIGUOUS_MARGIN:
                ambiguous[track].add(number)
            pose = found.poses[row].relabelled(symmetry)
            last_pose[track] = pose.shifted(-total_shift)
            certain[track] = certain[track] or bool(found.certain[row])
            taken.add(row)
        for row, pose in enumerate(found.poses):
            if row not in taken:
                last_pose.append(pose.shifted(-total_shift))
                rows.append({number: row})
                symmetries.append({number: np.eye(3)})
                ambiguous.append(set())
                kinds.append(int(found.kinds[row]))
                certain.append(bool(found.certain[row]))
    tracks = tuple(Track(r, s, frozenset(a), k) for r, s, a, k in zip(rows, symmetries, ambiguous, kinds, strict=True))
    return Identities(tracks, shifts)


def nearest_labels(reference: Pose, pose: Pose, unit: UnitType) -> tuple[FloatArray, float, float]:
    """Symmetry that renumbers ``pose`` to turn least from ``reference``; that turn and the next best, radians."""
    turns = Rotation.from_matrix(reference.rotation.T @ pose.rotation @ unit.symmetries).magnitude()
    order = np.argsort(turns)
    return np.asarray(unit.symmetries[order[0]]), float(turns[order[0]]), float(turns[order[1]])


def _match(
    last: Sequence[Pose], kinds: IntArray, certain: NDArray[np.bool_], found: FoundUnits, units: Sequence[UnitType], shift: FloatArray
) -> list[tuple[int, int]]:
    """Pairs (track, row) of least total cost."""
    if not len(last) or not len(found.poses):
        return []
    height = max(unit.height for unit in units)
    before = np.array([p.centre for p in last]) + shift
    after = np.array([p.centre for p in found.poses])
    near = cKDTree(after).query_ball_point(before, MAX_MOVE_HEIGHTS * height)
    i = np.repeat(np.arange(len(before)), [len(js) for js in near])
    j = np.array([k for js in near for k in js], dtype=np.int64)
    if not len(i):
        return []
    same = kinds[i] == found.kinds[j]
    i, j = i[same], j[same]
    move = np.linalg.norm(after[j] - before[i], axis=1)
    reach = np.array([units[k].height for k in kinds[i]])
    turn = np.array([nearest_labels(last[a], found.poses[b], units[kinds[a]])[1] for a, b in zip(i, j, strict=True)])
    cost = (move / (TYPICAL_MOVE_HEIGHTS * reach)) ** 2 + (turn / TYPICAL_TURN) ** 2
    both = certain[i] & found.certain[j]
    confirms = (move < CONFIRM_MOVE_HEIGHTS * reach) & (turn < CONFIRM_TURN)
    # at nearly the same place it is the same unit whatever its turn: no other fits into the space
    allowed = np.where(both, (cost < MAX_COST) | (move < 0.2 * reach), confirms) & (move <= MAX_MOVE_HEIGHTS * reach)
    i, j, cost = i[allowed], j[allowed], cost[allowed]
    if not len(i):
        return []
    graph = coo_matrix((np.ones(len(i)), (i, j + len(before))), shape=(len(before) + len(after),) * 2)
    part = connected_components(graph, directed=False)[1][i]
    pairs: list[tuple[int, int]] = []
    # far more than any cost, so that as many units as possible keep their identity
    absent = 1e3
    for component in np.unique(part):
        own = part == component
        left, right = np.unique(i[own]), np.unique(j[own])
        table = np.full((len(left), len(right)), absent)
        table[np.searchsorted(left, i[own]), np.searchsorted(right, j[own])] = cost[own]
        pairs += [(int(left[a]), int(right[b])) for a, b in zip(*linear_sum_assignment(table), strict=True) if table[a, b] < absent]
    return sorted(pairs)
