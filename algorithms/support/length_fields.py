"""Lengths of a result's fields as tables, forms and the identify window write them: in the project's unit, whatever the file holds.

The file holds metres. A field formatter of QGIS writes them, so that expressions, filters and exports go on with the stored numbers.
"""

from __future__ import annotations

from typing import Any

from qgis.core import NULL, QgsApplication, QgsEditorWidgetSetup, QgsFieldFormatter, QgsVectorLayer

from ...core.results.schema import Field
from .lengths import length_format

WIDGET = "TetratrackLength"
"""Type of the fields' widgets by which QGIS finds the formatter."""
PER = "Per"
"""Key of a widget's settings: what the length is divided by, ``a`` for velocities."""
PLACES = (
    "along",
    "along_from",
    "along_to",
    "correlation_length",
    "height_min",
    "height_max",
    "design_height",
    "crest_height",
    "crest_highest",
)
"""Chainages and heights: coordinates, which stay in the CRS's metres as those of the points do."""


class LengthFormatter(QgsFieldFormatter):
    """Writes a stored length with the project's unit."""

    def id(self) -> str:
        return WIDGET

    def representValue(self, layer: QgsVectorLayer, field: int, config: dict[str, Any], cache: Any, value: Any) -> str:
        if value is None or value == NULL:
            return QgsApplication.nullRepresentation()
        return length_text(float(value), str(config.get(PER, "")))


def length_text(metres: float, per: str = "") -> str:
    """A length, or a length by ``per``, in the project's unit; velocities, which are smaller, with a decimal more."""
    lengths = length_format()
    if not per:
        return lengths.text(metres)
    return f"{metres * lengths.factor:.{lengths.decimals + 1}f} {lengths.suffix}/{per}"


def register() -> None:
    """Let QGIS know the formatter."""
    if not registered():
        QgsApplication.fieldFormatterRegistry().addFieldFormatter(LengthFormatter())


def unregister() -> None:
    """Take the formatter back; lengths are bare metres from then on."""
    if registered():
        QgsApplication.fieldFormatterRegistry().removeFieldFormatter(WIDGET)


def registered() -> bool:
    """Whether QGIS knows the formatter: qgis_process and scripts without the plugin do not."""
    return QgsApplication.fieldFormatterRegistry().fieldFormatter(WIDGET).id() == WIDGET


def follows_unit(field: Field) -> bool:
    """Whether a field is a length that is written in the project's unit."""
    return field.type == "real" and field.unit in ("m", "m/a") and field.name not in PLACES


def length_setup(field: Field) -> QgsEditorWidgetSetup:
    """How a field that follows the unit is shown."""
    return QgsEditorWidgetSetup(WIDGET, {PER: "a"} if field.unit == "m/a" else {})
