"""The table of epochs in the window of *Monitor a survey*; Processing makes it by the name that the algorithm gives."""

from __future__ import annotations

from typing import Any

from processing.gui.wrappers import DIALOG_STANDARD, WidgetWrapper
from qgis.PyQt.QtCore import QCoreApplication
from qgis.PyQt.QtWidgets import QDialog, QDialogButtonBox, QLabel, QPushButton, QVBoxLayout, QWidget

from ..algorithms.support.translation import tr
from .epoch_rows import EpochRow, matrix_of, rows_of_matrix
from .epoch_table import EpochTable

OPTIONAL = " [optional]"


class EpochsButton(QPushButton):
    """The table behind a button, where a window has room for a line only: batches and models."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows: list[EpochRow] = []
        self.clicked.connect(lambda checked=False: self._ask())
        self.show_rows([])

    def rows(self) -> list[EpochRow]:
        """The epochs as they stand."""
        return self._rows

    def show_rows(self, rows: list[EpochRow]) -> None:
        """Take epochs in."""
        self._rows = rows
        self.setText(tr("{count} epochs…").format(count=len(rows)))

    def _ask(self) -> None:
        dialog = QDialog(self)
        dialog.setWindowTitle(tr("Epochs"))
        table = EpochTable(dialog)
        table.show_rows(self._rows)
        box = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel, dialog)
        box.accepted.connect(dialog.accept)
        box.rejected.connect(dialog.reject)
        layout = QVBoxLayout(dialog)
        layout.addWidget(table)
        layout.addWidget(box)
        dialog.resize(900, 320)
        if dialog.exec():
            self.show_rows(table.rows())


class EpochsWrapper(WidgetWrapper):
    """Hands the rows of the table to the parameter, and back."""

    def createWidget(self) -> QWidget:
        """The table itself, or a button that opens it."""
        return EpochTable() if self.dialogType == DIALOG_STANDARD else EpochsButton()

    def createLabel(self) -> QLabel | None:
        """The parameter's name; QGIS's own word for what may be left out, which it would look for under this class's name."""
        label = super().createLabel()
        if label is not None:
            label.setText(label.text().replace(OPTIONAL, QCoreApplication.translate("WidgetWrapper", OPTIONAL)))
        return label

    def setValue(self, value: Any) -> None:
        """Show the values of the parameter."""
        self.widget.show_rows(rows_of_matrix(value if isinstance(value, list) else None))

    def value(self) -> list[str]:
        """The values of the parameter."""
        return matrix_of(self.widget.rows())
