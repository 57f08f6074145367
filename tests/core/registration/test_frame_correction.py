"""Bent frames as a result states them, for those who go back to the cloud."""

from __future__ import annotations

import numpy as np
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
            "sd_e": 0.004, "sd_n": 0.005, "sd_h": 0.006,
        }
        for k in np.random.default_rng(0).permutation(len(along))
    ]  # fmt: skip


def test_the_error_is_found_between_the_rows_whatever_their_order() -> None:
    correction = FrameCorrection.from_rows(rows(), "a")
    along, across = np.random.default_rng(1).uniform([5, -8], [160, 8], (200, 2)).T
    points = np.column_stack([500_000 + 0.8 * along + 0.6 * across, 4_000_000 - 0.6 * along + 0.8 * across, np.full(200, 2.0)])
    assert np.abs(correction.at(points) - bend(along)).max() < 0.004
    assert np.allclose(correction.variances_at(points), np.array([0.004, 0.005, 0.006]) ** 2)


def test_other_epochs_and_rigid_frames_have_none() -> None:
    points = np.array([[500_010.0, 3_999_990.0, 2.0]])
    for correction in (FrameCorrection.none(), FrameCorrection.from_rows(rows(), "b"), FrameCorrection.from_rows([], "a")):
        assert (correction.at(points) == 0).all()
