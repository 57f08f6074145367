"""Write the locks with checksums, and the list of licences: ``python -m tetratrack.scripts.dev.lock``.

``requirements-lock.txt`` holds all that developers use, for Linux on x86-64; ``requirements-engine.txt`` what the engine needs, for every
platform and Python in :data:`TARGETS`: from it the plugin makes the engine's environment. Versions are those that stand in the former; a
new one is added there as ``name==version`` and gets its checksums here. The registry is asked through pip, for files that need no compiler.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path

from packaging.requirements import Requirement

ROOT = Path(__file__).resolve().parents[2]
LOCK = ROOT / "requirements-lock.txt"
ENGINE_LOCK = ROOT / "requirements-engine.txt"
LICENCES = ROOT / "docs" / "licences.md"
EXTRAS = ("pdf", "model", "e57")
"""Optional libraries that the engine's environment has: reports as PDF, models as DXF, scans as E57."""
PYTHONS = ("3.11", "3.12", "3.13")
GLIBC = (35, 41)
"""Minor versions of the C library (2.35 of Ubuntu 22.04, 2.41 of Debian 13): a newer one may be offered another file."""
MACOS = (14, 26)
"""Versions of macOS, the oldest with wheels of all libraries first."""
PIN = re.compile(r"(?P<name>[A-Za-z0-9_.-]+)==(?P<version>[^\s;]+)(?: ; (?P<marker>[^-]+?))?(?P<hashes>( --hash=sha256:[0-9a-f]{64})*)")
HEAD = (
    "# Exact versions of all libraries, those of developers included (Linux on x86-64, Python 3.11 to 3.13), with the checksums of their "
    "files; made by: python -m tetratrack.scripts.dev.lock"
)
ENGINE_HEAD = """\
# Exact versions of the engine's libraries with the checksums of their files, none of which needs a compiler: Windows and Linux on x86-64,
# macOS 14 and later on Apple silicon, Python 3.11 to 3.13. Complete: pip install --require-hashes --no-deps
# Made by: python -m tetratrack.scripts.dev.lock"""
PAGE = """# Licences

Tetratrack is under the GNU General Public Licence, version 2 or later. It installs the following libraries, each under its own licence as
its package states it; none is part of tetratrack's own files. Made by `scripts/dev/lock.py` from the engine's environment.

| library | version | licence |
| --- | --- | --- |
"""


@dataclass(frozen=True)
class Target:
    """A platform and Python for which files are locked: pip's names of what it can install, and what markers are held against."""

    system: str
    python: str
    tags: tuple[str, ...]

    def markers(self) -> dict[str, str]:
        """Values of the variables in markers."""
        platform, os_name, machine = {
            "linux": ("Linux", "posix", "x86_64"),
            "win32": ("Windows", "nt", "AMD64"),
            "darwin": ("Darwin", "posix", "arm64"),
        }[self.system]
        return {
            "sys_platform": self.system,
            "platform_system": platform,
            "os_name": os_name,
            "platform_machine": machine,
            "python_version": self.python,
            "python_full_version": f"{self.python}.0",
            "implementation_name": "cpython",
            "platform_python_implementation": "CPython",
        }

    def options(self) -> list[str]:
        """Options of pip that choose this target's files."""
        return [f"--platform={tag}" for tag in self.tags] + [f"--python-version={self.python}", "--only-binary=:all:"]


def linux_tags(minor: int) -> tuple[str, ...]:
    """Tags of wheels that a Linux with this minor version of glibc takes, newest first."""
    return (*(f"manylinux_2_{m}_x86_64" for m in range(minor, 16, -1)), "manylinux2014_x86_64", "linux_x86_64")


LINUX = tuple(Target("linux", python, linux_tags(minor)) for python in PYTHONS for minor in GLIBC)
TARGETS = (
    *LINUX,
    *(Target("win32", python, ("win_amd64",)) for python in PYTHONS),
    *(Target("darwin", python, (f"macosx_{version}_0_arm64",)) for python in PYTHONS for version in MACOS),
)


def pins(text: str) -> dict[str, tuple[str, str]]:
    """Version and checksums (as pip's options) by name, of the lines of a lock file.

    Raises
    ------
    ValueError
        A line is neither a comment nor a pin.
    """
    found = {}
    for line in text.splitlines():
        if line.strip() and not line.startswith("#"):
            pin = PIN.fullmatch(line.strip())
            if pin is None:
                raise ValueError(f"not a pinned version: {line}")
            found[pin["name"]] = (pin["version"], pin["hashes"].strip())
    return found


def normal(name: str) -> str:
    """A package's name as registries compare it."""
    return re.sub(r"[-_.]+", "-", name).lower()


