"""Feature points against surveyed check points."""

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
from .support.inputs import CHECK, CHECK_COLUMNS, add_check, write_points
from .support.point_files import CHECK_SD
from .support.translation import tr
from .survey_algorithm import write_layers


class ValidateSurvey(TetratrackAlgorithm):
    """Algorithm ``tetratrack:validatesurvey``."""

    ID = "validatesurvey"
    ICON = "validate.svg"
    INPUT, OUTPUT = "INPUT", "OUTPUT"

    def texts(self) -> Texts:
        return Texts(
            tr("Validate against check points"),
            tr(
                "Compares feature points of one epoch with the same points surveyed by total station or GNSS. Check points never take part "
                "in the fit: their differences show the accuracy that was reached."
            ),
            tr("A check point is matched by the approximate centre of its unit; one that matches no unit is named and left out."),
            tr("validation,accuracy,check points,total station,GNSS,RMSE"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        self.add(
            QgsProcessingParameterFeatureSource(self.INPUT, tr("Feature points"), [Qgis.ProcessingSourceType.VectorPoint]),
            tr("Layer from Extract feature points, of one epoch."),
        )
        add_check(self, optional=False)
        self.add_layer_sink(self.OUTPUT, "check_residuals")
        self.addOutput(QgsProcessingOutputNumber("RMSE", tr("RMSE at check points (m)")))
        self.addOutput(QgsProcessingOutputNumber("POINT_COUNT", tr("Points")))

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        source = self.parameterAsSource(parameters, self.INPUT, context)
        check = self.parameterAsSource(parameters, CHECK, context)
        for name, given in ((self.INPUT, source), (CHECK, check)):
            if given is None:
                raise QgsProcessingException(self.invalidSourceError(parameters, name))
        with self.scratch() as scratch:
            folder = Path(scratch)
            features = write_layers([source], folder / "features.gpkg", "feature_points", context)
            table = write_points(check, CHECK_COLUMNS, folder / "check.csv", source.sourceCrs(), context, {"sd": CHECK_SD})
            result = folder / "result.gpkg"
            found = self.run_engine(["validate", str(features), "--check", str(table), "--output", str(result)], feedback)
            if found is None:
                return {}
            identifier, count = self.copy_to_sink(result, "check_residuals", parameters, self.OUTPUT, context)
        return {self.OUTPUT: identifier, "RMSE": found["rmse"], "POINT_COUNT": count}
