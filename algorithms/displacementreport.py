"""Report of a reviewed result."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    Qgis,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
)

from ..plugin.translation import language_of, tr, user_locale
from .base import TetratrackAlgorithm, Texts


class DisplacementReport(TetratrackAlgorithm):
    """Algorithm ``tetratrack:displacementreport``."""

    ID = "displacementreport"
    GROUP = "monitoring"
    ICON = "report.svg"
    INPUT, OUTPUT = "INPUT", "OUTPUT"

    def texts(self) -> Texts:
        return Texts(
            tr("Displacement report"),
            tr(
                "Writes the report of a result as reviewed so far: summary, control quality, displacement map and table, worst units, "
                "damage figures, method, settings and versions."
            ),
            tr("Rejected units are left out of the statistics and listed apart. PDF needs the library weasyprint in the engine."),
            tr("report,HTML,PDF,damage,displacement"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        self.add(
            QgsProcessingParameterFile(
                self.INPUT, tr("Result"), Qgis.ProcessingFileParameterBehavior.File, fileFilter="GeoPackage (*.gpkg)"
            ),
            tr("GeoPackage written by Monitor a survey."),
        )
        self.add(
            QgsProcessingParameterFileDestination(self.OUTPUT, tr("Report"), "HTML (*.html);;PDF (*.pdf)"),
            tr("HTML in one file, or PDF; the ending decides."),
        )

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        result = self.parameterAsFile(parameters, self.INPUT, context)
        target = self.parameterAsFileOutput(parameters, self.OUTPUT, context)
        if not result:
            raise QgsProcessingException(self.invalidSourceError(parameters, self.INPUT))
        arguments = ["report", result, "--output", target, "--language", language_of(user_locale()) or "en"]
        return {} if self.run_engine(arguments, feedback) is None else {self.OUTPUT: target}
