"""Creates the engine's environment in the background: from the registry, or without a network from a folder or ZIP of wheels."""

from __future__ import annotations

import re
import shutil
import sys
import zipfile
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from qgis.core import QgsTask
from qgis.PyQt.QtCore import QProcess, pyqtSignal

from ..algorithms.support.engine import BOOTSTRAP, NEEDED_MODULES, engine_environment
from ..algorithms.support.environment import (
    LOCK,
    SIGN_OF_LIFE,
    Places,
    clear_leftovers,
    environment_python,
    in_making,
    remove_folder,
    write_stamp,
)
from ..algorithms.support.translation import tr
from .pip_words import what_failed

POLL_MILLISECONDS = 200
PIP_OPTIONS = ("--disable-pip-version-check", "--no-input", "--progress-bar", "off", "--retries", "2", "--timeout", "20")
LOCKED = ("--require-hashes", "--no-deps", "--only-binary", ":all:", "--no-compile")
"""Nothing but files whose checksums stand in the lock, and none that needs a compiler; Python compiles what is used at its first import."""
INSTALLED_BYTES = 2_300_000_000
"""On disk, as measured on Linux; see docs/install.md."""
DOWNLOADED_BYTES = 720_000_000
WARM_UP = ("-I", "-X", "utf8", str(BOOTSTRAP), "warm-up", "--quiet")
SITE_PACKAGES = ("lib/python*/site-packages", "Lib/site-packages")
"""Where an environment keeps its libraries, on Windows last."""


@dataclass(frozen=True, kw_only=True)
class Wish:
    """What is to be made.

    Attributes
    ----------
    python
        Interpreter that the environment is made from.
    environment
        Folder that it is to have.
    wheels
        Folder or ZIP of wheels to take instead of the registry's; None for the registry.
    lock
        Exact versions and checksums of what is installed.
    modules
        What must be importable in the end.
    first_run
        Arguments of the new Python that let it compile what runs need; empty for nothing.
    variables, certificates
        QGIS's proxy for pip, and certificates of authorities (PEM) besides those that pip knows.
    installed_bytes, downloaded_bytes
        Disk that is needed.
    """

    python: Path
    environment: Path
    wheels: Path | None = None
    lock: Path = LOCK
    modules: tuple[str, ...] = NEEDED_MODULES
    first_run: tuple[str, ...] = WARM_UP
    variables: dict[str, str] = field(default_factory=dict)
    certificates: str = ""
    installed_bytes: int = INSTALLED_BYTES
    downloaded_bytes: int = DOWNLOADED_BYTES


class _FailedError(Exception):
    """A step failed; the text is for the user."""


class _CancelledError(Exception):
    """The user ended it."""


