"""Layers of a result as QGIS shows them: field types, styles, names, groups."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from types import MappingProxyType

from qgis.core import (
    Qgis,
    QgsBilinearRasterResampler,
    QgsClassificationPrettyBreaks,
    QgsDateTimeRange,
    QgsFillSymbol,
    QgsGradientColorRamp,
    QgsGraduatedSymbolRenderer,
    QgsMapLayer,
    QgsPalLayerSettings,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingLayerPostProcessorInterface,
    QgsProject,
    QgsProperty,
    QgsProviderRegistry,
    QgsRasterLayer,
    QgsSingleBandGrayRenderer,
    QgsSymbolLayer,
    QgsTextBufferSettings,
    QgsTextFormat,
    QgsVectorLayer,
    QgsVectorLayerSimpleLabeling,
)
from qgis.PyQt.QtCore import QDateTime, QMetaType, Qt
from qgis.PyQt.QtGui import QColor

from ...core.common.errors import TetratrackError
from ...core.results.added_layers import TILE_INDEX, known_layer
from ...core.results.schema import LAYERS
from ...core.results.unit_rows import read_epochs
from .field_titles import field_alias
from .length_fields import WIDGET, follows_unit, length_setup, registered
from .lengths import length_format, write_project_lengths
from .translation import tr

STYLES = Path(__file__).resolve().parents[2] / "core" / "results" / "styles"
FIELD_TYPES = {
    "text": QMetaType.Type.QString,
    "integer": QMetaType.Type.LongLong,
    "real": QMetaType.Type.Double,
    "boolean": QMetaType.Type.Bool,
    "datetime": QMetaType.Type.QDateTime,
}
GRADED = ("displacements", "displacements_other")
"""Layers whose features are drawn by the survey's own grades."""
DRAWING_ORDER = (
    "manual_picks",
    "unit_edits",
    "displacements",
    "displacements_other",
    "check_residuals",
    "control_residuals",
    "stretches",
    "frame_errors",
    "feature_points",
    "gaps",
    "units",
    "placement",
    "unit_outlines",
    "unit_surfaces",
    "epochs",
    "reviews",
)
"""Layers from the top of the layer tree downwards."""

HIDDEN_AT_FIRST = ("displacements_other", "placement", "unit_surfaces")
"""Layers loaded but not shown: a second arrow of another datum misleads, placement is another question, surfaces are for 3D views."""

ARROW_LABEL = "arrow of 10 mm: 50 mm"
"""How the label of the shipped styles begins that says how long arrows are."""
LEGEND_PROPERTY = "tetratrack/legend"
"""Custom property of a layer that keeps the labels of its legend as the shipped style has them."""
NAMED_PROPERTY = "tetratrack/fields"
"""Custom property of a layer whose fields are named: what a user makes of the names afterwards stays."""
SHIPPED_WIDGETS = ("", "Range", WIDGET)
"""How the shipped styles and QGIS itself show numbers; what else a user has chosen stays."""
LEADING_FIELDS = 4
"""So many fields of a layer have been there in every version of the format."""

TILE_CLASSES = 5

_alive: list[QgsProcessingLayerPostProcessorInterface] = []


def wkb_type(geometry: str) -> Qgis.WkbType:
    """WKB type of a geometry of the schema."""
    return Qgis.WkbType.NoGeometry if geometry == "none" else getattr(Qgis.WkbType, geometry)


def layer_title(layer: str) -> str:
    """Name of a layer of the result in the layer tree."""
    return {
        "units": tr("Units"),
        "unit_outlines": tr("Outlines of the units"),
        "unit_surfaces": tr("Surfaces of the units (3D)"),
        "placement": tr("Placement of the units"),
        "gaps": tr("Gaps"),
        "feature_points": tr("Feature points"),
        "displacements": tr("Displacements"),
        "displacements_other": tr("Displacements, other pairs and datum"),
        "frame_errors": tr("Errors of bent frames"),
        "stretches": tr("Stretches that moved as one"),
        "control_residuals": tr("Control residuals"),
        "check_residuals": tr("Check residuals"),
        "epochs": tr("Epochs"),
        "reviews": tr("Reviews"),
        "unit_edits": tr("Corrections and placeholders"),
        "manual_picks": tr("Points picked by hand"),
        "tiles": tr("Tile index"),
    }[layer]


