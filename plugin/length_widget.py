"""Lengths in forms: read, in the project's unit; what a run or a correction has found is not typed over."""

from __future__ import annotations

from typing import Any

from qgis.core import NULL, QgsApplication, QgsVectorLayer
from qgis.gui import QgsEditorConfigWidget, QgsEditorWidgetFactory, QgsEditorWidgetWrapper, QgsGui
from qgis.PyQt.QtWidgets import QLineEdit, QWidget

from ..algorithms.support.length_fields import PER, WIDGET, length_text
from ..algorithms.support.translation import tr


class LengthWrapper(QgsEditorWidgetWrapper):
    """A line that states a length and keeps the number that is stored."""

    def __init__(self, layer: QgsVectorLayer, field: int, editor: QWidget | None, parent: QWidget | None) -> None:
        super().__init__(layer, field, editor, parent)
        self._stored: Any = NULL
        self._line: QLineEdit | None = None

    def createWidget(self, parent: QWidget | None) -> QWidget:
        return QLineEdit(parent)

    def initWidget(self, editor: QWidget) -> None:
        self._line = editor if isinstance(editor, QLineEdit) else None
        if self._line is not None:
            self._line.setReadOnly(True)

    def valid(self) -> bool:
        return self._line is not None

    def value(self) -> Any:
        return self._stored

    def setValue(self, value: Any) -> None:
        """What QGIS up to 3.44 calls from Python."""
        self.updateValues(value)

    def updateValues(self, value: Any, additional: list[Any] | None = None) -> None:
        self._stored = value
        if self._line is not None:
            empty = value is None or value == NULL
            text = QgsApplication.nullRepresentation() if empty else length_text(float(value), str(self.config(PER) or ""))
            self._line.setText(text)

    def setEnabled(self, enabled: bool) -> None:
        """Text that is read only can be copied whether the layer is edited or not."""


class LengthSettings(QgsEditorConfigWidget):
    """Nothing to set: the project's unit and QGIS's decimals of measurements say how lengths are written."""

    def config(self) -> dict[str, Any]:
        return dict(self.layer().editorWidgetSetup(self.field()).config())

    def setConfig(self, config: dict[str, Any]) -> None:
        pass


class LengthFactory(QgsEditorWidgetFactory):
    """Makes the widgets that QGIS asks for."""

    def create(self, layer: QgsVectorLayer, field: int, editor: QWidget | None, parent: QWidget | None) -> QgsEditorWidgetWrapper:
        return LengthWrapper(layer, field, editor, parent)

    def configWidget(self, layer: QgsVectorLayer, field: int, parent: QWidget | None) -> QgsEditorConfigWidget:
        return LengthSettings(layer, field, parent)


def register() -> None:
    """Let QGIS's forms know the widget; they keep it until QGIS ends, for there is no way to take it back."""
    registry = QgsGui.editorWidgetRegistry()
    if WIDGET not in registry.factories():
        registry.registerWidget(WIDGET, LengthFactory(tr("Length in the project's unit")))
