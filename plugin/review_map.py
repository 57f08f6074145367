"""The map side of a review: layers of the pair, selection in step, zoom and flash, clicks for corrections."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray
from qgis.core import (
    Qgis,
    QgsCoordinateTransform,
    QgsCsException,
    QgsExpression,
    QgsFeatureRequest,
    QgsGeometry,
    QgsLayerTreeGroup,
    QgsMarkerSymbol,
    QgsPointXY,
    QgsProject,
    QgsRectangle,
    QgsSingleSymbolRenderer,
    QgsVectorLayer,
)
from qgis.gui import QgsMapCanvas, QgsMapMouseEvent, QgsMapTool
from qgis.PyQt.QtCore import QObject, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor

from .layers import apply_style
from .review_store import ReviewStore
from .translation import tr

FloatArray = NDArray[np.float64]

ZOOM_HEIGHTS = 12.0
"""Width of the map after zooming to a unit, in heights of the unit."""


def quoted(values: Iterable[str]) -> str:
    """A list of values for a layer's filter expression."""
    return ", ".join(QgsExpression.quotedString(value) for value in values)


class ReviewMap(QObject):
    """Layers of one store on one canvas, selecting what the store selects and the other way round."""

    def __init__(self, store: ReviewStore, canvas: QgsMapCanvas, project: QgsProject, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.store, self.canvas, self.project = store, canvas, project
        self._group: QgsLayerTreeGroup | None = None
        self._following = False
        self._shown: tuple[object, ...] | None = None
        self._fids: dict[str, list[int]] = {}
        self._units: dict[int, str] = {}
        self.units = self._open("units", tr("Units reviewed"))
        self.displacements = self._open("displacements", tr("Displacements reviewed"))
        self.other = self._open("displacements_other", tr("Displacements reviewed, other pair or datum"))
        self.rejected = self._open("units", tr("Rejected units (excluded)"))
        self.layers = [layer for layer in (self.rejected, self.displacements, self.other, self.units) if layer.isValid()]
        self._style()
        self._add()
        self.units.selectionChanged.connect(self._tell_store)

    def remove(self) -> None:
        """Take the layers out of the project again."""
        ids = [layer.id() for layer in self.layers]
        self.project.removeMapLayers([layer_id for layer_id in ids if self.project.mapLayer(layer_id) is not None])
        if self._group is not None and self._group.parent() is not None:
            self._group.parent().removeChildNode(self._group)
        self._group = None

    def show_pair(self) -> None:
        """Show the store's epoch pair and datum, rejected units apart."""
        pair, rejected = self.store.pair, sorted(self.store.rejected)
        key = (pair, self.store.datum, tuple(rejected), len(self.store.rows))
        if key == self._shown:
            self.follow()
            return
        self._shown = key
        # a layer drops its selection with its filter; the store must not take that for the user's wish
        self._following = True
        keep = f' AND "unit_id" NOT IN ({quoted(rejected)})' if rejected else ""
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
        ends = {"epoch_from": pair.epoch_from, "epoch_to": pair.epoch_to, "datum": self.store.datum, "feature": "centre"}
        condition = " AND ".join(f'"{name}" = {QgsExpression.quotedString(value)}' for name, value in ends.items())
        for layer in (self.displacements, self.other):
            layer.setSubsetString(condition + keep)
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
        """Show all units."""
        extent = self.units.extent()
        if extent.isEmpty():
            return
        corners = QgsCoordinateTransform(self.units.crs(), self.canvas.mapSettings().destinationCrs(), self.project)
        extent = corners.transformBoundingBox(extent)
        extent.scale(1.1)
        self.canvas.setExtent(extent)
        self.canvas.refresh()

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

    def _style(self) -> None:
        apply_style(self.units, "units")
        apply_style(self.displacements, "displacements")
        apply_style(self.other, "displacements")
        symbol = QgsMarkerSymbol.createSimple({"name": "cross2", "size": "3.2", "outline_width": "0.5"})
        symbol.setColor(QColor("#7F8C8D"))
        symbol.symbolLayer(0).setStrokeColor(QColor("#7F8C8D"))
        self.rejected.setRenderer(QgsSingleSymbolRenderer(symbol))

    def _add(self) -> None:
        self._group = self.project.layerTreeRoot().insertGroup(0, tr("Displacement review: {name}").format(name=self.store.path.stem))
        for layer in self.layers:
            self.project.addMapLayer(layer, False)
            self._group.addLayer(layer)


class ClickTool(QgsMapTool):
    """One click on the map, for corrections; ``clicked`` carries the place in canvas coordinates, Escape ends the tool."""

    clicked = pyqtSignal(QgsPointXY)
    left = pyqtSignal()

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self.setCursor(Qt.CursorShape.CrossCursor)

    def canvasReleaseEvent(self, event: QgsMapMouseEvent) -> None:
        """Tell where the user clicked."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.clicked.emit(event.mapPoint())

    def keyReleaseEvent(self, event: object) -> None:
        """Leave the tool with Escape."""
        if event.key() == Qt.Key.Key_Escape:
            self.left.emit()
