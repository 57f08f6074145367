"""The table of a review: a thin model over the store's order, and a view that decides by single keys."""

from __future__ import annotations

from typing import Any

import numpy as np
from qgis.PyQt.QtCore import QAbstractTableModel, QEvent, QItemSelection, QItemSelectionModel, QModelIndex, QObject, Qt, pyqtSignal
from qgis.PyQt.QtGui import QBrush, QColor, QFont, QKeyEvent, QPalette
from qgis.PyQt.QtWidgets import QAbstractItemView, QApplication, QHeaderView, QTableView, QWidget

from ..algorithms.support.lengths import LengthFormat, decimal, length_format
from ..core.results.unit_rows import UnitRow
from ..core.review.decisions import DECISIONS
from .review_store import COLUMNS, ReviewStore
from .review_text import LENGTH_COLUMNS, column_help, decision_colour, decision_label, heading, kind_label

TEXT_COLUMNS = ("unit_id", "kind", "decision", "reviewer")
FADED = 110
"""Opacity, of 255, of the text of rejected units."""
COMMANDS = {
    Qt.Key.Key_A: "accepted",
    Qt.Key.Key_R: "rejected",
    Qt.Key.Key_I: "inspect",
    Qt.Key.Key_C: "confirm",
    Qt.Key.Key_U: "undo",
    Qt.Key.Key_N: "next",
    Qt.Key.Key_P: "previous",
    Qt.Key.Key_Z: "zoom",
}
# events carry plain numbers, which Qt 6's enumeration does not equal
KEYS = {int(getattr(key, "value", key)): command for key, command in COMMANDS.items()}


