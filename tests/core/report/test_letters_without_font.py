"""Figures on a machine without fonts for Korean, Japanese or Chinese, and lists that spreadsheets open rightly."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
from matplotlib import font_manager
from tetratrack.core.common.errors import InputError
from tetratrack.core.report import fonts
from tetratrack.core.report.alarms import write_alarms
from tetratrack.core.results.export import export_layers


@pytest.fixture
def bare(monkeypatch: pytest.MonkeyPatch):
    """A machine with nothing but matplotlib's own fonts."""
    monkeypatch.setattr(font_manager, "findSystemFonts", list)
    fonts.covering.cache_clear()
    yield
    fonts.covering.cache_clear()


def test_words_stay_english_and_names_become_latin(bare: None) -> None:
    assert fonts.drawable("봄 2024") == "Bom 2024"
    assert fonts.drawable("ひ") == "Hi"
    assert fonts.drawable("春") == "U+6625"
    assert fonts.drawable("été α") == "été α"
    words = fonts.drawable_words({"units": "부재", "easting": "est"}.__getitem__)
    assert (words("units"), words("easting")) == ("units", "est")
    assert fonts.families_for(["봄"]) == [fonts.STANDARD]


@pytest.mark.parametrize(("separator", "between", "decimal"), [("comma", ",", "."), ("semicolon", ";", ","), ("tab", "\t", ".")])
def test_lists_open_in_spreadsheets(result: Path, tmp_path: Path, separator: str, between: str, decimal: str) -> None:
    write_alarms(result, tmp_path / "alarms.csv", 0.0, separator=separator)
    export_layers(result, tmp_path, ["csv"], ["displacements"], separator)
    for name, column in (("alarms.csv", "easting"), ("displacements.csv", "x")):
        data = (tmp_path / name).read_bytes()
        assert data.startswith(b"\xef\xbb\xbf")
        rows = list(csv.DictReader(data.decode("utf-8-sig").splitlines(), delimiter=between))
        assert rows
        assert "unit_id" in rows[0]
        assert decimal in rows[0][column]
        assert 6e5 < float(rows[0][column].replace(decimal, ".")) < 7e5


def test_an_unknown_separator_is_named(result: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"unknown separator 'pipe'. Choose one of comma, semicolon, tab"):
        write_alarms(result, tmp_path / "a.csv", 0.0, separator="pipe")
