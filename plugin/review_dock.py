"""The dock in which an engineer reviews displacements: table, pages of the unit and decisions in step with the map."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from qgis.core import Qgis, QgsApplication, QgsProject, QgsSettings, QgsVectorLayer
from qgis.gui import QgsDockWidget, QgsMapCanvas
from qgis.PyQt.QtCore import QSize, Qt, QTimer
from qgis.PyQt.QtGui import QAction, QCloseEvent, QResizeEvent
from qgis.PyQt.QtWidgets import (
    QFileDialog,
    QInputDialog,
    QLabel,
    QMenu,
    QSplitter,
    QStackedWidget,
    QToolBar,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ..core.alarms import write_alarms
from ..core.errors import TetratrackError
from ..core.reviews import Decision
from .engine_task import EngineTask
from .review_corrections import ReviewCorrections
from .review_details import counts_html
from .review_map import ReviewMap
from .review_panels import SPACING, ComparisonChoice, DecisionPanel, FilterPanel, StartPage, StatusLine
from .review_store import ReviewStore, Topic
from .review_table import ReviewModel, ReviewTable
from .review_tabs import UnitTabs
from .review_text import decision_label
from .translation import tr

FOLLOW_SETTING = "tetratrack/review_follow"
OTHERS_MILLISECONDS = 2000
"""How often the decisions of other reviewers are taken in."""


class ReviewDock(QgsDockWidget):
    """Displacement review of one result GeoPackage.

    Parameters
    ----------
    canvas
        Map canvas to work with.
    project
        Project the layers go to.
    """

    def __init__(self, canvas: QgsMapCanvas, project: QgsProject | None = None, parent: QWidget | None = None) -> None:
        super().__init__(tr("Displacement review"), parent)
        self.setObjectName("TetratrackReviewDock")
        self.canvas, self.project = canvas, project or QgsProject.instance()
        self.store: ReviewStore | None = None
        self.map: ReviewMap | None = None
        self.model: ReviewModel | None = None
        self.corrections: ReviewCorrections | None = None
        self._tasks: list[EngineTask] = []
        self._others = QTimer(self)
        self._others.setInterval(OTHERS_MILLISECONDS)
        self._others.timeout.connect(self._take_in)
        self._build()

    # opening and closing

    def open(self, path: str | Path) -> bool:
        """Open a result file; False, with the reason in the status line, when it cannot be read."""
        try:
            store = ReviewStore(path)
        except TetratrackError as error:
            self.status.say(str(error), bad=True)
            return False
        self._close_store()
        # the new store shows all units; with none open the filters tell nobody
        self.filters.clear()
        self.store = store
        self.model = self.table.show_store(store)
        self.tabs.show_store(store)
        store.observe(self._on_store)
        self.map = ReviewMap(store, self.canvas, self.project, self)
        self.corrections = ReviewCorrections(self.map, self.tabs, self.decisions, self.status, self.start_engine)
        self.corrections.fill_menu(self._correction_menu)
        self.comparison.show_store(store)
        self._pages.setCurrentIndex(1)
        self._on_store("rows")
        self._others.start()
        self.status.say(
            str(store.path.name)
            if store.writable
            else tr("{name} is read-only: you can look, but decisions cannot be stored.").format(name=store.path.name),
            bad=not store.writable,
        )
        return True

    def choose_file(self) -> None:
        """Ask for a result file."""
        name, _ = QFileDialog.getOpenFileName(self, tr("Open a result"), "", tr("GeoPackage (*.gpkg)"))
        if name:
            self.open(name)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Everything is stored already; layers leave the project."""
        self._close_store()
        super().closeEvent(event)

    def _close_store(self) -> None:
        self._others.stop()
        self._correction_menu.clear()
        if self.corrections is not None:
            self.corrections.close()
        if self.map is not None:
            self.map.remove()
            self.map.deleteLater()
        if self.store is not None:
            self.store.forget(self._on_store)
        self.tabs.show_store(None)
        self.store = self.map = self.model = self.corrections = None
        self._pages.setCurrentIndex(0)

    # building the window

    def _build(self) -> None:
        start, body = StartPage(self), QWidget(self)
        start.button.clicked.connect(self.choose_file)
        self._pages = QStackedWidget(self)
        self._pages.addWidget(start)
        self._pages.addWidget(body)
        self.setWidget(self._pages)
        self._counts, answer = QLabel(body), QLabel(body)
        self._counts.setObjectName("review_counts")
        self._counts.setTextFormat(Qt.TextFormat.RichText)
        answer.setObjectName("review_status")
        answer.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.status = StatusLine(answer, start.status)
        toolbar = self._toolbar(body)
        self.comparison = ComparisonChoice(self.status, body)
        self.filters = FilterPanel(body)
        self.filters.changed.connect(self._filter)
        self.filters.area_wanted.connect(self.set_area)
        self._splitter = QSplitter(Qt.Orientation.Vertical, body)
        self._splitter.setChildrenCollapsible(False)
        self.table, self.tabs = ReviewTable(self._splitter), UnitTabs(self._splitter)
        self.table.setMinimumHeight(90)
        self.table.command.connect(self.run_command)
        self._splitter.setStretchFactor(0, 2)
        self._splitter.setStretchFactor(1, 3)
        self.decisions = DecisionPanel(body)
        self.decisions.command.connect(self.run_command)
        page = QVBoxLayout(body)
        page.setContentsMargins(4, 2, 4, 2)
        page.setSpacing(SPACING)
        for part in (toolbar, self.comparison, self.filters):
            page.addWidget(part)
        page.addWidget(self._splitter, 1)
        page.addWidget(self.decisions)
        for label in (self._counts, answer):
            label.setWordWrap(True)
            page.addWidget(label)

    def _toolbar(self, parent: QWidget) -> QToolBar:
        bar = QToolBar(parent)
        bar.setIconSize(QSize(18, 18))
        self._action(bar, "/mActionFileOpen.svg", tr("Open a result"), self.choose_file)
        self._action(bar, "/mActionArrowUp.svg", tr("Previous unit (Up, or P for the previous undecided)"), partial(self.step, -1))
        self._action(bar, "/mActionArrowDown.svg", tr("Next unit (Down, or N for the next undecided)"), partial(self.step, 1))
        self._action(bar, "/mActionZoomToSelected.svg", tr("Zoom to the unit and flash it (Z)"), self.zoom)
        self.follow = self._action(bar, "/mActionPanToSelected.svg", tr("The map follows the selection"), self._set_follow)
        self.follow.setCheckable(True)
        self.follow.setChecked(QgsSettings().value(FOLLOW_SETTING, True, type=bool))
        self._action(bar, "/mActionZoomFullExtent.svg", tr("Show all units"), self.zoom_to_all)
        bar.addSeparator()
        pencil = QToolButton(bar)
        pencil.setIcon(QgsApplication.getThemeIcon("/mActionToggleEditing.svg"))
        pencil.setToolTip(tr("Correct a unit"))
        pencil.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self._correction_menu = QMenu(pencil)
        pencil.setMenu(self._correction_menu)
        bar.addWidget(pencil)
        self._action(bar, "/mActionNewReport.svg", tr("Write the report…"), self.ask_report)
        self._action(bar, "/mActionSharingExport.svg", tr("Export the alarm list…"), self.ask_alarms)
        return bar

    def _action(self, bar: QToolBar, icon: str, text: str, run: Callable[[], Any]) -> QAction:
        action = bar.addAction(QgsApplication.getThemeIcon(icon), text)
        action.triggered.connect(lambda checked=False: run())
        return action

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Table above the views in a tall dock, beside them in a wide one."""
        wide = self.width() > 1.5 * self.height()
        self._splitter.setOrientation(Qt.Orientation.Horizontal if wide else Qt.Orientation.Vertical)
        super().resizeEvent(event)

    # store to window

    def _on_store(self, topic: Topic) -> None:
        if self.store is None or self.model is None or self.map is None:
            return
        if topic in ("rows", "order"):
            self.model.reset()
        if topic == "reviews":
            self.model.refresh()
        if topic in ("rows", "reviews"):
            self.map.show_pair()
        if topic in ("rows", "order", "selection"):
            self.table.follow()
        if topic == "selection":
            self.map.follow()
            if self.follow.isChecked() and self.isVisible():
                self.map.zoom()
        if topic in ("rows", "selection", "reviews"):
            self.tabs.show_unit()
        if topic != "selection":
            self._counts.setText(counts_html(self.store, self.palette()))

    def _take_in(self) -> None:
        changed: list[bool] = []
        if self.store is not None and self.isVisible():
            # a file locked for a moment is read at the next turn
            self.status.attempt(lambda: changed.append(self.store.refresh()), quiet=True)
        if any(changed):
            self.status.say(tr("Decisions of another reviewer were taken in."))

    # looking

    def set_area(self, kind: str) -> None:
        """Show units ``everywhere``, in the ``map`` window, or in the ``polygon`` features of the active layer."""
        if self.store is None or self.map is None:
            return
        if kind == "polygon":
            layer = self.canvas.currentLayer()
            if not isinstance(layer, QgsVectorLayer) or layer.geometryType() != Qgis.GeometryType.Polygon:
                self.status.say(tr("Make a polygon layer active first."), bad=True)
                return
            self.store.set_filter(area=self.map.polygon_rings(layer))
            self.filters.area.setText(tr("In polygons"))
        elif kind == "map":
            self.store.set_filter(area=(self.map.extent_ring(),))
            self.filters.area.setText(tr("In the map window"))
        else:
            self.store.set_filter(area=())
            self.filters.area.setText(tr("Everywhere"))

    def step(self, by: int, *, undecided: bool = False) -> None:
        """Select the next or previous unit of the table."""
        if self.store is not None and self.store.step(by, undecided=undecided) is None:
            self.status.say(tr("No unit passes the filter."))

    def zoom(self) -> None:
        """Zoom the map to the current unit and flash it."""
        if self.map is not None:
            self.map.zoom()

    def zoom_to_all(self) -> None:
        """Show all units on the map."""
        if self.map is not None:
            self.map.zoom_to_all()

    def _filter(self, changes: dict[str, Any]) -> None:
        if self.store is not None:
            self.store.set_filter(**changes)

    def _set_follow(self) -> None:
        QgsSettings().setValue(FOLLOW_SETTING, self.follow.isChecked())

    # deciding

    def run_command(self, command: str) -> None:
        """What a single key in the table or a button asks for."""
        if command in ("accepted", "rejected", "inspect"):
            self.decide(command)
        else:
            {
                "confirm": self.confirm,
                "undo": self.undo,
                "zoom": self.zoom,
                "next": partial(self.step, 1, undecided=True),
                "previous": partial(self.step, -1, undecided=True),
            }[command]()

    def decide(self, decision: Decision) -> None:
        """Store a decision on the selected units."""
        if self.store is None:
            return
        units = ", ".join(self.store.selected)
        reviewer, comment = self.decisions.reviewer.text(), self.decisions.comment.text().strip()
        if self.status.attempt(lambda: self.store.decide(decision, reviewer=reviewer, comment=comment)):
            self.status.say(
                tr("{units}: {decision}, stored.").format(
                    units=units if len(units) < 60 else len(self.store.selected), decision=decision_label(decision)
                )
            )
            self.decisions.comment.clear()

    def confirm(self) -> None:
        """Confirm another reviewer's decisions on the selected units."""
        reviewer, comment = self.decisions.reviewer.text(), self.decisions.comment.text().strip()
        if self.store is not None and self.status.attempt(lambda: self.store.confirm(reviewer=reviewer, comment=comment)):
            self.status.say(tr("Confirmed."))
            self.decisions.comment.clear()

    def undo(self) -> None:
        """Take back the last decision or confirmation of this reviewer."""
        reviewer = self.decisions.reviewer.text()
        if self.store is not None and self.status.attempt(lambda: self.store.select(self.store.undo(reviewer=reviewer))):
            self.status.say(tr("Taken back: {units}.").format(units=", ".join(self.store.selected)))

    # engine runs and exports

    def ask_report(self) -> None:
        """Ask for a file and write the report with the engine."""
        if self.store is None:
            return
        name, _ = QFileDialog.getSaveFileName(
            self, tr("Report"), str(self.store.path.with_suffix(".pdf")), tr("PDF (*.pdf);;Web page (*.html)")
        )
        if name:
            pair = self.store.pair
            language = QgsApplication.instance().locale()
            arguments = ["report", str(self.store.path), "--output", name, "--language", language]
            arguments += ["--from", pair.epoch_from, "--to", pair.epoch_to, "--datum", self.store.datum]
            self.start_engine(tr("Writing the report"), arguments, tr("Report written to {name}.").format(name=name))

    def ask_alarms(self) -> None:
        """Ask for threshold and file and export the alarm list."""
        if self.store is None:
            return
        shown = self.filters.threshold.value() or 10.0
        threshold, chosen = QInputDialog.getDouble(self, tr("Alarm list"), tr("Threshold (cm)"), shown, 0, 1000, 1)
        if not chosen:
            return
        name, _ = QFileDialog.getSaveFileName(
            self, tr("Alarm list"), str(self.store.path.with_name("alarms.csv")), tr("CSV (*.csv);;GeoJSON (*.geojson)")
        )
        if name:
            self.export_alarms(Path(name), threshold / 100)

    def export_alarms(self, path: Path, threshold: float) -> None:
        """Write units displaced by more than a threshold in metres, rejected ones left out."""
        store, counted = self.store, []
        if self.status.attempt(lambda: counted.append(write_alarms(store.path, path, threshold, pair=store.pair, datum=store.datum))):
            self.status.say(tr("{count} units written to {name}.").format(count=counted[0], name=path.name))

    def start_engine(self, title: str, arguments: list[str], success: str) -> None:
        """Run the engine in the background; show what it changed and say ``success``, or why it failed."""

        def done(outputs: dict[str, Any] | None, message: str) -> None:
            self._tasks.remove(task)
            if outputs is None:
                self.status.say(message, bad=True)
            elif self.store is not None and self.corrections is not None:
                self.store.open_index()
                self.corrections.reload()
                self.status.say(success)

        task = EngineTask(title, arguments, done)
        self._tasks.append(task)
        QgsApplication.taskManager().addTask(task)
        self.status.say(tr("{title}…").format(title=title))
