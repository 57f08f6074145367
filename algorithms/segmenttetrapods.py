"""Tetrapods found in an epoch's point cloud."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import QgsProcessingContext, QgsProcessingFeedback, QgsProcessingOutputNumber

from .base import Texts
from .support.inputs import WORKERS, add_area, add_crs, add_epoch, add_tiles, add_unit, add_workers
from .support.translation import tr
from .survey_algorithm import SurveyAlgorithm


class SegmentTetrapods(SurveyAlgorithm):
    """Algorithm ``tetratrack:segmenttetrapods``."""

    ID = "segmenttetrapods"
    ICON = "segment.svg"
    UNITS = "UNITS"

    def texts(self) -> Texts:
        return Texts(
            tr("Segment tetrapods"),
            tr(
                "Finds every tetrapod in a pile: cones from pairs of oriented points, legs that agree on a common centre and on the angles "
                "between them, and verification against the visible surface and against empty space."
            ),
            tr(
                "Units of which less than about 5 % is seen are not found; weak evidence has the status uncertain. Poses are approximate: "
                "fit them next."
            ),
            tr("segmentation,RANSAC,cone,tetrapod,armour unit,detection"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        add_tiles(self)
        add_unit(self)
        add_epoch(self)
        add_crs(self)
        add_area(self)
        add_workers(self)
        self.add_layer_sink(self.UNITS, "units")
        self.addOutput(QgsProcessingOutputNumber("UNITS_FOUND", tr("Units found")))

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        with self.scratch() as scratch:
            folder = Path(scratch)
            survey = self.survey(folder, parameters, context, feedback)
            result = folder / "result.gpkg"
            workers = str(self.parameterAsInt(parameters, WORKERS, context))
            arguments = ["segment", str(survey), "--output", str(result), "--workers", workers]
            found = survey and self.run_engine(arguments, feedback, 2, 100)
            if not found:
                return {}
            identifier, count = self.copy_to_sink(result, "units", parameters, self.UNITS, context)
        return {self.UNITS: identifier, "UNITS_FOUND": count}
