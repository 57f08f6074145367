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

from qgis.core import QgsSettings
from qgis.PyQt.QtCore import QProcess, QProcessEnvironment

from .environment import OUTDATED, PLUGIN_FOLDER, PLUGIN_VERSION, environment_python, fault_message, fault_of, managed_environment
from .translation import tr

BOOTSTRAP = PLUGIN_FOLDER / "scripts" / "engine.py"
PYTHON_SETTING = "tetratrack/engine_python"
PYTHON_VARIABLE = "TETRATRACK_ENGINE_PYTHON"
ATTACHED = "--attached"
OF_PLUGIN = "--of-plugin"
"""Before the version of the plugin, which the engine holds against its own."""
FOREIGN_PREFIXES = ("PYTHON", "PROJ_", "GDAL_", "OGR_", "VIRTUAL_ENV", "QT_PLUGIN_PATH", "__PYVENV_LAUNCHER__")
"""Variables QGIS sets for its own libraries; they would make the engine load QGIS's data files or modules."""
NEEDED_MODULES = ("numpy", "scipy", "open3d", "numba", "laspy", "pyproj", "geopandas", "pyogrio", "typer", "rich")
LINK_SCHEME = "tetratrack"
"""Scheme of links in messages that the plugin follows itself."""
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
    """A Python interpreter that can run the engine.

    Attributes
    ----------
    python
        The interpreter.
    origin
        Where it was found: ``setting``, ``managed``, ``checkout`` or ``current``.
    fault
        What is wrong with the plugin's own environment, as :func:`..environment.fault_of` names it; empty if nothing is.
    """

    python: Path
    origin: str
    fault: str = ""


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
    environment = managed_environment()
    if environment.is_dir():
        return Engine(environment_python(environment), "managed", fault_of(environment))
    checkout = environment_python(PLUGIN_FOLDER / ".venv")
    if checkout.is_file():
        return Engine(checkout, "checkout")
    if all(importlib.util.find_spec(name) is not None for name in NEEDED_MODULES):
        return Engine(interpreter_of_this_process(), "current")
    return None


def missing_engine_message() -> str:
    """One sentence that says what to do when no engine is found."""
    return tr("The tetratrack engine is not installed: open Settings > Options > Tetratrack and create its environment or choose one.")


def missing_engine_links() -> str:
    """The same for windows that show HTML, with a link to the page of the options."""
    link = f'<a href="{LINK_SCHEME}:options">{tr("Create or choose the engine…")}</a>'
    return f"{missing_engine_message()}<br>{link}"


def fault_links(fault: str) -> str:
    """What is wrong with the environment, for windows that show HTML, with a link that mends it."""
    link = f'<a href="{LINK_SCHEME}:mend">{tr("Make the environment again…")}</a>'
    return f"{fault_message(fault)}<br>{link}"


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
        With a message for the user: no engine, an engine of another version, bad input, or a crash of the engine.
    EngineCancelled
        When the listener asked to stop; the engine has ended.
    """
    engine = engine or find_engine()
    if engine is None:
        raise EngineError(missing_engine_message())
    if engine.fault == OUTDATED:
        # windows ask before the run; where there are none, other libraries are better than no result
        listener.warning(fault_message(engine.fault))
    elif engine.fault:
        raise EngineError(fault_message(engine.fault))
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
        process.start(str(engine.python), ["-I", "-X", "utf8", str(BOOTSTRAP), ATTACHED, OF_PLUGIN, PLUGIN_VERSION, *arguments])
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
        for said in bytes(self.process.readAllStandardError()).decode("utf-8", "replace").splitlines():
            if said.strip():
                self.tail = [*self.tail, said.rstrip()][-STDERR_LINES:]

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
        elif kind == "hello":
            self._check_version(str(event.get("version", "")))
        elif kind == "result":
            self.outputs = dict(event.get("outputs") or {})
        elif kind == "error":
            remedy = str(event.get("remedy") or "")
            self.error = message if not remedy or remedy in message else f"{message} {remedy}"

    def _check_version(self, version: str) -> None:
        """Refuse an engine of another version than the plugin's: the files were exchanged while QGIS ran."""
        if version != PLUGIN_VERSION:
            self.error = tr("QGIS runs version {plugin} of the plugin, but its files are of version {engine}: restart QGIS.").format(
                plugin=PLUGIN_VERSION, engine=version
            )
            self.process.kill()

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
