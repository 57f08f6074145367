"""The map side of a review: layers of the pair, selection in step, zoom and flash, the unit under a click."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from pathlib import Path
from uuid import uuid4

import numpy as np
from qgis.core import (
    Qgis,
    QgsCoordinateTransform,
    QgsCsException,
    QgsExpression,
    QgsFeatureRequest,
    QgsGeometry,
    QgsMarkerSymbol,
    QgsPointXY,
    QgsProject,
    QgsRectangle,
    QgsSingleSymbolRenderer,
    QgsVectorLayer,
    QgsVectorLayerSimpleLabeling,
)
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QObject, QTimer, pyqtSignal
from qgis.PyQt.QtGui import QColor

from ..algorithms.support.layers import apply_style
from ..algorithms.support.lengths import write_project_lengths
from ..algorithms.support.translation import tr
from ..core.common.arrays import FloatArray
from ..core.results.geopackage_reader import table_names
from .review_panels import draw
from .review_store import ReviewStore
from .review_text import datum_label

ZOOM_HEIGHTS = 8.0
"""Width of the map after zooming to a unit, in heights of the unit."""


REACH_PIXELS = 8
"""How far from an arrow or a centre a click may be."""
PAPER_PER_METRE, LONGEST_ON_PAPER = 0.2, 0.03
"""Length of an arrow on paper for a metre of displacement, and the longest, metres: as the shipped styles draw it."""
LATEST = '(@map_start_time is not null or "epoch_until" is null)'
"""Condition of the shipped styles that leaves earlier epochs out."""
TWINS = ("units", "unit_outlines", "displacements", "displacements_other", "gaps", "unit_edits", "manual_picks")
"""Layers of a result that a review shows in its own way."""
GROUP_PROPERTY = "tetratrack/review"
"""Custom property by which the groups of a review are known again, in saved projects as well."""


def remove_groups(project: QgsProject, token: str = "") -> None:  # nosec B107 - a mark of a group, no secret
    """Remove the group of one review from a project, with its layers; without a token those of all reviews."""
    # looked up each time: the user may have moved or removed it, and a group kept from before would be gone in C++ alone
    for group in project.layerTreeRoot().findGroups(True):
        found = group.customProperty(GROUP_PROPERTY)
        if found is None or (token and found != token):
            continue
        project.removeMapLayers([node.layerId() for node in group.findLayers()])
        group.parent().removeChildNode(group)


def show_every_epoch(layer: QgsVectorLayer) -> None:
    """Draw whatever rows a layer has: which epochs these are is the review's choice, not the latest one or the time of the map."""
    renderer = layer.renderer()
    if renderer.type() == "RuleRenderer":
        for rule in renderer.rootRule().descendants():
            rule.setFilterExpression(rule.filterExpression().replace(f" and {LATEST}", ""))
    if layer.labeling() is not None:
        settings = layer.labeling().settings()
        settings.fieldName = settings.fieldName.replace(LATEST, "true")
        layer.setLabeling(QgsVectorLayerSimpleLabeling(settings))
    layer.temporalProperties().setIsActive(False)


def quoted(values: Iterable[str]) -> str:
    """A list of values for a layer's filter expression."""
    return ", ".join(QgsExpression.quotedString(value) for value in values)


