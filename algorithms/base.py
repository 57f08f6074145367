"""What all algorithms share: texts, help, the engine's run with its messages, and results on their way into sinks."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from qgis.core import (
    Qgis,
    QgsFeature,
    QgsFeatureSink,
    QgsField,
    QgsFields,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSink,
    QgsVectorLayer,
)
from qgis.PyQt.QtGui import QIcon

from ..core.results.schema import LAYERS
from .support.engine import EngineCancelled, EngineError, Listener, fault_links, find_engine, missing_engine_links, run_engine
from .support.layers import FIELD_TYPES, layer_title, style_on_load, wkb_type
from .support.translation import tr
from .support.wording import Wording

ICONS = Path(__file__).resolve().parents[1] / "plugin" / "icons"
DOCS_URL = "https://tetratrack.readthedocs.io/en/latest/algorithms"


@dataclass(frozen=True)
class Texts:
    """What the user reads about an algorithm, translated.

    Attributes
    ----------
    title
        Name in the toolbox.
    summary
        What it does, for whom and with which method: one paragraph.
    limits
        What it cannot do and what to watch.
    tags
        Words by which it is found, separated by commas.
    """

    title: str
    summary: str
    limits: str
    tags: str


class TetratrackAlgorithm(QgsProcessingAlgorithm):
    """Base of all algorithms: thin, stateless between runs, all computing in the engine process."""

    ID = ""
    GROUP = "steps"
    ICON = "tetratrack.svg"
    wording = Wording()
    """What the user calls the files made for the engine; an algorithm that makes some says so for its run."""

    def texts(self) -> Texts:
        """Texts in the language of the interface."""
        raise NotImplementedError

    def createInstance(self) -> TetratrackAlgorithm:
        return type(self)()

    def name(self) -> str:
        return self.ID

    def displayName(self) -> str:
        return self.texts().title

    def groupId(self) -> str:
        return self.GROUP

    def group(self) -> str:
        return {"monitoring": tr("Monitoring"), "steps": tr("Single steps"), "planning": tr("Planning and simulation")}[self.GROUP]

    def shortDescription(self) -> str:
        return self.texts().summary.split(". ")[0].rstrip(".") + "."

    def shortHelpString(self) -> str:
        texts = self.texts()
        shown = [d for d in self.parameterDefinitions() if d.help()]
        parts = [f"<p>{texts.summary}</p>", f"<h3>{tr('Inputs and outputs')}</h3>"]
        parts += [f"<p><b>{d.description()}</b>: {d.help()}</p>" for d in shown]
        numbers = [d for d in self.outputDefinitions() if self.parameterDefinition(d.name()) is None]
        if numbers:
            parts.append(f"<h3>{tr('Numbers for models')}</h3>")
            parts += [f"<p><code>{d.name()}</code>: {d.description()}</p>" for d in numbers]
        parts += [f"<h3>{tr('Limits')}</h3>", f"<p>{texts.limits}</p>"]
        return "".join(parts)

    def tags(self) -> list[str]:
        return [tag.strip() for tag in self.texts().tags.split(",")]

    def helpUrl(self) -> str:
        return f"{DOCS_URL}/{self.ID}/"

    def icon(self) -> QIcon:
        return QIcon(str(ICONS / self.ICON))

    def svgIconPath(self) -> str:
        return str(ICONS / self.ICON)

    def canExecute(self) -> tuple[bool, str]:
        engine = find_engine()
        if engine is None:
            return False, missing_engine_links()
        return (False, fault_links(engine.fault)) if engine.fault else (True, "")

    def add(self, definition: QgsProcessingParameterDefinition, help_text: str, *, advanced: bool = False) -> None:
        """Add a parameter with its help; tuning goes under the advanced ones."""
        definition.setHelp(help_text)
        if advanced:
            definition.setFlags(definition.flags() | Qgis.ProcessingParameterFlag.Advanced)
        self.addParameter(definition)

    def add_layer_sink(self, name: str, layer: str, *, optional: bool = False) -> None:
        """Add a feature sink for a layer of the result."""
        kind = {
            "PointZ": Qgis.ProcessingSourceType.VectorPoint,
            "LineStringZ": Qgis.ProcessingSourceType.VectorLine,
            "PolygonZ": Qgis.ProcessingSourceType.VectorPolygon,
            "MultiPolygonZ": Qgis.ProcessingSourceType.VectorPolygon,
            "none": Qgis.ProcessingSourceType.Vector,
        }[LAYERS[layer].geometry]
        sink = QgsProcessingParameterFeatureSink(name, layer_title(layer), kind, optional=optional, createByDefault=not optional)
        self.add(sink, layer_help(layer))

    def run_engine(
        self, arguments: list[str], feedback: QgsProcessingFeedback, first: float = 0.0, last: float = 100.0
    ) -> dict[str, Any] | None:
        """Run one subcommand; None when the user cancelled. Progress fills the bar from ``first`` to ``last`` percent."""
        said = [""]

        def progress(fraction: float, message: str) -> None:
            feedback.setProgress(first + (last - first) * fraction)
            if message and message != said[0]:
                said[0] = message
                feedback.setProgressText(self.wording(message))

        listener = Listener(
            progress,
            lambda message: feedback.pushInfo(self.wording(message)),
            lambda message: feedback.pushWarning(self.wording(message)),
            feedback.isCanceled,
        )
        try:
            return run_engine(arguments, listener)
        except EngineCancelled:
            return None
        except EngineError as error:
            raise QgsProcessingException(self.wording(str(error))) from error

    def scratch(self) -> tempfile.TemporaryDirectory[str]:
        """Folder of one run, removed with everything in it however the run ends."""
        return tempfile.TemporaryDirectory(prefix="tetratrack-")

    def copy_to_sink(
        self, path: Path, layer: str, parameters: dict[str, Any], name: str, context: QgsProcessingContext, group: str = ""
    ) -> tuple[str | None, int]:
        """Copy a layer of a result GeoPackage into a sink; returns the sink's id (None if not wanted) and the number of rows."""
        source = open_layer(path, layer)
        if not parameters.get(name) and self.parameterDefinition(name).flags() & Qgis.ProcessingParameterFlag.Optional:
            return None, source.featureCount()
        fields = layer_fields(layer, source)
        kind = wkb_type(LAYERS[layer].geometry) if layer in LAYERS else source.wkbType()
        sink, identifier = self.parameterAsSink(parameters, name, context, fields, kind, source.crs())
        if sink is None:
            raise QgsProcessingException(self.invalidSinkError(parameters, name))
        rows = 0
        for feature in source.getFeatures():
            row = QgsFeature(fields)
            row.setGeometry(feature.geometry())
            row.setAttributes([feature.attribute(field.name()) for field in fields])
            if not sink.addFeature(row, QgsFeatureSink.Flag.FastInsert):
                raise QgsProcessingException(self.writeFeatureError(sink, parameters, name))
            rows += 1
        sink.flushBuffer()
        style_on_load(context, identifier, layer, group)
        return identifier, rows


