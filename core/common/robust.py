"""Robust statistics and their constants, each with its source."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .arrays import FloatArray

MAD_TO_SD = 1.4826
"""Standard deviation of normal errors over their median absolute value: 1 / quantile of 75 % (Huber, 1981, sec. 5.1)."""

TUKEY = 4.685
"""Tuning constant of Tukey's weights, in standard deviations: 95 % efficient for normal errors (Holland and Welsch, 1977)."""

CHI2_1_MEDIAN = 0.4549
"""Median of chi-square with one degree of freedom."""
CHI2_3_MEDIAN = 2.366
"""Median of chi-square with three degrees of freedom."""

CHI2_3_95 = 7.814727903
"""95 % quantile of chi-square with three degrees of freedom."""


def sd_of_deviations(deviations: ArrayLike) -> float:
    """Standard deviation of normal errors of which most of the given deviations (n,) from zero are, by their median absolute value."""
    return MAD_TO_SD * float(np.median(np.abs(deviations)))


def t_weights(misfits: FloatArray) -> tuple[FloatArray, float]:
    """Robust weights of vectors of three components, and the factor of their covariances by which they were judged.

    Parameters
    ----------
    misfits
        (n,) quadratic forms of the vectors in the inverse of their stated covariances.

    Returns
    -------
    (n,) weights from 1 to 0 that fall like those of a t distribution of few degrees of freedom, and the factor: from the median of the
    misfits, never below the stated one.
    """
    size = max(float(np.median(misfits)) / CHI2_3_MEDIAN, 1.0) if len(misfits) else 1.0
    return np.asarray(1 / (1 + misfits / (3 * size)) ** 2), size
