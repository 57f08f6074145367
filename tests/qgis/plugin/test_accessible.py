"""The dock without a mouse and in other countries: Tab reaches everything in the order in which one reads; decimal commas; time zones."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from qgis.core import QgsProject
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QCoreApplication, QEvent, QLocale, QPoint, Qt
from qgis.PyQt.QtGui import QKeyEvent
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLineEdit,
    QMainWindow,
    QTableView,
    QToolButton,
    QWidget,
)
from synthetic_result import write_points, write_result
from tetratrack.algorithms.support.lengths import LengthFormat
from tetratrack.algorithms.support.translation import load_translator, tr
from tetratrack.plugin.review_dock import ReviewDock
from tetratrack.plugin.review_plots import UnitView

pytestmark = pytest.mark.qgis

USED = (QAbstractButton, QAbstractSpinBox, QComboBox, QLineEdit, QTableView, UnitView)


@pytest.fixture
def dock(qgis_app: object, tmp_path: Path) -> Iterator[ReviewDock]:
    window = QMainWindow()
    canvas = QgsMapCanvas(window)
    window.setCentralWidget(canvas)
    dock = ReviewDock(canvas, QgsProject.instance(), window)
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
    window.resize(1366, 900)
    window.show()
    units = write_result(tmp_path / "result.gpkg", 12)
    write_points(tmp_path / "result.gpkg", units)
    assert dock.open(tmp_path / "result.gpkg")
    QApplication.processEvents()
    yield dock
    dock.close()
    window.close()


def used(dock: ReviewDock) -> list[QWidget]:
    """What a reviewer acts on and sees at this moment, less what belongs to another widget or to Qt's window."""
    inside = dock.widget()
    found = [widget for kind in USED for widget in inside.findChildren(kind)]
    own = [widget for widget in found if not isinstance(widget.parentWidget(), (QComboBox, QAbstractSpinBox, QLineEdit, QTableView))]
    return [widget for widget in own if widget.isVisible() and widget.isEnabled() and not widget.objectName().startswith("qt_")]


def tab_order(dock: ReviewDock) -> list[QWidget]:
    """Widgets as Tab comes to them, from the first on."""
    start = dock.widget()
    order, widget = [], start.nextInFocusChain()
    while widget is not start and len(order) < 1000:
        if widget.isVisible() and widget.focusPolicy() & Qt.FocusPolicy.TabFocus and start.isAncestorOf(widget):
            order.append(widget)
        widget = widget.nextInFocusChain()
    return order


def test_tab_reaches_everything_and_everything_has_a_name(dock: ReviewDock) -> None:
    reached = tab_order(dock)
    assert len(reached) > 15
    missed = [widget for widget in used(dock) if widget not in reached and widget.focusProxy() not in reached]
    assert [(type(widget).__name__, widget.objectName(), widget.toolTip()) for widget in missed] == []
    nameless = [
        widget
        for widget in used(dock)
        if isinstance(widget, QToolButton | UnitView) and not (widget.accessibleName() or widget.text() or widget.toolTip())
    ]
    assert nameless == []


def test_the_order_is_the_one_in_which_one_reads(dock: ReviewDock) -> None:
    """From top to bottom: no part of the dock is entered before one that stands wholly above it and is of the same column."""
    order = [widget for widget in tab_order(dock) if widget in used(dock)]
    tops = [widget.mapTo(dock, QPoint(0, 0)).y() for widget in order]
    table, decisions = order.index(dock.table), [order.index(button) for button in dock.decisions.findChildren(QToolButton)]
    filters = [order.index(widget) for widget in order if dock.filters.isAncestorOf(widget)]
    assert max(filters) < table < min(decisions)
    assert tops[0] == min(tops)


def press(widget: QWidget, key: Qt.Key) -> None:
    QApplication.sendEvent(widget, QKeyEvent(QEvent.Type.KeyPress, int(key), Qt.KeyboardModifier.NoModifier))


def test_views_move_zoom_and_pick_by_keys(dock: ReviewDock) -> None:
    dock.store.step(1)
    dock.tabs.setCurrentIndex(0)
    view = dock.tabs.plan
    before = view.grab().toImage()
    for key in (Qt.Key.Key_Left, Qt.Key.Key_Plus):
        press(view, key)
        after = view.grab().toImage()
        assert after != before
        before = after
    press(view, Qt.Key.Key_Home)
    picked: list[object] = []
    dock.tabs.picked.connect(picked.append)
    press(view, Qt.Key.Key_Return)
    assert picked == [], "nothing is picked while nothing is corrected"
    dock.tabs.set_picking(0)
    for _ in range(12):
        press(view, Qt.Key.Key_Return)
        press(view, Qt.Key.Key_Up)
        if picked:
            break
    assert len(picked) == 1


