"""A 3D view of a result in one click: bodies by class, arrows of displacement and, where there is one, the point cloud beside it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from qgis._3d import QgsLine3DSymbol, QgsSimpleLineMaterialSettings, QgsVectorLayer3DRenderer
from qgis.core import (
    Qgis,
    QgsCoordinateTransform,
    QgsFeature,
    QgsLineString,
    QgsPoint,
    QgsPointCloudLayer,
    QgsProject,
    QgsRectangle,
    QgsVector3D,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import Qt, QTimer
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtWidgets import QApplication, QLabel

from ..algorithms.support.layers import apply_style, layer_title
from ..algorithms.support.lengths import round_below
from ..algorithms.support.translation import tr
from ..core.results.class_colours import CLASS_COLOURS
from .review_text import kind_label

CLOUD_ENDINGS = (".copc.laz", "_residuals.copc.laz")
LEGEND = "tetratrack_legend_3d"
ARROW_COLOUR = "#c62828"
ARROW_HEIGHTS = 0.75
"""Arrows begin so far above the centre, in heights of the unit: within the body nobody would see them."""
ARROW_PIXELS = 4.0
TYPICAL_ARROW = 0.65
"""Heights of a unit that a typical significant displacement is drawn as, on a breakwater and in a tank."""
NEAREST_HEIGHTS = 4.5
"""Heights of a unit from which a few units are seen."""
NEAREST_CAMERA = 10.0
"""Metres nearer than which QGIS's camera does not go."""
ARROWS_PROPERTY = "tetratrack/arrows_3d"
"""Custom property of the layer of arrows: the result they are of."""
PITCH = 55.0
"""Degrees from straight down: a slope is seen from its foot."""


@dataclass(frozen=True)
class Scene:
    """What the view is to show: layers, the bodies first; extent (project's CRS) and heights; enlargement of the arrows, 0 for none; and
    the height H of the largest unit, metres."""

    layers: list[Any]
    extent: QgsRectangle
    heights: tuple[float, float]
    arrow_scale: float
    unit_height: float


def scene_of(result: Path, project: QgsProject) -> Scene | None:
    """Add what is missing of a result's scene to a project; None where the result has no bodies."""
    surfaces = _layer(result, "unit_surfaces", project)
    if surfaces is None or not surfaces.featureCount():
        return None
    height = unit_height(result)
    arrows, scale = arrow_layer(result, project, height)
    layers = [layer for layer in (surfaces, arrows, _cloud(result, project)) if layer is not None]
    corners = [(v.x(), v.y(), v.z()) for feature in surfaces.getFeatures() for v in _corners(feature)]
    east, north, heights = zip(*corners, strict=True)
    extent = QgsRectangle(min(east), min(north), max(east), max(north))
    if project.crs().isValid():
        extent = QgsCoordinateTransform(surfaces.crs(), project.crs(), project).transformBoundingBox(extent)
    return Scene(layers, extent, (min(heights), max(heights)), scale, height)


def unit_height(result: Path) -> float:
    """Height H of a result's largest unit, metres; one metre where it holds none."""
    units = QgsVectorLayer(f"{result}|layername=units", "units", "ogr")
    values = units.uniqueValues(units.fields().lookupField("height")) if units.isValid() else ()
    return max((float(value) for value in values if value), default=1.0)


def open_view(iface: Any, result: Path, project: QgsProject | None = None) -> Any:
    """Open QGIS's 3D view with the scene of a result, seen from the foot of the slope, with a legend; None where there is nothing to see.

    Parameters
    ----------
    iface
        Interface of QGIS.
    result
        GeoPackage of a run.
    project
        Where the layers go; the current one by default.
    """
    project = project or QgsProject.instance()
    scene = scene_of(result, project)
    if scene is None:
        return None
    canvas = iface.createNewMapCanvas3D(free_name(iface))
    if canvas is None:
        return None
    settings = canvas.mapSettings()
    settings.setLayers(scene.layers)
    settings.setTerrainRenderingEnabled(False)
    settings.setExtent(scene.extent)
    middle = scene.extent.center()
    # single precision in the scene: coordinates of seven digits would shake
    settings.setOrigin(QgsVector3D(middle.x(), middle.y(), 0.0))
    settings.setShowLabels(False)
    settings.setEyeDomeLightingEnabled(True)
    # the scene is built in the background: a camera that is set before is moved away again
    QTimer.singleShot(800, lambda: look_at(canvas, scene))
    add_legend(scene)
    return canvas


