"""Processing provider ``tetratrack``: all algorithms, always listed, whether or not the engine is there."""

from __future__ import annotations

from qgis.core import QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from .base import ICONS
from .comparedesign import CompareDesign
from .crosssections import CrossSections
from .displacementreport import DisplacementReport
from .exportmodel import ExportModel
from .extractfeaturepoints import ExtractFeaturePoints
from .fittetrapods import FitTetrapods
from .inspecttiles import InspectTiles
from .monitorsurvey import MonitorSurvey
from .newsurvey import NewSurvey
from .planningdetectability import PlanningDetectability
from .registertocontrol import RegisterToControl
from .registerviews import RegisterViews
from .residualpoints import ResidualPoints
from .segmenttetrapods import SegmentTetrapods
from .simulatesurvey import SimulateSurvey
from .support.translation import tr
from .trackdisplacements import TrackDisplacements
from .validatesurvey import ValidateSurvey

ALGORITHMS = (
    MonitorSurvey,
    NewSurvey,
    DisplacementReport,
    ExportModel,
    CompareDesign,
    CrossSections,
    ResidualPoints,
    InspectTiles,
    RegisterViews,
    RegisterToControl,
    SegmentTetrapods,
    FitTetrapods,
    ExtractFeaturePoints,
    TrackDisplacements,
    ValidateSurvey,
    SimulateSurvey,
    PlanningDetectability,
)


class TetratrackProvider(QgsProcessingProvider):
    """Lists the algorithms under the id ``tetratrack``."""

    def id(self) -> str:
        return "tetratrack"

    def name(self) -> str:
        return "Tetratrack"

    def longName(self) -> str:
        return tr("Tetratrack: displacements of tetrapods")

    def icon(self) -> QIcon:
        return QIcon(self.svgIconPath())

    def svgIconPath(self) -> str:
        return str(ICONS / "tetratrack.svg")

    def loadAlgorithms(self) -> None:
        for algorithm in ALGORITHMS:
            self.addAlgorithm(algorithm())
