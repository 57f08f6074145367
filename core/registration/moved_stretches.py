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
    model, gain = bend_of(windows)
    told: list[tuple[float, float]] = []
    for asked, most in ((SEEN, MOST_TRIES), (DOUBTED, 1)):
        for _ in range(MOST_TRIES):
            if model is None or gain <= least_gain or len(told) >= most:
                break
            doubt = clearest_jump(sample, searched, along, model, step, asked)
            if doubt is None:
                break
            smooth, _ = bend_of(outside(sample, windows, along, doubt))
            jump = clearest_jump(sample, searched, along, smooth or model, step, CERTAIN.along(float(np.ptp(along))))
            if jump is None or not jump.overlaps(doubt):
                # it is a bend, and the next in doubt is asked for
                searched = outside(sample, searched, along, doubt)
                continue
            told.append((jump.low, jump.high))
            windows, searched = (outside(sample, part, along, jump) for part in (windows, searched))
            model, gain = bend_of(windows)
    return MovedStretches(stretches=tuple(told), windows=windows, model=model, gain=gain)


def outside(sample: ShiftSample, windows: Sequence[IntArray], along: FloatArray, jump: Jump) -> list[IntArray]:
    """Windows without the cells of a stretch; targets stay."""
    inside = (along >= jump.low) & (along <= jump.high) & ~sample.fixed
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
