"""How a report writes numbers, times and names: names of the filters in its templates; a dash where there is nothing."""

from __future__ import annotations

import math
from collections.abc import Callable
from datetime import datetime
from typing import Any

import numpy as np
from markupsafe import Markup
from numpy.typing import ArrayLike

LONG_NAME, NAME_PART = 16, 8
"""Letters beyond which a name may be broken in a table, which it would make wider than the page, and after how many letters each."""


def further_decimals(height: float) -> int:
    """Decimals that lengths have besides the usual ones where units are lower than a metre: one for each power of ten."""
    return max(0, math.ceil(-math.log10(height)))


def _length(factor: float, decimals: int, sign: str = "") -> Callable[[float | None], str]:
    """How a length in metres is written, after multiplication."""
    return lambda value: "–" if value is None else f"{factor * value:{sign}.{decimals}f}"


def _percent(value: float | None) -> str:
    return "–" if value is None else f"{100 * value:.1f} %"


def _probability(value: float | None) -> str:
    """In percent, and never certain."""
    if value is None:
        return "–"
    return "> 99.9 %" if value > 0.999 else "< 0.1 %" if value < 0.001 else _percent(value)


def _degrees(value: float | None) -> str:
    return "–" if value is None else f"{value:.2f}°"


def _p(value: float | None) -> str:
    return "–" if value is None else ("< 0.001" if value < 0.001 else f"{value:.3f}")


def _day(value: datetime | None) -> str:
    return "–" if value is None else value.strftime("%Y-%m-%d %H:%M UTC")


def _places(values: ArrayLike | None) -> str:
    return "–" if values is None else ", ".join(f"{value:.2f}" for value in np.asarray(values, dtype=np.float64))


def _name(value: object) -> str:
    """A name, with places where it may be broken if it is long; what copies it copies no letter more."""
    text = str(value)
    if len(text) <= LONG_NAME:
        return text
    return Markup("<wbr>").join(text[k : k + NAME_PART] for k in range(0, len(text), NAME_PART))


def _name_cell(value: object) -> str:
    """A cell of a table that holds a name: a short one stays on one line."""
    cell = Markup('<td class="whole">{}</td>') if len(str(value)) <= LONG_NAME else Markup("<td>{}</td>")
    return cell.format(_name(value))


def number_formats(height: float) -> dict[str, Callable[[Any], str]]:
    """Filters by name, for units of a height H (metres): models of a tank move by tenths of a millimetre."""
    further = further_decimals(height)
    return {
        "m": _length(1, 3 + further),
        "rough_m": _length(1, 2 + further),
        "cm": _length(100, 1 + further),
        "signed_cm": _length(100, 2 + further, "+"),
        "percent": _percent,
        "probability": _probability,
        "mm": _length(1000, 1 + further),
        "degrees": _degrees,
        "p": _p,
        "day": _day,
        "name": _name,
        "name_cell": _name_cell,
        "places": _places,
    }
