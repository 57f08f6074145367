"""Paths and patterns of survey.toml on every system alike."""

from __future__ import annotations

from pathlib import Path

import pytest
from crooked_las import write_survey
from tetratrack.core.common.errors import InputError
from tetratrack.core.data.file_patterns import BrokenLink, existing_path, given_paths, matching_files
from tetratrack.core.data.survey_draft import tile_patterns
from tetratrack.core.data.survey_reader import read_survey


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in (
        "tiles [v2]/a.laz",
        "tiles [v2]/b.LAZ",
        "tiles [v2]/c.Laz",
        "tiles [v2]/note.txt",
        "north/x/d.laz",
        "odd[1].laz",
        "odd1.laz",
    ):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_bytes(b"")
    return tmp_path


@pytest.mark.parametrize(
    ("pattern", "names"),
    [
        ("tiles [v2]/*.laz", ["a.laz", "b.LAZ", "c.Laz"]),
        ("tiles [[]v2]/*.LAZ", ["a.laz", "b.LAZ", "c.Laz"]),
        ("tiles [v2]\\*.laz", ["a.laz", "b.LAZ", "c.Laz"]),
        ("odd[1].laz", ["odd[1].laz"]),
        ("odd?.laz", ["odd1.laz"]),
        ("**/*.laz", ["d.laz", "odd1.laz", "odd[1].laz", "a.laz", "b.LAZ", "c.Laz"]),
        ("n*/*/d.laz", ["d.laz"]),
        ("./tiles [v2]/../odd1.laz", ["odd1.laz"]),
        ("tiles v2/*.laz", []),
        ("tiles [v2]", []),
    ],
)
def test_what_patterns_match(folder: Path, pattern: str, names: list[str]) -> None:
    assert [path.name for path in matching_files(folder, pattern)] == names
    assert [path.name for path in matching_files(Path("nowhere"), f"{folder}/{pattern}")] == names


def test_names_that_begin_with_a_dot_are_hidden(folder: Path) -> None:
    """macOS lays ``._a.laz`` beside ``a.laz`` on disks that cannot hold what it notes of a file."""
    hidden = ("tiles [v2]/._a.laz", ".cache/e.laz")
    for name in hidden:
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(b"")
    assert [path.name for path in matching_files(folder, "tiles [v2]/*.laz")] == ["a.laz", "b.LAZ", "c.Laz"]
    assert {path.name for path in matching_files(folder, "**/*.laz")}.isdisjoint({"._a.laz", "e.laz"})
    assert not matching_files(folder, "*cache/*.laz")
    assert [path.name for path in matching_files(folder, ".c*/*.laz")] == ["e.laz"]
    assert [path.name for path in matching_files(folder, "tiles [v2]/._*.laz")] == ["._a.laz"]


def test_patterns_of_a_draft_match_its_tiles_and_no_other_file(folder: Path) -> None:
    """One year's program wrote .laz, the next year's .LAZ: the reader takes both for ``*.laz``."""
    whole = matching_files(folder, "tiles [v2]/*.laz")
    plain = folder / "tiles"
    (folder / "tiles [v2]").rename(plain)
    tiles = [plain / path.name for path in whole]
    assert tile_patterns(tiles, folder) == ["tiles/*.[lL][aA][sSzZ]"]
    (plain / "d.laz").write_bytes(b"")
    tiles = [plain / name for name in ("a.laz", "d.laz")]
    patterns = tile_patterns(tiles, folder)
    assert patterns == ["tiles/a.laz", "tiles/d.laz"]
    assert sorted(found for pattern in patterns for found in matching_files(folder, pattern)) == tiles
    (plain / "lost.laz").symlink_to(plain / "gone.laz")
    every = [plain / name for name in ("a.laz", "b.LAZ", "c.Laz", "d.laz")]
    assert tile_patterns(every, folder) == [f"tiles/{path.name}" for path in every]


def test_single_paths(folder: Path) -> None:
    assert existing_path(folder, "tiles [v2]\\a.laz").is_file()
    assert not existing_path(folder, "tiles [v2]\\z.laz").exists()


def test_links_to_nothing_are_named(folder: Path) -> None:
    (folder / "lost.laz").symlink_to(folder / "gone.laz")
    with pytest.raises(BrokenLink):
        matching_files(folder, "*.laz")
    with pytest.raises(InputError, match=r"lost.laz is a link to nothing. Mend the link"):
        read_survey(write_survey(folder, "*.laz"))


def test_brackets_and_backslashes_are_explained(folder: Path) -> None:
    with pytest.raises(InputError, match=r"no file matches none \[v2\]/\*.laz.*write \[\[\] for a bracket itself"):
        read_survey(write_survey(folder, "none [v2]/*.laz"))
    with pytest.raises(InputError, match=r"line 10.*write / instead of \\, or put the path in single quotes"):
        read_survey(write_survey(folder, "C:\\data\\*.laz"))
    # \n is a line break to TOML, and no error
    with pytest.raises(InputError, match=r"holds a control character. In double quotes a backslash"):
        read_survey(write_survey(folder, "tiles\\north.laz"))


@pytest.mark.parametrize(
    ("texts", "names"),
    [
        (["tiles [v2]"], ["tiles [v2]"]),
        (["tiles [v2]/*.laz"], ["a.laz", "b.LAZ", "c.Laz"]),
        (['"tiles [v2]/a.laz" "north/x/d.laz"'], ["a.laz", "d.laz"]),
        (["tiles [v2]/a.laz; north/**/*.LAZ"], ["a.laz", "d.laz"]),
        (["odd[1].laz", "odd[1].laz", "gone/*.laz"], ["odd[1].laz", "*.laz"]),
    ],
)
def test_what_a_user_gives(folder: Path, monkeypatch: pytest.MonkeyPatch, texts: list[str], names: list[str]) -> None:
    monkeypatch.chdir(folder)
    assert [path.name for path in given_paths(texts)] == names