class ReviewModel(QAbstractTableModel):
    """Rows of the store in its present order."""

    def __init__(self, store: ReviewStore, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.store = store
        self.lengths = lengths_of(store)

    def rowCount(self, parent: QModelIndex = QModelIndex()) -> int:  # noqa: B008 - Qt's signature
        """Units that pass the filter."""
        return 0 if parent.isValid() else len(self.store.order)

    def columnCount(self, parent: QModelIndex = QModelIndex()) -> int:  # noqa: B008 - Qt's signature
        """Columns of the table."""
        return 0 if parent.isValid() else len(COLUMNS)

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Headings with their explanation."""
        if orientation != Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return heading(COLUMNS[section], self.lengths.suffix)
        if role == Qt.ItemDataRole.ToolTipRole:
            return column_help(COLUMNS[section])
        return None

    def data(self, index: QModelIndex, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Text, alignment and emphasis of a cell."""
        if not index.isValid():
            return None
        row, column = self.store.shown(index.row()), COLUMNS[index.column()]
        if role == Qt.ItemDataRole.DisplayRole:
            return self.text(row, column)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            # Qt 5 takes a plain number only, and Qt 6's flags are no numbers
            side = Qt.AlignmentFlag.AlignLeft if column in TEXT_COLUMNS else Qt.AlignmentFlag.AlignRight
            alignment = side | Qt.AlignmentFlag.AlignVCenter
            return int(getattr(alignment, "value", alignment))
        review = self.store.review(row.unit_id)
        if role == Qt.ItemDataRole.FontRole:
            font = QFont(QApplication.font())
            font.setBold(row.significant and column in ("d_3d", "p_value"))
            # what was rejected stays in the list, but cannot be mistaken for a result
            font.setStrikeOut(review is not None and review.decision == "rejected" and column != "decision")
            return font
        if role == Qt.ItemDataRole.ForegroundRole and column == "decision" and review is not None:
            return QBrush(decision_colour(review.decision, QApplication.palette()))
        if role == Qt.ItemDataRole.ForegroundRole and review is not None and review.decision == "rejected":
            faded = QColor(QApplication.palette().color(QPalette.ColorRole.Text))
            faded.setAlpha(FADED)
            return QBrush(faded)
        if role == Qt.ItemDataRole.ToolTipRole and review is not None and review.comment:
            return review.comment
        return None

    def text(self, row: UnitRow, column: str) -> str:
        """A value as the user reads it; a dash for none."""
        value = self.store.value(row, column)
        if value is None:
            return "" if column in ("decision", "reviewer") else "–"
        if column in LENGTH_COLUMNS:
            return self.lengths.number(value)
        if column == "kind":
            return kind_label(value)
        if column == "decision":
            return f"● {decision_label(value)}"
        if column == "rotation_deg":
            return f"{decimal(value, 2)}°"
        if column == "p_value":
            return decimal(value, 3) if value >= 0.001 else f"<{decimal(0.001, 3)}"
        if column == "broken_legs":
            return ", ".join(map(str, value))
        if column == "coverage":
            return f"{100 * value:.0f} %"
        return str(value)

    def sort(self, column: int, order: Qt.SortOrder = Qt.SortOrder.AscendingOrder) -> None:
        """Let the store put the rows in order."""
        self.store.sort(COLUMNS[column], order == Qt.SortOrder.DescendingOrder)

    def reset(self) -> None:
        """The order or the rows changed."""
        self.beginResetModel()
        self.lengths = lengths_of(self.store)
        self.endResetModel()

    def refresh(self) -> None:
        """Decisions changed, the order did not."""
        if self.store.order:
            self.dataChanged.emit(self.index(0, 0), self.index(len(self.store.order) - 1, len(COLUMNS) - 1))


class ReviewTable(QTableView):
    """Table of units in step with the store's selection; ``command`` carries what a single key asks for."""

    command = pyqtSignal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("review_table")
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setAlternatingRowColors(True)
        self.setWordWrap(False)
        self.verticalHeader().hide()
        # one height for all rows: measuring ten thousand would cost seconds
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 5)
        self.horizontalHeader().setHighlightSections(False)
        self._store: ReviewStore | None = None
        self._following = False

    def show_store(self, store: ReviewStore) -> ReviewModel:
        """Show a store; the model that does it."""
        self._store = store
        model = ReviewModel(store, self)
        self.setModel(model)
        self.horizontalHeader().setSortIndicator(
            COLUMNS.index(store.sort_column), Qt.SortOrder.DescendingOrder if store.descending else Qt.SortOrder.AscendingOrder
        )
        self.setSortingEnabled(True)
        self.selectionModel().selectionChanged.connect(self._tell_store)
        metrics = self.fontMetrics()
        samples = {
            "unit_id": [store.rows[0].unit_id] if store.rows else ["U0000"],
            "kind": [kind_label(kind) for kind in ("relocated", "uncertain", "moved")],
            "decision": [f"● {decision_label(decision)}" for decision in DECISIONS],
            "reviewer": ["reviewer A"],
        }
        for place, column in enumerate(COLUMNS):
            widest = max(metrics.horizontalAdvance(sample) for sample in samples.get(column, ["-00.000"]))
            width = max(widest + 14, metrics.horizontalAdvance(heading(column, model.lengths.suffix)) + 24)
            self.setColumnWidth(place, width)
        self.horizontalHeader().setStretchLastSection(True)
        return model

    def follow(self) -> None:
        """Select what the store has selected and bring it into sight."""
        if self._store is None or self._following:
            return
        self._following = True
        places = sorted(place for unit in self._store.selected if (place := self._store.place_of(unit)) is not None)
        selection = QItemSelection()
        for first, last in _runs(places):
            selection.select(self.model().index(first, 0), self.model().index(last, len(COLUMNS) - 1))
        self.selectionModel().select(selection, QItemSelectionModel.SelectionFlag.ClearAndSelect)
        here = self._store.place_of(self._store.current) if self._store.current is not None else None
        if here is not None:
            index = self.model().index(here, 0)
            self.selectionModel().setCurrentIndex(index, QItemSelectionModel.SelectionFlag.NoUpdate)
            self.scrollTo(index)
        self._following = False

    def event(self, event: QEvent) -> bool:
        """Keep single keys from QGIS's own shortcuts while the table has the focus."""
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent) and _command(event):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Decide and move by single keys."""
        command = _command(event)
        if command:
            self.command.emit(command)
        else:
            super().keyPressEvent(event)

    def _tell_store(self) -> None:
        if self._following or self._store is None:
            return
        rows = [index.row() for index in self.selectionModel().selectedRows()]
        current = self.selectionModel().currentIndex().row()
        # the plots show the row the user touched last
        rows.sort(key=lambda row: row == current)
        self._following = True
        self._store.select(self._store.shown(row).unit_id for row in rows)
        self._following = False


def lengths_of(store: ReviewStore) -> LengthFormat:
    """Lengths with decimals that the standard deviations of most of the store's displacements are seen in."""
    sds = [row.sd for row in store.rows if row.sd is not None]
    return length_format().telling(float(np.median(sds)) if sds else None)


def _command(event: QKeyEvent) -> str:
    plain = event.modifiers() in (Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.KeypadModifier)
    return KEYS.get(event.key(), "") if plain else ""


def _runs(places: list[int]) -> list[tuple[int, int]]:
    """First and last of every run of consecutive numbers."""
    runs: list[tuple[int, int]] = []
    for place in places:
        if runs and runs[-1][1] == place - 1:
            runs[-1] = (runs[-1][0], place)
        else:
            runs.append((place, place))
    return runs
