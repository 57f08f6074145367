"""Figures of the report as data URIs: maps, histogram, views and series. Drawn without pyplot, so without global state."""

from __future__ import annotations

import base64
import io
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text
from matplotlib.ticker import MaxNLocator

from ..common.arrays import FloatArray
from ..model.outline import PlacedShape, end_discs, section, silhouette
from ..results.class_colours import CLASS_COLOURS, UNKNOWN_COLOUR
from ..results.geopackage_reader import Row
from ..results.unit_rows import Z_95, SeriesPoint, UnitRow
from .displacement_arrows import Arrows, displacement_arrows, nearest_round
from .fonts import drawable, families_for

Translate = Callable[[str], str]

EARLIER, LATER = "#0072B2", "#D55E00"
FEATURE_COLOURS = {"centre": "#000000", "f123": EARLIER, "f124": LATER, "f134": "#009E73", "f234": "#882255"}
SLAB = 0.12
RESOLUTION = 150
LAYOUTS, STEADY = 3, 1e-5
"""Passes of the layout at most, and the share of a figure, a hundredth of a pixel, by which a pass moves axes that need no further one."""


def empty_figure(width: float, height: float) -> Figure:
    """Empty figure, width and height in inches."""
    figure = Figure(figsize=(width, height), dpi=RESOLUTION, layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def drawn_as_uri(figure: Figure) -> str:
    """A figure as a data URI of a PNG, with letters that this machine can draw."""
    texts = [artist for artist in figure.findobj(Text) if isinstance(artist, Text)]
    for text in texts:
        text.set_text(drawable(text.get_text()))
    families = families_for(text.get_text() for text in texts)
    for text in texts:
        text.set_fontfamily(families)
        # names may hold dollar signs, which are no formulas
        text.set_parse_math(False)
    _lay_out(figure)
    # or saving would lay out anew and draw twice
    figure.set_layout_engine("none")
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", metadata={"Software": None})
    return f"data:image/png;base64,{base64.b64encode(buffer.getvalue()).decode('ascii')}"


def _lay_out(figure: Figure) -> None:
    """Lay a figure out as often as its axes move."""
    layout = figure.get_layout_engine()
    if layout is None:
        return
    # a pass lays out with the ticks of before it, and cuts the name of an axis whose numbers change; a second one may change them again
    for _pass in range(LAYOUTS):
        before = _places_of_axes(figure)
        layout.execute(figure)
        if np.abs(_places_of_axes(figure) - before).max(initial=0.0) < STEADY:
            break


def _places_of_axes(figure: Figure) -> FloatArray:
    """(n, 4) left, lower, right and upper edges of all axes as laid out, as shares of the figure."""
    return np.array([axes.get_position(original=True).extents for axes in figure.axes])


def overview_map(
    rows: Sequence[UnitRow], shapes: dict[str, PlacedShape], control: Sequence[Row], rejected: frozenset[str], _: Translate
) -> str:
    """Units by class with control points, survey coordinates."""
    figure = empty_figure(7.0, 4.2)
    axes = figure.add_subplot()
    kept = [row for row in rows if row.place is not None and row.unit_id not in rejected]
    outlines = _outlines(kept, shapes)
    colours = [CLASS_COLOURS.get(row.kind, UNKNOWN_COLOUR) for row in kept]
    axes.add_collection(PolyCollection(outlines, facecolors=colours, edgecolors="#5D6D7E", linewidths=0.3))
    gone = np.array([row.place[:2] for row in rows if row.place is not None and row.unit_id in rejected]).reshape(-1, 2)
    axes.plot(gone[:, 0], gone[:, 1], "x", color="#7F8C8D", markersize=4, label=_("rejected"))
    for used, marker, colour in ((True, "^", "#1B4F72"), (False, "v", "#C0392B")):
        points = np.array([row["geom"][:2] for row in control if row["geom"] is not None and bool(row["used"]) is used]).reshape(-1, 2)
        if len(points):
            axes.plot(
                points[:, 0], points[:, 1], marker, color=colour, markersize=6, label=_("control used") if used else _("control not used")
            )
    present = [kind for kind in CLASS_COLOURS if any(row.kind == kind for row in kept)]
    handles = [
        Line2D([], [], marker="s", linestyle="", color=CLASS_COLOURS[kind], markeredgecolor="#5D6D7E", label=_(kind)) for kind in present
    ]
    drawn: list[Any] = list(axes.get_legend_handles_labels()[0])
    named = [handle for handle in drawn if len(handle.get_xdata())]
    map_frame(axes, _)
    axes.legend(handles=[*handles, *named], fontsize=7, loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0, frameon=False)
    return drawn_as_uri(figure)


def displacement_map(rows: Sequence[UnitRow], shapes: dict[str, PlacedShape], rejected: frozenset[str], _: Translate) -> str:
    """Units coloured by the length of their displacement, with arrows for the significant ones (enlarged, scale stated)."""
    figure = empty_figure(7.0, 4.2)
    axes = figure.add_subplot()
    kept = [row for row in rows if row.place is not None and row.vector is not None and row.unit_id not in rejected]
    lengths = np.array([100 * (row.d_3d or 0.0) for row in kept])
    top = max(float(np.quantile(lengths, 0.98)), 1.0) if len(lengths) else 1.0
    patches = PolyCollection(_outlines(kept, shapes), array=lengths, cmap="YlOrRd", clim=(0, top), edgecolors="#5D6D7E", linewidths=0.3)
    axes.add_collection(patches)
    arrows = displacement_arrows(kept)
    if len(arrows.starts):
        _draw_arrows(axes, arrows)
        title = _("arrows: significant horizontal displacements, enlarged {scale} times").format(scale=f"{arrows.times:g}")
        axes.set_title("\n".join([title, *([_("dashed: cut short")] if arrows.cut.any() else [])]), fontsize=8)
    map_frame(axes, _)
    bar = figure.colorbar(patches, ax=axes, shrink=0.8, extend="max")
    bar.set_label(_("3D displacement (cm)"), fontsize=8)
    bar.ax.tick_params(labelsize=7)
    return drawn_as_uri(figure)


def _draw_arrows(axes: Any, arrows: Arrows) -> None:
    ink = "#17202A"
    for cut, look in (
        (False, {"color": ink}),
        (True, {"facecolor": "none", "edgecolor": ink, "linewidth": 0.6, "linestyle": (0, (3, 1.5))}),
    ):
        kept = arrows.cut == cut
        places, vectors = arrows.starts[kept], arrows.shown[kept]
        axes.quiver(*places.T, *vectors.T, angles="xy", scale_units="xy", scale=1, width=0.003, **look)
    # arrows count for the extent of the map, or the longest would be cut
    axes.update_datalim(arrows.starts + arrows.shown)


def histogram(rows: Sequence[UnitRow], limits: Sequence[tuple[str, float]], _: Translate) -> str:
    """Displacements of the units that are judged on a logarithmic axis, with thresholds."""
    figure = empty_figure(7.0, 2.7)
    axes = figure.add_subplot()
    lengths = np.array([100 * row.d_3d for row in rows if row.d_3d is not None])
    significant = np.array([100 * row.d_3d for row in rows if row.d_3d is not None and row.significant])
    low, high = max(lengths.min(), 1e-2), max(lengths.max() * 1.2, 1.0)
    edges: list[float] = np.geomspace(low * 0.9, high, 40).tolist()
    axes.hist(np.maximum(lengths, low), edges, color=CLASS_COLOURS["stable"], label=_("all units"))
    axes.hist(np.maximum(significant, low), edges, color="#E69F00", label=_("significant"))
    axes.set_xscale("log")
    for name, limit in limits:
        if 100 * limit < high:
            axes.axvline(100 * limit, color="#C0392B", linewidth=0.8, linestyle="--")
            axes.annotate(
                name,
                (100 * limit, 1),
                xycoords=("data", "axes fraction"),
                xytext=(2, -8),
                textcoords="offset points",
                fontsize=7,
                rotation=90,
                va="top",
            )
    axes.set_xlabel(_("3D displacement (cm)"), fontsize=8)
    axes.set_ylabel(_("units"), fontsize=8)
    axes.tick_params(labelsize=7)
    axes.xaxis.set_major_formatter(lambda value, position: f"{value:g}")
    axes.legend(fontsize=7, frameon=False, loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)
    return drawn_as_uri(figure)


def unit_views(
    shapes: tuple[PlacedShape | None, PlacedShape | None],
    points: tuple[FloatArray, FloatArray],
    labels: tuple[str, str],
    datum: str,
    _: Translate,
) -> str:
    """Plan and vertical section of a unit in two epochs, metres from the middle between the poses; both in the datum named."""
    figure = empty_figure(4.4, 2.3)
    known = [shape for shape in shapes if shape is not None]
    middle = np.mean([shape.centre for shape in known], axis=0)
    half = 1.15 * known[0].leg_length + max(float(np.linalg.norm(shape.centre - middle)) for shape in known)
    azimuth = np.pi / 2
    if shapes[0] is not None and shapes[1] is not None:
        de, dn, _dh = shapes[1].centre - shapes[0].centre
        azimuth = float(np.arctan2(de, dn))
    planes = (
        (_("plan"), np.array([1.0, 0, 0]), np.array([0, 1.0, 0])),
        (
            _("section {azimuth}°").format(azimuth=f"{np.degrees(azimuth) % 360:.0f}"),
            np.array([np.sin(azimuth), np.cos(azimuth), 0]),
            np.array([0, 0, 1.0]),
        ),
    )
    for k, (title, right, up) in enumerate(planes):
        axes = figure.add_subplot(1, 2, k + 1)
        for shape, cloud, colour, style in zip(shapes, points, (EARLIER, LATER), ("--", "-"), strict=True):
            near = cloud if k == 0 else cloud[np.abs((cloud - middle) @ np.cross(right, up)) <= SLAB * known[0].leg_length]
            flat = (near[:: max(1, len(near) // 4000)] - middle) @ np.vstack([right, up]).T
            axes.plot(flat[:, 0], flat[:, 1], ".", color=colour, markersize=0.8, alpha=0.4, rasterized=True)
            if shape is None:
                continue
            place = np.vstack([right, up]) @ (shape.centre - middle)
            curves = [silhouette(shape, right, up), *end_discs(shape, right, up)] if k == 0 else [section(shape, right, up)]
            for curve in curves:
                axes.plot(*(curve + place).T, style, color=colour, linewidth=1.0 if curve is curves[0] else 0.5)
        axes.set(xlim=(-half, half), ylim=(-half, half), aspect="equal")
        axes.set_title(f"{title} (m)", fontsize=7)
        axes.tick_params(labelsize=6)
    handles = [
        Line2D([], [], color=EARLIER, linestyle="--", label=labels[0]),
        Line2D([], [], color=LATER, linestyle="-", label=labels[1]),
    ]
    figure.legend(handles=handles, fontsize=6, loc="outside lower center", ncols=2, frameon=False, title=datum, title_fontsize=6)
    return drawn_as_uri(figure)


def unit_series(series: dict[str, list[SeriesPoint]], limit: float | None, _: Translate) -> str:
    """Displacement of every feature since the first epoch with its 95 % band."""
    figure = empty_figure(2.9, 2.2)
    axes = figure.add_subplot()
    for name, points in series.items():
        times: list[Any] = [point.time or k for k, point in enumerate(points)]
        lengths = np.array([100 * point.d_3d for point in points])
        half = np.array([100 * Z_95 * point.sd for point in points])
        colour = FEATURE_COLOURS[name]
        axes.fill_between(times, np.maximum(lengths - half, 0), lengths + half, color=colour, alpha=0.12, linewidth=0)
        axes.plot(times, lengths, ".-", color=colour, linewidth=1.6 if name == "centre" else 0.8, label=_(name))
    if limit is not None:
        axes.axhline(100 * limit, color="#C0392B", linewidth=0.8, linestyle="--", label=_("detection limit"))
    first = next(iter(series.values()))
    ticks: Any = [point.time or k for k, point in enumerate(first)]
    axes.set_xticks(ticks, [drawable(point.epoch) for point in first], fontsize=6, rotation=20, ha="right")
    axes.set_ylim(bottom=0)
    axes.set_ylabel(_("3D displacement (cm)"), fontsize=6)
    axes.tick_params(axis="y", labelsize=6)
    axes.legend(fontsize=5, frameon=False)
    return drawn_as_uri(figure)


def frame_charts(bends: Sequence[Row], stretches: Sequence[Row], _: Translate) -> dict[str, str]:
    """Charts of the page on frames by name, those that there is something to draw for."""
    drawn = {}
    if any(row["known_by"] == "targets" for row in bends):
        drawn["bends"] = bend_chart(bends, _)
    if len(stretches) > 1:
        drawn["settlement"] = settlement_chart(stretches, _)
    return drawn


def bend_chart(bends: Sequence[Row], _: Translate) -> str:
    """Error of every epoch's cloud along the structure, as its targets see it, by component."""
    figure = empty_figure(7.0, 2.6)
    axes = figure.add_subplot()
    styles = (("de", "sd_e", _("East"), "#0072B2"), ("dn", "sd_n", _("North"), "#D55E00"), ("dh", "sd_h", _("Height"), "#009E73"))
    labels = sorted({row["epoch"] for row in bends if row["known_by"] == "targets"})
    for label, line in zip(labels, ("-", "--", ":"), strict=False):
        own = sorted((row for row in bends if row["epoch"] == label and row["known_by"] == "targets"), key=lambda row: float(row["along"]))
        along = [row["along"] for row in own]
        for value, sd, name, colour in styles:
            middle = np.array([1000 * row[value] for row in own])
            half = np.array([1000 * Z_95 * row[sd] for row in own])
            axes.fill_between(along, middle - half, middle + half, color=colour, alpha=0.10, linewidth=0)
            axes.plot(along, middle, line, color=colour, linewidth=1.2, label=f"{name}, {label}")
    axes.axhline(0, color="#7F8C8D", linewidth=0.6)
    axes.set_xlabel(_("chainage along the axis (m)"), fontsize=8)
    axes.set_ylabel("mm", fontsize=8)
    axes.tick_params(labelsize=7)
    axes.legend(fontsize=6, frameon=False, ncols=max(len(labels), 1))
    return drawn_as_uri(figure)


def settlement_chart(stretches: Sequence[Row], _: Translate) -> str:
    """Height change and horizontal motion of stretches with their bands."""
    figure = empty_figure(7.0, 2.6)
    axes = figure.add_subplot()
    middle = np.array([0.5 * (row["along_from"] + row["along_to"]) for row in stretches])
    height = np.array([1000 * row["dh"] for row in stretches])
    half = np.array([1000 * Z_95 * row["sd_h"] for row in stretches])
    level = np.array([1000 * np.hypot(row["de"], row["dn"]) for row in stretches])
    level_half = np.array([1000 * Z_95 * max(row["sd_e"], row["sd_n"]) for row in stretches])
    axes.fill_between(middle, height - half, height + half, color="#009E73", alpha=0.15, linewidth=0)
    axes.plot(middle, height, "o-", color="#009E73", markersize=3, linewidth=1.2, label=_("Height change"))
    axes.errorbar(
        middle, level, yerr=level_half, fmt="s--", color="#0072B2", markersize=3, linewidth=0.9, capsize=2, label=_("Horizontal motion")
    )
    axes.axhline(0, color="#7F8C8D", linewidth=0.6)
    axes.set_xlabel(_("chainage along the axis (m)"), fontsize=8)
    axes.set_ylabel("mm", fontsize=8)
    axes.tick_params(labelsize=7)
    axes.legend(fontsize=7, frameon=False)
    return drawn_as_uri(figure)


def section_chart(starts: Sequence[float], shares: Sequence[float], length: float, _: Translate) -> str:
    """Share of units displaced by 10 cm or more per section along the axis."""
    figure = empty_figure(7.0, 2.0)
    axes = figure.add_subplot()
    axes.bar(starts, 100 * np.asarray(shares), width=length * 0.96, align="edge", color="#E69F00")
    axes.set_xlabel(_("chainage along the axis (m)"), fontsize=8)
    axes.set_ylabel(_("units ≥ 10 cm (%)"), fontsize=8)
    axes.tick_params(labelsize=7)
    return drawn_as_uri(figure)


def _outlines(rows: Sequence[UnitRow], shapes: dict[str, PlacedShape]) -> list[FloatArray]:
    """Plan outlines of units; a diamond of the unit's size where there is no pose. Coarse where there are many."""
    steps = 60 if len(rows) < 1000 else 18
    outlines = []
    for row in rows:
        shape = shapes.get(row.unit_id)
        if shape is not None:
            outlines.append(silhouette(shape, [1, 0, 0], [0, 1, 0], steps) + shape.centre[:2])
        elif row.place is not None:
            outlines.append(row.place[:2] + 0.4 * (row.height or 1.0) * np.array([[1, 0], [0, 1], [-1, 0], [0, -1]]))
    return outlines


def map_frame(axes: Any, _: Translate) -> None:
    """Give a map its coordinates, grid, north arrow and scale bar."""
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.ticklabel_format(useOffset=False, style="plain")
    axes.tick_params(labelsize=7)
    axes.set_xlabel(_("easting (m)"), fontsize=8)
    axes.set_ylabel(_("northing (m)"), fontsize=8)
    axes.grid(color="#D5D8DC", linewidth=0.4)
    axes.set_axisbelow(True)
    # seven digits along a short side run into each other
    axes.yaxis.set_major_locator(MaxNLocator(4))
    axes.xaxis.set_major_locator(MaxNLocator(6))
    for label in axes.get_yticklabels():
        label.set_rotation(90)
        label.set_va("center")
    _north_and_scale(axes)


def _north_and_scale(axes: Any) -> None:
    """North arrow and scale bar in the corners of a map that the units leave free more often than not."""
    axes.annotate(
        "N",
        (0.975, 0.97),
        (0.975, 0.86),
        xycoords="axes fraction",
        ha="center",
        va="center",
        fontsize=8,
        fontweight="bold",
        arrowprops={"arrowstyle": "-|>", "color": "#17202A", "linewidth": 1.2},
    )
    low, high = axes.get_xlim()
    bottom, top = axes.get_ylim()
    length = nearest_round(0.2 * (high - low))
    right, level = high - 0.03 * (high - low), bottom + 0.05 * (top - bottom)
    axes.plot([right - length, right], [level, level], color="#17202A", linewidth=2, solid_capstyle="butt", scalex=False, scaley=False)
    axes.annotate(
        f"{length:g} m", (right - length / 2, level), (0, 3), textcoords="offset points", ha="center", fontsize=7, color="#17202A"
    )
