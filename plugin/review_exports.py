"""What the review hands on, in the dock's toolbar: model, sections and comparisons by the windows of their algorithms, and the 3D view."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from qgis.core import QgsApplication
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QMenu, QToolBar, QToolButton

from ..algorithms.support.translation import tr
from .review_store import ReviewStore

ICONS = Path(__file__).parent / "icons"


class ReviewExports:
    """Button with a menu that a dock shows in its toolbar.

    Parameters
    ----------
    bar
        Toolbar of the dock.
    store
        Called for the store of the review, None where no result is open.
    view
        Opens the 3D view.
    """

    def __init__(self, bar: QToolBar, store: Callable[[], ReviewStore | None], view: Callable[[], Any]) -> None:
        self._store = store
        self._window: Any = None
        cube = QToolButton(bar)
        cube.setObjectName("review_view_3d")
        cube.setIcon(QgsApplication.getThemeIcon("/3d.svg"))
        cube.setToolTip(tr("Open 3D view"))
        cube.clicked.connect(lambda checked=False: view())
        bar.addWidget(cube)
        button = QToolButton(bar)
        button.setObjectName("review_exports")
        button.setIcon(QIcon(str(ICONS / "model.svg")))
        button.setToolTip(tr("Model, sections and design"))
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(button)
        for text, algorithm in (
            (tr("Export as-built model…"), "exportmodel"),
            (tr("Compare with design…"), "comparedesign"),
            (tr("Cross-sections and crest…"), "crosssections"),
            (tr("Points less blocks…"), "residualpoints"),
        ):
            menu.addAction(text).triggered.connect(lambda checked=False, name=algorithm: self.open(name))
        button.setMenu(menu)
        bar.addWidget(button)

    def open(self, algorithm: str) -> Any:
        """Open the window of an algorithm with the result, and the later epoch where it asks for one, filled in."""
        from qgis import processing

        store = self._store()
        if store is None:
            return None
        known = {"INPUT": str(store.path)}
        if algorithm != "crosssections":
            known["EPOCH"] = store.pair.epoch_to
        if algorithm == "exportmodel":
            known["OUTPUT"] = str(store.path.with_suffix(".glb"))
        # kept, or its Python half would be gone once this method ends
        self._window = processing.createAlgorithmDialog(f"tetratrack:{algorithm}", known)
        self._window.show()
        return self._window
