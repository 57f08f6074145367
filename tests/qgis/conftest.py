"""QGIS tests: the provider registered once, the engine of the checkout, and a fake engine that says what a test wants."""

from __future__ import annotations

import os
import stat
import sys
import textwrap
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from qgis.core import QgsApplication, QgsProcessingContext, QgsProcessingFeedback, QgsProject
from tetratrack.algorithms.provider import TetratrackProvider
from tetratrack.algorithms.support import engine

STATUS = pytest.StashKey[int]()


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    session.config.stash[STATUS] = int(exitstatus)


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config: pytest.Config) -> None:
    # what the tests say is printed; Python then destroys windows in any order, and Qt may end in a segmentation fault in their place
    if STATUS in config.stash:
        config.get_terminal_writer().flush()
        os._exit(config.stash[STATUS])


@pytest.fixture(scope="session", autouse=True)
def provider(qgis_app: QgsApplication, qgis_processing: None) -> Iterator[TetratrackProvider]:
    """The provider, registered as the plugin does it."""
    found = TetratrackProvider()
    QgsApplication.processingRegistry().addProvider(found)
    yield found
    QgsApplication.processingRegistry().removeProvider(found)


@pytest.fixture
def tiny(repository: Path) -> Path:
    """Folder of the tiny bundled survey."""
    return repository / "tests" / "data" / "tiny"


class RecordingFeedback(QgsProcessingFeedback):
    """Feedback that keeps what it was told."""

    def __init__(self) -> None:
        super().__init__(False)
        self.infos: list[str] = []
        self.warnings: list[str] = []
        self.progress_texts: list[str] = []

    def pushInfo(self, info: str) -> None:
        self.infos.append(info)

    def pushWarning(self, warning: str) -> None:
        self.warnings.append(warning)

    def setProgressText(self, text: str) -> None:
        self.progress_texts.append(text)


@pytest.fixture
def feedback() -> RecordingFeedback:
    """Recording feedback."""
    return RecordingFeedback()


@pytest.fixture
def context() -> Iterator[QgsProcessingContext]:
    """Context with an empty project."""
    project = QgsProject.instance()
    project.clear()
    found = QgsProcessingContext()
    found.setProject(project)
    yield found
    project.clear()


@pytest.fixture
def fake_engine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str], Path]:
    """Make an engine out of a few lines of Python; ``arguments`` holds what it was called with."""

    def make(body: str) -> Path:
        script = tmp_path / "fake_engine.py"
        preamble = "import json, os, signal, sys, time\narguments = sys.argv[1:]\ndef say(**event): print(json.dumps(event), flush=True)\n"
        script.write_text(preamble + textwrap.dedent(body), encoding="utf-8")
        python = tmp_path / "fake_python"
        python.write_text(f'#!/bin/sh\nexec "{sys.executable}" "{script}" "$@"\n', encoding="utf-8")
        python.chmod(python.stat().st_mode | stat.S_IXUSR)
        monkeypatch.setenv(engine.PYTHON_VARIABLE, str(python))
        return python

    return make


@pytest.fixture
def no_engine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A machine on which no engine is found."""
    monkeypatch.setenv(engine.PYTHON_VARIABLE, str(tmp_path / "absent"))
