"""The plugin's ZIP: what the plugin site would object to, and the documentation that goes with it."""

from __future__ import annotations

import importlib.util
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="module")
def packager() -> ModuleType:
    """scripts/package.py."""
    for needed in ("bandit", "detect_secrets"):
        pytest.importorskip(needed)
    if shutil.which("lrelease") is None:
        pytest.skip("lrelease is not installed")
    if not (ROOT / ".git").exists():
        pytest.skip("not a git checkout")
    spec = importlib.util.spec_from_file_location("package", ROOT / "scripts" / "package.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def package(packager: ModuleType, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The ZIP of HEAD."""
    return packager.build(tmp_path_factory.mktemp("dist") / "tetratrack.zip")


def test_the_site_would_accept_it(packager: ModuleType, package: Path) -> None:
    assert packager.objections(package) == []


def test_it_holds_what_runs_and_nothing_else(package: Path) -> None:
    names = zipfile.ZipFile(package).namelist()
    for needed in (
        "__init__.py",
        "core/styles/units.qml",
        "scripts/engine.py",
        "scripts/cli.py",
        "i18n/tetratrack_ja.qm",
        "pyproject.toml",
    ):
        assert f"tetratrack/{needed}" in names
    assert not [name for name in names if name.startswith(("tetratrack/tests/", "tetratrack/docs/", "tetratrack/benchmarks/"))]


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ({"core/bad.py": "value = eval(input())\n"}, "bandit B307"),
        ({"core/key.py": "aws_key = 'AKIA" + "IOSFODNN7EXAMPLX'\n"}, "detect-secrets"),
        ({"core/__pycache__/x.pyc": ""}, "does not belong"),
        ({"../other/file.txt": ""}, "outside"),
    ],
)
def test_the_check_finds_what_it_looks_for(
    packager: ModuleType, package: Path, tmp_path: Path, content: dict[str, str], words: str
) -> None:
    """A small package with one thing wrong: the scanners need not read everything again."""
    spoiled = tmp_path / "spoiled.zip"
    with zipfile.ZipFile(package) as whole, zipfile.ZipFile(spoiled, "w") as packed:
        for name in ("__init__.py", "metadata.txt", "LICENSE", "icon.png"):
            packed.writestr(f"tetratrack/{name}", whole.read(f"tetratrack/{name}"))
        for name, text in content.items():
            packed.writestr(name[3:] if name.startswith("../") else f"tetratrack/{name}", text)
    found = packager.objections(spoiled)
    assert len(found) == 1
    assert words in found[0]


def test_documentation_builds_without_warnings(tmp_path: Path) -> None:
    pytest.importorskip("material")
    command = [
        sys.executable,
        "-m",
        "mkdocs",
        "build",
        "--strict",
        "--quiet",
        "--config-file",
        str(ROOT / "mkdocs.yml"),
        "-d",
        str(tmp_path),
    ]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-3000:]
    assert (tmp_path / "algorithms" / "monitorsurvey" / "index.html").is_file()


def test_generated_pages_are_current() -> None:
    spec = importlib.util.spec_from_file_location("docs_pages", ROOT / "scripts" / "docs_pages.py")
    assert spec is not None
    assert spec.loader is not None
    pages = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(pages)
    assert (ROOT / "docs" / "schema.md").read_text(encoding="utf-8") == pages.schema_page(), "run scripts/docs_pages.py"
    assert (ROOT / "docs" / "changelog.md").read_text(encoding="utf-8") == pages.changelog_page(), "run scripts/docs_pages.py"
