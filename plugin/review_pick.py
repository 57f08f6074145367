"""Clicks on the map: one that says which unit is meant, whatever layer or tool QGIS has chosen, and one for corrections."""

from __future__ import annotations

from qgis.core import QgsPointXY
from qgis.gui import QgsMapCanvas, QgsMapMouseEvent, QgsMapTool, QgsMapToolPan
from qgis.PyQt.QtCore import QPoint, Qt, pyqtSignal
from qgis.PyQt.QtGui import QKeyEvent

STILL_PIXELS = 4
"""A button released nearer than this to where it was pressed was a click."""


class PickTool(QgsMapToolPan):
    """Pans as QGIS's own hand does; ``picked`` carries the place of a click, and whether it adds to what is selected."""

    picked = pyqtSignal(QgsPointXY, bool)

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self._pressed: QPoint | None = None
        self._moved = False
        self.setCursor(Qt.CursorShape.PointingHandCursor)

    def canvasPressEvent(self, event: QgsMapMouseEvent) -> None:
        """Begin a click or a move."""
        self._pressed, self._moved = event.pos(), False
        super().canvasPressEvent(event)

    def canvasMoveEvent(self, event: QgsMapMouseEvent) -> None:
        """Move the map; a hand that trembles moves nothing."""
        if self._pressed is not None and not self._moved:
            if (event.pos() - self._pressed).manhattanLength() <= STILL_PIXELS:
                return
            self._moved = True
        super().canvasMoveEvent(event)

    def canvasReleaseEvent(self, event: QgsMapMouseEvent) -> None:
        """End the move, or tell where the click was; the hand of QGIS would centre the map there."""
        if self._moved:
            super().canvasReleaseEvent(event)
        elif event.button() == Qt.MouseButton.LeftButton:
            adds = bool(event.modifiers() & (Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier))
            self.picked.emit(event.mapPoint(), adds)
        self._pressed = None
        self.canvas().setCursor(Qt.CursorShape.PointingHandCursor)


class ClickTool(QgsMapTool):
    """One click on the map, for corrections; ``clicked`` carries the place in canvas coordinates, Escape ends the tool."""

    clicked = pyqtSignal(QgsPointXY)
    left = pyqtSignal()

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self.setCursor(Qt.CursorShape.CrossCursor)

    def canvasReleaseEvent(self, event: QgsMapMouseEvent) -> None:
        """Tell where the user clicked."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.clicked.emit(event.mapPoint())

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """Leave the tool with Escape."""
        if event.key() == Qt.Key.Key_Escape:
            self.left.emit()
