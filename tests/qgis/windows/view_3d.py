"""Open the 3D view of a result with one click in the review dock, and keep a picture of the window."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from qgis.PyQt.QtGui import QGuiApplication
from qgis.PyQt.QtWidgets import QApplication, QLabel, QToolButton
from qgis.utils import iface
from steps import FOLDER, click, plugin, run, until, wait

RESULT = Path(os.environ["TETRATRACK_RESULT"])


def script() -> dict[str, Any]:
    """Open the result, click the cube, look."""
    window = iface.mainWindow()
    window.resize(1400, 900)
    plugin().show_review()
    dock = plugin().review_dock
    dock.open(RESULT)
    wait(1500)
    click(dock.findChild(QToolButton, "review_view_3d"))
    canvas = until(lambda: next(iter(iface.mapCanvases3D()), None), 30, "3D view")
    legend = until(lambda: next((w for w in QApplication.allWidgets() if w.objectName() == "tetratrack_legend_3d"), None), 10, "legend")
    wait(int(os.environ.get("TETRATRACK_WAIT", "15000")))
    QGuiApplication.primaryScreen().grabWindow(0).save(str(FOLDER / "view_3d.png"))
    camera = canvas.cameraController()
    return {
        "layers": [layer.name() for layer in canvas.mapSettings().layers()],
        "legend": legend.text() if isinstance(legend, QLabel) else "",
        "extent": canvas.mapSettings().extent().toString(),
        "origin": [getattr(canvas.mapSettings().origin(), k)() for k in "xyz"],
        "distance": camera.distance(),
        "pitch": camera.pitch(),
    }


run(script)
