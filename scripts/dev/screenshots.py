"""Pictures of a real QGIS window for docs/images; started by ``xvfb-run qgis --code scripts/dev/screenshots.py`` (see docs/development.md).

The environment names what to show: TETRATRACK_SHOTS is the folder to write to, TETRATRACK_RESULT a result with its reliefs beside
it, TETRATRACK_SURVEY the survey.toml that the dialog is to hold, TETRATRACK_SUFFIX is appended to the names of the pictures.
"""

from __future__ import annotations

import os
import traceback
from pathlib import Path

from qgis import processing
from qgis.core import QgsProject, QgsRasterLayer, QgsRectangle, QgsVectorLayer
from qgis.PyQt.QtCore import QEventLoop, QTimer
from qgis.PyQt.QtWidgets import QApplication, QDockWidget, QWidget
from qgis.utils import iface, plugins

FOLDER = Path(os.environ["TETRATRACK_SHOTS"])
RESULT = Path(os.environ["TETRATRACK_RESULT"])
SURVEY = os.environ.get("TETRATRACK_SURVEY", "")
SUFFIX = os.environ.get("TETRATRACK_SUFFIX", "")


def wait(milliseconds: int) -> None:
    """Let QGIS draw."""
    loop = QEventLoop()
    QTimer.singleShot(milliseconds, loop.quit)
    loop.exec()


def keep(widget: QWidget, name: str) -> None:
    """Save a picture of a widget."""
    QApplication.processEvents()
    widget.grab().save(str(FOLDER / f"{name}{SUFFIX}.png"))


def load_result() -> None:
    """Load the layers of the result as the algorithm does."""
    from importlib import import_module

    package = type(plugins[next(name for name in plugins if hasattr(plugins[name], "show_review"))]).__module__.split(".")[0]
    layers = import_module(f"{package}.algorithms.support.layers")
    group = QgsProject.instance().layerTreeRoot().insertGroup(0, RESULT.stem)
    for name in layers.DRAWING_ORDER:
        layer = QgsVectorLayer(f"{RESULT}|layername={name}", layers.layer_title(name), "ogr")
        if layer.featureCount() == 0 or not layer.isSpatial() or name == "displacements_other":
            continue
        QgsProject.instance().addMapLayer(layer, False)
        layers.apply_style(layer, name)
        node = group.addLayer(layer)
        node.setExpanded(name in ("unit_outlines", "displacements"))
        node.setItemVisibilityChecked(name not in layers.HIDDEN_AT_FIRST)
    for relief in sorted(RESULT.parent.glob(f"{RESULT.stem}_relief_*.tif"))[-1:]:
        layer = QgsRasterLayer(str(relief), relief.stem.rpartition("_")[2])
        layers.show_grey(layer)
        QgsProject.instance().addMapLayer(layer, False)
        group.addLayer(layer).setExpanded(False)
    units = next(layer for layer in QgsProject.instance().mapLayers().values() if "layername=units" in layer.source())
    QgsProject.instance().setCrs(units.crs())
    extent = QgsRectangle(units.extent())
    extent.scale(1.15)
    iface.mapCanvas().setExtent(extent)
    iface.mapCanvas().refresh()


def main() -> None:
    """Take all pictures and leave."""
    window = iface.mainWindow()
    window.resize(1500, 900)
    toolbox = window.findChild(QDockWidget, "ProcessingToolbox")
    toolbox.show()
    toolbox.setMinimumWidth(330)
    window.findChild(QDockWidget, "Layers").setMinimumWidth(330)
    for name in ("Browser",):
        window.findChild(QDockWidget, name).hide()
    load_result()
    wait(3000)
    toolbox.searchBox.setText("tetratrack")
    wait(3000)
    iface.messageBar().clearWidgets()
    keep(window, "map")
    keep(toolbox, "toolbox")
    toolbox.hide()
    for algorithm in ("monitorsurvey", "planningdetectability"):
        dialog = processing.createAlgorithmDialog(f"tetratrack:{algorithm}", {"SURVEY": SURVEY} if SURVEY else {})
        dialog.resize(1100, 800)
        dialog.show()
        wait(1500)
        keep(dialog, algorithm)
        dialog.close()
    QgsProject.instance().setDirty(False)
    os._exit(0)


def guarded() -> None:
    """Say on the console what went wrong: a message box would wait for ever."""
    try:
        main()
    except BaseException:
        traceback.print_exc()
        os._exit(1)


QTimer.singleShot(4000, guarded)
