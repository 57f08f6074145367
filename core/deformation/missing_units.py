"""Units that an epoch does not show: their places are looked at again, and those that are there are taken up.

Units of one home lie together: they are one question to the points around them, and no more than these are read at a time.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray, IntArray
from ..common.neighbourhood import point_tree
from ..model.pose import Pose
from ..model.tetrapod import distance_to_surface
from ..model.unit_types import UnitType
from ..segmentation.leg_ends import LegEnds
from ..segmentation.pose_score import SPARSE_RATIO
from ..segmentation.surface_elements import surface_noise
from ..segmentation.verification import MOST_OVERLAP, overlap
from .fitted_unit import FittedUnit
from .presence import FEWEST_POINTS, look_up, settled_on
from .questions import Answer, Ask
from .tracked_epoch import TrackedEpoch
from .unit_clouds import ReadCloud, UnitCloud

FEWEST_SPARSE_POINTS = 25
"""Points of a unit that is taken up, at least, where the cloud is sparse; elsewhere as many as a pose is adjusted from."""
LOOK_UP_RATIO, LOOK_UP_NOISE = 0.025, 3.0
"""Distance of a point from where another epoch predicts a unit's surface, as a share of the height and in standard deviations of a point's
noise, up to which it lies on it: whichever is more, as a window narrower than the noise keeps only the points that the prediction likes."""
LOOK_UP_REACHES = 1.35
"""Distance from a missing unit's centre, in reaches of a unit, in which its place is looked at."""
NEIGHBOURS = 9
"""Units whose median motion says where a unit would be that one epoch does not show."""
SAME_POINT = 1e-4
"""Distance in metres below which a point of the cloud is the point of a unit."""

Around = Callable[[], ReadCloud]
"""Reads (n, 3) points of an epoch and their (n,) sources, control frame less the reduction point."""
Surroundings = Callable[[int, FloatArray, float], Around]
"""Of an epoch (index) within a distance of (k, 3) places."""


@dataclass(frozen=True, eq=False, kw_only=True)
class MissingUnits:
    """Question: whether units that another epoch shows are still there.

    Attributes
    ----------
    units
        As the other epoch shows them.
    moves
        (k, 3) by which the cloud around each of them lies elsewhere in the epoch that misses it.
    owners
        Units of that epoch around them: their points are taken.
    now, before
        Points around them in that epoch and in the other one.
    reach
        Distance from their centres up to which these are read, metres.
    height
        Of the largest type of unit, metres.
    """

    units: tuple[FittedUnit, ...]
    moves: FloatArray
    owners: tuple[FittedUnit, ...]
    now: Around
    before: Around
    reach: float
    height: float

    def answer(self) -> Answer:
        """By unit its ``state`` and where it is (``centre``, ``rotation``); ``points`` and ``sources`` of those that are there, each unit's
        from one of ``offsets`` to the next."""
        points, sources = self.now()
        other, _ = self.before()
        tree, other_tree = point_tree(points), point_tree(other)
        owner_tree = cKDTree(np.array([u.pose.centre for u in self.owners]).reshape(-1, 3))
        noise = surface_noise(points, self.height, tree=tree) if len(points) else 0.0
        fewest = _fewest_points(points, tree, self.height)
        states, poses, taken = [], [], []
        for known, move in zip(self.units, self.moves, strict=True):
            pose = known.pose.shifted(move)
            index = np.sort(np.array(tree.query_ball_point(pose.centre, self.reach), dtype=np.int64))
            around = other[other_tree.query_ball_point(known.pose.centre, self.reach)] + move
            tolerance = max(LOOK_UP_RATIO * known.shape.height, LOOK_UP_NOISE * noise)
            state: str = look_up(known.cloud.read()[0] + move, pose, known.shape, around, points[index], tolerance).state
            own = np.zeros(0, dtype=np.int64)
            if state == "there":
                near = [self.owners[k] for k in owner_tree.query_ball_point(pose.centre, 2 * self.reach)]
                free = _left_by(near, points, index)
                pose = settled_on(points[free], pose, known.shape, tolerance, fewest)
                own = free[np.abs(distance_to_surface(pose.to_body(points[free]), known.shape)) < tolerance]
                if len(own) < fewest or _enters(pose, known.shape, near):
                    state, own = "hidden", own[:0]
            states.append(state)
            poses.append(pose)
            taken.append(own)
        every = np.concatenate(taken)
        return {
            "state": np.array(states),
            "centre": np.array([pose.centre for pose in poses]),
            "rotation": np.array([pose.rotation for pose in poses]),
            "points": points[every],
            "sources": sources[every],
            "offsets": np.cumsum([0, *map(len, taken)]),
        }


