"""Pictures of the report on the structure: cross-sections, crest, and the map of what was built against what was designed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.lines import Line2D

from ..armour.comparisons import DesignComparison, Profiles
from ..model.facets import plan_outline
from ..model.outline import PlacedShape
from ..results.geopackage_reader import EpochPair
from ..results.unit_rows import Z_95
from .figures import EARLIER, LATER, Translate, drawn_as_uri, empty_figure, map_frame

MOST_SECTIONS = 24
"""Cross-sections drawn; of more, evenly chosen ones."""
SECTIONS_A_FIGURE = 3
DESIGN_COLOUR = "#009E73"
VERDICT_COLOURS = {"within": "#009E73", "open": "#E69F00", "outside": "#C0392B", None: "#B8C4CE"}


def structure_words(_: Translate) -> dict[str, str]:
    """Words of the pages that come from the numbers, translated: states of damage and verdicts."""
    return {
        "no damage": _("no damage"),
        "initiation of damage": _("initiation of damage"),
        "Iribarren's damage": _("Iribarren's damage"),
        "initiation of destruction": _("initiation of destruction"),
        "within": _("within"),
        "outside": _("outside"),
        "open": _("cannot be told"),
    }


def section_figures(found: Profiles, pair: EpochPair, _: Translate) -> list[str]:
    """Cross-sections of the pair's epochs, some on a figure: blocks of both epochs, points of the later one, and the design."""
    numbers = sorted({int(row["section"]) for row in found.sections})
    if len(numbers) > MOST_SECTIONS:
        numbers = [numbers[k] for k in np.unique(np.linspace(0, len(numbers) - 1, MOST_SECTIONS).astype(int))]
    pictures = []
    for start in range(0, len(numbers), SECTIONS_A_FIGURE):
        own = numbers[start : start + SECTIONS_A_FIGURE]
        figure = empty_figure(7.0, 2.3 * len(own))
        for k, number in enumerate(own):
            axes = figure.add_subplot(len(own), 1, k + 1)
            plane = found.planes[number - 1]
            for row in found.sections:
                if row["section"] != number or row.get("epoch") not in (None, pair.epoch_from, pair.epoch_to):
                    continue
                across = (row["geometry"][:, :2] - plane.place) @ plane.left
                colour, style, width = _section_style(row, pair)
                axes.plot(across, row["geometry"][:, 2], style, color=colour, linewidth=width)
            axes.set_aspect("equal", adjustable="datalim")
            east, north = (f"{value:.1f}" for value in plane.place)
            title = _("chainage {along} m, axis at {east} / {north}").format(along=f"{plane.along:.1f}", east=east, north=north)
            axes.set_title(title, fontsize=7)
            axes.tick_params(labelsize=6)
            axes.set_ylabel(_("height (m)"), fontsize=7)
            axes.grid(color="#D5D8DC", linewidth=0.4)
        axes.set_xlabel(_("offset from the axis, left positive (m)"), fontsize=7)
        figure.legend(handles=_section_handles(found, pair, _), fontsize=6, loc="outside lower center", ncols=4, frameon=False)
        pictures.append(drawn_as_uri(figure))
    return pictures


def crest_chart(found: Profiles, pair: EpochPair, _: Translate) -> str:
    """Height of the crest along the structure in both epochs with its 95 % band."""
    figure = empty_figure(7.0, 2.3)
    axes = figure.add_subplot()
    for label, colour, style in ((pair.epoch_from, EARLIER, "s--"), (pair.epoch_to, LATER, "o-")):
        own = [row for row in found.crest if row["epoch"] == label]
        along = np.array([row["along"] for row in own])
        height = np.array([row["crest_height"] for row in own])
        half = Z_95 * np.array([row["sd"] for row in own], dtype=np.float64)
        axes.fill_between(along, height - half, height + half, color=colour, alpha=0.15, linewidth=0)
        axes.plot(along, height, style, color=colour, markersize=3, linewidth=1.1, label=label)
    axes.set_xlabel(_("chainage along the axis (m)"), fontsize=8)
    axes.set_ylabel(_("crest height (m)"), fontsize=8)
    axes.ticklabel_format(useOffset=False, style="plain")
    axes.tick_params(labelsize=7)
    axes.grid(color="#D5D8DC", linewidth=0.4)
    axes.legend(fontsize=7, frameon=False)
    return drawn_as_uri(figure)


def design_map(design: DesignComparison, shapes: Mapping[str, PlacedShape], _: Translate) -> str:
    """Units by what was found of them against the design, with places of the plan that are empty."""
    figure = empty_figure(7.0, 4.2)
    axes = figure.add_subplot()
    rows = design.plan.deviations if design.plan is not None else design.profile
    verdicts = {str(row["unit_id"]): row["verdict"] for row in rows}
    drawn = [(shape, verdicts[name]) for name, shape in shapes.items() if name in verdicts]
    outlines = [plan_outline(shape) for shape, _verdict in drawn]
    axes.add_collection(
        PolyCollection(outlines, facecolors=[VERDICT_COLOURS[v] for _shape, v in drawn], edgecolors="#5D6D7E", linewidths=0.3)
    )
    words = {"within": _("within the tolerance"), "open": _("cannot be told"), "outside": _("outside the tolerance"), None: _("not judged")}
    present = [key for key in VERDICT_COLOURS if any(v == key for _shape, v in drawn)]
    handles = [
        Line2D([], [], marker="s", linestyle="", color=VERDICT_COLOURS[key], markeredgecolor="#5D6D7E", label=words[key]) for key in present
    ]
    unmatched = design.plan.unmatched if design.plan is not None else []
    for kind, marker, label in (("missing", "x", _("planned place without a unit")), ("extra", "+", _("unit without a planned place"))):
        places = np.array([row["geometry"][:2] for row in unmatched if row["kind"] == kind])
        if len(places):
            handles += axes.plot(places[:, 0], places[:, 1], marker, color="#17202A", markersize=5, linestyle="", label=label)
    map_frame(axes, _)
    figure.legend(handles=handles, fontsize=7, loc="outside right upper", frameon=False)
    return drawn_as_uri(figure)


def _section_style(row: Mapping[str, Any], pair: EpochPair) -> tuple[str, str, float]:
    if row["kind"] == "design":
        return DESIGN_COLOUR, "-", 1.4
    late = row["epoch"] == pair.epoch_to
    if row["kind"] == "points":
        return (LATER if late else EARLIER), ":", 0.8
    return (LATER, "-", 0.9) if late else (EARLIER, "--", 0.7)


def _section_handles(found: Profiles, pair: EpochPair, _: Translate) -> list[Line2D]:
    handles = [
        Line2D([], [], color=EARLIER, linestyle="--", label=pair.epoch_from),
        Line2D([], [], color=LATER, linestyle="-", label=pair.epoch_to),
    ]
    kinds = {row["kind"] for row in found.sections}
    if "points" in kinds:
        handles.append(Line2D([], [], color="#7F8C8D", linestyle=":", label=_("surface of the points")))
    if "design" in kinds:
        handles.append(Line2D([], [], color=DESIGN_COLOUR, label=_("design")))
    return handles
