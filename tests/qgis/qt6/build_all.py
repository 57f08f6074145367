"""Run in a process of its own under PyQt6, without QGIS: import every module of the plugin, make every algorithm, build and paint every
widget. What belongs to QGIS is stood in for by widgets and objects that take anything; Qt is the real one. Prints what it did as JSON.
"""

from __future__ import annotations

import importlib
import importlib.util
import json
import os
import sys
import traceback
import types
from pathlib import Path
from typing import Any

os.environ["QT_QPA_PLATFORM"] = "offscreen"

import PyQt6.QtCore as QtCore
import PyQt6.QtGui as QtGui
import PyQt6.QtNetwork as QtNetwork
import PyQt6.QtSvg as QtSvg
import PyQt6.QtWidgets as QtWidgets
import PyQt6.QtXml as QtXml

ROOT = Path(sys.argv[1])
RESULT = Path(sys.argv[2])
problems: list[str] = []


class Anything:
    """Stands for an object of QGIS: takes any arguments, has any attribute, which is callable and stands for anything again."""

    def __init__(self, *arguments: Any, **named: Any) -> None:
        self.arguments = arguments

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        found = Anything()
        object.__setattr__(self, name, found)
        return found

    def __call__(self, *arguments: Any, **named: Any) -> Any:
        return Anything()

    def __iter__(self) -> Any:
        return iter(())

    def __or__(self, other: Any) -> Any:
        return self

    def __bool__(self) -> bool:
        return True

    def __float__(self) -> float:
        return 1.0

    def __int__(self) -> int:
        return 3

    def __index__(self) -> int:
        return 3

    def __fspath__(self) -> str:
        return str(RESULT.parent)

    __ror__ = __or__


