"""A page to print: the map as it stands, with title, legend, scale bar, north arrow and what was compared."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import (
    Qgis,
    QgsApplication,
    QgsLayoutItem,
    QgsLayoutItemLabel,
    QgsLayoutItemLegend,
    QgsLayoutItemMap,
    QgsLayoutItemPicture,
    QgsLayoutItemScaleBar,
    QgsLayoutPoint,
    QgsLayoutSize,
    QgsLegendStyle,
    QgsPrintLayout,
    QgsProject,
    QgsReadWriteContext,
)
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QLocale
from qgis.PyQt.QtGui import QFont
from qgis.PyQt.QtXml import QDomDocument

from ..algorithms.support.layers import ARROW_LABEL, legend_label
from ..algorithms.support.lengths import round_below
from ..algorithms.support.translation import tr
from .review_store import ReviewStore
from .review_text import datum_label

TEMPLATE = Path(__file__).resolve().parent / "templates" / "displacements_a4.qpt"
"""The page as it ships; a copy of it with a head of one's own can be chosen in QGIS's layout manager."""
PAGE, MARGIN, SIDE = (297.0, 210.0), 8.0, 68.0
"""A4 across, its margin, and the width of the column beside the map, millimetres."""
HEAD, FOOT = 16.0, 24.0
"""Height of the title and of the scale bar's strip, millimetres."""
ROUND_SCALES = tuple(step * 10**power for power in range(1, 5) for step in (1, 2, 2.5, 5))


def build_page(project: QgsProject) -> QgsPrintLayout:
    """The page with all its items and nothing of a result in them."""
    layout = QgsPrintLayout(project)
    layout.initializeDefaults()
    canvas = QgsLayoutItemMap(layout)
    canvas.setId("map")
    canvas.setFrameEnabled(True)
    column = PAGE[0] - MARGIN - SIDE
    _place(layout, canvas, MARGIN, MARGIN + HEAD, column - 2 * MARGIN, PAGE[1] - 2 * MARGIN - HEAD)
    _text(layout, "title", tr("Displacements of armour units"), 16, (MARGIN, MARGIN, PAGE[0] - 2 * MARGIN, HEAD - 6), bold=True)
    _text(layout, "subtitle", "", 9, (MARGIN, MARGIN + 9, PAGE[0] - 2 * MARGIN, 6))
    legend = QgsLayoutItemLegend(layout)
    legend.setId("legend")
    legend.setTitle(tr("Legend"))
    legend.setLinkedMap(canvas)
    legend.setLegendFilterByMapEnabled(True)
    legend.setResizeToContents(True)
    sizes = {"Title": 11, "Group": 9, "Subgroup": 8, "SymbolLabel": 8}
    for name, size in sizes.items():
        style = legend.style(getattr(QgsLegendStyle.Style, name))
        words = style.textFormat()
        words.setSize(size)
        words.setSizeUnit(Qgis.RenderUnit.Points)
        style.setTextFormat(words)
        legend.setStyle(getattr(QgsLegendStyle.Style, name), style)
    _place(layout, legend, column, MARGIN + HEAD, SIDE, 100)
    north = QgsLayoutItemPicture(layout)
    north.setId("north")
    north.setPicturePath(_north_arrow())
    north.setLinkedMap(canvas)
    north.setNorthMode(QgsLayoutItemPicture.NorthMode.GridNorth)
    _place(layout, north, column + SIDE - 16, PAGE[1] - MARGIN - FOOT - 18, 14, 16)
    bar = QgsLayoutItemScaleBar(layout)
    bar.setId("scale_bar")
    bar.setStyle("Single Box")
    bar.setLinkedMap(canvas)
    _place(layout, bar, column, PAGE[1] - MARGIN - FOOT, SIDE, 12)
    _text(layout, "note", "", 7, (column, PAGE[1] - MARGIN - 9, SIDE, 10))
    return layout


def _place(layout: QgsPrintLayout, item: QgsLayoutItem, x: float, y: float, width: float, height: float) -> None:
    layout.addLayoutItem(item)
    item.attemptMove(QgsLayoutPoint(x, y))
    item.attemptResize(QgsLayoutSize(width, height))


