"""Every string of the interface stands in every .ts, translated, with the same placeholders."""

from __future__ import annotations

import importlib.util
import shutil
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[1]


def script(name: str) -> ModuleType:
    """A module of scripts/ that is not part of the package's interface."""
    spec = importlib.util.spec_from_file_location(name, ROOT / "scripts" / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


TRANSLATIONS = script("translations")


@pytest.mark.parametrize("language", TRANSLATIONS.LANGUAGES)
def test_language_is_complete(language: str) -> None:
    sources = list(TRANSLATIONS.source_strings())
    known = TRANSLATIONS.translations(language)
    assert len(sources) > 300
    assert [source for source in sources if source not in known] == [], "run scripts/translations.py and translate what is unfinished"
    assert [source for source in known if source not in sources] == [], "run scripts/translations.py: strings that are gone"


@pytest.mark.parametrize("language", TRANSLATIONS.LANGUAGES)
def test_placeholders_match(language: str) -> None:
    for source, text in TRANSLATIONS.translations(language).items():
        assert TRANSLATIONS.placeholders(source) == TRANSLATIONS.placeholders(text), source


@pytest.mark.parametrize("language", ["ja", "ko", "zh-Hans"])
def test_cjk_languages_are_not_left_in_english(language: str) -> None:
    known = TRANSLATIONS.translations(language)
    latin = [source for source, text in known.items() if len(source) > 25 and text.isascii()]
    assert len(latin) < 5, latin


def test_a_string_that_cannot_be_collected_is_refused(tmp_path: Path) -> None:
    (tmp_path / "module.py").write_text('tr(f"{count} units")')
    with pytest.raises(ValueError, match="constant"):
        list(TRANSLATIONS.strings_of(tmp_path / "module.py"))


@pytest.mark.skipif(shutil.which("lrelease") is None, reason="lrelease is not installed")
def test_qm_files_are_built(tmp_path: Path) -> None:
    built = TRANSLATIONS.build(tmp_path)
    assert len(built) == len(TRANSLATIONS.LANGUAGES)
    assert all(path.stat().st_size > 10_000 for path in built)
