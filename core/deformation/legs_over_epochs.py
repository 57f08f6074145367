"""Whether the legs of a unit are whole, epoch by epoch, from what all epochs show of the same legs.

A leg that is broken stays broken. What the epochs show of it is independent given its state, so that their log-likelihood ratios add up in
a hidden Markov chain of two states, whole and broken, the second of which nothing leaves (Rabiner, 1989, Proceedings of the IEEE 77(2),
257-286: forward and backward passes).
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..common.arrays import FloatArray
from ..segmentation.leg_ends import BROKEN, PRIOR_ODDS, UNSEEN, WHOLE, LegEnds

BREAKS_BETWEEN = 0.005
"""Share of whole legs that break from one epoch to the next, before looking: a quarter of those that are broken."""
MOST_EVIDENCE = 10.0
"""Log-likelihood ratio that one epoch can add: its points err together, by the pose of the unit or by what grows on it."""


def legs_over_epochs(seen: Mapping[int, LegEnds]) -> dict[int, LegEnds]:
    """State of a unit's legs in the epochs that show it, by epoch; legs numbered alike in all of them.

    A leg is broken where the epochs together say so, also in an epoch that does not show its end; its missing length is that of the epoch
    itself, or of the one that shows the break best. A leg that no epoch calls broken is unseen where its end is not seen. What speaks for
    a break of a leg that an epoch takes for whole is there for another reason, as rock that the leg was pushed into, in all such epochs the
    same: it counts once.
    """
    epochs = sorted(seen)
    if len(epochs) < 2:
        return dict(seen)
    evidence = np.array([seen[e].evidence for e in epochs])
    if not (evidence > 0).any():
        return dict(seen)
    explained = (evidence > 0) & np.array([seen[e].states == WHOLE for e in epochs])
    evidence = np.where(explained, evidence / np.maximum(explained.sum(axis=0), 1), evidence)
    broken = _probability(np.clip(evidence, -MOST_EVIDENCE, MOST_EVIDENCE))
    missing = np.array([seen[e].missing for e in epochs])
    best = np.where(missing > 0, evidence, -np.inf).argmax(axis=0)
    found = {}
    for place, epoch in enumerate(epochs):
        own = seen[epoch]
        gone = broken[place] > 0.5
        states = np.where(gone, BROKEN, np.where(own.states == UNSEEN, UNSEEN, WHOLE))
        length = np.where(own.states == BROKEN, own.missing, missing[best, np.arange(4)])
        found[epoch] = LegEnds(states, np.where(gone, length, 0.0), np.where(states == UNSEEN, np.nan, broken[place]), own.evidence)
    return found


def _probability(evidence: FloatArray) -> FloatArray:
    """(e, 4) probability that a leg is broken in each epoch, from (e, 4) log-likelihood ratios."""
    count = len(evidence)
    # log-likelihoods of (whole, broken) of what came up to each epoch, and of what comes after it
    before, after = np.zeros((count, 2, 4)), np.zeros((count, 2, 4))
    breaks, stays = np.log(BREAKS_BETWEEN), np.log1p(-BREAKS_BETWEEN)
    before[0, 1] = PRIOR_ODDS + evidence[0]
    for k in range(1, count):
        before[k, 0] = before[k - 1, 0] + stays
        before[k, 1] = np.logaddexp(before[k - 1, 1], before[k - 1, 0] + breaks) + evidence[k]
    for k in range(count - 2, -1, -1):
        after[k, 1] = after[k + 1, 1] + evidence[k + 1]
        after[k, 0] = np.logaddexp(after[k + 1, 0] + stays, after[k, 1] + breaks)
    total = before + after
    return np.asarray(1 / (1 + np.exp(np.clip(total[:, 0] - total[:, 1], -500, 500))))
