"""Simulated survey with known displacements."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    Qgis,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingOutputFile,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterNumber,
)

from .base import Texts
from .support.inputs import add_unit_type, unit_arguments
from .support.translation import tr
from .survey_algorithm import SurveyAlgorithm

INSTRUMENTS = ("uav", "tls", "photogrammetry", "depth_camera")


class SimulateSurvey(SurveyAlgorithm):
    """Algorithm ``tetratrack:simulatesurvey``."""

    ID = "simulatesurvey"
    GROUP = "planning"
    ICON = "simulate.svg"
    OUTPUT, SURVEY = "OUTPUT", "SURVEY"

    def texts(self) -> Texts:
        return Texts(
            tr("Simulate a survey"),
            tr(
                "Writes a simulated survey of a tetrapod slope with known poses: LAZ tiles, control, check points and survey.toml. "
                "Use it to try the chain, to train, or to test a planned density and noise."
            ),
            tr("Simulated surfaces are cleaner than real ones; judge a plan with some reserve."),
            tr("simulation,synthetic,ground truth,test data"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        add_unit_type(self)
        instruments = [tr("UAV laser scanner"), tr("terrestrial laser scanner"), tr("photogrammetry"), tr("depth camera")]
        self.add(
            QgsProcessingParameterEnum("INSTRUMENT", tr("Instrument"), instruments, False, 0),
            tr("Decides viewpoints, hidden parts and, unless stated, noise and density."),
        )
        integer, real = Qgis.ProcessingNumberParameterType.Integer, Qgis.ProcessingNumberParameterType.Double
        self.add(QgsProcessingParameterNumber("UNITS", tr("Units"), integer, 50, False, 1, 5000), tr("Number of units on the slope."))
        self.add(
            QgsProcessingParameterNumber("EPOCHS", tr("Epochs"), integer, 2, False, 1, 20),
            tr("Number of surveys; some units move between them."),
        )
        self.add(
            QgsProcessingParameterNumber("NOISE", tr("Noise of a point (m)"), real, None, True, 0, 1),
            tr("Standard deviation of the range, in metres; empty takes that of the instrument."),
        )
        self.add(
            QgsProcessingParameterNumber("DENSITY", tr("Point density (points/m²)"), real, None, True, 1, 1e6),
            tr("On the ground; empty takes that of the instrument."),
        )
        self.add(
            QgsProcessingParameterNumber("LENGTH", tr("Length of a coast (m)"), real, None, True, 1, 10000),
            tr("A coast of this length, of stretches that hold the number of units each; empty gives one site."),
            advanced=True,
        )
        self.add(
            QgsProcessingParameterNumber("BEND", tr("Bend of every epoch (m)"), real, None, True, 0, 1),
            tr("Error of the trajectory along the site in metres, root mean square of each coordinate; empty for none."),
            advanced=True,
        )
        self.add(
            QgsProcessingParameterNumber("SEED", tr("Seed"), integer, 0, False, 0),
            tr("The same seed gives the same survey."),
            advanced=True,
        )
        self.add(
            QgsProcessingParameterFolderDestination(self.OUTPUT, tr("Survey folder")),
            tr("Receives tiles, CSV files, survey.toml and truth."),
        )
        self.addOutput(QgsProcessingOutputFile(self.SURVEY, tr("survey.toml of the simulated survey")))

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        target = self.parameterAsString(parameters, self.OUTPUT, context)
        arguments = ["simulate", "--output", target, *unit_arguments(self, parameters, context)]
        for name in ("UNITS", "EPOCHS", "SEED"):
            arguments += [f"--{name.lower()}", str(self.parameterAsInt(parameters, name, context))]
        for name in ("NOISE", "DENSITY", "LENGTH", "BEND"):
            if parameters.get(name) is not None:
                arguments += [f"--{name.lower()}", repr(self.parameterAsDouble(parameters, name, context))]
        arguments += ["--instrument", INSTRUMENTS[self.parameterAsEnum(parameters, "INSTRUMENT", context)]]
        found = self.run_engine(arguments, feedback)
        return {} if found is None else {self.OUTPUT: target, self.SURVEY: found["survey"]}
