"""Write algorithms/stepsofoneepoch.model3, the chain of single steps as a model to start from; run with QGIS's Python."""

from __future__ import annotations

import sys
from pathlib import Path

from qgis.core import (
    Qgis,
    QgsApplication,
    QgsProcessingModelAlgorithm,
    QgsProcessingModelChildAlgorithm,
    QgsProcessingModelChildParameterSource,
    QgsProcessingModelOutput,
    QgsProcessingModelParameter,
    QgsProcessingParameterCrs,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
)
from qgis.PyQt.QtCore import QPointF

ROOT = Path(__file__).resolve().parents[2]
TARGET = ROOT / "algorithms" / "stepsofoneepoch.model3"


def given(name: str) -> list[QgsProcessingModelChildParameterSource]:
    """An input of the model as the value of a step's parameter."""
    return [QgsProcessingModelChildParameterSource.fromModelParameter(name)]


def made(step: str, output: str) -> list[QgsProcessingModelChildParameterSource]:
    """An output of an earlier step as the value of a step's parameter."""
    return [QgsProcessingModelChildParameterSource.fromChildOutput(step, output)]


def main() -> None:
    """Build and write the model."""
    sys.path.insert(0, str(ROOT / "scripts"))
    import engine

    engine.load_package()
    application = QgsApplication([], False)
    application.initQgis()
    from tetratrack.algorithms.provider import TetratrackProvider

    provider = TetratrackProvider()
    QgsApplication.processingRegistry().addProvider(provider)
    model = QgsProcessingModelAlgorithm("Steps of one epoch", "Monitoring")
    inputs = (
        QgsProcessingParameterMultipleLayers("TILES", "Point cloud tiles", Qgis.ProcessingSourceType.File),
        QgsProcessingParameterString("UNIT", "Type of unit", "tetrapod 8 t"),
        QgsProcessingParameterNumber("HEIGHT", "Height H of the unit (m)", Qgis.ProcessingNumberParameterType.Double, None, True, 1e-6),
        QgsProcessingParameterString("EPOCH", "Epoch", "1"),
        QgsProcessingParameterCrs("CRS", "CRS of the results"),
        QgsProcessingParameterFeatureSource("CHECK", "Check points", [Qgis.ProcessingSourceType.Vector]),
    )
    for number, definition in enumerate(inputs):
        parameter = QgsProcessingModelParameter(definition.name())
        parameter.setPosition(QPointF(150, 80 + 90 * number))
        model.addModelParameter(definition, parameter)
    epoch = {name: given(name) for name in ("TILES", "UNIT", "HEIGHT", "EPOCH", "CRS")}
    steps: tuple[tuple[str, str, dict[str, list[QgsProcessingModelChildParameterSource]], dict[str, str]], ...] = (
        ("segment", "segmenttetrapods", epoch, {}),
        ("fit", "fittetrapods", epoch | {"INPUT": made("segment", "UNITS")}, {"UNITS": "Units"}),
        ("features", "extractfeaturepoints", {"INPUT": made("fit", "UNITS")}, {"OUTPUT": "Feature points"}),
        ("validate", "validatesurvey", {"INPUT": made("features", "OUTPUT"), "CHECK": given("CHECK")}, {"OUTPUT": "Check residuals"}),
    )
    for number, (step, algorithm, parameters, outputs) in enumerate(steps):
        child = QgsProcessingModelChildAlgorithm(f"tetratrack:{algorithm}")
        child.setChildId(step)
        child.setDescription(child.algorithm().displayName())
        child.setPosition(QPointF(450 + 60 * number, 120 + 120 * number))
        for name, sources in parameters.items():
            child.addParameterSources(name, sources)
        finals = {}
        for name, label in outputs.items():
            output = QgsProcessingModelOutput(label, label)
            output.setChildId(step)
            output.setChildOutputName(name)
            output.setPosition(QPointF(760 + 60 * number, 160 + 120 * number))
            finals[label] = output
        child.setModelOutputs(finals)
        model.addChildAlgorithm(child)
    model.updateDestinationParameters()
    if not model.toFile(str(TARGET)):
        raise SystemExit(f"{TARGET} cannot be written")


if __name__ == "__main__":
    main()