def layer_help(layer: str) -> str:
    """Meaning of a layer of the result, for the help of the sink that receives it."""
    return {
        "units": tr("Units at the common centre of their cones, with orientation, standard deviations (m, degrees), score and status."),
        "feature_points": tr("Centre and the four joints of three cones (f123, f124, f134, f234) of every unit, with covariance (m, m²)."),
        "displacements": tr("Displacement of every feature point between consecutive epochs (m), with test statistic and class."),
        "control_residuals": tr("Residuals at the control points (m), with normalised residual; disturbed points are marked."),
        "check_residuals": tr("Feature points less surveyed check points (m)."),
    }[layer]


def open_layer(path: Path, layer: str) -> QgsVectorLayer:
    """Layer of a GeoPackage, opened where the caller runs."""
    options = QgsVectorLayer.LayerOptions()
    options.loadDefaultStyle = False
    found = QgsVectorLayer(f"{path}|layername={layer}", layer, "ogr", options)
    if not found.isValid():
        raise QgsProcessingException(tr("The engine's result holds no layer {layer}.").format(layer=layer))
    return found


def layer_fields(layer: str, source: QgsVectorLayer) -> QgsFields:
    """Fields of a sink: those of the schema, in its order and with its types, then any further ones of the source."""
    fields = QgsFields()
    for field in LAYERS[layer].fields if layer in LAYERS else ():
        fields.append(QgsField(field.name, FIELD_TYPES[field.type]))
    for field in source.fields():
        if fields.lookupField(field.name()) < 0 and field.name() != "fid":
            fields.append(field)
    return fields
