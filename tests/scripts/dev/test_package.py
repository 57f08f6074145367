"""The plugin's ZIP and the wheel: what the plugin site would object to, what an empty environment gets, and the documentation with it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from types import ModuleType

import pytest
from synthetic_result import write_result
from tetratrack.scripts.dev import docs_pages

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="module")
def packager() -> ModuleType:
    """scripts/dev/package.py."""
    for needed in ("bandit", "detect_secrets"):
        pytest.importorskip(needed)
    if shutil.which("lrelease") is None:
        pytest.skip("lrelease is not installed")
    if not (ROOT / ".git").exists():
        pytest.skip("not a git checkout")
    from tetratrack.scripts.dev import package

    return package


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
        "core/results/styles/units.qml",
        "scripts/engine.py",
        "scripts/cli.py",
        "i18n/tetratrack_ja.qm",
        "pyproject.toml",
    ):
        assert f"tetratrack/{needed}" in names
    assert len(names) == len(set(names)), "a file stands in it twice"
    assert "changelog=" in zipfile.ZipFile(package).read("tetratrack/metadata.txt").decode("utf-8")
    assert not [name for name in names if name.startswith(("tetratrack/tests/", "tetratrack/docs/", "tetratrack/benchmarks/"))]


@pytest.fixture(scope="module")
def wheel(packager: ModuleType, package: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel of the same files."""
    pytest.importorskip("setuptools", minversion="77")
    return packager.build_wheel(package, tmp_path_factory.mktemp("wheel"))


def empty_environment(folder: Path) -> Path:
    """Interpreter of a new virtual environment with nothing but pip."""
    subprocess.run([sys.executable, "-m", "venv", str(folder)], check=True)
    return folder / "bin" / "python"


def said(folder: Path, *command: str | Path) -> str:
    """Output of a command that runs in an empty folder without what this process was given by variables."""
    folder.mkdir(exist_ok=True)
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    done = subprocess.run([*map(str, command)], cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-3000:]
    return done.stdout


def test_the_wheel_holds_every_file_that_its_code_reads(packager: ModuleType, package: Path, wheel: Path) -> None:
    assert packager.lacking(wheel, package) == []
    names = zipfile.ZipFile(wheel).namelist()
    for needed in ("i18n/tetratrack_ja.qm", "core/results/styles/units.qml", "core/report/templates/report.html"):
        assert f"tetratrack/{needed}" in names
    assert not [name for name in names if name.startswith(("tetratrack/tests/", "tetratrack/scripts/dev/"))]


def test_an_installed_wheel_gives_command_and_report(wheel: Path, tmp_path: Path) -> None:
    """Of the libraries those of this environment serve; a slow test below fetches them."""
    python = empty_environment(tmp_path / "environment")
    said(tmp_path / "away", python, "-m", "pip", "install", "--quiet", "--no-deps", "--no-index", wheel)
    # after the environment's own packages, so that this checkout is not found first
    (libraries,) = (tmp_path / "environment").glob("lib/python*/site-packages")
    paths = [path for path in sys.path if path.endswith("site-packages")]
    (libraries / "libraries.pth").write_text("\n".join(paths), encoding="utf-8")
    away = tmp_path / "away"
    where = said(away, python, "-I", "-c", "import tetratrack; print(tetratrack.__file__)")
    assert where.startswith(str(tmp_path / "environment"))
    command = tmp_path / "environment" / "bin" / "tetratrack"
    assert "Displacements of tetrapod" in said(away, command, "--help")
    result = tmp_path / "result.gpkg"
    write_result(result, 12, 2)
    said(away, command, "report", result, "--output", tmp_path / "report.html", "--language", "ja")
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "変位" in text, "translated by the installed files"


@pytest.mark.slow
@pytest.mark.network
def test_an_empty_environment_runs_the_demo(wheel: Path, tmp_path: Path) -> None:
    """As a user without a checkout: libraries of the lock and the wheel, then tiles to report."""
    python = empty_environment(tmp_path / "environment")
    locked = ["--require-hashes", "--no-deps", "--only-binary", ":all:", "-r", ROOT / "requirements-engine.txt"]
    said(tmp_path / "away", python, "-m", "pip", "install", "--quiet", *locked)
    said(tmp_path / "away", python, "-m", "pip", "install", "--quiet", "--no-deps", wheel)
    said(tmp_path / "away", tmp_path / "environment" / "bin" / "tetratrack", "demo", tmp_path / "demo", "--workers", "1")
    assert "<html" in (tmp_path / "demo" / "report.html").read_text(encoding="utf-8")


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
    assert (ROOT / "docs" / "schema.md").read_text(encoding="utf-8") == docs_pages.schema_page(), "run scripts/dev/docs_pages.py"
    assert (ROOT / "docs" / "changelog.md").read_text(encoding="utf-8") == docs_pages.changelog_page(), "run scripts/dev/docs_pages.py"
