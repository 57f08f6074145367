"""The review dock without a mouse: every button and view takes the focus, in the order in which one reads, and views heed keys."""

from __future__ import annotations

from qgis.PyQt.QtCore import QEvent, QObject, QPointF, Qt
from qgis.PyQt.QtGui import QKeyEvent
from qgis.PyQt.QtWidgets import QFocusFrame, QToolBar, QToolButton, QWidget

from ..algorithms.support.translation import tr
from .review_plots import UnitView

PAN_SHARE = 0.1
"""Of a view's width, by one press of an arrow."""
PANS = {
    Qt.Key.Key_Left: QPointF(1, 0),
    Qt.Key.Key_Right: QPointF(-1, 0),
    Qt.Key.Key_Up: QPointF(0, 1),
    Qt.Key.Key_Down: QPointF(0, -1),
}
ZOOMS = {Qt.Key.Key_Plus: 1.25, Qt.Key.Key_Equal: 1.25, Qt.Key.Key_Minus: 0.8}


def reach_all(window: QWidget) -> None:
    """Let Tab reach the buttons of toolbars, which Qt leaves out, and views; each has a name for those who listen."""
    for bar in window.findChildren(QToolBar):
        for button in bar.findChildren(QToolButton):
            # the button that shows what has no room in the bar stays Qt's own
            if button.objectName() != "qt_toolbar_ext_button":
                button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    for button in window.findChildren(QToolButton):
        if not button.accessibleName():
            button.setAccessibleName(button.text().lstrip("● ") or button.toolTip())
    for view in window.findChildren(UnitView):
        ViewKeys(view)


class ViewKeys(QObject):
    """Keys of a view: arrows move the drawing, + and - zoom, Home resets; while points are picked, Enter picks the one in the middle."""

    def __init__(self, view: UnitView) -> None:
        super().__init__(view)
        self.view = view
        view.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        view.setAccessibleName(tr("Plan of the unit") if view.objectName() == "view_plan" else tr("Section of the unit"))
        view.setToolTip(tr("Arrows move, + and - zoom, Home resets; Enter picks the point in the middle"))
        frame = QFocusFrame(view)
        frame.setWidget(view)
        view.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Take the keys that mean something here."""
        return event.type() == QEvent.Type.KeyPress and self._press(event)

    def _press(self, event: QKeyEvent) -> bool:
        key = Qt.Key(event.key())
        if key in PANS:
            self.view.move_by(PANS[key] * PAN_SHARE * self.view.width())
        elif key in ZOOMS:
            self.view.zoom_about(QPointF(self.view.rect().center()), ZOOMS[key])
        elif key == Qt.Key.Key_Home:
            self.view.reset()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.view.pick_at(QPointF(self.view.rect().center()))
        else:
            return False
        return True
