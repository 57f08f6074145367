"""survey.toml: what is read, and that every mistake is named with key and line."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest
from tetratrack.core.common.errors import CrsError, InputError
from tetratrack.core.data.survey import inside
from tetratrack.core.data.survey_keys import SECTIONS, template
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.model.unit_types import UnitType, told_apart

GOOD = """[survey]
name = "site"
crs = "EPSG:32650"

[unit]
type = "tetrapod"
height = 2.3

[[epoch]]
label = "b"
time = 2025-03-14T10:30:00+08:00
tiles = "later/*.laz"

[[epoch]]
label = "a"
time = 2024-03-14T02:30:00Z
tiles = ["tiles/one.laz", "tiles/*.laz"]
"""


@pytest.mark.parametrize(("given", "line"), [("watch = 0.2", "watch"), ("damaged = 0.3", "damaged"), ("watch = 0.3\nalert = 0.2", "watch")])
def test_limits_of_grades_out_of_order_are_refused(folder: Path, given: str, line: str) -> None:
    path = folder / "survey.toml"
    path.write_text(f"{GOOD}\n[displacement]\n{given}\n")
    number = 1 + path.read_text().splitlines().index(next(row for row in given.splitlines() if row.startswith(line)))
    with pytest.raises(InputError, match=rf"line {number}.*is above"):
        read_survey(path)
    path.write_text(f"{GOOD}\n[displacement]\nwatch = 0.2\nalert = 0.5\n")
    read_survey(path)


def test_a_tile_may_be_named_in_two_epochs(folder: Path) -> None:
    """As who asks what a cloud shows against itself does; what is compared then is said when the tiles are looked at."""
    path = folder / "survey.toml"
    path.write_text(GOOD.replace("later/*.laz", "tiles/*.laz"))
    later, first = sorted(read_survey(path).epochs, key=lambda epoch: epoch.label, reverse=True)
    assert set(later.tiles) == set(first.tiles)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("tiles/one.laz", "tiles/two.laz", "later/one.laz"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(b"")
    return tmp_path


def _read(folder: Path, text: str):
    path = folder / "survey.toml"
    path.write_text(text, encoding="utf-8")
    return read_survey(path)


def _line_of(text: str, part: str) -> int:
    return next(number for number, line in enumerate(text.splitlines(), start=1) if part in line)


def test_epochs_are_sorted_by_time_and_files_found_once(folder: Path) -> None:
    survey = _read(folder, GOOD)
    assert [epoch.label for epoch in survey.epochs] == ["a", "b"]
    assert survey.epochs[1].time == datetime(2025, 3, 14, 2, 30, tzinfo=UTC)
    assert [path.name for path in survey.epochs[0].tiles] == ["one.laz", "two.laz"]
    assert survey.unit.radius == pytest.approx(0.2644 * 2.3, abs=1e-3)
    assert survey.epoch("b") is survey.epochs[1]


def test_template_is_a_survey_that_needs_only_its_files(folder: Path) -> None:
    text = template().replace("tiles/2025-03-14/*.laz", "tiles/*.laz")
    assert _read(folder, text).epochs[0].label == "2025-03-14"
    for section, keys in SECTIONS.items():
        assert f"[{section}]" in text
        assert all(f"{key} = " in text for key in keys)


def test_catalogue_name_gives_the_height(folder: Path) -> None:
    survey = _read(folder, GOOD.replace('"tetrapod"\nheight = 2.3', '"tetrapod 8 t"'))
    assert survey.unit.mass() == pytest.approx(8, rel=1e-6)


def test_several_types_of_unit(folder: Path) -> None:
    text = GOOD.replace("[unit]", "[[unit]]").replace(
        "[[epoch]]", '[[unit]]\ntype = "tetrapod 20 t"\narea = [[0, 0], [10, 0], [10, 10.5]]\n\n[[epoch]]', 1
    )
    survey = _read(folder, text)
    assert len(survey.units) == 2
    assert survey.units[1].area == ((0.0, 0.0), (10.0, 0.0), (10.0, 10.5))
    assert inside(survey.units[1].area, 9, 1)
    assert not inside(survey.units[1].area, 1, 9)
    assert [unit.type.name for unit in survey.units] == ["tetrapod", "tetrapod 20 t"]


def test_types_of_one_name_are_told_apart(folder: Path) -> None:
    more = "".join(f'[[unit]]\ntype = "tetrapod"\nheight = {height}\n{rest}\n' for height, rest in ((1.5, ""), (1.5, 'opening = "paper"')))
    survey = _read(folder, GOOD.replace("[unit]", "[[unit]]").replace("[[epoch]]", more + "[[epoch]]", 1))
    assert [unit.type.name for unit in survey.units] == ["tetrapod 2.3 m", "tetrapod 1.5 m", "tetrapod 1.5 m (2)"]
    assert [unit.type.height for unit in survey.units] == [2.3, 1.5, 1.5]
    own = replace(survey.unit, name="tetrapod 1.5 m")
    names = [unit.name for unit in told_apart([UnitType.tetrapod(1.5), own, UnitType.tetrapod(1.5)])]
    assert len(set(names)) == 3
    assert names[1] == own.name


@pytest.mark.parametrize(
    ("old", "new", "place", "said"),
    [
        ("height = 2.3", "heigth = 2.3", "heigth", "unknown key heigth"),
        ("height = 2.3", 'height = "2.3"', "height =", "height must be a number, not the text '2.3'"),
        ("height = 2.3", "height = -1", "height =", "above 0"),
        ("height = 2.3", "height = nan", "height =", "above 0"),
        ("height = 2.3", "height = true", "height =", "must be a number, not true"),
        ("height = 2.3", "height = 2.3\ngradient = 0.9", "type =", "taper"),
        ("height = 2.3", 'height = 2.3\nopening = "wide"', "opening", "one of tetrahedral, paper"),
        ("height = 2.3", "height = 2.3\narea = [[0, 0], [1, 1]]", "area", "at least three corners"),
        ("height = 2.3", 'height = 2.3\ncalibrate = "yes"', "calibrate", "true or false"),
        ("height = 2.3\n", "", "[unit]", "height is missing"),
        ('"tetrapod"', '"dolos"', "type =", "unknown type of unit"),
        ('name = "site"\n', "", "[survey]", "key name is missing"),
        ("time = 2024-03-14T02:30:00Z", 'time = "2024"', 'time = "2024"', "time must be a time without quotes"),
        ("time = 2024-03-14T02:30:00Z", "time = 2024-03-14T02:30:00", "time = 2024", "no time of day or time zone"),
        ("time = 2024-03-14T02:30:00Z", "time = 2024-03-14", "time = 2024", "no time of day or time zone"),
        ("time = 2024-03-14T02:30:00Z", "time = 2025-03-14T02:30:00Z", "time = 2025-03-14T02", "belongs to two epochs"),
        ('label = "a"', 'label = "b"', 'tiles = ["', "belongs to two epochs"),
        ('label = "a"', 'label = " "', 'label = " "', "label is empty"),
        ('"later/*.laz"\n\n', '"later/*.las"\n\n', "*.las", "no file matches later/*.las"),
        ('"tiles/one.laz"', '"tiles/none.laz"', "none.laz", "there is no file tiles/none.laz"),
        ('["tiles/one.laz", "tiles/*.laz"]', "7", "tiles = 7", "a path in quotes or a list"),
        ('label = "a"', 'label = "a"\ncontrol = "c.csv"', "c.csv", "there is no file c.csv"),
        ('label = "a"', 'label = "a"\ncontrol = "tiles/one.laz"', "control", "control is given without targets"),
        ("[survey]", "[surveys]", "[surveys]", "unknown section surveys"),
        ("[survey]", "colour = 1\n[survey]", "colour", "unknown section colour"),
    ],
)
def test_mistakes_are_named_with_key_and_line(folder: Path, old: str, new: str, place: str, said: str) -> None:
    assert old in GOOD
    text = GOOD.replace(old, new, 1)
    with pytest.raises(InputError) as caught:
        _read(folder, text)
    message = str(caught.value)
    assert said in message
    assert "survey.toml" in message
    assert caught.value.remedy or "one of" in message or "number" in message or "corners" in message or "empty" in message
    if "two epochs" not in said:
        assert f"line {_line_of(text, place)}" in message


def test_typing_mistake_suggests_the_key(folder: Path) -> None:
    with pytest.raises(InputError, match="Did you mean height"):
        _read(folder, GOOD.replace("height =", "hieght ="))


@pytest.mark.parametrize(
    ("crs", "said"),
    [
        ("EPSG:4326", "is geographic"),
        ("EPSG:2264", "is in US survey foot, not metres"),
        ("EPSG:999999", "unknown CRS"),
        ("EPSG:4978", "is geocentric"),
        ("EPSG:5773", "is not a projected CRS"),
    ],
)
def test_crs_must_be_projected_in_metres(folder: Path, crs: str, said: str) -> None:
    with pytest.raises(CrsError, match=said) as caught:
        _read(folder, GOOD.replace("EPSG:32650", crs))
    assert "line 3" in str(caught.value)


def test_broken_toml_names_the_line(folder: Path) -> None:
    with pytest.raises(InputError, match="line 7") as caught:
        _read(folder, GOOD.replace("height = 2.3", "height = "))
    assert "not TOML" in str(caught.value)


def test_missing_file_and_foreign_bytes(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such file"):
        read_survey(tmp_path / "none.toml")
    (tmp_path / "x.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InputError, match="cannot be read"):
        read_survey(tmp_path / "x.toml")


@pytest.mark.parametrize("section", ["survey", "unit", "epoch"])
def test_sections_that_must_be_there(folder: Path, section: str) -> None:
    parts = GOOD.split("\n\n")
    text = "\n\n".join(part for part in parts if f"[{section}]" not in part)
    with pytest.raises(InputError, match=f"has no section .*{section}"):
        _read(folder, text)


def test_unknown_epoch_names_those_there_are(folder: Path) -> None:
    with pytest.raises(InputError, match="a, b"):
        _read(folder, GOOD).epoch("c")
