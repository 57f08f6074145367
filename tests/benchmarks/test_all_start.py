"""Every benchmark and every tool that needs no QGIS starts and explains itself: names that moved are noticed here."""

from __future__ import annotations

import importlib
import os
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
NEED_QGIS = {
    "benchmarks.performance.review",
    "scripts.dev.model",
    "scripts.dev.review_images",
    "scripts.dev.screenshots",
    "scripts.dev.styles",
}
MODULES = sorted(
    ".".join(path.relative_to(ROOT).with_suffix("").parts)
    for folder in ("benchmarks", "scripts/dev")
    for path in (ROOT / folder).rglob("*.py")
    if path.stem != "__init__"
)


@pytest.mark.parametrize("module", [name for name in MODULES if name not in NEED_QGIS])
def test_imports(module: str) -> None:
    before = {name: value for name, value in os.environ.items() if "THREADS" in name}
    assert importlib.import_module(f"tetratrack.{module}").__doc__
    # numba refuses to compile anything more where its number of threads changes after the first loop
    assert {name: value for name, value in os.environ.items() if "THREADS" in name} == before


def test_every_benchmark_is_listed() -> None:
    listed = (ROOT / "benchmarks" / "README.md").read_text(encoding="utf-8")
    files = [path.relative_to(ROOT / "benchmarks") for path in (ROOT / "benchmarks").rglob("*.py") if path.stem != "__init__"]
    assert [str(path) for path in files if f"`{path.as_posix()}`" not in listed] == []
