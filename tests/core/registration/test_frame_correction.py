"""Bent frames as a result states them, for those who go back to the cloud."""

from __future__ import annotations

import numpy as np
from curved_structures import line_of, units_along
from tetratrack.core.registration.frame_correction import FrameCorrection


def bend(along: np.ndarray) -> np.ndarray:
    return 0.04 * np.column_stack([np.sin(2 * np.pi * along / 80), np.cos(2 * np.pi * along / 60), np.sin(2 * np.pi * along / 120 + 1)])


def rows(epoch: str = "a") -> list[dict]:
    along = np.arange(0, 170, 7.0)
    places = np.column_stack([500_000 + 0.8 * along, 4_000_000 - 0.6 * along, np.full(len(along), 3.0)])
    errors = bend(along)
    return [
        {
            "epoch": epoch, "known_by": "targets", "geometry": places[k], "de": errors[k, 0], "dn": errors[k, 1], "dh": errors[k, 2],
            "sd_e": 0.004, "sd_n": 0.005, "sd_h": 0.006, "along": along[k],
        }
        for k in np.random.default_rng(0).permutation(len(along))
    ]  # fmt: skip


def test_the_error_is_found_between_the_rows_whatever_their_order() -> None:
    correction = FrameCorrection.from_rows(rows(), "a")
    along, across = np.random.default_rng(1).uniform([5, -8], [160, 8], (200, 2)).T
    points = np.column_stack([500_000 + 0.8 * along + 0.6 * across, 4_000_000 - 0.6 * along + 0.8 * across, np.full(200, 2.0)])
    assert np.abs(correction.at(points) - bend(along)).max() < 0.004
    assert np.allclose(correction.variances_at(points), np.array([0.004, 0.005, 0.006]) ** 2)


def test_arms_of_a_harbour_keep_errors_of_their_own() -> None:
    """Two arms side by side and the quay between them: what lies beside it on the other arm says nothing of a place."""
    line = line_of("U")
    steps = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1)))
    along = np.arange(3.5, steps[-1], 7.0)
    stations = np.column_stack([np.interp(along, steps, line[:, 0]), np.interp(along, steps, line[:, 1]), np.full(len(along), 3.0)])
    places, chainage, _ = units_along(line, 1)
    errors = bend(along)
    stated = [
        rows()[0] | {"geometry": stations[k], "along": along[k] + 2.0, "de": errors[k, 0], "dn": errors[k, 1], "dh": errors[k, 2]}
        for k in np.random.default_rng(0).permutation(len(along))
    ]
    apart = np.abs(chainage[:, None] - steps[None]).min(axis=1) > 10.0
    correction = FrameCorrection.from_rows(stated, "a")
    assert np.abs(correction.at(places[apart]) - bend(chainage[apart])).max() < 0.004


def test_other_epochs_and_rigid_frames_have_none() -> None:
    points = np.array([[500_010.0, 3_999_990.0, 2.0]])
    for correction in (FrameCorrection.none(), FrameCorrection.from_rows(rows(), "b"), FrameCorrection.from_rows([], "a")):
        assert (correction.at(points) == 0).all()
