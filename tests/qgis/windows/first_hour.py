"""From a folder of tiles to the review of its result, on the first page of the dock."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QDockWidget, QLineEdit
from qgis.utils import iface
from steps import action, click, picture, plugin, run, until, wait

FOLDER = Path(os.environ["TETRATRACK_FOLDER"])


def script() -> dict[str, Any]:
    """Choose, look, correct, run."""
    window = iface.mainWindow()
    window.resize(1500, 900)
    window.findChild(QDockWidget, "Browser").hide()
    action("Displacement review").trigger()
    dock = until(lambda: plugin().review_dock, 10, "the dock")
    window.resizeDocks([dock], [760], Qt.Orientation.Horizontal)
    start = dock.start
    line = start.folder.findChild(QLineEdit)
    QTest.keyClicks(line, str(FOLDER))
    QTest.keyClick(line, Qt.Key.Key_Return)
    until(start.epochs.rows, 120, "the epochs of the folder")
    wait(1500)
    iface.messageBar().clearWidgets()
    picture(window, "start_page")
    rows = start.epochs.rows()
    found = [{"label": row.label, "points": row.points, "density": row.density, "crs": row.crs, "tiles": len(row.tiles)} for row in rows]
    table = start.epochs.table
    editors = {name: type(table.cellWidget(0, column)).__name__ for name, column in (("time", 1), ("tiles", 2), ("control", 6))}
    table.item(0, 0).setText("before the storm")
    bands = len(start.footprints.bands)
    # its estimate takes minutes on a busy machine, and is tested with the command
    start.height.setValue(2.3)
    click(start.run)
    until(lambda: dock.store, 800, "the result in the dock")
    wait(3000)
    picture(window, "start_result")
    return {
        "found": found,
        "editors": editors,
        "footprints": bands,
        "epochs": [info.label for info in dock.store.epochs],
        "units": len(dock.store.rows),
    }


run(script)