@pytest.mark.parametrize("country", [QLocale.Language.German, QLocale.Language.French])
def test_decimal_commas_are_taken_and_lists_stay_numbers(dock: ReviewDock, country: QLocale.Language) -> None:
    before = QLocale()
    try:
        QLocale.setDefault(QLocale(country))
        dock.filters.threshold.setLocale(QLocale(country))
        dock.filters.threshold.lineEdit().selectAll()
        QTest.keyClicks(dock.filters.threshold.lineEdit(), "2,5")
        dock.filters.threshold.interpretText()
        assert dock.filters.threshold.value() == 2.5
        assert "," in dock.filters.threshold.text()
    finally:
        QLocale.setDefault(before)


@pytest.mark.skipif(not hasattr(time, "tzset"), reason="this system's time zone cannot be set for a process")
@pytest.mark.parametrize("zone", ["Asia/Seoul", "America/St_Johns", "UTC"])
def test_moments_are_the_same_in_every_time_zone(dock: ReviewDock, zone: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TZ", zone)
    time.tzset()
    try:
        dock.store.step(1)
        dock.decisions.reviewer.setText("A")
        dock.decide("accepted")
        dock.tabs.setCurrentWidget(dock.tabs.history)
        dock.tabs.show_unit()
        text = dock.tabs.history.toPlainText()
        now = time.gmtime()
        assert time.strftime("%Y-%m-%d", now) in text
        assert "UTC" in text
        assert dock.store.epochs[0].time.isoformat() == "2023-04-09T02:30:00+00:00"
    finally:
        monkeypatch.undo()
        os.environ.pop("TZ", None) if zone == os.environ.get("TZ") else None
        time.tzset()


def test_words_agree_with_numbers(qgis_app: object, repository: Path) -> None:
    assert [tr("%n lost", count) for count in (0, 1, 2)] == ["0 lost", "1 lost", "2 lost"]
    for language, expected in (("fr", ["0 perdu", "1 perdu", "2 perdus"]), ("es", ["0 perdidas", "1 perdida", "2 perdidas"])):
        translator = load_translator(repository / "i18n", language)
        if translator is None:
            pytest.skip("no .qm: run scripts/dev/translations.py build")
        QCoreApplication.installTranslator(translator)
        try:
            assert [tr("%n lost", count) for count in (0, 1, 2)] == expected
            assert "2" in tr("Units written to {name}: %n.", 2).format(name="alarms.csv")
        finally:
            QCoreApplication.removeTranslator(translator)


def test_a_standard_deviation_is_never_written_as_nothing(qgis_app: object) -> None:
    """Models in a tank are measured to tenths of a millimetre, and the project counts in metres."""
    lengths = LengthFormat(1.0, "m", 3)
    assert lengths.telling(0.005) == lengths
    assert lengths.telling(None) == lengths.telling(0.0) == lengths
    assert lengths.telling(0.0001).text(0.01784) == "0.0178 m"
    assert float(lengths.telling(0.000_02).number(0.000_02)) == pytest.approx(0.000_02)
    assert LengthFormat(1000.0, "mm", 1).telling(0.0001).decimals == 1


def test_lengths_in_the_dock_have_the_decimal_sign_of_the_map(dock: ReviewDock) -> None:
    before = QLocale()
    try:
        QLocale.setDefault(QLocale(QLocale.Language.French))
        dock.store.select([dock.store.shown(0).unit_id])
        dock.tabs.setCurrentIndex(2)
        row = dock.store.row(dock.store.current)
        written = f"{row.d_3d:.3f}".replace(".", ",")
        assert dock.model.text(row, "d_3d") == written
        page = dock.tabs.numbers.toPlainText()
        assert f"{written} ± {row.sd_3d:.3f} m".replace(".", ",") in page
        assert f"{row.rotation_deg:.2f}°".replace(".", ",") in page
        assert f"{row.d_3d / row.height:.3f} H".replace(".", ",") in page
        # another epoch than that of the table's worse share
        assert f"Seen in {dock.store.pair.epoch_to}" in page
        east = row.vector[0]
        assert f"{east:+.3f} ± {row.sd[0]:.3f} m".replace(".", ",") in page
    finally:
        QLocale.setDefault(before)
