"""Version and changelog: one source, copies that follow, and a release that is refused while they do not."""

from __future__ import annotations

import configparser
import shutil
from pathlib import Path

import pytest
from tetratrack.scripts.dev import release

CHANGELOG = """# Changelog

## Unreleased

### Added

- Not yet out. More words.

## 1.2.0 - 2026-11-28

### Fixed

- 3 % of units were lost
  at tile edges. Long story.
- `track` is quicker.

## 1.1.0 - 2026-01-01

- old
"""


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    for name in ("metadata.txt", "CITATION.cff"):
        shutil.copy(release.ROOT / name, tmp_path)
    (tmp_path / "CHANGELOG.md").write_text(CHANGELOG, encoding="utf-8")
    (tmp_path / "pyproject.toml").write_text('[project]\nversion = "1.2.0"\n', encoding="utf-8")
    return tmp_path


def write(checkout: Path) -> None:
    for name, text in release.wanted(checkout).items():
        (checkout / name).write_text(text, encoding="utf-8")


def test_the_copies_of_this_checkout_are_current() -> None:
    assert release.objections() == [], "run scripts/dev/release.py write"


def test_metadata_carries_version_and_a_short_changelog_that_qgis_can_read(checkout: Path) -> None:
    assert len(release.objections(checkout)) == 2
    write(checkout)
    assert release.objections(checkout) == []
    metadata = (checkout / "metadata.txt").read_text(encoding="utf-8")
    packed = release.with_changelog(metadata, "1.2.0", release.notes_of(CHANGELOG, "1.2.0"))
    # with the interpolation that QGIS's plugin manager leaves on
    parser = configparser.ConfigParser()
    parser.read_string(packed)
    general = parser["general"]
    assert general["version"] == "1.2.0"
    assert general["changelog"].splitlines() == [
        "1.2.0",
        "Added:",
        "- Not yet out",
        "Fixed:",
        "- 3 per cent of units were lost at tile edges",
        "- track is quicker",
    ]
    assert general["icon"] == "icon.png", "what stands below is kept"
    assert "version: 1.2.0" in (checkout / "CITATION.cff").read_text(encoding="utf-8")


def test_a_tag_is_held_against_version_and_changelog(checkout: Path) -> None:
    write(checkout)
    assert release.objections(checkout, "v1.2.0") == []
    assert release.objections(checkout, "v1.3.0") == ["the tag is v1.3.0, the version of pyproject.toml 1.2.0"]
    (checkout / "CHANGELOG.md").write_text(CHANGELOG.replace("- 2026-11-28", "- unreleased"), encoding="utf-8")
    assert release.objections(checkout, "v1.2.0") == ["CHANGELOG.md has no heading '## 1.2.0 - YEAR-MONTH-DAY'"]


def test_other_headings_and_missing_versions_are_refused() -> None:
    with pytest.raises(ValueError, match="'Improved'"):
        release.notes_of(CHANGELOG.replace("### Fixed", "### Improved"), "1.2.0")
    with pytest.raises(ValueError, match=r"nothing of 9\.9\.9"):
        release.notes_of(CHANGELOG.replace("Unreleased", "2.0.0"), "9.9.9")
