"""Units and targets along a coast whose epochs bend, as displacements and residuals: no clouds, so that many seeds cost little."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
ANGLE = 0.5
DIRECTION = np.array([math.cos(ANGLE), math.sin(ANGLE)])
SLIDE = (0.07, 0.0, -0.07)
"""Common motion of a sliding stretch, metres."""


@dataclass(frozen=True, eq=False, kw_only=True)
class BentCoast:
    """Two epochs: (n, 3) places, displacements and true motions of units with (n, 3, 3) covariances; bends at units; targets."""

    places: FloatArray
    displacements: FloatArray
    covariances: FloatArray
    motions: FloatArray
    bends: tuple[FloatArray, FloatArray]
    targets: FloatArray
    residuals: tuple[FloatArray, FloatArray]
    target_sd: float

    @property
    def resting(self) -> NDArray[np.bool_]:
        return ~self.motions.any(axis=1)

    @property
    def sliding(self) -> NDArray[np.bool_]:
        """(n,) units on the stretch that moved as one."""
        return np.asarray(np.all(self.motions == SLIDE, axis=1))


def waves(rng: np.random.Generator, along: FloatArray, rms: float, shortest: float, longest: float) -> FloatArray:
    """(k, 3) sums of eight sinusoids of random wave lengths along the coast, scaled to a root mean square in metres."""
    total = np.zeros((len(along), 3))
    for axis in range(3):
        lengths = np.exp(rng.uniform(math.log(shortest), math.log(longest), 8))
        amplitudes = rng.normal(size=8)
        amplitudes *= rms * math.sqrt(2 / np.sum(amplitudes**2))
        phases = rng.uniform(0, 2 * math.pi, 8)
        total[:, axis] = np.sum(amplitudes * np.sin(2 * math.pi * along[:, None] / lengths + phases), axis=1)
    return total


def bent_coast(
    seed: int, *, length: float = 168.0, rms: float = 0.03, shortest: float = 60.0, longest: float = 300.0, station: float = 50.0,
    slide: tuple[float, float] | None = None, unit_sd: float = 0.0025, target_sd: float = 0.006, density: float = 4.6,
    control_sd: float = 0.0,
) -> BentCoast:  # fmt: skip
    """A coast of ``length`` metres with ``density`` units a metre; every ``station`` metres eight targets on the wall behind them.

    Their coordinates were surveyed once, to ``control_sd``, for all epochs.
    """
    rng = np.random.default_rng(seed)
    count = int(length * density)
    along, across = rng.uniform(0, length, count), rng.uniform(0, 15, count)
    size = np.exp(rng.normal(0, 0.5, count)) * unit_sd
    frames = np.linalg.qr(rng.normal(size=(count, 3, 3)))[0]
    roots = frames * (size[:, None] * np.array([1.0, 1.0, 2.0]))[:, None, :]
    covariances = roots @ np.swapaxes(roots, 1, 2)
    stations = np.arange(station / 2, length, station) if 0 < station < 2 * length else np.empty(0)
    along_targets = (stations[:, None] + rng.uniform(-8, 8, (len(stations), 8))).ravel()
    across_targets = rng.uniform(16, 22, len(along_targets))
    both = np.concatenate([along, along_targets])
    bends = [waves(rng, both, rms, shortest, longest) for _ in range(2)]
    motions = np.zeros((count, 3))
    moved = rng.random(count) < 0.15
    directions = rng.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    motions[moved] = (directions * rng.uniform(0.02, 0.2, count)[:, None])[moved]
    if slide is not None:
        motions[(along > slide[0]) & (along < slide[1])] = SLIDE
    # understated as real covariances are
    errors = 1.15 * np.einsum("nij,nj->ni", roots, rng.normal(size=(count, 3)))
    targets = _placed(along_targets, across_targets, np.full(len(along_targets), 9.0))
    control = np.random.default_rng([seed, 1]).normal(0, control_sd, targets.shape)
    return BentCoast(
        places=_placed(along, across, 8 - 0.5 * across),
        displacements=bends[1][:count] - bends[0][:count] + motions + errors,
        covariances=covariances,
        motions=motions,
        bends=(bends[0][:count], bends[1][:count]),
        targets=targets,
        residuals=(
            bends[0][count:] + rng.normal(0, target_sd, targets.shape) - control,
            bends[1][count:] + rng.normal(0, target_sd, targets.shape) - control,
        ),
        target_sd=target_sd,
    )


def _placed(along: FloatArray, across: FloatArray, height: FloatArray) -> FloatArray:
    normal = np.array([-DIRECTION[1], DIRECTION[0]])
    return np.column_stack([along[:, None] * DIRECTION + across[:, None] * normal, height])
