"""Points of an epoch less its blocks."""

from __future__ import annotations

from typing import Any

from qgis.core import QgsProcessingParameterFileDestination

from .base import Texts
from .result_algorithm import ResultAlgorithm
from .support.translation import tr


class ResidualPoints(ResultAlgorithm):
    """Algorithm ``tetratrack:residualpoints``."""

    ID = "residualpoints"
    ICON = "fit.svg"
    COMMAND = "residuals"

    def texts(self) -> Texts:
        return Texts(
            tr("Points less blocks"),
            tr(
                "Writes the points around the units of one epoch with their distance to the nearest fitted unit, coloured from blue "
                "(10 cm or more within a body) through white to red (10 cm or more outside): what is red is debris, a "
                "unit that was missed, or one that is broken."
            ),
            tr(
                "Points are those read around the units for the review (unit-points), in the control frame. For units lower than 2 m, and "
                "models of a tank, colours end at 5 % of the height H instead of 10 cm; points near no unit have the distance 10 m."
            ),
            tr("residuals,LAZ,LAS,point cloud,distance"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        self.add_result()
        self.add_epoch()
        self.add(
            QgsProcessingParameterFileDestination(self.OUTPUT, tr("Points"), "LAZ (*.laz);;LAS (*.las)"),
            tr("Point cloud with the dimensions distance (m) and unit."),
        )
