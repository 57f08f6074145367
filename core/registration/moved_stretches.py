"""Stretches that moved as one against all around them, which no smooth bend does: slides and settlements.

What one cell of the ground alone bears is a body that moved by itself. A bend that follows a step is itself steep, so that little is left
of the step; so a stretch is in doubt by the bend that all cells show, and told by the bend that all others show.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..common.arrays import FloatArray, IntArray
from .frame_field import FieldModel, matern
from .shift_samples import FEWEST_CELLS, ShiftSample, smooth_covariances

LONGEST_JUMP, LONGEST_OF_WINDOW = 0.4, 0.5
"""Longest such stretch over the length of the structure, and over that of the window which shows it: of more than that nobody could say
which part moved."""
MOST_TRIES = 6
"""Stretches in doubt that are asked for at most, by either evidence."""

BendOf = Callable[[Sequence[IntArray]], tuple[FieldModel | None, float]]
"""Likeliest bend of the cells of some windows, None where a rigid motion is likelier, and its gain of log-likelihood."""


@dataclass(frozen=True, kw_only=True)
class Evidence:
    """What a stretch must show.

    Attributes
    ----------
    gain, of_others
        Least gain of log-likelihood by its common motion, and the same without the cell that bears most of it.
    steepness
        Least square of its step over the variance of the bend's own change at its ends.
    at_ends
        Whether it may end with the structure, where a bend is held from one side alone.
    """

    gain: float
    of_others: float
    steepness: float
    at_ends: bool

    def along(self, extent: float) -> Evidence:
        """What a structure of ``extent`` metres must show, where more stretches are looked at.

        A bend that others predict is off by more than its stated variance, which few bends tell: by the tails of F with three and some six
        degrees of freedom, which fall with the cube of the gain. So the gain grows with the cube root of the number of stretches.
        """
        grown = max(extent / USUAL_EXTENT, 1.0) ** (1 / 3)
        return replace(self, gain=self.gain * grown, of_others=self.of_others * grown)


SEEN = Evidence(gain=25.0, of_others=10.6, steepness=1.0, at_ends=True)
"""By the bend that all cells show. The best of all stretches of a smooth bend gains about ten; one that one cell chose gains 10.6 by the
others once in ten thousand (half of a chi-square of three)."""
DOUBTED = Evidence(gain=10.6, of_others=10.6, steepness=0.0, at_ends=False)
"""The same where nothing is seen: a bend that has to follow a step may leave little of it."""
CERTAIN = Evidence(gain=50.0, of_others=25.0, steepness=4.0, at_ends=True)
"""By the bend that all others show. That bend does not know the stretch and is off there by more than it says: stretches at rest gain up to
53 on drawn coasts of 100 m, slides of 10 cm 59 and more, nearly all over 130."""
USUAL_EXTENT = 100.0
"""Metres of structure for which it stands."""


@dataclass(frozen=True, kw_only=True)
class Jump:
    """Stretch from ``low`` to ``high`` along the axis, metres, the gain of its common motion, and the same without the ``cell`` (by its
    number) that bears most of it."""

    low: float
    high: float
    gain: float
    gain_of_others: float
    cell: int

    def overlaps(self, other: Jump) -> bool:
        """Whether a part of both is the same."""
        return self.high > other.low and self.low < other.high


@dataclass(frozen=True, eq=False, kw_only=True)
class MovedStretches:
    """What :func:`moved_stretches` found.

    Attributes
    ----------
    stretches
        From and to along the axis, metres, the clearest first.
    windows
        Numbers of the cells outside them.
    model, gain
        Likeliest bend of these, and its gain over a rigid motion.
    """

    stretches: tuple[tuple[float, float], ...]
    windows: list[IntArray]
    model: FieldModel | None
    gain: float


def moved_stretches(
    sample: ShiftSample, along: FloatArray, windows: list[IntArray], searched: list[IntArray], bend_of: BendOf, step: float,
    least_gain: float,
) -> MovedStretches:  # fmt: skip
    """Stretches that moved as one: all that are seen, or one that a bend hides where none is.

    Parameters
    ----------
    sample
        Shifts by cells and targets.
    along
        (k,) places along the structure, metres.
    windows, searched
        Numbers of the cells from which bends are learned, and of those among which stretches are looked for.
    bend_of
        Likeliest bend of some windows.
    step
        Least length of a stretch, metres.
    least_gain
        Gain up to which a bend is none, and nothing is looked for.
    """
    search = _Search(sample, along, windows, searched, bend_of, step, least_gain)
    for asked, most in ((SEEN, MOST_TRIES), (DOUBTED, 1)):
        for _ in range(MOST_TRIES):
            doubt = search.in_doubt(asked) if len(search.told) < most else None
            if doubt is None:
                break
            search.tell(doubt)
    stretches = tuple((jump.low, jump.high) for jump in search.told)
    return MovedStretches(stretches=stretches, windows=search.apart(windows, search.told), model=search.model, gain=search.gain)


class _Search:
    """Stretches told so far, and the bend of all cells outside them."""

    def __init__(
        self, sample: ShiftSample, along: FloatArray, windows: list[IntArray], searched: list[IntArray], bend_of: BendOf, step: float,
        least_gain: float,
    ) -> None:  # fmt: skip
        self.sample, self.along, self.windows, self.searched = sample, along, windows, searched
        self.bend_of, self.step, self.least_gain = bend_of, step, least_gain
        self.certain = CERTAIN.along(float(np.ptp(along)))
        self.told: list[Jump] = []
        self.model, self.gain = bend_of(windows)

    def apart(self, parts: Sequence[IntArray], jumps: Sequence[Jump]) -> list[IntArray]:
        """Windows without some stretches, whose ends are known to half a step: what is left of one there would pass for another."""
        return outside(self.sample, parts, self.along, [replace(j, low=j.low - self.step / 2, high=j.high + self.step / 2) for j in jumps])

    def in_doubt(self, asked: Evidence) -> Jump | None:
        """Clearest stretch by the bend that all cells show; None where there is none, or no bend."""
        if self.model is None or self.gain <= self.least_gain:
            return None
        return clearest_jump(self.sample, self.apart(self.searched, self.told), self.along, self.model, self.step, asked)

    def tell(self, doubt: Jump) -> None:
        """Take a stretch in doubt, as the bend of all others shows it, for one that moved, or leave it out of the search."""
        smooth, _ = self.bend_of(outside(self.sample, self.apart(self.windows, self.told), self.along, [doubt]))
        jump = self._certain(doubt, self.told, smooth or self.model)
        if jump is None:
            # it is a bend, and the next in doubt is asked for
            self.searched = outside(self.sample, self.searched, self.along, [doubt])
            return
        earlier = tuple(self.told)
        self.told.append(jump)
        self.model, self.gain = self.bend_of(self.apart(self.windows, self.told))
        for other in earlier:
            # it may have been told against what moved
            if self._certain(other, [known for known in self.told if known is not other], self.model) is None:
                self.told.remove(other)
                self.model, self.gain = self.bend_of(self.apart(self.windows, self.told))

    def _certain(self, doubt: Jump, told: Sequence[Jump], model: FieldModel | None) -> Jump | None:
        """What a bend that does not know it shows of a stretch, outside others that were told."""
        if model is None:
            return None
        jump = clearest_jump(self.sample, self.apart(self.searched, told), self.along, model, self.step, self.certain)
        return jump if jump is not None and jump.overlaps(doubt) else None


def outside(sample: ShiftSample, windows: Sequence[IntArray], along: FloatArray, jumps: Sequence[Jump]) -> list[IntArray]:
    """Windows without the cells of some stretches; targets stay."""
    inside = np.zeros(len(along), dtype=bool)
    for jump in jumps:
        inside |= (along >= jump.low) & (along <= jump.high) & ~sample.fixed
    return [window[~inside[window]] for window in windows]


def clearest_jump(
    sample: ShiftSample, windows: Sequence[IntArray], along: FloatArray, model: FieldModel, step: float, least: Evidence
) -> Jump | None:
    """Stretch whose common motion gains most likelihood under a bend; None where none gains enough.

    What one cell alone bears is a body that moved by itself: that cell is left out, and the window looked at anew.
    """
    best: Jump | None = None
    for number, window in enumerate(windows):
        ends = (number == 0, number == len(windows) - 1)
        found = _clearest_in(sample, window, along, model, step, ends, least)
        while found is not None and found.gain_of_others <= least.of_others:
            window = window[window != found.cell]
            found = _clearest_in(sample, window, along, model, step, ends, least)
        if found is not None and (best is None or found.gain > best.gain):
            best = found
    return best


def _clearest_in(
    sample: ShiftSample, window: IntArray, along: FloatArray, model: FieldModel, step: float, ends: tuple[bool, bool], least: Evidence
) -> Jump | None:
    """The same of one window, whose first and last cells may be ``ends`` of the structure."""
    if len(window) < FEWEST_CELLS:
        return None
    longest = min(LONGEST_JUMP * float(np.ptp(along)), LONGEST_OF_WINDOW * float(np.ptp(along[window])))
    free = ~sample.fixed[window]
    edges = np.arange(along[window].min(), along[window].max() + step, step / 2)
    bins = np.clip(np.searchsorted(edges, along[window], side="right") - 1, 0, len(edges) - 2)
    member = np.zeros((len(edges) - 1, len(window)))
    member[bins[free], np.flatnonzero(free)] = 1
    gains, sizes = (np.zeros((len(edges), len(edges))) for _ in range(2))
    inverses = _inverses(sample, window, model)
    solved = np.stack([inverse @ sample.values[window, axis] for axis, inverse in enumerate(inverses)])
    for inverse, own in zip(inverses, solved, strict=True):
        table, line = np.zeros((len(edges), len(edges))), np.zeros(len(edges))
        table[1:, 1:] = np.cumsum(np.cumsum(member @ inverse @ member.T, axis=0), axis=1)
        line[1:] = np.cumsum(member @ own)
        diagonal = np.diag(table)
        inside = diagonal[None, :] + diagonal[:, None] - table - table.T
        gains += 0.5 * (line[None, :] - line[:, None]) ** 2 / np.maximum(inside, 1e-12)
        sizes += ((line[None, :] - line[:, None]) / np.maximum(inside, 1e-12)) ** 2
    width = edges[None, :] - edges[:, None]
    # an end of a window within the structure is no end of a stretch: the next window sees what lies there whole
    if not ends[0]:
        gains[0] = 0
    elif not least.at_ends:
        gains[edges < edges[0] + step] = 0
    if not ends[1]:
        gains[:, bins.max() + 1 :] = 0
    elif not least.at_ends:
        gains[:, edges > along[window].max() - step] = 0
    # what a bend itself does over the distance in which an end is seen is no step
    gains[(width < step) | (width > longest) | (sizes < least.steepness * _own_change(model, step))] = 0
    low, high = np.unravel_index(int(np.argmax(gains)), gains.shape)
    if gains[low, high] <= least.gain:
        return None
    cells = np.flatnonzero(free & (bins >= low) & (bins < high))
    others = _gains_of_others(inverses, solved, cells)
    return Jump(
        low=float(edges[low]), high=float(edges[high]), gain=float(gains[low, high]),
        gain_of_others=float(others.min()), cell=int(window[cells[np.argmin(others)]]),
    )  # fmt: skip


def _inverses(sample: ShiftSample, window: IntArray, model: FieldModel) -> list[FloatArray]:
    """By component, inverse of the covariance of the shifts of a window under a bend."""
    smooth = smooth_covariances(sample.places[window], model)
    return [np.asarray(np.linalg.inv(own + np.diag(noise))) for own, noise in zip(smooth, sample.variances[window].T, strict=True)]


def _gains_of_others(inverses: Sequence[FloatArray], solved: FloatArray, cells: IntArray) -> FloatArray:
    """Gain of the common motion of some cells of a window with each of them left out in turn.

    Parameters
    ----------
    inverses, solved
        By component, (k, k) inverse covariance of the shifts of the window, and (k,) its product with these.
    cells
        (m,) places of the cells in the window.
    """
    total = np.zeros(len(cells))
    for inverse, own in zip(inverses, solved, strict=True):
        reach, alone = inverse[np.ix_(cells, cells)].sum(axis=1), np.diag(inverse)[cells]
        line = own[cells].sum() - reach * own[cells] / alone
        total += 0.5 * line**2 / np.maximum(reach.sum() - reach**2 / alone, 1e-9 * reach.sum())
    return total


def _own_change(model: FieldModel, step: float) -> float:
    """Mean square by which a bend changes over ``step`` metres along the structure, square metres."""
    return float(np.sum(np.square(model.sds)) * 2 * (1 - matern(np.array(step / model.length), model.smoothness)))
