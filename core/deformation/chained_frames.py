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
from ..registration.frame_field import FieldEstimate
from .elastic_congruence import ElasticDatum
from .epoch_frames import EpochFrames

MOST_UNKNOWNS = 4600
"""Unknowns of a field up to which epochs are chained; beyond, each stands on its own targets."""

MODEL_BENDS = 5.0
"""Independent bends that the model's own size of errors is worth beside those that differences of epochs show."""

Message = tuple[FloatArray, FloatArray]
"""Normal matrix and right-hand side of what another epoch says of a field."""


def chained_errors(frames: EpochFrames, data: Sequence[ElasticDatum | None]) -> tuple[FieldEstimate | None, ...]:
    """Error of every epoch's registered cloud as the targets of all epochs see it; None for all where none has targets.

    Parameters
    ----------
    frames
        Of all epochs, with what each one's own targets say.
    data
        Datums of pairs of epochs that follow each other; None where no units tie them.
    """
    if all(error is None for error in frames.errors) or frames.basis.size > MOST_UNKNOWNS:
        return frames.errors
    alone = [_prior(frames) if error is None else error for error in frames.errors]
    nothing = np.zeros((frames.basis.size, frames.basis.size)), np.zeros(frames.basis.size)
    before, after = [nothing] * len(alone), [nothing] * len(alone)
    for k in range(1, len(alone)):
        before[k] = _passed_on(alone[k - 1].informed(*before[k - 1]), data[k - 1], 1.0)
    for k in range(len(alone) - 2, -1, -1):
        after[k] = _passed_on(alone[k + 1].informed(*after[k + 1]), data[k], -1.0)
    together = [own.informed(a[0] + b[0], a[1] + b[1]) for own, a, b in zip(alone, before, after, strict=True)]
    factor = _size_of_positions(data)
    return tuple(replace(field, covariance=field.covariance * factor) for field in together)


def _prior(frames: EpochFrames) -> FieldEstimate:
    """What is known of a frame without targets."""
    basis = frames.basis
    covariance = np.asarray(np.linalg.inv(basis.precision()), dtype=np.float64)
    return FieldEstimate(basis, np.zeros(basis.size), covariance)


def _passed_on(known: FieldEstimate, datum: ElasticDatum | None, sign: float) -> Message:
    """What an epoch, and units that rest, say of the next one (sign 1) or the one before (-1)."""
    size = known.basis.size
    if datum is None:
        return np.zeros((size, size)), np.zeros(size)
    reach = np.linalg.inv(np.eye(size) + datum.information @ known.covariance)
    information = reach @ datum.information
    return 0.5 * (information + information.T), reach @ (datum.information @ known.mean + sign * datum.rhs)


def _size_of_positions(data: Sequence[ElasticDatum | None]) -> float:
    """Factor of the variance of positions: what the epochs share is another draw than their differences, and the model has its say too."""
    weights, sizes = [MODEL_BENDS], [1.0]
    for datum in data:
        if datum is not None and datum.bends > 0:
            weights.append(datum.bends)
            sizes.append(datum.size)
    return float(np.average(sizes, weights=weights))