def has_style(layer: str) -> bool:
    """Whether a style ships for a layer of the result."""
    return (STYLES / f"{layer}.qml").is_file()


def apply_style(layer: QgsVectorLayer, name: str) -> None:
    """Give a layer the shipped style of a layer of the result, and its metadata."""
    if name == TILE_INDEX.name:
        style_tiles(layer)
    if not has_style(name):
        return
    layer.loadNamedStyle(str(STYLES / f"{name}.qml"), True)
    translate_legend(layer)
    name_fields(layer, name)
    describe(layer, name)
    layer.triggerRepaint()


def name_fields(layer: QgsVectorLayer, name: str) -> None:
    """Fields in words of the interface's language, with their units."""
    known = known_layer(name)
    for field in known.fields if known is not None else ():
        index = layer.fields().lookupField(field.name)
        if index < 0:
            continue
        follows = registered() and follows_unit(field) and layer.editorWidgetSetup(index).type() in SHIPPED_WIDGETS
        if follows:
            layer.setEditorWidgetSetup(index, length_setup(field))
        layer.setFieldAlias(index, field_alias(field, with_unit=not follows))
    layer.setCustomProperty(NAMED_PROPERTY, name)


def name_added_layers(layers: Iterable[QgsMapLayer]) -> None:
    """Name the fields of layers of results that were opened without the plugin's help: dragged onto the map, or from a project of then."""
    for layer in layers:
        if not isinstance(layer, QgsVectorLayer) or layer.providerType() != "ogr" or layer.customProperty(NAMED_PROPERTY):
            continue
        name = QgsProviderRegistry.instance().decodeUri("ogr", layer.source()).get("layerName") or ""
        known = known_layer(name)
        # other files have layers of such names too
        if known is not None and {field.name for field in known.fields[:LEADING_FIELDS]} <= set(layer.fields().names()):
            name_fields(layer, name)


def describe(layer: QgsMapLayer, name: str) -> None:
    """Title and abstract from the schema."""
    known, metadata = known_layer(name), layer.metadata()
    metadata.setTitle(layer_title(name))
    metadata.setAbstract(known.description if known is not None else "")
    layer.setMetadata(metadata)


def translate_legend(layer: QgsVectorLayer) -> None:
    """Put the labels of the legend, English and in millimetres in the style files, into the interface's language and the project's unit."""
    renderer = layer.renderer()
    if renderer is None or renderer.type() != "RuleRenderer":
        return
    limits = limits_of_survey(layer)
    for rule in renderer.rootRule().descendants():
        if rule.label():
            original = layer.customProperty(f"{LEGEND_PROPERTY}/{rule.ruleKey()}") or rule.label()
            # kept, for the language or the unit of lengths may change
            layer.setCustomProperty(f"{LEGEND_PROPERTY}/{rule.ruleKey()}", original)
            rule.setLabel(legend_label(original, limits))
    layer.legendChanged.emit()


def limits_of_survey(layer: QgsVectorLayer) -> dict[str, float]:
    """Limits of the grades of displacements in metres, by name, that the settings of the layer's own result state; {} for other layers."""
    uri = QgsProviderRegistry.instance().decodeUri(layer.providerType(), layer.source())
    if uri.get("layerName") not in GRADED or not uri.get("path"):
        return {}
    try:
        epochs = read_epochs(Path(uri["path"]))
    except TetratrackError:
        return {}
    stated = epochs[-1].settings.get("displacement") if epochs else None
    return {name: value for name, value in stated.items() if isinstance(value, int | float)} if isinstance(stated, dict) else {}


