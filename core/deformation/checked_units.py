"""Cross checks of many units, asked so that whoever has several processes may register their points there."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..common.arrays import FloatArray
from ..common.kernels import side_by_side
from ..model.pose import Pose
from .cross_check import CrossCheck, cross_check
from .epoch_pairs import joint_block
from .fitted_unit import FittedUnit
from .joint_records import JointAdjustment
from .questions import Answer
from .unit_clouds import UnitCloud, by_home

PARTS = 4
"""Questions at least into which the units of two epochs are parted, where there are enough."""
FEWEST_UNITS, MOST_UNITS = 4, 40
"""Of a question: a few units take no longer than to read the points of a block."""
_VERDICTS = {-1: None, 0: False, 1: True}


@dataclass(frozen=True, eq=False, kw_only=True)
class CheckedUnit:
    """A unit in two epochs.

    Attributes
    ----------
    clouds
        Its points in both.
    offsets
        (s, 3) of their strips or stations, by ascending id, metres.
    poses
        By the model.
    covariance
        (3, 3) of the model's displacement of the centre.
    """

    clouds: tuple[UnitCloud, UnitCloud]
    offsets: tuple[FloatArray, FloatArray]
    poses: tuple[Pose, Pose]
    covariance: FloatArray

    def points(self) -> list[FloatArray]:
        """(n, 3) in both epochs, less the offset of their strip or station."""
        parts = []
        for cloud, offsets in zip(self.clouds, self.offsets, strict=True):
            points, sources = cloud.read()
            parts.append(np.asarray(points - offsets[np.searchsorted(cloud.ids, sources)]))
        return parts


@dataclass(frozen=True, eq=False)
class CrossChecks:
    """Asks what direct registrations of the points of some units say.

    Attributes
    ----------
    units
        In the order in which they are read with least effort.
    noise
        Standard deviation of a point along the surface normal, metres.
    """

    units: tuple[CheckedUnit, ...]
    noise: float

    def answer(self) -> Answer:
        """Fields of :class:`CrossCheck` by unit, ``agrees`` as -1 for None."""

        def registered(item: tuple[CheckedUnit, list[FloatArray]]) -> CrossCheck:
            unit, (before, after) = item
            return cross_check(before, after, *unit.poses, unit.covariance, self.noise)

        checks = list(side_by_side(registered, ((unit, unit.points()) for unit in self.units)))
        names = ("vector", "turn", "covariance", "overlap", "difference", "statistic", "p_value", "reason")
        columns = {name: np.array([getattr(check, name) for check in checks]) for name in names}
        return columns | {"agrees": np.array([-1 if check.agrees is None else int(check.agrees) for check in checks])}


def checks_of(answer: Answer) -> Iterator[CrossCheck]:
    """The cross checks that an answer holds."""
    for k, vector in enumerate(answer["vector"]):
        numbers = {name: float(answer[name][k]) for name in ("turn", "overlap", "difference", "statistic", "p_value")}
        yield CrossCheck(
            vector=vector, covariance=answer["covariance"][k], agrees=_VERDICTS[int(answer["agrees"][k])], reason=str(answer["reason"][k]),
            **numbers,
        )  # fmt: skip


def cross_check_questions(
    seen: Sequence[Mapping[int, FittedUnit]], joint: JointAdjustment, numbers: Mapping[tuple[int, int], int], first: int, second: int
) -> list[tuple[list[int], CrossChecks]]:
    """Questions about all units that two epochs show, one of them for certain, each with its units.

    Parameters
    ----------
    seen
        By unit, its sightings by epoch.
    joint, numbers
        Joint adjustment, and numbers of the sightings in it by unit and epoch.
    first, second
        The epochs.
    """
    both = [k for k, own in enumerate(seen) if first in own and second in own and (own[first].certain or own[second].certain)]
    both = [k for k in both if seen[k][first].cloud.has_points and seen[k][second].cloud.has_points]
    order = by_home((k, (seen[k][first].cloud, seen[k][second].cloud)) for k in both)
    noise = float(np.nanmax(joint.noise[[first, second]])) if order else 0.0
    difference = np.hstack([-np.eye(3), np.zeros((3, 3)), np.eye(3), np.zeros((3, 3))])

    def checked(unit: int) -> CheckedUnit:
        a, b = numbers[unit, first], numbers[unit, second]
        clouds = seen[unit][first].cloud, seen[unit][second].cloud
        return CheckedUnit(
            clouds=clouds,
            offsets=(joint.offsets_of(unit, first, clouds[0].ids), joint.offsets_of(unit, second, clouds[1].ids)),
            poses=(joint.poses[a], joint.poses[b]),
            covariance=difference @ joint_block(joint, unit, a, b) @ difference.T,
        )

    size = min(max(math.ceil(len(order) / PARTS), FEWEST_UNITS), MOST_UNITS)
    parts = [order[start : start + size] for start in range(0, len(order), size)]
    return [(part, CrossChecks(tuple(checked(unit) for unit in part), noise)) for part in parts]
