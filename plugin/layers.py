"""Layers of a result as QGIS shows them: field types, styles, names, groups."""

from __future__ import annotations

from pathlib import Path

from qgis.core import (
    Qgis,
    QgsMapLayer,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingLayerPostProcessorInterface,
    QgsRasterLayer,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QMetaType

from ..core.schema import LAYERS
from .translation import tr

STYLES = Path(__file__).resolve().parents[1] / "core" / "styles"
FIELD_TYPES = {
    "text": QMetaType.Type.QString,
    "integer": QMetaType.Type.LongLong,
    "real": QMetaType.Type.Double,
    "boolean": QMetaType.Type.Bool,
    "datetime": QMetaType.Type.QDateTime,
}
DRAWING_ORDER = (
    "displacements",
    "displacements_other",
    "check_residuals",
    "control_residuals",
    "feature_points",
    "gaps",
    "units",
    "epochs",
    "reviews",
)
"""Layers from the top of the layer tree downwards."""

_alive: list[QgsProcessingLayerPostProcessorInterface] = []


def wkb_type(geometry: str) -> Qgis.WkbType:
    """WKB type of a geometry of the schema."""
    return {"PointZ": Qgis.WkbType.PointZ, "LineStringZ": Qgis.WkbType.LineStringZ, "none": Qgis.WkbType.NoGeometry}[geometry]


def layer_title(layer: str) -> str:
    """Name of a layer of the result in the layer tree."""
    return {
        "units": tr("Units"),
        "gaps": tr("Gaps"),
        "feature_points": tr("Feature points"),
        "displacements": tr("Displacements"),
        "displacements_other": tr("Displacements, other pairs and datum"),
        "control_residuals": tr("Control residuals"),
        "check_residuals": tr("Check residuals"),
        "epochs": tr("Epochs"),
        "reviews": tr("Reviews"),
    }[layer]


def has_style(layer: str) -> bool:
    """Whether a style ships for a layer of the result."""
    return (STYLES / f"{layer}.qml").is_file()


def apply_style(layer: QgsVectorLayer, name: str) -> None:
    """Give a layer the shipped style of a layer of the result, and its metadata."""
    if not has_style(name):
        return
    layer.loadNamedStyle(str(STYLES / f"{name}.qml"), True)
    translate_legend(layer)
    describe(layer, name)
    layer.triggerRepaint()


def describe(layer: QgsMapLayer, name: str) -> None:
    """Title and abstract from the schema."""
    metadata = layer.metadata()
    metadata.setTitle(layer_title(name))
    metadata.setAbstract(LAYERS[name].description)
    layer.setMetadata(metadata)


def translate_legend(layer: QgsVectorLayer) -> None:
    """Put the labels of the legend, English in the style files, into the language of the interface."""
    renderer = layer.renderer()
    if renderer is None or renderer.type() != "RuleRenderer":
        return
    for rule in renderer.rootRule().descendants():
        if rule.label():
            rule.setLabel(legend_label(rule.label()))


def legend_label(label: str) -> str:
    """Translation of a label of the shipped styles; the scale of exaggerated symbols stays as it is."""
    known = {
        "found": tr("found"),
        "uncertain": tr("uncertain"),
        "new": tr("new"),
        "relocated": tr("relocated"),
        "lost: the place is empty": tr("lost: the place is empty"),
        "unseen: known from another epoch": tr("unseen: known from another epoch"),
        "unexplained points where a unit fits": tr("unexplained points where a unit fits"),
        "hole where a unit fits": tr("hole where a unit fits"),
        "arrow of 10 mm: 50 mm; ellipse: 95 %": tr("arrow of 10 mm: 50 mm; ellipse: 95 %"),
        "below the detection limit": tr("below the detection limit"),
        "significant, up to 50 mm": tr("significant, up to 50 mm"),
        "50 to 100 mm: watch": tr("50 to 100 mm: watch"),
        "more than 100 mm: alert": tr("more than 100 mm: alert"),
        "relocated unit": tr("relocated unit"),
        "uncertain unit": tr("uncertain unit"),
        "observed": tr("observed"),
        "derived from the rest of the unit": tr("derived from the rest of the unit"),
        "used": tr("used"),
        "disturbed, not used": tr("disturbed, not used"),
        "not used": tr("not used"),
        "check point": tr("check point"),
    }
    return known.get(label, label)


class StyleOnLoad(QgsProcessingLayerPostProcessorInterface):
    """Styles a layer when Processing has loaded it; made in the main thread's language, kept alive until then."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.name = name

    def postProcessLayer(self, layer: QgsMapLayer, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
        if isinstance(layer, QgsVectorLayer):
            apply_style(layer, self.name)
        elif isinstance(layer, QgsRasterLayer):
            layer.setOpacity(0.9)


def style_on_load(context: QgsProcessingContext, identifier: str, name: str, group: str = "") -> None:
    """Style a layer when and if Processing loads it, and put it into a group."""
    if not context.willLoadLayerOnCompletion(identifier):
        return
    details = context.layerToLoadOnCompletionDetails(identifier)
    _prepare(details, name, group)


def load_on_completion(context: QgsProcessingContext, source: str, name: str, output: str, group: str) -> None:
    """Have Processing load a source into the project after the run; without a project (qgis_process) nothing is loaded."""
    project = context.project()
    if project is None:
        return
    title = layer_title(name) if name in LAYERS else name
    details = QgsProcessingContext.LayerDetails(title, project, output)
    _prepare(details, name, group)
    context.addLayerToLoadOnCompletion(source, details)


def _prepare(details: QgsProcessingContext.LayerDetails, name: str, group: str) -> None:
    details.groupName = group
    if name in DRAWING_ORDER:
        details.layerSortKey = len(DRAWING_ORDER) - DRAWING_ORDER.index(name)
    processor = StyleOnLoad(name)
    _alive.append(processor)
    details.setPostProcessor(processor)