class Everything(type(Anything)):  # type: ignore[misc]
    """Class of classes whose attributes are anything, as of enums."""

    def __getattr__(cls, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        found = Anything()
        setattr(cls, name, found)
        return found


class Settings(Anything):
    """QgsSettings that holds what is not set."""

    def value(self, key: str, default: Any = None, type: Any = None) -> Any:
        return default


class Application(Anything):
    """QgsApplication with icons and a folder of settings."""

    @staticmethod
    def getThemeIcon(name: str) -> QtGui.QIcon:
        return QtGui.QIcon()

    @staticmethod
    def qgisSettingsDirPath() -> str:
        return str(RESULT.parent)

    @staticmethod
    def locale() -> str:
        return "en"

    @staticmethod
    def instance() -> Any:
        return types.SimpleNamespace(translation=lambda: "en")

    @staticmethod
    def taskManager() -> Any:
        return types.SimpleNamespace(activeTasks=list)

    @staticmethod
    def processingRegistry() -> Any:
        return Anything()


class UnitTypes(Anything):
    """QgsUnitTypes that knows metres."""

    @staticmethod
    def fromUnitToUnitFactor(first: Any, second: Any) -> float:
        return 1.0

    @staticmethod
    def toAbbreviatedString(unit: Any) -> str:
        return "m"


class Task(QtCore.QObject):
    """QgsTask."""

    progressChanged = QtCore.pyqtSignal(float)
    taskCompleted = QtCore.pyqtSignal()
    taskTerminated = QtCore.pyqtSignal()
    Flag = Anything()

    def __init__(self, title: str, flags: Any) -> None:
        super().__init__()

    def setProgress(self, percent: float) -> None:
        self.progressChanged.emit(percent)

    def progress(self) -> float:
        return 0.0


class FileWidget(QtWidgets.QWidget):
    """QgsFileWidget."""

    fileChanged = QtCore.pyqtSignal(str)
    StorageMode = Anything()

    def setStorageMode(self, mode: Any) -> None: ...
    def setFilter(self, names: str) -> None: ...
    def setDialogTitle(self, title: str) -> None: ...
    def setFilePath(self, path: str) -> None: ...
    def filePath(self) -> str:
        return ""


class DateTimeEdit(QtWidgets.QDateTimeEdit):
    """QgsDateTimeEdit."""

    valueChanged = QtCore.pyqtSignal(QtCore.QDateTime)

    def setAllowNull(self, allowed: bool) -> None: ...
    def isNull(self) -> bool:
        return False


class ProjectionWidget(QtWidgets.QWidget):
    """QgsProjectionSelectionWidget."""

    CrsOption = Anything()

    def setOptionVisible(self, option: Any, visible: bool) -> None: ...
    def setNotSetText(self, text: str) -> None: ...
    def setCrs(self, crs: Any) -> None: ...
    def crs(self) -> Any:
        return Anything()


class OptionsPage(QtWidgets.QWidget):
    """QgsOptionsPageWidget."""


class CheckableBox(QtWidgets.QComboBox):
    """QgsCheckableComboBox."""

    checkedItemsChanged = QtCore.pyqtSignal(list)

    def setDefaultText(self, text: str) -> None: ...
    def addItemWithCheckState(self, text: str, state: QtCore.Qt.CheckState, data: Any) -> None:
        self.addItem(text, data)

    def checkedItemsData(self) -> list[Any]:
        return []

    def deselectAllOptions(self) -> None: ...


class FilterEdit(QtWidgets.QLineEdit):
    """QgsFilterLineEdit."""

    def setShowSearchIcon(self, shown: bool) -> None: ...


class MapTool(QtCore.QObject):
    """QgsMapTool."""

    def __init__(self, canvas: Any) -> None:
        super().__init__()

    def setCursor(self, cursor: Any) -> None: ...


class Algorithm:
    """QgsProcessingAlgorithm that keeps its parameters."""

    def __init__(self) -> None:
        self.parameters: list[Any] = []

    def addParameter(self, definition: Any) -> None:
        self.parameters.append(definition)

    def addOutput(self, definition: Any) -> None: ...


KNOWN = {
    "QgsSettings": Settings,
    "QgsApplication": Application,
    "QgsTask": Task,
    "QgsUnitTypes": UnitTypes,
    "QgsFileWidget": FileWidget,
    "QgsOptionsPageWidget": OptionsPage,
    "QgsCheckableComboBox": CheckableBox,
    "QgsFilterLineEdit": FilterEdit,
    "QgsDockWidget": QtWidgets.QDockWidget,
    "QgsMapTool": MapTool,
    "QgsMapToolPan": MapTool,
    "QgsDateTimeEdit": DateTimeEdit,
    "QgsProjectionSelectionWidget": ProjectionWidget,
    "QgsProcessingAlgorithm": Algorithm,
    "QgsProcessingException": type("QgsProcessingException", (Exception,), {}),
    "QgsCsException": type("QgsCsException", (Exception,), {}),
}


class StandIn(types.ModuleType):
    """A module of QGIS: every class it is asked for."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        found = KNOWN.get(name) or Everything(name, (Anything,), {})
        setattr(self, name, found)
        return found


def install() -> None:
    """Put the stand-ins where imports find them, and this checkout under its name."""
    processing = ("processing", "processing.gui", "processing.gui.wrappers")
    for name in ("qgis", "qgis._3d", "qgis.core", "qgis.gui", "qgis.utils", "qgis.PyQt", "qgis.processing", *processing):
        module = StandIn(name)
        module.__path__ = []
        sys.modules[name] = module
    sys.modules["qgis.utils"].iface = None
    for qt in (QtCore, QtGui, QtWidgets, QtNetwork, QtSvg, QtXml):
        sys.modules[f"qgis.PyQt.{qt.__name__.rpartition('.')[2]}"] = qt
    spec = importlib.util.spec_from_file_location("tetratrack", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)])
    package = importlib.util.module_from_spec(spec)
    sys.modules["tetratrack"] = package
    spec.loader.exec_module(package)


def modules() -> list[str]:
    """Full names of all modules of the plugin."""
    paths = [path for folder in ("algorithms", "plugin") for path in sorted((ROOT / folder).rglob("*.py")) if path.stem != "__init__"]
    return [".".join(("tetratrack", *path.relative_to(ROOT).with_suffix("").parts)) for path in paths]


def paint(widget: QtWidgets.QWidget, width: int = 420, height: int = 760) -> bool:
    """Lay a widget out, show and paint it; whether anything was drawn."""
    widget.resize(width, height)
    widget.show()
    QtWidgets.QApplication.processEvents()
    image = widget.grab().toImage()
    return len({image.pixel(x, y) for x in range(0, image.width(), 3) for y in range(0, image.height(), 3)}) > 3


def build() -> dict[str, Any]:
    """Everything once; what was made."""
    for name in modules():
        importlib.import_module(name)
    from tetratrack.algorithms.base import TetratrackAlgorithm

    def below(kind: type) -> list[type]:
        return [kind, *(further for child in kind.__subclasses__() for further in below(child))]

    made = []
    for kind in below(TetratrackAlgorithm):
        if kind.ID:
            algorithm = kind()
            algorithm.initAlgorithm({})
            assert algorithm.displayName()
            assert algorithm.parameters
            made.append(kind.ID)
    from tetratrack.plugin import review_dock
    from tetratrack.plugin.environment_task import CreateEnvironment, Wish
    from tetratrack.plugin.epoch_rows import EpochRow
    from tetratrack.plugin.options import TetratrackOptionsPage

    class Map(QtCore.QObject):
        """Stands for the map side, which is QGIS alone."""

        vanished = QtCore.pyqtSignal()
        filtered = False

        def __init__(self, store: Any, canvas: Any, project: Any, parent: Any) -> None:
            super().__init__()
            self.store, self.canvas = store, canvas

        def __getattr__(self, name: str) -> Any:
            return lambda *arguments, **named: None

    review_dock.ReviewMap = Map
    CreateEnvironment(Wish(python=Path("python"), environment=RESULT.parent / "engine"))
    painted = {"options": paint(TetratrackOptionsPage())}
    dock = review_dock.ReviewDock(Anything(), Anything())
    painted["start"] = paint(dock)
    table = dock.start.epochs
    table.show_rows([EpochRow("1", "2024-04-09T02:30:00Z", ("a.laz", "b.laz"), {"control": "c.csv"}, 100, 20.0, "EPSG:32650")])
    table.table.item(0, 0).setText("before")
    table.add(("c.laz",))
    assert [row.label for row in table.rows()] == ["before", ""]
    painted["epochs"] = paint(table)
    assert dock.open(RESULT), dock.status.text()
    dock.store.step(1)
    for page in range(dock.tabs.count()):
        dock.tabs.setCurrentIndex(page)
        painted[f"tab {page}"] = paint(dock)
    painted["wide"] = paint(dock, 1100, 420)
    act(dock)
    return {"modules": len(modules()), "algorithms": made, "painted": painted}


def act(dock: Any) -> None:
    """Keys, mouse, wheel and decisions, as a reviewer does."""
    from PyQt6.QtTest import QTest

    key = QtCore.Qt.Key
    for pressed in (key.Key_Down, key.Key_A, key.Key_N, key.Key_U, key.Key_Z, key.Key_P):
        QTest.keyClick(dock.table, pressed)
    dock.tabs.setCurrentIndex(0)
    for view in (dock.tabs.plan, dock.tabs.section):
        middle = QtCore.QPointF(view.rect().center())
        QTest.mouseMove(view, middle.toPoint())
        QTest.mouseClick(view, QtCore.Qt.MouseButton.LeftButton, pos=middle.toPoint())
        wheel = QtGui.QWheelEvent(
            middle,
            view.mapToGlobal(middle),
            QtCore.QPoint(),
            QtCore.QPoint(0, 120),
            QtCore.Qt.MouseButton.NoButton,
            QtCore.Qt.KeyboardModifier.NoModifier,
            QtCore.Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QtWidgets.QApplication.sendEvent(view, wheel)
    dock.filters.threshold.setValue(2.5)
    dock.filters.undecided.setChecked(True)
    dock.tabs.along.setChecked(False)
    dock.tabs.azimuth.setValue(40)
    dock.decide("accepted")
    dock.table.horizontalHeader().sectionClicked.emit(2)
    QtWidgets.QApplication.processEvents()
    dock.grab()
    dock.close()


def main() -> None:
    """Build, and say what went wrong where Qt called."""
    sys.excepthook = lambda *caught: problems.append("".join(traceback.format_exception(*caught)))
    install()
    application = QtWidgets.QApplication([])
    try:
        made = build()
    except Exception:
        problems.append(traceback.format_exc())
        made = {}
    application.processEvents()
    print(json.dumps(made | {"problems": problems, "qt": QtCore.QT_VERSION_STR}))


if __name__ == "__main__":
    main()
