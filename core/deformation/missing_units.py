"""Units that an epoch does not show: their places are looked at again, and those that are there are taken up.

Units of one home lie together: they are one question to the points around them, and no more than these are read at a time.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray, IntArray
from ..common.neighbourhood import point_tree
from ..common.voxels import thin
from ..model.pose import Pose
from ..model.tetrapod import distance_to_surface
from ..model.unit_types import UnitType
from ..segmentation.innermost_layer import innermost_layer
from ..segmentation.leg_ends import LegEnds
from ..segmentation.segment import FOUND_SCORE, MOST_IN_NOISE
from ..segmentation.surface_elements import THINNING_RATIO, surface_noise
from ..segmentation.verification import MOST_OVERLAP, overlap
from .evidence_of_epochs import (
    DOUBTED,
    SAME_PLACE_HEIGHTS,
    is_near,
    is_sparse_there,
    joint_score,
    noise_taken_off,
    score_at_rest,
    shown_there,
)
from .fitted_unit import FittedUnit
from .presence import FEWEST_POINTS, look_up, settled_on
from .questions import Answer, Ask
from .tracked_epoch import TrackedEpoch
from .unit_clouds import ReadCloud, Sources, UnitCloud
from .unit_places import UnitPlaces
from .unit_states import SURE_SCORE

FEWEST_SPARSE_POINTS = 25
"""Points of a unit that is taken up, at least, where the cloud is sparse; elsewhere as many as a pose is adjusted from."""
LOOK_UP_RATIO, LOOK_UP_NOISE = 0.025, 3.0
"""Distance of a point from where another epoch predicts a unit's surface, as a share of the height and in standard deviations of a point's
noise, up to which it lies on it: whichever is more, as a window narrower than the noise keeps only the points that the prediction likes."""
LOOK_UP_REACHES = 1.35
"""Distance from a missing unit's centre, in reaches of a unit, in which its place is looked at."""
LEAST_SCORE = 0.4
"""Score of a pose of weak evidence from which it is looked for in another epoch."""
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
    rivals
        (k,) how that epoch shows them itself, far from there, each one of the owners; None of those that it misses.
    owners
        Units of that epoch around them: their points are taken.
    beside
        Units of the other epoch around them.
    now, before
        Points around them in that epoch and in the other one.
    reach
        Distance from their centres up to which these are read, metres.
    height
        Of the largest type of unit, metres.
    """

    units: tuple[FittedUnit, ...]
    moves: FloatArray
    rivals: tuple[FittedUnit | None, ...]
    owners: tuple[FittedUnit, ...]
    beside: tuple[FittedUnit, ...]
    now: Around
    before: Around
    reach: float
    height: float

    @cached_property
    def noises(self) -> tuple[float, float]:
        """Of a point of either epoch where noise is taken off, metres, else 0: see :func:`.evidence_of_epochs.noise_taken_off`."""
        return noise_taken_off(self.owners), noise_taken_off((*self.beside, *self.units))

    def answer(self) -> Answer:
        """By unit its ``state``, where it is (``centre``, ``rotation``) and its joint ``score``, not finite where that was not asked;
        ``points`` and ``sources`` of those that are there, each unit's from one of ``offsets`` to the next."""
        shown, of = self.now()
        points, sources = _innermost(shown, of, self.height)
        other, _ = _innermost(*self.before(), self.height)
        tree, other_tree = point_tree(points), point_tree(other)
        owner_tree = cKDTree(np.array([u.pose.centre for u in self.owners]).reshape(-1, 3))
        noise = surface_noise(points, self.height, tree=tree) if len(points) else 0.0
        sparse = is_sparse_there(self.owners, points, self.height)
        fewest = FEWEST_SPARSE_POINTS if sparse else FEWEST_POINTS
        states, poses, taken, scores = [], [], [], []
        for known, move, rival in zip(self.units, self.moves, self.rivals, strict=True):
            pose = known.pose.shifted(move)
            index = np.sort(np.array(tree.query_ball_point(pose.centre, self.reach), dtype=np.int64))
            around = other[other_tree.query_ball_point(known.pose.centre, self.reach)] + move
            tolerance = max(LOOK_UP_RATIO * known.shape.height, LOOK_UP_NOISE * noise)
            before = known.cloud.read()[0] + move
            state: str = look_up(before, pose, known.shape, around, points[index], tolerance).state
            if state == "hidden" and len(points) < len(shown):
                # what was taken for layers may be rough ground, which shows as well that nothing stands on it
                every = shown[np.sum((shown - pose.centre) ** 2, axis=1) < self.reach**2]
                state = "empty" if look_up(before, pose, known.shape, around, every, tolerance).state == "empty" else state
            own, score = np.zeros(0, dtype=np.int64), math.nan
            if state == "there":
                owned = (self.owners[k] for k in owner_tree.query_ball_point(pose.centre, 2 * self.reach))
                near = [owner for owner in owned if owner is not rival]
                free = _left_by(near, points, index)
                if rival is None:
                    pose = settled_on(points[free], pose, known.shape, tolerance, fewest)
                own = free[np.abs(distance_to_surface(pose.to_body(points[free]), known.shape)) < tolerance]
                most = MOST_OVERLAP if known.certain else MOST_IN_NOISE
                if len(own) < fewest or _enters(pose, known.shape, near, most):
                    state, own = "hidden", own[:0]
                elif rival is not None or known.score < SURE_SCORE or not known.certain:
                    beside, both = shown_there(self.beside, known, move, near), (points[index], around)
                    if rival is None:
                        score = joint_score(known, known.pose.shifted(move), pose, near, beside, both, sparse, self.noises)
                    else:
                        score, pose = score_at_rest(known, pose, rival.pose, near, beside, both, sparse, self.noises)
                        own = free[np.abs(distance_to_surface(pose.to_body(points[free]), known.shape)) < tolerance]
            scores.append(score)
            states.append(state)
            poses.append(pose)
            taken.append(own)
        used = np.concatenate(taken)
        return {
            "state": np.array(states),
            "centre": np.array([pose.centre for pose in poses]),
            "rotation": np.array([pose.rotation for pose in poses]),
            "score": np.array(scores),
            "points": points[used],
            "sources": sources[used],
            "offsets": np.cumsum([0, *map(len, taken)]),
        }


