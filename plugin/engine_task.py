"""One run of the engine in the background of QGIS, seen and cancelled in its task manager."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from qgis.core import QgsTask

from ..algorithms.support.engine import EngineCancelled, EngineError, Listener, run_engine
from ..algorithms.support.translation import tr


class EngineTask(QgsTask):
    """One engine run in the background; ``done`` is called in the main thread with its outputs or a message."""

    def __init__(self, title: str, arguments: list[str], done: Callable[[dict[str, Any] | None, str], None]) -> None:
        super().__init__(title, QgsTask.Flag.CanCancel)
        self._arguments, self._done = arguments, done
        self._outputs: dict[str, Any] | None = None
        self._message = ""

    def run(self) -> bool:
        """Run in a worker thread."""

        def ignore(message: str) -> None:
            """The dock shows the outcome only; the log is in the run record."""

        listener = Listener(lambda fraction, message: self.setProgress(100 * fraction), ignore, ignore, self.isCanceled)
        try:
            self._outputs = run_engine(self._arguments, listener)
        except EngineCancelled:
            self._message = tr("Cancelled.")
        except EngineError as error:
            self._message = str(error)
        return self._outputs is not None

    def finished(self, result: bool) -> None:
        """Report in the main thread."""
        self._done(self._outputs, self._message)
