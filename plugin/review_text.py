"""Words and numbers of the review as the user reads them: translated labels, lengths in the project's unit and decimals."""

from __future__ import annotations

from dataclasses import dataclass

from qgis.core import Qgis, QgsProject, QgsSettings, QgsUnitTypes
from qgis.PyQt.QtGui import QColor, QPalette

from .translation import tr

DECISION_COLOURS = {"accepted": ("#1E7B4B", "#6FCF97"), "rejected": ("#B03A2E", "#FF8A7A"), "inspect": ("#B9770E", "#F2B134")}
"""Colour of each decision on light and on dark paper."""


def kind_label(kind: str) -> str:
    """Name of a displacement class."""
    labels = {
        "stable": tr("stable"),
        "moved": tr("moved"),
        "rotated": tr("rotated"),
        "lost": tr("lost"),
        "new": tr("new"),
        "relocated": tr("relocated"),
        "uncertain": tr("uncertain"),
        "unseen": tr("unseen"),
    }
    return labels.get(kind, kind)


def decision_label(decision: str) -> str:
    """Name of a decision."""
    return {"accepted": tr("accepted"), "rejected": tr("rejected"), "inspect": tr("inspect")}.get(decision, decision)


def datum_label(datum: str) -> str:
    """Name of a datum."""
    return {"stable": tr("stable units and control"), "control": tr("control points alone")}.get(datum, datum)


def action_label(action: str) -> str:
    """Name of an act in the history."""
    return {"decide": tr("decided"), "confirm": tr("confirmed"), "undo": tr("took back")}.get(action, action)


def edit_label(kind: str) -> str:
    """Name of a correction."""
    labels = {
        "delete": tr("deleted"),
        "merge": tr("merged"),
        "split": tr("split"),
        "pose": tr("new pose"),
        "placeholder": tr("placeholder"),
    }
    return labels.get(kind, kind)


def column_label(column: str) -> str:
    """Heading of a table column."""
    return {
        "unit_id": tr("Unit"),
        "kind": tr("Class"),
        "d_3d": tr("Displ."),
        "d_horizontal": tr("Horiz."),
        "vertical": tr("Vert."),
        "rotation_deg": tr("Rot."),
        "p_value": tr("p"),
        "coverage": tr("Seen"),
        "decision": tr("Decision"),
        "reviewer": tr("Reviewer"),
    }[column]


def column_help(column: str) -> str:
    """What a table column shows, with its unit."""
    length = length_format().suffix
    return {
        "unit_id": tr("Name of the unit, the same in all epochs"),
        "kind": tr("Class of the displacement, or the unit's fate"),
        "d_3d": tr("3D displacement of the centre ({unit})").format(unit=length),
        "d_horizontal": tr("Horizontal displacement of the centre ({unit})").format(unit=length),
        "vertical": tr("Vertical displacement of the centre, positive up ({unit})").format(unit=length),
        "rotation_deg": tr("Rotation between the epochs (degrees)"),
        "p_value": tr("Probability of so large a displacement if the unit stood still; bold where significant"),
        "coverage": tr("Share of the unit's surface that holds points, in the worse epoch"),
        "decision": tr("Decision of the reviewers"),
        "reviewer": tr("Who decided, and ✓ who confirmed"),
    }[column]


def paper(palette: QPalette) -> QColor:
    """Colour behind a drawing; themes made of style sheets leave palette colours transparent, then the text tells light from dark."""
    for role in (QPalette.ColorRole.Base, QPalette.ColorRole.Window):
        colour = palette.color(role)
        if colour.alpha() == 255:
            return colour
    return QColor("#2B2B2B" if palette.color(QPalette.ColorRole.Text).lightness() > 128 else "#FFFFFF")


def is_dark(palette: QPalette) -> bool:
    """Whether a palette is that of a dark theme."""
    return paper(palette).lightness() < 128


def decision_colour(decision: str, palette: QPalette) -> QColor:
    """Colour of a decision, readable on the palette's paper."""
    light, dark = DECISION_COLOURS.get(decision, ("#5D6D7E", "#ABB2B9"))
    return QColor(dark if is_dark(palette) else light)


@dataclass(frozen=True)
class LengthFormat:
    """How lengths are written: factor from metres, unit and decimals."""

    factor: float
    suffix: str
    decimals: int

    def number(self, metres: float) -> str:
        """The bare number."""
        # adding zero turns the negative zero of small values into zero
        return f"{round(metres * self.factor, self.decimals) + 0.0:.{self.decimals}f}"

    def text(self, metres: float) -> str:
        """Number and unit."""
        return f"{self.number(metres)} {self.suffix}"


def length_format() -> LengthFormat:
    """Lengths as the project's distance unit and QGIS's measurement decimals ask; metres where that unit is none for a displacement."""
    unit = QgsProject.instance().distanceUnits()
    near = (
        Qgis.DistanceUnit.Meters,
        Qgis.DistanceUnit.Centimeters,
        Qgis.DistanceUnit.Millimeters,
        Qgis.DistanceUnit.Feet,
        Qgis.DistanceUnit.Inches,
    )
    if unit not in near:
        unit = Qgis.DistanceUnit.Meters
    factor = QgsUnitTypes.fromUnitToUnitFactor(Qgis.DistanceUnit.Meters, unit)
    decimals = QgsSettings().value("qgis/measure/decimalplaces", 3, type=int)
    return LengthFormat(factor, QgsUnitTypes.toAbbreviatedString(unit), max(0, min(int(decimals), 6)))
