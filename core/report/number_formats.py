"""How a report writes numbers and times: names of the filters in its templates; a dash where there is nothing."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from typing import Any

import numpy as np
from numpy.typing import ArrayLike


def _cm(value: float | None) -> str:
    return "–" if value is None else f"{100 * value:.1f}"


def _mm(value: float | None) -> str:
    return "–" if value is None else f"{1000 * value:.1f}"


def _signed_cm(value: float | None) -> str:
    return "–" if value is None else f"{100 * value:+.2f}"


def _percent(value: float | None) -> str:
    return "–" if value is None else f"{100 * value:.1f} %"


def _degrees(value: float | None) -> str:
    return "–" if value is None else f"{value:.2f}°"


def _p(value: float | None) -> str:
    return "–" if value is None else ("< 0.001" if value < 0.001 else f"{value:.3f}")


def _day(value: datetime | None) -> str:
    return "–" if value is None else value.strftime("%Y-%m-%d %H:%M UTC")


def _places(values: ArrayLike | None) -> str:
    return "–" if values is None else ", ".join(f"{value:.2f}" for value in np.asarray(values, dtype=np.float64))


NUMBER_FORMATS: dict[str, Callable[[Any], str]] = {
    "cm": _cm,
    "signed_cm": _signed_cm,
    "percent": _percent,
    "mm": _mm,
    "degrees": _degrees,
    "p": _p,
    "day": _day,
    "places": _places,
}
