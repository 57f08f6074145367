"""What a result records of an epoch's registration, read by those who transform by it and by those who only need its errors."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .arrays import FloatArray
from .errors import InputError

SHAPES: Mapping[str, tuple[int, ...]] = {
    "origin_from": (3,),
    "origin_to": (3,),
    "translation_m": (3,),
    "rotation_vector_rad": (3,),
    "scale": (),
    "covariance": (7, 7),
}
"""Numbers of a transformation's record."""


def record_numbers(record: Mapping[str, Any], name: str) -> FloatArray:
    """Numbers of one entry of ``SHAPES``, in its shape, from the record of a transformation in layer ``epochs``.

    Raises
    ------
    InputError
        The entry is missing or holds something else.
    """
    if name not in record:
        raise InputError(f"layer epochs holds a transformation without {name!r}", remedy="Run tetratrack again.")
    try:
        return np.array(record[name], dtype=np.float64).reshape(SHAPES[name])
    except (TypeError, ValueError) as error:
        raise InputError(f"layer epochs holds a damaged transformation: {name!r}", remedy="Run tetratrack again.") from error


def common_variance(settings: Mapping[str, Any]) -> FloatArray:
    """(3,) variance of what all points of an epoch have in common of the offsets and drifts of its strips or stations, square metres.

    Parameters
    ----------
    settings
        Of the epoch. Earlier versions have not said how far the mean offset is known, which the offsets then tell, or the mean drift.
    """
    sd = settings.get("mean_offset_sd_m")
    offset = mean_offset_variance(list(settings.get("source_offsets_m", {}).values())) if sd is None else float(sd) ** 2
    return offset + np.broadcast_to(np.square(settings.get("mean_drift_sds_m", 0.0)), 3)


def mean_offset_variance(offsets: ArrayLike) -> float:
    """Variance per axis (square metres) of the mean of (k, 3) offsets of strips or stations; 0 for less than two."""
    own = np.asarray(offsets, dtype=np.float64).reshape(-1, 3)
    if len(own) < 2:
        return 0.0
    return float(np.mean(np.sum(own**2, axis=0) / (len(own) - 1) / len(own)))
