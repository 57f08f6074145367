"""Processing provider ``tetratrack``: all algorithms, always listed, whether or not the engine is there."""

from __future__ import annotations

from qgis.core import QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from ..algorithms.base import ICONS
from ..algorithms.displacementreport import DisplacementReport
from ..algorithms.extractfeaturepoints import ExtractFeaturePoints
from ..algorithms.fittetrapods import FitTetrapods
from ..algorithms.inspecttiles import InspectTiles
from ..algorithms.monitorsurvey import MonitorSurvey
from ..algorithms.planningdetectability import PlanningDetectability
from ..algorithms.registertocontrol import RegisterToControl
from ..algorithms.registerviews import RegisterViews
from ..algorithms.segmenttetrapods import SegmentTetrapods
from ..algorithms.simulatesurvey import SimulateSurvey
from ..algorithms.trackdisplacements import TrackDisplacements
from ..algorithms.validatesurvey import ValidateSurvey
from .translation import tr

ALGORITHMS = (
    MonitorSurvey,
    DisplacementReport,
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