def look_for_missing(
    epochs: Sequence[TrackedEpoch],
    seen: Sequence[dict[int, FittedUnit]],
    units: Sequence[UnitType],
    shifts: FloatArray,
    surroundings: Surroundings | None,
    ask: Ask,
) -> tuple[list[dict[int, str]], list[tuple[int, int, FittedUnit]]]:
    """State of every unit in the epochs that do not show it, and units recovered where another epoch predicts them.

    Parameters
    ----------
    epochs
        In order of time.
    seen
        By unit, its sightings by epoch.
    units
        Types of unit.
    shifts
        (e, 3) common shift of the clouds, metres.
    surroundings
        Of places in an epoch's cloud; None where only the fits are known, and all that is not seen is hidden.
    ask
        Answers questions.

    Returns
    -------
    states
        By unit and epoch that does not show it: ``there``, ``empty`` or ``hidden``.
    recovered
        Unit, epoch, and the unit as that epoch shows it.
    """
    states: list[dict[int, str]] = [{} for _ in seen]
    wanted: dict[tuple[int, ...], list[int]] = {}
    for unit, sightings in enumerate(seen):
        certain = [e for e, s in sightings.items() if s.certain]
        for epoch in range(len(epochs)) if certain else ():
            if epoch not in sightings:
                reference = min(certain, key=lambda e: (abs(e - epoch), e))
                wanted.setdefault((epoch, reference, *sightings[reference].cloud.home), []).append(unit)
                states[unit][epoch] = "hidden"
    if surroundings is None:
        return states, []
    order = sorted(wanted)
    height, reach = max(u.height for u in units), max(u.reach for u in units) * LOOK_UP_REACHES
    places = _Places(epochs, seen, shifts)
    questions = []
    for key in order:
        epoch, reference, *_ = key
        known = tuple(seen[unit][reference] for unit in wanted[key])
        centres = np.array([unit.pose.centre for unit in known])
        moves = places.shifts(reference, epoch, centres)
        questions.append(
            MissingUnits(
                units=known,
                moves=moves,
                owners=places.owners(epoch, centres + moves, 2 * reach),
                now=surroundings(epoch, centres + moves, reach),
                before=surroundings(reference, centres, reach),
                reach=reach,
                height=height,
            )
        )
    recovered: list[tuple[int, int, FittedUnit]] = []
    for key, answer in zip(order, ask(questions), strict=True):
        epoch, reference, *_ = key
        for k, unit in enumerate(wanted[key]):
            states[unit][epoch] = str(answer["state"][k])
            if states[unit][epoch] == "there":
                own = slice(*answer["offsets"][k : k + 2])
                cloud = UnitCloud.held(answer["points"][own].copy(), answer["sources"][own].copy())
                pose = Pose(answer["centre"][k], answer["rotation"][k])
                recovered.append((unit, epoch, replace(seen[unit][reference], pose=pose, cloud=cloud, legs=LegEnds.unseen())))
    return states, recovered


class _Places:
    """Where units are that questions need, epoch by epoch."""

    def __init__(self, epochs: Sequence[TrackedEpoch], seen: Sequence[Mapping[int, FittedUnit]], shifts: FloatArray) -> None:
        self._seen, self._shifts = seen, shifts
        self._certain = [[u for u in epoch.units if u.certain] for epoch in epochs]
        self._trees = [cKDTree(np.array([u.pose.centre for u in own]).reshape(-1, 3)) for own in self._certain]
        self._both: dict[tuple[int, int], tuple[cKDTree, FloatArray] | None] = {}

    def owners(self, epoch: int, places: FloatArray, reach: float) -> tuple[FittedUnit, ...]:
        """Certain units of an epoch within a distance of (k, 3) places."""
        near = sorted({k for around in self._trees[epoch].query_ball_point(places, reach) for k in around})
        return tuple(self._certain[epoch][k] for k in near)

    def shifts(self, first: int, second: int, places: FloatArray) -> FloatArray:
        """(k, 3) shift between two epochs' clouds at (k, 3) places: the median of the nearest units that both show, or the common one."""
        if (first, second) not in self._both:
            both = [(s[first].pose.centre, s[second].pose.centre) for s in self._seen if first in s and second in s and s[first].certain]
            known = None
            if len(both) >= NEIGHBOURS:
                before, after = (np.array(column) for column in zip(*both, strict=True))
                known = cKDTree(before), after - before
            self._both[first, second] = known
        known = self._both[first, second]
        if known is None:
            return np.tile(self._shifts[second] - self._shifts[first], (len(places), 1))
        return np.asarray(np.median(known[1][known[0].query(places, k=NEIGHBOURS)[1]], axis=1))


def _fewest_points(points: FloatArray, tree: cKDTree, height: float) -> int:
    """Points of a unit that is taken up among (n, 3) points: in sparse clouds their number, and not what is seen, is what limits."""
    if len(points) < 2:
        return FEWEST_POINTS
    spacing = float(np.median(tree.query(points, k=2)[0][:, 1]))
    return FEWEST_SPARSE_POINTS if spacing > SPARSE_RATIO * height else FEWEST_POINTS


def _enters(pose: Pose, shape: UnitType, owners: Sequence[FittedUnit]) -> bool:
    """Whether a unit in this pose would be partly where one of the epoch's units is: no two solids share a place."""
    rows = [np.concatenate([p.centre, p.rotation.ravel()]) for p in (pose, *(owner.pose for owner in owners))]
    return any(overlap(rows[0], row, shape, owner.shape) > MOST_OVERLAP for row, owner in zip(rows[1:], owners, strict=True))


def _left_by(owners: Sequence[FittedUnit], points: FloatArray, index: IntArray) -> IntArray:
    """Those of the indices whose points belong to none of the units."""
    for owner in sorted(owners, key=lambda u: u.cloud.home):
        own, _ = owner.cloud.read()
        if len(own) and len(index):
            index = index[cKDTree(own).query(points[index])[0] > SAME_POINT]
    return index
