"""The dock never keeps the window from drawing itself for more than half a second: files that are damaged, endless, or held by others."""

from __future__ import annotations

import os
import shutil
import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path

import pytest
from qgis.core import QgsCoordinateReferenceSystem, QgsProject
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import Qt, QTimer
from qgis.PyQt.QtWidgets import QApplication, QMainWindow
from synthetic_result import SRS, write_points, write_result
from tetratrack.core.review.point_index import index_folder
from tetratrack.plugin.review_dock import ReviewDock

pytestmark = pytest.mark.qgis

LONGEST = 0.5
"""Seconds between two turns of the window's loop."""
HELD_SECONDS = 4.0
HARD = Path(os.environ.get("TETRATRACK_SHARED", Path(__file__).resolve().parents[4] / "shared")) / "faults_hard"


class Pulse:
    """Turns of the window's loop: how many, and the most seconds that this thread computed between two of them.

    Seconds that pass would count the turns of other processes on a busy machine.
    """

    def __init__(self) -> None:
        self._timer = QTimer()
        self._timer.timeout.connect(self._beat)
        self._last: float | None = None
        self.computing = 0.0
        self.turns = 0
        self._timer.start(0)

    def _beat(self) -> None:
        now = time.thread_time()
        if self._last is not None:
            self.computing = max(self.computing, now - self._last)
        self._last = now
        self.turns += 1

    def stop(self) -> None:
        self._timer.stop()


def turns(seconds: float) -> None:
    """Let the window's loop turn."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QApplication.processEvents()
        time.sleep(0.005)


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("sound") / "result.gpkg"
    write_points(path, write_result(path, 40), per_unit=300)
    return path


@pytest.fixture
def result(sound: Path, tmp_path: Path) -> Path:
    copy = Path(shutil.copy(sound, tmp_path / "result.gpkg"))
    shutil.copytree(index_folder(sound), index_folder(copy))
    return copy


@pytest.fixture
def dock(qgis_app: object) -> Iterator[ReviewDock]:
    window = QMainWindow()
    canvas = QgsMapCanvas(window)
    canvas.setDestinationCrs(QgsCoordinateReferenceSystem(f"EPSG:{SRS}"))
    window.setCentralWidget(canvas)
    dock = ReviewDock(canvas, QgsProject.instance(), window)
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
    window.resize(1366, 768)
    window.show()
    dock.decisions.reviewer.setText("Anna")
    yield dock
    dock.close()
    window.close()
    window.deleteLater()
    QApplication.processEvents()


def look_through(dock: ReviewDock, path: Path) -> Pulse:
    """Open a file, look at units on every page, and decide."""
    pulse = Pulse()
    turns(0.05)
    if dock.open(path):
        for place in range(min(3, len(dock.store.order))):
            dock.store.select([dock.store.shown(place).unit_id])
            turns(0.05)
        for page in range(dock.tabs.count()):
            dock.tabs.setCurrentIndex(page)
            turns(0.05)
        dock.run_command("accepted")
    else:
        assert dock.status.text()
    turns(0.1)
    pulse.stop()
    return pulse


def _execute(*statements: str) -> Callable[[Path], None]:
    def change(path: Path) -> None:
        with closing(sqlite3.connect(path)) as connection, connection:
            for statement in statements:
                connection.execute(statement)

    return change


ENDLESS = "WITH RECURSIVE r(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM r)"


VIEW = f"CREATE VIEW units AS {ENDLESS} SELECT u2.* FROM u2, r"  # noqa: S608 - constants
TRIGGER = f"CREATE TRIGGER t AFTER INSERT ON review_log BEGIN DELETE FROM reviews WHERE fid IN ({ENDLESS} SELECT -x FROM r); END"  # noqa: S608

CHANGES: dict[str, Callable[[Path], None]] = {
    "sound": lambda path: None,
    "view": _execute("ALTER TABLE units RENAME TO u2", VIEW),
    "text in geometry": _execute("UPDATE feature_points SET geom = 'x'"),
    "text in numbers": _execute("UPDATE feature_points SET sd_h = '[]' WHERE epoch = (SELECT max(label) FROM epochs)"),
    "huge numbers": _execute("UPDATE displacements SET d_3d = 1e300"),
    "no poses": _execute("UPDATE units SET qw = 0, qx = 0, qy = 0, qz = 0"),
    "settings": _execute('UPDATE epochs SET settings = \'{"unit_types": [{"name": 1}]}\''),
    "a gigabyte": _execute("ALTER TABLE units ADD COLUMN big GENERATED ALWAYS AS (zeroblob(1000000000)) VIRTUAL"),
    "truncated": lambda path: os.truncate(path, path.stat().st_size // 2),
    "empty": lambda path: path.write_bytes(b""),
    "index": lambda path: (index_folder(path) / "index.json").write_text('{"epochs": [' + "[" * 5000),
}


@pytest.mark.parametrize("name", CHANGES)
def test_changed_files(dock: ReviewDock, result: Path, name: str) -> None:
    CHANGES[name](result)
    assert look_through(dock, result).computing < LONGEST


SHARED = sorted([*HARD.glob("02_*/*.gpkg"), *HARD.glob("17_*/inputs/*.gpkg"), *HARD.glob("data/*.gpkg")])


@pytest.mark.shared_data
@pytest.mark.parametrize("path", SHARED, ids=lambda path: path.stem)
def test_files_of_the_shared_cases(dock: ReviewDock, tmp_path: Path, path: Path) -> None:
    copy = tmp_path / path.name
    for source in (path, path.with_name(f"{path.name}-journal")):
        if source.exists():
            shutil.copyfile(source, tmp_path / source.name)
    assert look_through(dock, copy).computing < LONGEST


HOLDER = """
import sqlite3, sys, time
c = sqlite3.connect(sys.argv[1], isolation_level=None)
c.execute("BEGIN " + sys.argv[2])
print("held", flush=True)
time.sleep(float(sys.argv[3]))
c.execute("ROLLBACK")
"""


def _held(path: Path, how: str, seconds: float) -> subprocess.Popen[str]:
    process = subprocess.Popen([sys.executable, "-c", HOLDER, str(path), how, str(seconds)], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "held\n"
    return process


def test_a_file_that_another_program_holds(dock: ReviewDock, result: Path) -> None:
    holder = _held(result, "EXCLUSIVE", HELD_SECONDS)
    pulse = Pulse()
    assert dock.open(result), "waited for, and opened"
    pulse.stop()
    holder.communicate()
    assert pulse.turns > HELD_SECONDS / LONGEST
    assert pulse.computing < LONGEST


def test_a_decision_waits_for_another_writer(dock: ReviewDock, result: Path) -> None:
    assert dock.open(result)
    dock.store.select([dock.store.shown(0).unit_id])
    holder = _held(result, "IMMEDIATE", HELD_SECONDS)
    pulse = Pulse()
    turns(0.05)
    dock.run_command("accepted")
    pulse.stop()
    holder.communicate()
    assert dock.store.review(dock.store.current).decision == "accepted"
    assert pulse.turns > HELD_SECONDS / LONGEST


def test_a_trigger_that_never_ends(dock: ReviewDock, result: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tetratrack.core.review.decisions.READING_SECONDS", 2.0)
    assert dock.open(result)
    dock.store.select([dock.store.shown(0).unit_id])
    _execute(TRIGGER)(result)
    pulse = Pulse()
    turns(0.05)
    dock.run_command("accepted")
    pulse.stop()
    assert "takes longer than 2 s to store anything" in dock.status.text()
    assert pulse.computing < LONGEST
