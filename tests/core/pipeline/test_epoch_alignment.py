"""Epochs that lie apart: how they lie is said in words, and heights of another system are named as that."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from constellations import UNIT, found, moved, pile
from numpy.typing import NDArray
from tetratrack.core.common.errors import InputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.pipeline.epoch_alignment import PlacedUnits, UnitTie, tie_by_units

SEPARATION = 41.37
"""Of ellipsoid and geoid, metres."""


def tied(shift: tuple[float, float, float], registered: bool) -> tuple[dict[str, UnitTie], list[str]]:
    """Ties of a pile whose later cloud lies shifted, and what was said of them."""
    rng = np.random.default_rng(5)
    poses = pile(rng)
    reference = PlacedUnits(label="2023", found=found(poses, rng), registered=registered)
    later = PlacedUnits(label="2024", found=found(moved(poses, np.eye(3), np.array(shift)), rng), registered=registered)
    said: list[str] = []
    ties = tie_by_units(reference, [reference, later], [UNIT], np.zeros(3), None, Path("survey.toml"), Feedback(info=said.append))
    return ties, said


def shift_of(tie: UnitTie) -> NDArray[np.float64]:
    middle = np.array([[15.0, 6.0, 2.5]])
    return np.asarray(tie.transformation.apply(middle) - middle)[0]


def test_heights_that_alone_differ_are_named_as_another_system() -> None:
    ties, said = tied((0.0, 0.0, SEPARATION), registered=False)
    np.testing.assert_allclose(shift_of(ties["2024"]), [0, 0, -SEPARATION], atol=0.05)
    assert len(said) == 1
    assert "heights alone differ, by 41.3" in said[0]
    assert "geoid separation" in said[0]


def test_a_cloud_that_lies_apart_in_plan_is_aligned_without_talk_of_heights() -> None:
    ties, said = tied((30.0, -12.0, SEPARATION), registered=False)
    np.testing.assert_allclose(shift_of(ties["2024"]), [-30, 12, -SEPARATION], atol=0.05)
    assert len(said) == 1
    assert "aligned by" in said[0]
    assert "geoid" not in said[0]


def test_control_in_another_height_system_is_refused_as_that() -> None:
    with pytest.raises(InputError, match="geoid separation"):
        tied((0.0, 0.0, SEPARATION), registered=True)
