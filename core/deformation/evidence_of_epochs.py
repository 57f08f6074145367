"""How sure a unit that one epoch shows is by what the points of another epoch say of its place, and by the points of both."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..common.arrays import FloatArray
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..segmentation.aggregation import assign
from ..segmentation.pose_score import SPARSE_RATIO
from ..segmentation.second_look import SecondLook, second_look
from ..segmentation.segment import FEWEST_POINTS, FOUND_SCORE, cloud_elements
from ..segmentation.unit_size import point_spacing
from .fitted_unit import FittedUnit
from .identity import CONFIRM_MOVE_HEIGHTS, CONFIRM_TURN, nearest_labels
from .unit_states import RECOVERED_SCORE

SAME_PLACE_HEIGHTS = 0.5
"""Distance of two centres, in unit heights, within which no two solids fit."""
SMEARED_HEIGHTS, SMEARED_TURN = 0.02, math.radians(3.0)
"""Move of a centre, in unit heights, and turn beyond which points of two epochs laid together do not fit one pose."""
MOVES_WITH_HEIGHTS = 0.05
"""Distance of a point from a neighbour's surface, in unit heights, within which it does not move with a unit."""
DOUBTED = 0.5
"""Score of two epochs' points laid together below which what one of them states is weak evidence: it is likelier none than a unit. From
``FOUND_SCORE`` on weak evidence is a unit."""


def joint_score(
    known: FittedUnit,
    rest: Pose,
    pose: Pose,
    owners: Sequence[FittedUnit],
    beside: Sequence[FittedUnit],
    around: tuple[FloatArray, FloatArray],
    sparse: bool,
    noises: tuple[float, float],
) -> float:
    """Probability of a unit by another epoch's (n, 3) points around it and its own, shifted to where it is at ``rest``, laid together.

    What rests looks alike in both, rock too, and would count twice if each were judged by itself and the odds multiplied; noise is
    another one in each. Not finite where these cannot tell: in rich clouds what fits by chance may do so in all epochs, where these do not
    speak against it, and what moved is another question. ``pose`` is where the other epoch's points draw it; ``noises`` are those of both
    epochs, see :func:`noise_taken_off`.
    """
    now, before = around
    noise, shared = noises[0], noise_of_both(noises)
    look = _look_at(pose, known.shape, owners, now, sparse, noise=noise)
    everybody, share_noise = [*owners, *beside], _share_noise([look])
    both = _look_at(pose, known.shape, everybody, np.vstack([now, before]), sparse, shared_noise=share_noise, noise=shared)
    if look is not None and look.score >= FOUND_SCORE:
        # what both epochs' points draw to another place alike was placed badly, and has not moved
        places = [pose] if both is None else [pose, both.place]
        if not any(is_near(look.place, place, known.shape) for place in places):
            return math.nan
        if both is not None and shared > 0 and both.score < RECOVERED_SCORE and _has_moved(rest, look.place, known.shape):
            # what moved fits no one pose where the points of both epochs are laid together as if it rested
            moved = np.vstack([now, _moved_with(rest, look.place, known.shape, everybody, before)])
            again = _look_at(look.place, known.shape, everybody, moved, sparse, shared_noise=share_noise, noise=shared)
            both = both if again is None else max(both, again, key=lambda one: one.score)
    if both is None:
        return _spoken_against(known, pose, owners, now, noise) if look is None else _said_once(known.score, look.score)
    # by its own epoch it was judged among more units: what the points do not speak against stays as sure as it was
    return both.score if both.score < RECOVERED_SCORE else max(both.score, known.score)


def score_at_rest(
    known: FittedUnit,
    pose: Pose,
    rival: Pose,
    owners: Sequence[FittedUnit],
    beside: Sequence[FittedUnit],
    around: tuple[FloatArray, FloatArray],
    sparse: bool,
    noises: tuple[float, float],
) -> tuple[float, Pose]:
    """The same of a unit whose ``rival`` pose the other epoch's points were taken for, not finite where they speak for that one; and where.

    A unit at rest is where it is predicted. Settled on the points of an epoch that shows little of it, it may slide off as it did when it
    was found there; it is therefore judged in its place as well.
    """
    now, before = around
    looks = [
        _look_at(place, known.shape, owners, now, sparse, settle=settle, noise=noises[0])
        for place, settle in ((pose, False), (pose, True), (rival, True))
    ]
    # settled, the other one may have come here as well, or this one have left
    here = [look for look in looks if look is not None and is_near(look.place, pose, known.shape)]
    best = max(here, key=lambda look: look.score, default=None)
    if best is None or best.score < max(FOUND_SCORE, *(look.score for look in looks if look is not None)):
        return math.nan, pose
    both = _look_at(
        pose,
        known.shape,
        [*owners, *beside],
        np.vstack([now, before]),
        sparse,
        shared_noise=_share_noise(looks),
        noise=noise_of_both(noises),
    )
    return math.nan if both is None or both.score < FOUND_SCORE else max(both.score, known.score), best.place


def score_with_twist(pose: Pose, shape: UnitType, owners: Sequence[FittedUnit], around: FloatArray, noise: float) -> tuple[float, Pose]:
    """Probability of a unit whose turn about a leg is known, by the (n, 3) points of two epochs laid together; and where it is then.

    ``noise`` as of :func:`noise_of_both`.
    """
    look = _judged(pose, shape, owners, around, settle=True, rich=True, twist=True, noise=noise)
    return (0.0, pose) if look is None else (look.score * look.certainty, look.place)


