"""Pages of the review dock on one unit: views, series, numbers and history."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtWidgets import QCheckBox, QHBoxLayout, QSpinBox, QTabWidget, QTextBrowser, QVBoxLayout, QWidget

from ..core.displacement_rows import series
from ..core.schema import FEATURES
from ..core.unit_edits import read_picks
from .review_details import history_html, numbers_html
from .review_plots import SeriesView, UnitScene, UnitView
from .review_store import ReviewStore
from .translation import tr


class UnitTabs(QTabWidget):
    """What is known of the store's current unit; only the page in front is brought up to date.

    ``picked`` carries the (e, n, h) of a point clicked in a view while picking is on.
    """

    picked = pyqtSignal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._store: ReviewStore | None = None
        self.setDocumentMode(True)
        self.setMinimumHeight(180)
        self.addTab(self._views(), tr("Views"))
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
        """Show the current unit on the page in front."""
        if self._store is not None:
            self._show[self.currentIndex()](self._store, self._store.current)

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
            view.picked.connect(self.picked)
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
        below.addWidget(self.along, 1)
        below.addWidget(self.azimuth)
        layout.addLayout(pictures, 1)
        layout.addLayout(below)
        return page

    def _turn_section(self, along: bool) -> None:
        self.azimuth.setEnabled(not along)
        self.section.set_azimuth(None if along else math.radians(self.azimuth.value()))

    def _show_views(self, store: ReviewStore, unit: str | None) -> None:
        scene = scene_of(store, unit) if unit else UnitScene()
        for view in (self.plan, self.section):
            view.show_scene(scene)
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
    """Outlines, points, features and picks of a unit in the store's pair."""
    details, pair = store.details(unit), store.pair
    labels = (pair.epoch_from, pair.epoch_to)
    shapes = (details.shapes.get(labels[0]), details.shapes.get(labels[1]))
    features = tuple({name: value[0] for name, value in details.features.get(label, {}).items()} for label in labels)
    picks = read_picks(store.path, unit)
    places = tuple(np.array([row["geom"] for row in picks if row["epoch"] == label]).reshape(-1, 3) for label in labels)
    outlines = UnitScene(shapes, features=features, picks=places, labels=labels)
    if outlines.middle is None:
        return outlines
    if store.index is None:
        return replace(outlines, note=tr("points not read yet"))
    return replace(outlines, points=tuple(store.index.read(label, outlines.middle, outlines.half_size) for label in labels))
