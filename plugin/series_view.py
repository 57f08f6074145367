"""The displacement of a unit over time, drawn with QPainter alone, in the colours of the running theme."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from datetime import datetime

from qgis.PyQt.QtCore import QPointF, QRectF, QSize, Qt
from qgis.PyQt.QtGui import QColor, QFontMetricsF, QPainter, QPaintEvent, QPalette, QPen, QPolygonF
from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from ..algorithms.support.lengths import LengthFormat, decimal, length_format, round_below
from ..algorithms.support.translation import tr
from ..core.results.unit_rows import Z_95, SeriesPoint
from .review_plots import MARGIN
from .review_text import is_dark, paper

FEATURE_COLOURS = {"centre": ("#000000", "#FFFFFF"), "f123": ("#0072B2", "#56B4E9"), "f124": ("#D55E00", "#E69F00")}
FEATURE_COLOURS |= {"f134": ("#009E73", "#A8E6A1"), "f234": ("#882255", "#B66DFF")}


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
        step = round_below(top * lengths.factor / 4) / lengths.factor
        ticks = [k * step for k in range(int(top / step) + 1)]
        decimals = max(0, math.ceil(-math.log10(step * lengths.factor) - 1e-9))
        names = [decimal(tick * lengths.factor, decimals) for tick in ticks]
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
        painter.drawText(QPointF(MARGIN, legend + metrics.ascent() - 2), self._caption(lengths))
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

    def _caption(self, lengths: LengthFormat) -> str:
        """What is drawn, since when, and how sure it is, as far as there is room."""
        words = tr("3D displacement since {epoch} ({unit}), bands of 95 %")
        first = min(self._moments().items(), key=lambda moment: moment[1])[0]
        text = words.format(epoch=first, unit=lengths.suffix)
        return self.fontMetrics().elidedText(text, Qt.TextElideMode.ElideRight, self.width() - 2 * MARGIN)

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
