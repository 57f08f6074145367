"""Drawings of the review: a unit from above, and a vertical section through it.

Drawn with QPainter alone, in the colours of the running theme.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from qgis.PyQt.QtCore import QPointF, QRectF, QSize, QSizeF, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QFontMetricsF, QMouseEvent, QPainter, QPaintEvent, QPalette, QPen, QPolygonF, QWheelEvent
from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from ..algorithms.support.lengths import decimal, round_below
from ..algorithms.support.translation import tr
from ..core.common.arrays import FloatArray
from ..core.model.outline import PlacedShape, end_discs, section, silhouette
from .review_text import is_dark, paper

# Okabe and Ito (2008): told apart by colour-blind readers; the lighter tones serve dark themes
EARLIER, LATER = ("#0072B2", "#56B4E9"), ("#D55E00", "#E69F00")
SLAB = 0.12
"""Half thickness of the slab of points drawn in the section, as a fraction of the leg length."""
MOST_POINTS = 6_000
MARGIN = 6
LEAST_LINES = 9
"""Lines of text that a view is high at least where it names its datum, too."""


@dataclass(frozen=True, eq=False)
class UnitScene:
    """What the views of one unit show.

    Attributes
    ----------
    shapes
        Outlines of the earlier and the later pose; None where the unit was not found.
    points
        (n, 3) points of both epochs around the unit, control frame.
    features
        Feature points of both epochs by name.
    picks
        Points picked by hand in both epochs, (m, 3).
    labels
        Labels of both epochs.
    datum
        Name of the datum everything is drawn in.
    shift
        (3,) by which the later epoch is drawn aside for that.
    note
        Why there are no points, to be read in the view.
    """

    shapes: tuple[PlacedShape | None, PlacedShape | None] = (None, None)
    points: tuple[FloatArray, FloatArray] = field(default_factory=lambda: (np.empty((0, 3)), np.empty((0, 3))))
    features: tuple[dict[str, FloatArray], dict[str, FloatArray]] = field(default_factory=lambda: ({}, {}))
    picks: tuple[FloatArray, FloatArray] = field(default_factory=lambda: (np.empty((0, 3)), np.empty((0, 3))))
    labels: tuple[str, str] = ("", "")
    note: str = ""
    datum: str = ""
    shift: FloatArray = field(default_factory=lambda: np.zeros(3))

    @cached_property
    def middle(self) -> FloatArray | None:
        """Point the views are centred on."""
        centres = [shape.centre for shape in self.shapes if shape is not None]
        return np.mean(centres, axis=0) if centres else None

    @cached_property
    def half_size(self) -> float:
        """Metres from the middle to the edge of the views: both poses fit."""
        shapes, middle = [shape for shape in self.shapes if shape is not None], self.middle
        if middle is None:
            return 1.0
        spread = max(float(np.linalg.norm(shape.centre - middle)) for shape in shapes)
        return 1.15 * shapes[0].leg_length + spread

    @property
    def section_azimuth(self) -> float:
        """Direction of the displacement, radians from north clockwise; east where there is none."""
        first, second = self.shapes
        if first is None or second is None:
            return math.pi / 2
        de, dn, _ = second.centre - first.centre
        return math.atan2(de, dn) if math.hypot(de, dn) > 0 else math.pi / 2


class UnitView(QWidget):
    """Plan or vertical section of a unit in two epochs; wheel zooms, drag moves, double click resets.

    ``picked`` carries the (e, n, h) of the point nearest to a click while picking is on.
    """

    picked = pyqtSignal(object)

    def __init__(self, kind: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._plan = kind == "plan"
        self.setObjectName(f"view_{kind}")
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(140, 120)
        self.setMouseTracking(True)
        self.scene = UnitScene()
        self.picking_epoch: int | None = None
        self._azimuth: float | None = None
        self._zoom, self._shift = 1.0, QPointF(0, 0)
        self._pressed: QPointF | None = None
        self._moved = False
        self._hover = ""
        self._curves: list[tuple[int, FloatArray, list[FloatArray]]] = []
        self._flat: list[FloatArray] = []

    def sizeHint(self) -> QSize:
        """Wide enough for the outlines to be read."""
        return QSize(240, 200)

    def show_scene(self, scene: UnitScene) -> None:
        """Draw another unit, from the standard view."""
        self.scene = scene
        self._zoom, self._shift = 1.0, QPointF(0, 0)
        self._prepare()

    def set_azimuth(self, azimuth: float | None) -> None:
        """Direction of the section in radians from north; None follows the displacement."""
        self._azimuth = azimuth
        self._prepare()

    def set_picking(self, epoch: int | None) -> None:
        """Pick points of the earlier (0) or later (1) epoch by clicking; None ends it."""
        self.picking_epoch = epoch
        self.setCursor(Qt.CursorShape.ArrowCursor if epoch is None else Qt.CursorShape.CrossCursor)

    @property
    def azimuth(self) -> float:
        """Direction of the section drawn, radians from north."""
        return self.scene.section_azimuth if self._azimuth is None else self._azimuth

    def axes(self) -> tuple[FloatArray, FloatArray]:
        """Unit vectors that point right and up in the drawing."""
        if self._plan:
            return np.array([1.0, 0, 0]), np.array([0, 1.0, 0])
        return np.array([math.sin(self.azimuth), math.cos(self.azimuth), 0]), np.array([0, 0, 1.0])

    def _prepare(self) -> None:
        right, up = self.axes()
        middle = self.scene.middle
        self._curves, self._flat = [], []
        if middle is not None:
            axes = np.vstack([right, up])
            for epoch, shape in enumerate(self.scene.shapes):
                if shape is not None:
                    place = axes @ (shape.centre - middle)
                    curve = silhouette(shape, right, up) if self._plan else section(shape, right, up)
                    discs = end_discs(shape, right, up) if self._plan else []
                    self._curves.append((epoch, curve + place, [disc + place for disc in discs]))
            self._flat = [(self._visible(points) - middle) @ axes.T for points in self.scene.points]
        self.update()

    def _visible(self, points: FloatArray) -> FloatArray:
        if not self._plan and self.scene.middle is not None:
            right, up = self.axes()
            length = next(shape.leg_length for shape in self.scene.shapes if shape is not None)
            points = points[np.abs((points - self.scene.middle) @ np.cross(right, up)) <= SLAB * length]
        return points[:: max(1, math.ceil(len(points) / MOST_POINTS))]

    def _side(self) -> float:
        """Pixels of the square that the drawing fills."""
        return min(self.width(), self.height() - 2 * self.fontMetrics().height()) - 2 * MARGIN

    def pixels_per_metre(self) -> float:
        """Scale of the drawing."""
        return self._zoom * self._side() / (2 * self.scene.half_size)

    def _origin(self) -> QPointF:
        # names and notes stand to the left, above and below: the drawing makes room for them where it has any
        aside = min(0.5 * (self.width() - 2 * MARGIN - self._side()), 0.5 * self._legend_size().width())
        return QPointF(self.width() / 2 + max(aside, 0.0), self.height() / 2) + self._shift

    def _legend_size(self) -> QSizeF:
        """Room of title, epochs and datum; the datum is left out where it would leave the drawing none."""
        metrics = QFontMetricsF(self.font())
        lines = 4 if self._datum() else 3
        wide = max(metrics.horizontalAdvance(text) for text in (self._title(), self._datum(), *self.scene.labels))
        return QSizeF(wide + 2 * MARGIN + 22, lines * metrics.height() + MARGIN + 2)

    def _title(self) -> str:
        return tr("Plan") if self._plan else tr("Section {azimuth}°").format(azimuth=f"{math.degrees(self.azimuth) % 360:.0f}")

    def _datum(self) -> str:
        if self.height() < LEAST_LINES * self.fontMetrics().height():
            return ""
        return str(self.fontMetrics().elidedText(self.scene.datum, Qt.TextElideMode.ElideRight, self.width() - 2 * MARGIN - 22))

    def _to_screen(self, flat: FloatArray) -> QPolygonF:
        scale, origin = self.pixels_per_metre(), self._origin()
        places = np.asarray(flat) * [scale, -scale] + [origin.x(), origin.y()]
        return QPolygonF([QPointF(x, y) for x, y in places.tolist()])

    def _to_metres(self, place: QPointF) -> FloatArray:
        scale, origin = self.pixels_per_metre(), self._origin()
        return np.array([(place.x() - origin.x()) / scale, (origin.y() - place.y()) / scale])

    def zoom_about(self, place: QPointF, factor: float) -> None:
        """Zoom by a factor; the given place stays where it is."""
        zoom = min(max(self._zoom * factor, 0.3), 40.0)
        self._shift = self._shift - (place - self._origin()) * (zoom / self._zoom - 1)
        self._zoom = zoom
        self.update()

    def move_by(self, step: QPointF) -> None:
        """Move the drawing by some pixels."""
        self._shift = self._shift + step
        self.update()

    def reset(self) -> None:
        """Back to the standard view."""
        self._zoom, self._shift = 1.0, QPointF(0, 0)
        self.update()

    def pick_at(self, place: QPointF) -> None:
        """Pick the point nearest to a place, while picking is on."""
        point = self.nearest_point(place)
        if point is not None:
            self.picked.emit(point)

    # events

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom about the cursor."""
        self.zoom_about(event.position(), 1.25 if event.angleDelta().y() > 0 else 0.8)
        event.accept()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin to move the drawing."""
        self._pressed, self._moved = QPointF(event.pos()), False

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Move the drawing, or read out the coordinates under the cursor."""
        place = QPointF(event.pos())
        if self._pressed is not None:
            step = place - self._pressed
            if self._moved or step.manhattanLength() > 4:
                self._moved = True
                self._shift, self._pressed = self._shift + step, place
        elif self.scene.middle is not None:
            right, up = self.axes()
            x, y = self._to_metres(place)
            e, n, h = self.scene.middle + x * right + y * up
            self._hover = f"E {decimal(e, 2)}  N {decimal(n, 2)}" if self._plan else f"{decimal(x, 2, signed=True)} m  H {decimal(h, 2)}"
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Pick a point where the drawing was not moved."""
        if self._pressed is not None and not self._moved:
            self.pick_at(QPointF(event.pos()))
        self._pressed = None

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Back to the standard view."""
        self.reset()
        event.accept()

    def leaveEvent(self, event: object) -> None:
        """Forget the read-out."""
        self._hover = ""
        self.update()

    def nearest_point(self, place: QPointF, pixels: float = 10.0) -> FloatArray | None:
        """Point of the epoch being picked under a place of the widget, the one nearest to the viewer; None where there is none."""
        if self.picking_epoch is None or self.scene.middle is None:
            return None
        points = self._visible(self.scene.points[self.picking_epoch])
        right, up = self.axes()
        flat = (points - self.scene.middle) @ np.vstack([right, up]).T
        distance = np.hypot(*(flat - self._to_metres(place)).T) * self.pixels_per_metre()
        near = np.flatnonzero(distance <= pixels)
        if len(near) == 0:
            return None
        depth = points[near] @ np.cross(right, up)
        # a surface is only as deep as the neighbourhood is wide: among the nearest to the viewer take the closest to the cursor
        front = near[depth >= depth.max() - pixels / self.pixels_per_metre()]
        return points[front[np.argmin(distance[front])]]

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the view."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        palette, dark = self.palette(), is_dark(self.palette())
        painter.fillRect(self.rect(), paper(palette))
        ink = palette.color(QPalette.ColorRole.Text)
        if not self._curves:
            painter.setPen(ink)
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, tr("Select a unit"))
            painter.end()
            return
        colours = (QColor(EARLIER[dark]), QColor(LATER[dark]))
        for epoch, flat in enumerate(self._flat):
            colour = QColor(colours[epoch])
            colour.setAlpha(150)
            painter.setPen(QPen(colour, 2.0))
            painter.drawPoints(self._to_screen(flat))
        for epoch, curve, discs in self._curves:
            style = Qt.PenStyle.SolidLine if epoch else Qt.PenStyle.DashLine
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(colours[epoch], 2.0, style))
            painter.drawPolyline(self._to_screen(curve))
            painter.setPen(QPen(colours[epoch], 1.0, style))
            for disc in discs:
                painter.drawPolyline(self._to_screen(disc))
        self._draw_features(painter, colours)
        self._draw_arrow(painter, ink)
        self._draw_frame(painter, ink, colours)
        painter.end()

    def _draw_features(self, painter: QPainter, colours: tuple[QColor, QColor]) -> None:
        right, up = self.axes()
        axes, middle = np.vstack([right, up]), self.scene.middle
        if middle is None:
            return
        for epoch in (0, 1):
            painter.setPen(QPen(colours[epoch], 1.5))
            painter.setBrush(paper(self.palette()))
            positions = [p for name, p in self.scene.features[epoch].items() if name != "centre"]
            if positions:
                for place in self._to_screen((np.array(positions) - middle) @ axes.T):
                    painter.drawEllipse(place, 3.0, 3.0)
            if len(self.scene.picks[epoch]):
                for place in self._to_screen((self.scene.picks[epoch] - middle) @ axes.T):
                    painter.drawLine(place + QPointF(-5, -5), place + QPointF(5, 5))
                    painter.drawLine(place + QPointF(-5, 5), place + QPointF(5, -5))

    def _draw_arrow(self, painter: QPainter, ink: QColor) -> None:
        first, second = self.scene.shapes
        if first is None or second is None:
            return
        axes = np.vstack(self.axes())
        start, stop = self._to_screen((np.array([first.centre, second.centre]) - self.scene.middle) @ axes.T)
        painter.setPen(QPen(ink, 2.0))
        painter.drawLine(start, stop)
        length = math.hypot((stop - start).x(), (stop - start).y())
        if length > 8:
            unit = (stop - start) / length
            side = QPointF(-unit.y(), unit.x())
            painter.setBrush(ink)
            painter.drawPolygon(QPolygonF([stop, stop - unit * 8 + side * 4, stop - unit * 8 - side * 4]))
        else:
            painter.setBrush(ink)
            painter.drawEllipse(stop, 2.0, 2.0)

    def _draw_frame(self, painter: QPainter, ink: QColor, colours: tuple[QColor, QColor]) -> None:
        metrics = QFontMetricsF(self.font())
        line = metrics.height()
        base = paper(self.palette())
        base.setAlpha(200)
        painter.fillRect(QRectF(QPointF(0, 0), self._legend_size()), base)
        painter.setPen(ink)
        painter.drawText(QPointF(MARGIN, MARGIN + metrics.ascent()), self._title())
        for epoch in (0, 1):
            y = MARGIN + (epoch + 1.5) * line
            painter.setPen(QPen(colours[epoch], 2.0, Qt.PenStyle.SolidLine if epoch else Qt.PenStyle.DashLine))
            painter.drawLine(QPointF(MARGIN, y), QPointF(MARGIN + 18, y))
            painter.setPen(ink)
            painter.drawText(QPointF(MARGIN + 22, y + metrics.ascent() / 2 - 1), self.scene.labels[epoch])
        painter.drawText(QPointF(MARGIN, MARGIN + 3 * line + metrics.ascent()), self._datum())
        bar = round_below(0.3 * self.width() / self.pixels_per_metre())
        bottom = self.height() - MARGIN
        text = f"{decimal(bar, max(0, -math.floor(math.log10(bar))))} m"
        painter.fillRect(
            QRectF(0, bottom - line - 6, bar * self.pixels_per_metre() + metrics.horizontalAdvance(text) + 4 * MARGIN, line + 12), base
        )
        painter.setPen(QPen(ink, 2.0))
        painter.drawLine(QPointF(MARGIN, bottom - 3), QPointF(MARGIN + bar * self.pixels_per_metre(), bottom - 3))
        painter.drawText(QPointF(2 * MARGIN + bar * self.pixels_per_metre(), bottom), text)
        if self._plan:
            tip = QPointF(self.width() - 14, MARGIN + 4)
            painter.setBrush(ink)
            painter.drawPolygon(QPolygonF([tip, tip + QPointF(-4, 12), tip + QPointF(4, 12)]))
            painter.drawText(QRectF(tip.x() - 12, tip.y() + 12, 24, line), Qt.AlignmentFlag.AlignHCenter, tr("N"))
        foot = self._hover or self.scene.note
        if foot:
            shown = self.fontMetrics().elidedText(foot, Qt.TextElideMode.ElideRight, self.width() - 2 * MARGIN)
            place = QRectF(MARGIN, bottom - 2 * line - 8, metrics.horizontalAdvance(shown) + MARGIN, line)
            painter.fillRect(place, base)
            painter.drawText(place, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, shown)
