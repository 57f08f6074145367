"""Adjustment of the four-cone model to units found before."""

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

from .base import Texts
from .support.inputs import add_crs, add_epoch, add_tiles, add_unit
from .support.translation import tr
from .survey_algorithm import SurveyAlgorithm, write_layers


class FitTetrapods(SurveyAlgorithm):
    """Algorithm ``tetratrack:fittetrapods``."""

    ID = "fittetrapods"
    ICON = "fit.svg"
    INPUT, UNITS = "INPUT", "UNITS"

    def texts(self) -> Texts:
        return Texts(
            tr("Fit tetrapods"),
            tr(
                "Fits four equal cones that share a centre to the points of each unit by an iterated Gauss–Helmert adjustment with robust "
                "weights, end discs and removal of the curvature bias; gives pose, radius, taper and their covariance."
            ),
            tr("With one visible leg the twist about its axis is undetermined: the unit says so in its large standard deviation."),
            tr("adjustment,Gauss-Helmert,least squares,cone,pose,covariance"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        add_tiles(self)
        self.add(
            QgsProcessingParameterFeatureSource(self.INPUT, tr("Units found"), [Qgis.ProcessingSourceType.VectorPoint]),
            tr("Layer of units from Segment tetrapods, with the fields qx, qy, qz, qw of their orientation."),
        )
        add_unit(self)
        add_epoch(self)
        add_crs(self)
        self.add_layer_sink(self.UNITS, "units")
        self.addOutput(QgsProcessingOutputNumber("UNITS_FITTED", tr("Units fitted")))

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        source = self.parameterAsSource(parameters, self.INPUT, context)
        if source is None:
            raise QgsProcessingException(self.invalidSourceError(parameters, self.INPUT))
        with self.scratch() as scratch:
            folder = Path(scratch)
            units = write_layers([source], folder / "units.gpkg", "units", context)
            survey = self.survey(folder, parameters, context, feedback)
            result = folder / "result.gpkg"
            found = survey and self.run_engine(["fit", str(survey), "--units", str(units), "--output", str(result)], feedback, 2, 100)
            if not found:
                return {}
            identifier, count = self.copy_to_sink(result, "units", parameters, self.UNITS, context)
        return {self.UNITS: identifier, "UNITS_FITTED": count}
