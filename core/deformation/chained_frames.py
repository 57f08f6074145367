"""Frames of all epochs from targets and units together: resting units tie each epoch's field to that of the next.

Targets say what the fields e_k are, units of which most rest what their differences are,

    e_k ~ N(m_k, C_k),    e_(k+1) - e_k observed with normal matrix U_k and right-hand side b_k,

a chain whose mean and covariance two passes give, one from each end (Rauch, Tung and Striebel, 1965, AIAA J. 3(8)). An epoch stands
thereby on the targets of all: between stations, where each of two frames bends for itself, its error is less by the square root of two,
and an epoch without targets of its own stands in the frame of one that has some.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..common.arrays import FloatArray
from ..registration.frame_field import FieldEstimate, solved, symmetric_part
from .elastic_congruence import FrameTie
from .epoch_frames import EpochFrames

MOST_UNKNOWNS = 4600
"""Unknowns of a field up to which epochs are chained; beyond, each stands on its own targets."""

MODEL_BENDS = 5.0
"""Independent bends that the model's own size of errors is worth beside those that differences of epochs show."""

Message = tuple[FloatArray, FloatArray]
"""Normal matrix and right-hand side of what another epoch says of a field."""


def chained_errors(frames: EpochFrames, ties: Sequence[FrameTie | None]) -> tuple[FieldEstimate | None, ...]:
    """Error of every epoch's registered cloud as the targets of all epochs see it; None for all where none has targets.

    Parameters
    ----------
    frames
        Of all epochs, with what each one's own targets say.
    ties
        Of epochs that follow each other; None where no units tie them.
    """
    if all(error is None for error in frames.errors) or frames.basis.size > MOST_UNKNOWNS:
        return frames.errors
    alone = [_prior(frames) if error is None else error for error in frames.errors_for_all()]
    before: list[Message | None] = [None] * len(alone)
    for k in range(1, len(alone)):
        before[k] = _passed_on(_with_word(alone[k - 1], before[k - 1]), ties[k - 1], 1.0)
    factor = _size_of_positions(ties)
    found: list[FieldEstimate] = []
    after: Message | None = None
    for k in range(len(alone) - 1, -1, -1):
        # each word is let go once it has been heard: on long coasts all matrices are large
        later = _with_word(alone[k], after)
        known = _with_word(later, before[k])
        before[k] = None
        found.append(replace(known, covariance=known.covariance * factor))
        del known
        after = _passed_on(later, ties[k - 1], -1.0) if k else None
    return tuple(reversed(found))


def _with_word(known: FieldEstimate, message: Message | None) -> FieldEstimate:
    """What is known of an epoch's field with what another epoch says of it."""
    return known if message is None else known.informed(*message)


def _prior(frames: EpochFrames) -> FieldEstimate:
    """What is known of a frame without targets."""
    basis = frames.basis
    covariance = np.asarray(np.linalg.inv(basis.precision()), dtype=np.float64)
    return FieldEstimate(basis, np.zeros(basis.size), covariance)


def _passed_on(known: FieldEstimate, tie: FrameTie | None, sign: float) -> Message | None:
    """What an epoch, and units that rest, say of the next one (sign 1) or the one before (-1); None where no units tie them."""
    if tie is None:
        return None
    size = known.basis.size
    said = np.zeros((size, size + 1), order="F")
    said[tie.information.coords] = tie.information.data
    said[:, -1] = tie.information @ known.mean + sign * tie.rhs
    passed = solved(tie.information @ known.covariance, said)
    return symmetric_part(passed[:, :-1]), passed[:, -1].copy()


def _size_of_positions(ties: Sequence[FrameTie | None]) -> float:
    """Factor of the variance of positions: what the epochs share is another draw than their differences, and the model has its say too."""
    weights, sizes = [MODEL_BENDS], [1.0]
    for tie in ties:
        if tie is not None and tie.bends > 0:
            weights.append(tie.bends)
            sizes.append(tie.size)
    return float(np.average(sizes, weights=weights))
