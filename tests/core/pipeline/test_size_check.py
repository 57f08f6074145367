"""A size that is not that of the units in the cloud is refused with the right one; the right one passes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tetratrack.core.common.errors import InputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.pipeline import size_check
from tetratrack.core.pipeline.epoch_plans import plan_survey
from tetratrack.core.pipeline.size_check import check_sizes, found_size
from tetratrack.core.segmentation.unit_size import FoundSize, SizeTrial

TINY = Path(__file__).resolve().parents[2] / "data" / "tiny"


def _check(tmp_path: Path, height: float, more: str = "", head: str = "") -> list[str]:
    text = f'''[survey]
name = "site"
crs = "EPSG:32650"
{head}
[unit]
type = "tetrapod"
height = {height}
{more}
[[epoch]]
label = "a"
time = 2024-04-09T02:30:00Z
tiles = "{(TINY / "tiles" / "2024-04-09").as_posix()}/*.laz"
'''
    path = tmp_path / "survey.toml"
    path.write_text(text, encoding="utf-8")
    survey = read_survey(path)
    said: list[str] = []
    check_sizes(survey, plan_survey(survey)[0].tiles, Feedback(info=said.append, warning=said.append))
    return said


def test_the_right_size_passes(tmp_path: Path) -> None:
    size, expected = _check(tmp_path, 2.3)
    assert "fits" in size
    assert "points per H²" in expected


@pytest.mark.parametrize("factor", [0.85, 1.15])
def test_a_size_off_by_a_seventh_is_refused_with_the_right_one(tmp_path: Path, factor: float) -> None:
    with pytest.raises(InputError, match=r"\[unit\], key height.*height = 2\.3"):
        _check(tmp_path, 2.3 * factor)


def test_the_check_can_be_left_out(tmp_path: Path) -> None:
    assert _check(tmp_path, 2.645, head="size_check = false") == []


def test_a_height_that_the_legs_do_not_reach(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"contradicts the legs.*2\.30"):
        _check(tmp_path, 2.645, more="radius = 0.60814\ngradient = 0.17610\nleg_length = 1.48120")


@pytest.mark.parametrize(
    ("height", "free_evidence", "expected", "sure"), [(2.3, 0.13, 2.3, False), (2.3, 0.17, 2.53, True), (2.53, 0.13, 2.3, False)]
)
def test_noise_does_not_make_units_larger(
    monkeypatch: pytest.MonkeyPatch, height: float, free_evidence: float, expected: float, sure: bool
) -> None:
    """In noise the evidence has no sharp peak and a free shape is too large: what explains most is the size, and a doubtful one."""

    def tried(_points: np.ndarray, unit: UnitType, *, windows: int = 2) -> SizeTrial:
        return SizeTrial(unit.height, 0.16 - 0.1 * abs(unit.height - 2.3), 60)

    def too_large(_points: np.ndarray, _unit: UnitType) -> FoundSize:
        trial = SizeTrial(2.53, free_evidence, 86)
        return FoundSize(UnitType.tetrapod(2.53), 0.05, True, True, trial, np.zeros((0, 3)))

    monkeypatch.setattr(size_check, "try_size", tried)
    monkeypatch.setattr(size_check, "refined", too_large)
    _, found = found_size(np.zeros((0, 3)), UnitType.tetrapod(height))
    assert found is not None
    assert found.unit.height == pytest.approx(expected)
    assert found.sure == sure
