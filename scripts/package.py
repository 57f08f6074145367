"""Make the plugin's ZIP and hold it against the rules of the QGIS plugin site.

``python scripts/package.py [--output dist/tetratrack.zip]`` packs what git has committed (``git archive``, less what .gitattributes
marks ``export-ignore``), adds the built translations, and prints what the site would object to; exit code 1 if there is anything.
"""

from __future__ import annotations

import argparse
import configparser
import json
import shutil
import subprocess  # nosec B404 - git and the checkers are started with fixed arguments
import sys
import tempfile
import zipfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import translations

ROOT = Path(__file__).resolve().parents[1]
PREFIX = "tetratrack"
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
        with zipfile.ZipFile(archive, "a", zipfile.ZIP_DEFLATED) as packed:
            for path in built:
                packed.write(path, f"{PREFIX}/i18n/{path.name}")
        shutil.move(str(archive), target)
    return target


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
    """Build, check, report."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=ROOT / "dist" / "tetratrack.zip")
    arguments = parser.parse_args()
    package = build(arguments.output)
    found = objections(package)
    for objection in found:
        print(objection)  # noqa: T201
    print(f"{package}: {package.stat().st_size / 1e6:.2f} MB, {len(found)} objections")  # noqa: T201
    return 1 if found else 0


if __name__ == "__main__":
    raise SystemExit(main())
