"""Several views of a depth camera or scanner into one frame."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    Qgis,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
)

from .base import TetratrackAlgorithm, Texts
from .support.inputs import TILES, add_tiles, tile_paths
from .support.translation import tr


class RegisterViews(TetratrackAlgorithm):
    """Algorithm ``tetratrack:registerviews``."""

    ID = "registerviews"
    ICON = "views.svg"
    OUTPUT, VOXEL = "OUTPUT", "VOXEL"

    def texts(self) -> Texts:
        return Texts(
            tr("Register views"),
            tr(
                "Brings overlapping views of a depth camera or scanner stations into the frame of the first by multiway ICP with a pose "
                "graph, and writes one cloud in which every view keeps its number as point source id."
            ),
            tr("Views must overlap by a third or more and be roughly aligned; views that do not connect are named."),
            tr("registration,ICP,pose graph,depth camera,multi-view"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        add_tiles(self, label=tr("Views"))
        self.add(
            QgsProcessingParameterNumber(self.VOXEL, tr("Voxel size (m)"), Qgis.ProcessingNumberParameterType.Double, None, True, 1e-6),
            tr("Resolution at which views are matched, in metres; empty derives it from the point spacing."),
            advanced=True,
        )
        self.add(
            QgsProcessingParameterFileDestination(self.OUTPUT, tr("Registered cloud"), "LAZ (*.laz)"),
            tr("One LAZ file in the frame of the first view."),
        )
        self.addOutput(QgsProcessingOutputNumber("VIEW_COUNT", tr("Views")))
        self.addOutput(QgsProcessingOutputNumber("RMSE", tr("RMSE between views (m)")))

    def prepareAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> bool:
        self.views = tile_paths(parameters[TILES], context, self.parameterDefinition(TILES).description())
        return True

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        target = self.parameterAsFileOutput(parameters, self.OUTPUT, context)
        arguments = ["register-views", *self.views, "--output", target]
        if parameters.get(self.VOXEL) is not None:
            arguments += ["--voxel", repr(self.parameterAsDouble(parameters, self.VOXEL, context))]
        found = self.run_engine(arguments, feedback)
        return {} if found is None else {self.OUTPUT: target, "VIEW_COUNT": len(self.views), "RMSE": found["rmse"]}
