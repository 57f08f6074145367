"""As-built units against their design."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from qgis.core import QgsProcessingOutputNumber, QgsProcessingParameterFileDestination

from .base import Texts
from .result_algorithm import ResultAlgorithm
from .support.translation import tr


class CompareDesign(ResultAlgorithm):
    """Algorithm ``tetratrack:comparedesign``."""

    ID = "comparedesign"
    ICON = "validate.svg"
    COMMAND = "design"
    OUTSIDE, MISSING, OFF_PROFILE = "OUTSIDE", "MISSING", "OFF_PROFILE"
    NUMBERS: ClassVar[Mapping[str, str]] = {OUTSIDE: "outside", MISSING: "missing", OFF_PROFILE: "off_profile"}

    def texts(self) -> Texts:
        return Texts(
            tr("Compare with design"),
            tr(
                "Compares the units of one epoch with a placement plan and with a design profile: deviation and turn of every unit, places "
                "without a unit, distance from the design surface, and whether that is within the tolerance."
            ),
            tr(
                "A unit stands at the place of its own name, or at the nearest free one within one height H. Within or outside is said "
                "where the standard deviations leave no doubt of 5 % or more, open where they do."
            ),
            tr("design,plan,placement,profile,tolerance,as-built,DXF"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        self.add_result()
        self.add_plan()
        self.add_profile(judged=True)
        self.add_epoch()
        self.add_axis()
        self.add(
            QgsProcessingParameterFileDestination(self.OUTPUT, tr("Deviations"), "GeoPackage (*.gpkg)"),
            tr("GeoPackage with the layers plan_deviations, plan_unmatched and profile_deviations, those that were asked for."),
        )
        self.addOutput(QgsProcessingOutputNumber(self.OUTSIDE, tr("Units outside the tolerance of the plan")))
        self.addOutput(QgsProcessingOutputNumber(self.MISSING, tr("Planned places without a unit")))
        self.addOutput(QgsProcessingOutputNumber(self.OFF_PROFILE, tr("Units outside the tolerance of the profile")))
