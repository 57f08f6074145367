"""Every string of the interface stands in every .ts, translated, with the same placeholders."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from tetratrack.scripts.dev import translations


@pytest.mark.parametrize("language", translations.LANGUAGES)
def test_language_is_complete(language: str) -> None:
    sources = list(translations.source_strings())
    known = translations.translations(language)
    assert len(sources) > 300
    assert [source for source in sources if source not in known] == [], "run scripts/dev/translations.py and translate what is unfinished"
    assert [source for source in known if source not in sources] == [], "run scripts/dev/translations.py: strings that are gone"


@pytest.mark.parametrize("language", translations.LANGUAGES)
def test_placeholders_match(language: str) -> None:
    for source, texts in translations.translations(language).items():
        for text in texts:
            assert translations.placeholders(source) == translations.placeholders(text), source
            assert (translations.COUNT in source) == (translations.COUNT in text), source


def test_every_text_with_a_number_has_the_forms_of_its_language() -> None:
    french, japanese = translations.translations("fr"), translations.translations("ja")
    assert french["%n lost"] == ("%n perdu", "%n perdus")
    assert japanese["%n lost"] == ("消失 %n",)
    assert all(len(texts) == 1 for source, texts in french.items() if translations.COUNT not in source)


def test_a_text_that_lacks_a_form_is_unfinished(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(translations, "FOLDER", tmp_path)
    monkeypatch.setattr(translations, "source_strings", lambda: {"%n lost": "m.py", "%n new": "m.py", "plain": "m.py"})
    translations.write("fr", {"%n lost": ("un", "deux"), "plain": ("simple",)})
    assert translations.translations("fr") == {"%n lost": ("un", "deux"), "plain": ("simple",)}
    path = translations.ts_path("fr")
    path.write_text(path.read_text(encoding="utf-8").replace("<numerusform>deux</numerusform>", ""), encoding="utf-8")
    assert translations.translations("fr") == {"plain": ("simple",)}


@pytest.mark.parametrize("language", ["ja", "ko", "zh-Hans"])
def test_cjk_languages_are_not_left_in_english(language: str) -> None:
    known = translations.translations(language)
    latin = [source for source, text in known.items() if len(source) > 25 and any(form.isascii() for form in text)]
    assert len(latin) < 5, latin


def test_a_string_that_cannot_be_collected_is_refused(tmp_path: Path) -> None:
    (tmp_path / "module.py").write_text('tr(f"{count} units")')
    with pytest.raises(ValueError, match="constant"):
        list(translations.strings_of(tmp_path / "module.py"))


@pytest.mark.skipif(shutil.which("lrelease") is None, reason="lrelease is not installed")
def test_qm_files_are_built(tmp_path: Path) -> None:
    built = translations.build(tmp_path)
    assert len(built) == len(translations.LANGUAGES)
    assert all(path.stat().st_size > 10_000 for path in built)
