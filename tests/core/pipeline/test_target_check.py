"""What ``inspect`` says of the targets of a long structure."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tetratrack.core.data.survey import Survey
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.data.tiles import TileInfo, inspect_tile
from tetratrack.core.pipeline.target_check import check_spacing
from tetratrack.core.registration.target_spacing import BentSurvey

TINY = Path(__file__).parents[2] / "data" / "tiny"


def stretched(length: float) -> tuple[Survey, TileInfo]:
    """The tiny sample with a tile as long as a coast."""
    survey = read_survey(TINY / "survey.toml")
    tile = inspect_tile(next((TINY / "tiles" / survey.epochs[0].label).glob("*.laz")), None)
    return survey, replace(tile, low=(0.0, 0.0, 0.0), high=(length, 20.0, 5.0))


def with_targets(survey: Survey, folder: Path, places: list[float]) -> Survey:
    control, targets = folder / "control.csv", folder / "targets.csv"
    points = [(f"T{k}{m}", x + 2 * m) for k, x in enumerate(places) for m in range(3)]
    control.write_text(
        "point_id,easting,northing,height,sd_e,sd_n,sd_h\n" + "".join(f"{n},{x},5,1,0.003,0.003,0.003\n" for n, x in points),
        encoding="utf-8",
    )
    targets.write_text("point_id,x,y,z\n" + "".join(f"{n},{x},5,1\n" for n, x in points), encoding="utf-8")
    return replace(survey, epochs=(replace(survey.epochs[0], control=control, targets=targets), *survey.epochs[1:]))


@pytest.mark.parametrize(("places", "enough"), [(np.linspace(3.0, 290.0, 10).tolist(), True), ([3.0, 73.0, 143.0, 213.0, 290.0], False)])
def test_spacing_and_limit_are_those_of_the_plan(tmp_path: Path, places: list[float], enough: bool) -> None:
    survey, tile = stretched(298.0)
    survey = with_targets(survey, tmp_path, places)
    (found,) = check_spacing(survey, survey.epochs[0], [tile])
    assert found.verdict == ("ok" if enough else "note")
    assert f"{3 * len(places)} targets at {len(places)} stations on 298 m" in found.message
    gap = float(np.diff(places).max())
    seen = BentSurvey(targets=3).detectable(gap)
    assert f"from {100 * seen:.1f} cm" in found.message
    assert "for 5 cm everywhere 9 stations are needed" in found.message


def test_a_coast_without_targets_is_told_and_a_short_one_is_not(tmp_path: Path) -> None:
    survey, tile = stretched(298.0)
    bare = replace(survey, epochs=tuple(replace(epoch, control=None, targets=None) for epoch in survey.epochs))
    (found,) = check_spacing(bare, bare.epochs[0], [tile])
    assert found.message.startswith("no targets on 298 m")
    assert check_spacing(bare, bare.epochs[0], [stretched(40.0)[1]]) == []
    assert check_spacing(replace(bare, frame="rigid"), bare.epochs[0], [tile]) == []