def legend_label(label: str, limits: Mapping[str, float] = MappingProxyType({})) -> str:
    """Translation of a label of the shipped styles, lengths and the survey's ``limits`` in the project's unit."""
    if label == "watch" and "watch" in limits:
        return tr("watch: over {length}").format(length=length_format().text(limits["watch"]))
    if label == "alert or more" and "alert" in limits:
        return tr("alert or more: over {length}").format(length=length_format().text(limits["alert"]))
    # saved projects know the label of their day, which said nothing of the longest
    if label.startswith(ARROW_LABEL):
        return tr("arrow of 10 mm: {length}, at most 30 mm long; ellipse: 95 %").format(length=length_format().text(0.05))
    known = {
        "error as targets see it": tr("error as targets see it"),
        "difference of two epochs as units see it": tr("difference of two epochs as units see it"),
        "strip against its epoch": tr("strip against its epoch"),
        "moved as one": tr("moved as one"),
        "no common motion that could be told": tr("no common motion that could be told"),
        "found": tr("found"),
        "uncertain": tr("uncertain"),
        "new": tr("new"),
        "relocated": tr("relocated"),
        "stable": tr("stable"),
        "moved": tr("moved"),
        "rotated": tr("rotated"),
        "lost: the place is empty": tr("lost: the place is empty"),
        "unseen: known from another epoch": tr("unseen: known from another epoch"),
        "unexplained points where a unit fits": tr("unexplained points where a unit fits"),
        "hole where a unit fits": tr("hole where a unit fits"),
        "below the detection limit": tr("below the detection limit"),
        "significant": tr("significant"),
        "watch": tr("watch"),
        "alert or more": tr("alert or more"),
        "relocated unit": tr("relocated unit"),
        "uncertain unit": tr("uncertain unit"),
        "missing end of a broken leg": tr("missing end of a broken leg"),
        "observed": tr("observed"),
        "derived from the rest of the unit": tr("derived from the rest of the unit"),
        "used": tr("used"),
        "disturbed, not used": tr("disturbed, not used"),
        "not used": tr("not used"),
        "check point": tr("check point"),
        "placeholder for a unit not found": tr("placeholder for a unit not found"),
        "place of a correction": tr("place of a correction"),
        "picked by hand": tr("picked by hand"),
    }
    return known.get(label, label)


def style_tiles(layer: QgsVectorLayer) -> None:
    """Tiles by density in classes of this index, each with its name, density and day; those with a warning have a red edge."""
    symbol = QgsFillSymbol.createSimple({"outline_color": "#44505a", "outline_width": "0.3"})
    red = "if(\"verdict\" in ('warning', 'refused'), '#c62828', '#44505a')"
    symbol.symbolLayer(0).setDataDefinedProperty(QgsSymbolLayer.Property.StrokeColor, QgsProperty.fromExpression(red))
    symbol.setOpacity(0.7)
    renderer = QgsGraduatedSymbolRenderer("density")
    renderer.setSourceSymbol(symbol)
    renderer.setSourceColorRamp(QgsGradientColorRamp(QColor("#fff3d6"), QColor("#16857f")))
    renderer.setClassificationMethod(QgsClassificationPrettyBreaks())
    renderer.updateClasses(layer, TILE_CLASSES)
    layer.setRenderer(renderer)
    settings = QgsPalLayerSettings()
    settings.isExpression = True
    settings.fieldName = (
        "file_name(\"file\") || '\\n' || format_number(\"density\", 0) || ' /m²' || if(\"measured\" <> '', '\\n' || \"measured\", '')"
    )
    settings.placement = Qgis.LabelPlacement.OverPoint
    words = QgsTextFormat()
    words.setSize(8)
    halo = QgsTextBufferSettings()
    halo.setEnabled(True)
    words.setBuffer(halo)
    settings.setFormat(words)
    layer.setLabeling(QgsVectorLayerSimpleLabeling(settings))
    layer.setLabelsEnabled(True)
    layer.setMapTipTemplate('<b>[% file_name("file") %]</b><br>[% "points" %], [% "crs" %]<br>[% "verdict" %] [% "remark" %]')
    name_fields(layer, TILE_INDEX.name)
    layer.triggerRepaint()


