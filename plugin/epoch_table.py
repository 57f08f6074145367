"""The table of epochs with an editor for each cell: time, tiles, tables of points."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

from qgis.core import QgsApplication, QgsMapLayer, QgsPointCloudLayer, QgsProject, QgsVectorLayer
from qgis.gui import QgsDateTimeEdit
from qgis.PyQt.QtCore import QDateTime, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QFileDialog,
    QHBoxLayout,
    QHeaderView,
    QMenu,
    QTableWidget,
    QTableWidgetItem,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ..algorithms.support.inputs import POINT_CLOUD_ENDINGS, SCAN_ENDINGS, tiles_in
from ..algorithms.support.translation import tr
from .epoch_rows import FILES, EpochRow, tiles_text

COLUMNS = ("label", "time", "tiles", "points", "density", "crs", *FILES)
TIME_PATTERN = "yyyy-MM-dd HH:mm"
CLOUDS = " ".join(f"*{ending} *{ending.upper()}" for ending in (*POINT_CLOUD_ENDINGS, *SCAN_ENDINGS, ".vpc"))
TIME_BUTTONS = 75
"""Pixels that the buttons of a time take in its cell, beside the text."""
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#AA4499", "#E69F00", "#56B4E9")
"""Of the epochs, in the table and on the map (Okabe and Ito, 2008)."""


def epoch_colour(place: int) -> QColor:
    """Colour of the epoch at a place of the table."""
    return QColor(COLOURS[place % len(COLOURS)])


def column_title(column: str) -> str:
    """Heading of a column."""
    return {
        "label": tr("Label"),
        "time": tr("Time (UTC)"),
        "tiles": tr("Tiles"),
        "points": tr("Points"),
        "density": tr("Points/m²"),
        "crs": tr("CRS"),
        "control": tr("Control points"),
        "targets": tr("Targets in the cloud"),
        "check": tr("Check points"),
    }[column]


class EpochTable(QWidget):
    """Epochs, one a row; ``changed`` after every change by the user, ``looked_away`` when tiles are no longer those that were looked at."""

    changed = pyqtSignal()
    looked_away = pyqtSignal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows: list[EpochRow] = []
        self._filling = False
        self.table = QTableWidget(0, len(COLUMNS), self)
        self.table.setObjectName("epochs")
        self.table.setHorizontalHeaderLabels([column_title(column) for column in COLUMNS])
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.table.verticalHeader().hide()
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        for place in range(len(COLUMNS)):
            # before there are rows too, and in any language
            header.resizeSection(place, max(header.sectionSize(place), header.sectionSizeHint(place)))
        self.table.setMinimumHeight(110)
        self.table.itemChanged.connect(self._typed)
        buttons = QHBoxLayout()
        for name, icon, text, run in (
            ("epoch_add", "/symbologyAdd.svg", tr("Add an epoch"), self.add),
            ("epoch_remove", "/symbologyRemove.svg", tr("Remove the selected epochs"), self.remove),
        ):
            button = QToolButton(self)
            button.setObjectName(name)
            button.setIcon(QgsApplication.getThemeIcon(icon))
            button.setToolTip(text)
            button.clicked.connect(lambda checked=False, run=run: run())
            buttons.addWidget(button)
        buttons.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.table, 1)
        layout.addLayout(buttons)

    def rows(self) -> list[EpochRow]:
        """The epochs as they stand."""
        return list(self._rows)

    def show_rows(self, rows: list[EpochRow]) -> None:
        """Show epochs."""
        self._rows = list(rows)
        self._filling = True
        self.table.setRowCount(0)
        self.table.setRowCount(len(rows))
        for place, row in enumerate(rows):
            self._fill(place, row)
        self.table.resizeColumnsToContents()
        self.table.setColumnWidth(COLUMNS.index("time"), self.fontMetrics().horizontalAdvance("0000-00-00 00:00") + TIME_BUTTONS)
        self._filling = False

    def selected(self) -> list[int]:
        """Places of the selected epochs."""
        return sorted({index.row() for index in self.table.selectedIndexes()})

    def add(self, tiles: tuple[str, ...] = ()) -> None:
        """Add an epoch."""
        self.show_rows([*self._rows, EpochRow(tiles=tiles)])
        self.changed.emit()

    def remove(self) -> None:
        """Remove the selected epochs."""
        gone = self.selected()
        self.show_rows([row for place, row in enumerate(self._rows) if place not in gone])
        self.changed.emit()

    def set_tiles(self, place: int, tiles: tuple[str, ...]) -> None:
        """Give an epoch other tiles."""
        before = self._rows[place]
        self._change(place, before.with_tiles(tiles))
        if self._rows[place] != before:
            self._filling = True
            self._fill(place, self._rows[place])
            self._filling = False
            self.looked_away.emit()

    # inside

    def _change(self, place: int, row: EpochRow) -> None:
        if row != self._rows[place]:
            self._rows[place] = row
            self.changed.emit()

    def _fill(self, place: int, row: EpochRow) -> None:
        texts = {
            "label": row.label,
            "points": f"{row.points:,}".replace(",", "\u202f") if row.points else "",
            "density": f"{row.density:.0f}" if row.points else "",
            "crs": row.crs if len(row.crs) < 40 else tr("user-defined"),
        }
        for column, text in texts.items():
            item = QTableWidgetItem(text)
            item.setToolTip(row.reason if column == "label" else row.crs if column == "crs" else "")
            if column == "label":
                item.setData(Qt.ItemDataRole.DecorationRole, epoch_colour(place))
            else:
                item.setFlags(Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable)
            if column in ("points", "density"):
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            self.table.setItem(place, COLUMNS.index(column), item)
        self.table.setCellWidget(place, COLUMNS.index("time"), self._time_editor(place, row))
        self.table.setCellWidget(place, COLUMNS.index("tiles"), self._tiles_editor(place, row))
        for key in FILES:
            self.table.setCellWidget(place, COLUMNS.index(key), self._points_editor(place, key, row.files.get(key, "")))

    def _typed(self, item: QTableWidgetItem) -> None:
        if not self._filling and COLUMNS[item.column()] == "label":
            self._change(item.row(), replace(self._rows[item.row()], label=item.text().strip()))

    def _time_editor(self, place: int, row: EpochRow) -> QgsDateTimeEdit:
        editor = QgsDateTimeEdit(self.table)
        editor.setDisplayFormat(TIME_PATTERN)
        editor.setCalendarPopup(True)
        editor.setAllowNull(True)
        editor.setToolTip(row.reason)
        moment = QDateTime.fromString(row.time.removesuffix("Z")[:19], Qt.DateFormat.ISODate)
        editor.setDateTime(moment) if moment.isValid() else editor.clear()

        def chosen(moment: QDateTime) -> None:
            time = "" if editor.isNull() or not moment.isValid() else moment.toString("yyyy-MM-ddTHH:mm:ss") + "Z"
            self._change(place, replace(self._rows[place], time=time))

        editor.valueChanged.connect(chosen)
        return editor

    def _tiles_editor(self, place: int, row: EpochRow) -> QToolButton:
        button = QToolButton(self.table)
        button.setObjectName("epoch_tiles")
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        button.setText(tiles_text(row.tiles) or tr("Choose…"))
        button.setToolTip("\n".join(row.tiles[:20]) + ("\n…" if len(row.tiles) > 20 else ""))
        menu = QMenu(button)
        menu.addAction(tr("Files…")).triggered.connect(lambda checked=False: self._ask_files(place))
        menu.addAction(tr("Folder…")).triggered.connect(lambda checked=False: self._ask_folder(place))
        layers = point_cloud_layers()
        if layers:
            menu.addSeparator()
        for layer in layers:
            chosen = (layer_file(layer),)
            menu.addAction(tr("Layer {name}").format(name=layer.name())).triggered.connect(
                lambda checked=False, chosen=chosen: self.set_tiles(place, chosen)
            )
        button.setMenu(menu)
        return button

    def _points_editor(self, place: int, key: str, value: str) -> QComboBox:
        return PointsChoice(value, partial(self._chosen, place, key), self.table)

    def _chosen(self, place: int, key: str, value: str) -> None:
        row = self._rows[place]
        files = {name: file for name, file in {**row.files, key: value}.items() if file}
        self._change(place, replace(row, files=files))

    def _ask_files(self, place: int) -> None:
        names, _ = QFileDialog.getOpenFileNames(
            self, tr("Tiles"), self._folder(place), tr("Point clouds ({endings})").format(endings=CLOUDS)
        )
        if names:
            self.set_tiles(place, tuple(names))

    def _ask_folder(self, place: int) -> None:
        name = QFileDialog.getExistingDirectory(self, tr("Folder of tiles"), self._folder(place))
        if name:
            self.set_tiles(place, tuple(tiles_in(Path(name))) or (name,))

    def _folder(self, place: int) -> str:
        tiles = self._rows[place].tiles
        return str(Path(tiles[0]).parent) if tiles else ""


class PointsChoice(QComboBox):
    """Choice of a table of points: none, a layer of the project, or a file."""

    def __init__(self, value: str, chosen: Callable[[str], None], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._value, self._tell = value, chosen
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self._fill()
        self.activated.connect(self._choose)

    def _fill(self) -> None:
        self.clear()
        self.addItem("–", "")
        named = {}
        for layer in point_layers():
            named[layer.id()] = layer.name()
            self.addItem(QgsApplication.getThemeIcon("/mIconPointLayer.svg"), layer.name(), layer.id())
        if self._value and self._value not in named:
            self.addItem(Path(self._value).name, self._value)
        self.addItem(tr("Choose a file…"), None)
        self.setCurrentIndex(max(self.findData(self._value), 0))
        self.setToolTip(self._value)

    def _choose(self, index: int) -> None:
        value = self.itemData(index)
        if value is None:
            start = str(Path(self._value).parent) if self._value else ""
            value, _ = QFileDialog.getOpenFileName(self, tr("Table of points"), start, tr("Tables (*.csv *.txt *.gpkg);;All files (*)"))
            value = value or self._value
        self._value = value
        self._fill()
        self._tell(value)


def point_layers() -> list[QgsVectorLayer]:
    """Vector layers of the project that can hold surveyed points: point layers and tables."""
    layers = QgsProject.instance().mapLayers().values()
    found = [layer for layer in layers if isinstance(layer, QgsVectorLayer) and layer.isValid() and _holds_points(layer)]
    return sorted(found, key=lambda layer: layer.name())


def _holds_points(layer: QgsVectorLayer) -> bool:
    names = {field.name().lower() for field in layer.fields()}
    return "point_id" in names and "epoch" not in names


def point_cloud_layers() -> list[QgsMapLayer]:
    """Point cloud layers of the project that lie in files."""
    layers = QgsProject.instance().mapLayers().values()
    found = [layer for layer in layers if isinstance(layer, QgsPointCloudLayer) and Path(layer_file(layer)).is_file()]
    return sorted(found, key=lambda layer: layer.name())


def layer_file(layer: QgsMapLayer) -> str:
    """File behind a layer."""
    return layer.source().split("|")[0]
