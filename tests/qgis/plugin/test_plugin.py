"""The plugin as QGIS loads it: registers everything, takes it back, starts quickly without an engine; pages of its help are current."""

from __future__ import annotations

import sys
import time
from pathlib import Path

import pytest
from qgis.core import QgsApplication, QgsSettings
from qgis.gui import QgisInterface
from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtGui import QDesktopServices
from qgis.PyQt.QtWidgets import QApplication, QPushButton, QToolBar
from tetratrack.algorithms.provider import TetratrackProvider
from tetratrack.algorithms.support import engine
from tetratrack.algorithms.support.translation import language_of
from tetratrack.plugin import options
from tetratrack.plugin.options import TetratrackOptionsPage
from tetratrack.plugin.tetratrack_plugin import TetratrackPlugin
from tetratrack.scripts.dev import docs_pages


class Interface:
    """What the plugin needs of QGIS's interface."""

    def __init__(self, real: QgisInterface) -> None:
        self.real = real
        self.factories: list[object] = []
        self.menu: list[object] = []
        self.docks: list[object] = []
        self.pages: list[str] = []

    def mainWindow(self) -> object:
        return self.real.mainWindow()

    def mapCanvas(self) -> object:
        return self.real.mapCanvas()

    def messageBar(self) -> object:
        return self.real.messageBar()

    def addToolBar(self, title: str) -> QToolBar:
        return QToolBar(title)

    def registerOptionsWidgetFactory(self, factory: object) -> None:
        self.factories.append(factory)

    def unregisterOptionsWidgetFactory(self, factory: object) -> None:
        self.factories.remove(factory)

    def addPluginToMenu(self, menu: str, action: object) -> None:
        self.menu.append(action)

    def removePluginMenu(self, menu: str, action: object) -> None:
        self.menu.remove(action)

    def addDockWidget(self, area: object, dock: object) -> None:
        self.docks.append(dock)

    def showOptionsDialog(self, parent: object, page: str) -> None:
        self.pages.append(page)

    def removeDockWidget(self, dock: object) -> None:
        self.docks.remove(dock)


def test_starts_quickly_without_an_engine_and_leaves_nothing(
    qgis_iface: QgisInterface, no_engine: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    # the provider of the other tests carries the id already
    monkeypatch.setattr(TetratrackProvider, "id", lambda self: "tetratrack_again")
    registry = QgsApplication.processingRegistry()
    before = len(registry.providers())
    interface = Interface(qgis_iface)
    # of the processor: what else the machine does is not the plugin's
    started = time.process_time()
    plugin = TetratrackPlugin(interface)
    plugin.initGui()
    assert time.process_time() - started < 0.1
    assert len(interface.menu) == 4
    assert len(interface.factories) == 1
    QApplication.processEvents()
    assert "engine is needed" in interface.messageBar().currentItem().text()
    interface.messageBar().currentItem().findChild(QPushButton, "tetratrack_engine").click()
    QDesktopServices.openUrl(QUrl("tetratrack:options"))
    assert interface.pages == [options.PAGE_NAME] * 2
    assert len(registry.providers()) == before + 1
    plugin.unload()
    assert interface.menu == []
    assert interface.factories == []
    assert len(registry.providers()) == before


def test_options_say_what_to_do_and_keep_the_choice(qgis_iface: QgisInterface, no_engine: None, monkeypatch: pytest.MonkeyPatch) -> None:
    page = TetratrackOptionsPage()
    assert "not installed" in page.state.text()
    monkeypatch.setattr(options, "NEEDED_MODULES", ("json",))
    page.chooser.setFilePath(sys.executable)
    assert "Can be used" in page.state.text()
    page.apply()
    assert QgsSettings().value(engine.PYTHON_SETTING) == sys.executable
    QgsSettings().remove(engine.PYTHON_SETTING)


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        ("absent", "no file"),
        ("folder", "no file"),
        ("program", "no Python interpreter"),
        ("bare", "lacks the engine's libraries: a_module"),
    ],
)
def test_an_interpreter_that_cannot_run_the_engine_is_not_kept(
    qgis_iface: QgisInterface, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str, words: str
) -> None:
    monkeypatch.setattr(options, "NEEDED_MODULES", ("json", "a_module_nobody_has"))
    chosen = {"absent": tmp_path / "python", "folder": tmp_path, "program": Path("/bin/ls"), "bare": Path(sys.executable)}[kind]
    page = TetratrackOptionsPage()
    page.chooser.setFilePath(str(chosen))
    assert words in page.state.text()
    assert not page.isValid()
    page.apply()
    assert not QgsSettings().value(engine.PYTHON_SETTING, "", type=str)


def test_engine_is_looked_for_in_order(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(engine.PYTHON_VARIABLE, raising=False)
    monkeypatch.setattr(engine, "managed_environment", lambda: tmp_path / "managed")
    monkeypatch.setattr(engine, "PLUGIN_FOLDER", tmp_path / "plugin")
    monkeypatch.setattr(engine, "NEEDED_MODULES", ("a_module_nobody_has",))
    assert engine.find_engine() is None
    monkeypatch.setattr(engine, "NEEDED_MODULES", ("json",))
    assert engine.find_engine().origin == "current"
    python = engine.environment_python(tmp_path / "plugin" / ".venv")
    python.parent.mkdir(parents=True)
    python.write_text("")
    assert engine.find_engine() == engine.Engine(python, "checkout")
    (tmp_path / "managed").mkdir()
    assert engine.find_engine().origin == "managed"
    chosen = tmp_path / "chosen"
    chosen.write_text("")
    monkeypatch.setenv(engine.PYTHON_VARIABLE, str(chosen))
    assert engine.find_engine() == engine.Engine(chosen, "setting")


@pytest.mark.parametrize(
    ("locale", "language"),
    [
        ("ja", "ja"),
        ("ja_JP", "ja"),
        ("zh-Hans", "zh-Hans"),
        ("zh_CN", "zh-Hans"),
        ("zh-Hant", None),
        ("pt_BR", "pt"),
        ("de", None),
        ("C", None),
    ],
)
def test_language_of_a_locale(locale: str, language: str | None) -> None:
    assert language_of(locale) == language


def test_catalogue_offered_is_the_engines() -> None:
    unit_types = pytest.importorskip("tetratrack.core.model.unit_types", reason="this Python has no SciPy")
    from tetratrack.algorithms.support.inputs import UNIT_HINTS

    assert list(UNIT_HINTS) == list(unit_types.catalogue())


def test_pages_of_the_algorithms_are_current(repository: Path) -> None:
    for name, text in docs_pages.algorithm_pages().items():
        assert (repository / "docs" / "algorithms" / name).read_text(encoding="utf-8") == text, f"{name}: run scripts/dev/docs_pages.py"
