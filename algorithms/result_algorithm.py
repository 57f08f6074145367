"""What algorithms on a finished result share: result, epoch, design and axis as options of the engine, and one file as output."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from qgis.core import (
    Qgis,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFile,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
)

from .base import TetratrackAlgorithm
from .support.translation import tr

REFERENCES = ("outer", "centre")


class ResultAlgorithm(TetratrackAlgorithm):
    """Base of the algorithms on a finished result."""

    GROUP = "monitoring"
    COMMAND = ""
    """Of the engine."""
    NUMBERS: ClassVar[Mapping[str, str]] = {}
    """Outputs, by what the engine calls them."""
    INPUT, EPOCH, OUTPUT = "INPUT", "EPOCH", "OUTPUT"
    PLAN, TOLERANCE, TURN = "PLAN", "TOLERANCE", "TURN_TOLERANCE"
    PROFILE, PROFILE_TOLERANCE, REFERENCE, AXIS, STEP = "PROFILE", "PROFILE_TOLERANCE", "REFERENCE", "AXIS", "STEP"

    def add_result(self) -> None:
        """Add the result."""
        kind = Qgis.ProcessingFileParameterBehavior.File
        self.add(
            QgsProcessingParameterFile(self.INPUT, tr("Result"), kind, fileFilter="GeoPackage (*.gpkg)"),
            tr("GeoPackage written by Monitor a survey."),
        )

    def add_epoch(self, meaning: str = "") -> None:
        """Add the epoch looked at; ``meaning`` says what for where that is not all."""
        usual = tr("Label of the epoch whose units are looked at; the latest one with units unless given.")
        self.add(QgsProcessingParameterString(self.EPOCH, tr("Epoch"), optional=True), meaning or usual)

    def add_plan(self, *, advanced: bool = False) -> None:
        """Add a placement plan with its tolerances."""
        self.add(
            self._file(self.PLAN, tr("Placement plan"), "*.csv *.gpkg *.geojson *.shp"),
            tr(
                "Path of a CSV unit_id,easting,northing,height with the planned centres, optionally qx,qy,qz,qw, or of a layer of points "
                "with heights (FILE|layername=NAME)."
            ),
            advanced=advanced,
        )
        turns = tr("Degrees a unit may be turned from its planned orientation.")
        self._add_number(self.TOLERANCE, tr("Tolerance of places (m)"), tr("Metres a unit may be from its planned place."), advanced)
        self._add_number(self.TURN, tr("Tolerance of turns (°)"), turns, advanced)

    def add_profile(self, *, judged: bool, advanced: bool = False) -> None:
        """Add a design profile, with its tolerance where units are ``judged`` by it."""
        self.add(
            self._file(self.PROFILE, tr("Design profile"), "*.dxf *.gpkg *.geojson *.shp"),
            tr(
                "Path of a DXF or of a layer of lines with heights: a single line is a cross-section along the whole structure, several "
                "are its edges."
            ),
            advanced=advanced,
        )
        if judged:
            meaning = tr("Metres a unit may be off the design profile.")
            self._add_number(self.PROFILE_TOLERANCE, tr("Tolerance of the profile (m)"), meaning, advanced)
            words = [tr("outermost point of a unit"), tr("centre of a unit")]
            self.add(
                QgsProcessingParameterEnum(self.REFERENCE, tr("Judged against the profile"), words, False, 0),
                tr("What is judged against the design profile; both distances are written."),
                advanced=True,
            )

    def add_axis(self) -> None:
        """Add the structure's axis."""
        self.add(
            QgsProcessingParameterString(self.AXIS, tr("Axis of the structure"), optional=True),
            tr("Places easting,northing along it, separated by blanks; the centreline of the units unless given."),
            advanced=True,
        )

    def add_step(self, *, advanced: bool = False) -> None:
        """Add the distance of the cross-sections."""
        step = QgsProcessingParameterNumber(
            self.STEP, tr("Distance of the sections (m)"), Qgis.ProcessingNumberParameterType.Double, None, True, 0.1
        )
        self.add(step, tr("Metres along the axis; four heights of a unit unless given."), advanced=advanced)

    def _file(self, name: str, label: str, endings: str) -> QgsProcessingParameterFile:
        """An optional file that can be looked for; any other name may be typed, also one of a layer in a file."""
        kind = Qgis.ProcessingFileParameterBehavior.File
        found = f"{label} ({endings});;{tr('All files (*.*)')}"
        return QgsProcessingParameterFile(name, label, kind, optional=True, fileFilter=found)

    def _add_number(self, name: str, label: str, meaning: str, advanced: bool) -> None:
        number = QgsProcessingParameterNumber(name, label, Qgis.ProcessingNumberParameterType.Double, None, True, 0.0)
        self.add(number, meaning, advanced=advanced)

    def arguments(self, command: str, parameters: dict[str, Any], context: QgsProcessingContext, target: str) -> list[str]:
        """Arguments of the engine for what was chosen."""
        result = self.parameterAsFile(parameters, self.INPUT, context)
        if not result:
            raise QgsProcessingException(self.invalidSourceError(parameters, self.INPUT))
        arguments = [command, result, "--output", target]
        texts = (("--epoch", self.EPOCH), ("--plan", self.PLAN), ("--profile", self.PROFILE), ("--axis", self.AXIS))
        numbers = (
            ("--tolerance", self.TOLERANCE), ("--turn-tolerance", self.TURN), ("--profile-tolerance", self.PROFILE_TOLERANCE),
            ("--step", self.STEP),
        )  # fmt: skip
        for option, name in texts:
            if self.parameterDefinition(name) is not None and (text := self.parameterAsString(parameters, name, context).strip()):
                arguments += [option, text]
        for option, name in numbers:
            if self.parameterDefinition(name) is not None and parameters.get(name) is not None:
                arguments += [option, repr(self.parameterAsDouble(parameters, name, context))]
        if self.parameterDefinition(self.REFERENCE) is not None:
            arguments += ["--reference", REFERENCES[self.parameterAsEnum(parameters, self.REFERENCE, context)]]
        return arguments

    def more_arguments(self, parameters: dict[str, Any], context: QgsProcessingContext) -> list[str]:
        """Arguments beside those of :meth:`arguments`."""
        return []

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        target = self.parameterAsFileOutput(parameters, self.OUTPUT, context)
        arguments = self.arguments(self.COMMAND, parameters, context, target) + self.more_arguments(parameters, context)
        outputs = self.run_engine(arguments, feedback)
        if outputs is None:
            return {}
        return {self.OUTPUT: target} | {name: outputs[key] for name, key in self.NUMBERS.items() if key in outputs}
