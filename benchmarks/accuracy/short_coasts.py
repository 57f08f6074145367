"""Datum control and positions of short coasts, where few draws decide: is every single one as far off as it says?

    python benchmarks/accuracy/short_coasts.py [--seeds 40] [--first 0]
    python benchmarks/accuracy/short_coasts.py --positions --length 320 --station 150 [--density 2] [--seeds 40] [--first 0]

Flat coasts of 100 m with two stations of eight targets: the clouds of both epochs lie off by the mean offset of their strips, which the
registration is told or not, and units are judged with the control's own size and with that of the units at rest. Bent coasts (3 cm):
positions of units between the stations, here or on coasts of another length (``--positions``). Displacements with their covariances
are drawn (``tests/helpers/bent_coast.py``), no clouds.
"""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "helpers"))

from bent_coast import BentCoast, bent_coast
from tetratrack.benchmarks.accuracy.frames import DEGREES, HEIGHT, flagged, frames_of
from tetratrack.core.deformation.chained_frames import chained_errors
from tetratrack.core.deformation.congruence import Congruence, congruence_of
from tetratrack.core.deformation.control_scale import with_rigid_scale
from tetratrack.core.deformation.elastic_congruence import elastic_congruence_of
from tetratrack.core.registration.weighted_transformation import weighted_fit

LENGTH, STATION, DENSITY = 105.0, 52.5, 2.0
OFFSETS = ((0.003, 0.003), (0.003, 0.0), (0.0015, 0.003), (0.0, 0.0015))
"""Mean offsets of the strips of an epoch, true and told, metres."""
HONEST, LEVELS = (0.7, 1.4), (0.02, 0.08)
"""Mean squared normalised errors and shares of flagged resting units that are true to what is stated."""


def flat(seed: int, offset: float, told: float) -> dict[str, tuple[float, float]]:
    """Mean squared normalised error and flagged share of resting units in datum control, by the control's own size and by theirs."""
    coast = bent_coast(seed, length=LENGTH, station=STATION, density=DENSITY, rms=1e-9)
    rng = np.random.default_rng([seed, 1])
    origin = coast.places.mean(axis=0)
    vectors, prior = coast.displacements.copy(), np.zeros((7, 7))
    for sign, residuals in zip((-1, 1), coast.residuals, strict=True):
        variances = np.full(residuals.shape, coast.target_sd**2)
        fit = weighted_fit(coast.targets, coast.targets + residuals, variances, np.ones(len(residuals), dtype=bool), False)
        vectors += sign * (fit.transformation.apply(coast.places) - coast.places + rng.normal(0, offset, 3))
        prior += fit.transformation.with_offset(told**2).covariance_at(origin)
    own = congruence_of(vectors, coast.covariances, coast.places, prior, origin, HEIGHT, DEGREES)
    scaled = with_rigid_scale(own, vectors, coast.covariances, coast.places)
    return {name: _judged(coast, vectors, found) for name, found in (("own", own), ("resting", scaled))}


def _judged(coast: BentCoast, vectors: Any, found: Congruence) -> tuple[float, float]:
    frame = found.rigid_motions(coast.places, "control").covariances[:, :3, :3]
    total = found.null.spread * found.null.covariance(coast.covariances) + frame
    squares = (vectors - coast.motions) ** 2 / np.einsum("nii->ni", total)
    return float(np.mean(squares[coast.resting])), flagged(found.control_p_values[coast.resting])


def bent(seed: int, length: float = LENGTH, station: float = STATION, density: float = DENSITY) -> tuple[float, float, float]:
    """Positions of units between stations: mean squared error and variance (square metres), and mean squared normalised error."""
    coast = bent_coast(seed, length=length, station=station, density=density)
    frames = frames_of(coast)
    if frames is None:
        raise ValueError("a bend of 3 cm was not seen")
    control, precision = frames.between(0, 1)
    datum = elastic_congruence_of(
        coast.displacements, coast.covariances, coast.places, control, precision, HEIGHT, frames.degrees,
        frames.jumped(0, 1, coast.places), frames.controlled(0, 1),
    )[1]  # fmt: skip
    away, variances = [], []
    for field, bend in zip(chained_errors(frames, [datum]), coast.bends, strict=True):
        if field is not None:
            known = field.at(coast.places)
            away.append(known.means[:, :3] - bend)
            variances.append(np.einsum("nii->ni", known.covariances[:, :3, :3]))
    squares, stated = np.square(away), np.array(variances)
    return float(3 * np.mean(squares)), float(3 * np.mean(stated)), float(np.mean(squares / stated))


def share(values: Any, limits: tuple[float, float]) -> float:
    """Per cent of the values within the limits."""
    return 100 * float(np.mean((values >= limits[0]) & (values <= limits[1])))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=40)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--positions", action="store_true", help="of bent coasts alone")
    parser.add_argument("--length", type=float, default=LENGTH, help="of a bent coast, metres")
    parser.add_argument("--station", type=float, default=STATION, help="distance of its stations of targets, metres")
    parser.add_argument("--density", type=float, default=DENSITY, help="its units a metre")
    arguments = parser.parse_args()
    seeds = range(arguments.first, arguments.first + arguments.seeds)
    if not arguments.positions:
        print_flat(seeds)
    squares, stated, z = np.array([bent(seed, arguments.length, arguments.station, arguments.density) for seed in seeds]).T
    rmse, sd = 1000 * np.sqrt(squares.mean()), 1000 * np.sqrt(stated.mean())
    error, (low, high) = z.std() / math.sqrt(len(z)), np.quantile(z, (0.1, 0.9))
    print(f"positions: RMSE {rmse:.1f} mm, stated {sd:.1f} mm, z² {z.mean():.2f} ± {error:.2f}", end=" ")
    print(f"(median {np.median(z):.2f}, 80 % {low:.2f}–{high:.2f}, all {z.min():.2f}–{z.max():.2f})")


def print_flat(seeds: range) -> None:
    """A row for each mean offset and each size."""
    print("| mean offset, told (mm) | size by | z², coasts within 0.7–1.4 | flagged, coasts within 2–8 % |\n| --- | --- | --- | --- |")
    for offset, told in OFFSETS:
        found = [flat(seed, offset, told) for seed in seeds]
        for name in ("own", "resting"):
            z, flags = np.array([row[name] for row in found]).T
            size = f"{z.mean():.2f} ({z.min():.2f}–{z.max():.2f}), {share(z, HONEST):.0f} %"
            level = f"{100 * flags.mean():.1f} % ({100 * flags.min():.1f}–{100 * flags.max():.1f}), {share(flags, LEVELS):.0f} %"
            print(f"| {1000 * offset:.1f}, {1000 * told:.1f} | {name} | {size} | {level} |", flush=True)


if __name__ == "__main__":
    main()
