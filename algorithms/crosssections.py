"""Cross-sections, crest and settlement of a result."""

from __future__ import annotations

from typing import Any

from qgis.core import QgsProcessingParameterFileDestination

from .base import Texts
from .result_algorithm import ResultAlgorithm
from .support.translation import tr


class CrossSections(ResultAlgorithm):
    """Algorithm ``tetratrack:crosssections``."""

    ID = "crosssections"
    ICON = "track.svg"
    COMMAND = "profiles"

    def texts(self) -> Texts:
        return Texts(
            tr("Cross-sections and crest"),
            tr(
                "Cuts the structure across its axis: outlines of the blocks of every epoch, surface of the points and design in each "
                "section, height and width of the crest of each reach, and settlement along the structure."
            ),
            tr("Points are those read around the units for the review (unit-points); without them sections show blocks alone."),
            tr("profile,section,crest,settlement,chainage"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        self.add_result()
        self.add_step()
        self.add_profile(judged=False)
        self.add_axis()
        self.add(
            QgsProcessingParameterFileDestination(self.OUTPUT, tr("Sections"), "GeoPackage (*.gpkg)"),
            tr("GeoPackage with the layers sections, crest and settlement."),
        )
