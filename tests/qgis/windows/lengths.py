"""Layers of a result dragged onto the map: what the attribute table and the identify window say when the project counts in millimetres."""

from __future__ import annotations

import os
from typing import Any

from qgis.core import Qgis, QgsProject
from qgis.PyQt.QtCore import QPoint, Qt
from qgis.PyQt.QtWidgets import QApplication, QDockWidget, QTreeWidget, QTreeWidgetItemIterator
from qgis.utils import iface
from steps import click, picture, run, until, wait

RESULT = os.environ["TETRATRACK_RESULT"]


def said(tree: QTreeWidget) -> dict[str, str]:
    """Rows of the identify window: what a field is called, and its value."""
    iterator, rows = QTreeWidgetItemIterator(tree), {}
    while iterator.value() is not None:
        rows[iterator.value().text(0)] = iterator.value().text(1)
        iterator += 1
    return rows


def script() -> dict[str, Any]:
    """Open the arrows, identify the longest one, open their table, change the unit."""
    window, project = iface.mainWindow(), QgsProject.instance()
    window.resize(1366, 768)
    arrows = iface.addVectorLayer(f"{RESULT}|layername=displacements", "displacements", "ogr")
    project.setCrs(arrows.crs())
    longest = max(arrows.getFeatures(), key=lambda feature: feature["d_3d"])
    canvas = iface.mapCanvas()
    start = longest.geometry().boundingBox()
    start.grow(3)
    canvas.setExtent(start)
    canvas.refresh()
    wait(1500)
    project.setDistanceUnits(Qgis.DistanceUnit.Millimeters)
    arrows.setSubsetString(f"fid = {longest.id()}")
    iface.setActiveLayer(arrows)
    iface.actionIdentify().trigger()
    place = canvas.mapTool().toCanvasCoordinates(longest.geometry().boundingBox().center()) if canvas.mapTool() else QPoint()
    click(canvas.viewport(), place)
    dock = until(lambda: next((d for d in window.findChildren(QDockWidget) if "Identify" in d.objectName()), None), 20, "identify window")
    tree = until(lambda: next((t for t in dock.findChildren(QTreeWidget) if len(said(t)) > 8), None), 20, "a feature in it")
    dock.setFloating(True)
    dock.resize(620, 560)
    tree.expandAll()
    wait(500)
    tree.resizeColumnToContents(0)
    tree.scrollToBottom()
    picture(dock, "identify_mm")
    identified = said(tree)
    arrows.setSubsetString("")
    iface.showAttributeTable(arrows)
    table = until(
        lambda: next((t for t in QApplication.allWidgets() if t.objectName() == "mTableView" and t.isVisible()), None), 20, "table"
    )
    wait(500)
    table.window().resize(1200, 500)
    picture(table.window(), "table_mm")
    model = table.model()
    headers = [model.headerData(column, Qt.Orientation.Horizontal) for column in range(model.columnCount())]
    column = headers.index("Displacement")
    in_millimetres = [model.index(row, column).data() for row in range(3)]
    project.setDistanceUnits(Qgis.DistanceUnit.Meters)
    return {
        "stored": longest["d_3d"],
        "identified": identified,
        "headers": headers,
        "millimetres": in_millimetres,
        "metres": [model.index(row, column).data() for row in range(3)],
    }


run(script)
