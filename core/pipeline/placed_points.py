"""Points of an epoch's cloud where a run saw them: in the control frame, straightened, less the offsets of their strips or stations."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..common.arrays import FloatArray
from ..registration.frame_correction import FrameCorrection
from ..registration.transformation import transformation_of
from ..results.unit_rows import EpochInfo

Placing = Callable[[FloatArray, ArrayLike], FloatArray]
"""From (n, 3) points in the survey's CRS and their (n,) source IDs to the control frame."""


def placing(info: EpochInfo, bends: Sequence[Mapping[str, Any]]) -> Placing:
    """How the points of an epoch come to where poses and displacements of a result are.

    Parameters
    ----------
    info
        The epoch as the result states it.
    bends
        Rows of the result's layer ``frame_errors``.
    """
    transformation, correction = transformation_of(info.transformation), FrameCorrection.from_rows(bends, info.label)

    def placed(points: FloatArray, source_ids: ArrayLike) -> FloatArray:
        registered = points if transformation is None else transformation.apply(points)
        return registered - correction.at(registered) - offsets_of_points(info, source_ids)

    return placed


def offsets_of_points(info: EpochInfo, source_ids: ArrayLike) -> FloatArray:
    """(n, 3) offsets of the strips or stations of points, metres in the control frame, as the run estimated them; 0 where it did not."""
    known = {int(source): offset for source, offset in info.settings.get("source_offsets_m", {}).items()}
    ids, inverse = np.unique(np.asarray(source_ids, dtype=np.int64), return_inverse=True)
    return np.array([known.get(int(source), (0.0, 0.0, 0.0)) for source in ids], dtype=np.float64).reshape(-1, 3)[inverse]
