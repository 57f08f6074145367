"""How the command talks: progress bar on a terminal, plain lines in a log, one JSON object a line for QGIS; exit codes; errors in
one sentence."""

from __future__ import annotations

import json
import signal
import sys
import time
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from types import FrameType
from typing import Any, TextIO

from ..core.errors import Cancelled, InputError, OutputError, TetratrackError

DONE, FAULT, BAD_INPUT, INTERRUPTED = 0, 1, 2, 130
PLAIN_SECONDS = 10.0
"""Plain progress lines are at least this far apart, unless a step is finished."""
JSON_SECONDS = 0.1


@dataclass
class Console:
    """Output of one subcommand.

    Attributes
    ----------
    quiet
        Nothing but errors and the result.
    log_file
        File that receives every line with its time, or None.
    json_progress
        JSON objects instead of text.
    """

    quiet: bool = False
    log_file: Path | None = None
    json_progress: bool = False
    _log: TextIO | None = field(default=None, init=False)
    _bar: Any = field(default=None, init=False)
    _task: Any = field(default=None, init=False)
    _said: str = field(default="", init=False)
    _last: float = field(default=0.0, init=False)

    def progress(self, fraction: float, message: str) -> None:
        """Show how far the run is."""
        now = time.monotonic()
        if self.json_progress:
            if now - self._last >= JSON_SECONDS or fraction >= 1:
                self._last = now
                self._json(event="progress", fraction=round(fraction, 4), message=message)
        elif self.quiet:
            return
        elif self._bar is not None:
            self._bar.update(self._task, completed=fraction, description=message)
        elif now - self._last >= PLAIN_SECONDS or fraction >= 1:
            self._last = now
            self._line(f"{100 * fraction:3.0f} % {message}")

    def info(self, message: str) -> None:
        """Tell something worth knowing."""
        self._message("info", message)

    def warning(self, message: str) -> None:
        """Tell something the user should look at."""
        self._message("warning", message)

    def result(self, outputs: dict[str, Any]) -> None:
        """State what the run produced."""
        if self.json_progress:
            self._json(event="result", outputs=outputs)
            return
        self._write_log("result " + json.dumps(outputs))
        table = outputs.pop("table", None)
        if table and not self.quiet:
            widths = {name: max(len(name), *(len(str(row[name])) for row in table)) for name in table[0]}
            for row in [{name: name for name in widths}, *table]:
                print("  ".join(str(row[name]).ljust(width) for name, width in widths.items()).rstrip())  # noqa: T201
        print(", ".join(f"{name} {_short(value)}" for name, value in outputs.items()))  # noqa: T201

    def error(self, message: str, remedy: str = "") -> None:
        """State in one sentence why the run ends."""
        if self.json_progress:
            self._json(event="error", message=message, remedy=remedy)
        else:
            print(f"error: {message}", file=sys.stderr)  # noqa: T201
        self._write_log(f"error {message}")

    @contextmanager
    def opened(self) -> Iterator[None]:
        """Open the log file and the progress bar for the time of a run.

        Raises
        ------
        OutputError
            The log file cannot be written.
        """
        if self.log_file is not None:
            try:
                self._log = self.log_file.open("a", encoding="utf-8")
            except OSError as error:
                raise OutputError(
                    f"cannot be written ({error.strerror})", source=self.log_file, remedy="Give --log-file another place."
                ) from error
        try:
            if not self.quiet and not self.json_progress and sys.stderr.isatty():
                with self._rich_bar():
                    yield
            else:
                yield
        finally:
            if self._log is not None:
                self._log.close()
                self._log = None

    @contextmanager
    def _rich_bar(self) -> Iterator[None]:
        from rich.console import Console as RichConsole
        from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeElapsedColumn

        columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeElapsedColumn())
        with Progress(*columns, console=RichConsole(stderr=True), transient=True) as bar:
            self._bar, self._task = bar, bar.add_task("starting", total=1.0)
            try:
                yield
            finally:
                self._bar = None

    def _message(self, level: str, message: str) -> None:
        if self.json_progress:
            self._json(event="log", level=level, message=message)
        elif not self.quiet:
            self._line(message if level == "info" else f"{level}: {message}")
            return
        self._write_log(f"{level} {message}")

    def _line(self, text: str) -> None:
        if self._bar is not None:
            self._bar.console.print(text, markup=False, highlight=False)
        else:
            print(text, file=sys.stderr)  # noqa: T201
        self._write_log(text)

    def _json(self, **event: Any) -> None:
        print(json.dumps(event, ensure_ascii=False), flush=True)  # noqa: T201

    def _write_log(self, text: str) -> None:
        if self._log is not None:
            self._log.write(f"{datetime.now(UTC).isoformat(timespec='seconds')} {text}\n")
            self._log.flush()


def execute(console: Console, step: Callable[[Console], dict[str, Any]]) -> int:
    """Run a step and return the exit code: 0 done, 2 bad input, 130 interrupted, 1 a fault of the program."""
    before = signal.signal(signal.SIGTERM, _interrupt)
    try:
        with console.opened():
            try:
                outputs = step(console)
            except InputError as error:
                console.error(str(error), error.remedy)
                return BAD_INPUT
            except Cancelled:
                console.error("cancelled; nothing was written")
                return INTERRUPTED
            except TetratrackError as error:
                console.error(str(error))
                return BAD_INPUT
            except KeyboardInterrupt:
                console.error("interrupted; nothing was written")
                return INTERRUPTED
            except MemoryError:
                console.error("out of memory. Use fewer --workers")
                return BAD_INPUT
            except Exception as error:
                console.error(f"fault in tetratrack, please report it with the lines above: {type(error).__name__}: {error}")
                traceback.print_exc()
                return FAULT
        console.result(outputs)
    except OutputError as error:
        console.error(str(error), error.remedy)
        return BAD_INPUT
    finally:
        signal.signal(signal.SIGTERM, before)
    return DONE


def _interrupt(number: int, frame: FrameType | None) -> None:
    """End on SIGTERM as on Ctrl-C, with temporary files removed."""
    raise KeyboardInterrupt


def _short(value: Any) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)
