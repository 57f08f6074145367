"""Nothing that the user reads is cut off: every shipped language, in a window of 1366 × 768."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from qgis.core import QgsApplication, QgsProject
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QCoreApplication, Qt, QTranslator
from qgis.PyQt.QtGui import QFont, QFontMetrics
from qgis.PyQt.QtWidgets import (
    QAbstractButton,
    QApplication,
    QComboBox,
    QGroupBox,
    QHeaderView,
    QLabel,
    QMainWindow,
    QPushButton,
    QStyle,
    QStyleOptionComboBox,
    QTabBar,
    QToolButton,
    QWidget,
)
from synthetic_result import write_points, write_result
from tetratrack.algorithms.support.translation import LANGUAGES, load_translator
from tetratrack.plugin.epoch_rows import EpochRow
from tetratrack.plugin.epoch_table import EpochTable
from tetratrack.plugin.options import TetratrackOptionsPage
from tetratrack.plugin.review_dock import ReviewDock

pytestmark = pytest.mark.qgis

WIDTH, HEIGHT = 1366, 768


@pytest.fixture(scope="module")
def result(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("fits") / "north_breakwater.gpkg"
    write_points(path, write_result(path, 12))
    return path


@pytest.fixture(params=("en", *LANGUAGES))
def language(request: pytest.FixtureRequest, repository: Path) -> Iterator[str]:
    """The interface's language; skipped where its translation is not built."""
    translator: QTranslator | None = None
    if request.param != "en":
        translator = load_translator(repository / "i18n", request.param)
        if translator is None:
            pytest.skip("no .qm: run scripts/dev/translations.py build")
        QCoreApplication.installTranslator(translator)
    yield request.param
    if translator is not None:
        QCoreApplication.removeTranslator(translator)


@pytest.fixture
def window(qgis_app: QgsApplication, language: str) -> Iterator[QMainWindow]:
    window = QMainWindow()
    canvas = QgsMapCanvas(window)
    window.setCentralWidget(canvas)
    window.resize(WIDTH, HEIGHT)
    window.show()
    yield window
    window.close()
    window.deleteLater()
    QgsProject.instance().clear()


def cut(root: QWidget) -> list[str]:
    """Texts that have less room than they take."""
    QApplication.processEvents()
    found = []
    for widget in root.findChildren(QWidget):
        if not widget.isVisible():
            continue
        missing = lacks(widget)
        if missing > 0:
            found.append(f"{type(widget).__name__} {widget.objectName()} {text_of(widget)!r}: {missing} px")
    return found


def text_of(widget: QWidget) -> str:
    if isinstance(widget, QComboBox):
        return widget.currentText()
    if isinstance(widget, QGroupBox):
        return widget.title()
    return widget.text() if hasattr(widget, "text") else ""


def lacks(widget: QWidget) -> int:
    """Pixels that a widget's text lacks across, or down where it is broken into lines."""
    if isinstance(widget, QTabBar):
        metrics, pages = QFontMetrics(widget.font()), range(widget.count())
        inside = max((metrics.horizontalAdvance(widget.tabText(page)) - widget.tabRect(page).width() for page in pages), default=0)
        return max(inside, widget.sizeHint().width() - widget.width())
    if isinstance(widget, QHeaderView):
        titles = [
            str(widget.model().headerData(place, widget.orientation(), Qt.ItemDataRole.DisplayRole)) for place in range(widget.count())
        ]
        taken = [QFontMetrics(widget.font()).horizontalAdvance(title) for title in titles]
        return max((needs - widget.sectionSize(place) for place, needs in enumerate(taken)), default=0)
    if isinstance(widget, QComboBox):
        option = QStyleOptionComboBox()
        option.initFrom(widget)
        option.rect = widget.rect()
        field = widget.style().subControlRect(QStyle.ComplexControl.CC_ComboBox, option, QStyle.SubControl.SC_ComboBoxEditField, widget)
        return QFontMetrics(widget.font()).horizontalAdvance(widget.currentText()) - field.width()
    if isinstance(widget, QLabel):
        if not widget.text() or (widget.pixmap() is not None and not widget.pixmap().isNull()):
            return 0
        if widget.wordWrap():
            return widget.heightForWidth(widget.width()) - widget.height()
        return widget.sizeHint().width() - widget.width()
    if isinstance(widget, QToolButton) and (not widget.text() or widget.toolButtonStyle() == Qt.ToolButtonStyle.ToolButtonIconOnly):
        return 0
    if isinstance(widget, QAbstractButton) and widget.text():
        return widget.sizeHint().width() - widget.width()
    if isinstance(widget, QGroupBox) and widget.title():
        return QFontMetrics(widget.font()).horizontalAdvance(widget.title()) - widget.width()
    return 0


