"""Velocities of units seen in more than two epochs: a straight uniform motion through their positions.

The poses of a unit share the error of its casting, which drops out of their differences: the line is fitted with the covariance of all of
them together. Its datum is that of the first epoch that shows the unit.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime

import numpy as np
from scipy.linalg import block_diag
from scipy.special import fdtrc

from ..common.arrays import FloatArray
from ..model.feature_points import FEATURES, feature_points
from .displacement import FramePart
from .epoch_pairs import EpochPair, TrackedUnits, joint_block, unit_shape

SECONDS_PER_YEAR = 365.25 * 86400
FEWEST_EPOCHS = 3
"""Epochs with a pose from which a velocity is told."""


@dataclass(frozen=True, eq=False)
class Velocity:
    """Linear motion of a feature through more than two epochs.

    Attributes
    ----------
    vector, sd
        (3,) metres a year.
    misfit_p_value
        Test of the positions against a straight uniform motion.
    """

    feature: str
    vector: FloatArray
    sd: FloatArray
    misfit_p_value: float


def velocities_of_units(units: TrackedUnits, times: Sequence[datetime], pairs: Sequence[EpochPair]) -> dict[int, tuple[Velocity, ...]]:
    """Unit to the velocities of its features, for certain units that were not carried elsewhere and have three poses or more.

    Parameters
    ----------
    units
        With their states in all epochs and the joint covariance of their poses.
    times
        Of the epochs.
    pairs
        All pairs of epochs, with what the frames bring into the motion of each unit in datum ``stable``.
    """
    years = np.array([time.timestamp() for time in times]) / SECONDS_PER_YEAR
    by_epochs = {(pair.first, pair.second): pair for pair in pairs}
    frames = {key: {motion.unit: motion.frames["stable"] for motion in pair.units} for key, pair in by_epochs.items()}
    found = {}
    for unit, states in enumerate(units.states):
        epochs = [e for e, s in sorted(states.items()) if s.pose is not None and s.status != "uncertain"]
        if len(epochs) < FEWEST_EPOCHS or units.tracks[unit].relocated:
            continue
        first, *later = epochs
        found[unit] = _velocities(
            units, unit, years[epochs], epochs, [by_epochs[first, e] for e in later], [frames[first, e][unit] for e in later]
        )
    return found


def _velocities(
    units: TrackedUnits, unit: int, years: FloatArray, epochs: Sequence[int], pairs: Sequence[EpochPair], frames: Sequence[FramePart]
) -> tuple[Velocity, ...]:
    """Those of one unit from its poses; ``pairs`` and ``frames`` from its first epoch to each later one."""
    states, kind = units.states[unit], units.tracks[unit].kind
    points = [feature_points(p, unit_shape(units.types[kind], states[e].scale)) for e in epochs if (p := states[e].pose) is not None]
    joint = joint_block(units.joint, unit, *(units.numbers[unit, e] for e in epochs))
    nulls = [pair.congruence.null for pair in pairs]
    factor, floor = np.median([null.factor for null in nulls]), np.median([null.floor for null in nulls])
    tail, spread = min(null.tail for null in nulls), float(np.median([null.spread for null in nulls]))
    brought = [frame.at(own.positions - own.positions[0]) for frame, own in zip(frames, points[1:], strict=True)]
    result = []
    for f in range(len(FEATURES)):
        rows = block_diag(*(own.jacobian[f, :, :6] for own in points))
        # the floor of a difference belongs half to each of its epochs
        own_covariance = factor**2 * rows @ joint @ rows.T + 0.5 * floor**2 * np.eye(len(rows))
        frame_covariance = block_diag(np.zeros((3, 3)), *(covariances[f] for _, covariances in brought))
        positions = np.array([own.positions[f] for own in points])
        positions[1:] -= [shifts[f] for shifts, _ in brought]
        result.append(velocity(f, years, positions, own_covariance, frame_covariance, tail, spread))
    return tuple(result)


def velocity(
    feature: int, years: FloatArray, positions: FloatArray, own: FloatArray, frames: FloatArray, tail: float, spread: float
) -> Velocity:
    """Weighted straight line through positions.

    Parameters
    ----------
    feature
        Index in ``FEATURES``.
    years
        (e,) times of the epochs.
    positions
        (e, 3) in one datum, metres.
    own, frames
        (3 e, 3 e) covariances: of the unit itself, as scale of a t distribution, and of the frames.
    tail, spread
        Degrees of freedom of that distribution, and its variance over its squared scale.
    """
    t = years - years.mean()
    design = np.vstack([np.hstack([np.eye(3), k * np.eye(3)]) for k in t])
    weighted = np.linalg.solve(own + frames, design)
    gain = np.linalg.solve(design.T @ weighted, weighted.T)
    values = (positions - positions[0]).ravel()
    solution = gain @ values
    residuals = values - design @ solution
    stated = gain @ (spread * own + frames) @ gain.T
    degrees = 3 * len(t) - 6
    form = float(residuals @ np.linalg.solve(own + frames, residuals))
    return Velocity(FEATURES[feature], solution[3:], np.sqrt(np.diag(stated)[3:]), float(fdtrc(degrees, tail, form / degrees)))
