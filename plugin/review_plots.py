"""Drawings of the review: a unit from above, a vertical section through it, and its displacement over time.

Drawn with QPainter alone, in the colours of the running theme.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from functools import cached_property

import numpy as np
from qgis.PyQt.QtCore import QPointF, QRectF, QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QFontMetricsF, QMouseEvent, QPainter, QPaintEvent, QPalette, QPen, QPolygonF, QWheelEvent
from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from ..algorithms.support.lengths import LengthFormat, length_format
from ..algorithms.support.translation import tr
from ..core.common.arrays import FloatArray
from ..core.model.outline import PlacedShape, end_discs, section, silhouette
from ..core.results.unit_rows import Z_95, SeriesPoint
from .review_text import is_dark, paper

# Okabe and Ito (2008): told apart by colour-blind readers; the lighter tones serve dark themes
EARLIER, LATER = ("#0072B2", "#56B4E9"), ("#D55E00", "#E69F00")
FEATURE_COLOURS = {"centre": ("#000000", "#FFFFFF"), "f123": ("#0072B2", "#56B4E9"), "f124": ("#D55E00", "#E69F00")}
FEATURE_COLOURS |= {"f134": ("#009E73", "#A8E6A1"), "f234": ("#882255", "#B66DFF")}
SLAB = 0.12
"""Half thickness of the slab of points drawn in the section, as a fraction of the leg length."""
MOST_POINTS = 6_000
MARGIN = 6


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

    def pixels_per_metre(self) -> float:
        return self._zoom * (min(self.width(), self.height() - 2 * self.fontMetrics().height()) - 2 * MARGIN) / (2 * self.scene.half_size)

    def _origin(self) -> QPointF:
        return QPointF(self.width() / 2, self.height() / 2) + self._shift

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
            self._hover = f"E {e:.2f}  N {n:.2f}" if self._plan else f"{x:+.2f} m  H {h:.2f}"
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
        title = tr("Plan") if self._plan else tr("Section {azimuth}°").format(azimuth=f"{math.degrees(self.azimuth) % 360:.0f}")
        base = paper(self.palette())
        base.setAlpha(200)
        datum = metrics.elidedText(self.scene.datum, Qt.TextElideMode.ElideRight, self.width() - 2 * MARGIN - 22)
        wide = max(metrics.horizontalAdvance(text) for text in (title, datum, *self.scene.labels)) + 2 * MARGIN + 22
        painter.fillRect(QRectF(0, 0, wide, (4 if datum else 3) * line + MARGIN + 2), base)
        painter.setPen(ink)
        painter.drawText(QPointF(MARGIN, MARGIN + metrics.ascent()), title)
        for epoch in (0, 1):
            y = MARGIN + (epoch + 1.5) * line
            painter.setPen(QPen(colours[epoch], 2.0, Qt.PenStyle.SolidLine if epoch else Qt.PenStyle.DashLine))
            painter.drawLine(QPointF(MARGIN, y), QPointF(MARGIN + 18, y))
            painter.setPen(ink)
            painter.drawText(QPointF(MARGIN + 22, y + metrics.ascent() / 2 - 1), self.scene.labels[epoch])
        painter.drawText(QPointF(MARGIN, MARGIN + 3 * line + metrics.ascent()), datum)
        bar = _round_below(0.3 * self.width() / self.pixels_per_metre())
        bottom = self.height() - MARGIN
        text = f"{bar:g} m"
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


class SeriesView(QWidget):
    """Displacement of each feature since the unit's first epoch, with its 95 % band, beside the detection limit."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("view_series")
        self.setMinimumSize(200, 130)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.series: dict[str, Sequence[SeriesPoint]] = {}
        self.limit: float | None = None

    def sizeHint(self) -> QSize:
        """Room for axes and legend."""
        return QSize(420, 220)

    def show_series(self, series: Mapping[str, Sequence[SeriesPoint]], limit: float | None) -> None:
        """Draw the series by feature name; ``limit`` is the detection limit in metres."""
        self.series = {name: points for name, points in series.items() if points}
        self.limit = limit
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the plot."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), paper(self.palette()))
        ink = self.palette().color(QPalette.ColorRole.Text)
        painter.setPen(ink)
        if not any(len(points) > 1 for points in self.series.values()):
            text = tr("No displacement of this unit") if self.series else tr("Select a unit")
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, text)
            painter.end()
            return
        self._draw(painter, ink, length_format())
        painter.end()

    def _draw(self, painter: QPainter, ink: QColor, lengths: LengthFormat) -> None:
        metrics = QFontMetricsF(self.font())
        points = [point for series in self.series.values() for point in series]
        top = 1.08 * max([p.d_3d + Z_95 * p.sd for p in points] + [self.limit or 0.0])
        step = _round_below(top * lengths.factor / 4) / lengths.factor
        ticks = [k * step for k in range(int(top / step) + 1)]
        decimals = max(0, math.ceil(-math.log10(step * lengths.factor) - 1e-9))
        names = [f"{tick * lengths.factor:.{decimals}f}" for tick in ticks]
        left = max(metrics.horizontalAdvance(name) for name in names) + 2 * MARGIN
        legend = metrics.height() + 2 * MARGIN
        area = QRectF(
            left, legend + metrics.height(), self.width() - left - 3 * MARGIN, self.height() - legend - 2 * metrics.height() - 2 * MARGIN
        )
        moments = self._moments()
        first, last = min(moments.values()), max(moments.values())
        span = (last - first) or 1.0

        def place(epoch: str, value: float) -> QPointF:
            return QPointF(
                area.left() + area.width() * (moments[epoch] - first) / span, area.bottom() - area.height() * min(value, top) / top
            )

        grid = QColor(ink)
        grid.setAlpha(50)
        for tick, name in zip(ticks, names, strict=True):
            y = area.bottom() - area.height() * tick / top
            painter.setPen(QPen(grid, 1.0))
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y))
            painter.setPen(ink)
            painter.drawText(QPointF(left - MARGIN - metrics.horizontalAdvance(name), y + metrics.ascent() / 2 - 1), name)
        painter.drawText(QPointF(MARGIN, legend + metrics.ascent() - 2), tr("3D displacement ({unit})").format(unit=lengths.suffix))
        self._draw_epochs(painter, area, {epoch: place(epoch, 0).x() for epoch in moments}, metrics)
        if self.limit is not None:
            y = area.bottom() - area.height() * self.limit / top
            painter.setPen(QPen(QColor("#CC3311"), 1.5, Qt.PenStyle.DashLine))
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y))
        dark = is_dark(self.palette())
        for name, series in self.series.items():
            colour = QColor(FEATURE_COLOURS[name][dark])
            band = QColor(colour)
            band.setAlpha(28)
            high = [place(p.epoch, p.d_3d + Z_95 * p.sd) for p in series]
            low = [place(p.epoch, max(p.d_3d - Z_95 * p.sd, 0.0)) for p in series]
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(band)
            painter.drawPolygon(QPolygonF(high + low[::-1]))
            painter.setPen(QPen(colour, 2.5 if name == "centre" else 1.2))
            painter.drawPolyline(QPolygonF([place(p.epoch, p.d_3d) for p in series]))
            painter.setBrush(colour)
            for p in series:
                painter.drawEllipse(place(p.epoch, p.d_3d), 2.5, 2.5)
        self._draw_legend(painter, ink, metrics, dark)

    def _draw_legend(self, painter: QPainter, ink: QColor, metrics: QFontMetricsF, dark: bool) -> None:
        x, y = float(MARGIN), MARGIN + metrics.ascent()
        for name in self.series:
            painter.setPen(QPen(QColor(FEATURE_COLOURS[name][dark]), 2.5))
            painter.drawLine(QPointF(x, y - metrics.ascent() / 3), QPointF(x + 12, y - metrics.ascent() / 3))
            painter.setPen(ink)
            label = tr("centre") if name == "centre" else name
            painter.drawText(QPointF(x + 15, y), label)
            x += 15 + metrics.horizontalAdvance(label) + 8
        if self.limit is not None:
            painter.setPen(QPen(QColor("#CC3311"), 1.5, Qt.PenStyle.DashLine))
            painter.drawLine(QPointF(x, y - metrics.ascent() / 3), QPointF(x + 14, y - metrics.ascent() / 3))
            painter.setPen(ink)
            room = int(self.width() - x - 18 - MARGIN)
            painter.drawText(QPointF(x + 18, y), self.fontMetrics().elidedText(tr("detection limit"), Qt.TextElideMode.ElideRight, room))

    def _draw_epochs(self, painter: QPainter, area: QRectF, places: dict[str, float], metrics: QFontMetricsF) -> None:
        free = -1e9
        for epoch, x in places.items():
            painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + 4))
            width = metrics.horizontalAdvance(epoch)
            begin = min(max(x - width / 2, 2.0), self.width() - width - 2)
            if begin > free:
                painter.drawText(QPointF(begin, area.bottom() + 5 + metrics.ascent()), epoch)
                free = begin + width + 6

    def _moments(self) -> dict[str, float]:
        epochs: dict[str, datetime | None] = {point.epoch: point.time for series in self.series.values() for point in series}
        if any(time is None for time in epochs.values()):
            return {epoch: float(k) for k, epoch in enumerate(epochs)}
        return dict(sorted(((epoch, time.timestamp()) for epoch, time in epochs.items() if time is not None), key=lambda item: item[1]))


def _round_below(value: float) -> float:
    """Largest of 1, 2 or 5 times a power of ten not above a positive value."""
    power = 10.0 ** math.floor(math.log10(max(value, 1e-9)))
    return next(step * power for step in (5, 2, 1) if step * power <= value * (1 + 1e-9))