class CreateEnvironment(QgsTask):
    """Makes an environment beside the one in use, which it replaces only once it is complete; whatever else happens leaves nothing."""

    step = pyqtSignal(str)
    """What is being done, with numbers."""

    def __init__(self, wish: Wish) -> None:
        super().__init__(tr("Creating the tetratrack engine"), QgsTask.Flag.CanCancel)
        self.wish = wish
        self.places = Places(wish.environment)
        self.problem = ""
        self._said = ""

    @property
    def log(self) -> Path:
        """File with everything that the programs said."""
        return self.places.log

    def run(self) -> bool:
        if in_making(self.places):
            self.problem = tr("Another window of QGIS is creating the engine at this moment.")
            return False
        try:
            self._prepare()
            self._make(self.places.making / "venv")
            self._exchange(self.places.making / "venv")
        except _CancelledError:
            self.problem = tr("Cancelled.")
        except _FailedError as error:
            self.problem = str(error)
        except (OSError, zipfile.BadZipFile) as error:
            self.problem = _not_created(what_failed(str(error)), self.log)
        finally:
            remove_folder(self.places.making)
        return not self.problem

    def _prepare(self) -> None:
        """Leftovers away, room on the disk, and everything to write in its place."""
        self.places.environment.parent.mkdir(parents=True, exist_ok=True)
        clear_leftovers(self.places)
        needed = self.wish.installed_bytes + (self.wish.downloaded_bytes if self._downloads() else 0)
        free = shutil.disk_usage(self.places.environment.parent).free
        if free < needed:
            raise _FailedError(
                tr("The engine needs {needed} GB on the disk of {folder}, and {free} GB are free.").format(
                    needed=f"{needed / 1e9:.1f}", folder=self.places.environment.parent, free=f"{free / 1e9:.1f}"
                )
            )
        (self.places.making / "tmp").mkdir(parents=True)
        self._show_life()
        self.log.write_bytes(b"")

    def _downloads(self) -> bool:
        """Whether files are fetched or unpacked first."""
        return self.wish.wheels is None or self.wish.wheels.is_file()

    def _make(self, venv: Path) -> None:
        wheels = self.wish.wheels
        if wheels is not None:
            self._check_wheels(wheels)
        self._tell(1, tr("Making an empty environment"))
        self._run(self.wish.python, ["-I", "-m", "venv", str(venv)])
        python = environment_python(venv)
        source: list[str] = []
        if wheels is not None:
            source = ["--no-index", "--find-links", str(self._unpacked(wheels, venv) if wheels.is_file() else wheels)]
        install = ["-I", "-m", "pip", "install", *PIP_OPTIONS, *LOCKED, *source, "-r", str(self.wish.lock)]
        self._run(python, install, self._certificates(venv), _Progress(self, venv).look)
        self._tell(95, tr("Trying the libraries"))
        self._run(python, ["-I", "-c", f"import {', '.join(self.wish.modules)}"])
        if self.wish.first_run:
            self._tell(97, tr("Compiling, so that the first run need not wait"))
            # what cannot be compiled now, for want of room or time, is compiled by the first run; the log has the reason
            with suppress(_FailedError):
                self._run(python, list(self.wish.first_run))
        write_stamp(venv, self.wish.lock)

    def _check_wheels(self, wheels: Path) -> None:
        """Whether a folder or ZIP holds all wheels by name and version.

        Raises
        ------
        _FailedError
            It holds no wheel, or lacks some.
        """
        if wheels.is_file():
            with zipfile.ZipFile(wheels) as packed:
                names = [Path(name).name for name in packed.namelist()]
        else:
            names = [path.name for path in wheels.glob("*.whl")]
        there = {_start_of(name) for name in names if name.endswith(".whl")}
        if not there:
            raise _FailedError(tr("{wheels} holds no wheels.").format(wheels=wheels))
        lacking = [name for name in _wanted(self.wish.lock) if name not in there]
        if lacking:
            some = ", ".join(sorted(lacking)[:5]) + (" …" if len(lacking) > 5 else "")
            raise _FailedError(
                tr("{wheels} lacks {count} of the wheels that this version of the plugin needs: {names}.").format(
                    wheels=wheels, count=len(lacking), names=some
                )
            )

    def _unpacked(self, wheels: Path, venv: Path) -> Path:
        """Folder with those wheels of a ZIP that an environment may take: one ZIP can serve several systems and Pythons."""
        folder = self.places.making / "wheels"
        folder.mkdir()
        version = re.search(r"^version\s*=\s*3\.(\d+)", (venv / "pyvenv.cfg").read_text(encoding="utf-8"), re.MULTILINE)
        with zipfile.ZipFile(wheels) as packed:
            for member in packed.infolist():
                name = Path(member.filename).name
                if name.endswith(".whl") and serves(name, sys.platform, int(version[1]) if version else None):
                    self._pause()
                    self._tell(4, tr("Unpacking {file}").format(file=name))
                    with packed.open(member) as content, (folder / name).open("wb") as file:
                        shutil.copyfileobj(content, file)
        return folder

    def _certificates(self, venv: Path) -> dict[str, str]:
        """Variables that make pip trust the user's authorities besides those it knows."""
        if not self.wish.certificates:
            return {}
        known = [Path(self.wish.variables[name]) for name in ("PIP_CERT", "REQUESTS_CA_BUNDLE") if name in self.wish.variables]
        known += venv.glob("[Ll]ib/**/pip/_vendor/certifi/cacert.pem")
        texts = [path.read_text(encoding="utf-8") for path in known if path.is_file()]
        bundle = self.places.making / "authorities.pem"
        bundle.write_text("\n".join([*texts, self.wish.certificates]), encoding="utf-8")
        return {"PIP_CERT": str(bundle)}

    def _exchange(self, venv: Path) -> None:
        """The new environment takes the place of the old one.

        Raises
        ------
        _FailedError
            The old one is in use (Windows does not let it go then).
        """
        places = self.places
        if places.environment.exists():
            try:
                places.environment.rename(places.before)
            except OSError as error:
                raise _FailedError(tr("The engine in use cannot be replaced now: wait until its runs have ended.")) from error
        try:
            venv.rename(places.environment)
        except OSError:
            if places.before.exists():
                places.before.rename(places.environment)
            raise
        remove_folder(places.before)

    def _run(
        self, program: Path, arguments: list[str], variables: dict[str, str] | None = None, watch: Callable[[str], None] | None = None
    ) -> None:
        """Run a program, keep what it says, and end it when the user wants.

        Raises
        ------
        _FailedError
            It ended with an error.
        _CancelledError
            The user ended it.
        """
        process = QProcess()
        environment = engine_environment()
        temporary = str(self.places.making / "tmp")
        for name, value in {**self.wish.variables, **(variables or {}), "TMPDIR": temporary, "TEMP": temporary, "TMP": temporary}.items():
            environment.insert(name, value)
        process.setProcessEnvironment(environment)
        process.setProcessChannelMode(QProcess.ProcessChannelMode.MergedChannels)
        process.start(str(program), arguments)
        if not process.waitForStarted(30_000):
            reason = tr("The engine could not be started with {python}: {reason}.").format(python=program, reason=process.errorString())
            raise _FailedError(reason)
        output = b""
        try:
            with self.log.open("ab") as log:
                while True:
                    running = process.state() != QProcess.ProcessState.NotRunning
                    if running:
                        process.waitForReadyRead(POLL_MILLISECONDS)
                    found = bytes(process.readAll())
                    log.write(found)
                    output += found
                    if not running:
                        break
                    self._pause()
                    if watch is not None:
                        watch(output.decode("utf-8", "replace"))
        finally:
            # cancelled, or the disk took no more
            if process.state() != QProcess.ProcessState.NotRunning:
                process.kill()
                process.waitForFinished(5000)
        if process.exitStatus() != QProcess.ExitStatus.NormalExit or process.exitCode() != 0:
            raise _FailedError(_not_created(what_failed(output.decode("utf-8", "replace")), self.log))

    def _pause(self) -> None:
        """Heed the user's wish to end, and show others that this lives."""
        if self.isCanceled():
            raise _CancelledError
        self._show_life()

    def _show_life(self) -> None:
        (self.places.making / SIGN_OF_LIFE).touch()

    def _tell(self, percent: float, text: str) -> None:
        self.setProgress(max(self.progress(), percent))
        if text != self._said:
            self._said = text
            self.step.emit(text)


