"""Which displacement a planned survey will detect."""

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
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
)

from .base import Texts
from .support.inputs import add_unit_type, check_unit, unit_arguments
from .support.plan_chart import chart_page
from .support.translation import tr
from .survey_algorithm import SurveyAlgorithm

OUTPUTS = (
    *("points", "sd_centre", "sd_rotation_deg", "sd_displacement", "detectable_worst", "detectable_mean", "detectable_rotation_deg"),
    *("points_per_square", "recall_30", "recall_15", "recall_5"),
)


class PlanningDetectability(SurveyAlgorithm):
    """Algorithm ``tetratrack:planningdetectability``."""

    ID = "planningdetectability"
    GROUP = "planning"
    ICON = "plan.svg"
    CHART = "CHART"

    def texts(self) -> Texts:
        return Texts(
            tr("Plan a survey: detectable displacement"),
            tr(
                "Computes which displacement and rotation of a unit a planned survey will find, from point density, noise, visible share "
                "and registration: the Cramér–Rao bound of the adjustment for the unit's geometry, and Baarda's detectability."
            ),
            tr(
                "White noise is averaged over the points of a unit; whatever does not average out must be stated as systematic part. "
                "The shares of units found are those measured on simulated piles of that density and noise, seen from above."
            ),
            tr("planning,detectability,point density,noise,Cramér-Rao bound,minimal detectable displacement"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        add_unit_type(self)
        self.number(
            "DENSITY",
            tr("Point density (points/m²)"),
            200.0,
            tr("On a surface that faces the instrument, all flight strips or stations together."),
            least=1e-3,
        )
        self.number("NOISE", tr("Noise of a point (m)"), 0.02, tr("Standard deviation along the surface normal, in metres."), least=1e-6)
        self.number(
            "VISIBLE",
            tr("Visible share of a unit"),
            0.3,
            tr("Share of a unit's surface that holds points, 0 to 1; in a pile 0.05 to 0.5."),
            least=1e-3,
            most=1.0,
        )
        self.number(
            "REGISTRATION",
            tr("Registration (m)"),
            0.003,
            tr("Standard deviation of an epoch's registration at the unit, per coordinate, in metres."),
        )
        self.number(
            "SYSTEMATIC",
            tr("Systematic part (m)"),
            0.002,
            tr("Strip offsets, roughness and growth that do not average out, per coordinate, in metres."),
        )
        self.number(
            "TILT",
            tr("Line of sight from the vertical (degrees)"),
            0.0,
            tr("0 from the air; about 70 from the crown wall."),
            most=90.0,
            advanced=True,
        )
        self.add(
            QgsProcessingParameterBoolean("SHAPE_FIXED", tr("Radius and taper are known"), True),
            tr("Calibrated and held; otherwise they are estimated for every unit, which costs accuracy."),
            advanced=True,
        )
        self.number(
            "SIGNIFICANCE",
            tr("Level of significance"),
            0.001,
            tr("Probability of a false alarm for one unit."),
            least=1e-9,
            most=0.5,
            advanced=True,
        )
        self.number(
            "POWER", tr("Power"), 0.8, tr("Probability with which the displacement is found."), least=0.01, most=0.9999, advanced=True
        )
        self.add(
            QgsProcessingParameterFileDestination(self.CHART, tr("Chart"), tr("Web page (*.html)"), optional=True),
            tr("What the survey detects over point density and visible share, beside the plan."),
        )
        labels = (
            tr("Points on a unit"),
            tr("Standard deviation of the centre (m)"),
            tr("Standard deviation of the rotation (degrees)"),
            tr("Standard deviation of a displacement (m)"),
            tr("Detectable displacement, worst direction (m)"),
            tr("Detectable displacement, mean (m)"),
            tr("Detectable rotation (degrees)"),
            tr("Points per square of a unit's height"),
            tr("Share found of the units seen to 30 % or more"),
            tr("Share found of the units seen to 15–30 %"),
            tr("Share found of the units seen to 5–15 %"),
        )
        for name, label in zip(OUTPUTS, labels):
            self.addOutput(QgsProcessingOutputNumber(name.upper(), label))

    def number(
        self, name: str, label: str, default: float, help_text: str, *, least: float = 0.0, most: float = 1e9, advanced: bool = False
    ) -> None:
        """Add a number with its bounds."""
        self.add(
            QgsProcessingParameterNumber(name, label, Qgis.ProcessingNumberParameterType.Double, default, False, least, most),
            help_text,
            advanced=advanced,
        )

    def checkParameterValues(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        problem = check_unit(self, parameters, context)
        if not problem and self.parameterAsDouble(parameters, "SIGNIFICANCE", context) >= self.parameterAsDouble(
            parameters, "POWER", context
        ):
            problem = tr("The level of significance must be below the power.")
        return (False, problem) if problem else super().checkParameterValues(parameters, context)

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        arguments = ["plan", *unit_arguments(self, parameters, context)]
        for name in ("DENSITY", "NOISE", "VISIBLE", "REGISTRATION", "SYSTEMATIC", "TILT", "SIGNIFICANCE", "POWER"):
            arguments += [f"--{name.lower()}", repr(self.parameterAsDouble(parameters, name, context))]
        arguments.append("--shape-fixed" if self.parameterAsBoolean(parameters, "SHAPE_FIXED", context) else "--shape-free")
        chart = self.parameterAsFileOutput(parameters, self.CHART, context) if parameters.get(self.CHART) else ""
        found = self.run_engine([*arguments, *(["--curves"] if chart else [])], feedback)
        if found is None:
            return {}
        rows = []
        for definition in self.outputDefinitions():
            if definition.name().lower() in OUTPUTS:
                rows.append((definition.description(), f"{found[definition.name().lower()]:.4g}"))
                feedback.pushInfo(": ".join(rows[-1]))
        outputs = {name.upper(): found[name] for name in OUTPUTS}
        if chart:
            density, visible = (self.parameterAsDouble(parameters, name, context) for name in ("DENSITY", "VISIBLE"))
            try:
                Path(chart).write_text(chart_page(found, rows, density, visible), encoding="utf-8")
            except OSError as error:
                raise QgsProcessingException(tr("{file} cannot be written: {reason}.").format(file=chart, reason=error.strerror)) from error
            outputs[self.CHART] = chart
        return outputs
