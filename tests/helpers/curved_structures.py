"""Structures that turn: places of units beside a line in plan, and their chainage along it."""

from __future__ import annotations

import numpy as np

WIDTH = 10.0
DENSITY = 1.5
"""Units per metre of structure."""


def line_of(name: str) -> np.ndarray:
    """(n, 2) corners of the middle of a ``straight``, an ``L``, a ``U``, a trunk that ends in a half circle (``head``) or a ``ring``."""
    turn = np.linspace(0, np.pi, 60)[:, None]
    lines = {
        "straight": np.array([[0.0, 0.0], [240.0, 60.0]]),
        "L": np.array([[0.0, 0.0], [200.0, 0.0], [200.0, 80.0]]),
        "U": np.array([[0.0, 0.0], [200.0, 0.0], [200.0, 150.0], [0.0, 150.0]]),
        "head": np.vstack([[[0.0, 40.0]], np.hstack([150 + 40 * np.sin(turn), 40 * np.cos(turn)])]),
        "ring": np.hstack([60 * np.cos(2 * turn), 60 * np.sin(2 * turn)])[:-1],
    }
    return lines[name]


def units_along(line: np.ndarray, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(n, 3) places of units beside a line (n, 2), their chainage (n,) along it, and the same units (n, 3) of a straight line, metres."""
    rng = np.random.default_rng(seed)
    steps = np.linalg.norm(np.diff(line, axis=0), axis=1)
    begin = np.append(0.0, np.cumsum(steps))
    chainage = rng.uniform(0, begin[-1], round(DENSITY * begin[-1]))
    part = np.searchsorted(begin, chainage, side="right") - 1
    heading = (np.diff(line, axis=0) / steps[:, None])[part]
    across = rng.uniform(-WIDTH / 2, WIDTH / 2, len(chainage))
    left = np.column_stack([-heading[:, 1], heading[:, 0]])
    places = line[part] + (chainage - begin[part])[:, None] * heading + across[:, None] * left
    level = np.zeros(len(places))
    return np.column_stack([places, level]), chainage, np.column_stack([chainage, across, level])
