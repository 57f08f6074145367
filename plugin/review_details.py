"""What the review says of a unit and of all units, as HTML: functions of the store."""

from __future__ import annotations

import html
import math

import numpy as np
from qgis.PyQt.QtGui import QPalette

from ..algorithms.support.lengths import LengthFormat, decimal, length_format
from ..algorithms.support.translation import tr
from ..core.model.outline import PlacedShape
from ..core.results.geopackage_reader import EpochPair, Row
from ..core.results.unit_legs import Leg, way_of_leg
from ..core.results.unit_rows import CheckComparison, UnitDetails, UnitRow, check_comparisons
from ..core.review.corrections import read_edits, read_picks
from .review_store import ReviewStore
from .review_text import action_label, datum_label, decision_colour, decision_label, edit_label, kind_label, leg_label

LEAST_P = 0.0001
"""Smallest p-value written as a number."""


def numbers_html(store: ReviewStore, unit: str) -> str:
    """Displacement, quality, check points and hand-picked points of a unit in the store's pair; empty for a unit it has no row of."""
    row, details = store.row(unit), store.details(unit)
    if row is None:
        return ""
    pair = store.pair
    compared = tr("{pair}, datum: {datum}").format(pair=pair, datum=datum_label(store.datum))
    fit = details.rows.get(pair.epoch_to) or details.rows.get(pair.epoch_from) or {}
    return "".join(
        [
            f"<h3>{html.escape(unit)} – {html.escape(kind_label(row.kind))}</h3>",
            f"<p>{html.escape(compared)}<br>{html.escape(tr('± one standard deviation'))}</p>",
            "<table cellspacing='0' cellpadding='3'>",
            *_displacement_lines(row),
            *_quality_lines(fit, str(fit.get("epoch") or "")),
            *(_line(name, ", ".join(map(str, legs))) for name, legs in _notable_legs(row) if legs),
            "</table>",
            *_leg_lines(row, details, pair),
            *_check_lines(check_comparisons(details, pair)),
            *_pick_lines(details, read_picks(store.path, unit)),
        ]
    )


def history_html(store: ReviewStore, unit: str) -> str:
    """Decisions on a unit, the newest first, then its corrections."""
    entries = []
    for event in reversed(store.history(unit)):
        comment = f" – {event.comment}" if event.comment else ""
        if event.action == "decide" and event.basis is not None and event.basis.length is not None:
            comment = f" ({length_format().text(event.basis.length)}){comment}"
        deed = f"{action_label(event.action)} «{decision_label(event.decision)}», {event.pair}{comment}"
        entries.append(_entry(event.at, event.reviewer, deed))
    for edit in read_edits(store.path):
        if edit.unit_id == unit:
            gone = f" ({tr('taken back by {who}').format(who=edit.undone_by or edit.editor)})" if edit.undone else ""
            entries.append(_entry(edit.edited_at, edit.editor, f"{edit_label(edit.kind)} {edit.epoch}{gone}"))
    return f"<ul>{''.join(entries)}</ul>" if entries else f"<p>{html.escape(tr('Nobody has decided on this unit yet.'))}</p>"


def counts_html(store: ReviewStore, palette: QPalette) -> str:
    """Counts of the pair; what is left out because it was rejected stands out in the palette's colour for that."""
    numbers = store.statistics()
    parts = [tr("%n of {all} units shown", len(store.order)).format(all=len(store.rows))]
    parts.append(tr("%n significant", numbers.significant))
    if numbers.lost:
        parts.append(tr("%n lost", numbers.lost))
    if numbers.new:
        parts.append(tr("%n new", numbers.new))
    if numbers.broken:
        parts.append(tr("%n with a broken leg", numbers.broken))
    if numbers.largest is not None:
        parts.append(tr("largest {length}").format(length=length_format().text(numbers.largest)))
    parts.append(tr("%n decided", numbers.decided + numbers.rejected))
    # a number stays on the line of its word
    text = html.escape("  ·  ".join(part.replace(" ", "\u00a0") for part in parts))
    if numbers.rejected:
        rejected = tr("%n rejected, excluded from statistics and map", numbers.rejected)
        text += f" · <b style='color:{decision_colour('rejected', palette).name()}'>{html.escape(rejected)}</b>"
    return text


def _line(name: str, value: str) -> str:
    return f"<tr><td>{html.escape(name)}</td><td><b>{html.escape(value)}</b></td></tr>"


def _displacement_lines(row: UnitRow) -> list[str]:
    if row.vector is None or row.sd is None or row.d_3d is None:
        return [_line(tr("Displacement"), tr("none: one of the two positions is not known"))]
    # models in a tank have standard deviations that metres would round to nothing
    lengths = length_format().telling(float(row.sd.min()))
    height = row.height or math.nan
    lines = [
        _line(tr("3D displacement"), f"{lengths.number(row.d_3d)} ± {lengths.text(row.sd_3d)}"),
        _line(
            tr("in heights H, in nominal diameters Dn"), f"{decimal(row.d_3d / height, 3)} H, {decimal(row.d_over_dn or math.nan, 3)} Dn"
        ),
    ]
    for name, part, sd in zip((tr("Easting"), tr("Northing"), tr("Height")), row.vector, row.sd, strict=True):
        lines.append(_line(name, f"{lengths.signed(part)} ± {lengths.text(sd)}"))
    lines.append(_line(tr("Horizontal"), _with_direction(row, lengths)))
    if row.rotation_deg is not None:
        sd_rotation = f" ± {decimal(row.sd_rotation_deg, 2)}°" if row.sd_rotation_deg is not None else ""
        lines.append(_line(tr("Rotation"), f"{decimal(row.rotation_deg, 2)}°{sd_rotation}"))
    if row.p_value is not None:
        verdict = tr("significant") if row.significant else tr("not significant")
        p = f"p = {decimal(row.p_value, 4)}" if row.p_value >= LEAST_P else f"p < {decimal(LEAST_P, 4)}"
        lines.append(_line(tr("Test against no motion"), f"{p}, {verdict}"))
    lines.append(_line(tr("Detection limit"), lengths.text(row.detection_limit)))
    return lines