def _text(layout: QgsPrintLayout, name: str, text: str, size: int, box: tuple[float, float, float, float], *, bold: bool = False) -> None:
    label = QgsLayoutItemLabel(layout)
    label.setId(name)
    label.setText(text)
    style = label.textFormat()
    font = QFont(style.font())
    font.setBold(bold)
    style.setFont(font)
    style.setSize(size)
    style.setSizeUnit(Qgis.RenderUnit.Points)
    label.setTextFormat(style)
    _place(layout, label, *box)


def _north_arrow() -> str:
    found = [Path(folder) / "arrows" / "NorthArrow_02.svg" for folder in QgsApplication.svgPaths()]
    return str(next((path for path in found if path.is_file()), ""))


def make_page(project: QgsProject, canvas: QgsMapCanvas, store: ReviewStore, title: str = "") -> QgsPrintLayout:
    """The shipped page, filled with the map as it stands and with what the review compares, in the project's layout manager."""
    layout = QgsPrintLayout(project)
    document = QDomDocument()
    document.setContent(TEMPLATE.read_text(encoding="utf-8"))
    layout.loadFromTemplate(document, QgsReadWriteContext())
    manager = project.layoutManager()
    name = layout_name([existing.name() for existing in manager.printLayouts()], store.path.stem)
    layout.setName(name)
    page_map: Any = layout.itemById("map")
    page_map.setCrs(canvas.mapSettings().destinationCrs())
    page_map.zoomToExtent(canvas.extent())
    page_map.setScale(next((scale for scale in ROUND_SCALES if scale >= page_map.scale()), page_map.scale()))
    layout.itemById("title").setText(title or tr("Displacements of armour units") + f": {store.path.stem}")
    compared = tr("{pair}, datum: {datum}").format(pair=store.pair, datum=datum_label(store.datum))
    layout.itemById("subtitle").setText(f"{compared}   1 : {QLocale().toString(round(page_map.scale()))}")
    bar: Any = layout.itemById("scale_bar")
    bar.setLinkedMap(page_map)
    _fit_bar(bar, page_map)
    _fill_legend(layout.itemById("legend"), page_map, project)
    layout.itemById("north").setPicturePath(_north_arrow())
    layout.itemById("north").setLinkedMap(page_map)
    crs = page_map.crs()
    scale = legend_label(ARROW_LABEL)
    layout.itemById("note").setText(f"{scale}\n{crs.authid()} {crs.description()}\ntetratrack, {store.path.name}")
    manager.addLayout(layout)
    return layout


def layout_name(taken: list[str], stem: str) -> str:
    """A name that no other page of the project has."""
    names = (f"{stem}{'' if k == 1 else f' {k}'}" for k in range(1, len(taken) + 2))
    return next(name for name in names if name not in taken)


def _fit_bar(bar: QgsLayoutItemScaleBar, page_map: QgsLayoutItemMap) -> None:
    """Two segments of a round length, together two thirds of the column."""
    metres = SIDE / 1000 * page_map.scale() / 3
    bar.setUnits(Qgis.DistanceUnit.Meters)
    bar.setUnitLabel("m")
    bar.setNumberOfSegments(2)
    bar.setNumberOfSegmentsLeft(0)
    bar.setUnitsPerSegment(round_below(metres))
    bar.update()


def _fill_legend(legend: QgsLayoutItemLegend, page_map: QgsLayoutItemMap, project: QgsProject) -> None:
    """Layers that are shown, tables and reliefs left out."""
    legend.setLinkedMap(page_map)
    legend.setAutoUpdateModel(False)
    root = legend.model().rootGroup()
    root.removeAllChildren()
    for node in project.layerTreeRoot().findLayers():
        layer = node.layer()
        if node.isVisible() and layer is not None and layer.type() == Qgis.LayerType.Vector and layer.isSpatial():
            root.addLayer(layer)
    legend.setLegendFilterByMapEnabled(True)
    legend.adjustBoxSize()