def test_first_page_of_the_dock(window: QMainWindow) -> None:
    dock = ReviewDock(window.centralWidget(), QgsProject.instance(), window)
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
    assert cut(dock.widget()) == []
    assert dock.minimumSizeHint().height() <= HEIGHT
    dock.close()


def test_review(window: QMainWindow, result: Path) -> None:
    dock = ReviewDock(window.centralWidget(), QgsProject.instance(), window)
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
    assert dock.open(result)
    dock.decisions.reviewer.setText("A. Meyer")
    dock.store.step(1)
    dock.decide("accepted")
    found = []
    for page in range(dock.tabs.count()):
        dock.tabs.setCurrentIndex(page)
        found += cut(dock.widget())
    assert found == []
    # the map keeps room beside it
    assert dock.width() < 0.62 * WIDTH
    dock.close()


def test_table_of_epochs(window: QMainWindow) -> None:
    table = EpochTable(window)
    window.setCentralWidget(table)
    assert cut(table) == []
    table.show_rows([EpochRow("2025-03-14"), EpochRow("1")])
    assert cut(table) == []


def test_options_page(window: QMainWindow) -> None:
    page = TetratrackOptionsPage(window)
    window.setCentralWidget(page)
    assert cut(page) == []


def test_the_check_finds_what_is_cut(qgis_app: QgsApplication) -> None:
    root = QWidget()
    label, button, box = QLabel("a text that is long", root), QPushButton("a text that is long", root), QComboBox(root)
    box.addItem("a text that is long")
    for row, widget in enumerate((label, button, box)):
        widget.setGeometry(0, 40 * row, 40, 30)
    root.show()
    assert [line.split()[0] for line in cut(root)] == ["QLabel", "QPushButton", "QComboBox"]
    for widget in (label, button, box):
        widget.resize(400, 30)
    assert cut(root) == []
    root.close()


def test_a_short_window_leaves_the_views_their_room(window: QMainWindow, result: Path) -> None:
    """A screen of 1920 × 1080 at 150 %: QGIS's toolbars leave the dock some 500 pixels; what gives way is told by the tooltip."""
    dock = ReviewDock(window.centralWidget(), QgsProject.instance(), window)
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
    assert dock.open(result)
    dock.store.step(1)
    # words of some languages need one line alone
    dock._counts.setText("160 of 160 units shown " * 8)
    QApplication.processEvents()
    assert dock._counts.height() >= dock._counts.sizeHint().height() > 1.5 * dock.fontMetrics().height()
    assert dock._counts.toolTip() == ""
    window.resize(1280, dock.minimumSizeHint().height())
    window.resizeDocks([dock], [dock.minimumSizeHint().width()], Qt.Orientation.Horizontal)
    QApplication.processEvents()
    assert dock.tabs.height() >= dock.tabs.minimumHeight()
    assert dock.tabs.geometry().bottom() < dock._splitter.height()
    assert dock._counts.toolTip() == dock._counts.text()
    assert dock.filters.text.width() > 60
    dock.close()


def test_large_letters_leave_room_for_the_views(window: QMainWindow, result: Path) -> None:
    """Letters of 13 points, as on a screen whose text is enlarged."""
    before = QApplication.font()
    try:
        large = QFont(before)
        large.setPointSize(13)
        QApplication.setFont(large)
        dock = ReviewDock(window.centralWidget(), QgsProject.instance(), window)
        window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
        assert dock.open(result)
        dock.store.step(1)
        QApplication.processEvents()
        views = dock.tabs.widget(0)
        assert views.height() >= views.minimumSizeHint().height()
        for view in (dock.tabs.plan, dock.tabs.section):
            assert view.height() >= view.minimumHeight()
            # the drawing makes room for its names where it has any, and leaves its datum out where it has none
            legend, side = view._legend_size(), view._side()
            free = view.width() - side - 12
            assert view._origin().x() == pytest.approx(view.width() / 2 + min(free, legend.width()) / 2)
            assert bool(view._datum()) == (view.height() >= 9 * view.fontMetrics().height())
        dock.close()
        table = EpochTable(window)
        window.setCentralWidget(table)
        QApplication.processEvents()
        table.show_rows([EpochRow("2025-03-14", time="2025-03-14T02:30:00Z")])
        assert table.table.columnWidth(1) >= table.fontMetrics().horizontalAdvance("2025-03-14 02:30") + 60
    finally:
        QApplication.setFont(before)
