"""The dock in which an engineer reviews displacements: table, views, series, decisions and corrections in step with the map."""

from __future__ import annotations

import getpass
import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from qgis.core import Qgis, QgsApplication, QgsProject, QgsSettings, QgsVectorLayer
from qgis.gui import QgsCheckableComboBox, QgsDockWidget, QgsFilterLineEdit, QgsMapCanvas
from qgis.PyQt.QtCore import QSize, Qt, QTimer
from qgis.PyQt.QtGui import QAction, QCloseEvent, QResizeEvent
from qgis.PyQt.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFileDialog,
    QHBoxLayout,
    QInputDialog,
    QLabel,
    QLineEdit,
    QMenu,
    QSizePolicy,
    QSplitter,
    QStackedWidget,
    QToolBar,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ..core.alarms import write_alarms
from ..core.errors import TetratrackError
from ..core.outline import LEG_LENGTH_RATIO
from ..core.reviews import Decision
from ..core.schema import CLASSES
from ..core.unit_edits import (
    NewPose,
    add_placeholder,
    delete_unit,
    merge_units,
    pose_from_features,
    read_edits,
    set_pose,
    split_unit,
    store_picks,
    undo_edit,
)
from .engine_task import EngineTask
from .review_details import counts_html
from .review_map import ClickTool, ReviewMap
from .review_store import ReviewStore, Topic
from .review_table import ReviewModel, ReviewTable
from .review_tabs import UnitTabs
from .review_text import DECISION_COLOURS, datum_label, decision_colour, decision_label, edit_label, kind_label, length_format
from .translation import tr

FloatArray = NDArray[np.float64]

REVIEWER_SETTING = "tetratrack/reviewer"
FOLLOW_SETTING = "tetratrack/review_follow"
OTHERS_MILLISECONDS = 2000
"""How often the decisions of other reviewers are taken in."""
PICK_SD_SPACINGS = 1.0
"""Standard deviation of one picked coordinate in point spacings: a pick lands on the nearest point."""