def _innermost(points: FloatArray, sources: Sources, height: float) -> ReadCloud:
    """(n, 3) points and (n,) sources without the layers that images leave before a surface: on them, what is gone seems to be there."""
    kept = innermost_layer(points, thin(points, THINNING_RATIO * height)[0], height)
    return (points, sources) if kept is None else (points[kept], sources[kept])


def look_for_missing(
    epochs: Sequence[TrackedEpoch],
    seen: Sequence[dict[int, FittedUnit]],
    units: Sequence[UnitType],
    shifts: FloatArray,
    surroundings: Surroundings | None,
    ask: Ask,
) -> tuple[list[dict[int, str]], list[tuple[int, int, FittedUnit]], dict[int, bool]]:
    """State of every unit in the epochs that do not show it, and units recovered where another epoch predicts them.

    In poor clouds what one epoch alone shows with a score that leaves a doubt is held against what the other says of the place.

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
    verdicts
        By unit whose evidence another epoch has changed, whether it is certain now.
    """
    states: list[dict[int, str]] = [{} for _ in seen]
    wanted: dict[tuple[int, ...], list[int]] = {}
    for unit, sightings in enumerate(seen):
        for epoch, reference in _asked(sightings, len(epochs)):
            wanted.setdefault((epoch, reference, *sightings[reference].cloud.home), []).append(unit)
            if sightings[reference].certain:
                states[unit][epoch] = "hidden"
    if surroundings is None:
        return states, [], {}
    certain = [[unit for unit in epoch.units if unit.certain] for epoch in epochs]
    return _weighed(seen, states, _answered(wanted, seen, units, UnitPlaces(certain, seen, shifts), surroundings, ask))


