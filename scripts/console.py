"""How the command talks: progress bar on a terminal, plain lines in a log, one JSON object a line for QGIS; exit codes; errors in
one sentence."""

from __future__ import annotations

import importlib.util
import json
import math
import os
import re
import signal
import sys
import time
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from types import FrameType
from typing import Any, TextIO

from ..core.common.errors import Cancelled, InputError, NoSolutionError, OutputError, TetratrackError
from ..core.common.garbage_collection import collect_seldom

DONE, FAULT, BAD_INPUT, INTERRUPTED = 0, 1, 2, 130
NOTHING = "nothing was written"
FINISHED = "files finished before are whole and stay"
"""What stays of a step that is ended before its time: of one that writes one file, and of one that writes several."""
PLAIN_SECONDS = 10.0
"""Plain progress lines are at least this far apart, unless a step is finished."""
JSON_SECONDS = 0.1
_STEERING = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")
"""Control characters but tab and the end of a line."""
NO_LOGS = (".toml", ".csv", ".gpkg", ".las", ".laz", ".geojson", ".shp")
"""Endings of inputs and results: a log is never appended to one."""
FOREIGN = ("PROJ_DATA", "PROJ_LIB", "GDAL_DATA", "GDAL_DRIVER_PATH")
"""Variables by which other programs place data of their PROJ and GDAL."""
LINEAR_ALGEBRA = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
"""By which libraries of linear algebra take the number of their threads, when they are loaded."""


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
    cancelled
        Ctrl-C, SIGTERM or the parent asked for the end. Mostly KeyboardInterrupt ends the step first; where a library swallowed
        that, the step hears it here at its next look.
    """

    quiet: bool = False
    log_file: Path | None = None
    json_progress: bool = False
    cancelled: bool = field(default=False, init=False)
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
            # its thread begins with what there is to show: until then workers may be copies of this process
            self._bar.start()
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
        self._write_log("result " + _as_json(outputs))
        document = outputs.pop("document", None)
        if document is not None:
            # nothing else on standard output, so that it can be sent into a file
            self._print(document, end="")
            return
        table = outputs.pop("table", None)
        if table and not self.quiet:
            widths = {name: max(len(name), *(len(str(row[name])) for row in table)) for name in table[0]}
            for row in [{name: name for name in widths}, *table]:
                self._print("  ".join(str(row[name]).ljust(width) for name, width in widths.items()).rstrip())
        self._print(", ".join(f"{name} {_short(value)}" for name, value in outputs.items()))

    def error(self, message: str, remedy: str = "", *, passing: bool = False) -> None:
        """State in one sentence why the run ends; ``passing``: the same input may succeed another time."""
        if self.json_progress:
            # nobody may be there any more to hear it
            with suppress(OutputError):
                self._json(event="error", message=message, remedy=remedy, passing=passing)
        else:
            self._print(f"error: {message}", errors=True)
        self._write_log(f"error {message}")

    @contextmanager
    def opened(self) -> Iterator[None]:
        """Open the log file and the progress bar for the time of a run.

        Raises
        ------
        OutputError
            The log file cannot be written.
        """
        if self.json_progress:
            _reconfigure(sys.stdout, encoding="utf-8")
        if self.log_file is not None:
            if self.log_file.suffix.lower() in NO_LOGS:
                raise OutputError("is no name for a log", source=self.log_file, remedy="Let it end in .log or .txt.")
            try:
                self._log = self.log_file.open("a", encoding="utf-8", errors="backslashreplace")
            except OSError as error:
                raise OutputError(
                    f"cannot be written ({error.strerror})", source=self.log_file, remedy="Give --log-file another place."
                ) from error
        try:
            if not self.quiet and not self.json_progress and sys.stderr is not None and sys.stderr.isatty():
                with self._rich_bar():
                    yield
            else:
                yield
        finally:
            if self._log is not None:
                with suppress(OSError):
                    self._log.close()
                self._log = None

    @contextmanager
    def _rich_bar(self) -> Iterator[None]:
        from rich.console import Console as RichConsole
        from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeElapsedColumn

        columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeElapsedColumn())
        bar = Progress(*columns, console=RichConsole(stderr=True), transient=True)
        self._bar, self._task = bar, bar.add_task("starting", total=1.0)
        try:
            yield
        finally:
            self._bar = None
            bar.stop()

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
            self._print(text, errors=True)
        self._write_log(text)

    def _json(self, **event: Any) -> None:
        unicode = (getattr(sys.stdout, "encoding", None) or "").lower().replace("-", "") == "utf8"
        self._print(_as_json(event, ensure_ascii=not unicode))

    @staticmethod
    def _print(text: str, *, errors: bool = False, end: str = "\n") -> None:
        """Print a line; letters that the stream's code page lacks, and signs that would steer a terminal, are written as their numbers.

        Raises
        ------
        OutputError
            Standard output goes to a full disk, or to nobody any more. Messages alone end nothing.
        """
        target: TextIO | None = sys.stderr if errors else sys.stdout
        if target is None:
            # closed by who started the command
            return
        encoding = target.encoding or "utf-8"
        text = _STEERING.sub(lambda sign: f"\\x{ord(sign[0]):02x}", text)
        try:
            print(text.encode(encoding, "backslashreplace").decode(encoding), file=target, end=end, flush=True)
        except OSError as error:
            _give_up(target)
            if not errors:
                raise OutputError(
                    f"cannot be written ({error.strerror or error})", source="standard output", remedy="Send it to another place."
                ) from error

    def _write_log(self, text: str) -> None:
        if self._log is None:
            return
        # a full disk must not end a run that could be finished
        with suppress(OSError):
            self._log.write(f"{datetime.now(UTC).isoformat(timespec='seconds')} {text}\n")
            self._log.flush()


def _give_up(stream: TextIO) -> None:
    """Let what is still to be written to a stream go nowhere, so that the interpreter does not fail on it when it ends."""
    with suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)


def print_document(text: str) -> int:
    """Print a text by itself and return the exit code."""
    console = Console()
    try:
        console.result({"document": text})
    except OutputError as error:
        console.error(str(error), error.remedy)
        return BAD_INPUT
    return DONE


def prepare_process() -> None:
    """Make the process independent of its surroundings: letters that a code page lacks are replaced, foreign data of PROJ and GDAL left,
    and garbage is collected seldom.

    Other programs (a database, another GIS) set PROJ_DATA and GDAL_DATA for all; their versions do not fit the libraries here, which
    bring their own. Matrices are solved by one thread, as in the worker processes, unless the user says otherwise: results then do not
    depend on the number of cores in their last digits, and threads that wait for each other do not take the time of a busy machine.
    """
    collect_seldom()
    for name in LINEAR_ALGEBRA:
        os.environ.setdefault(name, "1")
    for stream in (sys.stdout, sys.stderr):
        _reconfigure(stream, errors="replace")
    pyproj = importlib.util.find_spec("pyproj")
    if pyproj is not None and any((Path(folder) / "proj_dir").is_dir() for folder in pyproj.submodule_search_locations or ()):
        for name in FOREIGN:
            os.environ.pop(name, None)


def _reconfigure(stream: Any, **how: str) -> None:
    """Change how a stream writes, where it is one that can."""
    if hasattr(stream, "reconfigure"):
        stream.reconfigure(**how)


def execute(console: Console, step: Callable[[Console], dict[str, Any]], left: str = NOTHING) -> int:
    """Run a step and return the exit code: 0 done, 2 bad input, 130 interrupted, 1 a fault of the program.

    ``left`` says what stays of a step that is ended before its time.
    """
    before = _interrupts_go_to(console)
    try:
        with console.opened():
            try:
                outputs = step(console)
            except Cancelled:
                console.error(f"cancelled; {left}")
                return INTERRUPTED
            except TetratrackError as error:
                console.error(str(error), error.remedy, passing=not isinstance(error, InputError | NoSolutionError))
                return BAD_INPUT
            except KeyboardInterrupt:
                console.error(f"interrupted; {left}")
                return INTERRUPTED
            except MemoryError:
                console.error("out of memory. Use fewer --workers", passing=True)
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
        for number, handler in before.items():
            signal.signal(number, handler)
    return DONE


def _interrupts_go_to(console: Console) -> dict[signal.Signals, Any]:
    """End on SIGTERM as on Ctrl-C, with temporary files removed; the handlers of before.

    Who starts a command with SIGINT ignored (a script in the background) does not want Ctrl-C to reach it.
    """

    def interrupt(number: int, frame: FrameType | None) -> None:
        console.cancelled = True
        raise KeyboardInterrupt

    heard = [number for number in (signal.SIGTERM, signal.SIGINT) if signal.getsignal(number) not in (signal.SIG_IGN, None)]
    return {number: signal.signal(number, interrupt) for number in heard}


def _as_json(values: dict[str, Any], **how: bool) -> str:
    """JSON, which knows no nan and no infinity: null stands for them."""
    return json.dumps(_finite(values), allow_nan=False, **how)  # type: ignore[arg-type]


def _finite(value: Any) -> Any:
    if isinstance(value, float) and not math.isfinite(value):
        return None
    if isinstance(value, dict):
        return {name: _finite(part) for name, part in value.items()}
    return [_finite(part) for part in value] if isinstance(value, list | tuple) else value


def _short(value: Any) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)
