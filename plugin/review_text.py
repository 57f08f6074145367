"""Words and numbers of the review as the user reads them: translated labels, lengths in the project's unit and decimals."""

from __future__ import annotations

from qgis.PyQt.QtGui import QColor, QPalette

from ..algorithms.support.lengths import length_format
from ..algorithms.support.translation import tr

DECISION_COLOURS = {"accepted": ("#006B5E", "#7FE0C8"), "rejected": ("#8E1B1B", "#F4776A"), "inspect": ("#946200", "#FFD54A")}
"""Colour of each decision on light and on dark paper."""
LENGTH_COLUMNS = ("d_3d", "d_horizontal", "vertical")
"""Columns of the table whose numbers are lengths."""


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


def leg_label(state: str) -> str:
    """What is known of the end of a leg."""
    return {"whole": tr("whole"), "broken": tr("broken"), "unseen": tr("not seen")}.get(state, state)


def decision_label(decision: str) -> str:
    """Name of a decision."""
    return {"accepted": tr("accepted"), "rejected": tr("rejected"), "inspect": tr("inspect")}.get(decision, decision)


def datum_label(datum: str) -> str:
    """Name of a datum."""
    return {"stable": tr("stable units and control"), "control": tr("control points alone")}.get(datum, datum)


def action_label(action: str) -> str:
    """Name of an act in the history."""
    return {
        "decide": tr("decided"),
        "confirm": tr("confirmed"),
        "undo": tr("took back"),
        "lapse": tr("changed the numbers, which ended"),
        "restore": tr("brought back the numbers of"),
    }.get(action, action)


def edit_label(kind: str) -> str:
    """Name of a correction."""
    labels = {
        "delete": tr("deleted"),
        "merge": tr("merged"),
        "split": tr("split"),
        "pose": tr("new pose"),
        "pick": tr("points picked"),
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
        "broken_legs": tr("Broken"),
        "decision": tr("Decision"),
        "reviewer": tr("Reviewer"),
    }[column]


def heading(column: str, length: str) -> str:
    """Heading of a table column with its unit, the project's unit of lengths where its numbers are lengths."""
    return f"{column_label(column)} ({length})" if column in LENGTH_COLUMNS else column_label(column)


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
        "broken_legs": tr("Numbers of the legs that are broken; the page Numbers says how sure that is, and which ends are not seen"),
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