def look_for_rest(
    seen: Sequence[dict[int, FittedUnit]],
    count: int,
    units: Sequence[UnitType],
    shifts: FloatArray,
    surroundings: Surroundings | None,
    ask: Ask,
) -> list[tuple[int, int, FittedUnit]]:
    """Units that two epochs show far apart, taken up at rest where a poor epoch's points speak for it as well.

    In noise part of one unit and its neighbours looks like a unit between them, now and then, in one epoch. Asked once the units are there
    that one epoch misses: with the points of these it would again. Of units that moved the places say so, however little: where they would
    rest the other epoch's points score nothing.

    Parameters
    ----------
    seen
        By unit, its sightings by epoch, those included that were recovered.
    count
        Number of epochs.
    units, shifts, surroundings, ask
        As of :func:`look_for_missing`.

    Returns
    -------
    recovered
        Unit, epoch, and the unit as that epoch shows it.
    """
    if surroundings is None:
        return []
    wanted: dict[tuple[int, ...], list[int]] = {}
    for unit, sightings in enumerate(seen):
        for epoch, reference in _far_apart(sightings, shifts):
            wanted.setdefault((epoch, reference, *sightings[reference].cloud.home), []).append(unit)
    certain = [[own[epoch] for own in seen if epoch in own and own[epoch].certain] for epoch in range(count)]
    return [
        (unit, epoch, _taken_up(seen[unit][reference], answer, k))
        for (epoch, reference, *_), asked, answer in _answered(wanted, seen, units, UnitPlaces(certain, seen, shifts), surroundings, ask)
        for k, unit in enumerate(asked)
        if answer["state"][k] == "there" and answer["score"][k] >= FOUND_SCORE
    ]


def _answered(
    wanted: Mapping[tuple[int, ...], Sequence[int]],
    seen: Sequence[Mapping[int, FittedUnit]],
    units: Sequence[UnitType],
    places: UnitPlaces,
    surroundings: Surroundings,
    ask: Ask,
) -> Iterator[tuple[tuple[int, ...], Sequence[int], Answer]]:
    """Answers about units by epoch asked, epoch that shows them, and their home there; with both."""
    order = sorted(wanted)
    height, reach = max(u.height for u in units), max(u.reach for u in units) * LOOK_UP_REACHES
    questions = []
    for key in order:
        epoch, reference, *_ = key
        known = tuple(seen[unit][reference] for unit in wanted[key])
        asked = places.asked(reference, epoch, known, 2 * reach)
        questions.append(
            MissingUnits(
                units=known,
                moves=asked.moves,
                rivals=tuple(seen[unit].get(epoch) if seen[unit][reference].certain else None for unit in wanted[key]),
                owners=asked.owners,
                beside=asked.beside,
                now=surroundings(epoch, asked.there, reach),
                before=surroundings(reference, asked.here, reach),
                reach=reach,
                height=height,
            )
        )
    return ((key, wanted[key], answer) for key, answer in zip(order, ask(questions), strict=True))


def _weighed(
    seen: Sequence[dict[int, FittedUnit]], states: list[dict[int, str]], answers: Iterable[tuple[tuple[int, ...], Sequence[int], Answer]]
) -> tuple[list[dict[int, str]], list[tuple[int, int, FittedUnit]], dict[int, bool]]:
    """What :func:`look_for_missing` returns, from answers with their epochs (asked, and the one that shows the units) and units."""
    recovered: list[tuple[int, int, FittedUnit]] = []
    confirmed: list[tuple[int, int, int, FittedUnit]] = []
    verdicts: dict[int, bool] = {}
    for (epoch, reference, *_), units, answer in answers:
        for k, unit in enumerate(units):
            shown, score = seen[unit][reference], float(answer["score"][k])
            there = str(answer["state"][k]) == "there"
            if not shown.certain:
                if there and score >= FOUND_SCORE:
                    confirmed.append((unit, epoch, reference, _taken_up(shown, answer, k)))
            elif score < DOUBTED:
                if len(seen[unit]) == 1:
                    verdicts[unit] = False
            else:
                states[unit][epoch] = str(answer["state"][k])
                if there:
                    recovered.append((unit, epoch, _taken_up(shown, answer, k)))
    for unit, epoch, reference, sighting in sorted(confirmed, key=lambda item: (-item[3].score, item[:2])):
        if _has_room(seen[unit][reference], reference, recovered) and _has_room(sighting, epoch, recovered):
            verdicts[unit] = True
            if epoch not in seen[unit]:
                states[unit][epoch] = "there"
                recovered.append((unit, epoch, sighting))
    return states, recovered, verdicts


