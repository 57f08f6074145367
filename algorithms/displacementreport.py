"""Report of a reviewed result."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    Qgis,
    QgsProcessingContext,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
)

from .base import Texts
from .result_algorithm import ResultAlgorithm
from .support.translation import language_of, tr, user_locale


class DisplacementReport(ResultAlgorithm):
    """Algorithm ``tetratrack:displacementreport``."""

    ID = "displacementreport"
    ICON = "report.svg"
    COMMAND = "report"
    FROM, TO, DATUM, WIDTH, SECTION, WORST = "FROM", "TO", "DATUM", "WIDTH", "SECTION", "WORST"
    DATUMS = ("", "stable", "control")
    BANDS = "BANDS"
    PRESETS = ("usace", "cm", "dn")

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
        self.add_result()
        pair = tr("Label of an epoch; empty for both takes the latest pair.")
        self.add(QgsProcessingParameterString(self.FROM, tr("Earlier epoch"), optional=True), pair)
        self.add(QgsProcessingParameterString(self.TO, tr("Later epoch"), optional=True), pair)
        datums = [tr("that of the result"), tr("stable units and control"), tr("control points alone")]
        self.add(
            QgsProcessingParameterEnum(self.DATUM, tr("Reference of the displacements"), datums, False, 0),
            tr("What the displacements are stated against, in all of the report."),
        )
        self.add(
            QgsProcessingParameterString(self.AXIS, tr("Axis of the structure"), optional=True),
            tr("Places easting,northing along it, separated by blanks; damage is then stated by sections."),
            advanced=True,
        )
        for name, label, meaning in (
            (self.WIDTH, tr("Length looked at (m)"), tr("Length of the structure in metres, for the damage number N_od.")),
            (self.SECTION, tr("Length of a section (m)"), tr("Length of the sections along the axis, in metres.")),
        ):
            number = QgsProcessingParameterNumber(name, label, Qgis.ProcessingNumberParameterType.Double, None, True, 1e-3)
            self.add(number, meaning, advanced=True)
        bands = [tr("0.09, 0.30 and 0.61 m (US Army Corps of Engineers)"), tr("5 and 10 cm"), tr("0.5 and 1 Dn (nominal diameter)")]
        self.add(
            QgsProcessingParameterEnum(self.BANDS, tr("Movement bands"), bands, False, 0),
            tr("Limits by which the units are counted that moved."),
        )
        self.add_step(advanced=True)
        self.add_plan(advanced=True)
        self.add_profile(judged=True, advanced=True)
        self.add(
            QgsProcessingParameterNumber(
                self.WORST, tr("Units shown one by one"), Qgis.ProcessingNumberParameterType.Integer, 8, False, 0, 500
            ),
            tr("So many of those that moved most get views, series and decisions of their own."),
            advanced=True,
        )
        self.add(
            QgsProcessingParameterFileDestination(self.OUTPUT, tr("Report"), "HTML (*.html);;PDF (*.pdf)"),
            tr("HTML in one file, or PDF; the ending decides."),
        )

    def checkParameterValues(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        ends = [bool(self.parameterAsString(parameters, name, context).strip()) for name in (self.FROM, self.TO)]
        if ends[0] != ends[1]:
            return False, tr("Give both epochs, or neither for the latest pair.")
        return super().checkParameterValues(parameters, context)

    def more_arguments(self, parameters: dict[str, Any], context: QgsProcessingContext) -> list[str]:
        chosen = [
            ("--language", language_of(user_locale()) or "en"),
            ("--from", self.parameterAsString(parameters, self.FROM, context).strip()),
            ("--to", self.parameterAsString(parameters, self.TO, context).strip()),
            ("--datum", self.DATUMS[self.parameterAsEnum(parameters, self.DATUM, context)]),
            ("--bands", self.PRESETS[self.parameterAsEnum(parameters, self.BANDS, context)]),
            ("--worst", str(self.parameterAsInt(parameters, self.WORST, context))),
        ]
        for option, name in (("--width", self.WIDTH), ("--section", self.SECTION)):
            if parameters.get(name) is not None:
                chosen.append((option, repr(self.parameterAsDouble(parameters, name, context))))
        return [word for option, value in chosen if value for word in (option, value)]