def arrow_layer(result: Path, project: QgsProject, height: float) -> tuple[QgsVectorLayer | None, float]:
    """Arrows over units of height H that moved since the epoch before the latest, and how much they are enlarged; None and 0 for none."""
    source = QgsVectorLayer(f"{result}|layername=displacements", "displacements", "ogr")
    if not source.isValid():
        return None, 0.0
    times = source.uniqueValues(source.fields().lookupField("time_to"))
    latest = max(times, default=None)
    moved = []
    for feature in source.getFeatures():
        if feature["feature"] == "centre" and feature["significant"] and feature["time_to"] == latest:
            corners = list(_corners(feature))
            if len(corners) == 2 and feature["class"] != "relocated":
                moved.append(
                    (corners[0], [corners[1].x() - corners[0].x(), corners[1].y() - corners[0].y(), corners[1].z() - corners[0].z()])
                )
    if not moved:
        return None, 0.0
    lengths = sorted(math.hypot(*vector) for _, vector in moved)
    scale = round_below(max(1.0, TYPICAL_ARROW * height / max(lengths[len(lengths) // 2], 1e-3 * height)))
    features = []
    for start, vector in moved:
        feature = QgsFeature()
        feature.setGeometry(QgsLineString(arrow(start, [scale * value for value in vector], ARROW_HEIGHTS * height)))
        features.append(feature)
    layer = _arrows_of(result, project, source)
    layer.dataProvider().addFeatures(features)
    return layer, scale


def _arrows_of(result: Path, project: QgsProject, source: QgsVectorLayer) -> QgsVectorLayer:
    """The project's layer for the arrows of a result, empty: that of an earlier view, or a new one."""
    for known in project.mapLayers().values():
        if isinstance(known, QgsVectorLayer) and known.customProperty(ARROWS_PROPERTY) == str(result):
            known.dataProvider().truncate()
            return known
    layer = QgsVectorLayer(f"LineStringZ?crs={source.crs().toWkt()}", tr("Displacements in 3D"), "memory")
    layer.setCrs(source.crs())
    layer.setCustomProperty(ARROWS_PROPERTY, str(result))
    symbol = QgsLine3DSymbol()
    # tubes lose the heights of their corners
    symbol.setRenderAsSimpleLines(True)
    symbol.setWidth(ARROW_PIXELS)
    symbol.setAltitudeClamping(Qgis.AltitudeClamping.Absolute)
    symbol.setAltitudeBinding(Qgis.AltitudeBinding.Vertex)
    material = QgsSimpleLineMaterialSettings()
    material.setAmbient(QColor(ARROW_COLOUR))
    symbol.setMaterialSettings(material)
    layer.setRenderer3D(QgsVectorLayer3DRenderer(symbol))
    project.addMapLayer(layer, False)
    project.layerTreeRoot().addLayer(layer).setItemVisibilityChecked(False)
    return layer


def arrow(start: QgsPoint, vector: list[float], above: float) -> list[QgsPoint]:
    """Corners of an arrow along a vector, drawn in one stroke: shaft, one barb, back to the tip, the other barb; metres."""
    base = [start.x(), start.y(), start.z() + above]
    tip = [b + v for b, v in zip(base, vector, strict=True)]
    length = max(math.hypot(*vector), 1e-9)
    level = math.hypot(vector[0], vector[1])
    aside = [-vector[1] / level, vector[0] / level, 0.0] if level > 1e-9 else [1.0, 0.0, 0.0]
    barbs = [[t - 0.25 * v + sign * 0.12 * length * a for t, v, a in zip(tip, vector, aside, strict=True)] for sign in (1, -1)]
    return [QgsPoint(*place) for place in (base, tip, barbs[0], tip, barbs[1], tip)]


def free_name(iface: Any) -> str:
    """A name that no 3D view bears yet: two of one name are refused."""
    taken = {canvas.objectName() for canvas in iface.mapCanvases3D()}
    base = tr("Tetrapods in 3D")
    return next(name for k in range(1, len(taken) + 2) if (name := base if k == 1 else f"{base} {k}") not in taken)


def look_at(canvas: Any, scene: Scene) -> None:
    """Turn the camera so that the whole structure fills the view, seen along the fall of its slope."""
    settings = canvas.mapSettings()
    middle = scene.extent.center()
    height = sum(scene.heights) / 2
    place = settings.mapToWorldCoordinates(QgsVector3D(middle.x(), middle.y(), height))
    distance = 1.15 * max(math.hypot(scene.extent.width(), scene.extent.height()), NEAREST_HEIGHTS * scene.unit_height)
    if distance < NEAREST_CAMERA:
        # models in a tank are looked at through a longer lens
        half = math.tan(math.radians(settings.fieldOfView()) / 2)
        settings.setFieldOfView(math.degrees(2 * math.atan(half * distance / NEAREST_CAMERA)))
    canvas.cameraController().setLookingAtPoint(place, max(distance, NEAREST_CAMERA), PITCH, slope_azimuth(scene.layers[0]))


def slope_azimuth(surfaces: QgsVectorLayer) -> float:
    """Degrees by which the camera is turned so that the higher units stand behind the lower ones; 0 on level ground."""
    places = []
    for feature in surfaces.getFeatures():
        corners = list(_corners(feature))
        if corners:
            places.append([sum(values) / len(corners) for values in zip(*((v.x(), v.y(), v.z()) for v in corners), strict=True)])
    if len(places) < 3:
        return 0.0
    mean = [sum(values) / len(places) for values in zip(*places, strict=True)]
    xx = sum((p[0] - mean[0]) ** 2 for p in places)
    yy = sum((p[1] - mean[1]) ** 2 for p in places)
    xy = sum((p[0] - mean[0]) * (p[1] - mean[1]) for p in places)
    xz = sum((p[0] - mean[0]) * (p[2] - mean[2]) for p in places)
    yz = sum((p[1] - mean[1]) * (p[2] - mean[2]) for p in places)
    divisor = xx * yy - xy * xy
    if abs(divisor) < 1e-9:
        return 0.0
    east, north = (xz * yy - yz * xy) / divisor, (yz * xx - xz * xy) / divisor
    return math.degrees(math.atan2(-east, north)) if math.hypot(east, north) > 0.02 else 0.0


def add_legend(scene: Scene) -> QLabel | None:
    """Put the classes that are shown, with their colours, under the newest 3D view; None where QGIS has built the view otherwise."""
    host = next(
        (w for w in reversed(QApplication.allWidgets()) if w.metaObject().className() == "Qgs3DMapCanvasWidget" and w.layout()), None
    )
    if host is None:
        return None
    surfaces = scene.layers[0]
    present = {str(value) for value in surfaces.uniqueValues(surfaces.fields().lookupField("class"))}
    present |= {"stable"} if "found" in present else set()
    entries = [f'<span style="color:{colour}">■</span> {kind_label(kind)}' for kind, colour in CLASS_COLOURS.items() if kind in present]
    if scene.arrow_scale:
        words = tr("significant displacement, enlarged {scale} times").format(scale=f"{scene.arrow_scale:g}")
        entries.append(f'<span style="color:{ARROW_COLOUR}">➜</span> {words}')
    label = QLabel("&nbsp;&nbsp; ".join(entries), host)
    label.setObjectName(LEGEND)
    label.setTextFormat(Qt.TextFormat.RichText)
    label.setContentsMargins(4, 4, 4, 4)
    host.layout().addWidget(label)
    return label


def _layer(result: Path, name: str, project: QgsProject) -> QgsVectorLayer | None:
    """A layer of the result: that of the project if it is loaded whole or for an earlier view, else its own, styled, hidden on the map."""
    wanted = f"{result}|layername={name}"
    layer = QgsVectorLayer(wanted, layer_title(name), "ogr")
    if not layer.isValid():
        return None
    if name == "unit_surfaces":
        # the latest epoch alone: both would stand in each other
        layer.setSubsetString('"epoch_until" IS NULL')
    for known in project.mapLayers().values():
        if known.source() in (wanted, layer.source()):
            return known
    apply_style(layer, name)
    project.addMapLayer(layer, False)
    project.layerTreeRoot().addLayer(layer).setItemVisibilityChecked(False)
    return layer


def _cloud(result: Path, project: QgsProject) -> QgsPointCloudLayer | None:
    """The point cloud beside a result (``NAME.copc.laz``, ``NAME_residuals.copc.laz``), which QGIS shows where its own library is there."""
    for ending in CLOUD_ENDINGS:
        path = result.with_name(f"{result.stem}{ending}")
        if path.is_file():
            layer = QgsPointCloudLayer(str(path), path.stem, "copc")
            for known in project.mapLayers().values():
                if known.source() == layer.source():
                    return known
            if layer.isValid():
                project.addMapLayer(layer, False)
                project.layerTreeRoot().addLayer(layer).setItemVisibilityChecked(False)
                return layer
    return None


def _corners(feature: Any) -> Any:
    return feature.geometry().vertices()