def _taken_up(shown: FittedUnit, answer: Answer, k: int) -> FittedUnit:
    """A unit as the k-th answer finds it where the epoch that shows it predicts it, with what both say of it."""
    own = slice(*answer["offsets"][k : k + 2])
    return replace(
        shown,
        pose=Pose(answer["centre"][k], answer["rotation"][k]),
        cloud=UnitCloud.held(answer["points"][own].copy(), answer["sources"][own].copy()),
        legs=LegEnds.unseen(),
        score=float(answer["score"][k]) if math.isfinite(answer["score"][k]) else shown.score,
        certain=True,
    )


def _has_room(unit: FittedUnit, epoch: int, recovered: Sequence[tuple[int, int, FittedUnit]]) -> bool:
    """Whether none of the recovered units stands in the place of a unit in an epoch."""
    places = [other.pose.centre for _, own, other in recovered if own == epoch]
    return all(np.linalg.norm(unit.pose.centre - place) >= SAME_PLACE_HEIGHTS * unit.shape.height for place in places)


def _asked(sightings: Mapping[int, FittedUnit], epochs: int) -> list[tuple[int, int]]:
    """Epochs in which a unit is looked for, each with the one that shows it: the nearest of those that are certain of it.

    Of weak evidence the strongest is looked for: where no other epoch shows it, or else in the epoch that shows it best besides.
    """
    shown = [e for e, s in sightings.items() if s.certain]
    if shown:
        return [(e, min(shown, key=lambda s: (abs(s - e), s))) for e in range(epochs) if e not in sightings]
    best, *others = sorted(sightings, key=lambda e: (-sightings[e].score, e))
    if sightings[best].score < LEAST_SCORE or sightings[best].covariance is None:
        return []
    return [(e, best) for e in (others[:1] or range(epochs)) if e != best]


def _far_apart(sightings: Mapping[int, FittedUnit], shifts: FloatArray) -> list[tuple[int, int]]:
    """Epochs that are certain of a unit far from where the surest one shows it, each with that one; ``shifts`` as of the clouds.

    So far that weak evidence would not be taken for the same unit.
    """
    shown = [e for e, s in sightings.items() if s.certain]
    if not shown:
        return []
    best = max(shown, key=lambda e: (sightings[e].score, -e))
    moved = {e: sightings[best].pose.shifted(shifts[e] - shifts[best]) for e in shown}
    return [(e, best) for e in shown if e != best and not is_near(moved[e], sightings[e].pose, sightings[e].shape)]


def _enters(pose: Pose, shape: UnitType, owners: Sequence[FittedUnit], most: float) -> bool:
    """Whether more than a share of a unit in this pose would be where one of the epoch's units is: no two solids share a place."""
    return any(overlap(pose.as_row(), owner.pose.as_row(), shape, owner.shape) > most for owner in owners)


def _left_by(owners: Sequence[FittedUnit], points: FloatArray, index: IntArray) -> IntArray:
    """Those of the indices whose points belong to none of the units."""
    for owner in sorted(owners, key=lambda u: u.cloud.home):
        own, _ = owner.cloud.read()
        if len(own) and len(index):
            index = index[cKDTree(own).query(points[index])[0] > SAME_POINT]
    return index
