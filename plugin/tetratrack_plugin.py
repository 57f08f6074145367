"""The plugin object: provider, options page, actions and translation; nothing is started before it is used."""

from __future__ import annotations

import shutil
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from qgis.core import Qgis, QgsApplication, QgsProject, QgsSettings
from qgis.PyQt.QtCore import QCoreApplication, QObject, QStandardPaths, Qt, QTimer, QTranslator, QUrl, pyqtSlot
from qgis.PyQt.QtGui import QAction, QDesktopServices, QIcon
from qgis.PyQt.QtWidgets import QPushButton

from ..algorithms.provider import TetratrackProvider
from ..algorithms.support import length_fields
from ..algorithms.support.engine import LINK_SCHEME, find_engine
from ..algorithms.support.environment import (
    PLUGIN_FOLDER,
    Places,
    bring_back,
    clear_leftovers,
    fault_message,
    in_making,
    managed_environment,
)
from ..algorithms.support.layers import follow_unit, name_added_layers
from ..algorithms.support.translation import load_translator, tr, user_locale

ICONS = PLUGIN_FOLDER / "plugin" / "icons"


class Links(QObject):
    """Hands links of the plugin's own scheme on: Qt wants an object of its own to receive them."""

    def __init__(self, follow: Callable[[QUrl], None]) -> None:
        super().__init__()
        self._follow = follow

    @pyqtSlot(QUrl)
    def follow(self, url: QUrl) -> None:
        """Follow a link."""
        self._follow(url)


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
        self.monitor_dialog: Any = None
        self.links: Links | None = None
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
        from . import length_widget
        from .options import TetratrackOptionsFactory

        self.initProcessing()
        length_fields.register()
        length_widget.register()
        QgsProject.instance().layersAdded.connect(self._name_later)
        QgsProject.instance().distanceUnitsChanged.connect(self._follow_unit)
        self.options_factory = TetratrackOptionsFactory()
        self.iface.registerOptionsWidgetFactory(self.options_factory)
        self.toolbar = self.iface.addToolBar("Tetratrack")
        self.toolbar.setObjectName("tetratrackToolBar")
        self._add_action(tr("Displacement review"), "review.svg", self.show_review, checkable=True)
        self._add_action(tr("Monitor a survey…"), "tetratrack.svg", self.show_monitor)
        self._add_action(tr("Try the sample…"), "tetratrack.svg", self.try_sample, in_toolbar=False)
        self._add_action(tr("Engine…"), "tetratrack.svg", self.show_options, in_toolbar=False)
        self.links = Links(self.open_link)
        QDesktopServices.setUrlHandler(LINK_SCHEME, self.links.follow)
        # when the window stands: a message must not delay QGIS's start
        QTimer.singleShot(0, self._say_what_is_missing)

    def unload(self) -> None:
        """Take back everything :meth:`initGui` and :meth:`initProcessing` registered."""
        QDesktopServices.unsetUrlHandler(LINK_SCHEME)
        QgsProject.instance().layersAdded.disconnect(self._name_later)
        QgsProject.instance().distanceUnitsChanged.disconnect(self._follow_unit)
        length_fields.unregister()
        for action in self.actions:
            self.iface.removePluginMenu("Tetratrack", action)
        self.actions.clear()
        if self.review_dock is not None:
            self.iface.removeDockWidget(self.review_dock)
            self.review_dock.deleteLater()
            self.review_dock = None
        if self.monitor_dialog is not None:
            self.monitor_dialog.close()
            self.monitor_dialog = None
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

    def show_monitor(self, parameters: dict[str, Any] | None = None) -> None:
        """Open the dialog of the algorithm that does all steps, on wish with some parameters filled in."""
        from qgis import processing

        # QGIS keeps the window alone: without this reference the Python half, which runs the algorithm, is gone once this method ends
        self.monitor_dialog = processing.createAlgorithmDialog("tetratrack:monitorsurvey", parameters or {})
        self.monitor_dialog.show()

    def show_options(self) -> None:
        """Open the page of QGIS's options on which the engine is made and chosen."""
        from .options import PAGE_NAME

        self.iface.showOptionsDialog(self.iface.mainWindow(), PAGE_NAME)

    def try_sample(self) -> None:
        """Copy the sample survey into a folder of the user's, and run it in the window that runs any survey."""
        engine = find_engine()
        if engine is None or engine.fault:
            self._say_what_is_missing()
            return
        documents = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.DocumentsLocation) or str(Path.home())
        folder = Path(documents) / "tetratrack sample"
        try:
            shutil.copytree(sample_folder(), folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns("truth"))
        except OSError as error:
            problem = tr("The sample cannot be copied to {folder}: {reason}.").format(folder=folder, reason=error)
            self.iface.messageBar().pushMessage("Tetratrack", problem, Qgis.MessageLevel.Warning, 0)
            return
        self.show_monitor({"SURVEY": str(folder / "survey.toml"), "OUTPUT": str(folder / "result.gpkg")})
        self.monitor_dialog.runButton().click()

    def open_link(self, url: QUrl) -> None:
        """Follow a link of the plugin's own in a message."""
        {"options": self.show_options, "sample": self.try_sample, "mend": self.mend_engine}.get(
            url.path() or url.host(), self.show_options
        )()

    def mend_engine(self) -> None:
        """Ask whether the engine's environment shall be made again, and do it, from wheels where it was made of some."""
        from .options import WHEELS_SETTING, ask_and_create

        text = QgsSettings().value(WHEELS_SETTING, "", type=str)
        ask_and_create(self.iface.mainWindow(), Path(text) if text and Path(text).exists() else None)

    def _name_later(self, layers: list[Any]) -> None:
        """Name the fields of layers of results; QGIS reads the file's style, which would undo it, only after it has added them."""
        keys = [layer.id() for layer in layers]
        QTimer.singleShot(0, lambda: name_added_layers(filter(None, map(QgsProject.instance().mapLayer, keys))))

    def _follow_unit(self) -> None:
        """Lengths of all layers of results in the unit that the project now has."""
        follow_unit(QgsProject.instance())

    def _say_what_is_missing(self) -> None:
        """At the start, and where one is needed: that there is no engine, or one of another version, with the way to mend it."""
        places = Places(managed_environment())
        bring_back(places)
        if places.making.exists() or places.before.exists():
            # gigabytes: QGIS's start does not wait for them
            threading.Thread(target=clear_leftovers, args=(places,), daemon=True).start()
        engine = find_engine()
        if self.provider is None or in_making(places) or (engine is not None and not engine.fault):
            return
        text, label, way = tr("An engine is needed before anything can be computed."), tr("Create or choose the engine…"), self.show_options
        if engine is not None:
            text, label, way = fault_message(engine.fault), tr("Make the environment again…"), self.mend_engine
        message = self.iface.messageBar().createMessage("Tetratrack", text)
        button = QPushButton(label, message)
        button.setObjectName("tetratrack_engine")
        button.clicked.connect(lambda checked=False: self._leave_message(message, way))
        message.layout().addWidget(button)
        self.iface.messageBar().pushWidget(message, Qgis.MessageLevel.Info)

    def _leave_message(self, message: Any, way: Callable[[], None]) -> None:
        """Go where a message leads; it has been read."""
        self.iface.messageBar().popWidget(message)
        way()

    def _add_action(self, text: str, icon: str, called: Callable[..., None], *, checkable: bool = False, in_toolbar: bool = True) -> None:
        action = QAction(QIcon(str(ICONS / icon)), text, self.iface.mainWindow())
        action.setCheckable(checkable)
        action.triggered.connect(called if checkable else lambda _checked: called())
        self.iface.addPluginToMenu("Tetratrack", action)
        if in_toolbar:
            self.toolbar.addAction(action)
        self.actions.append(action)


def sample_folder() -> Path:
    """The sample survey: in the ZIP beside the code, in a checkout among the tests."""
    packed = PLUGIN_FOLDER / "sample"
    return packed if packed.is_dir() else PLUGIN_FOLDER / "tests" / "data" / "sample"
