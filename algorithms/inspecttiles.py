"""Tile index: extent, CRS, density and sensors of LAS/LAZ tiles."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import (
    Qgis,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingOutputString,
    QgsProcessingParameterFeatureSink,
)

from .base import TetratrackAlgorithm, Texts
from .support.inputs import TILES, add_tiles, tile_paths
from .support.translation import tr


class InspectTiles(TetratrackAlgorithm):
    """Algorithm ``tetratrack:inspecttiles``."""

    ID = "inspecttiles"
    ICON = "inspect.svg"
    OUTPUT = "OUTPUT"

    def texts(self) -> Texts:
        return Texts(
            tr("Inspect tiles"),
            tr(
                "Lists point cloud tiles with their extent, CRS, number and density of points and range of heights. "
                "Run it first: it shows missing CRS, gaps, overlaps and tiles too thin to find units in."
            ),
            tr("Reads headers and a sample of points; a damaged tile is named and ends the run."),
            tr("point cloud,LAS,LAZ,tile index,density,CRS,extent"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        add_tiles(self)
        self.add(
            QgsProcessingParameterFeatureSink(self.OUTPUT, tr("Tile index"), Qgis.ProcessingSourceType.VectorPolygon),
            tr("One rectangle per tile with file, CRS, points, density (points/m²) and heights (m)."),
        )
        self.addOutput(QgsProcessingOutputNumber("TILE_COUNT", tr("Tiles")))
        self.addOutput(QgsProcessingOutputNumber("POINT_COUNT", tr("Points")))
        self.addOutput(QgsProcessingOutputNumber("DENSITY", tr("Median density (points/m²)")))
        self.addOutput(QgsProcessingOutputString("TILES_CRS", tr("CRS of the tiles")))

    def prepareAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> bool:
        self.tiles = tile_paths(parameters[TILES], context, self.parameterDefinition(TILES).description())
        return True

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        with self.scratch() as folder:
            index = Path(folder) / "tiles.gpkg"
            found = self.run_engine(["inspect", *self.tiles, "--output", str(index)], feedback)
            if found is None:
                return {}
            identifier, _ = self.copy_to_sink(index, "tiles", parameters, self.OUTPUT, context)
        return {
            self.OUTPUT: identifier,
            "TILE_COUNT": found["tiles"],
            "POINT_COUNT": found["points"],
            "DENSITY": found["density"],
            "TILES_CRS": found["crs"],
        }
