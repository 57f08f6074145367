"""The engine as QGIS sees it: found, started, listened to, stopped.

The numeric libraries run in a process with a Python environment of their own, because a second numpy, PROJ or GDAL inside QGIS
breaks QGIS. This module needs Qt and the standard library only.
"""

from __future__ import annotations

import importlib.util
import json
import os
import signal
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from qgis.core import QgsApplication, QgsSettings
from qgis.PyQt.QtCore import QProcess, QProcessEnvironment

from .translation import tr

PLUGIN_FOLDER = Path(__file__).resolve().parents[1]
BOOTSTRAP = PLUGIN_FOLDER / "scripts" / "engine.py"
PYTHON_SETTING = "tetratrack/engine_python"
PYTHON_VARIABLE = "TETRATRACK_ENGINE_PYTHON"
ATTACHED = "--attached"
FOREIGN_PREFIXES = ("PYTHON", "PROJ_", "GDAL_", "OGR_", "VIRTUAL_ENV", "QT_PLUGIN_PATH", "__PYVENV_LAUNCHER__")
"""Variables QGIS sets for its own libraries; they would make the engine load QGIS's data files or modules."""
NEEDED_MODULES = ("numpy", "scipy", "open3d", "numba", "laspy", "pyproj", "geopandas", "pyogrio", "typer", "rich")
POLL_MILLISECONDS = 100
CANCEL_GRACE_MILLISECONDS = 1200
STDERR_LINES = 12
BAD_INPUT_EXIT = 2
CANCELLED_EXIT = 130


class EngineError(Exception):
    """The engine refused its input, ended unexpectedly or could not be started; the text is for the user."""


class EngineCancelled(Exception):
    """The user cancelled and the engine has ended."""


@dataclass(frozen=True)
class Engine:
    """A Python interpreter that can run the engine, and where it was found: ``setting``, ``managed`` or ``current``."""

    python: Path
    origin: str


def managed_environment() -> Path:
    """Folder of the environment that the plugin creates after asking, in the user's profile."""
    return Path(QgsApplication.qgisSettingsDirPath()) / "tetratrack" / "engine"


def environment_python(environment: Path) -> Path:
    """Interpreter inside a virtual environment."""
    return environment / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def interpreter_of_this_process() -> Path:
    """Console interpreter that belongs to the running Python; inside QGIS ``sys.executable`` may be QGIS itself."""
    name = "python.exe" if os.name == "nt" else f"bin/python{sys.version_info[0]}.{sys.version_info[1]}"
    beside = Path(sys.exec_prefix) / name
    return beside if beside.is_file() else Path(sys.executable)


def find_engine() -> Engine | None:
    """First interpreter of: environment variable, option, managed environment, checkout's ``.venv``, this interpreter.

    Looks at files only and starts nothing, so that it is quick enough for the toolbox.
    """
    chosen = os.environ.get(PYTHON_VARIABLE) or QgsSettings().value(PYTHON_SETTING, "", type=str)
    if chosen:
        # a choice that no longer exists is reported, not silently replaced by another environment
        return Engine(Path(chosen), "setting") if Path(chosen).is_file() else None
    for environment in (managed_environment(), PLUGIN_FOLDER / ".venv"):
        python = environment_python(environment)
        if python.is_file():
            return Engine(python, "managed")
    if all(importlib.util.find_spec(name) is not None for name in NEEDED_MODULES):
        return Engine(interpreter_of_this_process(), "current")
    return None


def missing_engine_message() -> str:
    """One sentence that says what to do when no engine is found."""
    return tr("The tetratrack engine is not installed: open Settings > Options > Tetratrack and create its environment or choose one.")


def engine_environment() -> QProcessEnvironment:
    """Environment of this process without what QGIS set for its own libraries."""
    inherited = QProcessEnvironment.systemEnvironment()
    clean = QProcessEnvironment()
    for name in inherited.keys():  # noqa: SIM118 - not a mapping
        if not name.upper().startswith(FOREIGN_PREFIXES):
            clean.insert(name, inherited.value(name))
    return clean


