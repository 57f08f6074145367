"""Files that a path or pattern of survey.toml names, on every system alike.

Endings match whatever their case, as on Windows: half a survey must not be left out because one program wrote .LAZ. Names that exist are
taken as they stand, though they hold characters of patterns. A pattern matches names that begin with a dot, such as those of the copies
that macOS lays beside files on foreign disks, only if it begins with one. Backslashes part folders where no name holds one.
"""

from __future__ import annotations

import fnmatch
import os
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

MAGIC = re.compile(r"[*?\[]")


class BrokenLink(Exception):
    """A link among the matches leads nowhere; the argument is its path."""


def existing_path(base: Path, text: str) -> Path:
    """Path of a text relative to a folder; with backslashes as separators if that exists and the text as it stands does not."""
    path = base / text
    if "\\" in text and os.sep == "/" and not path.exists():
        other = base / text.replace("\\", "/")
        return other if other.exists() else path
    return path


def matching_files(base: Path, pattern: str) -> list[Path]:
    """Files that a pattern matches, sorted.

    Raises
    ------
    BrokenLink
        One of the matches leads nowhere.
    OSError, ValueError
        A folder cannot be searched, or the pattern is none.
    """
    if "\0" in pattern:
        raise ValueError("it holds a zero character")
    found = _search(base, pattern)
    if not found and "\\" in pattern and os.sep == "/":
        found = _search(base, pattern.replace("\\", "/"))
    return found


def given_paths(texts: Iterable[str | Path]) -> list[Path]:
    """Paths of what a user gives: a file or folder, a pattern, or a list as windows write it (``"a.laz" "b.laz"``, or parted by ``;``).

    What names nothing stays as it is, for whoever looks for it to say so.
    """
    found: dict[Path, None] = {}
    for given in texts:
        text = str(given)
        if os.path.lexists(text):
            found[Path(text)] = None
            continue
        parts = re.findall(r'"([^"]+)"', text) or text.split(";")
        for part in (part.strip() for part in parts if part.strip()):
            try:
                matches = matching_files(Path.cwd(), part) if MAGIC.search(part) and not os.path.lexists(part) else []
            except (BrokenLink, OSError, ValueError):
                matches = []
            found |= dict.fromkeys(matches or [Path(part)])
    return list(found)


def _search(base: Path, pattern: str) -> list[Path]:
    path = Path(pattern)
    folder, parts = (Path(path.anchor), path.parts[1:]) if path.is_absolute() else (base, path.parts)
    found = set()
    for match in _walk(folder, parts):
        if match.is_symlink() and not match.exists():
            raise BrokenLink(match)
        if match.is_file():
            found.add(match)
    return sorted(found)


def _walk(folder: Path, parts: tuple[str, ...]) -> Iterator[Path]:
    """What the remaining parts of a pattern match below a folder."""
    if not parts:
        yield folder
        return
    part, rest = parts[0], parts[1:]
    literal = folder / part
    if part == "**":
        yield from _walk(folder, rest)
        for child in _entries(folder):
            if child.is_dir() and not child.is_symlink() and not child.name.startswith("."):
                yield from _walk(child, parts)
    elif not MAGIC.search(part) or os.path.lexists(literal):
        if os.path.lexists(literal):
            yield from _walk(literal, rest)
    else:
        # folders differ by case on some systems; files of point clouds by that of their ending alone
        matches = re.compile(fnmatch.translate(part), 0 if rest else re.IGNORECASE).match
        shows_hidden = part.startswith(".")
        for child in _entries(folder):
            if matches(child.name) and (shows_hidden or not child.name.startswith(".")) and (not rest or child.is_dir()):
                yield from _walk(child, rest)


def _entries(folder: Path) -> list[Path]:
    return sorted(folder.iterdir()) if folder.is_dir() else []
