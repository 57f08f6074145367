"""What becomes of every unit in every epoch: found, uncertain, new, lost or unseen, and whether it has a pose there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from ..adjustment.shape_effects import PRIOR_SIZE_SD
from ..common.arrays import BoolArray, FloatArray, IntArray
from ..common.positive_definite import largest_sd
from ..common.robust import sd_of_deviations
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..segmentation.overlaps import REACH_HEIGHTS
from ..segmentation.twist import OPEN_TWIST, ROOM_SD
from ..segmentation.verification import overlap
from .congruence import PoseCalibration
from .fitted_unit import FittedUnit
from .identity import Track
from .joint_records import JointAdjustment
from .tracked_epoch import TrackedUnit

LEAST_SIZE_SPREAD = 0.003
"""Relative standard deviation of the size of units from one set of moulds, at the least."""
SURE_SCORE = 0.99
"""Score of a unit whose size is held against what castings of any moulds differ by, at least."""
ODD_SIZE = 4.5
"""Deviation of a unit's size from that of the others, in standard deviations, above which something else was fitted."""
LARGE_NOISE_RATIO = 0.012
"""Noise of a point, as a share of the height, beyond which a size is no odder than the points of other surfaces make it: these lie within
the noise of a unit's own, and draw it by as much at the most. At 3.3 % of the height 8 right units of six piles, 1 to 5 % larger than the
others, would seem odd, and none that is wrong."""
MOST_OPEN_HEIGHTS = 0.06
"""Standard deviation of a centre in its worst direction, in unit heights, beyond which no one relies on a pose: two and a half of it are as
far as a pose may lie from its unit to be called right (0.15). Recovered units that are right stay below a fortieth."""
MOST_ENTERED = 2.0 * ROOM_SD
"""Share of its volume by which a unit may enter one whose turn is better known where its own is left open: its turn hangs on that room. Of
2800 right units of poor clouds the one that enters another most does so by 0.023."""
RECOVERED_SCORE = 0.8
"""Probability below which one detection does not vouch for the unit in an epoch where it was not detected."""


def odd_sizes(joint: JointAdjustment, kinds: IntArray, units: Sequence[UnitType], sure: BoolArray) -> frozenset[int]:
    """Units whose size differs from that of their kind by more than castings from one set of moulds do.

    The points of a leg that are taken for more, or for another one, make the unit shrink or grow. Units that are ``sure`` are held against
    what castings are known to differ by, at least: forty units may tell a spread a third too small.

    Parameters
    ----------
    kinds, sure
        (k,) index into ``units``, and whether the evidence for the unit leaves no doubt, of each unit of the adjustment.
    """
    scales, sds = (np.array([values[k] for k in range(len(kinds))]) for values in (joint.scales, joint.scale_sds))
    noise = float(np.max(joint.noise, initial=0.0, where=np.isfinite(joint.noise)))
    odd: list[int] = []
    for kind in np.unique(kinds):
        surface = joint.surfaces.get(units[kind])
        if surface is None:
            continue
        own = np.flatnonzero(kinds == kind)
        # an estimate is drawn towards the mean size by what the points leave open, and varies the less
        told = np.maximum(1 - (sds[own] / surface.size_sd) ** 2, 0.04)
        shares = np.abs(scales[own] - np.median(scales[own])) / np.sqrt(told)
        # the unit that is sought must not hide behind the spread that it makes itself; a median of few may be a third too small
        spread = min(surface.size_sd, max(1.5 * sd_of_deviations(shares), LEAST_SIZE_SPREAD))
        away = shares / np.where(sure[own], max(spread, PRIOR_SIZE_SD), spread)
        drawn = noise / units[kind].radius if noise > LARGE_NOISE_RATIO * units[kind].height else 0.0
        odd += own[(away > ODD_SIZE * max(sd_of_deviations(away), 1.0)) & (shares > drawn)].tolist()
    return frozenset(odd)


