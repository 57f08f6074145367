"""Identity, congruence and displacements between epochs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import (
    Qgis,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterMultipleLayers,
)

from .base import TetratrackAlgorithm, Texts
from .support.inputs import add_frame, frame_value
from .support.same_crs import crs_name, same_crs
from .support.translation import tr
from .survey_algorithm import write_layers


class TrackDisplacements(TetratrackAlgorithm):
    """Algorithm ``tetratrack:trackdisplacements``."""

    ID = "trackdisplacements"
    ICON = "track.svg"
    INPUT, REGISTRATIONS, UNITS, OUTPUT = "INPUT", "REGISTRATIONS", "UNITS", "OUTPUT"

    def texts(self) -> Texts:
        return Texts(
            tr("Track displacements"),
            tr(
                "Recognises each unit in all epochs, finds the stable units by a global congruence test and tests the displacement of "
                "every feature point and the rotation of every unit against it, with the covariance of fit and registration."
            ),
            tr("A rotation near 60° or more is ambiguous by the symmetry of the tetrapod and is reported as such."),
            tr("displacement,deformation analysis,congruence test,epoch,monitoring"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        self.add(
            QgsProcessingParameterMultipleLayers(self.INPUT, tr("Fitted units of all epochs"), Qgis.ProcessingSourceType.VectorPoint),
            tr("Layers of units from Fit tetrapods: one per epoch, each with its own label and time, all in one CRS."),
        )
        self.add(
            QgsProcessingParameterMultipleLayers(self.REGISTRATIONS, tr("Registrations"), Qgis.ProcessingSourceType.File, optional=True),
            tr("GeoPackages from Register to control, one per epoch; without them the clouds' own frames are taken as registered."),
        )
        add_frame(self)
        self.add_layer_sink(self.UNITS, "units")
        self.add_layer_sink(self.OUTPUT, "displacements")
        self.addOutput(QgsProcessingOutputNumber("UNITS_MOVED", tr("Units moved")))

    def checkParameterValues(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        if not self.parameterAsLayerList(parameters, self.INPUT, context):
            return False, tr("Give the units of at least two epochs.")
        return super().checkParameterValues(parameters, context)

    def prepareAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> bool:
        # copies belong to this run, so that the thread need not touch layers of the project
        self.layers = [layer.clone() for layer in self.parameterAsLayerList(parameters, self.INPUT, context)]
        first = self.layers[0].crs()
        if not all(same_crs(layer.crs(), first) for layer in self.layers):
            named = ", ".join(f"{layer.name()} ({crs_name(layer.crs()) or tr('no CRS')})" for layer in self.layers)
            raise QgsProcessingException(tr("The layers of units have different CRS: {crs}.").format(crs=named))
        return True

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        with self.scratch() as scratch:
            folder = Path(scratch)
            units = write_layers(self.layers, folder / "units.gpkg", "units", context)
            result = folder / "result.gpkg"
            arguments = ["track", str(units), "--output", str(result), "--frame", frame_value(self, parameters, context)]
            for registration in self.parameterAsFileList(parameters, self.REGISTRATIONS, context):
                arguments += ["--registration", registration]
            found = self.run_engine(arguments, feedback)
            if found is None:
                return {}
            units_sink, _ = self.copy_to_sink(result, "units", parameters, self.UNITS, context)
            identifier, _ = self.copy_to_sink(result, "displacements", parameters, self.OUTPUT, context)
        return {self.UNITS: units_sink, self.OUTPUT: identifier, "UNITS_MOVED": found["moved"]}
