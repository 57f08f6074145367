"""The dock in which an engineer reviews displacements: table, pages of the unit and decisions in step with the map."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from qgis.core import Qgis, QgsApplication, QgsPointXY, QgsPrintLayout, QgsProject, QgsSettings, QgsVectorLayer
from qgis.gui import QgsDockWidget, QgsMapCanvas, QgsMapTool
from qgis.PyQt.QtCore import QSize, Qt, QTimer
from qgis.PyQt.QtGui import QAction, QCloseEvent, QKeyEvent, QResizeEvent
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
from qgis.utils import iface

from ..algorithms.support.layers import follow_unit
from ..algorithms.support.lengths import length_format
from ..algorithms.support.translation import tr
from ..core.report.alarms import write_alarms
from ..core.results.field_checks import foreign_contents
from ..core.review.decisions import Decision
from .engine_task import EngineTask
from .keyboard import reach_all
from .print_map import make_page
from .review_corrections import ReviewCorrections
from .review_details import counts_html
from .review_exports import ReviewExports
from .review_map import ReviewMap
from .review_panels import MOST_METRES, SPACING, ComparisonChoice, DecisionPanel, FilterPanel, StatusLine, YieldingLabel
from .review_pick import ClickTool, PickTool
from .review_store import ReviewStore, Topic
from .review_table import ReviewModel, ReviewTable
from .review_tabs import UnitTabs
from .review_text import decision_label
from .start_page import StartPage
from .view_3d import open_view

FILTER_MAP_SETTING = "tetratrack/review_filter_map"
FOLLOW_SETTING = "tetratrack/review_follow"
MOST_NAMES = 60
"""Letters of the names of units that a message holds."""
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
        self._window: Any = None
        self._others = QTimer(self)
        self._others.setInterval(OTHERS_MILLISECONDS)
        self._others.timeout.connect(self.take_in)
        self._pick_tool = PickTool(canvas)
        self._pick_tool.picked.connect(self.pick_at)
        self._build()
        canvas.mapToolSet.connect(self._tool_chosen)
        self.project.distanceUnitsChanged.connect(self._unit_chosen)

    # opening and closing

    def open(self, path: str | Path) -> bool:
        """Open a result file; False, with the reason in the status line, when it cannot be read."""
        opened: list[ReviewStore] = []

        def read() -> None:
            with foreign_contents(Path(path)):
                opened.append(ReviewStore(path))

        if self.status.busy or not self.status.attempt(read):
            return False
        with self.status.working():
            self._show(opened[0])
        return True

    def _show(self, store: ReviewStore) -> None:
        self._close_store()
        self.start.footprints.clear()
        # the new store shows all units; with none open the filters tell nobody
        self.filters.clear()
        # while it opens its layers the window draws itself, as one without a result
        review_map = ReviewMap(store, self.canvas, self.project, self)
        self.store, self.map = store, review_map
        self.model = self.table.show_store(store)
        self.tabs.show_store(store)
        store.observe(self._on_store)
        self.map.filtered = self.filters.on_map.isChecked()
        self.map.vanished.connect(self._layers_vanished)
        self.corrections = ReviewCorrections(self.map, self.tabs, self.decisions, self.status, self.start_engine)
        self.corrections.fill_menu(self._correction_menu)
        self.comparison.show_store(store)
        self._pages.setCurrentIndex(1)
        self._on_store("rows")
        self._set_pick()
        self._others.start()
        self.status.say(
            str(store.path.name)
            if store.writable
            else tr("{name} is read-only: you can look, but decisions cannot be stored.").format(name=store.path.name),
            bad=not store.writable,
        )

    def choose_file(self) -> None:
        """Ask for a result file."""
        name, _ = QFileDialog.getOpenFileName(self, tr("Open a result"), "", tr("GeoPackage (*.gpkg)"))
        if name:
            self.open(name)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Everything is stored already; layers leave the project."""
        self._close_store()
        self.start.footprints.clear()
        super().closeEvent(event)

    def _layers_vanished(self) -> None:
        """The user removed the layers, or opened another project: the review ends and says so."""
        if self.store is None:
            return
        name = self.store.path.name
        self._close_store()
        self.status.say(tr("{name} was closed with its layers. Every decision is stored: open it again to go on.").format(name=name))

    def _close_store(self) -> None:
        self._others.stop()
        wanted = self.pick.isChecked()
        self.canvas.unsetMapTool(self._pick_tool)
        # leaving with the result is not the user's choice of another tool
        self.pick.setChecked(wanted)
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
        start, body = StartPage(self.canvas, self), QWidget(self)
        start.open_wanted.connect(self.choose_file)
        start.run_wanted.connect(self.run_survey)
        self.start = start
        self._pages = QStackedWidget(self)
        self._pages.addWidget(start)
        self._pages.addWidget(body)
        self.setWidget(self._pages)
        self._counts, answer = YieldingLabel(body), QLabel(body)
        self._counts.setObjectName("review_counts")
        self._counts.setTextFormat(Qt.TextFormat.RichText)
        answer.setObjectName("review_status")
        answer.setTextInteractionFlags(Qt.TextInteractionFlag.TextBrowserInteraction)
        answer.setOpenExternalLinks(True)
        self.status = StatusLine(answer, start.status)
        toolbar = self._toolbar(body)
        self.comparison = ComparisonChoice(self.status, body)
        self.filters = FilterPanel(body)
        self.filters.on_map.setChecked(QgsSettings().value(FILTER_MAP_SETTING, False, type=bool))
        self.filters.changed.connect(self._filter)
        self.filters.area_wanted.connect(self.set_area)
        self.filters.on_map.toggled.connect(self._filter_map)
        self._splitter = QSplitter(Qt.Orientation.Vertical, body)
        self._splitter.setChildrenCollapsible(False)
        self.table, self.tabs = ReviewTable(self._splitter), UnitTabs(self.status, self._splitter)
        self.tabs.points_wanted.connect(self._read_points)
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
        answer.setWordWrap(True)
        page.addWidget(self._counts)
        page.addWidget(answer)
        reach_all(self)

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
        self.pick = self._action(bar, "/mActionSelectRectangle.svg", tr("A click on the map picks the unit or arrow there"), self._set_pick)
        self.pick.setCheckable(True)
        self.pick.setChecked(True)
        bar.addSeparator()
        pencil = QToolButton(bar)
        pencil.setIcon(QgsApplication.getThemeIcon("/mActionToggleEditing.svg"))
        pencil.setToolTip(tr("Correct a unit"))
        pencil.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self._correction_menu = QMenu(pencil)
        pencil.setMenu(self._correction_menu)
        bar.addWidget(pencil)
        self._action(bar, "/mActionNewReport.svg", tr("Write the report…"), self.ask_report)
        self._action(bar, "/processingAlgorithm.svg", tr("Report with more choices…"), self.choose_report)
        self._action(bar, "/mActionNewLayout.svg", tr("A page to print, with the map as it stands"), self.print_map)
        self._action(bar, "/mActionSharingExport.svg", tr("Export the alarm list…"), self.ask_alarms)
        self.exports = ReviewExports(bar, lambda: self.store, self.view_3d)
        return bar

    def _action(self, bar: QToolBar, icon: str, text: str, run: Callable[[], Any]) -> QAction:
        action = bar.addAction(QgsApplication.getThemeIcon(icon), text)
        action.triggered.connect(lambda checked=False: run())
        return action

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Escape ends picking here as well: views and table have the focus as often as the map."""
        if event.key() == Qt.Key.Key_Escape and self.corrections is not None:
            self.corrections.leave()
        super().keyPressEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Table above the views in a tall dock, beside them in a wide one."""
        wide = self.width() > 1.5 * self.height()
        self._splitter.setOrientation(Qt.Orientation.Horizontal if wide else Qt.Orientation.Vertical)
        super().resizeEvent(event)

    # store to window

    def _on_store(self, topic: Topic) -> None:
        if self.store is None or self.model is None or self.map is None:
            return
        place = self.table.verticalScrollBar().value()
        if topic in ("rows", "order"):
            self.model.reset()
        if topic == "reviews":
            self.model.refresh()
        if topic in ("rows", "reviews", "order"):
            self.map.show_pair()
        if topic in ("rows", "order", "selection"):
            self.table.follow()
        if topic == "rows":
            # what others did meanwhile must not carry the list away under the reviewer's eyes
            self.table.verticalScrollBar().setValue(place)
        if topic == "selection":
            self.map.follow()
            if self.follow.isChecked() and self.isVisible():
                self.map.zoom()
        if topic in ("rows", "selection", "reviews"):
            self.tabs.show_unit()
        if topic != "selection":
            self._counts.setText(counts_html(self.store, self.palette()))

    def take_in(self) -> None:
        found: list[str] = []
        store, shown = self.store, self.map
        if store is not None and shown is not None and self.isVisible() and not self.status.busy:
            selected = store.selected

            def look() -> None:
                found.append(store.refresh())
                if "run" in found:
                    self.comparison.show_store(store)

            # a file locked for a moment is read at the next turn
            self.status.attempt(look, quiet=True)
            if "corrections" in found or "run" in found:
                shown.reload()
                store.select(selected)
        if any(found):
            others = {
                "decisions": tr("Decisions of another reviewer were taken in."),
                "corrections": tr("Corrections of another reviewer were taken in."),
                "run": tr("A run replaced the result: its numbers are shown now."),
            }
            self.status.say(others[found[0]])

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
            rings = self.map.polygon_rings(layer)
            if not rings:
                self.status.say(tr("The active layer holds no polygon."), bad=True)
                return
            self.store.set_filter(area=rings)
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

    def pick_at(self, point: QgsPointXY, adds: bool = False) -> None:
        """Select the unit at a place of the canvas; one beside all units selects nothing."""
        if self.store is None or self.map is None:
            return
        unit = self.map.unit_at(point)
        before = self.store.selected if adds else ()
        chosen = [other for other in before if other != unit]
        self.store.select([*chosen, unit] if unit is not None else before)

    def _set_pick(self) -> None:
        if self.pick.isChecked() and self.store is not None:
            self.canvas.setMapTool(self._pick_tool)
        else:
            self.canvas.unsetMapTool(self._pick_tool)

    def _tool_chosen(self, tool: QgsMapTool | None) -> None:
        """Show whether clicks pick; clicks for a correction only interrupt that."""
        if not isinstance(tool, ClickTool):
            self.pick.setChecked(tool is self._pick_tool)

    def _unit_chosen(self) -> None:
        """Lengths in the unit that the project now has, everywhere."""
        follow_unit(self.project)
        self.filters.show_lengths()
        self._on_store("rows")

    def _filter(self, changes: dict[str, Any]) -> None:
        if self.store is not None:
            self.store.set_filter(**changes)

    def _filter_map(self, wanted: bool) -> None:
        QgsSettings().setValue(FILTER_MAP_SETTING, wanted)
        if self.map is not None:
            self.map.filtered = wanted
            self.map.show_pair()

    def _set_follow(self) -> None:
        QgsSettings().setValue(FOLLOW_SETTING, self.follow.isChecked())

    # deciding

    def run_command(self, command: str) -> None:
        """What a single key in the table or a button asks for."""
        acts: dict[str, Callable[[], None]] = {
            "accepted": partial(self.decide, "accepted"),
            "rejected": partial(self.decide, "rejected"),
            "inspect": partial(self.decide, "inspect"),
            "confirm": self.confirm,
            "undo": self.undo,
            "zoom": self.zoom,
            "next": partial(self.step, 1, undecided=True),
            "previous": partial(self.step, -1, undecided=True),
        }
        acts[command]()

    def decide(self, decision: Decision) -> None:
        """Store a decision on the selected units."""
        store = self.store
        if store is None or not self._can_act(store):
            return
        reviewer, comment = self.decisions.reviewer.text(), self.decisions.comment.text().strip()
        if self.status.attempt(lambda: store.decide(decision, reviewer=reviewer, comment=comment)):
            self.status.say(tr("{units}: {decision}, stored.").format(units=_named(store.selected), decision=decision_label(decision)))
            self.decisions.comment.clear()

    def _can_act(self, store: ReviewStore) -> bool:
        """Whether there is a unit to decide on and a name to decide in, with the reason said where there is none."""
        reason = ""
        if not store.selected:
            reason = tr("Select a unit first.")
        elif not self.decisions.reviewer.text().strip():
            reason = tr("Enter your name or initials first: they stand beside every decision.")
            self.decisions.reviewer.setFocus()
        if reason:
            self.status.say(reason, bad=True)
        return not reason

    def confirm(self) -> None:
        """Confirm another reviewer's decisions on the selected units."""
        reviewer, comment = self.decisions.reviewer.text(), self.decisions.comment.text().strip()
        store = self.store
        if store is not None and self._can_act(store) and self.status.attempt(lambda: store.confirm(reviewer=reviewer, comment=comment)):
            self.status.say(tr("Confirmed."))
            self.decisions.comment.clear()

    def undo(self) -> None:
        """Take back the last decision or confirmation of this reviewer."""
        reviewer, store = self.decisions.reviewer.text(), self.store
        if store is not None and self.status.attempt(lambda: store.select(store.undo(reviewer=reviewer))):
            self.status.say(tr("Taken back: {units}.").format(units=_named(store.selected)))

    def _read_points(self) -> None:
        if self.corrections is not None:
            self.corrections.ask_index()

    # engine runs and exports

    def ask_report(self) -> None:
        """Ask for a file and write the report with the engine."""
        if self.store is None:
            return
        name, _ = QFileDialog.getSaveFileName(
            self, tr("Report"), str(self.store.path.with_suffix(".html")), tr("Web page (*.html);;PDF (*.pdf)")
        )
        if name:
            pair = self.store.pair
            language = QgsApplication.instance().locale()
            arguments = ["report", str(self.store.path), "--output", name, "--language", language]
            arguments += ["--from", pair.epoch_from, "--to", pair.epoch_to, "--datum", self.store.datum]
            self.start_engine(tr("Writing the report"), arguments, tr("Report written to {name}.").format(name=name), written=Path(name))

    def run_survey(self, survey: str, result: str) -> None:
        """Run a survey in the window of *Monitor a survey*, and open what comes of it."""
        dialog = self._algorithm_window("monitorsurvey", {"SURVEY": survey, "OUTPUT": result})

        def ended(successful: bool, outputs: dict[str, Any]) -> None:
            if successful and Path(result).is_file():
                self.open(result)

        dialog.algorithmFinished.connect(ended)
        dialog.runButton().click()

    def view_3d(self) -> None:
        """Show bodies and arrows of the result in QGIS's 3D view."""
        from qgis.utils import iface

        store = self.store
        if store is not None and iface is not None:
            self.status.attempt(lambda: open_view(iface, store.path, self.project))

    def choose_report(self) -> None:
        """Open the report's own window: axis, width, sections and number of units can be set there."""
        if self.store is None:
            return
        pair = self.store.pair
        known: dict[str, Any] = {"INPUT": str(self.store.path), "FROM": pair.epoch_from, "TO": pair.epoch_to}
        known |= {"DATUM": ("", "stable", "control").index(self.store.datum), "OUTPUT": str(self.store.path.with_suffix(".html"))}
        self._algorithm_window("displacementreport", known)

    def _algorithm_window(self, name: str, parameters: dict[str, Any]) -> Any:
        from qgis import processing

        # kept, or its Python half would be gone once the caller ends
        self._window = processing.createAlgorithmDialog(f"tetratrack:{name}", parameters)
        self._window.show()
        return self._window

    def print_map(self) -> QgsPrintLayout | None:
        """Make a page to print of the map as it stands, and open it."""
        if self.store is None:
            return None
        layout = make_page(self.project, self.canvas, self.store)
        if iface is not None and self.project is QgsProject.instance():
            iface.openLayoutDesigner(layout)
        self.status.say(tr("The page {name} is in the project's layouts.").format(name=layout.name()))
        return layout

    def ask_alarms(self) -> None:
        """Ask for threshold and file and export the alarm list."""
        if self.store is None:
            return
        lengths = length_format()
        shown, most = (metres * lengths.factor for metres in (self.filters.least() or 0.1, MOST_METRES))
        question = tr("Threshold ({unit})").format(unit=lengths.suffix)
        threshold, chosen = QInputDialog.getDouble(self, tr("Alarm list"), question, shown, 0, most, lengths.decimals)
        if not chosen:
            return
        name, _ = QFileDialog.getSaveFileName(
            self, tr("Alarm list"), str(self.store.path.with_name("alarms.csv")), tr("CSV (*.csv);;GeoJSON (*.geojson)")
        )
        if name:
            self.export_alarms(Path(name), threshold / lengths.factor)

    def export_alarms(self, path: Path, threshold: float) -> None:
        """Write units displaced by more than a threshold in metres, rejected ones left out."""
        store = self.store
        counted: list[int] = []
        if store is None:
            return
        if self.status.attempt(lambda: counted.append(write_alarms(store.path, path, threshold, pair=store.pair, datum=store.datum))):
            self.status.say(tr("Units written to {name}: %n.", counted[0]).format(name=path.name))

    def start_engine(self, title: str, arguments: list[str], success: str, written: Path | None = None) -> None:
        """Run the engine in the background; show what it changed and say ``success`` with a link to the file written, or why it failed."""

        def done(outputs: dict[str, Any] | None, message: str) -> None:
            self._tasks.remove(task)
            if outputs is None:
                self.status.say(message, bad=True)
            elif self.store is not None and self.corrections is not None:
                self.store.open_index()
                if written is None:
                    self.corrections.reload()
                self.status.say(success, link=written)

        task = EngineTask(title, arguments, done)
        # the last steps are told after the end
        task.progressChanged.connect(lambda percent: self.status.say(f"{title}… {percent:.0f} %") if task in self._tasks else None)
        self._tasks.append(task)
        QgsApplication.taskManager().addTask(task)
        self.status.say(tr("{title}…").format(title=title))


def _named(units: Sequence[str]) -> str:
    """Units by their names, or many of them by how many they are."""
    names = ", ".join(units)
    return names if len(names) < MOST_NAMES else tr("%n units", len(units))
