"""Version and changelog of a release: one source each, from which all others follow; see docs/releasing.md.

.venv/bin/python scripts/dev/release.py write            # pyproject.toml's version into metadata.txt and CITATION.cff
.venv/bin/python scripts/dev/release.py check [--tag v]  # exit code 1 and one sentence for each that differs
.venv/bin/python scripts/dev/release.py notes            # what changed, for the page of the release
"""

from __future__ import annotations

import argparse
import re
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SECTION = re.compile(r"^## (?P<version>\S+)(?: - (?P<date>.+))?$", re.MULTILINE)
KINDS = ("Added", "Changed", "Fixed")


def version_of_project(root: Path = ROOT) -> str:
    """The version: that of pyproject.toml, and of nothing else."""
    return str(tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"])


def notes_of(changelog: str, version: str) -> str:
    """What CHANGELOG.md says of a version, Markdown; what is unreleased belongs to the version that comes.

    Raises
    ------
    ValueError
        It says nothing of that version, or a heading below it is none of Added, Changed and Fixed.
    """
    found = list(SECTION.finditer(changelog))
    parts = []
    for match, following in zip(found, [*found[1:], None]):
        if match["version"] in (version, "Unreleased"):
            parts.append(changelog[match.end() : following.start() if following else None].strip())
    text = "\n".join(part for part in parts if part)
    if not text:
        raise ValueError(f"CHANGELOG.md says nothing of {version}")
    unknown = sorted(set(re.findall(r"^### (.+)$", text, re.MULTILINE)) - set(KINDS))
    if unknown:
        raise ValueError(f"CHANGELOG.md has the heading {unknown[0]!r} under {version}; use {', '.join(KINDS)}")
    return text


def short(notes: str) -> list[str]:
    """The notes for metadata.txt: a heading or the first sentence of an entry a line; QGIS takes a per cent sign for a reference."""
    lines: list[str] = []
    for line in notes.splitlines():
        if line.startswith("### "):
            lines.append(f"{line[4:]}:")
        elif line.startswith("- "):
            lines.append(line)
        elif line.strip() and lines:
            lines[-1] += f" {line.strip()}"
    # an entry ends with its first sentence; a point between digits or letters ends none
    first = [re.split(r"(?<=[.;])\s", line, maxsplit=1)[0].rstrip(".;") if line.startswith("- ") else line for line in lines]
    return [re.sub(r"\s*%", " per cent", line).replace("`", "") for line in first]


def with_changelog(metadata: str, version: str, notes: str) -> str:
    """metadata.txt with the notes of a version, as the plugin's ZIP carries it."""
    entry = "\n    ".join([f"changelog={version}", *short(notes)])
    return re.sub(r"^(version=.*\n)", lambda match: f"{match[1]}{entry}\n", metadata, flags=re.MULTILINE)


def wanted(root: Path = ROOT) -> dict[str, str]:
    """Files that repeat the version, as they should be."""
    version = version_of_project(root)
    metadata = (root / "metadata.txt").read_text(encoding="utf-8")
    citation = (root / "CITATION.cff").read_text(encoding="utf-8")
    return {
        "metadata.txt": re.sub(r"^version=.*$", f"version={version}", metadata, flags=re.MULTILINE),
        "CITATION.cff": re.sub(r"^version: .*$", f"version: {version}", citation, flags=re.MULTILINE),
    }


def objections(root: Path = ROOT, tag: str = "") -> list[str]:
    """What keeps a release from being made, one sentence each."""
    version = version_of_project(root)
    found = [
        f"{name} is not that of version {version}: run scripts/dev/release.py write"
        for name, text in wanted(root).items()
        if (root / name).read_text(encoding="utf-8") != text
    ]
    if tag and tag != f"v{version}":
        found.append(f"the tag is {tag}, the version of pyproject.toml {version}")
    if tag and not re.search(
        rf"^## {re.escape(version)} - \d{{4}}-\d{{2}}-\d{{2}}$", (root / "CHANGELOG.md").read_text("utf-8"), re.MULTILINE
    ):
        found.append(f"CHANGELOG.md has no heading '## {version} - YEAR-MONTH-DAY'")
    return found


def main() -> int:
    """Write, check or print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("act", choices=["write", "check", "notes"])
    parser.add_argument("--tag", default="", help="tag the release is made of, for example v0.1.0")
    options = parser.parse_args()
    if options.act == "write":
        for name, text in wanted().items():
            (ROOT / name).write_text(text, encoding="utf-8")
        return 0
    if options.act == "notes":
        print(notes_of((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), version_of_project()))
        return 0
    found = objections(tag=options.tag)
    for sentence in found:
        print(sentence, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    raise SystemExit(main())
