"""survey.toml from a folder of tiles: epochs, CRS, tables and the size of the units, each with its reason."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    Qgis,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterCrs,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
)

from .base import TetratrackAlgorithm, Texts
from .support.inputs import TILES, TilesParameter, crs_text, tile_paths
from .support.translation import tr


class NewSurvey(TetratrackAlgorithm):
    """Algorithm ``tetratrack:newsurvey``."""

    ID = "newsurvey"
    ICON = "inspect.svg"
    FOLDER, CRS, HEIGHT, OUTPUT = "FOLDER", "CRS", "HEIGHT", "OUTPUT"

    def texts(self) -> Texts:
        return Texts(
            tr("New survey from a folder"),
            tr(
                "Writes a survey.toml from what the files in a folder say: epochs and times, CRS, control, targets and check points, "
                "and the size of the units from the cloud itself."
            ),
            tr("Every value stands with its reason; what the files leave open is asked for in the log."),
            tr("new survey,folder,tiles,epochs,size of units,survey.toml"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        self.add(
            QgsProcessingParameterFile(self.FOLDER, tr("Folder of tiles"), Qgis.ProcessingFileParameterBehavior.Folder, optional=True),
            tr("Folder with the tiles of all epochs; tables of control lie in it or beside it."),
        )
        tiles = TilesParameter(TILES, tr("Point cloud tiles"))
        tiles.setFlags(tiles.flags() | Qgis.ProcessingParameterFlag.Optional)
        self.add(tiles, tr("Instead of a folder: point cloud layers, or files, of all epochs."))
        self.add(
            QgsProcessingParameterCrs(self.CRS, tr("CRS of the results"), optional=True),
            tr("Projected CRS in metres; needed only where the tiles declare none."),
        )
        self.add(
            QgsProcessingParameterNumber(
                self.HEIGHT, tr("Height of the units (m)"), Qgis.ProcessingNumberParameterType.Double, optional=True, minValue=0.01
            ),
            tr("Empty estimates it from the cloud."),
        )
        self.add(
            QgsProcessingParameterFileDestination(self.OUTPUT, tr("Survey"), "TOML (*.toml)"),
            tr("Text file to look through, correct and run."),
        )

    def checkParameterValues(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        if not parameters.get(self.FOLDER) and not parameters.get(TILES):
            return False, tr("Give a folder of tiles, or tiles.")
        return super().checkParameterValues(parameters, context)

    def prepareAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> bool:
        given = parameters.get(TILES)
        self.tiles = tile_paths(given, context, self.parameterDefinition(TILES).description()) if given else []
        return True

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        folder = self.parameterAsFile(parameters, self.FOLDER, context)
        target = self.parameterAsFileOutput(parameters, self.OUTPUT, context)
        arguments = ["init", *([folder] if folder else []), *self.tiles, "--output", target]
        crs = self.parameterAsCrs(parameters, self.CRS, context)
        if crs.isValid():
            arguments += ["--crs", crs_text(crs)]
        if parameters.get(self.HEIGHT) is not None:
            arguments += ["--height", repr(self.parameterAsDouble(parameters, self.HEIGHT, context))]
        return {} if self.run_engine(arguments, feedback) is None else {self.OUTPUT: target}
