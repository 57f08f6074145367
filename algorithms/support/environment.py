"""The engine's environment that the plugin makes: where it lies, for which libraries it was made, and what is wrong with it.

Looks at files only and starts nothing. An environment is complete if it holds its stamp, which is written last; the stamp says for which
version of the plugin and which locked libraries it was made.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import time
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from qgis.core import QgsApplication

from .translation import tr

PLUGIN_FOLDER = Path(__file__).resolve().parents[2]
LOCK = PLUGIN_FOLDER / "requirements-engine.txt"
"""Exact versions and checksums of the engine's libraries."""
STAMP = "tetratrack.json"
SIGN_OF_LIFE = "alive"
SECONDS_OF_LIFE = 60.0
"""After which an environment that nobody goes on making is a leftover; its maker touches the sign of life every second."""
OUTDATED, PYTHON_GONE = "outdated", "python gone"


def version_of(plugin_folder: Path) -> str:
    """Version stated by the files of a plugin."""
    found = re.search(r"^version=(.+)$", (plugin_folder / "metadata.txt").read_text(encoding="utf-8"), re.MULTILINE)
    return found[1].strip() if found else ""


PLUGIN_VERSION = version_of(PLUGIN_FOLDER)
"""Of the plugin as QGIS has loaded it: its files may have been exchanged since."""


@dataclass(frozen=True)
class Places:
    """Folders and files around an environment, all beside each other so that a rename suffices.

    Attributes
    ----------
    environment
        The one in use.
    making
        What is being made, with all temporary files; a leftover of a killed QGIS if nobody is alive in it.
    before
        The one in use until now, while the new one takes its place.
    log
        All that was said while the last one was made.
    """

    environment: Path

    @property
    def making(self) -> Path:
        return self.environment.with_name(f"{self.environment.name}.making")

    @property
    def before(self) -> Path:
        return self.environment.with_name(f"{self.environment.name}.before")

    @property
    def log(self) -> Path:
        return self.environment.with_name(f"{self.environment.name}.log")


def managed_environment() -> Path:
    """Folder of the environment that the plugin creates after asking, in the user's profile."""
    return Path(QgsApplication.qgisSettingsDirPath()) / "tetratrack" / "engine"


def environment_python(environment: Path) -> Path:
    """Interpreter inside a virtual environment."""
    return environment / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def lock_fingerprint(lock: Path) -> str:
    """Checksum of what a lock pins, whatever its comments and ends of lines."""
    return _fingerprint(lock, lock.stat().st_mtime_ns)


@lru_cache(maxsize=4)
def _fingerprint(lock: Path, changed: int) -> str:
    lines = [line.strip() for line in lock.read_text(encoding="utf-8").splitlines()]
    return hashlib.sha256("\n".join(line for line in lines if line and not line.startswith("#")).encode()).hexdigest()


def write_stamp(environment: Path, lock: Path) -> None:
    """State in a finished environment for what it was made."""
    stamp = {"version": PLUGIN_VERSION, "lock": lock_fingerprint(lock)}
    (environment / STAMP).write_text(json.dumps(stamp), encoding="utf-8")


def fault_of(environment: Path, lock: Path | None = None) -> str:
    """What keeps a managed environment from being used: :data:`OUTDATED`, :data:`PYTHON_GONE`, or nothing (empty)."""
    if not environment_python(environment).is_file() or not _base_is_there(environment):
        return PYTHON_GONE
    try:
        stamp = json.loads((environment / STAMP).read_text(encoding="utf-8"))
        made_for = stamp["lock"]
    except (OSError, ValueError, KeyError, TypeError):
        # made by the first release, which wrote no stamp
        return OUTDATED
    return "" if made_for == lock_fingerprint(lock or LOCK) else OUTDATED


def _base_is_there(environment: Path) -> bool:
    """Whether the Python that an environment was made from still is where it was: on Windows the file inside only leads to it."""
    try:
        text = (environment / "pyvenv.cfg").read_text(encoding="utf-8")
    except (OSError, ValueError):
        return True
    home = re.search(r"^home\s*=\s*(.+)$", text, re.MULTILINE)
    return home is None or Path(home[1].strip()).is_dir()


def fault_message(fault: str) -> str:
    """One sentence on a fault and what to do."""
    if fault == PYTHON_GONE:
        return tr("The Python that the tetratrack engine was made with is gone: let its environment be made again in Settings > Options.")
    return tr("The tetratrack engine was made for another version of the plugin: let it be brought up to date in Settings > Options.")


def in_making(places: Places) -> bool:
    """Whether a QGIS is making an environment there at this moment."""
    try:
        return time.time() - (places.making / SIGN_OF_LIFE).stat().st_mtime < SECONDS_OF_LIFE
    except OSError:
        return False


def bring_back(places: Places) -> None:
    """Give the environment its place again that a killed QGIS was about to replace."""
    if places.before.is_dir() and not places.environment.exists() and not in_making(places):
        places.before.rename(places.environment)


def clear_leftovers(places: Places) -> None:
    """Remove what a killed QGIS left while it made an environment; the one in use stays or comes back."""
    if not in_making(places):
        bring_back(places)
        remove_folder(places.making)
        remove_folder(places.before)


def remove_folder(folder: Path, tries: int = 10) -> bool:
    """Remove a folder with all in it; a process that is ending may still write there, so it is tried a few times."""
    for attempt in range(tries):
        shutil.rmtree(folder, ignore_errors=True)
        if not folder.exists():
            return True
        time.sleep(0.05 * (attempt + 1))
    return False
