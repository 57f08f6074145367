"""As-built model of a result."""

from __future__ import annotations

from typing import Any

from qgis.core import QgsProcessingParameterFileDestination

from .base import Texts
from .result_algorithm import ResultAlgorithm
from .support.translation import tr


class ExportModel(ResultAlgorithm):
    """Algorithm ``tetratrack:exportmodel``."""

    ID = "exportmodel"
    ICON = "model.svg"
    COMMAND = "model"

    def texts(self) -> Texts:
        return Texts(
            tr("Export as-built model"),
            tr(
                "Writes the units of one epoch as bodies at their fitted poses, coloured by class, with uncertainty and movement as "
                "properties, for CAD, BIM and 3D viewers. The ending of the file chooses the format: glTF (.glb), Wavefront (.obj), "
                "DXF, IFC4x3 or the poses alone (.json)."
            ),
            tr(
                "Bodies have 24 plane faces a leg. glTF, OBJ, IFC and JSON hold coordinates less a reduction point that stands in the "
                "file; DXF holds coordinates of the survey CRS and needs the library ezdxf in the engine."
            ),
            tr("model,3D,glTF,GLB,OBJ,DXF,IFC,BIM,CAD,as-built"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        self.add_result()
        self.add_epoch(tr("Label of the epoch whose units are written; the latest one with units unless given."))
        formats = "glTF (*.glb);;Wavefront OBJ (*.obj);;DXF (*.dxf);;IFC (*.ifc);;JSON (*.json)"
        self.add(
            QgsProcessingParameterFileDestination(self.OUTPUT, tr("Model"), formats),
            tr("File to write; its ending decides the format."),
        )
