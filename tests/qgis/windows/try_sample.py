"""Tetratrack > Try the sample…: copied, run and shown without another click, then opened in the review."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from qgis.core import QgsProject
from qgis.gui import QgsProcessingAlgorithmDialogBase
from qgis.PyQt.QtWidgets import QDockWidget
from qgis.utils import iface
from steps import action, picture, plugin, run, until, wait, window_of


def script() -> dict[str, Any]:
    """Press once, and look at what comes."""
    window = iface.mainWindow()
    window.resize(1366, 768)
    window.findChild(QDockWidget, "Browser").hide()
    action("Try the sample…").trigger()
    dialog = until(lambda: window_of(QgsProcessingAlgorithmDialogBase, "Monitor"), 20, "the window of Monitor a survey")
    until(lambda: QgsProject.instance().mapLayersByName("Outlines of the units"), 900, "the result")
    until(lambda: dialog.runButton().isEnabled() or not dialog.isVisible(), 60, "the end of the run")
    dialog.close()
    wait(2000)
    folder = Path(os.environ["HOME"]) / "tetratrack sample"
    if not folder.is_dir():
        folder = Path(os.environ["HOME"]) / "Documents" / "tetratrack sample"
    action("Displacement review").trigger()
    dock = until(lambda: plugin().review_dock, 10, "the dock")
    dock.open(folder / "result.gpkg")
    dock.step(1)
    wait(3000)
    iface.messageBar().clearWidgets()
    picture(window, "sample_1366x768")
    return {
        "files": sorted(path.name for path in folder.iterdir()),
        "truth": (folder / "truth").exists(),
        "units": len(dock.store.rows),
        "views": [dock.tabs.plan.width(), dock.tabs.plan.height()],
        "window": [window.width(), window.height()],
        "layers": sorted(layer.name() for layer in QgsProject.instance().mapLayers().values()),
    }


run(script)