def needed(target: Target) -> set[str]:
    """Normal names of all libraries the engine needs on a target, by what the installed packages state.

    Raises
    ------
    ValueError
        One is not installed here: it has no pin yet.
    """
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    optional = project["optional-dependencies"]
    waiting = [Requirement(text) for text in [*project["dependencies"], *(line for extra in EXTRAS for line in optional[extra])]]
    seen: set[tuple[str, tuple[str, ...]]] = set()
    while waiting:
        wanted = waiting.pop()
        extras = ("", *sorted(wanted.extras))
        if (normal(wanted.name), extras) in seen:
            continue
        seen.add((normal(wanted.name), extras))
        try:
            stated = metadata.requires(wanted.name) or []
        except metadata.PackageNotFoundError as error:
            raise ValueError(f"{wanted.name} is needed on {target.system} and not installed here: install and pin it") from error
        for line in map(Requirement, stated):
            if line.marker is None or any(line.marker.evaluate({**target.markers(), "extra": extra}) for extra in extras):
                waiting.append(line)
    return {name for name, _ in seen}


def checksums(wanted: dict[str, str], target: Target) -> dict[str, str]:
    """SHA-256 by normal name of the files that pip would install on a target, of versions by name."""
    with tempfile.TemporaryDirectory() as folder:
        plain, report = Path(folder) / "plain.txt", Path(folder) / "report.json"
        plain.write_text("".join(f"{name}=={version}\n" for name, version in wanted.items()), encoding="utf-8")
        command = [sys.executable, "-m", "pip", "install", "--dry-run", "--ignore-installed", "--no-deps", "--quiet", "--target", folder]
        subprocess.run([*command, *target.options(), "--report", str(report), "-r", str(plain)], check=True)
        installs = json.loads(report.read_text(encoding="utf-8"))["install"]
    return {normal(item["metadata"]["name"]): item["download_info"]["archive_info"]["hashes"]["sha256"] for item in installs}


def marker_of(users: Iterable[Target], targets: Iterable[Target]) -> str:
    """What pip shall ask before it installs a library that only some targets need; empty where all do."""
    systems, everywhere = {target.system for target in users}, {target.system for target in targets}
    if systems == everywhere:
        return ""
    if len(systems) == 1:
        return f' ; sys_platform == "{min(systems)}"'
    return "".join(f' ; sys_platform != "{system}"' for system in sorted(everywhere - systems))


def lines_of(versions: dict[str, str], files: dict[Target, dict[str, str]], wanted: dict[Target, set[str]]) -> list[str]:
    """Lines of a lock: every library wanted by a target, with the checksums of its files for those that want it."""
    found = []
    for name, version in sorted(versions.items(), key=lambda item: normal(item[0])):
        users = [target for target in files if normal(name) in wanted[target]]
        checksums_of = sorted({files[target][normal(name)] for target in users})
        if users:
            found.append(f"{name}=={version}{marker_of(users, files)}" + "".join(f" --hash=sha256:{h}" for h in checksums_of))
    return found


def missing(names: set[str], versions: dict[str, str]) -> set[str]:
    """Those of some normal names that have no pin."""
    return names - {normal(name) for name in versions}


def licence(name: str) -> str:
    """Licence of an installed package in a few words."""
    about = metadata.metadata(name)
    expressions = about.get_all("License-Expression", [])
    classes = [line.rsplit(" :: ", 1)[1] for line in about.get_all("Classifier", []) if line.startswith("License :: ")]
    stated = ", ".join(expressions or classes or about.get_all("License", [])) or "not stated"
    return " ".join(stated.split())[:80]


def page(wanted: dict[str, str]) -> str:
    """Page of all licences."""
    rows = []
    for name, version in sorted(wanted.items(), key=lambda item: normal(item[0])):
        try:
            rows.append(f"| {name} | {version} | {licence(name)} |")
        except metadata.PackageNotFoundError:
            rows.append(f"| {name} | {version} | not installed here |")
    return PAGE + "\n".join(rows) + "\n"


def main() -> None:
    """Write all three files."""
    versions = {name: version for name, (version, _) in pins(LOCK.read_text(encoding="utf-8")).items()}
    everything = {normal(name) for name in versions}
    engine = {target: needed(target) for target in TARGETS}
    unpinned = missing(set().union(*engine.values()), versions)
    if unpinned:
        raise SystemExit(f"add to {LOCK.name} as name==version: {', '.join(sorted(unpinned))}")

    def ask(target: Target) -> dict[str, str]:
        asked = {name: version for name, version in versions.items() if target in LINUX or normal(name) in engine[target]}
        found = checksums(asked, target)
        print(f"{target.system}, Python {target.python}, {target.tags[0]}: {len(found)} libraries", flush=True)
        return found

    # pip spends its time waiting for the registry
    with ThreadPoolExecutor(5) as pool:
        files = dict(zip(TARGETS, pool.map(ask, TARGETS), strict=True))
    developers = lines_of(versions, {target: files[target] for target in LINUX}, dict.fromkeys(LINUX, everything))
    LOCK.write_text("\n".join([HEAD, *developers]) + "\n", encoding="utf-8")
    ENGINE_LOCK.write_text("\n".join([ENGINE_HEAD, *lines_of(versions, files, engine)]) + "\n", encoding="utf-8")
    LICENCES.write_text(page(versions), encoding="utf-8")


if __name__ == "__main__":
    main()
