"""docs/tutorial.md, followed to the letter: every step clicks what the text says and keeps the picture that the text shows."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from qgis.core import QgsPointXY, QgsProject, QgsVectorLayer
from qgis.gui import QgsProcessingAlgorithmDialogBase
from qgis.PyQt.QtCore import QModelIndex, QPoint, Qt, QTimer
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import (
    QAbstractButton,
    QAction,
    QApplication,
    QDialogButtonBox,
    QDockWidget,
    QFileDialog,
    QLabel,
    QLineEdit,
    QListView,
    QMainWindow,
    QToolButton,
    QTreeView,
    QWidget,
)
from qgis.utils import iface
from steps import FOLDER, action, click, guarded, picture, plugin, run, until, wait, window_of

SAMPLE = Path(os.environ["TETRATRACK_SAMPLE"])


def script() -> dict[str, Any]:
    """All steps, in the order of the text."""
    window = iface.mainWindow()
    window.resize(1500, 900)
    window.findChild(QDockWidget, "Browser").hide()
    answer: dict[str, Any] = {}
    answer["found"] = find_algorithms(window, lambda: answer.update(tiles=look_at_the_tiles()))
    answer |= run_everything(window)
    answer |= decide(window)
    return answer


def find_algorithms(window: QWidget, then: Callable[[], None]) -> list[str]:
    """1. Processing > Toolbox, type tetratrack; then open Inspect tiles and do something in its window."""
    toolbox = window.findChild(QDockWidget, "ProcessingToolbox")
    toolbox.show()
    toolbox.setMinimumWidth(330)
    toolbox.searchBox.setText("")
    QTest.keyClicks(toolbox.searchBox, "tetratrack")
    wait(1500)
    picture(toolbox, "toolbox")
    view = toolbox.findChild(QTreeView, "algorithmTree") or toolbox.algorithmTree
    names = texts_of(view.model(), QModelIndex())
    if "Inspect tiles" not in names:
        raise LookupError(f"the toolbox shows {names}")
    # the window waits for its user inside the double click
    QTimer.singleShot(1000, guarded(then))
    open_algorithm(toolbox, view, "Inspect tiles")
    return names


def texts_of(model: Any, parent: QModelIndex) -> list[str]:
    """Texts of a tree, leaves and branches."""
    found = []
    for row in range(model.rowCount(parent)):
        index = model.index(row, 0, parent)
        found += [str(index.data()), *texts_of(model, index)]
    return found


def index_of(model: Any, parent: QModelIndex, text: str) -> QModelIndex | None:
    """Place of a text in a tree."""
    for row in range(model.rowCount(parent)):
        index = model.index(row, 0, parent)
        found = index if str(index.data()) == text else index_of(model, index, text)
        if found is not None:
            return found
    return None


def open_algorithm(toolbox: QDockWidget, view: QTreeView, name: str) -> None:
    """Double click on an algorithm."""
    view.expandAll()
    index = index_of(view.model(), QModelIndex(), name)
    view.scrollTo(index)
    place = view.visualRect(index).center()
    double_click(view, place)


def double_click(view: QTreeView, place: QPoint) -> None:
    """As a hand does it: the first click selects."""
    QTest.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place)
    QTest.mouseDClick(view.viewport(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place)


def look_at_the_tiles() -> dict[str, Any]:
    """2. Inspect tiles: the button beside the tiles, Add Directory, OK, Run."""
    dialog = until(lambda: window_of(QgsProcessingAlgorithmDialogBase), 20, "the window of Inspect tiles")
    button = next(b for b in dialog.findChildren(QToolButton) if b.isVisible() and b.text() == "…")
    click(button)
    until(lambda: visible_button(dialog, "Add Directory"), 10, "the list of tiles")
    choose_in_file_dialog(SAMPLE / "tiles" / "2024-04-09")
    click(visible_button(dialog, "Add Directory"))
    wait(500)
    picture(dialog, "inspecttiles")
    listed = next(view for view in dialog.findChildren(QListView) if view.isVisible()).model()
    tiles = [Path(str(listed.index(row, 0).data())).name for row in range(listed.rowCount())]
    click(visible_button(dialog, "OK"))
    before = set(QgsProject.instance().mapLayers())
    click(dialog.runButton())
    added = until(lambda: set(QgsProject.instance().mapLayers()) - before, 120, "the tile index")
    layer = QgsProject.instance().mapLayer(next(iter(added)))
    rows = [{"points": f["points"], "crs": f["crs"], "measured": f["measured"]} for f in layer.getFeatures()]
    dialog.close()
    shown = {"coloured": layer.renderer().type(), "by": layer.renderer().classAttribute(), "labels": layer.labelsEnabled()}
    iface.mapCanvas().setExtent(layer.extent())
    wait(2000)
    iface.messageBar().clearWidgets()
    picture(iface.mainWindow(), "tiles")
    QgsProject.instance().removeMapLayer(layer.id())
    return {"chosen": tiles, "rows": rows, **shown}


def visible_button(window: QWidget, text: str) -> QAbstractButton | None:
    """Button that a user sees, by the start of its text."""
    return next((b for b in window.findChildren(QAbstractButton) if b.isVisible() and b.text().replace("&", "").startswith(text)), None)


def run_everything(window: QWidget) -> dict[str, Any]:
    """3. and 4. Monitor a survey, and the map that comes."""
    action("Monitor a survey…").trigger()
    dialog = until(lambda: window_of(QgsProcessingAlgorithmDialogBase, "Monitor"), 20, "the window of Monitor a survey")
    dialog.resize(1100, 800)
    for parameter, file in (("SURVEY", SAMPLE / "survey.toml"), ("OUTPUT", FOLDER / "result.gpkg")):
        type_into(dialog.mainWidget().wrappers[parameter].wrappedWidget().findChild(QLineEdit), str(file))
    wait(500)
    picture(dialog, "monitorsurvey")
    click(dialog.runButton())
    until(lambda: QgsProject.instance().mapLayersByName("Outlines of the units"), 1800, "the result")
    until(lambda: dialog.runButton().isEnabled() or not dialog.isVisible(), 60, "the end of the run")
    dialog.close()
    toolbox = window.findChild(QDockWidget, "ProcessingToolbox")
    toolbox.hide()
    (outlines,) = QgsProject.instance().mapLayersByName("Outlines of the units")
    canvas = iface.mapCanvas()
    extent = outlines.extent()
    extent.scale(1.3)
    canvas.setExtent(extent)
    canvas.refresh()
    wait(4000)
    iface.messageBar().clearWidgets()
    picture(window, "map")
    span = QgsProject.instance().timeSettings().temporalRange()
    layers = {layer.name(): layer for layer in QgsProject.instance().mapLayers().values()}
    root = QgsProject.instance().layerTreeRoot()
    return {
        "layers": {name: root.findLayer(layer.id()).isVisible() for name, layer in layers.items()},
        "timed": sorted(name for name, layer in layers.items() if layer.temporalProperties().isActive()),
        "span": [moment.toString("yyyy-MM-dd") for moment in (span.begin(), span.end())],
    }


def type_into(line: QLineEdit, text: str) -> None:
    """Replace the text of a field as a hand does it."""
    line.selectAll()
    QTest.keyClicks(line, text)
    QTest.keyClick(line, Qt.Key.Key_Tab)


def decide(window: QWidget) -> dict[str, Any]:
    """5. Displacement review: open the result, look, accept, and write the report."""
    action("Displacement review").trigger()
    dock = until(lambda: plugin().review_dock, 10, "the dock")
    opened = next(b for b in dock.findChildren(QToolButton) if b.text() == "Open result…")
    choose_in_file_dialog(FOLDER / "result.gpkg")
    click(opened)
    until(lambda: dock.store, 20, "the open result")
    type_into(dock.decisions.reviewer, "Anna")
    dock.resize(560, 800)
    window.resizeDocks([dock], [560], Qt.Orientation.Horizontal)
    row = dock.table.visualRect(dock.model.index(0, 0)).center()
    QTest.mouseClick(dock.table.viewport(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, row)
    read = dock.tabs.read_points
    asked = read.isVisible()
    choose_in_file_dialog(SAMPLE / "survey.toml")
    click(read)
    until(lambda: dock.store.index is not None, 900, "the points around the units")
    wait(3000)
    picture(window, "review")
    unit = dock.store.current
    picked = click_arrow(dock)
    QTest.keyClick(dock.table, Qt.Key.Key_A)
    decision = dock.store.review(unit)
    arrows = [layer for layer in QgsProject.instance().mapLayers().values() if visible_arrows(layer)]
    choose_in_file_dialog(FOLDER / "report.html")
    dock.ask_report()
    until((FOLDER / "report.html").is_file, 900, "the report")
    until(lambda: "Report written" in dock.status.text(), 60, "the word that it is written")
    (said,) = (str(label.text()) for label in dock.findChildren(QLabel, "review_status") if label.isVisible())
    next(a for a in dock.findChildren(QAction) if a.text().startswith("A page to print")).trigger()
    page = until(lambda: window_of(QMainWindow, "result"), 20, "the page to print")
    wait(2500)
    picture(page, "page_designer")
    page.close()
    return {
        "unit": unit,
        "picked": picked,
        "opens": said,
        "page": [layout.name() for layout in QgsProject.instance().layoutManager().printLayouts()],
        "decision": decision.decision if decision else None,
        "asked_for_points": asked,
        "arrows": [layer.name() for layer in arrows],
    }


def click_arrow(dock: Any) -> str:
    """Click on the map in the middle of the current unit's arrow, after something else was selected; the unit picked."""
    row, canvas = dock.store.row(dock.store.current), iface.mapCanvas()
    dock.map.zoom()
    wait(1500)
    vector = row.vector[:2]
    size = float(np.hypot(*vector))
    place = row.place[:2] + 0.5 * min(0.2, 0.03 / size) * canvas.scale() * vector
    dock.store.select([])
    screen = canvas.getCoordinateTransform().transform(QgsPointXY(*place))
    click(canvas.viewport(), QPoint(round(screen.x()), round(screen.y())))
    return str(dock.store.current)


def visible_arrows(layer: Any) -> bool:
    """Whether a layer draws arrows of displacements now."""
    node = QgsProject.instance().layerTreeRoot().findLayer(layer.id())
    return isinstance(layer, QgsVectorLayer) and "layername=displacements" in layer.source() and node.isVisible()


def choose_in_file_dialog(path: Path) -> None:
    """Choose a file or folder in the window that the next act opens."""

    def fill() -> None:
        found = [w for w in QApplication.topLevelWidgets() if isinstance(w, QFileDialog) and w.isVisible()]
        if found:
            found[0].findChild(QLineEdit, "fileNameEdit").setText(str(path))
            box = found[0].findChild(QDialogButtonBox)
            click(next(b for b in box.buttons() if box.buttonRole(b) == QDialogButtonBox.ButtonRole.AcceptRole))
        if not found or found[0].isVisible():
            QTimer.singleShot(300, guarded(fill))

    QTimer.singleShot(300, guarded(fill))


run(script)
