"""Pages of the review dock on one unit: views, series, numbers and history."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtWidgets import QCheckBox, QHBoxLayout, QSpinBox, QTabWidget, QTextBrowser, QToolButton, QVBoxLayout, QWidget

from ..algorithms.support.translation import tr
from ..core.common.arrays import FloatArray
from ..core.model.outline import PlacedShape
from ..core.results.field_checks import foreign_contents
from ..core.results.schema import FEATURES
from ..core.results.unit_rows import series, shift_to_datum
from ..core.review.corrections import read_picks
from .review_details import history_html, numbers_html
from .review_panels import StatusLine
from .review_plots import UnitScene, UnitView
from .review_store import ReviewStore
from .review_text import datum_label
from .series_view import SeriesView


class UnitTabs(QTabWidget):
    """What is known of the store's current unit; only the page in front is brought up to date.

    ``picked`` carries the (e, n, h) of a point clicked in a view while picking is on; ``points_wanted`` asks for the points around the
    units, which are not read yet.
    """

    picked = pyqtSignal(object)
    points_wanted = pyqtSignal()

    def __init__(self, status: StatusLine, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._status = status
        self._store: ReviewStore | None = None
        self.setDocumentMode(True)
        self.addTab(self._views(), tr("Views"))
        # with large letters too, the views keep their least height and what is below them
        self.setMinimumHeight(max(180, self.tabBar().sizeHint().height() + self.widget(0).minimumSizeHint().height()))
        self.series = SeriesView(self)
        self.addTab(self.series, tr("Series"))
        self.numbers, self.history = QTextBrowser(self), QTextBrowser(self)
        for browser, name, title in ((self.numbers, "review_numbers", tr("Numbers")), (self.history, "review_history", tr("History"))):
            browser.setObjectName(name)
            browser.setOpenLinks(False)
            self.addTab(browser, title)
        self._show = (self._show_views, self._show_series, self._show_numbers, self._show_history)
        self.currentChanged.connect(lambda page: self.show_unit())

    def show_store(self, store: ReviewStore | None) -> None:
        """Show units of another store, from the next :meth:`show_unit` on; None for none."""
        self._store = store

    def show_unit(self) -> None:
        """Show the current unit on the page in front, or nothing and why, where its rows cannot be read."""
        store, show = self._store, self._show[self.currentIndex()]
        if store is None:
            return

        def read() -> None:
            with foreign_contents(store.path):
                show(store, store.current)

        if not self._status.attempt(read):
            show(store, None)

    def set_picking(self, epoch: int | None) -> None:
        """Pick points of the earlier (0) or later (1) epoch in the views; None ends it."""
        for view in (self.plan, self.section):
            view.set_picking(epoch)

    def _views(self) -> QWidget:
        page = QWidget(self)
        layout = QVBoxLayout(page)
        layout.setContentsMargins(0, 2, 0, 0)
        pictures, below = QHBoxLayout(), QHBoxLayout()
        pictures.setSpacing(2)
        self.plan, self.section = UnitView("plan", page), UnitView("section", page)
        for view in (self.plan, self.section):
            view.picked.connect(self._pick)
            pictures.addWidget(view, 1)
        self.along = QCheckBox(tr("Section along the displacement"), page)
        self.along.setChecked(True)
        self.azimuth = QSpinBox(page)
        self.azimuth.setRange(0, 359)
        self.azimuth.setWrapping(True)
        self.azimuth.setSuffix("°")
        self.azimuth.setEnabled(False)
        self.azimuth.setToolTip(tr("Direction of the section, from grid north; each outline is cut through its own centre"))
        self.along.toggled.connect(self._turn_section)
        self.azimuth.valueChanged.connect(lambda value: self._turn_section(self.along.isChecked()))
        self.read_points = QToolButton(page)
        self.read_points.setText(tr("Read the points…"))
        self.read_points.setToolTip(tr("Reads the points around the units from the tiles of the survey, for the views and for picking"))
        self.read_points.clicked.connect(lambda checked=False: self.points_wanted.emit())
        below.addWidget(self.along, 1)
        below.addWidget(self.read_points)
        below.addWidget(self.azimuth)
        layout.addLayout(pictures, 1)
        layout.addLayout(below)
        return page

    def _pick(self, point: FloatArray) -> None:
        """Tell what was clicked in the control frame of its epoch: the later one is drawn shifted into the datum shown."""
        later = self.plan.picking_epoch == 1
        self.picked.emit(point - self.plan.scene.shift if later else point)

    def _turn_section(self, along: bool) -> None:
        self.azimuth.setEnabled(not along)
        self.section.set_azimuth(None if along else math.radians(self.azimuth.value()))

    def _show_views(self, store: ReviewStore, unit: str | None) -> None:
        scene = scene_of(store, unit) if unit else UnitScene()
        for view in (self.plan, self.section):
            view.show_scene(scene)
        self.read_points.setVisible(store.index is None)
        if self.along.isChecked():
            self.azimuth.blockSignals(True)
            self.azimuth.setValue(round(math.degrees(scene.section_azimuth)) % 360)
            self.azimuth.blockSignals(False)

    def _show_series(self, store: ReviewStore, unit: str | None) -> None:
        if unit is None:
            self.series.show_series({}, None)
            return
        details, row = store.details(unit), store.row(unit)
        found = {name: series(details, store.epochs, store.datum, name) for name in FEATURES}
        self.series.show_series(found, row.detection_limit if row else None)

    def _show_numbers(self, store: ReviewStore, unit: str | None) -> None:
        self.numbers.setHtml(numbers_html(store, unit) if unit else "")

    def _show_history(self, store: ReviewStore, unit: str | None) -> None:
        self.history.setHtml(history_html(store, unit) if unit else "")


def scene_of(store: ReviewStore, unit: str) -> UnitScene:
    """Outlines, points, features and picks of a unit in the store's pair and datum."""
    details, pair, row = store.details(unit), store.pair, store.row(unit)
    labels = (pair.epoch_from, pair.epoch_to)
    shifts = (np.zeros(3), np.zeros(3) if row is None else shift_to_datum(row, details, pair))
    picks = read_picks(store.path, unit)

    def shown(label: str, shift: FloatArray) -> tuple[PlacedShape | None, dict[str, FloatArray], FloatArray]:
        shape = details.shapes.get(label)
        features = {name: value[0] + shift for name, value in details.features.get(label, {}).items()}
        places = np.array([row["geom"] for row in picks if row["epoch"] == label]).reshape(-1, 3) + shift
        return None if shape is None else replace(shape, centre=shape.centre + shift), features, places

    first, second = shown(labels[0], shifts[0]), shown(labels[1], shifts[1])
    scene = UnitScene(
        shapes=(first[0], second[0]),
        features=(first[1], second[1]),
        picks=(first[2], second[2]),
        labels=labels,
        datum=datum_label(store.datum),
        shift=shifts[1],
    )
    if scene.middle is None:
        return scene
    if store.index is None:
        return replace(scene, note=tr("points not read yet"))
    middle, size = scene.middle, scene.half_size
    before, after = (store.points_around(label, middle - shift, size) + shift for label, shift in zip(labels, shifts, strict=True))
    return replace(scene, points=(before, after))
