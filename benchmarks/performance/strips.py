"""Processor time and memory of one step of drifting strips by the length of a made-up coast: both grow as it does.

    python benchmarks/performance/strips.py [--lengths 240 480 960 1920] [--stations-every 12]

Two epochs of stations, each of which sees the units of four of its distances, two units a metre. Time is that of the normal equations,
their solution and the covariances, and the ratio to the length before says how it grows: 2 where the coast is twice as long.
"""

from __future__ import annotations

import argparse
import time
import tracemalloc

import numpy as np
from tetratrack.core.common.arrays import upper_triangle
from tetratrack.core.deformation.strip_drifts import DriftSystem, Knots, UnitEquations

HEIGHT, UNITS_PER_METRE, SEEN_BY, EPOCHS = 2.3, 2, 4, 2


def coast(length: float, distance: float) -> tuple[Knots, list[UnitEquations], np.ndarray]:
    """Knots, equations of the units and the epochs of the stations."""
    rng = np.random.default_rng(0)
    along = np.sort(rng.uniform(0, length, int(UNITS_PER_METRE * length)))
    knots = Knots.along(np.column_stack([along, np.zeros((len(along), 2))]), HEIGHT)
    if knots is None:
        raise SystemExit(f"a coast of {length} m is too short for knots")
    stations, equations = int(length / distance), []
    for unit, place in enumerate(along):
        nearest = np.clip(int(place / distance) + np.arange(SEEN_BY) - SEEN_BY // 2, 0, stations - 1)
        strips = np.unique(nearest + stations * np.arange(EPOCHS)[:, None])
        size = 3 * len(strips)
        equations.append(
            UnitEquations(unit=unit, strips=strips, upper=(1e6 * np.eye(size))[upper_triangle(size)], rhs=rng.normal(0, 1e3, size))
        )
    return knots, equations, np.repeat(np.arange(EPOCHS), stations)


def step(knots: Knots, equations: list[UnitEquations], epochs: np.ndarray) -> int:
    """One step with its covariances; the number of unknowns."""
    system = DriftSystem(knots, epochs, equations, np.full(len(epochs), 0.005), {k: k for k in range(len(equations))})
    _, factor = system.solve(0.001, np.zeros((knots.count, len(epochs), 3)))
    system.cofactors(factor)
    return system.size


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--lengths", type=float, nargs="+", default=[240.0, 480.0, 960.0, 1920.0], metavar="METRES")
    parser.add_argument("--stations-every", type=float, default=12.0, metavar="METRES")
    options = parser.parse_args()
    before = float("nan")
    for length in options.lengths:
        made = coast(length, options.stations_every)
        start = time.process_time()
        unknowns = step(*made)
        seconds = time.process_time() - start
        tracemalloc.start()
        step(*made)
        peak = tracemalloc.get_traced_memory()[1] / 1e6
        tracemalloc.stop()
        print(f"{length:6.0f} m: {unknowns:6d} unknowns, {seconds:6.2f} CPU s (ratio {seconds / before:4.1f}), {peak:6.0f} MB")
        before = seconds


if __name__ == "__main__":
    main()
