"""Pictures of the review dock for the documentation, from a synthetic result.

Run with QGIS's Python under a display, once per theme and size, for example
``xvfb-run -a -s "-screen 0 1920x1080x24" .venv-qgis/bin/python scripts/dev/review_images.py dark 1366 768``; a language after the
folder shows the translated dock, which wants fonts for it.
"""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "helpers"))

import conftest
from qgis.core import QgsApplication, QgsCoordinateReferenceSystem, QgsProject
from qgis.gui import QgsLayerTreeMapCanvasBridge, QgsMapCanvas
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QMainWindow
from synthetic_result import SRS, write_points, write_result
from tetratrack.algorithms.support.translation import load_translator

THEMES = {"light": "default", "dark": "Night Mapping"}
SETTLE_SECONDS = 1.5


def settle(application: QgsApplication, seconds: float = SETTLE_SECONDS) -> None:
    """Let the map draw."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        application.processEvents()
        time.sleep(0.02)


def main(theme: str, width: int, height: int, folder: Path, language: str = "") -> None:
    """Write one picture per page of the dock into ``folder``."""
    application = QgsApplication([], True)
    application.initQgis()
    translator = load_translator(conftest.ROOT / "i18n", language)
    if translator is not None:
        application.installTranslator(translator)
    QgsApplication.setUITheme(THEMES[theme])
    from tetratrack.plugin.review_dock import ReviewDock

    with tempfile.TemporaryDirectory() as place:
        path = Path(place) / "north_breakwater.gpkg"
        write_points(path, write_result(path, 160))
        window = QMainWindow()
        canvas = QgsMapCanvas(window)
        canvas.enableAntiAliasing(True)
        canvas.setDestinationCrs(QgsCoordinateReferenceSystem(f"EPSG:{SRS}"))
        window.setCentralWidget(canvas)
        bridge = QgsLayerTreeMapCanvasBridge(QgsProject.instance().layerTreeRoot(), canvas, window)
        bridge.setAutoSetupOnFirstLayer(False)
        dock = ReviewDock(canvas, QgsProject.instance(), window)
        window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
        window.resize(width, height)
        window.show()
        dock.decisions.reviewer.setText("A. Meyer")
        dock.follow.setChecked(False)
        dock.open(path)
        dock.zoom_to_all()
        store = dock.store
        if store is None:
            raise SystemExit(dock.status.text())
        for rank, command in ((0, "inspect"), (2, "rejected"), (1, "accepted")):
            store.select([store.shown(rank).unit_id])
            dock.run_command(command)
        dock.decisions.reviewer.setText("B. Sato")
        dock.confirm()
        settle(application)
        for page, tab in enumerate(("views", "series", "numbers", "history")):
            dock.tabs.setCurrentIndex(page)
            settle(application, 0.3)
            window.grab().save(str(folder / f"review_{tab}_{theme}_{width}x{height}{language and '_'}{language}.png"))
        dock.close()
        window.close()
        window.deleteLater()
        settle(application, 0.1)
    QgsProject.instance().clear()


if __name__ == "__main__":
    images = Path(sys.argv[4]) if len(sys.argv) > 4 else conftest.ROOT / "docs" / "images"
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), images, *sys.argv[5:6])
