"""Registration of an epoch's cloud to survey control."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFileDestination,
)

from .base import Texts
from .support.inputs import add_control, add_crs, add_epoch, add_tiles
from .support.translation import tr
from .survey_algorithm import SurveyAlgorithm


class RegisterToControl(SurveyAlgorithm):
    """Algorithm ``tetratrack:registertocontrol``."""

    ID = "registertocontrol"
    ICON = "register.svg"
    OUTPUT, RESIDUALS = "OUTPUT", "RESIDUALS"

    def texts(self) -> Texts:
        return Texts(
            tr("Register to control"),
            tr(
                "Estimates the rigid transformation from an epoch's cloud to survey control from targets, weighted by their standard "
                "deviations, and finds disturbed targets by data snooping on normalised residuals."
            ),
            tr("Needs three targets that do not lie in one line; an outlier is found from four, and named surely from five."),
            tr("registration,control points,targets,transformation,data snooping,georeferencing"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        add_tiles(self)
        add_control(self, optional=False)
        add_epoch(self)
        add_crs(self)
        self.add_layer_sink(self.RESIDUALS, "control_residuals")
        self.add(
            QgsProcessingParameterFileDestination(self.OUTPUT, tr("Registration"), "GeoPackage (*.gpkg)"),
            tr("GeoPackage whose table epochs holds the seven parameters and their covariance."),
        )
        self.addOutput(QgsProcessingOutputNumber("RMSE", tr("RMSE at control points (m)")))
        self.addOutput(QgsProcessingOutputNumber("OUTLIERS", tr("Disturbed targets")))

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        target = self.parameterAsFileOutput(parameters, self.OUTPUT, context)
        with self.scratch() as folder:
            survey = self.survey(Path(folder), parameters, context, feedback)
            found = survey and self.run_engine(["register", str(survey), "--output", target], feedback, 2, 100)
            if not found:
                return {}
        identifier, _ = self.copy_to_sink(Path(target), "control_residuals", parameters, self.RESIDUALS, context)
        return {self.OUTPUT: target, self.RESIDUALS: identifier, "RMSE": found["rmse"], "OUTLIERS": found["outliers"]}
