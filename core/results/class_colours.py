"""One colour a class of unit, for maps, scenes, models and the report."""

from __future__ import annotations

CLASS_COLOURS = {
    "stable": "#A0ACB8",
    "moved": "#E69F00",
    "rotated": "#3C78D8",
    "relocated": "#7D3C98",
    "lost": "#C0392B",
    "new": "#009E73",
    "uncertain": "#D8D0C0",
    "unseen": "#FFFFFF",
}
"""Hexadecimal RGB by ``displacements.class``, and by ``units.status`` where a unit has no displacement.

Everybody tells them apart, in numbers: ``tests/core/results/test_colours.py``."""
UNKNOWN_COLOUR = "#D8D0C0"


def class_colour(kind: str | None) -> str:
    """Colour of a class or status; a unit of the first epoch, found and compared with nothing yet, is shown as a stable one."""
    return CLASS_COLOURS.get("stable" if kind == "found" else str(kind), UNKNOWN_COLOUR)