def _with_direction(row: UnitRow, lengths: LengthFormat) -> str:
    """Horizontal displacement, and for a significant one whither it goes: of the others noise alone decides that."""
    length = lengths.text(row.d_horizontal)
    if row.vector is None or not row.significant:
        return length
    azimuth = round(math.degrees(math.atan2(row.vector[0], row.vector[1]))) % 360
    return tr("{length}, towards {azimuth}° from grid north").format(length=length, azimuth=azimuth)


def _quality_lines(fit: Row, epoch: str) -> list[str]:
    measures = (
        (tr("Seen in {epoch}").format(epoch=epoch), "coverage", lambda value: f"{100 * value:.0f} %"),
        (tr("Score of the fit, 0 to 1"), "score", lambda value: decimal(value, 2)),
        (tr("Points"), "n_points", str),
        (tr("Legs seen, of four"), "legs_visible", str),
    )
    lines = [_line(name, text(fit[key])) for name, key, text in measures if fit.get(key) is not None]
    return lines


def _notable_legs(row: UnitRow) -> tuple[tuple[str, tuple[int, ...]], ...]:
    return (tr("Broken legs"), row.broken_legs), (tr("Ends not seen, of legs"), row.unseen_legs)


def _leg_lines(row: UnitRow, details: UnitDetails, pair: EpochPair) -> list[str]:
    """Table of the legs, the broken ones bold."""
    if not row.legs:
        return []
    shape = details.shapes.get(pair.epoch_to) or details.shapes.get(pair.epoch_from)
    lengths = length_format()
    head = (tr("Leg"), tr("Its end"), tr("Missing ({unit})").format(unit=lengths.suffix), tr("Probability of a break"), tr("Points to"))
    lines = [
        f"<h4>{html.escape(tr('Legs'))}</h4>",
        "<table cellspacing='0' cellpadding='3'><tr>",
        *(f"<th align='left'>{html.escape(text)}</th>" for text in head),
    ]
    for leg in row.legs:
        missing = "–" if leg.missing is None else lengths.number(leg.missing)
        cells = (str(leg.number), leg_label(leg.state), missing, _share(leg.probability), "–" if shape is None else _way(leg, shape))
        texts = (f"<b>{html.escape(cell)}</b>" if leg.is_broken else html.escape(cell) for cell in cells)
        lines.append("</tr><tr>" + "".join(f"<td>{text}</td>" for text in texts))
    return [*lines, "</tr></table>", f"<p>{html.escape(tr('Points to: degrees from grid north, and above the horizon'))}</p>"]


def _share(probability: float | None) -> str:
    """A probability in percent, which is never certain."""
    if probability is None:
        return "–"
    percent = round(100 * probability)
    return "< 1 %" if percent < 1 else "> 99 %" if percent > 99 else f"{percent} %"


def _way(leg: Leg, shape: PlacedShape) -> str:
    azimuth, rise = way_of_leg(leg, shape)
    return f"{azimuth}°, {rise:+d}°"


def _check_lines(checks: list[CheckComparison]) -> list[str]:
    if not checks:
        return []
    lengths = length_format()
    title = html.escape(tr("Check points ({unit})").format(unit=lengths.suffix))
    head = (tr("Check point"), tr("Feature"), tr("Surveyed"), tr("Fitted"), tr("Difference"))
    lines = [f"<h4>{title}</h4><table cellspacing='0' cellpadding='3'><tr>"]
    lines += [f"<th align='left'>{html.escape(text)}</th>" for text in head]
    for check in checks:
        values = (lengths.number(value) for value in (check.measured, check.fitted, check.difference))
        lines.append("</tr><tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in (check.point_id, check.feature, *values)))
    return [*lines, "</tr></table>"]


def _pick_lines(details: UnitDetails, picks: list[Row]) -> list[str]:
    lengths, lines = length_format(), []
    for pick in picks:
        feature = details.features.get(pick["epoch"], {}).get(pick["feature"])
        if feature is not None:
            apart = float(np.linalg.norm(pick["geom"] - feature[0]))
            words = {"feature": pick["feature"], "epoch": pick["epoch"], "who": pick["picked_by"], "length": lengths.text(apart)}
            lines.append(f"<li>{html.escape(tr('{feature}, {epoch}: picked {length} from the fit ({who})').format(**words))}</li>")
    return [f"<h4>{html.escape(tr('Picked by hand'))}</h4><ul>", *lines, "</ul>"] if lines else []


def _entry(moment: str, who: str, deed: str) -> str:
    text = f"{moment[:19].replace('T', ' ')} UTC, {who}: {deed}"
    return f"<li>{html.escape(text)}</li>"
