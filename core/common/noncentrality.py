"""Noncentrality of tests: how large an effect must be to be found with a given power."""

from __future__ import annotations

from scipy.optimize import brentq
from scipy.special import chdtri, chndtr


def noncentrality(significance: float, power: float, freedom: int = 3) -> float:
    """Noncentrality of a chi-square test of ``freedom`` degrees that is found with a given power (Baarda, 1968)."""
    threshold = float(chdtri(freedom, significance))
    return float(brentq(lambda value: 1 - float(chndtr(threshold, freedom, value)) - power, 1e-9, 1e4))
