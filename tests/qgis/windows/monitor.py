"""Toolbar > Monitor a survey, then Run, then Run as Batch Process: each does what it says."""

from __future__ import annotations

import gc
import os
from typing import Any

from qgis.gui import QgsProcessingAlgorithmDialogBase
from qgis.PyQt.QtCore import QTimer
from qgis.PyQt.QtWidgets import QPushButton
from steps import FOLDER, action, click, guarded, picture, run, until, window_of


def script() -> dict[str, Any]:
    """Click through both windows."""
    action("Monitor a survey…").trigger()
    gc.collect()
    dialog = until(lambda: window_of(QgsProcessingAlgorithmDialogBase), 20, "the window of Monitor a survey")
    dialog.setParameters({"SURVEY": os.environ["TETRATRACK_SURVEY"], "OUTPUT": str(FOLDER / "result.gpkg"), "LOAD": False})
    picture(dialog, "monitor")
    click(dialog.runButton())
    told = FOLDER / "arguments.json"
    until(told.is_file, 30, "the engine's start")
    until(lambda: dialog.runButton().isEnabled(), 30, "the end of the run")
    dialog.showParameters()
    batch = next(b for b in dialog.findChildren(QPushButton) if "Batch" in b.text())
    titles: list[str] = []

    def look() -> None:
        found = window_of(QgsProcessingAlgorithmDialogBase, "Batch")
        if found is None:
            QTimer.singleShot(200, guarded(look))
        else:
            titles.append(found.windowTitle())
            found.reject()

    # the batch window waits for its user inside the click
    QTimer.singleShot(500, guarded(look))
    click(batch)
    return {"batch": titles[0], "arguments": told.read_text()}


run(script)
