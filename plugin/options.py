"""Options page: which engine is used, and its managed environment, created only after asking."""

from __future__ import annotations

import shutil
import sys
import tempfile
from pathlib import Path
from typing import Any

from qgis.core import Qgis, QgsApplication, QgsSettings, QgsTask
from qgis.gui import QgsFileWidget, QgsOptionsPageWidget, QgsOptionsWidgetFactory
from qgis.PyQt.QtCore import QProcess
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QFormLayout, QGroupBox, QLabel, QMessageBox, QPushButton, QVBoxLayout, QWidget
from qgis.utils import iface

from .engine import (
    PLUGIN_FOLDER,
    PYTHON_SETTING,
    engine_environment,
    environment_python,
    find_engine,
    interpreter_of_this_process,
    managed_environment,
    missing_engine_message,
)
from .translation import tr

OLDEST_PYTHON = (3, 11)
PYTHON_NAMES = ("python3.13", "python3.12", "python3.11")
ENVIRONMENT_SIZE = "1 GB"
POLL_MILLISECONDS = 200


def base_python() -> Path | None:
    """Interpreter from which the environment can be made: QGIS's own if it is new enough, otherwise one on the path."""
    if sys.version_info[:2] >= OLDEST_PYTHON:
        return interpreter_of_this_process()
    found = [shutil.which(name) for name in PYTHON_NAMES]
    return next((Path(path) for path in found if path), None)


class CreateEnvironment(QgsTask):
    """Creates the managed environment in the background: a virtual environment, then the engine's libraries."""

    def __init__(self, python: Path, environment: Path) -> None:
        super().__init__(tr("Creating the tetratrack engine"), QgsTask.Flag.CanCancel)
        self.python, self.environment = python, environment
        self.problem = ""

    def run(self) -> bool:
        self.environment.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix="tetratrack-") as scratch:
            # pip builds inside the folder it installs: a copy keeps the plugin's own folder clean
            source = Path(scratch) / "tetratrack"
            shutil.copytree(
                PLUGIN_FOLDER, source, ignore=shutil.ignore_patterns(".*", "__pycache__", "tests", "docs", "*.egg-info", "build")
            )
            steps = (
                (self.python, ["-m", "venv", "--clear", str(self.environment)]),
                (environment_python(self.environment), ["-m", "pip", "install", "--disable-pip-version-check", str(source)]),
            )
            for number, (program, arguments) in enumerate(steps):
                self.setProgress(5 + 40 * number)
                if not self._run(program, arguments):
                    shutil.rmtree(self.environment, ignore_errors=True)
                    return False
        return True

    def finished(self, result: bool) -> None:
        if iface is None or self.isCanceled():
            return
        if result:
            iface.messageBar().pushSuccess("Tetratrack", tr("The engine is ready."))
        else:
            iface.messageBar().pushMessage("Tetratrack", self.problem, Qgis.MessageLevel.Critical, 0)

    def _run(self, program: Path, arguments: list[str]) -> bool:
        process = QProcess()
        process.setProcessEnvironment(engine_environment())
        process.setProcessChannelMode(QProcess.ProcessChannelMode.MergedChannels)
        process.start(str(program), arguments)
        output = b""
        if not process.waitForStarted(30_000):
            self.problem = tr("The engine could not be started with {python}: {reason}.").format(
                python=program, reason=process.errorString()
            )
            return False
        while process.state() != QProcess.ProcessState.NotRunning:
            process.waitForReadyRead(POLL_MILLISECONDS)
            output += bytes(process.readAll())
            if self.isCanceled():
                process.kill()
                process.waitForFinished(2000)
                return False
        output += bytes(process.readAll())
        if process.exitCode() != 0:
            last = output.decode("utf-8", "replace").strip().splitlines()[-3:]
            self.problem = tr("The engine's environment could not be created: {reason}").format(reason=" ".join(last))
            return False
        return True


class TetratrackOptionsFactory(QgsOptionsWidgetFactory):
    """Adds the page to Settings > Options."""

    def __init__(self) -> None:
        super().__init__("Tetratrack", QIcon(str(PLUGIN_FOLDER / "plugin" / "icons" / "tetratrack.svg")))

    def createWidget(self, parent: QWidget | None = None) -> QgsOptionsPageWidget:
        return TetratrackOptionsPage(parent)


class TetratrackOptionsPage(QgsOptionsPageWidget):
    """The page: state of the engine, choice of its interpreter, creation of the managed environment."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.state = QLabel()
        self.state.setWordWrap(True)
        self.chooser = QgsFileWidget()
        self.chooser.setDialogTitle(tr("Python interpreter of the engine"))
        self.chooser.setFilePath(QgsSettings().value(PYTHON_SETTING, "", type=str))
        self.chooser.setToolTip(tr("Empty uses the environment that the plugin creates."))
        self.create_button = QPushButton(tr("Create the engine's environment…"))
        self.create_button.clicked.connect(self.ask_and_create)
        box = QGroupBox(tr("Engine"))
        form = QFormLayout(box)
        form.addRow(tr("State"), self.state)
        form.addRow(tr("Python interpreter of the engine"), self.chooser)
        form.addRow(self.create_button)
        layout = QVBoxLayout(self)
        layout.addWidget(box)
        layout.addStretch()
        self.show_state()

    def show_state(self) -> None:
        """Say which engine is used, or what to do."""
        engine = find_engine()
        self.state.setText(missing_engine_message() if engine is None else tr("Used: {python}").format(python=engine.python))

    def apply(self) -> None:
        """Keep the chosen interpreter."""
        QgsSettings().setValue(PYTHON_SETTING, self.chooser.filePath().strip())

    def ask_and_create(self) -> None:
        """Ask, then create the managed environment in the background."""
        python = base_python()
        if python is None:
            QMessageBox.warning(
                self, "Tetratrack", tr("Python 3.11 or later was not found: install it, or choose an interpreter of the engine above.")
            )
            return
        environment = managed_environment()
        question = tr("Create a Python environment in {folder} and download about {size} of libraries into it?")
        answer = QMessageBox.question(self, "Tetratrack", question.format(folder=environment, size=ENVIRONMENT_SIZE))
        if answer == QMessageBox.StandardButton.Yes:
            self.start(CreateEnvironment(python, environment))

    def start(self, task: Any) -> None:
        """Hand the task to QGIS's task manager, which keeps it alive."""
        self.create_button.setEnabled(False)
        task.taskCompleted.connect(self.show_state)
        QgsApplication.taskManager().addTask(task)
