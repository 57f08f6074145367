"""What scripts inside a real QGIS window share: waiting, finding what the user sees, clicking it, pictures, and the answer to the test.

The environment names the folder to answer in (TETRATRACK_WINDOW); the answer is ``answer.json``, pictures lie beside it.
"""

from __future__ import annotations

import json
import os
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

from qgis.core import Qgis, QgsApplication
from qgis.PyQt.QtCore import QEventLoop, QPoint, Qt, QTimer
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QMessageBox, QWidget
from qgis.utils import plugins

FOLDER = Path(os.environ["TETRATRACK_WINDOW"])
said: list[str] = []
"""Python errors that QGIS caught: a user sees them as red bars."""


def wait(milliseconds: int) -> None:
    """Let QGIS work."""
    loop = QEventLoop()
    QTimer.singleShot(milliseconds, loop.quit)
    loop.exec()


def until(condition: Callable[[], Any], seconds: float, what: str) -> Any:
    """Wait until something holds, and return it."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        wait(100)
    raise TimeoutError(f"{what}: not within {seconds} s")


def window_of(kind: type, title: str = "") -> QWidget | None:
    """A visible window of a class, with some words in its title."""
    return next((w for w in QApplication.topLevelWidgets() if isinstance(w, kind) and w.isVisible() and title in w.windowTitle()), None)


def click(widget: QWidget, at: QPoint | None = None) -> None:
    """Left click in the middle of a widget, or at a place in it."""
    QTest.mouseClick(widget, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, at or widget.rect().center())


def action(text: str) -> Any:
    """Action of the plugin's toolbar by its text."""
    found = [a for a in plugin().actions if a.text() == text]
    return found[0]


def plugin() -> Any:
    """The running plugin."""
    return plugins["tetratrack"]


def picture(widget: QWidget, name: str) -> None:
    """Keep a picture of a widget."""
    QApplication.processEvents()
    widget.grab().save(str(FOLDER / f"{name}.png"))


def press_in_message_box(button: QMessageBox.StandardButton, soon: int = 300) -> None:
    """Press a button of the message box that the next act opens."""

    def press() -> None:
        box = QApplication.activeModalWidget()
        if isinstance(box, QMessageBox):
            click(box.button(button))
        else:
            QTimer.singleShot(100, press)

    QTimer.singleShot(soon, press)


def guarded(act: Callable[[], None]) -> Callable[[], None]:
    """An act for a timer: its failure ends QGIS with an answer; otherwise QGIS shows a message box and waits."""

    def run_it() -> None:
        try:
            act()
        except BaseException:
            fail()

    return run_it


def fail() -> None:
    """Answer with what went wrong, and what is on the screen."""
    for number, widget in enumerate(w for w in QApplication.topLevelWidgets() if w.isVisible()):
        picture(widget, f"failed{number}")
    windows = [f"{type(w).__name__} {w.windowTitle()}" for w in QApplication.topLevelWidgets() if w.isVisible()]
    finish({"failed": traceback.format_exc(), "windows": windows})


def finish(answer: dict[str, Any]) -> None:
    """Answer, and leave QGIS; closing would ask about the project."""
    answer["python_errors"] = said
    (FOLDER / "answer.json").write_text(json.dumps(answer, default=str), encoding="utf-8")
    os._exit(0)


def run(script: Callable[[], dict[str, Any]]) -> None:
    """Run a script once the window stands, write its answer and leave QGIS."""

    def keep_errors(message: str, tag: str, level: Any) -> None:
        if "Traceback" in message:
            said.append(message)

    QgsApplication.messageLog().messageReceived[str, str, Qgis.MessageLevel].connect(keep_errors)
    QTimer.singleShot(1500, guarded(lambda: finish(script())))