@dataclass(frozen=True)
class Listener:
    """Where the engine's messages go: progress 0 to 1 with a message, information, warning, and whether to stop."""

    progress: Callable[[float, str], None]
    info: Callable[[str], None]
    warning: Callable[[str], None]
    cancelled: Callable[[], bool]


def run_engine(arguments: list[str], listener: Listener, engine: Engine | None = None) -> dict[str, Any]:
    """Run one subcommand of the engine and return the outputs of its result event.

    Raises
    ------
    EngineError
        With a message for the user: no engine, bad input, or a crash of the engine.
    EngineCancelled
        When the listener asked to stop; the engine has ended.
    """
    engine = engine or find_engine()
    if engine is None:
        raise EngineError(missing_engine_message())
    return _EngineRun(listener).run(engine, [*arguments, "--json-progress"])


class _EngineRun:
    """One engine process: its output split into events."""

    def __init__(self, listener: Listener) -> None:
        self.listener = listener
        self.process = QProcess()
        self.rest = b""
        self.outputs: dict[str, Any] | None = None
        self.error = ""
        self.tail: list[str] = []

    def run(self, engine: Engine, arguments: list[str]) -> dict[str, Any]:
        process = self.process
        process.setProcessEnvironment(engine_environment())
        process.start(str(engine.python), ["-I", "-X", "utf8", str(BOOTSTRAP), ATTACHED, *arguments])
        if not process.waitForStarted(30_000):
            raise EngineError(
                tr("The engine could not be started with {python}: {reason}.").format(python=engine.python, reason=process.errorString())
            )
        while process.state() != QProcess.ProcessState.NotRunning:
            process.waitForReadyRead(POLL_MILLISECONDS)
            self._listen()
            if self.listener.cancelled():
                self._stop()
                raise EngineCancelled
        self._listen()
        code = process.exitCode()
        if code == CANCELLED_EXIT and process.exitStatus() == QProcess.ExitStatus.NormalExit:
            raise EngineCancelled
        if self.error:
            raise EngineError(self.error)
        if process.exitStatus() == QProcess.ExitStatus.CrashExit or code != 0:
            raise EngineError(self._crash_report(code))
        return self.outputs or {}

    def _listen(self) -> None:
        self.rest += bytes(self.process.readAllStandardOutput())
        *lines, self.rest = self.rest.split(b"\n")
        for line in lines:
            self._handle(line.decode("utf-8", "replace").strip())
        for line in bytes(self.process.readAllStandardError()).decode("utf-8", "replace").splitlines():
            if line.strip():
                self.tail = [*self.tail, line.rstrip()][-STDERR_LINES:]

    def _handle(self, line: str) -> None:
        if not line:
            return
        try:
            event = json.loads(line)
        except ValueError:
            event = None
        if not isinstance(event, dict):
            # a library that prints on its own account
            self.listener.info(line)
            return
        kind, message = event.get("event"), str(event.get("message", ""))
        if kind == "progress":
            self.listener.progress(float(event.get("fraction") or 0.0), message)
        elif kind == "log":
            (self.listener.warning if event.get("level") in ("warning", "error") else self.listener.info)(message)
        elif kind == "result":
            self.outputs = dict(event.get("outputs") or {})
        elif kind == "error":
            remedy = str(event.get("remedy") or "")
            self.error = message if not remedy or remedy in message else f"{message} {remedy}"

    def _stop(self) -> None:
        process = self.process
        process.write(b"cancel\n")
        process.closeWriteChannel()
        if process.waitForFinished(CANCEL_GRACE_MILLISECONDS):
            return
        if hasattr(os, "killpg"):
            # the engine made itself head of a group: its workers end with it
            try:
                os.killpg(int(process.processId()), signal.SIGKILL)
            except ProcessLookupError:
                self.tail.append("the engine ended by itself")
        process.kill()
        process.waitForFinished(500)

    def _crash_report(self, code: int) -> str:
        message = tr("The engine ended unexpectedly (exit code {code}); QGIS and your data are unharmed.").format(code=code)
        return "\n".join([message, *self.tail])
