"""Damage figures: counts by thresholds, N_od, sections along a straight and a bent axis."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from curved_structures import line_of, units_along
from tetratrack.core.common.errors import InputError
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.report.damage import centreline_of, damage
from tetratrack.core.results.unit_legs import Leg
from tetratrack.core.results.unit_rows import UnitRow, over

H = 2.0
DN = UnitType.tetrapod(H).nominal_diameter


def unit(name: str, e: float, n: float, moved: float | None, kind: str = "stable") -> UnitRow:
    vector = None if moved is None else np.array([moved, 0.0, 0.0])
    sd = None if moved is None else np.full(3, 0.003)
    return UnitRow(
        unit_id=name, kind=kind, place=np.array([e, n, 1.0]), coverage=0.3, height=H, vector=vector, sd=sd, d_3d=moved, d_horizontal=moved
    )


def test_nominal_diameter_is_the_one_the_run_used() -> None:
    rows = [replace(row, d_over_dn=None if row.d_3d is None else row.d_3d / 1.25) for row in row_of_units()]
    assert damage(rows).nominal_diameter == pytest.approx(1.25)
    assert damage(row_of_units()).nominal_diameter == pytest.approx(DN), "standard proportions where the result does not say"


def row_of_units() -> list[UnitRow]:
    lengths = [0.0, 0.049, 0.05, 0.099, 0.10, 0.5 * DN, 0.5 * H, DN, H, 3.0]
    rows = [unit(f"U{k}", 3.0 * k, 0.0, length) for k, length in enumerate(lengths)]
    return [*rows, unit("L", 30.0, 0.0, None, "lost"), unit("N", 33.0, 0.0, None, "new"), unit("S", 36.0, 0.0, None, "unseen")]


def test_a_structure_that_turns_is_as_wide_as_it_is_long() -> None:
    """N_od of a harbour's two arms and end: counted along one of them, it would be more than twice as large."""
    places, along, _ = units_along(line_of("U"), 3)
    rows = [unit(f"U{k}", *place[:2], 3.0 if k % 10 == 0 else 0.0) for k, place in enumerate(places)]
    found = damage(rows)
    assert found.width == pytest.approx(along.max(), rel=0.05)
    assert len(found.sections) == pytest.approx(along.max() / (10 * DN), abs=2)
    assert max(section.units for section in found.sections) < 0.1 * len(rows)
    reference = centreline_of(rows).locate(places)[0]
    assert np.corrcoef(reference, along)[0, 1] > 0.999


def test_counts_by_thresholds_include_lost_units_and_the_limit_itself() -> None:
    found = damage(row_of_units())
    assert found.units == 11, "new and unseen units cannot be judged"
    assert {c.name: c.count for c in found.classes} == {"5 cm": 9, "10 cm": 7, "0.5 Dn": 6, "0.5 H": 5, "1 Dn": 4, "1 H": 3}
    assert [c.limit for c in found.classes] == sorted(c.limit for c in found.classes)
    assert found.classes[0].share == pytest.approx(9 / 11)
    assert found.n_lost == 1
    assert found.nominal_diameter == pytest.approx(DN)


def test_n_od_is_displaced_units_per_nominal_diameter_of_width() -> None:
    assert damage(row_of_units(), width=50.0).n_od == pytest.approx(4 * DN / 50)
    # by itself the width is the extent of the units and half a unit at each end
    assert damage(row_of_units()).width == pytest.approx(30.0 + H)


def test_uncertain_units_do_not_count() -> None:
    """However far they seem to have moved, whatever legs they seem to lack."""
    legs = tuple(Leg(number=k + 1, state=state) for k, state in enumerate(("broken", "whole", "whole", "unseen")))
    loose = replace(unit("X", 4.0, 0.0, 2.5, "uncertain"), legs=legs)
    assert damage([*row_of_units(), loose]) == damage(row_of_units())
    listed = [row.unit_id for row in over([*row_of_units(), loose], 0.1)]
    assert listed == [row.unit_id for row in over(row_of_units(), 0.1)]


def test_rejected_units_do_not_count() -> None:
    found = damage(row_of_units(), excluded=frozenset({"U9", "L"}))
    assert (found.units, found.n_lost) == (9, 0)
    assert {c.name: c.count for c in found.classes}["1 H"] == 1


def test_sections_hold_every_judged_unit_once() -> None:
    found = damage(row_of_units(), axis=[[0, -5], [40, -5]], section=9.0)
    assert [(s.start, s.stop, s.units) for s in found.sections] == [(0, 9, 3), (9, 18, 3), (18, 27, 3), (27, 36, 2)]
    for k, c in enumerate(found.classes):
        assert sum(s.counts[k] for s in found.sections) == c.count
    assert found.sections[-1].n_od == pytest.approx(2 * DN / 9.0)


def test_relocated_unit_counts_as_displaced_whatever_its_length() -> None:
    rows = [unit("A", 0, 0, 0.2, "relocated"), unit("B", 3, 0, 0.0)]
    assert {c.count for c in damage(rows).classes} == {1}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"axis": [[0, 0]]}, "two different corners"),
        ({"axis": [[0, 0], [0, 0]]}, "two different corners"),
        ({"width": 0.0}, "section width"),
        ({"section": -1.0}, "section length"),
    ],
)
def test_impossible_options_are_refused(arguments: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        damage(row_of_units(), **arguments)  # type: ignore[arg-type]


def test_nothing_to_judge_is_said() -> None:
    with pytest.raises(InputError, match="no unit has a displacement"):
        damage([unit("N", 0, 0, None, "new")])
