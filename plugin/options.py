"""Options page: which engine is used, and its managed environment, created only after asking."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

from qgis.core import Qgis, QgsApplication, QgsSettings
from qgis.gui import QgsFileWidget, QgsOptionsPageWidget, QgsOptionsWidgetFactory
from qgis.PyQt.QtCore import QProcess, QUrl
from qgis.PyQt.QtGui import QDesktopServices, QIcon
from qgis.PyQt.QtWidgets import (
    QFormLayout,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QMessageBox,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)
from qgis.utils import iface

from ..algorithms.support.engine import (
    NEEDED_MODULES,
    PYTHON_SETTING,
    engine_environment,
    find_engine,
    interpreter_of_this_process,
    missing_engine_message,
)
from ..algorithms.support.environment import PLUGIN_FOLDER, Places, environment_python, fault_message, managed_environment
from ..algorithms.support.translation import tr
from .environment_task import INSTALLED_BYTES, CreateEnvironment, Wish
from .network import added_certificates, proxy_variables

WHEELS_SETTING = "tetratrack/engine_wheels"

PAGE_NAME = "tetratrackOptions"
"""By which QGIS finds the page when a message leads to it."""
OLDEST_PYTHON = (3, 11)
PYTHON_NAMES = ("python3.13", "python3.12", "python3.11")
LATEST_PYTHON = (3, 13)
"""Later ones have no wheels of all libraries; see requirements-engine.txt."""
PROBE = (
    "import importlib.util as u, sys; "
    "print('tetratrack-probe', '%d.%d' % sys.version_info[:2], *[m for m in sys.argv[1:] if u.find_spec(m) is None])"
)
"""What an interpreter is asked: its version, and which of the modules named it lacks."""


def base_python() -> Path | None:
    """Interpreter from which the environment can be made: QGIS's own if its version is one of the lock's, otherwise one on the path."""
    if OLDEST_PYTHON <= sys.version_info[:2] <= LATEST_PYTHON:
        return interpreter_of_this_process()
    found = [shutil.which(name) for name in PYTHON_NAMES]
    return next((Path(path) for path in found if path), None)


def check_interpreter(python: Path) -> str:
    """Why an interpreter cannot run the engine; empty if it can."""
    if not python.is_file():
        return tr("{python} is no file.").format(python=python)
    process = QProcess()
    process.setProcessEnvironment(engine_environment())
    process.start(str(python), ["-I", "-c", PROBE, *NEEDED_MODULES])
    if not process.waitForStarted(5_000) or not process.waitForFinished(30_000):
        process.kill()
        process.waitForFinished(1_000)
        return tr("{python} is no Python interpreter.").format(python=python)
    answer = bytes(process.readAllStandardOutput()).decode("utf-8", "replace").split()
    if process.exitCode() != 0 or not answer or answer[0] != "tetratrack-probe":
        return tr("{python} is no Python interpreter.").format(python=python)
    version, missing = answer[1], answer[2:]
    if tuple(int(part) for part in version.split(".")) < OLDEST_PYTHON:
        return tr("{python} is Python {version}; the engine needs 3.11 or later.").format(python=python, version=version)
    if missing:
        return tr("{python} lacks the engine's libraries: {modules}.").format(python=python, modules=", ".join(missing))
    return ""


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
        self.setObjectName(PAGE_NAME)
        self.task: CreateEnvironment | None = None
        self.state = QLabel()
        self.state.setWordWrap(True)
        self.chooser = QgsFileWidget()
        self.chooser.setDialogTitle(tr("Python interpreter of the engine"))
        self.chooser.setFilePath(QgsSettings().value(PYTHON_SETTING, "", type=str))
        self.chooser.setToolTip(tr("Empty uses the environment that the plugin creates; a folder of an environment will do."))
        self.chooser.fileChanged.connect(self.show_state)
        self.wheels = QgsFileWidget()
        self.wheels.setDialogTitle(tr("Folder or ZIP of wheels"))
        self.wheels.setFilePath(QgsSettings().value(WHEELS_SETTING, "", type=str))
        self.wheels.setToolTip(tr("For computers without a network: what was fetched on another one. Empty fetches the libraries."))
        self.create_button = QPushButton(tr("Create the engine's environment…"))
        self.create_button.clicked.connect(self.ask_and_create)
        self.step = QLabel()
        self.step.setWordWrap(True)
        self.bar = QProgressBar()
        self.cancel_button = QPushButton(tr("Cancel"))
        self.cancel_button.clicked.connect(self.cancel)
        self.log_button = QPushButton(tr("Show the log"))
        self.log_button.clicked.connect(self.show_log)
        self._lay_out()
        self.show_state()
        self._follow(running_task())

    def _lay_out(self) -> None:
        box = QGroupBox(tr("Engine"))
        form = QFormLayout(box)
        form.addRow(tr("State"), self.state)
        form.addRow(tr("Python interpreter of the engine"), self.chooser)
        form.addRow(tr("Folder or ZIP of wheels"), self.wheels)
        buttons = QHBoxLayout()
        for button in (self.create_button, self.cancel_button, self.log_button):
            buttons.addWidget(button)
        form.addRow(buttons)
        form.addRow(self.bar)
        form.addRow(self.step)
        layout = QVBoxLayout(self)
        layout.addWidget(box)
        layout.addStretch()

    def show_state(self) -> None:
        """Say which engine is used, or what to do."""
        chosen = self.chosen()
        if chosen is not None:
            problem = check_interpreter(chosen)
            self.state.setText(problem or tr("Can be used: {python}").format(python=chosen))
            return
        engine = find_engine()
        if engine is None:
            self.state.setText(missing_engine_message())
        else:
            used = tr("Used: {python}").format(python=engine.python)
            self.state.setText(fault_message(engine.fault) if engine.fault else used)

    def chosen(self) -> Path | None:
        """The interpreter in the field, where it names a folder the one in that environment; None for an empty field."""
        text = self.chooser.filePath().strip()
        if not text:
            return None
        path = Path(text)
        return environment_python(path) if path.is_dir() else path

    def isValid(self) -> bool:
        """Whether the choice can be kept: QGIS asks before it closes its options."""
        chosen = self.chosen()
        return chosen is None or not check_interpreter(chosen)

    def apply(self) -> None:
        """Keep the chosen interpreter; one that cannot run the engine is not kept, and the reason said."""
        QgsSettings().setValue(WHEELS_SETTING, self.wheels.filePath().strip())
        chosen = self.chosen()
        problem = "" if chosen is None else check_interpreter(chosen)
        if problem:
            self.state.setText(problem)
            if iface is not None:
                iface.messageBar().pushMessage("Tetratrack", problem, Qgis.MessageLevel.Warning, 0)
            return
        QgsSettings().setValue(PYTHON_SETTING, "" if chosen is None else str(chosen))

    def ask_and_create(self) -> None:
        """Ask, then create the managed environment in the background."""
        text = self.wheels.filePath().strip()
        self._follow(ask_and_create(self, Path(text) if text else None))

    def cancel(self) -> None:
        """End what is being created; nothing of it is left."""
        if self.task is not None:
            self.task.cancel()

    def show_log(self) -> None:
        """Open what the programs said while the environment was created."""
        QDesktopServices.openUrl(QUrl.fromLocalFile(str(Places(managed_environment()).log)))

    def _follow(self, task: CreateEnvironment | None) -> None:
        """Show how far a task is; without one, that nothing is going on."""
        self.task = task
        for widget in (self.bar, self.step, self.cancel_button):
            widget.setVisible(task is not None)
        self.create_button.setEnabled(task is None)
        self.log_button.setVisible(Places(managed_environment()).log.is_file())
        if task is not None:
            task.step.connect(self.step.setText)
            task.progressChanged.connect(lambda percent: self.bar.setValue(round(percent)))
            task.taskCompleted.connect(self._ended)
            task.taskTerminated.connect(self._ended)

    def _ended(self) -> None:
        problem = "" if self.task is None else self.task.problem
        self._follow(None)
        self.show_state()
        if problem:
            self.step.setText(problem)
            self.step.setVisible(True)


def running_task() -> CreateEnvironment | None:
    """What is being created at this moment in this QGIS."""
    return next((task for task in QgsApplication.taskManager().activeTasks() if isinstance(task, CreateEnvironment)), None)


def ask_and_create(parent: QWidget | None, wheels: Path | None) -> CreateEnvironment | None:
    """Ask, then create the managed environment in the background; None if the user does not want it or it cannot be."""
    python = base_python()
    if python is None:
        problem = tr("Python 3.11 to 3.13 was not found: install it, or choose an interpreter of the engine above.")
        QMessageBox.warning(parent, "Tetratrack", problem)
        return None
    environment = managed_environment()
    if wheels is None:
        question = tr("Create a Python environment in {folder} and download libraries into it? It takes about {size} of disk.")
    else:
        question = tr("Create a Python environment in {folder} from the wheels in {wheels}? It takes about {size} of disk.")
    text = question.format(folder=environment, wheels=wheels, size=f"{INSTALLED_BYTES / 1e9:.1f} GB")
    if QMessageBox.question(parent, "Tetratrack", text) != QMessageBox.StandardButton.Yes:
        return None
    wish = Wish(python=python, environment=environment, wheels=wheels, variables=pip_variables(), certificates=added_certificates())
    task = CreateEnvironment(wish)
    task.taskCompleted.connect(say_ready)
    task.taskTerminated.connect(lambda: say_problem(task))
    QgsApplication.taskManager().addTask(task)
    return task


def pip_variables() -> dict[str, str]:
    """What pip is given of QGIS's settings and of the variables that it reads."""
    kept = {name: os.environ[name] for name in ("PIP_CERT", "REQUESTS_CA_BUNDLE") if name in os.environ}
    return kept | proxy_variables()


def say_ready() -> None:
    """Tell that the engine can be used."""
    if iface is not None:
        iface.messageBar().pushSuccess("Tetratrack", tr("The engine is ready."))


def say_problem(task: CreateEnvironment) -> None:
    """Tell in one message why there is no new engine, with the way to try again; a user who ended it knows."""
    if iface is None or task.isCanceled():
        return
    message = iface.messageBar().createMessage("Tetratrack", task.problem)
    button = QPushButton(tr("Try again…"), message)
    button.clicked.connect(lambda checked=False: ask_and_create(iface.mainWindow(), task.wish.wheels))
    message.layout().addWidget(button)
    iface.messageBar().pushWidget(message, Qgis.MessageLevel.Critical)
