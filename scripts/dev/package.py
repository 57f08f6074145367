"""Make the plugin's ZIP and the wheel, and hold both against what they are for.

``python scripts/dev/package.py [--output dist/tetratrack.zip]`` packs what git has committed (``git archive``, less what .gitattributes
marks ``export-ignore``), adds the built translations and the changelog in metadata.txt, makes the wheel of the same files beside it, and
prints what the plugin site would object to or what the wheel lacks; exit code 1 if there is anything.
"""

from __future__ import annotations

import argparse
import configparser
import json
import os
import shutil
import subprocess  # nosec B404 - git and the checkers are started with fixed arguments
import sys
import tempfile
import tomllib
import zipfile
from pathlib import Path

from tetratrack.scripts.dev import release, translations

ROOT = Path(__file__).resolve().parents[2]
PREFIX = "tetratrack"
SAMPLE = "tests/data/sample"
MOST_BYTES = 25_000_000
NEEDED_KEYS = (
    "name",
    "qgisMinimumVersion",
    "qgisMaximumVersion",
    "description",
    "about",
    "version",
    "author",
    "email",
    "repository",
    "tracker",
    "homepage",
    "icon",
    "hasProcessingProvider",
    "license",
)
NEEDED_FILES = ("__init__.py", "metadata.txt", "LICENSE")
IN_WHEEL = tuple(f"{PREFIX}/{folder}/" for folder in ("core", "algorithms", "plugin", "scripts", "i18n"))
"""Folders that the wheel has whole."""
FORBIDDEN_PARTS = ("__pycache__", ".git", "__MACOSX", ".DS_Store")
FORBIDDEN_ENDINGS = (".pyc", ".so", ".dll", ".dylib", ".exe")


def build(target: Path, revision: str = "HEAD") -> Path:
    """Write the ZIP of a revision with its translations.

    Raises
    ------
    subprocess.CalledProcessError
        git or lrelease failed.
    """
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        archive = Path(folder) / "archive.zip"
        command = ["git", "-C", str(ROOT), "archive", "--format=zip", f"--prefix={PREFIX}/", "-o", str(archive), revision]
        subprocess.run(command, check=True)  # nosec B603
        built = translations.build(Path(folder) / "qm")
        complete = Path(folder) / "complete.zip"
        with zipfile.ZipFile(archive) as committed, zipfile.ZipFile(complete, "w", zipfile.ZIP_DEFLATED) as packed:
            for entry in committed.infolist():
                own = entry.filename == f"{PREFIX}/metadata.txt"
                packed.writestr(entry, _metadata_of(revision) if own else committed.read(entry))
            for path in built:
                packed.write(path, f"{PREFIX}/i18n/{path.name}")
            for name, content in _sample(revision):
                packed.writestr(f"{PREFIX}/sample/{name}", content)
        shutil.move(str(complete), target)
    return target


def build_wheel(package: Path, folder: Path) -> Path:
    """Write the wheel of what a ZIP of the plugin holds, translations included, into a folder.

    Raises
    ------
    subprocess.CalledProcessError
        pip failed.
    """
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch, zipfile.ZipFile(package) as packed:
        packed.extractall(scratch)  # nosec B202 - made by this script a moment ago
        command = [sys.executable, "-m", "pip", "wheel", "--quiet", "--disable-pip-version-check", "--no-deps", "--no-build-isolation"]
        # setuptools warns at length of folders that hold no Python: what must be there is checked by its result
        quiet = {**os.environ, "PYTHONWARNINGS": "ignore"}
        subprocess.run([*command, "--wheel-dir", str(Path(scratch) / "wheel"), str(Path(scratch) / PREFIX)], check=True, env=quiet)  # nosec B603
        (built,) = (Path(scratch) / "wheel").glob("*.whl")
        return Path(shutil.move(str(built), folder / built.name))


def lacking(wheel: Path, package: Path) -> list[str]:
    """What an installed wheel would lack of the files its code reads: all of the ZIP's in the packages that it has, one sentence each."""
    with zipfile.ZipFile(wheel) as installed, zipfile.ZipFile(package) as plugin:
        there, wanted = set(installed.namelist()), plugin.namelist()
    return [f"{wheel.name} lacks {name}" for name in wanted if name.startswith(IN_WHEEL) and not name.endswith("/") and name not in there]


