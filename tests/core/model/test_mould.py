"""A stored mould is what was learned, gives back its cones, and takes its departures from the points."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
from tetratrack.core.adjustment.shape_effects import cell_places, prior_surface, surface_of
from tetratrack.core.adjustment.surface_estimation import mould_cells
from tetratrack.core.common.errors import InputError
from tetratrack.core.data.mould_files import read_mould
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.model.mould import Mould, onto_cones
from tetratrack.core.model.tetrapod import relate, sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.results.geopackage_writer import write_result

UNIT = UnitType.tetrapod(2.5, gradient=0.2, radius=0.68)


def mould() -> Mould:
    """Dimple of 1 cm at the root, a tip rounded by 2 cm, and three waves of 2 mm around each leg."""
    _, axial, azimuth, disc = cell_places()
    mean = np.where(
        disc == 1, -0.004, np.interp(axial, [0, 0.25, 0.35, 0.85, 0.95], [0.01, 0.01, 0, 0, -0.02]) + 0.002 * np.cos(3 * azimuth)
    )
    values = np.zeros(mould_cells().max() + 1)
    values[mould_cells()] = mean
    return replace(prior_surface(UNIT.height), mean=values[mould_cells()], units=9).as_mould("north", UNIT)


def test_a_mould_survives_its_record() -> None:
    known = mould()
    again = Mould.from_record(json.loads(json.dumps(known.as_record())), "north")
    assert again.units == 9
    assert again.side == pytest.approx(known.side, abs=1e-7)
    surface = surface_of(again, UNIT.height)
    assert surface.mean[: len(known.side) // 6] == pytest.approx(surface_of(known, UNIT.height).mean[: len(known.side) // 6], abs=1e-6)
    assert surface.variances == pytest.approx(prior_surface(UNIT.height).variances, rel=1e-3)
    assert again.shaped(UnitType.tetrapod(5.0)).radius == pytest.approx(2 * UNIT.radius)


def test_points_of_a_casting_go_onto_the_cones() -> None:
    known = mould()
    body, normals, _ = sample_surface(UNIT, 4000, np.random.default_rng(1), end_discs=False)
    cast = body + known.departures(body, UNIT)[0][:, None] * normals
    along = relate(body, UNIT).axial / UNIT.leg_length
    middle = (along > 0.1) & (along < 0.9)
    assert np.abs(relate(cast[middle], UNIT).distance).max() > 0.008
    left = np.abs(relate(onto_cones(cast, np.eye(3), np.zeros(3), UNIT, known)[middle], UNIT).distance)
    # next to a crease a point may be taken for the other leg's
    assert np.quantile(left, 0.98) < 5e-4


@pytest.mark.parametrize("change", [{"side": [0.0] * 59}, {"sds": None}, {"size_sd": float("nan")}, {"disc": 0.2}, {"own": -1}])
def test_what_is_no_mould_is_refused(change: dict[str, object]) -> None:
    with pytest.raises(ValueError, match=r"lacks|number|no mould"):
        Mould.from_record(mould().as_record() | change, "odd")


def survey_with(folder: Path, line: str) -> Path:
    (folder / "a.laz").write_bytes(b"")
    path = folder / "survey.toml"
    path.write_text(
        f'[survey]\nname = "n"\ncrs = "LOCAL"\n[unit]\ntype = "tetrapod"\nheight = 5.0\n{line}\n'
        '[[epoch]]\nlabel = "a"\ntime = 2025-01-01T00:00:00Z\ntiles = "a.laz"\n'
    )
    return path


def test_a_survey_takes_a_mould_by_its_name(tmp_path: Path) -> None:
    (tmp_path / "north.mould.json").write_text(json.dumps(mould().as_record()))
    survey = read_survey(survey_with(tmp_path, 'mould = "north"'))
    assert survey.units[0].mould is not None
    assert survey.unit.gradient == pytest.approx(0.2)
    assert survey.unit.radius == pytest.approx(2 * UNIT.radius)
    assert tmp_path / "north.mould.json" in survey.files
    held = read_survey(survey_with(tmp_path, 'mould = "north"\ngradient = 0.19'))
    assert held.unit.gradient == pytest.approx(0.19)


def test_a_mould_of_one_of_several_sizes(tmp_path: Path) -> None:
    castings = {f"tetrapod {height:g} m": mould().as_record() | {"units": units} for height, units in ((2.5, 9), (5.0, 12))}
    path = tmp_path / "r.gpkg"
    epoch = {"label": "a", "time": datetime(2025, 1, 1, tzinfo=UTC), "settings": json.dumps({"castings": castings})}
    write_result(path, "EPSG:32650", {"units": [], "feature_points": [], "displacements": [], "epochs": [epoch]})
    assert read_mould(path, UNIT).units == 9
    assert read_mould(path, UnitType.tetrapod(5.0, name="tetrapod 5 m")).units == 12
    with pytest.raises(InputError, match="holds no mould"):
        read_mould(path, UnitType.tetrapod(1.0))


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ('mould = "south"', "there is no mould south"),
        ('mould = "north"\ncalibrate = true', "calibrate"),
        ('mould = "bad.json"', "holds no mould"),
    ],
)
def test_moulds_that_cannot_be_used_are_named(tmp_path: Path, line: str, words: str) -> None:
    (tmp_path / "north.mould.json").write_text(json.dumps(mould().as_record()))
    (tmp_path / "bad.json").write_text('{"units": 3}')
    with pytest.raises(InputError, match=words) as caught:
        read_survey(survey_with(tmp_path, line))
    assert "line" in str(caught.value)
    (tmp_path / "r.gpkg").write_bytes(b"nothing")
    with pytest.raises(InputError, match="cannot be read as a result"):
        read_mould(tmp_path / "r.gpkg", UnitType.tetrapod(2.3))