def states_of(
    unit: int,
    track: Track,
    seen: dict[int, FittedUnit],
    states: dict[int, str],
    joint: JointAdjustment,
    numbers: dict[tuple[int, int], int],
    epochs: int,
    odd: bool,
) -> dict[int, TrackedUnit]:
    """A unit in the epochs that show it, and in those that say what became of it.

    Parameters
    ----------
    seen, states
        Its sightings, recovered ones included, and what the other epochs say of its place (``there``, ``empty``, ``hidden``), by epoch.
    numbers
        Sighting in the joint adjustment by unit and epoch.
    odd
        Whether its size is none that the moulds make.
    """
    tracked: dict[int, TrackedUnit] = {}
    first = min(seen)
    confirmed = not odd and any(s.certain for s in seen.values())
    for epoch in range(epochs):
        if epoch in seen:
            number = numbers[unit, epoch]
            place = joint.order[unit].index(number)
            block = slice(6 * place, 6 * place + 6)
            own = joint.covariances[unit][block, block]
            left_open = _is_open(own, seen[epoch].shape)
            if left_open and epoch not in track.rows:
                tracked |= {epoch: _not_seen("hidden", joint.scales[unit])} if epoch > first else {}
                continue
            vouched = epoch in track.rows or seen[epoch].score >= RECOVERED_SCORE
            status = "found" if confirmed and vouched and not left_open else "uncertain"
            if epoch in track.relocated:
                status = "relocated"
            elif confirmed and epoch == first > 0 and states.get(epoch - 1) == "empty":
                status = "new"
            tracked[epoch] = TrackedUnit(
                row=track.rows.get(epoch),
                pose=joint.poses[number],
                covariance=own,
                scale=1 + joint.scales[unit],
                status=status,
                points=int(joint.used[number]),
                ambiguous=epoch in track.ambiguous,
                legs=seen[epoch].legs,
            )
        elif epoch > first and epoch in states:
            tracked[epoch] = _not_seen(states[epoch], joint.scales[unit])
    return tracked


def doubted_where_open(
    states: Sequence[Mapping[int, TrackedUnit]], shapes: Sequence[UnitType], calibrations: Sequence[PoseCalibration]
) -> list[dict[int, TrackedUnit]] | None:
    """States of all units, uncertain where a found pose is left open once it is known how true the covariances are; None where none is.

    So is one whose turn is left open and that enters a unit of which it is known: the room among neighbours, which alone settles such a
    turn, has another one then.

    Parameters
    ----------
    states, shapes
        Of every unit, by epoch, and its type.
    calibrations
        What units at rest say of the covariances of each epoch.
    """
    doubted: list[set[int]] = [set() for _ in states]
    open_turns: dict[int, set[int]] = {}
    entering: set[int] = set()
    for epoch, calibration in enumerate(calibrations):
        poses: dict[int, Pose] = {}
        turns: dict[int, float] = {}
        for unit, own in enumerate(states):
            state = own.get(epoch)
            if state is None or state.status != "found" or state.pose is None or state.covariance is None:
                continue
            covariance = calibration.covariance(state.covariance)
            if _is_open(covariance, shapes[unit]):
                doubted[unit].add(epoch)
                continue
            poses[unit], turns[unit] = state.pose, largest_sd(covariance[3:, 3:])
            if turns[unit] > OPEN_TWIST:
                open_turns.setdefault(unit, set()).add(epoch)
        entering |= _entering(poses, turns, shapes)
    # what is open in several epochs is held at rest: they state one turn
    for unit in entering:
        doubted[unit] |= open_turns[unit]
    if not any(doubted):
        return None
    return [
        {epoch: replace(state, status="uncertain") if epoch in less else state for epoch, state in own.items()}
        for own, less in zip(states, doubted, strict=True)
    ]


def _entering(poses: Mapping[int, Pose], turns: Mapping[int, float], shapes: Sequence[UnitType]) -> set[int]:
    """Units by number whose turn is left open and whose pose enters a unit of which it is better known.

    Parameters
    ----------
    poses, turns
        By unit, its pose and the standard deviation of its turn about the axis where it is least known, radians.
    """
    left_open = [unit for unit, sd in turns.items() if sd > OPEN_TWIST]
    if not left_open:
        return set()
    numbers = list(poses)
    tree = cKDTree(np.array([poses[unit].centre for unit in numbers]))
    reach = REACH_HEIGHTS * max(shapes[unit].height for unit in numbers)
    near = {unit: [numbers[k] for k in tree.query_ball_point(poses[unit].centre, reach)] for unit in left_open}
    return {
        unit
        for unit in left_open
        for other in near[unit]
        if turns[other] < turns[unit] and overlap(poses[unit].as_row(), poses[other].as_row(), shapes[unit], shapes[other]) > MOST_ENTERED
    }


def _is_open(covariance: FloatArray, shape: UnitType) -> bool:
    """Whether a (6, 6) covariance of a pose leaves its centre open."""
    return largest_sd(covariance[:3, :3]) > MOST_OPEN_HEIGHTS * shape.height


def _not_seen(state: str, scale: float) -> TrackedUnit:
    """A unit in an epoch that does not show it; ``scale`` is the relative difference of its size."""
    status = "lost" if state == "empty" else "unseen"
    return TrackedUnit(row=None, pose=None, covariance=None, scale=1 + scale, status=status, points=0)