@dataclass
class Picking:
    """Clicks gathered so far for a correction; ``epoch`` is 0 for the earlier, 1 for the later epoch."""

    kind: str
    epoch: int
    points: list[FloatArray]


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
        self._picking: Picking | None = None
        self._tool: ClickTool | None = None
        self._old_tool: Any = None
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
            self._say(str(error), bad=True)
            return False
        self._close_store()
        self.store = store
        self.model = self.table.show_store(store)
        self.tabs.show_store(store)
        store.observe(self._on_store)
        self.map = ReviewMap(store, self.canvas, self.project, self)
        self._fill_choices()
        self._pages.setCurrentIndex(1)
        self._on_store("rows")
        self._others.start()
        for action in self._writing_actions:
            action.setEnabled(store.writable)
        self._say(
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
        self.end_picking()
        if self.map is not None:
            self.map.remove()
            self.map.deleteLater()
        if self.store is not None:
            self.store.forget(self._on_store)
        self.tabs.show_store(None)
        self.store = self.map = self.model = None
        self._pages.setCurrentIndex(0)

    # building the window

    def _build(self) -> None:
        body = QWidget(self)
        page = QVBoxLayout(body)
        page.setContentsMargins(4, 2, 4, 2)
        page.setSpacing(3)
        self._pages = QStackedWidget(self)
        self._pages.addWidget(self._start_page())
        self._pages.addWidget(body)
        self.setWidget(self._pages)
        page.addWidget(self._toolbar())
        page.addLayout(self._choices())
        page.addLayout(self._filters())
        self._splitter = QSplitter(Qt.Orientation.Vertical, body)
        self._splitter.setChildrenCollapsible(False)
        self.table = ReviewTable(self._splitter)
        self.table.setMinimumHeight(90)
        self.table.command.connect(self.run_command)
        self._splitter.addWidget(self.table)
        self.tabs = UnitTabs(self._splitter)
        self.tabs.picked.connect(self.add_pick)
        self._splitter.addWidget(self.tabs)
        self._splitter.setStretchFactor(0, 2)
        self._splitter.setStretchFactor(1, 3)
        page.addWidget(self._splitter, 1)
        page.addLayout(self._decisions())
        self._counts = QLabel(body)
        self._counts.setObjectName("review_counts")
        self._counts.setTextFormat(Qt.TextFormat.RichText)
        self._counts.setWordWrap(True)
        page.addWidget(self._counts)
        self._status = QLabel(body)
        self._status.setObjectName("review_status")
        self._status.setWordWrap(True)
        self._status.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        page.addWidget(self._status)
        self._start_status = QLabel(self._pages.widget(0))
        self._start_status.setWordWrap(True)
        self._pages.widget(0).layout().insertWidget(3, self._start_status)

    def _start_page(self) -> QWidget:
        page = QWidget(self)
        layout = QVBoxLayout(page)
        text = QLabel(tr("Open the result.gpkg of a survey with two epochs or more to review its displacements."), page)
        text.setWordWrap(True)
        button = QToolButton(page)
        button.setText(tr("Open result…"))
        button.setIcon(QgsApplication.getThemeIcon("/mActionFileOpen.svg"))
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.clicked.connect(self.choose_file)
        layout.addStretch(1)
        layout.addWidget(text)
        layout.addWidget(button)
        layout.addStretch(2)
        return page

    def _toolbar(self) -> QToolBar:
        bar = QToolBar(self)
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
        edit = QToolButton(bar)
        edit.setIcon(QgsApplication.getThemeIcon("/mActionToggleEditing.svg"))
        edit.setToolTip(tr("Correct a unit"))
        edit.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        edit.setMenu(self._edit_menu(edit))
        bar.addWidget(edit)
        self._action(bar, "/mActionNewReport.svg", tr("Write the report…"), self.ask_report)
        self._action(bar, "/mActionSharingExport.svg", tr("Export the alarm list…"), self.ask_alarms)
        return bar

    def _action(self, bar: QToolBar, icon: str, text: str, run: Callable[[], Any]) -> QAction:
        action = bar.addAction(QgsApplication.getThemeIcon(icon), text)
        action.triggered.connect(lambda checked=False: run())
        return action

    def _edit_menu(self, parent: QWidget) -> QMenu:
        menu = QMenu(parent)
        entries = (
            (tr("Fit again after a click on the unit (earlier epoch)"), partial(self.start_picking, "refit", 0)),
            (tr("Fit again after a click on the unit (later epoch)"), partial(self.start_picking, "refit", 1)),
            (tr("Pin by three joints of legs (earlier epoch)"), partial(self.start_picking, "pin", 0)),
            (tr("Pin by three joints of legs (later epoch)"), partial(self.start_picking, "pin", 1)),
            (tr("Pick feature points beside the fit (earlier epoch)"), partial(self.start_picking, "pick", 0)),
            (tr("Pick feature points beside the fit (later epoch)"), partial(self.start_picking, "pick", 1)),
            (tr("Placeholder for a unit not found"), partial(self.start_picking, "placeholder", 1)),
            (tr("Merge the two selected units"), self.merge),
            (tr("Split at the later epoch: two units taken for one"), self.split),
            (tr("Delete: not a unit"), self.delete),
            (tr("Take back the last correction"), self.undo_correction),
            (tr("Read the points around the units…"), self.ask_index),
        )
        self._writing_actions = []
        for text, run in entries:
            action = menu.addAction(text)
            action.triggered.connect(lambda checked=False, run=run: run())
            self._writing_actions.append(action)
        return menu

    def _choices(self) -> QHBoxLayout:
        row = QHBoxLayout()
        self.pair = QComboBox(self)
        self.pair.setToolTip(tr("Epochs compared"))
        self.datum = QComboBox(self)
        self.datum.setToolTip(tr("Reference of the displacements"))
        for box in (self.pair, self.datum):
            box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
            box.setMinimumContentsLength(12)
            box.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            row.addWidget(box)
        self.pair.activated.connect(self._choose_pair)
        self.datum.activated.connect(self._choose_datum)
        return row

    def _filters(self) -> QVBoxLayout:
        rows = QVBoxLayout()
        rows.setSpacing(3)
        first, second = QHBoxLayout(), QHBoxLayout()
        self.kinds = QgsCheckableComboBox(self)
        self.kinds.setDefaultText(tr("All classes"))
        self.kinds.setToolTip(tr("Classes shown"))
        self.kinds.setMinimumWidth(90)
        for kind in (*CLASSES, "unseen"):
            self.kinds.addItemWithCheckState(kind_label(kind), Qt.CheckState.Unchecked, kind)
        self.kinds.checkedItemsChanged.connect(lambda items: self._filter(kinds=frozenset(self.kinds.checkedItemsData())))
        self.threshold = QDoubleSpinBox(self)
        self.threshold.setRange(0, 1000)
        self.threshold.setDecimals(1)
        self.threshold.setPrefix("≥ ")
        self.threshold.setSuffix(" cm")
        self.threshold.setToolTip(tr("Least 3D displacement shown; lost, new and relocated units are always shown"))
        self.threshold.valueChanged.connect(lambda value: self._filter(threshold=value / 100))
        self.area = QToolButton(self)
        self.area.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
        self.area.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.area.setToolTip(tr("Area of the units shown"))
        menu = QMenu(self.area)
        menu.addAction(tr("Everywhere")).triggered.connect(lambda checked=False: self.set_area("everywhere"))
        menu.addAction(tr("In the map window")).triggered.connect(lambda checked=False: self.set_area("map"))
        menu.addAction(tr("In the active layer's polygons")).triggered.connect(lambda checked=False: self.set_area("polygon"))
        self.area.setMenu(menu)
        self.area.setText(tr("Everywhere"))
        self.undecided = QCheckBox(tr("Undecided only"), self)
        self.undecided.toggled.connect(lambda checked: self._filter(undecided=checked))
        self.text = QgsFilterLineEdit(self)
        self.text.setPlaceholderText(tr("Unit…"))
        self.text.setShowSearchIcon(True)
        self.text.textChanged.connect(lambda text: self._filter(text=text.strip()))
        first.addWidget(self.kinds, 1)
        first.addWidget(self.threshold)
        second.addWidget(self.text, 1)
        second.addWidget(self.area)
        second.addWidget(self.undecided)
        rows.addLayout(first)
        rows.addLayout(second)
        return rows

    def _decisions(self) -> QVBoxLayout:
        rows = QVBoxLayout()
        rows.setSpacing(3)
        buttons, words = QHBoxLayout(), QHBoxLayout()
        buttons.setSpacing(2)
        entries = (
            ("accepted", tr("Accept"), tr("The displacement is right (A)"), partial(self.decide, "accepted")),
            (
                "rejected",
                tr("Reject"),
                tr("The displacement is wrong: it leaves statistics, maps and report (R)"),
                partial(self.decide, "rejected"),
            ),
            ("inspect", tr("Inspect"), tr("Inspect on site (I)"), partial(self.decide, "inspect")),
            ("confirm", tr("Confirm"), tr("Confirm another reviewer's decision (C)"), self.confirm),
            ("undo", tr("Undo"), tr("Take back your last decision (U)"), self.undo),
        )
        for name, text, help_text, run in entries:
            button = QToolButton(self)
            button.setObjectName(f"review_{name}")
            button.setText(f"● {text}" if name in DECISION_COLOURS else text)
            if name in DECISION_COLOURS:
                button.setStyleSheet(f"color: {decision_colour(name, self.palette()).name()};")
            button.setToolTip(help_text)
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            button.clicked.connect(lambda checked=False, run=run: run())
            buttons.addWidget(button)
        self.comment = QLineEdit(self)
        self.comment.setPlaceholderText(tr("Comment, stored with the decision"))
        self.reviewer = QLineEdit(QgsSettings().value(REVIEWER_SETTING, "", type=str) or _login(), self)
        self.reviewer.setPlaceholderText(tr("Reviewer"))
        self.reviewer.setToolTip(tr("Your name or initials, stored with every decision"))
        self.reviewer.setMaximumWidth(130)
        self.reviewer.editingFinished.connect(lambda: QgsSettings().setValue(REVIEWER_SETTING, self.reviewer.text().strip()))
        words.addWidget(self.comment, 1)
        words.addWidget(self.reviewer)
        rows.addLayout(words)
        rows.addLayout(buttons)
        return rows

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

    def _say(self, message: str, *, bad: bool = False) -> None:
        for label in (self._status, self._start_status):
            label.setStyleSheet(f"color: {decision_colour('rejected', self.palette()).name()};" if bad else "")
            label.setText(message)

    # window to store

    def _fill_choices(self) -> None:
        self.pair.clear()
        for pair in self.store.pairs:
            self.pair.addItem(str(pair), pair)
        self._fill_datums()

    def _fill_datums(self) -> None:
        self.datum.clear()
        for datum in self.store.datums:
            self.datum.addItem(datum_label(datum), datum)
        self.datum.setCurrentIndex(self.datum.findData(self.store.datum))

    def _choose_pair(self, index: int) -> None:
        if self._try(lambda: self.store.set_pair(self.store.pairs[index])):
            self._fill_datums()

    def _choose_datum(self, index: int) -> None:
        self._try(lambda: self.store.set_datum(self.datum.itemData(index)))

    def _filter(self, **changes: Any) -> None:
        if self.store is not None:
            self.store.set_filter(**changes)

    def set_area(self, kind: str) -> None:
        """Show units ``everywhere``, in the ``map`` window, or in the ``polygon`` features of the active layer."""
        if self.store is None or self.map is None:
            return
        if kind == "polygon":
            layer = self.canvas.currentLayer()
            if not isinstance(layer, QgsVectorLayer) or layer.geometryType() != Qgis.GeometryType.Polygon:
                self._say(tr("Make a polygon layer active first."), bad=True)
                return
            self._filter(area=self.map.polygon_rings(layer))
            self.area.setText(tr("In polygons"))
        elif kind == "map":
            self._filter(area=(self.map.extent_ring(),))
            self.area.setText(tr("In the map window"))
        else:
            self._filter(area=())
            self.area.setText(tr("Everywhere"))

    def step(self, by: int, *, undecided: bool = False) -> None:
        """Select the next or previous unit of the table."""
        if self.store is not None and self.store.step(by, undecided=undecided) is None:
            self._say(tr("No unit passes the filter."))

    def zoom(self) -> None:
        """Zoom the map to the current unit and flash it."""
        if self.map is not None:
            self.map.zoom()

    def zoom_to_all(self) -> None:
        """Show all units on the map."""
        if self.map is not None:
            self.map.zoom_to_all()

    def run_command(self, command: str) -> None:
        """What a single key in the table asks for."""
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
        if self._try(lambda: self.store.decide(decision, reviewer=self.reviewer.text(), comment=self.comment.text().strip())):
            self._say(
                tr("{units}: {decision}, stored.").format(
                    units=units if len(units) < 60 else len(self.store.selected), decision=decision_label(decision)
                )
            )
            self.comment.clear()

    def confirm(self) -> None:
        """Confirm another reviewer's decisions on the selected units."""
        if self.store is not None and self._try(
            lambda: self.store.confirm(reviewer=self.reviewer.text(), comment=self.comment.text().strip())
        ):
            self._say(tr("Confirmed."))
            self.comment.clear()

    def undo(self) -> None:
        """Take back the last decision or confirmation of this reviewer."""
        if self.store is not None and self._try(lambda: self.store.select(self.store.undo(reviewer=self.reviewer.text()))):
            self._say(tr("Taken back: {units}.").format(units=", ".join(self.store.selected)))

    def _take_in(self) -> None:
        changed: list[bool] = []
        if self.store is not None and self.isVisible():
            # a file locked for a moment is read at the next turn
            self._try(lambda: changed.append(self.store.refresh()), quiet=True)
        if any(changed):
            self._say(tr("Decisions of another reviewer were taken in."))

    def _set_follow(self) -> None:
        QgsSettings().setValue(FOLLOW_SETTING, self.follow.isChecked())

    def _try(self, act: Callable[[], Any], *, quiet: bool = False) -> bool:
        """Do something that may fail for a reason the user can act on; the reason goes to the status line."""
        try:
            act()
        except TetratrackError as error:
            if not quiet:
                self._say(str(error), bad=True)
            return False
        return True

    # corrections

    def start_picking(self, kind: str, epoch: int) -> None:
        """Gather clicks, on the map or in the views, for ``refit``, ``pin``, ``pick`` or ``placeholder``."""
        if self.store is None or self.map is None:
            return
        if kind != "placeholder" and self.store.current is None:
            self._say(tr("Select a unit first."), bad=True)
            return
        if kind in ("pin", "pick") and self.store.index is None:
            self._say(tr("The points around the units are needed: read them from the correction menu."), bad=True)
            return
        self.end_picking()
        self._picking = Picking(kind, epoch, [])
        self._tool = ClickTool(self.canvas)
        self._tool.clicked.connect(self._clicked_map)
        self._tool.left.connect(self.end_picking)
        self._old_tool = self.canvas.mapTool()
        self.canvas.setMapTool(self._tool)
        self.tabs.set_picking(epoch)
        self._say(
            {
                "refit": tr("Click the middle of the unit on the map or in a view; Escape ends."),
                "pin": tr("Click three joints where three legs meet, on the map or in the views; Escape ends."),
                "pick": tr("Click a joint where three legs meet; Escape ends."),
                "placeholder": tr("Click where the unit lies on the map; Escape ends."),
            }[kind]
        )

    def end_picking(self) -> None:
        """Back to the map tool used before."""
        self._picking = None
        self.tabs.set_picking(None)
        if self._tool is not None:
            self.canvas.unsetMapTool(self._tool)
            if self._old_tool is not None:
                self.canvas.setMapTool(self._old_tool)
            self._tool.deleteLater()
        self._tool = self._old_tool = None

    def _clicked_map(self, point: Any) -> None:
        place = self.map.to_survey(point) if self.map is not None else None
        if place is None or self._picking is None:
            return
        surface = self.surface_point(place.x(), place.y(), self._picking.epoch)
        if surface is not None:
            self.add_pick(surface)

    def surface_point(self, e: float, n: float, epoch: int) -> FloatArray | None:
        """The highest point of the cloud near a place of the map; where no points are read, that place at the nearest unit's height."""
        label = (self.store.pair.epoch_from, self.store.pair.epoch_to)[epoch]
        near = [row for row in self.store.rows if row.place is not None]
        nearest = min(near, key=lambda row: math.hypot(row.place[0] - e, row.place[1] - n))
        flat = np.array([e, n, nearest.place[2]])
        if self.store.index is None:
            return flat
        height = nearest.height or 2.0
        points = self.store.index.read(label, flat, 2 * height)
        close = points[np.hypot(points[:, 0] - e, points[:, 1] - n) < 0.04 * height]
        if len(close) == 0:
            if self._picking is not None and self._picking.kind in ("pin", "pick"):
                self._say(tr("There are no points here; click on the cloud."), bad=True)
                return None
            return flat
        return close[np.argmax(close[:, 2])]

    def add_pick(self, point: FloatArray) -> None:
        """Take one click into the correction that is going on."""
        if self._picking is None or self.store is None:
            return
        picking = self._picking
        picking.points.append(np.asarray(point, dtype=np.float64))
        if picking.kind == "pin" and len(picking.points) < 3:
            self._say(tr("{count} of 3 joints.").format(count=len(picking.points)))
            return
        act = {"refit": self._refit, "pin": self._pin, "pick": self._pick, "placeholder": self._placeholder}[picking.kind]
        self.end_picking()
        self._try(lambda: act(picking))

    def _epoch(self, picking: Picking) -> str:
        return (self.store.pair.epoch_from, self.store.pair.epoch_to)[picking.epoch]

    def _refit(self, picking: Picking) -> None:
        unit, epoch = self.store.current, self._epoch(picking)
        place = ",".join(f"{value:.3f}" for value in picking.points[0])
        arguments = ["refit", str(self.store.path), "--unit", unit, "--epoch", epoch, "--near", place, "--editor", self.reviewer.text()]
        self._start(tr("Fitting {unit} again").format(unit=unit), arguments, tr("{unit} was fitted again.").format(unit=unit))

    def _pin(self, picking: Picking) -> None:
        unit, epoch = self.store.current, self._epoch(picking)
        details = self.store.details(unit)
        shape = details.shapes.get(epoch) or next(iter(details.shapes.values()), None)
        if shape is None:
            self._say(tr("The unit has no pose in any epoch to take its size from."), bad=True)
            return
        centre, rotation, names, misfit = pose_from_features(picking.points, shape.radius, shape.gradient, shape.rotation)
        sd = self._pick_sd(epoch, shape.centre)
        # three picks of equal precision: the mean holds the centre, their distance from it the rotation
        turn = math.degrees(sd * math.sqrt(3) / float(np.linalg.norm(picking.points[0] - centre)))
        height = self.store.row(unit).height or shape.leg_length / LEG_LENGTH_RATIO
        pose = NewPose(centre, rotation, shape.radius, shape.gradient, height, np.full(3, sd), turn)
        set_pose(self.store.path, unit, epoch, pose, editor=self.reviewer.text(), comment=tr("pinned by three joints"))
        store_picks(self.store.path, unit, epoch, dict(zip(names, picking.points, strict=True)), editor=self.reviewer.text())
        self._reload()
        self._say(tr("{unit} pinned; the picks fit within {length}.").format(unit=unit, length=length_format().text(misfit)))

    def _pick(self, picking: Picking) -> None:
        unit, epoch = self.store.current, self._epoch(picking)
        features = {name: value[0] for name, value in self.store.details(unit).features.get(epoch, {}).items() if name != "centre"}
        if not features:
            self._say(tr("The unit was not found in this epoch: pin it by three joints instead."), bad=True)
            return
        name = min(features, key=lambda feature: float(np.linalg.norm(features[feature] - picking.points[0])))
        store_picks(self.store.path, unit, epoch, {name: picking.points[0]}, editor=self.reviewer.text())
        apart = float(np.linalg.norm(features[name] - picking.points[0]))
        self.tabs.show_unit()
        self._say(tr("{feature} picked, {length} from the fit.").format(feature=name, length=length_format().text(apart)))

    def _placeholder(self, picking: Picking) -> None:
        name = add_placeholder(
            self.store.path, self._epoch(picking), picking.points[0], editor=self.reviewer.text(), comment=self.comment.text()
        )
        self._say(tr("Placeholder {name} stored; it counts as a unit not found.").format(name=name))

    def _pick_sd(self, epoch: str, place: FloatArray) -> float:
        """Standard deviation of a picked coordinate, metres: the spacing of the points around the unit."""
        points = self.store.index.read(epoch, place, 1.0) if self.store.index is not None else np.empty((0, 3))
        # a surface of the cube's size holds n points: spacing = edge / sqrt(n)
        return PICK_SD_SPACINGS * 2.0 / math.sqrt(max(len(points), 1))

    def merge(self) -> None:
        """Make one unit of the two selected."""
        if self.store is None:
            return
        if len(self.store.selected) != 2:
            self._say(tr("Select the two units to merge."), bad=True)
            return
        keep, other = sorted(self.store.selected)
        if self._try(lambda: merge_units(self.store.path, keep, other, editor=self.reviewer.text(), comment=self.comment.text())):
            self._edited(keep, tr("{other} is now {keep}.").format(other=other, keep=keep))

    def split(self) -> None:
        """Make two units of the current one, from the later epoch on."""
        if self.store is None or self.store.current is None:
            self._say(tr("Select a unit first."), bad=True)
            return
        unit, names = self.store.current, []
        epoch, editor = self.store.pair.epoch_to, self.reviewer.text()
        if self._try(lambda: names.append(split_unit(self.store.path, unit, epoch, editor=editor))):
            self._edited(
                unit, tr("{unit} is called {name} from {epoch} on.").format(unit=unit, name=names[0], epoch=self.store.pair.epoch_to)
            )

    def delete(self) -> None:
        """Take the current unit out of the result."""
        if self.store is None or self.store.current is None:
            self._say(tr("Select a unit first."), bad=True)
            return
        unit = self.store.current
        if self._try(lambda: delete_unit(self.store.path, unit, editor=self.reviewer.text(), comment=self.comment.text())):
            self._edited(None, tr("{unit} was deleted; take it back from the correction menu.").format(unit=unit))

    def undo_correction(self) -> None:
        """Take back the last correction that stands."""
        if self.store is None:
            return
        standing = [edit for edit in read_edits(self.store.path) if not edit.undone]
        if not standing:
            self._say(tr("There is no correction to take back."))
        elif self._try(lambda: undo_edit(self.store.path, standing[-1].number, editor=self.reviewer.text())):
            last = standing[-1]
            self._edited(last.unit_id, tr("Taken back: {kind} {unit}.").format(kind=edit_label(last.kind), unit=last.unit_id))

    def _reload(self) -> None:
        """Take in what a correction changed in the file."""
        self.store.reload()
        self.map.reload()

    def _edited(self, unit: str | None, message: str) -> None:
        self._reload()
        if unit is not None:
            self.store.select([unit])
        self._say(message)

    # engine runs and exports

    def ask_index(self) -> None:
        """Ask for the survey's description and read the points around the units with the engine."""
        if self.store is None:
            return
        name, _ = QFileDialog.getOpenFileName(self, tr("Survey description"), str(self.store.path.parent), tr("Survey (*.toml)"))
        if name:
            self._start(tr("Reading points around units"), ["unit-points", name, str(self.store.path)], tr("Points read."))

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
            self._start(tr("Writing the report"), arguments, tr("Report written to {name}.").format(name=name))

    def ask_alarms(self) -> None:
        """Ask for threshold and file and export the alarm list."""
        if self.store is None:
            return
        threshold, chosen = QInputDialog.getDouble(self, tr("Alarm list"), tr("Threshold (cm)"), self.threshold.value() or 10.0, 0, 1000, 1)
        if not chosen:
            return
        name, _ = QFileDialog.getSaveFileName(
            self, tr("Alarm list"), str(self.store.path.with_name("alarms.csv")), tr("CSV (*.csv);;GeoJSON (*.geojson)")
        )
        if name:
            self.export_alarms(Path(name), threshold / 100)

    def export_alarms(self, path: Path, threshold: float) -> None:
        """Write units displaced by more than a threshold in metres, rejected ones left out."""
        counted: list[int] = []
        if self._try(lambda: counted.append(write_alarms(self.store.path, path, threshold, pair=self.store.pair, datum=self.store.datum))):
            self._say(tr("{count} units written to {name}.").format(count=counted[0], name=path.name))

    def _start(self, title: str, arguments: list[str], success: str) -> None:
        def done(outputs: dict[str, Any] | None, message: str) -> None:
            self._tasks.remove(task)
            if outputs is None:
                self._say(message, bad=True)
            elif self.store is not None:
                self.store.open_index()
                self._reload()
                self._say(success)

        task = EngineTask(title, arguments, done)
        self._tasks.append(task)
        QgsApplication.taskManager().addTask(task)
        self._say(tr("{title}…").format(title=title))


def _login() -> str:
    """The user's login name; empty where the system has none."""
    try:
        return getpass.getuser()
    except (OSError, KeyError):
        return ""
