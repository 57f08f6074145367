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
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterNumber,
)

from .base import TetratrackAlgorithm, Texts
from .support.translation import tr
from .survey_algorithm import write_layers


class ExtractFeaturePoints(TetratrackAlgorithm):
    """Algorithm ``tetratrack:extractfeaturepoints``."""

    ID = "extractfeaturepoints"
    ICON = "features.svg"
    INPUT, END_DISCS, LEG_LENGTH, OUTPUT = "INPUT", "END_DISCS", "LEG_LENGTH", "OUTPUT"

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
        self.add(
            QgsProcessingParameterBoolean(self.END_DISCS, tr("Centres of the end discs as well"), False),
            tr("Points d1 to d4, which crews can measure and paint."),
        )
        self.add(
            QgsProcessingParameterNumber(
                self.LEG_LENGTH, tr("Leg length (m)"), Qgis.ProcessingNumberParameterType.Double, None, True, 1e-6
            ),
            tr("From the centre to the end disc, in metres; empty takes 0.644 H."),
            advanced=True,
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
            more = ["--end-discs"] if self.parameterAsBoolean(parameters, self.END_DISCS, context) else []
            if more and parameters.get(self.LEG_LENGTH) is not None:
                more += ["--leg-length", repr(self.parameterAsDouble(parameters, self.LEG_LENGTH, context))]
            if self.run_engine(["features", str(units), "--output", str(result), *more], feedback) is None:
                return {}
            identifier, count = self.copy_to_sink(result, "feature_points", parameters, self.OUTPUT, context)
        return {self.OUTPUT: identifier, "POINT_COUNT": count}
