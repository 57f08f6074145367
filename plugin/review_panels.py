"""Parts of the review dock that the reviewer acts on: comparison, filters, decisions, and the line that answers."""

from __future__ import annotations

import getpass
import html
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from qgis.core import QgsSettings
from qgis.gui import QgsCheckableComboBox, QgsFilterLineEdit
from qgis.PyQt.QtCore import QEventLoop, QSize, Qt, QUrl, pyqtSignal
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import (
    QApplication,
    QBoxLayout,
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QMenu,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ..algorithms.support.lengths import length_format
from ..algorithms.support.translation import tr
from ..core.common.errors import TetratrackError
from ..core.results.result_access import meanwhile
from ..core.results.schema import CLASSES
from .review_store import ReviewStore
from .review_text import DECISION_COLOURS, datum_label, decision_colour, kind_label

REVIEWER_SETTING = "tetratrack/reviewer"
SPACING = 3
"""Pixels between the parts of the dock."""
DRAW_MILLISECONDS = 20
"""Longest time for drawing at once while a file is read."""
MOST_METRES, STEP_METRES = 10.0, 0.01
"""Largest value and step of the least displacement shown."""


class YieldingLabel(QLabel):
    """Wrapped text whose later lines give way where the window is short; the tooltip then holds all of it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWordWrap(True)
        self.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)

    def hasHeightForWidth(self) -> bool:
        """No: layouts would take the height of all lines for the least there can be."""
        return False

    def sizeHint(self) -> QSize:
        """All lines, in the width there is."""
        return QSize(super().sizeHint().width(), max(self.heightForWidth(self.width()), self.fontMetrics().height()))

    def minimumSizeHint(self) -> QSize:
        """One line."""
        return QSize(0, self.fontMetrics().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Another width has other lines."""
        super().resizeEvent(event)
        if event.oldSize().width() != event.size().width():
            self.updateGeometry()
        self.setToolTip("" if self.height() >= self.sizeHint().height() else self.text())


class StatusLine:
    """What was done, or why it was not, in one label a page."""

    def __init__(self, *labels: QLabel) -> None:
        self._labels = labels
        self._said = ""
        self.busy = False
        """Something is being read or written, while the window draws itself."""

    def say(self, message: str, *, bad: bool = False, link: Path | None = None) -> None:
        """Show a message, a bad one in the colour of what is rejected, and a link that opens a file."""
        self._said = message
        for label in self._labels:
            # a label's own palette follows its style sheet
            colour = decision_colour("rejected", label.parentWidget().palette())
            label.setStyleSheet(f"color: {colour.name()};" if bad else "")
            if link is None:
                label.setTextFormat(Qt.TextFormat.PlainText)
                label.setText(message)
            else:
                label.setTextFormat(Qt.TextFormat.RichText)
                address = QUrl.fromLocalFile(str(link)).toString()
                label.setText(f'{html.escape(message)} <a href="{html.escape(address)}">{html.escape(tr("Open"))}</a>')

    def text(self) -> str:
        """What was said last."""
        return self._said

    def attempt(self, act: Callable[[], Any], *, quiet: bool = False) -> bool:
        """Do something that may fail for a reason the user can act on, and say the reason; whether it was done.

        Where that takes long, or another program holds the file, the window goes on drawing itself; it takes no input meanwhile.
        """
        try:
            with self.working(), meanwhile(draw):
                act()
        except TetratrackError as error:
            if not quiet:
                # what has no file before it begins a sentence
                text = str(error)
                self.say(text if error.source is not None else text[:1].upper() + text[1:], bad=True)
            return False
        return True

    @contextmanager
    def working(self) -> Iterator[None]:
        """While this lasts the dock begins nothing else, though the window draws itself."""
        before, self.busy = self.busy, True
        try:
            yield
        finally:
            self.busy = before


def draw() -> None:
    """Let the window draw itself."""
    QApplication.processEvents(QEventLoop.ProcessEventsFlag.ExcludeUserInputEvents, DRAW_MILLISECONDS)


class ComparisonChoice(QWidget):
    """Choice of the store's epoch pair and of the datum of its displacements."""

    def __init__(self, status: StatusLine, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._status = status
        self._store: ReviewStore | None = None
        self.pair = QComboBox(self)
        self.pair.setToolTip(tr("Epochs compared"))
        self.datum = QComboBox(self)
        self.datum.setToolTip(tr("Reference of the displacements"))
        row = _without_margins(QHBoxLayout(self))
        for box in (self.pair, self.datum):
            box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
            # two days and the arrow between them, in the narrowest dock
            box.setMinimumContentsLength(17 if box is self.pair else 14)
            box.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            row.addWidget(box)
        self.pair.activated.connect(self._choose_pair)
        self.datum.activated.connect(self._choose_datum)

    def show_store(self, store: ReviewStore) -> None:
        """Offer what a store can compare."""
        self._store = store
        self.pair.clear()
        for pair in store.pairs:
            self.pair.addItem(str(pair), pair)
        self.pair.setCurrentIndex(store.pairs.index(store.pair))
        self._fill_datums(store)

    def _fill_datums(self, store: ReviewStore) -> None:
        self.datum.clear()
        for datum in store.datums:
            self.datum.addItem(datum_label(datum), datum)
        self.datum.setCurrentIndex(self.datum.findData(store.datum))

    def _choose_pair(self, index: int) -> None:
        store = self._store
        if store is None:
            return

        def compare() -> None:
            store.set_pair(store.pairs[index])
            self._fill_datums(store)

        if not self._status.attempt(compare):
            self.pair.setCurrentIndex(store.pairs.index(store.pair))

    def _choose_datum(self, index: int) -> None:
        store = self._store
        if store is not None:
            self._status.attempt(lambda: store.set_datum(self.datum.itemData(index)))


class FilterPanel(QWidget):
    """Which units are shown.

    ``changed`` carries parts of the store's filter by their names; ``area_wanted`` the kind of area asked for: ``everywhere``, ``map``
    or ``polygon``.
    """

    changed = pyqtSignal(object)
    area_wanted = pyqtSignal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.kinds = QgsCheckableComboBox(self)
        self.kinds.setDefaultText(tr("All classes"))
        self.kinds.setToolTip(tr("Classes shown"))
        self.kinds.setMinimumWidth(90)
        for kind in (*CLASSES, "unseen"):
            self.kinds.addItemWithCheckState(kind_label(kind), Qt.CheckState.Unchecked, kind)
        self.threshold = QDoubleSpinBox(self)
        self.threshold.setPrefix("≥ ")
        self._lengths = length_format()
        self.show_lengths()
        self.threshold.setToolTip(tr("Least 3D displacement shown; lost, new and relocated units are always shown"))
        self.area = QToolButton(self)
        self.area.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
        self.area.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.area.setToolTip(tr("Area of the units shown"))
        self.area.setText(tr("Everywhere"))
        self.area.setMenu(self._area_menu())
        self.undecided = QCheckBox(tr("Undecided only"), self)
        self.on_map = QCheckBox(tr("On the map too"), self)
        self.on_map.setToolTip(tr("The map shows only the units that the list shows"))
        self.text = QgsFilterLineEdit(self)
        self.text.setPlaceholderText(tr("Unit…"))
        self.text.setShowSearchIcon(True)
        self._lay_out()
        self.kinds.checkedItemsChanged.connect(lambda items: self.changed.emit({"kinds": frozenset(self.kinds.checkedItemsData())}))
        self.threshold.valueChanged.connect(lambda value: self.changed.emit({"threshold": value / self._lengths.factor}))
        self.undecided.toggled.connect(lambda checked: self.changed.emit({"undecided": checked}))
        self.text.textChanged.connect(lambda text: self.changed.emit({"text": text.strip()}))

    def show_lengths(self) -> None:
        """State the least displacement in the project's unit of lengths."""
        metres, self._lengths = self.least(), length_format()
        self.threshold.blockSignals(True)
        self.threshold.setSuffix(f" {self._lengths.suffix}")
        self.threshold.setDecimals(self._lengths.decimals)
        self.threshold.setRange(0, MOST_METRES * self._lengths.factor)
        self.threshold.setSingleStep(STEP_METRES * self._lengths.factor)
        self.threshold.setValue(metres * self._lengths.factor)
        self.threshold.blockSignals(False)

    def least(self) -> float:
        """Least displacement shown, metres."""
        return self.threshold.value() / self._lengths.factor

    def clear(self) -> None:
        """Show all units again."""
        self.kinds.deselectAllOptions()
        self.threshold.setValue(0)
        self.undecided.setChecked(False)
        self.text.clear()
        self.area.setText(tr("Everywhere"))

    def _area_menu(self) -> QMenu:
        menu = QMenu(self.area)
        entries = (
            (tr("Everywhere"), "everywhere"),
            (tr("In the map window"), "map"),
            (tr("In the active layer's polygons"), "polygon"),
        )
        for text, kind in entries:
            menu.addAction(text).triggered.connect(lambda checked=False, kind=kind: self.area_wanted.emit(kind))
        return menu

    def _lay_out(self) -> None:
        rows = _without_margins(QVBoxLayout(self))
        first, second = QHBoxLayout(), QHBoxLayout()
        # what is typed has room beside short fields; words of other languages need the second row
        first.addWidget(self.kinds, 3)
        first.addWidget(self.text, 2)
        first.addWidget(self.threshold)
        second.addWidget(self.area)
        second.addWidget(self.undecided)
        second.addWidget(self.on_map)
        second.addStretch(1)
        rows.addLayout(first)
        rows.addLayout(second)


class DecisionPanel(QWidget):
    """Comment, reviewer, and a button for every act; ``command`` carries the act by the name the table's keys use."""

    command = pyqtSignal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        rows = _without_margins(QVBoxLayout(self))
        words, buttons = QHBoxLayout(), QHBoxLayout()
        buttons.setSpacing(2)
        for name, text, help_text in (
            ("accepted", tr("Accept"), tr("The displacement is right (A)")),
            ("rejected", tr("Reject"), tr("The displacement is wrong: it leaves statistics, maps and report (R)")),
            ("inspect", tr("Inspect"), tr("Inspect on site (I)")),
            ("confirm", tr("Confirm"), tr("Confirm another reviewer's decision (C)")),
            ("undo", tr("Undo"), tr("Take back your last decision (U)")),
        ):
            buttons.addWidget(self._button(name, text, help_text))
        self.comment = QLineEdit(self)
        self.comment.setPlaceholderText(tr("Comment, stored with the decision"))
        self.reviewer = QLineEdit(QgsSettings().value(REVIEWER_SETTING, "", type=str) or _login(), self)
        self.reviewer.setPlaceholderText(tr("Reviewer"))
        self.reviewer.setToolTip(tr("Your name or initials, stored with every decision"))
        self.reviewer.setMaximumWidth(130)
        self.reviewer.editingFinished.connect(lambda: QgsSettings().setValue(REVIEWER_SETTING, self.reviewer.text().strip()))
        words.addWidget(self.comment, 1)
        words.addWidget(self.reviewer)
        rows.addLayout(words)
        rows.addLayout(buttons)

    def _button(self, name: str, text: str, help_text: str) -> QToolButton:
        button = QToolButton(self)
        button.setObjectName(f"review_{name}")
        button.setText(text)
        if name in DECISION_COLOURS:
            button.setText(f"● {text}")
            button.setStyleSheet(f"color: {decision_colour(name, self.palette()).name()};")
        button.setToolTip(help_text)
        button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        button.clicked.connect(lambda checked=False: self.command.emit(name))
        return button


def _without_margins(layout: QBoxLayout) -> QBoxLayout:
    layout.setContentsMargins(0, 0, 0, 0)
    layout.setSpacing(SPACING)
    return layout


def _login() -> str:
    """The user's login name; empty where the system has none."""
    try:
        return getpass.getuser()
    except (OSError, KeyError):
        return ""
