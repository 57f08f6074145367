"""Feature points of fitted units."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import (
    Qgis,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSource,
)

from .base import TetratrackAlgorithm, Texts
from .support.translation import tr
from .survey_algorithm import write_layers


class ExtractFeaturePoints(TetratrackAlgorithm):
    """Algorithm ``tetratrack:extractfeaturepoints``."""

    ID = "extractfeaturepoints"
    ICON = "features.svg"
    INPUT, OUTPUT = "INPUT", "OUTPUT"

    def texts(self) -> Texts:
        return Texts(
            tr("Extract feature points"),
            tr(
                "Derives the centre and the four points where three cone surfaces meet on the outside of each unit, with the covariance "
                "carried over from the fit. These points can be surveyed by total station as well."
            ),
            tr("A joint is marked as observed only where points lie next to it; otherwise it follows from the rest of the unit."),
            tr("feature points,cone intersection,centre,covariance propagation"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        self.add(
            QgsProcessingParameterFeatureSource(self.INPUT, tr("Fitted units"), [Qgis.ProcessingSourceType.VectorPoint]),
            tr("Layer of units from Fit tetrapods or Monitor a survey."),
        )
        self.add_layer_sink(self.OUTPUT, "feature_points")
        self.addOutput(QgsProcessingOutputNumber("POINT_COUNT", tr("Points")))

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        source = self.parameterAsSource(parameters, self.INPUT, context)
        if source is None:
            raise QgsProcessingException(self.invalidSourceError(parameters, self.INPUT))
        with self.scratch() as scratch:
            folder = Path(scratch)
            units = write_layers([source], folder / "units.gpkg", "units", context)
            result = folder / "result.gpkg"
            if self.run_engine(["features", str(units), "--output", str(result)], feedback) is None:
                return {}
            identifier, count = self.copy_to_sink(result, "feature_points", parameters, self.OUTPUT, context)
        return {self.OUTPUT: identifier, "POINT_COUNT": count}
