"""The chart of a planned survey: what it detects over point density and visible share, as one HTML page with a drawing in it."""

from __future__ import annotations

import html
import math
from collections.abc import Sequence
from typing import Any

from .lengths import LengthFormat, length_format
from .translation import tr

WIDTH, HEIGHT = 720, 420
LEFT, RIGHT, TOP, BOTTOM = 70, 190, 20, 50
COLOURS = ("#0072B2", "#009E73", "#D55E00", "#AA4499", "#E69F00")
"""Okabe and Ito (2008): told apart by colour-blind readers."""


def chart_page(found: dict[str, Any], rows: Sequence[tuple[str, str]], density: float, visible: float) -> str:
    """HTML page of a plan.

    Parameters
    ----------
    found
        What the engine answers, with ``curves``.
    rows
        Names and values to be listed below the chart.
    density, visible
        Of the plan, which is marked.
    """
    lengths = length_format()
    title = tr("Which displacement a planned survey detects")
    said = tr("A unit that moves by {length} in its worst direction is found with the chosen power; the mark in the chart.").format(
        length=f"<b>{html.escape(lengths.text(found['detectable_worst']))}</b>"
    )
    listed = "".join(f"<tr><td>{html.escape(name)}</td><td>{html.escape(value)}</td></tr>" for name, value in rows)
    return (
        f"<!doctype html><html><head><meta charset='utf-8'><title>{html.escape(title)}</title>"
        "<style>body{font-family:sans-serif;margin:1.5em;max-width:60em}td{padding:.15em 1.2em .15em 0}td+td{text-align:right}</style>"
        f"</head><body><h2>{html.escape(title)}</h2><p>{said}</p>"
        f"{_drawing(found['curves'], (density, found['detectable_worst']), visible, lengths)}"
        f"<table>{listed}</table></body></html>"
    )


def _drawing(curves: Sequence[dict[str, Any]], plan: tuple[float, float], visible: float, lengths: LengthFormat) -> str:
    points = [(x, y) for curve in curves for x, y in zip(curve["density"], curve["detectable_worst"], strict=True)] + [plan]
    low_x, high_x = (math.log10(f(x for x, _ in points)) for f in (min, max))
    low_y, high_y = (math.log10(f(y for _, y in points)) for f in (min, max))
    # a little air above and below
    low_y, high_y = low_y - 0.05, high_y + 0.05

    def place(x: float, y: float) -> tuple[float, float]:
        across = (math.log10(x) - low_x) / max(high_x - low_x, 1e-9)
        up = (math.log10(y) - low_y) / max(high_y - low_y, 1e-9)
        return LEFT + across * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - up * (HEIGHT - TOP - BOTTOM)

    parts = [_axes(place, (low_x, high_x), (low_y, high_y), lengths)]
    for k, curve in enumerate(curves):
        colour = COLOURS[k % len(COLOURS)]
        line = " ".join("{:.1f},{:.1f}".format(*place(x, y)) for x, y in zip(curve["density"], curve["detectable_worst"], strict=True))
        width = 3 if abs(curve["visible"] - visible) < 1e-9 else 1.5
        parts.append(f"<polyline points='{line}' fill='none' stroke='{colour}' stroke-width='{width}'/>")
        text = html.escape(tr("{share} % of a unit seen").format(share=f"{100 * curve['visible']:.0f}"))
        row = TOP + 14 + 20 * k
        parts.append(
            f"<line x1='{WIDTH - RIGHT + 14}' x2='{WIDTH - RIGHT + 38}' y1='{row}' y2='{row}' stroke='{colour}' stroke-width='{width}'/>"
        )
        parts.append(f"<text x='{WIDTH - RIGHT + 44}' y='{row + 4}'>{text}</text>")
    x, y = place(*plan)
    parts.append(f"<circle cx='{x:.1f}' cy='{y:.1f}' r='6' fill='#c62828' stroke='#fff' stroke-width='2'/>")
    parts.append(f"<text x='{x + 10:.1f}' y='{y - 8:.1f}' font-weight='bold'>{html.escape(lengths.text(plan[1]))}</text>")
    style = "font:12px sans-serif;background:#fff"
    return f"<svg xmlns='http://www.w3.org/2000/svg' width='{WIDTH}' height='{HEIGHT}' style='{style}'>{''.join(parts)}</svg>"


def _axes(place: Any, x_range: tuple[float, float], y_range: tuple[float, float], lengths: LengthFormat) -> str:
    parts = []
    (left, bottom), (right, top) = place(10 ** x_range[0], 10 ** y_range[0]), place(10 ** x_range[1], 10 ** y_range[1])
    for value in _ticks(10 ** x_range[0], 10 ** x_range[1]):
        x, _ = place(value, 10 ** y_range[0])
        parts.append(f"<line x1='{x:.1f}' x2='{x:.1f}' y1='{top:.1f}' y2='{bottom:.1f}' stroke='#ddd'/>")
        parts.append(f"<text x='{x:.1f}' y='{bottom + 16:.1f}' text-anchor='middle'>{value:g}</text>")
    for shown in _ticks(10 ** y_range[0] * lengths.factor, 10 ** y_range[1] * lengths.factor):
        _, y = place(10 ** x_range[0], shown / lengths.factor)
        parts.append(f"<line x1='{left:.1f}' x2='{right:.1f}' y1='{y:.1f}' y2='{y:.1f}' stroke='#ddd'/>")
        parts.append(f"<text x='{left - 6:.1f}' y='{y + 4:.1f}' text-anchor='end'>{shown:g}</text>")
    parts.append(
        f"<rect x='{left:.1f}' y='{top:.1f}' width='{right - left:.1f}' height='{bottom - top:.1f}' fill='none' stroke='#44505a'/>"
    )
    across, up = (
        html.escape(tr("Point density (points/m²)")),
        html.escape(tr("Detectable displacement ({unit})").format(unit=lengths.suffix)),
    )
    parts.append(f"<text x='{(left + right) / 2:.1f}' y='{bottom + 38:.1f}' text-anchor='middle'>{across}</text>")
    middle = (top + bottom) / 2
    parts.append(f"<text x='18' y='{middle:.1f}' text-anchor='middle' transform='rotate(-90 18 {middle:.1f})'>{up}</text>")
    return "".join(parts)


def _ticks(low: float, high: float) -> list[float]:
    """1, 2 and 5 times powers of ten between two positive values."""
    powers = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    return [step * 10.0**power for power in powers for step in (1, 2, 5) if low <= step * 10.0**power <= high]
