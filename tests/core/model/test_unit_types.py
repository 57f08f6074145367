"""Which legs of a unit can be told apart."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from tetratrack.core.model.unit_types import UnitType

REGULAR, PAPER = UnitType.tetrapod(2.3), UnitType.tetrapod(2.3, opening="paper")


@pytest.mark.parametrize(("unit", "number"), [(REGULAR, 1), (PAPER, 4)])
def test_every_ordered_pair_of_legs_is_turned_into_just_one_of_the_pairs_given(unit, number):
    legs = unit.leg_directions
    reached = []
    for pair in unit.leg_pairs:
        turned = legs[list(pair)] @ unit.symmetries.transpose(0, 2, 1)
        reached += [tuple(int(k) for k in np.argmax(two @ legs.T, axis=1)) for two in turned]
    assert len(unit.leg_pairs) == number
    assert sorted(reached) == sorted((i, j) for i in range(4) for j in range(4) if i != j)


def test_legs_of_a_regular_unit_are_all_alike():
    np.testing.assert_array_equal(REGULAR.numberings, [np.eye(3)])


def test_each_leg_of_the_papers_unit_takes_the_place_of_leg_1_once():
    first = PAPER.numberings @ PAPER.leg_directions.T
    nearest = np.argmax(PAPER.leg_directions @ first[:, :, 0].T, axis=0)
    assert sorted(nearest) == [0, 1, 2, 3]
    # no leg ends up farther from a leg's place than half of what the angles between the legs differ by, and some
    apart = np.degrees(np.arccos(np.clip(np.max(PAPER.leg_directions @ first, axis=1), -1, 1)))
    assert apart.max() < 18
    assert np.allclose(np.linalg.det(PAPER.numberings), 1)


@pytest.mark.parametrize("unit", [REGULAR, PAPER])
def test_a_copy_for_another_process_makes_its_own_arrays_which_loops_are_compiled_for(unit):
    used = {name: getattr(unit, name) for name in ("leg_directions", "symmetries", "numberings")}
    copy = pickle.loads(pickle.dumps(unit))  # noqa: S301
    assert copy == unit
    for name, array in used.items():
        other = getattr(copy, name)
        assert np.array_equal(other, array)
        # numba compiles a loop once more for arrays that can be written to
        assert other.flags.writeable == array.flags.writeable, name
