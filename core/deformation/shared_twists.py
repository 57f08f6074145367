"""Units of which two epochs show one leg, each leaving the turn about it open: the points of both, laid together, may settle it.

Other epochs show other slivers of a unit and other neighbours, and all of them have to fit one pose, as long as it stands still. What rests
looks alike in both and is thinned to the same elements, so that it counts once.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..segmentation.segment import FOUND_SCORE
from .evidence_of_epochs import noise_of_both, noise_taken_off, score_with_twist, shown_there
from .fitted_unit import FittedUnit
from .identity import CONFIRM_MOVE_HEIGHTS, Track, nearest_labels
from .missing_units import LOOK_UP_REACHES, Around, Surroundings
from .questions import Answer, Ask
from .unit_places import UnitPlaces

Place = tuple[int, int]
"""A unit (index) in an epoch."""


@dataclass(frozen=True, eq=False, kw_only=True)
class OpenTwists:
    """Question: how far the points of two epochs together know units that each of them leaves open.

    Attributes
    ----------
    units
        As the epoch shows them that is surer.
    moves
        (k, 3) by which the cloud around each of them lies elsewhere in the other epoch.
    owners, beside
        Certain units around them of that epoch, and of the one that shows them.
    now, before
        Points around them in the same two.
    reach
        Distance from their centres up to which these are read, metres.
    """

    units: tuple[FittedUnit, ...]
    moves: FloatArray
    owners: tuple[FittedUnit, ...]
    beside: tuple[FittedUnit, ...]
    now: Around
    before: Around
    reach: float

    def answer(self) -> Answer:
        """By unit its joint ``score`` and, where the other epoch has it, its ``pose`` (12,)."""
        clouds = self.now()[0], self.before()[0]
        trees = [cKDTree(points) for points in clouds]
        places = np.array([owner.pose.centre for owner in self.owners]).reshape(-1, 3)
        noise = noise_of_both((noise_taken_off(self.owners), noise_taken_off((*self.beside, *self.units))))
        scores, poses = [], []
        for known, move in zip(self.units, self.moves, strict=True):
            pose = known.pose.shifted(move)
            now, before = (
                points[tree.query_ball_point(centre, self.reach)]
                for points, tree, centre in zip(clouds, trees, (pose.centre, known.pose.centre), strict=True)
            )
            near = [self.owners[k] for k in np.flatnonzero(np.linalg.norm(places - pose.centre, axis=1) < 2 * self.reach)]
            beside = shown_there(self.beside, known, move, near)
            score, pose = score_with_twist(pose, known.shape, [*near, *beside], np.vstack([now, before + move]), noise)
            scores.append(score)
            poses.append(pose.as_row())
        return {"score": np.array(scores), "pose": np.array(poses)}


def settle_together(
    tracks: Sequence[Track],
    seen: Sequence[dict[int, FittedUnit]],
    units: Sequence[UnitType],
    shifts: FloatArray,
    surroundings: Surroundings | None,
    ask: Ask,
) -> tuple[list[Track], list[dict[int, FittedUnit]]]:
    """Tracks and sightings with those made one, and certain, of which two epochs together know the turn that each leaves open.

    Parameters
    ----------
    tracks, seen
        By unit: its track, and its sightings by epoch.
    units
        Types of unit.
    shifts
        (e, 3) common shift of the clouds, metres.
    surroundings
        Of places in an epoch's cloud; None where only the fits are known, and nothing is settled.
    ask
        Answers questions.
    """
    joined, known = list(tracks), list(seen)
    gone: set[int] = set()
    for (unit, epoch), (twin, other), answer, pose in _answered(seen, units, shifts, surroundings, ask):
        if answer < FOUND_SCORE:
            continue
        first = (unit, epoch) if epoch < other else (twin, other)
        own = known[first[0]][first[1]]
        here = pose[first[1]]
        here = here.relabelled(nearest_labels(own.pose, here, own.shape)[0])
        track, sightings = joined[first[0]], dict(known[first[0]])
        for number, where in ((unit, epoch), (twin, other)):
            sighting = known[number][where]
            symmetry, *_ = nearest_labels(here, sighting.pose, sighting.shape)
            placed = Pose(pose[where].centre, here.rotation)
            sightings[where] = replace(sighting.relabelled(symmetry), pose=placed, certain=True, twist_open=False, score=answer)
            track = replace(
                track,
                rows=track.rows | {where: joined[number].rows[where]},
                symmetries=track.symmetries | {where: joined[number].symmetries[where] @ symmetry},
            )
        joined[first[0]], known[first[0]] = track, sightings
        gone |= {unit, twin} - {first[0]}
    kept = [k for k in range(len(joined)) if k not in gone]
    return [joined[k] for k in kept], [known[k] for k in kept]


def _answered(
    seen: Sequence[Mapping[int, FittedUnit]],
    units: Sequence[UnitType],
    shifts: FloatArray,
    surroundings: Surroundings | None,
    ask: Ask,
) -> Iterator[tuple[Place, Place, float, dict[int, Pose]]]:
    """Units that two epochs leave open, the surer one first, with the score of both together and the pose in either epoch."""
    wanted: dict[tuple[int, ...], list[tuple[Place, Place]]] = {}
    for surer, other in _open_in_two(seen, shifts):
        wanted.setdefault((other[1], surer[1], *seen[surer[0]][surer[1]].cloud.home), []).append((surer, other))
    if surroundings is None or not wanted:
        return
    reach = max(u.reach for u in units) * LOOK_UP_REACHES
    certain = [[own[epoch] for own in seen if epoch in own and own[epoch].certain] for epoch in range(len(shifts))]
    places = UnitPlaces(certain, seen, shifts)
    questions = []
    for key in sorted(wanted):
        epoch, reference, *_ = key
        known = tuple(seen[unit][reference] for (unit, _), _ in wanted[key])
        asked = places.asked(reference, epoch, known, 2 * reach)
        questions.append(
            OpenTwists(
                units=known,
                moves=asked.moves,
                owners=asked.owners,
                beside=asked.beside,
                now=surroundings(epoch, asked.there, reach),
                before=surroundings(reference, asked.here, reach),
                reach=reach,
            )
        )
    for key, question, answer in zip(sorted(wanted), questions, ask(questions), strict=True):
        for (surer, other), move, score, row in zip(wanted[key], question.moves, answer["score"], answer["pose"], strict=True):
            pose = Pose.of_row(row)
            yield surer, other, float(score), {other[1]: pose, surer[1]: pose.shifted(-move)}


def _open_in_two(seen: Sequence[Mapping[int, FittedUnit]], shifts: FloatArray) -> list[tuple[Place, Place]]:
    """Pairs of open sightings of two epochs in one place, the surer first; every unit once, with what lies nearest.

    Of one unit, or of two that no other epoch shows: what becomes one must not have two sightings in an epoch.
    """
    places = [(k, e) for k, own in enumerate(seen) if not any(s.certain for s in own.values()) for e, s in own.items() if _is_asked(s)]
    if len(places) < 2:
        return []
    shown = [seen[k][e] for k, e in places]
    centres = np.array([s.pose.centre - shifts[e] for s, (_, e) in zip(shown, places, strict=True)])
    limits = CONFIRM_MOVE_HEIGHTS * np.array([s.shape.height for s in shown])
    pairs = cKDTree(centres).query_pairs(float(limits.max()), output_type="ndarray")
    away = np.linalg.norm(centres[pairs[:, 0]] - centres[pairs[:, 1]], axis=1)
    near = away < limits[pairs[:, 0]]
    pairs, away = pairs[near], away[near]
    found: list[tuple[Place, Place]] = []
    taken: set[int] = set()
    for i, j in pairs[np.lexsort((pairs[:, 1], pairs[:, 0], away))]:
        (one, two), own = (places[i], places[j]), {places[i][0], places[j][0]}
        alone = len(own) == 1 or all(len(seen[k]) == 1 for k in own)
        if alone and one[1] != two[1] and shown[i].kind == shown[j].kind and not own & taken:
            taken |= own
            found.append((one, two) if shown[i].score >= shown[j].score else (two, one))
    return found


def _is_asked(sighting: FittedUnit) -> bool:
    """Whether nothing but its turn is open: what has no fit may be anything."""
    return sighting.twist_open and sighting.covariance is not None