def shown_there(beside: Sequence[FittedUnit], known: FittedUnit, move: FloatArray, owners: Sequence[FittedUnit]) -> list[FittedUnit]:
    """Units that the epoch of a unit alone shows around it, where they would be in the other one, whose units are ``owners``."""
    places = [owner.pose.centre for owner in owners]
    return [
        replace(unit, pose=unit.pose.shifted(move))
        for unit in beside
        if unit is not known
        and all(
            np.linalg.norm(unit.pose.centre + move - place) >= SAME_PLACE_HEIGHTS * unit.shape.height
            for place in (*places, known.pose.centre + move)
        )
    ]


def is_sparse_there(owners: Sequence[FittedUnit], points: FloatArray, height: float) -> bool:
    """Whether the number of points limits what an epoch shows, by its unit that holds most, or by (n, 3) points where none is near.

    What is half hidden is sparse in every cloud.
    """
    held = max((owner.cloud.read()[0] for owner in owners), key=len, default=points)
    seen = held if len(held) > 1 else points
    return len(seen) > 1 and point_spacing(seen) > SPARSE_RATIO * height


def noise_taken_off(owners: Sequence[FittedUnit]) -> float:
    """Standard deviation in metres of a point of an epoch of which noise is taken off, by its unit that holds most; 0 of others.

    A place that shows little holds too few points to tell, in every cloud.
    """
    fullest = max(owners, key=lambda owner: len(owner.cloud.read()[0]), default=None)
    held = np.zeros((0, 3)) if fullest is None else fullest.cloud.read()[0]
    if fullest is None or len(held) < FEWEST_POINTS:
        return 0.0
    elements = cloud_elements(np.ascontiguousarray(held), fullest.shape, workers=1).elements
    return elements.noise if elements.smoothed else 0.0


def noise_of_both(noises: tuple[float, float]) -> float:
    """The same of two epochs laid together, from those of each: the larger one, and 0 where one of them has no noise taken off."""
    return max(noises) if min(noises) > 0 else 0.0


def is_near(pose: Pose, other: Pose, shape: UnitType) -> bool:
    """Whether two poses are one to weak evidence."""
    move, turn = np.linalg.norm(other.centre - pose.centre), nearest_labels(pose, other, shape)[1]
    return bool(move < CONFIRM_MOVE_HEIGHTS * shape.height and turn < CONFIRM_TURN)


def _has_moved(rest: Pose, place: Pose, shape: UnitType) -> bool:
    """Whether a unit is so far from where it would rest that points of both epochs laid together there are smeared."""
    move, turn = np.linalg.norm(place.centre - rest.centre), nearest_labels(rest, place, shape)[1]
    return bool(move > SMEARED_HEIGHTS * shape.height or turn > SMEARED_TURN)


def _moved_with(pose: Pose, moved: Pose, shape: UnitType, others: Sequence[FittedUnit], points: FloatArray) -> FloatArray:
    """(n, 3) points where they are once a unit has moved between two poses: those that are of no other unit of its type with it."""
    rows = np.array([one.pose.as_row() for one in others if one.shape == shape]).reshape(-1, 12)
    owner, _ = assign(points, np.vstack([rows, pose.as_row()]), shape, MOVES_WITH_HEIGHTS * shape.height)
    with_it = (owner < 0) | (owner == len(rows))
    return np.where(with_it[:, None], moved.to_frame(pose.to_body(points)), points)


def _spoken_against(known: FittedUnit, pose: Pose, owners: Sequence[FittedUnit], now: FloatArray, noise: float) -> float:
    """Probability of a unit by its own epoch and rich (n, 3) points of another one, where these speak against it; else not finite.

    What fits by chance may fit in all epochs that see it from the same side, so that nothing is said where rich points agree. From other
    sides more is seen of it, and what chance aligned fits no longer, while a unit does.
    """
    if not known.certain:
        return math.nan
    looks = [_judged(pose, known.shape, owners, now, settle=settle, rich=True, noise=noise) for settle in (False, True)]
    best = max((look.score for look in looks if look is not None), default=1.0)
    score = _said_once(known.score, best)
    return score if score < DOUBTED else math.nan


def _said_once(first: float, second: float) -> float:
    """Probability from two epochs that say the same, where their points are too many together to be judged as poor ones: mean log-odds."""
    log_odds = np.mean([np.log(value / (1 - value)) for value in np.clip([first, second], 1e-9, 1 - 1e-9)])
    return float(1 / (1 + np.exp(-log_odds)))


def _share_noise(looks: Sequence[SecondLook | None]) -> bool:
    """Whether neighbours share their noise in the points of one epoch that were looked at."""
    return any(look is not None and look.shared_noise for look in looks)


def _look_at(
    pose: Pose,
    shape: UnitType,
    owners: Sequence[FittedUnit],
    around: FloatArray,
    sparse: bool,
    *,
    settle: bool = True,
    shared_noise: bool = False,
    noise: float = 0.0,
) -> SecondLook | None:
    """What (n, 3) points of an epoch, or of two, say of a pose among its units; None in rich clouds."""
    look = _judged(pose, shape, owners, around, settle=settle, rich=False, shared_noise=shared_noise, noise=noise)
    return look if look is not None and (look.noisy or sparse) else None


def _judged(
    pose: Pose,
    shape: UnitType,
    owners: Sequence[FittedUnit],
    around: FloatArray,
    *,
    settle: bool,
    rich: bool,
    twist: bool = False,
    shared_noise: bool = False,
    noise: float = 0.0,
) -> SecondLook | None:
    """The same whatever limits what the epoch shows; None where few points are there, or rich ones unless ``rich`` asks for these."""
    alike = [owner for owner in owners if owner.shape == shape]
    others = np.array([owner.pose.as_row() for owner in alike]).reshape(-1, 12)
    scores = np.array([owner.score for owner in alike])
    return second_look(
        around, pose.as_row(), others, scores, shape, settle=settle, rich=rich, twist=twist, shared_noise=shared_noise, noise=noise
    )