class StyleOnLoad(QgsProcessingLayerPostProcessorInterface):
    """Styles a layer when Processing has loaded it; made in the main thread's language, kept alive until then.

    Parameters
    ----------
    name
        Layer of the result.
    span
        When a raster shows what it does; None for always, or for a layer whose rows say so.
    """

    def __init__(self, name: str, span: QgsDateTimeRange | None = None) -> None:
        super().__init__()
        self.name, self.span = name, span

    def postProcessLayer(self, layer: QgsMapLayer, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
        if isinstance(layer, QgsVectorLayer):
            write_project_lengths(context.project() or QgsProject.instance())
            apply_style(layer, self.name)
        elif isinstance(layer, QgsRasterLayer):
            show_grey(layer)
            layer.setOpacity(0.9)
            # seen from nearer than its cells, a relief is smooth and not a chessboard
            layer.resampleFilter().setZoomedInResampler(QgsBilinearRasterResampler())
            if self.span is not None:
                set_span(layer, self.span)
        if self.name in HIDDEN_AT_FIRST and context.project() is not None:
            node = context.project().layerTreeRoot().findLayer(layer.id())
            if node is not None:
                node.setItemVisibilityChecked(False)


def show_grey(layer: QgsRasterLayer) -> None:
    """A relief's first band as grey values, its second as what lets the map through: QGIS takes both for colours."""
    renderer = QgsSingleBandGrayRenderer(layer.dataProvider(), 1)
    if layer.bandCount() > 1:
        renderer.setAlphaBand(2)
    layer.setRenderer(renderer)


def set_span(layer: QgsRasterLayer, span: QgsDateTimeRange) -> None:
    """Show a raster in the temporal controller during a span of time."""
    temporal = layer.temporalProperties()
    temporal.setMode(Qgis.RasterTemporalMode.FixedTemporalRange)
    temporal.setFixedTemporalRange(span)
    temporal.setIsActive(True)


def epoch_spans(result: Path) -> dict[str, QgsDateTimeRange]:
    """From when to when each epoch of a result is the latest; the last one has no end."""
    begins = [(info.label, info.time.timestamp()) for info in read_epochs(result) if info.time is not None]
    times = [QDateTime.fromMSecsSinceEpoch(round(1000 * seconds), Qt.TimeSpec.UTC) for _, seconds in begins]
    ends = [*times[1:], QDateTime()]
    return {label: QgsDateTimeRange(begin, end, True, False) for (label, _), begin, end in zip(begins, times, ends)}


def set_project_time(project: QgsProject, result: Path) -> None:
    """Let the project's time run over the epochs of a result, where it has none yet: an animation would begin today."""
    spans = list(epoch_spans(result).values())
    if len(spans) > 1 and project.timeSettings().temporalRange().isInfinite():
        project.timeSettings().setTemporalRange(QgsDateTimeRange(spans[0].begin(), spans[-1].begin()))


def style_on_load(context: QgsProcessingContext, identifier: str, name: str, group: str = "") -> None:
    """Style a layer when and if Processing loads it, and put it into a group."""
    if not context.willLoadLayerOnCompletion(identifier):
        return
    details = context.layerToLoadOnCompletionDetails(identifier)
    _prepare(details, name, group)


def load_on_completion(
    context: QgsProcessingContext, source: str, name: str, output: str, group: str, span: QgsDateTimeRange | None = None
) -> None:
    """Have Processing load a source into the project after the run; without a project (qgis_process) nothing is loaded."""
    project = context.project()
    if project is None:
        return
    title = layer_title(name) if name in LAYERS else name
    details = QgsProcessingContext.LayerDetails(title, project, output)
    _prepare(details, name, group, span)
    context.addLayerToLoadOnCompletion(source, details)


def _prepare(details: QgsProcessingContext.LayerDetails, name: str, group: str, span: QgsDateTimeRange | None = None) -> None:
    details.groupName = group
    if name in DRAWING_ORDER:
        details.layerSortKey = len(DRAWING_ORDER) - DRAWING_ORDER.index(name)
    processor = StyleOnLoad(name, span)
    _alive.append(processor)
    details.setPostProcessor(processor)


def follow_unit(project: QgsProject) -> None:
    """Bring labels and legends of all layers of results to the project's unit of lengths."""
    write_project_lengths(project)
    for layer in project.mapLayers().values():
        if isinstance(layer, QgsVectorLayer) and any(key.startswith(LEGEND_PROPERTY) for key in layer.customPropertyKeys()):
            translate_legend(layer)
            layer.triggerRepaint()