def _sample(revision: str) -> list[tuple[str, bytes]]:
    """The sample survey that the plugin offers to try, without its ground truth: name inside its folder and content."""
    git = ["git", "-C", str(ROOT)]
    command = [*git, "ls-tree", "-r", "--name-only", revision, SAMPLE]
    names = subprocess.run(command, check=True, capture_output=True, text=True, encoding="utf-8").stdout.split("\n")  # nosec B603
    wanted = [name.removeprefix(f"{SAMPLE}/") for name in names if name and not name.startswith(f"{SAMPLE}/truth/")]
    return [(n, subprocess.run([*git, "show", f"{revision}:{SAMPLE}/{n}"], check=True, capture_output=True).stdout) for n in wanted]  # nosec B603


def _metadata_of(revision: str) -> str:
    """metadata.txt of a revision with what its CHANGELOG.md says of its version."""

    def committed(name: str) -> str:
        command = ["git", "-C", str(ROOT), "show", f"{revision}:{name}"]
        return subprocess.run(command, check=True, capture_output=True, text=True, encoding="utf-8").stdout  # nosec B603

    metadata, changelog, project = committed("metadata.txt"), committed("CHANGELOG.md"), committed("pyproject.toml")
    version = str(tomllib.loads(project)["project"]["version"])
    return release.with_changelog(metadata, version, release.notes_of(changelog, version))


def objections(package: Path) -> list[str]:
    """What the plugin site would object to, one sentence each."""
    with zipfile.ZipFile(package) as packed:
        names = packed.namelist()
        found = [f"damaged member {packed.testzip()}"] if packed.testzip() else []
        if package.stat().st_size > MOST_BYTES:
            found.append(f"{package.stat().st_size} bytes; at most {MOST_BYTES} are accepted")
        found += [f"{name} is outside {PREFIX}/" for name in names if not name.startswith(f"{PREFIX}/")]
        found += [f"{name} does not belong into a plugin" for name in names if _forbidden(name)]
        found += [f"{name} is missing" for name in NEEDED_FILES if f"{PREFIX}/{name}" not in names]
        found += _metadata_objections(packed.read(f"{PREFIX}/metadata.txt").decode("utf-8"), names)
        with tempfile.TemporaryDirectory() as folder:
            packed.extractall(folder)  # nosec B202 - made by this script a moment ago
            found += _bandit(Path(folder)) + _secrets(Path(folder))
    return found


def _forbidden(name: str) -> bool:
    parts = Path(name).parts
    return any(part in FORBIDDEN_PARTS or (part.startswith(".") and len(part) > 1) for part in parts) or name.endswith(FORBIDDEN_ENDINGS)


def _metadata_objections(text: str, names: list[str]) -> list[str]:
    parser = configparser.ConfigParser(interpolation=None)
    parser.read_string(text)
    general = parser["general"]
    found = [f"metadata.txt has no {key}" for key in NEEDED_KEYS if not general.get(key)]
    if "supportsQt6" in general:
        found.append("metadata.txt states supportsQt6, which is gone: qgisMaximumVersion says it")
    if f"{PREFIX}/{general.get('icon', '')}" not in names:
        found.append("the icon named in metadata.txt is missing")
    return found


def _bandit(folder: Path) -> list[str]:
    """Findings of Bandit that no ``# nosec`` with a reason waives."""
    command = [sys.executable, "-m", "bandit", "-r", str(folder), "-f", "json", "-q"]
    report = json.loads(subprocess.run(command, capture_output=True, text=True, check=False).stdout)  # nosec B603
    return [
        f"bandit {r['test_id']} {Path(r['filename']).relative_to(folder)}:{r['line_number']}: {r['issue_text']}" for r in report["results"]
    ]


def _secrets(folder: Path) -> list[str]:
    """Findings of detect-secrets."""
    command = [sys.executable, "-m", "detect_secrets", "scan", "--all-files", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=folder)  # nosec B603
    results = json.loads(done.stdout)["results"]
    return [f"detect-secrets {entry['type']} {name}:{entry['line_number']}" for name, entries in results.items() for entry in entries]


def main() -> int:
    """Build both, check, report."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=ROOT / "dist" / "tetratrack.zip")
    arguments = parser.parse_args()
    package = build(arguments.output)
    wheel = build_wheel(package, package.parent)
    found = [*objections(package), *lacking(wheel, package)]
    for objection in found:
        print(objection)
    print(f"{package}: {package.stat().st_size / 1e6:.2f} MB; {wheel}: {wheel.stat().st_size / 1e6:.2f} MB; {len(found)} objections")
    return 1 if found else 0


if __name__ == "__main__":
    raise SystemExit(main())