class ReviewMap(QObject):
    """Layers of one store on one canvas, selecting what the store selects and the other way round.

    ``vanished`` tells that the user took layers out of the project, or the project away; nothing works on them from then on.
    """

    vanished = pyqtSignal()

    def __init__(self, store: ReviewStore, canvas: QgsMapCanvas, project: QgsProject, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.store, self.canvas, self.project = store, canvas, project
        self._token, self._left = uuid4().hex, False
        self._hidden: list[str] = []
        self.filtered = False
        self._following = False
        self._shown: tuple[object, ...] | None = None
        self._fids: dict[str, list[int]] = {}
        self._units: dict[int, str] = {}
        self.units = self._open_first("units", tr("Units reviewed"))
        self.outlines = self._open_first("unit_outlines", tr("Outlines of the units"))
        self.displacements = self._open_first("displacements", tr("Displacements reviewed"))
        self.other = self._open_first("displacements_other", tr("Displacements reviewed, other pair or datum"))
        self.rejected = self._open_first("units", tr("Rejected units (excluded)"))
        self.gaps = self._open_first("gaps", tr("Gaps"))
        own = (self.rejected, self.displacements, self.other, self.gaps, self.units, self.outlines)
        self.layers = [layer for layer in own if layer.isValid()]
        # tables of corrections come into the file with the first one
        self.added: dict[str, QgsVectorLayer] = {}
        self._open_added()
        self._style()
        self._add()
        self.units.selectionChanged.connect(self._tell_store)
        self.project.aboutToBeCleared.connect(self._project_leaves)
        self.project.layersWillBeRemoved.connect(self._layers_leave)

    def remove(self) -> None:
        """Take the layers out of the project again."""
        self.project.aboutToBeCleared.disconnect(self._project_leaves)
        self.project.layersWillBeRemoved.disconnect(self._layers_leave)
        if self._left:
            return
        remove_groups(self.project, self._token)
        self._show_again()

    def _hide_twins(self) -> None:
        """Hide layers of the same result that were in the map before: they show other pairs and datums than the review does."""
        own = {layer.id() for layer in self.layers}
        for node in self.project.layerTreeRoot().findLayers():
            layer = node.layer()
            if layer is None or layer.id() in own or not node.itemVisibilityChecked():
                continue
            path, _, name = layer.source().partition("|layername=")
            if name.partition("|")[0] in TWINS and Path(path) == self.store.path:
                node.setItemVisibilityChecked(False)
                self._hidden.append(layer.id())

    def _show_again(self) -> None:
        root = self.project.layerTreeRoot()
        for node in filter(None, (root.findLayer(layer_id) for layer_id in self._hidden)):
            node.setItemVisibilityChecked(True)

    def _project_leaves(self) -> None:
        # the project is about to delete everything itself
        self._left = True
        self.vanished.emit()

    def _layers_leave(self, ids: list[str]) -> None:
        if not {layer.id() for layer in self.layers}.isdisjoint(ids):
            # the project is in the middle of removing some; the others go afterwards
            self._left = True
            QTimer.singleShot(0, partial(remove_groups, self.project, self._token))
            self.vanished.emit()

    def show_pair(self) -> None:
        """Show the store's epoch pair and datum, rejected units apart."""
        pair, rejected = self.store.pair, sorted(self.store.rejected)
        # all units pass most of the time; a list of all names would only slow the layers down
        narrowed = self.filtered and len(self.store.order) < len(self.store.rows)
        passing = sorted(self.store.rows[k].unit_id for k in self.store.order) if narrowed else []
        key = (pair, self.store.datum, tuple(rejected), len(self.store.rows), narrowed, tuple(passing))
        if key == self._shown:
            self.follow()
            return
        self._shown = key
        # a layer drops its selection with its filter; the store must not take that for the user's wish
        self._following = True
        keep = f' AND "unit_id" NOT IN ({quoted(rejected)})' if rejected else ""
        if narrowed:
            keep += f' AND "unit_id" IN ({quoted(passing) or "NULL"})'
        epoch = f'"epoch" = {QgsExpression.quotedString(pair.epoch_from)}'
        # units that are new have their first point in the later epoch
        fresh = sorted(row.unit_id for row in self.store.rows if row.kind == "new")
        if fresh:
            later = QgsExpression.quotedString(pair.epoch_to)
            epoch = f'({epoch} OR ("epoch" = {later} AND "unit_id" IN ({quoted(fresh)})))'
        self.units.setSubsetString(epoch + keep)
        self.rejected.setSubsetString(
            f'"epoch" = {QgsExpression.quotedString(pair.epoch_from)} AND "unit_id" IN ({quoted(rejected) or "NULL"})'
        )
        # results of earlier versions have no outlines
        if self.outlines.isValid():
            self.outlines.setSubsetString(f'"epoch" = {QgsExpression.quotedString(pair.epoch_to)}{keep}')
        if self.gaps.isValid():
            self.gaps.setSubsetString(f'"epoch" = {QgsExpression.quotedString(pair.epoch_to)}')
        both = quoted((pair.epoch_from, pair.epoch_to))
        for layer in self.added.values():
            layer.setSubsetString(f'"epoch" IN ({both})')
        ends = {"epoch_from": pair.epoch_from, "epoch_to": pair.epoch_to, "datum": self.store.datum, "feature": "centre"}
        condition = " AND ".join(f'"{name}" = {QgsExpression.quotedString(value)}' for name, value in ends.items())
        reference = datum_label(self.store.datum)
        for layer in (self.displacements, self.other):
            layer.setSubsetString(condition + keep)
            # one arrow a unit, of one datum, and the legend says which
            layer.setName(tr("Displacements: {datum}").format(datum=reference))
            node = self.project.layerTreeRoot().findLayer(layer.id())
            if node is not None:
                node.setItemVisibilityChecked(next(layer.getFeatures(QgsFeatureRequest().setLimit(1)), None) is not None)
        for layer in self.layers:
            layer.triggerRepaint()
        request = QgsFeatureRequest().setFlags(Qgis.FeatureRequestFlag.NoGeometry).setSubsetOfAttributes(["unit_id"], self.units.fields())
        self._units = {feature.id(): str(feature["unit_id"]) for feature in self.units.getFeatures(request)}
        self._fids = {}
        for fid, unit in self._units.items():
            self._fids.setdefault(unit, []).append(fid)
        self._following = False
        self.follow()

    def reload(self) -> None:
        """Read the layers again after a correction changed the file."""
        group = next(g for g in self.project.layerTreeRoot().findGroups(True) if g.customProperty(GROUP_PROPERTY) == self._token)
        for layer in self._open_added():
            self.project.addMapLayer(layer, False)
            group.insertLayer(0, layer)
        for layer in self.layers:
            layer.dataProvider().reloadData()
        self._shown = None
        self.show_pair()

    def follow(self) -> None:
        """Select on the map what the store has selected."""
        if self._following:
            return
        self._following = True
        self.units.selectByIds([fid for unit in self.store.selected for fid in self._fids.get(unit, [])])
        self._following = False

    def zoom(self) -> None:
        """Bring the current unit into the middle of the map and flash it."""
        row = self.store.row(self.store.current) if self.store.current else None
        if row is None or row.place is None:
            return
        point = self._to_canvas(row.place)
        if point is None:
            return
        half = ZOOM_HEIGHTS / 2 * (row.height or 2.0)
        self.canvas.setExtent(QgsRectangle(point.x() - half, point.y() - half, point.x() + half, point.y() + half))
        self.canvas.refresh()
        self.flash()

    def flash(self) -> None:
        """Flash the current unit."""
        row = self.store.row(self.store.current) if self.store.current else None
        if row is not None and row.place is not None:
            circle = QgsGeometry.fromPointXY(QgsPointXY(row.place[0], row.place[1])).buffer(0.5 * (row.height or 2.0), 16)
            self.canvas.flashGeometries([circle], self.units.crs())

    def zoom_to_all(self) -> None:
        """Show all units, with their bodies where they lay and where they lie now."""
        extent = self.units.extent()
        if self.outlines.isValid() and not self.outlines.extent().isEmpty():
            extent.combineExtentWith(self.outlines.extent())
        # a single unit of a result without outlines is a point
        extent = extent.buffered(max((row.height or 0.0 for row in self.store.rows), default=0.0) / 2)
        if extent.isEmpty():
            return
        corners = QgsCoordinateTransform(self.units.crs(), self.canvas.mapSettings().destinationCrs(), self.project)
        extent = corners.transformBoundingBox(extent)
        extent.scale(1.1)
        self.canvas.setExtent(extent)
        self.canvas.refresh()

    def unit_at(self, point: QgsPointXY) -> str | None:
        """The unit that a click on the canvas means: the arrow under it, else the outline, else the nearest centre within reach."""
        place = self.to_survey(point)
        if place is None:
            return None
        click = np.array([place.x(), place.y()])
        # by a second place as far from the click as the reach is on the canvas, whose CRS may be another one
        aside = self.to_survey(QgsPointXY(point.x() + REACH_PIXELS * self.canvas.mapUnitsPerPixel(), point.y()))
        reach = float(np.hypot(*(np.array([aside.x(), aside.y()]) - click))) if aside is not None else 0.0
        return self._arrow_at(click, reach) or self._outline_at(place) or self._centre_at(click, reach)

    def _arrow_at(self, click: FloatArray, reach: float) -> str | None:
        """Unit whose arrow is drawn under a click: arrows have a length on paper, which the map's scale turns into one on the ground."""
        rejected = self.store.rejected
        shown = [row for row in self.store.rows if row.unit_id not in rejected]
        found = [(row.unit_id, row.place[:2], row.vector[:2]) for row in shown if row.vector is not None and row.place is not None]
        if not found:
            return None
        names, places, moves = zip(*found, strict=True)
        starts, vectors = np.array(places), np.array(moves)
        lengths = np.maximum(np.hypot(*vectors.T), 1e-6)
        arrows = vectors * (np.minimum(PAPER_PER_METRE, LONGEST_ON_PAPER / lengths) * self.canvas.scale())[:, None]
        along = np.clip(((click - starts) * arrows).sum(axis=1) / np.maximum((arrows**2).sum(axis=1), 1e-12), 0, 1)
        apart = np.hypot(*(starts + along[:, None] * arrows - click).T)
        nearest = int(np.argmin(apart))
        return names[nearest] if apart[nearest] <= reach else None

    def _outline_at(self, place: QgsPointXY) -> str | None:
        """Unit inside whose outline a place lies, the highest of several."""
        if not self.outlines.isValid():
            return None
        request = QgsFeatureRequest().setFilterRect(QgsRectangle(place, place).buffered(1e-6))
        point = QgsGeometry.fromPointXY(place)
        found = [feature for feature in self.outlines.getFeatures(request) if feature.geometry().contains(point)]
        names = [str(feature["unit_id"]) for feature in found]
        rows = [row for name in names if (row := self.store.row(name)) is not None]
        heights = {row.unit_id: float(row.place[2]) for row in rows if row.place is not None}
        return max(heights, key=lambda unit: heights[unit]) if heights else None

    def _centre_at(self, click: FloatArray, reach: float) -> str | None:
        """Unit whose centre lies nearest to a click, if within reach or half the unit's height."""
        found = [(float(np.hypot(*(row.place[:2] - click))), row) for row in self.store.rows if row.place is not None]
        if not found:
            return None
        apart, nearest = min(found, key=lambda unit: unit[0])
        return nearest.unit_id if apart <= max(reach, 0.5 * (nearest.height or 0.0)) else None

    def to_survey(self, point: QgsPointXY) -> QgsPointXY | None:
        """A place on the canvas in the survey's CRS; None where it cannot be transformed."""
        try:
            return QgsCoordinateTransform(self.canvas.mapSettings().destinationCrs(), self.units.crs(), self.project).transform(point)
        except QgsCsException:
            return None

    def extent_ring(self) -> FloatArray:
        """(4, 2) corners of the map's extent in the survey's CRS."""
        box = self.canvas.extent()
        corners = [
            (box.xMinimum(), box.yMinimum()),
            (box.xMaximum(), box.yMinimum()),
            (box.xMaximum(), box.yMaximum()),
            (box.xMinimum(), box.yMaximum()),
        ]
        points = [self.to_survey(QgsPointXY(x, y)) for x, y in corners]
        return np.array([(p.x(), p.y()) for p in points if p is not None]).reshape(-1, 2)

    def polygon_rings(self, layer: QgsVectorLayer) -> tuple[FloatArray, ...]:
        """Rings of a polygon layer's selected features (all when none is selected) in the survey's CRS."""
        features = layer.selectedFeatures() or list(layer.getFeatures())
        transform = QgsCoordinateTransform(layer.crs(), self.units.crs(), self.project)
        rings = []
        for feature in features:
            if not feature.hasGeometry():
                continue
            geometry = QgsGeometry(feature.geometry())
            geometry.transform(transform)
            parts = geometry.asMultiPolygon() if geometry.isMultipart() else [geometry.asPolygon()]
            rings += [np.array([(p.x(), p.y()) for p in ring]) for part in parts for ring in part]
        return tuple(rings)

    def _to_canvas(self, place: FloatArray) -> QgsPointXY | None:
        try:
            transform = QgsCoordinateTransform(self.units.crs(), self.canvas.mapSettings().destinationCrs(), self.project)
            return transform.transform(QgsPointXY(place[0], place[1]))
        except QgsCsException:
            return None

    def _tell_store(self) -> None:
        if self._following:
            return
        self._following = True
        self.store.select(self._units[fid] for fid in self.units.selectedFeatureIds() if fid in self._units)
        self._following = False

    def _open(self, name: str, title: str) -> QgsVectorLayer:
        options = QgsVectorLayer.LayerOptions(self.project.transformContext())
        # a writable connection would turn the file to write-ahead logging, and layers opened before would lose it
        options.forceReadOnly = True
        return QgsVectorLayer(f"{self.store.path.as_posix()}|layername={name}", title, "ogr", options)

    def _open_first(self, name: str, title: str) -> QgsVectorLayer:
        layer = self._open(name, title)
        # opening and styling all layers takes a third of a second: the window draws itself between two of them
        draw()
        return layer

    def _open_added(self) -> list[QgsVectorLayer]:
        """Open the layers that corrections have added to the file; those that are new."""
        new = []
        for name, title in (("unit_edits", tr("Placeholders and corrections")), ("manual_picks", tr("Points picked by hand"))):
            if name not in self.added and name in table_names(self.store.path):
                layer = self._open(name, title)
                if layer.isValid():
                    apply_style(layer, name)
                    self.added[name] = layer
                    self.layers.insert(0, layer)
                    new.append(layer)
        return new

    def _style(self) -> None:
        write_project_lengths(self.project)
        for layer, name in (
            (self.units, "units"),
            (self.outlines, "unit_outlines"),
            (self.displacements, "displacements"),
            (self.other, "displacements"),
            (self.gaps, "gaps"),
        ):
            if layer.isValid():
                apply_style(layer, name)
                show_every_epoch(layer)
                draw()
        symbol = QgsMarkerSymbol.createSimple({"name": "cross2", "size": "3.2", "outline_width": "0.5"})
        symbol.setColor(QColor("#7F8C8D"))
        symbol.symbolLayer(0).setStrokeColor(QColor("#7F8C8D"))
        self.rejected.setRenderer(QgsSingleSymbolRenderer(symbol))

    def _add(self) -> None:
        # a project saved while a review was open brings that review's group with it
        remove_groups(self.project)
        group = self.project.layerTreeRoot().insertGroup(0, tr("Displacement review: {name}").format(name=self.store.path.stem))
        group.setCustomProperty(GROUP_PROPERTY, self._token)
        for layer in self.layers:
            self.project.addMapLayer(layer, False)
            group.addLayer(layer).setExpanded(layer in (self.displacements, self.outlines))
        self._hide_twins()