class _Progress:
    """How far pip is: bytes that it has fetched, then libraries that it has unpacked."""

    def __init__(self, task: CreateEnvironment, venv: Path) -> None:
        self.task, self.venv = task, venv
        self.folder = task.places.making / "tmp"
        self.libraries = len(_wanted(task.wish.lock))

    def look(self, output: str) -> None:
        """Tell it from what pip has said and what lies on the disk."""
        # folders come and go while pip works: what cannot be seen now is told at the next look
        with suppress(OSError):
            self._look(output)

    def _look(self, output: str) -> None:
        if "Installing collected packages" in output:
            there = sum(1 for place in SITE_PACKAGES for _ in self.venv.glob(f"{place}/*.dist-info"))
            text = tr("Unpacking libraries: {count} of {all}").format(count=there, all=self.libraries)
            self.task._tell(65 + 30 * min(there / max(self.libraries, 1), 1.0), text)
            return
        names = re.findall(r"^(?:Collecting|Processing) (?:\S*[/\\])?([A-Za-z0-9._]+)", output, re.MULTILINE)
        if self.task.wish.wheels is not None or not names:
            self.task._tell(5 + 60 * min(len(names) / max(self.libraries, 1), 1.0), tr("Looking for the libraries"))
            return
        fetched = sum(path.stat().st_size for path in self.folder.rglob("*.whl"))
        text = tr("Fetching {name}: {done} of about {all} MB").format(
            name=names[-1], done=round(fetched / 1e6), all=round(self.task.wish.downloaded_bytes / 1e6)
        )
        self.task._tell(5 + 60 * min(fetched / self.task.wish.downloaded_bytes, 1.0), text)


def _not_created(reason: str, log: Path) -> str:
    return tr("The engine's environment could not be created: {reason} (everything that was said: {log})").format(reason=reason, log=log)


def serves(wheel: str, system: str, minor: int | None) -> bool:
    """Whether a wheel may be for a system and Python 3.minor, by its name; pip decides in the end."""
    python, abi, platform = wheel.removesuffix(".whl").rsplit("-", 3)[1:]
    words = {"win32": "win", "darwin": "macosx"}.get(system, "linux")
    if platform != "any" and words not in platform:
        return False
    return minor is None or not python.startswith("cp") or abi == "abi3" or f"cp3{minor}" in python.split(".")


def _start_of(wheel: str) -> str:
    """Name and version in a wheel's file name, as :func:`_wanted` gives them."""
    name, version = wheel.split("-")[:2]
    return f"{_normal(name)} {version}"


def _normal(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def _wanted(lock: Path) -> list[str]:
    """Names and versions of what a lock installs on this system."""
    found = []
    for line in lock.read_text(encoding="utf-8").splitlines():
        pin = re.match(r"(?P<name>[A-Za-z0-9_.-]+)==(?P<version>[^\s;]+)(?: ; sys_platform (?P<relation>==|!=) \"(?P<system>\w+)\")?", line)
        if pin and (pin["relation"] is None or (sys.platform == pin["system"]) == (pin["relation"] == "==")):
            found.append(f"{_normal(pin['name'])} {pin['version']}")
    return found
