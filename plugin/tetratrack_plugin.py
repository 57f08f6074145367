"""The plugin object: provider, options page, actions and translation; nothing is started before it is used."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QCoreApplication, Qt, QTranslator
from qgis.PyQt.QtGui import QAction, QIcon

from .engine import PLUGIN_FOLDER
from .provider import TetratrackProvider
from .translation import load_translator, tr, user_locale

ICONS = PLUGIN_FOLDER / "plugin" / "icons"


class TetratrackPlugin:
    """Registers everything with QGIS and takes it back on unload.

    Parameters
    ----------
    iface
        The interface of QGIS; None under qgis_process, which calls :meth:`initProcessing` only.
    """

    def __init__(self, iface: Any) -> None:
        self.iface = iface
        self.provider: TetratrackProvider | None = None
        self.options_factory: Any = None
        self.review_dock: Any = None
        self.actions: list[QAction] = []
        self.toolbar: Any = None
        self.translator: QTranslator | None = load_translator(PLUGIN_FOLDER / "i18n", user_locale())
        if self.translator is not None:
            QCoreApplication.installTranslator(self.translator)

    def initProcessing(self) -> None:
        """Register the Processing provider."""
        self.provider = TetratrackProvider()
        QgsApplication.processingRegistry().addProvider(self.provider)

    def initGui(self) -> None:
        """Register provider, options page, menu and toolbar."""
        from .options import TetratrackOptionsFactory

        self.initProcessing()
        self.options_factory = TetratrackOptionsFactory()
        self.iface.registerOptionsWidgetFactory(self.options_factory)
        self.toolbar = self.iface.addToolBar("Tetratrack")
        self.toolbar.setObjectName("tetratrackToolBar")
        self._add_action(tr("Displacement review"), "review.svg", self.show_review, checkable=True)
        self._add_action(tr("Monitor a survey…"), "tetratrack.svg", self.show_monitor)

    def unload(self) -> None:
        """Take back everything :meth:`initGui` and :meth:`initProcessing` registered."""
        for action in self.actions:
            self.iface.removePluginMenu("Tetratrack", action)
        self.actions.clear()
        if self.review_dock is not None:
            self.iface.removeDockWidget(self.review_dock)
            self.review_dock.deleteLater()
            self.review_dock = None
        if self.toolbar is not None:
            self.toolbar.deleteLater()
            self.toolbar = None
        if self.options_factory is not None:
            self.iface.unregisterOptionsWidgetFactory(self.options_factory)
            self.options_factory = None
        if self.provider is not None:
            QgsApplication.processingRegistry().removeProvider(self.provider)
            self.provider = None
        if self.translator is not None:
            QCoreApplication.removeTranslator(self.translator)
            self.translator = None

    def show_review(self, visible: bool = True) -> None:
        """Show or hide the dock "Displacement review", made when it is first asked for."""
        if self.review_dock is None:
            from .review_dock import ReviewDock

            self.review_dock = ReviewDock(self.iface.mapCanvas(), parent=self.iface.mainWindow())
            self.iface.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self.review_dock)
            self.review_dock.visibilityChanged.connect(self.actions[0].setChecked)
        self.review_dock.setVisible(visible)

    def show_monitor(self) -> None:
        """Open the dialog of the algorithm that does all steps."""
        from qgis import processing

        dialog = processing.createAlgorithmDialog("tetratrack:monitorsurvey", {})
        dialog.show()

    def _add_action(self, text: str, icon: str, called: Callable[..., None], *, checkable: bool = False) -> None:
        action = QAction(QIcon(str(ICONS / icon)), text, self.iface.mainWindow())
        action.setCheckable(checkable)
        action.triggered.connect(called if checkable else lambda _checked: called())
        self.iface.addPluginToMenu("Tetratrack", action)
        self.toolbar.addAction(action)
        self.actions.append(action)
