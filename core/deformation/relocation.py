"""Units carried elsewhere: recognised by the relief of their surfaces, and joined to what they were before."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray
from .fitted_unit import FittedUnit
from .identity import Track
from .surface_texture import Texture, likeness, texture
from .unit_clouds import by_home

RELIEFS_HELD = 64
"""Lost units whose relief is compared with that of the new ones around them at a time."""
CARRIED_HEIGHTS = 30.0
"""Distance in unit heights in which one that left its place is looked for: beyond what waves carry and a crane on its stand reaches
(assumed), so that the number of comparisons follows the length of the structure."""
DOUBTFUL_MOVE_HEIGHTS = 0.2
"""Motion above which another unit fits into the place."""


@dataclass(frozen=True, eq=False)
class Sighting:
    """A unit that left its place or came to another, and its (3,) place less the shift of the whole cloud, metres."""

    unit: FittedUnit
    place: FloatArray


@dataclass(frozen=True, eq=False)
class Followed:
    """A track with its sightings and what was found where it was not seen.

    Attributes
    ----------
    track
        Its rows, leg numbers and kind.
    seen
        Epoch to the unit as found in it.
    states
        Epoch in which it was not seen to what its place looks like: see ``presence``.
    """

    track: Track
    seen: dict[int, FittedUnit]
    states: dict[int, str]

    def until(self, epoch: int, epochs: int) -> Followed:
        """What happened before an epoch; from it on, to the last of all ``epochs``, another unit fills the place."""
        return self._part(lambda e: e < epoch, range(epoch, epochs))

    def since(self, epoch: int) -> Followed:
        """What happened from an epoch on; before it another unit filled the place."""
        return self._part(lambda e: e >= epoch, range(epoch))

    def _part(self, within: Callable[[int], bool], others: range) -> Followed:
        t = self.track
        track = Track(
            {e: r for e, r in t.rows.items() if within(e)},
            {e: s for e, s in t.symmetries.items() if within(e)},
            frozenset(e for e in t.ambiguous if within(e)),
            t.kind,
            frozenset(e for e in t.relocated if within(e)),
        )
        states = dict.fromkeys(others, "empty") | {e: s for e, s in self.states.items() if within(e)}
        return Followed(track, {e: s for e, s in self.seen.items() if within(e)}, states)

    def carried_to(self, arrived: Followed, epoch: int, symmetry: FloatArray) -> Followed:
        """The unit and, from an epoch on, what it was found to be elsewhere, with the leg numbers of the first place."""
        t, u = self.track, arrived.track
        track = Track(
            t.rows | u.rows,
            t.symmetries | {e: s @ symmetry for e, s in u.symmetries.items()},
            t.ambiguous | u.ambiguous,
            t.kind,
            t.relocated | u.relocated | {epoch},
        )
        states = {e: s for e, s in self.states.items() if e < epoch} | {e: s for e, s in arrived.states.items() if e > epoch}
        return Followed(track, self.seen | {e: s.relabelled(symmetry) for e, s in arrived.seen.items()}, states)

    def sighting(self, epoch: int, shifts: FloatArray) -> Sighting:
        """The unit in an epoch, and its centre less the (e, 3) ``shifts`` of whole clouds."""
        unit = self.seen[epoch]
        return Sighting(unit, unit.pose.centre - shifts[epoch])

    def moved_far(self, epoch: int, shifts: FloatArray) -> bool:
        """Whether it moved by a good part of its height into this epoch, beyond the (e, 3) ``shifts`` of whole clouds."""
        before = [e for e in self.seen if e < epoch]
        if epoch not in self.seen or not before:
            return False
        last, now = self.seen[max(before)], self.seen[epoch]
        motion = now.pose.centre - last.pose.centre - (shifts[epoch] - shifts[max(before)])
        return float(np.linalg.norm(motion)) > DOUBTFUL_MOVE_HEIGHTS * now.shape.height


def join_relocated(
    tracks: list[Track], seen: list[dict[int, FittedUnit]], states: list[dict[int, str]], shifts: FloatArray
) -> tuple[list[Track], list[dict[int, FittedUnit]], list[dict[int, str]]]:
    """Join a unit that left its place with one that appeared elsewhere, where the relief of their surfaces proves them to be one.

    Neither the place nor the size tells: waves carry units down, cranes put others on top, and moulded units differ in size by
    millimetres. Without proof both stay what they are seen to be, lost and new. What seems to have moved far may be another unit in the
    hole that the first one left: its track is parted where one of the two is recognised elsewhere.

    Parameters
    ----------
    tracks, seen, states
        By unit: its track, its sightings by epoch, and by epoch the state of its place where it is not seen.
    shifts
        (e, 3) common shift of the cloud of every epoch, metres.

    Returns
    -------
    tracks, seen, states
        Of the units that are left.
    """
    followed = {k: Followed(*parts) for k, parts in enumerate(zip(tracks, seen, states, strict=True)) if parts[1]}
    for epoch in range(1, len(shifts)):
        parted: dict[int, tuple[int, Followed]] = {}
        for k, whole in list(followed.items()):
            if whole.moved_far(epoch, shifts):
                later = max(followed) + 1
                parted[k] = later, whole
                followed[k], followed[later] = whole.until(epoch, len(shifts)), whole.since(epoch)
        pairs = _recognised(
            {k: f.sighting(max(f.seen), shifts) for k, f in followed.items() if max(f.seen) < epoch},
            {k: f.sighting(epoch, shifts) for k, f in followed.items() if min(f.seen) == epoch},
        )
        for old, new, symmetry in pairs:
            if old not in parted or parted[old][0] != new:
                followed[old] = followed[old].carried_to(followed.pop(new), epoch, symmetry)
        elsewhere = {old for old, new, _ in pairs if old not in parted or parted[old][0] != new}
        for k, (later, whole) in parted.items():
            if k not in elsewhere and later in followed:
                followed[k] = whole
                del followed[later]
    return [f.track for f in followed.values()], [f.seen for f in followed.values()], [f.states for f in followed.values()]


def _recognised(left: dict[int, Sighting], came: dict[int, Sighting]) -> list[tuple[int, int, FloatArray]]:
    """Pairs of a unit that left its place and one that came to another, proved by their relief, with the symmetry of the second."""
    near = _within_reach(left, came)
    found = []
    lost, arrived = (by_home((k, (s.unit.cloud,)) for k, s in units.items()) for units in (left, came))
    for first in range(0, len(lost), RELIEFS_HELD):
        batch = lost[first : first + RELIEFS_HELD]
        reliefs = {old: _relief_of(left[old].unit) for old in batch if near[old]}
        for new in arrived:
            around = [old for old in reliefs if new in near[old]]
            if not around:
                continue
            relief = _relief_of(came[new].unit)
            for old in around:
                match = likeness(reliefs[old], relief, left[old].unit.shape)
                if match.same_unit:
                    found.append((match.lead, old, new, match.symmetry))
    pairs: list[tuple[int, int, FloatArray]] = []
    for _, old, new, symmetry in sorted(found, key=lambda item: -item[0]):
        if all(old != a and new != b for a, b, _ in pairs):
            pairs.append((old, new, symmetry))
    return pairs


def _within_reach(left: dict[int, Sighting], came: dict[int, Sighting]) -> dict[int, frozenset[int]]:
    """By unit that left its place, those of its kind that came to one it may have been carried to."""
    if not left or not came:
        return dict.fromkeys(left, frozenset())
    numbers = list(came)
    tree = cKDTree([came[k].place for k in numbers])
    around = {k: tree.query_ball_point(s.place, CARRIED_HEIGHTS * s.unit.shape.height) for k, s in left.items()}
    return {k: frozenset(numbers[i] for i in near if came[numbers[i]].unit.kind == left[k].unit.kind) for k, near in around.items()}


def _relief_of(unit: FittedUnit) -> Texture:
    points, sources = unit.cloud.read()
    return texture(points, sources, unit.pose, unit.shape)
