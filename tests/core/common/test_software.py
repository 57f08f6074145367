"""Blocks of another software are never taken for this one's: a change in what a job depends on, and in nothing else, makes it new."""

from __future__ import annotations

import ast
import shutil
from pathlib import Path

import pytest
from tetratrack.core.common import software
from tetratrack.core.common.software import JOB_PACKAGES, code_fingerprint
from tetratrack.core.pipeline import job_runner
from tetratrack.core.pipeline.job_runner import job_key

CORE = software.CORE
OTHERS = sorted({path.name for path in CORE.iterdir() if (path / "__init__.py").exists()} - set(JOB_PACKAGES))


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """A copy of the code that a test may change."""
    target = tmp_path / "core"
    for path in CORE.rglob("*.py"):
        place = target / path.relative_to(CORE)
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, place)
    return target


def changed(core: Path, package: str) -> bool:
    """Whether blocks are computed anew after a change in the last module of a package."""
    before = code_fingerprint(JOB_PACKAGES, core)
    module = max((core / package).rglob("*.py"))
    module.write_text(module.read_text(encoding="utf-8") + "\nCHANGED = True\n", encoding="utf-8")
    code_fingerprint.cache_clear()
    return code_fingerprint(JOB_PACKAGES, core) != before


@pytest.mark.parametrize("package", JOB_PACKAGES)
def test_a_change_in_what_a_job_depends_on_makes_its_blocks_new(copy: Path, package: str) -> None:
    assert changed(copy, package)


@pytest.mark.parametrize("package", OTHERS)
def test_a_change_elsewhere_keeps_them(copy: Path, package: str) -> None:
    assert package in {"armour", "report", "results", "review", "registration", "deformation", "simulation"}
    assert not changed(copy, package)


def test_the_key_of_a_block_holds_the_fingerprint(monkeypatch: pytest.MonkeyPatch) -> None:
    before = job_key("segment", {"x": 1}, ["tile"])
    asked = []
    monkeypatch.setattr(job_runner, "code_fingerprint", lambda packages: asked.append(packages) or "other code")
    assert job_key("segment", {"x": 1}, ["tile"]) != before
    assert asked == [JOB_PACKAGES]


def test_a_job_imports_nothing_outside_the_named_packages() -> None:
    """Through all modules that the jobs reach, in functions too."""
    waiting, seen = [CORE / "pipeline" / "block_jobs.py"], set()
    while waiting:
        path = waiting.pop()
        seen.add(path)
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.level:
                folder = path.parents[node.level - 1]
                for name in (node.module or "", *(f"{node.module}.{alias.name}" for alias in node.names)):
                    module = folder.joinpath(*name.split(".")).with_suffix(".py")
                    if module.is_file() and module not in seen:
                        waiting.append(module)
    assert len(seen) > 20
    assert {path.relative_to(CORE).parts[0] for path in seen} <= set(JOB_PACKAGES)


def test_a_package_that_is_not_there_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="holds no Python file"):
        code_fingerprint(("nowhere",), tmp_path)
